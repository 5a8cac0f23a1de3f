"""The URDF of the PartNet-Mobility layout.

All bodies have frames that are parallel, y up, when every joint stands at 0; a fixed joint below `base` turns
them upright, z up with the front to -x. Meshes are in coordinates of the whole object, so each is shifted by
where its body's frame lies.
"""

import math
import xml.etree.ElementTree as ET
from collections.abc import Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from artgen.asset import Asset, Link
from artgen.colliders import Convex
from artgen.export.frames import (
    FAR,
    INTERMEDIATE_INERTIA,
    INTERMEDIATE_MASS,
    joint_type,
    mass_in_frame,
    translation,
)
from artgen.export.layouts.partnet_meshes import COLLIDERS, VISUALS, ObjectMeshes
from artgen.export.layouts.partnet_names import ROOT, UPRIGHT, Naming, Step

Array = NDArray[np.float64]

ROOT_MASS = 1e-9
"""Mass of the body without geometry [kg]; clients make up a mass where there is none."""

_ROOT_INERTIA = 2e-10  # [kg m^2]; smaller ones are corrected by Newton, with a warning
_TURN = {"rpy": "1.570796326794897 0 -1.570796326794897", "xyz": "0 0 0"}  # y up to z up, front to -x
_LEVEL = 1e-6  # cosine of the pitch below which roll and yaw turn about one axis


def urdf_text(asset: Asset, named: Naming, meshes: ObjectMeshes) -> bytes:
    """Return the URDF of an asset as XML text."""
    robot = ET.Element("robot", name=f"partnet_{asset.name}")
    _inertial(ET.SubElement(robot, "link", name=ROOT), ROOT_MASS, np.zeros(3), _ROOT_INERTIA * np.eye(3))
    base, *moving = asset.links
    for link in (*moving, base):
        _add_link(robot, asset, named, link, meshes)
        for step in named.of_link(link.name):
            _add_joint(robot, named, step)
    upright = ET.SubElement(robot, "joint", name=f"joint_{named.links[base.name]}", type="fixed")
    ET.SubElement(upright, "origin", _TURN)
    ET.SubElement(upright, "child", link=named.body(base.name))
    ET.SubElement(upright, "parent", link=ROOT)
    _add_springs(robot, named)
    ET.indent(robot)
    text: bytes = ET.tostring(robot, encoding="utf-8", xml_declaration=True)
    return text + b"\n"


def _add_link(robot: ET.Element, asset: Asset, named: Naming, link: Link, meshes: ObjectMeshes) -> None:
    for step in named.of_link(link.name)[:-1]:
        helper = ET.SubElement(robot, "link", name=step.child)
        _inertial(helper, INTERMEDIATE_MASS, np.zeros(3), INTERMEDIATE_INERTIA * np.eye(3))
    element = ET.SubElement(robot, "link", name=named.body(link.name))
    mass, center, inertia = mass_in_frame(asset, link)
    _inertial(element, mass, UPRIGHT @ center, UPRIGHT @ inertia @ UPRIGHT.T)
    origin = translation(-(UPRIGHT @ asset.origin(link.name)))
    names = {part.label: f"{part.name}-{part.number}" for part in named.parts[link.name]}
    for surface, file in zip(link.surfaces, meshes.surfaces[link.name], strict=True):
        _mesh(ET.SubElement(element, "visual", name=names[surface.label]), origin, f"{VISUALS}/{file}")
    for number, collider in enumerate(link.colliders):
        name = f"{named.body(link.name)}_collider_{number}"
        if collider.convex.kind == "hull":
            path = f"{COLLIDERS}/{meshes.colliders[link.name][number]}"
            _mesh(ET.SubElement(element, "collision", name=name), origin, path)
            continue
        for suffix, pose, tag, size in _primitives(collider.convex):
            collision = ET.SubElement(element, "collision", name=name + suffix)
            turned = origin.copy()
            turned[:3, 3] += UPRIGHT @ pose[:3, 3]
            turned[:3, :3] = UPRIGHT @ pose[:3, :3]
            _origin(collision, turned)
            ET.SubElement(ET.SubElement(collision, "geometry"), tag, size)


def _inertial(link: ET.Element, mass: float, center: Array, inertia: Array) -> None:
    element = ET.SubElement(link, "inertial")
    _origin(element, translation(center))
    ET.SubElement(element, "mass", value=_number(mass))
    moments = {
        f"i{'xyz'[row]}{'xyz'[column]}": _number(inertia[row, column])
        for row in range(3)
        for column in range(row, 3)
    }
    ET.SubElement(element, "inertia", moments)


def _mesh(parent: ET.Element, origin: Array, path: str) -> None:
    _origin(parent, origin)
    ET.SubElement(ET.SubElement(parent, "geometry"), "mesh", filename=path)


def _primitives(convex: Convex) -> Iterator[tuple[str, Array, str, dict[str, str]]]:
    """Yield the primitives of a piece: a suffix of its name, its pose, its tag and its size."""
    if convex.kind == "box":
        yield "", convex.pose, "box", {"size": _numbers(convex.size)}
        return
    ball = {"radius": _number(convex.size[0])}
    if convex.kind == "sphere":
        yield "", convex.pose, "sphere", ball
        return
    length = convex.size[1]
    yield "", convex.pose, "cylinder", ball | {"length": _number(length)}
    if convex.kind == "capsule":  # URDF has none: a cylinder between two balls is the same solid
        for number, end in enumerate((-length / 2.0, length / 2.0)):
            yield f"_end_{number}", convex.pose @ translation(np.array([0.0, 0.0, end])), "sphere", ball


def _add_joint(robot: ET.Element, named: Naming, step: Step) -> None:
    joint = step.segment.joint
    kind = joint_type(joint)
    element = ET.SubElement(robot, "joint", name=step.name, type=kind)
    frame = np.eye(4)
    frame[:3, :3] = UPRIGHT @ step.segment.origin[:3, :3] @ UPRIGHT.T
    frame[:3, 3] = UPRIGHT @ step.segment.origin[:3, 3]
    _origin(element, frame)
    if kind != "fixed":
        ET.SubElement(element, "axis", xyz=_lengths(step.axis))
    ET.SubElement(element, "child", link=step.child)
    ET.SubElement(element, "parent", link=step.parent)
    if kind == "fixed":
        return
    limit = {"effort": _number(joint.effort), "velocity": _number(joint.velocity)}
    if kind != "continuous":
        low, high = step.limits or (-FAR, FAR)
        limit = {"lower": _number(low), "upper": _number(high)} | limit
    ET.SubElement(element, "limit", limit)
    ET.SubElement(element, "dynamics", damping=_number(joint.damping), friction=_number(joint.friction))
    for item in named.couplings:
        if item.follower is step and not item.siblings:
            numbers = {"multiplier": _number(item.ratio), "offset": _number(item.offset)}
            ET.SubElement(element, "mimic", {"joint": item.leader.name} | numbers)


def _add_springs(robot: ET.Element, named: Naming) -> None:
    """Add Gazebo's word for a spring, which other clients pass over."""
    for step in named.steps:
        joint = step.segment.joint
        if joint.stiffness and not joint.locked:
            spring = ET.SubElement(robot, "gazebo", reference=step.name)
            ET.SubElement(spring, "springStiffness").text = _number(joint.stiffness)
            ET.SubElement(spring, "springReference").text = _number(step.sign * joint.rest)


def _origin(parent: ET.Element, pose: Array) -> None:
    turn = {} if np.array_equal(pose[:3, :3], np.eye(3)) else {"rpy": _lengths(roll_pitch_yaw(pose))}
    ET.SubElement(parent, "origin", {"xyz": _lengths(pose[:3, 3])} | turn)


def roll_pitch_yaw(pose: Array) -> tuple[float, float, float]:
    """Return the angles about the fixed axes x, y and z, in that order, that turn as a pose does [rad]."""
    # rounding first keeps a turn by pi from jumping to -pi on another machine
    rows = (np.round(pose[:3, :3], 12) + 0.0).tolist()
    (xx, _, _), (yx, yy, yz), (zx, zy, zz) = rows
    level = math.hypot(xx, yx)
    pitch = math.atan2(-zx, level)
    if level > _LEVEL:
        return math.atan2(zy, zz), pitch, math.atan2(yx, xx)
    return math.atan2(0.0 - yz, yy), pitch, 0.0


def _lengths(values: Sequence[float] | Array) -> str:
    """Write lengths, angles or directions with 12 decimals: the digits beyond differ between machines."""
    return " ".join(_number(round(float(value), 12)) for value in values)


def _numbers(values: Sequence[float] | Array) -> str:
    return " ".join(_number(float(value)) for value in values)


def _number(value: float) -> str:
    return f"{value + 0.0:.12g}"
