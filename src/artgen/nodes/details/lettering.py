"""Lettering: spaced capitals, blocks of small print, word marks and invented brands."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

import numpy as np

from artgen._arrays import cached
from artgen.asset.shape import Contour, Outline
from artgen.graph import records
from artgen.nodes import text
from artgen.nodes import validators as inputs
from artgen.nodes.contours import is_disjoint, moved_outline, outline_of, section
from artgen.nodes.details.icons import drawing
from artgen.nodes.handles import Profile, Scalar

Fineness = Literal["fine", "coarse"]
"""Level of detail of letters: full curves, or the visible part of small print."""

Emblem = Literal[
    "ring", "bar", "leaf", "hexagon", "waves", "peak", "sun", "bow", "diamond", "quarters", "none"
]
"""Emblems next to a word mark."""

BRANDS: tuple[str, ...] = (
    "Ormiveld", "Zuvetta", "Corvelline", "Eskeldon", "Ambrikson", "Tessaround", "Nordhavel", "Kelmarra",
    "Ostrivane", "Halvorne", "Talvorex", "Pendrovia", "Brunvekk", "Lindhoevel", "Wexmarrow",
)  # fmt: skip
"""Invented brand names for products."""

_COARSE = 0.028  # tolerance of coarse letters, in capital heights


@cached(512)
def _letter(character: str, fineness: str) -> tuple[tuple[Contour, ...], float]:
    """Return the contours of a character and its advance, in capital heights."""
    contours, advance = text._glyph(character)
    if contours and (fineness == "coarse" or not is_disjoint([each.points for each in contours])):
        region = section(contours)
        if fineness == "coarse":
            region = region.simplify(_COARSE)
        contours = outline_of(region, f"the letter {character!r}").contours
    return contours, advance


def _lettering(
    lines: tuple[str, ...],
    height: float,
    tracking: float,
    leading: float,
    align: Literal["left", "center", "right"],
    fineness: Fineness,
) -> Outline:
    inputs.positive("height", height)
    inputs.between("tracking", tracking, -0.2, 5.0, "capital heights")
    inputs.between("leading", leading, 1.2, 10.0, "capital heights")
    rows: list[Contour] = []
    for number, string in enumerate(lines):
        letters, pen = [], 0.0
        for character in string:
            contours, advance = _letter(character, fineness)
            letters.append((contours, pen))
            pen += advance + tracking
        width = pen - tracking
        shift = {"left": 0.0, "center": -0.5 * width, "right": -width}[align]
        rise = 0.5 * leading * (len(lines) - 1) - leading * number - 0.5
        for contours, place in letters:
            offset = np.array([place + shift, rise])
            rows += [Contour(one.points + offset, one.normals_in, one.normals_out) for one in contours]
    if not rows:
        raise ValueError(f"the lines {lines!r} are empty; give at least one visible character")
    return moved_outline(Outline(tuple(rows)), np.eye(2) * height, np.zeros(2))


@records(_lettering)
def lettering(
    lines: Sequence[str],
    height: Scalar,
    *,
    tracking: Scalar = 0.0,
    leading: Scalar = 1.7,
    align: Literal["left", "center", "right"] = "center",
    fineness: Fineness = "fine",
) -> Profile:
    """Make lines of text in Roboto Medium, vertically centered on y = 0.

    Args:
        lines: The lines from top to bottom; known while building.
        height: Height of the capital letters [m].
        tracking: Additional space between letters, in capital heights.
        leading: Distance between base lines, in capital heights.
        align: Whether x = 0 is the left end, the center or the right end of every line.
        fineness: `coarse` letters have a third of the vertices, for small print.

    Examples:
        >>> details.lettering(("Turn", "and push"), 0.005, align="left")
    """


def lettering_width(string: str, tracking: float = 0.0) -> float:
    """Return the length of a line, in heights of its capital letters.

    Examples:
        >>> width = 0.01 * details.lettering_width("ON", tracking=0.5) + 0.01
        >>> rectangle(width, 0.02) - details.lettering(("ON",), 0.01, tracking=0.5)
    """
    return text.text_width(string) + tracking * (len(string) - 1)


def _emblem(name: Emblem, height: float) -> Outline:
    inputs.positive("height", height)
    if name == "none":
        raise ValueError("the emblem 'none' is empty; choose another one")
    return drawing(f"emblem-{name}", 1.9, height)


@records(_emblem)
def emblem(name: Emblem, height: Scalar) -> Profile:
    """Make the emblem of an invented brand.

    Args:
        name: Name of the emblem; known while building.
        height: Side of the square about the origin [m].

    Examples:
        >>> details.emblem("leaf", 0.02)
    """


def logo(name: str, height: Scalar, *, sign: Emblem = "none", tracking: float = 0.3) -> Profile:
    """Make a word mark in spaced capitals, centered on the origin; `BRANDS` lists invented names.

    Args:
        name: The brand; known while building.
        height: Height of the capital letters [m].
        sign: Emblem to the left of the name.
        tracking: Additional space between letters, in capital heights.

    Examples:
        >>> details.logo("Norvik", 0.01, sign="peak")
    """
    string = name.upper()
    word = lettering((string,), height, tracking=tracking)
    if sign == "none":
        return word
    width = lettering_width(string, tracking)
    size, space = 1.5, 0.6  # emblem and space next to it, in capital heights
    mark = emblem(sign, size * height).at(-0.5 * (width + space) * height)
    return word.at(0.5 * (size + space) * height) | mark
