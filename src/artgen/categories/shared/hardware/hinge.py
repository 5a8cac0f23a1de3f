"""Butt hinges: alternating knuckles on one pin, tabs in the gap, plates on the leaf and on the jamb.

The origin is on the pin's axis (along z) at half the height of the hinge. The leaf is at x > 0, the jamb at x
< 0, each half a gap away; the front faces of both are at y = `offset`, behind the pin. The leaf swings
towards -y, about -z.
"""

import math
from collections.abc import Sequence

import artgen as ag
from artgen.categories.shared.hardware.fixings import screws

KNUCKLE_CLEARANCE = 0.001
"""Distance from the knuckles to the face of the leaf [m]."""

_AXIAL_GAP = 0.0004  # gap between knuckles [m]
_PLATE = 0.0026  # thickness of plates: both in the gap and in the wood [m]
_FACE = 0.0008  # thickness of the layer without colliders, with the holes of the screws [m]
_SCREW = 0.0034  # radius of the heads of the screws [m]
_CENTER = 0.00025  # distance from plates to the middle of the gap [m]


def hinge_offset(radius: ag.Scalar) -> ag.Scalar:
    """Return the distance from the pin's axis to the face of the leaf [m]."""
    return radius + KNUCKLE_CLEARANCE


def _half(
    height: ag.Scalar,
    radius: ag.Scalar,
    depth: ag.Scalar,
    count: int,
    side: int,
    finish: ag.Material,
    *,
    sheets: bool,
) -> list[ag.Body]:
    """Make the knuckles, tabs, plates and screws of one half; `side` is 1 for the leaf, -1 for the frame."""
    sheet, inner = _PLATE - _CENTER, side * _CENTER
    pitch = height / count
    tall = pitch - _AXIAL_GAP
    knuckle = ag.cylinder(
        radius, tall, axis=ag.Z
    )  # sharp rims: with its tab, one hull of less than 64 corners
    tab = ag.box(sheet, radius + 0.0006, tall).align((inner, 0.0, 0.0), x=-side, y=-1.0)
    middles = [pitch * (index + 0.5) - height / 2 for index in range(0 if side < 0 else 1, count, 2)]
    # the plate runs past the other half's knuckles, 0.5 mm behind them; its face has holes for screws
    deep = depth + KNUCKLE_CLEARANCE - 0.0005
    plate = ag.box(sheet - _FACE, deep, height)
    plate = plate.align((inner + side * _FACE, radius + 0.0005, 0.0), x=-side, y=-1.0)
    rows = ((-0.36, 0.65), (0.0, 0.40), (0.36, 0.65))
    screws_at = [(hinge_offset(radius) + row * depth, level * height) for level, row in rows]
    face = ag.rectangle(deep, height).at(radius + 0.0005 + deep / 2.0)
    for at in screws_at:
        face = face - ag.circle(_SCREW + 0.0003).at(*at)
    skin = ag.extrude(face, _FACE + 0.0003, axis=ag.X).at(inner + side * (_FACE + 0.0003) / 2.0, 0.0, 0.0)
    places = [(0.0, 0.0, z) for z in middles]
    if sheets:
        # a knuckle and its tab together are nearly convex
        made = [
            ag.part(ag.array(ag.bounding_collider(knuckle | tab), at=places), "hinge", finish),
            ag.part(plate, "hinge", finish),
        ]
    else:
        alone = ag.part(
            ag.array(knuckle, at=places), "hinge", finish, separate="its tab joins it to the plate"
        )
        made = [
            alone,
            ag.detail(ag.array(tab, at=places), "hinge", finish),
            ag.detail(plate, "hinge", finish),
        ]
    return [
        *made,
        ag.detail(skin, "hinge", finish),
        *screws(
            [(inner, y, z) for y, z in screws_at],
            facing="-x" if side > 0 else "+x",
            radius=_SCREW,
            finish=finish,
            sunk=0.0005,
        ),
    ]


def _stacked(bodies: Sequence[ag.Body], levels: Sequence[ag.Scalar]) -> ag.Body:
    """Put copies of a half hinge at several heights."""
    half = ag.weld(*bodies)
    return ag.weld(*(half.at(0.0, 0.0, level) for level in levels))


def hinge_leaf(
    *,
    height: ag.Scalar,
    radius: ag.Scalar,
    depth: ag.Scalar,
    finish: ag.Material,
    knuckles: int = 5,
    levels: Sequence[ag.Scalar] = (0.0,),
    sheets: bool = True,
) -> ag.Body:
    """Make the half of a butt hinge that turns with the leaf."""
    return _stacked(_half(height, radius, depth, knuckles, 1, finish, sheets=sheets), levels)


def hinge_frame(
    *,
    height: ag.Scalar,
    radius: ag.Scalar,
    depth: ag.Scalar,
    finish: ag.Material,
    knuckles: int = 5,
    levels: Sequence[ag.Scalar] = (0.0,),
    sheets: bool = True,
) -> ag.Body:
    """Make the half of a butt hinge that stays on the jamb, with the heads of its pin."""
    head = ag.dome(radius * 0.92, height=radius * 0.55).at(0.0, 0.0, height / 2 - 0.0003)
    heads = [ag.detail(each, "hinge", finish) for each in (head, head.rotate(ag.X, math.pi))]
    return _stacked([*_half(height, radius, depth, knuckles, -1, finish, sheets=sheets), *heads], levels)
