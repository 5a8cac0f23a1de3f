"""Switches of lamps: buttons, rockers and dimmers, set into a face that looks up or the case on a cord.

A switch is drawn about the origin in the face z = 0: what is seen around it, with the link that moves.
"""

import math
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details
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

    body: ag.Body  # what is seen around it, with the link that moves; to be welded to what has the face
    hole: ag.Solid | None  # what has to be cut out of the face; None where nothing has to
    half: float  # how far it reaches from its middle to the front and to the back [m]


def switch(
    kind: SwitchKind, *, finish: ag.Material, ink: ag.Material, dial_style: DialStyle = "fluted"
) -> Switch:
    """Make a switch: the link `button`, `rocker` or `dial` with its joint."""
    match kind:
        case "button":
            return _button(finish, ink)
        case "rocker":
            return _rocker(finish, ink)
        case "dial":
            return _dial(finish, ink, dial_style)


def _button(finish: ag.Material, ink: ag.Material) -> Switch:
    cap = push_button(finish=finish, width=_BUTTON, proud=0.0042, deep=0.006, icon="power", ink=ink)
    half = _BUTTON / 2 + 0.0045
    sheet = ag.circle(half) - ag.circle(_BUTTON / 2 + 0.0004)
    ring = ag.extrude(sheet, 0.0014, axis=ag.Y, bevel=0.0004).at(0.0, -0.0002, 0.0)
    press = button_press("switch_slide", travel=0.003, preload=1.0, force=4.0)  # keys of lamps close at 4 N
    return Switch(
        ag.detail(ring, "switch", finish).attach(cap, press).rotate(ag.X, _UP),
        button_hole(_BUTTON, through=0.0105).rotate(ag.X, _UP),
        half,
    )


def _rocker(finish: ag.Material, ink: ag.Material) -> Switch:
    wide, long = _ROCKER
    half, edge, middle = long / 2.0, 0.0054, 0.0038
    # from the side it is a flat V; the pivot lies in the face
    side = ag.polygon([(-half, -0.0015), (half, -0.0015), (half, edge), (0.0, middle), (-half, edge)])
    share = 0.85  # of the way to its end, where fingers press
    pushes = [
        ag.frame(
            (0.0, end * share * half, middle + share * (edge - middle)),
            approach=(0.0, 0.0, -1.0),
            closing=ag.X,
        )
        for end in (-1, 1)
    ]
    belly = ag.cylinder(0.0040, 0.7 * wide, axis=ag.X).at(0.0, 0.0, -0.0015)
    rocker = ag.weld(
        ag.part(ag.extrude(side, wide, axis=ag.X, bevel=0.0005), "rocker", finish, push=pushes),
        ag.part(belly, "rocker", finish),
        *(
            details.printed(sign, (0.0, end * 0.0055, middle + 0.0009), material=ink, facing=ag.Z)
            for end, sign in ((1, ag.circle(0.0016) - ag.circle(0.0011)), (-1, ag.rectangle(0.0006, 0.0034)))
        ),
    )
    tilt = ag.Revolute(
        "switch_rock",
        axis=ag.X,
        limits=(-ROCK, ROCK),
        friction=0.02,  # the contact spring snaps over the middle: about 2.5 N at the end
        damping=0.002,
        armature=0.00001,
        effort=0.15,
    )
    opening = (wide + 2 * _PLAY, long + 2 * _PLAY)
    sheet = ag.rectangle(wide + 0.007, long + 0.007, radius=0.002) - ag.rectangle(*opening)
    bezel = ag.extrude(sheet, 0.0016, bevel=0.0004).at(0.0, 0.0, 0.0002)
    hole = ag.box(*opening, 0.020).at(0.0, 0.0, 0.0015)
    return Switch(ag.detail(bezel, "switch", finish).attach(rocker, tilt), hole, (long + 0.007) / 2.0)


def _dial(finish: ag.Material, ink: ag.Material, style: DialStyle) -> Switch:
    knob = dial(finish=finish, style=style, radius=0.014, depth=0.017, mark=ink, name="dial", label="dial")
    turn = ag.Revolute(
        "switch_turn",
        axis=ag.Y,
        friction=0.03,  # a dimmer without stops; its wiper is felt
        damping=0.002,
        armature=0.00002,
        effort=0.5,
    )
    half = 0.0165
    plate = ag.cylinder(half, 0.0010, axis=ag.Y).at(0.0, 0.0003, 0.0)
    return Switch(ag.detail(plate, "switch", finish).attach(knob, turn).rotate(ag.X, _UP), None, half)
