"""Running a program that may print a lot, crash or hang, in a group of processes of its own."""

import os
import signal
import subprocess
import threading
import time
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import IO

_KEPT = 400_000  # bytes of output that are looked at
_RUNNING: "set[subprocess.Popen[bytes]]" = set()
_PATIENCE = 5.0  # how long to wait for output after the group was killed [s]


@dataclass(frozen=True)
class Finished:
    """How a program ended."""

    code: int  # its exit code, or minus the number of the signal that ended it
    output: str  # what it and its children printed to stdout and stderr, in order, the first part of it
    seconds: float  # how long it ran
    timed_out: bool  # whether it was killed because its time was over

    @property
    def ending(self) -> str:
        """How it ended, in words; empty if all was well."""
        if self.timed_out:
            return f"it was killed after {self.seconds:.0f} s"
        if self.code < 0:
            with suppress(ValueError):
                return f"it crashed: {signal.Signals(-self.code).name}"
        return f"it ended with exit code {self.code}" if self.code else ""


def run_process(
    command: Sequence[str | Path], directory: Path, environment: Mapping[str, str], seconds: float
) -> Finished:
    """Run a program to its end, or until its time is over; then nothing that it started is left."""
    start = time.monotonic()
    process = subprocess.Popen(  # noqa: S603 - the command is artgen's own
        list(command),
        cwd=directory,
        env=dict(environment),
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        start_new_session=True,
    )
    _RUNNING.add(process)
    assert process.stdout is not None
    kept = bytearray()
    reader = threading.Thread(target=_read, args=(process.stdout, kept), daemon=True)
    reader.start()
    timed_out = False
    try:
        process.wait(seconds)
    except subprocess.TimeoutExpired:
        timed_out = True
    finally:
        taken = time.monotonic() - start
        _kill_group(process)
        process.wait()
        _RUNNING.discard(process)
        reader.join(_PATIENCE)
    return Finished(process.returncode, bytes(kept).decode(errors="replace"), taken, timed_out)


def stop_running() -> None:
    """Kill all programs that `run_process` runs now, in any thread: nobody waits for them any more."""
    for process in tuple(_RUNNING):
        _kill_group(process)


def _read(stream: IO[bytes], kept: bytearray) -> None:
    """Read a stream to its end, so that its writer never waits, and keep the first part."""
    with stream:
        while chunk := stream.read1(65536):  # type: ignore[attr-defined]
            kept += chunk[: _KEPT - len(kept)]


def _kill_group(process: "subprocess.Popen[bytes]") -> None:
    """Kill a program with everything that it started; its group outlives it while a child does."""
    if hasattr(os, "killpg"):
        with suppress(ProcessLookupError, PermissionError):
            os.killpg(process.pid, signal.SIGKILL)
    else:
        process.kill()
