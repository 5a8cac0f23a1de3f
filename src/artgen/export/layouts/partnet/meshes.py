"""Meshes of the PartNet-Mobility layout: in coordinates of the whole object, y up, as in the dataset.

Visual meshes lie in `textured_objs`, where readers take every OBJ file as visible; colliders have another
directory.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset, Mesh
from artgen.asset.files import mesh_names
from artgen.export.hulls import Hull
from artgen.export.layouts.partnet.names import UPRIGHT
from artgen.export.maps import TEXTURE_DIRECTORY, map_files
from artgen.export.meshes import hull_texts, mtl_text, surface_text

VISUALS = "textured_objs"
"""Directory of visual meshes with their MTL file and maps."""

COLLIDERS = "convex_objs"
"""Directory of convex pieces."""

_LIBRARY = "materials.mtl"


@dataclass(frozen=True)
class ObjectMeshes:
    """The mesh files of an asset."""

    files: Mapping[str, bytes]  # content by path relative to the asset's directory, maps included
    surfaces: Mapping[str, tuple[str, ...]]  # file name of each surface in the link's order, by link
    # file name of each hull collider, in its own frame, by link and number of the collider
    colliders: Mapping[str, Mapping[int, str]]
    # position of that frame in the dataset's coordinates of the asset, shape (3,) [m]
    middles: Mapping[str, Mapping[int, Array]]


def object_meshes(asset: Asset, textures: int) -> ObjectMeshes:
    """Write the surfaces and hull colliders of all links.

    Args:
        asset: The asset.
        textures: Texels per side of the material maps; 0 for no maps.
    """
    maps = map_files(asset, textures)
    surfaces = mesh_names({link.name: [surface.name for surface in link.surfaces] for link in asset.links})
    shown = [surface for link in asset.links for surface in link.surfaces]
    files = {f"{VISUALS}/{_LIBRARY}": mtl_text([surface.material for surface in shown], maps)}
    for link in asset.links:
        for surface, name in zip(link.surfaces, surfaces[link.name], strict=True):
            content = surface_text(upright(surface.mesh), np.zeros(3), _LIBRARY, surface.material)
            files[f"{VISUALS}/{name}"] = content
    folder = TEXTURE_DIRECTORY.rpartition("/")[2]
    files |= {
        f"{VISUALS}/{folder}/{path.rpartition('/')[2]}": content for path, content in maps.files.items()
    }
    taken = [name for names in surfaces.values() for name in names]
    colliders, middles, pieces = _hull_files(asset, taken)
    return ObjectMeshes(files | pieces, surfaces, colliders, middles)


def upright(mesh: Mesh) -> Mesh:
    """Return a mesh in the dataset's coordinates."""
    return replace(mesh, vertices=mesh.vertices @ UPRIGHT.T, normals=mesh.normals @ UPRIGHT.T)


def _hull_files(
    asset: Asset, taken: list[str]
) -> tuple[dict[str, dict[int, str]], dict[str, dict[int, Array]], dict[str, bytes]]:
    numbers = {
        link.name: [number for number, item in enumerate(link.colliders) if item.convex.kind == "hull"]
        for link in asset.links
    }
    names = mesh_names(
        {link: [f"collider_{number}" for number in found] for link, found in numbers.items()}, taken
    )
    hulls = Hull.of(
        [
            (asset.link(link).colliders[number].convex, np.zeros(3))
            for link, found in numbers.items()
            for number in found
        ]
    )
    # a quarter turn only swaps and negates rounded coordinates, so the pieces stay convex
    texts = hull_texts([replace(hull, vertices=hull.vertices @ UPRIGHT.T) for hull in hulls])
    paths = [f"{COLLIDERS}/{name}" for found in names.values() for name in found]
    by_number = {link: dict(zip(found, names[link], strict=True)) for link, found in numbers.items()}
    turned = iter(UPRIGHT @ hull.middle for hull in hulls)
    middles = {link: {number: next(turned) for number in found} for link, found in numbers.items()}
    return by_number, middles, dict(zip(paths, texts, strict=True))
