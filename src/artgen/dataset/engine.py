"""What runs the tasks of a dataset: processes of this machine, or a Ray cluster."""

import os
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from functools import partial
from typing import Any, Literal, Protocol, get_args

from artgen.dataset.workers import Ending, run_tasks
from artgen.errors import ParameterError

EngineName = Literal["local", "ray"]


class Engine(Protocol):
    """A function that runs a task for each item, and yields how each ends, in the order in which they do."""

    def __call__(self, task: Callable[[Any], Any], items: Iterable[Any], *, limit: float) -> Iterator[Ending]:
        """Run them; a task may take `limit` [s], and is ended then."""


@contextmanager
def engine_of(name: EngineName, *, jobs: int | None, address: str | None) -> Iterator[Engine]:
    """Give the engine of that name.

    Args:
        name: Its name.
        jobs: How many processes work; all cores by default.
        address: Of a Ray cluster.

    Raises:
        ParameterError: There is none of that name, or it takes no address.
        ExportError: Ray or the cluster is not there.
    """
    if name not in get_args(EngineName):
        raise ParameterError(f"the engine is local or ray, not {name!r}")
    if name == "local":
        if address is not None:
            raise ParameterError(f"the address {address!r} is of a Ray cluster: choose the engine ray")
        yield partial(run_tasks, jobs=jobs or cores())
        return
    from artgen.dataset.ray_engine import cluster

    with cluster(address, jobs) as run:
        yield run


def cores() -> int:
    """Return how many cores this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1
