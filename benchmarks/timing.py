"""Processor times of alternating runs, and a fixed workload for comparing machines."""

import gc
import os
import resource
import statistics
import tempfile
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

import numpy as np
from manifold3d import Manifold


def processor_seconds() -> float:
    """Return the processor time of this process and of its ended children [s]."""
    used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(each.ru_utime + each.ru_stime for each in used)


def seconds(work: Callable[[], object]) -> float:
    """Return the processor time of some work, in this process and its children [s]."""
    gc.collect()
    start = processor_seconds()
    work()
    return processor_seconds() - start


@contextmanager
def timed(times: dict[str, float], stage: str) -> Iterator[None]:
    """Note what a stage takes of the processor [s]."""
    gc.collect()
    start = processor_seconds()
    yield
    times[stage] = processor_seconds() - start


def alternating(works: Mapping[str, Callable[[], float]], runs: int) -> dict[str, float]:
    """Return the median of what some measurements return, one after another, so many rounds."""
    found: dict[str, list[float]] = {name: [] for name in works}
    for _ in range(runs):
        for name, work in works.items():
            found[name].append(work())
    return {name: statistics.median(each) for name, each in found.items()}


def baseline() -> float:
    """Return the time of a fixed workload: 20 booleans and 1000 products of small matrices [s]."""
    return statistics.median(seconds(_workload) for _ in range(5))


def _workload() -> None:
    solid = Manifold.cube((1.0, 1.0, 1.0), center=True)
    for step in range(20):
        solid -= Manifold.cylinder(2.0, 0.02, circular_segments=16).translate((0.02 * step - 0.2, 0.0, -1.0))
        solid.status()
    values = np.arange(300.0).reshape(-1, 3)
    for _ in range(1000):
        values = values @ np.eye(3)


@contextmanager
def empty_cache() -> Iterator[Path]:
    """Use an empty folder as the disk cache of artgen within a context."""
    before = os.environ.get("ARTGEN_CACHE")
    with tempfile.TemporaryDirectory() as directory:
        os.environ["ARTGEN_CACHE"] = directory
        try:
            yield Path(directory)
        finally:
            del os.environ["ARTGEN_CACHE"]
            if before is not None:
                os.environ["ARTGEN_CACHE"] = before
