"""Reading an exported URDF with yourdfpy, and faults that URDF readers accept silently."""

import json
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.asset.report import AGAIN, Finding
from artgen.colliders import Convex
from artgen.errors import nearest
from artgen.export.layouts.partnet.names import NAMES_FILE
from artgen.validate.readback.pieces import ReadCollider
from artgen.validate.readback.reading import Faces, Inertial, Law, Reading, Said, listening

_CHECK = "urdf"
_UP = np.array([0.0, 0.0, 1.0, 0.0])
_UPRIGHT = 1e-6  # tolerance of an axis
_SPRING = {"springStiffness": "stiffness", "springReference": "rest"}  # elements of Gazebo


def element_findings(path: Path) -> Iterator[Finding]:
    """Yield names that are ambiguous or unknown, impossible limits, and elements that some readers obey."""
    from lxml import etree

    root = etree.parse(path).getroot()
    names = {tag: [each.get("name", "") for each in root.iterfind(tag)] for tag in ("link", "joint")}
    collisions = [each.get("name", "") for each in root.iterfind("link/collision")]
    for kind, found in {**names, "collision": collisions}.items():
        for name, count in Counter(filter(None, found)).items():
            if count > 1:
                message = f"{count} {kind}s are named {name!r}; readers keep one of them"
                yield Finding(_CHECK, message, **({kind: name} if kind in names else {}), hint=AGAIN)
    yield from _tree_findings(root, names["link"])
    for joint in root.iterfind("joint"):
        yield from _joint_findings(joint, names)
    materials = {each.get("name") for each in root.iterfind("material")}
    for material in root.iterfind("link/visual/material"):
        if not len(material) and material.get("name") not in materials:
            message = f"its material {material.get('name')!r} is not defined in the file"
            yield Finding(_CHECK, message, material.getparent().getparent().get("name"), hint=AGAIN)
    foreign = [(each.tag, "the model") for tag in ("transmission", "mujoco") for each in root.iterfind(tag)]
    for element in root.iterfind("gazebo"):
        place = element.get("reference", "the model")
        foreign += [(word.tag, place) for word in element if word.tag not in _SPRING]
    for tag, place in foreign:
        message = f"it sets <{tag}> of {place!r}, which belongs to the scene"
        yield Finding(_CHECK, message, hint=f"remove <{tag}>")


def _tree_findings(root: Any, links: list[str]) -> Iterator[Finding]:
    children = Counter(each.get("link") for each in root.iterfind("joint/child"))
    for link in links:
        if children[link] > 1:
            yield Finding(_CHECK, f"{children[link]} joints hold it instead of 1", link, hint=AGAIN)
    roots = [name for name in links if not children[name]]
    if len(roots) != 1:
        message = f"it has {len(roots)} links without a parent ({', '.join(roots)}) instead of 1"
        yield Finding(_CHECK, message, value=float(len(roots)), hint=AGAIN)


def _joint_findings(joint: Any, names: Mapping[str, list[str]]) -> Iterator[Finding]:
    name, limit = joint.get("name", ""), joint.find("limit")
    for tag, attribute, known in (
        ("parent", "link", names["link"]),
        ("child", "link", names["link"]),
        ("mimic", "joint", names["joint"]),
    ):
        element = joint.find(tag)
        target = None if element is None else element.get(attribute)
        if target not in known and not (tag == "mimic" and element is None):
            message = f"its {tag} {target!r} is not a {attribute} of the file.{nearest(str(target), known)}"
            yield Finding(_CHECK, message, joint=name, hint=AGAIN)
    for tag in ("safety_controller", "calibration"):
        if joint.find(tag) is not None:
            message = f"its <{tag}> changes its limits for some readers"
            yield Finding(_CHECK, message, joint=name, hint=f"remove <{tag}>")
    if limit is None or joint.get("type") == "fixed":
        return
    low, high, effort, velocity = (
        float(limit.get(key, "0")) for key in ("lower", "upper", "effort", "velocity")
    )
    for what, value in (("effort", effort), ("velocity", velocity)):
        if not value > 0.0:
            message = f"its {what} limit is {value:.4g}; simulators treat the joint as immovable"
            yield Finding(_CHECK, message, joint=name, value=value, hint=AGAIN)
    if joint.get("type") != "continuous" and not low < high:
        message = f"its limits are inverted or empty: from {low:.7g} to {high:.7g}"
        yield Finding(_CHECK, message, joint=name, value=high - low, hint=AGAIN)


@dataclass(frozen=True, eq=False)
class Names:
    """Names of a layout that differ from those of the asset."""

    links: Mapping[str, str]  # link of the asset, by name of the body
    # joint of the asset by name in the file, with -1 for a reversed joint, else 1
    joints: Mapping[str, tuple[str, int]]
    # law of each joint that follows, in the names of the file
    couplings: Mapping[str, Law]
    axes: Array  # rotation from the asset's axes to those of the bodies, by right angles, shape (3, 3)

    @property
    def bodies(self) -> dict[str, str]:
        """Name of the body of each link."""
        return {link: body for body, link in self.links.items()}

    def joint(self, name: str) -> str:
        """Return the joint of the asset for a name in the file."""
        return self.joints.get(name, (name, 1))[0]

    def sign(self, name: str) -> int:
        """Return -1 for a reversed joint, else 1."""
        return self.joints.get(name, (name, 1))[1]

    def law(self, follower: str, law: Law) -> Law:
        """Return a law of the file in terms of the asset's joints."""
        leader, ratio, offset = law
        sign = self.sign(follower)
        return self.joint(leader), sign * self.sign(leader) * ratio, sign * offset


def read_names(path: Path) -> Names | None:
    """Read the names of a layout; None if they are those of the asset."""
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
    """Return a reading with the names, axes and positions of the asset."""
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
            # the layout may turn the asset about the vertical
            away = np.linalg.inv(found[base])
            found = {name: away @ frame for name, frame in found.items()}
        return found

    return replace(
        reading,
        frames=frames,
        inertials={
            name: Inertial(
                each.mass, back @ np.asarray(each.center), back @ np.asarray(each.inertia) @ back.T
            )
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
    """Return the couplings of a file; the table has those between joints of the same parent."""
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


def read(asset: Asset, path: Path) -> Reading:
    """Read a file and its meshes."""
    import yourdfpy
    from lxml import etree

    names = read_names(path)
    bodies = {} if names is None else names.bodies
    with listening() as said:
        robot = yourdfpy.URDF.load(str(path))
        if not robot.validate():
            said.append("yourdfpy finds it invalid")
        own = {link.name: bodies.get(link.name, link.name) for link in asset.links}
        links = {name: robot.link_map[body] for name, body in own.items() if body in robot.link_map}
        colliders = {name: tuple(_colliders(link, path.parent)) for name, link in links.items()}

    def frames(positions: Mapping[str, float]) -> dict[str, Array]:
        with listening():  # yourdfpy repeats its warnings
            robot.update_cfg(
                {name: positions[name] for name in robot.actuated_joint_names if name in positions}
            )
        return dict(_reached(robot, {name: own[name] for name in links}))

    moving = {name: joint for name, joint in robot.joint_map.items() if joint.type != "fixed"}
    springs = _springs(etree.parse(path))
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
    """Yield the frame of each link that joints connect to the root; `bodies` has the names in the file."""
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


def _springs(root: Any) -> dict[str, dict[str, float]]:
    """Return stiffness and rest position in Gazebo's elements, by joint."""
    return {
        element.get("reference"): {word.tag: float(word.text) for word in element if word.tag in _SPRING}
        for element in root.iterfind("gazebo")
        if element.get("reference")
    }


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
    """Return the visible meshes of each link from the scene of yourdfpy."""
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
        found[owners[owner]].append(Faces.of(str(node), vertices, mesh.faces))
    return {name: tuple(each) for name, each in found.items()}


def _holds(asset: Asset, robot: Any) -> dict[str, tuple[str, Array]]:
    """Return the frames of grasps and pushes: fixed links without geometry."""
    mounts = {joint.child: joint for joint in robot.joint_map.values() if joint.type == "fixed"}
    found = {}
    for hold in asset.affordances:
        for name in (f"{hold.kind}_{hold.name}", hold.name, f"grasp_{hold.name}"):
            if name in mounts:
                mount = mounts[name]
                found[hold.name] = (mount.parent, np.asarray(mount.origin, float))
                break
    return found
