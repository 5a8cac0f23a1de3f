"""Dimensions of an oven: the planes that door, cavity, racks, panel and drawer share."""

from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen._arrays import cached_property
from artgen.categories.shared.appliances import ApplianceSpace

Build = Literal["built_in", "range"]
"""Built into a kitchen cabinet, or a freestanding range with burners on top."""

SEAL = 0.006
"""Gap between the inside of the door and the cavity, for the gasket [m]."""

LAP = 0.0005
"""Overlap of boards, so that they share no corners [m]."""

UNDER = 0.0003
"""Depth of the boards under a surface with soft edges; the boards have the mass and collide [m]."""

TOP = 0.034
"""Thickness of the top of a range [m]."""

GAP = 0.004
"""Gap between the door and the panel above it, for the outlet of cooling air [m]."""

LEVELS = 5
"""Number of rack levels of the rails."""

ROD = 0.0030
"""Radius of the rods of rails and racks [m]."""

SKIN = 0.014
"""Thickness of the fronts of door and drawer [m]."""

_BELOW = 0.008  # distance from the axis of the door down to its lower edge [m]
_UNDER = 0.0165  # distance from that axis down to the part below the door [m]
_FLOOR = 0.032  # distance from that axis up to the floor of the cavity [m]
_OVER = 0.046  # distance from the ceiling of the cavity to the top of the door [m]
_PLAY = 0.0008  # gap between a rack and its rails [m]
_REACH = 0.010  # distance from the mouth of the cavity to the front of a rack [m]
_LEAST = 0.0012  # least gap between a rack and the door at the angle at which the rack may slide out [m]


@dataclass(frozen=True, kw_only=True)
class Space(ApplianceSpace):
    """Dimensions of an oven."""

    build: Build  # built in or a range
    hinge_height: ag.Float  # height of the axis of the door [m]
    panel: ag.Float  # height of the control panel [m]
    wall: ag.Float  # distance from the outside to the cavity at the sides [m]
    swing: ag.Float  # opening angle of the door [rad]
    slide: ag.Float  # travel of the racks [m]

    @cached_property
    def side(self) -> ag.Scalar:
        """Half the width behind the front: a built-in oven fits into a niche [m]."""
        return self.half - 0.018 if self.build == "built_in" else self.half

    @cached_property
    def mouth(self) -> ag.Scalar:
        """Position of the front of the cavity along y [m]."""
        return self.inner + SEAL

    @cached_property
    def back(self) -> ag.Scalar:
        """Position of the back wall of the cavity along y, with the fan and wool behind it [m]."""
        return self.rear - 0.058

    @cached_property
    def inside(self) -> ag.Float:
        """Half the width of the cavity [m]."""
        return self.half - self.wall

    @cached_property
    def arm(self) -> ag.Float:
        """Distance from the axis of the door back to its inside [m]."""
        return 0.74 * self.thickness

    @cached_property
    def hinge(self) -> tuple[ag.Scalar, ag.Scalar, ag.Scalar]:
        """A point on the axis of the door [m]."""
        return (0.0, self.inner - self.arm, self.hinge_height)

    @cached_property
    def panel_high(self) -> ag.Scalar:
        """Height of the upper edge of the control panel [m]."""
        return self.height - (TOP if self.build == "range" else 0.0)

    @cached_property
    def panel_low(self) -> ag.Scalar:
        """Height of the lower edge of the control panel [m]."""
        return self.panel_high - self.panel

    @cached_property
    def door(self) -> ag.Span:
        """Heights of the lower and the upper edge of the door [m]."""
        return (self.hinge_height - _BELOW, self.panel_low - GAP)

    @cached_property
    def under_door(self) -> ag.Scalar:
        """Height of the upper edge of the part below the door, clear of the turning door [m]."""
        return self.hinge_height - _UNDER

    @cached_property
    def floor(self) -> ag.Scalar:
        """Height of the floor of the cavity [m]."""
        return self.hinge_height + _FLOOR

    @cached_property
    def ceiling(self) -> ag.Scalar:
        """Height of the ceiling of the cavity [m]."""
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
        """Position of the front of the racks along y [m]."""
        return self.mouth + _REACH

    @cached_property
    def rack_depth(self) -> ag.Scalar:
        """Depth of the racks [m]."""
        return self.back - 0.012 - self.rack_front

    @cached_property
    def rack_half(self) -> ag.Scalar:
        """Half the width of a rack, which lies on rails 5 mm off the walls [m]."""
        return self.inside - 0.0065

    @cached_property
    def play(self) -> ag.Scalar:
        """Travel of a rack behind the closed door [m]."""
        return _REACH + SEAL - 0.0012

    def angle_over(self, low: ag.Scalar) -> ag.Scalar:
        """Return the angle of the open door that clears the path of a rack [rad].

        The inside of the door clears the farthest point of the rack if the door leans beyond the direction of
        that point by the angle that its distance from the axis subtends at that point.
        """
        across = self.slide - (self.rack_front - self.hinge[1])
        up = low - self.hinge_height
        far = ag.sqrt(across * across + up * up)
        share = (self.arm + _LEAST) / far
        return ag.atan2(across, up) + ag.atan2(share, ag.sqrt(1.0 - share * share))
