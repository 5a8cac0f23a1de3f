"""The cabinet of a refrigerator: foam-filled walls around cold cells, the machine room and feet."""

import math
from functools import partial
from itertools import pairwise
from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.refrigerator.plan import FOOT, HUMP_DEEP, HUMP_HIGH, Cell, Plan
from artgen.categories.shared.appliances import DARK, cord_stub, filled
from artgen.categories.shared.fixings import feet

_WALLS = 166.0  # density of foam between steel and plastic, with pipes, wires and frames [kg/m3]
_COMPRESSOR = 7400.0  # density of a steel shell with a motor, oil and pipes: 10 kg [kg/m3]
_SHEET = ag.material("zinc").with_(
    name="galvanised_sheet", texture="", specular_roughness=0.42, density=7000.0
)
_COVE = 0.016  # radius of the round inner edges of a cell [m]
_ARC = 5  # number of sides of that radius
_IN_WALL = 0.0005  # overlap of walls [m]
_STEP = 0.030  # thickness of the boards around the machine room [m]

Back = Literal["grille", "panel"]
"""Visible back: a condenser of wires and pipes, or a flat sheet."""


def cabinet(
    plan: Plan,
    finish: ag.Material,
    liner: ag.Material,
    kick: ag.Material,
    back: Back,
    corner: ag.Scalar | None,
) -> ag.Body:
    """Make the cabinet with its cells, machine room, back, kick plate and feet: the link `body`."""
    block, first, last = plan.block, plan.cells[0], plan.cells[-1]
    whole = first.with_(x=(first.x.low, last.x.high), z=(first.z.low, last.z.high))
    hump = whole.with_(y=(whole.y.high - HUMP_DEEP, whole.y.high), z=(whole.z.low, whole.z.low + HUMP_HIGH))
    y, z = (hump.y.low + _STEP, block.y.high + 0.01), (FOOT + 0.014, hump.z.high - _STEP)
    room = ag.Region(block.shrink(x=0.035).x, y, z)
    if corner is None:
        solid = block.box(bevel=0.004)
    else:
        outline = block.front(radius=corner)
        solid = ag.extrude(outline, block.y.size, axis=ag.Y, bevel=0.004).at(y=block.y.mid)
    solid = solid - whole.grow(0, front=0.01).box().paint(liner) - room.box().paint(DARK)
    # the step in front of the machine room and above it, and a screen behind it
    face = hump.grow(x=_IN_WALL).deep(_STEP, None)[0].shrink(0, bottom=-0.00075, top=0.00025)
    lid = hump.grow(x=_IN_WALL, y=0, z=0).stack(_STEP, None)[0].grow(0, back=0.001)
    screen = room.shrink(x=0.001).with_(
        y=(room.y.low - 0.0005, room.y.low + 0.0015), z=(whole.z.low + 0.001, room.z.high - 0.001)
    )
    walls = [_partition(one, other, abreast=plan.abreast) for one, other in pairwise(plan.cells)]
    stand = block.shrink(x=0.05, front=0.04, back=0.05)
    corners = [(x, y) for x in stand.x for y in stand.y]
    return ag.weld(
        ag.part([solid, *walls], "body", filled(finish, _WALLS)),
        ag.detail([cove for cell in plan.cells for cove in _coves(cell)], "liner", liner),
        ag.part([face.box(), lid.box()], "liner", filled(liner, _WALLS)),
        ag.detail(screen.box(), "liner", DARK),
        *_machinery(block),
        *_kick_plate(plan, kick),
        *_back(block.with_(z=(hump.z.high + 0.03, block.z.high - 0.10)), back),
        feet(corners, radius=0.015, height=FOOT, finish=ag.material("black_abs")),
    )


def _partition(one: Cell, other: Cell, *, abreast: bool) -> ag.Solid:
    """Make the wall between two cells, with an overlap with the walls around it."""
    if abreast:
        wall = one.grow(z=_IN_WALL, back=_IN_WALL).with_(x=(one.x.high, other.x.low))
    else:
        wall = one.grow(x=_IN_WALL, back=_IN_WALL).with_(z=(one.z.high, other.z.low))
    return wall.box(bevel=0.002)


def _coves(cell: Cell) -> list[ag.Solid]:
    """Make the round inner edges of a cell, visual only."""
    r, buried = _COVE, -0.0004  # the corner lies in the wall
    turns = [k * math.pi / 2 / _ARC for k in range(1, _ARC)]
    arc = [(r - r * math.sin(turn), r - r * math.cos(turn)) for turn in turns]
    corner = ag.polygon([(buried, buried), (r, buried), *arc, (buried, r)])
    run = cell.shrink(0, front=0.0005)
    along = ag.extrude(corner, run.y.size, axis=ag.Y).at(y=run.y.mid)
    up = ag.extrude(corner, cell.z.size - 0.001).mirror(ag.Y)
    half = cell.x.size / 2
    left = [
        along.at(-half, 0, cell.z.low),
        along.mirror(ag.Z).at(-half, 0, cell.z.high),
        up.at(-half, cell.y.high, cell.z.mid),
    ]
    return [side.at(cell.x.mid) for each in left for side in (each, each.mirror(ag.X))]


def _machinery(block: ag.Region) -> list[ag.Body]:
    """Make the compressor with its pipes in the machine room."""
    at = (block.x.low + 0.17, block.y.high - 0.085, FOOT + 0.014)
    pot = ag.cylinder(0.066, 0.105, bevel=0.008).at(z=0.062)
    plate = ag.box(block.x.size - 0.08, 0.12, 0.004).at(0, at[1], at[2] + 0.0015)
    foot = ag.cylinder(0.012, 0.012)
    stubs = ag.array(foot, at=[(x, y, 0.006) for x in (-0.06, 0.06) for y in (-0.035, 0.035)])
    steel = ag.material("powder_coat_black").with_(name="compressor", density=_COMPRESSOR)
    corners = [(0.05, 0, 0.07), (0.10, 0, 0.07), (0.10, 0.03, 0.10), (0.20, 0.03, 0.10), (0.20, 0.03, 0.02)]
    pipe = ag.sweep(ag.circle(0.004), ag.polyline(corners, fillet=0.012))
    tray = ag.box(0.16, 0.12, 0.035, bevel=0.004).at(-at[0] - 0.02, at[1], at[2] + 0.020)
    return [
        ag.part(pot.at(at), "compressor", steel),
        ag.part(plate, "compressor", _SHEET),
        ag.detail(stubs.at(at), "compressor", ag.material("rubber")),
        ag.detail(pipe.at(at), "compressor", ag.material("copper")),
        ag.detail(tray, "compressor", ag.material("black_abs")),
    ]


def _kick_plate(plan: Plan, finish: ag.Material) -> list[ag.Body]:
    """Make the plate under the lowest front, with ventilation slots for the machine."""
    block, high = plan.block, plan.kick - FOOT
    plate = block.shrink(x=0.015).with_(
        y=(block.y.low - 0.008, block.y.low), z=(FOOT + 0.001, plan.kick - 0.003)
    )
    slots = details.vent_slots(0.62 * block.x.size, 0.44 * high, 3, slot=0.004, direction="horizontal")
    at = (0, plate.y.low, FOOT + 0.45 * high)
    return [
        ag.part(plate.box(bevel=0.002), "kick_plate", finish),
        details.printed(slots, at, material=DARK, label="kick_plate"),
    ]


def _back(area: ag.Region, kind: Back) -> list[ag.Body]:
    """Make the visible parts of the back above the machine room: condenser or sheet, cord, rating plate."""
    (width, _, height), y, z = area.size, area.y.high, area.z.mid
    if kind == "grille":
        rack = details.wire_rack(
            0.8 * width, 0.8 * height, pitch=0.028, wire=0.0011, frame=0.0032, direction="width", supports=2
        )
        rack = rack.rotate(ag.X, math.pi / 2).at(0, y + 0.007, z + 0.06 * height)
        clip = ag.box(0.02, 0.012, 0.03, bevel=0.002)
        corners = [(i * width, y + 0.004, z + j * height) for i in (-0.36, 0.36) for j in (-0.36, 0.36)]
        bodies = [
            ag.detail(rack, "condenser", ag.material("black_steel")),
            ag.detail(ag.array(clip, at=corners), "condenser", ag.material("black_abs")),
        ]
    else:
        raised = partial(details.relief, facing=ag.Y, bevel=0.0012)
        sheet = ag.rectangle(0.82 * width, 0.86 * height, radius=0.03)
        bead = ag.rectangle(0.7 * width, 0.012, radius=0.005)
        beads = [raised(bead, (0, y + 0.0018, z + share * height), proud=0.0016) for share in (-0.3, 0, 0.3)]
        bodies = [ag.detail([raised(sheet, (0, y, z), proud=0.0018), *beads], "condenser", _SHEET)]
    lines = ("REFRIGERATOR", "230 V  50 Hz  1.2 A", "R600a  48 g")
    at = (0.28 * width, y + 0.0002, area.z.high + 0.055)
    plate = details.rating_plate(0.095, 0.05, lines, at=at, facing=ag.Y, double_insulated=False)
    outlet = area.z.low - 0.025
    cord = cord_stub(height=outlet, radius=0.0042).at(0.36 * width, y, outlet)
    return [*bodies, plate, cord]
