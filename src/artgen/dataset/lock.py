"""A folder, or a file that grows, is written by one run at a time."""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from artgen.errors import ExportError

LOCK_FILE = ".lock"


@contextmanager
def locked(place: Path) -> Iterator[None]:
    """Hold the lock of a folder or a file; the system frees it when the process ends, however it does."""
    kind = "folder" if place.is_dir() else "file"
    lock = place / LOCK_FILE if kind == "folder" else place.with_name(f".{place.name}{LOCK_FILE}")
    try:
        descriptor = os.open(lock, os.O_RDWR | os.O_CREAT, 0o644)
    except OSError as error:
        raise ExportError(f"cannot write to {place}: {error.strerror}") from error
    with os.fdopen(descriptor, "r+", encoding="ascii") as file:
        try:
            _take(descriptor)
        except OSError as error:
            holder = file.read().strip() or "unknown"
            raise ExportError(
                f"another run (process {holder}) writes to {place}; wait until it is done, or choose "
                f"another {kind}"
            ) from error
        file.truncate(0)
        file.write(str(os.getpid()))
        file.flush()
        try:
            yield
        finally:
            file.seek(0)
            file.truncate(0)


def _take(descriptor: int) -> None:
    """Lock an open file, or raise an OSError at once."""
    if os.name == "nt":
        import msvcrt

        msvcrt.locking(descriptor, msvcrt.LK_NBLCK, 1)  # type: ignore[attr-defined]
    else:
        import fcntl

        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
