"""MJCF, the format of MuJoCo, for inclusion in or attachment to other models.

So the file has no floor, camera or solver option, and no light unless it is that of a room; the names of its
default classes, materials and textures begin with its own name; links, joints and meshes have the same names
as in other formats. `<exclude>` is never used: parts that collide by mistake are a fault of the asset.

Detents of a joint are spatial tendons that act as short springs between sites (`_detents`). A soft closing is
one that gets longer near the closed position, and nowhere else (`_closing`). Models of a batch have the same
tendons: those that an asset lacks have no stiffness and no damping (`Tendons`).

Features without an MJCF element are in `<custom>`: a text `<link>_labels` holds the semantic labels of a
link; a tuple with the name of a grasp or push holds its site, with the opening of the fingers as the number,
and the joints that the hand moves, the nearest first; the text `<asset>_artgen_states` holds limits,
couplings and dependencies of the joints, which `artgen.asset.valid_states` reads. Keyframes are valid states.
"""

import math
import xml.etree.ElementTree as ET
from collections.abc import Iterator, Mapping
from dataclasses import replace

import numpy as np

from artgen import _portable
from artgen._arrays import Array
from artgen.asset import Asset, AssetJoint, AssetSoftClosing, Link
from artgen.asset.affordance import Grasp
from artgen.asset.valid_states import KEY
from artgen.colliders import Convex
from artgen.export import frames
from artgen.export.losses import Loss, Written, look_rows, losses, mechanism_rows, seen_materials
from artgen.export.maps import TEXTURE_DIRECTORY, MapFiles, highlight
from artgen.export.meshes import MeshFiles, display_color, mesh_files, mesh_name
from artgen.export.text import Attribute, add, document, states_text
from artgen.materials import Material
from artgen.materials.textures import Kind

# time constant [s] and damping ratio of limits, contacts and couplings; MuJoCo allows at least two time steps
# of 2 ms by default and lengthens it for longer steps; with the default of 20 ms, a bolt lags behind its
# lever and a heavy door sinks into its stop
_STIFF = "0.005 1"
OFF = -1000.0  # margin of a spare collider: MuJoCo adds the margins of two geoms, so that it touches nothing
_KEYFRAMES = 4  # number of drawn states
_AT_ZERO = 1e-9  # a smaller rest position is 0: curves of closed chains are less exact [rad or m]
_DETENT_ARM = 0.01  # distance of the springs of detents from their axis [m]
_DRUM = 0.01  # radius of the drum of a soft closing, around which its cord lies [m]
_BESIDE = 0.03  # angle between the end of such a cord and its contact with the drum [rad]
_SLACK = 0.05  # distance of the other end of a cord from the joint's limit [rad or m]
_ENDLESS = 1000.0  # length from which such a spring would pull [m]
_NO_CLOSING = AssetSoftClosing(reach=0.0, preload=0.0, force=0.0, damping=0.0)
_COUPLING_IMPEDANCE = "0.99 0.9999 0.0001"
_SCREW_IMPEDANCE = "0.9999 0.9999 0.0001"  # with the other, a light lid sinks by 0.1 mm
_CONTACT_IMPEDANCE = "0.95 0.99 0.0005"
_FRICTION_IMPEDANCE = "0.9999 0.9999 0.001"  # with the default, a rod that friction holds creeps 16 mm in 5 s


Tendons = Mapping[str, tuple[int, bool]]
"""Number of ridges of each joint, and whether it has a soft closing, by the name of the joint."""


def tendons_of(asset: Asset) -> Tendons:
    """Return the tendons of an asset by the name of the joint."""
    return {joint.name: (len(joint.ridges), joint.closing is not None) for joint in asset.joints}


# directions and strengths of the lights of a room: the lamp that MuJoCo adds itself is dim
_LIGHTS = (((0.3, 0.6, -1.0), 0.4), ((-1.0, 0.3, -0.6), 0.3), ((1.0, 0.3, -0.6), 0.25))
_UNSEEN: dict[str, Attribute] = {"group": "4"}  # as the sites of tendons: viewers hide both by default


def write_mjcf(asset: Asset, textures: int = 0, tendons: Tendons | None = None) -> Written:
    """Write an asset as MJCF, with its meshes.

    The initial state of the model is `asset.positions()`, with every joint as near to 0 as its limits allow.

    Args:
        asset: The asset.
        textures: Texels per side of the material maps; 0 for colors only.
        tendons: Tendons of the model, at least those of the asset, which are the default.

    Returns:
        The MJCF, mesh and map files, and the losses of MJCF.
    """
    meshes = mesh_files(asset, textures)
    root = mjcf_tree(asset, meshes, tendons)
    custom, world = root.find("custom"), root.find("worldbody")
    assert custom is not None
    assert world is not None
    for number, (way, strength) in enumerate(_LIGHTS if asset.is_room else ()):
        light: dict[str, Attribute] = {"type": "directional", "dir": way, "diffuse": 3 * (strength,)}
        light |= {"ambient": 3 * (0.15 * strength,), "castshadow": "false"}
        add(world, "light", light, name=f"{asset.name}_light_{number}", pos=(0.0, 0.0, 3.0))
    add(custom, "text", name=f"{asset.name}_{KEY}", data=states_text(asset))
    _add_keyframes(root, asset)
    text = document(root)
    return Written({f"{asset.name}.xml": text, **meshes.files}, mjcf_losses(asset, textures))


def mjcf_losses(asset: Asset, textures: int) -> tuple[Loss, ...]:
    """Return the losses of MJCF for an asset with a size of maps."""
    locked = "no joint: the body is fixed to its parent where the joint holds it"
    held = [joint.name for joint in asset.joints if joint.locked and joint.child not in asset.loose]
    coats = [material.name for material in seen_materials(asset) if material.coat_weight]
    return losses(
        ("joint velocity limit", [joint.name for joint in asset.joints if not joint.locked], "nothing"),
        ("locked joint", held, locked),
        *mechanism_rows(asset),
        *look_rows(asset, textures),
        ("coat", coats, "the highlight of the coat, in the classic renderer"),
    )


def mjcf_tree(asset: Asset, meshes: MeshFiles, tendons: Tendons | None = None) -> ET.Element:
    """Return an asset as elements of an MJCF file next to the directory of its meshes; see `write_mjcf`."""
    root = ET.Element("mujoco", model=asset.name)
    # no directories here: a scene that includes the file would not find its files
    add(root, "compiler", angle="radian", autolimits="true")
    _add_defaults(root, asset.name)
    _add_assets(root, asset, meshes)
    world = add(root, "worldbody")
    elements: dict[str, ET.Element] = {}
    rest = dict(zip(asset.links.by_name, asset.fk(_closed(asset)), strict=True)) if asset.loose else {}
    for each in frames.bodies(asset):
        name, frame = each.link.name, each
        if name in asset.loose:
            frame = replace(each, parent="", placement=rest[name])
        elements[name] = _add_body(elements[frame.parent] if frame.parent else world, asset, frame, meshes)
    _add_couplings(root, asset)
    _add_tendons(root, asset, elements, tendons or tendons_of(asset))
    _add_custom(root, asset)
    return root


def _add_defaults(root: ET.Element, name: str) -> None:
    outer = add(add(root, "default"), "default", {"class": name})
    add(outer, "joint", solreflimit=_STIFF, solreffriction=_STIFF, solimpfriction=_FRICTION_IMPEDANCE)
    add(outer, "site", group="4", size="0.005")
    visual = add(outer, "default", {"class": f"{name}_visual"})
    add(visual, "geom", type="mesh", group="2", contype="0", conaffinity="0", mass="0")
    collision = add(outer, "default", {"class": f"{name}_collision"})
    add(collision, "geom", group="3", mass="0", solref=_STIFF, solimp=_CONTACT_IMPEDANCE)


def _add_assets(root: ET.Element, asset: Asset, meshes: MeshFiles) -> None:
    parent = add(root, "asset")
    added: set[str] = set()
    for material in asset.materials:
        _add_material(parent, asset.name, material, meshes.maps, added)
    for link in asset.links:
        for path in meshes.surfaces[link.name]:
            # its faces have no mass: a surface need not be closed
            add(parent, "mesh", name=mesh_name(path), file=path, inertia="shell")
        for path in meshes.colliders[link.name].values():
            add(parent, "mesh", name=mesh_name(path), file=path, inertia="convex")


_ROLES: dict[Kind, str] = {
    "albedo": "rgb", "normal": "normal", "roughness": "roughness", "metalness": "metallic",
}  # fmt: skip
_GREATEST = 128.0  # exponent of the classic renderer at shininess 1


def _add_material(
    parent: ET.Element, prefix: str, material: Material, maps: MapFiles, added: set[str]
) -> None:
    """Add a material for both renderers of MuJoCo: the classic Phong renderer and the physically based one.

    Its name and those of its maps begin with the asset's name, because assets in one scene may share
    materials. MuJoCo multiplies the numbers of a material with its maps. The classic renderer shows the color
    map unchanged only if MuJoCo chooses its color space: it decodes sRGB, but does not encode again.
    """
    files = {role: maps.of(material)[kind] for kind, role in _ROLES.items() if kind in maps.of(material)}
    layers = {role: f"{prefix}_{file.removesuffix('.png')}" for role, file in files.items()}
    for role, file in files.items():
        if file not in added:
            add(parent, "texture", type="2d", name=layers[role], file=f"{TEXTURE_DIRECTORY}/{file}")
            added.add(file)
    name, emission = f"{prefix}_{material.name}", None
    if any(material.emission):
        # a factor of the color for the classic renderer, a map of one texel for the other
        emission = max(material.emission) / max(*material.base_color, 1e-3)
        layers["emissive"] = f"{name}_emission"
        light = [channel / emission for channel in material.emission]
        flat = {"type": "2d", "name": layers["emissive"], "builtin": "flat"}
        add(parent, "texture", flat, rgb1=light, width="1", height="1")
    color = (1.0, 1.0, 1.0) if "rgb" in layers else material.base_color
    specular, exponent = highlight(material, _GREATEST)
    element = add(
        parent,
        "material",
        name=name,
        rgba=[*display_color(color), material.opacity],
        specular=round(specular, 6),
        shininess=round(exponent / _GREATEST, 6),
        roughness=1.0 if "roughness" in layers else material.specular_roughness,
        metallic=1.0 if "metallic" in layers else material.base_metalness,
        emission=emission,
    )
    for role, texture in layers.items():
        add(element, "layer", role=role, texture=texture)


def _add_body(parent: ET.Element, asset: Asset, frame: frames.BodyFrame, meshes: MeshFiles) -> ET.Element:
    link = frame.link
    body = add(parent, "body", name=link.name, **_placed(frame.placement))
    if not frame.parent:
        body.set("childclass", asset.name)
        if link.name in asset.loose:
            add(body, "freejoint", name=f"{link.name}_free")
        elif asset.base == "free":
            add(body, "freejoint", name=f"{asset.name}_free")
    mass, center, inertia = frames.mass_in_frame(asset, link)
    six = inertia[[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]]
    add(body, "inertial", pos=center, mass=mass, fullinertia=six)
    for joint in frame.joints:
        _add_joint(body, joint)
    for surface, path in zip(link.surfaces, meshes.surfaces[link.name], strict=True):
        geom = {"name": mesh_name(path), "class": f"{asset.name}_visual", "mesh": mesh_name(path)}
        add(body, "geom", geom, material=f"{asset.name}_{surface.material.name}")
    _add_colliders(body, asset, link, meshes)
    for hold in (*link.grasps, *link.pushes):
        # the site keeps the width if `<custom>` is dropped
        width = hold.width if isinstance(hold, Grasp) else None
        add(body, "site", name=hold.name, **_placed(frames.local(asset, link.name, hold.frame)), user=width)
    return body


def _add_colliders(body: ET.Element, asset: Asset, link: Link, meshes: MeshFiles) -> None:
    for number, collider in enumerate(link.colliders):
        geom: dict[str, Attribute] = {
            "name": f"{link.name}_collider_{number}",
            "class": f"{asset.name}_collision",
            # sliding friction only: resistance to torsion depends on the hand
            "friction": collider.material.friction,
            "margin": OFF if collider.spare else None,
        }
        convex = collider.convex
        if convex.kind == "hull":
            mesh = mesh_name(meshes.colliders[link.name][number])
            pose = frames.translation(meshes.middles[link.name][number])
            add(body, "geom", geom, type="mesh", mesh=mesh, **_placed(pose))
        else:
            pose = frames.local(asset, link.name, convex.pose)
            add(body, "geom", geom, type=convex.kind, size=_half_sizes(convex), **_placed(pose))


def _half_sizes(convex: Convex) -> list[float]:
    whole = 0 if convex.kind == "box" else 1  # a radius comes first
    return [*convex.size[:whole], *(length / 2 for length in convex.size[whole:])]


def _add_joint(body: ET.Element, placed: frames.BodyJoint) -> None:
    joint, turns = placed.joint, placed.joint.kind == "revolute"
    add(
        body,
        "joint",
        name=joint.name,
        type="hinge" if turns else "slide",
        axis=np.round(placed.axis, 12),
        pos=np.round(placed.pivot, 12) if turns and np.abs(placed.pivot).max() > 1e-12 else None,
        limited="false" if joint.limits is None else None,
        range=joint.limits,
        ref=placed.position if abs(placed.position) > _AT_ZERO else None,
        stiffness=joint.stiffness or None,
        springref=joint.rest if joint.stiffness else None,
        damping=joint.damping or None,
        frictionloss=joint.friction or None,
        armature=joint.armature or None,
        actuatorfrcrange=[-joint.effort, joint.effort],
    )


def _add_couplings(root: ET.Element, asset: Asset) -> None:
    found = [(joint.name, frames.linear_coupling(asset, joint)) for joint in asset.joints if not joint.locked]
    follows = [(name, law) for name, law in found if law is not None]
    equality = add(root, "equality") if follows or asset.loops else root
    for name, law in follows:
        # the polynomial relates displacements from the initial state, in which the coupling holds
        polynomial = [0.0, law.ratio, 0.0, 0.0, 0.0]
        joints = {"joint1": name, "joint2": law.leader}
        screw = asset.joint(name).child == asset.joint(law.leader).child
        impedance = _SCREW_IMPEDANCE if screw else _COUPLING_IMPEDANCE
        add(equality, "joint", joints, polycoef=polynomial, solref=_STIFF, solimp=impedance)
    for loop in asset.loops:
        first, second = loop.links
        anchor = np.round(loop.point - asset.origin(first), 12) + 0.0
        pinned = {"body1": first, "body2": second}
        add(equality, "connect", pinned, anchor=anchor, solref=_STIFF, solimp=_COUPLING_IMPEDANCE)


def _add_tendons(
    root: ET.Element, asset: Asset, elements: Mapping[str, ET.Element], tendons: Tendons
) -> None:
    """Add the detents and the soft closing of joints."""
    acting = [joint for joint in asset.joints if any(tendons[joint.name])]
    parent = add(root, "tendon") if acting else root
    for joint in acting:
        ridges, closes = tendons[joint.name]
        for link, name, place in (*_detents(parent, joint, ridges), *_closing(parent, joint, closes=closes)):
            where = frames.local(asset, link, place)
            add(elements[link], "site", name=name, pos=np.round(where[:3, 3], 12))
        if closes and joint.kind == "revolute":
            across, turned = _across(joint), frames.translation(joint.pivot)
            turned[:3, :3] = np.column_stack([across, np.cross(joint.axis, across), joint.axis])
            drum: dict[str, Attribute] = {"name": f"{joint.name}_drum", "class": f"{asset.name}_visual"}
            drum |= {"type": "cylinder", "group": "4", "rgba": "0 0 0 0", "size": (_DRUM, _DRUM / 2)}
            add(elements[joint.parent], "geom", drum, **_placed(frames.local(asset, joint.parent, turned)))


def _across(joint: AssetJoint) -> Array:
    """Return a unit vector across the axis of a joint."""
    across = np.cross(joint.axis, np.eye(3)[int(np.argmin(np.abs(np.round(joint.axis, 6))))])
    return np.asarray(across / _portable.norm(across))


_Site = tuple[str, str, Array]
"""A link, the name of a site on it, and its place in asset coordinates at rest."""


def _detents(tendons: ET.Element, joint: AssetJoint, count: int) -> Iterator[_Site]:
    """Add `count` detents: a short spring between sites of child and parent; without a ridge, it is limp."""
    if not count:
        return
    start = frames.translation(joint.pivot + _DETENT_ARM * _across(joint))
    site, torque = f"{joint.name}_detent", joint.detents.torque if joint.detents else 0.0
    yield joint.child, site, start
    springs = [(start, torque, ridge, gap) for ridge, gap in joint.ridges]
    beside = frames.translation(joint.pivot)  # no spring has length 0
    springs += [(beside, 0.0, joint.closed, _DETENT_ARM)] * (count - len(springs))
    for number, (place, torque, ridge, gap) in enumerate(springs):
        name = f"{joint.name}_ridge_{number}"
        yield joint.parent, name, _portable.product(joint.motion(ridge), place)
        reach, arm = gap / 2.0, 1.0  # distance at which the spring begins, and its arm on the ridge [m]
        if joint.kind == "revolute":
            reach, arm = 2.0 * _DETENT_ARM * _portable.sin(gap / 4.0), _DETENT_ARM
        stiffness, lengths = torque / (reach * arm), [reach, _ENDLESS]
        spring = add(tendons, "spatial", name=name, stiffness=stiffness, springlength=lengths, **_UNSEEN)
        add(spring, "site", site=site)
        add(spring, "site", site=name)


def _closing(tendons: ET.Element, joint: AssetJoint, *, closes: bool) -> Iterator[_Site]:
    """Add a soft closing: a cord from the reach over a site of the child to beyond the open limit.

    While the child is between both ends, the cord is as long wherever it is: no spring or damper of the cord
    acts. On the way home it gets longer by twice the way, which its spring, too short, pushes. On a turn it
    lies around a drum, so that its length grows with the angle. A joint without a soft closing has such a
    cord without spring and damper if `closes` asks for it.
    """
    if not closes:
        return
    closing, name = joint.closing or replace(_NO_CLOSING, reach=joint.opened), f"{joint.name}_closing"
    way = math.copysign(1.0, closing.reach - joint.closed)
    end = joint.opened + way * _SLACK
    start, arm, length = frames.translation(joint.pivot), 1.0, abs(end - closing.reach)
    if joint.kind == "revolute":
        start, arm = frames.translation(joint.pivot + _DRUM / _portable.cos(_BESIDE) * _across(joint)), _DRUM
        tangent = _portable.sin(_BESIDE) / _portable.cos(_BESIDE)
        length = _DRUM * (length + 4.0 * (tangent - _BESIDE))
    slope = 2.0 * arm  # growth of the cord with the joint's position [m/rad or 1]
    spring: dict[str, Attribute] = {"name": name, "damping": closing.damping / (slope * slope)}
    if closing.force:
        stiffness = (closing.force - closing.preload) / (slope * slope * abs(closing.reach - joint.closed))
        relaxed = length + closing.force / (slope * stiffness)
        spring |= {"stiffness": stiffness, "springlength": [relaxed, relaxed]}
    cord = add(tendons, "spatial", spring | _UNSEEN)
    for number, site in enumerate((f"{name}_reach", name, f"{name}_end")):
        if number and joint.kind == "revolute":
            add(cord, "geom", geom=f"{joint.name}_drum")
        add(cord, "site", site=site)
    yield joint.child, name, start
    for site, position in ((f"{name}_reach", closing.reach), (f"{name}_end", end)):
        yield joint.parent, site, _portable.product(joint.motion(position), start)


def _add_custom(root: ET.Element, asset: Asset) -> None:
    """Add custom elements for features without an MJCF element; they survive attachment to a model."""
    custom = add(root, "custom")
    for link in asset.links:
        add(custom, "text", name=f"{link.name}_labels", data=" ".join(link.labels))
    for affordance in asset.affordances:
        element = add(custom, "tuple", name=affordance.name)
        add(element, "element", objtype="site", objname=affordance.name, prm=affordance.width)
        for joint in affordance.joints:
            add(element, "element", objtype="joint", objname=joint, prm="0")


def _add_keyframes(root: ET.Element, asset: Asset) -> None:
    """Add valid states as keyframes: all joints closed, as far open as all can be at once, and some drawn."""
    states = asset.valid_states
    if not states.dofs:
        return
    far = np.where(abs(states.upper) >= abs(states.lower), states.upper, states.lower)
    rows: dict[str, Array] = {
        "closed": _closed(asset),
        "open": states.project(np.where(np.isfinite(far), far, 0.0)),
    }
    rows |= {f"state_{number}": row for number, row in enumerate(asset.sample_states(_KEYFRAMES))}
    keyframe = add(root, "keyframe")
    loose = {f"{name}_free": number for number, name in enumerate(asset.links.by_name) if name in asset.loose}
    order = [
        each.attrib["name"]
        for each in root.iter()
        if each.tag == "freejoint" or (each.tag == "joint" and each.get("type"))
    ]
    for name, row in rows.items():
        found: dict[str, list[float]] = {
            joint: [position] for joint, position in zip(states.joints, states.positions(row), strict=True)
        }
        found[f"{asset.name}_free"] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]
        poses = asset.fk(row) if loose else ()
        found |= {joint: [*poses[at][:3, 3], *frames.quaternion(poses[at])] for joint, at in loose.items()}
        numbers = [number for each in order for number in found[each]]
        add(keyframe, "key", name=f"{asset.name}_{name}", qpos=numbers)


def _closed(asset: Asset) -> Array:
    """Return the state in which every joint is as near to 0 as its limits allow, shape (dof,)."""
    positions = asset.positions()
    return np.array([positions[name] for name in asset.valid_states.dofs])


def _placed(matrix: Array) -> dict[str, Array | None]:
    """Return position and orientation; None for default values."""
    position, turn = np.round(matrix[:3, 3], 12), np.round(frames.quaternion(matrix), 12)
    return {"pos": position if position.any() else None, "quat": turn if turn[1:].any() else None}
