"""Tasks in processes of their own, with a time limit: none of them can end a run."""

import multiprocessing
import os
import signal
import sys
import threading
import time
import traceback
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from multiprocessing import resource_tracker
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess
from types import ModuleType
from typing import Any, Literal, Protocol

_THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")  # each process has one core
_START = 60.0  # that a process may take to start, beside its first task [s]

State = Literal["done", "failed", "timed out", "crashed"]


@dataclass(frozen=True)
class Ending:
    """How a task ended."""

    item: Any  # what it was given
    # `done`; `failed` where it raised; `timed out` where it took too long; `crashed` where its process died
    state: State
    value: Any = None  # what it returned; None unless it is done
    message: str = ""  # what went wrong; empty if it is done


class Engine(Protocol):
    """A function that runs a task for each item, and yields how each ends, in the order in which they do."""

    def __call__(self, task: Callable[[Any], Any], items: Iterable[Any], *, limit: float) -> Iterator[Ending]:
        """Run them; a task may take `limit` [s], and is ended then."""


def cores() -> int:
    """Return how many cores this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def run_tasks(
    task: Callable[[Any], Any], items: Iterable[Any], *, jobs: int, limit: float
) -> Iterator[Ending]:
    """Run a task for each item, and yield how each ends, in the order in which they do."""
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
        pipe: Where it is given items, and answers.
        deadline: When its task has to be done, on the monotonic clock [s].
    """

    def __init__(self, task: Callable[[Any], Any], item: Any, limit: float) -> None:
        context = multiprocessing.get_context("spawn")  # no threads and locks of this process come along
        self.pipe, other = context.Pipe()
        self._limit = limit
        self._process: BaseProcess = context.Process(target=_work, args=(task, other), daemon=True)
        with _unnamed_main(), _deaf():
            self._process.start()
        other.close()
        self.give(item)
        self.deadline += _START

    def give(self, item: Any) -> None:
        """Give it the next item."""
        self._item = item
        self.deadline = time.monotonic() + self._limit
        with suppress(OSError):  # it was killed since it answered: `ending` tells
            self.pipe.send(item)

    def ending(self, *, readable: bool) -> Ending | None:
        """Return how its task ended; None if it has not."""
        if readable:
            try:
                state, value = self.pipe.recv()
            except (EOFError, OSError):
                self._process.join()
                code = self._process.exitcode
                return Ending(self._item, "crashed", message=f"its process ended with code {code}")
            if state == "ready":
                self.deadline = time.monotonic() + self._limit
                return None
            if state == "done":
                return Ending(self._item, "done", value)
            return Ending(self._item, "failed", message=value)
        if time.monotonic() >= self.deadline:
            return Ending(self._item, "timed out", message=f"it took more than {self._limit:g} s")
        return None

    def stop(self) -> None:
        """End the process, whatever it does."""
        self._process.kill()
        self._process.join()
        self.pipe.close()


@contextmanager
def _unnamed_main() -> Iterator[None]:
    """Keep new processes from running the program of the user again, which may have no `__name__` guard.

    They import the module of their task and need nothing else.
    """
    main = sys.modules["__main__"]
    sys.modules["__main__"] = ModuleType("__main__")
    try:
        yield
    finally:
        sys.modules["__main__"] = main


@contextmanager
def _deaf() -> Iterator[None]:
    """Keep Ctrl-C from new processes while they start: those that begin inherit what is blocked here."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    resource_tracker.ensure_running()  # it begins with the first process otherwise, and lifts the block
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _work(task: Callable[[Any], Any], pipe: Connection) -> None:
    """Answer one item after another, until the other end is closed or the process that gives them is gone."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the process that gives the items
    threading.Thread(target=_end_with_parent, daemon=True).start()
    pipe.send(("ready", None))
    while True:
        try:
            item = pipe.recv()
        except EOFError:
            return
        try:
            answer = ("done", task(item))
        except Exception:  # noqa: BLE001 - whatever a task raises is its answer
            answer = ("failed", traceback.format_exc())
        pipe.send(answer)


def _end_with_parent() -> None:
    """End this process once the one that started it was killed: its task may write where a new run does."""
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)
