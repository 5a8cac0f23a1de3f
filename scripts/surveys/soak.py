"""The soak: samples at the ends of ranges, until the time is over."""

import functools
import shlex
import time
from collections import Counter
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import count
from pathlib import Path
from typing import Any

from artgen.dataset.places import locked
from artgen.dataset.workers import Ending
from artgen.version import __version__
from surveys.extreme_sample import measure_extreme, of_record
from surveys.extremes import category_of
from surveys.folder import memory_folder
from surveys.run import measured, read_records

FIELDS = ("run", "sample", "category", "state", "anomalies")
"""Fields of every line of a soak."""

MADE = ("error", "not proven")
"""Kinds of anomalies that `artgen generate` reports."""

VALIDATED = ("solids", "tree", "colliders", "settling")
"""Kinds of anomalies that `artgen validate` reports for a generated asset."""

OUT = Path("out/again")
"""Folder of the commands that reproduce anomalies."""

Record = Mapping[str, Any]
Task = Callable[..., dict[str, Any]]


@dataclass(frozen=True)
class Tally:
    """The number of samples of a category, by result."""

    category: str  # name of the category
    samples: int  # number of samples
    ruled_out: int  # number that a requirement of the category ruled out
    odd: int  # number with anomalies
    kinds: Mapping[str, int]  # number with anomalies of each kind


@dataclass(frozen=True)
class Anomaly:
    """An anomaly of a sample."""

    category: str  # name of the category
    sample: int  # number of the sample
    kind: str  # ending of the sample, or the check that found the anomaly
    message: str  # the message
    command: str  # shell command that reproduces it


def soak(
    path: Path,
    *,
    run: int,
    names: Collection[str],
    seconds: float,
    jobs: int = 1,
    limit: float = 120.0,
    fresh: bool = False,
    progress: Callable[[Record], None] | None = None,
    task: Task = measure_extreme,
) -> None:
    """Measure samples that have no line in a file until the time is over, and add their lines.

    A sample that has begun is finished. One that takes too long or ends its process has a line as well.
    """
    end = time.monotonic() + seconds
    with locked(path), memory_folder() as folder:
        if fresh:
            path.unlink(missing_ok=True)
        known = {record["sample"] for record in soaked(path, run)}
        numbers, work = _numbers(names, known, end), functools.partial(task, run=run, folder=folder)
        record_of = functools.partial(_record_of, run=run)
        for record in measured(path, work, numbers, record_of, jobs=jobs, limit=limit):
            if progress is not None:
                progress(record)


def soaked(path: Path, run: int) -> list[Record]:
    """Return the records of a run, in the order of their samples."""
    records = read_records(path, FIELDS, "a soak")
    return sorted((each for each in records if each["run"] == run), key=lambda each: each["sample"])


def tallies(records: Sequence[Record]) -> list[Tally]:
    """Return the number of samples of each category, by result."""
    by_category: dict[str, list[Record]] = {}
    for record in records:
        by_category.setdefault(record["category"], []).append(record)
    return [_tally(name, by_category[name]) for name in sorted(by_category)]


def anomalies(records: Sequence[Record]) -> list[Anomaly]:
    """Return all anomalies, by category and kind."""
    found = [
        Anomaly(
            record["category"], record["sample"], each["kind"], each["message"], again(record, each["kind"])
        )
        for record in records
        for each in record["anomalies"]
    ]
    return sorted(found, key=lambda each: (each.category, each.kind, each.sample))


def again(record: Record, kind: str) -> str:
    """Return the shell command that reproduces an anomaly of a kind."""
    if kind not in MADE + VALIDATED:
        return f"python scripts/soak.py --seed {record['run']} --sample {record['sample']}"
    extreme = of_record(record)
    out = OUT / f"{extreme.category}_{extreme.run}_{extreme.number}"
    if kind in MADE:
        return extreme.command(out, on_collision="fail")
    made = extreme.command(out, on_collision="keep")
    return f"{made} && {shlex.join(['artgen', 'validate', str(out)])}"


def _numbers(names: Collection[str], known: Collection[int], end: float) -> Iterator[int]:
    """Yield numbers of unknown samples until a time on the monotonic clock [s]."""
    for number in count():
        if number in known or category_of(number) not in names:
            continue
        if time.monotonic() >= end:
            return
        yield number


def _record_of(ending: Ending, run: int) -> dict[str, Any]:
    """Return the record of a sample with any ending."""
    if ending.state == "done":
        return dict(ending.value)
    return {
        "run": run,
        "sample": ending.item,
        "category": category_of(ending.item),
        "state": ending.state,
        "message": "",
        "anomalies": [{"kind": ending.state, "message": ending.message.strip()}],
        "version": __version__,
    }


def _tally(name: str, records: Sequence[Record]) -> Tally:
    kinds = Counter(kind for record in records for kind in {each["kind"] for each in record["anomalies"]})
    return Tally(
        name,
        len(records),
        sum(record["state"] == "ruled out" for record in records),
        sum(bool(record["anomalies"]) for record in records),
        dict(kinds.most_common()),
    )
