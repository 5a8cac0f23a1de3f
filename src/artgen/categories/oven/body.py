"""The cabinet of an oven: the enameled cavity of boards, its sides and back, the part below the door."""

from dataclasses import dataclass

import artgen as ag
from artgen import details
from artgen._arrays import cached_property
from artgen.categories.oven.space import LAP, Space
from artgen.categories.shared.appliances import DARK, cord_stub, filled
from artgen.categories.shared.fixings import feet, screws

FOOT = 0.022
"""Height of the feet of a range [m]."""

LOW = 0.018
"""Distance from the feet up to the lower edge of a drawer's front [m]."""

_SHEET = 0.003  # modeled thickness of a sheet [m]
_FRAME = 0.022  # width of the enameled frame around the mouth [m]
_SLAB = 0.024  # thickness of floor and ceiling of the cavity with their wool [m]


@dataclass(frozen=True)
class Cabinet:
    """Layout and finish of a cabinet."""

    space: Space  # dimensions of the oven
    sides: ag.Material  # finish of the sides
    enamel: ag.Material  # enamel of the cavity
    wool: float  # density of the walls [kg/m3]
    bay: bool  # whether there is a bay for a drawer below; otherwise a panel closes it
    finish: ag.Material  # finish of the part below the door
    convection: bool  # whether there is a fan behind the back wall
    maker: str  # brand on the rating plate
    watts: int  # power on the rating plate [W]

    def body(self) -> ag.Body:
        """Make all fixed parts except panel, top and rails: the link `body`."""
        below = self._lower() if self.space.build == "range" else self._trim()
        return ag.weld(*self._outside(), *self._walls(), *below, *self._inside(), *self._back())

    @cached_property
    def _low(self) -> ag.Scalar:
        """Height of the underside of the cabinet [m]."""
        return FOOT if self.space.build == "range" else 0.0 * self.space.width

    @cached_property
    def _high(self) -> ag.Scalar:
        """Height of the upper side of the parts behind the panel [m]."""
        return self.space.panel_high - 0.0008

    @cached_property
    def _under(self) -> ag.Scalar:
        """Height of the underside of the cavity's floor [m]."""
        return self.space.floor - _SLAB

    @cached_property
    def _bay_top(self) -> ag.Scalar:
        """Height of the ceiling of the bay for a drawer [m]."""
        return self._under

    def _outside(self) -> list[ag.Body]:
        """Make sides, bottom, back and deck of sheet."""
        space, side = self.space, self.space.side
        front, rear = space.mouth + 0.0006, space.rear
        low, high = self._low, self._high
        sheet = filled(self.sides, 2000.0, "sheet")
        zinc = ag.material("zinc")
        bodies = [
            ag.part(ag.Region(x, (front, rear), (low, high)).box(bevel=0.0010), "body", sheet)
            for x in ((-side, _SHEET - side), (side - _SHEET, 1.0 * side))
        ]
        inner = (_SHEET - side - LAP, side - _SHEET + LAP)
        deck = ag.Region(inner, (front, rear - 0.0012), (high - 0.0020, high - 0.0004)).box()
        bottom = ag.Region(inner, (front, rear - LAP), (low + 0.0004, low + 0.0024)).box()
        back = ag.Region(inner, (rear - 0.0030, rear - 0.0008), (low + 0.0008, high - 0.0008)).box()
        bodies.append(ag.part(bottom, "body", filled(zinc, 1800.0, "sheet")))
        return [*bodies, *(ag.detail(each, "body", zinc) for each in (deck, back))]

    def _walls(self) -> list[ag.Body]:
        """Make floor, ceiling, sides and back of the cavity; their front edges frame the opening."""
        space, inside = self.space, self.space.inside
        outer, edge = space.side - _SHEET + LAP, inside + _FRAME
        front, back = space.mouth, space.back
        floor, ceiling = space.floor, space.ceiling
        stuff = filled(self.enamel, self.wool, "wall")
        tall = (floor - LAP, ceiling + LAP)
        deep = (front, back + 0.014)
        boards = [
            ag.Region((-edge, edge), deep, (self._under, floor)).box(),
            ag.Region((-edge, edge), deep, (ceiling, ceiling + _FRAME)).box(),
            ag.Region((-inside - LAP, inside + LAP), (back, deep[1] - LAP), tall).box(),
            *(
                ag.Region(x, (front, deep[1] - LAP), tall).box()
                for x in ((inside, edge - LAP), (LAP - edge, -inside))
            ),
        ]
        # posts beside the frame, and the boards above it behind the panel
        frame = filled(ag.material("powder_coat_black"), self.wool, "frame")
        behind = (front + 0.0008, deep[1] - 2.0 * LAP)
        # they carry the top of a range
        top = space.panel_high + 0.0008 if space.build == "range" else self._high - 0.0012
        posts = [
            ag.Region(x, behind, (self._under + LAP, top)).box()
            for x in ((edge - 2.0 * LAP, outer), (-outer, 2.0 * LAP - edge))
        ]
        posts.append(
            ag.Region((-edge, edge), (behind[0], behind[1] - LAP), (ceiling + _FRAME - LAP, top - LAP)).box()
        )
        return [
            *(ag.part(each, "cavity", stuff) for each in boards),
            *(ag.part(each, "body", frame) for each in posts),
        ]

    def _trim(self) -> list[ag.Body]:
        """Make the strip below the door of a built-in oven, with slots for the air."""
        space, half = self.space, self.space.half
        front, top = space.front + 0.006, space.under_door
        strip = ag.Region((-half, half), (front, front + 0.016), (0.0, top)).box(bevel=0.0020)
        behind = ag.Region(
            (-space.side, space.side), (front + 0.0155, space.mouth + 0.004), (0.0004, top - 0.002)
        ).box()
        slots = details.vent_slots(0.86 * space.width, 0.012, 26, slot=0.0090)
        vent = details.relief(slots, (0.0, front, 0.5 * top), proud=0.0003, sunk=0.0003)
        return [
            ag.part(strip, "trim", filled(self.finish, 500.0, "trim")),
            ag.part(behind, "body", filled(ag.material("powder_coat_black"), 240.0, "base")),
            ag.detail(vent, "vent", DARK),
        ]

    def _lower(self) -> list[ag.Body]:
        """Make the base of a range below the door: feet, kick plate, and a panel if there is no drawer."""
        space, half = self.space, self.space.half
        front, low = space.mouth, FOOT
        kick = ag.Region(
            (0.004 - half, half - 0.004), (front + 0.020, front + 0.030), (0.010, low + 0.015)
        ).box()
        black = ag.material("powder_coat_black")
        x, rear = half - 0.05, space.rear - 0.06
        corners = [(side * x, y) for side in (-1, 1) for y in (front + 0.07, rear)]
        bodies = [
            ag.part(kick, "kick_plate", filled(black, 900.0)),
            feet(corners, radius=0.018, height=low + 0.0004, style="pad", finish=ag.material("black_abs")),
        ]
        if not self.bay:
            face = ag.Region(
                (0.0015 - half, half - 0.0015),
                (space.front, space.front + 0.016),
                (low + LOW, space.under_door),
            ).box(bevel=0.0022)
            behind = ag.Region(  # between the sides, with an overlap
                (0.0025 - half, half - 0.0025),
                (space.front + 0.0155, front + 0.004),
                (low + LOW + 0.002, space.under_door - 0.002),
            ).box()
            bodies.append(ag.part(face, "kick_plate", filled(self.finish, 300.0, "front")))
            bodies.append(ag.part(behind, "body", filled(ag.material("powder_coat_black"), 120.0, "base")))
        return bodies

    def _inside(self) -> list[ag.Body]:
        """Make gasket, lamp, fan cover and embossed walls, visual only."""
        space = self.space
        floor, ceiling, back, inside = space.floor, space.ceiling, space.back, space.inside
        tall, level = ceiling - floor, (ceiling + floor) / 2.0
        gasket = details.gasket(
            2.0 * inside + 0.022, tall + 0.022, size=0.0056, radius=0.016, section="half_round"
        ).at(0.0, space.mouth + 0.0002, level)
        rubber = ag.material("rubber").with_(name="glass_fibre_seal", base_color=(0.16, 0.155, 0.15))
        bodies = [ag.detail(gasket, "seal", rubber)]
        field = ag.rectangle(1.72 * inside, 0.80 * tall, radius=0.02)
        rib = details.relief(
            field - field.offset(-0.006), (0.0, back, level), proud=0.0024, sunk=0.0004, bevel=0.0018
        )
        bodies.append(ag.detail(rib, "cavity", self.enamel))
        lens = ag.cylinder(0.026, 0.012, axis=ag.Y, bevel=0.003).at(
            -0.62 * inside, back - 0.004, ceiling - 0.25 * tall
        )
        collar = details.relief(
            ag.ring(0.031, 0.024), (-0.62 * inside, back, ceiling - 0.25 * tall), proud=0.004
        )
        bodies += [
            ag.detail(lens, "light", ag.material("bulb").with_(name="oven_lamp")),
            ag.detail(collar, "light", ag.material("stainless")),
        ]
        if self.convection:
            radius = 0.105
            cover = details.relief(ag.circle(radius), (0.0, back, level), proud=0.010, bevel=0.006)
            petals = details.perforation(ag.circle(0.062), 0.0155, 0.0052)
            holes = details.relief(petals, (0.0, back - 0.010, level), proud=0.0002)
            slots = details.relief(
                details.vent_slots(0.055, 0.026, 3, slot=0.0046, direction="horizontal"),
                (0.0, back, 0.0),
                proud=0.0002,
                sunk=0.0002,
            )
            at = [(x * 0.155, 0.0, level + z * 0.30 * tall) for x in (-1, 1) for z in (-1, 1)]
            bodies += [
                ag.detail(cover, "fan_cover", self.enamel),
                ag.detail(holes, "fan_cover", DARK),
                ag.detail(ag.array(slots, at=at), "fan_cover", DARK),
                *screws(
                    [(x * 0.078, back - 0.010, level + z * 0.040) for x in (-1, 1) for z in (-1, 1)],
                    facing="-y",
                    radius=0.0035,
                    finish=ag.material("stainless"),
                    head="pan",
                ),
            ]
        return bodies

    def _back(self) -> list[ag.Body]:
        """Make vents, screws, rating plate and the cord."""
        space, side = self.space, self.space.side
        plane = space.rear - 0.0008
        low, high = self._low, self._high
        tall = high - low
        backward = (0.0, 1.0, 0.0)
        upper = details.relief(
            details.vent_slots(0.30, 0.045, 5, slot=0.0045, direction="horizontal"),
            (0.0, plane, high - 0.07),
            facing=backward,
            proud=0.0002,
        )
        lower = details.relief(
            details.vent_slots(0.16, 0.060, 12, slot=0.0045),
            (0.12, plane, low + 0.22 * tall),
            facing=backward,
            proud=0.0002,
        )
        box_cover = details.relief(
            ag.rectangle(0.30, 0.30, radius=0.02),
            (0.0, plane, low + 0.58 * tall),
            facing=backward,
            proud=0.008,
            bevel=0.005,
        )
        heads: list[tuple[ag.Scalar, ag.Scalar, ag.Scalar]] = [
            (x, plane, z)
            for x in (0.014 - side, side - 0.014)
            for z in (low + 0.03, low + 0.5 * tall, high - 0.02)
        ]
        lines = (f"{self.maker.upper()} F{self.watts // 10}", f"230 V~ 50/60 Hz {self.watts} W")
        plate = details.rating_plate(
            0.080, 0.042, lines, at=(-0.12, plane, low + 0.22 * tall), facing=backward, double_insulated=False
        )
        zinc = ag.material("zinc")
        outlet = low + 0.10 * tall + 0.03
        return [
            ag.detail(upper, "vent", DARK),
            ag.detail(lower, "vent", DARK),
            ag.detail(box_cover, "body", zinc),
            *screws(heads, facing="+y", radius=0.0036, finish=zinc, head="pan"),
            plate,
            cord_stub(height=outlet, reach=0.040, radius=0.0045).at(0.6 * side, plane, outlet),
        ]
