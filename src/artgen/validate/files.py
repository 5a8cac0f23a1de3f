"""Checks of the files of an export, which are complete, unchanged and readable, and of its certificate."""

import json
import os
import struct
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass, field
from functools import partial
from io import BytesIO
from pathlib import Path, PurePosixPath
from typing import Any

from artgen.asset import Asset
from artgen.asset.asset import OUTDATED
from artgen.asset.certificate import Certificate, PairResult, spelled_region
from artgen.asset.collision import mesh_precision
from artgen.asset.files import ASSET_FILE, CERTIFICATE_FILE, MESH_DIRECTORY, file_content
from artgen.asset.report import AGAIN, CheckResult, Finding
from artgen.errors import ExportError, nearest
from artgen.export.files import REACH_FILE, READER_FILE, REPORT_FILE, STATES_FILE, digest
from artgen.export.layouts import DEFAULT_FORMATS, LAYOUTS

Formats = Mapping[str, tuple[str, ...]]
"""Files of each format."""

_TEXTS = {".urdf", ".sdf", ".xml", ".usda", ".obj", ".mtl", ".json", ".txt"}
_LOOKS = {".png", ".jpg", ".mtl"}
_GLB_CHUNKS = [b"JSON", b"BIN\0"]
_LISTED = 3  # most files in one message

_CERTIFY = (
    "generate with certification or asset.certify() before export; colliders of other kinds than 'exact' are "
    "proven by artgen.Asset.load(directory).certify()"
)
_MEND = "shorten the limits to asset.safe_limits(), or move the pivot"
_MEND_AT_REST = (
    "they overlap at rest: move one of the parts, or allow the contact with body.allow_contact(...)"
)
_MEND_OPEN = "give the two pieces more clearance there, or shorten the limits to asset.safe_limits()"

_fault = partial(Finding, "files", hint=AGAIN)
_unproven = partial(Finding, "certificate")


def _read(directory: Path, path: str) -> tuple[str, bytes]:
    """Return the fault and the content of a file; the fault is empty if there is none."""
    try:
        # a link out of the export breaks when the directory is copied
        if not Path(os.path.realpath(directory / path)).is_relative_to(os.path.realpath(directory)):
            return f"{path} is a link that leads out of the directory", b""
        content = file_content(directory / path)
    except FileNotFoundError:
        return f"{path} is missing", b""
    except OSError as error:
        return f"{path} cannot be read ({error.strerror})", b""
    return _fault_of(path, content) if content else f"{path} is empty", content


def _fault_of(path: str, content: bytes) -> str:
    """Return the fault of a content; empty if there is none."""
    from PIL import Image

    suffix = PurePosixPath(path).suffix.lower()
    if suffix == ".png":
        try:
            with Image.open(BytesIO(content)) as image:
                image.load()
        # errors of Pillow for damaged PNG, and for one that would fill the memory
        except (OSError, SyntaxError, ValueError, Image.DecompressionBombError):
            return f"{path} is not a readable image"
    if suffix == ".glb":
        return _fault_of_glb(path, content)
    if suffix in _TEXTS:
        try:
            content.decode("utf-8")
        except UnicodeDecodeError as error:
            return f"{path} is not UTF-8 text: byte {error.start} is {content[error.start]:#04x}"
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
            except (ValueError, RecursionError) as error:
                return f"{path} has JSON that cannot be read: {error}"
        kinds.append(kind)
        place += 8 + size
    if place != length or not kinds or kinds != _GLB_CHUNKS[: len(kinds)]:
        return f"{path} has chunks that do not fill it"
    return ""


@dataclass(frozen=True)
class Exported:
    """An export and the result of its check `files`."""

    result: CheckResult  # result of the check `files`
    asset: Asset | None = None  # None if it cannot be read
    formats: Formats = field(default_factory=dict)  # files of each format
    layout: str = "flat"

    @property
    def meshes(self) -> bool:
        """Whether the visible faces were exported."""
        paths = [path for files in self.formats.values() for path in files]
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
        data = json.loads(file_content(directory / ASSET_FILE))
        formats = {name: tuple(map(str, each["files"])) for name, each in data["formats"].items()}
        coarse = any("mesh_precision" in each for each in data["links"])
        certified = data.get("certificate") is not None and not coarse  # coarse exports have no proof
        digests = dict(data.get("digests", {}))
    except (OSError, ValueError, LookupError, TypeError, AttributeError, RecursionError) as error:
        return Exported(CheckResult("files", (_unreadable(ASSET_FILE, error),)))
    findings = list(_certificate_findings(directory)) if certified else []
    try:
        asset = Asset.load(directory)
    except Exception as error:  # noqa: BLE001 - a damaged file may raise anything
        result = CheckResult("files", (*findings, _unreadable(ASSET_FILE, error)))
        return Exported(result, formats=formats)
    users: dict[str, list[str]] = {}  # formats of each file
    for name, files in formats.items():
        for path in files:
            users.setdefault(path, []).append(name)
    users |= {path: ["the set of valid states"] for path in (STATES_FILE, READER_FILE) if path in digests}
    read = {path: _read(directory, path) for path in users}
    sound = {path: content for path, (fault, content) in read.items() if not fault}
    findings[:0] = [*_layout_findings(data, formats), *_digest_findings(users, digests, sound)]
    compared = {data["formats"][name].get("main") for name in DEFAULT_FORMATS if name in formats}
    for path, names in users.items():
        if path not in sound:
            needs = f"{' and '.join(names)} need{'s' * (len(names) == 1)}"
            findings.append(_fault(f"{read[path][0]}, which {needs}"))
        elif path in digests and digest(sound[path]) != digests[path]:
            findings.append(_changed(path, compared=path in compared))
    findings += _stray(directory, users)
    detail = f"{len(users) + 1 + certified} files: {', '.join(formats) or 'no format'}"
    layout = str(data.get("layout", "flat"))
    return Exported(CheckResult("files", tuple(findings), detail), asset, formats, layout)


def _unreadable(file: str, error: Exception, hint: str = AGAIN) -> Finding:
    reason = str(error) if isinstance(error, OSError | ValueError) else f"{type(error).__name__}: {error}"
    return Finding("files", f"{file} cannot be read: {reason.removesuffix(f'; {hint}')}", hint=hint)


def _certificate_findings(directory: Path) -> Iterator[Finding]:
    hint = "certify the asset and export it again"
    try:
        json.loads(file_content(directory / CERTIFICATE_FILE))
    except FileNotFoundError:
        yield Finding("files", f"{CERTIFICATE_FILE} with the proof is missing", hint=hint)
    except (OSError, ValueError, RecursionError) as error:
        yield _unreadable(CERTIFICATE_FILE, error, hint)


def _changed(path: str, *, compared: bool) -> Finding:
    """Return the finding for a changed file."""
    # textures may be replaced, and other checks compare main files: these are notes, the rest faults
    message = f"{path} was changed after the export: its digest is not the one in {ASSET_FILE}"
    if compared or PurePosixPath(path).suffix.lower() in _LOOKS:
        hint = "keep it if the change was intended; otherwise export the asset again"
        return _fault(message, hint=hint, severity="note")
    return _fault(message, hint="export the asset again; keep files of your own in another directory")


def _layout_findings(data: Mapping[str, Any], formats: Formats) -> Iterator[Finding]:
    """Yield an unknown layout, formats that the layout does not have, and missing main files."""
    name = str(data.get("layout", "flat"))
    if name not in LAYOUTS:
        yield _fault(f"{ASSET_FILE} has the unknown layout {name!r}.{nearest(name, LAYOUTS)}")
    elif foreign := [each for each in formats if each not in LAYOUTS[name].formats]:
        yield _fault(f"{ASSET_FILE} has the layout {name!r}, which has no {', '.join(foreign)}")
    if not formats:
        yield _fault(f"{ASSET_FILE} lists no format, so nothing can be read")
    for form, files in formats.items():
        main = data["formats"][form].get("main")
        if main not in files:
            yield _fault(f"the main file of {form} is {main!r}, which {ASSET_FILE} does not list")


def _digest_findings(
    listed: Collection[str], digests: Mapping[str, str], sound: Collection[str]
) -> Iterator[Finding]:
    """Yield files without a digest, and digests of files that are not listed."""
    for paths, text in (
        (set(sound) - set(digests), "has no digest of {}, so changes cannot be noticed"),
        (set(digests) - set(listed), "has a digest of {}, which no format lists"),
    ):
        if paths:
            named = ", ".join(sorted(paths)[:_LISTED])
            named += f" and {len(paths) - _LISTED} more" if len(paths) > _LISTED else ""
            yield _fault(f"{ASSET_FILE} {text.format(named)}", value=float(len(paths)))


def _stray(directory: Path, listed: Collection[str]) -> Iterator[Finding]:
    """Yield files that artgen did not write: faults next to its meshes and if they may never end."""
    known = {*listed, ASSET_FILE, CERTIFICATE_FILE, REPORT_FILE, REACH_FILE}
    folders = {PurePosixPath(path).parent.as_posix() for path in listed} - {"."}
    for path in sorted(directory.rglob("*")):
        place = path.relative_to(directory)
        if (path.is_dir() and not path.is_symlink()) or place.as_posix() in known:
            continue
        shown = os.fsencode(place).decode("utf-8", "backslashreplace")  # reports are UTF-8, names may be any
        message = f"{shown} is not listed in {ASSET_FILE}"
        if path.exists() and not path.is_file():
            yield _fault(f"{message}, and is a device, a pipe or a socket", hint="remove it")
        elif place.parent.as_posix() in folders:
            yield _fault(message, hint="move it away: simulators that search meshes by name may load it")
        else:
            yield Finding("files", message, severity="note")


def check_certificate(asset: Asset, *, meshes: bool = True) -> CheckResult:
    """Check that an asset has a certificate for all pairs and that its proof is valid.

    `artgen.proof.recheck` verifies the stored proof independently of the search.
    """
    certificate = asset.certificate
    if certificate is None:
        reason = "there is no certificate"
        if vars(asset).get(OUTDATED):
            reason = f"{ASSET_FILE} has other colliders, joints or contacts than those that were certified"
        message = f"{reason}: nothing is proven about collisions between its links"
        return CheckResult("certificate", (_unproven(message, hint=_CERTIFY),))
    findings = [_pair_finding(asset, pair) for pair in certificate.failures]
    for contact in certificate.contacts:
        if contact not in asset.contacts:
            message = f"the certificate allows a contact that the asset does not declare: {contact}"
            link, hint = ", ".join(contact.links), "certify the asset again"
            findings.append(_unproven(message, link, value=contact.depth, unit="m", hint=hint))
    if mesh_precision(*asset.links):
        message = "an export with a mesh precision does not keep it"
        hint = "export with mesh_precision=0 as well"
    elif not meshes:
        message = "the export has no meshes to compare its pieces with"
        hint = "export with urdf or mjcf as well"
    else:
        from artgen.proof.recheck import recheck

        return CheckResult("certificate", (*findings, *recheck(asset, certificate)), _detail(certificate))
    findings.append(_unproven(f"the proof is not verified: {message}", hint=hint, severity="note"))
    return CheckResult("certificate", tuple(findings), _detail(certificate))


def _detail(certificate: Certificate) -> str:
    count = len(certificate.pairs)
    pairs = f"{count} pair{'' if count == 1 else 's'} of links"
    parts = [f"{pairs}, tolerance {1e3 * certificate.tolerance:.4g} mm" if count else "nothing moves"]
    closest = certificate.clearance
    if closest is not None and closest.guaranteed is not None:
        parts.append(f"{' and '.join(closest.links)} never closer than {1e3 * closest.guaranteed:.4g} mm")
    if certificate.contacts:
        parts.append("allowed contacts: " + "; ".join(map(str, certificate.contacts)))
    return ", ".join(parts)


def _pair_finding(asset: Asset, pair: PairResult) -> Finding:
    """Return the collision of a pair, or the region in which it is not proven."""
    link, witness = ", ".join(pair.links), pair.witness
    if witness is None:
        which = "not proven" if pair.verdict != "proven" else "not proven for their colliders"
        message = f"{which} in {100 * pair.open_fraction:.3g} % of their joint space"
        pose: dict[str, float] = {}
        if pair.open_cells:
            cell = pair.open_cells[0]
            first, second = cell.labels
            where = f"where {first} is {1e3 * cell.distance:.3f} mm from {second}"
            if pair.seconds is not None:
                message, where = f"not proven after {pair.seconds:g} s", f"for {first} and {second}"
            message += f", such as {spelled_region(cell.region)}, {where}"
            pose = {name: (low + high) / 2 for name, (low, high) in cell.region.items()}
        return _unproven(message, link, value=pair.open_fraction, pose=pose, hint=_MEND_OPEN)
    first, second = witness.labels
    x, y, z = witness.place
    contact = ", ".join(f"{name}={position:.4g}" for name, position in witness.first_contact.items())
    at_rest = all(
        abs(position - asset.joint(name).closed) < 1e-9 for name, position in witness.first_contact.items()
    )
    both = pair.verdict == "collision"
    message = (
        f"{'they collide' if both else 'only their colliders collide, not their solids'}: "
        f"{first} presses {1e3 * witness.depth:.3f} mm into {second} "
        f"at ({x:.3f}, {y:.3f}, {z:.3f}) m; first contact at {'rest' if at_rest else contact}"
    )
    hint = _MEND_AT_REST if at_rest else _MEND
    if not both:
        hint = f"{hint}; or give their solids colliders or covers that stay closer to them"
    return _unproven(message, link, value=witness.depth, unit="m", pose=witness.pose, hint=hint)
