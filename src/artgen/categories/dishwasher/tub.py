"""The cabinet of a dishwasher: the tub as a cavity of boards, with sides, base, top and back."""

from dataclasses import dataclass

import artgen as ag
from artgen import details
from artgen._arrays import cached_property
from artgen.categories.dishwasher.space import Build, Space
from artgen.categories.shared.appliances import DARK, cord_stub, filled

_PITCH = 0.006  # pitch of the ribs of a drain hose [m]
_RIBS = 3


def drain_hose(
    path: list[ag.VectorLike],
    *,
    radius: ag.Scalar = 0.0105,
    finish: ag.Material | None = None,
    label: str = "hose",
) -> ag.Body:
    """Make a corrugated hose from the origin through points."""
    grey = finish or ag.colored("polypropylene", "grey")
    hose = ag.sweep(ag.circle(radius), ag.polyline([(0.0, -0.004, 0.0), *path], fillet=1.8 * radius))
    rib = ag.cylinder(radius + 0.0012, 0.0035, axis=ag.Y, bevel=0.001)
    ribs = ag.array(rib, at=[(0.0, 0.004 + _PITCH * index, 0.0) for index in range(_RIBS)])
    collar = ag.cylinder(1.45 * radius, 0.004, axis=ag.Y, bevel=0.001).at(0.0, 0.001, 0.0)
    return ag.weld(*(ag.detail(each, label, grey) for each in (hose, collar, ribs)))


def inlet_hose(
    path: list[ag.VectorLike],
    *,
    radius: ag.Scalar = 0.007,
    finish: ag.Material | None = None,
    label: str = "hose",
) -> ag.Body:
    """Make a smooth pressure hose with the hexagon nut of its valve, from the origin through points."""
    grey = finish or ag.colored("abs", "light_grey")
    hose = ag.sweep(ag.circle(radius), ag.polyline([(0.0, 0.006, 0.0), *path], fillet=2.0 * radius))
    nut: ag.Solid = ag.extrude(ag.regular_polygon(6, 2.0 * radius), 0.014, axis=ag.Y, bevel=0.001).at(
        0.0, 0.007, 0.0
    )
    blue = ag.colored("abs", "sky")
    return ag.weld(ag.detail(hose, label, grey), ag.detail(nut, label, blue))


_SHEET = 0.004  # modeled thickness of the sheet of side panels [m]
_FEET = 0.022  # height of the base above the floor [m]
_RAIL = 0.0012  # play of rollers in their rails [m]
_BACK = 0.030  # depth of the recess for hoses at the back [m]
_SERVICES = 0.26  # height of this recess [m]


@dataclass(frozen=True)
class Cabinet:
    """Dimensions and finish of a cabinet."""

    space: Space  # dimensions of the machine
    build: Build  # built-in or freestanding
    worktop: bool  # whether it has a worktop
    sides: ag.Material  # finish of the sides and the top
    tub: ag.Material  # finish of the tub's inside
    kick: ag.Material  # finish of the kick plate
    worktop_finish: ag.Material  # finish of the worktop
    base_density: float  # density of the base with pump, motor and ballast [kg/m3]
    levels: tuple[
        ag.Scalar, ...
    ]  # heights of the axles of the upper racks, which roll in rails on the walls [m]
    maker: str  # brand on the rating plate

    def body(self) -> ag.Body:
        """Make all fixed parts: the link `body`."""
        return ag.weld(
            *self._base(),
            *self._walls(),
            *self._sides(),
            *self._top(),
            *self._rails(),
            *self._inside(),
            *self._back(),
        )

    @cached_property
    def _half(self) -> ag.Scalar:
        return self.space.width / 2.0

    @cached_property
    def _rear(self) -> ag.Scalar:
        return self.space.depth / 2.0

    def _base(self) -> list[ag.Body]:
        space = self.space
        half, low = self._half, _FEET
        front = space.mouth + 0.034
        under = space.floor - 0.014
        pan = ag.Region((0.004 - half, half - 0.004), (front, self._rear - _BACK - 0.002), (low, under)).box(
            bevel=0.004
        )
        ballast = filled(ag.material("black_abs"), self.base_density, "base")
        top = space.door_bottom - 0.004
        kick = ag.Region(
            (0.001 - half, half - 0.001), (front - 0.0125, front + 0.001), (0.012, top + 0.02)
        ).box(bevel=0.002)
        y = (front + 0.045, self._rear - _BACK - 0.05)
        corners = [(side * (half - 0.045), each, 0.0) for side in (-1, 1) for each in y]
        disc = ag.cylinder(0.019, 0.008, axis=ag.Z, bevel=0.0015).at(0.0, 0.0, 0.004)
        stem = ag.cylinder(0.007, low, axis=ag.Z).at(0.0, 0.0, low / 2.0 + 0.002)
        black = ag.material("black_abs")
        feet = ag.weld(
            ag.part(ag.array(disc, at=corners), "foot", black, separate="each foot is screwed into the base"),
            ag.part(ag.array(stem, at=corners), "foot", ag.material("zinc")),
        )
        slots = details.vent_slots(0.24, 0.012, 14, slot=0.0036)
        vent = details.relief(
            slots, (0.0, front - 0.0125, 0.045), proud=0.0003, sunk=0.0003
        )  # vents of the base
        return [
            ag.part(pan, "body", ballast),
            ag.part(kick, "kick_plate", filled(self.kick, 900.0)),
            ag.detail(vent, "kick_plate", DARK),
            feet,
        ]

    def _walls(self) -> list[ag.Body]:
        """Make floor, ceiling, sides and back of the tub; their front edges frame the opening."""
        space = self.space
        wide, outer = space.inside, self._half - _SHEET
        low, high = space.floor, space.ceiling
        front, back = space.mouth, space.back
        stuff = filled(self.tub, 190.0, "tub")
        boards = [
            ag.Region((-outer, outer), (front, self._rear - _BACK), (low - 0.016, low)).box(),
            ag.Region((-outer, outer), (front, self._rear - 0.002), (high, high + 0.016)).box(),
            ag.Region((-outer, outer), (back, back + 0.012), (low - 0.001, high + 0.001)).box(),
            *(
                ag.Region(
                    (side * wide, side * outer) if side > 0 else (-outer, -wide),
                    (front, back + 0.001),
                    (low - 0.001, high + 0.001),
                ).box()
                for side in (-1, 1)
            ),
        ]
        gasket = details.gasket(
            2.0 * wide + 0.020, high - low + 0.014 - 0.008, size=0.0062, radius=0.016, section="half_round"
        ).at(0.0, front + 0.0002, (low + high) / 2.0 + 0.003)
        return [
            *(ag.part(each, "tub", stuff) for each in boards),
            ag.detail(gasket, "seal", ag.material("rubber")),
        ]

    def _sides(self) -> list[ag.Body]:
        """Make the outer panels: painted ones, or galvanized frames around the insulated tub."""
        space, half = self.space, self._half
        bodies: list[ag.Body] = []
        front, rear = space.mouth + 0.0006, self._rear
        top = space.height - (0.032 if self.worktop else 0.002)
        bottom = 0.026
        density = 2400.0
        sheet = filled(self.sides, density, "sheet")
        for side in (-1, 1):
            x = (side * (half - _SHEET), side * half) if side > 0 else (-half, _SHEET - half)
            low = space.floor - 0.014
            bodies.append(ag.part(ag.Region(x, (front, rear), (low, top)).box(bevel=0.0012), "body", sheet))
            deep = (space.mouth + 0.030, rear - 0.002)
            bodies.append(ag.part(ag.Region(x, deep, (bottom, low + 0.001)).box(), "body", sheet))
            if self.build == "built_in":
                bodies += self._felt(side, top)
        return bodies

    def _felt(self, side: int, top: ag.Scalar) -> list[ag.Body]:
        """Make the visible insulation between the posts of a built-in machine."""
        space = self.space
        low = space.floor + 0.02
        tall, long = top - low - 0.03, self._rear - space.mouth - 0.11
        sheet = ag.rectangle(long, tall, radius=0.012)
        at = (side * self._half, space.mouth + 0.045 + long / 2.0, low + tall / 2.0)
        felt = ag.colored("fabric", "graphite").with_(name="bitumen_felt")
        pad = details.relief(sheet, at, facing=(side, 0.0, 0.0), proud=0.0006, sunk=0.0006)
        return [ag.detail(pad, "insulation", felt)]

    def _top(self) -> list[ag.Body]:
        space, half = self.space, self._half
        low = space.ceiling + 0.016
        if self.worktop:
            plate = ag.Region(
                (-half, half), (space.front + 0.004, self._rear), (space.height - 0.030, space.height)
            ).box(bevel=0.005)
            return [
                ag.part(
                    ag.Region(
                        (0.002 - half, half - 0.002), (space.mouth, self._rear), (low, space.height - 0.029)
                    ).box(),
                    "body",
                    filled(self.sides, 300.0, "deck"),
                ),
                ag.part(plate, "worktop", filled(self.worktop_finish, 620.0, "top")),
            ]
        deck = ag.Region(
            (_SHEET - half, half - _SHEET), (space.mouth, self._rear), (low - 0.001, space.height)
        ).box()
        return [ag.part(deck, "body", filled(self.sides, 300.0, "deck"))]

    def _rails(self) -> list[ag.Body]:
        """Make the ledges of the lower rack, and the channels of the upper racks."""
        space = self.space
        bodies: list[ag.Body] = []
        front, back = space.mouth + 0.004, space.back - 0.006
        grey = ag.colored("polypropylene", "light_grey").with_(name="rail_plastic")
        steel = ag.material("stainless")
        for side in (-1, 1):
            x = (space.inside - 0.017, space.inside + 0.001)
            if side < 0:
                x = (-space.inside - 0.001, 0.017 - space.inside)
            top = space.treads - _RAIL
            bodies.append(
                ag.part(ag.Region(x, (front, back), (top - 0.008, top)).box(bevel=0.002), "rail", grey)
            )
            for level in self.levels:
                apart = 0.0095 + _RAIL
                for way in (-1, 1):
                    z = level + way * (apart + 0.002)
                    strip = ag.Region(x, (front, back), (z - 0.002, z + 0.002)).box(bevel=0.0008)
                    bodies.append(ag.part(strip, "rail", steel))
        return bodies

    def _inside(self) -> list[ag.Body]:
        """Make sump, filter, feed pipe and embossed walls, visual only."""
        space = self.space
        middle, low = space.rack_middle, space.floor
        steel = ag.material("stainless")
        sump = ag.cylinder(0.085, 0.003, axis=ag.Z, bevel=0.001).at(0.0, middle - 0.075, low + 0.0006)
        mesh = ag.cylinder(0.078, 0.0012, axis=ag.Z).at(0.0, middle - 0.075, low + 0.0022)
        cup = ag.cylinder(0.034, 0.014, axis=ag.Z, bevel=0.003).at(0.0, middle - 0.105, low + 0.006)
        bar = ag.box(0.012, 0.056, 0.006, bevel=0.002).at(0.0, middle - 0.105, low + 0.0145)
        grey = ag.colored("polypropylene", "grey")
        bodies = [
            ag.detail(sump, "filter", steel),
            ag.detail(mesh, "filter", ag.material("perforated_steel")),
            ag.detail(cup, "filter", grey),
            ag.detail(bar, "filter", ag.colored("polypropylene", "blue")),
        ]
        pipe = ag.Region(
            (-0.016, 0.016), (space.back - 0.009, space.back + 0.001), (low, space.ceiling - 0.06)
        ).box()
        bodies.append(ag.detail(pipe, "tub", grey))
        rib = ag.box(0.006, 0.004, 0.55 * (space.ceiling - low), bevel=0.0019)  # ribs stiffen the sheet
        at: list[ag.VectorLike] = [
            (share * space.inside, space.back, (low + space.ceiling) / 2.0)
            for share in (-0.68, -0.42, 0.42, 0.68)
        ]
        bodies.append(ag.detail(ag.array(rib, at=at), "tub", self.tub))
        nozzle = ag.cylinder(0.028, 0.008, axis=ag.Z, bevel=0.002).at(0.0, middle, space.ceiling - 0.003)
        return [*bodies, ag.detail(nozzle, "tub", grey)]

    def _back(self) -> list[ag.Body]:
        """Make the back panel above the recess, and the connections for water and mains in the recess."""
        space, half, rear = self.space, self._half, self._rear
        zinc = filled(ag.material("zinc"), 700.0, "sheet")
        panel = ag.Region(
            (_SHEET - half, half - _SHEET),
            (space.back + 0.011, rear - 0.003),
            (_SERVICES, space.ceiling + 0.002),
        ).box()
        wall = ag.Region(
            (_SHEET - half, half - _SHEET),
            (rear - _BACK - 0.004, rear - _BACK),
            (_FEET + 0.004, _SERVICES + 0.001),
        ).box()
        plane = rear - _BACK
        low = 0.08
        side = half - 0.10
        plate = details.rating_plate(
            0.085,
            0.045,
            (self.maker, "230 V~ 1900 W"),
            at=(0.0, rear - 0.003, 0.55),
            facing=(0.0, 1.0, 0.0),
            double_insulated=False,
        )
        return [
            ag.part(panel, "body", zinc),
            ag.part(wall, "body", zinc),
            drain_hose([(0.0, 0.016, 0.0), (0.05, 0.016, -0.01), (0.06, 0.016, 0.14)], radius=0.009).at(
                -side, plane, low
            ),
            inlet_hose([(0.0, 0.021, 0.0), (-0.06, 0.021, 0.0), (-0.07, 0.021, 0.16)], radius=0.0055).at(
                side, plane, low
            ),
            cord_stub(height=0.16, reach=0.026).at(0.0, plane, 0.16),
            plate,
        ]


def kick_finish(front: ag.Material, build: Build) -> ag.Material:
    """Return the finish of the kick plate: that of the front, or black behind a kitchen plinth."""
    return ag.material("powder_coat_black") if build == "built_in" else front
