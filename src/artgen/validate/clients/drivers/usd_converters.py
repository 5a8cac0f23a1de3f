"""What the converters of the Newton project make of an MJCF or a URDF: a USD, which OpenUSD reads back."""

import tempfile
from typing import Any

import numpy as np
from driver_motion import in_base
from driver_protocol import about_axes, serve, transform

_UNLIMITED = 1e5  # limits beyond are none


def read(request: dict[str, Any]) -> dict[str, Any]:
    """Return the response to a request."""
    from importlib import import_module
    from importlib.metadata import version

    import usdex.core
    from pxr import Usd

    usdex.core.activateDiagnosticsDelegate()
    usdex.core.setDiagnosticsLevel(usdex.core.DiagnosticsLevel.eWarning)  # its progress is no message
    name = "mujoco_usd_converter" if request["format"] == "mjcf" else "urdf_usd_converter"
    with tempfile.TemporaryDirectory() as directory:
        path = import_module(name).Converter().convert(request["file"], directory)
        stage = Usd.Stage.Open(path.path)
        return {"version": version(name.replace("_", "-")), **_read(stage, request)}


def _read(stage: Any, request: dict[str, Any]) -> dict[str, Any]:
    from pxr import UsdPhysics

    prims = list(stage.Traverse())
    bodies = {prim.GetName(): prim for prim in prims if prim.HasAPI(UsdPhysics.RigidBodyAPI)}
    joints = {
        prim.GetName(): prim
        for prim in prims
        if prim.IsA(UsdPhysics.RevoluteJoint) or prim.IsA(UsdPhysics.PrismaticJoint)
    }
    arms = [_arm(prim) for prim in prims if prim.IsA(UsdPhysics.Joint)]
    return {
        "links": {name: _link(bodies[name]) for name in request["links"] if name in bodies},
        "joints": {name: _joint(prim) for name, prim in joints.items()},
        "couplings": dict(_coupling(prim) for prim in joints.values() if prim.HasAPI("NewtonMimicAPI")),
        "poses": [_pose(arms, pose, request["links"]) for pose in request["poses"]],
    }


def _link(prim: Any) -> dict[str, Any]:
    from pxr import UsdPhysics

    api = UsdPhysics.MassAPI(prim)
    turn = _frame((0, 0, 0), api.GetPrincipalAxesAttr().Get())[:3, :3]
    return {
        "mass": api.GetMassAttr().Get(),
        "center": api.GetCenterOfMassAttr().Get(),
        "inertia": about_axes(np.array(api.GetDiagonalInertiaAttr().Get(), float), turn),
    }


def _joint(prim: Any) -> dict[str, Any]:
    """Return kind, limits and passive terms, which stand in Newton's and MuJoCo's schemas."""
    unit = _unit(prim)
    low, high = (unit * prim.GetAttribute(f"physics:{end}Limit").Get() for end in ("lower", "upper"))
    limited = np.isfinite(low) and np.isfinite(high) and max(abs(low), abs(high)) < _UNLIMITED
    found = {
        "kind": "prismatic" if unit == 1.0 else "revolute",
        "limits": [low, high] if limited else None,
        "damping": (prim.GetAttribute("newton:damping").Get() or 0.0) / unit,
        "friction": prim.GetAttribute("newton:friction").Get() or 0.0,
    }
    if prim.HasAPI("MjcJointAPI"):
        found["armature"] = prim.GetAttribute("newton:armature").Get() or 0.0
        found["stiffness"] = prim.GetAttribute("mjc:stiffness").Get() or 0.0
        if found["stiffness"]:
            found["rest"] = prim.GetAttribute("mjc:springref").Get() or 0.0
    return found


def _coupling(prim: Any) -> tuple[str, list[Any]]:
    leader = prim.GetRelationship("newton:mimicJoint").GetTargets()[0].name
    ratio = prim.GetAttribute("newton:mimicCoef1").Get()
    offset = _unit(prim) * (prim.GetAttribute("newton:mimicCoef0").Get() or 0.0)
    return prim.GetName(), [leader, 1.0 if ratio is None else ratio, offset]


def _unit(prim: Any) -> float:
    """Return SI units per unit of a joint's position."""
    from pxr import UsdPhysics

    return np.pi / 180.0 if prim.IsA(UsdPhysics.RevoluteJoint) else 1.0


def _arm(prim: Any) -> tuple[str, str, str, Any, Any, int]:
    """Return a joint's name, its bodies, its frames in them and its axis; a slide's is counted from 3."""
    from pxr import UsdPhysics

    joint = UsdPhysics.Joint(prim)
    names = [
        [path.name for path in relation.GetTargets()] or [""]
        for relation in (joint.GetBody0Rel(), joint.GetBody1Rel())
    ]
    before = _frame(joint.GetLocalPos0Attr().Get(), joint.GetLocalRot0Attr().Get())
    after = _frame(joint.GetLocalPos1Attr().Get(), joint.GetLocalRot1Attr().Get())
    axis = prim.GetAttribute("physics:axis").Get()
    number = "XYZ".index(axis) + (3 if prim.IsA(UsdPhysics.PrismaticJoint) else 0) if axis else -1
    return prim.GetName(), names[0][0], names[1][0], before, after, number


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
    result = np.eye(4)
    if axis >= 3:
        result[axis - 3, 3] = position
    elif axis >= 0:
        one, two = (axis + 1) % 3, (axis + 2) % 3
        cosine, sine = np.cos(position), np.sin(position)
        result[one, one], result[one, two], result[two, one], result[two, two] = cosine, -sine, sine, cosine
    return result


def _frame(position: Any, quaternion: Any) -> Any:
    from pxr import Gf

    turn = np.array(Gf.Matrix3d(Gf.Quatd(quaternion).GetNormalized())).T
    return transform(turn, position)


if __name__ == "__main__":
    serve(read, "mujoco_usd_converter", "urdf_usd_converter")
