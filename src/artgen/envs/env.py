"""Manipulation tasks as Gymnasium environments: a Panda and an asset, which changes with each episode."""

import math
from collections.abc import Mapping, Sequence
from typing import Any, Literal

import gymnasium
import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.dataset.plan import check_whole
from artgen.envs.motion import ON, Stage, Target, tip_of
from artgen.envs.robot import OPENING
from artgen.envs.scene import CAMERAS, STEPS, TIME_STEP, Pictures, TaskScene
from artgen.envs.task import Assets, Source, Task, compiled_asset, find_task
from artgen.errors import EnvError, ParameterError, nearest

RATE = round(1.0 / (STEPS * TIME_STEP))  # actions per second [1/s]
PROPRIOCEPTION = 30  # size of the observation of the robot only
STATE = PROPRIOCEPTION + 17  # size of the observation of robot and asset
DENSE = 10.0  # largest sum of the rewards of an episode without the bonus
BONUS = 20.0  # reward of success, once
NEAR, ALONG = 0.3, 0.7  # shares of nearness and of progress in the reward of a stage
STEEPNESS = 5.0  # rate of decay of the reward of nearness: a quarter is left at 0.2 m [1/m]
ACTION = 0.05  # cost of an action of 1 in all directions, as a share of all stages
JITTER = 0.02  # deviation of the arm's angles at reset, as in robosuite [rad]

_SPEED = 0.5  # factor of speeds in observations, so that most numbers are within 1
_MOST_TRIES = 50  # unsuitable assets in a row before the reset fails
_OBSERVATIONS = ("state", "rgb")
_NOT_BEGUN = "{} has not begun; call reset() first"


class ManipulationEnv(gymnasium.Env[Any, NDArray[np.float32]]):
    """A Panda that moves the joints of an asset.

    An action has 7 numbers in -1..1, at 20 Hz: a translation of the tip, at most 0.05 m along each world
    axis, a rotation, at most 0.5 rad about each, and the opening of the hand: -1 wide open, 1 closed, with
    force. The world frame is that of the asset.

    Args:
        task: Name of a task, or a task.
        assets: A folder made by `artgen generate`, a `Dataset`, assets, a `range` of seeds, or None for a new
            asset in each episode. Assets that are unsuitable for the task are skipped.
        obs: `state`, numbers of robot and asset, or `rgb`, pictures and numbers of the robot.
        shuffle: Whether each reset takes a random asset. If False, it takes the next one, and a reset with a
            seed continues from the asset at that index, modulo their number.
        terminate_on_success: Whether an episode ends when the task is done.
        size: Pixels per side of the pictures.
        textures: Texels per side of the texture maps in pictures; 0 for plain colors.
        cache_size: Number of compiled assets that the process caches for all its environments; one takes
            about 15 MB.
        layouts_per_asset: Number of variants of the task on each asset: the place of the robot, the pose of
            its hand, and the part to move among several equal ones.
        render_mode: `rgb_array`, so that `render()` returns a picture; None for no pictures.

    Raises:
        EnvError: There are no assets of the task's category, or robosuite or mujoco is not installed.
        ParameterError: The task or an option is unknown or impossible.

    Attributes:
        task: The task.
        steps: Number of actions of an episode.
    """

    metadata: dict[str, Any] = {"render_modes": ["rgb_array"], "render_fps": RATE}  # noqa: RUF012 - Gymnasium's

    def __init__(
        self,
        task: str | Task,
        assets: Source = None,
        *,
        obs: Literal["state", "rgb"] = "state",
        shuffle: bool = True,
        terminate_on_success: bool = True,
        size: int = 128,
        textures: int = 0,
        cache_size: int = 128,
        layouts_per_asset: int = 1,
        render_mode: str | None = None,
    ) -> None:
        self.task = task if isinstance(task, Task) else find_task(task)
        if obs not in _OBSERVATIONS:
            raise ParameterError(f"there are no observations {obs!r}.{nearest(str(obs), _OBSERVATIONS)}")
        if render_mode not in (None, *self.metadata["render_modes"]):
            raise ParameterError(f"there is no render_mode {render_mode!r}; take 'rgb_array' or None")
        check_whole("size", size, 16, 4096)
        check_whole("cache_size", cache_size, 1, 10**6)
        check_whole("layouts_per_asset", layouts_per_asset, 1, 10**6)
        self.assets = Assets(self.task, assets)
        self.render_mode = render_mode
        self.steps = round(self.task.seconds * RATE)
        self._obs, self._shuffle, self._ends = obs, shuffle, terminate_on_success
        self._visual = obs == "rgb" or render_mode is not None
        self._size, self._textures = size, textures
        self._cache_size, self._layouts = cache_size, layouts_per_asset
        self._pictures: Pictures | None = None
        self._next_asset = self._step = 0
        self._scene: TaskScene | None = None
        self._target: Target | None = None
        self._done: list[bool] = []
        self._progress: list[float] = []
        self._handle = np.eye(4)  # pose of the tip at the affordance of the current stage
        self._succeeded = False
        self.action_space = spaces.Box(-1.0, 1.0, (7,), np.float32)
        self.observation_space = _numbers(STATE)
        if obs == "rgb":
            picture = spaces.Box(0, 255, (size, size, 3), np.uint8)
            robot = _numbers(PROPRIOCEPTION)
            self.observation_space = spaces.Dict({"rgb": picture, "hand_rgb": picture, "robot": robot})

    def reset(
        self, *, seed: int | None = None, options: Mapping[str, Any] | None = None
    ) -> tuple[Any, dict[str, Any]]:
        """Begin an episode with another asset.

        Args:
            seed: Seed of all random numbers after this reset.
            options: `asset`: the number of the asset: its index in the folder or list, or its seed.

        Raises:
            EnvError: The chosen asset, or each one that was tried, is unsuitable for the task.
            ParameterError: An option is unknown.
        """
        super().reset(seed=seed)
        if seed is not None:
            self._next_asset = seed
        for name in options or {}:
            if name != "asset":
                raise ParameterError(
                    f"reset has no option {name!r}; its option is 'asset', the number of an asset"
                )
        self._scene, self._target = self._set_up((options or {}).get("asset"))
        jitter = JITTER * self.np_random.uniform(-1.0, 1.0, 7)
        self._scene.place(self._target, self._target.arm + jitter)
        self._step, self._succeeded = 0, False
        self._done = [False] * len(self._target.stages)
        self._progress = [0.0] * len(self._target.stages)
        self._controller = self.asset.controller()
        self._update_progress()
        return self._observation(), self._info()

    def step(self, action: Any) -> tuple[Any, float, bool, bool, dict[str, Any]]:
        """Apply an action; return observation, reward, terminated, truncated and info."""
        scene = self.scene
        try:
            taken = np.asarray(action, float)
        except (TypeError, ValueError):
            taken = np.empty(0)
        if taken.shape != (7,) or not np.isfinite(taken).all():
            raise ParameterError(f"an action of {self.task.name} is 7 finite numbers, got {action!r}")
        scene.act(np.clip(taken, -1.0, 1.0))
        self._step += 1
        self._update_progress()
        first = all(self._done) and not self._succeeded
        self._succeeded |= first
        distance = float(np.linalg.norm(self._handle[:3, 3] - scene.tip()[:3, 3]))
        value = dense(self._progress, self._done, distance)
        gained = reward(value, taken, self.steps, success=first)
        return self._observation(), gained, first and self._ends, self._step >= self.steps, self._info()

    def render(self) -> Any:
        """Return a picture if the render mode is `rgb_array`, shape (size, size, 3); else None."""
        return None if self.render_mode is None else self.picture(self._size, shadows=True)

    def close(self) -> None:
        """Free the model and the renderer."""
        self._close_pictures()
        self._scene = None

    @property
    def scene(self) -> TaskScene:
        """The model and its state.

        Raises:
            EnvError: There was no reset.
        """
        if self._scene is None:
            raise EnvError(_NOT_BEGUN.format(self.task.name))
        return self._scene

    @property
    def target(self) -> Target:
        """The stages of the task on the asset of this episode, and the place of the robot."""
        if self._target is None:
            raise EnvError(_NOT_BEGUN.format(self.task.name))
        return self._target

    @property
    def asset(self) -> Asset:
        """The asset of this episode."""
        return self.scene.asset

    @property
    def model(self) -> Any:
        """MuJoCo's model."""
        return self.scene.model

    @property
    def data(self) -> Any:
        """MuJoCo's state."""
        return self.scene.data

    def tip(self) -> Array:
        """Return the pose of the center between the fingers' pads, shape (4, 4) [m]."""
        return self.scene.tip()

    def q(self, joint: str) -> float:
        """Return the position of a joint of the asset [rad or m]."""
        return self.scene.q(joint)

    def reached(self) -> tuple[bool, ...]:
        """Tell for each stage whether it is done: its joint was at the goal, and still is if it must stay."""
        return tuple(self._done)

    def state(self) -> NDArray[np.float32]:
        """Return the observation of robot and asset, for any setting of `obs`, shape (47,).

        After the 30 numbers of the robot: vector from the tip to the handle (3) [m], x and z axes of the
        handle (6), along which fingers close and the hand approaches, direction of the handle as its joint
        moves to the goal (3), progress of the joint, 0-1, its distance to the goal [rad or m] and its speed
        [rad/s or m/s], whether the contact is a grasp, and the share of stages that are done.
        """
        scene, pose = self.scene, self._handle
        number, stage = self._stage()
        toward, position = np.sign(stage.goal - stage.start), scene.q(stage.joint)
        direction = toward * scene.motion(stage.joint, pose[:3, 3])
        of_asset = [
            pose[:3, 3] - scene.tip()[:3, 3],
            pose[:3, 0],
            pose[:3, 2],
            direction / max(float(np.linalg.norm(direction)), 1e-9),
            [stage.progress(position), toward * (stage.goal - position), toward * scene.speed(stage.joint)],
            [float(stage.affordance.kind == "grasp"), number / len(self._done)],
        ]
        return np.concatenate([self._proprioception(), *of_asset], dtype=np.float32)

    def _proprioception(self) -> NDArray[np.float32]:
        """Return the observation of the robot only, shape (30,).

        In order: angles of the arm (7) [rad], half their speeds (7) [rad/s], vector from base to tip (3) [m],
        x and z axes of the tip (6), half its velocity (3) [m/s], half its angular velocity (3) [rad/s],
        opening of the hand (1), 0-1.
        """
        scene, control, tip = self.scene, self.scene.control, self.scene.tip()
        of_robot = [
            scene.data.qpos[control.at],
            _SPEED * scene.speeds[control.dofs],
            tip[:3, 3] - self.target.base[:3, 3],
            tip[:3, 0],
            tip[:3, 2],
            _SPEED * control.velocity(),
            [scene.opening() / (2.0 * OPENING)],
        ]
        return np.concatenate(of_robot, dtype=np.float32)

    def picture(self, size: int = 256, camera: str = "front", *, shadows: bool = False) -> NDArray[np.uint8]:
        """Return a picture of the current scene, shape (size, size, 3).

        Args:
            size: Pixels per side.
            camera: `front`, next to the robot, or `hand`, on the hand.
            shadows: Whether there are shadows; without a graphics card they take more than twice the time.

        Raises:
            EnvError: The environment was made without pictures.
            ParameterError: There is no such camera.
            RenderError: OpenGL cannot draw without a window.
        """
        if not self._visual:
            raise EnvError("pictures need render_mode='rgb_array' or obs='rgb' when the environment is made")
        if camera not in CAMERAS:
            raise ParameterError(f"there is no camera {camera!r}.{nearest(camera, CAMERAS)}")
        pictures = self._pictures
        if pictures is None or pictures.scene is not self.scene or not pictures.fits((size, size)):
            self._close_pictures()
            pictures = self._pictures = Pictures(self.scene, size)
        return pictures.take(size, camera, shadows=shadows)

    def _close_pictures(self) -> None:
        if self._pictures is not None:
            self._pictures.close()
        self._pictures = None

    def _set_up(self, chosen: int | None) -> tuple[TaskScene, Target]:
        """Return the scene and the target of the chosen or the next suitable asset."""
        reason = ""
        for _ in range(_MOST_TRIES if chosen is None else 1):
            key = chosen
            if key is None and self._shuffle:
                key = self.assets.draw(self.np_random)
            elif key is None:
                key = self.assets.keys[self._next_asset % len(self.assets.keys)]
                self._next_asset += 1
            number = int(self.np_random.integers(self._layouts))
            try:
                found = compiled_asset(
                    self.assets, key, visual=self._visual, textures=self._textures, most=self._cache_size
                )
                target = found.target(number)
            except EnvError as error:
                reason = str(error)
                continue
            if self._scene is not None and self._scene.asset is found.asset:
                return self._scene, target
            return found.scene(), target
        if chosen is not None:
            raise EnvError(reason)
        raise EnvError(
            f"{self.task.name} found no suitable asset in {_MOST_TRIES} draws; the last one: {reason}"
        )

    def _update_progress(self) -> None:
        """Update the outputs and the progress of the stages; one can be done only after the earlier ones."""
        found = self._controller.step([self.scene.q(name) for name in self._controller.dofs], 1.0 / RATE)
        self._outputs = {name: float(value[0]) for name, value in found.items()}
        before = True
        for number, stage in enumerate(self.target.stages):
            position = self.scene.q(stage.joint)
            self._progress[number] = stage.progress(position)
            on = stage.output is None or self._outputs[stage.output] >= ON
            now = (bool(stage.reached(position)) and on) or (self._done[number] and not stage.holds)
            before = self._done[number] = before and now
        affordance = self._stage()[1].affordance
        self._handle = np.asarray(self.scene.pose(affordance.link) @ tip_of(affordance))

    def _stage(self) -> tuple[int, Stage]:
        """Return the current stage, or the last one if all are done, with its number."""
        stages = self.target.stages
        number = self._done.index(False) if False in self._done else len(stages) - 1
        return number, stages[number]

    def _observation(self) -> Any:
        if self._obs == "state":
            return self.state()
        front, hand = (self.picture(self._size, camera) for camera in ("front", "hand"))
        return {"rgb": front, "hand_rgb": hand, "robot": self._proprioception()}

    def _info(self) -> dict[str, Any]:
        return {
            "success": all(self._done),
            "reached": list(self._done),
            "progress": list(self._progress),
            "outputs": dict(self._outputs),
            "asset": self.asset.name,
            "seed": self.asset.seed,
        }


def _numbers(count: int) -> spaces.Space[Any]:
    return spaces.Box(-np.inf, np.inf, (count,), np.float32)


def dense(progress: Sequence[float], done: Sequence[bool], distance: float) -> float:
    """Return the value of a state, 0-1.

    Each stage contributes up to its share of 1: a part for the nearness of the tip, and a part for the
    progress of the joint. A finished stage contributes its full share, a later one nothing, so that the next
    stage never costs reward. `distance` is that from the tip to the handle of the current stage [m].
    """
    if all(done):
        return 1.0
    stage = list(done).index(False)
    current = NEAR * (1.0 - math.tanh(STEEPNESS * distance)) + ALONG * progress[stage]
    return (stage + current) / len(progress)


def penalty(action: Array) -> float:
    """Return the cost of an action, 0-0.05."""
    return ACTION * float(action @ action) / len(action)


def reward(value: float, action: Array, steps: int, *, success: bool) -> float:
    """Return the reward of a step.

    All steps of an episode give at most `DENSE`, so that success is worth more than any delay of it. `value`
    is that of the state after the step, and `success` is true in the first step at which the task is done.
    """
    return DENSE / steps * (value - penalty(action)) + (BONUS if success else 0.0)
