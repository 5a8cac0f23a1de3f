"""The gallery: a page of many assets with pictures and filters, with links to their viewers."""

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from artgen.asset import Asset
from artgen.asset.record import plain
from artgen.errors import ArtgenError, AssetError, ExportError, RenderError
from artgen.export.files import write_file
from artgen.export.thumbnail import thumbnail
from artgen.view.page import page_html
from artgen.view.picture import jpeg
from artgen.view.rendering import render
from artgen.view.sheet import features, shots
from artgen.view.viewer import page_of

INDEX = "index.html"
"""File name of the gallery's page."""

_MARK = '<meta name="generator" content="artgen gallery">'  # identifies an earlier gallery
_SCRIPTS = ("view/web/elements.js", "view/web/gallery.js")
_PICTURE = 288  # pixels per side
_SAMPLES = 8  # rays for each pixel
_QUALITY = 84  # quality of JPEG files


def write_gallery(
    assets: Sequence[Path],
    source: Path,
    target: Path,
    *,
    textures: int,
    progress: Callable[[int], None] | None = None,
) -> tuple[Path, list[str]]:
    """Write a gallery; return its page, and a message for each asset that cannot be shown.

    Args:
        assets: Directories of exported assets below `source`.
        source: Folder of all assets; its name is the title.
        target: Folder of the gallery.
        textures: Texels per side of the material maps; 0 for plain colors.
        progress: Receives the number of finished assets.

    Raises:
        AssetError: No asset can be shown.
        ExportError: The folder holds other files, or cannot be written.
    """
    _check_target(target)
    drawn = _Pictures()
    entries, failed = [], []
    for number, directory in enumerate(assets):
        place = f"assets/{source.name if directory == source else directory.relative_to(source).as_posix()}"
        try:
            asset = Asset.load(directory)
            page, pictures, entry = page_of(asset, textures=textures), drawn.of(asset), _entry(asset)
        except ArtgenError as error:
            failed.append(f"{directory} is left out: {error}")
        else:
            _make_folder((target / place).parent)
            page.save(target / f"{place}.html")
            names = {"closed": f"{place}.jpg", "open": f"{place}_open.jpg"}
            for (state, name), picture in zip(names.items(), pictures, strict=False):
                write_file(target / name, picture)
                entry[state] = name
            entries.append({**entry, "page": f"{place}.html"})
        if progress is not None:
            progress(number + 1)
    if not entries:
        raise AssetError(f"{len(assets)} assets cannot be shown; the first: {failed[0]}")
    text = page_html("view/web/gallery", source.name, _SCRIPTS, entries)
    return write_file(target / INDEX, text.encode()), failed


class _Pictures:
    """Draws the pictures of assets: closed and open by Embree, or closed only without it."""

    def __init__(self) -> None:
        self._draws = True

    def of(self, asset: Asset) -> list[bytes]:
        if self._draws:
            try:
                return self._drawn(asset)
            except RenderError:
                self._draws = False
        return [jpeg(thumbnail(asset), _QUALITY)]

    @staticmethod
    def _drawn(asset: Asset) -> list[bytes]:
        pictures = [
            render(asset, q, camera=view, size=_PICTURE, textures=256, samples=_SAMPLES).color
            for q, view in shots(asset)[:2]
        ]
        return [jpeg(picture, _QUALITY) for picture in pictures]


def _entry(asset: Asset) -> dict[str, Any]:
    """Return the entry of an asset in the gallery."""
    certificate = asset.certificate
    return {
        "name": asset.name,
        "category": asset.category,
        "seed": asset.seed,
        "features": features(asset),
        "mass": round(asset.mass, 4),
        "links": len(asset.links),
        "joints": [joint.kind for joint in asset.joints if not joint.locked],
        "proven": None if certificate is None else certificate.proven,
        "parameters": plain(asset.parameters),
    }


def _check_target(target: Path) -> None:
    """Raise an ExportError if a folder holds files other than an earlier gallery."""
    try:
        names = {path.name for path in target.iterdir()} if target.exists() else set()
        known = INDEX in names and _MARK in (target / INDEX).read_text(encoding="utf-8")[:2000]
    except OSError as error:
        raise ExportError(f"cannot write to {target}: {error.strerror}") from error
    if names - {"assets"} and not known:
        raise ExportError(f"{target} holds files other than a gallery; choose another --out")


def _make_folder(path: Path) -> None:
    try:
        path.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise ExportError(f"cannot write {path}: {error.strerror}") from error
