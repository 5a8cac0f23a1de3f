"""Digests of exported files, by which a file that was changed later is known."""

import hashlib
import zlib
from collections.abc import Mapping

_PNG = b"\x89PNG\r\n\x1a\n"


def digests(files: Mapping[str, bytes]) -> dict[str, str]:
    """Return the digest of each file by its path, in the order of the paths."""
    return {path: digest(files[path]) for path in sorted(files)}


def digest(content: bytes) -> str:
    """Return the SHA-256 of a file in hexadecimal digits; of a PNG file, of what it says unpacked.

    Machines differ in how they pack the same texels, so the bytes of a PNG file would make `asset.json`
    differ as well.
    """
    unpacked = _unpacked(content) if content.startswith(_PNG) else None
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
