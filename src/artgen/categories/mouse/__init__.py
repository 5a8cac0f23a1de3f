"""A computer mouse: plain, small for travel, for the right hand, for games, or one that is held upright.

Links: `body`; `button_left` and `button_right`, which bend at their rear edge; `axle`, which carries `wheel`;
`thumb_0` and `thumb_1` in the left side, from the user; `receiver` in the rear of a wireless one. Joints:
`button_left_press`, `button_right_press`; `axle_press`, the middle button, and `wheel_turn` without limits;
`thumb_press_0` and `thumb_press_1`; `receiver_slide`.

Springs return all buttons. The wheel clicks through its steps under a finger that rolls over it. A mouse for
the right hand leans to the right, and an upright one stands on its side.

Sizes are those of makers' data sheets: plain mice are 58-64 mm wide, 108-118 mm long and 36-40 mm high and
weigh 70-90 g, for travel 55-60 mm, 94-102 mm, 33-37 mm, 54-70 g, for games 62-68 mm, 118-127 mm, 38-43 mm,
80-105 g, for the right hand 63-70 mm, 112-121 mm, 42-48 mm, 95-120 g, upright ones 64-72 mm, 112-121 mm,
64-72 mm, 125-160 g. Buttons close with 0.5-0.8 N after 0.6 mm; wheels have 18-24 steps per turn.
"""

import math
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details, feel, signals
from artgen.categories.shared import controls, polar
from artgen.categories.shared.finish import casting, colors
from artgen.nodes.fitting import FIT, Fitting

Style = Literal["plain", "travel", "game", "right", "upright"]
"""Plain, small for travel, for games, for the right hand, or held upright."""

_SEAM = 0.0164  # height of the lower edge of the buttons [m]
_GAP = 0.0009  # below the buttons [m]
_STRIP = 0.0052  # half of the width of the strip between the buttons [m]
_WIDE = 0.0060  # width of a wheel [m]
_OUT = 0.0046  # height of a wheel above its strip [m]
_CLICK = 0.0006  # travel of buttons [m]
_DEEP = 0.0040  # depth of thumb keys in the side [m]
_SHARES = {"plain": 0.28, "travel": 0.18, "game": 0.22, "right": 0.18, "upright": 0.14}
_SHELLS = ag.by(
    "style",
    travel=ag.choice(
        *colors("abs", "black white light_grey blush sky mint red"), weights=(2, 2, 1, 1, 1, 1, 1)
    ),
    game=ag.choice(*colors("abs", "black white graphite"), weights=(4, 2, 1)),
    otherwise=ag.choice(*colors("abs", "black graphite grey white slate"), weights=(4, 3, 1, 2, 1)),
)
_TRIMS = ag.choice(ag.material("black_abs"), *colors("abs", "graphite grey silver"), weights=(4, 2, 1, 1))
_GLOWS = ("led_red", "led_green", "led_blue", "led_white")
_STEEL = ag.material("stainless")
_CORD = ag.material("rubber").with_(name="mouse_cord", density=1500.0)


@dataclass(frozen=True)
class _Plan:
    """Measures and materials of a mouse that is not tilted, its middle at the origin of x and y."""

    style: Style
    width: ag.Scalar  # [m]
    length: ag.Scalar  # [m]
    height: ag.Scalar  # [m]
    tilt: ag.Scalar  # to the right [rad]
    finish: ag.Material
    trim: ag.Material

    @property
    def split(self) -> ag.Scalar:
        """Rear edge of the buttons along y [m]."""
        return 0.03 * self.length

    def outside(self) -> ag.Solid:
        """Make the outside: a plate, a wider one above it, a hump for the palm and a nose, in one skin."""
        wide, long, high = self.width, self.length, self.height
        low = ag.rectangle(wide - 0.008, long - 0.008, radius=0.42 * wide)
        middle = ag.rectangle(wide, long, radius=0.44 * wide)
        parts = [
            ag.extrude(low, 0.004).at(z=0.0032),
            ag.extrude(middle, 0.010, bevel=0.0022).at(z=0.0148),
            ag.ellipsoid(0.40 * wide, 0.32 * long, 0.40 * high).at(0, -0.13 * long, 0.60 * high),
            ag.ellipsoid(0.44 * wide, 0.15 * long, 0.013).at(0, 0.30 * long, 0.0160),
        ]
        if self.style in ("right", "upright"):
            parts += self.stand()
        return ag.hull(*parts)

    def stand(self) -> list[ag.Solid]:
        """Make the plate on the table with cut corners, as it lies before the mouse is tilted."""
        wide, long = {"right": (0.90, 0.90), "upright": (1.10, 0.86)}[self.style]
        x, y, z = self.foot
        turn, rise = ag.cos(self.tilt), ag.sin(self.tilt)

        def place(aside: ag.Scalar, up: ag.Scalar) -> tuple[ag.Scalar, ag.Scalar]:
            """Turn a corner of the plate back by the tilt."""
            return (turn * (x + aside) - rise * (z + up), rise * (x + aside) + turn * (z + up))

        plates = []
        for number in range(9):
            angle = number * math.pi / 18 + 0.12
            half = math.cos(angle) ** 0.6 * wide * self.width / 2
            deep = math.sin(angle) ** 0.6 * long * self.length
            corners = [
                place(way * half, up) for way, up in ((-1, -0.002), (1, -0.002), (1, 0.001), (-1, 0.001))
            ]
            plates.append(ag.extrude(ag.polygon(corners), deep, axis=ag.Y).at(y=y))
        return plates

    @property
    def foot(self) -> tuple[ag.Scalar, float, ag.Scalar]:
        """Middle of the plate on the table after the tilt [m]."""
        if self.style == "upright":
            return (0.0185, -0.002, -0.44 * self.width)
        return (0.004, -0.002, -0.30 * self.width * self.tilt)


def _top(shell: ag.Solid, x: ag.Scalar, y: ag.Scalar) -> ag.Scalar:
    """Return the height of a shell at a place [m]."""
    return (shell & ag.box(0.0010, 0.0010, 0.3).at(x, y, 0.1)).anchor(z=1).z


@ag.category(labels="body button receiver strip axle wheel thumb foot cable lens print led", joints=(4, 7))
def mouse(
    *,
    style: Style = ag.choice(_SHARES),
    width: ag.Float = ag.by(
        "style",
        plain=ag.uniform(0.058, 0.064),
        travel=ag.uniform(0.055, 0.060),
        game=ag.uniform(0.062, 0.068),
        right=ag.uniform(0.062, 0.068),
        upright=ag.uniform(0.060, 0.064),
        unit="m",
        within=(0.053, 0.072),
        doc="width before it is tilted",
    ),
    length: ag.Float = ag.by(
        "style",
        plain=ag.uniform(0.108, 0.118),
        travel=ag.uniform(0.094, 0.102),
        game=ag.uniform(0.118, 0.127),
        otherwise=ag.uniform(0.112, 0.121),
        unit="m",
        within=(0.09, 0.135),
    ),
    height: ag.Float = ag.by(
        "style",
        travel=ag.uniform(0.033, 0.037),
        game=ag.uniform(0.038, 0.042),
        otherwise=ag.uniform(0.036, 0.040),
        unit="m",
        within=(0.032, 0.045),
        doc="height before it is tilted",
    ),
    tilt: ag.Float = ag.by(
        "style",
        right=ag.uniform(0.16, 0.28),
        upright=ag.uniform(0.88, 1.02),
        otherwise=0.0,
        unit="rad",
        within=(0.0, 1.05),
        doc="tilt to the right",
    ),
    thumbs: Literal[0, 2] = ag.by(
        "style", plain={0: 2, 2: 1}, travel=0, otherwise=2, doc="keys for the thumb"
    ),
    steps: Literal[18, 20, 24] = ag.choice(18, 20, 24, weights=(1, 1, 3), doc="steps of the wheel per turn"),
    wired: bool = ag.by("style", plain={True: 1, False: 1}, game={True: 1, False: 1}, otherwise=False),
    force: ag.Float = ag.uniform(0.5, 0.8, "N", within=(0.3, 1.5), doc="force of the buttons at their front"),
    finish: ag.Material = _SHELLS,
    trim: ag.Material = _TRIMS,
    glow: ag.Material = ag.choice(*_GLOWS, doc="light of a mouse for games"),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a mouse with its buttons toward the back, as a hand reaches for it from the front."""
    tilted = style in ("right", "upright")
    suited = tilt > 0.1 if tilted else tilt < 0.01
    width = ag.require(width, suited, "only mice for the right hand are tilted")
    plan = _Plan(style, width, length, height, tilt, finish, trim)
    shell = plan.outside()
    body = _housing(plan, shell, maker, glow)
    for side, name in ((-1, "button_left"), (1, "button_right")):
        body = body.attach(*_button(plan, shell, side, name, force))
    body = _wheel(body, plan, shell, steps)
    for number in range(thumbs):
        body = _thumb(body, plan, shell, number)
    body = _clicking(body, thumbs)
    body = (
        ag.weld(body, _cable(plan)) if wired else body.install(_receiver(style), at=(0, -length / 2, 0.0148))
    )
    aside = 0.0011 if thumbs and style != "upright" else 0.0  # half of what the keys for the thumb stand out
    if not tilted:
        return ag.weld(body, *_underside((0.0, 0.0, 0.0012), plan)).at(aside)
    x, y, z = plan.foot
    body = ag.weld(body.rotate(ag.Y, tilt), *_underside((x, y, z - 0.002), plan))
    return body.at(aside - shell.rotate(ag.Y, tilt).anchor().x, 0.0, 0.0032 - z)


def _clicking(body: ag.Body, thumbs: int) -> ag.Body:
    """Let buttons, wheel and keys for the thumb click."""
    keys = {"left": "button_left_press", "right": "button_right_press", "middle": "axle_press"}
    keys |= {name: f"thumb_press_{number}" for number, name in enumerate(("back", "forward")[:thumbs])}
    for name, joint in keys.items():
        body = body.output(f"{name}_click", signals.pressed(joint), kind="sound")
    return body


def _housing(plan: _Plan, shell: ag.Solid, maker: str, glow: ag.Material) -> ag.Body:
    """Make the body below and behind the buttons, with the strip between them and a print on the palm."""
    front = ag.Region((-0.2, 0.2), (plan.split - FIT.running, 0.2), (_SEAM - _GAP, 0.2))
    solid = shell - front.box()
    middle = front.with_(x=(-_STRIP, _STRIP)).grow(front=0.0012, bottom=0.0004)
    strip = shell.at(z=-0.0008) & shell.at(y=-0.0005) & middle.box()
    sign = details.logo(maker, 0.0021) if plan.style != "game" else details.emblem("peak", 0.012)
    y = -0.22 * plan.length
    mark = ag.extrude(sign, 0.2).at(0, y, 0.12) & shell.at(z=0.00012)
    ink = glow if plan.style == "game" else controls.ink_on(plan.finish)
    label = "led" if plan.style == "game" else "print"
    film = mark - shell.at(z=-0.0003)
    if plan.style in ("game", "right", "upright"):  # the palm has another color than the sides
        palm = ag.Region((-0.2, 0.2), (-0.2, 0.2), (_SEAM - _GAP, 0.2)).box()
        solid = (solid - palm).paint(plan.trim) | (solid & palm)
    return ag.weld(
        ag.part(solid, "body", casting(plan.finish, 0.46), name="body"),
        ag.part(strip, "strip", casting(plan.trim, 0.5)),
        ag.detail(film, label, ink),
    )


def _button(plan: _Plan, shell: ag.Solid, side: int, name: str, force: ag.Scalar) -> tuple[ag.Body, ag.Joint]:
    """Make a button of the shell, which bends about its rear edge."""
    room = ag.Region((_STRIP + FIT.running, 0.2), (plan.split, 0.2), (_SEAM, 0.2))
    room = room if side > 0 else room.mirror()
    solid = shell & room.box()
    at, step = (side * 0.28 * plan.width, 0.30 * plan.length), 0.003
    rise_x = (_top(shell, at[0] + step, at[1]) - _top(shell, at[0] - step, at[1])) / (2 * step)
    rise_y = (_top(shell, at[0], at[1] + step) - _top(shell, at[0], at[1] - step)) / (2 * step)
    into = ag.vector(rise_x, rise_y, -1.0).normalized()
    touch = ag.push_on(solid, direction=into, at=(*at, _top(shell, *at)))
    lever = plan.length / 2 - plan.split
    spring = ag.Spring(preload=0.45 * force * lever, force=force * lever)
    bend = ag.Revolute(
        f"{name}_press", axis=-ag.X, pivot=(0, plan.split, _SEAM), limits=(0, _CLICK / lever), spring=spring,
        friction=0.001, damping=0.02, armature=2e-5, effort=0.25,
    )  # fmt: skip
    return ag.part(solid, "button", casting(plan.finish, 0.40), name=name, push=touch), bend


def _wheel(body: ag.Body, plan: _Plan, shell: ag.Solid, steps: int) -> ag.Body:
    """Put the wheel into a slot of the strip."""
    radius = 0.0116
    y = 0.27 * plan.length
    z = _top(shell, 0.0, y) - 0.0008 + _OUT - radius
    slot = ag.Region.centered(_WIDE + 0.0032, 2 * radius + 0.0024, 0.0).at(y=y)
    body = body.cut(slot.with_(z=(z - radius - 0.0016, 0.2)).box())
    core = ag.cylinder(radius - 0.0006, _WIDE, axis=ag.X, bevel=0.0010)
    rim = polar([radius - 0.0006, radius - 0.0006, radius, radius] * 36)
    tread = ag.extrude(rim, 0.0042, axis=ag.X, bevel=0.0002)
    wheel = ag.weld(
        ag.part(core, "wheel", ag.material("black_abs"), name="wheel"),
        ag.detail(tread, "wheel", ag.material("rubber")),
    )
    press = ag.Prismatic(
        "axle_press", axis=-ag.Z, limits=(0, _CLICK), spring=ag.Spring(preload=0.6, force=1.4),
        feel=feel.SWITCH, friction=0.03, effort=6.0, driven="a finger on the wheel",
    )  # fmt: skip
    turn = ag.Revolute(
        "wheel_turn", axis=ag.X, detents=feel.detents(steps, 0.003), friction=0.0008, damping=2e-5,
        armature=2e-6, effort=0.02, driven="a finger that rolls over it",
    )  # fmt: skip
    pin = ag.cylinder(0.0030, 0.0008, axis=ag.X, bevel=0.0002)
    axle = ag.part(pin.at(_WIDE / 2 + 0.0007), "axle", _STEEL)
    return body.attach(axle.attach(wheel, turn), press, at=(0, y, z))


def _thumb(body: ag.Body, plan: _Plan, shell: ag.Solid, number: int) -> ag.Body:
    """Put a key for the thumb into the left side."""
    long, high, level = 0.0150, 0.0048, 0.0148
    y = plan.split - 0.0105 - 0.0185 * (1 - number)
    column = ag.box(0.2, long, high).at(-0.1, y, level)
    x = (shell & column).anchor(x=-1).x
    cap = controls.button_cap(
        finish=plan.trim, shape="pill", width=long, height=high, proud=0.0022, deep=_DEEP, name="thumb"
    )
    hole = controls.button_hole(long, high, through=_DEEP + 0.0016)
    press = controls.button_press("thumb_press", travel=0.0007, preload=0.4, force=1.0, effort=6.0)
    key = Fitting.moving(cap, press, cut=hole).rotate(ag.Z, -math.pi / 2).suffixed(f"_{number}")
    return body.install(key, at=(x, y, level))


def _receiver(style: Style) -> Fitting:
    """Make the receiver of a wireless mouse in its slot in the rear."""
    grip = ag.box(0.0140, 0.0070, 0.0062, bevel=0.0008).at(y=-0.0029)
    plug = ag.box(0.0120, 0.0150, 0.0045).at(y=0.0075)
    if style == "upright":
        hold = ag.grasp_on(grip, approach=ag.Y, closing=ag.X, depth=0.0050)
    else:
        hold = ag.grasp_on(grip, approach=-ag.Z, closing=ag.X, at=(0, -0.0112, 0), depth=0.0070)
    receiver = ag.weld(
        ag.part(grip, "receiver", ag.material("black_abs"), name="receiver", grasp=hold),
        ag.part(plug, "receiver", _STEEL.with_(name="plug_sheet", density=2500.0)),
    )
    slide = ag.Prismatic(
        "receiver_slide",
        axis=-ag.Y,
        limits=(0, 0.0165),
        friction=1.5,
        damping=1.0,
        armature=0.01,
        effort=10.0,
    )
    slot = ag.Region((-0.0074, 0.0074), (-0.01, 0.0160), (-0.0035, 0.0035)).box()
    return Fitting.moving(receiver, slide, cut=slot)


def _underside(at: tuple[ag.Scalar, ag.Scalar, ag.Scalar], plan: _Plan) -> list[ag.Body]:
    """Make the glides below, 1.2 mm thick, and the window of the sensor."""
    x, y, z = at
    glide = ag.extrude(ag.slot(0.024, 0.006), 0.0016, bevel=0.0003)
    places = [(x, y + way * 0.33 * plan.length, z - 0.0004) for way in (-1, 1)]
    window = details.printed(
        ag.circle(0.004), (x, y, z), material=ag.material("led_red"), facing=-ag.Z, label="lens"
    )
    return [ag.part([glide.at(*place) for place in places], "foot", ag.material("polypropylene")), window]


def _cable(plan: _Plan) -> ag.Body:
    """Make the cable, which lies on the table before the mouse."""
    front, radius = plan.length / 2 - 0.006, 0.0018
    way = [
        (0, 0, 0.0095),
        (0, 0.014, 0.0078),
        (0.002, 0.032, 0.0038),
        (0.014, 0.060, 0.0024),
        (0.004, 0.088, 0.0020),
    ]
    line = ag.spline([(x, front + y, z) for x, y, z in way])
    sleeve = ag.cylinder(0.0030, 0.016, axis=ag.Y, bevel=0.0008).at(0, front + 0.005, 0.0095)
    return ag.part([sleeve, ag.sweep(ag.circle(radius), line)], "cable", _CORD)
