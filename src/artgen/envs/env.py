"""Manipulation tasks as environments of Gymnasium: a Panda and an asset, another one in each episode."""

from collections.abc import Mapping
from typing import Any, Literal

import gymnasium
import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.envs.assets import Assets, Source
from artgen.envs.compiled_assets import ready
from artgen.envs.motion import Stage, Target
from artgen.envs.observing import PROPRIOCEPTION, STATE, handle, proprioception, state
from artgen.envs.pictures import Pictures
from artgen.envs.rewards import dense, reward
from artgen.envs.scene import CAMERAS, STEPS, TIME_STEP, Scene
from artgen.envs.task import TASKS, Task
from artgen.errors import EnvError, ParameterError, nearest

RATE = round(1.0 / (STEPS * TIME_STEP))
"""Actions in a second [1/s]."""

_MOST_TRIES = 50  # assets without the part that are passed over in a row
_SIZES = (16, 4096)  # pixels on a side of a picture
_OBSERVATIONS = ("state", "rgb")
_NOT_BEGUN = "{} has not begun; call reset() first"
JITTER = 0.02  # of the arm's angles at reset, as robosuite has it [rad]


class ManipulationEnv(gymnasium.Env[Any, NDArray[np.float32]]):
    """A Panda that has to move an asset's joints.

    An action has 7 numbers within -1 and 1, at 20 Hz: a shift of the tip, of at most 0.05 m along each axis
    of the world, a turn, of at most 0.5 rad about each, and the opening that the hand takes: -1 wide open,
    1 closed, with force. The world is the asset's own frame.

    Args:
        task: Name of a task, or a task.
        assets: A folder that `artgen generate` made, a `Dataset`, assets, a `range` of seeds, or None to
            draw a new asset for each episode. Assets on which the task cannot be done are passed over.
        obs: `state`, numbers that tell all that matters, or `rgb`, pictures and what the robot feels.
        in_turn: Whether each reset takes the next asset rather than a random one; one with a seed begins
            with the asset at that place, counted round.
        terminate_on_success: Whether an episode ends when the task is done.
        size: Pixels on a side of the pictures.
        textures: Texels on a side of the maps of the asset in pictures; 0 for colours alone.
        scenes: How many assets with their compiled models the process keeps for all its environments, those
            used last; one takes about 15 MB.
        places: How many ways to set the task up are kept of each asset: where the robot stands, the pose of
            its hand, and of several like parts the one to move.
        render_mode: `rgb_array`, so that `render()` returns a picture; None for no pictures.

    Raises:
        EnvError: There are no assets of the task's category, or robosuite or mujoco is not installed.
        ParameterError: The task or an option is unknown or impossible.

    Attributes:
        task: The task.
        asset: The asset of this episode.
        target: What the task means on it.
        steps: How many actions an episode has.
    """

    metadata: dict[str, Any] = {"render_modes": ["rgb_array"], "render_fps": RATE}  # noqa: RUF012 - Gymnasium's

    def __init__(
        self,
        task: str | Task,
        assets: Source = None,
        *,
        obs: Literal["state", "rgb"] = "state",
        in_turn: bool = False,
        terminate_on_success: bool = True,
        size: int = 128,
        textures: int = 0,
        scenes: int = 128,
        places: int = 1,
        render_mode: str | None = None,
    ) -> None:
        self.task = _task(task)
        numbers = {"size": (size, *_SIZES), "scenes": (scenes, 1, 10**6), "places": (places, 1, 10**6)}
        _check_options(obs, numbers, render_mode)
        self.assets = Assets(self.task, assets)
        self.render_mode = render_mode
        self.steps = round(self.task.seconds * RATE)
        self._obs, self._in_turn, self._ends = obs, in_turn, terminate_on_success
        self._visual = obs == "rgb" or render_mode is not None
        self._size, self._textures, self._most = size, textures, scenes
        self._places = places
        self._pictures = Pictures()
        self._turn = self._step = 0
        self._scene: Scene | None = None
        self._target: Target | None = None
        self._done: list[bool] = []
        self._progress: list[float] = []
        self._handle = np.eye(4)
        self._succeeded = False
        self.action_space = spaces.Box(-1.0, 1.0, (7,), np.float32)
        self.observation_space = _observation_space(obs, size)

    def reset(
        self, *, seed: int | None = None, options: Mapping[str, Any] | None = None
    ) -> tuple[Any, dict[str, Any]]:
        """Begin an episode with another asset.

        Args:
            seed: Decides all that follows, if it is given.
            options: `asset`: the number of the asset to take: its place in the folder or list, or its seed.

        Raises:
            EnvError: The asset that was asked for, or every one of the set, lacks what the task is about.
            ParameterError: There is an unknown option.
        """
        super().reset(seed=seed)
        if seed is not None:
            self._turn = seed
        wanted = _wanted_asset(options)
        self._scene, self._target = self._begin(wanted)
        jitter = JITTER * self.np_random.uniform(-1.0, 1.0, 7)
        self._scene.place(self._target, self._target.arm + jitter)
        self._step, self._succeeded = 0, False
        self._done = [False] * len(self._target.stages)
        self._progress = [0.0] * len(self._target.stages)
        self._note()
        return self._observed(), self._info()

    def step(self, action: Any) -> tuple[Any, float, bool, bool, dict[str, Any]]:
        """Let the robot do an action; returns observation, reward, terminated, truncated and info."""
        scene = self.scene
        taken = np.clip(np.asarray(action, float), -1.0, 1.0)
        if taken.shape != (7,) or not np.isfinite(taken).all():
            raise ParameterError(f"an action of {self.task.name} is 7 finite numbers, got {action!r}")
        scene.act(taken)
        self._step += 1
        self._note()
        success = all(self._done)
        first = success and not self._succeeded
        self._succeeded |= success
        distance = float(np.linalg.norm(self._handle[:3, 3] - scene.tip()[:3, 3]))
        worth = dense(self._progress, self._done, distance)
        gained = reward(worth, taken, self.steps, success=first)
        ended = first and self._ends
        return self._observed(), gained, ended, self._step >= self.steps, self._info()

    def render(self) -> Any:
        """Return a picture if the render mode is `rgb_array`, shape (size, size, 3); else None."""
        return None if self.render_mode is None else self.picture(self._size, shadows=True)

    def close(self) -> None:
        """Free the model and the renderer."""
        self._pictures.close()
        self._scene = None

    @property
    def scene(self) -> Scene:
        """The model and its state.

        Raises:
            EnvError: There was no reset yet.
        """
        if self._scene is None:
            raise EnvError(_NOT_BEGUN.format(self.task.name))
        return self._scene

    @property
    def asset(self) -> Asset:
        """The asset of this episode."""
        return self.scene.asset

    @property
    def target(self) -> Target:
        """What the task means on the asset of this episode."""
        if self._target is None:
            raise EnvError(_NOT_BEGUN.format(self.task.name))
        return self._target

    @property
    def model(self) -> Any:
        """MuJoCo's model."""
        return self.scene.model

    @property
    def data(self) -> Any:
        """MuJoCo's state."""
        return self.scene.data

    def tip(self) -> Array:
        """Return the pose of the middle between the fingers' pads, shape (4, 4) [m]."""
        return self.scene.tip()

    def q(self, joint: str) -> float:
        """Return where a joint of the asset stands [rad or m]."""
        return self.scene.q(joint)

    def reached(self) -> tuple[bool, ...]:
        """Tell of each stage whether it is done: its joint was at the goal, or still is if it must stay."""
        return tuple(self._done)

    def state(self) -> NDArray[np.float32]:
        """Return the observation of the state, whatever the environment's observations are."""
        number, stage = self._stage()
        return state(self.scene, self.target.base, stage, self._handle, number / len(self._done))

    def picture(self, size: int = 256, camera: str = "front", *, shadows: bool = False) -> NDArray[np.uint8]:
        """Return a picture of the scene as it is, shape (size, size, 3).

        Args:
            size: Pixels on a side.
            camera: `front`, which looks on, or `hand`, on the hand.
            shadows: Whether things cast shadows; without a graphics card that takes more than twice as long.

        Raises:
            EnvError: The environment was made without pictures.
            ParameterError: There is no such camera.
            RenderError: There is no way to draw without a window.
        """
        if not self._visual:
            raise EnvError("pictures need render_mode='rgb_array' or obs='rgb' when the environment is made")
        if camera not in CAMERAS:
            raise ParameterError(f"there is no camera {camera!r}.{nearest(camera, CAMERAS)}")
        return self._pictures.take(self.scene, size, camera, shadows=shadows)

    def _begin(self, wanted: int | None) -> tuple[Scene, Target]:
        """Return the scene of the next asset that the task can be done on, and what has to be done."""
        reason = ""
        tries = _MOST_TRIES if wanted is None else 1
        for _ in range(tries):
            key = self._next() if wanted is None else wanted
            number = int(self.np_random.integers(self._places))
            try:
                return self._set_up(key, number)
            except EnvError as error:
                reason = str(error)
        if wanted is not None:
            raise EnvError(reason)
        raise EnvError(f"{self.task.name} found no fit asset in {tries} draws; the last one: {reason}")

    def _next(self) -> int:
        """Return the number of the asset whose turn it is."""
        if not self._in_turn:
            return self.assets.draw(self.np_random)
        key = self.assets.keys[self._turn % len(self.assets.keys)]
        self._turn += 1
        return key

    def _set_up(self, key: int, number: int) -> tuple[Scene, Target]:
        """Return an asset's scene and one of the ways to set the task up on it."""
        found = ready(self.assets, key, visual=self._visual, textures=self._textures, most=self._most)
        target = found.target(number)
        if self._scene is not None and self._scene.asset is found.asset:
            return self._scene, target
        return found.scene(), target

    def _note(self) -> None:
        """Note how far the stages are and which are done: one that is not done holds up those after it."""
        before = True
        for number, stage in enumerate(self.target.stages):
            position = self.scene.q(stage.joint)
            self._progress[number] = stage.progress(position)
            now = bool(stage.reached(position)) or (self._done[number] and not stage.holds)
            before = self._done[number] = before and now
        self._handle = handle(self.scene, self._stage()[1])

    def _stage(self) -> tuple[int, Stage]:
        """Return the stage that the robot is at, the last one if all are done, with its number."""
        stages = self.target.stages
        number = self._done.index(False) if False in self._done else len(stages) - 1
        return number, stages[number]

    def _observed(self) -> Any:
        if self._obs == "state":
            return self.state()
        return {
            "rgb": self.picture(self._size),
            "hand_rgb": self.picture(self._size, "hand"),
            "robot": proprioception(self.scene, self.target.base),
        }

    def _info(self) -> dict[str, Any]:
        return {
            "success": all(self._done),
            "reached": list(self._done),
            "progress": list(self._progress),
            "asset": self.asset.name,
            "seed": self.asset.seed,
        }


def _task(task: str | Task) -> Task:
    if isinstance(task, Task):
        return task
    if task not in TASKS:
        raise ParameterError(f"there is no task {task!r}.{nearest(str(task), TASKS)}")
    return TASKS[task]


def _check_options(obs: str, numbers: Mapping[str, tuple[Any, int, int]], render_mode: str | None) -> None:
    if obs not in _OBSERVATIONS:
        raise ParameterError(f"there are no observations {obs!r}.{nearest(str(obs), _OBSERVATIONS)}")
    if render_mode not in (None, *ManipulationEnv.metadata["render_modes"]):
        raise ParameterError(f"there is no render_mode {render_mode!r}; take 'rgb_array' or None")
    for name, (value, low, high) in numbers.items():
        if not isinstance(value, int) or not low <= value <= high:
            raise ParameterError(f"{name} is a whole number from {low} to {high}, not {value!r}")


def _wanted_asset(options: Mapping[str, Any] | None) -> int | None:
    for name in options or {}:
        if name != "asset":
            raise ParameterError(f"reset has no option {name!r}; it knows 'asset', the number of an asset")
    return (options or {}).get("asset")


def _observation_space(obs: str, size: int) -> spaces.Space[Any]:
    if obs == "state":
        return spaces.Box(-np.inf, np.inf, (STATE,), np.float32)
    picture = spaces.Box(0, 255, (size, size, 3), np.uint8)
    robot = spaces.Box(-np.inf, np.inf, (PROPRIOCEPTION,), np.float32)
    return spaces.Dict({"rgb": picture, "hand_rgb": picture, "robot": robot})
