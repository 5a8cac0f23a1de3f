"""USD attributes for PhysX, Newton and MuJoCo, without their packages.

Readers ignore unknown schemas. The numbers equal those of the MJCF.
"""

import math

from pxr import Sdf, Vt

from artgen.asset import Asset, AssetCoupling, AssetJoint
from artgen.export.usd.layer import TYPES, Layers, apply, relate, write

# as in the MJCF, which gives the reasons
_STIFF = Vt.DoubleArray([0.005, 1.0])
_CONTACT_IMPEDANCE = Vt.DoubleArray([0.95, 0.99, 0.0005, 0.5, 2.0])
_COUPLING_IMPEDANCE = Vt.DoubleArray([0.99, 0.9999, 0.0001, 0.5, 2.0])
_FRICTION_IMPEDANCE = Vt.DoubleArray([0.9999, 0.9999, 0.001, 0.5, 2.0])

_ITERATIONS = 32
"""Position iterations of PhysX for an articulation with couplings and heavy doors."""


def driven(joint: AssetJoint) -> bool:
    """Tell whether a joint has a drive: a coupled joint has one only for its own spring or damper."""
    return joint.follows is None or joint.stiffness > 0.0 or joint.damping > 0.0


def instance_of(joint: AssetJoint) -> str:
    """Return the instance name of the drive, axis and state of a joint's degree of freedom."""
    return "angular" if joint.kind == "revolute" else "linear"


def units_of(joint: AssetJoint) -> float:
    """Return USD units per SI unit of the joint's position: degrees, or metres."""
    return 180.0 / math.pi if joint.kind == "revolute" else 1.0


def write_runtime_root(layers: Layers, prim: Sdf.PrimSpec) -> None:
    """Write how each simulator treats the articulation with its root at a prim.

    Its parts collide with each other, as in MJCF: a bolt and its strike interact by contact.
    """
    physx = layers.runtime("physx", prim)
    apply(physx, "PhysxArticulationAPI")
    write(physx, TYPES.Bool, {"physxArticulation:enabledSelfCollisions": True})
    iterations = {"physxArticulation:solverPositionIterationCount": _ITERATIONS}
    write(physx, TYPES.Int, iterations)
    newton = layers.runtime("newton", prim)
    apply(newton, "NewtonArticulationRootAPI")
    write(newton, TYPES.Bool, {"newton:selfCollisionEnabled": True})


def write_runtime_body(layers: Layers, prim: Sdf.PrimSpec) -> None:
    """Write that only joints slow a body: by default, PhysX damps its rotation."""
    physx = layers.runtime("physx", prim)
    apply(physx, "PhysxRigidBodyAPI")
    write(physx, TYPES.Float, {"physxRigidBody:angularDamping": 0.0})


def write_runtime_collider(layers: Layers, prim: Sdf.PrimSpec, *, hull: bool) -> None:
    """Write the stiffness of a collider's contacts for MuJoCo, and that Newton uses it as one hull."""
    if hull:
        apply(layers.runtime("newton", prim), "NewtonMeshCollisionAPI")
    mujoco = layers.runtime("mujoco", prim)
    apply(mujoco, "MjcCollisionAPI")
    values = {"mjc:solimp": _CONTACT_IMPEDANCE, "mjc:solref": _STIFF}
    write(mujoco, TYPES.DoubleArray, values, uniform=True)


def write_runtime_joint(
    layers: Layers, prim: Sdf.PrimSpec, asset: Asset, joint: AssetJoint, position: float
) -> None:
    """Write friction, armature, largest speed, coupling and initial position of a joint."""
    physx = layers.runtime("physx", prim)
    _physx_joint(physx, joint)
    if position != 0.0:
        _state(physx, joint, position)
    _newton_joint(layers.runtime("newton", prim), joint)
    _mujoco_joint(layers, prim, joint, position)
    if joint.follows is not None:
        _couple(layers, prim, (joint, asset.joint(joint.follows.leader)), joint.follows)


def _physx_joint(prim: Sdf.PrimSpec, joint: AssetJoint) -> None:
    apply(prim, f"PhysxJointAxisAPI:{instance_of(joint)}")
    prefix = f"physxJointAxis:{instance_of(joint)}:"
    values = {
        "armature": joint.armature,
        "dynamicFrictionEffort": joint.friction,
        "staticFrictionEffort": joint.friction,
    }
    # a coupled joint has its leader's speed: its own limit would fight the coupling
    if joint.follows is None:
        values["maxJointVelocity"] = joint.velocity * units_of(joint)
    write(prim, TYPES.Float, {prefix + name: values[name] for name in sorted(values)})


def _newton_joint(prim: Sdf.PrimSpec, joint: AssetJoint) -> None:
    apply(prim, "NewtonJointAPI")
    values = {"newton:armature": joint.armature, "newton:friction": joint.friction}
    if joint.follows is None:
        values["newton:velocityLimit"] = joint.velocity * units_of(joint)
    write(prim, TYPES.Float, values)


def _mujoco_joint(layers: Layers, prim: Sdf.PrimSpec, joint: AssetJoint, position: float) -> None:
    """Write the joint attributes of MJCF.

    MuJoCo does not read drives, so its variant has the spring and the damper as MuJoCo attributes, and none
    in the drive. Newton adds both, so without variants they are in the drive only.
    """
    mujoco = layers.runtime("mujoco", prim)
    apply(mujoco, "MjcJointAPI")
    values = {
        "mjc:actuatorfrcrange:max": joint.effort,
        "mjc:actuatorfrcrange:min": -joint.effort,
        "mjc:armature": joint.armature,
        "mjc:frictionloss": joint.friction,
    }
    if layers.apart:
        values |= {"mjc:damping": joint.damping, "mjc:stiffness": joint.stiffness}
        if joint.stiffness:
            values["mjc:springref"] = joint.rest * units_of(joint)
        if position != 0.0:
            values["mjc:ref"] = position * units_of(joint)
        if driven(joint):
            drive = f"drive:{instance_of(joint)}:physics:"
            write(mujoco, TYPES.Float, {drive + "damping": 0.0, drive + "stiffness": 0.0})
    write(mujoco, TYPES.Double, values, uniform=True)
    solver = {
        "mjc:solimpfriction": _FRICTION_IMPEDANCE,
        "mjc:solreffriction": _STIFF,
        "mjc:solreflimit": _STIFF,
    }
    write(mujoco, TYPES.DoubleArray, solver, uniform=True)


def _state(prim: Sdf.PrimSpec, joint: AssetJoint, position: float) -> None:
    """Write the initial position of the joint: PhysX assumes 0 by default, regardless of the bodies."""
    apply(prim, f"PhysicsJointStateAPI:{instance_of(joint)}")
    write(prim, TYPES.Float, {f"state:{instance_of(joint)}:physics:position": units_of(joint) * position})


def _couple(
    layers: Layers, prim: Sdf.PrimSpec, pair: tuple[AssetJoint, AssetJoint], coupling: AssetCoupling
) -> None:
    """Write the coupling for each simulator.

    PhysX holds `position + gearing * leader + offset = 0` in degrees and metres, and does the same for
    `NewtonMimicAPI`, `position = coef0 + coef1 * leader`. Newton takes coef1 in radians and metres. The two
    agree on joints of one kind only: between a rotation and a slide Newton is told by a schema that PhysX
    passes over, MuJoCo's equality in radians and metres, unless PhysX does not see Newton's words.
    """
    joint, leader = pair
    leader_path = prim.path.ReplaceName(leader.name)
    newton, mujoco = layers.runtime("newton", prim), layers.runtime("mujoco", prim)
    if layers.apart or joint.kind == leader.kind:
        apply(newton, "NewtonMimicAPI")
        relate(newton, "newton:mimicJoint", leader_path)
        offset = coupling.offset * units_of(joint)
        write(newton, TYPES.Float, {"newton:mimicCoef0": offset, "newton:mimicCoef1": coupling.ratio})
    if layers.apart or joint.kind != leader.kind:
        apply(mujoco, "MjcEqualityJointAPI")
        relate(mujoco, "mjc:target", leader_path)
        # MuJoCo counts from the initial positions, in which the coupling holds; Newton counts from 0
        offset = 0.0 if layers.apart else coupling.offset
        write(mujoco, TYPES.Double, {"mjc:coef0": offset, "mjc:coef1": coupling.ratio}, uniform=True)
        solver = {"mjc:solimp": _COUPLING_IMPEDANCE, "mjc:solref": _STIFF}
        write(mujoco, TYPES.DoubleArray, solver, uniform=True)
    _physx_coupling(layers.runtime("physx", prim), pair, coupling)


def _physx_coupling(prim: Sdf.PrimSpec, pair: tuple[AssetJoint, AssetJoint], coupling: AssetCoupling) -> None:
    joint, leader = pair
    # PhysX requires the name of a rotation axis for slides as well
    apply(prim, "PhysxMimicJointAPI:rotX")
    prefix = "physxMimicJoint:rotX:"
    gearing = coupling.ratio * units_of(joint) / units_of(leader)
    relate(prim, prefix + "referenceJoint", prim.path.ReplaceName(leader.name))
    write(prim, TYPES.Token, {prefix + "referenceJointAxis": "rotX"}, uniform=True)
    offset = coupling.offset * units_of(joint)
    write(prim, TYPES.Float, {prefix + "gearing": -gearing, prefix + "offset": -offset})
