"""The certificate, made in another process so that nobody waits for it, and given up when it is outdated."""

import time
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any

from artgen.asset.certificate import Certificate
from artgen.catalog import find
from artgen.dataset.workers import Ending, Worker
from artgen.generator import Generator

_LIMIT = 600.0  # that a proof may take [s]


@dataclass(frozen=True)
class ProofTask:
    """The description of an asset for another process."""

    reference: str  # what the category is found by
    revision: int  # how often its file was loaded again
    seed: int  # what is drawn from
    attempts: int  # how often, at most
    overrides: Mapping[str, Any] = field(hash=False)  # what is set


@lru_cache(maxsize=1)
def _category(reference: str, revision: int) -> Generator:
    """Return the category, which is loaded again when its file was."""
    return find(reference)


def prove(task: ProofTask) -> Certificate:
    """Make the asset and certify it."""
    generator = _category(task.reference, task.revision)
    asset, _ = generator.evaluate(task.seed, attempts=task.attempts, certify=False, overrides=task.overrides)
    return asset.certify()


class Prover:
    """Certifies one asset at a time in a process of its own, which is started when it is first needed."""

    def __init__(self) -> None:
        self._worker: Worker | None = None
        self._busy = False

    @property
    def busy(self) -> bool:
        """Whether a proof is being made."""
        return self._busy

    def start(self, task: ProofTask) -> None:
        """Begin a proof; one that was being made is given up."""
        self.cancel()
        if self._worker is None:
            self._worker = Worker(prove, task, _LIMIT)
        else:
            self._worker.give(task)
        self._busy = True

    def cancel(self) -> None:
        """Give up the proof that is being made, if any."""
        if self._busy:
            self.close()

    def poll(self) -> Ending | None:
        """Return how the proof ended; None if it has not, or none was begun."""
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
        """Return how the proof ended, after that time at most; None if it has not."""
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
