"""Butterfly lids: two flaps in a frame over the rim, which hinge at its sides and open upward.

A rod at the back lifts both cranks at once where there is a pedal. Each flap turns about its rounded outer
edge, so that the gap to the frame stays what it is.
"""

from dataclasses import dataclass

from artgen import (
    Body,
    Float,
    Frame,
    Joint,
    Material,
    Revolute,
    Scalar,
    Solid,
    Y,
    Z,
    atan2,
    box,
    coarse,
    cylinder,
    cylinder_between,
    detail,
    extrude,
    grasp_on,
    material,
    min_,
    part,
    rectangle,
    weld,
)
from artgen.categories.trashcan.bins import Can
from artgen.categories.trashcan.pedals import PIN, Linkage

_THICK = 0.009  # of flaps [m]
_EDGE = 0.0055  # radius of their outer edge, about the axis [m]
_GAP = 0.0028  # around the flaps [m]
_TALL = 0.011  # of the frame [m]
_BORDER = 0.017  # from the outside of the frame to its opening, at the sides and in front [m]
_SHAFT = 0.0038  # radius of the shafts that reach to the cranks [m]
_DEEP = 0.026  # of the housing behind the rim [m]
_FOOT = 0.006  # where the housing ends above the floor [m]
_TAB = 0.014  # how far a tab stands up from a flap [m]


@dataclass(frozen=True)
class Flaps:
    """Two flaps and their frame on a bin with straight sides."""

    can: Can  # the bin
    opening: Scalar  # how far they open [rad]

    @property
    def top(self) -> Scalar:
        """Height of the frame's upper face [m]."""
        return self.can.top + _TALL - 0.001

    @property
    def level(self) -> Scalar:
        """Height of both axes [m]."""
        return self.top - _EDGE

    @property
    def half(self) -> Scalar:
        """From the middle to the opening's side [m]."""
        return self.can.width / 2.0 - _BORDER

    @property
    def axis(self) -> Scalar:
        """From the middle to either axis [m]."""
        return self.half - _EDGE - _GAP

    @property
    def reach(self) -> Scalar:
        """From an axis to the tip of its flap [m]."""
        return self.axis - _GAP / 2.0

    @property
    def back(self) -> Scalar:
        """Where the opening ends behind [m]."""
        return self.can.depth / 2.0 - _BORDER

    @property
    def crank_y(self) -> Scalar:
        """Where the cranks and the rod are, along y [m]."""
        return self.can.depth / 2.0 + 0.5 * _DEEP

    def frame(self, finish: Material, linkage: Linkage | None) -> Body:
        """Make the frame, to be welded to the bin, and the housing behind it where there is a rod."""
        can, side = self.can, rectangle(2.0 * self.half, 2.0 * self.back, radius=0.004)
        ring = can.outline(-0.001) - side
        middle = (self.top + can.top - 0.001) / 2.0
        if linkage is not None:
            slot = rectangle(2.0 * _SHAFT + 0.003, 0.1)
            for way in (-1, 1):
                ring = ring - slot.at(way * self.axis, self.back + 0.05 - 0.001)
        solid = coarse(extrude(ring, self.top - can.top + 0.001))
        bodies = [part(solid.at(0.0, 0.0, middle), "rim", finish)]
        return weld(*bodies, *(self._housing(finish, linkage) if linkage is not None else ()))

    def _housing(self, finish: Material, linkage: Linkage) -> list[Body]:
        """Make the box behind the rim in which the cranks turn, open below for the rod."""
        near, far = self.can.back - 0.003, self.can.back + _DEEP
        half, low = self.axis + 0.014, self.level - 0.034
        high = self.level + linkage.lift / 2.0 + PIN + 0.005
        middle, tall = (near + far) / 2.0, high - low
        deep, spine = far - near, low + 0.004
        up, post = (spine + _FOOT) / 2.0, spine - _FOOT
        strip = box(0.024, near + 0.002 - self.back - 0.001, 0.003, bevel=0.0008)
        # boards are a little smaller where they meet, so that no two faces lie on each other
        boards = [
            box(2.0 * half, deep, 0.003, bevel=0.001).at(0.0, middle, high - 0.0015),
            box(2.0 * half - 0.002, 0.003, high - self.top, bevel=0.001).at(
                0.0, near + 0.0021, (high + self.top) / 2.0 - 0.0006
            ),
            box(2.0 * half - 0.0014, 0.003, tall - 0.0007, bevel=0.001).at(
                0.0, far - 0.0021, low + tall / 2.0
            ),
            box(0.0424, 0.003, post - 0.001, bevel=0.001).at(0.0, far - 0.0026, up),
        ]
        for way in (-1, 1):
            side = box(0.003, deep - 0.0024, tall - 0.0012, bevel=0.001)
            wing = box(0.003, deep - 0.0036, post, bevel=0.001)
            boards.append(side.at(way * (half - 0.0018), middle, low + tall / 2.0))
            boards.append(wing.at(way * 0.0205, middle, up))
            boards.append(strip.at(way * self.axis, (near + 0.003 + self.back) / 2.0, self.top + 0.0012))
        return [part(each, "hinge", finish) for each in boards]

    def flap(self, side: int, *, finish: Material, dark: Material, linkage: Linkage | None) -> Body:
        """Make one flap: the link `lid_left` (side -1) or `lid_right`."""
        long = 2.0 * self.back - 2.0 * _GAP
        slab = box(self.reach, long, _THICK, bevel=0.0022)
        slab = slab.at(side * (self.axis - self.reach / 2.0), 0.0, self.level + _EDGE - _THICK / 2.0)
        edge = cylinder(_EDGE, long - 0.001, axis=Y, bevel=0.001).at(side * self.axis, 0.0, self.level)
        grasps: list[Frame] = []
        solids = [slab, edge]
        if linkage is None:
            wide = min_(0.060, 0.9 * self.back - 2.0 * _GAP - 0.002)  # about -0.55 back, within the frame
            tab = box(0.007, wide, _TAB + 0.004, bevel=0.002)
            tab = tab.at(side * 0.022, -0.55 * self.back, self.top + _TAB / 2.0 - 0.002)
            grasps = [grasp_on(tab, approach=-Z, closing=(1.0, 0.0, 0.0), depth=0.011)]
            solids.append(tab)
        name = "lid_left" if side < 0 else "lid_right"
        bodies = [part(solids[-1], "lid", finish, name=name, grasp=grasps)]
        bodies += [part(each, "lid", finish) for each in solids[:-1]]
        under = box(self.reach - 0.020, long - 0.02, 0.001)
        x = side * (self.axis - 0.5 * self.reach - 0.003)
        bodies.append(detail(under.at(x, 0.0, self.level + _EDGE - _THICK), "lid", dark))
        if linkage is not None:
            bodies += [part(each, "lid", material("steel")) for each in self._crank(side, linkage)]
        return weld(*bodies)

    def _crank(self, side: int, linkage: Linkage) -> list[Solid]:
        """Make the shaft of a flap and the crank at its end, at rest."""
        x, z = side * self.axis, self.level
        shaft = cylinder_between((x, self.back - 0.006, z), (x, self.crank_y + 0.0062, z), _SHAFT)
        plate = box(linkage.crank, 0.0032, 0.006, bevel=0.0008).at(-0.5 * side * linkage.crank, 0.0046, 0.0)
        pin = cylinder(PIN, 0.0124, axis=Y).at(-side * linkage.crank, 0.0, 0.0)
        turned = [each.rotate(Y, -0.5 * side * linkage.opening) for each in (plate, pin)]
        return [shaft, *(each.at(side * self.axis, self.crank_y, self.level) for each in turned)]

    def crossbar(self, linkage: Linkage, finish: Material) -> Body:
        """Make the bar on the rod that lifts both cranks, to be welded to the rod."""
        high = self.level - linkage.lift / 2.0 - PIN - 0.0012
        half = self.axis - 0.6 * linkage.crank
        bar = box(2.0 * half, 0.0055, 0.005, bevel=0.001).at(0.0, self.crank_y - 0.003, high - 0.0025)
        return part(bar, "rod", finish)

    def turn(
        self, side: int, *, linkage: Linkage | None, pedal: Joint | None, friction: Scalar, damping: Scalar
    ) -> Joint:
        """Make the joint of one flap; positive opens it."""
        follows = None
        if linkage is not None and pedal is not None:
            follows = pedal * (linkage.opening / linkage.angle)
        return Revolute(
            f"lid_hinge_{'left' if side < 0 else 'right'}",
            axis=side * Y,
            pivot=(side * self.axis, 0.0, self.level),
            limits=(0.0, self.opening) if follows is None else None,
            follows=follows,
            friction=friction,
            damping=damping,
            armature=0.0003,
            effort=5.0,
            velocity=8.0,
        )

    def clear(self, height: Scalar, beside: Scalar) -> Float:
        """Return the angle at which both flaps leave free what rises between them [rad]."""
        del height  # it rises past the tips of the flaps
        return atan2(self.reach, beside - _THICK)
