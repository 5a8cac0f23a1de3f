"""Running of clients on an export, each in its own process with a time limit, and their outcomes."""

import json
import os
import re
import signal
import subprocess
import tempfile
import threading
import time
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import IO, Any, ClassVar, Literal

from artgen.asset.record import Record
from artgen.asset.report import Finding, Report
from artgen.errors import ArtgenError
from artgen.validate.clients.exported import ClientExport, differences, read_exported
from artgen.validate.clients.install import OWN_PYTHON, how_to_get, interpreters
from artgen.validate.clients.registry import MACHINE, Client

DRIVERS = Path(__file__).parent / "drivers"
"""Folder of the drivers."""

_MOST_OUTPUT = 400_000  # most bytes of output that are read
_RUNNING: "set[subprocess.Popen[bytes]]" = set()
_PATIENCE = 5.0  # time to wait for output after the group was killed [s]
_GLANCE = 0.1  # interval between two checks for stopped programs [s]
_AFTER = 30.0  # time after the limit at which the alarm rings [s]
_ABSENT = 3  # exit code of a driver whose client is missing
_SHOWN = 5  # most messages of one client
# The folder of the drivers comes last, because `newton.py` there must not hide the package. The alarm ends a
# driver whose parent was killed first.
_START = (
    "import os, runpy, signal, sys; getattr(signal, 'alarm', int)(int(sys.argv[1])); "
    "sys.argv = sys.argv[2:]; sys.path[0] = os.path.dirname(sys.argv[0]); sys.path.append(sys.path.pop(0)); "
    "runpy.run_path(sys.argv[0], run_name='__main__')"
)

State = Literal["passed", "failed", "timed out", "absent", "nothing to read"]
_UNREAD = ("absent", "nothing to read")


@dataclass(frozen=True)
class Tolerated(Record):
    """Messages of a client that are not faults."""

    message: str  # first of these messages
    count: int  # number of these messages
    reason: str  # reason why no asset can avoid it


@dataclass(frozen=True)
class Outcome(Record):
    """The result of a client for an export."""

    FIRST: ClassVar = ("client", "format", "version", "state", "note", "seconds")

    client: str  # name of the client
    format: str  # format that it reads
    version: str  # the client's version; empty if it is absent
    state: State  # only `passed` is a pass
    findings: tuple[Finding, ...] = ()  # faults, or how to get an absent client
    note: str = ""  # short note about the client or its answer
    seconds: float = 0.0  # duration [s]
    tolerated: tuple[Tolerated, ...] = ()  # messages that are not faults

    @property
    def fault(self) -> bool:
        """Whether there is a fault."""
        return any(finding.severity == "fault" for finding in self.findings)

    @property
    def message(self) -> str:
        """The first fault, or the first note."""
        faults = [finding for finding in self.findings if finding.severity == "fault"]
        return next((str(finding) for finding in (*faults, *self.findings)), self.note)

    def to_data(self) -> dict[str, Any]:
        """Return the outcome as JSON data."""
        return super().to_data() | {"seconds": round(self.seconds, 1)}


@dataclass(frozen=True)
class ClientReport(Report):
    """Results of all checks and several clients for one asset."""

    outcomes: tuple[Outcome, ...] = ()  # one for each client

    @property
    def passed(self) -> bool:
        """Whether neither a check nor a client found a fault."""
        return super().passed and not any(outcome.fault for outcome in self.outcomes)

    def __str__(self) -> str:
        """Return one line for each check and client, and one line for each finding."""
        lines = [super().__str__()]
        for outcome in self.outcomes:
            name = f"{outcome.client} {outcome.version}".strip()
            lines.append(f"{name}: {outcome.state}" + (f" ({outcome.note})" if outcome.note else ""))
            lines += [f"  {finding.severity}: {finding}" for finding in outcome.findings]
        return "\n".join(lines)

    def to_data(self) -> dict[str, Any]:
        """Return the report as JSON data."""
        return {**super().to_data(), "clients": [outcome.to_data() for outcome in self.outcomes]}


_COLORS = re.compile(r"\x1b(\[[0-?]*[ -/]*[@-~]|\][^\x07\x1b]*(\x07|\x1b\\)|[@-Z\\^_])")
_SERIOUS = re.compile(
    r"\b(error|warning|failed|failure|fatal|invalid|cannot|could not|unable to|not found)\b(?!\()",
    re.IGNORECASE,
)


def joined_lines(output: str) -> list[str]:
    """Return the messages of an output; an indented line belongs to the message before it."""
    result: list[str] = []
    for line in _COLORS.sub("", output).replace("\r", "\n").splitlines():
        if line[:1].isspace() and line.strip() and result:
            result[-1] += "\n" + line.strip()
        elif line.strip():
            result.append(line.strip())
    return result


def sorted_messages(client: Client, messages: Sequence[str]) -> tuple[tuple[str, ...], tuple[Tolerated, ...]]:
    """Return the messages that are faults, and those that no asset can avoid.

    A pattern has to match the whole message or its beginning; the rest, such as a line of source code, must
    not mention an error.
    """
    faults: list[str] = []
    tolerated: dict[str, Tolerated] = {}
    for text in messages:
        line = " ".join(text.split())
        for pattern, reason in (*client.unavoidable, *MACHINE.items()):
            found = re.match(rf"(?:{pattern})(?P<rest>(?:\s[\s\S]*)?)\Z", text)
            if found and not _SERIOUS.search(found["rest"]):
                known = tolerated.get(pattern, Tolerated(line, 0, reason))
                tolerated[pattern] = replace(known, count=known.count + 1)
                break
        else:
            faults.append(line)
    return tuple(faults), tuple(tolerated.values())


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
    output = bytearray()
    reader = threading.Thread(target=_read, args=(process.stdout, output), daemon=True)
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
    return Finished(process.returncode, bytes(output).decode(errors="replace"), taken, timed_out)


def _read(stream: IO[bytes], output: bytearray) -> None:
    """Read a stream to its end, so that the writer never blocks, and store the first part."""
    with stream:
        while chunk := stream.read1(65536):  # type: ignore[attr-defined]
            output += chunk[: _MOST_OUTPUT - len(output)]


def stop_running() -> None:
    """Kill all programs that `run_process` runs in any thread."""
    for process in tuple(_RUNNING):
        _kill_group(process)


def _kill_group(process: "subprocess.Popen[bytes]") -> None:
    """Kill a program with all its children; its group outlives it while a child runs."""
    if hasattr(os, "killpg"):
        with suppress(ProcessLookupError, PermissionError):
            os.killpg(process.pid, signal.SIGKILL)
    else:
        process.kill()


def run_clients(directory: str | Path, clients: Sequence[Client], *, by_name: bool) -> list[Outcome]:
    """Return the results of clients for an export, in their order.

    An absent client is a fault if the clients were requested by name, or if no client read the export.
    """
    try:
        exported = read_exported(directory)
    except ArtgenError as error:
        return [_unread(client, "failed", str(error)) for client in clients]
    readers = [client for client in clients if exported.is_read_by(client)]
    outcomes = run_all(clients if by_name or not readers else readers, exported)
    none_read = all(outcome.state in _UNREAD for outcome in outcomes)
    return [_required(outcome) for outcome in outcomes] if by_name or none_read else outcomes


def _required(outcome: Outcome) -> Outcome:
    if outcome.state not in _UNREAD:
        return outcome
    findings = tuple(replace(finding, severity="fault") for finding in outcome.findings)
    return replace(outcome, findings=findings)


def _unread(client: Client, state: State, message: str, **options: Any) -> Outcome:
    return Outcome(client.name, client.format, "", state, (Finding(client.name, message, **options),))


def run_all(clients: Sequence[Client], exported: ClientExport) -> list[Outcome]:
    """Return the results of clients for an export, in their order; several clients run in parallel."""
    workers = max(1, (os.cpu_count() or 2) // 2)
    with ThreadPoolExecutor(workers) as pool:
        started = [pool.submit(run_client, client, [exported]) for client in clients]
        try:
            return [each.result()[0] for each in started]
        except BaseException:  # such as Ctrl-C: leaving the pool would wait for clients, possibly minutes
            pool.shutdown(wait=False, cancel_futures=True)
            while not all(each.done() for each in started):  # a thread may be about to start its client
                stop_running()
                time.sleep(_GLANCE)
            raise


def run_client(client: Client, exports: Sequence[ClientExport]) -> list[Outcome]:
    """Return the result of a client for each export.

    One process reads all exports, so that a slow start happens once. If its messages may belong to any of
    them, or answers are missing, halves are read again until the export is known.
    """
    readable = [each for each in exports if each.is_read_by(client)]
    read = iter(_run_on(client, readable))
    return [next(read) if each.is_read_by(client) else _nothing_to_read(client, each) for each in exports]


def _nothing_to_read(client: Client, exported: ClientExport) -> Outcome:
    message = f"it reads the layouts {', '.join(client.layouts)}, not {exported.layout}"
    if client.format not in exported.mains:
        message = f"it reads {client.format}, which the export does not have"
    return _unread(client, "nothing to read", message, severity="note")


def _run_on(client: Client, exports: Sequence[ClientExport]) -> list[Outcome]:
    for program in interpreters(client) if exports else ():
        session = _session(client, program, exports)
        ending = session.finished.ending
        if session.finished.code == _ABSENT and not any(session.answers) and not session.faults:
            continue  # an existing client that exits this way prints the reason
        if len(exports) > 1 and (session.faults or ending or None in session.answers):
            half = len(exports) // 2
            return _run_on(client, exports[:half]) + _run_on(client, exports[half:])
        pairs = zip(exports, session.answers, strict=True)
        return [_outcome(client, exported, session, answer) for exported, answer in pairs]
    absent = _unread(client, "absent", "it is not installed", hint=how_to_get(client), severity="note")
    return [absent for _ in exports]


@dataclass(frozen=True)
class _Session:
    """One process of a client."""

    finished: Finished
    answers: Sequence[bytes | None]  # response to each request; None if it is missing
    faults: tuple[str, ...]  # messages that are faults
    tolerated: tuple[Tolerated, ...]  # messages that are not faults


def _session(client: Client, program: Path, exports: Sequence[ClientExport]) -> _Session:
    """Let the driver of a client answer one request per export."""
    environment = {**os.environ, "PYTHONUNBUFFERED": "1", "PYTHONUTF8": "1"}
    for variable in ("PYTHONHOME", "PYTHONWARNINGS", "PYTHONSTARTUP"):
        environment.pop(variable, None)
    if program != OWN_PYTHON:
        environment.pop("PYTHONPATH", None)  # it leads to artgen's own packages
    with tempfile.TemporaryDirectory(prefix="artgen_client_") as name:
        folder = Path(name)
        work = folder / "work"
        work.mkdir()
        files: list[Path] = []
        for number, exported in enumerate(exports):
            files += [folder / f"{number}.request.json", folder / f"{number}.response.json"]
            files[-2].write_text(json.dumps(exported.request(client)), encoding="utf-8")
        seconds = client.seconds * len(exports)
        alarm, driver = str(int(seconds + _AFTER)), DRIVERS / f"{client.driver}.py"
        command: list[str | Path] = [program, "-B", "-c", _START, alarm, driver, *files]
        try:
            finished = run_process(command, work, environment, seconds)
        except OSError as error:
            finished = Finished(1, f"{program} cannot be started: {error.strerror}", 0.0, timed_out=False)
        answers = [response.read_bytes() if response.exists() else None for response in files[1::2]]
    return _Session(finished, answers, *sorted_messages(client, joined_lines(finished.output)))


def _outcome(client: Client, exported: ClientExport, session: _Session, answer: bytes | None) -> Outcome:
    """Return the outcome of a client's answer to one request."""
    finished, messages, tolerated = session.finished, session.faults, session.tolerated
    findings: list[Finding] = []
    version, note, fault = "", "", partial(Finding, client.name)
    if finished.ending:
        findings.append(fault(": ".join((finished.ending, *messages[-1:]))))
    elif answer is None:
        findings.append(fault("it gave no answer"))
    if answer is not None:
        try:
            data = json.loads(answer)
            if not isinstance(data, dict):
                raise TypeError(f"it is a {type(data).__name__}")  # noqa: TRY301 - one message for all damage
            version, note = str(data.get("version", "")), str(data.get("note", ""))
            said = [" ".join(str(text).split()) for text in data.get("said", ())]
            faults, more = sorted_messages(client, said)
            messages, tolerated = (*messages, *faults), (*tolerated, *more)
            findings += differences(client, exported, data)
        except Exception as error:  # noqa: BLE001 - a damaged answer may hold anything
            findings.append(fault(f"its answer is damaged: {type(error).__name__}: {error}"))
    if finished.ending:
        # the end of a traceback contains its start
        messages = tuple(text for text in messages[:-1] if not text.startswith("Traceback "))
    distinct = list(dict.fromkeys(messages))
    findings += [fault(f"it reports: {text}") for text in distinct[:_SHOWN]]
    if (rest := len(distinct) - _SHOWN) > 0:
        findings.append(fault(f"it reports {rest} more messages", value=float(rest)))
    state: State = "timed out" if finished.timed_out else "failed" if findings else "passed"
    seconds = finished.seconds / len(session.answers)
    return Outcome(client.name, client.format, version, state, tuple(findings), note, seconds, tolerated)
