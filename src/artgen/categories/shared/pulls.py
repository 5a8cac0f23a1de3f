"""Handles without moving parts: bars, pockets and recesses of appliances, and pulls of furniture.

Each is modeled about the origin on the plane y = 0, which is the face of the front, and projects to -y. All
have the label `handle` and a grasp frame.
"""

import math
from collections.abc import Callable, Sequence
from functools import partial
from typing import Literal

import artgen as ag
from artgen.categories.shared.finish import casting
from artgen.nodes.fitting import Fitting

Way = tuple[int, int, int]
"""Direction of a straight run: an axis or its opposite."""

_EIGHTH = math.tan(math.pi / 8.0)


def rod(radius: ag.Scalar) -> Callable[[ag.Vector, ag.Vector], ag.Solid]:
    """Return a function that makes round straight runs."""

    def run(start: ag.Vector, end: ag.Vector) -> ag.Solid:
        along = end - start
        return ag.cylinder(radius, along.norm(), axis=along).at((start + end) * 0.5)

    return run


def straight_run(section: ag.Profile) -> Callable[[ag.Vector, ag.Vector], ag.Solid]:
    """Return a function that makes straight runs with a section."""
    return lambda start, end: ag.sweep(section, ag.line(start, end))


def bent_bar(
    section: ag.Profile,
    corners: Sequence[tuple[ag.Scalar, ag.Scalar, ag.Scalar]],
    ways: Sequence[Way],
    *,
    bend: ag.Scalar,
    halves: bool,
    run: Callable[[ag.Vector, ag.Vector], ag.Solid] | None = None,
) -> list[ag.Solid]:
    """Make a bar along axes: its straight runs, then its bends; each is nearly convex.

    The distance from a bend's inner side to its hull is 0.3 of the radius, or 0.08 for bends in halves.
    """
    straight = run or straight_run(section)
    points = [ag.vector(*corner) for corner in corners]
    runs: list[ag.Solid] = []
    bends: list[ag.Solid] = []
    for index, way in enumerate(ways):
        along = ag.vector(*way)
        first = points[index] if index == 0 else points[index] + along * bend
        last = points[index + 1] if index == len(ways) - 1 else points[index + 1] - along * bend
        runs.append(straight(first, last))
        if index + 1 < len(ways):
            after = ag.vector(*ways[index + 1])
            bends += _bend(section, points[index + 1], along, after, bend, halves=halves)
    return [*runs, *bends]


def _bend(
    section: ag.Profile,
    corner: ag.Vector,
    before: ag.Vector,
    after: ag.Vector,
    radius: ag.Scalar,
    *,
    halves: bool,
) -> list[ag.Solid]:
    start, end = corner - before * radius, corner + after * radius
    if not halves:
        return [ag.bounding_collider(ag.sweep(section, ag.polyline([start, corner, end], fillet=radius)))]
    short = radius * _EIGHTH
    near, far = start + before * short, end - after * short
    middle = (near + far) * 0.5
    return [
        ag.bounding_collider(ag.sweep(section, ag.polyline(points, fillet=radius)))
        for points in ([start, near, middle], [middle, far, end])
    ]


BarStyle = Literal["round", "square", "bow", "strap", "pro", "arched"]
"""A rod on two posts; a square rod; a bent rod; a flat strap; a thick tube with end caps; a curved blade."""

_SUNK = 0.0006  # depth of the feet in the front [m]
_ARCS = 6  # number of lengths of the curved blade
_BITE = 0.0003  # overlap of the boards of a lining with the walls of a cut [m]
_FINGERS = 0.005  # clearance between an open finger and the handle [m]


@ag.generator
def bar_handle(
    *,
    length: ag.Float,
    finish: ag.Material,
    style: BarStyle = ag.given("round"),
    level: bool = ag.given(False),
    name: str = ag.given("handle"),
    overhang: ag.Float = ag.given(0.045),
    projection: ag.Float = ag.uniform(
        0.044, 0.058, "m", doc="distance from the front to the middle of the bar"
    ),
    girth: ag.Float = ag.uniform(0.0075, 0.0105, "m", doc="half of the thickness of the bar"),
) -> ag.Body:
    """Make a bar handle on the plane y = 0, vertical about the origin, which is welded to a front."""
    makers: dict[BarStyle, Callable[[ag.Scalar, ag.Scalar, ag.Scalar], list[ag.Solid]]] = {
        "round": partial(_round, overhang=overhang),
        "square": _square,
        "bow": _bow,
        "strap": _strap,
        "pro": _pro,
        "arched": _arched,
    }
    solids = makers[style](projection, length, girth)
    hollow = casting(finish, 0.4)
    hold = ag.frame((0.0, -projection, 0.0), approach=(0.0, 1.0, 0.0), closing=(1.0, 0.0, 0.0))
    body = ag.part(solids, "handle", hollow, name=name, grasp=hold)
    return body.rotate(ag.Y, math.pi / 2) if level else body


def _posts(out: ag.Scalar, apart: ag.Scalar, radius: ag.Scalar) -> list[ag.Solid]:
    """Make the posts of a bar and the flanges under them."""
    post = ag.cylinder(radius, out + _SUNK, axis=ag.Y).at(0.0, (_SUNK - out) / 2, 0.0)
    flange = ag.cylinder(1.55 * radius, 0.004, axis=ag.Y, bevel=0.0012).at(0.0, -0.002 + _SUNK, 0.0)
    return [each.at(0.0, 0.0, end * apart / 2) for each in (post, flange) for end in (-1, 1)]


def _round(out: ag.Scalar, length: ag.Scalar, girth: ag.Scalar, overhang: ag.Scalar) -> list[ag.Solid]:
    bar = ag.cylinder(girth, length, bevel=0.0018).at(0.0, -out, 0.0)
    return [bar, *_posts(out, length - 2 * overhang, 0.7 * girth)]


def _square(out: ag.Scalar, length: ag.Scalar, girth: ag.Scalar) -> list[ag.Solid]:
    bar = ag.box(1.8 * girth, 1.8 * girth, length, bevel=0.0018).at(0.0, -out, 0.0)
    post = ag.box(1.5 * girth, out + _SUNK, 1.8 * girth, bevel=0.0012).at(0.0, (_SUNK - out) / 2, 0.0)
    return [bar, *(post.at(0.0, 0.0, end * (length / 2 - 0.02)) for end in (-1, 1))]


def _bow(out: ag.Scalar, length: ag.Scalar, girth: ag.Scalar) -> list[ag.Solid]:
    half = length / 2 - girth
    corners = [(0.0, _SUNK, -half), (0.0, -out, -half), (0.0, -out, half), (0.0, _SUNK, half)]
    ways = [(0, -1, 0), (0, 0, 1), (0, 1, 0)]
    section = ag.circle(girth)
    bars = bent_bar(section, corners, ways, bend=0.024, halves=True, run=rod(girth))
    flange = ag.cylinder(1.5 * girth, 0.004, axis=ag.Y, bevel=0.0012).at(0.0, -0.002 + _SUNK, 0.0)
    # the straight grip comes first: it carries the grasp
    return [bars[1], bars[0], *bars[2:], *(flange.at(0.0, 0.0, end * half) for end in (-1, 1))]


def _strap(out: ag.Scalar, length: ag.Scalar, girth: ag.Scalar) -> list[ag.Solid]:
    thin = 0.006  # thickness of the plate [m]
    plate = ag.extrude(ag.rectangle(2.6 * girth, length, radius=0.004), thin, axis=ag.Y, bevel=0.0016)
    post = ag.box(2.2 * girth, out + _SUNK, 0.012, bevel=0.0016).at(0.0, (_SUNK - out) / 2, 0.0)
    return [plate.at(0.0, -out, 0.0), *(post.at(0.0, 0.0, end * (length / 2 - 0.012)) for end in (-1, 1))]


def _pro(out: ag.Scalar, length: ag.Scalar, girth: ag.Scalar) -> list[ag.Solid]:
    thick = 1.55 * girth
    tube = ag.cylinder(thick, length - 0.052, bevel=0.001).at(0.0, -out, 0.0)
    cap = ag.cylinder(1.24 * thick, 0.036, bevel=0.004)
    foot = ag.box(1.7 * thick, out + _SUNK, 0.026, bevel=0.004).at(0.0, (_SUNK - out) / 2, 0.0)
    ends = [(end * (length / 2 - 0.018)) for end in (-1, 1)]
    return [tube, *(cap.at(0.0, -out, z) for z in ends), *(foot.at(0.0, 0.0, z) for z in ends)]


def _arched(out: ag.Scalar, length: ag.Scalar, girth: ag.Scalar) -> list[ag.Solid]:
    """Make a blade that leaves the front in a long curve, in convex lengths."""
    wide, thin = 2.4 * girth, 0.009
    half, low = length / 2, 0.30  # share of the length over which it rises at each end
    straight = ag.box(wide, thin, (1 - 2 * low) * length + 0.002, bevel=0.002).at(0.0, -out, 0.0)
    solids = [straight]
    for index in range(_ARCS):
        points = []
        for at in (index / _ARCS, (index + 1) / _ARCS):
            rise = math.sin(at * math.pi / 2)
            points.append((-half + at * low * length, -out * rise + (1 - rise) * _SUNK))
        (z0, y0), (z1, y1) = points
        over = 0.0006  # overlap of the lengths, for no seam
        side = ag.polygon(
            [(y0 - thin / 2, z0), (y0 + thin / 2, z0), (y1 + thin / 2, z1 + over), (y1 - thin / 2, z1 + over)]
        )
        length_ = ag.extrude(side, wide, axis=(1.0, 0.0, 0.0))
        solids += [length_, length_.mirror(ag.Z)]
    return solids


def niche(
    width: ag.Scalar, height: ag.Scalar, deep: ag.Scalar, *, sheet: ag.Scalar = 0.0015
) -> list[ag.Solid]:
    """Make the lining of a recess in the front y = 0, about the origin: floor, sides and ends."""
    bite = _BITE
    side = ag.box(sheet + bite, deep, height + 2 * bite)
    end = ag.box(width + 4 * bite, deep - bite, sheet + 2 * bite)
    floor = ag.box(width + 6 * bite, sheet + 3 * bite, height + 6 * bite)
    return [
        floor.at(0.0, deep - (sheet - 3 * bite) / 2, 0.0),
        *(side.at(way * (width - sheet + bite) / 2, deep / 2 + bite, 0.0) for way in (-1, 1)),
        *(end.at(0.0, deep / 2 + 2 * bite, way * ((height - sheet) / 2 + bite)) for way in (-1, 1)),
    ]


def pocket_grip(
    length: ag.Scalar,
    *,
    finish: ag.Material,
    lip: ag.Scalar = 0.015,
    gap: ag.Scalar = 0.024,
    deep: ag.Scalar = 0.030,
    name: str = "handle",
) -> Fitting:
    """Make a pocket in the free edge of a door: fingers reach in from the side, behind a lip.

    The door's front is y = 0 and its free edge x = 0, the door lies at x < 0 and y > 0. A long pocket is the
    channel of a front without handles.
    """
    cut = ag.box(deep + 0.010, gap, length).at(0.005 - deep / 2, lip + gap / 2, 0.0)
    bite, sheet = _BITE, 0.0015  # boards overlap the walls of the cut, and no two of them end at one corner
    inner = ag.box(sheet + 3 * bite, gap + 6 * bite, length + 6 * bite)
    flat = ag.box(deep, sheet + bite, length + 2 * bite)
    ends = ag.box(deep - bite, gap + 4 * bite, sheet + 2 * bite)
    near, aside = (sheet - bite) / 2, (length - sheet) / 2 + bite
    boards = [
        inner.at((sheet - 3 * bite) / 2 - deep, lip + gap / 2, 0.0),
        *(flat.at(-deep / 2 - bite, y, 0.0) for y in (lip + near, lip + gap - near)),
        *(ends.at(-deep / 2 - 2 * bite, lip + gap / 2, end * aside) for end in (-1, 1)),
    ]
    hold = ag.frame((-0.013, lip / 2, 0.0), approach=-ag.X, closing=ag.Y)
    opening = lip + sheet + 2 * _FINGERS
    body = ag.part(boards, "handle", finish, name=name, grasp=hold, grasp_width=opening)
    return Fitting(body, cut)


def recessed_grip(
    length: ag.Scalar,
    *,
    finish: ag.Material,
    lining: ag.Material,
    width: ag.Scalar = 0.074,
    deep: ag.Scalar = 0.034,
    level: bool = False,
    name: str = "handle",
    thin: bool = False,
) -> Fitting:
    """Make a recess in a front with a blade in its middle, flush with the front, as the grip.

    The front is y = 0; the recess is vertical about the origin, or horizontal along x.
    """
    sheet, thick = 0.0015, 0.010
    cut = ag.box(width, deep + 0.010, length).at(0.0, deep / 2 - 0.005, 0.0)
    blade_deep = deep - 0.0005
    blade = ag.box(thick, blade_deep, length, bevel=0.002).at(0.0, 0.001 + blade_deep / 2 - 0.0015, 0.0)
    hold = ag.frame((0.0, 0.0155, 0.0), approach=(0.0, 1.0, 0.0), closing=(1.0, 0.0, 0.0))
    walls = niche(width, length, deep, sheet=sheet)
    rim = ag.rectangle(width + 0.006, length + 0.006, radius=0.004)
    rim = rim - ag.rectangle(width - 0.002, length - 0.002)
    shell = ag.weld(
        ag.part(blade, "handle", finish, name=name, grasp=hold),
        (ag.detail if thin else ag.part)(walls, "handle", lining),
        ag.detail(ag.extrude(rim, 0.0012, axis=ag.Y).at(0.0, -0.0002, 0.0), "handle", finish),
    )
    grip = Fitting(shell, cut)
    return grip.rotate(ag.Y, math.pi / 2) if level else grip


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
    solid = ag.part([head, neck], "handle", finish, name=name, grasp=hold)
    return ag.weld(solid, ag.detail([foot, *skin], "handle", finish))


def _head(style: str, radius: ag.Scalar, projection: ag.Scalar) -> tuple[ag.Solid, ag.Scalar, list[ag.Solid]]:
    """Make the head of a knob, which collides as one piece; return it, its widest place, and what is seen."""
    end, out, skin = -projection, -ag.Y, []
    match style:
        case "ball":
            widest = end + 0.86 * radius
            head = ag.cylinder(0.93 * radius, 0.60 * radius, axis=ag.Y).at(y=widest)
            skin = [ag.ellipsoid(radius, 0.86 * radius, radius).at(y=widest)]
        case "disc":
            widest = end + 0.0045
            head = ag.cylinder(radius, 0.009, axis=ag.Y, bevel=0.0022).at(y=widest)
        case "cone":
            widest = end + 0.0035
            head = ag.frustum(0.55 * radius, radius, 0.016, axis=out, bevel=0.0016).at(y=end + 0.008)
        case "square":
            widest = end + 0.0055
            head = ag.box(1.8 * radius, 0.011, 1.8 * radius, bevel=0.0022).at(y=widest)
        case _:
            widest = end + 0.0085
            head = ag.cylinder(radius, 0.007, axis=ag.Y, bevel=0.0022).at(y=widest)
            skin = [ag.dome(0.94 * radius, height=0.0062, axis=out).at(y=end + 0.0062)]
    return head, widest, skin


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
        bow = _bent_pull(length, projection, girth, finish, name)
        return bow.rotate(ag.Y, math.pi / 2) if level else bow
    measures = {"length": length, "projection": projection, "girth": girth, "overhang": 0.16 * length}
    made: ag.Body = bar_handle(finish=finish, style=style, level=level, name=name, **measures)
    return made


def _bent_pull(
    length: ag.Scalar, out: ag.Scalar, girth: ag.Scalar, finish: ag.Material, name: str
) -> ag.Body:
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
        ag.part([leg, leg.mirror(ag.Z), brace, brace.mirror(ag.Z)], "handle", finish),
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
    at, far = -bulge - 0.0030, (-bulge - 0.95 * b, -bulge - 0.80 * b)
    corner = ag.polygon([(a - 0.0040, at), (a - 0.0012, at), (x, far[0]), (x, far[1])])
    side = ag.extrude(corner, high - low).at(0.0, 0.0, (low + high) / 2)
    deep, over = (-bulge - 0.949 * b, -bulge - 0.801 * b), 0.0004
    front = ag.Region((-x - over, x + over), deep, (low + 0.0002, high - 0.0002)).box()
    top = ag.Region((-0.8 * x, 0.8 * x), (-bulge - 0.3 * b, _SUNK), (0.6 * c, 0.92 * c)).box()
    # finger pads end 1 mm before the face, around the widest point
    hold = ag.frame((0.0, -0.010, 0.0045), approach=(0.0, 1.0, 0.0), closing=(1.0, 0.0, 0.0))
    solids = [tab, tab.mirror(ag.X), side, side.mirror(ag.X), front, top]
    opening = ag.min_(width + 0.009, 0.0795)
    body = ag.part(solids, "handle", finish, name=name, grasp=hold, grasp_width=opening)
    return ag.weld(body, ag.detail(wall, "handle", finish))


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
