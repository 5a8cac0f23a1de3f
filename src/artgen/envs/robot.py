"""A Franka Panda with its hand, as robosuite's files have it.

The tip is the point in the middle of the fingers' pads: z points out of the hand, the fingers close along x.
A hand whose tip is at the frame of a grasp can close on it; the fingers end `GRIPPER.tip` further out.
"""

from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

from artgen.asset.gripper import GRIPPER
from artgen.errors import EnvError

PREFIX = "robot_"
"""Begins every name of the robot's in a scene."""

HAND = "hand_"
"""Begins every name of the hand's, after that of the robot's."""

HOME = np.array([0.0, np.pi / 16, 0.0, -5 * np.pi / 6, 0.0, np.pi - 0.2, np.pi / 4])
"""Where robosuite lets a Panda begin: the hand before it, pointing down, shape (7,) [rad]."""

LIMITS = np.array(
    [
        [-2.8973, 2.8973],
        [-1.7628, 1.7628],
        [-2.8973, 2.8973],
        [-3.0718, -0.0698],
        [-2.8973, 2.8973],
        [-0.0175, 3.7525],
        [-2.8973, 2.8973],
    ]
)
"""Range of each joint of the arm, shape (7, 2) [rad]."""

OPENING = 0.04
"""How far each finger goes from the middle [m]."""

ROBOT_BIT, ASSET_BIT = 2, 1
"""What may touch, in the bits of MuJoCo's `contype`: an asset is written with the first bit alone."""

_PEDESTAL = (0.11, 0.11)  # half its width and depth [m]
_PEDESTAL_MIDDLE = -0.04  # along x: under the foot of the arm [m]
_INSTALL = "pip install 'artgen[envs]'"
_SQUEEZE = 40.0  # most force of a finger [N]; robosuite's 20 N lets heavy doors slip
_FINGER_STIFFNESS = 4000.0  # [N/m]


def files() -> Path:
    """Return the directory of robosuite's models; the package itself, which takes seconds, is not imported.

    Raises:
        EnvError: robosuite is not installed.
    """
    found = find_spec("robosuite")
    if found is None or not found.submodule_search_locations:
        raise EnvError(f"the Panda of the manipulation tasks comes with robosuite: {_INSTALL}")
    return Path(found.submodule_search_locations[0]) / "models" / "assets"


def panda(*, visual: bool) -> Any:
    """Return the specification of the arm with its hand, which stands at the origin.

    Parts of the arm do not touch each other, so that few pairs of them are looked at; they touch all else.

    Args:
        visual: Whether it has the surfaces that are seen, or only those that touch.

    Raises:
        EnvError: robosuite or mujoco is not installed.
    """
    mujoco = simulator()
    arm = mujoco.MjSpec.from_file(str(files() / "robots" / "panda" / "robot.xml"))
    hand = mujoco.MjSpec.from_file(str(files() / "grippers" / "panda_gripper.xml"))
    arm.attach(hand, frame=arm.body("right_hand").add_frame(), prefix=HAND)
    _strengthen_fingers(arm)
    for number, side in ((1, 1.0), (2, -1.0)):
        _slim(arm.geom(f"{HAND}finger{number}_collision"), side, mujoco.mjtGeom.mjGEOM_BOX)
    _strip(arm, visual=visual)
    arm.body("base").add_geom(
        name="pedestal",
        type=mujoco.mjtGeom.mjGEOM_BOX,
        size=(*_PEDESTAL, 0.5),
        pos=(_PEDESTAL_MIDDLE, 0.0, -0.5),
        rgba=(0.35, 0.36, 0.38, 1.0),
        contype=ROBOT_BIT,
        conaffinity=ASSET_BIT,
        group=2,
    )
    return arm


def _strengthen_fingers(arm: Any) -> None:
    """Let the fingers squeeze as a Panda's do, and be told to go beyond each other to do so."""
    for finger in arm.actuators:
        if finger.name.startswith(HAND):
            finger.gainprm[0], finger.biasprm[1] = _FINGER_STIFFNESS, -_FINGER_STIFFNESS
            finger.forcerange = -_SQUEEZE, _SQUEEZE
            finger.ctrlrange = -OPENING, OPENING


def _strip(arm: Any, *, visual: bool) -> None:
    """Remove what measures and, unless it is wanted, what is only seen; say who may touch whom."""
    for sensor in list(arm.sensors):
        arm.delete(sensor)
    for geom in list(arm.geoms):
        if geom.contype or geom.conaffinity:
            geom.contype, geom.conaffinity, geom.group = ROBOT_BIT, ASSET_BIT, 3
        elif visual:
            geom.group = 2
        else:
            arm.delete(geom)
    for site in arm.sites:
        site.group = 4
    used = {geom.meshname for geom in arm.geoms}
    for mesh in list(arm.meshes):
        if mesh.name not in used:
            arm.delete(mesh)


def _slim(finger: Any, side: float, box: Any) -> None:
    """Make a finger a box as grasps are proven for; the hull of its mesh is up to three times as thick."""
    half = np.array([GRIPPER.wide, GRIPPER.thick, GRIPPER.long]) / 2.0
    finger.type, finger.meshname = box, ""
    finger.size, finger.pos = half, (0.0, side * half[1], half[2])
    finger.quat = (1.0, 0.0, 0.0, 0.0)


def simulator() -> Any:
    """Return the module `mujoco`.

    Raises:
        EnvError: It is not installed.
    """
    try:
        import mujoco
    except ImportError as error:
        raise EnvError(f"manipulation tasks run in MuJoCo: {_INSTALL}") from error
    return mujoco
