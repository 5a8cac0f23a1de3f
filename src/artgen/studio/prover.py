"""Certification in another process, cancelled when it is outdated."""

import time
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any

from artgen.asset.certificate import Certificate
from artgen.catalog import find
from artgen.dataset.workers import Ending, Worker
from artgen.generator import Generator

_LIMIT = 600.0  # time limit of a proof [s]


@dataclass(frozen=True)
class ProofTask:
    """The description of an asset for another process."""

    reference: str  # reference of the category
    revision: int  # number of reloads of its file
    seed: int  # seed
    attempts: int  # most draws
    overrides: Mapping[str, Any] = field(hash=False)  # overrides


@lru_cache(maxsize=1)
def _category(reference: str, revision: int) -> Generator:
    """Return the category, loaded again if its file was."""
    return find(reference)


def prove(task: ProofTask) -> Certificate:
    """Generate the asset and certify it."""
    generator = _category(task.reference, task.revision)
    asset, _ = generator.evaluate(task.seed, attempts=task.attempts, certify=False, overrides=task.overrides)
    return asset.certify()


class Prover:
    """Certifies one asset at a time in its own process, which starts on first use."""

    def __init__(self) -> None:
        self._worker: Worker | None = None
        self._busy = False

    @property
    def busy(self) -> bool:
        """Whether a proof is running."""
        return self._busy

    def start(self, task: ProofTask) -> None:
        """Start a proof and cancel a running one."""
        self.cancel()
        if self._worker is None:
            self._worker = Worker(prove, task, _LIMIT)
        else:
            self._worker.give(task)
        self._busy = True

    def cancel(self) -> None:
        """Cancel the running proof, if any."""
        if self._busy:
            self.close()

    def poll(self) -> Ending | None:
        """Return the result of the proof; None while it runs, or without a proof."""
        if self._worker is None or not self._busy:
            return None
        ending = self._worker.ending(readable=self._worker.pipe.poll())
        if ending is None:
            return None
        self._busy = False
        if ending.state not in ("done", "failed"):
            self.close()
        return ending

    def wait(self, seconds: float) -> Ending | None:
        """Return the result of the proof after at most a time; None if it still runs."""
        end = time.monotonic() + seconds
        while self._busy and time.monotonic() < end:
            ending = self.poll()
            if ending is not None:
                return ending
            time.sleep(0.02)
        return None

    def close(self) -> None:
        """End the process."""
        if self._worker is not None:
            self._worker.stop()
        self._worker = None
        self._busy = False
