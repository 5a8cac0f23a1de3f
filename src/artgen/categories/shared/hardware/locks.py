"""Locks: a deadbolt with its thumb turn and key cylinder, and the privacy pins of knobs and roses.

A deadbolt is drawn about its own axis, in the middle of the leaf, its lock edge at x = backset.
"""

import math
from typing import Literal

import artgen as ag
from artgen.asset.gripper import GRIPPER
from artgen.categories.shared.finish import casting
from artgen.categories.shared.hardware.latch import DEADBOLT, PLAY
from artgen.categories.shared.hardware.roses import PIN, SPINDLE, plug, spindle_hole

THROW = 0.025
"""How far a deadbolt comes out: 1 inch, the least that ANSI/BHMA A156.5 accepts [m]."""

QUARTER = 1.57
"""The range of a thumb turn [rad]."""

PIN_TRAVEL = 0.004
"""How far the pin of a privacy lock is pressed in [m]."""

_TAIL = 0.020  # what stays in the leaf when the bolt is thrown [m]
_RECESSED = 0.0005  # a drawn bolt ends this far inside the lock edge [m]
_ROSETTE = 0.0275  # radius of the covers [m]
_ROSETTE_DEPTH = 0.009
_FROM_BELOW = 0.9  # angle from which a hand comes to a button under a lever [rad]
_GAP = 0.0005  # between a rosette and what turns on it [m]


def deadbolt(*, backset: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make a deadbolt, drawn back: the link `deadbolt`."""
    length = THROW + _TAIL
    bolt = ag.box(length, DEADBOLT.width, DEADBOLT.height, bevel=0.001)
    return ag.part(bolt.align((backset - _RECESSED, 0.0, 0.0), x=1.0), "deadbolt", finish)


def deadbolt_slide(turn: ag.Joint, *, name: str = "deadbolt_slide") -> ag.Joint:
    """Make the joint that throws a deadbolt by its thumb turn; positive is thrown."""
    return ag.Prismatic(name, axis=ag.X, follows=(THROW / QUARTER) * turn, damping=5.0, friction=0.5)


def deadbolt_pocket(*, backset: ag.Scalar) -> ag.Solid:
    """Make the tool that cuts the deadbolt's pocket into the lock edge of the leaf."""
    # from 5 mm past the edge into the hole of the spindle, as high as that
    pocket = ag.box(backset + 0.005, DEADBOLT.width + 2 * PLAY, DEADBOLT.height + 2 * PLAY)
    return pocket.align((backset + 0.005, 0.0, 0.0), x=1.0)


def deadbolt_hole(thickness: ag.Scalar) -> ag.Solid:
    """Make the tool that cuts the hole for the spindle of a thumb turn through a leaf."""
    return spindle_hole(thickness, height=DEADBOLT.height + 2 * PLAY)


def thumb_turn_joint(
    name: str = "lock_turn", *, pivot: ag.VectorLike = (0.0, 0.0, 0.0), friction: ag.Scalar = 0.12
) -> ag.Joint:
    """Make the joint of a thumb turn, held by the friction of its detent; positive throws the bolt."""
    return ag.Revolute(
        name, axis=ag.Y, pivot=pivot, limits=(0.0, QUARTER), friction=friction, damping=0.02, armature=0.0001
    )


def thumb_turn(*, thickness: ag.Scalar, finish: ag.Material, side: int = -1) -> ag.Body:
    """Make a thumb turn, upright while the bolt is drawn: the link `lock`."""
    start = thickness / 2 + _ROSETTE_DEPTH + _GAP
    base = ag.cylinder(0.012, 0.004, axis=ag.Y, bevel=0.0012).at(0.0, side * (start + 0.002), 0.0)
    wing = ag.bounding_collider(ag.box(0.007, 0.018, 0.034, bevel=0.003)).at(0.0, side * (start + 0.012), 0.0)
    reach = start + 0.003  # from the middle of the leaf into the turn
    stem = ag.cylinder(SPINDLE, reach, axis=ag.Y).at(0.0, side * reach / 2, 0.0)
    hold = ag.grasp_on(wing, approach=(0.0, -side, 0.0), closing=ag.X, depth=0.016)  # 1 mm off its base
    return ag.part(ag.union(base, wing, stem), "lock", finish, grasp=hold)


def deadbolt_cover(*, thickness: ag.Scalar, finish: ag.Material, side: int = -1) -> ag.Body:
    """Make the rosette under a thumb turn and, on the other face, the key cylinder; weld it to the leaf."""
    deep = _ROSETTE_DEPTH + 0.0005
    middle = thickness / 2 - 0.0005 + deep / 2
    rosette = ag.cylinder(_ROSETTE, deep, axis=ag.Y, bevel=0.0022)
    rosette = rosette.at(0.0, side * middle, 0.0) - spindle_hole(thickness + 0.05)
    guard = ag.frustum(_ROSETTE, _ROSETTE - 0.007, 0.0155, axis=(0.0, -side, 0.0), bevel=0.0012)
    face = thickness / 2 + 0.015
    collar = ag.extrude(ag.ring(0.0155, 0.0105), 0.0014, axis=ag.Y, bevel=0.0005)
    return ag.weld(
        ag.part(rosette, "rose", casting(finish)),
        ag.part(guard.at(0.0, -side * (face - 0.00775), 0.0), "cylinder", finish),
        ag.detail(collar.at(0.0, -side * (face + 0.0002), 0.0), "cylinder", finish),
        *plug(face=face, side=-side, finish=finish, radius=0.0078),
    )


def turn_button(
    *, face: ag.Scalar, depth: ag.Scalar, finish: ag.Material, side: int = -1, below: ag.Scalar = 0.0
) -> ag.Body:
    """Make the small turning knob of a privacy lock: the link `lock`."""
    disc = ag.cylinder(0.0055, 0.003, axis=ag.Y, bevel=0.0008).at(0.0, side * (face + _GAP + 0.0015), -below)
    wing = ag.box(0.0032, 0.007, 0.0105, bevel=0.0012).at(0.0, side * (face + _GAP + 0.0050), -below)
    inner, outer = face - depth + 0.0015, face + 0.002
    stem = ag.cylinder_between((0.0, side * inner, -below), (0.0, side * outer, -below), PIN)
    hold = (
        _hold_from_below(face, side, below)
        if below
        else ag.grasp_on(wing, approach=(0.0, -side, 0.0), closing=ag.X, depth=0.005)
    )
    return ag.part(ag.union(disc, wing, stem), "lock", finish, grasp=hold)


def _hold_from_below(face: ag.Scalar, side: int, below: ag.Scalar) -> ag.Frame:
    """Make the frame at which a hand holds a turn button under a lever: it comes from below."""
    out, up = math.cos(_FROM_BELOW), math.sin(_FROM_BELOW)
    half, tip = GRIPPER.wide / 2.0, GRIPPER.tip
    # the nearest corner of the tips comes 0.5 mm over the disc, 4.5 mm below its middle
    away = face + 0.0040 + tip * out + half * up
    drop = -below - 0.0045 - tip * up + half * out
    return ag.frame((0.0, side * away, drop), approach=(0.0, -side * out, up), closing=ag.X)


def push_button(
    *, face: ag.Scalar, depth: ag.Scalar, finish: ag.Material, side: int = -1, below: ag.Scalar = 0.0
) -> ag.Body:
    """Make the pin of a privacy lock that is pressed in: the link `lock`."""
    inner, outer = face - depth + PIN_TRAVEL + 0.0015, face + PIN_TRAVEL + 0.0015
    pin = ag.cylinder_between((0.0, side * inner, -below), (0.0, side * outer, -below), PIN, bevel=0.0008)
    # a finger presses the lower half of the pin, away from the neck of a lever above it
    press = ag.push_on(pin, direction=(0.0, -side, 0.0), at=(0.0, side * outer, -below - 0.002))
    return ag.part(pin, "lock", finish, push=press)


def button_turn(name: str = "lock_turn", *, pivot: ag.VectorLike = (0.0, 0.0, 0.0)) -> ag.Joint:
    """Make the joint of a privacy knob, which friction holds to either side."""
    return ag.Revolute(
        name, axis=ag.Y, pivot=pivot, limits=(-0.8, 0.8), friction=0.03, damping=0.002, armature=0.00002
    )


def button_push(name: str = "lock_push", *, side: int = -1) -> ag.Joint:
    """Make the joint of a privacy pin; positive presses it in, where friction holds it."""
    return ag.Prismatic(
        name, axis=(0.0, -side, 0.0), limits=(0.0, PIN_TRAVEL), friction=1.5, damping=2.0, armature=0.01
    )


def with_button(
    body: ag.Body,
    style: Literal["turn", "push"],
    *,
    face: ag.Scalar,
    depth: ag.Scalar,
    finish: ag.Material,
    side: int = -1,
    below: ag.Scalar = 0.0,
) -> ag.Body:
    """Attach the knob or the pin of a privacy lock to a body that has the hole for it."""
    make = turn_button if style == "turn" else push_button
    button = make(face=face, depth=depth, finish=finish, side=side, below=below)
    joint = button_turn(pivot=(0.0, 0.0, -below)) if style == "turn" else button_push(side=side)
    return body.attach(button, joint)
