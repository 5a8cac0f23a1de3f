"""Baking: a recipe's pattern as pixels, in the recipe's own color, roughness as deviation about 128."""

import io
import zlib
from dataclasses import dataclass, fields
from typing import Any
from zipfile import BadZipFile

import numpy as np
from numpy.typing import ArrayLike, NDArray

from artgen.materials.textures import keep
from artgen.materials.textures.fields import Recipe, in_strips

Pixels = NDArray[np.uint8]

_DARKEST, _BRIGHTEST = 0.012, 0.92  # albedo that real surfaces have
_DAMAGED = (OSError, ValueError, KeyError, EOFError, BadZipFile, zlib.error)

MEMORY = keep.Memory(96 * 2**20)
"""Maps and files of the last assets: 19 % of requests miss, 18 % with four times the memory."""


@dataclass(frozen=True, eq=False)
class Maps:
    """The maps of a material; row 0 is the top.

    Attributes:
        albedo: sRGB, shape (n, n, 3); None where it is the material's `base_color` everywhere.
        roughness: 0..255 for 0..1, shape (n, n).
        metalness: 0..255 for 0..1, shape (n, n); None where it is the material's everywhere.
        normal: Tangent space, y towards greater v (OpenGL), shape (n, n, 3); None where the surface is even.
    """

    albedo: Pixels | None
    roughness: Pixels
    metalness: Pixels | None
    normal: Pixels | None

    @property
    def weight(self) -> int:
        """How many bytes they take."""
        return sum(pixels.nbytes for pixels in vars(self).values() if pixels is not None)


def baked(recipe: Recipe, variant: int, size: int) -> Maps:
    """Return a recipe's maps; they are made once for all processes where the recipe is kept."""
    return MEMORY.get((recipe, variant, size), lambda: _kept(recipe, variant, size), lambda made: made.weight)


def _kept(recipe: Recipe, variant: int, size: int) -> Maps:
    if not recipe.kept:
        return bake(recipe, variant, size)
    name = f"{recipe.name}_{variant}_{size}"
    made = _unpacked(keep.read(name, "npz"), size)
    if made is None:
        made = bake(recipe, variant, size)
        keep.write(name, "npz", _packed(made))
    return made


def bake(recipe: Recipe, variant: int, size: int) -> Maps:
    """Make a recipe's maps."""
    stream = np.random.default_rng(np.random.SeedSequence([zlib.crc32(recipe.name.encode()), variant]))
    pattern = recipe.make(stream, size)
    return Maps(
        None if pattern.albedo is None else in_strips(_colored, pattern.albedo),
        as_bytes(pattern.roughness + 128 / 255),
        None if pattern.metalness is None else as_bytes(pattern.metalness),
        None if pattern.height is None else _normals(pattern.height, recipe.tile),
    )


def as_bytes(values: NDArray[np.float64]) -> Pixels:
    """Return values in 0..1 as 0..255."""
    return np.rint(np.clip(values, 0.0, 1.0) * 255.0).astype(np.uint8)


def displayed(linear: ArrayLike) -> NDArray[np.float64]:
    """Encode linear values as sRGB."""
    light = np.clip(np.asarray(linear, float), 0.0, 1.0)
    return np.asarray(np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055))


def _colored(albedo: NDArray[np.float64]) -> Pixels:
    return as_bytes(displayed(np.clip(albedo, _DARKEST, _BRIGHTEST)))


def _normals(height: NDArray[np.float64], tile: tuple[float, float]) -> Pixels:
    """Return the tangent-space normals of a relief [m] over a tile of that size [m]."""
    size = len(height)
    along_u = (np.roll(height, -1, axis=1) - np.roll(height, 1, axis=1)) * (size / (2.0 * tile[0]))
    along_v = (np.roll(height, 1, axis=0) - np.roll(height, -1, axis=0)) * (size / (2.0 * tile[1]))

    def leaning(along_u: NDArray[np.float64], along_v: NDArray[np.float64]) -> Pixels:
        normals = np.stack([-along_u, -along_v, np.ones_like(along_u)], axis=-1)
        normals /= np.sqrt((normals**2).sum(axis=-1, keepdims=True))
        return as_bytes((normals * 127.0 + 128.0) / 255.0)

    return in_strips(leaning, along_u, along_v)


def _packed(made: Maps) -> bytes:
    file = io.BytesIO()
    np.savez(file, **{name: pixels for name, pixels in vars(made).items() if pixels is not None})
    return file.getvalue()


def _unpacked(content: bytes | None, size: int) -> Maps | None:
    """Return the maps that were kept, or None where there are none or they are damaged."""
    if content is None:
        return None
    try:
        with np.load(io.BytesIO(content), allow_pickle=False) as stored:
            found: dict[str, Any] = {field.name: stored.get(field.name) for field in fields(Maps)}
    except _DAMAGED:
        return None
    sound = found["roughness"] is not None and all(
        pixels is None or (pixels.dtype == np.uint8 and pixels.shape[:2] == (size, size))
        for pixels in found.values()
    )
    return Maps(**found) if sound else None
