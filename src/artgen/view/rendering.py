"""Pictures of assets for `Asset.render`, and exact ray casts.

A picture is the average of many, each lit from another point of the studio's lamps. A single picture has hard
shadows and aliased edges; the average has neither, and corners are dark because fewer lamps reach them.
"""

import atexit
import math
import threading
from collections import OrderedDict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, get_args

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.asset.shape import Mesh
from artgen.errors import AssetError, ParameterError, RenderError, nearest
from artgen.materials.textures import check_size
from artgen.view import gl
from artgen.view.camera import Camera, View, camera_of
from artgen.view.picture import Picture, Pixels, checked_size
from artgen.view.scene import ASSET_GROUP, HALF, HIDDEN_GROUP, Drawn, RenderScene, Studio
from artgen.view.studio import Backdrop, sphere_map_coordinates


@dataclass(frozen=True, eq=False)
class Hits:
    """The first hits of rays."""

    surfaces: NDArray[np.int32]  # number of the surface that each ray hits from 1, 0 for none, shape (n,)
    distance: Array  # distance in lengths of the direction, infinite without a hit, shape (n,)
    normals: Array  # unit normals, interpolated over the triangles; zero for none, shape (n, 3)
    # number of the triangle among those of all surfaces, -1 for none, shape (n,)
    triangles: NDArray[np.int64]
    shares: Array  # barycentric coordinates of the hit in its triangle, shape (n, 3)


def cast(meshes: Sequence[Mesh], origin: Array, directions: Array) -> Hits:
    """Return the first hits of rays from one point, with directions of shape (..., 3).

    Raises:
        RenderError: Embree is not installed.
    """
    try:
        from embreex.mesh_construction import TriangleMesh
        from embreex.rtcore_scene import EmbreeScene
    except ImportError as error:
        raise RenderError(
            f'normals are found by Embree, which cannot be loaded ({error}): pip install "artgen[sim]"'
        ) from error
    corners = np.concatenate([mesh.vertices[mesh.triangles] for mesh in meshes])
    normals = np.concatenate([mesh.normals[mesh.triangles] for mesh in meshes])
    surface = np.repeat(np.arange(1, len(meshes) + 1), [len(mesh.triangles) for mesh in meshes])
    scene = EmbreeScene()
    # Embree uses single precision: its coordinates have their origin at the origin of the rays
    TriangleMesh(scene, np.ascontiguousarray(corners - origin, np.float32))
    rays = np.ascontiguousarray(directions.reshape(-1, 3), np.float32)
    found = scene.run(np.zeros_like(rays), rays, output=True)
    triangle = np.asarray(found["primID"])
    hit = triangle >= 0
    share = np.stack([1.0 - found["u"] - found["v"], found["u"], found["v"]], axis=1).astype(float)
    smooth = np.zeros((len(rays), 3))
    blended = (share[hit][:, :, None] * normals[triangle[hit]]).sum(axis=1)
    smooth[hit] = blended / np.maximum(np.linalg.norm(blended, axis=1, keepdims=True), 1e-12)
    surfaces = np.zeros(len(rays), np.int32)
    surfaces[hit] = surface[triangle[hit]]
    distance = np.where(hit, np.asarray(found["tfar"], float), np.inf)
    return Hits(surfaces, distance, smooth, np.where(hit, triangle, -1).astype(np.int64), share)


_MOST_SCENES = 4  # most scenes that stay in memory for further pictures


class _Kept(threading.local):
    """The renderers of a thread, because a graphics context belongs to one thread."""

    def __init__(self) -> None:
        self.renderers: OrderedDict[Any, Renderer] = OrderedDict()


_kept = _Kept()


def render(
    asset: Asset,
    q: Mapping[str, float] | None = None,
    *,
    camera: Camera | View | str | None = None,
    size: int | tuple[int, int] = 768,
    studio: Studio = "studio",
    textures: int = 512,
    samples: int = 32,
) -> Picture:
    """Render a picture of an asset with MuJoCo.

    Args:
        asset: The asset, generated or loaded.
        q: Joint positions by name, completed as in `Asset.positions` [rad or m].
        camera: A camera, a view, or the name of a view: one of `artgen.view.VIEWS`, or `close-up:` and the
            name of a link. By default from the front, slightly left and above.
        size: Width and height of the picture, or one number for both [pixels].
        studio: Surroundings: a seamless backdrop, a wall and a wooden floor, or none.
        textures: Texels per side of the material maps; 0 for plain colors.
        samples: Number of samples of lamps and edges; with few samples, shadows have steps.

    Raises:
        AssetError: A joint or link is unknown, a position is beyond its limits, or nothing is visible.
        ParameterError: An argument has a value that is not allowed.
        RenderError: MuJoCo or OpenGL is missing; the message says what to install.
    """
    pixels = checked_size(size)
    if studio not in get_args(Studio):
        raise ParameterError(f"there is no studio {studio!r}.{nearest(str(studio), get_args(Studio))}")
    if textures != 0:
        check_size(textures)
    if type(samples) is not int or samples < 1:
        raise ParameterError(f"samples {samples!r} must be a whole number of at least 1")
    poses = asset.pose(q)
    taken = camera_of(camera, asset, _points(asset, poses), pixels[0] / pixels[1])
    try:
        import mujoco  # noqa: F401 - checks that it is installed
    except ImportError as error:
        raise RenderError(
            f'pictures are drawn by MuJoCo, which cannot be loaded ({error}): pip install "artgen[sim]"'
        ) from error
    renderer = _renderer(asset, studio, textures, pixels)
    color = renderer.color(*renderer.scene.placed(taken, poses), pixels, samples)
    return Picture(
        color,
        taken,
        tuple(link.name for link in asset.links for _ in link.surfaces),
        tuple(surface.label for link in asset.links for surface in link.surfaces),
        lambda: _surfaces(asset, taken, poses, pixels),
        lambda: _cast(asset, taken, poses, pixels).normals.reshape(pixels[1], pixels[0], 3),
    )


def close() -> None:
    """Free the renderers of this thread; the next picture creates a new one."""
    if gl.owns_process():  # renderers in a forked process belong to its parent
        while _kept.renderers:
            _kept.renderers.popitem()[1].close()


def _renderer(asset: Asset, studio: Studio, textures: int, size: tuple[int, int]) -> "Renderer":
    """Return the renderer of an asset; further pictures reuse it."""
    gl.claim_process()
    renderers = _kept.renderers
    key = (id(asset), studio, textures)
    if key in renderers and not renderers[key].fits(size):
        renderers.pop(key).close()
    if key not in renderers:
        while len(renderers) >= _MOST_SCENES:
            renderers.popitem(last=False)[1].close()
        renderers[key] = Renderer(RenderScene(asset, studio, textures), size)
        # exit functions run in reverse order: this one before those of MuJoCo, which close the display
        atexit.unregister(close)
        atexit.register(close)
    renderers.move_to_end(key)
    return renderers[key]


def _surfaces(
    asset: Asset, camera: Camera, poses: Mapping[str, Array], size: tuple[int, int]
) -> tuple[NDArray[np.int32], Array]:
    """Return number and depth of the surface at each pixel's center, by OpenGL or else by rays."""
    try:
        renderer = _renderer(asset, "none", 0, size)
    except RenderError:
        hits, shape = _cast(asset, camera, poses, size), (size[1], size[0])
        return hits.surfaces.reshape(shape), hits.distance.reshape(shape)
    return renderer.surfaces(*renderer.scene.placed(camera, poses), size)


def _cast(asset: Asset, camera: Camera, poses: Mapping[str, Array], size: tuple[int, int]) -> Hits:
    meshes = [surface.mesh.moved(poses[link.name]) for link in asset.links for surface in link.surfaces]
    return cast(meshes, np.array(camera.position), camera.rays(size))


def _points(asset: Asset, poses: Mapping[str, Array]) -> dict[str, Array]:
    """Return the posed vertices of each visible link."""
    found = {}
    for link in asset.links:
        if link.surfaces:
            points = np.concatenate([surface.mesh.vertices for surface in link.surfaces])
            found[link.name] = points @ poses[link.name][:3, :3].T + poses[link.name][:3, 3]
    if not found:
        raise AssetError(f"asset {asset.name!r} has no visible surfaces")
    return found


_KEY = np.array([-0.38, -0.85, 0.80]) / np.linalg.norm([-0.38, -0.85, 0.80])  # direction of the key light
_KEY_SPREAD = 0.16  # half the angular size of the softbox, seen from the asset
_LOWEST = 0.06  # squared height of the lowest point of the sky
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
        """Set the lamps of one of the averaged pictures: a point of the softbox, one of the sky, and fill."""
        place = self.scene.place
        floor, front = np.array([0.0, 0.0, -1.0]), np.array([0.15, -0.984, 0.1])
        key, sky = _key_light(*places[:2]), _sky_light(*places[2:])
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


def _key_light(across: float, around: float) -> Array:
    """Return the unit direction to a point of the softbox, given by two numbers in 0..1."""
    right = np.cross(_KEY, (0.0, 0.0, 1.0))
    radius, turn = _KEY_SPREAD * math.sqrt(across), 2.0 * math.pi * around
    point = _KEY + radius * (math.cos(turn) * right + math.sin(turn) * np.cross(right, _KEY))
    return np.asarray(point / np.linalg.norm(point))


def _sky_light(height: float, around: float) -> Array:
    """Return the unit direction to a point of the sky, brightest above, given by two numbers in 0..1."""
    z, turn = math.sqrt(_LOWEST + (1.0 - _LOWEST) * height), 2.0 * math.pi * around
    level = math.sqrt(1.0 - z * z)
    return np.array([level * math.cos(turn), level * math.sin(turn), z])


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
