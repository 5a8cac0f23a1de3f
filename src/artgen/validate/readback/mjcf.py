"""Reading an exported MJCF with MuJoCo."""

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.colliders import Convex
from artgen.colliders.convex import Kind
from artgen.validate.readback.mjcf_foreign_elements import model_findings
from artgen.validate.readback.pieces import ReadCollider
from artgen.validate.readback.reading import Faces, Inertial, Reading, Said, listening

_KINDS = {2: "prismatic", 3: "revolute"}  # of mjtJoint; 0 and 1 have more than one degree of freedom
_SHAPES: dict[int, Kind] = {2: "sphere", 3: "capsule", 5: "cylinder", 6: "box"}  # of mjtGeom
_FREE = 0
_MESH = 7


def read_mjcf(asset: Asset, path: Path) -> Reading:
    """Read a model and its meshes."""
    import mujoco

    # it keeps meshes, and takes a file that was changed within the same second for the one before
    mujoco.mj_clearCache(mujoco.mj_getCache())
    with listening() as said, _warnings(mujoco, said):
        model = mujoco.MjModel.from_xml_path(str(path))
        tried = mujoco.MjData(model)
        for _ in range(2):
            mujoco.mj_step(model, tried)
        said += [f"MuJoCo warns while stepping ({each.number})" for each in tried.warning if each.number]
    names = {model.body(number).name for number in range(1, model.nbody)}
    links = [link.name for link in asset.links if link.name in names]
    data = mujoco.MjData(model)
    joints = [number for number in range(model.njnt) if model.jnt_type[number] in _KINDS]

    def frames(positions: Mapping[str, float]) -> dict[str, Array]:
        for number in joints:
            name = model.joint(number).name
            if name in positions:
                data.qpos[model.jnt_qposadr[number]] = positions[name]
        mujoco.mj_kinematics(model, data)
        return {name: _pose(data.body(name).xpos, data.body(name).xmat.reshape(3, 3)) for name in links}

    bodies = {name: model.body(name).id for name in links}
    return Reading(
        path.name,
        frames,
        inertials={name: _inertial(model.body(name)) for name in links},
        mass=float(model.body_mass.sum()),
        base=_base(model, asset),
        kinds={model.joint(number).name: _KINDS[model.jnt_type[number]] for number in joints},
        ends={model.joint(number).name: _ends(model, number) for number in joints},
        limits={model.joint(number).name: _limits(model, number) for number in joints},
        axes=dict(_axes(model, joints)),
        dynamics={model.joint(number).name: tuple(_dynamics(model, number)) for number in joints},
        couplings=dict(_couplings(model)),
        colliders={name: tuple(_colliders(model, body)) for name, body in bodies.items()},
        faces={name: tuple(_faces(model, body)) for name, body in bodies.items()},
        holds=_holds(asset, model),
        findings=tuple(model_findings(model, links, asset.links[0].name, path.name)),
        said=tuple(said),
    )


@contextmanager
def _warnings(mujoco: Any, said: list[str]) -> Iterator[None]:
    """Collect MuJoCo's own warnings, which it prints and writes to a file otherwise."""
    before = mujoco.get_mju_user_warning()
    mujoco.set_mju_user_warning(said.append)
    try:
        yield
    finally:
        mujoco.set_mju_user_warning(before)


def _pose(position: Array, turn: Array) -> Array:
    result = np.eye(4)
    result[:3, :3], result[:3, 3] = turn, position
    return result


def _turn(quaternion: Array) -> Array:
    w, x, y, z = quaternion
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def _base(model: Any, asset: Asset) -> str:
    """Tell whether anything above and at the base lets it move freely."""
    body = next(
        (number for number in range(1, model.nbody) if model.body(number).name == asset.links[0].name), 0
    )
    while body:
        first = model.body_jntadr[body]
        kinds = [model.jnt_type[number] for number in range(first, first + model.body_jntnum[body])]
        if _FREE in kinds:
            return "free"
        body = model.body_parentid[body]
    return "fixed"


def _ends(model: Any, joint: int) -> tuple[str, str]:
    body = model.jnt_bodyid[joint]
    return model.body(model.body_parentid[body]).name, model.body(body).name


def _limits(model: Any, joint: int) -> tuple[float, float] | None:
    low, high = model.jnt_range[joint]
    return (float(low), float(high)) if model.jnt_limited[joint] else None


def _inertial(body: Any) -> Inertial:
    turn = _turn(body.iquat)
    return Inertial(float(body.mass[0]), np.array(body.ipos), turn @ np.diag(body.inertia) @ turn.T)


def _axes(model: Any, joints: list[int]) -> Iterator[tuple[str, Array]]:
    """Yield the axis of the last joint of each body; those before it are turned with the body."""
    for number in joints:
        body = model.jnt_bodyid[number]
        if number == model.body_jntadr[body] + model.body_jntnum[body] - 1:
            yield model.joint(number).name, np.array(model.jnt_axis[number])


def _dynamics(model: Any, joint: int) -> Iterator[Said]:
    freedom = model.jnt_dofadr[joint]
    yield Said("stiffness", float(model.jnt_stiffness[joint]), "stiffness")
    yield Said("rest", float(model.qpos_spring[model.jnt_qposadr[joint]]), "springref")
    yield Said("damping", float(model.dof_damping[freedom]), "damping")
    yield Said("friction", float(model.dof_frictionloss[freedom]), "frictionloss")
    yield Said("armature", float(model.dof_armature[freedom]), "armature")
    low, high = model.jnt_actfrcrange[joint]
    yield Said(
        "effort", float(min(-low, high)) if model.jnt_actfrclimited[joint] else np.inf, "actuatorfrcrange"
    )


def _couplings(model: Any) -> Iterator[tuple[str, tuple[str, float, float]]]:
    import mujoco

    for number in range(model.neq):
        if model.eq_type[number] != mujoco.mjtEq.mjEQ_JOINT or not model.eq_active0[number]:
            continue
        follower, leader = int(model.eq_obj1id[number]), int(model.eq_obj2id[number])
        if leader < 0:
            continue  # it holds a joint where it is
        # MuJoCo couples what joints have moved from their reference positions
        start, start_of_leader = (
            float(model.qpos0[model.jnt_qposadr[joint]]) for joint in (follower, leader)
        )
        ratio = float(model.eq_data[number, 1])
        offset = start + float(model.eq_data[number, 0]) - ratio * start_of_leader
        yield model.joint(follower).name, (model.joint(leader).name, ratio, offset)


def _geoms(model: Any, body: int, *, colliding: bool) -> Iterator[int]:
    first = model.body_geomadr[body]
    for number in range(first, first + model.body_geomnum[body]):
        if bool(model.geom_contype[number] or model.geom_conaffinity[number]) is colliding:
            yield number


def _placed_mesh(model: Any, geom: int) -> tuple[Array, NDArray[np.int64]]:
    """Return the vertices of a mesh geom in its body's frame, and its triangles."""
    mesh = model.geom_dataid[geom]
    vertices, faces = model.mesh_vertadr[mesh], model.mesh_faceadr[mesh]
    points = np.array(model.mesh_vert[vertices : vertices + model.mesh_vertnum[mesh]], float)
    triangles = np.array(model.mesh_face[faces : faces + model.mesh_facenum[mesh]], np.int64)
    return points @ _turn(model.geom_quat[geom]).T + model.geom_pos[geom], triangles


def _colliders(model: Any, body: int) -> Iterator[ReadCollider]:
    for geom in _geoms(model, body, colliding=True):
        name, friction = model.geom(geom).name or f"number {geom}", float(model.geom_friction[geom, 0])
        kind = _SHAPES.get(int(model.geom_type[geom]))
        if kind is not None:
            a, b, c = (float(size) for size in model.geom_size[geom])
            sizes = {"sphere": (a,), "box": (2 * a, 2 * b, 2 * c)}
            pose = _pose(model.geom_pos[geom], _turn(model.geom_quat[geom]))
            yield ReadCollider.primitive(name, Convex(kind, pose, sizes.get(kind, (a, 2 * b))), friction)
        elif model.geom_type[geom] == _MESH:
            yield ReadCollider.mesh(name, *_placed_mesh(model, geom), friction)
        else:
            place = np.array(model.geom_pos[geom])
            flaw = f"is of a kind that no asset has (mjtGeom {model.geom_type[geom]})"
            yield ReadCollider(name, np.array([place, place]), place, 0.0, friction, flaw=flaw)


def _faces(model: Any, body: int) -> Iterator[Faces]:
    for geom in _geoms(model, body, colliding=False):
        if model.geom_type[geom] == _MESH:
            vertices, triangles = _placed_mesh(model, geom)
            bounds = np.array([vertices.min(axis=0), vertices.max(axis=0)])
            yield Faces(model.geom(geom).name or f"number {geom}", bounds, len(triangles))


def _holds(asset: Asset, model: Any) -> dict[str, tuple[str, Array]]:
    """Return the sites of grasps and pushes."""
    sites = {model.site(number).name: number for number in range(model.nsite)}
    found = {}
    for hold in asset.affordances:
        number = next(
            (sites[name] for name in (hold.name, f"{hold.kind}_{hold.name}") if name in sites), None
        )
        if number is not None:
            pose = _pose(model.site_pos[number], _turn(model.site_quat[number]))
            found[hold.name] = (model.body(model.site_bodyid[number]).name, pose)
    return found
