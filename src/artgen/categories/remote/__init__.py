"""A remote control on a table: of a television, a streaming stick or an air conditioner; a key fob.

Links: `body`; `key_0`, ..., from the far end, row by row; `battery_cover`, whose end closes the near end of
the remote; `front_cover` over the lower keys of an air conditioner; `blade`, the key of a car, and `ring`
of a fob. Joints: `key_press_0`, ...; `battery_slide` and `front_slide`, 0 where they are closed;
`blade_turn`, 0 where it is folded; `ring_swing`.

Keys are returned by rubber domes; covers are held by friction. The blade snaps to both of its ends; a spring
behind its key throws it out. The far end looks to the device.

Sizes are those of shops: remotes of televisions are 46-54 mm wide, 150-245 mm long and 17-24 mm thick and
weigh 80-160 g with two AAA cells (11.5 g each, IEC 60086); of sticks 38-43 mm, 135-165 mm, 13-17 mm and
40-80 g; of air conditioners 52-60 mm, 150-180 mm, 22-26 mm and 100-170 g; fobs of cars 34-40 mm and 30-60 g,
of gates 34-44 mm and 25-50 g. Keys of rubber close with 0.8-2 N after 0.5-0.9 mm.
"""

import functools
import math
import operator
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal

import artgen as ag
from artgen import details, feel, signals
from artgen.categories.shared import controls, keypads, require_size
from artgen.categories.shared.finish import casting, colors
from artgen.nodes.details.icons import ICONS
from artgen.nodes.fitting import FIT

Style = Literal["tv", "stick", "air", "car", "gate"]
"""Remote of a television, of a streaming stick, of an air conditioner; fob of a car or of a gate."""

Shape = Literal["bar", "pill", "oval"]
"""Outline of a cap: a rectangle with rounded corners, with round ends, or an ellipse."""

Row = tuple[str, ...]
"""Legends of the keys of a row; none where it has a gap."""

_ROW = 0.0116  # distance of rows [m]
_CAP = 0.0048  # depth of a cap [m]
_FINGER = 0.0092  # from the middle of a key to the next one [m]
_OK = 0.0062  # radius of the key in a ring [m]
_WELL = 0.0032  # depth of the keys below the face [m]
_END = 0.016  # length of the end of a battery cover [m]
_PRINT = 0.0001  # height of the print [m]
_UNDER = 0.0016  # thickness of the plate of a battery cover [m]
_STEP = 0.0048  # from the face of an air conditioner's remote down to its lower keys [m]
_SILL = 0.0016  # thickness of the wall between the keys on the face and that step [m]
_TRAVEL = 0.046  # of the cover over these keys [m]
_DIGITS: tuple[Row, ...] = (("1", "2", "3"), ("4", "5", "6"), ("7", "8", "9"), ("LIST", "0", "return"))
_VOLUME: tuple[Row, ...] = (("plus", "mute", "chevron_up"), ("minus", "info", "chevron_down"))
_MEDIA: tuple[Row, ...] = (("chevron_left", "play", "chevron_right"), ("stop", "pause", "star"))
_WORDS: tuple[Row, ...] = (("GUIDE", "TEXT", "SUB"), ("AD", "HELP", "REC"))
_INK = {"red": (0.60, 0.03, 0.03), "green": (0.03, 0.33, 0.08), "yellow": (0.75, 0.55, 0.04)}
_HUES = tuple(
    ag.material("silicone").with_(name=f"key_{name}", base_color=rgb)
    for name, rgb in (_INK | {"blue": (0.03, 0.12, 0.50)}).items()
)
_LED = ag.material("led_red").with_(name="led_sends", emission=(0.0, 0.0, 0.0))
_CELL = ag.material("zinc").with_(name="battery_cell", density=2900.0)
_STEEL = ag.material("stainless")
_DARKS = (*colors("abs", "graphite slate"), ag.material("black_abs"), ag.material("leather_grain_abs"))
_LIGHTS = colors("abs", "white light_grey silver")
_BODIES = ag.by(
    "style",
    air=ag.choice(*_LIGHTS, ag.colored("abs", "cream"), weights=(4, 2, 1, 1)),
    tv=ag.choice(*_DARKS, *_LIGHTS, weights=(2, 1, 4, 2, 0.5, 1, 1.5)),
    stick=ag.choice(*_DARKS, *_LIGHTS, weights=(2, 1, 4, 1, 1.5, 0.5, 0.5)),
    car=ag.choice(*_DARKS, weights=(1, 1, 3, 3)),
    otherwise=ag.choice(*_DARKS, *_LIGHTS, *colors("abs", "navy red"), weights=(2, 1, 2, 1, 1, 1, 1, 1, 1)),
)
_PANELS = {
    "gloss": ag.material("glossy_plastic_black"),
    "metal": ag.material("brushed_aluminium").with_(name="brushed_dark", base_color=(0.16, 0.16, 0.17)),
}
_RUBBERS = colors("silicone", "graphite grey light_grey white black")
_RING = feel.Feel(friction=0.002, damping=1e-4, armature=1e-6, effort=0.2)
_BLADE = feel.Feel(friction=0.003, damping=0.002, armature=1e-5, effort=0.6)


@dataclass(frozen=True)
class _Plan:
    """Measures and materials of a remote, the middle of its far end at the origin of x and y."""

    width: ag.Scalar  # [m]
    thick: ag.Scalar  # [m]
    finish: ag.Material
    rubber: ag.Material
    cover: ag.Material  # plate around the keys
    stroke: keypads.Stroke
    shape: Shape
    maker: str

    @property
    def ink(self) -> ag.Material:
        """Material of the legends."""
        return controls.ink_on(self.rubber)


@dataclass
class _Rows:
    """Keys that are laid out from the far end toward the user."""

    plan: _Plan
    y: ag.Scalar  # far side of the next row [m]
    caps: list[keypads.Cap] = field(default_factory=list)

    def row(
        self,
        legends: Row,
        pitch: ag.Scalar,
        *,
        deep: ag.Scalar = _CAP,
        step: ag.Scalar = _ROW,
        finishes: Sequence[ag.Material] = (),
    ) -> None:
        """Add a row of keys, with gaps where a legend is empty."""
        y = self.y - step / 2
        wide = ag.min_(2 * (pitch - _FINGER), 0.0165)
        for number, x in enumerate(controls.places(len(legends), pitch)):
            if not (text := legends[number]):
                continue
            finish = finishes[number] if finishes else self.plan.rubber
            finish = _HUES[0] if text == "power" and self.plan.shape != "oval" else finish
            ink = controls.ink_on(finish)
            self.caps.append(
                keypads.Cap((x, y), _outline(self.plan.shape, wide, deep), finish, _sign(text, deep), ink)
            )
        self.y = self.y - step

    def ring(self, outer: ag.Scalar, corners: Row, aside: ag.Scalar) -> None:
        """Add a ring of four keys around a fifth one, and keys in its corners."""
        reach = outer + (0.0082 if corners else 0.0050)
        y = self.y - reach
        plan, ink = self.plan, self.plan.ink
        at = [(-aside, y + outer + 0.001), (aside, y + outer + 0.001)]
        at += [(-aside, y - outer - 0.001), (aside, y - outer - 0.001)]
        aside_of = [
            keypads.Cap(place, ag.circle(0.0034), plan.rubber, _sign(text, 0.0058), ink, proud=0.0023)
            for text, place in zip(corners, at, strict=False)
        ]
        around, touch = [], outer - 0.0009
        for turn, way in keypads.ring_places(1.0):
            sign = ag.circle(0.0006)
            middle = (_OK + outer) / 2
            around.append(
                keypads.Cap(
                    (0.0, y), keypads.sector(_OK + 0.0005, outer, turn), plan.rubber, sign, ink,
                    proud=0.0013,
                    push=(way[0] * touch, way[1] * touch), sign_at=(way[0] * middle, way[1] * middle),
                )
            )  # fmt: skip
        center = keypads.Cap(
            (0.0, y), ag.circle(_OK), plan.rubber, keypads.word("OK", 0.0026), ink, proud=0.0023
        )
        self.caps += [*aside_of[:2], *around, center, *aside_of[2:]]
        self.y = y - reach

    def skip(self, gap: ag.Scalar) -> None:
        """Leave a gap."""
        self.y = self.y - gap


def _outline(shape: Shape, wide: ag.Scalar, deep: ag.Scalar) -> ag.Profile:
    """Make the outline of a cap."""
    if shape == "oval":
        return ag.ellipse(wide / 2, deep / 2)
    return ag.rectangle(wide, deep, radius=(0.49 if shape == "pill" else 0.16) * ag.min_(wide, deep))


def _sign(text: str, deep: ag.Scalar) -> ag.Profile:
    """Make the legend of a key: an icon, or letters."""
    if text in ICONS:
        return details.icon(text, 0.74 * deep, weight="bold")
    return keypads.word(text, 0.0026 if len(text) == 1 else 0.0016)


_WIDTHS = {"tv": (0.042, 0.062), "stick": (0.038, 0.062), "air": (0.046, 0.062)}
"""Widths that have room for the keys [m]."""


@ag.category(
    labels="body key panel display battery battery_cover front_cover lens blade ring lug led print "
    "rating_plate",
    joints=(2, 46),
)
def remote(
    *,
    style: Style = ag.choice({"tv": 0.34, "stick": 0.22, "air": 0.18, "car": 0.14, "gate": 0.12}),
    width: ag.Float = ag.by(
        "style",
        tv=ag.uniform(0.046, 0.054),
        stick=ag.uniform(0.0388, 0.043),
        air=ag.uniform(0.052, 0.060),
        car=ag.uniform(0.035, 0.040),
        gate=ag.uniform(0.036, 0.044),
        unit="m",
        within=(0.034, 0.062),
    ),
    thick: ag.Float = ag.by(
        "style",
        tv=ag.uniform(0.0185, 0.0235),
        stick=ag.uniform(0.0164, 0.0178),
        air=ag.uniform(0.0225, 0.0255),
        otherwise=ag.uniform(0.0138, 0.0165),
        unit="m",
        within=(0.013, 0.028),
        doc="thickness",
    ),
    tail: ag.Float = ag.by(
        "style",
        tv=ag.uniform(0.024, 0.050),
        stick=ag.uniform(0.022, 0.050),
        otherwise=ag.uniform(0.008, 0.012),
        unit="m",
        within=(0.006, 0.07),
        doc="length below the keys",
    ),
    digits: bool = ag.by("style", tv={True: 4, False: 1}, otherwise=False, doc="whether it has digits"),
    extra: int = ag.by(
        "style",
        tv=ag.count(0, 5),
        stick=ag.count(1, 3),
        air=ag.count(2, 3),
        car=ag.count(2, 4),
        gate=ag.count(1, 4),
        doc="further rows of keys; number of keys of a fob",
    ),
    shape: Shape = ag.choice("bar", "pill", "oval", weights=(2, 2, 1)),
    corner: ag.Float = ag.uniform(0.004, 0.016, "m", doc="radius of the corners, seen from above"),
    travel: ag.Float = ag.uniform(0.0005, 0.0009, "m", within=(0.0003, 0.0009), doc="travel of the keys"),
    force: ag.Float = ag.uniform(0.9, 2.0, "N", within=(0.5, 3.0), doc="force of the keys"),
    hold: ag.Float = ag.uniform(2.0, 6.0, "N", doc="friction of the covers"),
    temperature: str = ag.choice("21 °C", "22 °C", "24 °C", "26 °C"),
    finish: ag.Material = _BODIES,
    rubber: ag.Material = ag.choice(*_RUBBERS, doc="material of the keys"),
    panel: Literal["body", "gloss", "metal"] = ag.choice(
        "body", "gloss", "metal", weights=(3, 1, 0.6), doc="plate around the keys"
    ),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a remote with closed covers, its far end to the back."""
    width = require_size(width, _WIDTHS.get(style, (0.034, 0.062)), f"width of a {style} remote")
    if style in ("tv", "stick"):
        tail = require_size(tail, (0.020, 0.07), f"length below the keys of a {style} remote")
    stroke = keypads.Stroke(travel, 0.35 * force, force, friction=0.05, effort=8.0)
    if style in ("car", "gate"):
        ag.require(1 <= extra <= 4, f"a fob of a {style} must have 1 to 4 keys, got extra={extra}")
        return _fob(style, width, thick, tail, extra, stroke, shape, corner, finish, rubber, maker)
    look = finish if panel == "body" else _PANELS[panel]
    head = {"tv": 0.012, "stick": 0.011, "air": 0.052}[style]
    plan = _Plan(width, thick, finish, rubber, look, stroke, shape, maker)
    rows = _Rows(plan, -head)
    match style:
        case "tv":
            _tv_rows(rows, extra, digits=digits)
        case "stick":
            _stick_rows(rows, extra)
        case _:
            pitch = 0.40 * width
            for legends in (("power", "menu"), ("chevron_up", "fan"), ("chevron_down", "snowflake")):
                rows.row(legends, pitch, deep=0.0075, step=0.0150)
    lower = rows.y - 0.0015
    if style == "air":
        ag.require(extra >= 1, "a remote of an air conditioner must have a row of keys below, got extra=0")
        tail = tail + _ROW * extra + 0.052
    room = ag.Region((-width / 2, width / 2), (lower - tail, 0.0), (0.0, thick))
    body = _case(plan, room, corner, hold, flat=style == "air")
    well = ag.Region((0, 0), (lower, -head + 0.0015), (thick - _WELL, thick)).grow(x=width / 2 - 0.0020)
    body = keypads.Pad(well, stroke, look).install(body, rows.caps)
    if style == "air":
        step = room.with_(y=(room.y.low, lower - _SILL))
        body = _lower_keys(body, plan, step, extra, corner, hold, len(rows.caps))
        pane = (width - 0.014, 0.032)
        at = (0, -0.029, thick)
        body = ag.weld(
            body,
            details.display(temperature.replace(" ", ""), *pane, at=at, facing=ag.Z, color="lcd"),
            _named(maker, (0, -0.0075, thick), finish, 0.0028),
        )
    else:
        body = ag.weld(body, _named(maker, (0, lower - 0.55 * (tail - _END), thick), finish, 0.0034))
    count = len(rows.caps) + (3 * min(extra, 3) if style == "air" else 0)
    body = body.output("infrared", _pressed(count), kind="light")
    return body.at(y=-room.y.mid, z=_PRINT)  # it lies on its print


def _pressed(count: int) -> signals.Signal:
    """Return the signal that a finger presses any key."""
    return controls.any_pressed(f"key_press_{number}" for number in range(count))


def _tv_rows(rows: _Rows, extra: int, *, digits: bool) -> None:
    """Lay out the keys of the remote of a television."""
    width = rows.plan.width
    pitch, outer = 0.30 * width, ag.clamp(0.40 * width, 0.0170, 0.0195)
    rows.row(("power", "", "eject"), pitch)
    for legends in _DIGITS if digits else ():
        rows.row(legends, pitch)
    rows.skip(0.0026)
    for legends in _VOLUME:
        rows.row(legends, pitch, deep=0.0076, step=0.0132)
    rows.ring(outer, ("menu", "home", "return", "settings"), 1.02 * pitch)
    four = ag.min_((width / 2 + 0.0066) / 2.5, 0.0128)
    more = (("dots",) * 4, *_MEDIA, *_WORDS)[:extra]
    for legends in more:
        if len(legends) == 4:
            rows.row(legends, four, finishes=_HUES)
        else:
            rows.row(legends, pitch)


def _stick_rows(rows: _Rows, extra: int) -> None:
    """Lay out the keys of the remote of a streaming stick."""
    width = rows.plan.width
    pitch = 0.325 * width
    rows.row(("power", "", "sound"), pitch)
    rows.ring(ag.clamp(width / 2 - 0.0028, 0.0165, 0.0180), (), 0.0)
    rows.skip(0.0016)
    rows.row(("return", "home", "menu"), pitch)
    rows.row(("chevron_left", "start_pause", "chevron_right"), pitch)
    if extra > 1:
        rows.row(("minus", "mute", "plus"), pitch)
    if extra > 2:
        rows.row(("KINO", "TIDE"), 0.415 * width, finishes=(_HUES[3], _HUES[1]))


def _named(maker: str, at: ag.VectorLike, finish: ag.Material, high: float) -> ag.Body:
    """Print the name of the maker on the face."""
    return details.printed(
        details.logo(maker, high), at, material=controls.ink_on(finish), facing=ag.Z, up=ag.Y, proud=0.0001
    )


def _shell(room: ag.Region, corner: ag.Scalar, *, flat: bool) -> ag.Solid:
    """Make the outside of a remote, with a narrower underside unless it is flat."""
    outline = room.plan(radius=corner)
    if flat:
        return ag.extrude(outline, room.z.size, bevel=0.0025).at(z=room.z.mid)
    belly = room.shrink(0.004, z=0).plan(radius=ag.max_(corner - 0.004, 0.0025))
    return ag.hull(
        ag.extrude(outline, 0.5 * room.z.size, bevel=0.0012).at(z=0.75 * room.z.size),
        ag.extrude(belly, 0.3 * room.z.size, bevel=0.001).at(z=0.15 * room.z.size),
    )


def _case(plan: _Plan, room: ag.Region, corner: ag.Scalar, hold: ag.Scalar, *, flat: bool) -> ag.Body:
    """Make the body with its cells, and the cover below them, whose end slides off with it."""
    shell = _shell(room, corner, flat=flat)
    edge = room.y.low + _END
    end = room.with_(y=(room.y.low, edge)).grow(0.01, back=0)
    plate = room.with_(y=(edge - 0.001, edge + 0.047), z=(0, _UNDER)).shrink(x=0.0075)
    cells = plate.with_(y=(edge + 0.001, edge + 0.0465), z=(_UNDER + 0.0002, 0.0128))
    cells = cells.with_(x=(-0.0105, 0.0105))
    solid = shell - end.grow(back=FIT.film).box() - plate.grow(FIT.sliding, bottom=0.01).box() - cells.box()
    cell = ag.cylinder(0.0051, 0.0440, axis=ag.Y, bevel=0.0006)
    pair = [cell.at(x, cells.y.mid, _UNDER + 0.0054) for x in (-0.0055, 0.0055)]
    lens = ag.box(0.014, 0.0012, 0.005, bevel=0.0004).at(0, 0, 0.62 * room.z.size)
    words = (plan.maker.upper(), "2 x AAA 1.5 V", "MADE FOR INFRARED")
    lines, ink = details.lettering(words, 0.0018, fineness="coarse"), controls.ink_on(plan.finish)
    at = (0, 0.4 * room.y.low, 0)
    back = details.printed(lines, at, material=ink, facing=-ag.Z, proud=_PRINT, label="rating_plate")
    body = ag.weld(
        ag.part(solid, "body", casting(plan.finish, 0.42), name="body"),
        ag.part(pair, "battery", _CELL, separate="held by springs"),
        ag.detail(lens, "lens", ag.material("black_glass")),
        back,
    )
    hull = shell & (end.with_(z=(-0.001, plan.thick - _STEP)) if flat else end).box()
    grasp = ag.grasp_on(hull, approach=-ag.Z, closing=ag.X, at=(0, room.y.low + 0.0045, 0), depth=0.0110)
    cover = ag.part(hull | plate.box(), "battery_cover", casting(plan.finish, 0.55), grasp=grasp)
    slide = ag.Prismatic(
        "battery_slide", axis=-ag.Y, limits=(0, 0.055), friction=hold, damping=2.0, armature=0.02, effort=20.0
    )
    return body.attach(cover, slide)


def _lower_keys(
    body: ag.Body, plan: _Plan, room: ag.Region, count: int, corner: ag.Scalar, hold: ag.Scalar, first: int
) -> ag.Body:
    """Lower the face toward the user, and put rows of keys there under a cover that slides off them."""
    face = plan.thick - _STEP
    step = room.with_(z=(face, plan.thick))
    slide = ag.Prismatic(
        "front_slide", axis=-ag.Y, limits=(0, _TRAVEL), friction=0.5 * hold, damping=2.0, armature=0.02,
        effort=15.0,
    )  # fmt: skip
    rows = _Rows(plan, step.y.high - 0.0038)
    for legends in (("TIMER", "SWING", "SLEEP"), ("clock", "fan", "leaf"), ("SET", "light", "lock"))[:count]:
        rows.row(legends, 0.30 * plan.width)
    well = ag.Region((0, 0), (rows.y, step.y.high - 0.004), (face - _WELL, face)).grow(x=0.45 * plan.width)
    pad = keypads.Pad(well, plan.stroke, plan.finish, when=slide > 0.9 * _TRAVEL)
    body = pad.install(body.cut(step.grow(0.01, back=0, bottom=0).box()), rows.caps, first)
    lid = step.shrink(front=_END + 0.001, back=FIT.sliding, bottom=0.0017).grow(x=0.0008)
    outline = lid.plan() & lid.grow(back=0.03).plan(radius=ag.min_(corner, 0.008))
    solid = ag.extrude(outline, lid.z.size, bevel=0.0008).at(z=lid.z.mid)
    ribs = [
        ag.Region((-0.009, 0.009), (lid.y.high - 0.008 - n * 0.003, lid.y.high - 0.0068 - n * 0.003), (0, 0))
        for n in range(4)
    ]
    lines = functools.reduce(operator.or_, [rib.plan() for rib in ribs])
    hold_on = ag.grasp_on(solid, approach=-ag.Z, closing=ag.X, depth=0.0028)
    cover = ag.weld(
        ag.part(solid, "front_cover", plan.finish, grasp=hold_on),
        details.engraved(lines, (0, 0, plan.thick), material=plan.finish, facing=ag.Z, up=ag.Y),
    )
    return body.attach(cover, slide)


def _fob(
    style: Style,
    width: ag.Scalar,
    thick: ag.Scalar,
    tail: ag.Scalar,
    count: int,
    stroke: keypads.Stroke,
    shape: Shape,
    corner: ag.Scalar,
    finish: ag.Material,
    rubber: ag.Material,
    maker: str,
) -> ag.Body:
    """Make a fob with a ring; that of a car has a blade in its side."""
    car, pitch = style == "car", 0.0143
    square = not car and count == 4
    lines = 2 if square else count
    head = 0.020 if car else 0.010
    length = ag.max_(head + pitch * lines + tail + 0.004, 0.078 if car else 0.052)
    room = ag.Region.centered(width, length, 0.0).with_(z=(0, thick))
    shell = _shell(room, ag.max_(corner, 0.008), flat=False)
    body = ag.part(shell, "body", casting(finish, 0.6), name="body")
    top = length / 2 - head
    x = 0.5 * 0.0192 if square else 0.0
    icons = ("lock", "unlock", "key", "light") if car else ("1", "2", "3", "4")
    caps = []
    for number in range(count):
        place = (
            ((-x, x)[number % 2], top - pitch * (number // 2 + 0.5))
            if square
            else (0.0, top - pitch * (number + 0.5))
        )
        outline = _outline(shape, 0.55 * width, 0.0096) if car else ag.circle(0.0048)
        caps.append(
            keypads.Cap(place, outline, rubber, _sign(icons[number], 0.0085), controls.ink_on(rubber))
        )
    half = 0.0152 if square else 0.31 * width if car else 0.0068
    well = ag.Region((-half, half), (top - pitch * lines, top), (thick - _WELL, thick))
    body = keypads.Pad(well, stroke, rubber if car else finish, corner=0.004).install(body, caps)
    lamp = details.printed(
        ag.circle(0.0012), (0, top + 0.005, thick), material=_LED, facing=ag.Z, label="led"
    )
    body = ag.weld(body, lamp, _named(maker, (0, room.y.low + 0.0058, thick), finish, 0.0024))
    body = body.output("signal", _pressed(count), kind="light", material=_LED, color=(1.0, 0.06, 0.03))
    if car:
        body = _blade(body, room)
        if count > 2:  # the third key lets the blade out
            out = signals.pressed("key_press_2")
            body = body.output("unfolding", out, kind="motor", moves="blade_turn", speed=8.0)
    return _ring(body, room, finish)


def _blade(body: ag.Body, room: ag.Region) -> ag.Body:
    """Fold the key of a car into a slot in the left side."""
    pivot = ag.vector(room.x.low + 0.0085, room.y.high - 0.0095, 0.42 * room.z.size)
    reach = 0.058
    slot = ag.Region(
        (room.x.low - 0.01, pivot.x + 0.0046), (pivot.y - reach - 0.001, room.y.high + 0.01), (0, 0)
    )
    slot = slot.with_(z=(pivot.z - 0.0028, pivot.z + 0.0028))
    body = body.cut(slot.box() | ag.bore(0.0068, 0.0056).at(pivot))
    side = [(-0.004, 0), (0.004, 0), (0.004, 0.006 - reach), (0, -reach), (-0.004, 0.003 - reach)]
    shaft = ag.extrude(ag.polygon(side), 0.0022, bevel=0.0003).at(pivot)
    boss = ag.cylinder(0.0062, 0.0044, bevel=0.0004).at(pivot)
    groove = ag.rectangle(0.0012, reach - 0.014)
    mark = details.engraved(
        groove,
        (pivot.x, pivot.y - reach / 2 - 0.003, pivot.z + 0.0011),
        material=_STEEL,
        facing=ag.Z,
        up=ag.Y,
    )
    blade = ag.weld(ag.part(boss | shaft, "blade", _STEEL, name="blade"), mark)
    snap = feel.detents((-0.1 * math.pi, 1.1 * math.pi), 0.03)
    turn = ag.Revolute(
        "blade_turn", axis=-ag.Z, pivot=pivot, limits=(0, math.pi), detents=snap, feel=_BLADE,
        driven="the spring behind its key",
    )  # fmt: skip
    return body.attach(blade, turn)


def _ring(body: ag.Body, room: ag.Region, finish: ag.Material) -> ag.Body:
    """Hang a ring on the post of a lug at the near end."""
    middle, post, wire, inner = 0.5 * room.z.size, room.y.low - 0.0105, 0.0014, 0.0115
    lug = ag.Region(
        (-0.0055, 0.0055), (post - 0.0028, room.y.low + 0.003), (middle - 0.0045, middle + 0.0045)
    )
    gap = lug.with_(y=(post - 0.01, post + 0.0100), z=(middle - 0.0020, middle + 0.0020)).grow(x=0.001)
    pin = ag.cylinder(0.0013, 0.0040).at(0, post, middle)
    solid = ag.extrude(lug.plan(radius=0.0020), lug.z.size, bevel=0.0006).at(z=lug.z.mid) - gap.box()
    body = ag.weld(body, ag.part([solid, pin], "lug", casting(finish, 0.9), separate="pin in the lug"))
    reach = inner - 0.0013 - wire - 0.0004
    ring = ag.torus(inner, wire).at(0, post - reach, middle)
    hold = ag.grasp_on(ring, approach=-ag.Z, closing=ag.X, at=(0, post - reach, 0), depth=0.0035)
    swing = ag.Revolute("ring_swing", axis=ag.Z, pivot=(0, post, middle), limits=(-0.5, 0.5), feel=_RING)
    return body.attach(ag.part(ring, "ring", ag.material("chrome"), grasp=hold), swing)
