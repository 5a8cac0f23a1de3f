"""Folders of temporary exports."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

_MEMORY = Path("/dev/shm")  # noqa: S108 - faster than a disk


@contextmanager
def memory_folder(within: Path | None = None) -> Iterator[Path]:
    """Yield a temporary folder, in memory where possible, or in a given folder."""
    place = within or (_MEMORY if _MEMORY.is_dir() else None)
    with TemporaryDirectory(prefix="artgen_", dir=place) as folder:
        yield Path(folder)
