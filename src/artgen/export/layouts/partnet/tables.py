"""Tables of the PartNet-Mobility layout: names of parts, their motion, their files."""

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset, AssetJoint, Link
from artgen.asset.record import json_text, rounded
from artgen.export.layouts.partnet.names import UPRIGHT, Naming, kind_of, semantic
from artgen.export.meshes import mesh_name
from artgen.export.names import NAMES_FILE

CATEGORIES: Mapping[str, str] = {
    "cabinet": "StorageFurniture", "chair folding": "FoldingChair", "drawer": "StorageFurniture",
    "plier": "Pliers", "pot": "KitchenPot",
    "soap_dispenser": "Dispenser", "trash": "TrashCan", "trash_can": "TrashCan", "trashcan": "TrashCan",
    "usb_stick": "USB",
}  # fmt: skip
"""Names of categories in the dataset, by category or its style, that are not artgen's in camel case."""

# rotation from asset to `base`: the front towards -x
_FRONT = np.array([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])


def tables(asset: Asset, named: Naming, surfaces: Mapping[str, Sequence[str]]) -> dict[str, bytes]:
    """Return the tables by file name.

    Args:
        asset: The asset.
        named: Its names in the dataset.
        surfaces: Paths of the surfaces of each link.
    """
    base, *moving = asset.links
    links = (*moving, base)
    camel = "".join(word.capitalize() for word in asset.category.split("_"))
    styled = f"{asset.category} {asset.parameters.get('style', '')}"
    category = CATEGORIES.get(styled) or CATEGORIES.get(asset.category, camel)
    semantics = [_semantics(asset, named, link) for link in links]
    data = {
        "meta.json": {
            "user_id": "artgen",
            "model_cat": category,
            "model_id": asset.name,
            "version": asset.version,
            "anno_id": "" if asset.seed is None else str(asset.seed),
            "time_in_sec": "0",
        },
        "bounding_box.json": _box(asset.bounds() @ UPRIGHT.T),
        "mobility_v2.json": [_mobility(asset, named, link) for link in links],
        # the tree of parts with the stems of their files in `textured_objs`
        "result.json": [
            {
                "text": category,
                "name": category,
                "id": 0,
                "children": [part for link in links for part in _parts(named, link, surfaces[link.name])],
            }
        ],
        "maniskill.json": _maniskill(asset, named, semantics),
        NAMES_FILE: named.to_data(),
    }
    return {
        "semantics.txt": "".join(" ".join(row) + "\n" for row in semantics).encode(),
        **{name: json_text(rounded(content)).encode() for name, content in data.items()},
    }


def _joints(named: Naming, link: Link) -> list[AssetJoint]:
    return [step.segment.joint for step in named.of_link(link.name)]


def _semantics(asset: Asset, named: Naming, link: Link) -> list[str]:
    joints = _joints(named, link)
    row = [named.body(link.name), kind_of(joints, asset.base), semantic(asset, link, joints)]
    return [word.replace(" ", "_") for word in row]


def _box(corners: Array) -> dict[str, list[float]]:
    """Return the box of two opposite corners, shape (2, 3) [m]."""
    corners = np.round(corners, 6) + 0.0
    return {"min": corners.min(axis=0).tolist(), "max": corners.max(axis=0).tolist()}


def _mobility(asset: Asset, named: Naming, link: Link) -> dict[str, Any]:
    """Describe a link and its joint, in degrees for hinges."""
    joints = _joints(named, link)
    kind = kind_of(joints, asset.base)
    moved = {"slider+": "slider", "static": "fixed" if joints else "static"}.get(kind, kind)
    return {
        "id": named.links[link.name],
        "parent": named.links[joints[0].parent] if joints else -1,
        "joint": moved,
        "name": semantic(asset, link, joints),
        "parts": [{"id": part.number, "name": part.name, "children": []} for part in named.parts[link.name]],
        "jointData": _joint_data(named, link, kind),
    }


def _joint_data(named: Naming, link: Link, kind: str) -> dict[str, Any]:
    steps = [step for step in named.of_link(link.name) if not step.segment.joint.locked]
    if not steps:
        return {}
    slides, turns = (
        [step for step in steps if step.segment.joint.kind == each] for each in ("prismatic", "revolute")
    )
    both = kind == "slider+"
    step = slides[-1] if both else steps[-1]
    degrees = math.degrees(1.0) if step in turns else 1.0
    low, high = step.limits or (0.0, 0.0)
    limit = {
        "a": low * degrees,
        "b": high * degrees,
        "noLimit": step.limits is None,
        "rotates": both,
        "noRotationLimit": both and turns[-1].limits is None,
        "rotationLimit": math.degrees(max(map(abs, turns[-1].limits or (0.0,)))) if both else 0.0,
    }
    origin = np.round(UPRIGHT @ step.segment.joint.pivot, 12) + 0.0
    direction = np.round(step.axis, 12) + 0.0
    return {"axis": {"origin": origin.tolist(), "direction": direction.tolist()}, "limit": limit}


def _parts(named: Naming, link: Link, paths: Sequence[str]) -> Iterator[dict[str, Any]]:
    for part in named.parts[link.name]:
        files = zip(link.surfaces, paths, strict=True)
        stems = [mesh_name(path) for surface, path in files if surface.label == part.label]
        yield {"text": part.name, "name": part.name, "id": part.number, "objs": stems}


def _maniskill(asset: Asset, named: Naming, semantics: Sequence[Sequence[str]]) -> dict[str, Any]:
    """Return the entry of a model in ManiSkill's `info_..._train.json`, with lengths in metres."""
    box = _box(asset.bounds() @ _FRONT.T)
    moved = [link for link in asset.links if kind_of(_joints(named, link)) not in ("static", "free")]
    held = [link for link in moved if any("handle" in part.name for part in named.parts[link.name])]
    return {
        "partnet_mobility_id": asset.name,
        "scale": 1.0,
        "num_target_links": len(held),
        "bbox": box,
        "offset": [-value + 0.0 for value in box["min"]],
        "semantics": semantics,
    }
