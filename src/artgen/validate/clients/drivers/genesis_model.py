"""Genesis driver: reads a URDF or MJCF and moves its joints on the CPU."""

from functools import cache
from importlib import import_module
from typing import Any

import numpy as np
from driver_motion import Simulation, pose_and_drive
from driver_protocol import finite_limits, frame_of, mass_properties, require, serve

require("genesis", "torch")


def _read(request: dict[str, Any]) -> dict[str, Any]:
    genesis = _genesis()
    options = genesis.options.SimOptions(dt=Simulation.time_step)
    scene = genesis.Scene(show_viewer=False, sim_options=options)
    # without these options, Genesis invents missing values and merges links of fixed joints
    options = {"file": request["file"], "default_armature": 0.0, "align": False}
    if request["format"] == "urdf":
        fixed = request["base"] == "fixed"
        morph = genesis.morphs.URDF(**options, fixed=fixed, merge_fixed_links=False)
    else:
        morph = genesis.morphs.MJCF(**options)
    entity = scene.add_entity(morph)
    scene.build()
    simulation = _Simulation(scene, entity)
    return {
        "links": _links(entity, request["links"]),
        "joints": simulation.joints(request["format"]),
        "couplings": _couplings(entity),
        **pose_and_drive(simulation, request),
    }


@cache
def _genesis() -> Any:
    """Return the package, which can be started only once in a process."""
    genesis = import_module("genesis")
    genesis.init(backend=genesis.cpu, logging_level="warning")
    return genesis


def _links(entity: Any, names: list[str]) -> dict[str, Any]:
    masses, found = _numbers(entity.get_links_mass()), {}
    for number, link in enumerate(entity.links):
        if link.name in names:
            read = link.desc
            w, x, y, z = np.asarray(read.inertial_quat, float)
            turn = frame_of([0.0, 0.0, 0.0, x, y, z, w])[:3, :3]
            found[link.name] = mass_properties(masses[number], read.inertial_pos, read.inertia, turn)
    return found


def _couplings(entity: Any) -> dict[str, Any]:
    found = {}
    for equality in entity.equalities:
        read = equality.desc
        if read.type.name == "JOINT":
            follower, leader = read.objs_name
            found[follower] = [leader, float(read.data[1]), float(read.data[0])]
    return found


class _Simulation(Simulation):
    def __init__(self, scene: Any, entity: Any) -> None:
        self._scene, self._entity = scene, entity
        self._joints = {joint.name: joint for joint in entity.joints if joint.n_dofs == 1}
        degrees = {name: int(joint.dofs_idx_local[0]) for name, joint in self._joints.items()}
        super().__init__(degrees, degrees)
        self._start = self.positions()

    def joints(self, form: str) -> dict[str, Any]:
        """Return the joints that can move; URDF has no springs and armature."""
        entity = self._entity
        lows, highs = (_numbers(each) for each in entity.get_dofs_limit())
        values = {"damping": entity.get_dofs_damping(), "friction": entity.get_dofs_frictionloss()}
        if form == "mjcf":
            values |= {"stiffness": entity.get_dofs_stiffness(), "armature": entity.get_dofs_armature()}
        values = {name: _numbers(each) for name, each in values.items()}
        return {
            name: {
                "kind": self._joints[name].type.name.lower(),
                "limits": finite_limits(lows[degree], highs[degree]),
                **{key: each[degree] for key, each in values.items()},
            }
            for name, degree in self.degrees.items()
        }

    def place(self, pose: dict[str, float]) -> None:
        positions = self.in_order(pose, self._start.copy())
        self._entity.set_dofs_position(positions.astype(np.float32), zero_velocity=True)

    def frames(self) -> dict[str, Any]:
        places, turns = _numbers(self._entity.get_links_pos()), _numbers(self._entity.get_links_quat())
        found = {}
        for number, link in enumerate(self._entity.links):
            w, *xyz = turns[number]
            found[link.name] = frame_of([*places[number], *xyz, w])
        return found

    def positions(self) -> Any:
        return _numbers(self._entity.get_dofs_position())

    def push(self, forces: dict[str, float]) -> None:
        self._entity.control_dofs_force(self.in_order(forces, np.zeros(len(self._start), np.float32)))

    def step(self, count: int) -> None:
        for _ in range(count):
            self._scene.step()


def _numbers(tensor: Any) -> Any:
    return np.asarray(tensor.cpu(), float)


if __name__ == "__main__":
    serve(_read)
