"""How a leaf hangs: its butt hinges on leaf and jamb, and the joint about their pins."""

from collections.abc import Callable
from dataclasses import dataclass

import artgen as ag
from artgen.categories.shared.furniture.door_slab import Blank
from artgen.categories.shared.hardware.hinge import hinge_frame, hinge_leaf, hinge_offset

_TOP = 0.19  # from the top of the leaf to the middle of the upper hinge [m]
_BOTTOM = 0.28  # from the bottom of the leaf to the middle of the lower hinge [m]


@dataclass(frozen=True)
class Hanging:
    """Butt hinges at the left of a leaf, which is centered in x."""

    blank: Blank  # the leaf
    count: int  # 2 or 3 hinges
    gap: ag.Float  # between the leaf and the jamb [m]
    height: ag.Float  # of a hinge [m]
    radius: ag.Float  # of its knuckles [m]
    finish: ag.Material  # its metal
    swing: ag.Float  # how far the leaf opens [rad]
    friction: ag.Float  # of all hinges together [N m]
    damping: ag.Float  # of all hinges together [N m s/rad]

    def _half(self, make: Callable[..., ag.Body]) -> ag.Body:
        low, high = self.blank.bottom + _BOTTOM, self.blank.straight - _TOP
        levels = [low + (high - low) * index / (self.count - 1) for index in range(self.count)]
        half = make(
            height=self.height, radius=self.radius, depth=self._depth, finish=self.finish, levels=levels
        )
        return half.at(
            -(self.blank.width + self.gap) / 2.0, -self.blank.thickness / 2.0 - hinge_offset(self.radius), 0.0
        )

    def on_leaf(self) -> ag.Body:
        """Make the halves to weld to the leaf."""
        return self._half(hinge_leaf)

    def on_frame(self) -> ag.Body:
        """Make the halves to weld to the jamb."""
        return self._half(hinge_frame)

    @property
    def _depth(self) -> ag.Float:
        """How far the plates reach along the edge: they stop 6 mm before its back [m]."""
        return self.blank.thickness - 0.006

    def joint(
        self,
        name: str,
        *,
        middle: ag.Scalar = 0.0,
        side: int = 1,
        needs: ag.Condition | ag.Dependency | None = None,
    ) -> ag.Joint:
        """Make the joint about the pins; positive opens the leaf towards -y."""
        blank = self.blank
        return ag.Revolute(
            name,
            axis=(0.0, 0.0, -side),
            pivot=(
                middle - side * (blank.width + self.gap) / 2.0,
                -blank.thickness / 2.0 - hinge_offset(self.radius),
                0.0,
            ),
            limits=(0.0, self.swing),
            friction=self.friction,
            damping=self.damping,
            effort=100.0,
            velocity=6.0,
            needs=needs,
        )

    def turns_within_gap(self) -> ag.Bool:
        """Tell whether the far corner of the leaf, which swings out of the closed width, clears the jamb."""
        thick = hinge_offset(self.radius) + self.blank.thickness
        return thick * thick / (2.0 * self.blank.width) < self.gap - 0.0004
