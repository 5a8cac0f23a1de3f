"""Doors of cabinets: in front of the carcass on concealed hinges, or between its sides on butt hinges.

Every door is made with its hinges at the left; a door hinged at the right is its mirror image in x = 0.
"""

from collections.abc import Callable, Sequence
from typing import Literal

import artgen as ag
from artgen import feel
from artgen.categories.shared.finish import recess
from artgen.categories.shared.fixings import hinge_frame, hinge_leaf, hinge_offset, screws
from artgen.categories.shared.fronts import FrontLook, front
from artgen.categories.shared.furniture import CLEAR_RUBBER, ZINC, Carcass

_GAP = 0.002  # gap between the back of a closed door and the carcass [m]
_AXIS = (0.0045, -0.0115)  # from the back of the hinge edge to the axis of a concealed hinge, x and y [m]
_CUP = 0.0175  # radius of the standard cup [m]
_CUP_AT = 0.0225  # distance from the edge of the door to the middle of a cup, which leaves 5 mm of wood [m]
_FLANGE = 0.0014  # thickness of the flanges on the door [m]


def _cups(levels: Sequence[ag.Scalar]) -> ag.Body:
    """Make the cups with their flanges on the back y = 0 of a door with its edge at x = 0, visual only."""
    at = [(0.0, 0.0, level) for level in levels]
    wing = ag.rectangle(0.013, 0.062, radius=0.005).at(_CUP_AT + 0.008)
    plate = ag.circle(_CUP + 0.0015).at(_CUP_AT) | wing
    flange = ag.extrude(plate - ag.circle(_CUP - 0.0015).at(_CUP_AT), _FLANGE, axis=-ag.Y)
    well = ag.cylinder(_CUP - 0.0012, 0.0004, axis=ag.Y).at(_CUP_AT, 0.0001)
    cheek = ag.Region((0.0170, 0.0330), (-0.001, 0.0085), (-0.0011, 0.0011)).box(bevel=0.0008)
    link = ag.array(cheek, at=[(0.0, 0.0, 0.0088), (0.0, 0.0, -0.0088)])
    heads = [(_CUP_AT + 0.008, _FLANGE / 2, level + end * 0.024) for level in levels for end in (-1, 1)]
    return ag.weld(
        ag.detail([ag.array(flange, at=at), ag.array(link, at=at)], "hinge", ZINC),
        ag.detail(ag.array(well, at=at), "hinge", recess(ZINC)),
        *screws(heads, facing="+y", radius=0.0036, finish=ZINC),
    )


def _arms(levels: Sequence[ag.Scalar], make: Callable[..., ag.Body]) -> ag.Body:
    """Make the mounting plates and arms on the inner face x = 0 of a side with its front at y = 0."""
    at = [(0.0, 0.0, level) for level in levels]
    plate = ag.Region((-0.0003, 0.0035), (0.024, 0.054), (-0.022, 0.022)).box(bevel=0.0008)
    arm = ag.Region((0.0030, 0.0130), (0.0025, 0.072), (-0.0062, 0.0062)).box(bevel=0.0016)
    heads = [(0.0034, 0.039, level + end * 0.016) for level in levels for end in (-1, 1)]
    turns = [(0.0129, y, level) for level in levels for y in (0.030, 0.058)]
    return ag.weld(
        make([ag.array(plate, at=at), ag.array(arm, at=at)], "hinge", ZINC),
        *screws(heads, facing="+x", radius=0.0038, finish=ZINC),
        *screws(turns, facing="+x", radius=0.0030, finish=ZINC),
    )


HingeStyle = Literal["concealed", "butt"]
"""Cups in the back of a door in front of the carcass, or knuckles in front of a door between the sides."""

_REVEAL = 0.003  # gap between the doors of a pair, and around a door between the sides [m]
_MARGIN = 0.0015  # distance from the edges of an overlaid door to the outlines of the carcass [m]
_END = 0.085  # distance from the ends of a door to the middles of its outer hinges [m]
_KNUCKLE, _TALL = 0.004, 0.056  # radius and height of the knuckles of butt hinges [m]
_HAND = 60.0  # largest pull of a hand [N]


class Hanging:
    """The left or only door of a carcass, and its hinges.

    Args:
        case: Carcass.
        hinge: Kind of the hinges.
        doors: Number of doors, 1 or 2.
        thickness: Thickness of a door [m].
        shares: Positions of the hinges between the outermost ones, from 0 to 1.
        above: Additional space above the doors [m].
        below: Additional space below the doors [m].
        metal: Metal of butt hinges.
    """

    def __init__(
        self,
        case: Carcass,
        hinge: HingeStyle,
        doors: int,
        thickness: ag.Scalar,
        shares: Sequence[float],
        *,
        above: ag.Scalar,
        below: ag.Scalar,
        metal: ag.Material,
    ) -> None:
        self._case, self._metal, self._thickness = case, metal, thickness
        self.inset = hinge == "butt"  # whether the doors are between the sides of the carcass
        if self.inset:
            face, x, z, edge = case.front, case.right, (case.floor, case.ceiling), _REVEAL
        else:
            face, x, z, edge = case.front - _GAP - thickness, case.width / 2, (case.low, case.high), _MARGIN
        whole = ag.Region((-x, x), (face, face + thickness), z)
        whole = whole.shrink(x=edge, top=edge + above, bottom=edge + below)
        self.region = whole.columns(doors, gap=_REVEAL)[0]
        low, high = self.region.z.low + _END, self.region.z.high - _END
        self._levels = [low + share * (high - low) for share in shares]
        if self.inset:
            self._axis = (self.region.x.low - _REVEAL / 2, face - hinge_offset(_KNUCKLE))
        else:
            self._axis = (self.region.x.low + _AXIS[0], face + thickness + _AXIS[1])

    def pair_turns(self) -> ag.Bool | bool:
        """Return whether the far corners of an inset pair clear each other when both doors open."""
        deep = hinge_offset(_KNUCKLE) + self._thickness
        return deep * deep / (2 * self.region.x.size + _REVEAL) < _REVEAL / 2 - 0.0002

    def leaf(self, look: FrontLook, handle: ag.Body, *, name: str) -> ag.Body:
        """Make a door with its halves of the hinges."""
        x, y, z = self.region.x, self.region.y, self.region.z
        boards = ag.weld(*front(look, x.size, z.size, self._thickness, label="door", name=name))
        boards = ag.weld(boards.at(self.region.center), handle)
        if self.inset:
            return ag.weld(boards, self._butt(hinge_leaf))
        # rubber behind the free corners keeps a door off the carcass
        drop = ag.dome(0.0042, height=0.0014, axis=ag.Y)
        at = [(x.high - 0.010, y.high - 0.0001, level) for level in (z.low + 0.010, z.high - 0.010)]
        bumpers = ag.detail(ag.array(drop, at=at), "bumper", CLEAR_RUBBER)
        return ag.weld(boards, _cups(self._levels).at(x.low, y.high), bumpers)

    def on_side(self, make: Callable[..., ag.Body] = ag.part) -> ag.Body:
        """Make the halves of the hinges at the left side of the carcass, with `ag.detail` only to be seen."""
        if self.inset:
            return self._butt(hinge_frame)
        return _arms(self._levels, make).at(-self._case.right, self._case.front)

    def _butt(self, make: Callable[..., ag.Body]) -> ag.Body:
        sizes = {"height": _TALL, "radius": _KNUCKLE, "knuckles": 3, "sheets": False}
        depth = self._thickness - 0.005
        return make(depth=depth, finish=self._metal, levels=self._levels, **sizes).at(*self._axis)

    def joint(
        self, name: str, *, limit: ag.Scalar, friction: ag.Scalar, damping: ag.Scalar, side: int = 1
    ) -> ag.Joint:
        """Make the hinge of a door; positive opens it towards -y."""
        x, y = self._axis
        drag = feel.Feel(friction=friction, damping=damping, effort=_HAND * self.region.x.size, velocity=6)
        return ag.Revolute(
            name, axis=(0.0, 0.0, -side), pivot=(side * x, y, self.region.z.mid), limits=(0, limit), feel=drag
        )
