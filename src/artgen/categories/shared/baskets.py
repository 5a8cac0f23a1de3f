"""Baskets of bent wire: racks of dishwashers and freezer baskets, with few convex collision pieces.

A basket is about the origin of x and y, with its lowest wires on z = 0 and its front towards -y. Straight
wires have mass and collide as capsules; the bent wires around them, uprights and tines are visual only.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details, feel
from artgen._arrays import cached_property

Grip = Literal["bar", "plate"]
"""Grip in front of a rack: a round bar or a flat molded plate."""

GRIP_REACH = 0.022
"""Reach of the grip of a basket in front of it [m]."""

_SUNK = 0.0003  # overlap of crossing wires, which are welded [m]
_TREAD = 0.010  # width of a roller [m]
_INSIDE = 0.0003  # difference between the radii of visible wires and the colliding wires inside them [m]
_CORNER = 0.018  # radius of the corners of a rim [m]
_TINE = 0.0017  # radius of a tine [m]
_CROSS = 5  # number of colliding wires across the floor
_WELDED = "wires of a rack are joined by bent ones, which are only seen"


def _spread(count: int, length: ag.Scalar, *, along: ag.Vector = ag.X) -> ag.Points:
    """Return points evenly spaced about the origin over a length [m]."""
    return ag.grid((0.0, 0.0, 0.0), along * (length / max(count - 1, 1)), ag.Z, columns=count, rows=1)


def _straight(
    radius: ag.Scalar, length: ag.Scalar, axis: ag.VectorLike, at: Sequence[ag.VectorLike]
) -> ag.Solid:
    return ag.array(ag.cylinder(radius, length, axis=axis), at=at)


_HERE = ((0.0, 0.0, 0.0),)


@dataclass(frozen=True)
class Basket:
    """An open basket of wires."""

    width: ag.Float  # overall width along x [m]
    depth: ag.Float  # overall depth along y, without grips [m]
    front: ag.Float  # height of the front rim above the lowest wires [m]
    back: ag.Float  # height of the rear rim [m]
    columns: int  # number of wires from front to back, an odd number: every other one collides
    rows: int  # number of wires from side to side
    finish: ag.Material  # coating of the wires
    label: str = "rack"  # semantic label of the wires
    wire: ag.Scalar = 0.0019  # radius of the wires of the grid [m]
    rim: ag.Scalar = 0.0027  # radius of the wire around the top [m]
    bend: ag.Scalar = 0.014  # radius of the bends at which wires turn up the walls [m]
    band: float = 0.5  # height of a second wire around the walls, as a share of the front height; 0 for none

    def wires(self, name: str | None = None) -> ag.Body:
        """Make floor, walls and rims.

        Only the straight wires of the floor, the rim and the band have mass and collide. They are inside the
        visible bent wires.
        """
        return ag.weld(self._solid(name), self._seen())

    @cached_property
    def _half_width(self) -> ag.Float:
        """Distance from the middle to the center lines of the side walls [m]."""
        return self.width / 2.0 - self.rim

    @cached_property
    def _half_depth(self) -> ag.Float:
        """Distance from the middle to the center lines of front and back [m]."""
        return self.depth / 2.0 - self.rim

    @cached_property
    def _down(self) -> tuple[ag.Scalar, ...]:
        """Depth of the wires around the walls below the tops of the walls [m]."""
        lowest = self.front * (1.0 - self.band)
        return (self.rim, lowest) if self.band > 0.0 else (self.rim,)

    def _solid(self, name: str | None) -> ag.Body:
        wire, bend, rim = self.wire - _INSIDE, self.bend, self.rim - _INSIDE
        x, y, middle = self._half_width, self._half_depth, (self.front + self.back) / 2
        floor = _straight(wire, 2 * (y - bend), ag.Y, [(0.0, 0.0, self.wire)])
        across = _straight(wire, 2 * (x - bend), ag.X, [(0.0, 0.0, 3 * self.wire - _SUNK)])
        walls = ((-1, self.front), (1, self.back))
        ends = [(0.0, side * y, tall - down) for side, tall in walls for down in self._down]
        sides = [(side * x, 0.0, middle - down) for side in (-1, 1) for down in self._down]
        slope = ag.vector(0.0, 2 * y, self.back - self.front)
        solids = [
            ag.array(floor, at=_spread((self.columns + 1) // 2, 2 * (x - bend - self.wire))),
            ag.array(across, at=_spread(_CROSS, 2 * (y - bend - self.wire), along=ag.Y)),
            _straight(rim, 2 * (x - _CORNER), ag.X, ends),
            _straight(rim, slope.norm() - 2 * _CORNER, slope, sides),
        ]
        return ag.part(solids, self.label, self.finish, name=name, separate=_WELDED)

    def _seen(self) -> ag.Body:
        """Make the wires from the floor up into the walls, and the wires around them."""
        wire, bend, x, y = self.wire, self.bend, self._half_width, self._half_depth
        low, front, back = 3 * wire - _SUNK, self.front - self.rim, self.back - self.rim
        column = [(0.0, -y, front), (0.0, -y, wire), (0.0, y, wire), (0.0, y, back)]
        # the rods across end at the mean height of the sloping rim; the ends of the rim are slightly off
        level = (front + back) / 2 - 0.5 * wire
        cross = [(-x, 0.0, level), (-x, 0.0, low), (x, 0.0, low), (x, 0.0, level)]
        beside = _spread(self.columns, 2 * (x - bend - wire))
        behind = _spread(self.rows, 2 * (y - bend - wire), along=ag.Y)
        bent = [
            details.bent_wires(ag.polyline(column, fillet=bend), wire, at=beside),
            details.bent_wires(ag.polyline(cross, fillet=bend), wire, at=behind),
        ]
        for number, down in enumerate(self._down):
            high, far = self.front - down, self.back - down
            loop: list[ag.VectorLike] = [
                (0.0, -y, high),
                (x, -y, high),
                (x, y, far),
                (-x, y, far),
                (-x, -y, high),
            ]
            path = ag.polyline(loop, fillet=_CORNER, closed=True)
            bent.append(details.bent_wires(path, wire if number else self.rim, at=_HERE))
        return ag.detail(bent, self.label, self.finish)

    def tines(
        self,
        first: tuple[ag.Scalar, ag.Scalar],
        step: tuple[ag.Scalar, ag.Scalar],
        rows: int,
        *,
        count: int,
        pitch: ag.Scalar,
        height: ag.Scalar,
        lean: ag.Scalar = 0.0,
        across: bool = True,
    ) -> ag.Body:
        """Make rows of tines on the floor; their rails collide, the tines are visual only."""
        along, aside = (ag.X, ag.Y) if across else (ag.Y, ag.X)
        # rails along x lie beside the wires along x, rails along y on top of them
        level = (3.0 if across else 5.0) * self.wire - 2.0 * _SUNK
        start, way = ag.vector(*first, level), ag.vector(*step, 0.0)
        places = ag.row(start, way, rows)
        length = (count - 1) * pitch
        rail = ag.array(ag.cylinder(self.wire, length + 0.008, axis=along), at=places)
        path = ag.line(ag.Z * 0.0, aside * (-height * lean) + ag.Z * height)
        middle = start + way * (0.5 * (rows - 1))
        stand = ag.grid(middle, along * pitch, way, columns=count, rows=rows)
        tines = details.bent_wires(path, _TINE, at=stand)
        return ag.weld(ag.part(rail, self.label, self.finish), ag.detail(tines, self.label, self.finish))

    def grip(
        self,
        *,
        style: Grip = "bar",
        length: ag.Scalar = 0.13,
        material: ag.Material,
        height: ag.Scalar | None = None,
        name: str | None = None,
    ) -> ag.Body:
        """Make a grip in front of the rim, with the grasp frame of a hand from the front."""
        z = self.front - self.rim if height is None else height
        front = -self.depth / 2.0
        out = front - GRIP_REACH + 0.0055
        if style == "bar":
            solid: ag.Solid = ag.capsule(0.0055, length, axis=ag.X).at(0.0, out, z)
        else:
            solid = ag.box(length, 0.011, 0.010, bevel=0.0035).at(0.0, out, z)
        arm = ag.box(0.008, GRIP_REACH - 0.004, 0.007, bevel=0.002).at(0.0, (front + out) / 2.0 + 0.001, z)
        arms = [arm.at(side * (length / 2 - 0.012)) for side in (-1, 1)]
        # tips, which reach 9 mm beyond the frame, end before the wires of the wall
        hold = ag.frame((0.0, front - 0.0175, z), approach=ag.Y, closing=ag.Z)
        thick = 0.011 if style == "bar" else 0.010
        solids = [solid, *arms]
        return ag.part(solids, "grip", material, name=name, grasp=hold, grasp_width=thick + 0.010)


def rollers(
    places: Sequence[tuple[ag.Scalar, ag.Scalar]],
    *,
    x: ag.Scalar,
    radius: ag.Scalar,
    material: ag.Material,
    rise: float = 0.0,
) -> ag.Body:
    """Make rollers on both sides of a basket, each on a bracket that reaches inward to its wires."""
    both = [(side, y, z) for y, z in places for side in (-1, 1)]
    wheel = ag.cylinder(radius, _TREAD, axis=ag.X, bevel=0.0012)
    tall = 2.0 * rise + 0.009
    arm = ag.box(0.026, 0.014, tall, bevel=0.002)
    far = x - 0.5 * _TREAD - 0.012
    wheels = ag.array(wheel, at=[(side * x, y, z) for side, y, z in both])
    arms = ag.array(arm, at=[(side * far, y, z + rise) for side, y, z in both])
    return ag.weld(ag.part(wheels, "roller", material, separate=_WELDED), ag.detail(arms, "roller", material))


def rack_slide(
    name: str,
    *,
    travel: ag.Scalar,
    friction: ag.Scalar,
    damping: ag.Scalar,
    needs: ag.Condition | ag.Dependency,
) -> ag.Joint:
    """Make the slide of a rack; its effort is the force of a hand, too small to move the door."""
    drag = feel.Feel(friction=friction, damping=damping, effort=14.0, velocity=1.5)
    return ag.Prismatic(name, axis=-ag.Y, limits=(0.0, travel), feel=drag, needs=needs)
