"""Time every stage of every category, and say how much of evaluation is spent in compiled code.

Each figure is the median over seeds, with a cold cache. Ratios to a fixed workload of numpy and manifold3d,
timed in the same run, compare machines and versions.
"""

import argparse
import gc
import json
import os
import statistics
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from time import perf_counter
from types import CodeType
from typing import Any

import numpy as np
from manifold3d import Manifold
from rich.console import Console
from rich.table import Table

import artgen
from artgen.asset import Asset
from artgen.export.formats import FORMATS, TEXTURES
from artgen.export.meshes import mesh_files
from artgen.generator import Generator
from artgen.survey.summary import MEDIAN_SECONDS

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


def baseline() -> float:
    """Time a fixed workload: 20 booleans and 1000 products of small matrices [s]."""
    start = perf_counter()
    solid = Manifold.cube((1.0, 1.0, 1.0), center=True)
    for step in range(20):
        solid -= Manifold.cylinder(2.0, 0.02, circular_segments=16).translate((0.02 * step - 0.2, 0.0, -1.0))
        solid.status()
    values = np.arange(300.0).reshape(-1, 3)
    for _ in range(1000):
        values = values @ np.eye(3)
    return perf_counter() - start


@contextmanager
def timed(times: dict[str, float], stage: str) -> Iterator[None]:
    """Add how long a stage took [s]."""
    gc.collect()
    start = perf_counter()
    yield
    times[stage] = perf_counter() - start


def stages(category: Generator, seed: int) -> dict[str, float]:
    """Time each stage of one asset [s]."""
    times: dict[str, float] = {}
    asset, _ = category.evaluate(seed, cache=artgen.Cache())  # the attempt that is feasible
    with timed(times, "seed to asset"):
        category.generate(seed, cache=artgen.Cache(), certify=False)
    with timed(times, "sample, build"):
        values = category.sample(seed, attempt=asset.attempt)
        graph = artgen.Graph(category.build(values))
    numbers = {name: values[name] for name in graph.parameters}
    with timed(times, "evaluate"):
        evaluation = graph.evaluate(numbers, artgen.Cache())
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
        category.generate(seed, cache=artgen.Cache()).export(Path(directory) / "asset")
    return times


def compiled_seconds(run: Callable[[], Any]) -> dict[str, float]:
    """Time spent in calls into manifold3d and numpy while something runs [s].

    Operators on arrays are no calls, so numpy's figure is a lower bound. Empty before Python 3.12, which
    cannot tell.
    """
    if sys.version_info < (3, 12):
        return {}
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
    """Return the share of evaluation that is spent in calls into manifold3d and into numpy."""
    asset, _ = category.evaluate(seed, cache=artgen.Cache())
    values = category.sample(seed, attempt=asset.attempt)
    graph = artgen.Graph(category.build(values))
    numbers = {name: values[name] for name in graph.parameters}

    def run() -> float:
        start = perf_counter()
        graph.evaluate(numbers, artgen.Cache())
        return perf_counter() - start

    # the quietest of a few runs with and without counting: counting itself takes time
    seconds = min(run() for _ in range(5))
    spent = min((compiled_seconds(run) for _ in range(5)), key=lambda found: sum(found.values()))
    return {name: value / seconds for name, value in spent.items()}


def measure(category: Generator, seeds: int, unit: float) -> dict[str, Any]:
    """Return the medians over seeds of one category.

    Args:
        category: What to time.
        seeds: Number of seeds.
        unit: What ratios are taken to [s].
    """
    runs = [stages(category, seed) for seed in range(seeds)]
    shares = [compiled_share(category, seed) for seed in range(seeds)]
    seconds = {stage: statistics.median(run[stage] for run in runs) for stage in STAGES}
    return {
        "seconds": seconds,
        "ratios to the baseline": {stage: value / unit for stage, value in seconds.items()},
        "compiled share of evaluate": {
            name: statistics.median(share[name] for share in shares) for name in shares[0]
        },
    }


def show(result: dict[str, Any]) -> None:
    """Print the result as tables."""
    console = Console(width=None if sys.stdout.isatty() else 160)
    table = Table(title="milliseconds, median over seeds")
    for column in ("category", *STAGES, "all / baseline"):
        table.add_column(column, justify="left" if column == "category" else "right")
    table.add_row("at most", f"{1e3 * MEDIAN_SECONDS:g}", end_section=True)
    for name, found in result["categories"].items():
        cells = [f"{1e3 * found['seconds'][stage]:.1f}" for stage in STAGES]
        if found["seconds"]["seed to asset"] > MEDIAN_SECONDS:
            cells[0] = f"[bold red]{cells[0]}[/]"
        table.add_row(name, *cells, f"{found['ratios to the baseline']['all, to disk']:.2f}")
    console.print(table)
    console.print(f"baseline: {1e3 * result['baseline']:.1f} ms")
    for name, found in result["categories"].items():
        shares = found["compiled share of evaluate"]
        shown = ", ".join(f"{package} {share:.0%}" for package, share in shares.items())
        console.print(f"{name}: of evaluate in {shown or 'compiled code: unknown before Python 3.12'}")


def main() -> None:
    """Run the benchmark."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("categories", nargs="*", help="names; all by default")
    parser.add_argument("--seeds", type=int, default=10, help="number of seeds")
    parser.add_argument("--json", action="store_true", help="print JSON instead of tables")
    arguments = parser.parse_args()
    names = arguments.categories or artgen.catalog.categories()
    for name in names:  # imports and first calls are no part of the figures
        artgen.generate(name, 0).export(Path(tempfile.mkdtemp()) / name)
    unit = statistics.median(baseline() for _ in range(5))
    result = {
        "version": artgen.__version__,
        "python": sys.version.split()[0],
        "seeds": arguments.seeds,
        "baseline": unit,
        "categories": {name: measure(artgen.catalog.find(name), arguments.seeds, unit) for name in names},
    }
    if arguments.json:
        Console(soft_wrap=True).print_json(json.dumps(result))
    else:
        show(result)


if __name__ == "__main__":
    main()
