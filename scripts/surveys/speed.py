"""Speed of the simulation of an asset in MuJoCo."""

import math
import time
from collections.abc import Mapping
from pathlib import Path

from artgen.asset import Asset
from artgen.validate.behavior.model import collected_warnings, fixed_model

STEP = 0.002
"""Time step [s]."""

_RUNS = 5
_WINDOWS = 10
_WINDOW = 25  # steps


def speed(asset: Asset, path: Path, q: Mapping[str, float]) -> float:
    """Return the simulated time per time of one core, from rest at some positions of the free joints.

    The same half second is run several times, and each twentieth of a second counts with its fastest run, in
    processor time: so other work on the machine hardly counts.
    """
    import mujoco

    with collected_warnings():
        model = fixed_model(path, looks=True)
        model.opt.timestep = STEP
        data = mujoco.MjData(model)
        best = [math.inf] * _WINDOWS
        for _ in range(_RUNS):
            mujoco.mj_resetData(model, data)
            for name, position in asset.positions(q).items():
                if not asset.joint(name).locked:
                    data.qpos[model.joint(name).qposadr[0]] = position
            mujoco.mj_forward(model, data)
            for window in range(_WINDOWS):
                start = time.thread_time()
                mujoco.mj_step(model, data, nstep=_WINDOW)
                best[window] = min(best[window], time.thread_time() - start)
    return _WINDOWS * _WINDOW * STEP / sum(best)
