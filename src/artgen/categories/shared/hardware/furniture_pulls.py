"""Handles of furniture: knobs, bars, cup pulls and edge pulls.

Each handle is modeled about the origin on the plane y = 0, which is the face of the front, and projects to
-y. All have the label `handle` and a grasp frame; they are rigid parts of a front.
"""

import math
from typing import Literal

import artgen as ag
from artgen.categories.shared.finish import casting
from artgen.categories.shared.hardware.bar_handles import BarStyle, bar_handle

_SUNK = 0.0006  # depth of the feet in the front [m]
_SHEET = 0.0024  # thickness of the wall of a cup [m]


@ag.generator
def knob_pull(
    *,
    finish: ag.Material,
    name: str = ag.given("handle"),
    style: Literal["mushroom", "ball", "disc", "cone", "square"] = ag.choice(
        "mushroom", "ball", "disc", "cone", "square", weights=(0.34, 0.2, 0.18, 0.16, 0.12)
    ),
    radius: ag.Float = ag.uniform(0.0135, 0.0180, "m", within=(0.010, 0.030)),
    projection: ag.Float = ag.uniform(
        0.025, 0.032, "m", doc="distance from the front to the end of the knob"
    ),
) -> ag.Body:
    """Make a knob of a drawer or a cabinet, 27-36 mm across."""
    head, widest, skin = _head(style, radius, projection)
    neck = ag.cylinder_between((0.0, _SUNK, 0.0), (0.0, widest, 0.0), 0.40 * radius)
    foot = ag.cylinder(0.62 * radius, 0.003, axis=ag.Y, bevel=0.0009).at(0.0, _SUNK - 0.0015, 0.0)
    hold = ag.frame((0.0, widest, 0.0), approach=(0.0, 1.0, 0.0), closing=(0.0, 0.0, 1.0))
    return ag.weld(
        ag.part(head, "handle", finish, name=name, grasp=hold),
        ag.part(neck, "handle", finish),
        *(ag.detail(each, "handle", finish) for each in (foot, *skin)),
    )


def _head(style: str, radius: ag.Scalar, projection: ag.Scalar) -> tuple[ag.Solid, ag.Scalar, list[ag.Solid]]:
    """Make the head of a knob, which collides as one piece."""
    end, out = -projection, (0.0, -1.0, 0.0)
    match style:
        case "ball":
            middle = end + 0.86 * radius
            core = ag.cylinder(0.93 * radius, 0.60 * radius, axis=ag.Y).at(0.0, middle, 0.0)
            return core, middle, [ag.ellipsoid(radius, 0.86 * radius, radius).at(0.0, middle, 0.0)]
        case "disc":
            return (
                ag.cylinder(radius, 0.009, axis=ag.Y, bevel=0.0022).at(0.0, end + 0.0045, 0.0),
                end + 0.0045,
                [],
            )
        case "cone":
            cup = ag.frustum(0.55 * radius, radius, 0.016, axis=out, bevel=0.0016)
            return cup.at(0.0, end + 0.008, 0.0), end + 0.0035, []
        case "square":
            return (
                ag.box(1.8 * radius, 0.011, 1.8 * radius, bevel=0.0022).at(0.0, end + 0.0055, 0.0),
                end + 0.0055,
                [],
            )
        case _:
            rim = ag.cylinder(radius, 0.007, axis=ag.Y, bevel=0.0022).at(0.0, end + 0.0085, 0.0)
            cap = ag.dome(0.94 * radius, height=0.0062, axis=out).at(0.0, end + 0.0062, 0.0)
            return rim, end + 0.0085, [cap]


@ag.generator
def bar_pull(
    *,
    finish: ag.Material,
    name: str = ag.given("handle"),
    level: bool = ag.given(True),
    room: ag.Scalar = ag.given(1.0),
    style: BarStyle = ag.choice("round", "square", "strap", "bow", weights=(0.4, 0.28, 0.12, 0.2)),
    length: ag.Float = ag.uniform(0.115, 0.230, "m", doc="overall length", within=(0.10, 0.9)),
    projection: ag.Float = ag.uniform(
        0.028, 0.036, "m", doc="distance from the front to the middle of the bar"
    ),
    girth: ag.Float = ag.uniform(0.0048, 0.0064, "m", doc="half of the thickness of the bar"),
) -> ag.Body:
    """Make a bar pull of furniture, 96-192 mm from post to post."""
    length = ag.require(length, length < room, "the bar is longer than its front: lower handle.length")
    if style == "bow":
        bow = _bow(length, projection, girth, finish, name)
        return bow.rotate(ag.Y, math.pi / 2) if level else bow
    made: ag.Body = bar_handle(
        length=length,
        finish=finish,
        style=style,
        level=level,
        name=name,
        overhang=0.16 * length,
        projection=projection,
        girth=girth,
    )
    return made


def _bow(length: ag.Scalar, out: ag.Scalar, girth: ag.Scalar, finish: ag.Material, name: str) -> ag.Body:
    """Make a vertical rod with ends bent to the face; straight rods inside it are its colliders."""
    half, bend = length / 2 - girth, 0.010
    corners = [(0.0, _SUNK, -half), (0.0, -out, -half), (0.0, -out, half), (0.0, _SUNK, half)]
    skin = ag.sweep(ag.circle(girth), ag.polyline(corners, fillet=bend))
    grip = ag.cylinder_between((0.0, -out, bend - half), (0.0, -out, half - bend), girth - 0.0001)
    leg = ag.cylinder_between((0.0, _SUNK, half), (0.0, bend - out, half), girth - 0.0001)
    brace = ag.cylinder_between((0.0, bend - out, half), (0.0, -out, half - bend), 0.4 * girth)
    hold = ag.frame((0.0, -out, 0.0), approach=(0.0, 1.0, 0.0), closing=(1.0, 0.0, 0.0))
    return ag.weld(
        ag.part(grip, "handle", casting(finish, 0.4), name=name, grasp=hold),
        *(ag.part(each, "handle", finish) for solid in (leg, brace) for each in (solid, solid.mirror(ag.Z))),
        ag.detail(skin, "handle", finish),
    )


@ag.generator
def cup_pull(
    *,
    finish: ag.Material,
    name: str = ag.given("handle"),
    width: ag.Float = ag.uniform(0.064, 0.073, "m", within=(0.05, 0.074)),
    height: ag.Float = ag.uniform(0.025, 0.033, "m"),
    projection: ag.Float = ag.uniform(
        0.023, 0.027, "m", doc="distance from the face of the front to the lip"
    ),
) -> ag.Body:
    """Make a cup pull (bin pull): a quarter of a shell, open below."""
    bulge, end = 0.006, 0.024  # distance from the face to the widest point, and radius of the ends [m]
    a, b, c = width / 2, projection - bulge, height
    half = ag.Region((-a - 0.01, a + 0.01), (-projection - 0.01, _SUNK), (0.0, c + 0.01)).box()
    wall = (_egg(a, end, b, c, -bulge, 0.0) - _egg(a, end, b, c, -bulge, _SHEET)) & half
    # the colliders are flat pieces under that skin: two tabs at its ends, a low wall between them, a top
    tab = ag.Region((a - 0.0040, a - 0.0007), (-bulge - 0.004, _SUNK), (0.0004, 0.0075)).box(bevel=0.0005)
    low, high = (0.0003, 0.0090)
    x = a - end
    corner = ag.polygon(
        [
            (a - 0.0040, -bulge - 0.0030),
            (a - 0.0012, -bulge - 0.0030),
            (x, -bulge - 0.95 * b),
            (x, -bulge - 0.80 * b),
        ]
    )
    side = ag.extrude(corner, high - low).at(0.0, 0.0, (low + high) / 2)
    deep, over = (-bulge - 0.949 * b, -bulge - 0.801 * b), 0.0004
    front = ag.Region((-x - over, x + over), deep, (low + 0.0002, high - 0.0002)).box()
    top = ag.Region((-0.8 * x, 0.8 * x), (-bulge - 0.3 * b, _SUNK), (0.6 * c, 0.92 * c)).box()
    # finger pads end 1 mm before the face, around the widest point
    hold = ag.frame((0.0, -0.010, 0.0045), approach=(0.0, 1.0, 0.0), closing=(1.0, 0.0, 0.0))
    solids = (tab.mirror(ag.X), side, side.mirror(ag.X), front, top)
    return ag.weld(
        ag.part(tab, "handle", finish, name=name, grasp=hold, grasp_width=ag.min_(width + 0.009, 0.0795)),
        *(ag.part(each, "handle", finish) for each in solids),
        ag.detail(wall, "handle", finish),
    )


def _egg(a: ag.Scalar, end: ag.Scalar, b: ag.Scalar, c: ag.Scalar, y: ag.Scalar, less: ag.Scalar) -> ag.Solid:
    """Make the outside of a cup, or the hollow in it, `less` smaller."""
    lobe = ag.ellipsoid(end - less, b - less, c - less)
    return ag.hull(lobe.at(end - a, y, 0.0), lobe.at(a - end, y, 0.0))


GROOVE = 0.034
"""Height of a groove pull above its slab [m]."""


@ag.generator
def groove_pull(
    *,
    length: ag.Float,
    thick: ag.Float,
    front: ag.Material,
    finish: ag.Material,
    end: int,
    name: str = ag.given("drawer_handle"),
    style: Literal["milled", "profile"] = ag.choice("milled", "profile", weights=(0.6, 0.4)),
    lip: ag.Float = ag.uniform(0.0065, 0.0080, "m", doc="thickness of the lip in front of the groove"),
) -> ag.Body:
    """Make the upper edge of a front without handles: a lip, and behind it a groove for fingers.

    The origin is in the middle of the upper edge of the front's face. Hands come to one end of it, from
    beside the furniture, with one finger in front of the lip and the other in the groove.
    """
    foot = 0.006  # height of the slope from the groove to the back [m]
    plate = ag.Region((-length / 2, length / 2), (0.0, lip), (-GROOVE, 0.0)).box(bevel=0.0010)
    low, high = -GROOVE, foot - GROOVE
    slope = ag.polygon([(lip - 0.0012, low), (thick, low), (thick, high), (lip - 0.0012, high + foot)])
    edge = ag.union(plate, ag.extrude(slope, length - 0.0004, axis=ag.X))
    hold = ag.frame(
        (end * (length / 2 - 0.004), lip / 2, -0.0110), approach=(-end, 0.0, 0.0), closing=(0.0, 1.0, 0.0)
    )
    made = front if style == "milled" else finish.with_(name=f"{finish.name}_profile", density=900.0)
    return ag.part(edge, "handle", made, name=name, grasp=hold)


@ag.generator
def edge_pull(
    *,
    finish: ag.Material,
    name: str = ag.given("handle"),
    level: bool = ag.given(True),
    room: ag.Scalar = ag.given(1.3),
    length: ag.Float = ag.uniform(0.09, 0.22, "m", within=(0.04, 1.2)),
    reach: ag.Float = ag.uniform(0.022, 0.026, "m", doc="projection from the face"),
) -> ag.Body:
    """Make an edge pull: a plate on the upper edge of a front that projects from its face, with a rolled lip.

    The origin is on the edge between the face and the upper edge of the front. A vertical pull is for the
    right edge of a door.
    """
    length = ag.require(
        length, length <= room, "the pull is longer than the edge of its door: lower handle.length"
    )
    thick = 0.0022
    plate = ag.Region((-length / 2, length / 2), (-reach, 0.014), (-0.0003, thick)).box(bevel=0.0005)
    lip = ag.capsule(0.0030, length, axis=(1.0, 0.0, 0.0)).at(0.0, -reach, 0.0008)
    # the lip lies 4 mm inside the finger pads
    hold = ag.frame((0.0, 0.005 - reach, 0.0008), approach=(0.0, 1.0, 0.0), closing=(0.0, 0.0, 1.0))
    body = ag.weld(
        ag.part(plate, "handle", casting(finish, 1.0), name=name, grasp=hold), ag.part(lip, "handle", finish)
    )
    return body if level else body.rotate(ag.Y, math.pi / 2)
