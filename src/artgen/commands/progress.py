"""The progress bars of commands that take long."""

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


def progress_bar() -> Progress:
    """Return a bar on stderr, which is shown on a terminal only and leaves nothing behind."""
    return _bar()


def rate_bar() -> Progress:
    """Return such a bar that also says how many a second there are; its tasks have a field `failed`."""
    return _bar(_Rate(), TextColumn("[red]{task.fields[failed]}"))


class _Rate(ProgressColumn):
    """How many steps a second there are."""

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
