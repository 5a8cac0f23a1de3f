"""Commands that make training data: `artgen images` and `artgen demos`, and `artgen card` of a dataset."""

import math
from pathlib import Path
from typing import Annotated

import typer
from typer import Argument, Option

from artgen.commands.console import counting, list_failures, make_dataset
from artgen.commands.options import (
    Categories,
    Certify,
    Collisions,
    Detail,
    Jobs,
    Overrides,
    Seed,
    TextureSize,
)
from artgen.dataset import write_card
from artgen.demos.run import DemoLayout
from artgen.errors import ParameterError
from artgen.images import ImagePlan
from artgen.images.plan import RANDOM, PictureFormat

_RANGE = "LOW,HIGH"


def images(
    categories: Categories,
    *,
    out: Annotated[str, Option(metavar="DIRECTORY", help="Target; also a URL that fsspec supports.")],
    assets: Annotated[
        int, Option(min=1, help="Number of assets, shared by the categories; a larger one extends a set.")
    ] = 250,
    images_per_asset: Annotated[int, Option(min=1, help="Number of pictures of each asset.")] = 12,
    size: Annotated[int, Option(metavar="PIXELS", help="Width and height of a picture.")] = 1024,
    seed: Seed = 0,
    overrides: Overrides = None,
    labels: Annotated[
        str,
        Option(
            metavar="NAMES",
            help="Labels with masks: handle,door; body=door+glass merges several; door:body=door+glass for "
            "one category only. All labels by default.",
        ),
    ] = "",
    random: Annotated[
        str, Option(metavar="NAMES", help=f"Drawn again for each picture: {', '.join(RANDOM)}, or all.")
    ] = "",
    depth: Annotated[bool, Option("--depth", help="Write depths as PNG of 16 bits.")] = False,
    normals: Annotated[bool, Option("--normals", help="Write normals as PNG.")] = False,
    field_of_view: Annotated[str, Option(metavar=_RANGE, help="Field of view [degrees].")] = "26,57",
    elevation: Annotated[str, Option(metavar=_RANGE, help="Elevation of cameras [degrees].")] = "6,75",
    azimuth: Annotated[float, Option(metavar="DEGREES", help="Largest angle from the front.")] = 180.0,
    margin: Annotated[str, Option(metavar=_RANGE, help="Empty share at each edge.")] = "0.03,0.45",
    samples: Annotated[int, Option(min=1, help="Samples per pixel, for shadows and edges.")] = 4,
    texture_size: TextureSize = 512,
    picture: Annotated[PictureFormat, Option(help="File format of pictures.")] = "png",
    split: Annotated[str, Option(metavar="SHARES", help="Training, validation and test.")] = "0.8,0.1,0.1",
    jobs: Jobs = None,
    certify: Certify = True,
    on_collision: Collisions = "redraw",
    detail: Detail = "full",
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
        detail=detail,
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
    make_dataset(plan, out, each=images_per_asset, what="images", jobs=jobs)


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


def demos(
    task: Annotated[str, Argument(help="Name of a task, such as OpenDrawer.")],
    *,
    out: Annotated[
        Path, Option(metavar="DIRECTORY", help="Target; demo.hdf5 or lerobot in it is complete or absent.")
    ],
    count: Annotated[int, Option("--count", "-n", min=1, help="Number of demonstrations.")] = 100,
    seed: Seed = 0,
    image: Annotated[int, Option(metavar="PIXELS", help="Size of pictures in observations; 0 for none.")] = 0,
    noise: Annotated[
        float,
        Option(
            metavar="SPREAD",
            help="Random disturbance of the arm's motion, so that demonstrations include corrections; the "
            "written actions are those without it.",
        ),
    ] = 0.0,
    layout: Annotated[
        DemoLayout, Option(help="An HDF5 file of robomimic, or a LeRobotDataset, which needs artgen[data].")
    ] = "robomimic",
    jobs: Jobs = None,
) -> None:
    """Write successful demonstrations of a task for robomimic or LeRobot; needs artgen[demos].

    A repeated command continues an interrupted run.
    """
    from artgen.demos import make_demos

    with counting(task, count) as (step, _):
        done = make_demos(
            task,
            count,
            out,
            seed=seed,
            image=image,
            noise=noise,
            layout=layout,
            jobs=jobs,
            progress=lambda succeeded: step(succeeded, int(succeeded)),
        )
    list_failures([f"seed {failed}: {reason}" for failed, reason in done.failed.items()])
    tried = done.demos + len(done.failed)
    typer.echo(
        f"wrote {done.demos} demonstrations, {done.steps} steps, of {tried} attempts in {done.seconds:.0f} s"
        f": {done.file}"
    )


def card(
    directory: Annotated[Path, Argument(help="Folder of a dataset made by `artgen generate -n`.")],
    *,
    licence: Annotated[
        str, Option(metavar="NAME", help="Licence of the assets by its name on the hub, such as cc-by-4.0.")
    ],
    title: Annotated[str, Option(help="Title of the card; by default the name of the folder.")] = "",
) -> None:
    """Write README.md and assets.jsonl, with which a dataset can be uploaded to the Hugging Face hub."""
    typer.echo(f"wrote {write_card(directory, licence, title=title)}")
