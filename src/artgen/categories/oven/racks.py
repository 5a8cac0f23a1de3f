"""Wire racks and a deep pan of an oven, the rails that carry them, and the heating element."""

import math
from collections.abc import Sequence
from functools import reduce
from operator import and_

import artgen as ag
from artgen import details
from artgen.categories.oven.case import REACH, SEAL, Plan

PLAY = REACH + SEAL - 0.0012
"""Travel of a rack behind the closed door [m]."""

_LEVELS = 5  # number of rack levels of the rails
_ROD = 0.0030  # radius of the rods of rails and racks [m]
_GAP = 0.0008  # gap between a rack and its rails [m]
_CORNER = 0.014  # radius of the corners of a rack [m]
_STOP, _STOP_WIRE = 0.016, 0.0022  # height of the stop at the back of a rack, and radius of its wire [m]
_PAN, _SHEET = 0.034, 0.0022  # depth of a pan below its rim, and its thickness [m]
_HEATING, _TUBE = 0.014, 0.0034  # distance from the ceiling to the heating element, radius of its tube [m]
_LEAST = 0.0012  # least gap between a rack and the door at the angle at which the rack may slide out [m]
_CHROME = ag.material("chrome").with_(name="rack_chrome", density=15000.0)  # with the visual-only wires
# density of 0.6 mm of sheet, modeled 2.2 mm thick
_ENAMEL = ag.colored("enamel", "anthracite").with_(name="pan_enamel", density=2200.0)
_HERE = ((0.0, 0.0, 0.0),)


def _rail(plan: Plan, level: int) -> ag.Scalar:
    """Return the height of the middle of the rails at a level, counted from below [m]."""
    return plan.cavity.z.at((level + 0.75) / (_LEVELS + 0.6))


def _rods(plan: Plan, level: int) -> ag.Scalar:
    """Return the height of the middle of the rods of a rack at a level [m]."""
    return _rail(plan, level) + 2 * _ROD + _GAP


def rails(plan: Plan, used: Sequence[int]) -> ag.Body:
    """Make the rails at both sides: rods for racks, and uprights; only the rods in use collide."""
    room = plan.cavity.shrink(front=0.012, back=0.004)
    every, inside = range(_LEVELS), room.x.high

    def rods(radius: float, levels: Sequence[int], above: float = 0.0) -> ag.Solid:
        at = [
            (side * (inside - 0.0095), room.y.mid, _rail(plan, each) + above)
            for side in (-1, 1)
            for each in levels
        ]
        return ag.array(ag.cylinder(radius, room.y.size, axis=ag.Y), at=at)

    low, high = _rail(plan, 0) - 0.012, _rail(plan, _LEVELS - 1) + 0.028
    posts = [  # near the walls, so that racks pass in front of them
        (side * (inside - 0.0022), y, (low + high) / 2)
        for side in (-1, 1)
        for y in (room.y.low + 0.035, room.y.high - 0.035)
    ]
    seen = [
        rods(_ROD, [each for each in every if each not in used]),
        rods(0.0022, every, above=0.019),  # they keep racks from tipping
        ag.array(ag.cylinder(0.0020, high - low), at=posts),
    ]
    reason = "each rod is welded to the uprights"
    return ag.weld(
        ag.part(rods(_ROD, used), "rail", _CHROME, separate=reason), ag.detail(seen, "rail", _CHROME)
    )


def rack(plan: Plan, level: int, name: str) -> ag.Body:
    """Make a wire rack at a level."""
    half, deep = plan.racks.x.high, plan.racks.y.size
    x, y = half - _ROD, deep / 2 - _ROD
    thin = _ROD - 0.0002  # rods that collide are inside the visible ones
    rim = ag.polyline(
        [(0, -y, 0), (x, -y, 0), (x, y, 0), (-x, y, 0), (-x, -y, 0)], fillet=_CORNER, closed=True
    )
    count, wire = {"built_in": 22, "range": 27}[plan.build], 0.0016  # wires on the frame, between its corners
    step = 2 * (x - _CORNER) / (count - 1)
    grid = ag.row((-(x - _CORNER), 0, _ROD + wire), ag.X * step, count)
    # the wire at the back keeps pots from falling off, and the rack from sliding out too far
    end = 0.94 * half
    stop = ag.polyline([(-end, y, 0), (-end, y, _STOP), (end, y, _STOP), (end, y, 0)], fillet=0.008)
    seen = [
        details.bent_wires(rim, _ROD, at=_HERE),
        details.bent_wires(ag.line((0, -y, 0), (0, y, 0)), wire, at=grid),
        ag.cylinder(thin, 2 * x, axis=ag.X),
        details.bent_wires(stop, _STOP_WIRE, at=_HERE),
    ]
    across = ag.cylinder(thin, 2 * (half - _CORNER), axis=ag.X)
    along = ag.cylinder(thin, deep - 2 * _CORNER, axis=ag.Y)
    inner = ag.cylinder(0.0015, deep - 2 * _ROD, axis=ag.Y)
    solids = [
        across.at(y=-y),
        across.at(y=y),
        ag.array(along, at=[(-x, 0, 0), (x, 0, 0)]),
        ag.array(inner, at=[(share * half, 0, 0.0011) for share in (-0.5, 0, 0.5)]),
        ag.cylinder(0.0020, 1.8 * half, axis=ag.X).at(0, y, _STOP),
    ]
    # under the panel a hand comes from below by one facet of the rod, and grasps only the rod, not the wires
    lean, before = (math.pi / 8, 0.006) if level == _LEVELS - 1 else (0.0, -0.0005)
    rise, run = math.sin(lean), math.cos(lean)
    hold = ag.frame((0, -y - before * run, -before * rise), approach=(0, run, rise), closing=(0, -rise, run))
    welded = "rods of a rack are joined by the bent ones, which are only seen"
    body = ag.weld(
        ag.part(solids, "rack", _CHROME, name=name, grasp=hold, grasp_width=0.016, separate=welded),
        ag.detail(seen, "rack", _CHROME),
    )
    return body.at(0, plan.racks.y.mid, _rods(plan, level))


def pan(plan: Plan, level: int, name: str) -> ag.Body:
    """Make a deep enameled pan at a level, with its rim on the rails."""
    x, y, _ = plan.racks.size
    less, wide = 0.0004, 0.016  # width of the rim [m]
    rim = ag.Region.centered(x, y, _SHEET)
    room = rim.shrink(x=wide, y=wide).with_(z=(-_PAN, _SHEET / 2))
    walls = room.shrink(bottom=less, top=less)
    front, _, back = rim.shrink(x=less).deep(wide + _SHEET, None, wide + _SHEET)
    boards = [
        *rim.shrink(y=wide, z=less).across(wide + _SHEET, None, wide + _SHEET)[::2],
        *walls.shrink(x=less).deep(_SHEET, None, _SHEET)[::2],
        *walls.shrink(x=2 * less, y=less).across(_SHEET - 2 * less, None, _SHEET - 2 * less)[::2],
    ]
    floor = room.with_(z=(-_PAN, _SHEET - _PAN)).box(bevel=0.001)
    solids = [front.box(bevel=0.0009), back.box(bevel=0.0009), floor, *(each.box() for each in boards)]
    # tips, which reach 9 mm beyond the frame, end before the wall under the rim
    hold = ag.frame((0, rim.y.low + 0.0045, 0))
    body = ag.part(solids, "pan", _ENAMEL, name=name, grasp=hold, grasp_width=0.014)
    return body.at(0, plan.racks.y.mid, _rods(plan, level) - _ROD + _SHEET / 2)


def clear_angle(plan: Plan, level: int, *, travel: ag.Scalar, pan: bool) -> ag.Scalar:
    """Return the angle of the open door that clears the path of a rack or a pan [rad].

    The inside of the door clears the farthest point of the rack if the door leans beyond the direction of
    that point by the angle that its distance from the axis subtends at that point.
    """
    low = _rods(plan, level) - _ROD - (_PAN + _SHEET if pan else 0)
    across, up = travel - (plan.racks.y.low - plan.hinge[1]), low - plan.hinge[2]
    far = ag.sqrt(across * across + up * up)
    share = (plan.arm + _LEAST) / far
    return ag.atan2(across, up) + ag.atan2(share, ag.sqrt(1 - share * share))


def apart(plan: Plan, levels: Sequence[int], *, pan: bool) -> ag.Bool | bool:
    """Return whether racks at these levels are clear of each other and of the heating element."""
    middles = [_rods(plan, level) for level in levels]
    lows, highs = [each - _ROD for each in middles], [each + _STOP + _STOP_WIRE for each in middles]
    if pan and len(levels) > 1:
        lows[1], highs[1] = lows[1] + _SHEET / 2 - _PAN, middles[1]
    lows.append(plan.cavity.z.high - _HEATING - _TUBE)
    return reduce(and_, (high < low - 0.001 for high, low in zip(highs, lows[1:], strict=True)))


TUBE = ag.material("black_steel").with_(name="heating_tube", base_color=(0.06, 0.057, 0.055))
"""Tube of the heating element."""


def element(plan: Plan) -> ag.Body:
    """Make the heating element under the ceiling: a tube in meanders, visual only."""
    field = plan.cavity.shrink(x=0.34 * plan.cavity.x.high, y=0.06)
    level, points = field.z.high - _HEATING, []
    for column in range(6):  # the outer two go on into the back wall
        ends = (field.y.low, plan.cavity.y.high if column in (0, 5) else field.y.high)
        points += [(field.x.at(column / 5), y, level) for y in (ends if column % 2 else ends[::-1])]
    path = ag.polyline(points, fillet=0.018)
    hangers = ag.line((0, 0, 0), ag.Z * 0.016)
    at = [(share * field.x.high, field.y.mid, level) for share in (-1.0, -0.2, 0.6)]
    return ag.weld(
        ag.detail(details.bent_wires(path, _TUBE, at=_HERE), "element", TUBE),
        ag.detail(details.bent_wires(hangers, 0.0014, at=at), "element", ag.material("steel")),
    )
