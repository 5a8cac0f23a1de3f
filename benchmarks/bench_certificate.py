"""Time the certificate of six assets against what it is meant to take.

Each figure is the median over runs on one core, after a run that imports what is needed. Each run has an
asset of its own, evaluated before with its colliders, so that no run finds what another one left. Ratios to
a fixed workload of numpy and manifold3d, timed in the same run, compare machines and versions.
"""

import argparse
import gc
import json
import statistics
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path
from time import perf_counter
from typing import Any

from rich.console import Console
from rich.table import Table

sys.path += [str(Path(__file__).parent), str(Path(__file__).parents[1] / "tests")]

from bench_categories import baseline

from support.proof_assets import PROOF_ASSETS

TARGETS = {
    "bearing_door": 0.080,
    "fridge": 0.050,
    "french_fridge": 0.400,
    "lamp": 0.040,
    "dishwasher": 0.060,
    "cooktop": 0.150,
}
"""Seconds that a proof may take; to measure the clearances it may take twice that."""


def median(prepare: Callable[[], Callable[[], Any]], runs: int) -> float:
    """Return the median time of what some preparations return, a first one left out [s]."""
    times = []
    for _ in range(runs + 1):
        run = prepare()
        gc.collect()
        start = perf_counter()
        run()
        times.append(perf_counter() - start)
    return statistics.median(times[1:])


def prepared(name: str, *, measure: bool) -> Callable[[], Any]:
    """Return what certifies a new asset."""
    asset = PROOF_ASSETS[name]()
    for link in asset.links:
        _ = link.colliders
    return lambda: asset.certify(measure=measure)


def measured(name: str, runs: int) -> dict[str, Any]:
    """Return what the certificate of one asset takes."""
    prove, measure = (median(partial(prepared, name, measure=bracket), runs) for bracket in (False, True))
    asset = PROOF_ASSETS[name]()
    certificate = asset.certify()
    return {
        "links": len(asset.links),
        "pairs": len(certificate.pairs),
        "proven": certificate.proven,
        "target": TARGETS[name],
        "prove": prove,
        "measure": measure,
    }


def show(result: dict[str, Any]) -> None:
    """Print the result as a table."""
    console = Console(width=None if sys.stdout.isatty() else 160)
    table = Table(title=f"milliseconds, median of {result['runs']} runs")
    for column in (
        "asset",
        "links",
        "pairs",
        "verdict",
        "target",
        "prove",
        "of target",
        "measure",
        "of twice",
    ):
        table.add_column(column, justify="left" if column in ("asset", "verdict") else "right")
    table.add_column("prove / baseline", justify="right")
    for name, found in result["assets"].items():
        prove, measure, target = found["prove"], found["measure"], found["target"]
        table.add_row(
            name,
            str(found["links"]),
            str(found["pairs"]),
            "proven" if found["proven"] else "NOT PROVEN",
            f"{1e3 * target:.0f}",
            f"{1e3 * prove:.1f}",
            f"{prove / target:.2f}",
            f"{1e3 * measure:.1f}",
            f"{measure / (2.0 * target):.2f}",
            f"{prove / result['baseline']:.2f}",
        )
    console.print(table)
    console.print(f"baseline: {1e3 * result['baseline']:.1f} ms")


def main() -> None:
    """Run the benchmark."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("assets", nargs="*", help=f"names, of {', '.join(TARGETS)}; all by default")
    parser.add_argument("--runs", type=int, default=11, help="timed runs of each")
    parser.add_argument("--json", action="store_true", help="print JSON instead of a table")
    arguments = parser.parse_args()
    unknown = [name for name in arguments.assets if name not in TARGETS]
    if unknown:
        parser.error(f"there is no asset {unknown[0]!r}; choose from {', '.join(TARGETS)}")
    names = arguments.assets or TARGETS
    result = {
        "python": sys.version.split()[0],
        "runs": arguments.runs,
        "baseline": median(lambda: baseline, 5),
        "assets": {name: measured(name, arguments.runs) for name in names},
    }
    if arguments.json:
        Console(soft_wrap=True).print_json(json.dumps(result))
    else:
        show(result)


if __name__ == "__main__":
    main()
