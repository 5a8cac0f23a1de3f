"""Readers that are not artgen's: what yourdfpy, pinocchio, MuJoCo and OpenUSD make of exported files.

Each gives one `Reading`, so that one comparison serves all.
"""

import logging
import os
import sys
import tempfile
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

import mujoco
import numpy as np
import pinocchio
import yourdfpy
from numpy.typing import NDArray
from pxr import Gf, Usd, UsdGeom, UsdPhysics, UsdValidation

from artgen.asset import Asset

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Reading:
    """What one reader found in an exported asset.

    Attributes:
        name: The reader.
        frames: Gives the frame of each link, shape (4, 4), at positions of all joints.
        masses: Mass of each link that the reader keeps apart [kg].
        centers: Center of mass of each link in its frame, shape (3,) [m].
        inertias: Inertia about the center, along the link's axes, shape (3, 3) [kg m^2].
        limits: Lowest and highest position of each joint; None is unlimited [rad or m].
        axes: Axis of each joint in the child's frame, shape (3,).
        couplings: Leader, ratio and offset of each joint that follows.
    """

    name: str
    frames: Callable[[dict[str, float]], dict[str, Array]]
    masses: dict[str, float] = field(default_factory=dict)
    centers: dict[str, Array] = field(default_factory=dict)
    inertias: dict[str, Array] = field(default_factory=dict)
    limits: dict[str, tuple[float, float] | None] = field(default_factory=dict)
    axes: dict[str, Array] = field(default_factory=dict)
    couplings: dict[str, tuple[str, float, float]] = field(default_factory=dict)


@contextmanager
def silence() -> Iterator[None]:
    """Assert that nothing is printed, logged or warned of, by Python or by C++."""
    records: list[str] = []
    handler = logging.Handler()
    handler.emit = lambda record: records.append(record.getMessage())  # type: ignore[method-assign]
    root = logging.getLogger()
    root.addHandler(handler)
    here = Path.cwd()
    with tempfile.TemporaryDirectory() as place, tempfile.TemporaryFile() as printed:
        os.chdir(place)  # where MuJoCo would leave its log
        saved = [os.dup(stream) for stream in (1, 2)]
        sys.stdout.flush()
        sys.stderr.flush()
        for stream in (1, 2):
            os.dup2(printed.fileno(), stream)
        try:
            with warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter("always")
                # yourdfpy calls trimesh in a way that trimesh is about to drop, whatever the file
                warnings.filterwarnings("ignore", message=".*Scene.dump", category=DeprecationWarning)
                yield
        finally:
            for stream, copy in zip((1, 2), saved, strict=True):
                os.dup2(copy, stream)
                os.close(copy)
            os.chdir(here)
            root.removeHandler(handler)
        printed.seek(0)
        output = printed.read().decode(errors="replace")
        logs = [path.name for path in Path(place).iterdir()]
    assert not output, f"printed: {output[:500]}"
    assert not records, f"logged: {records[:5]}"
    assert not caught, f"warned: {[str(item.message) for item in caught[:5]]}"
    assert not logs, f"left files: {logs}"


def read_all(asset: Asset, directory: Path) -> list[Reading]:
    """Read the three formats with every reader."""
    return [
        read_yourdfpy(asset, directory),
        read_pinocchio(asset, directory),
        read_mujoco(asset, directory, "xml"),
        read_mujoco(asset, directory, "urdf"),
        read_usd(asset, directory),
    ]


def read_yourdfpy(asset: Asset, directory: Path) -> Reading:
    """Read the URDF with yourdfpy."""
    robot = yourdfpy.URDF.load(
        str(directory / f"{asset.name}.urdf"), load_collision_meshes=True, build_collision_scene_graph=True
    )
    assert robot.validate()
    links = {link.name for link in asset.links}

    def frames(positions: dict[str, float]) -> dict[str, Array]:
        robot.update_cfg({name: positions[name] for name in robot.actuated_joint_names})
        return {name: robot.get_transform(name) for name in links}

    limits: dict[str, tuple[float, float] | None] = {}
    for name, joint in robot.joint_map.items():
        if joint.type in ("revolute", "prismatic"):
            limits[name] = (joint.limit.lower, joint.limit.upper)
        elif joint.type == "continuous":
            limits[name] = None
    inertials = {name: robot.link_map[name].inertial for name in links}
    return Reading(
        "yourdfpy",
        frames,
        {name: inertial.mass for name, inertial in inertials.items()},
        {name: inertial.origin[:3, 3] for name, inertial in inertials.items()},
        {name: inertial.inertia for name, inertial in inertials.items()},
        limits,
        {name: np.array(joint.axis) for name, joint in robot.joint_map.items() if name in limits},
        {
            name: (joint.mimic.joint, joint.mimic.multiplier or 1.0, joint.mimic.offset or 0.0)
            for name, joint in robot.joint_map.items()
            if joint.mimic is not None
        },
    )


def read_pinocchio(asset: Asset, directory: Path) -> Reading:
    """Read the URDF with pinocchio."""
    path = str(directory / f"{asset.name}.urdf")
    model, _, _ = pinocchio.buildModelsFromUrdf(path, [str(directory)])
    data = model.createData()

    def frames(positions: dict[str, float]) -> dict[str, Array]:
        q = pinocchio.neutral(model)
        for name, index, length in zip(model.names[1:], model.idx_qs[1:], model.nqs[1:], strict=True):
            value = positions[name]
            q[index : index + length] = [value] if length == 1 else [np.cos(value), np.sin(value)]
        pinocchio.framesForwardKinematics(model, data, q)
        return {
            link.name: data.oMf[model.getFrameId(link.name, pinocchio.FrameType.BODY)].homogeneous
            for link in asset.links
        }

    limits: dict[str, tuple[float, float] | None] = {}
    for name, index, length in zip(model.names[1:], model.idx_qs[1:], model.nqs[1:], strict=True):
        bounds = (float(model.lowerPositionLimit[index]), float(model.upperPositionLimit[index]))
        limits[name] = bounds if length == 1 else None
    return Reading("pinocchio", frames, limits=limits)


def read_mujoco(asset: Asset, directory: Path, suffix: str) -> Reading:
    """Read the MJCF (`xml`) or the URDF (`urdf`) with MuJoCo, which joins links fixed in URDF."""
    model = mujoco.MjModel.from_xml_path(str(directory / f"{asset.name}.{suffix}"))
    tried, data = mujoco.MjData(model), mujoco.MjData(model)
    for _ in range(2):
        mujoco.mj_step(model, tried)
    assert not [warning for warning in tried.warning if warning.number], "MuJoCo warns while stepping"
    names = {model.body(index).name for index in range(1, model.nbody)}
    kept = names & {link.name for link in asset.links}

    def frames(positions: dict[str, float]) -> dict[str, Array]:
        for index in range(model.njnt):
            if model.jnt_type[index] != mujoco.mjtJoint.mjJNT_FREE:
                data.qpos[model.jnt_qposadr[index]] = positions[model.joint(index).name]
        mujoco.mj_kinematics(model, data)
        result = {}
        for name in kept:
            result[name] = np.eye(4)
            result[name][:3, :3] = data.body(name).xmat.reshape(3, 3)
            result[name][:3, 3] = data.body(name).xpos
        return result

    limits: dict[str, tuple[float, float] | None] = {}
    axes: dict[str, Array] = {}
    for index in range(model.njnt):
        joint = model.joint(index)
        if model.jnt_type[index] == mujoco.mjtJoint.mjJNT_FREE:
            continue
        limits[joint.name] = (joint.range[0], joint.range[1]) if model.jnt_limited[index] else None
        body = model.jnt_bodyid[index]
        if index == model.body_jntadr[body] + model.body_jntnum[body] - 1:
            # the frame of a body is where its last joint leaves it; earlier axes are turned with it
            axes[joint.name] = np.array(joint.axis)
    couplings = {}
    for index in range(model.neq):
        if model.eq_type[index] == mujoco.mjtEq.mjEQ_CONNECT:
            continue  # the pin of a closed chain
        follower, leader = model.eq_obj1id[index], model.eq_obj2id[index]
        coefficients = model.eq_data[index, :5]
        assert not coefficients[2:].any()
        # MuJoCo couples what joints have moved from their reference positions
        start, start_of_leader = (model.qpos0[model.jnt_qposadr[joint]] for joint in (follower, leader))
        ratio = float(coefficients[1])
        offset = float(start + coefficients[0] - ratio * start_of_leader)
        couplings[model.joint(follower).name] = (model.joint(leader).name, ratio, offset)
    mass, center, inertia = {}, {}, {}
    if suffix == "xml":
        for name in kept:
            body = model.body(name)
            axes_of_inertia = np.empty(9)
            mujoco.mju_quat2Mat(axes_of_inertia, body.iquat)
            rotation = axes_of_inertia.reshape(3, 3)
            mass[name], center[name] = float(body.mass[0]), np.array(body.ipos)
            inertia[name] = rotation @ np.diag(body.inertia) @ rotation.T
    return Reading(f"mujoco {suffix}", frames, mass, center, inertia, limits, axes, couplings)


def read_usd(asset: Asset, directory: Path) -> Reading:
    """Read the USD with OpenUSD, and compose the poses of bodies from the frames of joints."""
    stage = Usd.Stage.Open(str(directory / f"{asset.name}.usda"))
    bodies, joints = {}, []
    for prim in stage.Traverse():
        if prim.HasAPI(UsdPhysics.RigidBodyAPI):
            bodies[prim.GetName()] = prim
        elif prim.IsA(UsdPhysics.Joint) and not UsdPhysics.Joint(prim).GetExcludeFromArticulationAttr().Get():
            joints.append(prim)  # a pin of a closed chain is outside the articulation
    masses, centers, inertias = {}, {}, {}
    for link in asset.links:
        api = UsdPhysics.MassAPI(bodies[link.name])
        quaternion = api.GetPrincipalAxesAttr().Get()
        rotation = np.array(Gf.Matrix3d(Gf.Quatd(quaternion).GetNormalized())).T
        masses[link.name] = api.GetMassAttr().Get()
        centers[link.name] = np.array(api.GetCenterOfMassAttr().Get())
        diagonal = np.array(api.GetDiagonalInertiaAttr().Get())
        inertias[link.name] = rotation @ np.diag(diagonal) @ rotation.T
    limits: dict[str, tuple[float, float] | None] = {}
    axes: dict[str, Array] = {}
    arms: list[tuple[str, str, str, Array, Array, bool]] = []
    for prim in joints:
        joint = UsdPhysics.Joint(prim)
        ends = [
            [target.name for target in relation.GetTargets()]
            for relation in (joint.GetBody0Rel(), joint.GetBody1Rel())
        ]
        if not ends[0]:
            continue  # the fixed base
        local = [
            _pose(position.Get(), rotation.Get())
            for position, rotation in (
                (joint.GetLocalPos0Attr(), joint.GetLocalRot0Attr()),
                (joint.GetLocalPos1Attr(), joint.GetLocalRot1Attr()),
            )
        ]
        turning, sliding = prim.IsA(UsdPhysics.RevoluteJoint), prim.IsA(UsdPhysics.PrismaticJoint)
        arms.append((prim.GetName() if turning or sliding else "", ends[0][0], ends[1][0], *local, turning))
        if not turning and not sliding:
            continue
        kind = (UsdPhysics.RevoluteJoint if turning else UsdPhysics.PrismaticJoint)(prim)
        assert kind.GetAxisAttr().Get() == "X"
        low, high = kind.GetLowerLimitAttr().Get(), kind.GetUpperLimitAttr().Get()
        unit = np.pi / 180.0 if turning else 1.0
        # PhysX wants limits on every coupled joint; unlimited ones get some that nothing ever reaches
        reachable = np.isfinite(low) and high * unit < 1e5
        limits[prim.GetName()] = (low * unit, high * unit) if reachable else None
        axes[prim.GetName()] = local[1][:3, 0]

    base = _xform(bodies[asset.links[0].name])

    def frames(positions: dict[str, float]) -> dict[str, Array]:
        found = {asset.links[0].name: base}
        remaining = list(arms)
        while remaining:
            ready = [arm for arm in remaining if arm[1] in found]
            assert ready, "a body is not connected to the base"
            for name, parent, child, before, after, turning in ready:
                motion = np.eye(4)
                value = positions.get(name, 0.0)
                if turning:
                    c, s = np.cos(value), np.sin(value)
                    motion[1:3, 1:3] = [[c, -s], [s, c]]
                elif name:
                    motion[0, 3] = value
                found[child] = found[parent] @ before @ motion @ np.linalg.inv(after)
            remaining = [arm for arm in remaining if arm not in ready]
        return {link.name: found[link.name] for link in asset.links}

    return Reading("usd", frames, masses, centers, inertias, limits, axes, _usd_couplings(stage))


def usd_faults(path: Path) -> list[str]:
    """Return what OpenUSD's own validators say of a file."""
    registry = UsdValidation.ValidationRegistry()
    context = UsdValidation.ValidationContext(registry.GetOrLoadAllValidators())
    stage = Usd.Stage.Open(str(path))
    return [f"{error.GetName()}: {error.GetMessage()}" for error in context.Validate(stage)]


def _usd_couplings(stage: Usd.Stage) -> dict[str, tuple[str, float, float]]:
    """Read couplings in radians and metres: Newton's schema, or MuJoCo's between a rotation and a slide."""
    result = {}
    for prim in stage.Traverse():
        for target, offset, ratio in (
            ("newton:mimicJoint", "newton:mimicCoef0", "newton:mimicCoef1"),
            ("mjc:target", "mjc:coef0", "mjc:coef1"),
        ):
            relation = prim.GetRelationship(target)
            if relation and relation.GetTargets():
                numbers = [prim.GetAttribute(name).Get() for name in (ratio, offset)]
                if target == "newton:mimicJoint" and prim.IsA(UsdPhysics.RevoluteJoint):
                    numbers[1] = np.radians(numbers[1])
                result[prim.GetName()] = (relation.GetTargets()[0].name, *map(float, numbers))
    return result


def _pose(position: Gf.Vec3f, rotation: Gf.Quatf) -> Array:
    result = np.eye(4)
    result[:3, :3] = np.array(Gf.Matrix3d(Gf.Quatd(rotation).GetNormalized())).T
    result[:3, 3] = position
    return result


def _xform(prim: Usd.Prim) -> Array:
    matrix = UsdGeom.Xformable(prim).ComputeLocalToWorldTransform(Usd.TimeCode.Default())
    return np.array(matrix).T


def expected_frames(asset: Asset, q: dict[str, float]) -> dict[str, Array]:
    """Return where each link's frame is, from the asset's pose alone."""
    result = {}
    for name, displacement in asset.pose(q).items():
        result[name] = displacement.copy()
        result[name][:3, 3] += displacement[:3, :3] @ asset.origin(name)
    return result


def draw_positions(asset: Asset, seed: int) -> dict[str, float]:
    """Draw positions of the free joints over their whole ranges; a full turn for unlimited ones."""
    generator = np.random.default_rng(seed)
    return {
        joint.name: float(generator.uniform(*(joint.limits or (-np.pi, np.pi))))
        for joint in asset.free_joints
    }
