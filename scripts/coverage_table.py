"""Write docs/coverage.md: the draws of 500 seeds of every category. `make coverage-table` runs this."""

from pathlib import Path
from typing import Annotated

import typer
from surveys.coverage import coverage
from surveys.pages import coverage_page

from artgen.catalog import categories, find

PAGE = Path(__file__).parents[1] / "docs" / "coverage.md"


def main(
    seeds: Annotated[int, typer.Option(min=1, help="Number of seeds of each category, from 0.")] = 500,
    out: Annotated[Path, typer.Option(help="The page to write.")] = PAGE,
) -> None:
    """Write the page; exit code 1 if an option never occurs or a range is not filled."""
    found = [coverage(find(name), seeds) for name in categories()]
    out.write_text(coverage_page(found), encoding="utf-8")
    typer.echo(out)
    wrong = [f"{each.category}: {text}" for each in found for text in each.faults]
    for line in wrong:
        typer.echo(line, err=True)
    if wrong:
        raise typer.Exit(1)


if __name__ == "__main__":
    typer.run(main)
