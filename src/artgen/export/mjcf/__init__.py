"""MJCF, the format of MuJoCo, for inclusion in or attachment to other models.

So the file has no floor, light, camera or solver option, and the names of its default classes, materials and
textures begin with its own name; links, joints and meshes have the same names as in other formats.
`<exclude>` is never used: parts that collide by mistake are a fault of the asset.

Features without an MJCF element are in `<custom>`: a text `<link>_labels` holds the semantic labels of a
link; a tuple with the name of a grasp or push holds its site, with the opening of the fingers as the number,
and the joints that the hand moves, the nearest first.
"""

import xml.etree.ElementTree as ET

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset, AssetJoint, Link
from artgen.asset.affordance import Grasp
from artgen.colliders import Convex
from artgen.export.frames import (
    BodyFrame,
    BodyJoint,
    bodies,
    coupling,
    local,
    mass_in_frame,
    quaternion,
    translation,
)
from artgen.export.losses import (
    Loss,
    Written,
    contact_losses,
    dependency_losses,
    joints_where,
    look_losses,
    loss,
)
from artgen.export.meshes import MeshFiles, mesh_files
from artgen.export.mjcf.materials import add_materials, material_name, numbers

# time constant [s] and damping ratio of limits, contacts and couplings; MuJoCo allows at least two time steps
# of 2 ms by default and lengthens it for longer steps; with the default of 20 ms, a bolt lags behind its
# lever and a heavy door sinks into its stop
_STIFF = "0.005 1"
_COUPLING_IMPEDANCE = "0.99 0.9999 0.0001"
_CONTACT_IMPEDANCE = "0.95 0.99 0.0005"
_FRICTION_IMPEDANCE = "0.9999 0.9999 0.001"  # with the default, a rod that friction holds creeps 16 mm in 5 s


def write_mjcf(asset: Asset, textures: int = 0) -> Written:
    """Write an asset as MJCF, with its meshes.

    The initial state of the model is `asset.positions()`, with every joint as near to 0 as its limits allow.

    Args:
        asset: The asset.
        textures: Texels per side of the material maps; 0 for colors only.

    Returns:
        The MJCF, mesh and map files, and the losses of MJCF.
    """
    meshes = mesh_files(asset, textures)
    root = mjcf_tree(asset, meshes)
    return Written({f"{asset.name}.xml": mjcf_text(root), **meshes.files}, mjcf_losses(asset, textures))


def mjcf_tree(asset: Asset, meshes: MeshFiles) -> ET.Element:
    """Return an asset as elements of an MJCF file next to the directory of its meshes."""
    root = ET.Element("mujoco", model=asset.name)
    # no directories here: a scene that includes the file would not find its files
    ET.SubElement(root, "compiler", angle="radian", autolimits="true")
    _add_defaults(root, asset)
    _add_assets(root, asset, meshes)
    world = ET.SubElement(root, "worldbody")
    elements: dict[str, ET.Element] = {}
    for frame in bodies(asset):
        parent = elements[frame.parent] if frame.parent else world
        elements[frame.link.name] = _add_body(parent, asset, frame, meshes)
    _add_couplings(root, asset)
    _add_custom(root, asset)
    return root


def mjcf_text(root: ET.Element) -> bytes:
    """Return the text of the elements of an MJCF file, indented."""
    ET.indent(root, " ")
    text: bytes = ET.tostring(root, encoding="utf-8", xml_declaration=True)
    return text + b"\n"


def _class(asset: Asset, what: str = "") -> str:
    return f"{asset.name}_{what}" if what else asset.name


def _add_defaults(root: ET.Element, asset: Asset) -> None:
    outer = ET.SubElement(ET.SubElement(root, "default"), "default", {"class": _class(asset)})
    ET.SubElement(
        outer, "joint", solreflimit=_STIFF, solreffriction=_STIFF, solimpfriction=_FRICTION_IMPEDANCE
    )
    ET.SubElement(outer, "site", group="4", size="0.005")
    visual = ET.SubElement(outer, "default", {"class": _class(asset, "visual")})
    ET.SubElement(visual, "geom", type="mesh", group="2", contype="0", conaffinity="0", mass="0")
    collision = ET.SubElement(outer, "default", {"class": _class(asset, "collision")})
    ET.SubElement(collision, "geom", group="3", mass="0", solref=_STIFF, solimp=_CONTACT_IMPEDANCE)


def _add_assets(root: ET.Element, asset: Asset, meshes: MeshFiles) -> None:
    parent = ET.SubElement(root, "asset")
    add_materials(parent, asset, meshes.maps)
    for link in asset.links:
        for file in meshes.surfaces[link.name]:
            # its faces have no mass: a surface need not be closed
            ET.SubElement(parent, "mesh", name=_stem(file), file=MeshFiles.path(file), inertia="shell")
        for file in meshes.colliders[link.name].values():
            ET.SubElement(parent, "mesh", name=_stem(file), file=MeshFiles.path(file), inertia="convex")


def _add_body(parent: ET.Element, asset: Asset, frame: BodyFrame, meshes: MeshFiles) -> ET.Element:
    link = frame.link
    body = ET.SubElement(parent, "body", {"name": link.name, **_placed(frame.placement)})
    if not frame.parent:
        body.set("childclass", _class(asset))
        if asset.base == "free":
            ET.SubElement(body, "freejoint", name=f"{asset.name}_free")
    mass, center, inertia = mass_in_frame(asset, link)
    six = [inertia[row, column] for row, column in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))]
    ET.SubElement(body, "inertial", pos=numbers(center), mass=numbers([mass]), fullinertia=numbers(six))
    for joint in frame.joints:
        ET.SubElement(body, "joint", _joint(joint))
    for surface, file in zip(link.surfaces, meshes.surfaces[link.name], strict=True):
        geom = {"name": _stem(file), "class": _class(asset, "visual"), "mesh": _stem(file)}
        ET.SubElement(body, "geom", geom, material=material_name(asset, surface.material))
    _add_colliders(body, asset, link, meshes)
    for hold in (*link.grasps, *link.pushes):
        site = {"name": hold.name, **_placed(local(asset, link.name, hold.frame))}
        if isinstance(hold, Grasp):
            site["user"] = numbers([hold.width])  # the site keeps the data if `<custom>` is dropped
        ET.SubElement(body, "site", site)
    return body


def _add_colliders(body: ET.Element, asset: Asset, link: Link, meshes: MeshFiles) -> None:
    for number, collider in enumerate(link.colliders):
        name = f"{link.name}_collider_{number}"
        # sliding friction only: resistance to torsion depends on the hand
        geom = {
            "name": name,
            "class": _class(asset, "collision"),
            "friction": numbers([collider.material.friction]),
        }
        convex = collider.convex
        if convex.kind == "hull":
            geom |= {"type": "mesh", "mesh": _stem(meshes.colliders[link.name][number])}
            geom |= _placed(translation(meshes.middles[link.name][number]))
        else:
            geom |= {"type": convex.kind, "size": numbers(_half_sizes(convex))}
            geom |= _placed(local(asset, link.name, convex.pose))
        ET.SubElement(body, "geom", geom)


def _half_sizes(convex: Convex) -> list[float]:
    if convex.kind == "box":
        return [length / 2 for length in convex.size]
    radius, *length = convex.size
    return [radius, *(each / 2 for each in length)]


def _joint(placed: BodyJoint) -> dict[str, str]:
    joint = placed.joint
    attributes = {
        "name": joint.name,
        "type": "hinge" if joint.kind == "revolute" else "slide",
        "axis": numbers(np.round(placed.axis, 12)),
    }
    if joint.kind == "revolute" and np.abs(placed.pivot).max() > 1e-12:
        attributes["pos"] = numbers(np.round(placed.pivot, 12))
    if joint.limits is None:
        attributes["limited"] = "false"
    else:
        attributes["range"] = numbers(joint.limits)
    if placed.position:
        attributes["ref"] = numbers([placed.position])
    if joint.stiffness:
        attributes |= {"stiffness": numbers([joint.stiffness]), "springref": numbers([joint.rest])}
    for name, value in (
        ("damping", joint.damping),
        ("frictionloss", joint.friction),
        ("armature", joint.armature),
    ):
        if value:
            attributes[name] = numbers([value])
    attributes["actuatorfrcrange"] = numbers([-joint.effort, joint.effort])
    return attributes


def _add_couplings(root: ET.Element, asset: Asset) -> None:
    follows = {joint.name: coupling(asset, joint) for joint in asset.joints if not joint.locked}
    equality = None
    for name, found in follows.items():
        if found is None:
            continue
        equality = ET.SubElement(root, "equality") if equality is None else equality
        # the polynomial relates displacements from the initial state, in which the coupling holds
        ET.SubElement(
            equality,
            "joint",
            joint1=name,
            joint2=found.leader,
            polycoef=f"0 {numbers([found.ratio])} 0 0 0",
            solref=_STIFF,
            solimp=_COUPLING_IMPEDANCE,
        )


def _add_custom(root: ET.Element, asset: Asset) -> None:
    """Add custom elements for features without an MJCF element; they survive attachment to a model."""
    custom = ET.SubElement(root, "custom")
    for link in asset.links:
        ET.SubElement(custom, "text", name=f"{link.name}_labels", data=" ".join(link.labels))
    for affordance in asset.affordances:
        element = ET.SubElement(custom, "tuple", name=affordance.name)
        width = numbers([affordance.width])
        ET.SubElement(element, "element", objtype="site", objname=affordance.name, prm=width)
        for joint in affordance.joints:
            ET.SubElement(element, "element", objtype="joint", objname=joint, prm="0")


def _placed(matrix: Array) -> dict[str, str]:
    """Return position and orientation, without default values."""
    attributes = {}
    position, turn = np.round(matrix[:3, 3], 12), np.round(quaternion(matrix), 12)
    if position.any():
        attributes["pos"] = numbers(position)
    if turn[1:].any():
        attributes["quat"] = numbers(turn)
    return attributes


def _stem(file: str) -> str:
    return file.removesuffix(".obj")


def mjcf_losses(asset: Asset, textures: int) -> tuple[Loss, ...]:
    """Return the losses of MJCF for an asset with a size of maps."""

    def moving(joint: AssetJoint) -> bool:
        return not joint.locked

    return (
        *loss("joint velocity limit", joints_where(asset, moving), "nothing"),
        *loss(
            "locked joint",
            joints_where(asset, lambda joint: joint.locked),
            "no joint: the body is fixed to its parent where the joint holds it",
        ),
        *dependency_losses(asset),
        *contact_losses(asset),
        *look_losses(asset, textures, coat="the highlight of the coat, in the classic renderer"),
    )
