"""What a row of the table of concepts is: one thing that an asset has, and how each format says it."""

from collections.abc import Mapping
from dataclasses import dataclass

FORMAT_TITLES: Mapping[str, str] = {"urdf": "URDF", "mjcf": "MJCF", "usd": "USD", "glb": "GLB"}
"""Title of the column of each format."""


@dataclass(frozen=True)
class Cell:
    """How one format says a concept.

    Attributes:
        text: The words of the format in backticks, with their unit where it differs from the asset's.
        losses: Features under which the writer reports what it cannot say; none if it says all.
    """

    text: str
    losses: tuple[str, ...] = ()


@dataclass(frozen=True)
class Concept:
    """One thing that an asset is or has.

    Attributes:
        name: What it is called.
        unit: Its unit in artgen; empty if it has none.
        field: Where it stands in asset.json; `[]` stands for each item of a list.
        cells: How each format says it, by the name of the format.
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
