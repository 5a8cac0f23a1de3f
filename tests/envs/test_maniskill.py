"""Tasks in ManiSkill: registered, stepped on the CPU without a graphics device, with the asset's physics."""

from collections.abc import Iterator
from typing import Any

import gymnasium
import numpy as np
import pytest

from artgen.asset import Asset
from artgen.errors import ParameterError

torch = pytest.importorskip("torch", reason="pip install mani_skill")
pytest.importorskip("mani_skill", reason="pip install mani_skill")

from mani_skill.utils.structs import Pose  # noqa: E402

from artgen.envs import maniskill  # noqa: E402

FORCE = {"OpenDrawer": 30.0, "TurnFaucet": 5.0, "PushToasterLever": 20.0}  # opens the joint [N or N m]


def make(name: str, **options: Any) -> Any:
    return gymnasium.make(
        f"Artgen{name}-v1", obs_mode="state", sim_backend="physx_cpu", render_backend="none", **options
    )


@pytest.fixture(scope="module", params=maniskill.NAMES)
def env(request: pytest.FixtureRequest) -> Iterator[Any]:
    made = make(request.param, assets=[3])
    yield made
    made.close()


def asset_of(env: Any) -> Asset:
    (asset,) = env.unwrapped.asset_list
    return asset


def simulate(env: Any, force: float, steps: int) -> None:
    """Step with a force on one joint of the task after the other, 0 is none; the robot is put aside."""
    task = env.unwrapped
    task.agent.robot.set_pose(Pose.create_from_pq([0.0, -5.0, 0.0]))
    forces = torch.zeros_like(task.asset.qpos)
    for joint, away in zip(task._joint[0], task._goal[0] - task._start[0], strict=True):
        forces[0, joint] = force * torch.sign(away)
        for _ in range(steps):
            task.asset.set_qf(forces)
            task.scene.step()
        task.evaluate()


@pytest.mark.filterwarnings("ignore:__array_wrap__:DeprecationWarning")  # ManiSkill with NumPy 2
def test_each_task_is_registered_and_steps(env: Any) -> None:
    observation, _ = env.reset(seed=0)
    assert env.spec.id in {f"Artgen{name}-v1" for name in maniskill.NAMES}
    after, reward, terminated, truncated, info = env.step(np.zeros(env.action_space.shape, np.float32))
    assert after.shape == observation.shape == (1, *env.observation_space.shape[1:])
    assert torch.isfinite(after).all()
    assert 0.0 <= float(reward) < 1.0
    for each in (info["success"], terminated, truncated):
        assert not each.any()


def test_masses_limits_and_springs_are_those_of_the_asset(env: Any) -> None:
    asset, built = asset_of(env), env.unwrapped.asset._objs[0]
    prefix = f"scene-0-{asset.name}-0_"
    masses = {each.name.removeprefix(prefix): each.mass for each in built.links}
    assert {link.name for link in asset.links} <= masses.keys()
    for link in asset.links[1:]:  # the base is fixed
        assert masses[link.name] == pytest.approx(link.mass, rel=1e-4)
    joints = {each.name.removeprefix(prefix): each for each in built.active_joints}
    assert joints.keys() == {joint.name for joint in asset.joints if not joint.locked}
    for name, each in joints.items():
        joint = asset.joint(name)
        assert each.stiffness == pytest.approx(joint.stiffness, rel=1e-6)
        assert each.damping == pytest.approx(joint.damping, rel=1e-6)
        assert each.drive_target == pytest.approx(joint.rest, abs=1e-6)
        assert each.armature == pytest.approx(joint.armature, abs=1e-6)
        expected = joint.limits or (-np.inf, np.inf)
        np.testing.assert_allclose(each.limits[0], expected, atol=1e-6, err_msg=name)


def test_the_joint_stays_until_a_force_opens_it(env: Any) -> None:
    env.reset(seed=0)
    simulate(env, 0.0, 100)
    assert float(env.unwrapped.progress()) < 0.1  # a handle of a faucet sags: there is no dry friction
    name = env.spec.id.removeprefix("Artgen").removesuffix("-v1")
    simulate(env, FORCE.get(name, 20.0), 400)
    assert env.unwrapped.evaluate()["success"].all()
    env.reset(seed=1)
    assert not env.unwrapped.evaluate()["success"].any()


def test_the_spring_returns_a_toaster_lever() -> None:
    env = make("PushToasterLever", assets=[3])
    env.reset(seed=0)
    simulate(env, 20.0, 200)
    assert env.unwrapped.evaluate()["success"].all()
    simulate(env, 0.0, 200)
    assert float(env.unwrapped.progress()) < 0.01
    env.close()


@pytest.mark.parametrize("name", ["PushDoor", "OpenWindow", "OpenSafe", "LiftBlenderJug"])
def test_the_latch_holds_until_the_lever_turns(name: str) -> None:
    env = make(name, assets=[3])
    env.reset(seed=0)
    task = env.unwrapped
    levers = [each[0, :-1].clone() for each in (task._start, task._goal)]
    task._goal[0, :-1] = levers[0]  # no force on the levers
    simulate(env, 20.0, 200)
    assert float(task._shares()[0, -1]) < 0.05
    task._goal[0, :-1] = levers[1]
    env.reset(seed=0)
    simulate(env, 20.0, 200)
    assert task.evaluate()["success"].all()
    env.close()


@pytest.mark.parametrize("name", ["OpenTrashcan", "TurnHandle"])
def test_followers_keep_the_ratio_to_their_leaders(name: str) -> None:
    env = make(name, assets=[3])
    env.reset(seed=0)
    simulate(env, 20.0, 200)
    asset, task = asset_of(env), env.unwrapped
    prefix = f"scene-0-{asset.name}-0_"
    joints = [each.name.removeprefix(prefix) for each in task.asset._objs[0].active_joints]
    positions = dict(zip(joints, task.asset.qpos[0].tolist(), strict=True))
    followers = [each for each in asset.joints if each.follows]
    assert followers
    for each in followers:
        leader = positions[each.follows.leader]
        assert positions[each.name] == pytest.approx(each.follows.at(leader), rel=0.01, abs=1e-4)
    env.close()


def test_no_seeds_are_refused() -> None:
    with pytest.raises(ParameterError, match=r"assets has no seeds; give some, such as range\(16\)"):
        make("OpenDrawer", assets=[])
