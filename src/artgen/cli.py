"""The command line: list categories, show their parameters, generate assets."""

import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Any, Literal

import typer
from rich.console import Console
from rich.table import Table
from typer.core import TyperGroup

from artgen.asset import Asset
from artgen.catalog import category_names, find_category
from artgen.errors import ArtgenError
from artgen.export import FORMATS
from artgen.generator import Fixed, Generator, Parameter
from artgen.nodes.handles import Float
from artgen.overrides import parse_overrides
from artgen.version import __version__

_WRONG_INPUT = 2  # exit code
_PLAIN_WIDTH = 150  # columns of a table that is not written to a terminal


class _Commands(TyperGroup):
    """Commands that say in one line what was wrong with their input."""

    def main(self, *args: Any, standalone_mode: bool = True, **extra: Any) -> Any:
        """Run the command line.

        Raises:
            SystemExit: It is done; 2 is wrong input.
        """
        if not standalone_mode:
            return super().main(*args, standalone_mode=False, **extra)
        try:
            code = super().main(*args, standalone_mode=False, **extra)
        except (ArtgenError, typer.TyperException) as error:
            message = error.format_message() if isinstance(error, typer.TyperException) else str(error)
            typer.echo(f"error: {' '.join(message.split())}", err=True)
            sys.exit(_WRONG_INPUT)
        except typer.Abort:
            sys.exit(1)
        sys.exit(code if isinstance(code, int) else 0)


app = typer.Typer(
    cls=_Commands,
    name="artgen",
    help="Generate articulated, simulation-ready assets.",
    no_args_is_help=True,
    add_completion=False,
    rich_markup_mode=None,
)


def main() -> None:
    """Run the command line."""
    app(prog_name="artgen")


def _show_version(wanted: bool) -> None:  # noqa: FBT001 - typer calls it so
    if wanted:
        typer.echo(f"artgen {__version__}")
        raise typer.Exit


@app.callback()
def _options(
    *,
    version: Annotated[
        bool,
        typer.Option("--version", callback=_show_version, is_eager=True, help="Print the version and exit."),
    ] = False,
) -> None:
    """Generate articulated, simulation-ready assets."""


@app.command(name="list")
def list_categories() -> None:
    """List the categories."""
    table = _table("category", "what it is", "labels", "parameters")
    for name in category_names():
        category = find_category(name)
        summary = (category.__doc__ or "").strip().partition("\n")[0]
        table.add_row(name, summary, ", ".join(category.labels), str(len(category.parameters())))
    _console().print(table)


@app.command()
def show_params(
    category: Annotated[str, typer.Argument(help="Name of a category; `artgen list` shows them.")],
) -> None:
    """Show what varies in a category, the parameters of its sub-generators included."""
    found = find_category(category)
    table = _table("parameter", "type", "distribution", "unit", "limits", "what it is")
    for name, parameter in found.parameters().items():
        distribution = parameter.distribution
        limits = "" if distribution.within is None else f"{distribution.within[0]:g} to {distribution.within[1]:g}"
        shown = f"always {distribution!r}" if isinstance(distribution, Fixed) else repr(distribution)
        table.add_row(name, _kind(parameter), shown, distribution.unit, limits, distribution.doc)
    _console().print(table)


@app.command()
def generate(
    category: Annotated[str, typer.Argument(help="Name of a category; `artgen list` shows them.")],
    *,
    seed: Annotated[int, typer.Option(help="Decides every draw: the same seed, the same bytes.")] = 0,
    overrides: Annotated[
        list[str] | None,
        typer.Option(
            "--set",
            metavar="NAME=VALUE",
            help="A value or distribution for a parameter: width=0.9, hand=left, 'width=uniform(0.8, 0.9)'. "
            "May be given several times.",
        ),
    ] = None,
    formats: Annotated[
        str, typer.Option("--format", metavar="NAMES", help=f"What to write, of {', '.join(FORMATS)}.")
    ] = ",".join(FORMATS),
    out: Annotated[
        Path | None, typer.Option(metavar="DIRECTORY", help="Where to; ./<name of the asset> by default.")
    ] = None,
    base: Annotated[
        Literal["fixed", "free"], typer.Option(help="Whether the asset is fixed to the world.")
    ] = "fixed",
    name: Annotated[str, typer.Option(help="Name of the asset; category and seed by default.")] = "",
) -> None:
    """Generate an asset and print the paths of what was written."""
    chosen = [item.strip() for item in formats.split(",") if item.strip()]
    if not chosen:
        raise typer.BadParameter(f"--format {formats!r} names no format; choose of {', '.join(FORMATS)}")
    found = find_category(category)
    values = _with_generators(found, parse_overrides(overrides or ()))
    asset, _ = found.evaluate(seed, name=name, base=base, overrides=values)
    directory = asset.export(Path(asset.name) if out is None else out, formats=chosen)
    for path in _main_files(directory, asset):
        typer.echo(path)


def _with_generators(category: Generator, overrides: dict[str, Any]) -> dict[str, Any]:
    return overrides


def _main_files(directory: Path, asset: Asset) -> Sequence[Path]:
    """Return the files that a simulator opens."""
    return [path for path in sorted(directory.glob(f"{asset.name}.*")) if path.is_file()]


def _kind(parameter: Parameter) -> str:
    """Spell the type of a parameter as authors annotate it."""
    if parameter.kind is Float:
        return "Float"
    return getattr(parameter.kind, "__name__", str(parameter.kind))


def _table(*columns: str) -> Table:
    table = Table(box=None, pad_edge=False, header_style="bold")
    for column in columns:
        table.add_column(column, overflow="fold")
    return table


def _console() -> Console:
    """Return where tables go: as wide as the terminal, or wide enough for a file."""
    return Console(width=None if sys.stdout.isatty() else _PLAIN_WIDTH, highlight=False)
