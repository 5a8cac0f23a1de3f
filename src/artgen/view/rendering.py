"""Pictures of assets for `Asset.render`, and exact ray casts."""

import atexit
import threading
from collections import OrderedDict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal, get_args

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.asset.shape import Mesh
from artgen.errors import AssetError, ParameterError, RenderError, nearest
from artgen.materials.textures import check_size
from artgen.view import filament, gl
from artgen.view.camera import Camera, View, camera_of
from artgen.view.classic import ClassicDress, ClassicRenderer
from artgen.view.picture import Passes, Picture
from artgen.view.scene import RenderScene, Studio


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
    """Return the first hits of rays from one point."""
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


Backend = Literal["auto", "classic", "filament"]

_KEPT = 4  # scenes that are kept for the next picture
_LEAST, _MOST = 16, 4096  # largest number of pixels per side
_kept = threading.local()  # a graphics context belongs to one thread


def render(
    asset: Asset,
    q: Mapping[str, float] | None = None,
    *,
    camera: Camera | View | str | None = None,
    size: int | tuple[int, int] = 768,
    studio: Studio = "studio",
    backend: Backend = "auto",
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
        backend: Filament is physically based and needs Python 3.12 and Vulkan; `classic` needs only OpenGL;
            `auto` uses Filament if it works.
        textures: Texels per side of the material maps; 0 for plain colors.
        samples: Number of samples of lamps and edges; few samples give steps in shadows.

    Raises:
        AssetError: A joint or link is unknown, a position is beyond its limits, or nothing is visible.
        ParameterError: An argument has a value that is not allowed.
        RenderError: A renderer or its library is missing; the message says what to install.
    """
    pixels = checked_size(size)
    _check("studio", studio, get_args(Studio))
    _check("backend", backend, get_args(Backend))
    if textures != 0:
        check_size(textures)
    _check_samples(samples)
    poses = asset.pose(q)
    seen = _points(asset, poses)
    taken = camera_of(camera, asset, seen, pixels[0] / pixels[1])
    _require_mujoco()
    chosen = ("filament" if filament.works() else "classic") if backend == "auto" else backend
    gl.claim_process()

    def draw() -> NDArray[np.uint8]:
        renderer = _renderer(asset, chosen, studio, textures, pixels)
        placed, moved = renderer.scene.placed(taken, poses)
        drawn: NDArray[np.uint8] = renderer.color(placed, moved, pixels, samples)
        return drawn

    color = filament.THREAD.run(draw) if chosen == "filament" else draw()
    surfaces = [(link.name, surface.label) for link in asset.links for surface in link.surfaces]
    return Picture(
        color,
        taken,
        chosen,
        tuple(link for link, _ in surfaces),
        tuple(label for _, label in surfaces),
        Passes(
            lambda: _surfaces(asset, taken, poses, pixels),
            lambda: _cast(asset, taken, poses, pixels).normals.reshape(pixels[1], pixels[0], 3),
        ),
    )


def close() -> None:
    """Free the renderers of this thread; the next picture creates a new one."""
    if not gl.owns_process():
        return  # renderers in a forked process belong to its parent
    _close_kept()
    if filament.THREAD.begun():
        filament.THREAD.run(_close_kept)
        filament.THREAD.run(filament.forget_context)


def _close_kept() -> None:
    kept: OrderedDict[Any, Any] = vars(_kept).pop("renderers", OrderedDict())
    while kept:
        kept.popitem()[1].close()


def _renderer(asset: Asset, backend: str, studio: Studio, textures: int, size: tuple[int, int]) -> Any:
    """Return the renderer of an asset, which is reused for further pictures."""
    gl.claim_process()
    kept: OrderedDict[Any, Any] = vars(_kept).setdefault("renderers", OrderedDict())
    key = (id(asset), backend, studio, textures)
    found = kept.get(key)
    if found is not None and not found.fits(size):
        kept.pop(key).close()
        found = None
    if found is None:
        while len(kept) >= _KEPT:
            kept.popitem(last=False)[1].close()
        if backend == "classic":
            found = ClassicRenderer(RenderScene(asset, studio, textures, ClassicDress()), size)
        else:
            for other in [other for other in kept if other[1] == "filament"]:
                kept.pop(other).close()  # Filament draws nothing while two models share its context
            found = filament.FilamentRenderer(RenderScene(asset, studio, textures, filament.FilamentDress()))
        # runs before MuJoCo's exit functions, which were registered earlier, remove the display
        atexit.unregister(close)
        atexit.register(close)
        kept[key] = found
    kept.move_to_end(key)
    return found


def _surfaces(
    asset: Asset, camera: Camera, poses: Mapping[str, Array], size: tuple[int, int]
) -> tuple[NDArray[np.int32], Array]:
    """Return number and depth of the surface at each pixel's center: by OpenGL, or by rays."""
    try:
        renderer = _renderer(asset, "classic", "none", 0, size)
    except RenderError:
        hits = _cast(asset, camera, poses, size)
        shape = (size[1], size[0])
        return hits.surfaces.reshape(shape), hits.distance.reshape(shape)
    placed, moved = renderer.scene.placed(camera, poses)
    found: tuple[NDArray[np.int32], Array] = renderer.surfaces(placed, moved, size)
    return found


def _cast(asset: Asset, camera: Camera, poses: Mapping[str, Array], size: tuple[int, int]) -> Any:
    meshes = [surface.mesh.moved(poses[link.name]) for link in asset.links for surface in link.surfaces]
    return cast(meshes, np.array(camera.position), camera.rays(size))


def _points(asset: Asset, poses: Mapping[str, Array]) -> dict[str, Array]:
    """Return the posed vertices of each visible link."""
    meshes: dict[str, list[Mesh]] = {
        link.name: [surface.mesh for surface in link.surfaces] for link in asset.links
    }
    found = {}
    for name, of_link in meshes.items():
        if of_link:
            points = np.concatenate([mesh.vertices for mesh in of_link])
            found[name] = points @ poses[name][:3, :3].T + poses[name][:3, 3]
    if not found:
        raise AssetError(f"asset {asset.name!r} has no surfaces to be seen")
    return found


def checked_size(size: Any) -> tuple[int, int]:
    """Return the width and height of a picture."""
    both = (size, size) if isinstance(size, int) and not isinstance(size, bool) else size
    try:
        width, height = both
        whole = int(width) == width and int(height) == height
    except (TypeError, ValueError):
        whole, width, height = False, 0, 0
    if not whole or not (_LEAST <= width <= _MOST and _LEAST <= height <= _MOST):
        raise ParameterError(
            f"size {size!r} must be one or two whole numbers in {_LEAST}..{_MOST}: width and height [pixels]"
        )
    return int(width), int(height)


def _check_samples(samples: Any) -> None:
    if isinstance(samples, bool) or not isinstance(samples, int) or samples < 1:
        raise ParameterError(f"samples {samples!r} must be a whole number from 1 on")


def _check(name: str, value: Any, allowed: tuple[str, ...]) -> None:
    if value not in allowed:
        raise ParameterError(f"there is no {name} {value!r}.{nearest(str(value), allowed)}")


def _require_mujoco() -> None:
    try:
        import mujoco  # noqa: F401 - whether it is there
    except ImportError as error:
        raise RenderError(
            f'pictures are drawn by MuJoCo, which cannot be loaded ({error}): pip install "artgen[sim]"'
        ) from error
