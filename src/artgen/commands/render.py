"""`artgen render`: a picture of an asset."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

import typer

from artgen.commands.view import SourceArgument, SourceOverrides, SourceSeed, asset_from
from artgen.errors import ParameterError

if TYPE_CHECKING:
    from artgen.view import Picture


def render(
    source: SourceArgument,
    *,
    seed: SourceSeed = 0,
    overrides: SourceOverrides = None,
    positions: Annotated[
        list[str] | None,
        typer.Option(
            "--q", metavar="JOINT=VALUE", help="Position of a joint [rad or m]. May be given several times."
        ),
    ] = None,
    opening: Annotated[
        float, typer.Option("--open", metavar="0..1", help="How far it is open; --q overrules it.")
    ] = 0.0,
    view: Annotated[
        str, typer.Option(help="front, three_quarter, back, side, top, ... or close-up:LINK.")
    ] = "three_quarter",
    size: Annotated[str, typer.Option(metavar="PIXELS", help="Width and height: 768, or 1280x720.")] = "768",
    studio: Annotated[Literal["studio", "room", "none"], typer.Option(help="What stands around.")] = "studio",
    show: Annotated[
        Literal["color", "links", "labels", "depth", "normals"], typer.Option(help="What the pixels tell.")
    ] = "color",
    texture_size: Annotated[
        int, typer.Option(metavar="TEXELS", help="Texels on a side of the maps; 0 for plain colors.")
    ] = 512,
    samples: Annotated[int, typer.Option(help="How finely shadows and edges are drawn.")] = 32,
    out: Annotated[
        Path | None, typer.Option(metavar="FILE", help="PNG or JPEG; ./<name of the asset>.png by default.")
    ] = None,
) -> None:
    """Render a picture of an asset and print its path; needs artgen[sim]."""
    from artgen.view import opened
    from artgen.view.picture import check_suffix, save_image

    if out is not None:
        check_suffix(out)
    pixels = _size(size)
    asset = asset_from(source, seed, overrides or [])
    q = opened(asset, opening) | _positions(positions or [])
    picture = asset.render(q, camera=view, size=pixels, studio=studio, textures=texture_size, samples=samples)
    path = Path(f"{asset.name}.png") if out is None else out
    typer.echo(save_image(_shown(picture, show), path))


def _positions(items: list[str]) -> dict[str, float]:
    found = {}
    for item in items:
        name, _, value = item.partition("=")
        try:
            found[name.strip()] = float(value)
        except ValueError:
            raise ParameterError(f"--q {item!r} must be JOINT=NUMBER, such as door_hinge=0.8") from None
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
