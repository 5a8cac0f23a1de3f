"""What is remembered is let go before manifold3d is taken down."""

import subprocess
import sys

PROGRAM = """
import atexit

def told():
    from artgen.generator.generator import SHARED
    from artgen.nodes.surfaces import _unit_box

    print(len(SHARED), _unit_box.cache_info().currsize)

atexit.register(told)  # what is registered first runs last
import artgen

artgen.generate("drawer", seed=1, certify=False)
told()
"""


def test_solids_are_forgotten_when_the_interpreter_ends() -> None:
    done = subprocess.run([sys.executable, "-c", PROGRAM], capture_output=True, text=True, check=True)
    before, after = done.stdout.splitlines()
    assert all(int(number) > 0 for number in before.split())
    assert after == "0 0"
    assert not done.stderr
