"""Jobs whose tasks run in worker processes with a time limit and can be interrupted."""

import multiprocessing
import os
import signal
import sys
import threading
import time
import traceback
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from multiprocessing import resource_tracker
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess
from types import ModuleType
from typing import Any, Literal, Protocol

_THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")  # one core per process
_START = 60.0  # time limit for the start of a process, added to that of its first task [s]

State = Literal["done", "failed", "timed out", "crashed"]


@dataclass(frozen=True)
class Ending:
    """The result of a task."""

    item: Any  # the argument of the task
    state: State  # `failed`: it raised an exception; `crashed`: its process died
    value: Any = None  # return value; None unless it succeeded
    message: str = ""  # error message or traceback; empty after success

    @property
    def reason(self) -> str:
        """The last line of the message."""
        return self.message.strip().rpartition("\n")[2]


Engine = Callable[..., Iterator[Ending]]
"""A function of task, items and time limit [s] that runs a task for each item, as `run_tasks` does."""


class Job(Protocol):
    """Interruptible work on many items; each item is recorded as soon as it is done."""

    @property
    def task(self) -> Callable[[Any], Any]:
        """The function that runs in a worker process, on one item."""

    def left(self) -> Iterable[Any]:
        """Return the items without a record."""

    def add(self, ending: Ending) -> Any:
        """Record an item, and return the record."""


def run_job(job: Job, engine: Engine, *, limit: float, tries: int = 1) -> Iterator[Any]:
    """Process the remaining items of a job, and yield each record after it was added.

    A task that ends its process, or takes longer than `limit` [s], runs up to `tries` times.
    """
    left, tried = job.left(), Counter[Any]()
    while left:
        again = []
        for ending in engine(job.task, left, limit=limit):
            tried[ending.item] += 1
            if ending.state in ("crashed", "timed out") and tried[ending.item] < tries:
                again.append(ending.item)
            else:
                yield job.add(ending)
        left = again


def cores() -> int:
    """Return the number of cores that this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def run_tasks(
    task: Callable[[Any], Any], items: Iterable[Any], *, jobs: int, limit: float
) -> Iterator[Ending]:
    """Run a task for each item in processes of this machine, and yield the endings as they come."""
    for name in _THREADS:
        os.environ.setdefault(name, "1")
    waiting = iter(items)
    workers: list[Worker] = []
    try:
        while True:
            while len(workers) < jobs and (item := next(waiting, None)) is not None:
                workers.append(Worker(task, item, limit))
            if not workers:
                return
            left = max(min(worker.deadline for worker in workers) - time.monotonic(), 0.0)
            ready = wait([worker.pipe for worker in workers], timeout=left)
            for worker in list(workers):
                ending = worker.ending(readable=worker.pipe in ready)
                if ending is None:
                    continue
                yield ending
                following = next(waiting, None) if ending.state in ("done", "failed") else None
                if following is None:
                    worker.stop()
                    workers.remove(worker)
                else:
                    worker.give(following)
    finally:
        for worker in workers:
            worker.stop()


class Worker:
    """A process that runs a task on one item after another.

    Attributes:
        pipe: Connection for items and answers.
        deadline: End of the time limit of its task, on the monotonic clock [s].
    """

    def __init__(self, task: Callable[[Any], Any], item: Any, limit: float) -> None:
        context = multiprocessing.get_context("spawn")  # copies no threads and locks
        self.pipe, other = context.Pipe()
        self._limit = limit
        self._process: BaseProcess = context.Process(target=_work, args=(task, other), daemon=True)
        with _unnamed_main(), _deaf():
            self._process.start()
        other.close()
        self.give(item)
        self.deadline += _START

    def give(self, item: Any) -> None:
        """Send the next item."""
        self._item = item
        self.deadline = time.monotonic() + self._limit
        with suppress(OSError):  # it was killed after its answer: `ending` reports that
            self.pipe.send(item)

    def ending(self, *, readable: bool) -> Ending | None:
        """Return the ending of its task; None while it runs."""
        if readable:
            try:
                answer = self.pipe.recv()
            except (EOFError, OSError):
                self._process.join()
                code = self._process.exitcode
                return Ending(self._item, "crashed", message=f"its process ended with code {code}")
            if answer is not None:
                return Ending(self._item, *answer)
            self.deadline = time.monotonic() + self._limit  # the process has started
        elif time.monotonic() >= self.deadline:
            return Ending(self._item, "timed out", message=f"it took more than {self._limit:g} s")
        return None

    def stop(self) -> None:
        """Kill the process."""
        self._process.kill()
        self._process.join()
        self.pipe.close()


@contextmanager
def _unnamed_main() -> Iterator[None]:
    """Hide the main program from new processes: without a `__name__` guard, each would run it again."""
    main = sys.modules["__main__"]
    sys.modules["__main__"] = ModuleType("__main__")
    try:
        yield
    finally:
        sys.modules["__main__"] = main


@contextmanager
def _deaf() -> Iterator[None]:
    """Block Ctrl-C in new processes while they start; they inherit the blocked signals."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    resource_tracker.ensure_running()  # a later process would unblock it
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _work(task: Callable[[Any], Any], pipe: Connection) -> None:
    """Answer one item after another, until the other end of the pipe is closed or the parent has ended."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the parent
    threading.Thread(target=_end_with_parent, daemon=True).start()
    pipe.send(None)
    with suppress(EOFError):
        while True:
            pipe.send(attempt(task, pipe.recv()))


def attempt(task: Callable[[Any], Any], item: Any) -> tuple[State, Any, str]:
    """Run a task on an item; return state, value and message of its ending."""
    try:
        return "done", task(item), ""
    except Exception:  # noqa: BLE001 - any exception is an answer
        return "failed", None, traceback.format_exc()


def _end_with_parent() -> None:
    """End this process if its parent was killed: its task might write into the folder of a new run."""
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)
