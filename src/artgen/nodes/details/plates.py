"""Rating plates: the small print on the back of an appliance."""

from __future__ import annotations

from collections.abc import Sequence

from artgen.errors import BuildError
from artgen.graph.node import authors_line
from artgen.materials import MATERIALS
from artgen.nodes.body import detail, weld
from artgen.nodes.details.lettering import lettering, lettering_width
from artgen.nodes.details.relief import FRONT, reading, relief
from artgen.nodes.handles import Body, Profile, Scalar, Solid, VectorLike
from artgen.nodes.profile import rectangle
from artgen.nodes.scalar import min_

_PLATE = 0.0003  # height of the plate above the face [m]
_FILM = 0.0001  # height of its print above the plate
_MOST_LETTERS = 90
_LEADING = 1.75  # distance between lines, in capital heights


def _frame(width: Scalar, height: Scalar, line: Scalar) -> Profile:
    return rectangle(width, height) - rectangle(width - 2 * line, height - 2 * line)


def rating_plate(
    width: Scalar,
    height: Scalar,
    lines: Sequence[str],
    *,
    double_insulated: bool = True,
    at: VectorLike = (0.0, 0.0, 0.0),
    facing: VectorLike = FRONT,
    up: VectorLike | None = None,
    label: str = "rating_plate",
) -> Body:
    """Make a white visual plate with lines of black small print, without marks of authorities.

    It has fewer than 4000 triangles.

    Args:
        width: Width of the plate [m].
        height: Height of the plate [m].
        lines: Lines from top to bottom, known while building; the first line is a third larger.
        double_insulated: Whether the symbol of protection class II, a double square, is in the lower right
            corner.
        at: Center of the plate on the face [m].
        facing: Outward direction of the face.
        up: Upward direction for the reader; by default Z, or Y on a face that looks up or down.
        label: Semantic label.

    Raises:
        BuildError: There are no lines, or more letters than small print may have.

    Examples:
        >>> plate = part(box(0.06, 0.004, 0.04), "plate", material("abs"))
        >>> lines = ("Model A-12", "230 V ~ 50 Hz", "1200 W")
        >>> weld(plate, details.rating_plate(0.04, 0.02, lines, at=(0, -0.002, 0)))
    """
    shown = [line for line in lines if line.strip()]
    letters = sum(not character.isspace() for line in shown for character in line)
    if not shown or letters > _MOST_LETTERS:
        raise BuildError(
            f"a rating plate has 1 to {_MOST_LETTERS} letters, got {letters}; give it more or fewer\n"
            f"  at {authors_line()}"
        )
    plain = {"texture": "", "tile": None}
    white = MATERIALS["abs"].with_(name="plate_white", base_color=(0.78, 0.78, 0.76), **plain)
    black = MATERIALS["black_abs"].with_(name="plate_ink", **plain)

    def on_face(profile: Profile, proud: float) -> Solid:
        return relief(profile, at, facing=facing, up=up, proud=proud, sunk=0.0002)

    rows = 1.33 * _LEADING + _LEADING * (len(shown) - 1) + 0.6  # size of the block, in capital heights
    square = 2.2 if double_insulated else 0.0
    wide = max(1.33 * lettering_width(shown[0]), *(lettering_width(line) for line in shown[1:]), 1.0)
    last = lettering_width(shown[-1]) + square + 1.0 if len(shown) > 1 else 0.0
    size = min_(0.9 * height / rows, 0.9 * width / max(wide, last))
    left = -0.45 * width
    top = 0.5 * (rows - 1.33 * _LEADING) * size
    # films next to each other need no union
    films = [lettering(shown[:1], 1.33 * size, align="left", fineness="coarse").at(left, top)]
    if len(shown) > 1:
        block = lettering(shown[1:], size, align="left", leading=_LEADING, fineness="coarse")
        films.append(block.at(left, -0.5 * 1.33 * _LEADING * size))
    films.append(_frame(0.97 * width, height - 0.03 * width, 0.004 * width))
    if double_insulated:
        middle = (0.45 * width - size, -0.45 * height + 1.15 * size)
        films += [_frame(side * size, side * size, 0.22 * size).at(*middle) for side in (2.0, 1.1)]
    plate = on_face(rectangle(width, height, radius=0.03 * min_(width, height)), _PLATE)
    turns = {"reads": reading(facing, up), "about": at}
    prints = [detail(on_face(film, _PLATE + _FILM), label, black, **turns) for film in films]
    return weld(detail(plate, label, white), *prints)
