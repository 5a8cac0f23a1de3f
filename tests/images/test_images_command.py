"""`artgen images`: errors before anything is written, and options of the assets."""

import json
from pathlib import Path

import pytest

import artgen.images.plan as plans
from artgen.images import ImagePlan


def test_without_opengl_nothing_is_written(artgen_command, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("MUJOCO_GL", "disable")
    done = artgen_command("images", "plier", "--assets", "1", "--out", "set")
    assert (done.code, done.err) == (2, "error: MUJOCO_GL=disable disables pictures; unset it\n")
    assert not Path("set").exists()


def test_a_missing_package_is_an_error(artgen_command, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(plans, "find_spec", lambda name: None if name == "pycocotools" else name)
    done = artgen_command("images", "plier", "--assets", "1", "--out", "set")
    expected = 'error: pycocotools, which encodes masks, is not installed: pip install "artgen[images]"\n'
    assert (done.code, done.err) == (2, expected)


def test_a_folder_with_other_files_stays_unchanged(artgen_command, opengl: None) -> None:
    Path("set").mkdir()
    Path("set/notes.txt").write_text("mine")
    done = artgen_command("images", "plier", "--assets", "1", "--out", "set")
    assert done.code == 2
    assert done.err.startswith("error: cannot write a dataset to ")
    assert done.err.endswith("/set: it holds 'notes.txt' and no dataset; choose another folder\n")
    assert [each.name for each in Path("set").iterdir() if each.name != ".lock"] == ["notes.txt"]


def test_assets_of_pictures_have_the_level_of_detail_that_is_given(artgen_command, opengl: None) -> None:
    done = artgen_command(
        *("images", "switch", "--assets", "1", "--images-per-asset", "1", "--size", "32", "--samples", "1"),
        *("--texture-size", "0", "--detail", "low", "--jobs", "1", "--out", "set"),
    )
    assert done.code == 0, done.err
    assert json.loads(Path("set/dataset.json").read_text())["plan"]["detail"] == "low"
    assert json.loads(Path("set/switch/switch_0/asset.json").read_text())["detail"] == "low"


def test_the_data_of_a_plan_are_those_of_their_json() -> None:
    plan = ImagePlan(("door",), 3, labels=("handle",), random=("light", "floor"), split=(1.0, 0.0, 0.0))
    assert json.loads(json.dumps(plan.to_data())) == plan.to_data()
