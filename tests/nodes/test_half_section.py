"""Half sections of turned things."""

import math

import numpy as np
import pytest

from artgen import half_section, line, material, part, polyline, revolve, spline
from artgen.errors import EvaluationError
from artgen.graph import Cache, Graph, Handle


def value(handle: Handle):
    return Graph(handle).evaluate({}, Cache()).value


def test_a_straight_line_makes_a_frustum():
    solid = value(revolve(half_section(line((0.2, 0.0, 0.0), (0.1, 0.0, 0.3))), sides=96))
    exact = math.pi * 0.3 / 3.0 * (0.2**2 + 0.2 * 0.1 + 0.1**2)
    assert solid.manifold.volume() == pytest.approx(exact, rel=2e-3)


def test_a_wall_lies_inside_of_the_line_and_keeps_its_thickness():
    path = polyline([(0.1, 0.0, 0.0), (0.1, 0.0, 0.2), (0.05, 0.0, 0.25)])
    (contour,) = value(half_section(path, wall=0.002)).contours
    assert contour.points[:, 0].max() == pytest.approx(0.1)
    for point in ((0.098, 0.1), (0.1 - 0.002 / math.sqrt(2) - 0.02, 0.22 - 0.002 / math.sqrt(2))):
        first, second = contour.points, np.roll(contour.points, -1, axis=0)
        along = second - first
        share = np.clip(((np.array(point) - first) * along).sum(1) / (along * along).sum(1), 0.0, 1.0)
        assert np.linalg.norm(first + share[:, None] * along - point, axis=1).min() < 1e-9


def test_an_inset_moves_the_outside_inward():
    path = line((0.1, 0.0, 0.0), (0.1, 0.0, 0.2))
    (contour,) = value(half_section(path, inset=0.01)).contours
    assert contour.points[:, 0].max() == pytest.approx(0.09)


def test_a_spline_has_the_normals_of_the_curve():
    (contour,) = value(half_section(spline([(0.1, 0.0, 0.0), (0.2, 0.0, 0.1), (0.1, 0.0, 0.2)]))).contours
    inside = (contour.points[:, 0] > 0.11) & (contour.points[:, 0] < 0.199)
    assert np.allclose(contour.normals_in[inside], contour.normals_out[inside])


def test_few_sides_make_few_pieces():
    shell = half_section(line((0.2, 0.0, 0.0), (0.15, 0.0, 0.2)), wall=0.002)
    link = value(part(revolve(shell, sides=16), "shade", material("steel"))).link
    assert len(link.colliders) == 16


def test_several_paths_meet_in_knees_with_steps_where_they_are_apart():
    foot, bead = (
        line((0.2, 0.0, 0.0), (0.2, 0.0, 0.1)),
        spline([(0.1, 0.0, 0.1), (0.15, 0.0, 0.2), (0.1, 0.0, 0.3)]),
    )
    (contour,) = value(half_section([foot, bead])).contours
    assert contour.points[:, 0].max() == pytest.approx(0.2)
    step = np.flatnonzero(np.isclose(contour.points, (0.2, 0.1)).all(axis=1))
    assert len(step) == 1
    assert contour.normals_in[step[0]] == pytest.approx([1.0, 0.0])  # the foot
    assert contour.normals_out[step[0]] == pytest.approx([0.0, 1.0])  # the ledge above it
    assert value(revolve(half_section([foot, bead]))).manifold.volume() > math.pi * 0.2**2 * 0.1


def test_runs_within_a_line_stay_under_it_and_are_few():
    path = spline([(0.03, 0.0, 0.0), (0.02, 0.0, 0.03), (0.03, 0.0, 0.06), (0.01, 0.0, 0.08)])
    (smooth,), (few,) = (value(half_section(path, within=off)).contours for off in (0.0, 0.001))
    assert len(few.points) < 0.8 * len(smooth.points)
    skin, core = (value(revolve(half_section(path, within=off), sides=64)).manifold for off in (0.0, 0.001))
    assert (core - skin).volume() < 1e-12
    low, high = few.points[:, 1].min(), few.points[:, 1].max()
    assert (low, high) == pytest.approx((0.0, 0.08))
    for r, z in few.points[few.points[:, 0] > 0.0]:
        off = np.hypot(*(smooth.points - (r, z)).T).min()
        assert off < 0.0022, f"({r:.4f}, {z:.4f}) lies {1e3 * off:.2f} mm from the line"


def test_a_bore_leaves_a_hole_along_the_axis():
    solid = value(revolve(half_section(line((0.2, 0.0, 0.0), (0.2, 0.0, 0.1)), bore=0.1), sides=96))
    assert solid.manifold.genus() == 1
    assert solid.manifold.volume() == pytest.approx(math.pi * 0.1 * (0.2**2 - 0.1**2), rel=2e-3)


@pytest.mark.parametrize(
    ("path", "wall", "message"),
    [
        (line((-0.1, 0.0, 0.0), (0.1, 0.0, 0.1)), None, "x is the radius"),
        (line((0.1, 0.5, 0.0), (0.1, 0.5, 0.1)), None, "must lie in the plane y = 0"),
        (polyline([(0.1, 0.0, 0.0), (0.2, 0.0, 0.1), (0.1, 0.0, 0.2)], closed=True), None, "must be open"),
        (polyline([(0.1, 0.0, 0.0), (0.2, 0.0, 0.05), (0.1, 0.0, 0.1)]), 0.08, "crosses itself"),
    ],
)
def test_a_line_that_makes_no_half_section_is_refused(path, wall, message):
    with pytest.raises(EvaluationError, match=message):
        value(half_section(path, wall=wall))


def test_a_lathe_refuses_two_sides():
    profile = half_section(line((0.2, 0.0, 0.0), (0.1, 0.0, 0.3)))
    with pytest.raises(EvaluationError, match="3 to 128 sides, or 0 for a number that looks round; got 2"):
        value(revolve(profile, sides=2))
