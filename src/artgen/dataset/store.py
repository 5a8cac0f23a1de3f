"""A dataset at a URL of any kind that fsspec knows: `s3://bucket/set`, `gs://`, `sftp://`, ...

Stores of objects know no renaming, no links and no locks. So the `asset.json` of an asset is written last,
and a directory without one is absent; and an object with the name of its owner says that a run goes on.
"""

import atexit
import json
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

from artgen._caching import cached_property
from artgen._names import inside
from artgen.asset.files import ASSET_FILE
from artgen.dataset.disk import Disk
from artgen.dataset.target import LOCK_FILE, PLAN_FILE, Target, unseen
from artgen.errors import ExportError
from artgen.export.files import write_files

_EVERY = 30.0  # how often lines are written that grow [s]


class Store(Target):
    """A place that fsspec knows; see `Target`. Credentials are found as fsspec finds them.

    Attributes:
        url: Where it is.
    """

    links = False

    def __init__(self, url: str) -> None:
        self.url = url.rstrip("/")
        with self._told():
            self._files.invalidate_cache()  # others write to it too

    def __str__(self) -> str:
        return self.url

    def __reduce__(self) -> tuple[type["Store"], tuple[str]]:
        """Let another process make connections and a cache of its own."""
        return Store, (self.url,)

    def absolute(self) -> "Store":
        """Return the place as processes with another working directory find it."""
        return self

    @contextmanager
    def opened(self) -> Iterator[None]:
        """Hold the place for one run."""
        owner = _owner()
        with self._told():
            self._own(owner)
        try:
            yield
        finally:
            with self._told():
                if self.read(LOCK_FILE) == owner:
                    self._files.rm_file(self._at(LOCK_FILE))

    def names(self) -> list[str]:
        """Return what lies directly in it."""
        with self._told():
            try:
                found = self._files.ls(self._root, detail=True)
            except FileNotFoundError:
                return []
            if [each["type"] for each in found if each["name"].strip("/") == self._root.strip("/")] == [
                "file"
            ]:
                raise ExportError(f"cannot write a dataset to {self}: it is a file; choose another place")
        names = [each["name"].rstrip("/").rpartition("/")[2] for each in found]
        return [name for name in names if name and name != LOCK_FILE]

    def contents(self, paths: Iterable[str]) -> dict[str, bytes]:
        """Return what the files hold, of those that there are."""
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
        """Write a file, which nobody sees by half."""
        with self._told():
            self._pipe({path: content})

    def lines(self, path: str, text: str) -> "_StoreLines":
        """Begin a file with some lines, to add others."""
        return _StoreLines(self, path, text)

    def complete(self, paths: Iterable[str]) -> set[str]:
        """Return those directories that have an `asset.json`."""
        with self._told():
            self._files.invalidate_cache()
            there = set(self._files.find(self._root))
        return {path for path in paths if self._at(f"{path}/{ASSET_FILE}") in there}

    def put(self, files: Mapping[str, bytes], path: str, *, share: bool) -> None:
        """Put an asset in its directory."""
        with self._told():
            if not self._files.exists(self._at(PLAN_FILE)):
                raise unseen(self)
            whole = {f"{path}/{name}": content for name, content in files.items()}
            last = f"{path}/{ASSET_FILE}"
            self._pipe({name: content for name, content in whole.items() if name != last})
            self._pipe({last: whole[last]})

    def local(self, path: str) -> Path:
        """Return the directory of an asset on this machine."""
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
        return self._found[0]

    @property
    def _root(self) -> str:
        """The place in its words."""
        return self._found[1]

    @property
    def _found(self) -> tuple[Any, str]:
        """Both; fsspec remembers them, and makes connections anew in a process that was forked."""
        try:
            from fsspec.core import url_to_fs
        except ImportError as error:
            raise ExportError(f"{self.url} needs fsspec: pip install 'artgen[url]'") from error
        try:
            files, root = url_to_fs(self.url)
        except (ImportError, ValueError) as error:  # the package for such URLs is missing, or there is none
            raise ExportError(f"{self.url} cannot be opened: {error}") from error
        return files, root.rstrip("/")

    @cached_property
    def _cache(self) -> Path:
        """Where assets are fetched to; assets read surfaces late, so it is there until the process ends."""
        folder, process = tempfile.mkdtemp(prefix="artgen_"), os.getpid()

        def remove() -> None:
            if os.getpid() == process:  # a forked one has it from its parent
                shutil.rmtree(folder, ignore_errors=True)

        atexit.register(remove)
        return Path(folder)

    def _at(self, path: str) -> str:
        return f"{self._root}/{path}" if self._root else path

    def _pipe(self, files: Mapping[str, bytes]) -> None:
        content = {self._at(path): each for path, each in files.items()}
        self._in_folders(files, lambda: self._files.pipe(content))

    def _in_folders(self, paths: Iterable[str], write: Callable[[], None]) -> None:
        """Write files; where the store has folders that want to be made, in those."""
        try:
            write()
        except FileNotFoundError:
            parents = {self._at(str(each)) for path in paths for each in PurePosixPath(path).parents[:-1]}
            for folder in sorted({self._root, *parents} - {""}):  # those above others first
                with suppress(FileExistsError):
                    self._files.mkdir(folder, create_parents=False)  # a bucket that is missing is a mistake
            write()

    def _own(self, owner: bytes) -> None:
        """Write who holds the place, or refuse because another does."""
        other = self.read(LOCK_FILE)
        if other is None:
            try:
                self._create(LOCK_FILE, owner)
            except FileExistsError:
                other = self.read(LOCK_FILE) or owner
            else:
                other = self.read(LOCK_FILE)  # the last one to write it, where a store cannot refuse
        if other != owner:
            raise ExportError(
                f"another run ({_spelt(other or b'')}) writes to {self}; wait until it is done, or choose "
                f"another place; if it was killed, remove {self}/{LOCK_FILE} and run the same command again"
            )

    def _create(self, path: str, content: bytes) -> None:
        """Write a file, or raise FileExistsError where the store can tell that there is one."""

        def write() -> None:
            with self._files.open(self._at(path), "xb") as file:
                file.write(content)

        try:
            self._in_folders([path], write)
        except (NotImplementedError, ValueError, TypeError):  # it knows no such mode
            self._pipe({path: content})

    @contextmanager
    def _told(self) -> Iterator[None]:
        """Say where it was that a store refused, whatever its package raises."""
        try:
            yield
        except ExportError:
            raise
        except Exception as error:  # network and credentials: no two packages have the same errors
            reason = " ".join(str(error).split()) or type(error).__name__
            raise ExportError(
                f"{self} cannot be used: {reason}; check the URL and its credentials"
            ) from error


class _StoreLines:
    """Lines that are written as a whole from time to time: objects cannot grow."""

    def __init__(self, store: Store, path: str, text: str) -> None:
        self._store, self._path = store, path
        self._parts = [text]
        self._write()

    def add(self, line: str) -> None:
        self._parts.append(line)
        self._new = True
        if time.monotonic() - self._at > _EVERY:
            self._write()

    def close(self) -> None:
        if self._new:
            self._write()

    def _write(self) -> None:
        self._store.write(self._path, "".join(self._parts).encode())
        self._at, self._new = time.monotonic(), False


def _owner() -> bytes:
    """Spell who this process is."""
    data = {
        "host": socket.gethostname(),
        "process": os.getpid(),
        "since": datetime.now(UTC).isoformat(timespec="seconds"),
        "id": uuid.uuid4().hex,
    }
    return json.dumps(data).encode()


def _spelt(owner: bytes) -> str:
    try:
        data = json.loads(owner)
        return f"process {data['process']} on {data['host']}, since {data['since']}"
    except (ValueError, LookupError, TypeError):
        return "unknown"


def is_url(place: str | Path) -> bool:
    """Tell whether a place is a URL, `file:` included; parts of chained ones are parted by `::`."""
    return isinstance(place, str) and ("://" in place or "::" in place)


def target_of(place: str | Path) -> Target:
    """Return the target of a folder or URL."""
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
