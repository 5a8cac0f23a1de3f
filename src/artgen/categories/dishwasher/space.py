"""Space inside a dishwasher: the planes that door, tub and racks share, and derived measures."""

from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen._arrays import cached_property
from artgen.categories.shared.appliances.finish import ApplianceSpace

Build = Literal["built_in", "freestanding"]
"""For a kitchen front, with bare sheet sides, or with painted sides and a worktop."""

Controls = Literal["front", "top"]
"""Whether the console faces the user or lies hidden on the upper edge of the door."""

Size = Literal["full", "slim"]
"""60 or 45 cm wide."""

SEAL = 0.006
"""Between the inside of the door and the tub, where the gasket is [m]."""

DISH = 0.022
"""How deep the middle of the door's liner lies behind its rim, for the grips of racks [m]."""

REACH = 0.005
"""From the rim of the liner to the front of the racks [m]."""

ROLLER = 0.0155
"""Radius of the rollers of the lower rack [m]."""

UNDER = 0.020
"""From the treads of these rollers up to the wires of the lower rack [m]."""

_LEAST = 0.0008  # between the lower rack and the door at the angle at which the rack may move [m]
_FLOOR = 0.047  # from the treads of the lower rack down to the floor of the tub [m]


@dataclass(frozen=True, kw_only=True)
class Space(ApplianceSpace):
    """The measures of a dishwasher."""

    plinth: ag.Float  # height of the hinge above the floor [m]
    wall: ag.Scalar  # thickness of a side wall, panel and tub together [m]
    roof: ag.Scalar  # from the ceiling of the tub to the very top [m]
    swing: ag.Float  # how far the door opens [rad]
    clearance: ag.Float  # of the lower rack over the open door [m]
    travel: ag.Float  # how far racks roll out, as a share of their depth

    @cached_property
    def mouth(self) -> ag.Scalar:
        """The front of the tub, along y [m]."""
        return self.inner + SEAL

    @cached_property
    def back(self) -> ag.Scalar:
        """The inside of the tub's back wall, along y [m]."""
        return self.depth / 2.0 - 0.045

    @cached_property
    def inside(self) -> ag.Float:
        """Half the width of the tub's inside [m]."""
        return self.width / 2.0 - self.wall

    @cached_property
    def ceiling(self) -> ag.Float:
        """The height of the tub's ceiling [m]."""
        return self.height - self.roof

    @cached_property
    def arm(self) -> ag.Float:
        """From the hinge's axis back to the rim of the liner [m]."""
        return 0.6 * self.thickness

    @cached_property
    def hinge(self) -> tuple[ag.Scalar, ag.Scalar, ag.Scalar]:
        """A point on the axis of the door [m]."""
        return (0.0, self.inner - self.arm, self.plinth)

    @cached_property
    def door_bottom(self) -> ag.Float:
        """The lower edge of the door: so little below the hinge that it turns past the tub [m]."""
        return self.plinth - 0.010

    @cached_property
    def rack_depth(self) -> ag.Scalar:
        """Of the racks, without their grips [m]."""
        return self.back - 0.016 - self.rack_front

    @cached_property
    def rack_front(self) -> ag.Scalar:
        """The front of the racks, along y [m]."""
        return self.inner + REACH

    @cached_property
    def rack_middle(self) -> ag.Scalar:
        """The middle of the racks, along y [m]."""
        return self.rack_front + self.rack_depth / 2.0

    @cached_property
    def slide(self) -> ag.Scalar:
        """How far racks roll out [m]."""
        return self.travel * self.rack_depth

    @cached_property
    def over(self) -> ag.Scalar:
        """How far the lower rack reaches out before the hinge [m]."""
        return self.slide - self.arm - REACH

    @cached_property
    def treads(self) -> ag.Scalar:
        """The height on which the lower rack rolls.

        Over the open door, which rises a little to its end where it opens by less than a right angle, the
        rack keeps its clearance where it reaches farthest [m].
        """
        rise = (self.arm + self.clearance + self.over * ag.cos(self.swing)) / ag.sin(self.swing)
        return self.plinth + rise

    @cached_property
    def floor(self) -> ag.Scalar:
        """The height of the tub's floor [m]."""
        return self.treads - _FLOOR

    @cached_property
    def reach_of_arms(self) -> ag.Float:
        """Half the length of the spray arms [m]."""
        return ag.min_(self.inside - 0.040, (self.back - self.mouth) / 2.0 - 0.030)

    def angle_over(self, low: ag.Scalar, ahead: ag.Scalar = 0.0) -> ag.Scalar:
        """Return the angle at which the open door clears the way of a rack [rad].

        The farthest point that the rack comes to lies before the hinge and above it, in the direction
        `steep` seen from it; the liner clears the point where it leans farther out than that by the angle
        under which its distance from the hinge's axis is seen.
        """
        across, up = self.over + ahead, low - self.plinth
        far = ag.sqrt(across * across + up * up)
        share = (self.arm + _LEAST) / far
        return ag.atan2(across, up) + ag.atan2(share, ag.sqrt(1.0 - share * share))
