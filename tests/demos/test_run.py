"""Demonstrations are successful attempts in the order of their seeds; the file is complete or absent."""

import itertools
import json
import shutil
import subprocess
import sys

import numpy as np
import pytest

from artgen import _progress
from artgen.dataset.places import locked
from artgen.dataset.workers import Ending
from artgen.demos import Demo, make_demos, record
from artgen.demos.run import Attempts
from artgen.errors import CheckError, ExportError, ParameterError

h5py = pytest.importorskip("h5py", reason="pip install 'artgen[demos]'")
gymnasium = pytest.importorskip("gymnasium", reason="pip install 'artgen[demos]'")
pytest.importorskip("robosuite", reason="pip install 'artgen[envs]'")


def test_early_endings_wait_for_their_turn(tmp_path, monkeypatch):
    arrived = []

    def swapped(task, items, *, jobs, limit):
        for item in items:
            arrived.append(item ^ 1)
            yield Ending(item ^ 1, "crashed" if item == 3 else "failed", message=f"attempt {item ^ 1}")

    monkeypatch.setattr("artgen.demos.run.run_tasks", swapped)
    attempts = Attempts(tmp_path / "attempts", {}, range(1000), record)
    found = list(itertools.islice(attempts.endings(1), 5))
    assert [each.item for each in found] == [0, 1, 2, 3, 4]
    assert [each.state for each in found] == ["failed", "failed", "crashed", "failed", "failed"]
    assert arrived == [1, 0, 3, 2, 5, 4], "no more attempts are made than are used"
    assert attempts.left()[:3] == [2, 6, 7]


def test_a_demonstration_ends_in_success_and_repeats_with_its_seed():
    first, again = record("OpenDrawer", 3), record("OpenDrawer", 3)
    assert first.success
    assert first.asset == "drawer_3"
    assert first.dones.sum() == first.dones[-1] == 1
    assert np.abs(first.actions).max() <= 1.0
    np.testing.assert_array_equal(first.actions, first.applied)
    assert len(first.observations["state"]) == len(first) + 1
    assert (np.diff(first.states[:, 0]) > 0.0).all()
    for key in ("actions", "rewards", "states"):
        np.testing.assert_array_equal(getattr(first, key), getattr(again, key))


def test_noise_disturbs_the_applied_actions_which_can_be_replayed():
    demo = record("OpenDrawer", 3, noise=0.1)
    moved = (demo.applied - demo.actions)[:, :6]
    assert 0.03 < moved.std() < 0.15
    np.testing.assert_array_equal(demo.applied[:, 6], demo.actions[:, 6])
    env = gymnasium.make("artgen/OpenDrawer-v0", terminate_on_success=False)
    env.reset(seed=3, options={"asset": 3})
    scene = env.unwrapped
    for action, state in zip(demo.applied, demo.states, strict=True):
        now = np.concatenate(([scene.data.time], scene.data.qpos, scene.data.qvel))
        np.testing.assert_array_equal(now, state)
        info = env.step(action)[-1]
    assert info["success"]
    env.close()


@pytest.mark.long
def test_the_file_depends_on_the_seeds_and_not_on_the_processes(tmp_path):
    results = []
    done = make_demos("OpenDrawer", 2, tmp_path / "demos", jobs=2, progress=results.append)
    assert (done.demos, results.count(True), results.count(False)) == (2, 2, len(done.failed))
    with h5py.File(done.file, "r") as file:
        data = file["data"]
        assert json.loads(data.attrs["env_args"])["env_name"] == "artgen/OpenDrawer-v0"
        assert data.attrs["total"] == done.steps
        seeds = [int(data[name].attrs["seed"]) for name in ("demo_0", "demo_1")]
        assert seeds == [seed for seed in range(4) if seed not in done.failed][:2]
        for name, seed in zip(("demo_0", "demo_1"), seeds, strict=True):
            again = record("OpenDrawer", seed)
            np.testing.assert_array_equal(data[name]["actions"][:], again.actions)
            np.testing.assert_array_equal(data[name]["states"][:], again.states)


@pytest.mark.long
def test_an_interrupted_run_continues_and_writes_the_same_bytes(tmp_path):
    whole = make_demos("OpenDrawer", 3, tmp_path / "whole", jobs=2).file

    def stop(succeeded):
        raise KeyboardInterrupt

    folder = tmp_path / "stopped"
    with pytest.raises(KeyboardInterrupt):
        make_demos("OpenDrawer", 3, folder, jobs=2, progress=stop)
    made = {path: path.stat().st_mtime_ns for path in (folder / ".attempts").glob("*.npz")}
    assert made
    assert not (folder / "demo.hdf5").exists()
    (folder / ".attempts" / ".1.99").write_bytes(b"as if it had been writing")
    kept = []

    def look(succeeded):
        kept.append({path: path.stat().st_mtime_ns for path in made if path.exists()})

    again = make_demos("OpenDrawer", 3, folder, jobs=2, progress=look).file
    assert kept[0] == made
    assert again.read_bytes() == whole.read_bytes()
    assert [path.name for path in folder.iterdir() if path.name != ".lock"] == ["demo.hdf5"]


def test_attempts_of_another_plan_are_not_used(tmp_path):
    ending = Ending(3, "done", record("OpenDrawer", 3))
    failed = [Ending(4, "failed", message="no such thing"), Ending(5, "crashed", message="code -9")]

    def attempts(noise):
        return Attempts(tmp_path / "kept", {"noise": noise}, range(10), record)

    first = attempts(0.0)
    assert [first.add(each) for each in (ending, *failed)] == [ending, *failed]
    again = attempts(0.0)
    assert again.left() == [0, 1, 2, *range(5, 10)]  # one that crashed is to be tried again
    assert again.read(4) == failed[0]
    demo = again.read(3).value
    assert (demo.seed, demo.asset, demo.success) == (3, "drawer_3", True)
    for key in ("actions", "applied", "rewards", "dones", "states"):
        np.testing.assert_array_equal(getattr(demo, key), getattr(ending.value, key))
    np.testing.assert_array_equal(demo.observations["state"], ending.value.observations["state"])
    assert attempts(0.1).left() == list(range(10))
    assert [path.name for path in (tmp_path / "kept").iterdir()] == ["plan.json"]


def test_too_many_failures_leave_nothing(tmp_path, monkeypatch):
    def fail(task, items, *, jobs, limit):
        return (Ending(item, "failed", message="Traceback\nEnvError: no drawer") for item in items)

    monkeypatch.setattr("artgen.demos.run.run_tasks", fail)
    message = "succeeded in 0 of 12 attempts, too few for 1 demonstrations; nothing .*: EnvError: no drawer"
    with pytest.raises(CheckError, match=message):
        make_demos("OpenDrawer", 1, tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == [".lock"]


def test_two_runs_do_not_write_to_one_folder(tmp_path):
    with locked(tmp_path), pytest.raises(ExportError, match=r"another run .* writes to .*; wait until it is"):
        make_demos("OpenDrawer", 1, tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == [".lock"]


def test_pictures_are_those_of_the_environment_that_the_file_names(tmp_path):
    file = make_demos("OpenDrawer", 1, tmp_path, image=16, jobs=1).file
    with h5py.File(file) as opened:
        data = opened["data"]
        made = json.loads(data.attrs["env_args"])
        demo = data["demo_0"]
        env = gymnasium.make(made["env_name"], **made["env_kwargs"])
        seed = int(demo.attrs["seed"])
        first, _ = env.reset(seed=seed, options={"asset": seed})
        second, *_ = env.step(demo["applied"][0])
        assert {*first} == {*demo["obs"]} - {"state"} == {"rgb", "hand_rgb", "robot"}
        for key in first:
            np.testing.assert_array_equal(demo["obs"][key][0], first[key])
            np.testing.assert_array_equal(demo["next_obs"][key][0], second[key])
        env.close()


def test_pictures_have_the_sizes_that_environments_allow(tmp_path):
    with pytest.raises(
        ParameterError, match="image, if it is not 0, is a whole number from 16 to 4096, not 15"
    ):
        make_demos("OpenDrawer", 1, tmp_path, image=15)


def test_a_file_of_another_program_stays(tmp_path):
    (tmp_path / "demo.hdf5").write_text("mine")
    with pytest.raises(ExportError, match="holds no demonstrations of artgen/OpenDrawer-v0; choose another"):
        make_demos("OpenDrawer", 1, tmp_path)
    assert (tmp_path / "demo.hdf5").read_text() == "mine"


def test_the_command_reports_a_wrong_task_in_one_line(tmp_path):
    done = subprocess.run(
        [sys.executable, "-m", "artgen", "demos", "OpenDoors", "--out", str(tmp_path / "new")],
        capture_output=True,
        text=True,
        check=False,
        timeout=60,
    )
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.startswith("error: there is no task 'OpenDoors'.")
    assert done.stderr.count("\n") == 1


def test_progress_is_shown_to_a_caller_in_python(tmp_path, monkeypatch, capsys):
    def fail(task, items, *, jobs, limit):
        yield from (Ending(item, "failed", message="no") for item in items)

    monkeypatch.setattr("artgen.demos.run.run_tasks", fail)
    monkeypatch.setattr(_progress, "_INTERVAL", 0.0)
    monkeypatch.setattr(_progress, "_live", lambda: True)
    monkeypatch.setattr(_progress, "_Bar", _progress._Display)
    for shown in (True, False):
        with pytest.raises(CheckError):
            make_demos("OpenDrawer", 2, tmp_path / "new", jobs=1, progress=shown)
        assert ("OpenDrawer 0/2, 3 failed" in capsys.readouterr().err.splitlines()) == shown


def test_a_full_disk_is_one_error_and_leaves_nothing(tmp_path, monkeypatch):
    demo = Demo(0, "a", True, {"state": np.zeros((3, 2))}, *[np.zeros((2, 7))] * 2, *[np.zeros(2)] * 3)

    def succeed(task, items, *, jobs, limit):
        yield from (Ending(item, "done", demo) for item in items)

    monkeypatch.setattr("artgen.demos.run.run_tasks", succeed)
    monkeypatch.setattr("shutil.disk_usage", lambda folder: shutil._ntuple_diskusage(2**30, 2**30, 1000))
    with pytest.raises(ExportError, match=r"demo\.hdf5: No space left on device; nothing was changed"):
        make_demos("OpenDrawer", 1, tmp_path / "new", jobs=1)
    assert not (tmp_path / "new" / "demo.hdf5").exists()
