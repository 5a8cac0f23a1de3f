"""Draw the contact sheets of the documentation: docs/CATEGORY.jpg and kitchens.jpg; `make sheets` runs it."""

from functools import partial
from pathlib import Path
from typing import Annotated

import typer

from artgen.catalog import categories
from artgen.commands.pictures import sheet
from artgen.scene import kitchen
from artgen.view import sheet as page

DOCS = Path(__file__).parents[1] / "docs"


def main(
    names: Annotated[
        list[str] | None, typer.Argument(help="Categories, or kitchens; all by default.")
    ] = None,
    *,
    seeds: Annotated[int, typer.Option(min=1, help="Number of samples.")] = 12,
    first_seed: Annotated[int, typer.Option(min=0, help="The first of their seeds.")] = 0,
    out: Annotated[Path, typer.Option(help="Directory.")] = DOCS,
) -> None:
    """Draw a sheet of each category with the best installed renderer."""
    for name in names or [*categories(), "kitchens"]:
        if name == "kitchens":
            rooms = [
                partial(kitchen, seed, detail="medium") for seed in range(first_seed, first_seed + seeds)
            ]
            typer.echo(page.save_sheet(page.sheet(rooms, views=1, size=300), out / "kitchens.jpg"))
            continue
        sheet(name, seeds=seeds, first_seed=first_seed, out=out / f"{name}.jpg")


if __name__ == "__main__":
    typer.run(main)
