"""The HDF5 layout of robomimic: one file, a group for each demonstration, lists of those to train on and not.

data              attributes: total, env_args (JSON)
  demo_0          attributes: num_samples, asset, seed
    obs/state     before each step, shape (n, ...); obs/image with pictures
    next_obs/...  after it
    actions       shape (n, 7), in [-1, 1]
    rewards, dones, states
mask/train, mask/valid    names of demonstrations
"""

import json
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from artgen.demos.episode import Demo
from artgen.errors import ExportError

INSTALL = "pip install 'artgen[demos]'"
VALID_EVERY = 10
"""One of so many demonstrations is not trained on."""

_GYM = 2  # robomimic's number for environments of Gymnasium's kind


class Writer:
    """A file that demonstrations are added to.

    Attributes:
        names: Those of the demonstrations so far.
    """

    def __init__(self, file: Any) -> None:
        self._file, self._data = file, file.create_group("data")
        self.names: list[str] = []
        self._total = 0

    def add(self, demo: Demo) -> None:
        """Add a demonstration."""
        name = f"demo_{len(self.names)}"
        group = self._data.create_group(name)
        for key, series in demo.observations.items():
            _put(group, f"obs/{key}", series[:-1])
            _put(group, f"next_obs/{key}", series[1:])
        for key in ("actions", "applied", "rewards", "dones", "states"):
            _put(group, key, getattr(demo, key))
        group.attrs["num_samples"] = len(demo)
        group.attrs["asset"] = demo.asset
        group.attrs["seed"] = demo.seed
        self._total += len(demo)
        self.names.append(name)

    def finish(self, environment: str, arguments: Mapping[str, Any]) -> None:
        """Add what holds for all: how many steps there are, how to make the environment, and the lists."""
        made = {"env_name": environment, "env_type": _GYM, "env_kwargs": dict(arguments)}
        self._data.attrs["total"] = self._total
        self._data.attrs["env_args"] = json.dumps(made, indent=4)
        valid = self.names[VALID_EVERY - 1 :: VALID_EVERY]
        for key, names in (("train", [each for each in self.names if each not in valid]), ("valid", valid)):
            self._file.create_dataset(f"mask/{key}", data=np.array(names, "S"))


@contextmanager
def writer(path: Path) -> Iterator[Writer]:
    """Yield a writer of a new file."""
    h5py = hdf5()
    with h5py.File(path, "w", track_order=False) as file:
        yield Writer(file)


def hdf5() -> Any:
    """Return h5py."""
    try:
        import h5py
    except ImportError as error:
        raise ExportError(f"demonstrations are HDF5 files, which need h5py: {INSTALL}") from error
    return h5py


def is_ours(path: Path) -> bool:
    """Tell whether a file holds demonstrations that artgen wrote."""
    h5py = hdf5()
    try:
        with h5py.File(path, "r") as file:
            return str(json.loads(file["data"].attrs["env_args"])["env_name"]).startswith("artgen/")
    except (OSError, KeyError, ValueError, TypeError):
        return False


def _put(group: Any, key: str, series: Any) -> None:
    """Add an array; pictures are compressed, each by itself."""
    packed = series.ndim == 4  # time, rows, columns and colours
    options = {"chunks": (1, *series.shape[1:]), "compression": "gzip"} if packed and len(series) else {}
    group.create_dataset(key, data=series, **options)
