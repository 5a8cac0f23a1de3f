"""Screws in rows, feet and casters of furniture and appliances, and butt hinges.

A butt hinge has alternating knuckles on one pin, tabs in the gap, plates on the leaf and on the jamb. Its
origin is on the pin's axis (along z) at half the height of the hinge. The leaf is at x > 0, the jamb at x <
0, each half a gap away; the front faces of both are at y = `offset`, behind the pin. The leaf swings towards
-y, about -z.
"""

import math
from collections.abc import Sequence
from typing import Literal

import artgen as ag
from artgen import details, feel
from artgen.categories.shared.finish import recess
from artgen.nodes.fitting import FIT, Fitting

FootStyle = Literal["pad", "round", "levelling"]
"""A rubber pad, a rounded knob, or a disc on a leveling screw of an appliance."""

_SUNK = 0.001  # depth of feet in the part above them [m]


def feet(
    at: Sequence[tuple[ag.Scalar, ag.Scalar]],
    *,
    radius: ag.Scalar = 0.009,
    height: ag.Scalar = 0.008,
    style: FootStyle = "pad",
    finish: ag.Material = ag.MATERIALS["rubber"],
    label: str = "foot",
) -> ag.Body:
    """Make feet at positions on the floor, z = 0; weld them to the part at the height `height`."""
    tall = height + _SUNK
    if style == "pad":  # a cylinder is one collider
        one = ag.cylinder(radius, tall, bevel=0.0009).at(z=tall / 2)
    else:
        one = ag.bounding_collider(details.foot(radius, tall, style=style))
    solid = ag.array(one, at=[(x, y, 0.0) for x, y in at])
    return ag.part(solid, label, finish, separate="each foot is fixed to what stands on it")


def corner_feet(
    width: ag.Scalar,
    depth: ag.Scalar,
    *,
    inset: ag.Scalar = 0.02,
    radius: ag.Scalar = 0.009,
    height: ag.Scalar = 0.008,
) -> ag.Body:
    """Make four feet under the corners of a rectangle about the origin."""
    x, y = width / 2 - inset, depth / 2 - inset
    corners = [(-x, -y), (x, -y), (x, y), (-x, y)]
    return feet(corners, radius=radius, height=height)


Drive = Literal["slot", "phillips", "hex"]
"""Drive of a screw."""

Head = Literal["pan", "countersunk"]
"""A low dome on a face, or a disc flush with it."""

Way = Literal["+x", "-x", "+y", "-y"]
"""Direction of the normal of a face."""

_FACING = {"+x": (1, 0, 0), "-x": (-1, 0, 0), "+y": (0, 1, 0), "-y": (0, -1, 0)}
_TURN = 0.5  # rotation of the recesses [rad]
_FLOOR = {"pan": (0.54, 0.26), "countersunk": (0.60, 0.09)}  # radius and height of the dark part, in radii


def screws(
    at: Sequence[ag.VectorLike],
    *,
    facing: Way,
    radius: ag.Scalar,
    finish: ag.Material,
    drive: Drive = "phillips",
    head: Head = "countersunk",
    sunk: ag.Scalar = 0.0,
) -> list[ag.Body]:
    """Make heads of screws on a face, each with a dark recess."""
    out = _FACING[facing]
    seat = tuple(-sunk * each for each in out)
    reach, high = _FLOOR[head]
    solid = details.screw_head(radius, seat, facing=out, drive=drive, head=head, turn=_TURN)
    bottom = details.drive_recess(reach * radius, drive).rotate(_TURN)
    floor = details.relief(bottom, seat, facing=out, proud=high * radius, sunk=0.02 * radius)
    return [
        ag.detail(ag.array(solid, at=at), "screw", finish),
        ag.detail(ag.array(floor, at=at), "screw", recess(finish)),
    ]


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
    if sheets:  # a knuckle and its tab together are nearly convex
        both = ag.array(ag.bounding_collider(knuckle | tab), at=places)
        made = [ag.part([both, plate], "hinge", finish)]
    else:
        joined = "its tab joins it to the plate"
        made = [
            ag.part(ag.array(knuckle, at=places), "hinge", finish, separate=joined),
            ag.detail([ag.array(tab, at=places), plate], "hinge", finish),
        ]
    facing: Way = "-x" if side > 0 else "+x"
    heads = [(inner, y, z) for y, z in screws_at]
    made.append(ag.detail(skin, "hinge", finish))
    return made + screws(heads, facing=facing, radius=_SCREW, finish=finish, sunk=0.0005)


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


_LAP = 0.0003  # overlap of the plate of a caster with the face above it [m]


def caster(
    *,
    radius: ag.Scalar,
    width: ag.Scalar,
    finish: ag.Material,
    tread: ag.Material = ag.MATERIALS["rubber"],
    swivel: bool = True,
    name: str = "caster",
) -> Fitting:
    """Make a caster on the plane y = 0: a plate, a fork that swivels, and a wheel on its axle.

    It faces -y; links are `{name}_fork` and `{name}_wheel`, joints `{name}_swivel` and `{name}_roll`.

    Args:
        radius: Radius of the wheel [m]; the caster is 2 * radius + 0.0155 high.
        width: Width of the wheel [m].
        finish: Metal or plastic of plate and fork.
        tread: Material of the wheel.
        swivel: Whether the fork swivels; otherwise the wheel rolls along z.
        name: First part of the names of links and joints.
    """
    plate = ag.box(0.050, 0.0025, 0.050, bevel=0.0008).at(y=_LAP - 0.00125)
    race = ag.cylinder(0.015, 0.0065, axis=ag.Y, bevel=0.0010).at(y=-0.0055)
    heads = [(x, _LAP - 0.0025, z) for x in (-0.019, 0.019) for z in (-0.019, 0.019)]
    fixed = ag.weld(
        ag.part([plate, race], "caster", finish),
        *screws(heads, facing="-y", radius=0.0034, finish=finish, head="pan"),
    )
    trail = 0.6 * radius  # offset of the wheel, which makes it follow
    axle = (0.0, -(0.0155 + radius), -trail)
    crown = ag.cylinder(0.016, 0.0032, axis=ag.Y, bevel=0.0006).at(y=-0.0110)
    bridge = ag.box(width + 0.0082, 0.0026, 0.018, bevel=0.0006).at(y=-0.0110)
    cheek = ag.hull(
        ag.box(0.0025, 0.0028, 0.020).at(y=-0.0110),
        ag.cylinder(0.0065, 0.0025, axis=ag.X).at(0.0, axle[1], axle[2]),
    )
    aside = width / 2 + FIT.running + 0.00125
    cheeks = [cheek.at(side * aside) for side in (-1, 1)]
    bolt = ag.cylinder(0.0045, width + 0.0120, axis=ag.X, bevel=0.0010) - ag.box(width + 0.005, 0.02, 0.02)
    fork = ag.weld(
        ag.part([crown, bridge, *cheeks], "caster", finish, name=f"{name}_fork"),
        ag.detail(bolt.at(axle), "caster", finish),
    )
    wheel = ag.cylinder(radius, width, axis=ag.X, bevel=0.0035)
    hold = ag.grasp_on(wheel, approach=ag.Z, closing=ag.X, depth=0.4 * radius)  # clear of the floor
    rolling = ag.weld(
        ag.part(wheel, "wheel", tread, name=f"{name}_wheel", grasp=hold),
        ag.detail(ag.cylinder(0.55 * radius, width + 0.0006, axis=ag.X, bevel=0.0010), "wheel", finish),
    )
    roll = ag.Revolute(f"{name}_roll", axis=ag.X, feel=feel.CASTER)
    if not swivel:
        hub = ag.cylinder(0.013, 0.003, axis=ag.Y).at(y=-0.0090)  # joins the crown to the race
        return Fitting(ag.weld(fixed, fork, ag.detail(hub, "caster", finish)).attach(rolling, roll, at=axle))
    turn = ag.Revolute(f"{name}_swivel", axis=ag.Y, feel=feel.CASTER)
    return Fitting.moving(fork.attach(rolling, roll, at=axle), turn, fixed=fixed)
