"""Studio light as a function of direction, also blurred by rough surfaces.

Directions are those of the studio: z up, the camera towards -y.
"""

import math
import struct
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array

_LOBE = 64  # directions in the average for the blur of a rough surface


def radiance(directions: Array) -> Array:
    """Return the brightness of the studio in unit directions, shape (n, 3) to (n,).

    A light tent with a dark front at the camera: softboxes and strips give metal long soft highlights, the
    gaps between them give contrast.
    """
    x, y, z = directions.T
    azimuth, elevation = (
        np.arctan2(x, y),
        np.arcsin(np.clip(z, -1.0, 1.0)),
    )  # azimuth 0 points away from the camera
    dome = 0.26 + 0.40 * _step(elevation, 0.0, 1.3)
    floor = 0.50 - 0.28 * _step(-elevation, 0.0, 0.9)
    light = np.where(z > 0.0, dome, floor)
    light -= 0.20 * _window(y, -1.3, -0.80, 0.2) * _window(z, -0.25, 0.3, 0.25)  # dark side of the camera
    light += 2.6 * _window(azimuth, -2.75, -1.75, 0.14) * _window(elevation, 0.25, 1.02, 0.12)  # key softbox
    light += 1.4 * _window(azimuth, 1.30, 1.72, 0.10) * _window(elevation, -0.05, 1.10, 0.15)  # strip, right
    light += 1.1 * _window(azimuth, -1.20, -0.92, 0.08) * _window(elevation, -0.05, 0.95, 0.15)  # strip, left
    light += 0.8 * _window(elevation, 1.22, 2.0, 0.12)  # ceiling
    light -= (
        0.16 * _window(azimuth, 1.95, 2.45, 0.1) * _window(elevation, -0.3, 0.9, 0.2)
    )  # flag next to the strip
    return light


def reflected(directions: Array, roughness: float) -> Array:
    """Return the reflection of a surface with a GGX roughness along directions, shape (n, 3) to (n,)."""
    if roughness < 0.03:
        return radiance(directions)
    number = np.arange(_LOBE) + 0.5
    alpha = roughness * roughness
    share = number / _LOBE
    cosine = np.sqrt((1.0 - share) / (1.0 + (alpha * alpha - 1.0) * share))
    sine = np.sqrt(1.0 - cosine * cosine)
    turn = number * (math.pi * (3.0 - math.sqrt(5.0)))
    # half vectors of a GGX lobe about z, and the reflected directions
    half = np.column_stack([sine * np.cos(turn), sine * np.sin(turn), cosine])
    mirrored = 2.0 * cosine[:, None] * half - np.array([0.0, 0.0, 1.0])
    weight = np.maximum(mirrored[:, 2], 0.0)
    aside = np.where(np.abs(directions[:, 2:]) < 0.9, [[0.0, 0.0, 1.0]], [[1.0, 0.0, 0.0]])
    across = np.cross(aside, directions)
    across /= np.linalg.norm(across, axis=1, keepdims=True)
    along = np.cross(directions, across)
    total = np.zeros(len(directions))
    for (u, v, w), share_of in zip(mirrored, weight, strict=True):
        if share_of > 0.0:
            total += share_of * radiance(u * across + v * along + w * directions)
    return np.asarray(total / weight.sum())


def sphere_map_coordinates(directions: Array) -> Array:
    """Return the sphere map coordinates of unit directions seen from -y, shape (n, 3) to (n, 2), in 0..1."""
    x, y, z = directions.T
    scale = 2.0 * np.sqrt(np.maximum(x * x + z * z + (1.0 - y) ** 2, 1e-9))
    return np.column_stack([x / scale + 0.5, z / scale + 0.5])


@lru_cache(maxsize=32)
def sphere_map(roughness: float, size: int = 96) -> Array:
    """Return the reflections for a roughness as a sphere map, shape (size, size), from the bottom."""
    u, v = np.meshgrid((np.arange(size) + 0.5) / size - 0.5, (np.arange(size) + 0.5) / size - 0.5)
    square = np.minimum(4.0 * (u * u + v * v), 0.9999)
    root = np.sqrt(1.0 - square)
    directions = np.stack([4.0 * u * root, 2.0 * square - 1.0, 4.0 * v * root], axis=-1).reshape(-1, 3)
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    return reflected(directions, roughness).reshape(size, size)


def sphere_directions(count: int) -> Array:
    """Return evenly spread unit directions, shape (count, 3)."""
    number = np.arange(count) + 0.5
    z = 1.0 - 2.0 * number / count
    turn = number * (math.pi * (3.0 - math.sqrt(5.0)))
    level = np.sqrt(1.0 - z * z)
    return np.column_stack([level * np.cos(turn), level * np.sin(turn), z])


def irradiance(normals: Array) -> Array:
    """Return the irradiance of surfaces divided by pi, shape (n, 3) to (n,)."""
    directions = sphere_directions(4096)
    cosine = np.maximum(normals @ directions.T, 0.0)
    return np.asarray(cosine @ radiance(directions) * (4.0 / len(directions)))


def _step(value: Array, low: float, high: float) -> Array:
    share = np.clip((value - low) / (high - low), 0.0, 1.0)
    return np.asarray(share * share * (3.0 - 2.0 * share))


def _window(value: Array, low: float, high: float, edge: float) -> Array:
    """Return 1 between two values and 0 outside, with soft edges."""
    return _step(value, low - edge, low + edge) * (1.0 - _step(value, high - edge, high + edge))


_SIZE = 64  # texels along an edge of the sharpest cube
_LEVELS = 5
_FILL = 0.3  # brightness relative to a wall with this irradiance
_R11F_G11F_B10F = 0x8C3A
_RGB = 0x1907
_HEADER = b"\xabKTX 11\xbb\r\n\x1a\n"


@lru_cache(maxsize=1)
def image_light() -> bytes:
    """Return the studio as a KTX file: a cube map with increasing blur per level, and its irradiance."""
    harmonics = "".join(f"{each:.6g} {each:.6g} {each:.6g}\n" for each in _harmonics()).encode() + b"\0"
    entry = b"sh\0" + harmonics
    entry = struct.pack("<I", len(entry)) + entry
    entry += b"\0" * (-len(entry) % 4)
    fields = (
        0x04030201,
        _R11F_G11F_B10F,
        1,
        _RGB,
        _R11F_G11F_B10F,
        _R11F_G11F_B10F,
        _SIZE,
        _SIZE,
        0,
        0,
        6,
        _LEVELS,
        len(entry),
    )
    parts = [_HEADER, struct.pack("<13I", *fields), entry]
    for level in range(_LEVELS):
        size = _SIZE >> level
        share = level / (_LEVELS - 1)
        # Filament uses the level of a roughness r at r * (2 - r)
        roughness = 1.0 - (1.0 - share) ** 0.5
        texels = _packed(reflected(_cube(size), roughness))
        parts += [struct.pack("<I", texels.nbytes // 6), texels.tobytes()]
    return b"".join(parts)


def _studio(directions: Array) -> Array:
    """Convert directions of Filament's images, with y up, to those of the studio."""
    x, y, z = directions.T
    return np.column_stack([x, -z, y])


def _cube(size: int) -> Array:
    """Return the studio directions of a cube map's texels, shape (6 * size * size, 3)."""
    place = (np.arange(size) + 0.5) / size * 2.0 - 1.0
    right, down = np.meshgrid(place, place)
    one = np.ones_like(right)
    faces = (
        (one, -down, -right),
        (-one, -down, right),
        (right, one, down),
        (right, -one, -down),
        (right, -down, one),
        (-right, -down, -one),
    )
    directions = np.stack([np.stack(face, axis=-1) for face in faces]).reshape(-1, 3)
    return _studio(directions / np.linalg.norm(directions, axis=1, keepdims=True))


def _harmonics() -> Array:
    """Return the factors of Filament's nine irradiance polynomials of a normal."""
    normals = sphere_directions(600)
    x, y, z = normals.T
    basis = np.column_stack([np.ones_like(x), y, z, x, y * x, y * z, 3.0 * z * z - 1.0, z * x, x * x - y * y])
    factors: Array = np.linalg.lstsq(basis, _falling(_studio(normals)), rcond=None)[0]
    return factors


def _falling(normals: Array) -> Array:
    """Return the incident light: the studio's, and a fill light that metals do not mirror."""
    return irradiance(normals) + _FILL * np.maximum(-normals[:, 1], 0.0)


def _packed(light: Array) -> NDArray[np.uint32]:
    """Return grey light as floats of 11, 11 and 10 bits."""
    bits = np.minimum(light, 60000.0).astype(np.float16).view(np.uint16).astype(np.uint32)
    return ((bits >> 4) | ((bits >> 4) << 11) | ((bits >> 5) << 22)).astype("<u4")
