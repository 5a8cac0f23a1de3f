"""`artgen clients`: installed simulators, validators and converters, and installation of others."""

import os
from pathlib import Path
from typing import Annotated

import typer
from rich.text import Text
from typer import Option

from artgen.commands.console import FAULT, console, progress, table
from artgen.errors import ClientError
from artgen.validate.clients.install import (
    OWN_PYTHON,
    environments_directory,
    how_to_get,
    installed,
    interpreters,
)
from artgen.validate.clients.install import install as install_environment
from artgen.validate.clients.registry import ALL, CLIENTS, REQUIREMENTS, Client, chosen_clients


def clients(
    *,
    install: Annotated[
        str | None,
        Option(metavar="NAMES", help=f"Clients to install: {ALL!r}, or names separated by commas."),
    ] = None,
    python: Annotated[
        Path | None, Option(help="Python program for the environments; artgen's own by default.")
    ] = None,
) -> None:
    """List the clients that read exports, or install them into their own environments.

    The environments are in the folder ARTGEN_CLIENTS, or in artgen's cache.
    """
    if install is not None:
        _install(install, python)
        return
    result = table("client", "reads", "layouts", "version", "where")
    for client in CLIENTS.values():
        version, place = installed(client)
        style = ""
        if not client.distribution:
            place = "a program of the system, searched when the client runs"
        elif not version:
            place, style = f"absent: {how_to_get(client)}", "yellow"
        result.add_row(client.name, client.format, ", ".join(client.layouts), version, Text(place, style))
    console().print(result)


def _install(names: str, python: Path | None) -> None:
    """Create the environments of the named clients as far as possible, and report the result."""
    found, by_name = chosen_clients(names)
    directory = environments_directory()
    program = "" if python is None else os.path.abspath(python)  # noqa: PTH100 - a link stays a link
    failed: list[ClientError] = []
    for environment in dict.fromkeys(client.environment for client in found if _needs_one(client, by_name)):
        typer.echo(f"{environment}: {', '.join(REQUIREMENTS[environment])}", err=True)
        try:
            with progress(f"install {environment}"):
                done = install_environment(environment, directory, python=program)
        except ClientError as error:
            failed.append(error)
            typer.echo(f"error: {' '.join(str(error).split())}", err=True)
        else:
            typer.echo(f"{directory / environment}: {done}")
    for client in found:
        if client.environment not in REQUIREMENTS and by_name:
            typer.echo(f"{client.name}: artgen cannot install it; {how_to_get(client)}", err=True)
            raise typer.Exit(FAULT)
    if failed:
        raise typer.Exit(FAULT)


def _needs_one(client: Client, by_name: bool) -> bool:  # noqa: FBT001 - private
    """Return whether a client needs an environment, because artgen's own does not have it."""
    if client.environment not in REQUIREMENTS:
        return False
    return by_name or not (client.environment == "light" and OWN_PYTHON in interpreters(client))
