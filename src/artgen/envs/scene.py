"""An asset and a Panda in one MuJoCo model, in asset coordinates, and pictures of it."""

import warnings
import xml.etree.ElementTree as ET
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.batch import Common
from artgen.envs.motion import Target
from artgen.envs.robot import ASSET_BIT, HAND, LIMITS, OPENING, PREFIX, ROBOT_BIT, Control, panda, simulator
from artgen.export.frames import apart, quaternion
from artgen.export.meshes import mesh_files
from artgen.export.mjcf import mjcf_tree
from artgen.export.text import document
from artgen.view import gl
from artgen.view.camera import Camera
from artgen.view.raster import Renderer

TIME_STEP = 0.0025  # of the physics: half the time constant of contacts and limits in the exports [s]
STEPS = 20  # physics steps per action
STEPS_OF_TORQUES = 4  # physics steps with the same torques of the arm
SHUT = 0.001  # smaller openings of each finger mean that the hand squeezes [m]
CAMERAS = {"front": "scene_front", "hand": f"{PREFIX}eye_in_hand"}  # next to the robot, and on its hand

_FLOOR, _TABLE = "scene_floor", "scene_table"
_ANYWHERE = (0.0, 0.0, 0.0, 1e3, 1e3, 1e3)  # bounds of moved shapes: center and half sizes [m]
_DEEP = 0.02  # least height of the pedestal [m]
_VISUAL_GROUP, _GROUPS = 2, 6  # geom group of visual surfaces, and number of groups

# the surroundings of asset and robot; a fixed asset needs no floor, so that only the robot touches it. Floor
# and table are not at the origin, because MuJoCo would ignore later changes of their positions
_SCENE = f"""<mujoco>
  <option timestep="{TIME_STEP}" integrator="implicitfast"/>
  <visual>
    <headlight ambient="0.28 0.28 0.28" diffuse="0.3 0.3 0.3"/>
    <quality shadowsize="4096"/>
    <map shadowclip="2"/>
  </visual>
  <asset>
    <texture name="scene_sky" type="skybox" builtin="gradient" rgb1="0.72 0.76 0.8" rgb2="0.6 0.61 0.62"
      width="32" height="192"/>
  </asset>
  <worldbody>
    <geom name="{_FLOOR}" type="plane" size="0 0 0.05" pos="0 0 -1" rgba="0.72 0.71 0.69 1" group="2"
      contype="{{floor_bits}}" conaffinity="{ROBOT_BIT}" castshadow="false"/>
    <geom name="{_TABLE}" type="box" size="0.1 0.1 0.1" pos="0 0 -1" rgba="0.62 0.52 0.42 1" group="2"
      contype="{{floor_bits}}" conaffinity="{ROBOT_BIT}"/>
    <camera name="{CAMERAS["front"]}" fovy="45"/>
    <light name="scene_light" type="directional" dir="0.3 0.5 -1" pos="0 0 4" diffuse="0.5 0.5 0.5"/>
  </worldbody>
</mujoco>"""


class TaskScene:
    """A compiled model with its state; `place` sets up a task.

    The names of the asset are unchanged; those of the robot begin with `robot_`. The scene moves the robot in
    the model.
    """

    def __init__(self, asset: Asset, model: Any) -> None:
        mujoco = simulator()
        self.asset, self._mujoco, self.model = asset, mujoco, model
        self.data = mujoco.MjData(model)
        self.control = Control(model, self.data)
        self._joints: dict[str, tuple[int, int, int]] = {}  # indices in `qpos`, `qvel` and of the joint
        for joint in asset.joints:
            if not joint.locked:
                found = model.joint(joint.name)
                self._joints[joint.name] = int(found.qposadr[0]), int(found.dofadr[0]), int(found.id)
        self._bodies = {link.name: int(model.body(link.name).id) for link in asset.links}
        hand = f"{PREFIX}{HAND}"
        self.fingers = np.array([model.actuator(f"{hand}gripper_finger_joint{n}").id for n in (1, 2)])
        self.finger_at = np.array([model.joint(f"{hand}finger_joint{n}").qposadr[0] for n in (1, 2)])
        self._tip_place = self.data.site_xpos[self.control.tip]
        self._tip_turn = self.data.site_xmat[self.control.tip].reshape(3, 3)
        self._rest = {link.name: asset.origin(link.name) for link in asset.links}
        self._bounds, self._qpos, self.speeds = asset.bounds(), self.data.qpos, self.data.qvel
        # floor, table and pedestal are moved after the compilation, which fixed their bounds
        for body in (0, int(model.geom_bodyid[model.geom(f"{PREFIX}pedestal").id])):
            first = int(model.body_bvhadr[body])
            model.bvh_aabb[first : first + int(model.body_bvhnum[body])] = _ANYWHERE

    def place(self, target: Target, arm: Array) -> None:
        """Set up a task, with the arm at given angles, shape (7,) [rad], and everything at rest."""
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
        """Simulate one action of `ManipulationEnv`, shape (7,), for `STEPS * TIME_STEP`."""
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
        """Return the distance between the pads of the fingers [m]."""
        first, second = self._qpos[self.finger_at]
        return float(first - second)

    def q(self, joint: str) -> float:
        """Return the position of a joint of the asset [rad or m]."""
        known = self.asset.joint(joint)
        return known.closed if known.locked else float(self._qpos[self._joints[joint][0]])

    def speed(self, joint: str) -> float:
        """Return the speed of a joint of the asset [rad/s or m/s]."""
        return 0.0 if self.asset.joint(joint).locked else float(self.speeds[self._joints[joint][1]])

    def motion(self, joint: str, place: Array) -> Array:
        """Return the motion of a point, shape (3,) [m], per unit of an unlocked joint, shape (3,)."""
        number = self._joints[joint][2]
        axis = self.data.xaxis[number]
        if self.asset.joint(joint).kind == "prismatic":
            return np.array(axis)
        return np.cross(axis, place - self.data.xanchor[number])

    def pose(self, link: str) -> Array:
        """Return the displacement of a link from rest, shape (4, 4)."""
        body = self._bodies[self.asset.link(link).name]
        pose = np.eye(4)
        pose[:3, :3] = self.data.xmat[body].reshape(3, 3)
        pose[:3, 3] = self.data.xpos[body] - pose[:3, :3] @ self._rest[link]
        return pose

    def _put_robot(self, base: Array) -> None:
        """Put the robot on a pedestal, on the floor of the asset or on a lower one next to a table."""
        body = self.model.body(f"{PREFIX}base")
        floor = float(base[2, 3]) if base[2, 3] < -_DEEP else 0.0
        body.pos[:], body.quat[:] = base[:3, 3], quaternion(base)
        # a room has a floor of its own
        self.model.geom(_FLOOR).pos[2] = float(self._bounds[0, 2]) if self.asset.is_room else floor
        height = max(float(base[2, 3]) - floor, _DEEP)
        pedestal = self.model.geom(f"{PREFIX}pedestal")
        center = np.array([pedestal.pos[0], 0.0, -0.5 * height])
        self._put_box(pedestal, center, [*pedestal.size[:2], 0.5 * height])
        low, high = self._bounds
        middle, half = 0.5 * (low + high), 0.5 * (high - low)
        if floor < 0.0:
            middle[2], half[2] = 0.5 * (float(low[2]) + floor), 0.5 * (float(low[2]) - floor)
        else:
            middle[2], half[2] = floor - 1.0, _DEEP  # out of view
        self._put_box(self.model.geom(_TABLE), middle, half)

    def _put_box(self, box: Any, middle: Array, half: Sequence[float]) -> None:
        """Set center and half sizes of a box of the model."""
        box.pos[:], box.size[:] = middle, half
        # bounds for collision detection
        self.model.geom_aabb[box.id][3:] = half
        self.model.geom_rbound[box.id] = np.linalg.norm(half)

    def _look(self, target: Target) -> None:
        """Put the camera in front of the first handle, on the side away from the robot."""
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
        camera = self.model.camera(CAMERAS["front"])
        right, up, forward = Camera(tuple(eye), tuple(middle)).axes()
        pose = np.eye(4)
        pose[:3, :3] = np.column_stack([right, up, -forward])
        camera.pos[:], camera.quat[:] = eye, quaternion(pose)


def compiled(asset: Asset, *, visual: bool = False, textures: int = 0, common: Common | None = None) -> Any:
    """Return the MuJoCo model of an asset and a Panda, with or without visual surfaces and texture maps.

    `common` makes it a model for a batch with other assets.
    """
    mujoco = simulator()
    meshes = mesh_files(asset, textures if visual else 0)
    root = mjcf_tree(asset, meshes, common.tendons if common else None)
    if not visual:
        _strip(root)
    named = {element.get("file") for element in root.iter()}
    files = {path: content for path, content in meshes.files.items() if path in named}
    scene = _SCENE.format(floor_bits=ASSET_BIT if asset.base == "free" else 0)
    root.extend(ET.fromstring(scene))  # noqa: S314 - the text of this file
    spec = mujoco.MjSpec.from_string(document(root).decode(), assets=files)
    if common is not None:
        common.align(asset, spec, touching=True)
    else:
        for first, second in apart(asset):
            spec.add_exclude(bodyname1=first, bodyname2=second)
    with warnings.catch_warnings():  # the robot's files are on disk, those of the asset in memory
        warnings.filterwarnings("ignore", message="Attaching a child without asset dict")
        spec.attach(panda(visual=visual), frame=spec.worldbody.add_frame(), prefix=PREFIX)
    return spec.compile()


def _strip(root: ET.Element) -> None:
    """Remove visual surfaces, grasps and pushes from the MJCF of an asset."""
    held = {each.get(each.tag) for each in root.iterfind("tendon/spatial/*")}  # of detents and soft closings
    for parent in root.iter("body"):
        for each in [*parent.findall("geom"), *parent.findall("site")]:
            seen = each.tag == "site" or each.get("class", "").endswith("_visual")
            if seen and each.get("name") not in held:
                parent.remove(each)
    for parent in root.iter("custom"):
        for element in parent.findall("tuple"):  # of grasps and pushes
            parent.remove(element)
    used = {geom.get("mesh") for geom in root.iter("geom")}
    for parent in root.iter("asset"):
        for element in list(parent):
            if element.tag != "mesh" or element.get("name") not in used:
                parent.remove(element)


class Pictures(Renderer):
    """Draws one scene from its cameras; `close` frees the graphics memory."""

    scene: Any  # a `TaskScene`, which has the model and the state that the base class needs

    def __init__(self, scene: Any, size: int) -> None:
        gl.claim_process()
        super().__init__(scene, (size, size))
        self._option = simulator().MjvOption()
        for number in range(_GROUPS):
            self._option.geomgroup[number] = number == _VISUAL_GROUP

    def take(self, size: int, camera: str, *, shadows: bool) -> NDArray[np.uint8]:
        """Return a picture from one of the `CAMERAS`, shape (size, size, 3)."""
        mujoco, model, data = simulator(), self.scene.model, self.scene.data
        self._gl.make_current()
        mujoco.mj_camlight(model, data)
        eye = mujoco.MjvCamera()
        eye.type = mujoco.mjtCamera.mjCAMERA_FIXED
        eye.fixedcamid = model.camera(CAMERAS[camera]).id
        every = mujoco.mjtCatBit.mjCAT_ALL
        mujoco.mjv_updateScene(model, data, self._option, None, eye, every, self._view)
        self._view.flags[mujoco.mjtRndFlag.mjRND_SHADOW] = shadows
        rectangle = mujoco.MjrRect(0, 0, size, size)
        pixels = np.empty((size, size, 3), np.uint8)
        mujoco.mjr_render(rectangle, self._view, self._context)
        mujoco.mjr_readPixels(pixels, None, rectangle, self._context)
        return np.ascontiguousarray(pixels[::-1])
