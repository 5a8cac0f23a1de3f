"""MuJoCo driver: reads a URDF or MJCF and moves its joints. Drivers of its relatives share `Model`."""

from collections.abc import Callable
from typing import Any

import numpy as np
from driver_motion import Simulation, pose_and_drive
from driver_protocol import mass_properties, require, serve, transform

require("mujoco")
import mujoco

_KINDS = {2: "prismatic", 3: "revolute"}  # values of mjtJoint with one degree of freedom


def _read(request: dict[str, Any]) -> dict[str, Any]:
    spec = mujoco.MjSpec.from_file(request["file"])
    if request["format"] == "urdf":
        spec.compiler.fusestatic = False  # keeps links of fixed joints separate
    model = Model(spec.compile())
    answer = model.read(request)
    if request["format"] == "urdf":  # it has no springs and armature
        for joint in answer["joints"].values():
            for quantity in ("stiffness", "armature", "rest"):
                joint.pop(quantity, None)
    return {**answer, **model.simulate(request)}


class Model:
    """Numbers of a model, with MuJoCo's names."""

    def __init__(self, model: Any, get: Callable[[str], Any] | None = None, prefix: str = "") -> None:
        self.model, self.prefix = model, prefix
        get = get or (lambda name: getattr(model, name))
        self._get = lambda name: np.asarray(get(name), float).reshape(np.shape(getattr(model, name)))
        names = {number: model.joint(number).name for number in range(model.njnt)}
        self.joints = {
            name.removeprefix(prefix): number
            for number, name in names.items()
            if model.jnt_type[number] in _KINDS and name.startswith(prefix)
        }
        self.places = {name: int(model.jnt_qposadr[number]) for name, number in self.joints.items()}
        self.degrees = {name: int(model.jnt_dofadr[number]) for name, number in self.joints.items()}

    def _link(self, name: str) -> dict[str, Any]:
        body, turn = self.model.body(self.prefix + name).id, np.zeros(9)
        mujoco.mju_quat2Mat(turn, self._get("body_iquat")[body])
        mass, center, moments = (self._get(f"body_{key}")[body] for key in ("mass", "ipos", "inertia"))
        return mass_properties(mass, center, moments, turn)

    def _joint(self, name: str) -> dict[str, Any]:
        number, degree = self.joints[name], self.degrees[name]
        found = {
            "kind": _KINDS[self.model.jnt_type[number]],
            "limits": self._get("jnt_range")[number] if self.model.jnt_limited[number] else None,
            "damping": np.ravel(self._get("dof_damping")[degree])[0],
            "friction": self._get("dof_frictionloss")[degree],
            "armature": self._get("dof_armature")[degree],
            "stiffness": np.ravel(self._get("jnt_stiffness")[number])[0],
        }
        return found | ({"rest": self._get("qpos_spring")[self.places[name]]} if found["stiffness"] else {})

    def _couplings(self) -> dict[str, list[Any]]:
        """Return leader, ratio and offset by follower."""
        names, found = {number: name for name, number in self.joints.items()}, {}
        for number in np.flatnonzero(self.model.eq_type == mujoco.mjtEq.mjEQ_JOINT):
            pair = [int(self.model.eq_obj1id[number]), int(self.model.eq_obj2id[number])]
            if pair[0] in names:
                # MuJoCo couples displacements from the reference positions
                start, start_of_leader = self._get("qpos0")[self.model.jnt_qposadr[pair]]
                constant, ratio = self._get("eq_data")[number][:2]
                offset = start + constant - ratio * start_of_leader
                found[names[pair[0]]] = [names[pair[1]], ratio, offset]
        return found

    def read(self, request: dict[str, Any]) -> dict[str, Any]:
        """Return links, joints and couplings for a response."""
        return {
            "links": {name: self._link(name) for name in request["links"]},
            "joints": {name: self._joint(name) for name in self.joints},
            "couplings": self._couplings(),
        }

    def frames(self, positions: Any, turns: Any) -> dict[str, Any]:
        """Return the frame of each link."""
        bodies = [(number, self.model.body(number).name) for number in range(1, self.model.nbody)]
        return {
            name.removeprefix(self.prefix): transform(turns[number], positions[number])
            for number, name in bodies
            if name.startswith(self.prefix)
        }

    def placed(self, pose: dict[str, float]) -> Any:
        """Return the positions of the model in a pose, shape (nq,)."""
        qpos = np.array(self.model.qpos0)
        for name, place in self.places.items():
            qpos[place] = pose.get(name, qpos[place])
        return qpos

    def simulate(self, request: dict[str, Any]) -> dict[str, Any]:
        """Return poses, motion and warnings for a response."""
        simulation = _Simulation(self)
        motion = pose_and_drive(simulation, request)
        return {**motion, "said": [*motion.get("said", ()), *warnings_of(simulation.data)]}


class _Simulation(Simulation):
    def __init__(self, model: Model) -> None:
        super().__init__(model.places, model.degrees)
        self._fields, self._model, self.time_step = model, model.model, model.model.opt.timestep
        self.data = mujoco.MjData(self._model)

    def place(self, pose: dict[str, float]) -> None:
        mujoco.mj_resetData(self._model, self.data)
        self.data.qpos[:] = self._fields.placed(pose)
        mujoco.mj_kinematics(self._model, self.data)

    def frames(self) -> dict[str, Any]:
        return self._fields.frames(self.data.xpos, self.data.xmat)

    def positions(self) -> Any:
        return self.data.qpos

    def push(self, forces: dict[str, float]) -> None:
        self.data.qfrc_applied[:] = self.in_order(forces, np.zeros(self._model.nv))

    def step(self, count: int) -> None:
        mujoco.mj_step(self._model, self.data, nstep=count)


def warnings_of(data: Any) -> list[str]:
    """Return the warnings of a simulation as messages."""
    return [f"it warns {each.number} times while stepping" for each in data.warning if each.number]


if __name__ == "__main__":
    serve(_read)
