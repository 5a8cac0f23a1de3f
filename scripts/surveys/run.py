"""Surveys: a line of a file for each sample, so that an interrupted survey can be continued."""

import functools
import json
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path
from typing import Any

from artgen.dataset.workers import Ending, run_job, run_tasks
from artgen.errors import ExportError
from surveys.sample import measure

Task = Callable[..., dict[str, Any]]

FIELDS = ("seed", "category", "state")
"""Fields of every line of a survey."""


def measured(
    path: Path,
    task: Callable[[int], dict[str, Any]],
    numbers: Iterable[int],
    record_of: Callable[[Ending], dict[str, Any]],
    *,
    jobs: int,
    limit: float,
) -> Iterator[dict[str, Any]]:
    """Measure samples, add their lines to a file, and yield their records."""
    try:
        with path.open("a", buffering=1, encoding="utf-8", newline="\n") as lines:  # each line at once

            def add(ending: Ending) -> dict[str, Any]:
                record = record_of(ending)
                lines.write(json.dumps(record, allow_nan=False) + "\n")
                return record

            yield from run_job(task, numbers, add, functools.partial(run_tasks, jobs=jobs), limit=limit)
    except OSError as error:
        raise ExportError(f"cannot write {path}: {error.strerror}") from error


def survey(
    category: str,
    seeds: Iterable[int],
    path: Path,
    *,
    fast: bool = False,
    jobs: int = 1,
    limit: float = 120.0,
    progress: Callable[[], None] | None = None,
    task: Task = measure,
) -> list[dict[str, Any]]:
    """Measure those samples that have no line in a file, add their lines, and return all records.

    A sample that fails, takes too long or ends its process is a line with the message. A line of a `fast`
    survey counts for fast surveys only.
    """
    wanted = list(seeds)
    known = {
        record["seed"]: record
        for record in read_records(path)
        if record["category"] == category and (fast or not record.get("fast", False))
    }
    left = [seed for seed in wanted if seed not in known]

    def record_of(ending: Ending) -> dict[str, Any]:
        lost = {"category": category, "seed": ending.item, "state": ending.state, "message": ending.message}
        return (ending.value or lost) | {"fast": fast}

    work = functools.partial(task, category=category, fast=fast)
    for record in measured(path, work, left, record_of, jobs=jobs, limit=limit):
        known[record["seed"]] = record
        if progress is not None:
            progress()
    return [known[seed] for seed in wanted]


def read_records(
    path: Path, fields: Sequence[str] = FIELDS, of: str = "a survey"
) -> Sequence[dict[str, Any]]:
    """Return the records of a file; none if there is no such file.

    An incomplete last line of an interrupted run is cut from the file.
    """
    records = []
    *lines, cut = path.read_text(encoding="utf-8").split("\n") if path.exists() else [""]
    for number, line in enumerate(lines):
        try:
            record = json.loads(line)
            for field in fields:
                record[field]
        except (ValueError, TypeError, KeyError) as error:
            raise ExportError(
                f"{path}: line {number + 1} is no record of {of}; give another --out"
            ) from error
        records.append(record)
    if cut:
        path.write_text("".join(f"{line}\n" for line in lines), encoding="utf-8")
    return records
