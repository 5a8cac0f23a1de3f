"""Hoods over the rim of a bin, with a lid, and butterfly flaps.

A swing lid tips about its middle and springs back; a disc turns in its rim; a ball (a half ball, closed
below) rolls under its collar. All three turn about an axis along x over the middle of the bin.
"""

from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen.categories.trashcan.bins import Can
from artgen.categories.trashcan.pedals import PIN, Linkage

_THICK = 0.009  # thickness of flaps [m]
_FLAP_EDGE = 0.0055  # radius of the outer edge of flaps, about the axis [m]
_GAP = 0.0028  # gap around the flaps [m]
_TALL = 0.011  # height of the frame [m]
_BORDER = 0.017  # distance from the outside of the frame to its opening, at the sides and in front [m]
_SHAFT = 0.0038  # radius of the shafts of the cranks [m]
_DEEP = 0.026  # depth of the housing behind the rim [m]
_FOOT = 0.006  # height of the lower end of the housing above the floor [m]
_TAB = 0.014  # height of a tab above its flap [m]


@dataclass(frozen=True)
class Flaps:
    """Two flaps and their frame on a bin with straight sides."""

    can: Can  # bin
    opening: ag.Scalar  # opening angle of the flaps [rad]

    @property
    def top(self) -> ag.Scalar:
        """Height of the frame's upper face [m]."""
        return self.can.top + _TALL - 0.001

    @property
    def level(self) -> ag.Scalar:
        """Height of both axes [m]."""
        return self.top - _FLAP_EDGE

    @property
    def half(self) -> ag.Scalar:
        """Distance from the middle to the side of the opening [m]."""
        return self.can.width / 2.0 - _BORDER

    @property
    def axis(self) -> ag.Scalar:
        """Distance from the middle to each axis [m]."""
        return self.half - _FLAP_EDGE - _GAP

    @property
    def reach(self) -> ag.Scalar:
        """Distance from an axis to the tip of its flap [m]."""
        return self.axis - _GAP / 2.0

    @property
    def back(self) -> ag.Scalar:
        """Position of the rear end of the opening along y [m]."""
        return self.can.depth / 2.0 - _BORDER

    @property
    def crank_y(self) -> ag.Scalar:
        """Position of the cranks and the rod along y [m]."""
        return self.can.depth / 2.0 + 0.5 * _DEEP

    def frame(self, finish: ag.Material, linkage: Linkage | None) -> ag.Body:
        """Make the frame, which is welded to the bin, and the housing behind it for a rod."""
        can, side = self.can, ag.rectangle(2.0 * self.half, 2.0 * self.back, radius=0.004)
        ring = can.outline(-0.001) - side
        middle = (self.top + can.top - 0.001) / 2.0
        if linkage is not None:
            slot = ag.rectangle(2.0 * _SHAFT + 0.003, 0.1)
            for way in (-1, 1):
                ring = ring - slot.at(way * self.axis, self.back + 0.05 - 0.001)
        solid = ag.simplified_collider(ag.extrude(ring, self.top - can.top + 0.001))
        bodies = [ag.part(solid.at(0.0, 0.0, middle), "rim", finish)]
        return ag.weld(*bodies, *(self._housing(finish, linkage) if linkage is not None else ()))

    def _housing(self, finish: ag.Material, linkage: Linkage) -> list[ag.Body]:
        """Make the box behind the rim around the cranks, open below for the rod."""
        near, far = self.can.back - 0.003, self.can.back + _DEEP
        half, low = self.axis + 0.014, self.level - 0.034
        high = self.level + linkage.lift / 2.0 + PIN + 0.005
        middle, tall = (near + far) / 2.0, high - low
        deep, spine = far - near, low + 0.004
        up, post = (spine + _FOOT) / 2.0, spine - _FOOT
        strip = ag.box(0.024, near + 0.002 - self.back - 0.001, 0.003, bevel=0.0008)
        # boards are a little smaller at their joints, so that no two faces are coplanar
        boards = [
            ag.box(2.0 * half, deep, 0.003, bevel=0.001).at(0.0, middle, high - 0.0015),
            ag.box(2.0 * half - 0.002, 0.003, high - self.top, bevel=0.001).at(
                0.0, near + 0.0021, (high + self.top) / 2.0 - 0.0006
            ),
            ag.box(2.0 * half - 0.0014, 0.003, tall - 0.0007, bevel=0.001).at(
                0.0, far - 0.0021, low + tall / 2.0
            ),
            ag.box(0.0424, 0.003, post - 0.001, bevel=0.001).at(0.0, far - 0.0026, up),
        ]
        for way in (-1, 1):
            side = ag.box(0.003, deep - 0.0024, tall - 0.0012, bevel=0.001)
            wing = ag.box(0.003, deep - 0.0036, post, bevel=0.001)
            boards.append(side.at(way * (half - 0.0018), middle, low + tall / 2.0))
            boards.append(wing.at(way * 0.0205, middle, up))
            boards.append(strip.at(way * self.axis, (near + 0.003 + self.back) / 2.0, self.top + 0.0012))
        return [ag.part(each, "hinge", finish) for each in boards]

    def flap(self, side: int, *, finish: ag.Material, dark: ag.Material, linkage: Linkage | None) -> ag.Body:
        """Make one flap: the link `lid_left` (side -1) or `lid_right`."""
        long = 2.0 * self.back - 2.0 * _GAP
        slab = ag.box(self.reach, long, _THICK, bevel=0.0022)
        slab = slab.at(side * (self.axis - self.reach / 2.0), 0.0, self.level + _FLAP_EDGE - _THICK / 2.0)
        edge = ag.cylinder(_FLAP_EDGE, long - 0.001, axis=ag.Y, bevel=0.001).at(
            side * self.axis, 0.0, self.level
        )
        grasps: list[ag.Frame] = []
        solids = [slab, edge]
        if linkage is None:
            # about 0.55 of the way back, within the frame
            wide = ag.min_(0.060, 0.9 * self.back - 2.0 * _GAP - 0.002)
            tab = ag.box(0.007, wide, _TAB + 0.004, bevel=0.002)
            tab = tab.at(side * 0.022, -0.55 * self.back, self.top + _TAB / 2.0 - 0.002)
            grasps = [ag.grasp_on(tab, approach=-ag.Z, closing=(1.0, 0.0, 0.0), depth=0.011)]
            solids.append(tab)
        name = "lid_left" if side < 0 else "lid_right"
        bodies = [ag.part(solids[-1], "lid", finish, name=name, grasp=grasps)]
        bodies += [ag.part(each, "lid", finish) for each in solids[:-1]]
        under = ag.box(self.reach - 0.020, long - 0.02, 0.001)
        x = side * (self.axis - 0.5 * self.reach - 0.003)
        bodies.append(ag.detail(under.at(x, 0.0, self.level + _FLAP_EDGE - _THICK), "lid", dark))
        if linkage is not None:
            bodies += [ag.part(each, "lid", ag.material("steel")) for each in self._crank(side, linkage)]
        return ag.weld(*bodies)

    def _crank(self, side: int, linkage: Linkage) -> list[ag.Solid]:
        """Make the shaft of a flap and the crank at its end, at rest."""
        x, z = side * self.axis, self.level
        shaft = ag.cylinder_between((x, self.back - 0.006, z), (x, self.crank_y + 0.0062, z), _SHAFT)
        plate = ag.box(linkage.crank, 0.0032, 0.006, bevel=0.0008).at(
            -0.5 * side * linkage.crank, 0.0046, 0.0
        )
        pin = ag.cylinder(PIN, 0.0124, axis=ag.Y).at(-side * linkage.crank, 0.0, 0.0)
        turned = [each.rotate(ag.Y, -0.5 * side * linkage.opening) for each in (plate, pin)]
        return [shaft, *(each.at(side * self.axis, self.crank_y, self.level) for each in turned)]

    def crossbar(self, linkage: Linkage, finish: ag.Material) -> ag.Body:
        """Make the crossbar that lifts both cranks, which is welded to the rod."""
        high = self.level - linkage.lift / 2.0 - PIN - 0.0012
        half = self.axis - 0.6 * linkage.crank
        bar = ag.box(2.0 * half, 0.0055, 0.005, bevel=0.001).at(0.0, self.crank_y - 0.003, high - 0.0025)
        return ag.part(bar, "rod", finish)

    def turn(
        self,
        side: int,
        *,
        linkage: Linkage | None,
        pedal: ag.Joint | None,
        friction: ag.Scalar,
        damping: ag.Scalar,
    ) -> ag.Joint:
        """Make the joint of one flap; positive opens it."""
        follows = None
        if linkage is not None and pedal is not None:
            follows = pedal * (linkage.opening / linkage.angle)
        return ag.Revolute(
            f"lid_hinge_{'left' if side < 0 else 'right'}",
            axis=side * ag.Y,
            pivot=(side * self.axis, 0.0, self.level),
            limits=(0.0, self.opening) if follows is None else None,
            follows=follows,
            friction=friction,
            damping=damping,
            armature=0.0003,
            effort=5.0,
            velocity=8.0,
        )

    def clear(self, height: ag.Scalar, beside: ag.Scalar) -> ag.Float:
        """Return the angle at which both flaps clear the parts that rise between them [rad]."""
        del height  # these parts rise past the tips of the flaps
        return ag.atan2(self.reach, beside - _THICK)


Turning = Literal["swing", "disc", "ball", "ring"]
"""Kind of hood; a ring has no lid, and holds a bag."""

_SHEET = 0.003  # thickness of the plate around a lid [m]
_SKIN = 0.003  # thickness of the skirt of a hood outside the gap [m]
_OVER = 0.0026  # gap between the rim and the skirt around it [m]
_SKIRT = 0.014  # reach of the skirt down over the rim [m]
_ON = 0.0022  # gap between the rim and the part on it [m]
_EDGE = 0.0030  # gap between a lid and the edge of its opening [m]
_BALL_EDGE = 0.0052  # gap around a ball; its colliders are up to 2 mm off the surface [m]
_EAR = 0.020  # projection of the ears by which a hood is lifted [m]
_WIDEST = 0.425  # largest width of a round collar that collides as 32 pieces and not as 64 [m]
_TOO_WIDE = "the collar of so wide a round bin needs too many colliders: lower width"
_GRAVITY = 9.81  # gravity [m/s2]


@dataclass(frozen=True)
class Hood:
    """A hood over the rim of a bin."""

    can: Can  # bin
    kind: Turning  # kind of turning part
    rise: ag.Scalar  # height of the slope [m]
    lean: float  # share by which the top is smaller than the skirt
    finish: ag.Material  # material of the hood

    @property
    def label(self) -> str:
        """Label of the hood, and name of its link."""
        return "ring" if self.kind == "ring" else "hood"

    @property
    def _level(self) -> Can:
        can = self.can
        return Can(can.plan, can.width, can.depth, can.top, can.foot, can.corner, can.sheet)

    @property
    def low(self) -> ag.Scalar:
        """Height of the underside, just above the rim [m]."""
        return self.can.top + _ON

    @property
    def top(self) -> ag.Scalar:
        """Height of the upper face [m]."""
        return self.low + self.rise

    @property
    def axis(self) -> ag.Scalar:
        """Height of the axis of the lid [m]."""
        return self.top - (0.003 if self.kind == "ball" else 0.005)

    @property
    def _opening(self) -> tuple[ag.Scalar, ag.Scalar]:
        """Width and depth of the opening; twice the diameter for a round opening [m]."""
        share = 1.0 - self.lean
        if self.kind == "ball":
            across = self.can.width - 2.0 * (self.can.wall + 0.004)
            return across, across
        if self.kind == "disc":
            return self.can.width - 0.030, self.can.depth - 0.030
        if self.kind == "ring":
            return self.can.width - 0.012, self.can.depth - 0.012
        if self.can.plan == "round":
            side = 0.66 * share * self.can.width
            return 1.06 * side, side
        return share * self.can.width - 0.042, share * self.can.depth - 0.042

    def _hole(self, gap: ag.Scalar) -> ag.Profile:
        """Make the opening, smaller by a gap all around."""
        across, along = self._opening
        if self.kind == "ball" or (self.kind != "swing" and self.can.plan == "round"):
            return ag.circle(across / 2.0 - gap)
        border = (1.0 - self.lean) * self.can.corner - (self.can.width - across) / 2.0
        radius = ag.max_(border, 0.006)
        if self.kind == "swing":
            radius = ag.min_(radius, 0.008)  # the lid has no round corners
        return ag.rectangle(across - 2.0 * gap, along - 2.0 * gap, radius=radius)

    def body(self, trim: ag.Material) -> ag.Body:
        """Make the hood: the link `hood`."""
        level = self._level
        out = -(_OVER + _SKIN)
        skirt = level.band(self.can.top - _SKIRT, self.low + 0.004, outer=out, inner=-_OVER)
        if self.kind == "swing":
            ring = level.outline(out) - level.outline(0.0015)
            slope = ag.simplified_collider(ag.extrude(ring, self.top - self.low, taper=self.lean), 0.0008)
            sheet = level.outline(out).scale(1.0 - self.lean) - self._hole(0.0)
            plate = ag.simplified_collider(ag.extrude(sheet, _SHEET, bevel=0.0006), 0.0005).at(
                0.0, 0.0, self.top - _SHEET / 2.0 + 0.0008
            )
            solids = [slope.at(0.0, 0.0, (self.low + self.top) / 2.0), plate]
        else:
            ring = level.outline(out) - self._hole(0.0)
            collar = ag.extrude(ring, self.top - self.low, bevel=0.0010)
            if self.can.plan == "round":
                collar = collar.require(self.can.width < _WIDEST, _TOO_WIDE)
            solids = [ag.simplified_collider(collar, 0.0007).at(0.0, 0.0, (self.low + self.top) / 2.0)]
        bearings: list[ag.Body] = []
        if self.kind != "ring":
            bearings = self._bosses(trim) if self.kind == "ball" else self._lugs(trim)
        return ag.weld(
            *(ag.part(each, self.label, self.finish) for each in solids),
            ag.detail(skirt, self.label, self.finish),
            *bearings,
            *self._ears(),
        )

    def _ears(self) -> list[ag.Body]:
        """Make the ears at both sides, for the hands that lift the hood."""
        bodies = []
        x = self.can.width / 2.0 + _OVER + _SKIN
        z = self.low + 0.0045
        ear = ag.box(_EAR + 0.003, 0.055, 0.005, bevel=0.0016)
        for side in (-1, 1):
            solid = ear.at(side * (x + _EAR / 2.0 - 0.0015), 0.0, z)
            hold = ag.grasp_on(
                solid, approach=(-side, 0.0, 0.0), closing=ag.Z, at=(side * (x + 0.012), 0.0, z), depth=0.016
            )
            name = f"{self.label}_ear_{'left' if side < 0 else 'right'}"
            bodies.append(ag.part(solid, self.label, self.finish, name=name, grasp=hold))
        return bodies

    def _lugs(self, trim: ag.Material) -> list[ag.Body]:
        """Make the bearings under the plate beside the lid, with their pins."""
        x = self._opening[0] / 2.0
        bodies = []
        for side in (-1, 1):
            lug = ag.box(0.007, 0.016, 0.014, bevel=0.0012)
            bodies.append(
                ag.part(lug.at(side * (x + 0.0036), 0.0, self.top - 0.009), self.label, self.finish)
            )
            pin = ag.cylinder(0.003, 0.0063, axis=ag.X).at(
                side * (x + 0.00035), 0.0, self.axis
            )  # up to the lid
            bodies.append(ag.detail(pin, self.label, trim))
        return bodies

    def _bosses(self, trim: ag.Material) -> list[ag.Body]:
        """Make the caps over the pins of a ball."""
        x = self._opening[0] / 2.0
        bodies = []
        for side in (-1, 1):
            low = ag.box(0.010, 0.030, 0.018, bevel=0.003)
            bodies.append(
                ag.part(low.at(side * (x + 0.0052), 0.0, self.top + 0.006), self.label, self.finish)
            )
            screw = ag.cylinder(0.0045, 0.003, axis=ag.X, bevel=0.0008)
            bodies.append(ag.detail(screw.at(side * (x + 0.0102), 0.0, self.top + 0.006), "screw", trim))
        return bodies

    def lift(self, body: ag.Body, *, travel: ag.Scalar) -> ag.Joint:
        """Make the joint of a hood, which is lifted off."""
        return ag.Prismatic(
            f"{self.label}_lift",
            axis=ag.Z,
            limits=(0.0, travel),
            friction=1.0,  # friction of the skirt on the rim
            damping=4.0,
            effort=1.4 * _GRAVITY * body.mass() + 3.0,
            velocity=1.0,
        )

    def lid(self, *, finish: ag.Material, dark: ag.Material) -> ag.Body:
        """Make the turning part of the hood: the link `lid`."""
        if self.kind == "ball":
            return self._ball(finish, dark)
        across, along = self._opening
        if self.kind == "disc":
            shape = ag.extrude(self._hole(_EDGE), 0.006, bevel=0.0022).at(0.0, 0.0, self.axis)
            bottom = ag.extrude(self._hole(_EDGE + 0.006), 0.001).at(0.0, 0.0, self.axis - 0.003)
        else:
            length, rise = along - 2.0 * _EDGE, 0.11 * along
            radius = (length * length / 4.0 + rise * rise) / (2.0 * rise)
            section = ag.circle(radius).at(0.0, rise - radius) & ag.rectangle(length, rise + 0.004).at(
                0.0, rise / 2.0 - 0.002
            )
            shape = ag.extrude(section, across - 2.0 * _EDGE, axis=ag.X, bevel=0.0012).at(0.0, 0.0, self.axis)
            bottom = ag.box(across - 0.02, length - 0.014, 0.001).at(0.0, 0.0, self.axis - 0.004)
        at = (0.0, -0.33 * along, 0.0)
        far = (0.0, 0.33 * along, 0.0)
        down = [
            ag.push_on(shape, direction=-ag.Z, at=point)
            for point in ((at, far) if self.kind == "disc" else ())
        ]
        if self.kind == "swing":
            down = [self._push(shape, -0.33 * along), self._push(shape, 0.33 * along)]
        body = ag.part(shape, "lid", finish, push=down)
        return ag.weld(body, ag.detail(bottom, "lid", dark))

    def _push(self, shape: ag.Solid, y: ag.Scalar) -> ag.Frame:
        """Return the push of a finger on an arched lid, normal to its surface."""
        along = self._opening[1]
        length, rise = along - 2.0 * _EDGE, 0.11 * along
        radius = (length * length / 4.0 + rise * rise) / (2.0 * rise)
        height = (radius * radius - y * y) ** 0.5
        return ag.push_on(
            shape, direction=(0.0, -y, -height), at=(0.0, y, self.axis + rise - radius + height - 0.004)
        )

    def _ball(self, finish: ag.Material, dark: ag.Material) -> ag.Body:
        radius = self._opening[0] / 2.0 - _BALL_EDGE
        half = ag.dome(radius).at(0.0, 0.0, self.axis)
        bar = ag.box(0.090, 0.011, 0.009, bevel=0.003).at(0.0, 0.0, self.axis + radius + 0.026)
        # drop of the ball from its top to a point under a post
        falls = radius - ag.sqrt(radius * radius - 0.040**2)
        longer = ag.max_(falls - 0.0065, 0.0)
        posts = [
            ag.box(0.009, 0.011, 0.036 + longer, bevel=0.002).at(
                side * 0.040, 0.0, self.axis + radius + 0.010 - longer / 2.0
            )
            for side in (-1, 1)
        ]
        hold = ag.grasp_on(bar, approach=-ag.Z, closing=(0.0, 1.0, 0.0))
        below = ag.cylinder(radius - 0.006, 0.001).at(0.0, 0.0, self.axis)
        return ag.weld(
            ag.part(half, "lid", finish),
            ag.part(bar, "lid", dark, grasp=hold),
            *(ag.part(each, "lid", dark) for each in posts),
            ag.detail(below, "lid", dark),
        )

    def dip(self, opening: ag.Scalar) -> ag.Float:
        """Return the lowest height of the edge of the turning lid [m]."""
        return self.axis - 0.5 * self._opening[1] * ag.sin(opening)

    def turn(self, body: ag.Body, *, opening: ag.Scalar) -> ag.Joint:
        """Make the joint of the lid, which turns both ways."""
        if self.kind == "swing":
            stiffness, friction, damping = 0.16, 0.003, 0.012
        elif self.kind == "disc":
            stiffness, friction, damping = 0.0, 0.05, 0.02
        else:
            stiffness, friction, damping = 0.0, 0.0, 0.04
        held = (
            friction if self.kind != "ball" else 1.5 * _GRAVITY * body.mass() * 0.45 * self._opening[0] / 2.0
        )
        return ag.Revolute(
            "lid_hinge",
            axis=ag.X,
            pivot=(0.0, 0.0, self.axis),
            limits=(-opening, opening),
            stiffness=stiffness,
            friction=held,
            damping=damping,
            armature=0.0003,
            effort=6.0,
            velocity=10.0,
        )
