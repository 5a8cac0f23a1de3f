"""MuJoCo Warp driver: reads an MJCF and simulates it at rest."""

from typing import Any

import numpy as np
from driver_protocol import in_base, require, serve

require("mujoco_warp")
import warp

warp.config.log_level = warp.LOG_WARNING  # official switch for its banner; warnings stay
import mujoco
import mujoco_warp
from mujoco_model import Model

_STEPS = 200
_CONTACTS = 1024  # room for contacts, and four times as much for constraints


def _read(request: dict[str, Any]) -> dict[str, Any]:
    model = mujoco.MjModel.from_xml_path(request["file"])
    with warp.ScopedDevice("cpu"):
        converted = mujoco_warp.put_model(model)
        fields = Model(model, lambda name: getattr(converted, name).numpy())
        poses = []
        for pose in request["poses"]:
            data = _data(model, fields.placed(pose))
            mujoco_warp.kinematics(converted, data)
            frames = fields.frames(data.xpos.numpy()[0], data.xmat.numpy()[0])
            poses.append(in_base(frames, request["links"]))
        data = _data(model, fields.placed(request["poses"][0]))
        for _ in range(_STEPS):
            mujoco_warp.step(converted, data)
    return {
        **fields.read(request),
        "poses": poses,
        "steps": _STEPS,
        "finite": bool(np.isfinite(data.qpos.numpy()).all()),
        "note": f"{int(data.nacon.numpy()[0])} contacts at rest",
    }


def _data(model: Any, qpos: Any) -> Any:
    """Return the state of one world."""
    data = mujoco.MjData(model)
    data.qpos[:] = qpos
    mujoco.mj_forward(model, data)
    return mujoco_warp.put_data(model, data, nworld=1, nconmax=_CONTACTS, njmax=4 * _CONTACTS)


if __name__ == "__main__":
    serve(_read)
