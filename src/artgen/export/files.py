"""The only module that writes assets to disk: all files of an asset with their digests, or none."""

import errno
import hashlib
import json
import os
import shutil
import stat
import zlib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import replace
from io import BytesIO
from itertools import islice
from pathlib import Path
from typing import Any

try:
    import fcntl
except ImportError:  # Windows has no locks of this kind
    fcntl = None  # type: ignore[assignment]

import numpy as np

from artgen._arrays import without_collector
from artgen._names import all_inside, check_name, check_names, checked_path
from artgen.asset import Asset, valid_states
from artgen.asset.asset import FORMAT, Limits
from artgen.asset.collision import Collision, collision_of, with_colliders
from artgen.asset.files import ASSET_FILE, CERTIFICATE_FILE, previous_directory
from artgen.asset.record import json_text
from artgen.errors import AssetError, ExportError, nearest
from artgen.export.layouts import FORMATS, LAYOUTS, TEXTURES
from artgen.export.losses import Layout
from artgen.export.precision import with_precision
from artgen.export.urdf import write_urdf
from artgen.materials.textures import check_size
from artgen.materials.textures.bake import Memory

STATES_FILE, READER_FILE = "states.npz", "valid_states.py"
"""Drawn valid states, and the module that reads the states of all formats without artgen."""

REPORT_FILE = "report.json"
"""Report of `artgen validate` in an export directory; a new export removes it."""

REACH_FILE = "reach.json"
"""Places of a robot for the joints of an exported room, from `artgen reach`; a new export removes it."""

_OWN_FILES = (ASSET_FILE, CERTIFICATE_FILE, REPORT_FILE, REACH_FILE, STATES_FILE, READER_FILE)
_NAME = 24  # characters of a digest in the name of a stored file
_PNG = b"\x89PNG\r\n\x1a\n"

_MEMORY = Memory(64 * 2**20)
"""Digests of recent PNG files by their bytes: many exports share the same maps."""


def digests(files: Mapping[str, bytes]) -> dict[str, str]:
    """Return the digest of each file by its path, in the order of the paths."""
    return {path: digest(files[path]) for path in sorted(files)}


def digest(content: bytes) -> str:
    """Return the SHA-256 of a file in hexadecimal; for a PNG file, that of its unpacked pixels.

    Machines compress the same pixels differently, which would make `asset.json` differ as well.
    """
    if not content.startswith(_PNG):
        return hashlib.sha256(content).hexdigest()
    return _MEMORY.get(
        content, lambda: hashlib.sha256(_unpacked(content)).hexdigest(), lambda _: len(content)
    )


def _unpacked(content: bytes) -> bytes:
    """Return the chunks of a PNG file with unpacked pixels; a damaged file is returned as it is."""
    head, packed, place = b"", b"", len(_PNG)
    while place + 12 <= len(content):
        length = int.from_bytes(content[place : place + 4], "big")
        kind, data = content[place + 4 : place + 8], content[place + 8 : place + 8 + length]
        if kind == b"IDAT":
            packed += data
        elif kind != b"IEND":
            head += kind + data
        place += 12 + length
    try:
        return head + zlib.decompress(packed)
    except zlib.error:
        return content


def export(
    asset: Asset,
    directory: str | Path,
    *,
    formats: Sequence[str] | None = None,
    collision: Collision = "exact",
    textures: int = TEXTURES,
    layout: str = "flat",
    mesh_precision: float = 0.0,
    limits: Limits = "full",
    frames: bool = True,
    states: int = 0,
) -> Path:
    """Write an asset to a directory: `asset.json` and the files of each format.

    All files are written to a temporary directory first, which then replaces the target: a failure leaves an
    earlier asset untouched and no partial one. Files in the target that artgen did not write are kept.
    Threads and processes that write to one target wait for each other.

    Args:
        asset: The asset.
        directory: Target directory: new, empty, or with an earlier export.
        formats: Any of `urdf`, `mjcf`, `usd`, `glb` and `sdf`; by default those of the layout, which for
            `flat` are the first three.
        collision: Kind of colliders: `exact` keeps the asset's; `coacd` and `hull` make new ones from the
            solids, see `artgen.asset.collision.with_colliders`, without a certificate, because it does not
            hold for them. `asset.json` records the kind.
        textures: Texels per side of the material maps: 256, 512, 1024 or 2048; 0 for colors only, as for all
            assets of low detail.
        layout: Layout of the files, see `artgen.export.layouts`: `flat`, `simready`, `partnet-mobility`,
            `robocasa`, `molmospaces` or `parts`.
        mesh_precision: Largest distance of visible meshes from the exact surface [m], to write fewer
            triangles, and texture coordinates only for maps: 0.0005 halves the meshes and is invisible from
            one metre; 0 writes all.
        limits: Ranges of joints: `independent` writes ranges in which every state is free, see
            `artgen.proof.limits.with_limits`.
        frames: Whether the URDF of the layout `flat` has a link for each grasp and push; without them, every
            link has inertia, visual and collider.
        states: Number of drawn valid states to write to `states.npz`, with `valid_states.py`, which reads the
            states of all formats without artgen; 0 writes neither.

    Returns:
        The directory.

    Raises:
        ExportError: A layout, format or collision is unknown, the layout does not have the format, the
            directory holds other files, or the disk reports an error.
        AssetError: The asset was read from files, which keep no solids, but other colliders or surfaces are
            requested.
        ParameterError: The directory, the size of maps or the precision is not allowed.
    """
    checked_path(directory, "directory")
    files = encode(
        asset,
        formats,
        collision,
        textures,
        layout,
        mesh_precision,
        limits=limits,
        frames=frames,
        states=states,
    )
    target = Path(os.path.realpath(directory))
    try:
        _replace(target, files)
    except ExportError:
        raise
    except OSError as error:
        reason = error.strerror or str(error)
        raise ExportError(
            f"cannot write asset {asset.name!r} to {directory}: {reason}; nothing was changed"
        ) from error
    return Path(directory)


@without_collector()
def encode(
    asset: Asset,
    formats: Sequence[str] | None = None,
    collision: Collision = "exact",
    textures: int = TEXTURES,
    layout: str = "flat",
    mesh_precision: float = 0.0,
    *,
    limits: Limits = "full",
    frames: bool = True,
    states: int = 0,
) -> dict[str, bytes]:
    """Return the content of every file of an export by its path relative to the directory; see `export`.

    Raises:
        ExportError: A layout, format or collision is unknown, or the layout does not have the format.
        AssetError: The asset was read from files, which keep no solids, but other colliders or surfaces are
            requested.
        ParameterError: The size of maps or the precision is not allowed.
    """
    check_size(textures, plain=True)
    check_name(asset.name)
    if asset.detail == "low":
        textures = 0
    laid_out = find_layout(layout)
    chosen = chosen_formats(laid_out, formats)
    asset = asset if limits == "full" else asset.with_limits(limits)
    asset = with_precision(with_colliders(asset, collision), mesh_precision).rounded()
    files: dict[str, bytes] = {}
    record: dict[str, Any] = {}
    for name in chosen:
        if name == "urdf" and layout == "flat" and not frames:
            asset_urdf = write_urdf(asset, textures, hands=False)
            written = replace(asset_urdf, main=f"{asset.name}.urdf")
        else:
            written = laid_out.write(asset, name, textures)
        files |= written.files
        record[name] = {
            "main": written.main,
            "files": sorted(written.files),
            "losses": [loss.to_data() for loss in written.losses],
        }
    if states:
        files |= _states_files(asset, states)
    data = asset.to_data()
    collisions = collision_of(data["links"])
    data |= {"collision": collisions, "layout": layout, "formats": record, "digests": digests(files)}
    files[ASSET_FILE] = json_text(data).encode()
    if asset.certificate is not None and asset.certificate.leaves is not None:
        files[CERTIFICATE_FILE] = json_text(asset.certificate.leaves).encode()
    return files


def _states_files(asset: Asset, count: int) -> dict[str, bytes]:
    """Return drawn valid states, and the reader of states."""
    packed = BytesIO()
    np.savez(packed, dofs=np.array(asset.dof_names), q=asset.sample_states(count))
    return {STATES_FILE: packed.getvalue(), READER_FILE: Path(valid_states.__file__).read_bytes()}


def write_files(files: Mapping[str, bytes], directory: Path, store: Path | None = None) -> None:
    """Write the files of an export to a new directory."""
    places = all_inside(directory, files)
    for parent in {place.parent for place in places.values()}:
        parent.mkdir(parents=True, exist_ok=True)
    for path, content in files.items():
        if store is not None and path.endswith(".png"):
            _share(content, places[path], store)
        else:
            places[path].write_bytes(content)


@contextmanager
def replaced(path: Path) -> Iterator[Path]:
    """Yield a temporary path that replaces a file or folder once it is complete; an error leaves nothing."""
    partial = path.with_name(f".{path.name}.partial")
    try:
        with _new_parents(path), ExitStack() as cleanup:
            _remove(partial)
            cleanup.callback(_remove, partial)
            yield partial
            if partial.is_dir():
                _remove(path)
            partial.replace(path)
    except ExportError:
        raise
    except OSError as error:
        raise ExportError(f"cannot write {path}: {error.strerror or error}; nothing was changed") from error


def write_file(path: Path, content: bytes) -> Path:
    """Write a file completely or not at all."""
    with replaced(path) as partial:
        partial.write_bytes(content)
    return path


def _remove(path: Path) -> None:
    """Remove a file or a folder, if there is one."""
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path)
    else:
        path.unlink(missing_ok=True)


@contextmanager
def _new_parents(path: Path) -> Iterator[None]:
    """Create the parents of a path; an error removes the new ones."""
    missing = [parent for parent in path.parents if not parent.exists()]
    existing = path.parents[len(missing)]
    if not existing.is_dir():
        raise NotADirectoryError(errno.ENOTDIR, f"{existing} is a file")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        yield
    except BaseException:
        for parent in missing:  # innermost first
            with suppress(OSError):
                parent.rmdir()
        raise


def _share(content: bytes, path: Path, store: Path) -> None:
    """Write a file as a hard link to equal content in a store, which gets missing or damaged content."""
    kept = store / f"{hashlib.sha256(content).hexdigest()[:_NAME]}{path.suffix}"
    with suppress(OSError):  # there is none
        if kept.is_symlink() or kept.read_bytes() != content:
            kept.unlink()
    if not kept.exists():
        path.write_bytes(content)
        with suppress(OSError):  # another process was faster, or the file system has no links
            os.link(path, kept)
            return
    try:
        path.unlink(missing_ok=True)
        os.link(kept, path)
    except OSError:
        path.write_bytes(content)


def find_layout(name: Any) -> Layout:
    """Return the layout of that name."""
    if not isinstance(name, str) or name not in LAYOUTS:
        raise ExportError(f"there is no layout {name!r}.{nearest(name, LAYOUTS)}")
    return LAYOUTS[name]


def chosen_formats(layout: Layout, formats: Sequence[str] | None) -> tuple[str, ...]:
    """Return the formats to write, each once."""
    if formats is None:
        return layout.default_formats
    if not isinstance(formats, str | Iterable):
        raise ExportError(f"formats = {formats!r} is not allowed: it must be a tuple of {', '.join(FORMATS)}")
    chosen = tuple(dict.fromkeys([formats] if isinstance(formats, str) else formats))
    for name in chosen:
        if name not in FORMATS:
            raise ExportError(f"there is no format {name!r}.{nearest(name, FORMATS)}")
        if name not in layout.formats:
            raise ExportError(
                f"the layout {layout.name!r} has no {name!r}; it holds {', '.join(layout.formats)}"
            )
    return chosen


def _foreign_files(target: Path, files: Iterable[str]) -> list[str]:
    """Return the files in a directory that artgen did not write, if an export may replace the others."""
    inside = (
        path.relative_to(target).as_posix()
        for path in target.rglob("*")
        if path.is_symlink() or not path.is_dir()
    )
    try:
        _recover(target)
        is_file = target.exists() and not target.is_dir()
        earlier = _earlier_files(target)
        # the folder of a user may hold millions of files
        found = sorted(islice(inside, 1 if earlier is None else None))
    except OSError as error:
        raise ExportError(f"cannot export to {target}: {error.strerror or error}") from error
    if is_file:
        raise ExportError(f"cannot export to {target}: it is a file; choose another directory")
    if not found:
        return []
    if earlier is None:
        raise ExportError(
            f"cannot export to {target}: it holds {found[0]!r} and is no earlier export of artgen; choose "
            "another directory or empty this one"
        )
    foreign = [path for path in found if path not in earlier]
    overwritten = sorted(set(foreign) & set(files))
    if overwritten:
        raise ExportError(
            f"cannot export to {target}: {overwritten[0]!r} is not artgen's and would be overwritten; "
            "move it away"
        )
    return foreign


def _earlier_files(target: Path) -> set[str] | None:
    """Return the files of the export in a directory, or None if it holds no export."""
    try:
        data = json.loads((target / ASSET_FILE).read_text(encoding="utf-8"))
        if data["format"] != FORMAT:
            return None
        check_names({"formats": data["formats"]}, target)
        return {*_OWN_FILES, *(path for record in data["formats"].values() for path in record["files"])}
    except (AssetError, OSError, ValueError, LookupError, TypeError, AttributeError):
        return None


def _replace(target: Path, files: Mapping[str, bytes]) -> None:
    """Replace the target by a directory with the files and those that artgen did not write."""
    if target.exists() and (os.path.ismount(target) or target in (Path.cwd(), *Path.cwd().parents)):
        raise ExportError(
            f"cannot export to {target}: a working directory or mount cannot be replaced as a whole; choose "
            f"a directory in it, such as {target / 'asset'}"
        )
    partial, previous = target.parent / f".{target.name}.partial", previous_directory(target)
    with _new_parents(target), _claimed(partial, target):
        try:
            kept = _foreign_files(target, files)
            if target.exists():
                _adopt(target, partial)
            write_files(files, partial)
            for path in kept:
                (partial / path).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy2(target / path, partial / path, follow_symlinks=False)
            if target.exists():
                target.rename(previous)
            partial.rename(target)
        except BaseException:
            _recover(target)
            shutil.rmtree(partial, ignore_errors=True)
            raise
        shutil.rmtree(previous, ignore_errors=True)


@contextmanager
def _claimed(partial: Path, target: Path) -> Iterator[None]:
    """Make an empty temporary folder; other threads and processes that write to the target wait."""
    claimed = False
    while not claimed:
        with suppress(FileExistsError):
            partial.mkdir()
        with _locked(partial) as handle:
            try:
                now = partial.stat()
            except FileNotFoundError:
                continue
            claimed = handle is None or os.path.samestat(os.fstat(handle), now)
            if not claimed:  # the one before has moved the folder to its place
                continue
            with _locked(target):  # the one before has it until all is done
                pass
            for path in partial.iterdir():  # left by a killed process
                _remove(path)
            yield


@contextmanager
def _locked(folder: Path) -> Iterator[int | None]:
    """Lock a folder, as far as there is one and the system has locks; yield its handle."""
    with ExitStack() as opened:
        handle = None
        if fcntl is not None:
            with suppress(OSError):
                handle = os.open(folder, os.O_RDONLY)
                opened.callback(os.close, handle)
                fcntl.flock(handle, fcntl.LOCK_EX)
        yield handle


def _adopt(target: Path, partial: Path) -> None:
    """Give the temporary folder the group and the permissions of the folder that it replaces."""
    if not os.access(target, os.W_OK):
        raise ExportError(f"cannot export to {target}: it is read-only; make it writable or choose another")
    found = target.stat()
    if hasattr(os, "chown"):
        with suppress(PermissionError):  # not a member of the group
            os.chown(partial, -1, found.st_gid)
    partial.chmod(stat.S_IMODE(found.st_mode) | stat.S_IRWXU)


def _recover(target: Path) -> None:
    """Finish an interrupted replacement: restore the old directory, or remove it if the new one exists."""
    previous = previous_directory(target)
    if not previous.exists():
        return
    if target.is_dir() and not any(target.iterdir()):
        target.rmdir()  # created in the meantime by another program
    if target.exists():
        shutil.rmtree(previous)
    else:
        previous.rename(target)
