"""The cabinet of a refrigerator: foam-filled walls around cold cells, the machine room behind, feet and kick.

A refrigerator is centered in x and y; its doors are in front, at y from `Case.front` to `Case.face`.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

import artgen as ag
from artgen import details
from artgen._arrays import cached_property
from artgen.categories.shared.appliances import DARK, cord_stub, filled
from artgen.categories.shared.fixings import feet

SEAL_GAP = 0.010
"""Gap between a closed door and the cabinet, filled by the gasket [m]."""

FOOT = 0.022
"""Height of the feet [m]."""

BACK_WALL = 0.055
"""Thickness of the back [m]."""

COVER = 0.018
"""Height of the covers of the upper hinges, on top of the cabinet [m]."""

HUMP_DEEP, HUMP_HIGH = 0.125, 0.175
"""Depth and height of the machine room in the rear of the lowest cell [m]."""

_WALLS = 166.0  # density of foam between steel and plastic, with pipes, wires and frames [kg/m3]
_COMPRESSOR = 7400.0  # density of a steel shell with a motor, oil and pipes: 10 kg [kg/m3]
_SHEET = ag.material("zinc").with_(
    name="galvanised_sheet", texture="", specular_roughness=0.42, density=7000.0
)
_COVE = 0.016  # radius of the round inner edges of a cell [m]
_ARC = 5
_IN_WALL = 0.0005  # overlap of walls [m]

Back = Literal["grille", "panel"]
"""Visible back: a condenser of wires and pipes, or a flat sheet."""


@dataclass(frozen=True)
class Cell:
    """A cold compartment of the cabinet, open in front."""

    left: ag.Scalar  # position of the left side along x [m]
    right: ag.Scalar  # position of the right side along x [m]
    low: ag.Scalar  # height of the floor [m]
    high: ag.Scalar  # height of the ceiling [m]
    rear: ag.Scalar  # position of the back along y [m]
    humped: bool = False  # whether the machine room takes the lower part of the rear
    top: bool = False  # whether the cell is under the top of the cabinet

    @cached_property
    def width(self) -> ag.Scalar:
        """Width between the sides [m]."""
        return self.right - self.left

    @cached_property
    def middle(self) -> ag.Scalar:
        """Position of the middle along x [m]."""
        return (self.left + self.right) / 2

    @cached_property
    def height(self) -> ag.Scalar:
        """Height from floor to ceiling [m]."""
        return self.high - self.low

    def mirrored(self) -> "Cell":
        """Return the mirror image of the cell in the plane x = 0."""
        return Cell(-self.right, -self.left, self.low, self.high, self.rear, self.humped, self.top)


@dataclass(frozen=True)
class Case:
    """Dimensions of a cabinet, shared by all parts."""

    width: ag.Scalar  # overall width [m]
    depth: ag.Scalar  # depth from the fronts of the doors to the back, without handles [m]
    top: ag.Scalar  # height of the top [m]
    kick: ag.Scalar  # height of the lower edge of the lowest front [m]
    thickness: ag.Scalar  # thickness of the doors [m]
    wall: ag.Scalar  # thickness of the sides [m]
    gap: ag.Scalar  # gap between two fronts [m]

    @cached_property
    def front(self) -> ag.Scalar:
        """Position of the fronts of the doors along y [m]."""
        return -0.5 * self.depth

    @cached_property
    def face(self) -> ag.Scalar:
        """Position of the inner sides of the doors along y [m]."""
        return self.front + self.thickness

    @cached_property
    def mouth(self) -> ag.Scalar:
        """Position of the front of the cabinet along y [m]."""
        return self.face + SEAL_GAP

    @cached_property
    def back(self) -> ag.Scalar:
        """Position of the back along y [m]."""
        return 0.5 * self.depth

    @cached_property
    def rear(self) -> ag.Scalar:
        """Position of the back of the cells along y [m]."""
        return self.back - BACK_WALL


def cabinet(
    case: Case,
    cells: Sequence[Cell],
    *,
    finish: ag.Material,
    liner: ag.Material,
    corner: ag.Scalar | None,
    kick: ag.Material,
    back: Back,
    abreast: bool = False,
) -> ag.Body:
    """Make the cabinet with its cells, machine room, back, kick plate and feet: the link `body`."""
    deep = case.back - case.mouth
    high = case.top - FOOT
    if corner is None:
        block = ag.box(case.width, deep, high, bevel=0.004)
    else:
        block = ag.extrude(ag.rectangle(case.width, high, radius=corner), deep, axis=ag.Y, bevel=0.004)
    block = block.at(0.0, case.mouth + deep / 2, (case.top + FOOT) / 2)
    first, last = cells[0], cells[-1]
    low = Cell(first.left, last.right, first.low, last.high, first.rear)
    block = block - _hollow(case, low).paint(liner) - _machine_room(case, low).paint(DARK)
    bodies = [ag.part(block, "body", filled(finish, _WALLS))]
    for one, other in pairwise(cells):
        bodies.append(ag.part(_partition(case, one, other, abreast=abreast), "body", filled(finish, _WALLS)))
    bodies += [ag.detail(cove, "liner", liner) for cell in cells for cove in _coves(case, cell)]
    bodies += [ag.part(board, "liner", filled(liner, _WALLS)) for board in _hump(low)]
    screen = ag.box(case.width - 0.072, 0.002, HUMP_HIGH - 0.032)  # behind the step, towards the machine
    rear = low.rear - HUMP_DEEP + 0.0305
    bodies.append(ag.detail(screen.at(0.0, rear, low.low + HUMP_HIGH / 2 - 0.015), "liner", DARK))
    bodies += _machinery(case, low)
    bodies += _kick_plate(case, kick)
    bodies += _back(case, low, back)
    x, y0, y1 = case.width / 2 - 0.05, case.mouth + 0.04, case.back - 0.05
    places = [(-x, y0), (x, y0), (x, y1), (-x, y1)]
    return ag.weld(
        *bodies, feet(places, radius=0.015, height=FOOT, style="pad", finish=ag.material("black_abs"))
    )


def _hollow(case: Case, whole: Cell) -> ag.Solid:
    """Make the cutter that removes all cells from the block."""
    return ag.Region(
        (whole.left, whole.right), (case.mouth - 0.01, whole.rear), (whole.low, whole.high)
    ).box()


def _partition(case: Case, one: Cell, other: Cell, *, abreast: bool) -> ag.Solid:
    """Make the wall between two cells, with an overlap of half a millimeter with the walls around it."""
    y = (case.mouth, one.rear + _IN_WALL)
    if abreast:
        return ag.Region((one.right, other.left), y, (one.low - _IN_WALL, one.high + _IN_WALL)).box(
            bevel=0.002
        )
    return ag.Region((one.left - _IN_WALL, one.right + _IN_WALL), y, (one.high, other.low)).box(bevel=0.002)


def _coves(case: Case, cell: Cell) -> list[ag.Solid]:
    """Make the round inner edges of a cell, visual only."""
    r, buried = _COVE, -0.0004  # the corner lies in the wall
    turns = [k * math.pi / 2 / _ARC for k in range(_ARC + 1)]
    arc = [(r - r * math.sin(turn), r - r * math.cos(turn)) for turn in turns[1:-1]]
    corner = ag.polygon([(buried, buried), (r, buried), *arc, (buried, r)])
    deep = cell.rear - case.mouth - 0.0005
    middle = cell.rear - deep / 2
    along = ag.extrude(corner, deep, axis=ag.Y)
    up = ag.extrude(corner, cell.height - 0.001, axis=ag.Z)
    z = (cell.low + cell.high) / 2
    lower = along.at(cell.left, middle, cell.low)
    upper = along.mirror(ag.Z).at(cell.left, middle, cell.high)
    rear = up.mirror(ag.Y).at(cell.left, cell.rear, z)
    return [
        way
        for one in (lower, upper, rear)
        for way in (one, one.at(-cell.middle).mirror(ag.X).at(cell.middle))
    ]


def _machine_room(case: Case, low: Cell) -> ag.Solid:
    """Make the cutter of the compressor's space in the block."""
    deep = case.back - (low.rear - HUMP_DEEP) - 0.03
    high = low.low + HUMP_HIGH - 0.03 - (FOOT + 0.014)
    room = ag.box(case.width - 0.07, deep + 0.01, high)
    return room.at(0.0, case.back - deep / 2 + 0.005, FOOT + 0.014 + high / 2)


def _hump(low: Cell) -> list[ag.Solid]:
    """Make the step in the lowest cell in front of and above the machine room."""
    thick = 0.030
    face = ag.box(low.width + 0.001, thick, HUMP_HIGH + 0.0005)
    lid = ag.box(low.width + 0.001, HUMP_DEEP + 0.001, thick)
    return [
        face.at(low.middle, low.rear - HUMP_DEEP + thick / 2, low.low + HUMP_HIGH / 2 - 0.0005),
        lid.at(low.middle, low.rear - HUMP_DEEP / 2 + 0.0005, low.low + HUMP_HIGH - thick / 2),
    ]


def _machinery(case: Case, low: Cell) -> list[ag.Body]:
    """Make the compressor with its pipes in the machine room."""
    floor = FOOT + 0.014
    y = case.back - 0.085
    x = -0.5 * case.width + 0.17
    pot = ag.cylinder(0.066, 0.105, bevel=0.008).at(x, y, floor + 0.062)
    plate = ag.box(case.width - 0.08, 0.12, 0.004).at(0.0, y, floor + 0.0015)
    foot = ag.cylinder(0.012, 0.012)
    stubs = ag.array(
        foot, at=[(x + way * 0.06, y + side * 0.035, floor + 0.006) for way in (-1, 1) for side in (-1, 1)]
    )
    black = ag.material("powder_coat_black").with_(name="compressor", density=_COMPRESSOR)
    pipe = ag.polyline(
        [
            (x + 0.05, y, floor + 0.07), (x + 0.10, y, floor + 0.07), (x + 0.10, y + 0.03, floor + 0.10),
            (x + 0.20, y + 0.03, floor + 0.10), (x + 0.20, y + 0.03, floor + 0.02),
        ],
        fillet=0.012,
    )  # fmt: skip
    tray = ag.box(0.16, 0.12, 0.035, bevel=0.004).at(-x - 0.02, y, floor + 0.020)
    return [
        ag.part(pot, "compressor", black),
        ag.part(plate, "compressor", _SHEET),
        ag.detail(stubs, "compressor", ag.material("rubber")),
        ag.detail(ag.sweep(ag.circle(0.004), pipe), "compressor", ag.material("copper")),
        ag.detail(tray, "compressor", ag.material("black_abs")),
    ]


def _kick_plate(case: Case, finish: ag.Material) -> list[ag.Body]:
    """Make the plate under the lowest front, with ventilation slots for the machine."""
    high = case.kick - FOOT
    y = case.mouth - 0.004
    plate = ag.box(case.width - 0.03, 0.008, high - 0.004, bevel=0.002)
    plate = plate.at(0.0, y, FOOT + high / 2 - 0.001)
    slots = details.vent_slots(0.62 * case.width, 0.44 * high, 3, slot=0.0040, direction="horizontal")
    return [
        ag.part(plate, "kick_plate", finish),
        details.printed(slots, (0.0, y - 0.004, FOOT + 0.45 * high), material=DARK, label="kick_plate"),
    ]


def _back(case: Case, low: Cell, kind: Back) -> list[ag.Body]:
    """Make the visible parts of the back: condenser or sheet, cord, rating plate."""
    outward = (0.0, 1.0, 0.0)
    bottom, top = low.low + HUMP_HIGH + 0.03, case.top - 0.10
    middle, high = (bottom + top) / 2, top - bottom
    bodies: list[ag.Body] = []
    if kind == "grille":
        tall, wide = 0.8 * high, 0.8 * case.width
        rack = details.wire_rack(
            wide, tall, pitch=0.028, wire=0.0011, frame=0.0032, direction="width", supports=2
        )
        rack = rack.rotate(ag.X, math.pi / 2).at(0.0, case.back + 0.007, middle + 0.06 * high)
        bodies.append(ag.detail(rack, "condenser", ag.material("black_steel")))
        clip = ag.box(0.02, 0.012, 0.03, bevel=0.002)
        corners = [
            (x * 0.36 * case.width, case.back + 0.004, middle + z * 0.36 * high)
            for x in (-1, 1)
            for z in (-1, 1)
        ]
        bodies.append(ag.detail(ag.array(clip, at=corners), "condenser", ag.material("black_abs")))
    else:
        sheet = ag.rectangle(0.82 * case.width, 0.86 * high, radius=0.03)
        bodies.append(
            ag.detail(
                details.relief(sheet, (0.0, case.back, middle), facing=outward, proud=0.0018, bevel=0.0012),
                "condenser",
                _SHEET,
            )
        )
        bead = ag.rectangle(0.7 * case.width, 0.012, radius=0.005)
        for share in (-0.3, 0.0, 0.3):
            solid = details.relief(
                bead,
                (0.0, case.back + 0.0018, middle + share * high),
                facing=outward,
                proud=0.0016,
                bevel=0.0012,
            )
            bodies.append(ag.detail(solid, "condenser", _SHEET))
    plate = details.rating_plate(
        0.095, 0.05, ("REFRIGERATOR", "230 V  50 Hz  1.2 A", "R600a  48 g"),
        at=(0.28 * case.width, case.back + 0.0002, top + 0.055), facing=outward, double_insulated=False,
    )  # fmt: skip
    height = low.low + HUMP_HIGH + 0.005
    cord = cord_stub(height=height, radius=0.0042).at(0.36 * case.width, case.back, height)
    return [*bodies, plate, cord]
