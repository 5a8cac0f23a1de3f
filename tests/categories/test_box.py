"""The category `box`: what each construction has, in which order it closes, and how its creases resist."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from manifold3d import Manifold, OpType

from artgen import Asset
from artgen.categories.box import box
from artgen.categories.box.board import LAYER, THICK
from artgen.errors import InfeasibleError
from artgen.graph import Cache
from artgen.validate.hands.motion import hand_forces

MAJOR = {"flap_front_hinge", "flap_back_hinge"}
MINOR = {"flap_left_hinge", "flap_right_hinge"}
STYLES = {
    "slotted": set[str](),
    "half_slotted": MAJOR | MINOR | {"sleeve_lift"},
    "mailer": {"lid_hinge", "tuck_front_hinge"},
    "pizza": {"lid_hinge", "tuck_front_hinge", "tuck_left_hinge", "tuck_right_hinge"},
    "tuck_end": {"lid_hinge_left", "lid_hinge_right", "tuck_lower_hinge_left", "tuck_lower_hinge_right"},
    "wine": set[str](),
    "tray": {"lid_lift"},
    "gift": set[str](),
}


def made(seed: int, **chosen: object) -> Asset:
    return box.generate(seed, certify=False, cache=Cache(), **chosen)


def solid(asset: Asset, link: str, **q: float) -> Manifold:
    """Return the solids of a link where it stands at a pose."""
    pieces = [piece.shape.manifold for piece in asset.link(link).pieces if not piece.visual]
    return Manifold.batch_boolean(pieces, OpType.Add).transform(asset.pose(q)[link][:3, :4])


def touch(asset: Asset, a: str, b: str, **q: float) -> bool:
    return not (solid(asset, a, **q) ^ solid(asset, b, **q)).is_empty()


@pytest.mark.parametrize("style", STYLES)
def test_every_construction_has_its_joints_and_is_certified(style: str) -> None:
    asset = box.generate(11, style=style, on_collision="fail", cache=Cache())
    names = {joint.name for joint in asset.joints}
    assert names >= STYLES[style]
    assert names


@settings(max_examples=12, deadline=None)
@given(seed=st.integers(0, 10**6), style=st.sampled_from(sorted(STYLES)))
@pytest.mark.long
def test_any_seed_of_any_construction_can_be_built(seed: int, style: str) -> None:
    asset = made(seed, style=style)
    assert {joint.name for joint in asset.joints} >= STYLES[style]
    assert sum(len(link.colliders) for link in asset.links) < 200
    assert all(force < 60.0 for force in hand_forces(asset).values())


@pytest.mark.parametrize("flute", ["b", "c", "eb", "bc"])
def test_closed_flaps_lie_on_each_other_a_board_and_a_hair_apart(flute: str) -> None:
    asset = made(3, style="slotted", mouth="top", flute=flute)
    thick = THICK[flute]  # type: ignore[index]
    heights = {}
    for side in ("front", "back", "left", "right"):
        sheet = next(piece for piece in asset.link(f"flap_{side}").pieces if piece.label.startswith("flap"))
        low, high = sheet.shape.bounds()[:, 2]
        assert high - low == pytest.approx(thick, abs=1e-6), "it lies flat"
        heights[side] = low
    assert heights["front"] == pytest.approx(heights["back"])
    assert heights["front"] - heights["left"] == pytest.approx(thick + LAYER, abs=1e-6)
    assert heights["left"] == pytest.approx(heights["right"])


def test_minor_flaps_fold_in_before_major_ones_and_hang_down_when_they_are_free() -> None:
    asset = made(3, style="slotted", mouth="top", swing=4.4)
    assert asset.blocked({"flap_left_hinge": 0.8}) == ("flap_left_hinge",)
    assert touch(asset, "flap_left", "flap_front", flap_left_hinge=0.8)
    wide = {"flap_front_hinge": 2.0, "flap_back_hinge": 2.0}
    assert asset.blocked({**wide, "flap_left_hinge": 0.8}) == ()
    assert asset.blocked({"flap_front_hinge": 2.0, "flap_left_hinge": 0.8}) == ("flap_left_hinge",)
    hanging = asset.joint("flap_left_hinge").limits[1]
    assert hanging > 3.4
    assert asset.blocked({"flap_left_hinge": hanging}) == ()
    assert not touch(asset, "flap_left", "flap_front", flap_left_hinge=hanging)


@pytest.mark.parametrize("end", ["left", "right"])
def test_flaps_at_the_ends_of_a_lying_box_open_in_order_too(end: str) -> None:
    asset = box.generate(3, style="slotted", mouth="ends", on_collision="fail", cache=Cache())
    sides = {"upper", "lower", "front", "back"}
    hinges = {side: f"flap_{side}_hinge_{end}" for side in sides}
    names = {joint.name for joint in asset.joints}
    assert len(names) == 8
    assert names >= set(hinges.values())
    assert asset.blocked({hinges["front"]: 0.8}) == (hinges["front"],)
    assert touch(asset, f"flap_front_{end}", f"flap_upper_{end}", **{hinges["front"]: 0.8})
    down = asset.joint(hinges["lower"]).limits[1]
    wide = {hinges["upper"]: 2.0, hinges["lower"]: down}
    assert asset.blocked({hinges["upper"]: 2.0, hinges["front"]: 0.8}) == (hinges["front"],)
    assert asset.blocked({**wide, hinges["front"]: 0.8, hinges["back"]: 0.8}) == ()
    # the majors are on the long creases, the minors do not meet between them
    assert asset.joint(hinges["upper"]).axis[2] == pytest.approx(0.0)
    assert abs(asset.joint(hinges["front"]).axis[2]) == pytest.approx(1.0)


@pytest.mark.parametrize("seed", range(3))
def test_the_lower_flap_of_a_lying_box_comes_to_lie_on_the_floor(seed: int) -> None:
    asset = made(seed, style="slotted", mouth="ends")
    for end in ("left", "right"):
        hinge = asset.joint(f"flap_lower_hinge_{end}")
        assert math.radians(65.0) < hinge.limits[1] < math.radians(90.0)
        for angle in np.linspace(*hinge.limits, 9).tolist():
            low = solid(asset, f"flap_lower_{end}", **{hinge.name: angle}).bounding_box()[2]
            assert low > -1e-6, "never below the floor"
        assert low < 0.003


@pytest.mark.parametrize(("more", "hinges"), [((), 8), (("ears",), 12), (("ears", "lips"), 16)])
def test_a_carton_with_tucked_ends_has_up_to_sixteen_hinges(more: tuple[str, ...], hinges: int) -> None:
    chosen = {name: name in more for name in ("ears", "lips")}
    asset = box.generate(5, style="tuck_end", on_collision="fail", cache=Cache(), **chosen)
    assert len(asset.joints) == hinges
    assert all(joint.kind == "revolute" for joint in asset.joints)
    left, right = (
        {joint.name.removesuffix(end) for joint in asset.joints if joint.name.endswith(end)}
        for end in ("_left", "_right")
    )
    assert left == right
    assert len(left) == hinges / 2


def test_a_tucked_end_opens_from_its_lid_inwards() -> None:
    asset = box.generate(5, style="tuck_end", ears=True, lips=True, on_collision="fail", cache=Cache())
    lid, tuck, flap = "lid_hinge_left", "tuck_lower_hinge_left", "flap_front_hinge_left"
    assert tuck in asset.blocked({tuck: 0.6})
    assert touch(asset, "tuck_lower_left", "box", **{tuck: 0.6})
    assert asset.blocked({flap: 0.5, lid: 1.0}) == (flap,)
    assert touch(asset, "flap_front_left", "lid_left", **{flap: 0.5})
    assert asset.blocked({flap: 0.5, lid: 1.8, tuck: 1.4, "ear_back_hinge_left": 1.0}) == ()
    assert asset.blocked({"lid_hinge_right": 1.8, flap: 0.5}) == (flap,), "each end has a lid of its own"
    assert asset.blocked({"lip_front_hinge_left": 1.5}) == (), "a lip turns under its flap and the lid"
    assert asset.link("lip_front_left").bounds()[1, 0] > asset.link("flap_front_left").bounds()[1, 0]


@pytest.mark.parametrize("style", ["mailer", "pizza"])
def test_a_tuck_moves_once_its_lid_is_up_and_a_lid_takes_a_closed_tuck_along(style: str) -> None:
    asset = made(2, style=style)
    assert "tuck_front_hinge" in asset.blocked({"tuck_front_hinge": 0.6})
    assert touch(asset, "tuck_front", "box", tuck_front_hinge=0.6)
    for angle in np.linspace(0.0, 0.4, 9).tolist():
        assert not touch(asset, "tuck_front", "box", lid_hinge=angle)
    assert asset.blocked({"lid_hinge": 1.2, "tuck_front_hinge": 1.4}) == ()


def test_a_deep_mailer_has_dust_flaps_under_its_lid_beside_ears_of_the_tuck() -> None:
    asset = box.generate(
        1,
        style="mailer",
        size="large",
        sides="over",
        dusted=True,
        ears=True,
        on_collision="fail",
        cache=Cache(),
    )
    assert {joint.name for joint in asset.joints} >= MINOR | {"ear_left_hinge", "ear_right_hinge"}
    assert asset.blocked({"flap_left_hinge": 0.5, "lid_hinge": 1.0}) == ("flap_left_hinge",)
    assert asset.blocked({"flap_left_hinge": 0.5, "lid_hinge": 1.8}) == ()


@pytest.mark.parametrize("bottles", [2, 3, 6, 12])
def test_a_bottle_is_lifted_out_where_the_flaps_over_it_are_open(bottles: int) -> None:
    asset = box.generate(4, style="wine", bottles=bottles, wine="red", on_collision="fail", cache=Cache())
    lifts = [joint for joint in asset.joints if joint.name.startswith("bottle_lift")]
    assert len(lifts) == bottles
    assert all(1.1 < asset.link(joint.child).mass_properties.mass < 1.4 for joint in lifts)
    assert asset.blocked({"bottle_lift_0": 0.2}) == ("bottle_lift_0",)
    assert lifts[0].needs is not None
    over = dict.fromkeys(lifts[0].needs.condition.joints(), 2.1)
    assert over.keys() == ({"lid_hinge"} if bottles < 6 else {"flap_front_hinge", "flap_left_hinge"})
    opened = {**over, "flap_back_hinge": 2.1} if bottles >= 6 else over
    assert asset.blocked({**opened, "bottle_lift_0": 0.2}) == ()


@pytest.mark.parametrize(
    ("bottles", "flute", "least"), [(2, "c", 0.3109), (6, "c", 0.3198), (6, "bc", 0.3310)]
)
def test_bottles_have_room_below_what_closes_over_them(bottles: int, flute: str, least: float) -> None:
    chosen = {"style": "wine", "bottles": bottles, "wine": "red", "flute": flute}
    asset = box.generate(4, **chosen, height=least + 0.0001, on_collision="fail", cache=Cache())
    over = solid(asset, "lid" if bottles == 2 else "flap_left")
    assert 0.002 < solid(asset, "bottle_0").min_gap(over, 0.1) < 0.003
    with pytest.raises(InfeasibleError, match=r"would collide with the lid over them: raise height"):
        made(4, **chosen, height=least - 0.0001)


def test_dividers_of_a_low_box_end_below_its_tuck() -> None:
    chosen = {"style": "wine", "bottles": 2, "wine": "none"}
    for height in (0.05, 0.33):
        asset = box.generate(4, **chosen, height=height, on_collision="fail", cache=Cache())
        divider = next(piece for piece in asset.link("box").pieces if piece.label == "divider")
        top = divider.shape.bounds()[1, 2]
        assert top < asset.link("tuck_front").bounds()[0, 2] - 0.003
    assert top == pytest.approx(0.6 * height), "a tall one is divided up to there"


@pytest.mark.parametrize(
    "small",
    [
        {"style": "half_slotted", "width": 0.08},
        {"style": "slotted", "mouth": "top", "height": 0.08},
        {"style": "wine", "wine": "none", "bottles": 6, "height": 0.05},
    ],
)
def test_hand_holes_have_board_around_them(small: dict[str, object]) -> None:
    holed = {} if small["style"] == "wine" else {"holes": True}
    with pytest.raises(InfeasibleError, match=r"a centimetre of board around them: take a larger width"):
        made(3, **small, **holed)
    if holed:
        assert made(3, **small, holes=False)


def test_the_corners_of_a_long_flap_are_no_rounder_than_it_is_wide() -> None:
    chosen = {"style": "gift", "closure": "flap", "width": 0.16, "aspect": 1.0}
    for height in (0.1, 0.8):
        asset = box.generate(3, **chosen, rounded=True, height=height, on_collision="fail", cache=Cache())
        flap = next(piece for piece in asset.link("flap_front").pieces if piece.label == "lid")
        square = made(3, **chosen, rounded=False, height=height).link("flap_front").pieces[0]
        assert 0.8 < flap.shape.manifold.volume() / square.shape.manifold.volume() < 0.99


def test_flaps_at_the_sides_of_open_ends_do_not_meet() -> None:
    lying = {"style": "slotted", "mouth": "ends", "width": 0.2, "aspect": 0.6}
    asset = box.generate(3, **lying, height=0.1199, on_collision="fail", cache=Cache())
    between = solid(asset, "flap_front_left").min_gap(solid(asset, "flap_back_left"), 0.01)
    assert 0.002 < between < 0.004
    with pytest.raises(InfeasibleError, match=r"would collide: lower height, or raise width"):
        made(3, **lying, height=0.1201)


def test_a_lid_between_the_walls_has_no_flaps_below_and_room_for_those_at_its_sides() -> None:
    tucked = {"style": "pizza", "sides": "tucked"}
    with pytest.raises(InfeasibleError, match=r"take sides=over or dusted=False"):
        made(3, **tucked, dusted=True)
    assert made(3, **{**tucked, "sides": "over"}, dusted=True)
    with pytest.raises(InfeasibleError, match=r"no room between its crease and its tuck: raise width"):
        made(3, **tucked, ears=True, width=0.1)
    for roomy in ({"ears": False, "width": 0.1}, {"ears": True, "width": 0.13}):
        assert box.generate(3, **tucked, **roomy, on_collision="fail", cache=Cache())


@pytest.mark.parametrize("model", range(100, 104))
def test_words_on_the_front_of_a_pizza_box_are_no_wider_than_it_is(model: int) -> None:
    asset = made(3, style="pizza", sides="over", model=model, width=0.3, height=0.2)
    printed = [piece for piece in asset.link("box").pieces if piece.label == "print"]
    assert printed
    assert all(np.abs(piece.shape.bounds()[:, 0]).max() < 0.15 for piece in printed)


def test_the_cover_of_a_half_slotted_box_stands_out_of_its_tray() -> None:
    chosen = {"style": "half_slotted", "holes": False, "flute": "c"}
    assert box.generate(3, **chosen, height=0.12, on_collision="fail", cache=Cache())
    with pytest.raises(InfeasibleError, match=r"protrude too little from its tray: raise height"):
        made(3, **chosen, height=0.09)


def test_what_is_bent_in_below_a_fresh_lid_does_not_spring_back() -> None:
    asset = made(6, style="mailer", crease="fresh", ears=True)
    assert asset.joint("lid_hinge").stiffness > 0.0
    for name in ("tuck_front_hinge", "ear_left_hinge", "ear_right_hinge"):
        assert asset.joint(name).stiffness == 0.0


@pytest.mark.parametrize("style", ["mailer", "pizza"])
def test_a_fresh_lid_comes_to_rest_without_a_swing(style: str) -> None:
    asset = made(6, style=style, crease="fresh", ears=False, stiffness=1.2, damping=0.03)
    hinge = asset.joint("lid_hinge")
    inertia = 0.0  # of the lid and its flaps about the hinge
    for link in asset.links[1:]:
        body = link.mass_properties
        arm = np.cross(hinge.axis, body.center - hinge.pivot)
        inertia += body.mass * float(arm @ arm) + float(hinge.axis @ body.inertia @ hinge.axis)
    ratio = hinge.damping / (2.0 * math.sqrt(hinge.stiffness * inertia))
    assert 0.8 < ratio < 1.5, "a lid that swings slams shut"
    assert hinge.limits[1] > hinge.rest > 0.0


def test_bottles_do_not_stand_too_deep_to_be_lifted_out() -> None:
    chosen = {"style": "wine", "bottles": 6, "wine": "red", "flute": "b"}
    assert box.generate(4, **chosen, height=0.40, on_collision="fail", cache=Cache())
    with pytest.raises(InfeasibleError, match=r"in so deep a box: lower height"):
        made(4, **chosen, height=0.42)


def test_a_lid_that_covers_nearly_all_of_a_gift_box_leaves_a_little_ribbon_below() -> None:
    asset = made(3, style="gift", closure="lift", height=0.05, skirt=0.95)
    bands = [piece.shape.bounds()[:, 2] for piece in asset.link("box").pieces if piece.label == "ribbon"]
    low = asset.link("lid").bounds()[0, 2]
    assert bands
    assert all(0.0 < bottom < top < low for bottom, top in bands)


def test_short_flaps_of_a_thick_board_do_not_meet_as_they_open() -> None:
    chosen = {"style": "slotted", "mouth": "top", "holes": False, "width": 0.09, "height": 0.2}
    assert box.generate(3, **chosen, aspect=0.56, flute="bc", on_collision="fail", cache=Cache())
    assert box.generate(3, **chosen, aspect=0.5, flute="c", on_collision="fail", cache=Cache())
    with pytest.raises(
        InfeasibleError, match=r"collide as they open: raise width or aspect, or take a thinner"
    ):
        made(3, **chosen, aspect=0.5, flute="bc")


def test_print_stays_on_the_walls_of_a_low_box() -> None:
    asset = made(3, style="slotted", mouth="top", holes=False, width=0.8, aspect=0.9, height=0.06)
    prints = [piece.shape.bounds()[:, 2] for piece in asset.link("box").pieces if piece.label == "print"]
    assert prints
    assert all(0.0 < low < high < 0.06 for low, high in prints)
    with pytest.raises(InfeasibleError, match=r"flaps and print need room: height must be >= 0.06 m"):
        made(3, style="slotted", mouth="top", height=0.05)


def test_a_fresh_crease_springs_back_by_30_to_60_degrees_and_a_worked_one_holds() -> None:
    fresh, worked = (made(6, style="slotted", mouth="top", crease=crease) for crease in ("fresh", "worked"))
    for name in MAJOR:
        joint = fresh.joint(name)
        assert joint.stiffness > 0.0
        assert math.radians(29.0) < joint.rest < math.radians(61.0)
        assert worked.joint(name).stiffness == 0.0
    for name in MINOR:
        assert fresh.joint(name).stiffness == 0.0, "the minor flaps lie under the major ones"


@pytest.mark.parametrize("seed", range(3))
def test_a_box_weighs_what_its_board_does(seed: int) -> None:
    asset = made(seed, style="slotted", mouth="top", taped=False)
    width, aspect, height = (asset.parameters[name] for name in ("width", "aspect", "height"))
    depth = aspect * width
    around = 2.0 * (width + depth) * height
    flaps = 2.0 * (width + depth) * depth  # at the top and at the bottom, each as long as half the depth
    assert asset.mass == pytest.approx(180.0 * THICK[asset.parameters["flute"]] * (around + flaps), rel=0.08)


@pytest.mark.parametrize("style", ["tray", "gift", "half_slotted"])
def test_what_lifts_off_comes_free_and_slides_down_by_itself(style: str) -> None:
    asset = made(5, style=style, closure="lift") if style == "gift" else made(5, style=style)
    name = "sleeve_lift" if style == "half_slotted" else "lid_lift"
    joint = asset.joint(name)
    weight = 9.81 * sum(link.mass_properties.mass for link in asset.links[1:])
    assert joint.friction < 0.9 * weight
    low = solid(asset, joint.child, **{name: joint.limits[1]}).bounding_box()[2]
    high = solid(asset, asset.links[0].name).bounding_box()[5]
    assert low > high
