"""Time every stage of every category, and measure the share of evaluation in compiled code."""

import os
import statistics
import sys
import tempfile
from collections.abc import Callable, Mapping
from pathlib import Path
from time import perf_counter
from types import CodeType
from typing import Any

from report import Section, Table, span
from surveys.summary import MEDIAN_SECONDS
from timing import baseline, timed

import artgen
from artgen.asset import Asset
from artgen.export.layouts import FORMATS, TEXTURES
from artgen.export.meshes import mesh_files
from artgen.generator import Generator

STAGES = (
    "seed to asset",
    "sample, build",
    "evaluate",
    "surfaces",
    "colliders",
    "mass",
    "certificate",
    "mesh files",
    *FORMATS,
    "all, to disk",
)

_COMPARED = f"""
Processor time of every stage of every category, medians over seeds, with a cold cache of values and warm
maps; and the ratio of the whole to a fixed workload of numpy and manifold3d that is timed in the same run,
which compares machines and versions. A category is asked to take at most {1e3 * MEDIAN_SECONDS:g} ms from
seed to asset.
"""


def measure(*, quick: bool) -> Section:
    """Run the benchmark."""
    names = ["plier"] if quick else list(artgen.catalog.categories())
    seeds = range(1) if quick else range(3)
    before = baseline()
    found, shares = {}, {}
    for name in names:
        category = artgen.catalog.find(name)
        with tempfile.TemporaryDirectory() as directory:
            for seed in seeds:  # imports, first calls and maps that are not in the cache are no part of it
                category.generate(seed).export(Path(directory) / str(seed))
        runs = [stages(category, seed) for seed in seeds]
        found[name] = {stage: statistics.median(run[stage] for run in runs) for stage in STAGES}
        counted = [compiled_share(category, seed) for seed in seeds]
        shares[name] = {of: statistics.median(each[of] for each in counted) for of in counted[0]}
    unit = statistics.median([before, baseline()])
    return Section(
        "every stage of every category",
        _COMPARED,
        [_stage_table(found, unit, len(seeds)), *_share_tables(shares)],
        _findings(found, unit),
    )


def stages(category: Generator, seed: int) -> dict[str, float]:
    """Time each stage of one asset [s]."""
    times: dict[str, float] = {}
    asset, _ = category.evaluate(seed, cache=artgen.graph.Cache())  # the attempt that is feasible
    with timed(times, "seed to asset"):
        category.generate(seed, cache=artgen.graph.Cache(), certify=False)
    with timed(times, "sample, build"):
        values = category.sample(seed, attempt=asset.attempt)
        graph = artgen.Graph(category.build(values))
    numbers = {name: values[name] for name in graph.parameters}
    with timed(times, "evaluate"):
        evaluation = graph.evaluate(numbers, artgen.graph.Cache())
    asset = Asset.from_tree(evaluation.value, f"{category.name}_{seed}", category.name, seed=seed)
    with timed(times, "surfaces"):
        _ = [link.surfaces for link in asset.links]
    with timed(times, "colliders"):
        _ = [link.colliders for link in asset.links]
    with timed(times, "mass"):
        _ = asset.mass
    with timed(times, "certificate"):
        asset.certify()
    with timed(times, "mesh files"):
        mesh_files(asset)  # URDF and MJCF share them
    for name, write in FORMATS.items():
        with timed(times, name):
            write(asset, TEXTURES)
    with tempfile.TemporaryDirectory() as directory, timed(times, "all, to disk"):
        category.generate(seed, cache=artgen.graph.Cache()).export(Path(directory) / "asset")
    return times


def compiled_seconds(run: Callable[[], Any]) -> dict[str, float]:
    """Time of calls of manifold3d and numpy while a function runs [s].

    Operators on arrays do not count as calls, so the number of numpy is a lower bound.
    """
    spent = {"manifold3d": 0.0, "numpy": 0.0}
    started: dict[Any, float] = {}
    monitoring, tool = sys.monitoring, sys.monitoring.PROFILER_ID

    def owner(function: Any) -> str:
        kind = getattr(function, "__objclass__", None) or type(getattr(function, "__self__", function))
        name = getattr(function, "__module__", None) or kind.__module__
        return str(name).partition(".")[0]

    def before(code: CodeType, _offset: int, function: Any, _argument: Any) -> None:
        # what numpy's own Python code calls is part of the call into numpy
        if f"{os.sep}numpy{os.sep}" not in code.co_filename:
            started.clear()
            if owner(function) in spent:
                started[id(function)] = perf_counter()

    def after(_code: CodeType, _offset: int, function: Any, _argument: Any) -> None:
        start = started.pop(id(function), None)
        if start is not None:
            spent[owner(function)] += perf_counter() - start

    events = monitoring.events
    monitoring.use_tool_id(tool, "bench")
    monitoring.register_callback(tool, events.CALL, before)
    for event in (events.C_RETURN, events.C_RAISE):
        monitoring.register_callback(tool, event, after)
    monitoring.set_events(tool, events.CALL)
    try:
        run()
    finally:
        monitoring.set_events(tool, events.NO_EVENTS)
        monitoring.free_tool_id(tool)
    return spent


def compiled_share(category: Generator, seed: int) -> dict[str, float]:
    """Return the shares of evaluation in calls of manifold3d and of numpy.

    Empty before Python 3.12, which cannot measure it.
    """
    if sys.version_info < (3, 12):
        return {}
    asset, _ = category.evaluate(seed, cache=artgen.graph.Cache())
    values = category.sample(seed, attempt=asset.attempt)
    graph = artgen.Graph(category.build(values))
    numbers = {name: values[name] for name in graph.parameters}

    def run() -> float:
        start = perf_counter()
        graph.evaluate(numbers, artgen.graph.Cache())
        return perf_counter() - start

    # the quietest of a few runs with and without counting: counting itself takes time
    seconds = min(run() for _ in range(5))
    spent = min((compiled_seconds(run) for _ in range(5)), key=lambda found: sum(found.values()))
    return {name: value / seconds for name, value in spent.items()}


def _stage_table(found: Mapping[str, Mapping[str, float]], unit: float, seeds: int) -> Table:
    return Table(
        f"Milliseconds, medians of {seeds} seeds",
        ("category", *STAGES, "all / fixed workload"),
        [
            (name, *(1e3 * times[stage] for stage in STAGES), times["all, to disk"] / unit)
            for name, times in found.items()
        ],
    )


def _share_tables(shares: Mapping[str, Mapping[str, float]]) -> list[Table]:
    """Return the table of the shares of evaluation in compiled code, if Python can measure them."""
    packages = list(next(iter(shares.values())))
    if not packages:
        return []
    return [
        Table(
            "Share of evaluation in compiled code [%]",
            ("category", *packages),
            [(name, *(100.0 * each[package] for package in packages)) for name, each in shares.items()],
        )
    ]


def _findings(found: Mapping[str, Mapping[str, float]], unit: float) -> list[str]:
    slow = [name for name, times in found.items() if times["seed to asset"] > MEDIAN_SECONDS]
    whole = [1e3 * times["all, to disk"] for times in found.values()]
    return [
        (
            f"From the seed to files in all formats, an asset takes {span(whole)} ms; the fixed workload "
            f"takes {1e3 * unit:.1f} ms."
        ),
        f"From seed to asset, {len(found) - len(slow)} of {len(found)} categories take at most "
        f"{1e3 * MEDIAN_SECONDS:g} ms" + (f"; more take {', '.join(slow)}." if slow else "."),
    ]
