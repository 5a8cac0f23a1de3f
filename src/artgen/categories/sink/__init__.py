"""A sink with its tap: inset, undermount or with an apron for a kitchen; on a vanity, a wall or a pedestal.

Links: `sink`, with all that stands still; `spout`, and `spray_head` on its hose; `handle`, or `handle_left`
(hot) and `handle_right` (cold); `strainer`, the basket in the drain of a kitchen sink, with `knob`, which
lifts it; `plug` of a washbasin, with `lift_rod` and `pivot_rod`. Joints: those of a faucet; `strainer_lift`
of a basket that is lifted out, or `knob_turn` and `strainer_slide`, which follows it; `plug_lift`, or
`lift_rod_slide` with `pivot_rod_turn` and `plug_slide`, which follow it.

A second bowl has the suffix `_right`. With `stand="none"` a sink hangs in the worktop of a room by its rim.

Sizes are those of EN 13310, EN 14688 and of shops: kitchen bowls 340-500 by 340-420 mm and 150-220 mm deep,
worktops 600 mm deep at 860-920 mm, drains of 90 mm with baskets of 80 mm; washbasins 400-650 by 360-480 mm
with rims at 820-870 mm, drains of 1 1/4 inch. Steel is 0.8-1.2 mm thick, fireclay 20 mm. An apron sink of
fireclay weighs 30-50 kg, a washbasin 9-20 kg, a pedestal 7-10 kg. A rotary waste turns by a quarter and
lifts its basket by 10-14 mm.
"""

import functools
import itertools
import math
import operator
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.shared import controls, sanitary, taps
from artgen.categories.shared.finish import casting
from artgen.categories.shared.furniture import DECORS, LACQUERS, MELAMINES, WOODS
from artgen.categories.shared.taps import drain, handles, spouts, stands
from artgen.nodes.fitting import Fitting

Style = Literal["inset", "undermount", "apron", "vessel", "hung", "pedestal"]
"""For a kitchen: with a rim on a worktop, below one, or with a front of its own. For a bath: a bowl on a
vanity, or a washbasin on a wall or a pedestal."""

Bowls = Literal["single", "half", "double"]
"""One bowl, one with half a bowl beside it, or two equal ones."""

Shape = Literal["round", "soft", "square", "sharp"]
"""Outline of a bowl from above, by the radius of its corners."""

Stand = Literal["cabinet", "legs", "wall", "pedestal", "none"]
"""An open cabinet, four legs with a shelf, a tiled wall, a pedestal, or nothing."""

_POWERS: dict[Shape, float] = {"round": 1.0, "soft": 0.6, "square": 0.25, "sharp": 0.15}
_KITCHEN = ("inset", "undermount", "apron")
_BACK = 0.088  # from the axis of the tap to the rear of a worktop or of a washbasin [m]
_NEAR = 0.045  # from the axis of the tap to a bowl [m]
_BETWEEN = 0.026  # between two bowls [m]
_RIM = 0.036  # from a bowl to the edge of an inset sink [m]
_HOLE = 0.0405  # radius of the drain of a kitchen sink [m]
_CUP = 0.042  # depth of the strainer below the floor of a bowl [m]
_BOARD = 0.018  # thickness of the boards of a cabinet [m]
_LIFT = 0.012  # stroke of a rotary waste [m]
_SIDES = 32  # corners of the outline of a bowl
_HALF = 0.40  # half of the width of a wall [m]

_STEEL = ag.material("stainless").with_(name="sink_steel", density=2700.0)  # 1 mm of it in a wall of 3 mm
_CLAY = ag.material("ceramic").with_(name="fireclay", base_color=(0.84, 0.83, 0.80), specular_roughness=0.12)
_STONE = ag.material("granite").with_(name="composite", density=2200.0, specular_roughness=0.55)
_COMPOSITES = {
    "graphite": (0.050, 0.052, 0.056),
    "cream": (0.66, 0.60, 0.50),
    "grey": (0.26, 0.26, 0.26),
    "brown": (0.12, 0.085, 0.065),
}
_STONES = {
    _STONE.with_(name=f"composite_{name}", base_color=rgb, texture=""): 0.1
    for name, rgb in _COMPOSITES.items()
}
_METALS = ag.shades(
    "chrome", "stainless", "satin_nickel", "satin_brass", "powder_coat_black", weights=(4, 3, 2, 1, 2)
)
_WHITE = ag.material("polypropylene").with_(name="trap_white", base_color=(0.75, 0.75, 0.73))


@ag.category(
    labels="bowl rim drainer worktop cabinet foot wall tile pedestal drain trap basket plug knob escutcheon "
    "body valve collar handle index spout aerator spray_head hose guide lift_rod strap pivot_rod print",
    joints=(4, 7),
)
def sink(
    *,
    style: Style = ag.choice(
        {"inset": 0.3, "undermount": 0.16, "apron": 0.16, "vessel": 0.14, "hung": 0.12, "pedestal": 0.12}
    ),
    stand: Stand = ag.by(
        "style",
        vessel={"cabinet": 0.7, "legs": 0.3},
        hung="wall",
        pedestal="pedestal",
        otherwise={"cabinet": 0.75, "legs": 0.25},
    ),
    bowls: Bowls = ag.by(
        "style",
        inset={"single": 0.5, "half": 0.25, "double": 0.25},
        undermount={"single": 0.5, "half": 0.2, "double": 0.3},
        apron={"single": 0.7, "double": 0.3},
        otherwise="single",
    ),
    drainer: Literal["none", "left", "right"] = ag.by(
        "style", inset={"none": 0.3, "left": 0.35, "right": 0.35}, otherwise="none"
    ),
    shape: Shape = ag.by(
        "style",
        vessel={"round": 0.4, "soft": 0.25, "square": 0.35},
        hung={"round": 0.3, "soft": 0.3, "square": 0.4},
        pedestal={"round": 0.4, "soft": 0.6},
        otherwise={"square": 0.65, "sharp": 0.35},
    ),
    width: ag.Float = ag.by(
        "style",
        vessel=ag.uniform(0.40, 0.50),
        hung=ag.uniform(0.50, 0.64),
        pedestal=ag.uniform(0.52, 0.62),
        otherwise=ag.by(
            "bowls", single=ag.uniform(0.42, 0.54), half=ag.uniform(0.34, 0.40), double=ag.uniform(0.33, 0.39)
        ),
        unit="m",
        within=(0.3, 0.8),
        doc="width of a bowl, or of a washbasin",
    ),
    deep: ag.Float = ag.by(
        "style",
        vessel=ag.uniform(0.35, 0.40),
        hung=ag.uniform(0.42, 0.48),
        pedestal=ag.uniform(0.44, 0.50),
        otherwise=ag.uniform(0.36, 0.41),
        unit="m",
        within=(0.33, 0.52),
        doc="the same from front to back",
    ),
    hollow: ag.Float = ag.by(
        "style",
        vessel=ag.uniform(0.105, 0.135),
        hung=ag.uniform(0.115, 0.135),
        pedestal=ag.uniform(0.125, 0.15),
        apron=ag.uniform(0.19, 0.22),
        otherwise=ag.uniform(0.15, 0.20),
        unit="m",
        within=(0.09, 0.25),
        doc="depth of a bowl",
    ),
    rim: ag.Float = ag.by(
        "style",
        vessel=ag.uniform(0.72, 0.77),
        hung=ag.uniform(0.82, 0.87),
        pedestal=ag.uniform(0.80, 0.86),
        otherwise=ag.uniform(0.86, 0.92),
        unit="m",
        within=(0.65, 1.0),
        doc="height of the worktop or of the rim",
    ),
    margin: ag.Float = ag.uniform(0.05, 0.12, "m", within=(0.04, 0.3), doc="of a worktop beside the sink"),
    tap: Literal["gooseneck", "pull_down", "beam", "pair"] = ag.by(
        "style",
        vessel="beam",
        hung={"beam": 0.65, "pair": 0.35},
        pedestal={"beam": 0.4, "pair": 0.6},
        otherwise={"gooseneck": 0.5, "pull_down": 0.5},
    ),
    height: ag.Float = ag.by(
        "tap",
        gooseneck=ag.uniform(0.32, 0.42),
        pull_down=ag.uniform(0.40, 0.45),
        pair=ag.uniform(0.145, 0.19),
        beam=ag.by("style", vessel=ag.uniform(0.20, 0.25), otherwise=ag.uniform(0.070, 0.10)),
        unit="m",
        within=(0.05, 0.45),
        doc="height of the spout, or of the column under a straight one",
    ),
    reach: ag.Float = ag.by(
        "tap",
        beam=ag.uniform(0.120, 0.150),
        pair=ag.uniform(0.115, 0.15),
        otherwise=ag.uniform(0.18, 0.22),
        unit="m",
        within=(0.1, 0.26),
    ),
    spout: Literal["gooseneck", "arc", "angular"] = ag.choice(
        "arc", "angular", doc="spout between two handles"
    ),
    grip: handles.HandleStyle = ag.choice("lever", "blade", "cross", doc="style of two handles"),
    lever: handles.LeverStyle = ag.choice("rod", "blade", "paddle", doc="lever of a mixer"),
    square: bool = ag.choice(False, True, doc="whether a straight spout is flat"),
    plug: Literal["basket", "knob", "stopper", "rod"] = ag.by(
        "style",
        vessel="stopper",
        hung="stopper",
        pedestal={"stopper": 0.4, "rod": 0.6},
        otherwise={"basket": 0.55, "knob": 0.45},
        doc="a basket or stopper that lifts off, or a knob or rod that moves it",
    ),
    metal: ag.Material = _METALS,
    shell: ag.Material = ag.by(
        "style",
        inset=ag.choice({_STEEL: 0.6, **_STONES}),
        undermount=ag.choice({_STEEL: 1.6, **_STONES}),
        apron=ag.choice({_CLAY: 1.6, _STEEL: 0.5, **_STONES}),
        otherwise=sanitary.GLAZES,
        doc="material of the bowl",
    ),
    top: ag.Material = ag.by(
        "style",
        inset=ag.choice("oak", "walnut", "beech", "granite", "black_granite", *DECORS[:2]),
        undermount=ag.choice("granite", "black_granite", "marble", "green_marble"),
        otherwise=ag.choice("oak", "walnut", "marble", "black_granite", "granite"),
        doc="material of the worktop",
    ),
    finish: ag.Material = ag.choice(*LACQUERS[:8], *WOODS[:3], *MELAMINES[:2], doc="boards of a cabinet"),
    tiles: ag.Material = sanitary.TILES,
    tile: ag.Float = ag.uniform(0.10, 0.30, "m", within=(0.1, 0.4), doc="height of the tiles of a wall"),
    maker: str = ag.choice(*details.BRANDS),
) -> ag.Body:
    """Make a sink with the plug in its drain and with its tap shut; worktops and walls are at the back."""
    ag.require((style in _KITCHEN) == (tap in ("gooseneck", "pull_down")), "kitchens have high spouts")
    ag.require((style in _KITCHEN) == (plug in ("basket", "knob")), "kitchens have strainers")
    ag.require(style not in ("vessel", "hung") or plug != "rod", "a lift rod is for style=pedestal")
    ag.require(stand != "none" or style == "inset", "stand=none is for style=inset, which has a rim")
    if shape == "round" and style in ("hung", "pedestal"):
        most = "width of a round washbasin must be <= 0.65 m and at most 0.23 m more than deep"
        width = ag.require(width, ag.max_(width - 0.65, width - deep - 0.23) <= 0.0, most)
    middle: ag.Scalar = 0.0
    plan = _Plan(style, stand, _POWERS[shape], width, deep, hollow, rim, margin, shell, metal, top)
    if style in _KITCHEN:
        body, places, ledge, middle = _kitchen(plan, bowls, drainer, finish)
    elif style == "vessel":
        over = "the tap of a vessel must be 0.034 m higher: raise height, or lower hollow"
        height = ag.require(height, height - hollow >= 0.034, over)
        body, places, ledge = _vessel(plan, finish)
    else:
        body, places, ledge = _washbasin(plan, maker, tiles, tile)
    body = _tapped(body, plan, ledge, tap, height, reach, spout, grip, lever, square=square)
    return _drained(body, plan, places, plug, middle)


@dataclass(frozen=True)
class _Plan:
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

    @property
    def wall(self) -> float:
        """Thickness of the walls of a bowl [m]."""
        return 0.008 if self.style in _KITCHEN else 0.014

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
    plan: _Plan, half: ag.Scalar, deep: ag.Scalar, top: ag.Scalar, rim: ag.Scalar
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
    return _shell(levels, _HOLE + 0.0015, 0.005) + plates


def _around(room: ag.Region, row: list[tuple[ag.Scalar, ag.Scalar]], near: ag.Scalar) -> list[ag.Solid]:
    """Make the boards of a frame around bowls: before, behind, beside and between them."""
    y = (near, -_NEAR)
    cells = [room.with_(y=(room.y.low, y[0] - 0.001)), room.with_(y=(y[1] + 0.001, room.y.high))]
    sides = [end for x, half in row for end in (x - half - 0.001, x + half + 0.001)]
    edges = [room.x.low, *sides, room.x.high]
    cells += [room.with_(x=pair, y=y).grow(y=0.0015) for pair in zip(edges[::2], edges[1::2], strict=True)]
    return [cell.box() for cell in cells]


def _kitchen(
    plan: _Plan, bowls: Bowls, drainer: str, finish: ag.Material
) -> tuple[ag.Body, list[ag.Vector], ag.Scalar, ag.Scalar]:
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
    drains = ag.array(ag.cylinder(_HOLE + 0.001, 0.1), at=places)
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
    board = room.with_(z=(-thick, 0.0), y=(near - 0.075, _BACK))
    board = board.grow(x=plan.margin + (0.02 if plan.style == "apron" else 0.0))
    slab = board.box(bevel=0.002)
    if plan.style == "undermount":
        inside = board.shrink(0.0005)
        boards = _around(inside, row, near)
        top = ag.weld(ag.part(boards, "worktop", plan.top), ag.detail(slab - cavity, "worktop", plan.top))
    else:
        top = ag.part(slab - hole.with_(z=(-0.1, 0.1)).box(), "worktop", plan.top)
    front = plan.hollow + 0.05 if plan.style != "apron" else None
    return ag.weld(body, top, _stood(plan, board, front, finish)), places, level, room.x.mid


def _ribs(room: ag.Region, drainer: str, ends: ag.Span, finish: ag.Material) -> ag.Body:
    """Make the ribs of a drainer, on which dishes stand, in low relief."""
    x = (room.x.low + 0.03, ends[0] - 0.03) if drainer == "left" else (ends[1] + 0.03, room.x.high - 0.03)
    field = room.with_(x=x).shrink(y=0.035).with_(z=(0.0022, 0.0042))
    ribs = [cell.shrink(x=0.0055, y=0.0).box(bevel=0.0009) for cell in field.columns(12)]
    return ag.detail(ag.union(*ribs), "drainer", finish)


def _stood(plan: _Plan, board: ag.Region, front: ag.Scalar | None, finish: ag.Material) -> ag.Body:
    """Make an open cabinet or legs with a shelf below a board; `front` is the height of a fixed panel."""
    under = board.with_(z=(-plan.rim, board.z.low + 0.0003)).shrink(x=0.012, front=0.03, back=0.004)
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
    if front is not None:
        panel = wide.deep(_BOARD, None)[0].at(y=-0.0002)
        parts.append(panel.with_(z=(under.z.high - front, under.z.high)).box(bevel=0.001))
    return ag.part(ag.union(*parts), "cabinet", finish)


def _vessel(plan: _Plan, finish: ag.Material) -> tuple[ag.Body, list[ag.Vector], ag.Scalar]:
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
    board = ag.Region((-half, half), (y - deep - 0.035, _BACK), (-0.040, 0.001)).grow(x=plan.margin + 0.06)
    core = [each.at(0, y) for each in _shell(rings, drain.HOLE / 2, 0.014)]
    body = ag.weld(
        ag.part(core, "bowl", plan.shell, name="sink"),
        ag.detail(skin.at(0, y) - slot, "bowl", plan.shell),
        ag.part(board.box(bevel=0.002) - slot, "worktop", plan.top),
        _stood(plan, board, None, finish),
    )
    return body, [ag.vector(0.0, y, levels[0])], 0.001


def _washbasin(
    plan: _Plan, maker: str, tiles: ag.Material, tile: ag.Scalar
) -> tuple[ag.Body, list[ag.Vector], ag.Scalar]:
    """Make a washbasin with its wall or its pedestal; return it with its drain and the height of its rim."""
    half, front, wall = plan.width / 2, plan.deep - _BACK, plan.wall
    soft = 0.25 + 0.45 * plan.power
    angles = [math.pi * step / 24 for step in range(25)]

    def outline(wide: float, long: float) -> ag.Profile:
        points = sanitary.rounded(wide * half, long * front, soft, angles)
        ends = [(wide * half - x, _BACK - z) for x, z in ((0.02, 0.0), (0.006, 0.006), (0.0, 0.02))]
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
    deck = ag.Region((0.0045, 0.98 * half), (-0.030, _BACK - 0.0005), (-0.042, -0.0005)).box()
    china = casting(plan.shell, 0.75)
    word, ink = details.logo(maker, 0.006), controls.ink_on(plan.shell)
    body = ag.weld(
        ag.part([*(each.at(0, y) for each in core), deck, deck.mirror(ag.X)], "bowl", china, name="sink"),
        ag.detail(shell - cavity - slot - rod, "bowl", plan.shell),
        details.printed(word, (0, -front + 0.016, 0), facing=ag.Z, material=ink),
    )
    if plan.stand == "wall":
        body = ag.weld(body, sanitary.tiled(_BACK - 0.0005, tile, tiles, half=_HALF).at(z=-plan.rim))
    else:
        body = ag.weld(body, _pedestal(plan, low, y))
    return body, [ag.vector(0.0, y, -plan.hollow)], 0.0


def _pedestal(plan: _Plan, low: ag.Scalar, y: ag.Scalar) -> ag.Body:
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


def _tapped(
    body: ag.Body,
    plan: _Plan,
    ledge: ag.Scalar,
    tap: str,
    height: ag.Scalar,
    reach: ag.Scalar,
    spout: spouts.SpoutStyle,
    grip: handles.HandleStyle,
    lever: handles.LeverStyle,
    *,
    square: bool,
) -> ag.Body:
    """Set a tap on the sink, or on the worktop behind it."""
    girth, radius, disc = 0.0120, 0.0235, 0.5
    length = 0.095 if plan.style in _KITCHEN else 0.082
    place, tube = stands.Ledge(body, ledge), spouts.Spout(reach, girth, plan.metal)

    def mixer(size: float) -> ag.Body:
        return handles.mixer(lever, length, plan.metal, 0.45, disc, size)

    match tap:
        case "beam":
            stand = stands.topped_column(
                place, radius, height, taps.ring_of(girth), mixer(radius), plan.metal
            )
            spout = "beam"
        case "pair":
            stand = stands.widespread(place, girth, plan.metal)
        case _:
            stand = stands.sided_column(place, radius, mixer(stands.SIDE), "right", plan.metal)
            spout = "gooseneck"
    body = taps.attach_spout(
        stand,
        tube,
        "pull_down" if tap == "pull_down" else spout,
        height,
        hub=radius,
        square=square,
        head=(0.06, 11.0),
        lever=length,
        turn=1.5 if plan.style in _KITCHEN else 1.1,
        friction=1.0,
    )
    if stand.valves:
        pair = (stand.valves, grip, 0.062, plan.metal, plan.metal, disc)
        body = handles.install_pair(
            body, *pair, flange=True, from_tip=False, lean=0.4 if plan.stand == "wall" else 0.0
        )
    return body


def _drained(body: ag.Body, plan: _Plan, places: list[ag.Vector], plug: str, middle: ag.Scalar) -> ag.Body:
    """Put drains with plugs and traps under the bowls; stand all of it with its middle on the floor."""
    if plug == "rod":
        at, thick = places[0], plan.wall
        body = drain.install(
            body, at, stands.ROD_AT - at.y, thick + 0.004, plan.metal, 7.0, above=plan.hollow
        )
    elif plug == "stopper":
        body = drain.stopped(body, places[0], 0.054 if plan.style == "vessel" else plan.wall, plan.metal)
    else:
        turn = None
        if plug == "knob":
            turn = controls.dial_turn(low=0.0, high=math.pi / 2, friction=0.12)
            knob = controls.control_knob(
                finish=plan.metal, style="round", radius=0.018, depth=0.022, mark=controls.DARK_INK
            )
            waste = Fitting.moving(knob, turn).rotate(ag.X, -math.pi / 2).rotate(ag.Z, math.pi / 2)
            body = body.install(waste, at=(-0.125, 0.0, 0.0025 if plan.style == "inset" else 0.0))
        for number, at in enumerate(places):
            suffix = "" if number == 0 else "_right"
            body = _strained(body, at, suffix, turn if number == 0 else None)
    for at in places:
        body = ag.weld(body, _trap(plan, at))
    return body.at(x=-middle, z=plan.rim)


def _strained(body: ag.Body, at: ag.Vector, suffix: str, knob: ag.Joint | None) -> ag.Body:
    """Put a strainer with its basket into the floor of a bowl; a knob lifts the basket, or a hand does."""
    steel, low = ag.material("stainless"), -_CUP
    cup = ag.box(0.082, 0.082, 0.004).at(z=low + 0.001)
    bore = _HOLE - 0.001
    rim = [(bore, low + 0.003), (bore + 0.0006, -0.006), (bore + 0.004, -0.0002), (0.0605, -0.0004)]
    rim += [(0.0595, 0.0011), (bore + 0.005, 0.0013), (bore, -0.006), (bore - 0.0006, low + 0.003)]
    pipe = ag.cylinder(0.019, 0.10).at(z=low - 0.0505)
    fixed = ag.weld(
        ag.part([cup, pipe], "drain", steel.with_(name="strainer_steel", density=3000.0)),
        ag.detail(ag.revolve(ag.polygon(rim)), "drain", steel),
    )
    floor = low + 0.0045
    disc = ag.cylinder(0.0330, 0.003, bevel=0.0008).at(z=floor + 0.0015)
    neck = ag.cylinder_between((0, 0, floor + 0.002), (0, 0, 0.006), 0.0035)
    knot = ag.cylinder(0.0095, 0.013, bevel=0.003).at(z=0.0105)
    side = [(0.0318, floor + 0.0006), (0.0366, -0.003), (0.0385, 0.0004), (0.0385, 0.0014), (0.0372, 0.0012)]
    side += [(0.0356, -0.003), (0.0308, floor + 0.0010)]
    holes = [ag.circle(0.0022).at(r * math.cos(a), r * math.sin(a)) for r, a in _sieve()]
    film = details.printed(
        functools.reduce(operator.or_, holes),
        (0, 0, floor + 0.003),
        facing=ag.Z,
        material=controls.DARK_INK,
        label="basket",
        proud=0.0001,
    )
    hold = ag.grasp_on(knot, approach=-ag.Z, closing=ag.Y, depth=0.0095)  # half a bowl is narrow
    basket = ag.weld(
        ag.part(ag.union(disc, neck, knot), "basket", steel, name="strainer", grasp=hold),
        ag.detail(ag.revolve(ag.polygon(side)), "basket", steel),
        film,
    )
    moves = drain.lifted("strainer_lift")
    if knob is not None:
        stroke = (_LIFT / (math.pi / 2)) * knob
        moves = ag.Prismatic("strainer_slide", axis=ag.Z, follows=stroke, damping=2.0, armature=0.01)
    return body.install(Fitting.moving(basket, moves, fixed=fixed).suffixed(suffix), at=at)


def _sieve() -> list[tuple[float, float]]:
    """Return radii and angles of the holes of a basket."""
    rings = ((0.013, 8), (0.020, 14), (0.027, 20))
    return [(radius, math.tau * step / count) for radius, count in rings for step in range(count)]


def _trap(plan: _Plan, at: ag.Vector) -> ag.Body:
    """Make a bottle trap below a drain, with its pipe to the wall."""
    kitchen = plan.style in _KITCHEN
    low = at - ag.Z * (0.13 if kitchen else drain.HANGS - 0.004)
    bottle = ag.cylinder(0.030, 0.11, bevel=0.004).align(low, z=1)
    end = ag.vector(at.x, _BACK - 0.012, low.z - 0.035)
    arm = ag.cylinder_between(low - ag.Z * 0.035, end, 0.016)
    finish = _WHITE if kitchen else plan.metal
    return ag.part(bottle | arm, "trap", casting(finish, 0.3))
