"""Concealed (cup) hinges: a cup in the back of a door, an arm on the side of the carcass.

Their four links carry a door along a path of which a turn about one axis is a close likeness: at 90 degrees
the door stands a few millimetres inside of the carcass's outer face, its edge a few millimetres before the
carcass. The turn that takes it there has its centre within the thickness of the door, near its edge. About
that axis the edge comes less than 1.5 mm nearer to the carcass, from which a closed door keeps 2 mm.

Hinges are drawn with the edge of the door at x = 0, the door at x > 0 and its back at y = 0, before the
carcass at y > 0.
"""

from collections.abc import Sequence

from artgen import (
    Body,
    Material,
    Scalar,
    VectorLike,
    array,
    board,
    circle,
    cylinder,
    detail,
    extrude,
    part,
    rectangle,
)
from artgen.categories.shared.finish import recess
from artgen.categories.shared.hardware.screws import screws

DOOR_GAP = 0.002
"""Between the back of a closed door and the carcass [m]."""

AXIS = (0.0045, -0.0115)
"""The axis of the turn, x and y [m]."""

_CUP = 0.0175  # radius of the standard cup [m]
_CUP_AT = 0.0225  # from the edge of the door to its middle: 5 mm of wood are left [m]
_FLANGE = 0.0014  # thickness of what lies on the door [m]


def _everywhere(levels: Sequence[Scalar]) -> list[VectorLike]:
    return [(0.0, 0.0, level) for level in levels]


def cup_hinges_on_door(levels: Sequence[Scalar], *, finish: Material) -> list[Body]:
    """Make the cups with their flanges, which only are seen."""
    at = _everywhere(levels)
    wing = rectangle(0.013, 0.062, radius=0.005).at(_CUP_AT + 0.008, 0.0)
    plate = circle(_CUP + 0.0015).at(_CUP_AT, 0.0) | wing
    way = (0.0, 1.0, 0.0)
    flange = extrude(plate - circle(_CUP - 0.0015).at(_CUP_AT, 0.0), _FLANGE, axis=(0.0, -1.0, 0.0))
    well = cylinder(_CUP - 0.0012, 0.0004, axis=way).at(_CUP_AT, 0.0001, 0.0)
    cheek = board((0.0170, 0.0330), (-0.001, 0.0085), (-0.0011, 0.0011), bevel=0.0008)
    link = array(cheek, at=[(0.0, 0.0, 0.0088), (0.0, 0.0, -0.0088)])
    heads = [(_CUP_AT + 0.008, _FLANGE / 2, level + end * 0.024) for level in levels for end in (-1, 1)]
    return [
        detail(array(flange, at=at), "hinge", finish),
        detail(array(well, at=at), "hinge", recess(finish)),
        detail(array(link, at=at), "hinge", finish),
        *screws(heads, facing="+y", radius=0.0036, finish=finish),
    ]


def cup_hinges_on_side(levels: Sequence[Scalar], *, inside: Scalar, finish: Material) -> list[Body]:
    """Make the mounting plates and arms on the inner face of a side."""
    at = _everywhere(levels)
    y = DOOR_GAP
    plate = board((inside - 0.0003, inside + 0.0035), (y + 0.024, y + 0.054), (-0.022, 0.022), bevel=0.0008)
    arm = board((inside + 0.0030, inside + 0.0130), (y + 0.0025, y + 0.072), (-0.0062, 0.0062), bevel=0.0016)
    heads = [(inside + 0.0034, y + 0.039, level + end * 0.016) for level in levels for end in (-1, 1)]
    turns = [(inside + 0.0129, y + deep, level) for level in levels for deep in (0.030, 0.058)]
    return [
        part(array(plate, at=at), "hinge", finish),
        part(array(arm, at=at), "hinge", finish),
        *screws(heads, facing="+x", radius=0.0038, finish=finish),
        *screws(turns, facing="+x", radius=0.0030, finish=finish),
    ]
