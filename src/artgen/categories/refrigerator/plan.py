"""The plan of a refrigerator: cabinet, cells, doors and drawer fronts, and the angles that drawers need.

A refrigerator is centered in x and y, and its doors are in front of the cabinet.
"""

from dataclasses import dataclass, replace
from functools import partial, reduce
from typing import Literal

import artgen as ag
from artgen import feel
from artgen._arrays import cached_property

Layout = Literal["single", "top_freezer", "bottom_freezer", "french", "side_by_side"]
"""One door; a freezer above or below; two doors over freezer drawers; freezer and cold cell side by side."""

FOOT = 0.022
"""Height of the feet [m]."""

SEAL_GAP = 0.010
"""Gap between a closed door and the cabinet, filled by the gasket [m]."""

COVER = 0.018
"""Height of the covers of the upper hinges, on top of the cabinet [m]."""

HUMP_DEEP, HUMP_HIGH = 0.125, 0.175
"""Depth and height of the machine room in the rear of the lowest cell [m]."""

SEAL_INSET = 0.026
"""Distance from the hinge edge to the gasket: beyond the axis, so that it leaves the cabinet at once [m]."""

CHEEK = 0.040
"""Distance from the side of a cell to a drawer: the width of the rails there [m]."""

LINING_INSET = 0.004
"""Difference in width between lining and skin at the hinge edge [m]."""

LIGHT = 0.15
"""Width of the light at the ceiling of a cell [m]."""

HAND = 60.0
"""Largest pull of a hand; 15-45 N open a refrigerator [N]."""

_PIN = 0.020  # distance of the axis of a hinge from the outer edge and the front of its door [m]
_BACK_WALL = 0.055  # thickness of the back [m]
_CEILING = 0.045  # thickness of the top [m]
_FLOOR = 0.030  # distance from the lower edge of the lowest front to the floor of its cell [m]
_HALF_WALL = 0.027  # half of the thickness of walls between cells [m]
_UNDER_COVER = 0.003  # gap between a door and the cover of its hinge [m]
_INSET = 0.001  # distance from each side of the cabinet to the doors [m]
_PASSES = 0.003  # gap between the inner parts of two doors that meet [m]
_RIDGE_INSET = 0.055  # distance from the wall of the cell to the ridge near the hinges [m]
_SWINGS_PAST = 0.005  # clearance between the free ridge and the parts that it passes [m]
_CLEARS = 0.004  # clearance between an open door and a drawer [m]
_NO_LIGHT = (
    "the freezer or the refrigerator is narrower than its light: raise width, lower wall, or take a "
    "freezer_share of about 0.45"
)
_NO_MACHINE = (
    "the lowest drawer would strike the machine room behind it: raise freezer_share or height, or lower "
    "outer_drawers or kick_height"
)


class Cell(ag.Region):
    """A cold compartment, open in front.

    The machine room takes the lower part of the rear of a humped cell; a top cell is under the top of the
    cabinet.
    """

    __slots__ = ("humped", "top")

    def __init__(self, space: ag.Region, *, humped: bool, top: bool) -> None:
        super().__init__(space.x, space.y, space.z)
        self.humped, self.top = humped, top


@dataclass(frozen=True)
class Leaf:
    """A door with hinges at its left; a door hinged at the right is the mirror image."""

    label: str  # semantic label
    board: ag.Region  # space from edge to edge, and from the front to the flat inside
    cell: Cell  # closed cell
    ridge: ag.Scalar | None  # depth of the ridges in the cell [m]; None for a flat inside
    bins: int  # number of bins between the ridges
    handle: Literal["low", "middle", "high"] = "middle"  # position of the handle
    side: Literal["", "left", "right"] = ""  # side of a door of a pair
    # whether the door is hinged at the right: all dimensions are then those of the mirror image
    mirrored: bool = False
    meets: bool = False  # whether the free edge meets that of another door

    @property
    def name(self) -> str:
        """Name of the link."""
        return f"{self.label}_{self.side}" if self.side else self.label

    @cached_property
    def axis(self) -> ag.Scalar:
        """Position of the axis along x [m]."""
        return self.board.x.low + _PIN

    @cached_property
    def reach(self) -> ag.Scalar:
        """Distance from the axis to the tips of the ridges, front to back [m]."""
        return self.board.y.size - _PIN + (0 if self.ridge is None else self.ridge)

    @cached_property
    def ridges(self) -> tuple[ag.Scalar, ag.Scalar]:
        """Outer sides of the ridges along x [m].

        The free ridge has the largest distance from the axis at which its tip passes a wall or another door.
        """
        limit = -_PASSES / 2 if self.side else self.cell.x.high
        room = limit - self.axis - _SWINGS_PAST
        far = ag.sqrt(ag.max_(room * room - self.reach * self.reach, 0))
        return self.cell.x.low + _RIDGE_INSET, self.axis + far

    @cached_property
    def _corners(self) -> list[tuple[ag.Scalar, ag.Scalar]]:
        """Positions of the corners of the inside: squared distance from the axis [m2], and angle [rad]."""
        back = self.board.y.size - _PIN
        points: list[tuple[ag.Scalar, ag.Scalar]] = [
            (LINING_INSET - _PIN, back),
            (SEAL_INSET - _PIN, back + SEAL_GAP),
        ]
        if self.ridge is not None:
            points.append((self.ridges[0] - self.axis, self.reach))
        return [(u * u + v * v, ag.atan2(v, u)) for u, v in points]

    def frees(self, x: ag.Span) -> ag.Float:
        """Return the smallest opening angle that clears a drawer between two sides [rad].

        A corner at (u, v) from the axis, to the right and to the back, moves to x = u cos q + v sin q. This
        decreases from q = atan2(v, u), and reaches c after a further turn of acos(c / r).
        """
        room = (-x[1] if self.mirrored else x[0]) - self.axis - _CLEARS
        angles = [
            start + ag.atan2(ag.sqrt(ag.max_(square - room * room, 0)), room)
            for square, start in self._corners
        ]
        return reduce(ag.max_, angles[1:], angles[0])

    def hinge(self, *, limit: ag.Scalar, pull: ag.Scalar, damping: ag.Scalar) -> ag.Joint:
        """Make the hinge of the door; friction holds the door at any angle.

        Opening a refrigerator needs 15-45 N at its handle against the gasket, and about 5 N further on; a
        joint has one friction over its range, so `pull` is the low end of the first force.
        """
        side = 1 if self.mirrored else -1
        arm = self.board.x.size - _PIN - 0.05  # distance from the axis to the handle [m]
        name = f"{self.label}_hinge_{self.side}" if self.side else f"{self.label}_hinge"
        pivot = (-side * self.axis, self.board.y.low + _PIN, self.board.z.mid)
        drag = feel.Feel(friction=pull * arm, damping=damping, effort=HAND * arm, velocity=4)
        return ag.Revolute(name, pivot=pivot, axis=(0, 0, side), limits=(0, limit), feel=drag)


class Plan:
    """Regions, cells and doors of a refrigerator."""

    def __init__(
        self,
        layout: Layout,
        outside: ag.Region,  # from the fronts of the doors to the back, without handles
        *,
        thickness: ag.Scalar,  # thickness of the doors [m]
        wall: ag.Scalar,  # thickness of the sides [m]
        gap: ag.Scalar,  # gap between two fronts [m]
        kick: ag.Scalar,  # height of the lower edge of the lowest front [m]
        share: ag.Scalar,  # share of the freezer in the height or the width
        ridge: ag.Scalar,  # depth in the cell of the bins of the refrigerator's doors [m]
        freezer_ridge: ag.Scalar | None,  # the same for the freezer's door; None for a flat inside [m]
        bins: int,  # number of bins on each door of the refrigerator
        drawers: int,  # number of freezer drawers with their own fronts
    ) -> None:
        self.wall, self.gap, self.kick = wall, gap, kick
        self.block = outside.shrink(front=thickness + SEAL_GAP, bottom=FOOT)
        front = outside.shrink(x=_INSET, bottom=kick, top=_UNDER_COVER)
        front = front.with_(y=(front.y.low, front.y.low + thickness))
        self.abreast = layout == "side_by_side"  # whether the freezer is beside the cold cell, at its left
        self.fronts: list[tuple[ag.Region, Cell]] = []  # fronts of freezer drawers with their cells
        self.freezer: Leaf | None = None
        door = partial(Leaf, "door", ridge=ridge, bins=bins)
        freezer = partial(Leaf, "freezer_door", ridge=freezer_ridge, bins=max(1, bins - 1))
        if layout == "single":
            self.cold = self._cell(front, lowest=True, highest=True)
            self.cells, self.doors = [self.cold], [door(front, self.cold)]
            return
        if self.abreast:
            whole, split = self._cell(front, lowest=True, highest=True), outside.x.at(share)
            narrower = ag.min_(split - whole.x.low, whole.x.high - split) - _HALF_WALL
            split = ag.require(split, narrower > LIGHT + 0.01, _NO_LIGHT)
            left, right = (whole.x.low, split - _HALF_WALL), (split + _HALF_WALL, whole.x.high)
            frozen, self.cold = (Cell(whole.with_(x=x), humped=True, top=True) for x in (left, right))
            turned = Cell(self.cold.mirror(), humped=True, top=True)
            self.cells = [frozen, self.cold]
            self.freezer = freezer(front.with_(x=(front.x.low, split - gap / 2)), frozen, meets=True)
            board = front.with_(x=(front.x.low, -split - gap / 2))
            self.doors = [door(board, turned, mirrored=True, meets=True)]
            return
        above, part = layout == "top_freezer", share * front.z.size - gap / 2
        upper, lower = front.stack(*((part, None) if above else (None, part)), gap=gap)
        if above:
            self.cold, frozen = self._cell(lower, lowest=True), self._cell(upper, highest=True)
            self.cells, self.doors = [self.cold, frozen], [door(lower, self.cold, handle="high")]
            self.freezer = freezer(upper, frozen, handle="low")
            return
        self.cold = self._cell(upper, highest=True)
        self.doors = [door(upper, self.cold, handle="low")]
        if layout == "french":
            half = upper.with_(x=(upper.x.low, -gap / 2))
            left_door = door(half, self.cold, side="left", meets=True)
            self.doors = [left_door, replace(left_door, side="right", mirrored=True)]
        elif not drawers:
            frozen = self._cell(lower, lowest=True)
            self.cells, self.freezer = [frozen, self.cold], freezer(lower, frozen, handle="high")
            return
        # the top of the machine room is in the wall above the lowest cell
        lowest = (lower.z.size + gap / 2) / drawers - _FLOOR - _HALF_WALL
        top = ag.require(lower.z.high, lowest > HUMP_HIGH - 1.5 * _HALF_WALL, _NO_MACHINE)
        first, *others = lower.with_(z=(lower.z.low + gap / 2, top)).rows(drawers, gap)
        first = first.grow(bottom=gap / 2)
        self.fronts = [
            (first, self._cell(first, lowest=True)),
            *((each, self._cell(each)) for each in others),
        ]
        self.cells = [*(cell for _, cell in self.fronts), self.cold]

    def _cell(self, front: ag.Region, *, lowest: bool = False, highest: bool = False) -> Cell:
        """Return the cell behind a front."""
        space = self.block.shrink(x=self.wall, front=0, back=_BACK_WALL, z=0)
        low = front.z.low + (_FLOOR if lowest else _HALF_WALL - self.gap / 2)
        high = space.z.high - _CEILING if highest else front.z.high - _HALF_WALL + self.gap / 2
        return Cell(space.with_(z=(low, high)), humped=lowest, top=highest)

    @property
    def leaves(self) -> list[Leaf]:
        """All doors."""
        return [*self.doors, *([self.freezer] if self.freezer else [])]


def hinges(plan: Plan, *, cover: ag.Material, metal: ag.Material) -> list[ag.Body]:
    """Make the covers over the hinges on top of the cabinet, and the brackets in the gaps under the doors."""
    bodies = []
    mouth, top = plan.block.y.low, plan.block.z.high
    for leaf in plan.leaves:
        x, y, z = leaf.axis, leaf.board.y.low + _PIN, leaf.board.z.low - plan.gap / 2
        plate = ag.Region((x - 0.018, x + 0.020), (y - 0.011, mouth + 0.001), (z - 0.0009, z + 0.0009))
        pin = ag.cylinder(0.0055, 0.003).at(x, y, z)
        fixed = [ag.detail([plate.box(bevel=0.0005), pin], "hinge", metal)]
        if leaf.cell.top:  # the cover projects over the door in front of it
            cap = ag.Region((x - 0.016, x + 0.036), (y - 0.017, y + 0.11), (top, top + COVER))
            solid = ag.extrude(cap.plan(radius=0.010), COVER, bevel=0.004).at(z=cap.z.mid)
            fixed.append(ag.part(solid, "hinge", cover))
        bodies += [each.mirror(ag.X) if leaf.mirrored else each for each in fixed]
    return bodies
