"""Pictures of assets for `Asset.render`: colors in a studio, and the surface at each pixel."""

from collections.abc import Mapping
from functools import cache
from typing import Any, get_args

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.errors import AssetError, ParameterError, nearest
from artgen.materials.textures import check_size
from artgen.view.camera import Camera, View, camera_of
from artgen.view.picture import Picture, checked_size
from artgen.view.scene import Studio
from artgen.view.shading import colors
from artgen.view.studio import backdrop
from artgen.view.tracing import Hits, World, cast

_MOST_SAMPLES = 4096  # per pixel; more change no pixel visibly


def render(
    asset: Asset,
    q: Mapping[str, float] | None = None,
    *,
    camera: Camera | View | str | None = None,
    size: int | tuple[int, int] = 768,
    studio: Studio = "studio",
    textures: int = 512,
    samples: int = 8,
) -> Picture:
    """Render a picture of an asset, by rays on the processor.

    Args:
        asset: The asset, generated or loaded.
        q: Joint positions by name, completed as in `Asset.positions` [rad or m].
        camera: A camera, a view, or the name of a view: one of `artgen.view.VIEWS`, or `close-up:` and the
            name of a link. By default from the front, slightly left and above, higher for small and flat
            assets; into a room, over the side without a wall.
        size: Width and height of the picture, or one number for both [pixels].
        studio: Surroundings: a seamless backdrop, a wall and a wooden floor, or none.
        textures: Texels per side of the material maps; 0 for plain colors.
        samples: Number of rays to the lamps and around for each pixel in shade, 1 to 4096; odd numbers are
            rounded to even ones.

    Raises:
        AssetError: A joint or link is unknown, a position is beyond its limits, or nothing is visible.
        ParameterError: An argument has a value that is not allowed.
        RenderError: Embree is missing; the message says what to install.
    """
    pixels = checked_size(size)
    if studio not in get_args(Studio):
        raise ParameterError(f"there is no studio {studio!r}.{nearest(str(studio), get_args(Studio))}")
    check_size(textures, plain=True)
    given: Any = samples
    whole = isinstance(given, int | np.integer) and not isinstance(given, bool)
    if not whole or not 1 <= given <= _MOST_SAMPLES:
        raise ParameterError(
            f"samples {samples!r} must be a whole number of at least 1 and at most {_MOST_SAMPLES}"
        )
    poses = asset.pose(q)
    taken = camera_of(camera, asset, _points(asset, poses), pixels[0] / pixels[1])
    place = backdrop(asset, studio)
    turn = place.turned(taken)
    surfaces = [(link, surface) for link in asset.links for surface in link.surfaces]
    posed = [(surface.mesh.moved(turn @ poses[link.name]), surface.material) for link, surface in surfaces]
    world = World([*posed, *place.meshes], place)

    @cache
    def hits() -> Hits:
        meshes = [surface.mesh.moved(poses[link.name]) for link, surface in surfaces]
        return cast(meshes, np.array(taken.position), taken.rays(pixels))

    def seen() -> tuple[NDArray[np.int32], Array]:
        shape = pixels[1], pixels[0]
        return hits().surfaces.reshape(shape), hits().distance.reshape(shape)

    return Picture(
        colors(world, taken.moved(turn), pixels, samples, textures),
        taken,
        tuple(link.name for link, _ in surfaces),
        tuple(surface.label for _, surface in surfaces),
        seen,
        lambda: hits().normals.reshape(pixels[1], pixels[0], 3),
    )


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
