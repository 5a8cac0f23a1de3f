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
from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.shared.appliances import cord_stub, mains_cord
from artgen.categories.shared.controls import ButtonShape, DialStyle
from artgen.categories.shared.fixings import corner_feet
from artgen.categories.toaster.controls import Layout, Panel, PanelLooks, Scale, end_site, side_site
from artgen.categories.toaster.finish import ENDS, GRIPS, KEYS, METALS, SLEEVES, hollow, ink_on, sheet
from artgen.categories.toaster.inside import (
    LeverStyle,
    Tray,
    TrayWay,
    arm,
    carriage,
    chamber,
    lever,
    lever_slide,
)
from artgen.categories.toaster.plan import BodyStyle, Plan
from artgen.categories.toaster.shell import Cuts, ShellLooks, back_print, shell, underside

_QUARTER = math.pi / 2.0
_NO_ROOM = "the controls have no room: raise height or shoulder, or lower buttons"
_ENDS_APART: tuple[BodyStyle, ...] = ("steel", "classic")  # styles with ends of another material
_FLAT_SIDES: tuple[BodyStyle, ...] = ("box", "steel")  # styles whose broad sides may have controls


@ag.category(
    labels=(
        "body",
        "control_panel",
        "trim",
        "chamber",
        "heating_element",
        "guide_wire",
        "lever",
        "carriage",
        "button",
        "knob",
        "crumb_tray",
        "foot",
        "cord",
        "base",
        "cord_wrap",
        "bezel",
        "display",
        "print",
        "vent",
        "screw",
        "rating_plate",
    ),
    joints=(3, 9),
)
def toaster(
    *,
    style: BodyStyle = ag.choice(
        "box", "rounded", "retro", "steel", "classic", weights=(0.14, 0.24, 0.20, 0.24, 0.18)
    ),
    slots: int = ag.by(
        "style",
        rounded=ag.choice(1, 2, 4, weights=(0.14, 0.46, 0.40)),
        retro=ag.choice(1, 2, 4, weights=(0.06, 0.52, 0.42)),
        classic=ag.choice(1, 2, 4, weights=(0.06, 0.42, 0.52)),  # cafe toasters
        otherwise=ag.choice(1, 2, 4, weights=(0.18, 0.40, 0.42)),
    ),
    slot_size: Literal["short", "long"] = ag.by(
        "slots",
        {
            1: ag.choice("short", "long", weights=(0.35, 0.65)),
            2: ag.choice("short", "long", weights=(0.75, 0.25)),
            4: "short",
        },
        doc="whether slots take two slices in a row",
    ),
    levers: int = ag.by(
        "slots",
        {1: 1, 2: ag.by("slot_size", short=1, long=ag.choice(1, 2)), 4: ag.choice(1, 2, weights=(0.3, 0.7))},
        doc="number of levers; each of two lifts one half of the slots",
    ),
    controls: Literal["end", "side"] = ag.by(
        "levers",
        {
            1: ag.by(
                "style",
                box=ag.choice("end", "side", weights=(0.7, 0.3)),
                steel=ag.choice("end", "side", weights=(0.7, 0.3)),
                otherwise="end",
            ),
            2: "end",
        },
        doc="the front face with the controls: a narrow end or a broad side",
    ),
    layout: Layout = ag.by(
        "levers",
        {
            1: ag.by("controls", end=ag.choice("beside", "below", weights=(0.6, 0.4)), side="beside"),
            2: "below",
        },
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
    finish: ag.Material = SLEEVES,
    ends: ag.Material = ENDS,
    metal: ag.Material = METALS,
    grip: ag.Material = GRIPS,
    keys: ag.Material = KEYS,
    panel: Literal["same", "black", "steel"] = ag.by(
        "style",
        box=ag.choice("same", "black", "steel", weights=(0.4, 0.35, 0.25)),
        rounded=ag.choice("same", "black", "steel", weights=(0.35, 0.35, 0.3)),
        retro=ag.choice("same", "black", "steel", weights=(0.45, 0.1, 0.45)),
        steel=ag.choice("same", "black", "steel", weights=(0.3, 0.3, 0.4)),
        classic=ag.choice("same", "black", "steel", weights=(0.6, 0.2, 0.2)),
        doc="finish of the control panel",
    ),
    lever_style: LeverStyle = ag.by(
        "style",
        retro=ag.choice("tab", "bar", "ball", "tee", "paddle", weights=(0.1, 0.35, 0.4, 0.1, 0.05)),
        otherwise=ag.choice("tab", "bar", "ball", "tee", "paddle", weights=(0.25, 0.17, 0.08, 0.22, 0.28)),
    ),
    lever_travel: ag.Float = ag.by(
        "layout",
        below=ag.uniform(0.060, 0.068),
        beside=ag.uniform(0.062, 0.090),
        unit="m",
        within=(0.05, 0.092),
    ),
    lever_force: ag.Float = ag.uniform(12.0, 24.0, "N", doc="spring force at the bottom", within=(8.0, 40.0)),
    lever_damping: ag.Float = ag.uniform(10.0, 16.0, "N s/m"),
    knobs: int = ag.by(
        "levers", {1: ag.choice(0, 1, weights=(0.18, 0.82)), 2: ag.choice(0, 2, weights=(0.12, 0.88))}
    ),
    buttons: int = ag.by(
        "knobs",
        {0: ag.choice(2, 3, 4)},  # dials that set the browning
        otherwise=ag.choice(0, 1, 2, 3, 4, weights=(0.12, 0.2, 0.18, 0.28, 0.22)),
    ),
    button_shape: ButtonShape = ag.choice("round", "square", "pill", "bar", weights=(0.45, 0.25, 0.15, 0.15)),
    button_force: ag.Float = ag.uniform(2.0, 4.0, "N", within=(1.0, 8.0)),
    knob_style: DialStyle = ag.choice("round", "fluted", "bar", "skirted", "capped"),
    knob_radius: ag.Float = ag.uniform(0.0135, 0.0165, "m", within=(0.012, 0.017)),
    knob_friction: ag.Float = ag.uniform(0.03, 0.06, "N m", doc="friction of the knob's detents"),
    scale: Scale = ag.choice("numbers", "ticks", "band", weights=(0.5, 0.25, 0.25)),
    tray: TrayWay = ag.by("style", retro="back", otherwise=ag.choice("back", "side", weights=(0.75, 0.25))),
    tray_friction: ag.Float = ag.uniform(1.0, 3.0, "N"),
    cord_side: Literal["left", "right"] = ag.choice("left", "right"),
    maker: str = ag.choice(*details.BRANDS),
    watts: int = ag.by(
        "slots", {1: ag.choice(850, 1000), 2: ag.choice(850, 950, 1100), 4: ag.choice(1500, 1750, 1800)}
    ),
) -> ag.Body:
    """Make a toaster with its levers up: carriages, buttons, knobs, crumb tray."""
    ag.require(levers == 1 or controls == "end", "two levers need the narrow end: controls must be end")
    ag.require(
        controls == "end" or style in _FLAT_SIDES,
        "the sides of this style are not flat: controls must be end",
    )
    ag.require(style != "retro" or tray == "back", "style=retro has round sides: tray must be back")
    length = ag.require(length, length - slot_length >= 0.05, "length must exceed slot_length by 0.05 m")
    plan = Plan(
        style, slots, slot_size == "long", slot_width, slot_length, bridge, shoulder, length, height, foot
    )
    is_side, apart = controls == "side", style in _ENDS_APART
    around = ends if apart and not is_side else finish
    plate = {"same": around, "black": ag.material("glossy_plastic_black"), "steel": ag.material("stainless")}[
        panel
    ]
    panel_looks = PanelLooks(
        plate=hollow(plate),
        ink=ink_on(plate),
        button=keys,
        button_ink=ink_on(keys),
        dial=hollow(grip),
        mark=ink_on(grip),
        metal=metal,
        shape=button_shape,
        style=knob_style,
        scale=scale,
        maker=maker,
    )
    site = side_site(plan) if is_side else end_site(plan, levers, layout, 1 if hand == "left" else -1)
    front = Panel(site, lever_travel, knobs, buttons, knob_radius, panel_looks)
    drawer = Tray(plan, tray)
    looks = ShellLooks(
        sleeve=sheet(finish, plan.solidity),
        ends=hollow(ends if apart else finish),
        trim=metal,
        piping=metal if style == "retro" else None,
    )
    # the shell has its slots along y until it is rotated
    opening = front.opening().rotate(ag.Z, -_QUARTER) if is_side else front.opening()
    cuts = Cuts(
        front=None if is_side else opening,
        side=((opening,) if is_side else ()) + ((drawer.opening(),) if tray == "side" else ()),
        back=(drawer.opening(),) if tray == "back" else (),
    )
    base = ag.weld(
        shell(plan, looks, cuts),
        chamber(plan),
        corner_feet(plan.width, plan.length, inset=0.028, height=foot + plan.inset),
        underside(plan),
        back_print(plan, (f"{maker.upper()} T{slots}{watts // 50}", f"220-240 V~ 50/60 Hz {watts} W")),
        _cord(plan, controls, cord_side, tray),
    )
    base = base.attach(drawer.body(hollow(grip)), drawer.slide(tray_friction))
    body = ag.weld(base.rotate(ag.Z, _QUARTER) if is_side else base, front.plate())

    share = slots // levers  # number of slots per lever
    for number, at in enumerate(site.arms):
        middles = plan.middles[number * share : (number + 1) * share]
        tail = ("_left", "_right")[number] if levers > 1 else ""
        post = middles[0] if is_side else at.x
        rack = carriage(plan, middles, post=post, height=site.rest, travel=lever_travel)
        reach = (middles[0] if is_side else plan.bay) - site.plane
        pressed = ag.weld(
            lever(lever_style, finish=grip, accent=metal, slim=levers == slots, name=f"lever{tail}").at(at),
            arm(reach).at(at),
            rack.rotate(ag.Z, _QUARTER) if is_side else rack,
        )
        slide = lever_slide(
            f"lever_slide{tail}", travel=lever_travel, force=lever_force, damping=lever_damping
        )
        body = body.attach(pressed, slide)
    return front.attached(body, button_force, knob_friction).require(front.fits(), _NO_ROOM)


def _cord(
    plan: Plan, controls: Literal["end", "side"], cord_side: Literal["left", "right"], tray: TrayWay
) -> ag.Body:
    """Make the cord, which leaves at the back and lies behind the body, with the slots along y."""
    height, length = plan.foot + 0.032, 0.125
    # a rotation by 90 degrees moves the wall at x to the back, and the bay to the right
    if controls == "side":
        cord = mains_cord(height=height, length=length, side=-1).rotate(ag.Z, -_QUARTER)
        return cord.at(plan.width / 2 - plan.inset, plan.bay, height)
    way = 1 if cord_side == "right" else -1
    # a plug on the floor would block a tray at the back
    plugged = tray != "back"
    cord = mains_cord(height=height, length=length, side=-way) if plugged else cord_stub(height=height)
    return cord.at(way * (plan.width / 2 - 0.018), plan.length / 2, height)
