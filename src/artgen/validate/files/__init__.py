"""Checks of the files of an export: all there, none strange, and the asset can be read from them."""

import json
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath
from typing import Any

from artgen.asset import Asset
from artgen.asset.files import ASSET_FILE, CERTIFICATE_FILE, MESH_DIRECTORY
from artgen.asset.report import AGAIN, CheckResult, Finding
from artgen.errors import ExportError
from artgen.export.files import REPORT_FILE
from artgen.export.layouts import DEFAULT_FORMATS
from artgen.validate.files.contents import Contents, read_contents
from artgen.validate.files.record import record_findings
from artgen.validate.files.references import reference_findings

FORMAT_CHECKS = DEFAULT_FORMATS
"""The checks that read the main file of one format each: what simulators read is read back."""


@dataclass(frozen=True)
class Exported:
    """An export, as far as it can be read.

    Attributes:
        directory: Where it is.
        result: What is wrong with its files.
        asset: The asset; None if it cannot be read.
        formats: The files of each format, by name of the format.
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
    """Read an exported asset, and check its files: the check `files`.

    Raises:
        ExportError: The directory is no export: it has no `asset.json`.
    """
    directory = Path(directory)
    if not (directory / ASSET_FILE).is_file():
        what = "has no asset.json" if directory.is_dir() else "is no directory"
        raise ExportError(f"{directory} {what}; give a directory that artgen exported an asset to")
    try:
        data = json.loads((directory / ASSET_FILE).read_text(encoding="utf-8"))
        formats = {name: tuple(map(str, each["files"])) for name, each in data["formats"].items()}
        coarse = any("mesh_precision" in each for each in data["links"])
        certified = data.get("certificate") is not None and not coarse  # which keeps no proof
        digests = dict(data.get("digests", {}))
    except (OSError, ValueError, LookupError, TypeError, AttributeError) as error:
        return _unreadable(directory, error)
    try:
        asset = Asset.load(directory)
    except Exception as error:  # noqa: BLE001 - whatever a damaged file makes of it is the finding
        damaged = _unreadable(directory, error, formats)
        certificate = _wrong_certificate(directory, certified=certified)
        result = CheckResult("files", (*certificate, *damaged.result.findings))
        return Exported(directory, result, formats=formats)
    compared = {data["formats"][name].get("main") for name in FORMAT_CHECKS if name in formats}
    contents = read_contents(directory, formats, digests, compared)
    findings = (
        *record_findings(data, asset, formats, digests, contents.found),
        *_wrong_certificate(directory, certified=certified),
        *_file_findings(contents, formats),
        *_wrong_main_files(data, formats),
        *reference_findings(contents.found, formats),
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
        yield Finding("files", f"{CERTIFICATE_FILE} is missing, which keeps the proof", hint=again)
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
    """Return the formats that need each listed file."""
    users: dict[str, list[str]] = {}
    for name, files in formats.items():
        for path in files:
            users.setdefault(path, []).append(name)
    return users


def _wrong_main_files(data: Mapping[str, Any], formats: Mapping[str, tuple[str, ...]]) -> Iterator[Finding]:
    for name, files in formats.items():
        main = data["formats"][name].get("main")
        if main not in files:
            message = f"the main file of {name} is {main!r}, which is not among its files in {ASSET_FILE}"
            yield Finding("files", message, hint=AGAIN)


def _stray(directory: Path, formats: Mapping[str, tuple[str, ...]]) -> Iterator[Finding]:
    """Find files that are not artgen's: a fault among its meshes, where clients search; else only a note."""
    listed = {path for files in formats.values() for path in files}
    folders = _folders(listed)
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
            f"{name} is listed by no format of {ASSET_FILE}",
            hint="move it away: clients that search meshes and textures by name may take it" if ours else "",
            severity="fault" if ours else "note",
        )


def _folders(paths: Iterable[str]) -> set[str]:
    """Return the folders below the export's own that hold some of the files."""
    return {PurePosixPath(path).parent.as_posix() for path in paths} - {"."}
