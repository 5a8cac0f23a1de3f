"""Engines that run interruptible jobs: worker processes of this machine, or a Ray cluster."""

import logging
import multiprocessing
import os
import signal
import socket
import sys
import threading
import time
import traceback
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from contextlib import AbstractContextManager, contextmanager, nullcontext, suppress
from dataclasses import dataclass
from functools import partial
from multiprocessing import resource_tracker
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess
from types import ModuleType
from typing import Any, Literal, TypeVar, get_args

from artgen.errors import ExportError, ParameterError, needed
from artgen.version import __version__

_ONE_THREAD = dict.fromkeys(("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"), "1")
_START = 60.0  # time limit for the start of a process, added to that of its first task [s]

_AHEAD = 2  # tasks per core of the cluster: one runs, one waits
_SILENCE = 5.0  # time limit for the answer of a head node [s]
# a connection of HTTP/2, the protocol of Ray, begins with a settings frame from both sides
_SETTINGS, _FRAME = 4, 9  # kind of the frame, and length of its head [bytes]
_HELLO = b"PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n" + bytes([0, 0, 0, _SETTINGS, 0, 0, 0, 0, 0])
_POLL = 1.0  # interval between checks of time limits [s]
_MEMORY = 128 * 2**20  # object store of a cluster that is started here [bytes]

EngineName = Literal["local", "ray"]
Record = TypeVar("Record")
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


Engine = Callable[..., Iterator[Ending]]  # runs a task for each item, with a time limit, as `run_tasks`


def run_job(
    task: Callable[[Any], Any],
    items: Iterable[Any],
    add: Callable[[Ending], Record],
    engine: Engine,
    *,
    limit: float,
    tries: int = 1,
) -> Iterator[Record]:
    """Run a task for each item in worker processes; record each ending at once, and yield the records.

    A task that ends its process, or takes longer than `limit` [s], runs up to `tries` times.
    """
    left, tried = items, Counter[Any]()
    while left:
        again = []
        for ending in engine(task, left, limit=limit):
            tried[ending.item] += 1
            if ending.state in ("crashed", "timed out") and tried[ending.item] < tries:
                again.append(ending.item)
            else:
                yield add(ending)
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
    for name, number in _ONE_THREAD.items():
        os.environ.setdefault(name, number)
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
    """A process that runs a task on one item after another."""

    def __init__(self, task: Callable[[Any], Any], item: Any, limit: float) -> None:
        context = multiprocessing.get_context("spawn")  # copies no threads and locks
        self.pipe, other = context.Pipe()  # for items and answers
        self._limit = limit
        self._process: BaseProcess = context.Process(target=_work, args=(task, other), daemon=True)
        with _starting():
            self._process.start()
        other.close()
        self.give(item)
        self.deadline += _START

    def give(self, item: Any) -> None:
        """Send the next item."""
        self._item = item
        self.deadline = time.monotonic() + self._limit  # end of the time limit of its task [s]
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
def _starting() -> Iterator[None]:
    """Let new processes inherit a blocked Ctrl-C, and hide the main program, which each would run again."""
    main, before = sys.modules["__main__"], None
    if hasattr(signal, "pthread_sigmask"):
        resource_tracker.ensure_running()  # a later process would unblock it
        before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    sys.modules["__main__"] = ModuleType("__main__")
    try:
        yield
    finally:
        sys.modules["__main__"] = main
        if before is not None:
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


def engine_of(name: EngineName, *, jobs: int | None, address: str | None) -> AbstractContextManager[Engine]:
    """Return a context that gives the engine of a name."""
    if name not in get_args(EngineName):
        raise ParameterError(f"the engine is local or ray, not {name!r}")
    if name == "local":
        if address is not None:
            raise ParameterError(
                f"the address {address!r} is for a Ray cluster: choose the engine ray, or give no address"
            )
        return nullcontext(partial(run_tasks, jobs=jobs or cores()))
    return cluster(address, jobs)


@contextmanager
def cluster(address: str | None, jobs: int | None) -> Iterator[Engine]:
    """Join a Ray cluster, or start one on this machine that ends with the run."""
    with needed("the engine ray needs Ray: pip install 'artgen[ray]'"):
        import ray
    if ray.is_initialized():  # by the caller
        yield partial(_run, most=jobs)
        return
    found = address or os.environ.get("RAY_ADDRESS") or "local"
    options: dict[str, Any] = {}
    if found == "local":
        os.environ.setdefault("RAY_USAGE_STATS_ENABLED", "0")
        options = {"num_cpus": jobs or cores(), "include_dashboard": False, "object_store_memory": _MEMORY}
    else:
        _check_head_node(found)
    try:
        ray.init(found, log_to_driver=False, logging_level=logging.ERROR, **options)
    except (Exception, SystemExit) as error:  # Ray exits if a cluster does not answer
        ray.shutdown()
        raise ExportError(_cannot_join(found, error)) from error
    try:
        yield partial(_run, most=None if found == "local" else jobs)
    finally:
        ray.shutdown()


def _check_head_node(address: str) -> None:
    """Raise ExportError for an address without a head node; Ray would try for minutes."""
    host, _, port = address.rpartition("/")[2].rpartition(":")
    if not host or not port.isdigit():
        return
    try:
        with socket.create_connection((host, int(port)), timeout=_SILENCE) as connection:
            if "RAY_USE_TLS" in os.environ:
                return
            connection.sendall(_HELLO)
            answer = connection.recv(_FRAME)
    except OSError as error:
        raise ExportError(_cannot_join(address, error)) from error
    if len(answer) < _FRAME or answer[3] != _SETTINGS:
        raise ExportError(_cannot_join(address, "another service listens there"))


def _cannot_join(address: str, error: BaseException | str) -> str:
    """Return the message for a cluster that cannot be used."""
    reason = " ".join(str(getattr(error, "strerror", None) or error).split())
    if address == "local":
        return f"Ray cannot be started here: {reason}"
    return (
        f"there is no Ray cluster at {address!r}: {reason}; give the HOST:PORT of its head node, with "
        "RAY_AUTH_MODE=token if it requires a token, or give no address to start a cluster here"
    )


def _run(
    task: Callable[[Any], Any], items: Iterable[Any], *, limit: float, most: int | None
) -> Iterator[Ending]:
    """Run a task for each item on a Ray cluster, and yield the endings as they come."""
    # the time limit of a task starts when it begins: it may wait long for a core of a shared cluster
    import ray

    work = ray.remote(
        num_cpus=1,
        max_retries=0,  # `run_job` tries again
        num_returns="streaming",
        runtime_env={"env_vars": _ONE_THREAD},
    )(_remote_work)
    waiting = iter(items)
    given: dict[Any, Any] = {}  # items of the tasks in the cluster, by stream of answers
    deadlines: dict[Any, float] = {}  # start of running tasks on the monotonic clock [s]
    try:
        while True:
            room = most or max(_AHEAD * int(ray.cluster_resources().get("CPU", 0)), 1)
            while len(given) < room and (item := next(waiting, None)) is not None:
                given[work.remote(task, item, __version__)] = item
            if not given:
                return
            ready, _ = ray.wait(list(given), num_returns=1, timeout=_POLL)
            for stream in ready:
                ending = _ending(given[stream], stream)
                if ending is None:
                    deadlines[stream] = time.monotonic() + limit
                else:
                    deadlines.pop(stream, None)
                    del given[stream]
                    yield ending
            for stream in [each for each, end in deadlines.items() if time.monotonic() >= end]:
                ray.cancel(stream, force=True)
                del deadlines[stream]
                yield Ending(given.pop(stream), "timed out", message=f"it took more than {limit:g} s")
    finally:
        for stream in given:
            with suppress(Exception):  # the cluster may be gone
                ray.cancel(stream, force=True)


def _remote_work(task: Callable[[Any], Any], item: Any, version: str) -> Iterator[Any]:
    """Yield None at the start of a task, then its answer; an error message for different versions."""
    if version != __version__:
        yield (
            f"{socket.gethostname()} has artgen {__version__}, and this is {version}: the same seeds may "
            "give other assets; install one version on all machines of the cluster"
        )
        return
    yield None
    yield attempt(task, item)


def _ending(item: Any, stream: Any) -> Ending | None:
    """Read the next answer of a task; None if it has only begun."""
    import ray
    from ray.exceptions import RayError, RayTaskError, RuntimeEnvSetupError

    try:
        answer = ray.get(next(stream))
    except (RayTaskError, RuntimeEnvSetupError) as error:  # `_remote_work` raises nothing: it was not found
        reason = str(error).strip().rpartition("\n")[2]
        raise ExportError(
            f"a machine of the Ray cluster cannot run artgen {__version__}: {reason}; install it on all of "
            "them"
        ) from error
    except RayError as error:  # its process or its machine died, or its memory was exhausted
        return Ending(item, "crashed", message=str(error).strip().partition("\n")[0])
    if isinstance(answer, str):
        raise ExportError(answer)
    return None if answer is None else Ending(item, *answer)
