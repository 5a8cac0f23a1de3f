"""Arguments and options that several commands share."""

from pathlib import Path
from typing import Annotated

import typer

from artgen.export import LAYOUTS
from artgen.generator import OnCollision
from artgen.materials.textures import check_size

Category = Annotated[
    str, typer.Argument(help="Name of a category, which `artgen list` shows, or a file that defines one.")
]
Categories = Annotated[
    list[str],
    typer.Argument(metavar="CATEGORY...", help="Names of categories, which `artgen list` shows, or files."),
]
Source = Annotated[
    str,
    typer.Argument(metavar="DIRECTORY|CATEGORY", help="An exported asset, a category, or a file with one."),
]
Overrides = Annotated[
    list[str] | None,
    typer.Option(
        "--set",
        metavar="NAME=VALUE",
        help="A value or distribution for a parameter: width=0.9, hand=left, 'width=uniform(0.8, 0.9)'; "
        "door:width=0.9 for one category of several. Repeatable.",
    ),
]
Seed = Annotated[int, typer.Option(help="The first seed; the same seed gives the same bytes.")]
Certify = Annotated[bool, typer.Option(help="Prove that no two links collide anywhere in the joint ranges.")]
Tolerance = Annotated[
    float, typer.Option(metavar="METRES", help="Clearance between links that the proof requires.")
]
Collisions = Annotated[
    OnCollision,
    typer.Option("--on-collision", help="After a failed proof: draw again, fail, or keep the asset."),
]
Layout = Annotated[str, typer.Option(metavar="NAME", help=f"Layout of the files: {', '.join(LAYOUTS)}.")]


def _texture_size(size: int) -> int:
    if size != 0:
        check_size(size)
    return size


TextureSize = Annotated[
    int,
    typer.Option(
        metavar="TEXELS", callback=_texture_size, help="Texels per side of the maps; 0 for plain colors."
    ),
]
Jobs = Annotated[int | None, typer.Option(min=1, help="Number of processes; all cores by default.")]
JsonOutput = Annotated[bool, typer.Option("--json", help="Print JSON instead of tables.")]
OpenBrowser = Annotated[bool, typer.Option("--open/--no-open", help="Open the page in the browser.")]


def _page(path: Path | None) -> Path | None:
    from artgen.view.page import check_page

    if path is not None:
        check_page(path)
    return path


Page = Annotated[
    Path | None,
    typer.Option(metavar="FILE", callback=_page, help="HTML file; by default ./<name of the asset>.html."),
]
