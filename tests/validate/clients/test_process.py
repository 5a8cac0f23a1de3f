"""Programs that print a lot, crash, hang, or leave children behind."""

import os
import sys
import threading
import time

from artgen.validate.clients.run import run_process, stop_running


def run(tmp_path, code, seconds=20.0):
    return run_process([sys.executable, "-c", code], tmp_path, os.environ, seconds)


def test_both_streams_are_kept_in_order(tmp_path):
    code = "import os; os.write(1, b'one\\n'); os.write(2, b'two\\n'); os.write(1, b'\\xff three\\n')"
    done = run(tmp_path, code)
    assert done.output == "one\ntwo\n\ufffd three\n"
    assert (done.code, done.ending, done.timed_out) == (0, "", False)


def test_a_flood_of_output_is_read_to_its_end_and_its_first_part_kept(tmp_path):
    done = run(tmp_path, "print('begin'); print('x' * 20_000_000); print('end')")
    assert done.code == 0
    assert done.output.startswith("begin\n")
    assert len(done.output) == 400_000


def test_a_crash_has_the_name_of_its_signal(tmp_path):
    done = run(tmp_path, "import os, signal; os.kill(os.getpid(), signal.SIGSEGV)")
    assert done.ending == "it crashed: SIGSEGV"


def test_an_exit_code_is_told(tmp_path):
    assert run(tmp_path, "raise SystemExit(7)").ending == "it ended with exit code 7"


def test_what_hangs_is_killed_with_all_its_children(tmp_path):
    child = "import pathlib, time; time.sleep(2.5); pathlib.Path('alive').touch()"
    code = (
        f"import subprocess, sys, time; subprocess.Popen([sys.executable, '-c', {child!r}]); "
        "print('started', flush=True); time.sleep(60)"
    )
    start = time.monotonic()
    done = run(tmp_path, code, 1.0)
    assert done.timed_out
    assert done.ending == "it was killed after 1 s"
    assert done.output == "started\n"
    assert time.monotonic() - start < 10.0
    time.sleep(2.5)
    assert not (tmp_path / "alive").exists()


def test_a_child_that_outlives_the_program_does_not_hold_it_up(tmp_path):
    code = "import subprocess, sys; subprocess.Popen([sys.executable, '-c', 'import time; time.sleep(60)'])"
    done = run(tmp_path, code, 30.0)
    assert (done.code, done.timed_out) == (0, False)
    assert done.seconds < 10.0


def test_what_nobody_waits_for_any_more_is_stopped(tmp_path):
    timer = threading.Timer(1.0, stop_running)
    timer.start()
    start = time.monotonic()
    done = run(tmp_path, "import time; time.sleep(60)")
    timer.join()
    assert time.monotonic() - start < 10.0
    assert done.ending == "it crashed: SIGKILL"
