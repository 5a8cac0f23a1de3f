"""The common part of door leaves: measures, wood, arch and fittings."""

import math
from dataclasses import dataclass

import artgen as ag

_STEPS = 24
"""Sides of an arch: 0.3 mm between chord and arc at a radius of 0.9 m."""


@dataclass(frozen=True)
class Arch:
    """An arch over the middle of the asset."""

    half: ag.Float  # half of its span [m]
    radius: ag.Float  # radius of its circle [m]
    center: ag.Float  # height of the circle's center [m]

    @staticmethod
    def over(span: ag.Float, *, spring: ag.Scalar, rise: ag.Float) -> "Arch":
        """Make the arch over a span that starts at the height `spring` and rises by `rise` [m]."""
        half = span / 2.0
        radius = (half * half + rise * rise) / (2.0 * rise)
        return Arch(half, radius, spring + rise - radius)

    def outset(self, distance: ag.Scalar) -> "Arch":
        """Return the concentric arch over a span that is wider by `distance` on either side [m]."""
        return Arch(self.half + distance, self.radius + distance, self.center)

    @property
    def angle(self) -> ag.Float:
        """Half of the angle that the arch spans [rad]."""
        return ag.atan2(self.half, ag.sqrt(self.radius * self.radius - self.half * self.half))

    @property
    def spring(self) -> ag.Float:
        """The height at which it starts [m]."""
        return self.center + ag.sqrt(self.radius * self.radius - self.half * self.half)

    @property
    def crown(self) -> ag.Float:
        """The height of its top [m]."""
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
"""Edges of boards are sanded to this radius [m]: joints show as a fine line."""

_FROM_EDGE = 0.094  # from the lock edge to where hands push: beside a pull, still on a stile [m]


@dataclass(frozen=True)
class Fittings:
    """What a leaf carries besides its lock."""

    finish: ag.Material  # their metal
    letters: bool = False  # whether it has a letter plate
    number: str = ""  # the number of the house; empty for none
    viewer: bool = False  # whether one can look out
    kick: bool = False  # whether a plate protects its foot
    sweep: bool = False  # whether a brush seals the gap to the floor

    def bare(self) -> "Fittings":
        """Return the fittings of a leaf that is no entrance."""
        return Fittings(self.finish, kick=self.kick, sweep=self.sweep)


@dataclass(frozen=True)
class Blank:
    """What every leaf has in common."""

    width: ag.Float  # [m]
    bottom: ag.Float  # height of its bottom above the floor [m]
    top: ag.Float  # height of its top above the floor, of the crown of an arch [m]
    thickness: ag.Float  # [m]
    rise: ag.Float | None  # rise of an arched top over its ends [m]; None for a straight one
    cut: ag.Solid | None  # cutter of the hardware in the lock stile; None for none
    finish: ag.Material  # material of the leaf
    fittings: Fittings  # fittings of an entrance besides its lock
    reach: ag.Float  # height above the floor at which hands push it [m]

    @property
    def straight(self) -> ag.Scalar:
        """The height above the floor to which its edges are straight [m]."""
        return self.top if self.rise is None else self.top - self.rise

    @property
    def arch(self) -> Arch | None:
        """The arch of its top, if any."""
        return None if self.rise is None else Arch.over(self.width, spring=self.straight, rise=self.rise)

    @property
    def upright(self) -> ag.Scalar:
        """The length of its edges [m]."""
        return self.straight - self.bottom

    @property
    def waist(self) -> ag.Scalar:
        """The height of the middle of its edges above the floor [m]."""
        return (self.straight + self.bottom) / 2.0

    @property
    def push(self) -> ag.Frame:
        """Where a hand pushes it open: on its back, which faces +y, near the lock edge."""
        at = (self.width / 2.0 - _FROM_EDGE, self.thickness / 2.0, self.reach)
        return ag.frame(at, approach=(0.0, -1.0, 0.0), closing=(1.0, 0.0, 0.0))

    def carved(self, solid: ag.Solid) -> ag.Solid:
        """Return a solid without the cutouts of the hardware."""
        return solid if self.cut is None else solid - self.cut

    def board(self, x: ag.Scalar, z: ag.Scalar, bevel: ag.Scalar = EASED) -> ag.Solid:
        """Make a board as thick as the leaf about the origin."""
        return ag.box(x, self.thickness, z, bevel=bevel)
