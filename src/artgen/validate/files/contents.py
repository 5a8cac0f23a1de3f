"""The contents of an export's files: there, whole, readable, and as they were exported."""

import json
import struct
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath

from artgen.asset.files import ASSET_FILE
from artgen.asset.report import Finding
from artgen.export.files import digest

_TEXTS = {".urdf", ".xml", ".usda", ".obj", ".mtl", ".json", ".txt"}
_LOOKS = {".png", ".jpg", ".mtl"}
_GLB_CHUNKS = (b"JSON", b"BIN\0")


@dataclass(frozen=True)
class Contents:
    """The contents of the files of an export.

    Attributes:
        found: Content of each file that can be read, by path.
        faults: What is wrong with a file, by path; the text begins with the path.
        changes: What is said of a file that is whole but was changed after the export.
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
        digests: What the files had as digests when they were exported.
        mains: The files that another check reads and compares with the asset.
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
    """Return the error of reading a file, and its content."""
    try:
        # a link between two files of the export is the user's; one to elsewhere does not travel with it
        if not (directory / path).resolve().is_relative_to(directory.resolve()):
            return f"{path} is a link that leads out of the directory", b""
        content = (directory / path).read_bytes()
    except FileNotFoundError:
        return f"{path} is missing", b""
    except OSError as error:
        return f"{path} cannot be read ({error.strerror})", b""
    return ("" if content else f"{path} is empty"), content


def _fault_of(path: str, content: bytes) -> str:
    """Return the fault of a content; an empty text if it can be read."""
    suffix = PurePosixPath(path).suffix.lower()
    if suffix == ".png":
        return _fault_of_image(path, content)
    if suffix == ".glb":
        return _fault_of_glb(path, content)
    if suffix in _TEXTS:
        try:
            content.decode("utf-8")
        except UnicodeDecodeError as error:
            return f"{path} is no UTF-8 text: byte {error.start} is {content[error.start]:#04x}"
    return ""


def _fault_of_image(path: str, content: bytes) -> str:
    from io import BytesIO

    from PIL import Image

    try:
        with Image.open(BytesIO(content)) as image:
            image.load()
    except (OSError, SyntaxError, ValueError):  # what Pillow raises at damaged PNG
        return f"{path} is no image that can be decoded"
    return ""


def _fault_of_glb(path: str, content: bytes) -> str:
    """Say what is wrong with the frame of a binary glTF file: a header, and chunks that fill it."""
    if len(content) < 12 or content[:4] != b"glTF":
        return f"{path} is no binary glTF file"
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
    """Tell of a changed file: a note where another check compares what it says, or where it is only looks.

    Replaced textures are allowed. What no check compares with the asset is a fault: meshes, from which
    the asset's own faces are read, and tables and layers beside the main files.
    """
    looks = PurePosixPath(path).suffix.lower() in _LOOKS
    message = f"{path} was changed after the export: its digest is not the one in {ASSET_FILE}"
    if looks or compared:
        hint = "right if you meant to; export the asset again to have artgen's"
        return Finding("files", message, hint=hint, severity="note")
    hint = "export the asset again; keep files of your own in another directory"
    return Finding("files", message, hint=hint)
