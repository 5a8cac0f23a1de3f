"""Latch bolts: the bolt, the pocket it slides in, its faceplate on the leaf, and the strike in the jamb.

All are drawn about the spindle of a closed leaf whose lock edge is at x = backset, and which closes towards
+y (it opens towards -y). Tubular latches and mortise locks of common make have bolts 11-13 mm wide with a
throw of 10-12.7 mm (ANSI/BHMA A156.2, EN 12209).
"""

from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.shared.hardware.fixings import Way, screws

PLAY = 0.0004
"""Clearance around a sliding bolt [m]."""


BoltName = Literal["latch", "deadbolt"]


@dataclass(frozen=True)
class Bolt:
    """The section of a bolt."""

    width: float  # across the leaf, along Y [m]
    height: float  # along Z [m]


LATCH = Bolt(0.012, 0.018)
DEADBOLT = Bolt(0.0145, 0.025)

LATCH_HOLE = LATCH.height + 2 * PLAY
"""Height of the hole of a spindle that meets the pocket of a latch [m]."""

_TAIL = 0.022  # what stays in the leaf behind the throw [m]
_OVERTRAVEL = 1.6  # a handle turns further than the latch needs: the pocket is that many throws deep
_OPENING_PLAY = 0.0007  # a closed door rattles by this much [m]
_EASY = 0.002  # play of the strike where nothing has to hold [m]
_SKIN = 0.0008  # thickness of what is seen of a strike [m]
_SCREW = 0.0036  # radius of the heads of screws [m]
_PROUD = 0.0003  # plates stand out of the wood by this much, so that they are seen [m]


def latch_bolt(*, backset: ag.Scalar, throw: ag.Scalar, finish: ag.Material) -> ag.Body:
    """Make a sprung bolt: flat towards -y, where it holds the door, slanted towards +y, where it closes."""
    half = LATCH.width / 2
    section = ag.polygon(
        [
            (backset - _TAIL, -half),
            (backset + throw, -half),
            (backset + throw, -half + 0.003),  # a blunt nose
            (backset + 0.0015, half),
            (backset - _TAIL, half),
        ]
    )
    return ag.part(ag.extrude(section, LATCH.height, axis=ag.Z, bevel=0.0006), "latch", finish)


def latch_slide(
    leader: ag.Joint, *, throw: ag.Scalar, release: ag.Scalar, name: str = "latch_slide"
) -> ag.Joint:
    """Make the joint of a latch bolt that a handle draws into the leaf; positive is drawn back."""
    return ag.Prismatic(name, axis=-ag.X, follows=(throw / release) * leader, damping=2.0, friction=0.2)


def latch_pocket(*, backset: ag.Scalar, throw: ag.Scalar, through: bool = False) -> ag.Solid:
    """Make the tool that cuts the bolt's pocket into the lock edge of the leaf."""
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
    # 0.1 mm inside the walls of the pocket, whose faces would fight its own for a pixel
    outline = outline - ag.rectangle(section.width + 1.5 * PLAY, section.height + 1.5 * PLAY)
    bodies = [
        ag.detail(_pierced(outline, level, thick).at(face - thick / 2, 0.0, 0.0), "faceplate", finish),
        *_plate_screws(face, "+x", level, finish),
    ]
    if mark:
        name = details.lettering([mark.upper()], 0.0016, tracking=0.12, fineness="coarse")
        bodies.append(
            details.engraved(
                name, (face, 0.0, -height / 2 + 0.0026), facing=ag.X, label="faceplate", material=finish
            )
        )
    return ag.weld(*bodies)


def _pierced(outline: ag.Profile, level: ag.Scalar, thick: ag.Scalar) -> ag.Solid:
    """Make a plate that looks along X, with holes for screws above and below its middle."""
    hole = ag.circle(_SCREW + 0.0003)
    return ag.extrude(outline - hole.at(0.0, level) - hole.at(0.0, -level), thick, axis=ag.X)


def _plate_screws(x: ag.Scalar, facing: Way, height: ag.Scalar, finish: ag.Material) -> list[ag.Body]:
    """Make countersunk heads above and below a bolt on a plate at x."""
    return screws(
        [(x, 0.0, -height), (x, 0.0, height)], facing=facing, radius=_SCREW, finish=finish, sunk=0.0005
    )


def strike_pocket(*, backset: ag.Scalar, gap: ag.Scalar, throw: ag.Scalar, bolt: Bolt = LATCH) -> ag.Solid:
    """Make the tool that cuts the hole for a thrown bolt into the jamb."""
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
    """Make the plate on the jamb that a bolt enters, to be welded to a jamb cut with `strike_pocket`."""
    section = LATCH if bolt == "latch" else DEADBOLT
    face = backset + gap - _PROUD
    low, high = -thickness / 2 + 0.0005, section.width / 2 + 0.008
    hole = strike_pocket(backset=backset, gap=gap, throw=throw, bolt=section)
    # what collides lies behind what is seen, which has the holes of the screws
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
        # the lip, which guides the latch in, curls around the front of the jamb
        curl = ag.polygon([(0.0, 0.0), (0.0, -0.0006), (0.0020, -0.0029), (0.0030, -0.0024), (0.0012, 0.0)])
        lip = ag.extrude(curl, section.height + 0.012, axis=ag.Z, bevel=0.0003)
        bodies.append(ag.detail(lip.at(face, -thickness / 2 + 0.0006, 0.0), "strike", finish))
    return ag.weld(*bodies)


def clear_angle(*, thickness: ag.Scalar, reach: ag.Scalar, bolt: Bolt = LATCH) -> ag.Scalar:
    """Return the angle of a door at which its thrown latch has left the strike, 2 mm to spare [rad]."""
    # small angles: the bolt moves by angle * reach, a little more at its nose
    return (thickness / 2 + bolt.width / 2 + 0.002) / reach * 1.02
