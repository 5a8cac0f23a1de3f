"""Environments: the check of Gymnasium, reproducible seeds, and ends of episodes."""

import subprocess
import sys
from dataclasses import replace

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env

import artgen.envs
from artgen.envs import ManipulationEnv
from artgen.envs.env import BONUS, DENSE
from artgen.errors import EnvError, ParameterError
from support.manipulation import PULL, pull

STILL = np.zeros(7, np.float32)


def made(**options):
    return ManipulationEnv(PULL, **{"assets": range(3), **options})


def rolled(env, seed, steps=15):
    """Return all observations and rewards of an episode with random actions."""
    observation, info = env.reset(seed=seed)
    rng = np.random.default_rng(seed)
    seen = [observation]
    for _ in range(steps):
        observation, reward, *_ = env.step(rng.uniform(-1.0, 1.0, 7).astype(np.float32))
        seen += [observation, [reward]]
    return info["seed"], np.concatenate(seen)


def test_every_task_is_registered():
    assert artgen.envs.TASKS
    for name in artgen.envs.TASKS:
        spec = gymnasium.spec(f"artgen/{name}-v0")
        assert spec.kwargs == {"task": name}


@pytest.mark.filterwarnings("ignore::UserWarning")  # that no environment of the registry was checked
def test_the_environment_passes_the_checks_of_gymnasium():
    check_env(made(), skip_render_check=True)


def test_a_seed_gives_the_same_episode_after_any_history():
    env, other = made(), made(cache_size=1)
    name, first = rolled(env, 7)
    for seed in (1, 2, 3):  # so that other assets are made, and of one environment each model anew
        other.reset(seed=seed)
        other.step(STILL)
    again_name, again = rolled(other, 7)
    assert name == again_name
    np.testing.assert_array_equal(first, again)
    _, third = rolled(env, 7)
    np.testing.assert_array_equal(first, third)
    assert np.abs(rolled(env, 8)[1] - first).max() > 1e-3


def test_resets_draw_other_assets_and_postures():
    env = made()
    env.reset(seed=0)
    seeds, postures = set(), []
    for _ in range(12):
        observation, info = env.reset()
        seeds.add(info["seed"])
        postures.append(observation[:7])
    assert seeds == {0, 1, 2}
    assert len(np.unique(np.round(postures, 6), axis=0)) == 12


def test_assets_are_taken_in_order_or_by_number():
    env = made(shuffle=False, assets=range(10, 13))
    assert [env.reset()[1]["seed"] for _ in range(4)] == [10, 11, 12, 10]
    assert [env.reset(seed=1)[1]["seed"], env.reset()[1]["seed"]] == [11, 12]
    assert env.reset(options={"asset": 10})[1]["seed"] == 10


def test_pulling_the_handle_opens_the_drawer():
    env = made()
    _, info = env.reset(seed=0)
    assert not info["success"]
    total, bonus = 0.0, 0.0
    for action in pull(env):
        observation, reward, terminated, truncated, info = env.step(action)
        total += reward
        if terminated or truncated:
            bonus = reward
            break
    assert terminated
    assert not truncated
    assert info["success"]
    assert info["reached"] == [True] == list(env.reached())
    assert info["progress"] == [1.0]
    stage = env.target.stages[0]
    assert env.q(stage.joint) >= stage.goal
    assert bonus > BONUS > DENSE > total - bonus
    assert observation[-5] == pytest.approx(1.0), "the progress is observed"


def test_time_runs_out_without_success():
    env = made()
    env.reset(seed=0)
    ended = [env.step(STILL)[2:4] for _ in range(env.steps)]
    assert env.steps == 80, "4 s at 20 Hz"
    assert not any(terminated for terminated, _ in ended)
    assert [truncated for _, truncated in ended] == [False] * 79 + [True]


def test_an_episode_can_continue_after_success():
    env = made(terminate_on_success=False)
    env.reset(seed=0)
    rewards = []
    for action in pull(env):
        _, reward, terminated, truncated, info = env.step(action)
        rewards.append(reward)
        assert not terminated
        if truncated:
            break
    assert info["success"]
    assert sum(reward > BONUS - 1.0 for reward in rewards) == 1, "the bonus is given once"


def test_stages_are_reached_in_their_order():
    env = made()
    env.reset(seed=0)
    stage = env.target.stages[0]
    first = type(stage)(stage.joint, 0.0, 10.0, stage.affordance)
    env.target.__dict__["stages"] = (first, stage)  # the first one is out of reach
    env._done, env._progress = [False, False], [0.0, 0.0]
    env.data.joint(stage.joint).qpos[0] = stage.goal + 0.02
    _, _, terminated, _, info = env.step(STILL)
    env.target.__dict__["stages"] = (stage,)
    assert info["reached"] == [False, False]
    assert info["progress"][1] > 0.99
    assert not terminated


def test_the_state_contains_the_vector_to_the_handle():
    env = made()
    env.reset(seed=0)
    state = env.state()
    grasp = env.target.stages[0].affordance.frame
    np.testing.assert_allclose(state[30:33], grasp[:3, 3] - env.tip()[:3, 3], atol=1e-5)
    np.testing.assert_allclose(state[36:39], grasp[:3, 2], atol=1e-5)
    np.testing.assert_allclose(
        state[39:42], -grasp[:3, 2], atol=1e-5
    )  # a drawer goes where the hand came from
    assert state.dtype == np.float32
    assert state.shape == env.observation_space.shape


def test_environments_of_processes_have_different_assets():
    vector = gymnasium.vector.AsyncVectorEnv(
        [lambda seed=seed: ManipulationEnv(PULL, range(seed, seed + 1)) for seed in (4, 5)]
    )
    try:
        observations, infos = vector.reset(seed=1)
        assert list(infos["seed"]) == [4, 5]
        assert observations.shape == (2, *ManipulationEnv(PULL, range(1)).observation_space.shape)
        _, rewards, *_ = vector.step(np.zeros((2, 7), np.float32))
        assert rewards.shape == (2,)
    finally:
        vector.close()


def test_pictures_are_observed(gl):
    env = made(obs="rgb", size=48, assets=range(1))
    observation, _ = env.reset(seed=0)
    assert env.observation_space.contains(observation)
    front, hand = observation["rgb"], observation["hand_rgb"]
    for picture in (front, hand):
        assert picture.std() > 10.0, "the picture is not uniform"
    for _ in range(8):
        observation, *_ = env.step(np.array([0, 0, 1, 0, 0, 0, 0], np.float32))
    assert np.abs(observation["rgb"].astype(int) - front).max() > 50, "the arm has moved"
    env.close()


def test_pictures_are_rendered(gl):
    env = made(render_mode="rgb_array", size=64, assets=range(1))
    env.reset(seed=0)
    assert env.render().shape == (64, 64, 3)
    assert env.picture(32, "hand").shape == (32, 32, 3)
    with pytest.raises(ParameterError, match=r"there is no camera 'hnad'\. Did you mean 'hand'"):
        env.picture(32, "hnad")
    env.close()


@pytest.fixture
def gl():
    from artgen.errors import RenderError
    from artgen.view.gl import available

    try:
        available()
    except RenderError as error:
        pytest.skip(str(error))


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"task": "PushDor"}, "there is no task 'PushDor'. Did you mean 'PushDoor'"),
        ({"obs": "stat"}, "there are no observations 'stat'. Did you mean 'state'"),
        ({"render_mode": "human"}, "there is no render_mode 'human'; take 'rgb_array' or None"),
        ({"size": 8}, "size is a whole number from 16 to 4096, not 8"),
        ({"cache_size": 0}, "cache_size is a whole number from 1"),
        ({"layouts_per_asset": 1.5}, "layouts_per_asset is a whole number from 1"),
    ],
)
def test_bad_options_are_one_clear_error(options, message):
    with pytest.raises(ParameterError, match=message):
        ManipulationEnv(**{"task": PULL, "assets": range(1), **options})


def test_bad_calls_are_one_clear_error():
    env = made(assets=range(1))
    with pytest.raises(EnvError, match=r"Pull has not begun; call reset\(\) first"):
        env.step(STILL)
    with pytest.raises(ParameterError, match="reset has no option 'assets'; its option is 'asset'"):
        env.reset(options={"assets": 1})
    env.reset(seed=0)
    for action in (np.zeros(6), np.full(7, np.nan), np.full(7, np.inf), "open", None):
        with pytest.raises(ParameterError, match="an action of Pull is 7 finite numbers"):
            env.step(action)
    with pytest.raises(EnvError, match="pictures need render_mode='rgb_array' or obs='rgb'"):
        env.picture()


def test_assets_without_the_part_are_skipped():
    good = PULL.generate(0)
    bare = replace(good, name="bare", links=tuple(replace(link, grasps=()) for link in good.links))
    env = made(assets=[bare, good], shuffle=False)
    for _ in range(3):
        assert env.reset()[1]["asset"] == good.name
    with pytest.raises(EnvError, match="asset 'bare' has no drawer with a handle"):
        env.reset(options={"asset": 0})
    with pytest.raises(
        EnvError, match="Pull found no suitable asset in 50 draws; the last one: asset 'bare' has no"
    ):
        made(assets=[bare]).reset()


def test_missing_gymnasium_is_one_clear_error():
    code = "import sys; sys.modules['gymnasium'] = None; import artgen.envs"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert "EnvError: manipulation tasks need Gymnasium: pip install 'artgen[envs]'" in done.stderr


def test_a_key_counts_only_while_the_output_goes_on():
    env = ManipulationEnv("StartMicrowave", range(3, 4))
    env.reset(seed=0)
    (stage,) = env.target.stages
    still = np.zeros(7, np.float32)

    def pressed():
        for _ in range(3):
            env.data.joint(stage.joint).qfrc_applied[0] = 20.0
            *_, info = env.step(still)
        return info

    env.data.joint("door_hinge").qpos[0] = 0.8
    assert env.step(still)[-1]["outputs"]["light"] == 1.0
    info = pressed()
    assert (info["success"], info["progress"], info["outputs"]["heat"]) == (False, [1.0], 0.0)
    env.reset(seed=0)
    info = pressed()
    assert (info["success"], info["outputs"]["heat"]) == (True, 1.0)
    env.close()
