"""The run: worker processes make what a folder has not, and everything that lands is on record at once."""

import functools
import time
from collections.abc import Callable, Collection, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from artgen.dataset.engine import EngineName, engine_of
from artgen.dataset.folder import Folder, writing
from artgen.dataset.make import Made, make
from artgen.dataset.plan import Draws, Item, Plan
from artgen.dataset.record import failure
from artgen.dataset.store import target_of
from artgen.dataset.tables import write_tables
from artgen.dataset.target import GO_ON, Target
from artgen.dataset.workers import Ending, Engine
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
    engine: EngineName = "local",
    address: str | None = None,
    limit: float = 600.0,
    progress: Progress | None = None,
    begin: Callable[[int], None] | None = None,
) -> Summary:
    """Make all assets of a plan in a folder or at a URL, with a manifest and tables of their parameters.

    The files depend on the plan alone, not on how many processes work or how often they were interrupted: a
    run in a folder of the same plan makes what is missing. An asset that cannot be made is a line of the
    manifest with its error; one that ended its process, or took too long, is tried again twice, and by the
    next run.

    Args:
        plan: What to make.
        directory: Where: a folder, or a URL that fsspec knows; made if there is none, else it is empty or
            holds a dataset of the same plan.
        jobs: How many processes work; by default as many as there are cores for this one, or in the cluster.
        engine: What runs them: `local` processes, or `ray`.
        address: Of a Ray cluster that runs; by default the variable RAY_ADDRESS tells it, or one is started
            here.
        limit: How long one asset may take [s].
        progress: Called with each line of the manifest as it is added.
        begin: Called before, with how many assets are missing.

    Raises:
        ParameterError: `jobs` is less than one, or there is no such engine.
        ExportError: The folder holds something else, another run writes to it, the disk refuses, or there is
            no such cluster; what is done stays.
    """
    return fill(
        plan,
        directory,
        make=make,
        finish=write_tables,
        jobs=jobs,
        engine=engine,
        address=address,
        limit=limit,
        progress=progress,
        begin=begin,
    )


def fill(
    plan: Draws,
    directory: str | Path,
    *,
    make: Callable[..., Made],
    finish: Callable[[Target, Collection[dict[str, Any]]], None],
    jobs: int | None = None,
    engine: EngineName = "local",
    address: str | None = None,
    limit: float = 600.0,
    progress: Progress | None = None,
    begin: Callable[[int], None] | None = None,
) -> Summary:
    """Do a plan of any kind in a folder, as `generate_many` does."""
    if jobs is not None and jobs < 1:
        raise ParameterError(f"at least one process has to work, not {jobs}")
    start = time.monotonic()
    target = target_of(directory).absolute()
    with engine_of(engine, jobs=jobs, address=address) as run, Folder.opened(target, plan) as folder:
        left = [item for item in folder.plan.items() if item.name not in folder.records]
        kept = sum(record["state"] == "done" for record in folder.records.values())
        if begin is not None:
            begin(len(left))
        made = 0
        task = functools.partial(make, plan=folder.plan, target=target)
        for item, record in _records(run, task, left, limit):
            folder.add(item, record)
            made += record["state"] == "done"
            if progress is not None:
                progress(record)
        folder.finish()
        records = [folder.records[item.name] for item in folder.plan.items()]
        with writing(target):
            finish(target, records)
        failed = tuple(record for record in records if record["state"] != "done")
    return Summary(made, kept, failed, time.monotonic() - start)


def _records(
    run: Engine, task: Callable[[Item], Made], items: list[Item], limit: float
) -> Iterator[tuple[Item, dict[str, Any]]]:
    """Yield each item with its line, in the order in which they are done."""
    tries = dict.fromkeys(items, 0)
    while items:
        again = []
        for ending in run(task, items, limit=limit):
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
