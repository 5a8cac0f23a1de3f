"""Tables and progress bars of commands, and the run of commands that make many things."""

import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer
from rich.console import Console
from rich.table import Table

from artgen._progress import Update
from artgen._progress import progress as shown_progress

if TYPE_CHECKING:
    from artgen.dataset.plan import BasePlan

FAULT = 1
"""Exit code of a command that found a fault."""

NOT_PROVEN = 3
"""Exit code if no collision was found, and not everything is proven."""

INTERRUPTED = 130
"""Exit code after Ctrl-C."""

progress = partial(shown_progress, lines=True)
"""Show a step of a command; see `artgen._progress.progress`."""

_PLAIN_WIDTH = 1000  # columns of tables in files and pipes: one line per row
_SHOWN = 20  # most listed failures


class InterruptedRunError(Exception):
    """Ctrl-C in a run that can be continued."""


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
def counting(name: str, total: int | None = None) -> Iterator[tuple[Callable[[bool, int], None], Update]]:
    """Show the progress of a run; yield a function for each result, and the update of the bar.

    The first function takes the success of the result and the number of steps.

    Raises:
        InterruptedRunError: Ctrl-C was pressed.
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
        from artgen.dataset.places import RESUME

        raise InterruptedRunError(f"interrupted; {RESUME}") from None


def list_failures(failures: Sequence[str], rest: str = "") -> None:
    """Print failures to stderr, the first ones if there are many."""
    for failure in failures[:_SHOWN]:
        typer.echo(failure, err=True)
    if len(failures) > _SHOWN:
        typer.echo(f"and {len(failures) - _SHOWN} more{rest}", err=True)


def make_dataset(plan: "BasePlan", out: str, *, each: int = 1, what: str = "assets", **options: Any) -> None:
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
    from artgen.dataset import generate_many

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
