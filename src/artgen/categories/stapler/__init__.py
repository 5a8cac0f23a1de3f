"""A stapler on a desk: full strip, half strip, heavy duty, a hand plier, or a hole punch.

Links: `base` with its `anvil`, a plate that turns between its two grooves; `arm`; `magazine` with its pusher,
which slides out of the arm. A plier has `body` with the magazine, and `lever` with the jaw; a punch has
`base`, `arm`, two `pin` and `guide`, the stop for the paper. Joints: `arm_hinge`, 0 where it is released;
`anvil_turn`, `magazine_slide`, `lever_hinge`, `pin_slide_0` and `pin_slide_1`, which follow the arm, and
`guide_slide`.

A spring lifts the arm, and opens the lever of a plier. The anvil snaps to its two grooves, half a turn apart;
it is reached from below. The magazine is held by its friction.

Sizes are those of Leitz, Rapid, Novus and Swingline catalogs: full strip 160-195 mm and 0.25-0.50 kg for
20-30 sheets, half strip 110-135 mm, heavy duty 270-310 mm, 1.3-2.7 kg for 100-200 sheets, pliers 150-170 mm
and 0.25-0.45 kg, punches 95-130 mm wide with holes of 6 mm at 80 mm (ISO 838). A full strip has 210 staples
of 0.5 mm (105 mm). Catalogs give no springs: those here carry the weight of the arm at its front, and 3-9 N
more.
"""

import math
from typing import Literal

import artgen as ag
from artgen import details, feel
from artgen.categories.shared import controls, pivots
from artgen.categories.shared.finish import colors
from artgen.nodes.fitting import FIT

Style = Literal["full", "half", "heavy", "plier", "punch"]
"""Full strip, half strip, heavy duty with a long lever, a plier for one hand, or a punch for two holes."""

Shape = Literal["plain", "wedge", "round"]
"""Outline of an arm from the side or from above."""

_BASE = 0.0125  # height of a base [m]
_ROOF = 0.0040  # thickness of its top [m]
_EAR = 0.0028  # thickness of the ears beside the arm [m]
_STRIP = {"full": 0.112, "half": 0.062, "heavy": 0.112}
"""Travel of a magazine, for the staples that it holds [m]."""

_BODIES = ag.shades(*colors("abs", "black graphite red navy teal white mustard sky"), color=0.04)
_METALS = ag.shades("chrome", "powder_coat_black", "powder_coat_graphite", "satin_nickel", color=0.03)
_SOFT = ag.choice("rubber", ag.colored("rubber", "light_grey"), ag.colored("rubber", "red"))
_STEEL = ag.material("stainless")
_MAGAZINE = feel.Feel(damping=2.0, armature=0.02, effort=20.0)
_GUIDE = feel.Feel(friction=1.0, damping=1.0, armature=0.02, effort=15.0)
_ARM = feel.Feel(friction=0.01, damping=0.02, armature=0.0003)
_ANVIL = feel.Feel(friction=0.001, damping=0.002, armature=2e-5, effort=0.5)
_LEVER = feel.Feel(friction=0.01, damping=0.006, armature=0.00005, effort=6.0)


@ag.category(
    labels="base foot anvil arm grip magazine staples hinge body lever pivot spring pin guide print",
    joints=(2, 4),
)
def stapler(
    *,
    style: Style = ag.choice({"full": 0.3, "half": 0.2, "heavy": 0.15, "plier": 0.15, "punch": 0.2}),
    length: ag.Float = ag.by(
        "style",
        full=ag.uniform(0.162, 0.195),
        half=ag.uniform(0.112, 0.135),
        heavy=ag.uniform(0.270, 0.310),
        plier=ag.uniform(0.150, 0.170),
        punch=ag.uniform(0.105, 0.130),
        unit="m",
        within=(0.10, 0.32),
        doc="length; of a punch its depth",
    ),
    width: ag.Float = ag.by(
        "style",
        heavy=ag.uniform(0.066, 0.080),
        punch=ag.uniform(0.100, 0.130),
        plier=ag.uniform(0.017, 0.021),
        otherwise=ag.uniform(0.042, 0.047),
        unit="m",
        within=(0.016, 0.14),
        doc="width; of a plier its thickness",
    ),
    tall: ag.Float = ag.by(
        "style",
        heavy=ag.uniform(0.040, 0.048),
        otherwise=ag.uniform(0.026, 0.034),
        unit="m",
        within=(0.024, 0.05),
        doc="height of an arm",
    ),
    shape: Shape = ag.by(
        "style", heavy="plain", plier="plain", otherwise={"plain": 0.35, "wedge": 0.4, "round": 0.25}
    ),
    swing: ag.Float = ag.by(
        "style",
        punch=ag.uniform(0.30, 0.40),
        full=ag.uniform(0.15, 0.22),
        plier=ag.uniform(0.16, 0.22),
        otherwise=ag.uniform(0.15, 0.24),
        unit="rad",
        within=(0.1, 0.45),
        doc="angle between released and pressed",
    ),
    lift: ag.Float = ag.uniform(3.0, 9.0, "N", within=(1.0, 15.0), doc="force at the front that presses it"),
    click: ag.Float = ag.uniform(0.02, 0.05, "N m", doc="torque that turns the anvil over"),
    housing: ag.Material = ag.by("style", plier=_METALS, heavy=_METALS, otherwise=_BODIES),
    accent: ag.Material = _SOFT,
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a stapler or a punch that is released."""
    least = {"heavy": 0.145, "plier": 0.13}.get(style, 0.1)
    length = ag.require(length, length >= least, f"length of a {style} stapler must be >= {least:g} m")
    narrow = {"punch": 0.06, "plier": 0.016}.get(style, 0.03)
    width = ag.require(width, width >= narrow, f"width of a {style} stapler must be >= {narrow:g} m")
    match style:
        case "plier":
            return _plier(length, width, swing, lift, housing, accent, maker)
        case "punch":
            return _punch(length, width, tall, swing, lift, housing, accent, maker, shape)
        case _:
            if style == "heavy":
                tall = ag.require(tall, tall >= 0.032, "tall of a heavy stapler must be >= 0.032 m")
            return _desk(style, length, width, tall, swing, lift, click, housing, accent, maker, shape)


def _print(
    maker: str, at: ag.VectorLike, high: float, face: ag.Material, facing: ag.Vector, up: ag.Vector
) -> ag.Body:
    """Print the name of the maker on a face."""
    mark = details.logo(maker, high)
    return details.printed(mark, at, material=controls.ink_on(face), facing=facing, up=up)


def _tray(plan: ag.Region, finish: ag.Material, shape: Shape) -> ag.Body:
    """Make a base that is open below, with walls behind, two feet in front and pads of rubber under them."""
    wall = 0.003

    def plate(room: ag.Region, margin: float, bevel: float = 0.0) -> ag.Solid:
        """Make the part of a box within the outline of the base."""
        outline = plan.shrink(margin, z=0).plan(radius=0.012 if shape == "round" else 0.006)
        return ag.extrude(outline & room.plan(), room.z.size, bevel=bevel).at(z=room.z.mid)

    top = plate(plan.with_(z=(_BASE - _ROOF, _BASE)), 0.0, 0.0012)
    low = plan.with_(z=(0.0012, _BASE - 0.0015))
    rear = low.deep(0.042, None)[1]  # fingers reach the anvil between walls and feet
    left, inner, right = rear.across(wall, None, wall)
    feet = [low.across(0.009, None, 0.009)[side].deep(0.007, None)[0] for side in (0, 2)]
    walls = [left, right, inner.grow(x=0.0005).deep(None, 0.010)[1], *feet]
    pads = [plate(each.with_(z=(0, 0.0022)), 0.0012) for each in (*feet, low.deep(None, 0.009)[1])]
    return ag.weld(
        ag.part(ag.union(top, *(plate(each, 0.0003) for each in walls)), "base", finish),
        ag.part(pads, "foot", ag.material("rubber")),
    )


def _side(room: ag.Region, shape: Shape) -> ag.Solid:
    """Make the outside of an arm."""
    x, y, z = room.x, room.y, room.z
    if shape == "wedge":
        side = [
            (y.low, z.low),
            (y.high, z.low),
            (y.high, z.high - 0.003),
            (y.high - 0.010, z.high),
            (y.low + 0.4 * y.size + 0.030, z.high - 0.001),
            (y.low + 0.044, z.low + 0.76 * z.size),
            (y.low, z.low + 0.76 * z.size),
        ]
        return ag.extrude(ag.polygon(side), x.size, axis=ag.X, bevel=0.0022)
    if shape == "round":
        nose = ag.cylinder(x.size / 2, z.size, bevel=0.0022).at(0, y.low + x.size / 2, z.mid)
        return ag.hull(nose, room.layers(2)[1].box(bevel=0.0022))
    # flat for the hand in front, and lower and lower behind the middle
    back = [
        (y.mid + share * y.size / 2, z.high - 0.3 * share**2 * z.size) for share in (0, 0.25, 0.5, 0.75, 1)
    ]
    side = [(y.low, z.low), (y.low, z.high - 0.004), (y.low + 0.008, z.high), *back, (y.high, z.low)]
    return ag.extrude(ag.polygon(side), x.size, axis=ag.X, bevel=0.0030)


def _pad(room: ag.Region, shape: Shape, window: ag.Region, accent: ag.Material) -> ag.Body:
    """Make a pad that follows the top of an arm."""
    layer = _side(room.shrink(0.004, z=0, back=0).grow(top=0.0012), shape)
    return ag.detail(layer & window.box(bevel=0.001), "grip", accent)


def _desk(
    style: Style,
    length: ag.Scalar,
    width: ag.Scalar,
    tall: ag.Scalar,
    swing: ag.Scalar,
    lift: ag.Scalar,
    click: ag.Scalar,
    housing: ag.Material,
    accent: ag.Material,
    maker: str,
    shape: Shape,
) -> ag.Body:
    """Make a stapler on a base: pressed down while it is drawn, then lifted to its released position."""
    heavy = style == "heavy"
    plan = ag.Region.centered(width, length, 0.1)
    paper = 0.014 if heavy else 0.0035  # room for sheets under the pressed arm [m]
    low = _BASE + paper
    room = plan.shrink(x=_EAR + FIT.running, front=0.014 if heavy else 0.010, back=0.010)
    room = room.with_(z=(low, low + tall))
    pivot = ag.vector(0, plan.y.high - 0.017, low + 0.35 * tall)
    base = _tray(plan, housing, shape)
    back = plan.with_(
        y=(plan.y.high - 0.028, plan.y.high - 0.004), z=(_BASE - 0.001, low + 0.35 * tall + 0.009)
    )
    left, _, right = back.across(_EAR, None, _EAR)
    pin = ag.cylinder(0.0022, width - 0.0006, axis=ag.X).at(pivot)
    base = ag.weld(
        base,
        ag.part(
            [left.box(bevel=0.001), right.box(bevel=0.001)], "hinge", housing, separate="ears on the base"
        ),
        ag.part(pin, "hinge", _STEEL, separate="held by the ears"),
    )
    # the magazine runs in a channel of the arm that is open in front
    channel = ag.Region((-0.0085, 0.0085), (plan.y.low, pivot.y - 0.012), (low + 0.0015, low + 0.0155))
    outside = _side(room, shape)
    hollow = outside - ag.bore(0.0029, 0.2, axis=ag.X).at(pivot) - channel.grow(front=0.02).box()
    # the lower back edge turns past the base
    arm_finish = housing.with_(name=f"{housing.name}_arm", density=1320.0 if style == "full" else 1500.0)
    press = ag.push_on(outside, direction=-ag.Z, at=(0, room.y.low + 0.022, 0))
    arm = ag.part(hollow, "arm", arm_finish, push=() if heavy else press)
    top = low + tall
    if heavy:
        arm = ag.weld(arm, _handle(plan, room, top, housing, accent))
    elif shape != "wedge":
        window = room.shrink(x=0.003, front=0.007).deep(0.042, None)[0].with_(z=(top - 0.012, top + 0.01))
        arm = ag.weld(arm, _pad(room, shape, window, accent))
    side = room.x.high
    arm = ag.weld(
        arm,
        _print(
            maker,
            (side, room.y.mid, low + 0.62 * tall if shape != "wedge" else low + 0.45 * tall),
            0.006,
            housing,
            ag.X,
            ag.Z,
        ),
    )
    travel = ag.min_(_STRIP[style], 0.85 * channel.y.size)
    slide = ag.Prismatic("magazine_slide", axis=-ag.Y, limits=(0, travel), friction=2.5, feel=_MAGAZINE)
    arm = arm.attach(_magazine(channel, room.y.low), slide)
    spring = _sprung(arm, pivot, plan, lift)
    effort = 100.0 * 0.9 * length if heavy else 60.0 * length
    hinge = ag.Revolute(
        "arm_hinge", axis=ag.X, pivot=pivot, limits=(0, swing), spring=spring, feel=_ARM, effort=effort
    )
    base = _anvil(base, plan, room.y.low + 0.009, click)
    return base.attach(arm.rotate(-ag.X, swing, about=pivot), hinge)


def _sprung(arm: ag.Body, pivot: ag.Vector, plan: ag.Region, lift: ag.Scalar) -> ag.Spring:
    """Make the spring that lifts an arm by its front."""
    reach = pivot.y - plan.y.low
    hold = arm.weight() * (pivot.y - arm.center_of_mass().y) + 0.5 * lift * reach
    return ag.Spring(preload=hold, force=hold + 0.5 * lift * reach)


def _handle(
    plan: ag.Region, room: ag.Region, top: ag.Scalar, finish: ag.Material, accent: ag.Material
) -> ag.Body:
    """Make the long lever of a heavy stapler over its arm, with a sleeve for the hand."""
    front, rise = plan.y.low - 0.020, top + 0.055
    line = [
        (0, room.y.high - 0.035, top - 0.014),
        (0, room.y.high - 0.050, top + 0.020),
        (0, room.y.mid + 0.02, rise),
        (0, front, rise),
    ]
    bar = ag.sweep(ag.rectangle(0.022, 0.010), ag.polyline(line, fillet=0.02))
    sleeve = ag.Region((-0.015, 0.015), (front - 0.012, front + 0.098), (rise - 0.0095, rise + 0.0095)).box(
        bevel=0.004
    )
    hold = ag.grasp_on(sleeve, approach=-ag.Z, closing=ag.X, depth=0.015)
    press = ag.push_on(sleeve, direction=-ag.Z)
    return ag.weld(
        ag.part(
            sleeve, "grip", accent.with_(name=f"{accent.name}_sleeve"), name="handle", grasp=hold, push=press
        ),
        ag.part(bar, "arm", finish.with_(name=f"{finish.name}_lever", density=4500.0)),
    )


def _magazine(channel: ag.Region, front: ag.Scalar) -> ag.Body:
    """Make the magazine, pushed in: a channel of steel with staples, and a tongue in front."""
    bar = channel.shrink(0.0006, front=0).with_(y=(front + 0.0010, channel.y.high - 0.0006)).box()
    tongue = ag.Region(
        (-0.0075, 0.0075), (front - 0.014, front + 0.002), (channel.z.low + 0.002, channel.z.high - 0.0015)
    ).box(bevel=0.0015)
    hold = ag.grasp_on(tongue, closing=ag.X, depth=0.010)
    steel = _STEEL.with_(name="magazine_sheet", density=3200.0)
    rails = channel.shrink(0.0006, front=0).with_(
        y=(front + 0.006, channel.y.high - 0.01), z=(channel.z.low + 0.0002, channel.z.low + 0.0007)
    )
    strip = rails.with_(x=(-0.006, 0.006)).box()
    return ag.weld(
        ag.part(tongue, "magazine", ag.material("black_abs"), grasp=hold),
        ag.part(bar, "magazine", steel),
        ag.detail(strip, "staples", ag.material("zinc")),
    )


def _anvil(base: ag.Body, plan: ag.Region, y: ag.Scalar, click: ag.Scalar) -> ag.Body:
    """Make the plate with two grooves in the top of the base; its knob is reached from below."""
    disc, play = 0.0085, FIT.sliding
    # around the disc, with half of the colliders of a round hole
    outline = ag.regular_polygon(8, (disc + play) / math.cos(math.pi / 8))
    hole = ag.extrude(outline, 0.02).at(0, y, _BASE)
    plate = ag.cylinder(disc, _ROOF - 0.0008).at(z=_BASE - _ROOF / 2 + 0.0004)
    knob = ag.box(0.0050, 0.0060, 0.0062, bevel=0.0008).at(z=_BASE - _ROOF - 0.0028)
    grooves = ag.rectangle(0.0110, 0.0020).at(0, 0.0035) | ag.rectangle(0.0150, 0.0016).at(0, -0.0035)
    marks = details.engraved(grooves, (0, 0, _BASE), material=_STEEL, facing=ag.Z, up=ag.Y, label="anvil")
    hold = ag.grasp_on(knob, approach=ag.Z, closing=ag.X, depth=0.0040)
    anvil = ag.weld(ag.part([knob, plate], "anvil", _STEEL, grasp=hold), marks)
    clicks = feel.detents((0.0, math.pi), click)
    turn = ag.Revolute("anvil_turn", axis=ag.Z, limits=(-0.02, math.pi + 0.02), detents=clicks, feel=_ANVIL)
    return base.cut(hole).attach(anvil, turn, at=(0, y, 0))


def _plier(
    length: ag.Scalar,
    thick: ag.Scalar,
    swing: ag.Scalar,
    lift: ag.Scalar,
    finish: ag.Material,
    accent: ag.Material,
    maker: str,
) -> ag.Body:
    """Make a plier that lies on its side: the magazine at the right of its jaw, the lever drawn squeezed."""
    jaw, rear, half = 0.42 * length, 0.58 * length, thick / 2
    sheet = finish.with_(name=f"{finish.name}_shell", density=4700.0)
    middle = 0.0046  # half of the thickness of the lever between the cheeks [m]
    cheek = ag.polygon([(0.0125, 0.025), (0.0, 0.025), (-0.0170, -0.022), (-0.0050, -0.024), (0.0125, 0.0)])
    deep = half - middle - FIT.running
    cheeks = [ag.extrude(cheek, deep).at(z=side * (half - deep / 2)) for side in (-1, 1)]
    plate = ag.polygon(
        [(-0.0100, 0.028), (-0.0014, 0.028), (0.0170, -0.022), (0.0050, -0.024), (-0.0125, 0.0)]
    )

    def handle(name: str, up: ag.Vector) -> ag.Body:
        """Make the left handle with its leaf spring."""
        line = [
            (-0.0110, -0.0200),
            (-0.0200, -0.0420),
            (-0.0265, -0.58 * rear),
            (-0.0265, -0.85 * rear),
            (-0.0235, -rear),
        ]
        sections = [
            ag.rectangle(wide, thick - 0.0004, radius=0.0035).at(x)
            for (x, _), wide in zip(line, (0.0120, 0.0105, 0.0110, 0.0110, 0.0090), strict=True)
        ]
        bar = ag.loft(sections[::-1], [y for _, y in reversed(line)], axis=ag.Y)
        hold = ag.grasp_on(bar, approach=up, closing=ag.X, at=(-0.0265, -0.71 * rear, 0), depth=0.8 * thick)
        sleeve = ag.loft(
            [
                ag.rectangle(wide + 0.0012, thick + 0.0008, radius=0.004).at(x)
                for (x, _), wide in zip(line[:1:-1], (0.0090, 0.0110, 0.0110), strict=True)
            ],
            [y for _, y in line[:1:-1]],
            axis=ag.Y,
        )
        return ag.weld(
            ag.part(bar, "lever", sheet, name=name, grasp=hold),
            ag.detail(sleeve, "grip", accent),
            pivots.leaf_spring((-0.0174, -0.045), -0.028),
        )

    shell = ag.Region((0.0, 0.0125), (0.0245, jaw), (-half, half))
    channel = ag.Region((0.0024, 0.0104), (0.030, jaw + 0.02), (-0.0062, 0.0062))
    case = shell.box(bevel=0.0010) - channel.box()
    body = ag.weld(
        ag.part(ag.union(case, *cheeks), "body", sheet),
        handle("body_handle", -ag.Z),
        pivots.rivet(0.0030, half, _STEEL),
        _print(maker, (0.0063, 0.5 * (jaw + 0.022), half), 0.0030, finish, ag.Z, ag.X),
    )
    bar = channel.shrink(0.0005, back=0.02 + 0.0005).box()
    tongue = ag.Region((0.0026, 0.0102), (jaw - 0.002, jaw + 0.012), (-0.0058, 0.0058)).box(bevel=0.0012)
    hold = ag.grasp_on(tongue, approach=-ag.Y, closing=ag.Z, depth=0.009)
    magazine = ag.weld(
        ag.part(tongue, "magazine", ag.material("black_abs"), grasp=hold),
        ag.part(bar, "magazine", _STEEL.with_(name="magazine_sheet", density=3200.0)),
    )
    slide = ag.Prismatic("magazine_slide", axis=ag.Y, limits=(0, 0.6 * jaw), friction=2.0, feel=_MAGAZINE)
    arm = ag.Region((-0.0095, -0.0014), (0.0275, jaw), (-half, half)).box(bevel=0.0010)
    core = ag.extrude(plate, 2 * middle) - ag.extrude(pivots.rivet_hole(0.0030), 0.1)
    anvil = ag.box(0.0006, 0.009, 0.012).at(-0.0013, jaw - 0.008)
    lever = ag.weld(
        ag.part(arm | core, "lever", sheet),
        handle("lever_handle", ag.Z).rotate(ag.Y, math.pi),
        ag.detail(anvil, "anvil", _STEEL),
    )
    press = lift * 0.7 * rear
    spring = ag.Spring(preload=0.5 * press, force=press)
    hinge = ag.Revolute("lever_hinge", axis=-ag.Z, limits=(0, swing), spring=spring, feel=_LEVER)
    body = body.attach(magazine, slide).attach(lever.rotate(ag.Z, swing), hinge)
    return body.at(0.0101, (rear - jaw) / 2, half + 0.0004)


def _punch(
    length: ag.Scalar,
    width: ag.Scalar,
    tall: ag.Scalar,
    swing: ag.Scalar,
    lift: ag.Scalar,
    housing: ag.Material,
    accent: ag.Material,
    maker: str,
    shape: Shape,
) -> ag.Body:
    """Make a punch for two holes at 80 mm: its arm is drawn pressed, then lifted."""
    plan = ag.Region.centered(width, length, 0.1)
    floor, slit = 0.024, 0.0028  # height of the tray for the chips, and of the slit for paper [m]
    reach, bore = 0.034, 0.0030  # from the hinge to the pins; radius of a hole [m]
    pivot = ag.vector(0, plan.y.high - 0.014, floor + slit + 0.026)
    y = pivot.y - reach
    under = pivot.z - 0.004  # lower side of the pressed arm [m]
    tray = plan.with_(z=(0.0015, floor)).box(bevel=0.003)
    guide = ag.Region((-0.5 * width - 0.01, 0.5 * width + 0.01), (y - 0.032, y - 0.020), (0.010, 0.0155))
    tray -= guide.grow(y=0.0005, z=0.0005).box()
    rubber = plan.shrink(0.004, z=0).with_(z=(0, 0.0030)).box(bevel=0.001)
    light = housing.with_(name=f"{housing.name}_tray", density=420.0)
    towers, steel = [], _STEEL.with_(name="tower_steel", density=4600.0)
    for x in (-0.040, 0.040):
        tower = ag.Region(
            (x - 0.009, x + 0.009), (y - 0.008, pivot.y - 0.010), (floor + slit, under - 0.0035)
        ).box(bevel=0.0008)
        post = ag.Region(
            (x - 0.009, x + 0.009), (y + 0.010, pivot.y - 0.0105), (floor - 0.002, floor + slit + 0.004)
        ).box()
        hole = 2 * (bore + FIT.sliding)
        towers.append((tower | post) - ag.box(hole, hole, 0.1).at(x, y, floor + 0.05))
        tray -= ag.box(hole, hole, 0.014).at(x, y, floor)
    ears = [
        ag.Region(
            (x - 0.002, x + 0.002), (pivot.y - 0.008, pivot.y + 0.008), (floor - 0.002, pivot.z + 0.008)
        ).box(bevel=0.0015)
        for x in (-0.024, 0.024)
    ]
    pin = ag.cylinder(0.0022, 0.054, axis=ag.X).at(pivot)
    base = ag.weld(
        ag.part(tray, "base", light),
        ag.part(rubber, "foot", ag.material("rubber").with_(name="punch_rubber", density=700.0)),
        ag.part(towers, "base", steel, separate="two towers on the base"),
        ag.part(ears, "hinge", steel, separate="ears on the base"),
        ag.part(pin, "hinge", _STEEL, separate="held by the ears"),
    )
    room = ag.Region(
        (-0.5 * width + 0.002, 0.5 * width - 0.002),
        (plan.y.low - 0.006, pivot.y + 0.011),
        (under, under + 0.55 * tall),
    )
    outside = _side(room, shape)
    niches = [
        ag.Region((x - 0.0028, x + 0.0028), (pivot.y - 0.012, pivot.y + 0.02), (under - 0.01, under + 0.1))
        for x in (-0.024, 0.024)
    ]
    hollow = outside - ag.bore(0.0029, 0.2, axis=ag.X).at(pivot)
    for niche in niches:
        hollow -= niche.box()
    press = ag.push_on(outside, direction=-ag.Z, at=(0, room.y.low + 0.016, 0))
    arm = ag.part(hollow, "arm", housing.with_(name=f"{housing.name}_shell", density=700.0), push=press)
    if shape != "wedge":
        window = room.shrink(x=0.016, front=0.006).deep(0.028, None)[0]
        window = window.with_(z=(room.z.mid, room.z.high + 0.01))
        arm = ag.weld(arm, _pad(room, shape, window, accent))
    spring = _sprung(arm, pivot, plan, lift)
    hinge = ag.Revolute(
        "arm_hinge", axis=ag.X, pivot=pivot, limits=(0, swing), spring=spring, feel=_ARM, effort=60.0 * length
    )
    base = base.attach(arm.rotate(-ag.X, swing, about=pivot), hinge)
    base = ag.weld(base, _print(maker, (0, plan.y.low, 0.45 * floor), 0.006, housing, -ag.Y, ag.Z))
    for number, x in enumerate((-0.040, 0.040)):
        foot = floor - 0.004
        shaft = ag.cylinder_between((x, y, foot), (x, y, under - 0.0020), bore)
        stroke = ag.Prismatic(f"pin_slide_{number}", axis=-ag.Z, follows=reach * hinge, armature=0.005)
        base = base.attach(ag.part(shaft.at(z=reach * swing), "pin", _STEEL, name=f"pin_{number}"), stroke)
    bar = guide.with_(x=(-0.5 * width + 0.004, 0.5 * width + 0.014)).box()
    stop = ag.Region(
        (0.5 * width + 0.0105, 0.5 * width + 0.0215),
        (guide.y.low - 0.003, guide.y.high + 0.003),
        (0.006, 0.0195),
    ).box(bevel=0.001)
    hold = ag.grasp_on(stop, approach=-ag.X, closing=ag.Y, depth=0.009)
    ruler = ag.part([stop, bar], "guide", ag.material("black_abs"), name="guide", grasp=hold)
    slide = ag.Prismatic("guide_slide", axis=ag.X, limits=(0, 0.75 * width), feel=_GUIDE)
    return base.attach(ruler, slide)
