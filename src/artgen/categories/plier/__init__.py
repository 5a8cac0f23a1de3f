"""Pliers on a table: two forgings that cross in a lapped joint, with teeth, grips and a spring.

Links: `body`, the half with the right jaw and the rivet; `jaw`, the other half. Joints: `jaw_hinge`, closed
at 0; `pivot_slide` of slip-joint pliers, whose keyed bolt passes from one hole of its slot to the other only
when the jaws are wide open.

The jaws point to the back (+y), the handles to the front, towards the user. In the lap each half has half of
the thickness; the jaws close to 0.3 mm with meshing teeth. Pliers without a spring hold any angle; a leaf
spring opens the others.

Sizes are those of Knipex, Bahco and Wiha catalogs: combination 160-200 mm and 0.18-0.32 kg, long-nose 140-200
mm and 0.10-0.20 kg, diagonal cutters 130-180 mm and 0.12-0.26 kg, slip-joint 160-250 mm.
"""

import artgen as ag
from artgen import details
from artgen.categories.plier.fittings import PASSES, Grip, Key, Make, off_middle
from artgen.categories.plier.halves import Forging, Style

_STEEL = ag.material("steel")
_STEELS = (
    _STEEL.with_(name="polished_steel", base_color=(0.72, 0.71, 0.70), specular_roughness=0.16),
    ag.material("chrome").with_(name="chrome_vanadium", specular_roughness=0.14, density=7850.0),
    ag.material("satin_nickel").with_(name="nickel_plated", density=7850.0),
    ag.material("black_steel").with_(name="blackened_steel", specular_roughness=0.38, density=7850.0),
    _STEEL.with_(name="forged_steel", base_color=(0.30, 0.295, 0.29), specular_roughness=0.48),
)
_SLEEVES = tuple(
    ag.colored(name, color)
    for name, color in (
        ("rubber", "red"),
        ("rubber", "blue"),
        ("rubber", "black"),
        ("rubber", "yellow"),
        ("rubber", "orange"),
        ("rubber", "forest"),
        ("abs", "red"),
        ("abs", "navy"),
        ("abs", "graphite"),
        ("abs", "teal"),
    )
)
_ACCENTS = tuple(ag.colored("rubber", color) for color in ("red", "yellow", "orange", "light_grey", "blue"))
_BRIGHT = 0.10  # mean color value of a sleeve with a dark soft part


@ag.category(labels=("body", "jaw", "teeth", "edge", "pivot", "grip", "spring", "print"), joints=(1, 2))
def plier(
    *,
    style: Style = ag.choice(
        "combination", "needle_nose", "cutter", "slip_joint", weights=(0.34, 0.26, 0.22, 0.18)
    ),
    length: ag.Float = ag.by(
        "style",
        combination=ag.uniform(0.155, 0.205),
        needle_nose=ag.uniform(0.140, 0.210),
        cutter=ag.uniform(0.130, 0.180),
        slip_joint=ag.uniform(0.165, 0.250),
        unit="m",
        within=(0.12, 0.26),
    ),
    spread: ag.Float = ag.uniform(
        0.118, 0.140, doc="half of the width over the handles, as a share of the length"
    ),
    handle_width: ag.Float = ag.uniform(
        0.0088, 0.0104, "m", doc="width of the bare bar", within=(0.007, 0.012)
    ),
    handle_share: ag.Float = ag.uniform(0.66, 0.82, doc="thickness of the bar, relative to the pivot"),
    jagged: bool = ag.by("style", cutter=False, otherwise=ag.choice(True, False, weights=(0.8, 0.2))),
    teeth_count: int = ag.by("jagged", {True: ag.count(6, 20), False: 6}, doc="number of teeth on a jaw"),
    steel: ag.Material = ag.shades(*_STEELS, weights=(2.2, 1.6, 1.0, 1.6, 0.8), color=0.04, roughness=0.05),
    grips: Grip = ag.choice("bare", "dipped", "two_component", weights=(0.2, 0.42, 0.38)),
    sleeve: ag.Material = ag.shades(*_SLEEVES, color=0.06, roughness=0.04),
    accent: ag.Material = ag.choice(
        *_ACCENTS, doc="color of the soft part of a dark sleeve; a bright sleeve has a dark one"
    ),
    sprung: bool = ag.by(
        "style",
        slip_joint=False,
        needle_nose=ag.choice(False, True, weights=(0.6, 0.4)),
        cutter=ag.choice(False, True),
        combination=ag.choice(False, True, weights=(0.85, 0.15)),
    ),
    opening: ag.Float = ag.uniform(0.42, 0.50, "rad", within=(0.2, 0.52)),
    friction: ag.Float = ag.uniform(0.06, 0.16, "N m", doc="friction of the joint; low if new and oiled"),
    preload: ag.Float = ag.uniform(0.22, 0.32, "N m", doc="spring torque with open jaws, handle 0.15 m"),
    squeeze: ag.Float = ag.uniform(0.45, 0.75, "N m", doc="spring torque with closed jaws, handle 0.15 m"),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make combination, needle-nose, slip-joint or cutting pliers, closed."""
    slip = style == "slip_joint"
    key = Key.of(length)
    least = PASSES + 0.01 if slip else 0.0
    opening = ag.require(
        opening, opening >= least, f"the bolt slides at the open end only: opening must be >= {least:g} rad"
    )
    # space for fingers between the handles of the smallest pliers
    forging = Forging(style, length, key.way if slip else 0.0, ag.max_(spread * length, 0.0178))
    inlay = ag.colored("rubber", "graphite") if sum(sleeve.base_color) / 3.0 > _BRIGHT else accent
    teeth = teeth_count if jagged else 0
    thick = handle_share * forging.thick
    make = Make(
        forging, teeth, steel, grips, sleeve, inlay, handle_width, thick, sprung, key if slip else None
    )
    lever = forging.rear / 0.15  # scales the torque with the handles, for the same force at the hand
    stiffness = lever * (squeeze - preload) / opening
    hinge = ag.Revolute(
        "jaw_hinge",
        axis=ag.Z,
        limits=(0.0, opening),
        stiffness=stiffness if sprung else 0.0,
        rest=lever * squeeze / stiffness if sprung else 0.0,
        friction=0.25 * friction if sprung else friction,
        damping=0.010 if sprung else 0.004,  # friction between the leaves of a spring
        armature=0.00002,
        effort=20.0,
    )
    slide = ag.Prismatic(
        "pivot_slide",
        axis=-ag.X,
        limits=(0.0, key.way),
        friction=4.0,  # friction of a tight bolt
        damping=1.0,
        effort=60.0,
        needs=(hinge > PASSES).until(0.985 * key.way),
    )
    body = make.lower().attach(make.upper(), *((slide, hinge) if slip else (hinge,)))
    nearer = key.way / 2.0 if slip else 0.0  # half of the travel of the pivot to its second hole
    body = body.require(
        off_middle(forging, grips, handle_width) > nearer + 0.0002,
        "thick handles would touch each other below the joint: lower handle_width, or raise length or spread",
    )
    return body.at(-make.middle(), (forging.rear - forging.jaw) / 2.0, make.rests())
