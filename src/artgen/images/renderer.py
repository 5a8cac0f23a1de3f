"""Many pictures of one asset with the classic renderer of MuJoCo, and their encoding as files."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from io import BytesIO
from typing import Any

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.images.draws import Setting, Surroundings
from artgen.materials import material
from artgen.view.camera import Camera
from artgen.view.classic import HALF, SKY, ClassicDress, ClassicRenderer
from artgen.view.scene import HIDDEN_GROUP, STUDIO_GROUP, Scene, add_geom
from artgen.view.studio import Backdrop, ribbon

_SKY_TEXELS = 32
_WIDE = 40.0  # half the size of floors and walls, over the radius of the asset
_NEARER = 0.15  # nearest depth with a floor, over that of the asset alone
_SHADOW_TEXELS = {False: 1024, True: 2048}  # of small and of large pictures
_LARGE = 640  # least size of large pictures [pixels]
_TILES = 6  # faces of the sky: right, left, up, down, front, back
_PNG_LEVEL = 1  # compression: higher levels take longer and save little
_JPEG_QUALITY = 95
_MOST = 65535  # largest number of 16 bits


@dataclass
class ImageDress(ClassicDress):
    """Adds floors and walls to the materials of other pictures."""

    around: Surroundings = field(default_factory=Surroundings)
    textures_around: int = 0  # texels on a side of the maps of floors and walls
    large: bool = True  # whether pictures are large, with finer shadows

    def surroundings(self, spec: Any, place: Backdrop) -> None:
        """Add lights, the sky, floors and walls to a specification."""
        super().surroundings(spec, place)
        sky = spec.texture(SKY)
        sky.width, sky.height = _SKY_TEXELS, _TILES * _SKY_TEXELS
        spec.visual.quality.shadowsize = _SHADOW_TEXELS[self.large]
        wide = _WIDE * place.radius
        lying, standing = np.array([0.0, 0.0, 1.0]), np.array([0.0, -1.0, 0.0])
        level = ribbon(np.array([[-wide, 0.0], [wide, 0.0]]), np.array([lying, lying]), 0.0, wide)
        upright = ribbon(np.array([[0.0, -wide], [0.0, wide]]), np.array([standing, standing]), 0.0, wide)
        for kind, mesh, names in (("floor", level, self.around.floors), ("wall", upright, self.around.walls)):
            for number, name in enumerate(names):
                # its own name separates its tint from that of the asset
                made = replace(material(name), name=f"{kind}_{name}")
                body = spec.worldbody.add_body(name=f"{kind}_{number}", mocap=True)
                layer = self.layers(spec, made, self.textures_around)[0]
                add_geom(spec, body, f"{kind}_{number}", mesh, made, layer, STUDIO_GROUP)


class ImageScene(Scene):
    """A scene whose floor is visible in front of the asset."""

    def depth_range(self, camera: Camera, poses: list[Array]) -> tuple[float, float]:
        """Return the nearest and farthest visible depth along the axis of a camera [m]."""
        near, far = super().depth_range(camera, poses)
        return _NEARER * near, far


class ImageRenderer(ClassicRenderer):
    """Takes pictures of one asset in changing settings; `close` frees the graphics memory."""

    def __init__(self, asset: Asset, around: Surroundings, textures: int, size: int) -> None:
        dress = ImageDress(around=around, textures_around=textures, large=size >= _LARGE)
        super().__init__(ImageScene(asset, "none", textures, dress), (size, size))
        self.around = around
        self._setting = Setting()
        self._size_of_picture = (size, size)
        self._tints = {
            (kind, number): self.scene.model.mat_rgba[self._material(kind, number)].copy()
            for kind, names in (("floor", around.floors), ("wall", around.walls))
            for number in range(len(names))
        }

    def take(
        self, camera: Camera, poses: Mapping[str, Array], points: Array, setting: Setting, samples: int
    ) -> tuple[NDArray[np.uint8], NDArray[np.int32], Array]:
        """Return colors, the surface of each pixel, and depths."""
        self._setting = setting
        studio = self.scene.place.turned(camera)
        self._furnish(points @ studio[:3, :3].T + studio[:3, 3])
        placed, moved = self.scene.placed(camera, poses)
        color = self.color(placed, moved, self._size_of_picture, samples)
        return color, *self.surfaces(placed, moved, self._size_of_picture)

    def _furnish(self, points: Array) -> None:
        """Put sky, floor and wall around an asset with some vertices, in studio coordinates."""
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
        names = self.around.floors if kind == "floor" else self.around.walls
        for number in range(len(names)):
            shown = number == chosen
            model.geom_group[model.geom(f"{kind}_{number}").id] = STUDIO_GROUP if shown else HIDDEN_GROUP
            if shown:
                mocap = model.body(f"{kind}_{number}").mocapid[0]
                data.mocap_pos[mocap] = at
                data.mocap_quat[mocap] = (np.cos(turn / 2.0), 0.0, 0.0, np.sin(turn / 2.0))
                model.mat_rgba[self._material(kind, number)] = self._tints[kind, number] * (*tint, 1.0)

    def _material(self, kind: str, number: int) -> int:
        model = self.scene.model
        return int(model.geom_matid[model.geom(f"{kind}_{number}").id])

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
            lamp.ambient = [0.55 * light.ambient * dim if number == 0 else 0.0] * 3
            lamp.castshadow = number == 0
            lamp.specular = [0.0] * 3


def encoded_color(pixels: NDArray[np.uint8], form: str) -> bytes:
    """Return colors, shape (height, width, 3), as PNG or JPEG."""
    return _png(pixels) if form == "png" else _encoded(pixels, "JPEG", quality=_JPEG_QUALITY)


def encoded_depth(depth: Array) -> tuple[bytes, float]:
    """Return depths as a 16-bit PNG, 0 for nothing, and the depth of one step [m]."""
    seen = np.isfinite(depth)
    scale = float(depth[seen].max()) / _MOST if seen.any() else 1.0
    steps = np.rint(np.where(seen, depth, 0.0) / scale)
    return _png(steps.astype(np.uint16)), scale


def encoded_normals(normals: Array) -> bytes:
    """Return unit normals, shape (height, width, 3), as PNG: 127.5 + 127.5 n, black for nothing."""
    seen = np.abs(normals).sum(axis=-1, keepdims=True) > 0.0
    return _png(np.where(seen, np.rint(127.5 + 127.5 * normals), 0.0).astype(np.uint8))


def _png(pixels: NDArray[Any]) -> bytes:
    return _encoded(pixels, "PNG", compress_level=_PNG_LEVEL)


def _encoded(pixels: NDArray[Any], form: str, **options: int) -> bytes:
    from PIL import Image

    content = BytesIO()
    Image.fromarray(pixels).save(content, form, **options)
    return content.getvalue()
