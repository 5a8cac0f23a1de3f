"""Approximate convex pieces of a mesh of unknown making, by CoACD."""

import io
import json
import subprocess
import sys
from importlib import metadata

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array
from artgen.colliders.cache import digest, read_points, write_points
from artgen.colliders.convex import Convex
from artgen.colliders.single import single_hull

THRESHOLD = 0.05
"""Concavity that CoACD allows in a piece unless said otherwise, relative to the size of the mesh."""

_SEED = 0
_MOST_SAID = 200  # characters of what it printed
_DECIMALS = 9  # of a vertex that CoACD sees [m]: those of colliders as they are exported
_MOST_SECONDS = 300.0  # what takes minutes never ends; else a solid takes seconds
# CoACD's own check of a mesh replaces good ones by coarse ones, and at times ends the process; so the mesh
# is taken as it is, and where that ends the process, the coarse one
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
    threshold: float = THRESHOLD,
    *,
    most_pieces: int = 64,
    most_vertices: int = 64,
) -> tuple[Convex, ...]:
    """Decompose a closed mesh to convex hulls.

    The hulls follow the surface to about `threshold` times the size of the mesh and need not contain it:
    prefer pieces known from how a solid was made. CoACD runs in a process of its own, which it may end. What
    it found is kept on disk, see `artgen.colliders.cache`: the same mesh, in whatever order, is decomposed
    once.

    Args:
        vertices: Positions, each point once, shape (n, 3) [m].
        triangles: Vertex indices, counter-clockwise seen from outside, shape (m, 3). They must close to a
            manifold; of one connected part, as CoACD is likely to fail on several.
        threshold: Concavity allowed in a piece, relative to the size of the mesh, 0.01 to 1.
        most_pieces: How many hulls there may be.
        most_vertices: How many vertices a hull may have.

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
    key = digest(vertices, triangles, {**settings, "attempts": " ".join(_ATTEMPTS), "version": _version()})
    found = read_points("coacd", key)
    if found is None:
        found = _run(vertices, triangles, settings)
        write_points("coacd", key, found)
    hulls = [_hull(points, most_vertices) for points in found]
    return tuple(hull for hull in hulls if hull is not None)


def canonical(vertices: Array, triangles: NDArray[np.int64]) -> tuple[Array, NDArray[np.int64]]:
    """Round vertices as they are exported, and put them and the triangles in an order of their values."""
    rounded: Array = np.round(vertices, _DECIMALS) + 0.0
    order = np.lexsort(rounded.T[::-1])
    number = np.empty(len(order), np.int64)
    number[order] = np.arange(len(order))
    corners = number[triangles]
    turned = np.argmin(corners, axis=1)[:, None] + np.arange(3)
    corners = np.take_along_axis(corners, turned % 3, axis=1)
    return rounded[order], corners[np.lexsort(corners.T[::-1])]


def _version() -> str:
    try:
        return metadata.version("coacd")
    except metadata.PackageNotFoundError as error:
        raise ImportError("decomposing a mesh needs CoACD: pip install coacd") from error


def _run(vertices: Array, triangles: NDArray[np.int64], settings: dict[str, float | str]) -> list[Array]:
    """Return the points of the hulls; the same ones in every process, on however many cores."""
    given = io.BytesIO()
    np.savez(given, vertices=vertices, triangles=triangles.astype(np.int32))
    said = ""
    for attempt in _ATTEMPTS:
        arguments = json.dumps({**settings, "preprocess_mode": attempt})
        # -P: a module `coacd` beside this one is not the package
        command = [sys.executable, "-P", "-c", _PROGRAM, arguments]
        try:
            done = subprocess.run(  # noqa: S603 - the program above
                command, input=given.getvalue(), capture_output=True, check=True, timeout=_MOST_SECONDS
            )
        except subprocess.TimeoutExpired:
            said = f"it took more than {_MOST_SECONDS:.0f} s"
        except subprocess.CalledProcessError as error:
            said = " ".join(error.stderr.decode(errors="replace").split()) or f"exit code {error.returncode}"
        else:
            with np.load(io.BytesIO(done.stdout), allow_pickle=False) as found:
                return np.split(found["points"], np.cumsum(found["counts"])[:-1])
    raise ValueError(f"CoACD fails on a mesh of {len(triangles)} triangles: {said[-_MOST_SAID:]}")


def _hull(points: Array, most_vertices: int) -> Convex | None:
    """Return the hull of points, or None where they lie in one plane."""
    try:
        return single_hull(points, most_vertices)
    except ValueError:
        return None
