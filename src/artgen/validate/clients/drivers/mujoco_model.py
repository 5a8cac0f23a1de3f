"""MuJoCo driver: reads a URDF or MJCF and moves its joints."""

from typing import Any

import numpy as np
from driver_motion import drive_all
from driver_protocol import about_axes, serve, transform

_KINDS = {2: "prismatic", 3: "revolute"}  # values of mjtJoint with one degree of freedom


def read(request: dict[str, Any]) -> dict[str, Any]:
    """Return the response to a request."""
    import mujoco

    spec = mujoco.MjSpec.from_file(request["file"])
    if request["format"] == "urdf":
        spec.compiler.fusestatic = False  # keeps links of fixed joints separate
    model = spec.compile()
    data = mujoco.MjData(model)
    joints = {
        model.joint(number).name: number for number in range(model.njnt) if model.jnt_type[number] in _KINDS
    }
    poses = []
    for q in request["poses"]:
        for name, number in joints.items():
            data.qpos[model.jnt_qposadr[number]] = q[name]
        mujoco.mj_kinematics(model, data)
        poses.append(_frames(data, request["links"]))
    simulation = _Simulation(mujoco, model, joints, request["poses"][0])
    moved = drive_all(simulation, request)
    return {
        "version": mujoco.__version__,
        "links": {name: _link(mujoco, model, name) for name in request["links"]},
        "joints": {name: _joint(model, number, request["format"]) for name, number in joints.items()},
        "couplings": dict(_coupling(model, number) for number in range(model.neq)),
        "poses": poses,
        "moved": moved,
        "steps": simulation.steps,
        "finite": simulation.finite,
        "said": [
            f"it warns {each.number} times while stepping" for each in simulation.data.warning if each.number
        ],
    }


def _frames(data: Any, links: list[str]) -> dict[str, Any]:
    found = {name: transform(data.body(name).xmat, data.body(name).xpos) for name in links}
    base = np.linalg.inv(found[links[0]])
    return {name: base @ frame for name, frame in found.items()}


def _link(mujoco: Any, model: Any, name: str) -> dict[str, Any]:
    body = model.body(name)
    turn = np.zeros(9)
    mujoco.mju_quat2Mat(turn, body.iquat)
    inertia = about_axes(body.inertia, turn.reshape(3, 3))
    return {"mass": body.mass[0], "center": body.ipos, "inertia": inertia}


def _joint(model: Any, number: int, form: str) -> dict[str, Any]:
    degree = model.jnt_dofadr[number]
    found = {
        "kind": _KINDS[model.jnt_type[number]],
        "limits": model.jnt_range[number] if model.jnt_limited[number] else None,
        "damping": np.ravel(model.dof_damping[degree])[0],
        "friction": model.dof_frictionloss[degree],
    }
    if form == "mjcf":
        found["stiffness"] = np.ravel(model.jnt_stiffness[number])[0]
        found["armature"] = model.dof_armature[degree]
        if found["stiffness"]:
            found["rest"] = model.qpos_spring[model.jnt_qposadr[number]]
    return found


def _coupling(model: Any, number: int) -> tuple[str, list[Any]]:
    follower, leader = int(model.eq_obj1id[number]), int(model.eq_obj2id[number])
    # MuJoCo couples displacements from the reference positions
    start, start_of_leader = (float(model.qpos0[model.jnt_qposadr[joint]]) for joint in (follower, leader))
    ratio = float(model.eq_data[number, 1])
    offset = start + float(model.eq_data[number, 0]) - ratio * start_of_leader
    return model.joint(follower).name, [model.joint(leader).name, ratio, offset]


class _Simulation:
    """A MuJoCo simulation from the initial positions."""

    def __init__(self, mujoco: Any, model: Any, joints: dict[str, int], start: dict[str, float]) -> None:
        self._mujoco, self._model, self.data = mujoco, model, mujoco.MjData(model)
        self._places = {name: int(model.jnt_qposadr[number]) for name, number in joints.items()}
        self._degrees = {name: int(model.jnt_dofadr[number]) for name, number in joints.items()}
        for name, place in self._places.items():
            self.data.qpos[place] = start[name]
        self.steps, self.finite = 0, True

    def position(self, name: str) -> float:
        return float(self.data.qpos[self._places[name]])

    def push(self, forces: dict[str, float]) -> None:
        self.data.qfrc_applied[list(self._degrees.values())] = 0.0
        for name, force in forces.items():
            self.data.qfrc_applied[self._degrees[name]] = force

    def advance(self, seconds: float) -> None:
        count = max(1, round(seconds / self._model.opt.timestep))
        self._mujoco.mj_step(self._model, self.data, nstep=count)
        self.steps += count
        self.finite = self.finite and bool(np.isfinite(self.data.qpos).all())


if __name__ == "__main__":
    serve(read, "mujoco")
