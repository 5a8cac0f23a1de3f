"""`artgen validate`: tables and reports of exported assets, and its exit code."""

import json
import shutil
from dataclasses import replace
from pathlib import Path

import pytest
import typer
from typer.testing import CliRunner

from artgen.asset.report import CheckResult, Finding
from artgen.commands.checks import validate
from artgen.errors import ExportError, ParameterError
from artgen.validate import Examination
from artgen.validate.clients.run import Outcome
from support.exports import stand


@pytest.fixture(scope="session")
def exported(tmp_path_factory):
    directory = tmp_path_factory.mktemp("exported") / "stand_0"
    return stand.generate(0, certify=False).export(directory, formats=("urdf", "mjcf"))


@pytest.fixture
def assets(exported, tmp_path):
    """Return a directory with two assets and other things."""
    for name in ("a", "b", ".a.partial"):
        shutil.copytree(exported, tmp_path / "assets" / name)
    (tmp_path / "assets" / "notes").mkdir()
    (tmp_path / "assets" / "readme.txt").write_text("assets")
    return tmp_path / "assets"


@pytest.fixture
def run():
    app = typer.Typer()
    app.command()(validate)

    def run(*arguments):
        done = CliRunner().invoke(app, [str(argument) for argument in arguments], terminal_width=300)
        if isinstance(done.exception, Exception):
            raise done.exception
        return done

    return run


@pytest.fixture
def judged(monkeypatch):
    """Let some checks find something, and all others nothing."""
    results = {}

    def result(self, check):
        skipped = "not requested" if check == "behavior" and not self._behavior else ""
        return results.get(check, CheckResult(check, detail=f"all of {check}", skipped=skipped))

    monkeypatch.setattr(Examination, "result", result)
    return results


TOUCHES = Finding(
    "certificate",
    "they [collide]",
    link="drawer, body",
    joint="slide",
    value=0.00123456,
    unit="m",
    pose={"slide": 0.1},
    hint="move the pivot",
)


def test_a_sound_asset_has_a_table_and_a_report(run, assets, judged):
    done = run(assets / "a")
    assert done.exit_code == 0
    lines = [" ".join(line.split()) for line in done.output.splitlines()]
    assert lines[0] == f"stand_0 in {assets / 'a'}"
    assert lines[1] == "check result detail"
    assert "solids passed all of solids" in lines
    assert "mjcf passed all of mjcf" in lines
    assert not any(line.startswith("usd") for line in lines)
    report = json.loads((assets / "a/report.json").read_text())
    assert (report["asset"], report["passed"]) == ("stand_0", True)
    assert [result["check"] for result in report["results"]][:2] == ["files", "solids"]
    assert not (assets / "b/report.json").exists()


def test_findings_have_their_link_number_pose_and_hint(run, assets, judged):
    judged["certificate"] = CheckResult("certificate", (TOUCHES,), "1 pair")
    judged["tree"] = CheckResult("tree", (Finding("tree", "is under tension", severity="note"),))
    done = run(assets / "a")
    assert done.exit_code == 1
    lines = [" ".join(line.split()) for line in done.output.splitlines()]
    assert "certificate failed 1 pair; 1 fault" in lines
    assert "tree passed 1 note" in lines
    place = "link drawer, body, joint slide"
    assert f"fault certificate: {place}: they [collide] (at slide=0.1); move the pivot" in lines
    assert "note tree: is under tension" in lines
    assert json.loads((assets / "a/report.json").read_text())["passed"] is False


def test_findings_that_differ_in_numbers_only_are_one_line(run, assets, judged):
    moves = [
        Finding(
            "behavior",
            f"moves by {number / 10} mm",
            f"key_{number}",
            f"press_{number}",
            pose={f"press_{each}": 0.001 * each for each in range(12)},
            hint="add armature",
        )
        for number in range(1, 62)
    ]
    judged["behavior"] = CheckResult("behavior", (*moves, Finding("behavior", "tips over", "base")))
    report = Examination(assets / "a").report(["behavior"])
    near = {f"press_{number}": (-1e-5, 1e-5 if number else 0.01) for number in range(12)}
    pose = ", ".join(f"press_{number}={0.001 * number:g}" for number in range(1, 7))
    such = "such as link key_1, joint press_1: moves by 0.1 mm"
    lines = [
        "behavior  failed  62 faults",
        f"fault behavior: press_* (61 joints), {such} (at {pose}, and 5 other joints); add armature",
        "fault behavior: link base: tips over",
    ]
    assert str(replace(report, near=near)).splitlines() == lines
    assert len(report.to_data()["results"][0]["findings"][0]["pose"]) == 12
    assert "fault behavior: press_* (61 joints), such as link key_1" in run(assets / "a").output


def test_the_range_of_a_joint_tells_what_is_near_rest(exported):
    near = Examination(exported).report(["tree"]).near
    (joint,) = stand.generate(0, certify=False).joints
    low, high = joint.limits
    assert near == {joint.name: pytest.approx((-0.01 * (high - low), 0.01 * (high - low)))}


def test_a_directory_of_assets_is_checked_one_by_one(run, assets, judged):
    done = run(assets)
    assert done.exit_code == 0
    assert f"stand_0 in {assets / 'a'}" in done.output
    assert f"stand_0 in {assets / 'b'}" in done.output
    assert "partial" not in done.output
    assert done.output.rstrip().endswith("0 of 2 assets failed")
    assert all((assets / name / "report.json").exists() for name in ("a", "b"))
    judged["tree"] = CheckResult("tree", (TOUCHES,))
    done = run(assets)
    assert done.exit_code == 1
    assert done.output.rstrip().endswith("2 of 2 assets failed: stand_0, stand_0")


def test_assets_of_a_data_set_are_found_below_its_categories(run, assets, judged):
    (assets / "door").mkdir()
    (assets / "b").rename(assets / "door/b")
    (assets / ".trash/c").mkdir(parents=True)
    (assets / ".trash/c/asset.json").write_text("{}")
    done = run(assets, "--json")
    found = [Path(report["directory"]).relative_to(assets).as_posix() for report in json.loads(done.output)]
    assert found == ["a", "door/b"]


def test_each_asset_is_checked_once(run, assets, judged):
    done = run(assets / "b", assets, assets / "b/../a", "--json")
    assert [Path(report["directory"]).name for report in json.loads(done.output)] == ["b", "a"]


def test_reports_as_json(run, assets, judged):
    judged["certificate"] = CheckResult("certificate", (TOUCHES,))
    done = run(assets / "a", "--json")
    assert done.exit_code == 1
    (report,) = json.loads(done.output)
    assert report.pop("directory") == str(assets / "a")
    assert report == json.loads((assets / "a/report.json").read_text())
    found = next(each for each in report["results"] if each["check"] == "certificate")["findings"]
    assert found == [TOUCHES.to_data()]


@pytest.mark.parametrize(("option", "state"), [("--behavior", "passed"), ("--no-behavior", "skipped")])
def test_the_simulation_can_be_left_out(run, assets, judged, option, state):
    (report,) = json.loads(run(assets / "a", "--json", option).output)
    assert report["results"][-1]["state"] == state


def test_the_real_checks_run_and_a_report_replaces_the_last(run, assets):
    done = run(assets / "a", "--no-behavior")
    assert done.exit_code == 1
    assert "fault certificate: there is no certificate" in done.output
    first = (assets / "a/report.json").read_bytes()
    assert run(assets / "a", "--no-behavior").exit_code == 1
    assert (assets / "a/report.json").read_bytes() == first
    assert [path.name for path in (assets / "a").glob("*report*")] == ["report.json"]


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("nowhere", "there is no directory '.*nowhere'; give one that holds an exported asset"),
        ("notes", "'.*notes' holds no exported asset; `artgen generate CATEGORY -n 10 --out .*` makes"),
        ("readme.txt", "there is no directory '.*readme.txt'"),
    ],
)
def test_wrong_use_is_one_line_and_nothing_is_checked(run, assets, name, message):
    with pytest.raises(ExportError, match=message) as raised:
        run(assets / "a", assets / name)
    assert "\n" not in str(raised.value)
    assert not (assets / "a/report.json").exists()


@pytest.fixture
def asked(monkeypatch):
    """Let clients say what a test wants, and remember how they were asked."""
    answers = {"outcomes": [], "calls": []}

    def run_clients(directory, clients, *, by_name):
        answers["calls"].append((directory, [client.name for client in clients], by_name))
        return answers["outcomes"]

    monkeypatch.setattr("artgen.commands.checks.run_clients", run_clients)
    return answers


GOOD = Outcome("one", "urdf", "1.5", "passed", note="3 things")
GONE = Outcome(
    "two", "usd", "", "absent", (Finding("two", "it is not installed", hint="buy it", severity="note"),)
)
BAD = Outcome(
    "three", "mjcf", "2", "failed", (Finding("three", "it is [bad]", link="lid"), Finding("three", "worse"))
)


def test_without_clients_none_is_asked(run, assets, judged, asked):
    assert run(assets / "a").exit_code == 0
    assert asked["calls"] == []
    assert "clients" not in json.loads((assets / "a/report.json").read_text())


def test_no_name_of_a_client_is_refused(run, assets, judged, asked):
    with pytest.raises(ParameterError, match="'' names no client; give 'all' or some of: mujoco"):
        run(assets / "a", "--clients", "")
    assert asked["calls"] == []


def test_clients_have_a_table_and_stand_in_the_report(run, assets, judged, asked):
    asked["outcomes"] = [GOOD, GONE]
    done = run(assets / "a", "--clients", "all")
    assert done.exit_code == 0
    assert [(directory, by_name) for directory, _, by_name in asked["calls"]] == [(assets / "a", False)]
    lines = [" ".join(line.split()) for line in done.output.splitlines()]
    start = lines.index("client version result first message")
    assert lines[start + 1 : start + 3] == [
        "one 1.5 passed 3 things",
        "two absent it is not installed; buy it",
    ]
    report = json.loads((assets / "a/report.json").read_text())
    assert report["passed"]
    assert [each["state"] for each in report["clients"]] == ["passed", "absent"]


def test_what_a_client_finds_is_a_fault(run, assets, judged, asked):
    asked["outcomes"] = [GOOD, BAD]
    done = run(assets / "a", "--clients", "mujoco,pinocchio")
    assert done.exit_code == 1
    assert asked["calls"] == [(assets / "a", ["mujoco", "pinocchio"], True)]
    lines = [" ".join(line.split()) for line in done.output.splitlines()]
    assert "three 2 failed link lid: it is [bad]" in lines
    assert "fault three: worse" in lines
    done = run(assets / "a", "--clients", "all", "--json")
    assert done.exit_code == 1
    (report,) = json.loads(done.output)
    assert not report["passed"]
    assert report["clients"][1]["findings"][0]["message"] == "it is [bad]"


def test_an_unknown_client_is_named_before_anything_runs(run, assets, judged, asked):
    with pytest.raises(ParameterError, match=r"there is no client 'mujco'\. Did you mean 'mujoco'\?"):
        run(assets / "a", "--clients", "mujco")
    assert not (assets / "a/report.json").exists()
