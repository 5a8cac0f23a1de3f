"""A grill: a kettle on three legs, gas on a cart, a ceramic egg, portable gas, or a contact grill.

Links: `body`, `lid`; `grate`; `vent`, the disc over the outlet of a lid; `damper` of an egg; `ash_lever`
below a kettle; `wheel_right`, `wheel_left`; `door_right`, `door_left`, `shelf_right`, `shelf_left` of a cart;
`dial_0`, ...; `tray` and `button` of a contact grill. Joints: `lid_hinge`, and `lid_lift` of a contact grill;
`grate_lift`; `vent_turn`, `damper_slide`, `ash_turn`; `wheel_roll_right`, `wheel_roll_left`;
`door_hinge_right`, ...; `shelf_hinge_right`, ...; `dial_turn_0`, ...; `tray_slide`, `button_slide`.

A lid stays where it is left: springs carry a part of its weight, friction holds the rest. The grate lifts out
below an open lid. The upper plate of a contact grill floats on its food. Side shelves fold down.

Sizes are those of shops. Kettles of 47-57 cm are 0.9-1.1 m high and weigh 8-18 kg (Weber Master-Touch: 15
kg, Napoleon PRO22K: 20 kg); gas grills with two to four burners 1.2-1.4 m wide with their shelves, 1.1-1.2 m
high, 40-65 kg (Weber Spirit E-310: 52 kg); ceramic eggs of 38-47 cm 0.40-0.50 m wide, 0.9-1.2 m high on
their stand, 36-95 kg (Kamado Joe Classic: 85 kg); portable ones 0.56-0.66 m wide, 0.30-0.40 m high, 8-14 kg
(Weber Q 1200: 14 kg with its shelves); contact grills 0.33-0.40 m wide, 0.15-0.20 m high, 4-7.5 kg
(De'Longhi CGH 1012: 6.2 kg; Tefal GC3060: 4 kg).
"""

from typing import Literal

import artgen as ag
from artgen import details, signals
from artgen.categories.grill import boxes
from artgen.categories.grill.parts import (
    Look,
    bowl,
    held_lid,
    lifts_out,
    rolls,
    round_grate,
    side_handles,
    thermometer,
    wheel,
)
from artgen.categories.shared import require_size
from artgen.categories.shared.appliances import DARK
from artgen.categories.shared.finish import casting, colors
from artgen.nodes.fitting import FIT, Fitting

Style = Literal["kettle", "gas", "egg", "portable", "press"]
"""A kettle for charcoal, gas on a cart, a ceramic egg, portable gas, or an electric contact grill."""

_SPANS = {
    "kettle": ((0.42, 0.62), (0.60, 0.90)),
    "gas": ((0.56, 0.80), (0.75, 1.0)),
    "egg": ((0.36, 0.50), (0.62, 0.95)),
    "portable": ((0.44, 0.62), (0.17, 0.30)),
    "press": ((0.28, 0.40), (0.08, 0.13)),
}
"""Possible widths and heights of the rim of each style [m]."""

_STAND = ag.material("powder_coat_black")
_UP = 1.58  # angle of an open round lid [rad]
_SWING = 1.0  # turn of a vent, and of the lever for ash [rad]
_FINISHES = ag.by(
    "style",
    kettle=ag.shades("enamel_black", *colors("enamel", "red sage navy burgundy"),
                     weights=(4, 1, 1, 1, 1), color=0.03),
    gas=ag.shades("enamel_black", "stainless", *colors("enamel", "graphite red"),
                  weights=(3, 3, 1, 1), color=0.03),
    egg=ag.shades(*colors("enamel", "forest red black graphite"), weights=(2, 2, 2, 1), color=0.03),
    portable=ag.shades(*colors("enamel", "black red graphite teal"), weights=(2, 1, 1, 1), color=0.03),
    press=ag.shades("stainless", "glossy_plastic_black", ag.colored("glossy_plastic", "red"),
                    weights=(3, 2, 1), color=0.03),
)  # fmt: skip
_GRIPS = ag.by(
    "style",
    egg=ag.choice("oak", "black_abs"),
    gas=ag.choice("stainless", "black_abs"),
    kettle=ag.choice("black_abs", "beech"),
    otherwise="black_abs",
    doc="handles and knobs",
)


@ag.category(
    labels="body bowl leg foot wheel lid handle hinge vent damper ash grate gauge door shelf tank "
    "panel dial button tray plate trim lamp cord rating_plate print",
    joints=(3, 12),
)
def grill(
    *,
    style: Style = ag.choice({"kettle": 0.26, "gas": 0.22, "egg": 0.16, "portable": 0.18, "press": 0.18}),
    width: ag.Float = ag.by(
        "style",
        kettle=ag.uniform(0.46, 0.58),
        gas=ag.uniform(0.60, 0.72),
        egg=ag.uniform(0.38, 0.47),
        portable=ag.uniform(0.48, 0.56),
        press=ag.uniform(0.30, 0.36),
        unit="m",
        within=(0.28, 0.80),
        doc="outer width of the bowl, of the box of a gas grill or of the case",
    ),
    height: ag.Float = ag.by(
        "style",
        kettle=ag.uniform(0.74, 0.81),
        gas=ag.uniform(0.86, 0.92),
        egg=ag.uniform(0.74, 0.84),
        portable=ag.uniform(0.19, 0.22),
        press=ag.uniform(0.085, 0.105),
        unit="m",
        within=(0.08, 1.0),
        doc="height up to the rim below the lid",
    ),
    burners: int = ag.by("style", gas=ag.count(2, 4), otherwise=1),
    finish: ag.Material = _FINISHES,
    metal: ag.Material = ag.shades("stainless", "chrome", "aluminium", weights=(3, 1, 1), color=0.03),
    grip: ag.Material = _GRIPS,
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a closed grill without food."""
    width = require_size(width, _SPANS[style][0], f"width of a {style} grill")
    height = require_size(height, _SPANS[style][1], f"height of a {style} grill")
    look = Look(finish, metal, grip, maker)
    match style:
        case "gas":
            return boxes.gas(width, height, burners, look)
        case "portable":
            return boxes.portable(width, height, look)
        case "press":
            return boxes.press(width, height, look)
        case "egg":
            return _egg(width / 2, height, look)
    return _kettle(width / 2, height, look)


def _round_lid(radius: ag.Scalar, rise: float, density: float, look: Look) -> ag.Body:
    """Make a dome over a rim at z = 0 with its handle at the front."""
    rim = ag.cylinder(radius + 0.006, 0.012, bevel=0.0014).at(z=0.006)
    dome = ag.simplified_collider(ag.dome(radius + 0.002, height=rise * radius), 0.001)
    stuff = look.thin(density, "lid")
    y, z = -0.86 * radius, 0.50 * rise * radius
    inside = details.printed(ag.circle(0.97 * radius), (0, 0, 0), material=DARK, facing=-ag.Z, label="lid")
    return ag.weld(*_front_bar(y, z, look), ag.part([rim, dome.at(z=0.004)], "lid", stuff), inside)


def _front_bar(y: ag.Scalar, z: ag.Scalar, look: Look) -> list[ag.Body]:
    """Make a bar for a hand before a dome."""
    reach = 0.062
    bar = ag.cylinder(0.0135, 0.17, axis=ag.X, bevel=0.0014).at(0, y - reach, z)
    post = ag.cylinder(0.0070, reach + 0.05, axis=ag.Y).at(0.062, y - reach / 2 + 0.025, z)
    hold = ag.grasp_on(bar, approach=ag.Y, closing=ag.Z, depth=0.014)
    return [
        ag.part(bar, "handle", casting(look.grip, 0.8), name="lid", grasp=hold),
        ag.part([post, post.mirror(ag.X)], "handle", look.metal),
    ]


def _vent(look: Look, radius: float) -> Fitting:
    """Make a vent on the plane z = 0: a disc over its seat, which turns by its tab."""
    seat = ag.cylinder(radius + 0.004, 0.014, bevel=0.001).at(z=-0.0055)
    disc = ag.cylinder(radius, 0.0030, bevel=0.0006).at(z=0.0015 + FIT.running + 0.0015)
    tab = ag.box(0.009, 0.030, 0.017, bevel=0.002).at(0.62 * radius, 0, 0.0110)
    hold = ag.grasp_on(tab, approach=-ag.Z, closing=ag.X, depth=0.011)
    hole = ag.circle(0.24 * radius).at(0, 0.55 * radius)
    holes = hole | hole.rotate(2.1) | hole.rotate(4.2)
    film = details.printed(
        holes, (0, 0, 0.0036 + FIT.running), material=ag.material("black_abs"), facing=ag.Z
    )
    turn = ag.Revolute(
        "vent_turn", axis=ag.Z, limits=(0, _SWING), friction=0.12, damping=0.01, armature=1e-4, effort=3.0
    )
    vent = ag.weld(ag.part([tab, disc], "vent", look.metal, name="vent", grasp=hold), film)
    vent = vent.output("air", signals.level(turn), kind="flow")
    return Fitting.moving(vent, turn, fixed=ag.part(seat, "vent", look.metal, name="vent_seat"))


def _hinged(
    body: ag.Body, lid: ag.Body, radius: ag.Scalar, rim: ag.Scalar, look: Look, share: float
) -> tuple[ag.Body, ag.Joint]:
    """Add a round lid on its hinge behind the rim."""
    axle, up = radius + 0.034, 0.012
    barrel = ag.cylinder(0.011, 0.080, axis=ag.X, bevel=0.001).at(0, axle, up)
    arm = ag.Region((-0.036, 0.036), (radius - 0.025, axle), (up - 0.008, up + 0.008)).box()
    ears = [
        ag.cylinder(0.011, 0.014, axis=ag.X, bevel=0.001).at(x, axle, rim + up)
        | ag.Region((x - 0.007, x + 0.007), (radius - 0.014, axle + 0.008), (rim - 0.050, rim - 0.004)).box()
        | ag.Region((x - 0.007, x + 0.007), (axle - 0.010, axle + 0.008), (rim - 0.006, rim + up)).box()
        for x in (-0.048, 0.048)
    ]
    lid = ag.weld(lid, ag.part([barrel, arm], "hinge", look.metal))
    hinge = held_lid(lid, (0, axle, rim + up + FIT.running), 2 * radius, _UP, share=share)
    body = ag.weld(body, ag.part(ears, "hinge", look.metal))
    return body.attach(lid.at(z=rim + FIT.running), hinge), hinge


def _kettle(radius: ag.Scalar, rim: ag.Scalar, look: Look) -> ag.Body:
    """Make a kettle on three legs with two wheels and a lever for its ash."""
    steps = [(0.40, -0.66), (0.84, -0.42), (1.0, 0.0)]
    body = bowl(radius, rim, steps, 0.006, 900.0, look)
    low = rim - 0.66 * radius
    axle = (0.82 * radius, 0.62 * radius, 0.100)
    feet = [axle, (-0.82 * radius, 0.62 * radius, 0.100), (0, -0.98 * radius, 0.010)]
    legs = []
    for x, y, z in feet:
        far = ag.sqrt(ag.vector(x, y, 0).dot(ag.vector(x, y, 0)))
        top = ag.vector(x, y, 0) * (0.66 * radius / far) + ag.vector(z=rim - 0.50 * radius)
        legs.append(ag.cylinder_between(top, (x, y, z), 0.0125))
    rod = ag.cylinder(0.006, 2 * axle[0] + 0.030, axis=ag.X).at(0, axle[1], axle[2])
    foot = ag.cylinder(0.018, 0.022, bevel=0.0014).at(0, -0.98 * radius, 0.011)
    pan = ag.cylinder(0.36 * radius, 0.055, bevel=0.0014).at(z=low - 0.055)
    hangers = [
        ag.box(0.010, 0.010, 0.034).at(x * radius, y * radius, low - 0.016)
        for x, y in ((-0.28, 0), (0.1, 0.26))
    ]
    body = ag.weld(
        body,
        ag.part([*legs, rod], "leg", casting(look.metal, 0.32)),
        ag.part(foot, "foot", ag.material("black_abs")),
        ag.part([pan, *hangers], "ash", casting(look.metal, 0.07)),
        side_handles(0.90 * radius, rim - 0.05, look),
    )
    place = ag.vector(0, 0.479 * radius, 0.878 * 0.62 * radius + 0.006)
    lid = _round_lid(radius, 0.62, 105.0, look)
    lid = lid.install(_vent(look, 0.042).rotate(ag.X, -0.326), at=place)
    front = (0, -0.479 * radius, 0.878 * 0.62 * radius + 0.004)
    lid = ag.weld(lid, *thermometer(front, (0, -0.316, 0.949), look.metal))
    body, hinge = _hinged(body, lid, radius, rim, look, 0.3)
    grate = round_grate(0.85 * radius).at(z=rim - 0.046)
    body = body.attach(grate, lifts_out(hinge, _UP, 0.046))
    body = _ash(body, radius, low, look)
    out = axle[0] + 0.038
    body = body.attach_pair(
        wheel(0.100, 0.036, look.metal).at(out, axle[1], axle[2]), rolls((out, axle[1], axle[2]))
    )
    return body.at(y=0.5 * (0.98 - 0.80) * radius)


def _ash(body: ag.Body, radius: ag.Scalar, low: ag.Scalar, look: Look) -> ag.Body:
    """Add the lever that sweeps the ash out of a kettle."""
    z = low - 0.012
    bar = ag.Region((-0.009, 0.009), (-0.86 * radius, 0.016), (z - 0.002, z + 0.002)).box()
    knob = ag.box(0.026, 0.060, 0.018, bevel=0.0014).at(0, -0.86 * radius, z)
    hold = ag.grasp_on(knob, approach=ag.Y, closing=ag.X, depth=0.02)
    lever = ag.part([knob, bar], "ash", look.metal, name="ash_lever", grasp=hold)
    turn = ag.Revolute(
        "ash_turn", axis=ag.Z, pivot=(0, 0, z), limits=(0, _SWING), friction=0.5, damping=0.05, armature=1e-3,
        effort=15.0,
    )  # fmt: skip
    return body.attach(lever.rotate(ag.Z, 0.35), turn)


def _egg(radius: ag.Scalar, rim: ag.Scalar, look: Look) -> ag.Body:
    """Make a ceramic egg in a stand on four casters."""
    steps = [(0.58, -1.15), (0.94, -0.62), (1.0, 0.0)]
    body = bowl(radius, rim, steps, 0.016, 3900.0, look)
    low = rim - 1.15 * radius
    seat = ag.cylinder(0.86 * radius, 0.020, bevel=0.002).at(z=low - 0.0096)
    x, back = 0.60 * radius, 0.60 * radius
    posts = [
        ag.Region((a - 0.018, a + 0.018), (b - 0.018, b + 0.018), (0.008, low - 0.012)).box()
        for a in (-x, x)
        for b in (-x, x)
    ]
    frame = ag.box(2 * x + 0.05, 2 * x + 0.05, 0.022, bevel=0.003).at(z=0.16)
    rod = ag.cylinder(0.006, 2 * x + 0.046, axis=ag.X).at(0, back, 0.060)
    feet = [ag.cylinder(0.016, 0.012, bevel=0.002).at(a, -x, 0.006) for a in (-x, x)]
    stand = _STAND.with_(name="stand", density=900.0)
    body = ag.weld(
        body,
        ag.part([seat, *posts, frame, rod], "leg", stand),
        ag.part(feet, "foot", ag.material("rubber")),
        *_band(radius, rim - 0.022, look),
    )
    place = (x + 0.041, back, 0.060)
    body = body.attach_pair(wheel(0.060, 0.030, look.metal).at(place), rolls(place))
    body = _damper(body, radius, rim, look)
    lid = _round_lid(radius, 0.84, 620.0, look)
    top = 0.84 * radius + 0.006
    collar = ag.cylinder(0.070, 0.030, bevel=0.004).at(z=top - 0.008)
    lid = ag.weld(lid, ag.part(collar, "vent", look.metal.with_(name="vent_iron", density=4000.0)))
    lid = lid.install(_vent(look, 0.055), at=(0, 0, top + 0.010))
    lid = ag.weld(
        lid,
        *_band(radius, 0.020, look),
        *thermometer((0, -0.63 * radius, 0.652 * radius), (0, -0.56, 0.83), look.metal),
    )
    body, hinge = _hinged(body, lid, radius, rim, look, 0.82)
    grate = round_grate(0.74 * radius).at(z=rim - 0.050)
    return body.attach(grate, lifts_out(hinge, _UP, 0.050))


def _band(radius: ag.Scalar, z: ag.Scalar, look: Look) -> list[ag.Body]:
    """Make the steel band around the rim of an egg, which is only seen."""
    return [
        ag.detail(ag.tube(radius + 0.0075, radius - 0.004, 0.026, bevel=0.002).at(z=z), "trim", look.metal)
    ]


def _damper(body: ag.Body, radius: ag.Scalar, rim: ag.Scalar, look: Look) -> ag.Body:
    """Add the sliding door of the air inlet at the front of an egg."""
    z, y = rim - 0.84 * radius, -0.93 * radius
    frame = ag.Region((-0.075, 0.110), (y - 0.006, y + 0.12), (z - 0.045, z + 0.045)).box(bevel=0.003)
    hole = details.printed(
        ag.rectangle(0.090, 0.055), (0, y - 0.006, z), material=ag.material("black_abs"), label="damper"
    )
    rails = [
        ag.Region(
            (-0.072, 0.108), (y - 0.0125, y - 0.004), (z + side * 0.038 - 0.003, z + side * 0.038 + 0.003)
        ).box()
        for side in (-1, 1)
    ]
    plate = ag.Region((-0.050, 0.045), (y - 0.0105, y - 0.0072), (z - 0.0340, z + 0.0340)).box()
    knob = ag.box(0.012, 0.020, 0.036, bevel=0.003).at(-0.034, y - 0.019, z)
    hold = ag.grasp_on(knob, approach=ag.Y, closing=ag.X, depth=0.010)
    door = ag.part([knob, plate], "damper", look.metal, name="damper", grasp=hold)
    slide = ag.Prismatic(
        "damper_slide", axis=ag.X, limits=(0, 0.060), friction=2.5, damping=4.0, armature=0.02, effort=40.0
    )
    iron = ag.material("powder_coat_black").with_(name="damper_frame", density=3000.0)
    body = ag.weld(body, ag.part([frame, *rails], "damper", iron), hole).attach(door, slide)
    return body.output("draught", signals.level(slide), kind="flow")
