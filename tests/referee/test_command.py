"""`artgen certify FILE`: exit codes, JSON, picture, repair, and wrong arguments."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from support.foreign_cabinet import cabinet


@pytest.fixture
def run(artgen_command: Callable[..., Any]) -> Callable[..., tuple[int, str, str]]:
    """Return a function that runs the command, and returns its exit code, stdout and stderr."""

    def command(*arguments: object) -> tuple[int, str, str]:
        result = artgen_command("certify", *map(str, arguments))
        return result.code, result.out, result.err

    return command


def test_a_sound_file_is_proven_with_exit_code_0(run: Callable[..., Any], tmp_path: Path) -> None:
    code, out, err = run(cabinet("urdf", tmp_path))
    assert (code, err) == (0, "")
    assert "proven (3 links, 2 joints, 6 colliders" in out
    assert "3 of 3 pairs that move are proven apart" in out


def test_a_collision_is_shown_drawn_repaired_and_written_with_exit_code_1(
    run: Callable[..., Any], tmp_path: Path
) -> None:
    path = cabinet("urdf", tmp_path, hinge_low=-0.2)
    picture, data = tmp_path / "a.png", tmp_path / "a.json"
    code, out, err = run(path, "--picture", picture, "--json", data, "--repair")
    assert (code, err) == (1, "")
    assert "case and door collide at hinge=-0." in out
    assert f"{picture} shows case and door where they collide" in out
    assert picture.read_bytes().startswith(b"\x89PNG")
    found: dict[str, Any] = json.loads(data.read_text())
    assert found["verdict"] == "collision"
    assert f"wrote {tmp_path / 'cabinet.repaired.urdf'}, whose joint limits are safe" in out
    assert run(tmp_path / "cabinet.repaired.urdf")[0] == 0


def test_pairs_that_stay_open_give_exit_code_3(run: Callable[..., Any], tmp_path: Path) -> None:
    code, out, _ = run(cabinet("urdf", tmp_path), "--seconds", "1e-9")
    assert code == 3
    assert "cabinet.urdf: not proven" in out


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("none.urdf",), "there is no file none.urdf"),
        (("cabinet.urdf", "--seconds", "-1"), "seconds must be a positive number [s], got -1.0"),
        (("cabinet.urdf", "--total", "nan"), "total must be a positive number [s], got nan"),
        (("cabinet.urdf", "--json", "no/folder.json"), "cannot write no/folder.json: give a file in"),
        (("cabinet.urdf", "--picture", "no/folder.png"), "cannot write no/folder.png: give a file in"),
        (("broken.urdf",), "broken.urdf, line 1: it is not well-formed XML"),
    ],
)
def test_wrong_arguments_give_one_line_and_exit_code_2(
    arguments: tuple[str, ...], message: str, run: Callable[..., Any], tmp_path: Path
) -> None:
    cabinet("urdf", tmp_path, hinge_low=-0.2)
    Path("broken.urdf").write_text("<robot")
    code, out, err = run(*arguments)
    assert (code, out) == (2, "")
    assert err.startswith(f"error: {message}")
    assert err.count("\n") == 1
