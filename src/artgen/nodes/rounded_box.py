"""Mesh of a box with rounded edges: the mesh of a sphere, pulled apart to the corners of the box."""

import numpy as np

from artgen._arrays import Array, Indices, cached
from artgen.nodes.surfaces import Skin
from artgen.nodes.unwrap import grain_of


@cached(16)
def _unit_box(steps: int) -> tuple[Array, Array, Array, Indices, Indices]:
    """Return directions, signs and arcs (n, 3) of a box with rounded edges, its triangles and its targets.

    An arc is the distance of a vertex from the flat part of its face along the rounded edge, in radii of the
    edge.
    """
    quarter = np.tan(np.linspace(0.0, np.pi / 4.0, steps + 1)) if steps else np.zeros(1)
    across = np.concatenate([-quarter[::-1], quarter])
    side = np.concatenate([-np.ones(steps + 1), np.ones(steps + 1)])
    count = len(across)
    directions = np.zeros((6, count, count, 3))
    signs = np.zeros((6, count, count, 3))
    arcs = np.zeros((6, count, count, 3))
    for face in range(6):
        axis, sign = face // 2, 1.0 - 2.0 * (face % 2)
        u, v = (axis + 1) % 3, (axis + 2) % 3
        directions[face, ..., axis] = signs[face, ..., axis] = sign
        directions[face, ..., u] = across[:, None] * sign
        directions[face, ..., v] = across[None, :]
        signs[face, ..., u] = side[:, None] * sign
        signs[face, ..., v] = side[None, :]
        arcs[face, ..., u] = np.arctan(across)[:, None] * sign
        arcs[face, ..., v] = np.arctan(across)[None, :]
    directions /= np.linalg.norm(directions, axis=-1, keepdims=True)
    cell = np.arange(count - 1)
    corner = cell[:, None] * count + cell[None, :]
    quads = np.stack(
        [corner, corner + count, corner + count + 1, corner, corner + count + 1, corner + 1], axis=-1
    ).reshape(-1, 3)
    triangles = np.concatenate([quads + face * count * count for face in range(6)])
    flat_directions, flat_signs, flat_arcs = (each.reshape(-1, 3) for each in (directions, signs, arcs))
    # a vertex on the border of a face is also on its neighbor: same direction and, unless the box is sharp
    # (then the direction is the face's), same corner
    where = flat_signs if steps == 0 else np.concatenate([flat_directions, flat_signs], axis=1)
    _, first, group = np.unique(np.rint(where * 1e6), axis=0, return_index=True, return_inverse=True)
    targets = first[group.ravel()]
    for array in (flat_directions, flat_signs, flat_arcs, triangles, targets):
        array.flags.writeable = False
    return flat_directions, flat_signs, flat_arcs, triangles, targets


def rounded_box(size: Array, bevel: float, steps: int) -> Skin:
    """Make a box about the origin with rounded edges and corners."""
    directions, signs, arcs, triangles, targets = _unit_box(steps)
    half = size / 2.0
    radius = min(bevel, 0.999 * float(half.min())) if steps else 0.0
    inner = signs * (half - radius)
    vertices = inner + directions * radius
    u, v, sense = _layout(len(vertices), tuple(grain_of(size, but=axis) for axis in range(3)))
    laid = inner + arcs * radius
    row = np.arange(len(vertices))
    uvs = np.stack([laid[row, u] * sense, laid[row, v]], axis=-1)
    return Skin(vertices, directions, uvs, triangles, targets)


@cached(128)
def _layout(count: int, grains: tuple[int, ...]) -> tuple[Indices, Indices, Array]:
    """Return which coordinates are u and v of each vertex, and the direction of u, all shape (count,)."""
    sides = [
        (3 - axis - grain, grain, side if (axis - grain) % 3 == 1 else -side)  # u is v x normal
        for axis, grain in enumerate(grains)
        for side in (1, -1)
    ]
    u, v, sense = np.repeat(np.array(sides), count // 6, axis=0).T
    return u, v, sense.astype(float)
