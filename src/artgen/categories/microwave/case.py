"""The case of a microwave oven: the cavity as boards, the room of its latches, the sheet around, its back."""

from dataclasses import dataclass

import artgen as ag
from artgen import details
from artgen._arrays import cached_property
from artgen.categories.microwave.space import FRAME, SHAFT, SHEET, Space
from artgen.categories.shared.appliances.cords import mains_cord
from artgen.categories.shared.appliances.finish import DARK, filled
from artgen.categories.shared.hardware.fixings import feet, screws

_LAP = 0.0005  # by which boards reach into each other, so that they have no corners in common [m]
_WALL = 0.0035  # thickness of the cavity's right wall [m]
_BEFORE = 0.045  # between the room of the latches and the works [m]
_WORKS = 0.18  # how deep they are in all but the smallest [m]
_OPEN = (0.0050, 0.0042)  # from the middle of a latch to the sides of its slot, to the left and right [m]
_MICA = ag.colored("fabric", "sand").with_(name="mica", texture="", tile=None, specular_roughness=0.35)


@dataclass(frozen=True)
class Case:
    """How a case looks."""

    space: Space  # its measures
    finish: ag.Material  # of the sheet around it
    inside: ag.Material  # of the cavity
    stuffing: float  # what its walls weigh with transformer, magnetron and fan, by their volume [kg/m3]
    slots: tuple[ag.Span, ...]  # heights of the slots of the latches, their lower and upper edges [m]
    vents: str  # which side the air comes in by: `left` or `right`
    maker: str  # whose name is on the rating plate
    watts: int  # on the rating plate [W]

    def body(self) -> ag.Body:
        """Make all that stands still but the control panel: the link `body`."""
        return ag.weld(*self._sheets(), *self._walls(), *self._inside(), *self._vents(), *self._back())

    @cached_property
    def _outer(self) -> ag.Span:
        """The cavity's boards end in the middle of the sheet."""
        return (_LAP + SHEET / 2.0 - self.space.half, self.space.half - SHEET / 2.0 - _LAP)

    def _walls(self) -> list[ag.Body]:
        """Make floor, ceiling, sides and back of the cavity, and the frame that the latches pass."""
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
            ag.part(ag.board(outer, shallow, (low, floor)), "cavity", filled(self.inside, 300.0, "floor")),
            ag.part(
                ag.board(outer, shallow, (ceiling, high)), "cavity", filled(self.inside, 210.0, "ceiling")
            ),
        ]
        boards = [
            ag.board((outer[0], left), (front, rear - _LAP), wall),
            ag.board((left - _LAP, right + _LAP), (space.back, rear - _LAP), wall),
            ag.board((right, passing), (front, rear - _LAP), wall),
        ]
        # the transformer and the fan are at the back; before them are the latches and the boards of the keys
        heavy_from = ag.max_(deep + _BEFORE, rear - _WORKS)
        works = ag.board((passing - _LAP, outer[1]), (heavy_from, rear - 2.0 * _LAP), wall)
        light = ag.board((rest, outer[1]), (front, heavy_from + _LAP), wall)
        strip = (passing - _LAP, rest + _LAP)
        edges = [wall[0], *(edge for slot in self.slots for edge in slot), wall[1]]
        frame = [
            ag.board(strip, (front, front + FRAME), (edges[index], edges[index + 1]))
            for index in range(0, len(edges), 2)
        ]
        beside = []  # the slots look narrower than the gaps of the frame, which guide nothing
        for bottom, top in self.slots:
            level = (bottom - _LAP, top + _LAP)
            thin = (front + _LAP, front + FRAME - _LAP)
            hook = space.hook
            beside.append(ag.board((passing - 2.0 * _LAP, hook - _OPEN[0]), thin, level))
            beside.append(ag.board((hook + _OPEN[1], rest + 2.0 * _LAP), thin, level))
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
            ag.board(x, (front, rear), (low, high - 0.0006), bevel=0.0010)
            for x in ((-half, SHEET - half), (half - SHEET, 1.0 * half))
        ]
        top = ag.board((0.0006 - half, half - 0.0006), (front, rear), (high - SHEET, high), bevel=0.0010)
        wide = (0.001 - half, half - 0.001)
        bottom = ag.board(wide, (front + 0.006, rear - 0.0006), (low, low + SHEET))
        back = ag.board(wide, (rear - SHEET, rear - 0.0008), (low + 0.0008, high - 0.0012))
        x = half - 0.040
        corners = [(side * x, y) for side in (-1, 1) for y in (space.mouth + 0.035, rear - 0.035)]
        return [
            *(ag.part(each, "body", sheet) for each in (*sides, top)),
            *(ag.detail(each, "body", zinc) for each in (bottom, back)),  # around the boards of the cavity
            feet(corners, radius=0.011, height=space.foot),
        ]

    def _inside(self) -> list[ag.Body]:
        """Make what is seen in the cavity: the cover of the wave guide, the lamp, the air holes."""
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
        # a pressed edge around the back wall, which stiffens it
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
        """Make the slots by which the fan draws and blows air, in a side and the top."""
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
        lines = (
            f"{self.maker.upper()} M{self.watts // 10}",
            f"230 V~ {self.watts} W 2450 MHz",
        )
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
