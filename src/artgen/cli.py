"""The command line: lists categories, shows parameters, generates, proves and checks assets."""

import sys
from collections.abc import Sequence
from typing import Annotated, NoReturn

import typer
from rich.console import Console
from rich.table import Table

from artgen.catalog import broken, categories, find
from artgen.commands.certify import certify as certify_category
from artgen.commands.clients import clients
from artgen.commands.colliders import colliders
from artgen.commands.demos import demos
from artgen.commands.export import export
from artgen.commands.generate import generate
from artgen.commands.images import images
from artgen.commands.new import new
from artgen.commands.render import render
from artgen.commands.sheet import sheet
from artgen.commands.validate import validate
from artgen.commands.view import gallery, graph, studio, view
from artgen.errors import ArtgenError, CheckError
from artgen.generator import Fixed, Parameter
from artgen.version import __version__

_FAULT = 1  # exit code
_WRONG_INPUT = 2  # exit code
_PLAIN_WIDTH = 1000  # columns of tables in files and pipes: one line per row


app = typer.Typer(
    name="artgen",
    help="Generate articulated, simulation-ready assets.",
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
)


def main(arguments: Sequence[str] | None = None) -> NoReturn:
    """Run the command line.

    Args:
        arguments: Arguments after the name of the command; by default those of the process.

    Raises:
        SystemExit: At the end, with the code 0, 1 for an asset with a fault, or 2 for wrong input, which one
            line on stderr explains.
    """
    try:
        code = app(args=arguments, prog_name="artgen", standalone_mode=False)
    except (ArtgenError, typer.TyperException) as error:
        message = error.format_message() if isinstance(error, typer.TyperException) else str(error)
        typer.echo(f"error: {' '.join(message.split())}", err=True)
        sys.exit(_FAULT if isinstance(error, CheckError) else _WRONG_INPUT)
    except typer.Abort:
        sys.exit(1)
    sys.exit(code if isinstance(code, int) else 0)


def _show_version(wanted: bool) -> None:  # noqa: FBT001 - typer calls it so
    if wanted:
        typer.echo(f"artgen {__version__}")
        raise typer.Exit


@app.callback(invoke_without_command=True)
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


@app.command(name="list")
def list_categories() -> None:
    """List the categories."""
    for message in broken().values():
        typer.echo(f"warning: {' '.join(message.split())}", err=True)
    table = _table("category", "what it is", "joints", "parameters", "labels")
    for name in categories():
        category = find(name)
        summary = (category.__doc__ or "").strip().partition("\n")[0]
        joints = "" if category.joints is None else _range(*category.joints)
        table.add_row(name, summary, joints, str(len(category.parameters())), ", ".join(category.labels))
    _console().print(table)


@app.command()
def show_params(
    category: Annotated[
        str, typer.Argument(help="Name of a category, which `artgen list` shows, or a file that defines one.")
    ],
) -> None:
    """Show the parameters of a category, including those of its sub-generators."""
    found = find(category)
    table = _table("parameter", "type", "distribution", "unit", "limits", "what it is")
    for name, parameter in found.parameters().items():
        distribution = parameter.distribution
        limits = "" if distribution.within is None else "{:g} to {:g}".format(*distribution.within)
        shown = f"always {distribution!r}" if isinstance(distribution, Fixed) else repr(distribution)
        table.add_row(name, _kind(parameter), shown, distribution.unit, limits, distribution.doc)
    _console().print(table)


app.command(name="certify")(certify_category)
app.command()(validate)
app.command()(clients)
app.command()(colliders)
app.command()(demos)
app.command()(export)
app.command()(gallery)
app.command()(generate)
app.command()(graph)
app.command()(images)
app.command()(new)
app.command()(render)
app.command()(sheet)
app.command()(studio)
app.command()(view)


def _range(least: int, most: int) -> str:
    return str(least) if least == most else f"{least}-{most}"


def _kind(parameter: Parameter) -> str:
    """Format the type of a parameter like its annotation."""
    if isinstance(parameter.kind, type):
        return parameter.kind.__name__
    return str(parameter.kind).removeprefix("typing.")


def _table(*columns: str) -> Table:
    table = Table(box=None, pad_edge=False, header_style="bold")
    for column in columns:
        table.add_column(column, overflow="fold")
    return table


def _console() -> Console:
    """Return the console for tables, as wide as the terminal, or wide enough for a file."""
    return Console(width=None if sys.stdout.isatty() else _PLAIN_WIDTH, highlight=False)
