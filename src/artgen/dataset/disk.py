"""A dataset in a folder.

An asset is made below `.staging` and then renamed to its place, so that its directory is complete or absent.
"""

import shutil
import uuid
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TextIO

from artgen._names import inside
from artgen.asset.files import ASSET_FILE
from artgen.dataset.lock import locked
from artgen.dataset.target import LOCK_FILE, STAGING, TEXTURE_DIRECTORY, Target, unseen
from artgen.errors import ExportError
from artgen.export.files import write_files


class Disk(Target):
    """A folder on a disk; see `Target`.

    Attributes:
        path: Where it is.
    """

    links = True

    def __init__(self, path: Path) -> None:
        self.path = path

    def __str__(self) -> str:
        return str(self.path)

    def absolute(self) -> "Disk":
        """Return the place as processes with another working directory find it."""
        return Disk(self.path.absolute())

    @contextmanager
    def opened(self) -> Iterator[None]:
        """Hold the place for one run."""
        self.path.mkdir(parents=True, exist_ok=True)
        with locked(self.path):
            shutil.rmtree(self._staging, ignore_errors=True)
            self._staging.mkdir()
            try:
                yield
            finally:
                shutil.rmtree(self._staging, ignore_errors=True)

    def names(self) -> list[str]:
        """Return what lies directly in it."""
        if not self.path.exists():
            return []
        if not self.path.is_dir():
            raise ExportError(f"cannot write a dataset to {self}: it is a file; choose another folder")
        return [each.name for each in self.path.iterdir() if each.name not in (LOCK_FILE, STAGING)]

    def contents(self, paths: Iterable[str]) -> dict[str, bytes]:
        """Return what the files hold, of those that there are."""
        found = {}
        for path in paths:
            with suppress(FileNotFoundError, NotADirectoryError):
                found[path] = (self.path / path).read_bytes()
        return found

    def write(self, path: str, content: bytes) -> None:
        """Write a file, which nobody sees by half."""
        place = inside(self.path, path)
        place.parent.mkdir(exist_ok=True)
        partial = place.with_name(f".{place.name}.partial")
        partial.write_bytes(content)
        partial.replace(place)

    def lines(self, path: str, text: str) -> "_DiskLines":
        """Begin a file with some lines, to add others."""
        self.write(path, text.encode())
        return _DiskLines(self.path / path)

    def complete(self, paths: Iterable[str]) -> set[str]:
        """Return those directories that have an `asset.json`."""
        return {path for path in paths if (self.path / path / ASSET_FILE).is_file()}

    def put(self, files: Mapping[str, bytes], path: str, *, share: bool) -> None:
        """Put an asset in its directory."""
        if not self._staging.is_dir():  # else another machine would make a folder of its own
            raise unseen(self)
        made = self._staging / uuid.uuid4().hex
        store = self.path / TEXTURE_DIRECTORY if share else None
        if store is not None:
            store.mkdir(exist_ok=True)
        write_files(files, made, store)
        _put(made, inside(self.path, path))

    def local(self, path: str) -> Path:
        """Return the directory of an asset on this machine."""
        return inside(self.path, path)

    @property
    def _staging(self) -> Path:
        """Where assets are made before they are put in their places; there is one while a run goes on."""
        return self.path / STAGING


class _DiskLines:
    """Lines that are on the disk once they are added."""

    def __init__(self, path: Path) -> None:
        self._file: TextIO = path.open("a", encoding="utf-8", newline="\n")

    def add(self, line: str) -> None:
        self._file.write(line)
        self._file.flush()

    def close(self) -> None:
        self._file.close()


def _put(made: Path, place: Path) -> None:
    """Put a complete directory in its place; one that is there already, of an earlier run, stays."""
    place.parent.mkdir(parents=True, exist_ok=True)
    try:
        made.rename(place)
    except OSError:
        if not (place / ASSET_FILE).is_file():
            raise
        with suppress(OSError):
            shutil.rmtree(made)
