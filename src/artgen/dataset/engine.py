"""Engines that run the tasks of a dataset: processes of this machine, or a Ray cluster."""

import logging
import os
import socket
import time
import traceback
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from functools import partial
from typing import Any, Literal, get_args

from artgen.dataset.workers import Ending, Engine, cores, run_tasks
from artgen.errors import ExportError, ParameterError
from artgen.version import __version__

EngineName = Literal["local", "ray"]

_ONE_THREAD = {"OMP_NUM_THREADS": "1"}  # each task has one core; OpenBLAS and MKL read it too
_AHEAD = 2  # tasks for each core of the cluster: one runs, and one waits so that no core does
_SILENCE = 5.0  # after which nobody listens at an address [s]
# what opens a connection of HTTP/2, which Ray speaks, and answers it: a frame with settings
_SETTINGS, _FRAME = 4, 9  # kind of the frame, and how long its head is [bytes]
_HELLO = b"PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n" + bytes([0, 0, 0, _SETTINGS, 0, 0, 0, 0, 0])
_LOOK = 1.0  # how often time limits are looked at [s]
_MEMORY = 128 * 2**20  # of the cluster that is started here: endings are small [bytes]


@contextmanager
def engine_of(name: EngineName, *, jobs: int | None, address: str | None) -> Iterator[Engine]:
    """Give the engine of that name."""
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
    if ray.is_initialized():  # by whoever calls, who will end it
        yield partial(_run, most=jobs)
        return
    found = address or os.environ.get("RAY_ADDRESS") or "local"
    options: dict[str, Any] = {}
    if found == "local":
        os.environ.setdefault("RAY_USAGE_STATS_ENABLED", "0")  # what is run here is nobody's business
        options = {
            "num_cpus": jobs or cores(),
            "include_dashboard": False,
            "object_store_memory": _MEMORY,
        }
    else:
        _call(found)
    try:
        ray.init(found, log_to_driver=False, logging_level=logging.ERROR, **options)
    except (Exception, SystemExit) as error:  # Ray exits where a cluster does not answer
        ray.shutdown()
        raise ExportError(_unreached(found, error)) from error
    try:
        yield partial(_run, most=None if found == "local" else jobs)
    finally:
        ray.shutdown()


def _call(address: str) -> None:
    """Refuse an address at which no head node listens; Ray itself would try for minutes."""
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
        raise ExportError(_unreached(address, "what listens there is no head node"))


def _unreached(address: str, error: BaseException | str) -> str:
    reason = " ".join(str(getattr(error, "strerror", None) or error).split())
    if address == "local":
        return f"Ray cannot be started here: {reason}"
    return (
        f"there is no Ray cluster at {address!r}: {reason}; give the HOST:PORT of its head node, with "
        "RAY_AUTH_MODE=token where it asks for a token, or no address to start one here"
    )


@dataclass
class _Flight:
    """A task that was given away."""

    item: Any  # what it was given
    # when it has to be done, on the monotonic clock [s]; None until it has begun
    deadline: float | None = None


def _run(
    task: Callable[[Any], Any], items: Iterable[Any], *, limit: float, most: int | None
) -> Iterator[Ending]:
    """Run a task for each item; see `workers.run_tasks`.

    A task tells when it begins, as it may wait long for a core of a cluster that others use too.
    """
    import ray

    work = ray.remote(
        num_cpus=1,
        max_retries=0,  # the run itself tries again, and counts
        num_returns="streaming",
        runtime_env={"env_vars": _ONE_THREAD},
    )(_work)
    waiting = iter(items)
    flights: dict[Any, _Flight] = {}
    try:
        while True:
            room = most or max(_AHEAD * int(ray.cluster_resources().get("CPU", 0)), 1)
            while len(flights) < room and (item := next(waiting, None)) is not None:
                flights[work.remote(task, item, __version__)] = _Flight(item)
            if not flights:
                return
            ready, _ = ray.wait(list(flights), num_returns=1, timeout=_LOOK)
            for stream in ready:
                flight = flights[stream]
                ending = _ending(flight.item, stream)
                if ending is None:
                    flight.deadline = time.monotonic() + limit
                else:
                    del flights[stream]
                    yield ending
            for stream, flight in list(flights.items()):
                if flight.deadline is not None and time.monotonic() >= flight.deadline:
                    ray.cancel(stream, force=True)
                    del flights[stream]
                    yield Ending(flight.item, "timed out", message=f"it took more than {limit:g} s")
    finally:
        for stream in flights:
            with suppress(Exception):  # the cluster may be gone
                ray.cancel(stream, force=True)


def _work(task: Callable[[Any], Any], item: Any, version: str) -> Iterator[tuple[str, Any]]:
    """Say that a task begins, and then how it ended."""
    if version != __version__:
        told = (
            f"{socket.gethostname()} has artgen {__version__}, and this is {version}: the same seeds may "
            "give other assets; install one version on all machines of the cluster"
        )
        yield "unlike", told
        return
    yield "begun", None
    try:
        answer = ("done", task(item))
    except Exception:  # noqa: BLE001 - whatever a task raises is its answer
        answer = ("failed", traceback.format_exc())
    yield answer


def _ending(item: Any, stream: Any) -> Ending | None:
    """Read what a task says next; None if it has only begun."""
    import ray
    from ray.exceptions import RayError, RayTaskError, RuntimeEnvSetupError

    try:
        state, value = ray.get(next(stream))
    except (RayTaskError, RuntimeEnvSetupError) as error:  # `_work` raises nothing: it was not found
        raise ExportError(
            f"a machine of the Ray cluster cannot run artgen {__version__}: {_last_line(error)}; install it "
            "on all of them"
        ) from error
    except RayError as error:  # its process was killed, its machine is gone, its memory was taken
        return Ending(item, "crashed", message=_first_line(error))
    if state == "begun":
        return None
    if state == "unlike":
        raise ExportError(value)
    if state == "done":
        return Ending(item, "done", value)
    return Ending(item, "failed", message=value)


def _first_line(error: Exception) -> str:
    return str(error).strip().partition("\n")[0]


def _last_line(error: Exception) -> str:
    return str(error).strip().rpartition("\n")[2]
