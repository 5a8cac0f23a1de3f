"""The asset that a command looks at: an exported one, or one made of a category; and how it is told."""

from pathlib import Path
from typing import Annotated

import typer

from artgen.asset import Asset
from artgen.asset.files import ASSET_FILE
from artgen.errors import ParameterError
from artgen.generator.overrides import parse_overrides

Source = Annotated[
    str,
    typer.Argument(metavar="DIRECTORY|CATEGORY", help="An exported asset, a category, or a file with one."),
]
SourceSeed = Annotated[int, typer.Option(help="Of a category: decides every draw.")]
SourceOverrides = Annotated[
    list[str] | None,
    typer.Option("--set", metavar="NAME=VALUE", help="Of a category: a value for a parameter."),
]

Category = Annotated[
    str, typer.Argument(help="Name of a category, which `artgen list` shows, or a file that defines one.")
]
Seed = Annotated[int, typer.Option(help="Decides every draw.")]
Overrides = Annotated[
    list[str] | None,
    typer.Option("--set", metavar="NAME=VALUE", help="A value for a parameter. May be given several times."),
]


def asset_from(source: str, seed: int, overrides: list[str], *, certify: bool = False) -> Asset:
    """Load an exported asset, or generate one of a category.

    Args:
        source: The directory of an exported asset or its `asset.json`, a category, or a file with one.
        seed: Of a category.
        overrides: The same: `NAME=VALUE`.
        certify: The same: whether to prove it; one that is only to be seen needs no proof.

    Raises:
        ParameterError: Overrides are given for an exported asset, or cannot be read.
        ArtgenError: There is no such asset or category, or it cannot be made.
    """
    from artgen.catalog import find

    directory = Path(source)
    if directory.is_dir() or directory.name == ASSET_FILE:
        if overrides:
            raise ParameterError(f"--set is for categories; {source} is an exported asset")
        return Asset.load(directory)
    return find(source).evaluate(seed, certify=certify, overrides=parse_overrides(overrides))[0]
