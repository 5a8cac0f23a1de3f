import math
from itertools import product

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from artgen.errors import EvaluationError
from artgen.graph import evaluate
from artgen.materials import material
from artgen.nodes import csg, extrude, primitive, profile, solid_methods
from artgen.nodes.handles import Solid
from artgen.nodes.primitive import box, cylinder
from support.cases import some
from support.shapes import X, Y, Z, check_metric, check_shape, relative_volume, same_bytes

BLOCK = primitive._box(0.1, 0.1, 0.1, 0.005)
PIN = primitive._cylinder(0.02, 0.2, Z, 0.0)
FAR = solid_methods._translate(PIN, X)
CORNER = profile._polygon(((0, 0), (0.3, 0), (0.3, 0.2), (0.15, 0.2), (0.15, 0.1), (0, 0.1)), 0.0)


def value(handle):
    return evaluate(handle).value


def volume(shape):
    return shape.manifold.volume()


def test_booleans_obey_inclusion_and_exclusion():
    either, both, rest = csg.united((BLOCK, PIN)), csg._intersection(BLOCK, PIN), csg._difference(BLOCK, PIN)
    for shape in (either, both, rest):
        check_shape(shape)
    assert volume(either) == pytest.approx(volume(BLOCK) + volume(PIN) - volume(both))
    assert volume(rest) == pytest.approx(volume(BLOCK) - volume(both))
    assert rest.manifold.genus() == 1


def test_operators_are_the_operations():
    a, b = box(0.1, 0.1, 0.1), cylinder(0.02, 0.2)
    for made, plain in (
        (a | b, csg.union(a, b)),
        (a - b, Solid.record("difference", a=a, b=b)),
        (a & b, Solid.record("intersection", a=a, b=b)),
    ):
        assert made.node.key == plain.node.key
        assert same_bytes(value(made), value(plain))


@settings(max_examples=10)
@given(st.lists(st.tuples(*[st.floats(-0.05, 0.05)] * 3), min_size=2, max_size=5))
def test_a_union_of_many_is_the_union_one_by_one(places):
    shapes = [solid_methods._translate(BLOCK, np.array(place)) for place in places]
    together = csg.united(shapes)
    check_shape(together)
    one_by_one = shapes[0]
    for shape in shapes[1:]:
        one_by_one = csg.united((one_by_one, shape))
    assert volume(together) == pytest.approx(volume(one_by_one), rel=1e-9)


def test_a_cut_keeps_texture_and_smooth_normals():
    cut = csg._difference(primitive._box(0.1, 0.1, 0.1, 0.0), PIN)
    mesh = cut.mesh
    bore = np.abs(np.linalg.norm(mesh.vertices[:, :2], axis=1) - 0.02) < 1e-9
    inside = bore & (np.abs(mesh.normals[:, 2]) < 0.5)
    inward = -mesh.vertices[inside, :2] / 0.02
    np.testing.assert_allclose(mesh.normals[inside, :2], inward, atol=1e-6)
    check_metric(cut)


def test_paint_stays_on_what_the_tool_cut():
    steel, brass = material("steel"), material("brass")
    cut = csg._difference(csg._paint(BLOCK, brass), csg._paint(PIN, steel))
    assert dict(cut.paints) == {steel.number: steel, brass.number: brass}
    mesh = cut.mesh
    painted = mesh.paints == steel.number
    assert set(mesh.paints.tolist()) == {steel.number, brass.number}
    np.testing.assert_allclose(np.linalg.norm(mesh.vertices[painted, :2], axis=1), 0.02, atol=1e-9)
    moved = solid_methods._rotate(solid_methods._scale(cut, np.array([1.0, 2.0, 1.0])), X, 0.3, np.zeros(3))
    assert set(moved.mesh.paints.tolist()) == {steel.number, brass.number}
    check_shape(moved)


def test_the_last_coat_of_paint_shows():
    steel, brass = material("steel"), material("brass")
    coated = csg._paint(csg._paint(PIN, brass), steel)
    assert dict(coated.paints) == {steel.number: steel}
    assert set(coated.mesh.paints.tolist()) == {steel.number}
    rows = [np.column_stack([mesh.vertices, mesh.normals]) for mesh in (coated.mesh, PIN.mesh)]
    np.testing.assert_array_equal(*(np.unique(each.round(12), axis=0) for each in rows))


def test_two_paints_of_one_name_are_refused():
    steel = material("steel")
    with pytest.raises(ValueError, match="two different materials are both named 'steel'"):
        csg.united((csg._paint(BLOCK, steel), csg._paint(FAR, steel.with_(specular_roughness=0.9))))


def test_a_hull_is_convex_and_has_normals():
    shape = csg._hull((BLOCK, solid_methods._translate(PIN, 0.1 * X)))
    check_shape(shape)
    assert volume(shape) == pytest.approx(shape.manifold.hull().volume())
    sharp = csg._hull((primitive._box(0.1, 0.2, 0.3, 0.0),))
    assert relative_volume(sharp, 0.006) == pytest.approx(1.0)
    check_metric(sharp)
    assert sharp.pieces.outer(0.001)[0].kind == "box"


@settings(max_examples=15)
@given(st.floats(-0.03, 0.03), st.floats(0.0, 6.28), st.floats(0.2, 3.0))
def test_halves_make_the_whole(shift, across, down):
    normal = np.array([math.sin(down) * math.cos(across), math.sin(down) * math.sin(across), math.cos(down)])
    whole = csg._difference(BLOCK, PIN)
    halves = [csg._split(whole, shift * normal, side * normal) for side in (1.0, -1.0)]
    for side, half in zip((1.0, -1.0), halves, strict=True):
        check_shape(half)
        assert (side * (half.mesh.vertices @ normal - shift)).min() > -1e-9
    assert sum(map(volume, halves)) == pytest.approx(volume(whole), rel=1e-9)


@pytest.mark.parametrize(("bevel", "open_side"), some(product([0.0, 0.002, 0.016], [None, Z, -Y]), 2))
def test_a_shell_has_walls_of_its_thickness(bevel, open_side):
    outer = primitive._box(0.1, 0.2, 0.3, bevel)
    shape = csg._shell(outer, 0.01, open_side)
    check_shape(shape)
    lengths = np.array([0.08, 0.18, 0.28])
    if bevel == 0.0:
        if open_side is not None:
            lengths = lengths + 0.01 * np.abs(open_side)
        assert volume(shape) == pytest.approx(volume(outer) - math.prod(lengths))
        assert shape.manifold.genus() == (0 if open_side is not None else -1)
    probe = solid_methods._translate(primitive._box(0.0099, 0.01, 0.01, 0.0), 0.045 * X).manifold
    assert (probe - shape.manifold).volume() < 1e-12


@pytest.mark.parametrize(
    "solid",
    [primitive._cylinder(0.05, 0.1, Z, 0.003), primitive._sphere(0.05), primitive._dome(0.05, None, Z)],
)
@pytest.mark.long
def test_round_things_have_shells(solid):
    shape = csg._shell(solid, 0.003, None)
    check_shape(shape)
    assert volume(shape) == pytest.approx(0.003 * solid.manifold.surface_area(), rel=0.12)


def test_a_shell_needs_a_convex_solid_with_room():
    with pytest.raises(ValueError, match="needs a convex solid, this one fills only 86 % of its hull"):
        csg._shell(extrude._extrude(CORNER, 0.1, Z, 0.0, 0.0, 0.0), 0.01, None)
    with pytest.raises(
        ValueError, match=r"thickness 0\.06 m leaves no cavity: the solid is only about 0.1 m thick"
    ):
        csg._shell(BLOCK, 0.06, None)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: box(0.1, 0.1, 0.1) - box(0.2, 0.2, 0.2), "difference is empty: the second solid contains"),
        (
            lambda: box(0.1, 0.1, 0.1) & box(0.1, 0.1, 0.1).at(1),
            "intersection is empty: the solids do not overlap",
        ),
        (lambda: box(0.1, 0.1, 0.1).split(point=(0, 0, 1), normal=(0, 0, 1)), "whole solid lies behind"),
        (csg.union, "a union needs at least one solid, got none"),
        (csg.hull, "a hull needs at least one solid, got none"),
    ],
)
def test_empty_results_name_the_authors_line(make, message):
    with pytest.raises(EvaluationError, match=message) as caught:
        evaluate(make())
    assert "test_csg.py" in str(caught.value)


def test_an_array_of_disjoint_copies_is_composed():
    places = np.array([[0.05 * i, 0.0, 0.0] for i in range(8)])
    shape = csg._array(PIN, places)
    check_shape(shape)
    assert volume(shape) == pytest.approx(8 * volume(PIN))
    assert len(shape.manifold.decompose()) == 8
    assert len(shape.pieces.outer(0.001)) == 8


def test_an_array_of_overlapping_copies_is_united():
    shape = csg._array(PIN, np.array([[0.03 * i, 0.0, 0.0] for i in range(3)]))
    check_shape(shape)
    assert len(shape.manifold.decompose()) == 1
    assert volume(shape) < 3 * volume(PIN)


def test_an_enclosed_solid_collides_as_its_hull_and_stays_what_it_was():
    comb = csg._array(PIN, np.array([[0.05 * i, 0.0, 0.0] for i in range(8)]))
    shape = csg._bounding_collider(comb)
    assert volume(shape) == pytest.approx(volume(comb))
    (around,) = shape.pieces.outer(0.001)
    assert np.ptp(around.bounds(), axis=0) == pytest.approx(np.ptp(comb.bounds(), axis=0), abs=0.002)
    assert len(shape.pieces.inner(0.001)) == len(comb.pieces.inner(0.001))


def test_covers_take_the_place_of_a_solids_colliders():
    comb = csg._array(PIN, np.array([[0.05 * i, 0.0, 0.0] for i in range(3)]))
    low, high = comb.bounds()
    half = primitive._box(*(high - low) / (2.0, 1.0, 1.0), 0.0)  # two of them meet in the middle of a pin
    middles = [low + (high - low) * (share, 0.5, 0.5) for share in (0.25, 0.75)]
    covers = tuple(solid_methods._translate(half, middle) for middle in middles)
    shape = csg._bounding_collider(comb, covers)
    assert volume(shape) == pytest.approx(volume(comb))
    assert [piece.kind for piece in shape.pieces.outer(0.001)] == ["box", "box"]
    assert len(solid_methods._translate(shape, X).pieces.declared()) == 2
    gap = tuple(solid_methods._scale(cover, np.array([0.99, 1.0, 1.0])) for cover in covers)
    with pytest.raises(
        ValueError, match=r"do not contain the solid: a part of .* mm at \(.*\) m lies outside"
    ):
        csg._bounding_collider(comb, gap)


def test_an_array_needs_points():
    with pytest.raises(ValueError, match="at needs at least 1 points, got 0"):
        csg._array(PIN, np.zeros((0, 3)))


def test_a_tree_of_operations_is_the_same_twice():
    def make():
        body = box(0.1, 0.2, 0.3, bevel=0.005) - cylinder(0.02, 0.5, axis=(0, 1, 0))
        return csg.hull(body, cylinder(0.05, 0.1).at(0.2)) - csg.array(
            cylinder(0.01, 1.0), at=[(0.0, 0, 0), (0.05, 0, 0)]
        )

    assert same_bytes(value(make()), value(make()))


def test_a_long_chain_of_unions_works_and_one_of_cuts_names_the_authors_line():
    chain = start = box(0.2, 0.1, 0.1)
    knobs = [box(0.01, 0.01, 0.02).at(x=0.0001 * number, z=0.05) for number in range(600)]
    for knob in knobs:
        chain = chain | knob
    shape = value(chain)
    assert shape.manifold.volume() == pytest.approx(value(csg.union(start, *knobs)).manifold.volume())
    assert len(shape.pieces.outer(0.001)) == 601
    for knob in knobs[:180]:
        start = start - knob
    assert len(value(start).pieces.outer(0.001)) > 0
    for knob in knobs[:30]:
        start = start - knob
    message = (
        r"difference failed: .* more than 200 operations, .* solid - union\(\*cutters\)\s+at .*test_csg.py"
    )
    with pytest.raises(EvaluationError, match=message):
        value(start)
