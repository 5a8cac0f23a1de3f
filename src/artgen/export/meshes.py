"""Mesh files that URDF and MJCF share: OBJ surfaces and colliders in their link's frame, with one MTL."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from artgen.asset import Asset, Mesh
from artgen.asset.files import MESH_DIRECTORY, mesh_names
from artgen.export.hulls import HULL_DECIMALS, Hull, hulls
from artgen.export.lines import face_lines, lines, rounded, text
from artgen.materials import Material

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

_POSITION_DECIMALS = 7  # 0.1 micrometre
_NORMAL_DECIMALS = 5
_UV_DECIMALS = 6


@dataclass(frozen=True)
class MeshFiles:
    """The mesh files of an asset.

    Attributes:
        files: Content by path relative to the asset's directory.
        surfaces: File name of each surface, by link, in the link's order.
        colliders: File name of each collider, by link and number of the collider; hulls only.
    """

    files: Mapping[str, bytes]
    surfaces: Mapping[str, tuple[str, ...]]
    colliders: Mapping[str, Mapping[int, str]]

    @staticmethod
    def path(name: str) -> str:
        """Return where a mesh file lies, relative to the asset's directory."""
        return f"{MESH_DIRECTORY}/{name}"


@lru_cache(maxsize=1)  # two formats are written of one asset after another
def mesh_files(asset: Asset) -> MeshFiles:
    """Write the surfaces and hull colliders of all links."""
    surfaces = mesh_names({link.name: [surface.name for surface in link.surfaces] for link in asset.links})
    of_links = hulls(asset)
    names = mesh_names(
        {link: [f"collider_{number}" for number in found] for link, found in of_links.items()},
        taken=[name for of_link in surfaces.values() for name in of_link],
    )
    library = f"{asset.name}.mtl"
    files = {library: mtl_text([surface.material for link in asset.links for surface in link.surfaces])}
    for link in asset.links:
        origin = asset.origin(link.name)
        for surface, name in zip(link.surfaces, surfaces[link.name], strict=True):
            files[name] = surface_text(surface.mesh, origin, library, surface.material.name)
    texts = hull_texts([hull for found in of_links.values() for hull in found.values()])
    files |= zip((name for of_link in names.values() for name in of_link), texts, strict=True)
    return MeshFiles(
        {MeshFiles.path(name): content for name, content in files.items()},
        surfaces,
        {link: dict(zip(found, names[link], strict=True)) for link, found in of_links.items()},
    )


def surface_text(mesh: Mesh, origin: Array, library: str, material: str) -> bytes:
    """Return a surface as OBJ text, with its vertices taken from asset coordinates to a frame at `origin`.

    Vertices keep their numbers; each normal and texture coordinate is written once.
    """
    rows = np.concatenate([mesh.vertices - origin, mesh.uvs, mesh.normals], axis=1)
    corners = mesh.triangles
    if len(rows) == 3:  # MuJoCo wants four vertices: halve a lone triangle at its first side
        a, b, c = corners[0]
        rows = np.concatenate([rows, rows[[a, b]].mean(axis=0, keepdims=True)])
        corners = np.array([[a, 3, c], [3, b, c]])
    uvs, uv_numbers = _distinct(rounded(rows[:, 3:5], _UV_DECIMALS))
    normals, normal_numbers = _distinct(rounded(rows[:, 5:8], _NORMAL_DECIMALS))
    numbers = np.column_stack([np.arange(len(rows)), uv_numbers, normal_numbers]) + 1
    return b"".join(
        (
            f"mtllib {library}\nusemtl {material}\n".encode(),
            text(lines(("v ", " ", " "), rounded(rows[:, :3], _POSITION_DECIMALS), _POSITION_DECIMALS)),
            text(lines(("vt ", " "), uvs, _UV_DECIMALS)),
            text(lines(("vn ", " ", " "), normals, _NORMAL_DECIMALS)),
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
    lowest = values.min(axis=0)
    spans = [int(span) + 1 for span in values.max(axis=0) - lowest]
    if math.prod(spans) >= 2**63:  # too wide for one key per row: coordinates of kilometres
        return values, np.arange(len(values))
    keys = np.zeros(len(values), np.int64)
    for column, span in zip((values - lowest).T, spans, strict=True):
        keys = keys * span + column
    found, numbers = np.unique(keys, return_inverse=True)
    columns: list[Indices] = []
    for span in reversed(spans):
        columns.insert(0, found % span)
        found = found // span
    return np.column_stack(columns) + lowest, numbers


def mtl_text(materials: list[Material]) -> bytes:
    """Return the materials as MTL text with the usual extension for roughness and metalness."""
    blocks = []
    for material in dict.fromkeys(materials):
        red, green, blue = display_color(material.base_color)
        lines = [f"newmtl {material.name}", f"Kd {red:.6g} {green:.6g} {blue:.6g}"]
        if any(material.emission):
            red, green, blue = display_color(material.emission)
            lines.append(f"Ke {red:.6g} {green:.6g} {blue:.6g}")
        lines.append(f"d {material.opacity:.6g}")
        lines.append(f"Pr {material.specular_roughness:.6g}")
        lines.append(f"Pm {material.base_metalness:.6g}")
        blocks.append("\n".join(lines) + "\n")
    return "\n".join(blocks).encode()


def display_color(linear: tuple[float, float, float]) -> tuple[float, float, float]:
    """Encode linear RGB as sRGB, which is what URDF, MJCF and MTL readers take colours for."""
    red, green, blue = (
        12.92 * value if value <= 0.0031308 else 1.055 * value ** (1 / 2.4) - 0.055 for value in linear
    )
    return round(red, 6), round(green, 6), round(blue, 6)
