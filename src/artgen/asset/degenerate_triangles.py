"""Triangles without height, as unions and differences leave them along straight rims."""

from collections import deque

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array, Indices

_SAME = 1e-6  # by how much position [m], normal and texture coordinates of one vertex differ
_ROUNDS = 8  # how often each needle is looked at: the ones beside it may have to go first


def needles(positions: Indices, corners: Indices) -> NDArray[np.bool_]:
    """Tell which triangles are lower than one step, shape (m,)."""
    a, b, c = (positions[:, each] for each in corners)
    first, second, third = b - a, c - b, a - c
    x, y, z = (first[i] * second[j] - first[j] * second[i] for i, j in ((1, 2), (2, 0), (0, 1)))
    longest = np.max([(side * side).sum(axis=0) for side in (first, second, third)], axis=0)
    return np.asarray(x.astype(float) ** 2 + y.astype(float) ** 2 + z.astype(float) ** 2 < longest)


def without_needles(
    rows: Array, place: Indices, corners: Indices, flat: NDArray[np.bool_]
) -> tuple[Array, Indices]:
    """Leave needles out; the triangle beyond the long side of each is divided at the corner between its ends.

    So no edge is left whose ends another edge passes. The ones at the border of a surface just go.
    """
    vertices, places = list(rows), place.tolist()
    triangles: list[list[int]] = corners.T.tolist()
    sides = {
        (places[one], places[other]): number
        for number, (a, b, c) in enumerate(triangles)
        for one, other in ((a, b), (b, c), (c, a))
    }
    waiting = deque(np.flatnonzero(flat).tolist())
    gone = set(waiting)
    for _ in range(_ROUNDS * len(waiting)):
        if not waiting:
            break
        number = waiting.popleft()
        middle, start, end = _from_middle(triangles[number], vertices)
        beyond = sides.get((places[end], places[start]))
        if beyond is None:
            continue
        if beyond in gone:
            if beyond in waiting:
                waiting.append(number)
            continue
        one, other, apex = _from_side(triangles[beyond], places, places[end])
        if (one, other) != (end, start):  # another face: it has a vertex of its own there
            middle = _vertex_between(vertices, places, middle, one, other)
        triangles[beyond] = [one, middle, apex]
        triangles.append([middle, other, apex])
        sides[places[one], places[middle]] = sides[places[middle], places[apex]] = beyond
        for first, second in ((middle, other), (other, apex), (apex, middle)):
            sides[places[first], places[second]] = len(triangles) - 1
    left = [triangle for number, triangle in enumerate(triangles) if number not in gone]
    return np.array(vertices), np.ascontiguousarray(np.array(left, np.int64).reshape(-1, 3).T)


def _from_middle(triangle: list[int], vertices: list[Array]) -> tuple[int, int, int]:
    """Return the corners of a needle in their order, from the one between the others."""
    at = np.array([vertices[corner][:3] for corner in triangle])
    opposite = np.square(at[[2, 0, 1]] - at[[1, 2, 0]]).sum(axis=1)
    return _from(triangle, int(opposite.argmax()))


def _from_side(triangle: list[int], places: list[int], place: int) -> tuple[int, int, int]:
    """Return the corners of a triangle in their order, from the one at a place."""
    return _from(triangle, [places[corner] for corner in triangle].index(place))


def _from(triangle: list[int], number: int) -> tuple[int, int, int]:
    return triangle[number], triangle[number - 2], triangle[number - 1]


def _vertex_between(vertices: list[Array], places: list[int], at: int, one: int, other: int) -> int:
    """Return a vertex on the side between two, at the place of another; a new one unless there is one."""
    start, end, position = vertices[one], vertices[other], vertices[at][:3]
    along = end[:3] - start[:3]
    share = float((position - start[:3]) @ along / (along @ along))
    row = (1.0 - share) * start + share * end
    row[:3] = position
    row[3:6] /= np.linalg.norm(row[3:6])
    for number, place in enumerate(places):
        if place == places[at] and np.abs(vertices[number] - row).max() < _SAME:
            return number
    vertices.append(row)
    places.append(places[at])
    return len(vertices) - 1
