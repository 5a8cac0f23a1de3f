"""Locks and lifts of windows that slide: the cam of a double-hung one, hook lifts, and latches on a stile.

Insides look to +y. A maker returns what is welded to the sash, what moves, and what is on the frame.
"""

import math
from typing import NamedTuple

from artgen import (
    Body,
    Joint,
    Material,
    Prismatic,
    Revolute,
    Scalar,
    X,
    Y,
    Z,
    array,
    box,
    box_between,
    cylinder_between,
    details,
    grasp_on,
    hull,
    part,
    union,
    weld,
)

LATCH_TOP = 0.044
"""From the middle of a latch on the stile of a sliding sash to its top [m]."""


class SashLock(NamedTuple):
    """A cam on the lower meeting rail that turns under a keeper on the upper one."""

    base: Body  # to be welded to the lower sash
    cam: Body  # what turns: the link `lock`
    keeper: Body  # to be welded to the upper sash
    turn: Joint  # the joint of the cam
    free: float  # where the cam has left the upper sash [rad]


def sash_lock(
    x: Scalar, lower: Scalar, upper: Scalar, top: Scalar, *, friction: Scalar, finish: Material
) -> SashLock:
    """Make the lock of a double-hung window."""
    axis = lower + 0.015
    base = hull(
        box(0.056, 0.024, 0.004, bevel=0.0015).at(x, axis + 0.001, top + 0.0015),
        box(0.030, 0.018, 0.004, bevel=0.0015).at(x, axis, top + 0.0105),
    )
    screws = [
        details.screw(
            0.0028, (x + side * 0.0235, axis, top + 0.0042), facing=Z, material=finish, label="screw"
        )
        for side in (-1, 1)
    ]
    hub = cylinder_between((x, axis, top + 0.0129), (x, axis, top + 0.0335), 0.0085, bevel=0.001)
    tip = upper - 0.0033  # bars on the glass begin 4 mm behind that face
    tongue = hull(
        box_between((x - 0.007, axis - 0.002, top + 0.0145), (x + 0.007, axis, top + 0.0195)),
        box_between((x - 0.004, tip, top + 0.0145), (x + 0.004, tip + 0.004, top + 0.0195)),
    )
    arm = box(0.052, 0.011, 0.0055, bevel=0.0022).at(x - 0.026, axis, top + 0.0305)
    hold = grasp_on(arm, approach=(0.0, -1.0, 0.0), closing=Z, at=(x - 0.040, axis, top + 0.0305))
    cam = part(union(hub, tongue, arm), "lock", finish, name="lock", grasp=hold)
    wall = box_between(
        (x - 0.020, upper - 0.0135, top - 0.0005), (x + 0.020, upper - 0.0098, top + 0.0262), bevel=0.0008
    )
    roof = box_between(
        (x - 0.020, upper - 0.0135, top + 0.0212), (x + 0.020, upper - 0.0006, top + 0.0262), bevel=0.0012
    )
    turn = Revolute(
        "lock_turn",
        axis=-Z,  # takes the lever from the left over the room to the right
        pivot=(x, axis, top),
        limits=(0.0, math.pi),
        friction=friction,
        damping=0.02,
        armature=0.0002,
        effort=5.0,
    )
    return SashLock(
        weld(part(base, "lock", finish), *screws), cam, part(union(wall, roof), "keep", finish), turn, 1.35
    )


def sash_lifts(places: list[Scalar], face: Scalar, z: Scalar, finish: Material) -> Body:
    """Make hook lifts on the bottom rail of a sash whose face looks to +y."""
    plate = box(0.054, 0.0035, 0.026, bevel=0.0014).at(0.0, face + 0.0012, z)
    hook = box_between((-0.023, face + 0.001, z + 0.001), (0.023, face + 0.020, z + 0.0065), bevel=0.0022)
    lip = box_between((-0.023, face + 0.016, z + 0.001), (0.023, face + 0.020, z + 0.0125), bevel=0.0018)
    lift = union(plate, hook, lip)
    holds = [
        grasp_on(hook.at(x, 0.0, 0.0), approach=(0.0, -1.0, 0.0), closing=X, depth=0.0145) for x in places
    ]
    screws = [
        details.screw(
            0.0026, (x + side * 0.018, face + 0.0029, z - 0.006), facing=Y, material=finish, label="screw"
        )
        for x in places
        for side in (-1, 1)
    ]
    return weld(part(array(lift, at=[(x, 0.0, 0.0) for x in places]), "handle", finish, grasp=holds), *screws)


class Latch(NamedTuple):
    """A latch on the stile of a sliding sash that drops behind a keep on the frame."""

    case: Body  # to be welded to the sash
    slider: Body  # what is lifted: the link `lock`
    keep: Body  # to be welded to the frame
    slide: Joint  # the joint of the slider
    free: float  # height at which it clears the keep [m]
    passed: float  # way of the sash at which it has passed the keep [m]


def sliding_latch(
    at: tuple[Scalar, Scalar, Scalar],
    floor: Scalar,
    way: int,
    *,
    name: str,
    friction: Scalar,
    finish: Material,
) -> Latch:
    """Make a latch on the face of a sash that looks to +y."""
    x, face, z = at
    tall, wide = 0.014, 0.010  # of the keep, and of what drops beside it [m]
    bottom = floor + 0.0015
    slider = box_between(
        (x - wide / 2.0, face + 0.003, bottom), (x + wide / 2.0, face + 0.0105, z + 0.020), bevel=0.001
    )
    nub = box_between(
        (x - 0.009, face + 0.0092, z - 0.008), (x + 0.009, face + 0.026, z + 0.008), bevel=0.003
    )
    hold = grasp_on(nub, approach=(0.0, -1.0, 0.0), closing=X, depth=0.013)
    body = part(union(slider, nub), "lock", finish, name="lock", grasp=hold)
    # the slider runs between two cheeks on a plate
    low, high = floor + 0.0185 + 0.004, z + LATCH_TOP
    plate = box_between((x - 0.013, face - 0.0005, low), (x + 0.013, face + 0.0024, high), bevel=0.0008)
    cheeks = [
        box_between(
            (x + side * 0.0095 - 0.0035, face, low),
            (x + side * 0.0095 + 0.0035, face + 0.0085, high),
            bevel=0.0015,
        )
        for side in (-1, 1)
    ]
    keep = box_between(
        (x + way * (wide / 2.0 + 0.0012 + 0.005) - 0.005, face + 0.0040, floor - 0.0005),
        (x + way * (wide / 2.0 + 0.0012 + 0.005) + 0.005, face + 0.0125, floor + tall),
        bevel=0.0012,
    )
    slide = Prismatic(
        name, axis=Z, limits=(0.0, 0.018), friction=friction, damping=1.0, armature=0.02, effort=30.0
    )
    case = weld(*(part(each, "lock", finish) for each in (plate, *cheeks)))
    return Latch(case, body, part(keep, "keep", finish), slide, tall + 0.0015, 2.0 * wide + 0.006)
