"""`artgen colliders`: a table of an export's colliders and others, or JSON."""

import json

import pytest
import typer
from typer.testing import CliRunner

from artgen.cli import main
from artgen.commands.checks import colliders
from artgen.errors import ExportError
from support.trays import tray

pytest.importorskip("coacd")


@pytest.fixture(scope="module")
def exported(tmp_path_factory):
    place = tmp_path_factory.mktemp("exported")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("ARTGEN_CACHE", str(place / "cache"))
        yield tray.generate(certify=False).export(place / "tray", formats=("mjcf",))


@pytest.fixture
def run():
    app = typer.Typer()
    app.command()(colliders)

    def run(*arguments):
        done = CliRunner().invoke(app, [str(argument) for argument in arguments])
        if done.exception and not isinstance(done.exception, SystemExit):
            raise done.exception
        return done

    return run


def test_a_line_for_each_kind(run, exported):
    before = sorted(exported.rglob("*"))
    done = run(exported, "--no-speed")
    assert done.exit_code == 0
    head, *lines = [line.split() for line in done.stdout.splitlines()]
    assert " ".join(head) == (
        "colliders pieces vertices volume error surface error interior kept MuJoCo steps/s"
    )
    assert [line[0] for line in lines] == ["exact", "coacd", "hull"]
    assert lines[0][1] == "(stored)"
    assert lines[2] == ["hull", "4", "32", "113.16%", *lines[2][4:7], "-"]
    assert lines[2][5] == "mm"
    assert sorted(exported.rglob("*")) == before


def test_speed_is_measured_unless_told_otherwise(run, exported):
    pytest.importorskip("mujoco")
    done = run(exported)
    assert all(int(line.split()[-1]) > 0 for line in done.stdout.splitlines()[1:])


def test_json_has_the_links(run, exported):
    done = run(exported, "--json", "--no-speed")
    data = json.loads(done.stdout)
    assert data["asset"] == "tray_0"
    assert [row["kind"] for row in data["colliders"]] == ["exact", "coacd", "hull"]
    assert data["colliders"][2]["links"]["tray"]["pieces"] == 2


def test_a_directory_that_is_no_export_is_refused(run, tmp_path):
    with pytest.raises(ExportError, match="is this a directory that artgen exported"):
        run(tmp_path)


def test_a_category_is_compared_with_fewer_of_its_own(run):
    arguments = ["soap_dispenser", "--seed", "1", "--no-speed", "--json", "--budgets"]
    data = json.loads(run(*arguments, "30,1").stdout)
    exact, thirty, fewest = data["colliders"]
    assert [exact["kind"], thirty["kind"], fewest["kind"]] == ["exact", "30", "fewest"]
    assert exact["pieces"] > thirty["pieces"] == 30 > fewest["pieces"] > 1
    assert exact["volume_error"] < thirty["volume_error"] < fewest["volume_error"]
    refused = run(*arguments, "30;1")
    assert refused.exit_code == 2
    assert "are not whole numbers with commas" in " ".join(refused.stderr.split())


def test_generate_joins_colliders(capsys, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    arguments = ["generate", "soap_dispenser", "--seed", "1", "--format", "mjcf", "--textures", "none"]
    with pytest.raises(SystemExit) as ended:
        main([*arguments, "--colliders", "30", "--out", "fewer"])
    assert not ended.value.code
    data = json.loads((tmp_path / "fewer" / "asset.json").read_text())
    assert data["collision"] == "joined"
    assert sum(len(link["colliders"]) for link in data["links"]) == 30
    assert data["certificate"]["proven"]
    with pytest.raises(SystemExit):
        main([*arguments, "--colliders", "1", "--out", "none"])
    assert "fewest colliders that were found for asset 'soap_dispenser_1' are" in capsys.readouterr().err
    assert not (tmp_path / "none").exists()


def test_generate_writes_other_colliders_and_says_what_is_not_proven(capsys, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    arguments = ["generate", "handle", "--seed", "3", "--format", "mjcf", "--collision", "hull"]
    for more, said in (
        (
            ["--out", "proven"],
            "note: the certificate is of the exact colliders; the export with 'hull' has none",
        ),
        (["--out", "plain", "--no-certify"], ""),
    ):
        with pytest.raises(SystemExit) as ended:
            main([*arguments, *more])
        assert not ended.value.code
        assert capsys.readouterr().err.strip() == said
        data = json.loads((tmp_path / more[1] / "asset.json").read_text())
        assert (data["collision"], data["certificate"]) == ("hull", None)
    with pytest.raises(SystemExit) as ended:
        main(["generate", "handle", "--collision", "boxes"])
    assert ended.value.code == 2
    assert "'exact', 'coacd', 'hull'" in capsys.readouterr().err
