"""Texture coordinates of every builder: metres, never mirrored, grain along the long side."""

import math
from dataclasses import dataclass

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from artgen.nodes import csg, extrude, loft, path, primitive, profile, solid_methods, surfaces, sweep
from support.shapes import X, Y, Z, agreement

LENGTHS = st.floats(0.01, 2.0)
SHARES = st.floats(0.0, 0.8)
AXES = st.sampled_from([X, Y, Z, -X, -Y, -Z])
few = settings(max_examples=12, deadline=None)


@dataclass(frozen=True, eq=False)
class Laid:
    """How texture lies on the faces of a mesh: derivatives of the texture coordinates along the surface.

    Attributes:
        stretch: Greatest and least length in the texture of a metre on the face, shape (m, 2).
        mirrored: Whether the texture reads backwards from outside, shape (m,).
        area: Area of each face, shape (m,) [m^2].
        normals: Outward unit normals, shape (m, 3).
        grain: Direction on the face along which v grows and u is the same, shape (m, 3).
    """

    stretch: np.ndarray
    mirrored: np.ndarray
    area: np.ndarray
    normals: np.ndarray
    grain: np.ndarray


def laid(mesh):
    corners, uvs = mesh.vertices[mesh.triangles], mesh.uvs[mesh.triangles]
    sides = corners[:, 1:] - corners[:, :1]
    across = np.cross(sides[:, 0], sides[:, 1])
    double = np.linalg.norm(across, axis=1)
    longest = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(axis=1)
    sound = double > 1e-4 * longest**2
    assert sound.any()
    sides, normals = sides[sound], across[sound] / double[sound, None]
    x = sides[:, 0] / np.linalg.norm(sides[:, 0], axis=1, keepdims=True)
    frame = np.stack([x, np.cross(normals, x)], axis=1)
    plane = np.einsum("tfi,tsi->tfs", frame, sides)
    change = np.swapaxes(uvs[sound, 1:] - uvs[sound, :1], 1, 2) @ np.linalg.inv(plane)
    grain = np.einsum("tf,tfi->ti", np.linalg.inv(change)[:, :, 1], frame)
    return Laid(
        np.linalg.svd(change, compute_uv=False),
        np.linalg.det(change) < 0.0,
        0.5 * double[sound],
        normals,
        grain / np.linalg.norm(grain, axis=1, keepdims=True),
    )


def check_laid(shape, stretch=1.0, off=0.0):
    """Assert that texture is not mirrored and, but for a share `off` of the surface, keeps lengths.

    Within `stretch` everywhere; 2 % are what chords miss of their arcs.
    """
    found = laid(shape.mesh)
    assert not found.mirrored.any(), f"{found.mirrored.mean():.0%} of the faces are mirrored"
    uneven = (np.abs(found.stretch - 1.0) > 0.02).any(axis=1)
    share = found.area[uneven].sum() / found.area.sum()
    assert share <= off, f"texture is stretched on {share:.1%} of the surface"
    worst = max(found.stretch.max(), 1.0 / found.stretch.min())
    assert worst <= 1.02 * stretch, f"texture is stretched {worst:.3f} times"
    assert agreement(shape) > 0.0, "a normal looks into the solid"
    return found


def mitred(radius):
    """Return how much texture is stretched by the shear of a narrow strip between the mitres of a circle."""
    half = 0.5 * math.tan(math.pi / surfaces.sides_of(radius))
    return half + math.hypot(1.0, half)


def check_grain(shape, axis, share=1.0):
    """Assert that v runs along an axis on that share of all faces but those square to it."""
    found = laid(shape.mesh)
    side = np.abs(found.normals[:, axis]) < 0.1
    assert side.any()
    straight = np.abs(found.grain[side, axis]) > 0.99
    found_share = found.area[side][straight].sum() / found.area[side].sum()
    assert found_share > share - 1e-9, f"grain runs along axis {axis} on {found_share:.1%} of the sides"


@few
@given(LENGTHS, LENGTHS, LENGTHS, SHARES)
def test_boxes(x, y, z, share):
    size = np.array([x, y, z])
    shape = primitive._box(x, y, z, share * size.min() / 2.0)
    check_laid(shape, stretch=1.75, off=1.0)  # corners are eighths of spheres
    sharp = primitive._box(x, y, z, 0.0)
    check_laid(sharp)
    longest, second, _ = np.argsort(-size)
    if size[longest] > 1.001 * size[second]:
        check_grain(sharp, longest)
        check_grain(shape, longest, 0.9)


def test_rounded_edges_of_a_box_keep_lengths():
    found = check_laid(primitive._box(0.1, 0.2, 0.9, 0.02), stretch=1.6, off=0.01)
    bevel = np.abs(found.normals).max(axis=1) < 0.99
    straight = bevel & (np.abs(found.normals).min(axis=1) < 1e-9)
    assert (np.abs(found.stretch[straight] - 1.0) < 0.03).all()


def test_a_picture_on_a_cube_stands_upright_on_its_walls():
    shape = primitive._box(0.2, 0.2, 0.2, 0.0)
    mesh, found = shape.mesh, laid(shape.mesh)
    wall = np.abs(found.normals[:, 2]) < 0.1
    np.testing.assert_allclose(found.grain[wall], np.broadcast_to(Z, (wall.sum(), 3)), atol=1e-9)
    front = np.flatnonzero(mesh.normals[:, 1] < -0.9)
    np.testing.assert_allclose(mesh.uvs[front], mesh.vertices[front][:, [0, 2]], atol=1e-9)
    back = np.flatnonzero(mesh.normals[:, 1] > 0.9)
    np.testing.assert_allclose(mesh.uvs[back], mesh.vertices[back][:, [0, 2]] * [-1, 1], atol=1e-9)


@few
@given(LENGTHS, LENGTHS, AXES, SHARES)
def test_cylinders(radius, length, axis, share):
    bevel = share * min(radius, length / 2.0)
    check_laid(primitive._cylinder(radius, length, axis, 0.0))
    shape = primitive._cylinder(radius, length, axis, bevel)
    check_laid(shape, stretch=mitred(radius) * radius / (radius - bevel), off=1.0)
    check_grain(shape, int(np.argmax(np.abs(axis))))
    check_laid(primitive._bore(radius, length, axis))


@few
@given(LENGTHS, SHARES, LENGTHS, AXES)
def test_tubes_are_metric_inside_and_outside(outer, share, length, axis):
    inner = max(0.1, share) * outer
    shape = primitive._tube(outer, inner, length, axis, 0.0)
    check_laid(shape)
    check_grain(shape, int(np.argmax(np.abs(axis))))
    bevelled = primitive._tube(outer, inner, length, axis, 0.1 * min(outer - inner, length))
    check_laid(bevelled, stretch=2.0, off=1.0)


@few
@given(LENGTHS, AXES)
def test_round_things_stretch_only_towards_their_poles(radius, axis):
    ball = check_laid(primitive._sphere(radius), stretch=20.0, off=1.0)
    belt = np.abs(ball.normals[:, 2]) < 0.6
    assert ball.stretch[belt].min() > 0.75
    assert ball.stretch[belt].max() < 1.2
    check_laid(primitive._dome(radius, 0.5 * radius, axis), stretch=20.0, off=1.0)
    check_laid(primitive._torus(radius, 0.25 * radius, axis), stretch=1.5, off=1.0)
    check_laid(primitive._frustum(radius, 0.6 * radius, radius, axis, 0.0), stretch=1.4, off=1.0)
    stretched = check_laid(primitive._capsule(radius, 6.0 * radius, axis), stretch=20.0, off=0.4)
    assert np.median(np.abs(stretched.stretch - 1.0)) < 0.02


@few
@given(LENGTHS, LENGTHS, LENGTHS)
def test_wedges(x, y, z):
    check_laid(primitive._wedge(x, y, z))


@few
@given(LENGTHS, LENGTHS, LENGTHS, AXES, SHARES)
def test_extrusions(width, height, length, axis, share):
    sharp = extrude._extrude(profile._rectangle(width, height, 0.0), length, axis, 0.0, 0.0, 0.0)
    check_laid(sharp)
    radius = 0.4 * min(width, height)
    rounded = profile._rectangle(width, height, radius)
    bevel = share * min(radius, 0.4 * length)
    shape = extrude._extrude(rounded, length, axis, bevel, 0.0, 0.0)
    check_laid(shape, stretch=mitred(radius) * radius / (radius - bevel), off=1.0)
    size = np.ptp(shape.bounds(), axis=0)
    longest, second, _ = np.argsort(-size)
    if size[longest] > 1.001 * size[second]:
        check_grain(sharp, longest)


@pytest.mark.parametrize("axis", [X, Y, Z, -X, -Y, -Z])
@pytest.mark.parametrize("turned", [False, True])
def test_the_grain_of_an_extruded_board_runs_along_it(axis, turned):
    section = (0.1, 0.04) if turned else (0.04, 0.1)
    board = extrude._extrude(profile._rectangle(*section, 0.0), 2.0, axis, 0.005, 0.0, 0.0)
    check_grain(board, int(np.argmax(np.abs(axis))), 0.99)
    sheet = (2.0, 0.1) if turned else (0.1, 2.0)
    panel = extrude._extrude(profile._rectangle(*sheet, 0.0), 0.04, axis, 0.005, 0.0, 0.0)
    check_grain(panel, int(np.argmax(np.ptp(panel.bounds(), axis=0))), 0.99)  # all but the mitred bevels


@pytest.mark.parametrize("axis", [Y, -Y])
def test_pictures_on_extruded_fronts_stand_upright(axis):
    found = laid(extrude._extrude(profile._rectangle(0.2, 0.2, 0.0), 0.02, axis, 0.0, 0.0, 0.0).mesh)
    cap = np.abs(found.normals[:, 1]) > 0.9
    np.testing.assert_allclose(found.grain[cap], np.broadcast_to(Z, (cap.sum(), 3)), atol=1e-9)


def test_grain_follows_an_arched_head():
    """Around the inside and outside of an arch cut from a panel, v runs along the edge."""
    arch = profile._profile_difference(profile._circle(0.5), profile._circle(0.4))
    half = profile._profile_intersection(
        arch, profile._profile_translate(profile._rectangle(2.0, 1.0, 0.0), 0.0, 0.5)
    )
    shape = extrude._extrude(half, 0.05, Y, 0.003, 0.0, 0.0)
    found = check_laid(shape, stretch=2.2, off=0.05)
    wall = np.abs(found.normals[:, 1]) < 0.1
    assert np.abs(found.grain[wall, 1]).max() < 0.05


@few
@given(st.floats(-0.5, 0.5), AXES)
def test_tapered_bars_have_straight_grain(taper, axis):
    shape = extrude._extrude(profile._rectangle(0.05, 0.04, 0.0), 0.5, axis, 0.0, taper, 0.0)
    check_laid(shape)
    tapered = profile._rectangle(0.05, 0.04, 0.0), profile._rectangle(0.03, 0.024, 0.0)
    check_laid(loft._loft(tapered, (0.0, 0.5), axis))
    check_laid(loft._loft(tapered, (0.0, 0.008), axis), stretch=1.1, off=1.0)
    both = profile._circle(0.05), profile._circle(0.03)
    check_laid(loft._loft(both, (0.0, 0.3), axis), stretch=1.35, off=1.0)


def test_a_creased_loft_is_metric_on_both_sides_of_the_crease():
    rings = profile._circle(0.05), profile._circle(0.05), profile._circle(0.1), profile._circle(0.1)
    found = check_laid(loft._loft(rings, (0.0, 0.2, 0.201, 0.4), Z), stretch=1.6, off=0.4)
    side = np.abs(found.normals[:, 2]) < 0.1
    assert (np.abs(found.stretch[side] - 1.0) < 0.01).all()


BENT = (0 * X, 0.05 * Z, 0.05 * Z + 0.2 * X, np.array([0.2, 0.1, 0.0]))
RADIUS = 0.04
PATHS = {
    "line": (path._line(0 * X, 0.1 * X + 0.1 * Z), 1.0),
    "sharp": (path._polyline(BENT, 0.0, False), 1.0),
    "sharp ring": (path._polyline((0 * X, X, X + Y, Y), 0.0, True), 1.0),
    "filleted": (path._polyline(BENT, RADIUS, False), RADIUS / (RADIUS - 0.007)),
    "arc": (path._arc(0 * X, RADIUS, 0.0, 2.0, Y), RADIUS / (RADIUS - 0.007)),
    "circle": (path._arc(0 * X, RADIUS, 0.0, math.tau, Z), RADIUS / (RADIUS - 0.007)),
    "helix": (path._helix(0.05, 0.03, 2.0, Z), 1.2),
}


@pytest.mark.parametrize("name", PATHS)
@pytest.mark.parametrize("outline", [profile._circle(0.006), profile._rectangle(0.012, 0.008, 0.001)])
def test_sweeps_measure_along_their_path(name, outline):
    curve, stretch = PATHS[name]
    shape = sweep._sweep(outline, curve)
    check_laid(shape, stretch=1.02 * stretch, off=float(stretch > 1.0))


@few
@given(st.floats(0.05, 1.0), st.floats(0.3, 6.0), AXES)
def test_revolved_sections(radius, angle, axis):
    section = profile._profile_translate(profile._rectangle(0.04, 0.1, 0.0), radius, 0.0)
    check_laid(extrude._revolve(section, angle, axis))


@few
@given(st.lists(st.tuples(*[st.floats(-0.3, 0.3)] * 3), min_size=6, max_size=12))
def test_hulls_are_projected_along_their_long_side(points):
    corners = [primitive._box(0.05, 0.05, 0.05, 0.0)]
    corners += [solid_methods._translate(corners[0], np.array(point)) for point in points]
    shape = csg._hull(tuple(corners))
    found = check_laid(shape, stretch=math.sqrt(3.0), off=1.0)
    size = np.ptp(shape.bounds(), axis=0)
    *_, second, long_side = np.argsort(size)
    if size[long_side] < 1.001 * size[second]:
        return
    side = np.argmax(np.abs(found.normals), axis=1) != long_side
    assert np.abs(found.grain[side, long_side]).min() > 0.5


def test_texture_and_normals_survive_booleans():
    board = primitive._box(0.04, 0.1, 0.6, 0.004)
    whole = laid(board.mesh)
    cut = csg._difference(board, solid_methods._translate(primitive._box(0.02, 0.2, 0.1, 0.0), 0.1 * Z))
    found = laid(cut.mesh)
    own = ~found.mirrored  # faces that the tool cut have the tool's texture, seen from behind
    assert found.area[own].sum() > 0.8 * whole.area.sum()
    assert (np.abs(found.stretch[found.mirrored] - 1.0) < 0.01).all()
    assert agreement(cut) > 0.9
    mesh = cut.mesh
    front = np.flatnonzero((mesh.normals[:, 1] < -1 + 1e-9) & (np.abs(mesh.vertices[:, 0]) < 0.016))
    np.testing.assert_allclose(mesh.uvs[front], mesh.vertices[front][:, [0, 2]], atol=1e-7)


def test_curved_sides_are_smooth_and_edges_sharp():
    mesh = primitive._cylinder(0.1, 0.3, Z, 0.0).mesh
    side = np.abs(mesh.normals[:, 2]) < 0.5
    radial = mesh.vertices[side, :2] / 0.1
    np.testing.assert_allclose(mesh.normals[side, :2], radial, atol=1e-6)
    assert (np.abs(mesh.normals[~side, 2]) > 1 - 1e-9).all()
