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

import math

import artgen as ag
from artgen import feel
from artgen.categories.plier import fittings
from artgen.categories.plier.fittings import PASSES, Grip
from artgen.categories.plier.halves import Forging, Style
from artgen.categories.shared import pivots
from artgen.categories.shared.finish import colors

_STEEL = ag.material("steel")
_STEELS = (
    _STEEL.with_(name="polished_steel", base_color=(0.72, 0.71, 0.70), specular_roughness=0.16),
    ag.material("chrome").with_(name="chrome_vanadium", specular_roughness=0.14, density=7850.0),
    ag.material("satin_nickel").with_(name="nickel_plated", density=7850.0),
    ag.material("black_steel").with_(name="blackened_steel", specular_roughness=0.38, density=7850.0),
    _STEEL.with_(name="forged_steel", base_color=(0.30, 0.295, 0.29), specular_roughness=0.48),
)
_SLEEVES = (
    *colors("rubber", "red blue black yellow orange forest"),
    *colors("abs", "red navy graphite teal"),
)
_ACCENTS = colors("rubber", "red yellow orange light_grey blue")
_BRIGHT = 0.10  # mean color value of a sleeve with a dark soft part
_BOLT = feel.Feel(friction=4, damping=1, effort=60)  # of a tight bolt


@ag.category(labels="body jaw teeth edge pivot grip spring print", joints=(1, 2))
def plier(
    *,
    style: Style = ag.choice({"combination": 0.34, "needle_nose": 0.26, "cutter": 0.22, "slip_joint": 0.18}),
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
    jagged: bool = ag.by("style", cutter=False, otherwise={True: 0.8, False: 0.2}),
    teeth_count: int = ag.by("jagged", {True: ag.count(6, 20), False: 6}, doc="number of teeth on a jaw"),
    steel: ag.Material = ag.shades(*_STEELS, weights=(2.2, 1.6, 1.0, 1.6, 0.8), color=0.04, roughness=0.05),
    grips: Grip = ag.choice({"bare": 0.2, "dipped": 0.42, "two_component": 0.38}),
    sleeve: ag.Material = ag.shades(*_SLEEVES, color=0.06, roughness=0.04),
    accent: ag.Material = ag.choice(
        *_ACCENTS, doc="color of the soft part of a dark sleeve; a bright sleeve has a dark one"
    ),
    sprung: bool = ag.by(
        "style",
        slip_joint=False,
        needle_nose={False: 0.6, True: 0.4},
        cutter=ag.choice(False, True),
        combination={False: 0.85, True: 0.15},
    ),
    opening: ag.Float = ag.uniform(0.42, 0.50, "rad", within=(0.2, 0.52)),
    friction: ag.Float = ag.uniform(0.06, 0.16, "N m", doc="friction of the joint; low if new and oiled"),
    preload: ag.Float = ag.uniform(0.22, 0.32, "N m", doc="spring torque with open jaws, handle 0.15 m"),
    squeeze: ag.Float = ag.uniform(0.45, 0.75, "N m", doc="spring torque with closed jaws, handle 0.15 m"),
) -> ag.Body:
    """Make combination, needle-nose, slip-joint or cutting pliers, closed."""
    slip = style == "slip_joint"
    way = fittings.WAY * length if slip else 0.0
    least = PASSES + 0.01 if slip else 0.0
    opening = ag.require(
        opening, opening >= least, f"the bolt slides at the open end only: opening must be >= {least:g} rad"
    )
    # space for fingers between the handles of the smallest pliers
    forging = Forging(style, length, way, ag.max_(spread * length, 0.0178))
    thick = handle_share * forging.thick
    bar = forging.handle_solid(handle_width, thick, hidden=grips != "bare")
    sleeved = None if grips == "bare" else fittings.Sleeve(forging, grips, handle_width, thick)
    handle = bar if sleeved is None else sleeved.solid
    tall = fittings.sleeve_thickness(grips, thick)
    soft = ag.colored("rubber", "graphite") if sum(sleeve.base_color) / 3 > _BRIGHT else accent
    forged = ag.union(forging.jaw_solid(), *forging.shoulders(), bar)
    lower = forged | forging.plate(fittings.bolt_slot(forging) if slip else None)
    upper = forged | forging.plate(None if slip else pivots.rivet_hole(fittings.RIVET * forging.lap))

    def half(label: str, solid: ag.Solid, *, over: bool) -> ag.Body:
        """Make a half in its drawn pose, with its jaw at the right, without its pivot."""
        y, x = forging.course[5]  # the widest place of the handle, grasped from above
        up = ag.Z if over else -ag.Z
        hold = ag.grasp_on(handle, approach=up, closing=ag.X, at=(x, y, 0.0), depth=0.8 * tall)
        bodies = [ag.part(solid, label, steel, grasp=hold if sleeved is None else ())]
        if sleeved is not None:
            inlay = soft if grips == "two_component" else None
            bodies.append(sleeved.parts(sleeve, inlay, over=over, grasp=hold))
        bodies += fittings.jaw_parts(forging, teeth_count if jagged else 0, steel, phase=-1 if over else 1)
        if sprung:
            bodies.append(fittings.spring(forging, width=handle_width))
        return ag.weld(*bodies)

    body, jaw = half("body", lower, over=False), half("jaw", upper, over=True)
    if slip:
        jaw = ag.weld(jaw, fittings.bolt(forging, steel))
    else:
        body = ag.weld(body, pivots.rivet(fittings.RIVET * forging.lap, forging.thick / 2, steel))
    lever = forging.rear / 0.15  # scales the torque with the handles, for the same force at the hand
    hinge = ag.Revolute(
        "jaw_hinge",
        axis=ag.Z,
        limits=(0, opening),
        spring=pivots.opened_by_spring(lever * squeeze, lever * preload, opening) if sprung else None,
        friction=0.25 * friction if sprung else friction,
        damping=0.010 if sprung else 0.004,  # friction between the leaves of a spring
        armature=0.00002,
        effort=20,
    )
    joints: tuple[ag.Joint, ...] = (hinge,)
    if slip:
        slide = ag.Prismatic(
            "pivot_slide", axis=-ag.X, limits=(0, way), feel=_BOLT, needs=(hinge > PASSES).until(0.985 * way)
        )
        joints = (slide, hinge)
    body = body.attach(jaw.rotate(ag.Y, math.pi), *joints)
    # half of the travel of the pivot to its second hole is nearer
    body = body.require(
        fittings.off_middle(forging, grips, handle_width) > way / 2 + 0.0002,
        "thick handles would touch each other below the joint: lower handle_width, or raise length or spread",
    )
    # the middle of the lower half, and the height of the middle of the tool above the table
    left, right = lower.anchor(x=-1).x, lower.anchor(x=1).x
    left = left if sleeved is None else ag.min_(left, handle.anchor(x=-1).x)
    rests = ag.max_(tall / 2, forging.thick / 2 + (fittings.NUT if slip else 0.0))
    return body.at(-(left + right) / 2, (forging.rear - forging.jaw) / 2, rests)
