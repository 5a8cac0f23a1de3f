"""Draw the contact sheets of the documentation: docs/CATEGORY.jpg, kitchens.jpg and rooms.jpg.

`make sheets` runs it.
"""

from functools import partial
from itertools import cycle
from pathlib import Path
from typing import Annotated

import typer

from artgen.catalog import categories
from artgen.commands.pictures import sheet
from artgen.scene import ROOMS, kitchen
from artgen.view import sheet as page

_OTHERS = [room.generate for name, room in ROOMS.items() if name != "kitchen"]
DOCS = Path(__file__).parents[1] / "docs"


def main(
    names: Annotated[
        list[str] | None, typer.Argument(help="Categories, kitchens or rooms; all by default.")
    ] = None,
    *,
    seeds: Annotated[int, typer.Option(min=1, help="Number of samples.")] = 12,
    first_seed: Annotated[int, typer.Option(min=0, help="The first of their seeds.")] = 0,
    out: Annotated[Path, typer.Option(help="Directory.")] = DOCS,
) -> None:
    """Draw a sheet of each category with the best installed renderer."""
    numbers = range(first_seed, first_seed + seeds)
    scenes = {
        "kitchens": [partial(kitchen, seed, detail="medium") for seed in numbers],
        "rooms": [
            partial(room, first_seed + number // len(_OTHERS), detail="medium")
            for number, room in zip(range(seeds), cycle(_OTHERS), strict=False)
        ],
    }
    for name in names or [*categories(), *scenes]:
        if name in scenes:
            drawn = page.sheet(scenes[name], views=1, size=300)
            typer.echo(page.save_sheet(drawn, out / f"{name}.jpg"))
            continue
        sheet(name, seeds=seeds, first_seed=first_seed, out=out / f"{name}.jpg")


if __name__ == "__main__":
    typer.run(main)
