"""Runs: the same bytes after any interruption, and clear errors."""

import json
import multiprocessing
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest

import artgen.dataset.plan as plans
from artgen.asset import Asset
from artgen.asset.files import ASSET_FILE
from artgen.catalog import find
from artgen.dataset import Dataset, Plan, generate_many
from artgen.dataset.places import PLAN_FILE, Disk, locked
from artgen.dataset.run import MANIFEST_FILE, make
from artgen.errors import ArtgenError, ExportError
from artgen.export.files import write_files
from support.digests import digests

CATEGORIES = ("cabinet", "drawer")
CUBE = """
import artgen as ag

@ag.category(labels="block")
def cube(*, size: ag.Float = ag.uniform(0.1, 0.2)) -> ag.Body:
    return ag.part(ag.box(size, size, size).at(z=size / 2), "block", ag.material("oak"))
"""
PLAN = Plan(CATEGORIES, 5, formats=("mjcf",), texture_size=256)
COMMAND = (*CATEGORIES, "--format", "mjcf", "--texture-size", "256")


def lines(folder: Path) -> list[dict[str, Any]]:
    return [json.loads(line) for line in (folder / MANIFEST_FILE).read_text().splitlines()]


def command(folder: Path, count: int = PLAN.count, *more: str) -> list[str]:
    return [
        *(sys.executable, "-m", "artgen", "generate", *COMMAND),
        *("-n", str(count), "--jobs", "2", "--out", str(folder), *more),
    ]


@pytest.fixture(scope="module")
def undisturbed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A dataset of one process without interruption."""
    folder = tmp_path_factory.mktemp("dataset") / "undisturbed"
    summary = generate_many(PLAN, folder, jobs=1)
    assert (summary.made, summary.existing, summary.failed) == (5, 0, ())
    return folder


def test_the_manifest_lists_the_assets(undisturbed: Path) -> None:
    found = lines(undisturbed)
    assert [each["name"] for each in found] == [item.name for item in PLAN.items()]
    for each in found:
        asset = Asset.load(undisturbed / each["path"])
        assert (asset.name, asset.category, asset.seed) == (each["name"], each["category"], each["seed"])
        assert each["mass"] == pytest.approx(asset.mass)
        assert each["joints"] == {joint.name: joint.kind for joint in asset.joints}
        assert each["parameters"] == asset.parameters
        assert each["proven"] is True
        assert (undisturbed / each["path"] / each["files"]["mjcf"]).is_file()


def test_maps_are_stored_once(undisturbed: Path) -> None:
    maps = [
        path
        for path in undisturbed.rglob("*.png")
        if path.parent.name != "textures" or "meshes" in path.parts
    ]
    store = {path.stat().st_ino: path for path in (undisturbed / "textures").iterdir()}
    assert len(maps) > len(store) > 3
    assert all(path.stat().st_ino in store for path in maps)


@pytest.mark.parametrize("damage", ["bytes", "link"])
def test_a_damaged_shared_map_is_replaced(tmp_path: Path, damage: str) -> None:
    store = tmp_path / "textures"
    store.mkdir()
    write_files({"map.png": b"pixels"}, tmp_path / "first", store)
    (kept,) = store.iterdir()
    if damage == "bytes":
        kept.write_bytes(b"damage")
    else:
        kept.unlink()
        kept.symlink_to("nowhere")
    for name in ("second", "third"):
        write_files({"map.png": b"pixels"}, tmp_path / name, store)
        assert (tmp_path / name / "map.png").read_bytes() == kept.read_bytes() == b"pixels"
        assert (tmp_path / name / "map.png").samefile(kept)
    assert list(store.iterdir()) == [kept]


def test_more_processes_write_the_same(undisturbed: Path, tmp_path: Path) -> None:
    generate_many(PLAN, tmp_path / "more", jobs=3)
    assert digests(tmp_path / "more") == digests(undisturbed)


@pytest.mark.long
def test_a_longer_plan_adds_to_a_shorter_one(undisturbed: Path, tmp_path: Path) -> None:
    folder = tmp_path / "grown"
    assert generate_many(Plan(CATEGORIES, 2, formats=("mjcf",), texture_size=256), folder, jobs=1).made == 2
    summary = generate_many(PLAN, folder, jobs=2)
    assert (summary.made, summary.existing) == (3, 2)
    assert digests(folder) == digests(undisturbed)
    assert generate_many(PLAN, folder).made == 0


@pytest.mark.long
def test_a_killed_worker_is_replaced(undisturbed: Path, tmp_path: Path) -> None:
    killed: list[int] = []

    def kill(record: dict[str, Any]) -> None:
        if len(killed) < 2:
            victim = multiprocessing.active_children()[0]
            killed.append(victim.pid or 0)
            victim.kill()
            victim.join()  # the next record may follow at once, and is to find it gone

    summary = generate_many(PLAN, tmp_path / "killed", jobs=2, progress=kill)
    assert len(set(killed)) == 2
    assert (summary.made, summary.failed) == (5, ())
    assert digests(tmp_path / "killed") == digests(undisturbed)


def test_a_killed_run_continues(undisturbed: Path, tmp_path: Path) -> None:
    folder = tmp_path / "killed"
    run = subprocess.Popen(command(folder), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    deadline = time.monotonic() + 120.0
    while not (folder / MANIFEST_FILE).exists() or not (folder / MANIFEST_FILE).read_text():
        assert run.poll() is None
        assert time.monotonic() < deadline
        time.sleep(0.01)
    run.send_signal(signal.SIGKILL)
    run.wait()
    with (folder / MANIFEST_FILE).open("a") as file:
        file.write('{"name": "handle_1", "categ')  # as if it had been writing
    before = {path: path.stat().st_mtime_ns for path in folder.rglob("asset.json")}
    assert 1 <= len(before) < 5
    done = subprocess.run(command(folder), check=True, capture_output=True, text=True)
    assert f"{len(before)} were there" in done.stdout
    assert digests(folder) == digests(undisturbed)
    assert all(path.stat().st_mtime_ns == at for path, at in before.items() if ".staging" not in path.parts)


def test_interrupted_with_the_keyboard(tmp_path: Path) -> None:
    folder = tmp_path / "stopped"
    # whoever runs the tests may have message its processes to ignore Ctrl-C
    program = (
        "import signal, artgen.cli\n"
        "signal.signal(signal.SIGINT, signal.default_int_handler)\n"
        "artgen.cli.main()"
    )
    arguments = [sys.executable, "-c", program, *command(folder)[3:]]
    run = subprocess.Popen(arguments, stderr=subprocess.PIPE, text=True, start_new_session=True)
    while not (folder / MANIFEST_FILE).exists():
        assert run.poll() is None
        time.sleep(0.01)
    os.killpg(run.pid, signal.SIGINT)
    _, message = run.communicate(timeout=60)
    assert run.returncode == 130
    assert message == "interrupted; finished work stays, and the same command continues the run\n"
    assert not (folder / ".staging").exists()


def test_failed_assets_are_listed_and_the_others_are_made(tmp_path: Path) -> None:
    options: dict[str, Any] = {"tolerance": 5e-4, "on_collision": "fail"}
    plan = Plan(CATEGORIES, 4, formats=("mjcf",), textures="none", **options)
    impossible = {}
    for item in plan.items():
        try:
            find(item.category).generate(item.seed, **options)
        except ArtgenError as error:
            impossible[item.name] = " ".join(str(error).split())
    assert 0 < len(impossible) < 4
    summary = generate_many(plan, tmp_path / "some", jobs=2)
    assert {each["name"]: each["error"] for each in summary.failed} == impossible
    assert summary.made == 4 - len(impossible)
    assert [each["state"] == "failed" for each in lines(tmp_path / "some")] == [
        item.name in impossible for item in plan.items()
    ]
    again = generate_many(plan, tmp_path / "some", jobs=2)
    assert (again.made, again.failed) == (0, summary.failed)


def test_an_unexpected_exception_is_recorded(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def broken(*_: object, **options: object) -> None:
        raise ZeroDivisionError("division by zero")

    monkeypatch.setattr(plans, "encode", broken)
    made = make(next(PLAN.items()), plan=PLAN, place=Disk(tmp_path))
    assert made["error"] == "ZeroDivisionError: division by zero"


def test_two_runs_do_not_write_to_one_folder(undisturbed: Path) -> None:
    before = digests(undisturbed)
    with (
        locked(undisturbed),
        pytest.raises(ExportError, match=f"another run .process {os.getpid()}. writes to .*; wait until"),
    ):
        generate_many(PLAN, undisturbed)
    assert digests(undisturbed) == before


def test_another_plan_is_refused(undisturbed: Path) -> None:
    before = digests(undisturbed)
    other = Plan(CATEGORIES, 5, formats=("mjcf", "usd"), texture_size=256)
    message = (
        "holds a dataset with formats = mjcf, not mjcf,usd: use the same options, or choose another folder"
    )
    with pytest.raises(ExportError, match=message):
        generate_many(other, undisturbed)
    assert digests(undisturbed) == before


def test_a_dataset_of_a_file_continues_until_the_file_changes(tmp_path: Path) -> None:
    file, folder = tmp_path / "cube.py", tmp_path / "set"
    file.write_text(CUBE)
    options: dict[str, Any] = {"formats": ("mjcf",), "textures": "none"}
    assert generate_many(Plan(str(file), 1, **options), folder, jobs=1).made == 1
    again = generate_many(Plan(str(file), 2, **options), folder, jobs=1)
    assert (again.made, again.existing, again.failed) == (1, 1, ())
    assert [each["path"] for each in lines(folder)] == ["cube/cube_0", "cube/cube_1"]
    assert [asset.category for asset in Dataset(folder)] == ["cube", "cube"]
    before = digests(folder)
    file.write_text(CUBE.replace("oak", "steel"))
    message = "holds assets of cube from another text of its file: restore the file, or choose another folder"
    with pytest.raises(ExportError, match=message):
        generate_many(Plan(str(file), 2, **options), folder, jobs=1)
    assert digests(folder) == before


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"plan": {"colour": "red"}}, "is no plan of such a dataset; choose another folder"),
        ({"plan": {"count": 5, "sources": None}}, "is no plan of such a dataset; choose another folder"),
        ({"plan": None}, r"dataset\.json has no version or no plan; choose another folder"),
        ({"version": None}, r"dataset\.json has no version or no plan; choose another folder"),
    ],
)
def test_a_plan_file_of_something_else_is_an_error(
    undisturbed: Path, tmp_path: Path, change: dict[str, Any], message: str
) -> None:
    folder = shutil.copytree(undisturbed, tmp_path / "copy")
    data = json.loads((folder / PLAN_FILE).read_text())
    (folder / PLAN_FILE).write_text(json.dumps(data | change))
    with pytest.raises(ExportError, match=message):
        generate_many(PLAN, folder)


@pytest.mark.parametrize(
    "change", [{"name": "drawer_0"}, {"category": "drawer"}, {"seed": 7}, {"path": "drawer/drawer_0"}]
)
def test_an_edited_line_is_made_again_from_its_asset(
    undisturbed: Path, tmp_path: Path, change: dict[str, Any]
) -> None:
    folder = shutil.copytree(undisturbed, tmp_path / "copy")
    first, *others = lines(folder)
    text = "".join(json.dumps(each) + "\n" for each in (first | change, *others))
    (folder / MANIFEST_FILE).write_text(text)
    assert generate_many(PLAN, folder).made == 0
    assert digests(folder) == digests(undisturbed)


def test_a_dataset_does_not_shrink(undisturbed: Path) -> None:
    message = (
        "holds a dataset of 5 assets, but only 4 are requested; request at least 5, or choose another folder"
    )
    with pytest.raises(ExportError, match=message):
        generate_many(Plan(CATEGORIES, 4, formats=("mjcf",), texture_size=256), undisturbed)


def test_a_folder_with_other_files_is_an_error(tmp_path: Path) -> None:
    (tmp_path / "thesis.tex").write_text("years of work")
    with pytest.raises(ExportError, match=r"it holds 'thesis\.tex' and no dataset; choose another folder"):
        generate_many(PLAN, tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["thesis.tex"]


def test_a_missing_manifest_is_made_again_and_a_damaged_one_is_an_error(
    undisturbed: Path, tmp_path: Path
) -> None:
    folder = shutil.copytree(undisturbed, tmp_path / "copy")
    (folder / MANIFEST_FILE).unlink()
    assert generate_many(PLAN, folder).made == 0
    assert (folder / MANIFEST_FILE).read_bytes() == (undisturbed / MANIFEST_FILE).read_bytes()
    (folder / MANIFEST_FILE).write_text("{what?}\n")
    with pytest.raises(
        ExportError, match=r"line 1 is damaged .*; remove the file, and the next run makes it again"
    ):
        generate_many(PLAN, folder)


@pytest.mark.parametrize("kind", ["folder", "file"])
def test_the_remains_of_an_asset_are_named(undisturbed: Path, tmp_path: Path, kind: str) -> None:
    folder = shutil.copytree(undisturbed, tmp_path / "copy")
    remains = folder / "drawer/drawer_1"
    if kind == "folder":
        (remains / ASSET_FILE).unlink()
    else:
        shutil.rmtree(remains)
        remains.write_text("")
    message = f"{re.escape(str(remains))} cannot be written: it exists, but has no asset.json: remove it; "
    with pytest.raises(ExportError, match=message):
        generate_many(PLAN, folder, jobs=1)


@pytest.mark.long
def test_the_clock_does_not_matter(
    undisturbed: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The clock is set back by an hour during the run: no waiting, and no times in the files."""
    real = time.time

    def back(_: dict[str, Any]) -> None:
        monkeypatch.setattr(time, "time", lambda: real() - 3600.0)

    summary = generate_many(PLAN, tmp_path / "late", jobs=2, progress=back)
    assert 0.0 < summary.seconds < 600.0
    assert digests(tmp_path / "late") == digests(undisturbed)


def mounted(script: str, folder: Path) -> subprocess.CompletedProcess[str]:
    """Run a script that may mount file systems at a folder; skip if the system does not allow it."""
    if not sys.platform.startswith("linux") or shutil.which("unshare") is None:
        pytest.skip("needs Linux's namespaces")
    inside = ["unshare", "--map-root-user", "--mount", "sh", "-c"]
    if subprocess.run(
        [*inside, f"mount -t tmpfs tmpfs {folder}"], capture_output=True, check=False
    ).returncode:
        pytest.skip("this system lets nobody mount")
    return subprocess.run([*inside, script], capture_output=True, text=True, check=False)


@pytest.mark.long
def test_a_run_ends_at_a_full_disk_and_continues_later(undisturbed: Path, tmp_path: Path) -> None:
    disk, copy = tmp_path / "disk", tmp_path / "copy"
    disk.mkdir()
    run = " ".join(command(disk / "set"))
    done = mounted(
        f"mount -t tmpfs -o size=900k tmpfs {disk} && {run}; echo code $?; "
        f"mount -o remount,size=200m {disk} && {run} && cp -a {disk}/set {copy}",
        disk,
    )
    message = "No space left on device; finished work stays, and the same command continues the run\n"
    assert f": {message}" in done.stderr  # at an asset of a worker, or at a line of the manifest
    assert "code 2\n" in done.stdout
    assert done.returncode == 0, done.stderr
    assert digests(copy) == digests(undisturbed)


def test_a_folder_that_cannot_be_written_is_named(tmp_path: Path) -> None:
    disk = tmp_path / "disk"
    disk.mkdir()
    done = mounted(f"mount -t tmpfs -o ro tmpfs {disk} && {' '.join(command(disk / 'set'))}", disk)
    assert done.returncode == 2
    assert done.stderr.startswith(f"error: cannot write to {disk}/set: Read-only file system; ")
