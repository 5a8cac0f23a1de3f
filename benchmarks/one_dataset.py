"""Make a dataset of all categories; print its times, the memory of its workers, and its sizes.

It is started by benchmarks: `one_dataset.py DIRECTORY COUNT FORMATS MESH_PRECISION`.
"""

import json
import multiprocessing
import resource
import sys
import threading
from collections import Counter
from pathlib import Path

from one_process import UNIT
from timing import processor_seconds

from artgen import catalog
from artgen.dataset import Plan, generate_many
from artgen.dataset.workers import cores

KINDS = {
    ".obj": "meshes",
    ".mtl": "meshes",
    ".usdc": "usd",
    ".usda": "usd",
    ".png": "maps",
    ".urdf": "urdf, mjcf",
    ".xml": "urdf, mjcf",
    ".glb": "glb",
    ".json": "asset.json",
}
"""What a file is of, by the end of its name; anything else is of the dataset."""


def main() -> None:
    """Make the dataset, and print a line of JSON."""
    directory, count, formats, precision = sys.argv[1:]
    plan = Plan(
        tuple(catalog.categories()),
        int(count),
        formats=tuple(formats.split(",")),
        mesh_precision=float(precision),
    )
    memory: list[tuple[int, int]] = []
    through = threading.Event()
    watch = threading.Thread(target=watched, args=(Path(directory), memory, through))
    start = processor_seconds()
    watch.start()
    try:
        summary = generate_many(plan, directory, jobs=cores())
    finally:
        through.set()
        watch.join()
    result = {
        "made": summary.made,
        "failed": len(summary.failed),
        "jobs": cores(),
        "clock": summary.seconds,
        "processor": processor_seconds() - start,
        "largest": UNIT * resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss,
        "memory": memory,
        "bytes": sizes(Path(directory)),
    }
    sys.stdout.write(json.dumps(result) + "\n")


def watched(directory: Path, memory: list[tuple[int, int]], through: threading.Event) -> None:
    """Record the number of assets and the memory of the largest worker every second [bytes]."""
    manifest = directory / "manifest.jsonl"
    while not through.wait(1.0):
        workers = [resident(worker.pid) for worker in multiprocessing.active_children()]
        made = manifest.read_bytes().count(b"\n") if manifest.exists() else 0
        memory.append((made, max(workers, default=0)))


def resident(process: int | None) -> int:
    """Return the memory of a process [bytes]; 0 if it has ended, or if the system has no file for it."""
    try:
        lines = Path(f"/proc/{process}/status").read_text().splitlines()
    except OSError:
        return 0
    return next((1024 * int(line.split()[1]) for line in lines if line.startswith("VmRSS")), 0)


def sizes(directory: Path) -> dict[str, int]:
    """Return the bytes of each kind of file; a file with several hard links counts once."""
    found = {path.stat().st_ino: path for path in directory.rglob("*") if path.is_file()}
    counted: Counter[str] = Counter()
    for path in found.values():
        counted[KINDS.get(path.suffix, "dataset")] += path.stat().st_size
    return dict(counted)


if __name__ == "__main__":
    main()
