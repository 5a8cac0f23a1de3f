"""Tasks in MuJoCo Playground: a held handle, and another asset in each world of one model of MJX.

from mujoco_playground import registry
from artgen.envs import playground

playground.register("OpenDrawer", range(64))
env = registry.load("ArtgenOpenDrawer")

The hand is not modelled. An action is the force with which it pulls the handle, so the drawer or the door
moves as if it were held. Stages, goals and rewards are those of `ManipulationEnv`.
"""

from collections.abc import Iterable, Mapping
from functools import partial
from itertools import pairwise
from typing import Any

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.batch import ASSET_SITE, mjx_worlds
from artgen.catalog import generate
from artgen.envs.env import ACTION, ALONG, BONUS, DENSE, NEAR, RATE
from artgen.envs.motion import Stage, tip_of
from artgen.envs.scene import TIME_STEP
from artgen.envs.stages import frees
from artgen.envs.task import Task, find_task
from artgen.errors import EnvError, ParameterError
from artgen.validate.hands.motion import MOST_FORCE

try:
    import jax
    import mujoco
    from jax import numpy as jnp
    from ml_collections import config_dict
    from mujoco import mjx
    from mujoco_playground import MjxEnv, State, manipulation
except ImportError as error:
    raise EnvError(f"MuJoCo Playground cannot be loaded ({error}): pip install playground") from error

_AJAR = 0.01  # opening of a joint beyond which its latch no longer holds it [rad or m]
_SPEED = 0.5  # factor of speeds in observations, as in `ManipulationEnv`


def register(task: str | Task, seeds: Iterable[int]) -> str:
    """Register a task with assets of some seeds for `registry.load`; return its name, `Artgen` + its own."""
    task = task if isinstance(task, Task) else find_task(task)
    name = f"Artgen{task.name}"
    made = partial(PlaygroundEnv, task, tuple(seeds))
    manipulation.register_environment(name, made, partial(default_config, task))
    return name


def default_config(task: Task) -> Any:
    """Return the default configuration: rates of `ManipulationEnv`, and the largest force of a hand [N]."""
    return config_dict.create(
        ctrl_dt=1.0 / RATE,
        sim_dt=TIME_STEP,
        episode_length=round(task.seconds * RATE),
        action_repeat=1,
        most_force=MOST_FORCE,
    )


class PlaygroundEnv(MjxEnv):  # type: ignore[misc]  # mujoco_playground has no types
    """A task on a handle that is held, with another asset in each world.

    An action has 3 numbers in -1..1: the force on the handle along the axes of the asset, in shares of
    `most_force`. An observation has 10 numbers: position of the handle (3) [m], direction in which it moves
    to the goal (3), progress of the joint, 0-1, its distance to the goal [rad or m] and half its speed
    [rad/s or m/s], and the share of stages that are done.

    `randomize` is the domain randomization function that gives worlds the assets in turn; without it, all
    have the first one. A joint with a latch cannot open until the joint before it frees it.

    Args:
        task: Name of a task, or a task.
        seeds: Seeds of the assets.
        config: Configuration; by default `default_config`.
        config_overrides: Other values of it.

    Raises:
        EnvError: An asset lacks the part, or the assets share none.
        AssetError: A seed does not fit the fixed topology of the category.
    """

    def __init__(
        self,
        task: str | Task,
        seeds: Iterable[int],
        config: Any = None,
        config_overrides: Mapping[str, Any] | None = None,
    ) -> None:
        self.task = task if isinstance(task, Task) else find_task(task)
        super().__init__(config or default_config(self.task), config_overrides)
        options = {"topology": "fixed", "certify": False, **self.task.overrides}
        assets = [generate(self.task.category, seed, **options) for seed in seeds]
        if not assets:
            raise ParameterError(f"{self.task.name} got no seeds; give some, such as range(16)")
        self.worlds, self.stages = mjx_worlds(assets), _shared(self.task, assets)
        self.randomize = self.worlds.randomize
        self._mj_model = self.worlds.model
        self._mj_model.opt.timestep = self.sim_dt
        self._mj_model.opt.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
        self._mjx_model = mjx.put_model(self._mj_model)
        joints = [self._mj_model.joint(stage.joint) for stage in self.stages[0]]
        self._joints = np.array([each.id for each in joints])
        self._qpos = np.array([each.qposadr[0] for each in joints])
        self._dofs = np.array([each.dofadr[0] for each in joints])
        grasps = [stage.affordance for stage in self.stages[0]]
        self._bodies = jnp.array([self._mj_model.body(grasp.link).id for grasp in grasps])
        self._start = jnp.array([[stage.start for stage in each] for each in self.stages])
        self._goal = jnp.array([[stage.goal for stage in each] for each in self.stages])
        pairs = list(zip(assets, self.stages, strict=True))
        # handles in the frames of their links, and positions at which joints free those of the next stages
        self._tips = jnp.array(
            [
                [
                    tip_of(grasp)[:3, 3] - asset.origin(grasp.link)
                    for grasp in (stage.affordance for stage in each)
                ]
                for asset, each in pairs
            ]
        )
        self._freed = jnp.array(
            [[frees(asset, later.joint, one.joint) for one, later in pairwise(each)] for asset, each in pairs]
        )
        self._rest = jnp.array([self._positions(asset) for asset in assets])
        self._active = jnp.array(self.worlds.active)

    def _positions(self, asset: Asset) -> Array:
        """Return MuJoCo's positions of an asset at rest."""
        result: Array = self._mj_model.qpos0.copy()
        for name, position in asset.positions().items():
            if not asset.joint(name).locked:
                result[self._mj_model.joint(name).qposadr[0]] = position
        return result

    def reset(self, rng: Any) -> Any:
        """Return the state of a world with its asset at rest, for any key of JAX."""
        number = self._number()
        data = mjx.make_data(self._mjx_model)
        data = data.replace(qpos=self._rest[number], eq_active=self._active[number])
        data = mjx.kinematics(self._mjx_model, data)
        reached, zero = jnp.zeros(len(self._joints), bool), jnp.zeros(())
        metrics, info = {"success": zero, "progress": zero}, {"reached": reached}
        return State(data, self._observation(data, reached), zero, zero, metrics, info)

    def step(self, state: Any, action: Any) -> Any:
        """Return the state after one action."""
        action = jnp.clip(action, -1.0, 1.0)
        # a wrapper that resets a world keeps its `info`
        before = state.info["reached"] & (state.data.time > 0.0)
        data, _ = jax.lax.scan(
            lambda data, _: (self._substep(data, before, action), None), state.data, None, self.n_substeps
        )
        position = data.qpos[self._qpos]
        progress = self._progress(position)
        now = before | (progress >= 1.0)
        reached = jnp.cumprod(now).astype(bool)  # a stage can be done only after the earlier ones
        success = reached.all()
        value = jnp.where(reached, 1.0, NEAR + ALONG * progress)
        value = jnp.where(jnp.cumprod(jnp.append(True, reached[:-1])), value, 0.0).mean()
        wrong = jnp.isnan(data.qpos).any() | jnp.isnan(data.qvel).any()
        gained = DENSE / self._config.episode_length * (value - ACTION * (action**2).mean()) + BONUS * success
        return state.replace(
            data=data,
            obs=self._observation(data, reached),
            reward=jnp.where(wrong, 0.0, gained),
            done=(success | wrong).astype(float),
            metrics={**state.metrics, "success": success.astype(float), "progress": progress.mean()},
            info={**state.info, "reached": reached},
        )

    def _number(self) -> Any:
        """Return the number of the asset in this world."""
        return self._mjx_model.site_pos[self._mj_model.site(ASSET_SITE).id, 0].astype(int)

    def _substep(self, data: Any, reached: Any, action: Any) -> Any:
        """Return the state after a step of the physics, with the force on the handle of the current stage."""
        number, model = self._number(), self._mjx_model
        stage = self._stage(reached)
        tip, body = self._tip(data, stage), self._bodies[stage]
        force = self._config.most_force * action
        wrench = jnp.concatenate([force, jnp.cross(tip - data.xipos[body], force)])
        data = data.replace(xfrc_applied=jnp.zeros_like(data.xfrc_applied).at[body].set(wrench))
        if len(self._joints) > 1:  # latches hold the later joints
            position = data.qpos[self._qpos]
            free = position[:-1] >= self._freed[number]
            ajar = jnp.abs(position - self._start[number])[1:] > _AJAR
            shut = jnp.repeat(self._start[number][1:, None], 2, axis=1)
            later = self._joints[1:]
            limits = jnp.where((free | ajar)[:, None], model.jnt_range[later], shut)
            model = model.replace(jnt_range=model.jnt_range.at[later].set(limits))
        return mjx.step(model, data)

    def _stage(self, reached: Any) -> Any:
        """Return the number of the current stage, or of the last one if all are done."""
        return jnp.minimum(reached.sum(), len(self._joints) - 1)

    def _tip(self, data: Any, stage: Any) -> Any:
        """Return the position of the handle of a stage, shape (3,) [m]."""
        body = self._bodies[stage]
        return data.xpos[body] + data.xmat[body] @ self._tips[self._number(), stage]

    def _progress(self, position: Any) -> Any:
        start, goal = self._start[self._number()], self._goal[self._number()]
        return jnp.clip((position - start) / (goal - start), 0.0, 1.0)

    def _observation(self, data: Any, reached: Any) -> Any:
        number, model, stage = self._number(), self._mjx_model, self._stage(reached)
        start, goal = self._start[number], self._goal[number]
        ahead, tip, position = jnp.sign(goal - start)[stage], self._tip(data, stage), data.qpos[self._qpos]
        joint = jnp.array(self._joints)[stage]
        body = jnp.array(model.jnt_bodyid)[joint]
        axis = data.xmat[body] @ model.jnt_axis[joint]
        arm = tip - data.xpos[body] - data.xmat[body] @ model.jnt_pos[joint]
        slides = jnp.array(model.jnt_type == mujoco.mjtJoint.mjJNT_SLIDE)[joint]
        toward = ahead * jnp.where(slides, axis, jnp.cross(axis, arm))
        toward /= jnp.maximum(jnp.linalg.norm(toward), 1e-9)
        left, speed = ahead * (goal - position)[stage], _SPEED * ahead * data.qvel[self._dofs][stage]
        progress = self._progress(position)[stage]
        return jnp.concatenate([tip, toward, jnp.stack([progress, left, speed, reached.mean()])])

    @property
    def xml_path(self) -> str:
        """Empty: the model is made in memory."""
        return ""

    @property
    def action_size(self) -> int:
        """Size of an action."""
        return 3

    @property
    def mj_model(self) -> Any:
        """MuJoCo's model of the first asset."""
        return self._mj_model

    @property
    def mjx_model(self) -> Any:
        """MJX's model of the first asset."""
        return self._mjx_model


def _shared(task: Task, assets: Iterable[Asset]) -> list[tuple[Stage, ...]]:
    """Return for each asset the stages of a task, on joints and links that all assets have."""
    found = []
    for asset in assets:
        choices: dict[tuple[tuple[str, str], ...], tuple[Stage, ...]] = {}
        for stages in task.choose(asset, np.random.default_rng(0)):
            choices.setdefault(tuple((each.joint, each.affordance.link) for each in stages), stages)
        found.append(choices)
    common = [each for each in found[0] if all(each in other for other in found)]
    if not common:
        raise EnvError(f"the assets of {task.name} share no joints for it; take other seeds")
    return [choices[common[0]] for choices in found]
