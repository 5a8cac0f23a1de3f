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
from artgen import details
from artgen.categories.cooktop.body import Case, Trim
from artgen.categories.cooktop.dials import (
    DialLooks,
    Push,
    Scale,
    bezels,
    dial_on,
    electric_turn,
    scales,
    signs,
    tap_dial,
    tap_hole,
    tap_joints,
    tap_pin,
)
from artgen.categories.shared.controls import DialStyle, ink_on
from artgen.categories.shared.cooktops import (
    ALUMINIUM,
    BRASS,
    COIL_RADIUS,
    ZONE_RADIUS,
    BurnerKind,
    BurnerSize,
    DialSide,
    GrateStyle,
    Place,
    Plan,
    coil_burner,
    gas_burner,
    grates,
    induction_zone,
    printed_zones,
    radiant_zone,
)
from artgen.categories.shared.finish import casting

_GLASS = (
    ag.material("black_glass"),
    ag.material("black_glass").with_(name="grey_glass", base_color=(0.10, 0.105, 0.11)),
    ag.material("black_glass").with_(name="white_glass", base_color=(0.72, 0.72, 0.70)),
)
_SILVER, _WHITE = ag.colored("abs", "silver"), ag.colored("abs", "white")
_BETWEEN = 0.002  # least gap between two dials [m]
_EXTRAS = ("timer", "fan")  # functions and icons of the dials in addition to those of the burners


@ag.category(
    labels=(
        "body", "plate", "trim", "seal", "burner", "burner_cap", "igniter", "coil", "drip_bowl", "zone",
        "grate", "burner_dial", "dial", "bezel", "print", "vent", "screw", "clamp", "cord",
        "gas_pipe", "rating_plate",
    ),
    joints=(2, 20),
)  # fmt: skip
def cooktop(
    *,
    burner: BurnerKind = ag.choice("gas", "radiant", "coil", "induction", weights=(0.38, 0.22, 0.18, 0.22)),
    burners: int = ag.by(
        "burner",
        coil=ag.choice(2, 3, 4, 5, weights=(0.2, 0.2, 0.45, 0.15)),
        otherwise=ag.choice(2, 3, 4, 5, 6, weights=(0.1, 0.16, 0.38, 0.22, 0.14)),
    ),
    rows: int = ag.by(
        "burners",
        {2: 1, 3: ag.choice(1, 2, weights=(0.4, 0.6)), 4: ag.choice(1, 2, weights=(0.15, 0.85))},
        otherwise=2,
        doc="number of burners; the fifth, between two rows, is a wok burner",
    ),
    dials_at: DialSide = ag.by(
        "burners",
        {6: ag.choice("front", "back", weights=(0.8, 0.2))},
        otherwise=ag.choice("front", "left", "right", "back", weights=(0.45, 0.12, 0.31, 0.12)),
    ),
    dials: int = ag.by(
        "burners",
        {
            2: ag.choice(2, 3, 4, weights=(0.6, 0.25, 0.15)),
            3: ag.choice(3, 4, 5, weights=(0.6, 0.25, 0.15)),
            4: ag.choice(4, 5, 6, weights=(0.6, 0.25, 0.15)),
            5: ag.choice(5, 6, 7, weights=(0.6, 0.25, 0.15)),
            6: ag.choice(6, 7, 8, weights=(0.45, 0.25, 0.3)),
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
        gas=ag.shades(
            "stainless",
            "enamel_black",
            "enamel_white",
            *_GLASS,
            weights=(4, 1.2, 1, 2.4, 0.5, 0.9),
            color=0.03,
        ),
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
        radiant=ag.choice("none", "frame", "sides", weights=(0.3, 0.5, 0.2)),
        induction=ag.choice("none", "frame", "sides", weights=(0.5, 0.25, 0.25)),
        doc="edge protection of the glass",
    ),
    metal: ag.Material = ag.shades(
        "stainless", "chrome", "aluminium", weights=(2, 1, 1), color=0.03, doc="metal of trims"
    ),
    grate: GrateStyle = ag.choice("continuous", "single", "diagonal", weights=(0.5, 0.25, 0.25)),
    iron: ag.Material = ag.shades("cast_iron", color=0.1, roughness=0.05, doc="material of the grates"),
    brass: bool = ag.choice(False, True, weights=(0.75, 0.25), doc="whether gas burners are of brass"),
    bowl: Literal["chrome", "black"] = ag.choice(
        "chrome", "black", weights=(0.7, 0.3), doc="finish of the bowls under coils"
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
    scale: Scale = ag.choice("numbers", "ticks", "band", weights=(0.5, 0.2, 0.3), doc="dial scale"),
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
    extras = dials - burners
    ag.require(0 <= extras <= 2, "dials must be from the number of burners to two more")
    gas = burner == "gas"
    plan = Plan(burners, rows, dials, dials_at, width, depth, dial_radius, dial_pitch, mirrored)
    case = Case(burner, plan, height, finish, metal, trim)
    ink = ink_on(finish)
    looks = DialLooks(dial_style, _light(dial_finish), ink_on(dial_finish), metal, ink, scale)
    push = Push(push_travel, push_force)

    coils = [(place.x, place.y, _coil_radius(plan, place.size)) for place in plan.places]
    taps = [(x, y, 0.0) for x, y in plan.dial_places[:burners]]
    holes = ag.array(tap_hole(height), at=taps) if gas else None
    model = f"{maker[:2].upper()}{burners}{round(watts / 100)}"
    lines = (
        f"{maker} {model}",
        f"220-240 V~ {'0.6 W' if gas else f'{watts} W'}",
        "G20 20 mbar" if gas else "50/60 Hz",
    )
    body = ag.weld(
        case.case(lines),
        case.plate(holes, coils if burner == "coil" else []),
        case.maker(maker, ink),
        scales(plan, looks, top=height, gas=gas),
        signs(plan, looks, top=height, extras=_EXTRAS),
    )
    match burner:
        case "gas":
            cap = ag.material("enamel_black").with_(
                name="cap_enamel",
                specular_roughness=0.5,
                density=4000.0,  # density of a pressed cap
            )
            metals = BRASS if brass else ALUMINIUM
            kinds = {place.size: gas_burner(place.size, spreader=metals, cap=cap) for place in plan.places}
            heads = [kinds[place.size].at(place.x, place.y, height) for place in plan.places]
            pins = ag.array(tap_pin(push, top=height, thick=case.thick), at=taps)
            steel = ag.material("steel")
            body = ag.weld(
                body,
                *heads,
                bezels(plan, looks, top=height),
                ag.part(pins, "body", steel, separate="each pin is riveted to the plate"),
            )
        case "coil":
            dish = ag.material("chrome") if bowl == "chrome" else ag.material("enamel_black")
            body = ag.weld(
                body,
                *(
                    coil_burner(radius, bowl=dish, turn=0.4 + number).at(x, y, height)
                    for number, (x, y, radius) in enumerate(coils)
                ),
            )
        case "radiant":
            zones = [
                (place, radiant_zone(_zone(place), dual=place.size in ("large", "wok")))
                for place in plan.places
            ]
            body = ag.weld(body, printed_zones(zones, height, ink))
        case "induction":
            zones = [(place, induction_zone(_zone(place), style=zone_print)) for place in plan.places]
            body = ag.weld(body, printed_zones(zones, height, ink))

    if gas:
        knob = tap_dial(plan, looks, push, top=height, thick=case.thick)
        body = body.repeat(knob, *tap_joints(push, friction=dial_friction), at=taps)
        for one, lift in grates(
            plan.columns, plate=height, style=grate, iron=iron, feet=ag.material("rubber")
        ):
            body = body.attach(one, lift)
    else:
        knob = dial_on(plan, looks, top=height, name="burner_dial", label="burner_dial")
        body = body.repeat(knob, electric_turn("burner_dial_turn", friction=dial_friction), at=taps)
    for name, (x, y) in zip(_EXTRAS, plan.dial_places[burners:], strict=False):
        knob = dial_on(plan, looks, top=height, name=f"{name}_dial", label="dial")
        turn = electric_turn(f"{name}_dial_turn", friction=dial_friction, pivot=(x, y, 0.0))
        body = body.attach(knob.at(x, y, 0.0), turn)
    return body.require(
        plan.spaced > 2.0 * dial_radius + _BETWEEN,
        "dials would touch each other: raise dial_pitch, or lower dial_radius or dials",
    )


def _light(finish: ag.Material) -> ag.Material:
    """Return the material of a hollow dial: a molding, or a sheet cap on a molding."""
    return casting(finish, 0.25 if finish.base_metalness > 0.5 else 0.7)


def _coil_radius(plan: Plan, size: BurnerSize) -> float:
    """Return the radius of a coil: 8 inches only if the plate has space for it [m]."""
    roomy = plan.side in ("left", "right") if plan.rows > 1 else plan.burners == 2
    return COIL_RADIUS[size if roomy else "small"]


def _zone(place: Place) -> ag.Float:
    """Return the radius of a zone with a gap to its neighbors [m]."""
    return ag.min_(ZONE_RADIUS[place.size], 0.95 * place.reach)
