"""Tables and progress bars of commands, and the run of commands that make many things."""

import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import Any

import typer
from rich.console import Console
from rich.progress import (
    BarColumn,
    MofNCompleteColumn,
    Progress,
    ProgressColumn,
    Task,
    TextColumn,
    TimeRemainingColumn,
)
from rich.table import Table
from rich.text import Text

from artgen.dataset import generate_many
from artgen.dataset.places import RESUME
from artgen.dataset.plan import BasePlan

FAULT = 1
"""Exit code of a command that found a fault."""

NOT_PROVEN = 3
"""Exit code if no collision was found, and not everything is proven."""

INTERRUPTED = 130
"""Exit code after Ctrl-C."""

_PLAIN_WIDTH = 1000  # columns of tables in files and pipes: one line per row
_SHOWN = 20  # most listed failures


def console() -> Console:
    """Return the console for tables, as wide as the terminal, or wide enough for a file."""
    width = None if sys.stdout.isatty() else _PLAIN_WIDTH
    return Console(width=width, highlight=False, markup=False)


def table(*columns: str) -> Table:
    """Return an empty table."""
    result = Table(box=None, pad_edge=False, header_style="bold")
    for column in columns:
        result.add_column(column, overflow="fold")
    return result


@contextmanager
def progress(name: str, total: int | None = None) -> Iterator[Callable[..., None]]:
    """Show a progress bar on stderr, on terminals only, until the end; yield the function that updates it."""
    console = Console(stderr=True)
    columns = (
        TextColumn("{task.description}"),
        BarColumn(),
        MofNCompleteColumn(),
        _Rate(),
        TextColumn("[red]{task.fields[failed]}"),
        TimeRemainingColumn(),
    )
    with Progress(*columns, console=console, transient=True, disable=not console.is_terminal) as bar:
        yield partial(bar.update, bar.add_task(name, total=total, failed=""))


class _Rate(ProgressColumn):
    """Steps per second."""

    def render(self, task: Task) -> Text:
        """Return the rate as text."""
        speed = task.finished_speed or task.speed
        return Text("" if speed is None else f"{speed:.1f}/s")


@contextmanager
def counting(
    name: str, total: int | None = None
) -> Iterator[tuple[Callable[[bool, int], None], Callable[..., None]]]:
    """Show the progress of a run; after Ctrl-C, print that the run can be continued, and end the command.

    Yields a function for each result, with its success and the number of steps, and the update of the bar.
    """
    try:
        with progress(name, total) as update:
            failed = 0

            def step(succeeded: bool, steps: int) -> None:  # noqa: FBT001 - a callback
                nonlocal failed
                failed += not succeeded
                update(advance=steps, failed=f"{failed} failed" if failed else "")

            yield step, update
    except KeyboardInterrupt:
        typer.echo(f"interrupted; {RESUME}", err=True)
        raise typer.Exit(INTERRUPTED) from None


def list_failures(failures: Sequence[str], rest: str = "") -> None:
    """Print failures to stderr, the first ones if there are many."""
    for failure in failures[:_SHOWN]:
        typer.echo(failure, err=True)
    if len(failures) > _SHOWN:
        typer.echo(f"and {len(failures) - _SHOWN} more{rest}", err=True)


def make_dataset(plan: BasePlan, out: str, *, each: int = 1, what: str = "assets", **options: Any) -> None:
    """Make a dataset, show the progress, and list the failures.

    Args:
        plan: Plan of the dataset.
        out: Target folder.
        each: Number of results per asset.
        what: Plural noun for the results.
        options: Options of `generate_many`.

    Raises:
        Exit: An asset failed.
    """
    with counting(Path(out).name) as (step, update):
        summary = generate_many(
            plan,
            out,
            progress=lambda record: step(record["state"] == "done", each),
            begin=lambda left: update(total=each * left),
            **options,
        )
    failures = [f"{record['name']}: {record['error']}" for record in summary.failed]
    list_failures(failures, ": manifest.jsonl lists them")
    made, existing = each * summary.made, each * summary.existing
    rate = f", {summary.seconds / made:.2f} s each" if made else ""
    before = f", {existing} were there" if existing else ""
    failed = f", {len(failures)} cannot be made" if failures else ""
    typer.echo(f"made {made} {what} in {summary.seconds:.0f} s{rate}{before}{failed}: {out}")
    if failures:
        raise typer.Exit(FAULT)
