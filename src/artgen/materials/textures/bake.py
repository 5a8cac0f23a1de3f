"""Baking of a recipe's pattern to pixels in the recipe's own color, cached in memory and on disk."""

import hashlib
import threading
import zlib
from collections import OrderedDict
from collections.abc import Callable, Hashable
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from artgen import _disk_cache as disk_cache
from artgen._arrays import Array, cached
from artgen.errors import ExportError
from artgen.materials.textures.fields import Recipe, in_strips

Pixels = NDArray[np.uint8]
Value = TypeVar("Value")

_KIND = "textures"
_DARKEST, _BRIGHTEST = 0.012, 0.92  # albedo range of real surfaces


class Memory:
    """A least-recently-used cache with a limit in bytes."""

    def __init__(self, limit: int) -> None:
        self.limit = limit
        self._kept: OrderedDict[Hashable, tuple[Any, int]] = OrderedDict()
        self._total = 0
        self._lock = threading.Lock()

    def get(self, key: Hashable, make: Callable[[], Value], weigh: Callable[[Value], int]) -> Value:
        """Return the value of a key; compute and store it if it is missing."""
        with self._lock:
            if key in self._kept:
                self._kept.move_to_end(key)
                found: Value = self._kept[key][0]
                return found
        made = make()
        weight = weigh(made)
        with self._lock:
            self._total += weight - self._kept.pop(key, (None, 0))[1]
            self._kept[key] = (made, weight)
            while self._total > self.limit and len(self._kept) > 1:
                self._total -= self._kept.popitem(last=False)[1][1]
        return made

    def clear(self) -> None:
        """Remove all values."""
        with self._lock:
            self._kept.clear()
            self._total = 0


MEMORY = Memory(96 * 2**20)
"""Maps and files of recent assets: 19 % of requests miss, 18 % with four times the memory."""


@dataclass(frozen=True, eq=False)
class Maps:
    """The maps of a material; row 0 is the top.

    Attributes:
        albedo: sRGB, shape (n, n, 3); None if it is uniform, equal to the material's `base_color`.
        roughness: 0..255 for 0..1, shape (n, n).
        metalness: 0..255 for 0..1, shape (n, n); None if it is uniform.
        normal: Tangent space, y towards greater v (OpenGL), shape (n, n, 3); None for a smooth surface.
    """

    albedo: Pixels | None
    roughness: Pixels
    metalness: Pixels | None
    normal: Pixels | None

    @property
    def arrays(self) -> dict[str, Pixels]:
        """The existing maps by name."""
        return {name: pixels for name, pixels in vars(self).items() if pixels is not None}


def baked(recipe: Recipe, variant: int, size: int) -> Maps:
    """Return a recipe's maps; maps of cached recipes are computed once for all processes."""
    return MEMORY.get(
        (recipe, variant, size),
        lambda: _stored(recipe, variant, size) if recipe.cached else bake(recipe, variant, size),
        lambda made: sum(pixels.nbytes for pixels in made.arrays.values()),
    )


def _stored(recipe: Recipe, variant: int, size: int) -> Maps:
    """Return a recipe's maps from disk, or compute and store them."""
    name = f"{recipe.name}_{variant}_{size}"
    stored = disk_cache.unpacked(read(name, "npz"))
    if stored is not None:
        found: dict[str, Any] = {each.name: stored.get(each.name) for each in fields(Maps)}
        return Maps(**found)
    made = bake(recipe, variant, size)
    write(name, "npz", disk_cache.packed(made.arrays))
    return made


def bake(recipe: Recipe, variant: int, size: int) -> Maps:
    """Compute a recipe's maps; the roughness is the deviation from the material's, plus 128."""
    stream = np.random.default_rng(np.random.SeedSequence([zlib.crc32(recipe.name.encode()), variant]))
    pattern = recipe.make(stream, size)
    return Maps(
        None if pattern.albedo is None else in_strips(_colored, pattern.albedo),
        as_bytes(pattern.roughness + 128 / 255),
        None if pattern.metalness is None else as_bytes(pattern.metalness),
        None if pattern.height is None else _normals(pattern.height, recipe.tile),
    )


def as_bytes(values: Array) -> Pixels:
    """Return values in 0..1 as 0..255."""
    return np.rint(np.clip(values, 0.0, 1.0) * 255.0).astype(np.uint8)


def displayed(linear: ArrayLike) -> Array:
    """Encode linear values as sRGB."""
    light = np.clip(np.asarray(linear, float), 0.0, 1.0)
    return np.asarray(np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055))


def _colored(albedo: Array) -> Pixels:
    return as_bytes(displayed(np.clip(albedo, _DARKEST, _BRIGHTEST)))


def _normals(height: Array, tile: tuple[float, float]) -> Pixels:
    """Return the tangent-space normals of a relief [m] on a tile of a size [m]."""
    size = len(height)
    along_u = (np.roll(height, -1, axis=1) - np.roll(height, 1, axis=1)) * (size / (2.0 * tile[0]))
    along_v = (np.roll(height, 1, axis=0) - np.roll(height, -1, axis=0)) * (size / (2.0 * tile[1]))

    def leaning(along_u: Array, along_v: Array) -> Pixels:
        normals = np.stack([-along_u, -along_v, np.ones_like(along_u)], axis=-1)
        normals /= np.sqrt((normals**2).sum(axis=-1, keepdims=True))
        return as_bytes((normals * 127.0 + 128.0) / 255.0)

    return in_strips(leaning, along_u, along_v)


@cached(1)
def _version() -> str:
    """Return a digest of everything that determines the bytes of maps; empty if it cannot be computed."""
    import PIL

    found = hashlib.sha256(f"{np.__version__} {PIL.__version__} {zlib.ZLIB_RUNTIME_VERSION}".encode())
    try:
        for path in sorted(Path(__file__).parent.glob("*.py")):
            found.update(path.name.encode() + b"\0" + path.read_bytes())
    except OSError:
        return ""
    return found.hexdigest()[:16]


def read(name: str, suffix: str) -> bytes | None:
    """Return a file on disk by name, written by this version of the code, or None."""
    return disk_cache.read(_KIND, f"{name}_{_version()}.{suffix}") if _version() else None


def write(name: str, suffix: str, content: bytes) -> None:
    """Store content on disk by name for this version of the code.

    Raises:
        ExportError: The folder of the cache cannot be written.
    """
    if not _version():
        return
    try:
        disk_cache.write(_KIND, f"{name}_{_version()}.{suffix}", content)
    except OSError as error:
        reason = error.strerror or str(error)
        raise ExportError(
            f"textures cannot be written to {disk_cache.cache_directory()}: {reason}; "
            "set ARTGEN_CACHE to a folder that can be written, or to 'off'"
        ) from error
