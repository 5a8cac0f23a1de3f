"""Arguments and options that several commands share."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any

import typer
from typer import Argument, Option

from artgen.asset import Asset
from artgen.asset.asset import DetailName
from artgen.catalog import Maker
from artgen.errors import ParameterError
from artgen.export import LAYOUTS
from artgen.generator import OnCollision
from artgen.materials.textures import check_size

Category = Annotated[
    str, Argument(help="Name of a category, which `artgen list` shows, or a file that defines one.")
]
Categories = Annotated[
    list[str],
    Argument(metavar="CATEGORY...", help="Names of categories or rooms, see `artgen list`, or files."),
]
Source = Annotated[
    str,
    Argument(metavar="DIRECTORY|CATEGORY", help="An exported asset, a category or room, or a file with one."),
]
Overrides = Annotated[
    list[str] | None,
    Option(
        "--set",
        metavar="NAME=VALUE",
        help="A value or distribution for a parameter: width=0.9, hand=left, 'width=uniform(0.8, 0.9)'; "
        "door:width=0.9 for one category of several. Repeatable.",
    ),
]
Seed = Annotated[int, Option(help="The first seed; the same seed gives the same bytes.")]
Certify = Annotated[bool, Option(help="Prove that no two links collide anywhere in the joint ranges.")]
Tolerance = Annotated[
    float, Option(metavar="METRES", help="Clearance between links that the proof requires.")
]
Collisions = Annotated[
    OnCollision, Option("--on-collision", help="After a failed proof: draw again, fail, or keep the asset.")
]
Detail = Annotated[
    DetailName, Option(help="Level of detail: medium has coarser curves, low few triangles and plain colors.")
]
Layout = Annotated[str, Option(metavar="NAME", help=f"Layout of the files: {', '.join(LAYOUTS)}.")]


def _texture_size(size: int) -> int:
    check_size(size, plain=True)
    return size


TextureSize = Annotated[
    int,
    Option(metavar="TEXELS", callback=_texture_size, help="Texels per side of the maps; 0 for plain colors."),
]
Jobs = Annotated[int | None, Option(min=1, help="Number of processes; all cores by default.")]
JsonOutput = Annotated[bool, Option("--json", help="Print JSON instead of tables.")]
OpenBrowser = Annotated[bool, Option("--open/--no-open", help="Open the page in the browser.")]


def _page(path: Path | None) -> Path | None:
    from artgen.view.page import check_page

    if path is not None:
        check_page(path)
    return path


Page = Annotated[
    Path | None,
    Option(metavar="FILE", callback=_page, help="HTML file; by default ./<name of the asset>.html."),
]


def check_given(context: typer.Context, refused: Sequence[str], what: str) -> None:
    """Check that no option was given that does nothing for what is asked."""
    for name in refused:
        source = context.get_parameter_source(name)
        if source is not None and source.name == "COMMANDLINE":
            given = next(each for each in context.command.params if each.name == name)
            off = given.secondary_opts if context.params[name] is False else []
            raise ParameterError(f"{(off or given.opts)[0]} does nothing for {what}; leave it out")


def generated(made: Maker, seed: int, overrides: Mapping[str, Any], **options: Any) -> Asset:
    """Return an asset of a category or room; overrides with names of options are refused."""
    made.sample(seed, overrides=overrides)
    return made.generate(seed, **options, **overrides)
