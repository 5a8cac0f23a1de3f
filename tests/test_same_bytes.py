"""Same seed, same bytes: whatever the process, its hash seed, its cache, and what it made before."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from artgen.asset import Asset
from artgen.catalog import categories, find
from artgen.graph import Cache
from support.digests import digests

SEED = 5
PROGRAM = """
import sys
from artgen.catalog import find
from artgen.graph import Cache
category, directory, before = sys.argv[1], sys.argv[2], int(sys.argv[3])
cache = Cache()
for seed in range(before):
    find(category).generate(seed, cache=cache)
find(category).generate(5, cache=cache).export(directory)
"""


def made_by_process(category: str, directory: Path, hash_seed: str, before: int) -> dict[str, str]:
    environment = {**os.environ, "PYTHONHASHSEED": hash_seed}
    command = [sys.executable, "-c", PROGRAM, category, str(directory), str(before)]
    subprocess.run(command, check=True, env=environment, timeout=300)
    return digests(directory)


@pytest.mark.parametrize("category", categories())
def test_processes_write_the_same_bytes(category: str, tmp_path: Path) -> None:
    first = made_by_process(category, tmp_path / "first", "1", 0)
    second = made_by_process(category, tmp_path / "second", "2", 3)
    assert len(first) > 5
    assert first == second


@pytest.mark.parametrize("category", categories())
def test_what_was_cached_does_not_show(category: str, tmp_path: Path) -> None:
    """A part of a graph that another sample computed before is built in another order, to the same bytes."""
    cold = find(category).generate(SEED, cache=Cache())
    warm = Cache()
    for seed in (1, 2, 3):
        find(category).generate(seed, cache=warm)
    # the same parameters but one: most of the graph is cached, and what is not comes later than it would
    number = next(name for name, value in cold.parameters.items() if isinstance(value, float))
    find(category).generate(SEED, cache=warm, **{number: 0.999 * cold.parameters[number]})
    first = cold.export(tmp_path / "cold")
    second = find(category).generate(SEED, cache=warm).export(tmp_path / "warm")
    assert digests(first) == digests(second)


@pytest.mark.parametrize("category", categories())
def test_an_asset_that_was_read_back_is_written_the_same(category: str, tmp_path: Path) -> None:
    formats = ("urdf", "mjcf", "usd", "glb")
    asset = find(category).generate(SEED, certify=False)
    first = asset.export(tmp_path / "first", formats=formats, textures=256)
    second = Asset.load(first).export(tmp_path / "second", formats=formats, textures=256)
    assert digests(first) == digests(second)
