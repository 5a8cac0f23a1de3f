"""URDF of other tools: links, joints and colliders; what belongs to single simulators is ignored."""

import math
import re
import xml.etree.ElementTree as ET
from collections import Counter, deque
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import NoReturn, cast

import numpy as np

from artgen._arrays import Array
from artgen.asset import AssetCoupling, AssetJoint, rotation
from artgen.colliders import Convex, Kind
from artgen.errors import AssetError, ExportError
from artgen.referee.files import (
    MOST_LENGTH,
    line_of,
    numbers,
    offset_of,
    parse_xml,
    safe_path,
    shown,
    similar,
)
from artgen.referee.meshes import Hulls, noted
from artgen.referee.model import MOST_BODIES, MOST_GEOMS, ForeignBody, ForeignGeom, ForeignModel, Meshes

_MOVING = ("revolute", "continuous", "prismatic")
_APART = ("floating", "planar", "spherical")  # the last one is PyBullet's
_TYPES = ("fixed", *_MOVING, *_APART)
_SHAPES = {"box": {"size": 3}, "sphere": {"radius": 1}, "cylinder": {"radius": 1, "length": 1}}
_SHAPES["capsule"] = _SHAPES["cylinder"]  # not in every version of URDF
_DRAKE = "drake:"  # prefix of Drake's own joints and shapes
_FAR = 1e9  # a joint between limits beyond this is unlimited [rad or m]
_THIN = 1e-8  # a thinner collider is flat [m]
_EFFORT = ' effort="1000" velocity="1000"'  # of a continuous joint without a limit; URDF requires them
_TAG = re.compile(rb"""<[^\s/>]+(\s+[^\s=]+\s*=\s*("[^"]*"|'[^']*'))*\s*/?>""")


def read_urdf(path: Path, *, meshes: Meshes = "hull", root: Path) -> ForeignModel:
    """Read a URDF.

    Args:
        path: The file.
        meshes: How a mesh that is not convex becomes convex.
        root: Folder that contains all meshes that may be read.

    Raises:
        AssetError: The file or a mesh cannot be read, or contradicts itself or the specification of URDF.
    """
    return _Reader(path, root, meshes).model()


def repaired_urdf(path: Path, limits: Mapping[str, tuple[float, float]], out: Path) -> None:
    """Write a copy of a URDF with other limits of some joints; the rest of its text stays.

    A continuous joint becomes revolute. Equal limits lock a joint.

    Args:
        path: The file.
        limits: Lowest and highest position, by name of the joint [rad or m].
        out: The copy, in the folder of the file, so that the paths of meshes hold.

    Raises:
        AssetError: A joint is unknown or fixed, limits are inverted, or `out` is the file or elsewhere.
        ExportError: The copy cannot be written.
    """
    if out.resolve().parent != path.resolve().parent or out.resolve() == path.resolve():
        raise AssetError(f"{out} must be another file in the folder of {path}: there, its meshes are found")
    reader = _Reader(path, path.parent, "hull")
    text = path.read_bytes()
    edits: list[tuple[int, int, bytes]] = []  # start, end and new bytes
    for name, (low, high) in limits.items():
        if name not in reader.joints:
            raise AssetError(f"{path.name} has no joint {shown(name)}.{similar(name, reader.joints)}")
        joint = reader.joints[name]
        if joint.get("type") not in _MOVING or not -math.inf < low <= high < math.inf:
            reader.refuse(joint, f"cannot have the limits {low:g}, {high:g}: it must move, low before high")
        if joint.get("type") == "continuous":
            edits.append(_edit(text, joint, {"type": "revolute"}))
        values = {"lower": repr(float(low)), "upper": repr(float(high))}
        if (limit := joint.find("limit")) is not None:
            edits.append(_edit(text, limit, values))
        else:
            end = _tag(text, joint).end()
            added = f'<limit lower="{values["lower"]}" upper="{values["upper"]}"{_EFFORT}/>'
            edits.append((end, end, added.encode()))
    for start, end, new in sorted(edits, reverse=True):
        text = text[:start] + new + text[end:]
    try:
        out.write_bytes(text)
    except OSError as error:
        raise ExportError(f"cannot write {out}: {error.strerror}") from None


def _tag(text: bytes, element: ET.Element) -> re.Match[bytes]:
    """Return the start tag of an element in the text of its file."""
    found = _TAG.match(text, offset_of(element))
    if found is None:
        raise AssetError(f"<{element.tag}> in line {line_of(element)} has another encoding; save it as UTF-8")
    return found


def _edit(text: bytes, element: ET.Element, values: Mapping[str, str]) -> tuple[int, int, bytes]:
    """Return where the start tag of an element is, and the tag with other values of attributes."""
    tag = _tag(text, element)
    new = tag[0]
    for key, value in values.items():
        if key in element.attrib:
            old = rf"""(\s{key}\s*=\s*)("[^"]*"|'[^']*')"""
            new = re.sub(old.encode(), rb'\1"' + value.encode() + b'"', new, count=1)
        else:
            new = re.sub(rb"(\s*/?>)$", f' {key}="{value}"'.encode() + rb"\1", new)
    return tag.start(), tag.end(), new


class _Reader:
    """Reads one file."""

    def __init__(self, path: Path, root: Path, meshes: Meshes) -> None:
        self.path, self.root, self.hulls = path, root, Hulls(meshes)
        self.robot = parse_xml(path)
        if self.robot.tag != "robot":
            self.refuse(self.robot, "is the root; the root of a URDF is <robot>")
        for element in self.robot.iter():
            if element.tag.startswith("xacro:"):
                self.refuse(element, "belongs to xacro; expand the file first: xacro FILE > robot.urdf")
        self.links, self.joints = self._named("link"), self._named("joint")
        self.notes: dict[tuple[str, str, str], list[str]] = {}  # names by kind, its plural, and what is said
        # names of geoms: those that the file gives once, and then those that are made
        found = Counter(each.get("name", "") for each in self.robot.iterfind("link/collision"))
        self.own = frozenset(name for name, count in found.items() if name and count == 1)
        self.taken = set(self.own)
        if found.total() > MOST_GEOMS:
            self.refuse(self.robot, f"has {found.total()} colliders; at most {MOST_GEOMS} are read: split it")
        self.count = 0  # of convex pieces

    def refuse(self, element: ET.Element, fault: str) -> NoReturn:
        """Raise the error of an element."""
        raise AssetError(f"{self._place(element)} {fault}")

    def model(self) -> ForeignModel:
        """Return the model."""
        above, below = self._tree()
        queue = deque((name, "", np.eye(4)) for name in self.links if name not in above)
        bodies: list[ForeignBody] = []
        while queue:
            name, parent, pose = queue.popleft()
            joints, apart = self._joints(above[name], pose) if parent else ((), "")
            bodies.append(ForeignBody(name, tuple(self._geoms(name, pose)), parent, joints, apart))
            queue += [(child, name, pose @ self._origin(joint)) for child, joint in below[name]]
        filters = [each.get("name", "") for each in self.robot.iter(f"{_DRAKE}collision_filter_group")]
        if filters:
            self.notes["collision filter", "collision filters", "obeyed by Drake alone: not obeyed"] = filters
        notes = [noted(one, many, names, what) for (one, many, what), names in self.notes.items()]
        return ForeignModel(self.path, "urdf", tuple(bodies), notes=(*notes, *self.hulls.notes()))

    def _place(self, element: ET.Element) -> str:
        name = f" {shown(element.attrib['name'])}" if "name" in element.attrib else ""
        return f"{self.path.name}, line {line_of(element)}: <{shown(element.tag)[1:-1]}>{name}"

    def _named(self, tag: str) -> dict[str, ET.Element]:
        """Return the elements of the robot with a tag, by name."""
        found: dict[str, ET.Element] = {}
        for element in self.robot:
            if element.tag.removeprefix(_DRAKE) != tag:
                continue
            if not (name := element.get("name", "")):
                self.refuse(element, f"has no name; give each {tag} a name of its own")
            if name in found:
                self.refuse(element, f"has the name of the {tag} in line {line_of(found[name])}; rename one")
            found[name] = element
        if len(found) > MOST_BODIES:
            self.refuse(self.robot, f"has {len(found)} {tag}s; at most {MOST_BODIES} are read: split it")
        return found

    def _tree(self) -> tuple[dict[str, ET.Element], dict[str, list[tuple[str, ET.Element]]]]:
        """Return the joint above each link, and the children below each with their joints; check the tree."""
        if not self.links:
            self.refuse(self.robot, "has no <link>; a URDF has at least one")
        above: dict[str, ET.Element] = {}
        below: dict[str, list[tuple[str, ET.Element]]] = {name: [] for name in self.links}
        for joint in self.joints.values():
            parent, child = self._end(joint, "parent"), self._end(joint, "child")
            if child in above:
                other = f"the joint in line {line_of(above[child])}"
                self.refuse(joint, f"has the child {shown(child)}, as {other} has; a link has one parent")
            above[child] = joint
            below[parent].append((child, joint))
        roots = [name for name in self.links if name not in above]
        if len(roots) > 1:
            others = f"as {shown(roots[0])}" + (f" and {len(roots) - 2} more" if len(roots) > 2 else "")
            self.refuse(self.links[roots[1]], f"has no parent, {others}; a URDF has one root: join them")
        queue, reached = deque(roots), set(roots)
        while queue:
            children = [child for child, _ in below[queue.popleft()]]
            queue += children
            reached.update(children)
        for name, joint in above.items():
            if name not in reached:
                self.refuse(joint, "is in a circle of joints, or below one; a URDF is a tree: remove a joint")
        return above, below

    def _end(self, joint: ET.Element, tag: str) -> str:
        """Return the parent or the child of a joint."""
        found = joint.find(tag)
        if found is None:
            self.refuse(joint, f"has no <{tag}>; name a link")
        if (name := found.get("link", "")) not in self.links:
            self.refuse(found, f"is {shown(name)}, which is no link.{similar(name, self.links)}")
        return name

    def _numbers(self, element: ET.Element, key: str, count: int, default: str = "") -> tuple[float, ...]:
        """Return the numbers of an attribute."""
        where = f"{self._place(element)}: {key}"
        return numbers(element.get(key, default), count, where, MOST_LENGTH)

    def _origin(self, element: ET.Element) -> Array:
        """Return the pose that an element's origin says, shape (4, 4) [m]."""
        pose = np.eye(4)
        if (origin := element.find("origin")) is not None:
            if "quat_xyzw" in origin.attrib:
                self.refuse(origin, "has quat_xyzw, which is not read; give rpy")
            roll, pitch, yaw = self._numbers(origin, "rpy", 3, "0 0 0")
            x, y, z = np.eye(3)
            pose[:3, :3] = rotation(z, yaw) @ rotation(y, pitch) @ rotation(x, roll)
            pose[:3, 3] = self._numbers(origin, "xyz", 3, "0 0 0")
        return pose

    def _joints(self, joint: ET.Element, pose: Array) -> tuple[tuple[AssetJoint, ...], str]:
        """Return the joint above a link with a pose in the world, and the reason to judge it apart."""
        name, kind = joint.get("name", ""), joint.get("type", "")
        if kind == "fixed":
            return (), ""
        if kind in _APART or joint.tag.startswith(_DRAKE):
            return (), f"{shown(kind)[1:-1]} joint {shown(name)}"
        if kind not in _MOVING:
            self.refuse(joint, f"has the type {shown(kind)}.{similar(kind, _TYPES)}")
        axis = np.array((1.0, 0.0, 0.0))
        if (found := joint.find("axis")) is not None:
            axis = np.array(self._numbers(found, "xyz", 3, "1 0 0"))
            length = float(np.abs(axis).max())
            if length == 0.0:
                self.refuse(found, f"of joint {shown(name)} is 0 0 0; give a direction")
            axis = axis / length / np.linalg.norm(axis / length)
        moved = AssetJoint(
            name,
            "prismatic" if kind == "prismatic" else "revolute",
            pose[:3, :3] @ axis,
            pose[:3, 3].copy(),
            None if kind == "continuous" else self._limits(joint),
            follows=self._coupling(joint),
        )
        return (moved,), ""

    def _limits(self, joint: ET.Element) -> tuple[float, float] | None:
        """Return the limits of a revolute or prismatic joint."""
        limit = joint.find("limit")
        if limit is None:
            self.refuse(joint, 'has no <limit>; give its lower and upper, or type="continuous" without any')
        place = self._place(limit)
        low, high = (numbers(limit.get(k, "0"), 1, f"{place}: {k}")[0] for k in ("lower", "upper"))
        if low > high:
            fault = f"of joint {shown(joint.get('name', ''))} goes from {low:g} to {high:g}; exchange them"
            self.refuse(limit, fault)
        if not {"lower", "upper"} & limit.attrib.keys():
            what = "limited without lower and upper: locked at 0, their default"
            self._note("joint", "joints", what, joint.get("name", ""))
        if low <= -_FAR and high >= _FAR:
            return None
        if max(-low, high) > MOST_LENGTH:
            fault = f"of joint {shown(joint.get('name', ''))} goes from {low:g} to {high:g}; give at most "
            self.refuse(limit, f'{fault}{MOST_LENGTH:g}, or type="continuous"')
        return low, high

    def _coupling(self, joint: ET.Element) -> AssetCoupling | None:
        """Return the coupling of a joint that mimics another, after a check of all that it follows."""
        seen, current = {joint.get("name")}, joint
        while (mimic := current.find("mimic")) is not None:
            leader = mimic.get("joint", "")
            if self.joints.get(leader, mimic).get("type") not in _MOVING:
                fault = f"names {shown(leader)}, which is no joint that moves.{similar(leader, self.joints)}"
                self.refuse(mimic, fault)
            if leader in seen:
                self.refuse(mimic, f"names {shown(leader)}: they mimic each other in a circle; one must lead")
            seen.add(leader)
            current = self.joints[leader]
        if (mimic := joint.find("mimic")) is None:
            return None
        (ratio,), (offset,) = (
            self._numbers(mimic, name, 1, default) for name, default in (("multiplier", "1"), ("offset", "0"))
        )
        return AssetCoupling(mimic.get("joint", ""), ratio, offset)

    def _note(self, one: str, many: str, what: str, name: str) -> None:
        """Add a name to those of which a note says the same."""
        self.notes.setdefault((one, many, what), []).append(name)

    def _geoms(self, link: str, pose: Array) -> Iterator[ForeignGeom]:
        """Yield the colliders of a link, whose frame has a pose in the world, shape (4, 4) [m]."""
        element = self.links[link]
        collisions = element.findall("collision")
        if not collisions and element.find("visual") is not None:
            self._note("body", "bodies", "visible without a collider: not judged", link)
        for number, collision in enumerate(collisions):
            name = collision.get("name", "")
            name = name if name in self.own else self._unique(f"{link}_{number}")
            pieces = self._pieces(collision, name, pose @ self._origin(collision))
            self.count += len(pieces)
            if self.count > MOST_GEOMS:
                self.refuse(collision, f"follows {MOST_GEOMS} convex colliders, the most that are read")
            for index, piece in enumerate(pieces):
                yield ForeignGeom(name if len(pieces) == 1 else self._unique(f"{name}_{index}"), piece)

    def _unique(self, name: str) -> str:
        while name in self.taken:
            name += "_"
        self.taken.add(name)
        return name

    def _pieces(self, collision: ET.Element, name: str, pose: Array) -> list[Convex]:
        """Return the convex pieces of a collider with a pose in the world, shape (4, 4) [m]."""
        shapes = {shape.tag.removeprefix(_DRAKE): shape for shape in collision.iterfind("geometry/*")}
        kind = next((kind for kind in (*_SHAPES, "mesh") if kind in shapes), None)
        if kind is None:
            self._note("collider", "colliders", "without a shape that URDF has: not judged", name)
            return []
        shape = shapes[kind]
        if kind == "mesh":
            return [piece.transformed(pose) for piece in self._mesh(shape)]
        size = sum((self._numbers(shape, key, count) for key, count in _SHAPES[kind].items()), ())
        if min(size) < 0.0:
            self.refuse(shape, f"of collider {shown(name)} has a negative size; give positive lengths")
        if kind == "capsule" and size[1] <= _THIN:
            kind, size = "sphere", size[:1]
        if min(size) <= _THIN:
            self._note("collider", "colliders", "flat: not judged", name)
            return []
        return [Convex(cast("Kind", kind), pose, size)]

    def _mesh(self, mesh: ET.Element) -> tuple[Convex, ...]:
        """Return the pieces of a mesh in the frame of its collider."""
        text = mesh.get("scale", "1")
        text = " ".join((text,) * 3) if len(text.split()) == 1 else text  # as some tools write it
        scale = numbers(text, 3, f"{self._place(mesh)}: scale", _FAR)
        if 0.0 in scale:
            self.refuse(mesh, "has the scale 0; give factors other than 0")
        place = self._place(mesh)
        path = safe_path(mesh.get("filename", ""), self.path.parent, self.root, f"{place}: filename")
        x, y, z = scale
        return self.hulls.file_pieces(path, (x, y, z), f"{place}: {shown(path.name)}")
