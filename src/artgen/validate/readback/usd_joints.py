"""Joints of a USD stage as a simulator takes them: frames, limits, springs, couplings."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from pxr import Gf, UsdPhysics

from artgen._arrays import Array
from artgen.validate.readback.reading import Said

_UNREACHABLE = 1e5  # [rad or m]: limits beyond are none; some simulators want them on coupled joints


@dataclass(frozen=True, eq=False)
class Arm:
    """A joint as a file has it: it moves along or about an axis of its frames."""

    prim: Any  # the prim; it lives as long as its stage
    name: str  # name of the joint
    kind: str  # `revolute`, `prismatic`, or empty for a fixed joint
    parent: str  # name of the body that it hangs on; empty for the world
    child: str  # name of the body that it moves; empty for the world
    before: Array  # its frame in the parent, shape (4, 4)
    after: Array  # its frame in the child, shape (4, 4)
    column: int = 0  # number of the axis: 0 for x
    limits: tuple[float, float] | None = None  # lowest and highest position [rad or m]

    @property
    def to_world(self) -> bool:
        """Whether it holds a body to the world."""
        return not self.kind and not (self.parent and self.child)

    def motion(self, position: float) -> Array:
        """Return the motion at a position, shape (4, 4)."""
        result = np.eye(4)
        if self.kind == "revolute":
            first, second = (self.column + 1) % 3, (self.column + 2) % 3
            cosine, sine = np.cos(position), np.sin(position)
            result[[first, second], [first, second]] = cosine
            result[first, second], result[second, first] = -sine, sine
        elif self.kind:
            result[self.column, 3] = position
        return result


def arms(stage: Any) -> Iterator[Arm]:
    """Yield the joints of a stage that are not disabled."""
    for prim in stage.Traverse():
        if not prim.IsA(UsdPhysics.Joint):
            continue
        joint = UsdPhysics.Joint(prim)
        if joint.GetJointEnabledAttr().Get() is False:
            continue
        parent, child = (
            next((path.name for path in each.GetTargets()), "")
            for each in (joint.GetBody0Rel(), joint.GetBody1Rel())
        )
        before = pose(joint.GetLocalPos0Attr().Get(), joint.GetLocalRot0Attr().Get())
        after = pose(joint.GetLocalPos1Attr().Get(), joint.GetLocalRot1Attr().Get())
        kind, limits, column = "", None, 0
        if prim.IsA(UsdPhysics.RevoluteJoint):
            kind, limits = "revolute", _limits(UsdPhysics.RevoluteJoint(prim), np.pi / 180.0)
        elif prim.IsA(UsdPhysics.PrismaticJoint):
            kind, limits = "prismatic", _limits(UsdPhysics.PrismaticJoint(prim), 1.0)
        if kind:
            column = "XYZ".find(str(prim.GetAttribute("physics:axis").Get()))
        yield Arm(prim, prim.GetName(), kind, parent, child, before, after, max(column, 0), limits)


def _limits(joint: Any, unit: float) -> tuple[float, float] | None:
    low, high = unit * joint.GetLowerLimitAttr().Get(), unit * joint.GetUpperLimitAttr().Get()
    reachable = np.isfinite(low) and np.isfinite(high) and high < _UNREACHABLE
    return (float(low), float(high)) if reachable else None


def pose(position: Any, rotation: Any) -> Array:
    """Return position and quaternion of OpenUSD as a transform, shape (4, 4)."""
    result = np.eye(4)
    # not by way of Gf.Rotation: its angle, an arccosine, is inexact near 0
    result[:3, :3] = np.array(Gf.Matrix3d(Gf.Quatd(rotation).GetNormalized())).T
    result[:3, 3] = position
    return result


def dynamics(arm: Arm) -> Iterator[Said]:
    """Yield what plain UsdPhysics and the schemas of simulators say of a joint; what is left out is 0."""
    unit = np.pi / 180.0 if arm.kind == "revolute" else 1.0  # SI units per USD unit
    instance = "angular" if arm.kind == "revolute" else "linear"
    drive, axis = f"drive:{instance}:physics:", f"physxJointAxis:{instance}:"
    schemas = applied(arm.prim)
    if f"PhysicsDriveAPI:{instance}" in schemas:
        yield from _spring(arm.prim, drive, unit)
    for schema, field, name in (
        ("NewtonJointAPI", "friction", "newton:friction"),
        ("NewtonJointAPI", "armature", "newton:armature"),
        (f"PhysxJointAxisAPI:{instance}", "friction", f"{axis}staticFrictionEffort"),
        (f"PhysxJointAxisAPI:{instance}", "friction", f"{axis}dynamicFrictionEffort"),
        (f"PhysxJointAxisAPI:{instance}", "armature", f"{axis}armature"),
        ("MjcJointAPI", "friction", "mjc:frictionloss"),
        ("MjcJointAPI", "armature", "mjc:armature"),
    ):
        if schema in schemas:
            yield Said(field, _value(arm.prim, name) or 0.0, name)
    for field, name, factor in (
        ("effort", f"{drive}maxForce", 1.0),
        ("effort", "mjc:actuatorfrcrange:max", 1.0),
        ("effort", "mjc:actuatorfrcrange:min", -1.0),
        ("velocity", "newton:velocityLimit", unit),
        ("velocity", f"{axis}maxJointVelocity", unit),
    ):
        value = _value(arm.prim, name)
        if value is not None and np.isfinite(value):
            yield Said(field, factor * value, name)


def _spring(prim: Any, drive: str, unit: float) -> Iterator[Said]:
    """Yield spring and damper: of the drive, and of MuJoCo beside it, which has a drive of 0 then."""
    for field in ("stiffness", "damping"):
        of_mujoco = _value(prim, f"mjc:{field}") or 0.0
        name = f"mjc:{field}" if of_mujoco else f"{drive}{field}"
        yield Said(field, (_value(prim, f"{drive}{field}") or 0.0) / unit + of_mujoco, name)
    name = "mjc:springref" if _value(prim, "mjc:stiffness") else f"{drive}targetPosition"
    yield Said("rest", (_value(prim, name) or 0.0) * unit, name)


def applied(prim: Any) -> list[str]:
    """Return the API schemas of a prim, those too that OpenUSD does not know."""
    schemas = prim.GetMetadata("apiSchemas")
    return [] if schemas is None else list(schemas.GetAppliedItems())


def _value(prim: Any, name: str) -> float | None:
    attribute = prim.GetAttribute(name)
    value = attribute.Get() if attribute else None
    return None if value is None else float(value)


def couplings(stage: Any, schema: str) -> dict[str, tuple[str, float, float]]:
    """Return couplings in radians and metres as one schema has them: `newton:mimicJoint` or `mjc:target`."""
    result = {}
    prefix = {"newton:mimicJoint": "newton:mimicC", "mjc:target": "mjc:c"}[schema]
    for prim in stage.Traverse():
        relation = prim.GetRelationship(schema)
        if not relation or not relation.GetTargets():
            continue
        offset, ratio = (_value(prim, f"{prefix}oef{number}") or 0.0 for number in (0, 1))
        if schema == "newton:mimicJoint" and prim.IsA(UsdPhysics.RevoluteJoint):
            offset = float(np.radians(offset))
        result[str(prim.GetName())] = (str(relation.GetTargets()[0].name), ratio, offset)
    return result


def physx_couplings(stage: Any) -> dict[str, tuple[str, float, float]]:
    """Return couplings as PhysX has them: position + gearing * leader + offset = 0 in degrees and metres."""
    result = {}
    for prim in stage.Traverse():
        for schema in applied(prim):
            if not schema.startswith("PhysxMimicJointAPI:"):
                continue
            prefix = f"physxMimicJoint:{schema.partition(':')[2]}:"
            relation = prim.GetRelationship(f"{prefix}referenceJoint")
            targets = relation.GetTargets() if relation else []
            leader = stage.GetPrimAtPath(targets[0]) if targets else None
            if not leader:
                continue
            unit, of_leader = (
                np.pi / 180.0 if each.IsA(UsdPhysics.RevoluteJoint) else 1.0 for each in (prim, leader)
            )
            gearing, offset = (_value(prim, prefix + name) or 0.0 for name in ("gearing", "offset"))
            result[str(prim.GetName())] = (str(leader.GetName()), -gearing * unit / of_leader, -offset * unit)
    return result
