"""The command line: what it prints, what it writes, and what it refuses in one line."""

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import artgen
from artgen.commands.info import _blocks
from artgen.generator import CATEGORIES
from support.generators import chest


def asset_data(directory: Path) -> dict:
    return json.loads((directory / "asset.json").read_text())


def test_list_names_every_category(artgen_command) -> None:
    result = artgen_command("list")
    assert result.code == 0
    for name in artgen.catalog.categories():
        summary = artgen.catalog.find(name).__doc__.strip().partition("\n")[0]
        line = next(line for line in result.out.splitlines() if line.startswith(name))
        assert summary in line
        least, most = artgen.catalog.find(name).joints
        assert f"{least}-{most}" in line.split() or (least == most and str(least) in line.split())


def test_info_names_every_parameter_and_a_sample(artgen_command) -> None:
    result = artgen_command("info", "door")
    assert (result.code, result.err) == (0, "")
    rows = {line.split()[0]: line for line in result.out.splitlines() if line.strip()}
    assert set(artgen.catalog.find("door").parameters()) <= set(rows)
    assert max(map(len, result.out.splitlines())) <= 110
    assert rows["handle.knob_handle.style"].split() == [
        "handle.knob_handle.style",
        *["ball", "|", "flat", "|", "tulip", "|", "egg"],
    ]
    assert "0.86 to 1.12 m" in rows["handle_height"]
    assert re.search(r"door_hinge\w* +revolute 0 to", result.out)
    assert result.out.index("styles, on which other draws depend") < result.out.index("\nparameters:")


def test_info_searches_names_and_descriptions(artgen_command) -> None:
    result = artgen_command("info", "refrigerator", "dispenser")
    lines = [" ".join(line.split()) for line in result.out.splitlines() if line.strip()]
    assert lines[1:] == [
        "name drawn what it is",
        "water P(water | layout=french) = 0.5 whether a door has a water dispenser",
        "P(water | layout=side_by_side) = 0.65",
        "P(water | otherwise) = 0",
    ]


def test_info_shows_the_weights_of_options(artgen_command) -> None:
    text = " ".join(artgen_command("info", "refrigerator", "layout").out.split())
    weights = dict(artgen.catalog.find("refrigerator").own["layout"].distribution.shares())
    assert ", ".join(f"{name} {share:.0%}" for name, share in weights.items()) in text


def test_info_writes_a_picture(artgen_command) -> None:
    assert "handle.png" in artgen_command("info", "handle", "--picture", "handle.png").out
    with Image.open("handle.png") as image:
        assert image.size == (256, 256)


def test_a_picture_of_a_terminal_has_two_pixels_in_each_character() -> None:
    pixels = np.zeros((112, 112, 3), np.uint8)
    pixels[:56] = (255, 0, 0)
    lines = _blocks(pixels).split("\n")
    assert len(lines[0]) == 56
    styles = {str(span.style) for line in lines[:28] for span in line.spans}
    assert "rgb(255,0,0) on rgb(255,0,0)" in styles


@pytest.mark.parametrize("command", ["list", "info", "new"])
def test_a_command_loads_no_module_of_another(command: str) -> None:
    script = (
        f"from artgen.cli import command_line; command_line({command!r}); import sys; print(*sys.modules)"
    )
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True, timeout=60
    )
    loaded = set(done.stdout.split())
    assert not loaded & {
        "artgen.validate",
        "artgen.images",
        "artgen.commands.checks",
        "artgen.view.rendering",
    }


def test_generate_writes_the_same_as_the_library(artgen_command, tmp_path: Path) -> None:
    result = artgen_command("generate", "handle", "--seed", "3", "--format", "urdf,mjcf")
    assert (result.code, result.err) == (0, "")
    assert result.out.split() == ["handle_3/handle_3.urdf", "handle_3/handle_3.xml"]
    directory = artgen.generate("handle", seed=3).export(tmp_path / "same", formats=("urdf", "mjcf"))
    ours = {path.relative_to(directory): path.read_bytes() for path in directory.rglob("*") if path.is_file()}
    written = tmp_path / "handle_3"
    theirs = {path.relative_to(written): path.read_bytes() for path in written.rglob("*") if path.is_file()}
    assert ours == theirs


def test_generate_takes_overrides_base_name_and_place(artgen_command) -> None:
    result = artgen_command(
        *("generate", "door", "--set", "width=0.9", "--set", "thickness=uniform(0.04, 0.041)"),
        *("--base", "free", "--name", "front_door", "--out", "deep/er", "--format", "mjcf"),
    )
    assert (result.code, result.out, result.err) == (0, "deep/er/front_door.xml\n", "")
    data = asset_data(Path("deep/er"))
    assert (data["name"], data["base"], data["parameters"]["width"]) == ("front_door", "free", 0.9)
    assert 0.04 <= data["parameters"]["thickness"] <= 0.041
    assert data["version"] == artgen.__version__


COLLIDES = ("generate", "chest", "--set", "gap=-0.001", "--format", "mjcf")


@pytest.fixture
def chests(monkeypatch):
    monkeypatch.setitem(CATEGORIES, "chest", chest)


@pytest.mark.parametrize(
    ("asked", "code", "message"),
    [
        (
            (),
            2,
            "error: chest: every draw fails alike (5 were tried for seed 0): not proven: 1 of 1 pair fails",
        ),
        (("--on-collision", "fail"), 1, "error: chest_0: not proven: 1 of 1 pair fails"),
        (("--on-collision", "keep"), 0, "warning: not proven: 1 of 1 pair fails"),
        (("--no-certify",), 0, ""),
    ],
)
@pytest.mark.usefixtures("chests")
def test_what_becomes_of_a_collision(artgen_command, tmp_path: Path, asked, code: int, message: str) -> None:
    result = artgen_command(*COLLIDES, *asked)
    assert result.code == code
    assert result.err.startswith(message)
    assert result.err.count("\n") == bool(message)
    if message:
        assert "box and drawer collide at slide=" in result.err
    assert result.out == ("" if code else "chest_0/chest_0.xml\n")
    assert bool(list(tmp_path.iterdir())) == (code == 0)


@pytest.mark.usefixtures("chests")
def test_the_tolerance_has_to_be_proven(artgen_command) -> None:
    chest_of_2_mm = ("generate", "chest", "--set", "gap=0.002", "--format", "mjcf", "--on-collision", "fail")
    assert artgen_command(*chest_of_2_mm, "--tolerance", "0.0015").code == 0
    assert artgen_command(*chest_of_2_mm, "--tolerance", "0.0025").code == 1


def test_a_place_that_cannot_be_written_is_refused(artgen_command, tmp_path: Path) -> None:
    (tmp_path / "taken").write_text("mine")
    for out in ("taken", "taken/deeper"):
        result = artgen_command("generate", "handle", "--format", "urdf", "--out", out)
        assert (result.code, result.err.count("\n")) == (2, 1)
        assert result.err.startswith("error: cannot")
    assert [path.name for path in tmp_path.iterdir()] == ["taken"]
    assert (tmp_path / "taken").read_text() == "mine"


def test_help_and_version(artgen_command) -> None:
    assert artgen_command("--version").out == f"artgen {artgen.__version__}\n"
    for arguments in ((), ("--help",)):
        result = artgen_command(*arguments)
        assert (result.code, result.err) == (0, "")
        assert {"list", "info", "generate"} <= set(result.out.split())
    options = artgen_command("generate", "--help").out
    for option in ("--seed", "--set", "--format", "--out", "--base", "--name"):
        assert option in options
    for option in ("--certify", "--no-certify", "--tolerance", "--on-collision"):
        assert option in options


@pytest.mark.parametrize(
    ("arguments", "code"), [(["--version"], 0), (["list"], 0), (["generate", "dor"], 2), (["--help"], 0)]
)
def test_as_a_process_without_a_warning(arguments: list[str], code: int, tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-W", "error", "-m", "artgen", *arguments],
        capture_output=True,
        text=True,
        check=False,
        cwd=tmp_path,
        timeout=120,
    )
    assert done.returncode == code
    assert "Traceback" not in done.stderr
    assert done.stderr.count("\n") == (1 if code else 0)
    assert bool(done.stdout) == (code == 0)


def test_a_terminal_without_a_character_gets_another_one() -> None:
    done = subprocess.run(
        [sys.executable, "-m", "artgen", "info", "door"],
        capture_output=True,
        check=False,
        env={**os.environ, "PYTHONIOENCODING": "latin-1"},
    )
    assert (done.returncode, done.stderr) == (0, b"")
    assert b"made_to_m?" in done.stdout


def test_generate_as_a_process_without_a_warning(tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-W", "error", "-m", "artgen", "generate", "handle", "--seed", "1"],
        capture_output=True,
        text=True,
        check=False,
        cwd=tmp_path,
        timeout=120,
    )
    assert done.returncode == 0, done.stderr
    assert not done.stderr
    paths = [tmp_path / line for line in done.stdout.splitlines()]
    assert [path.suffix for path in paths] == [".urdf", ".xml", ".usda"]
    assert all(path.is_file() for path in paths)


def test_generate_takes_the_size_of_the_maps(artgen_command, tmp_path) -> None:
    few = artgen_command("generate", "handle", "--no-certify", "--format", "mjcf", "--textures", "none")
    assert few.code == 0
    assert not list(tmp_path.rglob("*.png"))
    wrong = artgen_command("generate", "handle", "--no-certify", "--texture-size", "300", "--out", "other")
    assert wrong.code == 2
    sizes = "256, 512, 1024, 2048 texels on a side"
    assert wrong.err == f"error: textures have {sizes}, not 300; 0 gives plain colors\n"
    assert not (tmp_path / "other").exists()
