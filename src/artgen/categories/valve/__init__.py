"""A valve out of its pipe: ball, gate, globe or butterfly valve, or needle valves in a panel.

Links: `body`, or `panel` with the bodies of needle valves; `lever` of a ball or butterfly valve; `wheel`, and
`stem` of a gate valve; `knob`. Joints: `lever_turn`, a quarter turn between two stops; `wheel_turn` with
`stem_rise`, or with `wheel_turn_rise` of a globe valve, whose wheel rises with its stem; `knob_turn` with
`knob_turn_rise`. At 0 a valve is closed.

The pipe runs from left to right, the stem is upright. Friction of its seats holds a ball
valve, and ten notches of its plate hold a butterfly. The wheel of a gate valve stays at its
height and draws the stem through itself.

Sizes are those of standards. Lengths from face to face: EN 558 series 14 (gate), 1 (globe), 20 (butterfly);
flanges PN 16 of EN 1092-1; threads of ISO 228 on brass bodies of 50 to 110 mm (DN 15 to 50, catalogs of
Giacomini and Bugatti). Hand wheels of KSB, ARI and AVK catalogs: 120-180 mm up to DN 50, 180-250 mm above.
Brass ball valves turn with about 0.1 N m for each mm of DN, with 0.6 N m at a tee that fingers turn,
and butterflies with 0.07 N m without pressure. EN 1074-2 allows a gate valve as many N m as its DN in mm; the
wheel of a new one runs at a twentieth of that.
Hands pull a rim with up to 360 N for a moment (MSS SP-91); half of that is the effort here.
"""

import math
from typing import Literal

import artgen as ag
from artgen import details, feel, signals
from artgen.categories.shared import controls, finish
from artgen.categories.shared.finish import colors
from artgen.nodes.fitting import FIT

Style = Literal["ball", "gate", "globe", "butterfly", "needle"]
"""Kind of a valve."""

# thread: length of the body, width across the corners of its ends, and length of the lever [m]
_BALL = {15: (0.052, 0.030, 0.092), 20: (0.060, 0.037, 0.092), 25: (0.072, 0.046, 0.112),
         32: (0.083, 0.055, 0.112), 40: (0.094, 0.062, 0.140), 50: (0.110, 0.078, 0.150)}  # fmt: skip
# EN 558 series 14 and 1: from face to face [m]
_GATE = {50: 0.150, 65: 0.170, 80: 0.180, 100: 0.190}
_GLOBE = {15: 0.130, 20: 0.150, 25: 0.160, 32: 0.180, 40: 0.200, 50: 0.230}
_BUTTERFLY = {50: 0.043, 65: 0.046, 80: 0.046, 100: 0.052}
_SIZES = {
    "ball": [*_BALL],
    "gate": [*_GATE],
    "globe": [*_GLOBE],
    "butterfly": [*_BUTTERFLY],
    "needle": [6, 8],
}
"""Nominal sizes by style [mm]."""
# EN 1092-1, PN 16: outer diameter, diameter of the bolt circle, thickness [m], number and diameter of holes
_FLANGE = {15: (0.095, 0.065, 0.016, 4, 0.014), 20: (0.105, 0.075, 0.018, 4, 0.014),
           25: (0.115, 0.085, 0.018, 4, 0.014), 32: (0.140, 0.100, 0.018, 4, 0.018),
           40: (0.150, 0.110, 0.018, 4, 0.018), 50: (0.165, 0.125, 0.018, 4, 0.018),
           65: (0.185, 0.145, 0.018, 4, 0.018), 80: (0.200, 0.160, 0.020, 8, 0.018),
           100: (0.220, 0.180, 0.020, 8, 0.018)}  # fmt: skip
_WHEEL = {15: 0.120, 20: 0.120, 25: 0.140, 32: 0.140, 40: 0.160, 50: 0.180, 65: 0.180, 80: 0.200, 100: 0.250}
"""Diameters of hand wheels [m]."""

_GRIPS = ag.choice({"lever": 0.6, "tee": 0.4})
_RIM = 180.0  # greatest force of a hand at a rim or a lever [N]
_LEVERS = ag.choice(*colors("rubber", "red blue yellow forest black"))
_PAINTS = ag.choice(*colors("powder_coat", "blue navy graphite forest red"))
_WHEELS = ag.choice(*colors("powder_coat", "red black blue graphite"))
_IRON = ag.material("cast_iron")
_STEEL = ag.material("stainless")


@ag.category(
    labels="body flange bolt neck plate lever grip stem wheel knob nut panel foot print", joints=(1, 6)
)
def valve(
    *,
    style: Style = ag.choice({"ball": 0.28, "gate": 0.2, "globe": 0.18, "butterfly": 0.18, "needle": 0.16}),
    dn: int = ag.by(
        "style", {style: ag.choice(*sizes) for style, sizes in _SIZES.items()}, doc="nominal size DN [mm]"
    ),
    grip: Literal["lever", "tee"] = ag.by(
        "dn", {15: _GRIPS, 20: _GRIPS}, otherwise="lever", doc="handle of a ball valve"
    ),
    spokes: int = ag.by("style", gate={3: 0.4, 5: 0.6}, globe={3: 0.5, 4: 0.5}, otherwise=4),
    torque: ag.Float = ag.uniform(0.75, 1.25, within=(0.5, 2.0), doc="friction over that of its size"),
    knobs: int = ag.by("style", needle={1: 0.4, 2: 0.35, 3: 0.25}, otherwise=1, doc="valves in a panel"),
    metal: ag.Material = ag.by(
        "style",
        ball=ag.choice("brass", "satin_nickel", "chrome", "stainless"),
        needle=ag.choice("stainless", "brass", "chrome"),
        otherwise=_PAINTS,
        doc="material or paint of the body",
    ),
    color: ag.Material = ag.by("style", ball=_LEVERS, needle=_LEVERS, otherwise=_WHEELS),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a closed valve."""
    sizes = _SIZES[style]
    ag.require(dn in sizes, f"style={style} is made for dn={' or '.join(map(str, sizes))}: set dn or style")
    match style:
        case "ball":
            body = _ball(dn, grip, torque, metal, color, maker)
        case "gate":
            body = _gate(dn, spokes, torque, metal, color, maker)
        case "globe":
            body = _globe(dn, spokes, torque, metal, color, maker)
        case "butterfly":
            body = _butterfly(dn, torque, metal, color, maker)
        case _:
            body = _panel(dn, knobs, torque, metal, color, maker)
            for number in range(knobs):
                flow = signals.level(f"knob_turn_{number}")
                body = body.output(f"flow_{number}", flow, kind="flow")
            return body
    turned = "wheel_turn" if style in ("gate", "globe") else "lever_turn"
    return body.output("flow", signals.level(turned), kind="flow")


def _cast(paint: ag.Material, share: float) -> ag.Material:
    """Return the paint over hollow cast iron that fills a share of its outside."""
    return paint.with_(name=f"{paint.name}_casting_{round(100 * share)}", density=7200.0 * share)


def _words(lines: tuple[str, ...], high: float, at: ag.VectorLike, face: ag.Material) -> ag.Body:
    """Raise letters on the front of a body."""
    return details.raised(details.lettering(lines, high, tracking=0.05), at, material=face, proud=0.0006)


def _flanged(dn: int, face: float, paint: ag.Material) -> tuple[ag.Body, float]:
    """Make both flanges with their bolt holes and the pipe between, and return the height of the axis."""
    outer, circle, thick, count, hole = _FLANGE[dn]
    middle = outer / 2
    profile = ag.circle(outer / 2) - ag.circle(dn / 2000)
    for x, y in _ring(circle / 2, count):
        profile = profile - ag.circle(hole / 2).at(x, y)
    flange = ag.extrude(profile, thick, axis=ag.X, bevel=0.0015)
    raised = ag.tube(dn / 2000 + 0.012, dn / 2000, 0.004, axis=ag.X)
    bodies = []
    for side in (-1, 1):
        x = side * (face / 2 - thick / 2 - 0.002)
        seat = ag.detail(raised.at(side * (face / 2 - 0.002), 0, middle), "flange", paint)
        disc = ag.bounding_collider(flange, ag.cylinder(outer / 2, thick, axis=ag.X))
        bodies += [
            ag.part(disc.at(x, 0, middle), "flange", _cast(paint, 1.0), separate="cast with the body"),
            seat,
        ]
    pipe = ag.cylinder(dn / 2000 + 0.010, face - 2 * thick, axis=ag.X).at(0, 0, middle)
    return ag.weld(ag.part(pipe, "body", _cast(paint, 0.45)), *bodies), middle


def _ring(radius: float, count: int) -> list[tuple[float, float]]:
    """Return points on a circle, beside the vertical [m]."""
    angles = [math.pi / count + math.tau * at / count for at in range(count)]
    return [(radius * math.cos(angle), radius * math.sin(angle)) for angle in angles]


def _wheel(diameter: float, spokes: int, finish: ag.Material, *, bore: float = 0.0) -> ag.Body:
    """Make a hand wheel about z with its hub at the origin, 22 mm high, and its rim a little higher."""
    radius, rim, rise = diameter / 2, 0.0085 + 0.02 * diameter, 0.012
    core = 0.010 + 0.05 * diameter
    ring = ag.torus(radius - rim / 2, rim / 2).at(z=rise)
    hub = ag.tube(core, bore, 0.022, bevel=0.001) if bore else ag.cylinder(core, 0.022, bevel=0.002)
    arms = []
    for at in range(spokes):
        # a gap is in front, where a hand grasps the rim
        angle = math.pi / 2 + math.tau * (at + (0.0 if spokes % 2 else 0.5)) / spokes
        cosine, sine = math.cos(angle), math.sin(angle)
        near, far = 0.8 * core, radius - rim / 2
        ends = (near * cosine, near * sine, 0.0), (far * cosine, far * sine, rise)
        arms.append(ag.cylinder_between(*ends, 0.0030 + 0.012 * diameter))
    held = ag.box(0.016, rim, rim).at(0, rim / 2 - radius, rise)
    hold = ag.grasp_on(held, approach=ag.Y, closing=ag.Z, depth=0.9 * rim)
    iron = finish.with_(name=f"{finish.name}_wheel", density=5000.0)
    return ag.part(ag.union(ring, hub, *arms), "wheel", iron, grasp=hold, grasp_width=rim + 0.011)


def _ball(
    dn: int, grip: str, torque: ag.Scalar, metal: ag.Material, color: ag.Material, maker: str
) -> ag.Body:
    """Make a ball valve with threads; its lever points to the front when it is closed."""
    long, wide, reach = _BALL[dn]
    middle = wide / 2 * math.cos(math.pi / 6)
    heavy = metal.with_(name=f"{metal.name}_body", density=4300.0)
    end = ag.extrude(ag.regular_polygon(6, wide / 2), 0.24 * long, axis=ag.X, bevel=0.0008)
    bore = ag.cylinder(dn / 2000 + 0.0035, 0.2 * long, axis=ag.X)
    ends = []
    for side in (-1, 1):
        open_end = end.at(side * 0.38 * long) - bore.at(side * 0.42 * long)
        ends.append(open_end.at(z=middle))
    belly = ag.cylinder(0.428 * wide, 0.56 * long, axis=ag.X, bevel=0.004).at(z=middle)
    top = middle + 0.428 * wide
    neck = ag.cylinder(0.0075 + 0.06 * wide, 0.016, bevel=0.0005).at(z=top + 0.002)
    low, thick = top + 0.010 + FIT.running, 0.0030  # lower side of the lever, and its thickness [m]
    bar = 0.011 + 0.1 * wide  # width of the lever [m]
    far = bar / 2 + 0.0035  # of the stops from the axis of the lever
    stops = [
        ag.Region(
            (-far - 0.004, -bar / 2 - FIT.sliding), (-far - 0.004, -far + 0.001), (top - 0.001, low + thick)
        ),
        ag.Region(
            (far - 0.001, far + 0.004), (bar / 2 + FIT.sliding, far + 0.004), (top - 0.001, low + thick)
        ),
    ]
    shelf = ag.cylinder(far + 0.005, 0.004, bevel=0.0005).at(z=top - 0.0005)
    body = ag.weld(
        ag.part(belly | neck | shelf, "body", heavy),
        ag.part(ends, "body", heavy, separate="ends of the body"),
        ag.part([each.box(bevel=0.0005) for each in stops], "plate", heavy, separate="stops on the body"),
        _round_words((f"DN{dn} PN25",), 0.428 * wide, middle, metal),
    )
    if grip == "tee":
        half = 0.30 * reach + 0.006
        hub = ag.Region((-bar / 2, bar / 2), (-bar / 2, bar / 2), (low, low + 0.016)).box(bevel=0.001)
        wing = ag.Region((-0.0065, 0.0065), (-half, half), (low + 0.012, low + 0.030)).box(bevel=0.005)
        hold = ag.grasp_on(wing, approach=-ag.Z, closing=ag.X, depth=0.014)
        lever = ag.weld(ag.part(wing, "grip", color, name="lever", grasp=hold), ag.part(hub, "lever", color))
    else:
        flat = ag.Region((-bar / 2, bar / 2), (-0.26 * reach, bar / 2), (low, low + thick)).box(bevel=0.0006)
        crank = ag.hull(
            ag.box(bar, 0.003, thick).at(0, -0.25 * reach, low + thick / 2),
            ag.box(bar, 0.003, thick).at(0, -0.42 * reach, low + 0.012 + thick / 2),
        )
        tip = ag.Region((-bar / 2, bar / 2), (-reach, -0.41 * reach), (low + 0.012, low + 0.012 + thick)).box(
            bevel=0.0006
        )
        sleeve = ag.Region(
            (-bar / 2 - 0.0022, bar / 2 + 0.0022),
            (-reach - 0.004, -0.45 * reach),
            (low + 0.0085, low + 0.0185),
        ).box(bevel=0.0035)
        hold = ag.grasp_on(sleeve, approach=-ag.Z, closing=ag.X, depth=0.0085)
        lever = ag.weld(
            ag.part(sleeve, "grip", color, name="lever", grasp=hold),
            ag.part(
                ag.union(flat, crank, tip),
                "lever",
                ag.material("zinc").with_(name="zinc_plated_lever", density=7850.0),
            ),
        )
    nut = ag.extrude(ag.regular_polygon(6, 0.0055 + 0.03 * wide), 0.005, bevel=0.0006).at(
        z=low + (0.032 if grip == "tee" else thick + 0.002)
    )
    lever = ag.weld(lever, ag.detail(nut, "nut", _STEEL))
    run = torque * (0.6 if grip == "tee" else 0.10 * dn)
    drag = feel.Feel(friction=run, damping=0.15, armature=0.002, effort=run + 0.5 * _RIM * reach)
    turn = ag.Revolute("lever_turn", axis=ag.Z, limits=(0, math.pi / 2), feel=drag)
    return body.attach(lever, turn)


def _round_words(words: tuple[str, ...], radius: float, middle: float, metal: ag.Material) -> ag.Body:
    """Print lines with size and pressure on the round front of a body."""
    wall = ag.line((radius, 0, -0.1), (radius, 0, 0.1))
    lines = details.lettering(words, 0.09 * radius + 0.001).rotate(math.pi / 2)
    mark = details.wrapped(lines, wall, 0.0, material=controls.ink_on(metal))
    return mark.rotate(ag.Y, math.pi / 2).at(z=middle)


def _upright_words(
    words: str, radius: float, tall: float, z: float, paint: ag.Material, *, ball: bool
) -> ag.Body:
    """Print a line at a height of the front of a ball or a neck about z."""
    neck = ag.line((radius, 0, -0.1), (radius, 0, 0.1))
    outline = ag.arc((0, 0, 0), radius, start=-1.0, sweep=2.0, axis=-ag.Y) if ball else neck
    lines = details.lettering((words,), tall)
    return details.wrapped(lines, outline, 0.0, material=controls.ink_on(paint)).at(z=z)


def _neck(dn: int, top: float, high: float, paint: ag.Material) -> ag.Body:
    """Make the bolted bonnet above a body, with a hole for the stem."""
    wide, hole, play = dn / 1000 + 0.062, 2 * (_stem(dn) + FIT.running), 0.0003
    plan = ag.Region.centered(wide, 0.8 * wide, 1.0)
    lower = plan.with_(z=(top, top + 0.013 - play)).box(bevel=0.0012)
    tower = ag.frustum(0.40 * wide, 0.020 + 0.05 * dn / 1000, high - 0.024).at(
        z=top + 0.024 + (high - 0.024) / 2
    )
    made = ag.union(tower, plan.with_(z=(top + 0.013, top + 0.026)).box(bevel=0.0012))
    made -= ag.box(hole, hole, high + 0.1).at(z=top + 0.008 + high / 2 + 0.05)
    heads = [
        ag.extrude(ag.regular_polygon(6, 0.0095), 0.008).at(x, y, top + 0.030)
        for x in (-0.40 * wide, 0.40 * wide)
        for y in (-0.31 * wide, 0.31 * wide)
    ]
    return ag.weld(
        ag.part(lower, "neck", _cast(paint, 1.0)),
        ag.part(made, "neck", _cast(paint, 0.6), separate="a gasket lies between the flanges"),
        ag.detail(heads, "bolt", ag.material("zinc")),
    )


def _stem(dn: int) -> float:
    """Return the radius of a stem [m]."""
    return 0.005 + 0.06 * dn / 1000


def _gate(
    dn: int, spokes: int, torque: ag.Scalar, paint: ag.Material, color: ag.Material, maker: str
) -> ag.Body:
    """Make a gate valve with a yoke: its wheel turns in the yoke and draws the stem up."""
    body, middle = _flanged(dn, _GATE[dn], paint)
    size, pitch = dn / 1000, 0.005
    top = middle + 0.5 * size + 0.028
    room = ag.Region.centered(0.9 * size + 0.036, 0.5 * size + 0.034, 1.0)
    belly = room.with_(z=(middle - 0.5 * size - 0.014, top + 0.001)).box(bevel=0.006)
    high = size + 0.055  # of the bonnet
    crown = top + high + 0.075  # height of the yoke
    posts = []
    for side in (-1, 1):
        foot, head = (side * 0.030, 0.0, top + high - 0.020), (side * 0.024, 0.0, crown - 0.006)
        posts.append(ag.cylinder_between(foot, head, 0.0075))
    hole = 2 * (_stem(dn) + FIT.running)
    bridge = ag.box(0.066, 0.034, 0.016, bevel=0.0012).at(z=crown - 0.008) - ag.box(hole, hole, 0.2).at(
        z=crown
    )
    gland = ag.cylinder(0.034, 0.010, bevel=0.001).at(z=top + high - 0.020)
    gland -= ag.box(hole, hole, 0.2).at(z=top + high)
    body = ag.weld(
        body,
        ag.part(belly, "body", _cast(paint, 0.55)),
        _neck(dn, top, high, paint),
        ag.part([ag.union(bridge, *posts), gland], "neck", _cast(paint, 1.0)),
        _words((f"DN{dn}", "PN16"), 0.012, (0, -0.25 * size - 0.017, middle + 0.002), paint),
        _words((maker.upper(),), 0.008, (0, -0.25 * size - 0.017, middle - 0.3 * size - 0.006), paint),
    )
    diameter = _WHEEL[dn]
    wheel = _wheel(diameter, spokes, color, bore=_stem(dn) + 0.0014)
    drag = feel.Feel(friction=torque * dn / 20, damping=0.1, armature=0.01, effort=0.5 * _RIM * diameter)
    turn = ag.Revolute("wheel_turn", axis=ag.Z, limits=(0, math.tau * size / pitch), feel=drag)
    rise = ag.Prismatic("stem_rise", axis=ag.Z, follows=pitch / math.tau * turn, armature=1.0)
    start, end = top + 0.022, crown + 0.052
    stem = ag.cylinder_between((0, 0, start), (0, 0, end), _stem(dn))
    thread = ag.sweep(ag.circle(0.0010), ag.helix(_stem(dn) - 0.0004, pitch, 12)).at(z=end - 0.036)
    screw = ag.weld(ag.part(stem, "stem", _STEEL), ag.detail(thread, "stem", _STEEL))
    return body.attach(wheel, turn, at=(0, 0, crown + 0.0116)).attach(screw, rise)


def _globe(
    dn: int, spokes: int, torque: ag.Scalar, paint: ag.Material, color: ag.Material, maker: str
) -> ag.Body:
    """Make a globe valve: its wheel rises with the stem."""
    body, middle = _flanged(dn, _GLOBE[dn], paint)
    size, pitch = dn / 1000, 0.004
    radius = 0.75 * size + 0.016
    top = middle + 0.62 * size + 0.030
    ball = ag.sphere(radius).at(z=middle)
    collar = ag.cylinder(0.55 * size + 0.016, top - middle + 0.001).at(z=(top + middle + 0.001) / 2)
    high = 0.3 * size + 0.062
    body = ag.weld(
        body,
        ag.part(ball | collar, "body", _cast(paint, 0.5)),
        _neck(dn, top, high, paint),
        _upright_words(f"DN{dn} PN16", radius, 0.09 * radius + 0.001, middle, paint, ball=True),
        details.printed(
            details.logo(maker, 0.005 + 0.03 * size),
            (0, -0.4 * (size + 0.062), top + 0.0065),
            material=controls.ink_on(paint),
        ),
    )
    diameter, lift = _WHEEL[dn], size / 4
    level = top + high + 0.020  # height of the wheel over its stem
    stem = ag.cylinder_between((0, 0, top + 0.020), (0, 0, level), _stem(dn))
    wheel = ag.weld(_wheel(diameter, spokes, color).at(z=level), ag.part(stem, "stem", _STEEL))
    nut = ag.extrude(ag.regular_polygon(6, 0.009), 0.007, bevel=0.0008).at(z=level + 0.0144)
    drag = feel.Feel(friction=torque * dn / 20, damping=0.1, armature=0.02, effort=0.5 * _RIM * diameter)
    turn = ag.Screw("wheel_turn", pitch=pitch, axis=ag.Z, limits=(0, math.tau * lift / pitch), feel=drag)
    return body.attach(ag.weld(wheel, ag.detail(nut, "nut", _STEEL)), turn)


def _butterfly(dn: int, torque: ag.Scalar, paint: ag.Material, color: ag.Material, maker: str) -> ag.Body:
    """Make a butterfly valve between flanges: its lever stands in ten notches of a plate."""
    size, long = dn / 1000, _BUTTERFLY[dn]
    outer = _FLANGE[dn][1] / 2 - 0.012
    middle = max(outer, 0.25 * math.sqrt(2.0) * _FLANGE[dn][1] + 0.015)  # it stands on its lugs
    ring = ag.tube(outer, size / 2, long, axis=ag.X, bevel=0.002).at(z=middle)
    lining = ag.tube(size / 2 + 0.006, size / 2, 0.0012, axis=ag.X)
    seals = [lining.at(side * (long / 2 + 0.0003), 0, middle) for side in (-1, 1)]
    lugs, holes = [], []
    for x, z in _ring(0.5 * _FLANGE[dn][1], 4):
        lugs.append(ag.cylinder(0.015, 0.8 * long, axis=ag.X, bevel=0.001).at(0, x, middle + z))
        holes.append(ag.cylinder(0.009, 0.8 * long + 0.0004, axis=ag.X).at(0, x, middle + z))
    top = middle + outer + 0.055 + 0.2 * size  # face of the plate
    hole = 2 * (_stem(dn) + FIT.running)
    neck_radius = 0.017 + 0.05 * size
    neck = ag.cylinder(neck_radius, top - middle - outer + 0.010).at(z=(top + middle + outer - 0.010) / 2)
    shaft_way = ag.box(hole, hole, 0.5).at(z=middle + size / 2 + 0.25 - 0.006)
    reach = 0.130 + 1.15 * size
    plate = ag.cylinder(0.050, 0.005, bevel=0.0006).at(z=top + 0.0020)
    teeth = [
        ag.box(0.0026, 0.010, 0.0003).at(0, -0.0450, top + 0.00455).rotate(ag.Z, math.pi / 18 * at)
        for at in range(10)
    ]
    iron = _cast(paint, 0.85)
    body = ag.weld(
        ag.part(ag.union(ring, neck) - shaft_way, "body", iron),
        ag.part(lugs, "flange", iron, separate="lugs cast with the body"),
        ag.detail(seals, "body", ag.material("rubber")),
        ag.detail(holes, "bolt", finish.recess(paint)),
        ag.part(plate - shaft_way, "plate", _STEEL),
        ag.detail(teeth, "plate", ag.material("black_abs")),
        _round_words((f"DN{dn}", "PN16"), outer, middle, paint),
        _upright_words(
            maker.upper(),
            neck_radius,
            0.09 * neck_radius + 0.001,
            (top + middle + outer) / 2,
            paint,
            ball=False,
        ),
    )
    disc = ag.cylinder(size / 2 - 0.0022, 0.006, axis=ag.X, bevel=0.0015).at(z=middle)
    low = top + 0.0062
    shaft = ag.cylinder_between((0, 0, middle), (0, 0, low + 0.012), _stem(dn))
    hub = ag.box(0.030, 0.034, 0.016, bevel=0.002).at(z=low + 0.008)
    bar = ag.Region((-0.011, 0.011), (-reach, 0.010), (low + 0.004, low + 0.011)).box(bevel=0.001)
    grip = ag.Region((-0.0145, 0.0145), (-reach - 0.004, -0.45 * reach), (low - 0.003, low + 0.018)).box(
        bevel=0.006
    )
    hold = ag.grasp_on(grip, approach=-ag.Z, closing=ag.X, depth=0.018)
    lever = ag.weld(
        ag.part(grip, "grip", color, name="lever", grasp=hold),
        ag.part(hub | bar, "lever", color.with_(name=f"{color.name}_lever", density=2700.0)),
        ag.part(disc, "stem", _STEEL),
        ag.part(shaft, "stem", _STEEL),
    )
    run = torque * 0.07 * dn
    clicks = feel.detents(tuple(math.pi / 18 * at for at in range(10)), 0.4 * run)
    drag = feel.Feel(friction=0.6 * run, damping=0.2, armature=0.005, effort=run + 0.5 * _RIM * reach)
    turn = ag.Revolute("lever_turn", axis=ag.Z, limits=(0, math.pi / 2), detents=clicks, feel=drag)
    return body.attach(lever, turn)


def _panel(
    dn: int, knobs: int, torque: ag.Scalar, metal: ag.Material, color: ag.Material, maker: str
) -> ag.Body:
    """Make needle valves side by side in a panel that stands, with the ends of their tubes behind it."""
    pitch, thick, level = 0.062, 0.003, 0.085
    wide = pitch * knobs + 0.030
    sheet = ag.Region.centered(wide, 0.0, 1.0).with_(y=(0, thick), z=(0.004, level + 0.055)).box(bevel=0.0008)
    foot = ag.Region.centered(wide, 0.0, 1.0).with_(y=(-0.030, 0.070), z=(0, 0.005)).box(bevel=0.001)
    grey = ag.material("powder_coat_graphite").with_(name="panel_paint", density=2700.0)
    body = ag.weld(ag.part(sheet, "panel", grey), ag.part(foot, "foot", grey))
    play = 0.0030 + FIT.running
    for at in range(knobs):
        x = (at - (knobs - 1) / 2) * pitch
        block = ag.box(0.026, 0.030, 0.026, bevel=0.0015).at(x, thick + 0.015 - 0.0005, level)
        tubes = [ag.cylinder(dn / 2000, 0.046).at(x, thick + 0.015, level + side * 0.033) for side in (-1, 1)]
        caps = [
            ag.extrude(ag.regular_polygon(6, 0.0095), 0.012, bevel=0.0006).at(
                x, thick + 0.015, level + side * 0.019
            )
            for side in (-1, 1)
        ]
        nut = ag.extrude(ag.regular_polygon(6, 0.0115), 0.0065, axis=ag.Y, bevel=0.0006).at(
            x, -0.00325 + 0.0004, level
        )
        hole = ag.Region((x - play, x + play), (-0.02, thick + 0.012), (level - play, level + play)).box()
        body = ag.weld(
            body,
            ag.part(ag.union(block, *tubes, *caps), "body", metal),
            ag.part(nut, "nut", metal),
            details.printed(
                details.lettering((f"{at + 1}",), 0.006), (x, 0, level + 0.030), material=controls.LIGHT_INK
            ),
        ).cut(hole)
        shaft = ag.cylinder_between((x, -0.020, level), (x, 0.011, level), 0.0030)
        grip = ag.cylinder(0.0135, 0.017, axis=ag.Y, bevel=0.0015).at(x, -0.0235, level)
        flutes = ag.array(
            ag.cylinder(0.0011, 0.013, axis=ag.Y),
            at=ag.ring_points((x, -0.0235, level), 0.0135, count=24, axis=ag.Y),
        )
        hold = ag.grasp_on(grip, approach=ag.Y, closing=ag.X, depth=0.014)
        knob = ag.weld(
            ag.part(grip, "knob", color.with_(name=f"{color.name}_knob"), name=f"knob_{at}", grasp=hold),
            ag.part(shaft, "stem", _STEEL),
            ag.detail(flutes, "knob", color),
        )
        pivot = (x, 0, level)
        drag = feel.Feel(friction=0.08 * torque, damping=0.005, armature=2e-4, effort=1.5)
        turn = ag.Screw(
            f"knob_turn_{at}", pitch=0.0009, axis=-ag.Y, pivot=pivot, limits=(0, math.tau * 4), feel=drag
        )
        body = body.attach(knob, turn)
    mark = details.printed(details.logo(maker, 0.005), (0, 0, 0.028), material=controls.LIGHT_INK)
    return ag.weld(body, mark)
