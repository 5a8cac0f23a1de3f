"""What urchin reads in a URDF."""

from typing import Any

import numpy as np
from driver_protocol import serve
from partnet_request import numbered


def read(request: dict[str, Any]) -> dict[str, Any]:
    """Return the response to a request."""
    from importlib.metadata import version

    import urchin

    robot = urchin.URDF.load(request["file"])
    links = {}
    for name in request["links"]:
        inertial = robot.link_map[name].inertial
        turn = inertial.origin[:3, :3]
        inertia = turn @ inertial.inertia @ turn.T
        links[name] = {"mass": inertial.mass, "center": inertial.origin[:3, 3], "inertia": inertia}
    moving = {joint.name: joint for joint in robot.joints if joint.joint_type != "fixed"}
    leading = [name for name, joint in moving.items() if joint.mimic is None]
    poses = []
    for q in request["poses"]:
        found = robot.link_fk(cfg={name: q[name] for name in leading}, use_names=True)
        base = np.linalg.inv(found[request["links"][0]])
        poses.append({name: base @ found[name] for name in request["links"]})
    return {
        "version": version("urchin"),
        "links": links,
        "joints": {name: _joint(joint) for name, joint in moving.items()},
        "couplings": {
            name: [joint.mimic.joint, joint.mimic.multiplier, joint.mimic.offset]
            for name, joint in moving.items()
            if joint.mimic is not None
        },
        "poses": poses,
        "note": f"{len(robot.visual_trimesh_fk())} visual meshes",
    }


def _joint(joint: Any) -> dict[str, Any]:
    return {
        "kind": "prismatic" if joint.joint_type == "prismatic" else "revolute",
        "limits": None if joint.joint_type == "continuous" else [joint.limit.lower, joint.limit.upper],
        "damping": joint.dynamics.damping,
        "friction": joint.dynamics.friction,
    }


if __name__ == "__main__":
    serve(numbered(read), "urchin")
