"""Checks of names and relative paths from authors and files, before they become file names."""

import os
import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from artgen.errors import AssetError, ExportError

NAME_RULE = "letters, digits and _, at most 100"
"""Rule of names for messages; the length leaves room for files named after a link and a part."""

_LONGEST = 100  # most characters of a name
_NAMED = frozenset(  # keys of asset.json with names
    [
        "category",
        "child",
        "joint",
        "joints",
        "label",
        "labels",
        "leader",
        "link",
        "material",
        "name",
        "parent",
    ]
)
_PART = re.compile(r"(?!\.+\Z)[A-Za-z0-9_.-]{1,200}")  # parts of a path: no parent and no drive


def is_identifier(name: object) -> bool:
    """Tell whether a name is an ASCII identifier that is not too long for files."""
    return isinstance(name, str) and name.isascii() and name.isidentifier() and len(name) <= _LONGEST


def is_plain_path(path: object) -> bool:
    """Tell whether a path is relative, with slashes, and cannot leave its folder."""
    return isinstance(path, str) and all(_PART.fullmatch(part) for part in path.split("/"))


def check_names(data: Mapping[str, Any], source: Path) -> None:
    """Check the names and paths in the data of an `asset.json`.

    Raises:
        AssetError: A name is not an identifier, or a path leaves the folder of the asset.
    """
    for key, name in _names({**data, "parameters": {}, "formats": {}, "digests": {}, "certificate": {}}):
        if not is_identifier(name):
            raise AssetError(f"{source}: {key} {name!r} is no identifier; use {NAME_RULE}")
    for path in _paths(data):
        if not is_plain_path(path):
            raise AssetError(
                f"{source}: the path {path!r} is not allowed; it must be relative and stay in the folder of "
                "the asset"
            )


def _names(data: Any, key: str = "") -> Iterator[tuple[str, Any]]:
    """Yield each name with its key."""
    if isinstance(data, Mapping):
        for inner, value in data.items():
            yield from _names(value, inner)
    elif isinstance(data, list):
        for value in data:
            yield from _names(value, key)
    elif key in _NAMED and data is not None:
        yield key, data


def _paths(data: Mapping[str, Any]) -> Iterator[Any]:
    """Yield the paths of the files of an export."""
    yield from data.get("digests", {})
    for record in data.get("formats", {}).values():
        yield record["main"]
        yield from record["files"]


def inside(folder: Path, path: str) -> Path:
    """Return the path of a file below a folder, before it is read or written.

    Raises:
        ExportError: The path leaves the folder, possibly through a symbolic link.
    """
    if not is_plain_path(path):
        raise ExportError(f"cannot use {path!r} below {folder}: it must be a relative path that stays there")
    place = folder / path
    parent = Path(os.path.realpath(place.parent))
    if place.is_symlink() or not parent.is_relative_to(os.path.realpath(folder)):
        raise ExportError(f"cannot use {place}: a symbolic link leads out of {folder}; remove the link")
    return place
