"""The file of demonstrations has the layout of robomimic."""

import json

import numpy as np
import pytest

from artgen.demos import Demo
from artgen.demos.run import is_replaceable, write_demos
from artgen.errors import ExportError
from artgen.export.files import replaced

h5py = pytest.importorskip("h5py", reason="pip install 'artgen[demos]'")


def demo(seed, steps=4, image=0):
    rng = np.random.default_rng(seed)
    seen = {"state": rng.random((steps + 1, 5), np.float32)}
    if image:
        seen["rgb"] = rng.integers(0, 255, (steps + 1, image, image, 3), np.uint8)
    actions = rng.uniform(-1, 1, (steps, 7)).astype(np.float32)
    dones = np.eye(steps, dtype=np.int64)[-1]
    states = rng.random((steps, 9))
    return Demo(seed, f"drawer_{seed}", True, seen, actions, actions, rng.random(steps), dones, states)


def written(path, demos):
    steps = write_demos(path, demos, "artgen/OpenDrawer-v0", {"obs": "state"})
    assert steps == sum(map(len, demos))
    return path


def test_every_field_that_robomimic_reads_is_there(tmp_path):
    demos = [demo(seed, steps=3 + seed, image=8) for seed in range(12)]
    with h5py.File(written(tmp_path / "demo.hdf5", demos), "r") as file:
        data = file["data"]
        assert data.attrs["total"] == sum(map(len, demos))
        made = json.loads(data.attrs["env_args"])
        assert made == {"env_name": "artgen/OpenDrawer-v0", "env_type": 2, "env_kwargs": {"obs": "state"}}
        assert set(data) == {f"demo_{number}" for number in range(12)}
        for number, each in enumerate(demos):
            group = data[f"demo_{number}"]
            assert group.attrs["num_samples"] == len(each)
            assert (group.attrs["asset"], group.attrs["seed"]) == (each.asset, each.seed)
            for key in ("actions", "rewards", "dones", "states"):
                np.testing.assert_array_equal(group[key][:], getattr(each, key))
            for key, series in each.observations.items():
                np.testing.assert_array_equal(group["obs"][key][:], series[:-1])
                np.testing.assert_array_equal(group["next_obs"][key][1:-1], group["obs"][key][2:])
                np.testing.assert_array_equal(group["next_obs"][key][-1], series[-1])
        train, valid = ({name.decode() for name in file["mask"][key][:]} for key in ("train", "valid"))
        assert valid == {"demo_9"}
        assert train == set(data) - valid


def test_the_same_demonstrations_give_the_same_bytes(tmp_path):
    first, second = (written(tmp_path / name, [demo(1), demo(2, image=8)]) for name in ("a", "b"))
    assert first.read_bytes() == second.read_bytes()


def test_only_files_with_demonstrations_are_replaceable(tmp_path):
    ours = written(tmp_path / "ours.hdf5", [demo(1)])
    assert is_replaceable(ours, "artgen/OpenDrawer-v0")
    assert not is_replaceable(ours, "artgen/TurnFaucet-v0")
    (tmp_path / "text.hdf5").write_text("notes")
    with h5py.File(tmp_path / "other.hdf5", "w") as file:
        file.create_group("data")
    assert not is_replaceable(tmp_path / "text.hdf5", "artgen/OpenDrawer-v0")
    assert not is_replaceable(tmp_path / "other.hdf5", "artgen/OpenDrawer-v0")
    assert is_replaceable(tmp_path / "none.hdf5", "artgen/OpenDrawer-v0")


def half(place):
    def torn():
        yield demo(1)
        raise KeyError(place)

    with replaced(place) as partial:
        write_demos(partial, torn(), "artgen/OpenDrawer-v0", {"obs": "state"})


def test_a_file_is_complete_or_absent(tmp_path):
    place = tmp_path / "new" / "demo.hdf5"
    with pytest.raises(KeyError):
        half(place)
    assert not place.parent.exists()
    with replaced(place) as partial:
        partial.write_text("old")
    with pytest.raises(KeyError):
        half(place)
    assert place.read_text() == "old"
    assert [each.name for each in place.parent.iterdir()] == ["demo.hdf5"]
    with pytest.raises(ExportError, match="nothing was changed"), replaced(place / "below" / "demo.hdf5"):
        pass
