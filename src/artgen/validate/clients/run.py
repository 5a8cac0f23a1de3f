"""Running of clients on an export, each in its own process with a time limit."""

import json
import os
import signal
import subprocess
import tempfile
import threading
import time
from collections.abc import Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import IO, Any

from artgen.asset.report import Finding
from artgen.errors import ArtgenError
from artgen.validate.clients.client import Client
from artgen.validate.clients.exported import ClientExport, differences, read_exported
from artgen.validate.clients.install_location import how_to_get, interpreters
from artgen.validate.clients.outcome import Outcome, State, Tolerated, joined_lines, sorted_messages

_KEPT = 400_000  # most bytes of output that are kept
_RUNNING: "set[subprocess.Popen[bytes]]" = set()
_PATIENCE = 5.0  # time to wait for output after the group was killed [s]


@dataclass(frozen=True)
class Finished:
    """Result of a finished program."""

    code: int  # exit code, or minus the number of the signal that ended it
    output: str  # output of the program and its children to stdout and stderr, the first part
    seconds: float  # duration [s]
    timed_out: bool  # whether it was killed at the time limit

    @property
    def ending(self) -> str:
        """The exit in words; empty for success."""
        if self.timed_out:
            return f"it was killed after {self.seconds:.0f} s"
        if self.code < 0:
            with suppress(ValueError):
                return f"it crashed: {signal.Signals(-self.code).name}"
        return f"it ended with exit code {self.code}" if self.code else ""


def run_process(
    command: Sequence[str | Path], directory: Path, environment: Mapping[str, str], seconds: float
) -> Finished:
    """Run a program until it ends or reaches its time limit, and end all its children."""
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
    """Kill all programs that `run_process` runs in any thread."""
    for process in tuple(_RUNNING):
        _kill_group(process)


def _read(stream: IO[bytes], kept: bytearray) -> None:
    """Read a stream to its end, so that the writer never blocks, and keep the first part."""
    with stream:
        while chunk := stream.read1(65536):  # type: ignore[attr-defined]
            kept += chunk[: _KEPT - len(kept)]


def _kill_group(process: "subprocess.Popen[bytes]") -> None:
    """Kill a program with all its children; its group outlives it while a child runs."""
    if hasattr(os, "killpg"):
        with suppress(ProcessLookupError, PermissionError):
            os.killpg(process.pid, signal.SIGKILL)
    else:
        process.kill()


DRIVERS = Path(__file__).parent / "drivers"
"""Folder of the drivers."""

_ABSENT = 3  # exit code of a driver whose client is missing
_SHOWN = 5  # most messages of one client
# The folder of the drivers comes last, because `newton.py` there must not hide the package. The alarm ends a
# driver whose parent was killed first.
_START = (
    "import os, runpy, signal, sys; getattr(signal, 'alarm', int)(int(sys.argv[1])); "
    "sys.argv = sys.argv[2:]; sys.path[0] = os.path.dirname(sys.argv[0]); sys.path.append(sys.path.pop(0)); "
    "runpy.run_path(sys.argv[0], run_name='__main__')"
)
_GLANCE = 0.1  # interval between two checks for stopped programs [s]
_AFTER = 30.0  # time after the limit at which the alarm rings [s]


def ask_all(clients: Sequence[Client], exported: ClientExport) -> list[Outcome]:
    """Return the results of clients for an export, in their order; several clients run in parallel."""
    workers = max(1, (os.cpu_count() or 2) // 2)
    with ThreadPoolExecutor(workers) as pool:
        started = [pool.submit(ask, client, [exported]) for client in clients]
        try:
            return [each.result()[0] for each in started]
        except BaseException:  # such as Ctrl-C: leaving the pool would wait for clients, possibly minutes
            pool.shutdown(wait=False, cancel_futures=True)
            while not all(each.done() for each in started):  # a thread may be about to start its client
                stop_running()
                time.sleep(_GLANCE)
            raise


def ask(client: Client, exports: Sequence[ClientExport]) -> list[Outcome]:
    """Return the result of a client for each export.

    One process reads all exports, which pays for a slow start once. If its messages may belong to any of
    them, or answers are missing, halves are read again until the export is known.
    """
    outcomes: list[Outcome | None] = [
        None if each.is_read_by(client) else _nothing_to_read(client, each) for each in exports
    ]
    rest = [number for number, outcome in enumerate(outcomes) if outcome is None]
    for number, outcome in zip(rest, _ask(client, [exports[index] for index in rest]), strict=True):
        outcomes[number] = outcome
    return [outcome for outcome in outcomes if outcome is not None]


def absent(client: Client, *, severity: str = "note") -> Outcome:
    """Return the outcome of a missing client; it is a fault if the client was requested by name."""
    finding = Finding(client.name, "it is not installed", hint=how_to_get(client))
    if severity == "note":
        finding = replace(finding, severity="note")
    return Outcome(client.name, client.format, "", "absent", (finding,))


def _nothing_to_read(client: Client, exported: ClientExport) -> Outcome:
    if client.format not in exported.mains:
        message = f"it reads {client.format}, which the export does not have"
    else:
        message = f"it reads the layouts {', '.join(client.layouts)}, not {exported.layout}"
    finding = Finding(client.name, message, severity="note")
    return Outcome(client.name, client.format, "", "nothing to read", (finding,))


def _ask(client: Client, exports: Sequence[ClientExport]) -> list[Outcome]:
    if not exports:
        return []
    for program in interpreters(client):
        session = _session(client, program, exports)
        if session.finished.code == _ABSENT and not any(session.answers) and not session.messages:
            continue  # an existing client that exits this way prints the reason
        if len(exports) == 1:
            return [_outcome(client, exports[0], session)]
        if session.messages or session.finished.ending or None in session.answers:
            half = len(exports) // 2
            return _ask(client, exports[:half]) + _ask(client, exports[half:])
        shared = replace(
            session, finished=replace(session.finished, seconds=session.finished.seconds / len(exports))
        )
        return [
            _outcome(client, each, replace(shared, answers=[answer]))
            for each, answer in zip(exports, session.answers, strict=True)
        ]
    return [absent(client) for _ in exports]


@dataclass(frozen=True)
class _Session:
    """One process of a client."""

    finished: Finished  # how it ended
    # answer to each request; None if it is missing, a text if it cannot be read
    answers: Sequence[Mapping[str, Any] | str | None]
    messages: tuple[str, ...] = ()  # messages that are faults
    tolerated: tuple[Tolerated, ...] = field(default=())  # messages that are not faults


def _session(client: Client, program: Path, exports: Sequence[ClientExport]) -> _Session:
    """Let the driver of a client answer one request per export."""
    with tempfile.TemporaryDirectory(prefix="artgen_client_") as folder:
        place = Path(folder)
        work = place / "work"
        work.mkdir()
        paths = [
            (place / f"{number}.request.json", place / f"{number}.response.json")
            for number in range(len(exports))
        ]
        for (request, _), exported in zip(paths, exports, strict=True):
            request.write_text(json.dumps(exported.request(client)), encoding="utf-8")
        seconds = client.seconds * len(exports)
        command: list[str | Path] = [
            *(
                program,
                "-B",
                "-c",
                _START,
                str(int(seconds + _AFTER)),
                DRIVERS / f"{client.driver}.py",
            ),
            *(path for pair in paths for path in pair),
        ]
        try:
            finished = run_process(command, work, _environment(program), seconds)
        except OSError as error:
            finished = Finished(1, f"{program} cannot be started: {error.strerror}", 0.0, timed_out=False)
        answers = [_answer(response) for _, response in paths]
    messages, tolerated = sorted_messages(client, joined_lines(finished.output))
    return _Session(finished, answers, messages, tolerated)


def _environment(program: Path) -> dict[str, str]:
    """Return the environment variables of a driver, without variables for artgen's own packages."""
    result = {**os.environ, "PYTHONUNBUFFERED": "1", "PYTHONUTF8": "1"}
    for name in ("PYTHONHOME", "PYTHONWARNINGS", "PYTHONSTARTUP"):
        result.pop(name, None)
    if program not in interpreters(None):
        result.pop("PYTHONPATH", None)
    return result


def _answer(path: Path) -> Mapping[str, Any] | str | None:
    """Read a response: None if it is missing, the error if it is damaged."""
    try:
        data = json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        return None
    except (OSError, ValueError, RecursionError) as error:
        return f"its answer is damaged: {error}"
    return data if isinstance(data, dict) else f"its answer is damaged: it is a {type(data).__name__}"


def _outcome(client: Client, exported: ClientExport, session: _Session) -> Outcome:
    """Judge the answer of a client to one request."""
    answer, finished = session.answers[0], session.finished
    messages, tolerated = session.messages, session.tolerated
    findings: list[Finding] = []
    version, note = "", ""
    if finished.ending:
        last = f": {messages[-1]}" if messages else ""
        findings.append(Finding(client.name, f"{finished.ending}{last}"))
    elif answer is None:
        findings.append(Finding(client.name, "it gave no answer"))
    if isinstance(answer, str):
        findings.append(Finding(client.name, answer))
    elif answer is not None:
        try:
            version, note = str(answer.get("version", "")), str(answer.get("note", ""))
            said, more = sorted_messages(
                client, [" ".join(str(text).split()) for text in answer.get("said", ())]
            )
            messages, tolerated = (*messages, *said), (*tolerated, *more)
            findings += differences(client, exported, answer)
        except Exception as error:  # noqa: BLE001 - a damaged answer may hold anything
            findings.append(Finding(client.name, f"its answer is damaged: {type(error).__name__}: {error}"))
    if finished.ending:
        # the end of a traceback contains its start
        messages = tuple(text for text in messages[:-1] if not text.startswith("Traceback "))
    findings += _said(client, messages)
    state: State = "timed out" if finished.timed_out else "failed" if findings else "passed"
    return Outcome(
        client.name, client.format, version, state, tuple(findings), note, finished.seconds, tolerated
    )


def _said(client: Client, messages: Sequence[str]) -> Iterator[Finding]:
    distinct = list(dict.fromkeys(messages))
    for text in distinct[:_SHOWN]:
        yield Finding(client.name, f"it says: {text}")
    if len(distinct) > _SHOWN:
        more = len(distinct) - _SHOWN
        yield Finding(client.name, f"it says {more} more things", value=float(more))


_UNREAD = ("absent", "nothing to read")


def ask_clients(directory: str | Path, clients: Sequence[Client], *, by_name: bool) -> list[Outcome]:
    """Return the results of clients for an export, in their order."""
    try:
        exported = read_exported(directory)
    except ArtgenError as error:
        return [
            Outcome(client.name, client.format, "", "failed", (Finding(client.name, str(error)),))
            for client in clients
        ]
    readers = [client for client in clients if exported.is_read_by(client)]
    outcomes = ask_all(clients if by_name or not readers else readers, exported)
    none_read = all(outcome.state in _UNREAD for outcome in outcomes)
    return [_required(outcome) for outcome in outcomes] if by_name or none_read else outcomes


def _required(outcome: Outcome) -> Outcome:
    if outcome.state not in _UNREAD:
        return outcome
    findings = tuple(replace(finding, severity="fault") for finding in outcome.findings)
    return replace(outcome, findings=findings)
