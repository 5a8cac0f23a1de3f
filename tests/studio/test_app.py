"""The studio's server without a browser: wishes, faults, ports, and how it ends."""

import html
import os
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from artgen.cli import main
from artgen.errors import ParameterError, RenderError
from artgen.studio import Session

pytest.importorskip("viser", reason='viser is not installed: pip install "artgen[studio]"')

from artgen.studio.app import Studio

CRATE = Path(__file__).parent.parent / "support" / "crate.py"


def crate() -> Session:
    return Session(str(CRATE), seed=1)


def until(what: Callable[[], Any], why: str, patience: float = 30.0) -> Any:
    end = time.monotonic() + patience
    while not (found := what()):
        assert time.monotonic() < end, f"{why} within {patience:g} s"
        time.sleep(0.02)
    return found


@pytest.fixture
def studio() -> Iterator[Studio]:
    made = Studio(crate(), port=0)
    try:
        until(lambda: made.stage.sent == 4, "the links of the first asset are sent")
        yield made
    finally:
        made.close()


def test_it_serves_this_machine_only(studio: Studio) -> None:
    assert studio.host == "127.0.0.1"
    with socket.create_connection(("127.0.0.1", studio.port), timeout=5.0):
        pass
    others = [place[4][0] for place in socket.getaddrinfo(socket.gethostname(), None, socket.AF_INET)]
    for other in {place for place in others if not place.startswith("127.")}:
        with pytest.raises(OSError), socket.create_connection((other, studio.port), timeout=5.0):
            pass


def test_a_joint_sends_poses_alone_and_a_limit_not_even_those(studio: Studio) -> None:
    sent = studio.stage.sent
    studio.requests.add("move", lambda: studio.session.move("bolt_slide", 0.04))
    studio.requests.add("swing", lambda: studio.session.set("swing", 1.4))
    until(lambda: studio.session.asset.parameters["swing"] == 1.4, "the swing is taken")
    assert studio.stage.sent == sent
    studio.requests.add("width", lambda: studio.session.set("width", 0.3))
    until(lambda: studio.panel.python.content.count("width=0.3"), "the width is taken")
    assert studio.stage.sent == sent + 2, "bolt and flag are only carried along"


def test_of_many_wishes_the_last_is_granted(studio: Studio) -> None:
    made = []
    evaluate = studio.session.evaluate
    held = threading.Event()
    studio.session.evaluate = lambda: made.append(1) or (held.wait(10.0), evaluate())[1]
    for step in range(50):
        studio.requests.add("set width", lambda step=step: studio.session.set("width", 0.3 + 0.001 * step))
    held.set()
    until(lambda: studio.session.asset.parameters["width"] == pytest.approx(0.349), "the last is taken")
    assert len(made) <= 3


def test_whatever_goes_wrong_is_told_and_the_server_lives(studio: Studio) -> None:
    def fail() -> None:
        raise ZeroDivisionError("of no one's")

    studio.requests.add("odd", fail)
    until(lambda: "ZeroDivisionError: of no one's" in studio.session.error, "it is told")
    until(lambda: f"{__file__}:" in html.unescape(studio.panel.error.content), "the panel shows it")
    studio.requests.add("unknown", lambda: studio.session.set("depth", 1.0))
    until(lambda: "has no parameter 'depth'" in html.unescape(studio.panel.error.content), "it is told")
    studio.requests.add("set width", lambda: studio.session.set("width", 0.7))
    until(lambda: "0.2 to 0.6 m is allowed" in studio.panel.error.content, "it is told")
    assert studio.panel.error.visible
    studio.requests.add("set width", lambda: studio.session.set("width", 0.31))
    until(lambda: studio.session.asset.parameters["width"] == 0.31, "the next value is taken")
    until(lambda: not studio.panel.error.visible, "there is nothing to tell")


def test_the_certificate_comes_by_itself(studio: Studio) -> None:
    until(lambda: studio.session.certificate, "it is certified", 60.0)
    until(lambda: "proven: 6 pairs of links never collide" in studio.panel.verdict.content, "it is told")
    until(lambda: "proven" in studio.panel.status.content, "the first line tells it too")


def test_a_port_in_use_is_named_with_what_to_do(studio: Studio) -> None:
    with pytest.raises(ParameterError) as error:
        Studio(crate(), port=studio.port)
    assert str(error.value) == (
        f"port {studio.port} of 127.0.0.1 is in use, perhaps by another studio: stop that program, or use "
        f"--port {studio.port + 1}, or --port 0 for a free port"
    )


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["--port", "70000"], "--port 70000 is not allowed: it must be in 0..65535"),
        (["--host", "192.0.2.1"], "--host '192.0.2.1' is not an address of this machine"),
        (["--set", "widht=0.3"], "has no parameter 'widht'. Did you mean 'width'?"),
        (["--seed", "-1"], "seed must be a whole number that is not negative, got -1"),
    ],
)
def test_wrong_options_are_one_line(
    arguments: list[str], told: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as ended:
        main(["studio", str(CRATE), "--no-open", *arguments])
    assert ended.value.code == 2
    error = capsys.readouterr().err
    assert told in error
    assert error.count("\n") == 1


def test_without_viser_it_names_the_extra(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "viser", None)
    with pytest.raises(RenderError, match=r'pip install "artgen\[studio\]"'):
        Studio(crate(), port=0)


def test_ctrl_c_ends_it_without_a_trace() -> None:
    program = (  # whoever runs the tests may have told its processes to ignore Ctrl-C
        "import signal\n"
        "from artgen.cli import main\n"
        "signal.signal(signal.SIGINT, signal.default_int_handler)\n"
        f"main(['studio', {str(CRATE)!r}, '--port', '0', '--no-open'])"
    )
    process = subprocess.Popen(
        [sys.executable, "-c", program],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    try:
        assert process.stdout is not None
        assert process.stdout.readline().startswith("crate in the studio: http://127.0.0.1:")
        time.sleep(1.0)
        os.killpg(process.pid, signal.SIGINT)
        out, error = process.communicate(timeout=30.0)
    finally:
        process.kill()
        process.communicate()
    assert (process.returncode, out, error) == (0, "\nthe studio is closed\n", "")
