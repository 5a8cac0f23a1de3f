"""A folder of demonstrations is a LeRobotDataset 3.0, as LeRobot reads it."""

import json

import numpy as np
import pytest

from artgen.demos import Demo, make_demos
from artgen.demos.lerobot import is_lerobot, write_lerobot
from artgen.errors import ExportError, ParameterError
from artgen.export.files import replaced

parquet = pytest.importorskip("pyarrow.parquet", reason="pip install 'artgen[data]'")
pytest.importorskip("pandas", reason="pip install 'artgen[data]'")


def demo(seed, steps, image=0):
    rng = np.random.default_rng(seed)
    seen = {"state": rng.random((steps + 1, 5), np.float32)}
    for name in ("rgb", "hand_rgb") if image else ():
        seen[name] = rng.integers(0, 255, (steps + 1, image, image, 3), np.uint8)
    actions, applied = rng.uniform(-1, 1, (2, steps, 7)).astype(np.float32)
    dones = np.eye(steps, dtype=np.int64)[-1]
    return Demo(
        seed, f"drawer_{seed}", True, seen, actions, applied, rng.random(steps), dones, rng.random((steps, 9))
    )


def written(folder, demos):
    assert write_lerobot(folder, demos, "artgen/OpenDrawer-v0", "Open it.", 20) == sum(map(len, demos))
    return folder


def test_the_statistics_are_those_of_all_frames(tmp_path):
    demos = [demo(seed, steps=3 + seed, image=8) for seed in range(4)]
    folder = written(tmp_path / "lerobot", demos)
    stats = json.loads((folder / "meta/stats.json").read_text())
    states = np.concatenate([each.observations["state"][:-1] for each in demos])
    pictures = np.concatenate([each.observations["hand_rgb"][:-1] for each in demos]) / 255.0
    for kind in ("min", "max", "mean", "std"):
        got = stats["observation.state"][kind]
        np.testing.assert_allclose(got, getattr(states, kind)(axis=0), rtol=1e-6, err_msg=kind)
        got = np.array(stats["observation.images.hand"][kind])
        assert got.shape == (3, 1, 1)
        np.testing.assert_allclose(got.ravel(), getattr(pictures, kind)(axis=(0, 1, 2)), rtol=1e-6)
    assert stats["action"]["count"] == [len(states)]
    rows = parquet.read_table(folder / "meta/episodes/chunk-000/file-000.parquet").to_pylist()
    assert [(row["asset"], row["seed"]) for row in rows] == [(each.asset, each.seed) for each in demos]


def test_the_same_demonstrations_give_the_same_bytes(tmp_path):
    first, second = (written(tmp_path / name, [demo(1, 3), demo(2, 4, image=8)][:1]) for name in "ab")
    files = sorted(path.relative_to(first) for path in first.rglob("*") if path.is_file())
    assert len(files) == 5
    for path in files:
        assert (first / path).read_bytes() == (second / path).read_bytes(), path


def stopped(place):
    with replaced(place) as partial:
        written(partial, [demo(2, 9)])
        raise KeyError(place)


def test_only_folders_with_demonstrations_are_replaced(tmp_path):
    ours = written(tmp_path / "ours", [demo(1, 3)])
    (tmp_path / "notes").mkdir()
    (tmp_path / "notes" / "diary.txt").write_text("dear diary")
    assert is_lerobot(ours, "artgen/OpenDrawer-v0")
    assert not is_lerobot(ours, "artgen/TurnFaucet-v0")
    assert is_lerobot(tmp_path / "new", "artgen/OpenDrawer-v0")
    assert not is_lerobot(tmp_path / "notes", "artgen/OpenDrawer-v0")
    with replaced(ours) as partial:
        written(partial, [demo(2, 4)])
    assert json.loads((ours / "meta/info.json").read_text())["total_frames"] == 4
    with pytest.raises(KeyError):
        stopped(ours)
    assert json.loads((ours / "meta/info.json").read_text())["total_frames"] == 4
    assert sorted(path.name for path in tmp_path.iterdir()) == ["notes", "ours"]


def test_a_foreign_folder_and_an_unknown_layout_are_refused(tmp_path):
    pytest.importorskip("robosuite", reason="pip install 'artgen[envs]'")
    (tmp_path / "lerobot").mkdir()
    (tmp_path / "lerobot" / "diary.txt").write_text("dear diary")
    with pytest.raises(ExportError, match="holds no demonstrations of artgen/OpenDrawer-v0"):
        make_demos("OpenDrawer", 1, tmp_path, layout="lerobot")
    assert (tmp_path / "lerobot" / "diary.txt").exists()
    with pytest.raises(ParameterError, match=r"no layout 'lerobo'.*lerobot"):
        make_demos("OpenDrawer", 1, tmp_path, layout="lerobo")


def test_lerobot_reads_the_frames_of_each_episode(tmp_path):
    module = pytest.importorskip("lerobot.datasets.lerobot_dataset", reason="pip install lerobot")
    demos = [demo(seed, steps=3 + seed, image=8) for seed in range(3)]
    folder = written(tmp_path / "lerobot", demos)
    data = module.LeRobotDataset("artgen/test", root=folder)
    assert (len(data), data.num_episodes, data.fps) == (3 + 4 + 5, 3, 20)
    assert list(data.meta.tasks.index) == ["Open it."]
    frame = 0
    for episode, each in enumerate(demos):
        for step in range(len(each)):
            item = data[frame]
            assert int(item["episode_index"]) == episode
            assert float(item["timestamp"]) == pytest.approx(step / 20)
            assert item["task"] == "Open it."
            np.testing.assert_array_equal(item["observation.state"], each.observations["state"][step])
            np.testing.assert_array_equal(item["action"], each.actions[step])
            np.testing.assert_array_equal(item["applied"], each.applied[step])
            for name, feature in (("rgb", "front"), ("hand_rgb", "hand")):
                picture = np.moveaxis(item[f"observation.images.{feature}"].numpy(), 0, 2) * 255
                np.testing.assert_allclose(picture, each.observations[name][step], atol=1e-3)
            assert bool(item["next.done"]) == (step == len(each) - 1)
            frame += 1
    ahead = module.LeRobotDataset(
        "artgen/test", root=folder, episodes=[2], delta_timestamps={"action": [0.0, 0.05]}
    )
    np.testing.assert_array_equal(ahead[0]["action"], demos[2].actions[:2])
