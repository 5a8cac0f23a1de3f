"""URDF, and the elements that it shares with the URDF of PartNet-Mobility.

The base link is the root. URDF cannot express a fixed or free base: each simulator has an option for it, so
neither a `world` link nor a floating joint is written.
"""

import math
import xml.etree.ElementTree as ET
from collections.abc import Collection, Iterable, Iterator

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset, AssetJoint, Link
from artgen.asset.valid_states import KEY
from artgen.colliders import Convex
from artgen.export import frames
from artgen.export.losses import (
    Loss,
    Row,
    Written,
    affordance_rows,
    look_rows,
    loop_rows,
    losses,
    mechanism_rows,
    tendon_rows,
)
from artgen.export.meshes import MeshFiles, display_color, mesh_files, mesh_name
from artgen.export.text import add, digits, document, states_text

# mass properties of links that mark grasps or pushes: without a mass, PyBullet assumes 1 kg and warns; with
# 0, SAPIEN assumes moments of 1e-6 kg m^2, as does Newton below 1e-10 kg m^2, which equals that of a latch
MARKER_MASS = 1e-9
"""Mass of a link without geometry [kg]."""

MARKER_INERTIA = 2e-10
"""Each principal moment of such a link [kg m^2]."""

SPECK = 1e-4
"""Radius of the geometry of a link between two joints, in a URDF that requires one [m]."""

_LEVEL = 1e-6  # cosine of the pitch below which roll and yaw share an axis

UNMARKED = "nothing; they are in asset.json"
"""Replacement of the frames of grasps and pushes in files without links for them."""


def write_urdf(asset: Asset, textures: int = 0, *, hands: bool = True) -> Written:
    """Write an asset as URDF, with its meshes.

    Args:
        asset: The asset.
        textures: Texels per side of the material maps; 0 for colors only.
        hands: Whether grasps and pushes are marked by links; without them, every link has inertia, visual and
            collider, also the links between two joints of a pair.

    Returns:
        The URDF, mesh and map files, and the losses of URDF.
    """
    meshes = mesh_files(asset, textures)
    segments = frames.chain(asset)
    # no color beside a color map: PyBullet multiplies the map with it, SAPIEN shows it instead of the map
    mapped = [material.name for material in asset.materials if "albedo" in meshes.maps.of(material)]
    robot = ET.Element("robot", name=asset.name)
    for material in asset.materials:
        if material.name not in mapped:
            color = [*display_color(material.base_color), material.opacity]
            add(add(robot, "material", name=material.name), "color", rgba=color)
    # links in the order of the joints, because some readers number both together
    for frame in (frames.base_frame(asset), *(segment.child for segment in segments)):
        if frame.link is None:
            small = add_small_link(robot, frame.name, frames.INTERMEDIATE_MASS, frames.INTERMEDIATE_INERTIA)
            for kind in () if hands else ("visual", "collision"):
                add(add(add(small, kind), "geometry"), "sphere", radius=f"{SPECK:g}")
        else:
            _add_link(robot, asset, frame.link, meshes, mapped)
    marks = _add_marks(robot, asset) if hands else []
    for segment in segments:
        _add_joint(robot, asset, segment)
    for mark in marks:
        _add_connection(robot, "fixed", *mark)
    for joint in asset.joints:
        add_spring(robot, joint.name, joint, joint.rest)
    robot.append(ET.Comment(f" {KEY} {states_text(asset)} "))  # parsers pass over it
    text = document(robot, "  ", "UTF-8").replace(b" />", b"/>")
    inserted = [segment.child.name for segment in segments if segment.child.link is None]
    return Written(
        {f"{asset.name}.urdf": text, **meshes.files}, _losses(asset, inserted, mapped, textures, hands=hands)
    )


def _add_marks(robot: ET.Element, asset: Asset) -> list[tuple[str, str, str, Array]]:
    """Add a link for each grasp and push, because it is a named frame in URDF, and return their mounts."""
    taken = {link.attrib["name"] for link in robot.iterfind("link")} | {joint.name for joint in asset.joints}
    marks = []
    for affordance in asset.affordances:
        name = f"{affordance.kind}_{affordance.name}"
        while name in taken or f"{name}_mount" in taken:
            name += "_"
        taken |= {name, f"{name}_mount"}
        add_small_link(robot, name, MARKER_MASS, MARKER_INERTIA)
        placed = frames.local(asset, affordance.link, affordance.frame)
        marks.append((f"{name}_mount", affordance.link, name, placed))
    return marks


def _add_link(
    robot: ET.Element, asset: Asset, link: Link, meshes: MeshFiles, mapped: Collection[str]
) -> None:
    element = add(robot, "link", name=link.name)
    add_inertial(element, *frames.mass_in_frame(asset, link))
    for surface, path in zip(link.surfaces, meshes.surfaces[link.name], strict=True):
        visual = add(element, "visual", name=mesh_name(path))
        add_geometry(visual, path)
        add_origin(visual, np.eye(4))
        if surface.material.name not in mapped:
            add(visual, "material", name=surface.material.name)
    for number, collider in enumerate(link.colliders):
        name = f"{link.name}_collider_{number}"
        if collider.convex.kind == "hull":
            collision = add(element, "collision", name=name)
            add_geometry(collision, meshes.colliders[link.name][number])
            add_origin(collision, frames.translation(meshes.middles[link.name][number]))
            continue
        for suffix, piece in primitives(collider.convex):
            collision = add(element, "collision", name=name + suffix)
            add_geometry(collision, piece)
            add_origin(collision, frames.local(asset, link.name, piece.pose))


def _add_joint(robot: ET.Element, asset: Asset, segment: frames.Segment) -> None:
    joint, kind = segment.joint, frames.joint_type(segment.joint)
    element = _add_connection(
        robot, kind, joint.name, segment.parent.name, segment.child.name, segment.origin
    )
    if joint.locked:
        return
    add(element, "axis", xyz=lengths(joint.axis))
    lower, upper = (None, None) if kind == "continuous" else joint.limits or (-frames.FAR, frames.FAR)
    add(element, "limit", effort=joint.effort, velocity=joint.velocity, lower=lower, upper=upper)
    add(element, "dynamics", damping=joint.damping, friction=joint.friction)
    follows = frames.linear_coupling(asset, joint)
    if follows is not None:
        add(element, "mimic", joint=follows.leader, multiplier=follows.ratio, offset=follows.offset)


def _add_connection(
    robot: ET.Element, kind: str, name: str, parent: str, child: str, origin: Array
) -> ET.Element:
    element = add(robot, "joint", name=name, type=kind)
    add(element, "parent", link=parent)
    add(element, "child", link=child)
    add_origin(element, origin)
    return element


def add_small_link(robot: ET.Element, name: str, mass: float, moment: float) -> ET.Element:
    """Add a link without geometry, with the small mass [kg] and moments [kg m^2] that simulators require."""
    link = add(robot, "link", name=name)
    add_inertial(link, mass, np.zeros(3), moment * np.eye(3))
    return link


def add_inertial(link: ET.Element, mass: float, center: Array, inertia: Array) -> None:
    """Add mass [kg], center of mass, shape (3,) [m], and inertia about it, shape (3, 3) [kg m^2]."""
    element = add(link, "inertial")
    add_origin(element, frames.translation(center))
    add(element, "mass", value=mass)
    axes = ((0, "x"), (1, "y"), (2, "z"))
    add(element, "inertia", {f"i{a}{b}": inertia[i, j] for i, a in axes for j, b in axes if i <= j})


def add_geometry(parent: ET.Element, shape: str | Convex) -> None:
    """Add a mesh, given as the path of its file, or a primitive."""
    element = add(parent, "geometry")
    if isinstance(shape, str):
        add(element, "mesh", filename=shape)
    elif shape.kind == "box":
        add(element, "box", size=shape.size)
    else:
        add(element, shape.kind, dict(zip(("radius", "length"), shape.size, strict=False)))


def add_origin(parent: ET.Element, pose: Array) -> None:
    """Add a pose in the parent's frame, shape (4, 4) [m]."""
    add(parent, "origin", xyz=lengths(pose[:3, 3]), rpy=lengths(roll_pitch_yaw(pose)))


def roll_pitch_yaw(pose: Array) -> tuple[float, float, float]:
    """Return the angles about the fixed axes x, y and z, in that order, of a rotation [rad]."""
    (xx, _, _), (yx, yy, yz), (zx, zy, zz) = pose[:3, :3].tolist()
    level = math.hypot(xx, yx)
    pitch = math.atan2(-zx, level)
    if level > _LEVEL:
        return math.atan2(zy, zz), pitch, math.atan2(yx, xx)
    return math.atan2(-yz, yy), pitch, 0.0


def lengths(values: Iterable[float] | Array) -> str:
    """Return lengths, angles or directions as text with 12 decimals: machines differ in further digits."""
    return " ".join(digits(round(float(value), 12)) for value in values)


def primitives(convex: Convex) -> list[tuple[str, Convex]]:
    """Return the primitives of a piece that is not a hull, each with a suffix for its name.

    URDF has no capsule: a cylinder between two balls is the same solid.
    """
    if convex.kind != "capsule":
        return [("", convex)]
    radius, length = convex.size
    ends = [
        convex.pose @ frames.translation(np.array([0.0, 0.0, end])) for end in (-length / 2.0, length / 2.0)
    ]
    balls = [(f"_end_{number}", Convex("sphere", end, (radius,))) for number, end in enumerate(ends)]
    return [("", Convex("cylinder", convex.pose, convex.size)), *balls]


def add_spring(robot: ET.Element, name: str, joint: AssetJoint, rest: float) -> None:
    """Add Gazebo's element for the spring of a joint, which other simulators ignore.

    Args:
        robot: Root of the tree.
        name: Name of the joint in the tree.
        joint: The joint.
        rest: Rest position of the spring, with the sign of the joint in the tree [rad or m].
    """
    if joint.stiffness and not joint.locked:
        spring = add(robot, "gazebo", reference=name)
        add(spring, "springStiffness").text = digits(joint.stiffness)
        add(spring, "springReference").text = digits(rest)


def _losses(
    asset: Asset, inserted: Iterable[str], mapped: Iterable[str], textures: int, *, hands: bool
) -> tuple[Loss, ...]:
    mark = f"... of {MARKER_MASS:g} kg, fixed there;"
    moved = "the joints that it moves are in asset.json"
    marked = (f"a link named grasp_{mark} the width and {moved}", f"a link named push_{mark} {moved}")
    if not hands:
        marked = (UNMARKED, UNMARKED)
    color = "the map in the MTL file; many clients darken or hide it where the URDF has a color"
    return losses(
        *motion_rows(asset, inserted),
        *affordance_rows(asset, *marked),
        *material_rows(asset),
        ("color beside a color map", mapped, color),
        *look_rows(asset, textures),
        ("free body", asset.loose, "a fixed joint to the link that carries it"),
        ("semantic labels", [link.name for link in asset.links], "nothing; they are in asset.json"),
    )


def motion_rows(asset: Asset, inserted: Iterable[str]) -> Iterator[Row]:
    """Yield the losses of the motion of joints.

    Args:
        asset: The asset.
        inserted: Names of the links inserted between two joints of one pair of links.
    """
    moving = [joint for joint in asset.joints if not joint.locked]
    instead = "Gazebo's springStiffness and springReference; other clients have no spring"
    yield "joint spring", [joint.name for joint in moving if joint.stiffness > 0.0], instead
    yield "joint armature", [joint.name for joint in moving if joint.armature > 0.0], "nothing"
    endless = [joint.name for joint in moving if joint.kind == "prismatic" and joint.limits is None]
    yield "unlimited slide", endless, f"limits of -{frames.FAR:g} m and {frames.FAR:g} m"
    yield from mechanism_rows(asset)
    yield from tendon_rows(asset)
    yield from loop_rows(asset, "joints without mimic; artgen_states has their laws and the pins")
    instead = f"a link of {frames.INTERMEDIATE_MASS:g} kg after each joint but the last"
    yield "several joints between two links", inserted, instead


def material_rows(asset: Asset) -> Iterator[Row]:
    """Yield the losses of the materials of links."""
    instead = "nothing: clients take their own default; the coefficients are in asset.json"
    yield "contact friction", [link.name for link in asset.links if link.colliders], instead
    instead = "Pr, Pm, Pc and norm in the MTL file, which few clients read"
    yield "surface roughness, metalness and coat", [material.name for material in asset.materials], instead
