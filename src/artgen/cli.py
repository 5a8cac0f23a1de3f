"""The command line: lists categories, shows parameters, generates, proves and checks assets."""

import sys
from collections.abc import Sequence
from typing import Annotated, NoReturn

import typer

from artgen.catalog import broken, categories, find
from artgen.commands.checks import certify, check, colliders, validate
from artgen.commands.clients import clients
from artgen.commands.console import FAULT, INTERRUPTED, InterruptedRunError, console, table
from artgen.commands.datasets import demos, images
from artgen.commands.generate import export, generate
from artgen.commands.new import new
from artgen.commands.options import Category
from artgen.commands.pictures import render, sheet
from artgen.commands.view import gallery, graph, studio, view
from artgen.errors import ArtgenError, CheckError
from artgen.generator import Fixed, Parameter
from artgen.version import __version__

_WRONG_INPUT = 2  # exit code

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
        SystemExit: At the end, with the code 0, 1 for an asset with a fault, 2 for wrong input, which one
            line on stderr explains, or 130 after Ctrl-C.
    """
    try:
        code = app(args=arguments, prog_name="artgen", standalone_mode=False)
    except (ArtgenError, typer.TyperException) as error:
        message = error.format_message() if isinstance(error, typer.TyperException) else str(error)
        typer.echo(f"error: {' '.join(message.split())}", err=True)
        sys.exit(FAULT if isinstance(error, CheckError) else _WRONG_INPUT)
    except InterruptedRunError as error:
        typer.echo(error, err=True)
        sys.exit(INTERRUPTED)
    if code == INTERRUPTED:  # typer returns it after Ctrl-C
        typer.echo("interrupted", err=True)
    sys.exit(code if isinstance(code, int) else 0)


def _show_version(requested: bool) -> None:  # noqa: FBT001 - a callback of typer
    if requested:
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


def list_categories() -> None:
    """List the categories."""
    for message in broken().values():
        typer.echo(f"warning: {' '.join(message.split())}", err=True)
    result = table("category", "what it is", "joints", "parameters", "labels")
    for name in categories():
        category = find(name)
        summary = (category.__doc__ or "").strip().partition("\n")[0]
        joints = "" if category.joints is None else "-".join(map(str, dict.fromkeys(category.joints)))
        result.add_row(name, summary, joints, str(len(category.parameters())), ", ".join(category.labels))
    console().print(result)


def show_params(category: Category) -> None:
    """Show the parameters of a category, including those of its sub-generators."""
    result = table("parameter", "type", "distribution", "unit", "limits", "what it is")
    for name, parameter in find(category).parameters().items():
        distribution = parameter.distribution
        limits = "" if distribution.within is None else "{:g} to {:g}".format(*distribution.within)
        shown = f"always {distribution!r}" if isinstance(distribution, Fixed) else repr(distribution)
        result.add_row(name, _kind(parameter), shown, distribution.unit, limits, distribution.doc)
    console().print(result)


def _kind(parameter: Parameter) -> str:
    """Format the type of a parameter like its annotation."""
    if isinstance(parameter.kind, type):
        return parameter.kind.__name__
    return str(parameter.kind).removeprefix("typing.")


app.command(name="list")(list_categories)
for _command in (
    *(
        show_params,
        check,
        certify,
        validate,
        clients,
        colliders,
        demos,
        export,
        gallery,
        generate,
        graph,
        images,
    ),
    *(new, render, sheet, studio, view),
):
    app.command()(_command)
