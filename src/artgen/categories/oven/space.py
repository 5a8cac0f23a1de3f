"""Space inside an oven: the planes that door, cavity, racks, panel and drawer share."""

from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen._arrays import cached_property
from artgen.categories.shared.appliances.finish import ApplianceSpace

Build = Literal["built_in", "range"]
"""For a kitchen cabinet, or standing on its own with burners on it."""

SEAL = 0.006
"""Between the inside of the door and the cavity, where the gasket is [m]."""

LAP = 0.0005
"""By which boards reach into each other, so that they have no corners in common [m]."""

UNDER = 0.0003
"""From a surface with soft edges to the boards under it, which weigh and collide [m]."""

TOP = 0.034
"""Thickness of the top of a range [m]."""

GAP = 0.004
"""Between the door and the panel above it, where cooling air comes out [m]."""

LEVELS = 5
"""How many racks the rails at the sides have room for."""

ROD = 0.0030
"""Radius of the rods of rails and racks [m]."""

SKIN = 0.014
"""Thickness of the fronts of door and drawer [m]."""

_BELOW = 0.008  # from the axis of the door down to its lower edge [m]
_UNDER = 0.0165  # from that axis down to the part below the door [m]
_FLOOR = 0.032  # from that axis up to the floor of the cavity [m]
_OVER = 0.046  # from the ceiling of the cavity to the top of the door [m]
_PLAY = 0.0008  # between a rack and the rails that carry it [m]
_REACH = 0.010  # from the mouth of the cavity to the front of a rack [m]
_LEAST = 0.0012  # between a rack and the door at the angle at which it may come [m]


@dataclass(frozen=True, kw_only=True)
class Space(ApplianceSpace):
    """The measures of an oven."""

    build: Build  # built in or a range
    hinge_height: ag.Float  # of the axis of the door [m]
    panel: ag.Float  # height of the control panel [m]
    wall: ag.Float  # from the outside to the cavity at the sides [m]
    swing: ag.Float  # how far the door opens [rad]
    slide: ag.Float  # how far racks come out [m]

    @cached_property
    def side(self) -> ag.Scalar:
        """Half the width behind the front: a built-in oven goes into a niche [m]."""
        return self.half - 0.018 if self.build == "built_in" else self.half

    @cached_property
    def mouth(self) -> ag.Scalar:
        """The front of the cavity, along y [m]."""
        return self.inner + SEAL

    @cached_property
    def back(self) -> ag.Scalar:
        """The back wall of the cavity, along y: the fan and wool are behind it [m]."""
        return self.rear - 0.058

    @cached_property
    def inside(self) -> ag.Float:
        """Half the width of the cavity [m]."""
        return self.half - self.wall

    @cached_property
    def arm(self) -> ag.Float:
        """From the axis of the door back to its inside [m]."""
        return 0.74 * self.thickness

    @cached_property
    def hinge(self) -> tuple[ag.Scalar, ag.Scalar, ag.Scalar]:
        """A point on the axis of the door [m]."""
        return (0.0, self.inner - self.arm, self.hinge_height)

    @cached_property
    def panel_high(self) -> ag.Scalar:
        """The upper edge of the control panel [m]."""
        return self.height - (TOP if self.build == "range" else 0.0)

    @cached_property
    def panel_low(self) -> ag.Scalar:
        """The lower edge of the control panel [m]."""
        return self.panel_high - self.panel

    @cached_property
    def door(self) -> ag.Span:
        """The lower and the upper edge of the door [m]."""
        return (self.hinge_height - _BELOW, self.panel_low - GAP)

    @cached_property
    def under_door(self) -> ag.Scalar:
        """The upper edge of the part below the door, which the edge of the door clears [m]."""
        return self.hinge_height - _UNDER

    @cached_property
    def floor(self) -> ag.Scalar:
        """The floor of the cavity [m]."""
        return self.hinge_height + _FLOOR

    @cached_property
    def ceiling(self) -> ag.Scalar:
        """The ceiling of the cavity [m]."""
        return self.door[1] - _OVER

    def level(self, number: int) -> ag.Scalar:
        """Return the height of the middle of the rails at a level, counted from below [m]."""
        share = (number + 0.75) / (LEVELS + 0.6)
        return self.floor + share * (self.ceiling - self.floor)

    def rack(self, number: int) -> ag.Scalar:
        """Return the height of the middle of the rods of a rack at a level [m]."""
        return self.level(number) + 2.0 * ROD + _PLAY

    @cached_property
    def rack_front(self) -> ag.Scalar:
        """The front of the racks, along y [m]."""
        return self.mouth + _REACH

    @cached_property
    def rack_depth(self) -> ag.Scalar:
        """Of the racks [m]."""
        return self.back - 0.012 - self.rack_front

    @cached_property
    def rack_half(self) -> ag.Scalar:
        """Half the width of a rack, which lies on rails that stand 5 mm off the walls [m]."""
        return self.inside - 0.0065

    @cached_property
    def play(self) -> ag.Scalar:
        """How far a rack comes behind the closed door [m]."""
        return _REACH + SEAL - 0.0012

    def angle_over(self, low: ag.Scalar) -> ag.Scalar:
        """Return the angle at which the open door clears the way of a rack [rad].

        Its inside clears the farthest point that the rack comes to where it leans farther out than the
        direction of that point, by the angle under which its distance from the axis is seen.
        """
        across = self.slide - (self.rack_front - self.hinge[1])
        up = low - self.hinge_height
        far = ag.sqrt(across * across + up * up)
        share = (self.arm + _LEAST) / far
        return ag.atan2(across, up) + ag.atan2(share, ag.sqrt(1.0 - share * share))
