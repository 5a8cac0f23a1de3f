"""Commands that open pages: `artgen view`, `artgen gallery`, `artgen graph`, `artgen studio`."""

import time
import webbrowser
from pathlib import Path
from typing import Annotated

import typer

from artgen.asset import Asset
from artgen.asset.files import ASSET_FILE
from artgen.catalog import find
from artgen.commands.progress import progress_bar
from artgen.errors import ParameterError
from artgen.generator.overrides import parse_overrides

SourceArgument = Annotated[
    str,
    typer.Argument(metavar="DIRECTORY|CATEGORY", help="An exported asset, a category, or a file with one."),
]
SourceSeed = Annotated[int, typer.Option(help="Of a category: decides every draw.")]
SourceOverrides = Annotated[
    list[str] | None,
    typer.Option("--set", metavar="NAME=VALUE", help="Of a category: a value for a parameter."),
]

Category = Annotated[
    str, typer.Argument(help="Name of a category, which `artgen list` shows, or a file that defines one.")
]
Seed = Annotated[int, typer.Option(help="Decides every draw.")]
Overrides = Annotated[
    list[str] | None,
    typer.Option("--set", metavar="NAME=VALUE", help="A value for a parameter. May be given several times."),
]


def asset_from(source: str, seed: int, overrides: list[str], *, certify: bool = False) -> Asset:
    """Load an exported asset, or generate one of a category.

    Args:
        source: Directory of an exported asset or its `asset.json`, a category, or a file with one.
        seed: Seed for a category.
        overrides: The same: `NAME=VALUE`.
        certify: The same: whether to prove it; one that is only to be seen needs no proof.

    Raises:
        ParameterError: Overrides are given for an exported asset, or cannot be parsed.
        ArtgenError: There is no such asset or category, or it cannot be generated.
    """
    from artgen.catalog import find

    directory = Path(source)
    if directory.is_dir() or directory.name == ASSET_FILE:
        if overrides:
            raise ParameterError(f"--set is for categories; {source} is an exported asset")
        return Asset.load(directory)
    return find(source).evaluate(seed, certify=certify, overrides=parse_overrides(overrides))[0]


TEXELS = 512
"""Default texels per side of maps."""


def view(
    source: SourceArgument,
    *,
    seed: SourceSeed = 0,
    overrides: SourceOverrides = None,
    certify: Annotated[
        bool, typer.Option(help="Of a category: prove it, and draw again what collides.")
    ] = True,
    texture_size: Annotated[
        int, typer.Option(metavar="TEXELS", help="Texels on a side of the maps; 0 for plain colors.")
    ] = TEXELS,
    out: Annotated[
        Path | None, typer.Option(metavar="FILE", help="HTML; ./<name of the asset>.html by default.")
    ] = None,
    opening: Annotated[bool, typer.Option("--open/--no-open", help="Open it in the browser.")] = True,
) -> None:
    """Write an asset as a page with a slider for each joint, print its path, and open it in the browser.

    The page is one offline file.
    """
    from artgen.materials.textures import check_size
    from artgen.view.page import check_page
    from artgen.view.viewer import page_of

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
    """Open a file in the browser, or report that there is none."""
    if not webbrowser.open(path.resolve().as_uri()):
        typer.echo(f"note: no browser was found here; open {path} in one", err=True)


def gallery(
    directory: Annotated[
        Path,
        typer.Argument(
            metavar="DIRECTORY", help="A folder with exported assets, such as `artgen generate -n` makes."
        ),
    ],
    *,
    texture_size: Annotated[
        int, typer.Option(metavar="TEXELS", help="Texels on a side of the maps; 0 for plain colors.")
    ] = TEXELS // 2,
    out: Annotated[
        Path | None, typer.Option(metavar="FOLDER", help="Where to; <DIRECTORY>_gallery by default.")
    ] = None,
    opening: Annotated[bool, typer.Option("--open/--no-open", help="Open it in the browser.")] = True,
) -> None:
    """Write a page of all assets in a folder, with pictures and filters, and print its path.

    Each picture leads to the viewer of its asset. With artgen[sim], pictures are drawn by MuJoCo.
    """
    from artgen.materials.textures import check_size
    from artgen.view.gallery import find_assets, write_gallery

    if texture_size != 0:
        check_size(texture_size)
    source = directory.resolve()
    found = find_assets(source)
    target = out or source.with_name(f"{source.name}_gallery")
    with progress_bar() as bar:
        task = bar.add_task(source.name, total=len(found))
        path, failed = write_gallery(
            found,
            source,
            target,
            textures=texture_size,
            progress=lambda done: bar.update(task, completed=done),
        )
    for message in failed:
        typer.echo(f"warning: {' '.join(message.split())}", err=True)
    typer.echo(path)
    if opening:
        show_file(path)


def graph(
    category: Category,
    *,
    seed: Seed = 0,
    overrides: Overrides = None,
    change: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NAME=VALUE",
            help="Evaluate, set this, and evaluate again: shows what came from the cache and what did not.",
        ),
    ] = None,
    out: Annotated[
        Path | None, typer.Option(metavar="FILE", help="HTML; ./<category>_<seed>_graph.html by default.")
    ] = None,
    opening: Annotated[bool, typer.Option("--open/--no-open", help="Open it in the browser.")] = True,
) -> None:
    """Write the node graph of a category as a page, print its path, and open it; needs artgen[studio].

    The page shows value, time, state, author's line and geometry of each node.
    """
    from artgen.graph_view import graph_page
    from artgen.view.page import check_page

    if out is not None:
        check_page(out)
    page = graph_page(
        find(category),
        seed,
        overrides=parse_overrides(overrides or ()),
        change=parse_overrides(change or ()),
    )
    path = page.save(out or Path(f"{page.name}.html"))
    typer.echo(path)
    if opening:
        show_file(path)


def studio(
    category: Category,
    *,
    seed: Seed = 0,
    overrides: Overrides = None,
    host: Annotated[
        str, typer.Option(help="Where to serve; 0.0.0.0 lets in other machines that have the token.")
    ] = "127.0.0.1",
    port: Annotated[int, typer.Option(help="Where to serve; 0 takes any that is free.")] = 8080,
    out: Annotated[
        Path, typer.Option(metavar="DIRECTORY", help="The page exports files below this folder only.")
    ] = Path("out"),
    opening: Annotated[bool, typer.Option("--open/--no-open", help="Open it in the browser.")] = True,
) -> None:
    """Edit the parameters and joints of a category in the browser; needs artgen[studio].

    The studio loads the file of the category again when it is saved. Ctrl-C ends the studio.
    """
    from artgen.studio import Session
    from artgen.studio.app import Studio

    session = Session(category, seed, parse_overrides(overrides or []))
    served = Studio(session, host, port, out=out)
    try:
        typer.echo(f"{session.generator.name} in the studio: {served.address} (Ctrl-C ends it)")
        if opening:
            webbrowser.open(served.address)
        while True:
            time.sleep(1.0)
    except KeyboardInterrupt:
        typer.echo("\nthe studio is closed")
    finally:
        served.close()
