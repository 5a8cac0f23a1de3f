"""The run that takes pictures: a dataset whose items are pictures instead of files of assets."""

import os
from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from artgen.dataset.run import Summary, generate_many
from artgen.errors import RenderError
from artgen.images.plan import ImagePlan
from artgen.view import gl


def make_images(
    plan: ImagePlan,
    directory: str | Path,
    *,
    jobs: int | None = None,
    limit: float | None = None,
    progress: Callable[[dict[str, Any]], None] | None = None,
    begin: Callable[[int], None] | None = None,
) -> Summary:
    """Take all pictures of a plan, and list them in the files of COCO: `train.json`, `val.json`, `test.json`.

    The pictures depend on the plan alone, not on the number of processes or of interruptions: a run in a
    folder of the same plan makes the missing ones.

    Args:
        plan: The plan.
        directory: A folder, or a URL that fsspec can open; created if necessary. An existing one is empty or
            holds images of the same plan.
        jobs: Number of processes; by default the number of cores of this process.
        limit: Time limit for one asset; by default ten minutes, and one more for each picture [s].
        progress: Called with each line that is added to the manifest.
        begin: Called at the beginning with the number of missing assets.

    Raises:
        ParameterError: `jobs` is less than one.
        RenderError: MuJoCo, OpenGL or a package is missing; nothing was written.
        ExportError: The folder holds something else, another run writes to it, or the disk refuses; finished
            assets stay.
    """
    _check_tools(plan)
    os.environ.setdefault("LP_NUM_THREADS", "0")  # else Mesa uses all cores in every process
    limit = 600.0 + 60.0 * plan.images if limit is None else limit
    return generate_many(plan, directory, jobs=jobs, limit=limit, progress=progress, begin=begin)


def _check_tools(plan: ImagePlan) -> None:
    """Check OpenGL and the packages."""
    gl.available()
    needed = {"mujoco": "draws pictures", "pycocotools": "encodes masks"}
    if plan.normals:
        needed["embreex"] = "finds normals"
    for name, purpose in needed.items():
        if find_spec(name) is None:
            raise RenderError(f'{name}, which {purpose}, is not installed: pip install "artgen[images]"')
    gl.claim_process()
    gl.context(16, 16).free()
