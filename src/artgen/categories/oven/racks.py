"""Parts on the rails of an oven, wire racks and a deep pan, and the rails themselves."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import reduce
from operator import and_

import artgen as ag
from artgen import details
from artgen.categories.oven.space import LEVELS, ROD, Build, Space
from artgen.categories.shared.baskets import rack_slide

_INSIDE = 0.0002  # difference between the radii of visible and colliding rods [m]
_WIRE = 0.0016  # radius of the wires of a rack [m]
_WIRES: dict[Build, int] = {"built_in": 22, "range": 27}  # number of these wires
# tilt of a hand that takes the highest rack from below: one facet of its rod [rad]
_FROM_BELOW = math.pi / 8.0
_CORNER = 0.014  # radius of the corners of a rack [m]
_STOP, _STOP_WIRE = 0.016, 0.0022  # height of the stop at the back of a rack, and radius of its wire [m]
_PAN = 0.034  # depth of a pan below its rim [m]
_SHEET = 0.0022
# distance from the ceiling down to the heating element, and radius of its tube [m]
_HEATING, _TUBE = 0.014, 0.0034
_GUIDE = 0.019  # height of the rod that keeps a rack from tipping, above the rods that carry the rack [m]

_WELDED = "rods of a rack are joined by the bent ones, which are only seen"


@dataclass(frozen=True)
class Racks:
    """Racks of an oven."""

    space: Space  # dimensions of the oven
    chrome: ag.Material  # material of the wires
    enamel: ag.Material  # enamel of pans
    friction: ag.Scalar  # friction of a rack on its rails [N]

    def rails(self, used: Sequence[int]) -> ag.Body:
        """Make the rails at both sides: rods for racks, and uprights; only the rods in use collide."""
        space = self.space
        front, back = space.mouth + 0.012, space.back - 0.004
        x, middle = space.inside - 0.0095, (front + back) / 2.0
        rod, thin = ag.cylinder(ROD, back - front, axis=ag.Y), ag.cylinder(0.0022, back - front, axis=ag.Y)

        def places(levels: Sequence[int], above: float = 0.0) -> list[ag.VectorLike]:
            return [(side * x, middle, space.level(each) + above) for side in (-1, 1) for each in levels]

        every = range(LEVELS)
        free = [each for each in every if each not in used]
        low, high = space.level(0) - 0.012, space.level(LEVELS - 1) + 0.028
        post = ag.cylinder(0.0020, high - low)
        posts: list[ag.VectorLike] = [  # near the walls, so that racks pass in front of them
            (side * (space.inside - 0.0022), y, (low + high) / 2.0)
            for side in (-1, 1)
            for y in (front + 0.035, back - 0.035)
        ]
        seen = [
            ag.array(rod, at=places(free)),
            ag.array(thin, at=places(every, _GUIDE)),
            ag.array(post, at=posts),
        ]
        solid = ag.array(rod, at=places(used))
        return ag.weld(
            ag.part(solid, "rail", self.chrome, separate="each rod is welded to the uprights"),
            *(ag.detail(each, "rail", self.chrome) for each in seen),
        )

    def rack(self, name: str, level: int) -> ag.Body:
        """Make a wire rack at a level."""
        space = self.space
        half, deep = space.rack_half, space.rack_depth
        thin, x, y = ROD - _INSIDE, half - ROD, deep / 2.0 - ROD
        rim: list[ag.VectorLike] = [(0.0, -y, 0.0), (x, -y, 0.0), (x, y, 0.0), (-x, y, 0.0), (-x, -y, 0.0)]
        here = ((0.0, 0.0, 0.0),)
        loop = details.bent_wires(ag.polyline(rim, fillet=_CORNER, closed=True), ROD, at=here)
        count = _WIRES[space.build]  # wires on the frame, between its corners
        step = 2.0 * (half - _CORNER - ROD) / (count - 1)
        first = (-0.5 * (count - 1) * step, 0.0, ROD + _WIRE)
        wires = details.bent_wires(
            ag.line((0.0, -y, 0.0), (0.0, y, 0.0)), _WIRE, at=ag.row(first, ag.X * step, count)
        )
        brace = ag.cylinder(thin, 2.0 * x, axis=ag.X)
        across = ag.cylinder(thin, 2.0 * (half - _CORNER), axis=ag.X)
        along = ag.cylinder(thin, deep - 2.0 * _CORNER, axis=ag.Y)
        inner = ag.cylinder(0.0015, deep - 2.0 * ROD, axis=ag.Y)
        ends = [(0.0, way * (deep / 2.0 - ROD), 0.0) for way in (-1, 1)]
        sides = [(way * (half - ROD), 0.0, 0.0) for way in (-1, 1)]
        rows = [(share * half, 0.0, 0.0011) for share in (-0.5, 0.0, 0.5)]
        # the wire at the back keeps pots from falling off, and the rack from sliding out too far
        z = _STOP
        stop = ag.polyline(
            [(-0.94 * half, y, 0.0), (-0.94 * half, y, z), (0.94 * half, y, z), (0.94 * half, y, 0.0)],
            fillet=0.008,
        )
        high = ag.cylinder(0.0020, 1.8 * half, axis=ag.X).at(0.0, y, z)
        # under the panel a hand comes from below, and grasps only the rod, not the wires behind it
        lean, before = (_FROM_BELOW, 0.006) if level == LEVELS - 1 else (0.0, -0.0005)
        toward, over = (0.0, math.cos(lean), math.sin(lean)), (0.0, -math.sin(lean), math.cos(lean))
        at = (0.0, ROD - deep / 2.0 - before * toward[1], -before * toward[2])
        hold = ag.frame(at, approach=toward, closing=over)
        body = ag.weld(
            ag.part(
                ag.array(across, at=ends[:1]), "rack", self.chrome, name=name, grasp=hold, grasp_width=0.016
            ),
            ag.part(ag.array(across, at=ends[1:]), "rack", self.chrome, separate=_WELDED),
            ag.part(ag.array(along, at=sides), "rack", self.chrome),
            ag.part(ag.array(inner, at=rows), "rack", self.chrome),
            ag.part(high, "rack", self.chrome),
            *(ag.detail(each, "rack", self.chrome) for each in (loop, wires, brace)),
            ag.detail(details.bent_wires(stop, _STOP_WIRE, at=here), "rack", self.chrome),
        )
        return body.at(0.0, space.rack_front + deep / 2.0, space.rack(level))

    def pan(self, name: str, level: int) -> ag.Body:
        """Make a deep enameled pan at a level, with its rim on the rails."""
        space = self.space
        half, deep = space.rack_half, space.rack_depth
        rim = 0.016
        x, y = half - rim, deep / 2.0 - rim
        low, sheet = -_PAN, _SHEET
        less = 0.0004
        boards = [
            ag.Region((-x, x), (-y, y), (low, low + sheet)).box(bevel=0.001),
            *(
                ag.Region(
                    (-half + less, half - less),
                    (way * (y - sheet), way * (y + rim)) if way > 0 else (-(y + rim), sheet - y),
                    (-sheet / 2.0, sheet / 2.0),
                ).box(bevel=0.0009)
                for way in (-1, 1)
            ),
            *(
                ag.Region(
                    (x - sheet, half) if way > 0 else (-half, sheet - x),
                    (-y, y),
                    (less - sheet / 2.0, sheet / 2.0 - less),
                ).box()
                for way in (-1, 1)
            ),
            *(
                ag.Region(
                    (less - x, x - less),
                    (y - sheet, y) if way > 0 else (-y, sheet - y),
                    (low + less, sheet / 2.0 - less),
                ).box()
                for way in (-1, 1)
            ),
            *(
                ag.Region(
                    (x - sheet, x - 2.0 * less) if way > 0 else (2.0 * less - x, sheet - x),
                    (less - y, y - less),
                    (low + less, sheet / 2.0 - less),
                ).box()
                for way in (-1, 1)
            ),
        ]
        # tips, which reach 9 mm beyond the frame, end before the wall under the rim
        hold = ag.frame((0.0, 0.0045 - deep / 2.0, 0.0), approach=(0.0, 1.0, 0.0), closing=(0.0, 0.0, 1.0))
        first, front, *others = boards
        body = ag.weld(
            ag.part(front, "pan", self.enamel, name=name, grasp=hold, grasp_width=0.014),
            ag.part(first, "pan", self.enamel),
            *(ag.part(each, "pan", self.enamel) for each in others),
        )
        level_ = space.rack(level) - ROD + sheet / 2.0
        return body.at(0.0, space.rack_front + deep / 2.0, level_)

    def low(self, level: int, *, pan: bool) -> ag.Scalar:
        """Return the lowest height of a rack or a pan [m]."""
        return self.space.rack(level) - ROD - (_PAN + _SHEET if pan else 0.0)

    def apart(self, levels: Sequence[int], *, pan: bool) -> ag.Bool | bool:
        """Return whether racks at these levels are clear of each other and of the heating element."""
        spans: list[ag.Span] = []
        for number, level in enumerate(levels):
            middle = self.space.rack(level)
            if pan and number == 1:
                spans.append((middle - ROD + _SHEET / 2.0 - _PAN, middle))
            else:
                spans.append((middle - ROD, middle + _STOP + _STOP_WIRE))
        lows = [*(low for low, _ in spans[1:]), self.space.ceiling - _HEATING - _TUBE]
        return reduce(and_, (high < low - 0.001 for (_, high), low in zip(spans, lows, strict=True)))

    def slide(self, name: str, needs: ag.Condition | ag.Dependency) -> ag.Joint:
        """Make the joint by which a rack slides out; its effort cannot open the closed door."""
        return rack_slide(name, travel=self.space.slide, friction=self.friction, damping=6.0, needs=needs)


def element(space: Space) -> ag.Body:
    """Make the heating element under the ceiling: a tube in meanders, visual only."""
    x, y0, y1 = 0.66 * space.inside, space.mouth + 0.06, space.back - 0.06
    level = space.ceiling - _HEATING
    turns = 5
    points: list[ag.VectorLike] = [(-x, space.back, level), (-x, y0, level)]
    for turn in range(1, turns):
        here = -x + 2.0 * x * (turn / turns)
        ends = (y0, y1) if turn % 2 else (y1, y0)
        points += [(here, end, level) for end in ends]
    points += [(x, y0 if turns % 2 else y1, level), (x, space.back, level)]
    steel = ag.material("black_steel").with_(name="heating_tube", base_color=(0.06, 0.057, 0.055))
    path = ag.polyline(points, fillet=0.018)
    hangers = ag.line((0.0, 0.0, 0.0), ag.Z * 0.016)
    at = [(share * x, (y0 + y1) / 2.0, level) for share in (-1.0, -0.2, 0.6)]
    return ag.weld(
        ag.detail(details.bent_wires(path, _TUBE, at=((0.0, 0.0, 0.0),)), "element", steel),
        ag.detail(details.bent_wires(hangers, 0.0014, at=at), "element", ag.material("steel")),
    )
