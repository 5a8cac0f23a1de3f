"""PyBullet driver: reads a URDF and moves its joints."""

from typing import Any

import numpy as np
from driver_protocol import about_axes, ends, free, serve, transform
from partnet_request import numbered

_SETTLE = 240  # number of steps: one second
_TURN = 1.0  # time of a joint from one end to the other [s]
_STEP = 1.0 / 240.0  # time step [s]


def read(request: dict[str, Any]) -> dict[str, Any]:
    """Return the response to a request."""
    from importlib.metadata import version

    import pybullet as bullet

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
            for name, info in joints.items():
                bullet.resetJointState(body, info[0], q[name])
            poses.append(_frames(bullet, body, numbers, request["links"]))
        links = {name: _link(bullet, body, numbers[name]) for name in request["links"]}
        if fixed:
            links.pop(base, None)  # PyBullet gives fixed bodies no mass
        response = {
            "version": version("pybullet"),
            "links": links,
            "joints": {name: _joint(info) for name, info in joints.items()},
            "poses": poses,
        }
        return {**response, **_simulate(bullet, body, joints, request)}
    finally:
        bullet.disconnect(client)


_KINDS = {0: "revolute", 1: "prismatic"}


def _link(bullet: Any, body: int, number: int) -> dict[str, Any]:
    info = bullet.getDynamicsInfo(body, number)
    turn = np.array(bullet.getMatrixFromQuaternion(info[4])).reshape(3, 3)
    return {"mass": info[0], "center": info[3], "inertia": about_axes(info[2], turn)}


def _joint(info: Any) -> dict[str, Any]:
    low, high = info[8], info[9]
    return {
        "kind": _KINDS[info[2]],
        "limits": [low, high] if low <= high else None,
        "damping": info[6],
        "friction": info[7],
    }


def _frames(bullet: Any, body: int, numbers: dict[str, int], links: list[str]) -> dict[str, Any]:
    found = {}
    for name in links:
        if numbers[name] < 0:
            place = _frame(bullet, *bullet.getBasePositionAndOrientation(body))
            # the frame of its center of mass
            inertial = bullet.getDynamicsInfo(body, -1)
            found[name] = place @ np.linalg.inv(_frame(bullet, inertial[3], inertial[4]))
        else:
            state = bullet.getLinkState(body, numbers[name], computeForwardKinematics=True)
            found[name] = _frame(bullet, state[4], state[5])
    base = np.linalg.inv(found[links[0]])
    return {name: base @ frame for name, frame in found.items()}


def _frame(bullet: Any, position: Any, quaternion: Any) -> Any:
    return transform(bullet.getMatrixFromQuaternion(quaternion), position)


def _simulate(bullet: Any, body: int, joints: dict[str, Any], request: dict[str, Any]) -> dict[str, Any]:
    """Let the asset settle, then drive each free joint to both ends by its motor."""
    bullet.setTimeStep(_STEP)
    bullet.setGravity(0.0, 0.0, -9.81)
    steps = _SETTLE
    for name, info in joints.items():
        bullet.resetJointState(body, info[0], request["poses"][0][name])
    for _ in range(_SETTLE):
        bullet.stepSimulation()
    moved = {}
    for joint in free(request):
        number, effort = joints[joint["name"]][0], joint["effort"]
        low, high = ends(joint)
        # remaining impulses of earlier drives, such as a door against its stop, would push a light button for
        # seconds
        for name, info in joints.items():
            bullet.resetJointState(body, info[0], request["poses"][0][name])
        seen = [bullet.getJointState(body, number)[0]]
        for end in (high, low):
            for _ in range(round(1.5 * _TURN / _STEP)):
                speed = np.sign(end - seen[-1]) * (high - low) / _TURN
                bullet.setJointMotorControl2(
                    body, number, bullet.VELOCITY_CONTROL, targetVelocity=speed, force=effort
                )
                bullet.stepSimulation()
                seen.append(bullet.getJointState(body, number)[0])
            steps += round(1.5 * _TURN / _STEP)
        bullet.setJointMotorControl2(body, number, bullet.VELOCITY_CONTROL, targetVelocity=0.0, force=effort)
        moved[joint["name"]] = [min(seen), max(seen)]
    positions = [bullet.getJointState(body, info[0])[0] for info in joints.values()]
    return {"moved": moved, "steps": steps, "finite": bool(np.isfinite(positions).all())}


if __name__ == "__main__":
    serve(numbered(read), "pybullet")
