"""Joints as USD prims: frames, limits, springs, friction and couplings.

Plain UsdPhysics has frames, limits and drives. API schemas of PhysX, Newton and MuJoCo express friction,
armature, largest speed and couplings, without their packages; readers ignore unknown schemas. The numbers
equal those of the MJCF.
"""

import math
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from pxr import Sdf

from artgen._arrays import Array
from artgen.asset import Asset, AssetJoint
from artgen.export.frames import INTERMEDIATE_MASS, Segment, unused
from artgen.export.losses import Row, loop_rows, mechanism_rows, tendon_rows
from artgen.export.usd.layer import Layers, RuntimeRow, define

# as in the MJCF, which gives the reasons
STIFF = (0.005, 1.0)
"""Time constant [s] and damping ratio of limits, contacts and couplings in MuJoCo."""

_COUPLING_IMPEDANCE = (0.99, 0.9999, 0.0001, 0.5, 2.0)
_FRICTION_IMPEDANCE = (0.9999, 0.9999, 0.001, 0.5, 2.0)

_FAR = 2.0e5 * math.pi  # limits of a coupled joint without limits: a hundred thousand turns [rad or m]
_TYPE_NAMES = {"revolute": "PhysicsRevoluteJoint", "prismatic": "PhysicsPrismaticJoint"}


def write_joints(
    layers: Layers, root: Sdf.PrimSpec, name: str, asset: Asset, segments: Sequence[Segment]
) -> Sdf.PrimSpec | None:
    """Add every joint; return the one that fixes the base to the world, if any.

    Args:
        layers: Layers for attributes of single simulators.
        root: The prim of the asset, parent of the bodies.
        name: Name of the scope of the joints.
        asset: The asset.
        segments: Its joints with their frames.
    """
    scope = define(layers.physical(root), name, "Scope")
    limits, positions = _written_limits(asset), asset.positions()
    anchor = None
    if asset.base == "fixed":
        fixed = unused("root_joint", {joint.name for joint in asset.joints})
        base = {"physics:body1": root.path.AppendChild(asset.links[0].name)}
        anchor = define(
            scope, fixed, "PhysicsFixedJoint", {**base, **_frames(np.eye(4), np.eye(3), np.eye(3))}
        )
    for segment in segments:
        joint, origin = segment.joint, segment.origin
        if joint.child in asset.loose:
            continue
        bodies = {
            "physics:body0": root.path.AppendChild(segment.parent.name),
            "physics:body1": root.path.AppendChild(segment.child.name),
        }
        if joint.locked:
            values = {**bodies, **_frames(origin, origin[:3, :3], np.eye(3))}
            define(scope, joint.name, "PhysicsFixedJoint", values)
            continue
        turn = _turn_from_x(joint.axis)
        lower, upper = limits[joint.name] or (None, None)
        values = {
            **bodies,
            **_frames(origin, turn, turn),
            "physics:axis": "X",
            "physics:lowerLimit": None if lower is None else lower * units_of(joint),
            "physics:upperLimit": None if upper is None else upper * units_of(joint),
            **_drive(joint),
        }
        schemas = [f"PhysicsDriveAPI:{_instance(joint)}"] if _driven(joint) else []
        prim = define(scope, joint.name, _TYPE_NAMES[joint.kind], values, schemas=schemas)
        layers.add_runtime(prim, _runtime_rows(joint, positions[joint.name], apart=layers.apart))
        if joint.follows is not None and joint.follows.curve is None:
            leader = asset.joint(joint.follows.leader)
            layers.add_runtime(prim, _coupling_rows(prim.path, joint, leader, apart=layers.apart))
    taken = {joint.name for joint in asset.joints}
    for loop in asset.loops:
        first, second = loop.links
        turn, name = _turn_from_x(loop.axis), unused(f"{first}_{second}_pin", taken)
        taken.add(name)
        values = {
            "physics:body0": root.path.AppendChild(first),
            "physics:body1": root.path.AppendChild(second),
            "physics:localPos0": loop.point - asset.origin(first),
            "physics:localPos1": loop.point - asset.origin(second),
            "physics:localRot0": turn,
            "physics:localRot1": turn,
            "physics:axis": "X",
            "physics:excludeFromArticulation": True,
        }
        define(scope, name, "PhysicsRevoluteJoint", values)
    return anchor


def joint_rows(asset: Asset, segments: Sequence[Segment], *, apart: bool = False) -> Iterator[Row]:
    """Yield the losses of plain UsdPhysics.

    Args:
        asset: The asset.
        segments: Its joints with their frames.
        apart: Whether each simulator's attributes are in a separate variant.
    """
    movable = [joint for joint in asset.joints if not joint.locked]
    leading = [joint for joint in movable if joint.follows is None]
    limits, positions = _written_limits(asset), asset.positions()
    inserted = [segment.child.name for segment in segments if segment.child.link is None]
    instead = f"a body of {INTERMEDIATE_MASS:g} kg after each joint but the last"
    yield "several joints between two links", inserted, instead
    own = "in the variants of the simulators only: " if apart else ""
    instead = own + "PhysxJointAxisAPI, NewtonJointAPI and MjcJointAPI, which other readers do not know"
    yield "joint friction", [joint.name for joint in movable if joint.friction > 0.0], instead
    yield "joint armature", [joint.name for joint in movable if joint.armature > 0.0], instead
    instead = own + "PhysxJointAxisAPI and NewtonJointAPI, which other readers do not know"
    yield "joint velocity limit", [joint.name for joint in leading], instead
    instead = "no maxForce on the drive, which is a spring and a damper that it would weaken"
    yield "joint effort", [joint.name for joint in leading if not _effort_holds(joint)], instead
    moved = [joint.name for joint in movable if positions[joint.name] != 0.0]
    instead = "bodies placed as the joint stands, and PhysicsJointStateAPI"
    yield "joint that does not stand at 0", moved, instead + " in PhysX's variant" * apart
    instead = "PhysxMimicJointAPI and NewtonMimicAPI, or MjcEqualityJointAPI between a rotation and a slide"
    if apart:
        instead = own + "PhysxMimicJointAPI, NewtonMimicAPI and MjcEqualityJointAPI"
    linear = [joint for joint in movable if joint.follows is not None and joint.follows.curve is None]
    yield "joint coupling", [joint.name for joint in linear], instead
    yield from loop_rows(
        asset, "a joint outside the articulation, which closes the chain; its joints are free"
    )
    endless = [joint.name for joint in movable if joint.limits is None and limits[joint.name] is not None]
    instead = "limits a hundred thousand turns away, since PhysX couples joints with limits only"
    yield "coupling without limits", endless, instead
    yield from mechanism_rows(asset)
    yield from tendon_rows(asset)


def units_of(joint: AssetJoint) -> float:
    """Return USD units per SI unit of the joint's position: degrees, or metres."""
    return 180.0 / math.pi if joint.kind == "revolute" else 1.0


def _instance(joint: AssetJoint) -> str:
    """Return the instance name of the drive, axis and state of a joint's degree of freedom."""
    return "angular" if joint.kind == "revolute" else "linear"


def _driven(joint: AssetJoint) -> bool:
    """Tell whether a joint has a drive: a coupled joint has one only for its own spring or damper."""
    return joint.follows is None or joint.stiffness > 0.0 or joint.damping > 0.0


def _frames(origin: Array, turn0: Array, turn1: Array) -> dict[str, Any]:
    """Return the joint's frame in both bodies, at the origin of the child."""
    return {
        "physics:localPos0": origin[:3, 3],
        "physics:localPos1": np.zeros(3),
        "physics:localRot0": turn0,
        "physics:localRot1": turn1,
    }


def _drive(joint: AssetJoint) -> dict[str, Any]:
    """Return the joint's spring and damper as a drive, which actuators use as well."""
    if not _driven(joint):
        return {}
    prefix, units = f"drive:{_instance(joint)}:physics:", units_of(joint)
    return {
        prefix + "type": "force",
        prefix + "damping": joint.damping / units,
        prefix + "stiffness": joint.stiffness / units,
        prefix + "targetPosition": joint.rest * units,
        prefix + "maxForce": joint.effort if _effort_holds(joint) else None,
    }


def _runtime_rows(joint: AssetJoint, position: float, *, apart: bool) -> Iterator[RuntimeRow]:
    """Yield friction, armature, largest speed and initial position of a joint."""
    # MuJoCo reads no drives: its variant has spring and damper alone; Newton adds both, so it has one
    instance, units = _instance(joint), units_of(joint)
    # a coupled joint has its leader's speed: its own limit would fight the coupling
    speed = joint.velocity * units if joint.follows is None else None
    axis = f"physxJointAxis:{instance}:"
    physx = {
        axis + "armature": joint.armature,
        axis + "dynamicFrictionEffort": joint.friction,
        axis + "maxJointVelocity": speed,
        axis + "staticFrictionEffort": joint.friction,
    }
    yield "physx", f"PhysxJointAxisAPI:{instance}", physx
    if position != 0.0:  # PhysX assumes 0 by default, regardless of the bodies
        state = {f"state:{instance}:physics:position": units * position}
        yield "physx", f"PhysicsJointStateAPI:{instance}", state
    newton = {"newton:armature": joint.armature, "newton:friction": joint.friction}
    yield "newton", "NewtonJointAPI", {**newton, "newton:velocityLimit": speed}
    mujoco: dict[str, Any] = {
        "mjc:actuatorfrcrange:max": joint.effort,
        "mjc:actuatorfrcrange:min": -joint.effort,
        "mjc:armature": joint.armature,
        "mjc:frictionloss": joint.friction,
        "mjc:solimpfriction": _FRICTION_IMPEDANCE,
        "mjc:solreffriction": STIFF,
        "mjc:solreflimit": STIFF,
    }
    if apart:
        undriven = {f"drive:{instance}:physics:{name}": 0.0 for name in ("damping", "stiffness")}
        mujoco |= {
            "mjc:damping": joint.damping,
            "mjc:stiffness": joint.stiffness,
            "mjc:springref": joint.rest * units if joint.stiffness else None,
            "mjc:ref": position * units if position != 0.0 else None,
            **(undriven if _driven(joint) else {}),
        }
    yield "mujoco", "MjcJointAPI", mujoco


def _coupling_rows(
    path: Sdf.Path, joint: AssetJoint, leader: AssetJoint, *, apart: bool
) -> Iterator[RuntimeRow]:
    """Yield the coupling of a joint for each simulator.

    PhysX holds `position + gearing * leader + offset = 0` in degrees and metres, and does the same for
    `NewtonMimicAPI`, `position = coef0 + coef1 * leader`. Newton reads coef1 in radians and metres. The two
    agree on joints of one kind only. Between a rotation and a slide, MuJoCo's equality in radians and metres
    is for Newton, because PhysX ignores it; if each simulator has its own layer, both are written.
    """
    assert joint.follows is not None
    ratio, offset = joint.follows.ratio, joint.follows.offset
    target = path.ReplaceName(leader.name)
    if apart or joint.kind == leader.kind:
        law = {"newton:mimicCoef0": offset * units_of(joint), "newton:mimicCoef1": ratio}
        yield "newton", "NewtonMimicAPI", {"newton:mimicJoint": target, **law}
    if apart or joint.kind != leader.kind:
        # MuJoCo counts from the initial positions, in which the coupling holds; Newton counts from 0
        law = {"mjc:coef0": 0.0 if apart else offset, "mjc:coef1": ratio}
        solver = {"mjc:solimp": _COUPLING_IMPEDANCE, "mjc:solref": STIFF}
        yield "mujoco", "MjcEqualityJointAPI", {"mjc:target": target, **law, **solver}
    prefix = "physxMimicJoint:rotX:"  # PhysX requires the name of a rotation axis for slides as well
    physx = {
        prefix + "referenceJoint": target,
        prefix + "referenceJointAxis": "rotX",
        prefix + "gearing": -ratio * units_of(joint) / units_of(leader),
        prefix + "offset": -offset * units_of(joint),
    }
    yield "physx", "PhysxMimicJointAPI:rotX", physx


def _written_limits(asset: Asset) -> dict[str, tuple[float, float] | None]:
    """Return the limits to write, wide ones for coupled joints without limits."""
    laws = {joint.name: joint.follows for joint in asset.joints if joint.follows and not joint.follows.curve}
    coupled = {*laws, *(law.leader for law in laws.values())}
    return {
        joint.name: _wide(asset, joint) if joint.limits is None and joint.name in coupled else joint.limits
        for joint in asset.joints
    }


def _wide(asset: Asset, joint: AssetJoint) -> tuple[float, float]:
    if joint.follows is None or joint.follows.curve is not None:
        laws = [each.follows for each in asset.joints if each.follows and each.follows.leader == joint.name]
        slowest = min((abs(law.ratio) for law in laws if not law.curve and law.ratio), default=1.0)
        far = _FAR / min(1.0, slowest)  # slow followers are not to have limits that count as real ones
        return -far, far
    ends = _wide(asset, asset.joint(joint.follows.leader))
    low, high = sorted(joint.follows.ratio * end + joint.follows.offset for end in ends)
    return low, high


def _turn_from_x(axis: Array) -> Array:
    """Return a rotation that takes x to a unit axis, shape (3, 3)."""
    # the smallest rotation, after half a turn for an axis that points backwards, near which it loses digits
    sign = math.copysign(1.0, axis[0])
    x, y, z = sign * axis
    cross = np.array([[0.0, -y, -z], [y, 0.0, 0.0], [z, 0.0, 0.0]])
    turn: Array = np.eye(3) + cross + cross @ cross / (1.0 + x)
    return turn @ np.diag([sign, sign, 1.0])


def _effort_holds(joint: AssetJoint) -> bool:
    """Tell whether spring and damper always stay below the effort."""
    # `maxForce` limits the drive, here a passive spring and damper, while the effort limits an actuator
    strongest = joint.damping * joint.velocity
    if joint.stiffness > 0.0:
        if joint.limits is None:
            return False
        strongest += joint.stiffness * max(abs(limit - joint.rest) for limit in joint.limits)
    return strongest <= joint.effort
