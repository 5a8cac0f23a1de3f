"""Contact sheets: many samples of a category on one page, closed and open, with their main features."""

import math
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np

from artgen._names import checked_path
from artgen.asset import Asset
from artgen.errors import ExportError, ParameterError
from artgen.view.camera import View, box_corners, elevation_of
from artgen.view.opening import opened
from artgen.view.picture import Pixels, check_suffix, jpeg, save_image
from artgen.view.rendering import render

ASIDE = 0.5
"""Largest angle of the camera from the front or back of a sample [rad]."""

_SHADE = re.compile("_[0-9a-f]{6}$")  # suffix of the name of a material whose shade was drawn
_TITLE, _TEXT, _GAP = 15, 12, 12  # font sizes, and free space around an asset [pixels]
_LINES = 2  # lines of a caption
_INK, _GREY = (30, 30, 32), (110, 110, 114)
_PAGE = 1.5  # width of a page relative to its height
_BYTES = 250_000  # largest size of a sheet in the documentation [bytes]
_UPRIGHT = 0.7  # vertical part of an axis above which a hinge belongs to a door
_EVEN, _MIDDLE = (
    0.3,
    0.5,
)  # tolerance for equally large doors at both sides, and the share of the angle for these
_MARGIN = 0.05  # free share of a picture along its edges
_ABOVE = 1.45  # elevation of the view of rooms from above, nearly upright [rad]
_MEASURED = 12  # number of assets that determine the shape of all pictures
_NARROW, _WIDE = 0.5, 2.0  # smallest and largest ratio of width to height of pictures
_QUALITIES = (90, 85, 80, 75, 70, 62, 54, 46, 38, 30, 22)


def sheet(
    assets: Sequence[Callable[[], Asset]],
    *,
    views: int = 2,
    size: int = 200,
    columns: int | None = None,
    textures: int = 256,
    samples: int = 8,
    progress: Callable[[int, int], None] | None = None,
) -> Pixels:
    """Return a page of pictures: a cell for each asset, closed, open and from behind, shape (h, w, 3).

    Each asset fills its pictures, and the first assets determine their shape. The camera is on the side to
    which an asset opens, and higher for small and flat assets.

    Args:
        assets: A function for each asset, which generates it.
        views: 1 for pictures from the front, 2 for one from behind as well.
        size: Height of a picture [pixels].
        columns: Number of cells side by side; by default as many as make a good page.
        textures: Texels per side of the material maps; 0 for plain colors.
        samples: Number of rays to the lamps and around for each pixel in shade, an even number.
        progress: Receives the number of finished assets, and of all.

    Raises:
        ParameterError: There are no assets, or another argument is not allowed.
        RenderError: Embree is missing.
    """
    if not assets or views not in (1, 2) or (columns is not None and columns < 1):
        raise ParameterError(
            f"a sheet needs at least 1 asset and 1 column, and 1 or 2 views, not "
            f"{len(assets)} assets, {columns} columns and {views} views"
        )
    first = [make() for make in assets[:_MEASURED]]
    picture = (round(size * float(np.median([_aspect(asset) for asset in first]))), size)
    cells: list[Pixels] = []
    for number, make in enumerate(assets):
        asset = first[number] if number < len(first) else make()
        shown = [
            render(asset, q, camera=view, size=picture, textures=textures, samples=samples).color
            for q, view in shots(asset)[: views + 1]
        ]
        cells.append(_cell(asset, shown, features(asset)))
        if progress is not None:
            progress(number + 1, len(assets))
    height, width, _ = cells[0].shape
    fitting = max(1, round((_PAGE * len(cells) * height / width) ** 0.5))
    return _page(cells, min(columns or fitting, len(cells)))


def shots(asset: Asset) -> tuple[tuple[Mapping[str, float], View], ...]:
    """Return joint positions and a view for each picture of an asset on a sheet.

    The pictures are closed, open, and closed from behind; of rooms, the last one is from above.
    """
    q = opened(asset)
    aside = _side(asset, q) * (0.2 * ASIDE if asset.is_room else ASIDE)
    front = View(aside, elevation_of(asset), margin=_MARGIN)
    last = View(0.0, _ABOVE, margin=_MARGIN) if asset.is_room else replace(front, azimuth=aside + math.pi)
    return ({}, front), (q, front), ({}, last)


def _side(asset: Asset, q: Mapping[str, float]) -> float:
    """Return the direction of the camera for an open asset, relative to `ASIDE`."""
    # from the right (+) if most doors have their hinges left; nearer to the center with doors at both sides
    poses, right, doors = asset.pose(q), 0.0, 0.0
    for joint in map(asset.joint, q):
        low, high = asset.link(joint.child).bounds()
        middle, wide = (low + high) / 2.0, high[0] - low[0]
        off = middle[0] - joint.pivot[0]
        if joint.kind == "revolute" and abs(joint.axis[2]) > _UPRIGHT and abs(off) > wide / 4.0:
            pose = poses[joint.child]
            nearer = middle[1] - (pose[:3, :3] @ middle + pose[:3, 3])[1]
            size = wide * (high[2] - low[2])
            doors += size
            right += math.copysign(size, off * nearer)
    between = doors > 0.0 and abs(right) < _EVEN * doors
    return math.copysign(_MIDDLE if between else 1.0, right or -1.0)


def _aspect(asset: Asset) -> float:
    """Return the ratio of width to height of pictures that an asset fills."""
    found = []
    for q, view in shots(asset):
        poses = asset.pose(q)
        points = np.concatenate([box_corners(link.bounds(), poses[link.name]) for link in asset.links])
        seen = view.camera(points).pixels(points, (1000, 1000))
        wide, high = np.ptp(seen, axis=0)
        found.append(wide / high)
    return float(np.clip(np.mean(found), _NARROW, _WIDE))


def features(asset: Asset) -> str:
    """Return the main features of an asset as a short text: its size and its structural parameters."""
    found = [
        _SHADE.sub("", value)
        for name, value in asset.parameters.items()
        if isinstance(value, str) and value and value != "none" and "." not in name and not asset.is_room
    ]
    low, high = asset.bounds()
    size = " x ".join(f"{100.0 * length:.0f}" for length in high - low)
    return ", ".join([f"{size} cm", *(word.replace("_", " ") for word in dict.fromkeys(found))])


def save_sheet(pixels: Pixels, path: str | Path) -> Path:
    """Write a sheet to a PNG file, or to a JPEG file of at most 250 kB if a quality allows it."""
    path = checked_path(path, "path")
    check_suffix(path)
    if path.suffix.lower() == ".png":
        return save_image(pixels, path)
    content = b""
    for quality in _QUALITIES:
        content = jpeg(pixels, quality)
        if len(content) <= _BYTES:
            break
    try:
        path.write_bytes(content)
    except OSError as error:
        raise ExportError(f"cannot write {path}: {error.strerror}") from error
    return path


def _cell(asset: Asset, shown: Sequence[Pixels], text: str) -> Pixels:
    """Return pictures side by side with a caption below."""
    from PIL import Image, ImageDraw

    pictures = np.hstack(list(shown))
    lines = _wrapped(text, pictures.shape[1])
    height = _TITLE + 6 + _LINES * (_TEXT + 4)
    cell = Image.new("RGB", (pictures.shape[1], pictures.shape[0] + height), "white")
    cell.paste(Image.fromarray(pictures), (0, 0))
    draw = ImageDraw.Draw(cell)
    title = asset.name if asset.seed is None else f"{asset.category} {asset.seed}"
    draw.text((4, pictures.shape[0]), title, fill=_INK, font=_font(_TITLE, "Bold"))
    for number, line in enumerate(lines):
        place = (4, pictures.shape[0] + _TITLE + 5 + number * (_TEXT + 4))
        draw.text(place, line, fill=_GREY, font=_font(_TEXT, "Regular"))
    return np.asarray(cell)


def _wrapped(text: str, width: int) -> list[str]:
    """Break a text into the lines of a caption, each of at most this width [pixels]."""
    font = _font(_TEXT, "Regular")
    lines = [""]
    for word in text.split():
        longer = f"{lines[-1]} {word}".strip()
        if lines[-1] and font.getlength(longer) > width - 24:
            if len(lines) == _LINES:
                return [*lines[:-1], lines[-1].rstrip(",") + " ..."]
            lines.append(word)
        else:
            lines[-1] = longer
    return lines


def _page(cells: Sequence[Pixels], columns: int) -> Pixels:
    height, width, _ = cells[0].shape
    rows = -(-len(cells) // columns)
    page = np.full((rows * (height + _GAP) + _GAP, columns * (width + _GAP) + _GAP, 3), 255, np.uint8)
    for number, cell in enumerate(cells):
        top = _GAP + number // columns * (height + _GAP)
        left = _GAP + number % columns * (width + _GAP)
        page[top : top + height, left : left + width] = cell
    return page


@lru_cache(maxsize=4)
def _font(size: int, style: str) -> Any:
    import font_roboto
    from PIL import ImageFont

    path = {"Regular": font_roboto.Roboto, "Bold": font_roboto.RobotoBold}[style]
    return ImageFont.truetype(path, size)
