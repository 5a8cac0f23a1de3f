"""Switches of lamps, and the cord."""

import math
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.shared.appliances import CORD, strain_relief
from artgen.categories.shared.controls import DialStyle, button_cap, button_hole, button_press, control_knob

SwitchKind = Literal["button", "rocker", "dial"]
"""Kind of switch that a finger presses or turns."""

ROCK = 0.25
"""Tilt of a rocker to each side [rad]."""

_UP = -math.pi / 2.0  # rotation about x that turns the face at -y upward [rad]
_BUTTON = 0.017  # width of a button [m]
_ROCKER = (0.012, 0.021)  # width and length of a rocker [m]
_PLAY = 0.0006  # gap around a rocker [m]


@dataclass(frozen=True)
class Switch:
    """A switch in an upward-facing face."""

    body: ag.Body  # visible surround with the moving link, which is welded to the body with the face
    hole: ag.Solid | None  # cutter of the face, or None
    half: float  # distance from its middle to its front and back edges [m]


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
    cap = button_cap(finish=finish, width=_BUTTON, proud=0.0042, deep=0.006, icon="power", ink=ink)
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
    # seen from the side it is a flat V; the pivot is in the face
    side = ag.polygon([(-half, -0.0015), (half, -0.0015), (half, edge), (0.0, middle), (-half, edge)])
    share = 0.85  # position of the finger, as a share of the distance to the end
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
    knob = control_knob(
        finish=finish, style=style, radius=0.014, depth=0.017, mark=ink, name="dial", label="dial"
    )
    turn = ag.Revolute(
        "switch_turn",
        axis=ag.Y,
        friction=0.03,  # friction of the wiper of a dimmer without stops
        damping=0.002,
        armature=0.00002,
        effort=0.5,
    )
    half = 0.0165
    plate = ag.cylinder(half, 0.0010, axis=ag.Y).at(0.0, 0.0003, 0.0)
    return Switch(ag.detail(plate, "switch", finish).attach(knob, turn).rotate(ag.X, _UP), None, half)


CASE = (0.034, 0.080, 0.024)
"""Width, length and height of a case on the cord [m]."""

_TAIL = 0.21  # length of the cord behind its switch [m]
_ALONE = 0.15  # additional length of a cord without a switch [m]


@dataclass(frozen=True)
class Cord:
    """Layout of a cord."""

    finish: ag.Material  # material of cord and case
    start: ag.Scalar  # position of the outlet of the base along y [m]
    end: ag.Scalar  # position of the switch along y [m]
    height: ag.Scalar  # height of the outlet [m]
    # straight length at the outlet; from high up the cord bends down in a wider arc [m]
    stiff: ag.Scalar = 0.022

    def alone(self) -> ag.Body:
        """Make the cord without a switch."""
        return cord_run(
            self.start, self.end + _ALONE, height=self.height, finish=self.finish, sway=0.04, stiff=self.stiff
        )

    def with_case(self, switched: Switch) -> ag.Body:
        """Make the cord with a switch in a case."""
        half = CASE[1] / 2.0
        near, far = self.end - half + 0.002, self.end + half
        return ag.weld(
            cord_case(switched, self.finish).at(0.0, self.end, 0.0),
            cord_run(self.start, near, height=self.height, finish=self.finish, stiff=self.stiff),
            cord_run(far, far + _TAIL, height=0.010, finish=self.finish, sway=0.03),
        )


def cord_case(switched: Switch, finish: ag.Material) -> ag.Body:
    """Make the case of a switch on a cord: it lies on the floor about the origin, the cord is along y."""
    wide, long, high = CASE
    block = ag.box(wide, long, high - 0.001, bevel=0.005).at(0.0, 0.0, (high + 0.001) / 2.0)
    if switched.hole is not None:
        block = block - switched.hole.at(0.0, 0.0, high)
    seam = ag.box(wide - 0.004, long - 0.004, 0.0012)
    foot = ag.box(wide - 0.010, long - 0.012, 0.002, bevel=0.0006).at(0.0, 0.0, 0.001)
    joined = "its cord, which is only seen, joins it to the base"
    return ag.weld(
        ag.part(block, "switch", finish, separate=joined),
        ag.part(foot, "switch", finish),
        ag.detail(seam.at(0.0, 0.0, 0.009), "switch", finish),
        switched.body.at(0.0, 0.0, high),
    )


def cord_run(
    start: ag.Scalar,
    end: ag.Scalar,
    *,
    height: ag.Scalar,
    finish: ag.Material,
    sway: ag.Scalar = 0.0,
    stiff: ag.Scalar = 0.022,
) -> ag.Body:
    """Make a cord from the back of a base, at y = start, that lies on the floor up to y = end."""
    run = end - start
    path = ag.bezier(  # the path stays above the floor, as its control points do
        [
            (0.0, start - 0.004, height),
            (0.0, start + stiff, height - 0.001),
            (1.2 * sway, start + 0.022 + 0.30 * (run - 0.022), CORD),
            (3.0 * sway, start + 0.022 + 0.50 * (run - 0.022), CORD),
            (-3.0 * sway, start + 0.022 + 0.75 * (run - 0.022), CORD),
            (0.0, end, CORD),
        ]
    )
    return ag.weld(
        *(ag.detail(each.at(0.0, start, height), "cord", finish) for each in strain_relief()),
        ag.detail(ag.sweep(ag.circle(CORD - 0.0002), path), "cord", finish),
    )
