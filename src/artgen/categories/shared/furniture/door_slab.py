"""The common part of door leaves: dimensions, wood, arch and fittings."""

import math
from dataclasses import dataclass

import artgen as ag

_STEPS = 24
"""Number of sides of an arch: 0.3 mm between chord and arc at a radius of 0.9 m."""


@dataclass(frozen=True)
class Arch:
    """An arch over the middle of the asset."""

    half: ag.Float  # half of the span [m]
    radius: ag.Float  # radius of the circle [m]
    center: ag.Float  # height of the center of the circle [m]

    @staticmethod
    def over(span: ag.Float, *, spring: ag.Scalar, rise: ag.Float) -> "Arch":
        """Return the arch over a span, from the height `spring` up by `rise` [m]."""
        half = span / 2.0
        radius = (half * half + rise * rise) / (2.0 * rise)
        return Arch(half, radius, spring + rise - radius)

    def outset(self, distance: ag.Scalar) -> "Arch":
        """Return the concentric arch over a span that is wider by `distance` on each side [m]."""
        return Arch(self.half + distance, self.radius + distance, self.center)

    @property
    def angle(self) -> ag.Float:
        """Half of the angle of the arch [rad]."""
        return ag.atan2(self.half, ag.sqrt(self.radius * self.radius - self.half * self.half))

    @property
    def spring(self) -> ag.Float:
        """Height of the ends of the arch [m]."""
        return self.center + ag.sqrt(self.radius * self.radius - self.half * self.half)

    @property
    def crown(self) -> ag.Float:
        """Height of the top of the arch [m]."""
        return self.center + self.radius

    def segment(self) -> ag.Profile:
        """Make the region between the arch and its chord, x to the right and y up [m]."""
        points = []
        for step in range(_STEPS + 1):
            angle = self.angle * (1.0 - 2.0 * step / _STEPS)
            points.append((self.radius * ag.sin(angle), self.center + self.radius * ag.cos(angle)))
        return ag.polygon(points)

    def bands(self, width: ag.Scalar, *, count: int = 1, beyond: ag.Scalar = 0.0) -> list[ag.Profile]:
        """Make the band of a width outside the arch, in equal lengths from right to left."""
        whole = 2.0 * (self.angle + beyond / self.radius)
        middle, sweep = self.radius + width / 2.0, whole / count
        starts = [(math.pi - whole) / 2.0 + index * sweep for index in range(count)]
        return [ag.bow(middle, width, start=start, sweep=sweep).at(0.0, self.center) for start in starts]


EASED = 0.0008
"""Radius of the sanded edges of boards [m]: joints show as a fine line."""

_FROM_EDGE = 0.094  # distance from the lock edge to the push point: beside a pull, still on a stile [m]


@dataclass(frozen=True)
class Fittings:
    """Fittings of a leaf besides its lock."""

    finish: ag.Material  # metal of the fittings
    letters: bool = False  # whether there is a letter plate
    number: str = ""  # house number; empty for none
    viewer: bool = False  # whether there is a door viewer
    kick: bool = False  # whether a kick plate protects the foot
    sweep: bool = False  # whether a brush seals the gap to the floor

    def bare(self) -> "Fittings":
        """Return the fittings of an interior leaf: none."""
        return Fittings(self.finish, kick=self.kick, sweep=self.sweep)


@dataclass(frozen=True)
class Blank:
    """Common data of door leaves."""

    width: ag.Float  # width of the leaf [m]
    bottom: ag.Float  # height of the bottom above the floor [m]
    top: ag.Float  # height of the top (of the crown of an arch) above the floor [m]
    thickness: ag.Float  # thickness of the leaf [m]
    rise: ag.Float | None  # rise of an arched top over its ends; None for a straight top [m]
    cut: ag.Solid | None  # cutter of the hardware in the lock stile; None for none
    finish: ag.Material  # material of the leaf
    fittings: Fittings  # fittings of an entrance besides its lock
    reach: ag.Float  # height above the floor at which hands push the leaf [m]

    @property
    def straight(self) -> ag.Scalar:
        """Height above the floor up to which the edges are straight [m]."""
        return self.top if self.rise is None else self.top - self.rise

    @property
    def arch(self) -> Arch | None:
        """Arch of the top, or None."""
        return None if self.rise is None else Arch.over(self.width, spring=self.straight, rise=self.rise)

    @property
    def upright(self) -> ag.Scalar:
        """Length of the side edges [m]."""
        return self.straight - self.bottom

    @property
    def waist(self) -> ag.Scalar:
        """Height of the middle of the side edges above the floor [m]."""
        return (self.straight + self.bottom) / 2.0

    @property
    def push(self) -> ag.Frame:
        """Return the push frame of a hand: on the back, which faces +y, near the lock edge."""
        at = (self.width / 2.0 - _FROM_EDGE, self.thickness / 2.0, self.reach)
        return ag.frame(at, approach=(0.0, -1.0, 0.0), closing=(1.0, 0.0, 0.0))

    def carved(self, solid: ag.Solid) -> ag.Solid:
        """Return a solid without the cutouts of the hardware."""
        return solid if self.cut is None else solid - self.cut

    def board(self, x: ag.Scalar, z: ag.Scalar, bevel: ag.Scalar = EASED) -> ag.Solid:
        """Make a board about the origin with the thickness of the leaf."""
        return ag.box(x, self.thickness, z, bevel=bevel)
