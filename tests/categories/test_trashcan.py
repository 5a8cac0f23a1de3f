"""The category `trashcan`: levers, what lids let out, springs, and what each style has."""

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from manifold3d import Manifold, OpType

from artgen import Asset, InfeasibleError
from artgen.categories.trashcan import trashcan
from artgen.graph import Cache
from artgen.validate.hands.motion import hand_forces
from artgen.validate.solids import check_solids
from artgen.validate.tree import check_tree

STYLES = {
    "pedal": {"pedal_hinge", "rod_slide", "lid_hinge", "bucket_slide"},
    "lift": {"lid_hinge"},
    "swing": {"hood_lift", "lid_hinge"},
    "ball": {"hood_lift", "lid_hinge"},
    "disc": {"hood_lift", "lid_hinge"},
    "butterfly": {"lid_hinge_left", "lid_hinge_right", "bucket_slide"},
    "touch": {"button_slide", "lid_hinge", "bucket_slide"},
    "open": set(),
}


def solid(asset: Asset, link: str, **q: float) -> Manifold:
    """Return the solids of a link where it stands at a pose."""
    pieces = [piece.shape.manifold for piece in asset.link(link).pieces if not piece.visual]
    return Manifold.batch_boolean(pieces, OpType.Add).transform(asset.pose(q)[link][:3, :4])


@pytest.mark.parametrize("style", STYLES)
def test_every_style_has_its_joints_and_is_certified(style: str) -> None:
    asset = trashcan.generate(5, style=style, on_collision="fail", cache=Cache())
    names = {joint.name for joint in asset.joints}
    assert names >= STYLES[style]
    assert names, "an open bin has a ring or a liner that lifts out"
    size = asset.bounds()[1] - asset.bounds()[0]
    assert size.min() > 0.15
    assert size[:2].max() < 0.45
    assert size[2] < 0.82
    assert 0.4 < sum(link.mass_properties.mass for link in asset.links) < 8.0


@settings(max_examples=12, deadline=None)
@given(seed=st.integers(0, 10**6), style=st.sampled_from(sorted(STYLES)))
def test_any_seed_of_any_style_can_be_built(seed: int, style: str) -> None:
    asset = trashcan.generate(seed, style=style, certify=False, cache=Cache())
    assert {joint.name for joint in asset.joints} >= STYLES[style]
    assert sum(len(link.colliders) for link in asset.links) < 200


@pytest.mark.parametrize("seed", range(4))
def test_the_ratio_of_a_pedal_is_that_of_its_levers(seed: int) -> None:
    asset = trashcan.generate(seed, style="pedal", certify=False, cache=Cache())
    pedal, rod, lid = (asset.joint(name) for name in ("pedal_hinge", "rod_slide", "lid_hinge"))
    opening, angle = asset.parameters["lid_open"], pedal.limits[1]
    lift = 2.0 * asset.parameters["crank"] * math.sin(opening / 2.0)
    assert rod.limits[1] == pytest.approx(lift)
    assert lid.limits[1] == pytest.approx(opening)
    assert lid.follows.ratio == pytest.approx(opening / angle)
    rear = abs(float(rod.pivot[1] - pedal.pivot[1]))
    assert 2.0 * rear * math.sin(angle / 2.0) == pytest.approx(lift)


@pytest.mark.parametrize("seed", [0, 7])
def test_the_rod_stays_between_the_pedal_and_the_crank(seed: int) -> None:
    asset = trashcan.generate(seed, style="pedal", certify=False, cache=Cache())
    end = asset.joint("pedal_hinge").limits[1]
    for share in (0.0, 0.25, 0.5, 0.75, 1.0):
        q = {"pedal_hinge": share * end}
        rod = solid(asset, "rod", **q)
        for other in ("pedal", "lid"):
            gap = rod.min_gap(solid(asset, other, **q), 0.02)
            assert 0.0 < gap < 0.0025, f"the rod stands {1e3 * gap:.2g} mm off the {other} at {share:.0%}"


@pytest.mark.parametrize("seed", range(6))
def test_a_foot_opens_a_pedal_bin_with_15_to_60_newtons(seed: int) -> None:
    asset = trashcan.generate(seed, style="pedal", certify=False, cache=Cache())
    force = hand_forces(asset)["pedal_hinge"]
    assert 15.0 <= force <= 60.0
    pedal = asset.joint("pedal_hinge")
    assert pedal.stiffness * pedal.rest < 0.0, "a spring keeps the pedal up"


@pytest.mark.parametrize("style", ["pedal", "touch"])
def test_a_bucket_lifts_out_under_an_open_lid_only(style: str) -> None:
    asset = trashcan.generate(3, style=style, certify=False, cache=Cache())
    slide = asset.joint("bucket_slide")
    assert "lid_hinge" in slide.needs.condition.joints()
    assert slide.limits[1] > 0.18
    closed = solid(asset, "lid") ^ solid(asset, "bucket", bucket_slide=0.02)
    assert closed.volume() > 0.0, "the closed lid stands in its way"
    leader = asset.joint("lid_hinge").follows
    opened = {leader.leader: asset.joint(leader.leader).limits[1]} if leader else {"lid_hinge": 1.44}
    out = solid(asset, "bucket", bucket_slide=slide.limits[1], **opened)
    assert (solid(asset, "lid", **opened) ^ out).volume() == pytest.approx(0.0, abs=1e-12)


def test_a_touch_lid_needs_its_button_until_its_foot_has_passed() -> None:
    asset = trashcan.generate(1, style="touch", certify=False, cache=Cache())
    needs = asset.joint("lid_hinge").needs
    assert needs.condition.joints() == ("button_slide",)
    assert asset.joint("lid_hinge").stiffness > 0.0, "a spring opens it"
    held = solid(asset, "lid", lid_hinge=0.5 * needs.until) ^ solid(asset, "button")
    assert held.volume() > 0.0, "the bar of the button holds the foot"


@pytest.mark.parametrize(("style", "reach"), [("swing", 1.2), ("ball", 1.0), ("disc", 1.57)])
def test_lids_in_hoods_turn_both_ways(style: str, reach: float) -> None:
    asset = trashcan.generate(2, style=style, certify=False, cache=Cache())
    low, high = asset.joint("lid_hinge").limits
    assert low == -high
    assert 0.85 * reach < high <= reach
    assert asset.joint("lid_hinge").parent == "hood"
    assert (asset.joint("lid_hinge").stiffness > 0.0) == (style == "swing"), "a swing lid springs back"


def test_a_plan_that_a_lid_cannot_have_is_refused() -> None:
    with pytest.raises(
        InfeasibleError, match="plan=square is not allowed with style=ball: plan must be round"
    ):
        trashcan.generate(0, style="ball", plan="square", certify=False)


@pytest.mark.parametrize("width", [0.15, 0.2, 0.3])
def test_the_bar_of_a_ball_stands_on_it_however_round_that_is(width: float) -> None:
    asset = trashcan.generate(4, style="ball", width=width, certify=False, cache=Cache())
    assert len(solid(asset, "lid").decompose()) == 1, "the posts of its bar float above the ball"


@pytest.mark.parametrize("style", ["disc", "touch"])
def test_the_corners_of_a_narrow_bin_and_its_bucket_are_as_round_as_it_allows(style: str) -> None:
    chosen = {"style": style, "plan": "square", "width": 0.15, "corner": 0.06}
    assert trashcan.generate(4, aspect=0.9, on_collision="fail", cache=Cache(), **chosen)


def test_a_half_round_bin_with_a_bucket_is_refused_where_its_sides_leave_none() -> None:
    chosen = {"style": "touch", "plan": "half_round", "size": "small", "carry": "loop"}
    assert trashcan.generate(4, width=0.25, certify=False, cache=Cache(), **chosen)
    with pytest.raises(InfeasibleError, match=r"no room in a half-round bin: raise width or aspect"):
        trashcan.generate(4, width=0.15, attempts=1, certify=False, **chosen)


@pytest.mark.parametrize("style", ["ball", "disc", "open"])
def test_a_round_collar_is_refused_where_it_would_collide_as_too_many_pieces(style: str) -> None:
    chosen = {"style": style, "plan": "round", "carry": "none", "skin": "coated", "certify": False}
    assert trashcan.generate(4, width=0.42, cache=Cache(), **chosen)
    with pytest.raises(InfeasibleError, match=r"needs too many colliders: lower width"):
        trashcan.generate(4, width=0.45, attempts=1, **chosen)


@pytest.mark.parametrize(
    ("plan", "corner"), [("square", 0.008), ("square", 0.06), ("rectangle", 0.03), ("half_round", 0.03)]
)
def test_the_cushion_of_a_wide_lid_leans_no_farther_than_its_edges_can_round(
    plan: str, corner: float
) -> None:
    chosen = {"style": "lift", "lid_style": "domed", "carry": "none", "certify": False, "corner": corner}
    wide = trashcan.generate(4, plan=plan, width=0.45, aspect=1.3, cache=Cache(), **chosen)
    assert check_solids(wide).faults == ()


def test_the_bail_of_a_deep_half_round_bin_hangs_in_eyes_at_its_wall() -> None:
    chosen = {"style": "pedal", "plan": "half_round", "carry": "bail", "certify": False}
    for aspect in (0.9, 1.0, 1.3, 1.6):
        asset = trashcan.generate(4, aspect=aspect, cache=Cache(), **chosen)
        assert check_tree(asset).faults == (), f"an eye floats at aspect {aspect}"


@pytest.mark.parametrize("aspect", [0.9, 1.36])
def test_the_grips_of_a_narrow_butterfly_bin_stay_inside_its_frame_and_bucket(aspect: float) -> None:
    chosen = {"style": "butterfly", "plan": "rectangle", "width": 0.15, "aspect": aspect}
    for stepped_on in (False, True):
        assert trashcan.generate(4, stepped_on=stepped_on, on_collision="fail", cache=Cache(), **chosen)


@pytest.mark.parametrize("plan", ["square", "rectangle"])
def test_a_swing_lid_turns_in_the_opening_of_a_narrow_bin_with_round_corners(plan: str) -> None:
    chosen = {"style": "swing", "plan": plan, "width": 0.19, "corner": 0.06}
    assert trashcan.generate(4, on_collision="fail", cache=Cache(), **chosen)
