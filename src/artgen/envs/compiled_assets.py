"""Assets made ready for a task: compiled, with places for the robot; a process keeps those used last."""

import copy
from collections import OrderedDict
from collections.abc import Hashable
from typing import Any

import numpy as np

from artgen._caching import cached_property
from artgen.asset import Asset
from artgen.envs.assets import Assets
from artgen.envs.motion import Target
from artgen.envs.scene import Scene, compiled
from artgen.envs.task import Task
from artgen.errors import EnvError


class Ready:
    """An asset made ready for a task.

    Attributes:
        asset: The asset.
    """

    def __init__(self, task: Task, asset: Asset, key: int, *, visual: bool, textures: int) -> None:
        self.asset = asset
        self._task, self._key, self._visual, self._textures = task, key, visual, textures
        self._targets: dict[int, Target | str] = {}

    @cached_property
    def _model(self) -> Any:
        return compiled(self.asset, visual=self._visual, textures=self._textures)

    def scene(self) -> Scene:
        """Return a scene of its own, in which the robot may stand anywhere."""
        return Scene(self.asset, copy.copy(self._model))

    def target(self, number: int) -> Target:
        """Return one of the ways to set the task up; it depends on nothing but the asset and the number.

        Raises:
            EnvError: The asset lacks the part, or no place for the robot was found.
        """
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


_kept: OrderedDict[Hashable, Ready] = OrderedDict()


def ready(assets: Assets, key: int, *, visual: bool, textures: int, most: int) -> Ready:
    """Return an asset made ready, which all environments of a process share.

    Args:
        assets: The assets.
        key: Number of the asset.
        visual: Whether its model has what is seen.
        textures: Texels on a side of the maps.
        most: How many are kept, those used last.

    Raises:
        EnvError: There is no asset of that number.
    """
    name = (assets.identity(key), key, visual, textures)
    if name not in _kept:
        while len(_kept) >= most:
            _kept.popitem(last=False)
        _kept[name] = Ready(assets.task, assets.load(key), key, visual=visual, textures=textures)
    _kept.move_to_end(name)
    return _kept[name]
