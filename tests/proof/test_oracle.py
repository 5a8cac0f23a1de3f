"""The oracle by itself: it finds what is known to overlap, and draws poses that are allowed."""

import math

import numpy as np
import pytest
from manifold3d import Manifold

from artgen.asset import Asset
from support.brute import _motions, draw_poses, moving_pairs, overlaps
from support.proof_assets import PROOF_ASSETS, bearing_door, cooktop, fridge, gasket_fridge


@pytest.mark.parametrize("name", PROOF_ASSETS)
def test_drawn_poses_are_allowed_and_reach_all_of_joint_space(name: str) -> None:
    asset = PROOF_ASSETS[name]()
    poses = draw_poses(asset, 400, seed=3)
    for q in poses[:50]:
        assert not asset.blocked(q)
    for joint in asset.free_joints:
        low, high = joint.limits or (-math.pi, math.pi)
        reached = np.array([q[joint.name] for q in poses])
        assert reached.min() == pytest.approx(low, abs=0.02 * (high - low))
        assert reached.max() == pytest.approx(high, abs=0.02 * (high - low))
        middle = (reached > low + 0.1 * (high - low)) & (reached < high - 0.1 * (high - low))
        assert middle.mean() > 0.05


@pytest.mark.parametrize("name", PROOF_ASSETS)
def test_its_motions_are_those_of_the_asset(name: str) -> None:
    asset = PROOF_ASSETS[name]()
    poses = draw_poses(asset, 10, seed=4)
    motions = _motions(asset, poses)
    for index, q in enumerate(poses):
        for link, matrix in asset.pose(q).items():
            np.testing.assert_allclose(motions[link][index], matrix, atol=1e-12)


def plain_overlaps(asset: Asset, q: dict[str, float]) -> dict[tuple[str, str], float]:
    """The same by plain booleans of all pieces."""
    pose = asset.pose(q)
    solids = {}
    for link in asset.links:
        pieces = [piece.shape.manifold for piece in link.pieces if not piece.visual]
        whole = sum(pieces[1:], pieces[0])
        solids[link.name] = whole.transform(np.ascontiguousarray(pose[link.name][:3]))
    found = {pair: (solids[pair[0]] ^ solids[pair[1]]).volume() for pair in moving_pairs(asset)}
    return {pair: volume for pair, volume in found.items() if volume > 1e-12}


@pytest.mark.parametrize(
    "asset",
    [
        bearing_door(pivot=(-0.004, 0.0, 0.0)),
        bearing_door(rule=False, limit=1.8),
        fridge(wide=0.0055, rule=False),
        cooktop(pivot=(0.0008, 0.0, 0.0)),
    ],
    ids=lambda asset: asset.name,
)
def test_it_finds_the_volumes_that_plain_booleans_find(asset: Asset) -> None:
    poses = draw_poses(asset, 25, seed=5)
    found: list[dict[tuple[str, str], float]] = [{} for _ in poses]
    for index, a, b, volume in overlaps(asset, poses):
        found[index][a, b] = volume
    assert any(found)
    for index, q in enumerate(poses):
        assert found[index] == pytest.approx(plain_overlaps(asset, q), rel=1e-6, abs=1e-15)


def test_it_stops_after_as_many_overlaps_as_are_asked_for() -> None:
    asset = fridge(wide=0.0055)
    assert len(overlaps(asset, draw_poses(asset, 20), most=3)) == 3


def test_a_contact_is_allowed_to_its_depth_where_it_was_declared() -> None:
    closed, ajar = {"hinge": 0.0}, {"hinge": 0.004}
    assert overlaps(gasket_fridge(), [closed, ajar]) == []
    (found,) = overlaps(gasket_fridge(depth=0.0009), [closed])
    ring = 2 * 0.01 * (0.44 + 0.79 - 2 * 0.01)  # of the gasket, 10 mm are on the front of the walls [m^2]
    assert found[1:3] == ("body", "door")
    assert found[3] == pytest.approx(0.001 * ring, rel=1e-6)


@pytest.mark.long
def test_every_asset_is_free_of_overlaps_and_its_solids_are_solids() -> None:
    for make in PROOF_ASSETS.values():
        asset = make()
        assert overlaps(asset, draw_poses(asset, 60, seed=6)) == []
        for link in asset.links:
            assert all(isinstance(piece.shape.manifold, Manifold) for piece in link.pieces)
            assert 0 < len(link.colliders) <= 64
