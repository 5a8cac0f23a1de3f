"""Joints as USD prims: frames, limits, springs, friction and couplings.

Plain UsdPhysics has frames, limits and drives. API schemas of simulators express friction, armature, largest
speed and couplings, see `artgen.export.usd.runtimes`.
"""

import math
from collections.abc import Sequence

import numpy as np
from pxr import Gf, Sdf

from artgen._arrays import Array
from artgen.asset import Asset, AssetJoint
from artgen.export.frames import INTERMEDIATE_MASS, Segment
from artgen.export.losses import Loss, losses, mechanism_rows
from artgen.export.usd.layer import TYPES, Layers, define, quatf, relate, vec3, write
from artgen.export.usd.runtimes import driven, instance_of, units_of, write_runtime_joint

_IDENTITY = np.eye(4)


def write_fixed_joint(
    scope: Sdf.PrimSpec, name: str, bodies: tuple[Sdf.Path | None, Sdf.Path], frame: Array = _IDENTITY
) -> None:
    """Join two bodies rigidly.

    Args:
        scope: The parent prim.
        name: Its name.
        bodies: Parent and child; None as the parent is the world.
        frame: The child's frame in the parent's, shape (4, 4) [m].
    """
    prim = define(scope, name, "PhysicsFixedJoint")
    parent, child = bodies
    if parent is not None:
        relate(prim, "physics:body0", parent)
    relate(prim, "physics:body1", child)
    _frames(prim, frame[:3, 3], frame[:3, :3], np.eye(3))


def write_joints(layers: Layers, scope: Sdf.PrimSpec, asset: Asset, segments: Sequence[Segment]) -> None:
    """Add every joint.

    Args:
        layers: Layers for attributes of single simulators.
        scope: The parent prim; the bodies are its siblings.
        asset: The asset.
        segments: Its joints with their frames.
    """
    root = scope.path.GetParentPath()
    limits = _written_limits(asset)
    positions = asset.positions()
    for segment in segments:
        joint = segment.joint
        bodies = root.AppendChild(segment.parent.name), root.AppendChild(segment.child.name)
        if joint.locked:
            write_fixed_joint(scope, joint.name, bodies, segment.origin)
            continue
        prim = _joint(scope, segment, bodies)
        bounds = limits[joint.name]
        if bounds is not None:
            lower, upper = (units_of(joint) * bound for bound in bounds)
            write(prim, TYPES.Float, {"physics:lowerLimit": lower, "physics:upperLimit": upper})
        if driven(joint):
            _drive(prim, joint)
        write_runtime_joint(layers, prim, asset, joint, positions[joint.name])


def joint_losses(asset: Asset, segments: Sequence[Segment], *, apart: bool = False) -> tuple[Loss, ...]:
    """Return the losses of plain UsdPhysics.

    Args:
        asset: The asset.
        segments: Its joints with their frames.
        apart: Whether each simulator's attributes are in a separate variant.
    """
    movable = [joint for joint in asset.joints if not joint.locked]
    leading = [joint for joint in movable if joint.follows is None]
    followers = [joint for joint in movable if joint.follows is not None]
    limits = _written_limits(asset)
    positions = asset.positions()
    own = "in the variants of the simulators only: " if apart else ""
    words = own + "PhysxJointAxisAPI, NewtonJointAPI and MjcJointAPI, which other readers do not know"
    return losses(
        (
            "several joints between two links",
            [segment.child.name for segment in segments if segment.child.link is None],
            f"a body of {INTERMEDIATE_MASS:g} kg after each joint but the last",
        ),
        ("joint friction", [joint.name for joint in movable if joint.friction > 0.0], words),
        ("joint armature", [joint.name for joint in movable if joint.armature > 0.0], words),
        (
            "joint velocity limit",
            [joint.name for joint in leading],
            own + "PhysxJointAxisAPI and NewtonJointAPI, which other readers do not know",
        ),
        (
            "joint effort",
            [joint.name for joint in leading if not _effort_holds(joint)],
            "no maxForce on the drive, which is a spring and a damper that it would weaken",
        ),
        (
            "joint that does not stand at 0",
            [joint.name for joint in movable if positions[joint.name] != 0.0],
            "bodies placed as the joint stands, and PhysicsJointStateAPI" + (" in PhysX's variant" * apart),
        ),
        ("joint coupling", [joint.name for joint in followers], own + (_APART if apart else _TOGETHER)),
        (
            "coupling without limits",
            [joint.name for joint in movable if joint.limits is None and limits[joint.name] is not None],
            "limits a hundred thousand turns away, since PhysX couples joints with limits only",
        ),
        *mechanism_rows(asset),
    )


_TOGETHER = "PhysxMimicJointAPI and NewtonMimicAPI, or MjcEqualityJointAPI between a rotation and a slide"

_APART = "PhysxMimicJointAPI, NewtonMimicAPI and MjcEqualityJointAPI"

_FAR = 2.0e5 * math.pi
"""Limits of a coupled joint without limits: a hundred thousand turns [rad or m]."""


def _joint(scope: Sdf.PrimSpec, segment: Segment, bodies: tuple[Sdf.Path, Sdf.Path]) -> Sdf.PrimSpec:
    """Add the prim of a joint with its frames; it moves along or about x of both."""
    joint = segment.joint
    schemas = [f"PhysicsDriveAPI:{instance_of(joint)}"] if driven(joint) else []
    prim = define(scope, joint.name, _TYPE_NAMES[joint.kind], schemas)
    relate(prim, "physics:body0", bodies[0])
    relate(prim, "physics:body1", bodies[1])
    write(prim, TYPES.Token, {"physics:axis": "X"}, uniform=True)
    turn = _turn_from_x(joint.axis)
    _frames(prim, segment.origin[:3, 3], turn, turn)
    return prim


_TYPE_NAMES = {"revolute": "PhysicsRevoluteJoint", "prismatic": "PhysicsPrismaticJoint"}


def _written_limits(asset: Asset) -> dict[str, tuple[float, float] | None]:
    """Return the limits to write, wide ones for coupled joints without limits."""
    coupled = {joint.name for joint in asset.joints if joint.follows is not None}
    coupled |= {joint.follows.leader for joint in asset.joints if joint.follows is not None}
    return {
        joint.name: _wide(asset, joint) if joint.limits is None and joint.name in coupled else joint.limits
        for joint in asset.joints
    }


def _wide(asset: Asset, joint: AssetJoint) -> tuple[float, float]:
    if joint.follows is None:
        return -_FAR, _FAR
    ends = _wide(asset, asset.joint(joint.follows.leader))
    low, high = sorted(joint.follows.ratio * end + joint.follows.offset for end in ends)
    return low, high


def _frames(prim: Sdf.PrimSpec, position: Array, turn0: Array, turn1: Array) -> None:
    """Write the joint's frame in both bodies, at the origin of the child."""
    write(
        prim,
        TYPES.Point3f,
        {"physics:localPos0": vec3(position), "physics:localPos1": Gf.Vec3f(0.0)},
    )
    write(
        prim,
        TYPES.Quatf,
        {
            "physics:localRot0": quatf(turn0),
            "physics:localRot1": quatf(turn1),
        },
    )


def _turn_from_x(axis: Array) -> Array:
    """Return a rotation that takes x to a unit axis, shape (3, 3)."""
    # the smallest rotation, after half a turn for an axis that points backwards, near which it loses digits
    sign = math.copysign(1.0, axis[0])
    x, y, z = sign * axis
    cross = np.array([[0.0, -y, -z], [y, 0.0, 0.0], [z, 0.0, 0.0]])
    turn: Array = np.eye(3) + cross + cross @ cross / (1.0 + x)
    return turn @ np.diag([sign, sign, 1.0])


def _drive(prim: Sdf.PrimSpec, joint: AssetJoint) -> None:
    """Write the joint's spring and damper as a drive, which actuators use as well."""
    prefix = f"drive:{instance_of(joint)}:physics:"
    units = units_of(joint)
    write(prim, TYPES.Token, {prefix + "type": "force"}, uniform=True)
    values = {
        "damping": joint.damping / units,
        "stiffness": joint.stiffness / units,
        "targetPosition": joint.rest * units,
    }
    if _effort_holds(joint):
        values["maxForce"] = joint.effort
    write(prim, TYPES.Float, {prefix + name: values[name] for name in sorted(values)})


def _effort_holds(joint: AssetJoint) -> bool:
    """Tell whether spring and damper always stay below the effort.

    `maxForce` limits the drive, which is a passive spring and damper here, while the effort limits an
    actuator: for a stronger spring, it would change the passive motion of the part.
    """
    strongest = joint.damping * joint.velocity
    if joint.stiffness > 0.0:
        if joint.limits is None:
            return False
        strongest += joint.stiffness * max(abs(limit - joint.rest) for limit in joint.limits)
    return strongest <= joint.effort
