"""Caches of maps: recent ones in memory, those of the library on disk."""

import hashlib
import threading
import zlib
from collections import OrderedDict
from collections.abc import Callable, Hashable
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from artgen import _disk_cache as disk_cache
from artgen._arrays import cached
from artgen.errors import ExportError

_KIND = "textures"

Value = TypeVar("Value")


class Memory:
    """A least-recently-used cache with a limit in bytes."""

    def __init__(self, limit: int) -> None:
        self.limit = limit
        self._kept: OrderedDict[Hashable, tuple[Any, int]] = OrderedDict()
        self._total = 0
        self._lock = threading.Lock()

    def get(self, key: Hashable, make: Callable[[], Value], weigh: Callable[[Value], int]) -> Value:
        """Return the value under a key; make and keep it if it is missing."""
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
        """Forget everything."""
        with self._lock:
            self._kept.clear()
            self._total = 0


@cached(1)
def _version() -> str:
    """Return a digest of all that decides about the bytes of maps; empty where it cannot be found."""
    import PIL

    found = hashlib.sha256(f"{np.__version__} {PIL.__version__} {zlib.ZLIB_RUNTIME_VERSION}".encode())
    try:
        for path in sorted(Path(__file__).parent.glob("*.py")):
            found.update(path.name.encode() + b"\0" + path.read_bytes())
    except OSError:
        return ""
    return found.hexdigest()[:16]


def _key(name: str, suffix: str) -> str:
    return f"{name}_{_version()}.{suffix}"


def read(name: str, suffix: str) -> bytes | None:
    """Return the file on disk under a name, written by this version of the code, or None."""
    return disk_cache.read(_KIND, _key(name, suffix)) if _version() else None


def write(name: str, suffix: str, content: bytes) -> None:
    """Keep content on disk under a name for this version of the code."""
    if not _version():
        return
    try:
        disk_cache.write(_KIND, _key(name, suffix), content)
    except OSError as error:
        reason = error.strerror or str(error)
        raise ExportError(
            f"textures cannot be kept in {disk_cache.cache_directory()}: {reason}; "
            "set ARTGEN_CACHE to a folder that can be written, or to 'off'"
        ) from error
