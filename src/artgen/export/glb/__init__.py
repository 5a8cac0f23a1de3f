"""GLB: one file with the meshes, materials, maps, movable nodes and animations of an asset.

The nodes are the links, with their names, in the tree of the joints; several joints of two links have a node
between them each. A node has its origin at the link's origin and is parallel to the asset's axes when every
joint stands at 0. A joint moves the node of its child along or about `axis`: a revolute joint sets its
rotation, a prismatic joint its translation.
"""

import math
from collections.abc import Collection, Sequence

import numpy as np

from artgen.asset import Asset
from artgen.asset.record import rounded
from artgen.asset.valid_states import KEY
from artgen.export import frames
from artgen.export.glb.animations import animations, local_motion
from artgen.export.glb.buffer import Buffer, Json
from artgen.export.glb.surfaces import Surfaces
from artgen.export.losses import Loss, Written, affordance_rows, look_rows, losses

_UPRIGHT = [-math.sqrt(0.5), 0.0, 0.0, math.sqrt(0.5)]  # turns z up into y up
_ROOT, _BASE = 0, 1  # numbers of nodes


def write_glb(asset: Asset, textures: int = 0) -> Written:
    """Write an asset as one GLB file.

    Args:
        asset: The asset.
        textures: Texels per side of the material maps; 0 for colors only.

    Returns:
        The file, and the losses of GLB.

    Raises:
        ParameterError: The size of maps is not allowed.
    """
    buffer = Buffer()
    surfaces = Surfaces(buffer, textures)
    segments = frames.chain(asset)
    bodies = [frames.base_frame(asset), *(segment.child for segment in segments)]
    numbers = {frame.name: number for number, frame in enumerate(bodies, _BASE)}
    nodes = [_root(asset, segments, numbers), *map(_node, bodies)]
    for segment in segments:
        child = numbers[segment.child.name]
        _place(asset, segment, nodes[child])
        nodes[numbers[segment.parent.name]].setdefault("children", []).append(child)
    meshes: list[Json] = []
    for frame in bodies:
        if frame.link is not None:
            nodes[numbers[frame.name]]["mesh"] = len(meshes)
            primitives = [surfaces.primitive(each, frame.origin) for each in frame.link.surfaces]
            # readers rename a mesh with the name of a node
            meshes.append({"name": frames.unused(f"{frame.name}_mesh", numbers), "primitives": primitives})
    moved, held = animations(asset, segments, numbers, buffer)
    scene = {
        "asset": {
            "version": "2.0",
            "generator": f"artgen {asset.version}".strip(),
            "extras": {KEY: asset.states_data()},
        },
        "scene": 0,
        "scenes": [{"name": asset.name, "nodes": [_ROOT]}],
        "nodes": nodes,
        "meshes": meshes,
        **surfaces.to_data(),
        **({"animations": moved} if moved else {}),
    }
    return Written({f"{asset.name}.glb": buffer.glb(scene)}, _losses(asset, textures, held))


def _root(asset: Asset, segments: Sequence[frames.Segment], taken: Collection[str]) -> Json:
    """Return the root node, which turns the asset upright and has its metadata."""
    data: Json = {name: getattr(asset, name) for name in ("name", "category", "seed", "version", "base")}
    data["joints"] = [_joint(asset, segment) for segment in segments]
    node = {"name": frames.unused(asset.name, taken), "rotation": _UPRIGHT, "children": [_BASE]}
    return {**node, "extras": {"artgen": rounded(data)}}


def _joint(asset: Asset, segment: frames.Segment) -> Json:
    """Return the data of a joint for a viewer with sliders."""
    joint, follows = segment.joint, frames.linear_coupling(asset, segment.joint)
    lower, upper = joint.limits or (None, None)
    mimic = None
    if follows is not None:
        mimic = {"joint": follows.leader, "multiplier": follows.ratio, "offset": follows.offset}
    return {
        "name": joint.name,
        "type": frames.joint_type(joint),
        "parent": joint.parent,
        "child": joint.child,
        "node": segment.child.name,
        "origin": segment.origin[:3, 3].tolist(),
        "axis": joint.axis.tolist(),
        "lower": lower,
        "upper": upper,
        "position": asset.positions()[joint.name],
        "mimic": mimic,
        "needs": None if joint.needs is None else {**joint.needs.to_data(), "text": str(joint.needs)},
    }


def _node(frame: frames.LinkFrame) -> Json:
    """Return the node of a frame, without its placement in its parent."""
    node: Json = {"name": frame.name}
    if frame.link is not None:
        node["extras"] = {"label": frame.link.label, "labels": list(frame.link.labels)}
    return node


def _place(asset: Asset, segment: frames.Segment, node: Json) -> None:
    """Place the node of a segment's child at the initial positions."""
    joint = segment.joint
    if joint.locked:
        w, x, y, z = frames.quaternion(segment.origin)
        move, turn = segment.origin[:3, 3], np.array([x, y, z, w])
    else:
        moves, turns = local_motion(segment, np.array([asset.positions()[joint.name]]))
        move, turn = moves[0], turns[0]
    if np.any(move):
        node["translation"] = rounded(move.tolist())
    if turn[3] != 1.0:
        node["rotation"] = rounded(turn.tolist())


def _losses(asset: Asset, textures: int, held: Sequence[str]) -> tuple[Loss, ...]:
    links = [link.name for link in asset.links]
    driven = [
        joint.name
        for joint in asset.joints
        if any((joint.stiffness, joint.damping, joint.friction, joint.armature, joint.ridges))
    ]
    recorded = "nothing; asset.json has it"
    return losses(
        ("mass and inertia", links, recorded),
        ("colliders", links, recorded),
        ("joints", [joint.name for joint in asset.joints], "data of the root node and animations"),
        ("joint dynamics", driven, recorded),
        ("animation", held, "nothing: no way was found that its dependencies allow"),
        *affordance_rows(asset, recorded, recorded),
        *look_rows(asset, textures),
    )
