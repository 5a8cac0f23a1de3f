"""`artgen graph`: the node graph of a category in the browser, as one file."""

from pathlib import Path
from typing import Annotated

import typer

from artgen.catalog import find
from artgen.commands.source import Category, Overrides, Seed
from artgen.commands.view import show_file
from artgen.generator.overrides import parse_overrides


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

    Of each node it tells value, time, state, the author's line, and how it looks.
    """
    from artgen.graph_view import graph_page
    from artgen.view.web import check_page

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
