import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from artgen.errors import BuildError, EvaluationError
from artgen.graph import evaluate
from artgen.nodes import profile, surfaces
from artgen.nodes.contours import signed_area
from artgen.nodes.extrude import extrude
from artgen.nodes.path import spline
from support.shapes import outline_area

LENGTHS = st.floats(0.002, 2.0)


def check(outline):
    """Assert that normals are unit and outward, and borders in their direction."""
    for contour in outline.contours:
        sides = np.roll(contour.points, -1, axis=0) - contour.points
        right = np.column_stack([sides[:, 1], -sides[:, 0]])
        right /= np.linalg.norm(right, axis=1, keepdims=True)
        for normals in (contour.normals_out, np.roll(contour.normals_in, -1, axis=0)):
            np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1.0, atol=1e-9)
            assert np.einsum("ij,ij->i", normals, right).min() > 0.8
    assert outline_area(outline.contours) > 0.0


def value(handle):
    return evaluate(handle).value


@given(LENGTHS, LENGTHS, st.floats(0.0, 1.0))
def test_a_rectangle_has_its_area(width, height, share):
    radius = share * min(width, height) / 2.0
    outline = profile._rectangle(width, height, radius)
    check(outline)
    points = outline.contours[0].points
    np.testing.assert_allclose(points.max(axis=0), [width / 2, height / 2], rtol=1e-9)
    assert outline_area(outline.contours) <= (width * height - (4.0 - math.pi) * radius**2) * (1 + 1e-9)
    sides = surfaces.sides_of(radius)
    circle = 0.5 * sides * math.sin(math.tau / sides) * radius**2  # inscribed, a quarter in each corner
    assert outline_area(outline.contours) == pytest.approx(width * height - 4.0 * radius**2 + circle)


@given(LENGTHS)
def test_a_circle_is_inscribed(radius):
    outline = profile._circle(radius)
    check(outline)
    np.testing.assert_allclose(np.linalg.norm(outline.contours[0].points, axis=1), radius)


@given(LENGTHS, LENGTHS)
def test_other_shapes(a, b):
    low, high = min(a, b), max(a, b) * 1.01
    for outline, area in (
        (profile._ellipse(a, a / 4.0), math.pi * a * a / 4.0),
        (profile._slot(high, low), low * (high - low) + math.pi * low**2 / 4.0),
        (profile._ring(high, low), math.pi * (high**2 - low**2)),
        (profile._bow(high, low, 0.3, 2.0), 2.0 * high * low),
        (profile._regular_polygon(6, a), 1.5 * math.sqrt(3.0) * a * a),
    ):
        check(outline)
        assert outline_area(outline.contours) == pytest.approx(area, rel=0.06)


def test_a_polygon_may_run_either_way():
    points = ((0.0, 0.0), (0.3, 0.0), (0.3, 0.2), (0.1, 0.2), (0.1, 0.1), (0.0, 0.1))
    ways = [value(profile.polygon(p, radius=0.01)) for p in (points, points[::-1])]
    for outline in ways:
        check(outline)
        assert outline.convex is None
    assert outline_area(ways[0].contours) == pytest.approx(outline_area(ways[1].contours))
    assert value(profile.polygon(points[:3])).convex is not None


def test_a_drilled_plate_keeps_exact_normals():
    plate = value(profile.rectangle(0.2, 0.1) - profile.circle(0.02).at(0.05, 0.0))
    check(plate)
    hole = plate.contours[1]
    inward = (np.array([0.05, 0.0]) - hole.points) / 0.02
    np.testing.assert_allclose(hole.normals_in, inward, atol=1e-12)


def test_booleans_have_their_areas():
    a, b = profile.rectangle(0.2, 0.1), profile.rectangle(0.2, 0.1).at(0.1, 0.05)
    area = {op: outline_area(value(p).contours) for op, p in (("|", a | b), ("-", a - b), ("&", a & b))}
    assert area["|"] == pytest.approx(0.035)
    assert area["-"] == pytest.approx(0.015)
    assert area["&"] == pytest.approx(0.005)
    for result in (a | b, a - b, a & b, a.rotate(0.3) | b):
        check(value(result))


def test_a_boolean_keeps_round_parts_smooth_and_corners_sharp():
    outline = value(profile.rectangle(0.2, 0.1) | profile.circle(0.03).at(0.1, 0.0))
    contour = outline.contours[0]
    corner = np.einsum("ij,ij->i", contour.normals_in, contour.normals_out) < 0.99
    assert corner.sum() == 6
    on_arc = (contour.points[:, 0] > 0.1 + 1e-6) & ~corner
    outward = contour.points[on_arc] - [0.1, 0.0]
    cosine = np.einsum("ij,ij->i", outward, contour.normals_in[on_arc]) / np.linalg.norm(outward, axis=1)
    assert cosine.min() > 0.99


def test_offset_grows_and_shrinks():
    square = profile.rectangle(0.1, 0.1)
    assert outline_area(value(square.offset(0.01)).contours) == pytest.approx(
        0.01 + 4 * 0.001 + math.pi * 0.0001, rel=1e-3
    )
    assert outline_area(value(square.offset(-0.01)).contours) == pytest.approx(0.0064)
    sharp = value(square.offset(0.01, join="miter"))
    assert outline_area(sharp.contours) == pytest.approx(0.0144)
    assert value(square.offset(0.0)) is value(square) or len(value(square.offset(0.0)).contours) == 1


@given(st.floats(-3, 3), st.floats(0.6, 1.5), st.floats(0.6, 1.5), st.floats(-1, 1), st.floats(0, 6))
def test_transforms_keep_outsides_outside(angle, x, y, dx, across):
    outline = profile._ring(0.03, 0.02)
    outline = profile._profile_translate(outline, dx, 0.0)
    outline = profile._profile_rotate(outline, angle)
    outline = profile._profile_scale(outline, x, -y)
    outline = profile._profile_mirror(outline, math.cos(across), math.sin(across))
    check(outline)
    assert signed_area(outline.contours[0].points) > 0.0
    assert signed_area(outline.contours[1].points) < 0.0


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: profile._rectangle(-0.1, 0.1, 0.0), "width must be positive, got -0.1 m"),
        (lambda: profile._rectangle(0.1, 0.1, 0.06), "radius must be within 0 and 0.05 m, got 0.06 m"),
        (lambda: profile._circle(math.nan), "radius must be positive, got nan m"),
        (lambda: profile._polygon(((0, 0), (1, 0)), 0.0), "needs at least 3 points, got 2"),
        (
            lambda: profile._polygon(((0, 0), (1, 1), (1, 0), (0, 1)), 0.0),
            "crosses itself; give its points in order",
        ),
        (lambda: profile._polygon(((0, 0), (1, 1), (3, 3)), 0.0), "has no area; its points lie on one line"),
        (lambda: profile._polygon(((0, 0), (2, 1), (2, 0), (0, 1.5)), 0.0), "crosses itself"),
        (lambda: profile._polygon(((0, 0), (1, 0), (1, 0), (0, 1)), 0.0), "points 1 and 2 .* the same point"),
        (lambda: profile._polygon(((0, 0), (1, 0), (0, 1)), 0.9), "use a smaller radius"),
        (lambda: profile._regular_polygon(2, 0.1), "at least 3 sides, got 2"),
        (lambda: profile._slot(0.01, 0.02), "length must be within 0.02"),
        (lambda: profile._ring(0.01, 0.02), "outer radius 0.01 m must exceed the inner radius 0.02 m"),
        (lambda: profile._profile_scale(profile._circle(0.1), 0.0, 1.0), "no scale may be 0"),
    ],
)
def test_what_cannot_be_is_refused(make, message):
    with pytest.raises(ValueError, match=message):
        make()


def test_empty_results_say_so():
    a = profile.circle(0.1)
    with pytest.raises(EvaluationError, match="the difference of the profiles is empty"):
        evaluate(a - profile.rectangle(1.0, 1.0))
    with pytest.raises(EvaluationError, match="offset of -200 mm is empty"):
        evaluate(a.offset(-0.2))


def test_the_join_is_known_while_building():
    with pytest.raises(BuildError, match="'round', 'miter'"):
        profile.circle(0.1).offset(0.01, join="square")


@pytest.mark.parametrize("turn", [1, -1])
def test_a_closed_spline_is_the_border_of_a_profile(turn):
    angles = np.linspace(0.0, 2.0 * np.pi, 12, endpoint=False)[::turn]
    path = spline([(0.1 * np.cos(a), 0.1 * np.sin(a), 0) for a in angles], closed=True)
    outline = evaluate(path.profile()).value
    (contour,) = outline.contours
    assert signed_area(contour.points) == pytest.approx(np.pi * 0.01, rel=0.01)
    outward = contour.points / np.linalg.norm(contour.points, axis=1, keepdims=True)
    assert (contour.normals_out * outward).sum(axis=1).min() > 0.999
    assert evaluate(extrude(path.profile(), 0.02)).value.manifold.volume() == pytest.approx(
        np.pi * 2e-4, rel=0.01
    )


@pytest.mark.parametrize(
    ("points", "closed", "message"),
    [
        ([(0, 0, 0), (1, 0, 0), (0, 1, 0)], False, "the path of a profile is open; make it with closed=True"),
        ([(0, 0, 0), (1, 0, 0.1), (0, 1, 0)], True, r"in the plane z = 0; point \d+ is 0.1\d* m off"),
        ([(0, 0, 0), (1, 1, 0), (1, 0, 0), (0, 1, 0)], True, "the path of a profile crosses itself"),
    ],
)
def test_paths_that_border_nothing_are_refused(points, closed, message):
    with pytest.raises(EvaluationError, match=message):
        evaluate(spline(points, closed=closed).profile())
