"""Meshes of files that others made, and the convex pieces that stand for them."""

import json
import math
import re
import warnings
import xml.etree.ElementTree as ET
from collections.abc import Callable, Hashable, Sequence
from io import BytesIO
from pathlib import Path

import numpy as np

from artgen._arrays import Array, Indices
from artgen.colliders import Convex
from artgen.colliders.coacd import coacd_pieces
from artgen.colliders.triangles import hull_of
from artgen.errors import AssetError
from artgen.referee.files import MOST_LENGTH, Element, check_file, parse_xml, shown
from artgen.referee.model import MOST_BODIES, MOST_GEOMS, Meshes

MeshParts = list[tuple[Array, Indices]]
"""Vertices, shape (n, 3) [m], and triangles, shape (m, 3), of each part of a mesh."""

_FORMATS = ("dae", "glb", "obj", "ply", "stl")
_MOST_FAULT = 80  # characters of a library's message
_MOST_NAMES = 3  # in a note
_MOST_VALUES = 50_000_000  # vectors and indices of a GLB file
_CONVEX = 0.01  # share of the hull's volume that a mesh may lack and yet count as convex
_NOTES = {
    "hull": "not convex: taken as hulls, as most simulators take them",
    "coacd": "decomposed into convex pieces by CoACD, which follow the surface approximately",
    "failed": "not convex, and CoACD fails on them: taken as hulls",
    "flat": "flat: not judged",
    "turned": "Collada with an up axis other than Z: not turned, as ROS takes them; some tools turn them",
}


class Hulls:
    """Makes convex pieces of meshes, of each mesh once, and remembers what its notes must say.

    Args:
        meshes: Whether a mesh that is not convex becomes one hull or is decomposed by CoACD.
    """

    def __init__(self, meshes: Meshes) -> None:
        self._meshes = meshes
        self._known: dict[Hashable, tuple[Convex, ...]] = {}
        self._named: dict[str, list[str]] = {fault: [] for fault in _NOTES}

    def file_pieces(self, path: Path, scale: tuple[float, float, float], where: str) -> tuple[Convex, ...]:
        """Return the pieces of a mesh file in its own frame [m]; for the arguments see `load_mesh`."""

        def load() -> MeshParts:
            parts = load_mesh(path, scale, where=where)
            if path.suffix.lower() == ".dae" and re.search(rb"<up_axis>\s*[XY]", path.read_bytes()):
                self._named["turned"].append(path.name)
            return parts

        return self.pieces((path, scale), path.name, load)

    def pieces(self, key: Hashable, name: str, load: Callable[[], MeshParts]) -> tuple[Convex, ...]:
        """Return the pieces of a mesh in its own frame [m].

        Args:
            key: Equal for equal meshes, such as the path and the scale.
            name: Name of the mesh in notes.
            load: Returns the parts of the mesh; it is called for the first mesh of each key.
        """
        if key not in self._known:
            self._known[key] = tuple(piece for part in load() for piece in self._pieces(*part, name))
        return self._known[key]

    def notes(self) -> list[str]:
        """Return one sentence for each deviation from the meshes, with their number and the first names."""
        return [
            noted("mesh", "meshes", names, _NOTES[fault]) for fault, names in self._named.items() if names
        ]

    def _pieces(self, vertices: Array, triangles: Indices, name: str) -> tuple[Convex, ...]:
        """Return the pieces of a part: its hull, or what CoACD finds; none for a flat one."""
        used = vertices[np.unique(triangles)]
        try:
            hull = Convex.hull(used)
        except ValueError:
            self._named["flat"].append(name)
            return ()
        points = used if hull.kind == "box" else hull.points
        middle, corners = points.mean(axis=0), vertices[triangles]
        volume = abs(float(np.linalg.det(corners - middle).sum())) / 6.0
        room = hull.volume if hull.kind == "box" else float(hull_of(points - middle).volume())
        if abs(room - volume) <= _CONVEX * room:
            return (hull,)
        if self._meshes == "coacd":
            try:
                pieces = tuple(
                    piece for each in _connected(vertices, triangles) for piece in coacd_pieces(*each)
                )
            except (ImportError, ValueError):
                self._named["failed"].append(name)
                return (hull,)
            self._named["coacd"].append(name)
            return pieces
        self._named["hull"].append(name)
        return (hull,)


def noted(one: str, many: str, names: Sequence[str], what: str) -> str:
    """Return a note about several things: their number, the first names, and what is said of them."""
    first = ", ".join(map(shown, dict.fromkeys(names[:_MOST_NAMES])))
    more = ", ..." if len(names) > _MOST_NAMES else ""
    return f"{len(names)} {one if len(names) == 1 else many} ({first}{more}): {what}"


def load_mesh(path: Path, scale: Sequence[float] = (1.0, 1.0, 1.0), *, where: str = "") -> MeshParts:
    """Return the parts of a mesh file: STL, OBJ, PLY, GLB or DAE, in its own unit; for DAE, in meters.

    A GLB or DAE file has a part for each mesh in its scene, at its place in the scene; the up axis of DAE is
    ignored, as ROS does. Other files are one part.

    Args:
        path: The file.
        scale: Factors of x, y and z; a mirrored part has its triangles turned over.
        where: The place that names the file, for messages.

    Raises:
        AssetError: The file has another format, is damaged, or has no triangles.
    """
    kind, where = path.suffix.lower().lstrip("."), where or f"mesh {shown(path.name)}"
    if kind not in _FORMATS:
        allowed = ", ".join(each.upper() for each in _FORMATS)
        raise AssetError(f"{where} has the format {shown(kind)}; convert the mesh to one of {allowed}")
    check_file(path, where)
    try:
        with np.errstate(all="ignore"), warnings.catch_warnings():
            warnings.simplefilter("ignore")
            parts = _collada(path) if kind == "dae" else _scene(path.read_bytes(), kind)
            parts = [(np.asarray(v, np.float64) * scale, np.asarray(t, np.int64)) for v, t in parts if len(t)]
    except AssetError as error:
        raise AssetError(f"{where}: {error}") from None
    except ImportError as error:
        raise AssetError(f"{where}: reading {kind.upper()} needs another package ({error})") from None
    except Exception as error:  # noqa: BLE001 - the libraries raise anything on damaged files
        fault = f"{type(error).__name__} {' '.join(str(error).split())[:_MOST_FAULT]}"
        raise AssetError(f"{where} cannot be read as {kind.upper()} ({fault}); export it again") from None
    if not parts:
        raise AssetError(f"{where} has no triangles; export it again")
    for vertices, triangles in parts:
        if not (np.abs(vertices) <= MOST_LENGTH).all():
            raise AssetError(f"{where} has coordinates that are not finite or exceed {MOST_LENGTH:g} m")
        if triangles.min() < 0 or triangles.max() >= len(vertices):
            raise AssetError(f"{where} has a triangle of vertex {triangles.max()} of {len(vertices)}")
    return [(v, t if math.prod(scale) > 0.0 else t[:, ::-1]) for v, t in parts]


def _connected(vertices: Array, triangles: Indices) -> MeshParts:
    """Return the connected parts of a mesh, with each point once: CoACD takes one at a time."""
    import trimesh

    mesh = trimesh.Trimesh(vertices, triangles, process=True)
    return [(part.vertices, part.faces) for part in mesh.split(only_watertight=False)]


def _scene(data: bytes, kind: str) -> MeshParts:
    """Return the parts that trimesh finds; without a resolver, it reads no further file."""
    import trimesh

    if kind == "glb":  # an accessor claims values that no buffer has, or has them many times
        header = json.loads(data[20 : 20 + int.from_bytes(data[12:16], "little")])
        accessors = header.get("accessors", ())
        _check_count(sum(each["count"] for each in accessors), _MOST_VALUES, "values")
        if not all("bufferView" in each for each in accessors):
            raise AssetError("it has compressed or sparse values; export it without compression")
    scene = trimesh.load_scene(BytesIO(data), file_type=kind, process=False, skip_materials=True)
    _check_count(len(scene.graph.nodes), MOST_BODIES, "nodes")
    groups: dict[str, MeshParts] = {}
    for node in scene.graph.nodes_geometry:
        matrix, name = scene.graph.get(node)
        mesh = scene.geometry[name]
        if isinstance(mesh, trimesh.Trimesh):  # a mesh of several materials has several geometries
            several = mesh.metadata.get("from_gltf_primitive")
            key = "" if kind != "glb" else scene.graph.transforms.parents[node] if several else node
            groups.setdefault(key, []).append((trimesh.transform_points(mesh.vertices, matrix), mesh.faces))
    return [_joined(group) for group in groups.values()]


def _collada(path: Path) -> MeshParts:
    """Return the parts of a Collada file, one for each mesh in the scene."""
    root = parse_xml(path)  # refuses entities
    _check_count(_nodes(root), MOST_GEOMS, "nodes")
    try:
        import collada
    except ImportError:
        raise ImportError("install artgen[referee]") from None

    errors = collada.common.DaeUnsupportedError, collada.common.DaeBrokenRefError  # of materials, mostly
    document = collada.Collada(BytesIO(path.read_bytes()), ignore=list(errors))
    unit, parts = document.assetInfo.unitmeter or 1.0, []
    for mesh in document.scene.objects("geometry"):
        sets = [each.triangleset() if hasattr(each, "triangleset") else each for each in mesh.primitives()]
        found = [
            each for each in sets if isinstance(each, collada.triangleset.BoundTriangleSet) and len(each)
        ]
        if found:
            parts.append(_joined([(each.vertex * unit, each.vertex_index) for each in found]))
    return parts


def _nodes(root: Element) -> int:
    """Return the number of nodes of a Collada scene; instances of instances multiply."""
    named = {node.get("id"): node for node in root.iter() if node.tag.endswith("node")}
    known: dict[ET.Element, int] = {}

    def count(node: ET.Element) -> int:
        if node not in known:
            known[node] = 0  # a circle, which the library refuses
            targets = [named.get(child.get("url", "")[1:]) for child in node]
            inner = [child for child in node if child.tag.endswith("node")]
            known[node] = (
                1 + sum(map(count, inner)) + sum(count(each) for each in targets if each is not None)
            )
        return known[node]

    return sum(count(scene) for scene in root.iter() if scene.tag.endswith("visual_scene"))


def _check_count(count: int, most: int, what: str) -> None:
    if count > most:
        raise AssetError(f"it has more than {most} {what}, which are not read; simplify it")


def _joined(parts: MeshParts) -> tuple[Array, Indices]:
    """Return the meshes as one."""
    starts = np.cumsum([0, *(len(vertices) for vertices, _ in parts)])
    triangles = [np.asarray(each) + start for (_, each), start in zip(parts, starts, strict=False)]
    return np.concatenate([vertices for vertices, _ in parts]), np.concatenate(triangles)
