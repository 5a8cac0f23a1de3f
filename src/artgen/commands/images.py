"""`artgen images`: pictures of many assets with masks of their parts, for training."""

import math
from typing import Annotated

import typer

from artgen.commands.progress import many
from artgen.dataset import generate_many
from artgen.errors import ParameterError
from artgen.generator import OnCollision
from artgen.images import ImagePlan
from artgen.images.plan import RANDOM, PictureFormat

_RANGE = "LOW,HIGH"


def images(
    categories: Annotated[list[str], typer.Argument(metavar="CATEGORY...", help="Names of categories.")],
    *,
    out: Annotated[str, typer.Option(metavar="DIRECTORY", help="Where to; also a URL that fsspec knows.")],
    assets: Annotated[
        int,
        typer.Option(
            min=1, help="How many assets, shared evenly among the categories; with more, a set goes on."
        ),
    ] = 250,
    images_per_asset: Annotated[int, typer.Option(min=1, help="How many pictures of each.")] = 12,
    size: Annotated[int, typer.Option(metavar="PIXELS", help="Width and height of a picture.")] = 1024,
    seed: Annotated[int, typer.Option(help="The first seed of each category.")] = 0,
    overrides: Annotated[
        list[str] | None,
        typer.Option(
            "--set",
            metavar="NAME=VALUE",
            help="A value or distribution for a parameter; door:width=0.9 for one category of several.",
        ),
    ] = None,
    labels: Annotated[
        str,
        typer.Option(
            metavar="NAMES",
            help="Which labels have masks: handle,door; body=door+glass makes one of several; "
            "door:body=door+glass for one category only. All labels by default.",
        ),
    ] = "",
    random: Annotated[
        str,
        typer.Option(
            metavar="NAMES", help=f"Draw these again for each picture: {', '.join(RANDOM)}, or all."
        ),
    ] = "",
    depth: Annotated[bool, typer.Option("--depth", help="Write depths as PNG of 16 bits.")] = False,
    normals: Annotated[bool, typer.Option("--normals", help="Write normals as PNG.")] = False,
    field_of_view: Annotated[
        str, typer.Option(metavar=_RANGE, help="Between which angles of view [degrees].")
    ] = "26,57",
    elevation: Annotated[
        str, typer.Option(metavar=_RANGE, help="How high above the horizon cameras stand [degrees].")
    ] = "6,75",
    azimuth: Annotated[
        float, typer.Option(metavar="DEGREES", help="How far to each side of the front; 180 is all around.")
    ] = 180.0,
    margin: Annotated[
        str, typer.Option(metavar=_RANGE, help="Share of the picture that stays free along its edges.")
    ] = "0.03,0.45",
    samples: Annotated[int, typer.Option(min=1, help="How finely shadows and edges are drawn.")] = 4,
    texture_size: Annotated[
        int, typer.Option(metavar="TEXELS", help="Texels on a side of the maps; 0 for plain colors.")
    ] = 512,
    picture: Annotated[PictureFormat, typer.Option(help="What pictures are written as.")] = "png",
    split: Annotated[
        str, typer.Option(metavar="SHARES", help="Of the assets for training, validation and test.")
    ] = "0.8,0.1,0.1",
    jobs: Annotated[int | None, typer.Option(min=1, help="How many processes; all cores by default.")] = None,
    certify: Annotated[
        bool, typer.Option(help="Prove that no two links collide in any pose that is drawn.")
    ] = True,
    on_collision: Annotated[
        OnCollision,
        typer.Option(help="If that is not proven: draw another sample, fail, or keep the asset."),
    ] = "redraw",
) -> None:
    """Render pictures of many assets, with masks and joints in the layout of COCO; needs artgen[images].

    Writes train.json, val.json and test.json, split by asset. A repeated command continues an interrupted
    run.
    """
    plan = ImagePlan(
        tuple(categories),
        assets,
        seed,
        tuple(overrides or ()),
        certify=certify,
        on_collision=on_collision,
        images=images_per_asset,
        size=size,
        labels=_names(labels),
        random=RANDOM if random == "all" else _names(random),
        depth=depth,
        normals=normals,
        field_of_view=_angles("--field-of-view", field_of_view),
        elevation=_angles("--elevation", elevation),
        azimuth=math.radians(azimuth),
        margin=_range("--margin", margin),
        samples=samples,
        texture_size=texture_size,
        picture=picture,
        split=_numbers("--split", split, 3),
    )
    many(
        lambda step, begin: generate_many(plan, out, jobs=jobs, progress=step, begin=begin),
        out,
        each=images_per_asset,
        what="images",
    )


def _names(text: str) -> tuple[str, ...]:
    return tuple(name.strip() for name in text.split(",") if name.strip())


def _numbers(option: str, text: str, count: int) -> tuple[float, ...]:
    try:
        numbers = tuple(float(each) for each in text.split(","))
    except ValueError:
        numbers = ()
    if len(numbers) != count:
        raise ParameterError(f"{option} {text!r} must be {count} numbers with commas between them")
    return numbers


def _range(option: str, text: str) -> tuple[float, float]:
    low, high = _numbers(option, text, 2)
    return low, high


def _angles(option: str, text: str) -> tuple[float, float]:
    low, high = _range(option, text)
    return math.radians(low), math.radians(high)
