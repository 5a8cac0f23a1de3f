"""Tasks: their parts on assets, and reachability for a Panda."""

import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest

import artgen
from artgen.asset.affordance import GRIPPER
from artgen.envs.motion import Stage, lifted
from artgen.envs.robot import LIMITS, frames
from artgen.envs.stages import by_lever, by_output, found, one_joint
from artgen.envs.task import TASKS, push_door
from artgen.errors import EnvError, ParameterError

SEED = 4
OF_OUTPUTS = list(TASKS)[list(TASKS).index("TurnOnLamp") :]


@pytest.fixture(scope="module")
def assets():
    kept = {}

    def asset(name):
        if name not in kept:
            kept[name] = TASKS[name].generate(SEED)
        return kept[name]

    return asset


@pytest.mark.parametrize("name", TASKS)
def test_every_task_finds_its_parts_on_its_assets(name, assets):
    task, asset = TASKS[name], assets(name)
    stages = next(iter(task.choose(asset, np.random.default_rng(0))))
    assert asset.category == task.category
    assert task.doc.endswith(".")
    free = {joint.name for joint in asset.free_joints}
    q = dict(asset.positions())
    for stage in stages:
        low, high = asset.joint(stage.joint).limits
        assert stage.joint in free
        assert stage.start == q[stage.joint] != stage.goal
        assert low <= stage.goal <= stage.moves[-1].until <= high
        assert stage.affordance in asset.affordances
        assert stage.joint in stage.affordance.joints
        q[stage.joint] = stage.goal
    assert not asset.blocked({name: q[name] for name in free}), (
        "the goals of all stages are possible together"
    )


def test_the_lever_of_a_door_is_turned_until_the_latch_is_free(assets):
    door = assets("PushDoor")
    lever, hinge = next(iter(push_door(door, np.random.default_rng(0))))
    assert lever.goal >= 0.3
    assert not door.blocked({lever.joint: lever.goal, hinge.joint: 0.02})
    assert door.blocked({lever.joint: 0.5 * lever.goal, hinge.joint: 0.02}) == (hinge.joint,)
    assert hinge.moves[0].contact is None, "the hand keeps the lever while it pushes"


def test_the_key_of_a_safe_frees_its_handle_which_frees_its_door(assets):
    task, safe = TASKS["OpenSafe"], assets("OpenSafe")
    key, handle, door = next(iter(task.choose(safe, np.random.default_rng(0))))
    assert key.affordance is not handle.affordance is door.affordance
    assert safe.blocked({handle.joint: handle.goal}) == (handle.joint,)
    assert not safe.blocked({key.joint: key.goal, handle.joint: handle.goal})
    assert safe.blocked({key.joint: key.goal, door.joint: 0.02}) == (door.joint,)
    keypad = artgen.generate("safe", 0, certify=False, style="home", lock="keypad")
    with pytest.raises(EnvError, match=r"'safe_0' of category 'safe' has nothing for OpenSafe: Turn the key"):
        task.target(keypad, np.random.default_rng(0))


@pytest.mark.parametrize("name", ["OpenDrawer", "OpenTrashcan", "OpenMicrowave"])
def test_the_robot_begins_at_the_pose_of_its_hand_in_front_of_the_contact(name, assets):
    asset = assets(name)
    target = TASKS[name].target(asset, np.random.default_rng(1))
    assert (target.arm > LIMITS[:, 0]).all()
    assert (target.arm < LIMITS[:, 1]).all()
    assert np.allclose(target.base @ frames(target.arm[None])[0, 7], target.hand, atol=1e-9)
    assert np.allclose(target.base[2, :3], [0, 0, 1]), "the base is upright"
    assert (target.base[2, 3] < 0.0) == TASKS[name].raised, "the base is below the table"
    contact = target.moves[0].contact
    begin = lifted(contact.frame, -contact.back)
    assert np.linalg.norm(target.hand[:3, 3] - begin[:3, 3]) < 0.15
    assert target.hand[:3, 2] @ contact.frame[:3, 2] > 0.99
    low, high = asset.bounds()[:, :2]
    there = target.base[:2, 3]
    assert ((there < low) | (there > high)).any(), "the base is next to the asset"


def test_the_same_draw_gives_the_same_target(assets):
    asset, task = assets("OpenDrawer"), TASKS["OpenDrawer"]
    first, again, other = (task.target(asset, np.random.default_rng(seed)) for seed in (5, 5, 6))
    assert np.array_equal(first.arm, again.arm)
    assert np.array_equal(first.base, again.base)
    assert not np.array_equal(first.arm, other.arm)


def test_a_push_is_made_with_the_ends_of_the_fingers(assets):
    asset = assets("PushToasterLever")
    stage = next(iter(TASKS["PushToasterLever"].choose(asset, np.random.default_rng(0))))[0]
    ends = lifted(stage.moves[0].contact.frame, GRIPPER.tip)
    assert np.allclose(ends, stage.affordance.frame)


def test_the_error_for_a_missing_part_lists_the_existing_ones(assets):
    with pytest.raises(EnvError, match=r"'drawer_4' of category 'drawer' has no pedal that a hand can push"):
        TASKS["OpenTrashcan"].target(assets("OpenDrawer"), np.random.default_rng(0))
    with pytest.raises(EnvError, match=r"it has these grasps and pushes: drawer_handle_grasp_0"):
        found(assets("OpenDrawer"), "pedal", "push", "revolute")


@pytest.mark.parametrize("name", OF_OUTPUTS)
def test_the_goals_of_controls_switch_the_output_on_and_smaller_motions_do_not(name, assets):
    asset = assets(name)
    *before, last = next(iter(TASKS[name].choose(asset, np.random.default_rng(0))))
    assert last.output in [each.name for each in asset.outputs]
    assert [stage.output for stage in before] == [None] * len(before)

    def switched(*positions):
        controller, q = asset.controller(), asset.positions()
        value = controller.step([q[joint] for joint in controller.dofs], 0.1)
        for joint, position in positions:
            moved = {**q, joint: position}
            value = controller.step([moved[each] for each in controller.dofs], 0.1)
            if joint != last.joint:  # the hand leaves it
                q = q if asset.joint(joint).stiffness else moved
                controller.step([q[each] for each in controller.dofs], 0.1)
        return bool(value[last.output][0] >= 0.3)

    goals = [(stage.joint, stage.goal) for stage in (*before, last)]
    assert switched(*goals)
    assert not switched(*goals[:-1], (last.joint, last.start + 0.25 * (last.goal - last.start)))
    if before:
        assert not switched(goals[-1]), "one control would do"


def test_the_error_for_a_missing_output_lists_the_existing_ones(assets):
    with pytest.raises(
        EnvError, match=r"'cooktop_4' of category 'cooktop' has no output 'fridge'; .*burner_0"
    ):
        next(by_output("fridge")(assets("TurnOnBurner"), np.random.default_rng(0)))


def test_a_lever_without_a_door_is_an_error():
    lever = artgen.generate("handle", 0, certify=False)
    with pytest.raises(
        EnvError, match=r"has nothing for PushDoor: Turn the lever .* Take assets that the task"
    ):
        TASKS["PushDoor"].target(lever, np.random.default_rng(0))


@pytest.mark.parametrize("name", ["TurnValve", "OpenBox", "LiftCoffeeLever", "OpenDesk", "OpenSafe"])
def test_a_padded_asset_has_the_parts_of_the_plain_one(name, assets):
    task, plain = TASKS[name], assets(name)
    padded = artgen.generate(plain.category, plain.seed, certify=False, topology="fixed", **task.overrides)
    found = [
        [
            [asset.originals.get(each.joint, each.joint) for each in stages]
            for stages in task.choose(asset, rng)
        ]
        for asset, rng in ((each, np.random.default_rng(0)) for each in (plain, padded))
    ]
    assert sorted(found[0]) == sorted(found[1])


@pytest.mark.parametrize(
    ("made", "message"),
    [
        (
            lambda: one_joint("lid", "grasp", "revolute"),
            "needs one goal: .* got share = 0.0 and at_least = 0.0",
        ),
        (lambda: one_joint("lid", "grasp", "revolute", 0.5, at_least=0.1), "needs one goal"),
        (lambda: one_joint("lid", "grasp", "revolute", 1.5), "share = 1.5 .* positive number of at most 1"),
        (
            lambda: one_joint("lid", "grap", "revolute", 0.5),
            "kind = 'grap' is not allowed. Did you mean 'grasp'",
        ),
        (lambda: one_joint("lid", "grasp", "prism", 0.5), "Did you mean 'prismatic'"),
        (lambda: by_lever("", goal=0.3, until=0.1), "goal = 0.3 .* at most 0.1"),
        (lambda: by_lever("", goal=np.nan, until=0.1), "goal = nan is not allowed"),
        (lambda: replace(TASKS["OpenBox"], seconds=0.0), "seconds = 0.0 .* must be a positive number"),
        (
            lambda: replace(TASKS["OpenBox"], choose=None),
            "choose of OpenBox is a function, such as one_joint",
        ),
    ],
)
def test_impossible_tasks_are_refused_when_they_are_made(made, message):
    with pytest.raises(ParameterError, match=message):
        made()


def test_a_choice_that_is_no_tuple_is_an_error(assets):
    task = replace(
        TASKS["OpenDrawer"], choose=lambda asset, rng: iter(next(TASKS["OpenDrawer"].choose(asset, rng)))
    )
    with pytest.raises(
        EnvError, match=r"choose of OpenDrawer yields a Stage; .* tuples of stages: \(stage,\)"
    ):
        task.target(assets("OpenDrawer"), np.random.default_rng(0))


def test_progress_and_goal_of_a_stage_towards_smaller_positions(assets):
    affordance = assets("OpenDrawer").affordances[0]
    stage = Stage("slide", 0.4, 0.1, affordance)
    assert [stage.progress(q) for q in (0.5, 0.4, 0.25, 0.1, 0.0)] == pytest.approx([0, 0, 0.5, 1, 1])
    assert [stage.reached(q) for q in (0.4, 0.11, 0.1, 0.0)] == [False, False, True, True]


def test_an_id_with_its_module_needs_no_import():
    code = (
        "from gymnasium.envs.registration import _find_spec as find;"
        "print(find('artgen.envs:artgen/OpenDrawer-v0').id)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.stdout.split()[-1:] == ["artgen/OpenDrawer-v0"], done.stderr
