"""Dimensions of a microwave oven: the planes that door, panel, cavity and turntable share."""

from dataclasses import dataclass

import artgen as ag
from artgen._arrays import cached_property
from artgen.categories.shared.appliances import ApplianceSpace

SEAL = 0.0028
"""Gap between the inside of the door and the cavity's frame; chokes need 2-3 mm [m]."""

GAP = 0.0024
"""Gap between door and control panel [m]."""

EDGE = 0.0012
"""Distance from the outer edges of door and panel to the sides of the case [m]."""

SHEET = 0.0025
"""Modeled thickness of the sheet of the case [m]."""

FRAME = 0.0030
"""Thickness of the frame of the cavity in front of the latches [m]."""

SHAFT = 0.046
"""Depth of the space for the latches behind that frame [m]."""

STILE = 0.036
"""Distance from the cavity to the control panel: the frame with the slots of the latches [m]."""

HOOK = 0.0160
"""Distance from the cavity to the middle of the latches [m]."""

_SIDE = 0.020  # thickness of the left wall, case and cavity together [m]
_UNDER = 0.030  # distance from the underside of the case to the floor of the cavity, above the motor [m]
_OVER = 0.021  # distance from the ceiling of the cavity to the top [m]
_BEHIND = 0.020  # distance from the back of the cavity to that of the case [m]
_PIVOT = (0.0062, 0.0170)  # distances of the hinge from the left edge and from the inside of the door [m]


@dataclass(frozen=True, kw_only=True)
class Space(ApplianceSpace):
    """Dimensions of a microwave oven."""

    panel: ag.Float  # width of the control panel [m]
    foot: ag.Float  # height of the feet [m]

    @cached_property
    def mouth(self) -> ag.Scalar:
        """Position of the front of the cavity's frame along y [m]."""
        return self.inner + SEAL

    @cached_property
    def back(self) -> ag.Scalar:
        """Position of the back wall of the cavity along y [m]."""
        return self.rear - _BEHIND

    @cached_property
    def split(self) -> ag.Scalar:
        """Position of the left edge of the control panel along x [m]."""
        return self.half - self.panel

    @cached_property
    def door(self) -> ag.Span:
        """Positions of the edges of the door along x [m]."""
        return (EDGE - self.half, self.split - GAP)

    @cached_property
    def across(self) -> ag.Span:
        """Positions of the side walls of the cavity along x [m]."""
        return (_SIDE - self.half, self.split - STILE)

    @cached_property
    def tall(self) -> ag.Span:
        """Positions of the edges of door and panel along z [m]."""
        return (self.foot + EDGE, self.height - EDGE)

    @cached_property
    def floor(self) -> ag.Scalar:
        """Position of the floor of the cavity along z [m]."""
        return self.foot + _UNDER

    @cached_property
    def ceiling(self) -> ag.Scalar:
        """Position of the ceiling of the cavity along z [m]."""
        return self.height - _OVER

    @cached_property
    def middle(self) -> tuple[ag.Scalar, ag.Scalar]:
        """Position of the middle of the cavity, x and y [m]."""
        left, right = self.across
        return ((left + right) / 2.0, (self.mouth + self.back) / 2.0)

    @cached_property
    def reach(self) -> ag.Float:
        """Radius of the largest plate that turns in the cavity, with 7 mm to spare [m]."""
        left, right = self.across
        return ag.min_(right - left, self.back - self.mouth) / 2.0 - 0.007

    @cached_property
    def hook(self) -> ag.Scalar:
        """Position of the middle of the latches along x [m]."""
        return self.across[1] + HOOK

    @cached_property
    def hinge(self) -> tuple[ag.Scalar, ag.Scalar, ag.Scalar]:
        """Return a point on the axis of the door.

        The axis is near the edge, so that the rear corner of the door clears the frame by 1 mm [m].
        """
        aside, ahead = _PIVOT
        return (self.door[0] + aside, self.inner - ahead, self.height / 2.0)

    @cached_property
    def arm(self) -> ag.Scalar:
        """Distance from the hinge to the latches [m]."""
        return self.hook - self.hinge[0]
