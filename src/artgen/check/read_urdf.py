"""Reading an exported URDF with yourdfpy."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from artgen.asset import Asset
from artgen.check.reading import Inertial, Reading, listening, mesh_volume

Array = NDArray[np.float64]


def read_urdf(asset: Asset, path: Path) -> Reading:
    """Read a file and its meshes.

    Args:
        asset: The asset whose links are looked for.
        path: The file.
    """
    import yourdfpy
    from lxml import etree

    etree.parse(path)  # yourdfpy reads as much as it can of broken XML, and says nothing
    with listening() as said:
        robot = yourdfpy.URDF.load(str(path))
        if not robot.validate():
            said.append("yourdfpy finds it invalid")
        links = {link.name: robot.link_map[link.name] for link in asset.links if link.name in robot.link_map}
        colliders = {name: _colliders(link, path.parent) for name, link in links.items()}

    def frames(positions: Mapping[str, float]) -> dict[str, Array]:
        robot.update_cfg({name: positions[name] for name in robot.actuated_joint_names if name in positions})
        return {name: np.asarray(robot.get_transform(name)) for name in links}

    moving = {name: joint for name, joint in robot.joint_map.items() if joint.type != "fixed"}
    return Reading(
        path.name,
        frames,
        {name: _inertial(link) for name, link in links.items() if link.inertial is not None},
        {name: "prismatic" if joint.type == "prismatic" else "revolute" for name, joint in moving.items()},
        {
            name: None if joint.type == "continuous" else (joint.limit.lower, joint.limit.upper)
            for name, joint in moving.items()
        },
        {name: np.array(joint.axis, float) for name, joint in moving.items()},
        {
            name: (joint.mimic.joint, _or(joint.mimic.multiplier, 1.0), _or(joint.mimic.offset, 0.0))
            for name, joint in moving.items()
            if joint.mimic is not None
        },
        colliders,
        tuple(said),
    )


def _or(value: float | None, default: float) -> float:
    return default if value is None else float(value)


def _inertial(link: Any) -> Inertial:
    inertial = link.inertial
    origin = np.eye(4) if inertial.origin is None else np.asarray(inertial.origin)
    turn = origin[:3, :3]
    return Inertial(float(inertial.mass), origin[:3, 3], turn @ np.asarray(inertial.inertia) @ turn.T)


def _colliders(link: Any, directory: Path) -> tuple[int, float]:
    """Return number and total volume of the colliders of a link."""
    volume = 0.0
    for collision in link.collisions:
        geometry = collision.geometry
        if geometry.box is not None:
            volume += float(np.prod(geometry.box.size))
        elif geometry.sphere is not None:
            volume += 4.0 / 3.0 * np.pi * geometry.sphere.radius**3
        elif geometry.cylinder is not None:
            volume += np.pi * geometry.cylinder.radius**2 * geometry.cylinder.length
        else:
            volume += _mesh_volume(directory / geometry.mesh.filename)
    return len(link.collisions), volume


def _mesh_volume(path: Path) -> float:
    import trimesh

    mesh = trimesh.load_mesh(path, process=False)
    return mesh_volume(np.asarray(mesh.vertices), np.asarray(mesh.faces))
