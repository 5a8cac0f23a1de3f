"""Programs of other packages in environments of their own, which are created on first use."""

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
WARP = "mujoco-warp"
REQUIREMENTS = {ENVIRONMENT: ("scene-synthesizer>=1.15",), WARP: ("mujoco-warp>=4.0", "mujoco>=4.0")}

_PLACE = Path(__file__).parents[1] / ".clients"
_PROGRAMS = {ENVIRONMENT: "peer_worker.py", WARP: "warp_worker.py"}


class Peer:
    """A process of another package, which answers requests.

    Attributes:
        version: Version of the package.
    """

    def __init__(self, name: str, answers: IO[str], requests: IO[str]) -> None:
        self._name = name
        self._answers = answers
        self._requests = requests
        self.version: str = self._answer()["version"]

    def ask(self, **request: Any) -> dict[str, Any]:
        """Return the answer to a request of the program.

        Raises:
            ClientError: The program fails.
        """
        self._requests.write(json.dumps(request) + "\n")
        self._requests.flush()
        answer = self._answer()
        if "error" in answer:
            raise ClientError(f"{self._name} cannot do {request}: {answer['error']}")
        return answer

    def make(self, kind: str, seed: int, path: Path) -> float:
        """Let scene-synthesizer make an asset of a class as URDF, and return the processor time [s].

        Raises:
            ClientError: It fails.
        """
        return float(self.ask(kind=kind, seed=seed, path=str(path))["seconds"])

    def _answer(self) -> dict[str, Any]:
        line = self._answers.readline()
        if not line:
            raise ClientError(
                f"{self._name} ended before it answered; try its environment by hand: {_PROGRAMS[self._name]}"
            )
        answer: dict[str, Any] = json.loads(line)
        return answer


def directory() -> Path:
    """Return the folder of the environments: `$ARTGEN_CLIENTS`, or `.clients` beside the Makefile."""
    return Path(os.environ.get(VARIABLE) or _PLACE)


@contextmanager
def peer(name: str = ENVIRONMENT) -> Iterator[Peer]:
    """Start the process of an environment, and end it on exit.

    Raises:
        ClientError: Its environment cannot be made.
    """
    install(name, directory(), requirements=REQUIREMENTS)
    program = python_of(directory() / name)
    if program is None:
        raise ClientError(
            f"there is no Python in the environment of {name}, {directory() / name}; remove that folder and "
            "try again"
        )
    with subprocess.Popen(  # noqa: S603 - the program beside this one
        [str(program), str(Path(__file__).with_name(_PROGRAMS[name]))],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
    ) as process:
        assert process.stdin is not None
        assert process.stdout is not None
        try:
            yield Peer(name, process.stdout, process.stdin)
        finally:
            process.kill()
