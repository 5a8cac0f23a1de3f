"""Grinder works, cranks and knobs, and the bodies around them."""

import math
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen.categories.pepper_grinder.forms import WIDEST, BodyForm, Top, body_runs, fitting, head_runs
from artgen.categories.shared.vessels import Run, core, skin, turned

Finial = Literal["nut", "ball", "cap"]
"""Fixing of a head on its shaft: a knurled nut, a ball, or a low cap."""

STORE = 0.0108
"""Radius of the store of peppercorns in a turned body [m]."""

GAP = 0.0004
"""Gap between a head and its body [m]."""

_SHAFT = 0.0026  # radius of the shaft [m]
_RING = 0.0090  # radius of the hole of the female burr [m]
_TEETH = 14
_STEEL = ag.material("stainless")
_DEEP = 0.013  # height of the grinding works [m]
_UP = 0.0022  # height of the works above the table [m]
_PIN = 0.0019  # radius of the pin of a crank's knob [m]
_PLAY = 0.0004  # gap between the knob and the pin [m]


def store(low: ag.Scalar, high: ag.Scalar, half: float = STORE) -> ag.Solid:
    """Make the cutter that hollows a turned body; it is square, so that the body needs few colliders."""
    return ag.Region.between((-half, -half, low), (half, half, high)).box()


def _burr_outline() -> ag.Profile:
    steps = 4 * _TEETH
    angles = [math.tau * step / steps for step in range(steps)]
    radii = [1.0 if step % 4 < 2 else 0.84 for step in range(steps)]
    return ag.polygon([(r * math.cos(a), r * math.sin(a)) for r, a in zip(radii, angles, strict=True)])


def works() -> ag.Body:
    """Make the female burr in the foot of a mill, visible from below: a ring with teeth around its hole."""
    low, high = _UP, _UP + _DEEP
    reach = STORE + 0.0006  # overlap with the wood around it
    frame = ag.Region.between((-reach, -reach, low), (reach, reach, high)).box()
    hole = ag.Region.between((-_RING, -_RING, low - 0.001), (_RING, _RING, high + 0.001)).box()
    plate = skin([[(reach, low - 0.0003), (reach, low + 0.0012)]], bore=_RING)
    return ag.weld(
        ag.part(frame - hole, "mechanism", _STEEL.with_(name="burr_steel", density=5000.0)),
        ag.detail(plate, "mechanism", _STEEL),
    )


def shaft(high: ag.Scalar) -> ag.Body:
    """Make the shaft with the male burr at its lower end, up to a height."""
    burr = ag.revolve(
        ag.polygon([(0.0, _UP + 0.0006), (0.0078, _UP + 0.0006), (0.0050, _UP + _DEEP), (0.0, _UP + _DEEP)]),
        sides=16,
    )
    teeth = ag.extrude(_burr_outline().scale(0.0084), 0.010, taper=0.3, twist=0.5).at(0.0, 0.0, _UP + 0.0056)
    screw = ag.cylinder_between((0.0, 0.0, _UP - 0.0008), (0.0, 0.0, _UP + 0.0023), 0.0034, bevel=0.0006)
    rod = ag.cylinder_between((0.0, 0.0, _UP + 0.002), (0.0, 0.0, high), _SHAFT)
    return ag.weld(
        ag.part(rod, "shaft", _STEEL),
        ag.part(burr, "burr", ag.material("steel")),
        ag.detail(teeth, "burr", ag.material("steel")),
        ag.detail(screw, "screw", _STEEL),
    )


_FREE = 0.0275
"""Reach of fingers of 45 mm down a head before the hand touches the nut on it [m]."""


def finial_of(style: Finial, metal: ag.Material, at: ag.Scalar) -> ag.Body:
    """Make the nut on a face at a height, which holds a head."""
    match style:
        case "nut":
            runs: list[Run] = [
                [(0.0072, at), (0.0072, at + 0.0018)],
                [(0.0058, at + 0.0018), (0.0062, at + 0.0070)],
                [(0.0062, at + 0.0070), (0.0046, at + 0.0088), (0.0014, at + 0.0096)],
            ]
        case "ball":
            middle = at + 0.0086
            turns = [math.radians(angle) for angle in (-55.0, -20.0, 15.0, 50.0, 80.0)]
            runs = [
                [(0.0066, at), (0.0066, at + 0.0016)],
                [(0.0066 * math.cos(turn), middle + 0.0066 * math.sin(turn)) for turn in turns],
            ]
        case "cap":
            runs = [
                [(0.0100, at), (0.0100, at + 0.0016)],
                [(0.0100, at + 0.0016), (0.0070, at + 0.0036), (0.0012, at + 0.0043)],
            ]
    return turned(runs, "finial", metal, sides=16)


@dataclass(frozen=True)
class HeadLooks:
    """Dimensions and finish of the turning parts."""

    finish: ag.Material  # finish of a head, or of the knob of a crank
    metal: ag.Material  # metal of nut, crank and cap
    finial: Finial  # the nut
    across: float  # narrowing of the head that fits it to the body, as a share


def head(top: Top, radius: ag.Scalar, low: ag.Scalar, height: ag.Scalar, looks: HeadLooks) -> ag.Body:
    """Make the turning head, with shaft, burr and nut: the link `top`."""
    runs = head_runs(top, radius, low + GAP, height, across=looks.across)
    upper = low + GAP + height
    solid = core(runs)
    deep = ag.min_((1.0 - WIDEST[top]) * height + 0.007, _FREE)
    hold = ag.grasp_on(solid, approach=-ag.Z, closing=ag.X, depth=deep)
    tenon = ag.cylinder_between((0.0, 0.0, low - 0.008), (0.0, 0.0, low + 0.002), STORE - 0.0012)
    return ag.weld(
        ag.part(solid, "top", looks.finish, grasp=hold),
        ag.detail(skin(runs), "top", looks.finish),
        ag.part(tenon, "top", looks.finish),
        shaft(upper),
        finial_of(looks.finial, looks.metal, upper - 0.0004),
    )


def head_turn(name: str, friction: ag.Scalar) -> ag.Joint:
    """Make the joint of the burr: it turns without limits, against the friction of the peppercorns."""
    return ag.Revolute(
        name,
        axis=ag.Z,
        friction=friction,  # friction of a mill full of peppercorns, 0.1-0.4 N m
        damping=0.01,
        armature=0.0002,
        effort=3.0,
    )


@dataclass(frozen=True)
class Crank:
    """Dimensions and friction of a crank."""

    reach: ag.Scalar  # distance from the axis to the middle of the knob [m]
    knob: ag.Scalar  # radius of the knob [m]
    friction: ag.Scalar  # friction of the knob on its pin [N m]


def crank(sizes: Crank, low: ag.Scalar, looks: HeadLooks) -> ag.Body:
    """Make a crank with its shaft and burr, the link `crank`, and its knob on a pin, the link `knob`."""
    reach, thick = sizes.reach, 0.0030
    level = low + 0.0052  # height of the underside of the arm
    end = level + 0.012  # the arm rises to its outer end
    hub = ag.cylinder_between((0.0, 0.0, low + GAP), (0.0, 0.0, level + thick), 0.0085, bevel=0.001)
    # side view: horizontal over the cap, then up in a bend to the knob, which points to the front
    line = ag.spline(
        [
            (0.0, 0.006, level + thick / 2.0),
            (0.0, -0.35 * reach, level + thick / 2.0 + 0.0005),
            (0.0, -0.72 * reach, end - 0.004),
            (0.0, -reach, end),
            (0.0, -reach - 0.006, end),
        ]
    )
    arm = ag.sweep(ag.rectangle(0.0105, thick, radius=0.0012), line)
    eye = ag.cylinder_between((0.0, -reach, end - 0.0022), (0.0, -reach, end + 0.0026), 0.0076, bevel=0.0008)
    grip = _knob_runs(sizes.knob, end + 0.0026 + GAP)
    top = end + 0.0026 + GAP + 1.9 * sizes.knob
    pin = ag.cylinder_between((0.0, 0.0, end), (0.0, 0.0, top + GAP + 0.0008), _PIN)
    head_ = ag.cylinder_between((0.0, 0.0, top + GAP), (0.0, 0.0, top + GAP + 0.0016), 0.0042, bevel=0.0006)
    hole = ag.Region.between(
        (-_PIN - _PLAY, -_PIN - _PLAY, end), (_PIN + _PLAY, _PIN + _PLAY, top + 0.01)
    ).box()
    hold = ag.grasp_on(core(grip), approach=-ag.Z, closing=ag.X, depth=1.25 * sizes.knob)
    knob = turned(
        grip, "knob", looks.finish, hole=hole, spare=0.0003, bore=_PIN + _PLAY, sides=16, grasp=hold
    )
    spin = ag.Revolute(
        "knob_spin",
        axis=ag.Z,
        pivot=(0.0, -reach, 0.0),
        friction=sizes.friction,
        damping=0.0002,
        armature=0.00001,
        effort=0.3,
    )
    metal = looks.metal
    turning = ag.weld(
        ag.part(arm, "crank", metal),
        ag.part(hub, "crank", metal),
        ag.part(eye, "crank", metal),
        ag.part(pin.at(0.0, -reach), "crank", metal),
        ag.part(head_.at(0.0, -reach), "crank", metal),
        shaft(level + thick),
        finial_of("nut" if looks.finial == "ball" else looks.finial, metal, level + thick - 0.0003),
    )
    return turning.attach(knob.at(0.0, -reach), spin)


def _knob_runs(radius: ag.Scalar, low: ag.Scalar) -> list[Run]:
    """Return the outline of a pear-shaped knob, 1.9 radii high."""
    drawn = ((0.62, 0.0), (0.66, 0.16), (0.94, 0.86), (1.0, 1.22), (0.84, 1.66), (0.46, 1.90))
    return [[(r * radius, low + z * radius) for r, z in drawn]]


Content = Literal["pepper", "salt", "mixed"]
"""Contents of a mill: black peppercorns, salt, or peppercorns of four colors."""

INSET = 0.0016
"""Depth of a clear tube behind its foot and collar [m]."""

_WALL = 0.0028  # wall thickness of a clear tube [m]
_BULK = 560.0  # bulk density of peppercorns in a mill [kg/m3]
_AROUND = 20  # number of grains in a ring behind the clear wall
_GRAINS = {
    "pepper": ((0.060, 0.036, 0.022), 0.0024),
    "salt": ((0.82, 0.80, 0.78), 0.0021),
    "mixed": ((0.070, 0.042, 0.026), 0.0024),
}  # color, and radius of a grain [m]
_OTHERS = {"pepper": (0.105, 0.066, 0.042), "salt": (0.88, 0.86, 0.84), "mixed": (0.28, 0.05, 0.03)}
_ROOM = 0.0036  # half the width of holes for the shaft [m]


def wooden(form: BodyForm, radius: ag.Scalar, height: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make a one-piece turned body, with its store and works: the link `body`."""
    runs = body_runs(form, radius, 0.0, height)
    return ag.weld(turned(runs, "body", finish, hole=store(-0.001, height + 0.001), bore=STORE), works())


def capped(
    body: ag.Body, form: BodyForm, radius: ag.Scalar, low: ag.Scalar, height: ag.Scalar, metal: ag.Material
) -> ag.Body:
    """Put the domed cap of a mill with a crank on its body."""
    # a little lower, so that it shares no corners with the body
    runs = head_runs("crank", radius, low - 0.0002, height + 0.0002, across=fitting(form, "crank"))
    return ag.weld(
        body, turned(runs, "cap", metal, hole=store(low - 0.001, low + height + 0.001, _ROOM), bore=_ROOM)
    )


def ring(radius: ag.Scalar, low: ag.Scalar, high: ag.Scalar, metal: ag.Material) -> ag.Body:
    """Make the thin band of metal around a body, visual only."""
    runs: list[Run] = [
        [(radius - 0.0004, low), (radius, low + 0.0004)],
        [(radius, low + 0.0004), (radius, high - 0.0004)],
        [(radius, high - 0.0004), (radius - 0.0004, high)],
    ]
    return ag.detail(skin(runs, bore=radius - 0.002), "ring", metal)


def clear(
    radius: ag.Scalar,
    height: ag.Scalar,
    finish: ag.Material,
    ends: ag.Material,
    *,
    content: Content,
    rings: int,
) -> ag.Body:
    """Make a clear tube with its contents between a foot and a collar: the link `body`."""
    foot, collar = 0.020 + 0.10 * radius, 0.010
    below: list[Run] = [
        [(0.97 * radius, 0.0), (radius, 0.0016)],
        [(radius, 0.0016), (radius, foot - 0.0012)],
        [(radius, foot - 0.0012), (radius - 0.0012, foot)],
    ]
    top = height - collar
    above: list[Run] = [
        [(radius - 0.0010, top), (radius, top + 0.0010)],
        [(radius, top + 0.0010), (radius, height - 0.0010)],
        [(radius, height - 0.0010), (radius - 0.0010, height)],
    ]
    outer = radius - INSET
    tube = ag.revolve(
        ag.half_section(ag.line((outer, 0.0, foot - 0.001), (outer, 0.0, top + 0.001)), wall=_WALL)
    )
    inner = outer - _WALL
    filled = foot + 0.82 * (top - foot)
    return ag.weld(
        turned(below, "body", ends, hole=store(-0.001, foot + 0.001), bore=STORE),
        turned(above, "body", ends, hole=store(top - 0.001, height + 0.001), bore=STORE),
        ag.part(ag.simplified_collider(tube), "body", finish.with_(name="clear_tube", density=1180.0)),
        _filling(content, inner, foot, filled, rings),
        works(),
    )


def _filling(content: Content, inner: ag.Scalar, low: ag.Scalar, high: ag.Scalar, rings: int) -> ag.Body:
    """Make the peppercorns in a tube: a core with their mass, and the visible grains at the wall."""
    color, size = _GRAINS[content]
    stuff = ag.material("polypropylene").with_(
        name=f"grains_{content}", base_color=color, density=_BULK, texture="", specular_roughness=0.8
    )
    others = stuff.with_(name=f"grains_{content}_light", base_color=_OTHERS[content])
    wide = inner - 1.6 * size
    heap = ag.revolve(
        ag.polygon([(0.0, low - 0.0005), (wide, low - 0.0005), (wide, high), (0.0, high)]), sides=16
    )
    hole = store(low - 0.01, high + 0.01, _ROOM)
    grain = ag.revolve(
        ag.polygon([(0.0, -1.0), (0.85, -0.55), (1.0, 0.15), (0.7, 0.8), (0.0, 1.0)]), sides=6
    ).scale(size)
    step = (high - low - 2.0 * size) / (2 * rings - 1)
    seen = []
    for index, grains in enumerate((stuff, others)):
        ring_ = ag.ring_points(
            (0.0, 0.0, low + size + index * step),
            inner - 1.15 * size,
            count=_AROUND,
            start=index * math.pi / _AROUND,
        )
        column = ag.array(
            ag.array(grain, at=ring_), at=ag.row((0.0, 0.0, 0.0), (0.0, 0.0, 2.0 * step), rings)
        )
        seen.append(ag.detail(column, "peppercorns", grains))
    lid = ag.array(grain, at=ag.ring_points((0.0, 0.0, high), 0.62 * inner, count=11))
    return ag.weld(ag.part(heap - hole, "peppercorns", stuff), *seen, ag.detail(lid, "peppercorns", stuff))
