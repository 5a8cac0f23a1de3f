"""What yourdfpy reads in a URDF."""

from typing import Any

import numpy as np
from driver_protocol import serve
from partnet_request import numbered
from urdf_words import joints_and_couplings


def read(request: dict[str, Any]) -> dict[str, Any]:
    """Return the response to a request."""
    import warnings
    from importlib.metadata import version

    import yourdfpy

    # yourdfpy calls trimesh in a way that trimesh is about to drop, whatever the file
    warnings.filterwarnings("ignore", message=".*Scene.dump", category=DeprecationWarning)
    robot = yourdfpy.URDF.load(request["file"], load_collision_meshes=True)
    said = [] if robot.validate() else ["validate() finds it invalid"]
    links = {}
    for name in request["links"]:
        inertial = robot.link_map[name].inertial
        origin = np.eye(4) if inertial.origin is None else inertial.origin
        turn = origin[:3, :3]
        inertia = turn @ inertial.inertia @ turn.T
        links[name] = {"mass": inertial.mass, "center": origin[:3, 3], "inertia": inertia}
    moving = {name: joint for name, joint in robot.joint_map.items() if joint.type != "fixed"}
    poses = []
    for q in request["poses"]:
        robot.update_cfg({name: q[name] for name in robot.actuated_joint_names})
        poses.append({name: robot.get_transform(name, request["links"][0]) for name in request["links"]})
    return {
        "version": version("yourdfpy"),
        "links": links,
        **joints_and_couplings(moving, {name: joint.type for name, joint in moving.items()}),
        "poses": poses,
        "said": said,
    }


if __name__ == "__main__":
    serve(numbered(read), "yourdfpy")
