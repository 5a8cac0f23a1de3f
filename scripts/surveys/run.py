"""The run of a survey: a line of a file for each seed, so that it can be interrupted and go on."""

import functools
import json
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Any

from artgen.dataset.lines import lines_of
from artgen.dataset.workers import run_tasks
from artgen.errors import ExportError
from surveys.sample import measure

Task = Callable[..., dict[str, Any]]

FIELDS = ("seed", "category", "state")
"""What every line of a survey has."""


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
    """Measure the samples of seeds that a file has no line of, add their lines, and return all records.

    A sample that fails, takes too long or ends its process is a line with the message. A line that was
    measured `fast` is measured again where the survey is not.

    Args:
        category: Name of the category.
        seeds: The seeds.
        path: The file, of JSON lines; that of other categories may stand in it too.
        fast: Whether to leave out what a simulator and hands tell.
        jobs: How many processes measure.
        limit: How long one seed may take [s].
        progress: Called after each seed.
        task: What measures.

    Raises:
        ExportError: The file is not one of a survey, or cannot be written.
    """
    wanted = list(seeds)
    known = {
        record["seed"]: record
        for record in read_records(path)
        if record["category"] == category and (fast or not record.get("fast", False))
    }
    left = [seed for seed in wanted if seed not in known]
    try:
        with path.open("a", encoding="utf-8") as file:
            work = functools.partial(task, category=category, fast=fast)
            for ending in run_tasks(work, left, jobs=jobs, limit=limit):
                record = ending.value or {
                    "category": category,
                    "seed": ending.item,
                    "state": ending.state,
                    "message": ending.message,
                }
                record = {**record, "fast": fast}
                known[ending.item] = record
                file.write(json.dumps(record, allow_nan=False) + "\n")
                file.flush()
                if progress is not None:
                    progress()
    except OSError as error:
        raise ExportError(f"cannot write {path}: {error.strerror}") from error
    return [known[seed] for seed in wanted]


def read_records(
    path: Path, fields: Sequence[str] = FIELDS, of: str = "a survey"
) -> Sequence[dict[str, Any]]:
    """Return the records of a file; none if there is no such file.

    The last line of a run that was interrupted may be cut off; it is left out, and cut from the file.

    Args:
        path: The file, of JSON lines.
        fields: What each line has to have.
        of: What wrote such a file, in messages.

    Raises:
        ExportError: The file is of another kind, or cannot be read.
    """
    records = []
    lines, cut = lines_of(path)
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
