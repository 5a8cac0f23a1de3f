"""A row of the table of concepts: a property of an asset, and its form in each file format."""

from collections.abc import Mapping
from dataclasses import dataclass

FORMAT_TITLES: Mapping[str, str] = {
    "urdf": "URDF", "mjcf": "MJCF", "usd": "USD", "glb": "GLB", "sdf": "SDFormat",
}  # fmt: skip
"""Title of the column of each format."""


@dataclass(frozen=True)
class Cell:
    """The form of a concept in one file format.

    Attributes:
        text: The terms of the format in backticks, with their unit if it differs from that of the asset.
        losses: Features that the writer reports as losses; none if it writes all.
    """

    text: str
    losses: tuple[str, ...] = ()


@dataclass(frozen=True)
class Concept:
    """A property of an asset.

    Attributes:
        name: Name of the concept.
        unit: Its unit in artgen; empty if it has none.
        field: Its place in asset.json; `[]` means each item of a list.
        cells: Its form in each format, by the name of the format.
    """

    name: str
    unit: str
    field: str
    cells: Mapping[str, Cell]


def row(name: str, unit: str, field: str, **cells: str | tuple[str, ...]) -> Concept:
    """Make a concept; a cell is its text, or its text and the losses that belong to it."""
    found = {
        key: Cell(value) if isinstance(value, str) else Cell(value[0], value[1:])
        for key, value in cells.items()
    }
    return Concept(name, unit, field, found)
