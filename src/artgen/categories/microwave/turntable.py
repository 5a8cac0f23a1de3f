"""The turntable of a microwave oven: a glass plate on a coupler, and the ring of rollers under it."""

import math
from dataclasses import dataclass

import artgen as ag
from artgen._arrays import cached_property

_PLAY = 0.0004  # between floor, rollers and plate [m]
_ROLLER = 0.0075  # radius of a roller [m]
_WHEEL = 0.0085  # its width [m]
_GLASS = 0.0052  # thickness of the plate [m]
_RIM = 0.011  # how high its rim stands above its underside [m]
_TRACK = 0.66  # radius of the ring, as a share of that of the plate
_HUB = 0.0125  # radius of the coupler [m]
_SHAFT = 0.0042  # radius of the motor's shaft [m]


@dataclass(frozen=True)
class Turntable:
    """A plate on its ring."""

    radius: ag.Scalar  # of the plate [m]
    x: ag.Scalar  # where its axis is [m]
    y: ag.Scalar  # where its axis is [m]
    floor: ag.Scalar  # of the cavity [m]
    friction: ag.Scalar  # of the rollers and the gears of the motor, felt at the plate [N m]

    @cached_property
    def _under(self) -> float:
        """The underside of the plate, above the floor [m]."""
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
            *(
                ag.detail(each, "coupler", black) for each in lobes
            ),  # in the hollow of the ring, which they pass
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
        # spokes in a triangle carry the wheels; the round ring over them is only seen
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
        """Make the joint of the plate, which a synchronous motor of 5-6 rpm turns."""
        return ag.Revolute(
            "plate_spin",
            axis=ag.Z,
            pivot=(self.x, self.y, self.floor),
            friction=self.friction,
            damping=0.002,
            effort=1.5,  # of a hand at the rim; geared motors of 3 W give 0.5 before their clutch slips
            velocity=0.7,
            driven="a motor",
        )

    def roll(self, spin: ag.Joint) -> ag.Joint:
        """Make the joint of the ring: wheels that roll under the plate take it along at half its speed."""
        return ag.Revolute(
            "ring_spin",
            axis=ag.Z,
            pivot=(self.x, self.y, self.floor),
            damping=0.0005,
            armature=0.0001,  # of the wheels
            follows=0.5 * spin,
        )

    def shaft(self) -> ag.Body:
        """Make what is seen of the motor's shaft and the groove in which the ring runs."""
        steel = ag.material("stainless")
        groove = ag.tube(_TRACK * self.radius + 0.012, _TRACK * self.radius - 0.012, 0.0004)
        pin = ag.cylinder(_SHAFT, 0.0010).at(0.0, 0.0, 0.0003)
        return ag.weld(
            ag.detail(groove.at(0.0, 0.0, 0.0001), "cavity", ag.colored("enamel", "light_grey")),
            ag.detail(pin, "cavity", steel),
        ).at(self.x, self.y, self.floor)
