"""The run: worker processes take the pictures that a folder has not, as those of a dataset make assets."""

import functools
import os
from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from artgen.dataset.run import Summary, fill
from artgen.errors import RenderError
from artgen.images.coco import write_coco
from artgen.images.make import make
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

    What is drawn depends on the plan alone, not on how many processes work or how often they were
    interrupted: a run in a folder of the same plan makes what is missing.

    Args:
        plan: What to make.
        directory: Where: a folder, or a URL that fsspec knows; made if there is none, else it is empty or
            holds images of the same plan.
        jobs: How many processes work; by default as many as there are cores for this one.
        limit: How long the pictures of one asset may take; by default ten minutes and one for each [s].
        progress: Called with the line of each asset in the manifest as it is added.
        begin: Called before, with how many assets are missing.

    Raises:
        ParameterError: `jobs` is less than one.
        RenderError: MuJoCo, OpenGL or a package is missing; nothing was written.
        ExportError: The folder holds something else, another run writes to it, or the disk refuses; what is
            done stays.
    """
    _check_tools(plan)
    # Mesa draws with all cores in every process otherwise
    os.environ.setdefault("LP_NUM_THREADS", "0")
    return fill(
        plan,
        directory,
        make=make,
        finish=functools.partial(write_coco, plan=plan),
        jobs=jobs,
        limit=600.0 + 60.0 * plan.images if limit is None else limit,
        progress=progress,
        begin=begin,
    )


def _check_tools(plan: ImagePlan) -> None:
    """Look for OpenGL and the packages, and begin a picture."""
    gl.available()
    needed = {"mujoco": "draws pictures", "pycocotools": "encodes masks"}
    if plan.normals:
        needed["embreex"] = "finds normals"
    for name, what in needed.items():
        if find_spec(name) is None:
            raise RenderError(f'{name}, which {what}, is not installed: pip install "artgen[images]"')
    gl.claim_process()
    drawing = gl.context(16, 16)
    drawing.free()
