"""Hinged lids at the back of a bin, and touch lids with their latch and spring.

The hinge's axis runs along x behind the rim, below the underside of the lid: the parts of the lid in front of
and above the axis stay above it until the lid is upright.
"""

import math
from dataclasses import dataclass, replace
from typing import Literal

import artgen as ag
from artgen.categories.shared.controls import button_press
from artgen.categories.shared.finish import casting
from artgen.categories.trashcan.bins import Can, Plan
from artgen.categories.trashcan.pedals import Linkage

LidStyle = Literal["flat", "domed", "stepped"]
"""A slab with soft edges, a cushion shape, or a slab with a smaller slab on it."""

Grip = Literal["none", "lip", "bar", "knob"]
"""Grip of a lid: none, a lip in front, a bar or a knob on it."""

GAP = 0.0023
"""Gap between the rim and the lid [m]."""

PROUD = 0.0012
"""Height of the band of the rim above the wall [m]."""

STEP = 0.006
"""Height of the middle of a stepped lid above its edge [m]."""

SPARE = 0.004
"""Clearance between an open lid and the parts that rise in front of it [m]."""

_HUB = 0.0062  # radius of the lid's hub [m]
_HALF = 0.013  # half of the length of the hub [m]
_CHEEK = 0.0034  # thickness of the cheeks beside the hub [m]
_ROUND = 0.0082  # radius of the cheeks about the pin [m]
_SHELL = 0.4  # mass of a molding with 1.3 mm walls, as a share of a solid one
_CUSHION = 90.0  # density for sheet of 0.4 mm around air, 2-3 kg/m2 at a height of 25-35 mm [kg/m3]
_LEAST_ROUND = 0.012  # least corner radius of a cushion [m]
_SLOPE = 2.25  # largest inward lean of a cushion over its rise: its lower edge can still be rounded
_BELOW = 0.006  # depth of the axis under the rim [m]
_SOFT = 0.0032  # bevel of a slab [m]
_WITHIN = 0.0003  # depth of facets below the visible surface [m]
_LIP = 0.020  # length of a lip in front [m]


@dataclass(frozen=True)
class Hinge:
    """The hinge at the back of a bin."""

    can: Can  # bin
    behind: ag.Scalar  # distance of the axis behind the rim's wall [m]
    foot: ag.Scalar  # height of the lower end of the housing [m]

    @property
    def axis(self) -> tuple[ag.Scalar, ag.Scalar]:
        """Position of the axis, y and z [m]."""
        return self.can.back + self.behind, self.can.top - _BELOW

    def housing(
        self, finish: ag.Material, *, sill: bool = True, damper: bool = False, label: str = "hinge"
    ) -> ag.Body:
        """Make the block behind the rim with the pin: two cheeks, and the cover between them."""
        y, z = self.axis
        finish = casting(finish, _SHELL)
        near, far = self.can.back - 0.004, y + 0.008
        round_ = ag.cylinder(_ROUND, _CHEEK, axis=ag.X, bevel=0.0012)
        parts: list[ag.Body] = []
        cheek = ag.Region((-_CHEEK / 2.0, _CHEEK / 2.0), (near, far), (self.foot, z)).box(bevel=0.0012)
        for side in (-1, 1):
            x = side * (_HALF + 0.0005 + _CHEEK / 2.0)
            parts.append(ag.part(cheek.at(x, 0.0, 0.0), label, finish))
            parts.append(ag.part(round_.at(x, y, z), label, finish))
        half = _HALF + _CHEEK
        cover = ag.Region((-half, half), (far - 0.0027, far + 0.0003), (self.foot, z - 0.010)).box(
            bevel=0.0012
        )
        parts.append(ag.part(cover, label, finish))
        if sill:
            plate = ag.Region((-half, half), (near, far), (self.foot, self.foot + 0.003)).box(bevel=0.001)
            parts.append(ag.part(plate, label, finish))
        head = ag.cylinder(0.0034, _CHEEK, axis=ag.X, bevel=0.0008)
        for side in (-1, 1):
            out = _HALF + _CHEEK / 2.0 + 0.0012
            parts.append(ag.detail(head.at(side * out, y, z), "screw", ag.material("stainless")))
        if damper:
            disc = ag.cylinder(0.0075, 0.006, axis=ag.X, bevel=0.001).at(_HALF + _CHEEK + 0.003, y, z)
            parts.append(ag.detail(disc, label, ag.material("glossy_plastic_black")))
        return ag.weld(*parts)

    def arm(self, low: ag.Scalar, thick: ag.Scalar) -> list[ag.Solid]:
        """Make the hub of the lid and the arm from it to a lid with its underside at a height."""
        y, z = self.axis
        hub = ag.cylinder(_HUB, 2.0 * _HALF, axis=ag.X, bevel=0.0008).at(0.0, y, z)
        top = low + 0.7 * thick
        rise = top - 0.001 - z
        neck = ag.box(2.0 * _HALF - 0.002, 0.010, rise, bevel=0.0015).at(0.0, y - 0.0015, z + rise / 2.0)
        bridge = ag.Region((-_HALF, _HALF), (self.can.back - 0.010, y + 0.004), (low, top)).box(bevel=0.0015)
        return [hub, neck, bridge]

    def turn(
        self,
        *,
        opening: ag.Scalar | None = None,
        linkage: Linkage | None = None,
        pedal: ag.Joint | None = None,
        friction: ag.Scalar = 0.03,
        damping: ag.Scalar = 0.05,
        name: str = "lid_hinge",
    ) -> ag.Joint:
        """Make the joint of the lid; positive opens it."""
        y, z = self.axis
        follows = None
        if linkage is not None and pedal is not None:
            follows = pedal * (linkage.opening / linkage.angle)
        return ag.Revolute(
            name,
            axis=-ag.X,
            pivot=(0.0, y, z),
            limits=None if opening is None else (0.0, opening),
            follows=follows,
            friction=friction,
            damping=damping,
            armature=0.001,  # inertia of the rotor of the geared damper
            effort=12.0,
            velocity=8.0,
        )

    @property
    def far(self) -> ag.Scalar:
        """Position of the rear end of the cover, along y [m]."""
        return self.axis[0] + 0.0083

    def clear(self, height: ag.Scalar, before: ag.Scalar) -> ag.Float:
        """Return the angle at which the lid clears the parts that rise from the bin [rad]."""
        return ag.atan2(height, self.behind + before - SPARE)


def lid_panel(
    can: Can,
    *,
    low: ag.Scalar,
    thick: ag.Scalar,
    style: LidStyle,
    finish: ag.Material,
    overhang: ag.Scalar = 0.0015,
) -> ag.Body:
    """Make the panel of a lid, with its underside at a height: the link `lid`."""
    level = Can(can.plan, can.width, can.depth, low + thick, low, can.corner, can.sheet)
    slab = ag.extrude(level.outline(-overhang), thick, bevel=_SOFT).at(0.0, 0.0, low + thick / 2.0)
    radius = can.width / 2.0 + overhang
    bodies = _faceted(slab, _disc(radius, thick).at(0.0, 0.0, low), finish, can.plan)
    top = low + thick
    hollow = finish.with_(name=f"{finish.name}_cushion", density=_CUSHION)
    if style == "domed" and can.plan == "round":
        radius = radius - 0.004
        rise = 0.16 * can.width
        cushion = ag.dome(radius, height=rise).at(0.0, 0.0, top - 0.001)
        bodies += _faceted(cushion, _cap(radius, rise).at(0.0, 0.0, top - 0.001), hollow, can.plan)
    elif style == "domed":
        rise = 0.016
        soft = replace(level, corner=ag.max_(can.corner, _LEAST_ROUND))
        taper = ag.min_(0.16, _SLOPE * rise / soft.diagonal)
        slope = ag.extrude(soft.outline(0.003 - overhang), rise, taper=taper, bevel=0.005)
        bodies.append(ag.part(slope.at(0.0, 0.0, top - 0.002 + rise / 2.0), "lid", hollow))
    elif style == "stepped":
        step = level.block(top - 0.001, top + STEP, inset=0.014, bevel=0.0025)
        bodies.append(ag.part(step, "lid", finish))
    liner = ag.extrude(level.outline(can.wall + 0.006), 0.0016).at(0.0, 0.0, low)
    bodies.append(ag.detail(liner, "lid", ag.material("black_abs")))
    return ag.weld(*bodies)


def _faceted(seen: ag.Solid, met: ag.Solid, finish: ag.Material, plan: Plan) -> list[ag.Body]:
    """Make one piece of a lid; a round piece has a skin without colliders over a core of few facets.

    A round slab would collide as four pieces of many vertices, a cushion as eight, and simulators find
    contacts with the flat side of so wide a cylinder only roughly.
    """
    if plan != "round":
        return [ag.part(seen, "lid", finish)]
    return [ag.part(met, "lid", finish), ag.detail(seen, "lid", finish)]


def _disc(radius: ag.Scalar, thick: ag.Scalar) -> ag.Solid:
    """Make a disc of few facets inside a slab with its underside at z = 0.

    It has four quarters, so that a lid touches a raised bucket at points all around.
    """
    wide, high = radius - 0.8 * _SOFT, thick - 2.0 * _WITHIN
    quarter = ag.revolve(ag.rectangle(wide, high).at(wide / 2.0, thick / 2.0), angle=math.pi / 2.0, sides=32)
    return ag.union(*(quarter.rotate(ag.Z, number * math.pi / 2.0) for number in range(4)))


def _cap(radius: ag.Scalar, rise: ag.Scalar) -> ag.Solid:
    """Make half of an ellipsoid of few facets inside a smooth one."""
    turns = (0.0, 0.36, 0.78)
    wide, high = radius - _WITHIN, rise - _WITHIN
    line = [(wide * math.cos(turn), high * math.sin(turn)) for turn in turns]
    flat = 0.22  # radius of the flat top, as a share
    return ag.revolve(
        ag.polygon([(0.0, 0.0), *line, (flat * wide, 0.975 * high), (0.0, 0.975 * high)]), sides=15
    )


def lid_grip(
    can: Can, *, low: ag.Scalar, thick: ag.Scalar, style: Grip, lid: LidStyle
) -> tuple[list[ag.Solid], list[ag.Frame]]:
    """Make the grip of a lid, as a part of it, with its grasp frames."""
    if style == "lip" or lid == "domed":
        wide = 0.34 * can.width
        lip = ag.box(wide, _LIP + 0.012, 0.008, bevel=0.003)
        lip = lip.at(0.0, can.front - _LIP / 2.0 + 0.006, low + thick / 2.0)
        hold = ag.grasp_on(lip, at=(0.0, can.front - _LIP + 0.008, low + thick / 2.0), depth=0.015)
        return [lip], [hold]
    y, top = can.front + 0.30 * can.depth, low + thick + (STEP if lid == "stepped" else 0.0)
    if style == "bar":
        wide = 0.10
        bar = ag.box(wide, 0.012, 0.008, bevel=0.003).at(0.0, y, top + 0.030)
        post = ag.box(0.010, 0.012, 0.032, bevel=0.002)
        posts = [post.at(side * (wide / 2.0 - 0.005), y, top + 0.015) for side in (-1, 1)]
        return [bar, *posts], [ag.grasp_on(bar, approach=-ag.Z, closing=ag.Y)]
    knob = ag.cylinder(0.017, 0.014, bevel=0.004).at(0.0, y, top + 0.024)
    post = ag.cylinder(0.007, 0.022).at(0.0, y, top + 0.008)
    return [knob, post], [ag.grasp_on(knob, approach=-ag.Z, closing=ag.Y, depth=0.013)]


ROOM = 0.027
"""Depth of the catch behind the front wall [m]."""

_TONGUE = 0.024  # width of the tongue [m]
_REACH = 0.034  # reach of the tongue below the rim [m]
_BEHIND = 0.015  # distance from the outer face of the wall to the middle of the tongue [m]
_THIN = 0.003
_FOOT = 0.0045  # reach of the foot of the tongue inward [m]
_PLAY = 0.0005  # gap between the foot and the bar above it [m]
_CAP = (0.050, 0.013, 0.016)  # width, height and depth of the button [m]
_PROUD = 0.009  # height of the button above the wall [m]
_TRAVEL = 0.0062  # travel of the button [m]
_FREE = 0.0049  # travel at which the foot passes [m]
_FRICTION = 0.02  # friction of the hinge of a lid [N m]
_GRAVITY = 9.81  # gravity [m/s2]


@dataclass(frozen=True)
class Catch:
    """The catch between a lid and the front of a bin."""

    can: Can  # bin

    @property
    def _foot(self) -> ag.Scalar:
        """Height of the underside of the foot [m]."""
        return self.can.top - _REACH

    @property
    def _bar(self) -> ag.Scalar:
        """Height of the middle of the bar and of the button [m]."""
        return self._foot + _THIN + _PLAY + 0.002

    def hole(self) -> ag.Solid:
        """Make the cutter for the hole of the button in the front wall."""
        wide, _, high = _CAP
        tool = ag.box(wide + 0.001, 0.04, high + 0.001)
        return tool.at(0.0, self.can.front, self._bar)

    def tongue(self, low: ag.Scalar) -> list[ag.Solid]:
        """Make the tongue, which is welded to a lid with its underside at a height."""
        y = self.can.front + _BEHIND
        blade = ag.box(_TONGUE, _THIN, low + 0.004 - self._foot, bevel=0.0008)
        foot = ag.box(_TONGUE - 0.001, _FOOT + 0.001, _THIN, bevel=0.0006)
        return [
            blade.at(0.0, y, (low + 0.004 + self._foot) / 2.0),
            foot.at(0.0, y + _THIN / 2.0 + (_FOOT - 0.001) / 2.0, self._foot + _THIN / 2.0),
        ]

    def button(self, finish: ag.Material, hidden: ag.Material) -> ag.Body:
        """Make the button with its bar: the link `button`."""
        wide, deep, high = _CAP
        cap = ag.box(wide, deep, high, bevel=0.003).at(0.0, self.can.front - _PROUD + deep / 2.0, self._bar)
        start = self.can.front + 0.001
        far = self.can.front + _BEHIND + _THIN / 2.0 + 0.0008
        arm = ag.box(0.003, far + 0.004 - start, 0.004)
        bar = ag.box(_TONGUE + 0.010, 0.004, 0.004, bevel=0.0006).at(0.0, far + 0.002, self._bar)
        arms = [
            arm.at(side * (_TONGUE / 2.0 + 0.0032), (start + far + 0.004) / 2.0, self._bar)
            for side in (-1, 1)
        ]
        body = ag.part(cap, "button", finish, push=ag.push_on(cap, direction=ag.Y))
        return ag.weld(body, *(ag.part(each, "button", hidden) for each in (bar, *arms)))

    def press(self, name: str = "button_slide") -> ag.Joint:
        """Make the joint of the button."""
        return button_press(
            name, travel=_TRAVEL, preload=0.9, force=6.0, pivot=(0.0, self.can.front, self._bar)
        )

    def frees(self, press: ag.Joint) -> ag.Dependency:
        """Return the condition under which the foot of the lid can pass the bar."""
        # the foot rises by the heights of foot and bar, with 3 mm to spare
        passed = (_THIN + 0.004 + 0.004) / (0.85 * self.can.depth)
        return (press > _FREE).until(passed)


def sprung_lid(
    hinge: Hinge, lid: ag.Body, *, opening: ag.Scalar, needs: ag.Dependency, damping: ag.Scalar
) -> ag.Joint:
    """Make the joint of a lid with an opening spring, a third stronger than its weight and friction."""
    y, z = hinge.axis
    weight: ag.Float = _GRAVITY * lid.mass() * (y - lid.center_of_mass().y)
    start, end = 1.35 * weight + _FRICTION, 0.45 * weight
    stiffness = (start - end) / opening
    return ag.Revolute(
        "lid_hinge",
        axis=-ag.X,
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
