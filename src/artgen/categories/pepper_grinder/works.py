"""What grinds in a pepper mill and what turns it: burr and shaft, heads with their nut, and cranks.

The shaft stands on the z axis. Burr, shaft and head are one link, as they turn as one.
"""

import math
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen.categories.pepper_grinder.forms import WIDEST, Top, head_runs
from artgen.categories.shared.vessels.turned import Run, core, skin, turned

Finial = Literal["nut", "ball", "cap"]
"""What holds a head on its shaft: a knurled nut, a ball, or a low cap."""

STORE = 0.0108
"""Radius of the store of peppercorns in a turned body [m]."""

GAP = 0.0004
"""Between a head and its body [m]."""

_SHAFT = 0.0026  # radius of the shaft [m]
_RING = 0.0090  # radius of the hole of the female burr [m]
_TEETH = 14
_STEEL = ag.material("stainless")
_DEEP = 0.013  # height of the grinding works [m]
_UP = 0.0022  # of the works above the table [m]
_PIN = 0.0019  # radius of the pin of a crank's knob [m]
_PLAY = 0.0004  # of the knob on it [m]


def store(low: ag.Scalar, high: ag.Scalar, half: float = STORE) -> ag.Solid:
    """Make the tool that hollows a turned body out, square, so that few colliders surround it."""
    return ag.box_between((-half, -half, low), (half, half, high))


def _burr_outline() -> ag.Profile:
    steps = 4 * _TEETH
    angles = [math.tau * step / steps for step in range(steps)]
    radii = [1.0 if step % 4 < 2 else 0.84 for step in range(steps)]
    return ag.polygon([(r * math.cos(a), r * math.sin(a)) for r, a in zip(radii, angles, strict=True)])


def works() -> ag.Body:
    """Make the female burr in the foot of a mill, seen from below: a ring with teeth around its hole."""
    low, high = _UP, _UP + _DEEP
    reach = STORE + 0.0006  # into the wood around it
    frame = ag.box_between((-reach, -reach, low), (reach, reach, high))
    hole = ag.box_between((-_RING, -_RING, low - 0.001), (_RING, _RING, high + 0.001))
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
"""How deep fingers of 45 mm reach down a head before the hand comes near the nut on it [m]."""


def finial_of(style: Finial, metal: ag.Material, at: ag.Scalar) -> ag.Body:
    """Make the nut that holds a head, on a face at a height."""
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
    """How what turns is made."""

    finish: ag.Material  # of a head, or of the knob of a crank
    metal: ag.Material  # of nut, crank and cap
    finial: Finial  # the nut
    across: float  # share by which it is narrower than its drawing, so that it fits the body


def head(top: Top, radius: ag.Scalar, low: ag.Scalar, height: ag.Scalar, looks: HeadLooks) -> ag.Body:
    """Make the head that turns, with shaft, burr and nut: the link `top`."""
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
    """Make the joint of what grinds: it turns without end, against the peppercorns between the burrs."""
    return ag.Revolute(
        name,
        axis=ag.Z,
        friction=friction,  # a mill full of peppercorns takes 0.1-0.4 N m
        damping=0.01,
        armature=0.0002,
        effort=3.0,
    )


@dataclass(frozen=True)
class Crank:
    """A crank."""

    reach: ag.Scalar  # from the axis to the middle of its knob [m]
    knob: ag.Scalar  # radius of the knob [m]
    friction: ag.Scalar  # of the knob on its pin [N m]


def crank(sizes: Crank, low: ag.Scalar, looks: HeadLooks) -> ag.Body:
    """Make a crank with its shaft and burr, the link `crank`, and its knob on a pin, the link `knob`."""
    reach, thick = sizes.reach, 0.0030
    level = low + 0.0052  # of the underside of the arm
    end = level + 0.012  # the arm rises to its outer end
    hub = ag.cylinder_between((0.0, 0.0, low + GAP), (0.0, 0.0, level + thick), 0.0085, bevel=0.001)
    # from the side: level over the cap, then up in a bend to the knob, which points to the front
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
    hole = ag.box_between((-_PIN - _PLAY, -_PIN - _PLAY, end), (_PIN + _PLAY, _PIN + _PLAY, top + 0.01))
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
    """Return the outline of a knob like a pear, 1.9 radii high."""
    drawn = ((0.62, 0.0), (0.66, 0.16), (0.94, 0.86), (1.0, 1.22), (0.84, 1.66), (0.46, 1.90))
    return [[(r * radius, low + z * radius) for r, z in drawn]]
