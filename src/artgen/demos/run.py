"""Demonstrations of the scripted policy in a task, recorded by processes, in the order of their seeds.

`artgen.demos.lerobot` has the layout of LeRobot. That of robomimic is HDF5: a group for each
demonstration, and lists for training and validation.

data              attributes: total, env_args (JSON)
  demo_0          attributes: num_samples, asset, seed
    obs/state     before each step, shape (n, ...); with pictures the observations `rgb` as well
    next_obs/...  after each step
    actions       shape (n, 7), in [-1, 1]
    rewards, dones, states
mask/train, mask/valid    names of demonstrations
"""

import errno
import json
import os
import shutil
import time
from collections.abc import Callable, Generator, Iterable, Iterator, Mapping
from contextlib import closing
from dataclasses import dataclass
from functools import partial
from io import BytesIO
from pathlib import Path
from typing import Any, Literal, get_args

import numpy as np
from numpy.typing import NDArray

from artgen._names import checked_path
from artgen._progress import Update
from artgen._progress import progress as shown_progress
from artgen.dataset.places import Disk, locked
from artgen.dataset.plan import check_whole
from artgen.dataset.workers import Ending, cores, run_job, run_tasks
from artgen.demos.lerobot import is_lerobot, write_lerobot
from artgen.errors import CheckError, EnvError, ExportError, ParameterError, nearest, needed
from artgen.export.files import replaced
from artgen.sampling.distributions import is_number
from artgen.version import __version__

Array = NDArray[Any]

DemoLayout = Literal["robomimic", "lerobot"]
"""A file in the layout of robomimic, or a folder that is a LeRobotDataset."""

DEMO_FILE = "demo.hdf5"  # with all demonstrations
LEROBOT_DIRECTORY = "lerobot"
VALID_EVERY = 10  # every n-th demonstration is for validation

_ATTEMPTS = ".attempts"  # folder of the attempts of an unfinished run
_PLAN = "plan.json"
_LIMIT = 900.0  # time limit for one attempt [s]
_SPARE = 10  # attempts in addition to twice the number of demonstrations
_AFTERWARDS = 40  # most steps after success, in which the hand releases
_ROOM = 2**20  # bytes for tables of the file
_SERIES = ("actions", "applied", "rewards", "dones", "states")
_OBSERVED = "obs/"  # prefix of the names of observations in the file of an attempt
_GYM = 2  # robomimic's type of Gymnasium environments


@dataclass(frozen=True, eq=False)
class Demo:
    """An episode of n steps.

    Attributes:
        seed: Seed of the asset and of all random numbers.
        asset: Name of the asset.
        success: Whether the task succeeded.
        observations: Observations by name, before the first step and after each, shape (n + 1, ...).
        actions: Action of the policy in each step, shape (n, 7), in [-1, 1].
        applied: The actions with noise, shape (n, 7), in [-1, 1].
        rewards: Reward of each step, shape (n,).
        dones: 1 in the last step, else 0, shape (n,).
        states: Time, positions and velocities of MuJoCo before each step, shape (n, m).
    """

    seed: int
    asset: str
    success: bool
    observations: dict[str, Array]
    actions: Array
    applied: Array
    rewards: Array
    dones: Array
    states: Array

    def __len__(self) -> int:
        return len(self.actions)


def _check_task(task: str) -> None:
    """Check that a task exists and the environments are installed."""
    with needed("tasks need the package {error.name}: pip install 'artgen[envs]'", EnvError):
        from artgen.envs.task import find_task
    find_task(task)


def record(task: str, seed: int, *, image: int = 0, noise: float = 0.0) -> Demo:
    """Record one attempt of the scripted policy at a task; it goes on for some steps after success.

    Args:
        task: Name of the task.
        seed: Seed of the asset and of all random numbers.
        image: Pixels per side of the pictures in the observations; 0 for none.
        noise: Standard deviation of the noise on the motion of the arm.

    Raises:
        ParameterError: There is no such task.
        EnvError: The environment cannot be made.
    """
    _check_task(task)
    import gymnasium

    from artgen.envs.policy import ScriptedPolicy

    env = gymnasium.make(f"artgen/{task}-v0", **_arguments(image))
    scene: Any = env.unwrapped

    def with_state(observation: Any) -> dict[str, Array]:
        return {"state": scene.state(), **(observation if image else {})}

    try:
        begin, _ = env.reset(seed=seed, options={"asset": seed})
        policy, rng = ScriptedPolicy(scene), np.random.default_rng((seed, 1))
        states, seen = [_state(scene)], [with_state(begin)]
        actions, applied, rewards = [], [], []
        success, over, left = False, False, _AFTERWARDS
        while not over and left > 0 and not (success and policy.done):
            action = np.clip(policy.action(), -1.0, 1.0).astype(np.float32)
            disturbed = action.copy()  # no noise on the fingers
            disturbed[:6] = np.clip(disturbed[:6] + noise * rng.standard_normal(6), -1.0, 1.0)
            after, reward, ended, truncated, info = env.step(disturbed)
            states.append(_state(scene))
            seen.append(with_state(after))
            actions.append(action)
            applied.append(disturbed)
            rewards.append(float(reward))
            success, over = success or bool(info["success"]), ended or truncated
            left -= success
        name = scene.asset.name
    finally:
        env.close()
    dones = np.zeros(len(actions), np.int64)
    dones[-1] = 1
    observations = {key: np.stack([each[key] for each in seen]) for key in seen[0]}
    series = np.stack(actions), np.stack(applied), np.array(rewards), dones, np.stack(states[:-1])
    return Demo(seed, name, success, observations, *series)


def _state(scene: Any) -> Array:
    """Return the state of the simulation in the order of robosuite."""
    return np.concatenate(([scene.data.time], scene.data.qpos, scene.data.qvel))


def _arguments(image: int) -> dict[str, Any]:
    """Return the arguments of an environment whose observations are recorded."""
    return {"terminate_on_success": False} | ({"obs": "rgb", "size": image} if image else {"obs": "state"})


@dataclass(frozen=True)
class DemoSummary:
    """The result of a run.

    Attributes:
        file: The file that it wrote; a folder for the layout `lerobot`.
        demos: Number of demonstrations.
        steps: Number of their steps in all.
        failed: Reason for each seed without a demonstration.
        seconds: Duration of the run [s].
    """

    file: Path
    demos: int
    steps: int
    failed: dict[int, str]
    seconds: float


def make_demos(
    task: str,
    count: int,
    out: str | Path,
    *,
    seed: int = 0,
    image: int = 0,
    noise: float = 0.0,
    jobs: int | None = None,
    layout: DemoLayout = "robomimic",
    progress: Callable[[bool], None] | bool = True,
) -> DemoSummary:
    """Record successful demonstrations of the scripted policy in a task, each with another asset.

    The bytes of the file depend only on the task, count, seed, image size, noise and layout.

    Args:
        task: Name of the task, such as `OpenDrawer`.
        count: Number of demonstrations.
        out: Folder for `demo.hdf5`, or for the folder `lerobot`, which is complete or absent and replaces
            that of an earlier run of the task. An interrupted run continues from its attempts, which are in
            the folder `.attempts` until the end.
        seed: Seed of the first asset; the others follow.
        image: Pixels per side of the pictures in the observations; 0 for none.
        noise: Standard deviation of a disturbance of the arm's actions, so that demonstrations include
            corrections; `actions` are those of the policy, `applied` the disturbed ones.
        jobs: Number of processes; by default the number of cores.
        layout: `robomimic`, an HDF5 file, or `lerobot`, a LeRobotDataset 3.0 with pictures in its tables.
        progress: Whether to show the progress in a terminal or notebook, or a function that is called after
            each attempt, with its success.

    Raises:
        ParameterError: There is no such task or layout, the folder is no path, or a number is out of its
            range.
        EnvError: A package of the environments is not installed.
        ExportError: A package of the layout is not installed, the file exists and holds no demonstrations of
            the task, or the disk reports an error.
        CheckError: The policy fails too often; nothing is written.
    """
    _check_task(task)
    count = check_whole("count", count, 1, 10_000_000)
    seed, image = check_whole("seed", seed, 0, 2**62), check_whole("image", image, 0, 4096)
    if image:
        check_whole("image, if it is not 0,", image, 16, 4096)
    jobs = check_whole("jobs", cores() if jobs is None else jobs, 1, 10**6)
    if not is_number(noise) or not 0.0 <= noise <= 1.0:
        raise ParameterError(f"noise is a number from 0 to 1, not {noise!r}")
    file = _target(out, layout, task)
    start = time.monotonic()
    succeeded: list[int] = []
    failed: dict[int, str] = {}
    seeds = range(seed, seed + 2 * count + _SPARE)
    plan = {"task": task, "image": image, "noise": noise, "version": __version__}

    def successes(endings: Iterable[Ending], update: Update) -> Iterator[Demo]:
        for ending in endings:
            demo: Demo | None = ending.value
            if demo is not None and demo.success:
                succeeded.append(ending.item)
            else:
                failed[ending.item] = ending.reason if demo is None else "time was over before success"
                demo = None
            if callable(progress):
                progress(demo is not None)
            update(completed=len(succeeded), failed=f"{len(failed)} failed" if failed else "")
            if demo is not None:
                yield demo
            if len(succeeded) == count:
                return

    _make_folder(file.parent)
    with locked(file.parent), replaced(file) as partial_file:
        task_of_seed = partial(record, task, image=image, noise=noise)
        attempts = Attempts(file.parent / _ATTEMPTS, plan, seeds, task_of_seed)
        with (
            closing(attempts.endings(jobs)) as endings,
            shown_progress(task, None if callable(progress) else count, shown=progress is True) as update,
        ):
            demos = successes(endings, update)
            steps = _write(partial_file, demos, task, layout, image)
        if len(succeeded) < count:
            attempts.remove()
            raise CheckError(
                f"the scripted policy of {task} succeeded in {len(succeeded)} of {len(seeds)} attempts, too "
                f"few for {count} demonstrations; nothing was written. The last failure: "
                f"{failed[max(failed)]}"
            )
    attempts.remove()
    return DemoSummary(file, count, steps, failed, time.monotonic() - start)


def _target(out: str | Path, layout: str, task: str) -> Path:
    """Return the file or folder of a layout, which demonstrations of the task may replace."""
    if layout not in get_args(DemoLayout):
        raise ParameterError(f"there is no layout {layout!r}.{nearest(str(layout), get_args(DemoLayout))}")
    file = checked_path(out, "out") / (DEMO_FILE if layout == "robomimic" else LEROBOT_DIRECTORY)
    environment = f"artgen/{task}-v0"
    if not (is_replaceable if layout == "robomimic" else is_lerobot)(file, environment):
        raise ExportError(
            f"{file} exists and holds no demonstrations of {environment}; choose another directory"
        )
    return file


def _write(path: Path, demos: Iterable[Demo], task: str, layout: str, image: int) -> int:
    """Write demonstrations in a layout, and return the number of their steps."""
    from artgen.envs.env import RATE
    from artgen.envs.task import find_task

    environment = f"artgen/{task}-v0"
    if layout == "robomimic":
        return write_demos(path, demos, environment, _arguments(image))
    return write_lerobot(path, demos, environment, find_task(task).doc, RATE)


def _make_folder(folder: Path) -> None:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise ExportError(f"cannot write to {folder}: {error.strerror}; choose another directory") from error


class Attempts:
    """A folder with a file for each attempt of an unfinished run."""

    def __init__(
        self, folder: Path, plan: Mapping[str, Any], seeds: range, task: Callable[[int], Demo]
    ) -> None:
        self.task, self._seeds, self._folder = task, seeds, Disk(folder)
        text = json.dumps(dict(plan), sort_keys=True).encode()
        if self._folder.read(_PLAN) != text:  # attempts of another plan
            if folder.exists():
                shutil.rmtree(folder)
            self._folder.write(_PLAN, text)

    def left(self) -> list[int]:
        """Return the seeds without a file."""
        return [seed for seed in self._seeds if not self._path(seed).exists()]

    def add(self, ending: Ending) -> Ending:
        """Write the file of an attempt; a killed attempt has none, so the next run repeats it."""
        if ending.state in ("done", "failed"):
            content: dict[str, Any] = {"message": np.array(ending.message)}
            demo: Demo | None = ending.value
            if demo is not None:
                content |= {key: np.asarray(getattr(demo, key)) for key in ("asset", "success", *_SERIES)}
                content |= {_OBSERVED + key: each for key, each in demo.observations.items()}
            packed = BytesIO()
            np.savez(packed, allow_pickle=False, **content)
            self._folder.write(self._path(ending.item).name, packed.getvalue())
        return ending

    def read(self, seed: int) -> Ending:
        """Read the ending of an attempt."""
        with np.load(self._path(seed), allow_pickle=False) as content:
            if "asset" not in content:
                return Ending(seed, "failed", message=str(content["message"]))
            names = [key for key in content.files if key.startswith(_OBSERVED)]
            observed = {key.removeprefix(_OBSERVED): content[key] for key in names}
            series = {key: content[key] for key in _SERIES}
            demo = Demo(seed, str(content["asset"]), bool(content["success"]), observed, **series)
            return Ending(seed, "done", demo)

    def endings(self, jobs: int) -> Generator[Ending]:
        """Yield the endings of all attempts in the order of the seeds; missing ones are made."""
        arriving = run_job(self.task, self.left(), self.add, partial(run_tasks, jobs=jobs), limit=_LIMIT)
        killed: dict[int, Ending] = {}
        for seed in self._seeds:
            while seed not in killed and not self._path(seed).exists():
                ending = next(arriving)
                if not self._path(ending.item).exists():
                    killed[ending.item] = ending
            yield killed.get(seed) or self.read(seed)

    def remove(self) -> None:
        """Remove the folder."""
        shutil.rmtree(self._folder.path, ignore_errors=True)

    def _path(self, seed: int) -> Path:
        return self._folder.path / f"{seed}.npz"


def write_demos(path: Path, demos: Iterable[Demo], environment: str, arguments: Mapping[str, Any]) -> int:
    """Write a file of demonstrations, and return the number of their steps."""
    names, total = [], 0
    with _hdf5().File(path, "w", track_order=False) as file:
        data = file.create_group("data")
        for number, demo in enumerate(demos):
            _check_space(path, demo)
            name = f"demo_{number}"
            group = data.create_group(name)
            for key, series in demo.observations.items():
                _put(group, f"obs/{key}", series[:-1])
                _put(group, f"next_obs/{key}", series[1:])
            for key in _SERIES:
                _put(group, key, getattr(demo, key))
            group.attrs["num_samples"] = len(demo)
            group.attrs["asset"] = demo.asset
            group.attrs["seed"] = demo.seed
            total += len(demo)
            names.append(name)
        made = {"env_name": environment, "env_type": _GYM, "env_kwargs": dict(arguments)}
        data.attrs["total"] = total
        data.attrs["env_args"] = json.dumps(made, indent=4)
        valid = names[VALID_EVERY - 1 :: VALID_EVERY]
        for key, some in (("train", [each for each in names if each not in valid]), ("valid", valid)):
            file.create_dataset(f"mask/{key}", data=np.array(some, "S"))
    return total


def _check_space(path: Path, demo: Demo) -> None:
    """Check that a demonstration fits on the disk: HDF5 ends the process where it cannot write."""
    arrays = [getattr(demo, key) for key in _SERIES] + 2 * list(demo.observations.values())
    if shutil.disk_usage(path.parent).free < sum(each.nbytes for each in arrays) + _ROOM:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


def _put(group: Any, key: str, series: Any) -> None:
    """Add an array; pictures are compressed individually."""
    packed = series.ndim == 4  # time, rows, columns and colors
    options = {"chunks": (1, *series.shape[1:]), "compression": "gzip"} if packed and len(series) else {}
    group.create_dataset(key, data=series, **options)


def _hdf5() -> Any:
    with needed("demonstrations are HDF5 files, which need h5py: pip install 'artgen[demos]'"):
        import h5py
    return h5py


def is_replaceable(path: Path, environment: str) -> bool:
    """Tell whether there is no such file, or one with demonstrations in an environment."""
    h5py = _hdf5()
    if not path.exists():
        return True
    try:
        with h5py.File(path, "r") as file:
            return bool(json.loads(file["data"].attrs["env_args"])["env_name"] == environment)
    except (OSError, KeyError, ValueError, TypeError):
        return False
