"""The pictures of one asset with their annotations, and the COCO files of a set."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from artgen.asset import Asset
from artgen.asset.files import ASSET_FILE
from artgen.asset.record import json_text, rounded
from artgen.dataset.plan import Item
from artgen.dataset.store import Target
from artgen.images.draws import (
    Setting,
    Surroundings,
    extrinsics,
    intrinsics,
    random_camera,
    random_positions,
    random_setting,
    random_surroundings,
)
from artgen.images.renderer import ImageRenderer, encoded_color, encoded_depth, encoded_normals
from artgen.sampling.streams import stream
from artgen.version import __version__
from artgen.view.camera import Camera
from artgen.view.rays import cast

if TYPE_CHECKING:
    from artgen.images.plan import ImagePlan

Array = NDArray[np.float64]

PARTS = ("train", "val", "test")
"""Names of the parts of a set, and of their COCO files."""

_BATCH = 64  # number of assets that are read at once

ANNOTATION_FILE = "annotations.json"
"""The annotations of the pictures of one asset, in its directory; the COCO files are made of these."""


@dataclass(frozen=True, eq=False)
class Shot:
    """The random numbers of one picture."""

    name: str  # stem of its files
    q: Mapping[str, float]  # positions of the free joints [rad or m]
    poses: Mapping[str, Array]  # displacement of each link from rest, shape (4, 4)
    points: Array  # the vertices of all links, in asset coordinates, shape (n, 3) [m]
    camera: Camera
    setting: Setting


def pictures_of(item: Item, plan: "ImagePlan") -> dict[str, bytes]:
    """Return the pictures of an asset, their annotations, and its `asset.json`."""
    asset = plan.draw(item)
    around = random_surroundings(plan.random, stream(item.seed, f"{item.category}/images"))
    files: dict[str, bytes] = {}
    found = []
    renderer = ImageRenderer(asset, around, plan.texture_size, plan.size)
    try:
        for number in range(plan.images):
            shot = _shot(asset, item, plan, around, number)
            color, surfaces, depth = renderer.take(
                shot.camera, shot.poses, shot.points, shot.setting, plan.samples
            )
            written, data = _annotated(asset, item, plan, shot, surfaces, depth)
            files |= {f"{shot.name}.{plan.picture}": encoded_color(color, plan.picture)} | written
            found.append(data)
    finally:
        renderer.close()
    files[ANNOTATION_FILE] = json_text({"images": found}).encode()
    files[ASSET_FILE] = json_text(asset.to_data() | {"formats": {}}).encode()
    return files


def _shot(asset: Asset, item: Item, plan: "ImagePlan", around: Surroundings, number: int) -> Shot:
    """Draw one picture's pose, camera and setting."""
    draw = stream(item.seed, f"{item.category}/images/{number}")
    q = random_positions(asset, draw)
    poses = asset.pose(q)
    seen = [
        surface.mesh.vertices @ poses[link.name][:3, :3].T + poses[link.name][:3, 3]
        for link in asset.links
        for surface in link.surfaces
    ]
    points = np.concatenate(seen)
    camera = random_camera(
        points,
        draw,
        field_of_view=plan.field_of_view,
        elevation=plan.elevation,
        azimuth=plan.azimuth,
        margin=plan.margin,
    )
    return Shot(f"{number:02d}", q, poses, points, camera, random_setting(around, plan.random, draw))


def _annotated(
    asset: Asset, item: Item, plan: "ImagePlan", shot: Shot, surfaces: NDArray[np.int32], depth: Array
) -> tuple[dict[str, bytes], dict[str, Any]]:
    """Return the files of depth and normals, as far as the plan has them, and the data of a picture."""
    files: dict[str, bytes] = {}
    matrix = extrinsics(shot.camera)
    data: dict[str, Any] = {
        "width": plan.size,
        "height": plan.size,
        "file_name": f"{item.path}/{shot.name}.{plan.picture}",
        "asset": item.name,
        "category": item.category,
        "seed": item.seed,
        "intrinsics": rounded(intrinsics(shot.camera, plan.size).tolist()),
        "extrinsics": rounded(matrix.tolist()),
        "joints": rounded(asset.positions(shot.q)),
        "light": rounded(shot.setting.light.to_data()),
    }
    shown = [(link.name, surface) for link in asset.links for surface in link.surfaces]
    if plan.depth:
        name = f"{shot.name}_depth.png"
        files[name], data["depth_scale"] = encoded_depth(depth)
        data["depth_file"] = f"{item.path}/{name}"
    if plan.normals:
        name = f"{shot.name}_normals.png"
        meshes = [surface.mesh.moved(shot.poses[link]) for link, surface in shown]
        rays = shot.camera.rays((plan.size, plan.size))
        normals = cast(meshes, np.array(shot.camera.position), rays).normals @ matrix[:3, :3].T
        files[name] = encoded_normals(normals.reshape(plan.size, plan.size, 3))
        data["normals_file"] = f"{item.path}/{name}"
    vocabulary = plan.vocabulary()
    names = vocabulary.names[asset.category]
    ids = {name: vocabulary.ids()[asset.category, name] for name in names.values()}
    moves = _joints_of_links(asset, shot.q, matrix)
    masks = _coded(surfaces, [(link, names.get(surface.label, "")) for link, surface in shown], ids)
    return files, data | {"annotations": [each | {"joints": moves[each["link"]]} for each in masks]}


def _coded(
    surfaces: NDArray[np.int32], parts: list[tuple[str, str]], ids: Mapping[str, int]
) -> list[dict[str, Any]]:
    """Return the COCO annotation of each visible part of each link, without the ids of a file."""
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


def _joints_of_links(
    asset: Asset, q: Mapping[str, float], extrinsics: Array
) -> dict[str, list[dict[str, Any]]]:
    """Return the joints between each link and its parent, in camera coordinates; none for the base."""
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


def write_coco(target: Target, records: Sequence[Mapping[str, Any]], plan: "ImagePlan") -> None:
    """Write `train.json`, `val.json` and `test.json`; a longer plan keeps the ids of a shorter one."""
    part_of_seed = split_of(plan.seed, -(-plan.count // len(plan.categories)), plan.split)
    images: dict[str, list[dict[str, Any]]] = {part: [] for part in PARTS}
    masks: dict[str, list[dict[str, Any]]] = {part: [] for part in PARTS}
    done = [(number, record) for number, record in enumerate(records) if record["state"] == "done"]
    mask_id = 0
    for start in range(0, len(done), _BATCH):
        some = done[start : start + _BATCH]
        texts = target.contents(f"{record['path']}/{ANNOTATION_FILE}" for _, record in some)
        for number, record in some:
            part = part_of_seed[record["seed"]]
            data = json.loads(texts[f"{record['path']}/{ANNOTATION_FILE}"])
            for index, image in enumerate(data["images"]):
                of_image = image.pop("annotations")
                image_id = number * plan.images + index + 1
                images[part].append({"id": image_id, **image})
                for mask in of_image:
                    mask_id += 1
                    masks[part].append({"id": mask_id, "image_id": image_id, **mask})
    for part in PARTS:
        data = {
            "info": {
                "description": f"{part} images of {', '.join(plan.categories)}",
                "version": f"artgen {__version__}",
                "plan": plan.to_data(),
            },
            "licenses": [],
            "categories": plan.vocabulary().categories(),
            "images": images[part],
            "annotations": masks[part],
        }
        target.write(f"{part}.json", json.dumps(data, allow_nan=False, ensure_ascii=False).encode())


def split_of(first: int, count: int, shares: Sequence[float]) -> Mapping[int, str]:
    """Return the part of each seed, the same for all categories.

    Assets of one seed share draws, such as materials, even across categories: so seeds are divided. A seed
    stays in its part when the set grows, and every part has its share of any number of seeds.
    """
    taken = [0] * len(PARTS)
    found = {}
    for number in range(count):
        behind = [share * (number + 1) - had for share, had in zip(shares, taken, strict=True)]
        part = max(range(len(PARTS)), key=lambda each: round(behind[each], 9))
        taken[part] += 1
        found[first + number] = PARTS[part]
    return found
