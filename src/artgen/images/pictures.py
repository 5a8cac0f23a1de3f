"""Pictures of one asset with their annotations, and the COCO files of a set."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from io import BytesIO
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.asset.files import ASSET_FILE
from artgen.asset.placed import owners_of, place_of
from artgen.asset.record import json_text, rounded
from artgen.dataset.places import Place
from artgen.dataset.plan import Item
from artgen.images.draws import (
    CLEAR,
    Setting,
    Surroundings,
    camera_in,
    extrinsics,
    intrinsics,
    random_positions,
    random_setting,
    random_surroundings,
)
from artgen.materials import material as find_material
from artgen.sampling.distributions import stream
from artgen.version import __version__
from artgen.view.camera import Camera
from artgen.view.raster import Renderer
from artgen.view.scene import HALF, HIDDEN_GROUP, SKY, STUDIO_GROUP, RenderScene, SceneBuilder
from artgen.view.studio import ribbon
from artgen.view.tracing import cast

if TYPE_CHECKING:
    from artgen.images.plan import ImagePlan

PARTS = ("train", "val", "test")  # of a set; each has a COCO file
ANNOTATION_FILE = "annotations.json"  # of the pictures of one asset; the COCO files are made from them

_BATCH = 64  # number of assets that are read at once
_SKY_TEXELS = 32
_WIDE = 40.0  # half the size of floors and walls, over the radius of the asset
_NEARER = 0.15  # nearest depth with a floor, over that of the asset alone
_SHADOW_TEXELS = {False: 1024, True: 2048}  # samples of small and of large pictures
_ROOM_SHADOWS = 4096  # samples in pictures of rooms, whose shadows are as large as the room
_LARGE = 640  # least size of large pictures [pixels]
_TILES = 6  # faces of the sky: right, left, up, down, front, back
_PNG_LEVEL = 1  # compression: higher levels take longer and save little
_JPEG_QUALITY = 95
_MOST = 65535  # largest number of 16 bits


class ImageScene(RenderScene):
    """A scene with floors and walls, whose floor is visible in front of the asset."""

    def __init__(self, asset: Asset, around: Surroundings, texels: int, *, large: bool) -> None:
        self._around = around
        self._large = large  # whether pictures are large, with finer shadows
        super().__init__(asset, "none", texels)

    def add_surroundings(self, builder: SceneBuilder, texels: int) -> None:
        """Add the floors and walls, and a larger sky."""
        spec = builder.spec
        sky = spec.texture(SKY)
        sky.width, sky.height = _SKY_TEXELS, _TILES * _SKY_TEXELS
        spec.visual.quality.shadowsize = _ROOM_SHADOWS if self.asset.placed else _SHADOW_TEXELS[self._large]
        wide = _WIDE * self.place.radius
        lying, standing = np.array([0.0, 0.0, 1.0]), np.array([0.0, -1.0, 0.0])
        level = ribbon(
            np.array([[-wide, 0.0], [wide, 0.0]]), np.array([lying, lying]), np.array([-wide, wide])
        )
        upright = ribbon(
            np.array([[0.0, -wide], [0.0, wide]]), np.array([standing, standing]), np.array([-wide, wide])
        )
        for kind, mesh in (("floor", level), ("wall", upright)):
            for number, name in enumerate(self._around[kind]):
                # its own name separates its tint from that of the asset
                made = replace(find_material(name), name=f"{kind}_{name}")
                body = spec.worldbody.add_body(name=f"{kind}_{number}", mocap=True)
                builder.add_surroundings(body, f"{kind}_{number}", mesh, made, texels)

    def depth_range(self, camera: Camera, poses: list[Array]) -> tuple[float, float]:
        """Return the nearest and farthest visible depth along the axis of a camera [m]."""
        near, far = super().depth_range(camera, poses)
        return max(_NEARER * near, 0.5 * CLEAR if self.asset.placed else 0.0), far


class ImageRenderer(Renderer):
    """Renders one asset in changing settings; `close` frees the graphics memory."""

    def __init__(self, asset: Asset, around: Surroundings, textures: int, size: int) -> None:
        super().__init__(ImageScene(asset, around, textures, large=size >= _LARGE), (size, size))
        self._size_of_picture = (size, size)
        self._setting: Setting  # of the current picture
        self._boards = {
            kind: [self._board(f"{kind}_{number}") for number in range(len(names))]
            for kind, names in around.items()
        }

    def _board(self, name: str) -> tuple[int, int, int, Array]:
        """Return the indices of geom, mocap body and material of a floor or wall, and its color."""
        model = self.scene.model
        geom = int(model.geom(name).id)
        material = int(model.geom_matid[geom])
        return geom, int(model.body(name).mocapid[0]), material, model.mat_rgba[material].copy()

    def take(
        self, shot: "Shot", points: Array, samples: int
    ) -> tuple[NDArray[np.uint8], NDArray[np.int32], Array]:
        """Return colors, the surface of each pixel, and depths; `points` are the vertices of all links."""
        self._setting = shot.setting
        studio = self.scene.place.turned(shot.camera)
        self._furnish(points @ studio[:3, :3].T + studio[:3, 3])
        placed, moved = self.scene.placed(shot.camera, shot.poses)
        color = self.color(placed, moved, self._size_of_picture, samples)
        return color, *self.surfaces(placed, moved, self._size_of_picture)

    def _furnish(self, points: Array) -> None:
        """Put sky, floor and wall around an asset with given vertices, in studio coordinates."""
        setting, place = self._setting, self.scene.place
        self._paint_sky()
        floor = min(place.floor, float(points[:, 2].min()) - 1e-4 * place.radius)
        self._stand("floor", setting.floor, setting.floor_turn, (0.0, 0.0, floor), setting.floor_tint)
        turn = setting.wall_turn
        away = np.array([-np.sin(turn), np.cos(turn), 0.0])
        reach = max(float((points @ away).max()) + 0.01, float(place.center @ away))
        at = (reach + setting.wall_distance * place.radius) * away
        self._stand("wall", setting.wall, turn, (float(at[0]), float(at[1]), floor), setting.wall_tint)

    def _stand(self, kind: str, chosen: int, turn: float, at: Any, tint: Any) -> None:
        """Show one of the floors or walls, and hide the others."""
        model, data = self.scene.model, self.scene.data
        for number, (geom, mocap, material, color) in enumerate(self._boards[kind]):
            model.geom_group[geom] = STUDIO_GROUP if number == chosen else HIDDEN_GROUP
            if number == chosen:
                data.mocap_pos[mocap] = at
                data.mocap_quat[mocap] = (np.cos(turn / 2.0), 0.0, 0.0, np.sin(turn / 2.0))
                model.mat_rgba[material] = color * (*tint, 1.0)

    def _paint_sky(self) -> None:
        """Paint the sky with a gradient from horizon to zenith."""
        import mujoco

        setting, model = self._setting, self.scene.model
        horizon, zenith = np.array(setting.horizon), np.array(setting.zenith)
        rise = np.clip(np.linspace(2.0, 0.0, _SKY_TEXELS) - 1.0, 0.0, 1.0)[:, None, None]
        side = np.broadcast_to(horizon + rise * (zenith - horizon), (_SKY_TEXELS, _SKY_TEXELS, 3))
        above, below = (np.broadcast_to(each, side.shape) for each in (zenith, horizon))
        faces = np.concatenate([side, side, above, below, side, side])
        number = model.texture(SKY).id
        first = int(model.tex_adr[number])
        pixels = np.rint(255.0 * HALF * faces).astype(np.uint8).ravel()
        model.tex_data[first : first + pixels.size] = pixels
        self._gl.make_current()
        mujoco.mjr_uploadTexture(model, self._context, number)

    def _light(self, places: list[float], focus: Array) -> None:
        """Place the lamp at one of its points, and the ambient light, which is stronger from above."""
        light, place = self._setting.light, self.scene.place
        dim, color = HALF, np.array(light.color)
        lamps = (
            (light.direction((places[0], places[1])), 1.15 * light.directional * color),
            (np.array([0.0, -0.3, 0.954]), 0.55 * light.ambient * np.ones(3)),  # above
            (np.array([0.15, -0.984, 0.1]), 0.35 * light.ambient * np.ones(3)),  # in front
            (np.array([0.0, 0.0, -1.0]), 0.12 * light.ambient * np.ones(3)),  # below
        )
        for number, (lamp, (direction, strength)) in enumerate(zip(self._view.lights, lamps, strict=False)):
            lamp.dir = -direction
            lamp.pos = focus + 4.0 * place.radius * direction
            lamp.diffuse = strength * dim
            # a lamp that casts shadows has no ambient light in them
            lamp.ambient = [0.55 * light.ambient * dim if number == 1 else 0.0] * 3
            lamp.castshadow = number == 0
            lamp.specular = [0.0] * 3


def _encoded(pixels: NDArray[Any], form: str = "png") -> bytes:
    """Return pixels as PNG or JPEG."""
    from PIL import Image

    options = {"compress_level": _PNG_LEVEL} if form == "png" else {"quality": _JPEG_QUALITY}
    content = BytesIO()
    Image.fromarray(pixels).save(content, "PNG" if form == "png" else "JPEG", **options)
    return content.getvalue()


@dataclass(frozen=True, eq=False)
class Shot:
    """The random numbers of one picture."""

    name: str  # stem of its files
    q: Mapping[str, float]  # positions of the free joints [rad or m]
    poses: Mapping[str, Array]  # displacement of each link from rest, shape (4, 4)
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
            draw = stream(item.seed, f"{item.category}/images/{number}")
            q = random_positions(asset, draw)
            poses = asset.pose(q)
            points = {
                link.name: np.concatenate([surface.mesh.vertices for surface in link.surfaces])
                @ poses[link.name][:3, :3].T
                + poses[link.name][:3, 3]
                for link in asset.links
                if link.surfaces
            }
            camera = camera_in(asset, poses, points, plan, draw)
            setting = random_setting(around, plan.random, draw, room=bool(asset.placed))
            shot = Shot(f"{number:02d}", q, poses, camera, setting)
            color, surfaces, depth = renderer.take(shot, np.concatenate(list(points.values())), plan.samples)
            written, data = _annotated(asset, item, plan, shot, surfaces, depth)
            files |= {f"{shot.name}.{plan.picture}": _encoded(color, plan.picture)} | written
            found.append(data)
    finally:
        renderer.close()
    files[ANNOTATION_FILE] = json_text({"images": found}).encode()
    files[ASSET_FILE] = json_text(asset.to_data() | {"formats": {}}).encode()
    return files


def _annotated(
    asset: Asset, item: Item, plan: "ImagePlan", shot: Shot, surfaces: NDArray[np.int32], depth: Array
) -> tuple[dict[str, bytes], dict[str, Any]]:
    """Return the files of depth and normals requested by the plan, and the data of a picture."""
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
        name = f"{shot.name}_depth.png"  # 16 bits, 0 for nothing
        seen = np.isfinite(depth)
        scale = float(depth[seen].max()) / _MOST if seen.any() else 1.0
        files[name] = _encoded(np.rint(np.where(seen, depth, 0.0) / scale).astype(np.uint16))
        data["depth_scale"] = scale  # depth of one step [m]
        data["depth_file"] = f"{item.path}/{name}"
    if plan.normals:
        name = f"{shot.name}_normals.png"  # 127.5 + 127.5 n, black for nothing
        meshes = [surface.mesh.moved(shot.poses[link]) for link, surface in shown]
        rays = shot.camera.rays((plan.size, plan.size))
        normals = cast(meshes, np.array(shot.camera.position), rays).normals @ matrix[:3, :3].T
        hit = np.abs(normals).sum(axis=-1, keepdims=True) > 0.0
        pixels = np.where(hit, np.rint(127.5 + 127.5 * normals), 0.0).astype(np.uint8)
        files[name] = _encoded(pixels.reshape(plan.size, plan.size, 3))
        data["normals_file"] = f"{item.path}/{name}"
    names, owner = plan.mask_names()[asset.category], asset.category
    ids = {each["name"]: each["id"] for each in plan.coco_categories() if each["supercategory"] == owner}
    moves = _joints_of_links(asset, shot.q, matrix)
    masks = _coded(surfaces, [(link, names.get(surface.label, "")) for link, surface in shown], ids)
    owners = {link: {"placed": owner} for link, owner in owners_of(asset).items()} if asset.placed else {}
    found = [each | {"joints": moves[each["link"]]} | owners.get(each["link"], {}) for each in masks]
    return files, data | {"annotations": found}


def _coded(
    surfaces: NDArray[np.int32], parts: list[tuple[str, str]], ids: Mapping[str, int]
) -> list[dict[str, Any]]:
    """Return the COCO annotation of each visible part of each link, without file-specific ids."""
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
    """Return the joints between each link and its parent, in camera coordinates; none for bases."""
    positions, poses = asset.positions(q), asset.pose(q)
    places = {place_of(each.name) for each in asset.placed}
    found: dict[str, list[dict[str, Any]]] = {asset.links[0].name: []}
    for parent, child, joints in asset.pairs():
        motion = extrinsics @ poses[parent]
        for joint in joints:
            known = found.setdefault(child, [])
            if joint.name in places:
                continue
            known.append(
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


def write_coco(place: Place, records: Sequence[Mapping[str, Any]], plan: "ImagePlan") -> None:
    """Write `train.json`, `val.json` and `test.json`; a longer plan keeps the ids of a shorter one."""
    part_of_seed = split_of(plan.seed, -(-plan.count // len(plan.categories)), plan.split)
    images: dict[str, list[dict[str, Any]]] = {part: [] for part in PARTS}
    masks: dict[str, list[dict[str, Any]]] = {part: [] for part in PARTS}
    done = [(number, record) for number, record in enumerate(records) if record["state"] == "done"]
    mask_id = 0
    for start in range(0, len(done), _BATCH):
        some = done[start : start + _BATCH]
        texts = place.contents(f"{record['path']}/{ANNOTATION_FILE}" for _, record in some)
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
            "categories": plan.coco_categories(),
            "images": images[part],
            "annotations": masks[part],
        }
        place.write(f"{part}.json", json.dumps(data, allow_nan=False, ensure_ascii=False).encode())


def split_of(first: int, count: int, shares: Sequence[float]) -> Mapping[int, str]:
    """Return the part of each seed, the same for all categories.

    Assets with the same seed share draws, such as materials, even across categories; so seeds are divided. A
    seed stays in its part when the set grows, and the parts match the shares for any number of seeds.
    """
    taken = [0] * len(PARTS)
    found = {}
    for number in range(count):
        behind = [share * (number + 1) - had for share, had in zip(shares, taken, strict=True)]
        part = max(range(len(PARTS)), key=lambda each: round(behind[each], 9))
        taken[part] += 1
        found[first + number] = PARTS[part]
    return found
