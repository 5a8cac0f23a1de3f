"""Reading an exported URDF with yourdfpy, and names of other layouts."""

import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.colliders import Convex
from artgen.export.layouts.partnet.names import NAMES_FILE
from artgen.validate.readback.pieces import ReadCollider
from artgen.validate.readback.reading import Faces, Inertial, Reading, Said, listening

Law = tuple[str, float, float]

_UP = np.array([0.0, 0.0, 1.0, 0.0])
_UPRIGHT = 1e-6  # error of an axis


@dataclass(frozen=True, eq=False)
class Names:
    """The meaning of the names of a layout."""

    links: Mapping[str, str]  # link of the asset, by name of the body
    # joint of the asset, and -1 where it is turned round, else 1, by name in the file
    joints: Mapping[str, tuple[str, int]]
    # leader, ratio and offset of each joint that follows, in the names of the file
    couplings: Mapping[str, Law]
    axes: Array  # from the asset's coordinates to those of the bodies, shape (3, 3): right angles only

    @property
    def bodies(self) -> dict[str, str]:
        """Name of the body of each link."""
        return {link: body for body, link in self.links.items()}

    def joint(self, name: str) -> str:
        """Return the joint of the asset that a name stands for."""
        return self.joints.get(name, (name, 1))[0]

    def sign(self, name: str) -> int:
        """Return -1 where a joint is turned round, else 1."""
        return self.joints.get(name, (name, 1))[1]

    def law(self, follower: str, law: Law) -> Law:
        """Return a coupling of the file in the joints of the asset."""
        leader, ratio, offset = law
        sign = self.sign(follower)
        return self.joint(leader), sign * self.sign(leader) * ratio, sign * offset


def read_names(path: Path) -> Names | None:
    """Read the meaning of the names in a file; None where they are those of the asset."""
    table = path.parent / NAMES_FILE
    if not table.exists():
        return None
    data = json.loads(table.read_text(encoding="utf-8"))
    return Names(
        {str(body): str(link) for body, link in data["links"].items()},
        {str(name): (str(each["name"]), int(each["sign"])) for name, each in data["joints"].items()},
        {str(name): (str(law[0]), float(law[1]), float(law[2])) for name, law in data["couplings"].items()},
        np.array(data["axes"], float),
    )


def translated(reading: Reading, names: Names, base: str) -> Reading:
    """Return a reading in the names, axes and positions of the asset."""
    back = names.axes.T
    turn = np.eye(4)
    turn[:3, :3] = names.axes

    def frames(positions: Mapping[str, float]) -> dict[str, Array]:
        own = {
            name: sign * positions[joint]
            for name, (joint, sign) in names.joints.items()
            if joint in positions
        }
        found = {name: frame @ turn for name, frame in reading.frames(own).items()}
        if base in found and np.abs(found[base][:, 2] - _UP).max() <= _UPRIGHT:
            # the layout may have its front elsewhere, but not its top
            away = np.linalg.inv(found[base])
            found = {name: away @ frame for name, frame in found.items()}
        return found

    return replace(
        reading,
        frames=frames,
        inertials={
            name: Inertial(each.mass, back @ each.center, back @ each.inertia @ names.axes)
            for name, each in reading.inertials.items()
        },
        kinds={names.joint(name): kind for name, kind in reading.kinds.items()},
        ends={
            names.joint(name): (names.links.get(first, first), names.links.get(second, second))
            for name, (first, second) in reading.ends.items()
        },
        limits={names.joint(name): _turned(each, names.sign(name)) for name, each in reading.limits.items()},
        axes={names.joint(name): names.sign(name) * (back @ axis) for name, axis in reading.axes.items()},
        dynamics={
            names.joint(name): tuple(
                Said(
                    each.field,
                    names.sign(name) * each.value if each.field == "rest" else each.value,
                    each.source,
                )
                for each in said
            )
            for name, said in reading.dynamics.items()
        },
        couplings={names.joint(name): names.law(name, law) for name, law in _laws(reading, names).items()},
        colliders={
            name: tuple(_piece(piece, back) for piece in pieces) for name, pieces in reading.colliders.items()
        },
        faces={
            name: tuple(Faces(each.name, _bounds(each.bounds, back), each.count) for each in faces)
            for name, faces in reading.faces.items()
        },
        holds=None,
    )


def _laws(reading: Reading, names: Names) -> dict[str, Law]:
    """Return the couplings of a file; those between joints of one body are in the table, not in the URDF."""
    laws = dict(reading.couplings)
    for follower, law in names.couplings.items():
        ends = [reading.ends.get(name) for name in (follower, law[0])]
        if ends[0] and ends[1] and ends[0][0] == ends[1][0]:
            laws.setdefault(follower, law)
    return laws


def _turned(limits: tuple[float, float] | None, sign: int) -> tuple[float, float] | None:
    return limits if limits is None or sign > 0 else (-limits[1], -limits[0])


def _bounds(bounds: Array, turn: Array) -> Array:
    return np.sort(bounds @ turn.T, axis=0)


def _piece(piece: ReadCollider, turn: Array) -> ReadCollider:
    return replace(
        piece,
        bounds=_bounds(piece.bounds, turn),
        middle=turn @ piece.middle,
        vertices=piece.vertices @ turn.T,
    )


def read_urdf(asset: Asset, path: Path) -> Reading:
    """Read a file and its meshes."""
    import yourdfpy
    from lxml import etree

    names = read_names(path)
    bodies = {} if names is None else names.bodies
    tree = etree.parse(path)  # yourdfpy reads as much as it can of broken XML, and says nothing
    with listening() as said:
        robot = yourdfpy.URDF.load(str(path))
        if not robot.validate():
            said.append("yourdfpy finds it invalid")
        own = {link.name: bodies.get(link.name, link.name) for link in asset.links}
        links = {name: robot.link_map[body] for name, body in own.items() if body in robot.link_map}
        colliders = {name: tuple(_colliders(link, path.parent)) for name, link in links.items()}

    def frames(positions: Mapping[str, float]) -> dict[str, Array]:
        with listening():  # it repeats what it said when it read the file
            robot.update_cfg(
                {name: positions[name] for name in robot.actuated_joint_names if name in positions}
            )
        return dict(_reached(robot, {name: own[name] for name in links}))

    moving = {name: joint for name, joint in robot.joint_map.items() if joint.type != "fixed"}
    springs = _springs(tree)
    reading = Reading(
        path.name,
        frames,
        inertials={name: _inertial(link) for name, link in links.items() if link.inertial is not None},
        mass=sum(float(link.inertial.mass) for link in robot.link_map.values() if link.inertial is not None),
        kinds={
            name: "prismatic" if joint.type == "prismatic" else "revolute" for name, joint in moving.items()
        },
        ends={name: (joint.parent, joint.child) for name, joint in moving.items()},
        limits={
            name: None if joint.type == "continuous" else (joint.limit.lower, joint.limit.upper)
            for name, joint in moving.items()
        },
        axes={name: np.array(joint.axis, float) for name, joint in moving.items()},
        dynamics={name: tuple(_dynamics(joint, springs.get(name, {}))) for name, joint in moving.items()},
        couplings={
            name: (joint.mimic.joint, _or(joint.mimic.multiplier, 1.0), _or(joint.mimic.offset, 0.0))
            for name, joint in moving.items()
            if joint.mimic is not None
        },
        colliders=colliders,
        faces=_faces(robot, links),
        holds=_holds(asset, robot),
        said=tuple(said),
    )
    return reading if names is None else translated(reading, names, asset.links[0].name)


def _reached(robot: Any, bodies: Mapping[str, str]) -> Iterator[tuple[str, Array]]:
    """Yield the frames of the links, given by their bodies, that joints lead to from the root."""
    for name, body in bodies.items():
        try:
            yield name, np.asarray(robot.get_transform(body))
        except ValueError:
            continue


def _or(value: float | None, default: float) -> float:
    return default if value is None else float(value)


def _inertial(link: Any) -> Inertial:
    inertial = link.inertial
    origin = np.eye(4) if inertial.origin is None else np.asarray(inertial.origin)
    turn = origin[:3, :3]
    return Inertial(float(inertial.mass), origin[:3, 3], turn @ np.asarray(inertial.inertia) @ turn.T)


def _springs(tree: Any) -> dict[str, dict[str, float]]:
    """Return what Gazebo's words say of springs, by joint."""
    return {
        element.get("reference"): {word.tag: float(word.text) for word in element if word.tag in _SPRING}
        for element in tree.iterfind("gazebo")
        if element.get("reference")
    }


_SPRING = {"springStiffness": "stiffness", "springReference": "rest"}


def _dynamics(joint: Any, spring: Mapping[str, float]) -> Iterator[Said]:
    if joint.limit is not None:
        yield Said("effort", _or(joint.limit.effort, 0.0), "effort")
        yield Said("velocity", _or(joint.limit.velocity, 0.0), "velocity")
    if joint.dynamics is not None:
        yield Said("damping", _or(joint.dynamics.damping, 0.0), "damping")
        yield Said("friction", _or(joint.dynamics.friction, 0.0), "friction")
    for tag, value in spring.items():
        yield Said(_SPRING[tag], value, tag)


def _colliders(link: Any, directory: Path) -> Iterator[ReadCollider]:
    for collision in link.collisions:
        geometry = collision.geometry
        pose = np.eye(4) if collision.origin is None else np.asarray(collision.origin, float)
        name = collision.name or "without a name"
        if geometry.box is not None:
            yield ReadCollider.primitive(name, Convex("box", pose, tuple(map(float, geometry.box.size))))
        elif geometry.sphere is not None:
            yield ReadCollider.primitive(name, Convex("sphere", pose, (float(geometry.sphere.radius),)))
        elif geometry.cylinder is not None:
            size = (float(geometry.cylinder.radius), float(geometry.cylinder.length))
            yield ReadCollider.primitive(name, Convex("cylinder", pose, size))
        else:
            yield _mesh_piece(name, geometry.mesh, pose, directory)


def _mesh_piece(name: str, mesh: Any, pose: Array, directory: Path) -> ReadCollider:
    import trimesh

    loaded = trimesh.load_mesh(directory / mesh.filename, process=False)
    scale = np.ones(3) if mesh.scale is None else np.asarray(mesh.scale, float) * np.ones(3)
    vertices = (np.asarray(loaded.vertices) * scale) @ pose[:3, :3].T + pose[:3, 3]
    flaw = "" if (scale > 0.0).all() else f"is mirrored by a scale of {scale.min():.4g}"
    return ReadCollider.mesh(name, vertices, np.asarray(loaded.faces, np.int64), flaw=flaw)


def _faces(robot: Any, links: Mapping[str, Any]) -> dict[str, tuple[Faces, ...]]:
    """Return the visible faces of each link, from the scene that yourdfpy makes of them."""
    graph = robot.scene.graph
    owners = {link.name: name for name, link in links.items()}
    found: dict[str, list[Faces]] = {name: [] for name in links}
    for node in graph.nodes_geometry:
        owner = node
        while owner is not None and owner not in owners:
            owner = graph.transforms.parents.get(owner)
        if owner is None:
            continue
        pose, name = graph.get(node, frame_from=owner)
        mesh = robot.scene.geometry[name]
        vertices = np.asarray(mesh.vertices) @ pose[:3, :3].T + pose[:3, 3]
        bounds = np.array([vertices.min(axis=0), vertices.max(axis=0)])
        found[owners[owner]].append(Faces(str(node), bounds, len(mesh.faces)))
    return {name: tuple(each) for name, each in found.items()}


def _holds(asset: Asset, robot: Any) -> dict[str, tuple[str, Array]]:
    """Return the frames of grasps and pushes: links without extent that are fixed there."""
    mounts = {joint.child: joint for joint in robot.joint_map.values() if joint.type == "fixed"}
    found = {}
    for hold in asset.affordances:
        for name in (f"{hold.kind}_{hold.name}", hold.name, f"grasp_{hold.name}"):
            if name in mounts:
                mount = mounts[name]
                found[hold.name] = (mount.parent, np.asarray(mount.origin, float))
                break
    return found
