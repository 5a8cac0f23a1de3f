"""Openings of a link: what may be filled and what has to stay free; and primitives around several pieces."""

import numpy as np
import pytest

from artgen.colliders import Convex
from artgen.colliders.budget import around
from artgen.colliders.openings import Openings


def block(low, high):
    pose = np.eye(4)
    pose[:3, 3] = (np.array(low) + high) / 2.0
    return Convex.box(tuple(np.subtract(high, low)), pose)


def channel(width, depth=0.1):
    """Two walls on a floor, along x."""
    half = width / 2.0
    return [
        block((-0.2, -half - 0.01, -0.01), (0.2, half + 0.01, 0.0)),
        block((-0.2, -half - 0.01, 0.0), (0.2, -half, depth)),
        block((-0.2, half, 0.0), (0.2, half + 0.01, depth)),
    ]


def closed(pieces, joined, **options):
    return Openings([piece.faces for piece in pieces], **options).closed_by(joined.faces)


@pytest.mark.parametrize(("width", "kept"), [(0.010, False), (0.018, False), (0.030, True), (0.2, True)])
def test_a_channel_in_which_the_ball_has_room_is_not_filled(width, kept):
    pieces = channel(width)
    assert closed(pieces, around(pieces)[-1]) is kept


def test_a_larger_ball_lets_wider_openings_close():
    pieces = channel(0.05)
    assert closed(pieces, around(pieces)[-1])
    assert not closed(pieces, around(pieces)[-1], ball=0.09)


def test_a_thin_plate_across_an_opening_closes_it():
    assert closed(channel(0.06), block((-0.2, -0.03, 0.05), (0.2, 0.03, 0.051)))


@pytest.mark.parametrize("height", [0.40, 0.407, 0.413, 0.42])
def test_a_thin_plate_closes_an_opening_of_a_large_link_wherever_it_is(height):
    sides = [block((side * 0.4 - 0.01, -0.4, 0.0), (side * 0.4 + 0.01, 0.4, 1.5)) for side in (-1, 1)]
    assert closed(sides, block((-0.39, -0.4, height), (0.39, 0.4, height + 0.001)))


def test_walls_of_wide_openings_may_grow_a_little():
    assert not closed(channel(0.3, 0.2), block((-0.2, -0.15, 0.0), (0.2, 0.15, 0.002)))
    assert closed(channel(0.3, 0.2), block((-0.2, -0.15, 0.0), (0.2, 0.15, 0.02)))


def test_the_window_of_a_thin_frame_stays_open():
    """No ball rests on both sides of it: the ball goes through."""
    bars = [block((s * 0.15 - 0.005, -0.05, 0.0), (s * 0.15 + 0.005, 0.05, 0.012)) for s in (-1, 1)]
    bars += [block((-0.15, s * 0.05 - 0.005, 0.0), (0.15, s * 0.05 + 0.005, 0.012)) for s in (-1, 1)]
    assert closed(bars, around(bars)[-1])


def test_a_flat_recess_and_a_hollow_without_entrance_may_be_filled():
    recess = channel(0.3, 0.002)
    assert not closed(recess, around(recess)[-1])
    hollow = [block((-0.1, -0.1, side * 0.1 - 0.001), (0.1, 0.1, side * 0.1 + 0.001)) for side in (-1.0, 1.0)]
    hollow = [*hollow, *(Convex.hull(piece.faces.points[:, [2, 0, 1]]) for piece in hollow)]
    tube = list(hollow)
    hollow += [Convex.hull(piece.faces.points[:, [1, 2, 0]]) for piece in hollow[:2]]
    assert not closed(hollow, around(hollow)[0])
    assert closed(tube, around(tube)[0])


def test_two_boxes_become_a_box_and_two_cylinders_a_cylinder():
    (whole,) = around([block((0, 0, 0), (1, 1, 1)), block((1, 0, 0), (2, 1, 1))])
    assert (whole.kind, whole.size) == ("box", (2.0, 1.0, 1.0))
    upper, lower = np.eye(4), np.eye(4)
    upper[2, 3] = 0.1
    cylinder, hull = around([Convex.cylinder(0.02, 0.1, lower), Convex.cylinder(0.02, 0.1, upper)])
    assert cylinder.kind == "cylinder"
    assert cylinder.size == pytest.approx((0.02, 0.2), abs=3e-4)
    assert hull.kind == "hull"
    assert len(hull.points) <= 64


def test_joined_pieces_contain_their_pieces():
    rng = np.random.default_rng(1)
    for _ in range(20):
        pieces = [
            Convex.hull(rng.random((8, 3)) * (0.1, 0.02, 0.02) + rng.random(3) * 0.05) for _ in range(3)
        ]
        found = around(pieces)
        assert found[-1].volume >= max(piece.volume for piece in pieces)
        assert all(each.volume <= 1.05 * found[-1].volume for each in found)
        for each in found:
            assert all(each.outer_polytope(1e-6).contains(piece.points, 1e-6) for piece in pieces)
