"""Interior of a dishwasher: racks with their fittings, and spray arms."""

from dataclasses import dataclass

import artgen as ag
from artgen import details
from artgen._arrays import cached_property
from artgen.categories.dishwasher.space import ROLLER, UNDER, Size, Space
from artgen.categories.shared.baskets import Basket, Grip, rack_slide, rollers

UPPER_ROLLER = 0.0095
"""Radius of the rollers of the upper racks [m]."""

FRONT_RIM = 0.105
"""Height of the front of the lower rack above its floor [m]."""

_BACK_RIM = 0.135
_UPPER_RIM = 0.085
_TRAY = 0.036  # height of the cutlery tray [m]
_BESIDE = 0.020  # gap between the wires of a rack and the wall of the tub [m]
_BLADE = 0.011  # thickness of a spray arm [m]
_HANGS = 0.014  # distance from the floor of the upper rack to the spray arm under it [m]


@dataclass(frozen=True)
class Racks:
    """The racks of one machine."""

    space: Space  # dimensions of the machine
    size: Size  # 60 or 45 cm wide: decides the number of wires and tines
    wire: ag.Material  # coating of the wires
    plastic: ag.Material  # plastic of grips, rollers, basket and tray
    grip: Grip  # style of the grips
    friction: ag.Scalar  # friction of a rack on its rollers [N]
    basket: bool  # whether the lower rack has a cutlery basket
    shelves: bool  # whether the upper rack has cup shelves
    upper: ag.Scalar  # height of the floor of the upper rack [m]

    @cached_property
    def _width(self) -> ag.Scalar:
        return 2.0 * (self.space.inside - _BESIDE)

    @cached_property
    def _columns(self) -> int:
        return 15 if self.size == "full" else 11

    @cached_property
    def _grip_length(self) -> float:
        return 0.125 if self.size == "full" else 0.080

    @cached_property
    def floor(self) -> ag.Scalar:
        """Height of the floor of the lower rack [m]."""
        return self.space.treads + UNDER

    @cached_property
    def rim(self) -> ag.Scalar:
        """Height of the front rim of the lower rack [m]."""
        return self.floor + FRONT_RIM

    @cached_property
    def upper_axle(self) -> ag.Scalar:
        """Height of the rollers of the upper rack [m]."""
        return self.upper + 0.052

    @cached_property
    def tray_floor(self) -> ag.Scalar:
        """Height of the floor of the cutlery tray [m]."""
        return self.space.ceiling - 0.068

    @cached_property
    def tray_axle(self) -> ag.Scalar:
        """Height of the rollers of the cutlery tray [m]."""
        return self.tray_floor + 0.016

    def _basket(self, front: float, back: float, rows: int, band: float = 0.5) -> Basket:
        def height(value: float) -> ag.Float:
            return 0.0 * self.space.width + value

        return Basket(
            self._width + 0.0 * self.space.width,
            self.space.rack_depth + 0.0 * self.space.width,
            height(front),
            height(back),
            self._columns,
            rows,
            self.wire,
            band=band,
        )

    def _wheels(
        self, axle: ag.Scalar, radius: float, places: tuple[float, ...], rise: float = 0.0
    ) -> ag.Body:
        depth = self.space.rack_depth
        return rollers(
            [(share * depth, axle) for share in places],
            x=self.space.inside - 0.0095,
            radius=radius,
            material=self.plastic,
            rise=rise,
        )

    def lower(self, name: str) -> ag.Body:
        """Make the lower rack: rows of tines for plates, rollers, and an optional cutlery basket."""
        basket = self._basket(FRONT_RIM, _BACK_RIM, 13)
        depth, space = self.space.rack_depth, self.space
        bodies = [
            basket.wires(name),
            basket.grip(
                style=self.grip, length=self._grip_length, material=self.plastic, name=f"{name}_grip"
            ),
            self._wheels(ROLLER - UNDER, ROLLER, (-0.36, 0.0, 0.36), rise=0.006),
        ]
        wide = self._width - 0.075
        room = 0.115 if self.basket else 0.0  # space for the basket, at the front
        count = 17 if self.size == "full" else 12
        start = room - 0.42 * depth
        pitch = wide / (count - 1)
        for parity, height, lean in ((0, 0.088, 0.12), (1, 0.070, 0.0)):
            rows = 2 if self.basket or parity else 3
            first, step = (0.0, start + parity * 0.088), (0.0, 0.176)
            bodies.append(basket.tines(first, step, rows, count=count, pitch=pitch, height=height, lean=lean))
        if self.basket:
            bodies.append(self._cutlery_basket(0.62 * self._width, 0.085).at(0.0, 0.055 - 0.5 * depth, 0.0))
        return ag.weld(*bodies).at(0.0, space.rack_middle, self.floor)

    def _cutlery_basket(self, wide: ag.Scalar, deep: float) -> ag.Body:
        """Make an open plastic basket with divisions and a handle over it."""
        high, low, sheet = 0.115, 0.0070, 0.0026
        half = 0.5 * wide
        walls = [
            ag.Region((-half, half), (-deep / 2, deep / 2), (low, low + sheet)).box(),
            *(
                ag.Region((-half, half), (y - sheet / 2, y + sheet / 2), (low, low + high)).box(bevel=0.001)
                for y in (-deep / 2, deep / 2)
            ),
            *(
                ag.Region((x - sheet / 2, x + sheet / 2), (-deep / 2, deep / 2), (low, low + high)).box(
                    bevel=0.001
                )
                for x in (-half, half)
            ),
            ag.Region((-half, half), (-sheet / 2, sheet / 2), (low, low + high + 0.004)).box(bevel=0.001),
        ]
        bodies = [ag.part(each, "cutlery_basket", self.plastic) for each in walls]
        hole = ag.grid(
            (0.0, 0.0, low + high / 2.0), (wide * 0.125, 0.0, 0.0), (0.0, 0.0, 0.024), columns=7, rows=4
        )
        for y in (-deep / 2 - sheet / 2, deep / 2 + sheet / 2):
            mark = ag.box(wide * 0.085, 0.0004, 0.014).at(0.0, y, 0.0)
            shade = self.plastic.with_(
                name=f"{self.plastic.name}_hole",
                base_color=tuple(0.25 * channel for channel in self.plastic.base_color),
            )
            bodies.append(ag.detail(ag.array(mark, at=hole), "cutlery_basket", shade))
        return ag.weld(*bodies)

    def upper_rack(self, name: str) -> ag.Body:
        """Make the upper rack: lower sides, finer tines, cup shelves, and the bearing of a spray arm."""
        basket = self._basket(_UPPER_RIM, _UPPER_RIM + 0.02, 12)
        depth = self.space.rack_depth
        bodies = [
            basket.wires(name),
            basket.grip(
                style=self.grip, length=self._grip_length, material=self.plastic, name=f"{name}_grip"
            ),
            self._wheels(self.upper_axle - self.upper, UPPER_ROLLER, (0.33, 0.46)),
        ]
        count = 12 if self.size == "full" else 9
        pitch, apart = 0.8 * depth / (count - 1), 0.24 * self._width
        first, step = (-0.5 * apart, 0.0), (apart, 0.0)
        bodies.append(
            basket.tines(first, step, 2, count=count, pitch=pitch, height=0.055, lean=0.15, across=False)
        )
        if self.shelves:
            bodies += self._cup_shelves(0.4 * self._width)
        hanger = ag.cylinder(0.020, _HANGS - 0.0008, axis=ag.Z, bevel=0.002).at(
            0.0, 0.0, -_HANGS / 2.0 + 0.0012
        )
        pipe = ag.Region((-0.012, 0.012), (0.0, 0.49 * depth), (-0.0085, 0.0006)).box(bevel=0.003)
        bodies += [ag.part(hanger, "rack", self.plastic), ag.part(pipe, "rack", self.plastic)]
        return ag.weld(*bodies).at(0.0, self.space.rack_middle, self.upper)

    def _cup_shelves(self, x: ag.Scalar) -> list[ag.Body]:
        """Make hinged shelves for cups at both sides, folded down."""
        along = ag.line((0.0, -0.148, 0.0), (0.0, 0.148, 0.0))
        places = ag.row((-0.044, 0.0, 0.0), (0.022, 0.0, 0.0), 5)
        across = ag.line((-0.0455, 0.0, 0.0), (0.0455, 0.0, 0.0))
        shelf = details.bent_wires(along, 0.0016, at=places)
        ends = details.bent_wires(across, 0.0021, at=((0.0, -0.147, 0.0), (0.0, 0.0, 0.0), (0.0, 0.147, 0.0)))
        wire = ag.cylinder(0.0013, 0.26, axis=ag.Y)
        bodies = []
        for side in (-1, 1):
            at = ag.vector(side * (x - 0.002), 0.02, _UPPER_RIM + 0.018)
            seen, crossing, solid = (
                each.rotate(ag.Y, side * 0.10).at(at)
                for each in (shelf, ends, ag.array(wire, at=[(way * 0.044, 0.0, 0.0) for way in (-1, 0, 1)]))
            )
            bodies += [ag.detail(each, "cup_shelf", self.wire) for each in (seen, crossing)]
            bodies.append(ag.part(solid, "cup_shelf", self.wire))
            post = ag.cylinder(0.0018, 0.022, axis=ag.Z)
            feet = [(side * (0.5 * self._width - 0.0036), y, _UPPER_RIM + 0.008) for y in (-0.11, 0.15)]
            bodies.append(ag.detail(ag.array(post, at=feet), "cup_shelf", self.wire))
        return bodies

    def tray(self, name: str) -> ag.Body:
        """Make the cutlery tray under the ceiling: a shallow wire tray with plastic ribs."""
        basket = self._basket(_TRAY, _TRAY, 9, band=0.55)
        depth = self.space.rack_depth
        bodies = [
            basket.wires(name),
            basket.grip(
                style="plate",
                length=self._grip_length,
                material=self.plastic,
                height=0.020,
                name=f"{name}_grip",
            ),
            self._wheels(self.tray_axle - self.tray_floor, UPPER_ROLLER, (0.33, 0.46)),
        ]
        for index in range(5):
            x = (index - 2) * 0.2 * self._width
            comb = ag.Region((x - 0.002, x + 0.002), (-0.44 * depth, 0.44 * depth), (0.0072, 0.026)).box(
                bevel=0.001
            )
            bodies.append(ag.part(comb, "rack", self.plastic))
        return ag.weld(*bodies).at(0.0, self.space.rack_middle, self.tray_floor)

    def slide(self, name: str, needs: ag.Condition | ag.Dependency) -> ag.Joint:
        """Make the joint of a rack, which rolls out.

        Its effort is the force of a hand, too small to push the closed door open.
        """
        return rack_slide(name, travel=self.space.slide, friction=self.friction, damping=8.0, needs=needs)

    @cached_property
    def low_ends(self) -> tuple[ag.Scalar, ag.Scalar, ag.Scalar]:
        """Return the lowest heights of the three racks with their loads [m]."""
        return (self.space.treads, self.upper - _HANGS - _BLADE - 0.0060, self.tray_floor)

    def _arm(self, name: str, reach: ag.Scalar) -> ag.Body:
        """Make a spray arm about the origin, with its upper side on z = 0."""
        grey = ag.colored("polypropylene", "grey").with_(name="spray_arm_grey")
        half: ag.Scalar = 1.0 * reach
        outline = ag.polygon(
            [
                (-half, -0.013),
                (-0.3 * half, -0.019),
                (0.3 * half, -0.019),
                (half, -0.013),
                (half, 0.013),
                (0.3 * half, 0.019),
                (-0.3 * half, 0.019),
                (-half, 0.013),
            ]
        )
        blade = ag.extrude(outline, _BLADE, axis=ag.Z, bevel=0.0016).at(0.0, 0.0, -_BLADE / 2.0)
        hub = ag.cylinder(0.024, _BLADE + 0.004, axis=ag.Z, bevel=0.002).at(0.0, 0.0, -_BLADE / 2.0 - 0.002)
        at = [
            (share * half, way * 0.006, 0.0001)
            for share, way in ((-0.9, 1), (-0.7, -1), (-0.5, 1), (0.42, -1), (0.62, 1), (0.84, -1))
        ]
        holes = ag.array(ag.cylinder(0.0034, 0.0008, axis=ag.Z), at=at)
        dark = ag.material("black_abs")
        return ag.weld(
            ag.part(blade, "spray_arm", grey, name=name),
            ag.part(hub, "spray_arm", grey),
            ag.detail(holes, "spray_arm", dark),
        )

    def lower_arm(self, name: str) -> ag.Body:
        """Make the spray arm under the lower rack, turned by a small angle at rest."""
        z = self.floor - 0.009
        arm = self._arm(name, self.space.reach_of_arms).rotate(ag.Z, 0.35)
        return arm.at(0.0, self.space.rack_middle, z)

    def post(self) -> ag.Body:
        """Make the post of the lower spray arm, which is welded to the tub."""
        top = self.floor - 0.009 - _BLADE - 0.0045
        low = self.space.floor - 0.001
        y = self.space.rack_middle
        post = ag.cylinder_between((0.0, y, low), (0.0, y, top), 0.019, bevel=0.002)
        return ag.part(post, "tub", ag.colored("polypropylene", "grey"))

    def upper_arm(self, name: str) -> ag.Body:
        """Make the spray arm under the upper rack."""
        arm = self._arm(name, 0.92 * self.space.reach_of_arms).rotate(ag.Z, -0.5)
        return arm.at(0.0, self.space.rack_middle, self.upper - _HANGS - 0.0005)

    def spin(self, name: str) -> ag.Joint:
        """Make the joint of a spray arm, which is driven by water."""
        return ag.Revolute(
            name,
            axis=ag.Z,
            pivot=(0.0, self.space.rack_middle, 0.0),
            friction=0.004,
            damping=0.002,
            effort=0.1,  # torque of jets at 0.3 bar at the ends of the arm
            driven="water",
        )
