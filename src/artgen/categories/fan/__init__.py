"""A fan: on a desk, on a pole, in a box, or on a clip.

Links: `base` of all; `pole`, which is drawn out; `jaw` of a clip; `neck`, `head` and `blades`; `button_0` and
so on, or `dial`; `knob`, the clutch of the swing. Joints: `blades_spin`; `head_swing` and `head_tilt`;
`pole_slide`; `jaw_turn`; `button_slide_0` and so on, or `dial_turn`; `knob_pull`.

The motor turns the blades. The head swings by hand against the friction of its gear, which is not modeled:
nothing couples the swing to the blades. Friction holds tilt and height; a dial clicks from speed to speed.

Sizes are those of shops: desk fans of 300-400 mm across the blades weigh 2-4 kg; pedestal fans of 400-450 mm
are 1.0-1.35 m high and weigh 3.5-7 kg; box fans of 20 in are 520-550 mm wide, 110-130 mm deep and weigh
3-5.5 kg; clip fans of 150-200 mm weigh 0.5-1.2 kg. Blades turn with 700-1400/min, heads swing by
80-90 degrees. Friction holds heads with 1.2 times their weight; keys take 2-4 N, detents of speed
switches 0.04-0.06 N m (catalogs of rotary switches).
"""

import math
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details, feel, signals
from artgen.categories.shared import controls
from artgen.categories.shared.finish import casting, colors
from artgen.nodes.fitting import FIT, Fitting

Style = Literal["desk", "pedestal", "box", "clip"]
"""A fan on a base, on a pole of variable height, in a square frame, or on a clip."""

Panel = Literal["buttons", "dial"]
"""Keys for the speeds, or a dial that clicks."""

_WIRE = 0.0011  # radius of the other wires [m]
_CHEEK = 0.0065  # thickness of the cheeks of the neck [m]
_HINGE = 0.0115  # radius of the hinge of the tilt [m]
_COLUMN = 0.0125  # radius of the column below the neck [m]
_ROD = 0.0032  # thickness of the rods of a guard [m]
_RODS = 12  # at each side
_SIGNS = ("0", "1", "2", "3")
_MOTOR = feel.Feel(damping=2e-4, friction=0.01, armature=2e-4, effort=0.5, velocity=140.0)
_SWING = feel.Feel(friction=0.12, damping=0.05, armature=1e-3, effort=6.0)
_KNOB = feel.Feel(friction=0.5, damping=2.0, armature=0.02, effort=25.0)
_CLIP = feel.Feel(damping=0.02, friction=0.02, armature=5e-4, effort=6.0)

_SHELLS = ag.choice(
    *colors("abs", "white black light_grey mint sky cream red"), weights=(4, 3, 1.5, 1, 1, 1, 1)
)
_BLADES = ag.choice(
    *colors("polypropylene", "white black sky grey"), "brushed_aluminium", weights=(3, 2, 1.5, 1.5, 1.5)
)
_WIRES = ag.choice("chrome", ag.colored("powder_coat", "white"), "powder_coat_black", weights=(2, 2, 2))
_BLACK = ag.material("black_abs")
_RUBBER = ag.material("rubber")


_Rotor = tuple[int, ag.Scalar, ag.Scalar, ag.Material]
"""Number of blades, their angle [rad], their width over their share of a turn, and material."""


@dataclass(frozen=True)
class _Head:
    """Measures of a head, the axis of its blades along y through the origin."""

    radius: ag.Scalar  # of the guard [m]

    @property
    def front(self) -> ag.Scalar:
        """Return the reach of the guard before the middle of the blades [m]."""
        return 0.018 + 0.20 * self.radius

    @property
    def rear(self) -> ag.Scalar:
        """Return the reach of the guard behind the middle of the blades [m]."""
        return 0.016 + 0.15 * self.radius

    @property
    def motor(self) -> ag.Scalar:
        """Return the radius of the motor [m]."""
        return 0.022 + 0.16 * self.radius

    @property
    def long(self) -> ag.Scalar:
        """Return the length of the motor [m]."""
        return 0.040 + 0.40 * self.radius

    @property
    def pivot(self) -> tuple[float, ag.Scalar, ag.Scalar]:
        """Return a point on the axis of the tilt."""
        return (0.0, self.rear + 0.80 * self.long, -self.motor - _HINGE - 0.001)

    @property
    def low(self) -> ag.Scalar:
        """Return the drop of the guard below the axis of the tilt when it is tilted down [m]."""
        _, y, z = self.pivot
        return 0.96 * (self.radius + z) + 0.30 * (self.front + y)


@ag.category(
    labels="base foot pole collar jaw neck motor guard badge blade hub knob button dial panel handle print",
    joints=(2, 9),
)
def fan(
    *,
    style: Style = ag.choice({"desk": 0.32, "pedestal": 0.28, "box": 0.2, "clip": 0.2}),
    panel: Panel = ag.by("style", desk={"buttons": 0.55, "dial": 0.45}, pedestal="buttons", otherwise="dial"),
    size: ag.Float = ag.by(
        "style",
        desk=ag.uniform(0.31, 0.41),
        pedestal=ag.uniform(0.42, 0.47),
        box=ag.uniform(0.52, 0.55),
        clip=ag.uniform(0.165, 0.205),
        unit="m",
        within=(0.16, 0.56),
        doc="width of the guard",
    ),
    blades: int = ag.choice({3: 0.4, 4: 0.25, 5: 0.35}),
    pitch: ag.Float = ag.uniform(0.38, 0.55, "rad", within=(0.2, 0.7), doc="angle of the blades"),
    broad: ag.Float = ag.uniform(
        0.75, 0.95, within=(0.5, 1.0), doc="width of a blade over its share of a turn"
    ),
    swing: ag.Float = ag.uniform(0.65, 0.80, "rad", within=(0.3, 0.9), doc="swing of the head to each side"),
    tilt: ag.Float = ag.uniform(0.20, 0.30, "rad", within=(0.1, 0.3), doc="tilt of the head up and down"),
    rise: ag.Float = ag.uniform(0.22, 0.32, "m", within=(0.1, 0.34), doc="range of the height of a pole"),
    wires: int = ag.choice({36: 1, 48: 1, 60: 1}, doc="wires of the guard at each side"),
    foot: Literal["disc", "cross"] = ag.by("style", pedestal={"disc": 0.6, "cross": 0.4}, otherwise="disc"),
    shell: ag.Material = _SHELLS,
    blade: ag.Material = _BLADES,
    wire: ag.Material = _WIRES,
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a fan that stands still and looks straight ahead."""
    rotor = (blades, pitch, broad, blade)
    if style == "box":
        return _blowing(_box(size, rotor, shell, maker), "dial")
    least = {"desk": 0.2, "pedestal": 0.26, "clip": 0.16}[style]
    size = ag.require(size, size >= least, f"size of a {style} fan must be >= {least:g} m")
    plan = _Head(size / 2)
    head = _head(plan, rotor, wires, shell, wire, maker, swings=style != "clip")
    neck = _neck(plan, shell)
    center = head.center_of_mass()
    hold = 1.2 * head.weight() * (abs(center.y) + 0.3 * abs(center.z))
    lean = ag.Revolute(
        "head_tilt", axis=-ag.X, limits=(-tilt, tilt), friction=hold, damping=0.05, effort=2.5 * hold + 2.0
    )
    neck = neck.attach(head, lean, at=(0, 0, _RAISED))
    turn = ag.Revolute("head_swing", axis=ag.Z, limits=(-swing, swing), feel=_SWING)
    match style:
        case "desk":
            return _blowing(_desk(plan, panel, neck, turn, shell), panel)
        case "pedestal":
            return _blowing(_pedestal(plan, rise, foot, neck, turn, shell, maker), panel)
        case _:
            return _blowing(_clip(plan, neck, turn, shell), "dial")


def _blowing(body: ag.Body, panel: Panel) -> ag.Body:
    """Let the keys or the dial set the speed of the motor."""
    if panel == "dial":
        speed = signals.level("dial_turn")
    else:
        keys = [signals.pressed(f"button_slide_{index}") for index in range(len(_SIGNS))]
        speed = signals.latest(keys, (0.0, 0.55, 0.78, 1.0))
    return body.output("blow", speed, kind="motor", moves="blades_spin", speed=_MOTOR.velocity)


_RAISED = 0.034  # height of the axis of the tilt above the foot of the neck [m]


def _blades(radius: ag.Scalar, deep: ag.Scalar, rotor: _Rotor) -> ag.Body:
    """Make the blades with their hub about the y axis."""
    count, pitch, broad, finish = rotor
    hub = 0.016 + 0.10 * radius
    boss = ag.cylinder(hub, 1.2 * deep, axis=ag.Y, bevel=0.003).at(y=-0.1 * deep)
    cone = ag.dome(hub - 0.002, height=0.5 * deep, axis=-ag.Y).at(y=-0.7 * deep)
    # shares of the chord, and greatest half of the chord in radii, from the hub to the tip
    shares = ((0.60, 1.0), (1.0, 0.52), (0.85, 0.35))
    heights = [0.9 * hub, 0.64 * radius, 0.93 * radius]
    sections = []
    for (wide, most), height in zip(shares, heights, strict=True):
        half = broad * wide * math.pi / count * (0.42 * radius + 0.30 * height)
        # it fits between the sides of the guard
        half = ag.min_(ag.min_(half, most * radius), deep / ag.sin(pitch))
        outline = [(1, 0), (0.95, -0.02), (-0.95, -0.02), (-1, 0), (-0.45, 0.06), (0.45, 0.06)]
        sections.append(ag.polygon(outline).scale(half).rotate(pitch))
    # the profile of a section is x, y at the height z; its y runs against the air, along -y
    blade = ag.loft(sections, heights)
    made = [blade.rotate(ag.Y, math.tau * index / count) for index in range(count)]
    light = finish if finish.density < 2000.0 else casting(finish, 0.4)
    return ag.weld(
        ag.part([boss, *made], "blade", light, name="blades", separate="the hub carries the blades"),
        ag.detail(cone, "hub", finish),
    )


def _spin() -> ag.Joint:
    return ag.Revolute("blades_spin", axis=ag.Y, feel=_MOTOR, driven="the motor")


def _grille(
    radius: ag.Scalar, inner: ag.Scalar, y: ag.Scalar, wire: ag.Material, count: int, brim: ag.Scalar
) -> list[ag.Body]:
    """Make one side of the guard: rods from a plate to the rim; panes between them are its colliders."""
    plate = ag.cylinder(inner, 0.0024, axis=ag.Y, bevel=0.0006)
    knot, thinner = ag.box(_ROD, _ROD, _ROD), ag.box(0.0026, 0.0026, 0.0026)
    bend, end = knot.at(z=radius - 0.012), knot.at(0, brim, radius - 0.003)
    face, side = ag.hull(thinner.at(z=0.7 * inner), thinner.at(z=radius - 0.012)), ag.hull(bend, end)
    pane = ag.hull(side, side.rotate(ag.Y, math.tau / _RODS))
    faces, sides, panes = (
        [each.rotate(ag.Y, math.tau * step / _RODS) for step in range(_RODS)] for each in (face, side, pane)
    )
    covered = ag.bounding_collider(ag.union(plate, *faces, *sides), ag.hull(*faces), *panes)
    way = ag.polyline([(0, 0, 0.8 * inner), (0, 0, radius - 0.012), (0, brim, radius - 0.003)], fillet=0.008)
    thin = ag.sweep(ag.regular_polygon(4, _WIRE), way)
    wires = [thin.rotate(ag.Y, math.tau * step / count) for step in range(count)]
    rings = [
        ag.revolve(ag.rectangle(0.002, 0.002).at(inner + share * (radius - 0.0125 - inner)), axis=ag.Y)
        for share in (0.34, 0.68, 1.0)
    ]
    return [
        ag.part(covered, "guard", casting(wire, 0.4)).at(y=y),
        ag.detail([*wires, *rings], "guard", wire).at(y=y),
    ]


def _head(
    plan: _Head, rotor: _Rotor, wires: int, shell: ag.Material, wire: ag.Material, maker: str, *, swings: bool
) -> ag.Body:
    """Make the motor with its guard and its blades, the axis of its tilt through the origin."""
    radius, rear = plan.radius, plan.rear
    band = ag.rectangle(0.004, 0.012).at(radius - 0.002)
    ring = ag.revolve(band, axis=ag.Y, sides=2 * _RODS)
    inner = 0.24 * radius
    front = _grille(radius, inner, -plan.front, wire, wires, plan.front - 0.004)
    back = _grille(radius, plan.motor + 0.004, rear, wire, wires, 0.004 - rear)
    housing = ag.cylinder(plan.motor, plan.long, axis=ag.Y, bevel=0.0012).at(y=rear + plan.long / 2)
    tail = ag.frustum(0.75 * plan.motor, 0.017, 0.030, axis=ag.Y, bevel=0.0016).at(
        y=rear + plan.long + 0.0145
    )
    grip = ag.cylinder(0.0165, 0.028, axis=ag.Y, bevel=0.0016).at(y=rear + plan.long + 0.042)
    _, y, z = plan.pivot
    lug = ag.cylinder(_HINGE, 0.020, axis=ag.X, bevel=0.001).at(0, y, z)
    stem = ag.box(0.020, 1.6 * _HINGE, -z).at(0, y, z / 2)
    hold = ag.grasp_on(grip, approach=-ag.Y, closing=ag.X, depth=0.020)
    heavy = shell.with_(name=f"{shell.name}_motor", density=660.0)
    head = ag.weld(
        ag.part(ag.union(housing, tail, grip, lug, stem), "motor", heavy, name="head", grasp=hold),
        ag.part(ring, "guard", casting(wire, 0.4)),
        ag.detail(ag.revolve(band.offset(0.0004), axis=ag.Y), "guard", wire),
        *front,
        *back,
        ag.detail(
            ag.cylinder(0.92 * inner, 0.003, axis=ag.Y, bevel=0.001).at(y=-plan.front - 0.0030),
            "badge",
            shell,
        ),
        details.printed(
            details.logo(maker, 0.14 * inner), (0, -plan.front - 0.0045, 0), material=controls.ink_on(shell)
        ),
    )
    if swings:
        head = head.install(_clutch(), at=(0, rear + 0.55 * plan.long, plan.motor))
    rotor_ = _blades(0.87 * radius, 0.30 * (plan.front + rear - 0.012), rotor)
    return head.attach(rotor_, _spin()).at(0, -y, -z)


def _clutch() -> Fitting:
    """Make the knob on a motor that is pressed to let the head swing; it snaps up or down."""
    travel = 0.009
    stem = ag.cylinder(0.0040, 0.030).at(z=0.0)
    cap = ag.cylinder(0.0095, 0.014, bevel=0.002).at(z=0.0195)
    hold = ag.grasp_on(cap, approach=-ag.Z, closing=ag.X, depth=0.011)
    knob = ag.part(stem | cap, "knob", _BLACK, grasp=hold)
    ends = feel.detents((-0.1 * travel, 1.1 * travel), 6.0)
    pull = ag.Prismatic("knob_pull", axis=ag.Z, limits=(0, travel), detents=ends, feel=_KNOB)
    return Fitting.moving(knob, pull, cut=ag.box(0.0095, 0.0095, 0.05))


def _neck(plan: _Head, shell: ag.Material) -> ag.Body:
    """Make the neck with its cheeks beside the hinge of the head; its foot is the origin."""
    disc = ag.cylinder(0.0230, 0.012, bevel=0.002).at(z=0.006)
    inner = 0.010 + FIT.running
    cheek = ag.cylinder(_HINGE, _CHEEK, axis=ag.X, bevel=0.001).at(z=_RAISED)
    cheek |= ag.box(_CHEEK, 1.7 * _HINGE, _RAISED - 0.008).at(z=0.008 + (_RAISED - 0.008) / 2)
    cheeks = [cheek.at(side * (inner + _CHEEK / 2)) for side in (-1, 1)]
    return ag.part(
        ag.union(disc, *cheeks), "neck", shell.with_(name=f"{shell.name}_neck", density=1100.0), name="neck"
    )


def _foot(radius: ag.Scalar, shell: ag.Material, density: float = 1100.0) -> ag.Body:
    """Make a round base with rubber below it."""
    plate = ag.cylinder(radius, 0.016, bevel=0.005).at(z=0.010)
    heavy = shell.with_(name=f"{shell.name}_base", density=density)
    return ag.weld(
        ag.part(plate, "base", heavy, name="base"),
        ag.part(ag.cylinder(0.92 * radius, 0.003, bevel=0.0005).at(z=0.0015), "foot", _RUBBER),
    )


def _console(
    body: ag.Body, panel: Panel, at: tuple[ag.Scalar, ag.Scalar, ag.Scalar], shell: ag.Material
) -> ag.Body:
    """Add keys in a row or a dial to a front at a place, with their print."""
    ink = controls.ink_on(shell)
    if panel == "dial":
        return body.install(_dial(shell), at=at)
    dark = _BLACK if sum(shell.base_color) > 0.6 else ag.colored("abs", "light_grey")
    for index, x in enumerate(controls.places(4, 0.0195)):
        key = controls.push_button(
            finish=dark,
            through=0.014,
            shape="square",
            width=0.014,
            proud=0.006,
            travel=0.004,
            preload=0.8,
            icon=details.lettering((_SIGNS[index],), 0.0065),
            ink=controls.ink_on(dark),
        )
        body = body.install(key.suffixed(f"_{index}"), at=(at[0] + x, at[1], at[2]))
    word = details.printed(details.lettering(("SPEED",), 0.0034, tracking=0.2), (0, 0, 0.0130), material=ink)
    return ag.weld(body, word.at(*at))


def _dial(shell: ag.Material, radius: float = 0.0165) -> Fitting:
    """Make the dial of the speeds, which clicks at each of them."""
    clicks = (0.0, 0.7, 1.4, 2.1)
    detents = feel.detents(clicks, 0.05)
    turn = ag.Revolute(
        "dial_turn", axis=ag.Y, limits=(0, 2.1), feel=feel.DIAL, friction=0.012, detents=detents
    )
    scale = details.dial_scale(
        radius + 0.002, 4, sweep=2.1, start=0.0, numbers=_SIGNS, number_height=0.0042, length=0.002
    )
    film = details.printed(scale, material=controls.ink_on(shell))
    finish = _BLACK if sum(shell.base_color) > 0.6 else ag.colored("abs", "light_grey")
    return controls.dial(turn, "bar", radius, finish, depth=0.019, scale=film)


def _desk(plan: _Head, panel: Panel, neck: ag.Body, turn: ag.Joint, shell: ag.Material) -> ag.Body:
    """Make the base of a desk fan: a disc, a console on it, and a column behind the guard."""
    radius = 0.62 * plan.radius + 0.012
    top = 0.066 + plan.low  # of the column, so that the guard clears the console
    front = -0.22 * plan.radius - radius + 0.008
    room = ag.Region((-0.046, 0.046), (front, front + 0.060), (0.016, 0.062))
    console = ag.part(room.box(bevel=0.006), "panel", shell)
    column = ag.cylinder(_COLUMN, top - _RAISED - 0.016, bevel=0.001).at(z=(top - _RAISED + 0.016) / 2)
    body = ag.weld(_foot(radius, shell).at(y=-0.22 * plan.radius), console)
    body = _console(body, panel, (0, room.y.low, 0.036), shell)
    body = ag.weld(body, ag.part(column, "pole", shell))
    return body.attach(neck, turn, at=(0, 0, top - _RAISED + FIT.running))


def _pedestal(
    plan: _Head, rise: ag.Scalar, foot: str, neck: ag.Body, turn: ag.Joint, shell: ag.Material, maker: str
) -> ag.Body:
    """Make a pole that is drawn out of a tube on a base, with the keys on it."""
    tall, radius, rod = 0.56, 0.0160, 0.0100
    if foot == "disc":
        body = _foot(0.95 * plan.radius, shell, 1300.0)
    else:
        bar = ag.box(2.2 * plan.radius, 0.034, 0.022, bevel=0.006).at(z=0.014)
        cross = ag.union(bar.rotate(ag.Z, math.pi / 4), bar.rotate(ag.Z, -math.pi / 4))
        pads = [
            ag.cylinder(0.012, 0.005).at(way[0] * 0.74 * plan.radius, way[1] * 0.74 * plan.radius, 0.0025)
            for way in ((1, 1), (1, -1), (-1, 1), (-1, -1))
        ]
        body = ag.weld(
            ag.part(cross, "base", shell.with_(name=f"{shell.name}_base", density=2300.0), name="base"),
            ag.part(ag.union(*pads), "foot", _RUBBER, separate="four feet"),
        )
    steel = casting(ag.material("chrome"), 0.3)
    tube = ag.cylinder(radius, tall - 0.014, bevel=0.0008).at(z=(tall + 0.014) / 2)
    collar = ag.cylinder(0.024, 0.044, bevel=0.004).at(z=tall - 0.014)
    hole = ag.bore(rod + FIT.sliding, 0.48).at(z=tall - 0.18)
    body = ag.weld(body, ag.part(tube - hole, "pole", steel), ag.part(collar - hole, "collar", shell))
    start = tall + 0.009  # end of the collar
    drawn = ag.cylinder_between((0, 0, start - 0.40), (0, 0, start + 0.080), rod)
    box = ag.Region((-0.046, 0.046), (-0.036, 0.030), (start + 0.075, start + 0.160))
    top = start + 0.075 + plan.low  # of the shaft above the keys
    shaft = ag.cylinder_between((0, 0, box.z.high - 0.002), (0, 0, top), _COLUMN)
    hold = ag.grasp_on(drawn, approach=ag.Y, closing=ag.X, at=(0, 0, start + 0.045))
    pole = ag.weld(
        ag.part(drawn, "pole", steel, name="pole", grasp=hold),
        ag.part(box.box(bevel=0.008), "panel", casting(shell, 0.5)),
        ag.part(shaft, "pole", steel),
        details.printed(
            details.logo(maker, 0.006), (0, box.y.low, box.z.high - 0.018), material=controls.ink_on(shell)
        ),
    )
    pole = _console(pole, "buttons", (0, box.y.low, box.z.low + 0.030), shell)
    pole = pole.attach(neck, turn, at=(0, 0, top + FIT.running))
    weight = pole.weight()
    lift = ag.Prismatic(
        "pole_slide", axis=ag.Z, limits=(0, rise), friction=1.07 * weight, damping=20.0, effort=3.0 * weight
    )
    return body.attach(pole, lift)


def _clip(plan: _Head, neck: ag.Body, turn: ag.Joint, shell: ag.Material) -> ag.Body:
    """Make a clip: a flat lower jaw that stands on a table, and an upper one with the fan on it."""
    wide, axle = 0.058, 0.026
    floor = ag.Region((-wide / 2, wide / 2), (-0.072, 0.062), (0.0, 0.012))
    ears = [
        ag.cylinder(0.008, 0.006, axis=ag.X, bevel=0.0008).at(x, 0.010, axle)
        | ag.box(0.006, 0.016, axle - 0.008).at(x, 0.010, 0.010 + (axle - 0.008) / 2)
        for x in (-wide / 2 + 0.003, wide / 2 - 0.003)
    ]
    pad = floor.with_(y=(-0.070, -0.044), z=(0.0115, 0.0145)).shrink(x=0.004)
    heavy = shell.with_(name=f"{shell.name}_base", density=1900.0)
    base = ag.weld(
        ag.part(ag.union(floor.box(bevel=0.003), *ears), "base", heavy, name="base"),
        ag.part(pad.box(), "foot", _RUBBER),
    )
    half = wide / 2 - 0.006 - FIT.running
    plate = ag.Region((-half, half), (-0.072, 0.060), (axle, axle + 0.012))
    nose = plate.with_(y=(-0.072, -0.042), z=(0.0152, axle + 0.002))
    barrel = ag.cylinder(0.008, 2 * half, axis=ag.X, bevel=0.0008).at(0, 0.010, axle)
    solid = ag.union(plate.box(bevel=0.003), nose.box(bevel=0.002), barrel)
    press = ag.push_on(solid, direction=-ag.Z, at=(0, 0.050, plate.z.high))
    jaw = ag.part(solid, "jaw", shell, name="jaw", push=press)
    top = plate.z.high + ag.max_(plan.low + 0.012, 0.056)
    column = ag.cylinder_between((0, -0.004, plate.z.high - 0.002), (0, -0.004, top), _COLUMN)
    room = ag.Region((-half, half), (-0.026, 0.022), (plate.z.high - 0.002, plate.z.high + 0.050))
    jaw = ag.weld(jaw, ag.part(column, "pole", shell), ag.part(room.box(bevel=0.006), "panel", shell))
    jaw = jaw.attach(neck, turn, at=(0, -0.004, top + FIT.running))
    jaw = jaw.install(
        _dial(shell, 0.0125).rotate(ag.Z, math.pi / 2), at=(half, room.y.mid, room.z.mid - 0.002)
    )
    spring = ag.Spring(preload=1.2, force=2.4)
    squeeze = ag.Revolute(
        "jaw_turn", axis=-ag.X, pivot=(0, 0.010, axle), limits=(0, 0.22), spring=spring, feel=_CLIP
    )
    return base.attach(jaw, squeeze)


def _box(wide: ag.Scalar, rotor: _Rotor, shell: ag.Material, maker: str) -> ag.Body:
    """Make a box fan: a square frame with bars on both sides, and a dial in its upper corner."""
    deep, band, low = 0.115, 0.028, 0.014
    frame = ag.Region((-wide / 2, wide / 2), (-deep / 2, deep / 2), (low, low + wide + 0.028))
    room = frame.shrink(x=band, z=band).shrink(top=0.028, y=0.0)
    hollow = room.grow(y=0.01)
    light = shell.with_(name=f"{shell.name}_frame", density=420.0)
    body = ag.part(frame.box(bevel=0.006) - hollow.box(), "base", light, name="base")
    feet = [
        ag.Region((x - 0.018, x + 0.018), (-0.085, 0.085), (0.0, low + 0.004)).box(bevel=0.004)
        for x in (-0.38 * wide, 0.38 * wide)
    ]
    grip = ag.Region((-0.060, 0.060), (-0.010, 0.010), (frame.z.high + 0.024, frame.z.high + 0.036))
    posts = [
        grip.with_(x=(x - 0.007, x + 0.007), z=(frame.z.high - 0.004, grip.z.high - 0.002)).shrink(y=0.001)
        for x in (-0.052, 0.052)
    ]
    hold = ag.grasp_on(grip.box(), approach=-ag.Z, closing=ag.Y, depth=0.012)
    carried = ag.part(
        ag.union(grip.box(bevel=0.004), *(post.box() for post in posts)), "handle", shell, grasp=hold
    )
    body = ag.weld(body, ag.part(feet, "foot", shell, separate="two feet"), carried)
    for side in (-1, 1):
        y = side * (deep / 2 - 0.006)
        rows = [
            room.grow(x=0.002).with_(y=(y - 0.002, y + 0.002), z=(z - 0.0016, z + 0.0016)).box()
            for z in (room.z.at(share / 19) for share in range(1, 19))
        ]
        posts_ = [
            room.grow(z=0.002).with_(x=(x - 0.003, x + 0.003), y=(y - 0.0026, y + 0.0026)).box()
            for x in (room.x.at(share) for share in (0.2, 0.5, 0.8))
        ]
        cover = room.grow(x=0.003, z=0.003).with_(y=(y - 0.0028, y + 0.0028)).box()
        body = ag.weld(
            body,
            ag.part(ag.bounding_collider(ag.union(*rows), cover), "guard", shell),
            ag.detail(posts_, "guard", shell),
        )
    disc = ag.cylinder(0.055, 0.004, axis=ag.Y, bevel=0.001)
    badge = ag.detail(disc.at(0, 0.0045 - deep / 2, room.z.mid), "badge", shell)
    name = details.printed(
        details.logo(maker, 0.0085), (0, 0.0024 - deep / 2, room.z.mid), material=controls.ink_on(shell)
    )
    motor = ag.part(
        ag.cylinder(0.046, 0.040, axis=ag.Y, bevel=0.002).at(0, deep / 2 - 0.0265, room.z.mid),
        "motor",
        _BLACK.with_(name="motor_black", density=3200.0),
    )
    body = ag.weld(body, motor, badge, name)
    body = body.attach(_blades(0.46 * room.x.size, 0.019, rotor), _spin(), at=(0, -0.016, room.z.mid))
    return body.install(_dial(shell), at=(wide / 2 - 0.042, frame.y.low, frame.z.high - 0.0285))
