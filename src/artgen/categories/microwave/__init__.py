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
from artgen.categories.microwave import front
from artgen.categories.microwave.case import Plan, case, turntable
from artgen.categories.shared.appliances import PlainLook, cabinet_finish, fronts, grip_metals
from artgen.categories.shared.controls import ButtonShape, DialStyle, button_press, dial, dial_turn, ink_on
from artgen.categories.shared.pulls import BarStyle
from artgen.nodes.details.displays import Color

Controls = Literal["keypad", "mixed", "dials"]
"""Keys, keys with one dial, or dials alone."""

_LOOKS = get_args(PlainLook)
_FINISH, _METAL = fronts(*_LOOKS), grip_metals(*_LOOKS)
_STEEL = ag.material("stainless").with_(
    name="cavity_steel", base_color=(0.74, 0.735, 0.73), specular_roughness=0.32
)
_CAVITIES = {
    "grey": ag.colored("enamel", "light_grey").with_(name="cavity_grey", specular_roughness=0.35),
    "ivory": ag.colored("enamel", "ivory").with_(name="cavity_ivory", specular_roughness=0.35),
    "steel": _STEEL,
}
_BLACK = ag.material("black_glass")
_WHITE = _BLACK.with_(name="white_glass", base_color=(0.80, 0.80, 0.79))
_CAPS = dict(zip(_LOOKS, ("silver", "graphite", "light_grey", "anthracite", "ivory"), strict=True))
_LININGS = {  # other looks have the finish of the front
    look: ag.colored("abs", color).with_(name=f"door_lining_{color}")
    for look, color in (("stainless", "graphite"), ("dark_steel", "anthracite"), ("black", "anthracite"))
}
_KNOBS = (  # plastic caps under a metal skin
    *(ag.material(name).with_(name=f"{name}_cap", density=1100) for name in ("aluminium", "chrome")),
    ag.material("black_abs"),
    ag.material("brushed_aluminium").with_(name="brushed_cap", density=1100),
)


@ag.category(
    labels=(
        "body cavity foot vent light wave_guide_cover rating_plate screw cord door window mesh handle hinge "
        "latch panel display print button dial plate coupler roller_ring"
    ),
    joints=(5, 17),
)
def microwave(
    *,
    controls: Controls = ag.choice({"keypad": 0.5, "mixed": 0.28, "dials": 0.22}),
    look: PlainLook = ag.by(
        "controls",
        dials={"stainless": 1, "dark_steel": 0.3, "white": 1.6, "black": 0.8, "pastel": 2.4},
        otherwise={"stainless": 2.4, "dark_steel": 0.7, "white": 1.4, "black": 1, "pastel": 1},
    ),
    handle: front.HandleKind = ag.by(
        "look",
        stainless={"pocket": 0.25, "none": 0.3, "bar": 0.45},
        dark_steel={"none": 0.3, "pocket": 0.25, "bar": 0.45},
        white={"bar": 0.25, "pocket": 0.3, "none": 0.45},
        black={"none": 0.35, "bar": 0.35, "pocket": 0.3},
        pastel={"pocket": 0.15, "none": 0.35, "bar": 0.5},
        doc="handle of the door; none for a button that opens the door",
    ),
    face: front.FaceStyle = ag.by(
        "look",
        stainless={"framed": 0.4, "glass": 0.2, "banded": 0.4},
        dark_steel={"framed": 0.3, "glass": 0.4, "banded": 0.3},
        white={"framed": 0.75, "glass": 0.25},
        black={"framed": 0.4, "glass": 0.6},
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
    cavity: Literal["grey", "ivory", "steel"] = ag.choice({"grey": 0.45, "ivory": 0.25, "steel": 0.3}),
    keys: int = ag.by(
        "controls",
        keypad={6: 0.25, 9: 0.35, 12: 0.4},
        mixed=ag.choice(3, 6),
        dials=0,
        doc="number of keys, in rows of three",
    ),
    key_shape: ButtonShape = ag.choice({"bar": 0.45, "square": 0.25, "pill": 0.3}),
    key_travel: ag.Float = ag.uniform(0.0010, 0.0015, "m", within=(0.0005, 0.003)),
    key_force: ag.Float = ag.uniform(2.0, 4.0, "N"),
    dials: int = ag.by("controls", keypad=0, mixed=1, dials={2: 0.75, 3: 0.25}),
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
    forward = depth / 2 - (front.PROJECTION + front.GIRTH if handle == "bar" else 0)
    outside = ag.Region((-width / 2, width / 2), (-forward, depth / 2), (0, height))
    plan = Plan(outside, thickness=door_thickness, panel=panel, foot=foot)
    glass = _WHITE if look == "white" and face == "glass" else _BLACK
    around = finish if face == "framed" and not show else glass
    lining, caps = _LININGS.get(look, finish), ag.colored("abs", _CAPS[look])
    style = front.Finish(face, finish, glass, around, metal, lining, caps)
    signs = {"door": "", "panel": "", signed: maker}
    eject = handle == "none"
    places = front.layout(plan, face, keys=keys, dials=dials, eject=eject, show=show, maker=signs["panel"])
    body = ag.weld(
        case(plan, cabinet_finish(look, finish), _CAVITIES[cavity], vents=air, maker=maker, watts=watts),
        front.panel(plan, style, places, key_shape, show=show, color=figures, maker=signs["panel"]),
    )
    y, press = outside.y.low, None
    if places.button:
        press = button_press(
            travel=eject_travel, preload=0.16 * eject_force, force=eject_force, damping=8, effort=30
        )
        size, proud = (places.button.x.size, places.button.z.size), eject_travel + 0.0016
        cap = front.cap(size, "button", "bar", caps, proud=proud, sign="OPEN")
        body = body.attach(cap, press, at=(places.button.x.mid, y, places.button.z.mid))
        body = body.install(front.latch(plan, press))
    door = front.door(plan, style, handle, bar, border=border, maker=signs["door"])
    body = body.attach(door, front.hinge(plan, swing, pop if eject else pull, press))
    room = plan.cavity
    largest = ag.min_(room.x.size, room.y.size) / 2 - 0.007  # radius of a plate with 7 mm to spare
    body = body.install(turntable(plate * largest, plate_friction), at=room.anchor(z=-1))
    for number, (key, sign) in enumerate(zip(places.keys, front.key_names(keys), strict=True)):
        # the domes under the keys of a foil push only little at rest
        slide = button_press(f"key_slide_{number}", travel=key_travel, preload=0.3, force=key_force)
        proud = front.PANE + key_travel + 0.0006
        cap = front.cap(places.key, f"key_{number}", key_shape, caps, proud=proud, sign=sign)
        body = body.attach(cap, slide, at=(key.x.mid, y, key.z.mid))
    for number in range(dials):
        tail, cell = f"_{number}" if dials > 1 else "", places.dials[number]
        turned = dial(
            dial_turn(f"dial_turn{tail}", endless=True),
            dial_style,
            dial_radius,
            knob,
            depth=0.020,
            cap=metal,
            scale=front.scale(number, dial_radius, places.field.x.size, ink_on(around)),
            name=f"dial{tail}",
        )
        body = body.install(turned, at=(cell.x.mid, y - front.PANE, cell.z.mid))
    return front.cooks(body, keys, dials).require(
        places.dials[0].z.size >= (2 * dial_radius if dials else 0),
        "dials have no room over keys and button: raise height, or lower keys, dials or dial_radius",
    )
