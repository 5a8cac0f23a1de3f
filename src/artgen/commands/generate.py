"""Commands that write assets: `artgen generate`, one or a dataset, and `artgen export`, one of them again."""

from pathlib import Path
from typing import Annotated, Any, Literal

import typer
from typer import Argument, Option

from artgen.asset import Asset
from artgen.asset.asset import Limits
from artgen.asset.collision import Collision
from artgen.asset.files import main_files
from artgen.catalog import maker, rooms
from artgen.colliders.openings import BALL
from artgen.commands.console import make_dataset, progress
from artgen.commands.options import (
    Categories,
    Certify,
    Collisions,
    Detail,
    Jobs,
    Layout,
    Overrides,
    Seed,
    TextureSize,
    Tolerance,
    check_given,
    generated,
)
from artgen.dataset import Plan, TextureMode
from artgen.dataset.places import is_url
from artgen.dataset.workers import EngineName
from artgen.errors import ExportError
from artgen.export import FORMATS, TEXTURES
from artgen.export.files import chosen_formats, find_layout
from artgen.export.precision import check_precision
from artgen.generator.overrides import overrides_of, parse_overrides
from artgen.proof.fewer import check_budget

_Formats = Annotated[
    list[str] | None,
    Option(
        "--format",
        metavar="NAMES",
        help=f"Formats, of {', '.join(FORMATS)}; by default those of the layout. Repeatable.",
    ),
]


def generate(
    context: typer.Context,
    categories: Categories,
    *,
    count: Annotated[
        int | None,
        Option(
            "--count", "-n", min=1, help="Number of assets of a dataset, shared evenly by the categories."
        ),
    ] = None,
    seed: Seed = 0,
    overrides: Overrides = None,
    formats: _Formats = None,
    layout: Layout = "flat",
    out: Annotated[
        str | None,
        Option(
            metavar="DIRECTORY",
            help="Target; ./<name of the asset> by default. For a dataset also a URL: s3://bucket/doors.",
        ),
    ] = None,
    jobs: Jobs = None,
    engine: Annotated[EngineName, Option(help="Processes of this machine, or a Ray cluster.")] = "local",
    address: Annotated[
        str | None,
        Option(metavar="HOST:PORT", help="Ray cluster; by default that of RAY_ADDRESS, or a new one here."),
    ] = None,
    base: Annotated[Literal["fixed", "free"], Option(help="Fixed to the world, or free.")] = "fixed",
    name: Annotated[str, Option(help="Name of the asset; category and seed by default.")] = "",
    collision: Annotated[Collision, Option(help="Exact colliders, CoACD's, or convex hulls.")] = "exact",
    colliders: Annotated[
        int | None,
        Option(metavar="NUMBER", help="Most colliders of an asset; as many as it needs by default."),
    ] = None,
    openings: Annotated[
        float, Option(metavar="METRES", help="Width of openings that fewer colliders leave open.")
    ] = BALL,
    textures: Annotated[
        TextureMode | None,
        Option(
            help="Maps: shared by the assets of a dataset, embedded in each, or none: plain colors. The "
            "default is shared in a folder, embedded at a URL."
        ),
    ] = None,
    texture_size: TextureSize = TEXTURES,
    mesh_precision: Annotated[
        float,
        Option(metavar="METRES", help="Precision of visible meshes: 0.0005 halves the files; 0 is exact."),
    ] = 0.0,
    limits: Annotated[
        Limits,
        Option(
            help="Ranges of joints: full, with dependencies; or independent: narrowed so that every state is "
            "free."
        ),
    ] = "full",
    detail: Detail = "full",
    frames: Annotated[
        bool, Option("--frames/--no-frames", help="Links for grasps and pushes in the URDF.")
    ] = True,
    states: Annotated[
        int, Option(metavar="NUMBER", min=0, help="Valid states in states.npz, with a reader without artgen.")
    ] = 0,
    certify: Certify = True,
    tolerance: Tolerance = 0.0,
    on_collision: Collisions = "redraw",
) -> None:
    """Generate an asset and print the paths of its files; with -n, a dataset of many assets."""
    chosen = _chosen_formats(layout, formats)
    check_precision(mesh_precision)
    if colliders is None:
        check_given(context, ("openings",), "assets without --colliders")
    else:
        check_budget(colliders, openings, collision)
    if not certify:
        check_given(context, ("tolerance", "on_collision"), "assets without a proof (--no-certify)")
    drawn: dict[str, Any] = {
        "base": base,
        "certify": certify,
        "tolerance": tolerance,
        "on_collision": on_collision,
        "detail": detail,
    }
    written: dict[str, Any] = {
        "formats": chosen,
        "collision": collision,
        "layout": layout,
        "mesh_precision": mesh_precision,
        "limits": limits,
        "frames": frames,
        "states": states,
    }
    if count is None:
        check_given(context, ("jobs", "engine", "address"), "one asset")
        if out is not None and is_url(out):
            raise typer.BadParameter(
                f"one asset is written to a directory, not to {out}; give a number of assets with -n"
            )
        values = overrides_of(categories[0], overrides or (), categories)
        if len(categories) > 1:
            raise typer.BadParameter(
                f"one asset is of one category, not {', '.join(categories)}; give a number of assets with -n"
            )
        with progress("generate"):
            asset = generated(maker(categories[0]), seed, values, name=name, **drawn)
            if colliders is not None:
                asset = asset.with_colliders(colliders, openings)
        _write(asset, out, textures=0 if textures == "none" else texture_size, **written)
        return
    if name:
        raise typer.BadParameter("--name is for one asset; those of a dataset are named by category and seed")
    if out is None:
        raise typer.BadParameter("-n makes a dataset: give its folder with --out DIRECTORY")
    plan = Plan(
        tuple(categories),
        count,
        seed,
        tuple(overrides or ()),
        textures=textures if texture_size else "none",
        texture_size=texture_size or TEXTURES,
        colliders=colliders,
        openings=openings,
        **drawn,
        **written,
    )
    make_dataset(plan, out, jobs=jobs, engine=engine, address=address)


def scene(
    room: Annotated[str, Argument(metavar="ROOM", help="Kind of room, such as kitchen.")],
    *,
    seed: Seed = 0,
    width: Annotated[float | None, Option(metavar="METRES", help="Inner width; drawn by default.")] = None,
    depth: Annotated[float | None, Option(metavar="METRES", help="Inner depth; drawn by default.")] = None,
    overrides: Annotated[
        list[str] | None,
        Option("--set", metavar="NAME=VALUE", help="A parameter of the room: layout=island. Repeatable."),
    ] = None,
    formats: _Formats = None,
    layout: Layout = "flat",
    texture_size: TextureSize = TEXTURES,
    detail: Detail = "full",
    out: Annotated[
        str | None, Option(metavar="DIRECTORY", help="Target; ./<room>_<seed> by default.")
    ] = None,
) -> None:
    """Generate a room of assets in which nothing collides in any state, and print the paths of its files."""
    chosen = _chosen_formats(layout, formats)
    if room not in rooms():
        raise typer.BadParameter(f"there is no room {room!r}; choose from {', '.join(rooms())}")
    values = parse_overrides(overrides or [])
    for name, value in (("width", width), ("depth", depth)):
        if value is not None and name in values:
            raise typer.BadParameter(f"{name} is set twice; leave one of --{name} and --set out")
        values |= {} if value is None else {name: value}
    with progress(f"furnish {room} {seed}"):
        asset = generated(rooms()[room], seed, values, detail=detail)
    _write(asset, out, collision="exact", formats=chosen, textures=texture_size, layout=layout)


def _write(asset: Asset, out: str | None, *, collision: Collision, **options: Any) -> None:
    """Export a generated asset and print the paths of its main files."""
    if asset.certificate is not None and not asset.certificate.proven:
        typer.echo(f"warning: {' '.join(str(asset.certificate).split())}", err=True)
    with progress(f"write {asset.name}"):
        directory = asset.export(asset.name if out is None else out, collision=collision, **options)
    if collision != "exact" and asset.certificate is not None:
        typer.echo(
            f"note: the certificate is of the exact colliders; the export with {collision!r} has none",
            err=True,
        )
    _print_main_files(directory)


def _print_main_files(directory: Path) -> None:
    for path in main_files(directory).values():
        typer.echo(path)


def export(
    directory: Annotated[
        Path, Argument(help="An exported asset in the layout flat or robocasa, with urdf or mjcf.")
    ],
    *,
    layout: Layout = "flat",
    formats: _Formats = None,
    texture_size: TextureSize = TEXTURES,
    out: Annotated[Path | None, Option(help="Target; ./<name of the asset>_<layout> by default.")] = None,
) -> None:
    """Export an asset again in another layout, and print the paths of its main files."""
    chosen = _chosen_formats(layout, formats)
    asset = Asset.load(directory)
    target = Path(f"{asset.name}_{layout.replace('-', '_')}") if out is None else out
    source = directory.parent if directory.suffix == ".json" else directory  # as `Asset.load` accepts it
    if target.resolve() == source.resolve():
        raise ExportError(
            f"cannot export {source} to itself: its surfaces are read from there; choose another --out"
        )
    with progress(f"write {asset.name}"):
        written = asset.export(target, formats=chosen, textures=texture_size, layout=layout)
    _print_main_files(written)


def _chosen_formats(layout: str, formats: list[str] | None) -> tuple[str, ...]:
    """Return the formats in texts with commas, or the default formats of the layout."""
    found = find_layout(layout)
    if not formats:
        return chosen_formats(found, None)
    given = ",".join(formats)
    chosen = [item.strip() for item in given.split(",") if item.strip()]
    if not chosen:
        names = ", ".join(found.formats)
        raise typer.BadParameter(f"--format {given!r} names no format; choose from {names}")
    return chosen_formats(found, chosen)
