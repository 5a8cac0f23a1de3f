"""Mesh files that URDF and MJCF share: OBJ surfaces in their link's frame, colliders, one MTL, maps."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from artgen._arrays import Array, Indices
from artgen._caching import FrozenArrays, cached
from artgen.asset import Asset, Mesh
from artgen.asset.files import (
    MESH_DIRECTORY,
    NORMAL_DECIMALS,
    POSITION_DECIMALS,
    UV_DECIMALS,
    mesh_names,
)
from artgen.asset.surface import texture_coordinates
from artgen.export.hulls import HULL_DECIMALS, Hull, hulls
from artgen.export.maps import TEXTURE_DIRECTORY, MapFiles, map_files
from artgen.export.number_text import face_lines, lines, rounded, text
from artgen.export.phong import phong_exponent, specular_color
from artgen.materials import Material
from artgen.materials.textures import Kind, displayed


@dataclass(frozen=True)
class MeshFiles(FrozenArrays):
    """The mesh files of an asset.

    Attributes:
        files: Content by path relative to the asset's directory, maps included.
        surfaces: File name of each surface, by link, in the link's order.
        colliders: File name of each collider, by link and number of the collider; hulls only, each in its own
            frame.
        middles: Where that frame lies in the link's, shape (3,) [m].
        maps: The maps of the materials, which lie in `textures/` beside the meshes.
    """

    files: Mapping[str, bytes]
    surfaces: Mapping[str, tuple[str, ...]]
    colliders: Mapping[str, Mapping[int, str]]
    middles: Mapping[str, Mapping[int, Array]]
    maps: MapFiles

    @staticmethod
    def path(name: str) -> str:
        """Return where a mesh file lies, relative to the asset's directory."""
        return f"{MESH_DIRECTORY}/{name}"


@cached(1)  # two formats are written of one asset after another
def mesh_files(asset: Asset, textures: int = 0) -> MeshFiles:
    """Write the surfaces and hull colliders of all links.

    Args:
        asset: The asset.
        textures: Texels on a side of the materials' maps; 0 for no maps.
    """
    maps = map_files(asset, textures)
    surfaces = mesh_names({link.name: [surface.name for surface in link.surfaces] for link in asset.links})
    of_links = hulls(asset)
    names = mesh_names(
        {link: [f"collider_{number}" for number in found] for link, found in of_links.items()},
        taken=[name for of_link in surfaces.values() for name in of_link],
    )
    library = f"{asset.name}.mtl"
    files = {library: mtl_text([surface.material for link in asset.links for surface in link.surfaces], maps)}
    for link in asset.links:
        origin = asset.origin(link.name)
        for surface, name in zip(link.surfaces, surfaces[link.name], strict=True):
            files[name] = surface_text(surface.mesh, origin, library, surface.material)
    texts = hull_texts([hull for found in of_links.values() for hull in found.values()])
    files |= zip((name for of_link in names.values() for name in of_link), texts, strict=True)
    return MeshFiles(
        {MeshFiles.path(name): content for name, content in files.items()} | dict(maps.files),
        surfaces,
        {link: dict(zip(found, names[link], strict=True)) for link, found in of_links.items()},
        {link: {number: hull.middle for number, hull in found.items()} for link, found in of_links.items()},
        maps,
    )


def surface_text(mesh: Mesh, origin: Array, library: str, material: Material) -> bytes:
    """Return a surface as OBJ text, with its vertices taken from asset coordinates to a frame at `origin`.

    Each position, normal and texture coordinate is written once; `read_obj` finds the vertices again.
    """
    coordinates = texture_coordinates(mesh, material)
    rows = np.concatenate([mesh.vertices - origin, coordinates, mesh.normals], axis=1)
    corners = mesh.triangles
    if len(rows) == 3:  # MuJoCo wants four vertices: halve a lone triangle at its first side
        a, b, c = corners[0]
        rows = np.concatenate([rows, rows[[a, b]].mean(axis=0, keepdims=True)])
        corners = np.array([[a, 3, c], [3, b, c]])
    positions, place_numbers = _distinct(rounded(rows[:, :3], POSITION_DECIMALS))
    uvs, uv_numbers = _distinct(rounded(rows[:, 3:5], UV_DECIMALS))
    normals, normal_numbers = _distinct(rounded(rows[:, 5:8], NORMAL_DECIMALS))
    numbers = np.column_stack([place_numbers, uv_numbers, normal_numbers]) + 1
    return b"".join(
        (
            f"mtllib {library}\nusemtl {material.name}\n".encode(),
            text(lines(("v ", " ", " "), positions, POSITION_DECIMALS)),
            text(lines(("vt ", " "), uvs, UV_DECIMALS)),
            text(lines(("vn ", " ", " "), normals, NORMAL_DECIMALS)),
            text(face_lines(corners, numbers)),
        )
    )


def hull_texts(found: Sequence[Hull]) -> list[bytes]:
    """Return hulls as OBJ texts; all at once, for there are many of a few lines each."""
    if not found:
        return []
    vertices = rounded(np.concatenate([hull.vertices for hull in found]), HULL_DECIMALS)
    positions = lines(("v ", " ", " "), vertices, HULL_DECIMALS)
    faces = lines(("f ", " ", " "), np.concatenate([hull.triangles for hull in found]) + 1)
    ends = np.cumsum([(len(hull.vertices), len(hull.triangles)) for hull in found], axis=0)[:-1].T
    return [
        text(of_hull) + text(its_faces)
        for of_hull, its_faces in zip(np.split(positions, ends[0]), np.split(faces, ends[1]), strict=True)
    ]


def _distinct(values: Indices) -> tuple[Indices, Indices]:
    """Return the distinct rows of integers, shape (n, k), in order, and the number of each row's own."""
    columns = np.ascontiguousarray(values.T)
    lowest = columns.min(axis=1)
    spans = [int(span) + 1 for span in columns.max(axis=1) - lowest]
    if math.prod(spans) >= 2**63:  # too wide for one key per row
        order = np.lexsort(columns[::-1])
        ordered = values[order]
        new = np.append(True, (ordered[1:] != ordered[:-1]).any(axis=1))
        numbers = np.empty(len(values), np.int64)
        numbers[order] = np.cumsum(new) - 1
        return ordered[new], numbers
    keys = columns[0] - lowest[0]
    for column, least, span in zip(columns[1:], lowest[1:], spans[1:], strict=True):
        keys = keys * span + (column - least)
    found, numbers = np.unique(keys, return_inverse=True)
    distinct = np.empty((len(found), len(spans)), np.int64)
    for number in reversed(range(len(spans))):
        found, distinct[:, number] = np.divmod(found, spans[number])
    return distinct + lowest, numbers


def mtl_text(materials: Sequence[Material], maps: MapFiles) -> bytes:
    """Return the materials as MTL text with the usual extensions for physically based shading.

    Readers multiply a number with its map, or take the map alone: where there is a map the number is 1.
    """
    return "\n".join(
        _mtl_block(material, maps.of(material)) for material in dict.fromkeys(materials)
    ).encode()


_MAPS: dict[Kind, str] = {
    "albedo": "map_Kd", "roughness": "map_Pr", "metalness": "map_Pm", "normal": "norm",
}  # fmt: skip


def _mtl_block(material: Material, maps: Mapping[Kind, str]) -> str:
    color = (1.0, 1.0, 1.0) if "albedo" in maps else material.base_color
    words = {"Kd": _color(color), "Ks": _color(specular_color(material))}
    if any(material.emission):
        words["Ke"] = _color(material.emission)
    words |= {
        "Ns": f"{phong_exponent(material.specular_roughness):.6g}",
        "d": f"{material.opacity:.6g}",
        "illum": "2",
        "Pr": "1" if "roughness" in maps else f"{material.specular_roughness:.6g}",
        "Pm": "1" if "metalness" in maps else f"{material.base_metalness:.6g}",
    }
    if material.coat_weight:
        words |= {"Pc": f"{material.coat_weight:.6g}", "Pcr": f"{material.coat_roughness:.6g}"}
    folder = TEXTURE_DIRECTORY.removeprefix(f"{MESH_DIRECTORY}/")
    words |= {_MAPS[kind]: f"{folder}/{name}" for kind, name in maps.items()}
    return "".join(f"{word} {value}\n" for word, value in ({"newmtl": material.name} | words).items())


def _color(linear: tuple[float, float, float]) -> str:
    return " ".join(f"{channel:.6g}" for channel in display_color(linear))


def display_color(linear: tuple[float, float, float]) -> tuple[float, float, float]:
    """Encode linear RGB as sRGB, which is what URDF, MJCF and MTL readers take colours for."""
    red, green, blue = displayed(np.array(linear)).tolist()
    return round(red, 6), round(green, 6), round(blue, 6)
