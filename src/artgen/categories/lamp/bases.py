"""Bases of lamps: weighted bases, poles, tripods, and the turned bodies of table lamps."""

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import Literal

import artgen as ag
from artgen.categories.lamp.arms import Carried
from artgen.categories.lamp.electrics import Switch
from artgen.categories.lamp.finish import hollow

BaseShape = Literal["round", "square", "hexagonal"]
"""Outline of a base."""

BodyForm = Literal["vase", "gourd", "bottle", "column", "turned", "stem"]
"""Shape of a table lamp's body."""

FITTING = 0.035
"""Height of the fitting between the body of a table lamp and its socket [m]."""

PAD = 0.002
"""Height of the felt or rubber under a base [m]."""

_AREA = {
    "round": math.pi,
    "square": 4.0 * 0.89**2,
    "hexagonal": 1.5 * math.sqrt(3.0),
}  # area over the radius squared
# distance of the nearest edge over the radius
_EDGE = {"round": 1.0, "square": 0.89, "hexagonal": math.cos(math.pi / 6.0)}
_BELOW = 0.0020  # depth of the core of a turned body below its surface [m]
_SQUAT = (
    "the body of the lamp has no room between its base and its shade or socket: raise height, or lower "
    "shade_radius or shade_height"
)
_TIPS = (
    "a base against tipping would be higher than wide: raise base_radius, or lower reach, arm_length, "
    "shade_radius or shade_height"
)
_CORE_SIDES = 32  # number of sides of the core: its frustums have 64 corners, the limit of a collider
_STEADY = 1.35  # safety factor of the base against tipping


def base_edge(shape: BaseShape, radius: ag.Scalar) -> ag.Scalar:
    """Return the distance from the middle of a base to its nearest edge [m]."""
    return _EDGE[shape] * radius


def steady_height(
    shape: BaseShape, radius: ag.Scalar, density: float, *, least: ag.Scalar, of: Carried
) -> ag.Float:
    """Return the height of a base that keeps the lamp stable with its arms stretched out."""
    edge = 0.97 * base_edge(shape, radius)  # the pad is a little smaller
    tips = of.moment - of.body.mass() * edge
    high = ag.max_(least, _STEADY * tips / (edge * density * _AREA[shape] * radius * radius))
    return ag.require(high, high < 2.0 * radius, _TIPS)


def base_block(
    shape: BaseShape, radius: ag.Scalar, height: ag.Scalar, *, bevel: ag.Scalar = 0.0025
) -> ag.Solid:
    """Make the block of a base on its pad, up to z = height."""
    tall = height - PAD
    match shape:
        case "round":
            block = ag.cylinder(radius, tall, bevel=bevel)
        case "square":
            block = ag.box(2.0 * 0.89 * radius, 2.0 * 0.89 * radius, tall, bevel=bevel)
        case "hexagonal":
            block = ag.extrude(ag.regular_polygon(6, radius), tall, bevel=bevel)
    return block.at(0.0, 0.0, PAD + tall / 2.0)


def pad(shape: BaseShape, radius: ag.Scalar) -> ag.Body:
    """Make the pad under a base, which keeps it from sliding and scratching."""
    inset = 0.96 * radius
    match shape:
        case "round":
            sheet = ag.cylinder(inset, PAD + 0.0006)
        case "square":
            sheet = ag.box(1.78 * inset, 1.78 * inset, PAD + 0.0006)
        case "hexagonal":
            sheet = ag.extrude(ag.regular_polygon(6, inset), PAD + 0.0006)
    return ag.part(sheet.at(0.0, 0.0, (PAD + 0.0006) / 2.0), "foot", ag.material("rubber"))


def weighted_base(
    shape: BaseShape,
    radius: ag.Scalar,
    height: ag.Scalar,
    finish: ag.Material,
    *,
    set_in: Switch | None = None,
    front: ag.Scalar = 0.0,
) -> ag.Body:
    """Make a base on its pad: the link `base`."""
    block = base_block(shape, radius, height)
    if set_in is None:
        return ag.weld(ag.part(block, "base", finish), pad(shape, radius))
    at = ag.vector(0.0, -front, height)
    if set_in.hole is not None:
        block = block - set_in.hole.at(at)
    return ag.weld(ag.part(block, "base", finish), pad(shape, radius), set_in.body.at(at))


_LENGTHS = 4  # number of lengths of a pole with a sliding ring


def pole(
    radius: ag.Scalar, low: ag.Scalar, high: ag.Scalar, finish: ag.Material, *, capped: bool = False
) -> ag.Body:
    """Make an upright tube with a flange at its foot and, if it is `capped`, a ball at its end.

    A ring slides on a capped pole, which collides in short lengths: PhysX lets a ring jam on a long thin
    collider.
    """
    if capped:
        long = (high - low) / _LENGTHS
        length = ag.cylinder(radius, long + 0.001)
        middles = [low + long * (number + 0.5) for number in range(_LENGTHS)]
        tube_ = ag.union(*(length.at(0.0, 0.0, middle) for middle in middles))
    else:
        tube_ = ag.cylinder_between((0.0, 0.0, low), (0.0, 0.0, high), radius, bevel=0.001)
    flange = ag.cylinder(2.1 * radius, 0.008, bevel=0.0025).at(0.0, 0.0, low + 0.004)
    bodies = [ag.part(tube_, "pole", hollow(finish)), ag.part(flange, "pole", finish)]
    if capped:
        bodies.append(ag.part(ag.sphere(1.7 * radius).at(0.0, 0.0, high + 0.8 * radius), "pole", finish))
    return ag.weld(*bodies)


def tripod(
    *, spread: ag.Scalar, height: ag.Scalar, radius: ag.Scalar, finish: ag.Material, metal: ag.Material
) -> ag.Body:
    """Make three slanted legs under a hub with its top at a height; one leg points to the front."""
    top = 0.034
    disc = ag.cylinder(0.052, 0.030, bevel=0.004).at(0.0, 0.0, height - 0.015)
    bodies = [ag.part(disc, "pole", metal.with_(name=f"{metal.name}_hub", density=1500.0), name="base")]
    foot = ag.cylinder(0.62 * radius + 0.004, 0.014, bevel=0.003)
    rise = height - 0.020
    for number in range(3):
        turn = math.pi * (1.5 + 2.0 * number / 3.0)
        out = ag.vector(math.cos(turn), math.sin(turn), 0.0)
        low, high = out * spread + ag.vector(0.0, 0.0, 0.010), out * top + ag.vector(0.0, 0.0, rise)
        leg = _strut(low, high, 0.62 * radius, radius)
        share = 0.09
        end = low + (high - low) * share
        ferrule = _strut(low, end, 0.62 * radius + 0.0012, 0.62 * radius + 0.0012 + 0.38 * share * radius)
        bodies += [
            ag.part(leg, "pole", finish),
            ag.detail(ferrule, "pole", metal),
            ag.part(foot.at(out * spread + ag.vector(0.0, 0.0, 0.007)), "foot", ag.material("rubber")),
        ]
    share = 0.46  # share of the height at which three rods hold the legs apart
    corners = [
        ag.vector(math.cos(turn), math.sin(turn), 0.0) * (spread + (top - spread) * share)
        + ag.vector(0.0, 0.0, 0.010 + (rise - 0.010) * share)
        for turn in (math.pi * (1.5 + 2.0 * number / 3.0) for number in range(3))
    ]
    rods = [_strut(corners[index], corners[index - 1], 0.0035, 0.0035) for index in range(3)]
    return ag.weld(*bodies, *(ag.part(rod, "pole", metal) for rod in rods))


def _strut(low: ag.Vector, high: ag.Vector, thin: ag.Scalar, thick: ag.Scalar) -> ag.Solid:
    along = high - low
    return ag.frustum(thin, thick, along.norm(), axis=along).at((low + high) * 0.5)


_BODIES: dict[str, Sequence[tuple[float, float]]] = {
    # radius and height from the foot to the neck, as shares
    "vase": ((0.60, 0.0), (0.80, 0.16), (1.0, 0.45), (0.96, 0.66), (0.62, 0.88), (0.30, 0.97), (0.24, 1.0)),
    "gourd": (
        (0.62, 0.0),
        (0.96, 0.15),
        (1.0, 0.30),
        (0.66, 0.52),
        (0.46, 0.62),
        (0.60, 0.76),
        (0.52, 0.90),
        (0.22, 1.0),
    ),
    "bottle": ((0.86, 0.0), (1.0, 0.10), (1.0, 0.42), (0.82, 0.62), (0.36, 0.80), (0.26, 0.90), (0.26, 1.0)),
    "column": ((1.0, 0.0), (0.66, 0.07), (0.50, 0.16), (0.46, 0.5), (0.42, 0.86), (0.60, 0.93), (0.42, 1.0)),
    "stem": ((1.0, 0.0), (0.62, 0.10), (0.42, 0.28), (0.36, 0.55), (0.36, 0.80), (0.42, 1.0)),
    "turned": (
        (0.95, 0.0),
        (0.72, 0.07),
        (0.42, 0.13),
        (0.66, 0.24),
        (0.72, 0.32),
        (0.44, 0.46),
        (0.30, 0.60),
        (0.30, 0.78),
        (0.50, 0.86),
        (0.30, 0.93),
        (0.26, 1.0),
    ),
}


def _between(points: Sequence[tuple[float, float]]) -> list[tuple[float, float]]:
    """Return points of an outline with one more point between each two, on a Catmull-Rom curve."""
    found = [points[0]]
    for index in range(len(points) - 1):
        before, after = points[max(index - 1, 0)], points[min(index + 2, len(points) - 1)]
        start, end = points[index], points[index + 1]
        middle = [
            (9.0 * (a + b) - (c + d)) / 16.0 for a, b, c, d in zip(start, end, before, after, strict=True)
        ]
        found += [(middle[0], middle[1]), end]
    return found


def turned_body(
    form: BodyForm, *, radius: ag.Scalar, low: ag.Scalar, high: ag.Scalar, finish: ag.Material
) -> ag.Body:
    """Make the turned or thrown body of a table lamp between two heights.

    A smooth surface is visible; the mass and the colliders are a core of frustums 2 mm below it, each of them
    one convex piece with few corners.
    """
    least = 0.020 if form == "stem" else 0.068  # the core of a lower one would intersect itself
    high = ag.require(high, high - low >= least, _SQUAT)
    points = [(r * radius, 0.0, low + share * (high - low)) for r, share in _between(_BODIES[form])]
    core = ag.revolve(ag.half_section(ag.polyline(points), inset=_BELOW), sides=_CORE_SIDES)
    skin = ag.revolve(ag.half_section(ag.spline(points), wall=0.0005))
    lid = ag.cylinder(_BODIES[form][-1][0] * radius - 0.0002, 0.0025).at(0.0, 0.0, high - 0.00125)
    return ag.weld(
        ag.part(core, "base", finish), ag.detail(skin, "base", finish), ag.detail(lid, "base", finish)
    )


def wide_up_to(
    form: BodyForm, beside: float, *, radius: ag.Scalar, low: ag.Scalar, high: ag.Scalar
) -> ag.Scalar:
    """Return the height up to which a turned body is wider than a distance from its axis [m]."""
    found = low
    share = beside / radius
    for (r, at), (r_above, at_above) in pairwise(_between(_BODIES[form])):
        way = ag.clamp((r - share) / (r - r_above), 0.0, 1.0) if r > r_above else 1.0
        end = low + (at + way * (at_above - at)) * (high - low)
        found = ag.switch(max(r, r_above) > share, end, found)
    return found


def neck(
    form: BodyForm, radius: ag.Scalar, *, low: ag.Scalar, high: ag.Scalar, finish: ag.Material
) -> ag.Body:
    """Make the fitting between a body and its socket: a cap on the body, and a tube."""
    wide = ag.max_(_BODIES[form][-1][0] * radius + 0.003, 0.016)
    cap = ag.cylinder(wide, 0.006, bevel=0.002).at(0.0, 0.0, low + 0.002)
    stem = ag.cylinder_between((0.0, 0.0, low), (0.0, 0.0, high), 0.0095, bevel=0.001)
    ring = ag.cylinder(0.0125, 0.008, bevel=0.0028).at(0.0, 0.0, low + 0.45 * (high - low))
    return ag.weld(
        ag.part(cap, "pole", finish), ag.part(stem, "pole", hollow(finish)), ag.part(ring, "pole", finish)
    )


def turned_lamp(
    form: BodyForm,
    *,
    radius: ag.Scalar,
    low: ag.Scalar,
    high: ag.Scalar,
    finish: ag.Material,
    metal: ag.Material,
) -> ag.Body:
    """Make the body of a table lamp with the fitting for its socket."""
    shoulder = high - FITTING
    return ag.weld(
        turned_body(form, radius=radius, low=low, high=shoulder, finish=finish),
        neck(form, radius, low=shoulder, high=high + 0.003, finish=metal),
    )


def harp(
    *,
    saddle: ag.Scalar,
    top: ag.Scalar,
    half: ag.Scalar,
    metal: ag.Material,
    stud: ag.Scalar,
    stud_radius: ag.Scalar,
    finial: bool = True,
) -> list[ag.Body]:
    """Make the wire bow that carries a shade around a bulb, with its stud and finial."""
    rise = top - saddle
    course = ag.polyline(
        [
            (-0.014, 0.0, saddle),
            (-half, 0.0, saddle + 0.30 * rise),
            (-half, 0.0, saddle + 0.70 * rise),
            (-0.012, 0.0, top),
            (0.012, 0.0, top),
            (half, 0.0, saddle + 0.70 * rise),
            (half, 0.0, saddle + 0.30 * rise),
            (0.014, 0.0, saddle),
        ]
    )
    seat = ag.cylinder(0.0085, 0.0030, bevel=0.0008).at(0.0, 0.0, top + 0.0012)
    tall = stud + (0.004 if finial else -0.003)  # a stud without a finial ends inside the hub
    pin = ag.cylinder(stud_radius, tall).at(0.0, 0.0, top + tall / 2.0)
    knob = ag.sphere(0.0085).at(0.0, 0.0, top + stud + 0.0095)
    saddle_bar = ag.box(0.034, 0.010, 0.0030, bevel=0.0008).at(0.0, 0.0, saddle)
    bodies = [
        ag.part(ag.sweep(ag.circle(0.0019), course), "harp", metal),
        ag.part(saddle_bar, "harp", metal),
        ag.part(seat, "harp", metal),
        ag.part(pin, "harp", metal),
    ]
    if finial:
        collar = ag.cylinder(0.0062, 0.004, bevel=0.0008).at(0.0, 0.0, top + stud + 0.0025)
        bodies += [ag.part(collar, "finial", metal), ag.part(knob, "finial", metal)]
    return bodies
