"""A lighter: with petrol or an arc under a hinged lid, for gas, with a jet, for a table, or for candles.

Links: `case` with the `lid`, the `wheel` or the `button`; a gas lighter has the `wheel` and the `lever`, a
table lighter `base`, `insert`, `lever` and `snuffer`, a stick lighter the `trigger`. Joints: `lid_hinge`,
`wheel_turn`, `lever_press`, `button_slide`, `insert_lift`, `snuffer_hinge`, `trigger_slide`. At 0 lids are
closed, and keys and triggers are released.

A cam snaps the lid of a petrol lighter open and closed. A striking wheel turns on and on, by the friction of
a thumb. Springs return levers, buttons and triggers. The lid of a jet and the snuffer of a table lighter are
geared to what a thumb presses. Friction holds the insert of a table lighter, which lifts out for petrol.

Sizes are those of Zippo, BIC, Clipper, Ronson and Colibri catalogs. Petrol lighters have 38 by 57 by 13 mm
and 50-65 g, arc lighters 37-40 by 70-76 mm and 50-80 g; gas lighters are 72-82 mm high and weigh 13-24 g;
jets have 40-42 by 62-70 by 16 mm and 70-130 g. Table lighters are 70-95 mm wide and weigh 0.35-1.3 kg; stick
lighters are 250-290 mm long and weigh 45-90 g. Lids turn over with 0.015-0.04 N m, a wheel takes 0.01-0.02
N m, a lever 4-8 N; triggers and buttons of jets take 12-30 N, because children must not press them (ISO
9994).
"""

import math
from functools import reduce
from operator import or_
from typing import Literal

import artgen as ag
from artgen import details, feel, signals
from artgen.categories.shared import controls, polar, require_size
from artgen.categories.shared.finish import casting, colors, recess

Style = Literal["petrol", "arc", "gas", "jet", "table", "stick"]
"""A lighter for petrol with a lid, with an arc, for gas, with a jet, for a table, or for candles."""

_WALL = 0.0008  # of a lid [m]
_PIVOT = 0.0012  # from the side of a case to the axis of its lid [m]
_OPEN = 2.1  # angle of an open lid [rad]
_WHEEL = 0.0043  # radius of a striking wheel [m]
_STEEL = ag.material("stainless")
_BLACK = ag.material("black_abs")
_BLUE = (0.08, 0.35, 1.0)  # emission of lamps
_CHARGE = ag.material("led_blue").with_(name="led_charge", emission=(0.0, 0.0, 0.0))
_WICK = ag.material("linen").with_(name="wick", base_color=(0.72, 0.68, 0.58), texture="")
_LID = feel.Feel(friction=0.002, damping=0.003, armature=1e-5, effort=0.1)
_STRIKE = feel.Feel(friction=0.012, damping=2e-4, armature=1e-6, effort=0.1)
_PRESS = feel.Feel(friction=0.004, damping=0.004, armature=4e-5, effort=0.4)
_PIEZO = feel.Feel(friction=0.8, damping=8.0, armature=0.06, effort=45.0)
_LIFT = feel.Feel(friction=4.0, damping=4.0, armature=0.05, effort=30.0)
_METALS = ("chrome", "stainless", "satin_nickel", "brass", "copper", "black_steel")
_FINISHES = {
    "petrol": ag.shades(*_METALS, *colors("powder_coat", "black navy red forest"), color=0.03),
    "arc": ag.shades(*_METALS[:3], "black_anodised", *colors("powder_coat", "black blue red"), color=0.03),
    "gas": ag.shades(
        *colors("glossy_plastic", "red yellow blue black white orange forest pink"), color=0.05
    ),
    "jet": ag.shades(
        "chrome", "black_steel", "satin_nickel", *colors("powder_coat", "black red blue"), color=0.03
    ),
    "table": ag.choice("marble", "green_marble", "black_granite", "walnut", "brass", "oak"),
    "stick": ag.shades(*colors("abs", "red black blue yellow forest orange"), color=0.04),
}  # fmt: skip

_SPANS: dict[Style, tuple[tuple[float, float], tuple[float, float]]] = {
    "petrol": ((0.050, 0.075), (0.034, 0.048)), "arc": ((0.060, 0.100), (0.034, 0.050)),
    "gas": ((0.060, 0.100), (0.0235, 0.028)), "jet": ((0.055, 0.100), (0.038, 0.050)),
    "table": ((0.060, 0.130), (0.060, 0.110)), "stick": ((0.220, 0.320), (0.0155, 0.025)),
}  # fmt: skip
"""Possible heights and widths by style [m]."""

_ACCENTS = ag.choice(*colors("abs", "black red graphite white"))


@ag.category(
    labels=(
        "case lid hinge insert chimney wheel lever hood button bezel nozzle trigger base snuffer wick print "
        "window led"
    ),
    joints=(1, 3),
)
def lighter(
    *,
    style: Style = ag.choice(
        {"petrol": 0.24, "arc": 0.12, "gas": 0.22, "jet": 0.14, "table": 0.12, "stick": 0.16}
    ),
    height: ag.Float = ag.by(
        "style",
        petrol=ag.uniform(0.056, 0.058),
        arc=ag.uniform(0.070, 0.076),
        gas=ag.uniform(0.072, 0.082),
        jet=ag.uniform(0.062, 0.070),
        table=ag.uniform(0.072, 0.096),
        stick=ag.uniform(0.250, 0.290),
        unit="m",
        within=(0.05, 0.32),
        doc="height; of a stick its length",
    ),
    width: ag.Float = ag.by(
        "style",
        petrol=ag.uniform(0.037, 0.039),
        arc=ag.uniform(0.037, 0.040),
        gas=ag.uniform(0.024, 0.026),
        jet=ag.uniform(0.040, 0.042),
        table=ag.uniform(0.070, 0.094),
        stick=ag.uniform(0.017, 0.021),
        unit="m",
        within=(0.015, 0.11),
        doc="width; of a stick the thickness of its handle",
    ),
    shape: Literal["round", "square"] = ag.by(
        "style",
        table={"round": 0.6, "square": 0.4},
        gas={"round": 0.7, "square": 0.3},
        otherwise="square",
        doc="section of the base of a table lighter, or of a gas lighter",
    ),
    torque: ag.Float = ag.uniform(
        0.015, 0.040, "N m", within=(0.008, 0.08), doc="torque that turns a lid over"
    ),
    press: ag.Float = ag.by(
        "style",
        jet=ag.uniform(12.0, 24.0),
        stick=ag.uniform(14.0, 30.0),
        arc=ag.uniform(2.5, 4.5),
        otherwise=ag.uniform(4.0, 8.0),
        unit="N",
        within=(2.0, 40.0),
        doc="force of a thumb at the end of its way",
    ),
    clear: bool = ag.by("style", gas={True: 0.35, False: 0.65}, otherwise=False, doc="a clear tank"),
    finish: ag.Material = ag.by("style", _FINISHES),
    accent: ag.Material = _ACCENTS,
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a lighter that is closed and released."""
    high, wide = _SPANS[style]
    height = require_size(height, high, f"{'length' if style == 'stick' else 'height'} of a {style} lighter")
    width = require_size(width, wide, f"width of a {style} lighter")
    match style:
        case "petrol":
            return _petrol(width, height, torque, finish, maker)
        case "arc":
            return _arc(width, height, torque, press, finish, maker)
        case "gas":
            return _gas(width, height, press, finish, accent, maker, square=shape == "square", clear=clear)
        case "jet":
            return _jet(width, height, press, finish, maker)
        case "table":
            return _table(width, height, press, finish, square=shape == "square")
    return _stick(height, width, press, finish, accent, maker)


def _boxed(
    room: ag.Region, split: ag.Scalar, torque: ag.Scalar, finish: ag.Material, share: float
) -> tuple[ag.Body, ag.Body, ag.Joint]:
    """Make the case of a lighter below a height, its lid, and the hinge at the left that snaps."""
    whole = room.box(bevel=0.0020)
    low = whole.split(point=(0, 0, split), normal=-ag.Z)
    shell = whole.split(point=(0, 0, split + 0.00025), normal=ag.Z)
    hollow = shell - room.shrink(_WALL).with_(z=(split - 0.01, room.z.high - 0.0014)).box()
    x, knuckle = room.x.low - _PIVOT, room.y.size / 3 - 0.0010
    barrel = ag.cylinder(0.0009, knuckle, axis=ag.Y).at(x, 0, split)
    leaf = ag.Region((x - 0.0005, room.x.low + 0.0004), (-knuckle / 2, knuckle / 2), (0.0003, 0.0030)).box()
    joint = ag.union(barrel, leaf.at(z=split))
    ends = [joint.at(y=side * (knuckle + 0.0005)) for side in (-1, 1)]
    fixed = barrel | leaf.at(z=split - 0.0033)
    metal = finish.with_(name=f"{finish.name}_hinge")
    hold = ag.grasp_on(
        shell, approach=-ag.Z, closing=ag.Y, at=(room.x.high - 0.011, 0, split + 0.01), depth=0.0125
    )
    body = ag.weld(
        ag.part(low, "case", casting(finish.with_(density=8500.0), share), name="case"),
        ag.part(fixed, "hinge", metal),
    )
    sheet = finish.with_(name=f"{finish.name}_lid", density=7800.0)
    lid = ag.weld(ag.part(hollow, "lid", sheet, name="lid", grasp=hold), ag.part(ends, "hinge", metal))
    snap = feel.detents((-0.30, _OPEN + 0.45), torque)
    hinge = ag.Revolute(
        "lid_hinge", axis=-ag.Y, pivot=(x, 0, split), limits=(0, _OPEN), detents=snap, feel=_LID
    )
    return body, lid, hinge


def _logo(maker: str, tall: float, wide: float) -> ag.Profile:
    """Make the name of the maker within a height and a width [m]."""
    return details.logo(maker, min(tall, wide / details.lettering_width(maker.upper(), 0.3)))


def _wheel(at: ag.VectorLike, wide: float) -> tuple[ag.Body, ag.Joint]:
    """Make a striking wheel along y with its joint."""
    count = 26
    teeth = polar([_WHEEL + 0.0002 - 0.0004 * (step % 2) for step in range(2 * count)])
    dark = ag.material("steel").with_(name="striker", base_color=(0.24, 0.235, 0.23), specular_roughness=0.45)
    core = ag.cylinder(_WHEEL - 0.0002, wide, axis=ag.Y) - ag.bore(0.0013, 0.05, axis=ag.Y)
    band = ag.extrude(teeth - ag.circle(_WHEEL - 0.0012), 0.8 * wide, axis=ag.Y)
    body = ag.weld(ag.part(core, "wheel", dark, name="wheel"), ag.detail(band, "wheel", dark))
    turn = ag.Revolute("wheel_turn", axis=-ag.Y, pivot=at, feel=_STRIKE, driven="the friction of a thumb")
    return body.at(at), turn


def _petrol(
    width: ag.Scalar, height: ag.Scalar, torque: ag.Scalar, finish: ag.Material, maker: str
) -> ag.Body:
    """Make a petrol lighter with its insert: chimney, wick, cam and wheel."""
    split = height - 0.0205
    room = ag.Region.centered(width, 0.0130, 0.0).with_(z=(0, height))
    body, lid, hinge = _boxed(room, split, torque, finish, 0.24)
    level = split + 0.0008
    plate = room.shrink(0.0012, left=0.0030, z=0).with_(z=(split - 0.001, level)).box()
    sheet = 0.0005
    guard = ag.Region((-0.0120, 0.0030), (-0.0042, 0.0042), (level - 0.0002, level + 0.0150))
    chimney = guard.box() - guard.shrink(sheet, z=0).grow(z=0.01).box()
    ears = [
        ag.Region((0.0026, 0.0110), (y - sheet / 2, y + sheet / 2), (level - 0.0002, level + 0.0086)).box()
        for y in (-0.0042 + sheet / 2, 0.0042 - sheet / 2)
    ]
    at = ag.vector(0.0088, 0, level + 0.0052)
    axle = ag.cylinder(0.0009, 0.0082, axis=ag.Y).at(at)
    holes = reduce(
        or_, (ag.circle(0.0010).at(0.0036 * x, 0.0033 * z) for x in (-1, 0, 1) for z in (-1, 0, 1) if x or z)
    )
    middle = (guard.x.low + guard.x.high) / 2
    seen = [
        details.printed(holes, (middle, y, level + 0.0084), material=recess(_STEEL), facing=facing)
        for y, facing in ((-0.0042, -ag.Y), (0.0042, ag.Y))
    ]
    wick = ag.cylinder(0.0016, 0.0100, bevel=0.0006).at(-0.0050, 0, level + 0.0048)
    cam = ag.Region((-0.0160, -0.0128), (-0.0024, 0.0024), (level - 0.0002, level + 0.0046)).box(bevel=0.0006)
    mark = details.engraved(_logo(maker, 0.0030, 0.027), (0, -0.0065, 0.45 * split), material=finish)
    body = ag.weld(
        body,
        ag.part(plate, "insert", _STEEL),
        ag.part([chimney, *ears], "chimney", _STEEL),
        ag.part(axle, "insert", _STEEL, separate="held by the ears of the chimney"),
        ag.detail(wick, "wick", _WICK),
        ag.detail(cam, "insert", ag.material("brass")),
        *seen,
        mark,
    )
    wheel, turn = _wheel(at, 0.0062)
    flame = _struck(turn, unless=hinge < 0.4)
    body = body.output("flame", flame, kind="heat")
    return body.attach(lid, hinge).attach(wheel, turn).at(_PIVOT / 2)  # in the middle with its hinge


def _struck(turn: ag.Joint, *, unless: signals.Signal | ag.Condition) -> signals.Signal:
    """Return the signal of a flame that a turn of the wheel lights."""
    return signals.latest([signals.pressed(turn, (0.0, 1.2))], [1.0], unless=unless)


def _arc(
    width: ag.Scalar, height: ag.Scalar, torque: ag.Scalar, press: ag.Scalar, finish: ag.Material, maker: str
) -> ag.Body:
    """Make an electric lighter, whose arc crosses between four electrodes under the lid."""
    split, deep = height - 0.0240, 0.0125
    room = ag.Region.centered(width, deep, 0.0).with_(z=(0, height))
    body, lid, hinge = _boxed(room, split, torque, finish, 0.19)
    plate = room.shrink(0.0014, left=0.0036, z=0).with_(z=(split - 0.001, split + 0.0022)).box(bevel=0.0004)
    ceramic = ag.material("ceramic")
    spots = [(x, y) for x in (-0.0030, 0.0030) for y in (-0.0022, 0.0022)]
    posts = [ag.cylinder(0.0013, 0.0060).at(x, y, split + 0.0050) for x, y in spots]
    tips = [ag.sphere(0.0010).at(0.9 * x, 0.9 * y, split + 0.0082) for x, y in spots]
    face = -deep / 2
    leds = [
        ag.cylinder(0.0008, 0.0004, axis=ag.Y).at(x, face, 0.36 * split)
        for x in (-0.0045, -0.0015, 0.0015, 0.0045)
    ]
    body = ag.weld(
        body,
        ag.part(plate, "insert", _BLACK),
        ag.part(posts, "insert", ceramic),
        ag.detail(tips, "nozzle", _STEEL),
        ag.detail(leds, "led", _CHARGE),
        details.engraved(_logo(maker, 0.0026, 0.027), (0, face, 0.20 * split), material=finish),
    )
    ink = _CHARGE.with_(name="ring_of_light")
    button = controls.push_button(
        finish=_STEEL, plate=_BLACK, through=0.0042, width=0.0105, proud=0.0022, deep=0.0030, travel=0.0010,
        preload=0.25 * press, force=press, icon="power", ink=ink,
    )  # fmt: skip
    body = body.install(button, at=(0, face, 0.66 * split))
    opened, pressed = hinge > 0.8, signals.pressed("button_slide")
    body = body.output("arc", pressed & opened, kind="heat")
    body = body.output("charge", opened, kind="light", material=_CHARGE, color=_BLUE)
    body = body.output("ring", pressed, kind="light", material=ink, color=_BLUE)
    return body.attach(lid, hinge).at(_PIVOT / 2)


def _gas(
    width: ag.Scalar,
    height: ag.Scalar,
    press: ag.Scalar,
    finish: ag.Material,
    accent: ag.Material,
    maker: str,
    *,
    square: bool,
    clear: bool,
) -> ag.Body:
    """Make a gas lighter with a wheel in a hood, and a lever at the right."""
    deep = 0.0130
    level = height - 0.0200  # upper side of the tank [m]
    outline = ag.rectangle(width, deep, radius=0.0025) if square else ag.rectangle(width, deep, radius=0.0060)
    tank_finish = finish
    if clear:
        tint = tuple(0.5 * share + 0.35 for share in finish.base_color)
        tank_finish = finish.with_(
            name=f"{finish.name}_clear", base_color=tint, transmission_weight=0.7, opacity=0.55
        )
    tank_finish = casting(tank_finish, 0.62)
    tank = ag.extrude(outline, level - 0.0030, bevel=0.0010).at(z=(level + 0.0030) / 2)
    foot = ag.extrude(outline.offset(-0.0006), 0.0036, bevel=0.0006).at(z=0.0018)
    collar = ag.extrude(outline.offset(-0.0008), 0.0060).at(z=level + 0.0028)
    left, top = -width / 2 + 0.0010, height
    at = ag.vector(-0.0041, 0, top - 0.0080)
    hood_room = ag.Region((left, -0.0086), (-0.0052, 0.0052), (level + 0.0050, top - 0.0004))
    hood = hood_room.box(bevel=0.0010) - hood_room.shrink(0.0006, z=0).grow(z=0.01).box()
    sheet = 0.0007
    ears = [
        ag.Region((-0.0092, 0.0002), (y - sheet / 2, y + sheet / 2), (level + 0.0050, top - 0.0052)).box()
        for y in (-0.0052 + sheet / 2, 0.0052 - sheet / 2)
    ]
    axle = ag.cylinder(0.0009, 0.0102, axis=ag.Y).at(at)
    nozzle = ag.cylinder(0.0011, 0.0050, bevel=0.0003).at((left - 0.0086) / 2, 0, level + 0.0086)
    # the lever lies in a channel of the collar, and turns about its inner end
    channel = ag.Region((-0.0022, 0.02), (-0.0040, 0.0040), (level + 0.0004, level + 0.02))
    pivot = ag.vector(-0.0002, 0, level + 0.0046)
    body = ag.weld(
        ag.part(tank, "case", tank_finish, name="case"),
        ag.part(foot, "case", accent),
        ag.part(collar - channel.box(), "case", accent),
        ag.part([hood, *ears], "hood", _STEEL),
        ag.part(axle, "hood", _STEEL, separate="held by the ears of the hood"),
        ag.detail(nozzle, "nozzle", ag.material("brass")),
        details.printed(
            _logo(maker, 0.0028, 0.034).rotate(math.pi / 2),
            (0, -deep / 2, 0.46 * level),
            material=controls.ink_on(finish),
        ),
    )
    wheel, turn = _wheel(at, 0.0074)
    bar = ag.Region((-0.0016, width / 2 - 0.0004), (-0.0034, 0.0034), (level + 0.0036, level + 0.0056)).box()
    thumb = ag.Region((0.0018, width / 2 + 0.0002), (-0.0046, 0.0046), (level + 0.0082, level + 0.0104))
    web = ag.Region((0.0022, width / 2 - 0.0004), (-0.0034, 0.0034), (level + 0.0040, level + 0.0090)).box()
    touch = ag.push_on(thumb.box(), direction=-ag.Z, at=(width / 2 - 0.0030, 0, 0))
    ribs = [
        ag.box(0.0007, 0.0078, 0.0006).at(x=0.0042 + 0.0020 * number, z=level + 0.0105) for number in range(4)
    ]
    lever = ag.weld(
        ag.part([thumb.box(bevel=0.0007), web, bar], "lever", accent, name="lever", push=touch),
        ag.detail(ribs, "lever", accent),
    )
    arm = width / 2 - 0.003
    spring = ag.Spring(preload=0.45 * press * arm, force=press * arm)
    swing = ag.Revolute("lever_press", axis=ag.Y, pivot=pivot, limits=(0, 0.13), spring=spring, feel=_PRESS)
    gas = signals.pressed(swing)
    body = body.output("gas", gas, kind="flow").output("flame", _struck(turn, unless=~gas), kind="heat")
    return body.attach(wheel, turn).attach(lever, swing)


def _jet(width: ag.Scalar, height: ag.Scalar, press: ag.Scalar, finish: ag.Material, maker: str) -> ag.Body:
    """Make a lighter whose button at the right lights a jet and opens the lid at the left."""
    deep, half, travel = 0.0165, width / 2, 0.0050
    level = height - 0.0110  # upper side of the body [m]
    room = ag.Region((-half, half), (-deep / 2, deep / 2), (0, level))
    pocket = ag.Region(
        (0.0, half + 0.01), (-deep / 2 + 0.0020, deep / 2 - 0.0020), (level - 0.0110, level + 0.01)
    )
    key = ag.Region(
        (0.0006, half - 0.0008), (-deep / 2 + 0.0026, deep / 2 - 0.0026), (level - 0.0048, height)
    )
    button = ag.part(key.box(bevel=0.0018), "button", finish, push=ag.push_on(key.box(), direction=-ag.Z))
    ribs = [ag.box(0.0008, 0.0085, 0.0006).at(x, 0, height) for x in (0.0060, 0.0084, 0.0108, 0.0132)]
    button = ag.weld(button, ag.detail(ribs, "button", recess(finish)))
    spring = ag.Spring(preload=0.35 * press, force=press)
    slide = ag.Prismatic("button_slide", axis=-ag.Z, limits=(0, travel), spring=spring, feel=_PIEZO)
    top, low, x = height - 0.0012, level + 0.0006, -half + 0.0038
    barrel = ag.cylinder(0.0032, deep - 0.0012, axis=ag.Y, bevel=0.0006).at(x, 0, low + 0.0032)
    block = ag.Region((x, -0.0006), (-deep / 2 + 0.0006, deep / 2 - 0.0006), (low, top))
    flat = block.with_(x=(x + 0.0020, -0.0006)).box(bevel=0.0012)
    hollow = ag.Region((x + 0.0042, -0.0018), (-0.0052, 0.0052), (low - 0.01, top - 0.0014)).box()
    sheet = casting(finish.with_(name=f"{finish.name}_cap", density=6600.0), 0.9)
    lid = ag.part(ag.hull(barrel, flat) - hollow, "lid", sheet)
    hinge = ag.Revolute(
        "lid_hinge", axis=-ag.Y, pivot=(x, 0, low + 0.0032), follows=1.25 / travel * slide, armature=2e-6
    )
    middle = (x + 0.0042 - 0.0018) / 2
    nozzle = ag.tube(0.0040, 0.0026, 0.0052, bevel=0.0004).at(middle, 0, level + 0.0020)
    window = ag.Region(
        (-half + 0.005, -half + 0.008), (-deep / 2 - 0.0002, -deep / 2 + 0.001), (0.008, 0.026)
    )
    knob = ag.cylinder(0.0040, 0.0012, bevel=0.0003).at(-0.004, 0, 0.0004)
    body = ag.weld(
        ag.part(
            room.box(bevel=0.0024) - pocket.box(),
            "case",
            casting(finish.with_(density=6600.0), 0.30),
            name="case",
        ),
        ag.part(nozzle, "nozzle", ag.material("brass")),
        ag.detail(window.box(bevel=0.0004), "window", ag.material("tinted_glass")),
        ag.detail(knob, "wheel", ag.material("brass")),
        details.engraved(_logo(maker, 0.0026, 0.021), (0.004, -deep / 2, 0.38 * level), material=finish),
    )
    body = body.output("flame", signals.pressed(slide), kind="heat")
    return body.attach(button, slide).attach(lid, hinge).at(z=0.0002)  # on the knob of its gas


def _table(
    width: ag.Scalar, height: ag.Scalar, press: ag.Scalar, finish: ag.Material, *, square: bool
) -> ag.Body:
    """Make a table lighter, whose insert lifts out of its base and whose lever lifts the snuffer."""
    metal = ag.material("satin_brass" if finish.name in ("walnut", "green_marble", "brass") else "chrome")
    level, radius = height - 0.0260, 0.0125
    hole = (
        ag.Region.centered(2 * radius + 0.0014, 2 * radius + 0.0014, 0.0)
        .with_(z=(level - 0.034, height))
        .box()
    )
    if square:
        base = ag.Region.centered(width, width, 0.0).with_(z=(0, level)).box(bevel=0.0030)
    else:
        half = width / 2
        belly = [
            (0.70, 0.0),
            (0.80, 0.05),
            (0.89, 0.14),
            (0.955, 0.27),
            (0.99, 0.42),
            (1.0, 0.56),
            (0.985, 0.69),
        ]
        belly += [(0.94, 0.81), (0.865, 0.91), (0.765, 0.975), (0.68, 1.0)]
        line = [(0.0, 0.0), *((share * half, up * level) for share, up in belly), (0.0, level)]
        base = ag.revolve(ag.polygon(line))
    felt = ag.cylinder(0.32 * width, 0.0010).at(z=0.0003)
    ring = ag.tube(0.0205, 0.0150, 0.0016, bevel=0.0005).at(z=level + 0.0006)
    solid = casting(finish, 0.16 if finish.name == "brass" else 0.92)
    body = ag.weld(
        ag.part(base - hole, "base", solid, name="base"),
        ag.part(ring, "base", metal),
        ag.detail(felt, "base", ag.material("fabric").with_(name="felt", base_color=(0.03, 0.09, 0.05))),
    )
    tank = ag.extrude(ag.regular_polygon(16, radius), 0.0330).at(z=level - 0.0150)
    block = ag.Region((-0.0135, 0.0135), (-0.0072, 0.0072), (level + 0.0018, level + 0.0160))
    slot = ag.Region((-0.0006, 0.03), (-0.0027, 0.0027), (level + 0.0050, level + 0.03))
    ears = [
        ag.Region((-0.0028, 0.0028), (y - 0.0007, y + 0.0007), (level + 0.0150, level + 0.0222)).box(
            bevel=0.0005
        )
        for y in (-0.0054, 0.0054)
    ]
    nozzle = ag.cylinder(0.0022, 0.0050).at(-0.0082, 0, level + 0.0178)
    hold = ag.grasp_on(block.box(), approach=-ag.Z, closing=ag.Y, depth=0.0110)
    insert = ag.weld(
        ag.part(block.box(bevel=0.0014) - slot.box(), "insert", metal, name="insert", grasp=hold),
        ag.part(tank, "insert", casting(metal, 0.30)),
        ag.part(ears, "hinge", metal, separate="two ears on the block"),
        ag.part(nozzle, "wick", _WICK),
    )
    thumb = ag.Region((0.0152, 0.0300), (-0.0062, 0.0062), (level + 0.0162, level + 0.0186))
    arm = ag.Region((0.0004, 0.0172), (-0.0021, 0.0021), (level + 0.0110, level + 0.0150)).box()
    web = ag.Region((0.0152, 0.0172), (-0.0021, 0.0021), (level + 0.0110, level + 0.0170)).box()
    touch = ag.push_on(thumb.box(), direction=-ag.Z)
    lever = ag.part([thumb.box(bevel=0.0009), arm, web], "lever", metal, name="lever", push=touch)
    spring = ag.Spring(preload=0.4 * press * 0.021, force=press * 0.021)
    pivot = (0.0020, 0, level + 0.0130)
    swing = ag.Revolute("lever_press", axis=ag.Y, pivot=pivot, limits=(0, 0.30), spring=spring, feel=_PRESS)
    axis = ag.vector(0.0, 0, level + 0.0198)
    barrel = ag.cylinder(0.0022, 0.0088, axis=ag.Y).at(axis)
    bar = ag.Region((-0.0090, 0.0), (-0.0016, 0.0016), (level + 0.0206, level + 0.0226)).box()
    cap = ag.cylinder(0.0034, 0.0048, bevel=0.0008).at(-0.0082, 0, level + 0.0231)
    snuffer = ag.part([barrel, bar, cap], "snuffer", metal, name="snuffer")
    lift = ag.Revolute("snuffer_hinge", axis=ag.Y, pivot=axis, follows=4.0 * swing, armature=2e-6)
    insert = insert.attach(lever, swing).attach(snuffer, lift)
    out = ag.Prismatic("insert_lift", axis=ag.Z, limits=(0, 0.050), feel=_LIFT)
    body = body.output("flame", signals.pressed(swing), kind="heat")
    return body.attach(insert, out).at(z=0.0002)  # on its felt


def _stick(
    length: ag.Scalar,
    thick: ag.Scalar,
    press: ag.Scalar,
    finish: ag.Material,
    accent: ag.Material,
    maker: str,
) -> ag.Body:
    """Make a lighter for candles that lies on its side, with its trigger in front."""
    mid, travel = thick / 2, 0.0070
    rear, front = -length / 2, -length / 2 + 0.128
    line = [
        (rear, 0.004), (rear + 0.006, 0.0125), (rear + 0.030, 0.0140), (rear + 0.070, 0.0125),
        (front - 0.026, 0.0130), (front - 0.006, 0.0100), (front, 0.0050), (front, -0.0060),
        (front - 0.010, -0.0105), (front - 0.030, -0.0115), (front - 0.050, -0.0128), (rear + 0.040, -0.0150),
        (rear + 0.010, -0.0135), (rear, -0.0060),
    ]  # fmt: skip
    outline = ag.spline([(x, y, 0) for x, y in line], closed=True).profile()
    eye = ag.slot(0.0120, 0.0050).at(rear + 0.0130, 0.0)
    handle = ag.extrude(outline - eye, thick, bevel=0.0020).at(z=mid)
    x = front - 0.030  # of the trigger [m]
    well = ag.Region((x - 0.0094, x + 0.0094), (-0.03, -0.0020), (mid - 0.0049, mid + 0.0049)).box()
    reach = length / 2
    sheath = ag.cylinder(0.0046, reach - front + 0.012, axis=ag.X, bevel=0.0005).at(
        (reach + front - 0.012) / 2, 0, mid
    )
    mouth = ag.cylinder(0.0034, 0.0004, axis=ag.X).at(reach, 0, mid)
    nose = ag.frustum(0.0088, 0.0056, 0.016, axis=ag.X, bevel=0.0008).at(front + 0.005, 0, mid)
    slots = [
        ag.cylinder(0.0012, 0.0004).at(reach - 0.006 - 0.005 * number, 0, mid + 0.0046) for number in range(3)
    ]
    window = ag.extrude(ag.slot(0.026, 0.0055), 0.0004).at(rear + 0.058, 0.0050, thick)
    switch = ag.box(0.010, 0.0050, 0.0016, bevel=0.0005).at(front - 0.052, 0.0045, thick + 0.0003)
    tube = ag.material("black_steel").with_(name="tube_black")
    body = ag.weld(
        ag.part(handle - well, "case", casting(finish, 0.80), name="case"),
        ag.part(nose, "hood", accent),
        ag.part(sheath, "nozzle", casting(tube, 0.22)),
        ag.detail([mouth, *slots], "nozzle", recess(tube)),
        ag.detail(window, "window", ag.material("tinted_glass")),
        ag.detail(switch, "button", accent),
        details.printed(
            _logo(maker, 0.0040, 0.044), (rear + 0.058, -0.0050, thick), material=controls.ink_on(finish),
            facing=ag.Z, up=ag.Y,
        ),
    )  # fmt: skip
    key = ag.Region((x - 0.0090, x + 0.0090), (-0.0230, -0.0095), (mid - 0.0045, mid + 0.0045))
    touch = ag.push_on(key.box(), direction=ag.Y)
    trigger = ag.part(key.box(bevel=0.0018), "trigger", accent, push=touch)
    spring = ag.Spring(preload=0.35 * press, force=press)
    pull = ag.Prismatic("trigger_slide", axis=ag.Y, limits=(0, travel), spring=spring, feel=_PIEZO)
    return body.attach(trigger, pull).output("flame", signals.pressed(pull), kind="heat")
