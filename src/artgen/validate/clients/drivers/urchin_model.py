"""urchin driver: reads a URDF."""

from typing import Any

import numpy as np
from driver_protocol import serve
from partnet_request import numbered
from urdf_words import joints_and_couplings


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
        **joints_and_couplings(moving, {name: joint.joint_type for name, joint in moving.items()}),
        "poses": poses,
        "note": f"{len(robot.visual_trimesh_fk())} visual meshes",
    }


if __name__ == "__main__":
    serve(numbered(read), "urchin")
