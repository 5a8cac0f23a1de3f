"""Measure many samples of categories, and report failures. `make survey` runs this for all categories.

python scripts/survey.py toaster --seeds 60 --fast
python scripts/survey.py refrigerator --seeds 500 --jobs 2 --out out/refrigerator.jsonl
python scripts/survey.py lamp --alike 24

Measurements stay in the file, so that an interrupted survey continues; after a change of the category,
--fresh is necessary to start again.
"""

import sys
from functools import partial
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.table import Table
from surveys.alike import SAME, likenesses, same_neighbors
from surveys.pages import soak_page
from surveys.run import survey
from surveys.summary import Criterion, criteria, failures, figures, listed

from artgen.catalog import categories as all_categories
from artgen.catalog import find
from artgen.commands.console import progress

_PAIRS = 8  # number of pairs that are shown
_STATES = {True: "[green]yes[/]", False: "[bold red]no[/]", None: "[yellow]?[/]"}


def main(
    categories: Annotated[list[str] | None, typer.Argument(help="Names; all by default.")] = None,
    *,
    seeds: Annotated[int, typer.Option(min=1, help="Number of seeds of each.")] = 500,
    first_seed: Annotated[int, typer.Option(min=0, help="The first seed.")] = 0,
    jobs: Annotated[int, typer.Option(min=1, help="Number of processes.")] = 1,
    fast: Annotated[bool, typer.Option("--fast", help="Omit behavior, hands and speed.")] = False,
    limit: Annotated[float, typer.Option(min=1.0, help="Time limit for a seed [s].")] = 120.0,
    fresh: Annotated[bool, typer.Option("--fresh", help="Delete earlier measurements first.")] = False,
    alike: Annotated[
        int,
        typer.Option(
            min=0, help="Show the most similar samples of this number of seeds, and measure nothing else."
        ),
    ] = 0,
    out: Annotated[
        Path | None, typer.Option(help="The file of records; by default out/survey/<category>.jsonl.")
    ] = None,
    page: Annotated[
        Path | None, typer.Option(help="Also write the results as a page in Markdown, docs/soak.md.")
    ] = None,
) -> None:
    """Measure samples and judge them; exit code 1 if a criterion is not met."""
    console = Console(width=None if sys.stdout.isatty() else 160, highlight=False)
    met = True
    found = {}
    for name in categories or all_categories():
        if alike:
            met &= _alike(console, name, range(first_seed, first_seed + alike))
            continue
        path = out or Path("out/survey") / f"{name}.jsonl"
        path.parent.mkdir(parents=True, exist_ok=True)
        find(name)
        if fresh:
            path.unlink(missing_ok=True)
        with progress(name, seeds) as update:
            records = survey(
                name,
                range(first_seed, first_seed + seeds),
                path,
                fast=fast,
                jobs=jobs,
                limit=limit,
                progress=partial(update, advance=1),
            )
        found[name] = records
        if page is not None:  # after each category, for an interrupted run
            page.write_text(soak_page(found), encoding="utf-8")
        results = criteria(records)
        _show(console, name, results)
        for quantity, text in figures(records).items():
            console.print(f"{quantity}: {text}", markup=False, soft_wrap=True)
        for failure in failures(records):
            console.print(str(failure), markup=False, soft_wrap=True)
        console.print()
        met &= all(each.passed is not False for each in results)
    if not met:
        raise typer.Exit(1)


def _show(console: Console, name: str, results: list[Criterion]) -> None:
    table = Table(title=name, title_justify="left", box=None, pad_edge=False, header_style="bold")
    for column in ("criterion", "found", "met", "seeds that do not"):
        table.add_column(column)
    for each in results:
        table.add_row(each.name, each.found, _STATES[each.passed], listed(each.seeds) if each.seeds else "")
    console.print(table)


def _alike(console: Console, name: str, seeds: range) -> bool:
    """Show the most similar pairs of seeds; return False if neighbors on a sheet look the same."""
    pairs = likenesses(find(name), seeds)
    table = Table(title=f"{name}: most alike", title_justify="left", box=None, pad_edge=False)
    for column in ("seeds", "difference", "in a row"):
        table.add_column(column)
    for pair in pairs[:_PAIRS]:
        table.add_row(
            f"{pair.seeds[0]}, {pair.seeds[1]}", f"{pair.difference:.3f}", "yes" if pair.near else ""
        )
    console.print(table)
    same = same_neighbors(pairs)
    console.print(f"neighbors that look the same (difference below {SAME:g}): {len(same)}\n", markup=False)
    return not same


if __name__ == "__main__":
    typer.run(main)
