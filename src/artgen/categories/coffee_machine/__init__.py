"""A coffee machine: a filter machine with its jug, a capsule machine, or an espresso machine.

Links: `body`; `tank_lid`; `button_0`, ... from left to right. A filter machine has `jug` with `lid`, and
`basket`. A capsule machine has `lever`, `tank` and `drip_tray`. An espresso machine has `portafilter`,
`wand`, `steam`, the dial of the wand, and `drip_tray`. Joints: `tank_lid_hinge` and `button_slide_0`, ...;
`jug_slide`, `jug_lift`, `lid_hinge`, and `basket_turn` or `basket_lift`; `lever_turn`, `tank_lift`,
`drip_tray_slide`; `portafilter_turn`, `portafilter_lower`, `wand_turn`, `steam_turn`.

A jug slides out from under the basket before it lifts off, and its lid opens only there. A basket swings out
to the front, or lifts out under the open lid. A portafilter turns to the left before its ears pass the ledges
of the group: contact holds it up until then.

Sizes are those of shops. Filter machines for 8-12 cups (Melitta Easy and Look, Philips HD7461, Braun KF 47)
are 160-200 mm wide, 230-270 mm deep and 300-370 mm high and weigh 1.6-2.6 kg; their jugs hold 1.1-1.4 l.
Capsule machines (Nespresso Essenza and Inissia) are 85-135 mm wide, 290-340 mm deep, 205-260 mm high and
weigh 2.3-3 kg. Espresso machines (Gaggia Classic, Lelit Anna, De'Longhi Dedica) are 150-270 mm wide, 260-330
mm deep, 305-380 mm high and weigh 4-8 kg, with portafilters of 51-58 mm. A jug is filled by half.
"""

import math
from typing import Literal, NamedTuple

import artgen as ag
from artgen import details, feel, signals
from artgen.categories.shared import controls, vessels
from artgen.categories.shared.appliances import CLEAR, DARK, cord_stub, filled
from artgen.categories.shared.finish import casting
from artgen.categories.shared.shelves import open_box
from artgen.nodes.fitting import FIT, Fitting

Style = Literal["filter", "capsule", "espresso"]
"""A filter machine, a machine for capsules, or an espresso machine with a portafilter."""

Jug = Literal["glass", "thermal"]
"""A jug of glass, or one of steel that keeps coffee warm."""

Basket = Literal["swing", "lift"]
"""A basket on a hinge below the head, or one in the head under its lid."""

_FOOT = 0.004  # height of the feet [m]
_BASE = 0.042  # height of the base under a jug [m]
_COVER = 0.028  # height of the head above a basket that swings [m]
_GAP = 0.0012  # around lids, trays and tanks [m]
_SLACK = 0.0004  # rise of a jug under the basket [m]
_OUTLET = 0.0160  # from the head down to the end of the outlet of a basket [m]
_SKIRT = (0.0350, 0.0385)  # inner and outer radius of the group of an espresso machine [m]
_CUP = 0.0295  # radius of a portafilter [m]
_BLACK = ag.material("black_abs")
_STEEL = ag.material("stainless")
_RUBBER = ag.material("rubber")
_GLASS = ag.material("glass").with_(name="jug_glass", opacity=0.26)
_COFFEE = ag.material("polycarbonate").with_(
    name="coffee", base_color=(0.045, 0.016, 0.007), density=1000.0, specular_roughness=0.1, texture=""
)
_WATER = CLEAR.with_(name="water", base_color=(0.72, 0.84, 0.90), opacity=0.4, density=1000.0)
_PAPER = ag.material("cardboard").with_(name="filter_paper", base_color=(0.62, 0.48, 0.33), texture="")

_PLASTICS = ag.shades(
    {
        "black_abs": 2.0,
        "glossy_plastic_black": 1.0,
        **{ag.colored("glossy_plastic", name): 1.0 for name in ("white", "cream", "red", "sage", "graphite")},
    },
    color=0.04,
)
_VIVID = ag.shades(
    {
        "glossy_plastic_black": 2.0,
        "glossy_plastic_white": 1.5,
        **{ag.colored("glossy_plastic", name): 1.0 for name in ("red", "cream", "sky", "graphite", "orange")},
    },
    color=0.04,
)
_SHEETS = ag.shades(
    {
        "stainless": 3.0,
        "stainless_blasted": 1.0,
        **{ag.colored("enamel", name): 0.7 for name in ("black", "cream", "red", "mint", "white", "navy")},
    },
    color=0.03,
)
_JUG = feel.Feel(friction=0.2, damping=3.0, effort=60.0)
_BASKET = feel.Feel(friction=0.3, damping=2.0, effort=4.5)  # the stiff lid holds the basket down
_FILTER_TURN = feel.Feel(damping=0.05, effort=12.0, velocity=4.0)
_LOWERING = feel.Feel(friction=0.5, damping=4.0, effort=30.0)


class _Look(NamedTuple):
    """Finishes of a machine."""

    shell: ag.Material
    trim: ag.Material
    grip: ag.Material
    maker: str


@ag.category(
    labels="body foot cord print rating_plate bezel button display plate jug rim coffee lid handle basket "
    "hinge tank_lid tank water lever spout slot drip_tray grid group portafilter wand dial gauge rail",
    joints=(6, 9),
)
def coffee_machine(
    *,
    style: Style = ag.choice({"filter": 0.4, "capsule": 0.28, "espresso": 0.32}),
    jug: Jug = ag.by("style", filter={"glass": 0.6, "thermal": 0.4}, otherwise="glass"),
    basket: Basket = ag.by("style", filter={"swing": 0.55, "lift": 0.45}, otherwise="swing"),
    width: ag.Float = ag.by(
        "style",
        filter=ag.uniform(0.162, 0.198),
        capsule=ag.uniform(0.102, 0.134),
        espresso=ag.uniform(0.205, 0.265),
        unit="m",
        within=(0.10, 0.28),
    ),
    depth: ag.Float = ag.by(
        "style",
        filter=ag.uniform(0.236, 0.264),
        capsule=ag.uniform(0.290, 0.335),
        espresso=ag.uniform(0.280, 0.325),
        unit="m",
        doc="depth of the body",
        within=(0.23, 0.34),
    ),
    height: ag.Float = ag.by(
        "style",
        filter=ag.by("jug", glass=ag.uniform(0.306, 0.332), thermal=ag.uniform(0.342, 0.368)),
        capsule=ag.uniform(0.222, 0.256),
        espresso=ag.uniform(0.322, 0.376),
        unit="m",
        doc="height of the body",
        within=(0.21, 0.38),
    ),
    soft: ag.Float = ag.by(
        "style",
        espresso=ag.uniform(0.006, 0.016),
        otherwise=ag.uniform(0.012, 0.034),
        unit="m",
        doc="radius of the upright edges",
        within=(0.005, 0.036),
    ),
    belly: ag.Float = ag.uniform(0.30, 0.55, doc="height of the widest place of a jug, as a share"),
    narrow: ag.Float = ag.uniform(0.74, 0.88, doc="radius of the rim of a jug, as a share of the largest"),
    swing: ag.Float = ag.uniform(1.35, 1.7, "rad", doc="angle of a lever or of a basket that swings"),
    opens: ag.Float = ag.uniform(1.36, 1.50, "rad", doc="angle of the open lid of the tank"),
    lock: ag.Float = ag.uniform(0.80, 1.0, "rad", doc="turn of a portafilter"),
    torque: ag.Float = ag.by(
        "style",
        espresso=ag.uniform(1.5, 3.0),
        otherwise=ag.uniform(0.35, 0.7),
        unit="N m",
        doc="friction of the seal of a portafilter, or of a lever",
    ),
    press: ag.Float = ag.uniform(2.0, 4.0, "N", doc="force of the buttons"),
    cap: controls.ButtonShape = ag.choice("round", "round", "square", "pill"),
    knob: controls.DialStyle = ag.choice("fluted", "round", "capped", "skirted"),
    gauge: bool = ag.by("style", espresso={True: 0.5, False: 0.5}, otherwise=False),
    clock: str = ag.by("style", filter=ag.choice("", "", "7:00", "6:45"), otherwise="", doc="empty for none"),
    shell: ag.Material = ag.by("style", filter=_PLASTICS, capsule=_VIVID, espresso=_SHEETS),
    trim: ag.Material = ag.shades({"stainless": 3.0, "chrome": 1.5, "black_steel": 1.0}, color=0.03),
    grip: ag.Material = ag.by(
        "style", espresso=ag.choice("black_abs", "black_abs", "walnut", "beech"), otherwise="black_abs"
    ),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a coffee machine, ready: jug, capsule lever or portafilter in place."""
    least = {"filter": 0.28, "capsule": 0.21, "espresso": 0.32}[style]
    height = ag.require(height, height >= least, f"height of a machine for {style} must be >= {least:g} m")
    if style == "espresso":
        width = ag.require(width, width >= 0.18, "width of a machine for espresso must be >= 0.18 m")
    room = ag.Region.centered(width, depth, 0).with_(z=(_FOOT, height))
    look = _Look(shell, trim, grip, maker)
    match style:
        case "filter":
            body = _filter(room, soft, look, jug, basket, belly, narrow, swing, opens, clock)
            places: list[tuple[ag.Scalar, ag.Scalar]] = [(width / 2 - 0.030, _FOOT + 0.0195)]
            signs: tuple[str, ...] = ("power",)
        case "capsule":
            body = _capsule(room, soft, look, swing, opens, torque)
            places = [(x, height - 0.042) for x in (-0.0145, 0.0145)]
            signs = ("cup", "glass")
        case "espresso":
            body = _espresso(room, soft, look, lock, torque, opens, knob, gauge=gauge)
            signs = ("power", "cup") if gauge else ("power", "cup", "steam")
            places = [(0.032 + 0.028 * number - width / 2, height - 0.048) for number in range(len(signs))]
    for number, (sign, (x, z)) in enumerate(zip(signs, places, strict=True)):
        body = body.install(_button(cap, sign, press, trim).suffixed(f"_{number}"), at=(x, room.y.low, z))
    return _brewing(body, style, gauge=gauge)


def _brewing(body: ag.Body, style: Style, *, gauge: bool) -> ag.Body:
    """Let coffee run: into a jug in its place, through a capsule that is locked, or a portafilter."""
    key = [signals.pressed(f"button_slide_{number}") for number in range(3)]
    if style == "capsule":
        opened = signals.pressed("lever_turn", (0.0, 0.1))
        cups = signals.timer(key[0], 20.0, unless=opened) | signals.timer(key[1], 40.0, unless=opened)
        return body.output("coffee", cups, kind="flow")
    on = signals.toggle(key[0])
    body = body.output("heater", on, kind="heat")
    if style == "filter":
        away = signals.pressed("jug_slide", (0.0, 0.02))
        return body.output("coffee", signals.timer(on, 300.0, unless=~on) & ~away, kind="flow")
    steam = on if gauge else signals.toggle(key[2], unless=~on)
    body = body.output("coffee", signals.timer(key[1], 25.0, unless=~on), kind="flow")
    return body.output("steam", steam & signals.level("steam_turn"), kind="flow")


def _button(shape: controls.ButtonShape, icon: str, force: ag.Scalar, trim: ag.Material) -> Fitting:
    """Make a button with an icon in a thin plate."""
    wide, high = 0.0135, 0.0105
    return controls.push_button(
        finish=_BLACK, plate=trim, through=0.012, shape=shape, width=wide, height=high, force=force,
        icon=icon, ink=controls.LIGHT_INK,
    )  # fmt: skip


def _frame(room: ag.Region, soft: ag.Scalar, niche: ag.Region, look: _Look, density: float) -> ag.Body:
    """Make the outside with a niche in front, on feet, with a cord and a rating plate."""
    outline = ag.rectangle(room.x.size, room.y.size, radius=soft)
    solid = ag.extrude(outline, room.z.size, bevel=0.003).at(room.anchor())
    solid -= niche.grow(x=0.02, front=0.02).box()
    x, y = room.x.high - 0.026, room.y.high - 0.028
    foot = ag.cylinder(0.009, _FOOT + 0.002, bevel=0.0008).at(z=_FOOT / 2 + 0.001)
    feet = ag.array(foot, at=[(a * x, b * y, 0) for a in (-1, 1) for b in (-1, 1)])
    lines = (look.maker.upper(), "220-240 V~ 50/60 Hz", "1050-1260 W")
    plate = details.rating_plate(0.052, 0.020, lines, at=(0, room.y.high - 0.06, _FOOT), facing=-ag.Z)
    cord = cord_stub(height=0.024).at(-0.3 * room.x.size, room.y.high, 0.024)
    body = ag.part(solid, "body", filled(look.shell, density, "case"))
    return ag.weld(body, ag.part(feet, "foot", _RUBBER, separate="feet"), plate, cord)


def _signed(room: ag.Region, look: _Look, x: ag.Scalar, z: ag.Scalar) -> ag.Body:
    """Print the name of the maker on the front."""
    word = details.logo(look.maker, 0.0055)
    return details.printed(word, (x, room.y.low, z), material=controls.ink_on(look.shell))


def _tank_lid(
    cover: ag.Region, opens: ag.Scalar, finish: ag.Material, friction: float = 0.02
) -> tuple[Fitting, ag.Joint]:
    """Make a lid that is hinged at its back edge, with a bar near its front edge."""
    bar = ag.box(0.0095, 0.042, 0.0145, bevel=0.0025).at(0, cover.y.low + 0.030, cover.z.high + 0.0067)
    hold = ag.grasp_on(bar, approach=-ag.Z, closing=ag.X, depth=0.0095)
    lid = ag.weld(
        ag.part(bar, "tank_lid", finish, grasp=hold, name="tank_lid"),
        ag.part(cover.box(bevel=0.0016), "tank_lid", finish),
    )
    pivot = (0, cover.y.high, cover.z.low)
    hinge = ag.Revolute(
        "tank_lid_hinge", axis=-ag.X, pivot=pivot, limits=(0, opens), feel=feel.PIVOT, friction=friction
    )
    return Fitting.moving(lid, hinge), hinge


def _drip_tray(room: ag.Region, travel: ag.Scalar, finish: ag.Material, trim: ag.Material) -> Fitting:
    """Make a tray in its room with a grid on it, and a lip that a hand draws out."""
    wide, deep, high = room.size
    front = room.anchor(y=-1, z=-1)
    boards = [each.at(front) for each in open_box(wide, deep, high - 0.0022, wall=0.0024, front=0.004)]
    lip = ag.box(0.048, 0.0135, 0.0075, bevel=0.002).at(0, room.y.low - 0.0055, room.z.high - 0.0085)
    plate = room.shrink(x=0.001, front=0.004, back=0.002).with_(
        z=(room.z.high - 0.0030, room.z.high - 0.0008)
    )
    sole = plate.shrink(0.0004, top=0.0012, bottom=0)  # below the slots of the sheet, which is only seen
    outline = ag.rectangle(plate.x.size, plate.y.size, radius=0.003)
    slots = details.vent_slots(wide - 0.024, deep - 0.026, 11, slot=0.0040)
    sheet = ag.extrude(outline - slots, 0.0022).at(plate.anchor())
    hold = ag.grasp_on(lip, approach=ag.Y, closing=ag.Z, depth=0.0095)
    tray = ag.weld(
        ag.part(lip, "drip_tray", finish, grasp=hold, name="drip_tray"),
        ag.part(boards, "drip_tray", finish),
        ag.part(sole.box(), "grid", DARK.with_(name="grid_sole", density=2000.0)),
        ag.detail(sheet, "grid", trim),
    )
    slide = ag.Prismatic(
        "drip_tray_slide", axis=-ag.Y, limits=(0, travel), friction=0.6, damping=3.0, effort=30.0
    )
    hole = room.grow(_GAP, front=0.02, top=0.02)
    return Fitting.moving(tray, slide, cut=hole.box())


def _filter(
    room: ag.Region,
    soft: ag.Scalar,
    look: _Look,
    kind: Jug,
    basket: Basket,
    belly: ag.Scalar,
    narrow: ag.Scalar,
    swing: ag.Scalar,
    opens: ag.Scalar,
    clock: str,
) -> ag.Body:
    """Make a filter machine with its jug under the basket."""
    width, depth, _ = room.size
    height, front = room.z.high, room.y.low
    radius = ag.min_(width / 2 - 0.012, 0.068)
    column = depth - 2 * radius - 0.018
    middle = front + 0.008 + radius  # of the jug along y [m]
    rim = height - 0.196  # height of a jug up to its rim [m]
    head = _BASE + 0.0026 + rim + 0.0322  # lower end of the head [m]
    wall = room.y.high - column  # front of the tank [m]
    top = height - (_COVER if basket == "swing" else 0.0)
    niche = room.with_(y=(front, wall), z=(_BASE, top if basket == "swing" else head))
    body = _frame(room, soft, niche, look, 225.0)
    tank = room.shrink(x=0.010).with_(y=(wall + 0.010, room.y.high - 0.008), z=(_BASE + 0.03, height + 0.02))
    body = body.cut(tank.box())
    water = tank.shrink(x=-0.001, y=-0.001).with_(z=(_BASE + 0.028, _BASE + 0.10))
    plate = ag.cylinder(0.90 * radius, 0.0036, bevel=0.001).at(0, middle, _BASE + 0.0006)
    body = ag.weld(
        body,
        ag.detail(water.box(), "water", _WATER),
        ag.part(plate, "plate", ag.material("black_steel")),
        _signed(room, look, 0, height - 0.014 if basket == "swing" else (head + height) / 2),
    )
    pane = ag.slot(0.10, 0.011).rotate(math.pi / 2)
    level = ag.slot(0.050, 0.0085).rotate(math.pi / 2).at(0, -0.024)
    gauge = (room.x.high, wall + 0.4 * column, 0.12)
    body = ag.weld(
        body,
        details.printed(pane, gauge, material=DARK, facing=ag.X, label="water"),
        details.printed(level, gauge, material=_WATER, facing=ag.X, label="water", proud=0.0004),
    )
    if clock:
        body = ag.weld(
            body,
            details.display(
                clock, 0.034, 0.016, at=(0.034 - width / 2, front, _FOOT + 0.0195), color="green"
            ),
        )
    cup = ag.min_(radius - 0.004, 0.060)
    if basket == "swing":
        place = ag.Region((0, 0), (middle, wall), (head, top))
        body = body.install(_swinging(cup, place, look, swing))
        edges = (wall - 0.012, room.y.high - 0.001)
        cover = room.shrink(x=0.004).with_(y=edges, z=(height + FIT.running, height + 0.008))
        lid, _ = _tank_lid(cover, opens, casting(look.shell, 0.4))
        body = body.install(lid)
    else:
        body = _lifting(body, cup, room.with_(z=(head, height)), middle, look, opens)
    reach = 1.65 * cup + 0.016 if basket == "swing" else middle - front + 0.022
    clear = radius + reach
    slide = ag.Prismatic(
        "jug_slide", axis=-ag.Y, limits=(0, clear + 0.05), friction=1.2, damping=6.0, effort=60.0
    )
    out = slide > clear - 0.004
    lift = ag.Prismatic("jug_lift", axis=ag.Z, limits=(0, 0.12), feel=_JUG, needs=out.beyond(_SLACK))
    vessel = _jug(kind, radius, rim, belly, narrow, look, out)
    return body.attach(vessel, slide, lift, at=(0, middle, _BASE + 0.0026 + FIT.running))


def _jug(
    kind: Jug,
    radius: ag.Scalar,
    high: ag.Scalar,
    belly: ag.Scalar,
    narrow: ag.Scalar,
    look: _Look,
    free: ag.Condition,
) -> ag.Body:
    """Make a jug about z on z = 0 with its handle to the front and a lid that a thumb opens."""
    rim = narrow * radius
    if kind == "glass":
        path = ag.polyline(
            [
                (0.84 * radius, 0, 0),
                (radius, 0, 0.2 * high),
                (radius, 0, (0.2 + belly / 2) * high),
                (rim, 0, high),
            ],
            fillet=0.014,
        )
        wall, level = 0.0026, 0.56 * high
        coffee = vessels.filled(path, wall=wall, level=level - 0.0003)
        vessel = ag.weld(
            vessels.blown(path, "jug", _GLASS, foot=0.84 * radius, wall=wall, level=level),
            ag.part(ag.bounding_collider(coffee), "coffee", _COFFEE),
        )
    else:
        runs: list[vessels.Run] = [
            [(0.90 * radius, 0), (0.93 * radius, 0.003)],
            [(0.93 * radius, 0.003), (0.93 * radius, (0.35 + belly / 2) * high)],
            [(0.93 * radius, (0.35 + belly / 2) * high), (rim, 0.90 * high), (0.86 * rim, high)],
        ]
        vessel = vessels.turned(runs, "jug", look.trim.with_(name="jug_steel", density=820.0), sides=20)
    band = ag.cylinder(rim + 0.0016, 0.013, bevel=0.0016).at(z=high - 0.0005)
    if kind == "glass":
        band = band - ag.extrude(ag.regular_polygon(14, 0.86 * rim), 0.03).at(z=high)
    out = radius + 0.046
    line = [(0, -rim + 0.004, high - 0.002), (0, -out, high - 0.002), (0, -out + 0.008, 0.20 * high)]
    bar = ag.sweep(ag.rectangle(0.022, 0.014, radius=0.005), ag.polyline(line, fillet=0.016))
    hold = ag.grasp_on(bar, approach=ag.Y, closing=ag.X, at=(0, -out + 0.004, 0.55 * high), depth=0.012)
    dark = casting(_BLACK, 0.85)
    vessel = ag.weld(
        vessel, ag.part(bar, "handle", dark, grasp=hold, name="jug"), ag.part(band, "rim", look.trim)
    )
    low, axle = high + 0.006 + FIT.running, -rim - 0.006
    disc = ag.cylinder(rim - 0.002, 0.008, bevel=0.002).at(z=low + 0.004)
    tongue = ag.Region((-0.008, 0.008), (axle, -rim + 0.012), (low + 0.0012, low + 0.0070)).box()
    thumb = ag.box(0.014, 0.0065, 0.021, bevel=0.0015).at(0, axle, low + 0.0115)
    pinch = ag.grasp_on(thumb, approach=-ag.Z, closing=ag.X, depth=0.0095)
    lid = ag.weld(
        ag.part(thumb, "lid", dark, grasp=pinch, name="lid"),
        ag.part(disc | tongue, "lid", casting(_BLACK, 0.6)),
    )
    ears = [
        ag.Region((x - 0.0025, x + 0.0025), (axle - 0.004, axle + 0.006), (high - 0.006, low + 0.008)).box()
        for x in (-0.0112, 0.0112)
    ]
    hinge = ag.Revolute(
        "lid_hinge",
        axis=ag.X,
        pivot=(0, axle, low + 0.004),
        limits=(0, 1.1),
        feel=feel.PIVOT,
        friction=0.008,
        effort=0.1,
        needs=free.beyond(0.003),
    )
    return vessel.install(Fitting.moving(lid, hinge, fixed=ag.part(ears, "hinge", dark)))


def _cup(radius: ag.Scalar, end: ag.Scalar, low: ag.Scalar, high: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make a round basket about z between two heights, with paper in it and an outlet to its end below."""
    outline: vessels.Run = [(radius - 0.003, low), (radius, low + 0.003)]
    runs: list[vessels.Run] = [outline, [(radius, low + 0.003), (radius, high)]]
    well = ag.extrude(ag.regular_polygon(10, 0.94 * radius), high).at(z=low + 0.006 + high / 2)
    skin = ag.tube(radius, radius - 0.0024, high - low - 0.0034).at(z=(low + high) / 2 + 0.0015)
    paper = ag.frustum(0.40 * radius, 0.89 * radius, high - low - 0.016) - ag.frustum(
        0.38 * radius, 0.88 * radius, high - low - 0.014
    )
    outlet = ag.cylinder(0.009, low - end + 0.002, bevel=0.0008).at(z=(low + end) / 2 + 0.001)
    return ag.weld(
        ag.part([vessels.core(runs) - well, outlet], "basket", finish, name="basket"),
        ag.detail(skin, "basket", finish),
        ag.detail(paper.at(z=(low + high) / 2 + 0.001), "basket", _PAPER),
    )


def _swinging(radius: ag.Scalar, place: ag.Region, look: _Look, swing: ag.Scalar) -> Fitting:
    """Make a basket under the head that swings out to the front about its left side."""
    low, high, middle = place.z.low + 0.002, place.z.high - 0.0018, place.y.low
    finish = casting(look.shell, 0.7)
    cup = _cup(radius, place.z.low - _OUTLET, low, high, finish).at(0, middle, 0)
    tab = ag.box(0.013, 0.018, 0.034, bevel=0.003).at(0, middle - radius - 0.0075, (low + high) / 2)
    hold = ag.grasp_on(tab, approach=ag.Y, closing=ag.X, depth=0.012)
    axle = (-radius - 0.002, middle + 0.5 * radius, (low + high) / 2)
    lug = ag.Region(
        (axle[0] - 0.004, -0.78 * radius), (axle[1] - 0.008, axle[1] + 0.006), (low + 0.01, high - 0.004)
    )
    cup = ag.weld(
        cup, ag.part(tab, "handle", look.trim, grasp=hold), ag.part(lug.box(bevel=0.002), "hinge", finish)
    )
    joint = ag.Revolute(
        "basket_turn", axis=-ag.Z, pivot=axle, limits=(0, swing), friction=0.06, damping=0.02, effort=8.0
    )
    pin = ag.cylinder(0.0026, 0.012).at(axle[0], axle[1], place.z.high - 0.004)
    return Fitting.moving(cup, joint, fixed=ag.detail(pin, "hinge", look.trim))


def _lifting(
    body: ag.Body, radius: ag.Scalar, head: ag.Region, middle: ag.Scalar, look: _Look, opens: ag.Scalar
) -> ag.Body:
    """Add a basket in the head, and the lid over it and over the tank."""
    low, high = head.z.low + 0.008, head.z.high - 0.0051
    dark = casting(_BLACK, 0.7)
    bar = ag.box(1.86 * radius, 0.009, 0.014, bevel=0.002).at(z=high - 0.002)
    hold = ag.grasp_on(bar, approach=-ag.Z, closing=ag.Y, depth=0.0095)
    cup = ag.weld(
        _cup(radius, head.z.low - _OUTLET, low, high, dark), ag.part(bar, "handle", dark, grasp=hold)
    )
    cover = head.shrink(x=0.002, y=0.002).with_(z=(head.z.high + FIT.running, head.z.high + 0.012))
    lid, hinge = _tank_lid(cover, opens, casting(look.shell, 0.4), friction=0.8)
    lift = ag.Prismatic(
        "basket_lift", axis=ag.Z, limits=(0, 0.11), feel=_BASKET, needs=(hinge > 1.1).beyond(0.0004)
    )
    well = ag.extrude(ag.regular_polygon(12, radius + 0.0045), 0.3).at(z=low + 0.1475)
    well |= ag.box(0.024, 0.024, 0.04).at(z=low - 0.01)
    return body.install(lid).install(Fitting.moving(cup, lift, cut=well), at=(0, middle, 0))


def _capsule(
    room: ag.Region, soft: ag.Scalar, look: _Look, swing: ag.Scalar, opens: ag.Scalar, torque: ag.Scalar
) -> ag.Body:
    """Make a capsule machine: a tank that lifts off behind, a lever on the head, a tray in front."""
    front, back, height = room.y.low, room.y.high, room.z.high
    head, floor = height - 0.092, 0.038
    bay = room.with_(y=(back - 0.084, back), z=(0.026, height + 0.01))
    stand = room.with_(y=(front, front + 0.104), z=(floor, head))
    body = _frame(room, ag.min_(soft, 0.02), stand, look, 330.0).cut(bay.grow(x=0.01, back=0.01).box())
    slot = ag.Region.centered(0.040, 0.044, 0).at(y=front + 0.056).with_(z=(height - 0.032, height + 0.01))
    body = body.cut(slot.box())
    bottom = slot.grow(x=0.0005, y=0.0005).with_(z=(height - 0.0325, height - 0.0315))
    spout = ag.hull(
        ag.box(0.040, 0.034, 0.010, bevel=0.003).at(0, front + 0.052, head + 0.001),
        ag.box(0.018, 0.014, 0.006, bevel=0.002).at(0, front + 0.052, head - 0.019),
    )
    body = ag.weld(
        body,
        ag.detail(bottom.box(), "slot", DARK),
        ag.part(spout, "spout", look.trim.with_(name="spout_metal", density=1500.0)),
        _signed(room, look, 0, height - 0.070),
    )
    tray = ag.Region((0.010 - room.x.high, room.x.high - 0.010), (front, front + 0.098), (0.0075, floor))
    body = body.install(_drip_tray(tray, 0.075, _BLACK, look.trim))
    # the lever: a plate with a lip in front, on a barrel between two ears
    axle, low = front + 0.118, height + 0.0018
    half = room.x.high - 0.014
    barrel = ag.cylinder(0.0075, 2 * half - 0.022, axis=ag.X, bevel=0.001).at(0, axle, height + 0.0105)
    plate = ag.Region((-half, half), (front - 0.014, axle - 0.012), (low, low + 0.013)).box(bevel=0.004)
    neck = ag.Region((0.012 - half, half - 0.012), (axle - 0.020, axle), (low + 0.002, low + 0.012)).box()
    hold = ag.grasp_on(plate, approach=ag.Y, closing=ag.Z, depth=0.0095)
    lever = ag.weld(
        ag.part(plate, "lever", casting(look.trim, 0.12), grasp=hold, name="lever"),
        ag.part(neck | barrel, "lever", casting(_BLACK, 0.8)),
    )
    ear = ag.Region((half - 0.0085, half), (axle - 0.009, axle + 0.010), (height - 0.003, height + 0.019))
    drag = feel.Feel(friction=torque, damping=0.02, effort=8.0)
    raise_ = ag.Revolute(
        "lever_turn", axis=-ag.X, pivot=(0, axle, height + 0.0105), limits=(0, swing), feel=drag
    )
    ears = ag.part(
        [ear.box(bevel=0.002), ear.mirror().box(bevel=0.002)], "hinge", look.shell, separate="ears"
    )
    body = body.install(Fitting.moving(lever, raise_, fixed=ears))
    return body.install(_tank(bay.shrink(x=0.003, front=_GAP, bottom=_GAP), height - 0.022, opens))


def _tank(bay: ag.Region, top: ag.Scalar, opens: ag.Scalar) -> Fitting:
    """Make a clear tank with water, a rib behind as its grip, and its lid."""
    room = bay.with_(z=(bay.z.low, top))
    boards = [each.at(room.anchor(y=-1, z=-1)) for each in open_box(*room.size)]
    water = room.shrink(x=0.0034, y=0.0036, bottom=0.0040).with_(z=(room.z.low + 0.0040, room.z.at(0.55)))
    rib = ag.Region(
        (-0.006, 0.006), (room.y.high - 0.001, room.y.high + 0.021), (room.z.at(0.3), room.z.at(0.72))
    )
    bar = rib.box(bevel=0.002)
    hold = ag.grasp_on(bar, approach=-ag.Y, closing=ag.X, depth=0.014)
    far = room.z.size + 0.03
    lift = ag.Prismatic("tank_lift", axis=ag.Z, limits=(0, far), friction=0.5, damping=3.0, effort=60.0)
    cover = room.with_(z=(top + FIT.running, top + 0.009))
    lid, _ = _tank_lid(cover, opens, casting(_BLACK, 0.9))
    tank = ag.weld(
        ag.part(bar, "handle", _BLACK, grasp=hold, name="tank"),
        ag.part(boards, "tank", CLEAR),
        ag.part(water.box(), "water", _WATER),
    )
    return Fitting.moving(tank.install(lid), lift)


def _espresso(
    room: ag.Region,
    soft: ag.Scalar,
    look: _Look,
    lock: ag.Scalar,
    torque: ag.Scalar,
    opens: ag.Scalar,
    knob: controls.DialStyle,
    *,
    gauge: bool,
) -> ag.Body:
    """Make an espresso machine with its portafilter locked, its handle to the front."""
    front, height, half = room.y.low, room.z.high, room.x.high
    head, floor, deep = height - 0.100, 0.070, 0.122
    niche = room.with_(y=(front, front + deep), z=(floor, head))
    body = _frame(room, soft, niche, look, 370.0)
    tray = ag.Region((0.014 - half, half - 0.014), (front, front + deep - 0.010), (0.020, floor))
    body = body.install(
        _drip_tray(tray, 0.09, casting(look.shell, 0.25) if look.shell.density > 3000 else _BLACK, look.trim)
    )
    well = ag.Region(
        (0.024 - half, half - 0.024), (room.y.high - 0.094, room.y.high - 0.014), (0.10, height + 0.01)
    )
    body = body.cut(well.box())
    water = well.grow(x=0.001, y=0.001).with_(z=(0.098, height - 0.07))
    cover = well.grow(x=0.006, y=0.006).with_(z=(height + FIT.running, height + 0.0075))
    lid, _ = _tank_lid(cover, opens, casting(_BLACK, 0.9))
    body = ag.weld(body, ag.detail(water.box(), "water", _WATER), _signed(room, look, 0, head + 0.018))
    rail = ag.polyline(
        [
            (x * (half - 0.016), y, height + 0.018)
            for x, y in (
                (-1, room.y.high - 0.115),
                (-1, front + 0.016),
                (1, front + 0.016),
                (1, room.y.high - 0.115),
            )
        ],
        fillet=0.014,
    )
    posts = [
        ag.cylinder(0.0026, 0.021).at(x * (half - 0.016), y, height + 0.008)
        for x in (-1, 1)
        for y in (front + 0.045, room.y.high - 0.12)
    ]
    body = ag.weld(
        body.install(lid),
        ag.detail([details.bent_wires(rail, 0.0028, at=((0, 0, 0),)), *posts], "rail", look.trim),
    )
    if gauge:
        body = ag.weld(body, _gauge(look.trim).at(0, front, height - 0.048))
    turn = controls.dial_turn("steam_turn", low=0, high=4.5, friction=0.06)
    band = controls.dial_print(0.019, ink=controls.ink_on(look.shell), style="band", sweep=4.5, start=0)
    steam = controls.dial(turn, knob, 0.019, look.grip, depth=0.022, cap=look.trim, scale=band, name="steam")
    body = body.install(steam, at=(half - 0.036, front, height - 0.048))
    body = body.install(_wand(look.trim), at=(half - 0.030, front + 0.046, head))
    return body.install(_portafilter(look, lock, torque), at=(0, front + 0.058, head))


def _gauge(trim: ag.Material) -> ag.Body:
    """Make a pressure gauge on the plane y = 0, which is only seen."""
    face = ag.material("abs").with_(name="gauge_face", base_color=(0.80, 0.79, 0.75), texture="")
    ring = ag.tube(0.0175, 0.0150, 0.005, axis=ag.Y, bevel=0.001).at(y=-0.001)
    disc = ag.cylinder(0.0155, 0.002, axis=ag.Y).at(y=-0.0003)
    scale = details.dial_scale(0.0085, 13, major_every=3, length=0.0014, major_length=0.0024)
    hand = details.pointer(-0.003, 0.0095, 0.0011).rotate(1.7)
    return ag.weld(
        ag.detail(ring, "gauge", trim),
        ag.detail(disc, "gauge", face),
        details.printed(scale, (0, -0.0013, 0), material=controls.DARK_INK),
        details.printed(hand, (0, -0.0015, 0), material=ag.material("led_red"), label="gauge"),
    )


def _wand(trim: ag.Material) -> Fitting:
    """Make the pipe of a steam wand below the head, which turns outward."""
    line = ag.polyline([(0, 0, -0.010), (0, 0, -0.030), (0, -0.034, -0.128)], fillet=0.012)
    pipe = ag.sweep(ag.regular_polygon(8, 0.0042), line)
    way = ag.vector(0, -0.034, -0.098)
    start, end = ag.vector(0, 0, -0.030) + way * 0.15, ag.vector(0, 0, -0.030) + way * 0.66
    sleeve = ag.sweep(ag.rectangle(0.015, 0.015, radius=0.004), ag.line(start, end))
    tip = ag.cylinder_between(
        ag.vector(0, -0.034, -0.128), ag.vector(0, -0.0383, -0.1405), 0.0052, bevel=0.001
    )
    ball = ag.sphere(0.0105).at(z=-0.0105 - FIT.running)
    hold = ag.grasp_on(sleeve, approach=ag.Y, closing=ag.X, depth=0.008)
    wand = ag.weld(
        ag.part(
            sleeve,
            "wand",
            ag.material("silicone").with_(name="wand_rubber", base_color=(0.02, 0.02, 0.02)),
            grasp=hold,
            grasp_width=0.026,
            name="wand",
        ),
        ag.part([pipe, ball, tip], "wand", trim),
    )
    turn = ag.Revolute("wand_turn", axis=ag.Z, limits=(0, 1.4), friction=0.12, damping=0.01, effort=4.0)
    return Fitting.moving(wand, turn)


def _portafilter(look: _Look, lock: ag.Scalar, torque: ag.Scalar) -> Fitting:
    """Make the group below the head with two ledges, and the portafilter with its ears over them."""
    inner, outer = _SKIRT
    low = -0.022
    ring = ag.regular_polygon(12, outer) - ag.regular_polygon(12, inner + 0.0006)
    skirt = ag.extrude(ring, 0.023).at(z=low + 0.0115)
    skin = ag.tube(outer + 0.0004, inner - 0.0006, 0.0225, bevel=0.001).at(z=low + 0.0115)
    ledge = ag.Region((0.0305, 0.0365), (-0.010, 0.010), (low + 0.001, low + 0.0052))
    group = ag.weld(
        ag.part([skirt, ledge.box(), ledge.mirror().box()], "group", look.trim),
        ag.detail(skin, "group", look.trim),
    )
    top, foot = low + 0.0165, low - 0.026
    cup = ag.extrude(ag.regular_polygon(20, _CUP), top - foot).at(z=(top + foot) / 2)
    cup -= ag.extrude(ag.regular_polygon(12, 0.0245), 0.03).at(z=low + 0.007)
    shell = ag.tube(_CUP + 0.0003, 0.0250, top - foot - 0.0006, bevel=0.001).at(z=(top + foot) / 2)
    dish = ag.dome(_CUP - 0.001, height=0.008, axis=-ag.Z).at(z=foot + 0.0004)
    ear = ag.Region((0.026, 0.0327), (-0.007, 0.007), (low + 0.006, low + 0.0105))
    pipes = [
        ag.cylinder_between((x / 2, 0, foot - 0.003), (x, 0, foot - 0.020), 0.0048) for x in (-0.012, 0.012)
    ]
    level = low - 0.011
    neck = ag.cylinder_between((0, -0.024, level), (0, -0.056, level - 0.002), 0.0065)
    grip = ag.cylinder_between((0, -0.052, level - 0.0018), (0, -0.160, level - 0.009), 0.0138, bevel=0.004)
    hold = ag.grasp_on(grip, approach=ag.Y, closing=ag.X, depth=0.022)
    heavy = look.trim.with_(name="portafilter_metal", density=8200.0)
    filter_ = ag.weld(
        ag.part(grip, "handle", look.grip, grasp=hold, grasp_width=0.036, name="portafilter"),
        ag.part([cup, ear.box(), ear.mirror().box(), neck, *pipes], "portafilter", heavy),
        ag.detail([shell, dish], "portafilter", look.trim),
    )
    turn = ag.Revolute("portafilter_turn", axis=-ag.Z, limits=(0, lock), friction=torque, feel=_FILTER_TURN)
    lower = ag.Prismatic(
        "portafilter_lower", axis=-ag.Z, limits=(0, 0.05), feel=_LOWERING, needs=(turn > 0.65).beyond(0.0004)
    )
    return Fitting.moving(filter_, turn, lower, fixed=group)
