"""The category `cabinet`: reveals, axes of hinges, hands, shelves."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from manifold3d import Manifold, OpType

from artgen import Asset, InfeasibleError
from artgen.categories.cabinet import cabinet
from artgen.graph import Cache
from artgen.validate.hands.motion import hand_forces


def solid(asset: Asset, link: str, *labels: str, **q: float) -> Manifold:
    """Return the solids of a link, of all or of some labels, where it stands at a pose."""
    pieces = [
        piece.shape.manifold
        for piece in asset.link(link).pieces
        if not piece.visual and (not labels or piece.label in labels)
    ]
    return Manifold.batch_boolean(pieces, OpType.Add).transform(asset.pose(q)[link][:3, :4])


@pytest.mark.parametrize("hinge", ["concealed", "butt"])
@pytest.mark.parametrize("kind", ["base", "wall", "tall"])
def test_a_pair_meets_with_a_reveal_of_3_mm(kind: str, hinge: str) -> None:
    asset = cabinet.generate(
        4, kind=kind, hinge=hinge, grip="bar", doors=2, on_collision="fail", cache=Cache()
    )
    left, right = solid(asset, "door_left", "door"), solid(asset, "door_right", "door")
    assert left.min_gap(right, 0.02) == pytest.approx(0.003, abs=1e-6)
    assert left.bounding_box()[3] == pytest.approx(-right.bounding_box()[0]), "they meet in the middle"


@pytest.mark.parametrize("seed", range(4))
def test_an_overlaid_door_turns_about_an_axis_within_its_thickness_and_keeps_off_the_carcass(
    seed: int,
) -> None:
    asset = cabinet.generate(seed, hinge="concealed", doors=1, certify=False, cache=Cache())
    joint, door = asset.joint("door_hinge"), solid(asset, "door", "door").bounding_box()
    assert door[1] < joint.pivot[1] < door[4]
    edge = door[0] if joint.axis[2] < 0.0 else door[3]
    assert abs(joint.pivot[0] - edge) < 0.006
    boards = solid(asset, "body", "body")
    for share in (0.0, 0.1, 0.2, 0.3, 0.5, 1.0):
        turned = solid(asset, "door", "door", door_hinge=share * joint.limits[1])
        assert turned.min_gap(boards, 0.01) > 0.0005


@pytest.mark.parametrize("seed", range(3))
def test_the_knuckles_of_butt_hinges_stand_about_the_axis(seed: int) -> None:
    asset = cabinet.generate(seed, hinge="butt", grip="knob", doors=1, certify=False, cache=Cache())
    joint = asset.joint("door_hinge")
    box = np.array(solid(asset, "door", "hinge").bounding_box()).reshape(2, 3)
    front = solid(asset, "door", "door").bounding_box()[1]
    assert box[0, 1] < joint.pivot[1] < front, "the pin is in front of the flush door"
    assert box[0, 0] < joint.pivot[0] < box[1, 0]
    body = solid(asset, "body", "body").bounding_box()[1]
    top = asset.parameters["top"]
    assert front == pytest.approx(body, abs=1e-6) or top == "worktop"


@pytest.mark.parametrize(("hand", "side"), [("left", -1.0), ("right", 1.0)])
def test_one_door_hangs_at_the_side_of_its_hand_and_opens_to_the_viewer(hand: str, side: float) -> None:
    asset = cabinet.generate(2, doors=1, hand=hand, certify=False, cache=Cache())
    joint = asset.joint("door_hinge")
    assert joint.pivot[0] * side > 0.0
    closed = solid(asset, "door").bounding_box()[1]
    assert solid(asset, "door", door_hinge=1.2).bounding_box()[1] < closed - 0.1


@pytest.mark.parametrize("shelves", [0, 1, 2, 3, 4, 5])
def test_it_has_as_many_shelves_as_asked_for(shelves: int) -> None:
    asset = cabinet.generate(6, kind="tall", shelves=shelves, certify=False, cache=Cache())
    found = [collider for collider in asset.link("body").colliders if collider.label == "shelf"]
    assert len(found) == shelves


def test_hands_open_doors_with_5_to_20_newtons_and_they_stay() -> None:
    for seed in range(4):
        asset = cabinet.generate(seed, certify=False, cache=Cache())
        for name, force in hand_forces(asset).items():
            assert 5.0 <= force <= 20.0
            joint = asset.joint(name)
            assert joint.stiffness == 0.0
            assert joint.axis[2] in (-1.0, 1.0), "gravity turns no upright axis"
            assert 1.6 <= joint.limits[1] <= 2.3


def test_a_door_between_the_sides_has_no_edge_pull() -> None:
    with pytest.raises(InfeasibleError, match="no free edge"):
        cabinet.generate(1, kind="base", grip="edge", hinge="butt")


@pytest.mark.parametrize(("doors", "longest"), [(1, 0.597), (2, 0.297)])
def test_an_edge_pull_is_no_longer_than_the_edge_of_its_door(doors: int, longest: float) -> None:
    options = {"kind": "base", "grip": "edge", "doors": doors, "width": 0.6}
    asset = cabinet.generate(1, **options, on_collision="fail", **{"handle.length": longest - 1e-6})
    assert asset.certificate is not None
    assert asset.certificate.proven
    with pytest.raises(InfeasibleError, match="the pull is longer than the edge of its door"):
        cabinet.generate(1, **options, attempts=1, **{"handle.length": longest + 0.001})


def test_the_corners_of_a_narrow_pair_between_the_sides_would_meet() -> None:
    options = {"kind": "base", "grip": "knob", "doors": 2, "thickness": 0.019, "door_thickness": 0.018}
    asset = cabinet.generate(1, **options, hinge="butt", width=0.46, on_collision="fail")
    assert asset.certificate is not None
    assert asset.certificate.proven
    with pytest.raises(InfeasibleError, match="free corners of two doors that open together would collide"):
        cabinet.generate(1, **options, hinge="butt", width=0.44, attempts=1)
    # those before the carcass turn about axes within their thickness
    assert cabinet.generate(1, **options, hinge="concealed", width=0.44).certificate.proven  # type: ignore[union-attr]


@pytest.mark.parametrize("style", ["shaker", "ramped", "fielded", "glazed"])
def test_the_frame_of_a_narrow_door_leaves_room_for_its_panel(style: str) -> None:
    options = {"kind": "base", "doors": 2, "width": 0.28, "hinge": "concealed", "grip": "knob"}
    asset = cabinet.generate(
        3, **options, style=style, rail=0.068, slope=0.026, moulding="ogee", on_collision="fail"
    )
    assert asset.certificate is not None
    assert asset.certificate.proven
    boxes = [
        piece.shape.bounds()[:, 0]
        for piece in asset.link("door_left").pieces
        if piece.label == "door" and not piece.visual
    ]
    assert min(high - low for low, high in boxes) == pytest.approx(0.27 * 0.137), "that of a stile"


@settings(max_examples=10, deadline=None)
@given(seed=st.integers(0, 10**6))
def test_any_seed_can_be_built_with_its_door_as_wide_as_its_carcass(seed: int) -> None:
    asset = cabinet.generate(seed, certify=False, cache=Cache())
    assert math.isclose(asset.bounds()[0, 2], 0.0, abs_tol=1e-9)
    assert sum(len(link.colliders) for link in asset.links) < 100
    doors = [link.name for link in asset.links[1:]]
    assert len(doors) == asset.parameters["doors"]


@pytest.mark.parametrize("hinge", ["concealed", "butt"])
def test_a_unit_with_rails_is_open_above_and_behind(hinge: str) -> None:
    size = {"width": 0.6, "depth": 0.56, "height": 0.86}
    values = {"kind": "base", "stand": "plinth", "top": "rails", "shelves": 0, "hinge": hinge, "grip": "bar"}
    asset = cabinet.generate(3, doors=2, **size, **values, cache=Cache())
    assert asset.certificate is not None
    assert asset.certificate.proven
    body = solid(asset, "body")
    sink = Manifold.cube((0.5, 0.46, 0.5), True).translate((0.0, -0.01, 0.70))
    pipe = Manifold.cube((0.05, 0.3, 0.05), True).translate((0.0, 0.2, 0.45))
    assert (body ^ (sink + pipe)).volume() == pytest.approx(0.0, abs=1e-12)
    low, high = asset.link("body").bounds()
    assert high[2] - low[2] == pytest.approx(0.86, abs=1e-6)
