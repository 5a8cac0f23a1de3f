"""Triangles without height: what joins meshes leaves none, nor an edge that passes a vertex."""

from collections import Counter

import numpy as np
import pytest

import artgen
from artgen.asset.shape import Mesh
from artgen.asset.surface import joined

UP = (0.0, 0.0, 1.0)
TO_FRONT = (0.0, -1.0, 0.0)


def mesh_of(points, triangles, normals) -> Mesh:
    vertices = np.array(points, float)
    uvs = vertices[:, :2] + vertices[:, 2:]
    return Mesh(
        vertices, np.array(normals, float), uvs, np.zeros(len(vertices), np.int64), np.array(triangles)
    )


def areas(mesh: Mesh) -> np.ndarray:
    a, b, c = (mesh.vertices[corners] for corners in mesh.triangles.T)
    return 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)


def open_edges(mesh: Mesh) -> int:
    """How many edges, by position, have a triangle on one side only."""
    places = [tuple(point) for point in np.rint(1e7 * mesh.vertices).astype(int).tolist()]
    sides = Counter(
        (places[a], places[b]) for t in mesh.triangles.tolist() for a, b in zip(t, t[1:] + t[:1], strict=True)
    )
    assert max(sides.values()) == 1, "an edge has two triangles on one side"
    return sum((b, a) not in sides for a, b in sides)


# a square of side 1 whose lower edge has corners at 0.25 and 0.5, seen from above
RIM = [(0, 0, 0), (0.25, 0, 0), (0.5, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]


@pytest.mark.parametrize(
    "triangles",
    [
        [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]],  # needles beside each other, then what lies beyond
        [[0, 1, 3], [1, 2, 3], [0, 3, 5], [3, 4, 5]],
        [[1, 2, 3], [0, 1, 3], [0, 3, 4], [0, 4, 5]],
    ],
)
def test_needles_within_a_face_go(triangles) -> None:
    mesh = joined([mesh_of(RIM, triangles, [UP] * 6)])
    assert areas(mesh).min() > 0.01
    assert areas(mesh).sum() == pytest.approx(1.0)
    assert len(mesh.vertices) == 6
    assert open_edges(mesh) == 6
    np.testing.assert_array_equal(mesh.normals, [UP] * 6)


def test_needles_that_share_their_long_sides_leave_no_gap() -> None:
    points = [*RIM[:4], (0.5, 1, 0), (0.5, -1, 0)]
    needles = [[0, 3, 1], [0, 2, 3]]
    mesh = joined(
        [mesh_of(points, [*needles, [0, 1, 4], [1, 3, 4], [0, 5, 2], [2, 5, 3]], [UP] * len(points))]
    )
    assert areas(mesh).min() > 0.01
    assert areas(mesh).sum() == pytest.approx(1.0)
    assert open_edges(mesh) == 4


def test_face_around_the_corner_gets_a_vertex_of_its_own() -> None:
    """The needle is one of the upper face, its long side the edge that it shares with the front."""
    top = mesh_of(RIM, [[0, 3, 1], [1, 3, 4], [1, 4, 5], [1, 5, 0]], [UP] * 6)
    front = mesh_of([(0, 0, -1), (1, 0, -1), (1, 0, 0), (0, 0, 0)], [[0, 1, 2], [0, 2, 3]], [TO_FRONT] * 4)
    mesh = joined([top, front])
    assert areas(mesh).min() > 0.01
    assert areas(mesh).sum() == pytest.approx(2.0)
    assert open_edges(mesh) == 6, "the border, and not the edge between the faces"
    at = np.flatnonzero(np.abs(mesh.vertices - RIM[1]).max(axis=1) < 1e-9)
    assert sorted(mesh.normals[at].tolist()) == sorted([list(TO_FRONT), list(UP)])
    np.testing.assert_allclose(mesh.uvs[at], np.tile(mesh.uvs[at[0]], (2, 1)), atol=1e-12)


def test_needle_at_the_border_just_goes() -> None:
    mesh = joined([mesh_of(RIM, [[0, 3, 1], [1, 3, 4], [1, 4, 5], [1, 5, 0]], [UP] * 6)])
    assert areas(mesh).min() > 0.01
    assert areas(mesh).sum() == pytest.approx(1.0)


@pytest.mark.parametrize(("category", "seed"), [("box", 1), ("plier", 0), ("plier", 1), ("window", 1)])
def test_no_triangle_of_an_asset_is_without_area(category, seed) -> None:
    asset = artgen.generate(category, seed=seed, certify=False)
    for link in asset.links:
        for surface in link.surfaces:
            assert areas(surface.mesh).min() > 0.0, f"{link.name}: {surface.name}"
