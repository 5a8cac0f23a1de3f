"""Make assets one after another in this process, and print the time and the memory of each.

It is started by benchmarks: `one_process.py CATEGORY COUNT SEEDS DIRECTORY`. If there are fewer seeds than
assets, the seeds repeat, and each asset is made again.
"""

import json
import resource
import sys
from functools import partial
from pathlib import Path

from timing import seconds

UNIT = 1 if sys.platform == "darwin" else 1024
"""Bytes in which the system tells the largest memory of a process."""

_STATUS = Path("/proc/self/status")


def largest() -> int:
    """Return the peak memory of this process [bytes].

    On Linux it is read from a file, because `getrusage` there includes the memory of the parent process.
    """
    if _STATUS.exists():
        fields = next(line.split() for line in _STATUS.read_text().splitlines() if line.startswith("VmHWM"))
        return UNIT * int(fields[1])
    return UNIT * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


def main() -> None:
    """Make the assets, and print a line of JSON for each: seconds, and the peak memory in bytes."""
    import artgen

    category, directory = artgen.catalog.find(sys.argv[1]), Path(sys.argv[4])
    count, seeds = int(sys.argv[2]), int(sys.argv[3])

    def make(number: int) -> None:
        cache = artgen.graph.Cache() if seeds < count else None  # by default one that the process shares
        asset = category.generate(number % seeds, cache=cache)
        asset.export(directory / str(number), formats=("mjcf",), textures=0)

    for number in range(count):
        spent = seconds(partial(make, number))
        sys.stdout.write(json.dumps({"seconds": spent, "memory": largest()}) + "\n")


if __name__ == "__main__":
    main()
