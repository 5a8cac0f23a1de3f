"""Layout `parts`: each asset of a room in files of its own, and a table of their places, `layout.json`.

    <room>/layout.json                       every asset with its category, seed, parameters, place and joints
    <room>/room/room.urdf                    floor and walls
    <room>/refrigerator/refrigerator.urdf    an asset, in coordinates of its own: its front faces -y
    <room>/refrigerator/meshes/...

Joints have the limits that are free in the room. Dependencies on joints of other assets are in `layout.json`
alone, as `needs` in the names of the room. An asset that is no room is the only one of its table.
"""

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from artgen import _portable
from artgen._names import ByName
from artgen.asset import Asset, AssetJoint
from artgen.asset.placed import PlacedAsset, certificate_digest, owners_of, place_of
from artgen.asset.record import json_text, plain, rounded
from artgen.export.frames import quaternion
from artgen.export.losses import Loss, Written

FORMAT = "artgen-layout-1"
"""Format of `layout.json`."""

_FILE = "layout.json"


def write_parts(asset: Asset, write: Callable[[Asset, int], Written], textures: int) -> Written:
    """Write each asset of a room by a writer, and the table of their places.

    Args:
        asset: A room, or any asset.
        write: Writer of the format.
        textures: Texels per side of the material maps; 0 for colors only.
    """
    files: dict[str, bytes] = {}
    lost: list[Loss] = []
    rows: list[dict[str, Any]] = []
    for placed, part, joints in parts_of(asset):
        written = write(part.rounded(), textures)
        files |= {f"{placed.name}/{path}": content for path, content in written.files.items()}
        lost += [replace(each, where=f"{placed.name}: {each.where}") for each in written.losses]
        rows.append(_row(placed, part, joints))
    head = {
        name: getattr(asset, name) for name in ("name", "category", "seed", "attempt", "version", "detail")
    }
    files[_FILE] = json_text({"format": FORMAT, **head, "assets": rows}).encode()
    return Written(files, tuple(lost), _FILE)


def _row(placed: PlacedAsset, part: Asset, joints: tuple[AssetJoint, ...]) -> dict[str, Any]:
    """Return the entry of an asset in the table."""
    data = placed.to_data()
    pose = np.array(data.pop("pose"))
    moving = [pair for pair in zip(part.joints, joints, strict=True) if not pair[0].locked]
    return data | {
        "folder": placed.name,
        "position": rounded(plain(pose[:3, 3] + 0.0)),
        "quaternion": rounded(plain(quaternion(pose) + 0.0)),  # w, x, y, z
        "joints": [
            {
                "name": own.name,
                "in_room": joint.name,
                "kind": joint.kind,
                "limits": rounded(plain(joint.limits)),
                "needs": None if joint.needs is None else rounded(joint.needs.to_data()),
            }
            for own, joint in moving
        ],
    }


def parts_of(asset: Asset) -> Iterator[tuple[PlacedAsset, Asset, tuple[AssetJoint, ...]]]:
    """Yield each asset of a room with its place, in its own coordinates, and its joints as the room has them.

    The first one is the room itself. Joints keep dependencies on joints of their own asset only.
    """
    if not asset.placed:
        digest = certificate_digest(asset.certificate)
        yield PlacedAsset.of(asset, asset.name, np.eye(4), digest=digest), asset, tuple(asset.joints)
        return
    owners, places = owners_of(asset), {place_of(each.name) for each in asset.placed}
    shell = replace(
        asset, name="room", links=ByName(asset.links[:1]), joints=ByName(()), contacts=(), loose=(), placed=()
    )
    room = replace(shell, category="room", seed=None, attempt=0, parameters={})
    yield PlacedAsset.of(room, "room", np.eye(4)), room, ()
    for placed in asset.placed:
        links = [link for link in asset.links if owners[link.name] == placed.name]
        joints = tuple(
            joint for joint in asset.joints if owners[joint.child] == placed.name and joint.name not in places
        )
        yield placed, _part(asset, placed, ByName(links), joints), joints


def _part(asset: Asset, placed: PlacedAsset, links: ByName[Any], joints: tuple[AssetJoint, ...]) -> Asset:
    """Return an asset of a room in its own coordinates and with its own names."""
    back, prefix = _portable.inverse(placed.pose), f"{placed.name}_"
    of_links = {link.name: link.name.removeprefix(prefix) for link in links}
    of_joints = {joint.name: joint.name.removeprefix(prefix) for joint in joints}
    own = []
    for joint in joints:
        foreign = joint.needs is not None and not set(joint.needs.condition.joints()) <= set(of_joints)
        moved = (replace(joint, needs=None) if foreign else joint).moved(back).renamed(of_joints)
        own.append(replace(moved, parent=of_links[joint.parent], child=of_links[joint.child]))
    return replace(
        asset,
        name=placed.name,
        category=placed.category,
        seed=placed.seed,
        attempt=placed.attempt,
        parameters=placed.parameters,
        links=ByName(
            link.moved(back).renamed(lambda name: name.removeprefix(prefix), of_joints) for link in links
        ),
        joints=ByName(own),
        base="free" if placed.free else "fixed",
        contacts=tuple(
            each.renamed(of_links, of_joints) for each in asset.contacts if set(each.links) <= set(of_links)
        ),
        loose=(),
        placed=(),
    )
