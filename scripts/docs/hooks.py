"""Hook of MkDocs: makes the generated pages, pictures and viewers.

`ARTGEN_DOCS=quick` makes no pictures and no viewers, for reading the text or testing the links.
"""

import hashlib
import io
import os
import sys
from pathlib import Path
from typing import Any

sys.path.append(str(Path(__file__).parents[1]))

import category_pages
import gallery_page
import node_pages
import node_pictures
import reference_pages
from mkdocs.config.defaults import MkDocsConfig
from mkdocs.exceptions import PluginError
from mkdocs.structure.files import File, Files
from PIL import Image

from artgen.errors import ArtgenError

ROOT = Path(__file__).parents[2]
QUICK = os.environ.get("ARTGEN_DOCS") == "quick"


def on_config(config: MkDocsConfig) -> MkDocsConfig:
    """Insert the generated pages into the navigation, in place of their folders."""
    listed = {
        f"{node_pages.FOLDER}/": ["index", *(page.name for page in node_pages.PAGES)],
        f"{category_pages.FOLDER}/": list(gallery_page.shown()),
        f"{reference_pages.FOLDER}/": list(reference_pages.PAGES),
    }
    config.nav = _expanded(config.nav, listed)
    return config


def _expanded(nav: Any, listed: dict[str, list[str]]) -> Any:
    """Return a navigation with each folder replaced by its pages."""
    if isinstance(nav, str):
        return [f"{nav}{name}.md" for name in listed[nav]] if nav in listed else nav
    if isinstance(nav, dict):
        return {title: _expanded(item, listed) for title, item in nav.items()}
    expanded = [_expanded(item, listed) for item in nav]
    return [page for item in expanded for page in (item if isinstance(item, list) else [item])]


def on_files(files: Files, *, config: MkDocsConfig) -> Files:
    """Add the generated files to the site.

    Raises:
        PluginError: A file cannot be made; MkDocs ends with the message.
    """
    try:
        return _with_made(files, config)
    except (ArtgenError, LookupError) as error:
        raise PluginError(str(error)) from error


def _with_made(files: Files, config: MkDocsConfig) -> Files:
    digest = source_digest()

    def add(path: str, content: str | bytes) -> None:
        files.append(File.generated(config, path, content=content))

    placed = node_pages.placed()
    add(f"{node_pages.FOLDER}/index.md", node_pages.index(placed))
    for page in node_pages.PAGES:
        add(f"{node_pages.FOLDER}/{page.name}.md", node_pages.written(page, placed[page.name]))
        for example in placed[page.name]:
            made = example.run()
            add(node_pages.picture_of(example), _blank() if QUICK else node_pictures.picture(made))
    for name in reference_pages.PAGES:
        add(f"{reference_pages.FOLDER}/{name}.md", reference_pages.written(name))
    seeds = 1 if QUICK else category_pages.SEEDS
    for name in gallery_page.shown():
        joints = category_pages.rows(name, seeds, digest)
        add(f"{category_pages.FOLDER}/{name}.md", category_pages.written(name, joints, seeds))
        add(gallery_page.viewer_of(name), "" if QUICK else gallery_page.viewer(name, digest))
        add(gallery_page.thumbnail_of(name), _blank() if QUICK else gallery_page.thumbnail(name, digest))
    add("gallery.md", gallery_page.written())
    return files


def source_digest() -> str:
    """Return a digest of the sources of artgen."""
    content = hashlib.blake2b(digest_size=10)
    for path in sorted((ROOT / "src").rglob("*")):
        if path.is_file() and path.suffix != ".pyc":
            content.update(path.read_bytes())
    return content.hexdigest()


def _blank() -> bytes:
    """Return an empty picture."""
    file = io.BytesIO()
    Image.new("RGB", (1, 1), "white").save(file, "WEBP")
    return file.getvalue()
