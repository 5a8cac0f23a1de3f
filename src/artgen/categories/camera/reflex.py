"""Cameras with a large lens: reflex cameras with a grip and a screen, and cameras for film.

A lens is about the y axis with its mount on y = 0 and its front to -y. Its ring turns, its front moves out.
"""

import math
from dataclasses import dataclass

import artgen as ag
from artgen import details, feel, signals
from artgen.categories.shared import controls, polar, vessels
from artgen.categories.shared.finish import casting
from artgen.nodes.fitting import FIT, Fitting

_SIDES = 16  # facets of the solids inside rings
_RIBS = 48  # ribs of a ring
_BLACK = ag.material("black_abs")
_TUBE = ag.material("led_white").with_(name="flash_tube", emission=(0, 0, 0))
_RING = feel.Feel(friction=0.03, damping=0.004, armature=2e-5, effort=1.0)
_GLASS = ag.material("black_glass").with_(
    name="coated_glass", base_color=(0.012, 0.014, 0.035), specular_roughness=0.05
)
SCREEN = ag.material("black_glass").with_(name="camera_screen", base_color=(0.012, 0.014, 0.035))
_LEVER = feel.Feel(friction=0.004, damping=0.003, armature=2e-5, effort=0.6)
_HOLD = feel.Feel(friction=0.02, damping=0.004, armature=5e-5, effort=1.5)


@dataclass(frozen=True)
class Look:
    """Sizes and materials of a camera with a large lens."""

    body: ag.Region  # from the front to the back, without prism and grip
    shift: float  # of the lens to the right, along x [m]
    radius: ag.Scalar  # of the ring of the lens [m]
    length: ag.Scalar  # of the lens at rest [m]
    finish: ag.Material
    metal: ag.Material
    maker: str

    @property
    def axis(self) -> ag.Vector:
        """Middle of the mount of the lens [m]."""
        return ag.vector(self.shift, self.body.y.low, self.body.z.low + 0.47 * self.body.z.size)


def ribbed(outer: ag.Scalar, inner: ag.Scalar, length: ag.Scalar) -> ag.Solid:
    """Make a ring with ribs about the y axis, only to be seen."""
    outline = polar([1.0, 1.0, 0.972, 0.972] * _RIBS)
    return ag.extrude(outline.scale(outer) - ag.circle(inner), length, axis=ag.Y)


def hollow(outer: ag.Scalar, inner: ag.Scalar, ends: tuple[ag.Scalar, ag.Scalar]) -> ag.Solid:
    """Make the faceted ring that collides inside a round one, between two distances from the mount."""
    near, far = ends
    ring = vessels.hoop(outer, inner, far - near, _SIDES).rotate(ag.X, math.pi / 2)
    return ring.at(y=-(near + far) / 2)


def disc(radius: ag.Scalar, near: ag.Scalar, far: ag.Scalar, bevel: float = 0.0) -> ag.Solid:
    """Make a cylinder between two distances from the mount."""
    return ag.cylinder(radius, far - near, axis=ag.Y, bevel=bevel).at(y=-(near + far) / 2)


def reflex(look: Look, *, popup: bool, swings: bool, keys: int) -> ag.Body:
    """Make a reflex camera: a grip, a prism that may hold a flash, a dial, keys, and a screen."""
    room = look.body
    x, y, z = room.x, room.y, room.z
    grip = ag.Region((x.low, x.low + 0.028), (y.low - 0.022, y.low + 0.012), (z.low, z.high - 0.001))
    at = look.shift
    prism = ag.Region(
        (at - 0.027, at + 0.027), (y.low + 0.002, y.high - 0.010), (z.high - 0.001, z.high + 0.026)
    )
    hump = _hump(prism, 0.0195, radius=0.004, bevel=0.002)
    eye = ag.Region(
        (at - 0.016, at + 0.016), (y.high - 0.012, y.high + 0.006), (z.high + 0.002, z.high + 0.020)
    )
    skin = ag.material("leather_grain_abs").with_(name="camera_skin", base_color=(0.015, 0.015, 0.016))
    shell = look.finish.with_(name=f"{look.finish.name}_body", density=900.0)
    body = ag.weld(
        ag.part([room.box(bevel=0.007), hump], "body", shell, name="body"),
        ag.part(grip.box(bevel=0.010), "grip", skin.with_(density=900.0)),
        ag.part(eye.box(bevel=0.004), "eyepiece", ag.material("rubber")),
        ag.detail(
            eye.shrink(x=0.006, z=0.004).with_(y=(y.high + 0.004, y.high + 0.0064)).box(), "glass", _GLASS
        ),
        details.printed(
            details.logo(look.maker, 0.0042), (at, prism.y.low, z.high + 0.010), material=controls.LIGHT_INK
        ),
    )
    body = with_lens(body, look, ring="zoom_ring", reach=0.25 * look.length)
    top = ag.vector(x.low + 0.014, y.low - 0.0095, grip.z.high)
    body = _pressed(body, top, radius=0.0065)
    body = _dialed(body, (x.high - 0.0160, y.mid, z.high), "mode_dial", 0.0115, casting(_BLACK, 0.8), 0.40)
    body = _screened(body, room, keys, swings=swings)
    if popup:
        body = _flashed(body, prism)
    return _working(body, keys, popup=popup)


def shows(body: ag.Body, on: signals.Signal, menu: range) -> ag.Body:
    """Let the screen at the back shine, and some keys open its menu."""
    body = body.output("display", on, kind="display", material=SCREEN, color=(0.14, 0.16, 0.19))
    if not menu:
        return body
    keys = controls.any_pressed(f"button_slide_{number}" for number in menu)
    return body.output("menu", signals.timer(keys, 10.0) & on, kind="display")


def _working(body: ag.Body, keys: int, *, popup: bool) -> ag.Body:
    """Let the shutter click and flash; keys switch the screen and lift the flash; the dial ends at video."""
    shutter, live = signals.pressed("shutter_slide"), signals.pressed("mode_dial_turn", (2.25, 3.0))
    body = body.output("shutter", shutter, kind="sound")
    if keys:
        live = live | signals.toggle(signals.pressed("button_slide_0"))
    body = shows(body, live, range(2 if popup else 1, keys))
    if not popup:
        return body
    flash = signals.timer(shutter, 0.1) & signals.pressed("flash_hinge")
    body = body.output("flash", flash, kind="light", material=_TUBE, color=(1.0, 1.0, 1.0))
    if keys < 2:
        return body
    up = signals.pressed("button_slide_1")
    return body.output("rising", up, kind="motor", moves="flash_hinge", speed=6.0)


def _hump(room: ag.Region, half: float, *, radius: float, bevel: float) -> ag.Solid:
    """Make the hump over a prism, narrower at its top, half of which is so wide [m]."""
    x, z = room.x, room.z
    front = [(x.low, z.low), (x.high, z.low), (x.mid + half, z.high), (x.mid - half, z.high)]
    return ag.extrude(ag.polygon(front, radius=radius), room.y.size, axis=ag.Y, bevel=bevel).at(y=room.y.mid)


def _pressed(body: ag.Body, at: ag.VectorLike, *, radius: float) -> ag.Body:
    """Add the button of the shutter to a face that looks up."""
    button = controls.push_button(
        finish=ag.material("chrome"), plate=_BLACK, through=0.012, width=2 * radius, proud=0.0035,
        travel=0.0022, preload=0.4, force=1.6, name="shutter",
    )  # fmt: skip
    return body.install(button.rotate(ag.X, -math.pi / 2), at=at)


def _dialed(
    body: ag.Body, at: ag.VectorLike, name: str, radius: float, finish: ag.Material, back: float
) -> ag.Body:
    """Add a dial that clicks to a face that looks up, its mark to the side and turned back by an angle."""
    clicks = tuple(0.5 * step for step in range(7))
    turn = controls.dial_turn(f"{name}_turn", low=0.0, high=3.0, clicks=clicks, torque=0.02, friction=0.006)
    dial = controls.dial(turn, "fluted", radius, finish, depth=0.0115, name=name)
    return body.install(dial.rotate(ag.Y, math.pi / 2 - back).rotate(ag.X, -math.pi / 2), at=at)


def _screened(body: ag.Body, room: ag.Region, keys: int, *, swings: bool) -> ag.Body:
    """Add the screen at the back, which may swing out to the left, and keys at its right."""
    y, z = room.y.high, room.z
    wide, tall, thick = 0.066, 0.050, 0.0065
    x = room.x.high - 0.008 - wide / 2  # the left of a hand that holds the camera
    panel = ag.Region(
        (x - wide / 2, x + wide / 2),
        (y + 0.0008, y + 0.0008 + thick),
        (z.mid - tall / 2 - 0.003, z.mid + tall / 2 - 0.003),
    )
    face = panel.shrink(x=0.0035, z=0.0035).with_(y=(panel.y.high - 0.0004, panel.y.high + 0.0004))
    glass = ag.detail(face.box(bevel=0.0003), "screen", SCREEN)
    for number in range(keys):
        at = (room.x.low + 0.016, y, z.low + 0.016 + number * 0.019)
        key = controls.push_button(
            finish=_BLACK,
            plate=_BLACK,
            through=0.009,
            width=0.009,
            proud=0.0028,
            deep=0.006,
            travel=0.0015,
            force=2.0,
        )
        body = body.install(key.rotate(ag.Z, math.pi).suffixed(f"_{number}"), at=at)
    if not swings:
        plate = panel.with_(y=(y - 0.001, y + 0.0022))
        film = face.with_(y=(y + 0.0018, y + 0.0026))
        return ag.weld(
            body, ag.part(plate.box(bevel=0.0008), "screen", _BLACK), ag.detail(film.box(), "screen", SCREEN)
        )
    axis = (panel.x.high + 0.0032, panel.y.mid)
    pin = ag.cylinder(0.0028, 0.010).at(*axis)
    ends = [pin.at(z=panel.z.low + 0.006), pin.at(z=panel.z.high - 0.006)]
    foot = ag.box(0.0045, 0.006, 0.010).at(axis[0], axis[1] - 0.003)
    feet = [foot.at(z=panel.z.low + 0.006), foot.at(z=panel.z.high - 0.006)]
    knuckle = ag.cylinder(0.0028, tall - 0.023).at(*axis, panel.z.mid)
    tongue = panel.with_(x=(panel.x.high - 0.001, panel.x.high + 0.002)).shrink(z=0.0115)
    screen = ag.weld(
        ag.part(
            [panel.box(bevel=0.0012), knuckle, tongue.box()], "screen", casting(_BLACK, 0.9), name="screen"
        ),
        glass,
    )
    body = ag.weld(body, ag.part([*ends, *feet], "hinge", _BLACK))
    swing = ag.Revolute(
        "screen_hinge",
        axis=-ag.Z,
        pivot=(*axis, panel.z.mid),
        limits=(0.0, math.pi),
        feel=_HOLD,
        driven="a thumb at the edge of the screen",
    )
    return body.attach(screen, swing)


def _flashed(body: ag.Body, prism: ag.Region) -> ag.Body:
    """Add a flash that stands up from the prism."""
    y, low = prism.y, prism.z.high
    lid = ag.Region(
        (prism.x.mid - 0.0135, prism.x.mid + 0.0135), (y.low, y.high - 0.010), (low + 0.0008, low + 0.0085)
    )
    tube = lid.shrink(x=0.003).with_(y=(y.low + 0.004, y.low + 0.018), z=(low + 0.0004, low + 0.0010))
    pivot = (prism.x.mid, lid.y.high - 0.004, low + 0.0045)
    ears = [
        ag.Region(
            (x - 0.002, x + 0.002), (pivot[1] - 0.004, pivot[1] + 0.004), (low - 0.001, low + 0.008)
        ).box(bevel=0.001)
        for x in (lid.x.low - 0.0028, lid.x.high + 0.0028)
    ]
    flash = ag.weld(
        ag.part(lid.box(bevel=0.0025), "flash", casting(_BLACK, 0.8), name="flash"),
        ag.detail(tube.box(), "flash", _TUBE),
    )
    rise = ag.Revolute(
        "flash_hinge", axis=-ag.X, pivot=pivot, limits=(0.0, 0.7), feel=_LEVER,
        detents=feel.detents((-0.07, 0.77), 0.02), driven="the spring of the flash",
    )  # fmt: skip
    return ag.weld(body, ag.part(ears, "hinge", _BLACK)).attach(flash, rise)


def film(look: Look, leather: ag.Material) -> ag.Body:
    """Make a camera for film: a lever that winds it, a knob that rewinds it, dials, and a back that opens."""
    room = look.body
    x, y, z = room.x, room.y, room.z
    cap, shoe = 0.016, 0.008  # heights of the metal above and below the leather
    door = 0.0045
    chamber = room.with_(y=(y.high - door - 0.010, y.high + 0.001)).shrink(
        x=0.012, top=cap + 0.004, bottom=shoe + 0.004
    )
    plan = room.plan(radius=0.0100)
    tall = z.size - cap - shoe + 0.001
    skin = ag.extrude(room.shrink(0.0003).plan(radius=0.0097), tall).at(z=z.low + shoe - 0.0005 + tall / 2)
    core = skin.split(point=(0, y.high - door, 0), normal=-ag.Y)
    shell = look.metal.with_(name=f"{look.metal.name}_cap", density=1300.0)
    lid = ag.extrude(plan, cap, bevel=0.002).at(z=z.high - cap / 2)
    floor = ag.extrude(plan, shoe, bevel=0.002).at(z=z.low + shoe / 2)
    prism = ag.Region(
        (look.shift - 0.022, look.shift + 0.022),
        (y.low + 0.001, y.high - 0.004),
        (z.high - 0.001, z.high + 0.014),
    )
    hump = _hump(prism, 0.0115, radius=0.002, bevel=0.0015)
    inside = leather.with_(name=f"{leather.name}_body", density=900.0)
    body = ag.weld(
        ag.part([core - chamber.box()], "body", inside, name="body"),
        ag.part([lid, floor, hump], "cap", shell),
        details.printed(
            details.logo(look.maker, 0.0040),
            (look.shift, prism.y.low, z.high + 0.004),
            material=controls.DARK_INK,
        ),
    )
    body = with_lens(body, look, ring="focus_ring", reach=0.16 * look.length)
    body = _pressed(body, (x.low + 0.0170, y.low + 0.0076, z.high), radius=0.0055)
    body = _dialed(body, (x.low + 0.0385, y.mid + 0.001, z.high), "speed_dial", 0.0090, look.metal, 0.38)
    body = _wound(body, (x.low + 0.0155, y.mid + 0.009, z.high), look.metal)
    body = body.output("shutter", signals.pressed("shutter_slide"), kind="sound")
    body = body.output("winding", signals.pressed("lever_turn"), kind="sound")
    body = _rewound(body, (x.high - 0.0135, y.mid, z.high), look.metal)
    return _backed(body, room, skin, leather, door, (cap, shoe))


def _wound(body: ag.Body, at: ag.VectorLike, metal: ag.Material) -> ag.Body:
    """Add the lever that winds the film and springs back."""
    low = FIT.running
    hub = ag.cylinder(0.0068, 0.006, bevel=0.0008).at(z=low + 0.003)
    arm = ag.hull(
        ag.cylinder(0.006, 0.0024).at(0, 0.003, low + 0.0040),
        ag.cylinder(0.004, 0.0024).at(0.0, 0.024, low + 0.0040),
    )
    tip = ag.box(0.013, 0.009, 0.007, bevel=0.001).at(0, 0.0275, low + 0.004)
    lever = ag.part([hub, arm, tip], "lever", metal, name="lever", push=ag.push_on(tip, direction=-ag.X))
    wind = ag.Revolute(
        "lever_turn", axis=ag.Z, limits=(0.0, 1.6), spring=ag.Spring(preload=0.006, force=0.02), feel=_LEVER
    )
    return body.attach(lever, wind, at=at)


def _rewound(body: ag.Body, at: ag.VectorLike, metal: ag.Material) -> ag.Body:
    """Add the knob that rewinds the film, with its folded crank."""
    knob = controls.control_knob(finish=metal, style="round", radius=0.009, depth=0.0115, name="rewind_knob")
    crank = ag.Region((-0.0075, 0.0075), (-0.0128, -0.0112), (-0.0022, 0.0022)).box(bevel=0.0006)
    knob = ag.weld(knob, ag.detail(crank, "knob", ag.material("chrome")))
    turn = ag.Revolute("rewind_knob_turn", axis=ag.Y, feel=feel.DIAL, friction=0.01)
    turned = Fitting.moving(knob, turn).rotate(ag.Y, math.pi / 2 - 0.58).rotate(ag.X, -math.pi / 2)
    return body.install(turned, at=at)


def _backed(
    body: ag.Body,
    room: ag.Region,
    skin: ag.Solid,
    leather: ag.Material,
    door: float,
    ends: tuple[float, float],
) -> ag.Body:
    """Add the back that opens for the film, hinged at the right of the lens."""
    cap, shoe = ends
    y = room.y.high
    leaf = room.with_(y=(y - door + 0.0006, y)).shrink(
        top=cap + 0.0006, bottom=shoe + 0.0006, right=0.0040, left=0.0015
    )
    tab = ag.Region(
        (leaf.x.low - 0.0085, leaf.x.low + 0.001),
        (leaf.y.low, leaf.y.high),
        (leaf.z.mid - 0.009, leaf.z.mid + 0.009),
    )
    pivot = (room.x.high - 0.0010, y - 0.0010, leaf.z.mid)
    pin = ag.cylinder(0.0022, leaf.z.size - 0.0004).at(*pivot)
    tongue = leaf.with_(x=(leaf.x.high - 0.001, pivot[0]), y=(y - 0.0026, y - 0.0002)).shrink(z=0.002)
    plate = ag.detail(
        leaf.shrink(0.0006)
        .with_(y=(leaf.y.low - 0.0012, leaf.y.low + 0.0004))
        .shrink(x=0.026, z=0.006)
        .box(),
        "back",
        _BLACK,
    )
    hold = ag.grasp_on(tab.box(), approach=ag.X, closing=ag.Y, depth=0.005)
    stuff = leather.with_(name=f"{leather.name}_back", density=1500.0)
    back = ag.weld(
        ag.part([leaf.box() & skin, pin, tongue.box()], "back", stuff, name="back"),
        ag.part(tab.box(bevel=0.0008), "tab", ag.material("chrome"), grasp=hold),
        plate,
    )
    turn = ag.Revolute("back_hinge", axis=-ag.Z, pivot=pivot, limits=(0.0, 1.9), feel=_HOLD)
    return body.attach(back, turn)


def with_lens(body: ag.Body, look: Look, *, ring: str, reach: ag.Scalar) -> ag.Body:
    """Add a lens: its ring turns by a quarter and moves its front by a reach [m]."""
    big, long = look.radius, look.length
    core, slide = 0.74 * big, 0.62 * big
    base, mid, lip = 0.011, 0.50 * long, 0.80 * long
    steel = look.metal.with_(name=f"{look.metal.name}_mount")
    fixed = [
        disc(0.95 * big, -0.001, base, 0.001),
        disc(core, 0.0, mid),
        hollow(core, slide, (mid - 0.001, lip - 0.002)),
    ]
    body = ag.weld(
        body,
        ag.part(fixed, "lens", casting(_BLACK, 0.9)).at(look.axis),
        ag.detail(disc(1.02 * big, -0.001, 0.003, 0.0008), "mount", steel).at(look.axis),
    )
    solid = hollow(big, core + 0.0007, (base + FIT.running, lip - FIT.running))
    grip = ag.cylinder(big, 0.001, axis=ag.Y).at(y=0.0045 - lip)  # the hand stays before the barrel
    hold = ag.grasp_on(grip, approach=ag.Y, closing=ag.X, depth=0.0045)
    seen = ribbed(1.012 * big, core + 0.001, lip - base - 0.008).at(y=-(base + lip) / 2 - 0.002)
    plain = ag.tube(big + 0.0002, core + 0.001, lip - base - 0.0014, axis=ag.Y, bevel=0.0006).at(
        y=-(base + lip) / 2
    )
    rubber = ag.material("rubber").with_(name="lens_rubber", density=700.0)
    turning = ag.weld(
        ag.part(solid, "ring", rubber, name=ring, grasp=hold, grasp_width=2 * big + 0.008),
        ag.detail([seen, plain], "ring", rubber),
    )
    turn = ag.Revolute(f"{ring}_turn", axis=ag.Y, limits=(0.0, math.pi / 2), feel=_RING)
    body = body.attach(turning, turn, at=look.axis)
    front = [
        disc(slide - 0.0007, mid + 0.003, lip),
        disc(0.94 * big, lip, long - 0.004, 0.0008),
        hollow(0.93 * big, 0.76 * big, (long - 0.0045, long)),
    ]
    rim = ag.tube(0.94 * big, 0.76 * big, 0.0046, axis=ag.Y, bevel=0.0008).at(y=0.0021 - long)
    glass = ag.dome(0.70 * big, height=0.0030, axis=-ag.Y).at(y=0.0042 - long)
    words = f"{look.maker.upper()}  35-70 mm  1:3.5"
    band = _around(words, 0.735 * big)
    barrel = ag.weld(
        ag.part(front, "lens", casting(_BLACK, 0.8), name="barrel"),
        ag.detail(rim, "lens", _BLACK),
        ag.detail(glass, "glass", _GLASS),
        details.printed(band, (0, 0.00385 - long, 0), material=controls.LIGHT_INK),
    )
    out = ag.Prismatic(
        "barrel_slide", axis=-ag.Y, follows=(2 / math.pi) * reach * turn, damping=1.0, armature=0.01
    )
    return body.attach(barrel, out, at=look.axis)


def _around(words: str, radius: ag.Scalar) -> ag.Profile:
    """Make letters around a circle, read from its inside."""
    made = None
    for number, letter in enumerate(words):
        if letter == " ":
            continue
        turn = 0.95 - 0.068 * number
        glyph = details.lettering((letter,), 0.0022, fineness="coarse").at(0, radius).rotate(turn)
        made = glyph if made is None else made | glyph
    assert made is not None
    return made
