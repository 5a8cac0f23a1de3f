"""MuJoCo's classic renderer for many pictures of one asset: colours, and what each pixel shows."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.images.lighting import Setting, Surroundings
from artgen.materials import material
from artgen.view.camera import Camera
from artgen.view.classic import HALF, SKY, ClassicDress, ClassicRenderer
from artgen.view.scene import HIDDEN_GROUP, STUDIO_GROUP, Scene, add_geom
from artgen.view.studio import Backdrop, ribbon

_SKY_TEXELS = 32
_WIDE = 40.0  # half the size of floors and walls, over the asset's radius
_NEARER = 0.15  # where the floor begins to be seen, over where it would for the asset alone
_SHADOW_TEXELS = {False: 1024, True: 2048}  # of small and of large pictures
_LARGE = 640  # pixels on a side of large pictures
_TILES = 6  # faces of the sky: right, left, up, down, front, back


@dataclass
class ImageDress(ClassicDress):
    """Makes materials as for other pictures, and the floors and walls of these."""

    around: Surroundings = field(default_factory=Surroundings)  # which floors and walls
    textures_around: int = 0  # texels on a side of their maps
    large: bool = True  # whether pictures are large, and want finer shadows

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
                # by a name of its own, so that its tint is not the asset's
                made = replace(material(name), name=f"{kind}_{name}")
                body = spec.worldbody.add_body(name=f"{kind}_{number}", mocap=True)
                layer = self.layers(spec, made, self.textures_around)[0]
                add_geom(spec, body, f"{kind}_{number}", mesh, made, layer, STUDIO_GROUP)


class ImageScene(Scene):
    """A scene whose floor is seen before the asset, too."""

    def depth_range(self, camera: Camera, poses: list[Array]) -> tuple[float, float]:
        """Return between which depths along a camera's axis everything is seen [m]."""
        near, far = super().depth_range(camera, poses)
        return _NEARER * near, far


class ImageRenderer(ClassicRenderer):
    """Takes pictures of one asset in changing settings; `close` frees what it holds of the graphics card.

    Attributes:
        around: What the settings choose from.
    """

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
        """Take a picture."""
        self._setting = setting
        studio = self.scene.place.turned(camera)
        self._furnish(points @ studio[:3, :3].T + studio[:3, 3])
        placed, moved = self.scene.placed(camera, poses)
        color = self.color(placed, moved, self._size_of_picture, samples)
        return color, *self.surfaces(placed, moved, self._size_of_picture)

    def _furnish(self, points: Array) -> None:
        """Put sky, floor and wall around an asset that reaches to some points, in studio coordinates."""
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
        """Paint the sky from its colour at the horizon and below to that above."""
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
        """Put the lamp, at one of its points, and light from everywhere, which is stronger from above."""
        light, place = self._setting.light, self.scene.place
        dim, color = HALF, np.array(light.color)
        above, front, below = (
            np.array([0.0, -0.3, 0.954]),
            np.array([0.15, -0.984, 0.1]),
            np.array([0.0, 0.0, -1.0]),
        )
        lamps = (
            (light.direction((places[0], places[1])), 1.15 * light.directional * color),
            (above, 0.55 * light.ambient * np.ones(3)),
            (front, 0.35 * light.ambient * np.ones(3)),
            (below, 0.12 * light.ambient * np.ones(3)),
        )
        for number, (lamp, (direction, strength)) in enumerate(zip(self._view.lights, lamps, strict=False)):
            lamp.dir = -direction
            lamp.pos = focus + 4.0 * place.radius * direction
            lamp.diffuse = strength * dim
            lamp.ambient = [0.55 * light.ambient * dim if number == 0 else 0.0] * 3
            lamp.castshadow = number == 0
            lamp.specular = [0.0] * 3
