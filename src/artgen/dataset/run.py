"""The run that fills the folder of a dataset: worker processes make missing assets."""

import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from artgen.dataset.engine import EngineName, engine_of
from artgen.dataset.folder import Folder, Record, writing
from artgen.dataset.plan import Draws
from artgen.dataset.store import target_of
from artgen.dataset.workers import run_job
from artgen.errors import ParameterError

_TRIES = 3  # tries of an item that ends its process or exceeds the time limit


@dataclass(frozen=True)
class Summary:
    """The result of a run.

    Attributes:
        made: Number of assets made in this run.
        kept: Number of assets that existed before.
        failed: Manifest lines of the assets that failed, in this run and earlier ones.
        seconds: Duration of the run [s].
    """

    made: int
    kept: int
    failed: tuple[Record, ...] = ()
    seconds: float = 0.0


def generate_many(
    plan: Draws,
    directory: str | Path,
    *,
    jobs: int | None = None,
    engine: EngineName = "local",
    address: str | None = None,
    limit: float = 600.0,
    progress: Callable[[Record], None] | None = None,
    begin: Callable[[int], None] | None = None,
) -> Summary:
    """Make all assets of a plan in a folder or at a URL, with a manifest and tables of their parameters.

    The files depend only on the plan, not on the number of processes or interruptions: a run in a folder with
    the same plan makes the missing assets. A failed asset is a line of the manifest with its error. An asset
    that ended its process or exceeded the time limit is tried twice again, and by the next run.

    Args:
        plan: A `Plan`, or an `ImagePlan` for pictures instead of files of the assets.
        directory: A folder, or a URL that fsspec can open; created if necessary. An existing one must be
            empty or hold a dataset with the same plan.
        jobs: Number of processes; by default the number of cores of this process or of the cluster.
        engine: `local` processes, or `ray`.
        address: Address of a running Ray cluster; by default that of the variable RAY_ADDRESS, or a cluster
            is started here.
        limit: Time limit for one asset [s].
        progress: Called with each new line of the manifest.
        begin: Called at the beginning with the number of missing assets.

    Raises:
        ParameterError: `jobs` is less than one, or there is no such engine.
        ExportError: The folder holds something else, another run writes to it, the disk reports an error, or
            there is no such cluster; finished assets stay.
    """
    if jobs is not None and jobs < 1:
        raise ParameterError(f"at least one process has to work, not {jobs}")
    start = time.monotonic()
    target = target_of(directory).absolute()
    with engine_of(engine, jobs=jobs, address=address) as run, Folder.opened(target, plan) as folder:
        kept = sum(record["state"] == "done" for record in folder.records.values())
        if begin is not None:
            begin(len(folder.left()))
        made = 0
        for record in run_job(folder, run, limit=limit, tries=_TRIES):
            made += record["state"] == "done"
            if progress is not None:
                progress(record)
        records = folder.finish()
        with writing(target):
            folder.plan.finish(target, records)
        failed = tuple(record for record in records if record["state"] != "done")
    return Summary(made, kept, failed, time.monotonic() - start)
