"""A stand mixer: its head tilts up over the bowl, or a crank lowers the bowl below a fixed head.

Links: `base`, `bowl`, `beater`, `knob` of the speed; `head` and `button`, the lock of the head; `crank` and
`carriage`, the arms that carry a bowl. Joints: `head_tilt`, `button_slide`; `crank_turn`, `carriage_slide`;
`bowl_turn`, `bowl_lift`; `beater_spin`; `knob_turn`.

The head tilts only while its lock is off: the bar of a slider, which stays where it is left, is over a foot
of the head. Friction holds the head open, and lets it sink from lower angles. A bowl turns out of the hooks
of its seat, and then it lifts below the open head; a lowered bowl lifts off the pins of its arms. The motor
turns the hub, with the tool beside its axis; the tool does not turn in the hub. The dial clicks from speed
to speed.

Sizes are those of shops and catalogs. Mixers with a tilting head and a bowl of 4.3-4.8 l (KitchenAid
5KSM125 and 5KSM175, Smeg SMF03) are 350-400 mm high and deep and weigh 8.5-12 kg; those of plastic (Bosch
MUM5) 5-7 kg. Mixers that lift a bowl of 5-6.9 l (KitchenAid 5KSM55, 5KSM7580) are 400-430 mm high and weigh
11-14 kg; the bowl is empty.
"""

import math
from typing import Literal

import artgen as ag
from artgen import details, feel, signals
from artgen.categories.shared import controls, vessels
from artgen.categories.shared.finish import casting, colors
from artgen.nodes.fitting import FIT, Fitting

Style = Literal["tilt", "lift"]
"""The head tilts, or a crank moves the bowl."""

Tool = Literal["beater", "whisk", "hook"]
"""A flat beater, a whisk or a dough hook."""

Form = Literal["bullet", "round", "square"]
"""Heads that taper to the front, tubes with round ends, and flat ones with rounded edges."""

_FLOOR = 0.034  # height of the plate below the bowl [m]
_FOOT = 0.012  # height of the foot of a bowl [m]
_DEEP = 0.108  # depth of the column [m]
_WALL = 0.0016  # of a bowl [m]
_NEAR = 0.0032  # distance of a tool from the floor of the bowl [m]
_SIDES = 20  # facets around a bowl, each with a collider for each bend of the wall
_WIDE = (0.092, 0.108)  # width of the column below a head that tilts, and of one that carries a bowl [m]
_BAR = -0.020  # place of the bar of the lock behind the middle of the column [m]
_SLIDE = 0.011  # travel of the lock [m]
_TURN = 0.45  # of a bowl out of its seat [rad]
_AXLE = (0.011, 0.0095)  # height of the hinge of the head above the column, and its radius [m]
_SWEEP = 3.6  # of the dial [rad]
_MOTOR = feel.Feel(damping=2e-3, friction=0.05, armature=2e-3, effort=4.0, velocity=30.0)
_CRANK = feel.Feel(damping=0.05, armature=0.002, effort=8.0)
_FORMS: dict[Form, tuple[tuple[float, float, float], ...]] = {
    "bullet": (
        (0.0, 0.34, 0.36), (0.03, 0.62, 0.68), (0.12, 0.88, 0.93), (0.45, 1.0, 1.0), (0.80, 0.95, 0.94),
        (0.95, 0.77, 0.78), (1.0, 0.56, 0.58),
    ),
    "round": (
        (0.0, 0.36, 0.36), (0.02, 0.64, 0.64), (0.07, 0.89, 0.89), (0.16, 1.0, 1.0), (0.84, 1.0, 1.0),
        (0.95, 0.84, 0.84), (1.0, 0.58, 0.58),
    ),
    "square": (
        (0.0, 0.70, 0.58), (0.015, 0.84, 0.74), (0.05, 0.96, 0.88), (0.14, 1.0, 0.95), (0.75, 1.0, 0.88),
        (0.96, 0.95, 0.78), (1.0, 0.82, 0.66),
    ),
}  # fmt: skip
"""Sections of a head: share of its length, of its half width and of its half height."""

_PAINTS = ag.choice(
    *colors("enamel", "red cream black white sky mint pink navy sage anthracite"),
    weights=(3, 2, 2, 2, 1, 1.5, 1, 1, 1, 1),
)
_BOWLS = ag.shades("chrome", "stainless_blasted", weights=(3, 2), color=0.02)
_STEEL = ag.material("chrome")
_BLACK = ag.material("black_abs")


@ag.category(
    labels="base foot column collar head band hub bowl handle beater dial button crank arm hinge panel cord "
    "print",
    joints=(5, 6),
)
def stand_mixer(
    *,
    style: Style = ag.choice({"tilt": 0.7, "lift": 0.3}),
    form: Form = ag.choice({"bullet": 0.45, "round": 0.3, "square": 0.25}, doc="shape of the head"),
    tool: Tool = ag.choice({"beater": 0.45, "whisk": 0.35, "hook": 0.2}),
    radius: ag.Float = ag.by(
        "style",
        tilt=ag.uniform(0.101, 0.110),
        lift=ag.uniform(0.108, 0.118),
        unit="m",
        within=(0.098, 0.12),
        doc="radius of the rim of the bowl",
    ),
    height: ag.Float = ag.by(
        "style",
        tilt=ag.uniform(0.140, 0.155),
        lift=ag.uniform(0.155, 0.170),
        unit="m",
        within=(0.13, 0.175),
        doc="height of the bowl",
    ),
    slim: ag.Float = ag.uniform(0.050, 0.060, "m", within=(0.048, 0.062), doc="half width of the head"),
    tilt: ag.Float = ag.uniform(0.82, 0.92, "rad", within=(0.80, 0.95), doc="angle of an open head"),
    drop: ag.Float = ag.uniform(0.045, 0.055, "m", within=(0.04, 0.06), doc="travel of a bowl on a crank"),
    speeds: int = ag.choice(5, 7, 11, doc="clicks of the dial"),
    torque: ag.Float = ag.uniform(0.04, 0.09, "N m", doc="greatest torque of the clicks"),
    dial: controls.DialStyle = ag.choice("round", "fluted", "skirted", "capped", "bar"),
    shell: ag.Material = _PAINTS,
    bowl: ag.Material = _BOWLS,
    knob: ag.Material = ag.shades("black_abs", "chrome", "stainless", color=0.03),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a mixer with its head down and its bowl in its place."""
    lifts = style == "lift"
    if lifts:
        height = ag.require(height, height >= 0.15, "height of a bowl that lifts must be >= 0.15 m")
    seat = _FLOOR + (drop if lifts else 0.0)  # foot of the bowl
    rim = seat + height
    back = radius + (0.036 if lifts else 0.012) + _DEEP / 2  # the middle of the column
    top = rim + 0.030
    body = _stand(radius, back, top, shell, lifts=lifts)
    head, middle = _head(form, radius, back, top, rim, slim, shell, maker, lifts=lifts)
    spin = ag.Revolute("beater_spin", axis=ag.Z, feel=_MOTOR, driven="the motor")
    mix = _tool(tool, radius, height)
    switch = _speed(dial, knob, shell, speeds, torque).rotate(ag.Z, -math.pi / 2)
    if lifts:
        body = ag.weld(body, head).attach(mix, spin, at=(0, 0, seat))
        boss = ag.cylinder(0.028, slim, axis=ag.X, bevel=0.002).at(-slim / 2 - 0.006, back - 0.03, middle)
        body = ag.weld(body, ag.part(boss, "panel", casting(shell)))
        body = body.install(switch, at=(-slim - 0.006, back - 0.03, middle))
        return _mixing(_crane(body, radius, height, back, drop, bowl, shell))
    head = head.attach(mix, spin, at=(0, 0, seat))
    side = 0.052
    boss = ag.cylinder(0.027, side, axis=ag.X, bevel=0.002).at(-side / 2, back, 0.54 * top)
    body = ag.weld(body, ag.part(boss, "panel", casting(shell)))
    body = body.install(switch, at=(-side, back, 0.54 * top))
    key, press = _lock(back, top, _WIDE[0])
    body = body.attach(key, press)
    pivot = (0.0, back + 0.042, top + _AXLE[0])
    center = head.center_of_mass()
    arm, up = pivot[1] - center.y, center.z - pivot[2]
    hold = 1.2 * head.weight() * (arm * ag.cos(tilt) - up * ag.sin(tilt))
    swing = ag.Revolute(
        "head_tilt", axis=-ag.X, pivot=pivot, limits=(0, tilt), friction=hold, damping=0.8, effort=40.0,
        velocity=4.0, needs=(press > 0.8 * _SLIDE).beyond(0.004),
    )  # fmt: skip
    body = body.attach(head, swing)
    turn = ag.Revolute("bowl_turn", axis=-ag.Z, limits=(0, _TURN), friction=0.3, damping=0.05, effort=15.0)
    lift = ag.Prismatic(
        "bowl_lift", axis=ag.Z, limits=(0, 0.034), friction=0.3, damping=2.0, effort=80.0,
        needs=((turn > _TURN - 0.04) & (swing > tilt - 0.05)).beyond(_NEAR - 0.0020),
    )  # fmt: skip
    body = body.attach(_bowl(radius, height, bowl), lift, turn, at=(0, 0, _FLOOR + FIT.running))
    return _mixing(body, ~signals.pressed("head_tilt", (0.0, 0.1)))


def _mixing(body: ag.Body, closed: signals.Signal | None = None) -> ag.Body:
    """Let the knob set the speed of the beater, with a head that has to be down."""
    speed = signals.level("knob_turn") if closed is None else signals.level("knob_turn") & closed
    return body.output("mix", speed, kind="motor", moves="beater_spin", speed=_MOTOR.velocity)


def _stand(radius: ag.Scalar, back: ag.Scalar, top: ag.Scalar, shell: ag.Material, *, lifts: bool) -> ag.Body:
    """Make the foot and the column; the axis of the bowl is z."""
    front = ag.cylinder(0.80 * radius, _FLOOR - 0.006, bevel=0.006).at(z=_FLOOR / 2)
    rear = ag.box(0.150, 0.030, _FLOOR - 0.006, bevel=0.006).at(0, back + 0.052, _FLOOR / 2)
    # the plate has one collider: no seam is under the bowl
    heel = ag.extrude(vessels.chamfered(0.150, 0.030, 0.58 * 0.006), _FLOOR - 0.006).at(0, back + 0.052)
    cover = ag.hull(ag.extrude(vessels.around(0.80 * radius), _FLOOR - 0.006), heel).at(z=_FLOOR / 2)
    plate = ag.bounding_collider(ag.hull(front, rear), cover)
    wide, floor = _WIDE[lifts], _FLOOR - 0.010
    sizes = ((wide + 0.036, _DEEP + 0.020, 0.040), (wide, _DEEP - 0.008, 0.030), (wide, _DEEP, 0.030))
    levels = (floor, _FLOOR + 0.055, top)
    column = ag.loft([ag.rectangle(x, y, radius=r) for x, y, r in sizes], levels).at(0, back, 0)
    slabs = [
        ag.extrude(vessels.chamfered(x + 0.0004, y + 0.0004, 0.58 * r), 0.0002).at(0, back, z)
        for (x, y, r), z in zip(sizes, levels, strict=True)
    ]
    covers = [ag.hull(*slabs[:2]), ag.hull(*slabs[1:])]
    if not lifts:
        pocket = ag.Region((-0.012, 0.012), (back - 0.0425, back - 0.002), (top - 0.031, top + 0.01))
        slot = ag.Region(
            (-0.08, 0), (back + _BAR - 0.0035, back + _BAR + _SLIDE + 0.0035), (top - 0.0255, top - 0.0185)
        )
        column -= ag.union(pocket.box(), slot.box()).paint(_BLACK)
        upper, far, low = covers.pop(), 0.2, pocket.z.low
        room = ag.Region((-far, far), (back - far, back + far), (_FLOOR + 0.03, top + 0.01))
        left, deck = (
            room.with_(x=(-far, pocket.x.low), z=(low, room.z.high)),
            room.with_(z=(low, room.z.high)),
        )
        cells = [
            room.with_(z=(room.z.low, low)),
            deck.with_(x=(pocket.x.high, far)),
            deck.with_(x=pocket.x, y=(room.y.low, pocket.y.low)),
            deck.with_(x=pocket.x, y=(pocket.y.high, room.y.high)),
            left.with_(y=(room.y.low, slot.y.low)),
            left.with_(y=(slot.y.high, room.y.high)),
            left.with_(y=slot.y, z=(low, slot.z.low)),
            left.with_(y=slot.y, z=(slot.z.high, room.z.high)),
        ]
        covers += [upper & cell.box() for cell in cells]
    column = ag.bounding_collider(column, *covers)
    heavy = shell.with_(name=f"{shell.name}_base", density=1500.0)
    around = [(-0.055, back + 0.045), (0.055, back + 0.045), (-0.045, -0.3 * radius), (0.045, -0.3 * radius)]
    feet = [ag.box(0.020, 0.020, 0.006).at(x, y, 0.003) for x, y in around]
    rear_ = back + _DEEP / 2
    line = [
        (0, rear_ - 0.002, 0.012),
        (0, rear_ + 0.035, 0.010),
        (0.03, rear_ + 0.07, 0.0048),
        (0.09, rear_ + 0.085, 0.0048),
    ]
    cord = ag.sweep(ag.regular_polygon(8, 0.0036), ag.spline(line))
    body = ag.weld(
        ag.part(plate, "base", heavy),
        ag.part(column, "column", shell.with_(name=f"{shell.name}_column", density=900.0)),
        ag.part(feet, "foot", ag.material("rubber"), separate="four feet"),
        ag.part(cord, "cord", _BLACK),
    )
    if lifts:
        return body
    ring = ag.tube(0.66 * radius, 0.58 * radius, 0.0125, bevel=0.001).at(z=_FLOOR + 0.00275)
    posts = [
        ag.box(0.07 * radius, 0.020, 0.013).at(side * 0.62 * radius, 0, _FLOOR + 0.0030) for side in (-1, 1)
    ]
    hooks = [
        ag.box(0.10 * radius, 0.020, 0.0034).at(side * 0.575 * radius, 0, _FLOOR + 0.0107) for side in (-1, 1)
    ]
    pivot = (back + 0.042, top + _AXLE[0])
    ears = [
        ag.cylinder(_AXLE[1], 0.012, axis=ag.X, bevel=0.001).at(x, *pivot)
        | ag.box(0.012, 2 * _AXLE[1] - 0.001, 0.022).at(x, pivot[0], pivot[1] - 0.011)
        for x in (-0.034, 0.034)
    ]
    return ag.weld(
        body,
        ag.part([*posts, *hooks], "collar", casting(_STEEL)),
        ag.detail(ring, "collar", _STEEL),
        ag.part(ears, "hinge", shell),
    )


def _head(
    form: Form, radius: ag.Scalar, back: ag.Scalar, top: ag.Scalar, rim: ag.Scalar, slim: ag.Scalar,
    shell: ag.Material, maker: str, *, lifts: bool,
) -> tuple[ag.Body, ag.Scalar]:  # fmt: skip
    """Make a head with its hub for attachments, and return it with the height of its middle."""
    half = 0.060
    middle, rear = top + 0.020 + half, back + 0.062
    long = rear + radius + 0.022

    shape, edge = _FORMS[form], 0.4 * slim

    def section(w: float, h: float, more: float) -> ag.Profile:
        if form == "square":
            return ag.rectangle(2 * (slim * w + more), 2 * (half * h + more), radius=edge * h)
        return ag.ellipse(slim * w + more, half * h + more)

    def outline(w: float, h: float) -> ag.Profile:
        if form == "square":
            return vessels.chamfered(2 * slim * w + 0.0004, 2 * half * h + 0.0004, 0.58 * edge * h)
        return ag.regular_polygon(12, 1.037).scale(slim * w, half * h)

    def barrel(more: float) -> ag.Solid:
        sections = [section(w, h, more) for _, w, h in shape]
        return ag.loft(sections, [share * long for share, _, _ in shape], axis=-ag.Y).at(0, rear, middle)

    belt = ag.box(0.3, 1.2, 0.013).at(0, 0, middle - 0.014)
    free = [ag.box(0.3, y, 0.1).at(0, at, middle) for y, at in ((0.06, rear), (0.006, rear - long))]
    band = (barrel(0.0010) & belt) - ag.union(*free)
    ends = [
        ag.extrude(outline(w, h), 0.0004, axis=ag.Y).at(0, rear - share * long, middle)
        for share, w, h in shape
    ]
    case = ag.bounding_collider(barrel(0.0), ag.hull(*ends[:4]), ag.hull(*ends[3:]))
    foot = ag.Region(
        (-0.005, 0.005), (back + _BAR - 0.0115, back + _BAR + 0.0035), (top - 0.0290, top - 0.0254)
    )
    peg = foot.with_(y=(back + _BAR - 0.0115, back + _BAR - 0.0036), z=(foot.z.low, top + 0.01))
    low = top + (-0.0010 if lifts else 0.0015)  # a head that tilts has play above its column
    saddle = ag.Region((-0.045, 0.045), (back - 0.052, back + 0.028), (low, middle)).box(bevel=0.006)
    knuckle = ag.cylinder(_AXLE[1], 0.052, axis=ag.X, bevel=0.001).at(0, back + 0.042, top + _AXLE[0])
    tongue = ag.Region((-0.0255, 0.0255), (back + 0.034, back + 0.050), (top + _AXLE[0], middle)).box()
    skirt = ag.frustum(0.044, 0.048, middle - rim - 0.024, bevel=0.002).at(z=(middle + rim + 0.024) / 2)
    boss = ag.cylinder(0.0235, 0.034, axis=ag.Y, bevel=0.002).at(0, -radius - 0.030, middle)
    hold = ag.grasp_on(boss, approach=ag.Y, closing=ag.X, depth=0.018)
    full = shell.with_(name=f"{shell.name}_head", density=1250.0)
    solids = [case, saddle, skirt] if lifts else [case, saddle, skirt, knuckle, tongue, foot.box(), peg.box()]
    head = ag.weld(
        ag.part(boss, "hub", casting(_STEEL), name="head", grasp=hold),
        ag.part(solids, "head", full),
        ag.detail(band, "band", _STEEL),
    )
    place = rear - 0.52 * long
    for side in (-1, 1):
        out = slim + 0.0012
        badge = ag.box(0.006, 0.074, 0.015, bevel=0.001).at(side * (out - 0.003), place, middle + 0.004)
        word = details.printed(
            details.logo(maker, 0.0058), (side * out, place, middle + 0.004), facing=side * ag.X,
            material=controls.DARK_INK,
        )  # fmt: skip
        head = ag.weld(head, ag.detail(badge, "band", _STEEL), word)
    return head, middle


def _speed(
    style: controls.DialStyle, finish: ag.Material, shell: ag.Material, speeds: int, torque: ag.Scalar
) -> Fitting:
    """Make the dial of the speeds, the link `knob`."""
    clicks = [_SWEEP * step / (speeds - 1) for step in range(speeds)]
    turn = controls.dial_turn("knob_turn", low=0.0, high=_SWEEP, friction=0.012, clicks=clicks, torque=torque)
    scale = controls.dial_print(
        0.0175, ink=controls.ink_on(shell), style="ticks", count=(speeds + 1) // 2, sweep=_SWEEP, start=0.0
    )
    return controls.dial(turn, style, 0.0175, finish, depth=0.020, cap=_STEEL, scale=scale, name="knob")


def _lock(back: ag.Scalar, top: ag.Scalar, wide: float) -> tuple[ag.Body, ag.Joint]:
    """Make the slider whose bar holds the foot of a head in the pocket of the column: the link `button`."""
    y, z = back + _BAR, top - 0.022
    bar = ag.Region((-wide / 2 - 0.006, 0.008), (y - 0.003, y + 0.003), (z - 0.003, z + 0.003)).box()
    cap = ag.box(0.0130, 0.015, 0.018, bevel=0.0020).at(-wide / 2 - 0.0078, y, z)
    hold = ag.grasp_on(cap, approach=ag.X, closing=ag.Y, depth=0.0100)
    slide = ag.Prismatic(
        "button_slide", axis=ag.Y, limits=(0, _SLIDE), friction=0.5, damping=2.0, armature=0.02, effort=25.0,
        detents=feel.detents((-0.1 * _SLIDE, 1.1 * _SLIDE), 6.0),
    )  # fmt: skip
    return ag.part([bar, cap], "button", _BLACK, name="button", grasp=hold, grasp_width=0.025), slide


def _tool(kind: Tool, radius: ag.Scalar, height: ag.Scalar) -> ag.Body:
    """Make the hub with its tool, whose axis is beside z; the plate below the bowl is the origin."""
    aside, low, top = 0.12 * radius, _FOOT + 0.0035 + _NEAR, height + 0.012
    span = top - low
    hub = ag.cylinder(0.040, 0.009, bevel=0.002).at(z=top + 0.0045)
    shaft = ag.cylinder_between((0, 0, low + 0.80 * span), (0, 0, top + 0.002), 0.0065)
    wide = 0.46 * radius
    widths = ((0.0, 0.30), (0.22, 0.86), (0.42, 1.0), (0.66, 0.72), (0.84, 0.16))
    right = [(share * wide, low + z * span) for z, share in widths]
    if kind == "beater":
        outer = ag.polygon([*right, *((-x, z) for x, z in reversed(right))])
        inner = ag.polygon(
            [*((0.78 * x, 0.9 * z + 0.1 * (low + 0.42 * span)) for x, z in right),
             *((-0.78 * x, 0.9 * z + 0.1 * (low + 0.42 * span)) for x, z in reversed(right))]
        )  # fmt: skip
        plate = ag.extrude(outer - inner, 0.009, axis=ag.Y, bevel=0.0015)
        bars = [
            ag.Region((-x, x), (-0.0035, 0.0035), (low + z * span - 0.004, low + z * span + 0.004)).box()
            for x, z in ((0.86 * wide, 0.26), (0.86 * wide, 0.54))
        ]
        web = ag.Region((-0.004, 0.004), (-0.0035, 0.0035), (low + 0.005, low + 0.85 * span)).box()
        look = ag.union(plate, *bars, web)
        finish = casting(ag.material("brushed_aluminium"), 0.8)
    elif kind == "whisk":
        shares = ((0.36, 0.0), (0.95, 0.26), (0.74, 0.64))
        side = [(x * wide, 0.0, low + z * span) for x, z in shares]
        end = (0.006, 0.0, low + 0.86 * span)
        loop = ag.polyline(
            [*((-x, y, z) for x, y, z in (end, *reversed(side))), *((x, y, z) for x, y, z in (*side, end))]
        )
        wire = ag.sweep(ag.regular_polygon(4, 0.0015), loop)
        look = ag.union(
            ag.cylinder(0.012, 0.030, bevel=0.003).at(z=low + 0.86 * span),
            *(wire.rotate(ag.Z, math.pi * step / 5).at(z=0.0035 * step) for step in range(5)),
        )
        finish = _STEEL
    else:
        way = ag.spline([
            (0, 0, low + 0.86 * span), (0.42 * wide, 0.1 * wide, low + 0.70 * span),
            (0.68 * wide, -0.25 * wide, low + 0.46 * span), (0.30 * wide, -0.62 * wide, low + 0.24 * span),
            (-0.35 * wide, -0.2 * wide, low + 0.0068),
        ])  # fmt: skip
        look = ag.sweep(ag.regular_polygon(8, 0.0075), way)
        finish = casting(ag.material("brushed_aluminium"), 0.9)
    return ag.weld(
        ag.part(hub, "hub", casting(_STEEL, 0.5), name="beater"),
        ag.part([look.at(aside), shaft.at(aside)], "beater", finish),
    )


def _vessel(radius: ag.Scalar, height: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make a bowl on its foot, at the origin, without handles: the link `bowl`."""
    tall = height - _FOOT
    path = ag.polyline([(0.46 * radius, 0, 0), (0.87 * radius, 0, 0.29 * tall), (radius, 0, tall)])
    shell = ag.revolve(ag.half_section(path, wall=_WALL), sides=_SIDES)
    floor = ag.cylinder(0.452 * radius, 0.0035).at(z=0.00175)
    steel = finish.with_(name=f"{finish.name}_bowl", density=6500.0)
    made = ag.part(shell | floor, "bowl", steel).at(z=_FOOT)
    foot = ag.cylinder(0.50 * radius, _FOOT + 0.002, bevel=0.001).at(z=_FOOT / 2 + 0.001)
    lugs = [ag.box(0.016, 0.020, 0.0045).at(side * (0.50 * radius - 0.0025), 0, 0.0038) for side in (-1, 1)]
    brim = ag.detail(
        ag.tube(radius + 0.0022, radius - 0.0030, 0.004, bevel=0.001).at(z=height - 0.002), "bowl", finish
    )
    return ag.weld(ag.part([foot, *lugs], "bowl", casting(finish, 0.2), name="bowl"), made, brim)


def _bowl(radius: ag.Scalar, height: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make a bowl with a handle at its side."""
    end, low = height - 0.018, 0.40 * height
    line = [
        (radius - 0.003, 0, end), (radius + 0.045, 0, end), (radius + 0.040, 0, low), (0.90 * radius, 0, low)
    ]  # fmt: skip
    bar = ag.sweep(ag.rectangle(0.020, 0.007, radius=0.003), ag.polyline(line, fillet=0.014))
    hold = ag.grasp_on(
        bar, approach=-ag.X, closing=ag.Y, at=(radius + 0.0425, 0, (end + low) / 2), depth=0.012
    )
    return ag.weld(_vessel(radius, height, finish), ag.part(bar, "handle", casting(finish, 0.5), grasp=hold))


def _crane(
    body: ag.Body, radius: ag.Scalar, height: ag.Scalar, back: ag.Scalar, drop: ag.Scalar,
    finish: ag.Material, shell: ag.Material,
) -> ag.Body:  # fmt: skip
    """Add the arms that carry the bowl, the crank that lowers them, and the bowl."""
    front = back - _DEEP / 2 - FIT.running  # of the column
    level = _FLOOR + drop + 0.50 * height
    block = ag.Region((-0.040, 0.040), (front - 0.016, front), (level - 0.040, level + 0.018)).box(
        bevel=0.003
    )
    reach = radius + 0.020
    bar = ag.Region(
        (-reach - 0.007, reach + 0.007), (front - 0.014, front - 0.002), (level - 0.008, level + 0.008)
    )
    arms = [
        ag.Region((x - 0.007, x + 0.007), (-0.016, front - 0.003), (level - 0.007, level + 0.007)).box(
            bevel=0.002
        )
        for x in (-reach, reach)
    ]
    pins = [ag.cylinder(0.0035, 0.012, bevel=0.0008).at(x, 0, level + 0.012) for x in (-reach, reach)]
    steel = casting(_STEEL, 0.6)
    carriage = ag.part([block, bar.box(bevel=0.002), *arms, *pins], "arm", steel, name="carriage")
    cup = _vessel(radius, height, finish).at(0, 0, _FLOOR + drop)
    lows = []
    for side in (-1, 1):
        ear = ag.Region((-0.014, 0.014), (-0.014, 0.014), (-0.003, 0.003)).box(bevel=0.001) - ag.box(
            0.009, 0.009, 0.02
        )
        root = ag.box(0.022, 0.024, 0.012, bevel=0.002).at(side * (radius + 0.002), 0, level + 0.0145)
        plate = ear.at(side * reach, 0, level + 0.0070 + FIT.running + 0.003)
        lows += [plate, root]
    grip = (
        ag.Region((-0.028, 0.028), (-radius - 0.018, -radius + 0.006), (_FLOOR + drop, _FLOOR + drop))
        .grow(z=0.004)
        .at(0, 0, 0.86 * height)
    )
    hold = ag.grasp_on(grip.box(), approach=ag.Y, closing=ag.Z, depth=0.012)
    cup = ag.weld(
        cup,
        ag.part(lows, "bowl", casting(finish, 0.5)),
        ag.part(grip.box(bevel=0.0025), "handle", casting(finish, 0.5), grasp=hold),
    )
    turns = 1.45
    hub = ag.cylinder(0.013, 0.014, axis=ag.X, bevel=0.002).at(-0.007 - FIT.running, 0, 0)
    rod = ag.box(0.007, 0.014, 0.082, bevel=0.002).at(-0.0105, 0, 0.041)
    ball = ag.cylinder(0.0095, 0.044, axis=ag.X, bevel=0.004).at(-0.034, 0, 0.080)
    turned = ag.grasp_on(ball, approach=ag.X, closing=ag.Y, depth=0.014)
    handle = ag.weld(
        ag.part(ball, "crank", _BLACK, name="crank", grasp=turned), ag.part(hub | rod, "crank", steel)
    )
    weight = cup.weight() + carriage.weight()
    friction = (1.3 * weight + 55.0) * drop / turns + 0.1
    crank = ag.Revolute("crank_turn", axis=-ag.X, limits=(0, turns), friction=friction, feel=_CRANK)
    slide = ag.Prismatic(
        "carriage_slide", axis=-ag.Z, follows=(drop / turns) * crank, damping=2.0, effort=200.0
    )
    lift = ag.Prismatic(
        "bowl_lift", axis=ag.Z, limits=(0, drop), friction=0.3, damping=2.0, effort=80.0,
        needs=(crank > turns - 0.05).beyond(_NEAR - 0.0020),
    )  # fmt: skip
    body = body.attach(handle, crank, at=(-_WIDE[1] / 2, back + 0.015, 0.70 * level))
    return body.attach(carriage.attach(cup, lift), slide)
