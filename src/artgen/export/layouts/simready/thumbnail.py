"""Thumbnail of an asset for a package, drawn without a graphics library, equal on all machines."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array, Indices
from artgen.asset import Asset
from artgen.materials import Material
from artgen.materials.textures.bake import displayed

_GRID = 16
"""Grid positions of corners within a pixel, in each direction."""

NOTHING = -1
"""Number for pixels without a triangle."""


@dataclass(frozen=True, eq=False)
class Seen:
    """The visible triangle and depth at each pixel."""

    owner: Indices  # number of the triangle, `NOTHING` without one, shape (size, size)
    depth: Array  # depth along the view, infinite without a triangle, shape (size, size) [m]


def rasterize(corners: Array, size: int) -> Seen:
    """Find the nearest front-facing triangle at each pixel."""
    grid = np.rint(corners[:, :, :2] * _GRID).astype(np.int64)
    facing = np.flatnonzero(_doubled_area(grid) > 0)
    number, row = _rows(grid[facing], size)
    first, last = _spans(grid[facing][number], row, size)
    kept = last >= first
    number, row, first, last = number[kept], row[kept], first[kept], last[kept]
    count = last - first + 1
    column = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count) + np.repeat(first, count)
    number, row = np.repeat(number, count), np.repeat(row, count)
    depth = _depths(corners[facing], grid[facing], number, column, row)
    pixel = row * size + column
    nearest = np.full(size * size, np.inf)
    np.minimum.at(nearest, pixel, depth)
    front = depth == nearest[pixel]
    owner = np.full(size * size, len(corners), np.int64)
    np.minimum.at(owner, pixel[front], facing[number[front]])
    owner[owner == len(corners)] = NOTHING
    return Seen(owner.reshape(size, size), nearest.reshape(size, size))


def weights(corners: Array, column: Array, row: Array) -> Array:
    """Return the barycentric weights of the corners of a triangle at the center of a pixel, shape (n, 3)."""
    x, y = corners[:, :, 0], corners[:, :, 1]
    px, py = (column + 0.5)[:, None], (row + 0.5)[:, None]
    ahead, behind = np.roll(np.arange(3), -1), np.roll(np.arange(3), 1)
    areas = (x[:, ahead] - px) * (y[:, behind] - py) - (x[:, behind] - px) * (y[:, ahead] - py)
    areas = np.maximum(areas, 0.0)
    total = areas.sum(axis=1, keepdims=True)
    return np.where(total > 0.0, areas / np.where(total > 0.0, total, 1.0), 1.0 / 3.0)


def _doubled_area(grid: Indices) -> Indices:
    one, other = grid[:, 1] - grid[:, 0], grid[:, 2] - grid[:, 0]
    return np.asarray(one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0])


def _rows(grid: Indices, size: int) -> tuple[Indices, Indices]:
    """Return the rows of pixels of each triangle, as number of the triangle and of the row."""
    half = _GRID // 2
    low = np.maximum(-((half - grid[:, :, 1].min(axis=1)) // _GRID), 0)
    high = np.minimum((grid[:, :, 1].max(axis=1) - half) // _GRID, size - 1)
    count = np.maximum(high - low + 1, 0)
    number = np.repeat(np.arange(len(grid)), count)
    row = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count) + np.repeat(low, count)
    return number, row


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
    area = one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0]
    rise_one, rise_other = (corners[:, index, 2] - corners[:, 0, 2] for index in (1, 2))
    to_right = (rise_one * other[:, 1] - rise_other * one[:, 1]) / area
    upwards = (rise_other * one[:, 0] - rise_one * other[:, 0]) / area
    right, up = column + 0.5 - points[number, 0, 0], row + 0.5 - points[number, 0, 1]
    plane: Array = corners[number, 0, 2] + to_right[number] * right + upwards[number] * up
    # slivers have steep planes: clip depths to those of the corners
    nearest, farthest = corners[:, :, 2].min(axis=1), corners[:, :, 2].max(axis=1)
    return np.clip(plane, nearest[number], farthest[number])


SIZE = 256
"""Pixels per side."""

_FINE = 2  # samples per pixel, in each direction
_FILLED = 0.84  # share of the picture that the asset fills
_SHADOW = 384  # samples per side of the view of the key light
_FLOOR = 0.80  # linear grey
_SOFT = 5  # samples per side of the kernel of a shadow's edge


def thumbnail(asset: Asset) -> NDArray[np.uint8]:
    """Draw an asset from the front, right and above, shape (256, 256, 3)."""
    scene = _scene(asset)
    size = SIZE * _FINE
    camera = _fitted(_View.along((-0.62, 1.0, -0.42)), scene.corners, size)
    light = _fitted(_View.along((0.45, 0.62, -1.0)), scene.corners, _SHADOW)
    shadow = rasterize(light.project(scene.corners), _SHADOW)
    picture = _floor(scene, camera, light, shadow, size)
    for clear in (False, True):
        _draw(picture, scene, camera, light, shadow, clear=clear)
    fine = picture.light.reshape(SIZE, _FINE, SIZE, _FINE, 3).mean(axis=(1, 3))
    pixels: NDArray[np.uint8] = np.rint(displayed(fine) * 255.0).astype(np.uint8)[::-1]
    return np.ascontiguousarray(pixels)


@dataclass(frozen=True, eq=False)
class _Scene:
    """The triangles of an asset."""

    corners: Array  # corners, shape (n, 3, 3) [m]
    normals: Array  # normals at the corners, shape (n, 3, 3)
    stuff: Indices  # number of the material of each triangle, shape (n,)
    materials: tuple[Material, ...]  # the materials


@dataclass(frozen=True, eq=False)
class _View:
    """A parallel projection."""

    axes: Array  # right, up and view direction in asset coordinates as rows, shape (3, 3)
    scale: float = 1.0  # pixels per metre
    shift: tuple[float, float] = (0.0, 0.0)  # position of the asset's origin in pixels, to the right and up

    @staticmethod
    def along(direction: tuple[float, float, float]) -> "_View":
        forward = _unit(np.array(direction))
        right = _unit(np.array([forward[1], -forward[0], 0.0]))
        up = np.array(
            [
                right[1] * forward[2] - right[2] * forward[1],
                right[2] * forward[0] - right[0] * forward[2],
                right[0] * forward[1] - right[1] * forward[0],
            ]
        )
        return _View(np.array([right, up, forward]))

    def project(self, points: Array) -> Array:
        """Return pixel coordinates to the right and up, and the depth of points, shape (..., 3)."""
        right, up, depth = (_dot(points, axis) for axis in self.axes)
        return np.stack([right * self.scale + self.shift[0], up * self.scale + self.shift[1], depth], axis=-1)

    def place(self, column: Array, row: Array, depth: Array) -> Array:
        """Return the points in asset coordinates that are visible at pixels, shape (n, 3)."""
        right = (column - self.shift[0]) / self.scale
        up = (row - self.shift[1]) / self.scale
        parts = (right, up, depth)
        return np.asarray(sum(part[:, None] * axis for part, axis in zip(parts, self.axes, strict=True)))


@dataclass(frozen=True, eq=False)
class _Picture:
    """A picture under construction, with its lowest row first."""

    light: Array  # linear RGB, shape (size, size, 3)
    depth: Array  # depth of the drawn surfaces, shape (size, size) [m]


def _scene(asset: Asset) -> _Scene:
    pose = asset.pose()
    corners, normals, stuff = [], [], []
    materials: dict[Material, int] = {}
    for link in asset.links:
        turn, offset = pose[link.name][:3, :3], pose[link.name][:3, 3]
        for surface in link.surfaces:
            mesh = surface.mesh
            # sums of products one by one: matrix products round differently on other machines
            vertices = np.stack([_dot(mesh.vertices, row) for row in turn], axis=-1) + offset
            turned = np.stack([_dot(mesh.normals, row) for row in turn], axis=-1)
            corners.append(np.round(vertices, 7)[mesh.triangles])
            normals.append(turned[mesh.triangles])
            number = materials.setdefault(surface.material, len(materials))
            stuff.append(np.full(len(mesh.triangles), number))
    return _Scene(np.concatenate(corners), np.concatenate(normals), np.concatenate(stuff), tuple(materials))


def _fitted(view: _View, corners: Array, size: int) -> _View:
    """Return a view in which the asset fills the picture."""
    flat = view.project(corners)[..., :2].reshape(-1, 2)
    low, high = flat.min(axis=0), flat.max(axis=0)
    scale = _FILLED * size / max(float((high - low).max()), 1e-6)
    right, up = (0.5 * size - 0.5 * (low + high) * scale).tolist()
    return _View(view.axes, scale, (right, up))


def _floor(scene: _Scene, camera: _View, light: _View, shadow: Seen, size: int) -> _Picture:
    """Return a picture of a bright floor with the asset's shadow."""
    column, row = _pixels(np.ones((size, size), bool))
    flat = camera.place(column, row, np.zeros(len(column)))
    level = float(scene.corners[..., 2].min())
    depth = (level - flat[:, 2]) / camera.axes[2, 2]
    lit = _lit(camera.place(column, row, depth), light, shadow)
    grey = _FLOOR * (0.62 + 0.38 * lit) * (0.94 + 0.12 * row / size)
    colors = grey[:, None] * np.array([1.0, 1.0, 1.01])
    return _Picture(colors.reshape(size, size, 3), depth.reshape(size, size))


def _draw(
    picture: _Picture, scene: _Scene, camera: _View, light: _View, shadow: Seen, *, clear: bool
) -> None:
    """Draw the opaque or the transparent triangles over a picture."""
    opacity = np.array([material.opacity for material in scene.materials])[scene.stuff]
    chosen = np.flatnonzero((opacity < 1.0) == clear)
    corners = camera.project(scene.corners[chosen])
    seen = rasterize(corners, len(picture.depth))
    # the floor hides nothing: rounding may put things slightly below it
    nearer = (seen.owner != NOTHING) & ((seen.depth < picture.depth) | (not clear))
    column, row = _pixels(nearer)
    owner = seen.owner[nearer]
    share = weights(corners[owner], column - 0.5, row - 0.5)
    normals = _unit(np.sum(scene.normals[chosen][owner] * share[:, :, None], axis=1))
    points = camera.place(column, row, seen.depth[nearer])
    lit = _lit(points + (2.0 / light.scale) * normals, light, shadow)
    stuff = scene.stuff[chosen][owner]
    colors = _shaded(scene, stuff, normals, camera.axes[2], -light.axes[2], lit)
    if clear:
        cover = opacity[chosen][owner][:, None]
        colors = cover * colors + (1.0 - cover) * picture.light[nearer]
    else:
        colors *= _openness(np.where(nearer, seen.depth, picture.depth), camera)[nearer][:, None]
        picture.depth[nearer] = seen.depth[nearer]
    picture.light[nearer] = colors


def _shaded(scene: _Scene, stuff: Indices, normals: Array, view: Array, light: Array, lit: Array) -> Array:
    """Return the light from surfaces to the viewer, shape (n, 3)."""
    color, emission = (
        np.array([getattr(material, name) for material in scene.materials])[stuff]
        for name in ("base_color", "emission")
    )
    metal, rough = (
        np.array([getattr(material, name) for material in scene.materials])[stuff]
        for name in ("base_metalness", "specular_roughness")
    )
    sky = 0.5 + 0.5 * normals[:, 2]
    key = np.maximum(_dot(normals, light), 0.0) * lit
    fill = np.maximum(_dot(normals, _unit(np.array([0.9, -0.5, 0.2]))), 0.0)
    diffuse = 0.30 + 0.28 * sky + 0.55 * key + 0.10 * fill
    facing = np.clip(-_dot(normals, view), 0.0, 1.0)
    mirrored = view + 2.0 * facing[:, None] * normals
    glow = _studio(mirrored, light, rough) * (0.55 + 0.45 * lit)
    edge = (1.0 - facing) ** 5 * (1.0 - rough)
    mirror = metal[:, None] * color + (1.0 - metal[:, None]) * 0.04
    mirror = mirror + (1.0 - mirror) * edge[:, None]
    body = (1.0 - metal[:, None]) * color * diffuse[:, None]
    return np.asarray(body + mirror * glow[:, None] + emission)


def _studio(direction: Array, light: Array, rough: Array) -> Array:
    """Return the light from a direction: a bright ceiling, a lamp, a grey floor."""
    rise = direction[:, 2]
    sharp = np.clip(0.5 + rise / (0.25 + rough), 0.0, 1.0)
    smooth = sharp * sharp * (3.0 - 2.0 * sharp)
    lamp = np.clip(_dot(direction, light), 0.0, 1.0) ** 8
    return np.asarray(0.30 + 0.75 * smooth + 0.9 * lamp * (1.0 - 0.6 * rough))


def _lit(points: Array, light: _View, shadow: Seen) -> Array:
    """Return the share of the key light that reaches points, shape (n,)."""
    size = len(shadow.depth)
    place = light.project(points)
    column, row = (np.floor(place[:, axis]).astype(np.int64) for axis in (0, 1))
    bias = 3.0 / light.scale  # soft edges sample around the point
    reach = range(-(_SOFT // 2), _SOFT // 2 + 1)
    total = np.zeros(len(points))
    for right in reach:
        for up in reach:
            x, y = column + right, row + up
            inside = (x >= 0) & (x < size) & (y >= 0) & (y < size)
            depth = shadow.depth[np.clip(y, 0, size - 1), np.clip(x, 0, size - 1)]
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


def _pixels(mask: NDArray[np.bool_]) -> tuple[Array, Array]:
    """Return the centers of the pixels of a mask: to the right and up."""
    row, column = np.nonzero(mask)
    return np.asarray(column + 0.5, float), np.asarray(row + 0.5, float)


def _dot(points: Array, axis: Array) -> Array:
    return np.asarray(points[..., 0] * axis[0] + points[..., 1] * axis[1] + points[..., 2] * axis[2])


def _unit(vectors: Array) -> Array:
    length = np.sqrt(np.sum(vectors * vectors, axis=-1, keepdims=True))
    return np.asarray(vectors / np.where(length > 0.0, length, 1.0))
