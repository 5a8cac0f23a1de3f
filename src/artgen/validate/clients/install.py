"""Environments of clients: artgen's own, or one of their own, which `install` creates."""

import importlib.metadata
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Literal

from artgen._disk_cache import cache_directory
from artgen.errors import ClientError, nearest
from artgen.validate.clients.registry import REQUIREMENTS, Client

VARIABLE = "ARTGEN_CLIENTS"
"""Environment variable that names the folder of the clients' environments."""

UNFINISHED = ".artgen-unfinished"
"""File in an unfinished environment; while it exists, the environment is not used."""

OWN_PYTHON = Path(sys.executable)
"""Python program of artgen's own environment."""

_RECORD = ".artgen-requirements"  # packages that artgen installed in an environment
_SHOWN = 300  # most characters of pip's error message


def environments_directory() -> Path:
    """Return the folder of the clients' environments: `$ARTGEN_CLIENTS`, or `clients` in artgen's cache.

    Raises:
        ClientError: The variable is not set and the cache is off.
    """
    if chosen := os.environ.get(VARIABLE):
        return Path(chosen)
    cache = cache_directory()
    if cache is None:
        raise ClientError(
            f"the environments of clients have no folder, because the cache is off; name one in {VARIABLE}"
        )
    return cache / "clients"


def python_of(environment: Path) -> Path | None:
    """Return the Python program of an environment; None if it is missing or unfinished."""
    # a client has another working directory; the path of the link, not of its target, gives the environment
    program = Path(os.path.abspath(_program(environment)))  # noqa: PTH100
    return program if program.is_file() and not (environment / UNFINISHED).exists() else None


def _program(environment: Path) -> Path:
    return environment / ("Scripts/python.exe" if os.name == "nt" else "bin/python")


def interpreters(client: Client) -> list[Path]:
    """Return the Python programs that may have a client, the likeliest first."""
    if not client.environment:
        return [OWN_PYTHON]
    own = [OWN_PYTHON] if _version(client, sys.path) else []
    try:
        program = python_of(environments_directory() / client.environment)
    except ClientError:
        return own
    separate = [] if program is None else [program]
    return own + separate if client.environment == "light" else separate + own


def installed(client: Client) -> tuple[str, str]:
    """Return the version of a client and its location: `artgen's own`, or the folder of its environment.

    Both are empty for a missing client, and for a system program, which only its driver finds.
    """
    for program in interpreters(client) if client.distribution else ():
        environment = program.parent.parent
        folders = [*environment.glob("lib/python*/site-packages"), *environment.glob("Lib/site-packages")]
        own = program == OWN_PYTHON
        if version := _version(client, sys.path if own else [str(folder) for folder in folders]):
            return version, "artgen's own" if own else str(environment)
    return "", ""


def _version(client: Client, path: list[str]) -> str:
    """Return the version of a client's distribution in folders; empty if it is missing."""
    found = importlib.metadata.distributions(name=client.distribution, path=path)
    return next((each.version for each in found), "")


def how_to_get(client: Client) -> str:
    """Return how to get a client."""
    return client.obtain or f"artgen clients --install {client.name}"


def install(
    environment: str,
    directory: Path,
    *,
    python: str = "",
    requirements: Mapping[str, Sequence[str]] = REQUIREMENTS,
) -> Literal["made", "there already", "made by hand"]:
    """Create the environment of clients, unless it exists.

    An environment exists once pip has finished, so an interrupted installation starts again.

    Raises:
        ClientError: There is no such environment, or it cannot be created.
    """
    if environment not in requirements:
        raise ClientError(f"there is no environment {environment!r}.{nearest(environment, requirements)}")
    target = directory / environment
    packages = "\n".join(requirements[environment]) + "\n"
    try:
        directory.mkdir(parents=True, exist_ok=True)
        with _only_one(directory / f".{environment}.lock", environment):
            record, complete = target / _RECORD, python_of(target) is not None
            if complete and not record.exists():
                return "made by hand"
            if complete and record.read_text(encoding="utf-8") == packages:
                return "there already"
            _create(target, requirements[environment], python or sys.executable)
            record.write_text(packages, encoding="utf-8")
            (target / UNFINISHED).unlink()
    except OSError as error:
        raise ClientError(
            f"cannot make the environment {environment!r} in {target}: {error.strerror or error}"
        ) from error
    return "made"


def _create(target: Path, requirements: Sequence[str], python: str) -> None:
    if target.exists():
        shutil.rmtree(target)
    target.mkdir()
    (target / UNFINISHED).touch()
    _run([python, "-m", "venv", str(target)], target)
    quiet = ("--quiet", "--disable-pip-version-check", "--no-input")
    _run([str(_program(target)), "-m", "pip", "install", *quiet, *requirements], target)


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
            "fix that, or make the environment there by hand, and try again"
        )


@contextmanager
def _only_one(lock: Path, environment: str) -> Iterator[None]:
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
