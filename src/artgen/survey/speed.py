"""How fast MuJoCo simulates an asset."""

import statistics
import time
from collections.abc import Mapping
from pathlib import Path

from artgen.asset import Asset
from artgen.check.behaviour_load import collected_warnings, fixed_model

STEP = 0.002
"""Time step [s]."""

_RUNS = 3
_SIMULATED = 0.5  # [s] in each run


def speed(asset: Asset, path: Path, q: Mapping[str, float]) -> float:
    """Return how many seconds MuJoCo simulates in a second of one core.

    It is the median of three short runs, by the processor's time, so that other work on the machine hardly
    counts.

    Args:
        asset: The asset.
        path: Its MJCF.
        q: Where its free joints start, at rest [rad or m].
    """
    import mujoco

    with collected_warnings():
        model = fixed_model(path)
        model.opt.timestep = STEP
        data = mujoco.MjData(model)
        found = []
        for _ in range(_RUNS):
            mujoco.mj_resetData(model, data)
            for name, position in asset.positions(q).items():
                if not asset.joint(name).locked:
                    data.qpos[model.joint(name).qposadr[0]] = position
            mujoco.mj_forward(model, data)
            start = time.thread_time()
            mujoco.mj_step(model, data, nstep=round(_SIMULATED / STEP))
            found.append(_SIMULATED / (time.thread_time() - start))
    return statistics.median(found)
