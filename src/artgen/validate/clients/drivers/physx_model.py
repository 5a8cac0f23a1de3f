"""PhysX 5 driver, by ovphysx on the CPU: reads a USD and moves its joints."""

import warnings
from functools import cache
from typing import Any

import numpy as np
from driver_motion import Simulation, drive_all, lags
from driver_protocol import UNLIMITED, enabled, finite_limits, frame_of, mass_properties, require, serve

require("ovphysx", "physx_usd_schemas", "newton_usd_schemas")
import ovphysx
import ovstage
from ovphysx.samples.python_samples.schema_support import physx_schema_paths
from ovphysx.types import GlobalConfigKey, TensorType

_RETURN = 2.0  # time in which a spring has to return its joint [s]
_LOOK = 0.02  # interval between two checks during that time [s]
_RETURNED = 0.05  # tolerance of a spring's rest position, as a share of the range


def _read(request: dict[str, Any]) -> dict[str, Any]:
    physics = _physics()
    stage = ovstage.Stage(request["asset"])
    with enabled(request, "PhysX") as file:
        ovstage.population.open_usd(stage, file, ordinal=1, domains=ovstage.PopulationDomain.ALL)
        stage.advance_write_floor(ordinal=1).wait()
        physics.wait_task(physics.attach_ovstage(stage, read_ordinal=1))
    try:
        physics.warmup()
        physics.wait_all()
        return _Simulation(physics, request).answer()
    finally:
        physics.wait_task(physics.detach_ovstage())
        stage.destroy()


@cache
def _physics() -> Any:
    """Return the only instance of the process."""
    ovphysx.PhysX.set_cpu_mode(True)
    ovphysx.set_global_config(GlobalConfigKey.NUM_THREADS, 0)  # one asset is too small for several threads
    schemas = [*physx_schema_paths(), ovphysx.newton_schema_root()]
    ovstage.population.register_usd_schemas([str(path) for path in schemas])
    return ovphysx.PhysX()


class _Simulation(Simulation):
    """The articulation of one asset, posed and simulated; in a room also those of its free bodies."""

    def __init__(self, physics: Any, request: dict[str, Any]) -> None:
        self._physics, self._request = physics, request
        self._bindings: dict[str, list[Any]] = {}
        self._track: list[Any] = []
        free = set(request["free_links"])
        everything = self._bound("/**", "ARTICULATION_DOF_POSITION")
        # bodies come breadth first; those of the asset itself are the first ones
        self._paths = sorted(everything.prim_paths, key=lambda path: path.rpartition("/")[2] in free)
        everything.destroy()
        found = self._binding("DOF_POSITION")
        count = sum(not free.intersection(each.body_names) for each in found)
        if count != 1:
            raise RuntimeError(f"PhysX finds {count} articulations in the file, not one")
        fixed = [each.is_fixed_base for each in found]
        if fixed[0] != (request["base"] == "fixed") or any(fixed[1:]):
            raise RuntimeError(f"PhysX reads the bases as {['fixed' if each else 'free' for each in fixed]}")
        degrees = {name: number for number, name in enumerate(n for each in found for n in each.dof_names)}
        super().__init__(degrees, degrees)
        self._bodies = {
            name: number for number, name in enumerate(n for each in found for n in each.body_names)
        }
        self._single = {
            name: self._bound(f"/**/{name}", "RIGID_BODY_POSE") for name in free - set(self._bodies)
        }

    def answer(self) -> dict[str, Any]:
        """Read everything, pose it, then simulate it."""
        start = self.positions()
        answer = {"links": self._links(), "joints": self._joints(), "poses": self.poses(self._request)}
        self._put(start)
        if self._request["base"] == "free":  # while driven it would fall, beyond single precision
            self._make_weightless()
        motion = drive_all(self, self._request)
        said = motion.pop("said", [])
        track = np.array(self._track)  # PhysX does not report its couplings
        said += lags(self._request, {name: track[:, number] for name, number in self.degrees.items()})
        said += [] if self._request["rest"] else self._unreturned(start)
        for binding in [*(each for row in self._bindings.values() for each in row), *self._single.values()]:
            binding.destroy()
        return {**answer, **motion, "steps": self.steps, "finite": self.finite, "said": said}

    def _bound(self, pattern: str, quantity: str) -> Any:
        return self._physics.create_tensor_binding(pattern=pattern, tensor_type=TensorType[quantity])

    def _binding(self, quantity: str) -> list[Any]:
        """Return the bindings of a quantity, one for each articulation."""
        if quantity not in self._bindings:
            self._bindings[quantity] = [self._bound(path, f"ARTICULATION_{quantity}") for path in self._paths]
        return self._bindings[quantity]

    def _read(self, quantity: str) -> Any:
        return np.concatenate([_values(binding)[0] for binding in self._binding(quantity)])

    def _write(self, quantity: str, values: Any) -> None:
        at = 0
        for binding in self._binding(quantity):
            some = values[at : at + binding.shape[1]]
            binding.write(np.ascontiguousarray(some[None], np.float32))
            at += binding.shape[1]

    def _links(self) -> dict[str, Any]:
        values = (self._read(f"BODY_{name}") for name in ("MASS", "COM_POSE", "INERTIA"))
        found = list(zip(self._bodies, *values, strict=True))
        for name in self._single:
            single = [
                self._bound(f"/**/{name}", f"RIGID_BODY_{each}") for each in ("MASS", "COM_POSE", "INERTIA")
            ]
            found.append((name, *(_values(binding)[0] for binding in single)))
            for binding in single:
                binding.destroy()
        return {
            name: mass_properties(mass, pose[:3], inertia.reshape(3, 3))
            for name, mass, pose, inertia in found
            if name in self._request["links"]
        }

    def _joints(self) -> dict[str, Any]:
        ranges, target = self._read("DOF_LIMIT"), self._read("DOF_POSITION_TARGET")
        values = {
            "stiffness": self._read("DOF_STIFFNESS"),
            "damping": self._read("DOF_DAMPING"),
            "friction": self._read("DOF_FRICTION_PROPERTIES")[:, 0],
            "armature": self._read("DOF_ARMATURE"),
            "effort": self._read("DOF_MAX_FORCE"),
            "velocity": self._read("DOF_MAX_VELOCITY"),
        }
        found: dict[str, Any] = {}
        for name, number in self.degrees.items():
            # PhysX does not report the kind of a joint: a wrong one shows in the poses
            found[name] = {"limits": finite_limits(*ranges[number])}
            found[name] |= {key: each[number] for key, each in values.items() if each[number] < UNLIMITED}
            if found[name]["stiffness"]:
                found[name]["rest"] = target[number]
            elif not found[name]["damping"]:
                found[name].pop("effort", None)  # without a drive, it is 0
        return found

    def _put(self, positions: Any) -> None:
        self._write("DOF_POSITION", positions)
        self._write("DOF_VELOCITY", 0.0 * positions)
        self._physics.update_articulations_kinematic()

    def place(self, pose: dict[str, float]) -> None:
        self._put(self.in_order(pose, np.zeros(len(self.degrees))))

    def frames(self) -> dict[str, Any]:
        poses = self._read("LINK_POSE")
        singles = {name: _values(binding)[0] for name, binding in self._single.items()}
        bodies = {name: poses[number] for name, number in self._bodies.items()}
        return {name: frame_of(pose) for name, pose in (bodies | singles).items()}

    def positions(self) -> Any:
        return self._read("DOF_POSITION")

    def push(self, forces: dict[str, float]) -> None:
        self._write("DOF_ACTUATION_FORCE", self.in_order(forces, np.zeros(len(self.degrees))))

    def step(self, count: int) -> None:
        for _ in range(count):
            self._physics.step_sync(self.time_step)

    def advance(self, seconds: float) -> None:
        super().advance(seconds)
        if not np.isfinite(self._read("LINK_POSE")).all():
            self.finite = False
        self._track.append(self.positions())

    def _make_weightless(self) -> None:
        for weightless in self._binding("BODY_DISABLE_GRAVITY"):
            weightless.write(np.ones(weightless.shape, np.uint8))

    def _unreturned(self, start: Any) -> list[str]:
        """Return springs that do not return their joints although they exceed friction."""
        self._make_weightless()
        # reset blocked joints without springs: a lifted bucket keeps its lid from falling
        names = [
            each["name"] for each in self._request["joints"] if each["blocked"] and not each["stiffness"]
        ]
        at_start = {name: start[self.degrees[name]] for name in names if name in self.degrees}
        self._put(self.in_order(at_start, self.positions()))
        seen = len(self._track)
        for _ in range(round(_RETURN / _LOOK)):
            self.advance(_LOOK)
        track = np.array(self._track[seen:])
        said = []
        for joint in self._request["joints"]:
            limits, name = joint["limits"], joint["name"]
            if not joint["stiffness"] or limits is None or name not in self.degrees:
                continue
            rest, span = min(max(joint["rest"], limits[0]), limits[1]), limits[1] - limits[0]
            pull = joint["stiffness"] * (abs(joint["rest"] - rest) + _RETURNED * span)
            # without damping it oscillates forever
            away = float(np.abs(track[:, self.degrees[name]] - rest).min())
            if pull > 2.0 * joint["friction"] and not away <= _RETURNED * span:
                said.append(f"the spring of {name} leaves it {away:.4g} away from its rest position")
        return said


def _values(binding: Any) -> Any:
    """Return the values of a binding; the first axis is that of its prims."""
    values = np.zeros(binding.shape, np.float32)
    binding.read(values)
    return values.astype(float)


if __name__ == "__main__":
    # the bindings are deprecated in favor of sessions, which do not report gains
    warnings.filterwarnings("ignore", message=".*tensor bindings are deprecated", category=DeprecationWarning)
    serve(_read)
