"""MuJoCo's classic renderer: averages of many pictures, each lit from another point of the studio's lamps.

A single picture has hard shadows and aliased edges; the average has neither, and corners are dark because
fewer lamps reach them. Metal and lacquer mirror the studio: its image is a texture with coordinates for each
camera.
"""

import math
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array
from artgen.materials import Material
from artgen.materials.textures import displayed, kinds, map_name, maps
from artgen.view import gl
from artgen.view.camera import Camera
from artgen.view.environment import sphere_map, sphere_map_coordinates
from artgen.view.scene import ASSET_GROUP, HIDDEN_GROUP, Drawn, Layer, RenderScene
from artgen.view.studio import Backdrop

KEY = np.array([-0.38, -0.85, 0.80]) / np.linalg.norm([-0.38, -0.85, 0.80])
"""Direction of the key light, shape (3,)."""

_KEY_SPREAD = 0.16  # half the angular size of the softbox, seen from the asset
_LOWEST = 0.06  # squared height of the lowest point of the sky
_PRIMES = (2, 3, 5, 7, 11)


def key_light(across: float, around: float) -> Array:
    """Return the unit direction to a point of the softbox, given by two numbers in 0..1."""
    right = np.cross(KEY, (0.0, 0.0, 1.0))
    radius, turn = _KEY_SPREAD * math.sqrt(across), 2.0 * math.pi * around
    point = KEY + radius * (math.cos(turn) * right + math.sin(turn) * np.cross(right, KEY))
    return np.asarray(point / np.linalg.norm(point))


def sky_light(height: float, around: float) -> Array:
    """Return the unit direction to a point of the sky, brightest above, given by two numbers in 0..1."""
    z, turn = math.sqrt(_LOWEST + (1.0 - _LOWEST) * height), 2.0 * math.pi * around
    level = math.sqrt(1.0 - z * z)
    return np.array([level * math.cos(turn), level * math.sin(turn), z])


def spread(number: int, count: int) -> list[float]:
    """Return the coordinates of a point of an evenly spread sequence, 6 in 0..1 (Hammersley)."""
    return [*(_radical_inverse(number + 1, base) for base in _PRIMES), (number + 0.5) / count]


def _radical_inverse(number: int, base: int) -> float:
    result, scale = 0.0, 1.0 / base
    while number:
        number, digit = divmod(number, base)
        result += digit * scale
        scale /= base
    return result


HALF = 0.5
"""Brightness of the single pictures, so that no light is clipped before the average."""

SKY = "studio_sky"
"""Name of the background texture."""

_MIRROR_STEP = 0.05  # roughness steps of the blurred studio
_SHADOW_TEXELS = 2048
_SHADOW_REACH = 1.25  # distance of shadows from the asset's center, relative to its radius
_NEARNESS = 0.35  # half the asset's size relative to the distance of the mirrored studio
_SKY_LIGHT = {"studio": 0.87, "room": 0.87, "none": 1.7}  # the last value becomes white


def body_of_glass(material: Material) -> float:
    """Return the brightness of transparent surfaces: clear glass scatters less than frosted glass."""
    if material.opacity == 1.0:
        return 1.0
    return 0.6 + 0.4 * min(1.0, material.specular_roughness / 0.5)


@dataclass
class ClassicDress:
    """Materials of the classic renderer: colors and pictures of their reflections."""

    known: dict[str, tuple[Layer, ...]] = field(default_factory=dict)
    textures: set[str] = field(default_factory=set)

    def layers(self, spec: Any, material: Material, textures: int) -> tuple[Layer, ...]:
        """Add the textures and materials of a surface; return the material passes in draw order."""
        if material.name not in self.known:
            self.known[material.name] = self._made(spec, material, textures)
        return self.known[material.name]

    def _made(self, spec: Any, material: Material, textures: int) -> tuple[Layer, ...]:
        color = displayed(material.base_color)
        if material.base_metalness >= 0.5:
            mirror = self._mirror(spec, material.specular_roughness)
            name = f"{material.name}_metal"
            _add_material(spec, name, (*(0.46 * color), 1.0), mirror, emission=0.75)
            return (Layer(name, mirrors=True),)
        texture = ""
        if textures and "albedo" in kinds(material):
            texture = f"{map_name(material, 'albedo')}"
            color = np.ones(3)
            if texture not in self.textures:
                self.textures.add(texture)
                albedo = maps(material, textures).albedo
                assert albedo is not None
                _add_texture(spec, texture, albedo)
        glow = max(material.emission)
        if glow:
            color = displayed(np.array(material.emission) / max(1.0, glow))
        color = color * body_of_glass(material)
        _add_material(spec, material.name, (*color, material.opacity), texture, emission=1.0 if glow else 0.0)
        return (Layer(material.name), *self._gloss(spec, material))

    def _gloss(self, spec: Any, material: Material) -> tuple[Layer, ...]:
        """Return the layer in which a smooth surface slightly mirrors the studio."""
        roughness, share = material.specular_roughness, 0.16 * (1.0 - material.specular_roughness / 0.5)
        if material.coat_weight > 0.0:
            roughness = min(roughness, material.coat_roughness)
            share = max(share, 0.16 * material.coat_weight * (1.0 - roughness / 0.5))
        if material.opacity < 1.0:
            share *= 1.3
        if share < 0.02:
            return ()
        name = f"{material.name}_gloss"
        _add_material(spec, name, (1.0, 1.0, 1.0, share), self._mirror(spec, roughness), emission=0.5)
        return (Layer(name, mirrors=True),)

    def _mirror(self, spec: Any, roughness: float) -> str:
        step = round(roughness / _MIRROR_STEP)
        name = f"studio_mirror_{step}"
        if name not in self.textures:
            self.textures.add(name)
            light = displayed(sphere_map(_MIRROR_STEP * step))
            pixels = np.repeat(np.rint(255 * light).astype(np.uint8)[..., None], 3, axis=2)
            _add_texture(spec, name, pixels)
        return name

    def surroundings(self, spec: Any, place: Backdrop) -> None:
        """Add lights and the sky to a specification."""
        import mujoco

        for number in range(4):
            spec.worldbody.add_light(
                name=f"lamp_{number}", type=mujoco.mjtLightType.mjLIGHT_DIRECTIONAL, castshadow=number < 2
            )
        light = _SKY_LIGHT[place.kind] * HALF
        spec.add_texture(
            name=SKY,
            type=mujoco.mjtTexture.mjTEXTURE_SKYBOX,
            builtin=mujoco.mjtBuiltin.mjBUILTIN_FLAT,
            rgb1=[light] * 3,
            rgb2=[light] * 3,
            width=8,
            height=48,
        )
        visual = spec.visual
        visual.headlight.active = 0
        visual.quality.offsamples = 0
        visual.quality.shadowsize = _SHADOW_TEXELS
        visual.map.fogstart, visual.map.fogend = 1e4, 1e5


def _add_texture(spec: Any, name: str, pixels: NDArray[np.uint8]) -> None:
    import mujoco

    texture = spec.add_texture(
        name=name,
        type=mujoco.mjtTexture.mjTEXTURE_2D,
        width=pixels.shape[1],
        height=pixels.shape[0],
        nchannel=pixels.shape[2],
    )
    texture.data = np.ascontiguousarray(pixels).tobytes()


def _add_material(spec: Any, name: str, rgba: Any, texture: str = "", emission: float = 0.0) -> None:
    import mujoco

    made = spec.add_material(
        name=name,
        rgba=[float(each) for each in rgba],
        emission=emission,
        specular=0.0,
        shininess=0.0,
        reflectance=0.0,
    )
    if texture:
        roles = [""] * int(mujoco.mjtTextureRole.mjNTEXROLE)
        roles[int(mujoco.mjtTextureRole.mjTEXROLE_RGB)] = texture
        made.textures = roles


class ClassicRenderer:
    """Draws one scene with OpenGL; `close` frees its graphics memory."""

    def __init__(self, scene: RenderScene, size: tuple[int, int]) -> None:
        import mujoco

        self.scene = scene
        self._size = size
        visual = scene.model.vis.global_
        visual.offwidth, visual.offheight = size
        self._gl = gl.context(*size)
        self._gl.make_current()
        self._context = mujoco.MjrContext(scene.model, mujoco.mjtFontScale.mjFONTSCALE_100)
        mujoco.mjr_setBuffer(mujoco.mjtFramebuffer.mjFB_OFFSCREEN, self._context)
        self._view = mujoco.MjvScene(scene.model, scene.model.ngeom + 10)

    def close(self) -> None:
        """Free the graphics memory."""
        if self._gl is not None:
            self._gl.make_current()
            self._context.free()
            self._gl.free()
            self._gl = None

    def fits(self, size: tuple[int, int]) -> bool:
        """Tell whether pictures of a size can be drawn."""
        return size[0] <= self._size[0] and size[1] <= self._size[1]

    def color(
        self, camera: Camera, poses: list[Array], size: tuple[int, int], samples: int
    ) -> NDArray[np.uint8]:
        """Return the colors, shape (height, width, 3)."""
        import mujoco

        self._gl.make_current()
        self._lay_mirrors(camera, poses)
        focus = self._focus_shadows(camera, size)
        near, far = self.scene.depth_range(camera, poses)
        self._update(range(HIDDEN_GROUP))
        width, height = size
        total = np.zeros((height, width, 3), np.uint32)
        buffer = np.empty((height, width, 3), np.uint8)
        rectangle = mujoco.MjrRect(0, 0, width, height)
        flags = self._view.flags
        flags[mujoco.mjtRndFlag.mjRND_SHADOW] = True
        flags[mujoco.mjtRndFlag.mjRND_REFLECTION] = False
        flags[mujoco.mjtRndFlag.mjRND_HAZE] = False
        flags[mujoco.mjtRndFlag.mjRND_SKYBOX] = True
        for number in range(samples):
            across, along, *lamps = spread(number, samples)
            self._aim(camera, size, near, far, (across - 0.5, along - 0.5))
            self._light(lamps, focus)
            mujoco.mjr_render(rectangle, self._view, self._context)
            mujoco.mjr_readPixels(buffer, None, rectangle, self._context)
            total += buffer
        light = np.arange(255 * samples + 1, dtype=np.float32) / (255.0 * HALF * samples)
        return _toned(light)[total[::-1]]

    def surfaces(
        self, camera: Camera, poses: list[Array], size: tuple[int, int]
    ) -> tuple[NDArray[np.int32], Array]:
        """Return number and depth of the surface at each pixel's center, both of shape (height, width)."""
        import mujoco

        self._gl.make_current()
        near, far = self.scene.depth_range(camera, poses)
        self._update([ASSET_GROUP])
        self._aim(camera, size, near, far)
        width, height = size
        colors, depth = np.empty((height, width, 3), np.uint8), np.empty((height, width), np.float32)
        flags = self._view.flags
        saved = flags.copy()
        flags[mujoco.mjtRndFlag.mjRND_SEGMENT] = True
        flags[mujoco.mjtRndFlag.mjRND_IDCOLOR] = True
        rectangle = mujoco.MjrRect(0, 0, width, height)
        mujoco.mjr_render(rectangle, self._view, self._context)
        mujoco.mjr_readPixels(colors, depth, rectangle, self._context)
        flags[:] = saved
        table = np.zeros(self._view.ngeom + 1, np.int32)
        for geom in self._view.geoms[: self._view.ngeom]:
            if geom.segid >= 0:
                table[geom.segid + 1] = self.scene.surface_of_geom[geom.objid]
        red, green, blue = (colors[::-1, :, channel].astype(np.int32) for channel in range(3))
        found = table[red + 256 * green + 65536 * blue]
        share = depth[::-1].astype(float)
        # the depth buffer holds a / depth + b, by default from 0 near to 1 far
        distance = near * far / (far - share * (far - near))
        return found, np.where(found > 0, distance, np.inf)

    def _update(self, groups: Any) -> None:
        import mujoco

        option = mujoco.MjvOption()
        for number in range(len(option.geomgroup)):
            option.geomgroup[number] = number in groups
        mujoco.mjv_updateScene(
            self.scene.model,
            self.scene.data,
            option,
            None,
            mujoco.MjvCamera(),
            mujoco.mjtCatBit.mjCAT_ALL,
            self._view,
        )

    def _aim(
        self,
        camera: Camera,
        size: tuple[int, int],
        near: float,
        far: float,
        shift: tuple[float, float] = (0.0, 0.0),
    ) -> None:
        """Aim MuJoCo's two eyes, shifted by fractions of a pixel."""
        width, height = size
        _, up, forward = camera.axes()
        half = near * math.tan(camera.field_of_view / 2.0)
        pixel = 2.0 * half / height
        for eye in self._view.camera:
            eye.pos, eye.forward, eye.up = camera.position, forward, up
            eye.frustum_center = shift[0] * pixel
            eye.frustum_width = half * width / height
            eye.frustum_bottom, eye.frustum_top = -half + shift[1] * pixel, half + shift[1] * pixel
            eye.frustum_near, eye.frustum_far = near, far
            eye.orthographic = 0

    def _focus_shadows(self, camera: Camera, size: tuple[int, int]) -> Array:
        """Adjust the sharpness of shadows to a close-up; return their center, shape (3,)."""
        place = self.scene.place
        seen = math.dist(camera.position, camera.target) * math.tan(camera.field_of_view / 2.0)
        reach = 2.0 * seen * math.hypot(1.0, size[0] / size[1])
        near = reach < _SHADOW_REACH * place.radius
        self._context.shadowClip = reach if near else _SHADOW_REACH * place.radius
        return np.array(camera.target) if near else place.center

    def _light(self, places: list[float], focus: Array) -> None:
        """Set the lamps of one of the averaged pictures: a point of the softbox, one of the sky, and fill."""
        place = self.scene.place
        key, sky = key_light(*places[:2]), sky_light(*places[2:])
        floor, front = np.array([0.0, 0.0, -1.0]), np.array([0.15, -0.984, 0.1])
        lamps = ((key, 0.42), (sky, 0.80), (front, 0.22), (floor, 0.10))
        for number, (lamp, (direction, strength)) in enumerate(zip(self._view.lights, lamps, strict=False)):
            lamp.dir = -direction
            lamp.pos = focus + 4.0 * place.radius * direction
            lamp.diffuse = [strength * HALF] * 3
            lamp.ambient = [0.26 * HALF if number == 0 else 0.0] * 3
            lamp.castshadow = number < 2
            lamp.specular = [0.0] * 3

    def _lay_mirrors(self, camera: Camera, poses: list[Array]) -> None:
        """Set the studio's reflection on mirroring surfaces for the camera."""
        import mujoco

        model = self.scene.model
        for drawn in self.scene.drawn:
            if not drawn.mirrors:
                continue
            coordinates = _mirrored(drawn, camera, poses[drawn.link], self.scene.place)
            for mesh in drawn.mirrors:
                first = int(model.mesh_texcoordadr[mesh])
                assert model.mesh_texcoordnum[mesh] == len(coordinates)
                model.mesh_texcoord[first : first + len(coordinates)] = coordinates
                mujoco.mjr_uploadMesh(model, self._context, mesh)


def _mirrored(drawn: Drawn, camera: Camera, pose: Array, place: Backdrop) -> Array:
    """Return the sphere map coordinates of the reflection at each vertex for a camera, shape (n, 2)."""
    points = drawn.mesh.vertices @ pose[:3, :3].T + pose[:3, 3]
    normals = drawn.mesh.normals @ pose[:3, :3].T
    rays = points - camera.position
    rays /= np.linalg.norm(rays, axis=1, keepdims=True)
    bounced = rays - 2.0 * (rays * normals).sum(axis=1, keepdims=True) * normals
    # the studio's walls are at a finite distance: a flat plate mirrors a gradient, not one color
    bounced += _NEARNESS / place.radius * (points - place.center)
    return sphere_map_coordinates(bounced / np.linalg.norm(bounced, axis=1, keepdims=True))


def _toned(light: Any) -> NDArray[np.uint8]:
    """Compress highlights, and return bytes."""
    knee = 0.85
    over = np.maximum(light - knee, 0.0)
    shown = np.minimum(light, knee) + (1.0 - knee) * (1.0 - np.exp(-over / (1.0 - knee)))
    pixels: NDArray[np.uint8] = np.rint(np.clip(shown, 0.0, 1.0) * 255.0).astype(np.uint8)
    return pixels
