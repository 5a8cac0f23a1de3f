"""Doors of cabinets: in front of the carcass on concealed hinges, or between its sides on butt hinges.

Every door is made with its hinges at the left; a door hinged at the right is its mirror image in x = 0.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen.categories.shared.finish import recess
from artgen.categories.shared.fixings import hinge_frame, hinge_leaf, hinge_offset, screws
from artgen.categories.shared.fronts import FrontLook, front
from artgen.categories.shared.furniture import CLEAR_RUBBER, ZINC, Carcass

DOOR_GAP = 0.002
"""Gap between the back of a closed door and the carcass [m]."""

AXIS = (0.0045, -0.0115)
"""Position of the hinge axis, x and y [m]."""

_CUP = 0.0175  # radius of the standard cup [m]
_CUP_AT = 0.0225  # distance from the edge of the door to the middle of a cup, which leaves 5 mm of wood [m]
_FLANGE = 0.0014  # thickness of the flanges on the door [m]


def _everywhere(levels: Sequence[ag.Scalar]) -> list[ag.VectorLike]:
    return [(0.0, 0.0, level) for level in levels]


def cup_hinges_on_door(levels: Sequence[ag.Scalar], *, finish: ag.Material) -> list[ag.Body]:
    """Make the cups with their flanges, visual only."""
    at = _everywhere(levels)
    wing = ag.rectangle(0.013, 0.062, radius=0.005).at(_CUP_AT + 0.008, 0.0)
    plate = ag.circle(_CUP + 0.0015).at(_CUP_AT, 0.0) | wing
    way = (0.0, 1.0, 0.0)
    flange = ag.extrude(plate - ag.circle(_CUP - 0.0015).at(_CUP_AT, 0.0), _FLANGE, axis=(0.0, -1.0, 0.0))
    well = ag.cylinder(_CUP - 0.0012, 0.0004, axis=way).at(_CUP_AT, 0.0001, 0.0)
    cheek = ag.Region((0.0170, 0.0330), (-0.001, 0.0085), (-0.0011, 0.0011)).box(bevel=0.0008)
    link = ag.array(cheek, at=[(0.0, 0.0, 0.0088), (0.0, 0.0, -0.0088)])
    heads = [(_CUP_AT + 0.008, _FLANGE / 2, level + end * 0.024) for level in levels for end in (-1, 1)]
    return [
        ag.detail(ag.array(flange, at=at), "hinge", finish),
        ag.detail(ag.array(well, at=at), "hinge", recess(finish)),
        ag.detail(ag.array(link, at=at), "hinge", finish),
        *screws(heads, facing="+y", radius=0.0036, finish=finish),
    ]


def cup_hinges_on_side(
    levels: Sequence[ag.Scalar], *, inside: ag.Scalar, finish: ag.Material
) -> list[ag.Body]:
    """Make the mounting plates and arms on the inner face of a side."""
    at = _everywhere(levels)
    y = DOOR_GAP
    plate = ag.Region((inside - 0.0003, inside + 0.0035), (y + 0.024, y + 0.054), (-0.022, 0.022)).box(
        bevel=0.0008
    )
    arm = ag.Region((inside + 0.0030, inside + 0.0130), (y + 0.0025, y + 0.072), (-0.0062, 0.0062)).box(
        bevel=0.0016
    )
    heads = [(inside + 0.0034, y + 0.039, level + end * 0.016) for level in levels for end in (-1, 1)]
    turns = [(inside + 0.0129, y + deep, level) for level in levels for deep in (0.030, 0.058)]
    return [
        ag.part(ag.array(plate, at=at), "hinge", finish),
        ag.part(ag.array(arm, at=at), "hinge", finish),
        *screws(heads, facing="+x", radius=0.0038, finish=finish),
        *screws(turns, facing="+x", radius=0.0030, finish=finish),
    ]


HingeStyle = Literal["concealed", "butt"]
"""Cups in the back of a door in front of the carcass, or knuckles in front of a door between the sides."""

REVEAL = 0.003
"""Gap between the doors of a pair, and around a door between the sides [m]."""

_MARGIN = 0.0015  # distance from the edges of an overlaid door to the outlines of the carcass [m]
_END = 0.085  # distance from the ends of a door to the middles of its outer hinges [m]
_KNUCKLE, _TALL = 0.004, 0.056  # radius and height of the knuckles of butt hinges [m]
_HAND = 60.0  # largest pull of a hand [N]


@dataclass(frozen=True)
class Hanging:
    """The doors of a cabinet."""

    case: Carcass  # carcass
    hinge: HingeStyle  # kind of hinge
    doors: int  # number of doors, 1 or 2
    thickness: ag.Scalar  # thickness of a door [m]
    # positions of the inner hinges between the outermost ones, as shares from 0 to 1
    shares: Sequence[float]
    above: ag.Scalar  # additional space above the doors [m]
    below: ag.Scalar  # additional space below the doors [m]
    metal: ag.Material  # metal of butt hinges

    @property
    def inset(self) -> bool:
        """Whether the doors are between the sides of the carcass."""
        return self.hinge == "butt"

    @property
    def left(self) -> ag.Scalar:
        """Position of the hinge edge of the left or only door along x [m]."""
        return REVEAL - self.case.right if self.inset else _MARGIN - self.case.width / 2

    @property
    def width(self) -> ag.Scalar:
        """Width of a door [m]."""
        return (-2 * self.left - (self.doors - 1) * REVEAL) / self.doors

    @property
    def low(self) -> ag.Scalar:
        """Height of the lower edge of a door [m]."""
        return self.below + (self.case.floor + REVEAL if self.inset else self.case.low + _MARGIN)

    @property
    def high(self) -> ag.Scalar:
        """Height of the upper edge of a door [m]."""
        return (self.case.ceiling - REVEAL if self.inset else self.case.high - _MARGIN) - self.above

    @property
    def face(self) -> ag.Scalar:
        """Position of the face of a shut door along y [m]."""
        return self.case.front if self.inset else self.case.front - DOOR_GAP - self.thickness

    @property
    def levels(self) -> list[ag.Scalar]:
        """Heights of the middles of the hinges [m]."""
        way = self.high - self.low - 2 * _END
        return [self.low + _END + share * way for share in self.shares]

    def pair_turns(self) -> ag.Bool | bool:
        """Return whether the far corners of an inset pair clear each other when both doors open."""
        deep = hinge_offset(_KNUCKLE) + self.thickness
        return deep * deep / (2 * self.width + REVEAL) < REVEAL / 2 - 0.0002

    def leaf(self, look: FrontLook, handle: ag.Body, *, name: str) -> ag.Body:
        """Make a door with its halves of the hinges."""
        t, back = self.thickness, self.face + self.thickness
        middle = (self.left + self.width / 2, self.face + t / 2, (self.low + self.high) / 2)
        boards = front(look, self.width, self.high - self.low, t, label="door", name=name)
        if self.inset:
            halves = [self._butt(hinge_leaf)]
        else:
            cups = cup_hinges_on_door(self.levels, finish=ZINC)
            halves = [*(each.at(self.left, back, 0.0) for each in cups), self._bumpers(back)]
        return ag.weld(*(each.at(*middle) for each in boards), handle, *halves)

    def on_side(self) -> list[ag.Body]:
        """Make the halves of the hinges at the left side of the carcass."""
        if self.inset:
            return [self._butt(hinge_frame)]
        inside = -self.case.right - self.left
        arms = cup_hinges_on_side(self.levels, inside=inside, finish=ZINC)
        return [each.at(self.left, self.case.front - DOOR_GAP, 0.0) for each in arms]

    def _butt(self, make: Callable[..., ag.Body]) -> ag.Body:
        half = make(
            height=_TALL,
            radius=_KNUCKLE,
            depth=self.thickness - 0.005,
            finish=self.metal,
            knuckles=3,
            levels=self.levels,
            sheets=False,
        )
        return half.at(self.left - REVEAL / 2, self.face - hinge_offset(_KNUCKLE), 0.0)

    def _bumpers(self, back: ag.Scalar) -> ag.Body:
        """Make the rubber bumpers behind the free corners, which keep a door off the carcass."""
        drop = ag.dome(0.0042, height=0.0014, axis=(0.0, 1.0, 0.0))
        x = self.left + self.width - 0.010
        at: list[ag.VectorLike] = [(x, back - 0.0001, z) for z in (self.low + 0.010, self.high - 0.010)]
        return ag.detail(ag.array(drop, at=at), "bumper", CLEAR_RUBBER)

    def joint(
        self, name: str, *, limit: ag.Scalar, friction: ag.Scalar, damping: ag.Scalar, side: int = 1
    ) -> ag.Joint:
        """Make the hinge of a door; positive opens it towards -y."""
        x, y = (
            (self.left - REVEAL / 2, self.face - hinge_offset(_KNUCKLE))
            if self.inset
            else (self.left + AXIS[0], self.face + self.thickness + AXIS[1])
        )
        return ag.Revolute(
            name,
            axis=(0.0, 0.0, -side),
            pivot=(side * x, y, (self.low + self.high) / 2),
            limits=(0.0, limit),
            friction=friction,
            damping=damping,
            effort=_HAND * self.width,
            velocity=6.0,
        )
