"""Progress bars of long commands, and the run of commands that process many assets."""

from collections.abc import Callable
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
from rich.text import Text

from artgen.dataset import Summary
from artgen.dataset.places import GO_ON


def progress_bar() -> Progress:
    """Return a progress bar on stderr, which appears on terminals only and is removed at the end."""
    return _bar()


def rate_bar() -> Progress:
    """Return a progress bar with the rate per second; its tasks have a field `failed`."""
    return _bar(_Rate(), TextColumn("[red]{task.fields[failed]}"))


class _Rate(ProgressColumn):
    """Steps per second."""

    def render(self, task: Task) -> Text:
        """Return the rate as text."""
        speed = task.finished_speed or task.speed
        return Text("" if speed is None else f"{speed:.1f}/s")


def _bar(*columns: ProgressColumn) -> Progress:
    console = Console(stderr=True)
    return Progress(
        TextColumn("{task.description}"),
        BarColumn(),
        MofNCompleteColumn(),
        *columns,
        TimeRemainingColumn(),
        console=console,
        transient=True,
        disable=not console.is_terminal,
    )


_FAULT = 1  # exit code
_INTERRUPTED = 130  # exit code
_SHOWN = 20  # most listed seeds that failed

Step = Callable[[dict[str, Any]], None]
Begin = Callable[[int], None]


def many(work: Callable[[Step, Begin], Summary], out: str, *, each: int = 1, what: str = "assets") -> None:
    """Run the work on a dataset, show its progress, and list the failures.

    Args:
        work: Function that does the work; its arguments are a callback for each line of the manifest and a
            callback for the number of missing lines.
        out: Target folder.
        each: Number of results per asset.
        what: Plural noun for the results.

    Raises:
        Exit: An asset failed.
    """
    try:
        with rate_bar() as bar:
            task = bar.add_task(Path(out).name, total=None, failed="")
            failed = 0

            def step(record: dict[str, Any]) -> None:
                nonlocal failed
                failed += record["state"] != "done"
                bar.update(task, advance=each, failed=f"{failed} failed" if failed else "")

            summary = work(step, lambda left: bar.update(task, total=each * left))
    except KeyboardInterrupt:
        typer.echo(f"interrupted; {GO_ON}", err=True)
        raise typer.Exit(_INTERRUPTED) from None
    _tell(summary, out, each, what)
    if summary.failed:
        raise typer.Exit(_FAULT)


def _tell(summary: Summary, out: str, each: int, what: str) -> None:
    """List the failures on stderr, and the number of finished assets on stdout."""
    for record in summary.failed[:_SHOWN]:
        typer.echo(f"{record['name']}: {record['error']}", err=True)
    if len(summary.failed) > _SHOWN:
        typer.echo(f"and {len(summary.failed) - _SHOWN} more: manifest.jsonl lists them", err=True)
    made, existing = each * summary.made, each * summary.existing
    rate = f", {summary.seconds / made:.2f} s each" if made else ""
    before = f", {existing} were there" if existing else ""
    failed = f", {len(summary.failed)} cannot be made" if summary.failed else ""
    typer.echo(f"made {made} {what} in {summary.seconds:.0f} s{rate}{before}{failed}: {out}")
