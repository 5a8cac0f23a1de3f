"""The catalog: categories of artgen and of other packages, by name or by file."""

from __future__ import annotations

import functools
import hashlib
import os
import re
import sys
from collections.abc import Mapping
from importlib import import_module
from importlib.util import decode_source
from pathlib import Path
from traceback import walk_tb
from types import MappingProxyType, ModuleType
from typing import Any, Protocol

from artgen.asset import Asset
from artgen.errors import ArtgenError, BuildError, ParameterError, nearest
from artgen.generator import CATEGORIES, Generator, collected, own_categories
from artgen.graph.node import line_in

ENTRY_POINTS = "artgen.categories"
"""Group of entry points for categories of other packages; each names a module that defines categories."""

_FILE = re.compile(r"(?P<path>.+\.py)(?::(?P<name>[^:/\\]*))?", re.DOTALL)


class Maker(Protocol):
    """A source of assets for plans and streams: a category, or a kind of room."""

    @property
    def name(self) -> str:
        """Its name, which is the category of its assets."""

    @property
    def labels(self) -> tuple[str, ...]:
        """The labels of its assets."""

    def sample(self, seed: int, *, overrides: Mapping[str, Any] | None = None) -> dict[str, Any]:
        """Check the overrides, and return the parameters of a seed."""

    def generate(self, /, seed: int = 0, **given: Any) -> Asset:
        """Return the asset of a seed."""


def rooms() -> Mapping[str, Maker]:
    """Return the kinds of rooms by name; their package uses this module, so it is imported on request."""
    found: Mapping[str, Maker] = import_module("artgen.scene").ROOMS
    return found


def maker(name: str | Path) -> Maker:
    """Return the category with a name or in a file, or the kind of room with a name.

    Raises:
        ParameterError: There is none; the message suggests the nearest name.
        BuildError: A file cannot be loaded, or a package cannot be imported.
    """
    known = not isinstance(name, str) or is_file(name) or name in (*own_categories(), *CATEGORIES)
    # categories of other packages come before rooms of the same name
    return find(name) if known or name not in rooms() or name in categories() else rooms()[str(name)]


@functools.cache
def broken() -> Mapping[str, str]:
    """Import the categories of other packages, and return the errors by entry point."""
    from importlib.metadata import entry_points

    messages = {}
    for point in sorted(entry_points(group=ENTRY_POINTS), key=lambda point: (point.name, point.value)):
        package = f" of the package {point.dist.name}" if point.dist else ""
        try:
            point.load()
        except (Exception, SystemExit) as error:  # noqa: BLE001 - whatever a package raises, others go on
            reason = _describe(_culprit(error), error)
            messages[point.name] = f"the categories in {point.value!r}{package} cannot be imported: {reason}"
    return MappingProxyType(messages)


def _culprit(error: BaseException) -> str:
    """Return the innermost file of a package that failed during its import; None if there is none."""
    files = [frame.f_code.co_filename for frame, _ in walk_tb(error.__traceback__)]
    # artgen's own error
    files = [file for file in files if not file.startswith("<") and "importlib" not in file][1:]
    if isinstance(error, SyntaxError) and error.filename:
        files.append(error.filename)
    return next((file for file in reversed(files) if Path(file).is_relative_to(Path(files[0]).parent)), "")


def categories() -> tuple[str, ...]:
    """Return the names of all categories, sorted; `broken` returns packages that cannot be imported."""
    broken()
    return tuple(sorted({*own_categories(), *CATEGORIES}))


def find(name: str | Path) -> Generator:
    """Return the category with a name, or the category in a file: see `load_file`.

    Only the package of that name is imported.

    Raises:
        ParameterError: There is no such category; the message suggests the nearest name.
        BuildError: A file cannot be loaded, or a package cannot be imported.
    """
    if not isinstance(name, str | Path):
        raise ParameterError(f"a category is found by its name, such as 'door', or its file, not by {name!r}")
    name = str(name)
    if is_file(name):
        return load_file(name)
    if name not in CATEGORIES and name in own_categories():
        import_module(f"artgen.categories.{name}")
    if name not in CATEGORIES:  # the caller's own categories need no catalog
        broken()
    if name not in CATEGORIES:
        if name in broken():
            raise BuildError(broken()[name])
        missing = "".join(f"\n  {message}" for message in broken().values())
        raise ParameterError(f"there is no category {name!r}.{_remedy(name)}{missing}")
    return CATEGORIES[name]


def _remedy(name: str) -> str:
    """Return what to give in place of a name that is no category: a file, or the nearest name."""
    script = script_of(name)
    if script:
        return f" Did you mean the file {script}?"
    if os.path.isfile(os.path.join(name, "asset.json")):  # noqa: PTH113, PTH118
        return f" {name} is an exported asset: `artgen view {name}` and `artgen validate {name}` take it."
    if is_pipe(name):
        return (
            " artgen reads no pipe or device: write its content to a file, such as stapler.py or robot.urdf."
        )
    if name.endswith(".html") and os.path.isfile(name):  # noqa: PTH113 - False for names that are too long
        return f" {name} is a page: open it in a browser."
    if os.path.exists(name):  # noqa: PTH110 - False for names that are too long
        return f" {name} is a file or folder: give the Python file of the category, such as stapler.py."
    if name in rooms():
        return f" {name} is a room, which `artgen scene {name}` and artgen.generate({name!r}) make."
    return nearest(name, (*categories(), *rooms()))


def script_of(name: str) -> str:
    """Return the Python file beside a name or in its folder, as of `artgen new`; empty without one."""
    stem = os.path.basename(os.path.normpath(name))  # noqa: PTH119 - names may be too long for paths
    for script in (f"{name}.py", os.path.join(name, f"{stem}.py"), os.path.join(name, "src", f"{stem}.py")):  # noqa: PTH118
        if os.path.isfile(script):  # noqa: PTH113
            return script
    return ""


def is_pipe(name: str) -> bool:
    """Tell whether a name is that of a pipe, a device or a socket, which a command cannot read twice."""
    found = os.path.exists(name) and not os.path.isfile(name) and not os.path.isdir(name)  # noqa: PTH110, PTH112, PTH113
    return name == "-" or found


def is_file(name: str) -> bool:
    """Tell whether a text is a file rather than a name: `stapler.py`, or `shop.py:stapler`."""
    return _FILE.fullmatch(name) is not None


def load_file(path: str | Path) -> Generator:
    """Execute a Python file and return the category that it defines.

    The file is executed each time, so that edits take effect. The category does not enter the catalog,
    because the file may be a copy of an installed one. The folder of the file is in the import path, as for a
    script.

    Args:
        path: The file; `file.py:name` selects one of several categories, by default that of the file's name.

    Raises:
        ParameterError: The file does not exist or has no category of that name, or it has several and none is
            selected.
        BuildError: The file has an error, or defines no category; the message has the author's line.
    """
    parts = _FILE.fullmatch(str(path))
    file = Path(parts["path"] if parts else path)
    wanted = parts["name"] if parts else None
    if is_pipe(str(file)):
        raise ParameterError(f"{file} is a pipe or device; write its content to a file, such as stapler.py")
    if file.suffix != ".py" or not os.path.isfile(file):  # noqa: PTH113 - False for names that are too long
        raise ParameterError(
            f"there is no Python file {str(file)!r}; give the path of one, such as stapler.py"
        )
    file = file.resolve()
    found = _run(file)
    if not found:
        raise BuildError(
            f"{file} defines no category; put @artgen.category(labels=(...)) before the function that "
            "returns its Body"
        )
    if wanted is not None:
        if wanted not in found:
            raise ParameterError(f"{file} defines no category {wanted!r}.{nearest(wanted, found)}")
        return found[wanted]
    if len(found) > 1 and file.stem in found:
        return found[file.stem]
    if len(found) > 1:
        picks = " or ".join(f"{file.name}:{name}" for name in found)
        raise ParameterError(f"{file} defines {len(found)} categories; pick one: {picks}")
    return next(iter(found.values()))


def _run(file: Path) -> dict[str, Generator]:
    """Execute a file as a separate module and return the categories that it defines."""
    # the text is compiled here, because Python's cache misses edits within one second
    path = str(file)
    name = f"category_file_{hashlib.blake2b(path.encode(), digest_size=6).hexdigest()}"
    before = sys.modules.get(name)
    module = ModuleType(name)
    module.__file__ = path
    sys.modules[name] = module  # dataclasses look up their module
    sys.path.insert(0, str(file.parent))
    try:
        with collected(name) as found:
            text = decode_source(file.read_bytes())
            exec(compile(text, path, "exec", dont_inherit=True), vars(module))  # noqa: S102 - that is its purpose
    except (Exception, SystemExit) as error:
        if before is None:
            del sys.modules[name]
        else:
            sys.modules[name] = before
        raise BuildError(_describe(path, error)) from error
    finally:
        sys.path.remove(str(file.parent))
    return found


def _describe(path: str, error: BaseException) -> str:
    """Format an error in a file, with the faulty line of the file."""
    if isinstance(error, ArtgenError) and f"{path}:" in str(error):
        return str(error)
    if isinstance(error, ArtgenError):
        reason = str(error)
    elif isinstance(error, SyntaxError) and error.filename == path:
        reason = f"{type(error).__name__}: {error.msg}"
    else:
        reason = f"{type(error).__name__}: {error}"
    place = line_in(path, error)
    return f"{reason}\n  at {place}" if place else reason


def generate(category: str | Path | Generator, /, seed: int = 0, **overrides: Any) -> Asset:
    """Generate an asset.

    Args:
        category: Name of a category or of a kind of room, a file that defines a category, or a category or
            generator.
        seed: Seed of all draws: the same seed gives the same asset, byte for byte.
        **overrides: Options of `Generator.generate`: `name`, `base` ("fixed" or "free"), `certify=False` to
            skip the proof that no two links collide or `certify="later"` to make it when it is needed, its
            `tolerance` [m] and `on_collision` ("redraw", "fail" or "keep"), `limits`, `topology`, `detail`,
            `colliders` and `openings`; and a value or a distribution by parameter name. Write
            `handle__length` for `handle.length`.

    Raises:
        ParameterError: The category, the seed, an option or an override is unknown or not allowed.
        BuildError: The category has an error.
        EvaluationError: A kernel failed.
        InfeasibleError: No draw met the requirements of the category, or none is proven free of collisions.
        CheckError: The links are not proven apart, and `on_collision` is "fail".
    """
    if isinstance(category, str | Path):
        return maker(category).generate(seed, **overrides)
    if not isinstance(category, Generator):
        raise ParameterError(f"generate takes the name of a category or a generator, got {category!r}")
    return category.generate(seed, **overrides)
