"""A toaster oven with a door that drops, or an air fryer with a drawer for its basket, or with two.

Links: `body`; `dial_0`, ... from top to bottom, or from left to right. A toaster oven has `door`, `rack` and
`crumb_tray`, an air fryer has `drawer` and `basket`, one with two drawers has `_left` and `_right` behind
these names. Joints: `dial_turn_0`, ...; `door_hinge`, `rack_slide`, `crumb_tray_slide`; `drawer_slide`,
`basket_lift`, with the same suffixes.

The door stays at any angle: a spring carries it, and friction holds it. The rack slides out over the open
door; the crumb tray slides out below it. The basket lifts out of a drawer that is out. Dials click: the
functions at their icons, temperatures and minutes at their numbers; a first dial that turns without clicks is
a timer.

Sizes are those of shops. Toaster ovens for 4-6 slices (Breville BOV650 and BOV800, Cuisinart TOB-60,
Panasonic NB-G110) are 390-480 mm wide, 290-370 mm deep and 230-290 mm high and weigh 5-10 kg. Air fryers
(Philips HD9252 and HD9270, Cosori L501, Ninja AF100) hold 3.8-6.2 l, are 240-310 mm wide, 300-400 mm deep
with the handle and 280-340 mm high and weigh 4.2-6 kg; those with two drawers (Ninja AF300, Philips NA352)
are 380-420 mm wide and weigh 7.5-9 kg. Rotary switches click at 0.02-0.06 N m (catalogs of
appliance switches).
"""

import math
from typing import Literal, NamedTuple

import artgen as ag
from artgen import details, feel, signals
from artgen.categories.shared import controls
from artgen.categories.shared.appliances import DARK, cord_stub, filled, grip_metals
from artgen.categories.shared.baskets import rack_slide
from artgen.categories.shared.finish import casting, colors
from artgen.categories.shared.fixings import corner_feet
from artgen.categories.shared.pulls import BarStyle, bar_handle
from artgen.categories.shared.shelves import open_box
from artgen.nodes.fitting import FIT, Fitting

Style = Literal["oven", "fryer", "dual"]
"""A toaster oven with a door that drops, or an air fryer with one drawer or with two side by side."""

Look = Literal["stainless", "dark_steel", "white", "black", "pastel"]
"""Families of finishes."""

_THICK = 0.017  # thickness of a door [m]
_SEAL = 0.0025  # gap between a closed door and the case [m]
_WALL = 0.016  # distance from the sides to the cavity [m]
_TRAY = (0.0075, 0.016)  # bottom of the crumb tray above that of the case, and height of its front [m]
_AXLE = 0.040  # height of the axis of a door above the bottom of the case [m]
_ROD = 0.0027  # radius of the rods of a rack [m]
_SWEEP = 4.7  # turn of a dial [rad]
_FIRST = 0.5  # turn of a dial from off to its first position [rad]
_FLAT = 0.031  # half of the width of the flat front and back of a round air fryer [m]
_FUNCTIONS = ("bread", "bagel", "grill", "hot_air", "heat_both", "pizza")
_LINING = ag.material("steel").with_(
    name="oven_lining", base_color=(0.30, 0.30, 0.30), specular_roughness=0.5, texture=""
)
_CHROME = ag.material("chrome").with_(name="rack_chrome", density=15000.0)  # with the visual-only wires
_TUBE = ag.material("frosted_glass").with_(name="quartz_tube", base_color=(0.72, 0.66, 0.60))
_NONSTICK = ag.colored("enamel", "anthracite").with_(name="nonstick", density=1500.0)

_METAL = grip_metals("stainless", "dark_steel", "white", "black", "pastel")
_CAPS = ag.shades("black_abs", ag.colored("abs", "light_grey"), color=0.03)
_FINISH = ag.by(
    "look",
    stainless=ag.shades("stainless", "stainless_across", color=0.03),
    dark_steel=ag.shades(
        ag.material("stainless").with_(name="black_stainless", base_color=(0.105, 0.105, 0.110)), color=0.03
    ),
    white=ag.shades("glossy_plastic_white", ag.colored("abs", "cool_white"), color=0.03),
    black=ag.shades("black_abs", "glossy_plastic_black", ag.colored("abs", "graphite"), color=0.03),
    pastel=ag.shades(*colors("glossy_plastic", "cream mint red sage sky navy"), color=0.04),
)
_BASKET = feel.Feel(friction=0.4, damping=3.0, effort=40.0)


class _Dials(NamedTuple):
    """Dials of a machine."""

    style: controls.DialStyle
    radius: ag.Scalar  # [m]
    torque: ag.Scalar  # of their clicks [N m]
    knob: ag.Material
    metal: ag.Material
    ink: ag.Material


@ag.category(
    labels="body cavity foot cord vent rating_plate panel print element rail door window handle rack "
    "crumb_tray dial drawer basket trim",
    joints=(4, 8),
)
def toaster_oven(
    *,
    style: Style = ag.choice({"oven": 0.52, "fryer": 0.34, "dual": 0.14}),
    look: Look = ag.by(
        "style",
        oven={"stainless": 2.5, "dark_steel": 1.0, "white": 0.8, "black": 1.2, "pastel": 0.9},
        otherwise={"white": 1.0, "black": 2.0, "pastel": 1.3, "dark_steel": 0.6},
    ),
    form: Literal["block", "round"] = ag.by("style", fryer=ag.choice("block", "round"), otherwise="block"),
    dials: int = ag.by("style", oven={3: 0.6, 4: 0.4}, fryer=2, dual=4),
    width: ag.Float = ag.by(
        "style",
        oven=ag.uniform(0.405, 0.475),
        fryer=ag.uniform(0.250, 0.300),
        dual=ag.uniform(0.380, 0.420),
        unit="m",
        within=(0.24, 0.50),
    ),
    depth: ag.Float = ag.by(
        "style",
        oven=ag.uniform(0.285, 0.335),
        otherwise=ag.uniform(0.285, 0.330),
        unit="m",
        doc="depth of the case",
        within=(0.27, 0.36),
    ),
    height: ag.Float = ag.by(
        "style",
        oven=ag.by("dials", {3: ag.uniform(0.240, 0.275), 4: ag.uniform(0.268, 0.292)}),
        otherwise=ag.by("form", block=ag.uniform(0.290, 0.335), round=ag.uniform(0.285, 0.320)),
        unit="m",
        within=(0.23, 0.35),
    ),
    soft: ag.Float = ag.by(
        "style",
        oven=ag.uniform(0.006, 0.022),
        otherwise=ag.uniform(0.022, 0.040),
        unit="m",
        doc="radius of the edges of the case, unless it is round",
        within=(0.004, 0.045),
    ),
    panel: ag.Float = ag.uniform(0.088, 0.102, "m", doc="width of the panel with the dials of an oven"),
    swing: ag.Float = ag.uniform(1.47, 1.54, "rad", doc="angle of the open door", within=(1.45, 1.56)),
    travel: ag.Float = ag.uniform(0.60, 0.75, doc="travel of the rack, as a share of its depth"),
    pull: ag.Float = ag.uniform(4.0, 7.0, "N", doc="friction of the rack and of the drawer"),
    bar: BarStyle = ag.choice("round", "square", "bow", "strap", "arched"),
    knob: controls.DialStyle = ag.choice("round", "fluted", "bar", "skirted", "capped"),
    radius: ag.Float = ag.uniform(0.0165, 0.0205, "m", doc="radius of the dials", within=(0.015, 0.022)),
    torque: ag.Float = ag.uniform(0.02, 0.05, "N m", doc="torque of the clicks"),
    finish: ag.Material = _FINISH,
    metal: ag.Material = _METAL,
    cap: ag.Material = _CAPS,
    watts: int = ag.by(
        "style",
        oven=ag.choice(1500, 1650, 1800),
        fryer=ag.choice(1400, 1500, 1700),
        dual=ag.choice(2400, 2700),
    ),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a toaster oven or an air fryer, closed."""
    ink = controls.ink_on(finish)
    made = _Dials(knob, radius, torque, cap, metal, ink)
    lines = (f"{maker.upper()} {watts // 10}", f"220-240 V~ 50/60 Hz {watts} W")
    foot = 0.012
    ag.require(style == "fryer" or form == "block", "form=round is for style=fryer")
    if style == "dual":
        width = ag.require(width, width >= 0.35, "width of a dual fryer must be >= 0.35 m")
    elif form == "round":
        width = ag.require(width, width <= 0.32, "width of a round fryer must be <= 0.32 m")
    room = ag.Region((-width / 2, width / 2), (-depth / 2, depth / 2), (foot, height))
    if style != "oven":
        return _fryer(
            room, soft, finish, made, pull, lines, maker, dual=style == "dual", rounded=form == "round"
        )
    return _oven(room, soft, finish, made, panel, dials, swing, travel, pull, bar, lines, maker)


def _backed(room: ag.Region, lines: tuple[str, ...], side: int, *, rounded: bool = False) -> ag.Body:
    """Make feet, cord and rating plate; on a round case above each other."""
    back, low = room.y.high, room.z.low + (0.044 if rounded else 0.028)
    inset, x, up = (0.056, 0.0, 0.095) if rounded else (0.03, side * 0.3 * room.x.size, 0.05)
    at = (0.0 if rounded else -0.06, back, room.z.low + up)
    return ag.weld(
        corner_feet(room.x.size, room.y.size, inset=inset, height=room.z.low).at(0, room.y.mid, 0),
        cord_stub(height=low).at(x, back, low),
        details.rating_plate(0.058, 0.024, lines, at=at, facing=ag.Y),
    )


def _dial(
    made: _Dials, number: int, kind: str, *, count: int = 6, icons: tuple[str, ...] = _FUNCTIONS
) -> Fitting:
    """Make a dial with its scale: of functions, of temperatures, or a timer that does not click."""
    steps = len(icons) if kind == "functions" else count
    clicks = (0.0, *(_FIRST + (_SWEEP - _FIRST) * step / (steps - 1) for step in range(steps)))
    turn = controls.dial_turn(
        f"dial_turn_{number}",
        low=0.0,
        high=_SWEEP,
        friction=0.012 if kind != "timer" else 0.045,
        clicks=clicks if kind != "timer" else (),
        torque=made.torque,
    )
    sweep = _SWEEP - _FIRST
    if kind == "functions":
        scale = details.dial_icons(icons, made.radius + 0.0085, 0.0068, sweep=sweep, start=_FIRST)
        ring = details.printed(scale, material=made.ink)
    else:
        form: controls.DialScale = "numbers" if kind == "numbers" else "ticks"
        ring = controls.dial_print(
            made.radius, ink=made.ink, style=form, count=count, sweep=sweep, start=_FIRST, height=0.0036
        )
    return controls.dial(
        turn,
        made.style,
        made.radius,
        made.knob,
        depth=0.020,
        cap=made.metal,
        scale=ring,
        name=f"dial_{number}",
    )


def _oven(
    room: ag.Region,
    soft: ag.Scalar,
    finish: ag.Material,
    made: _Dials,
    panel: ag.Scalar,
    dials: int,
    swing: ag.Scalar,
    travel: ag.Scalar,
    pull: ag.Scalar,
    bar: BarStyle,
    lines: tuple[str, ...],
    maker: str,
) -> ag.Body:
    """Make a toaster oven: case, panel with dials, door, rack and crumb tray."""
    front, low = room.y.low, room.z.low
    split = room.x.high - panel
    face = low + _AXLE - 0.004  # lower edge of the door
    cavity = room.with_(x=(room.x.low + _WALL, split - 0.010), y=(front, room.y.high - 0.022)).with_(
        z=(low + _AXLE + 0.002, room.z.high - 0.022)
    )
    tray = room.with_(x=cavity.x, y=(front, cavity.y.high - 0.01)).with_(
        z=(low + _TRAY[0], low + _TRAY[0] + _TRAY[1])
    )
    outline = ag.rectangle(room.x.size, room.z.size, radius=soft)
    case = ag.extrude(outline, room.y.size, axis=ag.Y, bevel=0.002).at(room.anchor())
    case -= cavity.grow(front=0.02).box().paint(_LINING)
    case -= tray.grow(0.0012, front=0.02).box().paint(DARK)
    stuff = filled(finish, 390.0, "case")
    body = ag.weld(ag.part(case, "body", stuff), _backed(room, lines, -1))
    plate = ag.Region(
        (split + 0.003, room.x.high - 0.006),
        (front - 0.0005, front + 0.001),
        (low + 0.010, room.z.high - 0.010),
    )
    black = ag.material("black_glass")
    dark = controls.ink_on(finish) is controls.DARK_INK
    if dark:  # a dark panel on bright cases
        made = made._replace(ink=controls.LIGHT_INK)
        sheet = details.relief(plate.front(radius=0.006), (0, front, 0), proud=controls.PANE, sunk=0.0006)
        body = ag.weld(body, ag.detail(sheet, "panel", black))
    plane = front - (controls.PANE if dark else 0.0)
    kinds = {3: ("numbers", "functions", "timer"), 4: ("numbers", "functions", "ticks", "timer")}[dials]
    cells = plate.shrink(bottom=0.016, top=0.004).rows(dials)[::-1]
    for number, (kind, cell) in enumerate(zip(kinds, cells, strict=True)):
        body = body.install(_dial(made, number, kind), at=(cell.x.mid, plane, cell.z.mid))
    word = details.logo(maker, 0.0042)
    body = ag.weld(
        body,
        details.printed(word, (plate.x.mid, plane, plate.z.low + 0.009), material=made.ink),
        _inside(cavity),
    )
    body = ag.weld(body, _vents(room))
    # door
    leaf = ag.Region(
        (room.x.low + 0.003, split - 0.001),
        (front - _SEAL - _THICK, front - _SEAL),
        (face, room.z.high - 0.004),
    )
    door, hinge = _door(leaf, low + _AXLE, finish, made.metal, bar, swing)
    body = body.attach(door, hinge)
    # rack
    level = cavity.z.at(0.34)
    body = ag.weld(body, _rails(cavity, level))
    grid = cavity.shrink(x=0.004, front=0.018, back=0.006)
    slide = rack_slide(
        "rack_slide",
        travel=travel * grid.y.size,
        friction=pull,
        damping=5.0,
        needs=(hinge > 1.40).beyond(0.0055),
    )
    body = body.attach(_rack(grid, level), slide)
    out = ag.min_(0.62 * tray.y.size, leaf.z.size - 0.072)  # up to the handle of the open door [m]
    runs = _turned(2) if dials == 3 else _turned(2) | _turned(3)  # for the minutes of toast, or of the timer
    heat = signals.level("dial_turn_0") & _turned(1) & runs
    return body.install(_crumb_tray(tray, made.knob, out)).output("heat", heat, kind="heat", material=_TUBE)


def _turned(number: int) -> signals.Signal:
    """Return the signal that a dial is not at its off."""
    return signals.pressed(f"dial_turn_{number}", (0.0, _FIRST))


def _vents(room: ag.Region) -> ag.Body:
    """Print the vents of both sides and of the back, which are only seen."""
    slots = details.vent_slots(0.10, 0.030, 9, slot=0.0045)
    z = room.z.at(0.72)
    at = [(ag.X, (room.x.high, room.y.at(0.62), z)), (-ag.X, (room.x.low, room.y.at(0.62), z))]
    at.append((ag.Y, (0.0, room.y.high, z)))
    return ag.weld(
        *(details.printed(slots, place, material=DARK, facing=way, label="vent") for way, place in at)
    )


def _inside(cavity: ag.Region) -> ag.Body:
    """Make the heating tubes at the ceiling and at the floor, which are only seen."""
    tube = ag.cylinder(0.0048, cavity.x.size + 0.002, axis=ag.X)
    places = [
        (cavity.x.mid, cavity.y.at(share), z)
        for z in (cavity.z.high - 0.016, cavity.z.low + 0.014)
        for share in (0.30, 0.70)
    ]
    return ag.detail(ag.array(tube, at=places), "element", _TUBE)


def _rails(cavity: ag.Region, level: ag.Scalar) -> ag.Body:
    """Make the ledges of a rack at both sides of the cavity."""
    ledge = cavity.with_(
        x=(cavity.x.low - 0.0005, cavity.x.low + 0.0085),
        z=(level - _ROD - 0.0046, level - _ROD - FIT.running),
    )
    ledge = ledge.shrink(front=0.012, back=-0.0005)
    other = ledge.at(cavity.x.size - 0.008)
    return ag.part([ledge.box(), other.box()], "rail", _LINING, separate="they are pressed into the walls")


def _rack(room: ag.Region, level: ag.Scalar) -> ag.Body:
    """Make a wire rack with a tab; its straight rods collide, the wires between them are only seen."""
    x, y, _ = room.size
    wires = details.wire_rack(x, y, pitch=0.021, wire=0.0013, frame=_ROD, corner=0.010, supports=1)
    across = ag.cylinder(_ROD - 0.0002, x - 0.020, axis=ag.X)
    along = ag.cylinder(_ROD - 0.0002, y - 0.020, axis=ag.Y)
    rods = [across.at(y=side * (y / 2 - _ROD)) for side in (-1, 0, 1)]
    rods += [along.at(side * (x / 2 - _ROD)) for side in (-1, 1)]
    tab = ag.box(0.0095, 0.0165, 0.0120, bevel=0.002).at(y=-y / 2 - 0.0055)
    hold = ag.grasp_on(tab, approach=ag.Y, closing=ag.X, depth=0.0105)
    welded = "rods of a rack are joined by the bent ones, which are only seen"
    rack = ag.weld(
        ag.part(tab, "rack", ag.material("stainless"), name="rack", grasp=hold),
        ag.part(rods, "rack", _CHROME, separate=welded),
        ag.detail(wires, "rack", _CHROME),
    )
    return rack.at(room.x.mid, room.y.mid, level)


def _door(
    leaf: ag.Region, axle: ag.Scalar, finish: ag.Material, metal: ag.Material, bar: BarStyle, swing: ag.Scalar
) -> tuple[ag.Body, ag.Joint]:
    """Make a door of glass in a frame, hinged at its lower edge, with a bar across its top."""
    view = leaf.shrink(x=0.026, bottom=0.024, top=0.048).with_(y=leaf.y)
    outline = leaf.front(radius=0.006) - view.front(radius=0.008)
    frame = ag.extrude(outline, _THICK, axis=ag.Y, bevel=0.0018).at(y=leaf.y.mid)
    pane = view.grow(x=0.003, z=0.003).with_(y=(leaf.y.high - 0.0045, leaf.y.high - 0.001))
    glass = ag.material("tinted_glass").with_(name="oven_glass", base_color=(0.09, 0.09, 0.095), opacity=0.5)
    grip: ag.Body = bar_handle(
        length=0.72 * leaf.x.size, finish=metal, style=bar, level=True, projection=0.032, girth=0.0062
    )
    door = ag.weld(
        ag.part(frame, "door", filled(finish, 900.0, "door"), name="door"),
        ag.part(pane.box(), "window", glass),
        grip.at(leaf.x.mid, leaf.y.low, leaf.z.high - 0.024),
    )
    arm = 0.55 * leaf.z.size
    moment = door.weight() * arm
    at = (leaf.x.mid, leaf.y.high - 0.004, axle)
    drag = feel.Feel(friction=0.45 * moment, damping=0.3, effort=9.0, velocity=4.0)
    hinge = ag.Revolute(
        "door_hinge", axis=ag.X, pivot=at, limits=(0, swing), stiffness=0.75 * moment, rest=-0.25, feel=drag
    )
    return door, hinge


def _crumb_tray(room: ag.Region, finish: ag.Material, travel: ag.Scalar) -> Fitting:
    """Make the crumb tray with a lip that a hand draws out."""
    wide, deep, high = room.size
    tin = ag.material("steel").with_(name="tray_tin", density=3000.0)
    corner = room.anchor(y=-1, z=-1)
    front, *walls = open_box(wide, deep, high, wall=0.0026, front=0.004, floor=0.0026)
    lip = ag.box(0.060, 0.0140, 0.0080, bevel=0.002).at(room.x.mid, room.y.low - 0.0060, room.z.mid)
    hold = ag.grasp_on(lip, approach=ag.Y, closing=ag.Z, depth=0.0095)
    tray = ag.weld(
        ag.part([lip, front.at(corner)], "crumb_tray", finish, grasp=hold, name="crumb_tray"),
        ag.part([each.at(corner) for each in walls], "crumb_tray", tin),
    )
    slide = ag.Prismatic(
        "crumb_tray_slide", axis=-ag.Y, limits=(0, travel), friction=1.0, damping=3.0, effort=25.0
    )
    return Fitting.moving(tray, slide)


def _fryer(
    room: ag.Region,
    soft: ag.Scalar,
    finish: ag.Material,
    made: _Dials,
    pull: ag.Scalar,
    lines: tuple[str, ...],
    maker: str,
    *,
    dual: bool,
    rounded: bool,
) -> ag.Body:
    """Make an air fryer: a soft case, dials above a drawer or two, a basket in each."""
    front, low, half = room.y.low, room.z.low, room.x.high
    top = room.z.at(0.60)  # of the drawer
    soft, edge = (half - _FLAT, 0.026) if rounded else (soft, ag.min_(0.008, 0.9 * soft))
    outline = ag.rectangle(room.x.size, room.y.size, radius=soft)
    case = ag.extrude(outline, room.z.size, bevel=edge).at(room.anchor())
    side = half - (0.034 if rounded else soft + 0.003)
    bay = ag.Region((-side, side), (front, room.y.high - 0.045), (low + (0.030 if rounded else 0.014), top))
    bays = bay.columns(2, gap=0.024) if dual else [bay]
    for each in bays:
        case -= each.grow(front=0.02).box().paint(DARK)
    body = ag.weld(
        ag.part(case, "body", filled(finish, 270.0, "case")),
        _backed(room, lines, 1, rounded=rounded),
        _grille(room, 0.056 if rounded else 0.09),
    )
    high = room.z.at(0.80)
    word = details.printed(details.logo(maker, 0.0050), (0, front, room.z.high - 0.032), material=made.ink)
    body = ag.weld(body, word)
    across = (-0.130, -0.056, 0.056, 0.130) if dual else (-0.047, 0.047)
    for number, x in enumerate(across):  # on top of a round case: in front, the hand would strike the handle
        place = ag.vector(x, room.y.at(0.40), room.z.high) if rounded else ag.vector(x, front, high)
        kind, sign = (("numbers", "thermometer"), ("ticks", "timer"))[number % 2]
        mark = details.icon(sign, 0.0085).at(0.0, -made.radius - 0.0125)
        dial, facing = _dial(made, number, kind, count=8), -ag.Y
        if rounded:
            dial, facing = dial.rotate(ag.X, -math.pi / 2), ag.Z
        body = body.install(dial, at=place)
        body = ag.weld(body, details.printed(mark, place, facing=facing, material=made.ink))
    for number, (each, suffix) in enumerate(zip(bays, ("_left", "_right") if dual else ("",), strict=True)):
        drawer = _drawer(each, finish, made, pull, _Bow(front, soft) if rounded else None)
        body = body.install(drawer.suffixed(suffix) if suffix else drawer)
        heat = signals.level(f"dial_turn_{2 * number}") & _turned(2 * number + 1)
        closed = ~signals.pressed(f"drawer_slide{suffix}", (0.0, 0.03))
        body = body.output(f"heat{suffix}", heat & closed, kind="heat")
    return body


class _Bow(NamedTuple):
    """The front of a round case, seen from above: flat in the middle, then around two corners."""

    front: ag.Scalar  # position of the flat middle along y [m]
    radius: ag.Scalar  # of the corners [m]

    def angle(self, half: ag.Scalar, more: ag.Scalar) -> ag.Scalar:
        """Return the angle at which a line before the front is half of a width away from the middle [rad]."""
        sine = (half - _FLAT) / (self.radius + more)
        return ag.atan2(sine, ag.sqrt(1.0 - sine * sine))

    def line(self, end: ag.Scalar, more: ag.Scalar) -> list[tuple[ag.Scalar, ag.Scalar]]:
        """Return the corners of a line before the front, from left to right [m]."""
        turns, out = [end * step / 8 for step in range(9)], self.radius + more
        right = [(_FLAT + out * ag.sin(a), self.front + self.radius - out * ag.cos(a)) for a in turns]
        return [*((-x, y) for x, y in reversed(right)), *right]


def _grille(room: ag.Region, width: float) -> ag.Body:
    """Print the outlet of air behind, which is only seen."""
    slots = details.vent_slots(width, 0.05, 8, slot=0.005, direction="horizontal")
    place = (0, room.y.high, room.z.at(0.72))
    return details.printed(slots, place, material=DARK, facing=ag.Y, label="vent")


def _drawer(bay: ag.Region, finish: ag.Material, made: _Dials, pull: ag.Scalar, bow: _Bow | None) -> Fitting:
    """Make the drawer: a pan behind a front with a handle, and the basket that lifts out of it.

    The front is flat, or follows the round case.
    """
    gap, thick = 0.0024, 0.018 if bow is None else 0.009
    pan = bay.shrink(gap, front=-0.002)
    deep = pan.y.size
    face = pan.with_(y=(bay.y.low - thick, bay.y.low - 0.0012)).grow(x=0.010, z=0.006)
    fronts: list[ag.Solid]
    if bow is None:
        fronts = [ag.extrude(face.front(radius=0.012), face.y.size, axis=ag.Y, bevel=0.005).at(y=face.y.mid)]
        box = pan.with_(y=(face.y.high - 0.002, pan.y.high)).shrink(top=0.006)
    else:
        behind, half = bay.y.low + 0.040, pan.x.high  # the pan begins where the case bends away from it
        end = bow.angle(face.x.high, thick)
        shell = ag.polygon([*bow.line(end, thick), *reversed(bow.line(end, 0.0012))])
        inner = bow.line(bow.angle(half, 0.0015), 0.0015)
        block = ag.polygon([*inner, (half, behind), (-half, behind)])
        fronts = [
            ag.extrude(shell, face.z.size, bevel=0.0025).at(z=face.z.mid),
            ag.extrude(block, pan.z.size).at(z=pan.z.mid),
        ]
        box = pan.with_(y=(behind - 0.002, pan.y.high)).shrink(top=0.006)
    walls = [each.at(box.anchor(y=-1, z=-1)) for each in open_box(*box.size, wall=0.0028, floor=0.0028)]
    # the handle: a beam out of the front with a soft end
    reach = 0.085
    z = face.z.at(0.60)
    beam = ag.Region((-0.015, 0.015), (face.y.low - reach, face.y.low + 0.002), (z - 0.013, z + 0.013))
    beam = beam.at(x=face.x.mid)
    grip = ag.grasp_on(beam.box(bevel=0.007), approach=ag.Y, closing=ag.Z, depth=0.040)
    strip = beam.shrink(x=0.009, front=0.010).with_(z=(beam.z.high - 0.001, beam.z.high + 0.0006))
    drawer = ag.weld(
        ag.part(
            beam.box(bevel=0.007), "handle", casting(ag.material("black_abs"), 0.8), grasp=grip, name="drawer"
        ),
        ag.detail(strip.box(), "trim", made.metal),
        ag.part(fronts, "drawer", filled(finish, 800.0, "front")),
        ag.part(walls, "drawer", _NONSTICK),
    )
    travel = deep + 0.040
    slide = ag.Prismatic(
        "drawer_slide", axis=-ag.Y, limits=(0, travel), friction=pull, damping=8.0, effort=60.0
    )
    inside = box.shrink(x=0.006, front=0.007, back=0.006, bottom=0.012, top=-0.004)
    free = (slide > deep + 0.024).beyond(0.002)
    lift = ag.Prismatic("basket_lift", axis=ag.Z, limits=(0, box.z.size + 0.02), feel=_BASKET, needs=free)
    return Fitting.moving(drawer.attach(_basket(inside), lift), slide)


def _basket(room: ag.Region) -> ag.Body:
    """Make the basket with holes in its floor and a bar across its top."""
    wide, deep, high = room.size
    corner = room.anchor(y=-1, z=-1)
    front, floor, *walls = open_box(wide, deep, high, wall=0.0026, front=0.0026, floor=0.0026)
    bar = ag.box(wide - 0.001, 0.0095, 0.014, bevel=0.002).at(room.x.mid, room.y.mid, room.z.high - 0.0075)
    hold = ag.grasp_on(bar, approach=-ag.Z, closing=ag.Y, depth=0.0095)
    holes = details.vent_slots(0.82 * wide, 0.78 * deep, 13, slot=0.006)
    film = details.printed(holes, (room.x.mid, room.y.mid, room.z.low + 0.0029), facing=ag.Z, material=DARK)
    sides = details.vent_slots(0.72 * wide, 0.5 * high, 11, slot=0.005)
    rear = details.printed(sides, (room.x.mid, room.y.high - 0.0026, room.z.mid - 0.006), material=DARK)
    return ag.weld(
        ag.part(bar, "handle", ag.material("black_abs"), grasp=hold, name="basket"),
        ag.part([each.at(corner) for each in (front, floor, *walls)], "basket", _NONSTICK),
        film,
        rear,
    )
