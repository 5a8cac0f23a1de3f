"""Reading an exported MJCF with MuJoCo, and faults that MuJoCo accepts silently."""

from collections.abc import Collection, Iterator, Mapping
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from artgen._arrays import Array, Indices, affine
from artgen.asset import Asset, AssetJoint
from artgen.asset.report import AGAIN, Finding
from artgen.colliders import Convex
from artgen.colliders.convex import Kind
from artgen.export.frames import quaternion
from artgen.export.layouts.robocasa import OBJECT
from artgen.export.mjcf import OFF
from artgen.export.names import read_names
from artgen.validate.behavior.model import check_loadable, collected_warnings, load_spec
from artgen.validate.readback.reading import (
    UNLIMITED,
    Faces,
    Inertial,
    ReadCollider,
    Reading,
    ReadJoint,
    Stated,
    collected_messages,
)

_KINDS = {2: "prismatic", 3: "revolute"}  # values of mjtJoint with one degree of freedom
_FREE, _BALL = 0, 1  # other values of mjtJoint
_SHAPES: dict[int, Kind] = {2: "sphere", 3: "capsule", 5: "cylinder", 6: "box"}  # values of mjtGeom
_MESH = 7
_SCENE = "move it to the scene that attaches the asset"
_ACTING = ("actuator", "deformable", "extension", "include")  # they move or hold links
_SETTINGS = ("gravity", "density", "wind", "timestep", "iterations")
_PLAIN = {"contype": 1.0, "conaffinity": 1.0, "condim": 3.0, "margin": 0.0, "gap": 0.0}
_SOFTEST, _LEAST_IMPEDANCE = 0.02, 0.9  # default time constant [s] and impedance of MuJoCo
_SHARES = (-0.5, -0.3, -0.01, 0.01, 0.25, 0.45)  # compared positions around a ridge, in gaps of detents
_NEAR, _AWAY = (0.02, 0.3, 0.6, 0.98), (0.02, 0.3, 0.98)  # the same before and behind a soft closing's reach
_TENDON = 0.001  # allowed difference of the force of detents or a soft closing, over the greatest one
_SHOWN = 2  # most findings about the colliders of one link
# for each field of a joint's dynamics: the name in the file, the array of MuJoCo's model and its index
_DYNAMICS = (
    ("stiffness", "stiffness", "jnt_stiffness", "joint"),
    ("rest", "springref", "qpos_spring", "position"),
    ("damping", "damping", "dof_damping", "freedom"),
    ("friction", "frictionloss", "dof_frictionloss", "freedom"),
    ("armature", "armature", "dof_armature", "freedom"),
)

_fault = partial(Finding, "mjcf", hint=AGAIN)
_foreign = partial(Finding, "mjcf", hint=_SCENE)


def element_findings(path: Path) -> Iterator[Finding]:
    """Yield elements that hide contacts, change gravity, or move and hold links."""
    from lxml import etree

    root, file = etree.parse(path).getroot(), path.name
    for exclude in root.iterfind("contact/exclude"):
        message = f"{file} excludes their contacts, which hides parts that penetrate each other"
        yield _fault(message, f"{exclude.get('body1')}, {exclude.get('body2')}", hint="remove <exclude>")
    for option in root.iterfind("option"):
        settings = {name: option.get(name) for name in _SETTINGS if option.get(name)}
        settings |= {name: value for flag in option.iterfind("flag") for name, value in flag.items()}
        for name, value in settings.items():
            yield _foreign(f"{file} sets {name} to {value}, which belongs to the scene")
    for body in root.iterfind("worldbody//body[@gravcomp]"):
        message = f"{file} compensates the share {body.get('gravcomp')} of its weight (gravcomp)"
        yield _fault(message, body.get("name", ""), hint="remove gravcomp")
    for tag in _ACTING:
        if root.find(f".//{tag}") is not None:
            yield _foreign(f"{file} has <{tag}>, which does not belong to an asset")
    for equality in root.iterfind("equality/*"):
        if equality.tag not in ("joint", "connect"):  # the model tells which links these connect
            yield _foreign(f"{file} has the equality <{equality.tag}>, which holds links together")
        elif equality.tag == "joint" and not equality.get("joint2"):
            yield _foreign(f"an equality of {file} holds it in place", joint=equality.get("joint1", ""))


def _model_findings(model: Any, asset: Asset, file: str) -> Iterator[Finding]:
    """Yield bodies that collide or move beside the links, and contacts and couplings that are unusual."""
    import mujoco

    links = {link.name for link in asset.links}
    supports = _supports(model, asset.links[0].name)
    off = {
        f"{link.name}_collider_{number}"
        for link in asset.links
        for number, collider in enumerate(link.colliders)
        if collider.spare
    }
    for body in range(model.nbody):
        name = model.body(body).name
        found = list(_geom_findings(model, body, name if name in links else "", file, off))
        yield from found[:_SHOWN]
        first = model.body_jntadr[body]
        for joint in range(first, first + model.body_jntnum[body]):
            kind = int(model.jnt_type[joint])
            if kind == _BALL or (kind == _FREE and body not in supports and name not in asset.loose):
                yield _foreign(
                    f"the body {name!r} moves {'as a ball' if kind == _BALL else 'freely'} in {file}"
                )
            elif kind != _FREE and _is_soft(model.jnt_solref[joint], model.jnt_solimp[joint]):
                message = f"its limits are softer than MuJoCo's default in {file}"
                yield _fault(message, joint=model.joint(joint).name)
    for number in np.flatnonzero(model.eq_type == mujoco.mjtEq.mjEQ_JOINT):
        if np.abs(model.eq_data[number, 2:5]).max() > 0.0:
            follower = model.joint(int(model.eq_obj1id[number])).name
            yield _fault(f"its coupling has terms of higher order in {file}", joint=follower)
    pins = sorted(
        (*loop.links, *np.round(loop.point - asset.origin(loop.links[0]), 6)) for loop in asset.loops
    )
    read = sorted(
        (
            *(model.body(int(body)).name for body in (model.eq_obj1id[number], model.eq_obj2id[number])),
            *np.round(model.eq_data[number, :3], 6),
        )
        for number in np.flatnonzero(model.eq_type == mujoco.mjtEq.mjEQ_CONNECT)
        if model.eq_objtype[number] == mujoco.mjtObj.mjOBJ_BODY
    )
    if read != pins:
        yield _foreign(f"{file} connects links otherwise than the {len(pins)} closed chains of the asset")


def _tendon_findings(model: Any, data: Any, asset: Asset, file: str) -> Iterator[Finding]:
    """Yield tendons that the asset does not have, and joints whose springs and tendons have other forces."""
    names = [f"{joint.name}_ridge_{number}" for joint in asset.joints for number in range(len(joint.ridges))]
    names += [f"{joint.name}_closing" for joint in asset.joints if joint.closing is not None]
    if sorted(names) != sorted(model.tendon(number).name for number in range(model.ntendon)):
        listed = "other <tendon> than the detents and soft closings of the asset" if names else "<tendon>"
        yield _foreign(f"{file} has {listed}, which does not belong to an asset")
        return
    for joint in asset.joints:
        for feature, samples, most in () if joint.locked else _tendon_samples(joint):
            worst = _tendon_error(model, data, joint, samples)
            if worst > _TENDON * most:
                message = f"its {feature} in {file} differs by {worst:.3g} N m or N from {most:.3g}"
                yield _fault(message, joint=joint.name, value=worst)


def _tendon_samples(joint: AssetJoint) -> Iterator[tuple[str, Array, float]]:
    """Yield features of a joint with positions to compare, and the greatest force."""
    if joint.detents is not None:
        places = [ridge + share * gap for ridge, gap in joint.ridges for share in _SHARES]
        yield "detents", np.array(places), joint.detents.torque
    if joint.closing is not None:
        reach = joint.closing.reach
        near = [joint.closed + share * (reach - joint.closed) for share in _NEAR]
        away = [reach + share * (joint.opened - reach) for share in _AWAY]
        yield "soft closing", np.array([*near, *away]), max(joint.closing.force, joint.closing.damping)


def _tendon_error(model: Any, data: Any, joint: AssetJoint, positions: Array) -> float:
    """Return the greatest difference of springs and dampers at a speed of 1 from those of a joint."""
    import mujoco

    tendons = joint.detent_torque(positions) + joint.closing_force(positions, 1.0)
    springs = joint.stiffness * (positions - joint.rest) + joint.damping
    at, freedom = model.joint(joint.name).qposadr[0], model.joint(joint.name).dofadr[0]
    start, worst = float(data.qpos[at]), 0.0
    data.qvel[freedom] = 1.0
    for position, wanted in zip(positions, tendons - springs, strict=True):
        data.qpos[at] = position
        mujoco.mj_forward(model, data)
        worst = max(worst, abs(float(data.qfrc_spring[freedom] + data.qfrc_damper[freedom]) - float(wanted)))
    data.qpos[at], data.qvel[freedom] = start, 0.0
    return worst


def _geom_findings(model: Any, body: int, link: str, file: str, off: Collection[str]) -> Iterator[Finding]:
    for geom in _geoms(model, body, colliding=True):
        name = model.geom(geom).name or f"number {geom}"
        if not link:
            where = model.body(body).name
            message = f"its body {where!r} is not a link of the asset and collides, by the geom {name!r}"
            yield _foreign(message)
            continue
        for key, wanted in _PLAIN.items():
            value = float(getattr(model, f"geom_{key}")[geom])
            if value != (OFF if key == "margin" and name in off else wanted):
                message = f"its collider {name} has {key} {value:.4g} in {file}, not {wanted:g}"
                yield _fault(message, link, value=value)
        if _is_soft(model.geom_solref[geom], model.geom_solimp[geom]):
            yield _fault(f"its collider {name} is softer than MuJoCo's default in {file}", link)


def _supports(model: Any, base: str) -> set[int]:
    """Return the numbers of the base and of the bodies above it, without the world."""
    found = set()
    body = next((number for number in range(model.nbody) if model.body(number).name == base), 0)
    while body:
        found.add(int(body))
        body = model.body_parentid[body]
    return found


def _is_soft(reference: Any, impedance: Any) -> bool:
    """Tell whether a constraint is softer than MuJoCo's default; negative references are stiffnesses."""
    return bool(reference[0] > _SOFTEST + 1e-9 or impedance[0] < _LEAST_IMPEDANCE - 1e-9)


def read(asset: Asset, path: Path) -> Reading:
    """Read a model and its meshes."""
    import mujoco

    check_loadable(path)
    renamed = bool(read_names(path.parent).links)
    # MuJoCo caches meshes and does not notice a file that changed within the same second
    mujoco.mj_clearCache(mujoco.mj_getCache())
    with collected_messages() as messages, collected_warnings() as warned:
        model = load_spec(path).compile() if renamed else mujoco.MjModel.from_xml_path(str(path))
        tried = mujoco.MjData(model)
        for _ in range(2):
            mujoco.mj_step(model, tried)
        numbers = [each.number for each in tried.warning if each.number]
        messages.extend((*warned, *(f"MuJoCo warns while stepping ({number})" for number in numbers)))
    names = {model.body(number).name for number in range(1, model.nbody)}
    links = [link.name for link in asset.links if link.name in names]
    data = mujoco.MjData(model)
    free = {int(body) for body in model.jnt_bodyid[model.jnt_type == _FREE]}
    joints = [number for number in range(model.njnt) if model.jnt_type[number] in _KINDS]

    def placed(positions: Mapping[str, float]) -> dict[str, Array]:
        for number in joints:
            name = model.joint(number).name
            if name in positions:
                data.qpos[model.jnt_qposadr[number]] = positions[name]
        mujoco.mj_kinematics(model, data)
        return {name: _pose(data.body(name).xpos, data.body(name).xquat) for name in links}

    closed = placed(asset.positions()) if asset.loose else {}
    held = [joint for joint in asset.joints if joint.child in asset.loose and joint.child in closed]

    def frames(positions: Mapping[str, float]) -> dict[str, Array]:
        found = placed(positions)
        for joint in held:  # free bodies stand on what carries them, and move along with it
            if joint.parent in found:
                pose = found[joint.parent] @ np.linalg.inv(closed[joint.parent]) @ closed[joint.child]
                at = model.jnt_qposadr[model.body(joint.child).jntadr[0]]
                data.qpos[at : at + 7] = [*pose[:3, 3], *quaternion(pose)]
        return placed(positions) if held else found

    bodies = {name: model.body(name).id for name in links}
    return Reading(
        path.name,
        frames,
        inertials={name: _inertial(model.body(name)) for name in links},
        mass=float(model.body_mass.sum()),
        base="fixed" if free.isdisjoint(_supports(model, asset.links[0].name)) else "free",
        joints={
            model.joint(number).name: _joint(model, number, "" if OBJECT in links else asset.links[0].name)
            for number in joints
        },
        couplings=dict(_couplings(model)),
        colliders={name: tuple(_colliders(model, body)) for name, body in bodies.items()},
        faces={
            name: tuple(
                Faces.of(model.geom(geom).name or f"number {geom}", *_placed_mesh(model, geom))
                for geom in _geoms(model, body, colliding=False)
                if model.geom_type[geom] == _MESH
            )
            for name, body in bodies.items()
        },
        holds=_holds(asset, model),
        findings=(
            *_model_findings(model, asset, path.name),
            *_tendon_findings(model, data, asset, path.name),
        ),
        complaints=tuple(messages),
    )


def _pose(position: Array, quaternion: Array) -> Array:
    """Return a position and a quaternion (w, x, y, z) as a transform, shape (4, 4)."""
    return affine(Rotation.from_quat(quaternion, scalar_first=True).as_matrix(), position)


def _inertial(body: Any) -> Inertial:
    pose = _pose(body.ipos, body.iquat)
    turn = pose[:3, :3]
    return Inertial(float(body.mass[0]), pose[:3, 3], turn @ np.diag(body.inertia) @ turn.T)


def _joint(model: Any, number: int, base: str) -> ReadJoint:
    """Read a joint; in the layout robocasa, moving parts may hang on the body around the base."""
    body = model.jnt_bodyid[number]
    parent = model.body(model.body_parentid[body]).name
    low, high = model.jnt_range[number] if model.jnt_limited[number] else UNLIMITED
    index = {"joint": number, "position": model.jnt_qposadr[number], "freedom": model.jnt_dofadr[number]}
    least, most = model.jnt_actfrcrange[number]
    effort = float(min(-least, most)) if model.jnt_actfrclimited[number] else np.inf
    dynamics = [
        Stated(field, float(getattr(model, array)[index[of]]), name) for field, name, array, of in _DYNAMICS
    ]
    # earlier joints of a body turn with it: their axes in the model are not those of the asset
    last = number == model.body_jntadr[body] + model.body_jntnum[body] - 1
    return ReadJoint(
        _KINDS[model.jnt_type[number]],
        (base if base and parent == OBJECT else parent, model.body(body).name),
        (float(low), float(high)),
        np.array(model.jnt_axis[number]) if last else None,
        (*dynamics, Stated("effort", effort, "actuatorfrcrange")),
    )


def _couplings(model: Any) -> Iterator[tuple[str, tuple[str, float, float]]]:
    import mujoco

    # an equality without a leader holds a joint in place
    coupled = (model.eq_type == mujoco.mjtEq.mjEQ_JOINT) & (model.eq_active0 != 0) & (model.eq_obj2id >= 0)
    for number in np.flatnonzero(coupled):
        follower, leader = int(model.eq_obj1id[number]), int(model.eq_obj2id[number])
        # MuJoCo couples displacements from the reference positions
        start, start_of_leader = (float(model.joint(joint).qpos0[0]) for joint in (follower, leader))
        ratio = float(model.eq_data[number, 1])
        offset = start + float(model.eq_data[number, 0]) - ratio * start_of_leader
        yield model.joint(follower).name, (model.joint(leader).name, ratio, offset)


def _geoms(model: Any, body: int, *, colliding: bool) -> Iterator[int]:
    first = model.body_geomadr[body]
    for number in range(first, first + model.body_geomnum[body]):
        if bool(model.geom_contype[number] or model.geom_conaffinity[number]) is colliding:
            yield number


def _placed_mesh(model: Any, geom: int) -> tuple[Array, Indices]:
    """Return the vertices of a mesh geom in its body's frame, and its triangles."""
    mesh = model.geom_dataid[geom]
    vertices, faces = model.mesh_vertadr[mesh], model.mesh_faceadr[mesh]
    points = np.array(model.mesh_vert[vertices : vertices + model.mesh_vertnum[mesh]], float)
    triangles = np.array(model.mesh_face[faces : faces + model.mesh_facenum[mesh]], np.int64)
    pose = _pose(model.geom_pos[geom], model.geom_quat[geom])
    return points @ pose[:3, :3].T + pose[:3, 3], triangles


def _colliders(model: Any, body: int) -> Iterator[ReadCollider]:
    for geom in _geoms(model, body, colliding=True):
        name, friction = model.geom(geom).name or f"number {geom}", float(model.geom_friction[geom, 0])
        kind = _SHAPES.get(int(model.geom_type[geom]))
        if kind is not None:
            a, b, c = (float(size) for size in model.geom_size[geom])
            sizes = {"sphere": (a,), "box": (2 * a, 2 * b, 2 * c)}
            pose = _pose(model.geom_pos[geom], model.geom_quat[geom])
            yield ReadCollider.primitive(name, Convex(kind, pose, sizes.get(kind, (a, 2 * b))), friction)
        elif model.geom_type[geom] == _MESH:
            yield ReadCollider.mesh(name, *_placed_mesh(model, geom), friction)
        else:
            place = np.array(model.geom_pos[geom])
            flaw = f"has an unknown type (mjtGeom {model.geom_type[geom]})"
            yield ReadCollider(name, np.array([place, place]), place, 0.0, friction, flaw=flaw)


def _holds(asset: Asset, model: Any) -> dict[str, tuple[str, Array]]:
    """Return the sites of grasps and pushes."""
    sites = {model.site(number).name: model.body(body).name for number, body in enumerate(model.site_bodyid)}
    found = {}
    for hold in asset.affordances:
        for name in (f"{hold.kind}_{hold.name}", hold.name):  # the last one is the name in artgen's layout
            if name in sites:
                pose = _pose(model.site(name).pos, model.site(name).quat)
                found[hold.name] = (sites[name], pose)
    return found
