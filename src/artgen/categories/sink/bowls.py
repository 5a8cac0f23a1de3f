"""Bowls of sinks and their supports: worktops on cabinets or legs, walls, pedestals."""

import itertools
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.shared import controls, sanitary
from artgen.categories.shared.finish import casting
from artgen.categories.shared.fronts import FrontLook, front
from artgen.categories.shared.furniture import Carcass
from artgen.categories.shared.hanging import Hanging
from artgen.categories.shared.taps import drain, stands

Style = Literal["inset", "undermount", "apron", "vessel", "hung", "pedestal"]
"""For a kitchen: with a rim on a worktop, below one, or with a front of its own. For a bath: a bowl on a
vanity, or a washbasin on a wall or a pedestal."""

Bowls = Literal["single", "half", "double"]
"""One bowl, one with half a bowl beside it, or two equal ones."""

Stand = Literal["cabinet", "legs", "wall", "pedestal", "none"]
"""A cabinet, four legs with a shelf, a tiled wall, a pedestal, or nothing."""

KITCHEN = ("inset", "undermount", "apron")
BACK = 0.088  # from the axis of the tap to the rear of a worktop or of a washbasin [m]
_NEAR = 0.045  # from the axis of the tap to a bowl [m]
_BETWEEN = 0.026  # between two bowls [m]
_RIM = 0.036  # from a bowl to the edge of an inset sink [m]
HOLE = 0.0405  # radius of the drain of a kitchen sink [m]
_BOARD = 0.018  # thickness of the boards of a cabinet [m]
_LEAF = 0.019  # thickness of a door [m]
_INSET = 0.032  # from the front of a worktop to the boards below it [m]
_SIDES = 32  # corners of the outline of a bowl
_HALF = 0.40  # half of the width of a wall [m]


@dataclass(frozen=True)
class Cabinet:
    """Doors and boards of a cabinet under a worktop."""

    look: FrontLook  # style and material of the doors; the boards have the same material
    doors: int  # 0 or 2
    handle: Callable[[str], ag.Body]  # makes the handle of a name
    swing: ag.Scalar  # angle of an open door [rad]


@dataclass(frozen=True)
class Plan:
    """Measures and materials of one sink, with the axis of the tap at the origin of x and y."""

    style: Style
    stand: Stand
    power: float
    width: ag.Scalar  # [m]
    deep: ag.Scalar  # [m]
    hollow: ag.Scalar  # [m]
    rim: ag.Scalar  # height of the worktop or of the rim above the floor [m]
    margin: ag.Scalar  # [m]
    shell: ag.Material
    metal: ag.Material
    top: ag.Material
    cabinet: Cabinet

    @property
    def wall(self) -> float:
        """Thickness of the walls of a bowl [m]."""
        return 0.008 if self.style in KITCHEN else 0.014

    def ring(self, half: ag.Scalar, deep: ag.Scalar) -> ag.Profile:
        """Make the outline of a bowl of half a width and half a depth about the origin."""
        angles = (math.tau * (step + 0.5) / _SIDES for step in range(_SIDES))
        return ag.polygon(sanitary.rounded(half, deep, self.power, angles))

    def tub(self, half: ag.Scalar, deep: ag.Scalar, top: ag.Scalar) -> tuple[ag.Solid, ag.Solid]:
        """Make the outside and the cavity of a steep bowl with its rim at a height."""
        bends = ((0.034, 0.0), (0.012, 0.012), (0.003, 0.040), (0.0, 0.0))
        rings = [self.ring(half - inset, deep - inset) for inset, _ in bends]
        outer = [self.ring(half - inset + self.wall, deep - inset + self.wall) for inset, _ in bends]
        heights = [top - self.hollow + up for _, up in bends[:-1]]
        cavity = ag.loft(rings, [*heights, top + 0.06])
        return ag.loft(outer, [*(z - self.wall for z in heights), top - 0.0004]), cavity


Point = tuple[ag.Scalar, ag.Scalar]
"""A corner of an outline [m]."""

Points = list[Point]
"""Corners of an outline [m]."""


def _past(start: Point, end: Point) -> Point:
    """Return a point a little behind the end of a line, so that pieces overlap."""
    return (1.004 * end[0] - 0.004 * start[0], 1.004 * end[1] - 0.004 * start[1])


def _between(inner: Sequence[Point], outer: Sequence[Point], first: int, last: int) -> ag.Profile:
    """Make the section of a wall between two corners of its inside and of its outside."""
    ends = [_past(inner[first], inner[last]), _past(outer[first], outer[last])]
    return ag.polygon([inner[first], *ends, outer[first]])


def _shell(levels: list[tuple[Points, Points, ag.Scalar]], hole: float, thick: float) -> list[ag.Solid]:
    """Make the convex pieces of a bowl from its inside, its outside and its height, from the floor up.

    The floor lies below the lowest level, around a square drain.
    """
    pieces = []
    for (inner, outer, low), (within, without, high) in itertools.pairwise(levels):
        for first in range(len(inner)):
            last = (first + 1) % len(inner)
            rims = [_between(*each, first, last) for each in ((inner, outer), (within, without))]
            pieces.append(ag.hull(ag.loft(rims, [low - 0.0004, high])))
    inner, outer, floor = levels[0]
    quarter, diagonal = len(inner) // 4, hole * math.sqrt(2)
    for side in range(4):
        start = side * quarter + (quarter - 1) // 2
        around = [inner[(start + step) % len(inner)] for step in range(quarter + 1)]
        left, right = (
            (diagonal * math.cos(turn), -diagonal * math.sin(turn))
            for turn in (math.pi * (0.5 * side + 0.75), math.pi * (0.5 * side + 0.25))
        )
        around[-1] = _past(around[-2], around[-1])
        plate = ag.polygon([*around, _past(right, left), right])
        pieces.append(ag.extrude(plate, thick).at(z=floor - thick / 2))
    return pieces


def _box_walls(
    plan: Plan, half: ag.Scalar, deep: ag.Scalar, top: ag.Scalar, rim: ag.Scalar
) -> list[ag.Solid]:
    """Make the pieces of a steep bowl with eight walls, within its visible surface.

    Plates at the height `rim` fill the corners of the frame around it.
    """
    angles = [math.tau * (step + 0.5) / 8 for step in range(8)]

    def corners(more: float) -> Points:
        return sanitary.rounded((half + more) / 0.987, (deep + more) / 0.987, 0.16, angles)

    bends = corners(0.0025)
    ends = [(x * (half + 0.0025), y * (deep + 0.0025)) for x, y in ((1, -1), (-1, -1), (-1, 1), (1, 1))]
    plates = [
        ag.extrude(ag.polygon([bends[2 * side], end, bends[2 * side + 1]]), 0.0015).at(z=rim)
        for side, end in enumerate(ends)
    ]
    levels = [
        (corners(less), corners(less + 0.005), z)
        for less, z in ((-0.018, top - plan.hollow - 0.0008), (0.0012, top - 0.0012))
    ]
    return _shell(levels, HOLE + 0.0015, 0.005) + plates


def _around(room: ag.Region, row: list[tuple[ag.Scalar, ag.Scalar]], near: ag.Scalar) -> list[ag.Solid]:
    """Make the boards of a frame around bowls: before, behind, beside and between them."""
    y = (near, -_NEAR)
    cells = [room.with_(y=(room.y.low, y[0] - 0.001)), room.with_(y=(y[1] + 0.001, room.y.high))]
    sides = [end for x, half in row for end in (x - half - 0.001, x + half + 0.001)]
    edges = [room.x.low, *sides, room.x.high]
    cells += [room.with_(x=pair, y=y).grow(y=0.0015) for pair in zip(edges[::2], edges[1::2], strict=True)]
    return [cell.box() for cell in cells]


def kitchen(plan: Plan, bowls: Bowls, drainer: str) -> tuple[ag.Body, list[ag.Vector], ag.Scalar, ag.Scalar]:
    """Make bowls in a worktop; return them with the drains, the height under the tap, and the middle in x."""
    half, small = plan.width / 2, 0.45 * plan.width / 2
    aside = _BETWEEN / 2
    rows: dict[Bowls, list[tuple[ag.Scalar, ag.Scalar]]] = {
        "single": [(0.0, half)],
        "half": [(-half - aside, half), (small + aside, small)],
        "double": [(-half - aside, half), (half + aside, half)],
    }
    row = rows[bowls]
    thick, near = 0.038, -_NEAR - plan.deep
    ends = (row[0][0] - row[0][1], row[-1][0] + row[-1][1])
    low: ag.Scalar = 0.0
    soft, level = 0.0011, 0.0
    match plan.style:
        case "inset":
            room = ag.Region(ends, (near, 0.014), (-0.0002, 0.0025)).grow(x=_RIM, y=_RIM)
            room = room if drainer == "none" else room.grow(**{drainer: 0.36})
            hole, level, low = room.shrink(x=0.012, y=0.012), 0.0025, 0.0025
        case "undermount":
            low = -thick
            room = ag.Region(ends, (near, -_NEAR), (low - 0.004, low + 0.0004)).grow(x=0.02, y=0.02)
            hole, soft = room.shrink(x=0.02, y=0.02), 0.0004
        case _:
            room = ag.Region(ends, (near - 0.026, 0.016 - _NEAR), (-plan.hollow - 0.022, 0.001))
            room, low = room.grow(x=0.026), 0.001
            hole, soft = room.grow(x=0.001, back=0.001, front=0.2), 0.008
    y = -_NEAR - plan.deep / 2
    tubs = [[each.at(x, y) for each in plan.tub(wide, plan.deep / 2, low)] for x, wide in row]
    floor = low - plan.hollow
    places = [ag.vector(x, y, floor) for x, _ in row]
    drains = ag.array(ag.cylinder(HOLE + 0.001, 0.1), at=places)
    cavity = ag.union(*(each for _, each in tubs))
    skin = ag.union(room.box(bevel=soft), *(each for each, _ in tubs)) - cavity - drains
    core = _around(room.shrink(0.0006), row, near)
    for x, wide in row:
        rim = room.z.high - 0.00135
        core += [each.at(x, y) for each in _box_walls(plan, wide, plan.deep / 2, low, rim)]
    share = {"inset": 1.0, "undermount": 1.0}.get(plan.style, 0.3 if "steel" in plan.shell.name else 0.75)
    body = ag.weld(
        ag.part(core, "bowl", casting(plan.shell, share), name="sink"), ag.detail(skin, "bowl", plan.shell)
    )
    if plan.style == "inset" and drainer != "none":
        body = ag.weld(body, _ribs(room, drainer, ends, plan.shell))
    if plan.stand == "none":
        return body, places, level, room.x.mid
    apron = plan.style == "apron"  # it stands out from doors and worktop
    board = room.with_(z=(-thick, 0.0), y=(near - (0.024 if apron else 0.075), BACK))
    board = board.grow(x=plan.margin + (0.02 if apron else 0.0))
    slab = board.box(bevel=0.002)
    if plan.style == "undermount":
        inside = board.shrink(0.0005)
        boards = _around(inside, row, near)
        top = ag.weld(ag.part(boards, "worktop", plan.top), ag.detail(slab - cavity, "worktop", plan.top))
    else:
        top = ag.part(slab - hole.with_(z=(-0.1, 0.1)).box(), "worktop", plan.top)
    above = plan.hollow + (0.026 - thick if apron else 0.05)
    gap = (room.x.low - 0.001, room.x.high + 0.001) if apron else ()
    return ag.weld(body, top, _stood(plan, board, above, gap)), places, level, room.x.mid


def _ribs(room: ag.Region, drainer: str, ends: ag.Span, finish: ag.Material) -> ag.Body:
    """Make the ribs of a drainer, on which dishes stand, in low relief."""
    x = (room.x.low + 0.03, ends[0] - 0.03) if drainer == "left" else (ends[1] + 0.03, room.x.high - 0.03)
    field = room.with_(x=x).shrink(y=0.035).with_(z=(0.0022, 0.0042))
    ribs = [cell.shrink(x=0.0055, y=0.0).box(bevel=0.0009) for cell in field.columns(12)]
    return ag.detail(ag.union(*ribs), "drainer", finish)


def _stood(
    plan: Plan, board: ag.Region, above: ag.Scalar = 0.0, apron: tuple[ag.Scalar, ...] | None = None
) -> ag.Body:
    """Make a cabinet, or legs with a shelf, below a board.

    There are fixed panels of the height `above` over the doors, beside the ends of an `apron`; without ends
    there is one panel, and for None no panel.
    """
    under = board.with_(z=(-plan.rim, board.z.low + 0.0003)).shrink(x=0.012, front=_INSET, back=0.004)
    if plan.stand == "legs":
        steel = ag.material("stainless").with_(name="leg_steel", density=1500.0)
        room = under.shrink(x=0.018, y=0.018)
        leg = ag.box(0.036, 0.036, under.z.size, bevel=0.002).at(z=under.z.mid)
        legs = ag.array(leg, at=[(x, y, 0.0) for x in room.x for y in room.y])
        shelf = under.with_(z=(under.z.low + 0.15, under.z.low + 0.165)).shrink(x=0.006, y=0.006)
        return ag.weld(ag.part(legs | shelf.box(bevel=0.002), "foot", steel))
    left, inner, right = under.across(_BOARD, None, _BOARD)
    wide = inner.grow(x=0.0004)
    foot = under.z.low + 0.09
    parts = [left.box(bevel=0.001), right.box(bevel=0.001)]
    parts.append(wide.with_(z=(foot, foot + _BOARD)).shrink(front=0.002).box(bevel=0.001))
    parts.append(wide.with_(z=(under.z.low, foot + 0.0004)).shrink(front=0.05).deep(_BOARD, None)[0].box())
    rear = wide.shrink(back=0.002).deep(None, 0.012)[1]
    parts.append(rear.with_(z=(foot, under.z.high - 0.0004)).box())
    look, middle = plan.cabinet.look, under.x.mid
    if not plan.cabinet.doors:
        plate = wide.deep(_BOARD, None)[0].with_(z=(under.z.high - above, under.z.high)).at(y=-0.0002)
        parts += [plate.with_(x=x).box(bevel=0.001) for x in _pairs(wide.x, apron)]
        return ag.part(ag.union(*parts), "cabinet", look.finish)
    boards = ag.part(ag.union(*parts), "cabinet", look.finish).at(x=-middle)
    case = Carcass(
        under.x.size, foot, under.z.high - above, *under.y, _BOARD, finish=look.finish, inside=look.finish
    )
    hanging = Hanging(case, "concealed", 2, _LEAF, (0.0, 1.0), above=0.0, below=0.0, metal=plan.metal)
    door, arms = hanging.region, hanging.on_side(ag.detail)
    made = ag.weld(boards, arms, arms.mirror(ag.X))
    face = under.with_(y=(door.y.low, case.front + 0.0004), z=(case.high + 0.0015, under.z.high - 0.0015))
    for x in _pairs(face.shrink(x=0.0015).x, apron):  # fronts like the doors, on the sides
        room = face.with_(x=x).at(x=-middle)
        style = look if apron == () else replace(look, style="flat")
        fixed = front(style, room.x.size, room.z.size, room.y.size, label="cabinet")
        made = ag.weld(made, ag.weld(*fixed).at(room.center))
    place = (door.x.high - look.rail / 2, door.y.low, door.z.high - 0.12)
    for side, name in ((1, "left"), (-1, "right")):
        leaf = hanging.leaf(look, plan.cabinet.handle(f"door_{name}_handle").at(place), name=f"door_{name}")
        hinge = hanging.joint(
            f"door_hinge_{name}", side=side, limit=plan.cabinet.swing, friction=7.0 * door.x.size, damping=0.4
        )
        made = made.attach(leaf if side > 0 else leaf.mirror(ag.X), hinge)
    return made.at(x=middle)


def _pairs(
    whole: tuple[ag.Scalar, ag.Scalar], gap: tuple[ag.Scalar, ...] | None
) -> list[tuple[ag.Scalar, ag.Scalar]]:
    """Return the spans of fixed panels: the whole, or both sides of a gap; no span for None."""
    ends = [whole[0], *(gap or ()), whole[1]]
    return [] if gap is None else list(zip(ends[::2], ends[1::2], strict=True))


def vessel(plan: Plan) -> tuple[ag.Body, list[ag.Vector], ag.Scalar]:
    """Make a bowl on a vanity; return it with its drain and the height under the tap."""
    half, deep, wall = plan.width / 2, plan.deep / 2, plan.wall
    y = -_NEAR - wall - deep
    levels = [0.016 + share * plan.hollow for share in (0.0, 0.36, 1.0)]
    shares = ((0.60, 0.52), (0.90, 0.86), (1.0, 1.0))
    outside = [plan.ring(out * half, out * deep) for out, _ in shares]
    inside = [plan.ring(ins * half - wall, ins * deep - wall) for _, ins in shares]
    angles = [math.tau * (step + 0.5) / 12 for step in range(12)]

    def corners(share: float, more: float) -> Points:
        return sanitary.rounded(share * half + more, share * deep + more, plan.power, angles)

    rings = [
        (corners(ins, 0.0085 - wall), corners(out, -0.001), z)
        for (out, ins), z in zip(shares, [levels[0] - 0.0005, levels[1], levels[2] - 0.0006], strict=True)
    ]
    slot = ag.box(drain.HOLE, drain.HOLE, 0.2).at(0, y)
    skin = ag.loft(outside, [0.0005, levels[1] - 0.006, levels[2]])
    skin -= ag.loft([*inside, inside[-1]], [*levels, levels[2] + 0.02])
    board = ag.Region((-half, half), (y - deep - 0.035, BACK), (-0.040, 0.001)).grow(x=plan.margin + 0.06)
    core = [each.at(0, y) for each in _shell(rings, drain.HOLE / 2, 0.014)]
    body = ag.weld(
        ag.part(core, "bowl", plan.shell, name="sink"),
        ag.detail(skin.at(0, y) - slot, "bowl", plan.shell),
        ag.part(board.box(bevel=0.002) - slot, "worktop", plan.top),
        _stood(plan, board),
    )
    return body, [ag.vector(0.0, y, levels[0])], 0.001


def washbasin(
    plan: Plan, maker: str, tiles: ag.Material, tile: ag.Scalar
) -> tuple[ag.Body, list[ag.Vector], ag.Scalar]:
    """Make a washbasin with its wall or its pedestal; return it with its drain and the height of its rim."""
    half, front, wall = plan.width / 2, plan.deep - BACK, plan.wall
    soft = 0.25 + 0.45 * plan.power
    angles = [math.pi * step / 24 for step in range(25)]

    def outline(wide: float, long: float) -> ag.Profile:
        points = sanitary.rounded(wide * half, long * front, soft, angles)
        ends = [(wide * half - x, BACK - z) for x, z in ((0.02, 0.0), (0.006, 0.006), (0.0, 0.02))]
        return ag.polygon([*ends, *points, *((-x, z) for x, z in reversed(ends))])

    shares = ((0.58, 0.82), (0.84, 0.95), (0.985, 0.99), (1.0, 1.0), (0.985, 0.99))
    low = -plan.hollow - wall
    shell = ag.hull(ag.loft([outline(*share) for share in shares], [low, 0.55 * low, -0.045, -0.008, 0.0]))
    wide, deep = half - 0.042, (front - _NEAR - 0.034) / 2
    y = -_NEAR - deep
    levels = ((0.46, 1.0), (0.78, 0.60), (0.94, 0.25), (1.0, 0.03), (1.0, -0.2))
    rings = [plan.ring(share * wide, share * deep) for share, _ in levels]
    cavity = ag.loft(rings, [-share * plan.hollow for _, share in levels]).at(0, y)
    slot = ag.box(drain.HOLE, drain.HOLE, 0.2).at(0, y, -plan.hollow)
    rod = ag.box(0.008, 0.008, 0.6).at(0, stands.ROD_AT)
    turns = [math.tau * (step + 0.5) / 12 for step in range(12)]

    def corners(share: float, more: float) -> Points:
        return sanitary.rounded(share * wide + more, share * deep + more, plan.power, turns)

    def edge(share: float, long: float) -> Points:
        ahead = [math.pi / 2 - 0.8 * (math.pi / 2 - turn) for turn in turns if turn < math.pi]
        before = sanitary.rounded(share * half, long * front, soft, ahead)
        behind = sanitary.rounded(share * half, 0.0, 0.3, (turn for turn in turns if turn > math.pi))
        return [(x, end - y) for x, end in [*before, *behind]]  # about the middle of the bowl

    core = _shell(
        [
            (corners(0.46, 0.0075), edge(0.56, 0.80), -plan.hollow - 0.0006),
            (corners(0.78, 0.0075), edge(0.80, 0.93), -0.60 * plan.hollow),
            (corners(1.0, 0.0070), edge(0.98, 0.985), -0.0006),
        ],
        drain.HOLE / 2,
        wall - 0.001,
    )
    deck = ag.Region((0.0045, 0.98 * half), (-0.030, BACK - 0.0005), (-0.042, -0.0005)).box()
    china = casting(plan.shell, 0.75)
    word, ink = details.logo(maker, 0.006), controls.ink_on(plan.shell)
    body = ag.weld(
        ag.part([*(each.at(0, y) for each in core), deck, deck.mirror(ag.X)], "bowl", china, name="sink"),
        ag.detail(shell - cavity - slot - rod, "bowl", plan.shell),
        details.printed(word, (0, -front + 0.016, 0), facing=ag.Z, material=ink),
    )
    if plan.stand == "wall":
        body = ag.weld(body, sanitary.tiled(BACK - 0.0005, tile, tiles, half=_HALF).at(z=-plan.rim))
    else:
        body = ag.weld(body, _pedestal(plan, low, y))
    return body, [ag.vector(0.0, y, -plan.hollow)], 0.0


def _pedestal(plan: Plan, low: ag.Scalar, y: ag.Scalar) -> ag.Body:
    """Make a pedestal, open behind, around the drain."""

    def corners(size: tuple[float, float], thick: float, steps: int) -> list[tuple[float, float]]:
        half, long = size[0] - thick, size[1] - thick
        turns = (math.pi * step / steps for step in range(steps + 1))
        front = [(float(x), float(z)) for x, z in sanitary.rounded(half, long, 0.7, turns)]
        return [(half, 0.09), *front, (-half, 0.09)]

    sizes = ((0.118, 0.128), (0.111, 0.121), (0.107, 0.117), (0.098, 0.110))
    tall = plan.rim + low + 0.03
    levels = [share * tall - plan.rim for share in (0.0, 0.06, 0.25, 1.0)]
    skin = ag.hull(ag.loft([ag.polygon(corners(size, 0.0, 24)) for size in sizes], levels))
    inside = [
        ag.polygon([(x, 1.2 * z if z > 0 else z) for x, z in corners(size, 0.016, 24)]) for size in sizes
    ]
    skin -= ag.loft(inside, [levels[0] - 0.01, *levels[1:-1], levels[-1] + 0.01])
    rings = [
        [[each[0], *each[2:-2], each[-1]] for each in (corners(size, thick, 4) for thick in (0.0155, 0.002))]
        for size in (sizes[1], sizes[3])
    ]
    panels = []
    for first, last in itertools.pairwise(range(len(rings[0][0]))):
        ends = [_between(inner, outer, first, last) for inner, outer in rings]
        panels.append(ag.hull(ag.loft(ends, [levels[0] + 0.0005, levels[-1] - 0.0005])).at(0, y))
    return ag.weld(
        ag.part(panels, "pedestal", casting(plan.shell, 0.8)),
        ag.detail(skin.at(0, y), "pedestal", plan.shell),
    )
