"""Faults in exported files: each edit is found by the check that it concerns, with place and number."""

import re
import runpy
import shutil
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

import artgen
from artgen.asset import Asset
from artgen.validate import validate
from support import injections_files, injections_mjcf, injections_urdf, injections_usd
from support.cases import long
from support.exports import edit_json
from support.injections import FAULTS, Absent, Export, Fault, place

pytest.importorskip("mujoco")

# what the faults are added by
MODULES = (injections_urdf, injections_mjcf, injections_usd, injections_files)
HANDMADE = runpy.run_path(str(Path(__file__).parents[1] / "export/conftest.py"))
MAKERS: dict[str, Callable[[], Asset]] = {
    "handle": lambda: artgen.generate("handle", seed=3, certify=False),
    "cabinet": HANDMADE["make_cabinet"],
    "free_cabinet": lambda: HANDMADE["make_cabinet"](base="free"),
    "door": lambda: artgen.generate("door", seed=7, certify=False),
}
FORMATS = ("urdf", "mjcf", "usd", "glb")


@pytest.fixture(scope="module")
def exports(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Path]:
    """Return a function that exports one of the assets, once."""
    made: dict[str, Path] = {}

    def export(name: str) -> Path:
        if name not in made:
            asset = MAKERS[name]()
            made[name] = asset.export(
                tmp_path_factory.mktemp(name) / asset.name, formats=FORMATS, textures=256
            )
        return made[name]

    return export


def cases() -> Iterator[Any]:
    """Yield each fault with one of the assets: in turn, the door seldom, since it takes longest."""
    names = ("handle", "cabinet", "free_cabinet", "handle", "cabinet", "handle", "door")
    for number, fault in enumerate(FAULTS.values()):
        marks = long if number % 2 else ()
        yield pytest.param(names[number % len(names)], fault, marks=marks, id=fault.name)


def injected(source: Path, directory: Path, fault: Fault) -> tuple[str, str]:
    """Copy an export with a fault; return the link and the joint that must be named."""
    shutil.copytree(source, directory)
    export = Export(directory)
    where = place(fault, export)
    fault.inject(export)
    return where


@pytest.mark.parametrize(("name", "fault"), list(cases()))
def test_fault_is_found(
    name: str, fault: Fault, exports: Callable[[str], Path], tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    try:
        link, joint = injected(exports(name), tmp_path / exports(name).name, fault)
    except Absent:
        link, joint = injected(exports("handle"), tmp_path / "handle" / exports("handle").name, fault)
        tmp_path /= "handle"
    (directory,) = (path for path in tmp_path.iterdir() if (path / "asset.json").exists())
    capfd.readouterr()
    report = validate(directory, behavior=False, checks=[fault.check])
    assert not any(capfd.readouterr()), "a reader printed what a finding should say"
    assert not report.passed
    told = [
        finding
        for finding in report.faults
        if re.search(fault.says, finding.message)
        and link in (finding.link, "")
        and joint in (finding.joint, "")
    ]
    assert told, f"{fault.says} at {link or joint or 'no place'} is not in:\n{report}"


@pytest.mark.parametrize("name", MAKERS)
@pytest.mark.parametrize("textures", [0, 256])
def test_sound_exports_have_no_findings(name: str, textures: int, tmp_path: Path) -> None:
    asset = MAKERS[name]()
    directory = asset.export(tmp_path / asset.name, formats=FORMATS, textures=textures)
    report = validate(directory, checks=["files", "urdf", "mjcf", "usd"])
    assert not [str(finding) for result in report.results for finding in result.findings]
    assert not [result for result in report.results if result.skipped]


LAYOUTS = {"simready": "usd", "partnet-mobility": "urdf", "robocasa": "mjcf"}


@pytest.fixture(scope="module", params=LAYOUTS)
def laid_out(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, str]:
    """Return an export of the handmade cabinet in a layout of its own, and the check of its format."""
    directory = tmp_path_factory.mktemp(request.param) / "it"
    HANDMADE["make_cabinet"]().export(directory, layout=request.param, textures=256)
    return directory, LAYOUTS[request.param]


def test_other_layouts_are_read_with_their_names_and_axes(laid_out: tuple[Path, str]) -> None:
    directory, check = laid_out
    report = validate(directory, checks=["files", check])
    assert not [str(finding) for result in report.results for finding in result.findings]
    assert not [result for result in report.results if result.skipped]
    assert report.results[1].detail.endswith("8 links, 7 joints, 6 poses")


@pytest.mark.parametrize(
    ("field", "value", "says"),
    [
        ("limits", [0.0, 1.1], "its limits are -?[0-9.]+ to [0-9.]+ rad in .*, not 0 to 1.1 rad"),
        ("axis", [0.0, 0.0, 1.0], "its axis differs by 1 in"),
        ("damping", 0.7, "its damping is 0.2 N m s/rad in .*, not 0.7 N m s/rad"),
        ("friction", 0.7, "its friction is 0.1 N m in .*, not 0.7 N m"),
        ("stiffness", 9.0, "its stiffness is 1.5 N m/rad in .*, not 9 N m/rad"),
        ("rest", 0.4, "its rest is -0.3 rad in .*, not 0.4 rad"),
        ("effort", 7.0, "its effort is 40 N m in .*, not 7 N m"),
    ],
)
def test_other_layouts_are_compared_with_the_record(
    laid_out: tuple[Path, str], tmp_path: Path, field: str, value: Any, says: str
) -> None:
    directory, check = shutil.copytree(laid_out[0], tmp_path / "it"), laid_out[1]

    def change(data: Any) -> None:
        next(joint for joint in data["joints"] if joint["name"] == "lid_hinge")[field] = value

    edit_json(directory / "asset.json", change)
    faults = validate(directory, checks=[check]).faults
    assert any(fault.joint == "lid_hinge" and re.match(says, fault.message) for fault in faults), faults


def test_other_layouts_are_compared_in_masses_colliders_and_couplings(
    laid_out: tuple[Path, str], tmp_path: Path
) -> None:
    directory, check = shutil.copytree(laid_out[0], tmp_path / "it"), laid_out[1]

    def change(data: Any) -> None:
        lid = next(link for link in data["links"] if link["name"] == "lid")
        lid["mass"] *= 2.0
        dial = next(link for link in data["links"] if link["name"] == "dial")
        dial["colliders"][0]["size"][0] *= 2.0
        bolt = next(joint for joint in data["joints"] if joint["name"] == "bolt_slide")
        bolt["follows"]["ratio"] *= -1.0
        tray = next(joint for joint in data["joints"] if joint["name"] == "tray_slide")
        tray["pivot"][2] += 0.01

    edit_json(directory / "asset.json", change)
    faults = {
        (fault.link or fault.joint): fault.message for fault in validate(directory, checks=[check]).faults
    }
    assert {"lid", "dial", "bolt_slide", "tray"} <= set(faults)


def test_there_are_faults_of_every_kind() -> None:
    counts = {
        check: sum(fault.check == check for fault in FAULTS.values()) for check in ("files", *FORMATS[:3])
    }
    assert all(count >= 16 for count in counts.values()), counts
    assert len(FAULTS) >= 130
