"""A keyboard: a pad of macros, a numeric pad, or a keyboard of 61, 87 or 104 keys.

Links: `case`; `key_0`, ..., row by row from the back at the left; `knob`, which sets the volume; `foot_0` and
`foot_1` below the rear edge. Joints: `key_press_0`, ...; `knob_turn` without limits; `foot_hinge_0` and
`foot_hinge_1`, 0 where the feet are folded into the underside.

Springs return the keys. The knob clicks; the feet snap to their ends.

Sizes are those of makers' data sheets: keys have a pitch of 19.05 mm; mechanical ones travel 4 mm and close
with 0.45-0.65 N, flat ones 2 mm. Full keyboards are 0.43-0.46 m by 0.13-0.17 m and weigh 0.7-1.1 kg with tall
caps and 0.4-0.6 kg with flat ones, those without a numeric pad 0.36-0.38 m and 0.33-0.95 kg, of 60 %
0.29-0.31 m and 0.22-0.55 kg; numeric pads 0.085-0.1 m and 0.07-0.2 kg; pads of macros 0.13-0.2 kg.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details, feel, signals
from artgen.categories.shared import controls, keypads
from artgen.categories.shared.finish import colors
from artgen.nodes.fitting import Fitting

Style = Literal["macro", "numeric", "small", "compact", "full"]
"""A pad of twelve keys, a numeric pad, a keyboard of 61 keys, without a numeric pad, or with one."""

Caps = Literal["tall", "flat"]
"""Tall caps that taper, of a mechanical keyboard, or flat ones."""

_U = 0.01905  # pitch of keys [m]
_BAR = 0.030  # depth of the bar with a knob behind the keys [m]
_PAD = 0.0015  # height of the rubber pads [m]
_GAPS = 0.0010  # between two caps [m]


@dataclass(frozen=True)
class _Form:
    """Heights of a keyboard with one kind of caps [m]."""

    case: float  # height of the case
    well: float  # depth of the hollow of the keys
    rest: float  # height of the caps over the floor of their hollow
    cap: float  # height of a cap
    slope: float  # from the edge of a cap to the edge of its top
    travel: float


_FORMS: dict[Caps, _Form] = {
    "tall": _Form(0.0205, 0.0110, 0.0052, 0.0086, 0.0027, 0.0040),
    "flat": _Form(0.0135, 0.0040, 0.0026, 0.0032, 0.0007, 0.0020),
}
_ARROWS = {"left": "chevron_left", "up": "chevron_up", "down": "chevron_down", "right": "chevron_right"}
_BOTTOM = (
    *(("ctrl", 1.25), ("win", 1.25), ("alt", 1.25), ("", 6.25)),
    *(("alt", 1.25), ("fn", 1.25), ("menu", 1.25), ("ctrl", 1.25)),
)
_ACCENTS = ("esc", "enter", "", "Enter")
_CASES = ag.shades(
    *colors("abs", "black graphite white light_grey navy"), weights=(4, 3, 2, 1, 1), color=0.03
)
_TOPS = ag.choice(*colors("abs", "black graphite light_grey white cream"), weights=(3, 2, 2, 2, 1))
_MODS = ag.choice(*colors("abs", "black graphite grey slate sand"), weights=(3, 3, 1, 1, 1))
_ACCENT = ag.choice(
    *colors("abs", "red orange teal mint mustard graphite black"), weights=(1, 1, 1, 1, 1, 2, 2)
)
_RUBBER = ag.material("rubber")
_FOOT = feel.Feel(friction=0.002, damping=0.001, armature=2e-6, effort=0.5)


@dataclass(frozen=True)
class _Key:
    """A key by its legend, its middle from the left and the back, and its size, in pitches."""

    legend: str
    x: float
    y: float
    wide: float = 1.0
    deep: float = 1.0
    modifier: bool = False


def _row(legends: tuple[tuple[str, float], ...], y: float, x: float = 0.0) -> Iterator[_Key]:
    """Lay out a row of keys from a place to the right."""
    for legend, wide in legends:
        yield _Key(legend, x + wide / 2, y, wide, modifier=len(legend) > 1)
        x += wide


def _singles(names: str) -> tuple[tuple[str, float], ...]:
    """Return the legends of keys of one pitch."""
    return tuple((name, 1.0) for name in names.split())


def _numeric(x: float, y: float) -> Iterator[_Key]:
    """Lay out a numeric pad."""
    yield from _row(_singles("num / * -"), y, x)
    for number, legends in enumerate(("7 8 9", "4 5 6", "1 2 3")):
        yield from _row(_singles(legends), y + 1 + number, x)
    yield from _row((("0", 2.0), (".", 1.0)), y + 4, x)
    yield _Key("+", x + 3.5, y + 1.5, deep=2.0, modifier=True)
    yield _Key("Enter", x + 3.5, y + 3.5, deep=2.0, modifier=True)


def _keys(style: Style) -> list[_Key]:
    """Lay out the keys of a keyboard; y is 0.5 in the row at the back."""
    if style == "macro":
        legends = ["M1", "M2", "M3", "M4", "M5", "M6", "M7", "M8", "M9", "fn", "up", "enter"]
        return [_Key(text, n % 4 + 0.5, n // 4 + 0.5, modifier=n >= 9) for n, text in enumerate(legends)]
    if style == "numeric":
        return list(_numeric(0.0, 0.5))
    top = 0.0 if style == "small" else 1.25
    first = "esc" if style == "small" else "`"
    found: list[_Key] = []
    if style != "small":
        for names, x in (("esc", 0.0), ("F1 F2 F3 F4", 2.0), ("F5 F6 F7 F8", 6.5), ("F9 F10 F11 F12", 11.0)):
            found += _row(_singles(names), 0.5, x)
        found += _row(_singles("prt scr brk"), 0.5, 15.25)
    numbers, *letters = keypads.LETTERS
    for number, row in enumerate((((first, 1.0), *numbers[1:]), *letters, _BOTTOM)):
        found += _row(row, top + number + 0.5)
    if style != "small":
        for number, names in enumerate(("ins home pgup", "del end pgdn")):
            found += _row(_singles(names), top + number + 0.5, 15.25)
        found += _row(_singles("up"), top + 3.5, 16.25)
        found += _row(_singles("left down right"), top + 4.5, 15.25)
    if style == "full":
        found += _numeric(18.5, top + 0.5)
    return found


@ag.category(labels="case pad key knob dial foot led print rating_plate", joints=(13, 107))
def keyboard(
    *,
    style: Style = ag.choice({"macro": 0.18, "numeric": 0.2, "small": 0.22, "compact": 0.2, "full": 0.2}),
    caps: Caps = ag.by(
        "style", macro="tall", small={"tall": 4, "flat": 1}, otherwise=ag.choice("tall", "flat")
    ),
    knob: bool = ag.by(
        "style", macro=True, compact={True: 2, False: 1}, full={True: 2, False: 1}, otherwise=False
    ),
    rim: ag.Float = ag.uniform(0.004, 0.009, "m", within=(0.004, 0.02), doc="border around the keys"),
    corner: ag.Float = ag.uniform(0.003, 0.009, "m", within=(0.002, 0.01), doc="radius of the corners"),
    force: ag.Float = ag.uniform(0.45, 0.65, "N", within=(0.3, 1.0), doc="force of the keys"),
    case: ag.Material = _CASES,
    tops: ag.Material = _TOPS,
    mods: ag.Material = _MODS,
    accent: ag.Material = _ACCENT,
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a keyboard with folded feet, the user at its front."""
    form, found = _FORMS[caps], _keys(style)
    wide = _U * max(each.x + each.wide / 2 for each in found)
    deep = _U * max(each.y + each.deep / 2 for each in found)
    bar = _BAR if knob else 0.0
    room = ag.Region.centered(wide + 2 * rim, deep + 2 * rim + bar, 0.0).with_(z=(_PAD, _PAD + form.case))
    well = ag.Region((-wide / 2, wide / 2), (0, deep), (room.z.high - form.well, room.z.high))
    well = well.at(y=room.y.low + rim).grow(0.0008, z=0)
    body = _housing(room, well, corner, case, caps, maker, bare=not knob)
    stroke = keypads.Stroke(form.travel, 0.5 * force, force, friction=0.03, effort=4.0)
    back = well.y.high - 0.0008
    for number, each in enumerate(found):
        finish = accent if each.legend in _ACCENTS else mods if each.modifier else tops
        made = _key(each, form, finish, stroke).suffixed(f"_{number}")
        at = (each.x * _U - wide / 2, back - each.y * _U, well.z.low + form.rest)
        body = body.install(made, at=at)
    typed = controls.any_pressed(f"key_press_{number}" for number in range(len(found)))
    body = body.output("keys", typed, kind="sound")
    if knob:
        body = body.install(_knob(case, accent), at=(room.x.high - 0.020, room.y.high - 0.014, room.z.high))
        body = body.output("volume", signals.level("knob_turn", (0.0, math.tau)), kind="sound")
    return body if style in ("macro", "numeric") else _feet(body, room, case)


def _key(each: _Key, form: _Form, finish: ag.Material, stroke: keypads.Stroke) -> Fitting:
    """Make a key about the middle of its lower edge."""
    wide, deep = each.wide * _U - _GAPS, each.deep * _U - _GAPS
    low = ag.rectangle(wide, deep, radius=0.0012)
    top = ag.rectangle(wide - 2 * form.slope, deep - 2 * form.slope, radius=0.0018)
    cap = ag.loft([low, top], [0.0, form.cap])
    name = _ARROWS.get(each.legend)
    sign = details.icon(name, 0.0048) if name else None
    if sign is None and each.legend:
        sign = keypads.word(each.legend, 0.0040 if len(each.legend) == 1 else 0.0023)
    return keypads.key(
        cap, finish.with_(name=f"{finish.name}_cap", density=520.0), stroke, top=form.cap, sign=sign,
        ink=controls.ink_on(finish),
    )  # fmt: skip


def _housing(
    room: ag.Region,
    well: ag.Region,
    corner: ag.Scalar,
    case: ag.Material,
    caps: Caps,
    maker: str,
    *,
    bare: bool,
) -> ag.Body:
    """Make the case with the hollow of the keys, on rubber pads."""
    solid = ag.extrude(room.plan(radius=corner), room.z.size, bevel=0.0012).at(z=room.z.mid)
    solid -= well.grow(top=0.01).box()
    pads = [
        ag.box(0.014, 0.005, _PAD + 0.0005, bevel=0.0004).at(
            x * (room.x.high - 0.014), y * (room.y.high - 0.006), _PAD / 2 + 0.00025
        )
        for x in (-1, 1)
        for y in (-1, 1)
    ]
    port = ag.box(0.010, 0.0030, 0.0040, bevel=0.0008).at(0, room.y.high - 0.0010, room.z.low + 0.0055)
    lines = (maker.upper(), "5 V - 100 mA", "USB")
    body = ag.weld(
        ag.part(
            solid, "case", case.with_(name=f"{case.name}_{caps}", density=1000.0 if caps == "tall" else 640.0)
        ),
        ag.part(pads, "pad", _RUBBER),
        ag.detail(port, "case", ag.material("black_abs")),
        details.rating_plate(0.040, 0.016, lines, at=(0, 0, _PAD), facing=-ag.Z, up=ag.Y),
    )
    if bare:
        return body
    mark, ink = details.logo(maker, 0.0030), controls.ink_on(case)
    at = (room.x.low + 0.030, room.y.high - 0.013, room.z.high)
    return ag.weld(body, details.printed(mark, at, material=ink, facing=ag.Z, proud=0.0001))


def _knob(case: ag.Material, accent: ag.Material) -> Fitting:
    """Make the knob for the volume, which clicks."""
    turn = ag.Revolute(
        "knob_turn", axis=ag.Y, detents=feel.detents(24, 0.008), feel=feel.DIAL, friction=0.0012
    )
    dial = controls.dial(turn, "capped", 0.0100, case, depth=0.0150, cap=accent, name="knob")
    return dial.rotate(ag.X, -math.pi / 2)


def _feet(body: ag.Body, room: ag.Region, case: ag.Material) -> ag.Body:
    """Fold two feet into the underside near the rear edge."""
    wide, long, thick = 0.030, 0.016, 0.0035
    for number, x in enumerate((room.x.low + 0.048, room.x.high - 0.048)):
        pivot = (x, room.y.high - 0.014, _PAD + 0.0026)
        plate = ag.Region.centered(wide, 0.0, thick).with_(y=(-long, 0.0015))
        recess = plate.grow(0.0012, front=0.0036, bottom=0.01).box()
        tip = ag.box(wide - 0.002, 0.004, 0.0006, bevel=0.0002).at(0, 0.002 - long, -thick / 2)
        foot = ag.weld(
            ag.part(plate.box(bevel=0.0006), "foot", case, name=f"foot_{number}"),
            ag.detail(tip, "foot", _RUBBER),
        )
        fold = ag.Revolute(
            f"foot_hinge_{number}", axis=ag.X, limits=(0, 1.75), detents=feel.detents((-0.2, 1.95), 0.012),
            feel=_FOOT, driven="fingers below the keyboard",
        )  # fmt: skip
        body = body.install(Fitting.moving(foot, fold, cut=recess), at=pivot)
    return body
