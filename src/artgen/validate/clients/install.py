"""Installation of the environments of clients."""

import os
import shutil
import subprocess
import sys
from collections.abc import Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from artgen.errors import ClientError, nearest
from artgen.validate.clients.client import REQUIREMENTS
from artgen.validate.clients.install_location import UNFINISHED, python_of

if TYPE_CHECKING:
    from collections.abc import Iterator

Done = Literal["made", "there already", "made by hand"]

_RECORD = ".artgen-requirements"  # packages that artgen installed in an environment
_SHOWN = 300  # most characters of pip's error message


def install(
    environment: str,
    directory: Path,
    *,
    python: str = "",
    requirements: Mapping[str, Sequence[str]] = REQUIREMENTS,
) -> Done:
    """Create the environment of clients, unless it exists.

    An environment exists once pip has finished, so an interrupted installation starts again.
    """
    if environment not in requirements:
        raise ClientError(f"there is no environment {environment!r}.{nearest(environment, requirements)}")
    target = directory / environment
    wanted = "\n".join(requirements[environment]) + "\n"
    try:
        directory.mkdir(parents=True, exist_ok=True)
        with _only_one(directory / f".{environment}.lock", environment):
            record, whole = target / _RECORD, python_of(target) is not None
            if whole and record.is_file() and record.read_text(encoding="utf-8") == wanted:
                return "there already"
            if whole and not record.exists():
                return "made by hand"
            _make(target, requirements[environment], python or sys.executable)
            record.write_text(wanted, encoding="utf-8")
            (target / UNFINISHED).unlink()
    except OSError as error:
        raise ClientError(
            f"cannot make the environment {environment!r} in {target}: {error.strerror or error}"
        ) from error
    return "made"


def _make(target: Path, requirements: Sequence[str], python: str) -> None:
    if target.exists():
        shutil.rmtree(target)
    target.mkdir()
    (target / UNFINISHED).touch()
    _run([python, "-m", "venv", str(target)], target)
    program = target / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    quiet = ("--quiet", "--disable-pip-version-check", "--no-input")
    _run([str(program), "-m", "pip", "install", *quiet, *requirements], target)


def _run(command: Sequence[str], target: Path) -> None:
    done = subprocess.run(  # noqa: S603 - the command is artgen's own
        command, capture_output=True, text=True, check=False, stdin=subprocess.DEVNULL, errors="replace"
    )
    if done.returncode:
        lines = [line.strip() for line in (done.stdout + done.stderr).splitlines() if line.strip()]
        errors = [line for line in lines if line.upper().startswith("ERROR")] or lines[-1:]
        reason = (errors[-1] if errors else f"exit code {done.returncode}")[:_SHOWN]
        raise ClientError(
            f"cannot make the environment {target.name!r}: {reason} (of: {' '.join(command)}); "
            "mend that, or make it by hand there, and try again"
        )


@contextmanager
def _only_one(lock: Path, environment: str) -> "Iterator[None]":
    """Keep other processes from creating the same environment."""
    try:
        import fcntl
    except ImportError:  # missing on Windows
        yield
        return
    with lock.open("w") as file:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            raise ClientError(
                f"another process is making the environment {environment!r}; wait until it is done"
            ) from error
        yield
