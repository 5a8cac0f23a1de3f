"""Draw docs/family.jpg: one product of every category, partly open. `make sheets` runs this too."""

from pathlib import Path
from typing import Annotated

import numpy as np
import typer
from PIL import Image, ImageDraw, ImageFont

from artgen.asset import Asset
from artgen.catalog import categories, find
from artgen.view.rendering import render
from artgen.view.sheet import save_sheet, shots

DOCS = Path(__file__).parents[1] / "docs"
SEEDS: dict[str, int] = {"box": 2, "lamp": 9, "trashcan": 6, "window": 6}
"""The seeds of those that are shown; 0 where none is named."""

_OPEN = 0.55  # share of how far they open on their sheets
_SIZE = 240  # of a picture [pixels]
_TEXT = 17  # [pixels]
_COLUMNS = 6


def main(
    *,
    out: Annotated[Path, typer.Option(help="JPEG or PNG.")] = DOCS / "family.jpg",
    only: Annotated[str, typer.Option(help="Names of categories, with commas; all by default.")] = "",
) -> None:
    """Draw the picture with the best installed renderer, and print its path."""
    names = only.split(",") if only else categories()
    cells = [_cell(find(name).generate(SEEDS.get(name, 0), certify=False), name) for name in names]
    columns = min(_COLUMNS, len(cells))
    empty = np.full_like(cells[0], 255)
    cells += [empty] * (-len(cells) % columns)
    rows = [np.hstack(cells[start : start + columns]) for start in range(0, len(cells), columns)]
    typer.echo(save_sheet(np.vstack(rows), out))


def _cell(asset: Asset, name: str) -> np.ndarray:
    """Return the picture of an asset with its name below."""
    (_, view), (q, _), *_ = shots(asset)
    ajar = {joint: _OPEN * position for joint, position in q.items()}
    shown = render(asset, ajar, camera=view, size=(_SIZE, _SIZE)).color
    cell = Image.new("RGB", (_SIZE, _SIZE + _TEXT + 12), "white")
    cell.paste(Image.fromarray(shown), (0, 0))
    font = ImageFont.load_default(_TEXT)
    place = ((_SIZE - font.getlength(name)) / 2, _SIZE + 4)
    ImageDraw.Draw(cell).text(place, name, fill=(60, 60, 64), font=font)
    return np.asarray(cell)


if __name__ == "__main__":
    typer.run(main)
