"""Commands that open pages: `artgen view`, `artgen gallery`, `artgen graph`, `artgen studio`."""

import difflib
import time
import webbrowser
from pathlib import Path
from typing import Annotated

import typer
from typer import Argument, Option

from artgen.asset import Asset
from artgen.asset.asset import DetailName
from artgen.asset.files import ASSET_FILE, exports_in
from artgen.catalog import categories, find, is_file, is_pipe, maker, rooms, script_of
from artgen.commands.console import progress
from artgen.commands.options import (
    Category,
    Detail,
    OpenBrowser,
    Overrides,
    Page,
    Seed,
    Source,
    TextureSize,
    check_given,
    generated,
)
from artgen.errors import ParameterError
from artgen.generator.overrides import parse_overrides

_OF_CATEGORIES = ("seed", "certify", "detail", "budgets", "openings")
_TEXELS = 512  # default texels per side of maps


def asset_from(
    context: typer.Context,
    source: str,
    seed: int,
    overrides: list[str],
    *,
    certify: bool = False,
    detail: DetailName = "full",
) -> Asset:
    """Load an exported asset, or generate one of a category with a seed and overrides.

    Raises:
        ParameterError: Options of categories are given for an exported asset, or overrides cannot be parsed.
        ArtgenError: There is no such asset or category, or it cannot be generated.
    """
    directory = Path(source)
    script = script_of(source)
    if directory.is_dir() and script and not (directory / ASSET_FILE).exists():
        raise ParameterError(
            f"{source} is a folder without an exported asset; did you mean the file {script}?"
        )
    if directory.is_dir() or directory.name == ASSET_FILE:
        if overrides:
            raise ParameterError(
                f"--set is for categories, but {source} is an exported asset; leave --set out"
            )
        check_given(context, _OF_CATEGORIES, "an exported asset")
        return Asset.load(directory)
    known = directory.exists() or is_file(source) or is_pipe(source) or source in categories()
    if not (known or script or source in rooms()):
        near = difflib.get_close_matches(source, (*categories(), *rooms()), 1, cutoff=0.7)
        raise ParameterError(
            f"there is no category {source!r} and no folder of that name; give a folder that artgen "
            "exported, the Python file of a category, such as stapler.py, or a category or room that "
            "`artgen list` shows." + (f" Did you mean {near[0]!r}?" if near else "")
        )
    return generated(maker(source), seed, parse_overrides(overrides), certify=certify, detail=detail)


def view(
    context: typer.Context,
    source: Source,
    *,
    seed: Seed = 0,
    overrides: Overrides = None,
    certify: Annotated[bool, Option(help="Prove an asset of a category, or draw again.")] = True,
    detail: Detail = "full",
    texture_size: TextureSize = _TEXELS,
    out: Page = None,
    opening: OpenBrowser = True,
) -> None:
    """Write an asset as a page with a slider for each joint, print its path, and open it in the browser.

    The page is one offline file.
    """
    from artgen.view.viewer import page_of

    with progress("view"):
        asset = asset_from(context, source, seed, overrides or [], certify=certify, detail=detail)
        path = page_of(asset, textures=texture_size).save(out or Path(f"{asset.name}.html"))
    _show(path, opening)


def _show(path: Path, opening: bool) -> None:  # noqa: FBT001 - private
    """Print the path of a page, and open the page in the browser."""
    typer.echo(path)
    if opening and not webbrowser.open(path.resolve().as_uri()):
        typer.echo(f"note: there is no browser here; open {path} in one", err=True)


def gallery(
    directory: Annotated[
        Path, Argument(help="A folder with exported assets, such as `artgen generate -n` makes.")
    ],
    *,
    texture_size: TextureSize = _TEXELS // 2,
    out: Annotated[Path | None, Option(help="Target; <DIRECTORY>_gallery by default.")] = None,
    opening: OpenBrowser = True,
) -> None:
    """Write a page of all assets in a folder, with pictures and filters, and print its path.

    Each picture links to the viewer of its asset. With artgen[sim], they show it closed and open.
    """
    from artgen.view.gallery import write_gallery

    source = directory.resolve()
    found = exports_in([source])
    target = out or source.with_name(f"{source.name}_gallery")
    with progress(source.name, len(found)) as update:
        path, failed = write_gallery(
            found, source, target, textures=texture_size, progress=lambda done: update(completed=done)
        )
    for message in failed:
        typer.echo(f"warning: {' '.join(message.split())}", err=True)
    _show(path, opening)


def graph(
    category: Category,
    *,
    seed: Seed = 0,
    overrides: Overrides = None,
    change: Annotated[
        list[str] | None,
        Option(
            metavar="NAME=VALUE",
            help="Set this value, evaluate a second time, and show which nodes come from the cache.",
        ),
    ] = None,
    out: Page = None,
    opening: OpenBrowser = True,
) -> None:
    """Write the node graph of a category as a page, print its path, and open it; needs artgen[studio].

    The page shows value, time, state, author's line and geometry of each node.
    """
    from artgen.graph_view import graph_page

    given, changed = parse_overrides(overrides or ()), parse_overrides(change or ())
    with progress("graph"):
        page = graph_page(find(category), seed, overrides=given, change=changed)
    _show(page.save(out or Path(f"{page.name}.html")), opening)


def studio(
    category: Category,
    *,
    seed: Seed = 0,
    overrides: Overrides = None,
    host: Annotated[
        str, Option(help="Address of the server; 0.0.0.0 admits other machines that have the token.")
    ] = "127.0.0.1",
    port: Annotated[int, Option(help="Port of the server; 0 takes a free one.")] = 8080,
    out: Annotated[Path, Option(metavar="DIRECTORY", help="Folder for exports of the page.")] = Path("out"),
    opening: OpenBrowser = True,
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
