"""A shower enclosure: a glass door in a niche, a corner or a quarter circle, or a screen on a bath.

Links: `tray`, or `bath`, with all that is fixed; `door`, or `door_0`, `door_1`. Joints: `door_hinge`,
`door_slide`, `door_slide_0`, ..., `door_roll_0`, `door_roll_1` of curved doors, `fold_hinge` of a second
leaf. At 0 all doors are shut.

The front (-y) is the room. Hinged and pivot doors open to the room, and magnets in the strip of their edge
draw them shut. A pivot door turns about an axis inside its width. Sliding doors hang on rollers: one passes a
fixed pane, two pass each other, or the second of three panels follows the first by half of its way. A bifold
door folds into the shower, its second panel guided in the rail. Two doors part at a corner, or roll around a
quarter circle. Both leaves of a screen on a bath turn freely.

Sizes are those of Kermi, Huppe, Merlyn and Ideal Standard catalogs. Niches are 0.76-1.0 m wide, with a side
pane 0.95-1.25 m, and with sliding doors 1.1-1.6 m; corners and quarter circles are 0.8-1.0 m wide, with a
radius of 0.55 m. Enclosures are 1.9-2.05 m high with their tray, glass is 6-8 mm thick (15-20 kg/m2); a tray
of mineral cast weighs 15-60 kg, the whole 35-110 kg. A screen is 0.9-1.05 by 1.35-1.5 m, 20-30 kg, on an
acrylic bath of 1.6-1.8 by 0.7-0.8 m, 28-34 kg. Magnetic strips hold with 5-12 N, doors slide with 3-8 N.
"""

import math
from dataclasses import replace
from typing import Literal

import artgen as ag
from artgen import feel
from artgen.categories.shared import require_size
from artgen.categories.shared.finish import casting
from artgen.categories.shower.parts import (
    DIAGONAL,
    GAP,
    HEAD,
    PROFILE,
    RIM,
    SEAL,
    SILL,
    Etched,
    Handle,
    Plan,
    bent,
    drain,
    fold_hinge,
    hung,
    ordered,
    tray_with_drain,
)  # fmt: skip

Style = Literal["hinged", "pivot", "sliding", "bifold", "corner", "quadrant", "screen"]
"""A hinged, pivot, sliding or folding door in a niche, two doors at a corner or a curve, or a screen."""

_ETCHED = {"none": 0.66, "band": 0.18, "stripes": 0.16}
_QUARTER = [math.radians(180.0 + 7.5 * step) for step in range(13)]  # angles of a quarter circle
_PITCH = 0.024  # between layers of sliding panels [m]
_OVERLAP = 0.045  # of sliding panels [m]
_RADIUS = 0.55  # of a quarter circle [m]
_SLIDE = feel.Feel(friction=4.0, damping=12.0, effort=60.0)
_HINGE = feel.Feel(friction=0.3, damping=0.8, effort=40.0, velocity=5.0)
_METALS = ("chrome", "brushed_aluminium", "black_anodised", "satin_nickel", "satin_brass")
_GLASSES = ("glass", "frosted_glass", "tinted_glass")
_ACRYLIC = ag.material("glossy_plastic_white").with_(
    name="sanitary_acrylic", density=75.0
)  # a shell over its hollow
_CAST = ag.material("granite").with_(
    name="mineral_cast", base_color=(0.62, 0.61, 0.58), texture="", specular_roughness=0.65, density=900.0
)
_TRAYS = (
    _CAST.with_(name="mineral_cast_white", base_color=(0.80, 0.80, 0.78), specular_roughness=0.35),
    _CAST,
    _CAST.with_(name="mineral_cast_slate", base_color=(0.07, 0.075, 0.08)),
    _CAST.with_(name="mineral_cast_sand", base_color=(0.50, 0.43, 0.34)),
)
_SPANS: dict[Style, tuple[float, float]] = {
    "hinged": (0.74, 1.40), "pivot": (0.72, 1.40), "sliding": (1.00, 1.80), "bifold": (0.70, 1.05),
    "corner": (0.75, 1.10), "quadrant": (0.78, 1.05), "screen": (1.50, 1.90),
}  # fmt: skip
"""Possible widths by style [m]."""


@ag.category(labels="tray bath drain frame glass seal hinge roller handle print", joints=(1, 2))
def shower(
    *,
    style: Style = ag.choice(
        {
            "hinged": 0.20,
            "pivot": 0.14,
            "sliding": 0.20,
            "bifold": 0.10,
            "corner": 0.13,
            "quadrant": 0.11,
            "screen": 0.12,
        }
    ),
    side: bool = ag.by(
        "style",
        hinged={True: 0.55, False: 0.45},
        pivot={True: 0.4, False: 0.6},
        otherwise=False,
        doc="a fixed pane beside the door",
    ),
    width: ag.Float = ag.by(
        "style",
        hinged=ag.by("side", {True: ag.uniform(0.98, 1.25), False: ag.uniform(0.76, 0.94)}),
        pivot=ag.by("side", {True: ag.uniform(1.02, 1.30), False: ag.uniform(0.76, 0.98)}),
        sliding=ag.uniform(1.10, 1.60),
        bifold=ag.uniform(0.76, 1.00),
        corner=ag.uniform(0.80, 1.00),
        quadrant=ag.uniform(0.80, 1.00),
        screen=ag.uniform(1.60, 1.80),
        unit="m",
        within=(0.7, 1.9),
        doc="width of the tray, or length of the bath",
    ),
    depth: ag.Float = ag.by(
        "style",
        screen=ag.uniform(0.70, 0.80),
        otherwise=ag.uniform(0.74, 0.90),
        unit="m",
        within=(0.68, 1.0),
        doc="depth of a tray in a niche, or of a bath",
    ),
    height: ag.Float = ag.uniform(1.90, 2.05, "m", within=(1.8, 2.2)),
    panels: Literal["one", "both", "three"] = ag.by(
        "style",
        sliding={"one": 0.4, "both": 0.35, "three": 0.25},
        otherwise="one",
        doc="one that slides past a fixed pane, both of two, or two that pass a fixed third",
    ),
    rim: ag.Float = ag.uniform(0.030, 0.060, "m", within=(0.025, 0.15), doc="height of a tray"),
    thickness: Literal["six", "eight"] = ag.by(
        "style", hinged="eight", otherwise={"six": 0.7, "eight": 0.3}, doc="thickness of the glass [mm]"
    ),
    handle: Handle = ag.by(
        "style",
        hinged={"knob": 0.4, "bar": 0.4, "towel": 0.2},
        sliding={"bar": 0.5, "towel": 0.5},
        screen="knob",
        otherwise={"knob": 0.5, "bar": 0.5},
    ),
    swing: ag.Float = ag.uniform(1.2, 1.57, "rad", within=(0.5, 1.58), doc="angle of an open door"),
    magnet: ag.Float = ag.uniform(5.0, 12.0, "N", within=(3.0, 20.0), doc="pull of the magnetic strip"),
    hand: Literal["left", "right"] = ag.choice("left", "right"),
    glass: ag.Material = ag.choice(*_GLASSES, weights=(0.76, 0.10, 0.14)),
    etched: Etched = ag.by(
        "style", quadrant="none", screen="none", otherwise=_ETCHED, doc="frosted part of flat panes"
    ),
    tray: ag.Material = ag.choice(*_TRAYS, weights=(0.5, 0.2, 0.16, 0.14)),
    metal: ag.Material = ag.shades(*_METALS, weights=(0.36, 0.24, 0.24, 0.08, 0.08), color=0.03),
) -> ag.Body:
    """Make an enclosure with its doors shut."""
    width = require_size(width, _SPANS[style], f"width of a {style} shower")
    thick = 0.006 if thickness == "six" else 0.008
    plan = Plan(width, rim, height, thick, glass, etched, metal, handle)
    match style:
        case "screen":
            body = _screen(plan, depth, swing)
        case "corner":
            body = _corner(plan, tray)
        case "quadrant":
            body = _quadrant(plan, tray)
        case _:
            base = tray_with_drain(plan, ag.Region.centered(width, depth, 0), tray)
            front = -depth / 2 + RIM
            if style == "sliding":
                makers = {"one": _past, "both": _passing, "three": _following}
                body = makers[panels](plan, base.at(y=-front))
            elif style == "bifold":
                body = _bifold(plan, base.at(y=-front), 0.75 * swing)
            else:
                make = _hinged if style == "hinged" else _pivot
                body = make(plan, base.at(y=-front), swing, magnet, side=side)
            body = body.at(y=front)
    return body.mirror(ag.X) if hand == "right" else body


def _hinged(plan: Plan, base: ag.Body, swing: ag.Scalar, magnet: ag.Scalar, *, side: bool) -> ag.Body:
    """Make a door without a frame on hinges at a wall or at a fixed pane."""
    half = plan.wide / 2
    start = 0.36 * plan.wide - half if side else PROFILE - half
    axis = start + (0.006 if side else 0.0135)
    low, high = plan.low - 0.0005, plan.top
    levels = [(axis, 0, level) for level in (plan.low + 0.24, high - 0.24)]
    notches = ag.array(ag.box(0.026, 0.05, 0.086), at=levels)
    fixed = [plan.wall(-half, 1), plan.wall(half, -1)]
    if side:
        stay = ag.Region((start - 0.05, half), (-0.007, 0.007), (high + 0.006, high + 0.022)).box(bevel=0.003)
        clamp = ag.Region((start - 0.052, start - 0.012), (-0.011, 0.011), (high - 0.03, high + 0.024))
        fixed.append(ag.weld(*plan.pane((0.012 - half, start), (low, high))).cut(notches))
        fixed += [ag.part([stay, clamp.box(bevel=0.002)], "hinge", plan.metal)]
    span, end = (plan.low + 0.008, high), half - PROFILE - GAP
    door = [ag.weld(*plan.pane((axis + 0.006, end), span, name="door")).cut(notches)]
    lower = plan.low + 0.0075
    sweep = ag.Region((axis + 0.008, end - 0.004), (-0.0045, 0.0045), (plan.low + 0.003, lower + 0.006))
    for at in levels:
        ends = [
            ag.hull(
                ag.cylinder(0.011, 0.016),
                ag.Region((-0.022, -0.0125), (-0.011, 0.011), (-0.008, 0.008)).box(),
            ).at(z=way * 0.034)
            for way in (-1, 1)
        ]
        plate = ag.Region((-0.056 if side else -0.030, -0.0125), (-0.011, 0.011), (-0.042, 0.042)).box(
            bevel=0.001
        )
        leaf = ag.hull(
            ag.cylinder(0.011, 0.050), ag.Region((0.0, 0.056), (-0.011, 0.011), (-0.025, 0.025)).box()
        )
        fixed.append(ag.part([plate, *ends], "hinge", casting(plan.metal, 0.7)).at(at))
        door.append(ag.part(leaf, "hinge", casting(plan.metal, 0.7)).at(at))
    body = ag.weld(base, *fixed, plan.strip(half - PROFILE, span))
    panel = ag.weld(
        *door, plan.strip(end, span), ag.detail(sweep.box(bevel=0.0015), "seal", SEAL),
        plan.opener((axis + 0.08, end - 0.02), end - 0.055),
    )  # fmt: skip
    hinge = ag.Revolute(
        "door_hinge", axis=-ag.Z, pivot=(axis, 0, 0), limits=(0, swing), feel=_HINGE,
        detents=feel.detents((0.0, 0.05), 0.6 * magnet),
    )  # fmt: skip
    return body.attach(panel, hinge)


def _pivot(plan: Plan, base: ag.Body, swing: ag.Scalar, magnet: ag.Scalar, *, side: bool) -> ag.Body:
    """Make a framed door that turns about an axis inside its width, below a rail."""
    half, low = plan.wide / 2, plan.low - 0.0005
    start = 0.34 * plan.wide - half if side else PROFILE - half
    fixed = [
        plan.wall(-half, 1),
        plan.wall(half, -1),
        *plan.rails((-half, half), (-0.016, 0.016), lips=False),
    ]
    if side:
        fixed.append(plan.bar((start - 0.022, start), (low, plan.top), (-0.016, 0.016)))
        fixed += plan.pane((0.012 - half, start - 0.010), (plan.low + 0.012, plan.top - 0.012))
    x, z, axis = (start + GAP, half - PROFILE - GAP), plan.panel, start + 0.13
    bars = [ag.Region((x[0] + 0.001, x[1] - 0.001), (-0.006, 0.006), span).box(bevel=0.0015)
            for span in ((z[0] + 0.0004, z[0] + 0.018), (z[1] - 0.018, z[1] - 0.0004))]  # fmt: skip
    pins = [ag.cylinder(0.011, 0.012, axis=ag.Z).at(axis, 0, level) for level in (z[0] - 0.003, z[1] + 0.003)]
    panel = ag.weld(
        *plan.pane((x[0] + 0.006, x[1] - 0.006), (z[0] + 0.006, z[1] - 0.006), name="door"),
        plan.stiles(x, z),
        ag.part(bars, "frame", plan.profile),
        plan.strip(x[1], z),
        plan.grip(x[1] - 0.075, 0.0),
    )
    body = ag.weld(base, *fixed, ag.detail(pins, "hinge", plan.metal), plan.strip(half - PROFILE, z))
    hinge = ag.Revolute(
        "door_hinge", axis=-ag.Z, pivot=(axis, 0, 0), limits=(0, swing), feel=_HINGE,
        detents=feel.detents((0.0, 0.05), 0.5 * magnet),
    )  # fmt: skip
    return body.attach(panel, hinge)


def _past(plan: Plan, base: ag.Body) -> ag.Body:
    """Make a door that hangs by rollers on a bar, and slides before a fixed pane."""
    half, out = plan.wide / 2, -0.036
    beam, low, top = plan.top - 0.065, plan.low, plan.top
    rail = ag.Region((0.002 - half, half - 0.002), (-0.024, -0.012), (beam - 0.034, beam)).box(bevel=0.002)
    ends = [
        ag.Region(
            ordered(side * half, side * (half - 0.030), -side), (-0.030, -0.006), (beam - 0.042, beam + 0.008)
        )
        for side in (-1, 1)
    ]
    studs = [ag.cylinder(0.010, 0.022, axis=ag.Y).at(x, -0.0075, beam - 0.017) for x in (0.06, half - 0.16)]
    caps = [
        ag.cylinder(0.016, 0.006, axis=ag.Y, bevel=0.001).at(x, 0.006, beam - 0.017)
        for x in (0.06, half - 0.16)
    ]
    nubs = [
        ag.Region((-0.016, 0.026), y, (low - 0.0005, z)).box(bevel=0.001)
        for y, z in (
            ((-0.0470, -0.0420), low + 0.030),
            ((-0.0300, -0.0250), low + 0.030),
            ((-0.047, 0.006), low + 0.006),
        )
    ]
    body = ag.weld(
        base,
        plan.wall(half, -1),
        plan.bar((-half, 0.020 - half), (low - 0.0005, top), (-0.050, -0.010)),
        *plan.pane((-0.020, half - 0.012), (low - 0.0005, top - 0.004)),
        ag.part(
            [rail, *studs, *(each.box(bevel=0.002) for each in ends)], "roller", casting(plan.metal, 0.6)
        ),
        ag.part(nubs, "roller", plan.profile),
        ag.detail(caps, "roller", plan.metal),
        plan.strip(0.021 - half, (low + 0.01, top), out),
    )
    x, z = (0.027 - half, 0.030), (low + 0.010, top)
    wheels, covers = [], []
    for place in (x[0] + 0.10, x[1] - 0.10):
        at = (place, 0, beam + 0.0243)
        wheels += [ag.cylinder(0.024, 0.009, axis=ag.Y, bevel=0.001).at(y=-0.018).at(at),
                   ag.cylinder(0.007, 0.016, axis=ag.Y).at(y=-0.027).at(at)]  # fmt: skip
        covers.append(
            ag.cylinder(0.026, 0.007, axis=ag.Y, bevel=0.002).at(y=out - plan.thick / 2 - 0.003).at(at)
        )
    door = ag.weld(
        *plan.pane(x, z, out, name="door"),
        ag.part([*wheels, *covers], "roller", casting(plan.metal, 0.7), separate="pinned to the glass"),
        plan.strip(x[0], z, out),
        plan.opener((x[0] + 0.05, x[1] - 0.07), x[0] + 0.07, out, through=False),
    )
    return body.attach(door, _slide("door_slide", half - 0.062))


def _slide(name: str, way: ag.Scalar, axis: ag.VectorLike = ag.X) -> ag.Joint:
    """Make the joint of a door on rollers."""
    return ag.Prismatic(name, axis=axis, limits=(0, way), feel=_SLIDE)


def _passing(plan: Plan, base: ag.Body) -> ag.Body:
    """Make two doors that pass each other between rails."""
    half, y = plan.wide / 2, (-0.030, 0.030)
    inside = half - PROFILE
    body = ag.weld(base, plan.wall(-half, 1, y), plan.wall(half, -1, y), *plan.rails((-half, half), y))
    x, way = (0.003 - inside, _OVERLAP / 2), inside - _OVERLAP / 2 - 0.006
    outer = ag.weld(
        *hung(plan, x, -_PITCH / 2), plan.opener(x, x[0] + 0.055, -_PITCH / 2, through=False)
    ).suffixed("_0")
    grip = replace(plan, handle="bar").grip(-x[0] - 0.055, _PITCH / 2, out=1, through=False)
    inner = ag.weld(*hung(plan, (-x[1], -x[0]), _PITCH / 2), grip).suffixed("_1")
    body = body.attach(outer, _slide("door_slide_0", way))
    return body.attach(inner, _slide("door_slide_1", way, -ag.X))


def _following(plan: Plan, base: ag.Body) -> ag.Body:
    """Make two doors that slide before a fixed pane, the second half as far as the first."""
    half, y = plan.wide / 2, (-0.042, 0.034)
    inside = half - PROFILE
    wide = 2 * inside / 3 + 0.03
    body = ag.weld(
        base, plan.wall(-half, 1, y), plan.wall(half, -1, y), *plan.rails((-half, half), y),
        *plan.pane((inside - wide, half - 0.012), (plan.low + 0.012, plan.top - 0.012), _PITCH),
    )  # fmt: skip
    x = (0.003 - inside, 0.003 - inside + wide)
    first = ag.weld(*hung(plan, x, -_PITCH), plan.opener(x, x[0] + 0.055, -_PITCH, through=False)).suffixed(
        "_0"
    )
    second = ag.weld(*hung(plan, (-wide / 2, wide / 2), 0.0)).suffixed("_1")
    slide = _slide("door_slide_0", 2 * inside - wide - 0.006)
    body = body.attach(first, slide)
    return body.attach(second, ag.Prismatic("door_slide_1", axis=ag.X, follows=0.5 * slide, damping=8.0))


def _bifold(plan: Plan, base: ag.Body, swing: ag.Scalar) -> ag.Body:
    """Make a door of two panels that folds inwards; the far edge of the second is guided in the rails."""
    half, z, deep = plan.wide / 2, plan.panel, 0.0145
    first, last = PROFILE - half + 0.018, half - PROFILE - 0.018  # axis at the wall, and guide
    middle = (first + last) / 2
    fixed = [
        plan.wall(-half, 1),
        plan.wall(half, -1),
        *plan.rails((-half, half), (-0.016, 0.016), lips=False),
    ]
    pins = [ag.cylinder(0.009, 0.012).at(first, 0, level) for level in (z[0] - 0.003, z[1] + 0.003)]
    fixed += [ag.detail(pins, "hinge", plan.metal), plan.strip(half - PROFILE, z)]
    knuckle, leaf = fold_hinge(plan, (middle, -deep, 0), z, -1)
    near = ag.weld(*hung(plan, (first - 0.012, middle - 0.003), 0.0), knuckle).suffixed("_0")
    span = (middle + 0.003, last + 0.012)
    guides = [ag.cylinder(0.006, 0.010).at(last, 0, level) for level in (z[0] - 0.002, z[1] + 0.002)]
    far = ag.weld(
        *hung(plan, span, 0.0), leaf, ag.detail(guides, "roller", plan.metal),
        plan.grip(0.36 * span[0] + 0.64 * span[1], 0.0),
    ).suffixed("_1")  # fmt: skip
    turn = ag.Revolute("door_hinge", axis=ag.Z, pivot=(first, 0, 0), limits=(0, swing), feel=_HINGE)
    fold = ag.Revolute("fold_hinge", axis=ag.Z, pivot=(middle, -deep, 0), follows=-2.0 * turn, damping=0.3)
    return ag.weld(base, *fixed).attach(near.attach(far, fold), turn)


def _corner(plan: Plan, tray: ag.Material) -> ag.Body:
    """Make two doors that slide from the corner at the front and the left, inside fixed panes."""
    long = plan.wide - RIM
    mid, high = long / 2, (plan.low + 0.012, plan.top - 0.012)
    x = (0.034, mid + _OVERLAP / 2)
    pane = ag.weld(
        *plan.pane((mid, long - 0.012), high), plan.wall(long, -1, (-0.0165, 0.0165)),
        plan.bar((mid - 0.004, mid + 0.012), high, (-0.0065, 0.0065)),
    )  # fmt: skip
    rails = [ag.weld(*plan.rails((start, long), (-0.016, 0.040))) for start in (-0.016, 0.0403)]
    door = ag.weld(*hung(plan, x, _PITCH), plan.grip(x[0] + 0.045, _PITCH, through=False))
    base = tray_with_drain(plan, ag.Region((-RIM, long), (-RIM, long), (0, 0)), tray)
    body = ag.weld(base, pane, rails[0], ag.weld(pane, rails[1]).mirror(DIAGONAL))
    way = mid - x[0] - 0.090
    body = body.attach(door.suffixed("_0"), _slide("door_slide_0", way))
    other = door.mirror(DIAGONAL).suffixed("_1")
    return body.attach(other, _slide("door_slide_1", way, ag.Y)).at((RIM - long) / 2, (RIM - long) / 2)


def _quadrant(plan: Plan, tray: ag.Material) -> ag.Body:
    """Make two curved doors that roll around a quarter circle at the front and the left."""
    long, low, top, radius = plan.wide - RIM, plan.low, plan.top, _RADIUS - RIM
    straight, mid = long - radius, -radius
    # about the middle of the circle; the straight front is the plane y = -radius
    rails = [plan.bar((0.0, straight), z, (mid - 0.016, mid + 0.040))
             for z in ((top - HEAD, top), (low - 0.0005, low + SILL))]  # fmt: skip
    flat = plan.pane((-0.001, straight - 0.012), (low + 0.012, top - 0.012), mid)
    curve = bent(radius, plan.thick, (low + 0.012, top - 0.012), 258.0, 12.1, 2)
    side = ag.weld(
        plan.wall(straight, -1, (mid - 0.016, mid + 0.016)),
        *rails,
        *flat,
        ag.part(curve, "glass", plan.glass),
    )
    arcs = [*bent(radius - 0.012, 0.056, (top - HEAD, top), 180.0, 90.0, 8),
            *bent(radius - 0.012, 0.056, (low - 0.0005, low + SILL), 180.0, 90.0, 8)]  # fmt: skip
    z = radius + RIM
    outline, inner = (
        ag.polygon(
            [
                (straight - less, less - z),
                (straight - less, straight - less),
                (less - z, straight - less),
                *(((z - less) * math.cos(a), (z - less) * math.sin(a)) for a in _QUARTER),
            ]
        )
        for less in (0.0, 0.05)
    )
    plate = ag.extrude(outline, low - 0.014, bevel=0.002).at(z=(low - 0.014) / 2)
    edge = ag.extrude(outline - inner, 0.0145).at(z=low - 0.00725)
    base = ag.weld(
        ag.part(plate | edge, "tray", tray, name="tray"),
        *drain(plan.metal, (straight - 0.25, straight - 0.25, low - 0.0142)),
        ag.part(arcs, "frame", plan.profile),
        side,
        side.mirror(DIAGONAL),
    )
    door = _curved(plan, radius - _PITCH)
    roll = feel.Feel(friction=2.0, damping=4.0, effort=30.0)
    joints = [ag.Revolute(f"door_roll_{index}", axis=axis, limits=(0, 0.39), feel=roll)
              for index, axis in enumerate((ag.Z, -ag.Z))]  # fmt: skip
    body = base.attach(door.suffixed("_0"), joints[0])
    body = body.attach(door.mirror(DIAGONAL).suffixed("_1"), joints[1])
    return body.at((z - straight) / 2, (z - straight) / 2)


def _curved(plan: Plan, radius: ag.Scalar) -> ag.Body:
    """Make a curved door about the origin, from the middle of the quarter circle towards its right end."""
    z = plan.panel
    glass = bent(radius, plan.thick, z, 225.9, 35.0, 6)
    stile = ag.Region((-0.008, 0.008), (-radius - 0.0065, 0.0065 - radius), z).box(bevel=0.0015)

    def around(angle: float) -> float:
        return math.radians(angle - 270.0)

    return ag.weld(
        ag.part(glass, "glass", plan.glass, name="door"),
        ag.part([stile.rotate(ag.Z, around(angle)) for angle in (226.6, 260.6)], "frame", plan.profile),
        plan.strip(0.0, z, -radius).rotate(ag.Z, around(225.6)),
        plan.grip(0.0, -radius).rotate(ag.Z, around(231.5)),
    )


def _screen(plan: Plan, depth: ag.Scalar, swing: ag.Scalar) -> ag.Body:
    """Make a bath, and a screen of two leaves on its rim at the left."""
    long, rim = plan.wide, 0.56
    front, half = -depth / 2 + 0.040, plan.wide / 2
    up = replace(plan, low=rim)
    z = (rim + 0.010, plan.top)
    axis, deep = (PROFILE + 0.010 - half, 0.0), 0.0145
    middle = axis[0] + 0.34 * long
    end = middle + 0.24 * long
    web = ag.Region((PROFILE - 0.001 - half, axis[0]), (0.0, 0.005), z).box()
    post = ag.weld(
        up.bar((-half, PROFILE - half), (rim - 0.0005, plan.top), (-0.016, 0.016)),
        ag.part(
            [ag.cylinder(0.0062, z[1] - z[0]).at(axis[0], 0, (z[0] + z[1]) / 2), web], "hinge", plan.profile
        ),
    )
    knuckle, leaf = fold_hinge(plan, (middle, deep, 0), z, 1)
    x = (axis[0] + 0.0085, middle - 0.003)
    near = ag.weld(*up.pane((x[0] + 0.006, x[1] - 0.006), z, name="door_0"), up.stiles(x, z), knuckle)
    room = ag.Region((middle + 0.009, end), (0, 0), z)
    corner, count = 0.16, 8
    arc = [
        (end - corner + corner * math.sin(a), plan.top - corner + corner * math.cos(a))
        for a in (math.pi / 2 * step / count for step in range(count + 1))
    ]
    shape = ag.polygon([(room.x.low, z[0]), (room.x.low, z[1]), *arc, (end, z[0])])
    stile = ag.Region((middle + 0.003, middle + 0.019), (-0.0065, 0.0065), z).box(bevel=0.0015)
    sweep = ag.Region((middle + 0.02, end - 0.002), (-0.0045, 0.0045), (rim + 0.003, rim + 0.016)).box(
        bevel=0.0015
    )
    far = ag.weld(
        ag.part(ag.extrude(shape, plan.thick, axis=ag.Y, bevel=0.0008), "glass", plan.glass, name="door_1"),
        ag.part(stile, "frame", plan.profile),
        leaf,
        ag.detail(sweep, "seal", SEAL),
        up.grip(end - 0.06, 0.0, through=False).at(z=-0.45),
    )
    turn = ag.Revolute("door_hinge", axis=-ag.Z, pivot=(*axis, 0), limits=(0, swing), feel=_HINGE)
    fold = ag.Revolute("fold_hinge", axis=ag.Z, pivot=(middle, deep, 0), limits=(0, 3.0), feel=_HINGE)
    return ag.weld(_bath(plan, depth, rim), post.at(y=front)).attach(
        near.attach(far, fold), turn, at=(0, front, 0)
    )


def _bath(plan: Plan, depth: ag.Scalar, rim: float) -> ag.Body:
    """Make a bath of acrylic with its drain and overflow; its front panel is a part of it."""
    right, back, low = plan.wide / 2, depth / 2, rim - 0.42
    levels = ((0.24, 0.150, low + 0.001), (0.08, 0.075, rim + 0.0003))
    plates = [ag.extrude(_basin(right - x, back - y), 0.002).at(z=z) for x, y, z in levels]
    outside = ag.Region((-right, right), (0.020 - back, back), (0, rim)).box(bevel=0.004)
    lip = ag.Region((-right, right), (-back, 0.024 - back), (rim - 0.035, rim)).box(bevel=0.004)
    drain_at = ag.cylinder(0.032, 0.006, bevel=0.002).at(0.34 - right, 0, low)
    hole = ag.cylinder(0.028, 0.005, axis=ag.X, bevel=0.001).rotate(ag.Y, 0.36)
    return ag.weld(
        ag.part((outside - ag.hull(*plates)) | lip, "bath", _ACRYLIC, name="bath"),
        ag.detail([drain_at, hole.at(0.117 - right, 0, rim - 0.10)], "drain", plan.metal),
    )


def _basin(half: ag.Scalar, deep: ag.Scalar) -> ag.Profile:
    """Make a rectangle with round corners about the origin, of half a width and half a depth."""
    turns = [math.radians(30.0 * step) for step in range(4)]
    quarter = [(half - 0.14 * (1 - math.cos(a)), deep - 0.14 * (1 - math.sin(a))) for a in turns]
    right = [*((x, -y) for x, y in quarter[::-1]), *quarter]
    return ag.polygon([*right, *((-x, y) for x, y in right[::-1])])
