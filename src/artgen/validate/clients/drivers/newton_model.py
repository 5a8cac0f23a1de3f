"""Newton driver: reads a URDF, MJCF or USD and moves its joints in MuJoCo's solver on the CPU."""

import warnings
from dataclasses import dataclass
from typing import Any

import numpy as np
from driver_motion import Simulation, pose_and_drive
from driver_protocol import (
    UNLIMITED,
    couplings_to_heads,
    enabled,
    finite_limits,
    frame_of,
    mass_properties,
    require,
    serve,
)

require("newton", "mujoco", "pxr")
import warp

# one line per warning, without the source line
warnings.formatwarning = lambda message, category, *_: f"{category.__name__}: {message}\n"
warp.config.log_level = warp.LOG_WARNING  # official switch for its banner; warnings stay
import newton


def _read(request: dict[str, Any]) -> dict[str, Any]:
    model = _load(request).finalize(device="cpu")
    degrees = _degrees(model, request)
    simulation = _Simulation(model, degrees)
    masses = (values.numpy() for values in (model.body_mass, model.body_com, model.body_inertia))
    bodies = dict(zip(map(_last, model.body_label), zip(*masses, strict=True), strict=True))
    return {
        "links": {name: mass_properties(*bodies[name]) for name in request["links"] if name in bodies},
        "joints": _joints(model, request, degrees),
        "couplings": _couplings(model, degrees),
        **pose_and_drive(simulation, request),
    }


def _load(request: dict[str, Any]) -> Any:
    builder = newton.ModelBuilder()
    if request["format"] == "urdf":
        builder.add_urdf(request["file"], floating=request["base"] == "free")
    elif request["format"] == "mjcf":
        builder.add_mjcf(request["file"])
    else:
        with enabled(request, "Newton") as file:
            builder.add_usd(file)
    return builder


@dataclass(frozen=True)
class _Degree:
    """One degree of freedom."""

    kind: str  # `revolute` or `prismatic`
    place: int  # index among positions
    speed: int  # index among speeds
    start: float  # position of the joint where the model has 0, which an MJCF may choose [rad or m]


def _degrees(model: Any, request: dict[str, Any]) -> dict[str, _Degree]:
    """Return the degrees of freedom by the names of their joints."""
    # in an MJCF, several between two bodies are one joint with all names, slides before rotations
    kinds = {joint["name"]: joint["kind"] for joint in request["joints"]}
    dimensions = model.joint_dof_dim.numpy()
    places, speeds, types = (
        values.numpy() for values in (model.joint_q_start, model.joint_qd_start, model.joint_type)
    )
    known = {int(newton.JointType.REVOLUTE), int(newton.JointType.PRISMATIC), int(newton.JointType.D6)}
    in_tree = model.joint_articulation.numpy() >= 0  # the pin of a closed chain is not
    starts = model.mujoco.dof_ref.numpy() if hasattr(model.mujoco, "dof_ref") else None
    found = {}
    for number, label in enumerate(model.joint_label):
        slides, count = int(dimensions[number][0]), int(dimensions[number].sum())
        if int(types[number]) not in known or not count or not in_tree[number]:
            continue
        names = [_last(label)] if count == 1 else _split_names(_last(label), list(kinds))
        # the sort is stable: each kind keeps its order
        for index, name in enumerate(sorted(names, key=lambda each: kinds.get(each) == "revolute")):
            speed = int(speeds[number]) + index
            kind = "prismatic" if index < slides else "revolute"
            start = 0.0 if starts is None else float(starts[speed])
            found[name] = _Degree(kind, int(places[number]) + index, speed, start)
    return found


def _split_names(text: str, names: list[str]) -> list[str]:
    """Return the names that form a text with underscores; empty for other texts."""
    for name in names:
        if text == name:
            return [name]
        if text.startswith(f"{name}_") and (rest := _split_names(text[len(name) + 1 :], names)):
            return [name, *rest]
    return []


def _joints(model: Any, request: dict[str, Any], degrees: dict[str, _Degree]) -> dict[str, Any]:
    found = {name: _joint(model, degree, request["format"]) for name, degree in degrees.items()}
    for joint in request["joints"] if request["format"] == "usd" else ():
        low, high = joint["limits"] or (-np.inf, np.inf)
        if not low <= joint["rest"] <= high and joint["name"] in found:
            # Newton moves a drive's target beyond the limits to the center of the range, and has no other
            # spring in USD
            found[joint["name"]].pop("rest", None)
    return found


def _joint(model: Any, degree: _Degree, form: str) -> dict[str, Any]:
    """Return the values of one degree of freedom; URDF has no springs and armature."""

    def value(name: str) -> float:
        return float(getattr(model, name).numpy()[degree.speed])

    # a drive pulls to its target, a spring of the joint to its rest: a file has one of them
    driven, passive = value("joint_target_ke"), value("joint_stiffness")
    low, high = value("joint_limit_lower") + degree.start, value("joint_limit_upper") + degree.start
    result: dict[str, Any] = {
        "kind": degree.kind,
        "limits": finite_limits(low, high),
        "damping": value("joint_target_kd") + value("joint_damping"),
        "friction": value("joint_friction"),
    }
    if form != "urdf":
        result |= {"stiffness": driven + passive, "armature": value("joint_armature")}
        if driven or passive:
            rests = model.joint_target_q if driven else model.joint_rest_q
            result["rest"] = float(rests.numpy()[degree.place]) + degree.start
    bounds = {name: value(f"joint_{name}_limit") for name in ("effort", "velocity")}
    return result | {name: bound for name, bound in bounds.items() if bound < UNLIMITED}


def _couplings(model: Any, degrees: dict[str, _Degree]) -> dict[str, Any]:
    """Return couplings: those of joints, or equalities of MuJoCo, which Newton stores separately."""
    # an equality names a joint, and the degree of freedom if the joint has several
    names = {degree.speed: name for name, degree in degrees.items()}
    starts = model.joint_qd_start.numpy()
    mimics = zip(model.joint_mimic_joint.numpy(), model.joint_mimic_coeffs.numpy(), strict=True)
    laws = [((number, -1), (leader, -1), terms) for number, (leader, terms) in enumerate(mimics)]
    first, first_dof, second, second_dof, terms = (
        getattr(model.mujoco, f"equality_constraint_{name}").numpy()
        for name in ("joint1", "joint1_dof", "joint2", "joint2_dof", "polycoef")
    )
    laws += zip(zip(first, first_dof, strict=True), zip(second, second_dof, strict=True), terms, strict=True)
    found: dict[str, list[Any]] = {}
    for follower, leader, (offset, ratio, *_) in laws:
        if follower[0] >= 0 and leader[0] >= 0:
            name, head = (
                names[int(starts[joint] if degree < 0 else degree)] for joint, degree in (follower, leader)
            )
            shift = degrees[name].start - float(ratio) * degrees[head].start
            found[name] = [head, float(ratio), float(offset) + shift]
    return couplings_to_heads(found)


class _Simulation(Simulation):
    def __init__(self, model: Any, degrees: dict[str, _Degree]) -> None:
        places = {name: degree.place for name, degree in degrees.items()}
        super().__init__(places, {name: degree.speed for name, degree in degrees.items()})
        self.bodies = {_last(label): number for number, label in enumerate(model.body_label)}
        self._model, self._starts = model, {name: degree.start for name, degree in degrees.items()}
        self._solver = newton.solvers.SolverMuJoCo(model, use_mujoco_cpu=True)
        self._states = [model.state(), model.state()]
        self._control = model.control()

    def place(self, pose: dict[str, float]) -> None:
        state = self._states[0]
        q = state.joint_q.numpy()
        for name, position in pose.items():
            if name in self.places:
                q[self.places[name]] = position - self._starts[name]
        state.joint_q.assign(q)
        newton.eval_fk(self._model, state.joint_q, state.joint_qd, state)

    def frames(self) -> dict[str, Any]:
        poses = self._states[0].body_q.numpy()
        return {name: frame_of(poses[number]) for name, number in self.bodies.items()}

    def positions(self) -> Any:
        return self._states[0].joint_q.numpy()

    def position(self, name: str) -> float:
        return super().position(name) + self._starts[name]

    def push(self, forces: dict[str, float]) -> None:
        self._control.joint_f.assign(self.in_order(forces, 0.0 * self._control.joint_f.numpy()))

    def step(self, count: int) -> None:
        for _ in range(count):
            self._states[0].clear_forces()
            self._solver.step(self._states[0], self._states[1], self._control, None, self.time_step)
            self._states.reverse()


def _last(label: str) -> str:
    """Return the last part of a label, which is the name in the file."""
    return label.rsplit("/", 1)[-1]


if __name__ == "__main__":
    serve(_read)
