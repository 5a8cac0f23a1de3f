"""Rays against the surfaces of a picture, by Embree, and the light that each triangle scatters."""

import math
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array
from artgen.asset.shape import Mesh
from artgen.asset.surface import texture_coordinates
from artgen.errors import RenderError, needed
from artgen.materials import Material
from artgen.view.studio import BOXES, POINTS, Backdrop, Floats, dome, lamp_points, light_of, spread

_OFFSET = 2e-4  # start of secondary rays above a surface, relative to the asset's radius
_RAYS = 200_000  # rays of all triangles, more for larger ones
_FEWEST, _MOST = 4, 64  # rays of a triangle
_PASSES = 2  # bounces of the scattered light
THREADS = 2  # threads of a picture
_TRACED = 4096  # triangles whose light one of them traces at once


@dataclass(frozen=True, eq=False)
class Hits:
    """The first hits of rays."""

    surfaces: NDArray[np.int32]  # number of the surface that each ray hits from 1, 0 for none, shape (n,)
    distance: Array  # distance in lengths of the direction, infinite without a hit, shape (n,)
    normals: Array  # unit normals, interpolated over the triangles; zero for none, shape (n, 3)
    # number of the triangle among those of all surfaces, -1 for none, shape (n,)
    triangles: NDArray[np.int64]
    shares: Array  # barycentric coordinates of the hit in its triangle, shape (n, 3)


def embree_scene(corners: Floats) -> Any:
    """Return an Embree scene of triangles, shape (m, 3, 3).

    Raises:
        RenderError: Embree is not installed.
    """
    text = 'pictures are drawn with Embree, which cannot be loaded ({error}): pip install "artgen[sim]"'
    with needed(text, RenderError):
        from embreex.mesh_construction import TriangleMesh
        from embreex.rtcore_scene import EmbreeScene
    scene = EmbreeScene()
    TriangleMesh(scene, np.ascontiguousarray(corners, np.float32))
    return scene


def cast(meshes: Sequence[Mesh], origin: Array, directions: Array) -> Hits:
    """Return the first hits of rays from one point, with directions of shape (..., 3).

    Raises:
        RenderError: Embree is not installed.
    """
    corners = np.concatenate([mesh.vertices[mesh.triangles] for mesh in meshes])
    normals = np.concatenate([mesh.normals[mesh.triangles] for mesh in meshes])
    surface = np.repeat(np.arange(1, len(meshes) + 1), [len(mesh.triangles) for mesh in meshes])
    # Embree uses single precision: its coordinates have their origin at the origin of the rays
    scene = embree_scene(corners - origin)
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


def dot(a: Sequence[Floats] | Floats, b: Sequence[Floats] | Floats) -> Floats:
    """Return the dot products of vectors, given as rows of x, y and z; shape (n,)."""
    return np.asarray(a[0] * b[0] + a[1] * b[1] + a[2] * b[2])


def unit(a: Floats) -> Floats:
    """Return vectors of length 1."""
    return np.asarray(a * (1.0 / np.sqrt(np.maximum(dot(a, a), np.float32(1e-20)))))


def mirrored(direction: Floats, normal: Floats) -> Floats:
    """Return the directions of rays after a mirror."""
    return np.asarray(direction - 2.0 * dot(direction, normal) * normal)


def turned(local: Floats, axis: Floats) -> Floats:
    """Return vectors, given in frames with the third axis at `axis`, in the frame of all."""
    x, y, z = axis
    sign = np.where(z >= 0.0, np.float32(1.0), np.float32(-1.0))
    a = -1.0 / (sign + z)
    b = x * y * a
    u, v, w = local
    return np.stack(
        [
            u * (1.0 + sign * x * x * a) + v * b + w * x,
            u * (sign * b) + v * (sign + y * y * a) + w * y,
            -u * (sign * x) - v * y + w * z,
        ]
    )


@lru_cache(maxsize=1)
def cosine_lobe() -> Floats:
    """Return directions about the third axis, more along it, shape (3, `POINTS`)."""
    across, around = spread(POINTS)
    radius, turn = np.sqrt(across), 2.0 * math.pi * around
    return np.stack([radius * np.cos(turn), radius * np.sin(turn), np.sqrt(1.0 - across)]).astype(np.float32)


class World:
    """The surfaces of a picture in studio coordinates, with the asset's center as the origin.

    Attributes:
        place: The surroundings.
        materials: Each material once.
        material: For each triangle the number of its material, shape (m,).
        solid: For each triangle whether it lets no light through, shape (m,); these are the first ones.
        curvature: For each triangle the most change of its normal, shape (m,) [1/m].
        glow: For each triangle the light that it scatters and emits, shape (m, 3).
    """

    def __init__(self, surfaces: Sequence[tuple[Mesh, Material]], place: Backdrop) -> None:
        """Trace the scattered light."""
        surfaces = sorted(surfaces, key=lambda each: clear(each[1]))
        self.place = place
        self.materials = list(dict.fromkeys(material for _, material in surfaces))
        number = {material: index for index, material in enumerate(self.materials)}
        counts = [len(mesh.triangles) for mesh, _ in surfaces]
        self.material = np.repeat([number[material] for _, material in surfaces], counts)
        self.solid = ~np.array([clear(material) for material in self.materials])[self.material]
        starts = np.cumsum([0, *(len(mesh.vertices) for mesh, _ in surfaces)])
        self._vertex = np.concatenate(
            [mesh.triangles + start for (mesh, _), start in zip(surfaces, starts, strict=False)]
        )
        vertices = np.concatenate([mesh.vertices for mesh, _ in surfaces]) - place.center
        self.corners = vertices.astype(np.float32)[self._vertex]
        self._normals = np.concatenate([mesh.normals for mesh, _ in surfaces]).astype(np.float32)
        self._uvs = np.concatenate([texture_coordinates(*each) for each in surfaces]).astype(np.float32)
        first, second = self.corners[:, 1] - self.corners[:, 0], self.corners[:, 2] - self.corners[:, 0]
        across = np.cross(first, second)
        size = np.linalg.norm(across, axis=1)
        self.flat = across / np.maximum(size, 1e-30)[:, None]
        self._areas = size / 2.0
        self.tangents = self._tangents(first, second)
        self.curvature = self._curvature()
        self.offset = np.float32(_OFFSET * place.radius)
        self.all = embree_scene(self.corners)
        self.opaque = self.all if self.solid.all() else embree_scene(self.corners[self.solid])
        self._scatter()

    def _tangents(self, first: Floats, second: Floats) -> Floats:
        """Return the direction of the texture's u axis on each triangle, shape (m, 3)."""
        uvs = self._uvs[self._vertex]
        one, other = uvs[:, 1] - uvs[:, 0], uvs[:, 2] - uvs[:, 0]
        along = first * other[:, 1:] - second * one[:, 1:]
        area = one[:, :1] * other[:, 1:] - one[:, 1:] * other[:, :1]
        along *= np.where(area < 0.0, -1.0, 1.0)
        length = np.linalg.norm(along, axis=1, keepdims=True)
        return np.asarray(along / np.maximum(length, 1e-30), np.float32)

    def _curvature(self) -> Floats:
        """Return the most change of the normal along the edges of each triangle, shape (m,) [1/m]."""
        normals = self._normals[self._vertex]
        change, long = (np.linalg.norm(each - each[:, [1, 2, 0]], axis=2) for each in (normals, self.corners))
        return np.asarray((change / np.maximum(long, 1e-9)).max(axis=1), np.float32)

    def run(self, scene: Any, origin: Floats, direction: Floats) -> dict[str, NDArray[Any]]:
        """Return the first hits of rays: `primID`, `tfar`, `u` and `v`."""
        found: dict[str, NDArray[Any]] = scene.run(
            np.ascontiguousarray(origin.T), np.ascontiguousarray(direction.T), output=True
        )
        return found

    def first(self, origin: Floats, direction: Floats) -> NDArray[Any]:
        """Return the first opaque triangles on rays, -1 for none, shape (n,)."""
        return np.asarray(self.opaque.run(np.ascontiguousarray(origin.T), np.ascontiguousarray(direction.T)))

    def free(self, scene: Any, origin: Floats, path: Floats) -> NDArray[np.bool_]:
        """Tell which paths are free, shape (n,)."""
        reach = np.full(origin.shape[1], 1.0, np.float32)
        found = scene.run(
            np.ascontiguousarray(origin.T), np.ascontiguousarray(path.T), dists=reach, query="OCCLUDED"
        )
        return np.asarray(found) < 0

    def lamp_light(self, origin: Floats, normal: Floats) -> Floats:
        """Return the light of each lamp on white paper at open places, shape (lamps, n)."""
        return np.stack([light_of(box, origin, normal, self.place.radius) for box in BOXES])

    def hidden(self, origin: Floats, normal: Floats, light: Floats, number: NDArray[Any]) -> Floats:
        """Return the part of the light of all lamps that does not arrive, seen from one point of a lamp.

        Args:
            origin: Places, shape (3, n) [m].
            normal: Unit normals there.
            light: The light of each lamp, shape (lamps, n).
            number: Number of the point on the lamps for each place, shape (n,).
        """
        path = np.float32(self.place.radius) * lamp_points()[number].T - origin
        lost = len(BOXES) * light[number % len(BOXES), np.arange(len(number))]
        some = np.flatnonzero((lost > 0.0) & (dot(path, normal) > 0.0))
        free = some[self.free(self.opaque, origin[:, some], path[:, some])]
        lost[free] = 0.0
        return np.asarray(lost, np.float32)

    def at_hits(self, values: Floats, triangle: NDArray[Any], u: Floats, v: Floats) -> Floats:
        """Return values of vertices, shape (k, c), interpolated at hits, shape (c, n)."""
        a, b, c = self._vertex[triangle].T
        return np.asarray(
            ((1.0 - u - v)[:, None] * values[a] + u[:, None] * values[b] + v[:, None] * values[c]).T
        )

    def normals_at(self, triangle: NDArray[Any], u: Floats, v: Floats) -> Floats:
        """Return the smooth unit normals at hits."""
        return unit(self.at_hits(self._normals, triangle, u, v))

    def uvs_at(self, triangle: NDArray[Any], u: Floats, v: Floats) -> Floats:
        """Return the texture coordinates at hits, shape (2, n)."""
        return self.at_hits(self._uvs, triangle, u, v)

    def glow_at(self, triangle: NDArray[Any], u: Floats, v: Floats) -> Floats:
        """Return the light that surfaces scatter and emit at hits."""
        return self.at_hits(self._vertex_glow, triangle, u, v)

    def light_at(self, triangle: NDArray[Any], u: Floats, v: Floats) -> Floats:
        """Return the light that arrives at surfaces at hits: radiance of white paper there."""
        return self.at_hits(self._vertex_light, triangle, u, v)

    def _scatter(self) -> None:
        """Trace the light that each triangle scatters."""
        count = len(self.corners)
        size = np.sqrt(self._areas)
        # each lamp has as many of them
        rays = 4 * np.rint(np.clip(_RAYS * size / size.sum(), _FEWEST, _MOST) / 4.0).astype(int)
        starts = np.cumsum(rays) - rays
        color = np.array([each.base_color for each in self.materials], np.float32)
        # metal and glass scatter little, but what they mirror lights others as well
        emitted = np.array([each.emission for each in self.materials], np.float32)[self.material]
        albedo = color[self.material]
        with ThreadPoolExecutor(THREADS) as pool:
            traced = list(
                pool.map(
                    lambda first: self._arriving(first, rays[first:][:_TRACED]), range(0, count, _TRACED)
                )
            )
        found, direct = (np.concatenate(each) for each in zip(*traced, strict=True))
        light = np.repeat(direct[:, None], 3, axis=1)
        arriving = light
        for _ in range(_PASSES):
            scattered = albedo * arriving + emitted
            gathered = np.where(found[:, None] >= 0, scattered[found], np.float32(0.0))
            arriving = light + np.add.reduceat(gathered, starts) / rays[:, None]
        weights = np.repeat(self._areas, 3)
        total = np.bincount(self._vertex.ravel(), weights, len(self._normals))
        smooth = [
            np.bincount(self._vertex.ravel(), np.repeat(each * self._areas, 3), len(self._normals))
            for each in arriving.T
        ]
        vertex = (np.stack(smooth) / np.maximum(total, 1e-30)).T.astype(np.float32)
        of_vertex = np.zeros(len(self._normals), np.int64)
        of_vertex[self._vertex.ravel()] = np.repeat(self.material, 3)
        self._vertex_light = vertex
        glowing = np.array([each.emission for each in self.materials], np.float32)[of_vertex]
        self._vertex_glow = np.asarray(color[of_vertex] * vertex + glowing, np.float32)
        self.glow = np.asarray(self._vertex_glow[self._vertex].mean(axis=1), np.float32)

    def _arriving(self, first: int, rays: NDArray[Any]) -> tuple[NDArray[Any], Floats]:
        """Return what rays from some triangles meet, -1 for the studio, and the light from outside."""
        triangle = np.repeat(first + np.arange(len(rays)), rays)
        starts = np.cumsum(rays) - rays
        number = (np.arange(len(triangle)) - np.repeat(starts, rays) + 37 * triangle) % POINTS
        across, along = spread(POINTS)[:, number].astype(np.float32)
        a, b = np.sqrt(across), np.sqrt(across) * along
        corner = self.corners[triangle]
        normal = self.flat[triangle].T
        origin = (1.0 - a) * corner[:, 0].T + (a - b) * corner[:, 1].T + b * corner[:, 2].T
        origin = origin + self.offset * normal
        number = (number * 5 + 11) % POINTS
        path = turned(cosine_lobe()[:, number], normal)
        found = self.first(origin, path)
        lamps = self.lamp_light(origin, normal)
        direct = np.where(found < 0, dome(path[2]), 0.0) + lamps.sum(axis=0)
        direct -= self.hidden(origin, normal, lamps, number)
        return found, (np.add.reduceat(direct, starts) / rays).astype(np.float32)


def clear(material: Material) -> bool:
    """Tell whether a material lets light through."""
    return material.transmission_weight > 0.0 or material.opacity < 1.0
