import math

import numpy as np
import pytest

from artgen.asset import Curve
from artgen.nodes import loft, path, profile, sweep
from support.shapes import X, Y, Z, check_shape, outline_area, relative_volume

O = np.zeros(3)  # noqa: E741
BENT = (O, 0.05 * Z, 0.05 * Z + 0.2 * X, np.array([0.2, 0.1, 0.0]))
RING = (O, 0.1 * X, np.array([0.1, 0.1, 0.03]), 0.1 * Y)
PATHS = {
    "line": path._line(O, 0.1 * X + 0.1 * Z),
    "upward": path._line(O, 0.1 * Z),
    "sharp": path._polyline(BENT, 0.0, False),
    "filleted": path._polyline(BENT, 0.02, False),
    "ring": path._polyline(RING, 0.02, True),
    "sharp ring": path._polyline(RING, 0.0, True),
    "arc": path._arc(O, 0.1, 0.0, 2.0, Y),
    "circle": path._arc(O, 0.1, 0.0, math.tau, Y),
    "bezier": path._bezier(BENT),
    "spline": path._spline(BENT, False),
    "loop": path._spline(BENT, True),
    "helix": path._helix(0.03, 0.015, 2.0, Z),
}
ROUND, FLAT = profile._circle(0.004), profile._rectangle(0.008, 0.004, 0.0)


def length(curve):
    points = np.concatenate([curve.points, curve.points[:1]]) if curve.closed else curve.points
    return float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())


@pytest.mark.parametrize("name", PATHS)
@pytest.mark.parametrize("outline", [ROUND, FLAT], ids=["round", "flat"])
def test_a_sweep_has_the_volume_of_its_path(name, outline):
    curve = PATHS[name]
    shape = sweep._sweep(outline, curve)
    check_shape(shape)
    assert shape.manifold.genus() == int(curve.closed)
    assert relative_volume(shape, outline_area(outline.contours) * length(curve)) == pytest.approx(
        1, abs=0.02
    )


@pytest.mark.parametrize("name", ["line", "filleted", "circle"])
def test_a_profile_may_have_a_hole(name):
    shape = sweep._sweep(profile._ring(0.004, 0.003), PATHS[name])
    check_shape(shape)
    assert shape.manifold.genus() == 1 if name != "circle" else shape.manifold.volume() > 0


def test_a_mitre_keeps_the_width():
    frame = path._polyline((O, X, X + Y, Y), 0.0, True)
    shape = sweep._sweep(profile._rectangle(0.1, 0.2, 0.0), frame)
    np.testing.assert_allclose(shape.bounds(), [[-0.05, -0.05, -0.1], [1.05, 1.05, 0.1]], atol=1e-12)
    assert relative_volume(shape, 4 * 0.02) == pytest.approx(1.0)


def test_the_profile_stands_upright():
    shape = sweep._sweep(profile._rectangle(0.02, 0.04, 0.0), path._line(O, X))
    np.testing.assert_allclose(np.ptp(shape.bounds(), axis=0), [1.0, 0.02, 0.04], atol=1e-12)
    shape = sweep._sweep(profile._rectangle(0.02, 0.04, 0.0), path._line(O, Z))
    np.testing.assert_allclose(np.ptp(shape.bounds(), axis=0), [0.02, 0.04, 1.0], atol=1e-12)


def test_a_bend_too_tight_is_refused_where_it_is():
    tight = path._polyline((O, 0.1 * X, 0.1 * X + 0.1 * Y), 0.01, False)
    with pytest.raises(ValueError, match=r"bends too tightly .* near \(0\..*use a larger radius"):
        sweep._sweep(profile._circle(0.02), tight)


def test_a_path_that_turns_back_is_refused():
    with pytest.raises(ValueError, match=r"turns back by 1[67]\d degrees at \(0.1, 0, 0\) m"):
        sweep._sweep(ROUND, Curve(np.array([O, 0.1 * X, 0.02 * Y])))


@pytest.mark.parametrize("axis", [X, Y, Z, -Y])
def test_a_loft_of_one_profile_is_a_prism(axis):
    shape = loft._loft((FLAT, FLAT, FLAT), (0.0, 0.05, 0.1), axis)
    check_shape(shape)
    assert relative_volume(shape, 0.008 * 0.004 * 0.1) == pytest.approx(1.0)


def test_a_loft_passes_through_its_profiles():
    round_top = (profile._rectangle(0.1, 0.06, 0.02), profile._ellipse(0.04, 0.03), profile._circle(0.05))
    shape = loft._loft(round_top, (0.0, 0.05, 0.1), Z)
    check_shape(shape, least_agreement=0.5)
    for outline, level in zip(round_top, (0.0, 0.05, 0.1), strict=True):
        ring = shape.mesh.vertices[np.abs(shape.mesh.vertices[:, 2] - level) < 1e-9]
        points = np.column_stack(
            [outline.contours[0].points, np.full(len(outline.contours[0].points), level)]
        )
        gap = np.linalg.norm(points[:, None] - ring[None], axis=2).min(axis=1)
        assert gap.max() < 1e-7


def test_a_frustum_by_loft():
    shape = loft._loft((profile._circle(0.05), profile._circle(0.02)), (0.0, 0.1), Z)
    check_shape(shape)
    exact = math.pi * 0.1 / 3.0 * (0.05**2 + 0.05 * 0.02 + 0.02**2)
    assert 0.97 < relative_volume(shape, exact) < 1.0


@pytest.mark.parametrize(
    ("profiles", "heights", "message"),
    [
        ((ROUND,), (0.0,), "at least 2 profiles"),
        ((ROUND, FLAT), (0.0,), "got 2 profiles and 1 heights"),
        ((ROUND, FLAT), (0.1, 0.0), "must ascend, got 0.1, 0 m"),
        ((ROUND, profile._ring(0.02, 0.01)), (0.0, 1.0), "profile 1 of the loft has 2 borders"),
        ((profile._bow(0.1, 0.02, 0.0, 2.0), ROUND), (0.0, 1.0), "profile 0 of the loft is not convex"),
    ],
)
def test_lofts_that_cannot_be_are_refused(profiles, heights, message):
    with pytest.raises(ValueError, match=message):
        loft._loft(profiles, heights, Z)
