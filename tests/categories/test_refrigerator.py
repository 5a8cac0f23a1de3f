"""The category `refrigerator`: what opens, what waits for a door, and what each layout has."""

from collections.abc import Mapping
from functools import lru_cache

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from manifold3d import Manifold, OpType

from artgen import Asset
from artgen.categories.refrigerator import refrigerator
from artgen.errors import InfeasibleError
from artgen.graph import Cache
from artgen.validate.tree import check_tree

LAYOUTS = {
    "single": ["door"],
    "top_freezer": ["door", "freezer_door"],
    "bottom_freezer": ["door", "freezer_door"],
    "french": ["door_left", "door_right", "outer_drawer_0"],
    "side_by_side": ["door", "freezer_door"],
}


@lru_cache(maxsize=8)
def made(layout: str) -> Asset:
    """Return a refrigerator of a layout, with drawers inside."""
    few = {"outer_drawers": 1} if layout == "french" else {"outer_drawers": 0}
    return refrigerator.generate(
        3,
        cache=Cache(),
        certify=False,
        layout=layout,
        build="tall",
        crispers=2,
        hand="left",
        ice_box=False,
        **few,
    )


def solid(asset: Asset, link: str, *, without: str = "") -> Manifold:
    """Return the union of what is solid of a link, without the pieces of a label."""
    solids = [piece for piece in asset.link(link).pieces if not piece.visual]
    pieces = [piece.shape.manifold for piece in solids if piece.label != without]
    return Manifold.batch_boolean(pieces, OpType.Add)


def overlap(asset: Asset, a: str, b: str, q: Mapping[str, float]) -> float:
    """Return the volume in which two links overlap in a pose [m^3]."""
    pose = asset.pose(q)
    first, second = (solid(asset, link).transform(pose[link][:3, :4]) for link in (a, b))
    return float((first ^ second).volume())


def mass(asset: Asset) -> float:
    """Return the mass of all links [kg]."""
    return sum(link.mass_properties.mass for link in asset.links)


@pytest.mark.parametrize("layout", LAYOUTS)
def test_each_layout_has_its_doors_and_drawers(layout: str) -> None:
    names = [link.name for link in made(layout).links]
    assert set(LAYOUTS[layout]) <= set(names)
    assert {"inner_drawer_0", "inner_drawer_1"} <= set(names)
    assert names[0] == "body"


@pytest.mark.parametrize("layout", ["single", "top_freezer", "french", "side_by_side"])
def test_a_drawer_strikes_its_closed_door_and_passes_the_open_one(layout: str) -> None:
    asset = made(layout)
    slide = asset.joint("inner_drawer_slide_0")
    assert slide.needs is not None
    assert slide.limits is not None
    assert slide.needs.beyond is not None
    doors = [name for name in slide.needs.condition.joints() if "door" in name]
    assert doors
    out = slide.limits[1]
    assert asset.blocked({slide.name: out}) == (slide.name,)
    closed = {slide.name: slide.needs.beyond + 0.006}
    struck = sum(overlap(asset, asset.joint(door).child, slide.child, closed) for door in doors)
    assert struck > 1e-9, "nothing stands in the way of the drawer while the door is closed"
    condition = slide.needs.condition
    for door in doors:
        term = next((each for each in (condition, *condition.terms) if each.joint == door), condition)
        q = {door: term.value + 1e-3, slide.name: out}
        assert asset.blocked(q) == ()
        assert overlap(asset, asset.joint(door).child, slide.child, q) < 1e-12, "the open door is in its way"


@pytest.mark.parametrize("layout", LAYOUTS)
def test_doors_open_by_a_plausible_pull_and_stay_where_they_are_left(layout: str) -> None:
    asset = made(layout)
    for joint in asset.free_joints:
        if not joint.name.startswith(("door", "freezer_door")):
            continue
        assert joint.stiffness == 0.0
        child = asset.link(joint.child)
        (grasp,) = child.grasps
        arm = float(np.linalg.norm((grasp.frame[:3, 3] - joint.pivot)[:2]))
        assert 13.0 < joint.friction / arm < 45.0, joint.name
        assert joint.effort / arm < 62.0, joint.name


@pytest.mark.parametrize("layout", LAYOUTS)
def test_the_edge_of_a_door_hardly_overhangs_the_side_of_the_cabinet(layout: str) -> None:
    asset = made(layout)
    name = LAYOUTS[layout][0]
    joint = next(each for each in asset.free_joints if each.child == name)
    low, high = asset.link("body").bounds()[:, 0]
    own = solid(asset, name, without="handle")
    for angle in np.linspace(0.0, 1.5, 7):  # beyond, all of the door is beside the cabinet
        box = own.transform(asset.pose({joint.name: float(angle)})[name][:3, :4]).bounding_box()
        beyond = low - box[0] if joint.axis[2] < 0.0 else box[3] - high
        assert beyond < 0.016


def test_both_doors_of_a_pair_pass_each_other_together() -> None:
    asset = made("french")
    for angle in (0.01, 0.04, 0.1, 0.2, 0.4, 0.8):
        q = {"door_hinge_left": angle, "door_hinge_right": angle}
        assert overlap(asset, "door_left", "door_right", q) == 0.0


def test_a_flap_of_an_ice_box_waits_for_the_door() -> None:
    asset = refrigerator.generate(2, layout="single", ice_box=True, on_collision="fail")
    flap = asset.joint("freezer_door_hinge")
    assert asset.blocked({flap.name: 0.5}) == (flap.name,)
    assert asset.blocked({flap.name: 0.5, "door_hinge": asset.joint("door_hinge").limits[1]}) == ()  # type: ignore[index]
    assert overlap(asset, "door", "freezer_door", {flap.name: 0.3}) > 1e-9


def test_the_other_hand_is_the_mirror_image() -> None:
    left, right = (
        refrigerator.generate(1, layout="top_freezer", hand=hand, certify=False) for hand in ("left", "right")
    )
    assert mass(left) == pytest.approx(mass(right))
    for a, b in zip(left.links, right.links, strict=True):
        assert b.bounds()[:, 0] == pytest.approx(-a.bounds()[::-1, 0], abs=1e-9)


@settings(max_examples=8, deadline=None)
@given(seed=st.integers(0, 10_000))
@pytest.mark.long
def test_seeds_give_what_a_shop_could_sell(seed: int) -> None:
    asset = refrigerator.generate(seed, certify=False)
    low, high = asset.link("body").bounds()
    wide, tall = high[0] - low[0], asset.bounds()[1, 2]
    drawn = asset.parameters
    layout = drawn["layout"]
    least, most = (0.83, 0.92) if layout in ("french", "side_by_side") else (0.55, 0.76)
    assert least - 1e-6 <= wide <= most + 1e-6
    assert 0.80 - 1e-6 <= tall <= 1.83 + 1e-6
    assert (50.0 if tall > 1.2 else 25.0) <= mass(asset) <= 130.0
    assert sum(link.label == "inner_drawer" for link in asset.links) <= 3
    assert max(len(link.colliders) for link in asset.links) <= 64
    assert sum(len(link.colliders) for link in asset.links) < 200


@pytest.mark.parametrize("grip", ["bar", "pocket", "channel", "recessed"])
@pytest.mark.parametrize("layout", LAYOUTS)
def test_every_grip_fits_every_layout(layout: str, grip: str) -> None:
    asset = refrigerator.generate(5, certify=False, layout=layout, grip=grip)
    assert all(asset.link(name).grasps for name in LAYOUTS[layout][:1])


@pytest.mark.parametrize(("layout", "link"), [("french", "door_left"), ("side_by_side", "freezer_door")])
def test_one_door_has_the_water_dispenser(layout: str, link: str) -> None:
    asset = refrigerator.generate(3, certify=False, layout=layout, water=True)
    wet = [each.name for each in asset.links if any(piece.label == "dispenser" for piece in each.pieces)]
    assert wet == [link]


def test_doors_side_by_side_have_room_for_light_and_bins() -> None:
    narrow = {"layout": "side_by_side", "wall": 0.05, "certify": False}
    for width, share, words in (
        (0.86, 0.2, "is narrower than its light"),
        (0.62, 0.55, "have no room between the ridges"),
    ):
        with pytest.raises(InfeasibleError, match=f"{words}.*: raise width, lower wall"):
            refrigerator.generate(3, **narrow, width=width, freezer_share=share, bin_depth=0.12)
    assert refrigerator.generate(3, **narrow, width=0.62, freezer_share=0.45, bin_depth=0.05)


def test_french_doors_without_drawers_are_refused():
    with pytest.raises(InfeasibleError, match="layout=french has drawers: outer_drawers must be 1 or 2"):
        refrigerator.generate(0, layout="french", outer_drawers=0)


def test_the_name_on_a_front_that_swells_far_reaches_back_to_it() -> None:
    wide = {}
    for bow in (0.018, 0.03):
        asset = refrigerator.generate(
            3,
            layout="single",
            form="bowed",
            grip="bar",
            display="",
            maker="Tessaround",
            bow=bow,
            certify=False,
        )
        assert not check_tree(asset).faults
        (name,) = (piece for piece in asset.link("door").pieces if piece.label == "logo")
        wide[bow] = float(np.ptp(name.shape.bounds()[:, 0]))
    assert wide[0.03] < 0.8 * wide[0.018], "it is smaller where its ends would stand off"
