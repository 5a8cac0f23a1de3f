"""The outside of an entrance door's grip set: a plate with a fixed grip and a thumb piece above it."""

from math import pi

import artgen as ag
from artgen.categories.shared.finish import casting
from artgen.categories.shared.locks import plug

THUMB_RANGE = 0.28
"""Range of a thumb piece [rad]."""

_PIVOT = 0.0085  # distance from the plate to the pin of the thumb piece [m]
_BARREL = 0.0045  # radius of the thumb piece about its pin [m]
_WIDE = 0.022  # length of the barrel [m]
_EAR = 0.003  # thickness of the ears that hold the pin [m]
_PLAY = 0.0004  # gap between barrel and ears [m]
_CYLINDER = 0.0085  # radius of the plug of the key cylinder [m]
_KEY = 0.038  # height of the key cylinder above the spindle [m]
_GRIP_TOP = 0.048  # distance from the spindle down to the upper end of the grip, within a thumb's reach [m]


def grip(
    *,
    thickness: ag.Scalar,
    depth: ag.Scalar,
    finish: ag.Material,
    length: ag.Scalar,
    projection: ag.Scalar,
    side: int = -1,
) -> ag.Body:
    """Make the plate, the ears of the thumb piece and the fixed grip, all welded to the leaf."""
    face = thickness / 2 + depth
    plate = ag.extrude(ag.slot(0.150, 0.058).rotate(pi / 2), depth + 0.0005, axis=ag.Y, bevel=0.002)
    ear = ag.box(_EAR, _PIVOT + 0.0055, 0.012, bevel=0.001)
    ears = [
        ear.at(end * (_WIDE / 2 + _PLAY + _EAR / 2), side * (face + (_PIVOT + 0.0045) / 2), 0.0)
        for end in (-1, 1)
    ]
    top, bottom = -_GRIP_TOP, -_GRIP_TOP - length
    root, out = side * (thickness / 2 - 0.0005), side * (thickness / 2 + projection)
    course = ag.polyline(
        [(0.0, root, top), (0.0, out, top), (0.0, out, bottom), (0.0, root, bottom)], fillet=0.024
    )
    bar = ag.sweep(ag.rectangle(0.021, 0.015, radius=0.006), course)
    flange = ag.cylinder(0.0165, 0.006, axis=ag.Y, bevel=0.0018).at(0.0, root + side * 0.003, bottom)
    hold = ag.frame((0.0, out, (top + bottom) / 2), approach=(0.0, -side, 0.0), closing=(1.0, 0.0, 0.0))
    pin = ag.cylinder(0.0022, _EAR + 0.0006, axis=ag.X, bevel=0.0005)
    ends = [(end * (_WIDE / 2 + _PLAY + _EAR / 2 + 0.0003), side * (face + _PIVOT), 0.0) for end in (-1, 1)]
    middle = side * (thickness / 2 + (depth - 0.0005) / 2)
    collar = ag.cylinder(_CYLINDER + 0.004, 0.0040, axis=ag.Y, bevel=0.0014).at(
        0.0, side * (face + 0.0008), _KEY
    )
    return ag.weld(
        ag.part(bar | flange, "grip", casting(finish), grasp=hold),
        ag.part(plate.at(0.0, middle, -0.012), "rose", casting(finish)),
        *(ag.part(each, "rose", finish) for each in ears),
        ag.detail(ag.array(pin, at=ends), "rose", finish),
        ag.detail(collar, "cylinder", finish),
        *plug(face=face + 0.0028, side=side, finish=finish, radius=_CYLINDER, below=-_KEY),
    )


def thumb_piece(*, thickness: ag.Scalar, depth: ag.Scalar, finish: ag.Material, side: int = -1) -> ag.Body:
    """Make the thumb piece above the grip: the link `thumb_latch`; attach it by `thumb_press`."""
    pivot = thickness / 2 + depth + _PIVOT
    barrel = ag.cylinder(_BARREL, _WIDE, axis=ag.X, bevel=0.0008).at(0.0, side * pivot, 0.0)
    blade = ag.box(0.014, 0.036, 0.0042, bevel=0.0014).at(0.0, side * (pivot + 0.016), 0.0)
    pad = ag.cylinder(0.0125, 0.0042, axis=ag.Z, bevel=0.0016).at(0.0, side * (pivot + 0.040), 0.0)
    return ag.part(ag.union(barrel, blade, pad), "thumb_latch", finish, push=ag.push_on(pad, direction=-ag.Z))


def thumb_press(
    turn: ag.Joint,
    *,
    limit: ag.Scalar,
    thickness: ag.Scalar,
    depth: ag.Scalar,
    side: int = -1,
    name: str = "thumb_press",
) -> ag.Joint:
    """Make the joint of a thumb piece that follows the inside handle; positive presses it down."""
    pivot = (0.0, side * (thickness / 2 + depth + _PIVOT), 0.0)
    return ag.Revolute(
        name, axis=(-side, 0.0, 0.0), pivot=pivot, follows=(THUMB_RANGE / limit) * turn, damping=0.005
    )
