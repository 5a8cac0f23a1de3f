"""Tuples that are read by name, and checks of names and paths before they become file names."""

import os
import re
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any, Generic, Protocol, SupportsIndex, TypeVar, overload

from artgen._arrays import cached_property
from artgen.errors import AssetError, ExportError, ParameterError, nearest

NAME_RULE = "letters, digits and _, at most 100"
"""Rule of names for messages; the length leaves room for files named after a link and a part."""

WORLD = "world"
"""Name of the fixed frame in MJCF and URDF, which no link may have."""

_LONGEST = 100  # most characters of a name
_NAMED = frozenset([  # keys of asset.json with names
    "category", "child", "joint", "joints", "label", "labels", "leader", "link", "material", "name", "parent",
])  # fmt: skip
_PART = re.compile(r"(?!\.+\Z)[A-Za-z0-9_.-]{1,200}")  # parts of a path: no parent and no drive


class _HasName(Protocol):
    @property
    def name(self) -> str: ...


Item_co = TypeVar("Item_co", bound=_HasName, covariant=True)


class ByName(tuple[Item_co, ...], Generic[Item_co]):  # noqa: SLOT001 - it caches its names
    """A tuple of items that have names: `joints["door_hinge"]` is an item as `joints[0]` is.

    Attributes:
        missing: Start of the message for an unknown name, such as `asset 'door_7' has no joint`.
    """

    missing = "there is no"

    @cached_property
    def names(self) -> tuple[str, ...]:
        """The names in order."""
        return tuple(item.name for item in self)

    @cached_property
    def by_name(self) -> dict[str, Item_co]:
        """The items by name."""
        return {item.name: item for item in self}

    def __contains__(self, key: object) -> bool:
        """Tell whether there is an item, or an item of a name."""
        return key in self.by_name if isinstance(key, str) else super().__contains__(key)

    @overload
    def __getitem__(self, key: str | SupportsIndex) -> Item_co: ...

    @overload
    def __getitem__(self, key: slice) -> tuple[Item_co, ...]: ...

    def __getitem__(self, key: Any) -> Any:
        """Return the item of a name or an index, or the items of a slice.

        Raises:
            AssetError: There is no such name; the message has the nearest name and the others.
        """
        if not isinstance(key, str):
            try:
                return super().__getitem__(key)
            except TypeError as error:
                raise AssetError(f"{self.missing} {key!r}.{nearest(key, self.names)}") from error
        if key not in self.by_name:
            near = nearest(key, self.names)
            others = f" It has: {', '.join(self.names[:12])}{', ...' * (len(self) > 12)}."
            raise AssetError(f"{self.missing} {key!r}.{near}{others if near.endswith('?') else ''}")
        return self.by_name[key]


def is_identifier(name: object) -> bool:
    """Tell whether a name is an ASCII identifier that is not too long for files."""
    return isinstance(name, str) and name.isascii() and name.isidentifier() and len(name) <= _LONGEST


def check_name(name: object) -> None:
    """Check the argument `name` of an author.

    Raises:
        ParameterError: It is no identifier, or formats have a meaning for it.
    """
    if not is_identifier(name):
        raise ParameterError(f"name = {name!r} is no identifier; use {NAME_RULE}")
    if name in ("main", WORLD):
        raise ParameterError(f"name = {name!r} has a meaning of its own in MJCF and URDF; use another name")


def is_plain_path(path: object) -> bool:
    """Tell whether a path is relative, with slashes, and cannot leave its folder."""
    return isinstance(path, str) and all(_PART.fullmatch(part) for part in path.split("/"))


def checked_path(path: Any, name: str) -> Path:
    """Return the path in an argument of that name.

    Raises:
        ParameterError: The argument is no path.
    """
    if not isinstance(path, str | os.PathLike) or "\0" in str(path):
        raise ParameterError(f"{name} = {path!r} is not allowed: give a path, such as 'out/door'")
    return Path(path)


def check_names(data: Mapping[str, Any], source: Path) -> None:
    """Check the names and paths in the data of an `asset.json`.

    Raises:
        AssetError: A name is not an identifier, or a path leaves the folder of the asset.
    """
    named = {**data, "formats": {}, "digests": {}, "certificate": {}}
    for place, name in _names(named, "", ""):
        if not is_identifier(name):
            raise AssetError(f"{source}: {place} {name!r:.60} is no identifier; use {NAME_RULE}")
    for path in _paths(data):
        if not is_plain_path(path):
            raise AssetError(
                f"{source}: the path {path!r:.60} is not allowed; it must be relative and stay in the folder "
                "of the asset"
            )


def _names(data: Any, key: str, place: str) -> Iterator[tuple[str, Any]]:
    """Yield each name with its place."""
    if isinstance(data, Mapping):
        for inner, value in data.items():
            if inner == "parameters":  # of the asset, or of one in a room: an author may call one `label`
                continue
            yield from _names(value, inner, f"{place}.{inner}" if place else inner)
    elif isinstance(data, list):
        for number, value in enumerate(data):
            if not isinstance(value, float):  # most of the data
                yield from _names(value, key, f"{place}[{number}]")
    elif key in _NAMED and (data is not None or key in ("labels", "name")):
        yield place, data


def _paths(data: Mapping[str, Any]) -> Iterator[Any]:
    """Yield the paths of the files of an export."""
    yield from data.get("digests", {})
    for record in data.get("formats", {}).values():
        yield record["main"]
        yield from record["files"]


def inside(folder: Path, path: str) -> Path:
    """Return the path of a file below a folder, see `all_inside`."""
    return all_inside(folder, [path])[path]


def all_inside(folder: Path, paths: Iterable[str]) -> dict[str, Path]:
    """Return the path of each file below a folder, before it is read or written.

    Raises:
        ExportError: A path leaves the folder, possibly through a symbolic link.
    """
    root, parents = os.path.realpath(folder), {}
    places = {}
    for path in paths:
        if not is_plain_path(path):
            raise ExportError(
                f"cannot use {path!r} below {folder}: it must be a relative path that stays there"
            )
        place = places[path] = folder / path
        parent = place.parent
        if parent not in parents:
            parents[parent] = Path(os.path.realpath(parent)).is_relative_to(root)
        if place.is_symlink() or not parents[parent]:
            raise ExportError(f"cannot use {place}: a symbolic link leads out of {folder}; remove the link")
    return places
