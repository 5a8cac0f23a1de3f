"""Faults of meshes, maps and records; see `support.injections`."""

import json
import struct
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from support.exports import edit_json
from support.injections import Absent, Export, fault


def edit_mesh(path: Path, change: Callable[[np.ndarray, list[list[int]]], tuple[np.ndarray, Any]]) -> None:
    """Change vertices and triangles of a collider's OBJ file."""
    rows = [line.split() for line in path.read_text(encoding="utf-8").splitlines()]
    vertices = np.array([row[1:] for row in rows if row[0] == "v"], float)
    triangles = [[int(word) - 1 for word in row[1:]] for row in rows if row[0] == "f"]
    vertices, triangles = change(vertices, triangles)
    text = [f"v {x:.9f} {y:.9f} {z:.9f}" for x, y, z in vertices]
    text += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in triangles]
    path.write_text("\n".join(text) + "\n", encoding="utf-8")


@fault("files", r"meshes/\S+\.obj is missing, which urdf and mjcf need")
def mesh_missing(export: Export) -> None:
    export.surface.unlink()


@fault("urdf", r"\S+_collider_\d+\.obj")
def collider_mesh_missing(export: Export) -> None:
    export.hull[1].unlink()


@fault("files", r"textures/\S+\.png is missing, which urdf and mjcf and usd need")
def texture_missing(export: Export) -> None:
    export.texture.unlink()


@fault("files", r"textures/\S+\.png is not a readable image")
def texture_truncated(export: Export) -> None:
    export.cut(export.texture)


@fault("files", r"textures/\S+\.png is not a readable image")
def texture_is_no_image(export: Export) -> None:
    export.texture.write_text("no image", encoding="utf-8")


@fault("urdf", r"its collider \w+ is open: 3 edges have a face on one side only", "hull")
def collider_open(export: Export) -> None:
    edit_mesh(export.hull[1], lambda vertices, triangles: (vertices, triangles[1:]))


@fault("urdf", r"its collider \w+ is inside out: its volume is -[\d.]+ cm\^3", "hull")
def collider_inside_out(export: Export) -> None:
    edit_mesh(export.hull[1], lambda vertices, triangles: (vertices, [[a, c, b] for a, b, c in triangles]))


def dented(vertices: np.ndarray, triangles: list[list[int]]) -> tuple[np.ndarray, Any]:
    """Push a new vertex in the largest face into the piece."""
    sizes = [np.linalg.norm(np.cross(*(vertices[[b, c]] - vertices[a]))) for a, b, c in triangles]
    number = int(np.argmax(sizes))
    a, b, c = triangles[number]
    inside = 0.6 * vertices[[a, b, c]].mean(axis=0) + 0.4 * vertices.mean(axis=0)
    new = len(vertices)
    rest = triangles[:number] + triangles[number + 1 :]
    return np.vstack([vertices, inside]), [*rest, [a, b, new], [b, c, new], [c, a, new]]


@fault("urdf", r"its collider \w+ is not convex in .*: a vertex lies [\d.]+ mm inside its hull", "hull")
def collider_concave(export: Export) -> None:
    edit_mesh(export.hull[1], dented)


@fault("mjcf", r"its collider \w+ is not convex in .*: a vertex lies [\d.]+ mm inside its hull", "hull")
def collider_concave_for_mujoco(export: Export) -> None:
    edit_mesh(export.hull[1], dented)


@fault("urdf", r"its collider \w+ has \d+ vertices; GPU simulators take at most 64", "hull")
def collider_of_too_many_vertices(export: Export) -> None:
    def refined(vertices: np.ndarray, triangles: list[list[int]]) -> tuple[np.ndarray, Any]:
        while len(vertices) <= 64:
            (a, b, c), *rest = triangles
            new = len(vertices)
            vertices = np.vstack([vertices, vertices[[a, b, c]].mean(axis=0)])
            triangles = [*rest, [a, b, new], [b, c, new], [c, a, new]]
        return vertices, triangles

    edit_mesh(export.hull[1], refined)


@fault("urdf", r"its collider \w+ is off by [\d.e+]+ mm and has [\d.e+]+ cm\^3", "hull")
def collider_in_millimetres(export: Export) -> None:
    edit_mesh(export.hull[1], lambda vertices, triangles: (1000.0 * vertices, triangles))


@fault("files", r"meshes/\S+\.obj was changed after the export")
def mesh_turned_into_another(export: Export) -> None:
    """The same shape, its triangles in another order: no other check could tell."""
    lines = export.surface.read_text(encoding="utf-8").splitlines()
    faces = [line for line in lines if line.startswith("f ")]
    text = [line for line in lines if not line.startswith("f ")] + faces[::-1]
    export.surface.write_text("\n".join(text) + "\n", encoding="utf-8")


@fault("files", r"meshes/\S+\.obj is missing, which")
def file_of_wrong_case(export: Export) -> None:
    export.surface.rename(export.surface.with_name(export.surface.name.upper()))


@fault("files", r"meshes/\S+\.obj is a link that leads out of the directory")
def link_out_of_the_directory(export: Export) -> None:
    elsewhere = export.directory.parent / "elsewhere.obj"
    export.surface.rename(elsewhere)
    export.surface.symlink_to(elsewhere)


@fault("files", r"meshes/old\.obj is not listed in")
def stray_mesh(export: Export) -> None:
    (export.directory / "meshes/old.obj").write_text("v 0 0 0\n", encoding="utf-8")


@fault("files", r"asset\.json cannot be read")
def record_truncated(export: Export) -> None:
    export.cut(export.directory / "asset.json")


def record(export: Export, change: Callable[[Any], Any]) -> None:
    edit_json(export.directory / "asset.json", change)


@fault("urdf", r"its mass is [\d.]+ kg in .*, not [\d.]+ kg", "link")
def record_of_another_asset(export: Export) -> None:
    """The sizes of a sibling under the same names: its masses are others."""

    def change(data: Any) -> None:
        for link in data["links"]:
            link["mass"] *= 1.25
        data["mass"] *= 1.25

    record(export, change)


@fault("colliders", r"is not convex: a vertex lies [\d.]+ mm inside", "hull")
def record_of_concave_collider(export: Export) -> None:
    name = export.hull[0]

    def change(data: Any) -> None:
        link = next(link for link in data["links"] if link["name"] == name)
        hull = next(item for item in link["colliders"] if item["kind"] == "hull")
        hull["points"].append(np.mean(hull["points"], axis=0).tolist())

    record(export, change)


@fault("urdf", r"its friction is [\d.]+ N.* in .*, not 0", "rubbing")
def record_without_friction(export: Export) -> None:
    def change(data: Any) -> None:
        next(item for item in data["joints"] if item["name"] == export.rubbing.name)["friction"] = 0.0

    record(export, change)


@fault("files", r"\.glb has \d+ bytes where its header says \d+")
def glb_truncated(export: Export) -> None:
    export.cut(glb(export))


@fault("files", r"\.glb has JSON that cannot be read")
def glb_of_broken_json(export: Export) -> None:
    path = glb(export)
    content = bytearray(path.read_bytes())
    content[20:24] = b"nonsense"[:4]
    path.write_bytes(bytes(content))


@fault("files", r"\.glb was changed after the export")
def glb_of_other_colors(export: Export) -> None:
    path = glb(export)
    content = path.read_bytes()
    (size,) = struct.unpack_from("<I", content, 12)
    data = json.loads(content[20 : 20 + size])
    data["asset"]["generator"] = "x" * len(data["asset"]["generator"])
    text = json.dumps(data, separators=(",", ":"), ensure_ascii=False).encode().ljust(size)
    path.write_bytes(content[:20] + text[:size] + content[20 + size :])


def glb(export: Export) -> Path:
    if "glb" not in export.files:
        raise Absent
    return export.files["glb"]
