"""What COCO says of one picture: a mask for each part of each link that is seen, and how the link moves."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.asset.record import rounded


def annotations(
    surfaces: NDArray[np.int32], parts: list[tuple[str, str]], ids: Mapping[str, int]
) -> list[dict[str, Any]]:
    """Return an annotation for each visible part of each link, without the ids of a file."""
    from pycocotools import mask as coder

    wanted = list(dict.fromkeys(part for part in parts if part[1]))
    number_of = {part: number for number, part in enumerate(wanted, start=1)}
    table = np.array([0, *(number_of.get(part, 0) for part in parts)], np.int32)
    shown = np.asfortranarray(table[surfaces])
    areas = np.bincount(shown.ravel(order="K"), minlength=len(wanted) + 1)
    found = []
    for (link, name), number in number_of.items():
        if areas[number] == 0:
            continue
        code = coder.encode((shown == number).view(np.uint8))
        found.append(
            {
                "category_id": ids[name],
                "segmentation": {"size": code["size"], "counts": code["counts"].decode("ascii")},
                "area": int(areas[number]),
                "bbox": [float(each) for each in coder.toBbox(code)],
                "iscrowd": 0,
                "link": link,
            }
        )
    return found


def joints_of_links(
    asset: Asset, q: Mapping[str, float], extrinsics: Array
) -> dict[str, list[dict[str, Any]]]:
    """Return how each link moves against its parent, in camera coordinates; nothing for the base."""
    positions, poses = asset.positions(q), asset.pose(q)
    found: dict[str, list[dict[str, Any]]] = {asset.links[0].name: []}
    for parent, child, joints in asset.pairs():
        motion = extrinsics @ poses[parent]
        for joint in joints:
            found.setdefault(child, []).append(
                {
                    "name": joint.name,
                    "type": joint.kind,
                    "axis": rounded((motion[:3, :3] @ joint.axis).tolist()),
                    "origin": rounded((motion[:3, :3] @ joint.pivot + motion[:3, 3]).tolist()),
                    "value": rounded(positions[joint.name]),
                    "limits": None if joint.limits is None else rounded(list(joint.limits)),
                    "parent": parent,
                }
            )
            motion = motion @ joint.motion(positions[joint.name])
    return found
