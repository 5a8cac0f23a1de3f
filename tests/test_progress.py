"""Progress in terminals, silence in threads and on request, and one line after Ctrl-C."""

import os
import pty
import re
import signal
import subprocess
import sys
import threading
import time

import pytest

from artgen import _progress
from artgen._progress import progress

SLOW = """
import time
import artgen as ag

@ag.category(labels="box", joints=(0, 0))
def slow(*, width: ag.Float = ag.uniform(0.1, 0.2, "m")) -> ag.Body:
    time.sleep(1.5)
    return ag.part(ag.box(width, width, width), "box", ag.material("oak"))
"""


def steps():
    """Return what an outer step with an inner one shows."""
    with progress("outer", 3, lines=True) as outer:
        outer(advance=1, failed="1 failed")
        with progress("inner") as inner:
            inner(text="pair 2", completed=2, total=5)
    with progress("after", lines=True):
        pass


def test_a_step_within_a_step_is_a_further_part_of_a_line(monkeypatch, capsys):
    monkeypatch.setattr(_progress, "_INTERVAL", 0.0)
    steps()
    shown = capsys.readouterr().err.splitlines()
    inner = ["outer 1/3, 1 failed: inner", "outer 1/3, 1 failed: pair 2 2/5"]
    assert shown == ["outer 0/3", "outer 1/3, 1 failed", *inner, "after"]


@pytest.mark.parametrize("why", ["library", "variable", "thread"])
def test_where_nothing_is_shown(monkeypatch, capsys, why):
    monkeypatch.setattr(_progress, "_INTERVAL", 0.0)
    if why == "library":  # no terminal, and no command
        with progress("outer") as update:
            update(advance=1)
    elif why == "variable":
        monkeypatch.setenv(_progress.SILENT, "0")
        steps()
    else:
        thread = threading.Thread(target=steps)
        thread.start()
        thread.join()
    assert capsys.readouterr().err == ""


def in_terminal(folder, *arguments, until, environment=None):
    """Run a command with a terminal as its stderr; press Ctrl-C when a text is shown.

    Returns the exit code and all that was shown.
    """
    (folder / "slow.py").write_text(SLOW)
    leader, follower = pty.openpty()
    variables = {**os.environ, "TERM": "xterm", "COLUMNS": "160", **(environment or {})}
    # a shell makes programs in its background ignore it
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    command = subprocess.Popen(
        [sys.executable, "-m", "artgen", *arguments], cwd=folder, stderr=follower, stdout=subprocess.DEVNULL,
        env=variables,
    )  # fmt: skip
    signal.signal(signal.SIGINT, before)
    os.close(follower)
    shown, end, sent = "", time.monotonic() + 60.0, False
    try:
        while time.monotonic() < end:
            try:
                shown += os.read(leader, 4096).decode(errors="replace")
            except OSError:  # the command has ended
                break
            if until in shown and not sent:
                command.send_signal(signal.SIGINT)
                sent = True
        return command.wait(20), re.sub(r"\x1b\[[0-9;?]*[a-zA-Z]", "", shown)
    finally:
        command.kill()
        command.wait()
        os.close(leader)


@pytest.mark.skipif(sys.platform == "win32", reason="pseudo-terminals are of POSIX")
def test_a_terminal_shows_the_sample_and_ctrl_c_ends_the_command(tmp_path):
    arguments = ("certify", "slow.py", "--samples", "9", "--no-corners")
    code, shown = in_terminal(tmp_path, *arguments, until="1/9")
    assert code == 130
    assert "seed 1: slow_1" in shown
    assert shown.rstrip().endswith("interrupted")
    assert "Traceback" not in shown
    assert sorted(path.name for path in tmp_path.iterdir()) == ["slow.py"]
