"""`artgen export`: an exported asset again, in another layout or other formats."""

import json
from pathlib import Path

import pytest

import artgen
from artgen.export import LAYOUTS


@pytest.fixture(scope="module")
def exported(tmp_path_factory: pytest.TempPathFactory) -> Path:
    asset = artgen.generate("handle", seed=3, certify=False)
    return asset.export(tmp_path_factory.mktemp("exports") / asset.name, textures=256)


def record(directory: Path) -> dict[str, object]:
    return json.loads((directory / "asset.json").read_text())


@pytest.mark.parametrize("layout", LAYOUTS)
def test_an_export_is_written_again_in_every_layout(artgen_command, exported, tmp_path, layout):
    done = artgen_command(
        "export", str(exported), "--layout", layout, "--texture-size", "256", "--out", str(tmp_path / "x")
    )
    assert done.code == 0, done.err
    data = record(tmp_path / "x")
    assert data["layout"] == layout
    assert list(data["formats"]) == list(LAYOUTS[layout].default_formats)
    printed = [Path(line) for line in done.out.splitlines()]
    assert printed == [tmp_path / "x" / each["main"] for each in data["formats"].values()]
    assert all(path.is_file() for path in printed)
    assert data["seed"] == 3


def test_the_flat_layout_again_says_the_same(artgen_command, exported, tmp_path):
    done = artgen_command("export", str(exported), "--texture-size", "256", "--out", str(tmp_path / "x"))
    assert done.code == 0, done.err
    before, after = (record(directory) for directory in (exported, tmp_path / "x"))
    assert after["formats"] == before["formats"]
    assert after["links"] == before["links"]


def test_formats_are_chosen(artgen_command, exported, tmp_path):
    done = artgen_command(
        "export", str(exported), "--format", "glb,mjcf", "--texture-size", "0", "--out", str(tmp_path / "x")
    )
    assert done.code == 0, done.err
    assert list(record(tmp_path / "x")["formats"]) == ["glb", "mjcf"]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--layout", "simredy"], "there is no layout 'simredy'. Did you mean 'simready'?"),
        (["--format", "usdz"], "there is no format 'usdz'. Did you mean 'usd'?"),
        (["--layout", "simready", "--format", "urdf"], "the layout 'simready' has no 'urdf'; it holds usd"),
        (["--format", ","], "names no format; choose from urdf, mjcf, usd, glb"),
        (["--texture-size", "300"], "300"),
    ],
)
def test_wrong_input_is_one_line_and_writes_nothing(artgen_command, exported, tmp_path, arguments, message):
    done = artgen_command("export", str(exported), *arguments, "--out", str(tmp_path / "x"))
    assert done.code == 2
    assert done.out == ""
    (line,) = done.err.splitlines()
    assert line.startswith("error: ")
    assert message in line
    assert not (tmp_path / "x").exists()


@pytest.mark.parametrize("file", ["", "asset.json"])
def test_an_export_is_not_written_over_itself(artgen_command, exported, file):
    before = record(exported)
    done = artgen_command("export", str(exported / file), "--layout", "flat", "--out", str(exported))
    assert done.code == 2
    assert "to itself: its surfaces are read from there; choose another --out" in done.err
    assert record(exported) == before


def test_what_is_no_export_is_refused(artgen_command, tmp_path):
    done = artgen_command("export", str(tmp_path), "--out", str(tmp_path / "x"))
    assert done.code == 2
    assert "asset.json" in done.err
