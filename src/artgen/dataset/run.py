"""The run: worker processes make what a folder has not, and everything that lands is on record at once."""

import functools
import os
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from artgen.dataset.folder import GO_ON, Folder
from artgen.dataset.make import Made, make
from artgen.dataset.plan import Item, Plan
from artgen.dataset.record import failure
from artgen.dataset.tables import write_tables
from artgen.dataset.workers import Ending, run_tasks
from artgen.errors import ExportError, ParameterError

_TRIES = 3  # for an item whose process dies or takes too long

Progress = Callable[[dict[str, Any]], None]


@dataclass(frozen=True)
class Summary:
    """What a run did.

    Attributes:
        made: How many assets it made.
        kept: How many were there before.
        failed: The lines of those that cannot be made, of this run and of earlier ones.
        seconds: How long it took [s].
    """

    made: int
    kept: int
    failed: tuple[dict[str, Any], ...] = field(default=())
    seconds: float = 0.0


def generate_many(
    plan: Plan,
    directory: str | Path,
    *,
    jobs: int | None = None,
    limit: float = 600.0,
    progress: Progress | None = None,
    begin: Callable[[int], None] | None = None,
) -> Summary:
    """Make all assets of a plan in a folder, with a manifest and tables of their parameters.

    The files depend on the plan alone, not on how many processes work or how often they were interrupted: a
    run in a folder of the same plan makes what is missing. An asset that cannot be made is a line of the
    manifest with its error; one that ended its process, or took too long, is tried again twice, and by the
    next run.

    Args:
        plan: What to make.
        directory: Where; made if there is none, else it is empty or holds a dataset of the same plan.
        jobs: How many processes work; by default as many as there are cores for this one.
        limit: How long one asset may take [s].
        progress: Called with each line of the manifest as it is added.
        begin: Called before, with how many assets are missing.

    Raises:
        ParameterError: `jobs` is less than one.
        ExportError: The folder holds something else, another run writes to it, or the disk refuses; what is
            done stays.
    """
    workers = cores() if jobs is None else jobs
    if workers < 1:
        raise ParameterError(f"at least one process has to work, not {workers}")
    start = time.monotonic()
    path = Path(directory).absolute()
    with Folder.opened(path, plan) as folder:
        left = [item for item in folder.plan.items() if item.name not in folder.records]
        kept = sum(record["state"] == "done" for record in folder.records.values())
        if begin is not None:
            begin(len(left))
        made = 0
        task = functools.partial(make, plan=folder.plan, folder=path, staging=folder.staging)
        for item, record in _records(task, left, workers, limit):
            folder.add(item, record)
            made += record["state"] == "done"
            if progress is not None:
                progress(record)
        folder.finish()
        write_tables(folder.path, folder.records.values())
        failed = tuple(
            folder.records[item.name]
            for item in folder.plan.items()
            if folder.records[item.name]["state"] != "done"
        )
    return Summary(made, kept, failed, time.monotonic() - start)


def cores() -> int:
    """Return how many cores this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def _records(
    task: Callable[[Item], Made], items: list[Item], jobs: int, limit: float
) -> Iterator[tuple[Item, dict[str, Any]]]:
    """Yield each item with its line, in the order in which they are done.

    Raises:
        ExportError: The disk refuses.
    """
    tries = dict.fromkeys(items, 0)
    while items:
        again = []
        for ending in run_tasks(task, items, jobs=jobs, limit=limit):
            item: Item = ending.item
            tries[item] += 1
            if ending.state == "done":
                yield item, _line(ending.value)
            elif tries[item] < _TRIES and ending.state != "failed":
                again.append(item)
            else:
                yield item, failure(item.name, item.category, item.seed, _told(ending)) | {"state": "lost"}
        items = again


def _line(made: Made) -> dict[str, Any]:
    if made.record is None:
        raise ExportError(f"an asset cannot be written: {made.refusal}; {GO_ON}")
    return made.record


def _told(ending: Ending) -> str:
    return ending.message.strip().splitlines()[-1]
