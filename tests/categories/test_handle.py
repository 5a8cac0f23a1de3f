"""The category `handle`: every style is generated, moves freely, and is what the catalog promises."""

from itertools import combinations, product

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from manifold3d import Manifold, OpType

from artgen import Asset, ParameterError
from artgen.categories.handle import handle
from artgen.graph import Cache
from artgen.validate.colliders import check_colliders
from support.cases import some


def poses(asset: Asset, generator: np.random.Generator) -> list[dict[str, float]]:
    """Return the corners of the joint ranges and some poses between."""
    names = [joint.name for joint in asset.free_joints]
    limits = [joint.limits or (-1.0, 1.0) for joint in asset.free_joints]
    corners = [dict(zip(names, corner, strict=True)) for corner in product(*limits)]
    low, high = np.array(limits).T
    inside = [dict(zip(names, map(float, generator.uniform(low, high)), strict=True)) for _ in range(3)]
    return corners + inside


def assert_no_overlap(asset: Asset) -> None:
    solids = {
        link.name: Manifold.batch_boolean(
            [piece.shape.manifold for piece in link.pieces if not piece.visual], OpType.Add
        )
        for link in asset.links
    }
    for q in poses(asset, np.random.default_rng(0)):
        pose = asset.pose(q)
        placed = {name: solid.transform(pose[name][:3, :4]) for name, solid in solids.items()}
        for a, b in combinations(placed, 2):
            assert (placed[a] ^ placed[b]).volume() < 1e-13, (a, b, q)


STYLES = [
    *(("lever", style, lock) for style in ("straight", "bent", "wave") for lock in ("none", "turn", "push")),
    *(
        ("knob", style, lock)
        for style in ("ball", "flat", "tulip", "egg")
        for lock in ("none", "turn", "push")
    ),
]


@pytest.mark.parametrize(("kind", "style", "lock"), some(STYLES, 3))
def test_every_style_moves_freely(kind: str, style: str, lock: str) -> None:
    asset = handle.generate(3, kind=kind, lock=lock, cache=Cache(), **{f"handle.{kind}_handle.style": style})
    assert_no_overlap(asset)
    expected = ["base", "handle", "latch"] + (["lock"] if lock != "none" else [])
    assert sorted(link.name for link in asset.links) == sorted(expected)


@pytest.mark.parametrize("inside", ["lever", "knob"])
@pytest.mark.parametrize("lock", ["none", "turn", "push"])
def test_a_grip_set_has_a_thumb_piece_that_moves_with_the_handle_inside(inside: str, lock: str) -> None:
    asset = handle.generate(2, kind="grip_set", inside=inside, lock=lock, cache=Cache())
    assert_no_overlap(asset)
    limit = asset.joint("handle_turn").limits
    assert limit is not None
    at_end = asset.positions({"handle_turn": limit[1]})
    assert at_end["thumb_press"] == pytest.approx(0.28)
    # the grip is outside, at the front; lever or knob is inside, at the back
    assert asset.link("base").bounds()[0, 1] < -0.05
    assert asset.link("handle").bounds()[1, 1] > 0.05


@pytest.mark.parametrize("lock", ["turn", "push"])
def test_the_rim_of_a_small_flat_knob_is_rounded_less(lock: str) -> None:
    knob = {"handle.style": "flat", "handle.radius": 0.02, "handle.projection": 0.06}
    chosen = {"kind": "knob", "lock": lock, "rose_depth": 0.007, "thickness": 0.032}
    asset = handle.generate(3, certify=False, **chosen, **knob)
    assert not check_colliders(asset).faults, "its colliders stand off more of it than of a larger knob"


@settings(max_examples=12, deadline=None)
@given(seed=st.integers(0, 10_000))
@pytest.mark.long
def test_seeds_give_plausible_handles(seed: int) -> None:
    asset = handle.generate(seed)
    assert_no_overlap(asset)
    low = np.min([link.bounds()[0] for link in asset.links], axis=0)
    board = asset.link("base").bounds()
    assert low[2] == pytest.approx(0.0, abs=1e-9)
    assert board[0, 0] + board[1, 0] == pytest.approx(0.0, abs=0.001)
    assert all(len(link.colliders) <= 64 for link in asset.links)
    assert 1.5 < sum(link.mass_properties.mass for link in asset.links) < 9.0  # as for the survey
    turn = asset.joint("handle_turn")
    assert turn.limits is not None
    assert turn.limits[0] == 0.0
    assert 0.6 <= turn.limits[1] <= 0.9
    assert turn.rest < 0.0 < turn.stiffness
    assert asset.link("handle").grasps


def test_the_latch_is_drawn_into_the_leaf_by_the_handle() -> None:
    asset = handle.generate(0, kind="lever", hand="left", throw=0.012, turn=0.8, release=0.85)
    edge = asset.link("base").bounds()[1, 0] - 0.025  # the foot is 25 mm wider at either side
    assert asset.link("latch").bounds()[1, 0] == pytest.approx(edge + 0.012, abs=1e-6)
    moved = asset.pose({"handle_turn": 0.85 * 0.8})["latch"]
    assert moved[0, 3] == pytest.approx(-0.012)


def test_the_other_hand_is_the_mirror_image() -> None:
    left, right = (handle.generate(4, hand=hand) for hand in ("left", "right"))
    for a, b in zip(left.links, right.links, strict=True):
        flipped = a.bounds()[::-1, 0] * -1.0
        assert b.bounds()[:, 0] == pytest.approx(flipped, abs=1e-9)
        assert b.mass_properties.mass == pytest.approx(a.mass_properties.mass)
    grasp = right.link("handle").grasps[0]
    assert np.linalg.det(grasp.frame[:3, :3]) == pytest.approx(1.0)


def test_labels_are_the_same_for_every_seed_and_declared() -> None:
    declared = {handle.generate(seed).labels for seed in range(4)}
    assert len(declared) == 1
    assert {"handle", "latch", "lock", "rose", "door"} <= set(next(iter(declared)))


def test_the_same_seed_gives_the_same_asset() -> None:
    first, second = (handle.generate(9, cache=Cache()) for _ in range(2))
    assert first.parameters == second.parameters
    for a, b in zip(first.links, second.links, strict=True):
        for one, other in zip(a.surfaces, b.surfaces, strict=True):
            assert one.mesh.vertices.tobytes() == other.mesh.vertices.tobytes()
            assert one.mesh.triangles.tobytes() == other.mesh.triangles.tobytes()


def test_an_unknown_style_is_refused_with_the_styles_that_exist() -> None:
    with pytest.raises(ParameterError, match="grip_set"):
        handle.generate(0, kind="crank")
