"""`artgen generate`: one asset, or a dataset of many."""

from typing import Annotated, Any, Literal

import typer

from artgen.asset.collision import Collision
from artgen.asset.files import main_files
from artgen.catalog import find
from artgen.commands.export import check_formats
from artgen.commands.progress import many
from artgen.dataset import Plan, TextureMode, generate_many
from artgen.dataset.places import is_url
from artgen.dataset.workers import EngineName
from artgen.export import DEFAULT_FORMATS, FORMATS, LAYOUTS, TEXTURES
from artgen.export.precision import check_precision
from artgen.generator import OnCollision
from artgen.generator.overrides import parse_overrides
from artgen.materials.textures import check_size


def generate(
    categories: Annotated[
        list[str],
        typer.Argument(
            metavar="CATEGORY...",
            help="Names of categories, which `artgen list` shows; for one asset also a file with one.",
        ),
    ],
    *,
    count: Annotated[
        int | None,
        typer.Option(
            "--count",
            "-n",
            min=1,
            help="Make a dataset of so many assets in --out, shared evenly among the categories; run again, "
            "it goes on where it was interrupted. Without it, one asset is made.",
        ),
    ] = None,
    seed: Annotated[
        int,
        typer.Option(help="Decides every draw: the same seed, the same bytes. The first one of a dataset."),
    ] = 0,
    overrides: Annotated[
        list[str] | None,
        typer.Option(
            "--set",
            metavar="NAME=VALUE",
            help="A value or distribution for a parameter: width=0.9, hand=left, 'width=uniform(0.8, 0.9)'; "
            "door:width=0.9 for one category of several. May be given several times.",
        ),
    ] = None,
    formats: Annotated[
        str | None,
        typer.Option(
            "--format",
            metavar="NAMES",
            help=f"What to write, of {', '.join(FORMATS)}; by default {', '.join(DEFAULT_FORMATS)}, or what "
            "the layout has of it.",
        ),
    ] = None,
    layout: Annotated[
        str, typer.Option(metavar="NAME", help=f"How the files lie: {', '.join(LAYOUTS)}.")
    ] = "flat",
    out: Annotated[
        str | None,
        typer.Option(
            metavar="DIRECTORY",
            help="Where to; ./<name of the asset> by default. For a dataset also a URL that fsspec knows, "
            "such as s3://bucket/doors.",
        ),
    ] = None,
    jobs: Annotated[
        int | None, typer.Option(min=1, help="How many processes make a dataset; all cores by default.")
    ] = None,
    engine: Annotated[
        EngineName, typer.Option(help="What runs them: processes of this machine, or a Ray cluster.")
    ] = "local",
    address: Annotated[
        str | None,
        typer.Option(
            metavar="HOST:PORT",
            help="Of the Ray cluster; by default that of RAY_ADDRESS, else one is started on this machine.",
        ),
    ] = None,
    base: Annotated[
        Literal["fixed", "free"], typer.Option(help="Whether assets are fixed to the world.")
    ] = "fixed",
    name: Annotated[str, typer.Option(help="Name of the asset; category and seed by default.")] = "",
    collision: Annotated[
        Collision,
        typer.Option(help="Colliders: those known from how solids were made, CoACD's, or convex hulls."),
    ] = "exact",
    textures: Annotated[
        TextureMode | None,
        typer.Option(
            help="Where maps are kept: once for all assets of a dataset, with each asset, or nowhere, so "
            "that colors alone are left. By default shared in a dataset; at a URL, embedded."
        ),
    ] = None,
    texture_size: Annotated[
        int, typer.Option(metavar="TEXELS", help="Texels on a side of the maps.")
    ] = TEXTURES,
    mesh_precision: Annotated[
        float,
        typer.Option(
            metavar="METRES",
            help="How far what is seen may lie from what was made: 0.0005 halves the files; 0 writes every "
            "triangle.",
        ),
    ] = 0.0,
    certify: Annotated[
        bool, typer.Option(help="Prove that no two links collide anywhere in the joint ranges.")
    ] = True,
    tolerance: Annotated[
        float, typer.Option(metavar="METRES", help="Clearance between links that has to be proven.")
    ] = 0.0,
    on_collision: Annotated[
        OnCollision,
        typer.Option(help="If that is not proven: draw another sample, fail, or keep the asset."),
    ] = "redraw",
) -> None:
    """Generate an asset and print the paths of its files; with -n, a dataset of many assets."""
    chosen = check_formats(layout, formats)
    check_size(texture_size)
    check_precision(mesh_precision)
    options: dict[str, Any] = {
        "base": base,
        "certify": certify,
        "tolerance": tolerance,
        "on_collision": on_collision,
    }
    if count is None:
        if out is not None and is_url(out):
            raise typer.BadParameter(
                f"one asset is written to a directory, not to {out}; say with -n how many"
            )
        _one(
            categories,
            seed,
            name,
            overrides or [],
            out,
            options,
            {
                "formats": chosen,
                "collision": collision,
                "layout": layout,
                "textures": 0 if textures == "none" else texture_size,
                "mesh_precision": mesh_precision,
            },
        )
        return
    if name:
        raise typer.BadParameter("--name is for one asset; those of a dataset are named by category and seed")
    if out is None:
        raise typer.BadParameter("-n makes a dataset: say with --out DIRECTORY where to")
    plan = Plan(
        tuple(categories),
        count,
        seed,
        tuple(overrides or ()),
        formats=chosen,
        layout=layout,
        collision=collision,
        textures=textures,
        texture_size=texture_size,
        mesh_precision=mesh_precision,
        **options,
    )
    many(
        lambda step, begin: generate_many(
            plan, out, jobs=jobs, engine=engine, address=address, progress=step, begin=begin
        ),
        out,
    )


def _one(
    categories: list[str],
    seed: int,
    name: str,
    overrides: list[str],
    out: str | None,
    drawn: dict[str, Any],
    written: dict[str, Any],
) -> None:
    """Generate one asset and print the paths of its files."""
    if len(categories) > 1:
        raise typer.BadParameter(
            f"one asset is of one category, not {', '.join(categories)}; say with -n how many"
        )
    asset, _ = find(categories[0]).evaluate(seed, name=name, overrides=parse_overrides(overrides), **drawn)
    if asset.certificate is not None and not asset.certificate.proven:
        typer.echo(f"warning: {' '.join(str(asset.certificate).split())}", err=True)
    directory = asset.export(asset.name if out is None else out, **written)
    if written["collision"] != "exact" and asset.certificate is not None:
        typer.echo(
            "note: the certificate is of the exact colliders; the export with "
            f"{written['collision']!r} has none",
            err=True,
        )
    for path in main_files(directory).values():
        typer.echo(path)
