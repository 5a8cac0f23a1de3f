"""A thousand assets of all categories: processor time, memory of the workers, and disk space."""

import tempfile
from typing import Any

from one_dataset import KINDS
from program import output_of
from report import Section, Table, shown
from timing import baseline

_MOST = (0.6, 1000.0, 1.5)  # seconds an asset; MB of a worker; GB of a thousand
_PRECISION = 0.001

_COMPARED = f"""
`artgen generate` of all categories with a certificate, maps of 512 texels and as many worker processes as
there are cores, twice: first as URDF, MJCF and USD with `--mesh-precision {_PRECISION}` and no map in the
cache, for what it takes on a disk; then as URDF, MJCF, USD and GLB with every triangle and with warm maps,
for what it takes of the processors: of all processes, their starts and the writing of the dataset's tables
included. The fixed workload is timed before and after each. Memory is what the largest worker had resident,
second by second, once each has made some assets; a map, though linked to from many places, counts once.
"""

_RUNS = {
    "cold maps, coarser meshes": ("urdf,mjcf,usd", _PRECISION),
    "warm maps, all formats": ("urdf,mjcf,usd,glb", 0.0),
}


def measure(*, quick: bool) -> Section:
    """Run the benchmark."""
    count = 4 if quick else 1000
    runs: dict[str, dict[str, Any]] = {}
    for name, (formats, precision) in _RUNS.items():
        before = baseline()
        with tempfile.TemporaryDirectory() as directory:
            (runs[name],) = output_of("one_dataset.py", directory, count, formats, precision)
        runs[name]["workload"] = 0.5 * (before + baseline())
    return Section(
        "a thousand assets",
        _COMPARED,
        [_times(runs), _memory(runs), _disk(runs)],
        _findings(*runs.values(), count=count),
    )


def _times(runs: dict[str, dict[str, Any]]) -> Table:
    columns = ("run", "assets", "failed", "processes", "by the clock [s]", "core-seconds an asset")
    return Table(
        "Time",
        (*columns, "fixed workload [ms]", "an asset / fixed workload"),
        [
            (
                name,
                each["made"],
                each["failed"],
                each["jobs"],
                each["clock"],
                _each(each),
                1000.0 * each["workload"],
                _each(each) / each["workload"],
            )
            for name, each in runs.items()
        ],
    )


def _memory(runs: dict[str, dict[str, Any]]) -> Table:
    shares = (0.25, 0.5, 0.75, 1.0)
    return Table(
        "Memory of the largest worker [MB], when a share of the assets was made",
        ("run", *(f"{100.0 * share:.0f} %" for share in shares), "ever"),
        [
            (name, *(_resident(each, share) for share in shares), each["largest"] / 1e6)
            for name, each in runs.items()
        ],
    )


def _resident(run: dict[str, Any], share: float) -> float | None:
    """Return the largest memory in the quarter before the given share of the assets was made [MB]."""
    low, high = (max(0.0, each) * run["made"] for each in (share - 0.25, share))
    found = [memory for made, memory in run["memory"] if low <= made <= high and memory]
    return max(found) / 1e6 if found else None


def _disk(runs: dict[str, dict[str, Any]]) -> Table:
    kinds = [*dict.fromkeys(KINDS.values()), "dataset"]
    return Table(
        "Disk [MB]",
        ("run", *kinds, "all"),
        [
            (name, *(each["bytes"].get(kind, 0) / 1e6 for kind in kinds), sum(each["bytes"].values()) / 1e6)
            for name, each in runs.items()
        ],
    )


def _findings(coarse: dict[str, Any], full: dict[str, Any], count: int) -> list[str]:
    time, memory, disk = _MOST
    size = sum(coarse["bytes"].values()) / 1e9
    largest = max(each["largest"] for each in (coarse, full)) / 1e6
    took = round(_each(full), 3)
    return [
        f"An asset in all formats takes {took} core-seconds ({_verdict(took, time)} {time}).",
        f"No worker had more than {shown(largest)} MB ({_verdict(largest, memory)} {memory:.0f}).",
        f"{count} assets take {shown(size)} GB with coarser meshes"
        + (f" ({_verdict(size, disk)} {disk})." if count == 1000 else "."),
    ]


def _verdict(value: float, most: float) -> str:
    return "at most" if value <= most else "**more than**"


def _each(run: dict[str, Any]) -> float:
    return float(run["processor"] / max(1, run["made"]))
