"""Places of datasets: a folder on a disk, or a URL that fsspec can open, such as `s3://bucket/set`.

One run at a time writes to a place. On a disk, an asset is written below `.staging` and then renamed, so that
its directory is complete or absent. Object stores have no renaming, links or locks. Therefore the
`asset.json` of an asset is written last, a directory without it counts as absent, and an object with the name
of the process marks a run.
"""

import atexit
import os
import re
import shutil
import socket
import tempfile
import time
import uuid
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
from datetime import UTC, datetime
from pathlib import Path, PurePosixPath
from typing import Any
from urllib.parse import urlsplit
from urllib.request import url2pathname

from artgen._arrays import cached_property
from artgen._names import checked_path, inside
from artgen.asset.files import ASSET_FILE
from artgen.errors import ExportError
from artgen.export.files import write_file, write_files

PLAN_FILE = "dataset.json"
LOCK_FILE = ".lock"
STAGING = ".staging"
TEXTURE_DIRECTORY = "textures"

RESUME = "finished work stays, and the same command continues the run"  # ends messages about interruptions

_ONE_SLASH = re.compile(r"[a-z][a-z0-9+]+:/(?!/)")  # a scheme, which is longer than the name of a drive
_INTERVAL = 30.0  # time between two writes of a growing object in a store [s]


def _unseen(place: "Place") -> ExportError:
    """Return the error of a worker without access to the place of the run."""
    return ExportError(
        f"process {os.getpid()} on {socket.gethostname()} does not see {place}; choose a folder or URL that "
        "all processes share"
    )


class Disk:
    """A folder on a disk; workers get a copy of this object. Paths are relative to it, with slashes."""

    links = True  # assets can share texture maps by links

    def __init__(self, path: Path) -> None:
        self.path = path
        self._staging = path / STAGING  # assets are written here; the folder exists during a run only

    def __str__(self) -> str:
        return str(self.path)

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
        if self.path.is_file():
            raise ExportError(f"cannot write a dataset to {self}: it is a file; choose another folder")
        found = self.path.iterdir() if self.path.exists() else ()
        return [each.name for each in found if each.name not in (LOCK_FILE, STAGING)]

    def read(self, path: str) -> bytes | None:
        """Return the content of a file; None if there is none."""
        return self.contents([path]).get(path)

    def contents(self, paths: Iterable[str]) -> dict[str, bytes]:
        """Return the contents of the existing files."""
        found = {}
        for path in paths:
            try:
                found[path] = (self.path / path).read_bytes()
            except (FileNotFoundError, NotADirectoryError):
                continue
            except OSError as error:
                raise ExportError(f"cannot read {self.path / path}: {error.strerror or error}") from error
        return found

    def complete(self, paths: Iterable[str]) -> set[str]:
        """Return the directories that have an `asset.json`."""
        return {path for path in paths if (self.path / path / ASSET_FILE).is_file()}

    def write(self, path: str, content: bytes) -> None:
        """Write a file, which is complete or absent."""
        write_file(inside(self.path, path), content)

    def append(self, path: str, line: str) -> None:
        """Add a line to a file, on the disk at once."""
        with (self.path / path).open("a", encoding="utf-8", newline="\n") as file:
            file.write(line)

    def put(self, files: Mapping[str, bytes], path: str, *, share: bool) -> None:
        """Put an asset in its directory, which is complete or absent; an existing one stays."""
        if not self._staging.is_dir():  # another machine would create its own folder
            raise _unseen(self)
        made, place = self._staging / uuid.uuid4().hex, inside(self.path, path)
        store = self.path / TEXTURE_DIRECTORY if share else None
        if store is not None:
            store.mkdir(exist_ok=True)
        write_files(files, made, store)
        place.parent.mkdir(parents=True, exist_ok=True)
        try:
            made.rename(place)
        except OSError as error:
            if not place.exists():
                raise
            if not (place / ASSET_FILE).is_file():
                raise ExportError(f"it exists, but has no {ASSET_FILE}: remove it") from error
            shutil.rmtree(made, ignore_errors=True)

    def local(self, path: str) -> Path:
        """Return the directory of an asset on this machine."""
        return inside(self.path, path)


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
            _lock(descriptor)
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


def _lock(descriptor: int) -> None:
    """Lock an open file, or raise an OSError at once."""
    if os.name == "nt":
        import msvcrt

        msvcrt.locking(descriptor, msvcrt.LK_NBLCK, 1)  # type: ignore[attr-defined]
    else:
        import fcntl

        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)


class Store:
    """A place at a URL, with the methods of `Disk`; fsspec finds the credentials."""

    links = False

    def __init__(self, url: str) -> None:
        self.url = url.rstrip("/")
        self._growing: dict[str, bytearray] = {}  # content of growing objects, of which some is not written
        self._written = time.monotonic()
        with self._named_errors():
            try:
                from fsspec.core import url_to_fs
            except ImportError as error:
                raise ExportError(f"{url} needs fsspec: pip install 'artgen[url]'") from error
            try:
                self._root = url_to_fs(self.url)[1].rstrip("/")
            except (ImportError, ValueError) as error:  # unknown protocol, or its package is missing
                raise ExportError(f"{url} cannot be opened: {error}") from error
            self._files.invalidate_cache()  # other processes write to it as well

    def __str__(self) -> str:
        return self.url

    def __reduce__(self) -> tuple[type["Store"], tuple[str]]:
        """Pickle the URL only: another process makes its own connections and cache."""
        return Store, (self.url,)

    @contextmanager
    def opened(self) -> Iterator[None]:
        """Hold the place for one run."""
        since = datetime.now(UTC).isoformat(timespec="seconds")
        run = f"process {os.getpid()} on {socket.gethostname()}, since {since}, run {uuid.uuid4().hex}"
        owner = run.encode()
        with self._named_errors():
            self._own(owner)
        try:
            yield
        finally:
            with self._named_errors():
                try:
                    self._flush()
                finally:
                    if self.read(LOCK_FILE) == owner:
                        self._files.rm_file(self._at(LOCK_FILE))

    def names(self) -> list[str]:
        """Return the names of the files and folders in the place, without those of the run."""
        with self._named_errors():
            try:
                found = self._files.ls(self._root, detail=True)
            except FileNotFoundError:
                return []
            own = [each["type"] for each in found if each["name"].strip("/") == self._root.strip("/")]
            if own == ["file"]:
                raise ExportError(f"cannot write a dataset to {self}: it is a file; choose another place")
        names = [each["name"].rstrip("/").rpartition("/")[2] for each in found]
        return [name for name in names if name and name != LOCK_FILE]

    def read(self, path: str) -> bytes | None:
        """Return the content of a file; None if there is none."""
        return self.contents([path]).get(path)

    def contents(self, paths: Iterable[str]) -> dict[str, bytes]:
        """Return the contents of the existing files."""
        places = {self._at(path): path for path in paths}
        if not places:
            return {}
        with self._named_errors():
            found = self._files.cat(list(places), on_error="return")
            for content in found.values():
                if isinstance(content, Exception) and not isinstance(content, FileNotFoundError):
                    raise content
        return {places[at]: content for at, content in found.items() if isinstance(content, bytes)}

    def complete(self, paths: Iterable[str]) -> set[str]:
        """Return the directories that have an `asset.json`."""
        with self._named_errors():
            self._files.invalidate_cache()
            there = set(self._files.find(self._root))
        return {path for path in paths if self._at(f"{path}/{ASSET_FILE}") in there}

    def write(self, path: str, content: bytes) -> None:
        """Write a file, which is complete or absent."""
        with self._named_errors():
            self._pipe({path: content})
        self._growing.pop(path, None)
        self._written = time.monotonic()

    def append(self, path: str, line: str) -> None:
        """Add a line to a file; it is written as a whole at intervals, because objects cannot grow."""
        if path not in self._growing:
            self._growing[path] = bytearray(self.read(path) or b"")
        self._growing[path] += line.encode()
        if time.monotonic() - self._written > _INTERVAL:
            self._flush()

    def _flush(self) -> None:
        for path, content in list(self._growing.items()):
            self.write(path, bytes(content))

    def put(self, files: Mapping[str, bytes], path: str, *, share: bool) -> None:
        """Put an asset in its directory, which is complete or counts as absent."""
        with self._named_errors():
            if not self._files.exists(self._at(PLAN_FILE)):
                raise _unseen(self)
            self._pipe({f"{path}/{name}": files[name] for name in files if name != ASSET_FILE})
            self._pipe({f"{path}/{ASSET_FILE}": files[ASSET_FILE]})

    def local(self, path: str) -> Path:
        """Return the directory of an asset on this machine, fetched once."""
        place = inside(self._cache, path)
        if not place.exists():
            with self._named_errors():
                names = self._files.find(self._at(path))
            start = len(self._at(path)) + 1
            files = self.contents([f"{path}/{name[start:]}" for name in names])
            if f"{path}/{ASSET_FILE}" not in files:
                raise ExportError(f"{self}/{path} holds no {ASSET_FILE}; generate the dataset again")
            partial = self._cache / uuid.uuid4().hex
            write_files({name.removeprefix(f"{path}/"): files[name] for name in files}, partial)
            place.parent.mkdir(parents=True, exist_ok=True)
            with suppress(OSError):  # another thread was faster
                partial.rename(place)
        return place

    @property
    def _files(self) -> Any:
        """The file system; fsspec caches it, and reconnects in a forked process."""
        from fsspec.core import url_to_fs

        return url_to_fs(self.url)[0]

    @cached_property
    def _cache(self) -> Path:
        """Folder of fetched assets, removed at the exit of the process: assets read surfaces late."""
        folder, process = tempfile.mkdtemp(prefix="artgen_"), os.getpid()

        def remove() -> None:
            if os.getpid() == process:  # not in a fork
                shutil.rmtree(folder, ignore_errors=True)

        atexit.register(remove)
        return Path(folder)

    def _at(self, path: str) -> str:
        return f"{self._root}/{path}" if self._root else path

    def _pipe(self, files: Mapping[str, bytes]) -> None:
        content = {self._at(path): each for path, each in files.items()}
        self._in_folders(files, lambda: self._files.pipe(content))

    def _in_folders(self, paths: Iterable[str], write: Callable[[], None]) -> None:
        """Write files; create their folders in stores with folders."""
        try:
            write()
        except FileNotFoundError:
            parents = {self._at(str(each)) for path in paths for each in PurePosixPath(path).parents[:-1]}
            for folder in sorted({self._root, *parents} - {""}):  # parents first
                with suppress(FileExistsError):
                    self._files.mkdir(folder, create_parents=False)  # a missing bucket is a mistake
            write()

    def _own(self, owner: bytes) -> None:
        """Mark the place as held by this run; raise ExportError if another run holds it."""
        other = self.read(LOCK_FILE)
        if other is None:
            try:
                self._create(LOCK_FILE, owner)
            except FileExistsError:
                other = self.read(LOCK_FILE) or owner
            else:
                other = self.read(LOCK_FILE)  # the last writer wins if a store cannot refuse
        if other != owner:
            holder = (other or b"unknown").decode(errors="replace")
            raise ExportError(
                f"another run ({holder}) writes to {self}; wait until it is done, or choose "
                f"another place; if it was killed, remove {self}/{LOCK_FILE} and run the same command again"
            )

    def _create(self, path: str, content: bytes) -> None:
        """Write a file; raise FileExistsError if it exists, where the store supports that."""

        def write() -> None:
            with self._files.open(self._at(path), "xb") as file:
                file.write(content)

        try:
            self._in_folders([path], write)
        except (NotImplementedError, ValueError, TypeError):  # the mode is not supported
            self._pipe({path: content})

    @contextmanager
    def _named_errors(self) -> Iterator[None]:
        """Convert any error of a store to an ExportError that names the place."""
        try:
            yield
        except ExportError:
            raise
        except Exception as error:  # each package has its own errors
            reason = " ".join(str(error).split()) or type(error).__name__
            raise ExportError(
                f"{self} cannot be used: {reason}; check the URL and its credentials"
            ) from error


def is_url(place: str | Path) -> bool:
    """Tell whether a place is a URL; `file:` is one, and so are chained URLs, such as `zip::s3://x`."""
    return isinstance(place, str) and ("://" in place or "::" in place)


Place = Disk | Store


def place_of(path: str | Path) -> Place:
    """Return the place of a folder or URL.

    Raises:
        ParameterError: It is neither.
        ExportError: The URL names a folder of another machine, or is incomplete.
    """
    checked_path(path, "directory")
    if isinstance(path, str) and _ONE_SLASH.match(path):
        raise ExportError(f"{path} is no URL: write {path.replace(':', ':/', 1)}, with two slashes")
    if isinstance(path, Path) or not is_url(path):
        return Disk(Path(path).absolute())
    parts = urlsplit(path)
    if parts.scheme != "file":
        return Store(path)
    if parts.netloc not in ("", "localhost"):
        raise ExportError(
            f"{path} names a folder of another machine ({parts.netloc!r}): a folder of this one is "
            "file:///PATH, with three slashes"
        )
    return Disk(Path(url2pathname(parts.path)))
