"""SDFormat 1.12, the format of Gazebo and Drake: a model for an asset, a world for a room.

The pose of each link is given in its parent's frame, and the frame of a joint is that of its child, as in
URDF. A fixed base has a fixed joint to the world. Grasps and pushes are frames of the model. A free body of a
room is a model of its own.
"""

import xml.etree.ElementTree as ET
from collections.abc import Mapping, Sequence

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset, Link
from artgen.asset.valid_states import KEY
from artgen.colliders import Convex
from artgen.export import frames
from artgen.export.losses import (
    Loss,
    Written,
    affordance_rows,
    look_rows,
    loop_rows,
    losses,
    mechanism_rows,
    seen_materials,
    tendon_rows,
)
from artgen.export.maps import TEXTURE_DIRECTORY, MapFiles, specular_color
from artgen.export.meshes import MeshFiles, display_color, mesh_files, mesh_name
from artgen.export.text import add, digits, document, states_text
from artgen.export.urdf import lengths, roll_pitch_yaw
from artgen.materials import Material
from artgen.materials.textures import Kind

VERSION = "1.12"
"""Version of SDFormat."""

_DRAKE = "http://drake.mit.edu"  # namespace of Drake's own elements

_MAPS: dict[Kind, str] = {
    "albedo": "albedo_map", "normal": "normal_map",
    "roughness": "roughness_map", "metalness": "metalness_map",
}  # fmt: skip


def write_sdf(asset: Asset, textures: int = 0) -> Written:
    """Write an asset as SDFormat, with its meshes.

    Args:
        asset: The asset.
        textures: Texels per side of the material maps; 0 for colors only.

    Returns:
        The SDFormat, mesh and map files, and the losses of SDFormat.
    """
    meshes = mesh_files(asset, textures)
    root = ET.Element("sdf", {"version": VERSION, "xmlns:drake": _DRAKE})
    holder = add(root, "world", name=asset.name) if asset.is_room else root
    base, segments = frames.base_frame(asset), frames.chain(asset)
    taken = {base.name, *(each.child.name for each in segments)}  # names of a model are unique
    names: dict[str, str] = {}
    for joint in asset.joints:
        names[joint.name] = frames.unused(joint.name, taken)
        taken.add(names[joint.name])
    models = {base.name: _add_model(holder, asset.name, np.eye(4))}
    _add_link(models[base.name], asset, base, meshes, None)
    if asset.base == "fixed":
        _add_joint(models[base.name], frames.unused("world_mount", taken), "fixed", "world", base.name)
    for each in segments:
        name, parent = each.child.name, each.parent.name
        if name in asset.loose:
            models[name] = _add_model(holder, name, each.child.placement)
            _add_link(models[name], asset, each.child, meshes, None)
            continue
        model = models[name] = models[parent]
        _add_link(model, asset, each.child, meshes, (parent, each.origin))
        _add_moving_joint(model, asset, each, names)
    for affordance in asset.affordances:
        name = frames.unused(f"{affordance.kind}_{affordance.name}", taken)
        taken.add(name)
        frame = add(models[affordance.link], "frame", name=name, attached_to=affordance.link)
        _add_pose(frame, frames.local(asset, affordance.link, affordance.frame))
    root.append(ET.Comment(f" {KEY} {states_text(asset)} "))  # parsers pass over it
    text = document(root, "  ", "UTF-8").replace(b" />", b"/>")
    inserted = [each.child.name for each in segments if each.child.link is None]
    return Written({f"{asset.name}.sdf": text, **meshes.files}, _losses(asset, inserted, textures))


def _add_model(holder: ET.Element, name: str, pose: Array) -> ET.Element:
    model = add(holder, "model", name=name)
    _add_pose(model, pose)
    _add_text(model, "self_collide", "true")  # bolts hold doors
    return model


def _add_link(
    model: ET.Element,
    asset: Asset,
    frame: frames.LinkFrame,
    meshes: MeshFiles,
    place: tuple[str, Array] | None,
) -> None:
    """Add a link at a place in the frame of another link, or at the origin of the model."""
    element = add(model, "link", name=frame.name)
    if place is not None:
        _add_pose(element, place[1], place[0])
    link = frame.link
    if link is None:
        _add_inertial(element, frames.INTERMEDIATE_MASS, np.zeros(3), frames.INTERMEDIATE_INERTIA * np.eye(3))
        return
    _add_inertial(element, *frames.mass_in_frame(asset, link))
    for surface, path in zip(link.surfaces, meshes.surfaces[link.name], strict=True):
        visual = add(element, "visual", name=mesh_name(path))
        _add_geometry(visual, path)
        _add_material(visual, surface.material, meshes.maps)
    _add_colliders(element, asset, link, meshes)


def _add_colliders(element: ET.Element, asset: Asset, link: Link, meshes: MeshFiles) -> None:
    for number, collider in enumerate(link.colliders):
        collision = add(element, "collision", name=f"{link.name}_collider_{number}")
        if collider.convex.kind == "hull":
            _add_pose(collision, frames.translation(meshes.middles[link.name][number]))
            _add_geometry(collision, meshes.colliders[link.name][number])
        else:
            _add_pose(collision, frames.local(asset, link.name, collider.convex.pose))
            _add_geometry(collision, collider.convex)
        ode = add(add(add(collision, "surface"), "friction"), "ode")
        for word in ("mu", "mu2"):
            _add_text(ode, word, digits(collider.material.friction))


def _add_inertial(element: ET.Element, mass: float, center: Array, inertia: Array) -> None:
    inertial = add(element, "inertial")
    _add_pose(inertial, frames.translation(center))
    _add_text(inertial, "mass", digits(mass))
    matrix = add(inertial, "inertia")
    for row, column in ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)):
        _add_text(matrix, f"i{'xyz'[row]}{'xyz'[column]}", digits(float(inertia[row, column])))


def _add_geometry(parent: ET.Element, shape: str | Convex) -> None:
    """Add a mesh, given as the path of its file, or a primitive; a collider of a mesh is its convex hull."""
    geometry = add(parent, "geometry")
    if isinstance(shape, str):
        mesh = add(geometry, "mesh", optimization="convex_hull" if parent.tag == "collision" else None)
        _add_text(mesh, "uri", shape)
        return
    element = add(geometry, shape.kind)
    if shape.kind == "box":
        _add_text(element, "size", " ".join(map(digits, shape.size)))
        return
    for word, length in zip(("radius", "length"), shape.size, strict=False):
        _add_text(element, word, digits(length))


def _add_material(visual: ET.Element, material: Material, maps: MapFiles) -> None:
    files = maps.of(material)
    element = add(visual, "material")
    color = (1.0, 1.0, 1.0) if "albedo" in files else display_color(material.base_color)
    _add_text(element, "diffuse", lengths([*color, material.opacity]))
    _add_text(element, "specular", lengths([*display_color(specular_color(material)), 1.0]))
    if any(material.emission):
        _add_text(element, "emissive", lengths([*display_color(material.emission), 1.0]))
    metal = add(add(element, "pbr"), "metal")
    for kind, word in _MAPS.items():
        if kind in files:
            _add_text(metal, word, f"{TEXTURE_DIRECTORY}/{files[kind]}")
    if "roughness" not in files:
        _add_text(metal, "roughness", digits(material.specular_roughness))
    if "metalness" not in files:
        _add_text(metal, "metalness", digits(material.base_metalness))


def _add_moving_joint(
    model: ET.Element, asset: Asset, segment: frames.Segment, names: Mapping[str, str]
) -> None:
    joint, kind = segment.joint, frames.joint_type(segment.joint)
    element = _add_joint(model, names[joint.name], kind, segment.parent.name, segment.child.name)
    if joint.locked:
        return
    axis = add(element, "axis")
    _add_text(axis, "xyz", lengths(joint.axis))
    limit = add(axis, "limit")
    for word, end in zip(("lower", "upper"), joint.limits or (), strict=False):
        _add_text(limit, word, digits(end))
    _add_text(limit, "effort", digits(joint.effort))
    _add_text(limit, "velocity", digits(joint.velocity))
    dynamics = add(axis, "dynamics")
    words = {"damping": joint.damping, "friction": joint.friction}
    if joint.stiffness:
        words |= {"spring_reference": joint.rest, "spring_stiffness": joint.stiffness}
    for word, value in words.items():
        _add_text(dynamics, word, digits(value))
    follows = frames.linear_coupling(asset, joint)
    if follows is not None:
        leader = names[follows.leader]
        mimic = add(axis, "mimic", joint=leader)
        _add_text(mimic, "multiplier", digits(follows.ratio))
        _add_text(mimic, "offset", digits(follows.offset))
        _add_text(mimic, "reference", "0")
        # Drake 1.51 passes over the element of SDFormat
        add(element, "drake:mimic", joint=leader, multiplier=follows.ratio, offset=follows.offset)


def _add_joint(model: ET.Element, name: str, kind: str, parent: str, child: str) -> ET.Element:
    element = add(model, "joint", name=name, type=kind)
    _add_text(element, "parent", parent)
    _add_text(element, "child", child)
    return element


def _add_pose(parent: ET.Element, pose: Array, relative_to: str | None = None) -> None:
    """Add a pose in the frame of the parent element or of a link, shape (4, 4) [m]."""
    element = add(parent, "pose", relative_to=relative_to)
    element.text = lengths([*pose[:3, 3], *roll_pitch_yaw(pose)])


def _add_text(parent: ET.Element, tag: str, text: str) -> None:
    add(parent, tag).text = text


def _losses(asset: Asset, inserted: Sequence[str], textures: int) -> tuple[Loss, ...]:
    moved = "a frame of the model named {}_...; {}the joints that it moves are in asset.json"
    moving = [joint for joint in asset.joints if not joint.locked]
    coats = [material.name for material in seen_materials(asset) if material.coat_weight]
    small = f"a link of {frames.INTERMEDIATE_MASS:g} kg after each joint but the last"
    return losses(
        ("joint armature", [joint.name for joint in moving if joint.armature > 0.0], "nothing"),
        *mechanism_rows(asset),
        *tendon_rows(asset),
        *loop_rows(asset, "joints without mimic; artgen_states has their laws and the pins"),
        ("several joints between two links", inserted, small),
        *affordance_rows(asset, moved.format("grasp", "the width and "), moved.format("push", "")),
        *look_rows(asset, textures),
        ("coat", coats, "nothing"),
        ("semantic labels", [link.name for link in asset.links], "nothing; they are in asset.json"),
    )
