"""Faults of a USD stage that do not depend on the asset; simulators silently ignore most of them."""

import re
from collections import Counter
from collections.abc import Iterator
from typing import Any

import numpy as np
from pxr import Usd, UsdGeom, UsdPhysics, UsdShade

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.asset.report import AGAIN, Finding

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
    """Yield foreign attributes of bodies, joints and colliders, and values that change with time."""
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


_CHECK = "usd"
_RIGID = 1e-6  # error of a body's axes


def placed(prim: Any) -> Array:
    """Return where a prim stands in the world, shape (4, 4)."""
    matrix = UsdGeom.Xformable(prim).ComputeLocalToWorldTransform(Usd.TimeCode.Default())
    return np.array(matrix).T


def stage_findings(stage: Any, asset: Asset) -> Iterator[Finding]:
    """Yield the faults of units, articulation, bodies, joints, colliders and materials of a stage."""
    prims = list(Usd.PrimRange(stage.GetPseudoRoot(), Usd.TraverseInstanceProxies()))
    bodies = [prim for prim in prims if prim.HasAPI(UsdPhysics.RigidBodyAPI)]
    links = {link.name for link in asset.links}
    yield from _unit_findings(stage)
    yield from _root_findings(prims, asset)
    for name, count in Counter(prim.GetName() for prim in bodies).items():
        if count > 1:
            message = f"{count} rigid bodies are named {name!r}"
            yield Finding(_CHECK, message, name if name in links else "", value=float(count), hint=AGAIN)
    for body in bodies:
        yield from _body_findings(body)
    joints = [prim for prim in prims if prim.IsA(UsdPhysics.Joint)]
    for name, count in Counter(prim.GetName() for prim in joints).items():
        if count > 1:
            message = f"{count} joints are named {name!r}"
            yield Finding(_CHECK, message, joint=name, value=float(count), hint=AGAIN)
    known = {body.GetPath() for body in bodies}
    stand = asset.positions()
    for joint in joints:
        yield from _joint_findings(joint, known)
        yield from _start_findings(joint, stand.get(joint.GetName(), 0.0))
    for prim in prims:
        yield from strange_opinions(prim)
        yield from _binding_findings(prim)
        yield from _contact_findings(prim)


def _unit_findings(stage: Any) -> Iterator[Finding]:
    for name, wanted in (("upAxis", "Z"), ("metersPerUnit", 1.0), ("kilogramsPerUnit", 1.0)):
        found = stage.GetMetadata(name) if stage.HasAuthoredMetadata(name) else None
        if found != wanted:
            said = "is missing" if found is None else f"is {found}"
            value = float(found) if isinstance(found, int | float) else None
            message = f"{name} {said}, not {wanted}: simulators take lengths, masses or directions for others"
            yield Finding(_CHECK, message, value=value, hint=AGAIN)
    if not stage.GetDefaultPrim():
        yield Finding(_CHECK, "it has no default prim, so nothing comes where it is referenced", hint=AGAIN)


def _root_findings(prims: list[Any], asset: Asset) -> Iterator[Finding]:
    roots = [prim for prim in prims if prim.HasAPI(UsdPhysics.ArticulationRootAPI)]
    if len(roots) != 1:
        where = ", ".join(str(prim.GetPath()) for prim in roots) or "none"
        message = f"it has {len(roots)} articulation roots ({where}); simulators need exactly one"
        yield Finding(_CHECK, message, asset.links[0].name, value=float(len(roots)), hint=AGAIN)


def _body_findings(body: Any) -> Iterator[Finding]:
    name, above = body.GetName(), body.GetParent()
    while above and not above.HasAPI(UsdPhysics.RigidBodyAPI):
        above = above.GetParent()
    if above:
        message = f"it is a rigid body within the rigid body {above.GetName()!r}"
        yield Finding(_CHECK, message, name, hint="make bodies siblings; or export the asset again")
    turn = placed(body)[:3, :3]
    error = float(np.abs(turn.T @ turn - np.eye(3)).max())
    if not (error <= _RIGID and np.linalg.det(turn) > 0.0):
        scales = ", ".join(f"{scale:.6g}" for scale in np.linalg.norm(turn, axis=0))
        yield Finding(_CHECK, f"its rigid body is scaled by {scales}", name, value=error, hint=AGAIN)
    api = UsdPhysics.RigidBodyAPI(body)
    if api.GetRigidBodyEnabledAttr().Get() is False:
        yield Finding(_CHECK, "its rigid body is disabled", name, hint=AGAIN)
    if api.GetKinematicEnabledAttr().Get():
        yield Finding(_CHECK, "its rigid body is kinematic, so nothing moves it", name, hint=AGAIN)


def _joint_findings(prim: Any, known: set[Any]) -> Iterator[Finding]:
    name, joint = prim.GetName(), UsdPhysics.Joint(prim)
    for what, relation in (("body0", joint.GetBody0Rel()), ("body1", joint.GetBody1Rel())):
        for target in relation.GetTargets():
            if target not in known:
                message = f"its {what} is {target}, which is no rigid body"
                yield Finding(_CHECK, message, joint=name, hint=AGAIN)
    if joint.GetJointEnabledAttr().Get() is False:
        yield Finding(_CHECK, "it is disabled", joint=name, hint=AGAIN)
    if joint.GetExcludeFromArticulationAttr().Get():
        yield Finding(_CHECK, "it is excluded from the articulation", joint=name, hint=AGAIN)
    if not (prim.IsA(UsdPhysics.RevoluteJoint) or prim.IsA(UsdPhysics.PrismaticJoint)):
        return
    low, high = (prim.GetAttribute(f"physics:{end}Limit").Get() for end in ("lower", "upper"))
    if low is not None and high is not None and low > high:
        message = f"its limits are inverted: from {low:.7g} to {high:.7g}"
        yield Finding(_CHECK, message, joint=name, value=float(high - low), hint=AGAIN)
    for kind in ("angular", "linear"):
        drive = prim.GetAttribute(f"drive:{kind}:physics:type")
        if drive and drive.HasAuthoredValue() and drive.Get() != "force":
            message = f"its drive is of the type {drive.Get()!r}, whose gains are not per newton but per mass"
            yield Finding(_CHECK, message, joint=name, hint=AGAIN)


def _start_findings(prim: Any, wanted: float) -> Iterator[Finding]:
    """Yield where a joint begins elsewhere than the asset stands."""
    for kind, unit in (("angular", np.pi / 180.0), ("linear", 1.0)):
        said = prim.GetAttribute(f"state:{kind}:physics:position")
        start = unit * float(said.Get()) if said and said.HasAuthoredValue() else wanted
        if not abs(start - wanted) <= _RIGID * max(1.0, abs(wanted)):
            message = f"it begins at {start:.7g}, not at {wanted:.7g}, where its body stands"
            yield Finding(_CHECK, message, joint=prim.GetName(), value=start, hint=AGAIN)


def _binding_findings(prim: Any) -> Iterator[Finding]:
    for relation in prim.GetRelationships():
        if not relation.GetName().startswith("material:binding"):
            continue
        for target in relation.GetTargets():
            material = prim.GetStage().GetPrimAtPath(target)
            if not material or not material.IsA(UsdShade.Material):
                message = f"{prim.GetPath()} is bound to the material {target}, which is not there"
                yield Finding(_CHECK, message, body_of(prim), hint=AGAIN)


def _contact_findings(prim: Any) -> Iterator[Finding]:
    if (
        prim.HasAPI(UsdPhysics.FilteredPairsAPI)
        and UsdPhysics.FilteredPairsAPI(prim).GetFilteredPairsRel().GetTargets()
    ):
        message = f"{prim.GetPath()} filters contacts, which hides parts that go through each other"
        yield Finding(_CHECK, message, body_of(prim), hint="remove PhysicsFilteredPairsAPI")
    collides = UsdPhysics.CollisionAPI(prim).GetCollisionEnabledAttr()
    if prim.HasAPI(UsdPhysics.CollisionAPI) and collides.Get() is False:
        message = f"its collider {prim.GetName()} is disabled"
        yield Finding(_CHECK, message, body_of(prim), hint=AGAIN)
