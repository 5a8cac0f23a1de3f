"""A dataset in a folder of a disk, with one writing run at a time.

An asset is written below `.staging` and then renamed, so that its directory is complete or absent.
"""

import os
import shutil
import socket
import uuid
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path

from artgen._names import inside
from artgen.asset.files import ASSET_FILE
from artgen.errors import ExportError
from artgen.export.files import write_files

PLAN_FILE = "dataset.json"
LOCK_FILE = ".lock"
STAGING = ".staging"
TEXTURE_DIRECTORY = "textures"

GO_ON = "what is done stays, and the same command goes on from there"
"""The end of each message about an interrupted run."""


class Disk:
    """A folder on a disk; workers get a copy of this object. Paths are relative to the folder, with slashes.

    Attributes:
        path: The folder.
        links: Whether assets can share texture maps by links.
    """

    links = True

    def __init__(self, path: Path) -> None:
        self.path = path
        self._staging = path / STAGING  # assets are written here; the folder exists during a run only

    def __str__(self) -> str:
        return str(self.path)

    def absolute(self) -> "Disk":
        """Return the place for processes with another working directory."""
        return Disk(self.path.absolute())

    @contextmanager
    def opened(self) -> Iterator[None]:
        """Hold the place for one run; create it if necessary, and remove the remains of a killed run."""
        self.path.mkdir(parents=True, exist_ok=True)
        with locked(self.path):
            shutil.rmtree(self._staging, ignore_errors=True)
            self._staging.mkdir()
            try:
                yield
            finally:
                shutil.rmtree(self._staging, ignore_errors=True)

    def names(self) -> list[str]:
        """Return the names of the files and folders in the place, without those of the run."""
        if not self.path.exists():
            return []
        if not self.path.is_dir():
            raise ExportError(f"cannot write a dataset to {self}: it is a file; choose another folder")
        return [each.name for each in self.path.iterdir() if each.name not in (LOCK_FILE, STAGING)]

    def read(self, path: str) -> bytes | None:
        """Return the content of a file; None if there is none."""
        return self.contents([path]).get(path)

    def contents(self, paths: Iterable[str]) -> dict[str, bytes]:
        """Return the contents of the existing files."""
        found = {}
        for path in paths:
            with suppress(FileNotFoundError, NotADirectoryError):
                found[path] = (self.path / path).read_bytes()
        return found

    def write(self, path: str, content: bytes) -> None:
        """Write a file, which is complete or absent."""
        place = inside(self.path, path)
        place.parent.mkdir(exist_ok=True)
        partial = place.with_name(f".{place.name}.partial")
        try:
            partial.write_bytes(content)
            partial.replace(place)
        except BaseException:
            with suppress(OSError):
                partial.unlink(missing_ok=True)
            raise

    def lines(self, path: str, text: str) -> "Lines":
        """Open a file that grows by one line at a time."""
        self.write(path, text.encode())
        return Lines(self.path / path)

    def complete(self, paths: Iterable[str]) -> set[str]:
        """Return the directories that have an `asset.json`."""
        return {path for path in paths if (self.path / path / ASSET_FILE).is_file()}

    def put(self, files: Mapping[str, bytes], path: str, *, share: bool) -> None:
        """Put an asset in its directory, which is complete or absent."""
        if not self._staging.is_dir():  # another machine would create its own folder
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


class Lines:
    """A file that grows; each line is on the disk after `add`."""

    def __init__(self, path: Path) -> None:
        self._file = path.open("a", encoding="utf-8", newline="\n")

    def add(self, line: str) -> None:
        """Add a line, which ends with a line break."""
        self._file.write(line)
        self._file.flush()

    def close(self) -> None:
        """Close the file."""
        self._file.close()


def unseen(place: object) -> ExportError:
    """Return the error of a worker without access to the place of the run."""
    return ExportError(
        f"process {os.getpid()} on {socket.gethostname()} does not see {place}; choose a folder or URL that "
        "all processes share"
    )


@contextmanager
def locked(place: Path) -> Iterator[None]:
    """Hold the lock of a folder or a file; the system releases it at the end of the process."""
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


def _put(made: Path, place: Path) -> None:
    """Put a complete directory in its place; an existing one stays."""
    place.parent.mkdir(parents=True, exist_ok=True)
    try:
        made.rename(place)
    except OSError:
        if not (place / ASSET_FILE).is_file():
            raise
        with suppress(OSError):
            shutil.rmtree(made)
