"""Faces of clocks: numerals and minutes on a dial, and hands in layers before it.

A face is about the origin on the plane y = 0 and is seen from -y; z is up. The hands are layers with gaps, so
that all of them turn past each other.
"""

import functools
import math
import operator
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import details, feel

Numerals = Literal["arabic", "roman", "quarters", "bars"]
"""Twelve numbers, twelve Roman ones, numbers at the quarters, or bars."""

Hands = Literal["baton", "leaf", "spade", "sword"]
"""Outline of the hands: bars, diamonds, bars with a disc before the tip, or blades."""

REACH = 0.0125
"""From the dial to the front of the foremost hand [m]."""

_ROMAN = ("XII", "I", "II", "III", "IIII", "V", "VI", "VII", "VIII", "IX", "X", "XI")
_LAYERS = {"alarm": 0.0010, "hour": 0.0030, "minute": 0.0062, "second": 0.0094}
"""From the dial to the back of each hand [m]."""
_THIN = 0.0012  # thickness of a hand [m]
_GAP = 0.0008  # between the hubs of the hands [m]
_DRIVE = "the movement"
_LIGHT = feel.Feel(damping=1e-4, armature=1e-5)
_RED = ag.colored("powder_coat", "red")


@dataclass(frozen=True)
class Face:
    """Look of a dial and of its hands."""

    radius: ag.Scalar  # to the ends of the minutes [m]
    numerals: Numerals
    hands: Hands
    time: ag.Scalar  # that the hands show at rest, from noon on [h]
    seconds: bool  # whether there is a hand for seconds
    paper: ag.Material  # of the dial
    ink: ag.Material  # of numerals and minutes
    metal: ag.Material  # of the hands
    maker: str

    def disc(self, radius: ag.Scalar) -> ag.Body:
        """Make the disc of the dial behind the plane y = 0, of its own radius [m]."""
        return ag.part(ag.cylinder(radius, 0.002, axis=ag.Y).at(y=0.001), "dial", self.paper)

    def printed(self) -> list[ag.Body]:
        """Print the minutes, the numerals and the maker on the dial."""
        radius = self.radius
        minute = ag.rectangle(0.010 * radius, 0.045 * radius).at(0, 0.965 * radius)
        strong = ag.rectangle(0.026 * radius, 0.070 * radius).at(0, 0.952 * radius)
        marks = [(minute if number % 5 else strong).rotate(-math.tau * number / 60) for number in range(60)]
        marks += [self._numeral(number) for number in range(12)]
        film = details.printed(_united(marks), material=self.ink)
        name = details.logo(self.maker, 0.055 * radius, tracking=0.2).at(0, 0.34 * radius)
        return [film, details.printed(name, material=self.ink)]

    def _numeral(self, number: int) -> ag.Profile:
        """Make the numeral at an hour; 0 is at the top."""
        turn, radius = math.tau * number / 12, self.radius
        if self.numerals == "bars" or (self.numerals == "quarters" and number % 3):
            bar = ag.rectangle(0.045 * radius, 0.17 * radius).at(0, 0.80 * radius)
            return bar.rotate(-turn)
        if self.numerals == "roman":
            sign = details.lettering((_ROMAN[number],), 0.17 * radius, fineness="coarse")
            return sign.at(0, 0.76 * radius).rotate(-turn)
        sign = details.lettering((str(number or 12),), 0.15 * radius, fineness="coarse")
        away = 0.76 * radius
        return sign.at(away * math.sin(turn), away * math.cos(turn))

    def hand(self, kind: Literal["alarm", "hour", "minute", "second"]) -> ag.Body:
        """Make a hand that points up, with its hub."""
        shares = {
            "alarm": (0.46, 0.030, 0.0, 0.045), "hour": (0.56, 0.085, 0.12, 0.060),
            "minute": (0.86, 0.060, 0.14, 0.050), "second": (0.90, 0.018, 0.26, 0.040),
        }[kind]  # fmt: skip
        far, wide, tail, hub = (share * self.radius for share in shares)
        back = _LAYERS[kind]
        front = back + _THIN + (0.0008 if kind == "second" else 0.0)
        below = {"minute": _LAYERS["hour"] + _THIN, "second": _LAYERS["minute"] + _THIN}.get(
            kind, back - _GAP
        )
        style = "baton" if kind in ("alarm", "second") else self.hands
        plates = [
            ag.extrude(each, _THIN, axis=ag.Y).at(y=-back - _THIN / 2)
            for each in _outline(style, far, wide, tail)
        ]
        boss = ag.cylinder(hub, front - below - _GAP, axis=ag.Y).at(y=-(front + below + _GAP) / 2)
        finish = _RED if kind in ("alarm", "second") else self.metal
        return ag.part([*plates, boss], "hand", finish, name=f"{kind}_hand")

    def with_hands(self, body: ag.Body, at: ag.VectorLike, *, lead: ag.Joint | None = None) -> ag.Body:
        """Join the hands to a body.

        Args:
            body: Link that carries the dial.
            at: Middle of the dial [m].
            lead: Joint of a knob that sets the hands; without one, the minute hand leads the hour hand.
        """
        turn = self._turn(lead)
        slow = ag.Revolute(
            "hour_turn", axis=ag.Y, follows=(1 / 12) * (turn if lead is None else lead), feel=_LIGHT
        )
        body = body.attach(self.hand("hour").rotate(ag.Y, self.time * (math.tau / 12)), slow, at=at)
        body = body.attach(self.hand("minute").rotate(ag.Y, self.time * math.tau), turn, at=at)
        if self.seconds:
            sweep = ag.Revolute(
                "second_turn", axis=ag.Y, friction=2e-4, damping=1e-5, armature=1e-6, effort=0.02,
                driven=_DRIVE,
            )  # fmt: skip
            body = body.attach(self.hand("second").rotate(ag.Y, 2.2), sweep, at=at)
        return body

    def with_alarm(self, body: ag.Body, lead: ag.Joint) -> ag.Body:
        """Join the hand of an alarm that follows its knob to a body with the dial at the origin."""
        shows = ag.Revolute("alarm_hand_turn", axis=ag.Y, follows=1.0 * lead, feel=_LIGHT)
        return body.attach(self.hand("alarm").rotate(ag.Y, 3.4), shows)

    @staticmethod
    def _turn(lead: ag.Joint | None) -> ag.Joint:
        """Make the joint of the minute hand."""
        if lead is not None:
            return ag.Revolute("minute_turn", axis=ag.Y, follows=1.0 * lead, feel=_LIGHT)
        return ag.Revolute(
            "minute_turn", axis=ag.Y, friction=0.004, damping=1e-3, armature=2e-5, effort=0.1, driven=_DRIVE
        )


def _united(profiles: list[ag.Profile]) -> ag.Profile:
    return functools.reduce(operator.or_, profiles)


def _outline(style: Hands, far: ag.Scalar, wide: ag.Scalar, tail: ag.Scalar) -> list[ag.Profile]:
    """Make the outline of a hand that points up, of convex profiles."""
    half = wide / 2
    match style:
        case "baton":
            return [ag.rectangle(0.8 * wide, far + tail).at(0, (far - tail) / 2)]
        case "leaf":
            return [ag.polygon([(0, -tail), (0.9 * half, 0.30 * far), (0, far), (-0.9 * half, 0.30 * far)])]
        case "sword":
            right = [(0.45 * half, -tail), (half, 0.80 * far)]
            return [ag.polygon([*right, (0, far), *((-x, y) for x, y in reversed(right))])]
        case _:
            stem = ag.rectangle(0.45 * wide, 0.72 * far + tail).at(0, (0.72 * far - tail) / 2)
            tip = ag.polygon([(-0.6 * half, 0.70 * far), (0.6 * half, 0.70 * far), (0, far)])
            return [stem, ag.circle(0.95 * half).at(0, 0.70 * far), tip]
