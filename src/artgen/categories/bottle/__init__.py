"""A bottle or a jar with a closure: a screw cap, a twist-off lid, a flip top, a pump, a stopper or a trigger.

Links: `body`; `cap` of a screw cap, `lid` of a jar or of a flip top, `nozzle` of a pump, `stopper` or
`trigger`. Joints: `cap_turn` and `lid_turn` with their rise, `cap_turn_rise` and `lid_turn_rise`;
`lid_hinge`; `nozzle_slide`; `stopper_lift`; `trigger_pull`.

A screw turns and rises along its thread to the end of the thread. Friction holds a stopper in its bore; it
lifts out all the way. Springs return a nozzle and a trigger. Bottles are full: their density is that of
container and contents together.

Sizes are those of standards and shops. PET bottles have the neck finish PCO-1881 (ISBT: thread 27.4 mm,
pitch 2.7 mm, support ring 33 mm), 65 mm by 220 mm for 0.5 l and 89 mm by 330 mm for 1.5 l. Jars have
twist-off lids of 58-66 mm. Bottles of spirits and wine are 73-80 mm wide and 270-300 mm high and weigh
450-600 g empty, with a bore of 18.5 mm (EN 12726). Bottles of shampoo, lotion and cleaners of HDPE hold
0.25-0.75 l, with necks of 28 mm. Caps of PET bottles open at 0.6-1.7 N m, jars at 1.5-3 N m (torque tables
of closure makers).
"""

import math
from typing import Literal

import artgen as ag
from artgen import details, feel
from artgen.categories.shared import vessels
from artgen.categories.shared.finish import colors
from artgen.nodes.fitting import FIT, Fitting

Style = Literal["screw", "jar", "flip", "pump", "stopper", "trigger"]
"""A PET bottle with a screw cap, a jar with a twist-off lid, a bottle with a flip top, with a pump, with a
stopper of cork, or with the trigger of a spray."""

_SIDES = 24  # facets of the core of a body
_FINISH = {"screw": 0.0170, "jar": 0.0140, "flip": 0.0, "pump": 0.0, "stopper": 0.0240, "trigger": 0.0}
"""Height of the neck above the support ring or the shoulder, by style [m]."""

_SHOULDER = ((1, 0), (0.97, 0.35), (0.84, 0.68), (0.60, 0.90), (0, 1))
"""Shares of the step from the neck to the wall, and of the height of a shoulder."""

_CAPS = ag.shades(
    *colors("polypropylene", "white blue red teal black light_grey"),
    color=0.04,
    doc="material of a cap of plastic",
)
_LIDS = ag.shades("satin_brass", "powder_coat_black", *colors("enamel", "white red sage"))
_PAPER = ag.material("cardboard").with_(name="bottle_paper", base_color=(0.84, 0.82, 0.77), texture="")
_CORK = ag.material("oak").with_(name="cork", base_color=(0.62, 0.45, 0.28), density=240.0, texture="")
_NOZZLE = feel.Feel(damping=8.0, friction=0.5, armature=0.03, effort=40.0)
_TRIGGER = feel.Feel(damping=0.02, friction=0.01, armature=2e-4, effort=1.5)


def _liquid(name: str, color: tuple[float, float, float], clear: float = 0.0) -> ag.Material:
    """Make the contents of a clear bottle."""
    plain = ag.material("polycarbonate").with_(name=f"{name}_inside", base_color=color, texture="")
    return plain.with_(transmission_weight=clear, opacity=1.0 - 0.5 * clear, specular_roughness=0.2)


_CONTENTS = {
    "screw": (_liquid("water", (0.78, 0.86, 0.90), 0.8), _liquid("cola", (0.09, 0.03, 0.02)),
              _liquid("juice", (0.83, 0.42, 0.06)), _liquid("soda", (0.45, 0.72, 0.42), 0.6)),
    "jar": (_liquid("jam", (0.36, 0.03, 0.05)), _liquid("honey", (0.72, 0.38, 0.06)),
            _liquid("pesto", (0.25, 0.30, 0.08)), _liquid("cream", (0.82, 0.74, 0.60))),
    "stopper": (_liquid("whisky", (0.52, 0.22, 0.04), 0.4), _liquid("gin", (0.80, 0.85, 0.86), 0.8),
                _liquid("wine", (0.06, 0.08, 0.03)), _liquid("rum", (0.20, 0.07, 0.03))),
}  # fmt: skip
_PLASTICS = ag.shades(*colors("glossy_plastic", "white cream sky mint blush graphite"), color=0.04)
_GLASS = ag.material("glass").with_(name="bottle_glass", opacity=0.22)
_FULL = {"screw": 985.0, "jar": 1330.0, "flip": 985.0, "pump": 985.0, "stopper": 1290.0, "trigger": 985.0}
"""Density of a full bottle with its walls, by style [kg/m3]."""


@ag.category(labels="body neck cap lid collar nozzle stem stopper trigger label print", joints=(1, 2))
def bottle(
    *,
    style: Style = ag.choice(
        {"screw": 0.26, "jar": 0.18, "flip": 0.14, "pump": 0.14, "stopper": 0.16, "trigger": 0.12}
    ),
    width: ag.Float = ag.by(
        "style",
        screw=ag.uniform(0.060, 0.090),
        jar=ag.uniform(0.062, 0.080),
        stopper=ag.uniform(0.072, 0.080),
        otherwise=ag.uniform(0.058, 0.080),
        unit="m",
        within=(0.055, 0.095),
        doc="diameter of the body",
    ),
    slender: ag.Float = ag.by(
        "style",
        screw=ag.uniform(2.1, 2.7),
        jar=ag.uniform(0.95, 1.45),
        stopper=ag.uniform(2.0, 2.25),
        otherwise=ag.uniform(1.9, 2.5),
        within=(0.9, 2.8),
        doc="height up to the shoulder over the diameter",
    ),
    slope: ag.Float = ag.by(
        "style",
        jar=ag.uniform(0.12, 0.2),
        stopper=ag.uniform(0.25, 0.4),
        otherwise=ag.uniform(0.3, 0.55),
        within=(0.1, 0.6),
        doc="height of the shoulder over the diameter",
    ),
    throat: ag.Float = ag.by(
        "style",
        stopper=ag.uniform(0.03, 0.06),
        otherwise=0.0,
        unit="m",
        within=(0.0, 0.09),
        doc="length of the neck of glass below its finish",
    ),
    contents: ag.Material = ag.by(
        "style",
        screw=ag.choice(*_CONTENTS["screw"]),
        jar=ag.choice(*_CONTENTS["jar"]),
        stopper=ag.choice(*_CONTENTS["stopper"]),
        otherwise=_PLASTICS,
        doc="contents of a clear bottle, or color of a bottle of plastic",
    ),
    closure: ag.Material = ag.by(
        "style", jar=_LIDS, stopper=ag.choice("walnut", "oak", "black_abs"), otherwise=_CAPS
    ),
    turns: ag.Float = ag.by(
        "style",
        jar=ag.uniform(0.22, 0.30),
        otherwise=ag.uniform(1.6, 1.9),
        doc="turns of a thread",
        within=(0.2, 2.0),
    ),
    torque: ag.Float = ag.by(
        "style",
        jar=ag.uniform(0.6, 1.2),
        otherwise=ag.uniform(0.15, 0.4),
        unit="N m",
        doc="friction of a thread",
    ),
    swing: ag.Float = ag.uniform(1.9, 2.4, "rad", doc="angle of an open flip top", within=(1.2, 2.5)),
    travel: ag.Float = ag.uniform(0.012, 0.018, "m", doc="travel of a pump", within=(0.010, 0.019)),
    force: ag.Float = ag.uniform(9.0, 20.0, "N", doc="force of a pump or a trigger, pressed home"),
    hold: ag.Float = ag.uniform(8.0, 20.0, "N", doc="friction of a stopper"),
    label: bool = ag.choice({True: 0.8, False: 0.2}, doc="label of paper"),
    word: str = ag.by(
        "style",
        flip=ag.choice("SHAMPOO", "SHOWER", "SUN"),
        pump=ag.choice("LOTION", "BALM", "SOAP"),
        trigger=ag.choice("CLEANER", "GLASS", "BATH"),
        otherwise="",
        doc="word on the label; empty for the name of the contents",
    ),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a closed bottle or jar."""
    radius, high = width / 2, slender * width
    neck = ag.min_(radius - 0.0030, 0.0300) if style == "jar" else 0.0129
    mouth = high + slope * width + throat  # height of the neck's lower end [m]
    body = _vessel(style, radius, neck, high, mouth - throat, mouth, contents)
    if label:
        name = word or contents.name.removesuffix("_inside").upper()
        body = ag.weld(body, *_label(radius, high, maker, name))
    match style:
        case "screw" | "jar":
            made = _screwed(style, neck, closure, turns, torque)
        case "flip":
            made = _flip(closure, swing)
        case "pump":
            made = _pump(closure, travel, force)
        case "stopper":
            made = _stopper(closure, hold)
        case "trigger":
            made = _trigger(closure, force)
    return body.install(made, at=(0, 0, mouth))


def _vessel(
    style: Style,
    radius: ag.Scalar,
    neck: ag.Scalar,
    high: ag.Scalar,
    top: ag.Scalar,
    mouth: ag.Scalar,
    contents: ag.Material,
) -> ag.Body:
    """Make the body with its shoulder and its neck: the contents carry the mass, inside glass or PET."""
    shoulder = [(neck + r * (radius - neck), high + z * (top - high)) for r, z in _SHOULDER]
    end = mouth + (0.0 if style == "stopper" else _FINISH[style])
    runs: list[vessels.Run] = [
        [(radius - 0.0040, 0), (radius - 0.0010, 0.0012), (radius, 0.0045)],
        [(radius, 0.0045), (radius, high)],
        shoulder,
        [(neck, top), (neck, end + 0.0005)],
    ]
    stuff = contents.with_(name=f"{contents.name}_{style}", density=_FULL[style])
    glass = _GLASS if style in _CONTENTS else stuff
    body = ag.weld(
        ag.part(vessels.core(runs, sides=_SIDES), "body", stuff), ag.detail(vessels.skin(runs), "body", glass)
    )
    if style == "screw":  # support ring and thread
        ring = ag.tube(0.0165, 0.0122, 0.0026, bevel=0.0006).at(z=mouth + 0.0005)
        thread = ag.sweep(ag.circle(0.0006), ag.helix(neck, 0.0027, 1.8)).at(z=mouth + 0.0105)
        return ag.weld(body, ag.detail([ring, thread], "neck", glass))
    return body


def _label(radius: ag.Scalar, high: ag.Scalar, maker: str, word: str) -> list[ag.Body]:
    """Make the paper around the body with its print."""
    tall, z = 0.52 * high, 0.47 * high
    paper = ag.revolve(ag.rectangle(0.0006, tall).at(radius, z))
    wall, ink = ag.line((radius, 0, 0), (radius, 0, high)), ag.colored("abs", "navy")
    prints = [
        (details.logo(maker, 0.0048), 0.22 * tall),
        (details.lettering([word], 0.0072, tracking=0.1), -0.02 * tall),
        (ag.rectangle(0.030, 0.0006), -0.16 * tall),
    ]
    return [
        ag.detail(paper, "label", _PAPER),
        *(details.wrapped(each, wall, z + rise, material=ink, proud=0.0006) for each, rise in prints),
    ]


def _hollow(outer: ag.Scalar, inner: ag.Scalar, high: float, low: float) -> list[ag.Solid]:
    """Make a cap of few sides about z from a height up: its wall and its top."""
    sides = 20
    ring = ag.regular_polygon(sides, outer) - vessels.around(inner, sides)
    top = ag.extrude(ag.regular_polygon(sides, outer - 0.0003), 0.0014)
    return [ag.extrude(ring, high).at(z=low + high / 2), top.at(z=low + high - 0.0007)]


def _ribs(radius: ag.Scalar, high: float, low: float, finish: ag.Material, label: str) -> ag.Body:
    """Make the fluted skin of a cap with a soft upper edge."""
    rib = ag.cylinder(0.0005, high - 0.003)
    ribs = ag.array(rib, at=ag.ring_points((0, 0, low + high / 2), radius + 0.0001, count=48))
    skin = ag.tube(radius + 0.0002, radius - 0.0010, high - 0.0004, bevel=0.0004).at(z=low + high / 2)
    return ag.detail([ribs, skin], label, finish)


def _screwed(
    style: Style, neck: ag.Scalar, finish: ag.Material, turns: ag.Scalar, torque: ag.Scalar
) -> Fitting:
    """Make a cap or a lid on its thread: it turns and rises by the pitch."""
    jar = style == "jar"
    name, pitch = ("lid", 0.0080) if jar else ("cap", 0.0027)
    low, high = (0.0010, _FINISH["jar"] + 0.0012) if jar else (0.0024, 0.0168)
    inner = neck + FIT.running + 0.0004
    outer = inner + 0.0014
    grip = ag.cylinder(outer, high).at(z=low + high / 2)
    hold = ag.grasp_on(grip, approach=-ag.Z, closing=ag.X, depth=0.9 * high)
    light = finish.with_(name=f"{finish.name}_{name}", density=7800.0 * 0.28 if jar else 910.0)
    made = ag.part(_hollow(outer, inner, high, low), name, light, grasp=hold, name=name)
    if jar:
        rim = ag.tube(outer + 0.0006, outer - 0.0010, 0.0030, bevel=0.0006).at(z=low + 0.0016)
        skin = ag.tube(outer + 0.0002, outer - 0.0010, high - 0.0004, bevel=0.0004).at(z=low + high / 2)
        made = ag.weld(made, ag.detail([rim, skin], name, finish))
    else:
        made = ag.weld(made, _ribs(outer, high, low, finish, name))
    drag = feel.Feel(friction=torque, damping=0.01, armature=3e-3 if jar else 2e-4, effort=3.0)
    screw = ag.Screw(f"{name}_turn", pitch=pitch, axis=ag.Z, limits=(0, math.tau * turns), feel=drag)
    return Fitting.moving(made, screw)


def _flip(finish: ag.Material, swing: ag.Scalar) -> Fitting:
    """Make a cap with a hinged lid that a thumb lifts at its lip."""
    radius, base, tall = 0.0165, 0.016, 0.0085
    low = base + FIT.sliding
    cap = ag.part(ag.cylinder(radius, base, bevel=0.001).at(z=base / 2), "cap", finish)
    orifice = ag.detail(ag.cylinder(0.003, FIT.sliding).at(z=base), "cap", finish)
    disc = ag.cylinder(radius - 0.0004, tall, bevel=0.0012).at(z=low + tall / 2)
    lip = ag.box(0.010, 0.004, 0.003, bevel=0.0008).at(0, -radius - 0.0008, low + 0.002)
    hold = ag.grasp_on(disc, approach=-ag.Z, closing=ag.X, depth=0.8 * tall)
    lid = ag.part([disc, lip], "lid", finish, grasp=hold, name="lid")
    pivot = (0, radius + 0.0004, low - 0.0002)
    hinge = ag.Revolute(
        "lid_hinge", axis=-ag.X, pivot=pivot, limits=(0, swing), friction=0.02, feel=feel.PIVOT
    )
    return Fitting.moving(lid, hinge, fixed=ag.weld(cap, orifice))


def _pump(finish: ag.Material, travel: ag.Scalar, force: ag.Scalar) -> Fitting:
    """Make the collar of a pump, and its nozzle that slides down against a spring."""
    stem, collar = 0.0038, 0.0245
    bore = 2 * (stem + FIT.sliding)
    ring = ag.cylinder(0.0155, collar).at(z=collar / 2) - ag.box(bore, bore, 0.05).at(z=0.025)
    fixed = ag.weld(ag.part(ring, "collar", finish), _ribs(0.0155, 0.015, 0.0005, finish, "collar"))
    low = collar + 0.0012 + travel
    head = ag.Region((-0.0095, 0.0095), (-0.014, 0.010), (0.0, 0.010)).box(bevel=0.003)
    spout = ag.Region((-0.005, 0.005), (-0.040, -0.010), (0.0022, 0.0092)).box(bevel=0.002)
    pipe = ag.cylinder_between((0, 0, -travel - 0.0054), (0, 0, 0.002), stem)
    hold = ag.grasp_on(head, approach=-ag.Z, closing=ag.X, depth=0.008)
    press = ag.push_on(head, direction=-ag.Z)
    nozzle = ag.weld(
        ag.part([head, spout], "nozzle", finish, grasp=hold, push=press, name="nozzle"),
        ag.part(pipe, "stem", ag.material("polypropylene")),
    )
    spring = ag.Spring(preload=0.35 * force, force=force)
    slide = ag.Prismatic("nozzle_slide", axis=-ag.Z, limits=(0, travel), spring=spring, feel=_NOZZLE)
    return Fitting.moving(nozzle.at(z=low), slide, fixed=fixed)


def _stopper(finish: ag.Material, hold: ag.Scalar) -> Fitting:
    """Make the finish of a neck with a bore of 18.5 mm, and a stopper of cork under a head."""
    bore, high = 0.00925, _FINISH["stopper"]
    hole = ag.box(2 * bore, 2 * bore, high).at(z=high / 2 + 0.002)
    glass = _GLASS.with_(name="neck_glass", opacity=0.45)
    neck = ag.part(ag.cylinder(0.0148, high).at(z=high / 2) - hole, "neck", glass)
    shaft = ag.cylinder(bore - FIT.sliding, high - 0.004).at(z=high / 2 + 0.0022)
    head = ag.cylinder(0.0152, 0.013, bevel=0.0015).at(z=high + FIT.sliding + 0.0065)
    grip = ag.grasp_on(head, approach=-ag.Z, closing=ag.X, depth=0.011)
    stopper = ag.weld(
        ag.part(head, "stopper", finish, grasp=grip, name="stopper"), ag.part(shaft, "stopper", _CORK)
    )
    lift = ag.Prismatic(
        "stopper_lift", axis=ag.Z, limits=(0, 0.06), friction=hold, damping=3.0, armature=0.02, effort=60.0
    )
    return Fitting.moving(stopper, lift, fixed=neck)


def _trigger(finish: ag.Material, force: ag.Scalar) -> Fitting:
    """Make the head of a spray with its collar and nozzle, and the trigger that a spring pushes out."""
    collar = ag.cylinder(0.0155, 0.016, bevel=0.0008).at(z=0.008)
    trunk = ag.Region((-0.009, 0.009), (-0.006, 0.016), (0.014, 0.050)).box(bevel=0.002)
    barrel = ag.Region((-0.010, 0.010), (-0.046, 0.030), (0.048, 0.070)).box(bevel=0.004)
    tip = ag.cylinder(0.0085, 0.012, axis=ag.Y, bevel=0.001).at(0, -0.051, 0.059)
    white = ag.colored("polypropylene", "white")
    fixed = ag.weld(
        ag.part(collar, "collar", finish),
        ag.part([trunk, barrel], "collar", white.with_(name="spray_shell", density=420.0)),
        ag.part(tip, "collar", finish),
        _ribs(0.0155, 0.014, 0.001, finish, "collar"),
    )
    blade = ag.Region((-0.0075, 0.0075), (-0.044, -0.038), (0.002, 0.046)).box(bevel=0.002)
    press = ag.push_on(blade, direction=ag.Y, at=(0, -0.044, 0.014))
    trigger = ag.part(blade, "trigger", finish, push=press, name="trigger")
    arm = 0.030  # from the hinge to the finger [m]
    spring = ag.Spring(preload=0.35 * force * arm, force=force * arm)
    pull = ag.Revolute(
        "trigger_pull", axis=ag.X, pivot=(0, -0.041, 0.044), limits=(0, 0.32), spring=spring, feel=_TRIGGER
    )
    return Fitting.moving(trigger, pull, fixed=fixed)
