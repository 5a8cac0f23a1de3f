"""Links, joints and couplings from the arrays of a model, for drivers of MuJoCo's relatives."""

from collections.abc import Callable
from typing import Any

import numpy as np
from driver_protocol import about_axes, transform

_KINDS = {2: "prismatic", 3: "revolute"}  # values of mjtJoint with one degree of freedom


class Fields:
    """Numbers of a model, with MuJoCo's names."""

    def __init__(self, model: Any, get: Callable[[str], Any], prefix: str = "") -> None:
        self.model, self.prefix = model, prefix
        self._get = lambda name: np.asarray(get(name), float).reshape(np.shape(getattr(model, name)))

    def joints(self, request: dict[str, Any]) -> dict[str, int]:
        """Return the number of each requested joint that the model has."""
        found = {self.model.joint(number).name: number for number in range(self.model.njnt)}
        names = [joint["name"] for joint in request["joints"]]
        return {name: found[self.prefix + name] for name in names if self.prefix + name in found}

    def link(self, name: str) -> dict[str, Any]:
        """Return the mass properties of a link."""
        import mujoco

        body, turn = self.model.body(self.prefix + name).id, np.zeros(9)
        mujoco.mju_quat2Mat(turn, self._get("body_iquat")[body])
        inertia = about_axes(self._get("body_inertia")[body], turn.reshape(3, 3))
        return {
            "mass": self._get("body_mass")[body],
            "center": self._get("body_ipos")[body],
            "inertia": inertia,
        }

    def joint(self, number: int) -> dict[str, Any]:
        """Return the values of a joint."""
        degree, place = self.model.jnt_dofadr[number], self.model.jnt_qposadr[number]
        found = {
            "kind": _KINDS[self.model.jnt_type[number]],
            "limits": self._get("jnt_range")[number] if self.model.jnt_limited[number] else None,
            "damping": np.ravel(self._get("dof_damping")[degree])[0],
            "friction": self._get("dof_frictionloss")[degree],
            "armature": self._get("dof_armature")[degree],
            "stiffness": np.ravel(self._get("jnt_stiffness")[number])[0],
        }
        return found | ({"rest": self._get("qpos_spring")[place]} if found["stiffness"] else {})

    def couplings(self) -> dict[str, list[Any]]:
        """Return leader, ratio and offset by follower."""
        found = {}
        for number in range(self.model.neq):
            follower, leader = int(self.model.eq_obj1id[number]), int(self.model.eq_obj2id[number])
            name = self.model.joint(follower).name
            if name.startswith(self.prefix):
                # MuJoCo couples displacements from the reference positions
                places = self.model.jnt_qposadr[[follower, leader]]
                start, before = self._get("qpos0")[places]
                constant, ratio = self._get("eq_data")[number][:2]
                name_of_leader = self.model.joint(leader).name.removeprefix(self.prefix)
                found[name.removeprefix(self.prefix)] = [
                    name_of_leader,
                    ratio,
                    start + constant - ratio * before,
                ]
        return found

    def read(self, request: dict[str, Any]) -> dict[str, Any]:
        """Return links, joints and couplings for a response."""
        return {
            "links": {name: self.link(name) for name in request["links"]},
            "joints": {name: self.joint(number) for name, number in self.joints(request).items()},
            "couplings": self.couplings(),
        }

    def frames(self, positions: Any, turns: Any, links: list[str]) -> dict[str, Any]:
        """Return the frame of each link in that of the base."""
        bodies = {name: self.model.body(self.prefix + name).id for name in links}
        found = {name: transform(turns[body], positions[body]) for name, body in bodies.items()}
        base = np.linalg.inv(found[links[0]])
        return {name: base @ frame for name, frame in found.items()}

    def placed(self, request: dict[str, Any], pose: dict[str, float]) -> Any:
        """Return the positions of the model in a pose, shape (nq,)."""
        qpos = np.array(self.model.qpos0)
        for name, number in self.joints(request).items():
            qpos[self.model.jnt_qposadr[number]] = pose[name]
        return qpos
