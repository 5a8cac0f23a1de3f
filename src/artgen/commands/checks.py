"""Commands that check: `artgen check`, `certify`, `validate`, `colliders` and `reach`."""

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np
import typer
from rich.console import Console
from rich.text import Text
from typer import Argument, Option

from artgen.asset import Asset
from artgen.asset.asset import remember
from artgen.asset.certificate import Certificate
from artgen.asset.files import exports_in
from artgen.asset.report import CheckResult, Finding, Report, grouped
from artgen.catalog import find
from artgen.colliders.openings import BALL
from artgen.commands.console import FAULT, NOT_PROVEN, console, progress, table
from artgen.commands.options import JsonOutput, Overrides, Seed, Source, Tolerance, check_given
from artgen.commands.view import asset_from
from artgen.errors import ExportError, ParameterError
from artgen.export.files import REACH_FILE, REPORT_FILE, write_file
from artgen.generator.overrides import parse_overrides
from artgen.generator.source import check_source
from artgen.proof.certify import certify as prove
from artgen.range_proof import Failure, prove_range
from artgen.validate import validate as run_checks
from artgen.validate.clients.registry import ALL, chosen_clients
from artgen.validate.clients.run import ClientReport, run_clients

_FOREIGN: dict[str, Any] = {"rich_help_panel": "Files of other tools"}
_OF_CATEGORIES = ("samples", "corners", "fail_fast", "overrides", "seed", "tolerance")
_OF_FILES = ("meshes", "root", "total", "first", "picture", "repair")
_PIXELS = 480  # side of a picture of `check`
_CORNERS = 20  # least number of samples with which corners are certified unless asked otherwise
_STYLES = {
    "passed": "green", "failed": "bold red", "skipped": "yellow", "fault": "bold red", "note": "yellow",
    "timed out": "bold red", "absent": "yellow", "nothing to read": "yellow",
}  # fmt: skip


def check(
    context: typer.Context,
    source: Annotated[
        str, Argument(metavar="FILE|CATEGORY", help="A file that defines a category, or its name.")
    ],
    *,
    seed: Seed = 0,
    overrides: Overrides = None,
    seconds: Annotated[float, Option(metavar="NUMBER", min=0.0, help="Time limit for the proof [s].")] = 10.0,
    out: Annotated[Path, Option(metavar="DIRECTORY", help="Folder for the picture.")] = Path(),
) -> None:
    """Check one asset of a category while you write it: proof, validation, and a picture, closed and open.

    A collision is printed as soon as it is found, and shown in the picture; then the asset is not simulated.
    Exit code 1: the asset has a fault, or is not proven.
    """
    if not out.is_dir():
        raise ExportError(f"cannot write to {out}: give a directory that exists")
    terminal = console()
    with progress(f"check {source}") as update:
        asset = asset_from(context, source, seed, list(overrides or ()))
        update(text=f"check {asset.name}")
        results = _source_results(source, asset, parse_overrides(overrides or ()))
        certificate = prove(asset, seconds=seconds)
        remember(asset, certificate)
        for first in certificate.failures[:1]:
            others = len(certificate.failures) - 1
            more = f"\nand {others} more pair{'' if others == 1 else 's'} of links" if others else ""
            terminal.print(f"{first}{more}\n", soft_wrap=True)
        report = run_checks(asset, behavior=certificate.proven)
        report = Report(report.asset, (*report.results, *results), near=report.near)
        picture = _picture(asset, certificate, out)
    _show(terminal, f"{asset.name}, seed {seed}", report)
    terminal.print(picture, soft_wrap=True)
    if not report.passed:
        raise typer.Exit(FAULT)


def _source_results(source: str, asset: Asset, overrides: Mapping[str, Any]) -> list[CheckResult]:
    """Check the author's function, if the source is a category."""
    if Path(source).is_dir() or asset.seed is None:
        return []
    again, checked = find(source), find(source)  # a file is executed each time
    return [check_source(checked, again, asset, overrides=overrides)]


def _picture(asset: Asset, certificate: Certificate, out: Path) -> str:
    """Draw an asset closed, open, and at its first collision; return the path or the reason for none."""
    from artgen.view import RenderError
    from artgen.view.picture import save_image
    from artgen.view.sheet import shots

    closed, opened, _ = shots(asset)
    collisions = [pair.witness.pose for pair in certificate.failures if pair.witness is not None]
    poses = [closed[0], opened[0], *collisions[:1]]
    try:
        with progress("draw"):
            pixels = [asset.render(q, camera=opened[1], size=_PIXELS, textures=256).color for q in poses]
    except RenderError as error:
        return f"no picture: {' '.join(str(error).split())}"
    return f"picture: {save_image(np.concatenate(pixels, axis=1), out / f'{asset.name}_check.png')}"


def certify(
    context: typer.Context,
    category: Annotated[
        str,
        Argument(
            metavar="CATEGORY|FILE",
            help="A category, a file that defines one, or a URDF, MJCF or USD file of another tool.",
        ),
    ],
    *,
    samples: Annotated[int, Option(metavar="NUMBER", help="Number of seeds.")] = 500,
    corners: Annotated[
        bool | None,
        Option(
            "--corners/--no-corners",
            help="Certify the corners of the parameter ranges as well; by default with 0, or at least "
            f"{_CORNERS}, samples.",
        ),
    ] = None,
    fail_fast: Annotated[bool, Option("--fail-fast", help="End with the first failure.")] = False,
    overrides: Overrides = None,
    seed: Seed = 0,
    tolerance: Tolerance = 0.0,
    json_file: Annotated[Path | None, Option("--json", metavar="FILE", help="File for all results.")] = None,
    meshes: Annotated[
        Literal["hull", "coacd"], Option(help="Meshes: their hulls, or CoACD's pieces.", **_FOREIGN)
    ] = "hull",
    root: Annotated[
        Path | None, Option(help="Folder that the file may read; by default two levels up.", **_FOREIGN)
    ] = None,
    seconds: Annotated[
        float | None,
        Option(
            metavar="NUMBER",
            help="Time limit for the proof of a sample, 60 by default, or of a pair of a file, 10 [s].",
        ),
    ] = None,
    total: Annotated[float, Option(help="Time limit for all pairs of the file [s].", **_FOREIGN)] = 120.0,
    first: Annotated[bool, Option("--first", help="Stop at the first collision.", **_FOREIGN)] = False,
    picture: Annotated[
        Path | None, Option(metavar="PNG", help="Draw the first collision that is found.", **_FOREIGN)
    ] = None,
    repair: Annotated[
        bool, Option("--repair", help="Write NAME.repaired with joint limits that are safe.", **_FOREIGN)
    ] = False,
) -> None:
    """Prove a category, or a file of another tool, free of collisions.

    Exit code 1: a proof of a category fails, or links of the file collide; 3: links of the file do not
    collide as far as is known, but not all are proven apart.
    """
    for file in (json_file, picture):
        if file is not None and (file.is_dir() or not file.absolute().parent.is_dir()):
            raise ExportError(f"cannot write {file}: give a file in a directory that exists")
    if root is not None and not root.is_dir():
        raise ExportError(f"there is no directory {root}; give the one with the files as --root")
    if json_file is not None and json_file.suffix.lower() != ".json":
        raise ParameterError(f"--json {json_file} is not allowed: the name of the file must end in .json")
    foreign = _is_foreign(Path(category))
    check_given(context, _OF_CATEGORIES if foreign else _OF_FILES, "a file" if foreign else "a category")
    if foreign:
        _certify_file(
            Path(category),
            json_file,
            picture,
            meshes=meshes,
            root=root,
            seconds=10.0 if seconds is None else seconds,
            total=total,
            first=first,
            repair=repair,
        )
        return
    told: list[Failure] = []

    def tell_first(failure: Failure) -> None:
        if not told:
            typer.echo(f"first failure: {failure.origin}: {failure.message}", err=True)
        told.append(failure)

    with progress("certify") as update:
        proof = prove_range(
            category,
            samples,
            corners=samples == 0 or samples >= _CORNERS if corners is None else corners,
            seed=seed,
            overrides=parse_overrides(overrides or ()),
            tolerance=tolerance,
            seconds=60.0 if seconds is None else seconds,
            fail_fast=fail_fast,
            progress=lambda done, total: update(
                completed=done, total=total, failed=f"{len(told)} failed" if told else ""
            ),
            failed=tell_first,
        )
    typer.echo(proof)
    _write_json(json_file, proof.to_data())
    if not proof.sound:
        raise typer.Exit(FAULT)


def _is_foreign(path: Path) -> bool:
    """Tell whether a name is that of a file for the referee, not of a category or its module."""
    return path.suffix not in ("", ".py")


def _certify_file(
    path: Path, json_file: Path | None, picture: Path | None, *, repair: bool, **options: Any
) -> None:
    """Judge a file of another tool; the exit code tells the verdict."""
    from artgen.referee import certify as judge

    with progress(path.name) as update:
        judgment = judge(path, progress=lambda text: update(text=text), **options)
    typer.echo(judgment)
    _write_json(json_file, judgment.to_data())
    if picture is not None and any(pair.result.witness is not None for pair in judgment.failures):
        pair = judgment.picture(picture)
        typer.echo(f"{picture} shows {' and '.join(pair.result.links)} where they collide")
    if repair and judgment.verdict not in ("proven", "nothing moves"):
        typer.echo(f"wrote {judgment.repair()}, whose joint limits are safe")
    if not judgment.rechecked or judgment.verdict == "collision":
        raise typer.Exit(FAULT)
    if judgment.verdict == "not proven":
        raise typer.Exit(NOT_PROVEN)


def _write_json(path: Path | None, data: object) -> None:
    if path is not None:
        write_file(path, (_json(data) + "\n").encode())


def _json(data: object) -> str:
    return json.dumps(data, indent=1, ensure_ascii=False, allow_nan=False)


def reach(
    directory: Annotated[Path, Argument(help="An exported room, or another asset that stands on the floor.")],
    *,
    seed: Seed = 0,
) -> None:
    """Find a place of a Panda on a mobile base for each joint that a hand moves, and write reach.json.

    From a place the hand follows the way of the joint, or a part of it and the rest from further places;
    the footprints are free.
    """
    from artgen.envs.reach import hand_joints, stands, write_stands

    asset = Asset.load(directory)
    count = len(hand_joints(asset))
    with progress(f"reach {asset.name}", count) as update:
        found = []
        for each in stands(asset, seed):
            found.append(each)
            update(advance=1)
    for each in found:
        if each.reason:
            typer.echo(f"{each.joint}: {each.reason}")
    typer.echo(write_stands(asset, found, directory / REACH_FILE))
    whole = [each for each in found if each.way == 1.0]
    parts = sum(0.0 < each.way < 1.0 for each in found)
    several = sum(bool(each.then) for each in whole)
    typer.echo(
        f"{len(whole)} of {count} joints are followed all the way, {several} of them from several places; "
        f"{parts} a part of it"
    )


def colliders(
    context: typer.Context,
    source: Source,
    *,
    seed: Seed = 0,
    overrides: Overrides = None,
    budgets: Annotated[
        str, Option(metavar="NUMBERS", help="For a category: numbers of colliders, separated by commas.")
    ] = "48,16,8",
    openings: Annotated[
        float, Option(metavar="METRES", help="Width of openings that fewer colliders leave open.")
    ] = BALL,
    speed: Annotated[bool, Option(help="Measure the speed of MuJoCo; needs artgen[sim].")] = True,
    as_json: JsonOutput = False,
) -> None:
    """Compare the colliders of an export with CoACD's and hulls, or those of a category with fewer."""
    from artgen.validate.colliders import compare_colliders  # scipy and trimesh take half a second

    numbers = [number.strip() for number in budgets.split(",")]
    if not all(number.isdecimal() for number in numbers):
        raise typer.BadParameter(f"--budgets {budgets!r} are not whole numbers with commas, such as 48,16")
    asset = asset_from(context, source, seed, overrides or [], certify=True)
    fewer = [int(number) for number in numbers] if asset.links[0].pieces else []
    with progress(f"compare the colliders of {asset.name}"):
        rows = compare_colliders(asset, fewer, openings, speed=speed)
    if as_json:
        typer.echo(_json({"asset": asset.name, "colliders": rows}))
        return
    result = table(
        *("colliders", "pieces", "vertices", "volume error", "surface error", "interior kept"),
        "MuJoCo steps/s",
    )
    for column in result.columns[1:]:
        column.justify = "right"
    for row in rows:
        result.add_row(
            f"{row['kind']} (stored)" if row["stored"] else row["kind"],
            str(row["pieces"]),
            str(row["vertices"]),
            f"{row['volume_error']:.2%}",
            f"{1e3 * row['surface_error']:.2f} mm",
            f"{row['interior_kept']:.2%}",
            "-" if row["steps_per_second"] is None else str(row["steps_per_second"]),
        )
    console().print(result)


def validate(
    directories: Annotated[
        list[Path],
        Argument(metavar="DIRECTORY...", help="Exported assets, or directories that contain some."),
    ],
    *,
    behavior: Annotated[bool, Option(help="Simulate in MuJoCo, seconds each; needs artgen[sim].")] = True,
    clients: Annotated[
        str | None,
        Option(
            metavar="NAMES",
            help=f"Clients that read each asset: names separated by commas, or {ALL!r} installed ones.",
        ),
    ] = None,
    as_json: JsonOutput = False,
) -> None:
    """Run all checks on exported assets, and write a report.json into each; exit code 1 for a fault."""
    chosen, by_name = ((), False) if clients is None else chosen_clients(clients)
    terminal = console()
    reports: list[tuple[Path, Report]] = []
    found = exports_in(directories)
    for number, directory in enumerate(found):
        with progress(f"validate {directory.name}, {number + 1} of {len(found)}"):
            report = run_checks(directory, behavior=behavior)
            if chosen:
                outcomes = run_clients(directory, chosen, by_name=by_name)
                report = ClientReport(report.asset, report.results, tuple(outcomes), near=report.near)
        reports.append((directory, report))
        if not as_json:
            _show(terminal, f"{report.asset} in {directory}", report)
        write_report(report, directory)
    if as_json:
        typer.echo(
            _json([{"directory": str(directory), **report.to_data()} for directory, report in reports])
        )
    failed = [report.asset for _, report in reports if not report.passed]
    if len(reports) > 1 and not as_json:
        names = f": {', '.join(failed)}" if failed else ""
        terminal.print(f"{len(failed)} of {len(reports)} assets failed{names}", soft_wrap=True)
    if failed:
        raise typer.Exit(FAULT)


def write_report(report: Report, directory: Path) -> Path:
    """Write a report as JSON into a directory, completely or not at all."""
    return write_file(directory / REPORT_FILE, report.to_json().encode())


def _show(terminal: Console, title: str, report: Report) -> None:
    """Print a table of the checks, and one of the clients, with their findings below."""
    terminal.print(Text(title, "bold"), soft_wrap=True)
    checks = table("check", "result", "detail")
    for result in report.results:
        checks.add_row(result.check, Text(result.state, _STYLES[result.state]), result.counted)
    terminal.print(checks)
    _show_findings(terminal, [each for result in report.results for each in result.findings], report.near)
    if isinstance(report, ClientReport):
        clients = table("client", "version", "result", "first message")
        for outcome in report.outcomes:
            style = "bold red" if outcome.fault else _STYLES[outcome.state]
            clients.add_row(outcome.client, outcome.version, Text(outcome.state, style), outcome.message)
        terminal.print()
        terminal.print(clients)
        _show_findings(terminal, [finding for each in report.outcomes for finding in each.findings[1:]], {})
    terminal.print()


def _show_findings(
    terminal: Console, findings: Sequence[Finding], near: Mapping[str, tuple[float, float]]
) -> None:
    for finding, text in grouped(findings, near):
        line = Text.assemble((finding.severity, _STYLES[finding.severity]), f" {finding.check}: {text}")
        terminal.print(line, soft_wrap=True)
