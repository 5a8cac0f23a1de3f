"""A dataset at a URL that fsspec can open: `s3://bucket/set`, `gs://`, `sftp://`, ...

Object stores have no renaming, links or locks. Therefore the `asset.json` of an asset is written last, a
directory without it counts as absent, and an object with the name of the process marks a run.
"""

import atexit
import os
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
from artgen._names import inside
from artgen.asset.files import ASSET_FILE
from artgen.dataset.disk import LOCK_FILE, PLAN_FILE, Disk, unseen
from artgen.errors import ExportError
from artgen.export.files import write_files

_EVERY = 30.0  # time between two writes of a growing file [s]


class Store:
    """A place at a URL, with the methods of `Disk`; fsspec finds the credentials.

    Attributes:
        url: The URL.
        links: Whether assets can share texture maps by links.
    """

    links = False

    def __init__(self, url: str) -> None:
        self.url = url.rstrip("/")
        with self._told():
            self._files.invalidate_cache()  # other processes write to it as well

    def __str__(self) -> str:
        return self.url

    def __reduce__(self) -> tuple[type["Store"], tuple[str]]:
        """Pickle the URL only: another process makes its own connections and cache."""
        return Store, (self.url,)

    def absolute(self) -> "Store":
        """Return the place for processes with another working directory."""
        return self

    @contextmanager
    def opened(self) -> Iterator[None]:
        """Hold the place for one run."""
        since = datetime.now(UTC).isoformat(timespec="seconds")
        run = f"process {os.getpid()} on {socket.gethostname()}, since {since}, run {uuid.uuid4().hex}"
        owner = run.encode()
        with self._told():
            self._own(owner)
        try:
            yield
        finally:
            with self._told():
                if self.read(LOCK_FILE) == owner:
                    self._files.rm_file(self._at(LOCK_FILE))

    def names(self) -> list[str]:
        """Return the names of the files and folders in the place, without those of the run."""
        with self._told():
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
        with self._told():
            found = self._files.cat(list(places), on_error="return")
            for content in found.values():
                if isinstance(content, Exception) and not isinstance(content, FileNotFoundError):
                    raise content
        return {places[at]: content for at, content in found.items() if isinstance(content, bytes)}

    def write(self, path: str, content: bytes) -> None:
        """Write a file, which is complete or absent."""
        with self._told():
            self._pipe({path: content})

    def lines(self, path: str, text: str) -> "StoreLines":
        """Open a file that grows by one line at a time."""
        return StoreLines(self, path, text)

    def complete(self, paths: Iterable[str]) -> set[str]:
        """Return the directories that have an `asset.json`."""
        with self._told():
            self._files.invalidate_cache()
            there = set(self._files.find(self._root))
        return {path for path in paths if self._at(f"{path}/{ASSET_FILE}") in there}

    def put(self, files: Mapping[str, bytes], path: str, *, share: bool) -> None:
        """Put an asset in its directory, which is complete or counts as absent."""
        with self._told():
            if not self._files.exists(self._at(PLAN_FILE)):
                raise unseen(self)
            whole = {f"{path}/{name}": content for name, content in files.items()}
            last = f"{path}/{ASSET_FILE}"
            self._pipe({name: content for name, content in whole.items() if name != last})
            self._pipe({last: whole[last]})

    def local(self, path: str) -> Path:
        """Return the directory of an asset on this machine, fetched once."""
        place = inside(self._cache, path)
        if not place.exists():
            with self._told():
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
        """The file system of fsspec."""
        return self._opened_url()[0]

    @property
    def _root(self) -> str:
        """The path of the place in that file system."""
        return self._opened_url()[1]

    def _opened_url(self) -> tuple[Any, str]:
        """Return file system and path; fsspec caches them, and reconnects in a forked process."""
        try:
            from fsspec.core import url_to_fs
        except ImportError as error:
            raise ExportError(f"{self.url} needs fsspec: pip install 'artgen[url]'") from error
        try:
            files, root = url_to_fs(self.url)
        except (ImportError, ValueError) as error:  # unknown protocol, or its package is missing
            raise ExportError(f"{self.url} cannot be opened: {error}") from error
        return files, root.rstrip("/")

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
    def _told(self) -> Iterator[None]:
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


class StoreLines:
    """A growing file; it is written as a whole at intervals, because objects cannot grow."""

    def __init__(self, store: Store, path: str, text: str) -> None:
        self._store, self._path = store, path
        self._parts = [text]
        self._write()

    def add(self, line: str) -> None:
        """Add a line, which ends with a line break."""
        self._parts.append(line)
        self._new = True
        if time.monotonic() - self._at > _EVERY:
            self._write()

    def close(self) -> None:
        """Write the remaining lines."""
        if self._new:
            self._write()

    def _write(self) -> None:
        self._store.write(self._path, "".join(self._parts).encode())
        self._at, self._new = time.monotonic(), False


def is_url(place: str | Path) -> bool:
    """Tell whether a place is a URL; `file:` is one, and so are chained URLs, such as `zip::s3://x`."""
    return isinstance(place, str) and ("://" in place or "::" in place)


Target = Disk | Store
"""A place of a dataset."""


def target_of(place: str | Path) -> Target:
    """Return the place of a folder or URL."""
    if isinstance(place, Path) or not is_url(place):
        return Disk(Path(place))
    parts = urlsplit(place)
    if parts.scheme != "file":
        return Store(place)
    if parts.netloc not in ("", "localhost"):
        raise ExportError(
            f"{place} names a folder of another machine ({parts.netloc!r}): a folder of this one is "
            "file:///PATH, with three slashes"
        )
    return Disk(Path(url2pathname(parts.path)))
