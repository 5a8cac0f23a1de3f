"""Make a dataset as `artgen generate` does; print its time and the memory of the largest worker.

It is started by benchmarks: `one_run.py DIRECTORY JOBS COUNT CATEGORY...`.
"""

import json
import resource
import sys

from one_process import UNIT

from artgen.dataset import Plan, generate_many


def main() -> None:
    """Make the dataset, and print a line of JSON: wall-clock seconds, and bytes."""
    directory, jobs, count, *categories = sys.argv[1:]
    plan = Plan(tuple(categories), int(count), formats=("mjcf",), textures="none")
    summary = generate_many(plan, directory, jobs=int(jobs))
    # of all the processes that have ended, the largest one counts
    memory = UNIT * resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
    sys.stdout.write(json.dumps({"made": summary.made, "seconds": summary.seconds, "memory": memory}) + "\n")


if __name__ == "__main__":
    main()
