"""Where a dataset lies: a folder on a disk, or a URL of a store that keeps objects by name.

A run, its workers and `Dataset` speak to either in the words of `Target`. A path is relative to the place,
with slashes.
"""

import os
import socket
from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping
from contextlib import AbstractContextManager
from pathlib import Path
from typing import Protocol

from artgen.errors import ExportError

PLAN_FILE = "dataset.json"
LOCK_FILE = ".lock"
STAGING = ".staging"
TEXTURE_DIRECTORY = "textures"

GO_ON = "what is done stays, and the same command goes on from there"
"""What messages say of a run that was ended."""


class Lines(Protocol):
    """A file that grows by a line at a time."""

    def add(self, line: str) -> None:
        """Add a line, which ends with a line break."""

    def close(self) -> None:
        """See that every line is in its place."""


class Target(ABC):
    """A place of a dataset; workers get a copy of it."""

    links: bool  # whether assets can share maps by links

    @abstractmethod
    def __str__(self) -> str:
        """Name the place in messages."""

    @abstractmethod
    def absolute(self) -> "Target":
        """Return the place as processes with another working directory find it."""

    @abstractmethod
    def opened(self) -> AbstractContextManager[None]:
        """Hold the place for one run, made if there is none; what a killed run left over is removed."""

    @abstractmethod
    def names(self) -> list[str]:
        """Return what lies directly in the place, except for what is of a run."""

    @abstractmethod
    def contents(self, paths: Iterable[str]) -> dict[str, bytes]:
        """Return what the files hold, of those that there are."""

    @abstractmethod
    def write(self, path: str, content: bytes) -> None:
        """Write a file, which nobody sees by half."""

    @abstractmethod
    def lines(self, path: str, text: str) -> Lines:
        """Begin a file with some lines, to add others."""

    @abstractmethod
    def complete(self, paths: Iterable[str]) -> set[str]:
        """Return those of some directories of assets that are whole."""

    @abstractmethod
    def put(self, files: Mapping[str, bytes], path: str, *, share: bool) -> None:
        """Put an asset in its directory, which is whole or counts as absent."""

    @abstractmethod
    def local(self, path: str) -> Path:
        """Return the directory of an asset on this machine, fetched if it lies elsewhere."""

    def read(self, path: str) -> bytes | None:
        """Return what a file holds; None if there is none."""
        return self.contents([path]).get(path)


def unseen(target: Target) -> ExportError:
    """Return the error of a worker that does not see what the run sees."""
    return ExportError(
        f"process {os.getpid()} on {socket.gethostname()} does not see {target}; choose a folder or URL that "
        "all processes share"
    )
