"""Pictures: color, and the link, label, depth and normal of each pixel."""

from collections.abc import Callable
from dataclasses import dataclass
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array, cached_property
from artgen._names import checked_path
from artgen.errors import AssetError, ExportError, ParameterError, nearest
from artgen.view.camera import Camera

Pixels = NDArray[np.uint8]

_SIZES = (16, 4096)  # fewest and most pixels per side
_SUFFIXES = {".png": "PNG", ".jpg": "JPEG", ".jpeg": "JPEG"}


@dataclass(frozen=True, eq=False)
class Segmentation:
    """Link or label of each pixel.

    Attributes:
        ids: Number of the name at each pixel, 0 for the background, shape (height, width).
        names: The names; the first is empty, for the background.
    """

    ids: NDArray[np.int32]
    names: tuple[str, ...]

    def mask(self, name: str) -> NDArray[np.bool_]:
        """Return the pixels of a name, shape (height, width).

        Raises:
            AssetError: There is no such name.
        """
        if name not in self.names:
            raise AssetError(f"nothing in the picture is named {name!r}.{nearest(name, self.names[1:])}")
        return np.asarray(self.ids == self.names.index(name))


@dataclass(frozen=True, eq=False)
class Picture:
    """A picture of an asset; all but the colors is drawn on first use.

    Attributes:
        color: sRGB, shape (height, width, 3).
        camera: The camera, in asset coordinates.
        link_names: Link of each surface.
        label_names: Semantic label of each surface.
    """

    color: Pixels
    camera: Camera
    link_names: tuple[str, ...]
    label_names: tuple[str, ...]
    # number of the surface at each pixel's center from 1, 0 for none, and its depth along the camera's axis
    # [m], infinite for none; both of shape (height, width)
    _draw_surfaces: Callable[[], tuple[NDArray[np.int32], Array]]
    _draw_normals: Callable[[], Array]  # the values of `normals`

    def __repr__(self) -> str:
        height, width = self.color.shape[:2]
        return f"<picture, {width} x {height} pixels; save(path) writes it>"

    @cached_property
    def _surfaces(self) -> tuple[NDArray[np.int32], Array]:
        return self._draw_surfaces()

    @property
    def depth(self) -> Array:
        """Depth along the camera's axis, infinite for the background, shape (height, width) [m]."""
        return self._surfaces[1]

    @cached_property
    def links(self) -> Segmentation:
        """Index of the link at each pixel's center; glass hides the links behind it."""
        return self._by(self.link_names)

    @cached_property
    def labels(self) -> Segmentation:
        """Index of the semantic label at each pixel's center; glass hides the labels behind it."""
        return self._by(self.label_names)

    @cached_property
    def normals(self) -> Array:
        """Unit normals in asset coordinates, zero for the background, shape (height, width, 3)."""
        return self._draw_normals()

    def _by(self, of_surface: tuple[str, ...]) -> Segmentation:
        names = ("", *dict.fromkeys(of_surface))
        table = np.array([0, *(names.index(name) for name in of_surface)], np.int32)
        return Segmentation(table[self._surfaces[0]], names)

    def save(self, path: str | Path) -> Path:
        """Write the colors to a PNG or JPEG file.

        Raises:
            ExportError: The name has another suffix, or the file cannot be written.
            ParameterError: The path is none.
        """
        return save_image(self.color, path)


def jpeg(pixels: Pixels, quality: int) -> bytes:
    """Return sRGB pixels, shape (height, width, 3), as a JPEG file."""
    from PIL import Image

    file = BytesIO()
    Image.fromarray(pixels).save(file, "JPEG", quality=quality, optimize=True)
    return file.getvalue()


def save_image(pixels: Pixels, path: str | Path) -> Path:
    """Write sRGB pixels, shape (height, width, 3), to a PNG or JPEG file.

    Raises:
        ExportError: The name has another suffix, or the file cannot be written.
        ParameterError: The path is none.
    """
    from PIL import Image

    path = checked_path(path, "path")
    check_suffix(path)
    try:
        Image.fromarray(pixels).save(path, _SUFFIXES[path.suffix.lower()], quality=92)
    except OSError as error:
        raise ExportError(f"cannot write {path}: {error.strerror or error}") from error
    return path


def check_suffix(path: Path) -> None:
    """Raise an ExportError unless a file's name has the suffix of PNG or JPEG."""
    if path.suffix.lower() not in _SUFFIXES:
        raise ExportError(f"cannot write {path}: a picture's name ends in {', '.join(_SUFFIXES)}")


def checked_size(size: Any) -> tuple[int, int]:
    """Return the width and height of a picture.

    Raises:
        ParameterError: The size is not allowed.
    """
    both = (size, size) if isinstance(size, int | np.integer) and not isinstance(size, bool) else size
    try:
        width, height = both
        allowed = all(int(each) == each and _SIZES[0] <= each <= _SIZES[1] for each in both)
    except (TypeError, ValueError):
        allowed = False
    if not allowed:
        raise ParameterError(
            f"size {size!r} must be one or two whole numbers in {_SIZES[0]}..{_SIZES[1]}: width and height "
            "[pixels]"
        )
    return int(width), int(height)
