"""Engines for the tasks of a job: processes of this machine, or a Ray cluster."""

import logging
import os
import socket
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from functools import partial
from typing import Any, Literal, get_args

from artgen.dataset.workers import Ending, Engine, attempt, cores, run_tasks
from artgen.errors import ExportError, ParameterError
from artgen.version import __version__

EngineName = Literal["local", "ray"]

_ONE_THREAD = {"OMP_NUM_THREADS": "1"}  # one core per task; OpenBLAS and MKL obey this variable as well
_AHEAD = 2  # tasks per core of the cluster: one runs, one waits
_SILENCE = 5.0  # time limit for the answer of a head node [s]
# a connection of HTTP/2, the protocol of Ray, begins with a settings frame from both sides
_SETTINGS, _FRAME = 4, 9  # kind of the frame, and length of its head [bytes]
_HELLO = b"PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n" + bytes([0, 0, 0, _SETTINGS, 0, 0, 0, 0, 0])
_LOOK = 1.0  # interval between checks of time limits [s]
_MEMORY = 128 * 2**20  # object store of a cluster that is started here [bytes]


@contextmanager
def engine_of(name: EngineName, *, jobs: int | None, address: str | None) -> Iterator[Engine]:
    """Yield the engine of a name."""
    if name not in get_args(EngineName):
        raise ParameterError(f"the engine is local or ray, not {name!r}")
    if name == "local":
        if address is not None:
            raise ParameterError(f"the address {address!r} is of a Ray cluster: choose the engine ray")
        yield partial(run_tasks, jobs=jobs or cores())
        return
    with cluster(address, jobs) as run:
        yield run


@contextmanager
def cluster(address: str | None, jobs: int | None) -> Iterator[Engine]:
    """Join a Ray cluster, or start one on this machine that ends with the run."""
    try:
        import ray
    except ImportError as error:
        raise ExportError("the engine ray needs Ray: pip install 'artgen[ray]'") from error
    if ray.is_initialized():  # by the caller
        yield partial(_run, most=jobs)
        return
    found = address or os.environ.get("RAY_ADDRESS") or "local"
    options: dict[str, Any] = {}
    if found == "local":
        os.environ.setdefault("RAY_USAGE_STATS_ENABLED", "0")
        options = {"num_cpus": jobs or cores(), "include_dashboard": False, "object_store_memory": _MEMORY}
    else:
        _call(found)
    try:
        ray.init(found, log_to_driver=False, logging_level=logging.ERROR, **options)
    except (Exception, SystemExit) as error:  # Ray exits if a cluster does not answer
        ray.shutdown()
        raise ExportError(_unreached(found, error)) from error
    try:
        yield partial(_run, most=None if found == "local" else jobs)
    finally:
        ray.shutdown()


def _call(address: str) -> None:
    """Raise ExportError for an address without a head node; Ray would try for minutes."""
    host, _, port = address.rpartition("/")[2].rpartition(":")
    if not host or not port.isdigit():
        return
    try:
        with socket.create_connection((host, int(port)), timeout=_SILENCE) as line:
            if "RAY_USE_TLS" in os.environ:
                return
            line.sendall(_HELLO)
            answer = line.recv(_FRAME)
    except OSError as error:
        raise ExportError(_unreached(address, error)) from error
    if len(answer) < _FRAME or answer[3] != _SETTINGS:
        raise ExportError(_unreached(address, "another service listens there"))


def _unreached(address: str, error: BaseException | str) -> str:
    """Return the message for a cluster that cannot be used."""
    reason = " ".join(str(getattr(error, "strerror", None) or error).split())
    if address == "local":
        return f"Ray cannot be started here: {reason}"
    return (
        f"there is no Ray cluster at {address!r}: {reason}; give the HOST:PORT of its head node, with "
        "RAY_AUTH_MODE=token where it asks for a token, or no address to start one here"
    )


def _run(
    task: Callable[[Any], Any], items: Iterable[Any], *, limit: float, most: int | None
) -> Iterator[Ending]:
    """Run a task for each item on a Ray cluster, and yield the endings as they come.

    The time limit of a task starts when it begins, because it may wait long for a core of a shared cluster.
    """
    import ray

    work = ray.remote(
        num_cpus=1,
        max_retries=0,  # `run_job` tries again
        num_returns="streaming",
        runtime_env={"env_vars": _ONE_THREAD},
    )(_work)
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
            ready, _ = ray.wait(list(given), num_returns=1, timeout=_LOOK)
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


def _work(task: Callable[[Any], Any], item: Any, version: str) -> Iterator[Any]:
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
    except (RayTaskError, RuntimeEnvSetupError) as error:  # `_work` raises nothing: it was not found
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
