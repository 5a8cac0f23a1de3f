"""PyBullet driver: reads a URDF and moves its joints."""

from typing import Any

import numpy as np
from driver_protocol import ends, free, in_base, mass_properties, require, serve, transform

require("pybullet")
import pybullet as bullet

_SETTLE = 240  # number of steps: one second
_TURN = 1.0  # time of a joint from one end to the other [s]
_STEP = 1.0 / 240.0  # time step [s]
_KINDS = {0: "revolute", 1: "prismatic"}


def _read(request: dict[str, Any]) -> dict[str, Any]:
    client = bullet.connect(bullet.DIRECT)
    try:
        fixed = request["base"] == "fixed"
        # use the file's inertia; by default, PyBullet computes it from the colliders
        body = bullet.loadURDF(request["file"], useFixedBase=fixed, flags=bullet.URDF_USE_INERTIA_FROM_FILE)
        infos = [bullet.getJointInfo(body, number) for number in range(bullet.getNumJoints(body))]
        numbers = {info[12].decode(): info[0] for info in infos}
        base = bullet.getBodyInfo(body)[0].decode()
        numbers[base] = -1
        joints = {info[1].decode(): info for info in infos if info[2] in _KINDS}
        poses = []
        for q in request["poses"]:
            _put(body, joints, q)
            frames = {name: _frame(body, numbers[name]) for name in request["links"]}
            poses.append(in_base(frames, request["links"]))
        links = {name: _link(body, numbers[name]) for name in request["links"]}
        if fixed:
            links.pop(base, None)  # PyBullet gives fixed bodies no mass
        return {
            "links": links,
            "joints": {name: _joint(info) for name, info in joints.items()},
            "poses": poses,
            **_simulate(body, joints, request),
        }
    finally:
        bullet.disconnect(client)


def _put(body: int, joints: dict[str, Any], pose: dict[str, float]) -> None:
    for name, info in joints.items():
        bullet.resetJointState(body, info[0], pose[name])


def _link(body: int, number: int) -> dict[str, Any]:
    info = bullet.getDynamicsInfo(body, number)
    return mass_properties(info[0], info[3], info[2], bullet.getMatrixFromQuaternion(info[4]))


def _joint(info: Any) -> dict[str, Any]:
    low, high = info[8], info[9]
    limits = [low, high] if low <= high else None
    return {"kind": _KINDS[info[2]], "limits": limits, "damping": info[6], "friction": info[7]}


def _frame(body: int, number: int) -> Any:
    if number >= 0:
        state = bullet.getLinkState(body, number, computeForwardKinematics=True)
        return transform(bullet.getMatrixFromQuaternion(state[5]), state[4])
    position, turn = bullet.getBasePositionAndOrientation(body)
    place = transform(bullet.getMatrixFromQuaternion(turn), position)
    # the frame of its center of mass
    inertial = bullet.getDynamicsInfo(body, -1)
    return place @ np.linalg.inv(transform(bullet.getMatrixFromQuaternion(inertial[4]), inertial[3]))


def _simulate(body: int, joints: dict[str, Any], request: dict[str, Any]) -> dict[str, Any]:
    """Let the asset settle, then drive each free joint to both ends by its motor."""

    def position(number: int) -> float:
        return float(bullet.getJointState(body, number)[0])

    def drive(number: int, speed: float, effort: float) -> None:
        bullet.setJointMotorControl2(
            body, number, bullet.VELOCITY_CONTROL, targetVelocity=speed, force=effort
        )

    bullet.setTimeStep(_STEP)
    bullet.setGravity(0.0, 0.0, -9.81)
    steps, start = _SETTLE, request["poses"][0]
    _put(body, joints, start)
    for _ in range(_SETTLE):
        bullet.stepSimulation()
    moved = {}
    for joint in free(request):
        number, effort = joints[joint["name"]][0], joint["effort"]
        low, high = ends(joint)
        # remaining impulses of earlier drives, such as a door against its stop, would push a light button for
        # seconds
        _put(body, joints, start)
        seen = [position(number)]
        for end in (high, low):
            for _ in range(round(1.5 * _TURN / _STEP)):
                drive(number, np.sign(end - seen[-1]) * (high - low) / _TURN, effort)
                bullet.stepSimulation()
                seen.append(position(number))
            steps += round(1.5 * _TURN / _STEP)
        drive(number, 0.0, effort)
        moved[joint["name"]] = [min(seen), max(seen)]
    finite = bool(np.isfinite([position(info[0]) for info in joints.values()]).all())
    return {"moved": moved, "steps": steps, "finite": finite}


if __name__ == "__main__":
    serve(_read)
