"""Check of the files of an export: they are complete, unchanged and readable."""

import json
import struct
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath
from typing import Any

from artgen.asset import Asset
from artgen.asset.files import ASSET_FILE, CERTIFICATE_FILE, MESH_DIRECTORY
from artgen.asset.report import AGAIN, CheckResult, Finding
from artgen.errors import ExportError, nearest
from artgen.export.files import REPORT_FILE, digest
from artgen.export.layouts import DEFAULT_FORMATS, LAYOUTS

_TEXTS = {".urdf", ".xml", ".usda", ".obj", ".mtl", ".json", ".txt"}
_LOOKS = {".png", ".jpg", ".mtl"}
_GLB_CHUNKS = (b"JSON", b"BIN\0")


@dataclass(frozen=True)
class Contents:
    """The contents of the files of an export.

    Attributes:
        found: Content of each readable file, by path.
        faults: Fault of each damaged file, by path; the text begins with the path.
        changes: Finding for each file that was changed after the export, by path.
    """

    found: dict[str, bytes] = field(default_factory=dict)
    faults: dict[str, str] = field(default_factory=dict)
    changes: dict[str, Finding] = field(default_factory=dict)


def read_contents(
    directory: Path,
    formats: Mapping[str, tuple[str, ...]],
    digests: Mapping[str, str],
    mains: Collection[str] = (),
) -> Contents:
    """Read every listed file once.

    Args:
        directory: The directory of the export.
        formats: The files of each format.
        digests: Digests of the files at the time of the export.
        mains: Files that other checks compare with the asset.
    """
    result = Contents()
    for path in dict.fromkeys(path for files in formats.values() for path in files):
        fault, content = _read(directory, path)
        fault = fault or _fault_of(path, content)
        if fault:
            result.faults[path] = fault
        else:
            result.found[path] = content
            if path in digests and digest(content) != digests[path]:
                result.changes[path] = _changed(path, compared=path in mains)
    return result


def _read(directory: Path, path: str) -> tuple[str, bytes]:
    """Return the fault and the content of a file."""
    try:
        # a link out of the export breaks when the directory is copied
        if not (directory / path).resolve().is_relative_to(directory.resolve()):
            return f"{path} is a link that leads out of the directory", b""
        content = (directory / path).read_bytes()
    except FileNotFoundError:
        return f"{path} is missing", b""
    except OSError as error:
        return f"{path} cannot be read ({error.strerror})", b""
    return ("" if content else f"{path} is empty"), content


def _fault_of(path: str, content: bytes) -> str:
    """Return the fault of a content; empty if there is none."""
    suffix = PurePosixPath(path).suffix.lower()
    if suffix == ".png":
        return _fault_of_image(path, content)
    if suffix == ".glb":
        return _fault_of_glb(path, content)
    if suffix in _TEXTS:
        try:
            content.decode("utf-8")
        except UnicodeDecodeError as error:
            return f"{path} is not UTF-8 text: byte {error.start} is {content[error.start]:#04x}"
    return ""


def _fault_of_image(path: str, content: bytes) -> str:
    from io import BytesIO

    from PIL import Image

    try:
        with Image.open(BytesIO(content)) as image:
            image.load()
    except (OSError, SyntaxError, ValueError):  # errors of Pillow for damaged PNG
        return f"{path} is not a readable image"
    return ""


def _fault_of_glb(path: str, content: bytes) -> str:
    """Return the fault of the header or the chunks of a binary glTF file."""
    if len(content) < 12 or content[:4] != b"glTF":
        return f"{path} is not a binary glTF file"
    (length,) = struct.unpack_from("<I", content, 8)
    if length != len(content):
        return f"{path} has {len(content)} bytes where its header says {length}"
    place = 12
    kinds: list[bytes] = []
    while place + 8 <= length:
        size, kind = struct.unpack_from("<I4s", content, place)
        if not kinds:
            try:
                json.loads(content[place + 8 : place + 8 + size])
            except ValueError as error:
                return f"{path} has JSON that cannot be read: {error}"
        kinds.append(kind)
        place += 8 + size
    if place != length or not kinds or tuple(kinds) != _GLB_CHUNKS[: len(kinds)]:
        return f"{path} has chunks that do not fill it"
    return ""


def _changed(path: str, *, compared: bool) -> Finding:
    """Return the finding for a changed file.

    Textures may be replaced, and other checks compare main files: these changes are notes. Changes of meshes,
    tables and layers are faults.
    """
    looks = PurePosixPath(path).suffix.lower() in _LOOKS
    message = f"{path} was changed after the export: its digest is not the one in {ASSET_FILE}"
    if looks or compared:
        hint = "keep it if the change was intended; otherwise export the asset again"
        return Finding("files", message, hint=hint, severity="note")
    hint = "export the asset again; keep files of your own in another directory"
    return Finding("files", message, hint=hint)


FORMAT_CHECKS = DEFAULT_FORMATS
"""Checks that read back the main file of one format each."""

_SHOWN = 3  # most files in one message


@dataclass(frozen=True)
class Exported:
    """An export and the result of its check `files`.

    Attributes:
        directory: Directory of the export.
        result: Result of the check `files`.
        asset: The asset; None if it cannot be read.
        formats: Files of each format, by name of the format.
    """

    directory: Path
    result: CheckResult
    asset: Asset | None = None
    formats: Mapping[str, tuple[str, ...]] = field(default_factory=dict)

    @property
    def meshes(self) -> bool:
        """Whether the visible faces were exported."""
        paths = (path for files in self.formats.values() for path in files)
        return any(path.startswith(f"{MESH_DIRECTORY}/") and path.endswith(".obj") for path in paths)


def read_export(directory: str | Path) -> Exported:
    """Read an exported asset and run the check `files`.

    Raises:
        ExportError: The directory is not an export: it has no `asset.json`.
    """
    directory = Path(directory)
    if not (directory / ASSET_FILE).is_file():
        what = "has no asset.json" if directory.is_dir() else "is not a directory"
        raise ExportError(f"{directory} {what}; give a directory that artgen exported an asset to")
    try:
        data = json.loads((directory / ASSET_FILE).read_text(encoding="utf-8"))
        formats = {name: tuple(map(str, each["files"])) for name, each in data["formats"].items()}
        coarse = any("mesh_precision" in each for each in data["links"])
        certified = data.get("certificate") is not None and not coarse  # coarse exports have no proof
        digests = dict(data.get("digests", {}))
    except (OSError, ValueError, LookupError, TypeError, AttributeError) as error:
        return _unreadable(directory, error)
    try:
        asset = Asset.load(directory)
    except Exception as error:  # noqa: BLE001 - a damaged file may raise anything
        damaged = _unreadable(directory, error, formats)
        certificate = _wrong_certificate(directory, certified=certified)
        result = CheckResult("files", (*certificate, *damaged.result.findings))
        return Exported(directory, result, formats=formats)
    compared = {data["formats"][name].get("main") for name in FORMAT_CHECKS if name in formats}
    contents = read_contents(directory, formats, digests, compared)
    findings = (
        *_layout_findings(data, formats),
        *_digest_findings(formats, digests, contents.found),
        *_wrong_certificate(directory, certified=certified),
        *_file_findings(contents, formats),
        *_stray(directory, formats),
    )
    listed = {path for files in formats.values() for path in files}
    detail = f"{len(listed) + 1 + certified} files: {', '.join(formats) or 'no format'}"
    return Exported(directory, CheckResult("files", findings, detail), asset, formats)


def _unreadable(
    directory: Path, error: Exception, formats: Mapping[str, tuple[str, ...]] | None = None
) -> Exported:
    finding = Finding("files", f"{ASSET_FILE} cannot be read: {_reason(error)}", hint=AGAIN)
    return Exported(directory, CheckResult("files", (finding,)), formats=formats or {})


def _reason(error: Exception) -> str:
    return str(error) if isinstance(error, OSError | ValueError) else f"{type(error).__name__}: {error}"


def _wrong_certificate(directory: Path, *, certified: bool) -> Iterator[Finding]:
    path = directory / CERTIFICATE_FILE
    if not certified:
        return
    again = "certify the asset and export it again"
    try:
        json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        yield Finding("files", f"{CERTIFICATE_FILE} with the proof is missing", hint=again)
    except (OSError, ValueError) as error:
        yield Finding("files", f"{CERTIFICATE_FILE} cannot be read: {_reason(error)}", hint=again)


def _file_findings(contents: Contents, formats: Mapping[str, tuple[str, ...]]) -> Iterator[Finding]:
    users = users_of(formats)
    for path in users:
        if path in contents.faults:
            names = users[path]
            text = contents.faults[path]
            if not text.startswith(ASSET_FILE):
                text += f", which {' and '.join(names)} need{'s' * (len(names) == 1)}"
            yield Finding("files", text, hint=AGAIN)
        elif path in contents.changes:
            yield contents.changes[path]


def users_of(formats: Mapping[str, tuple[str, ...]]) -> dict[str, list[str]]:
    """Return the formats of each listed file."""
    users: dict[str, list[str]] = {}
    for name, files in formats.items():
        for path in files:
            users.setdefault(path, []).append(name)
    return users


def _layout_findings(data: Mapping[str, Any], formats: Mapping[str, tuple[str, ...]]) -> Iterator[Finding]:
    """Yield an unknown layout, formats that the layout does not have, and missing main files."""
    name = str(data.get("layout", "flat"))
    if name not in LAYOUTS:
        message = f"{ASSET_FILE} has the unknown layout {name!r}.{nearest(name, LAYOUTS)}"
        yield Finding("files", message, hint=AGAIN)
    elif foreign := [each for each in formats if each not in LAYOUTS[name].formats]:
        message = f"{ASSET_FILE} has the layout {name!r}, which has no {', '.join(foreign)}"
        yield Finding("files", message, hint=AGAIN)
    if not formats:
        yield Finding("files", f"{ASSET_FILE} lists no format, so nothing can be read", hint=AGAIN)
    for form, files in formats.items():
        main = data["formats"][form].get("main")
        if main not in files:
            message = f"the main file of {form} is {main!r}, which {ASSET_FILE} does not list"
            yield Finding("files", message, hint=AGAIN)


def _digest_findings(
    formats: Mapping[str, tuple[str, ...]], digests: Mapping[str, str], existing: Collection[str]
) -> Iterator[Finding]:
    """Yield files without a digest, and digests of files that are not listed."""
    listed = {path for files in formats.values() for path in files}
    for paths, says in (
        (set(existing) - set(digests), "has no digest of {}, so changes cannot be noticed"),
        (set(digests) - listed, "has a digest of {}, which no format lists"),
    ):
        if paths:
            named = ", ".join(sorted(paths)[:_SHOWN])
            named += f" and {len(paths) - _SHOWN} more" if len(paths) > _SHOWN else ""
            message = f"{ASSET_FILE} {says.format(named)}"
            yield Finding("files", message, value=float(len(paths)), hint=AGAIN)


def _stray(directory: Path, formats: Mapping[str, tuple[str, ...]]) -> Iterator[Finding]:
    """Yield files that artgen did not write: faults next to its meshes, notes elsewhere."""
    listed = {path for files in formats.values() for path in files}
    folders = {PurePosixPath(path).parent.as_posix() for path in listed} - {"."}
    for path in sorted(directory.rglob("*")):
        place = path.relative_to(directory)
        name = place.as_posix()
        if (path.is_dir() and not path.is_symlink()) or name in listed:
            continue
        if name in (ASSET_FILE, CERTIFICATE_FILE, REPORT_FILE):
            continue
        ours = place.parent.as_posix() in folders
        yield Finding(
            "files",
            f"{name} is not listed in {ASSET_FILE}",
            hint="move it away: simulators that search meshes by name may load it" if ours else "",
            severity="fault" if ours else "note",
        )
