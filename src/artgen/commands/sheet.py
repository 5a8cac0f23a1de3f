"""`artgen sheet`: many samples of a category on one page."""

from functools import partial
from pathlib import Path
from typing import Annotated, Any

import typer

from artgen.asset import Asset
from artgen.catalog import find
from artgen.commands.progress import progress_bar
from artgen.errors import ExportError, ParameterError
from artgen.generator.overrides import parse_overrides


def sheet(
    category: Annotated[
        str, typer.Argument(help="Name of a category, which `artgen list` shows, or a file that defines one.")
    ],
    *,
    seeds: Annotated[int, typer.Option(metavar="NUMBER", help="How many samples.")] = 12,
    first_seed: Annotated[int, typer.Option(help="The first of their seeds.")] = 0,
    overrides: Annotated[
        list[str] | None,
        typer.Option("--set", metavar="NAME=VALUE", help="A value or distribution for a parameter."),
    ] = None,
    views: Annotated[int, typer.Option(help="1 from in front, 2 from behind as well.")] = 2,
    size: Annotated[int, typer.Option(metavar="PIXELS", help="Height of one picture.")] = 240,
    columns: Annotated[
        int | None, typer.Option(help="Samples side by side; as many as make a good page by default.")
    ] = None,
    out: Annotated[
        Path | None, typer.Option(metavar="FILE", help="JPEG or PNG; ./<category>.jpg by default.")
    ] = None,
) -> None:
    """Draw samples of a category, closed and open, on one page, and print its path; needs artgen[sim]."""
    from artgen.view.picture import check_suffix
    from artgen.view.sheet import save_sheet
    from artgen.view.sheet import sheet as draw

    if seeds < 1:
        raise ParameterError(f"--seeds {seeds} must be at least 1")
    found, chosen = find(category), parse_overrides(overrides or [])
    path = Path(f"{found.name}.jpg") if out is None else out
    check_suffix(path)
    if not path.absolute().parent.is_dir():
        raise ExportError(f"cannot write {path}: give a file in a directory that exists")
    makers = [partial(_asset, found, seed, chosen) for seed in range(first_seed, first_seed + seeds)]
    with progress_bar() as bar:
        task = bar.add_task(found.name, total=seeds)
        pixels = draw(
            makers,
            views=views,
            size=size,
            columns=columns,
            progress=lambda done, total: bar.update(task, completed=done, total=total),
        )
    typer.echo(save_sheet(pixels, path))


def _asset(category: Any, seed: int, overrides: Any) -> Asset:
    """Generate a sample without a proof."""
    asset: Asset = category.evaluate(seed, certify=False, overrides=overrides)[0]
    return asset
