"""Pictures drawn by several threads, and in processes that were forked."""

import multiprocessing
import os
import subprocess
import sys

import pytest

pytest.importorskip("embreex", reason="needs Embree: artgen[sim]")

CUBE = """
import threading, os
from artgen import box, generator, material, part, Body

@generator
def cube() -> Body:
    return part(box(0.1, 0.1, 0.1), "cube", material("oak"))

def picture(asset):
    return asset.render(size=32, textures=0)

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
shown = picture(asset)
child = os.fork()
if not child:
    same = (picture(asset).color == shown.color).all()
    os._exit(3 if same else 4)  # as multiprocessing ends its processes
print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
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
def test_a_forked_process_draws_the_same() -> None:
    assert output_of(CUBE + FORK) == "3\n"
