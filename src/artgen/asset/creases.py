"""Normals of bare triangles: smooth where they turn a little, split at creases."""

import math
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array
from artgen.colliders.triangles import cross


def corner_normals(
    triangles: NDArray[np.int64], corners: Array, crease: float, *, by: Literal["angle", "area"] = "angle"
) -> Array:
    """Return a normal for each corner of each triangle, shape (3 m, 3), smooth across shallow edges."""
    count = len(triangles)
    across = cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    areas = np.linalg.norm(across, axis=1)  # twice
    flat = across / np.maximum(areas, 1e-300)[:, None]
    following, before = np.roll(corners, -1, axis=1) - corners, np.roll(corners, 1, axis=1) - corners
    cosine = np.einsum("ijk,ijk->ij", following, before)
    angle = np.arctan2(np.broadcast_to(areas[:, None], cosine.shape), cosine).ravel()
    share = angle * np.repeat(areas, 3) if by == "area" else angle
    vertex = triangles.ravel()
    face = np.repeat(np.arange(count), 3)
    order = np.argsort(vertex, kind="stable")
    start = np.searchsorted(vertex[order], np.arange(vertex.max() + 2))
    fans = np.diff(start)
    normals = np.zeros((3 * count, 3))
    for size in np.unique(fans[fans > 0]).tolist():
        heads = start[:-1][fans == size]
        corner = order[heads[:, None] + np.arange(size)]
        turned = flat[face[corner]]
        near = np.einsum("vik,vjk->vij", turned, turned) > math.cos(crease)
        weight = near * share[corner][:, None, :]
        normals[corner.ravel()] = np.einsum("vij,vjk->vik", weight, turned).reshape(-1, 3)
    length = np.linalg.norm(normals, axis=1, keepdims=True)
    return np.where(length > 1e-12, normals / np.maximum(length, 1e-300), np.repeat(flat, 3, axis=0))
