"""The category `faucet`: what turns, lifts and slides in each style, and what brings it back."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from artgen import Asset
from artgen.categories.faucet import faucet
from artgen.errors import ArtgenError
from artgen.graph import Cache

_MIXER = {"spout_swivel", "handle_turn", "handle_lift"}
_TWO = {"spout_swivel", "handle_turn_left", "handle_turn_right"}
STYLES = {
    "widespread": _TWO,
    "bridge": _TWO,
    "wall": _TWO,
    "single_hole": _MIXER,
    "vessel": _MIXER,
    "gooseneck": _MIXER,
    "pull_down": _MIXER | {"spray_head_slide"},
}


def made(seed: int, **overrides: object) -> Asset:
    return faucet.generate(seed, cache=Cache(), certify=False, **overrides)


def grasped(asset: Asset, link: str, **q: float) -> np.ndarray:
    """Return where the first grasp of a link is at a pose, shape (3,) [m]."""
    pose = asset.pose(q)[link]
    return pose[:3, :3] @ asset.link(link).grasps[0].frame[:3, 3] + pose[:3, 3]


@pytest.mark.parametrize("style", STYLES)
def test_every_style_has_its_joints_and_is_certified(style: str) -> None:
    asset = faucet.generate(5, cache=Cache(), on_collision="fail", style=style, **_rodless(style))
    assert {joint.name for joint in asset.joints} == STYLES[style]
    assert asset.certificate is not None
    assert asset.certificate.proven


@pytest.mark.parametrize("spout", ["low", "gooseneck"])
def test_on_the_wall_of_a_room_it_has_no_board(spout: str) -> None:
    given = {"style": "wall", "spout": spout}
    shown, hung = (faucet.generate(5, cache=Cache(), stand=stand, **given) for stand in ("board", "none"))
    assert [each.name for each in hung.links] == [each.name for each in shown.links]
    assert hung.certificate is not None
    assert hung.certificate.proven
    assert hung.bounds()[1, 1] < 0.001 < shown.bounds()[1, 1]
    with pytest.raises(ArtgenError, match="stand=none is for style=wall, in a room"):
        made(1, style="bridge", stand="none")


def _rodless(style: str) -> dict[str, object]:
    return {"rod": False} if style in ("widespread", "single_hole") else {}


@pytest.mark.parametrize(
    ("style", "axis"), [("single_hole", (0, 0, 1)), ("vessel", (0, 0, 1)), ("gooseneck", (1, 0, 0))]
)
def test_a_single_lever_has_two_joints_on_one_pair_of_links(style: str, axis: tuple[int, int, int]) -> None:
    asset = made(3, style=style, side="right")
    turn, lift = asset.joint("handle_turn"), asset.joint("handle_lift")
    assert (turn.parent, turn.child) == (lift.parent, lift.child) == ("deck", "handle")
    assert turn.limits == pytest.approx((-0.9, 0.9))
    assert lift.limits == pytest.approx((0.0, asset.parameters["lift"]))
    np.testing.assert_allclose(turn.axis, axis, atol=1e-9)
    assert turn.axis @ lift.axis == pytest.approx(0.0, abs=1e-9)
    # lifted, the lever goes away from its seat, along the axis of the turn
    moved = grasped(asset, "handle", handle_lift=lift.limits[1]) - grasped(asset, "handle")
    assert moved @ turn.axis > 0.02


def test_levers_of_hot_and_cold_come_to_the_front_as_they_open() -> None:
    asset = made(1, style="widespread", handle="lever")
    for which, side in (("left", -1), ("right", 1)):
        name, turn = f"handle_{which}", f"handle_turn_{which}"
        shut, opened = grasped(asset, name), grasped(asset, name, **{turn: 1.57})
        pivot = asset.joint(turn).pivot
        assert side * (shut - pivot)[0] > 0.03
        assert (opened - pivot)[1] < -0.03
        assert abs((opened - pivot)[0]) < 0.002


@pytest.mark.parametrize("style", STYLES)
def test_a_spout_turns_about_its_foot_at_its_reach(style: str) -> None:
    asset = made(2, style=style)
    swivel = asset.joint("spout_swivel")
    assert 1.57 <= swivel.limits[1] <= math.pi
    assert swivel.limits[0] == pytest.approx(-swivel.limits[1])
    np.testing.assert_allclose(swivel.axis, (0.0, 0.0, 1.0), atol=1e-9)
    low = asset.link("spout").bounds()[0]
    assert swivel.pivot[1] - low[1] == pytest.approx(asset.parameters["reach"], abs=0.02)


@pytest.mark.parametrize("seed", range(4))
def test_a_spray_head_is_drawn_back_and_its_hose_stays_in_the_spout(seed: int) -> None:
    asset = made(seed, style="pull_down")
    slide, head = asset.joint("spray_head_slide"), asset.link("spray_head")
    weight = 9.81 * head.mass_properties.mass
    assert -slide.stiffness * slide.rest > weight + slide.friction  # even where the spring is weakest
    travel = slide.limits[1]
    hose = max(piece.shape.bounds()[1, 2] for piece in head.pieces if piece.label == "hose")
    grip = max(piece.shape.bounds()[1, 2] for piece in head.pieces if piece.label == "spray_head")
    assert hose - travel > grip + 0.005
    assert grip - travel - 0.09 > 0.0  # it hangs over the floor


@pytest.mark.parametrize("style", ["widespread", "single_hole"])
def test_the_rod_of_a_drain_stays_where_it_is_put(style: str) -> None:
    asset = faucet.generate(6, cache=Cache(), on_collision="fail", style=style, rod=True)
    rod = asset.joint("lift_rod_slide")
    assert rod.friction > 9.81 * asset.link("lift_rod").mass_properties.mass
    under = asset.link("spout").bounds()[0, 2]
    solids = [piece.shape.bounds() for piece in asset.link("lift_rod").pieces if piece.label == "lift_rod"]
    assert min(low[2] for low, _ in solids) + rod.limits[1] < under  # lifted, it is still in its collar
    assert asset.link("lift_rod").bounds()[0, 2] > 0.02


def _middle(asset: Asset, link: str, label: str, q: dict[str, float]) -> np.ndarray:
    """Return the middle of what has a label at a pose, shape (3,) [m]."""
    boxes = [piece.shape.bounds() for piece in asset.link(link).pieces if piece.label == label]
    middle = np.append(np.mean([np.min(boxes, axis=(0, 1)), np.max(boxes, axis=(0, 1))], axis=0), 1.0)
    return (asset.pose(q)[link] @ middle)[:3]


@pytest.mark.parametrize("style", ["widespread", "single_hole"])
def test_a_lifted_rod_lowers_the_plug_by_the_arms_of_the_pivot_rod(style: str) -> None:
    asset = made(4, style=style, rod=True)
    lift, turn, fall = (asset.joint(f"{name}") for name in ("lift_rod_slide", "pivot_rod_turn", "plug_slide"))
    shut = {"lift_rod_slide": lift.limits[1]}
    assert turn.follows is not None
    assert fall.follows is not None
    assert turn.follows.leader == fall.follows.leader == "lift_rod_slide"
    # the inner arm reaches from the ball to the middle of the drain, the outer one to the strap
    inner = abs(turn.pivot[1] + asset.parameters["reach"])
    assert fall.follows.ratio == pytest.approx(inner * turn.follows.ratio)
    down = _middle(asset, "plug", "plug", {}) - _middle(asset, "plug", "plug", shut)
    np.testing.assert_allclose(down, (0.0, 0.0, fall.follows.ratio * lift.limits[1]), atol=1e-9)
    assert 0.005 < down[2] < 0.012
    up = _middle(asset, "lift_rod", "strap", shut) - _middle(asset, "lift_rod", "strap", {})
    np.testing.assert_allclose(up, (0.0, 0.0, lift.limits[1]), atol=1e-9)
    # the plug stands under the end of the spout, and comes down on its seat without touching it
    assert _middle(asset, "plug", "plug", {})[1] == pytest.approx(-asset.parameters["reach"], abs=1e-6)
    for share in (0.0, 0.5, 1.0):
        assert min(asset.clearance({"lift_rod_slide": share * lift.limits[1]}).values()) > 0.0


@settings(max_examples=10, deadline=None)
@given(seed=st.integers(0, 10_000), style=st.sampled_from(sorted(STYLES)))
def test_any_seed_of_any_style_can_be_built_within_the_budget(seed: int, style: str) -> None:
    asset = made(seed, style=style)
    counts = [len(link.colliders) for link in asset.links]
    assert max(counts) <= 64
    assert sum(counts) < 200
    assert {joint.name for joint in asset.joints} - {
        "lift_rod_slide",
        "pivot_rod_turn",
        "plug_slide",
    } == STYLES[style]
