"""Handles made of bars and tubes."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Literal

import artgen as ag
from artgen.categories.shared.finish import casting

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

BAR_STYLES: tuple[BarStyle, ...] = ("round", "square", "bow", "strap", "pro", "arched")

_SUNK = 0.0006  # depth of the feet in the front [m]
_ARCS = 6  # number of lengths of the curved blade
_BITE = 0.0003  # overlap of the boards of a lining with the walls of a cut [m]
_FINGERS = 0.005  # clearance between an open finger and the handle [m]


@dataclass(frozen=True)
class Grip:
    """A grip in a recess of a front."""

    cut: ag.Solid  # cutter of the front
    shell: ag.Body  # lining with the label `handle` and the grasp, which is welded to the front

    def at(self, x: ag.Scalar, y: ag.Scalar, z: ag.Scalar) -> "Grip":
        """Return the moved grip [m]."""
        return Grip(self.cut.at(x, y, z), self.shell.at(x, y, z))

    def mirrored(self, normal: tuple[float, float, float]) -> "Grip":
        """Return the grip mirrored in the plane through the origin with that normal."""
        return Grip(self.cut.mirror(normal), self.shell.mirror(normal))


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
    body = ag.weld(
        ag.part(solids[0], "handle", hollow, name=name, grasp=hold),
        *(ag.part(each, "handle", hollow) for each in solids[1:]),
    )
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
    lining: ag.Scalar = 0.0015,
    name: str = "handle",
) -> Grip:
    """Make a pocket in the free edge of a door: fingers reach in from the side, behind a lip.

    The door's front is y = 0 and its free edge x = 0, the door lies at x < 0 and y > 0. A long pocket is the
    channel of a front without handles.
    """
    cut = ag.box(deep + 0.010, gap, length).at(0.005 - deep / 2, lip + gap / 2, 0.0)
    bite = _BITE  # boards overlap the walls of the cut, and no two of them end at one corner
    inner = ag.part(
        ag.box(lining + 3 * bite, gap + 6 * bite, length + 6 * bite).at(
            (lining - 3 * bite) / 2 - deep, lip + gap / 2, 0.0
        ),
        "handle",
        finish,
        name=name,
        grasp=ag.frame((-0.013, lip / 2, 0.0), approach=(-1.0, 0.0, 0.0), closing=(0.0, 1.0, 0.0)),
        grasp_width=lip + lining + 2 * _FINGERS,
    )
    flat = ag.box(deep, lining + bite, length + 2 * bite)
    ends = ag.box(deep - bite, gap + 4 * bite, lining + 2 * bite)
    boards = [
        flat.at(-deep / 2 - bite, lip + (lining - bite) / 2, 0.0),
        flat.at(-deep / 2 - bite, lip + gap - (lining - bite) / 2, 0.0),
        *(
            ends.at(-deep / 2 - 2 * bite, lip + gap / 2, end * ((length - lining) / 2 + bite))
            for end in (-1, 1)
        ),
    ]
    return Grip(cut, ag.weld(inner, *(ag.part(each, "handle", finish) for each in boards)))


def boards_around(x: ag.Span, z: ag.Span, hole: tuple[ag.Span, ag.Span], y: ag.Span) -> list[ag.Solid]:
    """Make the boards of a front around a rectangular opening: left, right, below and above."""
    (left, right), (bottom, top) = hole
    lap = 0.0005  # boards share no corners
    across, thin = (left - lap, right + lap), (y[0] + lap, y[1] - lap)
    return [
        ag.Region((x[0], left), y, z).box(),
        ag.Region((right, x[1]), y, z).box(),
        ag.Region(across, thin, (z[0] + lap, bottom)).box(),
        ag.Region(across, thin, (top, z[1] - lap)).box(),
    ]


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
) -> Grip:
    """Make a recess in a front with a blade in its middle, flush with the front, as the grip.

    The front is y = 0; the recess is vertical about the origin, or horizontal along x.
    """
    sheet, thick = 0.0015, 0.010
    cut = ag.box(width, deep + 0.010, length).at(0.0, deep / 2 - 0.005, 0.0)
    blade_deep = deep - 0.0005
    blade = ag.box(thick, blade_deep, length, bevel=0.002).at(0.0, 0.001 + blade_deep / 2 - 0.0015, 0.0)
    hold = ag.frame((0.0, 0.0155, 0.0), approach=(0.0, 1.0, 0.0), closing=(1.0, 0.0, 0.0))
    walls = niche(width, length, deep, sheet=sheet)
    rim = ag.rectangle(width + 0.006, length + 0.006, radius=0.004) - ag.rectangle(
        width - 0.002, length - 0.002
    )
    shell = ag.weld(
        ag.part(blade, "handle", finish, name=name, grasp=hold),
        *((ag.detail if thin else ag.part)(each, "handle", lining) for each in walls),
        ag.detail(ag.extrude(rim, 0.0012, axis=ag.Y).at(0.0, -0.0002, 0.0), "handle", finish),
    )
    turned = Grip(cut, shell)
    if not level:
        return turned
    return Grip(cut.rotate(ag.Y, math.pi / 2), shell.rotate(ag.Y, math.pi / 2))
