"""Progress on stderr in terminals and notebooks: one display per process, with nested steps."""

import os
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from importlib.util import find_spec

SILENT = "ARTGEN_PROGRESS"
"""Environment variable; `0` shows no progress."""

Update = Callable[..., None]
"""Function that takes any of `text`, `completed`, `advance`, `total` and `failed`."""

_DELAY = 1.0  # shorter steps show nothing [s]
_INTERVAL = 30.0  # time between two lines where nothing can change in place [s]


@contextmanager
def progress(
    name: str, total: int | None = None, *, lines: bool = False, shown: bool = True
) -> Iterator[Update]:
    """Show a step until its end; yield the function that tells how far it is.

    The display appears after a second, for the main thread of the main process only. A step within a step is
    a further part of the text.

    Args:
        name: Text of the step.
        total: Number of its parts, if known.
        lines: Whether to write a line every 30 seconds where there is neither terminal nor notebook.
        shown: Whether to show anything.
    """
    global _display  # noqa: PLW0603 - a process has one stderr
    if (
        os.environ.get(SILENT) == "0"
        or _is_worker()
        or threading.current_thread() is not threading.main_thread()
    ):
        yield lambda **_: None
    elif _display is not None:
        with _display.step(name, total) as update:
            yield update
    elif not shown or not (lines or _live()):
        yield lambda **_: None
    else:
        _display = _Bar() if _live() else _Display()
        try:
            with _display.step(name, total) as update:
                yield update
        finally:
            _display.stop()
            _display = None


def _is_worker() -> bool:
    """Tell whether this is a process that another one started to work for it."""
    multiprocessing = sys.modules.get("multiprocessing")  # a worker has it; others need not load it
    return multiprocessing is not None and multiprocessing.parent_process() is not None


def _live() -> bool:
    """Tell whether a text can change in place: in a terminal, or in a notebook with widgets."""
    if "ipykernel" in sys.modules:
        return find_spec("ipywidgets") is not None
    return sys.stderr is not None and sys.stderr.isatty()


@dataclass
class _Step:
    """A step in progress."""

    text: str
    total: int | None
    done: int = 0
    failed: str = ""

    def __str__(self) -> str:
        count = f" {self.done}/{self.total}" if self.total else ""
        return self.text + count + (f", {self.failed}" if self.failed else "")


class _Display:
    """The steps in progress, written as a line from time to time."""

    def __init__(self) -> None:
        self._last = time.monotonic()
        self.steps: list[_Step] = []

    @contextmanager
    def step(self, name: str, total: int | None) -> Iterator[Update]:
        """Add a step until its end; yield the function that updates it."""
        step = _Step(name, total)
        depth = len(self.steps)
        self.steps.append(step)

        def update(
            text: str = "",
            completed: int | None = None,
            advance: int = 0,
            total: int | None = None,
            failed: str = "",
        ) -> None:
            step.text, step.total = text or step.text, total or step.total
            step.done = step.done + advance if completed is None else completed
            step.failed = failed or step.failed
            self._show()

        try:
            self._show()
            yield update
        finally:
            del self.steps[depth:]

    def _show(self) -> None:
        if time.monotonic() - self._last >= _INTERVAL:
            self._last = time.monotonic()
            sys.stderr.write(": ".join(map(str, self.steps)) + "\n")
            sys.stderr.flush()

    def stop(self) -> None:
        """Remove the display."""


class _Bar(_Display):
    """The steps in progress, shown in place: the first as a bar, the others as text."""

    def __init__(self) -> None:
        from rich import progress as rich
        from rich.console import Console

        super().__init__()
        self._bar = rich.Progress(
            rich.SpinnerColumn(),
            rich.TextColumn("{task.description}", markup=False),
            rich.BarColumn(bar_width=20),
            rich.TextColumn("{task.fields[count]}", markup=False),
            rich.TimeRemainingColumn(elapsed_when_finished=True),
            rich.TimeElapsedColumn(),
            rich.TextColumn("{task.fields[inner]}", markup=False),
            console=Console(stderr=True),
            transient=True,
        )
        self._task = self._bar.add_task("", total=None, count="", inner="")
        self._lock, self._ended = threading.Lock(), False
        self._timer = threading.Timer(_DELAY, self._begin)
        self._timer.daemon = True
        self._timer.start()

    def _begin(self) -> None:
        with self._lock:
            if not self._ended:
                self._bar.start()

    def _show(self) -> None:
        outer, *inner = self.steps
        elapsed = self._bar.tasks[0].elapsed
        counts = [f"{outer.done}/{outer.total}"] if outer.total else []
        counts += [f"{outer.done / elapsed:.1f}/s"] if outer.done and elapsed else []
        self._bar.update(
            self._task,
            description=outer.text,
            total=outer.total,
            completed=outer.done,
            count=", ".join([*counts, outer.failed] if outer.failed else counts),
            inner=": ".join(map(str, inner)),
        )

    def stop(self) -> None:
        with self._lock:
            self._ended = True
            self._timer.cancel()
            self._bar.stop()


_display: _Display | None = None
