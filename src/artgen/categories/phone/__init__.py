"""A telephone: a flip phone, a slider, a bar, a folding smartphone, or one on a desk with a handset.

Links: `base` with `key_0`, ..., row by row from the far end; `lid` with the screen of a flip phone or a
folding smartphone; `slide`, the upper half of a slider with its own keys; `volume_up`, `volume_down` and
`power` of a smartphone; `handset` of a desk telephone, drawn without its cord. Joints: `lid_hinge` and
`slide_up`, 0 where it is closed; `key_press_0`, ...; `volume_up_press`, `volume_down_press`, `power_press`;
`handset_lift`.

Flip phones and sliders snap open and shut; the hinge of a smartphone stays at any angle. Keys under a lid or
a slide are reached where it is open. The handset lies in two hollows and is lifted off them.

Sizes are those of makers' data sheets: flip phones are 49-54 mm wide, 100-107 mm long and 18-22 mm thick and
weigh 85-110 g; sliders 49-53 mm, 98-105 mm, 17-19 mm, 100-125 g; bars 48-52 mm, 116-126 mm, 14-16 mm,
80-100 g; folding smartphones 71-73 mm, 84-88 mm, 15-18 mm folded, 175-195 g; desk telephones 0.18-0.20 m,
0.20-0.23 m, 0.09-0.13 m, 0.6-1.0 kg with a handset of 0.12-0.20 kg. Keys of phones travel 0.3-0.5 mm with
1-2 N, those on a desk 1.4-2 mm.
"""

import functools
import math
import operator
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details, feel, signals
from artgen.categories.shared import controls, keypads, require_size, screens
from artgen.categories.shared.finish import colors
from artgen.nodes.details.icons import ICONS
from artgen.nodes.fitting import FIT, Fitting

Style = Literal["flip", "slider", "bar", "fold", "desk"]
"""A phone with a lid, with an upper half that slides, in one piece, one that folds, or one on a desk."""

_SEAM = 0.0013  # gap between two halves [m]
_ROW = 0.0116  # distance of rows of keys [m]
_FINGER = 0.0092  # from the middle of a key to the next one [m]
_WELL = 0.0028  # depth of the keys below the face [m]
_DENSITY = {"flip": 1150.0, "slider": 1450.0, "bar": 1200.0, "fold": 2100.0, "desk": 330.0}
_TRAVEL = 0.057  # of a slider [m]
_TILT = 0.16  # of a desk telephone [rad]
_DIGITS = (("1", "2", "3"), ("4", "5", "6"), ("7", "8", "9"), ("*", "0", "#"))
_MENU = (("menu", "chevron_up", "return"), ("call", "OK", "end"))
_END = 5  # number of the key that ends a call, and switches the phone
_COLORS = {
    "call": ag.colored("silicone", "light_grey").with_(name="key_call", base_color=(0.03, 0.33, 0.09)),
    "end": ag.colored("silicone", "light_grey").with_(name="key_end", base_color=(0.55, 0.03, 0.03)),
}
_METALS = tuple(
    ag.material("aluminium").with_(name=f"anodised_{name}", base_color=color)
    for name, color in {
        "silver": (0.70, 0.71, 0.72),
        "graphite": (0.12, 0.12, 0.13),
        "lilac": (0.46, 0.38, 0.52),
        "mint": (0.45, 0.60, 0.52),
        "gold": (0.72, 0.58, 0.42),
    }.items()
)
_PLASTICS = (*colors("abs", "graphite slate navy burgundy silver white"), ag.material("glossy_plastic_black"))
_CASES = ag.by(
    "style",
    fold=ag.choice(*_METALS),
    desk=ag.choice(*colors("leather_grain_abs", "black graphite light_grey cream"), weights=(4, 2, 2, 1)),
    bar=ag.choice(*_PLASTICS, *colors("abs", "yellow teal red"), weights=(2, 2, 2, 1, 1, 1, 3, 1, 1, 1)),
    otherwise=ag.choice(*_PLASTICS, weights=(2, 2, 2, 1.5, 2, 1, 3)),
)
_KEYS = ag.choice(*colors("silicone", "graphite light_grey white black"), weights=(2, 2, 1, 1))
_SIGNS = ag.material("led_white").with_(name="screen_signs")
_LCD = ag.material("abs").with_(name="lcd")  # pane of a liquid crystal
_PANE = ag.material("black_glass").with_(name="phone_glass", specular_roughness=0.10)
_SLIDE = feel.Feel(friction=0.4, damping=2.0, armature=0.02, effort=15.0)


@dataclass(frozen=True)
class _Plan:
    """Measures and materials of a phone whose base lies at the origin of x and y."""

    style: Style
    room: ag.Region  # closed base
    corner: ag.Scalar
    finish: ag.Material
    caps: ag.Material
    stroke: keypads.Stroke
    picture: str
    clock: str
    maker: str

    @property
    def shell(self) -> ag.Material:
        """Material of a housing with what it contains."""
        return self.finish.with_(name=f"{self.finish.name}_{self.style}", density=_DENSITY[self.style])

    def slab(self, room: ag.Region, bevel: float = 0.0015) -> ag.Solid:
        """Make a slab with the corners of the phone."""
        return ag.extrude(room.plan(radius=self.corner), room.z.size, bevel=bevel).at(z=room.z.mid)

    def rows(self, legends: Sequence[Sequence[str]], top: ag.Scalar) -> list[keypads.Cap]:
        """Lay out rows of keys below a height, as wide as the base."""
        pitch = 0.295 * self.room.x.size
        wide, deep = 2 * (pitch - _FINGER), 2 * (_ROW - _FINGER)
        outline = ag.rectangle(wide, deep, radius=0.0016)
        caps = []
        for number, row in enumerate(legends):
            for text, x in zip(row, controls.places(len(row), pitch), strict=True):
                finish = _COLORS.get(text, self.caps)
                y = top - (number + 0.5) * _ROW
                ink = controls.ink_on(finish)
                caps.append(keypads.Cap((x, y), outline, finish, _legend(text, 0.0034), ink, proud=0.0009))
        return caps

    def pad(self, top: ag.Scalar, low: ag.Scalar, face: ag.Scalar, when: ag.Condition | None) -> keypads.Pad:
        """Plan a hollow of keys between two places along y."""
        half = self.room.x.high - 0.0032
        room = ag.Region((-half, half), (low, top), (face - _WELL, face))
        return keypads.Pad(room, self.stroke, self.finish, when=when)


_WIDTHS = {"fold": (0.068, 0.085), "desk": (0.17, 0.22)}
_LENGTHS = {
    "flip": (0.100, 0.15), "slider": (0.098, 0.15), "bar": (0.114, 0.16), "fold": (0.080, 0.110),
    "desk": (0.19, 0.24),
}  # fmt: skip
_THICK = {"fold": (0.007, 0.012), "desk": (0.026, 0.04)}
"""Possible sizes by style [m]; others have the sizes of their rows of keys."""


@ag.category(
    labels="base lid slide hinge key panel button bezel display lens handset foot socket speaker "
    "print rating_plate",
    joints=(4, 26),
)
def phone(
    *,
    style: Style = ag.choice({"flip": 0.26, "slider": 0.18, "bar": 0.18, "fold": 0.16, "desk": 0.22}),
    width: ag.Float = ag.by(
        "style",
        flip=ag.uniform(0.0495, 0.0535),
        slider=ag.uniform(0.0495, 0.0525),
        bar=ag.uniform(0.0490, 0.0520),
        fold=ag.uniform(0.0710, 0.0728),
        desk=ag.uniform(0.182, 0.200),
        unit="m",
        within=(0.049, 0.22),
    ),
    length: ag.Float = ag.by(
        "style",
        flip=ag.uniform(0.101, 0.106),
        slider=ag.uniform(0.099, 0.104),
        bar=ag.uniform(0.117, 0.126),
        fold=ag.uniform(0.084, 0.088),
        desk=ag.uniform(0.205, 0.225),
        unit="m",
        within=(0.08, 0.24),
        doc="length while it is closed",
    ),
    thick: ag.Float = ag.by(
        "style",
        flip=ag.uniform(0.0088, 0.0102),
        slider=ag.uniform(0.0086, 0.0100),
        bar=ag.uniform(0.0132, 0.0150),
        fold=ag.uniform(0.0072, 0.0080),
        desk=ag.uniform(0.030, 0.036),
        unit="m",
        within=(0.007, 0.04),
        doc="thickness of the base",
    ),
    corner: ag.Float = ag.uniform(0.005, 0.011, "m", doc="radius of the corners, seen from above"),
    turn: ag.Float = ag.by(
        "style",
        fold=ag.uniform(2.9, 3.1),
        otherwise=ag.uniform(2.5, 2.8),
        unit="rad",
        doc="angle of an open lid",
    ),
    extra: int = ag.by("style", desk=ag.count(0, 2), otherwise=0, doc="columns of memory keys"),
    travel: ag.Float = ag.by(
        "style",
        desk=ag.uniform(0.0014, 0.0020),
        otherwise=ag.uniform(0.0003, 0.0005),
        unit="m",
        within=(0.0002, 0.002),
        doc="travel of the keys",
    ),
    force: ag.Float = ag.uniform(0.9, 1.8, "N", within=(0.5, 3.0), doc="force of the keys"),
    finish: ag.Material = _CASES,
    keys: ag.Material = _KEYS,
    picture: str = ag.choice("dusk", "sea", "meadow", "off", weights=(2, 2, 2, 1)),
    clock: str = ag.choice("12:30", "09:41", "18:05", "21:17"),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a closed phone on its back."""
    width = require_size(width, _WIDTHS.get(style, (0.049, 0.060)), f"width of a {style} phone")
    length = require_size(length, _LENGTHS[style], f"length of a {style} phone")
    thick = require_size(thick, _THICK.get(style, (0.0085, 0.02)), f"thickness of a {style} phone")
    travel = require_size(
        travel, (0.0002, 0.002 if style == "desk" else 0.0008), f"travel of a {style} phone"
    )
    stroke = keypads.Stroke(travel, 0.4 * force, force, friction=0.04, effort=6.0)
    room = ag.Region.centered(width, length, 0.0).with_(z=(0, thick))
    plan = _Plan(style, room, corner, finish, keys, stroke, picture, clock, maker)
    match style:
        case "flip":
            return _flip(plan, turn)
        case "slider":
            return _slider(plan)
        case "bar":
            return _bar(plan)
        case "fold":
            return _smartphone(plan, turn)
        case _:
            return _desk(plan, extra)


def _legend(text: str, high: ag.Scalar) -> ag.Profile:
    """Make the legend of a key: an icon, a telephone or letters."""
    if text in ("call", "end"):
        bow = ag.bow(0.62 * high, 0.30 * high, start=0.25, sweep=math.pi - 0.5)
        ends = [
            ag.rectangle(0.46 * high, 0.34 * high, radius=0.0002).at(x * 0.60 * high, 0.02 * high)
            for x in (-1, 1)
        ]
        sign = functools.reduce(operator.or_, ends, bow).at(0, -0.3 * high)
        return sign if text == "end" else sign.rotate(2.3)
    if text in ICONS:
        return details.icon(text, high, weight="bold")
    return keypads.word(text, 0.0030 if len(text) == 1 else 0.0022)


def _named(plan: _Plan, at: ag.VectorLike, high: float, *, up: ag.Vector = ag.Y) -> ag.Body:
    """Print the name of the maker on a face that looks up."""
    ink = controls.ink_on(plan.finish)
    return details.printed(details.logo(plan.maker, high), at, material=ink, facing=ag.Z, up=up, proud=0.0001)


def _screen(
    plan: _Plan,
    room: ag.Region,
    face: ag.Scalar,
    *,
    facing: ag.Vector = ag.Z,
    up: ag.Vector = ag.Y,
    margin: float = 0.0022,
) -> list[ag.Body]:
    """Make a pane with a picture on a face that looks up or down."""
    way = 1.0 if facing is ag.Z else -1.0
    at = (room.x.mid, room.y.mid, face)
    pane = ag.rectangle(room.x.size, room.y.size, radius=0.003)
    glass = details.printed(pane, at, material=_PANE, facing=facing, up=up, label="bezel", proud=0.0003)
    size = (room.x.size - 2 * margin, room.y.size - 2 * margin)
    at = (room.x.mid, room.y.mid, face + way * 0.0003)
    if plan.picture == "off":
        return [glass]
    clock = details.lettering((plan.clock,), 0.18 * size[0], fineness="coarse").at(0, 0.26 * size[1])
    app = ag.rectangle(0.14 * size[0], 0.14 * size[0], radius=0.035 * size[0])
    signs = [app.at(0.23 * size[0] * column, -0.38 * size[1]) for column in (-1.5, -0.5, 0.5, 1.5)]
    film = details.printed(
        functools.reduce(operator.or_, signs, clock), (at[0], at[1], at[2] + way * 0.00015),
        material=_SIGNS, facing=facing, up=up, label="display", proud=0.00012,
    )  # fmt: skip
    return [glass, *screens.picture_films(plan.picture, size, at, facing=facing, up=up, dock=False), film]


def _switched(
    body: ag.Body, picture: str, on: signals.Signal, keys: int | Sequence[str], sound: str = "tone"
) -> ag.Body:
    """Let the screen shine while it is on, and let keys sound: some, or a number of the pad."""
    body = screens.lit(body, picture, on, dock=False)
    if picture != "off":
        body = body.output("display_signs", on, kind="display", material=_SIGNS, color=_SIGNS.emission)
    return body.output(sound, _pressed(keys), kind="sound")


def _pressed(keys: int | Sequence[str]) -> signals.Signal:
    """Return the signal that a finger presses any of some keys, or of a number of the pad."""
    names = [f"key_press_{number}" for number in range(keys)] if isinstance(keys, int) else keys
    return controls.any_pressed(names)


def _folded(
    plan: _Plan, base: ag.Body, lid: ag.Body, radius: ag.Scalar, hinge: ag.Material, joint: ag.Joint
) -> ag.Body:
    """Join a lid to a base by a barrel at the far end, and by two barrels of the lid beside it."""
    room, seam = plan.room, plan.room.z.high + _SEAM / 2
    axis, inner, half = room.y.high - radius, 0.56 * room.x.high, room.x.high - 0.0016
    front = axis - radius - 0.002
    tongue = 0.55 * radius

    def barrel(low: ag.Scalar, high: ag.Scalar, z: tuple[ag.Scalar, ag.Scalar]) -> ag.Solid:
        """Make a barrel with a tongue that reaches to its half."""
        round_ = ag.cylinder(radius, high - low, axis=ag.X, bevel=0.0006).at((low + high) / 2, axis, seam)
        return round_ | ag.Region((low, high), (front, axis), z).box()

    middle = barrel(-inner, inner, (seam - 0.001 - tongue, seam - 0.001))
    ear = barrel(inner + FIT.running, half, (seam + 0.001, seam + 0.001 + tongue))
    base = ag.weld(base, ag.part(middle, "hinge", hinge))
    return base.attach(ag.weld(lid, ag.part([ear, ear.mirror(ag.X)], "hinge", hinge)), joint)


def _halves(plan: _Plan, radius: ag.Scalar, lid: ag.Scalar) -> tuple[ag.Region, ag.Region]:
    """Return the rooms of base and lid, before the barrels at the far end."""
    low = plan.room.shrink(back=2 * radius + 0.0006)
    top = low.z.high + _SEAM
    return low, low.with_(z=(top, top + lid))


def _held(plan: _Plan, room: ag.Region, solid: ag.Solid) -> ag.Frame:
    """Return the grasp of an upper half by both sides near its front."""
    return ag.grasp_on(
        solid, approach=-ag.Z, closing=ag.X, at=(0, room.y.low + 0.016, 0), depth=room.z.size - 0.001
    )


def _flip(plan: _Plan, turn: ag.Scalar) -> ag.Body:
    """Make a flip phone."""
    radius = 0.78 * plan.room.z.high
    low, high = _halves(plan, radius, plan.room.z.high - 0.0006)
    axis, seam = plan.room.y.high - radius, low.z.high + _SEAM / 2
    snap = feel.detents((-0.1 * turn, 1.1 * turn), 0.05)
    joint = ag.Revolute(
        "lid_hinge", axis=-ag.X, pivot=(0, axis, seam), limits=(0, turn), detents=snap, friction=0.006,
        damping=0.002, armature=2e-5, effort=1.5,
    )  # fmt: skip
    base = ag.part(plan.slab(low), "base", plan.shell, name="base")
    top = low.y.high - 0.004
    caps = plan.rows((*_MENU, *_DIGITS), top)
    base = plan.pad(top, top - 6 * _ROW, low.z.high, joint > 2.0).install(base, caps)
    on = screens.powered(plan.picture, signals.pressed(f"key_press_{_END}")) & (joint > 0.4)
    base = _switched(base, plan.picture, on, len(caps))
    solid = plan.slab(high)
    pane = high.shrink(0.0045, z=0)
    small = (0.024, 0.013)
    lid = ag.weld(
        ag.part(solid, "lid", plan.shell, grasp=_held(plan, high, solid)),
        *_screen(plan, pane.shrink(front=0.008), high.z.low, facing=-ag.Z, up=-ag.Y),
        details.display(
            plan.clock, *small, at=(0, high.y.low + 0.055, high.z.high), facing=ag.Z, color="white"
        ),
        _lens((0, high.y.low + 0.072, high.z.high), 0.0042),
        _named(plan, (0, high.y.low + 0.020, high.z.high), 0.0036),
    )
    return _folded(plan, base, lid, radius, plan.finish, joint)


def _lens(at: ag.VectorLike, radius: float) -> ag.Body:
    """Make the lens of a camera in its rim on a face that looks up."""
    rim = ag.cylinder(radius, 0.0012, bevel=0.0003).at(at)
    glass = ag.cylinder(0.66 * radius, 0.0015, bevel=0.0002).at(at)
    return ag.weld(ag.detail(rim, "lens", ag.material("aluminium")), ag.detail(glass, "lens", _PANE))


def _slider(plan: _Plan) -> ag.Body:
    """Make a slider: its upper half slides to the far end."""
    room = plan.room
    low = room.y.low + 0.0045
    slide = ag.Prismatic(
        "slide_up", axis=ag.Y, limits=(0, _TRAVEL), feel=_SLIDE,
        detents=feel.detents((-0.1 * _TRAVEL, 1.1 * _TRAVEL), 2.0),
    )  # fmt: skip
    base = ag.part(plan.slab(room), "base", plan.shell, name="base")
    caps = plan.rows(_DIGITS, low + 4 * _ROW)
    count = len(caps)
    base = plan.pad(low + 4 * _ROW, low, room.z.high, slide > 0.97 * _TRAVEL).install(base, caps)
    upper = room.with_(z=(room.z.high + _SEAM, room.z.high + _SEAM + 0.0072))
    solid = plan.slab(upper)
    half = ag.part(solid, "slide", plan.shell, name="slide", grasp=_held(plan, upper, solid))
    caps = plan.rows(_MENU, low + 2 * _ROW)
    half = plan.pad(low + 2 * _ROW, low, upper.z.high, None).install(half, caps, count)
    on = screens.powered(plan.picture, signals.pressed(f"key_press_{count + _END}"))
    half = _switched(half, plan.picture, on, count + len(caps))
    pane = upper.shrink(x=0.0035, front=2 * _ROW + 0.008, back=0.010, z=0)
    half = ag.weld(
        half,
        *_screen(plan, pane, upper.z.high),
        _named(plan, (0, upper.y.high - 0.0055, upper.z.high), 0.0028),
    )
    return base.attach(half, slide)


def _bar(plan: _Plan) -> ag.Body:
    """Make a phone in one piece."""
    room = plan.room
    low = room.y.low + 0.0055
    top = low + 6 * _ROW
    solid = ag.hull(
        plan.slab(room.with_(z=(0.35 * room.z.high, room.z.high))),
        plan.slab(room.shrink(0.004, z=0).with_(z=(0, 0.4 * room.z.high)), 0.0012),
    )
    base = ag.part(solid, "base", plan.shell, name="base")
    caps = plan.rows((*_MENU, *_DIGITS), top)
    base = plan.pad(top, low, room.z.high, None).install(base, caps)
    on = screens.powered(plan.picture, signals.pressed(f"key_press_{_END}"))
    base = _switched(base, plan.picture, on, len(caps))
    pane = room.shrink(x=0.0045, z=0).with_(y=(top + 0.0035, room.y.high - 0.012))
    slots = functools.reduce(operator.or_, [ag.slot(0.004, 0.0012).at(x) for x in (-0.005, 0, 0.005)])
    grille = details.printed(
        slots,
        (0, room.y.high - 0.0035, room.z.high),
        material=_PANE,
        facing=ag.Z,
        label="speaker",
        proud=0.0001,
    )
    return ag.weld(
        base,
        *_screen(plan, pane, room.z.high),
        grille,
        _named(plan, (0, room.y.high - 0.0085, room.z.high), 0.0026),
    )


def _smartphone(plan: _Plan, turn: ag.Scalar) -> ag.Body:
    """Make a folding smartphone with keys in its right side."""
    radius = 0.62 * plan.room.z.high
    low, high = _halves(plan, radius, plan.room.z.high)
    axis, seam = plan.room.y.high - radius, low.z.high + _SEAM / 2
    joint = ag.Revolute(
        "lid_hinge", axis=-ag.X, pivot=(0, axis, seam), limits=(0, turn), friction=0.12, damping=0.01,
        armature=2e-5, effort=2.0,
    )  # fmt: skip
    base = ag.part(plan.slab(low), "base", plan.shell, name="base")
    tools = functools.reduce(
        operator.or_,
        [
            details.icon(name, 0.0075).at(x)
            for name, x in zip(("chevron_left", "pause", "chevron_right"), (-0.016, 0, 0.016), strict=True)
        ],
    )
    face = low.z.high
    pane = low.shrink(0.0022, back=0.0006, z=0)
    base = ag.weld(
        base,
        details.printed(
            ag.rectangle(pane.x.size, pane.y.size, radius=0.006),
            (0, pane.y.mid, face),
            material=_PANE,
            facing=ag.Z,
            label="bezel",
            proud=0.0003,
        ),
    )
    if plan.picture != "off":
        at = (0, pane.y.mid - 0.004, face + 0.0003)
        film = details.printed(tools, at, material=_SIGNS, facing=ag.Z, label="display", proud=0.0001)
        base = ag.weld(base, film)
    for name, y, long in (
        ("power", 0.016, 0.011),
        ("volume_down", -0.004, 0.010),
        ("volume_up", -0.0196, 0.010),
    ):
        cap = controls.button_cap(
            finish=plan.finish, shape="pill", width=long, height=0.0028, proud=0.0007, deep=0.003, name=name
        )
        hole = controls.button_hole(long, 0.0028, through=0.0045)
        fitting = Fitting.moving(
            cap,
            controls.button_press(f"{name}_press", travel=0.0003, preload=0.7, force=1.8, effort=8.0),
            cut=hole,
        ).rotate(ag.Z, math.pi / 2)
        base = base.install(fitting, at=(low.x.high, low.y.mid - y, low.z.mid))
    on = screens.powered(plan.picture, signals.pressed("power_press")) & (joint > 0.4)
    base = _switched(base, plan.picture, on, ("volume_down_press", "volume_up_press"), "volume")
    solid = plan.slab(high)
    cover = high.shrink(0.0030, z=0).with_(y=(high.y.mid + 0.004, high.y.high - 0.003))
    back = details.printed(
        ag.rectangle(cover.x.size, cover.y.size, radius=0.005),
        (0, cover.y.mid, high.z.high),
        material=_PANE,
        facing=ag.Z,
        label="bezel",
        proud=0.0002,
    )
    lid = ag.weld(
        ag.part(solid, "lid", plan.shell, grasp=_held(plan, high, solid)),
        *_screen(plan, high.shrink(0.0022, back=0.0006, z=0), high.z.low, facing=-ag.Z, up=-ag.Y),
        back,
        *(_lens((x, cover.y.mid, high.z.high), 0.0062) for x in (-0.022, -0.006)),
        _named(plan, (0, high.y.low + 0.012, high.z.high), 0.0030),
    )
    return _folded(plan, base, lid, radius, plan.finish, joint)


def _desk(plan: _Plan, extra: int) -> ag.Body:
    """Make a telephone on a desk: flat while it is built, then tilted toward the user."""
    room, face = plan.room, plan.room.z.high
    pivot = (0, room.y.low, 0)
    plate = (
        room.shrink(0.004, bottom=0).with_(z=(0, 0.006)).with_(y=(room.y.low + 0.004, room.y.high - 0.012))
    )
    foot = plan.slab(plate).rotate(ag.X, -_TILT, about=pivot)
    solid = ag.hull(plan.slab(room.shrink(bottom=0.012), 0.003), foot)
    pads = [
        ag.cylinder(0.007, 0.0022, bevel=0.0005).at(side * (plate.x.high - 0.016), y, -0.0009)
        for side in (-1, 1)
        for y in (plate.y.low + 0.016, plate.y.high - 0.016)
    ]
    pads = [pad.rotate(ag.X, -_TILT, about=pivot) for pad in pads]
    base = ag.weld(
        ag.part(solid, "base", plan.shell, name="base"), ag.part(pads, "foot", ag.material("rubber"))
    )
    base = _desk_keys(base, plan, extra)
    x = room.x.low + 0.036
    for y in (-0.074, 0.074):
        cup = ag.Region.centered(0.046, 0.045, 0.0).with_(z=(face - 0.007, face + 0.01)).at(x, y)
        base = base.cut(cup.box())
    grip = ag.Region((-0.0155, 0.0155), (-0.070, 0.070), (face + 0.014, face + 0.032)).box(bevel=0.006)
    ends = []
    for y in (-0.074, 0.074):
        head = ag.Region.centered(0.043, 0.042, 0.0).with_(z=(face - 0.0062, face + 0.010)).at(y=y)
        crown = head.shrink(0.006, z=0).with_(z=(face + 0.020, face + 0.032))
        low = ag.extrude(head.plan(radius=0.010), head.z.size, bevel=0.002).at(z=head.z.mid)
        high = ag.extrude(crown.plan(radius=0.010), crown.z.size, bevel=0.005).at(z=crown.z.mid)
        ends.append(ag.hull(low, high))
    hold = ag.grasp_on(grip, approach=-ag.Z, closing=ag.X, depth=0.016)
    light = plan.finish.with_(name=f"{plan.finish.name}_handset", density=950.0)
    handset = ag.part([*ends, grip], "handset", light, name="handset", grasp=hold, grasp_width=0.041)
    lift = ag.Prismatic(
        "handset_lift", axis=ag.Z, limits=(0, 0.15), friction=0.1, damping=2.0, armature=0.01, effort=15.0
    )
    base = base.attach(handset.at(x), lift)
    return base.rotate(ag.X, _TILT, about=pivot).at(z=0.0020)


def _desk_keys(base: ag.Body, plan: _Plan, extra: int) -> ag.Body:
    """Put the display and the keys of a desk telephone beside its handset."""
    room, face = plan.room, plan.room.z.high
    pitch, step = 0.0195, 0.0178
    low, left = room.y.low + 0.020, room.x.low + 0.066
    top = low + 5 * step
    legends = (*_DIGITS, ("mute", "sound", "repeat"))
    cap, small = ag.rectangle(0.0128, 0.0108, radius=0.002), ag.rectangle(0.0128, 0.0070, radius=0.002)
    caps = []
    for number, row in enumerate((legends[-1], *legends[:-1])):
        y = top - (number + 0.5) * step
        for column, text in enumerate(row):
            outline = small if number == 0 else cap
            sign = _legend(text, 0.0042)
            place = (left + (column + 0.5) * pitch, y)
            caps.append(
                keypads.Cap(place, outline, plan.caps, sign, controls.ink_on(plan.caps), proud=0.0035)
            )
        for column in range(3, 3 + extra):
            place = (left + (column + 0.5) * pitch, y)
            sign = keypads.word(f"M{number + 1 + 5 * (column - 3)}", 0.0022)
            caps.append(
                keypads.Cap(place, small, plan.finish, sign, controls.ink_on(plan.finish), proud=0.0035)
            )
    wide = (3 + extra) * pitch
    hollow = ag.Region((left + 0.001, left + wide - 0.001), (low, top), (face - 0.0055, face))
    base = keypads.Pad(hollow, plan.stroke, plan.finish).install(base, caps)
    keys, line = _pressed(len(caps)), signals.pressed("handset_lift", (0.0, 0.03))
    lit = signals.timer(keys | line, 20.0)
    base = base.output("tone", keys, kind="sound").output("line", line, kind="sound")
    base = base.output("backlight", lit, kind="display", material=_LCD, color=(0.10, 0.16, 0.11))
    middle = left + wide / 2
    size = (wide - 0.004, 0.030)
    slots = functools.reduce(operator.or_, [ag.slot(0.018, 0.0014).at(0, 0.0032 * n) for n in range(-2, 3)])
    socket = ag.box(0.012, 0.003, 0.009, bevel=0.0005).at(0.02, room.y.high - 0.0008, 0.6 * face)
    return ag.weld(
        base,
        details.display(plan.clock, *size, at=(middle, top + 0.024, face), facing=ag.Z, color="lcd"),
        _named(plan, (middle, top + 0.046, face), 0.0040),
        details.printed(slots, (middle, low - 0.010, face), material=_PANE, facing=ag.Z, label="speaker"),
        ag.detail(socket, "socket", _PANE),
    )
