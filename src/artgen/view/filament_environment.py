"""The studio's light as an image that Filament lights scenes by: a blurred cube map in a KTX file."""

import struct
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array
from artgen.view.environment import irradiance, reflected, sphere_directions

_SIZE = 64  # texels along an edge of the sharpest cube
_LEVELS = 5
_FILL = 0.3  # as bright as a wall that gives so much light
_R11F_G11F_B10F = 0x8C3A
_RGB = 0x1907
_HEADER = b"\xabKTX 11\xbb\r\n\x1a\n"


@lru_cache(maxsize=1)
def image_light() -> bytes:
    """Return the studio as a KTX file: a cube map blurred more from level to level, and its irradiance."""
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
        # Filament finds the level of a roughness r at r * (2 - r)
        roughness = 1.0 - (1.0 - share) ** 0.5
        texels = _packed(reflected(_cube(size), roughness))
        parts += [struct.pack("<I", texels.nbytes // 6), texels.tobytes()]
    return b"".join(parts)


def _studio(directions: Array) -> Array:
    """Turn directions of Filament's images, with y up, to the studio's."""
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
    """Return the factors of Filament's nine polynomials that give the irradiance of a normal."""
    normals = sphere_directions(600)
    x, y, z = normals.T
    basis = np.column_stack([np.ones_like(x), y, z, x, y * x, y * z, 3.0 * z * z - 1.0, z * x, x * x - y * y])
    factors: Array = np.linalg.lstsq(basis, _falling(_studio(normals)), rcond=None)[0]
    return factors


def _falling(normals: Array) -> Array:
    """Return the light that falls on surfaces: the studio's, and a fill light's that no metal mirrors."""
    return irradiance(normals) + _FILL * np.maximum(-normals[:, 1], 0.0)


def _packed(light: Array) -> NDArray[np.uint32]:
    """Return grey light as floats of 11, 11 and 10 bits."""
    bits = np.minimum(light, 60000.0).astype(np.float16).view(np.uint16).astype(np.uint32)
    return ((bits >> 4) | ((bits >> 4) << 11) | ((bits >> 5) << 22)).astype("<u4")
