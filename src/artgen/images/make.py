"""The pictures of one asset, taken in a process of its own."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.asset.files import ASSET_FILE
from artgen.asset.record import json_text, rounded
from artgen.dataset.make import Made, put
from artgen.dataset.plan import Item
from artgen.dataset.target import Target
from artgen.images.annotations import annotations, joints_of_links
from artgen.images.cameras import extrinsics, intrinsics, random_camera
from artgen.images.encoding import encoded_color, encoded_depth, encoded_normals
from artgen.images.lighting import Setting, Surroundings, random_setting, random_surroundings
from artgen.images.plan import ImagePlan
from artgen.images.poses import random_positions
from artgen.images.renderer import ImageRenderer
from artgen.sampling.streams import stream
from artgen.view.camera import Camera
from artgen.view.rays import cast

ANNOTATION_FILE = "annotations.json"
"""What is known of the pictures of one asset, in its directory; files of COCO are made of these."""


def make(item: Item, *, plan: ImagePlan, target: Target) -> Made:
    """Take the pictures of an asset and put them in its place."""
    return put(item, lambda: _files(item, plan), target, share=False)


@dataclass(frozen=True, eq=False)
class Shot:
    """What is drawn for one picture."""

    name: str  # of its files, without a suffix
    q: Mapping[str, float]  # positions of the free joints [rad or m]
    poses: Mapping[str, Array]  # how each link is displaced from rest, shape (4, 4)
    points: Array  # the vertices of all links, in asset coordinates, shape (n, 3) [m]
    camera: Camera  # where it is taken from
    setting: Setting  # what is around the asset


def _files(item: Item, plan: ImagePlan) -> dict[str, bytes]:
    """Return the pictures of an asset, what is known of them, and its `asset.json`."""
    asset = plan.draw(item)
    around = random_surroundings(plan.random, stream(item.seed, f"{item.category}/images"))
    files: dict[str, bytes] = {}
    told = []
    renderer = ImageRenderer(asset, around, plan.texture_size, plan.size)
    try:
        for number in range(plan.images):
            shot = _shot(asset, item, plan, around, number)
            color, surfaces, depth = renderer.take(
                shot.camera, shot.poses, shot.points, shot.setting, plan.samples
            )
            written, layers = _layers(asset, item, plan, shot, depth)
            files |= {f"{shot.name}.{plan.picture}": encoded_color(color, plan.picture)} | written
            told.append(_record(asset, item, plan, shot) | layers | _masks(asset, plan, shot, surfaces))
    finally:
        renderer.close()
    files[ANNOTATION_FILE] = json_text({"images": told}).encode()
    files[ASSET_FILE] = json_text(asset.to_data() | {"formats": {}}).encode()
    return files


def _shot(asset: Asset, item: Item, plan: ImagePlan, around: Surroundings, number: int) -> Shot:
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


def _record(asset: Asset, item: Item, plan: ImagePlan, shot: Shot) -> dict[str, Any]:
    """Return what is known of a picture, apart from its masks."""
    return {
        "width": plan.size,
        "height": plan.size,
        "file_name": f"{item.path}/{shot.name}.{plan.picture}",
        "asset": item.name,
        "category": item.category,
        "seed": item.seed,
        "intrinsics": rounded(intrinsics(shot.camera, plan.size).tolist()),
        "extrinsics": rounded(extrinsics(shot.camera).tolist()),
        "joints": rounded(asset.positions(shot.q)),
        "light": rounded(shot.setting.light.to_data()),
    }


def _layers(
    asset: Asset, item: Item, plan: ImagePlan, shot: Shot, depth: Array
) -> tuple[dict[str, bytes], dict[str, Any]]:
    """Return the files of depth and normals, and what is known of them, as far as they are wanted."""
    files: dict[str, bytes] = {}
    told: dict[str, Any] = {}
    if plan.depth:
        name = f"{shot.name}_depth.png"
        files[name], told["depth_scale"] = encoded_depth(depth)
        told["depth_file"] = f"{item.path}/{name}"
    if plan.normals:
        name = f"{shot.name}_normals.png"
        meshes = [
            surface.mesh.moved(shot.poses[link.name]) for link in asset.links for surface in link.surfaces
        ]
        rays = shot.camera.rays((plan.size, plan.size))
        found = cast(meshes, np.array(shot.camera.position), rays).normals
        turned = found @ extrinsics(shot.camera)[:3, :3].T
        files[name] = encoded_normals(turned.reshape(plan.size, plan.size, 3))
        told["normals_file"] = f"{item.path}/{name}"
    return files, told


def _masks(asset: Asset, plan: ImagePlan, shot: Shot, surfaces: NDArray[np.int32]) -> dict[str, Any]:
    """Return the annotations of a picture."""
    vocabulary = plan.vocabulary()
    names = vocabulary.names[asset.category]
    ids = {name: vocabulary.ids()[asset.category, name] for name in names.values()}
    parts = [(link.name, names.get(surface.label, "")) for link in asset.links for surface in link.surfaces]
    moves = joints_of_links(asset, shot.q, extrinsics(shot.camera))
    found = annotations(surfaces, parts, ids)
    return {"annotations": [each | {"joints": moves[each["link"]]} for each in found]}
