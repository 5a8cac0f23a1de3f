"""Mesh files of URDF and MJCF: OBJ surfaces, colliders, one MTL file, maps."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from artgen._arrays import Array, FrozenArrays, Indices, cached
from artgen.asset import Asset, Mesh
from artgen.asset.files import MESH_DIRECTORY, mesh_names
from artgen.asset.surface import NORMAL_DECIMALS, POSITION_DECIMALS, UV_DECIMALS, texture_coordinates
from artgen.export.hulls import HULL_DECIMALS, Hull, hulls
from artgen.export.maps import TEXTURE_DIRECTORY, MapFiles, map_files, phong_exponent, specular_color
from artgen.export.text import face_lines, lines, rounded, text
from artgen.materials import Material
from artgen.materials.textures import Kind, displayed


@dataclass(frozen=True)
class MeshFiles(FrozenArrays):
    """The mesh files of an asset, by path relative to its directory."""

    files: Mapping[str, bytes]  # content by path, maps included
    surfaces: Mapping[str, Sequence[str]]  # path of each surface, by link, in the link's order
    # path of each hull collider, in its own frame, by link and number of the collider
    colliders: Mapping[str, Mapping[int, str]]
    middles: Mapping[str, Mapping[int, Array]]  # origin of that frame, shape (3,) [m]
    maps: MapFiles  # maps of the materials, in `textures/` next to the surfaces


@cached(1)  # two formats of one asset are written in sequence
def mesh_files(asset: Asset, textures: int = 0) -> MeshFiles:
    """Write the surfaces and hull colliders of all links, in the frames of the links.

    Args:
        asset: The asset.
        textures: Texels per side of the material maps; 0 for no maps.
    """
    return arranged_files(asset, textures, (MESH_DIRECTORY, MESH_DIRECTORY), f"{asset.name}.mtl")


def arranged_files(
    asset: Asset, textures: int, directories: tuple[str, str], library: str, turn: Array | None = None
) -> MeshFiles:
    """Write the surfaces and hull colliders of all links to chosen directories.

    Args:
        asset: The asset.
        textures: Texels per side of the material maps; 0 for no maps.
        directories: Directories of the surfaces and of the colliders.
        library: Name of the MTL file.
        turn: Rotation by quarter turns from the asset's coordinates to those of all meshes, shape (3, 3);
            None writes each mesh in the frame of its link.
    """
    maps = map_files(asset, textures)
    visuals, convex = directories
    names = mesh_names({link.name: [surface.name for surface in link.surfaces] for link in asset.links})
    surfaces = {link: [f"{visuals}/{name}" for name in of_link] for link, of_link in names.items()}
    materials = [surface.material for link in asset.links for surface in link.surfaces]
    files = {f"{visuals}/{library}": mtl_text(materials, maps)}
    for link in asset.links:
        origin = asset.origin(link.name) if turn is None else np.zeros(3)
        for surface, path in zip(link.surfaces, surfaces[link.name], strict=True):
            mesh = surface.mesh
            if turn is not None:
                mesh = replace(mesh, vertices=mesh.vertices @ turn.T, normals=mesh.normals @ turn.T)
            files[path] = surface_text(mesh, origin, library, surface.material)
    of_links = hulls(asset) if turn is None else hulls(asset, in_links=False)  # USD uses the first ones
    if turn is not None:  # quarter turns swap and negate rounded coordinates, so hulls stay convex
        of_links = {
            link: {
                number: replace(hull, vertices=hull.vertices @ turn.T, middle=turn @ hull.middle)
                for number, hull in found.items()
            }
            for link, found in of_links.items()
        }
    taken = [name for of_link in names.values() for name in of_link]
    numbered = {link: [f"collider_{number}" for number in found] for link, found in of_links.items()}
    colliders = {
        link: dict(zip(of_links[link], (f"{convex}/{name}" for name in of_link), strict=True))
        for link, of_link in mesh_names(numbered, taken).items()
    }
    texts = hull_texts([hull for found in of_links.values() for hull in found.values()])
    files |= zip((path for found in colliders.values() for path in found.values()), texts, strict=True)
    files |= {visuals + path.removeprefix(MESH_DIRECTORY): content for path, content in maps.files.items()}
    middles = {
        link: {number: hull.middle for number, hull in found.items()} for link, found in of_links.items()
    }
    return MeshFiles(files, surfaces, colliders, middles, maps)


def mesh_name(path: str) -> str:
    """Return the name of a mesh: that of its file."""
    return path.rpartition("/")[2].removesuffix(".obj")


def surface_text(mesh: Mesh, origin: Array, library: str, material: Material) -> bytes:
    """Return a surface as OBJ text, moved from asset coordinates to the frame at `origin`.

    Each position, normal and texture coordinate is written once; `read_obj` restores the vertices.
    """
    coordinates = texture_coordinates(mesh, material)
    rows = np.concatenate([mesh.vertices - origin, coordinates, mesh.normals], axis=1)
    corners = mesh.triangles
    if len(rows) == 3:  # MuJoCo needs four vertices: halve a single triangle at its first side
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
    """Return hulls as OBJ texts, in one call for many short files."""
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
    """Return the distinct rows of integers, shape (n, k), sorted, and the number of each row."""
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
    steps = keys[1:] - keys[:-1]
    if (steps >= 0).all():  # sorted already, as the positions of a surface
        new = np.append(True, steps > 0)
        found, numbers = keys[new], np.cumsum(new) - 1
    else:
        found, numbers = np.unique(keys, return_inverse=True)
    distinct = np.empty((len(found), len(spans)), np.int64)
    for number in reversed(range(len(spans))):
        found, distinct[:, number] = np.divmod(found, spans[number])
    return distinct + lowest, numbers


def mtl_text(materials: Sequence[Material], maps: MapFiles) -> bytes:
    """Return the materials as MTL text with the usual extensions for physically based shading.

    Readers multiply a number with its map, or use the map alone: with a map the number is 1.
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
    """Encode linear RGB as sRGB, as readers of URDF, MJCF and MTL expect."""
    red, green, blue = displayed(np.array(linear)).tolist()
    return round(red, 6), round(green, 6), round(blue, 6)
