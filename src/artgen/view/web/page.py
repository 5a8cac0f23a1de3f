"""The viewer of an asset as one HTML page, which needs no network and no other file."""

import base64
import html
import json
import zipfile
import zlib
from contextlib import suppress
from dataclasses import dataclass
from functools import lru_cache
from importlib.metadata import version
from importlib.resources import files
from io import BytesIO
from pathlib import Path
from typing import Any

from artgen.asset import Asset
from artgen.errors import AssetError, ExportError
from artgen.export import write_glb
from artgen.materials.textures import check_size
from artgen.view.web.record import viewer_data

TEXTURES = 512
"""Texels on a side of the maps of a page, unless said otherwise."""

_SCRIPTS = (
    "elements.js",
    "kinematics.js",
    "studio.js",
    "model.js",
    "signs.js",
    "orbit.js",
    "panel.js",
    "main.js",
)
_OWN_VIEWER = (
    "var camera,controls,scene"  # where three.js ends in trimesh's page, and trimesh's viewer begins
)


@dataclass(frozen=True)
class Page:
    """An asset in a viewer: in a notebook it shows itself; elsewhere save it and open it in a browser.

    Attributes:
        name: Name of the asset.
        html: The page.
        height: Of the cell of a notebook [pixels].
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
        """Name its type and its size."""
        return f"<Page of {self.name}: {len(self.html) / 1e6:.1f} MB; save(path) writes it>"

    def save(self, path: str | Path) -> Path:
        """Write the page to a file, and return its path.

        Raises:
            ExportError: The file is not a page written by artgen, or cannot be written.
        """
        path = Path(path)
        check_page(path)
        return write_file(path, self.html.encode())


def page_of(asset: Asset, *, textures: int = TEXTURES, height: int = 600) -> Page:
    """Make the viewer of an asset.

    Args:
        asset: The asset.
        textures: Texels on a side of the materials' maps; 0 for colors alone.
        height: Of the cell of a notebook [pixels].

    Raises:
        ParameterError: Maps cannot have that many texels.
        AssetError: The asset was read from files that have no surfaces.
    """
    if textures:
        check_size(textures)
    (model,) = write_glb(asset, textures).files.values()
    data = json.dumps(viewer_data(asset), separators=(",", ":"), allow_nan=False)
    parts = {
        "TITLE": html.escape(asset.name),
        "STYLE": read("viewer.css"),
        "THREE": packed(three_js().encode()),
        "MODEL": packed(model),
        "DATA": packed(data.encode()),
        "VIEWER": "\n".join(read(name) for name in _SCRIPTS),
    }
    return Page(asset.name, filled(read("viewer.html"), parts), height)


def filled(template: str, parts: dict[str, str]) -> str:
    """Return a page with `{{NAME}}` replaced by its parts."""
    for name, text in parts.items():
        template = template.replace(f"{{{{{name}}}}}", text)
    return template


def packed(content: bytes) -> str:
    """Return bytes as text that a page can hold: compressed, in base64."""
    return base64.b64encode(zlib.compress(content, 9)).decode()


@lru_cache(maxsize=32)
def read(name: str) -> str:
    """Return a file of the viewer."""
    return files("artgen.view.web").joinpath(name).read_text(encoding="utf-8")


@lru_cache(maxsize=1)
def three_js() -> str:
    """Return three.js with its loader of glTF, which come with trimesh: a script that defines `THREE`."""
    content = files("trimesh").joinpath("resources/templates/viewer.zip").read_bytes()
    with zipfile.ZipFile(BytesIO(content)) as archive:
        page = archive.read("viewer.html.template").decode()
    script, found, _ = page.partition("<script>")[2].partition(_OWN_VIEWER)
    if not found or "GLTFLoader" not in script:
        raise AssetError(
            f"the viewer needs the three.js that comes with trimesh, and trimesh {version('trimesh')} has "
            "another one; install the version of trimesh that artgen asks for"
        )
    return script


def script_data(value: Any) -> str:
    """Return data as JSON that can stand in a script of a page."""
    return json.dumps(value, separators=(",", ":"), allow_nan=False).replace("<", "\\u003c")


def check_page(path: Path) -> None:
    """Refuse a name that no page has, or one in no folder, before anything is made.

    Raises:
        ExportError: The name ends otherwise, it is that of a folder, or its folder is not there.
    """
    if path.suffix.lower() not in (".html", ".htm") or path.is_dir():
        raise ExportError(f"cannot write {path}: give a file whose name ends in .html")
    if not path.absolute().parent.is_dir():
        raise ExportError(f"cannot write {path}: give a file in a directory that exists")


def write_file(path: Path, content: bytes) -> Path:
    """Write a file as a whole or not at all."""
    part = path.with_name(f".{path.name}.part")
    try:
        part.write_bytes(content)
        part.replace(path)
    except OSError as error:
        with suppress(OSError):
            part.unlink(missing_ok=True)
        raise ExportError(f"cannot write {path}: {error.strerror}") from error
    return path
