"""`artgen images`: errors before anything is written."""

import json
from pathlib import Path

import pytest

import artgen.images.plan as plans
from artgen.images import ImagePlan


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("dor",), "there is no category 'dor'. Did you mean 'door'?"),
        (("door", "--labels", "handel"), "door: there is no label 'handel'. Did you mean 'handle'?"),
        (
            ("door", "--labels", "lamp:base"),
            "the label 'lamp:base' is for 'lamp', which is not in the plan; its categories are door",
        ),
        (("door", "--labels", "handle,grip=handle"), "the label 'handle' of door is named twice; leave one"),
        (("door", "--random", "flor"), "no part of a picture is called 'flor'. Did you mean 'floor'?"),
        (("door", "--size", "8"), "size 8 must be one or two whole numbers in 16..4096"),
        (("door", "--split", "0.8,0.1,0.2"), "must be the shares of train, val, test with the sum 1"),
        (("door", "--elevation", "60,30"), "must be within 0..1.5708, the lower number first"),
        (("door", "--margin", "a,b"), "--margin 'a,b' must be 2 numbers with commas between them"),
        (("door", "--assets", "0"), "Input should be greater than or equal to 1"),
    ],
)
def test_what_is_refused(artgen_command, arguments: tuple[str, ...], message: str) -> None:
    done = artgen_command("images", *arguments, "--out", "set")
    assert done.code == 2
    assert message in done.err
    assert done.err.count("\n") == 1
    assert not Path("set").exists()


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


def test_the_data_of_a_plan_are_those_of_their_json() -> None:
    plan = ImagePlan(("door",), 3, labels=("handle",), random=("light", "floor"), split=(1.0, 0.0, 0.0))
    assert json.loads(json.dumps(plan.to_data())) == plan.to_data()
