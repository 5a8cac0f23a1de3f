"""Sample all categories at the ends of their ranges for some time, and list all anomalies: `make soak`.

python scripts/soak.py --minutes 60 --jobs 2
python scripts/soak.py door window --minutes 5 --seed 3
python scripts/soak.py --seed 0 --sample 41

Each sample is made with overrides at the ends of its distributions and hard limits, proven, exported, checked
and simulated by MuJoCo for a second. Results stay in the file, so that an interrupted run continues with the
next sample; after a change of a category, --fresh is necessary to start again.
"""

import sys
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.table import Table
from surveys.extreme_sample import measure_extreme
from surveys.soak import Record, anomalies, soak, soaked, tallies
from surveys.summary import shortened

from artgen.catalog import categories as all_categories
from artgen.catalog import find
from artgen.commands.console import progress
from artgen.errors import ArtgenError
from artgen.generator.overrides import spelled

_WRONG_INPUT = 2  # exit code
_INTERRUPTED = 130  # exit code


def main(
    categories: Annotated[list[str] | None, typer.Argument(help="Names; all by default.")] = None,
    *,
    minutes: Annotated[float, typer.Option(min=0.0, help="Time in which samples are begun [min].")] = 30.0,
    jobs: Annotated[int, typer.Option(min=1, help="Number of processes.")] = 1,
    seed: Annotated[
        int, typer.Option(min=0, help="Seed of the run; seed and number determine a sample.")
    ] = 0,
    limit: Annotated[float, typer.Option(min=1.0, help="Time limit for a sample [s].")] = 120.0,
    fresh: Annotated[bool, typer.Option("--fresh", help="Delete earlier results first.")] = False,
    sample: Annotated[int | None, typer.Option(min=0, help="Measure the sample of this number only.")] = None,
    out: Annotated[Path, typer.Option(help="The file of records.")] = Path("out/soak.jsonl"),
) -> None:
    """Measure samples and list their anomalies; exit code 1 if there are any."""
    console = Console(width=None if sys.stdout.isatty() else 160, highlight=False)
    if sample is not None:
        raise typer.Exit(_one(console, seed, sample))
    names = tuple(categories or all_categories())
    for name in names:
        find(name)
    out.parent.mkdir(parents=True, exist_ok=True)
    interrupted = False
    try:
        with progress(out.name) as update:
            odd = 0

            def step(record: Record) -> None:
                nonlocal odd
                odd += bool(record["anomalies"])
                update(advance=1, failed=f"{odd} with anomalies" if odd else "")

            soak(
                out,
                run=seed,
                names=names,
                seconds=60.0 * minutes,
                jobs=jobs,
                limit=limit,
                fresh=fresh,
                progress=step,
            )
    except KeyboardInterrupt:
        interrupted = True
    records = [record for record in soaked(out, seed) if record["category"] in names]
    _show(console, records)
    if any(record["anomalies"] for record in records):
        raise typer.Exit(1)
    if interrupted:
        raise typer.Exit(_INTERRUPTED)


def _one(console: Console, run: int, number: int) -> int:
    """Measure one sample, show its anomalies, and return the exit code."""
    record = measure_extreme(number, run=run)
    console.print(f"{record['category']} --seed {record['seed']}", markup=False)
    for each in spelled(record["overrides"]):
        console.print(f"  {each}", markup=False, soft_wrap=True)
    console.print(f"{record['state']} {record['message']}", markup=False, soft_wrap=True)
    for each in record["anomalies"]:
        console.print(f"{each['kind']}: {each['message']}", markup=False, soft_wrap=True)
    return int(bool(record["anomalies"]))


def _show(console: Console, records: list[Record]) -> None:
    """Show a row for each category, and each anomaly with the command that reproduces it."""
    table = Table(box=None, pad_edge=False, header_style="bold")
    for column in ("category", "samples", "ruled out", "with anomalies", "of which kinds"):
        table.add_column(column)
    for each in tallies(records):
        kinds = ", ".join(f"{kind} {number}" for kind, number in each.kinds.items())
        table.add_row(each.category, str(each.samples), str(each.ruled_out), str(each.odd), kinds)
    console.print(table)
    for found in anomalies(records):
        console.print(f"\n{found.category}, sample {found.sample}: {found.kind}", markup=False)
        console.print(f"  {shortened(' '.join(found.message.split()))}", markup=False, soft_wrap=True)
        console.print(f"  {found.command}", markup=False, soft_wrap=True)


if __name__ == "__main__":
    try:
        typer.run(main)
    except ArtgenError as error:
        typer.echo(f"error: {' '.join(str(error).split())}", err=True)
        sys.exit(_WRONG_INPUT)
