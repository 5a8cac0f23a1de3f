"""What a run that was interrupted has made: the same run goes on from there."""

import json
import os
import shutil
from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np

from artgen.dataset.workers import Ending
from artgen.demos.episode import Demo

_PLAN = "plan.json"
_SERIES = ("actions", "applied", "rewards", "dones", "states")
_SEEN = "obs/"


class Kept:
    """A folder with a file for each attempt that has ended, whether it succeeded or not."""

    def __init__(self, folder: Path, plan: Mapping[str, Any]) -> None:
        self._folder, self._plan = folder, json.dumps(dict(plan), sort_keys=True)
        try:
            same = (folder / _PLAN).read_text(encoding="utf-8") == self._plan
        except (OSError, ValueError):
            same = False
        if folder.exists() and not same:
            shutil.rmtree(folder)

    def of(self, seeds: Iterable[int]) -> dict[int, Path]:
        """Return the files of those seeds that have one."""
        return {seed: path for seed in seeds if (path := self._folder / f"{seed}.npz").exists()}

    def saved(self, endings: Iterable[Ending]) -> Iterator[Ending]:
        """Yield endings, each once it is on the disk; where a process was killed, a next run tries again."""
        for ending in endings:
            if ending.state in ("done", "failed"):
                self._save(ending)
            yield ending

    def remove(self) -> None:
        """Remove the folder."""
        shutil.rmtree(self._folder, ignore_errors=True)

    def _save(self, ending: Ending) -> None:
        if not self._folder.exists():
            self._folder.mkdir(parents=True)
            (self._folder / _PLAN).write_text(self._plan, encoding="utf-8")
        demo: Demo | None = ending.value
        content: dict[str, Any] = {"message": np.array(ending.message)}
        if demo is not None:
            content |= {key: np.asarray(getattr(demo, key)) for key in ("asset", "success", *_SERIES)}
            content |= {_SEEN + key: each for key, each in demo.observations.items()}
        partial = self._folder / f".{ending.item}.{os.getpid()}"
        try:
            with partial.open("wb") as file:
                np.savez(file, allow_pickle=False, **content)
            partial.replace(self._folder / f"{ending.item}.npz")
        except BaseException:
            with suppress(OSError):
                partial.unlink(missing_ok=True)
            raise


def read(seed: int, path: Path) -> Ending:
    """Read how an attempt ended."""
    with np.load(path, allow_pickle=False) as content:
        if "asset" not in content:
            return Ending(seed, "failed", message=str(content["message"]))
        seen = {key.removeprefix(_SEEN): content[key] for key in content.files if key.startswith(_SEEN)}
        series = {key: content[key] for key in _SERIES}
        return Ending(
            seed, "done", Demo(seed, str(content["asset"]), bool(content["success"]), seen, **series)
        )
