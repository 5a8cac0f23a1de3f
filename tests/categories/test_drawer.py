"""The category `drawer`: runners, order and boards of drawers, and what grips them."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from artgen import Asset
from artgen.categories.drawer import drawer
from artgen.graph import Cache
from artgen.validate.hands import check_grasps

KINDS = ("chest", "bedside", "file", "kitchen")


def bounds(asset: Asset, link: str, *labels: str) -> np.ndarray:
    """Return the bounding box of the solids of a link that have some labels, shape (2, 3) [m]."""
    boxes = np.array(
        [p.shape.bounds() for p in asset.link(link).pieces if not p.visual and p.label in labels]
    )
    return np.array([boxes[:, 0].min(axis=0), boxes[:, 1].max(axis=0)])


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("mounting", ["overlay", "inset"])
def test_every_kind_is_certified_and_has_rows_by_columns_drawers(kind: str, mounting: str) -> None:
    asset = drawer.generate(3, kind=kind, mounting=mounting, grip="bar", on_collision="fail", cache=Cache())
    number = asset.parameters["rows"] * asset.parameters["columns"]
    assert [joint.name for joint in asset.joints] == [f"drawer_slide_{index}" for index in range(number)]


def test_drawers_are_counted_row_by_row_from_the_top_left() -> None:
    asset = drawer.generate(5, kind="chest", rows=4, columns=3, certify=False, cache=Cache())
    pivots = [asset.joint(f"drawer_slide_{index}").pivot for index in range(12)]
    order = sorted(range(12), key=lambda index: (-round(pivots[index][2], 4), pivots[index][0]))
    assert order == list(range(12))


@pytest.mark.parametrize("kind", KINDS)
def test_boxes_have_12_and_a_half_mm_of_side_play(kind: str) -> None:
    asset = drawer.generate(1, kind=kind, columns=1, certify=False, cache=Cache())
    inside = asset.parameters["width"] / 2.0 - asset.parameters["thickness"]
    low, high = bounds(asset, "drawer_0", "drawer")
    assert inside - high[0] == pytest.approx(0.0125, abs=1e-6)
    assert low[0] + inside == pytest.approx(0.0125, abs=1e-6)


@pytest.mark.parametrize("runner", ["roller", "ball"])
def test_the_members_of_runners_fill_the_play_but_for_2_mm(runner: str) -> None:
    asset = drawer.generate(0, kind="bedside", rows=1, runner=runner, certify=False, cache=Cache())
    moving, fixed = bounds(asset, "drawer_0", "runner"), bounds(asset, "body", "runner")
    side = asset.parameters["width"] / 2.0 - asset.parameters["thickness"]
    assert fixed[1, 0] == pytest.approx(side, abs=0.0005)
    play = side - moving[1, 0] - 0.0052
    assert play == pytest.approx(0.0021, abs=1e-4)


@settings(max_examples=12, deadline=None)
@given(seed=st.integers(0, 10**6))
def test_any_seed_can_be_built_within_the_budget_and_comes_out_by_three_quarters(seed: int) -> None:
    asset = drawer.generate(seed, certify=False, cache=Cache())
    assert sum(len(link.colliders) for link in asset.links) < 200
    for joint in asset.joints:
        low, high = bounds(asset, joint.child, "drawer")
        share = joint.limits[1] / (high - low)[1]
        assert 0.59 < share < 0.76
        assert joint.stiffness == 0.0
        assert 5.0 <= joint.friction <= 10.0
        boards = [p for p in asset.link(joint.child).pieces if p.label == "drawer" and not p.visual]
        assert len(boards) == 5, "front, bottom, back and two sides"


def test_a_groove_is_held_from_the_side_and_nothing_stands_out_of_the_front() -> None:
    asset = drawer.generate(2, kind="chest", columns=2, rows=3, grip="groove", certify=False, cache=Cache())
    for index in range(6):
        front, lip = bounds(asset, f"drawer_{index}", "front"), bounds(asset, f"drawer_{index}", "handle")
        assert lip[0, 1] == pytest.approx(front[0, 1])
        (grasp,) = asset.link(f"drawer_{index}").grasps
        outwards = 1.0 if index % 2 else -1.0
        assert grasp.frame[0, 2] == pytest.approx(-outwards), "hands come from beside the chest"
    assert check_grasps(asset).faults == ()


@pytest.mark.parametrize("rows", [2, 3, 4])
def test_drawers_for_files_are_0_28_to_0_32_m_high(rows: int) -> None:
    for seed in range(3):
        asset = drawer.generate(seed, kind="file", rows=rows, columns=1, certify=False, cache=Cache())
        for link in asset.links[1:]:
            low, high = bounds(asset, link.name, "front")
            assert 0.28 < (high - low)[2] < 0.345
        labels = {piece.label for piece in asset.link("drawer_0").pieces}
        assert "label_holder" in labels


def test_rows_of_a_chest_grow_downwards() -> None:
    asset = drawer.generate(8, kind="chest", rows=4, columns=1, growth=1.1, mounting="inset", certify=False)
    tall = [np.diff(bounds(asset, f"drawer_{index}", "front")[:, 2])[0] for index in range(4)]
    assert tall[1] / tall[0] > 1.0
    assert tall[3] / tall[2] == pytest.approx(1.1, abs=1e-6)
