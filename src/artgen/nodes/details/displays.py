"""Displays: a dark pane with luminous seven-segment figures, or a grey pane with black figures."""

from __future__ import annotations

import math
from typing import Literal

import numpy as np

from artgen._arrays import Array
from artgen.asset.shape import Contour, Outline
from artgen.errors import BuildError, nearest
from artgen.graph import records
from artgen.graph.node import authors_line
from artgen.materials import MATERIALS, Material
from artgen.nodes import validators as inputs
from artgen.nodes.body import detail, weld
from artgen.nodes.contours import circle_contour, faceted, moved_outline
from artgen.nodes.details.relief import FRONT, reading, relief
from artgen.nodes.handles import Body, Profile, Scalar, Solid, VectorLike
from artgen.nodes.profile import rectangle
from artgen.nodes.scalar import min_

Color = Literal["red", "amber", "green", "blue", "white", "cyan", "lcd"]
"""Appearance of the figures: luminous in a color, or black on a grey-green liquid crystal."""

_SHARE = 0.56  # height of the figures as a share of the pane's
_PANE = 0.0008  # height of the pane above the face [m]
_FILM = 0.0001  # height of the figures above the pane [m]

_GLOW: dict[str, tuple[float, float, float]] = {
    "red": (1.0, 0.04, 0.02),
    "amber": (1.0, 0.32, 0.02),
    "green": (0.10, 0.95, 0.16),
    "blue": (0.10, 0.32, 1.0),
    "white": (0.90, 0.95, 1.0),
    "cyan": (0.12, 0.85, 0.95),
}


# lengths relative to the height of a figure
_THICK = 0.125  # width of a segment
_WIDE = 0.56
_SPACE = 0.24  # between figures
_COLON = 0.20  # width of a colon
_GAP = 0.016  # gap between segments
_SLANT = 0.1  # slant of the figures to the right [rad]

FIGURES: dict[str, str] = {
    "0": "abcdef", "1": "bc", "2": "abdeg", "3": "abcdg", "4": "bcfg", "5": "acdfg", "6": "acdefg",
    "7": "abc", "8": "abcdefg", "9": "abcdfg", " ": "", "-": "g", "_": "d", "=": "dg",
    "A": "abcefg", "B": "cdefg", "C": "adef", "D": "bcdeg", "E": "adefg", "F": "aefg", "G": "acdef",
    "H": "bcefg", "I": "ef", "J": "bcde", "L": "def", "N": "ceg", "O": "cdeg", "P": "abefg",
    "Q": "abcfg", "R": "eg", "S": "acdfg", "T": "defg", "U": "bcdef", "Y": "bcdfg", "°": "abfg",
}  # fmt: skip
"""Lit segments of each figure: a is the top, then clockwise, g the center."""


_SEGMENTS = {
    "a": (False, 0, 2), "b": (True, 1, 1), "c": (True, 1, 0), "d": (False, 0, 0),
    "e": (True, 0, 0), "f": (True, 0, 1), "g": (False, 0, 1),
}  # fmt: skip
"""Whether a segment is upright, and the column and row of its start."""


def _bar(*, upright: bool, column: int, row: int) -> Array:
    """Return the border of a segment with pointed ends, the lower left corner of its figure at the origin."""
    half, reach, rise = _THICK / 2.0, _WIDE - _THICK, (1.0 - _THICK) / 2.0
    a, b = _GAP / 2.0, (rise if upright else reach) - _GAP / 2.0
    line = [(a, 0.0), (a + half, -half), (b - half, -half), (b, 0.0), (b - half, half), (a + half, half)]
    points = np.array(line)
    if upright:
        points = np.column_stack([-points[:, 1], points[:, 0]])
    return points + [half + column * reach, half + row * rise]


_BARS = {
    name: _bar(upright=upright, column=column, row=row) for name, (upright, column, row) in _SEGMENTS.items()
}


def _cells(string: str) -> tuple[list[tuple[str, float]], float]:
    """Return the characters with their start positions, and the width, in heights of a figure."""
    places: list[tuple[str, float]] = []
    pen = 0.0
    for shown in string:
        character = shown.upper()
        if character not in FIGURES and character not in ":.":
            raise ValueError(
                f"a seven-segment figure has no character {shown!r} (U+{ord(shown):04X}) of "
                f"{string!r}; it shows {''.join(sorted(FIGURES)).strip()}:. - use text instead"
            )
        if character == ".":  # a point uses the space after its figure
            places.append((character, pen - _SPACE if places else pen))
            pen += 0.0 if places[:-1] else _SPACE
            continue
        places.append((character, pen))
        pen += (_COLON if character == ":" else _WIDE) + _SPACE
    return places, pen - _SPACE


def _figures(string: str, height: float, lit: bool) -> Outline:
    places, width = _cells(string)
    contours: list[Contour] = []
    for character, x in places:
        if character not in ":.":
            bars = [bar for name, bar in _BARS.items() if (name in FIGURES[character]) == lit]
            contours += [faceted(bar + [x, 0.0]) for bar in bars]
        elif lit:
            dot = circle_contour(0.55 * _THICK, 12)
            across = x + (_COLON if character == ":" else _SPACE) / 2.0
            contours += [
                Contour(dot.points + np.array([across, level]), dot.normals_in, dot.normals_out)
                for level in ((0.3, 0.7) if character == ":" else (0.5 * _THICK,))
            ]
    matrix = np.array([[1.0, math.tan(_SLANT)], [0.0, 1.0]]) * inputs.positive("height", height)
    convex = tuple(contour.points for contour in contours)
    return moved_outline(Outline(tuple(contours), convex), matrix, matrix @ np.array([-width / 2.0, -0.5]))


@records(_figures)
def figures(string: str, height: Scalar, *, lit: bool) -> Profile:
    """Make the lit or the dark segments of figures such as `"12:30"` or `"-18°C"`, centered on the origin."""


def _has_dark_segments(string: str) -> bool:
    return any(character not in ":." and len(FIGURES[character]) < 7 for character, _ in _cells(string)[0])


def _materials(color: str) -> tuple[Material, Material, Material]:
    """Return the materials of the pane, of lit and of dark segments."""
    if color not in (*_GLOW, "lcd"):
        raise BuildError(
            f"a display cannot shine in {color!r}.{nearest(color, [*_GLOW, 'lcd'])}\n  at {authors_line()}"
        )
    if color == "lcd":
        pane = MATERIALS["abs"].with_(
            name="lcd", base_color=(0.34, 0.39, 0.31), specular_roughness=0.22, texture="", tile=None
        )
        ghost = pane.with_(name="lcd_dark", base_color=(0.295, 0.34, 0.265))
        return pane, pane.with_(name="lcd_lit", base_color=(0.02, 0.024, 0.02)), ghost
    pane = MATERIALS["black_glass"]
    faint = tuple(0.014 + 0.022 * channel for channel in _GLOW[color])
    dark = pane.with_(name=f"led_{color}_dark", base_color=faint, texture="", tile=None)
    return pane, MATERIALS["display" if color == "cyan" else f"led_{color}"], dark


def display(
    string: str,
    width: Scalar,
    height: Scalar,
    *,
    at: VectorLike = (0.0, 0.0, 0.0),
    facing: VectorLike = FRONT,
    up: VectorLike | None = None,
    color: Color = "red",
    label: str = "display",
) -> Body:
    """Make a display on a face: a pane 0.8 mm above the face with visual figures.

    Args:
        string: Displayed text, known while building; `""` is dark.
        width: Width of the pane [m].
        height: Height of the pane [m].
        at: Center of the pane on the face [m].
        facing: Outward direction of the face.
        up: Upward direction for the reader; by default Z, or Y on a face that looks up or down.
        color: Color of luminous figures on black glass, or a liquid crystal.
        label: Semantic label of pane and figures.

    Raises:
        BuildError: Segments cannot show a character.

    Examples:
        >>> plate = part(box(0.06, 0.004, 0.04), "plate", material("abs"))
        >>> weld(plate, details.display("12:30", 0.05, 0.02, at=(0, -0.002, 0), color="green"))
    """
    pane, lit, dark = _materials(color)

    def plate(profile: Profile, proud: float, bevel: float = 0.0) -> Solid:
        return relief(profile, at, facing=facing, up=up, proud=proud, sunk=0.0004, bevel=bevel)

    corner = 0.06 * min_(width, height)
    turns = {"reads": reading(facing, up), "about": at}
    bodies = [detail(plate(rectangle(width, height, radius=corner), _PANE, 0.0003), label, pane, **turns)]
    if string.strip():
        try:
            wide = _cells(string)[1] + 0.12  # slant of the figures
        except ValueError as error:
            raise BuildError(f"{error}\n  at {authors_line()}") from None
        tall = min_(_SHARE * height, 0.84 * width / wide)
        bodies.append(detail(plate(figures(string, tall, lit=True), _PANE + _FILM), label, lit, **turns))
        if _has_dark_segments(string):
            bodies.append(
                detail(plate(figures(string, tall, lit=False), _PANE + _FILM), label, dark, **turns)
            )
    return weld(*bodies)
