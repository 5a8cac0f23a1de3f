"""The outside of an entrance door's grip set: a plate with a fixed grip and a thumb piece above it.

Parts are modeled about the spindle of a leaf whose middle is y = 0; the outside faces -Y. The thumb piece
turns on a pin in two ears and goes down with the handle inside.
"""

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
    *, thickness: ag.Scalar, depth: ag.Scalar, finish: ag.Material, length: ag.Scalar, projection: ag.Scalar
) -> ag.Body:
    """Make the plate, the ears of the thumb piece and the fixed grip, all welded to the leaf."""
    face, out = -thickness / 2 - depth, -thickness / 2 - projection
    plate = ag.extrude(ag.slot(0.150, 0.058).rotate(pi / 2), depth + 0.0005, axis=ag.Y, bevel=0.002)
    beside = _WIDE / 2 + _PLAY + _EAR / 2
    ear = ag.box(_EAR, _PIVOT + 0.0055, 0.012, bevel=0.001).at(0.0, face - (_PIVOT + 0.0045) / 2)
    pin = ag.cylinder(0.0022, _EAR + 0.0006, axis=ag.X, bevel=0.0005).at(0.0, face - _PIVOT)
    top, bottom, root = -_GRIP_TOP, -_GRIP_TOP - length, -thickness / 2 + 0.0005
    line = [(0.0, root, top), (0.0, out, top), (0.0, out, bottom), (0.0, root, bottom)]
    bar = ag.sweep(ag.rectangle(0.021, 0.015, radius=0.006), ag.polyline(line, fillet=0.024))
    flange = ag.cylinder(0.0165, 0.006, axis=ag.Y, bevel=0.0018).at(0.0, root - 0.003, bottom)
    hold = ag.frame((0.0, out, (top + bottom) / 2), approach=ag.Y, closing=ag.X)
    collar = ag.cylinder(_CYLINDER + 0.004, 0.0040, axis=ag.Y, bevel=0.0014).at(0.0, face - 0.0008, _KEY)
    return ag.weld(
        ag.part(bar | flange, "grip", casting(finish), grasp=hold),
        ag.part(plate.at(0.0, face + (depth + 0.0005) / 2, -0.012), "rose", casting(finish)),
        ag.part([ear.at(-beside), ear.at(beside)], "rose", finish),
        ag.detail([pin.at(-beside - 0.0003), pin.at(beside + 0.0003), collar], "rose", finish),
        *plug(face=-face + 0.0028, side=-1, finish=finish, radius=_CYLINDER, below=-_KEY),
    )


def thumb_piece(*, thickness: ag.Scalar, depth: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make the thumb piece above the grip: the link `thumb_latch`; attach it by `thumb_press`."""
    pivot = -thickness / 2 - depth - _PIVOT
    barrel = ag.cylinder(_BARREL, _WIDE, axis=ag.X, bevel=0.0008).at(0.0, pivot)
    blade = ag.box(0.014, 0.036, 0.0042, bevel=0.0014).at(0.0, pivot - 0.016)
    pad = ag.cylinder(0.0125, 0.0042, bevel=0.0016).at(0.0, pivot - 0.040)
    return ag.part(ag.union(barrel, blade, pad), "thumb_latch", finish, push=ag.push_on(pad, direction=-ag.Z))


def thumb_press(turn: ag.Joint, *, limit: ag.Scalar, thickness: ag.Scalar, depth: ag.Scalar) -> ag.Joint:
    """Make the joint of a thumb piece that follows the inside handle; positive presses it down."""
    pivot, follows = (0.0, -thickness / 2 - depth - _PIVOT, 0.0), (THUMB_RANGE / limit) * turn
    return ag.Revolute("thumb_press", axis=ag.X, pivot=pivot, follows=follows, damping=0.005)
