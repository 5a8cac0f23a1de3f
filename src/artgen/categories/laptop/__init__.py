"""A laptop: a thin one, a plain one with a disc tray, or one whose screen turns over by 360 degrees.

Links: `base`; `screen`, and `hinge` between both of a convertible; `trackpad`; `power`, a key; `tray`; with
`keys="all"`, a `key` of each row from 1 to 5 and column. Joints: `screen_hinge`, and `base_hinge`, which
turns half of the way of a convertible; `trackpad_press`, `power_press`, `tray_slide`, and `key_press_1_0`
to `key_press_5_9`.

Friction holds the screen where it is left. Its tab is reached with the lid closed, keys and trackpad only
with the lid open.

Sizes are those of shops: screens of 12-16 inches (16:10 or 16:9), bases of 0.28-0.37 m by 0.20-0.26 m,
11-15 mm thick or 21-26 mm with a tray, 1.0-2.4 kg. Keys have a pitch of 19 mm (ISO 9241-410), a travel of
1.0-1.5 mm and 0.5-0.7 N; trackpads click at 0.6-1.2 N. Hinges hold with 0.5-1.2 N m (catalogs of torque
hinges).
"""

import functools
import math
import operator
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details, feel, signals
from artgen.categories.shared import controls, keypads, screens
from artgen.categories.shared.finish import colors
from artgen.nodes.fitting import FIT, Fitting

Style = Literal["thin", "plain", "convertible"]
"""A thin one of metal, a plain one of plastic with a disc tray, or one with a hinge of two axes."""

_PITCH = 0.019  # distance of keys [m]
_GAP = 0.0012  # between base and closed screen [m]
_LID = 0.0058  # thickness of the screen [m]
_FEET = 0.0009  # height of the feet [m]
_WELL = 0.0027  # depth of the keys below the deck [m]
_AXLE = 0.0036  # from the edge of screen and base to the axis of a hinge [m]
_STEEL = ag.material("black_steel")
_ROWS: tuple[tuple[tuple[str, float], ...], ...] = (
    (("esc", 1.3), *((f"F{number}", 1.058) for number in range(1, 13)), ("power", 1.0)),
    *keypads.LETTERS,
    (
        ("ctrl", 1.25),
        ("fn", 1.0),
        ("alt", 1.25),
        ("", 5.5),
        ("alt", 1.0),
        ("ctrl", 1.0),
        *((k, 1.0) for k in "<^v>"),
    ),
)
"""Legend and width of each key in pitches, by row from the back."""

_METALS = ag.choice(
    *(
        ag.material("aluminium").with_(name=f"anodised_{name}", base_color=color, density=900.0)
        for name, color in {
            "silver": (0.70, 0.71, 0.72),
            "grey": (0.30, 0.31, 0.33),
            "midnight": (0.06, 0.08, 0.12),
            "champagne": (0.72, 0.62, 0.50),
            "teal": (0.20, 0.36, 0.38),
        }.items()
    )
)
_PLASTICS = ag.shades(*colors("abs", "black graphite white navy red"), color=0.03)
_CAPS = ag.choice("black_abs", *colors("abs", "graphite light_grey white"))
_PORT = ag.material("black_abs").with_(name="port_recess", base_color=(0.015, 0.015, 0.015))


@dataclass(frozen=True)
class _Plan:
    """Measures of one laptop, with the center of its base at the origin of x and y."""

    width: ag.Scalar  # [m]
    depth: ag.Scalar  # [m]
    top: ag.Scalar  # height of the deck [m]
    rear: ag.Scalar  # rear edge of the screen, which has the hinge behind it [m]

    @property
    def well(self) -> ag.Region:
        """Return the room of the keys in the deck."""
        back, half = self.depth / 2 - 0.021, 7.5 * _PITCH + 0.001
        return ag.Region(
            (-half, half), (back - 6 * _PITCH + 0.005, back + 0.004), (self.top - _WELL, self.top)
        )

    @property
    def pad(self) -> ag.Region:
        """Return the room of the trackpad in the deck."""
        free = self.well.y[0] + self.depth / 2  # before the keys
        middle = free / 2 - self.depth / 2
        deep = ag.min_(free - 0.018, 0.074) / 2
        return ag.Region(
            (-0.9 * deep - 0.026, 0.9 * deep + 0.026),
            (middle - deep, middle + deep),
            (self.top - 0.0012, self.top),
        )


@ag.category(
    labels="base foot port key trackpad screen bezel display hinge tray print rating_plate", joints=(3, 4)
)
def laptop(
    *,
    style: Style = ag.choice({"thin": 0.45, "plain": 0.3, "convertible": 0.25}),
    width: ag.Float = ag.uniform(0.312, 0.362, "m", within=(0.310, 0.38), doc="width of the base"),
    ratio: ag.Float = ag.uniform(0.66, 0.71, within=(0.64, 0.74), doc="depth of the base over its width"),
    thick: ag.Float = ag.by(
        "style",
        thin=ag.uniform(0.0105, 0.0125),
        plain=ag.uniform(0.0205, 0.0245),
        otherwise=ag.uniform(0.0115, 0.0135),
        unit="m",
        within=(0.010, 0.026),
        doc="thickness of the base",
    ),
    turn: ag.Float = ag.by(
        "style",
        thin=ag.uniform(2.0, 2.35),
        plain=ag.uniform(2.1, 2.5),
        otherwise=math.tau,
        unit="rad",
        within=(1.8, 6.2832),
        doc="angle of the open screen",
    ),
    torque: ag.Float = ag.uniform(0.7, 1.1, "N m", doc="friction of the hinge"),
    bezel: ag.Float = ag.uniform(0.005, 0.012, "m", within=(0.004, 0.02), doc="border of the display"),
    case: ag.Material = ag.by("style", plain=_PLASTICS, otherwise=_METALS),
    caps: ag.Material = _CAPS,
    picture: str = ag.choice("dusk", "sea", "meadow", "off", weights=(2, 2, 2, 1)),
    keys: Literal["still", "all"] = "still",
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a closed laptop on its feet; `keys="all"` lets all keys but those of functions move."""
    depth = ratio * width
    if style == "plain":
        thick = ag.require(thick, thick >= 0.016, "a disc tray needs room: thick must be >= 0.016 m")
    rear = depth / 2 - (0.0 if style == "convertible" else 0.012)
    plan = _Plan(width, depth, _FEET + thick, rear)
    middle = plan.top + _GAP + _LID / 2  # height of the middle of the screen [m]
    hold = feel.Feel(damping=0.02, friction=torque, armature=1e-4, effort=8.0, velocity=10.0)
    screen = _screen(plan, case, bezel, picture, maker)
    body = _base(plan, style, thick, case, maker)
    if style == "convertible":
        axle, low = depth / 2 + _AXLE, _FEET + thick / 2
        lift = ag.Revolute(
            "screen_hinge", axis=-ag.X, pivot=(0, axle, middle), limits=(0, turn / 2), feel=hold
        )
        roll = ag.Revolute("base_hinge", axis=-ag.X, pivot=(0, axle, low), follows=1.0 * lift, feel=hold)
        opened = lift > 0.8
    else:
        turn = ag.require(turn, turn <= 3.2, "only a convertible turns over: turn must be <= 3.2 rad")
        axle = rear + _AXLE
        lift = ag.Revolute("screen_hinge", axis=-ag.X, pivot=(0, axle, middle), limits=(0, turn), feel=hold)
        opened = lift > 1.6
    body = _typed(body, plan, caps, keys, opened)
    metal = case.with_(name=f"{case.name}_pad", specular_roughness=0.25)
    pad = plan.pad.box(bevel=0.0003)
    touch = ag.push_on(pad, direction=-ag.Z)
    click = ag.Spring(preload=0.4, force=1.0)
    press = ag.Prismatic(
        "trackpad_press", axis=-ag.Z, limits=(0, 0.0006), spring=click, feel=feel.SWITCH, effort=6.0
    )
    body = body.attach(ag.part(pad, "trackpad", metal, push=touch, when=opened), press)
    body = _wired(body, picture, keys, lift)
    if style == "plain":
        body = body.install(_tray(case), at=(width / 2, -0.25 * depth + 0.04, _FEET + 0.0092))
    ears, half = width / 2 - 0.062, width / 2 - 0.030
    ear = _barrel((ears + FIT.running, half), axle, middle, front=_AXLE + 0.003)
    if style != "convertible":
        fixed = _barrel((-ears, ears), axle, middle, bottom=0.5 * _LID + _GAP + 0.001)
        body = ag.weld(body, ag.part(fixed, "hinge", _STEEL))
        return body.attach(_hung(screen, ear, case), lift)
    link = ag.hull(*(ag.cylinder(_LID / 2, 2 * ears, axis=ag.X).at(0, axle, z) for z in (low, middle)))
    body = _hung(body, _barrel((ears + FIT.running, half), axle, low, front=_AXLE + 0.003), case)
    return body.attach(ag.part(link, "hinge", _STEEL).attach(_hung(screen, ear, case), lift), roll)


def _wired(body: ag.Body, picture: str, keys: str, lift: ag.Joint) -> ag.Body:
    """Let the open screen shine, which the power key switches; let the trackpad and the keys click."""
    on = screens.powered(picture, signals.pressed("power_press")) & (lift > 0.15)
    body = screens.lit(body, picture, on).output("click", signals.pressed("trackpad_press"), kind="sound")
    if keys == "still":
        return body
    rows = range(1, len(_ROWS))
    typed = [f"key_press_{row}_{column}" for row in rows for column in range(len(_ROWS[row]))]
    return body.output("keys", controls.any_pressed(typed), kind="sound")


def _barrel(x: tuple[ag.Scalar, ag.Scalar], y: ag.Scalar, z: ag.Scalar, **reach: ag.Scalar) -> ag.Solid:
    """Make a barrel of a hinge along x, with a tongue that reaches to its front or its bottom."""
    span, middle, half = x[1] - x[0], (x[0] + x[1]) / 2, 0.0026
    barrel = ag.cylinder(_LID / 2, span, axis=ag.X, bevel=0.0006).at(middle, y, z)
    thick = {"front": half, "back": half} if "bottom" in reach else {"top": half, "bottom": half}
    return barrel | ag.Region(x, (y, y), (z, z)).grow(**thick, **reach).box()


def _hung(body: ag.Body, ear: ag.Solid, case: ag.Material) -> ag.Body:
    """Add the barrel at the right and its mirror image at the left."""
    return ag.weld(body, ag.part([ear, ear.mirror(ag.X)], "hinge", case))


def _base(plan: _Plan, style: Style, thick: ag.Scalar, case: ag.Material, maker: str) -> ag.Body:
    """Make the case with the hollows of keys and trackpad, feet, ports and a rating plate."""
    soft = 0.006 if style == "plain" else 0.011
    outline = ag.rectangle(plan.width, plan.depth, radius=soft)
    solid = ag.extrude(outline, thick, bevel=0.0012 if style == "plain" else 0.0028).at(z=_FEET + thick / 2)
    solid -= plan.well.grow(top=0.005).box()
    solid -= plan.pad.grow(0.0005, top=0.005, bottom=0.0012).box()
    base = ag.part(solid, "base", case)
    corner = (plan.width / 2 - 0.03, plan.depth / 2 - 0.025)
    foot = ag.cylinder(0.006, _FEET + 0.0006, bevel=0.0004).at(z=_FEET / 2 + 0.0003)
    feet = ag.array(foot, at=[(x * corner[0], y * corner[1], 0) for x in (-1, 1) for y in (-1, 1)])
    ports = []
    level = _FEET + 0.5 * thick
    shapes = (ag.slot(0.0088, 0.0030), ag.slot(0.0088, 0.0030), ag.circle(0.0019))
    for side in (-1, 1):
        for place, shape in zip((-0.02, -0.038, -0.056), shapes[: 3 if side < 0 else 1], strict=False):
            at = (side * plan.width / 2, plan.depth / 2 + place - 0.012, level)
            ports.append(
                details.printed(shape, at, material=_PORT, facing=side * ag.X, label="port", proud=0.00015)
            )
    words = (f"{maker} 14", "20 V - 3.25 A", "Designed for desks")
    plate = details.rating_plate(0.05, 0.016, words, at=(0, 0.02, _FEET), facing=-ag.Z)
    return ag.weld(base, ag.part(feet, "foot", ag.material("rubber"), separate="feet"), plate, *ports)


def _typed(body: ag.Body, plan: _Plan, caps: ag.Material, keys: str, opened: ag.Condition) -> ag.Body:
    """Put the keys into their hollow: links, or one visual part besides the power key."""
    ink, back = controls.ink_on(caps), plan.well.y[1] - 0.004
    still, prints = [], []
    for row, legends in enumerate(_ROWS):
        deep = 0.7 * _PITCH if row == 0 else _PITCH
        x, y = -7.5 * _PITCH, back - (row + 0.2 if row else 0.35) * _PITCH
        for column, (legend, wide) in enumerate(legends):
            moves = (keys == "all" and row > 0) or legend == "power"
            high = 0.0012 if moves else _WELL - 0.0002  # a key that does not move stands on the hollow
            cap = ag.box(wide * _PITCH - 0.0026, deep - 0.0026, high, bevel=0.0004)
            at = (x + wide * _PITCH / 2, y, plan.top - 0.0002 - high / 2)
            x += wide * _PITCH
            if legend == "power":
                sign = details.icon(legend, 0.005)
                body = body.install(
                    _key(cap, sign, caps, ink, opened, "power", 0.0005), at=(*at[:2], at[2] + 0.0007)
                )
                continue
            size = 0.0030 if len(legend) == 1 else 0.0019
            sign = details.lettering((legend or "_",), size, fineness="coarse")
            if moves:
                key = _key(cap, sign, caps, ink, opened, "key", 0.0010)
                body = body.install(key.suffixed(f"_{row}_{column}"), at=at)
            else:
                still.append(cap.at(*at))
                prints.append(sign.at(*at[:2]))
    if not still:
        return body
    film = functools.reduce(operator.or_, prints)
    signs = details.printed(film, (0, 0, plan.top - 0.0002), facing=ag.Z, material=ink, proud=0.0001)
    return ag.weld(body, ag.detail(ag.union(*still), "key", caps), signs)


def _key(
    cap: ag.Solid,
    sign: ag.Profile,
    finish: ag.Material,
    ink: ag.Material,
    opened: ag.Condition,
    name: str,
    travel: float,
) -> Fitting:
    """Make a key with its print, which a spring returns."""
    stroke = keypads.Stroke(travel)
    return keypads.key(cap, finish, stroke, top=0.0006, sign=sign, ink=ink, when=opened, name=name)


def _tray(case: ag.Material) -> Fitting:
    """Make the tray of a disc drive in the right side, which slides out for the disc."""
    wide, long, high, travel = 0.128, 0.130, 0.0085, 0.105
    room = ag.Region((-long, 0.0), (-wide / 2, wide / 2), (-high / 2, high / 2))
    board = ag.part(
        room.box(bevel=0.0006), "tray", ag.material("black_abs").with_(name="tray_plastic", density=500.0)
    )
    front = ag.detail(room.with_(x=(-0.001, 0.0004)).box(), "tray", case)
    disc = details.printed(ag.ring(0.0605, 0.0195), (-long / 2, 0, high / 2), facing=ag.Z, material=_PORT)
    hub = ag.detail(
        ag.cylinder(0.0075, 0.0012, bevel=0.0003).at(-long / 2, 0, high / 2 - 0.0002), "tray", _STEEL
    )
    slide = ag.Prismatic(
        "tray_slide",
        axis=ag.X,
        limits=(0, travel),
        feel=feel.RUNNER,
        friction=0.8,
        driven="the motor of its drive",
    )
    hole = room.grow(FIT.running, left=FIT.running + 0.001, right=0.01)
    return Fitting.moving(ag.weld(board, front, disc, hub), slide, cut=hole.box())


def _screen(plan: _Plan, case: ag.Material, bezel: ag.Scalar, picture: str, maker: str) -> ag.Body:
    """Make the closed screen with its tab, the display below, and the maker's name above."""
    low = plan.top + _GAP
    end = plan.rear
    room = ag.Region((-plan.width / 2, plan.width / 2), (-plan.depth / 2, end), (low, low + _LID))
    outline = ag.rectangle(plan.width, end + plan.depth / 2, radius=0.006)
    shell = ag.extrude(outline, _LID, bevel=0.0012).at(0, (end - plan.depth / 2) / 2, low + _LID / 2)
    tab = ag.Region((-0.024, 0.024), (-plan.depth / 2 - 0.0115, -plan.depth / 2 + 0.004), (low, low + 0.004))
    lip = tab.box(bevel=0.0012)
    held = ag.grasp_on(lip, approach=ag.Y, closing=ag.Z, depth=0.0095)
    lid = ag.part(lip | shell, "screen", case, name="screen", grasp=held)
    face = room.shrink(0.0022, bottom=0.0, top=0.0)
    pane = ag.detail(face.with_(z=(low - 0.0003, low + 0.0005)).box(), "bezel", screens.GLASS)
    glass = face.shrink(bezel, back=0.010, bottom=0.0, top=0.0)
    middle = glass.anchor()
    wide, tall = glass.size[0], glass.size[1]
    at = (middle[0], middle[1], low - 0.0003)
    films = screens.picture_films(picture, (wide, tall), at, facing=-ag.Z, up=-ag.Y)
    name = details.printed(
        details.logo(maker, 0.007), (0, 0, low + _LID), material=controls.ink_on(case), facing=ag.Z, up=-ag.Y
    )
    return ag.weld(lid, pane, name, *films)
