"""Every example runs, in an empty directory, without a warning."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from artgen.catalog import load_file
from artgen.testing import check_category
from support.cases import some

FOLDER = Path(__file__).parent.parent / "examples"
EXAMPLES = sorted(FOLDER.glob("*.py"))
CATEGORIES = sorted(FOLDER.glob("categories/*.py"))


def test_examples_are_numbered_and_short() -> None:
    assert [path.name[:3] for path in EXAMPLES] == [f"{number:02}_" for number in range(1, len(EXAMPLES) + 1)]
    for path in EXAMPLES:
        assert len(path.read_text().splitlines()) <= 40, path.name


@pytest.mark.parametrize("path", some(EXAMPLES, 2), ids=[path.stem for path in EXAMPLES])
def test_example_runs(path: Path, tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-W", "error", str(path)],
        capture_output=True,
        text=True,
        check=False,
        cwd=tmp_path,
        env={**os.environ, "MPLBACKEND": "agg"},
        timeout=120,
    )
    assert done.returncode == 0, done.stderr
    assert not done.stderr
    assert done.stdout
    assert {item.name for item in tmp_path.iterdir()} <= {"out"}


@pytest.mark.parametrize("path", some(CATEGORIES, 2, 1), ids=[path.stem for path in CATEGORIES])
def test_an_example_category_is_short_proven_and_sound(path: Path) -> None:
    assert len(path.read_text().splitlines()) < 200
    check_category(load_file(path), seeds=range(1))


def test_example_categories_are_ordinary_modules() -> None:
    run = "import runpy, sys; print([name for path in sys.argv[1:] for name in runpy.run_path(path)])"
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", run, *map(str, CATEGORIES)],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert all(repr(path.stem) in done.stdout for path in CATEGORIES)
