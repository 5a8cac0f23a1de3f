"""Commands that draw: `artgen render`, a picture of an asset, and `artgen sheet`, many samples on a page."""

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

import typer
from typer import Option

from artgen.asset import Asset
from artgen.catalog import maker
from artgen.commands.console import progress
from artgen.commands.options import Category, Detail, Overrides, Seed, Source, TextureSize, generated
from artgen.commands.view import asset_from
from artgen.errors import ExportError, ParameterError
from artgen.generator.overrides import parse_overrides

if TYPE_CHECKING:
    from artgen.view import Picture

_File = Annotated[Path | None, Option(metavar="FILE", help="PNG or JPEG; by default in this folder.")]


def render(
    context: typer.Context,
    source: Source,
    *,
    seed: Seed = 0,
    overrides: Overrides = None,
    detail: Detail = "full",
    positions: Annotated[
        list[str] | None,
        Option("--joint", metavar="JOINT=VALUE", help="Position of a joint [rad or m]. Repeatable."),
    ] = None,
    opening: Annotated[
        float, Option("--open", metavar="0..1", help="Share of the ranges; --joint overrides it.")
    ] = 0.0,
    lit: Annotated[
        list[str] | None, Option("--on", metavar="OUTPUT", help="Light that shines, or 'all'. Repeatable.")
    ] = None,
    view: Annotated[
        str | None,
        Option(help="front, back, side, top, ... or close-up:LINK; by default from the left and above."),
    ] = None,
    size: Annotated[str, Option(metavar="PIXELS", help="Width and height: 768, or 1280x720.")] = "768",
    studio: Annotated[Literal["studio", "room", "none"], Option(help="Surroundings.")] = "studio",
    show: Annotated[
        Literal["color", "links", "labels", "depth", "normals"], Option(help="Content of the picture.")
    ] = "color",
    texture_size: TextureSize = 512,
    samples: Annotated[int, Option(help="Rays per pixel in shade, an even number.")] = 8,
    out: _File = None,
) -> None:
    """Render a picture of an asset and print its path; needs artgen[sim]."""
    from artgen.view import opened
    from artgen.view.picture import save_image

    if out is not None:
        _check_file(out)
    if samples < 1 or samples % 2:
        raise ParameterError(f"--samples {samples} must be an even number from 2 on, such as 8")
    pixels = _size(size)
    with progress("render"):
        asset = asset_from(context, source, seed, overrides or [], detail=detail)
        q = opened(asset, opening) | _positions(positions or [])
        shining = [each.name for each in asset.outputs if each.color] if lit == ["all"] else lit or []
        asset = asset.with_outputs(dict.fromkeys(shining, 1.0))
        picture = asset.render(
            q, camera=view, size=pixels, studio=studio, textures=texture_size, samples=samples
        )
    typer.echo(save_image(_shown(picture, show), out or Path(f"{asset.name}.png")))


def _check_file(path: Path) -> None:
    """Check the file of a picture before it is drawn."""
    from artgen.view.picture import check_suffix

    check_suffix(path)
    if path.is_dir() or not path.absolute().parent.is_dir():
        raise ExportError(f"cannot write {path}: give a file in a directory that exists")


def _positions(items: list[str]) -> dict[str, float]:
    found = {}
    for item in items:
        name, _, value = item.partition("=")
        try:
            found[name.strip()] = float(value)
        except ValueError:
            raise ParameterError(f"--joint {item!r} must be JOINT=NUMBER, such as door_hinge=0.8") from None
    return found


def _size(text: str) -> tuple[int, int]:
    try:
        numbers = [int(part) for part in text.lower().split("x")]
    except ValueError:
        numbers = []
    if len(numbers) not in (1, 2):
        raise ParameterError(f"--size {text!r} must be a number of pixels, or two such as 1280x720")
    return numbers[0], numbers[-1]


def _shown(picture: "Picture", what: str) -> Any:
    """Return the channel of a picture as colors."""
    import numpy as np

    if what == "color":
        return picture.color
    if what == "normals":
        return np.rint(127.5 + 127.5 * picture.normals).astype(np.uint8)
    if what == "depth":
        seen = np.isfinite(picture.depth)
        near, far = (picture.depth[seen].min(), picture.depth[seen].max()) if seen.any() else (0.0, 1.0)
        share = (far - np.where(seen, picture.depth, far)) / max(far - near, 1e-9)
        grey = np.where(seen, np.rint(55.0 + 200.0 * share), 0.0).astype(np.uint8)
        return np.repeat(grey[..., None], 3, axis=2)
    found = picture.links if what == "links" else picture.labels
    hue = np.arange(len(found.names)) * 0.381966
    wheel = 0.5 + 0.5 * np.cos(2.0 * np.pi * (hue[:, None] + np.array([0.0, 1 / 3, 2 / 3])))
    colors = np.rint(60.0 + 190.0 * wheel).astype(np.uint8)
    colors[0] = 0
    return colors[found.ids]


def sheet(
    category: Category,
    *,
    seeds: Annotated[int, Option(metavar="NUMBER", help="Number of samples.")] = 12,
    first_seed: Seed = 0,
    overrides: Overrides = None,
    views: Annotated[int, Option(help="1 for the front, 2 for the back as well.")] = 2,
    size: Annotated[int, Option(metavar="PIXELS", help="Height of a picture.")] = 240,
    columns: Annotated[
        int | None, Option(help="Samples side by side; by default chosen for the page.")
    ] = None,
    out: _File = None,
) -> None:
    """Draw samples of a category, closed and open, on one page, and print its path; needs artgen[sim]."""
    from artgen.view.sheet import save_sheet
    from artgen.view.sheet import sheet as draw

    if seeds < 1:
        raise ParameterError(f"--seeds {seeds} must be at least 1")
    found, values = maker(category), parse_overrides(overrides or [])
    path = Path(f"{found.name}.jpg") if out is None else out
    _check_file(path)

    def sample(seed: int) -> Asset:
        return generated(found, seed, values, certify=False)

    makers = [partial(sample, seed) for seed in range(first_seed, first_seed + seeds)]
    with progress(found.name, seeds) as update:
        pixels = draw(
            makers,
            views=views,
            size=size,
            columns=columns,
            progress=lambda done, total: update(completed=done, total=total),
        )
    typer.echo(save_sheet(pixels, path))
