"""Many demonstrations of a task, made by processes and written in the order of their seeds."""

import time
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

from artgen.dataset.lock import locked
from artgen.dataset.workers import Ending, cores, run_tasks
from artgen.demos import layout
from artgen.demos.episode import Demo, check_task, record
from artgen.demos.resume import Kept, read
from artgen.errors import CheckError, ExportError, ParameterError
from artgen.export.files import replaced
from artgen.version import __version__

DEMO_FILE = "demo.hdf5"
"""The file with all demonstrations."""

_KEPT = ".attempts"  # folder of what an unfinished run has made
_LIMIT = 900.0  # that one demonstration may take [s]
_SPARE = 10  # more attempts than twice as many as demonstrations


@dataclass(frozen=True)
class Summary:
    """What a run did.

    Attributes:
        file: What it wrote.
        demos: How many demonstrations there are.
        steps: How many steps they have together.
        failed: Why each seed gave no demonstration.
        seconds: How long it took.
    """

    file: Path
    demos: int
    steps: int
    failed: dict[int, str]
    seconds: float


def make_demos(
    task: str,
    count: int,
    out: str | Path,
    *,
    seed: int = 0,
    image: int = 0,
    noise: float = 0.0,
    jobs: int | None = None,
    progress: Callable[[bool], None] = lambda succeeded: None,
) -> Summary:
    """Let the scripted policy do a task until it has succeeded so often, each time with another asset.

    The bytes of the file depend on the task, the count, the seed, the image size and the noise alone.

    Args:
        task: Its name, such as `OpenDrawer`.
        count: How many demonstrations to write.
        out: Folder for `demo.hdf5`, which is complete or absent; one of an earlier run is replaced. A run
            that was interrupted goes on from what it has made, which is in `.attempts` there till the end.
        seed: Of the first asset; those after it follow.
        image: Pixels on a side of the pictures among the observations; 0 for none.
        noise: Spread of what is added at random to the motion of the arm, so that demonstrations show how to
            get back to the way; the actions are those wanted, `applied` those that were done.
        jobs: How many processes work; all cores by default.
        progress: Told after each attempt whether it succeeded.

    Raises:
        ParameterError: There is no such task, or a number is out of its range.
        EnvError: A package of the environments is not installed.
        ExportError: h5py is not installed, `demo.hdf5` is there and not artgen's, or the disk refuses.
        CheckError: The policy fails too often; nothing is written.
    """
    check_task(task)
    _check("the number of demonstrations", count, 1, 10_000_000)
    _check("the size of an image", image, 0, 4096)
    _check("the noise", noise, 0.0, 1.0)
    file = Path(out) / DEMO_FILE
    layout.hdf5()
    if file.exists() and not layout.is_ours(file):
        raise ExportError(f"{file} is there and holds no demonstrations of artgen; choose another directory")
    start, steps = time.monotonic(), 0
    failed: dict[int, str] = {}
    attempts = range(seed, seed + 2 * count + _SPARE)
    plan = {"task": task, "image": image, "noise": noise, "version": __version__}
    with locked(_folder(file.parent)), replaced(file) as partial_file, layout.writer(partial_file) as writer:
        kept = Kept(file.parent / _KEPT, plan)
        for ending in _endings(partial(record, task, image=image, noise=noise), attempts, kept, jobs):
            demo: Demo | None = ending.value
            if demo is not None and demo.success:
                writer.add(demo)
                steps += len(demo)
            else:
                failed[ending.item] = _reason(ending)
            progress(ending.item not in failed)
            if len(writer.names) == count:
                break
        if len(writer.names) < count:
            last = failed[max(failed)]
            kept.remove()
            raise CheckError(
                f"the scripted policy of {task} succeeded in {len(writer.names)} of {len(attempts)} "
                f"attempts, too few for {count} demonstrations; nothing was written. The last failure: {last}"
            )
        writer.finish(f"artgen/{task}-v0", {"obs": "state"})
    kept.remove()
    return Summary(file, count, steps, failed, time.monotonic() - start)


def _folder(path: Path) -> Path:
    try:
        path.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise ExportError(f"cannot write to {path}: {error.strerror}; choose another directory") from error
    return path


def _endings(task: Callable[[int], Demo], seeds: range, kept: Kept, jobs: int | None) -> Iterator[Ending]:
    """Yield how each attempt ended, in the order of the seeds: read, where an interrupted run has made it."""
    there = kept.of(seeds)
    todo = [seed for seed in seeds if seed not in there]
    made = in_order(kept.saved(run_tasks(task, todo, jobs=jobs or cores(), limit=_LIMIT)), todo)
    for seed in seeds:
        yield read(seed, there[seed]) if seed in there else next(made)


def in_order(endings: Iterable[Ending], items: Iterable[Any]) -> Iterator[Ending]:
    """Yield how tasks ended in the order of their items; those that are early wait."""
    early: dict[Any, Ending] = {}
    arriving = iter(endings)
    for item in items:
        while item not in early:
            ending = next(arriving)
            early[ending.item] = ending
        yield early.pop(item)


def _reason(ending: Ending) -> str:
    """Say why an attempt gave no demonstration."""
    if ending.state == "done":
        return "the time was over before it succeeded"
    return ending.message.strip().splitlines()[-1]


def _check(what: str, value: float, least: float, most: float) -> None:
    if not least <= value <= most:
        raise ParameterError(f"{what} is {value:g}; it can be {least:g} to {most:g}")
