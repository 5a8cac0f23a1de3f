"""Segmental arches: a circle's segment over a chord, shared by leaves and frames."""

import math
from dataclasses import dataclass

from artgen import Float, Profile, Scalar, atan2, bow, cos, polygon, sin, sqrt

_STEPS = 24
"""Sides of an arch: 0.3 mm between chord and arc at a radius of 0.9 m."""


@dataclass(frozen=True)
class Arch:
    """An arch over the middle of the asset."""

    half: Float  # half of its span [m]
    radius: Float  # radius of its circle [m]
    center: Float  # height of the circle's centre [m]

    @staticmethod
    def over(span: Float, *, spring: Scalar, rise: Float) -> "Arch":
        """Make the arch over a span that starts at the height `spring` and rises by `rise` [m]."""
        half = span / 2.0
        radius = (half * half + rise * rise) / (2.0 * rise)
        return Arch(half, radius, spring + rise - radius)

    def outset(self, distance: Scalar) -> "Arch":
        """Return the concentric arch over a span that is wider by `distance` on either side [m]."""
        return Arch(self.half + distance, self.radius + distance, self.center)

    @property
    def angle(self) -> Float:
        """Half of the angle that the arch spans [rad]."""
        return atan2(self.half, sqrt(self.radius * self.radius - self.half * self.half))

    @property
    def spring(self) -> Float:
        """The height at which it starts [m]."""
        return self.center + sqrt(self.radius * self.radius - self.half * self.half)

    @property
    def crown(self) -> Float:
        """The height of its top [m]."""
        return self.center + self.radius

    def segment(self) -> Profile:
        """Make the region between the arch and its chord, x to the right and y up [m]."""
        points = []
        for step in range(_STEPS + 1):
            angle = self.angle * (1.0 - 2.0 * step / _STEPS)
            points.append((self.radius * sin(angle), self.center + self.radius * cos(angle)))
        return polygon(points)

    def bands(self, width: Scalar, *, count: int = 1, beyond: Scalar = 0.0) -> list[Profile]:
        """Make the band of a width outside the arch, in equal lengths from right to left."""
        whole = 2.0 * (self.angle + beyond / self.radius)
        middle, sweep = self.radius + width / 2.0, whole / count
        starts = [(math.pi - whole) / 2.0 + index * sweep for index in range(count)]
        return [bow(middle, width, start=start, sweep=sweep).at(0.0, self.center) for start in starts]
