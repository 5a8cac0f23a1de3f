"""Tasks in MuJoCo Playground: four assets in the worlds of one model, which move as in MuJoCo."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import Any, NamedTuple

import mujoco
import numpy as np
import pytest

from artgen import batch
from artgen.errors import EnvError, ParameterError

pytest.importorskip("mujoco_playground", reason="pip install playground")

import jax
from mujoco_playground import manipulation, registry, wrapper

from artgen.envs import playground

SEEDS = range(4)
STEPS = 50
FORCE = 0.8  # of the scripted hand, as a share of the largest
HELD = 0.2  # the same, along the way of the first stage

pytestmark = pytest.mark.filterwarnings("ignore::DeprecationWarning")


class Worlds(NamedTuple):
    env: Any
    reset: Callable[[Any], Any]
    step: Callable[[Any, Any], Any]

    def begin(self) -> Any:
        return self.reset(jax.random.split(jax.random.PRNGKey(0), len(SEEDS)))


def made(task: str) -> Worlds:
    env = playground.PlaygroundEnv(task, SEEDS)
    keys = jax.random.split(jax.random.PRNGKey(0), len(SEEDS))
    worlds = wrapper.BraxDomainRandomizationVmapWrapper(env, partial(env.randomize, rng=keys))
    return Worlds(env, jax.jit(worlds.reset), jax.jit(worlds.step))


@pytest.fixture(scope="module")
def drawers() -> Worlds:
    return made("OpenDrawer")


@pytest.fixture(scope="module")
def doors() -> Worlds:
    return made("PushDoor")


def ahead(state: Any) -> Any:
    """Return the direction in which the handle moves to the goal, shape (worlds, 3)."""
    return state.obs[:, 3:6]


def scripted(worlds: Worlds) -> Any:
    """Pull each handle ahead until its world has succeeded once; return which worlds did.

    The hand keeps pressing along the first way, as a lever has to stay down until the leaf moves.
    """
    state = worlds.begin()
    first = np.asarray(ahead(state))
    assert state.obs.shape == (len(SEEDS), worlds.env.observation_size)
    succeeded = np.zeros(len(SEEDS), bool)
    for _ in range(STEPS):
        state = worlds.step(state, FORCE * ahead(state) + HELD * first)
        success = np.asarray(state.metrics["success"]) > 0.0
        assert ((np.asarray(state.done) > 0.0) == success).all()  # no world breaks
        assert (np.asarray(state.reward)[success] > playground.BONUS / 2.0).all()
        assert (np.asarray(state.reward)[~success] < 1.0).all()
        succeeded |= success
    return succeeded


def test_worlds_have_the_masses_and_limits_of_their_assets(drawers: Worlds) -> None:
    env = drawers.env
    model, axes = env.randomize(env.mjx_model, np.zeros((6, 2)))
    for world in range(6):
        asset = env.worlds.assets[world % len(SEEDS)]
        for link in asset.links:
            body = env.mj_model.body(link.name).id
            assert float(model.body_mass[world, body]) == pytest.approx(link.mass, rel=1e-6)
        joint = asset.joint("drawer_slide_0")
        assert model.jnt_range[world, env.mj_model.joint(joint.name).id].tolist() == pytest.approx(
            joint.limits
        )
    assert axes.body_mass == axes.jnt_range == 0
    assert axes.jnt_solref is None
    assert model.jnt_solref.shape == env.mjx_model.jnt_solref.shape


def test_a_scripted_force_opens_four_drawers(drawers: Worlds) -> None:
    assert scripted(drawers).all()


def test_without_force_nothing_moves(drawers: Worlds) -> None:
    state = drawers.begin()
    for _ in range(3):
        state = drawers.step(state, np.zeros((len(SEEDS), 3)))
    assert np.abs(state.metrics["progress"]).max() < 1e-3
    assert np.abs(state.obs[:, 8]).max() < 1e-3
    assert not np.asarray(state.done).any()


def test_drawers_move_as_in_mujoco(drawers: Worlds) -> None:
    env, count = drawers.env, 5
    state = drawers.begin()
    start = np.asarray(ahead(state))
    for _ in range(count):
        state = drawers.step(state, FORCE * start)
    for number, spec in enumerate(batch.specs(env.worlds.assets)):
        model = spec.compile()
        model.opt.timestep, model.opt.integrator = env.sim_dt, mujoco.mjtIntegrator.mjINT_IMPLICITFAST
        model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONTACT
        data = mujoco.MjData(model)
        mujoco.mj_forward(model, data)
        stage = env.stages[number][0]
        body = model.body(stage.affordance.link).id
        offset = np.asarray(env._tips[number, 0])
        for _ in range(count * env.n_substeps):
            force = env._config.most_force * FORCE * start[number]
            arm = data.xpos[body] + data.xmat[body].reshape(3, 3) @ offset - data.xipos[body]
            data.xfrc_applied[body] = [*force, *np.cross(arm, force)]
            mujoco.mj_step(model, data)
        moved = data.qpos[model.joint(stage.joint).qposadr[0]]
        found = state.data.qpos[number, env.mj_model.joint(stage.joint).qposadr[0]]
        assert moved > 0.005
        assert float(found) == pytest.approx(moved, rel=1e-3)


def test_a_latch_holds_doors_until_the_lever_is_turned(doors: Worlds) -> None:
    state = doors.begin()
    hinge = doors.env._qpos[1]
    for _ in range(5):  # against the leaf, at the lever
        state = doors.step(state, np.tile([0.0, 1.0, 0.0], (len(SEEDS), 1)))
    assert np.abs(state.data.qpos[:, hinge]).max() < playground._AJAR
    assert not np.asarray(state.info["reached"]).any()
    assert scripted(doors).all()


def test_a_wrapper_that_keeps_info_begins_again_at_the_first_stage(doors: Worlds) -> None:
    state = doors.begin()
    kept = state.replace(info={"reached": np.ones((len(SEEDS), 2), bool)})
    assert not np.asarray(doors.step(kept, np.zeros((len(SEEDS), 3))).info["reached"]).any()


def test_tasks_are_registered(monkeypatch: pytest.MonkeyPatch) -> None:
    # it would fetch the robots of other environments
    monkeypatch.setattr("mujoco_playground._src.mjx_env.ensure_menagerie_exists", lambda: None)
    assert playground.register("OpenDrawer", range(1)) == "ArtgenOpenDrawer"
    assert "ArtgenOpenDrawer" in manipulation.ALL_ENVS
    assert registry.get_default_config("ArtgenOpenDrawer").episode_length == 200
    env = registry.load("ArtgenOpenDrawer", config_overrides={"most_force": 30.0})
    assert env.action_size == 3
    assert env.dt == pytest.approx(0.05)
    assert env._config.most_force == 30.0


def test_errors_name_the_remedy() -> None:
    with pytest.raises(ParameterError, match=r"OpenDrawer got no seeds"):
        playground.PlaygroundEnv("OpenDrawer", [])
    with pytest.raises(ParameterError, match=r"there is no task 'OpenDraw'"):
        playground.register("OpenDraw", range(2))


def test_assets_must_share_the_joints_of_the_task() -> None:
    task = playground.find_task("OpenDrawer")

    def unlike(asset: Any, rng: np.random.Generator) -> Any:
        for stages in task.choose(asset, rng):
            yield tuple(replace(stage, joint=f"{stage.joint}_{asset.seed}") for stage in stages)

    assets = [playground.generate("drawer", seed, certify=False) for seed in (0, 2)]
    assert len(playground._shared(replace(task, choose=unlike), assets[:1])) == 1
    with pytest.raises(EnvError, match="the assets of OpenDrawer share no joints"):
        playground._shared(replace(task, choose=unlike), assets)
