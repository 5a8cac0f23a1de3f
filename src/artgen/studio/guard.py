"""Guard of the studio's server: it admits only the pages of one session, and drops malformed messages.

viser checks neither `Host` nor `Origin`: without a guard, any page in the browser could control its server.
"""

import asyncio
import contextlib
import http
import ipaddress
import logging
import re
import secrets
import socket
import threading
from collections.abc import Callable, Iterator
from typing import Any
from urllib.parse import parse_qs, urlsplit

import websockets.asyncio.server as websockets_server
from viser.infra import Message
from websockets.asyncio.server import ServerConnection
from websockets.http11 import Request, Response

_LOOPBACK = ("127.0.0.1", "localhost", "::1")
_WILDCARD = ("0.0.0.0", "::")  # noqa: S104 - compared, not bound
_HOST = re.compile(r"(?:\[([0-9a-f:.]+)\]|([0-9a-z_.-]+))(?::([0-9]{1,5}))?")  # IPv6, name or IPv4, port
_HTTP_PORT = 80  # default port of a `Host` header
_MESSAGE_BYTES = 2**20  # largest message; a longer one closes its connection
_REFUSED = "Open the address that `artgen studio` printed, with its token.\n"

_STARTING = threading.Lock()  # one server starts at a time
_LOG = logging.getLogger("artgen.studio")
_LOG.addFilter(lambda record: record.getMessage() != "opening handshake failed")

_Process = Callable[[ServerConnection, Request], Response | None]


class Guard:
    """Checks the requests and messages of one server.

    Attributes:
        host: The address that the server listens on.
        token: The secret of the session: in the query of the page's address, then in a cookie.
        installed: Whether a server was started with this guard.
    """

    def __init__(self, host: str) -> None:
        """Draw a token for a server that listens on `host`."""
        self.host = host.lower()
        self.token = secrets.token_urlsafe()
        self.installed = False

    @contextlib.contextmanager
    def installing(self) -> Iterator[None]:
        """Guard the viser server that starts within this context.

        viser passes no options to `websockets`, so its call of `serve` is replaced temporarily.
        """
        serve = websockets_server.serve

        def guarded(handler: Any, *arguments: Any, **options: Any) -> Any:
            if handler.__module__.startswith("viser."):
                asyncio.get_running_loop().set_exception_handler(_drop_faults_of_messages)
                options |= {
                    "process_request": self._guarded(options["process_request"]),
                    "create_connection": _Connection,
                    "max_size": _MESSAGE_BYTES,
                    "logger": _LOG,
                }
                self.installed = True
            return serve(handler, *arguments, **options)

        with _STARTING:
            websockets_server.serve = guarded  # type: ignore[assignment, misc]
            try:
                yield
            finally:
                websockets_server.serve = serve  # type: ignore[misc]

    def _guarded(self, process: _Process) -> _Process:
        """Return viser's request handler with the checks."""

        def guarded(connection: ServerConnection, request: Request) -> Response | None:
            port = connection.local_address[1]
            if not self._admits(request, port):
                return connection.respond(http.HTTPStatus.FORBIDDEN, _REFUSED)
            response = process(connection, request)
            if response is not None:  # a page, whose WebSocket sends the cookie
                response.headers["Set-Cookie"] = f"{self._cookie(port)}; Path=/; HttpOnly; SameSite=Strict"
            return response

        return guarded

    def _admits(self, request: Request, port: int) -> bool:
        """Tell whether a request comes from this server's own page, or from a program with the token."""
        hosts, origins = request.headers.get_all("Host"), request.headers.get_all("Origin")
        if len(hosts) != 1 or not self._serves(hosts[0].lower(), port):
            return False
        if any(origin.lower() != f"http://{hosts[0].lower()}" for origin in origins):
            return False
        cookies = ";".join(request.headers.get_all("Cookie")).split(";")
        tokens = parse_qs(urlsplit(request.path).query).get("token", [])
        return any(_same(cookie.strip(), self._cookie(port)) for cookie in cookies) or any(
            _same(token, self.token) for token in tokens
        )

    def _serves(self, host: str, port: int) -> bool:
        """Tell whether a `Host` header names this server; with a wildcard, any IP address does."""
        match = _HOST.fullmatch(host)
        if match is None or int(match[3] or _HTTP_PORT) != port:
            return False
        name = match[1] or match[2]
        if self.host in _WILDCARD:
            return name in (*_LOOPBACK, socket.gethostname().lower()) or _is_ip(name)
        return name in (_LOOPBACK if self.host in _LOOPBACK else (self.host,))

    def _cookie(self, port: int) -> str:
        """Return name and value of the cookie; browsers share cookies among the ports of a host."""
        return f"artgen_studio_{port}={self.token}"


class _Connection(ServerConnection):
    """A WebSocket that receives values of controls and cameras only."""

    async def recv(self, decode: bool | None = None) -> Any:  # noqa: FBT001 - the signature of the base
        """Return the next message that is well-formed."""
        while not _is_well_formed(raw := await super().recv(decode)):
            pass
        return raw


def _is_well_formed(raw: str | bytes) -> bool:
    """Tell whether viser can read a message, and whether the studio's page would send it."""
    if not isinstance(raw, bytes):
        return False
    try:
        message: Any = Message.deserialize(raw)
    except Exception:  # noqa: BLE001 - viser raises whatever the bytes lead to
        return False
    kind = type(message).__name__
    if kind != "GuiUpdateMessage":
        return kind == "ViewerCameraMessage"
    return (
        isinstance(message.uuid, str)
        and isinstance(message.updates, dict)
        and [*message.updates] == ["value"]
    )


def _drop_faults_of_messages(loop: asyncio.AbstractEventLoop, context: dict[str, Any]) -> None:
    """Drop the error of a value that its control cannot read, such as text for a slider."""
    task = context.get("future")
    name = getattr(task.get_coro(), "__name__", "") if isinstance(task, asyncio.Task) else ""
    if name != "_handle_incoming_message":
        loop.default_exception_handler(context)


def _same(given: str, secret: str) -> bool:
    """Compare secrets in constant time."""
    return secrets.compare_digest(given.encode(errors="replace"), secret.encode())


def _is_ip(name: str) -> bool:
    """Tell whether a name is an IP address, which DNS cannot rebind."""
    try:
        ipaddress.ip_address(name)
    except ValueError:
        return False
    return True
