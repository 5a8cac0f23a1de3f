"""MuJoCo Warp driver: reads an MJCF and simulates it at rest."""

import importlib.metadata
from typing import Any

import numpy as np
from driver_protocol import serve
from mujoco_fields import Fields

_STEPS = 200
_CONTACTS = 1024  # room for contacts, and four times as much for constraints


def read(request: dict[str, Any]) -> dict[str, Any]:
    """Return the response to a request."""
    import warp

    # official switch for its banner; warnings stay
    warp.config.log_level = warp.LOG_WARNING
    import mujoco
    import mujoco_warp

    model = mujoco.MjModel.from_xml_path(request["file"])
    with warp.ScopedDevice("cpu"):
        given = mujoco_warp.put_model(model)
        fields = Fields(model, lambda name: getattr(given, name).numpy())
        poses = []
        for pose in request["poses"]:
            placed = _data(mujoco, mujoco_warp, model, fields.placed(request, pose))
            mujoco_warp.kinematics(given, placed)
            poses.append(fields.frames(placed.xpos.numpy()[0], placed.xmat.numpy()[0], request["links"]))
        data = _data(mujoco, mujoco_warp, model, fields.placed(request, request["poses"][0]))
        for _ in range(_STEPS):
            mujoco_warp.step(given, data)
    return {
        "version": importlib.metadata.version("mujoco-warp"),
        **fields.read(request),
        "poses": poses,
        "steps": _STEPS,
        "finite": bool(np.isfinite(data.qpos.numpy()).all()),
        "note": f"{int(data.nacon.numpy()[0])} contacts at rest",
    }


def _data(mujoco: Any, mujoco_warp: Any, model: Any, qpos: Any) -> Any:
    """Return the state of one world."""
    data = mujoco.MjData(model)
    data.qpos[:] = qpos
    mujoco.mj_forward(model, data)
    return mujoco_warp.put_data(model, data, nworld=1, nconmax=_CONTACTS, njmax=4 * _CONTACTS)


if __name__ == "__main__":
    serve(read, "mujoco_warp")
