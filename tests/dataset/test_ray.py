"""Runs on a Ray cluster: the same endings and bytes as with local processes."""

import os
import shutil
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from dataclasses import replace
from http.server import BaseHTTPRequestHandler, HTTPServer
from pathlib import Path
from typing import Any

import pytest

from artgen.dataset import Plan, generate_many, workers
from artgen.dataset.places import LOCK_FILE
from artgen.errors import ExportError, ParameterError
from support.cases import long
from support.digests import digests

ray = pytest.importorskip("ray")

PLAN = Plan(("drawer", "cabinet"), 4, formats=("mjcf",), textures="none", certify=False)


@pytest.fixture(scope="module", autouse=True)
def _own_home(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Use another home directory, because Ray writes a token for its clusters there."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("HOME", str(tmp_path_factory.mktemp("home")))
        yield


def test_an_address_without_a_cluster_is_an_error_at_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    message = (
        r"there is no Ray cluster at '127\.0\.0\.1:9': Connection refused; give the HOST:PORT of its head"
    )
    start = time.monotonic()
    with pytest.raises(ExportError, match=message):
        generate_many(PLAN, tmp_path / "set", engine="ray", address="127.0.0.1:9")
    monkeypatch.setenv("RAY_ADDRESS", "127.0.0.1:9")
    with pytest.raises(ExportError, match=message):
        generate_many(PLAN, tmp_path / "set", engine="ray")
    assert time.monotonic() - start < 10.0
    assert not (tmp_path / "set").exists()


def test_an_address_of_another_service_is_an_error_at_once(tmp_path: Path) -> None:
    class Page(BaseHTTPRequestHandler):
        def log_message(self, *_: object) -> None:
            pass

    start = time.monotonic()
    with HTTPServer(("127.0.0.1", 0), Page) as server:
        threading.Thread(target=server.handle_request, daemon=True).start()
        address = f"127.0.0.1:{server.server_port}"
        with pytest.raises(
            ExportError, match=f"no Ray cluster at '{address}': another service listens there"
        ):
            generate_many(PLAN, tmp_path / "set", engine="ray", address=address)
    assert time.monotonic() - start < 10.0


def test_missing_ray_is_an_error(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "ray", None)
    with pytest.raises(ExportError, match=r"the engine ray needs Ray: pip install 'artgen\[ray\]'"):
        generate_many(PLAN, tmp_path / "set", engine="ray")


def test_unknown_engines_are_errors(tmp_path: Path) -> None:
    with pytest.raises(ParameterError, match="the engine is local or ray, not 'slurm'"):
        generate_many(PLAN, tmp_path / "set", engine="slurm")  # type: ignore[arg-type]
    with pytest.raises(
        ParameterError, match="the address 'head:6379' is for a Ray cluster: choose the engine"
    ):
        generate_many(PLAN, tmp_path / "set", address="head:6379")


@pytest.fixture(scope="module")
def run(bucket: Path) -> Iterator[Any]:
    """A cluster of two processes, started once: it takes seconds."""
    with workers.cluster("local", 2) as started:
        yield started


def behave(number: int) -> int:
    if number == 1:
        raise ValueError("one is refused")
    if number == 2:
        os.kill(os.getpid(), signal.SIGKILL)
    if number == 3:
        time.sleep(60.0)
    return 2 * number


@long
def test_every_item_has_an_ending(run: Any) -> None:
    endings = {each.item: each for each in run(behave, range(6), limit=2.0)}
    assert {item: each.state for item, each in endings.items()} == {
        **dict.fromkeys((0, 4, 5), "done"),
        1: "failed",
        2: "crashed",
        3: "timed out",
    }
    assert endings[5].value == 10
    assert "ValueError: one is refused" in endings[1].message
    assert "died" in endings[2].message
    assert endings[3].message == "it took more than 2 s"


def test_another_version_of_artgen_is_refused(run: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    real = workers.__version__
    monkeypatch.setattr(workers, "__version__", "0.0.1")
    with pytest.raises(ExportError, match=f"has artgen {real}, and this is 0.0.1: the same seeds may give"):
        list(run(behave, [0], limit=2.0))


def working() -> list[int]:
    """Return the processes of this cluster that work on a task."""
    program = shutil.which("ps") or pytest.skip("needs ps")
    listing = [program, "-eo", "pid=,ppid=,args="]
    output = subprocess.run(listing, check=True, capture_output=True, text=True).stdout
    rows = [line.split(maxsplit=2) for line in output.splitlines()]
    ours = {int(pid) for pid, parent, _ in rows if int(parent) == os.getpid()}
    return [
        int(pid) for pid, parent, name in rows if int(parent) in ours and name.startswith("ray::_remote_work")
    ]


def test_a_killed_worker_loses_nothing(run: Any, tmp_path: Path) -> None:
    assert generate_many(PLAN, tmp_path / "process", jobs=1).made == 4
    records, killed = [], []

    def kill_one_half_way(record: dict[str, Any]) -> None:
        records.append(record)
        while len(records) >= 2 and not killed:
            for process in working()[:1]:
                os.kill(process, signal.SIGKILL)
                killed.append(process)

    summary = generate_many(PLAN, tmp_path / "cluster", engine="ray", progress=kill_one_half_way)
    assert len(killed) == 1
    assert (summary.made, summary.failed) == (4, ())
    assert digests(tmp_path / "cluster") == digests(tmp_path / "process")
    assert ray.is_initialized()  # whoever started the cluster ends it


@long
def test_workers_write_to_a_url(run: Any, bucket: Path, tmp_path: Path) -> None:
    plan = replace(PLAN, count=2)
    generate_many(plan, f"bucket://{bucket}/set", engine="ray")
    generate_many(plan, tmp_path, jobs=1)
    expected = digests(tmp_path)
    del expected[LOCK_FILE]
    assert digests(bucket / "set") == expected


@long
def test_a_cluster_is_joined_and_left(run: Any, tmp_path: Path) -> None:
    """In a separate process, because the process of the tests has started the cluster."""
    address = ray.get_runtime_context().gcs_address
    workers._check_head_node(address)
    arguments = ["drawer", "-n", "1", "--format", "mjcf", "--textures", "none", "--no-certify"]
    done = subprocess.run(
        [
            *(sys.executable, "-m", "artgen", "generate", *arguments),
            *("--engine", "ray", "--address", address, "--out", str(tmp_path / "set")),
        ],
        check=False,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("made 1 assets in ")
    assert ray.cluster_resources()["CPU"] == 2.0
