"""Assets per second by the number of processes, and the memory of a worker."""

import hashlib
import statistics
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from program import output_of
from report import Section, Table, shown

from artgen.dataset.workers import cores

CATEGORIES = ("drawer", "cabinet", "plier")

_COMPARED = f"""
`artgen generate {" ".join(CATEGORIES)} -n COUNT --format mjcf --textures none` with one worker process and
with more, in turn, by the clock: starting the workers counts. The files of all runs are compared byte by
byte. Memory is the largest that a process ever had resident, of the largest worker of a run; and of one
process that makes one asset after another, to see whether it goes on growing.
"""


def measure(*, quick: bool) -> Section:
    """Run the benchmark."""
    most = cores()
    jobs = sorted(
        {1, most} if quick else {1, 2, *(2**power for power in range(2, 8) if 2**power < most), most}
    )
    count, rounds = (3, 1) if quick else (30, 2)
    runs: dict[int, list[dict[str, Any]]] = {number: [] for number in jobs}
    digests = set()
    for _ in range(rounds):
        for number in jobs:
            with tempfile.TemporaryDirectory() as directory:
                runs[number] += output_of("one_run.py", directory, number, count, *CATEGORIES)
                digests.add(digest(Path(directory)))
    with tempfile.TemporaryDirectory() as directory:
        number = 3 if quick else 60
        row = output_of("one_process.py", "drawer", number, number, directory)
    rates = {
        number: statistics.median(each["made"] / each["seconds"] for each in of)
        for number, of in runs.items()
    }
    memory = [each["memory"] for each in row]
    return Section(
        "processes and memory",
        _COMPARED,
        [_rate_table(runs, rates, count), _memory_table(memory)],
        [
            *_rates_told(rates),
            "The files of all runs are the same, byte by byte."
            if len(digests) == 1
            else f"**The files of the runs differ: there are {len(digests)} different sets.**",
            _growth(memory),
        ],
    )


def digest(directory: Path) -> str:
    """Return a digest of all files below a folder and of their names."""
    found = hashlib.sha256()
    for path in sorted(path for path in directory.rglob("*") if path.is_file()):
        found.update(str(path.relative_to(directory)).encode() + b"\0")
        found.update(hashlib.sha256(path.read_bytes()).digest())
    return found.hexdigest()


def _rate_table(
    runs: Mapping[int, Sequence[dict[str, Any]]], rates: Mapping[int, float], count: int
) -> Table:
    return Table(
        f"{count} assets, medians of {len(runs[1])} runs",
        ("processes", "assets/s", "ratio to one", "of the ideal [%]", "largest worker [MiB]"),
        [
            (
                str(number),
                rate,
                rate / rates[1],
                100.0 * rate / rates[1] / number,
                statistics.median(each["memory"] for each in runs[number]) / 2**20,
            )
            for number, rate in rates.items()
        ],
    )


def _memory_table(memory: Sequence[int]) -> Table:
    at = sorted({1, min(10, len(memory)), *range(20, len(memory) + 1, 20), len(memory)})
    return Table(
        "One drawer after another in one process",
        ("assets made", "largest memory [MiB]", "ratio to the first"),
        [(str(number), memory[number - 1] / 2**20, memory[number - 1] / memory[0]) for number in at],
    )


def _rates_told(rates: Mapping[int, float]) -> list[str]:
    more = {number: rate / rates[1] for number, rate in rates.items() if number > 1}
    if not more:
        return ["There is one core, so there is nothing to compare."]
    last = max(more)
    return [f"{last} processes make {shown(more[last])} times as many assets a second as one."]


def _growth(memory: Sequence[int]) -> str:
    half = len(memory) // 2
    first, last = memory[0] / 2**20, memory[-1] / 2**20
    grown = (memory[-1] - memory[half]) / 2**20 / (len(memory) - half)
    return (
        f"A process has {shown(first)} MiB after the first asset and {shown(last)} MiB after {len(memory)}; "
        f"in the second half it grows by {shown(grown)} MiB an asset."
    )
