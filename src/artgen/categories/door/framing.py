"""Framed leaves as joiners make them: stiles that run through, rails between them, and what they hold.

Each board is a part of its own, so that each has its own grain.
"""

from collections.abc import Sequence
from typing import NamedTuple

from artgen import Body, Float, Scalar, Solid, Y, extrude, part, weld
from artgen.categories.door.entrance import fitted
from artgen.categories.shared.furniture.door_slab import EASED, Blank
from artgen.categories.shared.furniture.infill import Fill, Opening

_TOP_RAIL = 0.115  # [m]
_BOTTOM_RAIL = 0.200  # the kick rail is the widest [m]
_LOCK_RAIL = 0.120  # between rows [m]
_MULLION = 0.085  # between columns [m]


class Row(NamedTuple):
    """A row of openings between two rails."""

    share: float  # its part of the height that the rails leave
    columns: int  # openings side by side
    fill: Fill  # what fills them


def framed(blank: Blank, stile: Float, rows: Sequence[Row]) -> Body:
    """Make stiles and rails, fill what is between them, and fit what an entrance has."""
    upright = blank.board(stile, blank.upright)
    beside = (blank.width - stile) / 2.0
    lock_stile = part(
        blank.carved(upright.at(beside, 0.0, blank.waist)), "door", blank.finish, push=blank.push
    )
    boards = [upright.at(-beside, 0.0, blank.waist)]
    if blank.arch is not None:
        boards.append(extrude(blank.arch.segment(), blank.thickness, axis=Y, bevel=EASED))
    inner = blank.width - 2.0 * stile
    free = blank.upright - _BOTTOM_RAIL - _TOP_RAIL - _LOCK_RAIL * (len(rows) - 1)
    level: Scalar = blank.bottom
    fillings: list[Body] = []
    looks_out: Scalar | None = None
    for index, row in enumerate(rows):
        rail = _LOCK_RAIL if index else _BOTTOM_RAIL
        boards.append(blank.board(inner, rail).at(0.0, 0.0, level + rail / 2.0))
        level = level + rail
        tall = free * row.share
        opening, mullions = _columns(inner, tall, level + tall / 2.0, row.columns, blank)
        boards += mullions
        fillings += row.fill(opening, blank.thickness)
        if index == 1 and row.columns == 2:
            looks_out = level + 0.80 * tall  # in the mullion
        level = level + tall
    top = blank.straight - _TOP_RAIL / 2.0
    boards.append(blank.board(inner, _TOP_RAIL).at(0.0, 0.0, top))
    fittings = fitted(
        blank.fittings,
        face=blank.thickness / 2.0,
        width=blank.width,
        bottom=blank.bottom,
        letters=blank.bottom + _BOTTOM_RAIL + free * rows[0].share + _LOCK_RAIL / 2.0 if rows[1:] else None,
        number=top,
        looks_out=looks_out,
    )
    rest = (part(board, "door", blank.finish) for board in boards)
    return weld(lock_stile, *rest, *fillings, *fittings)


def _columns(
    inner: Scalar, tall: Scalar, middle: Scalar, columns: int, blank: Blank
) -> tuple[Opening, list[Solid]]:
    """Return the openings of a row between the stiles, and the mullions between them."""
    wide = (inner - _MULLION * (columns - 1)) / columns
    pitch = wide + _MULLION
    centers = [((at - (columns - 1) / 2.0) * pitch, 0.0, middle) for at in range(columns)]
    board = blank.board(_MULLION, tall)
    mullions = [board.at((at - columns / 2.0) * pitch, 0.0, middle) for at in range(1, columns)]
    return Opening(wide, tall, centers, columns, blank.finish), mullions
