"""Division of a refrigerator into cells, doors and drawer fronts."""

from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen._arrays import cached_property
from artgen.categories.refrigerator.case import HUMP_HIGH, Case, Cell
from artgen.categories.refrigerator.drawers import Front
from artgen.categories.refrigerator.inside import LIGHT
from artgen.categories.refrigerator.leaf import PIN, Leaf, hinge_bracket, hinge_cover

Layout = Literal["single", "top_freezer", "bottom_freezer", "french", "side_by_side"]
"""One door; a freezer above or below; two doors over freezer drawers; freezer and cold cell side by side."""

_CEILING = 0.045  # thickness of the top [m]
_FLOOR = 0.030  # distance from the lower edge of the lowest front to the floor of its cell [m]
_HALF_WALL = 0.027  # half of the thickness of walls between cells [m]
_UNDER_COVER = 0.003  # gap between a door and the cover of its hinge [m]
_INSET = 0.001  # distance from each side of the cabinet to the doors [m]
_PASSES = 0.003  # gap between the inner parts of two doors that meet [m]
_NO_LIGHT = (
    "the freezer or the refrigerator is narrower than its light: raise width, lower wall, or take a "
    "freezer_share of about 0.45"
)


@dataclass(frozen=True)
class Plan:
    """Cells, doors and fronts of a refrigerator."""

    cold: Cell  # cell of the refrigerator
    frozen: tuple[Cell, ...]  # cells of the freezer
    doors: tuple[Leaf, ...]  # doors of the refrigerator
    freezer: Leaf | None = None  # door of the freezer, or None
    fronts: tuple[Front, ...] = ()  # fronts of the freezer's drawers, or none
    abreast: bool = False  # whether the freezer is beside the refrigerator, at its left

    @cached_property
    def cells(self) -> tuple[Cell, ...]:
        """All cells, from below or from the left."""
        if not self.frozen:
            return (self.cold,)
        return (
            (self.cold, *self.frozen)
            if self.frozen[0].top and not self.abreast
            else (*self.frozen, self.cold)
        )

    @cached_property
    def leaves(self) -> tuple[Leaf, ...]:
        """All doors."""
        return self.doors if self.freezer is None else (*self.doors, self.freezer)


@dataclass(frozen=True)
class Divided:
    """Options for the division of a cabinet."""

    case: Case  # cabinet
    share: ag.Scalar  # share of the freezer in the height or the width
    ridge: ag.Scalar  # depth of the bins of the refrigerator's doors in the cell [m]
    # depth of the inner parts of the freezer's door; None for a flat inside [m]
    freezer_ridge: ag.Scalar | None
    bins: int  # number of bins on each door of the refrigerator
    drawers: int  # number of freezer drawers with their own fronts

    def plan(self, layout: Layout) -> Plan:
        """Divide the cabinet."""
        case = self.case
        low, high = case.kick, case.top - _UNDER_COVER
        if layout == "single":
            cold = self._cell(low, high, lowest=True, highest=True)
            return Plan(cold, (), (self._door(cold, low, high),))
        if layout == "side_by_side":
            return self._abreast(low, high)
        if layout == "top_freezer":
            split = high - self.share * (high - low)
            cold = self._cell(low, split, lowest=True)
            frozen = self._cell(split, high, highest=True)
            door = self._door(cold, low, split - case.gap / 2, handle="high")
            freezer = self._freezer(frozen, split + case.gap / 2, high, handle="low")
            return Plan(cold, (frozen,), (door,), freezer)
        split = low + self.share * (high - low)
        cold = self._cell(split, high, highest=True)
        if layout == "bottom_freezer" and not self.drawers:
            frozen = self._cell(low, split, lowest=True)
            door = self._door(cold, split + case.gap / 2, high, handle="low")
            freezer = self._freezer(frozen, low, split - case.gap / 2, handle="high")
            return Plan(cold, (frozen,), (door,), freezer)
        fronts = self._fronts(low, split)
        cells = tuple(front.cell for front in fronts)
        if layout == "bottom_freezer":
            doors: tuple[Leaf, ...] = (self._door(cold, split + case.gap / 2, high, handle="low"),)
        else:
            doors = self._pair(cold, split + case.gap / 2, high)
        return Plan(cold, cells, doors, None, fronts)

    def _cell(self, low: ag.Scalar, high: ag.Scalar, *, lowest: bool = False, highest: bool = False) -> Cell:
        case = self.case
        side = case.width / 2 - case.wall
        bottom = low + (_FLOOR if lowest else _HALF_WALL)
        top = case.top - _CEILING if highest else high - _HALF_WALL
        return Cell(-side, side, bottom, top, case.rear, humped=lowest, top=highest)

    @cached_property
    def _edge(self) -> ag.Scalar:
        return self.case.width / 2 - _INSET

    def _door(
        self, cell: Cell, low: ag.Scalar, high: ag.Scalar, handle: Literal["low", "middle", "high"] = "middle"
    ) -> Leaf:
        return self._wide("door", cell, low, high, self.ridge, self.bins, handle)

    def _freezer(self, cell: Cell, low: ag.Scalar, high: ag.Scalar, handle: Literal["low", "high"]) -> Leaf:
        return self._wide("freezer_door", cell, low, high, self.freezer_ridge, max(1, self.bins - 1), handle)

    def _wide(
        self,
        name: str,
        cell: Cell,
        low: ag.Scalar,
        high: ag.Scalar,
        ridge: ag.Scalar | None,
        bins: int,
        handle: Literal["low", "middle", "high"],
    ) -> Leaf:
        """Make a door as wide as the cabinet, between two heights."""
        edge, case = self._edge, self.case
        return Leaf(name, name, case, cell, -edge, edge, low, high, cell.right, ridge, bins, handle=handle)

    def _fronts(self, low: ag.Scalar, high: ag.Scalar) -> tuple[Front, ...]:
        """Divide the freezer into drawers of equal fronts."""
        count, half = self.drawers, self.case.gap / 2
        lowest = (high - low) / count - _FLOOR - _HALF_WALL  # height of the lowest cell
        high = ag.require(
            high,
            lowest > HUMP_HIGH - 1.5 * _HALF_WALL,  # the top of the machine room is in the wall above it
            "the lowest drawer would strike the machine room behind it: raise freezer_share or height, "
            "or lower outer_drawers or kick_height",
        )
        edges = [low + (high - low) * index / count for index in range(count + 1)]
        fronts = []
        for index in range(count):
            bottom, top = edges[index], edges[index + 1]
            cell = self._cell(bottom, top, lowest=index == 0)
            start = bottom if index == 0 else bottom + half
            fronts.append(Front(cell, -self._edge, self._edge, start, top - half))
        return tuple(fronts)

    def _pair(self, cell: Cell, low: ag.Scalar, high: ag.Scalar) -> tuple[Leaf, Leaf]:
        """Make two doors that meet in the middle."""
        edge, half = self._edge, -0.5 * self.case.gap
        left, right = (
            Leaf(
                "door",
                f"door_{side}",
                self.case,
                cell,
                -edge,
                half,
                low,
                high,
                -0.5 * _PASSES,
                self.ridge,
                self.bins,
                mirrored=side == "right",
                meets=True,
            )
            for side in ("left", "right")
        )
        return left, right

    def _abreast(self, low: ag.Scalar, high: ag.Scalar) -> Plan:
        """Divide the width of the cabinet, with the freezer at the left."""
        case, half = self.case, self.case.gap / 2
        whole = self._cell(low, high, lowest=True, highest=True)
        split = -0.5 * case.width + self.share * case.width
        narrower = ag.min_(split - whole.left, whole.right - split) - _HALF_WALL
        split = ag.require(split, narrower > LIGHT + 0.01, _NO_LIGHT)
        frozen = Cell(
            whole.left, split - _HALF_WALL, whole.low, whole.high, whole.rear, humped=True, top=True
        )
        cold = Cell(split + _HALF_WALL, whole.right, whole.low, whole.high, whole.rear, humped=True, top=True)
        freezer = Leaf(
            "freezer_door", "freezer_door", case, frozen, -self._edge, split - half, low, high,
            frozen.right, self.freezer_ridge, max(1, self.bins - 1), meets=True,
        )  # fmt: skip
        turned = cold.mirrored()
        door = Leaf(
            "door", "door", case, turned, -self._edge, -(split + half), low, high,
            turned.right, self.ridge, self.bins, mirrored=True, meets=True,
        )  # fmt: skip
        return Plan(cold, (frozen,), (door,), freezer, abreast=True)


def hinges(plan: Plan, case: Case, *, cover: ag.Material, metal: ag.Material) -> list[ag.Body]:
    """Make the covers over the hinges on top of the cabinet, and the brackets under the doors."""
    bodies = []
    for leaf in plan.leaves:
        x, y = leaf.left + PIN, case.front + PIN
        fixed = [
            hinge_bracket(finish=metal, way=-1, inset=PIN, back=case.mouth - y).at(
                x, y, leaf.low - case.gap / 2
            )
        ]
        if leaf.cell.top:
            fixed.append(hinge_cover(finish=cover, way=-1, inset=PIN).at(x, y, case.top))
        bodies += [each.mirror(ag.X) if leaf.mirrored else each for each in fixed]
    return bodies
