"""The catch of touch bins: a button in front lets the lid go, and a spring opens it.

A tongue under the lid reaches down behind the front wall, its foot pointing inward under a bar of the button.
Pressed, the bar moves inward, past the foot.
"""

from dataclasses import dataclass

from artgen import (
    Body,
    Dependency,
    Float,
    Joint,
    Material,
    Revolute,
    Scalar,
    Solid,
    X,
    Y,
    box,
    center_of_mass,
    mass,
    part,
    push_on,
    weld,
)
from artgen.categories.shared.controls.buttons import button_press
from artgen.categories.trashcan.bins import Can
from artgen.categories.trashcan.lids import Hinge

ROOM = 0.027
"""What the catch needs behind the front wall [m]."""

_TONGUE = 0.024  # width of the tongue [m]
_REACH = 0.034  # how far it reaches below the rim [m]
_BEHIND = 0.015  # from the outer face of the wall to the middle of the tongue [m]
_THIN = 0.003
_FOOT = 0.0045  # how far its foot points inward [m]
_PLAY = 0.0005  # between the foot and the bar above it [m]
_CAP = (0.050, 0.013, 0.016)  # of the button [m]
_PROUD = 0.009  # how far the button stands out [m]
_TRAVEL = 0.0062  # of the button [m]
_FREE = 0.0049  # of its travel, from which the foot passes [m]
_FRICTION = 0.02  # of the hinge of a lid [N m]
_GRAVITY = 9.81  # [m/s2]


@dataclass(frozen=True)
class Catch:
    """The catch between a lid and the front of a bin."""

    can: Can  # the bin

    @property
    def _foot(self) -> Scalar:
        """Height of the underside of the foot [m]."""
        return self.can.top - _REACH

    @property
    def _bar(self) -> Scalar:
        """Height of the middle of the bar and of the button [m]."""
        return self._foot + _THIN + _PLAY + 0.002

    def hole(self) -> Solid:
        """Make the tool that cuts the hole of the button into the front wall."""
        wide, _, high = _CAP
        tool = box(wide + 0.001, 0.04, high + 0.001)
        return tool.at(0.0, self.can.front, self._bar)

    def tongue(self, low: Scalar) -> list[Solid]:
        """Make the tongue, to be welded to a lid whose underside is at a height."""
        y = self.can.front + _BEHIND
        blade = box(_TONGUE, _THIN, low + 0.004 - self._foot, bevel=0.0008)
        foot = box(_TONGUE - 0.001, _FOOT + 0.001, _THIN, bevel=0.0006)
        return [
            blade.at(0.0, y, (low + 0.004 + self._foot) / 2.0),
            foot.at(0.0, y + _THIN / 2.0 + (_FOOT - 0.001) / 2.0, self._foot + _THIN / 2.0),
        ]

    def button(self, finish: Material, hidden: Material) -> Body:
        """Make the button with its bar: the link `button`."""
        wide, deep, high = _CAP
        cap = box(wide, deep, high, bevel=0.003).at(0.0, self.can.front - _PROUD + deep / 2.0, self._bar)
        start = self.can.front + 0.001
        far = self.can.front + _BEHIND + _THIN / 2.0 + 0.0008
        arm = box(0.003, far + 0.004 - start, 0.004)
        bar = box(_TONGUE + 0.010, 0.004, 0.004, bevel=0.0006).at(0.0, far + 0.002, self._bar)
        arms = [
            arm.at(side * (_TONGUE / 2.0 + 0.0032), (start + far + 0.004) / 2.0, self._bar)
            for side in (-1, 1)
        ]
        body = part(cap, "button", finish, push=push_on(cap, direction=Y))
        return weld(body, *(part(each, "button", hidden) for each in (bar, *arms)))

    def press(self, name: str = "button_slide") -> Joint:
        """Make the joint of the button."""
        return button_press(
            name, travel=_TRAVEL, preload=0.9, force=6.0, pivot=(0.0, self.can.front, self._bar)
        )

    def frees(self, press: Joint) -> Dependency:
        """Return what the lid needs until its foot has passed the bar."""
        # the foot has to rise by the heights of foot and bar, 3 mm to spare
        passed = (_THIN + 0.004 + 0.004) / (0.85 * self.can.depth)
        return (press > _FREE).until(passed)


def sprung_lid(hinge: Hinge, lid: Body, *, opening: Scalar, needs: Dependency, damping: Scalar) -> Joint:
    """Make the joint of a lid that a spring opens, a third stronger than its weight and its friction."""
    y, z = hinge.axis
    weight: Float = _GRAVITY * mass(lid) * (y - center_of_mass(lid).y)
    start, end = 1.35 * weight + _FRICTION, 0.45 * weight
    stiffness = (start - end) / opening
    return Revolute(
        "lid_hinge",
        axis=-X,
        pivot=(0.0, y, z),
        limits=(0.0, opening),
        stiffness=stiffness,
        rest=start / stiffness,
        friction=_FRICTION,
        damping=damping,
        armature=0.001,
        effort=12.0,
        velocity=8.0,
        needs=needs,
        driven="its spring",
    )
