"""The command line: `artgen COMMAND`; the modules of `artgen.commands` have the commands."""

import errno
import sys
from collections.abc import Sequence
from importlib import import_module
from io import TextIOWrapper
from typing import Annotated, NoReturn

import typer

from artgen.commands.console import FAULT, INTERRUPTED, InterruptedRunError
from artgen.errors import ArtgenError, CheckError, ParameterError, nearest
from artgen.version import __version__

COMMANDS = {
    "list": "info.list_categories", "info": "info.info", "card": "datasets.card", "check": "checks.check",
    "certify": "checks.certify", "validate": "checks.validate", "clients": "clients.clients",
    "colliders": "checks.colliders", "demos": "datasets.demos", "export": "generate.export",
    "gallery": "view.gallery", "generate": "generate.generate", "graph": "view.graph",
    "images": "datasets.images", "new": "new.new", "reach": "checks.reach", "render": "pictures.render",
    "scene": "generate.scene", "sheet": "pictures.sheet", "studio": "view.studio", "view": "view.view",
}  # fmt: skip
"""Module and function of each command, in `artgen.commands`."""

_WRONG_INPUT = 2  # exit code


def command_line(*names: str) -> typer.Typer:
    """Return the command line with the given commands, or with all; only their modules are imported."""
    app = typer.Typer(
        name="artgen",
        help="Generate articulated, simulation-ready assets.",
        add_completion=False,
        pretty_exceptions_enable=False,
        rich_markup_mode=None,
        callback=_options,
        invoke_without_command=True,
    )
    for name in names or COMMANDS:
        module, _, function = COMMANDS[name].partition(".")
        app.command(name)(getattr(import_module(f"artgen.commands.{module}"), function))
    return app


def main(arguments: Sequence[str] | None = None) -> NoReturn:
    """Run the command line.

    Args:
        arguments: Arguments after the name of the command; by default those of the process.

    Raises:
        SystemExit: At the end, with the code 0, 1 for an asset with a fault, 2 for wrong input, which one
            line on stderr explains, or 130 after Ctrl-C.
    """
    given = sys.argv[1:] if arguments is None else arguments
    if isinstance(sys.stdout, TextIOWrapper):
        sys.stdout.reconfigure(errors="replace")  # its encoding may lack characters of tables
    try:
        if given and not given[0].startswith("-") and given[0] not in COMMANDS:
            raise ParameterError(
                f"there is no command {given[0]!r}.{nearest(given[0], COMMANDS)} `artgen --help` lists them"
            )
        app = command_line(*(name for name in given[:1] if name in COMMANDS))
        code = app(args=arguments, prog_name="artgen", standalone_mode=False)
    except (ArtgenError, typer.TyperException) as error:
        message = error.format_message() if isinstance(error, typer.TyperException) else str(error)
        context, option = getattr(error, "ctx", None), getattr(error, "option_name", "")
        if option and context and any("--set" in each.opts for each in context.command.params):
            message += f"; a parameter is given as --set {option.lstrip('-').replace('-', '_')}=VALUE"
        typer.echo(f"error: {' '.join(message.split())}", err=True)
        sys.exit(FAULT if isinstance(error, CheckError) else _WRONG_INPUT)
    except InterruptedRunError as error:
        typer.echo(error, err=True)
        sys.exit(INTERRUPTED)
    except OSError as error:
        if error.errno != errno.ENAMETOOLONG:
            raise
        typer.echo(f"error: the file system refuses the name {error.filename!r}: it is too long", err=True)
        sys.exit(_WRONG_INPUT)
    if code == INTERRUPTED:  # typer returns it after Ctrl-C
        typer.echo("interrupted", err=True)
    sys.exit(code if isinstance(code, int) else 0)


def _show_version(requested: bool) -> None:  # noqa: FBT001 - a callback of typer
    if requested:
        typer.echo(f"artgen {__version__}")
        raise typer.Exit


def _options(
    context: typer.Context,
    *,
    version: Annotated[
        bool,
        typer.Option("--version", callback=_show_version, is_eager=True, help="Print the version and exit."),
    ] = False,
) -> None:
    """Generate articulated, simulation-ready assets."""
    if context.invoked_subcommand is None:
        typer.echo(context.get_help())
