"""Contact sheets: many samples of a category on one page, each closed and open, with what tells it apart."""

import io
import re
from collections.abc import Callable, Sequence
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from artgen.asset import Asset
from artgen.errors import ExportError, ParameterError
from artgen.view.camera import View
from artgen.view.opening import opened
from artgen.view.rendering import Backend, close, render

Pixels = NDArray[np.uint8]

SIDES = (View(-0.5, 0.22), View(np.pi - 0.5, 0.22))
"""From where the samples of a sheet are seen: from in front, and from behind."""

_SHADE = re.compile("_[0-9a-f]{6}$")  # ends the name of a material in a shade of its own
_TITLE, _TEXT, _GAP = 15, 12, 12  # sizes of type, and what stays free around an asset [pixels]
_INK, _GREY = (30, 30, 32), (110, 110, 114)
_PAGE = 1.5  # width of a page over its height
_BYTES = 300_000  # what a sheet may take on a page of documentation
_QUALITIES = (90, 85, 80, 75, 70, 62, 54, 46, 38, 30, 22)


def sheet(
    assets: Sequence[Callable[[], Asset]],
    *,
    views: int = 2,
    size: int = 200,
    columns: int | None = None,
    backend: Backend = "auto",
    textures: int = 256,
    samples: int = 16,
    progress: Callable[[int, int], None] | None = None,
) -> Pixels:
    """Return a page of pictures: a cell for each asset, closed and open from each side, shape (h, w, 3).

    Args:
        assets: Makers of the assets, each called when its turn comes.
        views: How many sides, 1 or 2.
        size: Height of one picture [pixels].
        columns: Cells in a row; by default the page is about one and a half times as wide as high.
        backend: As of `render`.
        textures: As of `render`.
        samples: As of `render`.
        progress: Called with how many assets are done and how many there are.

    Raises:
        ParameterError: There are no assets, or a number is not allowed.
        RenderError: A renderer or its library is missing.
    """
    if not assets or not 1 <= views <= len(SIDES) or (columns is not None and columns < 1):
        raise ParameterError(
            f"a sheet has at least 1 asset and 1 column, and 1 or {len(SIDES)} views; "
            f"these are {len(assets)} assets, {columns} columns, {views} views"
        )
    cells: list[Pixels] = []
    picture: tuple[int, int] | None = None
    for number, make in enumerate(assets):
        asset = make()
        picture = picture or (round(size * _aspect(asset)), size)  # all cells have one size
        shown = [
            render(
                asset,
                q,
                camera=side,
                size=picture,
                backend=backend,
                textures=textures,
                samples=samples,
            ).color
            for side in SIDES[:views]
            for q in ({}, opened(asset))
        ]
        close()  # a sheet may be long, and no asset is drawn again
        cells.append(_cell(asset, shown, words(asset)))
        if progress is not None:
            progress(number + 1, len(assets))
    height, width, _ = cells[0].shape
    fitting = max(1, round((_PAGE * len(cells) * height / width) ** 0.5))
    return _page(cells, min(columns or fitting, len(cells)))


def _aspect(asset: Asset) -> float:
    """Return width divided by height of pictures of assets like one."""
    low, high = asset.bounds()
    wide, deep, tall = high - low
    return float(np.clip(1.05 * (wide + 0.5 * deep) / max(tall, 1e-9), 0.65, 1.5))


def words(asset: Asset) -> str:
    """Return what makes an asset different in a few words: its structural parameters and its size."""
    found = [
        _SHADE.sub("", value)
        for name, value in asset.parameters.items()
        if isinstance(value, str) and value and value != "none" and "." not in name
    ]
    low, high = asset.bounds()
    size = " x ".join(f"{100.0 * length:.0f}" for length in high - low)
    return ", ".join([f"{size} cm", *(word.replace("_", " ") for word in dict.fromkeys(found))])


def save_sheet(pixels: Pixels, path: str | Path) -> Path:
    """Write a sheet to a PNG file, or to a JPEG file of at most 300 kB where any quality allows it.

    Raises:
        ExportError: The name ends otherwise, or the file cannot be written.
    """
    from PIL import Image

    from artgen.view.picture import check_suffix, save_image

    path = Path(path)
    check_suffix(path)
    if path.suffix.lower() == ".png":
        return save_image(pixels, path)
    image, data = Image.fromarray(pixels), b""
    for quality in _QUALITIES:
        file = io.BytesIO()
        image.save(file, "JPEG", quality=quality, optimize=True)
        data = file.getvalue()
        if len(data) <= _BYTES:
            break
    try:
        path.write_bytes(data)
    except OSError as error:
        raise ExportError(f"cannot write {path}: {error.strerror}") from error
    return path


def _cell(asset: Asset, shown: Sequence[Pixels], text: str) -> Pixels:
    """Return pictures side by side with a caption below."""
    from PIL import Image, ImageDraw

    pictures = np.hstack(list(shown))
    lines = _wrapped(text, pictures.shape[1])
    height = _TITLE + 6 + 2 * (_TEXT + 4)
    cell = Image.new("RGB", (pictures.shape[1], pictures.shape[0] + height), "white")
    cell.paste(Image.fromarray(pictures), (0, 0))
    draw = ImageDraw.Draw(cell)
    title = asset.name if asset.seed is None else f"{asset.category} {asset.seed}"
    draw.text((4, pictures.shape[0]), title, fill=_INK, font=_font(_TITLE, "Bold"))
    for number, line in enumerate(lines[:2]):
        place = (4, pictures.shape[0] + _TITLE + 5 + number * (_TEXT + 4))
        draw.text(place, line, fill=_GREY, font=_font(_TEXT, "Regular"))
    return np.asarray(cell)


def _wrapped(text: str, width: int) -> list[str]:
    """Break a text into lines that are no wider than a number of pixels."""
    font = _font(_TEXT, "Regular")
    lines = [""]
    for word in text.split():
        longer = f"{lines[-1]} {word}".strip()
        if lines[-1] and font.getlength(longer) > width - 8:
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
