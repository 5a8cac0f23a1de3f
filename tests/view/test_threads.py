"""Pictures drawn by several threads, and in processes that were forked."""

import multiprocessing
import os
import subprocess
import sys

import pytest

pytestmark = pytest.mark.usefixtures("opengl")

CUBE = """
import threading, os
from artgen import box, generator, material, part, Body

@generator
def cube() -> Body:
    return part(box(0.1, 0.1, 0.1), "cube", material("oak"))

def picture(asset):
    return asset.render(size=32, textures=0, samples=4)

asset = cube.generate()
seen = []
"""

THREADS = """
def draw(asset):
    shown = picture(asset)
    seen.append(int(shown.links.mask("cube").sum()))

for made in (lambda: asset, cube.generate):
    threads = [threading.Thread(target=draw, args=(made(),)) for _ in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
draw(asset)
print(len(seen), len(set(seen)), seen[0] > 100)
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


def test_threads_draw_the_same() -> None:
    assert output_of(CUBE + THREADS) == "7 1 True\n"


@pytest.mark.skipif(
    "fork" not in multiprocessing.get_all_start_methods(), reason="needs fork: Linux or macOS"
)
def test_a_forked_process_says_that_it_cannot_draw() -> None:
    refused, masked, parent = output_of(CUBE + FORK).splitlines()
    assert refused.startswith("RenderError this process was forked from one that had drawn a picture")
    assert "'spawn' or 'forkserver'" in refused
    assert masked == "True", "masks are not found by rays"
    assert parent == "3 True"
