"""Layout of user libraries of MolmoSpaces: objects with their metadata, and grasps of their joints.

    assets_index.json, grasps_index.json            the asset's place in a library of assets and one of grasps
    <asset>/<asset>.xml                             the object, with its meshes beside it
    <asset>/<asset>.json                            metadata: descriptions, WordNet synset, mass, bounding box
    <asset>/droid/joint_grasps_<joint>.npz          grasps that move a joint, in the frame of the joint's body
    <asset>/droid/grasps.npz                        grasps that move no joint, in the frame of the base

Paths in the indices are relative to them; a dataset has one of each for all of its assets. A grasp has z
along the approach, as in artgen, but the fingers open along y.
"""

import json
from collections.abc import Mapping
from io import BytesIO
from typing import Any

import numpy as np

from artgen import _portable
from artgen._arrays import Array
from artgen.asset import Asset
from artgen.asset.joint import joints_above
from artgen.asset.record import json_text, rounded
from artgen.export.frames import seen_box
from artgen.export.losses import Layout, Written, losses
from artgen.export.mjcf import write_mjcf
from artgen.materials import COLORS

ASSETS, GRASPS = "assets_index.json", "grasps_index.json"
"""Files that MolmoSpaces asks for in the folder of a library."""

_ROBOT = "droid"  # robot of MolmoSpaces' own grasps; all of its grippers have the same frame
_TURN = np.array([[0.0, 1.0, 0.0, 0.0], [-1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]])
# names of WordNet 3.0, each with the first word of its synset, those of MolmoSpaces' own types of objects
# where it has them
_SYNSETS: Mapping[str, str] = {
    "blender": "blender.n.01", "bottle": "bottle.n.01", "box": "carton.n.02", "bucket": "bucket.n.01",
    "cabinet": "cabinet.n.01", "camera": "camera.n.01", "cart": "handcart.n.01", "chair": "chair.n.01",
    "clock": "clock.n.01", "clothespin": "clothespin.n.01", "coffee_machine": "coffee_maker.n.01",
    "cooktop": "stove.n.01", "dishwasher": "dishwasher.n.01", "display": "display.n.06",
    "door": "door.n.01", "drawer": "drawer.n.01", "eyeglasses": "spectacles.n.01",
    "fan": "electric_fan.n.01", "faucet": "faucet.n.01", "globe": "globe.n.03", "grill": "grill.n.02",
    "handle": "handle.n.01", "kettle": "kettle.n.01", "keyboard": "computer_keyboard.n.01",
    "knife": "knife.n.01", "lamp": "lamp.n.02", "laptop": "laptop.n.01", "lighter": "lighter.n.02",
    "microwave": "microwave.n.02", "mouse": "mouse.n.04", "oven": "oven.n.01", "pen": "pen.n.01",
    "pepper_grinder": "pepper_mill.n.01", "phone": "telephone.n.01", "plier": "pliers.n.01",
    "pot": "pot.n.01", "printer": "printer.n.03", "range_hood": "range_hood.n.01",
    "refrigerator": "refrigerator.n.01", "remote": "remote_control.n.01", "rice_cooker": "cooker.n.01",
    "safe": "safe.n.01", "scissors": "scissors.n.01", "shower": "shower_stall.n.01", "sink": "sink.n.01",
    "soap_dispenser": "soap_dispenser.n.01", "stand_mixer": "electric_mixer.n.01",
    "stapler": "stapler.n.01", "suitcase": "bag.n.06", "switch": "switch.n.01", "syringe": "syringe.n.01",
    "table": "table.n.02", "toaster": "toaster.n.02", "toaster_oven": "toaster_oven.n.01",
    "toilet": "toilet.n.02", "trashcan": "ashcan.n.01", "usb_stick": "flash_memory.n.01",
    "valve": "valve.n.03", "washing_machine": "washer.n.03", "window": "window.n.01",
}  # fmt: skip


def write_molmospaces(asset: Asset, name: str, textures: int) -> Written:
    """Write an asset as an object of a user library of MolmoSpaces; see `Layout.write`."""
    assert name == "mjcf"
    written = write_mjcf(asset, textures)
    uid = asset.name
    files = {f"{uid}/{path}": content for path, content in written.files.items()}
    files[f"{uid}/{uid}.json"] = json_text(_metadata(asset)).encode()
    joint_grasps, base_grasps = _grasps(asset)
    paths = {joint: f"{uid}/{_ROBOT}/joint_grasps_{joint}.npz" for joint in joint_grasps}
    files |= {path: _packed(joint_grasps[joint]) for joint, path in paths.items()}
    rigid = {uid: f"{uid}/{_ROBOT}/grasps.npz"} if base_grasps else {}
    files |= {path: _packed(base_grasps) for path in rigid.values()}
    entry = {
        "uid": uid,
        "object_path": f"{uid}/{uid}.xml",
        "metadata_path": f"{uid}/{uid}.json",
        "metadata_npz_path": None,
    }
    grasps = {
        "articulated_grasp_paths": {_ROBOT: {uid: paths} if paths else {}},
        "grasp_paths": {_ROBOT: rigid},
    }
    files |= {ASSETS: json_text({uid: entry}).encode(), GRASPS: json_text(grasps).encode()}
    held = {each.name for each in asset.affordances if each.kind == "grasp"}
    kept = {each for each, _ in _sorted_grasps(asset)}
    own = losses(
        ("loose link", asset.loose, "a body of the world, which the samplers of MolmoSpaces leave behind"),
        ("grasp of MolmoSpaces", sorted(held - kept), "a site of the MJCF: it is not within reach at rest"),
    )
    return Written(files, (*written.losses, *own), f"{uid}/{uid}.xml")


def library(indices: Mapping[str, bytes]) -> dict[str, bytes]:
    """Return the indices of a dataset from those of its assets, by their paths in the dataset."""
    assets: dict[str, Any] = {}
    grasps: dict[str, dict[str, Any]] = {"articulated_grasp_paths": {_ROBOT: {}}, "grasp_paths": {_ROBOT: {}}}
    for path, content in sorted(indices.items()):
        folder, _, kind = path.rpartition("/")
        data = _placed(json.loads(content), folder)
        if kind == ASSETS:
            assets |= data
        else:
            for name, found in grasps.items():
                found[_ROBOT] |= data[name][_ROBOT]
    return {ASSETS: json_text(assets).encode(), GRASPS: json_text(grasps).encode()}


def _placed(data: Any, folder: str, name: str = "") -> Any:
    """Return an index with its paths in another folder; the name of an asset is no path."""
    if isinstance(data, dict):
        return {key: _placed(value, folder, key) for key, value in data.items()}
    return data if data is None or name == "uid" else f"{folder}/{data}"


def _metadata(asset: Asset) -> dict[str, Any]:
    """Return what the object metadata of MolmoSpaces holds; its boxes are centered at the origin."""
    noun = asset.category.replace("_", " ")
    words = asset.links[0].surfaces[0].material.name.split("_") if asset.links[0].surfaces else []
    seen = next((f"{word} {noun}" for word in words if word in COLORS), noun)  # "white drawer"
    moving = [joint.child.replace("_", " ") for joint in asset.free_joints]
    parts = f" Its moving parts: {', '.join(dict.fromkeys(moving))}." if moving else ""
    size = 2.0 * np.abs(seen_box(asset)).max(axis=0)
    data = {
        "assetId": asset.name,
        "category": noun,
        "description": f"A {seen}.",
        "description_long": f"A {seen}.{parts}",
        "description_short": {"one_word": noun, "two_words": seen, "three_words": seen},
        "mass": rounded(asset.mass),
        "boundingBox": dict(zip("xyz", rounded(size.tolist()), strict=True)),
        "isObjaverse": False,
        "primaryProperty": "Static",
        "receptacle": False,
        "split": "train",
    }
    return data | ({"synset": _SYNSETS[asset.category]} if asset.category in _SYNSETS else {})


def _grasps(asset: Asset) -> tuple[dict[str, list[Array]], list[Array]]:
    """Return the grasps of each joint and those of the base, shape (4, 4) each [m]."""
    joints: dict[str, list[Array]] = {}
    base: list[Array] = []
    frames = {each.name: each for each in asset.affordances}
    for name, joint in _sorted_grasps(asset):
        link = asset.joint(joint).child if joint else asset.links[0].name
        frame = _portable.product(frames[name].frame, _TURN)
        frame[:3, 3] -= asset.origin(link)
        (joints.setdefault(joint, []) if joint else base).append(frame)
    return joints, base


def _sorted_grasps(asset: Asset) -> list[tuple[str, str]]:
    """Return the name of each grasp within reach at rest, and the joint that carries its link, or nothing."""
    closed = asset.positions()
    found = []
    for each in asset.affordances:
        above = [joint for joint in joints_above(asset.joints, each.link) if not joint.locked]
        nearest = above[0].name if above else ""
        own = nearest == (each.joints[0] if each.joints else "")
        if each.kind == "grasp" and own and (each.when is None or each.when.holds(closed)):
            found.append((each.name, nearest))
    return found


def _packed(frames: list[Array]) -> bytes:
    content = BytesIO()
    np.savez(content, transforms=np.stack(frames))
    return content.getvalue()


MOLMOSPACES = Layout(
    "molmospaces",
    "object of a user library of MolmoSpaces, with grasps of its joints",
    ("mjcf",),
    ("mjcf",),
    write_molmospaces,
    (ASSETS, GRASPS),
    library,
)
"""One object in a folder of its own, and the indices of a library."""
