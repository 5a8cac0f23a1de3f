"""Pictures drawn by several threads, and in processes that were forked."""

import multiprocessing
import os
import subprocess
import sys
import threading

import pytest

from artgen.view import filament
from artgen.view.filament import OneThread

pytestmark = pytest.mark.usefixtures("opengl")

CUBE = """
import threading, os
from artgen import box, generator, material, part, Body

@generator
def cube() -> Body:
    return part(box(0.1, 0.1, 0.1), "cube", material("oak"))

def picture(asset):
    return asset.render(size=32, backend=BACKEND, textures=0, samples=4)

asset = cube.generate()
seen = []
"""

THREADS = """
def draw(asset):
    shown = picture(asset)
    seen.append((shown.backend, int(shown.links.mask("cube").sum())))

for made in (lambda: asset, cube.generate):
    threads = [threading.Thread(target=draw, args=(made(),)) for _ in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
draw(asset)
print(len(seen), len(set(seen)), seen[0][0])
"""

FORK = """
shown, later = picture(asset), picture(asset)
want = shown.links.ids.sum()
child = os.fork()
if not child:
    try:
        picture(asset)
    except Exception as error:
        print(type(error).__name__, error, flush=True)
    print(later.links.ids.sum() == want, flush=True)
    os._exit(3)  # as multiprocessing ends its processes
print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), picture(asset).links.ids.sum() == want)
"""


def output_of(program: str) -> str:
    """Return what a program prints that ends well and without a word."""
    done = subprocess.run(
        [sys.executable, "-W", "error", "-W", "ignore::DeprecationWarning", "-c", program],
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
        env=os.environ,
    )
    assert (done.returncode, done.stderr) == (0, "")
    return done.stdout


@pytest.fixture(params=["classic", "filament"])
def backend(request) -> str:
    if request.param == "filament" and not filament.works():
        pytest.skip("needs Filament: Python 3.12, mujoco-studio and Vulkan")
    return request.param


def test_threads_draw_the_same(backend) -> None:
    program = CUBE.replace("BACKEND", repr(backend)) + THREADS
    assert output_of(program) == f"7 1 {backend}\n"


@pytest.mark.skipif(
    "fork" not in multiprocessing.get_all_start_methods(), reason="needs fork: Linux or macOS"
)
def test_a_forked_process_says_that_it_cannot_draw(backend) -> None:
    refused, masked, parent = output_of(CUBE.replace("BACKEND", repr(backend)) + FORK).splitlines()
    assert refused.startswith("RenderError this process was forked from one that had drawn a picture")
    assert "'spawn' or 'forkserver'" in refused
    assert masked == "True", "masks are not found by rays"
    assert parent == "3 True"


class TestOneThread:
    """Calls from several threads, made by one."""

    def test_calls_are_made_in_one_thread_of_its_own(self) -> None:
        hand = OneThread("hand")
        assert not hand.begun()
        names = {hand.run(lambda: threading.current_thread().name) for _ in range(3)}
        assert names == {"hand"}
        assert hand.begun()

    def test_a_call_may_make_another(self) -> None:
        hand = OneThread("hand")
        assert hand.run(lambda: hand.run(lambda: 7)) == 7

    def test_errors_reach_whoever_asked(self) -> None:
        hand = OneThread("hand")

        def fail() -> None:
            raise KeyError("lost")

        with pytest.raises(KeyError, match="lost"):
            hand.run(fail)
        assert hand.run(lambda: 7) == 7, "a failed call ended the thread"

    def test_calls_of_many_threads_take_turns(self) -> None:
        hand, inside, most = OneThread("hand"), [], []

        def call() -> None:
            inside.append(1)
            most.append(len(inside))
            inside.pop()

        threads = [threading.Thread(target=lambda: [hand.run(call) for _ in range(50)]) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        assert len(most) == 200
        assert max(most) == 1
