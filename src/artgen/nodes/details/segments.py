"""Seven-segment figures: lit and dark segments."""

import math
from typing import Literal

import numpy as np

from artgen._arrays import Array
from artgen.asset.shape import Contour, Outline
from artgen.graph import kernel
from artgen.nodes import validators as inputs
from artgen.nodes.contours import circle_contour, faceted, moved_outline
from artgen.nodes.handles import Profile, Scalar

Lit = Literal["lit", "dark", "all"]
"""Lit segments or dots, dark ones, or both."""

_THICK = 0.125  # width of a segment relative to the height of a figure, as all lengths below
_WIDE = 0.56
_SPACE = 0.24  # between figures
_COLON = 0.20  # width of a colon
_GAP = 0.016  # gap between segments

FIGURES: dict[str, str] = {
    "0": "abcdef", "1": "bc", "2": "abdeg", "3": "abcdg", "4": "bcfg", "5": "acdfg", "6": "acdefg",
    "7": "abc", "8": "abcdefg", "9": "abcdfg", " ": "", "-": "g", "_": "d", "=": "dg",
    "A": "abcefg", "B": "cdefg", "C": "adef", "D": "bcdeg", "E": "adefg", "F": "aefg", "G": "acdef",
    "H": "bcefg", "I": "ef", "J": "bcde", "L": "def", "N": "ceg", "O": "cdeg", "P": "abefg",
    "Q": "abcfg", "R": "eg", "S": "acdfg", "T": "defg", "U": "bcdef", "Y": "bcdfg", "°": "abfg",
}  # fmt: skip
"""Lit segments of each figure: a is the top, then clockwise, g the center."""


def _bars() -> dict[str, Array]:
    """Return the borders of the segments of a figure, its lower left corner at the origin."""
    half, reach = _THICK / 2.0, _WIDE - _THICK
    rise = (1.0 - _THICK) / 2.0

    def bar(length: float, *, upright: bool, x: float, y: float) -> Array:
        """Return a bar with pointed ends around a line that starts at (x, y)."""
        a, b = _GAP / 2.0, length - _GAP / 2.0
        line = [(a, 0.0), (a + half, -half), (b - half, -half), (b, 0.0), (b - half, half), (a + half, half)]
        points = np.array(line)
        if upright:
            points = np.column_stack([-points[:, 1], points[:, 0]])
        return points + [x, y]

    low, middle, high = half, half + rise, half + 2.0 * rise
    left, right = half, half + reach
    return {
        "a": bar(reach, upright=False, x=left, y=high),
        "b": bar(rise, upright=True, x=right, y=middle),
        "c": bar(rise, upright=True, x=right, y=low),
        "d": bar(reach, upright=False, x=left, y=low),
        "e": bar(rise, upright=True, x=left, y=low),
        "f": bar(rise, upright=True, x=left, y=middle),
        "g": bar(reach, upright=False, x=left, y=middle),
    }


_BARS = _bars()


def _cells(string: str) -> tuple[list[tuple[str, float]], float]:
    """Return the characters with their start positions, and the width, in heights of a figure."""
    places: list[tuple[str, float]] = []
    pen = 0.0
    for shown in string:
        character = shown.upper()
        if character not in FIGURES and character not in ":.":
            raise ValueError(
                f"a seven-segment figure has no character {shown!r} (U+{ord(shown):04X}) of "
                f"{string!r}; it shows {''.join(sorted(FIGURES)).strip()}:. - use dot_matrix or text instead"
            )
        if character == ".":  # a point uses the space after its figure
            places.append((character, pen - _SPACE if places else pen))
            pen += 0.0 if places[:-1] else _SPACE
            continue
        places.append((character, pen))
        pen += (_COLON if character == ":" else _WIDE) + _SPACE
    if not places:
        raise ValueError("a seven-segment display needs at least one character, got ''")
    return places, pen - _SPACE


def seven_segment_width(string: str) -> float:
    """Return the width of seven-segment figures without slant, in heights of a figure."""
    return _cells(string)[1]


def has_dark_segments(string: str) -> bool:
    """Tell whether a string has a dark segment."""
    return any(character not in ":." and len(FIGURES[character]) < 7 for character, _ in _cells(string)[0])


def _dot(x: float, y: float) -> Contour:
    dot = circle_contour(0.55 * _THICK, 12)
    return Contour(dot.points + np.array([x, y]), dot.normals_in, dot.normals_out)


@kernel
def _seven_segment(string: str, height: float, slant: float, show: Lit) -> Outline:
    inputs.positive("height", height)
    inputs.between("slant", slant, -0.6, 0.6, "rad")
    places, width = _cells(string)
    contours: list[Contour] = []
    for character, x in places:
        if character in ":.":
            if show != "dark":
                levels = (0.3, 0.7) if character == ":" else (0.5 * _THICK,)
                across = x + (_COLON if character == ":" else _SPACE) / 2.0
                contours += [_dot(across, level) for level in levels]
            continue
        for name, bar in _BARS.items():
            if show == "all" or (name in FIGURES[character]) == (show == "lit"):
                contours.append(faceted(bar + [x, 0.0]))
    if not contours:
        what = "dark: all of them are lit" if show == "dark" else "lit"
        raise ValueError(f"no segment of {string!r} is {what}")
    matrix = np.array([[1.0, math.tan(slant)], [0.0, 1.0]]) * height
    convex = tuple(contour.points for contour in contours)
    return moved_outline(Outline(tuple(contours), convex), matrix, matrix @ np.array([-width / 2.0, -0.5]))


def seven_segment(string: str, height: Scalar, *, slant: Scalar = 0.1, show: Lit = "lit") -> Profile:
    """Make the segments of figures such as `"12:30"` or `"-18°C"`, centered on the origin.

    Lit and dark segments are separate profiles, for different materials.

    Args:
        string: Figures, `:`, `.` and the letters of seven-segment displays; known while building.
        height: Height of the figures [m].
        slant: Slant to the right [rad].
        show: Lit segments, dark segments or both.

    Examples:
        >>> details.seven_segment("12:30", 0.01)
    """
    return Profile.record(_seven_segment, string=string, height=height, slant=slant, show=show)
