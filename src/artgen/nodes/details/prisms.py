"""Extrusions of outlines with many borders, such as dots, letters and holes: all built at once."""

from collections.abc import Sequence

import numpy as np

from artgen._arrays import Array, Indices
from artgen.asset.outline import Contour
from artgen.nodes.surfaces import Skin, triangulated


def prisms(contours: Sequence[Contour], length: float) -> Skin:
    """Extrude contours along z, centred on z = 0, with sharp edges.

    Every vertex has three copies at either end: for the side that arrives, for the side that leaves and for
    the flat end. A loop over the contours would take ten times as long for hundreds of them.
    """
    plan = np.concatenate([contour.points for contour in contours])
    counts = np.array([len(contour.points) for contour in contours])
    begins = np.cumsum(counts) - counts
    following = np.arange(1, len(plan) + 1)
    following[begins + counts - 1] = begins
    level = np.array([-length / 2.0, length / 2.0])
    side = np.sign(level)
    vertices = np.empty((2, 3, len(plan), 3))
    vertices[..., :2] = plan
    vertices[..., 2] = level[:, None, None]
    normals = np.zeros_like(vertices)
    normals[:, 0, :, :2] = np.concatenate([contour.normals_in for contour in contours])
    normals[:, 1, :, :2] = np.concatenate([contour.normals_out for contour in contours])
    normals[:, 2, :, 2] = side[:, None]
    leaving, arriving = _distances(plan, following, begins, counts)
    uvs = np.empty((2, 3, len(plan), 2))
    uvs[:, 0, :, 0], uvs[:, 1, :, 0] = arriving, leaving
    uvs[:, :2, :, 1] = level[:, None, None]
    uvs[:, 2] = plan * np.stack([side, np.ones(2)], axis=1)[:, None]
    index = np.arange(6 * len(plan)).reshape(2, 3, len(plan))
    low, high, end = index[0, 1], index[1, 1], index[:, 0][:, following]
    walls = np.stack([low, end[0], end[1], low, end[1], high], axis=-1).reshape(-1, 3)
    lid = triangulated([contour.points for contour in contours])
    triangles = np.concatenate([walls, index[1, 2][lid], index[0, 2][lid[:, ::-1]]])
    targets = np.ascontiguousarray(np.broadcast_to(index[:, :1], index.shape)).reshape(-1)
    return Skin(vertices.reshape(-1, 3), normals.reshape(-1, 3), uvs.reshape(-1, 2), triangles, targets)


def _distances(plan: Array, following: Indices, begins: Indices, counts: Indices) -> tuple[Array, Array]:
    """Return how far along its contour each vertex is left and reached, both shape (n,) [m]."""
    sides = np.linalg.norm(plan[following] - plan, axis=1)
    total = np.concatenate([[0.0], np.cumsum(sides)])
    leaving = total[:-1] - np.repeat(total[begins], counts)
    arriving = leaving.copy()
    arriving[begins] = total[begins + counts] - total[begins]
    return leaving, arriving
