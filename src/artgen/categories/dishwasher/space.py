"""Dimensions of a dishwasher: the planes that door, tub and racks share, and derived lengths."""

from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen._arrays import cached_property
from artgen.categories.shared.appliances import ApplianceSpace

Build = Literal["built_in", "freestanding"]
"""Built-in with bare sheet sides, or freestanding with painted sides and a worktop."""

Controls = Literal["front", "top"]
"""Position of the console: in the front, or hidden on the upper edge of the door."""

Size = Literal["full", "slim"]
"""Width of the machine: 60 or 45 cm."""

SEAL = 0.006
"""Gap between the inside of the door and the tub, for the gasket [m]."""

DISH = 0.022
"""Depth of the middle of the door's liner behind its rim, for the grips of racks [m]."""

REACH = 0.005
"""Gap from the rim of the liner to the front of the racks [m]."""

ROLLER = 0.0155
"""Radius of the rollers of the lower rack [m]."""

UNDER = 0.020
"""Distance from the treads of these rollers up to the wires of the lower rack [m]."""

_LEAST = 0.0008  # least gap between the lower rack and the door at the angle at which the rack may move [m]
_FLOOR = 0.047  # distance from the treads of the lower rack down to the floor of the tub [m]


@dataclass(frozen=True, kw_only=True)
class Space(ApplianceSpace):
    """Dimensions of a dishwasher."""

    plinth: ag.Float  # height of the hinge above the floor [m]
    wall: ag.Scalar  # thickness of a side wall, panel and tub together [m]
    roof: ag.Scalar  # distance from the ceiling of the tub to the top [m]
    swing: ag.Float  # opening angle of the door [rad]
    clearance: ag.Float  # gap between the lower rack and the open door [m]
    travel: ag.Float  # travel of the racks, as a share of their depth

    @cached_property
    def mouth(self) -> ag.Scalar:
        """Position of the front of the tub along y [m]."""
        return self.inner + SEAL

    @cached_property
    def back(self) -> ag.Scalar:
        """Position of the inside of the tub's back wall along y [m]."""
        return self.depth / 2.0 - 0.045

    @cached_property
    def inside(self) -> ag.Float:
        """Half the width of the tub's inside [m]."""
        return self.width / 2.0 - self.wall

    @cached_property
    def ceiling(self) -> ag.Float:
        """Height of the tub's ceiling [m]."""
        return self.height - self.roof

    @cached_property
    def arm(self) -> ag.Float:
        """Distance from the hinge's axis back to the rim of the liner [m]."""
        return 0.6 * self.thickness

    @cached_property
    def hinge(self) -> tuple[ag.Scalar, ag.Scalar, ag.Scalar]:
        """A point on the axis of the door [m]."""
        return (0.0, self.inner - self.arm, self.plinth)

    @cached_property
    def door_bottom(self) -> ag.Float:
        """Lower edge of the door: just below the hinge, so that it turns past the tub [m]."""
        return self.plinth - 0.010

    @cached_property
    def rack_depth(self) -> ag.Scalar:
        """Depth of the racks, without their grips [m]."""
        return self.back - 0.016 - self.rack_front

    @cached_property
    def rack_front(self) -> ag.Scalar:
        """Position of the front of the racks along y [m]."""
        return self.inner + REACH

    @cached_property
    def rack_middle(self) -> ag.Scalar:
        """Position of the middle of the racks along y [m]."""
        return self.rack_front + self.rack_depth / 2.0

    @cached_property
    def slide(self) -> ag.Scalar:
        """Travel of the racks [m]."""
        return self.travel * self.rack_depth

    @cached_property
    def over(self) -> ag.Scalar:
        """Reach of the extended lower rack in front of the hinge [m]."""
        return self.slide - self.arm - REACH

    @cached_property
    def treads(self) -> ag.Scalar:
        """Height at which the lower rack rolls.

        A door that opens by less than a right angle rises a little to its end; the rack keeps its clearance
        above the door at its farthest reach [m].
        """
        rise = (self.arm + self.clearance + self.over * ag.cos(self.swing)) / ag.sin(self.swing)
        return self.plinth + rise

    @cached_property
    def floor(self) -> ag.Scalar:
        """Height of the tub's floor [m]."""
        return self.treads - _FLOOR

    @cached_property
    def reach_of_arms(self) -> ag.Float:
        """Half the length of the spray arms [m]."""
        return ag.min_(self.inside - 0.040, (self.back - self.mouth) / 2.0 - 0.030)

    def angle_over(self, low: ag.Scalar, ahead: ag.Scalar = 0.0) -> ag.Scalar:
        """Return the angle of the open door that clears the path of a rack [rad].

        The farthest point that the rack reaches is in front of the hinge and above it, in the direction
        `steep` as seen from the hinge; the liner clears this point if it leans beyond it by the angle that
        its distance from the hinge's axis subtends at that point.
        """
        across, up = self.over + ahead, low - self.plinth
        far = ag.sqrt(across * across + up * up)
        share = (self.arm + _LEAST) / far
        return ag.atan2(across, up) + ag.atan2(share, ag.sqrt(1.0 - share * share))
