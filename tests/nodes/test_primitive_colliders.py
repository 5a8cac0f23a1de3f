"""How closely colliders follow rounded edges."""

import numpy as np
import pytest
from hypothesis import example, given, reject, settings
from hypothesis import strategies as st
from manifold3d import Manifold, OpType

from artgen.asset import Asset
from artgen.colliders import TOLERANCE
from artgen.errors import EvaluationError
from artgen.graph import DETAILS, evaluate
from artgen.materials import material
from artgen.nodes import primitive
from artgen.nodes.body import part
from artgen.nodes.extrude import extrude, revolve
from artgen.nodes.loft import loft
from artgen.nodes.profile import circle, polygon, rectangle
from artgen.validate.colliders import check_colliders
from support.shapes import Y, Z, check_shape


def covered(shape):
    """Return by which share the colliders of a shape exceed it; they contain it."""
    pieces = shape.pieces.outer(TOLERANCE)
    cover = Manifold.batch_boolean([piece.manifold(1e-5) for piece in pieces], OpType.Add)
    assert (shape.manifold - cover).volume() < 1e-7 * shape.manifold.volume()
    return cover.volume() / shape.manifold.volume() - 1.0


def farthest(shape, core):
    """Return how far the corners of a shape's colliders are from a core, at most [m].

    Args:
        shape: The shape, along the axes.
        core: Takes points to what they are beyond the core in each of its directions, negative within [m].
    """
    corners = np.concatenate([piece.outer_points(1e-5) for piece in shape.pieces.outer(TOLERANCE)])
    return np.linalg.norm(np.maximum(core(corners), 0.0), axis=1).max()


@settings(max_examples=40, deadline=None)
@given(st.floats(0.004, 0.04), st.floats(0.005, 0.3), st.floats(0.0, 0.9))
def test_a_rounded_cylinder_is_followed(radius, length, share):
    bevel = share * min(radius, length / 2.0)
    shape = primitive._cylinder(radius, length, Z, bevel)

    def core(points):
        across = np.hypot(points[:, 0], points[:, 1]) - (radius - bevel)
        return np.column_stack((across, np.abs(points[:, 2]) - (length / 2.0 - bevel)))

    assert covered(shape) < 0.047 or farthest(shape, core) - bevel < 0.0012


@settings(max_examples=40, deadline=None)
@given(st.floats(0.01, 0.4), st.floats(0.01, 0.4), st.floats(0.01, 0.4), st.floats(0.0, 0.9))
def test_a_rounded_box_is_followed(x, y, z, share):
    bevel = share * min(x, y, z) / 2.0
    shape = primitive._box(x, y, z, bevel)
    assert len(shape.pieces.outer(TOLERANCE)) in (1, 8)

    def core(points):
        return np.abs(points) - (np.array((x, y, z)) / 2.0 - bevel)

    assert covered(shape) < 0.047 or farthest(shape, core) - bevel < max(0.0012, 0.2 * bevel)


@pytest.mark.parametrize(
    ("radius", "bevel", "kinds"),
    [(0.028, 0.001, ["cylinder"]), (0.028, 0.006, ["cylinder", "hull", "hull"]), (0.015, 0.004, ["hull"])],
)
def test_a_knob_shows_its_rims_where_they_matter(radius, bevel, kinds):
    shape = primitive._cylinder(radius, 0.025, Y, bevel)
    assert [piece.kind for piece in shape.pieces.outer(TOLERANCE)] == kinds
    assert covered(shape) < (0.05 if kinds == ["hull"] else 0.03)


@pytest.mark.parametrize(
    ("size", "bevel", "kind"),
    [
        ((0.5, 0.5, 0.5), 0.005, "box"),
        ((0.5, 0.5, 0.5), 0.01, "hull"),
        ((0.02, 0.005, 0.03), 0.001, "box"),
        ((0.02, 0.01, 0.03), 0.004, "hull"),
    ],
)
def test_a_box_shows_its_edges_where_they_matter(size, bevel, kind):
    (piece,) = primitive._box(*size, bevel).pieces.outer(TOLERANCE)
    assert piece.kind == kind


def check_passed(solid, detail):
    """Assert that the colliders of a solid at a level of detail have no finding, and few vertices."""
    tree = evaluate(part(solid, "block", material("oak")), detail=DETAILS[detail]).value
    asset = Asset.from_tree(tree, "block", "block", detail=detail)
    assert not check_colliders(asset).findings
    assert max(len(collider.convex.points) for collider in asset.links[0].colliders) <= 64


@pytest.mark.parametrize("detail", DETAILS)
@settings(max_examples=8, deadline=None)
@given(st.floats(0.01, 0.5), st.floats(0.01, 0.5), st.floats(0.01, 0.5), st.floats(0.0, 1.0))
@example(0.45, 0.15, 0.06, 2 * 0.026 / 0.06)
@example(0.4, 0.4, 0.034, 2 * 0.006 / 0.034)
@example(0.1, 0.1, 0.1, 0.9)
@example(0.022, 0.019, 0.025, 2 * 0.006 / 0.019)
@example(0.25, 0.0625, 0.078, 0.625)
@example(0.3445, 0.011, 0.0104, 0.327)
def test_a_rounded_box_passes_the_check_of_colliders(detail, x, y, z, share):
    check_passed(primitive.box(x, y, z, bevel=share * min(x, y, z) / 2.0), detail)


@pytest.mark.parametrize("detail", DETAILS)
@settings(max_examples=12, deadline=None)
@given(st.floats(0.003, 0.3), st.floats(0.005, 0.6), st.floats(0.0, 0.99))
@example(0.015, 0.025, 0.24)
@example(0.0047, 0.038, 0.49)
@example(0.285, 0.5, 0.99)
def test_a_rounded_cylinder_passes_the_check_of_colliders(detail, radius, length, share):
    check_passed(primitive.cylinder(radius, length, bevel=share * min(radius, length / 2.0)), detail)


@pytest.mark.parametrize("detail", DETAILS)
@settings(max_examples=12, deadline=None)
@given(
    st.floats(0.02, 0.3), st.floats(0.02, 0.3), st.floats(0.01, 0.3), st.floats(0.2, 1.0), st.floats(0.0, 0.9)
)
@example(0.028, 0.06, 0.015, 0.98, 0.36)
@example(0.165, 0.09, 0.194, 0.92, 0.71)
@example(0.25, 0.1, 0.25, 0.875, 0.875)
def test_a_rounded_slab_passes_the_check_of_colliders(detail, x, y, z, corner, share):
    radius = corner * min(x, y) / 2.0
    slab = extrude(rectangle(x, y, radius=radius), z, bevel=0.99 * share * min(radius, z / 2.0))
    try:
        check_passed(slab, detail)
    except EvaluationError as error:
        assert "is too large for the profile" in str(error)  # noqa: PT017 fewer sides allow smaller bevels
        reject()


@pytest.mark.parametrize("detail", DETAILS)
def test_a_wide_rim_shows_though_it_adds_little_volume(detail):
    check_passed(primitive.cylinder(0.11, 0.07, bevel=0.014), detail)


@settings(max_examples=12, deadline=None)
@given(st.floats(0.02, 0.2), st.floats(0.02, 0.2), st.floats(0.3, 1.0), st.floats(0.02, 0.4))
@example(0.2, 0.2, 0.8, 0.1)
@example(0.047, 0.016, 0.58, 0.22)
def test_the_hollow_sides_of_a_loft_are_followed(x, y, share, height):
    solid = loft([rectangle(x, y), circle(share * min(x, y) / 2.0)], [0.0, height])
    check_shape(evaluate(solid).value, least_agreement=0.0)
    check_passed(solid, "full")


@pytest.mark.parametrize("detail", DETAILS)
@settings(max_examples=12, deadline=None)
@given(st.floats(0.015, 0.12), st.floats(0.03, 0.4), st.floats(0.0015, 0.006), st.floats(0.0, 1.0))
@example(0.032, 0.35, 0.0056, 1.0)
@example(0.11, 0.323, 0.0025, 1.0)
def test_the_rounded_rims_of_a_cup_are_followed(detail, radius, height, wall, share):
    cup = primitive.cylinder(radius, height, bevel=share * wall)
    check_passed(cup - primitive.bore(radius - wall, height).at(0, 0, wall), detail)


@pytest.mark.parametrize("detail", ["full", "low"])
@settings(max_examples=12, deadline=None)
@given(
    st.floats(0.04, 0.5), st.floats(0.3, 1.0), st.floats(0.2, 1.0), st.floats(0.01, 0.1), st.floats(0.0, 1.0)
)
@example(0.069, 0.8, 0.6, 0.06, 1.0)
def test_the_rounded_edges_of_a_bin_are_followed(detail, x, y, z, wall, share):
    size, wall = np.array((x, y * x, z * x)), wall * x * min(y, z)
    solid = primitive.box(*size, bevel=share * wall)
    check_passed(solid - primitive.box(*(size - (2.0 * wall, 2.0 * wall, 0.0))).at(0, 0, wall), detail)


@settings(max_examples=12, deadline=None)
@given(st.floats(0.04, 0.5), st.floats(0.3, 1.0), st.floats(0.05, 0.4), st.floats(0.0, 0.5))
@example(0.094, 0.5, 0.25, 0.2)
def test_the_rounded_edges_of_a_part_of_a_box_are_followed(x, y, share, cut):
    bevel = share * x * y / 2.0
    solid = primitive.box(x, x * y, x * y, bevel=bevel)
    check_passed(solid.split(point=(0, 0, x * y / 2.0 - (1.0 + cut) * bevel), normal=Z), "full")


@pytest.mark.parametrize(("radius", "height", "wall"), [(0.0742, 0.3991, 0.00163), (0.11, 0.323, 0.0025)])
def test_the_walls_of_a_turned_vessel_are_followed(radius, height, wall):
    foot = 0.7 * radius
    line = [(0, 0), (foot, 0), (radius, height), (radius - wall, height), (foot - wall, wall), (0, wall)]
    check_passed(revolve(polygon(line, radius=0.4 * wall)), "full")
