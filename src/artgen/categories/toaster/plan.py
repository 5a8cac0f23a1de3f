"""The plan of a toaster: positions of its slots, its chamber and its controls.

All parts are modeled with the slots along y and the bay of the controls at -y. For controls on a broad side,
the finished shell is rotated by 90 degrees, which moves the wall at -x to the front.
"""

import math
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen._arrays import cached_property

BodyStyle = Literal["box", "rounded", "retro", "steel", "classic"]
"""A plain box; rounded shoulders; bulging sides; a steel sleeve between plastic ends; beveled edges."""

SHEET = 0.0025
"""Modeled thickness of sheets [m]; their density compensates for it."""

_BACK = 0.014  # distance between the chamber and the back cap [m]
_DOMES: dict[BodyStyle, float] = {"rounded": 0.009, "retro": 0.013}  # radius of rounded ends [m]
_CAPS: dict[BodyStyle, float] = {"box": 0.008, "steel": 0.014, "classic": 0.007}  # thickness of flat ends [m]
_INSETS: dict[BodyStyle, float] = {"retro": 0.0016, "steel": 0.003, "classic": 0.0022}
# distance from the sides to the panel [m]
_BORDERS: dict[BodyStyle, float] = {"rounded": 0.021, "retro": 0.026, "classic": 0.016}
# distance from the top to the panel [m]
_TOPS: dict[BodyStyle, float] = {"rounded": 0.026, "retro": 0.034, "classic": 0.032}


def _round(sides: int) -> ag.Profile:
    """Make a circle of radius 1 with a number of sides."""
    angles = [math.tau * side / sides for side in range(sides)]
    return ag.polygon([(math.cos(angle), math.sin(angle)) for angle in angles])


_COARSE = _round(40)  # for ends with a limited number of corners
_ROUND = _round(200)  # for a bulging sleeve without visible facets


@dataclass(frozen=True)
class Plan:
    """Independent dimensions of a toaster [m]."""

    style: BodyStyle  # style of the body
    slots: int  # number of slots side by side
    long: bool  # whether a slot takes two slices
    slot_width: ag.Float  # width of a slot
    slot_length: ag.Float  # length of a slot
    bridge: ag.Float  # gap between two slots
    shoulder: ag.Float  # distance from the outer slots to the sides
    length: ag.Float  # length of the body along the slots
    height: ag.Float  # height of the body's top above the floor
    foot: ag.Float  # height of the body's underside above the floor

    @cached_property
    def span(self) -> ag.Float:
        """Width from the first slot to the last."""
        return self.slots * self.slot_width + (self.slots - 1) * self.bridge

    @cached_property
    def width(self) -> ag.Float:
        """Width of the body across the slots."""
        return self.span + 2 * self.shoulder

    @property
    def dome(self) -> float:
        """Radius of the rounded front end; 0 for a flat end."""
        return _DOMES.get(self.style, 0.0)

    @property
    def cap(self) -> float:
        """Thickness of the front end."""
        return _CAPS.get(self.style, 0.004 + self.dome)

    @property
    def back_cap(self) -> float:
        """Thickness of the flat back end."""
        return _CAPS.get(self.style, 0.009)

    @property
    def inset(self) -> float:
        """Depth of the sleeve inside the outline of the ends, which shows the joint."""
        return _INSETS.get(self.style, 0.0012)

    @property
    def border(self) -> float:
        """Distance from the sides of the front to the control panel."""
        return _BORDERS.get(self.style, 0.012)

    @property
    def under_panel(self) -> float:
        """Distance from the underside of the front to the control panel."""
        return 0.018 if self.style == "retro" else 0.012

    @property
    def over_panel(self) -> float:
        """Distance from the control panel to the top of the front."""
        return _TOPS.get(self.style, 0.018)

    @cached_property
    def pitch(self) -> ag.Float:
        """Distance from the middle of a slot to that of the next."""
        return self.slot_width + self.bridge

    @property
    def solidity(self) -> float:
        """Real share of the modeled volume of the sleeve: a rounded sleeve is modeled thicker."""
        return {"retro": 0.42, "rounded": 0.75, "steel": 0.85}.get(self.style, 1.0)

    @cached_property
    def top(self) -> ag.Float:
        """Height of the sleeve's upper face."""
        return self.height - self.inset

    @cached_property
    def floor(self) -> ag.Float:
        """Height of the inner face of the sleeve's bottom."""
        return self.foot + self.inset + SHEET

    @cached_property
    def chamber(self) -> tuple[ag.Float, ag.Float]:
        """Positions of the ends of the chamber along y."""
        end = self.length / 2 - self.back_cap - _BACK
        return end - self.slot_length, end

    @cached_property
    def bay(self) -> ag.Float:
        """Middle of the bay of the carriage's post along y."""
        return 0.5 * (self.chamber[0] - self.length / 2 + self.cap)

    @cached_property
    def middles(self) -> list[ag.Float]:
        """Positions of the middles of the slots along x, from the left."""
        return [(number - (self.slots - 1) / 2) * self.pitch for number in range(self.slots)]

    @cached_property
    def outline(self) -> ag.Profile:
        """Outline of the ends in x and z, about their middle."""
        return self._outline(self.width, self.height - self.foot, _COARSE)

    def section(self) -> ag.Profile:
        """Return the outline of the sleeve, about the middle of the ends."""
        return self._outline(self.width - 2 * self.inset, self.height - self.foot - 2 * self.inset, _ROUND)

    def hollow(self) -> ag.Profile:
        """Return the outline of the inside of the sleeve; it has few corners, for few collision pieces.

        Walls of a rounded sleeve are thicker, which is invisible.
        """
        x, z = self.width / 2 - self.inset - SHEET, (self.height - self.foot) / 2 - self.inset - SHEET
        match self.style:
            case "box":
                return ag.rectangle(2 * x, 2 * z)
            case "steel":
                return _cornered(x, z, upper=self._steel - SHEET, lower=self._steel - SHEET)
            case "rounded":
                return _cornered(x, z, upper=self._shoulder - SHEET)
            case "classic":
                return _cornered(x, z, upper=self._bevel, steep=1.5)
            case "retro":
                low, high = 0.93 * x - 0.013, 0.895 * x - 0.013
                left = [(-high, z), (-x, -0.06 * z), (-low, -z)]
                return ag.polygon([(low, -z), (x, -0.06 * z), (high, z), *left])

    @cached_property
    def _steel(self) -> ag.Float:
        return ag.min_(0.5 * self.shoulder, 0.017)

    @cached_property
    def _shoulder(self) -> ag.Float:
        return ag.min_(0.7 * self.shoulder, 0.036)

    @cached_property
    def _bevel(self) -> ag.Float:
        return ag.min_(0.72 * self.shoulder, 0.034)

    def _outline(self, wide: ag.Scalar, high: ag.Scalar, disc: ag.Profile) -> ag.Profile:
        match self.style:
            case "box":
                return ag.rectangle(wide, high, radius=0.0075)
            case "steel":
                return ag.rectangle(wide, high, radius=self._steel)
            case "rounded":
                shoulders = ag.rectangle(wide, high, radius=self._shoulder)
                return shoulders | ag.rectangle(wide, 0.6 * high, radius=0.0075).at(0.0, -0.2 * high)
            case "retro":
                bulge = disc.scale(wide / 2, 1.15 * high)
                bulging = ag.rectangle(1.1 * wide, high) & bulge.at(0.0, -0.04 * high)
                return bulging.offset(-0.022).offset(0.022)
            case "classic":
                return _cornered(wide / 2, high / 2, upper=self._bevel, steep=1.5, radius=0.004)


def _cornered(
    x: ag.Scalar,
    z: ag.Scalar,
    *,
    upper: ag.Scalar,
    lower: ag.Scalar | None = None,
    steep: float = 1.0,
    radius: float = 0.0,
) -> ag.Profile:
    """Make a rectangle with its upper corners cut off, and its lower corners if they have a size."""
    right: list[tuple[ag.Scalar, ag.Scalar]] = [(x, z - steep * upper), (x - upper, z)]
    right = [(x, -z), *right] if lower is None else [(x - lower, -z), (x, steep * lower - z), *right]
    left = [(-each, level) for each, level in reversed(right)]
    return ag.polygon([*right, *left], radius=radius)
