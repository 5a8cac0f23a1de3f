"""scene-synthesizer in a separate environment, which is created on first use."""

import json
import os
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import IO, Any

from artgen.errors import ClientError
from artgen.validate.clients.install import VARIABLE, install, python_of

ENVIRONMENT = "scene_synthesizer"
REQUIREMENTS = {ENVIRONMENT: ("scene-synthesizer>=1.15",)}

_PLACE = Path(__file__).parents[1] / ".clients"
_PROGRAM = Path(__file__).with_name("peer_worker.py")


class Peer:
    """A process that makes assets with scene-synthesizer.

    Attributes:
        version: Version of scene-synthesizer.
    """

    def __init__(self, answers: IO[str], requests: IO[str]) -> None:
        self._answers = answers
        self._requests = requests
        self.version: str = self._answer()["version"]

    def make(self, kind: str, seed: int, path: Path) -> float:
        """Make an asset of a class, write it as URDF, and return the processor time [s].

        Raises:
            ClientError: The peer fails.
        """
        self._requests.write(json.dumps({"kind": kind, "seed": seed, "path": str(path)}) + "\n")
        self._requests.flush()
        answer = self._answer()
        if "error" in answer:
            raise ClientError(f"scene-synthesizer cannot make {kind} of seed {seed}: {answer['error']}")
        return float(answer["seconds"])

    def _answer(self) -> dict[str, Any]:
        line = self._answers.readline()
        if not line:
            raise ClientError(
                f"scene-synthesizer ended before it answered; try its environment by hand: {_PROGRAM.name}"
            )
        answer: dict[str, Any] = json.loads(line)
        return answer


def directory() -> Path:
    """Return the folder of the environment: `$ARTGEN_CLIENTS`, or `.clients` beside the Makefile."""
    return Path(os.environ.get(VARIABLE) or _PLACE)


@contextmanager
def peer() -> Iterator[Peer]:
    """Start the process, and end it on exit.

    Raises:
        ClientError: Its environment cannot be made.
    """
    install(ENVIRONMENT, directory(), requirements=REQUIREMENTS)
    program = python_of(directory() / ENVIRONMENT)
    if program is None:
        raise ClientError(
            f"there is no Python in the environment of scene-synthesizer, {directory() / ENVIRONMENT}; "
            "remove that folder and try again"
        )
    with subprocess.Popen(  # noqa: S603 - the program beside this one
        [str(program), str(_PROGRAM)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
    ) as process:
        assert process.stdin is not None
        assert process.stdout is not None
        try:
            yield Peer(process.stdout, process.stdin)
        finally:
            process.kill()
