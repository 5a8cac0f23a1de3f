"""Drawer boxes with their fronts, on runners."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details
from artgen._arrays import cached_property
from artgen.categories.shared.fixings import screws
from artgen.categories.shared.fronts import FrontLook, front
from artgen.categories.shared.furniture import CREAM_STEEL, ZINC, Carcass
from artgen.categories.shared.locks import plug
from artgen.categories.shared.pulls import GROOVE
from artgen.categories.shared.shelves import open_box

SIDE_PLAY = 0.0125
"""Gap between the side of a drawer and the face beside it [m]."""

RunnerStyle = Literal["roller", "ball"]
"""Coated angles with rollers, or ball-bearing telescopic runners."""

_MEMBER = 0.0052  # thickness of each member; a gap of 2.1 mm is between them [m]

_RUNNER_HEIGHT: dict[RunnerStyle, float] = {"roller": 0.030, "ball": 0.042}


def steel_of(style: RunnerStyle) -> ag.Material:
    """Return the steel of runners of a style."""
    return CREAM_STEEL if style == "roller" else ZINC


def fixed_member(
    style: RunnerStyle, *, face: ag.Scalar, z: ag.Scalar, front: ag.Scalar, length: ag.Scalar, solid: bool
) -> list[ag.Body]:
    """Make the member on the carcass, at the right of a drawer."""
    high, steel = _RUNNER_HEIGHT[style], steel_of(style)
    rail = ag.Region(
        (face - _MEMBER, face + 0.0003), (front, front + length), (z - high / 2, z + high / 2)
    ).box(bevel=0.0008)
    # lips wrap around the drawer's member
    lip = ag.Region(
        (face - _MEMBER - 0.0018, face - _MEMBER + 0.0005),
        (front + 0.001, front + length - 0.001),
        (-0.0015, 0.0015),
    ).box()
    edge = high / 2 - 0.0015
    at: list[ag.VectorLike] = [(0.0, 0.0, z + end * edge) for end in ((-1, 1) if style == "ball" else (-1,))]
    bodies = [_steel(rail, steel, solid=solid), ag.detail(ag.array(lip, at=at), "runner", steel)]
    if style == "roller":
        wheel = ag.cylinder(0.010, 0.0022, axis=ag.X, bevel=0.0006)
        bodies.append(
            ag.detail(wheel.at(face - _MEMBER - 0.0006, front + 0.014, z), "runner", ag.material("abs"))
        )
    return bodies


def moving_member(
    style: RunnerStyle, *, side: ag.Scalar, z: ag.Scalar, front: ag.Scalar, length: ag.Scalar, solid: bool
) -> list[ag.Body]:
    """Make the member on the right side of a drawer."""
    high, steel = _RUNNER_HEIGHT[style] - 0.010, steel_of(style)
    rail = ag.Region(
        (side - 0.0003, side + _MEMBER), (front, front + length), (z - high / 2, z + high / 2)
    ).box(bevel=0.0008)
    heads = [(side + _MEMBER, front + share * length, z) for share in (0.12, 0.5, 0.88)]
    return [
        _steel(rail, steel, solid=solid),
        *screws(heads, facing="+x", radius=0.0032, finish=steel, sunk=0.0008),
    ]


def _steel(rail: ag.Solid, steel: ag.Material, *, solid: bool) -> ag.Body:
    return ag.part(rail, "runner", steel) if solid else ag.detail(rail, "runner", steel)


INDEXES = ("A-F", "G-K", "L-R", "S-Z", "2021", "2022", "2023", "2024")
"""Texts of the cards."""

_WIDE, _HIGH = 0.078, 0.030  # width and height of a label holder [m]


def label_holder(*, z: ag.Scalar, finish: ag.Material, index: str) -> list[ag.Body]:
    """Make a label holder and its card."""
    opening = ag.rectangle(_WIDE - 0.010, _HIGH - 0.011).at(0.0, 0.0015)
    rim = ag.rectangle(_WIDE, _HIGH, radius=0.003) - opening
    paper = ag.colored("abs", "white").with_(name="card", specular_roughness=0.85)
    return [
        ag.detail(
            ag.extrude(rim, 0.0026, axis=ag.Y, bevel=0.0007).at(0.0, -0.0008, z), "label_holder", finish
        ),
        ag.detail(
            ag.box(_WIDE - 0.009, 0.0008, _HIGH - 0.010).at(0.0, -0.0003, z + 0.0015), "label_holder", paper
        ),
        details.printed(ag.text(index, 0.010), (0.0, -0.0007, z - 0.0035), material=ag.material("black_abs")),
    ]


def lock(*, x: ag.Scalar, z: ag.Scalar, finish: ag.Material) -> list[ag.Body]:
    """Make the cylinder of a lock, visual only."""
    collar = ag.extrude(ag.ring(0.0115, 0.0070), 0.0030, axis=ag.Y, bevel=0.0009)
    return [
        ag.detail(collar.at(x, -0.0011, z), "lock", finish),
        *(each.at(x, 0.0, z) for each in plug(face=0.0004, side=-1, finish=finish, radius=0.0072)),
    ]


Mounting = Literal["overlay", "inset"]
"""Position of fronts: on the edges of the carcass or between them."""

GAP = 0.003
"""Gap between two fronts, or around a front between boards [m]."""

_SHADOW = 0.020  # gap above a groove for fingers from above [m]
_BEHIND = 0.002  # gap between an overlaid front and the carcass [m]
_MARGIN = 0.0015  # distance from overlaid fronts to the outlines of the carcass [m]
_FLOOR = 0.014  # space under the box of a drawer [m]
_OVER = 0.016  # space above the box [m]
_REAR = 0.018  # space behind the box [m]
_BITE = 0.0003  # overlap of joined boards [m]
_HAND = 60.0  # largest pull of a hand [N]


@dataclass(frozen=True)
class Rows:
    """Positions of the drawers in a carcass."""

    case: Carcass  # carcass
    mounting: Mounting  # mounting of the fronts
    columns: int  # number of drawers side by side
    weights: Sequence[ag.Scalar]  # relative heights of the rows, from the top
    thick: ag.Scalar  # thickness of fronts [m]
    groove: bool = False  # whether fronts have a groove along their upper edges
    # height of the lower end of the lowest row above the floor [m]; by default the bottom of the carcass
    low: ag.Scalar | None = None

    @property
    def inset(self) -> bool:
        """Whether fronts are between the boards."""
        return self.mounting == "inset"

    @cached_property
    def face(self) -> ag.Scalar:
        """Position of the faces of shut drawers along y [m]."""
        return self.case.front if self.inset else self.case.front - _BEHIND - self.thick

    @property
    def apart(self) -> ag.Scalar:
        """Distance from a front to the front above it [m]."""
        if self.inset:
            return self.case.thick + 2 * GAP  # with a rail between them
        return _SHADOW if self.groove else GAP

    @cached_property
    def bottom(self) -> ag.Scalar:
        """Height of the lower edge of the lowest fronts [m]."""
        if self.inset:
            return (self.case.floor if self.low is None else self.low) + GAP
        return (self.case.low + _MARGIN) if self.low is None else self.low - self.case.thick / 2

    @cached_property
    def top(self) -> ag.Scalar:
        """Height of the upper edge of the highest fronts [m]."""
        if self.inset:
            return self.case.ceiling - GAP
        return self.case.high - (_SHADOW if self.groove else _MARGIN)

    @cached_property
    def cell(self) -> ag.Scalar:
        """Width between the boards beside a drawer [m]."""
        return (2 * self.case.right - (self.columns - 1) * self.case.thick) / self.columns

    @cached_property
    def middles(self) -> list[ag.Scalar]:
        """Middles of the columns along x [m]."""
        pitch = self.cell + self.case.thick
        return [(at - (self.columns - 1) / 2) * pitch for at in range(self.columns)]

    @cached_property
    def width(self) -> ag.Scalar:
        """Width of a front, the same for all in a row; outer fronts may end before the outline [m]."""
        return self.cell - 2 * GAP if self.inset else self.cell + self.case.thick - GAP

    @cached_property
    def begin(self) -> ag.Scalar:
        """Position of the fronts of boxes along y [m]."""
        return self.face + self.thick - _BITE

    @cached_property
    def deep(self) -> ag.Scalar:
        """Depth of boxes [m]."""
        return self.case.behind - _REAR - self.begin

    def outer(self, column: int) -> tuple[ag.Scalar, ag.Scalar]:
        """Return the left and the right edge of the fronts of a column [m]."""
        middle = self.middles[column]
        left, right = middle - self.width / 2, middle + self.width / 2
        if self.inset:
            return left, right
        end = self.case.width / 2 - _MARGIN
        return (-end if column == 0 else left), (end if column == self.columns - 1 else right)

    @cached_property
    def spans(self) -> list[tuple[ag.Scalar, ag.Scalar]]:
        """Heights of the lower and upper edges of the fronts of each row, from the top [m]."""
        whole: ag.Scalar = self.weights[0]
        for weight in self.weights[1:]:
            whole = whole + weight
        unit = (self.top - self.bottom - (len(self.weights) - 1) * self.apart) / whole
        found, high = [], self.top
        for weight in self.weights:
            found.append((high - weight * unit, high))
            high = high - weight * unit - self.apart
        return found

    def rises(self, row: int) -> tuple[ag.Scalar, ag.Scalar]:
        """Return the free heights above the lower edge of a front and below its upper edge [m]."""
        if self.inset:
            return 0.0, 0.0
        last = row == len(self.weights) - 1
        floor: ag.Scalar = 0.0
        if last:
            floor = (self.case.floor - self.bottom) if self.low is None else self.case.thick / 2
        ceiling: ag.Scalar = 0.0
        if row == 0:
            ceiling = self.case.thick - _MARGIN
        if self.groove:
            ceiling = GROOVE
        return floor, ceiling

    def between(self, *, solid: bool) -> list[ag.Body]:
        """Make the partitions between columns and the rails between rows."""
        case, y = self.case, self.case.thick / 2
        low = None if self.low is None else self.low
        bodies = [
            case.partition((left + right) / 2, low=low)
            for left, right in zip(self.middles, self.middles[1:], strict=False)
        ]
        if not self.inset and not self.groove:
            return bodies
        levels: list[tuple[ag.Scalar, ag.Scalar]] = []
        for (_, high), (low_above, _) in zip(self.spans[1:], self.spans, strict=False):
            if self.inset:
                levels.append((high + GAP + y, case.thick))
            else:
                levels.append(((high - 0.022 + low_above + 0.004) / 2, low_above - high + 0.026))
        for middle in self.middles:
            half = self.cell / 2
            bodies += [
                case.rail(middle - half, middle + half, z, high=high, solid=solid or self.inset)
                for z, high in levels
            ]
        return bodies


@dataclass(frozen=True)
class BoxLook:
    """Finish and dimensions of drawer boxes."""

    sides: ag.Material  # material of sides, back and inner front
    bottom: ag.Material  # material of the bottom
    wall: ag.Scalar  # thickness of sides, back and inner front [m]
    floor: ag.Scalar  # thickness of the bottom [m]
    runner: RunnerStyle  # style of the runners
    tallest: ag.Scalar  # largest height of the sides [m]
    # whether runners, and rails behind grooves, have mass and collide; with many drawers they are visual
    # only, because simulators test all pairs of close colliders
    solid: bool = True


def drawer(
    rows: Rows, row: int, column: int, look: FrontLook, box: ag.Body, handles: Sequence[ag.Body]
) -> ag.Body:
    """Make a drawer: the link `drawer`."""
    low, high = rows.spans[row]
    left, right = rows.outer(column)
    aside = (left + right) / 2 - rows.middles[column]
    slab = high - low - GROOVE + 0.0004 if rows.groove else high - low  # below the edge of the groove
    middle = (aside, rows.face + rows.thick / 2, slab / 2)
    return ag.weld(
        box,
        *(each.at(*middle) for each in front(look, right - left, slab, rows.thick, label="front")),
        *(each.at(aside, rows.face, 0.0) for each in handles),
    )


def _sizes(rows: Rows, row: int, look: BoxLook) -> tuple[ag.Scalar, ag.Scalar, ag.Scalar]:
    """Return the start of a box above its front's lower edge, its height, and the middle of its runners."""
    low, high = rows.spans[row]
    floor, over = rows.rises(row)
    base = floor + _FLOOR
    tall = ag.min_(high - low - base - over - _OVER, look.tallest)
    return base, tall, base + (0.017 if look.runner == "roller" else 0.42 * tall)


def drawer_box(rows: Rows, row: int, look: BoxLook) -> ag.Body:
    """Make the box of the drawers of a row with its runner members: the link `drawer`."""
    base, tall, z = _sizes(rows, row, look)
    begin, wide, deep = rows.begin, rows.cell - 2 * SIDE_PLAY, rows.deep
    boards = open_box(wide, deep, tall, wall=look.wall, front=look.wall, floor=look.floor)
    inner, bottom, *others = (each.at(0.0, begin, base) for each in boards)
    length = deep - look.wall - 0.004
    members = moving_member(
        look.runner, side=wide / 2, z=z, front=begin + look.wall, length=length, solid=look.solid
    )
    return ag.weld(
        ag.part(inner, "drawer", look.sides, name="drawer"),
        ag.part(bottom, "drawer", look.bottom),
        *(ag.part(each, "drawer", look.sides) for each in others),
        *(half for each in members for half in (each, each.mirror(ag.X))),
    )


def fixed_members(rows: Rows, look: BoxLook) -> list[ag.Body]:
    """Make the members of the runners on the carcass."""
    bodies: list[ag.Body] = []
    for row, (low, _) in enumerate(rows.spans):
        z = low + _sizes(rows, row, look)[2]
        members = fixed_member(
            look.runner,
            face=rows.cell / 2,
            z=z,
            front=rows.begin + 0.004,
            length=rows.deep - 0.008,
            solid=look.solid,
        )
        pair = [half for each in members for half in (each, each.mirror(ag.X))]
        bodies += [each.at(x, 0.0, 0.0) for x in rows.middles for each in pair]
    return bodies


def travel(rows: Rows, share: ag.Scalar) -> ag.Scalar:
    """Return the travel of drawers [m]."""
    return share * rows.deep


def slide(
    rows: Rows, row: int, column: int, *, share: ag.Scalar, friction: ag.Scalar, damping: ag.Scalar
) -> ag.Joint:
    """Make the slide of a drawer, with its indices as suffix."""
    low, high = rows.spans[row]
    return ag.Prismatic(
        f"drawer_slide_{row * rows.columns + column}",
        axis=(0.0, -1.0, 0.0),
        pivot=(rows.middles[column], rows.face, (low + high) / 2),
        limits=(0.0, travel(rows, share)),
        friction=friction,
        damping=damping,
        effort=_HAND,
    )
