"""A toaster: its lever moves the bread down on a carriage, against a spring.

The body is built with its slots along y and its controls at the end that faces the viewer; with the controls
on a broad side it is rotated by 90 degrees.

Links: `body`; `lever`, or `lever_left` and `lever_right`, each with its carriage in the slots; `crumb_tray`;
`button`, or `button_0`, `button_1`, ...; `knob`, or `knob_left` and `knob_right`. Joints: `lever_slide`,
`crumb_tray_slide`, `button_slide`, `knob_turn`, with the same suffixes. A toaster has one or two long slots,
or one, two or four short slots.

Without power, no magnet holds a pressed lever down: its spring lifts it again. Sizes are those of household
toasters: slots 25-40 mm wide, 14-16 cm long for one slice or 24 cm for two.
"""

import math
from functools import partial
from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.shared.controls import ButtonShape, DialStyle, control_knob, dial_print, dial_turn
from artgen.categories.toaster import finish as looks
from artgen.categories.toaster import inside
from artgen.categories.toaster.controls import Layout, Panel, button, toasting
from artgen.categories.toaster.plan import FORMS, BodyStyle, Plan, cord, outside, shell
from artgen.nodes.fitting import Fitting


@ag.category(
    labels="body control_panel trim chamber heating_element guide_wire lever carriage button knob crumb_tray "
    "foot cord base cord_wrap bezel display print vent screw rating_plate",
    joints=(3, 9),
)
def toaster(
    *,
    style: BodyStyle = ag.choice(
        {"box": 0.14, "rounded": 0.24, "retro": 0.20, "steel": 0.24, "classic": 0.18}
    ),
    slots: int = ag.by(
        "style",
        rounded={1: 0.14, 2: 0.46, 4: 0.40},
        retro={1: 0.06, 2: 0.52, 4: 0.42},
        classic={1: 0.06, 2: 0.42, 4: 0.52},  # cafe toasters
        otherwise={1: 0.18, 2: 0.40, 4: 0.42},
    ),
    slot_size: Literal["short", "long"] = ag.by(
        "slots",
        {1: {"short": 0.35, "long": 0.65}, 2: {"short": 0.75, "long": 0.25}, 4: "short"},
        doc="whether slots take two slices in a row",
    ),
    levers: int = ag.by(
        "slots",
        {1: 1, 2: ag.by("slot_size", short=1, long=ag.choice(1, 2)), 4: {1: 0.3, 2: 0.7}},
        doc="number of levers; each of two lifts one half of the slots",
    ),
    controls: Literal["end", "side"] = ag.by(
        "levers",
        {
            1: ag.by(
                "style", box={"end": 0.7, "side": 0.3}, steel={"end": 0.7, "side": 0.3}, otherwise="end"
            ),
            2: "end",
        },
        doc="the front face with the controls: a narrow end or a broad side",
    ),
    layout: Layout = ag.by(
        "levers", {1: ag.by("controls", end={"beside": 0.6, "below": 0.4}, side="beside"), 2: "below"}
    ),
    hand: Literal["left", "right"] = ag.choice("left", "right", doc="side of a lever with dials beside it"),
    length: ag.Float = ag.by(
        "slot_size",
        short=ag.uniform(0.256, 0.29),
        long=ag.uniform(0.345, 0.375),
        unit="m",
        within=(0.25, 0.42),
        doc="length of the body along the slots",
    ),
    height: ag.Float = ag.by(
        "layout",
        below=ag.uniform(0.199, 0.22),
        beside=ag.uniform(0.18, 0.215),
        unit="m",
        within=(0.178, 0.25),
    ),
    slot_length: ag.Float = ag.by(
        "slot_size",
        short=ag.uniform(0.14, 0.158),
        long=ag.uniform(0.235, 0.25),
        unit="m",
        within=(0.12, 0.28),
    ),
    slot_width: ag.Float = ag.by(
        "slots",
        {4: ag.uniform(0.0255, 0.033)},
        otherwise=ag.uniform(0.025, 0.040),
        unit="m",
        within=(0.024, 0.045),
    ),
    bridge: ag.Float = ag.uniform(0.026, 0.032, "m", doc="gap between two slots", within=(0.024, 0.05)),
    shoulder: ag.Float = ag.by(
        "slots",
        {1: ag.uniform(0.064, 0.072), 2: ag.uniform(0.040, 0.048), 4: ag.uniform(0.036, 0.042)},
        unit="m",
        within=(0.034, 0.08),
        doc="distance from the outer slots to the sides",
    ),
    foot: ag.Float = ag.uniform(0.008, 0.011, "m", doc="height of the feet", within=(0.007, 0.02)),
    finish: ag.Material = looks.SLEEVES,
    ends: ag.Material = looks.ENDS,
    metal: ag.Material = looks.METALS,
    grip: ag.Material = looks.GRIPS,
    keys: ag.Material = looks.KEYS,
    panel: Literal["same", "black", "steel"] = ag.by(
        "style",
        box={"same": 0.4, "black": 0.35, "steel": 0.25},
        rounded={"same": 0.35, "black": 0.35, "steel": 0.3},
        retro={"same": 0.45, "black": 0.1, "steel": 0.45},
        steel={"same": 0.3, "black": 0.3, "steel": 0.4},
        classic={"same": 0.6, "black": 0.2, "steel": 0.2},
        doc="finish of the control panel",
    ),
    lever_style: inside.LeverStyle = ag.by(
        "style",
        retro={"tab": 0.1, "bar": 0.35, "ball": 0.4, "tee": 0.1, "paddle": 0.05},
        otherwise={"tab": 0.25, "bar": 0.17, "ball": 0.08, "tee": 0.22, "paddle": 0.28},
    ),
    lever_travel: ag.Float = ag.by(
        "layout",
        below=ag.uniform(0.060, 0.068),
        beside=ag.uniform(0.062, 0.090),
        unit="m",
        within=(0.05, 0.09),
    ),
    lever_force: ag.Float = ag.uniform(12.0, 24.0, "N", doc="spring force at the bottom", within=(8.0, 40.0)),
    lever_damping: ag.Float = ag.uniform(10.0, 16.0, "N s/m"),
    knobs: int = ag.by("levers", {1: {0: 0.18, 1: 0.82}, 2: {0: 0.12, 2: 0.88}}),
    buttons: int = ag.by(
        "knobs",
        {0: ag.choice(2, 3, 4)},  # dials that set the browning
        otherwise={0: 0.12, 1: 0.2, 2: 0.18, 3: 0.28, 4: 0.22},
    ),
    button_shape: ButtonShape = ag.choice({"round": 0.45, "square": 0.25, "pill": 0.15, "bar": 0.15}),
    button_force: ag.Float = ag.uniform(2.0, 4.0, "N", within=(1.0, 8.0)),
    knob_style: DialStyle = ag.choice("round", "fluted", "bar", "skirted", "capped"),
    knob_radius: ag.Float = ag.uniform(0.0135, 0.0165, "m", within=(0.012, 0.017)),
    knob_friction: ag.Float = ag.uniform(0.03, 0.06, "N m", doc="friction of the knob's detents"),
    scale: Literal["numbers", "ticks", "band"] = ag.choice({"numbers": 0.5, "ticks": 0.25, "band": 0.25}),
    tray: inside.TrayWay = ag.by("style", retro="back", otherwise={"back": 0.75, "side": 0.25}),
    tray_friction: ag.Float = ag.uniform(1.0, 3.0, "N"),
    cord_side: Literal["left", "right"] = ag.choice("left", "right"),
    maker: str = ag.choice(*details.BRANDS),
    watts: int = ag.by(
        "slots", {1: ag.choice(850, 1000), 2: ag.choice(850, 950, 1100), 4: ag.choice(1500, 1750, 1800)}
    ),
) -> ag.Body:
    """Make a toaster with its levers up: carriages, buttons, knobs, crumb tray."""
    form, is_side = FORMS[style], controls == "side"
    ag.require(levers <= slots, "one slot has one lever: levers must be 1")
    ag.require(knobs <= levers, "a lever has at most one knob: knobs must be at most levers")
    ag.require(levers == 1 or not is_side, "two levers need the narrow end: controls must be end")
    ag.require(levers == 1 or layout == "below", "two levers have their dials below: layout must be below")
    ag.require(form.is_flat or not is_side, "the sides of this style are not flat: controls must be end")
    ag.require(style != "retro" or tray == "back", "style=retro has round sides: tray must be back")
    if layout == "below":
        height = ag.require(height, height >= 0.19, "dials below levers: height must be >= 0.19 m")
    length = ag.require(length, length - slot_length >= 0.05, "length must exceed slot_length by 0.05 m")
    area = ag.Region.centered(slots * slot_width + (slots - 1) * bridge, slot_length, 0)
    space = ag.Region.centered(area.x.size + 2 * shoulder, length, 0).with_(z=(foot, height))
    plan = Plan(style, space, area, slots, bridge, wires=8 if slot_size == "long" else 5)
    front = Panel(plan, controls, layout, hand, levers, knob_radius, buttons)
    ends = ends if form.is_apart else finish
    drawer = inside.crumb_tray(plan, tray, looks.hollow(grip), tray_friction)
    materials = looks.sheet(finish, form.solidity), looks.hollow(ends), metal
    base = shell(plan, *materials, front.field.grow(front=0.005), controls, drawer, tray)
    lines = (f"{maker.upper()} T{slots}{watts // 50}", f"220-240 V~ 50/60 Hz {watts} W")
    body = ag.weld(base, inside.chamber(plan), outside(plan, lines), cord(plan, controls, cord_side, tray))
    black, steel = ag.material("glossy_plastic_black"), ag.material("stainless")
    plate = {"same": finish if is_side else ends, "black": black, "steel": steel}[panel]
    body = body.rotate(ag.Z, math.pi / 2) if is_side else body
    body = ag.weld(body, front.plate(plate, lever_travel, dials=knobs > 0, maker=maker))
    share = slots // levers  # number of slots per lever
    for number, at in enumerate(front.arms):
        tail = ("_left", "_right")[number] if levers > 1 else ""
        lifted = plan.slots[number * share : (number + 1) * share]
        pressed = inside.lever(lever_style, grip, metal, slim=levers == slots, name=f"lever{tail}")
        rack = inside.carriage(plan, lifted, at, lever_travel, turned=is_side)
        slide = inside.lever_slide(f"lever_slide{tail}", lever_travel, lever_force, lever_damping)
        body = body.attach(ag.weld(pressed.at(at), rack), slide)
    for number, at in enumerate(front.keys):
        tail = f"_{number}" if buttons > 1 else ""
        body = body.install(button(number, tail, button_shape, button_force, keys, metal), at=at)
    knob_of = partial(
        control_knob, finish=looks.hollow(grip), style=knob_style, radius=knob_radius, cap=metal
    )
    marks = dial_print(knob_radius, ink=looks.ink_on(plate), style=scale, sweep=4.8, height=0.0030)
    for number, at in enumerate(front.dials[:knobs]):
        tail = ("_left", "_right")[number] if knobs > 1 else ""
        knob = knob_of(mark=looks.ink_on(grip), name=f"knob{tail}")
        turn = dial_turn(f"knob_turn{tail}", friction=knob_friction)
        body = body.install(Fitting.moving(knob, turn, fixed=marks), at=at)
    return toasting(body, levers, knobs, buttons).require(
        front.fits, "the controls have no room: raise height or shoulder, or lower buttons"
    )
