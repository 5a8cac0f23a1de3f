"""A clip with a spring: a clothespin, a clip for bags, paper or hair, or a clamp of a workshop.

Links: `body`, the half that lies below, and `lever`, the other half; `arm_0` and `arm_1` of a binder clip,
`pad_0` and `pad_1` of a clamp. Joints: `jaw_hinge`; `arm_turn_0`, `arm_turn_1`; `pad_turn_0`, `pad_turn_1`.

The jaws are at the left (-x), the ends for fingers at the right. At 0 the jaws are closed, and a spring holds
them so; a finger that presses the end of the lever opens them, until both ends meet. A hair claw stands on
its teeth. The walls of a binder clip bend at its back; both wire arms lie back at 0, ready to be pressed, and
turn over to the front. The work in a clamp turns its pads, which are 2 mm apart when it is closed.

Sizes are those of catalogs of Whitmor, Linden, Esselte, Acco and Bessey. Clothespins of wood are 66-84 mm
long and weigh 5-11 g, those of plastic 70-90 mm, 6-14 g; both hold with 5-10 N at the jaws. Clips for bags
are 60-110 mm wide, 20-38 g; binder clips 19-51 mm wide, 2-38 g, with 20-40 N; bulldog clips 38-76 mm,
12-50 g, 10-25 N; hair claws 60-105 mm, 12-40 g, 4-8 N; spring clamps 100-170 mm long, 35-160 g, 20-45 N.
"""

import math
from collections.abc import Sequence
from functools import reduce
from itertools import pairwise
from operator import or_
from typing import Literal

import artgen as ag
from artgen import details, feel
from artgen.categories.shared import require_size
from artgen.categories.shared.finish import casting, colors

Style = Literal["wood", "plastic", "bag", "binder", "bulldog", "claw", "clamp"]
"""A clothespin of wood or plastic, a clip for bags, for paper or hair, or a clamp."""

_HELD = "the legs of the spring hold it between both halves"
_PLAY = 0.0005  # around a hinge [m]
_WIRE = ag.material("steel").with_(name="spring_wire", base_color=(0.60, 0.59, 0.57), specular_roughness=0.3)
_NICKEL = ag.material("satin_nickel").with_(name="nickel_plated_wire", density=7850.0)
_SHEET = ag.material("steel").with_(name="spring_steel", specular_roughness=0.35)
_TORTOISE = ag.material("glossy_plastic").with_(
    name="tortoise_acetate", base_color=(0.15, 0.058, 0.016), texture="tortoise", density=1280.0
)
_WOODS = ("beech", "pine", "maple", "ash")
_POLYMERS = colors("polypropylene", "sky red yellow forest white orange pink teal")
_TURN = feel.Feel(friction=0.01, damping=0.001, armature=2e-6, effort=0.3)
_ARM = feel.Feel(friction=0.008, damping=0.0008, armature=2e-6, effort=0.2)
_ACCENTS = colors("rubber", "orange red yellow graphite sky")
_FINISHES = {
    "wood": ag.shades(*_WOODS, color=0.06),
    "plastic": ag.shades(*_POLYMERS, color=0.05),
    "bag": ag.shades(*colors("abs", "white red sky forest yellow graphite"), color=0.05),
    "binder": ag.shades(
        *colors("powder_coat", "black black red navy forest yellow white"), "satin_brass", color=0.03
    ),
    "bulldog": ag.shades("satin_nickel", "chrome", "black_steel", "satin_brass", color=0.04),
    "claw": ag.shades(_TORTOISE, "black_abs", *colors("glossy_plastic", "black ivory pink sage"), color=0.04),
    "clamp": ag.shades(*colors("abs", "black graphite navy orange"), color=0.04),
}  # fmt: skip
_SPANS: dict[Style, tuple[float, float]] = {
    "wood": (0.060, 0.095), "plastic": (0.062, 0.100), "bag": (0.050, 0.130), "binder": (0.018, 0.056),
    "bulldog": (0.034, 0.085), "claw": (0.055, 0.120), "clamp": (0.095, 0.190),
}  # fmt: skip
"""Possible sizes by style: lengths of clothespins and clamps, widths of the others [m]."""

_Points = Sequence[tuple[float, float]]

# outlines of the lower halves at their nominal size about the hinge, from the jaw along the inner edge to the
# end for a finger and back [mm]
_WOOD: _Points = (
    (-36.0, -0.15), (0.0, -0.15), (36.0, -4.6), (36.0, -7.6), (35.0, -8.2), (20.0, -8.2), (-9.0, -8.0),
    (-26.0, -6.9), (-35.4, -3.6), (-36.0, -2.8),
)  # fmt: skip
_PLASTIC: _Points = (
    (-40.0, -0.9), (-38.6, -0.15), (-37.2, -0.9), (-35.8, -0.15), (-34.4, -0.9), (-33.0, -0.15), (0.0, -0.15),
    (40.0, -8.2), (40.0, -10.4), (37.0, -11.4), (30.0, -11.2), (18.0, -9.0), (6.0, -8.0), (-9.0, -8.0),
    (-20.0, -9.2), (-30.0, -9.0), (-37.0, -6.2), (-40.0, -3.0),
)  # fmt: skip
_CREST = -8.0  # height of both outlines over the hinge [mm]
_BAG: _Points = (
    (-30.0, -0.15), (0.0, -0.15), (28.0, -6.4), (28.0, -8.6), (25.0, -9.4), (8.0, -7.8), (-6.0, -7.4),
    (-20.0, -6.0), (-28.0, -4.0), (-30.0, -2.0),
)  # fmt: skip
_SLEEVE: _Points = (
    (30, -14.5), (83, -31.5), (86, -35), (82, -40.6), (76, -42), (38, -27.0), (28, -23)
)  # fmt: skip
_CLAMP: _Points = (
    (-63.0, -6.9), (-57.0, -6.9), (-50.0, -13.0), (-30.0, -16.0), (-12.0, -10.5), (0.0, -6.0), (14.0, -7.0),
    (82.0, -29.0), (86.0, -33.0), (84.0, -39.0), (76.0, -41.0), (40.0, -27.0), (14.0, -18.0), (-10.0, -19.0),
    (-30.0, -26.5), (-54.0, -22.0), (-64.0, -13.0), (-65.0, -9.0),
)  # fmt: skip


@ag.category(labels="body lever spring arm pad grip print", joints=(1, 3))
def clothespin(
    *,
    style: Style = ag.choice(
        {
            "wood": 0.22,
            "plastic": 0.18,
            "bag": 0.12,
            "binder": 0.14,
            "bulldog": 0.10,
            "claw": 0.12,
            "clamp": 0.12,
        }
    ),
    size: ag.Float = ag.by(
        "style",
        wood=ag.uniform(0.066, 0.084),
        plastic=ag.uniform(0.070, 0.090),
        bag=ag.uniform(0.060, 0.110),
        binder=ag.choice(0.019, 0.025, 0.032, 0.041, 0.051),
        bulldog=ag.choice(0.038, 0.050, 0.064, 0.076),
        claw=ag.uniform(0.060, 0.105),
        clamp=ag.uniform(0.105, 0.170),
        unit="m",
        within=(0.018, 0.19),
        doc="length of a clothespin or clamp, width of another clip",
    ),
    force: ag.Float = ag.by(
        "style",
        binder=ag.uniform(20.0, 40.0),
        bulldog=ag.uniform(10.0, 25.0),
        claw=ag.uniform(4.0, 8.0),
        clamp=ag.uniform(20.0, 45.0),
        otherwise=ag.uniform(5.0, 10.0),
        unit="N",
        within=(3.0, 80.0),
        doc="force at the closed jaws",
    ),
    finish: ag.Material = ag.by("style", _FINISHES),
    accent: ag.Material = ag.choice(*_ACCENTS, doc="grips and pads"),
    teeth: int = ag.by("style", claw=ag.count(4, 6), otherwise=4, doc="teeth of a half of a hair claw"),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a closed clip."""
    long = style in ("wood", "plastic", "clamp")
    size = require_size(size, _SPANS[style], f"{'length' if long else 'width'} of a {style} clip")
    match style:
        case "wood":
            return _peg(_WOOD, size / 72.0, 9.6, (-22.0, 3.1), force, casting(finish, 1.0), "")
        case "plastic":
            return _peg(_PLASTIC, size / 80.0, 11.5, (-23.0, 4.6), force, casting(finish, 0.72), maker)
        case "bag":
            return _bag(size, force, finish, maker)
        case "binder":
            return _binder(size, force, finish)
        case "bulldog":
            return _bulldog(size, force, finish)
        case "claw":
            return _claw(size, force, teeth, finish)
    return _clamp(size, force, finish, accent, maker)


def _outline(points: _Points, scale: ag.Scalar) -> ag.Profile:
    """Make a polygon from points in a scale [m per point unit]."""
    return ag.polygon([(x * scale, z * scale) for x, z in points])


def _hinge(
    grip: ag.Scalar, swing: float, *, at: ag.VectorLike = (0, 0, 0), way: int = 1, driven: str = ""
) -> ag.Joint:
    """Make the joint of the jaws, closed at 0, with a spring of a torque at rest [N m]."""
    spring = ag.Spring(preload=grip, force=1.5 * grip)
    drag = feel.Feel(friction=0.02 * grip, damping=0.1 * grip, armature=3e-4 * grip, effort=1.8 * grip)
    return ag.Revolute(
        "jaw_hinge", axis=way * ag.Y, pivot=at, limits=(0, swing), spring=spring, feel=drag, driven=driven
    )


def _coil(radius: ag.Scalar, wire: ag.Scalar, wide: ag.Scalar) -> list[ag.Body]:
    """Make the coil of a torsion spring along y, with its mass in a tube."""
    turns = 5
    core = ag.cylinder(radius, 0.98 * wide, axis=ag.Y)
    tube = ag.tube(radius, radius - 1.5 * wire, 0.98 * wide, axis=ag.Y)
    path = ag.helix(radius, 0.88 * wide / turns, turns, axis=ag.Y)
    return [
        ag.part(ag.bounding_collider(tube, core), "spring", casting(_WIRE, 0.75), separate=_HELD),
        ag.detail(ag.sweep(ag.regular_polygon(8, wire), path), "spring", _WIRE),
    ]


def _peg(
    points: _Points,
    scale: ag.Scalar,
    across: float,
    hole: tuple[float, float],
    force: ag.Scalar,
    finish: ag.Material,
    maker: str,
) -> ag.Body:
    """Make a clothespin of two halves with a coil spring in their grooves."""
    wide, wire = across * scale, 0.62 * scale
    low, crest = min(z for _, z in points), _CREST
    outline = _outline(points, scale)
    outline -= ag.regular_polygon(12, 4.1 * scale)
    outline -= ag.regular_polygon(10, hole[1] * scale).at(hole[0] * scale)
    groove = ag.rectangle(1.9 * scale, 2.6 * scale).at(-7.0 * scale, crest * scale)
    outline -= groove
    solid = ag.extrude(outline, wide, axis=ag.Y, bevel=0.0001 if maker else 0.0003)
    side = wide / 2 + 0.7 * wire
    leg = [
        (0.0, side, -3.0 * scale),
        (-4.0 * scale, side, (crest + 1.0) * scale),
        (-7.0 * scale, side, (crest + 0.55) * scale),
        (-7.0 * scale, -0.7 * side, (crest + 0.55) * scale),
    ]
    legs = ag.detail(
        ag.sweep(ag.regular_polygon(8, wire), ag.polyline(leg, fillet=0.8 * scale)), "spring", _WIRE
    )
    seen: list[ag.Body] = [legs]
    if maker:
        pocket = ag.polygon(
            [(x * scale, z * scale) for x, z in ((9.0, -3.6), (36.0, -9.2), (35.0, -9.8), (9.0, -6.6))]
        )
        dark = _shaded(finish)
        seen += [
            details.printed(
                pocket if way < 0 else pocket.mirror(),
                (0, way * wide / 2, 0),
                material=dark,
                facing=(0, way, 0),
            )
            for way in (-1, 1)
        ]
    lower = ag.weld(ag.part(solid, "body", finish, name="body"), *seen, *_coil(2.9 * scale, wire, wide))
    upper_solid = solid.rotate(ag.X, math.pi)
    press = ag.push_on(upper_solid, direction=-ag.Z, at=(0.86 * points[_last(points)][0] * scale, 0, 0))
    upper = ag.weld(
        ag.part(upper_solid, "lever", finish, name="lever", push=press),
        *(each.rotate(ag.X, math.pi) for each in seen),
    )
    reach = -points[0][0] * scale
    inner = points[_last(points)]
    swing = 1.84 * math.atan2(-inner[1], inner[0])
    body = lower.attach(upper, _hinge(force * reach, swing))
    return body.at(0, 0, -low * scale)


def _last(points: _Points) -> int:
    """Return the index of the inner corner at the end for a finger: the first point farthest to the right."""
    return max(range(len(points)), key=lambda index: (points[index][0], points[index][1]))


def _shaded(finish: ag.Material) -> ag.Material:
    """Return a finish in the shade of a pocket."""
    return finish.with_(
        name=f"{finish.name}_pocket", base_color=tuple(0.55 * each for each in finish.base_color)
    )


def _knuckle(radius: ag.Scalar, y: tuple[ag.Scalar, ag.Scalar], web: ag.Profile | None = None) -> ag.Solid:
    """Make a part of a hinge about the y axis, with a web that joins it to its half."""
    outline = ag.circle(radius) if web is None else ag.circle(radius) | web
    return ag.extrude(outline, y[1] - y[0], axis=ag.Y).at(y=(y[0] + y[1]) / 2)


def _bag(size: ag.Scalar, force: ag.Scalar, finish: ag.Material, maker: str) -> ag.Body:
    """Make a clip for bags, with jaws wider than its ends for fingers."""
    unit, narrow = 0.001, ag.max_(0.34 * size, 0.024)
    outline = _outline(_BAG, unit) - ag.regular_polygon(12, 0.0044)
    front = ag.rectangle(0.02, 0.03).at(-0.025)
    jaw = ag.extrude(outline & front, size, axis=ag.Y, bevel=0.0004)
    rear = ag.extrude(outline - ag.rectangle(0.02, 0.03).at(-0.0252), narrow, axis=ag.Y)
    solid = jaw | rear
    pad = ag.Region((-0.0290, -0.0170), (-0.46 * size, 0.46 * size), (-0.0002, -0.00012)).box()
    mark = details.logo(maker, ag.min_(0.0026, 0.7 * narrow / details.lettering_width(maker.upper(), 0.3)))
    soft = ag.detail(pad, "grip", ag.colored("rubber", "light_grey"))
    lower = ag.weld(ag.part(solid, "body", finish, name="body"), soft, *_coil(0.0034, 0.0006, 0.9 * narrow))
    turned = solid.rotate(ag.X, math.pi)
    press = ag.push_on(turned, direction=-ag.Z, at=(0.0245, 0, 0))
    lean = math.atan2(1.6, 17.0)
    upper = ag.weld(
        ag.part(turned, "lever", finish, name="lever", push=press),
        soft.rotate(ag.X, math.pi),
        details.printed(
            mark, (0.0165, 0, 0.0086), material=_shaded(finish), facing=(-lean, 0, 1), up=(-1, 0, -lean)
        ),
    )
    body = lower.attach(upper, _hinge(0.030 * force, 1.84 * math.atan2(6.4, 28.0)))
    return body.at(0.001, 0, 0.0094)


def _clamp(
    size: ag.Scalar, force: ag.Scalar, finish: ag.Material, accent: ag.Material, maker: str
) -> ag.Body:
    """Make a clamp of a workshop, whose pads turn on pins at the ends of its jaws."""
    unit = size / 150.0
    wide, pin = 19.0 * unit, (-60.0 * unit, -10.0 * unit)
    arm = ag.extrude(
        _outline(_CLAMP, unit) - ag.regular_polygon(16, 12.8 * unit), wide, axis=ag.Y, bevel=0.0005
    )
    web = ag.rectangle(15.0 * unit, 8.0 * unit).at(0, -13.0 * unit)
    outer, inner = (wide / 2 - 4.0 * unit, wide / 2), (wide / 2 - 7.4 * unit, wide / 2 - 4.4 * unit)
    ears = [_knuckle(11.4 * unit, y, web) for y in (outer, (-outer[1], -outer[0]))]
    lugs = [_knuckle(11.4 * unit, y, web) for y in (inner, (-inner[1], -inner[0]))]
    hole = ag.bore(3.0 * unit + _PLAY, 0.1, axis=ag.Y)
    sleeve = _outline(_SLEEVE, unit)
    soft = ag.detail(ag.extrude(sleeve, wide + 0.0016, axis=ag.Y, bevel=0.0006), "grip", accent)
    shell = casting(finish, 0.85)
    mark = details.logo(maker, ag.min_(0.005, 22.0 * unit / details.lettering_width(maker.upper(), 0.3)))
    name = details.raised(mark, (-30.0 * unit, -wide / 2, -21.3 * unit), material=finish)
    lower = ag.weld(
        ag.part(arm | ears[0] | ears[1], "body", shell, name="body"),
        soft,
        name,
        ag.part(ag.cylinder(3.0 * unit, wide + 0.004, axis=ag.Y, bevel=0.0006), "spring", _WIRE),
        *_coil(4.1 * unit, 0.80 * unit, 3.6 * unit),
    )
    turned = (arm | ((lugs[0] | lugs[1]) - hole)).rotate(ag.X, math.pi)
    press = ag.push_on(turned, direction=-ag.Z, at=(74.0 * unit, 0, 0))
    upper = ag.weld(ag.part(turned, "lever", shell, name="lever", push=press), soft.rotate(ag.X, math.pi))
    hinge = _hinge(60.0 * unit * force, 0.60)
    pad = _pad(unit, wide, pin, accent)
    joints = [
        ag.Revolute(
            f"pad_turn_{index}", axis=ag.Y, pivot=(pin[0], 0, way * pin[1]), limits=(-0.18, 0.18), feel=_TURN,
            driven="the work between the jaws",
        )
        for index, way in enumerate((1, -1))
    ]  # fmt: skip
    lower = lower.attach(pad.suffixed("_0"), joints[0])
    upper = upper.attach(pad.rotate(ag.X, math.pi).suffixed("_1"), joints[1])
    return lower.attach(upper, hinge).at(-10.0 * unit, 0, 42.0 * unit)


def _pad(unit: ag.Scalar, wide: ag.Scalar, pin: tuple[ag.Scalar, ag.Scalar], finish: ag.Material) -> ag.Body:
    """Make the pad of the lower jaw of a clamp: a plate with cheeks about the pin."""
    half = wide / 2 + 3.2 * unit
    plate = ag.Region((pin[0] - 6.5 * unit, pin[0] + 6.5 * unit), (-half, half), (-4.4 * unit, -1.2 * unit))
    cheek = ag.hull(
        ag.cylinder(3.6 * unit, 2.4 * unit, axis=ag.Y).at(pin[0], 0, pin[1]),
        ag.box(11.0 * unit, 2.4 * unit, 2.0 * unit).at(pin[0], 0, -3.2 * unit),
    )
    cheeks = [cheek.at(y=side * (wide / 2 + 2.0 * unit)) for side in (-1, 1)]
    return ag.part([plate.box(bevel=0.0005), *cheeks], "pad", finish, name="pad")


def _strip(points: _Points, thick: float, unit: ag.Scalar) -> ag.Profile:
    """Make the section of a bent sheet along points."""
    runs = []
    for (x0, z0), (x1, z1) in pairwise(points):
        long = math.hypot(x1 - x0, z1 - z0)
        bar = ag.rectangle((long + 0.8 * thick) * unit, thick * unit).rotate(math.atan2(z1 - z0, x1 - x0))
        runs.append(bar.at((x0 + x1) / 2 * unit, (z0 + z1) / 2 * unit))
    return reduce(or_, runs)


def _bulldog(size: ag.Scalar, force: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make a clip of two bent sheets on a tube with a spring; their ears are for fingers."""
    unit = 0.0005 + 0.01 * size
    jaw = ag.extrude(_strip([(-27, -0.55), (-26, -2.8), (-12, -5.4), (-3, -6.2)], 0.9, unit), size, axis=ag.Y)
    ear = ag.extrude(
        _strip([(-4, -6.2), (4, -6.6), (12, -9.2), (20, -15.5)], 0.9, unit), 0.56 * size, axis=ag.Y
    )
    pad = ag.extrude(_strip([(19.4, -15.0), (24, -17.4)], 0.9, unit), 0.40 * size, axis=ag.Y)
    web = ag.rectangle(7.0 * unit, 3.4 * unit).at(0, -4.8 * unit)
    near, thin = 0.27 * size, 0.9 * unit
    ears = [_knuckle(4.0 * unit, _ordered(side * near, side * (near - thin)), web) for side in (-1, 1)]
    near -= thin + 0.3 * unit
    lugs = [_knuckle(4.0 * unit, _ordered(side * near, side * (near - thin)), web) for side in (-1, 1)]
    metal = finish.with_(name=f"{finish.name}_sheet", density=7850.0)
    tube = ag.cylinder(2.2 * unit, 0.56 * size, axis=ag.Y, bevel=0.0003)
    lower = ag.weld(
        ag.part(ag.union(jaw, ear, pad, *ears), "body", metal, name="body"),
        ag.part(tube, "spring", casting(_WIRE, 0.6)),
        *_coil(3.2 * unit, 0.55 * unit, 0.30 * size),
    )
    hole = ag.bore(2.2 * unit + _PLAY, 0.2, axis=ag.Y)
    turned = ag.union(jaw, ear, pad, *(each - hole for each in lugs)).rotate(ag.X, math.pi)
    press = ag.push_on(turned, direction=(0.46, 0, -0.887), at=(21.7 * unit, 0, 16.2 * unit))
    upper = ag.part(turned, "lever", metal, name="lever", push=press)
    return lower.attach(upper, _hinge(27.0 * unit * force, 0.62)).at(1.5 * unit, 0, -pad.anchor(z=-1).z)


def _ordered(first: ag.Scalar, second: ag.Scalar) -> tuple[ag.Scalar, ag.Scalar]:
    """Return both ends of a span, lowest first."""
    return ag.min_(first, second), ag.max_(first, second)


def _claw(size: ag.Scalar, force: ag.Scalar, teeth: int, finish: ag.Material) -> ag.Body:
    """Make a claw for hair that stands on its teeth, which cross between each other."""
    unit = 0.0004 + 0.0071 * size
    ridge = _outline(
        [(-2.5, -5.2), (-13, -6.2), (-21.5, -13.5), (-18.8, -16), (-11.6, -9.6), (-2.5, -8.4)], unit
    )
    tooth = _outline(
        [(-20.6, -12.0), (-24, -25), (-19, -37), (-6, -45.5), (6, -48), (6, -46.6), (-4, -43), (-15.4, -34.6),
         (-20, -25), (-17.2, -13.2)], unit,
    )  # fmt: skip
    handle = _outline(
        [(-5.2, -7.0), (-5.2, 3.4), (-14, 24), (-17, 25), (-18, 23.4), (-9.4, 2.4), (-9.4, -7.0)], unit
    )
    pitch = size / teeth
    broad = 0.40 * pitch
    round_off = ag.rectangle(0.34 * size, 60.0 * unit, radius=0.11 * size).at(0, -5.0 * unit)
    thumb = ag.extrude(handle, 0.36 * size, axis=ag.Y) & ag.extrude(round_off, 0.1, axis=ag.X)
    back = ag.extrude(ridge, size, axis=ag.Y, bevel=0.0004)
    spots = [pitch * (index + 0.5) - size / 2 for index in range(teeth)]
    prong = ag.extrude(tooth, broad, axis=ag.Y)
    web = ag.rectangle(4.0 * unit, 5.0 * unit).at(-4.0 * unit, -4.0 * unit)
    radius, end = 3.4 * unit, 0.17 * size
    core = _knuckle(radius, (-0.10 * size, 0.10 * size), web)
    pins = [_knuckle(radius, _ordered(side * end, side * (0.10 * size + _PLAY)), web) for side in (-1, 1)]

    def half(way: int, solids: Sequence[ag.Solid]) -> ag.Solid:
        """Make a half; its teeth are beside those of the other."""
        prongs = [prong.at(y=spot - way * 0.25 * pitch) for spot in spots]
        whole = ag.union(back, thumb, *prongs, *solids)
        return whole if way > 0 else whole.mirror(ag.X)

    touch = ag.push_on(thumb.mirror(ag.X), direction=(-0.925, 0, 0.379), at=(14.0 * unit, 0, 13.6 * unit))
    body = ag.weld(
        ag.part(half(1, [core]), "body", finish, name="body"),
        ag.detail(ag.tube(radius + 0.0004, radius - 0.001, 0.15 * size, axis=ag.Y), "spring", _WIRE),
    )
    # along the plate of the thumb
    hold = ag.frame(
        (13.2 * unit, 0, 16.0 * unit), approach=(-0.379, 0.0, -0.925), closing=(0.925, 0.0, -0.379)
    )
    lever = ag.part(half(-1, pins), "lever", finish, name="lever", push=touch, grasp=hold)
    return body.attach(lever, _hinge(0.045 * force, 0.72, way=-1)).at(9.0 * unit, 0, 48.0 * unit)


_FINGERS = "fingers, which are slimmer than those of a gripper"
_WEDGE = 0.585  # angle between the walls of a binder clip [rad]


def _binder(size: ag.Scalar, force: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make a binder clip about its mouth: two walls on a back, each with a wire arm in its rolled edge."""
    unit, deep = size / 32.0, 26.0
    steel = finish.with_(name=f"{finish.name}_on_spring_steel", density=7600.0)
    turn = (-math.sin(_WEDGE / 2), 0.0, math.cos(_WEDGE / 2))  # normal of the plane between the walls
    end = (deep * math.cos(_WEDGE) * unit, deep * math.sin(_WEDGE) * unit)
    rolls = [
        ag.extrude(ag.regular_polygon(10, 1.45 * unit), 0.24 * size, axis=ag.Y).at(
            1.6 * unit, side * 0.34 * size, -1.75 * unit
        )
        for side in (-1, 1)
    ]
    y, sheet = (-size / 2, size / 2), 0.00022 + 0.23 * unit
    wall = ag.Region((0.0, deep * unit), y, (-sheet, -0.00012)).box()
    short = ag.Region((0.0, (deep - 1.1) * unit), y, (-sheet, -0.00012)).box()
    knuckles = [
        ag.extrude(ag.regular_polygon(8, 0.32 * unit), size, axis=ag.Y).at(x, 0, z)
        for x, z in (((deep - 0.3) * unit, -0.3 * unit), end)
    ]
    body = ag.part(ag.union(wall, *rolls, ag.hull(*knuckles)), "body", steel, name="body")
    lever = ag.part(ag.union(short, *rolls), "lever", steel, name="lever").mirror(turn)
    pin = (1.6 * unit, 0, -1.75 * unit)
    arm = _arm(size, 38.0 * unit, unit).at(pin)
    across, normal = ag.vector(*pin), ag.vector(*turn)
    pins = (across, across - normal * (2.0 * across.dot(normal)))
    turns = [
        ag.Revolute(
            f"arm_turn_{index}",
            axis=way * ag.Y,
            pivot=pins[index],
            limits=(0, 2.55),
            feel=_ARM,
            driven=_FINGERS,
        )
        for index, way in enumerate((1, -1))
    ]
    body = body.attach(arm.suffixed("_0"), turns[0])
    lever = lever.attach(arm.mirror(turn).suffixed("_1"), turns[1])
    hinge = _hinge(deep * unit * force, 0.55, at=(end[0], 0, end[1]), driven="fingers that press both arms")
    return body.attach(lever, hinge).at(-deep / 2 * unit, 0, (1.75 + 1.45 * math.cos(math.pi / 10)) * unit)


def _arm(size: ag.Scalar, reach: ag.Scalar, unit: ag.Scalar) -> ag.Body:
    """Make a wire arm about its pin, to the right."""
    wire = 0.8 * unit
    near, far = 0.18 * size, 0.13 * size
    section = ag.regular_polygon(6, 1.06 * wire)
    ends = [((0, side * near, 0), (reach, side * far, 0)) for side in (-1, 1)]
    legs = [ag.sweep(section, ag.line(*each)) for each in ends]
    tip = ag.sweep(section, ag.line((reach, -far, 0), (reach, far, 0)))
    balls = [ag.sphere(wire).at(reach, side * far, 0) for side in (-1, 1)]
    stubs = [ag.cylinder(wire, 0.10 * size, axis=ag.Y).at(0, side * 0.225 * size, 0) for side in (-1, 1)]
    return ag.weld(
        ag.part(ag.union(*legs, tip), "arm", _NICKEL, name="arm"), ag.detail([*balls, *stubs], "arm", _NICKEL)
    )
