"""PNG files of maps: a third of the time of general encoders, and as small."""

import struct
import zlib

import numpy as np
from numpy.typing import NDArray

_SIGNATURE = b"\x89PNG\r\n\x1a\n"
_GREY, _COLOR = 0, 2
_UP = 2  # each texel as difference from the one above: patterns run along v


def png(pixels: NDArray[np.uint8]) -> bytes:
    """Return a PNG file of grey texels, shape (n, m), or of RGB, shape (n, m, 3)."""
    height, width = pixels.shape[:2]
    lines = pixels.reshape(height, -1)
    rows = np.empty((height, lines.shape[1] + 1), np.uint8)
    rows[:, 0] = _UP
    rows[0, 1:] = lines[0]
    np.subtract(lines[1:], lines[:-1], out=rows[1:, 1:])
    packer = zlib.compressobj(1, zlib.DEFLATED, 15, 9, zlib.Z_RLE)
    data = packer.compress(rows.tobytes()) + packer.flush()
    head = struct.pack(">IIBBBBB", width, height, 8, _GREY if pixels.ndim == 2 else _COLOR, 0, 0, 0)
    return _SIGNATURE + _chunk(b"IHDR", head) + _chunk(b"IDAT", data) + _chunk(b"IEND", b"")


def _chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
