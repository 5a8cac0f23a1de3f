"""`import artgen` stays light: what is heavy is imported when it is used."""

import subprocess
import sys

HEAVY = (
    "coacd",
    "fcl",
    "fontTools",
    "fsspec",
    "lxml",
    "matplotlib",
    "mujoco",
    "PIL",
    "pxr",
    "ray",
    "rich",
    "scipy",
    "trimesh",
    "typer",
)
HEAVY_TOO = (
    "artgen.categories.door",
    "artgen.cli",
    "artgen.dataset",
    "artgen.export",
    "multiprocessing",
    "pinocchio",
    "yourdfpy",
)


def modules_after(statement: str) -> set[str]:
    script = f"{statement}\nimport sys\nsys.stdout.write(' '.join(sys.modules))"
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", script], capture_output=True, text=True, check=True, timeout=60
    )
    return set(done.stdout.split())


def test_import_loads_nothing_heavy() -> None:
    assert not modules_after("import artgen") & {*HEAVY, *HEAVY_TOO}


def test_generating_loads_no_simulator_and_no_reader() -> None:
    loaded = modules_after("import artgen; artgen.generate('door')")
    assert "artgen.categories.door" in loaded
    assert not loaded & {"mujoco", "pinocchio", "pxr", "trimesh", "typer", "yourdfpy"}


def test_datasets_are_imported_on_first_use() -> None:
    assert "artgen.dataset" in modules_after("import artgen; artgen.Dataset; artgen.stream")
    assert "artgen.dataset.plan" in modules_after("import artgen; artgen.dataset.Plan")
    assert "multiprocessing" in modules_after("from artgen import *; Dataset")


def test_modules_that_the_documentation_writes_with_dots_are_attributes() -> None:
    assert "artgen.feel" in modules_after("import artgen as ag; ag.feel.HINGE")
    assert "artgen.fittings" in modules_after("import artgen as ag; ag.fittings.dial")
    assert "artgen.images" in modules_after("import artgen; artgen.images.ImagePlan")
