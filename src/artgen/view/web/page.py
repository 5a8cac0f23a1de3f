"""The viewer of an asset as one offline HTML page."""

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
"""Default texels per side of the maps of a page."""

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
_OWN_VIEWER = "var camera,controls,scene"  # end of three.js and start of trimesh's viewer in trimesh's page


@dataclass(frozen=True)
class Page:
    """An asset in a viewer: a notebook shows it; otherwise save it and open it in a browser.

    Attributes:
        name: Name of the asset.
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
            ExportError: The file is not a page written by artgen, or cannot be written.
        """
        path = Path(path)
        check_page(path)
        return write_file(path, self.html.encode())


def page_of(asset: Asset, *, textures: int = TEXTURES, height: int = 600) -> Page:
    """Make the viewer of an asset.

    Args:
        asset: The asset.
        textures: Texels per side of the material maps; 0 for colors only.
        height: Height of the notebook cell [pixels].

    Raises:
        ParameterError: The size of maps is not allowed.
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
    """Return bytes as text for a page: compressed, in base64."""
    return base64.b64encode(zlib.compress(content, 9)).decode()


@lru_cache(maxsize=32)
def read(name: str) -> str:
    """Return a file of the viewer."""
    return files("artgen.view.web").joinpath(name).read_text(encoding="utf-8")


@lru_cache(maxsize=1)
def three_js() -> str:
    """Return three.js with its glTF loader from trimesh: a script that defines `THREE`."""
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
    """Return data as JSON that is safe in a script of a page."""
    return json.dumps(value, separators=(",", ":"), allow_nan=False).replace("<", "\\u003c")


def check_page(path: Path) -> None:
    """Check the name of a page before anything is generated.

    Raises:
        ExportError: The name has another suffix, it is the name of a folder, or its folder does not exist.
    """
    if path.suffix.lower() not in (".html", ".htm") or path.is_dir():
        raise ExportError(f"cannot write {path}: give a file whose name ends in .html")
    if not path.absolute().parent.is_dir():
        raise ExportError(f"cannot write {path}: give a file in a directory that exists")


def write_file(path: Path, content: bytes) -> Path:
    """Write a file completely or not at all."""
    part = path.with_name(f".{path.name}.part")
    try:
        part.write_bytes(content)
        part.replace(path)
    except OSError as error:
        with suppress(OSError):
            part.unlink(missing_ok=True)
        raise ExportError(f"cannot write {path}: {error.strerror}") from error
    return path
