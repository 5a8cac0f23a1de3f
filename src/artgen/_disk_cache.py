"""Disk cache for files that are expensive to compute, shared by all processes of a user.

The folder is `$ARTGEN_CACHE`, `$XDG_CACHE_HOME/artgen` or `~/.cache/artgen`; `ARTGEN_CACHE=off` disables the
cache. A file is first written under a temporary name, so that other processes see all of it or nothing. It
begins with a checksum: a damaged file counts as missing.
"""

import io
import os
import tempfile
import zlib
from contextlib import suppress
from pathlib import Path
from typing import Any
from zipfile import BadZipFile

import numpy as np
from numpy.typing import NDArray

_HEAD = b"artgen-cache-1\n"
_CHECK = 12  # bytes of checksum and length


def cache_directory() -> Path | None:
    """Return the folder of the cache, or None if the cache is off or the user has no home directory."""
    try:
        if chosen := os.environ.get("ARTGEN_CACHE"):
            return None if chosen == "off" else Path(chosen).expanduser()
        shared = os.environ.get("XDG_CACHE_HOME", "")
        if Path(shared).is_absolute():  # relative paths must be ignored according to the specification
            return Path(shared) / "artgen"
        return Path.home() / ".cache" / "artgen"
    except RuntimeError:
        return None


def read(kind: str, key: str) -> bytes | None:
    """Return the content of a kind under a key; None if it is missing or damaged."""
    directory = cache_directory()
    if directory is None:
        return None
    try:
        stored = (directory / kind / key).read_bytes()
    except OSError:
        return None
    start = len(_HEAD) + _CHECK
    content = stored[start:]
    return content if stored[:start] == _head(content) else None


def write(kind: str, key: str, content: bytes) -> None:
    """Store content of a kind under a key, if the cache is enabled."""
    directory = cache_directory()
    if directory is None:
        return
    path = directory / kind / key
    path.parent.mkdir(parents=True, exist_ok=True)
    handle, name = tempfile.mkstemp(prefix=f".{key[:16]}.", suffix=".part", dir=path.parent)
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(_head(content))
            file.write(content)
        Path(name).replace(path)
    except BaseException:
        with suppress(OSError):
            Path(name).unlink()
        raise


def packed(arrays: dict[str, NDArray[Any]]) -> bytes:
    """Return arrays as the content of a file for `unpacked`."""
    file = io.BytesIO()
    np.savez(file, allow_pickle=False, **arrays)
    return file.getvalue()


def unpacked(content: bytes | None) -> dict[str, NDArray[Any]] | None:
    """Return the arrays in the content of a file; None if it is missing or invalid."""
    try:
        with np.load(io.BytesIO(content or b""), allow_pickle=False) as stored:
            return dict(stored)
    except (OSError, ValueError, KeyError, EOFError, BadZipFile, zlib.error):
        return None


def _head(content: bytes) -> bytes:
    return _HEAD + zlib.crc32(content).to_bytes(4, "little") + len(content).to_bytes(8, "little")
