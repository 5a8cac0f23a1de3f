"""`artgen gallery`: a page of many assets, each with a viewer of its own."""

from pathlib import Path
from typing import Annotated

import typer

from artgen.commands.progress import progress_bar
from artgen.commands.view import TEXELS, show_file


def gallery(
    directory: Annotated[
        Path,
        typer.Argument(
            metavar="DIRECTORY", help="A folder with exported assets, such as `artgen generate -n` makes."
        ),
    ],
    *,
    texture_size: Annotated[
        int, typer.Option(metavar="TEXELS", help="Texels on a side of the maps; 0 for plain colours.")
    ] = TEXELS // 2,
    out: Annotated[
        Path | None, typer.Option(metavar="FOLDER", help="Where to; <DIRECTORY>_gallery by default.")
    ] = None,
    opening: Annotated[bool, typer.Option("--open/--no-open", help="Open it in the browser.")] = True,
) -> None:
    """Write a page of all assets in a folder, with pictures and filters, and print its path.

    Each picture leads to the viewer of its asset. With artgen[sim], pictures are drawn by MuJoCo.
    """
    from artgen.materials.textures import check_size
    from artgen.view.web.gallery import find_assets, write_gallery

    if texture_size != 0:
        check_size(texture_size)
    source = directory.resolve()
    found = find_assets(source)
    target = out or source.with_name(f"{source.name}_gallery")
    with progress_bar() as bar:
        task = bar.add_task(source.name, total=len(found))
        path, failed = write_gallery(
            found,
            source,
            target,
            textures=texture_size,
            progress=lambda done: bar.update(task, completed=done),
        )
    for message in failed:
        typer.echo(f"warning: {' '.join(message.split())}", err=True)
    typer.echo(path)
    if opening:
        show_file(path)
