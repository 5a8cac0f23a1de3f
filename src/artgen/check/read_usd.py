"""Reading an exported USD with OpenUSD."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pxr import Gf, Usd, UsdGeom, UsdPhysics, UsdUtils, UsdValidation

from artgen.asset import Asset
from artgen.check.reading import Inertial, Reading, listening, mesh_volume

Array = NDArray[np.float64]

_UNREACHABLE = 1e5  # [rad or m]: limits beyond are none; some simulators want them on coupled joints


def read_usd(asset: Asset, path: Path) -> Reading:
    """Read a stage, and run OpenUSD's validators on it.

    Args:
        asset: The asset whose links are looked for.
        path: The file.
    """
    with listening() as said:
        diagnostics = UsdUtils.CoalescingDiagnosticDelegate()
        stage = Usd.Stage.Open(str(path))
        stage.Reload()  # layers that are open already hide what is on the disk now
        said.extend(_validated(stage))
        said.extend(item.commentary for item in diagnostics.TakeUncoalescedDiagnostics())
        del diagnostics  # from here on, OpenUSD prints again
    bodies = {prim.GetName(): prim for prim in stage.Traverse() if prim.HasAPI(UsdPhysics.RigidBodyAPI)}
    arms = list(_arms(stage))
    links = [link.name for link in asset.links if link.name in bodies]
    moving = {arm.name: arm for arm in arms if arm.kind}
    base = asset.links[0].name
    start = _placed(bodies[base]) if base in bodies else np.eye(4)

    def frames(positions: Mapping[str, float]) -> dict[str, Array]:
        found = {base: start}
        remaining = list(arms)
        while remaining:
            ready = [arm for arm in remaining if arm.parent in found]
            if not ready:
                break
            for arm in ready:
                motion = arm.before @ arm.motion(positions.get(arm.name, 0.0)) @ np.linalg.inv(arm.after)
                found[arm.child] = found[arm.parent] @ motion
            remaining = [arm for arm in remaining if arm not in ready]
        return {name: found[name] for name in links if name in found}

    return Reading(
        path.name,
        frames,
        {name: _inertial(bodies[name]) for name in links},
        {name: arm.kind for name, arm in moving.items()},
        {name: arm.limits for name, arm in moving.items()},
        {name: arm.after[:3, 0] for name, arm in moving.items()},
        dict(_couplings(stage)),
        {name: _colliders(bodies[name]) for name in links},
        tuple(said),
    )


def _validated(stage: Any) -> list[str]:
    """Return what OpenUSD's own validators say of a stage."""
    registry = UsdValidation.ValidationRegistry()
    context = UsdValidation.ValidationContext(registry.GetOrLoadAllValidators())
    return [f"{error.GetName()}: {error.GetMessage()}" for error in context.Validate(stage)]


@dataclass(frozen=True, eq=False)
class _Arm:
    """A joint as a file has it: it moves along or about x of its frames.

    Attributes:
        name: Name of the joint.
        kind: `revolute`, `prismatic`, or empty for a fixed joint.
        parent: Name of the body that it hangs on.
        child: Name of the body that it moves.
        before: Its frame in the parent, shape (4, 4).
        after: Its frame in the child, shape (4, 4).
        limits: Lowest and highest position [rad or m].
    """

    name: str
    kind: str
    parent: str
    child: str
    before: Array
    after: Array
    limits: tuple[float, float] | None = None

    def motion(self, position: float) -> Array:
        """Return the motion at a position, shape (4, 4)."""
        result = np.eye(4)
        if self.kind == "revolute":
            cosine, sine = np.cos(position), np.sin(position)
            result[1:3, 1:3] = [[cosine, -sine], [sine, cosine]]
        elif self.kind:
            result[0, 3] = position
        return result


def _arms(stage: Any) -> Iterator[_Arm]:
    for prim in stage.Traverse():
        if not prim.IsA(UsdPhysics.Joint):
            continue
        joint = UsdPhysics.Joint(prim)
        ends = [
            [path.name for path in each.GetTargets()] for each in (joint.GetBody0Rel(), joint.GetBody1Rel())
        ]
        if not ends[0] or not ends[1]:
            continue  # the fixed base
        before = _pose(joint.GetLocalPos0Attr().Get(), joint.GetLocalRot0Attr().Get())
        after = _pose(joint.GetLocalPos1Attr().Get(), joint.GetLocalRot1Attr().Get())
        kind, limits = "", None
        if prim.IsA(UsdPhysics.RevoluteJoint):
            kind, limits = "revolute", _limits(UsdPhysics.RevoluteJoint(prim), np.pi / 180.0)
        elif prim.IsA(UsdPhysics.PrismaticJoint):
            kind, limits = "prismatic", _limits(UsdPhysics.PrismaticJoint(prim), 1.0)
        yield _Arm(prim.GetName(), kind, ends[0][0], ends[1][0], before, after, limits)


def _limits(joint: Any, unit: float) -> tuple[float, float] | None:
    low, high = unit * joint.GetLowerLimitAttr().Get(), unit * joint.GetUpperLimitAttr().Get()
    reachable = np.isfinite(low) and np.isfinite(high) and high < _UNREACHABLE
    return (float(low), float(high)) if reachable else None


def _pose(position: Any, rotation: Any) -> Array:
    result = np.eye(4)
    result[:3, :3] = np.array(Gf.Matrix3d(Gf.Rotation(Gf.Quatd(rotation)))).T
    result[:3, 3] = position
    return result


def _placed(prim: Any) -> Array:
    matrix = UsdGeom.Xformable(prim).ComputeLocalToWorldTransform(Usd.TimeCode.Default())
    return np.array(matrix).T


def _inertial(prim: Any) -> Inertial:
    api = UsdPhysics.MassAPI(prim)
    turn = _pose((0.0, 0.0, 0.0), api.GetPrincipalAxesAttr().Get())[:3, :3]
    diagonal = np.diag(np.array(api.GetDiagonalInertiaAttr().Get(), float))
    center = np.array(api.GetCenterOfMassAttr().Get(), float)
    return Inertial(float(api.GetMassAttr().Get()), center, turn @ diagonal @ turn.T)


def _couplings(stage: Any) -> Iterator[tuple[str, tuple[str, float, float]]]:
    """Yield couplings in radians and metres: Newton's schema, or MuJoCo's between a rotation and a slide."""
    for prim in stage.Traverse():
        for prefix, target in (("newton:mimicC", "newton:mimicJoint"), ("mjc:c", "mjc:target")):
            relation = prim.GetRelationship(target)
            if not relation or not relation.GetTargets():
                continue
            offset, ratio = (float(prim.GetAttribute(f"{prefix}oef{number}").Get()) for number in (0, 1))
            if target == "newton:mimicJoint" and prim.IsA(UsdPhysics.RevoluteJoint):
                offset = float(np.radians(offset))
            yield prim.GetName(), (relation.GetTargets()[0].name, ratio, offset)


def _colliders(body: Any) -> tuple[int, float]:
    """Return number and total volume of the colliders of a body."""
    found = [prim for prim in Usd.PrimRange(body) if prim.HasAPI(UsdPhysics.CollisionAPI)]
    return len(found), sum(_volume(prim, _placed(body)) for prim in found)


def _volume(prim: Any, body: Array) -> float:
    if prim.IsA(UsdGeom.Mesh):
        mesh = UsdGeom.Mesh(prim)
        corners = np.array(mesh.GetFaceVertexIndicesAttr().Get(), np.int64).reshape(-1, 3)
        volume = mesh_volume(np.array(mesh.GetPointsAttr().Get(), float), corners)
    elif prim.IsA(UsdGeom.Cube):
        volume = float(UsdGeom.Cube(prim).GetSizeAttr().Get()) ** 3
    else:
        radius = float(prim.GetAttribute("radius").Get())
        ball = 0.0 if prim.IsA(UsdGeom.Cylinder) else 4.0 / 3.0 * np.pi * radius**3
        height = 0.0 if prim.IsA(UsdGeom.Sphere) else float(prim.GetAttribute("height").Get())
        volume = np.pi * radius**2 * height + ball
    scale = np.linalg.det((np.linalg.inv(body) @ _placed(prim))[:3, :3])
    return float(volume * abs(scale))
