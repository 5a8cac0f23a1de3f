"""The case of a microwave oven: cavity, sheet, back, turntable and roller ring."""

import math
from dataclasses import dataclass

import artgen as ag
from artgen import details
from artgen._arrays import cached_property
from artgen.categories.microwave.space import FRAME, SHAFT, SHEET, Space
from artgen.categories.shared.appliances import DARK, filled, mains_cord
from artgen.categories.shared.fixings import feet, screws

_LAP = 0.0005  # overlap of boards, so that they share no corners [m]
_WALL = 0.0035  # thickness of the cavity's right wall [m]
_BEFORE = 0.045  # distance between the space of the latches and the electronics [m]
_WORKS = 0.18  # depth of the electronics in all but the smallest ovens [m]
_OPEN = (0.0050, 0.0042)  # distances from the middle of a latch to the left and right sides of its slot [m]
_MICA = ag.colored("fabric", "sand").with_(name="mica", texture="", tile=None, specular_roughness=0.35)


@dataclass(frozen=True)
class Case:
    """Layout and finish of a case."""

    space: Space  # dimensions of the oven
    finish: ag.Material  # finish of the outer sheet
    inside: ag.Material  # finish of the cavity
    stuffing: float  # density of its walls with transformer, magnetron and fan [kg/m3]
    slots: tuple[ag.Span, ...]  # heights of the slots of the latches, their lower and upper edges [m]
    vents: str  # side of the air inlet: `left` or `right`
    maker: str  # brand on the rating plate
    watts: int  # power on the rating plate [W]

    def body(self) -> ag.Body:
        """Make all fixed parts except the control panel: the link `body`."""
        return ag.weld(*self._sheets(), *self._walls(), *self._inside(), *self._vents(), *self._back())

    @cached_property
    def _outer(self) -> ag.Span:
        """Return the outline at which the cavity's boards end: the middle of the sheet."""
        return (_LAP + SHEET / 2.0 - self.space.half, self.space.half - SHEET / 2.0 - _LAP)

    def _walls(self) -> list[ag.Body]:
        """Make floor, ceiling, sides and back of the cavity, and the frame with the slots of the latches."""
        space = self.space
        left, right = space.across
        floor, ceiling = space.floor, space.ceiling
        low, high = space.foot + 0.0004, space.height - SHEET / 2.0
        outer, front, rear = self._outer, space.mouth, space.rear - 0.0012
        wall = (floor - _LAP, ceiling + _LAP)
        deep = front + SHAFT
        passing = right + _WALL
        rest = space.split - 0.0045  # the frame ends behind the panel
        seen = filled(self.inside, 265.0, "wall")
        heavy = filled(self.inside, self.stuffing, "works")
        shallow = (front, rear)
        slabs = [  # the floor with the motor of the turntable, and the ceiling
            ag.part(
                ag.Region(outer, shallow, (low, floor)).box(), "cavity", filled(self.inside, 300.0, "floor")
            ),
            ag.part(
                ag.Region(outer, shallow, (ceiling, high)).box(),
                "cavity",
                filled(self.inside, 210.0, "ceiling"),
            ),
        ]
        boards = [
            ag.Region((outer[0], left), (front, rear - _LAP), wall).box(),
            ag.Region((left - _LAP, right + _LAP), (space.back, rear - _LAP), wall).box(),
            ag.Region((right, passing), (front, rear - _LAP), wall).box(),
        ]
        # the transformer and the fan are at the back; in front of them are the latches and the boards of the
        # keys
        heavy_from = ag.max_(deep + _BEFORE, rear - _WORKS)
        works = ag.Region((passing - _LAP, outer[1]), (heavy_from, rear - 2.0 * _LAP), wall).box()
        light = ag.Region((rest, outer[1]), (front, heavy_from + _LAP), wall).box()
        strip = (passing - _LAP, rest + _LAP)
        edges = [wall[0], *(edge for slot in self.slots for edge in slot), wall[1]]
        frame = [
            ag.Region(strip, (front, front + FRAME), (edges[index], edges[index + 1])).box()
            for index in range(0, len(edges), 2)
        ]
        beside = []  # the visible slots are narrower than the gaps of the colliding frame
        for bottom, top in self.slots:
            level = (bottom - _LAP, top + _LAP)
            thin = (front + _LAP, front + FRAME - _LAP)
            hook = space.hook
            beside.append(ag.Region((passing - 2.0 * _LAP, hook - _OPEN[0]), thin, level).box())
            beside.append(ag.Region((hook + _OPEN[1], rest + 2.0 * _LAP), thin, level).box())
        return [
            *(ag.detail(each, "cavity", self.inside) for each in beside),
            *slabs,
            *(ag.part(each, "cavity", seen) for each in (*boards, *frame)),
            ag.part(works, "cavity", heavy),
            ag.part(light, "cavity", filled(self.inside, 120.0, "keys")),
        ]

    def _sheets(self) -> list[ag.Body]:
        """Make the wrapper over top and sides, the bottom, the back and the feet."""
        space, half = self.space, self.space.half
        low, high = space.foot, space.height
        sheet = filled(self.finish, 2000.0, "sheet")
        zinc = ag.material("zinc")
        front, rear = space.mouth - 0.0016, space.rear
        sides = [
            ag.Region(x, (front, rear), (low, high - 0.0006)).box(bevel=0.0010)
            for x in ((-half, SHEET - half), (half - SHEET, 1.0 * half))
        ]
        top = ag.Region((0.0006 - half, half - 0.0006), (front, rear), (high - SHEET, high)).box(bevel=0.0010)
        wide = (0.001 - half, half - 0.001)
        bottom = ag.Region(wide, (front + 0.006, rear - 0.0006), (low, low + SHEET)).box()
        back = ag.Region(wide, (rear - SHEET, rear - 0.0008), (low + 0.0008, high - 0.0012)).box()
        x = half - 0.040
        corners = [(side * x, y) for side in (-1, 1) for y in (space.mouth + 0.035, rear - 0.035)]
        return [
            *(ag.part(each, "body", sheet) for each in (*sides, top)),
            *(ag.detail(each, "body", zinc) for each in (bottom, back)),  # around the boards of the cavity
            feet(corners, radius=0.011, height=space.foot),
        ]

    def _inside(self) -> list[ag.Body]:
        """Make the visible parts of the cavity: the cover of the wave guide, the lamp, the air holes."""
        space = self.space
        left, right = space.across
        front, back = space.mouth, space.back
        floor, ceiling = space.floor, space.ceiling
        tall, deep = ceiling - floor, back - front
        inward = (-1.0, 0.0, 0.0)
        mica = details.relief(
            ag.rectangle(0.30 * deep, 0.45 * tall, radius=0.006),
            (right, front + 0.56 * deep, floor + 0.55 * tall),
            facing=inward,
            proud=0.0012,
            sunk=0.0006,
        )
        holes = details.perforation(ag.rectangle(0.050, 0.034), 0.0074, 0.0025, margin=0.001)
        outlets = details.vent_slots(0.050, 0.034, 5, slot=0.0040)
        lamp = details.relief(
            ag.rectangle(0.036, 0.022, radius=0.003),
            (right, front + 0.22 * deep, ceiling - 0.30 * tall),
            facing=inward,
            proud=0.0001,
            sunk=0.0006,
        )
        grille = details.relief(
            holes, (right, front + 0.22 * deep, ceiling - 0.30 * tall), facing=inward, proud=0.0002
        )
        outlet = details.relief(
            outlets, (left, front + 0.72 * deep, ceiling - 0.24 * tall), facing=(1.0, 0.0, 0.0), proud=0.0002
        )
        # a pressed edge stiffens the back wall
        rim = ag.rectangle(right - left - 0.03, tall - 0.03, radius=0.02)
        rib = details.relief(
            rim - rim.offset(-0.005),
            ((left + right) / 2.0, back, floor + tall / 2.0),
            proud=0.0016,
            bevel=0.0008,
        )
        frame = ag.rectangle(right - left + 0.004, tall + 0.004, radius=0.006)
        seam = details.relief(
            frame - frame.offset(-0.002),
            ((left + right) / 2.0, front, floor + tall / 2.0),
            proud=0.0002,
            sunk=0.0006,
        )
        glow = ag.material("bulb").with_(name="oven_lamp")
        return [
            ag.detail(mica, "wave_guide_cover", _MICA),
            ag.detail(lamp, "light", glow),
            ag.detail(grille, "vent", DARK),
            ag.detail(outlet, "vent", DARK),
            ag.detail(rib, "cavity", self.inside),
            ag.detail(seam, "cavity", ag.material("zinc")),
        ]

    def _vents(self) -> list[ag.Body]:
        """Make the air inlet and outlet slots of the fan, in a side and the top."""
        space, half = self.space, self.space.half
        side = -1 if self.vents == "left" else 1
        high = space.height - space.foot
        slots = details.vent_slots(0.11, 0.052, 13, slot=0.0030)
        low = details.vent_slots(0.085, 0.030, 10, slot=0.0030)
        y = space.rear - 0.085
        on_side = details.relief(
            slots, (side * half, y, space.foot + 0.66 * high), facing=(side, 0.0, 0.0), proud=0.0002
        )
        other = details.relief(
            low, (-side * half, y - 0.03, space.foot + 0.24 * high), facing=(-side, 0.0, 0.0), proud=0.0002
        )
        return [ag.detail(each, "vent", DARK) for each in (on_side, other)]

    def _back(self) -> list[ag.Body]:
        """Make vents, screws, rating plate, the dome over the stirrer and the cord."""
        space = self.space
        half, rear = space.half, space.rear
        plane = rear - 0.0008
        low, high = space.foot, space.height
        backward = (0.0, 1.0, 0.0)
        tall = high - low
        slots = details.vent_slots(0.085, 0.070, 9, slot=0.0036, direction="horizontal")
        fan = details.perforation(ag.circle(0.043), 0.0092, 0.0031)
        works = half - 0.085  # the fan is behind the control panel
        vents = [
            details.relief(slots, (-0.42 * half, plane, low + 0.62 * tall), facing=backward, proud=0.0002),
            details.relief(fan, (works, plane, low + 0.62 * tall), facing=backward, proud=0.0002),
        ]
        ring = ag.cylinder(0.047, 0.0020, axis=ag.Y, bevel=0.0008).at(
            works, plane - 0.0002, low + 0.62 * tall
        )
        heads: list[tuple[ag.Scalar, ag.Scalar, ag.Scalar]] = [
            (x, plane, z)
            for x in (0.012 - half, half - 0.012)
            for z in (low + 0.016, low + 0.5 * tall, high - 0.014)
        ]
        heads += [(x, plane, high - 0.012) for x in (-0.3 * half, 0.3 * half)]
        lines = (f"{self.maker.upper()} M{self.watts // 10}", f"230 V~ {self.watts} W 2450 MHz")
        plate = details.rating_plate(
            0.070,
            0.040,
            lines,
            at=(-0.35 * half, plane, low + 0.24 * tall),
            facing=backward,
            double_insulated=False,
        )
        cord = mains_cord(height=low + 0.05, length=0.15, side=-1).at(works + 0.03, plane, low + 0.05)
        spacer = ag.box(0.016, 0.018, 0.030, bevel=0.004)
        spacers: list[ag.Solid] = [
            spacer.at(x, rear - 0.0004 + 0.0085, high - 0.030) for x in (-0.62 * half, 0.05 * half)
        ]
        black = ag.material("black_abs")
        return [
            ag.detail(ring, "body", ag.material("zinc")),
            *(
                ag.detail(each.at(0.0, 0.0012, 0.0) if index else each, "vent", DARK)
                for index, each in enumerate(vents)
            ),
            *screws(heads, facing="+y", radius=0.0032, finish=ag.material("zinc"), head="pan"),
            plate,
            cord,
            *(ag.detail(each, "body", black) for each in spacers),
        ]


_PLAY = 0.0004  # gap between floor, rollers and plate [m]
_ROLLER = 0.0075  # radius of a roller [m]
_WHEEL = 0.0085  # width of a roller [m]
_GLASS = 0.0052  # thickness of the plate [m]
_RIM = 0.011  # height of the rim of the plate above its underside [m]
_TRACK = 0.66  # radius of the ring, as a share of that of the plate
_HUB = 0.0125  # radius of the coupler [m]
_SHAFT = 0.0042  # radius of the motor's shaft [m]


@dataclass(frozen=True)
class Turntable:
    """A plate on its roller ring."""

    radius: ag.Scalar  # radius of the plate [m]
    x: ag.Scalar  # position of the axis along x [m]
    y: ag.Scalar  # position of the axis along y [m]
    floor: ag.Scalar  # height of the floor of the cavity [m]
    friction: ag.Scalar  # friction of the rollers and the motor's gears, at the plate [N m]

    @cached_property
    def _under(self) -> float:
        """Height of the underside of the plate above the floor [m]."""
        return 2.0 * _ROLLER + 2.0 * _PLAY

    def plate(self) -> ag.Body:
        """Make the glass plate with the coupler under it: the link `plate`."""
        radius, low = self.radius, self._under
        glass = ag.material("glass").with_(name="plate_glass", opacity=0.30)
        disc = ag.cylinder(radius, _GLASS, bevel=0.002).at(0.0, 0.0, low + _GLASS / 2.0)
        inner = radius - 0.016
        rim = ag.polygon(
            [
                (inner, low + _GLASS - 0.0008),
                (radius - 0.0005, low + _GLASS - 0.0014),
                (radius, low + _RIM - 0.001),
                (radius - 0.0015, low + _RIM),
                (radius - 0.0045, low + _RIM - 0.0015),
            ]
        )
        rings = [
            ag.torus(share * radius, 0.0011).at(0.0, 0.0, low + _GLASS - 0.0003) for share in (0.40, 0.78)
        ]
        black = ag.colored("polypropylene", "light_grey").with_(name="coupler_plastic")
        hub = ag.cylinder(_HUB, low - 2.0 * _PLAY - 0.0016, bevel=0.0015)
        lobe = ag.box(0.030, 0.0075, 0.0062, bevel=0.0015)
        lobes = [
            lobe.at(0.0135, 0.0, 0.0).rotate(ag.Z, turn * math.tau / 3.0).at(0.0, 0.0, low - _PLAY - 0.0029)
            for turn in range(3)
        ]
        middle = 0.5 * (low + 0.0016)
        return ag.weld(
            ag.part(disc, "plate", glass),
            ag.part(hub.at(0.0, 0.0, middle), "coupler", black, separate="the plate lies on the coupler"),
            *(ag.detail(each, "coupler", black) for each in lobes),  # through the space inside the ring
            ag.detail(ag.revolve(rim), "plate", glass),
            *(ag.detail(each, "plate", glass) for each in rings),
        ).at(self.x, self.y, self.floor)

    def ring(self) -> ag.Body:
        """Make the ring of rollers: the link `roller_ring`."""
        track, level = _TRACK * self.radius, _PLAY + _ROLLER
        white = ag.colored("polypropylene", "ivory").with_(name="roller_plastic")
        wheel = ag.cylinder(_ROLLER, _WHEEL, axis=ag.X, bevel=0.001)
        wheels = [
            wheel.at(track, 0.0, level).rotate(ag.Z, turn * math.tau / 3.0 + math.pi / 2.0)
            for turn in range(3)
        ]
        # spokes in a triangle carry the wheels; the round ring above them is visual only
        chord = ag.box(0.004, math.sqrt(3.0) * track - 0.012, 0.0038, bevel=0.001)
        chords = [
            chord.at(0.5 * track, 0.0, level).rotate(ag.Z, turn * math.tau / 3.0 + math.pi / 6.0)
            for turn in range(3)
        ]
        hoop = ag.tube(track + 0.0062, track - 0.0062, 0.0042, bevel=0.0008).at(0.0, 0.0, level)
        return ag.weld(
            ag.part(wheels[0], "roller_ring", white, separate="its wheels turn on pins in the ring"),
            *(ag.part(each, "roller_ring", white) for each in wheels[1:]),
            *(ag.part(each, "roller_ring", white) for each in chords),
            ag.detail(hoop, "roller_ring", white),
        ).at(self.x, self.y, self.floor)

    def spin(self) -> ag.Joint:
        """Make the joint of the plate; a synchronous motor of 5-6 rpm drives it."""
        return ag.Revolute(
            "plate_spin",
            axis=ag.Z,
            pivot=(self.x, self.y, self.floor),
            friction=self.friction,
            damping=0.002,
            # torque of a hand at the rim; geared motors of 3 W give 0.5 before their clutch slips
            effort=1.5,
            velocity=0.7,
            driven="a motor",
        )

    def roll(self, spin: ag.Joint) -> ag.Joint:
        """Make the joint of the ring: its wheels roll under the plate, and turn the ring at half speed."""
        return ag.Revolute(
            "ring_spin",
            axis=ag.Z,
            pivot=(self.x, self.y, self.floor),
            damping=0.0005,
            armature=0.0001,  # inertia of the wheels
            follows=0.5 * spin,
        )

    def shaft(self) -> ag.Body:
        """Make the visible shaft of the motor and the groove of the roller ring."""
        steel = ag.material("stainless")
        groove = ag.tube(_TRACK * self.radius + 0.012, _TRACK * self.radius - 0.012, 0.0004)
        pin = ag.cylinder(_SHAFT, 0.0010).at(0.0, 0.0, 0.0003)
        return ag.weld(
            ag.detail(groove.at(0.0, 0.0, 0.0001), "cavity", ag.colored("enamel", "light_grey")),
            ag.detail(pin, "cavity", steel),
        ).at(self.x, self.y, self.floor)
