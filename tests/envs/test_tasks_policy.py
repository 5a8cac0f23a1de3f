"""The scripted policy succeeds, a random one fails, and a door is shut until its lever is turned."""

from dataclasses import replace

import numpy as np
import pytest

from artgen.envs import TASKS, ManipulationEnv
from artgen.envs.policy import ScriptedPolicy, action_towards
from support.cases import some

SEED = 3


def played(env, act):
    while True:
        _, _, terminated, truncated, info = env.step(act())
        if terminated or truncated:
            return info


def test_the_scripted_policy_succeeds_and_a_random_one_fails():
    env = ManipulationEnv("OpenDrawer", range(SEED, SEED + 1))
    env.reset(seed=0)
    policy = ScriptedPolicy(env)
    assert played(env, policy.action)["success"]
    env.reset(seed=0)
    rng = np.random.default_rng(0)
    assert not played(env, lambda: rng.uniform(-1.0, 1.0, 7))["success"]
    env.reset(seed=1)
    assert played(env, policy.action)["success"], "it begins again with the episode"
    env.close()


@pytest.mark.parametrize("name", some(TASKS, 4))
def test_the_scripted_policy_does_every_task(name):
    env = ManipulationEnv(name, range(SEED, SEED + 1))
    env.reset(seed=0)
    info = played(env, ScriptedPolicy(env).action)
    assert info["success"], f"{info['asset']}: {info['progress']} of {env.target.stages}"
    env.close()


def test_the_policy_turns_a_lever_and_keeps_it_while_it_pushes_the_door():
    env = ManipulationEnv("PushDoor", range(SEED, SEED + 1))
    env.reset(seed=0)
    lever, _ = env.target.stages
    assert played(env, ScriptedPolicy(env).action)["success"]
    assert env.q(lever.joint) > lever.goal
    env.close()


def test_the_policy_releases_the_handle_and_reports_its_end():
    env = ManipulationEnv("OpenDrawer", range(SEED, SEED + 1), terminate_on_success=False)
    env.reset(seed=0)
    policy = ScriptedPolicy(env)
    while not policy.done:
        _, _, _, truncated, info = env.step(policy.action())
        assert not truncated
    assert info["success"]
    contact = env.target.moves[0].contact
    link = env.asset.pose({env.target.stages[0].joint: env.q(env.target.stages[0].joint)})[contact.link]
    handle = link @ contact.frame
    assert np.linalg.norm(env.tip()[:3, 3] - handle[:3, 3]) > 0.05, "the hand has gone back"
    env.close()


def pushed(env, force, lever=0.0):
    """Push the leaf at its lock with a force for a second, with the lever held; return how far it opened."""
    model, data = env.model, env.data
    turn, hinge = (model.joint(stage.joint) for stage in env.target.stages)
    arm = np.linalg.norm(env.target.stages[0].affordance.frame[:2, 3] - env.asset.joint(hinge.name).pivot[:2])
    still = np.zeros(7)
    still[6] = 1.0
    for _ in range(20):
        data.qfrc_applied[hinge.dofadr[0]] = force * arm
        data.qfrc_applied[turn.dofadr[0]] = lever
        env.step(still)
    return env.q(hinge.name)


def test_a_door_stays_shut_however_hard_it_is_pushed_until_its_lever_is_turned():
    env = ManipulationEnv("PushDoor", range(SEED, SEED + 1), terminate_on_success=False)
    env.reset(seed=0)
    _, hinge = env.target.stages
    assert pushed(env, 200.0) < 0.1 * hinge.goal
    assert env.reached() == (False, False)
    env.reset(seed=0)
    assert pushed(env, 20.0, lever=4.0) > hinge.goal
    assert env.reached() == (True, True)
    env.close()


def test_a_hand_that_only_pushes_the_leaf_does_not_open_the_door():
    env = ManipulationEnv(replace(TASKS["PushDoor"], seconds=4.0), range(SEED, SEED + 1))
    env.reset(seed=0)
    start = env.target.hand.copy()
    start[:3, 3] += [0.0, 0.6, 0.12]  # through the door, over its lever
    assert not played(env, lambda: action_towards(env.tip(), start, 0.0))["success"]
    assert env.q(env.target.stages[1].joint) < 0.03
    env.close()


def test_an_action_goes_straight_and_at_most_at_full_speed():
    tip, aim = np.eye(4), np.eye(4)
    aim[:3, 3] = [0.3, 0.4, 0.0]
    action = action_towards(tip, aim, 0.08)
    assert action == pytest.approx([0.6, 0.8, 0.0, 0.0, 0.0, 0.0, -1.0])
    aim[:3, 3] = [0.0, 0.0, 0.01]
    assert action_towards(tip, aim, -1.0) == pytest.approx([0.0, 0.0, 0.2, 0.0, 0.0, 0.0, 1.0])


@pytest.mark.parametrize(("task", "output"), [("PressLampButton", "light"), ("TurnStoveKnob", "burner")])
def test_what_a_hand_does_has_its_effect(task, output):
    env = ManipulationEnv(TASKS[task], assets=range(4))
    _, info = env.reset(seed=1)
    assert set(info["outputs"].values()) == {0.0}
    info = played(env, ScriptedPolicy(env).action)
    assert info["success"]
    seen = {name: value for name, value in info["outputs"].items() if name.startswith(output)}
    assert max(seen.values()) > 0.1
    assert sum(value > 0.05 for value in seen.values()) == 1  # no other burner
