"""Reading an exported USD with OpenUSD, and faults that simulators accept silently."""

import os
import re
from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from pxr import Gf, Sdf, Usd, UsdGeom, UsdPhysics, UsdShade, UsdUtils, UsdValidation
from scipy.spatial.transform import Rotation

from artgen._arrays import Array, Indices, affine
from artgen.asset import Asset
from artgen.asset.report import AGAIN, Finding
from artgen.colliders import Convex
from artgen.colliders.convex import Kind
from artgen.validate.readback.reading import (
    UNLIMITED,
    Faces,
    Inertial,
    Law,
    ReadCollider,
    Reading,
    ReadJoint,
    Stated,
    collected_messages,
)

_ENABLED = "Enabled"
_NEWTON, _PHYSX, _MUJOCO = "Newton", "PhysX", "MuJoCo"
_MASS = ("mass", "centerOfMass", "diagonalInertia", "principalAxes")
_DEGREE = np.pi / 180.0
_MATERIAL_X = re.compile(r"MissingShaderIdInRegistry: shaderId 'ND_\w+' ")
_TURNS = {"X": np.eye(3)[:, [1, 2, 0]], "Y": np.eye(3)[:, [2, 0, 1]], "Z": np.eye(3)}  # from z to an axis
_ROUND: dict[str, Kind] = {"Sphere": "sphere", "Cylinder": "cylinder", "Capsule": "capsule"}
_RIGID = 1e-6  # tolerance of a body's axes and of start positions
_PHYSICS = re.compile(r"(physics|physx\w*|newton|mjc|drive|state|limit|isaac\w*|omni\w*):")
_BODY = re.compile(
    r"physics:(mass|centerOfMass|diagonalInertia|principalAxes|rigidBodyEnabled|kinematicEnabled)"
    r"|physxRigidBody:angularDamping|(physxArticulation|newton):\w*[sS]elfCollision\w*"
    r"|physxArticulation:solverPositionIterationCount"
)
_ROOT = re.compile(
    r"newton:selfCollisionEnabled|physxArticulation:(enabledSelfCollisions|solver\w+IterationCount)"
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
# attributes that a simulator obeys silently: the value that is a fault, and the message
_SWITCHES = {
    "physics:rigidBodyEnabled": (False, "its rigid body is disabled"),
    "physics:kinematicEnabled": (True, "its rigid body is kinematic, so nothing moves it"),
    "physics:jointEnabled": (False, "it is disabled"),
    "physics:collisionEnabled": (False, "its collider {} is disabled"),
}
_UNREACHABLE = 1e5  # larger limits count as none; some simulators want limits on coupled joints [rad or m]


_fault = partial(Finding, "usd", hint=AGAIN)


def _placed(prim: Any) -> Array:
    """Return the transform of a prim to the world, shape (4, 4)."""
    matrix = UsdGeom.Xformable(prim).ComputeLocalToWorldTransform(Usd.TimeCode.Default())
    return np.array(matrix).T


def _stage_findings(stage: Any, asset: Asset) -> Iterator[Finding]:
    """Yield faults of units, articulation, bodies, joints, contacts and materials of a stage."""
    prims = list(Usd.PrimRange(stage.GetPseudoRoot(), Usd.TraverseInstanceProxies()))
    bodies = [prim for prim in prims if prim.HasAPI(UsdPhysics.RigidBodyAPI)]
    joints = [prim for prim in prims if prim.IsA(UsdPhysics.Joint)]
    yield from _layer_findings(stage)
    yield from _pin_findings([joint for joint in joints if _is_pin(joint)], asset)
    roots = sum(prim.HasAPI(UsdPhysics.ArticulationRootAPI) for prim in prims)
    wanted = 1 + sum(any(joint.parent == name for joint in asset.joints) for name in asset.loose)
    if roots != wanted:
        message = f"it has {roots} articulation roots; simulators need exactly {wanted}"
        yield _fault(message, asset.links[0].name, value=float(roots))
    for kind, text, named in (("link", "rigid bodies", bodies), ("joint", "joints", joints)):
        for name, count in Counter(prim.GetName() for prim in named).items():
            if count > 1:
                yield _fault(f"{count} {text} are named {name!r}", value=float(count), **{kind: name})
    for body in bodies:
        yield from _body_findings(body)
    known = {body.GetPath() for body in bodies}
    positions = asset.positions()
    for joint in joints:
        yield from _joint_findings(joint, known, positions.get(joint.GetName(), 0.0))
    off = {
        (link.name, f"{collider.convex.kind}_{number}")
        for link in asset.links
        for number, collider in enumerate(link.colliders)
        if collider.spare
    }
    for prim in prims:
        yield from _contact_findings(prim)
        yield from _attribute_findings(prim, off)


def _is_pin(joint: Any) -> bool:
    """Tell whether a joint is outside the articulation, as pins of closed chains are."""
    return bool(_get(joint, "physics:excludeFromArticulation", False))


def _pin_findings(pins: Sequence[Any], asset: Asset) -> Iterator[Finding]:
    """Yield joints outside the articulation that close no chain, and chains that none closes."""
    wanted = list(asset.loops)
    for pin in pins:
        links = _ends(pin)
        places = [np.array(_get(pin, f"physics:localPos{end}", np.nan)) for end in (0, 1)]
        closed = [
            loop
            for loop in wanted
            if loop.links == links
            and pin.IsA(UsdPhysics.RevoluteJoint)
            and all(
                np.allclose(place, loop.point - asset.origin(name), rtol=0.0, atol=_RIGID)
                for place, name in zip(places, links, strict=True)
            )
        ]
        if not closed:
            yield _fault("it is excluded from the articulation", joint=pin.GetName())
        for loop in closed[:1]:
            wanted.remove(loop)
    for loop in wanted:
        yield _fault("no pin closes their chain", ", ".join(loop.links))


def _layer_findings(stage: Any) -> Iterator[Finding]:
    for name, wanted in (("upAxis", "Z"), ("metersPerUnit", 1.0), ("kilogramsPerUnit", 1.0)):
        found = stage.GetMetadata(name) if stage.HasAuthoredMetadata(name) else "missing"
        if found != wanted:
            yield _fault(f"{name} is {found}, not {wanted}")
    if not stage.GetDefaultPrim():
        yield _fault("it has no default prim, so references to it are empty")
    folder = os.path.realpath(Path(stage.GetRootLayer().realPath).parent)
    values = [attribute.Get() for prim in stage.TraverseAll() for attribute in prim.GetAuthoredAttributes()]
    named = [each.realPath for each in stage.GetUsedLayers() if not each.anonymous]
    named += [each.resolvedPath or each.path for each in values if isinstance(each, Sdf.AssetPath)]
    for name in dict.fromkeys(named):
        if not Path(os.path.realpath(os.path.join(folder, name))).is_relative_to(folder):  # noqa: PTH118
            yield _fault(f"it reads {name[-80:]!r}, which is outside its folder")


def _is_finite(value: Any) -> bool:
    """Tell whether a vector or a quaternion has finite numbers."""
    turns = isinstance(value, Gf.Quatf | Gf.Quatd | Gf.Quath)
    return bool(np.isfinite([value.GetReal(), *value.GetImaginary()] if turns else [*value]).all())


def _attribute_findings(prim: Any, off: Collection[tuple[str, str]]) -> Iterator[Finding]:
    """Yield attributes that switch a prim off, change with time, or are not those that artgen writes."""
    where = prim.GetName()
    for place, schema, known in (
        ({"joint": where}, prim.IsA(UsdPhysics.Joint), _JOINT),
        ({"link": where}, prim.HasAPI(UsdPhysics.RigidBodyAPI), _BODY),
        ({"link": _body_name(prim)}, prim.HasAPI(UsdPhysics.CollisionAPI), _COLLIDER),
    ):
        for attribute in prim.GetAuthoredAttributes() if schema else ():
            name = attribute.GetName()
            value = attribute.Get()
            if name == "physics:axis" and value not in _TURNS:
                yield _fault(f"{where} has the {name} {value!r}, not 'X', 'Y' or 'Z'", **place)
            if name.startswith("physics:local") and not _is_finite(value):
                yield _fault(f"{where} has the {name} {value}, which is not finite", **place)
            if attribute.ValueMightBeTimeVarying():
                yield _fault(f"{where} has a {name} that changes with time", **place)
            fault, message = _SWITCHES.get(name, (None, ""))
            if name == "physics:collisionEnabled" and (place.get("link"), where) in off:
                continue  # a spare collider of a padded asset
            if value == fault and message:
                yield _fault(message.format(where), **place)
            of_root = prim.HasAPI(UsdPhysics.ArticulationRootAPI) and _ROOT.fullmatch(name)
            if _PHYSICS.match(name) and not known.fullmatch(name) and not of_root:
                message = f"{where} has {name} = {attribute.Get()}, which does not belong to an asset"
                yield _fault(message, **place)


def _body_findings(body: Any) -> Iterator[Finding]:
    name, above = body.GetName(), _body_name(body.GetParent())
    if above:
        yield _fault(f"it is a rigid body within the rigid body {above!r}", name)
    turn = _placed(body)[:3, :3]
    error = float(np.abs(turn.T @ turn - np.eye(3)).max())
    if not (error <= _RIGID and np.linalg.det(turn) > 0.0):
        scales = ", ".join(f"{scale:.6g}" for scale in np.linalg.norm(turn, axis=0))
        yield _fault(f"its rigid body is scaled by {scales}", name, value=error)


def _body_name(prim: Any) -> str:
    """Return the name of the rigid body of a prim or its nearest ancestor; empty if there is none."""
    while prim and not prim.HasAPI(UsdPhysics.RigidBodyAPI):
        prim = prim.GetParent()
    return str(prim.GetName()) if prim else ""


def _joint_findings(prim: Any, known: set[Any], start: float) -> Iterator[Finding]:
    """Yield faults of a joint; `start` is its position in the asset at rest [rad or m]."""
    fault = partial(_fault, joint=prim.GetName())
    for name in ("body0", "body1"):
        for target in prim.GetRelationship(f"physics:{name}").GetTargets():
            if target not in known:
                yield fault(f"its {name} is {target}, which is not a rigid body")
    low, high = (_get(prim, f"physics:{end}Limit") for end in ("lower", "upper"))
    if low is not None and high is not None and low > high:
        message = f"its limits are inverted: from {low:.7g} to {high:.7g}"
        yield fault(message, value=float(high - low))
    for kind, unit in (("angular", _DEGREE), ("linear", 1.0)):
        drive = _get(prim, f"drive:{kind}:physics:type", "force")
        if drive != "force":
            yield fault(f"its drive has the type {drive!r} instead of 'force'")
        position = unit * float(_get(prim, f"state:{kind}:physics:position", start / unit))
        if not abs(position - start) <= _RIGID * max(1.0, abs(start)):
            message = f"it begins at {position:.7g}, not at {start:.7g}, where its body stands"
            yield fault(message, value=position)


def _contact_findings(prim: Any) -> Iterator[Finding]:
    """Yield filtered contacts and bindings of missing materials."""
    link = _body_name(prim)
    filtered = UsdPhysics.FilteredPairsAPI(prim).GetFilteredPairsRel()
    if filtered and filtered.GetTargets():
        message = f"{prim.GetPath()} filters contacts, which hides parts that penetrate each other"
        yield _fault(message, link, hint="remove PhysicsFilteredPairsAPI")
    for relation in prim.GetRelationships():
        for target in relation.GetTargets() if relation.GetName().startswith("material:binding") else ():
            material = prim.GetStage().GetPrimAtPath(target)
            if not material or not material.IsA(UsdShade.Material):
                message = f"{prim.GetPath()} is bound to the material {target}, which does not exist"
                yield _fault(message, link)


@dataclass(frozen=True, eq=False)
class _Arm:
    """A joint of a stage: motion along or about an axis of its frames."""

    prim: Any  # the prim; it lives as long as its stage
    name: str  # name of the joint
    kind: str  # `revolute`, `prismatic`, or empty for a fixed joint
    parent: str  # name of the parent body; empty for the world
    child: str  # name of the child body; empty for the world
    before: Array  # its frame in the parent, shape (4, 4)
    after: Array  # its frame in the child, shape (4, 4)
    column: int = 0  # number of the axis: 0 for x

    @property
    def limits(self) -> tuple[float, float]:
        """Lowest and highest position [rad or m]."""
        low, high = (_unit(self.prim) * _get(self.prim, f"physics:{end}Limit") for end in ("lower", "upper"))
        reachable = np.isfinite(low) and np.isfinite(high) and high < _UNREACHABLE
        return (float(low), float(high)) if reachable else UNLIMITED

    def motion(self, position: float) -> Array:
        """Return the motion at a position, shape (4, 4)."""
        way = position * np.eye(3)[self.column]
        if self.kind == "revolute":
            return affine(Rotation.from_rotvec(way).as_matrix())
        return affine(np.eye(3), way if self.kind else 0.0)


def _arms(stage: Any, asset: Asset) -> Iterator[_Arm]:
    """Yield the enabled joints of a stage, without the pins of closed chains."""
    for prim in stage.Traverse():
        if not prim.IsA(UsdPhysics.Joint) or _get(prim, "physics:jointEnabled") is False:
            continue
        if _is_pin(prim) and prim.GetName() not in asset.joints.by_name:
            continue
        parent, child = _ends(prim)
        before, after = (
            _pose(*(_get(prim, f"physics:local{part}{end}") for part in ("Pos", "Rot"))) for end in (0, 1)
        )
        kinds = {"revolute": UsdPhysics.RevoluteJoint, "prismatic": UsdPhysics.PrismaticJoint}
        kind = next((kind for kind, schema in kinds.items() if prim.IsA(schema)), "")
        column = "XYZ".find(str(_get(prim, "physics:axis"))) if kind else 0
        yield _Arm(prim, prim.GetName(), kind, parent, child, before, after, max(column, 0))


def _ends(joint: Any) -> tuple[str, str]:
    """Return the names of the bodies of a joint; empty for the world."""
    targets = [joint.GetRelationship(f"physics:body{end}").GetTargets() for end in (0, 1)]
    parent, child = (paths[0].name if paths else "" for paths in targets)
    return parent, child


def _pose(position: Any, rotation: Any) -> Array:
    """Return position and quaternion of OpenUSD as a transform, shape (4, 4)."""
    # Gf.Rotation would lose precision near 0: its angle is an arccosine
    return affine(np.array(Gf.Matrix3d(Gf.Quatd(rotation).GetNormalized())).T, position)


def _dynamics(arm: _Arm) -> Iterator[Stated]:
    """Yield the dynamics of a joint in UsdPhysics and in the schemas of simulators; missing values are 0."""
    prim, unit = arm.prim, _unit(arm.prim)
    instance = "angular" if arm.kind == "revolute" else "linear"
    drive, axis = f"drive:{instance}:physics:", f"physxJointAxis:{instance}:"
    schemas = _applied(prim)
    if f"PhysicsDriveAPI:{instance}" in schemas:
        # the drive and the attributes of MuJoCo: one of them is 0
        for field in ("stiffness", "damping"):
            of_mujoco = _number(prim, f"mjc:{field}")
            name = f"mjc:{field}" if of_mujoco else f"{drive}{field}"
            yield Stated(field, _number(prim, f"{drive}{field}") / unit + of_mujoco, name)
        name = "mjc:springref" if _number(prim, "mjc:stiffness") else f"{drive}targetPosition"
        yield Stated("rest", _number(prim, name) * unit, name)
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
            yield Stated(field, _number(prim, name), name)
    for field, name, factor in (
        ("effort", f"{drive}maxForce", 1.0),
        ("effort", "mjc:actuatorfrcrange:max", 1.0),
        ("effort", "mjc:actuatorfrcrange:min", -1.0),
        ("velocity", "newton:velocityLimit", unit),
        ("velocity", f"{axis}maxJointVelocity", unit),
    ):
        value = _get(prim, name)
        if value is not None and np.isfinite(value):
            yield Stated(field, factor * float(value), name)


def _applied(prim: Any) -> list[str]:
    """Return the API schemas of a prim, including those unknown to OpenUSD."""
    schemas = prim.GetMetadata("apiSchemas")
    return [] if schemas is None else list(schemas.GetAppliedItems())


def _get(prim: Any, name: str, default: Any = None) -> Any:
    """Return the value of an attribute; the default if it has none."""
    attribute = prim.GetAttribute(name)
    value = attribute.Get() if attribute else None
    return default if value is None else value


def _number(prim: Any, name: str) -> float:
    return float(_get(prim, name, 0.0))


def _target(prim: Any, relation: str) -> Any:
    """Return the prim that a relationship names first; None if there is none."""
    found = prim.GetRelationship(relation)
    targets = found.GetTargets() if found else []
    return prim.GetStage().GetPrimAtPath(targets[0]) if targets else None


def _unit(prim: Any) -> float:
    """Return the SI units per USD unit of a joint's positions."""
    return _DEGREE if prim.IsA(UsdPhysics.RevoluteJoint) else 1.0


def _variants(stage: Any) -> Iterator[str]:
    """Enable the variants for single simulators in turn, and yield their names, or an empty one once."""
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


def _laws(stage: Any, asset: Asset, variant: str) -> dict[str, dict[str, Law]]:
    """Return the couplings of a stage [rad, m] with a variant enabled, by simulator."""
    start = asset.positions()
    laws: dict[str, dict[str, Law]] = {_NEWTON: {}, _PHYSX: {}, _MUJOCO: {}}
    for prim in stage.Traverse():
        name = prim.GetName()
        if leader := _target(prim, "mjc:target"):
            lead, ratio, offset = leader.GetName(), _number(prim, "mjc:coef1"), _number(prim, "mjc:coef0")
            # between a rotation and a slide, Newton reads this schema, with positions counted from 0
            laws[_NEWTON][name] = (lead, ratio, offset)
            # MuJoCo relates displacements from the initial positions
            offset += start.get(name, 0.0) - ratio * start.get(lead, 0.0)
            laws[_MUJOCO][name] = (lead, ratio, offset)
        if leader := _target(prim, "newton:mimicJoint"):
            ratio, offset = (_number(prim, f"newton:mimicCoef{number}") for number in (1, 0))
            laws[_NEWTON][name] = (leader.GetName(), ratio, offset * _unit(prim))
        for schema in _applied(prim):
            kind, _, instance = schema.partition(":")
            leader = _target(prim, f"physxMimicJoint:{instance}:referenceJoint")
            if leader and kind == "PhysxMimicJointAPI":
                # position + gearing * leader + offset = 0 in degrees and metres
                gearing, offset = (
                    _number(prim, f"physxMimicJoint:{instance}:{part}") for part in ("gearing", "offset")
                )
                ratio = -gearing * _unit(prim) / _unit(leader)
                laws[_PHYSX][name] = (leader.GetName(), ratio, -offset * _unit(prim))
    if not variant:
        return {simulator: laws[simulator] for simulator in (_NEWTON, _PHYSX)}
    simulator = variant if variant in laws else _NEWTON
    return {simulator: laws[simulator]}


def read(asset: Asset, path: Path) -> Reading:
    """Read a stage, and run OpenUSD's validators on it."""
    with collected_messages() as messages:
        diagnostics = UsdUtils.CoalescingDiagnosticDelegate()
        stage = Usd.Stage.Open(str(path))
        stage.Reload()  # open layers would hide newer files
        validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
        validation = UsdValidation.ValidationContext(validators)
        laws: dict[str, dict[str, Law]] = {}
        dynamics: dict[str, dict[Stated, None]] = {}  # an ordered set
        for variant in _variants(stage):
            found = [f"{error.GetName()}: {error.GetMessage()}" for error in validation.Validate(stage)]
            # OpenUSD from PyPI is built without MaterialX
            messages.extend(text for text in found if not _MATERIAL_X.match(text))
            laws |= _laws(stage, asset, variant)
            for arm in _arms(stage, asset):
                if arm.kind:
                    dynamics.setdefault(arm.name, {}).update(dict.fromkeys(_dynamics(arm)))
        messages.extend(item.commentary for item in diagnostics.TakeUncoalescedDiagnostics())
        del diagnostics  # OpenUSD prints again
    bodies = {prim.GetName(): prim for prim in stage.Traverse() if prim.HasAPI(UsdPhysics.RigidBodyAPI)}
    arms = list(_arms(stage, asset))
    links = [link.name for link in asset.links if link.name in bodies]
    base, holds = asset.links[0].name, {hold.name for hold in asset.affordances}
    start = _placed(bodies[base]) if base in bodies else np.eye(4)
    below = {name: list(_below(body)) for name, body in bodies.items()}
    fixed = any({base, ""} == {arm.parent, arm.child} and not arm.kind for arm in arms)

    # free bodies stand on what carries them, and move along with it
    held = {
        joint.child: (
            joint.parent,
            np.linalg.inv(_placed(bodies[joint.parent])) @ _placed(bodies[joint.child]),
        )
        for joint in asset.joints
        if joint.child in asset.loose and {joint.parent, joint.child} <= bodies.keys()
    }

    def frames(positions: Mapping[str, float]) -> dict[str, Array]:
        found, remaining = {base: start}, [arm for arm in arms if arm.parent and arm.child]
        while ready := [arm for arm in remaining if arm.parent in found]:
            for arm in ready:
                motion = arm.before @ arm.motion(positions.get(arm.name, 0.0)) @ np.linalg.inv(arm.after)
                found[arm.child] = found[arm.parent] @ motion
            remaining = [arm for arm in remaining if arm not in ready]
            for name, (carrier, at_rest) in held.items():
                if carrier in found and name not in found:
                    found[name] = found[carrier] @ at_rest
        return {name: found[name] for name in links if name in found}

    return Reading(
        path.name,
        frames,
        placements={name: _placed(bodies[name]) for name in links},
        inertials={
            name: _inertial(bodies[name])
            for name in links
            if all(_get(bodies[name], f"physics:{part}") is not None for part in _MASS)
        },
        mass=sum(_number(prim, "physics:mass") for prim in bodies.values()),
        base="fixed" if fixed else "free",
        joints={
            arm.name: ReadJoint(
                arm.kind,
                (arm.parent, arm.child),
                arm.limits,
                arm.after[:3, arm.column],
                tuple(dynamics.get(arm.name, ())),
            )
            for arm in arms
            if arm.kind and arm.parent
        },
        couplings=laws.pop(_NEWTON, {}),
        more_couplings=laws,
        colliders={
            name: tuple(_piece(*each) for each in below[name] if each[0].HasAPI(UsdPhysics.CollisionAPI))
            for name in links
        },
        faces={
            name: tuple(
                Faces.of(prim.GetName(), *_mesh(prim, matrix))
                for prim, matrix in below[name]
                if prim.IsA(UsdGeom.Mesh) and not prim.HasAPI(UsdPhysics.CollisionAPI)
            )
            for name in links
        },
        # grasps and pushes are the prims with their names below the bodies
        holds={
            prim.GetName(): (name, matrix)
            for name, each in below.items()
            for prim, matrix in each
            if prim.GetName() in holds and not prim.IsA(UsdGeom.Gprim)
        },
        findings=tuple(_stage_findings(stage, asset)),
        complaints=tuple(messages),
    )


def _inertial(prim: Any) -> Inertial:
    mass, center, diagonal, axes = (_get(prim, f"physics:{part}") for part in _MASS)
    turn = _pose((0.0, 0.0, 0.0), axes)[:3, :3]
    inertia = turn @ np.diag(np.array(diagonal, float)) @ turn.T
    return Inertial(float(mass), np.array(center, float), inertia)


def _below(body: Any) -> Iterator[tuple[Any, Array]]:
    """Yield the prims below a body, including instances, with their transforms to the body."""
    inverse = np.linalg.inv(_placed(body))
    for prim in Usd.PrimRange(body, Usd.TraverseInstanceProxies()):
        if prim.IsA(UsdGeom.Xformable):
            yield prim, inverse @ _placed(prim)


def _piece(prim: Any, matrix: Array) -> ReadCollider:
    name = prim.GetName()
    binding = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial("physics")[0]
    rough = binding and binding.GetPrim().HasAPI(UsdPhysics.MaterialAPI)
    friction = _number(binding.GetPrim(), "physics:dynamicFriction") if rough else 0.0
    if prim.IsA(UsdGeom.Mesh):
        applied = prim.HasAPI(UsdPhysics.MeshCollisionAPI)
        shape = _get(prim, "physics:approximation", "none") if applied else "none"
        flaw = "" if shape == "convexHull" else f"has the approximation {shape!r}, not 'convexHull'"
        return ReadCollider.mesh(name, *_mesh(prim, matrix), friction, flaw)
    scales = np.linalg.norm(matrix[:3, :3], axis=0)
    rigid = matrix.copy()
    rigid[:3, :3] /= scales
    if prim.IsA(UsdGeom.Cube):
        edges = scales * float(UsdGeom.Cube(prim).GetSizeAttr().Get())
        return ReadCollider.primitive(name, Convex("box", rigid, tuple(map(float, edges))), friction)
    flaw = "" if np.abs(scales - 1.0).max() <= 1e-6 else f"is round and scaled by {scales.max():.6g}"
    kind = _ROUND.get(prim.GetTypeName())
    if kind is None:
        kind, flaw = "capsule", f"has an unknown type ({prim.GetTypeName()})"
    size = [float(prim.GetAttribute("radius").Get())]
    if kind != "sphere":
        size.append(float(prim.GetAttribute("height").Get()))
        rigid[:3, :3] = rigid[:3, :3] @ _TURNS[prim.GetAttribute("axis").Get()]
    return ReadCollider.primitive(name, Convex(kind, rigid, tuple(size)), friction, flaw)


def _mesh(prim: Any, matrix: Array) -> tuple[Array, Indices]:
    mesh = UsdGeom.Mesh(prim)
    corners = np.array(mesh.GetFaceVertexIndicesAttr().Get(), np.int64).reshape(-1, 3)
    points = np.array(mesh.GetPointsAttr().Get(), float)
    return points @ matrix[:3, :3].T + matrix[:3, 3], corners
