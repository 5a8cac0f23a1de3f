"""PhysX 5 driver, by ovphysx on the CPU: reads a USD and moves its joints."""

import warnings
from functools import cache
from typing import Any

import numpy as np
from driver_motion import drive_all, in_base, posed
from driver_protocol import serve
from usd_runtime import enabled

_STEP = 0.002  # [s]
_RETURN = 2.0  # time in which a spring has to return its joint [s]
_LOOK = 0.02  # interval between two checks during that time [s]
_RETURNED = 0.05  # tolerance of a spring's rest position, as a share of the range
_FOLLOWED = 0.01  # largest lag of a driven coupled joint, as a share of the range
_UNBOUNDED = 1e5  # larger limits, efforts and speeds count as none


def read(request: dict[str, Any]) -> dict[str, Any]:
    """Return the response to a request."""
    import ovphysx
    import ovstage

    physics = _physics()
    stage = ovstage.Stage(request["asset"])
    with enabled(request, "PhysX") as file:
        ovstage.population.open_usd(stage, file, ordinal=1, domains=ovstage.PopulationDomain.ALL)
        stage.advance_write_floor(ordinal=1).wait()
        physics.wait_task(physics.attach_ovstage(stage, read_ordinal=1))
    try:
        physics.warmup()
        physics.wait_all()
        return {"version": ovphysx.__version__, **_Articulation(physics, request).ask()}
    finally:
        physics.wait_task(physics.detach_ovstage())
        stage.destroy()


@cache
def _physics() -> Any:
    """Return the only instance of the process."""
    import ovphysx
    import ovstage
    from ovphysx.samples.python_samples.schema_support import physx_schema_paths

    ovphysx.PhysX.set_cpu_mode(True)
    schemas = [*physx_schema_paths(), ovphysx.newton_schema_root()]
    ovstage.population.register_usd_schemas([str(path) for path in schemas])
    return ovphysx.PhysX()


class _Articulation:
    """The articulation of one asset, posed and simulated."""

    def __init__(self, physics: Any, request: dict[str, Any]) -> None:
        self.steps, self.finite = 0, True
        self._physics, self._request = physics, request
        self._bindings: dict[str, Any] = {}
        self._track: list[Any] = []
        position = self._binding("DOF_POSITION")
        if position.count != 1:
            raise RuntimeError(f"PhysX finds {position.count} articulations in the file, not one")
        if position.is_fixed_base != (request["base"] == "fixed"):
            raise RuntimeError(f"PhysX takes the base for {'fixed' if position.is_fixed_base else 'free'}")
        self._joints = {name: number for number, name in enumerate(position.dof_names)}
        self._bodies = {name: number for number, name in enumerate(position.body_names)}

    def ask(self) -> dict[str, Any]:
        """Read everything, pose it, then simulate it."""
        start = self._read("DOF_POSITION")
        answer = {
            "links": self._links(),
            "joints": self._told(),
            "poses": [self._pose(pose) for pose in self._request["poses"]],
        }
        self._place(start)
        if self._request["base"] == "free":  # while driven it would fall, beyond single precision
            self._make_weightless()
        moved = drive_all(self, self._request)
        said = [*self._astray(), *self._left(start)]
        for binding in self._bindings.values():
            binding.destroy()
        return {**answer, "moved": moved, "steps": self.steps, "finite": self.finite, "said": said}

    def _binding(self, quantity: str) -> Any:
        if quantity not in self._bindings:
            from ovphysx.types import TensorType

            self._bindings[quantity] = self._physics.create_tensor_binding(
                pattern="/**", tensor_type=TensorType[f"ARTICULATION_{quantity}"]
            )
        return self._bindings[quantity]

    def _read(self, quantity: str) -> Any:
        binding = self._binding(quantity)
        values = np.zeros(binding.shape, np.float32)
        binding.read(values)
        return values[0].astype(float)

    def _write(self, quantity: str, values: Any) -> None:
        self._binding(quantity).write(np.ascontiguousarray(values[None], np.float32))

    def _links(self) -> dict[str, Any]:
        masses, poses, inertias = (
            self._read(f"BODY_{quantity}") for quantity in ("MASS", "COM_POSE", "INERTIA")
        )
        return {
            name: {
                "mass": masses[number],
                "center": poses[number, :3],
                "inertia": inertias[number].reshape(3, 3),
            }
            for name, number in self._bodies.items()
            if name in self._request["links"]
        }

    def _told(self) -> dict[str, Any]:
        limits, target = self._read("DOF_LIMIT"), self._read("DOF_POSITION_TARGET")
        values = {
            "stiffness": self._read("DOF_STIFFNESS"),
            "damping": self._read("DOF_DAMPING"),
            "friction": self._read("DOF_FRICTION_PROPERTIES")[:, 0],
            "armature": self._read("DOF_ARMATURE"),
            "effort": self._read("DOF_MAX_FORCE"),
            "velocity": self._read("DOF_MAX_VELOCITY"),
        }
        found: dict[str, Any] = {}
        for name, number in self._joints.items():
            bounded = bool(np.abs(limits[number]).max() < _UNBOUNDED)
            # PhysX does not tell the kind of a joint: a wrong one shows in the poses
            found[name] = {"limits": limits[number] if bounded else None}
            found[name] |= {key: each[number] for key, each in values.items() if each[number] < _UNBOUNDED}
            if found[name]["stiffness"]:
                found[name]["rest"] = target[number]
        return found

    def _place(self, positions: Any) -> None:
        self._write("DOF_POSITION", positions)
        self._write("DOF_VELOCITY", 0.0 * positions)
        self._physics.update_articulations_kinematic()

    def _pose(self, pose: dict[str, float]) -> dict[str, Any]:
        self._place(self._by_joint(pose))
        placed = self._read("LINK_POSE")
        frames = {name: posed(placed[number]) for name, number in self._bodies.items()}
        return in_base(frames, self._request["links"])

    def _by_joint(self, values: dict[str, float]) -> Any:
        """Return values in the order of PhysX, which is breadth first."""
        return np.array([values.get(name, 0.0) for name in self._joints])

    def position(self, name: str) -> float:
        """Return the position of a joint [rad or m]."""
        return float(self._read("DOF_POSITION")[self._joints[name]])

    def push(self, forces: dict[str, float]) -> None:
        """Set the torques and forces of joints [N m or N]."""
        self._write("DOF_ACTUATION_FORCE", self._by_joint(forces))

    def advance(self, seconds: float) -> None:
        """Simulate."""
        for _ in range(round(seconds / _STEP)):
            self._physics.step_sync(_STEP)
            self.steps += 1
        self.finite = self.finite and bool(np.isfinite(self._read("LINK_POSE")).all())
        self._track.append(self._read("DOF_POSITION"))

    def _astray(self) -> list[str]:
        """Return coupled joints that left their leaders: PhysX does not tell its couplings."""
        track = np.array(self._track)
        said = []
        for joint in self._request["joints"]:
            name, leader = joint["name"], joint["follows"]
            if leader not in self._joints or name not in self._joints:
                continue
            poses = self._request["poses"]
            ratio, offset = np.polyfit([q[leader] for q in poses], [q[name] for q in poses], 1)
            wanted = ratio * track[:, self._joints[leader]] + offset
            error = float(np.abs(track[:, self._joints[name]] - wanted).max())
            span = max(1e-9, float(np.ptp([q[name] for q in poses])))
            if not error <= _FOLLOWED * span:
                said.append(f"{name} does not follow {leader}: it is off by {error:.4g}")
        return said

    def _put_back(self, start: Any) -> None:
        """Reset blocked joints without springs: a lifted bucket keeps its lid from falling."""
        positions = self._read("DOF_POSITION")
        for joint in self._request["joints"]:
            if joint["blocked"] and not joint["stiffness"] and joint["name"] in self._joints:
                number = self._joints[joint["name"]]
                positions[number] = start[number]
        self._place(positions)

    def _make_weightless(self) -> None:
        weightless = self._binding("BODY_DISABLE_GRAVITY")
        weightless.write(np.ones(weightless.shape, np.uint8))

    def _left(self, start: Any) -> list[str]:
        """Return springs that do not return their joints although they exceed friction."""
        self._make_weightless()
        self._put_back(start)
        seen = len(self._track)
        for _ in range(round(_RETURN / _LOOK)):
            self.advance(_LOOK)
        track = np.array(self._track[seen:])
        said = []
        for joint in self._request["joints"]:
            limits, name = joint["limits"], joint["name"]
            if not joint["stiffness"] or limits is None or name not in self._joints:
                continue
            rest, span = min(max(joint["rest"], limits[0]), limits[1]), limits[1] - limits[0]
            pull = joint["stiffness"] * (abs(joint["rest"] - rest) + _RETURNED * span)
            # without damping it oscillates forever
            away = float(np.abs(track[:, self._joints[name]] - rest).min())
            if pull > 2.0 * joint["friction"] and not away <= _RETURNED * span:
                said.append(f"the spring of {name} leaves it {away:.4g} away from where it should rest")
        return said


if __name__ == "__main__":
    # the bindings are deprecated in favor of sessions, which do not tell gains: this message is not about the
    # file
    warnings.filterwarnings("ignore", message=".*tensor bindings are deprecated", category=DeprecationWarning)
    serve(read, "ovphysx", "physx_usd_schemas", "newton_usd_schemas")
