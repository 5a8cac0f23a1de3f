"""Draw the contact sheets of the documentation: docs/CATEGORY.jpg, kitchens.jpg, rooms.jpg and outputs.jpg.

`make sheets` runs it.
"""

from functools import partial
from itertools import cycle
from pathlib import Path
from typing import Annotated

import typer

from artgen.asset import Asset
from artgen.catalog import categories, generate
from artgen.commands.pictures import sheet
from artgen.scene import ROOMS, kitchen
from artgen.view import sheet as page

_OTHERS = [room.generate for name, room in ROOMS.items() if name != "kitchen"]
DOCS = Path(__file__).parents[1] / "docs"
_SHINING = ((("lamp", 2), ("cooktop", 1), ("globe", 7)), (("lamp", 0), ("cooktop", 3), ("refrigerator", 1)))
"""Categories and seeds of products, in rows that are drawn off and then on."""


def _used(name: str, seed: int, value: float) -> Asset:
    """Return a product whose lights have a value."""
    asset = generate(name, seed=seed)
    return asset.with_outputs({each.name: value for each in asset.outputs if each.color is not None})


def main(
    names: Annotated[
        list[str] | None, typer.Argument(help="Categories, kitchens, rooms or outputs; all by default.")
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
        "outputs": [partial(_used, *each, value) for row in _SHINING for value in (0.0, 1.0) for each in row],
    }
    for name in names or [*categories(), *scenes]:
        if name in scenes:
            drawn = page.sheet(scenes[name], views=1, size=300)
            typer.echo(page.save_sheet(drawn, out / f"{name}.jpg"))
            continue
        sheet(name, seeds=seeds, first_seed=first_seed, out=out / f"{name}.jpg")


if __name__ == "__main__":
    typer.run(main)
