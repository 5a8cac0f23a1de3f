"""Offline HTML pages: one shell for the viewer of an asset, the gallery and the graph of a category."""

import base64
import html
import json
import zipfile
import zlib
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import lru_cache
from importlib.metadata import version
from importlib.resources import files
from io import BytesIO
from pathlib import Path
from typing import Any

from artgen._names import checked_path
from artgen.asset import Asset, summary
from artgen.errors import AssetError, ExportError
from artgen.export.files import write_file
from artgen.export.thumbnail import thumbnail
from artgen.view.picture import jpeg

_OWN_VIEWER = "var camera,controls,scene"  # end of three.js and start of trimesh's viewer in trimesh's page

_QUALITY = 88  # of the picture on a card


@dataclass(frozen=True)
class Page:
    """A page: a notebook shows it; otherwise save it and open it in a browser.

    Attributes:
        name: Name of the asset or graph.
        html: The page.
        height: Height of the notebook cell [pixels].
    """

    name: str
    html: str
    height: int = 600

    def _repr_html_(self) -> str:
        """Return the page in a frame, as notebooks show it."""
        return (
            f'<iframe srcdoc="{html.escape(self.html)}" title="{html.escape(self.name)}" '
            f'style="width:100%;height:{self.height}px;border:0;border-radius:8px" allowfullscreen></iframe>'
        )

    def __repr__(self) -> str:
        """Return its type and its size."""
        return f"<Page of {self.name}: {len(self.html) / 1e6:.1f} MB; save(path) writes it>"

    def save(self, path: str | Path) -> Path:
        """Write the page to a file, and return its path.

        Raises:
            ExportError: The name has another suffix than `.html`, or the file cannot be written.
            ParameterError: The path is none.
        """
        path = checked_path(path, "path")
        check_page(path)
        return write_file(path, self.html.encode())


def card(asset: Asset) -> str:
    """Return a small picture of an asset and its facts as a fragment of HTML; `page_of` makes the viewer."""
    picture = ""
    with suppress(AssetError):  # an asset that was read from files without surfaces
        source = base64.b64encode(jpeg(thumbnail(asset), _QUALITY)).decode()
        picture = f'<img src="data:image/jpeg;base64,{source}" width="192" height="192" alt="{asset.name}"/>'
    left = ' style="text-align:left;white-space:pre"'
    rows = "".join(
        f"<tr><td{left}>{name}</td><td{left}>{html.escape(chr(10).join(lines))}</td></tr>"
        for name, lines in summary.facts(asset)
    )
    table = f"<table><caption{left}><b>{html.escape(summary.title(asset))}</b></caption>{rows}</table>"
    return f'<div style="display:flex;gap:1em;align-items:center">{picture}{table}</div>'


def page_html(kind: str, title: str, scripts: Sequence[str], data: Any, **blobs: bytes) -> str:
    """Return a page.

    Args:
        kind: Path in the package of its body and style, without suffix, such as `view/web/viewer`.
        title: Title of the page.
        scripts: Paths in the package of its scripts.
        data: JSON data, which a script reads by `unpackedText("data")`.
        blobs: Other data, which a script reads by `unpacked(name)`.
    """
    blobs |= {"data": json.dumps(data, separators=(",", ":"), allow_nan=False).encode()}
    packed = {name: base64.b64encode(zlib.compress(blob, 9)).decode() for name, blob in blobs.items()}
    parts = {
        "KIND": kind.rpartition("/")[2],
        "STYLE": _read(f"{kind}.css"),
        "BODY": _read(f"{kind}.html"),
        "TITLE": html.escape(title),
        "DATA": "\n".join(
            f'<script type="text/plain" id="{name}">{text}</script>' for name, text in packed.items()
        ),
        "SCRIPT": "\n".join(_read(script) for script in scripts),
    }
    text = _read("view/web/page.html")
    for name, part in parts.items():
        text = text.replace(f"{{{{{name}}}}}", part)
    return text


@lru_cache(maxsize=32)
def _read(path: str) -> str:
    return files("artgen").joinpath(path).read_text(encoding="utf-8")


@lru_cache(maxsize=1)
def three_js() -> bytes:
    """Return three.js with its glTF loader from trimesh: a script that defines `THREE`."""
    content = files("trimesh").joinpath("resources/templates/viewer.zip").read_bytes()
    with zipfile.ZipFile(BytesIO(content)) as archive:
        page = archive.read("viewer.html.template").decode()
    script, found, _ = page.partition("<script>")[2].partition(_OWN_VIEWER)
    if not found or "GLTFLoader" not in script:
        raise AssetError(
            f"the viewer needs the three.js that comes with trimesh, and trimesh {version('trimesh')} has "
            "another one; install the version of trimesh that artgen requires"
        )
    return script.encode()


def check_page(path: Path) -> None:
    """Check the name of a page before anything is generated.

    Raises:
        ExportError: The name has another suffix, it is the name of a folder, or its folder does not exist.
    """
    if path.suffix.lower() not in (".html", ".htm") or path.is_dir():
        raise ExportError(f"cannot write {path}: give a file whose name ends in .html")
    if not path.absolute().parent.is_dir():
        raise ExportError(f"cannot write {path}: give a file in a directory that exists")
