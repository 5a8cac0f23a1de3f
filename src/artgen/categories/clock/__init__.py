"""A clock: on the wall, with two bells, in a wooden case with a pendulum, tall, or with digits.

Links: `case`; `hour_hand`, `minute_hand`, `second_hand`; `pendulum`; `door`, or `trunk_door` and `hood_door`
of a tall clock; `set_knob`, `alarm_knob`, `alarm_hand`, `key` and `hammer` with bells; `snooze` and
`button_0`, ... with digits. Joints: `hour_turn`, `minute_turn`, `second_turn`; `pendulum_swing`;
`door_hinge`, `trunk_door_hinge`, `hood_door_hinge`; `set_turn`, `alarm_turn`, `alarm_hand_turn`, `key_turn`,
`hammer_swing`; `snooze_slide`, `button_slide_0`, ....

At 0 the hands show the drawn time and doors are shut. Positive turns are clockwise from the front. The hour
hand follows the minute hand at a twelfth; with bells, a knob at the back leads both, and another one the
hand of the alarm. A pendulum hangs, and swings on for a while.

Sizes are those of shops: clocks for walls are 0.22-0.40 m across and weigh 0.4-2 kg, with rays up to 0.7 m;
clocks with two bells 0.10-0.13 m, 0.14-0.19 m high, 0.2-0.6 kg; mantel clocks 0.20-0.30 by 0.30-0.50 m, 2-5
kg; regulators 0.24-0.36 by 0.60-0.95 m, 4-10 kg; longcase clocks 0.42-0.54 by 1.75-2.2 m, 22-45 kg; alarm
clocks with digits 0.12-0.19 m wide, 0.15-0.6 kg.
"""

import math
from typing import Literal

import artgen as ag
from artgen import details, feel, signals
from artgen.categories.clock import cases
from artgen.categories.clock.faces import REACH, Face, Hands, Numerals
from artgen.categories.shared import controls, require_size, vessels
from artgen.categories.shared.finish import casting, colors
from artgen.nodes.details.displays import Color
from artgen.nodes.fitting import FIT

Style = Literal["wall", "bells", "mantel", "regulator", "longcase", "digital"]
"""A round or square clock for a wall, one with two bells, wooden ones for a shelf, for a wall or
that stand on the floor with a pendulum, or one with digits."""

_FRONT = REACH + 0.0050  # from the dial to the front of a rim [m]
_BACK = 0.016  # from the dial to the back of a clock for walls [m]
_DEEP = 0.030  # from the dial to the back of a clock with bells [m]
_SLOPE = 0.26 / math.hypot(0.26, 0.42)  # sine of the angle between a leg and the vertical
_SIDES = 24  # facets of the solid inside a rim
_LENS = ag.material("glass").with_(name="lens")
_PAPERS = {"white": (0.82, 0.82, 0.80), "cream": (0.72, 0.64, 0.48), "black": (0.02, 0.02, 0.022)}
_WOODS = ("walnut", "mahogany", "oak", "beech")
_METALS = ("satin_brass", "chrome", "brass", "black_steel", "copper")
_PLASTICS = colors("abs", "white black sage red navy graphite")
_CASES = ag.by(
    "style",
    wall=ag.shades(*_PLASTICS, "walnut", "oak", "brushed_aluminium", "satin_brass",
                   weights=(3, 3, 1, 1, 1, 1, 2, 2, 2, 1), color=0.04),
    bells=ag.shades(
        *colors("enamel", "white black sage red sky"), "satin_brass", "chrome", "copper", color=0.03
    ),
    digital=ag.shades(*_PLASTICS, "walnut", "oak", "beech", weights=(2, 3, 1, 1, 1, 1, 2, 2, 1), color=0.04),
    otherwise=ag.shades(*_WOODS, weights=(3, 2, 2, 1), color=0.06),
)  # fmt: skip
_CASED = ("mantel", "regulator", "longcase")
_RINGING = feel.Feel(friction=1e-3, damping=1e-3, armature=1e-5, effort=0.5)
_KNOB = feel.Feel(friction=0.01, damping=1e-3, armature=2e-5, effort=0.4)

_WIDTHS = {"wall": (0.17, 0.6), "mantel": (0.18, 0.6), "regulator": (0.22, 0.6), "longcase": (0.34, 0.6)}
_SLENDER = {"mantel": 1.35, "regulator": 2.0, "longcase": 3.9}
"""Possible widths [m], and least heights by the width: with room for the works and the pendulum."""


@ag.category(
    labels="case molding foot door glass hinge knob dial hand pendulum bob weight line ray bell hammer "
    "handle key button display print lens rating_plate screw bezel",
    joints=(2, 8),
)
def clock(
    *,
    style: Style = ag.choice(
        {"mantel": 0.15, "wall": 0.31, "bells": 0.15, "longcase": 0.10, "regulator": 0.13, "digital": 0.16}
    ),
    shape: Literal["round", "square", "bare", "rays", "block", "wedge"] = ag.by(
        "style",
        wall={"round": 0.45, "square": 0.2, "bare": 0.2, "rays": 0.15},
        digital={"block": 0.6, "wedge": 0.4},
        otherwise="round",
        doc="round or square with a lens; a disc with bare hands, alone or between rays; a block or a wedge",
    ),
    width: ag.Float = ag.by(
        "style",
        wall=ag.uniform(0.22, 0.38),
        bells=ag.uniform(0.096, 0.120),
        mantel=ag.uniform(0.20, 0.26),
        regulator=ag.uniform(0.24, 0.31),
        longcase=ag.uniform(0.40, 0.48),
        digital=ag.uniform(0.125, 0.185),
        unit="m",
        within=(0.09, 0.60),
        doc="of a clock with rays the diameter of its disc",
    ),
    slender: ag.Float = ag.by(
        "style",
        mantel=ag.uniform(1.45, 1.75),
        regulator=ag.uniform(2.4, 2.9),
        longcase=ag.uniform(4.1, 4.6),
        otherwise=1.0,
        within=(0.5, 5.0),
        doc="height of a wooden case by its width",
    ),
    time: ag.Float = ag.uniform(0.0, 12.0, "h", doc="time that the hands show", within=(0.0, 24.0)),
    digits: str = ag.choice("7:30", "10:08", "6:45", "12:00", "9:41", "23:59", doc="time on a display"),
    numerals: Numerals = ag.by(
        "style",
        wall={"arabic": 0.45, "bars": 0.3, "roman": 0.1, "quarters": 0.15},
        bells={"arabic": 0.8, "quarters": 0.2},
        otherwise={"roman": 0.75, "arabic": 0.25},
    ),
    hands: Hands = ag.by(
        "style",
        wall={"baton": 0.5, "sword": 0.3, "leaf": 0.2},
        bells={"spade": 0.4, "baton": 0.4, "leaf": 0.2},
        otherwise={"spade": 0.6, "leaf": 0.4},
    ),
    paper: Literal["white", "cream", "black"] = ag.by(
        "style",
        wall={"white": 0.65, "cream": 0.1, "black": 0.25},
        bells={"white": 0.55, "cream": 0.2, "black": 0.25},
        otherwise={"white": 0.5, "cream": 0.5},
        doc="color of the dial",
    ),
    top: cases.Top = ag.by(
        "style",
        mantel={"flat": 0.4, "arch": 0.4, "gable": 0.2},
        regulator={"flat": 0.3, "arch": 0.3, "gable": 0.4},
        otherwise={"flat": 0.3, "arch": 0.4, "gable": 0.3},
    ),
    seconds: bool = ag.by(
        "style", wall={True: 0.7, False: 0.3}, bells=ag.choice(True, False), otherwise=False
    ),
    keys: int = ag.by(
        "style", digital=ag.count(3, 5), otherwise=3, doc="keys at the back of a digital clock"
    ),
    color: Literal["red", "green", "cyan", "white", "amber"] = ag.choice(
        "red", "green", "cyan", "white", "amber"
    ),
    finish: ag.Material = _CASES,
    metal: ag.Material = ag.choice(*_METALS, weights=(3, 2, 2, 1, 1), doc="hands, bezels, knobs and bobs"),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a clock with its doors shut."""
    wide = require_size(width, _WIDTHS.get(style, (0.09, 0.6)), f"width of a {style} clock")
    if style in _SLENDER:
        least = _SLENDER[style]
        what = f"height of a {style} clock must be >= {least:g} times its width"
        slender = ag.require(slender, slender >= least, what)
    if style == "digital":
        return _digital(shape, wide, digits, keys, color, finish, maker)
    sheet = ag.material("powder_coat_white").with_(
        name=f"dial_{paper}", base_color=_PAPERS[paper], specular_roughness=0.5
    )
    ink = controls.ink_on(finish if shape in ("bare", "rays") else sheet)
    dark = ink == controls.DARK_INK
    share = {"wall": 0.43, "bells": 0.40}.get(style, 0.36)
    pointers = metal if style in _CASED else ag.material("black_steel" if dark else "chrome")
    face = Face(share * wide, numerals, hands, time, seconds, sheet, ink, pointers, maker)
    if style == "wall":
        return _wall(face, shape, wide / 2, finish, metal)
    if style == "bells":
        return _belled(face, wide / 2, finish, metal)
    deep = 0.24 if style == "longcase" else 0.125
    case = cases.Case(wide, slender * wide, deep, finish, metal, top, face)
    made = cases.longcase(case) if style == "longcase" else cases.small(case, hung=style == "regulator")
    return made.at(y=0.009 - deep / 2)


def _drum(radius: ag.Scalar, rim: float, back: float, finish: ag.Material, share: float) -> ag.Body:
    """Make a round case about its dial: a back, a rim and a lens."""
    block = ag.cylinder(radius - 0.0006, back - 0.0004, axis=ag.Y, bevel=0.002).at(y=back / 2 + 0.0002)
    tall = _FRONT + 0.004
    ring = vessels.hoop(radius - 0.0008, radius - rim, tall - 0.0030, _SIDES).rotate(ag.X, math.pi / 2)
    seen = ag.tube(radius, radius - rim - 0.0004, tall, axis=ag.Y, bevel=0.0022)
    shell = ag.tube(radius, radius - 0.004, back - 0.002, axis=ag.Y).at(y=back / 2)
    middle = (0.004 - _FRONT) / 2
    lens = ag.cylinder(radius - rim + 0.001, 0.0016, axis=ag.Y).at(y=0.004 - _FRONT)
    return ag.weld(
        ag.part([block, ring.at(y=middle)], "case", _light(finish, share), name="case"),
        ag.detail([seen.at(y=middle), shell], "case", finish),
        ag.part(lens, "lens", _LENS),
    )


def _light(finish: ag.Material, share: float) -> ag.Material:
    """Return the material of a hollow case: of metal, it is thin sheet."""
    return casting(finish, share * min(1.0, 1400.0 / finish.density))


def _square(half: ag.Scalar, rim: float, finish: ag.Material) -> ag.Body:
    """Make a square case about its dial."""
    whole = ag.Region((-half, half), (-_FRONT, _BACK), (-half, half))
    inner = whole.shrink(x=rim, z=rim)
    block = whole.with_(y=(0.0002, _BACK)).box(bevel=0.002)
    sides = [each.box(bevel=0.0012) for each in whole.with_(y=(-_FRONT, 0.001)).around(inner, lap=0.0004)]
    lens = inner.grow(x=0.001, z=0.001).with_(y=(0.0032 - _FRONT, 0.0048 - _FRONT)).box()
    return ag.weld(
        ag.part([block, *sides], "case", _light(finish, 0.3), name="case"), ag.part(lens, "lens", _LENS)
    )


def _wall(face: Face, shape: str, radius: ag.Scalar, finish: ag.Material, metal: ag.Material) -> ag.Body:
    """Make a clock for a wall, its lowest point on the floor."""
    rim, bare = 0.012, shape in ("bare", "rays")
    low = radius
    if not bare:
        body = _drum(radius, rim, _BACK, finish, 0.3) if shape == "round" else _square(radius, rim, finish)
        plate = face.disc(radius - rim + 0.0004)
        if shape == "square":
            side = 2 * (radius - rim + 0.0004)
            plate = ag.part(ag.box(side, 0.002, side).at(y=0.001), "dial", face.paper)
        body = ag.weld(body, plate, *face.printed())
    else:
        disc = ag.cylinder(radius, _BACK, axis=ag.Y, bevel=0.003).at(y=_BACK / 2)
        body = ag.weld(ag.part(disc, "case", _light(finish, 0.45), name="case"), *face.printed())
    if shape == "rays":
        low = 1.9 * radius
        rods = []
        for number in range(24):
            turn, far = math.tau * number / 24, (1.9 if number % 2 == 0 else 1.55)
            way = ag.vector(math.sin(turn), 0, math.cos(turn))
            start, end = (ag.vector(y=0.5 * _BACK) + share * radius * way for share in (0.96, far))
            rods.append(ag.cylinder_between(start, end, 0.0022 if number % 2 else 0.0030))
        body = ag.weld(body, ag.part(rods, "ray", metal))
    return face.with_hands(ag.weld(body, *_mount(radius)), (0, 0, 0)).at(
        0, ((0.0 if bare else _FRONT) - _BACK) / 2, low
    )


def _mount(radius: ag.Scalar) -> list[ag.Body]:
    """Make the back of a clock for walls: its works, a lid over the battery and the hole for a nail."""
    works = ag.rectangle(0.056, 0.056, radius=0.004) | ag.slot(0.05, 0.012).at(0, 0.040)
    hole = ag.circle(0.0045) | ag.rectangle(0.004, 0.010).at(0, 0.006)
    lid = ag.rectangle(0.020, 0.048, radius=0.002)
    at, black = (0, _BACK, 0), ag.material("black_abs")
    return [
        details.printed(works - lid.at(0.010), at, material=black, label="case", facing=ag.Y),
        details.printed(lid.at(0.010), at, material=ag.colored("abs", "graphite"), label="case", facing=ag.Y),
        details.printed(hole, (0, _BACK, 0.72 * radius), material=black, label="case", facing=ag.Y),
    ]


def _belled(face: Face, radius: ag.Scalar, finish: ag.Material, metal: ag.Material) -> ag.Body:
    """Make an alarm clock on two legs with two bells, with the knobs at its back."""
    rim = 0.006
    body = _drum(radius, rim, _DEEP, finish, 0.32)
    body = ag.weld(body, face.disc(radius - rim + 0.0004), *face.printed())
    sole = -1.16 * radius - 0.0042 * _SLOPE
    strut = ag.cylinder_between((0, _DEEP - 0.006, -0.8 * radius), (0, _DEEP - 0.006, sole), 0.0042)
    legs, bells, posts = [strut], [], []
    for side in (-1, 1):
        legs.append(
            ag.cylinder_between(
                (side * 0.52 * radius, -0.006, -0.74 * radius),
                (side * 0.78 * radius, -0.006, -1.16 * radius),
                0.0042,
            )
        )
        lean = ag.vector(side * math.sin(0.55), 0, math.cos(0.55))
        foot, head = 0.97 * radius, 1.20 * radius
        posts.append(
            ag.cylinder_between(lean * foot + ag.vector(y=0.006), lean * head + ag.vector(y=0.006), 0.003)
        )
        bell = ag.dome(0.52 * radius, height=0.32 * radius).rotate(ag.Y, side * 0.55)
        bells.append(bell.at(lean * (1.14 * radius) + ag.vector(y=0.006)))
    body = ag.weld(
        body,
        ag.part([*legs, *posts], "foot", casting(metal, 0.4)),
        ag.part(bells, "bell", casting(metal, 0.12)),
        _carrier(radius, metal),
        _plate(radius, face.maker),
    )
    body = _with_hammer(body, radius, metal)
    return _with_knobs(body, face).at(0, (_FRONT - _DEEP) / 2, -sole)


def _carrier(radius: ag.Scalar, metal: ag.Material) -> ag.Body:
    """Make the handle over the bells."""
    ends = [(-0.75 * radius, 0.006, 1.21 * radius), (-0.62 * radius, 0.006, 1.74 * radius)]
    line = [*ends, *((-x, y, z) for x, y, z in reversed(ends))]
    bow = ag.sweep(ag.regular_polygon(8, 0.0028), ag.polyline(line, fillet=0.25 * radius))
    return ag.part(ag.simplified_collider(bow, 0.0004), "handle", casting(metal, 0.4))


def _plate(radius: ag.Scalar, maker: str) -> ag.Body:
    """Make the plate at the back."""
    lines = (f"{maker} quartz", "1.5 V - AA", "Made to last")
    return details.rating_plate(
        0.6 * radius, 0.22 * radius, lines, at=(0, _DEEP, -0.62 * radius), facing=ag.Y
    )


def _with_hammer(body: ag.Body, radius: ag.Scalar, metal: ag.Material) -> ag.Body:
    """Add the hammer between the bells."""
    y, low = 0.006, radius + FIT.running
    rod = ag.box(0.0022, 0.003, 0.30 * radius).at(0, y, low + 0.15 * radius)
    head = ag.cylinder(0.0032, 0.010, axis=ag.X, bevel=0.0006).at(0, y, low + 0.30 * radius)
    hammer = ag.part(rod | head, "hammer", metal)
    swing = ag.Revolute(
        "hammer_swing", axis=ag.Y, pivot=(0, y, low), limits=(-0.12, 0.12), stiffness=0.06, rest=0.0,
        feel=_RINGING, driven="the ringing works",
    )  # fmt: skip
    return body.attach(hammer, swing)


def _with_knobs(body: ag.Body, face: Face) -> ag.Body:
    """Add the hands, the knobs that set them, and the key that winds the bells."""
    radius = face.radius
    set_turn = ag.Revolute("set_turn", axis=ag.Y, feel=_KNOB)
    alarm = ag.Revolute("alarm_turn", axis=ag.Y, feel=_KNOB)
    wind = ag.Revolute("key_turn", axis=-ag.Y, feel=_KNOB, friction=0.03)
    for name, joint, x in (("set_knob", set_turn, -0.48), ("alarm_knob", alarm, 0.48)):
        knob = controls.control_knob(
            finish=ag.material("black_abs"), style="fluted", radius=0.0075, depth=0.014, name=name
        )
        body = body.attach(knob.rotate(ag.Z, math.pi), joint, at=(x * radius, _DEEP, -0.25 * radius))
    wing = ag.Region((-0.0012, 0.0012), (0.010, 0.024), (-0.013, 0.013)).box(bevel=0.001)
    stem = ag.cylinder(0.0028, 0.011, axis=ag.Y).at(y=FIT.running + 0.0055)
    hold = ag.grasp_on(wing, approach=-ag.Y, closing=ag.X, depth=0.011)
    key = ag.part([wing, stem], "key", ag.material("satin_brass"), grasp=hold)
    body = body.attach(key, wind, at=(0, _DEEP, 0.55 * radius))
    return face.with_hands(face.with_alarm(body, alarm), (0, 0, 0), lead=set_turn)


def _digital(
    shape: str, wide: ag.Scalar, digits: str, keys: int, color: Color, finish: ag.Material, maker: str
) -> ag.Body:
    """Make an alarm clock with digits: a bar on top silences it, keys at its back set it."""
    high, deep = 0.46 * wide, 0.44 * wide
    lean = 0.0 if shape == "block" else 0.30
    room = ag.Region((-wide / 2, wide / 2), (-deep / 2, deep / 2), (0.0025, high))
    back = high * math.tan(lean)  # of the upper edge of the front
    y, z = room.y, room.z
    side = ag.polygon(
        [(y.low, z.low), (y.high, z.low), (y.high, z.high), (y.low + back, z.high)], radius=0.006
    )
    solid = ag.extrude(side, wide, axis=ag.X, bevel=0.002)
    stuff = finish.with_(name=f"{finish.name}_clock", density=420.0)
    facing = (0, -math.cos(lean), math.sin(lean))
    middle = y.low + back / 2
    pane = (0.86 * wide, 0.62 * high / math.cos(lean))
    name = details.logo(maker, 0.0032)
    ink, low = controls.ink_on(finish), 0.0065
    pads = [
        ag.cylinder(0.005, 0.003).at(a * 0.4 * wide, b * 0.36 * deep, 0.0015)
        for a in (-1, 1)
        for b in (-1, 1)
    ]
    body = ag.weld(
        ag.part(solid, "case", stuff, name="case"),
        ag.part(pads, "foot", ag.material("rubber")),
        details.display(digits, *pane, at=(0, middle + 0.004 * math.tan(lean), z.mid + 0.004), color=color,
                        facing=facing),
        details.printed(name, (0, y.low + (low - z.low) * math.tan(lean), low), material=ink, facing=facing),
    )  # fmt: skip
    black = ag.material("black_abs")
    bar = controls.push_button(
        finish=black, plate=black, through=0.012, shape="pill", width=0.40 * wide, height=0.016,
        travel=0.0025, name="snooze",
    )  # fmt: skip
    body = body.install(bar.rotate(ag.X, -math.pi / 2), at=(0, (y.low + back + y.high) / 2, z.high))
    key = controls.push_button(
        finish=black, plate=black, through=0.012, width=0.010, proud=0.0035, travel=0.002
    )
    for number, x in enumerate(controls.places(keys, 0.020)):
        body = body.install(key.rotate(ag.Z, math.pi).suffixed(f"_{number}"), at=(x, y.high, 0.55 * high))
    dimmed = signals.toggle(signals.pressed("snooze_slide"))
    figures = ag.material("display" if color == "cyan" else f"led_{color}")
    bright = ~dimmed | 0.25 * dimmed
    body = body.output("display", bright, kind="display", material=figures, color=figures.emission)
    if not keys:
        return body
    beep = controls.any_pressed(f"button_slide_{number}" for number in range(keys))
    return body.output("beep", beep, kind="sound")
