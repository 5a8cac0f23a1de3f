"""Roses, plates and lock cylinders around the hole of a spindle.

A rose hides a square hole for a square spindle; the neck of the handle is in front of the rose and covers the
rest of the hole.
"""

import math
from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.shared.finish import casting, recess
from artgen.categories.shared.hardware.fixings import Drive, Way, screws

_PLUG = 0.0066  # radius of the plug of a euro-profile cylinder [m]
_OUT = 0.0018  # height of that cylinder above its plate [m]


def plug(
    *, face: ag.Scalar, side: int, finish: ag.Material, radius: ag.Scalar, below: ag.Scalar = 0.0
) -> list[ag.Body]:
    """Make the plug of a cylinder with its keyway, 0.7 mm high."""
    upright = ag.slot(0.0080, 0.0017).rotate(math.pi / 2.0)
    keyway = upright | ag.rectangle(0.0026, 0.0014).at(0.0004, 0.0012)  # a ward of the key
    disc = ag.extrude(ag.circle(radius) - keyway, 0.0012, axis=ag.Y)
    dark = ag.box(0.0034, 0.0004, 0.0084)
    groove = ag.extrude(ag.ring(radius + 0.0005, radius - 0.0004), 0.0003, axis=ag.Y)
    return [
        ag.detail(disc.at(0.0, side * (face + 0.0001), -below), "cylinder", finish),
        ag.detail(
            (dark.at(0.0, side * (face - 0.0001), 0.0) | groove.at(0.0, side * face, 0.0)).at(
                0.0, 0.0, -below
            ),
            "cylinder",
            recess(finish),
        ),
    ]


def key_cylinder(*, face: ag.Scalar, side: int, finish: ag.Material, below: ag.Scalar) -> list[ag.Body]:
    """Make the visual-only end of a euro-profile cylinder in a plate."""
    profile = ag.circle(0.0085) | ag.rectangle(0.0100, 0.0245, radius=0.0045).at(0.0, -0.01225)
    body = ag.extrude(profile, 2.0 * _OUT, axis=ag.Y, bevel=0.0006)
    return [
        ag.detail(body.at(0.0, side * face, -below), "cylinder", finish),
        *plug(face=face + _OUT, side=side, finish=finish, radius=_PLUG, below=below),
    ]


Faces = Literal["both", "front", "back"]
"""The faces of a leaf that carry a part; the front faces -y."""

Fixing = Literal["hidden", "slot", "phillips"]
"""Fixing of a rose: a set screw in its rim, or two screws through its face."""

SIDES: dict[str, tuple[int, ...]] = {"both": (-1, 1), "front": (-1,), "back": (1,)}
"""Signs of y of the faces in `Faces`."""

SPINDLE = 0.0045
"""Radius of a spindle: a square spindle of 8 mm, with its edges rounded [m]."""

NECK_GAP = 0.0005
"""Gap between a rose and the neck of a handle [m]."""

PIN_BELOW = 0.0215
"""Distance of a privacy pin below the spindle, at the rose [m]."""

PIN = 0.0034
"""Radius of a privacy pin [m]."""

_KEY_BELOW = 0.060  # distance of a key cylinder below the spindle [m]
_HOLE = 0.0105  # side of the hole [m]
_SUNK = 0.0005  # depth of a rose in the leaf [m]


def spindle_hole(thickness: ag.Scalar, *, height: ag.Scalar = _HOLE) -> ag.Solid:
    """Make the cutter for the hole of a spindle through a leaf (4 mm past each face)."""
    return ag.box(_HOLE, thickness + 0.008, height)


def rose(
    *,
    thickness: ag.Scalar,
    depth: ag.Scalar,
    across: ag.Scalar,
    finish: ag.Material,
    style: Literal["round", "square", "plate"] = "round",
    height: ag.Scalar = 0.2,
    faces: Faces = "both",
    pin: bool = False,
    pin_side: int = -1,
    fixing: Fixing = "hidden",
    keyed: bool = False,
) -> ag.Body:
    """Make the roses of a handle on the faces of a leaf, which are welded to it."""
    if faces == "both" and not pin:
        front = ag.weld(
            *_one_rose(thickness, depth, across, finish, style, height, -1, fixing, pin=False, keyed=keyed)
        )
        return ag.weld(front, front.rotate(ag.Z, math.pi))
    bodies: list[ag.Body] = []
    for side in SIDES[faces]:
        bodies += _one_rose(
            thickness,
            depth,
            across,
            finish,
            style,
            height,
            side,
            fixing,
            pin=pin and side == pin_side,
            keyed=keyed,
        )
    return ag.weld(*bodies)


def _one_rose(
    thickness: ag.Scalar,
    depth: ag.Scalar,
    across: ag.Scalar,
    finish: ag.Material,
    style: str,
    height: ag.Scalar,
    side: int,
    fixing: Fixing,
    *,
    pin: bool,
    keyed: bool,
) -> list[ag.Body]:
    middle = side * (thickness / 2 + (depth - _SUNK) / 2)
    face = side * (thickness / 2 + depth)
    deep = depth + _SUNK
    if style == "round":
        cover = ag.cylinder(across / 2, deep, axis=ag.Y, bevel=0.0022)
    elif style == "square":
        cover = ag.box(across, deep, across, bevel=0.0022)
    else:
        cover = ag.extrude(ag.rectangle(across, height, radius=0.006), deep, axis=ag.Y, bevel=0.0015)
    cover = cover.at(0.0, middle, 0.0) - ag.box(_HOLE, deep + 0.004, _HOLE).at(0.0, middle, 0.0)
    if pin:
        cover = cover - ag.bore(PIN + 0.0004, deep + 0.004, axis=ag.Y).at(0.0, middle, -PIN_BELOW)
    bodies = [ag.part(cover, "rose", casting(finish))]
    facing: Way = "-y" if side < 0 else "+y"
    drive: Drive = "phillips" if fixing == "phillips" else "slot"
    if style == "plate":
        places = [(0.0, face, end * (height / 2 - 0.0125)) for end in (-1, 1)]
        bodies += screws(places, facing=facing, radius=0.0042, finish=finish, drive=drive)
        if keyed:
            below = _KEY_BELOW
            bodies += key_cylinder(face=thickness / 2 + depth, side=side, finish=finish, below=below)
        return bodies
    if fixing == "hidden":
        # the set screw is in the rim, hidden from the front
        socket = ag.extrude(ag.circle(0.0021) - details.drive_recess(0.00125, "hex"), 0.0008).at(
            0.0, middle, -across / 2
        )
        dark = ag.cylinder(0.0019, 0.0008).at(0.0, middle, -across / 2 + 0.0003)
        return [*bodies, ag.detail(socket, "screw", finish), ag.detail(dark, "screw", recess(finish))]
    aside = across / 2 - 0.0056  # outside the collar of a knob
    # beside the hole of a pin, or above and below the spindle
    spots = [(end * aside, face, 0.0) if pin else (0.0, face, end * aside) for end in (-1, 1)]
    return bodies + screws(spots, facing=facing, radius=0.0028, finish=finish, drive=drive, head="pan")


def spindle(thickness: ag.Scalar, rose_depth: ag.Scalar, faces: Faces = "both") -> ag.Solid:
    """Make the spindle that joins the handles on both faces, or ends in the middle of the leaf."""
    reach = thickness / 2 + rose_depth + 0.006  # 6 mm into the neck of the handle
    if faces == "both":
        return ag.cylinder(SPINDLE, 2 * reach, axis=ag.Y)
    side = SIDES[faces][0]
    # a one-sided spindle ends behind the follower of the lock, 5 mm past the middle
    return ag.cylinder(SPINDLE, reach + 0.005, axis=ag.Y).at(0.0, side * (reach - 0.005) / 2, 0.0)
