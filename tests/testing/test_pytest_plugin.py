"""The pytest plugin: a test of each asset and check, beside other tests or alone."""

import json
import shutil
import subprocess
import sys

import pytest

from artgen.asset.report import CheckResult, Finding
from artgen.validate import Examination
from support.exports import stand

pytest_plugins = ["pytester"]


@pytest.fixture(scope="session")
def exported(tmp_path_factory):
    directory = tmp_path_factory.mktemp("exported") / "stand_0"
    return stand.generate(0, certify=False).export(directory, formats=("urdf", "mjcf"))


@pytest.fixture
def suite(pytester, exported, monkeypatch):
    """Run pytest in a directory with two assets in `assets` and a test that passes."""
    monkeypatch.setenv("PYTEST_DISABLE_PLUGIN_AUTOLOAD", "1")
    for name in ("stand_0", "other"):
        shutil.copytree(exported, pytester.path / "assets" / name)
    shutil.copytree(exported, pytester.path / "assets" / ".stand_0.previous")
    pytester.makepyfile(test_own="def test_own(): pass")

    def run(*arguments):
        return pytester.runpytest_inprocess("-p", "pytest_artgen", *arguments)

    return run


@pytest.fixture
def judged(monkeypatch):
    """Let some checks find something, and all others nothing."""
    results = {}

    def result(self, check):
        return results.get(check, CheckResult(check))

    monkeypatch.setattr(Examination, "result", result)
    return results


def test_each_asset_and_check_is_a_test(suite, judged):
    done = suite("--artgen", "assets", "-v")
    checks = ["files", "solids", "tree", "colliders", "urdf", "mjcf", "certificate", "grasps", "outputs"]
    checks.append("behavior")
    done.assert_outcomes(passed=2 * len(checks))
    done.stdout.fnmatch_lines([f"assets/other::{check} PASSED*" for check in checks])
    done.stdout.fnmatch_lines([f"assets/stand_0::{check} PASSED*" for check in checks])
    done.stdout.no_fnmatch_line("*previous*")
    done.stdout.no_fnmatch_line("*usd*")  # it was not exported


def test_alone_it_runs_no_other_tests_and_with_paths_both(suite, judged):
    suite("--artgen", "assets/other", "-k", "tree").assert_outcomes(passed=1)
    suite("--artgen", "assets/other", "-k", "tree or own", "test_own.py").assert_outcomes(passed=2)
    suite().assert_outcomes(passed=1)


def test_it_takes_several_directories_and_each_asset_once(suite, judged, pytester):
    done = suite("--artgen", "assets/other", "--artgen", "assets", "--collect-only", "-q", "-k", "tree")
    assert [line for line in done.outlines if "::" in line] == ["assets/other::tree", "assets/stand_0::tree"]


def test_assets_elsewhere_are_named_by_their_whole_path(suite, judged, exported):
    done = suite("--artgen", str(exported), "--rootdir", ".", "--collect-only", "-q", "-k", "tree")
    assert [line for line in done.outlines if "::" in line] == [f"{exported.as_posix()}::tree"]


def test_faults_fail_with_every_finding_and_notes_are_shown(suite, judged):
    judged["tree"] = CheckResult(
        "tree",
        (
            Finding("tree", "floats 3 mm away", link="drawer", value=0.003, hint="weld it"),
            Finding("tree", "has no limits", joint="slide", pose={"slide": 0.1}),
            Finding("tree", "is under tension", severity="note"),
        ),
    )
    judged["urdf"] = CheckResult("urdf", (Finding("urdf", "has one thing to tell", severity="note"),))
    judged["behavior"] = CheckResult("behavior", skipped="needs artgen[sim]")
    done = suite("--artgen", "assets/stand_0", "-rs")
    done.assert_outcomes(failed=1, passed=8, skipped=1)
    done.stdout.fnmatch_lines(
        [
            "*stand_0: tree*",
            "stand_0 fails the check 'tree': 2 faults",
            "  link drawer: floats 3 mm away; weld it",
            "  joint slide: has no limits (at slide=0.1)",
            "*notes*",
            "is under tension",
            "*needs artgen?sim?",
        ]
    )
    assert "FaultsFoundError" not in done.stdout.str()
    assert "Traceback" not in done.stdout.str()


def test_the_real_checks_run(suite, pytester):
    (pytester.path / "assets/other/meshes/body_body_oak.obj").unlink()
    done = suite("--artgen", "assets", "-k", "files or tree or certificate")
    done.assert_outcomes(passed=3, failed=3)
    done.stdout.fnmatch_lines(
        [
            "stand_0 fails the check 'files': 1 fault",  # the asset's name; the directory is `other`
            "  meshes/body_body_oak.obj is missing, which urdf and mjcf need; export the asset again",
            "  there is no certificate: *",
        ]
    )


def test_an_asset_that_cannot_be_read_fails_its_files_alone(suite, pytester):
    (pytester.path / "assets/other/asset.json").write_text("{")
    done = suite("--artgen", "assets/other")
    done.assert_outcomes(failed=1, skipped=7)
    done.stdout.fnmatch_lines(["other fails the check 'files': 1 fault", "  asset.json cannot be read: *"])


@pytest.mark.parametrize("directory", ["nowhere", "assets/other/meshes"])
def test_a_directory_without_assets_is_wrong_use(suite, directory):
    done = suite("--artgen", directory)
    assert done.ret == pytest.ExitCode.USAGE_ERROR
    done.stderr.fnmatch_lines(["ERROR: --artgen: *exported asset*"])


def test_loading_the_plugin_loads_nothing_of_artgen():
    script = (
        "import sys, pytest; before = set(sys.modules); import pytest_artgen;"
        "import json; print(json.dumps(sorted(set(sys.modules) - before)))"
    )
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", script], capture_output=True, text=True, check=True, timeout=60
    )
    loaded = json.loads(done.stdout)
    assert "pytest_artgen" in loaded
    assert not [name for name in loaded if name.startswith(("artgen", "numpy"))]
