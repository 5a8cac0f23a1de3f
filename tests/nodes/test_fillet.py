import math

import numpy as np
import pytest

from artgen.nodes import csg, loft, primitive, solid_methods
from support.shapes import X, Z, check_shape

FOOT = np.array([0.0, 0.0, -0.05])
POST = primitive._cylinder(0.02, 0.1, Z, 0.0)
BLOCK = primitive._box(0.04, 0.06, 0.1, 0.0)


def volume(shape):
    return shape.manifold.volume()


def ring(radius):
    """Volume between a right angle and an arc of a radius, over a straight edge of 1 m and around a point."""
    straight = (1.0 - math.pi / 4.0) * radius**2
    # Pappus: the corner of the square minus the quarter of the disc
    moment = radius**3 / 2.0 - (math.pi * radius**2 / 4.0) * (radius - 4.0 * radius / (3.0 * math.pi))
    return straight, math.tau * moment


@pytest.mark.parametrize(("shape", "around"), [(POST, math.tau * 0.02), (BLOCK, 0.2)])
def test_a_fillet_adds_the_volume_between_arc_and_edge(shape, around):
    made = loft._fillet(shape, FOOT, Z, 0.01)
    check_shape(made)
    straight, corner = ring(0.01)
    assert volume(made) - volume(shape) == pytest.approx(straight * around + corner, rel=0.03)
    low, high = made.bounds()
    np.testing.assert_allclose(high - low - np.ptp(shape.bounds(), axis=0), (0.02, 0.02, 0.0), atol=1e-4)


def test_a_fillet_turns_with_its_solid_and_the_sides_of_a_block_stay_flat():
    turned = solid_methods._rotate(BLOCK, np.array(X), 0.7, np.zeros(3))
    normal = solid_methods.rotation_about(np.array(X), 0.7) @ Z
    made = loft._fillet(turned, -0.05 * normal, normal, 0.01)
    check_shape(made)
    assert volume(made) == pytest.approx(volume(loft._fillet(BLOCK, FOOT, Z, 0.01)), rel=1e-6)
    assert len(made.pieces.outer(0.001)) == 4  # the block and three slabs of the fillet


def test_each_leg_of_a_solid_has_its_fillet():
    legs = csg._array(POST, np.array([[0.0, 0.0, 0.0], [0.1, 0.0, 0.0]]))
    one = volume(loft._fillet(POST, FOOT, Z, 0.01))
    assert volume(loft._fillet(legs, FOOT, Z, 0.01)) == pytest.approx(2.0 * one)


@pytest.mark.parametrize(
    ("shape", "foot", "message"),
    [
        (POST, -FOOT, "the solid does not reach from the plane to 10 mm above it"),
        (primitive._frustum(0.03, 0.01, 0.1, Z, 0.0), FOOT, "a fillet needs straight sides there"),
        (primitive._tube(0.03, 0.02, 0.1, Z, 0.0), FOOT, "a convex section without holes"),
        (csg.united((BLOCK, primitive._box(0.2, 0.01, 0.1, 0.0))), FOOT, "a convex section without holes"),
    ],
)
def test_a_fillet_that_cannot_be_made_tells_why(shape, foot, message):
    with pytest.raises(ValueError, match=message):
        loft._fillet(shape, foot, Z, 0.01)
