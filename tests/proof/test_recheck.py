"""The verification of a stored proof: it accepts what was proven, and nothing that was tampered with."""

import copy
import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import artgen as ag
import artgen.proof.recheck
from artgen.asset import Asset
from artgen.asset.certificate import Certificate
from artgen.catalog import find
from artgen.graph import evaluate
from artgen.proof.recheck import recheck, uncovered
from support.proof_assets import PROOF_ASSETS

Leaves = dict[str, Any]


@pytest.fixture(scope="module")
def door() -> Asset:
    asset = PROOF_ASSETS["bearing_door"]()
    asset.certify()
    return asset


def tampered(asset: Asset, change: Callable[[Leaves], None]) -> list[str]:
    """What the verification says of a proof that was changed."""
    certificate = asset.certificate
    assert certificate is not None
    leaves = copy.deepcopy(dict(certificate.leaves or {}))
    change(leaves)
    return [str(finding) for finding in recheck(asset, replace(certificate, leaves=leaves))]


@pytest.mark.parametrize("name", PROOF_ASSETS)
def test_what_was_proven_is_verified(name: str) -> None:
    asset = PROOF_ASSETS[name]()
    certificate = asset.certify(measure=True)
    assert recheck(asset, certificate) == []


@pytest.mark.parametrize(("category", "seed"), [("door", 3), ("handle", 5)])
def test_what_was_read_from_files_is_verified(category: str, seed: int, tmp_path: Path) -> None:
    asset = find(category).generate(seed)
    read = Asset.load(asset.export(tmp_path / "asset", formats=("urdf",)))
    assert read.certificate == asset.certificate or read.certificate is not None
    assert read.certificate is not None
    assert recheck(read, read.certificate) == []
    stored = json.loads((tmp_path / "asset" / "certificate.json").read_text())
    assert asset.certificate is not None
    assert stored == asset.certificate.leaves


def test_the_verification_uses_neither_fcl_nor_the_search() -> None:
    source = Path(artgen.proof.recheck.__file__).read_text(encoding="utf-8")
    assert "fcl" not in source.replace("FCL", "")
    for module in ("search", "separation", "kinematics", "hierarchy", "certify"):
        assert f"artgen.proof.{module} " not in source


def test_normals_are_rounded_which_counts_by_the_distance() -> None:
    post = ag.part(ag.box(0.05, 0.05, 0.9).at(0.0, 0.0, 0.45), "post", ag.material("oak"))
    far = ag.part(ag.box(0.05, 0.05, 0.9).at(2.8, 0.0, 0.45), "far", ag.material("oak"))
    made = evaluate(post.attach(far, ag.Prismatic("slide", axis=ag.Z, limits=(0.0, 0.1)))).value
    asset = Asset.from_tree(made, "toy", "test")
    certificate = asset.certify()
    (pair,) = certificate.pairs
    assert pair.guaranteed is not None
    for more, faults in ((0.0, 0), (2.5e-9, 0), (1e-8, 1)):
        claimed = replace(pair, guaranteed=pair.guaranteed + more)
        assert len(recheck(asset, replace(certificate, pairs=(claimed,)))) == faults


def test_a_missing_leaf_leaves_space_uncovered(door: Asset) -> None:
    for index in (0, 3, -1):
        found = tampered(door, lambda leaves, at=index: leaves["pairs"][0]["leaves"].pop(at))  # type: ignore[misc]
        assert len(found) == 1
        assert found[0].startswith("link frame, leaf: the proof does not cover all of the joint space (at ")


def test_a_turned_plane_is_refused(door: Asset) -> None:
    def turn(leaves: Leaves) -> None:
        row = next(row for row in leaves["pairs"][1]["leaves"] if row[4] >= 0)
        row[5:8] = [-value for value in row[5:8]]

    (found,) = tampered(door, turn)
    assert "a plane of the proof leaves a gap of -" in found
    assert found.endswith("; certify the asset again and export it")


def test_a_longer_normal_gains_nothing(door: Asset) -> None:
    def stretch(leaves: Leaves) -> None:
        for pair in leaves["pairs"]:
            for row in pair["leaves"]:
                row[5:8] = [1e6 * value for value in row[5:8]]

    assert tampered(door, stretch) == []  # the gap is measured along a unit normal


def test_a_plane_without_a_direction_is_refused() -> None:
    asset = PROOF_ASSETS["gasket_fridge"]()
    asset.certify()

    def flatten(leaves: Leaves) -> None:
        for row in leaves["pairs"][0]["leaves"]:
            row[5:8] = [0.0, 0.0, 0.0]

    (found,) = tampered(asset, flatten)
    assert "a plane of the proof leaves a gap of -inf mm" in found


def test_a_wider_cell_or_more_pieces_must_be_proven_too(door: Asset) -> None:
    def widen(leaves: Leaves) -> None:
        for row in leaves["pairs"][0]["leaves"]:
            row[8], row[9] = -0.5, 3.5

    def gather(leaves: Leaves) -> None:
        for row in leaves["pairs"][0]["leaves"]:
            row[0], row[1] = 0, len(leaves["pieces"][0]["frame"]["order"])

    assert any("a plane of the proof leaves a gap" in text for text in tampered(door, widen))
    assert any("a plane of the proof leaves a gap" in text for text in tampered(door, gather))


def test_an_axis_leaf_is_refused_where_joints_have_several_axes(door: Asset) -> None:
    def claim(leaves: Leaves) -> None:
        pair = next(each for each in leaves["pairs"] if each["links"] == ["frame", "handle"])
        pair["leaves"][0][4] = -2

    (found,) = tampered(door, claim)
    assert found.startswith("link frame, handle: a plane of the proof leaves a gap of -inf mm")


def test_a_missing_pair_a_wrong_order_and_a_damaged_file_are_named(door: Asset) -> None:
    assert tampered(door, lambda leaves: leaves["pairs"].pop(0)) == [
        "link frame, leaf: there is no proof of this pair; certify the asset again and export it"
    ]
    (found,) = tampered(door, lambda leaves: leaves["pieces"][0]["frame"].update(order=[0, 0]))
    assert "the order of the pieces of 'frame' is no permutation of its 62 pieces" in found
    (found,) = tampered(door, lambda leaves: leaves.update(format="other"))
    assert "the proof in certificate.json has format 'other' instead of 'artgen-certificate-1'" in found
    (found,) = tampered(door, lambda leaves: leaves["pairs"][2].pop("leaves"))
    assert "the proof in certificate.json is damaged (KeyError('leaves'))" in found
    certificate = door.certificate
    assert certificate is not None
    (finding,) = recheck(door, replace(certificate, leaves=None))
    assert finding.message == "the proof in certificate.json is missing"


def test_a_proof_holds_for_its_asset_only(door: Asset) -> None:
    certificate = door.certificate
    assert certificate is not None
    hinge = door.joint("hinge")
    assert hinge.limits is not None
    for changed, expected in (
        (replace(hinge, limits=(0.0, hinge.limits[1] + 0.01)), "does not cover all of the joint space"),
        (replace(hinge, pivot=hinge.pivot + (0.001, 0.0, 0.0)), "a plane of the proof leaves a gap of"),
    ):
        joints = tuple(changed if joint is hinge else joint for joint in door.joints)
        found = recheck(replace(door, joints=joints), certificate)
        assert any(expected in finding.message for finding in found), found


def test_a_pair_that_the_certificate_leaves_out_is_named(door: Asset) -> None:
    certificate = door.certificate
    assert certificate is not None
    shorter = Certificate(0.0, certificate.pairs[1:], (), certificate.leaves)
    (finding,) = recheck(door, shorter)
    assert finding.link == "frame, leaf"
    assert finding.message == "the certificate has no result for this pair, which can move"


@settings(max_examples=60, deadline=None)
@given(st.integers(0, 10**6))
def test_cells_that_tile_a_region_cover_it_and_without_one_they_do_not(seed: int) -> None:
    draw = np.random.default_rng(seed)
    dimensions = int(draw.integers(1, 5))
    region = np.sort(draw.normal(size=(dimensions, 2)), axis=1)
    if draw.random() < 0.3:
        region[0, 1] = region[0, 0]  # a joint that stands still
    cells = [region]
    for _ in range(int(draw.integers(0, 20))):
        cell = cells.pop(int(draw.integers(len(cells))))
        axis = int(draw.integers(dimensions))
        middle = draw.uniform(*cell[axis])
        lower, upper = cell.copy(), cell.copy()
        lower[axis, 1] = upper[axis, 0] = middle
        cells += [lower, upper]
    assert uncovered(np.array(cells), region) is None
    missing = int(draw.integers(len(cells)))
    rest = np.array(cells[:missing] + cells[missing + 1 :]).reshape(-1, dimensions, 2)
    gap = uncovered(rest, region)
    if (region[:, 0] < region[:, 1]).all():
        assert gap is not None
        assert (gap[:, 0] >= cells[missing][:, 0]).all()
        assert (gap[:, 1] <= cells[missing][:, 1]).all()
