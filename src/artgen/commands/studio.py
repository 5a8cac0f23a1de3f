"""`artgen studio`: a category in the browser, seen while it is made."""

import time
import webbrowser
from pathlib import Path
from typing import Annotated

import typer

from artgen.commands.source import Category, Overrides, Seed
from artgen.generator.overrides import parse_overrides


def studio(
    category: Category,
    *,
    seed: Seed = 0,
    overrides: Overrides = None,
    host: Annotated[
        str, typer.Option(help="Where to serve; 0.0.0.0 lets in other machines that have the token.")
    ] = "127.0.0.1",
    port: Annotated[int, typer.Option(help="Where to serve; 0 takes any that is free.")] = 8080,
    out: Annotated[
        Path, typer.Option(metavar="DIRECTORY", help="The page exports files below this folder only.")
    ] = Path("out"),
    opening: Annotated[bool, typer.Option("--open/--no-open", help="Open it in the browser.")] = True,
) -> None:
    """Turn the parameters and joints of a category in the browser; needs artgen[studio].

    The file of the category is loaded again when it is saved. Ctrl-C ends the studio.
    """
    from artgen.studio import Session, Source
    from artgen.studio.app import Studio

    session = Session(Source(category), seed, parse_overrides(overrides or []))
    served = Studio(session, host, port, out=out)
    try:
        typer.echo(f"{session.source.generator.name} in the studio: {served.address} (Ctrl-C ends it)")
        if opening:
            webbrowser.open(served.address)
        while True:
            time.sleep(1.0)
    except KeyboardInterrupt:
        typer.echo("\nthe studio is closed")
    finally:
        served.close()
