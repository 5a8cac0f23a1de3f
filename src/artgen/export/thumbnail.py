"""Thumbnail of an asset for a package, drawn without a graphics library, equal on all machines.

Sums of products are written one by one: matrix products round differently on other machines.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array, Indices, Mask
from artgen.asset import Asset
from artgen.materials import Material
from artgen.materials.textures.bake import displayed

SIZE = 256
"""Pixels per side."""

NOTHING = -1
"""Number for pixels without a triangle."""

_GRID = 16  # grid positions of corners within a pixel, in each direction
_FINE = 2  # samples per pixel, in each direction
_FILLED = 0.84  # share of the picture that the asset fills
_SHADOW = 384  # samples per side of the view of the key light
_FLOOR = 0.80  # linear grey
_SOFT = 5  # samples per side of the kernel of a shadow's edge


@dataclass(frozen=True, eq=False)
class Seen:
    """The visible triangle and depth at each pixel."""

    owner: Indices  # number of the triangle, `NOTHING` without one, shape (size, size)
    depth: Array  # depth along the view, infinite without a triangle, shape (size, size) [m]


def rasterize(corners: Array, size: int) -> Seen:
    """Find the nearest front-facing triangle at each pixel; corners have the shape (n, 3, 3)."""
    grid = np.rint(corners[:, :, :2] * _GRID).astype(np.int64)
    facing = np.flatnonzero(_doubled_area(grid) > 0)
    grid, front = grid[facing], corners[facing]
    half = _GRID // 2
    low = np.maximum(-((half - grid[:, :, 1].min(axis=1)) // _GRID), 0)
    high = np.minimum((grid[:, :, 1].max(axis=1) - half) // _GRID, size - 1)
    number, row = _ranges(low, high)
    line, column = _ranges(*_spans(grid[number], row, size))
    number, row = number[line], row[line]
    depth = _depths(front, grid, number, column, row)
    pixel = row * size + column
    nearest = np.full(size * size, np.inf)
    np.minimum.at(nearest, pixel, depth)
    shown = depth == nearest[pixel]
    owner = np.full(size * size, len(corners), np.int64)
    np.minimum.at(owner, pixel[shown], facing[number[shown]])
    owner[owner == len(corners)] = NOTHING
    return Seen(owner.reshape(size, size), nearest.reshape(size, size))


def weights(corners: Array, column: Array, row: Array) -> Array:
    """Return the barycentric weights of the corners of a triangle at the center of a pixel, shape (n, 3)."""
    x, y = corners[:, :, 0], corners[:, :, 1]
    px, py = (column + 0.5)[:, None], (row + 0.5)[:, None]
    ahead, behind = [1, 2, 0], [2, 0, 1]
    areas = (x[:, ahead] - px) * (y[:, behind] - py) - (x[:, behind] - px) * (y[:, ahead] - py)
    areas = np.maximum(areas, 0.0)
    total = areas.sum(axis=1, keepdims=True)
    return np.where(total > 0.0, areas / np.where(total > 0.0, total, 1.0), 1.0 / 3.0)


def _ranges(first: Indices, last: Indices) -> tuple[Indices, Indices]:
    """Return for every integer of many ranges the number of its range, and the integer."""
    count = np.maximum(last - first + 1, 0)
    number = np.repeat(np.arange(len(count)), count)
    return number, np.arange(len(number)) + (first - np.cumsum(count) + count)[number]


def _doubled_area(points: NDArray[Any]) -> NDArray[Any]:
    one, other = points[:, 1] - points[:, 0], points[:, 2] - points[:, 0]
    return np.asarray(one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0])


def _spans(grid: Indices, row: Indices, size: int) -> tuple[Indices, Indices]:
    """Return the first and last pixel with its center inside each triangle, in one row each."""
    half = _GRID // 2
    y = row * _GRID + half
    first, last = np.zeros(len(row), np.int64), np.full(len(row), size - 1)
    for corner in range(3):
        start, end = grid[:, corner], grid[:, (corner + 1) % 3]
        run, rise = end[:, 0] - start[:, 0], end[:, 1] - start[:, 1]
        # a pixel is inside if its cross products with all sides are not negative
        bound = run * (y - start[:, 1]) + rise * start[:, 0] - rise * half
        step = rise * _GRID
        up, down = rise > 0, rise < 0
        last[up] = np.minimum(last[up], bound[up] // step[up])
        first[down] = np.maximum(first[down], -(bound[down] // -step[down]))
        last[(rise == 0) & (bound < 0)] = -1
    return first, last


def _depths(corners: Array, grid: Indices, number: Indices, column: Indices, row: Indices) -> Array:
    """Return the depth of each triangle's plane at the centers of pixels."""
    points = grid / _GRID
    one, other = points[:, 1] - points[:, 0], points[:, 2] - points[:, 0]
    area = _doubled_area(points)
    rise_one, rise_other = (corners[:, index, 2] - corners[:, 0, 2] for index in (1, 2))
    to_right = (rise_one * other[:, 1] - rise_other * one[:, 1]) / area
    upwards = (rise_other * one[:, 0] - rise_one * other[:, 0]) / area
    right, up = column + 0.5 - points[number, 0, 0], row + 0.5 - points[number, 0, 1]
    plane: Array = corners[number, 0, 2] + to_right[number] * right + upwards[number] * up
    # slivers have steep planes: clip depths to those of the corners
    depths = corners[:, :, 2]
    return np.clip(plane, depths.min(axis=1)[number], depths.max(axis=1)[number])


def thumbnail(asset: Asset) -> NDArray[np.uint8]:
    """Draw an asset from the front, right and above, shape (256, 256, 3)."""
    scene = _Scene(asset)
    size = SIZE * _FINE
    camera = _View((-0.62, 1.0, -0.42), scene.corners, size)
    light = _View((0.45, 0.62, -1.0), scene.corners, _SHADOW)
    shadow = rasterize(light.project(scene.corners), _SHADOW).depth
    # a bright floor with the asset's shadow, the lowest row of pixels first
    column, row = _pixels(np.ones((size, size), bool))
    flat = camera.place(column, row, np.zeros(len(column)))
    depth = (float(scene.corners[..., 2].min()) - flat[:, 2]) / camera.axes[2, 2]
    lit = _lit(camera.place(column, row, depth), light, shadow)
    grey = _FLOOR * (0.62 + 0.38 * lit) * (0.94 + 0.12 * row / size)
    picture = (grey[:, None] * np.array([1.0, 1.0, 1.01])).reshape(size, size, 3)
    depth = depth.reshape(size, size)
    for clear in (False, True):
        _draw(picture, depth, scene, (camera, light, shadow), clear=clear)
    fine = picture.reshape(SIZE, _FINE, SIZE, _FINE, 3).mean(axis=(1, 3))
    pixels: NDArray[np.uint8] = np.rint(displayed(fine) * 255.0).astype(np.uint8)[::-1]
    return np.ascontiguousarray(pixels)


class _Scene:
    """The triangles of an asset."""

    def __init__(self, asset: Asset) -> None:
        pose = asset.pose()
        corners, normals, numbers = [], [], []
        materials: dict[Material, int] = {}
        for link in asset.links:
            turn, offset = pose[link.name][:3, :3], pose[link.name][:3, 3]
            for surface in link.surfaces:
                mesh = surface.mesh
                vertices = np.stack([_dot(mesh.vertices, row) for row in turn], axis=-1) + offset
                turned = np.stack([_dot(mesh.normals, row) for row in turn], axis=-1)
                corners.append(np.round(vertices, 7)[mesh.triangles])
                normals.append(turned[mesh.triangles])
                number = materials.setdefault(surface.material, len(materials))
                numbers.append(np.full(len(mesh.triangles), number))
        self.corners = np.concatenate(corners)  # shape (n, 3, 3) [m]
        self.normals = np.concatenate(normals)  # at the corners, shape (n, 3, 3)
        # color, emission, metalness, roughness and opacity of each triangle, shape (n, 9)
        self.looks = np.array(
            [
                (*each.base_color, *each.emission, each.base_metalness, each.specular_roughness, each.opacity)
                for each in materials
            ]
        )[np.concatenate(numbers)]


class _View:
    """A parallel projection in which triangles fill a picture."""

    def __init__(self, direction: tuple[float, float, float], corners: Array, size: int) -> None:
        forward = _unit(np.array(direction))
        right = _unit(np.array([forward[1], -forward[0], 0.0]))
        # right, up and view direction in asset coordinates as rows, shape (3, 3)
        self.axes = np.array([right, np.cross(right, forward), forward])
        self.scale = 1.0  # pixels per metre
        self._shift = np.zeros(2)  # position of the asset's origin in pixels, to the right and up
        flat = self.project(corners)[..., :2].reshape(-1, 2)
        low, high = flat.min(axis=0), flat.max(axis=0)
        self.scale = _FILLED * size / max(float((high - low).max()), 1e-6)
        self._shift = 0.5 * size - 0.5 * (low + high) * self.scale

    def project(self, points: Array) -> Array:
        """Return pixel coordinates to the right and up, and the depth of points, shape (..., 3)."""
        right, up, depth = (_dot(points, axis) for axis in self.axes)
        x, y = self._shift
        return np.stack([right * self.scale + x, up * self.scale + y, depth], axis=-1)

    def place(self, column: Array, row: Array, depth: Array) -> Array:
        """Return the points in asset coordinates that are visible at pixels, shape (n, 3)."""
        x, y = self._shift
        parts = ((column - x) / self.scale, (row - y) / self.scale, depth)
        return np.asarray(sum(part[:, None] * axis for part, axis in zip(parts, self.axes, strict=True)))


def _draw(
    picture: Array, depth: Array, scene: _Scene, views: tuple[_View, _View, Array], *, clear: bool
) -> None:
    """Draw the opaque or the transparent triangles over a picture in linear RGB with its depth."""
    camera, light, shadow = views
    chosen = np.flatnonzero((scene.looks[:, 8] < 1.0) == clear)
    corners = camera.project(scene.corners[chosen])
    seen = rasterize(corners, len(depth))
    # the floor hides nothing: rounding may put things slightly below it
    nearer = (seen.owner != NOTHING) & ((seen.depth < depth) | (not clear))
    column, row = _pixels(nearer)
    owner = seen.owner[nearer]
    share = weights(corners[owner], column - 0.5, row - 0.5)
    normals = _unit(np.sum(scene.normals[chosen][owner] * share[:, :, None], axis=1))
    points = camera.place(column, row, seen.depth[nearer])
    lit = _lit(points + (2.0 / light.scale) * normals, light, shadow)
    looks = scene.looks[chosen][owner]
    colors = _shaded(looks, normals, camera.axes[2], -light.axes[2], lit)
    if clear:
        cover = looks[:, 8:]
        colors = cover * colors + (1.0 - cover) * picture[nearer]
    else:
        colors *= _openness(np.where(nearer, seen.depth, depth), camera)[nearer][:, None]
        depth[nearer] = seen.depth[nearer]
    picture[nearer] = colors


def _shaded(looks: Array, normals: Array, view: Array, light: Array, lit: Array) -> Array:
    """Return the light from surfaces to the viewer, shape (n, 3)."""
    color, emission, metal, rough = looks[:, :3], looks[:, 3:6], looks[:, 6], looks[:, 7]
    sky = 0.5 + 0.5 * normals[:, 2]
    key = np.maximum(_dot(normals, light), 0.0) * lit
    fill = np.maximum(_dot(normals, _unit(np.array([0.9, -0.5, 0.2]))), 0.0)
    diffuse = 0.30 + 0.28 * sky + 0.55 * key + 0.10 * fill
    facing = np.clip(-_dot(normals, view), 0.0, 1.0)
    mirrored = view + 2.0 * facing[:, None] * normals
    # the mirror image of a studio: a bright ceiling, a lamp, a grey floor
    sharp = np.clip(0.5 + mirrored[:, 2] / (0.25 + rough), 0.0, 1.0)
    smooth = sharp * sharp * (3.0 - 2.0 * sharp)
    lamp = np.clip(_dot(mirrored, light), 0.0, 1.0) ** 8
    glow = (0.30 + 0.75 * smooth + 0.9 * lamp * (1.0 - 0.6 * rough)) * (0.55 + 0.45 * lit)
    edge = (1.0 - facing) ** 5 * (1.0 - rough)
    mirror = metal[:, None] * color + (1.0 - metal[:, None]) * 0.04
    mirror = mirror + (1.0 - mirror) * edge[:, None]
    body = (1.0 - metal[:, None]) * color * diffuse[:, None]
    return np.asarray(body + mirror * glow[:, None] + emission)


def _lit(points: Array, light: _View, shadow: Array) -> Array:
    """Return the share of the key light that reaches points, shape (n,)."""
    size = len(shadow)
    place = light.project(points)
    column, row = (np.floor(place[:, axis]).astype(np.int64) for axis in (0, 1))
    bias = 3.0 / light.scale  # soft edges sample around the point
    reach = range(-(_SOFT // 2), _SOFT // 2 + 1)
    total = np.zeros(len(points))
    for x, y in ((column + right, row + up) for right in reach for up in reach):
        inside = (x >= 0) & (x < size) & (y >= 0) & (y < size)
        depth = shadow[np.clip(y, 0, size - 1), np.clip(x, 0, size - 1)]
        total += ~inside | (place[:, 2] < depth + bias)
    return total / (_SOFT * _SOFT)


def _openness(depth: Array, camera: _View) -> Array:
    """Return the ambient openness of pixels: less in corners and gaps, shape (size, size)."""
    from scipy.ndimage import uniform_filter

    result = np.ones_like(depth)
    for width, strength in ((9, 0.5), (31, 0.35)):
        reach = width / camera.scale
        around = uniform_filter(depth, width, mode="nearest")
        result *= 1.0 - strength * np.clip((depth - around) / reach, 0.0, 1.0)
    return result


def _pixels(mask: Mask) -> tuple[Array, Array]:
    """Return the centers of the pixels of a mask: to the right and up."""
    row, column = np.nonzero(mask)
    return np.asarray(column + 0.5, float), np.asarray(row + 0.5, float)


def _dot(points: Array, axis: Array) -> Array:
    return np.asarray(points[..., 0] * axis[0] + points[..., 1] * axis[1] + points[..., 2] * axis[2])


def _unit(vectors: Array) -> Array:
    length = np.sqrt(np.sum(vectors * vectors, axis=-1, keepdims=True))
    return np.asarray(vectors / np.where(length > 0.0, length, 1.0))
