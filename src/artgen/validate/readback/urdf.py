"""Reading an exported URDF with yourdfpy, and faults that URDF readers accept silently."""

import json
from collections import Counter
from collections.abc import Iterator, Mapping
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.asset.files import ASSET_FILE, file_content
from artgen.asset.report import AGAIN, Finding
from artgen.colliders import Convex
from artgen.errors import AssetError, nearest
from artgen.export.names import Names, read_names
from artgen.export.urdf import SPECK, UNMARKED
from artgen.validate.readback.reading import (
    UNLIMITED,
    Faces,
    Inertial,
    Law,
    ReadCollider,
    Reading,
    ReadJoint,
    Stated,
    collected_messages,
)

_UP = np.array([0.0, 0.0, 1.0, 0.0])
_UPRIGHT = 1e-6  # tolerance of an axis
_SPRING = {"springStiffness": "stiffness", "springReference": "rest"}  # elements of Gazebo

_SMALLEST = 2.01  # width of a speck over its radius
_MOST_MORE = 1000  # links without a counterpart in the asset: marks of grasps, bodies between joints
_TEXTS = ("name", "type", "link", "joint", "reference", "filename")  # attributes without numbers

_fault = partial(Finding, "urdf", hint=AGAIN)


def element_findings(path: Path) -> Iterator[Finding]:
    """Yield names that are ambiguous or unknown, impossible limits, and elements that some readers obey."""
    from lxml import etree

    root = etree.parse(path).getroot()
    for element in root.iter(etree.Element):
        yield from _number_findings(element)
    links, joints = ([each.get("name", "") for each in root.iterfind(tag)] for tag in ("link", "joint"))
    collisions = [each.get("name", "") for each in root.iterfind("link/collision")]
    for kind, found in (("link", links), ("joint", joints), ("collision", collisions)):
        for name, count in Counter(filter(None, found)).items():
            if count > 1:
                place = {} if kind == "collision" else {kind: name}
                yield _fault(f"{count} {kind}s are named {name!r}; readers keep one of them", **place)
    parents = Counter(each.get("link") for each in root.iterfind("joint/child"))
    for link in links:
        if parents[link] > 1:
            yield _fault(f"{parents[link]} joints hold it instead of 1", link)
    roots = [name for name in links if not parents[name]]
    if len(roots) != 1:
        message = f"it has {len(roots)} links without a parent ({', '.join(roots)}) instead of 1"
        yield _fault(message, value=float(len(roots)))
    for joint in root.iterfind("joint"):
        yield from _joint_findings(joint, {"link": links, "joint": joints})
    yield from _foreign_findings(root)


def _number_findings(element: Any) -> Iterator[Finding]:
    """Yield numbers that are not finite; 1e999 is one of them, because it exceeds the largest float."""
    stated = [(f" {key}", value) for key, value in element.items() if key not in _TEXTS]
    stated.append(("", element.text or ""))
    for key, value in stated:
        with suppress(ValueError):  # text
            if not np.isfinite([float(word) for word in value.split()]).all():
                owners = [each for each in (element, *element.iterancestors()) if each.get("name")]
                place = {each.tag: each.get("name") for each in owners if each.tag in ("link", "joint")}
                line = f"line {element.sourceline}: <{element.tag}{key}>"
                yield _fault(f"{line} is {value.strip()!r}, which is not a finite number", **place)


def _foreign_findings(root: Any) -> Iterator[Finding]:
    """Yield undefined materials, and elements that only some readers obey."""
    materials = {each.get("name") for each in root.iterfind("material")}
    for material in root.iterfind("link/visual/material"):
        if not len(material) and material.get("name") not in materials:
            message = f"its material {material.get('name')!r} is not defined in the file"
            yield _fault(message, material.getparent().getparent().get("name"))
    foreign = [(each.tag, "the model") for tag in ("transmission", "mujoco") for each in root.iterfind(tag)]
    for element in root.iterfind("gazebo"):
        place = element.get("reference", "the model")
        foreign += [(word.tag, place) for word in element if word.tag not in _SPRING]
    for tag, place in foreign:
        yield _fault(f"it sets <{tag}> of {place!r}, which belongs to the scene", hint=f"remove <{tag}>")


def _joint_findings(joint: Any, names: Mapping[str, list[str]]) -> Iterator[Finding]:
    fault, limit = partial(_fault, joint=joint.get("name", "")), joint.find("limit")
    for tag, kind in (("parent", "link"), ("child", "link"), ("mimic", "joint")):
        element = joint.find(tag)
        target = None if element is None else element.get(kind)
        if target not in names[kind] and not (tag == "mimic" and element is None):
            suggestion = nearest(str(target), names[kind])
            yield fault(f"its {tag} {target!r} is not a {kind} of the file.{suggestion}")
    for tag in ("safety_controller", "calibration"):
        if joint.find(tag) is not None:
            yield fault(f"its <{tag}> changes its limits for some readers", hint=f"remove <{tag}>")
    if limit is None or joint.get("type") == "fixed":
        return
    for name in ("effort", "velocity"):
        value = float(limit.get(name, "0"))
        if not value > 0.0:
            message = f"its {name} limit is {value:.4g}; simulators treat the joint as immovable"
            yield fault(message, value=value)
    low, high = (float(limit.get(key, "0")) for key in ("lower", "upper"))
    if joint.get("type") != "continuous" and not low < high:
        message = f"its limits are inverted or empty: from {low:.7g} to {high:.7g}"
        yield fault(message, value=high - low)


def read(asset: Asset, path: Path) -> Reading:
    """Read a file and its meshes, in the names, axes and positions of the asset."""
    import yourdfpy
    from lxml import etree

    count = sum(1 for _ in etree.parse(path).getroot().iterfind("link"))
    if count > len(asset.links) + _MOST_MORE:  # yourdfpy would take minutes
        raise AssetError(f"it has {count} links, where the asset has {len(asset.links)}")
    names, turn = read_names(path.parent), np.eye(4)
    turn[:3, :3] = names.axes
    bodies = {link: body for body, link in names.links.items()}
    base, back = asset.links[0].name, turn.T
    with collected_messages() as messages:
        robot = yourdfpy.URDF.load(str(path))
        if not robot.validate():
            messages.append("yourdfpy finds it invalid")
        own = {link.name: bodies.get(link.name, link.name) for link in asset.links}
        links = {name: robot.link_map[body] for name, body in own.items() if body in robot.link_map}
        colliders = {name: tuple(_colliders(link, path.parent, back)) for name, link in links.items()}

    def frames(positions: Mapping[str, float]) -> dict[str, Array]:
        places = {}
        for name in robot.actuated_joint_names:
            joint, sign = names.joint(name)
            if joint in positions:
                places[name] = sign * positions[joint]
        with collected_messages():  # yourdfpy repeats its warnings
            robot.update_cfg(places)
        found = {}
        for name in links:
            with suppress(ValueError):  # no joints lead to it from the root
                found[name] = np.asarray(robot.get_transform(own[name])) @ turn
        if names.links and base in found and np.abs(found[base][:, 2] - _UP).max() <= _UPRIGHT:
            # the layout may turn the asset about the vertical
            away = np.linalg.inv(found[base])
            found = {name: away @ frame for name, frame in found.items()}
        return found

    moving = {name: joint for name, joint in robot.joint_map.items() if joint.type != "fixed"}
    springs = {
        element.get("reference"): {word.tag: float(word.text) for word in element if word.tag in _SPRING}
        for element in etree.parse(path).iterfind("gazebo")
        if element.get("reference")
    }
    return Reading(
        path.name,
        frames,
        inertials={name: _inertial(link, back) for name, link in links.items() if link.inertial is not None},
        mass=sum(float(link.inertial.mass) for link in robot.link_map.values() if link.inertial is not None),
        joints={
            names.joint(name)[0]: _joint(joint, springs.get(name, {}), names)
            for name, joint in moving.items()
        },
        couplings=dict(_couplings(moving, names)),
        colliders=colliders,
        faces=_faces(robot, links, back),
        holds=None if names.links or not _marked(path) else _holds(asset, robot),
        complaints=tuple(messages),
    )


def _or(value: float | None, default: float) -> float:
    return default if value is None else float(value)


def _inertial(link: Any, back: Array) -> Inertial:
    inertial = link.inertial
    origin = back if inertial.origin is None else back @ np.asarray(inertial.origin)
    turn = origin[:3, :3]
    return Inertial(float(inertial.mass), origin[:3, 3], turn @ np.asarray(inertial.inertia) @ turn.T)


def _joint(joint: Any, spring: Mapping[str, float], names: Names) -> ReadJoint:
    sign = names.joint(joint.name)[1]
    limits = UNLIMITED if joint.type == "continuous" else (joint.limit.lower, joint.limit.upper)
    low, high = (sign * limit for limit in limits[::sign])
    dynamics = [
        Stated(name, _or(getattr(part, name), 0.0), name)
        for part, fields in ((joint.limit, ("effort", "velocity")), (joint.dynamics, ("damping", "friction")))
        for name in (fields if part is not None else ())
    ]
    for tag, value in spring.items():
        dynamics.append(Stated(_SPRING[tag], sign * value if _SPRING[tag] == "rest" else value, tag))
    return ReadJoint(
        "prismatic" if joint.type == "prismatic" else "revolute",
        (names.links.get(joint.parent, joint.parent), names.links.get(joint.child, joint.child)),
        (low, high),
        sign * (names.axes.T @ np.array(joint.axis, float)),
        tuple(dynamics),
    )


def _couplings(moving: Mapping[str, Any], names: Names) -> Iterator[tuple[str, Law]]:
    """Yield the law of each joint that follows; a layout's table has those between joints of one parent."""
    laws = {
        follower: law
        for follower, law in names.couplings.items()
        if {follower, law[0]} <= moving.keys() and moving[follower].parent == moving[law[0]].parent
    }
    for name, joint in moving.items():
        if (mimic := joint.mimic) is not None:
            laws[name] = (mimic.joint, _or(mimic.multiplier, 1.0), _or(mimic.offset, 0.0))
    for follower, (leader, ratio, offset) in laws.items():
        (name, sign), (head, sign_of_leader) = names.joint(follower), names.joint(leader)
        yield name, (head, sign * sign_of_leader * ratio, sign * offset)


def _colliders(link: Any, directory: Path, back: Array) -> Iterator[ReadCollider]:
    for collision in link.collisions:
        geometry = collision.geometry
        pose = back if collision.origin is None else back @ np.asarray(collision.origin, float)
        name = collision.name or "without a name"
        if geometry.mesh is not None:
            yield _mesh_piece(name, geometry.mesh, pose, directory)
        elif geometry.box is not None:
            yield ReadCollider.primitive(name, Convex("box", pose, tuple(map(float, geometry.box.size))))
        elif geometry.sphere is not None:
            yield ReadCollider.primitive(name, Convex("sphere", pose, (float(geometry.sphere.radius),)))
        else:
            size = (float(geometry.cylinder.radius), float(geometry.cylinder.length))
            yield ReadCollider.primitive(name, Convex("cylinder", pose, size))


def _mesh_piece(name: str, mesh: Any, pose: Array, directory: Path) -> ReadCollider:
    import trimesh

    loaded = trimesh.load_mesh(directory / mesh.filename, process=False)
    scale = np.ones(3) if mesh.scale is None else np.asarray(mesh.scale, float) * np.ones(3)
    vertices = (np.asarray(loaded.vertices) * scale) @ pose[:3, :3].T + pose[:3, 3]
    flaw = "" if (scale > 0.0).all() else f"is mirrored by a scale of {scale.min():.4g}"
    return ReadCollider.mesh(name, vertices, np.asarray(loaded.faces, np.int64), flaw=flaw)


def _faces(robot: Any, links: Mapping[str, Any], back: Array) -> dict[str, tuple[Faces, ...]]:
    """Return the visible meshes of each link from the scene of yourdfpy."""
    graph = robot.scene.graph
    owners = {link.name: name for name, link in links.items()}
    found: dict[str, list[Faces]] = {name: [] for name in links}
    for node in graph.nodes_geometry:
        owner = next((each for each in _ancestors(graph, node) if each in owners), None)
        if owner is None:
            continue
        pose, name = graph.get(node, frame_from=owner)
        pose = back @ pose
        mesh = robot.scene.geometry[name]
        vertices = np.asarray(mesh.vertices) @ pose[:3, :3].T + pose[:3, 3]
        nearest = next(each for each in _ancestors(graph, node) if each in robot.link_map)
        if nearest != owner and np.ptp(vertices, axis=0).max() <= _SMALLEST * SPECK:
            continue  # of a link between two joints
        found[owners[owner]].append(Faces.of(str(node), vertices, mesh.faces))
    return {name: tuple(each) for name, each in found.items()}


def _ancestors(graph: Any, node: str) -> Iterator[str]:
    """Yield a node of a scene and the nodes above it."""
    above: str | None = node
    while above is not None:
        yield above
        above = graph.transforms.parents.get(above)


def _marked(path: Path) -> bool:
    """Tell whether the export has links for grasps and pushes; an export without them lists the losses."""
    with suppress(FileNotFoundError):
        losses = json.loads(file_content(path.parent / ASSET_FILE))["formats"]["urdf"]["losses"]
        return not any(loss["instead"] == UNMARKED and "frame" in loss["feature"] for loss in losses)
    return True


def _holds(asset: Asset, robot: Any) -> dict[str, tuple[str, Array]]:
    """Return the frames of grasps and pushes: fixed links without geometry."""
    mounts = {joint.child: joint for joint in robot.joint_map.values() if joint.type == "fixed"}
    found = {}
    for hold in asset.affordances:
        for name in (f"grasp_{hold.name}", hold.name, f"{hold.kind}_{hold.name}"):  # the last one counts
            if name in mounts:
                found[hold.name] = (mounts[name].parent, np.asarray(mounts[name].origin, float))
    return found
