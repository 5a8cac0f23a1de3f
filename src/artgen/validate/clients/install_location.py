"""Locations of clients: artgen's own environment, or an environment of their own."""

import importlib.metadata
import os
import sys
from collections.abc import Iterator
from pathlib import Path

from artgen._disk_cache import cache_directory
from artgen.errors import ClientError
from artgen.validate.clients.client import REQUIREMENTS, Client

VARIABLE = "ARTGEN_CLIENTS"
"""Environment variable that names the folder of the clients' environments."""

UNFINISHED = ".artgen-unfinished"
"""File in an unfinished environment; while it exists, the environment is not used."""


def environments_directory() -> Path:
    """Return the folder of the clients' environments: `$ARTGEN_CLIENTS`, or `clients` in artgen's cache."""
    if chosen := os.environ.get(VARIABLE):
        return Path(chosen)
    cache = cache_directory()
    if cache is None:
        raise ClientError(
            f"there is no folder for the environments of clients, as the cache is off; name one in {VARIABLE}"
        )
    return cache / "clients"


def interpreters(client: Client | None) -> list[Path]:
    """Return the Python programs that may have a client, the likeliest first; for None, artgen's own."""
    own = [Path(sys.executable)] if sys.executable else []
    if client is None:
        return own
    if not client.distribution or not client.environment:
        return own
    here = own if _version_here(client.distribution) else []
    try:
        program = python_of(environments_directory() / client.environment)
    except ClientError:
        return here
    apart = [] if program is None else [program]
    return here + apart if client.light else apart + here


def python_of(environment: Path) -> Path | None:
    """Return the Python program of an environment; None if it is missing or unfinished."""
    program = environment / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    # a relative path would be resolved in the working directory of the client
    program = Path(os.path.abspath(program))  # noqa: PTH100 - the link of an environment says which one it is
    return program if program.is_file() and not (environment / UNFINISHED).exists() else None


def installed(client: Client) -> tuple[str, str]:
    """Return the version of a client and its location: `artgen's own`, or the folder of its environment.

    Both are empty for a missing client, and for a system program, which only its driver finds.
    """
    if not client.distribution:
        return "", ""
    for program in interpreters(client):
        if program in interpreters(None):
            return _version_here(client.distribution), "artgen's own"
        environment = program.parent.parent
        version = next(_versions(environment, client.distribution), "")
        if version:
            return version, str(environment)
    return "", ""


def how_to_get(client: Client) -> str:
    """Return how to get a client."""
    if client.obtain:
        return client.obtain
    if client.environment in REQUIREMENTS:
        return f"artgen clients --install {client.name}"
    return f"install {client.distribution or client.name}"


def _version_here(distribution: str) -> str:
    try:
        return importlib.metadata.version(distribution)
    except importlib.metadata.PackageNotFoundError:
        return ""


def _versions(environment: Path, distribution: str) -> Iterator[str]:
    places = [
        str(path)
        for pattern in ("lib/python*/site-packages", "Lib/site-packages")
        for path in environment.glob(pattern)
    ]
    for found in importlib.metadata.distributions(name=distribution, path=places):
        yield found.version
