"""Reading an exported MJCF with MuJoCo."""

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from artgen.asset import Asset
from artgen.check.reading import Inertial, Reading, listening, mesh_volume

Array = NDArray[np.float64]


def read_mjcf(asset: Asset, path: Path) -> Reading:
    """Read a model and its meshes.

    Args:
        asset: The asset whose links are looked for.
        path: The file.

    Raises:
        ImportError: MuJoCo is not installed.
    """
    import mujoco

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
        result = {}
        for name in links:
            result[name] = np.eye(4)
            result[name][:3, :3] = data.body(name).xmat.reshape(3, 3)
            result[name][:3, 3] = data.body(name).xpos
        return result

    return Reading(
        path.name,
        frames,
        {name: _inertial(model.body(name)) for name in links},
        {model.joint(number).name: _KINDS[model.jnt_type[number]] for number in joints},
        {
            model.joint(number).name: (
                (float(model.jnt_range[number, 0]), float(model.jnt_range[number, 1]))
                if model.jnt_limited[number]
                else None
            )
            for number in joints
        },
        dict(_axes(model, joints)),
        dict(_couplings(model)),
        {name: _colliders(model, model.body(name).id) for name in links},
        tuple(said),
    )


_KINDS = {2: "prismatic", 3: "revolute"}  # of mjtJoint; 0 and 1 have more than one degree of freedom


@contextmanager
def _warnings(mujoco: Any, said: list[str]) -> Iterator[None]:
    """Collect MuJoCo's own warnings, which it prints and writes to a file otherwise."""
    before = mujoco.get_mju_user_warning()
    mujoco.set_mju_user_warning(said.append)
    try:
        yield
    finally:
        mujoco.set_mju_user_warning(before)


def _inertial(body: Any) -> Inertial:
    w, x, y, z = body.iquat
    turn = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )
    return Inertial(float(body.mass[0]), np.array(body.ipos), turn @ np.diag(body.inertia) @ turn.T)


def _axes(model: Any, joints: list[int]) -> Iterator[tuple[str, Array]]:
    """Yield the axis of the last joint of each body; those before it are turned with the body."""
    for number in joints:
        body = model.jnt_bodyid[number]
        if number == model.body_jntadr[body] + model.body_jntnum[body] - 1:
            yield model.joint(number).name, np.array(model.jnt_axis[number])


def _couplings(model: Any) -> Iterator[tuple[str, tuple[str, float, float]]]:
    for number in range(model.neq):
        follower, leader = int(model.eq_obj1id[number]), int(model.eq_obj2id[number])
        # MuJoCo couples what joints have moved from their reference positions
        start, start_of_leader = (
            float(model.qpos0[model.jnt_qposadr[joint]]) for joint in (follower, leader)
        )
        ratio = float(model.eq_data[number, 1])
        offset = start + float(model.eq_data[number, 0]) - ratio * start_of_leader
        yield model.joint(follower).name, (model.joint(leader).name, ratio, offset)


def _colliders(model: Any, body: int) -> tuple[int, float]:
    """Return number and total volume of the geoms of a body that collide."""
    first = model.body_geomadr[body]
    numbers = [
        number
        for number in range(first, first + model.body_geomnum[body])
        if model.geom_contype[number] or model.geom_conaffinity[number]
    ]
    return len(numbers), sum(_volume(model, number) for number in numbers)


def _volume(model: Any, geom: int) -> float:
    kind, (a, b, c) = int(model.geom_type[geom]), model.geom_size[geom]
    ball = 4.0 / 3.0 * np.pi * a**3
    volumes = {2: ball, 3: np.pi * a**2 * 2 * b + ball, 5: np.pi * a**2 * 2 * b, 6: 8 * a * b * c}
    if kind in volumes:  # of mjtGeom: sphere, capsule, cylinder, box
        return float(volumes[kind])
    mesh = model.geom_dataid[geom]
    vertices, faces = model.mesh_vertadr[mesh], model.mesh_faceadr[mesh]
    return mesh_volume(
        np.array(model.mesh_vert[vertices : vertices + model.mesh_vertnum[mesh]], float),
        np.array(model.mesh_face[faces : faces + model.mesh_facenum[mesh]], np.int64),
    )
