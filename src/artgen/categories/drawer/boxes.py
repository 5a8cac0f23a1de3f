"""Drawer boxes with their fronts, on runners, and their places in a carcass."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import reduce
from typing import Literal

import artgen as ag
from artgen import details, feel
from artgen.categories.shared.fixings import screws
from artgen.categories.shared.fronts import FrontLook, front
from artgen.categories.shared.furniture import CREAM_STEEL, ZINC, Carcass
from artgen.categories.shared.locks import plug
from artgen.categories.shared.pulls import GROOVE
from artgen.categories.shared.shelves import open_box
from artgen.nodes.joint import SoftClosing

RunnerStyle = Literal["roller", "ball"]  # coated angles with rollers, or telescopic runners on balls
Mounting = Literal["overlay", "inset"]  # position of fronts: on the edges of the carcass or between them

INDEXES = ("A-F", "G-K", "L-R", "S-Z", "2021", "2022", "2023", "2024")  # texts of the cards

_RUNNERS = {"roller": (0.030, CREAM_STEEL), "ball": (0.042, ZINC)}  # height [m], and steel
_MEMBER = 0.0052  # thickness of each member of a runner; a gap of 2.1 mm is between them [m]
_PLAY = 0.0125  # gap between the side of a drawer and the face beside it [m]
_GAP = 0.003  # gap between two fronts, or around a front between boards [m]
_SHADOW = 0.020  # gap above a groove for fingers from above [m]
_BEHIND = 0.002  # gap between an overlaid front and the carcass [m]
_MARGIN = 0.0015  # distance from overlaid fronts to the outlines of the carcass [m]
_UNDER = 0.014  # space under the box of a drawer [m]
_OVER = 0.016  # space above the box [m]
_REAR = 0.018  # space behind the box [m]
_BITE = 0.0003  # overlap of joined boards [m]
_HAND = 60.0  # largest pull of a hand [N]


@dataclass(frozen=True)
class Boxes:
    """Finish and dimensions of drawer boxes."""

    sides: ag.Material  # material of sides, back and inner front
    bottom: ag.Material  # material of the bottom
    wall: ag.Scalar  # thickness of sides, back and inner front [m]
    runner: RunnerStyle  # style of the runners
    tallest: ag.Scalar  # largest height of the sides [m]
    # whether runners, and rails behind grooves, have mass and collide; with many drawers they are visual
    # only, because simulators test all pairs of close colliders
    solid: bool


class Bays:
    """Places of the drawers in a carcass, with the relative heights of the rows from the top."""

    def __init__(
        self,
        case: Carcass,
        boxes: Boxes,
        mounting: Mounting,
        columns: int,
        weights: Sequence[ag.Scalar],
        thick: ag.Scalar,
        *,
        groove: bool,
        deck: ag.Scalar | None,
    ) -> None:
        self.case, self.boxes, self.thick, self.groove, self.deck = case, boxes, thick, groove, deck
        self.inset = mounting == "inset"
        board = case.thick
        # width between the boards beside a drawer, and middles of the columns along x [m]
        self.cell = (2 * case.right - (columns - 1) * board) / columns
        self.middles = [(at - (columns - 1) / 2) * (self.cell + board) for at in range(columns)]
        floor = case.floor if deck is None else deck
        if self.inset:  # with rails between the fronts
            bottom, top, apart = floor + _GAP, case.ceiling - _GAP, board + 2 * _GAP
            half, face = self.cell / 2 - _GAP, case.front
        else:
            bottom = case.low + _MARGIN if deck is None else deck - board / 2
            top, apart = case.high - (_SHADOW if groove else _MARGIN), _SHADOW if groove else _GAP
            half, face = (self.cell + board - _GAP) / 2, case.front - _BEHIND - thick
        self.face, self.begin = face, face + thick - _BITE  # of shut drawers, and of their boxes, along y [m]
        self.deep = case.behind - _REAR - self.begin  # depth of boxes [m]
        edges = [(middle - half, middle + half) for middle in self.middles]
        if not self.inset:  # the outer fronts end before the outline
            edges[0] = (_MARGIN - case.width / 2, edges[0][1])
            edges[-1] = (edges[-1][0], case.width / 2 - _MARGIN)
        unit = (top - bottom - (len(weights) - 1) * apart) / reduce(lambda a, b: a + b, weights)
        whole = ag.Region((0.0, 0.0), (face, face + thick), (bottom, top))
        rows = whole.stack(*(weight * unit for weight in weights), gap=apart)
        self.fronts = [[row.with_(x=edge) for edge in edges] for row in rows]
        # heights above the lower edge of a front and below its upper edge that boards or a groove take [m]
        lower: list[ag.Scalar] = [0.0 for _ in weights]
        upper: list[ag.Scalar] = [0.0 for _ in weights]
        if not self.inset:
            lower[-1] = floor - bottom if deck is None else board / 2
            upper = [GROOVE for _ in weights] if groove else [board - _MARGIN, *upper[1:]]
        self.taken = list(zip(lower, upper, strict=True))

    def between(self) -> list[ag.Body]:
        """Make the partitions between columns and the rails between rows."""
        case, half = self.case, self.cell / 2
        pairs = zip(self.middles, self.middles[1:], strict=False)
        bodies = [case.partition((left + right) / 2, low=self.deck) for left, right in pairs]
        if not (self.inset or self.groove):
            return bodies
        solid = self.boxes.solid or self.inset
        for (above, *_), (below, *_) in zip(self.fronts, self.fronts[1:], strict=False):
            low, high = below.z.high - 0.022, above.z.low + 0.004  # behind a groove
            if self.inset:
                low, high = below.z.high + _GAP, above.z.low - _GAP
            z, tall = (low + high) / 2, high - low
            bodies += [case.rail(x - half, x + half, z, high=tall, solid=solid) for x in self.middles]
        return bodies

    def _sizes(self, row: int) -> tuple[ag.Scalar, ag.Scalar, ag.Scalar]:
        """Return the start of a box above its front's lower edge, its height, the middle of the runners."""
        floor, over = self.taken[row]
        base = floor + _UNDER
        tall = ag.min_(self.fronts[row][0].z.size - base - over - _OVER, self.boxes.tallest)
        tall = ag.require(tall, tall >= 0.012, "drawers are too low: have fewer rows or a greater height")
        return base, tall, base + (0.017 if self.boxes.runner == "roller" else 0.42 * tall)

    def box(self, row: int) -> ag.Body:
        """Make the box of the drawers of a row with its members of the runners: the link `drawer`."""
        look, (base, tall, z) = self.boxes, self._sizes(row)
        wide, begin = self.cell - 2 * _PLAY, self.begin
        boards = open_box(wide, self.deep, tall, wall=look.wall, front=look.wall, floor=0.006)
        inner, bottom, *others = (each.at(0, begin, base) for each in boards)
        high, steel = _RUNNERS[look.runner]
        start, side = begin + look.wall, wide / 2
        length = self.deep - look.wall - 0.004
        y, half = (start, start + length), high / 2 - 0.005
        rail = ag.Region((side - 0.0003, side + _MEMBER), y, (z - half, z + half)).box(bevel=0.0008)
        places = [(side + _MEMBER, start + share * length, z) for share in (0.12, 0.5, 0.88)]
        heads = screws(places, facing="+x", radius=0.0032, finish=steel, sunk=0.0008)
        return ag.weld(
            ag.part(inner, "drawer", look.sides),
            ag.part(bottom, "drawer", look.bottom),
            ag.part(others, "drawer", look.sides),
            *self._both(rail, *heads),
        )

    def _both(self, rail: ag.Solid, *more: ag.Body) -> list[ag.Body]:
        """Make members of a runner at both sides."""
        _, steel = _RUNNERS[self.boxes.runner]
        make = ag.part if self.boxes.solid else ag.detail
        member = ag.weld(make(rail, "runner", steel), *more)
        return [member, member.mirror(ag.X)]

    def fixed_members(self) -> list[ag.Body]:
        """Make the members of the runners on the carcass."""
        high, steel = _RUNNERS[self.boxes.runner]
        inner, y = self.cell / 2 - _MEMBER, (self.begin + 0.004, self.begin + self.deep - 0.004)
        rail = ag.Region((inner, self.cell / 2 + 0.0003), y, (-high / 2, high / 2))
        # lips wrap around the drawer's member
        lip = ag.Region((inner - 0.0018, inner + 0.0005), y, (-0.0015, 0.0015)).shrink(y=0.001).box()
        edge = high / 2 - 0.0015
        ends = (-1, 1) if self.boxes.runner == "ball" else (-1,)
        more = [ag.detail(ag.array(lip, at=[(0, 0, end * edge) for end in ends]), "runner", steel)]
        if self.boxes.runner == "roller":
            wheel = ag.cylinder(0.010, 0.0022, axis=ag.X, bevel=0.0006)
            wheel = wheel.at(inner - 0.0006, self.begin + 0.018)
            more.append(ag.detail(wheel, "runner", ag.material("abs")))
        members = self._both(rail.box(bevel=0.0008), *more)
        levels = [fronts[0].z.low + self._sizes(row)[2] for row, fronts in enumerate(self.fronts)]
        return [each.at(x, 0, z) for z in levels for x in self.middles for each in members]

    def drawer(
        self, row: int, column: int, look: FrontLook, box: ag.Body, fixtures: Sequence[ag.Body]
    ) -> ag.Body:
        """Make a drawer about the lower edge of its front: the link `drawer`."""
        place = self.fronts[row][column]
        aside = place.x.mid - self.middles[column]
        # below the edge of the groove
        slab = place.z.size - GROOVE + 0.0004 if self.groove else place.z.size
        boards = front(look, place.x.size, slab, self.thick, label="front")
        return ag.weld(
            box,
            *(each.at(aside, place.y.mid, slab / 2) for each in boards),
            *(each.at(aside, self.face, 0) for each in fixtures),
        )

    def slide(
        self,
        row: int,
        column: int,
        *,
        share: ag.Scalar,
        friction: ag.Scalar,
        damping: ag.Scalar,
        closing: SoftClosing | None = None,
    ) -> ag.Joint:
        """Make the slide of a drawer, whose box comes out by a share of its depth."""
        name = f"drawer_slide_{row * len(self.middles) + column}"
        pivot = (0, self.face, self.fronts[row][column].z.size / 2)
        drag = feel.Feel(friction=friction, damping=damping, effort=_HAND)
        return ag.Prismatic(
            name, axis=-ag.Y, pivot=pivot, limits=(0.0, share * self.deep), feel=drag, closing=closing
        )


def label_holder(z: ag.Scalar, metal: ag.Material, index: str) -> list[ag.Body]:
    """Make a label holder and its card."""
    wide, high = 0.078, 0.030
    rim = ag.rectangle(wide, high, radius=0.003) - ag.rectangle(wide - 0.010, high - 0.011).at(0, 0.0015)
    frame = ag.extrude(rim, 0.0026, axis=ag.Y, bevel=0.0007).at(0, -0.0008, z)
    paper = ag.colored("abs", "white").with_(name="card", specular_roughness=0.85)
    card = ag.box(wide - 0.009, 0.0008, high - 0.010).at(0, -0.0003, z + 0.0015)
    ink = ag.material("black_abs")
    return [
        ag.detail(frame, "label_holder", metal),
        ag.detail(card, "label_holder", paper),
        details.printed(ag.text(index, 0.010), (0, -0.0007, z - 0.0035), material=ink),
    ]


def lock(x: ag.Scalar, z: ag.Scalar) -> list[ag.Body]:
    """Make the cylinder of a lock, visual only."""
    chrome = ag.material("chrome")
    collar = ag.extrude(ag.ring(0.0115, 0.0070), 0.0030, axis=ag.Y, bevel=0.0009).at(x, -0.0011, z)
    cylinder = plug(face=0.0004, side=-1, finish=chrome, radius=0.0072)
    return [ag.detail(collar, "lock", chrome), *(each.at(x, 0, z) for each in cylinder)]
