"""Driver of yourdfpy and urchin, which read a URDF into objects with the same attributes."""

import warnings
from typing import Any

import numpy as np
from driver_protocol import in_base, mass_properties, require, serve


def _read(request: dict[str, Any]) -> dict[str, Any]:
    require(request["client"])
    return {"yourdfpy": _read_by_yourdfpy, "urchin": _read_by_urchin}[request["client"]](request)


def _read_by_yourdfpy(request: dict[str, Any]) -> dict[str, Any]:
    import yourdfpy

    # yourdfpy uses a deprecated function of trimesh, for every file
    warnings.filterwarnings("ignore", message=".*Scene.dump", category=DeprecationWarning)
    robot = yourdfpy.URDF.load(request["file"], load_collision_meshes=True)
    said = [] if robot.validate() else ["validate() finds it invalid"]
    poses = []
    for q in request["poses"]:
        robot.update_cfg({name: q[name] for name in robot.actuated_joint_names})
        poses.append({name: robot.get_transform(name, request["links"][0]) for name in request["links"]})
    kinds = {name: joint.type for name, joint in robot.joint_map.items()}
    return {**_links_and_joints(robot, kinds, request), "poses": poses, "said": said}


def _read_by_urchin(request: dict[str, Any]) -> dict[str, Any]:
    import urchin

    robot = urchin.URDF.load(request["file"])
    leading = [joint.name for joint in robot.joints if joint.joint_type != "fixed" and joint.mimic is None]
    poses = []
    for q in request["poses"]:
        frames = robot.link_fk(cfg={name: q[name] for name in leading}, use_names=True)
        poses.append(in_base(frames, request["links"]))
    kinds = {name: joint.joint_type for name, joint in robot.joint_map.items()}
    note = f"{len(robot.visual_trimesh_fk())} visual meshes"
    return {**_links_and_joints(robot, kinds, request), "poses": poses, "note": note}


def _links_and_joints(robot: Any, kinds: dict[str, str], request: dict[str, Any]) -> dict[str, Any]:
    links = {}
    for name in request["links"]:
        inertial = robot.link_map[name].inertial
        origin = np.eye(4) if inertial.origin is None else inertial.origin
        links[name] = mass_properties(inertial.mass, origin[:3, 3], inertial.inertia, origin[:3, :3])
    moving = {name: joint for name, joint in robot.joint_map.items() if kinds[name] != "fixed"}
    return {
        "links": links,
        "joints": {name: _joint(joint, kinds[name]) for name, joint in moving.items()},
        "couplings": {
            name: [joint.mimic.joint, joint.mimic.multiplier, joint.mimic.offset]
            for name, joint in moving.items()
            if joint.mimic is not None
        },
    }


def _joint(joint: Any, kind: str) -> dict[str, Any]:
    return {
        "kind": "prismatic" if kind == "prismatic" else "revolute",
        "limits": None if kind == "continuous" else [joint.limit.lower, joint.limit.upper],
        "damping": joint.dynamics.damping,
        "friction": joint.dynamics.friction,
    }


if __name__ == "__main__":
    serve(_read)
