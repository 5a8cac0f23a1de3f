"""The studio in the browser: a viser server; one worker handles the latest request of each kind."""

import contextlib
import errno
import io
import socket
import threading
import time
import traceback
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from artgen.errors import ArtgenError, ParameterError, RenderError
from artgen.studio.panel import Panel, tell
from artgen.studio.prover import Prover
from artgen.studio.session import Session, message_of
from artgen.studio.signs import Sign
from artgen.studio.stage import Viewport

HOST, PORT = "127.0.0.1", 8080
OUT = Path("out")

_BREATH = 0.1  # interval between checks for changed files, finished proofs and replaced objects [s]
_CALM = 0.5  # time without changes before a proof begins [s]
_PORTS = 65535


class Studio:
    """A session served to browsers.

    Requests from browsers are kept by name, the latest of each. One thread handles them, evaluates, and sends
    the changes. Errors become messages in the panel.

    Attributes:
        session: The session; only the studio's thread uses it.
        stage: The scene.
        panel: The controls.
        host: Address of the server.
        port: Port of the server.
        out: Folder below which browsers can export.
        updates: Durations of the last changes, from the request to the end of sending [s].
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
        self._wishes: dict[str, tuple[float, Callable[[], None]]] = {}
        self._changed = threading.Condition()
        self._running = True
        self._stale = True
        self._since = time.monotonic()
        self._proven = False
        self._prover = Prover()
        self._moving = ""
        self.updates: list[float] = []
        self.stage = Viewport(self._server)
        self.stage.light(rich=rich_light)
        self.panel = Panel(
            self._server,
            session,
            self.ask,
            self._actions(),
            out=self.out,
            waits=self._waits,
            rich_light=rich_light,
        )
        self._thread = threading.Thread(target=self._run, name="artgen studio", daemon=True)
        self._thread.start()

    @property
    def address(self) -> str:
        """The address for browsers, with the token of the session."""
        host = "127.0.0.1" if self.host in ("0.0.0.0", "::") else self.host  # noqa: S104 - a test, no binding
        host = f"[{host}]" if ":" in host else host
        return f"http://{host}:{self.port}/?token={self._token}"

    def ask(self, name: str, wish: Callable[[], None]) -> None:
        """Queue a request; it replaces an unhandled request of the same name."""
        with self._changed:
            since = self._wishes.pop(name, (time.monotonic(), wish))[0]
            self._wishes[name] = (since, wish)
            self._changed.notify()

    def _waits(self, name: str) -> bool:
        with self._changed:
            return name in self._wishes

    def close(self) -> None:
        """End the server, its thread and its process."""
        with self._changed:
            self._running = False
            self._changed.notify()
        self._thread.join(timeout=10.0)
        self._prover.close()
        _stop(self._server)

    # the studio's thread

    def _run(self) -> None:
        while self._running:
            with self._changed:
                if not self._wishes and not self._stale:
                    self._changed.wait(_BREATH)
                wishes, self._wishes = self._wishes, {}
            began = min((since for since, _ in wishes.values()), default=time.monotonic())
            with self._told(), self._server.atomic():
                for _, wish in wishes.values():
                    with self._told():
                        wish()
                if self._stale:
                    self._stale = False
                    self._evaluate()
            if wishes:
                self.updates = [*self.updates[-99:], time.monotonic() - began]
            with self._told():
                self._look_around()

    @contextlib.contextmanager
    def _told(self) -> Iterator[None]:
        """Show errors instead of ending."""
        try:
            yield
        except ArtgenError as error:
            self.session.fault = message_of(error)
            self.panel.show_fault()
        except Exception as error:  # noqa: BLE001 - the server lives on whatever happens
            place = traceback.extract_tb(error.__traceback__)[-1]
            self.session.fault = f"{message_of(error)}\n  at {place.filename}:{place.lineno}"
            self.panel.show_fault()

    def _evaluate(self) -> None:
        self._since = time.monotonic()
        self._proven = False
        self._prover.cancel()
        if self.session.evaluate():
            self.stage.show(self.session.asset, self.session.q)
            self.panel.show()
            self.panel.show_positions()
            self.panel.show_proof("waiting for a moment of calm ...")
        self.panel.show_fault()

    def _look_around(self) -> None:
        """Check the file of the category, the proof, and replaced objects."""
        self.stage.tidy()
        if self.session.source.saved():
            if self.session.reload():
                self._stale = True
            else:
                self._prover.cancel()
            self.panel.show_fault()
        ending = self._prover.poll()
        if ending is not None and ending.state == "done":
            self.session.certified(ending.value)
            self.panel.show_proof()
            self.panel.show_fault()
        elif ending is not None:
            last = ending.message.strip().rpartition("\n")[2]
            self.panel.show_proof(f"no certificate: {last}")
        calm = time.monotonic() - self._since > _CALM and not self._wishes and not self._stale
        task = self.session.task()
        if calm and not self._proven and task is not None:
            self._proven = True
            self._prover.start(task)
            self.panel.show_proof("being proven ...")

    # requests

    def _actions(self) -> dict[str, Callable[..., None]]:
        return {
            "set": self.set,
            "seed": self._resample,
            "resample": lambda: self.ask("seed", self._next_seed),
            "reset": lambda: self.ask("reset", self._reset),
            "move": self._move,
            "close": lambda: self.ask("pose", lambda: self._pose({})),
            "open": lambda: self.ask("pose", self._open),
            "worst": self._worst,
            "labels": self._labels,
            "textures": self._textures,
            "sign": self._sign,
            "light": lambda wanted: self.stage.light(rich=wanted),
            "export": self._export,
        }

    def set(self, name: str, value: Any) -> None:
        """Set a parameter; a request for `ask`."""
        self.session.set(name, value)
        self._stale = True

    def _resample(self, seed: int) -> None:
        self.session.resample(seed)
        self._stale = True

    def _next_seed(self) -> None:
        self._resample(self.session.seed + 1)
        self.panel.seed.value = self.session.seed

    def _reset(self) -> None:
        self.session.reset()
        self._stale = True

    def _move(self, joint: str, position: float) -> None:
        if joint in self.session.asset.positions():  # it may not exist any more
            self.session.move(joint, position)
            self._posed(joint)

    def _open(self) -> None:
        from artgen.view import opened

        self._pose(opened(self.session.asset))

    def _pose(self, q: dict[str, float]) -> None:
        self.session.pose(q)
        self._posed()

    def _posed(self, moving: str = "", red: tuple[str, ...] = ()) -> None:
        self.stage.pose(self.session.q)
        self.stage.dress(red)
        self.panel.show_positions(moving)

    def _worst(self, number: int) -> None:
        pair = self.session.collisions[number]
        assert pair.witness is not None
        self.session.pose(pair.witness.pose)
        self._posed(red=pair.links)

    def _labels(self, wanted: bool) -> None:  # noqa: FBT001 - a checkbox says so
        self.stage.by_label = wanted
        self.stage.dress()

    def _textures(self, size: int) -> None:
        self.stage.textures = size
        self.stage.dress()

    def _sign(self, kind: Sign, wanted: bool) -> None:  # noqa: FBT001 - a checkbox says so
        kinds = self.stage.signs.kinds
        (kinds.add if wanted else kinds.discard)(kind)
        self.stage.signs.show(self.session.asset, self.session.q)

    def _export(self, folder: str, formats: tuple[str, ...]) -> None:
        try:
            path = self.session.export(self._below(folder) if folder.strip() else "", formats)
        except ArtgenError as error:
            tell(self.panel.exported, message_of(error), "fault")
        else:
            tell(self.panel.exported, f"written to {path.resolve()}", "plain")

    def _below(self, folder: str) -> Path:
        """Return a folder below `out`, with links resolved."""
        try:
            path = (self.out / folder.strip()).resolve()
        except (OSError, RuntimeError, ValueError):  # a loop of links, or a NUL character
            path = None
        if path is None or not path.is_relative_to(self.out):
            raise ParameterError(
                f"folder {folder!r} is not allowed: give one below {self.out}, "
                "or start the studio with another --out"
            )
        return path


def _server(host: str, port: int) -> tuple[Any, str]:
    """Return a guarded viser server at exactly this port, and the token of its guard."""
    try:
        import viser

        from artgen.studio.guard import Guard
    except ImportError as error:
        raise RenderError(
            f'the studio needs viser, which cannot be loaded ({error}): pip install "artgen[studio]"'
        ) from error
    if not 0 <= port <= _PORTS:
        raise ParameterError(f"--port {port} is not allowed: it must be in 0..{_PORTS}; 0 takes any free one")
    _check_free(host, port)
    guard = Guard(host)
    with _quiet(), guard.installing():
        server = viser.ViserServer(host=host, port=port, verbose=False)
    if not guard.installed:  # viser does not start its server as the guard expects
        _stop(server)
        raise RenderError(
            f"viser {viser.__version__} cannot be guarded against other web pages: install another one, "
            'such as pip install "viser==1.1.1"'
        )
    if port and server.get_port() != port:  # taken in the meantime
        _stop(server)
        raise ParameterError(_taken(host, port))
    return server, guard.token


def _quiet() -> contextlib.redirect_stdout[io.StringIO]:
    """Suppress viser's own start message."""
    return contextlib.redirect_stdout(io.StringIO())


def _stop(server: Any) -> None:
    with _quiet():
        server.stop()


def _check_free(host: str, port: int) -> None:
    try:
        family, kind, protocol, _, place = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)[0]
        with socket.socket(family, kind, protocol) as probe:
            probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)  # as the server will
            probe.bind(place)
    except socket.gaierror as error:
        raise ParameterError(f"--host {host!r} is no address of this machine: {error.strerror}") from None
    except PermissionError:
        raise ParameterError(
            f"--port {port} is not allowed for this user; take one from 1024 on, such as {PORT}"
        ) from None
    except OSError as error:
        if error.errno == errno.EADDRINUSE:
            raise ParameterError(_taken(host, port)) from None
        raise ParameterError(f"--host {host!r} is no address of this machine: {error.strerror}") from None


def _taken(host: str, port: int) -> str:
    return (
        f"port {port} of {host} is in use, perhaps by another studio: end what uses it, or take another one: "
        f"--port {port + 1}, or --port 0 for any that is free"
    )
