"""`artgen colliders`: comparison of the colliders of an exported asset with other kinds."""

import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer
from rich.console import Console
from rich.table import Table

from artgen.asset import Asset

if TYPE_CHECKING:
    from artgen.validate.collider_table import ColliderRow

_PLAIN_WIDTH = 1000  # columns without a terminal: one line per row
_COLUMNS = (
    "colliders",
    "pieces",
    "vertices",
    "volume error",
    "surface error",
    "interior kept",
    "MuJoCo steps/s",
)


def colliders(
    directory: Annotated[
        Path,
        typer.Argument(metavar="DIRECTORY", help="An exported asset, with urdf or mjcf among its formats."),
    ],
    *,
    speed: Annotated[bool, typer.Option(help="Measure how fast MuJoCo steps; needs artgen[sim].")] = True,
    as_json: Annotated[
        bool, typer.Option("--json", help="Print JSON, with the numbers of each link.")
    ] = False,
) -> None:
    """Compare the colliders of an exported asset with CoACD's and with convex hulls."""
    from artgen.validate.collider_table import compare_colliders  # scipy and trimesh take half a second

    asset = Asset.load(directory)
    rows = compare_colliders(asset, speed=speed)
    if as_json:
        data = {"asset": asset.name, "colliders": [row.to_data() for row in rows]}
        typer.echo(json.dumps(data, indent=1, ensure_ascii=False, allow_nan=False))
        return
    table = Table(box=None, pad_edge=False, header_style="bold")
    for number, column in enumerate(_COLUMNS):
        table.add_column(column, justify="right" if number else "left")
    for row in rows:
        table.add_row(*_cells(row))
    width = None if sys.stdout.isatty() else _PLAIN_WIDTH
    Console(width=width, highlight=False, markup=False).print(table)


def _cells(row: "ColliderRow") -> list[str]:
    return [
        f"{row.kind} (stored)" if row.stored else row.kind,
        str(row.pieces),
        str(row.vertices),
        f"{row.volume_error:.2%}",
        f"{1e3 * row.surface_error:.2f} mm",
        f"{row.interior_kept:.2%}",
        "-" if row.steps_per_second is None else f"{row.steps_per_second:.0f}",
    ]
