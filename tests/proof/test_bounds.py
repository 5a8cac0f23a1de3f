"""The closed-form bounds, apart from any asset: never violated, attained where they are exact.

What they bound is computed with 4x4 matrices (from quaternions, verified by exponentials of twists), which
share no formula with them. The same check is made of formulas with a fault, and has to fail.
"""

from collections.abc import Callable
from dataclasses import replace
from itertools import combinations, product
from typing import Any

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.linalg import expm
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

from artgen.proof import bounds
from artgen.proof.bounds import Motion
from support.cases import some

Array = NDArray[np.float64]

ROUNDING = 1e-9  # [m]
HALVES = (0.0, 1e-6, 0.01, 0.2, 0.7, 1.1, 1.19, 1.3, np.pi / 2, 2.0, 2.8, np.pi, 4.0)  # [rad]
seeds = st.integers(0, 10**6)


def unit(vectors: Array) -> Array:
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)


def random_motion(draw: np.random.Generator, count: int, kind: str | None = None) -> Motion:
    """One joint for each of some items; directions along coordinate axes are as likely as others."""
    chosen = kind or draw.choice(["revolute", "revolute", "prismatic"])
    axis = unit(draw.normal(size=(count, 3)))
    axis[draw.random(count) < 0.5] = np.eye(3)[draw.integers(3)] * draw.choice([-1, 1])
    size = draw.choice(HALVES) if draw.random() < 0.7 else draw.uniform(0.0, np.pi)
    half = np.where(draw.random(count) < 0.7, size, draw.uniform(0.0, size, count))
    center = draw.uniform(-np.pi, np.pi, count) * draw.integers(0, 2)
    return Motion(chosen, draw.normal(size=(count, 3)), axis, center, half)


def displacement(motion: Motion, q: Array) -> Array:
    """The joint's motion at positions of each item, shape (N, S, 4, 4)."""
    result = np.zeros((*q.shape, 4, 4))
    result[..., :3, :3], result[..., 3, 3] = np.eye(3), 1.0
    vectors = q[..., None] * motion.axis[:, None]
    if motion.kind == "prismatic":
        result[..., :3, 3] = vectors
        return result
    turn = Rotation.from_rotvec(vectors.reshape(-1, 3)).as_matrix().reshape(*q.shape, 3, 3)
    result[..., :3, :3] = turn
    result[..., :3, 3] = motion.origin[:, None] - (turn @ motion.origin[:, None, :, None])[..., 0]
    return result


@pytest.mark.parametrize("kind", ["revolute", "prismatic"])
def test_the_reference_is_the_exponential_of_the_twist(kind: str) -> None:
    draw = np.random.default_rng(1)
    motion = random_motion(draw, 5, kind)
    axis, turns = motion.axis, kind == "revolute"
    twist = np.zeros((5, 4, 4))
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        twist[:, i, j], twist[:, j, i] = -turns * axis[:, k], turns * axis[:, k]
    twist[:, :3, 3] = np.cross(motion.origin, axis) if turns else axis
    q = positions(draw, motion, 8)
    np.testing.assert_allclose(displacement(motion, q), expm(q[..., None, None] * twist[:, None]), atol=1e-12)


def positions(draw: np.random.Generator, motion: Motion, samples: int) -> Array:
    """Positions in the interval of each item, shape (N, S): any, the ends and the middle."""
    share = draw.uniform(-1.0, 1.0, (len(motion.half), samples))
    share = np.where(draw.random(share.shape) < 0.4, np.rint(share), share)
    return motion.center[:, None] + share * motion.half[:, None]


def carried(transforms: list[Array], points: Array) -> Array:
    """Points of each item moved by a product of transforms, shape (N, S, V, 3)."""
    moved = points[:, None]
    for transform in reversed(transforms):
        moved = moved @ np.swapaxes(transform[..., :3, :3], -1, -2) + transform[..., None, :3, 3]
    return moved


def true_gap(
    path: list[Motion], q: list[Array], frame: int, first: Array, second: Array, normals: Array
) -> Array:
    """The gap along the normals at sampled positions, shape (N, S, C)."""
    steps = [displacement(motion, at) for motion, at in zip(path, q, strict=True)]
    back = [np.linalg.inv(step) for step in steps[:frame]][::-1]
    columns = np.swapaxes(normals, 1, 2)[:, None]
    on_a, on_b = carried(back, first) @ columns, carried(steps[frame:], second) @ columns
    return on_b.min(axis=2) - on_a.max(axis=2)


def random_case(
    draw: np.random.Generator, joints: int, count: int = 4, corners: int = 3
) -> tuple[list[Motion], Array, Array, Array]:
    path = [random_motion(draw, count) for _ in range(joints)]
    size = draw.choice([0.0, 0.05, 1.0])  # of the pieces
    first, second = (
        draw.normal(size=(count, 1, 3)) + size * draw.normal(size=(count, draw.integers(1, 1 + corners), 3))
        for _ in range(2)
    )
    normals = unit(draw.normal(size=(count, 6, 3)))
    chosen = path[draw.integers(joints)]
    normals[:, 0] = chosen.axis
    for row in range(1, 4):  # across an axis, where arcs bulge farthest
        normals[:, row] = unit(np.cross(chosen.axis, draw.normal(size=(count, 3))))
    return path, first, second, normals


def worst_violation(seed: int, joints: int) -> float:
    """By how much the gap at a sampled position is smaller than its bound, at most [m]."""
    draw = np.random.default_rng([seed, joints])
    path, first, second, normals = random_case(draw, joints)
    q = [positions(draw, motion, 96) for motion in path]
    worst = -np.inf
    for frame in range(joints + 1):
        bound = bounds.gap(first, second, path, frame, normals)
        truth = true_gap(path, q, frame, first, second, normals)
        worst = max(worst, float((bound[:, None] - truth).max()))
    return worst


@pytest.mark.parametrize("joints", some([1, 2, 3, 4], 2))
@settings(max_examples=250)
@given(seed=seeds)
def test_no_sampled_position_is_closer_than_the_bound(joints: int, seed: int) -> None:
    assert worst_violation(seed, joints) <= ROUNDING


def smallest_gap(path: list[Motion], frame: int, first: Array, second: Array, normal: Array) -> float:
    """The smallest gap of one item where one joint moves each piece: sampled densely where it is small."""

    def lowest(motion: Motion, points: Array, sign: float) -> float:
        low, high = (float(motion.center[0] + side * motion.half[0]) for side in (-1, 1))
        for _ in range(4):
            q = np.linspace(low, high, 201)
            step = displacement(motion, q[None])
            if sign < 0.0:
                step = np.linalg.inv(step)
            heights = sign * (carried([step], points)[0] @ normal).T  # (V, S)
            at = int(np.argmin(heights.min(axis=0)))
            low, high = q[max(at - 1, 0)], q[min(at + 1, 200)]
        return float(heights.min())

    on_a = lowest(path[frame - 1], first, -1.0) if frame else -float((first[0] @ normal).max())
    on_b = lowest(path[frame], second, 1.0) if frame < len(path) else float((second[0] @ normal).min())
    return on_b + on_a


@settings(max_examples=150)
@given(seed=seeds, path_and_frame=st.sampled_from([(1, 0), (1, 1), (2, 1)]))
def test_the_bound_is_attained_where_each_piece_is_moved_by_one_joint(
    seed: int, path_and_frame: tuple[int, int]
) -> None:
    joints, frame = path_and_frame
    path, first, second, normals = random_case(np.random.default_rng([seed, 7]), joints, count=1)
    bound = bounds.gap(first, second, path, frame, normals)[0]
    truth = [smallest_gap(path, frame, first, second, normal) for normal in normals[0]]
    np.testing.assert_allclose(bound, truth, rtol=0.0, atol=ROUNDING)


@settings(max_examples=40)
@given(seed=seeds, joints=st.integers(2, 4), half=st.sampled_from([0.0, 0.01, 0.1]))
def test_the_bound_is_loose_to_second_order_only(seed: int, joints: int, half: float) -> None:
    """A bound by the length of arcs would be off by radius times angle, ten to hundred times as much."""
    draw = np.random.default_rng([seed, 8])
    path, first, second, normals = random_case(draw, joints)
    path = [replace(motion, half=np.full_like(motion.half, half)) for motion in path]
    grid = np.array(list(product(np.linspace(-1.0, 1.0, 5), repeat=joints))).T
    q = [motion.center[:, None] + half * share for motion, share in zip(path, grid, strict=True)]
    reach = sum(np.linalg.norm(motion.origin, axis=1).max() + 3.5 for motion in path)
    reach += max(np.linalg.norm(points, axis=2).max() for points in (first, second))
    for frame in range(joints + 1):
        bound = bounds.gap(first, second, path, frame, normals)
        truth = true_gap(path, q, frame, first, second, normals).min(axis=1)
        assert (truth - bound).max() <= joints * reach * half**2 + ROUNDING


@settings(max_examples=60)
@given(seed=seeds, kind=st.sampled_from(["revolute", "prismatic"]))
def test_the_enclosing_points_enclose(seed: int, kind: str) -> None:
    """In every direction, and so their hull."""
    draw = np.random.default_rng([seed, 9])
    motion, points = random_motion(draw, 4, kind), draw.normal(size=(4, 3, 3))
    around = bounds.enclosing_points(motion, points)
    moved = carried([displacement(motion, positions(draw, motion, 64))], points)
    directions = unit(draw.normal(size=(40, 3)))
    assert ((moved @ directions.T).max(axis=(1, 2)) <= (around @ directions.T).max(axis=1) + ROUNDING).all()


# the faults, each of which the same check has to find


def halved(motion: Motion) -> Motion:
    return replace(motion, half=motion.half / 2.0)


def still(motion: Motion) -> Motion:
    return replace(motion, half=np.zeros_like(motion.half))


def ends_only(motion: Motion, points: Array, normals: Array) -> Array:
    """The support without the amplitude of the circle: at both ends of the interval."""
    low, high = (still(replace(motion, center=motion.center + side * motion.half)) for side in (-1, 1))
    return np.maximum(exact_support(low, points, normals), exact_support(high, points, normals))


def without_tangents(motion: Motion, points: Array) -> Array:
    found = exact_points(motion, points)
    count = points.shape[1]
    return found[:, : 2 * count] if found.shape[1] == 3 * count else found


def without_radius(motion: Motion, points: Array) -> Array:
    """Wide arcs enclosed by an octagon on the circle instead of around it."""
    found = exact_points(motion, points)
    count = points.shape[1]
    if found.shape[1] != 8 * count:
        return found
    middle = found.reshape(len(found), 8, count, 3).mean(axis=1)
    return np.tile(middle, (1, 8, 1)) + np.cos(np.pi / 8) * (found - np.tile(middle, (1, 8, 1)))


exact_support, exact_points = bounds.support, bounds.enclosing_points
FAULTS: dict[str, tuple[str, Any]] = {
    "half the interval in the support": ("support", lambda m, p, n: exact_support(halved(m), p, n)),
    "half the interval around outer joints": ("enclosing_points", lambda m, p: exact_points(halved(m), p)),
    "no amplitude": ("support", ends_only),
    "no interval": ("support", lambda m, p, n: exact_support(still(m), p, n)),
    "no tangent point": ("enclosing_points", without_tangents),
    "no rule for wide angles": ("WIDEST", np.inf),
    "octagon within the circle": ("enclosing_points", without_radius),
    "outer joints held still": ("enclosing_points", lambda m, p: exact_points(still(m), p)),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_the_check_finds_a_fault_in_the_formulas(fault: str, monkeypatch: pytest.MonkeyPatch) -> None:
    name, wrong = FAULTS[fault]
    monkeypatch.setattr(bounds, name, wrong)
    assert any(worst_violation(seed, 3) > 1e-3 for seed in range(60))


def test_the_check_finds_a_joint_crossed_the_wrong_way(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Motion, "reversed", lambda self: self)
    assert any(worst_violation(seed, 1) > 1e-3 for seed in range(60))


# what does not change about an axis

Profile = Callable[[Array, Array, Array], Array]


def distance_from_axis(points: Array, origin: Array, axis: Array) -> float:
    """Smallest distance of the hull of some points, shape (V, 3), from an axis."""
    across = np.linalg.svd(axis[None])[2][1:]
    flat = (points - origin) @ across.T
    angles = np.sort(np.arctan2(flat[:, 1], flat[:, 0]))
    if np.diff(angles, append=angles[0] + 2 * np.pi).max() < np.pi:
        return 0.0  # the axis runs through the hull
    result = np.linalg.norm(flat, axis=1).min()
    for a, b in combinations(flat, 2):
        along = (b - a) @ (b - a)
        share = np.clip(-a @ (b - a) / along, 0.0, 1.0) if along > 0.0 else 0.0
        result = min(result, np.linalg.norm(a + share * (b - a)))
    return float(result)


def random_pieces(draw: np.random.Generator, count: int, origin: Array, axis: Array) -> Array:
    """Convex pieces about an axis, such as the wedges of a bore."""
    corners = draw.integers(4, 9)
    points = 0.3 * draw.normal(size=(count, corners, 3)) + draw.normal(size=(count, 1, 3))
    points -= draw.uniform(0.0, 1.0) * ((points - origin) @ axis)[..., None] * axis
    return points + origin


def worst_profile_violation(seed: int) -> float:
    """By how much points of pieces that turn and slide are nearer than the profile bound, at most [m]."""
    draw = np.random.default_rng([seed, 5])
    origin, axis = draw.normal(size=3), unit(draw.normal(size=3))
    first, second = (random_pieces(draw, 6, origin, axis) for _ in range(2))
    second = second + draw.normal() * axis
    shift, half = draw.normal(size=6), draw.uniform(0.0, 0.5, 6)
    bound = bounds.axis_gap(
        bounds.around_axis(first, origin, axis), bounds.around_axis(second, origin, axis), shift, half
    )
    count = np.broadcast_to(origin, (6, 3)), np.broadcast_to(axis, (6, 3)), np.zeros(6), np.full(6, np.pi)
    turn = displacement(Motion("revolute", *count), draw.uniform(-np.pi, np.pi, (6, 40)))
    along = shift[:, None] + draw.choice([-1.0, 0.0, 0.5, 1.0], (6, 40)) * half[:, None]
    dense_a, dense_b = (_inside(draw, points) for points in (first, second))
    moved = carried([turn], dense_b) + (along[..., None] * axis)[:, :, None]
    between = [cKDTree(a).query(b.reshape(-1, 3))[0].min() for a, b in zip(dense_a, moved, strict=True)]
    return float((bound - between).max())


def _inside(draw: np.random.Generator, points: Array) -> Array:
    """The corners of pieces, points on their edges, and points within."""
    weights = draw.dirichlet(np.full(points.shape[1], 0.3), size=40)
    return np.concatenate((points, weights @ points), axis=1)


@settings(max_examples=150)
@given(seed=seeds)
def test_no_turned_pieces_are_closer_than_the_profile_bound(seed: int) -> None:
    assert worst_profile_violation(seed) <= ROUNDING


@settings(max_examples=150)
@given(seed=seeds)
@example(seed=0)
@example(seed=10)
def test_heights_and_distances_about_an_axis_hold_for_the_whole_piece(seed: int) -> None:
    draw = np.random.default_rng([seed, 6])
    origin, axis = draw.normal(size=3), unit(draw.normal(size=3))
    pieces = random_pieces(draw, 6, origin, axis)
    low, high, near, far = bounds.around_axis(pieces, origin, axis).T
    inside = _inside(draw, pieces) - origin
    height = inside @ axis
    radius = np.linalg.norm(np.cross(inside, axis), axis=2)
    assert (height.min(axis=1) >= low - ROUNDING).all()
    assert (height.max(axis=1) <= high + ROUNDING).all()
    assert (radius.max(axis=1) <= far + ROUNDING).all()
    truth = np.array([distance_from_axis(piece, origin, axis) for piece in pieces])
    assert (near <= truth + ROUNDING).all()
    # attained: by a corner, and by the side or corner next to the axis
    np.testing.assert_allclose(height.max(axis=1), high, atol=ROUNDING)
    np.testing.assert_allclose(radius.max(axis=1), far, atol=ROUNDING)
    np.testing.assert_allclose(near, truth, atol=ROUNDING)


def farthest_corner_only(points: Array, origin: Array, axis: Array) -> Array:
    found = exact_profile(points, origin, axis)
    radius = np.linalg.norm(np.cross(points - origin, axis), axis=2)
    found[:, 2] = radius.min(axis=1)  # a side may be nearer than its corners
    return found


def without_slide(first: Array, second: Array, shift: Array, half: Array) -> Array:
    return exact_axis_gap(first, second, shift, np.zeros_like(half))


exact_profile, exact_axis_gap = bounds.around_axis, bounds.axis_gap
PROFILE_FAULTS: dict[str, tuple[str, Any]] = {
    "distance of the corners only": ("around_axis", farthest_corner_only),
    "no interval along the axis": ("axis_gap", without_slide),
    "slide the wrong way": ("axis_gap", lambda a, b, shift, half: exact_axis_gap(a, b, -shift, half)),
    "half the interval along the axis": (
        "axis_gap",
        lambda a, b, s, half: exact_axis_gap(a, b, s, half / 2.0),
    ),
}


@pytest.mark.parametrize("fault", PROFILE_FAULTS)
def test_the_check_finds_a_fault_in_the_profile_bound(fault: str, monkeypatch: pytest.MonkeyPatch) -> None:
    name, wrong = PROFILE_FAULTS[fault]
    monkeypatch.setattr(bounds, name, wrong)
    assert any(worst_profile_violation(seed) > 1e-3 for seed in range(200))
