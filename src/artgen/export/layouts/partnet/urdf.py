"""The URDF of the PartNet-Mobility layout.

The frames of all bodies are parallel, y up, when every joint stands at 0; a fixed joint below `base` turns
them upright, z up with the front towards -x. Meshes have coordinates of the whole object, so each is shifted
by the origin of its body's frame.
"""

import xml.etree.ElementTree as ET

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset, Link
from artgen.export import frames, urdf
from artgen.export.layouts.partnet.names import ROOT, UPRIGHT, Naming, Step
from artgen.export.meshes import MeshFiles
from artgen.export.text import add, document

_TURN = {"rpy": "1.570796326794897 0 -1.570796326794897", "xyz": "0 0 0"}  # y up to z up, front towards -x


def urdf_text(asset: Asset, named: Naming, meshes: MeshFiles) -> bytes:
    """Return the URDF of an asset as XML text."""
    robot = ET.Element("robot", name=f"partnet_{asset.name}")
    urdf.add_small_link(robot, ROOT, urdf.MARKER_MASS, urdf.MARKER_INERTIA)
    base, *moving = asset.links
    for link in (*moving, base):
        _add_link(robot, asset, named, link, meshes)
        for step in named.of_link(link.name):
            _add_joint(robot, named, step)
    for origin in robot.iter("origin"):
        if origin.get("rpy") == "0 0 0":
            del origin.attrib["rpy"]
        else:  # machines differ in the sign of half a turn
            origin.set("rpy", origin.attrib["rpy"].replace("-3.14159265359", "3.14159265359"))
    upright = add(robot, "joint", name=f"joint_{named.links[base.name]}", type="fixed")
    add(upright, "origin", _TURN)
    add(upright, "child", link=named.body(base.name))
    add(upright, "parent", link=ROOT)
    for step in named.steps:
        joint = step.segment.joint
        urdf.add_spring(robot, step.name, joint, step.sign * joint.rest)
    return document(robot, "  ")


def _add_link(robot: ET.Element, asset: Asset, named: Naming, link: Link, meshes: MeshFiles) -> None:
    for step in named.of_link(link.name)[:-1]:
        urdf.add_small_link(robot, step.child, frames.INTERMEDIATE_MASS, frames.INTERMEDIATE_INERTIA)
    element = add(robot, "link", name=named.body(link.name))
    mass, center, inertia = frames.mass_in_frame(asset, link)
    urdf.add_inertial(element, mass, UPRIGHT @ center, UPRIGHT @ inertia @ UPRIGHT.T)
    origin = frames.translation(-(UPRIGHT @ asset.origin(link.name)))
    names = {part.label: f"{part.name}-{part.number}" for part in named.parts[link.name]}
    for surface, path in zip(link.surfaces, meshes.surfaces[link.name], strict=True):
        visual = add(element, "visual", name=names[surface.label])
        urdf.add_origin(visual, origin)
        urdf.add_geometry(visual, path)
    for number, collider in enumerate(link.colliders):
        name = f"{named.body(link.name)}_collider_{number}"
        if collider.convex.kind == "hull":
            collision = add(element, "collision", name=name)
            urdf.add_origin(collision, origin @ frames.translation(meshes.middles[link.name][number]))
            urdf.add_geometry(collision, meshes.colliders[link.name][number])
            continue
        for suffix, piece in urdf.primitives(collider.convex):
            collision = add(element, "collision", name=name + suffix)
            urdf.add_origin(collision, origin @ _upright(piece.pose))
            urdf.add_geometry(collision, piece)


def _upright(pose: Array) -> Array:
    """Return a pose in the dataset's coordinates."""
    result = np.eye(4)
    result[:3] = UPRIGHT @ pose[:3]
    result[:3, :3] = np.round(result[:3, :3], 12)  # or machines differ in the angles
    return result


def _add_joint(robot: ET.Element, named: Naming, step: Step) -> None:
    joint = step.segment.joint
    kind = frames.joint_type(joint)
    element = add(robot, "joint", name=step.name, type=kind)
    frame = _upright(step.segment.origin)
    frame[:3, :3] = frame[:3, :3] @ UPRIGHT.T
    urdf.add_origin(element, frame)
    if kind != "fixed":
        add(element, "axis", xyz=urdf.lengths(step.axis))
    add(element, "child", link=step.child)
    add(element, "parent", link=step.parent)
    if kind == "fixed":
        return
    lower, upper = (None, None) if kind == "continuous" else step.limits or (-frames.FAR, frames.FAR)
    add(element, "limit", lower=lower, upper=upper, effort=joint.effort, velocity=joint.velocity)
    add(element, "dynamics", damping=joint.damping, friction=joint.friction)
    for item in named.couplings:
        if item.follower is step and not item.siblings:
            add(element, "mimic", joint=item.leader.name, multiplier=item.ratio, offset=item.offset)
