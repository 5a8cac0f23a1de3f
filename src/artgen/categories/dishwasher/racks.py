"""Interior of a dishwasher: racks with their fittings, and spray arms."""

from typing import Literal

import artgen as ag
from artgen import details, feel
from artgen.categories.dishwasher.tub import AXLES, FRONT_RIM, UNDER, Plan
from artgen.categories.shared.baskets import GRIP_REACH, Basket, Grip, rollers

Size = Literal["full", "slim"]
"""Width of the machine: 60 or 45 cm."""

_ROLLERS = (0.0155, 0.0095)  # radii of the rollers of the lower rack, and of the upper racks [m]
_UPPER_RIM = 0.085  # height of the front of the upper rack [m]
_BLADE = 0.011  # thickness of a spray arm [m]
_HANGS = 0.014  # distance from the floor of the upper rack to the spray arm under it [m]
# torque of jets at 0.3 bar at the ends of the arm
_JETS = feel.Feel(friction=0.004, damping=0.002, effort=0.1)


class Racks:
    """The racks and spray arms of one machine, with their wires, plastic and grips."""

    def __init__(self, plan: Plan, size: Size, wire: ag.Material, plastic: ag.Material, grip: Grip) -> None:
        self.plan, self.full = plan, size == "full"
        self.wire, self.plastic, self.grip = wire, plastic, grip
        self.width, self.depth, _ = plan.racks.size

    def make(self, number: int, *, cutlery: bool, shelves: bool) -> ag.Body:
        """Make a rack: 0 is the lower one, 1 the upper one, and 2 the tray for cutlery."""
        name = f"rack_{number}"
        match number:
            case 0:
                body = self._lower(name, cutlery=cutlery)
            case 1:
                body = self._upper(name, shelves=shelves)
            case _:
                body = self._tray(name)
        return body.at(0, self.plan.racks.y.mid, self.plan.floors[number])

    def clear_angle(self, number: int) -> ag.Scalar:
        """Return the angle of the open door that clears the path of a rack with its load [rad]."""
        plan = self.plan
        lows = (plan.treads, plan.floors[1] - _HANGS - _BLADE - 0.0060, plan.floors[2])
        return plan.clear_angle(lows[number], GRIP_REACH if number else 0.0)

    def _basket(self, front: float, back: float, rows: int, band: float = 0.5) -> Basket:
        zero = 0.0 * self.plan.swing
        sizes = (zero + self.width, zero + self.depth, zero + front, zero + back)
        return Basket(*sizes, 15 if self.full else 11, rows, self.wire, band=band)

    def _grip(self, basket: Basket, name: str, style: Grip, height: float | None = None) -> ag.Body:
        length = 0.125 if self.full else 0.080
        return basket.grip(
            style=style, length=length, material=self.plastic, height=height, name=f"{name}_grip"
        )

    def _wheels(self, axle: float, radius: float, *shares: float, rise: float = 0.0) -> ag.Body:
        """Make rollers at shares of the depth."""
        x, at = self.plan.tub.x.high - 0.0095, [(share * self.depth, axle) for share in shares]
        return rollers(at, x=x, radius=radius, material=self.plastic, rise=rise)

    def _lower(self, name: str, *, cutlery: bool) -> ag.Body:
        """Make the lower rack: rows of tines for plates, rollers, and an optional cutlery basket."""
        basket = self._basket(FRONT_RIM, 0.135, 13)
        large = _ROLLERS[0]
        bodies = [
            basket.wires(name),
            self._grip(basket, name, self.grip),
            self._wheels(large - UNDER, large, -0.36, 0.0, 0.36, rise=0.006),
        ]
        count = 17 if self.full else 12
        pitch = (self.width - 0.075) / (count - 1)
        start = (0.115 if cutlery else 0) - 0.42 * self.depth  # the basket is at the front
        for parity, height, lean in ((0, 0.088, 0.12), (1, 0.070, 0.0)):
            rows, first = 2 if cutlery or parity else 3, (0, start + parity * 0.088)
            bodies.append(
                basket.tines(first, (0, 0.176), rows, count=count, pitch=pitch, height=height, lean=lean)
            )
        if cutlery:
            bodies.append(self._cutlery_basket().at(y=0.055 - self.depth / 2))
        return ag.weld(*bodies)

    def _cutlery_basket(self) -> ag.Body:
        """Make an open plastic basket with divisions and a handle over it."""
        wide, deep, sheet = 0.62 * self.width, 0.085, 0.0026
        room = ag.Region.centered(wide, deep, 0.115).at(z=0.0645)
        outer = room.grow(x=sheet / 2, y=sheet / 2)
        floor = room.with_(z=(room.z.low, room.z.low + sheet))
        walls = [
            *outer.shrink(x=sheet / 2).deep(sheet, None, sheet)[::2],
            *outer.shrink(y=sheet / 2).across(sheet, None, sheet)[::2],
            room.grow(top=0.004).with_(y=(-sheet / 2, sheet / 2)),
        ]
        solids = [floor.box(), *(each.box(bevel=0.001) for each in walls)]
        hole = ag.box(wide * 0.085, 0.0004, 0.014)
        around = (wide * 0.125, 0, 0), (0, 0, 0.024)
        holes = [ag.array(hole, at=ag.grid((0, y, room.z.mid), *around, columns=7, rows=4)) for y in outer.y]
        color = tuple(0.25 * channel for channel in self.plastic.base_color)
        shade = self.plastic.with_(name=f"{self.plastic.name}_hole", base_color=color)
        return ag.weld(
            ag.part(solids, "cutlery_basket", self.plastic), ag.detail(holes, "cutlery_basket", shade)
        )

    def _upper(self, name: str, *, shelves: bool) -> ag.Body:
        """Make the upper rack: lower sides, finer tines, cup shelves, and the bearing of a spray arm."""
        basket = self._basket(_UPPER_RIM, _UPPER_RIM + 0.02, 12)
        count, apart = 12 if self.full else 9, 0.24 * self.width
        pitch = 0.8 * self.depth / (count - 1)
        hanger = ag.cylinder(0.020, _HANGS - 0.0008, bevel=0.0012).at(z=0.0012 - _HANGS / 2)
        pipe = ag.Region((-0.012, 0.012), (0, 0.49 * self.depth), (-0.0085, 0.0006)).box(bevel=0.003)
        return ag.weld(
            basket.wires(name),
            self._grip(basket, name, self.grip),
            self._wheels(AXLES[0], _ROLLERS[1], 0.33, 0.46),
            basket.tines(
                (-apart / 2, 0),
                (apart, 0),
                2,
                count=count,
                pitch=pitch,
                height=0.055,
                lean=0.15,
                across=False,
            ),
            *(self._cup_shelves() if shelves else []),
            ag.part([hanger, pipe], "rack", self.plastic),
        )

    def _cup_shelves(self) -> list[ag.Body]:
        """Make hinged shelves for cups at both sides, folded down."""
        along, across = (ag.line(axis * -half, axis * half) for axis, half in ((ag.Y, 0.148), (ag.X, 0.0455)))
        wires = details.bent_wires(along, 0.0016, at=ag.row((-0.044, 0, 0), (0.022, 0, 0), 5))
        ends = details.bent_wires(across, 0.0021, at=ag.row((0, -0.147, 0), (0, 0.147, 0), 3))
        straight = ag.array(ag.cylinder(0.0013, 0.26, axis=ag.Y), at=ag.row((-0.044, 0, 0), (0.044, 0, 0), 3))
        post, solids, seen = ag.cylinder(0.0018, 0.022), [], []
        for side in (-1, 1):
            at = ag.vector(side * (0.4 * self.width - 0.002), 0.02, _UPPER_RIM + 0.018)
            *folded, solid = (each.rotate(ag.Y, side * 0.10).at(at) for each in (wires, ends, straight))
            x, z = side * (self.width / 2 - 0.0036), _UPPER_RIM + 0.008
            seen += [*folded, ag.array(post, at=[(x, -0.11, z), (x, 0.15, z)])]
            solids.append(solid)
        return [ag.detail(seen, "cup_shelf", self.wire), ag.part(solids, "cup_shelf", self.wire)]

    def _tray(self, name: str) -> ag.Body:
        """Make the cutlery tray under the ceiling: a shallow wire tray with plastic ribs."""
        basket = self._basket(0.036, 0.036, 9, band=0.55)
        rib = ag.Region((-0.002, 0.002), (-0.44 * self.depth, 0.44 * self.depth), (0.0072, 0.026))
        ribs = [rib.at(share * self.width).box(bevel=0.001) for share in (-0.4, -0.2, 0.0, 0.2, 0.4)]
        return ag.weld(
            basket.wires(name),
            self._grip(basket, name, "plate", height=0.020),
            self._wheels(AXLES[1], _ROLLERS[1], 0.33, 0.46),
            ag.part(ribs, "rack", self.plastic),
        )

    def with_arm(self, body: ag.Body, number: int) -> ag.Body:
        """Attach the spray arm over the floor of the tub (0), or under the upper rack (1), to its bearing."""
        plan = self.plan
        reach = ag.min_(plan.tub.x.high - 0.040, plan.tub.y.size / 2 - 0.030)
        lower, upper = plan.floors[0] - 0.009, plan.floors[1] - _HANGS - 0.0005
        half, turn, top = ((reach, 0.35, lower), (0.92 * reach, -0.5, upper))[number]
        arm = _spray_arm(f"spray_arm_{number}", half).rotate(ag.Z, turn).at(z=top)
        spin = ag.Revolute(f"spray_arm_spin_{number}", axis=ag.Z, feel=_JETS, driven="water")
        return body.attach(arm, spin, at=(0, plan.racks.y.mid, 0))


def _spray_arm(name: str, half: ag.Scalar) -> ag.Body:
    """Make a spray arm of some half length about the origin, with its upper side on z = 0."""
    grey = ag.colored("polypropylene", "grey").with_(name="spray_arm_grey")
    side = [(-half, -0.013), (-0.3 * half, -0.019), (0.3 * half, -0.019), (half, -0.013)]
    outline = ag.polygon([*side, *((-x, -y) for x, y in side)])
    blade = ag.extrude(outline, _BLADE, bevel=0.0016).at(z=-_BLADE / 2)
    hub = ag.cylinder(0.024, _BLADE + 0.004, bevel=0.002).at(z=-_BLADE / 2 - 0.002)
    jets = ((-0.9, 1), (-0.7, -1), (-0.5, 1), (0.42, -1), (0.62, 1), (0.84, -1))
    holes = ag.array(
        ag.cylinder(0.0034, 0.0008), at=[(share * half, way * 0.006, 0.0001) for share, way in jets]
    )
    return ag.weld(
        ag.part([blade, hub], "spray_arm", grey, name=name),
        ag.detail(holes, "spray_arm", ag.material("black_abs")),
    )
