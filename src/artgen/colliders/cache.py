"""Pieces that took long to find, kept on disk by a digest of what they were found of.

They lie where `artgen._disk_cache` says. The files hold numbers only. Where one cannot be read or written,
nothing is said: the pieces are found again.
"""

import hashlib
import io
import json
import zlib
from collections.abc import Mapping, Sequence
from contextlib import suppress
from zipfile import BadZipFile

import numpy as np
from numpy.typing import NDArray

from artgen import _disk_cache as disk_cache
from artgen._arrays import Array
from artgen._disk_cache import cache_directory

__all__ = ["cache_directory", "digest", "read_points", "write_points"]

_FORMAT = "artgen-pieces-1"
_DAMAGED = (OSError, ValueError, KeyError, EOFError, BadZipFile, zlib.error)  # what a damaged file raises


def digest(vertices: Array, triangles: NDArray[np.int64], settings: Mapping[str, float | str]) -> str:
    """Return a digest of a mesh, as its numbers are, and of how its pieces are found."""
    head = {"format": _FORMAT, "vertices": len(vertices), "triangles": len(triangles), **settings}
    found = hashlib.sha256(json.dumps(head, sort_keys=True).encode())
    found.update(np.ascontiguousarray(vertices, "<f8").tobytes())
    found.update(np.ascontiguousarray(triangles, "<i8").tobytes())
    return found.hexdigest()


def read_points(kind: str, key: str) -> list[Array] | None:
    """Return the points of the pieces that are kept under a key, each shape (n, 3) [m], or None."""
    content = disk_cache.read(kind, f"{key}.npz")
    if content is None:
        return None
    try:
        with np.load(io.BytesIO(content), allow_pickle=False) as stored:
            points, counts = stored["points"], stored["counts"]
    except _DAMAGED:
        return None
    sound = (
        points.dtype == np.float64
        and counts.dtype == np.int64
        and points.shape == (counts.sum(), 3)
        and counts.ndim == 1
        and bool((counts > 0).all())
        and bool(np.isfinite(points).all())
    )
    return np.split(points, np.cumsum(counts)[:-1]) if sound else None


def write_points(kind: str, key: str, pieces: Sequence[Array]) -> None:
    """Keep the points of pieces, each shape (n, 3) [m], under a key; other processes see all or nothing."""
    if not pieces:
        return
    counts = np.array([len(points) for points in pieces], np.int64)
    with suppress(OSError):
        file = io.BytesIO()
        np.savez(file, points=np.concatenate(pieces).astype(np.float64), counts=counts)
        disk_cache.write(kind, f"{key}.npz", file.getvalue())
