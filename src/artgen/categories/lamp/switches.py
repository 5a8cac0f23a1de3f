"""Switches of lamps: buttons, rockers and dimmers, set into a face that looks up or the case on a cord.

A switch is drawn about the origin in the face z = 0: what is seen around it, with the link that moves.
"""

import math
from dataclasses import dataclass
from typing import Literal

from artgen import (
    Body,
    Material,
    Revolute,
    Solid,
    X,
    Y,
    Z,
    box,
    circle,
    cylinder,
    detail,
    details,
    extrude,
    frame,
    part,
    polygon,
    rectangle,
    weld,
)
from artgen.categories.shared.controls.buttons import button_hole, button_press, push_button
from artgen.categories.shared.controls.dials import DialStyle, dial

SwitchKind = Literal["button", "rocker", "dial"]
"""What a finger presses or turns."""

SWITCH_LABELS = ("switch", "button", "rocker", "dial", "pull_chain", "cord", "print")
"""Labels of switches, of what they are on and of their print."""

ROCK = 0.25
"""How far a rocker tilts either way [rad]."""

_UP = -math.pi / 2.0  # turns what faces -y upward, about X
_BUTTON = 0.017  # across a button [m]
_ROCKER = (0.012, 0.021)  # width and length of a rocker [m]
_PLAY = 0.0006  # around it [m]


@dataclass(frozen=True)
class Switch:
    """A switch in a face that looks up."""

    body: Body  # what is seen around it, with the link that moves; to be welded to what has the face
    hole: Solid | None  # what has to be cut out of the face; None where nothing has to
    half: float  # how far it reaches from its middle to the front and to the back [m]


def switch(kind: SwitchKind, *, finish: Material, ink: Material, dial_style: DialStyle = "fluted") -> Switch:
    """Make a switch: the link `button`, `rocker` or `dial` with its joint."""
    match kind:
        case "button":
            return _button(finish, ink)
        case "rocker":
            return _rocker(finish, ink)
        case "dial":
            return _dial(finish, ink, dial_style)


def _button(finish: Material, ink: Material) -> Switch:
    cap = push_button(finish=finish, width=_BUTTON, proud=0.0042, deep=0.006, icon="power", ink=ink)
    half = _BUTTON / 2 + 0.0045
    sheet = circle(half) - circle(_BUTTON / 2 + 0.0004)
    ring = extrude(sheet, 0.0014, axis=Y, bevel=0.0004).at(0.0, -0.0002, 0.0)
    press = button_press("switch_slide", travel=0.003, preload=1.0, force=4.0)  # keys of lamps close at 4 N
    return Switch(
        detail(ring, "switch", finish).attach(cap, press).rotate(X, _UP),
        button_hole(_BUTTON, through=0.0105).rotate(X, _UP),
        half,
    )


def _rocker(finish: Material, ink: Material) -> Switch:
    wide, long = _ROCKER
    half, edge, middle = long / 2.0, 0.0054, 0.0038
    # from the side it is a flat V; the pivot lies in the face
    side = polygon([(-half, -0.0015), (half, -0.0015), (half, edge), (0.0, middle), (-half, edge)])
    share = 0.85  # of the way to its end, where fingers press
    pushes = [
        frame(
            (0.0, end * share * half, middle + share * (edge - middle)), approach=(0.0, 0.0, -1.0), closing=X
        )
        for end in (-1, 1)
    ]
    belly = cylinder(0.0040, 0.7 * wide, axis=X).at(0.0, 0.0, -0.0015)
    rocker = weld(
        part(extrude(side, wide, axis=X, bevel=0.0005), "rocker", finish, push=pushes),
        part(belly, "rocker", finish),
        *(
            details.printed(sign, (0.0, end * 0.0055, middle + 0.0009), material=ink, facing=Z)
            for end, sign in ((1, circle(0.0016) - circle(0.0011)), (-1, rectangle(0.0006, 0.0034)))
        ),
    )
    tilt = Revolute(
        "switch_rock",
        axis=X,
        limits=(-ROCK, ROCK),
        friction=0.02,  # the contact spring snaps over the middle: about 2.5 N at the end
        damping=0.002,
        armature=0.00001,
        effort=0.15,
    )
    opening = (wide + 2 * _PLAY, long + 2 * _PLAY)
    sheet = rectangle(wide + 0.007, long + 0.007, radius=0.002) - rectangle(*opening)
    bezel = extrude(sheet, 0.0016, bevel=0.0004).at(0.0, 0.0, 0.0002)
    hole = box(*opening, 0.020).at(0.0, 0.0, 0.0015)
    return Switch(detail(bezel, "switch", finish).attach(rocker, tilt), hole, (long + 0.007) / 2.0)


def _dial(finish: Material, ink: Material, style: DialStyle) -> Switch:
    knob = dial(finish=finish, style=style, radius=0.014, depth=0.017, mark=ink, name="dial", label="dial")
    turn = Revolute(
        "switch_turn",
        axis=Y,
        friction=0.03,  # a dimmer without stops; its wiper is felt
        damping=0.002,
        armature=0.00002,
        effort=0.5,
    )
    half = 0.0165
    plate = cylinder(half, 0.0010, axis=Y).at(0.0, 0.0003, 0.0)
    return Switch(detail(plate, "switch", finish).attach(knob, turn).rotate(X, _UP), None, half)
