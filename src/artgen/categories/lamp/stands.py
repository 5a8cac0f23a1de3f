"""Stands of lamps: weighted bases, poles, tripods, and the turned bodies of table lamps."""

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import Literal

import artgen as ag
from artgen.categories.lamp.arms import Carried
from artgen.categories.lamp.finish import hollow

BaseShape = Literal["round", "square", "hexagonal"]
BodyForm = Literal["vase", "gourd", "bottle", "column", "turned", "stem"]

FITTING = 0.035  # height of the fitting between the body of a table lamp and its socket [m]

_PAD = 0.002  # height of the felt or rubber under a base [m]
# area over the radius squared, and distance of the nearest edge over the radius
_SHAPES = {
    "round": (math.pi, 1.0),
    "square": (4 * 0.89**2, 0.89),
    "hexagonal": (1.5 * math.sqrt(3), math.cos(math.pi / 6)),
}
_BELOW = 0.0020  # depth of the core of a turned body below its surface [m]
_CORE_SIDES = 32  # number of sides of the core: its frustums have 64 corners, the limit of a collider
_STEADY = 1.35  # safety factor of the base against tipping
_LENGTHS = 4  # number of lengths of a pole with a sliding ring
_RUBBER = ag.material("rubber")
_SQUAT = (
    "the body of the lamp has no room between its base and its shade or socket: raise height, or lower "
    "shade_radius or shade_height"
)
_TIPS = (
    "a base against tipping would be higher than wide: raise base_radius, or lower reach, arm_length, "
    "shade_radius or shade_height"
)
# radius and height from the foot to the neck, as shares
_FORMS: dict[BodyForm, Sequence[tuple[float, float]]] = {
    "vase": ((0.60, 0.0), (0.80, 0.16), (1.0, 0.45), (0.96, 0.66), (0.62, 0.88), (0.30, 0.97), (0.24, 1.0)),
    "gourd": ((0.62, 0.0), (0.96, 0.15), (1.0, 0.30), (0.66, 0.52), (0.46, 0.62), (0.60, 0.76), (0.52, 0.90),
              (0.22, 1.0)),
    "bottle": ((0.86, 0.0), (1.0, 0.10), (1.0, 0.42), (0.82, 0.62), (0.36, 0.80), (0.26, 0.90), (0.26, 1.0)),
    "column": ((1.0, 0.0), (0.66, 0.07), (0.50, 0.16), (0.46, 0.5), (0.42, 0.86), (0.60, 0.93), (0.42, 1.0)),
    "stem": ((1.0, 0.0), (0.62, 0.10), (0.42, 0.28), (0.36, 0.55), (0.36, 0.80), (0.42, 1.0)),
    "turned": ((0.95, 0.0), (0.72, 0.07), (0.42, 0.13), (0.66, 0.24), (0.72, 0.32), (0.44, 0.46),
               (0.30, 0.60), (0.30, 0.78), (0.50, 0.86), (0.30, 0.93), (0.26, 1.0)),
}  # fmt: skip


def base_edge(shape: BaseShape, radius: ag.Scalar) -> ag.Scalar:
    """Return the distance from the middle of a base to its nearest edge [m]."""
    return _SHAPES[shape][1] * radius


def steady_height(
    shape: BaseShape, radius: ag.Scalar, density: float, least: ag.Scalar, carried: Carried
) -> ag.Float:
    """Return the height of a base that keeps the lamp stable with its arms stretched out."""
    edge = 0.97 * base_edge(shape, radius)  # the pad is a little smaller
    tips = carried.moment - carried.body.mass() * edge
    high = ag.max_(least, _STEADY * tips / (edge * density * _SHAPES[shape][0] * radius * radius))
    return ag.require(high, high < 2 * radius, _TIPS)


def _slab(shape: BaseShape, radius: ag.Scalar, low: float, high: ag.Scalar, bevel: float = 0.0) -> ag.Solid:
    tall = high - low
    match shape:
        case "round":
            slab = ag.cylinder(radius, tall, bevel=bevel)
        case "square":
            slab = ag.box(1.78 * radius, 1.78 * radius, tall, bevel=bevel)
        case "hexagonal":
            slab = ag.extrude(ag.regular_polygon(6, radius), tall, bevel=bevel)
    return slab.at(z=(low + high) / 2)


def weighted_base(shape: BaseShape, radius: ag.Scalar, height: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make a base on a pad, which keeps it from sliding and scratching: the link `base`."""
    return ag.weld(
        ag.part(_slab(shape, radius, _PAD, height, 0.0025), "base", finish),
        ag.part(_slab(shape, 0.96 * radius, 0.0, _PAD + 0.0006), "foot", _RUBBER),
    )


def pole(
    radius: float, low: ag.Scalar, high: ag.Scalar, finish: ag.Material, *, capped: bool = False
) -> ag.Body:
    """Make an upright tube with a flange at its foot and, if it is `capped`, a ball at its end.

    A ring slides on a capped pole, which collides in short lengths: PhysX lets a ring jam on a long thin
    collider.
    """
    solids = [ag.cylinder(2.1 * radius, 0.008, bevel=0.0025).at(z=low + 0.004)]
    if capped:
        long = (high - low) / _LENGTHS
        length = ag.cylinder(radius, long + 0.001)
        tube = ag.union(*(length.at(z=low + long * (number + 0.5)) for number in range(_LENGTHS)))
        solids.append(ag.sphere(1.7 * radius).at(z=high + 0.8 * radius))
    else:
        tube = ag.cylinder_between((0, 0, low), (0, 0, high), radius, bevel=0.001)
    return ag.weld(ag.part(tube, "pole", hollow(finish)), ag.part(solids, "pole", finish))


def tripod(spread: ag.Scalar, height: ag.Scalar, finish: ag.Material, metal: ag.Material) -> ag.Body:
    """Make three slanted legs under a hub with its top at a height; one leg points to the front."""
    top, rise, thick, thin = 0.034, height - 0.020, 0.014, 0.62 * 0.014
    disc = ag.cylinder(0.052, 0.030, bevel=0.004).at(z=height - 0.015)
    foot = ag.cylinder(thin + 0.004, 0.014, bevel=0.003)
    legs, ferrules, feet, corners = [], [], [], []
    for number in range(3):
        turn = math.pi * (1.5 + 2 * number / 3)
        out = ag.vector(math.cos(turn), math.sin(turn))
        low, high = out * spread + (0, 0, 0.010), out * top + (0, 0, rise)
        legs.append(_strut(low, high, thin, thick))
        end = low + (high - low) * 0.09
        ferrules.append(_strut(low, end, thin + 0.0012, thin + 0.0012 + 0.09 * (thick - thin)))
        feet.append(foot.at(out * spread + (0, 0, 0.007)))
        corners.append(low + (high - low) * 0.46)  # three rods hold the legs apart
    rods = [_strut(corners[index], corners[index - 1], 0.0035, 0.0035) for index in range(3)]
    hub = metal.with_(name=f"{metal.name}_hub", density=1500.0)
    return ag.weld(
        ag.part(disc, "pole", hub, name="base"),
        ag.part(legs, "pole", finish),
        ag.detail(ferrules, "pole", metal),
        ag.part(feet, "foot", _RUBBER),
        ag.part(rods, "pole", metal),
    )


def _strut(low: ag.Vector, high: ag.Vector, thin: float, thick: float) -> ag.Solid:
    along = high - low
    return ag.frustum(thin, thick, along.norm(), axis=along).at((low + high) * 0.5)


def _between(points: Sequence[tuple[float, float]]) -> list[tuple[float, float]]:
    """Return points of an outline with one more point between each two, on a Catmull-Rom curve."""
    found = [points[0]]
    for index in range(len(points) - 1):
        before, after = points[max(index - 1, 0)], points[min(index + 2, len(points) - 1)]
        start, end = points[index], points[index + 1]
        middle = [(9 * (a + b) - (c + d)) / 16 for a, b, c, d in zip(start, end, before, after, strict=True)]
        found += [(middle[0], middle[1]), end]
    return found


def turned_body(
    form: BodyForm, radius: ag.Scalar, low: ag.Scalar, high: ag.Scalar, finish: ag.Material
) -> ag.Body:
    """Make the turned or thrown body of a table lamp between two heights.

    A smooth surface is visible; the mass and the colliders are a core of frustums 2 mm below it, each of them
    one convex piece with few corners.
    """
    least = 0.020 if form == "stem" else 0.068  # the core of a lower one would intersect itself
    high = ag.require(high, high - low >= least, _SQUAT)
    points = [(r * radius, 0.0, low + share * (high - low)) for r, share in _between(_FORMS[form])]
    core = ag.revolve(ag.half_section(ag.polyline(points), inset=_BELOW), sides=_CORE_SIDES)
    skin = ag.revolve(ag.half_section(ag.spline(points), wall=0.0005))
    lid = ag.cylinder(_FORMS[form][-1][0] * radius - 0.0002, 0.0025).at(z=high - 0.00125)
    return ag.weld(ag.part(core, "base", finish), ag.detail([skin, lid], "base", finish))


def wide_up_to(
    form: BodyForm, beside: float, radius: ag.Scalar, low: ag.Scalar, high: ag.Scalar
) -> ag.Scalar:
    """Return the height up to which a turned body is wider than a distance from its axis [m]."""
    found = low
    share = beside / radius
    for (r, at), (r_above, at_above) in pairwise(_between(_FORMS[form])):
        way = ag.clamp((r - share) / (r - r_above), 0.0, 1.0) if r > r_above else 1.0
        end = low + (at + way * (at_above - at)) * (high - low)
        found = ag.switch(max(r, r_above) > share, end, found)
    return found


def turned_lamp(
    form: BodyForm,
    radius: ag.Scalar,
    low: ag.Scalar,
    high: ag.Scalar,
    finish: ag.Material,
    metal: ag.Material,
) -> ag.Body:
    """Make the body of a table lamp with the fitting for its socket: a cap on the body, and a tube."""
    shoulder = high - FITTING
    wide = ag.max_(_FORMS[form][-1][0] * radius + 0.003, 0.016)
    cap = ag.cylinder(wide, 0.006, bevel=0.002).at(z=shoulder + 0.002)
    stem = ag.cylinder_between((0, 0, shoulder), (0, 0, high + 0.003), 0.0095, bevel=0.001)
    ring = ag.cylinder(0.0125, 0.008, bevel=0.0028).at(z=shoulder + 0.45 * (FITTING + 0.003))
    return ag.weld(
        turned_body(form, radius, low, shoulder, finish),
        ag.part(cap, "pole", metal),
        ag.part(stem, "pole", hollow(metal)),
        ag.part(ring, "pole", metal),
    )
