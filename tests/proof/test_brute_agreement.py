"""The certificate against exact booleans at many poses: of every category, and of assets made for it.

`ARTGEN_TEST_SEEDS=200 ARTGEN_TEST_POSES=1000 pytest tests/proof/test_brute_agreement.py` is the long form.
"""

import os
from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache

import numpy as np
import pytest
from manifold3d import Manifold

from artgen.asset import Asset
from artgen.asset.certificate import Certificate, PairResult
from artgen.catalog import categories, find
from support.brute import draw_poses, moving_pairs, overlaps
from support.cases import some
from support.geometry import polytope
from support.proof_assets import (
    PROOF_ASSETS,
    bearing_door,
    cooktop,
    dishwasher,
    french_fridge,
    fridge,
    gasket_fridge,
    lamp,
    sliding_gate,
    threaded_cap,
    trash_can,
)

SEEDS = range(int(os.environ.get("ARTGEN_TEST_SEEDS", "1")))
POSES = int(os.environ.get("ARTGEN_TEST_POSES", "100"))
PLAIN = 1e-8
"""Volume of an overlap that no proof may leave undecided [m^3]: a cube of 2 mm."""


@lru_cache(maxsize=2)
def certified(category: str, seed: int) -> tuple[Asset, Certificate]:
    asset = find(category).generate(seed, certify=False)
    return asset, asset.certify()


def check_agreement(asset: Asset, certificate: Certificate, poses: int) -> None:
    """Assert that no proven pair overlaps at any of a number of poses, and that every witness does."""
    check_every_pair_is_judged(asset, certificate)
    proven = [pair.links for pair in certificate.pairs if pair.verdict == "proven"]
    drawn = draw_poses(asset, poses, seed=11)
    for pair in certificate.pairs:  # and where the proof found the pieces nearest
        if pair.found is not None:
            drawn.append(asset_pose(asset, pair.found_at))
    found = overlaps(asset, drawn, pairs=proven)
    assert not found, f"{asset.name}: {found[0][1:]} is proven, at {drawn[found[0][0]]}"
    for pair in certificate.pairs:
        if pair.witness is not None:
            check_witness(asset, pair)


def asset_pose(asset: Asset, pose: dict[str, float]) -> dict[str, float]:
    """Complete a pose of some joints so that nothing forbids it where that can be."""
    q = dict(pose)
    for candidate in draw_poses(asset, 200, seed=12):
        if not asset.blocked(q):
            break
        q = candidate | dict(pose)
    return q


def check_every_pair_is_judged(asset: Asset, certificate: Certificate) -> None:
    judged = [frozenset(pair.links) for pair in certificate.pairs]
    assert len(set(judged)) == len(judged)
    assert set(judged) == {frozenset(pair) for pair in moving_pairs(asset)}


def check_witness(asset: Asset, pair: PairResult) -> None:
    """Assert that what is said of a collision is so: pose, first contact, volume, place."""
    witness = pair.witness
    assert witness is not None
    assert set(pair.joints) == set(witness.pose)
    q = asset_pose(asset, dict(witness.pose))
    assert not asset.blocked(q), f"{asset.name}: a dependency forbids {q}"
    if pair.verdict != "collision":
        assert pair.colliders == "collision"
        assert collider_volume(asset, pair, q) > 0.0
        assert not overlaps(asset, [q], pairs=[pair.links])
        return
    found = overlaps(asset, [q], pairs=[pair.links], least=0.0)
    assert found, f"{asset.name}: {pair.links} do not overlap at {q}"
    if not asset.contacts:  # the certificate counts two pieces, the oracle what is not allowed of two links
        assert witness.volume == pytest.approx(found[0][3], rel=1e-3, abs=1e-13)
    assert witness.depth > 0.0
    low, high = (np.array(corner) for corner in posed_bounds(asset, pair, q))
    assert (low - 1e-6 <= witness.place).all()
    assert (witness.place <= high + 1e-6).all()
    check_first_contact(asset, pair)


def check_first_contact(asset: Asset, pair: PairResult) -> None:
    """Assert that links are apart on the way to their first contact, which lies before the witness."""
    witness = pair.witness
    assert witness is not None
    rest = {name: asset.joint(name).closed for name in witness.pose}
    way = np.array([witness.pose[name] - rest[name] for name in rest])
    part = np.array([witness.first_contact[name] - rest[name] for name in rest])
    share = float(part @ way / (way @ way)) if way.any() else 0.0
    np.testing.assert_allclose(part, share * way, atol=1e-6)
    assert -1e-9 <= share <= 1.0 + 1e-9
    for fraction in (0.0, 0.3, 0.7, 0.95):
        q = {
            name: rest[name] + fraction * share * step for name, step in zip(rest, way.tolist(), strict=True)
        }
        if share > 0.0 and not asset.blocked(q):
            assert not overlaps(asset, [q], pairs=[pair.links]), f"{pair.links} overlap at {q} already"


def posed_bounds(asset: Asset, pair: PairResult, q: dict[str, float]) -> tuple[np.ndarray, np.ndarray]:
    """Corners of the box that the boxes of both links share."""
    boxes = []
    for name in pair.links:
        points = np.concatenate([surface.mesh.vertices for surface in asset.link(name).surfaces])
        matrix = asset.pose(q)[name]
        moved = points @ matrix[:3, :3].T + matrix[:3, 3]
        boxes.append((moved.min(axis=0), moved.max(axis=0)))
    return np.maximum(boxes[0][0], boxes[1][0]), np.minimum(boxes[0][1], boxes[1][1])


def collider_volume(asset: Asset, pair: PairResult, q: dict[str, float]) -> float:
    """Largest volume that two colliders of the links share [m^3]."""
    pose = asset.pose(q)
    first, second = (
        [
            Manifold.hull_points(polytope(collider.convex)).transform(np.ascontiguousarray(pose[name][:3]))
            for collider in asset.link(name).colliders
        ]
        for name in pair.links
    )
    return max((a ^ b).volume() for a in first for b in second)


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("category", some(categories(), 10, 2))
def test_what_is_proven_of_a_category_is_so(category: str, seed: int) -> None:
    asset, certificate = certified(category, seed)
    assert certificate.proven, str(certificate)
    check_agreement(asset, certificate, POSES)


@pytest.mark.parametrize("name", some(PROOF_ASSETS, 3))
def test_assets_without_a_fault_are_proven(name: str) -> None:
    asset = PROOF_ASSETS[name]()
    certificate = asset.certify(measure=True)
    assert certificate.proven, str(certificate)
    check_agreement(asset, certificate, POSES)
    for pair in certificate.pairs:
        assert pair.guaranteed is not None
        assert pair.found is None or pair.guaranteed <= pair.found + 1e-9


FAULTS: dict[str, Callable[[], Asset]] = {
    "door, pivot": lambda: bearing_door(pivot=(-0.004, 0.0, 0.0)),
    "door, half a millimetre": lambda: bearing_door(pivot=(-0.0005, 0.0, 0.0)),
    "door, pins": lambda: bearing_door(wide=0.0005),
    "door, limit": lambda: bearing_door(limit=1.9),
    "door, bolt": lambda: bearing_door(ratio=0.7),
    "door, no latch": lambda: bearing_door(rule=False),
    "fridge, pivot": lambda: fridge(pivot=(0.012, 0.0, 0.0)),
    "fridge, crispers": lambda: fridge(wide=0.0055),
    "fridge, limit": lambda: fridge(limit=1.7),
    "fridge, no rule": lambda: fridge(rule=False),
    "gasket, allowance": lambda: gasket_fridge(depth=0.0008),
    "gasket, pressed": lambda: gasket_fridge(press=0.0013),
    "french, crispers": lambda: french_fridge(wide=0.0055),
    "french, no rule": lambda: french_fridge(rule=False),
    "french, pivot": lambda: french_fridge(pivot=(0.004, 0.0, 0.0)),
    "lamp, arm": lambda: lamp(wide=0.005),
    "lamp, limits": lambda: lamp(limit=1.6),
    "dishwasher, rack": lambda: dishwasher(wide=0.0065),
    "dishwasher, no rule": lambda: dishwasher(rule=False),
    "cooktop, posts": lambda: cooktop(wide=0.0015),
    "cooktop, axes": lambda: cooktop(pivot=(0.0008, 0.0, 0.0)),
    "can, collar": lambda: trash_can(wide=0.02),
    "can, pedal": lambda: trash_can(limit=1.9),
    "gate, runners": lambda: sliding_gate(wide=0.0012),
    "gate, out of line": lambda: sliding_gate(tilt=0.001),
    "cap, lugs": lambda: threaded_cap(wide=0.0015),
    "cap, pitch": lambda: threaded_cap(pitch=1.25),
    "cap, left-hand thread": lambda: threaded_cap(sense=-1.0),
}


@pytest.mark.parametrize("fault", some(FAULTS, 4))
def test_every_fault_is_found_in_the_pairs_that_overlap_and_every_witness_is_true(fault: str) -> None:
    asset = FAULTS[fault]()
    certificate = asset.certify()
    assert not certificate.proven
    poses = draw_poses(asset, 4 * POSES, seed=13)
    found = {frozenset(pair) for _, *pair, _ in overlaps(asset, poses, least=PLAIN, once=True)}
    collides = {frozenset(pair.links) for pair in certificate.pairs if pair.verdict == "collision"}
    assert found <= collides, str(certificate)
    check_agreement(asset, certificate, POSES)


def test_a_false_proof_and_a_false_witness_are_noticed() -> None:
    asset = bearing_door(pivot=(-0.004, 0.0, 0.0))
    certificate = asset.certify()
    (failed,) = certificate.failures
    assert failed.witness is not None
    lie = replace(failed, verdict="proven", colliders="proven", witness=None)
    with pytest.raises(AssertionError, match="is proven"):
        check_agreement(asset, replace(certificate, pairs=(lie,) + other_pairs(certificate, failed)), POSES)
    clear = {"hinge": 0.0}
    lie = replace(failed, witness=replace(failed.witness, pose=clear, first_contact=clear))
    with pytest.raises(AssertionError, match="do not overlap"):
        check_agreement(asset, replace(certificate, pairs=(lie,) + other_pairs(certificate, failed)), POSES)


def other_pairs(certificate: Certificate, pair: PairResult) -> tuple[PairResult, ...]:
    return tuple(other for other in certificate.pairs if other is not pair)
