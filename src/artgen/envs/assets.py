"""Where a task's assets come from: a folder, a list, seeds, or all seeds there are."""

from collections.abc import Hashable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from artgen.asset import Asset
from artgen.dataset import Dataset
from artgen.errors import EnvError

if TYPE_CHECKING:
    from artgen.envs.task import Task

Source = str | Path | Dataset | Sequence[Asset] | range | None
"""A folder that `artgen generate` made, a dataset, assets, seeds to draw them from, or None for all seeds."""

_SEEDS = 2**31  # seeds that are drawn from where none are given


class Assets:
    """The assets of a task by number, each made or read when it is asked for.

    Args:
        task: The task.
        source: Where they come from; of a folder or dataset, those of the task's category.

    Raises:
        EnvError: There are none, or some in a list are of another category.
        ExportError: The folder holds no dataset.

    Attributes:
        task: The task.
        keys: Their numbers: places in a dataset or list, or seeds.
    """

    def __init__(self, task: "Task", source: Source = None) -> None:
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
                f"or None to draw a {task.category} anew for each episode"
            )
        if self._known is None and min(self.keys[0], self.keys[-1]) < 0:
            raise EnvError(f"{task.name} got the seeds {self.keys}; seeds are not negative")

    def draw(self, rng: np.random.Generator) -> int:
        """Return one of the numbers at random."""
        return int(self.keys[int(rng.integers(len(self.keys)))])

    def identity(self, key: int) -> Hashable:
        """Return what stands for the asset of a number, the same wherever it is taken for this task."""
        if self._known is None:
            return self.task
        if isinstance(self._known, Dataset):
            return self.task, str(self._known.directory), str(self._known.records[key]["path"])
        return self.task, self._known[key]

    def load(self, key: int) -> Asset:
        """Return the asset of a number.

        Raises:
            EnvError: There is none.
        """
        if key not in self.keys:
            raise EnvError(
                f"{self.task.name} has no asset {key!r}; its numbers are {self.keys[0]} to {self.keys[-1]}"
            )
        return self.task.generate(key) if self._known is None else self._known[key]


def _of_category(task: "Task", source: "str | Path | Dataset") -> Dataset:
    dataset = source if isinstance(source, Dataset) else Dataset(source)
    found = sorted({str(record["category"]) for record in dataset.records})
    if task.category not in found:
        held = f"assets of {', '.join(found)}" if found else "no assets"
        raise EnvError(
            f"{task.name} needs assets of the category {task.category!r}, but {dataset.directory} holds "
            f"{held}; `artgen generate {task.category} -n 100 --out FOLDER` makes some"
        )
    return dataset.filter(task.category)


def _checked(task: "Task", assets: Any) -> Sequence[Asset]:
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
