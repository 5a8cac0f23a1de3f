"""Pedals: a lever under the bin lifts a rod, and the rod turns the lid by its crank.

The lengths of the levers give the ratio of the coupling: foot plate to pin, pin to rod, and rod to the lid's
axis. The lever and the crank both swing symmetrically about the horizontal, where sines and angles differ
least, so that the rod follows both within a millimeter.
"""

from collections.abc import Sequence

import artgen as ag
from artgen import details, feel
from artgen.categories.trashcan import finish
from artgen.categories.trashcan.bins import STEEL, Design, pair, stand

PIN = 0.0025  # radius of the pin at the end of the lid's crank [m]
_ROLLER = 0.004  # radius of the roller under the rod [m]
_SLOT = 0.030  # width of the slot for the lever in the wall [m]
_ARM = 0.022  # width of the lever [m]
_DEEP = 0.040  # length of the foot plate [m]
_PLATE = 0.007  # thickness of the foot plate [m]
_PLAY = 0.0008  # gap under the rod at rest [m]
_SLACK = 0.0012  # gap above the rod: the pin of the crank lags behind by up to 0.4 mm [m]
_FLOOR = 0.004  # gap under the pressed pedal [m]
_ROD = feel.Feel(friction=0.2, damping=2.0, effort=200.0)


class Linkage:
    """The levers between a pedal in front and the lid; `rod` is the position of the rod along y [m]."""

    def __init__(self, design: Design, rod: ag.Scalar) -> None:
        self.design, self.rod = design, rod
        # rise of the rod: the crank swings by half the opening angle to each side of the horizontal [m]
        self.lift: ag.Scalar = 2 * design.crank * ag.sin(design.opening / 2)
        length = (
            rod + design.can.depth / 2 + 0.008 + _DEEP / 2
        )  # from the middle of the foot plate to the rod [m]
        self.front = (
            length * design.travel / (design.travel + self.lift)
        )  # from the foot plate to the pin [m]
        rear = length * self.lift / (design.travel + self.lift)  # from the pin to the rod [m]
        sine = self.lift / (2 * rear)
        self.angle = 2 * ag.atan2(sine, ag.sqrt(1 - sine * sine))  # turn of the pedal [rad]
        self.ratio = design.opening / self.angle  # of the angles of the lid and of the pedal
        # neither end of the lever reaches the floor
        below = ag.max_(self.lift / 2 + _ROLLER, design.travel / 2 + _PLATE / 2)
        self.rear, self.y, self.z = rear, rod - rear, below + _FLOOR  # y and z of the pin [m]
        self.head = self.z + ag.max_(design.travel, self.lift) / 2 + 0.009  # height of the bin's floor [m]

    def stand(self, level: ag.Scalar, more: Sequence[ag.Solid] = ()) -> tuple[ag.Body, ag.Joint]:
        """Make the stand of a bin with its pedal and the rod up to cranks at a level, and the pedal's joint.

        The weight of the lid returns the pedal through the rod, together with a spring.
        """
        design = self.design
        high = self.head - 0.001
        slot = ag.box(_SLOT, design.can.depth + 0.1, high + 0.02).at(
            z=(high - 0.02) / 2
        )  # in front and behind
        spring = ag.Spring(preload=design.preload * self.front, force=design.force * self.front)
        # effort of a firm step
        drag = feel.Feel(damping=0.15, friction=0.04, armature=0.002, effort=90.0 * self.front, velocity=6.0)
        hinge = ag.Revolute("pedal_hinge", axis=ag.X, limits=(0.0, self.angle), spring=spring, feel=drag)
        rise = hinge * (self.lift / self.angle)
        slide = ag.Prismatic("rod_slide", axis=ag.Z, pivot=(0, self.rod, 0), follows=rise, feel=_ROD)
        body = ag.weld(stand(design, floor=self.head, holes=slot), self._bracket())
        body = body.attach(self._pedal(), hinge, at=(0, self.y, self.z))
        return body.attach(self._rod(level, more), slide), hinge

    def _pedal(self) -> ag.Body:
        """Make the lever with its foot plate at rest, about its pin: the link `pedal`."""
        design, front = self.design, self.front
        metal = ag.material("stainless") if design.finish.base_metalness > 0.5 else design.trim
        metal = metal.with_(name=f"{metal.name}_pedal", density=2400.0)  # a pressing with ribs below
        inner = front - 0.25 * _DEEP
        arm = ag.box(_ARM, inner + self.rear, 0.006, bevel=0.0012).at(y=(self.rear - inner) / 2)
        hub = ag.cylinder(0.0065, _ARM, axis=ag.X, bevel=0.001)
        roller = ag.cylinder(_ROLLER, _ARM, axis=ag.X).at(y=self.rear)
        top = 0.0005 + _PLATE / 2
        outline = ag.rectangle(design.pedal_width, _DEEP, radius=0.4 * _DEEP)
        plate = ag.extrude(outline, _PLATE, bevel=0.0022).at(0, -front, 0.0005)
        push = ag.push_on(plate, direction=-ag.Z, at=(0, -front - 0.15 * _DEEP, 0))
        sole = ag.rectangle(design.pedal_width - 0.012, _DEEP - 0.012, radius=0.4 * (_DEEP - 0.012))
        sheet = ag.extrude(sole, 0.0016).at(0, -front, top)
        sign, at = details.icon("pedal", 0.5 * _DEEP, weight="bold"), (0, -front, top + 0.0008)
        body = ag.weld(
            ag.part([plate, arm, hub, roller], "pedal", metal, push=push),
            ag.detail(sheet, "pedal", ag.material("rubber")),
            details.printed(sign, at, material=ag.material("abs"), facing=ag.Z, up=ag.Y),
        )
        return body.rotate(ag.X, -self.angle / 2)

    def _bracket(self) -> ag.Body:
        """Make the two cheeks under the floor with the pin, which are welded to the bin."""
        floor, low, high = self.head, self.z - 0.008, self.head + 0.001
        cheek = ag.box(0.003, 0.018, high - low, bevel=0.0008)
        screen = ag.box(0.001, self.design.can.depth - 0.008, floor - 0.006)
        end = ag.cylinder(0.003, 0.0059, axis=ag.X, bevel=0.0006)  # the end of the pin, beside the arm
        cheeks = pair(cheek, _ARM / 2 + 0.0021, self.y, (low + high) / 2)
        screens = pair(screen, _SLOT / 2 + 0.0008, z=floor / 2 + 0.003)  # no light passes through the slot
        return ag.weld(
            ag.part(cheeks, "base", self.design.plastic),
            ag.detail(screens, "base", finish.BLACK),
            ag.detail(pair(end, _ARM / 2 + 0.00355, self.y, self.z), "base", STEEL),
        )

    def _rod(self, level: ag.Scalar, more: Sequence[ag.Solid]) -> ag.Body:
        """Make the rod at rest up to cranks at a level: the link `rod`."""
        low = self.z - self.lift / 2 + _ROLLER + _PLAY
        high = level - self.lift / 2 - PIN - _SLACK
        bar = ag.box(0.005, 0.005, high - low - 0.002, bevel=0.001).at(0, self.rod, (low + high) / 2)
        foot = ag.box(0.012, 0.009, 0.004, bevel=0.001).at(0, self.rod, low + 0.002)
        head = ag.box(0.006, 0.3 * self.design.crank + 0.005, 0.005, bevel=0.001)
        return ag.part([bar, foot, head.at(0, self.rod, high - 0.0025), *more], "rod", STEEL)
