"""Draw the contact sheets of the documentation, docs/<category>.jpg. `make sheets` runs this."""

from pathlib import Path
from typing import Annotated

import typer

from artgen.catalog import categories
from artgen.commands.pictures import sheet

DOCS = Path(__file__).parents[1] / "docs"


def main(
    names: Annotated[list[str] | None, typer.Argument(help="Categories; all by default.")] = None,
    *,
    seeds: Annotated[int, typer.Option(min=1, help="Number of samples.")] = 12,
    first_seed: Annotated[int, typer.Option(min=0, help="The first of their seeds.")] = 0,
    out: Annotated[Path, typer.Option(help="Directory.")] = DOCS,
) -> None:
    """Draw a sheet of each category with the best installed renderer."""
    for name in names or categories():
        sheet(name, seeds=seeds, first_seed=first_seed, out=out / f"{name}.jpg")


if __name__ == "__main__":
    typer.run(main)
