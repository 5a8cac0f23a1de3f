"""Mesh files of URDF and MJCF: OBJ surfaces, colliders, one MTL file, maps; fast formatting of numbers."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array, FrozenArrays, Indices, cached
from artgen.asset import Asset, Mesh
from artgen.asset.files import MESH_DIRECTORY, mesh_names
from artgen.asset.rounding import NORMAL_DECIMALS, POSITION_DECIMALS, UV_DECIMALS
from artgen.asset.surface import texture_coordinates
from artgen.export.hulls import HULL_DECIMALS, Hull, hulls
from artgen.export.maps import TEXTURE_DIRECTORY, MapFiles, map_files, phong_exponent, specular_color
from artgen.materials import Material
from artgen.materials.textures import Kind, displayed

Bytes = NDArray[np.uint8]
Words = NDArray[np.uint32]  # four characters each

_GROUP = 10_000  # range of four digits


def rounded(values: Array, decimals: int) -> Indices:
    """Return numbers with a fixed number of decimals as integers."""
    return np.rint(values * 10.0**decimals).astype(np.int64)


def lines(heads: Sequence[str], scaled: Indices, decimals: int = 0) -> Bytes:
    """Return one line of text per row of numbers, as input of `text`, without trailing zeros."""
    magnitude = np.abs(scaled)
    whole = magnitude // 10**decimals
    words = _whole(whole)
    if decimals:
        words += _fraction(magnitude - whole * 10**decimals, decimals)
    first, signed = _words(*heads), _words(*(f"{head}-" for head in heads))
    rows, columns = scaled.shape
    cells = 1 + len(words)
    line = np.empty((rows, columns * cells + 1), np.uint32)
    line[:, :-1:cells] = np.where(scaled < 0, signed, first)
    for number, word in enumerate(words, start=1):
        line[:, number:-1:cells] = word
    line[:, -1] = _words("\n")
    return line.view(np.uint8)


def face_lines(corners: Indices, numbers: Indices) -> Bytes:
    """Return the `f` lines of an OBJ file, as input of `text`."""
    each = np.ascontiguousarray(lines((" ", "/", "/"), numbers)[:, :-4])  # without line ends
    row = np.empty((len(corners), 2 + 3 * each.shape[1]), np.uint8)
    row[:, 0] = ord("f")
    # taking items is many times faster than taking rows
    taken = np.take(each.view(f"V{each.shape[1]}").ravel(), corners)
    row[:, 1:-1] = taken.view(np.uint8).reshape(len(corners), -1)
    row[:, -1] = ord("\n")
    return row


def text(rows: Bytes) -> bytes:
    """Return the text of several lines."""
    return rows.tobytes().translate(None, b"\0")


@cached(64)
def _words(*characters: str) -> Words:
    """Return strings of at most four characters as one number each with the same bytes."""
    return np.frombuffer("".join(each.ljust(4, "\0") for each in characters).encode("ascii"), np.uint32)


def _whole(numbers: Indices) -> list[Words]:
    """Return the digits of integers, shape (...), without leading zeros."""
    higher = numbers // _GROUP
    group = numbers - higher * _GROUP
    words = [np.where(higher > 0, _DIGITS[group], _LEADING[group])]
    if higher.any():
        words = [np.where(higher > 0, word, 0).astype(np.uint32) for word in _whole(higher)] + words
    return words


def _fraction(numbers: Indices, decimals: int) -> list[Words]:
    """Return a point and the digits after it, without trailing zeros; empty if all are zero."""
    groups = max(0, -(-(decimals - 3) // 4))  # four digits, after a point and three digits
    rest = numbers * 10 ** (3 + 4 * groups - decimals)
    words: list[Words] = []
    shown = np.zeros(numbers.shape, bool)
    for _ in range(groups):
        higher = rest // _GROUP
        group = rest - higher * _GROUP
        words.insert(0, np.where(shown, _DIGITS[group], _TRAILING[group]))
        shown |= group > 0
        rest = higher
    return [np.where(shown, _POINT_DIGITS[rest], _POINT_TRAILING[rest]), *words]


_POWERS = np.array([1000, 100, 10, 1])
_NUMBERS = np.arange(_GROUP)[:, None]
_CHARACTERS = (_NUMBERS // _POWERS % 10 + ord("0")).astype(np.uint8)
_POINTED = np.where(_POWERS == 1000, np.uint8(ord(".")), _CHARACTERS)[:1000]  # a point and three digits
_ENDING = _NUMBERS % (10 * _POWERS) > 0  # whether a digit or a later one is not zero

_DIGITS = _CHARACTERS.view(np.uint32).ravel()
_LEADING = np.where((_NUMBERS >= _POWERS) | (_POWERS == 1), _CHARACTERS, 0).view(np.uint32).ravel()
_TRAILING = np.where(_ENDING, _CHARACTERS, 0).view(np.uint32).ravel()
_POINT_DIGITS = _POINTED.view(np.uint32).ravel()
_POINT_TRAILING = np.where(_ENDING[:1000], _POINTED, 0).view(np.uint32).ravel()


@dataclass(frozen=True)
class MeshFiles(FrozenArrays):
    """The mesh files of an asset.

    Attributes:
        files: Content by path relative to the asset's directory, maps included.
        surfaces: File name of each surface, by link, in the link's order.
        colliders: File name of each hull collider, in its own frame, by link and number of the collider.
        middles: Origin of that frame in the link's frame, shape (3,) [m].
        maps: Maps of the materials, in `textures/` next to the meshes.
    """

    files: Mapping[str, bytes]
    surfaces: Mapping[str, tuple[str, ...]]
    colliders: Mapping[str, Mapping[int, str]]
    middles: Mapping[str, Mapping[int, Array]]
    maps: MapFiles

    @staticmethod
    def path(name: str) -> str:
        """Return the path of a mesh file relative to the asset's directory."""
        return f"{MESH_DIRECTORY}/{name}"


@cached(1)  # two formats of one asset are written in sequence
def mesh_files(asset: Asset, textures: int = 0) -> MeshFiles:
    """Write the surfaces and hull colliders of all links.

    Args:
        asset: The asset.
        textures: Texels per side of the material maps; 0 for no maps.
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
