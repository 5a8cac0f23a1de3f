"""Rounding of an asset to the digits that files keep: all files agree, and a loaded asset is the same."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import ClassVar

import numpy as np

from artgen._arrays import Array, cached, cached_property
from artgen.asset.link import Collider, DerivedLink, Link, Surface
from artgen.asset.mass import MassProperties
from artgen.asset.record import rounded, rounded_coordinates
from artgen.asset.shape import Mesh
from artgen.asset.surface import joined, metric_coordinates, texture_coordinates
from artgen.colliders import Convex
from artgen.materials import Material

POSITION_DECIMALS = 7
"""Decimals of the vertices of surfaces in files, in the frame of their link: 0.1 micrometre."""

NORMAL_DECIMALS = 5
"""Decimals of the normals of surfaces in files."""

UV_DECIMALS = 6
"""Decimals of the texture coordinates of surfaces in files, in repeats of the maps."""


def rounded_links(links: Iterable[Link], origins: Mapping[str, Array]) -> tuple[Link, ...]:
    """Return links rounded to the digits that files keep; links that were read from files stay.

    Args:
        links: The links.
        origins: Origin of the frame of each link by its name, shape (3,) [m].
    """
    return tuple(
        link
        if link.rounded
        else replace(
            RoundedLink.of(link, origin=origins[link.name]),
            grasps=rounded(link.grasps),
            pushes=rounded(link.pushes),
        )
        for link in links
    )


@dataclass(frozen=True, eq=False)
class RoundedLink(DerivedLink):
    """A link rounded to the digits that files keep."""

    rounded: ClassVar = True

    origin: Array = field(kw_only=True)  # of its frame in asset coordinates at rest, shape (3,) [m]

    @cached_property
    def mass_properties(self) -> MassProperties:
        """Mass, center and inertia of the source, rounded."""
        properties: MassProperties = rounded(self.source.mass_properties)
        return properties

    @cached_property
    def colliders(self) -> tuple[Collider, ...]:
        """The colliders of the source, rounded."""
        return tuple(
            replace(each, convex=_rounded_convex(each.convex), material=_rounded_material(each.material))
            for each in self.source.colliders
        )

    @cached_property
    def surfaces(self) -> tuple[Surface, ...]:
        """The visible faces of the source, as a loader of the files sees them."""
        return tuple(
            _as_written(surface, self.origin, _rounded_material(surface.material))
            for surface in self.source.surfaces
        )


@cached(256)
def _rounded_material(material: Material) -> Material:
    result: Material = rounded(material)
    return result


def _rounded_convex(convex: Convex) -> Convex:
    """Return a collider rounded to the digits that files keep."""
    size = tuple(map(rounded, convex.size))
    points = convex.points if convex.kind == "hull" else np.empty((0, 3))
    return Convex(convex.kind, rounded_coordinates(convex.pose), size, rounded_coordinates(points))


def _as_written(surface: Surface, origin: Array, material: Material) -> Surface:
    """Return a surface rounded in the frame at `origin` [m], with a material, in the order of files."""
    mesh = rounded_mesh(surface.mesh, origin, material)
    # rounding makes some vertices equal; joining them may move texture coordinates
    mesh = joined([mesh])
    mesh = replace(mesh, uvs=_rounded_uvs(mesh, material))
    return replace(surface, material=material, mesh=_in_order(mesh, origin, material))


def _in_order(mesh: Mesh, origin: Array, material: Material) -> Mesh:
    """Return a mesh with its vertices in the order of a mesh file.

    `joined` sorts them by position, normal and metric texture coordinates; on turned maps the order of the
    written coordinates differs.
    """
    coordinates = texture_coordinates(mesh, material)
    steps = [each[1:] - each[:-1] for each in (mesh.vertices, mesh.normals)]
    alike = ~np.any([each.any(axis=1) for each in steps], axis=0)
    written = np.rint(coordinates * 10.0**UV_DECIMALS)
    u, v = (written[1:] - written[:-1])[alike].T
    if not ((u < 0.0) | (u == 0.0) & (v < 0.0)).any():
        return mesh
    columns = (
        (coordinates, UV_DECIMALS),
        (mesh.normals, NORMAL_DECIMALS),
        (mesh.vertices - origin, POSITION_DECIMALS),  # lexsort: the last keys decide first
    )
    keys = [np.rint(each[:, ::-1].T * 10.0**decimals) for each, decimals in columns]
    order = np.lexsort(np.concatenate(keys))
    return Mesh(
        mesh.vertices[order],
        mesh.normals[order],
        mesh.uvs[order],
        mesh.paints[order],
        np.argsort(order)[mesh.triangles],
    )


def rounded_mesh(
    mesh: Mesh,
    origin: Array,
    material: Material,
    *,
    positions: int = POSITION_DECIMALS,
    normals: int = NORMAL_DECIMALS,
    uvs: int = UV_DECIMALS,
) -> Mesh:
    """Return a mesh rounded to numbers of decimals in the frame of a link at `origin`, shape (3,) [m]."""
    return replace(
        mesh,
        vertices=np.round(mesh.vertices - origin, positions) + 0.0 + origin,
        normals=np.round(mesh.normals, normals) + 0.0,
        uvs=_rounded_uvs(mesh, material, uvs),
    )


def _rounded_uvs(mesh: Mesh, material: Material, decimals: int = UV_DECIMALS) -> Array:
    written = np.round(texture_coordinates(mesh, material), decimals) + 0.0
    return metric_coordinates(written, material)
