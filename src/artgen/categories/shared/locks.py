"""Locks of doors: roses and plates around a spindle, lock cylinders, latches, deadbolts, privacy locks.

Door hardware is modeled about its own axis on a leaf in the x-z plane: the origin is on the spindle (or on
the axis of a lock) in the middle of the leaf's thickness, the faces of the leaf are at y = -thickness / 2 and
y = thickness / 2, and the lock edge is at x = backset. Levers therefore point to -x. A rose hides a square
hole for a square spindle; the neck of the handle is in front of the rose and covers the rest of the hole.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details
from artgen.asset.affordance import GRIPPER
from artgen.categories.shared.finish import casting, recess
from artgen.categories.shared.fixings import Drive, Way, screws
from artgen.feel import Feel


def plug(
    *, face: ag.Scalar, side: int, finish: ag.Material, radius: ag.Scalar, below: ag.Scalar = 0.0
) -> list[ag.Body]:
    """Make the plug of a cylinder with its keyway, 0.7 mm high."""
    upright = ag.slot(0.0080, 0.0017).rotate(math.pi / 2.0)
    keyway = upright | ag.rectangle(0.0026, 0.0014).at(0.0004, 0.0012)  # a ward of the key
    disc = ag.extrude(ag.circle(radius) - keyway, 0.0012, axis=ag.Y).at(0.0, side * (face + 0.0001), -below)
    dark = ag.box(0.0034, 0.0004, 0.0084).at(0.0, side * (face - 0.0001), -below)
    groove = ag.extrude(ag.ring(radius + 0.0005, radius - 0.0004), 0.0003, axis=ag.Y)
    slit = dark | groove.at(0.0, side * face, -below)
    return [ag.detail(disc, "cylinder", finish), ag.detail(slit, "cylinder", recess(finish))]


def _key_cylinder(face: ag.Scalar, side: int, finish: ag.Material) -> list[ag.Body]:
    """Make the visual-only end of a euro-profile cylinder in a plate, 60 mm below the spindle."""
    below, out = 0.060, 0.0018  # the cylinder is 1.8 mm above its plate
    profile = ag.circle(0.0085) | ag.rectangle(0.0100, 0.0245, radius=0.0045).at(0.0, -0.01225)
    body = ag.extrude(profile, 2 * out, axis=ag.Y, bevel=0.0006).at(0.0, side * face, -below)
    core = plug(face=face + out, side=side, finish=finish, radius=0.0066, below=below)
    return [ag.detail(body, "cylinder", finish), *core]


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

    def one(side: int, *, pinned: bool) -> ag.Body:
        middle, face = side * (thickness / 2 + (depth - _SUNK) / 2), side * (thickness / 2 + depth)
        deep = depth + _SUNK
        if style == "round":
            cover = ag.cylinder(across / 2, deep, axis=ag.Y, bevel=0.0022)
        elif style == "square":
            cover = ag.box(across, deep, across, bevel=0.0022)
        else:
            cover = ag.extrude(ag.rectangle(across, height, radius=0.006), deep, axis=ag.Y, bevel=0.0015)
        cover = cover.at(y=middle) - ag.box(_HOLE, deep + 0.004, _HOLE).at(y=middle)
        if pinned:
            cover = cover - ag.bore(PIN + 0.0004, deep + 0.004, axis=ag.Y).at(0.0, middle, -PIN_BELOW)
        facing: Way = "-y" if side < 0 else "+y"
        drive: Drive = "phillips" if fixing == "phillips" else "slot"
        bodies = [ag.part(cover, "rose", casting(finish))]
        if style == "plate":
            places = [(0.0, face, end * (height / 2 - 0.0125)) for end in (-1, 1)]
            bodies += screws(places, facing=facing, radius=0.0042, finish=finish, drive=drive)
            if keyed:
                bodies += _key_cylinder(thickness / 2 + depth, side, finish)
        elif fixing == "hidden":  # the set screw is in the rim, hidden from the front
            socket = ag.extrude(ag.circle(0.0021) - details.drive_recess(0.00125, "hex"), 0.0008)
            dark = ag.cylinder(0.0019, 0.0008).at(0.0, middle, -across / 2 + 0.0003)
            bodies.append(ag.detail(socket.at(0.0, middle, -across / 2), "screw", finish))
            bodies.append(ag.detail(dark, "screw", recess(finish)))
        else:
            aside = across / 2 - 0.0056  # outside the collar of a knob
            # beside the hole of a pin, or above and below the spindle
            spots = [(end * aside, face, 0.0) if pinned else (0.0, face, end * aside) for end in (-1, 1)]
            bodies += screws(spots, facing=facing, radius=0.0028, finish=finish, drive=drive, head="pan")
        return ag.weld(*bodies)

    if faces == "both" and not pin:
        front = one(-1, pinned=False)
        return ag.weld(front, front.rotate(ag.Z, math.pi))
    return ag.weld(*(one(side, pinned=pin and side == pin_side) for side in SIDES[faces]))


def spindle(thickness: ag.Scalar, rose_depth: ag.Scalar, faces: Faces = "both") -> ag.Solid:
    """Make the spindle that joins the handles on both faces, or ends in the middle of the leaf."""
    reach = thickness / 2 + rose_depth + 0.006  # 6 mm into the neck of the handle
    if faces == "both":
        return ag.cylinder(SPINDLE, 2 * reach, axis=ag.Y)
    side = SIDES[faces][0]
    # a one-sided spindle ends behind the follower of the lock, 5 mm past the middle
    return ag.cylinder(SPINDLE, reach + 0.005, axis=ag.Y).at(0.0, side * (reach - 0.005) / 2, 0.0)


PLAY = 0.0004
"""Clearance around a sliding bolt [m]."""


BoltName = Literal["latch", "deadbolt"]


@dataclass(frozen=True)
class Bolt:
    """The section of a bolt."""

    width: float  # width across the leaf, along y [m]
    height: float  # height along z [m]


LATCH = Bolt(0.012, 0.018)
DEADBOLT = Bolt(0.0145, 0.025)

LATCH_HOLE = LATCH.height + 2 * PLAY
"""Height of the hole of a spindle that meets the pocket of a latch [m]."""

_TAIL = 0.022  # length of the bolt in the leaf behind the throw [m]
_OVERTRAVEL = 1.6  # depth of the pocket in throws, because a handle turns further than the latch needs
_OPENING_PLAY = 0.0007  # play of a closed door [m]
_EASY = 0.002  # play of the strike on sides that hold nothing [m]
_SKIN = 0.0008  # visible thickness of a strike [m]
_SCREW = 0.0036  # radius of the heads of screws [m]
_PROUD = 0.0003  # height of plates above the wood, so that they are visible [m]


def latch_bolt(
    *,
    backset: ag.Scalar,
    throw: ag.Scalar,
    finish: ag.Material,
    push: Sequence[ag.Frame] = (),
    name: str = "latch",
) -> ag.Body:
    """Make a sprung bolt: flat towards -y, to hold the door, slanted towards +y, for closing."""
    half = LATCH.width / 2
    tail, nose = backset - _TAIL, backset + throw  # the nose is blunt
    section = ag.polygon(
        [(tail, -half), (nose, -half), (nose, -half + 0.003), (backset + 0.0015, half), (tail, half)]
    )
    bolt = ag.extrude(section, LATCH.height, axis=ag.Z, bevel=0.0006)
    return ag.part(bolt, "latch", finish, push=push, name=name)


def latch_slide(leader: ag.Joint, *, throw: ag.Scalar, release: ag.Scalar) -> ag.Joint:
    """Make the joint of a latch bolt that a handle draws into the leaf; positive is drawn back."""
    drawn = (throw / release) * leader
    return ag.Prismatic("latch_slide", axis=-ag.X, follows=drawn, damping=2.0, friction=0.2)


def latch_pocket(*, backset: ag.Scalar, throw: ag.Scalar, through: bool = False) -> ag.Solid:
    """Make the cutter for the bolt's pocket in the lock edge of the leaf."""
    deep = backset if through else _TAIL + _OVERTRAVEL * throw + 0.005
    return _slot(LATCH, deep + 0.005, backset + 0.005)  # 5 mm past the edge, through the faceplate


def _slot(bolt: Bolt, length: ag.Scalar, end: ag.Scalar) -> ag.Solid:
    """Make a box around a bolt with play, which ends at x = end."""
    return ag.box(length, bolt.width + 2 * PLAY, bolt.height + 2 * PLAY).align((end, 0.0, 0.0), x=1.0)


def faceplate(
    *, backset: ag.Scalar, finish: ag.Material, bolt: BoltName = "latch", mark: str = ""
) -> ag.Body:
    """Make the faceplate on the lock edge with its hole and screws: 23 by 57 mm, as is common."""
    section = LATCH if bolt == "latch" else DEADBOLT
    width, height, thick = 0.0235, 0.057, 0.0024
    face, level = backset + _PROUD, section.height / 2 + 0.0095
    outline = ag.rectangle(width, height, radius=0.0045)
    # 0.1 mm inside the walls of the pocket, so that no two faces coincide
    outline = outline - ag.rectangle(section.width + 1.5 * PLAY, section.height + 1.5 * PLAY)
    bodies = [
        ag.detail(_pierced(outline, level, thick).at(face - thick / 2, 0.0, 0.0), "faceplate", finish),
        *_plate_screws(face, "+x", level, finish),
    ]
    if mark:
        name = details.lettering([mark.upper()], 0.0016, tracking=0.12, fineness="coarse")
        at = (face, 0.0, -height / 2 + 0.0026)
        bodies.append(details.engraved(name, at, facing=ag.X, label="faceplate", material=finish))
    return ag.weld(*bodies)


def _pierced(outline: ag.Profile, level: ag.Scalar, thick: ag.Scalar) -> ag.Solid:
    """Make a plate that faces x, with holes for screws above and below its middle."""
    hole = ag.circle(_SCREW + 0.0003)
    return ag.extrude(outline - hole.at(0.0, level) - hole.at(0.0, -level), thick, axis=ag.X)


def _plate_screws(x: ag.Scalar, facing: Way, height: ag.Scalar, finish: ag.Material) -> list[ag.Body]:
    """Make countersunk heads above and below a bolt on a plate at x."""
    return screws(
        [(x, 0.0, -height), (x, 0.0, height)], facing=facing, radius=_SCREW, finish=finish, sunk=0.0005
    )


def strike_pocket(*, backset: ag.Scalar, gap: ag.Scalar, throw: ag.Scalar, bolt: Bolt = LATCH) -> ag.Solid:
    """Make the cutter for the hole of a thrown bolt in the jamb."""
    front = backset + gap - 0.002
    back = backset + throw + 0.004
    low, high = -bolt.width / 2 - _OPENING_PLAY, bolt.width / 2 + _EASY
    solid = ag.box(back - front, high - low, bolt.height + 2 * _EASY)
    return solid.align((front, low, 0.0), x=-1.0, y=-1.0)


def strike_plate(
    *,
    backset: ag.Scalar,
    gap: ag.Scalar,
    throw: ag.Scalar,
    thickness: ag.Scalar,
    finish: ag.Material,
    bolt: BoltName = "latch",
) -> ag.Body:
    """Make the plate on the jamb for a bolt, which is welded to a jamb cut with `strike_pocket`."""
    section = LATCH if bolt == "latch" else DEADBOLT
    face = backset + gap - _PROUD
    low, high = -thickness / 2 + 0.0005, section.width / 2 + 0.008
    hole = strike_pocket(backset=backset, gap=gap, throw=throw, bolt=section)
    # the collider lies behind the visible plate, which has the holes of the screws
    plate = ag.box(0.0018 - _SKIN, high - low, 0.060).align((face + _SKIN, low, 0.0), x=-1.0, y=-1.0)
    wide = section.width + _OPENING_PLAY + _EASY
    opening = ag.rectangle(wide, section.height + 2 * _EASY).at((_EASY - _OPENING_PLAY) / 2)
    skin = ag.rectangle(high - low, 0.060, radius=0.0045).at((low + high) / 2)
    level = section.height / 2 + 0.0105
    bodies = [
        ag.part(plate - hole, "strike", finish),
        ag.detail(
            _pierced(skin - opening, level, _SKIN + 0.0003).at(face + (_SKIN + 0.0003) / 2, 0.0, 0.0),
            "strike",
            finish,
        ),
        *_plate_screws(face, "-x", level, finish),
    ]
    if bolt == "latch":
        # the lip guides the latch in and curls around the front of the jamb
        curl = ag.polygon([(0.0, 0.0), (0.0, -0.0006), (0.0020, -0.0029), (0.0030, -0.0024), (0.0012, 0.0)])
        lip = ag.extrude(curl, section.height + 0.012, axis=ag.Z, bevel=0.0003)
        bodies.append(ag.detail(lip.at(face, -thickness / 2 + 0.0006, 0.0), "strike", finish))
    return ag.weld(*bodies)


def clear_angle(*, thickness: ag.Scalar, reach: ag.Scalar) -> ag.Scalar:
    """Return the angle of a door at which its thrown latch has left the strike, with 2 mm to spare [rad]."""
    # small angles: the bolt moves by angle * reach, a little more at its nose
    return (thickness / 2 + LATCH.width / 2 + 0.002) / reach * 1.02


THROW = 0.025
"""Travel of a deadbolt: 1 inch, the least that ANSI/BHMA A156.5 accepts [m]."""

QUARTER = 1.57
"""The range of a thumb turn [rad]."""

PIN_TRAVEL = 0.004
"""Travel of the pin of a privacy lock [m]."""

_BOLT_TAIL = 0.020  # length of the thrown bolt in the leaf [m]
_RECESSED = 0.0005  # distance of the end of a drawn bolt inside the lock edge [m]
_ROSETTE = 0.0275  # radius of the covers [m]
_ROSETTE_DEPTH = 0.009
_FROM_BELOW = 0.9  # angle of approach of a hand to a button under a lever [rad]
_GAP = 0.0005  # gap between a rosette and the turning part on it [m]


def deadbolt(*, backset: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make a deadbolt, drawn back: the link `deadbolt`."""
    length = THROW + _BOLT_TAIL
    bolt = ag.box(length, DEADBOLT.width, DEADBOLT.height, bevel=0.001)
    return ag.part(bolt.align((backset - _RECESSED, 0.0, 0.0), x=1.0), "deadbolt", finish)


def deadbolt_slide(turn: ag.Joint) -> ag.Joint:
    """Make the joint of a deadbolt, which follows its thumb turn; positive is thrown."""
    thrown = (THROW / QUARTER) * turn
    return ag.Prismatic("deadbolt_slide", axis=ag.X, follows=thrown, damping=5.0, friction=0.5)


def deadbolt_pocket(*, backset: ag.Scalar) -> ag.Solid:
    """Make the cutter for the deadbolt's pocket in the lock edge of the leaf."""
    # from 5 mm past the edge to the hole of the spindle, with the same height
    pocket = ag.box(backset + 0.005, DEADBOLT.width + 2 * PLAY, DEADBOLT.height + 2 * PLAY)
    return pocket.align((backset + 0.005, 0.0, 0.0), x=1.0)


def deadbolt_hole(thickness: ag.Scalar) -> ag.Solid:
    """Make the cutter for the hole of a thumb turn's spindle through a leaf."""
    return spindle_hole(thickness, height=DEADBOLT.height + 2 * PLAY)


def thumb_turn_joint(name: str = "lock_turn", *, pivot: ag.VectorLike = (0.0, 0.0, 0.0)) -> ag.Joint:
    """Make the joint of a thumb turn, held by the friction of its detent; positive throws the bolt."""
    feel_ = Feel(friction=0.12, damping=0.02, armature=0.0001)
    return ag.Revolute(name, axis=ag.Y, pivot=pivot, limits=(0.0, QUARTER), feel=feel_)


def thumb_turn(*, thickness: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make a thumb turn on the front, upright while the bolt is drawn: the link `lock`."""
    start = thickness / 2 + _ROSETTE_DEPTH + _GAP
    base = ag.cylinder(0.012, 0.004, axis=ag.Y, bevel=0.0012).at(y=-start - 0.002)
    wing = ag.bounding_collider(ag.box(0.007, 0.018, 0.034, bevel=0.003)).at(y=-start - 0.012)
    reach = start + 0.003  # depth of the spindle in the turn, from the middle of the leaf
    stem = ag.cylinder(SPINDLE, reach, axis=ag.Y).at(y=-reach / 2)
    hold = ag.grasp_on(wing, approach=ag.Y, closing=ag.X, depth=0.016)  # 1 mm off its base
    return ag.part(ag.union(base, wing, stem), "lock", finish, grasp=hold)


def deadbolt_cover(*, thickness: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make the rosette under a thumb turn and, on the back, the key cylinder; weld it to the leaf."""
    deep, face = _ROSETTE_DEPTH + 0.0005, thickness / 2 + 0.015
    rosette = ag.cylinder(_ROSETTE, deep, axis=ag.Y, bevel=0.0022).at(y=(0.001 - thickness - deep) / 2)
    guard = ag.frustum(_ROSETTE, _ROSETTE - 0.007, 0.0155, axis=ag.Y, bevel=0.0012).at(y=face - 0.00775)
    collar = ag.extrude(ag.ring(0.0155, 0.0105), 0.0014, axis=ag.Y, bevel=0.0005).at(y=face + 0.0002)
    return ag.weld(
        ag.part(rosette - spindle_hole(thickness + 0.05), "rose", casting(finish)),
        ag.part(guard, "cylinder", finish),
        ag.detail(collar, "cylinder", finish),
        *plug(face=face, side=1, finish=finish, radius=0.0078),
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
    """Attach the knob or the pin of a privacy lock, the link `lock`, to a body with a hole for it."""
    if style == "turn":
        knob = _turn_button(face, depth, finish, side, below)
        feel_ = Feel(friction=0.03, damping=0.002, armature=0.00002)  # friction holds it at both ends
        turn = ag.Revolute("lock_turn", axis=ag.Y, pivot=(0, 0, -below), limits=(-0.8, 0.8), feel=feel_)
        return body.attach(knob, turn)
    inner, outer = face - depth + PIN_TRAVEL + 0.0015, face + PIN_TRAVEL + 0.0015
    pin = ag.cylinder_between((0.0, side * inner, -below), (0.0, side * outer, -below), PIN, bevel=0.0008)
    # a finger presses the lower half of the pin, away from the neck of a lever above it
    press = ag.push_on(pin, direction=(0.0, -side, 0.0), at=(0.0, side * outer, -below - 0.002))
    feel_ = Feel(friction=1.5, damping=2.0, armature=0.01)
    slide = ag.Prismatic("lock_push", axis=(0.0, -side, 0.0), limits=(0.0, PIN_TRAVEL), feel=feel_)
    return body.attach(ag.part(pin, "lock", finish, push=press), slide)


def _turn_button(
    face: ag.Scalar, depth: ag.Scalar, finish: ag.Material, side: int, below: ag.Scalar
) -> ag.Body:
    """Make the small turning knob of a privacy lock."""
    disc = ag.cylinder(0.0055, 0.003, axis=ag.Y, bevel=0.0008).at(0.0, side * (face + _GAP + 0.0015), -below)
    wing = ag.box(0.0032, 0.007, 0.0105, bevel=0.0012).at(0.0, side * (face + _GAP + 0.0050), -below)
    inner, outer = face - depth + 0.0015, face + 0.002
    stem = ag.cylinder_between((0.0, side * inner, -below), (0.0, side * outer, -below), PIN)
    if below:  # under a lever, the hand comes from below
        out, up = math.cos(_FROM_BELOW), math.sin(_FROM_BELOW)
        half, tip = GRIPPER.wide / 2, GRIPPER.tip
        # the nearest corner of the finger tips is 0.5 mm above the disc, 4.5 mm below its middle
        away, drop = face + 0.0040 + tip * out + half * up, -below - 0.0045 - tip * up + half * out
        hold = ag.frame((0.0, side * away, drop), approach=(0.0, -side * out, up), closing=ag.X)
    else:
        hold = ag.grasp_on(wing, approach=(0.0, -side, 0.0), closing=ag.X, depth=0.005)
    return ag.part(ag.union(disc, wing, stem), "lock", finish, grasp=hold)


def inserted_key(back: ag.Scalar, *, radius: ag.Scalar) -> tuple[list[ag.Solid], ag.Frame]:
    """Make a key in its cylinder, which ends at y = back behind the face y = 0, and the grasp of its bow."""
    barrel = ag.cylinder(radius, back + 0.0010, axis=ag.Y, bevel=0.0004).at(y=(back - 0.0010) / 2)
    blade = ag.box(0.0022, 0.016, 0.0075).at(y=-0.008)
    bow = ag.cylinder(0.0115, 0.0026, axis=ag.X, bevel=0.0008).at(y=-0.024)
    return [bow, blade, barrel], ag.grasp_on(bow, approach=ag.Y, closing=ag.X, depth=0.012)
