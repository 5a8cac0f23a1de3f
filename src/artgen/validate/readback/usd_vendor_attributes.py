"""What prims of physics may say in a USD stage: what else they say, single simulators obey."""

import re
from collections.abc import Iterator
from typing import Any

from pxr import UsdGeom, UsdPhysics

from artgen.asset.report import Finding

_CHECK = "usd"
_HINT = "put opinions of your own into a layer above; or export the asset again"
_BODY = re.compile(
    r"physics:(mass|centerOfMass|diagonalInertia|principalAxes|rigidBodyEnabled|kinematicEnabled)"
    r"|physxRigidBody:angularDamping|(physxArticulation|newton):\w*[sS]elfCollision\w*"
    r"|physxArticulation:solverPositionIterationCount"
)
_JOINT = re.compile(
    r"physics:(axis|local(Pos|Rot)[01]|(lower|upper)Limit|jointEnabled|excludeFromArticulation)"
    r"|drive:(angular|linear):physics:(damping|maxForce|stiffness|targetPosition|type)"
    r"|mjc:(actuatorfrcrange:(max|min)|armature|coef[01]|damping|frictionloss|ref|springref|stiffness)"
    r"|mjc:sol(imp|ref)(friction|limit)?"
    r"|newton:(armature|friction|velocityLimit|mimicCoef[01]|mimicEnabled)"
    r"|physxJointAxis:(angular|linear):(armature|(dynamic|static)FrictionEffort|maxJointVelocity)"
    r"|physxMimicJoint:\w+:(gearing|offset|referenceJointAxis)|state:(angular|linear):physics:position"
)
_COLLIDER = re.compile(r"physics:(approximation|collisionEnabled)|mjc:sol(imp|ref)|newton:maxHullVertices")
_PHYSICS = re.compile(r"(physics|physx\w*|newton|mjc|drive|state|limit|isaac\w*|omni\w*):")
_ZERO = ("physxRigidBody:angularDamping",)  # PhysX damps by itself where it is not told 0


def strange_opinions(prim: Any) -> Iterator[Finding]:
    """Yield what a body, joint or collider says that no asset says, and values that change with time."""
    joint = prim.IsA(UsdPhysics.Joint)
    body = prim.HasAPI(UsdPhysics.RigidBodyAPI)
    known = (
        _JOINT if joint else _BODY if body else _COLLIDER if prim.HasAPI(UsdPhysics.CollisionAPI) else None
    )
    if known is None:
        return
    name = prim.GetName()
    where = {"joint": name} if joint else {"link": name if body else body_of(prim)}
    text = "it" if joint or body else f"its collider {name}"
    for attribute in prim.GetAuthoredAttributes():
        said = attribute.GetName()
        if attribute.ValueMightBeTimeVarying():
            yield Finding(_CHECK, f"{text} has a {said} that changes with time", **where, hint=_HINT)
        if _PHYSICS.match(said) and not known.fullmatch(said):
            message = f"{text} says {said} = {attribute.Get()}, which is no part of an asset"
            yield Finding(_CHECK, message, **where, hint=_HINT)
        elif said in _ZERO and attribute.Get() != 0.0:
            message = f"{text} says {said} = {attribute.Get()}, not 0"
            yield Finding(_CHECK, message, **where, hint=_HINT)
    if body and UsdGeom.Imageable(prim).ComputeVisibility() == UsdGeom.Tokens.invisible:
        yield Finding(_CHECK, "it is invisible", **where, hint=_HINT)


def body_of(prim: Any) -> str:
    """Return the name of the rigid body that a prim belongs to; empty if to none."""
    while prim and not prim.HasAPI(UsdPhysics.RigidBodyAPI):
        prim = prim.GetParent()
    return str(prim.GetName()) if prim else ""
