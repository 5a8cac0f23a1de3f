"""MJX driver: reads an MJCF with Warp unchanged if it is installed, and with JAX without contacts.

In JAX, MJX has no contacts of cylinders with boxes and meshes, and allocates every pair of colliders that may
touch, which are thousands; so only the joints are simulated.
"""

import importlib.util
from typing import Any

import numpy as np
from driver_protocol import in_base, require, serve

require("jax", "mujoco")
import jax
import mujoco
from mujoco import mjx
from mujoco_model import Model

_STEPS = 20
_CONTACTS = 1024  # room for contacts, and four times as much for constraints


def _read(request: dict[str, Any]) -> dict[str, Any]:
    model = mujoco.MjModel.from_xml_path(request["file"])
    try:
        mjx.put_model(model)
        note = "JAX takes its contacts"
    except NotImplementedError as error:
        note = f"JAX: {error}"
    bare = mujoco.MjModel.from_xml_path(request["file"])
    bare.geom_contype[:] = bare.geom_conaffinity[:] = 0
    converted = mjx.put_model(bare)
    fields = Model(model, lambda name: getattr(converted, name))
    data, kinematics = mjx.make_data(converted), jax.jit(mjx.kinematics)
    poses = []
    for pose in request["poses"]:
        placed = kinematics(converted, data.replace(qpos=jax.numpy.array(fields.placed(pose))))
        frames = fields.frames(np.asarray(placed.xpos), np.asarray(placed.xmat))
        poses.append(in_base(frames, request["links"]))
    states = [_stepped(converted, data)]
    if importlib.util.find_spec("warp"):
        import warp

        warp.config.log_level = warp.LOG_WARNING  # official switch for its banner
        whole = mjx.put_model(model, impl="warp")
        room = mjx.make_data(model, impl="warp", naconmax=_CONTACTS, njmax=4 * _CONTACTS)
        states.append(_stepped(whole, room))
        note = f"Warp takes its contacts; {note}"
    return {
        **fields.read(request),
        "poses": poses,
        "steps": _STEPS * len(states),
        "finite": bool(np.isfinite(states).all()),
        "note": note,
    }


def _stepped(model: Any, data: Any) -> Any:
    """Return the joint positions after several steps."""
    step = jax.jit(mjx.step)
    for _ in range(_STEPS):
        data = step(model, data)
    return np.asarray(data.qpos)


if __name__ == "__main__":
    serve(_read)
