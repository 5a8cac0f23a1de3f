"""The studio in the browser: a viser server; one thread handles the latest request of each kind."""

import contextlib
import errno
import io
import math
import socket
import threading
import time
import traceback
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from artgen.dataset.workers import Ending, Worker
from artgen.errors import ArtgenError, ParameterError, RenderError, needed
from artgen.studio.panel import Panel, Requests
from artgen.studio.session import ProofTask, Session, message_of, prove
from artgen.studio.stage import Viewport

HOST, PORT = "127.0.0.1", 8080
OUT = Path("out")

_POLL = 0.1  # interval between checks for changed files, finished proofs and replaced objects [s]
_PAUSE = 0.5  # time without changes before a proof begins [s]
_PORTS = 65535
_LIMIT = 600.0  # time limit of a proof [s]


class Prover:
    """Certifies one asset at a time in its own process, which starts on first use."""

    def __init__(self) -> None:
        self._worker: Worker | None = None
        self._busy = False

    def start(self, task: ProofTask) -> None:
        """Start a proof and cancel a running one."""
        self.cancel()
        if self._worker is None:
            self._worker = Worker(prove, task, _LIMIT)
        else:
            self._worker.give(task)
        self._busy = True

    def cancel(self) -> None:
        """Cancel the running proof, if any."""
        if self._busy:
            self.close()

    def poll(self) -> Ending | None:
        """Return the result of the proof; None while it runs, or without a proof."""
        if self._worker is None or not self._busy:
            return None
        ending = self._worker.ending(readable=self._worker.pipe.poll())
        self._busy = ending is None
        if ending is not None and ending.state not in ("done", "failed"):
            self.close()
        return ending

    def close(self) -> None:
        """End the process."""
        if self._worker is not None:
            self._worker.stop()
        self._worker = None
        self._busy = False


class Studio:
    """A session served to browsers.

    One thread handles the requests of browsers, evaluates, and sends the changes. Errors become messages in
    the panel.

    Attributes:
        session: The session; only the studio's thread uses it.
        requests: Requests for this thread, such as `requests.add("set width", lambda: session.set(...))`.
        stage: The scene.
        panel: The controls.
        host: Address of the server.
        port: Port of the server.
        out: Folder below which browsers can export.
    """

    def __init__(
        self,
        session: Session,
        host: str = HOST,
        port: int = PORT,
        *,
        out: Path = OUT,
        rich_light: bool = True,
    ) -> None:
        """Start the server."""
        self.session = session
        self.host = host
        self.out = out.resolve()
        self._server, self._token = _server(host, port)
        self.port: int = self._server.get_port()
        self.requests = Requests()
        self._running = True
        self._proof_at = math.inf  # start of the next proof, in the time of `time.monotonic` [s]
        self._prover = Prover()
        self.stage = Viewport(self._server, rich_light=rich_light)
        self.panel = Panel(self._server, session, self.stage, self.requests, self.out)
        self._thread = threading.Thread(target=self._run, name="artgen studio", daemon=True)
        self._thread.start()

    @property
    def address(self) -> str:
        """The address for browsers, with the token of the session."""
        host = "127.0.0.1" if self.host in ("0.0.0.0", "::") else self.host  # noqa: S104 - a test, no binding
        host = f"[{host}]" if ":" in host else host
        return f"http://{host}:{self.port}/?token={self._token}"

    def close(self) -> None:
        """End the server, its thread and its process."""
        self._running = False
        self._thread.join(timeout=10.0)
        self._prover.close()
        _stop(self._server)

    # the studio's thread

    def _run(self) -> None:
        while self._running:
            requests = self.requests.take(0.0 if self.session.stale else _POLL)
            with self._reporting(), self._server.atomic():
                for request in requests:
                    with self._reporting():
                        request()
                if self.session.stale:
                    self._evaluate()
            with self._reporting():
                if self.session.saved():
                    if not self.session.reload():
                        self._prover.cancel()
                    self.panel.show_error()
                self._check_proof(idle=not requests)
                self.stage.remove_replaced()

    @contextlib.contextmanager
    def _reporting(self) -> Iterator[None]:
        """Show errors in the panel instead of ending the thread."""
        try:
            yield
        except Exception as error:  # noqa: BLE001 - no error may end the server
            self.session.error = message_of(error)
            if not isinstance(error, ArtgenError):
                place = traceback.extract_tb(error.__traceback__)[-1]
                self.session.error += f"\n  at {place.filename}:{place.lineno}"
            self.panel.show_error()

    def _evaluate(self) -> None:
        self._proof_at = time.monotonic() + _PAUSE
        self._prover.cancel()
        if self.session.evaluate():
            self.stage.show(self.session.asset, self.session.q)
            self.panel.show()
            self.panel.show_proof("the proof starts after a pause without changes ...")
        self.panel.show_error()

    def _check_proof(self, *, idle: bool) -> None:
        """Show the result of a proof, and start one after a while without changes."""
        ending = self._prover.poll()
        if ending is not None and ending.state == "done":
            self.session.certified(ending.value)
            self.panel.show_proof()
            self.panel.show_error()
        elif ending is not None:
            self.panel.show_proof(f"no certificate: {ending.reason}")
        task = self.session.task()
        idle = idle and not self.session.stale and time.monotonic() > self._proof_at
        if idle and task is not None:
            self._proof_at = math.inf
            self._prover.start(task)
            self.panel.show_proof("the proof is running ...")


def _server(host: str, port: int) -> tuple[Any, str]:
    """Return a guarded viser server at exactly this port, and the token of its guard."""
    text = 'the studio needs viser, which cannot be loaded ({error}): pip install "artgen[studio]"'
    with needed(text, RenderError):
        import viser

        from artgen.studio.guard import Guard
    if not 0 <= port <= _PORTS:
        raise ParameterError(
            f"--port {port} is not allowed: it must be in 0..{_PORTS}; 0 selects a free port"
        )
    _check_free(host, port)
    guard = Guard(host)
    with contextlib.redirect_stdout(io.StringIO()), guard.installing():
        server = viser.ViserServer(host=host, port=port, verbose=False)
    if not guard.installed:  # viser does not start its server as the guard expects
        _stop(server)
        raise RenderError(
            f"viser {viser.__version__} cannot be guarded against other web pages: install another version, "
            'such as pip install "viser==1.1.1"'
        )
    if port and server.get_port() != port:  # taken in the meantime
        _stop(server)
        raise ParameterError(_taken(host, port))
    return server, guard.token


def _stop(server: Any) -> None:
    with contextlib.redirect_stdout(io.StringIO()):  # viser prints a message
        server.stop()


def _check_free(host: str, port: int) -> None:
    try:
        family, kind, protocol, _, place = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)[0]
        with socket.socket(family, kind, protocol) as probe:
            probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)  # as the server will
            probe.bind(place)
    except OSError as error:
        if isinstance(error, PermissionError):
            raise ParameterError(
                f"--port {port} is not allowed for this user; use 1024 or higher, such as {PORT}"
            ) from None
        if error.errno == errno.EADDRINUSE:
            raise ParameterError(_taken(host, port)) from None
        raise ParameterError(f"--host {host!r} is not an address of this machine: {error.strerror}") from None


def _taken(host: str, port: int) -> str:
    return (
        f"port {port} of {host} is in use, perhaps by another studio: stop that program, or use "
        f"--port {port + 1}, or --port 0 for a free port"
    )
