"""Where the studio's lamps stand, and how they are sampled."""

import math

import numpy as np

from artgen._arrays import Array

KEY = np.array([-0.38, -0.85, 0.80]) / np.linalg.norm([-0.38, -0.85, 0.80])
"""From where the key light comes, shape (3,)."""

_KEY_SPREAD = 0.16  # half the size of the softbox as seen from the asset
_LOWEST = 0.06  # square of the least height of a point of the sky
_PRIMES = (2, 3, 5, 7, 11)


def key_light(across: float, around: float) -> Array:
    """Return the unit direction to a point of the softbox, given by two numbers in 0..1."""
    right = np.cross(KEY, (0.0, 0.0, 1.0))
    radius, turn = _KEY_SPREAD * math.sqrt(across), 2.0 * math.pi * around
    point = KEY + radius * (math.cos(turn) * right + math.sin(turn) * np.cross(right, KEY))
    return np.asarray(point / np.linalg.norm(point))


def sky_light(height: float, around: float) -> Array:
    """Return the unit direction to a point of the sky, brightest above, given by two numbers in 0..1."""
    z, turn = math.sqrt(_LOWEST + (1.0 - _LOWEST) * height), 2.0 * math.pi * around
    level = math.sqrt(1.0 - z * z)
    return np.array([level * math.cos(turn), level * math.sin(turn), z])


def spread(number: int, count: int) -> list[float]:
    """Return the coordinates of a point among some that are spread evenly, 6 in 0..1 (Hammersley)."""
    return [*(_radical_inverse(number + 1, base) for base in _PRIMES), (number + 0.5) / count]


def _radical_inverse(number: int, base: int) -> float:
    result, scale = 0.0, 1.0 / base
    while number:
        number, digit = divmod(number, base)
        result += digit * scale
        scale /= base
    return result
