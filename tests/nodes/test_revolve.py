import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from artgen.nodes import extrude, profile
from support.cases import some
from support.shapes import X, Y, Z, check_shape, outline_area, relative_volume

KNOB = profile._polygon(((0, 0), (0.02, 0), (0.02, 0.005), (0.01, 0.01), (0.012, 0.03), (0, 0.035)), 0.0)
RIM = profile._profile_translate(profile._rectangle(0.02, 0.05, 0.004), 0.03, 0.0)
HOLED = profile._profile_translate(
    profile._profile_difference(profile._rectangle(0.04, 0.05, 0.0), profile._circle(0.01)), 0.05, 0.0
)


@pytest.mark.parametrize("axis", some([X, Y, Z, -Z], 4, 1))
@pytest.mark.parametrize("angle", [math.tau, 4.0, 1.0])
@pytest.mark.parametrize("outline", [RIM, HOLED])
def test_volume_follows_pappus(outline, angle, axis):
    shape = extrude._revolve(outline, angle, axis)
    check_shape(shape)
    center = np.mean([outline.contours[0].points.min(axis=0)[0], outline.contours[0].points.max(axis=0)[0]])
    exact = outline_area(outline.contours) * center * angle
    assert 0.97 < relative_volume(shape, exact) < 1.0
    height = shape.mesh.vertices @ axis
    assert np.ptp(height) == pytest.approx(0.05)


@pytest.mark.parametrize("angle", [math.tau, 2.5])
def test_a_profile_may_touch_the_axis(angle):
    shape = extrude._revolve(KNOB, angle, Z)
    check_shape(shape)
    assert shape.manifold.genus() == 0
    assert shape.bounds()[1, 2] == pytest.approx(0.035)


def test_a_part_turn_starts_at_x():
    shape = extrude._revolve(RIM, 0.5 * math.pi, Z)
    np.testing.assert_allclose(shape.bounds(), [[0.0, 0.0, -0.025], [0.04, 0.04, 0.025]], atol=1e-12)


@settings(max_examples=15)
@given(st.floats(0.01, 0.5), st.floats(0.05, 6.28))
@pytest.mark.long
def test_a_half_disc_makes_a_wedge_of_a_ball(radius, angle):
    half = profile._profile_intersection(
        profile._circle(radius),
        profile._profile_translate(profile._rectangle(radius, 3 * radius, 0), radius / 2, 0),
    )
    shape = extrude._revolve(half, angle, Z)
    check_shape(shape)
    assert 0.9 < relative_volume(shape, 2 / 3 * radius**3 * angle) < 1.0


def test_a_profile_across_the_axis_is_refused():
    with pytest.raises(ValueError, match=r"the profile reaches x = -0\.1 m; all of it must be at x >= 0"):
        extrude._revolve(profile._circle(0.1), math.tau, Z)
    with pytest.raises(ValueError, match=r"angle must be within 0\.001 and"):
        extrude._revolve(RIM, 7.0, Z)
