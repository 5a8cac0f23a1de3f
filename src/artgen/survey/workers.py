"""Tasks in processes of their own, with a time limit: none of them can end a run."""

import multiprocessing
import time
import traceback
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess
from typing import Any, Literal

State = Literal["done", "failed", "timed out", "crashed"]


@dataclass(frozen=True)
class Ending:
    """How a task ended.

    Attributes:
        item: What it was given.
        state: `done`; `failed` where it raised; `timed out` where it took too long; `crashed` where its
            process died.
        value: What it returned; None unless it is done.
        message: What went wrong; empty if it is done.
    """

    item: Any
    state: State
    value: Any = None
    message: str = ""


def run_tasks(
    task: Callable[[Any], Any], items: Iterable[Any], *, jobs: int, limit: float
) -> Iterator[Ending]:
    """Run a task for each item, and yield how each ends, in the order in which they do.

    Args:
        task: A function of a module, so that other processes can import it.
        items: What it is given, one after another.
        jobs: How many processes there are.
        limit: How long a task may take [s]; its process is ended then, and another one takes its place.
    """
    waiting = iter(list(items))
    workers: list[_Worker] = []
    try:
        while True:
            while len(workers) < jobs and (item := next(waiting, None)) is not None:
                workers.append(_Worker(task, item, limit))
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


class _Worker:
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
        self._process.start()
        other.close()
        self.give(item)

    def give(self, item: Any) -> None:
        """Give it the next item."""
        self._item = item
        self.deadline = time.monotonic() + self._limit
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


def _work(task: Callable[[Any], Any], pipe: Connection) -> None:
    """Answer one item after another, until the other end is closed."""
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
