import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from artgen.graph import evaluate
from artgen.nodes import extrude, profile
from support.shapes import X, Y, Z, check_metric, check_shape, outline_area, relative_volume

AXES = [X, Y, Z, -X, -Y, -Z]
CORNER = ((0.0, 0.0), (0.3, 0.0), (0.3, 0.2), (0.15, 0.2), (0.15, 0.1), (0.0, 0.1))
PLATE = profile._profile_difference(profile._rectangle(0.2, 0.1, 0.0), profile._circle(0.02))
PROFILES = {
    "rectangle": profile._rectangle(0.2, 0.1, 0.0),
    "rounded": profile._rectangle(0.2, 0.1, 0.02),
    "corner": profile._polygon(CORNER, 0.0),
    "round corner": profile._polygon(CORNER, 0.02),
    "ring": profile._ring(0.05, 0.03),
    "plate": PLATE,
    "bow": profile._bow(0.05, 0.01, 0.0, 2.0),
    "two": profile._profile_union(
        profile._circle(0.02), profile._profile_translate(profile._circle(0.02), 0.1, 0)
    ),
}


@pytest.mark.parametrize("name", PROFILES)
@pytest.mark.parametrize("bevel", [0.0, 0.003])
def test_an_extrusion_is_its_area_times_its_length(name, bevel):
    outline = PROFILES[name]
    shape = extrude._extrude(outline, 0.05, -Y, bevel, 0.0, 0.0)
    check_shape(shape)
    check_metric(shape)
    share = relative_volume(shape, outline_area(outline.contours) * 0.05)
    assert share == pytest.approx(1.0, abs=1e-9) if bevel == 0.0 else 0.9 < share < 1.0
    assert np.ptp(shape.bounds()[:, 1]) == pytest.approx(0.05)


@pytest.mark.parametrize("axis", AXES)
def test_the_profile_lies_along_the_other_axes_in_their_order(axis):
    off_center = profile._polygon(((0.0, 0.0), (0.3, 0.0), (0.0, 0.1)), 0.0)
    shape = extrude._extrude(off_center, 0.02, axis, 0.002, 0.0, 0.0)
    check_shape(shape)
    first, second = (i for i in range(3) if axis[i] == 0.0)
    low, high = shape.bounds()
    np.testing.assert_allclose([low[first], high[first]], [0.0, 0.3], atol=1e-12)
    np.testing.assert_allclose([low[second], high[second]], [0.0, 0.1], atol=1e-12)


@settings(max_examples=20)
@given(st.floats(0.01, 1), st.floats(0.01, 1), st.floats(0.01, 1), st.floats(0.01, 0.95))
def test_a_bevelled_extrusion_stays_within_its_box(width, height, length, share):
    bevel = share * min(width, height, length) / 2.0
    shape = extrude._extrude(profile._rectangle(width, height, 0.0), length, Z, bevel, 0.0, 0.0)
    check_shape(shape)
    np.testing.assert_allclose(np.ptp(shape.bounds(), axis=0), [width, height, length], rtol=1e-9)


def test_bevelled_ends_are_round():
    radius, bevel = 0.05, 0.01
    mesh = extrude._extrude(profile._circle(radius), 0.1, Z, bevel, 0.0, 0.0).mesh
    edge = mesh.vertices[:, 2] > 0.04 + 1e-9
    across = np.linalg.norm(mesh.vertices[edge, :2], axis=1)
    rim = across > radius - bevel - 1e-9
    off = np.hypot(across[rim] - (radius - bevel), mesh.vertices[edge, 2][rim] - 0.04)
    np.testing.assert_allclose(off, bevel, rtol=1e-9)


@pytest.mark.parametrize("name", ["rounded", "corner", "plate"])
@pytest.mark.parametrize("taper", [0.4, -0.5, 0.95])
def test_a_taper_scales_the_end(name, taper):
    outline = PROFILES[name]
    shape = extrude._extrude(outline, 0.1, Z, 0.0, taper, 0.0)
    check_shape(shape)
    end = 1.0 - taper
    exact = outline_area(outline.contours) * 0.1 * (1.0 + end + end**2) / 3.0
    assert relative_volume(shape, exact) == pytest.approx(1.0, abs=1e-9)


@pytest.mark.parametrize("bevel", [0.0, 0.001])
def test_a_twist_turns_the_end(bevel):
    outline = profile._rectangle(0.02, 0.02, 0.0)
    shape = extrude._extrude(outline, 0.1, Z, bevel, 0.0, 1.2)
    check_shape(shape)
    assert relative_volume(shape, 0.02 * 0.02 * 0.1) == pytest.approx(1.0, abs=0.02)
    if bevel == 0.0:
        top = shape.mesh.vertices[shape.mesh.vertices[:, 2] > 0.05 - 1e-9][:, :2]
        corner = 0.01 * math.sqrt(2.0) * np.array([math.cos(1.2 + math.pi / 4), math.sin(1.2 + math.pi / 4)])
        assert np.linalg.norm(top - corner, axis=1).min() < 1e-9


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((PLATE, 0.0, Z, 0.0, 0.0, 0.0), "length must be positive, got 0 m"),
        ((PLATE, 0.1, Z, 0.06, 0.0, 0.0), "bevel must be within 0 and 0.04995 m"),
        ((PLATE, 0.1, Z, 0.04, 0.0, 0.0), "bevel 40 mm is too large .* thinnest part"),
        (
            (profile._rectangle(0.1, 0.1, 0.005), 0.1, Z, 0.006, 0.0, 0.0),
            "bevel 6 mm is too large .* less than 5 mm",
        ),
        ((PLATE, 0.1, Z, 0.0, 1.0, 0.0), "taper must be within -10 and 0.99"),
        ((PLATE, 0.1, Z, 0.0, 0.0, math.nan), "twist must be within"),
        ((PLATE, 0.1, 0 * Z, 0.0, 0.0, 0.0), "axis must have a direction"),
    ],
)
def test_what_cannot_be_is_refused(arguments, message):
    with pytest.raises(ValueError, match=message):
        extrude._extrude(*arguments)


def test_the_constructor_records_the_kernel():
    solid = extrude.extrude(profile.circle(0.1), 0.2, axis=(0, 1, 0), bevel=0.01)
    assert evaluate(solid).value.bounds()[1, 1] == pytest.approx(0.1)
