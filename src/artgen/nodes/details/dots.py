"""Dot-matrix characters of 5 x 7 dots."""

from typing import Literal

import numpy as np
from numpy.typing import NDArray

from artgen.asset.shape import Contour, Outline
from artgen.graph import kernel
from artgen.nodes import validators as inputs
from artgen.nodes.contours import circle_contour, faceted
from artgen.nodes.details.segments import Lit
from artgen.nodes.handles import Profile, Scalar

_ROWS, _COLUMNS = 7, 5
_FILLED = 0.82  # share of the pitch that a dot fills

_FONT_ROWS = """
0 0E 11 13 15 19 11 0E;1 04 0C 04 04 04 04 0E;2 0E 11 01 02 04 08 1F;3 1F 02 04 02 01 11 0E
4 02 06 0A 12 1F 02 02;5 1F 10 1E 01 01 11 0E;6 06 08 10 1E 11 11 0E;7 1F 01 02 04 08 08 08
8 0E 11 11 0E 11 11 0E;9 0E 11 11 0F 01 02 0C;A 0E 11 11 1F 11 11 11;B 1E 11 11 1E 11 11 1E
C 0E 11 10 10 10 11 0E;D 1C 12 11 11 11 12 1C;E 1F 10 10 1E 10 10 1F;F 1F 10 10 1E 10 10 10
G 0E 11 10 17 11 11 0F;H 11 11 11 1F 11 11 11;I 0E 04 04 04 04 04 0E;J 07 02 02 02 02 12 0C
K 11 12 14 18 14 12 11;L 10 10 10 10 10 10 1F;M 11 1B 15 15 11 11 11;N 11 11 19 15 13 11 11
O 0E 11 11 11 11 11 0E;P 1E 11 11 1E 10 10 10;Q 0E 11 11 11 15 12 0D;R 1E 11 11 1E 14 12 11
S 0F 10 10 0E 01 01 1E;T 1F 04 04 04 04 04 04;U 11 11 11 11 11 11 0E;V 11 11 11 11 11 0A 04
W 11 11 11 15 15 15 0A;X 11 11 0A 04 0A 11 11;Y 11 11 11 0A 04 04 04;Z 1F 01 02 04 08 10 1F
- 00 00 00 1F 00 00 00;+ 00 04 04 1F 04 04 00;= 00 00 1F 00 1F 00 00;_ 00 00 00 00 00 00 1F
. 00 00 00 00 00 0C 0C;, 00 00 00 00 0C 04 08;: 00 0C 0C 00 0C 0C 00;! 04 04 04 04 00 00 04
? 0E 11 01 02 04 00 04;/ 00 01 02 04 08 10 00;% 18 19 02 04 08 13 03;° 0C 12 12 0C 00 00 00
( 02 04 08 08 08 04 02;) 08 04 02 02 02 04 08;< 02 04 08 10 08 04 02;> 08 04 02 01 02 04 08
* 00 04 15 0E 15 04 00;& 0C 12 14 08 15 12 0D;' 0C 04 08 00 00 00 00;# 0A 0A 1F 0A 1F 0A 0A
"""

FONT: dict[str, tuple[int, ...]] = {" ": (0,) * _ROWS} | {
    line[0]: tuple(int(row, 16) for row in line[1:].split())
    for line in _FONT_ROWS.strip().replace("\n", ";").split(";")
}
"""Rows of each character from the top, the leftmost dot in the highest of five bits."""


def dot_matrix_width(string: str) -> float:
    """Return the width of a line of characters, in heights of a character."""
    return ((_COLUMNS + 1) * len(string) - 1) / _ROWS


def dots_of(string: str) -> NDArray[np.bool_]:
    """Return the lit dots of a line, shape (rows, columns)."""
    columns: list[list[bool]] = []
    for character in string:
        if character not in FONT:
            upper = character.upper()
            remedy = (
                f"write {upper!r}" if upper in FONT else f"it has {''.join(sorted(FONT)).strip()}; use text"
            )
            raise ValueError(
                f"the 5x7 dot font has no character {character!r} (U+{ord(character):04X}) of {string!r}; "
                f"{remedy}"
            )
        rows = FONT[character]
        columns += [[bool(row >> bit & 1) for row in rows] for bit in range(_COLUMNS - 1, -1, -1)]
        columns.append([False] * _ROWS)
    if not columns:
        raise ValueError("a dot matrix needs at least one character, got ''")
    return np.array(columns[:-1]).T


@kernel
def _dot_matrix(string: str, height: float, dot: Literal["square", "round"], show: Lit) -> Outline:
    pitch = inputs.positive("height", height) / _ROWS
    shining = dots_of(string)
    wanted = np.ones_like(shining) if show == "all" else shining == (show == "lit")
    if not wanted.any():
        raise ValueError(f"no dot of {string!r} is {show}")
    half = 0.5 * _FILLED * pitch
    square = np.array([[-half, -half], [half, -half], [half, half], [-half, half]])
    shape = faceted(square) if dot == "square" else circle_contour(half * 1.08, 10)
    places = np.argwhere(wanted)[:, ::-1] * [1.0, -1.0]
    middle = np.array([shining.shape[1] - 1, 1 - _ROWS]) / 2.0
    contours = tuple(
        Contour(shape.points + place, shape.normals_in, shape.normals_out)
        for place in (places - middle) * pitch
    )
    return Outline(contours, tuple(contour.points for contour in contours))


def dot_matrix(
    string: str, height: Scalar, *, dot: Literal["square", "round"] = "square", show: Lit = "lit"
) -> Profile:
    """Make the dots of a line of 5 x 7 characters, centered on the origin.

    Args:
        string: Capitals, digits and common signs; known while building.
        height: Height of a character from the first to the last row of dots [m].
        dot: Shape of the dots.
        show: Lit dots, dark dots or both. A dark column separates characters.

    Examples:
        >>> details.dot_matrix("ARTGEN", 0.01, dot="round")
    """
    return Profile.record(_dot_matrix, string=string, height=height, dot=dot, show=show)
