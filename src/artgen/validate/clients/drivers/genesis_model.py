"""Genesis driver: reads a URDF or MJCF and moves its joints on the CPU."""

from functools import cache
from importlib import import_module
from typing import Any

import numpy as np
from driver_motion import drive_all, in_base, posed
from driver_protocol import serve

_STEP = 0.002  # [s]
_UNLIMITED = 1e5  # larger limits count as none


def read(request: dict[str, Any]) -> dict[str, Any]:
    """Return the response to a request."""
    genesis = _genesis()
    scene = genesis.Scene(show_viewer=False, sim_options=genesis.options.SimOptions(dt=_STEP))
    # without these options, Genesis invents missing values and merges links of fixed joints
    options = {"file": request["file"], "default_armature": 0.0, "align": False}
    if request["format"] == "urdf":
        fixed = request["base"] == "fixed"
        morph = genesis.morphs.URDF(**options, fixed=fixed, merge_fixed_links=False)
    else:
        morph = genesis.morphs.MJCF(**options)
    run = _Run(scene, scene.add_entity(morph))
    response = {
        "version": genesis.__version__,
        "links": run.links(request["links"]),
        "joints": run.joints(request["format"]),
        "couplings": run.couplings(),
        "poses": [run.pose(pose, request["links"]) for pose in request["poses"]],
    }
    run.start(request["poses"][0])
    moved = drive_all(run, request)
    return {**response, "moved": moved, "steps": run.steps, "finite": run.finite}


@cache
def _genesis() -> Any:
    """Return the package, which can be started only once in a process."""
    genesis = import_module("genesis")
    genesis.init(backend=genesis.cpu, logging_level="warning")
    return genesis


class _Run:
    """An entity, posed and simulated."""

    def __init__(self, scene: Any, entity: Any) -> None:
        self.steps, self.finite = 0, True
        self._scene, self._entity = scene, entity
        scene.build()
        self._joints = {joint.name: joint for joint in entity.joints if joint.n_dofs == 1}
        self._degrees = {name: int(joint.dofs_idx_local[0]) for name, joint in self._joints.items()}
        self._start = _numbers(entity.get_dofs_position())

    def links(self, names: list[str]) -> dict[str, Any]:
        """Return the mass properties of links."""
        masses, found = _numbers(self._entity.get_links_mass()), {}
        for number, link in enumerate(self._entity.links):
            if link.name in names:
                read = link.desc
                w, x, y, z = np.asarray(read.inertial_quat, float)
                turn = posed([0.0, 0.0, 0.0, x, y, z, w])[:3, :3]
                found[link.name] = {
                    "mass": masses[number],
                    "center": read.inertial_pos,
                    "inertia": turn @ np.asarray(read.inertia, float) @ turn.T,
                }
        return found

    def joints(self, form: str) -> dict[str, Any]:
        """Return the joints that can move; URDF has no springs and armature."""
        entity = self._entity
        lows, highs = (_numbers(each) for each in entity.get_dofs_limit())
        values = {"damping": entity.get_dofs_damping(), "friction": entity.get_dofs_frictionloss()}
        if form == "mjcf":
            values |= {"stiffness": entity.get_dofs_stiffness(), "armature": entity.get_dofs_armature()}
        values = {name: _numbers(each) for name, each in values.items()}
        found = {}
        for name, degree in self._degrees.items():
            low, high = lows[degree], highs[degree]
            limited = np.isfinite([low, high]).all() and max(abs(low), abs(high)) < _UNLIMITED
            found[name] = {
                "kind": self._joints[name].type.name.lower(),
                "limits": [low, high] if limited else None,
                **{key: each[degree] for key, each in values.items()},
            }
        return found

    def couplings(self) -> dict[str, Any]:
        """Return the equalities between joints."""
        found = {}
        for equality in self._entity.equalities:
            read = equality.desc
            if read.type.name == "JOINT":
                follower, leader = read.objs_name
                found[follower] = [leader, float(read.data[1]), float(read.data[0])]
        return found

    def pose(self, pose: dict[str, float], links: list[str]) -> dict[str, Any]:
        """Return the frames of links at a pose."""
        self.start(pose)
        places, turns = _numbers(self._entity.get_links_pos()), _numbers(self._entity.get_links_quat())
        frames = {}
        for number, link in enumerate(self._entity.links):
            w, *xyz = turns[number]
            frames[link.name] = posed([*places[number], *xyz, w])
        return in_base(frames, links)

    def start(self, pose: dict[str, float]) -> None:
        """Put the joints to their positions."""
        positions = self._start.copy()
        for name, position in pose.items():
            if name in self._degrees:
                positions[self._degrees[name]] = position
        self._entity.set_dofs_position(positions.astype(np.float32), zero_velocity=True)

    def position(self, name: str) -> float:
        """Return the position of a joint [rad or m]."""
        return float(_numbers(self._entity.get_dofs_position())[self._degrees[name]])

    def push(self, forces: dict[str, float]) -> None:
        """Set the torques and forces of joints [N m or N]."""
        values = np.zeros(len(self._start), np.float32)
        for name, amount in forces.items():
            values[self._degrees[name]] = amount
        self._entity.control_dofs_force(values)

    def advance(self, seconds: float) -> None:
        """Simulate."""
        for _ in range(round(seconds / _STEP)):
            self._scene.step()
            self.steps += 1
        self.finite = self.finite and bool(np.isfinite(_numbers(self._entity.get_dofs_position())).all())


def _numbers(tensor: Any) -> Any:
    return np.asarray(tensor.cpu(), float)


if __name__ == "__main__":
    serve(read, "genesis", "torch")
