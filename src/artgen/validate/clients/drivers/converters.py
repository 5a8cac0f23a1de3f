"""Driver of the converters of the Newton project: the USD that they make of an MJCF or a URDF."""

import tempfile
from importlib import import_module
from typing import Any

import numpy as np
from driver_protocol import finite_limits, frame_of, in_base, mass_properties, require, serve

require("mujoco_usd_converter", "urdf_usd_converter")
import usdex.core
from pxr import Usd, UsdPhysics


def _read(request: dict[str, Any]) -> dict[str, Any]:
    usdex.core.activateDiagnosticsDelegate()
    usdex.core.setDiagnosticsLevel(usdex.core.DiagnosticsLevel.eWarning)  # its progress is no message
    with tempfile.TemporaryDirectory() as directory:
        path = import_module(request["client"]).Converter().convert(request["file"], directory)
        return _read_stage(Usd.Stage.Open(path.path), request)


def _read_stage(stage: Any, request: dict[str, Any]) -> dict[str, Any]:
    prims = list(stage.Traverse())
    bodies = {prim.GetName(): prim for prim in prims if prim.HasAPI(UsdPhysics.RigidBodyAPI)}
    joints = {
        prim.GetName(): prim
        for prim in prims
        if prim.IsA(UsdPhysics.RevoluteJoint) or prim.IsA(UsdPhysics.PrismaticJoint)
    }
    tree = [prim for prim in prims if prim.IsA(UsdPhysics.Joint)]
    pins = [prim for prim in tree if UsdPhysics.Joint(prim).GetExcludeFromArticulationAttr().Get()]
    arms = [_arm(prim) for prim in tree if prim not in pins]  # pins close chains, outside the tree of links
    return {
        "links": {name: _link(bodies[name]) for name in request["links"] if name in bodies},
        "joints": {name: _joint(prim) for name, prim in joints.items()},
        "couplings": dict(_coupling(prim) for prim in joints.values() if prim.HasAPI("NewtonMimicAPI")),
        "poses": [_pose(arms, pose, request["links"]) for pose in request["poses"]],
    }


def _link(prim: Any) -> dict[str, Any]:
    api = UsdPhysics.MassAPI(prim)
    axes = _frame((0, 0, 0), api.GetPrincipalAxesAttr().Get())[:3, :3]
    mass, center, moments = (
        attribute.Get()
        for attribute in (api.GetMassAttr(), api.GetCenterOfMassAttr(), api.GetDiagonalInertiaAttr())
    )
    return mass_properties(mass, center, moments, axes)


def _joint(prim: Any) -> dict[str, Any]:
    """Return kind, limits and passive terms, which are in Newton's and MuJoCo's schemas."""

    def value(name: str) -> Any:
        return prim.GetAttribute(name).Get() or 0.0

    unit = _unit(prim)
    found = {
        "kind": "prismatic" if unit == 1.0 else "revolute",
        "limits": finite_limits(
            *(unit * prim.GetAttribute(f"physics:{end}Limit").Get() for end in ("lower", "upper"))
        ),
        "damping": value("newton:damping") / unit,
        "friction": value("newton:friction"),
    }
    if prim.HasAPI("MjcJointAPI"):
        found |= {"armature": value("newton:armature"), "stiffness": value("mjc:stiffness")}
        if found["stiffness"]:
            found["rest"] = value("mjc:springref")
    return found


def _coupling(prim: Any) -> tuple[str, list[Any]]:
    leader = prim.GetRelationship("newton:mimicJoint").GetTargets()[0].name
    ratio = prim.GetAttribute("newton:mimicCoef1").Get()
    offset = _unit(prim) * (prim.GetAttribute("newton:mimicCoef0").Get() or 0.0)
    return prim.GetName(), [leader, 1.0 if ratio is None else ratio, offset]


def _unit(prim: Any) -> float:
    """Return SI units per unit of a joint's position."""
    return np.pi / 180.0 if prim.IsA(UsdPhysics.RevoluteJoint) else 1.0


def _arm(prim: Any) -> tuple[str, str, str, Any, Any, int]:
    """Return a joint's name, its bodies, its frames in them, and its axis; axes of slides start at 3."""
    joint = UsdPhysics.Joint(prim)
    bodies = (relation.GetTargets() for relation in (joint.GetBody0Rel(), joint.GetBody1Rel()))
    parent, child = (paths[0].name if paths else "" for paths in bodies)
    before = _frame(joint.GetLocalPos0Attr().Get(), joint.GetLocalRot0Attr().Get())
    after = _frame(joint.GetLocalPos1Attr().Get(), joint.GetLocalRot1Attr().Get())
    axis = prim.GetAttribute("physics:axis").Get()
    number = "XYZ".index(axis) + (3 if prim.IsA(UsdPhysics.PrismaticJoint) else 0) if axis else -1
    return prim.GetName(), parent, child, before, after, number


def _pose(arms: list[Any], pose: dict[str, float], links: list[str]) -> dict[str, Any]:
    """Return the frames of links; joints between the same bodies move one after the other, as MuJoCo's do."""
    frames = {links[0]: np.eye(4)}
    pairs = dict.fromkeys((parent, child) for _, parent, child, *_ in arms if child != links[0])
    remaining = list(pairs)
    while ready := [pair for pair in remaining if pair[0] in frames]:
        for pair in ready:
            frame = frames[pair[0]]
            *earlier, last = [arm for arm in arms if arm[1:3] == pair]
            for name, _, _, before, _, axis in earlier:
                frame = frame @ before @ _motion(axis, pose.get(name, 0.0)) @ np.linalg.inv(before)
            name, _, child, before, after, axis = last
            frames[child] = frame @ before @ _motion(axis, pose.get(name, 0.0)) @ np.linalg.inv(after)
        remaining = [pair for pair in remaining if pair not in ready]
    return in_base(frames, links)


def _motion(axis: int, position: float) -> Any:
    pose = np.array([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0])
    if axis >= 3:
        pose[axis - 3] = position
    elif axis >= 0:
        pose[3 + axis], pose[6] = np.sin(position / 2.0), np.cos(position / 2.0)
    return frame_of(pose)


def _frame(position: Any, quaternion: Any) -> Any:
    return frame_of([*position, *quaternion.GetImaginary(), quaternion.GetReal()])


if __name__ == "__main__":
    serve(_read)
