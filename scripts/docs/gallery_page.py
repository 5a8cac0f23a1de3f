"""The gallery: a viewer for one seed of each category, and the page with the links."""

import io
from functools import lru_cache

from PIL import Image

from artgen import _disk_cache as disk_cache
from artgen.asset import Asset
from artgen.catalog import categories, find
from artgen.view import page_of, render
from artgen.view.sheet import shots

SEEDS = {"box": 2, "lamp": 9, "trashcan": 6, "window": 6}
"""The seeds of those that are shown; 0 where none is named."""

_TEXTURES = 256  # texels on a side: a page has to stay below 3 MB
_OPEN = 0.55  # share of how far they open on their sheets
_SIZE = 320  # of a thumbnail [pixels]


def shown() -> tuple[str, ...]:
    """Return the names of the categories of artgen, without those of other packages."""
    return tuple(
        name for name in categories() if find(name).function.__module__ == f"artgen.categories.{name}"
    )


def viewer_of(category: str) -> str:
    """Return the path of a category's viewer below the documentation."""
    return f"viewers/{category}.html"


def thumbnail_of(category: str) -> str:
    """Return the path of a category's picture below the documentation."""
    return f"viewers/{category}.webp"


@lru_cache(maxsize=1)
def _asset(category: str) -> Asset:
    return find(category).generate(SEEDS.get(category, 0))


def viewer(category: str, digest: str) -> bytes:
    """Return the viewer of one seed of a category; cached by `digest`."""
    key = f"{category}_{digest}.html"
    cached = disk_cache.read("docs_viewers", key)
    if cached is None:
        cached = page_of(_asset(category), textures=_TEXTURES).html.encode()
        disk_cache.write("docs_viewers", key, cached)
    return cached


def thumbnail(category: str, digest: str) -> bytes:
    """Return a picture of the same seed, partly open; cached by `digest`."""
    key = f"{category}_{digest}.webp"
    cached = disk_cache.read("docs_viewers", key)
    if cached is None:
        asset = _asset(category)
        (_, view), (q, _), *_ = shots(asset)
        ajar = {joint: _OPEN * position for joint, position in q.items()}
        pixels = render(asset, ajar, camera=view, size=_SIZE, studio="none", textures=256).color
        file = io.BytesIO()
        Image.fromarray(pixels).save(file, "WEBP", quality=84, method=6)
        cached = file.getvalue()
        disk_cache.write("docs_viewers", key, cached)
    return cached


def written() -> str:
    """Return the page, in Markdown."""
    lines = [
        "# Gallery",
        "",
        (
            "One seed of each category in the web viewer: drag to turn it, move its joints, show its "
            "colliders and what its certificate says. Each is one file that needs no network, as "
            "`asset.show()` and `artgen view` make it."
        ),
        "",
        '<div class="gallery" markdown>',
        "",
    ]
    for name in shown():
        seed = SEEDS.get(name, 0)
        picture = f"![{name}, seed {seed}]({thumbnail_of(name)}){{ loading=lazy }}"
        lines += [f"[{picture}<span>`{name}`, seed {seed}</span>]({viewer_of(name)}){{ target=_blank }}", ""]
    return "\n".join([*lines, "</div>", ""])
