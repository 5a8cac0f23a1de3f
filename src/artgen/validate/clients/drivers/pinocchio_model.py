"""Pinocchio driver: reads a URDF, and its meshes with coal."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from driver_protocol import mass_properties, require, serve, transform

require("pinocchio")
import pinocchio


def _read(request: dict[str, Any]) -> dict[str, Any]:
    path = request["file"]
    # a joint with six degrees of freedom at the base separates its mass from the world's
    model = pinocchio.buildModelFromUrdf(path, pinocchio.JointModelFreeFlyer())
    meshes = [
        pinocchio.buildGeomFromUrdf(model, path, kind, package_dirs=[str(Path(path).parent)])
        for kind in (pinocchio.GeometryType.COLLISION, pinocchio.GeometryType.VISUAL)
    ]
    note = f"{meshes[0].ngeoms} colliders, {meshes[1].ngeoms} visuals"
    coupled, why_not = _coupled(path)
    moving = {model.names[number]: model.joints[number] for number in range(2, model.njoints)}
    return {
        "links": dict(_links(model, request["links"])),
        "joints": {name: _joint(model, joint) for name, joint in moving.items()},
        "poses": _poses(coupled or model, request),
        "note": note + why_not,
    }


def _coupled(path: str) -> tuple[Any, str]:
    """Return a model with couplings, or the reason why there is none."""
    try:
        return pinocchio.buildModelFromUrdf(path, pinocchio.JointModelFreeFlyer(), mimic=True), ""
    except ValueError as error:
        # joints are added in the order of their names, and leaders have to come first
        if "mimic joint is not in the kinematic tree" not in str(error):
            raise
        return None, "; it cannot couple a joint to one of a later name"


def _links(model: Any, names: list[str]) -> Iterator[tuple[str, dict[str, Any]]]:
    """Yield the links that pinocchio keeps separate: those without a fixed joint to another link."""
    fused = pinocchio.FrameType.FIXED_JOINT
    for name in names:
        frame = model.frames[model.getFrameId(name, pinocchio.FrameType.BODY)]
        if model.frames[frame.parentFrame].type == fused:
            continue
        own = model.inertias[frame.parentJoint]
        for other in model.frames:
            if other.type == fused and other.parentJoint == frame.parentJoint:
                own = own - other.placement.act(other.inertia)
        yield name, mass_properties(own.mass, own.lever, own.inertia)


def _joint(model: Any, joint: Any) -> dict[str, Any]:
    unlimited = joint.nq == 2  # cosine and sine
    place, degree = joint.idx_q, joint.idx_v
    return {
        "kind": "prismatic" if "P" in joint.shortname().removeprefix("JointModel") else "revolute",
        "limits": None if unlimited else [model.lowerPositionLimit[place], model.upperPositionLimit[place]],
        "damping": model.damping[degree],
        "friction": model.friction[degree],
    }


def _poses(model: Any, request: dict[str, Any]) -> list[dict[str, Any]]:
    frames = {name: model.getFrameId(name, pinocchio.FrameType.BODY) for name in request["links"]}
    data = model.createData()
    result = []
    for q in request["poses"]:
        configuration = pinocchio.neutral(model)
        for number in range(2, model.njoints):  # after the world and the base
            joint, position = model.joints[number], q[model.names[number]]
            turned = [[], [position], [np.cos(position), np.sin(position)]][joint.nq]
            configuration[joint.idx_q : joint.idx_q + joint.nq] = turned
        pinocchio.framesForwardKinematics(model, data, configuration)
        base = data.oMf[frames[request["links"][0]]].inverse()
        found = {name: base * data.oMf[frame] for name, frame in frames.items()}
        result.append({name: transform(each.rotation, each.translation) for name, each in found.items()})
    return result


if __name__ == "__main__":
    serve(_read)
