"""Run benchmarks, print their results, and write them to docs/benchmarks.md. `make bench` runs all of them.

python benchmarks/run.py peers
python benchmarks/run.py stages textures --quick

Each benchmark writes its own section of the page at its end, so that an interrupted run leaves the other
sections unchanged. --quick measures very little, as a test of the programs, and writes no page by default.
"""

import importlib
import sys
from pathlib import Path
from typing import Annotated

import typer
from page import write_section
from report import Section, show
from rich.console import Console
from timing import empty_cache

from artgen.errors import ArtgenError, ParameterError, nearest

BENCHMARKS = {
    "peers": "bench_peers",
    "colliders": "bench_colliders",
    "certificate": "bench_certificate",
    "cost": "bench_cost",
    "scaling": "bench_scaling",
    "thousand": "bench_thousand",
    "training": "bench_training",
    "stages": "bench_stages",
    "textures": "bench_textures",
}
"""The module of each benchmark, by its name, in the order of the page."""

PAGE = Path(__file__).parents[1] / "docs" / "benchmarks.md"

_WIDTH = 200  # columns where there is no terminal


def measured(name: str, *, quick: bool) -> Section:
    """Run a benchmark with a temporary cache."""
    with empty_cache():
        section: Section = importlib.import_module(BENCHMARKS[name]).measure(quick=quick)
    return section


def main(
    names: Annotated[
        list[str] | None,
        typer.Argument(metavar="[NAME]...", help=f"Any of {', '.join(BENCHMARKS)}; all by default."),
    ] = None,
    *,
    quick: Annotated[
        bool, typer.Option("--quick", help="Measure very little, as a test of the programs.")
    ] = False,
    page: Annotated[
        Path | None, typer.Option(help="The page to write; docs/benchmarks.md by default, none with --quick.")
    ] = None,
) -> None:
    """Run benchmarks and print their tables; exit code 1 if one of them cannot be run."""
    target = page or (None if quick else PAGE)
    try:
        for name in names or BENCHMARKS:
            if name not in BENCHMARKS:
                raise ParameterError(f"there is no benchmark {name!r}.{nearest(name, BENCHMARKS)}")
        console = Console(width=None if sys.stdout.isatty() else _WIDTH)
        for name in names or BENCHMARKS:
            section = measured(name, quick=quick)
            show(console, name, section)
            if target is not None:
                write_section(target, name, section, list(BENCHMARKS))
    except ArtgenError as error:
        typer.echo(f"error: {error}", err=True)
        raise typer.Exit(1) from None


if __name__ == "__main__":
    typer.run(main)
