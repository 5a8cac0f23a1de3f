"""Pictures of scenes by MuJoCo's renderer, for training images and tasks.

A picture is the average of many, each lit from another point of its lamps. A single picture has hard shadows
and aliased edges; the average has neither.
"""

import math
from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array
from artgen.view import gl
from artgen.view.camera import Camera
from artgen.view.picture import Pixels
from artgen.view.scene import ASSET_GROUP, HALF, HIDDEN_GROUP, Drawn, RenderScene
from artgen.view.studio import Backdrop, sphere_map_coordinates

_PRIMES = (2, 3, 5, 7, 11)
_SHADOW_REACH = 1.25  # distance of shadows from the asset's center, relative to its radius
_NEARNESS = 0.35  # half the asset's size relative to the distance of the mirrored studio


class Renderer:
    """Draws one scene with OpenGL.

    Attributes:
        scene: The scene.
    """

    def __init__(self, scene: RenderScene, size: tuple[int, int]) -> None:
        """Create the graphics context for pictures of at most this size [pixels]."""
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
        self._gl.make_current()
        self._context.free()
        self._gl.free()

    def fits(self, size: tuple[int, int]) -> bool:
        """Tell whether pictures of a size can be drawn."""
        return size[0] <= self._size[0] and size[1] <= self._size[1]

    def color(self, camera: Camera, poses: list[Array], size: tuple[int, int], samples: int) -> Pixels:
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
            # an evenly spread sequence in 0..1 (Hammersley)
            across, along, *lamps = (_radical_inverse(number + 1, base) for base in _PRIMES)
            lamps.append((number + 0.5) / samples)
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
        found = table[colors[::-1].astype(np.int32) @ [1, 256, 65536]]
        share = depth[::-1].astype(float)
        # the depth buffer holds a / depth + b, by default from 0 near to 1 far
        distance = near * far / (far - share * (far - near))
        return found, np.where(found > 0, distance, np.inf)

    def _update(self, groups: Iterable[int]) -> None:
        import mujoco

        option = mujoco.MjvOption()
        for number in range(len(option.geomgroup)):
            option.geomgroup[number] = number in groups
        scene, camera, every = self.scene, mujoco.MjvCamera(), mujoco.mjtCatBit.mjCAT_ALL
        mujoco.mjv_updateScene(scene.model, scene.data, option, None, camera, every, self._view)

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
        half = math.dist(camera.position, camera.target) * math.tan(camera.field_of_view / 2.0)
        reach = 2.0 * half * math.hypot(1.0, size[0] / size[1])
        near = reach < _SHADOW_REACH * place.radius
        self._context.shadowClip = reach if near else _SHADOW_REACH * place.radius
        return np.array(camera.target) if near else place.center

    def _light(self, places: list[float], focus: Array) -> None:
        """Set the lamps of one of the averaged pictures, given by numbers in 0..1."""
        raise NotImplementedError

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


def _radical_inverse(number: int, base: int) -> float:
    result, scale = 0.0, 1.0 / base
    while number:
        number, digit = divmod(number, base)
        result += digit * scale
        scale /= base
    return result


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


def _toned(light: NDArray[np.floating]) -> Pixels:
    """Compress highlights, and return bytes."""
    knee = 0.85
    over = np.maximum(light - knee, 0.0)
    shown = np.minimum(light, knee) + (1.0 - knee) * (1.0 - np.exp(-over / (1.0 - knee)))
    pixels: Pixels = np.rint(np.clip(shown, 0.0, 1.0) * 255.0).astype(np.uint8)
    return pixels
