"""Surfaces joined of several meshes: which corners are one vertex, and in which order all comes."""

from collections import defaultdict
from dataclasses import replace

import numpy as np
import pytest

import artgen
from artgen.asset import surface as module
from artgen.asset.shape import Mesh
from artgen.asset.surface import as_written, joined

PLAIN = artgen.material("abs")


def square(x: float, y: float) -> Mesh:
    """A flat square of side 1 with its lower left corner there."""
    corners = np.array([[x, y, 0.0], [x + 1, y, 0.0], [x + 1, y + 1, 0.0], [x, y + 1, 0.0]])
    normals = np.tile([0.0, 0.0, 1.0], (4, 1))
    triangles = np.array([[0, 1, 2], [0, 2, 3]])
    return Mesh(corners, normals, corners[:, :2].copy(), np.zeros(4, np.int64), triangles)


def fans_at_most(mesh: Mesh) -> int:
    """Return into how many fans the triangles about a vertex fall at most."""
    ahead: dict[int, dict[int, int]] = defaultdict(dict)
    for a, b, c in mesh.triangles.tolist():
        for vertex, following, preceding in ((a, b, c), (b, c, a), (c, a, b)):
            ahead[vertex][following] = preceding
    most = 0
    for steps in ahead.values():
        count, left = 0, dict(steps)
        starts = [corner for corner in steps if corner not in steps.values()]
        for start in [*starts, *steps]:
            corner, count = start, count + (start in left)
            while corner in left:
                corner = left.pop(corner)
        most = max(most, count)
    return most


@pytest.mark.parametrize("order", [(0, 1), (1, 0)])
def test_squares_side_by_side_share_two_vertices(order) -> None:
    squares = [square(0, 0), square(1, 0)]
    mesh = joined([squares[number] for number in order])
    assert len(mesh.vertices) == 6
    assert fans_at_most(mesh) == 1


@pytest.mark.parametrize("places", [[(0, 0), (1, 1)], [(0, 0), (1, 1), (0, 1.5)], [(0, 0), (1, 1), (2, 0)]])
def test_squares_that_touch_in_a_corner_share_none(places) -> None:
    squares = [square(*place) for place in places]
    mesh = joined(squares)
    assert len(mesh.vertices) == 4 * len(squares), "faces that touch in one point share a vertex there"
    again = joined(squares[::-1])
    for name in ("vertices", "normals", "uvs", "triangles"):
        assert np.array_equal(getattr(mesh, name), getattr(again, name)), name
    corners = mesh.vertices[mesh.triangles]
    area = 0.5 * np.linalg.norm(
        np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1
    )
    assert area.sum() == pytest.approx(len(squares))


def test_four_squares_about_a_point_share_it() -> None:
    mesh = joined([square(x, y) for x in (0, 1) for y in (0, 1)])
    assert len(mesh.vertices) == 9
    assert fans_at_most(mesh) == 1


@pytest.mark.parametrize("seed", [2, 4, 7, 12, 28])
def test_no_vertex_of_a_door_has_two_fans(seed) -> None:
    asset = artgen.generate("door", seed=seed, certify=False)
    for link in asset.links:
        for surface in link.surfaces:
            assert fans_at_most(surface.mesh) == 1, f"{link.name}: {surface.name}"


def test_the_order_of_triangles_does_not_depend_on_how_it_is_found(monkeypatch) -> None:
    asset = artgen.generate("handle", seed=3, certify=False)
    meshes = [surface.mesh for link in asset.links for surface in link.surfaces]
    packed = joined(meshes)
    corners = packed.triangles.tolist()
    assert corners == sorted(corners)
    assert all(first < min(second, third) for first, second, third in corners)
    monkeypatch.setattr(module, "_MOST_PACKED", 1)
    assert np.array_equal(joined(meshes).triangles, packed.triangles)


@pytest.mark.parametrize("noise", [-1e-16, 0.0, 1e-16])
def test_the_order_of_vertices_is_that_in_the_frame_of_the_link(noise) -> None:
    # places a rounding step apart, which lie in the middle of two steps in asset coordinates
    origin = np.array([0.0, -0.02690625 + noise, 0.0])
    sheets = [square(0.0, 1e-7 * number - 0.0088642) for number in range(4)]
    turned = [each.normals - [0.1 * number, 0.0, 0.0] for number, each in enumerate(sheets)]
    whole = joined([replace(each, normals=up) for each, up in zip(sheets, turned, strict=True)])
    written = as_written(replace(whole, vertices=whole.vertices + origin), origin, PLAIN)
    assert np.allclose(written.vertices - origin, whole.vertices, rtol=0.0, atol=1e-12)
    assert np.array_equal(written.triangles, whole.triangles)
