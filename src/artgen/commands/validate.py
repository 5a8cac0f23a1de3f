"""`artgen validate`: all checks of exported assets."""

import json
import os
import sys
from collections.abc import Iterator, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.table import Table
from rich.text import Text

from artgen.asset.files import ASSET_FILE
from artgen.asset.report import CheckResult, Finding, Report
from artgen.errors import ExportError
from artgen.export.files import REPORT_FILE
from artgen.validate import validate as run_checks
from artgen.validate.clients.registry import ALL, chosen_clients
from artgen.validate.clients.run import ClientReport, Outcome, run_clients

_FAULT = 1  # exit code
_PLAIN_WIDTH = 1000  # columns without a terminal: one line per row
_STYLES = {
    "passed": "green",
    "failed": "bold red",
    "skipped": "yellow",
    "fault": "bold red",
    "note": "yellow",
    "timed out": "bold red",
    "absent": "yellow",
    "nothing to read": "yellow",
}


def validate(
    directories: Annotated[
        list[Path],
        typer.Argument(
            metavar="DIRECTORY...", help="An exported asset each, or a directory that holds some."
        ),
    ],
    *,
    behavior: Annotated[
        bool, typer.Option(help="Simulate each asset in MuJoCo; takes seconds, needs artgen[sim].")
    ] = True,
    clients: Annotated[
        str | None,
        typer.Option(
            metavar="NAMES",
            help=f"Let these simulators, validators and converters read each asset as well: {ALL!r} that are "
            "installed, or names separated by commas; `artgen clients` lists them.",
        ),
    ] = None,
    as_json: Annotated[
        bool, typer.Option("--json", help="Print the reports as JSON, not as tables.")
    ] = False,
) -> None:
    """Run all checks on exported assets, and write a report.json into each; exit code 1 for a fault."""
    chosen, by_name = ((), False) if clients is None else chosen_clients(clients)
    console = Console(width=None if sys.stdout.isatty() else _PLAIN_WIDTH, highlight=False, markup=False)
    reports: list[tuple[Path, Report]] = []
    for directory in exports_in(directories):
        report = run_checks(directory, behavior=behavior)
        if chosen:
            outcomes = run_clients(directory, chosen, by_name=by_name)
            report = ClientReport(report.asset, report.results, tuple(outcomes))
        reports.append((directory, report))
        if not as_json:
            _show(console, directory, report)
        write_report(report, directory)
    if as_json:
        data = [{"directory": str(directory), **report.to_data()} for directory, report in reports]
        typer.echo(json.dumps(data, indent=1, ensure_ascii=False, allow_nan=False))
    failed = [report.asset for _, report in reports if not report.passed]
    if len(reports) > 1 and not as_json:
        names = f": {', '.join(failed)}" if failed else ""
        console.print(f"{len(failed)} of {len(reports)} assets failed{names}", soft_wrap=True)
    if failed:
        raise typer.Exit(_FAULT)


def exports_in(directories: Sequence[Path]) -> list[Path]:
    """Return the directories of exported assets: given ones, and those directly inside given directories.

    Raises:
        ExportError: A directory does not exist or holds no asset.
    """
    found: dict[str, Path] = {}
    for directory in directories:
        if not directory.is_dir():
            raise ExportError(
                f"there is no directory {str(directory)!r}; give one that holds an exported asset"
            )
        inside = [directory] if (directory / ASSET_FILE).is_file() else list(_children(directory))
        if not inside:
            raise ExportError(
                f"{str(directory)!r} holds no exported asset: no asset.json in it or in a directory in it"
            )
        for each in inside:
            found.setdefault(os.path.realpath(each), each)
    return list(found.values())


def _children(directory: Path) -> Iterator[Path]:
    for child in sorted(directory.iterdir()):
        # names of unfinished and replaced exports begin with a dot
        if not child.name.startswith(".") and (child / ASSET_FILE).is_file():
            yield child


def _show(console: Console, directory: Path, report: Report) -> None:
    """Print a table of the checks, with their findings below."""
    title = Text.assemble((report.asset, "bold"), f" in {directory}")
    console.print(title, soft_wrap=True)
    table = Table(box=None, pad_edge=False, header_style="bold")
    table.add_column("check")
    table.add_column("result")
    table.add_column("detail", overflow="fold")
    for result in report.results:
        state = result.to_data()["state"]
        table.add_row(result.check, Text(state, _STYLES[state]), Text(_detail(result)))
    console.print(table)
    for finding in (finding for result in report.results for finding in result.findings):
        console.print(_described(finding), soft_wrap=True)
    if isinstance(report, ClientReport):
        _show_clients(console, report.outcomes)
    console.print()


def _show_clients(console: Console, outcomes: Sequence[Outcome]) -> None:
    """Print a table of the results of clients, with further faults below."""
    table = Table(box=None, pad_edge=False, header_style="bold")
    for column in ("client", "version", "result", "first message"):
        table.add_column(column, overflow="fold")
    for outcome in outcomes:
        state = Text(outcome.state, "bold red" if outcome.fault else _STYLES[outcome.state])
        table.add_row(outcome.client, outcome.version, state, Text(outcome.message))
    console.print()
    console.print(table)
    for outcome in outcomes:
        for finding in outcome.findings[1:]:
            console.print(_described(finding), soft_wrap=True)


def _detail(result: CheckResult) -> str:
    parts = [result.skipped or result.detail]
    notes = len(result.findings) - len(result.faults)
    for count, word in ((len(result.faults), "fault"), (notes, "note")):
        if count:
            parts.append(f"{count} {word}{'' if count == 1 else 's'}")
    return "; ".join(part for part in parts if part)


def _described(finding: Finding) -> Text:
    """Format a finding over several lines: fault and place, number and pose, hint."""
    place = ", ".join(
        f"{kind} {name}" for kind, name in (("link", finding.link), ("joint", finding.joint)) if name
    )
    lines = [f"{place}: {finding.message}" if place else finding.message]
    number = "" if finding.value is None else f"{finding.value:.6g} {finding.unit}".strip()
    pose = ", ".join(f"{name}={position:.4g}" for name, position in finding.pose.items())
    lines += [" at ".join(part for part in (number, pose) if part), finding.hint and f"-> {finding.hint}"]
    text = Text.assemble((finding.severity, _STYLES[finding.severity]), f" {finding.check}: ")
    return text.append("\n    ".join(line for line in lines if line))


def write_report(report: Report, path: str | Path) -> Path:
    """Write a report as JSON, completely or not at all."""
    target = Path(path)
    target = target / REPORT_FILE if target.is_dir() else target
    partial = target.with_name(f".{target.name}.{os.getpid()}.partial")
    try:
        try:
            partial.write_text(report.to_json(), encoding="utf-8", newline="\n")
            partial.replace(target)
        except BaseException:
            with suppress(OSError):
                partial.unlink(missing_ok=True)
            raise
    except OSError as error:
        reason = error.strerror or str(error)
        raise ExportError(
            f"cannot write the report of {report.asset!r} to {target}: {reason}; check that its directory "
            "exists and may be written to"
        ) from error
    return target
