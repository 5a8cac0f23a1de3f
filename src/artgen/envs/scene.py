"""An asset and a Panda in one model of MuJoCo: the asset as it is exported, in its own coordinates."""

import warnings
import xml.etree.ElementTree as ET
from collections.abc import Mapping, Sequence
from itertools import combinations
from typing import Any

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.asset.affordance import head
from artgen.envs.control import Control
from artgen.envs.motion import Target
from artgen.envs.robot import ASSET_BIT, HAND, LIMITS, OPENING, PREFIX, ROBOT_BIT, panda, simulator
from artgen.export.frames import quaternion
from artgen.export.meshes import MeshFiles, mesh_files
from artgen.export.mjcf import mjcf_text, mjcf_tree

TIME_STEP = 0.0025
"""Length of a step of the physics [s]: half the time constant of the contacts and limits in the exports."""

STEPS = 20
"""Steps of the physics in one action."""

CAMERAS = ("front", "hand")
"""What looks on: a camera beside the robot, and the one on its hand."""

STEPS_OF_TORQUES = 4  # the arm's torques are found anew after so many steps
SHUT = 0.001  # the hand squeezes where less than this opening of each finger is asked for [m]
_FLOOR, _TABLE, _FRONT, _LIGHT = "scene_floor", "scene_table", "scene_front", "scene_light"
_AMBIENT, _HEADLIGHT, _LAMP = 0.28, 0.3, 0.5  # light from everywhere, from the camera and from above
_LIGHT_GOES = (0.3, 0.5, -1.0)
_HAND_CAMERA = f"{PREFIX}eye_in_hand"
_DEEP = 0.02  # least height of the pedestal [m]


class Scene:
    """A compiled model with its state, which `place` sets to the beginning of a task.

    Names of the asset's are unchanged; the robot's begin with `robot_`. The world is the asset's frame.

    Args:
        asset: The asset.
        model: What `compiled` returned for it; the scene moves the robot in it.

    Raises:
        EnvError: mujoco is not installed.

    Attributes:
        asset: The asset.
        model: MuJoCo's model.
        data: MuJoCo's state.
        control: What finds the torques of the arm.
        fingers: Numbers of the two motors of the hand.
        finger_at: Where the positions of the two fingers are in `qpos`.
        speeds: Speeds of the joints of asset and robot, a view of the state.
    """

    def __init__(self, asset: Asset, model: Any) -> None:
        mujoco = simulator()
        self.asset, self._mujoco, self.model = asset, mujoco, model
        self.data = mujoco.MjData(self.model)
        self.control = Control(model, self.data)
        self._joints: dict[str, tuple[int, int, int]] = {}
        for joint in asset.joints:
            if not joint.locked:
                found = model.joint(joint.name)
                self._joints[joint.name] = int(found.qposadr[0]), int(found.dofadr[0]), int(found.id)
        self._bodies = {link.name: int(model.body(link.name).id) for link in asset.links}
        self.fingers = np.array([model.actuator(f"{PREFIX}{HAND}gripper_finger_joint{n}").id for n in (1, 2)])
        fingers = [model.joint(f"{PREFIX}{HAND}finger_joint{number}") for number in (1, 2)]
        self.finger_at = np.array([finger.qposadr[0] for finger in fingers])
        self._tip_place = self.data.site_xpos[self.control.tip]
        self._tip_turn = self.data.site_xmat[self.control.tip].reshape(3, 3)
        self._rest = {link.name: asset.origin(link.name) for link in asset.links}
        self._bounds = asset.bounds()
        self._qpos, self.speeds = self.data.qpos, self.data.qvel

    def place(self, target: Target, arm: Array) -> None:
        """Set all to the beginning of a task, at rest.

        Args:
            target: What has to be done, and where the robot stands.
            arm: Angles of its joints, shape (7,) [rad].
        """
        self._mujoco.mj_resetData(self.model, self.data)
        self._put_robot(target.base)
        for name, position in self.asset.positions(target.start).items():
            if name in self._joints:
                self._qpos[self._joints[name][0]] = position
        self._qpos[self.control.at] = np.clip(arm, LIMITS[:, 0], LIMITS[:, 1])
        opening = OPENING if target.stages[0].affordance.kind == "grasp" else 0.0
        self._qpos[self.finger_at] = self.data.ctrl[self.fingers] = opening, -opening
        self._look(target)
        self._mujoco.mj_forward(self.model, self.data)
        self.control.begin()

    def act(self, action: Array) -> None:
        """Let the robot do one action, which takes `STEPS * TIME_STEP`.

        What follows from positions and speeds is computed when it returns.

        Args:
            action: As `ManipulationEnv` takes it, within -1 and 1, shape (7,).
        """
        mujoco, model, data, control = self._mujoco, self.model, self.data, self.control
        control.aim(action[:6])
        opening = 0.5 * OPENING * (1.0 - action[6])
        wanted = opening if opening > SHUT else -OPENING
        data.ctrl[self.fingers] = wanted, -wanted
        for _ in range(STEPS // STEPS_OF_TORQUES):
            control.run()
            mujoco.mj_step2(model, data)
            mujoco.mj_step(model, data, nstep=STEPS_OF_TORQUES - 1)
            mujoco.mj_step1(model, data)

    def tip(self) -> Array:
        """Return the pose of the tip, shape (4, 4) [m]."""
        pose = np.eye(4)
        pose[:3, :3], pose[:3, 3] = self._tip_turn, self._tip_place
        return pose

    def opening(self) -> float:
        """Return how far the fingers' pads are apart [m]."""
        first, second = self._qpos[self.finger_at]
        return float(first - second)

    def q(self, joint: str) -> float:
        """Return where a joint of the asset stands [rad or m].

        Raises:
            AssetError: The asset has no such joint.
        """
        known = self.asset.joint(joint)
        return known.closed if known.locked else float(self._qpos[self._joints[joint][0]])

    def speed(self, joint: str) -> float:
        """Return how fast a joint of the asset moves [rad/s or m/s].

        Raises:
            AssetError: The asset has no such joint.
        """
        return 0.0 if self.asset.joint(joint).locked else float(self.speeds[self._joints[joint][1]])

    def motion(self, joint: str, place: Array) -> Array:
        """Return how a place moves with a joint of the asset, for each radian or metre, shape (3,).

        Args:
            joint: Name of a joint that is not locked.
            place: On what the joint moves, shape (3,) [m].
        """
        number = self._joints[joint][2]
        axis = self.data.xaxis[number]
        if self.asset.joint(joint).kind == "prismatic":
            return np.array(axis)
        return np.cross(axis, place - self.data.xanchor[number])

    def pose(self, link: str) -> Array:
        """Return how a link is displaced from rest, shape (4, 4)."""
        body = self._bodies[self.asset.link(link).name]
        pose = np.eye(4)
        pose[:3, :3] = self.data.xmat[body].reshape(3, 3)
        pose[:3, 3] = self.data.xpos[body] - pose[:3, :3] @ self._rest[link]
        return pose

    def _put_robot(self, base: Array) -> None:
        """Put the robot on a pedestal on the floor: the asset's, or a lower one with the asset on a table."""
        body = self.model.body(f"{PREFIX}base")
        floor = float(base[2, 3]) if base[2, 3] < -_DEEP else 0.0
        body.pos[:], body.quat[:] = base[:3, 3], quaternion(base)
        self.model.geom(_FLOOR).pos[2] = floor
        height = max(float(base[2, 3]) - floor, _DEEP)
        pedestal = self.model.geom(f"{PREFIX}pedestal")
        self._put_box(
            pedestal, np.array([pedestal.pos[0], 0.0, -0.5 * height]), [*pedestal.size[:2], 0.5 * height]
        )
        low, high = self._bounds
        middle, half = 0.5 * (low + high), 0.5 * (high - low)
        if floor < 0.0:
            middle[2], half[2] = 0.5 * (float(low[2]) + floor), 0.5 * (float(low[2]) - floor)
        else:
            middle[2], half[2] = floor - 1.0, _DEEP  # out of sight
        self._put_box(self.model.geom(_TABLE), middle, half)

    def _put_box(self, box: Any, middle: Array, half: Sequence[float]) -> None:
        """Put a box of the model's somewhere in its body, with half its sizes."""
        box.pos[:], box.size[:] = middle, half
        # by these MuJoCo finds what is near
        self.model.geom_aabb[box.id][3:] = half
        self.model.geom_rbound[box.id] = np.linalg.norm(half)

    def _look(self, target: Target) -> None:
        """Put the camera before what is to be moved, on the side where the robot does not stand."""
        frame = target.stages[0].affordance.frame
        at = frame[:3, 3]
        before = -frame[:3, 2] * (1.0, 1.0, 0.0)
        if np.linalg.norm(before) < 0.5:  # the hand comes from above
            before = np.array([0.0, -1.0, 0.0])  # the front of the asset
        before /= np.linalg.norm(before)
        back = (target.base[:3, 3] - at) * (1.0, 1.0, 0.0)
        side = np.cross([0.0, 0.0, 1.0], before)
        side *= -1.0 if side @ back > 0.0 else 1.0
        distance = float(np.linalg.norm(back))
        middle = at + 0.25 * back
        eye = middle + max(distance, 0.6) * (1.1 * before + 0.9 * side + np.array([0.0, 0.0, 0.8]))
        camera = self.model.camera(_FRONT)
        forward = (middle - eye) / np.linalg.norm(middle - eye)
        right = np.cross(forward, [0.0, 0.0, 1.0])
        right /= np.linalg.norm(right)
        pose = np.eye(4)
        pose[:3, :3] = np.column_stack([right, np.cross(right, forward), -forward])
        camera.pos[:], camera.quat[:] = eye, quaternion(pose)

    def camera(self, name: str) -> str:
        """Return what the model calls a camera of `CAMERAS`."""
        return _FRONT if name == "front" else _HAND_CAMERA


def compiled(asset: Asset, *, visual: bool = False, textures: int = 0) -> Any:
    """Return MuJoCo's model of an asset and a Panda.

    Args:
        asset: The asset.
        visual: Whether the model has what is seen, or only what touches.
        textures: Texels on a side of the asset's maps; 0 for colours alone.

    Raises:
        EnvError: robosuite or mujoco is not installed.
    """
    mujoco = simulator()
    meshes = mesh_files(asset, textures if visual else 0)
    root = mjcf_tree(asset, meshes)
    if not visual:
        _strip(root)
    spec = mujoco.MjSpec.from_string(mjcf_text(root).decode(), assets=_used(root, meshes))
    spec.option.timestep = TIME_STEP
    spec.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    world = spec.worldbody
    world.add_geom(
        name=_FLOOR,
        type=mujoco.mjtGeom.mjGEOM_PLANE,
        size=(0.0, 0.0, 0.05),
        pos=(0.0, 0.0, -1.0),  # anywhere: what is compiled at the origin of its body stays there
        rgba=(0.72, 0.71, 0.69, 1.0),
        group=2,
        # an asset that is fixed was made without a floor: only the robot feels it
        contype=ASSET_BIT if asset.base == "free" else 0,
        conaffinity=ROBOT_BIT,
        castshadow=False,
    )
    world.add_geom(
        name=_TABLE,
        type=mujoco.mjtGeom.mjGEOM_BOX,
        size=(0.1, 0.1, 0.1),
        pos=(0.0, 0.0, -1.0),
        rgba=(0.62, 0.52, 0.42, 1.0),
        group=2,
        contype=0,
        conaffinity=ROBOT_BIT,
    )
    for first, second in apart(asset):
        spec.add_exclude(bodyname1=first, bodyname2=second)
    with warnings.catch_warnings():  # the robot's files lie on the disk, the asset's do not: both are found
        warnings.filterwarnings("ignore", message="Attaching a child without asset dict")
        spec.attach(panda(visual=visual), frame=world.add_frame(), prefix=PREFIX)
    world.add_camera(name=_FRONT, fovy=45.0)
    world.add_light(
        name=_LIGHT,
        type=mujoco.mjtLightType.mjLIGHT_DIRECTIONAL,
        dir=_LIGHT_GOES,
        pos=(0.0, 0.0, 4.0),
        diffuse=[_LAMP] * 3,
    )
    spec.visual.headlight.ambient[:] = _AMBIENT
    spec.visual.headlight.diffuse[:] = _HEADLIGHT
    spec.visual.quality.shadowsize = 4096
    return spec.compile()


def apart(asset: Asset) -> list[tuple[str, str]]:
    """Return the pairs of an asset's links that nothing has to keep apart.

    An asset is made so that its links never touch as long as its dependencies hold. What contacts are for
    is to hold these, as the bolt of a latch does. So only such pairs can touch between which a joint moves
    that depends on another joint between them, and those that touch by design. To look at all others takes
    most of the time of a simulation.
    """
    chains: dict[str, frozenset[str]] = {asset.links[0].name: frozenset()}
    for parent, child, joints in asset.pairs():
        chains[child] = chains[parent] | {joint.name for joint in joints if not joint.locked}
    leaders = {joint.name: head(joint, asset).name for joint in asset.joints}
    blocks = []
    for joint in asset.joints:
        if joint.needs is not None:
            others = {leaders[name] for name in joint.needs.condition.joints()}
            blocks.append((leaders[joint.name], others))
    by_design = {frozenset(contact.links) for contact in asset.contacts}
    result = []
    for first, second in combinations(chains, 2):
        between = {leaders[name] for name in chains[first] ^ chains[second]}
        held = any(name in between and others & between for name, others in blocks)
        if between and not held and frozenset((first, second)) not in by_design:
            result.append((first, second))
    return result


def _strip(root: ET.Element) -> None:
    """Remove what is only seen from the elements of an asset's MJCF."""
    for parent in root.iter("body"):
        for geom in parent.findall("geom"):
            if geom.get("class", "").endswith("_visual"):
                parent.remove(geom)
    used = {geom.get("mesh") for geom in root.iter("geom")}
    for parent in root.iter("asset"):
        for element in list(parent):
            if element.tag != "mesh" or element.get("name") not in used:
                parent.remove(element)


def _used(root: ET.Element, meshes: MeshFiles) -> Mapping[str, bytes]:
    """Return the files that the elements name, by path."""
    named = {element.get("file") for element in root.iter() if element.get("file")}
    return {path: content for path, content in meshes.files.items() if path in named}
