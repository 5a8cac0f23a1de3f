"""Interior parts of a refrigerator: shelves of glass or wire, bins on doors, drawers, egg trays."""

import math
from collections.abc import Sequence

import artgen as ag
from artgen import details

GLASS = 0.004
"""Thickness of a pane of toughened glass [m]."""

_TRIM_HIGH, _TRIM_DEEP = 0.016, 0.013  # height and depth of the strip in front of a shelf [m]
_LEDGE = 0.007  # height of the ledges under a pane above the walls [m]
_IN_WALL = 0.0005  # overlap of the ledges with the walls [m]
_INSIDE = 0.0001  # difference between the radii of visible and colliding rods [m]
_SHEET = 0.003  # thickness of the walls of bins and drawers [m]
_FRONT = 0.007  # thickness of the front of a drawer [m]
_LIP_DEEP, _LIP_HIGH = 0.019, 0.009  # depth and height of the lip at the front of a drawer [m]


ORIGIN: tuple[ag.VectorLike, ...] = ((0.0, 0.0, 0.0),)
"""One part at the origin."""


def glass_shelf(
    width: ag.Scalar, depth: ag.Scalar, *, trim: ag.Material, at: Sequence[ag.VectorLike] = ORIGIN
) -> ag.Body:
    """Make glass shelves between two walls, on ledges, with strips at their fronts and backs.

    The middle of the underside of a pane is the origin.
    """
    pane = ag.box(width + 2 * _IN_WALL, depth, GLASS, bevel=0.001).at(0.0, 0.0, GLASS / 2)
    strip = ag.box(width - 0.001, _TRIM_DEEP, _TRIM_HIGH, bevel=0.003)
    front = strip.at(0.0, (_TRIM_DEEP - depth) / 2 - 0.002, GLASS + 0.0015 - _TRIM_HIGH / 2)
    back = strip.at(0.0, (depth - _TRIM_DEEP) / 2, GLASS + 0.0015 - _TRIM_HIGH / 2)
    ledge = ag.box(_LEDGE + _IN_WALL, depth - 0.004, 0.008, bevel=0.0015)
    ledges = [ledge.at(way * (width - _LEDGE + _IN_WALL) / 2, 0.0, -0.0039) for way in (-1, 1)]
    return ag.weld(
        ag.part(ag.array(pane, at=at), "shelf", ag.material("glass")),
        ag.part(ag.array(front, at=at), "shelf", trim),
        ag.detail([ag.array(each, at=at) for each in (*ledges, back)], "shelf", trim),
    )


def wire_shelf(
    width: ag.Scalar, depth: ag.Scalar, *, finish: ag.Material, at: Sequence[ag.VectorLike] = ORIGIN
) -> ag.Body:
    """Make wire shelves between two walls, with the middle of the frame on z = 0.

    The front, the back and three rods across collide; the wires between them are visual only.
    """
    wire, rod = 0.0016, 0.003
    rack = details.wire_rack(
        width + 2 * _IN_WALL, depth, pitch=0.026, wire=wire, frame=rod, corner=0.012, supports=0
    )
    front = ag.capsule(rod - _INSIDE, width + 2 * _IN_WALL, axis=ag.X)
    deep = ag.capsule(rod - _INSIDE, depth - 2 * rod, axis=ag.Y)
    rods = ag.array(deep, at=[(way * 0.25 * width, 0.0, 0.0) for way in (-1, 0, 1)])
    ends = ag.array(front, at=[(0.0, way * (depth / 2 - rod), 0.0) for way in (-1, 1)])
    solid = ag.part([ag.array(ends, at=at), ag.array(rods, at=at)], "shelf", finish)
    return ag.weld(solid, ag.detail(ag.array(rack, at=at), "shelf", finish))


def open_box(
    width: ag.Scalar,
    depth: ag.Scalar,
    height: ag.Scalar,
    *,
    wall: ag.Scalar = _SHEET,
    front: ag.Scalar = _SHEET,
    floor: ag.Scalar | None = None,
) -> list[ag.Solid]:
    """Make floor, back, sides and front of a box without a lid; its front is y = 0 and its floor z = 0."""
    ease, less = 0.0012, 0.0006  # boards end inside the boards that they meet
    sole = wall if floor is None else floor
    deep = depth - (front + wall) / 2
    side = ag.box(wall, deep, height - less, bevel=ease)
    return [
        ag.box(width, front, height, bevel=ease).at(0.0, front / 2, height / 2),
        ag.box(width - less, deep, sole, bevel=ease).at(0.0, (depth + front / 2) / 2, sole / 2 + less / 2),
        ag.box(width - wall, wall, height - 0.004, bevel=ease).at(0.0, depth - wall / 2, height / 2),
        *(
            side.at(way * (width - wall) / 2, (depth + front / 2) / 2 - wall / 4, height / 2)
            for way in (-1, 1)
        ),
    ]


def door_bin(
    width: ag.Scalar,
    depth: ag.Scalar,
    height: ag.Scalar,
    *,
    finish: ag.Material,
    trim: ag.Material | None = None,
    at: Sequence[ag.VectorLike] = ORIGIN,
) -> ag.Body:
    """Make bins for the inside of a door: back of a bin at y = 0, front to +y, floor at z = 0."""
    boards = [board.rotate(ag.Z, math.pi).at(0.0, depth, 0.0) for board in open_box(width, depth, height)]
    body = ag.part([ag.array(board, at=at) for board in boards], "bin", finish)
    if trim is None:
        return body
    strip = ag.box(width - 0.002, 0.0048, 0.012, bevel=0.0014).at(0.0, depth - 0.0016, height - 0.0075)
    return ag.weld(body, ag.detail(ag.array(strip, at=at), "bin", trim))


def egg_tray(width: ag.Scalar, depth: ag.Scalar, *, finish: ag.Material, columns: int = 6) -> ag.Body:
    """Make a tray with two rows of holes for eggs, on z = 0 about the origin."""
    high, sheet = 0.028, 0.003
    plate = ag.box(width, depth, sheet, bevel=0.0012).at(0.0, 0.0, high - sheet / 2)
    leg = ag.box(0.004, depth - 0.004, high - 0.001, bevel=0.001)
    places = [
        ((column - (columns - 1) / 2) * width / (columns + 0.25), row * depth * 0.235, 0.0)
        for row in (-1, 1)
        for column in range(columns)
    ]
    up = (0.0, 0.0, 1.0)
    rim = details.relief(ag.ring(0.0205, 0.0165), (0.0, 0.0, high), facing=up, proud=0.0022, bevel=0.001)
    cup = details.relief(ag.circle(0.0166), (0.0, 0.0, high), facing=up, proud=0.0002)
    shade = finish.with_(name=f"{finish.name}_cup", base_color=tuple(0.45 * c for c in finish.base_color))
    legs = [leg.at(way * (width / 2 - 0.006), 0.0, (high - 0.001) / 2) for way in (-1, 1)]
    return ag.weld(
        ag.part([plate, *legs], "egg_tray", finish),
        ag.detail(ag.array(rim, at=places), "egg_tray", finish),
        ag.detail(ag.array(cup, at=places), "egg_tray", shade),
    )


def drawer_box(
    width: ag.Scalar,
    depth: ag.Scalar,
    height: ag.Scalar,
    *,
    label: str,
    finish: ag.Material,
    front: ag.Material,
    lip: ag.Material,
    lip_at: ag.Scalar,
    name: str | None = None,
) -> ag.Body:
    """Make a drawer with a lip in front as its grip: the front is y = 0, the floor z = 0."""
    face, *walls = open_box(width, depth, height, front=_FRONT)
    long = width - 0.004
    ledge = ag.box(long, _LIP_DEEP + _IN_WALL, _LIP_HIGH, bevel=0.003)
    ledge = ledge.at(0.0, (_IN_WALL - _LIP_DEEP) / 2, lip_at)
    # finger pads end 2 mm before the front
    hold = ag.frame((0.0, -0.011, lip_at), approach=(0.0, 1.0, 0.0), closing=(0.0, 0.0, 1.0))
    band = ag.box(width + 0.001, 0.0022, 0.014, bevel=0.0007).at(0.0, 0.0, height - 0.0075)
    return ag.weld(
        ag.part(ledge, label, lip, name=name, grasp=hold),
        ag.part(face, label, front),
        ag.part(walls, label, finish),
        ag.detail(band, label, lip),
    )


LIP_REACH = _LIP_DEEP
"""Reach of the lip of a drawer in front of it [m]."""
