"""Approximate convex pieces of a mesh of unknown construction: CoACD with a disk cache, or single hulls."""

import hashlib
import json
import sys
from collections.abc import Sequence
from contextlib import suppress
from typing import Any

import numpy as np
from numpy.typing import NDArray

from artgen import _disk_cache as disk_cache
from artgen._arrays import Array
from artgen.colliders.convex import TOLERANCE, Convex
from artgen.colliders.enclose import Facets, enclosing


def single_hull(points: Array, most_vertices: int = 64) -> Convex:
    """Return the convex hull of points, shape (n, 3) [m], or a polytope with fewer vertices around it.

    The result does not depend on the order of the points.

    Raises:
        ValueError: The points are fewer than four, not finite, or lie in one plane.
    """
    piece = Convex.hull(points)
    if piece.kind != "hull" or len(piece.points) <= most_vertices:
        return piece
    return Convex.hull(enclosing(Facets.hull(piece.points), most_vertices, TOLERANCE)[0])


def fewest(pieces: Sequence[Convex], most_pieces: int) -> list[tuple[Convex, tuple[int, ...]]]:
    """Join pieces until they are few enough, starting with pairs whose common bounding box adds least volume.

    Args:
        pieces: The pieces, each with few enough vertices.
        most_pieces: Largest number of pieces, at least 1.

    Returns:
        Each piece with the numbers of the pieces that it replaces.
    """
    groups: list[tuple[int, ...]] = [(number,) for number in range(len(pieces))]
    boxes = np.array([piece.bounds() for piece in pieces]).reshape(-1, 2, 3)
    while len(groups) > most_pieces:
        lower = np.minimum(boxes[:, None, 0], boxes[None, :, 0])
        upper = np.maximum(boxes[:, None, 1], boxes[None, :, 1])
        volume = np.prod(boxes[:, 1] - boxes[:, 0], axis=1)
        added = np.prod(upper - lower, axis=2) - volume[:, None] - volume
        added[np.tril_indices(len(groups))] = np.inf
        first, second = divmod(int(np.argmin(added)), len(groups))
        groups[first] += groups.pop(second)
        boxes[first] = (lower[first, second], upper[first, second])
        boxes = np.delete(boxes, second, axis=0)
    return [(_around([pieces[number] for number in group]), group) for group in groups]


def _around(pieces: Sequence[Convex]) -> Convex:
    if len(pieces) == 1:
        return pieces[0]
    return single_hull(np.concatenate([piece.outer_points() for piece in pieces]))


_FORMAT = "artgen-pieces-1"  # of the files of the cache
_SEED = 0
_MOST_OUTPUT = 200  # most characters of its output in a message
_DECIMALS = 9  # decimals of vertices for CoACD, equal to those of exported colliders [m]
_MOST_SECONDS = 300.0  # a run of minutes never ends; usual runs take seconds
# CoACD's own preprocessing replaces good meshes by coarse ones and sometimes ends the process: use the mesh
# unchanged, and the coarse one only if that ends the process
_ATTEMPTS = ("off", "on")
_PROGRAM = """
import io, json, sys
import coacd, numpy
settings = json.loads(sys.argv[1])
with numpy.load(io.BytesIO(sys.stdin.buffer.read()), allow_pickle=False) as given:
    mesh = coacd.Mesh(given["vertices"], given["triangles"])
coacd.set_log_level("off")
hulls = [points for points, _ in coacd.run_coacd(mesh, **settings)]
found = io.BytesIO()
numpy.savez(found, points=numpy.concatenate(hulls), counts=numpy.array([len(points) for points in hulls]))
sys.stdout.buffer.write(found.getvalue())
"""


def coacd_pieces(
    vertices: Array,
    triangles: NDArray[np.int64],
    threshold: float = 0.05,
    *,
    most_pieces: int = 64,
    most_vertices: int = 64,
) -> tuple[Convex, ...]:
    """Decompose a closed mesh into convex hulls.

    The hulls follow the surface to about `threshold` times the size of the mesh and need not contain it:
    prefer pieces from the construction of a solid. CoACD runs in its own process, which it may end. Results
    are cached on disk: the same mesh, in any order, is decomposed once.

    Args:
        vertices: Positions, each point once, shape (n, 3) [m].
        triangles: Vertex indices, counter-clockwise seen from outside, shape (m, 3). They must form a closed
            manifold with one connected part, because CoACD often fails on several parts.
        threshold: Concavity allowed in a piece, relative to the size of the mesh, 0.01 to 1.
        most_pieces: Largest number of hulls.
        most_vertices: Largest number of vertices of a hull.

    Raises:
        ImportError: The package `coacd` is not installed.
        ValueError: The threshold is out of range, or CoACD fails on the mesh.
    """
    if not 0.01 <= threshold <= 1.0:
        raise ValueError(f"the threshold of CoACD must be within 0.01 and 1, got {threshold}")
    settings: dict[str, float | str] = {
        "threshold": float(threshold),
        "max_convex_hull": most_pieces,
        "decimate": True,
        "max_ch_vertex": most_vertices,
        "seed": _SEED,
    }
    vertices, triangles = canonical(vertices, triangles)
    head = {
        **settings,
        "format": _FORMAT,
        "attempts": " ".join(_ATTEMPTS),
        "version": _version(),
        "vertices": len(vertices),
        "triangles": len(triangles),
    }
    digest = hashlib.sha256(json.dumps(head, sort_keys=True).encode())
    digest.update(np.ascontiguousarray(vertices, "<f8").tobytes())
    digest.update(np.ascontiguousarray(triangles, "<i8").tobytes())
    key = f"{digest.hexdigest()}.npz"
    found = disk_cache.unpacked(disk_cache.read("coacd", key))
    if found is None:
        found = _run(vertices, triangles, settings)
        with suppress(OSError):
            disk_cache.write("coacd", key, disk_cache.packed(found))
    hulls = np.split(found["points"], np.cumsum(found["counts"])[:-1])
    pieces = [_hull(points, most_vertices) for points in hulls]
    return tuple(piece for piece in pieces if piece is not None)


def canonical(vertices: Array, triangles: NDArray[np.int64]) -> tuple[Array, NDArray[np.int64]]:
    """Round vertices like exported ones, and sort vertices and triangles by value."""
    rounded: Array = np.round(vertices, _DECIMALS) + 0.0
    order = np.lexsort(rounded.T[::-1])
    number = np.empty(len(order), np.int64)
    number[order] = np.arange(len(order))
    corners = number[triangles]
    turned = np.argmin(corners, axis=1)[:, None] + np.arange(3)
    corners = np.take_along_axis(corners, turned % 3, axis=1)
    return rounded[order], corners[np.lexsort(corners.T[::-1])]


def _version() -> str:
    from importlib import metadata  # slow to import

    try:
        return metadata.version("coacd")
    except metadata.PackageNotFoundError as error:
        raise ImportError("decomposing a mesh needs CoACD: pip install coacd") from error


def _run(
    vertices: Array, triangles: NDArray[np.int64], settings: dict[str, float | str]
) -> dict[str, NDArray[Any]]:
    """Return the points of the hulls and their counts, equal in every process with any number of cores."""
    import subprocess  # slow to import

    given = disk_cache.packed({"vertices": vertices, "triangles": triangles.astype(np.int32)})
    for attempt in _ATTEMPTS:
        arguments = json.dumps({**settings, "preprocess_mode": attempt})
        # P: a module `coacd` in this folder must not hide the package
        command = [sys.executable, "-P", "-c", _PROGRAM, arguments]
        try:
            done = subprocess.run(  # noqa: S603 - the program above
                command, input=given, capture_output=True, check=True, timeout=_MOST_SECONDS
            )
        except subprocess.TimeoutExpired:
            reason = f"it took more than {_MOST_SECONDS:.0f} s"
        except subprocess.CalledProcessError as error:
            output = " ".join(error.stderr.decode(errors="replace").split())
            reason = output or f"exit code {error.returncode}"
        else:
            if (found := disk_cache.unpacked(done.stdout)) is not None:
                return found
            reason = "its output is damaged"
    raise ValueError(f"CoACD fails on a mesh of {len(triangles)} triangles: {reason[-_MOST_OUTPUT:]}")


def _hull(points: Array, most_vertices: int) -> Convex | None:
    """Return the hull of points, or None for points in one plane."""
    try:
        return single_hull(points, most_vertices)
    except ValueError:
        return None
