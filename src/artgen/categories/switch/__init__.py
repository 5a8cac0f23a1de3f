"""A switch on a sample board, as in a shop: rockers, a toggle, a dimmer, a timer, or an emergency stop.

Links: `board`, with the plate or the box of the switch; `rocker_0` and so on from the left; `toggle`; `knob`;
`stop`. Joints: `rocker_tilt_0`, `toggle_tilt`, `knob_turn`, `stop_push`; at 0 a switch is off.

Rockers, toggles and the emergency stop are bistable: a ridge lies in the middle of their travel, and they
snap to one of their ends. A timer clicks from hour to hour; friction holds a dimmer.

Sizes are those of standards and shops: plates of 80-86 mm for boxes of 60 mm (DIN 49073), of 70 by 114 mm
with openings of 10 by 24 mm or 33 by 67 mm (NEMA WD 6), emergency stops of 40 mm that are pressed with
20-50 N over 4-6 mm (IEC 60947-5-5). Rockers turn over with 2-5 N at their edge, toggles with 3-8 N.
"""

import math
from typing import Literal

import numpy as np

import artgen as ag
from artgen import details, feel, signals
from artgen.categories.shared import controls, finish
from artgen.categories.shared.finish import colors
from artgen.nodes.fitting import FIT, Fitting
from artgen.nodes.joint import Detents

Style = Literal["rocker", "toggle", "dimmer", "timer", "stop"]
"""Rockers in a row, a toggle in a slot, a knob for light or for hours, or an emergency stop in a box."""

Plate = Literal["square", "tall"]
"""A plate for round boxes, or a plate for upright boxes."""

_SIZES: dict[Plate, tuple[float, float]] = {"square": (0.082, 0.082), "tall": (0.0715, 0.1145)}
_WINDOWS: dict[Plate, tuple[float, float]] = {"square": (0.056, 0.056), "tall": (0.0335, 0.0670)}
_MIDDLE = 0.16  # height of a switch over the foot of its board [m]
_THICK = 0.018  # thickness of the board [m]
_FACE = 0.0085  # thickness of a plate [m]
_TILT = 0.085  # of a rocker to both sides [rad]
_SWING = 0.36  # of a toggle to both sides [rad]
_PUSH = 0.005  # travel of an emergency stop [m]
_SHARES = {"rocker": 0.4, "toggle": 0.18, "dimmer": 0.16, "timer": 0.1, "stop": 0.16}
_PLATES = ag.choice(
    *colors("abs", "white cream anthracite black"),
    "brushed_aluminium",
    "satin_brass",
    "stainless",
    weights=(5, 1.5, 1.5, 1, 1, 0.7, 0.7),
)
_BOARDS = ag.choice(
    "oak",
    "walnut",
    *colors("lacquered_mdf", "sage sky blush taupe ivory navy"),
    weights=(1.5, 1, 1, 1, 1, 1, 1, 1),
)
_KEYS = ag.choice(ag.colored("abs", "white"), "black_abs", ag.colored("abs", "cream"), weights=(4, 2, 1))
_YELLOW = ag.colored("abs", "mustard").with_(name="signal_yellow", base_color=(0.85, 0.62, 0.03))
_RED = ag.colored("abs", "red").with_(name="signal_red", base_color=(0.62, 0.02, 0.02))
_GLOW = (1.0, 0.45, 0.04)  # emission of the light in a rocker
_TOGGLE = feel.Feel(friction=0.004, damping=0.01, armature=1e-5, effort=1.0)
_ROCKER = feel.Feel(friction=0.004, damping=0.02, armature=1e-5, effort=1.2)
_STOP = feel.Feel(friction=1.0, damping=60.0, armature=0.05, effort=60.0)


@ag.category(labels="board foot plate screw rocker toggle dial box stop collar print led", joints=(1, 3))
def switch(
    *,
    style: Style = ag.choice(_SHARES),
    plate: Plate = ag.by(
        "style", rocker={"square": 0.6, "tall": 0.4}, toggle="tall", otherwise={"square": 0.8, "tall": 0.2}
    ),
    gangs: int = ag.by(
        "style",
        rocker=ag.by("plate", square={1: 0.4, 2: 0.35, 3: 0.25}, tall=1),
        otherwise=1,
        doc="switches side by side, as wide as a finger",
    ),
    shape: Literal["flat", "angled"] = ag.choice("flat", "angled", weights=(1, 2)),
    force: ag.Float = ag.by(
        "style",
        stop=ag.uniform(22.0, 40.0),
        toggle=ag.uniform(2.5, 5.0),
        otherwise=ag.uniform(1.8, 3.5),
        unit="N",
        within=(1.0, 50.0),
        doc="force that turns it over, at its edge",
    ),
    radius: ag.Float = ag.uniform(0.0165, 0.0205, "m", within=(0.014, 0.022), doc="radius of a knob"),
    knob: controls.DialStyle = ag.choice("round", "fluted", "skirted", "capped"),
    marks: Literal["none", "icon", "light"] = ag.choice(
        "none", "icon", "light", weights=(3, 2, 1), doc="what is on a rocker"
    ),
    face: ag.Material = ag.by("style", stop=_YELLOW, otherwise=_PLATES),
    key: ag.Material = ag.by("style", stop=_RED, otherwise=_KEYS, doc="material of what moves"),
    board: ag.Material = _BOARDS,
) -> ag.Body:
    """Make a switch that is off, on a board that stands."""
    wide, high = _SIZES[plate]
    margin = 0.044
    back = ag.Region(
        (-wide / 2 - margin, wide / 2 + margin), (0.0, _THICK), (0.0095, _MIDDLE + high / 2 + 0.04)
    )
    foot = ag.Region((-wide / 2 - 0.03, wide / 2 + 0.03), (-0.055, 0.075), (0.0, 0.010)).box(bevel=0.002)
    body = ag.weld(ag.part(back.box(bevel=0.0015), "board", board), ag.part(foot, "foot", board))
    match style:
        case "rocker":
            body = body.install(_rockers(plate, gangs, shape, force, marks, face, key), at=(0, 0, _MIDDLE))
        case "toggle":
            force = ag.require(force, force <= 20.0, "force of a toggle must be <= 20 N")
            body = body.install(_toggle(plate, force, face, key), at=(0, 0, _MIDDLE))
        case "stop":
            body = body.install(_stop(force, face, key), at=(0, 0, _MIDDLE))
        case _:
            hours = style == "timer"
            body = body.install(_knob(plate, radius, knob, face, key, hours=hours), at=(0, 0, _MIDDLE))
    return _wired(body, style, gangs, marks)


def _wired(body: ag.Body, style: Style, gangs: int, marks: str) -> ag.Body:
    """Let the switch supply a lamp of the room, or a machine that an emergency stop switches off."""
    match style:
        case "rocker":
            for gang in range(gangs):
                led = _led(gang) if marks == "light" else None
                on = signals.pressed(f"rocker_tilt_{gang}")
                body = body.output(f"lamp_{gang}", on, kind="light", material=led, color=_GLOW if led else ())
            return body
        case "toggle":
            return body.output("lamp", signals.pressed("toggle_tilt"), kind="light")
        case "dimmer":
            return body.output("lamp", signals.level("knob_turn"), kind="light")
        case "timer":  # on from the first hour
            return body.output("lamp", signals.pressed("knob_turn", (0.0, 0.8)), kind="light")
    return body.output("supply", ~signals.pressed("stop_push"), kind="flow")


def _led(gang: int) -> ag.Material:
    """Return the material of the light in a rocker, dark until it is on."""
    return ag.material("led_amber").with_(name=f"led_amber_{gang}", emission=(0.0, 0.0, 0.0))


def _cover(plate: Plate, face: ag.Material, *, screwed: bool) -> ag.Body:
    """Make the plate on the wall, with its screws."""
    wide, high = _SIZES[plate]
    made = ag.part(ag.Region.centered(wide, 0.0, high).grow(front=_FACE).box(bevel=0.0025), "plate", face)
    if not screwed:
        return made
    heads = [details.screw(0.0030, (0, -_FACE, z), material=face, drive="slot") for z in (-0.030, 0.030)]
    return ag.weld(made, *heads)


def _snap(limit: float, torque: ag.Scalar) -> Detents:
    """Make a joint bistable: its two positions lie a little beyond its limits."""
    return feel.detents((-0.1 * limit, 1.1 * limit), torque)


def _rockers(
    plate: Plate, gangs: int, shape: str, force: ag.Scalar, marks: str, face: ag.Material, key: ag.Material
) -> Fitting:
    """Make a plate with rockers side by side in its window."""
    wide, high = _WINDOWS[plate]
    cover = _cover(plate, face, screwed=False)
    window = ag.Region.centered(wide, 0.0, high).grow(front=0.02, back=0.008)
    pitch = wide / gangs
    for gang in range(gangs):
        rim = 0.0105 if shape == "flat" else 0.0085
        outline = ag.polygon(
            [
                (-0.0105, 0),
                (-rim, high / 2 - 0.0018),
                (-0.001, high / 2 - 0.0018),
                (-0.001, 0.0018 - high / 2),
                (-rim, 0.0018 - high / 2),
            ]
        )
        paddle = ag.extrude(outline, pitch - 2 * FIT.running, axis=ag.X, bevel=0.0008)
        pivot = (0, -0.002, 0)
        off = paddle.rotate(ag.X, _TILT, about=pivot)
        # along the normal of what is pushed: the upper half of an angled one is upright while it is off
        into = ag.Y if shape == "angled" else ag.vector(0, math.cos(_TILT), math.sin(_TILT))
        touch = ag.push_on(off, direction=into, at=(0, 0, high / 2 - 0.011))
        rocker = ag.part(off, "rocker", key, name="rocker", push=touch)
        if marks != "none":
            sign = details.icon("light", 0.010) if marks == "icon" else ag.circle(0.0016)
            glow = _led(gang) if marks == "light" else controls.ink_on(key)
            film = details.printed(
                sign,
                (0, -0.0102, 0.0),
                material=glow,
                label="print" if marks == "icon" else "led",
                proud=0.0004,
            )
            rocker = ag.weld(rocker, film.rotate(ag.X, _TILT, about=pivot))
        snap = _snap(2 * _TILT, force * high / 2)
        tilt = ag.Revolute(
            "rocker_tilt", axis=-ag.X, pivot=pivot, limits=(0, 2 * _TILT), detents=snap, feel=_ROCKER
        )
        moving = Fitting.moving(rocker, tilt).suffixed(f"_{gang}").at((gang - (gangs - 1) / 2) * pitch)
        cover = cover.install(Fitting(moving.body, window.box() if gang == 0 else None))
    return Fitting(cover, window.box())


def _toggle(plate: Plate, force: ag.Scalar, face: ag.Material, key: ag.Material) -> Fitting:
    """Make a plate with a toggle in its slot: it points down while it is off."""
    slot = ag.Region.centered(0.0098, 0.0, 0.0240).grow(front=0.02, back=0.011)
    length, pivot = 0.0185, (0, 0.004, 0)
    bat = ag.hull(
        ag.box(0.0078, 0.003, 0.0085, bevel=0.001).at(y=0.003),
        ag.box(0.0070, 0.003, 0.0060, bevel=0.0013).at(y=-_FACE - length),
    )
    off = bat.rotate(ag.X, _SWING, about=pivot)
    reach = _FACE + length - 0.002
    hold = ag.grasp_on(off, approach=ag.Y, closing=ag.X, depth=0.012)
    lever = ag.part(off, "toggle", key, grasp=hold)
    snap = _snap(2 * _SWING, force * (reach + 0.004))
    tilt = ag.Revolute(
        "toggle_tilt", axis=-ag.X, pivot=pivot, limits=(0, 2 * _SWING), detents=snap, feel=_TOGGLE
    )
    words = [
        details.printed(details.lettering((word,), 0.0032), (0, -_FACE, z), material=controls.ink_on(face))
        for word, z in (("ON", 0.018), ("OFF", -0.018))
    ]
    cover = ag.weld(_cover(plate, face, screwed=True), *words)
    return Fitting(cover.install(Fitting.moving(lever, tilt, cut=slot.box())), slot.box())


def _knob(
    plate: Plate,
    radius: ag.Scalar,
    style: controls.DialStyle,
    face: ag.Material,
    key: ag.Material,
    *,
    hours: bool,
) -> Fitting:
    """Make a plate with the knob of a dimmer, or of a timer of six hours that clicks at each."""
    ink, sweep = controls.ink_on(face), 4.8
    joint = ag.Revolute(
        "knob_turn",
        axis=ag.Y,
        limits=(0, sweep),
        feel=feel.DIAL,
        friction=0.012 if hours else 0.03,
        detents=feel.detents(tuple(np.linspace(0.0, sweep, 7)), 0.05) if hours else None,
    )
    scale = controls.dial_print(
        radius, ink=ink, style="numbers" if hours else "band", count=7 if hours else 6, sweep=sweep
    )
    turned = controls.dial(joint, style, radius, key, depth=0.019, scale=scale, name="knob")
    cover = _cover(plate, face, screwed=False)
    return Fitting(cover.install(turned.at(y=-_FACE)))


def _stop(force: ag.Scalar, face: ag.Material, key: ag.Material) -> Fitting:
    """Make the box of an emergency stop, which stays pressed until a hand draws it out."""
    deep, radius = 0.052, 0.020
    box = ag.part(ag.Region.centered(0.072, 0.0, 0.072).grow(front=deep).box(bevel=0.005), "box", face)
    out = _PUSH + 0.004
    head = ag.frustum(radius - 0.002, radius, 0.014, axis=-ag.Y, bevel=0.003).at(y=-deep - out - 0.007)
    shaft = ag.cylinder(0.0095, out + 0.02, axis=ag.Y).at(y=-deep - out / 2 + 0.009)
    hold = ag.grasp_on(head, approach=ag.Y, closing=ag.X, depth=0.012)
    pressed = ag.part(head | shaft, "stop", key, grasp=hold, push=ag.push_on(head, direction=ag.Y))
    slide = ag.Prismatic("stop_push", axis=ag.Y, limits=(0, _PUSH), detents=_snap(_PUSH, force), feel=_STOP)
    ring = ag.tube(0.0165, 0.0099, 0.003, axis=ag.Y, bevel=0.0008).at(y=-deep - 0.0013)
    words = details.printed(
        details.lettering(("EMERGENCY STOP",), 0.0036, tracking=0.1),
        (0, -deep, -0.0285),
        material=controls.DARK_INK,
    )
    heads = [
        details.screw(0.0026, (x, -deep, z), material=finish.recess(face))
        for x, z in ((-0.029, 0.029), (0.029, -0.029))
    ]
    cut = ag.Region.centered(0.0198, 0.0, 0.0198).grow(back=0.03).box().at(y=-deep)
    fixed = ag.weld(box, ag.detail(ring, "collar", ag.material("black_abs")), words, *heads)
    return Fitting(fixed.install(Fitting.moving(pressed, slide, cut=cut)))
