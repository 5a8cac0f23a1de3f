"""Approximate convex pieces of a mesh of unknown making, by CoACD; an optional dependency."""

import numpy as np
from numpy.typing import NDArray

from artgen.colliders.convex import Array, Convex

_SEED = 0


def coacd_pieces(
    vertices: Array, triangles: NDArray[np.int64], threshold: float = 0.05, *, most_vertices: int = 64
) -> tuple[Convex, ...]:
    """Decompose a closed mesh to convex hulls.

    The hulls follow the surface to about `threshold` times the size of the mesh and need not contain it:
    prefer pieces known from how a solid was made.

    Args:
        vertices: Positions, shape (n, 3) [m].
        triangles: Vertex indices, counter-clockwise seen from outside, shape (m, 3).
        threshold: Concavity allowed in a piece, relative to the size of the mesh, 0.01 to 1.
        most_vertices: How many vertices a hull may have.

    Raises:
        ImportError: The package `coacd` is not installed.
        ValueError: The threshold is out of range.
    """
    if not 0.01 <= threshold <= 1.0:
        raise ValueError(f"the threshold of CoACD must be within 0.01 and 1, got {threshold}")
    try:
        import coacd
    except ImportError as error:
        raise ImportError("decomposing a mesh needs CoACD: pip install coacd") from error
    coacd.set_log_level("off")
    hulls = coacd.run_coacd(
        coacd.Mesh(np.ascontiguousarray(vertices, np.float64), np.ascontiguousarray(triangles, np.int32)),
        threshold=threshold,
        decimate=True,
        max_ch_vertex=most_vertices,
        seed=_SEED,
    )
    return tuple(Convex.hull(np.asarray(points, np.float64)) for points, _ in hulls)
