"""Cost by the number of joints, links and parts of an asset, and by the number of earlier assets."""

import statistics
import tempfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from program import output_of
from report import Cell, Section, Table, shown
from timing import timed

import artgen

STAGES = ("seed to asset", "certificate", "export")

_BUCKETS = {"1": (1, 1), "2 to 3": (2, 3), "4 to 6": (4, 6), "7 to 9": (7, 9), "10 or more": (10, 10_000)}
_SEEDS = 5  # of the assets that are made again and again
_COMPARED = """
What an asset takes of the processor, against how much there is of it: from the seed to the asset, the
certificate, and an export as MJCF without maps, over seeds of all categories. The first table takes assets
together by their number of joints. The second fits a power to each stage: 1 is growth in proportion, and r²
is the share of the differences (of logarithms) that the fit explains. The third makes the
same few assets again and again in one new process, each time anew, and compares each of them with its own
median: the first one pays for what is imported with it.
"""


@dataclass(frozen=True)
class Cost:
    """Times and sizes of an asset.

    Attributes:
        counts: Joints, links, parts (solids), colliders.
        seconds: Time of each of `STAGES`, and of `all` [s].
    """

    counts: Mapping[str, int]
    seconds: Mapping[str, float]


def measure(*, quick: bool) -> Section:
    """Run the benchmark."""
    names = ["drawer", "plier"] if quick else list(artgen.catalog.categories())
    seeds = range(2) if quick else range(4)
    with tempfile.TemporaryDirectory() as directory:
        costs = []
        for name in names:
            _cost(name, 1000, Path(directory))  # imports and first calls are no part of the figures
            costs += [_cost(name, seed, Path(directory)) for seed in seeds]
        row = output_of("one_process.py", "drawer", _SEEDS * (2 if quick else 12), _SEEDS, directory)
    buckets = _buckets(costs)
    row_table, drift = _row_table([each["seconds"] for each in row])
    fits = _fits(costs)
    return Section(
        "cost against the number of joints, parts and assets",
        _COMPARED,
        [_bucket_table(buckets), _fit_table(fits), row_table],
        [*_findings(buckets, fits), drift],
    )


def _cost(name: str, seed: int, directory: Path) -> Cost:
    times: dict[str, float] = {}
    with timed(times, "seed to asset"):
        asset = artgen.catalog.find(name).generate(seed, cache=artgen.graph.Cache(), certify=False)
        for link in asset.links:
            _ = link.colliders
    with timed(times, "certificate"):
        asset.certify()
    with timed(times, "export"):
        asset.export(directory / f"{name}_{seed}", formats=("mjcf",), textures=0)
    counts = {
        "joints": len(asset.joints),
        "links": len(asset.links),
        "parts": sum(not piece.visual for link in asset.links for piece in link.pieces),
        "colliders": sum(len(link.colliders) for link in asset.links),
    }
    return Cost(counts, times | {"all": sum(times.values())})


def _buckets(costs: Sequence[Cost]) -> dict[str, list[Cost]]:
    """Group assets by their number of joints."""
    found = {}
    for name, (low, high) in _BUCKETS.items():
        within = [cost for cost in costs if low <= cost.counts["joints"] <= high]
        if within:
            found[name] = within
    return found


def _bucket_table(buckets: Mapping[str, Sequence[Cost]]) -> Table:
    stages = (*STAGES, "all")
    middles = {
        name: {stage: statistics.median(cost.seconds[stage] for cost in costs) for stage in stages}
        for name, costs in buckets.items()
    }
    first = next(iter(middles.values()))["all"]
    rows: list[tuple[Cell, ...]] = [
        (
            name,
            len(costs),
            statistics.median(cost.counts["parts"] for cost in costs),
            *(1e3 * middles[name][stage] for stage in stages),
            middles[name]["all"] / first,
            1e3 * statistics.median(cost.seconds["all"] / cost.counts["joints"] for cost in costs),
        )
        for name, costs in buckets.items()
    ]
    return Table(
        "By number of joints, medians",
        (
            "joints",
            "assets",
            "parts",
            *(f"{stage} [ms]" for stage in stages),
            "to the first",
            "all / joint [ms]",
        ),
        rows,
    )


def _fits(costs: Sequence[Cost]) -> dict[str, dict[str, tuple[float, float]]]:
    """Fit a power of each count to each stage: exponent and r²."""
    found: dict[str, dict[str, tuple[float, float]]] = {}
    for count in costs[0].counts:
        x = np.log([cost.counts[count] for cost in costs])
        if np.ptp(x) == 0.0:
            continue
        found[count] = {}
        for stage in (*STAGES, "all"):
            y = np.log([cost.seconds[stage] for cost in costs])
            exponent = float(np.polyfit(x, y, 1)[0])
            found[count][stage] = exponent, float(np.corrcoef(x, y)[0, 1] ** 2)
    return found


def _fit_table(fits: Mapping[str, Mapping[str, tuple[float, float]]]) -> Table:
    return Table(
        "The power with which each stage grows, and r²",
        ("with the number of", *(cell for stage in (*STAGES, "all") for cell in (stage, "r²"))),
        [(name, *(round(cell, 2) for pair in each.values() for cell in pair)) for name, each in fits.items()],
    )


def _row_table(times: Sequence[float]) -> tuple[Table, str]:
    """Compare repeated assets of a few seeds, each seed with itself."""
    rounds = np.array(times).reshape(-1, _SEEDS)
    ratios = rounds / np.median(rounds, axis=0)
    first = float(ratios[0, 0])
    middles = [float(np.median(ratios[0, 1:])), *(float(each) for each in np.median(ratios[1:], axis=1))]
    rows: list[tuple[Cell, ...]] = [("1", 1e3 * float(rounds[0, 0]), first)]
    for number, ratio in enumerate(middles):
        start = _SEEDS * number + 1
        each = rounds[0, 1:] if number == 0 else rounds[number]
        name = f"{start + (number == 0)} to {start + _SEEDS - 1}"
        rows.append((name, 1e3 * float(np.median(each)), ratio))
    return (
        Table("Drawers in one process, medians", ("asset", "each [ms]", "to the median of its seed"), rows),
        (
            f"The first asset of a process takes {shown(first)} times as long as the median of its seed; the "
            f"last {_SEEDS} take {shown(middles[-1] / middles[0])} times as long as the first ones after it."
        ),
    )


def _findings(
    buckets: Mapping[str, Sequence[Cost]], fits: Mapping[str, Mapping[str, tuple[float, float]]]
) -> list[str]:
    said = []
    if len(buckets) > 1:
        (few, first), *_, (many, last) = buckets.items()
        seconds = [statistics.median(cost.seconds["all"] for cost in costs) for costs in (first, last)]
        joints = [statistics.median(cost.counts["joints"] for cost in costs) for costs in (first, last)]
        said.append(
            f"An asset of {many} joints has {shown(joints[1] / joints[0])} times as many as one of {few}, "
            f"and takes {shown(seconds[1] / seconds[0])} times as long."
        )
    if fits:
        best = max(fits, key=lambda name: fits[name]["all"][1])
        exponent, explained = fits[best]["all"]
        said.append(
            f"The number of {best} tells most about the cost: it grows with its power {exponent:.2f} "
            f"(r² {explained:.2f})."
        )
    return said
