"""Same seed, same bytes: whatever the process, its hash seed, its cache, and what it made before."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from artgen.asset import Asset
from artgen.catalog import categories, find
from artgen.graph import Cache
from support.cases import some
from support.digests import digests

SEED = 5
GROUPS = 8  # of categories, each of one process
HASHES = Path(__file__).parents[1] / "scripts" / "tree_hashes.py"


@pytest.mark.parametrize("group", some(range(GROUPS), GROUPS))
def test_seeds_give_what_they_gave_to_other_processes(group: int) -> None:
    """Compare with the record of a process with another hash seed, in which other assets came before."""
    names = categories()[group::GROUPS]
    environment = {**os.environ, "PYTHONHASHSEED": "7"}
    done = subprocess.run(
        [sys.executable, HASHES, *names],
        check=False, env=environment, capture_output=True, text=True, timeout=600,
    )  # fmt: skip
    assert done.stdout == f"{len(names)} assets: the same bytes as before\n", done.stderr


def test_other_bytes_are_named(tmp_path: Path) -> None:
    """A record that says otherwise of one file is told from the others."""
    record = json.loads((HASHES.parents[1] / "tests" / "tree_hashes.json").read_text())
    record["plier_0"]["mjcf"] = "0"
    (tmp_path / "tests").mkdir()
    (tmp_path / "tests" / "tree_hashes.json").write_text(json.dumps(record))
    (tmp_path / "scripts").mkdir()
    script = shutil.copy(HASHES, tmp_path / "scripts")
    done = subprocess.run(
        [sys.executable, script, "plier"], check=False, capture_output=True, text=True, timeout=600
    )
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr == (
        "plier_0: not the same bytes as before: mjcf\n"
        "if that is meant, run: python scripts/tree_hashes.py plier --write\n"
    )


@pytest.mark.parametrize("category", some(categories(), 10))
def test_what_was_cached_does_not_show(category: str, tmp_path: Path) -> None:
    """A part of a graph that another sample computed before is built in another order, to the same bytes."""
    cold = find(category).generate(SEED, cache=Cache())
    warm = Cache()
    for seed in (1, 2):
        find(category).generate(seed, cache=warm, certify=False)
    # the same parameters but one: most of the graph is cached, and what is not comes later than it would
    number = next(name for name, value in cold.parameters.items() if isinstance(value, float))
    changed = {number: 0.999 * cold.parameters[number]}
    find(category).generate(SEED, cache=warm, certify=False, **changed)
    again = find(category).generate(SEED, cache=warm)
    first, second = (
        each.export(tmp_path / name, textures=256) for name, each in (("cold", cold), ("warm", again))
    )
    assert digests(first) == digests(second)


@pytest.mark.parametrize("category", some(categories(), 6, 1))
def test_an_asset_that_was_read_back_is_written_the_same(category: str, tmp_path: Path) -> None:
    formats = ("urdf", "mjcf", "usd", "glb")
    asset = find(category).generate(SEED, certify=False)
    first = asset.export(tmp_path / "first", formats=formats, textures=256)
    second = Asset.load(first).export(tmp_path / "second", formats=formats, textures=256)
    assert digests(first) == digests(second)
