"""Kitchens: rows of base units under worktops with appliances, a sink and a hood, and wall units above."""

import math
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from typing import Any, Literal, get_args

import numpy as np

from artgen.asset import Asset
from artgen.asset.asset import DetailName
from artgen.categories.cooktop.case import THICK as PLATES
from artgen.categories.range_hood.parts import TAB
from artgen.errors import ParameterError
from artgen.scene.furnish import (
    DEEP,
    DOORWAY,
    FACE,
    FRONT,
    KICK,
    OVER,
    PLINTH,
    SETBACK,
    UNDER,
    Furnisher,
    Hole,
    Span,
    check_room,
    drawn,
    width_of,
)
from artgen.scene.room import GAP, STANDING, Line, Wall

Layout = Literal["one_wall", "galley", "l", "u", "island"]
"""Rows of units: along the back wall, along both side walls, round one or two corners, or with an island."""

_BOARD = 0.018  # thickness of the boards of a housing [m]
_BAR = 0.25  # of the worktop of an island over its back [m]
_STOOLS = 0.5  # before the bar of an island, for stools [m]
_SHALLOW = 0.33  # of the carcass of wall units [m]
_MARGIN = 0.05  # filler between a row and a wall, which lets doors open [m]
_SWINGS = 0.12  # space between a refrigerator and a wall, for its open door and its handle [m]
_NEAR = 0.08  # distance from a wall within which a row ends with a filler [m]
_CORNER = 0.95  # of each wall that a corner unit takes [m]
_WALL_CORNER = 0.62  # of each wall that a wall unit in a corner takes [m]
_POST = 0.045  # on both sides of a corner unit, so that its door clears those beside it [m]
_NARROW, _UNIT, _WIDE = 0.4, 0.58, 0.9  # least, usual and greatest width of a unit [m]
_SINK = 0.6  # least width of a sink unit [m]
_COOKS = 1.56  # height of a hood above the floor [m]
_ABOVE, _HUNG = 1.45, 0.72  # bottom and height of the wall units [m]
_SASHES = 0.61  # least width of a window with two sashes [m]
_SILL = 0.06  # by which the sill of a window is wider at each end [m]
_AISLE = 1.15  # least width between two rows [m]
_SPANS: dict[Layout, tuple[Span, Span]] = {
    "one_wall": ((3.0, 4.6), (2.4, 3.0)),
    "galley": ((2.5, 3.0), (3.0, 3.6)),
    "l": ((3.0, 4.0), (2.9, 3.5)),
    "u": ((3.1, 3.8), (2.9, 3.5)),
    "island": ((3.6, 4.6), (3.3, 4.0)),
}
"""Widths and depths of drawn rooms [m]."""

_LEAST: dict[Layout, tuple[float, float]] = {
    "one_wall": (3.0, 1.8), "galley": (2.5, 2.6), "island": (3.4, 3.2),
}  # fmt: skip
"""Least width and depth of rooms in which a layout is drawn [m]; those with corners are made on request."""


def kitchen(
    seed: int = 0,
    *,
    width: float | None = None,
    depth: float | None = None,
    detail: DetailName = "full",
    layout: Layout | None = None,
) -> Asset:
    """Return a kitchen, proven free of collisions in all states of all its joints.

    It has a refrigerator, a range or an oven under a cooktop, a hood, a dishwasher, a sink with a faucet,
    base units with drawers and doors, wall units, a microwave, a window and a door.

    Args:
        seed: Seed of the layout and of all assets.
        width: Length of the back wall [m]; drawn by default.
        depth: Depth of the room [m]; drawn by default.
        detail: Level of detail of the assets.
        layout: Rows of units: `one_wall`, `galley` or `island`, one of these by default; or `l` and `u`,
            which have corner units.

    Raises:
        ParameterError: The room is too small; the message has the length that is missing.
        AssetError: No draw is free of collisions.
    """
    if layout is not None and layout not in get_args(Layout):
        raise ParameterError(f"layout = {layout!r} is not allowed: it must be one of {', '.join(_SPANS)}")
    check_room(seed, (width, depth))
    return drawn(
        f"kitchen {seed}", lambda attempt: _Kitchen(seed, attempt, (width, depth), detail, layout).furnish()
    )


@dataclass(frozen=True)
class _Item:
    """An appliance, a sink or a base unit in a row."""

    kind: str  # an appliance, `sink`, `hob` or `unit`
    width: float  # [m]
    values: dict[str, Any] = field(default_factory=dict)  # parameters of the asset


@dataclass
class _Row:
    """Items from left to right along a wall; a number stands for base units, which fill low numbers first."""

    wall: Wall | Line
    start: float  # from the left end of the wall to the row [m]
    end: float  # from the left end of the wall to the end of the row [m]
    items: list[_Item | int]
    free: Literal["", "left", "right"] = ""  # end at which space may be left
    island: bool = False

    @property
    def widths(self) -> float:
        """Width of all items with a gap after each [m]."""
        return sum(each.width + GAP for each in self.items if isinstance(each, _Item))


def _beside(items: Sequence[_Item], number: int, kind: str) -> list[str]:
    """Return the sides of an item of a row at which the next one is of a kind."""
    ends = (("left", number - 1), ("right", number + 1))
    return [side for side, other in ends if 0 <= other < len(items) and items[other].kind == kind]


class _Kitchen(Furnisher):
    """A draw of a kitchen."""

    def __init__(
        self,
        seed: int,
        attempt: int,
        size: tuple[float | None, float | None],
        detail: DetailName,
        layout: Layout | None,
    ) -> None:
        fits = [
            name
            for name, least in _LEAST.items()
            if all(given is None or given >= most for given, most in zip(size, least, strict=True))
        ]
        chosen = np.random.default_rng((seed, attempt)).integers(max(len(fits), 1))
        self.layout: Layout = layout or (fits[chosen] if fits else "one_wall")
        super().__init__("kitchen", seed, attempt, size, _SPANS[self.layout], detail)
        self.units = 0  # number of base units so far
        # places of free objects: `deep` leaves a hand over them clear of the sill of a window
        self.objects: list[tuple[str, dict[str, Any], dict[str, Any]]] = [
            ("microwave", {"depth": 0.42}, {"deep": 0.9}),  # a hand has room before its lowest keys
            ("kettle", {}, {"deep": 0.3, "turn": math.pi}),  # its handle is behind its spout
            ("pepper_grinder", {}, {"deep": 0.3}),
            ("toaster", {}, {"deep": 0.8}),  # its tray slides out behind it
            ("bottle", {"style": "screw"}, {"deep": 0.2}),
        ]

    def furnish(self) -> Asset:
        """Return the kitchen."""
        for row in self._rows():
            self._furnish(row)
        return self.build(layout=self.layout)

    def _rows(self) -> list[_Row]:
        """Return the rows of the layout, and set corner units and the door."""
        width, depth = self.width, self.depth
        flip = bool(self.draw.random() < 0.5)
        cold, hob = self._cold(), self._hob()
        dishwasher = self._dishwasher()
        sink = _Item("sink", self.uniform(_SINK, 0.7 if width > 3.3 else _SINK))
        washing: list[_Item | int] = [dishwasher, sink]
        if self.draw.random() < 0.5:
            washing.reverse()
        if self.layout in ("galley", "u") and (missing := 2.0 * FACE + _AISLE - width) > 0.0:
            raise ParameterError(
                f"a kitchen of {width:.3f} m is too narrow for layout={self.layout}: between its rows, "
                f"{missing:.3f} m are missing"
            )
        if self.layout == "galley":
            self.door("back", (width - DOORWAY) / 2.0)
            return [
                _Row("left", 0.0, depth - _MARGIN, [1, *washing, 0], "left"),
                _Row("right", _MARGIN, depth, [1, hob, 0, cold], "right"),
            ]
        if self.layout == "l":
            self._corner("right" if flip else "left")
            self.door("left" if flip else "right", 0.0 if flip else depth - DOORWAY)
            if flip:
                return [
                    _Row("back", _MARGIN, width - _CORNER, [0, *washing, 1]),
                    _Row("right", _CORNER, depth, [0, hob, 1, cold], "right"),
                ]
            return [
                _Row("left", 0.0, depth - _CORNER, [cold, 1, hob, 0], "left"),
                _Row("back", _CORNER, width - _MARGIN, [1, *washing, 0]),
            ]
        if self.layout == "u":
            self._corner("left")
            self._corner("right")
            self.door("right", depth - DOORWAY)
            return [
                _Row("left", 0.0, depth - _CORNER, [cold, 1, dishwasher, 0], "left"),
                _Row("back", _CORNER, width - _CORNER, [1, sink, 0]),
                _Row("right", _CORNER, depth - DOORWAY, [0, hob, 1], "right"),
            ]
        self.door("right", depth - DOORWAY)
        at_back = self.layout == "one_wall" or self.draw.random() < 0.5
        items: list[_Item | int] = [cold, 2, *washing, 0, *([hob, 1] if at_back else ())]
        ends = (_MARGIN, width - _SWINGS) if flip else (_SWINGS, width - _MARGIN)
        rows = [_Row("back", *ends, items[::-1] if flip else items)]
        if self.layout == "island":
            rows.append(self._island([] if at_back else [hob]))
        return rows

    def _island(self, items: list[_Item | int]) -> _Row:
        """Return the row of an island, which faces the room or the back wall."""
        spare = self.depth - 2.0 * FACE - _AISLE - _BAR - 0.3
        if spare < 0.0:
            raise ParameterError(
                f"a kitchen of {self.depth:.3f} m is too shallow for an island: {-spare:.3f} m are missing"
            )
        length = min(self.width - 1.7, self.uniform(1.5, 2.4))
        away = self.draw.random() < 0.4  # whether it faces the back wall
        y = -FACE - _AISLE - (FACE if away else _BAR) - 0.3 * spare
        ends: Line = ((-length / 2.0, y), (length / 2.0, y))
        line = (ends[1], ends[0]) if away else ends
        self.board("panel", line, (0.0, length), (0.0, 0.02), (0.0, UNDER))
        if away and self.depth + y - _BAR > _STOOLS:
            # a back would meet the bar
            alike: dict[str, Any] = {"style": "bar", "backed": False, "height": 0.64, "width": 0.36}
            alike |= {"cover": self.choice("oak", "walnut", "black_leather"), "metal": "chrome"}
            for number, share in enumerate((-0.25, 0.25)):
                self.stand("chair", f"stool_{number}", share * length, y - _BAR - 0.25, sway=0.6, **alike)
        return _Row(line, 0.0, length, [0, *items, 1] if items else [0], island=True)

    def _corner(self, side: Wall) -> None:
        """Set a base unit and a wall unit across the corner of the back wall and a side wall."""
        sign, root = (1.0 if side == "left" else -1.0), math.sqrt(2.0)
        wall = -sign * self.width / 2.0
        for name, long, deep, z, high in (
            ("corner_unit", _CORNER, DEEP, 0.0, UNDER),
            ("corner_wall_unit", _WALL_CORNER, _SHALLOW, _ABOVE, _HUNG),
        ):
            front = GAP + deep
            back = (min(deep, 0.3) if z else deep) + GAP  # from the fronts to the line behind the unit
            line = [(wall + sign * (front - back / root), -long + back / root)]
            line.append((wall + sign * (long - back / root), -front + back / root))
            if side == "right":
                line.reverse()
            across = (long - front) * root
            kind: dict[str, Any] = {"kind": "base", "stand": "plinth", **PLINTH, **self.base}
            if z:
                kind = {"kind": "wall", **self.fronts}
            self.room.against(
                (line[0], line[1]), "cabinet", at=_POST, z=z, name=f"{name}_{side}", **kind,
                doors=1, width=across - 2.0 * _POST, depth=back - GAP, height=high, top="flush",
                swing=1.35, hand=self.choice("left", "right"),
            )  # fmt: skip
            for at in (0.0005, across - _POST + 0.0005):
                ends = (at, at + _POST - 0.001)
                foot = z or KICK
                self.board("filler", (line[0], line[1]), ends, (-back, 0.02 - back), (foot, z + high))
        half = self.width / 2.0
        plan = [(0.0, 0.0), (_CORNER, 0.0), (_CORNER, -FRONT), (FRONT, -_CORNER), (0.0, -_CORNER)]
        self.lay([(sign * (x - half), y) for x, y in plan], [], None)

    def _cold(self) -> _Item:
        # drawers behind its doors need doors that open by 120 degrees, into what stands beside it
        values: dict[str, Any] = {
            "build": "tall", "crispers": 0, "freezer_drawers": 0, "ice_box": False, "swing": 1.6,
            "grip": "bar",  # walls and neighbors would be in the way of a hand in the edge of a door
        }  # fmt: skip
        if self.width < 3.4 or self.layout in ("l", "u", "galley"):
            values |= {"layout": self.choice("single", "bottom_freezer", "top_freezer"), "width": 0.6}
        return self._appliance("refrigerator", **values)

    def _dishwasher(self) -> _Item:
        size = "slim" if self.width < 3.4 else self.choice("full", "slim")
        # a third rack has its grip behind the edge of the worktop, and a pocket in the door is under it
        values = {"size": size, "racks": 2, "handle": self.choice("bar", "bar", "recessed")}
        return self._appliance("dishwasher", build="built_in", height=UNDER, **values)

    def _hob(self) -> _Item:
        """Return a range, or a built-in oven under a cooktop."""
        if self.layout != "island" and self.draw.random() < 0.4:
            return self._appliance("oven", build="range", width=0.6)
        oven = self._appliance("oven", build="built_in", depth=0.6, height=0.6)
        return _Item("hob", oven.width + 2.0 * (_BOARD + 0.002), oven.values)

    def _appliance(self, category: str, **values: Any) -> _Item:
        return _Item(category, width_of(self.room.draw(category, name=category, **values)), values)

    def _furnish(self, row: _Row) -> None:
        """Place the items of a row, its worktops, and what is above it."""
        items = self._with_units(row)
        spare = row.end - row.start - sum(each.width + GAP for each in items) + GAP
        at = row.start + (spare if row.free == "left" else 0.0)
        if not row.free:
            number = [each.kind for each in items].index("sink") if not row.island else 0
            items[number] = replace(items[number], width=items[number].width + spare)
        placed: list[tuple[_Item, float]] = []
        holes: list[Hole] = []
        for number, item in enumerate(items):
            placed.append((item, at))
            # doors would meet the front of a range or the door of a dishwasher beside them
            beside = {each.kind for each in items[max(number - 1, 0) : number + 2]}
            if item.kind == "sink":
                self.sink(row.wall, at, item.width, holes, _beside(items, number, "dishwasher"))
            else:
                self._place(row, item, at, holes, doors=beside <= {"unit", "sink", "hob"})
            at += item.width + GAP
        self._cover(row, placed, holes)
        self._stand(row, placed)
        self._hang(row, placed)

    def _with_units(self, row: _Row) -> list[_Item]:
        """Return the items of a row with units of one width in the place of the numbers."""
        spare = row.end - row.start - row.widths + GAP
        slots = sorted(each for each in row.items if isinstance(each, int))
        count = max(round(spare / _UNIT), 0 if row.free else math.ceil(spare / (_WIDE + GAP)), 0)
        while count > 0 and spare / count - GAP < _NARROW:
            count -= 1
        if self.layout == "one_wall" and count == 0:
            raise ParameterError(
                f"a kitchen of {self.width:.3f} m is too narrow: with a refrigerator, a dishwasher "
                f"and an oven, "
                f"{_NARROW + GAP - spare:.3f} m are missing for a sink and a base unit"
            )
        if spare < 0.0:
            kinds = ", ".join(each.kind for each in row.items if isinstance(each, _Item))
            raise ParameterError(
                f"a kitchen of {self.width:.3f} x {self.depth:.3f} m is too small for layout={self.layout}: "
                f"beside {kinds}, {-spare:.3f} m are missing"
            )
        width = min(spare / count - GAP, _WIDE) if count else 0.0
        result: list[_Item] = []
        for each in row.items:
            if isinstance(each, _Item):
                result.append(each)
            else:
                share = [slots[number % len(slots)] for number in range(count)].count(each)
                result += [_Item("unit", width)] * share
        return result

    def _place(self, row: _Row, item: _Item, at: float, holes: list[Hole], *, doors: bool) -> None:
        """Place an item; a unit has drawers, or doors if it may."""
        if item.kind == "unit":
            doors = doors and self.units % 2 == 1
            unit = self.unit(row.wall, at, item.width, doors=doors)
            if not doors and self.units == 0:
                with suppress(ParameterError):  # long pliers fit into no narrow drawer, open ones tip over
                    self.room.inside(unit, "drawer_0", "plier", at=0.3, turn=0.2, name="plier_in_drawer")
            self.units += 1
        elif item.kind == "hob":
            self._oven_unit(row.wall, at, item, holes)
        elif item.kind == "refrigerator":
            hand = "right" if at < 0.5 * (row.start + row.end) else "left"
            self.room.against(row.wall, "refrigerator", at=at, name="refrigerator", **item.values, hand=hand)
        else:
            self.room.against(row.wall, item.kind, at=at, name=item.kind, **item.values)

    def _oven_unit(self, wall: Wall | Line, at: float, item: _Item, holes: list[Hole]) -> None:
        """Place an oven in a housing of boards, and a cooktop over it."""
        board, width = _BOARD, item.width
        oven = self.room.draw("oven", name="oven", **item.values)
        high = float(np.ptp(oven.bounds()[:, 2]))
        burners = self.choice(4, 4, 5) if width > 0.8 else 4
        hob = {
            "burners": burners,
            "rows": 2,
            "width": 0.58,
            "depth": 0.51,
            "dials_at": self.choice("front", "right"),
        }
        top = self.room.draw("cooktop", name="cooktop", **hob)
        case = top.parameters["height"] - PLATES[top.parameters["burner"]]
        foot = OVER - case - 0.012 - high  # of the oven
        sides, back = ((at, at + board), (at + width - board, at + width)), (-GAP - DEEP, -GAP)
        for x in sides:
            self.board("panel", wall, x, back, (0.0, UNDER))
        inner = (at + board, at + width - board)
        self.board("panel", wall, inner, back, (foot - board - 0.001, foot - 0.001))
        self.board("panel", wall, (at, at + width), (-FACE + 0.001, back[0] - 0.001), (KICK, foot - 0.003))
        self.board("plinth", wall, inner, (back[0] + SETBACK, back[0] + SETBACK + 0.016), (0.0, KICK))
        self.board(
            "panel", wall, (at, at + width), (-FACE + 0.001, back[0] - 0.001), (foot + high + 0.003, UNDER)
        )
        self.room.against(wall, "oven", at=at + board + 0.002, z=foot, name="oven", **item.values)
        middle, y = at + width / 2.0, -FRONT / 2.0 - 0.01
        below = [each.convex.bounds() for each in top.links[0].colliders]
        below = [each for each in below if each[1, 2] < case + 0.0005]
        (x0, y0, _), (x1, y1, _) = np.min(below, axis=0)[0], np.max(below, axis=0)[1]
        holes.append((middle + x0 - 0.002, middle + x1 + 0.002, y + y0 - 0.002, y + y1 + 0.002))
        self.let_in(wall, "cooktop", (middle, y, OVER + STANDING - case), hob)

    def _cover(self, row: _Row, placed: list[tuple[_Item, float]], holes: list[Hole]) -> None:
        """Lay worktops over neighboring items, and fill the ends at walls."""
        runs: list[list[tuple[_Item, float]]] = [[]]
        for each in placed:
            if each[0].kind in ("refrigerator", "oven"):
                runs.append([])
            else:
                runs[-1].append(each)
        length = self.room.frame(row.wall)[1]
        for run in filter(None, runs):
            low, high = run[0][1], run[-1][1] + run[-1][0].width
            if not row.island and low <= _NEAR:
                self._filler(row.wall, GAP, low - GAP)
                low = 0.001
            if not row.island and length - high <= _NEAR:
                self._filler(row.wall, high + GAP, length - GAP)
                high = length - 0.001
            edge = _BAR if row.island else 0.0
            outline = [(low, -FRONT), (high, -FRONT), (high, edge), (low, edge)]
            near = [hole for hole in holes if low - 0.01 < hole[0] and hole[1] < high + 0.01]
            self.lay(outline, near, row.wall)

    def _stand(self, row: _Row, placed: list[tuple[_Item, float]]) -> None:
        """Stand free objects on the worktop over base units."""
        tops = [each for each in self.room.placed if each.asset.category == "worktop"]
        for item, at in placed:
            middle = at + item.width / 2.0
            for category, values, place in self.objects if item.kind == "unit" else []:
                width = width_of(self.room.draw(category, name=category, **values))
                if width > item.width:
                    continue  # it would stand over the sink or the burners beside the unit
                top = next(
                    each
                    for each in reversed(tops)
                    if each.asset.bounds()[0, 0] < middle < each.asset.bounds()[1, 0]
                )
                low, high = top.asset.bounds()[:, 0]
                share = min(max((middle - width / 2.0 - low) / (high - low - width), 0.03), 0.97)
                self.room.on(top, category, at=share, free=True, name=category, **place, **values)
                self.objects.remove((category, values, place))
                break

    def _filler(self, wall: Wall | Line, low: float, high: float) -> None:
        """Fill the space between a row and a wall."""
        if high - low > 0.005:
            face = -GAP - DEEP
            self.board("filler", wall, (low, high), (face, face + 0.02), (KICK, UNDER))
            foot = (face + SETBACK, face + SETBACK + 0.016)
            self.board("plinth", wall, (low, high), foot, (0.0, KICK - 0.001))

    def _hang(self, row: _Row, placed: list[tuple[_Item, float]]) -> None:
        """Hang wall units over base units, a hood over the burners, and a window over the sink."""
        for item, at in placed:
            low, high = at, at + item.width
            if item.kind in ("oven", "hob"):
                self._hood(row, low + 0.02, high - 0.02)
            elif item.kind == "sink" and isinstance(row.wall, str):
                middle = 0.5 * (low + high)
                tall = [
                    abs(middle - end)
                    for each, start in placed
                    if each.kind == "refrigerator"
                    for end in (start, start + each.width)
                ]
                width = min([0.9, *(2.0 * (space - _SILL) for space in tall)])
                if width >= _SASHES:
                    self.window(row.wall, middle, width=width)
        sink = [at + item.width / 2.0 for item, at in placed if item.kind == "sink"]
        items = [item for item, _ in placed]
        for number, (item, at) in enumerate(placed):
            beside = all(at > middle + 0.52 or at + item.width < middle - 0.52 for middle in sink)
            if item.kind in ("unit", "dishwasher") and beside and not row.island:
                # a hand has no room beside a refrigerator, which is deeper
                sides = _beside(items, number, "refrigerator")
                self.hang(row.wall, at, item.width, *sides[:1])

    def _hood(self, row: _Row, low: float, high: float) -> None:
        """Hang a hood, whose chimney ends at the ceiling, on a wall or over an island."""
        style = "island" if row.island else self.choice("chimney", "chimney", "glass", "inclined")
        width = 0.898 if row.island else min(high - low, 0.898)
        tall = self.room.size[2] - _COOKS - TAB - 0.001
        at = 0.5 * (low + high - width)
        self.room.against(
            row.wall, "range_hood", at=at, z=_COOKS, name="hood", style=style, width=width, height=tall
        )
