"""The soak: samples at the ends of ranges, one after another, until the time is over."""

import functools
import shlex
import time
from collections import Counter
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import count
from pathlib import Path
from typing import Any

from artgen.dataset.disk import locked
from artgen.dataset.workers import Ending
from artgen.version import __version__
from surveys.extreme_sample import measure_extreme, of_record
from surveys.extremes import category_of
from surveys.folder import memory_folder
from surveys.run import measured, read_records

FIELDS = ("run", "sample", "category", "state", "anomalies")
"""What every line of a soak has."""

MADE = ("error", "not proven")
"""Kinds of anomalies that `artgen generate` tells."""

VALIDATED = ("solids", "tree", "colliders", "settling")
"""Kinds of anomalies that `artgen validate` tells of what was generated."""

OUT = Path("out/again")
"""Where the commands that reproduce anomalies write to."""

Record = Mapping[str, Any]
Task = Callable[..., dict[str, Any]]


@dataclass(frozen=True)
class Tally:
    """What became of the samples of a category.

    Attributes:
        category: Its name.
        samples: How many there are.
        ruled_out: How many a requirement of the category ruled out.
        odd: How many have anomalies.
        kinds: How many have anomalies of each kind.
    """

    category: str
    samples: int
    ruled_out: int
    odd: int
    kinds: Mapping[str, int]


@dataclass(frozen=True)
class Anomaly:
    """Something wrong with a sample.

    Attributes:
        category: Name of the category.
        sample: Number of the sample.
        kind: How it ended, or what found it.
        message: What is wrong.
        command: The command of a shell that shows it again.
    """

    category: str
    sample: int
    kind: str
    message: str
    command: str


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
    """Measure samples that a file has no line of until the time is over, and add their lines.

    A sample that has begun is finished. One that takes too long or ends its process is a line as well.

    Args:
        path: The file, of JSON lines; those of other runs may stand in it too.
        run: Seed of the run.
        names: Categories whose samples are measured; they are sampled in turn.
        seconds: How long samples are begun [s].
        jobs: How many processes measure.
        limit: How long one sample may take [s].
        fresh: Whether to throw away what the file holds.
        progress: Called with each record.
        task: What measures.

    Raises:
        ExportError: The file is not one of a soak, cannot be written, or another soak writes to it.
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
    """Return the records of a run, in the order of their samples.

    Raises:
        ExportError: The file is not one of a soak, or cannot be read.
    """
    records = read_records(path, FIELDS, "a soak")
    return sorted((each for each in records if each["run"] == run), key=lambda each: each["sample"])


def tallies(records: Sequence[Record]) -> list[Tally]:
    """Return what became of the samples of each category."""
    by_category: dict[str, list[Record]] = {}
    for record in records:
        by_category.setdefault(record["category"], []).append(record)
    return [_tally(name, by_category[name]) for name in sorted(by_category)]


def anomalies(records: Sequence[Record]) -> list[Anomaly]:
    """Return all that is wrong, by category and kind."""
    found = [
        Anomaly(
            record["category"], record["sample"], each["kind"], each["message"], again(record, each["kind"])
        )
        for record in records
        for each in record["anomalies"]
    ]
    return sorted(found, key=lambda each: (each.category, each.kind, each.sample))


def again(record: Record, kind: str) -> str:
    """Return the command of a shell that shows an anomaly of a kind again."""
    if kind not in MADE + VALIDATED:
        return f"python scripts/soak.py --seed {record['run']} --sample {record['sample']}"
    extreme = of_record(record)
    out = OUT / f"{extreme.category}_{extreme.run}_{extreme.number}"
    if kind in MADE:
        return extreme.command(out, on_collision="fail")
    made = extreme.command(out, on_collision="keep")
    return f"{made} && {shlex.join(['artgen', 'validate', str(out)])}"


def _numbers(names: Collection[str], known: Collection[int], end: float) -> Iterator[int]:
    """Yield numbers of samples that are not known until a time on the monotonic clock [s]."""
    for number in count():
        if number in known or category_of(number) not in names:
            continue
        if time.monotonic() >= end:
            return
        yield number


def _record_of(ending: Ending, run: int) -> dict[str, Any]:
    """Return the record of a sample, whatever became of it."""
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
