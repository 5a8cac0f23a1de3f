"""How exported assets look, as readers that are not artgen's find them: triangles, texture and shading.

A `View` of an asset is a soup of triangles in asset coordinates at rest, each with what shades it. Views of
different formats are compared where the same rays first hit them. Colors are displayed (sRGB) ones in grey
levels, 0..255; v grows upwards, and a map's first row is its top.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
import trimesh
from numpy.typing import NDArray
from trimesh.ray.ray_pyembree import RayMeshIntersector

from artgen.asset import Asset
from artgen.asset.surface import texture_coordinates
from artgen.materials import Material
from artgen.materials.textures import kinds, maps

Array = NDArray[np.float64]

_SAME = 2e-5  # [m]: of two faces as near to each other either may be hit


def displayed(linear: Array) -> Array:
    """Encode linear values as sRGB."""
    linear = np.clip(linear, 0.0, 1.0)
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)


@dataclass(frozen=True, eq=False)
class Channel:
    """A property of a surface: a factor times a map that repeats.

    Attributes:
        factor: As the map is encoded, shape (k,).
        pixels: The map, 0..1, shape (h, w, k); None where there is none.
    """

    factor: Array
    pixels: Array | None = None

    def at(self, uvs: Array) -> Array:
        """Return the values at texture coordinates, shape (n, 2), bilinear between texels; shape (n, k)."""
        if self.pixels is None:
            return np.broadcast_to(self.factor, (len(uvs), len(self.factor)))
        height, width = self.pixels.shape[:2]
        x, y = uvs[:, 0] * width - 0.5, (1.0 - uvs[:, 1]) * height - 0.5
        left, top = np.floor(x).astype(np.int64), np.floor(y).astype(np.int64)
        right_share, low_share = (x - left)[:, None], (y - top)[:, None]
        columns, rows = (left % width, (left + 1) % width), (top % height, (top + 1) % height)
        upper, lower = (
            (1.0 - right_share) * self.pixels[row, columns[0]] + right_share * self.pixels[row, columns[1]]
            for row in rows
        )
        return np.asarray(self.factor * ((1.0 - low_share) * upper + low_share * lower))


def constant(*values: float) -> Channel:
    """Return a channel without a map."""
    return Channel(np.array(values, float))


def mapped(pixels: NDArray[np.uint8] | Array, *factor: float) -> Channel:
    """Return a channel with a map of bytes, shape (h, w) or (h, w, k)."""
    values = np.asarray(pixels, float) / 255.0
    values = values.reshape(*values.shape[:2], -1)
    return Channel(np.array(factor or [1.0] * values.shape[2], float), values)


@dataclass(frozen=True, eq=False)
class Look:
    """What shades a surface.

    Attributes:
        color: Base color, sRGB.
        roughness: GGX roughness.
        metalness: Share of bare metal.
        opacity: 1 is opaque.
        emission: Linear RGB.
        normal: Tangent space, 0..1, y towards greater v; flat where there is no map.
    """

    color: Channel
    roughness: Channel
    metalness: Channel
    opacity: Channel = field(default_factory=lambda: constant(1.0))
    emission: Channel = field(default_factory=lambda: constant(0.0, 0.0, 0.0))
    normal: Channel = field(default_factory=lambda: constant(128 / 255, 128 / 255, 1.0))


LEVELS = {
    "color": 255.0,
    "roughness": 255.0,
    "metalness": 255.0,
    "opacity": 255.0,
    "emission": 255.0,
    "normal": 255.0,
}
"""The properties of a look, and how many grey levels they have."""


@dataclass(frozen=True, eq=False)
class Part:
    """Triangles of one link that are shaded alike.

    Attributes:
        link: Name of the link.
        corners: Positions at rest, in asset coordinates, shape (m, 3, 3) [m].
        uvs: Texture coordinates in repeats of the maps, shape (m, 3, 2).
        normals: Unit normals, shape (m, 3, 3).
        look: What shades them.
    """

    link: str
    corners: Array
    uvs: Array
    normals: Array
    look: Look


@dataclass(frozen=True, eq=False)
class Hits:
    """What rays hit first; rows of rays that hit nothing are not numbers.

    Attributes:
        part: Number of the part, -1 for none, shape (n,).
        points: Shape (n, 3) [m].
        faces: Outward normal of the face by its winding, shape (n, 3).
        normals: Normal that shades it, shape (n, 3).
        uvs: Texture coordinates, shape (n, 2).
        looks: Each property of the look in grey levels, shape (n, k).
    """

    part: NDArray[np.int64]
    points: Array
    faces: Array
    normals: Array
    uvs: Array
    looks: dict[str, Array]


@dataclass(frozen=True, eq=False)
class View:
    """An asset as a reader sees it.

    Attributes:
        name: The reader.
        parts: All that is seen.
    """

    name: str
    parts: Sequence[Part]

    @cached_property
    def corners(self) -> Array:
        """All triangles, shape (m, 3, 3) [m]."""
        return np.concatenate([part.corners for part in self.parts])

    @cached_property
    def owner(self) -> NDArray[np.int64]:
        """The part of each triangle, shape (m,)."""
        return np.repeat(np.arange(len(self.parts)), [len(part.corners) for part in self.parts])

    @cached_property
    def _intersector(self) -> RayMeshIntersector:
        soup = trimesh.Trimesh(
            self.corners.reshape(-1, 3), np.arange(3 * len(self.corners)).reshape(-1, 3), process=False
        )
        return RayMeshIntersector(soup)

    def cast(self, origins: Array, directions: Array) -> Hits:
        """Return what rays, both shape (n, 3), hit first."""
        triangle, struck = self._intersector.intersects_id(
            origins, directions, multiple_hits=False, return_locations=False
        )
        weights = _weights(self.corners[triangle], origins[struck], directions[struck])
        count = len(origins)
        part = np.full(count, -1)
        part[struck] = self.owner[triangle]
        weight = weights[:, :, None]
        flat = self.corners[triangle]
        across = np.cross(flat[:, 1] - flat[:, 0], flat[:, 2] - flat[:, 0])
        result = {
            "points": (weight * flat).sum(axis=1),
            "faces": across / np.linalg.norm(across, axis=1, keepdims=True),
            "normals": (weight * np.concatenate([each.normals for each in self.parts])[triangle]).sum(axis=1),
            "uvs": (weight * np.concatenate([each.uvs for each in self.parts])[triangle]).sum(axis=1),
        }
        full = {name: np.full((count, values.shape[1]), np.nan) for name, values in result.items()}
        for name, values in result.items():
            full[name][struck] = values
        return Hits(part=part, looks=self._looks(part, full["uvs"]), **full)

    def clear(self, points: Array) -> NDArray[np.bool_]:
        """Tell at which points, shape (n, 3), one face alone lies: no edge, and no face upon the other."""
        low, high = self.corners.min(axis=1) - _SAME, self.corners.max(axis=1) + _SAME
        near = np.zeros(len(points), np.int64)
        for number, point in enumerate(points):
            inside = ((low <= point) & (point <= high)).all(axis=1)
            found = self.corners[inside]
            closest = trimesh.triangles.closest_point(found, np.broadcast_to(point, (len(found), 3)))
            near[number] = (np.linalg.norm(closest - point, axis=1) < _SAME).sum()
        return near == 1

    def _looks(self, part: NDArray[np.int64], uvs: Array) -> dict[str, Array]:
        looks = {name: np.full((len(part), 3), np.nan) for name in LEVELS}
        for number in np.unique(part[part >= 0]):
            rows = np.flatnonzero(part == number)
            for name, levels in LEVELS.items():
                values = getattr(self.parts[number].look, name).at(uvs[rows])
                looks[name][rows] = levels * np.broadcast_to(values, (len(rows), 3))
        return looks


def _weights(corners: Array, origins: Array, directions: Array) -> Array:
    """Return barycentric weights, shape (n, 3), of where rays cross the planes of triangles."""
    a, b, c = corners[:, 0], corners[:, 1], corners[:, 2]
    normal = np.cross(b - a, c - a)
    distance = ((a - origins) * normal).sum(axis=1) / (directions * normal).sum(axis=1)
    point = origins + distance[:, None] * directions
    size = (normal * normal).sum(axis=1)
    weights = [
        (np.cross(second - first, point - first) * normal).sum(axis=1) / size
        for first, second in ((b, c), (c, a), (a, b))
    ]
    return np.stack(weights, axis=1)


def expected_view(asset: Asset, size: int) -> View:
    """Return how an asset is meant to look: what the files must show, from its data alone."""
    parts = []
    for link in asset.links:
        for surface in link.surfaces:
            mesh = surface.mesh
            uvs = texture_coordinates(mesh, surface.material)
            parts.append(
                Part(
                    link.name,
                    mesh.vertices[mesh.triangles],
                    uvs[mesh.triangles],
                    mesh.normals[mesh.triangles],
                    expected_look(surface.material, size),
                )
            )
    return View("asset", parts)


def expected_look(material: Material, size: int) -> Look:
    """Return how a material is meant to look with maps of that many texels on a side; 0 for none."""
    plain = Look(
        constant(*displayed(np.array(material.base_color))),
        constant(material.specular_roughness),
        constant(material.base_metalness),
        constant(material.opacity),
        constant(*material.emission),
    )
    if not size or not kinds(material):
        return plain
    found = maps(material, size)
    return Look(
        plain.color if found.albedo is None else mapped(found.albedo),
        mapped(found.roughness),
        plain.metalness if found.metalness is None else mapped(found.metalness),
        plain.opacity,
        plain.emission,
        plain.normal if found.normal is None else mapped(found.normal),
    )


def random_rays(view: View, count: int, seed: int) -> tuple[Array, Array]:
    """Return rays from around an asset to random points of its surfaces, both shape (count, 3).

    Every part gets its share, however small it is.
    """
    draw = np.random.default_rng(seed)
    number = draw.integers(len(view.parts), size=count)
    half = number[: count // 2]
    areas = np.linalg.norm(
        np.cross(view.corners[:, 1] - view.corners[:, 0], view.corners[:, 2] - view.corners[:, 0]), axis=1
    )
    triangle = draw.choice(len(areas), size=count, p=areas / areas.sum())
    for row, part in enumerate(half):
        own = np.flatnonzero(view.owner == part)
        triangle[row] = draw.choice(own, p=areas[own] / areas[own].sum())
    weights = draw.dirichlet([1.0, 1.0, 1.0], size=count)
    targets = np.einsum("nk,nkc->nc", weights, view.corners[triangle])
    flat = view.corners[triangle]
    outward = np.cross(flat[:, 1] - flat[:, 0], flat[:, 2] - flat[:, 0])
    outward /= np.linalg.norm(outward, axis=1, keepdims=True)
    directions = -outward + 0.6 * draw.normal(size=(count, 3))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    reach = 2.0 * float(np.linalg.norm(np.ptp(view.corners.reshape(-1, 3), axis=0)))
    return targets - reach * directions, directions
