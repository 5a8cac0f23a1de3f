"""Half sections of round solids: the (r, z) contours that `lathe` turns."""

import math

import numpy as np

from artgen._arrays import Array
from artgen.asset.outline import Contour
from artgen.nodes.contours import arc_points, faceted, rounded_polygon
from artgen.nodes.surfaces import sides_of


def axial(radius: float, half: float, bevel: float, top_radius: float | None = None) -> Contour:
    """Return the (r, z) half section of a cylinder or frustum, its rims rounded."""
    top = radius if top_radius is None else top_radius
    corners = [(0.0, -half), (radius, -half), (top, half), (0.0, half)]
    points = np.array([corner for at, corner in enumerate(corners) if at in (0, 3) or corner[0] > 0.0])
    if bevel == 0.0:
        return faceted(points)
    return rounded_polygon(points, [bevel if point[0] > 0.0 else 0.0 for point in points])


def half_ellipse(radius: float, half: float, start: float) -> Contour:
    """Return the (r, z) section of an ellipsoid from an angle [rad] to its upper pole."""
    sides = sides_of(max(radius, half))
    steps = max(2, math.ceil(sides * (0.5 * math.pi - start) / math.tau - 1e-9))
    unit, _ = arc_points(np.zeros(2), 1.0, start, 0.5 * math.pi - start, steps)
    normals = unit / np.array([radius, half])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    return onto_axis(unit * np.array([radius, half]), normals)


def onto_axis(points: Array, normals: Array) -> Contour:
    """Close a smooth (r, z) line along the axis (and along a flat base where it starts away from it)."""
    points, normals = points.copy(), normals.copy()
    points[-1, 0] = 0.0
    if points[0, 0] > 1e-9:
        points = np.concatenate([[[0.0, points[0, 1]]], points])
        base = np.array([[0.0, -1.0]])
        arriving = np.concatenate([[[-1.0, 0.0]], base, normals[1:]])
        leaving = np.concatenate([base, normals[:-1], [[-1.0, 0.0]]])
        return Contour(points, arriving, leaving)
    points[0, 0] = 0.0
    arriving, leaving = normals.copy(), normals.copy()
    arriving[0] = leaving[-1] = (-1.0, 0.0)
    return Contour(points, arriving, leaving)
