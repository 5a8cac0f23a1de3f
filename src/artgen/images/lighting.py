"""What a picture is lit by and what stands around: plain, or drawn anew for each picture."""

import colorsys
import math
from collections.abc import Collection
from dataclasses import dataclass
from typing import Any

import numpy as np

from artgen._arrays import Array

FLOORS = ("oak", "walnut_flat_sawn", "pine", "marble", "granite", "black_granite", "linen", "canvas", "mdf")
"""Materials that a random floor may have."""

WALLS = ("linen", "marble", "plywood", "cardboard", "fabric", "beech", "mdf", "granite")
"""Materials that a random wall may have."""

_PLAIN_SKY = (0.80, 0.80, 0.80)
_PLAIN_KEY = (-0.6, 0.9)  # azimuth from the camera and elevation [rad]


@dataclass(frozen=True)
class Light:
    """Light of one picture: from everywhere, and of a far lamp that casts shadows."""

    # from where the lamp shines: 0 from the camera, a quarter turn from its right [rad]
    azimuth: float = _PLAIN_KEY[0]
    elevation: float = _PLAIN_KEY[1]  # how far above the horizon [rad]
    directional: float = 0.55  # strength of the lamp
    ambient: float = 0.45  # strength of the light from everywhere
    color: tuple[float, float, float] = (1.0, 1.0, 1.0)  # of the lamp, red, green and blue
    spread: float = 0.05  # how far its shadows are blurred [rad]

    def direction(self, aside: tuple[float, float] = (0.0, 0.0)) -> Array:
        """Return the unit direction to a point of the lamp, in coordinates that turn with the camera."""
        turn = self.azimuth + 2.0 * self.spread * (aside[0] - 0.5)
        high = self.elevation + 2.0 * self.spread * (aside[1] - 0.5)
        level = math.cos(high)
        return np.array([level * math.sin(turn), -level * math.cos(turn), math.sin(high)])

    def to_data(self) -> dict[str, Any]:
        """Return the light as JSON data."""
        return {
            "azimuth": self.azimuth,
            "elevation": self.elevation,
            "directional": self.directional,
            "ambient": self.ambient,
            "color": list(self.color),
        }


@dataclass(frozen=True)
class Setting:
    """What is around the asset in one picture."""

    light: Light = Light()  # what it is lit by
    horizon: tuple[float, float, float] = _PLAIN_SKY  # colour of the sky at the horizon and below, as shown
    zenith: tuple[float, float, float] = _PLAIN_SKY  # its colour above
    floor: int = -1  # number of the floor among those of the scene; -1 for none
    floor_tint: tuple[float, float, float] = (1.0, 1.0, 1.0)  # what its colours are multiplied by
    floor_turn: float = 0.0  # how far it is turned about z [rad]
    wall: int = -1  # the same for the wall behind the asset
    wall_tint: tuple[float, float, float] = (1.0, 1.0, 1.0)  # what its colours are multiplied by
    wall_turn: float = 0.0  # how far it is turned about z [rad]
    wall_distance: float = 1.5  # how far it is behind the middle of the asset, over the asset's radius


@dataclass(frozen=True)
class Surroundings:
    """What the settings of one asset's pictures choose from."""

    floors: tuple[str, ...] = ()  # names of the materials of floors
    walls: tuple[str, ...] = ()  # names of the materials of walls


def random_surroundings(random: Collection[str], draw: np.random.Generator) -> Surroundings:
    """Return the floors and walls of an asset's pictures: three of each that is random."""
    floors = tuple(str(each) for each in draw.choice(FLOORS, 3, replace=False))
    walls = tuple(str(each) for each in draw.choice(WALLS, 3, replace=False))
    return Surroundings(floors if "floor" in random else (), walls if "backdrop" in random else ())


def random_setting(around: Surroundings, random: Collection[str], draw: np.random.Generator) -> Setting:
    """Return what is around the asset in a picture; what is not random is plain."""
    light = _random_light(draw) if "light" in random else Light()
    horizon, zenith = (
        (_random_color(draw), _random_color(draw)) if "backdrop" in random else (_PLAIN_SKY,) * 2
    )
    wall = int(draw.integers(2 * len(around.walls))) if around.walls else -1  # half of them have none
    return Setting(
        light,
        horizon,
        zenith,
        floor=int(draw.integers(len(around.floors))) if around.floors else -1,
        floor_tint=_random_tint(draw),
        floor_turn=float(draw.uniform(-math.pi, math.pi)),
        wall=wall if wall < len(around.walls) else -1,
        wall_tint=_random_tint(draw),
        wall_turn=float(draw.uniform(-0.7, 0.7)),
        wall_distance=float(draw.uniform(1.3, 4.0)),
    )


def _random_light(draw: np.random.Generator) -> Light:
    directional = float(draw.uniform(0.25, 0.8))
    warmth = float(draw.uniform(-0.12, 0.12))
    return Light(
        azimuth=float(draw.uniform(-2.4, 2.4)),
        elevation=float(draw.uniform(0.45, 1.4)),
        directional=directional,
        ambient=float(draw.uniform(0.8, 1.05)) - 0.8 * directional,
        color=(1.0 + min(warmth, 0.0), 1.0 - 0.4 * abs(warmth), 1.0 - max(warmth, 0.0)),
        spread=float(draw.uniform(0.01, 0.05)),
    )


def _random_color(draw: np.random.Generator) -> tuple[float, float, float]:
    hue, colorful, bright = (
        draw.uniform(0.0, 1.0),
        0.5 * draw.uniform(0.0, 1.0) ** 2,
        draw.uniform(0.25, 0.95),
    )
    return colorsys.hsv_to_rgb(hue, colorful, bright)


def _random_tint(draw: np.random.Generator) -> tuple[float, float, float]:
    red, green, blue = draw.uniform(0.75, 1.0) * draw.uniform(0.85, 1.0, 3)
    return float(red), float(green), float(blue)
