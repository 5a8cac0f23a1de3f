"""Newton driver: reads a URDF, MJCF or USD and moves its joints in MuJoCo's solver on the CPU."""

import math
import warnings
from dataclasses import dataclass
from typing import Any

import numpy as np
from driver_motion import drive_all, in_base, posed
from driver_protocol import serve
from usd_runtime import enabled

_STEP = 0.002  # [s]
_UNLIMITED = 1e5  # larger limits, efforts and speeds count as none


def read(request: dict[str, Any]) -> dict[str, Any]:
    """Return the response to a request."""
    import warp

    # its own switch for its banner; warnings stay
    warp.config.log_level = warp.LOG_WARNING
    import newton

    model = _load(newton, request).finalize(device="cpu")
    run = _Run(newton, model, request)
    return {
        "version": newton.__version__,
        "links": _links(model, request, run.bodies),
        "joints": _joints(model, request, run.degrees),
        "couplings": _couplings(model, run.degrees),
        "poses": [run.pose(pose, request["links"]) for pose in request["poses"]],
        "moved": drive_all(run, request),
        "steps": run.steps,
        "finite": run.finite,
    }


def _load(newton: Any, request: dict[str, Any]) -> Any:
    builder = newton.ModelBuilder()
    if request["format"] == "urdf":
        builder.add_urdf(request["file"], floating=request["base"] == "free")
    elif request["format"] == "mjcf":
        builder.add_mjcf(request["file"])
    else:
        with enabled(request, "Newton") as file:
            builder.add_usd(file)
    return builder


def _links(model: Any, request: dict[str, Any], bodies: dict[str, int]) -> dict[str, Any]:
    masses, centers, inertias = (
        values.numpy() for values in (model.body_mass, model.body_com, model.body_inertia)
    )
    return {
        name: {
            "mass": masses[bodies[name]],
            "center": centers[bodies[name]],
            "inertia": inertias[bodies[name]],
        }
        for name in request["links"]
        if name in bodies
    }


def _joints(model: Any, request: dict[str, Any], degrees: dict[str, "_Degree"]) -> dict[str, Any]:
    springs = {joint["name"]: joint for joint in request["joints"]}
    found = {}
    for name, degree in degrees.items():
        found[name] = _joint(model, degree, request["format"])
        if "rest" in found[name] and _beyond(springs.get(name)) and request["format"] == "usd":
            # Newton moves a drive's target beyond the limits to the center of the range, and has no other
            # spring in USD
            del found[name]["rest"]
    return found


def _beyond(joint: dict[str, Any] | None) -> bool:
    """Tell whether the rest position of a joint's spring is outside its limits."""
    if joint is None or joint["limits"] is None:
        return False
    low, high = joint["limits"]
    return not low <= joint["rest"] <= high


@dataclass(frozen=True)
class _Degree:
    """One degree of freedom."""

    kind: str  # `revolute` or `prismatic`
    place: int  # index among positions
    speed: int  # index among speeds
    start: float  # position of the joint where the model has 0, which an MJCF may choose [rad or m]


def _degrees(newton: Any, model: Any, request: dict[str, Any]) -> dict[str, _Degree]:
    """Return the degrees of freedom by the names of their joints.

    In an MJCF, Newton makes one joint of several between two bodies: it has all their names, and its slides
    come before its rotations.
    """
    kinds = {joint["name"]: joint["kind"] for joint in request["joints"]}
    dimensions = model.joint_dof_dim.numpy()
    places, speeds, types = (
        values.numpy() for values in (model.joint_q_start, model.joint_qd_start, model.joint_type)
    )
    known = {int(newton.JointType.REVOLUTE), int(newton.JointType.PRISMATIC), int(newton.JointType.D6)}
    starts = model.mujoco.dof_ref.numpy() if hasattr(model.mujoco, "dof_ref") else None
    found = {}
    for number, label in enumerate(model.joint_label):
        slides, count = int(dimensions[number][0]), int(dimensions[number].sum())
        if int(types[number]) not in known or not count:
            continue
        names = [_last(label)] if count == 1 else _parts(_last(label), list(kinds))
        # the sort is stable: each kind keeps its order
        for index, name in enumerate(sorted(names, key=lambda each: kinds.get(each) == "revolute")):
            speed = int(speeds[number]) + index
            kind = "prismatic" if index < slides else "revolute"
            start = 0.0 if starts is None else float(starts[speed])
            found[name] = _Degree(kind, int(places[number]) + index, speed, start)
    return found


def _parts(text: str, names: list[str]) -> list[str]:
    """Return the names that form a text with underscores; empty for other texts."""
    for name in names:
        if text == name:
            return [name]
        if text.startswith(f"{name}_") and (rest := _parts(text[len(name) + 1 :], names)):
            return [name, *rest]
    return []


def _joint(model: Any, degree: _Degree, form: str) -> dict[str, Any]:
    """Return the values of one degree of freedom; URDF has no springs and armature."""

    def value(name: str) -> float:
        return float(getattr(model, name).numpy()[degree.speed])

    low, high = value("joint_limit_lower"), value("joint_limit_upper")
    limited = math.isfinite(low) and math.isfinite(high) and max(abs(low), abs(high)) < _UNLIMITED
    # a drive pulls to its target, a spring of the joint to its rest: a file has one of them
    driven, passive = value("joint_target_ke"), value("joint_stiffness")
    result: dict[str, Any] = {
        "kind": degree.kind,
        "limits": [low + degree.start, high + degree.start] if limited else None,
        "damping": value("joint_target_kd") + value("joint_damping"),
        "friction": value("joint_friction"),
    }
    if form != "urdf":
        result |= {"stiffness": driven + passive, "armature": value("joint_armature")}
        if driven or passive:
            rests = model.joint_target_q if driven else model.joint_rest_q
            result["rest"] = float(rests.numpy()[degree.place]) + degree.start
    for name in ("effort", "velocity"):
        bound = value(f"joint_{name}_limit")
        if bound < _UNLIMITED:
            result[name] = bound
    return result


def _couplings(model: Any, degrees: dict[str, _Degree]) -> dict[str, Any]:
    """Return couplings: those of joints, or equalities of MuJoCo, which Newton stores separately."""
    names = [_last(label) for label in model.joint_label]
    laws = [
        (number, int(leader), *coefficients)
        for number, (leader, coefficients) in enumerate(
            zip(model.joint_mimic_joint.numpy(), model.joint_mimic_coeffs.numpy(), strict=True)
        )
    ]
    equalities = model.mujoco
    followers, leaders = (getattr(equalities, f"equality_constraint_joint{side}").numpy() for side in (1, 2))
    for follower, leader, terms in zip(
        followers, leaders, equalities.equality_constraint_polycoef.numpy(), strict=True
    ):
        laws.append((int(follower), int(leader), *terms[:2]))
    found: dict[str, list[Any]] = {}
    for follower, leader, offset, ratio in laws:
        if follower >= 0 and leader >= 0:
            name, head = names[follower], names[leader]
            shift = degrees[name].start - float(ratio) * degrees[head].start
            found[name] = [head, float(ratio), float(offset) + shift]
    return {name: _to_head(found, name) for name in found}


def _to_head(found: dict[str, list[Any]], name: str) -> list[Any]:
    """Return the coupling of a joint to the free joint at the head of its chain of leaders."""
    leader, ratio, offset = found[name]
    if leader not in found:
        return [leader, ratio, offset]
    head, above, shift = _to_head(found, leader)
    return [head, ratio * above, ratio * shift + offset]


class _Run:
    """A model, posed and simulated."""

    def __init__(self, newton: Any, model: Any, request: dict[str, Any]) -> None:
        self.steps, self.finite = 0, True
        self.degrees = _degrees(newton, model, request)
        self.bodies = {_last(label): number for number, label in enumerate(model.body_label)}
        self._newton, self._model = newton, model
        self._solver = newton.solvers.SolverMuJoCo(model, use_mujoco_cpu=True)
        self._states = [model.state(), model.state()]
        self._control = model.control()
        self._place(self._states[0], request["poses"][0])

    def pose(self, pose: dict[str, float], links: list[str]) -> dict[str, Any]:
        """Return the frames of links at a pose."""
        state = self._model.state()
        self._place(state, pose)
        placed = state.body_q.numpy()
        return in_base({name: posed(placed[number]) for name, number in self.bodies.items()}, links)

    def _place(self, state: Any, pose: dict[str, float]) -> None:
        q = state.joint_q.numpy()
        for name, position in pose.items():
            if name in self.degrees:
                q[self.degrees[name].place] = position - self.degrees[name].start
        state.joint_q.assign(q)
        self._newton.eval_fk(self._model, state.joint_q, state.joint_qd, state)

    def position(self, name: str) -> float:
        """Return the position of a joint [rad or m]."""
        degree = self.degrees[name]
        return float(self._states[0].joint_q.numpy()[degree.place]) + degree.start

    def push(self, forces: dict[str, float]) -> None:
        """Set the torques and forces of joints [N m or N]."""
        values = self._control.joint_f.numpy()
        values[:] = 0.0
        for name, amount in forces.items():
            values[self.degrees[name].speed] = amount
        self._control.joint_f.assign(values)

    def advance(self, seconds: float) -> None:
        """Simulate."""
        for _ in range(round(seconds / _STEP)):
            self._states[0].clear_forces()
            self._solver.step(self._states[0], self._states[1], self._control, None, _STEP)
            self._states.reverse()
            self.steps += 1
        self.finite = self.finite and bool(np.isfinite(self._states[0].joint_q.numpy()).all())


def _last(label: str) -> str:
    """Return the last part of a label, which is the name in the file."""
    return label.rsplit("/", 1)[-1]


if __name__ == "__main__":
    # one line per warning, without the source line
    warnings.formatwarning = lambda message, category, *_: f"{category.__name__}: {message}\n"
    serve(read, "newton", "mujoco", "pxr")
