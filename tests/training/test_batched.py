"""Worlds that are stepped together move as the environment does, one by one."""

import sys
from dataclasses import replace
from itertools import product
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

torch = pytest.importorskip("torch", reason="pip install 'artgen[train]'")
pytest.importorskip("stable_baselines3", reason="pip install 'artgen[train]'")
sys.path.insert(0, str(Path(__file__).parents[2] / "examples" / "training"))
import batched_maths  # noqa: E402

import artgen  # noqa: E402
from artgen.envs import TASKS, ManipulationEnv  # noqa: E402
from artgen.envs.env import dense, reward  # noqa: E402
from artgen.envs.policy import ScriptedPolicy  # noqa: E402
from artgen.envs.scene import CAMERAS  # noqa: E402
from artgen.errors import ParameterError  # noqa: E402

TIP = 1e-5  # single precision after an episode [m]
JOINT = 1e-4  # share of the way to the goal
SEEN = 2e-4  # of any number that is observed
REWARD = 1e-5
# a bar with flat sides: in single precision, fingers lose contacts with round ones for a step
BAR = {"grip": "bar", "handle.style": "square"}

needs_warp = pytest.mark.filterwarnings("ignore::DeprecationWarning", "ignore::UserWarning")


@pytest.fixture(scope="module")
def batched():
    pytest.importorskip("mujoco_warp", reason="pip install mujoco-warp")
    import batched

    return batched


@pytest.fixture(scope="module")
def drawers():
    """Two of one structure and of other sizes, and one of another structure."""
    first = artgen.generate("drawer", 0, certify=False, **BAR)
    width = 1.2 * first.parameters["width"]
    return [
        first,
        artgen.generate("drawer", 0, certify=False, width=width, **BAR),
        artgen.generate("drawer", 1, certify=False),
    ]


@pytest.fixture(scope="module")
def pair(batched, drawers):
    return batched.BatchedTask("OpenDrawer", drawers[:2], 2, seed=0)


@pytest.fixture(scope="module")
def padded():
    """Two of different structure, padded to the fixed topology of drawers."""
    return [
        artgen.generate("drawer", seed, certify=False, topology="fixed", **some)
        for seed, some in ((0, BAR), (1, {}))
    ]


@pytest.fixture(scope="module")
def different(batched, padded):
    return batched.BatchedTask("OpenDrawer", padded, 2, seed=0)


@pytest.fixture(scope="module")
def twice(batched, drawers):
    """Worlds of a task with two stages: a drawer is opened half way, then all the way."""
    task = TASKS["OpenDrawer"]

    def halves(asset, rng):
        for (whole,) in task.choose(asset, rng):
            yield replace(whole, goal=0.5 * (whole.start + whole.goal), moves=()), whole

    both = replace(task, name="OpenDrawerTwice", choose=halves)
    return batched.BatchedTask(both, drawers[:2], 2, seed=0)


def state_of(control):
    def tensor(values):
        return torch.as_tensor(np.array(values))[None]

    names = ("jacobian", "inertia", "angles", "speeds", "bias", "place", "turn")
    return {name: tensor(getattr(control, f"_{name}")) for name in names}


def test_torques_are_those_of_the_control():
    env = ManipulationEnv("PushToasterLever", range(1))
    env.reset(seed=0)
    for action in np.random.default_rng(0).uniform(-1.0, 1.0, (4, 7)):
        env.step(action)
        control = env.scene.control
        control.aim(action[:6])
        control.run()
        goals = (
            torch.as_tensor(each)[None] for each in (control._goal, control._goal_turn, control._posture)
        )
        found = batched_maths.torques(state_of(control), *goals)
        np.testing.assert_allclose(found[0], env.data.ctrl[control.actuators], rtol=1e-8, atol=1e-8)


def test_the_jacobian_is_that_of_the_simulator():
    env = ManipulationEnv("PushToasterLever", range(1))
    env.reset(seed=0)
    env.step(np.ones(7))
    control, joints = env.scene.control, env.model.jnt_qposadr
    numbers = [int(np.flatnonzero(joints == at)[0]) for at in range(control.at.start, control.at.stop)]
    found = batched_maths.jacobians(
        *(torch.as_tensor(each)[None] for each in (env.data.xaxis[numbers], env.data.xanchor[numbers])),
        torch.as_tensor(env.tip()[:3, 3])[None],
    )
    control.velocity()  # finds the control's own
    np.testing.assert_allclose(found[0], control._jacobian, atol=1e-9)


def test_turns_are_by_the_length_of_their_vector():
    vectors = np.array([[0.1, -0.3, 0.2], [0.0, 0.0, 0.0], [0.0, 0.5, 0.0]])
    found = batched_maths.rotations(torch.as_tensor(vectors))
    np.testing.assert_allclose(found, Rotation.from_rotvec(vectors).as_matrix(), atol=1e-12)


@pytest.mark.parametrize("done", [(False,), (True,), (False, False), (True, False), (True, True)])
def test_rewards_are_those_of_the_environment(done):
    action, stage = np.linspace(-1.0, 1.0, 7), min(sum(done), len(done) - 1)
    wanted = reward(dense([0.4, 0.2][: len(done)], done, 0.13), action, 160, success=False)
    numbers = (stage, len(done), [0.4, 0.2][stage], 0.13, action)
    tensors = (torch.as_tensor(np.array([each])) for each in numbers)
    found = batched_maths.rewarded(*tensors, 160, done=torch.tensor([all(done)]))
    assert found.item() == pytest.approx(wanted, abs=1e-12)


@needs_warp
def test_a_stage_counts_after_the_earlier_ones_and_need_not_stay(twice):
    """The second stage alone is not done; the first one stays done when the drawer goes back."""
    goals = twice.groups[0][0].goals
    goals.begin(goals.worlds)
    half, whole = goals.goal[0].tolist()
    qpos = torch.zeros((2, int(goals.at.max()) + 1), dtype=torch.float64)

    def at(position):
        qpos[:, goals.at[0, 0]] = position
        progress = goals.update(qpos)
        return progress[0].tolist(), goals.done[0].tolist(), int(goals.stage[0])

    assert at(0.0) == ([0.0, 0.0], [False, False], 0)
    assert at(half) == ([1.0, pytest.approx(0.5)], [True, False], 1)
    assert at(0.0) == ([0.0, 0.0], [True, False], 1)
    assert at(whole) == ([1.0, 1.0], [True, True], 1)
    goals.holds[:] = True
    assert at(0.0) == ([0.0, 0.0], [False, False], 0)
    goals.holds[:] = False


@needs_warp
def test_sizes_share_a_model_and_structures_do_not(batched, drawers, pair):
    assert [len(numbers) for _, numbers in pair.groups] == [2]
    scenes, _ = batched._fit(pair.task, drawers, 3)
    kinds = [batched.structured(scene)[0] for scene in scenes]
    assert kinds[0] == kinds[1] != kinds[2]


@needs_warp
@pytest.mark.parametrize("task", ["PushDoor", "PushToasterLever", "OpenFridge"])
def test_assets_of_the_fixed_topology_share_a_model(batched, task):
    category = TASKS[task].category
    assets = [artgen.generate(category, seed, topology="fixed", certify=False) for seed in range(8)]
    scenes, _ = batched._fit(TASKS[task], assets, 3)
    assert len({scene.asset.name for scene in scenes}) == 3
    assert len({batched.structured(scene)[0] for scene in scenes}) == 1


@needs_warp
@pytest.mark.parametrize(
    ("name", "number"), [("pair", 0), ("pair", 1), ("twice", 1), ("different", 0), ("different", 1)]
)
def test_an_episode_goes_as_in_the_environment(request, name, number):
    """The script opens the drawer in the environment; the same actions do the same in the world."""
    pair = request.getfixturevalue(name)
    assert len(pair.groups) == 1
    assets = request.getfixturevalue("padded" if name == "different" else "drawers")
    env = ManipulationEnv(pair.task, assets[:2])
    observation, _ = env.reset(seed=0, options={"asset": number})
    policy = ScriptedPolicy(env)
    (worlds, numbers), both = pair.groups[0], np.ones(2, bool)
    pair.begin(worlds, numbers, both, np.tile(env.data.qpos[env.scene.control.at], (2, 1)))
    np.testing.assert_allclose(worlds.goals.observe(worlds.seen())[0][number], observation, atol=SEEN)
    for _ in range(env.steps):
        action = policy.action()
        observation, gained, ended, _, info = env.step(action)
        observations, rewards, ends, infos = pair.step(np.tile(action, (2, 1)))
        mine = infos[number]
        seen = mine.get("terminal_observation", observations[number])
        np.testing.assert_allclose(seen[14:17], observation[14:17], atol=TIP)
        np.testing.assert_allclose(seen, observation, atol=SEEN)
        assert mine["progress"] == pytest.approx(info["progress"], abs=JOINT)
        assert rewards[number] == pytest.approx(gained, abs=REWARD)
        assert (ends[number], mine["success"]) == (ended, info["success"])
        if ended:
            break
    assert ended
    assert not mine["TimeLimit.truncated"]
    # it begins again: the drawer is shut, the tip where it began but for the jitter
    assert observations[number][42] == pytest.approx(0.0, abs=1e-4)
    assert np.abs(observations[number][:7] - env.target.arm).max() < 0.0201


@needs_warp
def test_an_episode_ends_with_its_time(pair):
    pair.reset()
    pair._ages[:] = pair.steps - 1, 3
    observations, _, ends, infos = pair.step(np.zeros((2, 7)))
    assert ends.tolist() == [True, False]
    assert infos[0]["TimeLimit.truncated"]
    assert "terminal_observation" not in infos[1]
    assert not np.array_equal(infos[0]["terminal_observation"], observations[0])
    assert pair._ages.tolist() == [0, 4]


@needs_warp
def test_first_episodes_can_end_one_after_another(batched, drawers, pair):
    pair.reset()
    assert pair._ages.tolist() == [0, 0]
    spread = batched.BatchedTask("OpenDrawer", drawers[:2], 2, seed=0, spread=True)
    spread.reset()
    assert spread._ages.tolist() == [0, spread.steps // 2]
    spread.step(np.zeros((2, 7)))
    assert spread._ages.tolist() == [1, spread.steps // 2 + 1]
    spread._ages[1] = spread.steps - 1
    _, _, ends, infos = spread.step(np.zeros((2, 7)))
    assert ends.tolist() == [False, True]
    assert infos[1]["TimeLimit.truncated"]
    assert spread._ages.tolist() == [2, 0], "later episodes are whole"


@needs_warp
def test_seeds_repeat(pair):
    actions = np.random.default_rng(3).uniform(-1.0, 1.0, (2, 2, 7))

    def seen(seed):
        pair.seed(seed)
        return [pair.reset(), *(pair.step(each)[0] for each in actions)]

    first, again, other = seen(5), seen(5), seen(6)
    np.testing.assert_allclose(first, again, atol=1e-6)
    assert np.abs(first[0] - other[0]).max() > 1e-3


@needs_warp
def test_wrong_arguments_are_errors(batched, pair):
    with pytest.raises(ParameterError, match="worlds is a whole number from 1 to 1000000, not 0"):
        batched.BatchedTask("OpenDrawer", range(1), 0)
    with pytest.raises(ParameterError, match="actions of 2 worlds"):
        pair.step(np.zeros((3, 7)))


@needs_warp
def test_pictures_show_the_asset_of_each_world(batched, padded):
    """Rays of MuJoCo meet the colliders whose colors the pixels have; lights are white."""
    mujoco, size = pytest.importorskip("mujoco"), 48
    task = batched.BatchedTask("OpenDrawer", padded, 2, seed=0, pictures=size)
    seen = task.reset()
    scenes, _ = batched._fit(task.task, padded, 2)
    assert seen["robot"].shape == (2, 30)
    groups = np.array([0, 0, 1, 1, 0, 0], np.uint8)
    for (number, scene), (key, camera) in product(
        enumerate(scenes), (("rgb", "front"), ("hand_rgb", "hand"))
    ):
        model, data = scene.model, scene.data
        data.qpos[:] = task.groups[0][0].seen()["qpos"][number]
        mujoco.mj_forward(model, data)
        eye = model.camera(CAMERAS[camera]).id
        half, found = np.tan(np.radians(model.cam_fovy[eye]) / 2.0), []
        for row, column in np.random.default_rng(0).integers(0, size, (300, 2)):
            across = half * (2.0 * np.array([column + 0.5, size - row - 0.5]) / size - 1.0)
            ray = data.cam_xmat[eye].reshape(3, 3) @ np.array([*across, -1.0])
            met = np.zeros(1, np.int32)
            mujoco.mj_ray(model, data, data.cam_xpos[eye], ray, groups, 1, -1, met)
            pixel = seen[key][number, row, column].astype(float)
            wanted = model.geom_rgba[met[0], :3] if met[0] >= 0 else np.full(3, 0.6)
            shares = [each / max(each.sum(), 1e-9) for each in (pixel, wanted)]
            found.append(np.abs(shares[0] - shares[1]).max() < 0.02 or pixel.sum() < 30)
        assert np.mean(found) > 0.97, f"{key} of {scene.asset.name}: {np.mean(found):.2f} of the pixels"
    still = np.zeros((2, 7))
    while True:
        after, _, ended, infos = task.step(still)
        if ended.any():
            break
    last = infos[0]["terminal_observation"]
    assert set(last) == set(after) == {"rgb", "hand_rgb", "robot"}
    assert last["rgb"].shape == after["rgb"][0].shape == (size, size, 3)
