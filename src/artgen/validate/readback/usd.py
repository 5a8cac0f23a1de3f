"""Reading an exported USD with OpenUSD, and faults that simulators accept silently."""

import re
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from pxr import Gf, Usd, UsdGeom, UsdPhysics, UsdShade, UsdUtils, UsdValidation

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.asset.report import AGAIN, Finding
from artgen.colliders import Convex
from artgen.colliders.convex import Kind
from artgen.validate.readback.pieces import ReadCollider
from artgen.validate.readback.reading import Faces, Inertial, Law, Reading, Said, listening

_CHECK = "usd"
_RIGID = 1e-6  # tolerance of a body's axes and of start positions
_PHYSICS = re.compile(r"(physics|physx\w*|newton|mjc|drive|state|limit|isaac\w*|omni\w*):")
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
_UNREACHABLE = 1e5  # larger limits count as none; some simulators want limits on coupled joints [rad or m]


def element_findings(path: Path) -> Iterator[Finding]:
    """Yield nothing: the faults of a stage are found when it is read."""
    del path
    yield from ()


def placed(prim: Any) -> Array:
    """Return the transform of a prim to the world, shape (4, 4)."""
    matrix = UsdGeom.Xformable(prim).ComputeLocalToWorldTransform(Usd.TimeCode.Default())
    return np.array(matrix).T


def stage_findings(stage: Any, asset: Asset) -> Iterator[Finding]:
    """Yield faults of units, articulation, bodies, joints, contacts and materials of a stage."""
    prims = list(Usd.PrimRange(stage.GetPseudoRoot(), Usd.TraverseInstanceProxies()))
    bodies = [prim for prim in prims if prim.HasAPI(UsdPhysics.RigidBodyAPI)]
    joints = [prim for prim in prims if prim.IsA(UsdPhysics.Joint)]
    yield from _layer_findings(stage)
    roots = sum(prim.HasAPI(UsdPhysics.ArticulationRootAPI) for prim in prims)
    if roots != 1:
        message = f"it has {roots} articulation roots; simulators need exactly one"
        yield Finding(_CHECK, message, asset.links[0].name, value=float(roots), hint=AGAIN)
    for kind, found in (("link", bodies), ("joint", joints)):
        for name, count in Counter(prim.GetName() for prim in found).items():
            if count > 1:
                what = "rigid bodies" if kind == "link" else "joints"
                message = f"{count} {what} are named {name!r}"
                yield Finding(_CHECK, message, **{kind: name}, value=float(count), hint=AGAIN)
    for body in bodies:
        yield from _body_findings(body)
    known = {body.GetPath() for body in bodies}
    stand = asset.positions()
    for joint in joints:
        yield from _joint_findings(joint, known, stand.get(joint.GetName(), 0.0))
    for prim in prims:
        yield from _contact_findings(prim)
        yield from _attribute_findings(prim)


def _attribute_findings(prim: Any) -> Iterator[Finding]:
    """Yield physics attributes that artgen does not write, which some simulators obey, and time samples."""
    for kind, schema, known in (
        ("joint", prim.IsA(UsdPhysics.Joint), _JOINT),
        ("link", prim.HasAPI(UsdPhysics.RigidBodyAPI), _BODY),
        ("collider", prim.HasAPI(UsdPhysics.CollisionAPI), _COLLIDER),
    ):
        for attribute in prim.GetAuthoredAttributes() if schema else ():
            name, where = attribute.GetName(), prim.GetName()
            place = {"link": _body_name(prim)} if kind == "collider" else {kind: where}
            if attribute.ValueMightBeTimeVarying():
                yield Finding(_CHECK, f"{where} has a {name} that changes with time", **place, hint=AGAIN)
            if _PHYSICS.match(name) and not known.fullmatch(name):
                message = f"{where} has {name} = {attribute.Get()}, which does not belong to an asset"
                yield Finding(_CHECK, message, **place, hint=AGAIN)


def _layer_findings(stage: Any) -> Iterator[Finding]:
    for name, wanted in (("upAxis", "Z"), ("metersPerUnit", 1.0), ("kilogramsPerUnit", 1.0)):
        found = stage.GetMetadata(name) if stage.HasAuthoredMetadata(name) else "missing"
        if found != wanted:
            yield Finding(_CHECK, f"{name} is {found}, not {wanted}", hint=AGAIN)
    if not stage.GetDefaultPrim():
        yield Finding(_CHECK, "it has no default prim, so references to it are empty", hint=AGAIN)


def _body_findings(body: Any) -> Iterator[Finding]:
    name, above = body.GetName(), _body_name(body.GetParent())
    if above:
        yield Finding(_CHECK, f"it is a rigid body within the rigid body {above!r}", name, hint=AGAIN)
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


def _body_name(prim: Any) -> str:
    """Return the name of the rigid body of a prim or its nearest ancestor; empty if there is none."""
    while prim and not prim.HasAPI(UsdPhysics.RigidBodyAPI):
        prim = prim.GetParent()
    return str(prim.GetName()) if prim else ""


def _joint_findings(prim: Any, known: set[Any], stand: float) -> Iterator[Finding]:
    """Yield faults of a joint; `stand` is its position in the asset at rest [rad or m]."""
    name, joint = prim.GetName(), UsdPhysics.Joint(prim)
    for what, relation in (("body0", joint.GetBody0Rel()), ("body1", joint.GetBody1Rel())):
        for target in relation.GetTargets():
            if target not in known:
                message = f"its {what} is {target}, which is not a rigid body"
                yield Finding(_CHECK, message, joint=name, hint=AGAIN)
    if joint.GetJointEnabledAttr().Get() is False:
        yield Finding(_CHECK, "it is disabled", joint=name, hint=AGAIN)
    if joint.GetExcludeFromArticulationAttr().Get():
        yield Finding(_CHECK, "it is excluded from the articulation", joint=name, hint=AGAIN)
    low, high = (prim.GetAttribute(f"physics:{end}Limit").Get() for end in ("lower", "upper"))
    if low is not None and high is not None and low > high:
        message = f"its limits are inverted: from {low:.7g} to {high:.7g}"
        yield Finding(_CHECK, message, joint=name, value=float(high - low), hint=AGAIN)
    for kind, unit in (("angular", np.pi / 180.0), ("linear", 1.0)):
        drive = prim.GetAttribute(f"drive:{kind}:physics:type")
        if drive and drive.HasAuthoredValue() and drive.Get() != "force":
            message = f"its drive has the type {drive.Get()!r} instead of 'force'"
            yield Finding(_CHECK, message, joint=name, hint=AGAIN)
        start = prim.GetAttribute(f"state:{kind}:physics:position")
        position = unit * float(start.Get()) if start and start.HasAuthoredValue() else stand
        if not abs(position - stand) <= _RIGID * max(1.0, abs(stand)):
            message = f"it begins at {position:.7g}, not at {stand:.7g}, where its body stands"
            yield Finding(_CHECK, message, joint=name, value=position, hint=AGAIN)


def _contact_findings(prim: Any) -> Iterator[Finding]:
    """Yield filtered contacts, disabled colliders and bindings of missing materials."""
    link = _body_name(prim)
    filtered = UsdPhysics.FilteredPairsAPI(prim).GetFilteredPairsRel()
    if filtered and filtered.GetTargets():
        message = f"{prim.GetPath()} filters contacts, which hides parts that penetrate each other"
        yield Finding(_CHECK, message, link, hint="remove PhysicsFilteredPairsAPI")
    collides = UsdPhysics.CollisionAPI(prim).GetCollisionEnabledAttr()
    if prim.HasAPI(UsdPhysics.CollisionAPI) and collides.Get() is False:
        yield Finding(_CHECK, f"its collider {prim.GetName()} is disabled", link, hint=AGAIN)
    for relation in prim.GetRelationships():
        for target in relation.GetTargets() if relation.GetName().startswith("material:binding") else ():
            material = prim.GetStage().GetPrimAtPath(target)
            if not material or not material.IsA(UsdShade.Material):
                message = f"{prim.GetPath()} is bound to the material {target}, which does not exist"
                yield Finding(_CHECK, message, link, hint=AGAIN)


@dataclass(frozen=True, eq=False)
class Arm:
    """A joint of a stage: motion along or about an axis of its frames."""

    prim: Any  # the prim; it lives as long as its stage
    name: str  # name of the joint
    kind: str  # `revolute`, `prismatic`, or empty for a fixed joint
    parent: str  # name of the parent body; empty for the world
    child: str  # name of the child body; empty for the world
    before: Array  # its frame in the parent, shape (4, 4)
    after: Array  # its frame in the child, shape (4, 4)
    column: int = 0  # number of the axis: 0 for x
    limits: tuple[float, float] | None = None  # lowest and highest position [rad or m]

    @property
    def to_world(self) -> bool:
        """Whether it fixes a body to the world."""
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
    """Yield the enabled joints of a stage."""
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
    # Gf.Rotation would lose precision near 0: its angle is an arccosine
    result[:3, :3] = np.array(Gf.Matrix3d(Gf.Quatd(rotation).GetNormalized())).T
    result[:3, 3] = position
    return result


def dynamics(arm: Arm) -> Iterator[Said]:
    """Yield the dynamics of a joint in UsdPhysics and in the schemas of simulators; missing values are 0."""
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
    """Yield spring and damper: the sum of the drive and the attributes of MuJoCo, as one of them is 0."""
    for field in ("stiffness", "damping"):
        of_mujoco = _value(prim, f"mjc:{field}") or 0.0
        name = f"mjc:{field}" if of_mujoco else f"{drive}{field}"
        yield Said(field, (_value(prim, f"{drive}{field}") or 0.0) / unit + of_mujoco, name)
    name = "mjc:springref" if _value(prim, "mjc:stiffness") else f"{drive}targetPosition"
    yield Said("rest", (_value(prim, name) or 0.0) * unit, name)


def applied(prim: Any) -> list[str]:
    """Return the API schemas of a prim, including those unknown to OpenUSD."""
    schemas = prim.GetMetadata("apiSchemas")
    return [] if schemas is None else list(schemas.GetAppliedItems())


def _value(prim: Any, name: str) -> float | None:
    attribute = prim.GetAttribute(name)
    value = attribute.Get() if attribute else None
    return None if value is None else float(value)


def couplings(stage: Any, schema: str) -> dict[str, tuple[str, float, float]]:
    """Return couplings [rad, m] of one schema: `newton:mimicJoint` or `mjc:target`."""
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
    """Return couplings of PhysX: position + gearing * leader + offset = 0 in degrees and metres."""
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


_ENABLED = "Enabled"
_NEWTON, _PHYSX, _MUJOCO = "Newton", "PhysX", "MuJoCo"


@dataclass(frozen=True, eq=False)
class RuntimeProfile:
    """Joints of a stage for one simulator."""

    dynamics: dict[str, tuple[Said, ...]]  # springs, friction and so on of each joint
    couplings: dict[str, dict[str, Law]]  # leader, ratio and offset of each joint that follows, by simulator


def variants(stage: Any) -> Iterator[str]:
    """Enable the variants of a stage for single simulators one after the other, and yield their names.

    A stage without such variants yields an empty name once. At the end, no variant is enabled.
    """
    root = stage.GetDefaultPrim()
    names = list(root.GetVariantSets().GetNames()) if root else []
    names = [name for name in names if _ENABLED in root.GetVariantSet(name).GetVariantNames()]
    if not names:
        yield ""
    for name in names:
        layer = stage.GetSessionLayer()
        with Usd.EditContext(stage, layer):
            root.GetVariantSet(name).SetVariantSelection(_ENABLED)
        yield name
        layer.Clear()


def profile(stage: Any, asset: Asset, variant: str) -> RuntimeProfile:
    """Read a stage with a variant enabled."""
    said = {arm.name: tuple(dynamics(arm)) for arm in arms(stage) if arm.kind and arm.parent}
    if variant == _PHYSX:
        return RuntimeProfile(said, {_PHYSX: physx_couplings(stage)})
    if variant == _MUJOCO:
        return RuntimeProfile(said, {_MUJOCO: _of_mujoco(couplings(stage, "mjc:target"), asset)})
    # between a rotation and a slide, Newton reads the schema of MuJoCo, with positions counted from 0
    of_newton = couplings(stage, "mjc:target") | couplings(stage, "newton:mimicJoint")
    result = {_NEWTON: of_newton}
    if not variant:
        result[_PHYSX] = physx_couplings(stage)
    return RuntimeProfile(said, result)


def _of_mujoco(laws: dict[str, Law], asset: Asset) -> dict[str, Law]:
    """Convert couplings of MuJoCo, which relate displacements from the initial positions."""
    positions = asset.positions()
    return {
        follower: (
            leader,
            ratio,
            offset + positions.get(follower, 0.0) - ratio * positions.get(leader, 0.0),
        )
        for follower, (leader, ratio, offset) in laws.items()
    }


_MATERIAL_X = re.compile(r"MissingShaderIdInRegistry: shaderId 'ND_\w+' ")
_TURNS = {"X": np.eye(3)[:, [1, 2, 0]], "Y": np.eye(3)[:, [2, 0, 1]], "Z": np.eye(3)}  # from z to an axis


def read(asset: Asset, path: Path) -> Reading:
    """Read a stage, and run OpenUSD's validators on it."""
    with listening() as said:
        diagnostics = UsdUtils.CoalescingDiagnosticDelegate()
        stage = Usd.Stage.Open(str(path))
        stage.Reload()  # open layers would hide newer files
        profiles = []
        for variant in variants(stage):
            said.extend(_validated(stage))
            profiles.append(profile(stage, asset, variant))
        said.extend(item.commentary for item in diagnostics.TakeUncoalescedDiagnostics())
        del diagnostics  # OpenUSD prints again
    bodies = {prim.GetName(): prim for prim in stage.Traverse() if prim.HasAPI(UsdPhysics.RigidBodyAPI)}
    found_arms = list(arms(stage))
    moving = {arm.name: arm for arm in found_arms if arm.kind and arm.parent}
    links = [link.name for link in asset.links if link.name in bodies]
    base = asset.links[0].name
    start = placed(bodies[base]) if base in bodies else np.eye(4)
    masses = {name: UsdPhysics.MassAPI(prim).GetMassAttr().Get() for name, prim in bodies.items()}
    joined = [arm for arm in found_arms if arm.parent and arm.child]
    laws = {simulator: law for each in profiles for simulator, law in each.couplings.items()}
    return Reading(
        path.name,
        lambda positions: _frames(joined, base, start, links, positions),
        standing={name: placed(bodies[name]) for name in links},
        inertials={name: _inertial(bodies[name]) for name in links if _weighed(bodies[name])},
        mass=float(sum(mass or 0.0 for mass in masses.values())),
        base="fixed"
        if any(base in (arm.parent, arm.child) and arm.to_world for arm in found_arms)
        else "free",
        kinds={name: arm.kind for name, arm in moving.items()},
        ends={name: (arm.parent, arm.child) for name, arm in moving.items()},
        limits={name: arm.limits for name, arm in moving.items()},
        axes={name: arm.after[:3, arm.column] for name, arm in moving.items()},
        dynamics={
            name: tuple(dict.fromkeys(said for each in profiles for said in each.dynamics.get(name, ())))
            for name in moving
        },
        couplings=laws.pop("Newton", {}),
        more_couplings=laws,
        colliders={name: tuple(_colliders(bodies[name])) for name in links},
        faces={name: tuple(_faces(bodies[name])) for name in links},
        holds=_holds(asset, bodies),
        findings=tuple(stage_findings(stage, asset)),
        said=tuple(said),
    )


def _validated(stage: Any) -> list[str]:
    """Return the findings of OpenUSD's validators for a stage.

    Findings about shaders of MaterialX are dropped: OpenUSD from PyPI is built without MaterialX.
    """
    registry = UsdValidation.ValidationRegistry()
    context = UsdValidation.ValidationContext(registry.GetOrLoadAllValidators())
    said = [f"{error.GetName()}: {error.GetMessage()}" for error in context.Validate(stage)]
    return [text for text in said if not _MATERIAL_X.match(text)]


def _frames(
    remaining: list[Arm], base: str, start: Array, links: list[str], positions: Mapping[str, float]
) -> dict[str, Array]:
    """Return the frames of the links that joints connect to the base."""
    found = {base: start}
    while remaining:
        ready = [arm for arm in remaining if arm.parent in found]
        if not ready:
            break
        for arm in ready:
            motion = arm.before @ arm.motion(positions.get(arm.name, 0.0)) @ np.linalg.inv(arm.after)
            found[arm.child] = found[arm.parent] @ motion
        remaining = [arm for arm in remaining if arm not in ready]
    return {name: found[name] for name in links if name in found}


def _weighed(prim: Any) -> bool:
    api = UsdPhysics.MassAPI(prim)
    attributes = (
        api.GetMassAttr(), api.GetCenterOfMassAttr(), api.GetDiagonalInertiaAttr(), api.GetPrincipalAxesAttr()
    )  # fmt: skip
    return all(attribute and attribute.Get() is not None for attribute in attributes)


def _inertial(prim: Any) -> Inertial:
    api = UsdPhysics.MassAPI(prim)
    turn = pose((0.0, 0.0, 0.0), api.GetPrincipalAxesAttr().Get())[:3, :3]
    diagonal = np.diag(np.array(api.GetDiagonalInertiaAttr().Get(), float))
    center = np.array(api.GetCenterOfMassAttr().Get(), float)
    return Inertial(float(api.GetMassAttr().Get()), center, turn @ diagonal @ turn.T)


def _below(body: Any) -> Iterator[tuple[Any, Array]]:
    """Yield the prims below a body, including instances, with their transforms to the body."""
    inverse = np.linalg.inv(placed(body))
    for prim in Usd.PrimRange(body, Usd.TraverseInstanceProxies()):
        if prim.IsA(UsdGeom.Xformable):
            yield prim, inverse @ placed(prim)


def _colliders(body: Any) -> Iterator[ReadCollider]:
    for prim, matrix in _below(body):
        if prim.HasAPI(UsdPhysics.CollisionAPI):
            yield _piece(prim, matrix)


def _piece(prim: Any, matrix: Array) -> ReadCollider:
    name, friction = prim.GetName(), _friction(prim)
    if prim.IsA(UsdGeom.Mesh):
        return ReadCollider.mesh(name, *_mesh(prim, matrix), friction, _approximation_flaw(prim))
    scales = np.linalg.norm(matrix[:3, :3], axis=0)
    rigid = matrix.copy()
    rigid[:3, :3] /= scales
    if prim.IsA(UsdGeom.Cube):
        size = scales * float(UsdGeom.Cube(prim).GetSizeAttr().Get())
        return ReadCollider.primitive(name, Convex("box", rigid, tuple(map(float, size))), friction)
    flaw = "" if np.abs(scales - 1.0).max() <= 1e-6 else f"is round and scaled by {scales.max():.6g}"
    radius = float(prim.GetAttribute("radius").Get())
    if prim.IsA(UsdGeom.Sphere):
        return ReadCollider.primitive(name, Convex("sphere", rigid, (radius,)), friction, flaw)
    rigid[:3, :3] = rigid[:3, :3] @ _TURNS[prim.GetAttribute("axis").Get()]
    if not (prim.IsA(UsdGeom.Cylinder) or prim.IsA(UsdGeom.Capsule)):
        flaw = f"has an unknown type ({prim.GetTypeName()})"
    kind: Kind = "cylinder" if prim.IsA(UsdGeom.Cylinder) else "capsule"
    convex = Convex(kind, rigid, (radius, float(prim.GetAttribute("height").Get())))
    return ReadCollider.primitive(name, convex, friction, flaw)


def _approximation_flaw(prim: Any) -> str:
    how = UsdPhysics.MeshCollisionAPI(prim).GetApproximationAttr()
    said = how.Get() if prim.HasAPI(UsdPhysics.MeshCollisionAPI) and how.HasAuthoredValue() else "none"
    return "" if said == "convexHull" else f"has the approximation {said!r}, not 'convexHull'"


def _friction(prim: Any) -> float | None:
    """Return the friction of a collider's material; 0 for a missing material."""
    binding = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial("physics")[0]
    if not binding or not binding.GetPrim().HasAPI(UsdPhysics.MaterialAPI):
        return 0.0
    value = UsdPhysics.MaterialAPI(binding.GetPrim()).GetDynamicFrictionAttr().Get()
    return float(value or 0.0)


def _mesh(prim: Any, matrix: Array) -> tuple[Array, NDArray[np.int64]]:
    mesh = UsdGeom.Mesh(prim)
    corners = np.array(mesh.GetFaceVertexIndicesAttr().Get(), np.int64).reshape(-1, 3)
    points = np.array(mesh.GetPointsAttr().Get(), float)
    return points @ matrix[:3, :3].T + matrix[:3, 3], corners


def _faces(body: Any) -> Iterator[Faces]:
    for prim, matrix in _below(body):
        if prim.IsA(UsdGeom.Mesh) and not prim.HasAPI(UsdPhysics.CollisionAPI):
            yield Faces.of(prim.GetName(), *_mesh(prim, matrix))


def _holds(asset: Asset, bodies: Mapping[str, Any]) -> dict[str, tuple[str, Array]]:
    """Return the frames of grasps and pushes: prims with their names below the bodies."""
    wanted = {hold.name for hold in asset.affordances}
    found = {}
    for name, body in bodies.items():
        for prim, matrix in _below(body):
            if prim.GetName() in wanted and prim.IsA(UsdGeom.Xformable) and not prim.IsA(UsdGeom.Gprim):
                found[prim.GetName()] = (name, matrix)
    return found
