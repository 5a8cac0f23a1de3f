"""Digests of exported files, by which a file that was changed later is known."""

import hashlib
import zlib
from collections.abc import Mapping

from artgen.materials.textures.keep import Memory

_PNG = b"\x89PNG\r\n\x1a\n"

_MEMORY = Memory(64 * 2**20)
"""Digests of the last PNG files, by their bytes: those of the library are in every other export."""


def digests(files: Mapping[str, bytes]) -> dict[str, str]:
    """Return the digest of each file by its path, in the order of the paths."""
    return {path: digest(files[path]) for path in sorted(files)}


def digest(content: bytes) -> str:
    """Return the SHA-256 of a file in hexadecimal digits; of a PNG file, of what it says unpacked.

    Machines differ in how they pack the same texels, so the bytes of a PNG file would make `asset.json`
    differ as well.
    """
    if not content.startswith(_PNG):
        return hashlib.sha256(content).hexdigest()
    return _MEMORY.get(content, lambda: _of_texels(content), lambda _: len(content))


def _of_texels(content: bytes) -> str:
    unpacked = _unpacked(content)
    return hashlib.sha256(content if unpacked is None else unpacked).hexdigest()


def _unpacked(content: bytes) -> bytes | None:
    """Return the chunks of a PNG file with its texels unpacked; None where it is damaged."""
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
        return None
