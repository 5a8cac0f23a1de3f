"""`artgen export`: export an asset again in another layout or other formats."""

from pathlib import Path
from typing import Annotated

import typer

from artgen.asset import Asset
from artgen.asset.files import main_files
from artgen.errors import ExportError
from artgen.export import FORMATS, LAYOUTS, TEXTURES
from artgen.export.files import chosen_formats, find_layout
from artgen.materials.textures import check_size


def export(
    directory: Annotated[
        Path,
        typer.Argument(
            metavar="DIRECTORY",
            help="An exported asset in the layout flat or robocasa, with urdf or mjcf among its formats.",
        ),
    ],
    *,
    layout: Annotated[
        str, typer.Option(metavar="NAME", help=f"How the files lie: {', '.join(LAYOUTS)}.")
    ] = "flat",
    formats: Annotated[
        str | None,
        typer.Option(
            "--format",
            metavar="NAMES",
            help=f"What to write, of {', '.join(FORMATS)}; by default what is usual in the layout.",
        ),
    ] = None,
    texture_size: Annotated[
        int, typer.Option(metavar="TEXELS", help="Texels on a side of the maps; 0 for colors alone.")
    ] = TEXTURES,
    out: Annotated[
        Path | None,
        typer.Option(metavar="DIRECTORY", help="Where to; ./<name of the asset>_<layout> by default."),
    ] = None,
) -> None:
    """Export an asset again in another layout, and print the paths of its main files."""
    chosen = check_formats(layout, formats)
    if texture_size != 0:
        check_size(texture_size)
    asset = Asset.load(directory)
    target = Path(f"{asset.name}_{layout.replace('-', '_')}") if out is None else out
    source = directory.parent if directory.suffix == ".json" else directory  # as `Asset.load` accepts it
    if target.resolve() == source.resolve():
        raise ExportError(
            f"cannot export {source} to itself: its surfaces are read from there; choose another --out"
        )
    written = asset.export(target, formats=chosen, textures=texture_size, layout=layout)
    for path in main_files(written).values():
        typer.echo(path)


def check_formats(layout: str, formats: str | None) -> tuple[str, ...]:
    """Return the formats that a command writes in a layout.

    Args:
        layout: Name of the layout.
        formats: Names separated by commas; None for the default formats of the layout.

    Raises:
        BadParameter: `formats` is empty.
        ExportError: The layout or a format does not exist, or the layout does not have the format.
    """
    found = find_layout(layout)
    chosen = None if formats is None else [item.strip() for item in formats.split(",") if item.strip()]
    if chosen is not None and not chosen:
        names = ", ".join(found.formats)
        raise typer.BadParameter(f"--format {formats!r} names no format; choose of {names}")
    return chosen_formats(found, chosen)
