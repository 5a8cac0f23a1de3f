"""A blender: a jug or a cup that twists off its base and lifts, with a lid, a filler cap, a dial and buttons.

Links: `base`, `jug`; `lid` and `cap`, the stopper of the hole in the lid; `blade`; `dial`; `button_0`, ...
Joints: `jug_turn` and `jug_lift`; `lid_lift`, `cap_lift`; `blade_spin`; `dial_turn`; `button_slide_0`, ...

A jug has a bayonet: it turns by half a radian, and only then it lifts off. A lid sits in its jug with the
friction of its seal, and a cap lies in the hole of the lid. A dial clicks at its speeds.

Sizes are those of shops and catalogs. Blenders with a jug of 1.5-2 l are 380-440 mm high on a base of
170-210 mm and weigh 3.0-5.5 kg (KitchenAid K150: 3.4 kg, Vitamix E310: 4.8 kg); retro ones have a round base
of die-cast metal (Smeg BLF01: 397 mm, 6.0 kg). Personal blenders with a cup of 0.5-0.7 l are 290-360 mm high,
110-130 mm wide and weigh 1.0-1.9 kg (NutriBullet 600). They are empty.
"""

import math
from functools import reduce
from operator import or_
from typing import Literal

import artgen as ag
from artgen import details, signals
from artgen.categories.shared import controls, vessels
from artgen.categories.shared.finish import colors
from artgen.nodes.fitting import FIT, Fitting

Style = Literal["jug", "retro", "personal"]
"""A blender with a jug on a tapered base, one on a round base of metal, or one with a cup upside down."""

_TURN = 0.52  # of the bayonet [rad]
_SWEEP = 4.2  # of a dial [rad]
_FASTEST = 300.0  # speed of the blades, that of a motor under load [rad/s]
_DIAL = 0.019  # its radius [m]
_CLEAR = ag.material("polycarbonate").with_(name="jug_clear", opacity=0.28)
_GLASS = ag.material("glass").with_(name="jug_glass", opacity=0.22)
_SMOKE = ag.material("polycarbonate").with_(name="jug_smoke", base_color=(0.16, 0.16, 0.17), opacity=0.55)
_PLASTICS = ag.shades(
    "black_abs",
    "glossy_plastic_black",
    *colors("glossy_plastic", "white graphite red cream navy silver"),
    color=0.04,
)
_METALS = ag.choice(*colors("enamel", "cream red sky mint black pink"), "chrome")
_STEEL = ag.material("stainless")
_CHROME = ag.material("chrome")
_INK = ag.colored("abs", "white").with_(name="scale_ink", texture="", tile=None)
_GREY = ag.colored("abs", "light_grey")
_BLACK = ag.material("black_abs")


@ag.category(
    labels="base foot rim cord collar jug handle lid cap tab blade dial button bezel panel print",
    joints=(2, 10),
)
def blender(
    *,
    style: Style = ag.choice({"jug": 0.45, "retro": 0.25, "personal": 0.3}),
    width: ag.Float = ag.by(
        "style",
        personal=ag.uniform(0.108, 0.128),
        retro=ag.uniform(0.165, 0.195),
        jug=ag.uniform(0.165, 0.205),
        unit="m",
        within=(0.10, 0.22),
        doc="width of the base",
    ),
    high: ag.Float = ag.by(
        "style",
        personal=ag.uniform(0.145, 0.185),
        otherwise=ag.uniform(0.155, 0.195),
        unit="m",
        within=(0.13, 0.21),
        doc="height of the base",
    ),
    jug_height: ag.Float = ag.by(
        "style",
        personal=ag.uniform(0.135, 0.175),
        otherwise=ag.uniform(0.185, 0.225),
        unit="m",
        within=(0.12, 0.24),
        doc="height of the jug or the cup",
    ),
    mouth: ag.Float = ag.uniform(
        0.066, 0.073, unit="m", within=(0.064, 0.076), doc="outer radius of the rim of a jug"
    ),
    waist: ag.Float = ag.uniform(0.70, 0.82, doc="height of the shoulder of a square base over its height"),
    control: Literal["dial", "buttons", "both"] = ag.by(
        "style", personal="buttons", retro="dial", jug={"dial": 0.35, "buttons": 0.2, "both": 0.45}
    ),
    buttons: int = ag.by(
        "style", personal=ag.choice(0, 1), otherwise=ag.count(2, 4), doc="number of buttons, if any"
    ),
    button_shape: controls.ButtonShape = ag.choice("round", "square", "pill"),
    button_force: ag.Float = ag.uniform(2.0, 4.0, "N"),
    speeds: int = ag.choice(4, 6, 8, doc="clicks of a dial"),
    dial_style: controls.DialStyle = ag.choice("round", "fluted", "skirted", "capped"),
    dial_torque: ag.Float = ag.uniform(0.03, 0.08, "N m", doc="greatest torque of the detents of a dial"),
    seal: ag.Float = ag.uniform(3.0, 8.0, "N", doc="friction of the lid in the jug"),
    finish: ag.Material = ag.by("style", retro=_METALS, otherwise=_PLASTICS, doc="base"),
    clear: ag.Material = ag.by(
        "style", personal=ag.choice(_CLEAR, _SMOKE), otherwise=ag.choice(_CLEAR, _GLASS), doc="jug or cup"
    ),
    trim: ag.Material = ag.choice("black_abs", _GREY, doc="lid, collar, handle"),
    knob: ag.Material = ag.shades("black_abs", "chrome", "stainless", color=0.03),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a blender with its jug on the base."""
    ag.require(style != "retro" or control == "dial", "style=retro has a dial: control must be dial")
    least = {"jug": 0.15, "retro": 0.125, "personal": 0.1}[style]
    width = ag.require(width, width >= least, f"width of a {style} blender must be >= {least:g} m")
    neck = 0.043 if style == "personal" else 0.056  # radius of the collar of the jug
    body, face, low = _base(style, width, high, waist, neck, finish, maker)
    if style == "personal":
        if buttons:
            key = _button("round", "power", button_force)
            body = body.install(key, at=(0, face, low))
        body = _seat(body, _cup(neck, jug_height, clear, trim), high)
        return body.output("blend", signals.pressed("button_slide"), kind="sound") if buttons else body
    jug_height = ag.require(jug_height, jug_height >= 0.14, "height of a jug must be >= 0.14 m")
    jug = _jug(neck, mouth, jug_height, clear, trim)
    jug = jug.install(_lid(mouth, jug_height, seal, trim, clear))
    jug = jug.install(_blade())
    if control != "buttons":
        clicks = [_SWEEP * step / (speeds - 1) for step in range(speeds)]
        joint = controls.dial_turn(
            "dial_turn", low=0.0, high=_SWEEP, friction=0.01, clicks=clicks, torque=dial_torque
        )
        scale = controls.dial_print(
            _DIAL, ink=controls.ink_on(_BLACK), style="numbers", count=speeds, sweep=_SWEEP, start=_SWEEP / 2
        )
        dial = controls.dial(joint, dial_style, _DIAL, knob, depth=0.020, cap=_STEEL, scale=scale)
        x = -0.034 if control == "both" else 0.0
        body = body.install(dial, at=(x, face, low))
    if control != "dial":
        for index, icon in enumerate(("power", "snowflake", "timer", "drop")[:buttons]):
            step = index - (buttons - 1) / 2
            at = (0.034, face, low - 0.017 * step) if control == "both" else (0.025 * step, face, low)
            body = body.install(_button(button_shape, icon, button_force).suffixed(f"_{index}"), at=at)
    return _blending(_seat(body, jug, high), control, buttons)


def _blending(body: ag.Body, control: Literal["dial", "buttons", "both"], buttons: int) -> ag.Body:
    """Let the dial and the keys run the blades while the jug is locked."""
    runs = [signals.level("dial_turn")] if control != "buttons" else []
    if control != "dial":
        power, *programs = (signals.pressed(f"button_slide_{index}") for index in range(buttons))
        runs += [signals.toggle(power), *programs]
    locked = ~signals.pressed("jug_turn", (0.0, 0.1))
    speed = reduce(or_, runs) & locked
    return body.output("blend", speed, kind="motor", moves="blade_spin", speed=_FASTEST)


def _button(shape: controls.ButtonShape, icon: str, force: ag.Scalar) -> Fitting:
    """Make a button with a plate around it, which covers the corners of its hole."""
    wide, high = (0.017, 0.0105) if shape == "pill" else (0.0125, 0.0125)
    return controls.push_button(
        finish=_STEEL, plate=_BLACK, through=0.016, shape=shape, width=wide, height=high, force=force,
        icon=icon, ink=controls.DARK_INK,
    )  # fmt: skip


def _seat(body: ag.Body, jug: ag.Body, high: ag.Scalar) -> ag.Body:
    """Set a jug on its bayonet: it turns, and then lifts off."""
    turn = ag.Revolute("jug_turn", axis=ag.Z, limits=(0, _TURN), friction=0.3, damping=0.05, effort=15.0)
    lift = ag.Prismatic(
        "jug_lift", axis=ag.Z, limits=(0, 0.12), friction=0.3, damping=2.0, effort=80.0,
        needs=(turn > _TURN - 0.04).beyond(0.0008),
    )  # fmt: skip
    return body.attach(jug, lift, turn, at=(0, 0, high))


def _base(
    style: Style,
    width: ag.Scalar,
    high: ag.Scalar,
    waist: ag.Scalar,
    neck: float,
    finish: ag.Material,
    maker: str,
) -> tuple[ag.Body, ag.Scalar, ag.Scalar]:
    """Make the base with its feet, cord and hooks; return it with the y and z of its controls."""
    radius, top = width / 2, neck + (0.014 if style == "personal" else 0.016)
    shell = finish.with_(name=f"{finish.name}_motor", density=1050.0 if style == "retro" else 620.0)
    shoulder = waist * high
    if style == "jug":
        lower = ag.Region((-radius, radius), (-radius, radius), (0.006, shoulder)).box(bevel=0.012)
        wide, cut = radius - 0.003, 0.012 * (2 - math.sqrt(2))
        # one collider is below the jug: no seam pushes it aside
        taper = ag.hull(
            ag.box(2 * wide, 2 * wide, 0.030, bevel=0.012).at(z=shoulder - 0.010),
            ag.cylinder(top, 0.012, bevel=0.003).at(z=high - 0.006),
        )
        foot = ag.extrude(vessels.chamfered(2 * wide, 2 * wide, cut), 0.030 - cut).at(
            z=shoulder - 0.010 - cut / 2
        )
        inner, less = 2 * (wide - cut), (math.sqrt(2) - 1) * cut
        edge = ag.extrude(vessels.chamfered(inner, inner, less), 0.001).at(z=shoulder + 0.0045)
        deck = ag.extrude(vessels.around(top), 0.001).at(z=high - 0.0005)
        solids = [lower, ag.bounding_collider(taper, ag.hull(foot, edge, deck))]
    else:
        cone = ag.frustum(radius, top, high - 0.006, bevel=0.005).at(z=0.003 + high / 2)
        solids = [
            ag.bounding_collider(cone, ag.loft([vessels.around(radius), vessels.around(top)], (0.006, high)))
        ]
    _, hooks = vessels.bayonet(neck, half=0.010)
    feet = ag.array(
        ag.cylinder(0.010, 0.008, bevel=0.001), at=ag.ring_points((0, 0, 0.004), 0.72 * radius, count=4)
    )
    line = [
        (0, radius - 0.004, 0.012), (0, radius + 0.035, 0.010), (0.015, radius + 0.07, 0.0047),
        (0.05, radius + 0.085, 0.0047),
    ]  # fmt: skip
    cord = ag.sweep(ag.regular_polygon(8, 0.0036), ag.spline(line))
    body = ag.weld(
        ag.part(solids, "base", shell),
        ag.part(hooks.at(z=high), "rim", _BLACK),
        ag.part(feet, "foot", ag.material("rubber")),
        ag.part(cord, "cord", _BLACK),
    )
    if style == "jug":
        face, upper = -radius - controls.PANE, shoulder - 0.013
        pane = controls.inlay(0.80 * width, upper - 0.018, radius=0.006)
        mark = details.printed(
            details.logo(maker, 0.0050), (0, face, upper - 0.008), material=controls.LIGHT_INK
        )
        body = ag.weld(body, pane.at(0, -radius, (upper + 0.018) / 2), mark)
        return body, face, (upper + 0.006) / 2
    slope = (top - radius) / (high - 0.006)
    low = 0.40 * high
    face = -radius - slope * (low - 0.006)
    band = ag.tube(radius + 0.0006, radius - 0.004, 0.010, bevel=0.001).at(z=0.016)
    wall = ag.line((radius + 0.0003, 0, 0.006), (top + 0.0003, 0, high))
    size = 0.0065 if style == "retro" else 0.0055
    mark = details.wrapped(details.logo(maker, size), wall, 0.80 * high, material=controls.ink_on(finish))
    body = ag.weld(body, mark)
    if style == "personal":
        return ag.weld(body, ag.detail(band, "rim", _BLACK)), face, low
    face = -radius - 0.005
    disc = ag.cylinder_between((0, face, low), (0, -0.5 * radius, low), 0.041, bevel=0.001)
    ring = ag.cylinder_between((0, face + 0.003, low), (0, -0.6 * radius, low), 0.0445, bevel=0.002)
    body = ag.weld(
        body,
        ag.part(disc, "base", _BLACK.with_(name="console", density=700.0)),
        ag.detail(ring, "rim", _CHROME),
        ag.detail(band, "rim", _CHROME),
    )
    return body, face, low


def _collar(neck: float, tall: float, trim: ag.Material) -> ag.Body:
    """Make the collar of a jug with the lugs of its bayonet, about its seat: the link `jug`."""
    lugs, _ = vessels.bayonet(neck, half=0.010)
    ring = ag.cylinder(neck, tall, bevel=0.0015).at(z=FIT.running + tall / 2)
    light = trim.with_(name=f"{trim.name}_collar", density=620.0)
    return ag.part([ring, lugs], "collar", light, name="jug")


def _jug(neck: float, rim: ag.Scalar, tall: ag.Scalar, clear: ag.Material, trim: ag.Material) -> ag.Body:
    """Make an open jug with its handle on its collar."""
    low, wall = 0.034, 0.0032 if clear.name == "jug_clear" else 0.0042
    bottom, end = neck - 0.003, low + tall
    path = ag.polyline([(0.004, 0, 0), (bottom, 0, 0), (rim, 0, tall)], fillet=wall + 0.0012)
    glass = vessels.blown(path, "jug", clear, foot=bottom, wall=wall, level=1.4 * wall + 0.0009).at(z=low)
    line = [
        (rim - 0.003, 0, end - 0.018), (rim + 0.052, 0, end - 0.018), (rim + 0.046, 0, low + 0.045),
        (0.060, 0, low + 0.045),
    ]  # fmt: skip
    bar = ag.sweep(ag.rectangle(0.022, 0.014, radius=0.004), ag.polyline(line, fillet=0.010))
    hold = ag.grasp_on(bar, approach=-ag.X, closing=ag.Y, at=(rim + 0.049, 0, low + 0.6 * tall), depth=0.012)
    collar = _collar(neck, low + 0.002, trim)
    side = ag.line((bottom + 0.0002, 0, low), (rim + 0.0002, 0, end))
    scale = [
        details.wrapped(details.lettering((f"{level} ml",), 0.0042), side, low + share * tall, material=_INK)
        for level, share in ((500, 0.30), (1000, 0.54), (1500, 0.76))
    ]
    return ag.weld(collar, glass, ag.part(bar, "handle", trim, grasp=hold), *scale)


def _lid(rim: ag.Scalar, tall: ag.Scalar, seal: ag.Scalar, trim: ag.Material, clear: ag.Material) -> Fitting:
    """Make the lid in the rim of a jug, with a tab in front, and the cap in its hole."""
    hole, low = 0.022, 0.034 + tall + FIT.running
    inner = rim - 0.0085  # of the plug in a jug with a wall of 4 mm
    mouth, wide = (vessels.around(hole + gap, 8) for gap in (0.0004, 0.0009))
    plate = ag.extrude(ag.circle(rim + 0.003) - mouth, 0.012, bevel=0.002).at(z=low + 0.006)
    plug = ag.extrude(ag.circle(inner) - wide, 0.016).at(z=low - 0.006)
    around = [vessels.around(each, 16) - cut for each, cut in ((rim + 0.003, mouth), (inner, wide))]
    plate = ag.bounding_collider(plate, ag.extrude(around[0], 0.012).at(z=low + 0.006))
    plug = ag.bounding_collider(plug, ag.extrude(around[1], 0.016).at(z=low - 0.006))
    tab = ag.Region((-0.014, 0.014), (-rim - 0.017, -rim + 0.004), (low + 0.003, low + 0.010)).box(
        bevel=0.002
    )
    hold = ag.grasp_on(tab, approach=ag.Y, closing=ag.Z, depth=0.0095)
    soft = trim.with_(name=f"{trim.name}_lid", density=900.0)
    lid = ag.weld(ag.part(tab, "tab", soft, name="lid", grasp=hold), ag.part([plate, plug], "lid", soft))
    stem = ag.cylinder(hole, 0.020).at(z=low + 0.004)
    head = ag.cylinder(0.0265, 0.018, bevel=0.003).at(z=low + 0.012 + FIT.running + 0.009)
    pick = ag.grasp_on(head, approach=-ag.Z, closing=ag.X, depth=0.014)
    light = clear.with_(name="cap_clear", density=500.0)
    cap = ag.part([head, stem], "cap", light, name="cap", grasp=pick)
    out = ag.Prismatic("cap_lift", axis=ag.Z, limits=(0, 0.06), friction=0.5, damping=1.0, effort=20.0)
    lift = ag.Prismatic("lid_lift", axis=ag.Z, limits=(0, 0.10), friction=seal, damping=2.0, effort=60.0)
    return Fitting.moving(lid.attach(cap, out), lift)


def _blade() -> Fitting:
    """Make the blades over the floor of a jug, which the motor turns."""
    low = 0.034 + 0.0085
    hub = ag.cylinder(0.0075, 0.014, bevel=0.001).at(z=low + 0.007)
    wing = ag.hull(
        ag.box(0.004, 0.012, 0.0016).at(0.006, 0, low + 0.006),
        ag.box(0.004, 0.005, 0.0016).at(0.028, 0, low + 0.012),
    )
    wings = [wing.rotate(ag.Z, turn * math.pi / 2) for turn in range(4)]
    spin = ag.Revolute(
        "blade_spin", axis=ag.Z, friction=0.02, damping=1e-4, armature=2e-4, effort=3.0,
        velocity=_FASTEST, driven="a motor",
    )  # fmt: skip
    return Fitting.moving(ag.part([hub, *wings], "blade", _STEEL), spin)


def _cup(neck: float, tall: ag.Scalar, clear: ag.Material, trim: ag.Material) -> ag.Body:
    """Make a cup upside down on its collar with the blades."""
    low, top = 0.022, 0.0335
    end = low + tall
    wall = 0.0026
    path = ag.polyline([(0.004, 0, 0), (top, 0, 0), (neck - 0.002, 0, tall + 0.002)], fillet=wall + 0.0010)
    upright = vessels.blown(path, "jug", clear, foot=top, wall=wall, level=1.4 * wall + 0.0006)
    cover = ag.hull(ag.cylinder(neck - 0.001, 0.006).at(z=low), ag.cylinder(top + 0.001, 0.002).at(z=end))
    hold = ag.grasp_on(cover, approach=-ag.Z, closing=ag.X, depth=0.030)
    wing = ag.hull(
        ag.box(0.004, 0.012, 0.002).at(0.004, 0, low + 0.012),
        ag.box(0.003, 0.004, 0.002).at(0.026, 0, low + 0.022),
    )
    wings = [wing.rotate(ag.Z, turn * math.pi / 2) for turn in range(4)]
    return ag.weld(
        _collar(neck, low, trim),
        upright.rotate(ag.X, math.pi).at(z=end),
        ag.part([ag.cylinder(0.009, 0.016).at(z=low + 0.007), *wings], "blade", _STEEL, grasp=hold),
    )
