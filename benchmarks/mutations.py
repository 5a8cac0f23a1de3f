"""Insert faults into assets one by one, and compare the proof with exact booleans.

The long form of `tests/validate/test_mutations.py`. Exits with 1 if a mutant that collides is proven, or if
more than 1 % are undecided.
"""

import argparse
import random
import sys
from collections import Counter
from pathlib import Path

from rich.console import Console
from rich.table import Table

sys.path.append(str(Path(__file__).parents[1] / "tests"))

from artgen import catalog
from artgen.asset import Asset
from support.mutations import Outcome, judged, mutants
from support.proof_assets import PROOF_ASSETS

UNDECIDED = 0.01
"""Share of mutants that may be neither proven nor shown to collide."""

COLUMNS = ("mutants", "proven", "collision", "undecided", "overlap found", "missed")


def assets(names: list[str], seeds: int) -> dict[str, Asset]:
    """Return the assets to change, by name: those made for tests, and seeds of categories."""
    found: dict[str, Asset] = {}
    for name in names or [*PROOF_ASSETS, *catalog.categories()]:
        if name in PROOF_ASSETS:
            found[name] = PROOF_ASSETS[name]()
            continue
        for seed in range(seeds):
            found[f"{name} {seed}"] = catalog.find(name).generate(seed, certify=False)
    return found


def counted(outcome: Outcome) -> Counter[str]:
    """Return the columns in which an outcome counts."""
    verdict = "proven" if outcome.proven else "undecided" if outcome.undecided else "collision"
    row = Counter({"mutants": 1, verdict: 1})
    row["overlap found"] += outcome.overlap is not None
    row["missed"] += outcome.missed
    return row


def show(console: Console, title: str, rows: dict[str, Counter[str]]) -> None:
    """Print the counts of some groups of mutants, and of all."""
    table = Table(title=title)
    table.add_column("")
    for column in COLUMNS:
        table.add_column(column, justify="right")
    for name, row in {**rows, "all": sum(rows.values(), Counter())}.items():
        table.add_row(name, *(str(row[column]) for column in COLUMNS))
    console.print(table)


def main() -> int:
    """Run all mutants and return the exit code."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("assets", nargs="*", help="names of test assets and categories; all by default")
    parser.add_argument("--poses", type=int, default=10_000, help="poses at which booleans are computed")
    parser.add_argument("--seeds", type=int, default=1, help="assets of each category")
    parser.add_argument("--most", type=int, help="mutants of each asset, drawn at random; all by default")
    arguments = parser.parse_args()
    console = Console(width=None if sys.stdout.isatty() else 160)
    by_asset: dict[str, Counter[str]] = {}
    by_kind: dict[str, Counter[str]] = {}
    for name, asset in assets(arguments.assets, arguments.seeds).items():
        chosen = list(mutants(asset))
        if arguments.most is not None and arguments.most < len(chosen):
            chosen = random.Random(name).sample(chosen, arguments.most)  # noqa: S311 - no secret
        for mutant in chosen:
            outcome = judged(mutant, arguments.poses)
            row = counted(outcome)
            by_asset[name] = by_asset.get(name, Counter()) + row
            by_kind[mutant.kind] = by_kind.get(mutant.kind, Counter()) + row
            if outcome.missed or outcome.undecided:
                console.print(str(outcome), style="red" if outcome.missed else "yellow", highlight=False)
    show(console, "by asset", by_asset)
    show(console, f"by fault, {arguments.poses} poses each", by_kind)
    every = sum(by_kind.values(), Counter())
    return int(every["missed"] > 0 or every["undecided"] > UNDECIDED * every["mutants"])


if __name__ == "__main__":
    sys.exit(main())
