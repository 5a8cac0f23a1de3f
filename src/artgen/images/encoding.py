"""Pictures, depths and normals as the bytes of files."""

from io import BytesIO
from typing import Any

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array

_PNG_LEVEL = 1  # of compression: higher ones take longer and save little
_JPEG_QUALITY = 95
_MOST = 65535  # of 16 bits


def encoded_color(pixels: NDArray[np.uint8], form: str) -> bytes:
    """Return colours, shape (height, width, 3), as PNG or JPEG."""
    return _png(pixels) if form == "png" else _encoded(pixels, "JPEG", quality=_JPEG_QUALITY)


def encoded_depth(depth: Array) -> tuple[bytes, float]:
    """Return depths as PNG of 16 bits, 0 where nothing is seen, and how much one step of it is [m]."""
    seen = np.isfinite(depth)
    scale = float(depth[seen].max()) / _MOST if seen.any() else 1.0
    steps = np.rint(np.where(seen, depth, 0.0) / scale)
    return _png(steps.astype(np.uint16)), scale


def encoded_normals(normals: Array) -> bytes:
    """Return unit normals, shape (height, width, 3), as PNG: 127.5 + 127.5 n, black where there is none."""
    seen = np.abs(normals).sum(axis=-1, keepdims=True) > 0.0
    return _png(np.where(seen, np.rint(127.5 + 127.5 * normals), 0.0).astype(np.uint8))


def _png(pixels: NDArray[Any]) -> bytes:
    return _encoded(pixels, "PNG", compress_level=_PNG_LEVEL)


def _encoded(pixels: NDArray[Any], form: str, **options: int) -> bytes:
    from PIL import Image

    content = BytesIO()
    Image.fromarray(pixels).save(content, form, **options)
    return content.getvalue()
