"""Pedals: a lever under the bin lifts a rod, and the rod turns the lid by its crank.

The lengths of the levers give the ratio of the coupling: foot plate to pin, pin to rod, and rod to the lid's
axis. The lever and the crank both swing symmetrically about the horizontal, where sines and angles differ
least, so that the rod follows both within a millimeter.
"""

from dataclasses import dataclass

import artgen as ag
from artgen import details

ROLLER = 0.004
"""Radius of the roller under the rod [m]."""

PIN = 0.0025
"""Radius of the pin at the end of the lid's crank [m]."""

SLOT = 0.030
"""Width of the slot for the lever [m]."""

_HUB = 0.0065  # radius of the lever's hub [m]
_THICK = 0.006  # thickness of the lever [m]
_PLATE = 0.007  # thickness of the foot plate [m]
_PLAY = 0.0008  # gap under the rod at rest [m]
_SLACK = 0.0012  # gap above the rod: the pin of the crank lags behind by up to 0.4 mm [m]
_FLOOR = 0.004  # gap under the pressed pedal [m]
_ARM = 0.022  # width of the lever [m]


def asin(value: ag.Scalar) -> ag.Float:
    """Return the arc sine of a number [rad]."""
    return ag.atan2(value, ag.sqrt(1.0 - value * value))


@dataclass(frozen=True)
class Linkage:
    """The levers between a pedal and a lid."""

    opening: ag.Scalar  # opening angle of the lid [rad]
    crank: ag.Scalar  # distance from the lid's axis to the pin that the rod lifts [m]
    travel: ag.Scalar  # travel of the middle of the foot plate [m]
    plate: ag.Scalar  # position of the middle of the foot plate along y [m]
    rod: ag.Scalar  # position of the rod along y [m]

    @property
    def lift(self) -> ag.Float:
        """Rise of the rod: the crank swings by half the opening angle to each side of the horizontal [m]."""
        return 2.0 * self.crank * ag.sin(self.opening / 2.0)

    @property
    def front(self) -> ag.Float:
        """Length of the lever from the pin to the foot plate [m]."""
        return (self.rod - self.plate) * self.travel / (self.travel + self.lift)

    @property
    def rear(self) -> ag.Float:
        """Length of the lever from the pin to the rod [m]."""
        return (self.rod - self.plate) * self.lift / (self.travel + self.lift)

    @property
    def angle(self) -> ag.Float:
        """Turn of the pedal [rad]."""
        return 2.0 * asin(self.lift / (2.0 * self.rear))

    @property
    def pin(self) -> tuple[ag.Scalar, ag.Scalar]:
        """Position of the pin of the lever, y and z: neither end reaches the floor [m]."""
        below = ag.max_(self.lift / 2.0 + ROLLER, self.travel / 2.0 + _PLATE / 2.0)
        return self.rod - self.rear, below + _FLOOR

    @property
    def head(self) -> ag.Float:
        """Height of the space of the lever above the floor [m]."""
        return self.pin[1] + ag.max_(self.travel, self.lift) / 2.0 + 0.009

    def turn(self, *, preload: ag.Scalar, force: ag.Scalar, damping: ag.Scalar = 0.15) -> ag.Joint:
        """Make the joint of the pedal; positive presses the foot plate down.

        The lid's weight returns it through the rod, together with a spring.
        """
        stiffness = (force - preload) * self.front / self.angle
        y, z = self.pin
        return ag.Revolute(
            "pedal_hinge",
            axis=ag.X,
            pivot=(0.0, y, z),
            limits=(0.0, self.angle),
            stiffness=stiffness,
            rest=-preload * self.front / stiffness,
            damping=damping,
            friction=0.04,
            armature=0.002,
            effort=90.0 * self.front,  # force of a firm step
            velocity=6.0,
        )

    def pedal(
        self, *, finish: ag.Material, width: ag.Scalar, deep: ag.Scalar, sole: str = "pedal"
    ) -> ag.Body:
        """Make the lever with its foot plate, at rest: the link `pedal`."""
        front, rear = self.front, self.rear
        inner = front - 0.25 * deep
        arm = ag.box(_ARM, inner + rear, _THICK, bevel=0.0012).at(0.0, (rear - inner) / 2.0, 0.0)
        hub = ag.cylinder(_HUB, _ARM, axis=ag.X, bevel=0.001)
        roller = ag.cylinder(ROLLER, _ARM, axis=ag.X).at(0.0, rear, 0.0)
        outline = ag.rectangle(width, deep, radius=0.4 * deep)
        plate = ag.extrude(outline, _PLATE, bevel=0.0022).at(0.0, -front, 0.0005)
        at = (0.0, -front - 0.15 * deep, 0.0)
        rubber = ag.material("rubber")
        top = 0.0005 + _PLATE / 2.0
        sheet = ag.extrude(ag.rectangle(width - 0.012, deep - 0.012, radius=0.4 * (deep - 0.012)), 0.0016)
        sign = details.icon(sole, 0.5 * deep, weight="bold")
        light = ag.material("abs")
        body = ag.weld(
            ag.part(plate, "pedal", finish, push=ag.push_on(plate, direction=-ag.Z, at=at)),
            *(ag.part(each, "pedal", finish) for each in (arm, hub, roller)),
            ag.detail(sheet.at(0.0, -front, top), "pedal", rubber),
            details.printed(
                sign, (0.0, -front, top + 0.0008), material=light, facing=ag.Z, up=(0.0, 1.0, 0.0)
            ),
        )
        y, z = self.pin
        return body.rotate(ag.X, -0.5 * self.angle).at(0.0, y, z)

    def bracket(self, *, floor: ag.Scalar, depth: ag.Scalar, finish: ag.Material) -> ag.Body:
        """Make the two cheeks under the floor with the pin, which are welded to the bin."""
        y, z = self.pin
        low = z - 0.008
        cheek = ag.box(0.003, 0.018, floor - low + 0.001, bevel=0.0008)
        parts: list[ag.Body] = []
        for side in (-1, 1):
            x = side * (_ARM / 2.0 + 0.0006 + 0.0015)
            parts.append(ag.part(cheek.at(x, y, (low + floor + 0.001) / 2.0), "base", finish))
        dark = ag.material("black_abs")
        for side in (-1, 1):  # no light passes through the slot
            screen = ag.box(0.001, depth - 0.008, floor - 0.006)
            parts.append(
                ag.detail(screen.at(side * (SLOT / 2.0 + 0.0008), 0.0, floor / 2.0 + 0.003), "base", dark)
            )
        end = ag.cylinder(0.003, 0.0059, axis=ag.X, bevel=0.0006)  # the end of the pin, beside the arm
        for side in (-1, 1):
            placed = end.at(side * (_ARM / 2.0 + 0.00355), y, z)
            parts.append(ag.detail(placed, "base", ag.material("steel")))
        return ag.weld(*parts)

    def rod_body(self, *, axis: ag.Scalar, finish: ag.Material) -> ag.Body:
        """Make the rod at rest: the link `rod`."""
        low = self.pin[1] - self.lift / 2.0 + ROLLER + _PLAY
        high = axis - self.lift / 2.0 - PIN - _SLACK
        bar = ag.box(0.005, 0.005, high - low - 0.002, bevel=0.001).at(0.0, self.rod, (low + high) / 2.0)
        foot = ag.box(0.012, 0.009, 0.004, bevel=0.001).at(0.0, self.rod, low + 0.002)
        head = ag.box(0.006, 0.3 * self.crank + 0.005, 0.005, bevel=0.001).at(0.0, self.rod, high - 0.0025)
        return ag.weld(*(ag.part(each, "rod", finish) for each in (bar, foot, head)))

    def rod_slide(self, pedal: ag.Joint) -> ag.Joint:
        """Make the joint of the rod, which follows the pedal."""
        return ag.Prismatic(
            "rod_slide",
            axis=ag.Z,
            pivot=(0.0, self.rod, 0.0),
            follows=pedal * (self.lift / self.angle),
            friction=0.2,
            damping=2.0,
            effort=200.0,
        )

    def cranks(self, *, axis: tuple[ag.Scalar, ag.Scalar]) -> list[ag.Solid]:
        """Make the crank of the lid at rest, which is welded to it: two plates and the pin between them."""
        y, z = axis
        plate = ag.box(0.0032, self.crank, 0.006, bevel=0.0008).at(0.0, -0.5 * self.crank, 0.0)
        pin = ag.cylinder(PIN, 0.0164, axis=ag.X).at(0.0, -self.crank, 0.0)
        level = [plate.at(0.0066, 0.0, 0.0), plate.at(-0.0066, 0.0, 0.0), pin]
        return [each.rotate(ag.X, self.opening / 2.0).at(0.0, y, z) for each in level]
