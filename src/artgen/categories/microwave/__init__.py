"""A microwave oven with its turntable, and a door with a handle or an opening button.

The door is hinged at its left. Links: `body`; `door`; `plate` on its coupler, and the `roller_ring` under it;
`key_0`, ... in rows of three; `dial`, or `dial_0`, ...; for a door without a handle, `button` and the `latch`
that it lifts. Joints: `door_hinge`, `plate_spin`, `ring_spin`, `key_slide_0`, ..., `dial_turn` (numbered if
there are several), `button_slide` and `latch_slide`.

Two hooks of the door reach into the frame of the cavity. Pawls of the latch block their barbs, so that the
door opens only while the button is pressed; a spring then opens it to 0.3 rad, and friction holds it at any
larger angle. Friction holds a door with a handle at any angle. Wheels roll between the floor and the plate:
their ring turns half as fast as the plate.

Sizes are those of countertop ovens of 17-32 liters: 0.44-0.60 x 0.32-0.45 x 0.25-0.34 m and 10-18 kg; plates
of 245-315 mm.
"""

from typing import Literal, get_args

import artgen as ag
from artgen import details
from artgen.categories.microwave.case import Case, Turntable
from artgen.categories.microwave.controls import Controls, Panel
from artgen.categories.microwave.door import Door, FaceStyle, HandleKind, Latches
from artgen.categories.microwave.space import Space
from artgen.categories.shared.appliances import cabinet_finish, fronts, grip_metals
from artgen.categories.shared.controls import ButtonShape, DialStyle
from artgen.categories.shared.pulls import BarStyle
from artgen.nodes.details.displays import Color

Look = Literal["stainless", "dark_steel", "white", "black", "pastel"]
"""Families of finishes, the same as those of other appliances."""

_LOOKS: tuple[Look, ...] = get_args(Look)
_FINISH, _METAL = fronts(*_LOOKS), grip_metals(*_LOOKS)
_CAVITIES = {
    "grey": ag.colored("enamel", "light_grey").with_(name="cavity_grey", specular_roughness=0.35),
    "ivory": ag.colored("enamel", "ivory").with_(name="cavity_ivory", specular_roughness=0.35),
    "steel": ag.material("stainless").with_(
        name="cavity_steel", base_color=(0.74, 0.735, 0.73), specular_roughness=0.32
    ),
}
_BLACK = ag.material("black_glass")
_WHITE = ag.material("black_glass").with_(name="white_glass", base_color=(0.80, 0.80, 0.79))
_CAPS = {
    "stainless": ag.colored("abs", "silver"),
    "dark_steel": ag.colored("abs", "graphite"),
    "white": ag.colored("abs", "light_grey"),
    "black": ag.colored("abs", "anthracite"),
    "pastel": ag.colored("abs", "ivory"),
}
_LININGS = {  # other looks have the finish of the front
    look: ag.colored("abs", color).with_(name=f"door_lining_{color}")
    for look, color in (("stainless", "graphite"), ("dark_steel", "anthracite"), ("black", "anthracite"))
}
_KNOBS = (  # plastic caps under a metal skin
    *(ag.material(name).with_(name=f"{name}_cap", density=1100.0) for name in ("aluminium", "chrome")),
    ag.material("black_abs"),
    ag.material("brushed_aluminium").with_(name="brushed_cap", density=1100.0),
)


@ag.category(
    labels=(
        "body", "cavity", "foot", "vent", "light", "wave_guide_cover", "rating_plate", "screw", "cord",
        "door", "window", "mesh", "handle", "hinge", "latch", "panel", "display", "print", "button", "dial",
        "plate", "coupler", "roller_ring",
    ),
    joints=(5, 17),
)  # fmt: skip
def microwave(
    *,
    controls: Controls = ag.choice("keypad", "mixed", "dials", weights=(0.5, 0.28, 0.22)),
    look: Look = ag.by(
        "controls",
        dials=ag.choice(*_LOOKS, weights=(1.0, 0.3, 1.6, 0.8, 2.4)),
        otherwise=ag.choice(*_LOOKS, weights=(2.4, 0.7, 1.4, 1.0, 1.0)),
    ),
    handle: HandleKind = ag.by(
        "look",
        stainless=ag.choice("pocket", "none", "bar", weights=(0.25, 0.3, 0.45)),
        dark_steel=ag.choice("none", "pocket", "bar", weights=(0.3, 0.25, 0.45)),
        white=ag.choice("bar", "pocket", "none", weights=(0.25, 0.3, 0.45)),
        black=ag.choice("none", "bar", "pocket", weights=(0.35, 0.35, 0.3)),
        pastel=ag.choice("pocket", "none", "bar", weights=(0.15, 0.35, 0.5)),
        doc="handle of the door; none for a button that opens the door",
    ),
    face: FaceStyle = ag.by(
        "look",
        stainless=ag.choice("framed", "glass", "banded", weights=(0.4, 0.2, 0.4)),
        dark_steel=ag.choice("framed", "glass", "banded", weights=(0.3, 0.4, 0.3)),
        white=ag.choice("framed", "glass", weights=(0.75, 0.25)),
        black=ag.choice("framed", "glass", weights=(0.4, 0.6)),
        pastel="framed",
    ),
    width: ag.Float = ag.uniform(0.44, 0.60, "m", within=(0.43, 0.66)),
    height: ag.Float = ag.uniform(0.25, 0.34, "m", within=(0.245, 0.38)),
    depth: ag.Float = ag.by(
        "handle",
        bar=ag.uniform(0.375, 0.45),
        otherwise=ag.uniform(0.330, 0.42),
        unit="m",
        doc="overall depth, handle included",
        within=(0.32, 0.5),
    ),
    panel: ag.Float = ag.uniform(0.098, 0.128, "m", doc="width of the control panel", within=(0.094, 0.16)),
    door_thickness: ag.Float = ag.uniform(0.0345, 0.040, "m", within=(0.034, 0.05)),
    border: ag.Float = ag.uniform(
        0.030, 0.052, "m", doc="height of the frame above and below the window", within=(0.026, 0.08)
    ),
    foot: ag.Float = ag.uniform(0.008, 0.014, "m", doc="height of the feet", within=(0.006, 0.02)),
    plate: ag.Float = ag.uniform(
        0.93, 1.0, doc="radius, as a share of the largest that fits", within=(0.7, 1.0)
    ),
    finish: ag.Material = _FINISH,
    metal: ag.Material = _METAL,
    bar: BarStyle = ag.by(
        "look",
        pastel=ag.choice("bow", "arched", "round"),
        otherwise=ag.choice("round", "square", "bow", "strap", "arched"),
    ),
    cavity: Literal["grey", "ivory", "steel"] = ag.choice(
        "grey", "ivory", "steel", weights=(0.45, 0.25, 0.3)
    ),
    keys: int = ag.by(
        "controls",
        keypad=ag.choice(6, 9, 12, weights=(0.25, 0.35, 0.4)),
        mixed=ag.choice(3, 6),
        dials=0,
        doc="number of keys, in rows of three",
    ),
    key_shape: ButtonShape = ag.choice("bar", "square", "pill", weights=(0.45, 0.25, 0.3)),
    key_travel: ag.Float = ag.uniform(0.0010, 0.0015, "m", within=(0.0005, 0.003)),
    key_force: ag.Float = ag.uniform(2.0, 4.0, "N"),
    dials: int = ag.by("controls", keypad=0, mixed=1, dials=ag.choice(2, 3, weights=(0.75, 0.25))),
    dial_style: DialStyle = ag.choice("round", "fluted", "bar", "skirted", "capped"),
    dial_radius: ag.Float = ag.by(
        "dials",
        {2: ag.uniform(0.018, 0.023), 3: ag.uniform(0.0165, 0.019)},
        otherwise=ag.uniform(0.0165, 0.021),
        unit="m",
        within=(0.012, 0.026),
    ),
    knob: ag.Material = ag.shades(*_KNOBS, color=0.03, roughness=0.03, doc="material of dials"),
    eject_travel: ag.Float = ag.uniform(0.0042, 0.0050, "m", doc="travel of the opening button"),
    eject_force: ag.Float = ag.uniform(8.0, 14.0, "N", doc="force that presses the opening button home"),
    swing: ag.Float = ag.uniform(1.55, 1.70, "rad", within=(1.2, 1.75)),
    pull: ag.Float = ag.uniform(10.0, 22.0, "N", doc="force at the handle that opens the door"),
    pop: ag.Float = ag.uniform(2.0, 3.5, "N", doc="spring force at the latches of a door without a handle"),
    plate_friction: ag.Float = ag.uniform(0.02, 0.05, "N m", doc="friction of the rollers and the gears"),
    show: str = ag.by(
        "controls",
        dials="",
        otherwise=ag.choice("12:00", "9:41", "0:30", "2:05", "18:20"),
        doc="text of the display; empty for none",
    ),
    figures: Color = ag.choice("green", "white", "cyan", "amber", "red", "lcd"),
    air: Literal["left", "right"] = ag.choice("left", "right", doc="side of the larger vent"),
    watts: int = ag.choice(1050, 1150, 1200, 1270, 1350, 1450),
    maker: str = ag.choice(*details.BRANDS),
    signed: Literal["door", "panel"] = ag.choice("door", "panel", doc="position of the maker's name"),
) -> ag.Body:
    """Make a microwave oven, closed: door, latch, turntable, keys, dials."""
    ag.require(
        key_shape != "round", "keys of this panel are wider than high: key_shape must be bar, square or pill"
    )
    girth, projection = 0.0072, 0.034
    space = Space(
        width=width,
        height=height,
        depth=depth,
        projection=projection + girth if handle == "bar" else 0.0 * depth,
        thickness=door_thickness,
        panel=panel,
        foot=foot,
    )
    glass = _WHITE if look == "white" and face == "glass" else _BLACK
    latches = Latches(space)
    case = Case(
        space,
        finish=cabinet_finish(look, finish),
        inside=_CAVITIES[cavity],
        stuffing=740.0,
        slots=latches.slots,
        vents=air,
        maker=maker,
        watts=watts,
    )
    left = space.across[0] - space.door[0] + 0.008
    right = space.door[1] - space.across[1] + 0.010
    leaf = Door(
        space,
        face=face,
        handle=handle,
        bar=bar,
        finish=finish,
        glass=glass,
        metal=metal,
        inside=_LININGS.get(look, finish),
        border=(left, right + (0.036 if handle == "pocket" else 0.0), border, border),
        maker=maker if signed == "door" else "",
    )
    front = Panel(
        space,
        face=face,
        finish=finish,
        glass=glass,
        keys=keys,
        shape=key_shape,
        cap=_CAPS[look],
        dials=dials,
        dial=dial_style,
        radius=dial_radius,
        knob=knob,
        metal=metal,
        travel=key_travel,
        force=key_force,
        eject=handle == "none",
        eject_travel=eject_travel,
        eject_force=eject_force,
        show=show,
        color=figures,
        maker=maker if signed == "panel" else "",
    )
    x, y = space.middle
    table = Turntable(plate * space.reach, x, y, space.floor, plate_friction)

    body = ag.weld(case.body(), front.body(), table.shaft())
    if handle == "none":
        press = front.press()
        hinge = leaf.hinge(swing=swing, pull=pop, needs=latches.frees(press), sprung=True)
        body = body.attach(front.button(), press).attach(latches.pawls(), latches.slide(press))
    else:
        hinge = leaf.hinge(swing=swing, pull=pull, needs=None)
    body = body.attach(leaf.body(latches), hinge)
    spin = table.spin()
    body = body.attach(table.plate(), spin).attach(table.ring(), table.roll(spin))
    return front.joined(body).require(
        front.room >= 0.0,
        "dials have no room over keys and button: raise height, or lower keys, dials or dial_radius",
    )
