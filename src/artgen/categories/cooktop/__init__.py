"""A cooktop: gas burners under cast grates, radiant or induction zones under glass, or coils, with dials.

It is shown as delivered: the case that fits into a worktop is on the floor, the plate on top of it. Links:
`body`; `burner_dial_0`, ..., one for each burner, in the order of the columns of burners from left to right;
`timer_dial` and `fan_dial` if there are more dials than burners; `grate_0`, ... over gas burners. Joints:
`burner_dial_turn_0`, ..., `timer_dial_turn`, `fan_dial_turn`, `grate_lift_0`, ....

A gas dial has two joints: `burner_dial_push_0` against the spring of its tap, then `burner_dial_turn_0`. It
turns only while it is pushed in, because a disc on its stem must pass under a pin. A turned dial stays in
under the pin; at off the spring pushes it out. The dials of electric burners turn freely.

Sizes are those of shops: plates 0.56-0.92 m wide for cut-outs of 0.49 m, 0.50-0.56 m deep; data sheets give
8-9 kg for four radiant zones, 9-12 kg for induction, 9-19 kg for gas with cast grates, 7-13 kg for coils.
"""

from typing import Literal

import artgen as ag
from artgen import details, signals
from artgen.categories.cooktop import case
from artgen.categories.cooktop import dials as controls
from artgen.categories.cooktop.case import Trim
from artgen.categories.cooktop.dials import Scale
from artgen.categories.shared import cooktops
from artgen.categories.shared.controls import DialStyle, ink_on
from artgen.categories.shared.cooktops import BurnerKind, DialSide, GrateStyle, Plan
from artgen.categories.shared.finish import casting

_GLASS = (
    ag.material("black_glass"),
    ag.material("black_glass").with_(name="grey_glass", base_color=(0.10, 0.105, 0.11)),
    ag.material("black_glass").with_(name="white_glass", base_color=(0.72, 0.72, 0.70)),
)
_GAS_PLATES = ("stainless", "enamel_black", "enamel_white", *_GLASS)
_SILVER, _WHITE = ag.colored("abs", "silver"), ag.colored("abs", "white")
_BETWEEN = 0.002  # least gap between two dials [m]
_EXTRAS = ("timer", "fan")  # functions and icons of the dials in addition to those of the burners


@ag.category(
    labels="body plate trim seal burner burner_cap igniter coil drip_bowl zone grate burner_dial dial bezel "
    "print vent screw clamp cord gas_pipe rating_plate",
    joints=(2, 20),
)
def cooktop(
    *,
    burner: BurnerKind = ag.choice({"gas": 0.38, "radiant": 0.22, "coil": 0.18, "induction": 0.22}),
    burners: int = ag.by(
        "burner",
        coil={2: 0.2, 3: 0.2, 4: 0.45, 5: 0.15},
        otherwise={2: 0.1, 3: 0.16, 4: 0.38, 5: 0.22, 6: 0.14},
    ),
    rows: int = ag.by(
        "burners",
        {2: 1, 3: {1: 0.4, 2: 0.6}, 4: {1: 0.15, 2: 0.85}},
        otherwise=2,
        doc="number of rows of burners; the fifth burner, between two rows, is a wok burner",
    ),
    dials_at: DialSide = ag.by(
        "burners",
        {6: {"front": 0.8, "back": 0.2}},
        otherwise={"front": 0.45, "left": 0.12, "right": 0.31, "back": 0.12},
    ),
    dials: int = ag.by(
        "burners",
        {
            2: {2: 0.6, 3: 0.25, 4: 0.15},
            3: {3: 0.6, 4: 0.25, 5: 0.15},
            4: {4: 0.6, 5: 0.25, 6: 0.15},
            5: {5: 0.6, 6: 0.25, 7: 0.15},
            6: {6: 0.45, 7: 0.25, 8: 0.3},
        },
        doc="number of dials: one for each burner, then a timer, then the fan of a hood",
    ),
    mirrored: bool = ag.choice(False, True, doc="whether the large burners are on the right"),
    width: ag.Float = ag.by(
        "burners",
        {
            2: ag.uniform(0.56, 0.60),
            3: ag.by("rows", {1: ag.uniform(0.70, 0.80), 2: ag.uniform(0.56, 0.68)}),
            4: ag.by("rows", {1: ag.uniform(0.88, 0.92), 2: ag.uniform(0.56, 0.77)}),
            5: ag.uniform(0.72, 0.92),
            6: ag.uniform(0.84, 0.92),
        },
        unit="m",
        within=(0.55, 0.95),
    ),
    depth: ag.Float = ag.uniform(0.50, 0.56, "m", within=(0.48, 0.60)),
    height: ag.Float = ag.by(
        "burner",
        gas=ag.uniform(0.060, 0.100),
        coil=ag.uniform(0.065, 0.095),
        otherwise=ag.uniform(0.046, 0.066),
        unit="m",
        doc="height of the plate above the bottom of the case",
        within=(0.04, 0.12),
    ),
    dial_radius: ag.Float = ag.by(
        "dials_at",
        front=ag.uniform(0.017, 0.025),
        back=ag.uniform(0.017, 0.025),
        otherwise=ag.uniform(0.016, 0.020),  # smaller for a row with less space
        unit="m",
        within=(0.014, 0.028),
    ),
    dial_pitch: ag.Float = ag.uniform(
        0.070, 0.088, "m", doc="distance between dials, if there is space for it", within=(0.055, 0.12)
    ),
    finish: ag.Material = ag.by(
        "burner",
        gas=ag.shades(*_GAS_PLATES, weights=(4, 1.2, 1, 2.4, 0.5, 0.9), color=0.03),
        coil=ag.shades(
            "enamel_white", "enamel_black", "stainless", "enamel_cream", weights=(3, 2.5, 2, 0.8), color=0.03
        ),
        radiant=ag.shades(*_GLASS, weights=(5, 1, 1), color=0.05),
        induction=ag.shades(*_GLASS, weights=(5, 1, 1.4), color=0.05),
    ),
    trim: Trim = ag.by(
        "burner",
        gas="none",
        coil="none",
        radiant={"none": 0.3, "frame": 0.5, "sides": 0.2},
        induction={"none": 0.5, "frame": 0.25, "sides": 0.25},
        doc="edge protection of the glass",
    ),
    metal: ag.Material = ag.shades(
        "stainless", "chrome", "aluminium", weights=(2, 1, 1), color=0.03, doc="metal of trims"
    ),
    grate: GrateStyle = ag.choice({"continuous": 0.5, "single": 0.25, "diagonal": 0.25}),
    iron: ag.Material = ag.shades("cast_iron", color=0.1, roughness=0.05, doc="material of the grates"),
    brass: bool = ag.choice({False: 0.75, True: 0.25}, doc="whether gas burners are of brass"),
    bowl: Literal["chrome", "black"] = ag.choice(
        {"chrome": 0.7, "black": 0.3}, doc="finish of the bowls under coils"
    ),
    zone_print: Literal["cross", "corners", "dots"] = ag.choice(
        "cross", "corners", "dots", doc="marks of induction zones"
    ),
    dial_style: DialStyle = ag.choice("round", "fluted", "bar", "skirted", "capped"),
    dial_finish: ag.Material = ag.by(
        "burner",
        gas=ag.shades("black_abs", "stainless", _SILVER, "satin_brass", weights=(2.2, 2, 1, 0.5), color=0.05),
        coil=ag.shades("black_abs", _WHITE, _SILVER, weights=(2, 1.5, 1), color=0.05),
        otherwise=ag.shades("black_abs", "stainless", _SILVER, weights=(2, 1.5, 1), color=0.05),
    ),
    scale: Scale = ag.choice({"numbers": 0.5, "ticks": 0.2, "band": 0.3}, doc="dial scale"),
    dial_friction: ag.Float = ag.uniform(0.05, 0.09, "N m", doc="friction of switches or greased taps"),
    push_travel: ag.Float = ag.uniform(0.003, 0.004, "m", doc="travel of gas dials", within=(0.0025, 0.005)),
    push_force: ag.Float = ag.uniform(8.0, 14.0, "N", doc="spring force of a pushed gas tap", within=(6, 20)),
    maker: str = ag.choice(*details.BRANDS),
    watts: int = ag.by(
        "burners",
        {2: 3500, 3: ag.choice(5400, 5800), 4: ag.choice(6600, 7200), 5: 7800, 6: ag.choice(8900, 9400)},
    ),
) -> ag.Body:
    """Make a gas, coil, radiant or induction cooktop, turned off: dials that push and turn, grates."""
    ag.require(burner != "coil" or burners <= 5, "at most 5 coils have room: burners must be <= 5")
    is_arranged = (burners, rows) in cooktops.COLUMNS
    ag.require(is_arranged, "2 burners have one row, 3 or 4 one or two, 5 or 6 two: set rows or burners")
    ag.require(0 <= dials - burners <= 2, "dials must be from the number of burners to two more")
    gas = burner == "gas"
    plan = Plan(burners, rows, dials, dials_at, width, depth, dial_radius, dial_pitch, mirrored)
    under = height - case.THICK[burner]
    place = ag.Region((-width / 2, width / 2), (-depth / 2, depth / 2), (under, height))
    ink = ink_on(finish)
    # a dial is hollow: a molding, or a sheet cap on a molding
    hollow = casting(dial_finish, 0.25 if dial_finish.base_metalness > 0.5 else 0.7)
    knobs = controls.Dials(plan, height, dial_style, hollow, metal, ink, scale)
    taps = [(x, y, 0) for x, y in plan.dial_places[:burners]]

    model = f"{maker[:2].upper()}{burners}{round(watts / 100)}"
    power, supply = ("0.6 W", "G20 20 mbar") if gas else (f"{watts} W", "50/60 Hz")
    body = case.case(burner, place, (f"{maker} {model}", f"220-240 V~ {power}", supply))
    if burner == "coil":
        coils = [(each.x, each.y, _coil_radius(plan, each.size)) for each in plan.places]
        dish = ag.material("chrome" if bowl == "chrome" else "enamel_black")
        heaters = [
            cooktops.coil_burner(
                radius, bowl=dish, coil=cooktops.glowing(burner, number, ink), turn=0.4 + number
            ).at(x, y, height)
            for number, (x, y, radius) in enumerate(coils)
        ]
        body = ag.weld(body, case.plate_of_coils(place, finish, coils), *heaters)
    else:
        hole = ag.box(0.011, 0.011, 0.05).at(z=height)  # for the stem of a tap
        holes = ag.array(hole, at=taps) if gas else None
        body = ag.weld(body, case.plate(burner, place, finish, holes), *case.trims(trim, place, metal))
    body = ag.weld(body, _signature(plan, maker, height, ink), knobs.scales(gas=gas), knobs.signs(_EXTRAS))

    if gas:
        # density of a pressed cap
        cap = ag.material("enamel_black").with_(name="cap_enamel", specular_roughness=0.5, density=4000.0)
        metals = cooktops.BRASS if brass else cooktops.ALUMINIUM
        heads = {each.size: cooktops.gas_burner(each.size, spreader=metals, cap=cap) for each in plan.places}
        pins = ag.array(controls.tap_pin(push_travel, under), at=taps)
        riveted = "each pin is riveted to the plate"
        body = ag.weld(
            body,
            *(heads[each.size].at(each.x, each.y, height) for each in plan.places),
            knobs.bezels(),
            ag.part(pins, "body", ag.material("steel"), separate=riveted),
        )
        joints = controls.tap_joints(push_travel, push_force, dial_friction)
        body = body.repeat(knobs.tap(push_travel, under), *joints, at=taps)
        rubber = ag.material("rubber")
        for one, lift in cooktops.grates(plan.columns, plate=height, style=grate, iron=iron, feet=rubber):
            body = body.attach(one, lift)
    else:
        if burner != "coil":
            zones = cooktops.printed_zones(plan.places, burner, height, ink, share=0.95, style=zone_print)
            body = ag.weld(body, zones)
        turn = controls.electric_turn("burner_dial_turn", dial_friction)
        body = body.repeat(knobs.knob("burner_dial"), turn, at=taps)
    body = cooktops.heated(body, burner, [f"burner_dial_turn_{number}" for number in range(burners)], ink)
    for name, (x, y) in zip(_EXTRAS, plan.dial_places[burners:], strict=False):
        turn = controls.electric_turn(f"{name}_dial_turn", dial_friction)
        body = body.attach(knobs.knob(f"{name}_dial", label="dial"), turn, at=(x, y, 0))
        # the bell of a timer rings when its dial is back at 0
        rings = signals.timer(turn < 0.05, 1.0) if name == "timer" else signals.level(turn)
        body = body.output(name, rings, kind="sound" if name == "timer" else "flow")
    return body.require(
        plan.spaced > 2 * dial_radius + _BETWEEN,
        "dials would touch each other: raise dial_pitch, or lower dial_radius or dials",
    )


def _coil_radius(plan: Plan, size: cooktops.BurnerSize) -> float:
    """Return the radius of a coil: 8 inches only if the plate has space for it [m]."""
    roomy = plan.side in ("left", "right") if plan.rows > 1 else plan.burners == 2
    return cooktops.COIL_RADIUS[size if roomy else "small"]


def _signature(plan: Plan, maker: str, top: ag.Scalar, ink: ag.Material) -> ag.Body:
    """Print the maker's name at the middle of the edge without dials."""
    left, right, front, back = plan.field
    y = back - 0.004 if plan.side == "front" else front + 0.001
    logo = details.logo(maker, 0.0062, tracking=0.15)
    return details.printed(logo, ((left + right) / 2, y, top), material=ink, facing=ag.Z)
