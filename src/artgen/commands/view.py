"""`artgen view`: an asset in the browser, as one file."""

import webbrowser
from pathlib import Path
from typing import Annotated

import typer

from artgen.commands.source import Source, SourceOverrides, SourceSeed, asset_from

TEXELS = 512
"""Texels on a side of the maps, unless said otherwise."""


def view(
    source: Source,
    *,
    seed: SourceSeed = 0,
    overrides: SourceOverrides = None,
    certify: Annotated[
        bool, typer.Option(help="Of a category: prove it, and draw again what collides.")
    ] = True,
    texture_size: Annotated[
        int, typer.Option(metavar="TEXELS", help="Texels on a side of the maps; 0 for plain colours.")
    ] = TEXELS,
    out: Annotated[
        Path | None, typer.Option(metavar="FILE", help="HTML; ./<name of the asset>.html by default.")
    ] = None,
    opening: Annotated[bool, typer.Option("--open/--no-open", help="Open it in the browser.")] = True,
) -> None:
    """Write an asset as a page with a slider for each joint, print its path, and open it in the browser.

    The page is one file, which needs no network.
    """
    from artgen.materials.textures import check_size
    from artgen.view.web import check_page, page_of

    if texture_size != 0:
        check_size(texture_size)
    if out is not None:
        check_page(out)
    asset = asset_from(source, seed, overrides or [], certify=certify)
    path = page_of(asset, textures=texture_size).save(out or Path(f"{asset.name}.html"))
    typer.echo(path)
    if opening:
        show_file(path)


def show_file(path: Path) -> None:
    """Open a file in the browser, or say that there is none."""
    if not webbrowser.open(path.resolve().as_uri()):
        typer.echo(f"note: no browser was found here; open {path} in one", err=True)
