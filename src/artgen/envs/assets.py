"""The assets of a task, from a folder, a list or seeds, and a cache of their compiled models."""

import copy
from collections import OrderedDict
from collections.abc import Hashable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from artgen._caching import cached_property
from artgen.asset import Asset
from artgen.dataset import Dataset
from artgen.envs.motion import Target
from artgen.envs.scene import Scene, compiled
from artgen.envs.task import Task
from artgen.errors import EnvError

Source = str | Path | Dataset | Sequence[Asset] | range | None
"""A folder made by `artgen generate`, a dataset, assets, a range of seeds, or None for all seeds."""

_SEEDS = 2**31  # number of all seeds


class Assets:
    """The assets of a task by number, made or read on access.

    Args:
        task: The task.
        source: Their source; in a folder or dataset, those of the task's category.

    Raises:
        EnvError: There are none, or some in a list are of another category.
        ExportError: The folder holds no dataset.

    Attributes:
        task: The task.
        keys: Their numbers: indices in a dataset or list, or seeds.
    """

    def __init__(self, task: Task, source: Source = None) -> None:
        self.task = task
        self._known: Sequence[Asset] | None = None
        self.keys: Sequence[int] = range(_SEEDS)
        if isinstance(source, range):
            self.keys = source
        elif isinstance(source, str | Path | Dataset):
            self._known = _of_category(task, source)
            self.keys = range(len(self._known))
        elif source is not None:
            self._known = _checked(task, source)
            self.keys = range(len(self._known))
        if not len(self.keys):
            raise EnvError(
                f"{task.name} got no assets: give a folder, assets or a range of seeds that is not empty, "
                f"or None for a new {task.category} in each episode"
            )
        if self._known is None and min(self.keys[0], self.keys[-1]) < 0:
            raise EnvError(f"{task.name} got the seeds {self.keys}; seeds are not negative")

    def draw(self, rng: np.random.Generator) -> int:
        """Return one of the numbers at random."""
        return int(self.keys[int(rng.integers(len(self.keys)))])

    def identity(self, key: int) -> Hashable:
        """Return the key of an asset in the cache, the same for equal sources and tasks."""
        if self._known is None:
            return self.task
        if isinstance(self._known, Dataset):
            return self.task, str(self._known.directory), str(self._known.records[key]["path"])
        return self.task, self._known[key]

    def load(self, key: int) -> Asset:
        """Return the asset of a number, or raise an EnvError if there is none."""
        if key not in self.keys:
            raise EnvError(
                f"{self.task.name} has no asset {key!r}; the numbers are {self.keys[0]} to {self.keys[-1]}"
            )
        return self.task.generate(key) if self._known is None else self._known[key]


def _of_category(task: Task, source: str | Path | Dataset) -> Dataset:
    dataset = source if isinstance(source, Dataset) else Dataset(source)
    found = sorted({str(record["category"]) for record in dataset.records})
    if task.category not in found:
        held = f"assets of {', '.join(found)}" if found else "no assets"
        raise EnvError(
            f"{task.name} needs assets of the category {task.category!r}, but {dataset.directory} holds "
            f"{held}; `artgen generate {task.category} -n 100 --out FOLDER` makes some"
        )
    return dataset.filter(task.category)


def _checked(task: Task, assets: Any) -> Sequence[Asset]:
    for asset in assets if isinstance(assets, Sequence) else (assets,):
        if not isinstance(asset, Asset):
            raise EnvError(
                f"{task.name} got {asset!r} for an asset; give a folder, assets, a range of seeds, or None"
            )
        if asset.category != task.category:
            raise EnvError(
                f"{task.name} needs assets of the category {task.category!r}, but {asset.name!r} is of "
                f"{asset.category!r}"
            )
    return tuple(assets)


class CompiledAsset:
    """An asset with its compiled model and its variants of a task."""

    def __init__(self, task: Task, asset: Asset, key: int, *, visual: bool, textures: int) -> None:
        self.asset = asset
        self._task, self._key, self._visual, self._textures = task, key, visual, textures
        self._targets: dict[int, Target | str] = {}

    @cached_property
    def _model(self) -> Any:
        return compiled(self.asset, visual=self._visual, textures=self._textures)

    def scene(self) -> Scene:
        """Return a scene with a model of its own, whose robot can move."""
        return Scene(self.asset, copy.copy(self._model))

    def target(self, number: int) -> Target:
        """Return a variant of the task; it depends on the asset and the number alone."""
        if number not in self._targets:
            try:
                self._targets[number] = self._task.target(
                    self.asset, np.random.default_rng([self._key, number])
                )
            except EnvError as error:
                self._targets[number] = str(error)
        found = self._targets[number]
        if isinstance(found, str):
            raise EnvError(found)
        return found


_cache: OrderedDict[Hashable, CompiledAsset] = OrderedDict()


def compiled_asset(assets: Assets, key: int, *, visual: bool, textures: int, most: int) -> CompiledAsset:
    """Return the compiled asset of a number from the cache of the process, which keeps the `most` recent."""
    name = (assets.identity(key), key, visual, textures)
    if name not in _cache:
        while len(_cache) >= most:
            _cache.popitem(last=False)
        _cache[name] = CompiledAsset(assets.task, assets.load(key), key, visual=visual, textures=textures)
    _cache.move_to_end(name)
    return _cache[name]
