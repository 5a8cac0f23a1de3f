"""The studio against foreign web pages: requests, messages, and the folder that a page may export to."""

import contextlib
import http.client
import logging
import time
import urllib.request
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("viser", reason='viser is not installed: pip install "artgen[studio]"')

import msgspec
import viser
from viser import _messages
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection, connect

from artgen.cli import main
from artgen.errors import ParameterError, RenderError
from artgen.studio import Session
from artgen.studio.app import Studio
from artgen.studio.guard import Guard

CRATE = Path(__file__).parent.parent / "support" / "crate.py"
PROTOCOL = f"viser-v{viser.__version__}"
UPGRADE = {
    "Connection": "Upgrade",
    "Upgrade": "websocket",
    "Sec-WebSocket-Version": "13",
    "Sec-WebSocket-Key": "AAAAAAAAAAAAAAAAAAAAAA==",
    "Sec-WebSocket-Protocol": PROTOCOL,
}
PAGE: dict[str, str] = {}


@pytest.fixture
def studio(tmp_path: Path) -> Iterator[Studio]:
    made = Studio(Session(str(CRATE), seed=1), port=0, out=tmp_path / "out")
    try:
        yield made
    finally:
        made.close()


def status(studio: Studio, path: str, headers: dict[str, str]) -> int:
    """The status of one request: 200 for the page, 101 for an open WebSocket, 403 where it is refused."""
    connection = http.client.HTTPConnection("127.0.0.1", studio.port, timeout=10.0)
    try:
        connection.request("GET", path, headers=headers)
        return connection.getresponse().status
    finally:
        connection.close()


def secret(studio: Studio) -> str:
    """The path and query of the printed address."""
    return "/" + studio.address.rpartition("/")[2]


@pytest.mark.parametrize(("kind", "welcome"), [(PAGE, 200), (UPGRADE, 101)], ids=["page", "websocket"])
def test_only_its_own_page_and_programs_with_the_token_come_in(
    studio: Studio, kind: dict[str, str], welcome: int
) -> None:
    path, port = secret(studio), studio.port
    assert status(studio, path, kind) == welcome
    for name in ("127.0.0.1", "localhost", "LOCALHOST", "[::1]"):
        here = f"{name}:{port}"
        assert status(studio, path, kind | {"Host": here, "Origin": f"http://{here}"}) == welcome
    for host in ("evil.example", f"evil.example:{port}", f"127.0.0.1:{port + 1}", "127.0.0.1", ""):
        assert status(studio, path, kind | {"Host": host}) == 403, host
        assert status(studio, path, kind | {"Host": host, "Origin": f"http://{host}"}) == 403, host
    for origin in (
        "http://evil.example",
        "null",
        f"https://127.0.0.1:{port}",
        f"http://127.0.0.1:{port + 1}",
    ):
        assert status(studio, path, kind | {"Origin": origin}) == 403, origin


@pytest.mark.parametrize(("kind", "welcome"), [(PAGE, 200), (UPGRADE, 101)], ids=["page", "websocket"])
def test_without_the_token_it_refuses(studio: Studio, kind: dict[str, str], welcome: int) -> None:
    token = secret(studio).partition("=")[2]
    for path in ("/", "/?token=", f"/?token={token[:-1]}", "/?token=%FF%C3%A9", "/index.html"):
        assert status(studio, path, kind) == 403, path
    name = f"artgen_studio_{studio.port}"
    assert status(studio, "/", kind | {"Cookie": f"other; {name}={token}; last=1"}) == welcome
    assert status(studio, "/", kind | {"Cookie": f"{name}={token}x"}) == 403
    assert status(studio, "/", kind | {"Cookie": f"artgen_studio_1={token}"}) == 403


def test_the_page_sets_a_cookie_that_no_other_site_sends(studio: Studio) -> None:
    connection = http.client.HTTPConnection("127.0.0.1", studio.port, timeout=10.0)
    connection.request("GET", secret(studio))
    cookie = connection.getresponse().getheader("Set-Cookie")
    connection.close()
    assert cookie is not None
    value, *attributes = cookie.split("; ")
    assert value == f"artgen_studio_{studio.port}={secret(studio).partition('=')[2]}"
    assert {"HttpOnly", "SameSite=Strict"} <= set(attributes)


def test_each_studio_has_a_token_of_its_own(studio: Studio) -> None:
    other = Studio(Session(str(CRATE), seed=1), port=0)
    try:
        assert status(other, secret(studio), UPGRADE) == 403
    finally:
        other.close()


def test_of_every_interface_no_foreign_name_is_served() -> None:
    everywhere = Studio(Session(str(CRATE), seed=1), "0.0.0.0", 0)  # noqa: S104 - the case
    try:
        for name, expected in (("127.0.0.1", 101), ("192.0.2.7", 101), ("evil.example", 403)):
            headers = UPGRADE | {"Host": f"{name}:{everywhere.port}"}
            assert status(everywhere, secret(everywhere), headers) == expected, name
    finally:
        everywhere.close()


def test_a_viser_that_the_guard_does_not_fit_serves_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Guard, "installing", lambda _: contextlib.nullcontext())
    with pytest.raises(RenderError, match=f"viser {viser.__version__} cannot be guarded"):
        Studio(Session(str(CRATE), seed=1), port=0)


def test_loopback_of_ipv6_has_an_address_that_opens() -> None:
    try:
        made = Studio(Session(str(CRATE), seed=1), "::1", 0)
    except ParameterError:
        pytest.skip("this machine has no IPv6")
    try:
        assert made.address.startswith(f"http://[::1]:{made.port}/?token=")
        with urllib.request.urlopen(made.address, timeout=10.0) as page:  # noqa: S310 - its own address
            assert page.status == 200
    finally:
        made.close()


def test_the_command_gives_the_folder(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    given: list[Path] = []

    def stop(*_: Any, out: Path) -> None:
        given.append(out)
        raise ParameterError("enough")

    monkeypatch.setattr("artgen.studio.app.Studio", stop)
    for arguments in ([], ["--out", str(tmp_path)]):
        with pytest.raises(SystemExit):
            main(["studio", str(CRATE), "--no-open", *arguments])
    assert given == [Path("out"), tmp_path]


# what a page with the token may send


def opened(studio: Studio) -> ClientConnection:
    """A WebSocket as the page opens it, known to the server once its camera is sent."""
    address = studio.address.replace("http:", "ws:")
    client = connect(address, subprotocols=[PROTOCOL], max_size=None, compression=None)
    camera = _messages.ViewerCameraMessage(
        (1.0, 0.0, 0.0, 0.0), (0.0, 0.0, 1.0), 1.0, 0.1, 9.0, 10, 10, (0.0, 0.0, 0.0), (0.0, 0.0, 1.0)
    )
    client.send(packed(camera))
    return client


def packed(message: Any) -> bytes:
    return msgspec.msgpack.encode(message.as_serializable_dict())


def update(handle: Any, value: Any, name: str = "value") -> bytes:
    return packed(_messages.GuiUpdateMessage(handle._impl.uuid, {name: value}))


def until(what: Any, why: str, patience: float = 30.0) -> Any:
    end = time.monotonic() + patience
    while not (found := what()):
        assert time.monotonic() < end, f"{why} within {patience:g} s"
        time.sleep(0.02)
    return found


def button(studio: Studio, label: str) -> Any:
    handles = list(studio._server.gui._gui_input_handle_from_uuid.values())  # other threads add some
    return next(handle for handle in handles if getattr(handle, "label", "") == label)


@pytest.mark.parametrize(
    "folder",
    ["../elsewhere", "{tmp}/elsewhere", "a/../../elsewhere", "link/elsewhere", "bad\0name"],
    ids=["above", "absolute", "through a folder", "through a link", "no path"],
)
def test_the_page_exports_below_the_given_folder_only(studio: Studio, tmp_path: Path, folder: str) -> None:
    until(lambda: studio.panel._folder.value.startswith("crate"), "the name of the asset is suggested")
    studio.out.mkdir()
    (tmp_path / "elsewhere").mkdir()
    (studio.out / "link").symlink_to(tmp_path)
    with opened(studio) as client:
        client.send(update(studio.panel._folder, folder.format(tmp=tmp_path)))
        client.send(update(button(studio, "export"), value=True))
        until(lambda: "is not allowed: give a folder below" in studio.panel.exported.content, "it is told")
    assert not [*(tmp_path / "elsewhere").iterdir()]
    assert [path.name for path in studio.out.iterdir()] == ["link"]
    assert not studio.session.error


def test_the_page_exports_to_a_folder_below(studio: Studio) -> None:
    until(lambda: studio.panel._folder.value.startswith("crate"), "the name of the asset is suggested")
    with opened(studio) as client:
        client.send(update(studio.panel._folder, "mine/first"))
        client.send(update(button(studio, "export"), value=True))
        until(lambda: "written to" in studio.panel.exported.content, "it is exported")
    assert (studio.out / "mine" / "first" / "asset.json").is_file()


def test_the_buttons_of_a_group_still_work(studio: Studio) -> None:
    until(lambda: studio.session.shown, "there is an asset")
    with opened(studio) as client:
        client.send(update(button(studio, "draw"), "resample"))
        until(lambda: studio.session.seed == 2, "another seed is drawn")
        client.send(update(button(studio, "all"), "open"))
        until(lambda: studio.session.q, "it opens")


def test_malformed_messages_are_dropped_without_a_trace(
    studio: Studio, caplog: pytest.LogCaptureFixture, capfd: pytest.CaptureFixture[str]
) -> None:
    until(lambda: studio.panel._controls, "there are parameters")
    width, seed = studio.panel._controls["width"][1], studio.panel.seed
    pack = msgspec.msgpack.encode
    draw = button(studio, "draw")
    with caplog.at_level(logging.WARNING), opened(studio) as client:
        for message in (
            "text",
            b"",
            b"\xc1 no msgpack",
            b"\x91" * 100_000,
            pack([1, 2]),
            pack({"type": 5}),
            pack({"type": "Unknown"}),
            pack({"type": "GuiUpdateMessage"}),
            pack({"type": "GuiUpdateMessage", "uuid": [1], "updates": {"value": 1}}),
            pack({"type": "GuiUpdateMessage", "uuid": width._impl.uuid, "updates": 7}),
            pack({"type": "ViewerCameraMessage", "wxyz": "north"}),
            pack({"type": "ShareUrlRequest"}),
            update(width, "wide"),
            update(width, None),
            update(seed, float("inf")),
            update(width, [], name="update_cb"),
            update(draw, "export"),
        ):
            client.send(message)
        client.send(update(seed, 7))
        until(lambda: studio.session.seed == 7, "the next message is read")
        client.send(b"\0" * 2_000_000)
        with contextlib.suppress(ConnectionClosed):
            while True:
                client.recv(timeout=30.0)
        assert client.close_code == 1009, "it is too long"
    with opened(studio) as client:
        client.send(update(seed, 8))
        until(lambda: studio.session.seed == 8, "another browser is served")
    assert callable(width._impl.update_cb[0])
    studio.close()  # a task's error is logged when the task goes
    out, error = capfd.readouterr()
    assert not caplog.records
    assert "Traceback" not in out + error
