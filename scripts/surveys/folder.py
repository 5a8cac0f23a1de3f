"""Where exports of a moment go."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

_MEMORY = Path("/dev/shm")  # noqa: S108 - no disk is asked for what is read once


@contextmanager
def memory_folder(within: Path | None = None) -> Iterator[Path]:
    """Give a folder of its own, in memory where there is such a place, and remove it.

    Args:
        within: The folder in which it is made instead.
    """
    place = within or (_MEMORY if _MEMORY.is_dir() else None)
    with TemporaryDirectory(prefix="artgen_", dir=place) as folder:
        yield Path(folder)
