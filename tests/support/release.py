"""Joints that are let go in MuJoCo."""

import mujoco

from artgen.asset import Asset


def released(asset: Asset, name: str, position: float, *, seconds: float = 1.0, pull: float = 0.0) -> float:
    """Return where a joint stands some time after it was let go at a position, or pulled by a force."""
    model = asset.to_mjspec().compile()
    data = mujoco.MjData(model)
    joint = model.joint(name)
    data.qpos[joint.qposadr[0]] = position
    data.qfrc_applied[joint.dofadr[0]] = pull
    mujoco.mj_step(model, data, nstep=round(seconds / model.opt.timestep))
    return float(data.qpos[joint.qposadr[0]])
