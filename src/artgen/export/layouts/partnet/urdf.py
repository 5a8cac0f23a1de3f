"""The URDF of the PartNet-Mobility layout.

The frames of all bodies are parallel, y up, when every joint stands at 0; a fixed joint below `base` turns
them upright, z up with the front towards -x. Meshes have coordinates of the whole object, so each is shifted
by the origin of its body's frame.
"""

import math
import xml.etree.ElementTree as ET
from collections.abc import Sequence

import numpy as np

from artgen._arrays import Array
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
from artgen.export.layouts.partnet.meshes import COLLIDERS, VISUALS, ObjectMeshes
from artgen.export.layouts.partnet.names import ROOT, UPRIGHT, Naming, Step
from artgen.export.urdf.losses import add_spring, digits, primitives

ROOT_MASS = 1e-9
"""Mass of the body without geometry [kg]; simulators invent a mass if there is none."""

_ROOT_INERTIA = 2e-10  # Newton corrects smaller moments with a warning [kg m^2]
_TURN = {"rpy": "1.570796326794897 0 -1.570796326794897", "xyz": "0 0 0"}  # y up to z up, front towards -x
_LEVEL = 1e-6  # cosine of the pitch below which roll and yaw share an axis


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
    for step in named.steps:
        joint = step.segment.joint
        add_spring(robot, step.name, joint, step.sign * joint.rest)
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
            placed = origin @ translation(meshes.middles[link.name][number])
            _mesh(ET.SubElement(element, "collision", name=name), placed, path)
            continue
        for suffix, piece in primitives(collider.convex):
            collision = ET.SubElement(element, "collision", name=name + suffix)
            turned = origin.copy()
            turned[:3, 3] += UPRIGHT @ piece.pose[:3, 3]
            turned[:3, :3] = UPRIGHT @ piece.pose[:3, :3]
            _origin(collision, turned)
            ET.SubElement(ET.SubElement(collision, "geometry"), piece.kind, _size(piece))


def _inertial(link: ET.Element, mass: float, center: Array, inertia: Array) -> None:
    element = ET.SubElement(link, "inertial")
    _origin(element, translation(center))
    ET.SubElement(element, "mass", value=digits(mass))
    moments = {
        f"i{'xyz'[row]}{'xyz'[column]}": digits(inertia[row, column])
        for row in range(3)
        for column in range(row, 3)
    }
    ET.SubElement(element, "inertia", moments)


def _mesh(parent: ET.Element, origin: Array, path: str) -> None:
    _origin(parent, origin)
    ET.SubElement(ET.SubElement(parent, "geometry"), "mesh", filename=path)


def _size(convex: Convex) -> dict[str, str]:
    if convex.kind == "box":
        return {"size": _numbers(convex.size)}
    return dict(zip(("radius", "length"), map(digits, convex.size), strict=False))


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
    limit = {"effort": digits(joint.effort), "velocity": digits(joint.velocity)}
    if kind != "continuous":
        low, high = step.limits or (-FAR, FAR)
        limit = {"lower": digits(low), "upper": digits(high)} | limit
    ET.SubElement(element, "limit", limit)
    ET.SubElement(element, "dynamics", damping=digits(joint.damping), friction=digits(joint.friction))
    for item in named.couplings:
        if item.follower is step and not item.siblings:
            numbers = {"multiplier": digits(item.ratio), "offset": digits(item.offset)}
            ET.SubElement(element, "mimic", {"joint": item.leader.name} | numbers)


def _origin(parent: ET.Element, pose: Array) -> None:
    turn = {} if np.array_equal(pose[:3, :3], np.eye(3)) else {"rpy": _lengths(roll_pitch_yaw(pose))}
    ET.SubElement(parent, "origin", {"xyz": _lengths(pose[:3, 3])} | turn)


def roll_pitch_yaw(pose: Array) -> tuple[float, float, float]:
    """Return the angles about the fixed axes x, y and z, in that order, of a rotation [rad]."""
    # rounding first prevents a jump from pi to -pi on other machines
    rows = (np.round(pose[:3, :3], 12) + 0.0).tolist()
    (xx, _, _), (yx, yy, yz), (zx, zy, zz) = rows
    level = math.hypot(xx, yx)
    pitch = math.atan2(-zx, level)
    if level > _LEVEL:
        return math.atan2(zy, zz), pitch, math.atan2(yx, xx)
    return math.atan2(0.0 - yz, yy), pitch, 0.0


def _lengths(values: Sequence[float] | Array) -> str:
    """Format lengths, angles or directions with 12 decimals: machines differ in the digits beyond."""
    return " ".join(digits(round(float(value), 12)) for value in values)


def _numbers(values: Sequence[float] | Array) -> str:
    return " ".join(digits(float(value)) for value in values)
