"""URDF with yourdfpy's model; elements that its XML writer omits are added to the tree.

The base link is the root. URDF cannot express a fixed or free base: each simulator has an option for it, so
neither a `world` link nor a floating joint is written.
"""

from collections.abc import Iterator, Sequence
from io import BytesIO
from typing import Any

import numpy as np

from artgen.asset import Asset, Link
from artgen.colliders import Convex
from artgen.export.frames import (
    FAR,
    INTERMEDIATE_INERTIA,
    INTERMEDIATE_MASS,
    Segment,
    chain,
    coupling,
    joint_type,
    local,
    mass_in_frame,
    translation,
)
from artgen.export.losses import Loss, Written, label_losses, look_losses, loss
from artgen.export.meshes import MeshFiles, display_color, mesh_files
from artgen.export.urdf.losses import add, add_spring, digits, material_losses, motion_losses, primitives
from artgen.materials import Material

# mass properties of links that mark grasps or pushes: without a mass, PyBullet assumes 1 kg and warns; with
# 0, SAPIEN assumes moments of 1e-6 kg m^2, as does Newton below 1e-10 kg m^2, which equals that of a latch
_MARKER_MASS = 1e-9  # [kg]
_MARKER_INERTIA = 2e-10  # [kg m^2]
_NUMERIC = (
    "origin", "axis", "limit", "dynamics", "mimic", "mass", "inertia", "box", "cylinder", "sphere", "color",
)  # fmt: skip


def write_urdf(asset: Asset, textures: int = 0) -> Written:
    """Write an asset as URDF, with its meshes.

    Args:
        asset: The asset.
        textures: Texels per side of the material maps; 0 for colors only.

    Returns:
        The URDF, mesh and map files, and the losses of URDF.
    """
    from yourdfpy import urdf as model

    meshes = mesh_files(asset, textures)
    segments = chain(asset)
    robot = model.Robot(name=asset.name)
    robot.materials = [_material(material) for material in asset.materials if _is_plain(material, meshes)]
    robot.links = [_link(asset, asset.links[0], meshes)]
    for segment in segments:  # in the order of the joints, because some readers number both together
        child = segment.child
        robot.links.append(
            _small_link(child.name, INTERMEDIATE_MASS, INTERMEDIATE_INERTIA)
            if child.link is None
            else _link(asset, child.link, meshes)
        )
    robot.joints = [_joint(segment) for segment in segments]
    _add_affordances(robot, asset)
    tree = _tree(robot)
    _add_couplings(tree, asset)
    for joint in asset.joints:
        add_spring(tree.getroot(), joint.name, joint, joint.rest)
    return Written(
        {f"{asset.name}.urdf": _text(tree), **meshes.files}, _losses(asset, segments, meshes, textures)
    )


def _tree(robot: Any) -> Any:
    """Return the XML tree of yourdfpy's model with the materials first."""
    from yourdfpy import urdf as model

    # the null handler: the mesh files do not exist yet
    handler = model.filename_handler_null
    tree = model.URDF(robot, build_scene_graph=False, load_meshes=False, filename_handler=handler).write_xml()
    for number, element in enumerate(tree.getroot().findall("material")):
        tree.getroot().insert(number, element)
    return tree


def _material(material: Material) -> Any:
    from yourdfpy import urdf as model

    rgba = np.array([*display_color(material.base_color), material.opacity])
    return model.Material(material.name, model.Color(rgba))


def _is_plain(material: Material, meshes: MeshFiles) -> bool:
    """Return whether the URDF may have a material's color.

    With a color map it may not: PyBullet multiplies the map with it, SAPIEN shows it instead of the map.
    """
    return "albedo" not in meshes.maps.of(material)


def _link(asset: Asset, link: Link, meshes: MeshFiles) -> Any:
    from yourdfpy import urdf as model

    mass, center, inertia = mass_in_frame(asset, link)
    result = model.Link(link.name, model.Inertial(translation(center), mass, inertia))
    for surface, file in zip(link.surfaces, meshes.surfaces[link.name], strict=True):
        geometry = model.Geometry(mesh=model.Mesh(meshes.path(file)))
        plain = _is_plain(surface.material, meshes)
        material = model.Material(surface.material.name) if plain else None
        result.visuals.append(model.Visual(file.removesuffix(".obj"), np.eye(4), geometry, material))
    for number, collider in enumerate(link.colliders):
        name = f"{link.name}_collider_{number}"
        if collider.convex.kind == "hull":
            geometry = model.Geometry(mesh=model.Mesh(meshes.path(meshes.colliders[link.name][number])))
            middle = translation(meshes.middles[link.name][number])
            result.collisions.append(model.Collision(name, middle, geometry))
        else:
            result.collisions += [
                model.Collision(name + suffix, local(asset, link.name, piece.pose), _geometry(piece))
                for suffix, piece in primitives(collider.convex)
            ]
    return result


def _small_link(name: str, mass: float, moment: float) -> Any:
    """Return a link without geometry, with a small mass, which simulators require."""
    from yourdfpy import urdf as model

    return model.Link(name, model.Inertial(np.eye(4), mass, moment * np.eye(3)))


def _geometry(convex: Convex) -> Any:
    from yourdfpy import urdf as model

    if convex.kind == "box":
        return model.Geometry(box=model.Box(np.array(convex.size)))
    if convex.kind == "sphere":
        return model.Geometry(sphere=model.Sphere(convex.size[0]))
    return model.Geometry(cylinder=model.Cylinder(*convex.size))


def _joint(segment: Segment) -> Any:
    from yourdfpy import urdf as model

    joint = segment.joint
    result = model.Joint(
        joint.name, joint_type(joint), segment.parent.name, segment.child.name, segment.origin
    )
    if joint.locked:
        return result
    result.axis = joint.axis
    result.limit = model.Limit(joint.effort, joint.velocity)
    if result.type != "continuous":
        result.limit.lower, result.limit.upper = joint.limits or (-FAR, FAR)
    result.dynamics = model.Dynamics(joint.damping, joint.friction)
    return result


def _add_affordances(robot: Any, asset: Asset) -> None:
    """Mark each grasp and push by a fixed link, which is a named frame in URDF."""
    from yourdfpy import urdf as model

    taken = {link.name for link in robot.links} | {joint.name for joint in robot.joints}
    for affordance in asset.affordances:
        name = f"{affordance.kind}_{affordance.name}"
        while name in taken or f"{name}_mount" in taken:
            name += "_"
        taken |= {name, f"{name}_mount"}
        robot.links.append(_small_link(name, _MARKER_MASS, _MARKER_INERTIA))
        frame = local(asset, affordance.link, affordance.frame)
        robot.joints.append(model.Joint(f"{name}_mount", "fixed", affordance.link, name, frame))


def _add_couplings(tree: Any, asset: Asset) -> None:
    """Add the couplings of yourdfpy's model, which its writer omits."""
    elements = {element.get("name"): element for element in tree.iterfind("joint")}
    for joint in asset.joints:
        follows = coupling(asset, joint)
        if follows is not None and not joint.locked:
            numbers = {"multiplier": repr(follows.ratio), "offset": repr(follows.offset)}
            add(elements[joint.name], "mimic", joint=follows.leader, **numbers)


def _text(tree: Any) -> bytes:
    """Return the XML text with numbers rounded to the digits in which all machines agree."""
    for element in tree.getroot().iter(*_NUMERIC):
        lengths = element.tag in {"origin", "axis"}
        for key, value in element.items():
            if key == "joint":
                continue
            numbers = [round(float(word), 12) if lengths else float(word) for word in value.split()]
            element.set(key, " ".join(map(digits, numbers)))
    text = BytesIO()
    tree.write(text, xml_declaration=True, encoding="utf-8", pretty_print=True)
    return text.getvalue()


def _losses(asset: Asset, segments: Sequence[Segment], meshes: MeshFiles, textures: int) -> tuple[Loss, ...]:
    return (
        *motion_losses(asset, [segment.child.name for segment in segments if segment.child.link is None]),
        *_affordance_losses(asset),
        *material_losses(asset),
        *loss(
            "color beside a color map",
            [material.name for material in asset.materials if not _is_plain(material, meshes)],
            "the map in the MTL file; many clients darken or hide it where the URDF has a color",
        ),
        *look_losses(asset, textures),
        *label_losses(asset),
    )


def _affordance_losses(asset: Asset) -> Iterator[Loss]:
    for kind, besides in (
        ("grasp", "the width and the joints that it moves"),
        ("push", "the joints that it moves"),
    ):
        yield from loss(
            f"{kind} frame",
            [affordance.name for affordance in asset.affordances if affordance.kind == kind],
            f"a link named {kind}_... of {_MARKER_MASS:g} kg, fixed there; {besides} are in asset.json",
        )
