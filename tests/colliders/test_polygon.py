"""Convex decomposition of regions of the plane."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from manifold3d import CrossSection, OpType
from numpy.typing import NDArray

from artgen.colliders import decompose_polygon
from artgen.colliders.polygon import convex_hull, is_convex, signed_area

Array = NDArray[np.float64]
TOLERANCE = 0.00025


def circle(radius: float, sides: int = 64, center: tuple[float, float] = (0.0, 0.0)) -> Array:
    angle = np.arange(sides) * 2.0 * np.pi / sides
    return radius * np.column_stack((np.cos(angle), np.sin(angle))) + center


def square(side: float) -> Array:
    return np.array([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]) * side / 2.0


def region(contours: list[Array]) -> CrossSection:
    return CrossSection(contours)


def covered(parts: list[Array]) -> CrossSection:
    return CrossSection.batch_boolean([CrossSection([part]) for part in parts], OpType.Add)


def assert_covers(contours: list[Array], parts: list[Array], tolerance: float) -> None:
    """The convex parts contain the region and exceed it by the tolerance at most; they do not overlap."""
    solid, cover = region(contours), covered(parts)
    assert all(is_convex(part) and signed_area(part) > 0.0 for part in parts)
    assert (solid - cover).area() < 1e-7 * solid.area() + 1e-12
    assert (cover - solid.offset(1.05 * tolerance + 1e-6)).area() < 1e-12
    assert sum(map(signed_area, parts)) == pytest.approx(cover.area(), rel=1e-5)


def assert_within(contours: list[Array], parts: list[Array], tolerance: float) -> None:
    solid, cover = region(contours), covered(parts)
    assert all(is_convex(part) and signed_area(part) > 0.0 for part in parts)
    assert (cover - solid).area() < 1e-7 * solid.area() + 1e-12
    assert (solid.offset(-1.05 * tolerance - 1e-6) - cover).area() < 1e-9


SHAPES = {
    "annulus": [circle(0.05), circle(0.03)[::-1]],
    "plate with a bore": [square(0.2), circle(0.008, 16)[::-1]],
    "plate with three bores": [
        square(0.2),
        *(circle(0.01, 32, (x, 0.01 * x))[::-1] for x in (-0.06, 0.0, 0.05)),
    ],
    "L": [np.array([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]) * 0.1],
    "star": [circle(0.1, 10) * np.where(np.arange(10) % 2, 0.4, 1.0)[:, None]],
    "two squares": [square(0.1) - (0.2, 0.0), square(0.1) - (-0.2, 0.0)],
    "crescent": [np.concatenate((circle(0.1, 64)[:49], circle(0.07, 64)[48::-1]))],
    "square": [square(0.1)],
    "square with straight vertices": [
        np.array([(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (0, 2), (0, 1)]) * 0.1
    ],
}


@pytest.mark.parametrize("name", SHAPES)
@pytest.mark.parametrize("tolerance", [1e-6, TOLERANCE, 0.001])
def test_outer_parts_contain_the_region_and_little_more(name: str, tolerance: float) -> None:
    assert_covers(SHAPES[name], decompose_polygon(SHAPES[name], tolerance), tolerance)


@pytest.mark.parametrize("name", SHAPES)
def test_inner_parts_lie_within_the_region(name: str) -> None:
    assert_within(SHAPES[name], decompose_polygon(SHAPES[name], TOLERANCE, inner=True), TOLERANCE)


@pytest.mark.parametrize(
    ("name", "most"),
    [("annulus", 32), ("plate with a bore", 16), ("L", 2), ("star", 6), ("two squares", 2), ("square", 1)],
)
def test_parts_are_few(name: str, most: int) -> None:
    assert len(decompose_polygon(SHAPES[name], TOLERANCE)) <= most


def test_an_annulus_comes_out_as_equal_sectors() -> None:
    parts = decompose_polygon([circle(0.05), circle(0.03)[::-1]], 0.001)
    areas = [signed_area(part) for part in parts]
    assert 12 <= len(parts) <= 16
    assert max(areas) < 1.4 * min(areas)


def test_a_hole_smaller_than_the_tolerance_stays_open() -> None:
    parts = decompose_polygon([square(0.1), circle(0.0005, 16)[::-1]], 0.01)
    assert (covered(parts) ^ CrossSection([circle(0.0003)])).area() < 1e-12


@given(st.integers(0, 10**6), st.integers(5, 40))
@settings(max_examples=60, deadline=None)
def test_random_stars_are_covered(seed: int, count: int) -> None:
    radius = np.random.default_rng(seed).uniform(0.05, 0.2, count)
    contour = circle(1.0, count) * radius[:, None]
    assert_covers([contour], decompose_polygon([contour], TOLERANCE), TOLERANCE)
    assert_within([contour], decompose_polygon([contour], TOLERANCE, inner=True), TOLERANCE)


def test_convex_hull_keeps_corners_only() -> None:
    points = np.array([(0, 0), (1, 0), (2, 0), (2, 2), (1, 1), (0, 2), (0, 1)], float)
    assert convex_hull(points).tolist() == [[0, 0], [2, 0], [2, 2], [0, 2]]


def test_contours_in_the_wrong_order_are_refused() -> None:
    with pytest.raises(ValueError, match="outer borders must run counter-clockwise"):
        decompose_polygon([square(1.0)[::-1]], TOLERANCE)
    with pytest.raises(ValueError, match=r"finite points of shape \(n, 2\), got shape \(3, 3\)"):
        decompose_polygon([np.zeros((3, 3))], TOLERANCE)
