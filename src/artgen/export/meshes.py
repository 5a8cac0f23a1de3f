"""Mesh files that URDF and MJCF share: OBJ surfaces and colliders in their link's frame, with one MTL."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from manifold3d import Manifold
from numpy.typing import NDArray

from artgen.asset import Asset, Mesh
from artgen.asset.files import MESH_DIRECTORY, mesh_names
from artgen.colliders import Convex
from artgen.materials import Material

Array = NDArray[np.float64]

_POSITION_DECIMALS = 7  # 0.1 micrometre
_COLLIDER_DECIMALS = 9  # rounding must not dent a convex piece
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
    hulls = {
        link.name: [number for number, item in enumerate(link.colliders) if item.convex.kind == "hull"]
        for link in asset.links
    }
    names = mesh_names(
        {link: [f"collider_{number}" for number in numbers] for link, numbers in hulls.items()},
        taken=[name for of_link in surfaces.values() for name in of_link],
    )
    library = f"{asset.name}.mtl"
    files = {library: mtl_text([surface.material for link in asset.links for surface in link.surfaces])}
    for link in asset.links:
        origin = asset.origin(link.name)
        for surface, name in zip(link.surfaces, surfaces[link.name], strict=True):
            files[name] = surface_text(surface.mesh, origin, library, surface.material.name)
        for number, name in zip(hulls[link.name], names[link.name], strict=True):
            files[name] = hull_text(link.colliders[number].convex, origin)
    return MeshFiles(
        {MeshFiles.path(name): content for name, content in files.items()},
        surfaces,
        {link: dict(zip(hulls[link], names[link], strict=True)) for link in hulls},
    )


def surface_text(mesh: Mesh, origin: Array, library: str, material: str) -> bytes:
    """Return a surface as OBJ text, with its vertices taken from asset coordinates to a frame at `origin`."""
    rows = np.concatenate([mesh.vertices - origin, mesh.normals, mesh.uvs], axis=1)
    corners = mesh.triangles
    if len(rows) == 3:  # MuJoCo wants four vertices: halve a lone triangle at its first side
        a, b, c = corners[0]
        rows = np.concatenate([rows, rows[[a, b]].mean(axis=0, keepdims=True)])
        corners = np.array([[a, 3, c], [3, b, c]])
    return b"".join(
        (
            f"mtllib {library}\nusemtl {material}\n".encode(),
            _lines("v", rows[:, :3], _POSITION_DECIMALS),
            _lines("vt", rows[:, 6:8], _UV_DECIMALS),
            _lines("vn", rows[:, 3:6], _NORMAL_DECIMALS),
            _lines("f", np.repeat(corners + 1, 3, axis=1), 0, separators=" //" * 3),
        )
    )


def hull_text(convex: Convex, origin: Array) -> bytes:
    """Return a hull as OBJ text, with its vertices taken from asset coordinates to a frame at `origin`."""
    mesh = Manifold.hull_points(np.ascontiguousarray(convex.points - origin)).to_mesh64()
    return b"".join(
        (
            _lines("v", np.asarray(mesh.vert_properties)[:, :3], _COLLIDER_DECIMALS),
            _lines("f", np.asarray(mesh.tri_verts).astype(np.int64) + 1, 0),
        )
    )


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


def _lines(keyword: str, values: Array | NDArray[np.int64], decimals: int, separators: str = "") -> bytes:
    """Format one line per row of `values`, shape (n, k), at a fixed number of decimals.

    Digits are made of integers, so the text is the same on every platform; and all at once, for a model's
    meshes hold a hundred thousand numbers. Zeros that say nothing are left out.

    Args:
        keyword: First word of each line.
        values: The numbers; integers if `decimals` is 0.
        decimals: Digits after the point.
        separators: The k characters before the numbers; blanks by default.
    """
    scaled = np.rint(values * 10.0**decimals).astype(np.int64)
    rows, columns = scaled.shape
    magnitude = np.abs(scaled)
    whole = len(str(int(magnitude.max(initial=0)) // 10**decimals))
    powers = 10 ** np.arange(whole + decimals - 1, -1, -1, dtype=np.int64)
    shifted = magnitude[..., None] // powers
    digits = (shifted % 10).astype(np.uint8)
    kept = np.ones(digits.shape, bool)
    kept[..., : whole - 1] = shifted[..., : whole - 1] > 0
    if decimals:
        nonzero = digits[..., whole:] > 0
        kept[..., whole:] = np.logical_or.accumulate(nonzero[..., ::-1], axis=-1)[..., ::-1]

    # one cell per character: separator, sign, whole digits, point, decimals
    text = np.empty((rows, columns, 3 + whole + decimals), np.uint8)
    shown = np.ones(text.shape, bool)
    text[..., 0] = np.frombuffer((separators or " " * columns).encode(), np.uint8)
    text[..., 1] = ord("-")
    shown[..., 1] = scaled < 0
    text[..., 2 : 2 + whole] = digits[..., :whole] + ord("0")
    shown[..., 2 : 2 + whole] = kept[..., :whole]
    text[..., 2 + whole] = ord(".")
    shown[..., 2 + whole] = kept[..., whole] if decimals else False
    text[..., 3 + whole :] = digits[..., whole:] + ord("0")
    shown[..., 3 + whole :] = kept[..., whole:]

    start = np.frombuffer(keyword.encode(), np.uint8)
    line = np.concatenate(
        [
            np.broadcast_to(start, (rows, len(start))),
            text.reshape(rows, -1),
            np.full((rows, 1), ord("\n"), np.uint8),
        ],
        axis=1,
    )
    visible = np.ones(line.shape, bool)
    visible[:, len(start) : -1] = shown.reshape(rows, -1)
    return line[visible].tobytes()
