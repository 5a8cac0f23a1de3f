"""Assets: poses, couplings, dependencies, frames and lookups."""

import json
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from artgen.asset import Asset, Branch, Link, Tree
from artgen.asset import AssetCondition as Condition
from artgen.asset import AssetCoupling as Coupling
from artgen.asset import AssetDependency as Dependency
from artgen.asset import AssetJoint as Joint
from artgen.catalog import find
from artgen.errors import AssetError, ParameterError
from artgen.materials import Material

BoxLink = Callable[..., Link]
X, Y, Z = np.eye(3)


@pytest.fixture(scope="module")
def bin_(box_link: BoxLink) -> Asset:
    """A pedal bin: the lid follows the pedal, a flap follows the lid, a tray slides and turns on one link."""
    pedal = Joint("pedal", "revolute", X, np.array([0.0, -0.2, 0.05]), (0.0, 0.25))
    lid = Joint("lid", "revolute", -X, np.array([0.0, 0.2, 0.6]), follows=Coupling("pedal", 4.0, 0.02))
    flap = Joint("flap", "revolute", Z, np.array([0.1, 0.2, 0.7]), follows=Coupling("lid", -0.5, 0.1))
    out = Joint("out", "prismatic", -Y, np.array([0.0, 0.0, 0.3]), (0.02, 0.3))
    turn = Joint(
        "turn", "revolute", Z, np.array([0.1, 0.0, 0.3]), None,
        needs=Dependency(Condition("above", "out", 0.25)),
    )  # fmt: skip
    foot = Joint("foot", "revolute", Z, np.array([0.1, 0.0, 0.0]), (0.5, 0.5))
    tree = Tree(
        box_link("body", (0.4, 0.4, 0.6), (0, 0, 0.3)),
        (
            Branch((pedal,), Tree(box_link("pedal_arm", center=(0, -0.3, 0.05)))),
            Branch(
                (lid,),
                Tree(
                    box_link("lid_top", (0.4, 0.4, 0.02), (0, 0, 0.61)),
                    (Branch((flap,), Tree(box_link("flap_leaf", center=(0.1, 0.1, 0.7)))),),
                ),
            ),
            Branch((out, turn), Tree(box_link("tray", center=(0, 0, 0.3)))),
            Branch((foot,), Tree(box_link("foot_block"))),
        ),
    )
    return Asset.from_tree(tree, "bin_1", "bin", seed=1, parameters={"height": 0.6})


def test_followers_take_their_leaders_position(bin_: Asset) -> None:
    positions = bin_.positions({"pedal": 0.2})
    assert positions["lid"] == pytest.approx(4.0 * 0.2 + 0.02)
    assert positions["flap"] == pytest.approx(-0.5 * positions["lid"] + 0.1)


def test_joints_not_given_stand_nearest_to_zero(bin_: Asset) -> None:
    positions = bin_.positions()
    assert list(positions) == [joint.name for joint in bin_.joints]
    assert (positions["pedal"], positions["out"], positions["turn"], positions["foot"]) == (
        0.0,
        0.02,
        0.0,
        0.5,
    )
    assert [joint.name for joint in bin_.free_joints] == ["pedal", "out", "turn"]


def test_followers_range_over_their_leaders_range(bin_: Asset) -> None:
    assert bin_.joint("lid").limits == pytest.approx((0.02, 1.02))
    assert bin_.joint("flap").limits == pytest.approx((-0.41, 0.09))


@given(out=st.floats(0.02, 0.3), turn=st.floats(-9.0, 9.0))
def test_joints_of_a_pair_act_in_order_the_first_nearest_to_the_parent(
    bin_: Asset, out: float, turn: float
) -> None:
    """Turned about a pivot that the slide has carried along."""
    pose = bin_.pose({"out": out, "turn": turn})["tray"]
    pivot = np.array([0.1, 0.0, 0.3, 1.0])
    np.testing.assert_allclose(pose @ pivot, pivot - np.array([0.0, out, 0.0, 0.0]), atol=1e-12)
    np.testing.assert_allclose(pose[:2, 0], [np.cos(turn), np.sin(turn)], atol=1e-12)


@given(pedal=st.floats(0.0, 0.25))
def test_child_is_carried_along_by_its_parent(bin_: Asset, pedal: float) -> None:
    pose = bin_.pose({"pedal": pedal})
    flap = bin_.joint("flap")
    relative = np.linalg.inv(pose["lid_top"]) @ pose["flap_leaf"]
    np.testing.assert_allclose(relative, flap.motion(bin_.positions({"pedal": pedal})["flap"]), atol=1e-12)
    np.testing.assert_array_equal(pose["body"], np.eye(4))


def test_locked_joint_holds_its_link_displaced(bin_: Asset) -> None:
    np.testing.assert_array_equal(bin_.pose()["foot_block"], bin_.joint("foot").motion(0.5))


@pytest.mark.parametrize(
    ("q", "message"),
    [
        ({"pedal": 0.26}, r"joint 'pedal' cannot be at 0\.26; its limits are 0 to 0\.25"),
        ({"lid": 0.5}, "joint 'lid' follows 'pedal'; set 'pedal' instead"),
        ({"pedl": 0.1}, r"asset 'bin_1' has no joint 'pedl'\. Did you mean 'pedal'\?"),
    ],
)
def test_impossible_positions_are_refused(bin_: Asset, q: dict[str, float], message: str) -> None:
    with pytest.raises(AssetError, match=message):
        bin_.pose(q)


def test_rounding_beyond_a_limit_is_forgiven(bin_: Asset) -> None:
    assert bin_.positions({"pedal": 0.25 + 1e-12})["pedal"] == pytest.approx(0.25)


def test_dependency_blocks_where_its_condition_fails(bin_: Asset) -> None:
    assert bin_.blocked({"out": 0.1, "turn": 0.5}) == ("turn",)
    assert bin_.blocked({"out": 0.3, "turn": 0.5}) == ()
    assert bin_.blocked() == ()


def test_frames_lie_on_the_joint_nearest_to_the_link(bin_: Asset) -> None:
    np.testing.assert_array_equal(bin_.origin("body"), np.zeros(3))
    np.testing.assert_array_equal(bin_.origin("tray"), [0.1, 0.0, 0.3])
    with pytest.raises(AssetError, match=r"no link 'try'\. Did you mean 'tray'\?"):
        bin_.origin("try")


def test_mass_is_that_of_the_links(bin_: Asset) -> None:
    assert bin_.mass == pytest.approx(sum(link.mass_properties.mass for link in bin_.links))
    assert bin_.mass_properties().mass == pytest.approx(bin_.mass)


def test_data_is_plain_json_and_the_same_each_time(bin_: Asset) -> None:
    assert json.loads(bin_.to_json()) == json.loads(json.dumps(bin_.to_data()))
    assert bin_.to_json() == bin_.to_json()


def test_base_can_be_freed(bin_: Asset) -> None:
    assert bin_.with_base("free").base == "free"
    assert bin_.base == "fixed"
    with pytest.raises(ParameterError, match="base = 'Fixed' is not allowed: it must be 'fixed' or 'free'"):
        bin_.with_base("Fixed")


def test_joints_contain_their_names(bin_: Asset) -> None:
    assert bin_.joints[0].name in bin_.joints
    assert bin_.joints[0] in bin_.joints
    assert "none" not in bin_.joints


def pair(box_link: BoxLink, *joints: Joint) -> Tree:
    branches = tuple(Branch((joint,), Tree(box_link(f"{joint.name}_link"))) for joint in joints)
    return Tree(box_link("base"), branches)


def revolute(name: str, **fields: object) -> Joint:
    return Joint(name, "revolute", Z, np.zeros(3), (0.0, 1.0), **fields)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("joints", "message"),
    [
        ([revolute("lid", follows=Coupling("pedl", 1.0)), revolute("pedal")],
         r"joint 'lid' follows 'pedl', which is not a joint of this asset; attach .* Did you mean 'pedal'"),
        ([revolute("lid", needs=Dependency(Condition("above", "dor", 1.0))), revolute("door")],
         r"joint 'lid' needs 'dor', which is not a joint of this asset; attach .* Did you mean 'door'"),
        ([revolute("lid", follows=Coupling("lid", 1.0))], "joint 'lid' follows itself; name another joint"),
        ([revolute("a", follows=Coupling("b", 1.0)), revolute("b", follows=Coupling("a", 1.0))],
         "the couplings of joints a, b form a circle"),
    ],
)  # fmt: skip
def test_wrong_references_are_refused(box_link: BoxLink, joints: list[Joint], message: str) -> None:
    with pytest.raises(AssetError, match=message):
        Asset.from_tree(pair(box_link, *joints), "it", "it")


def test_two_materials_of_one_name_are_refused(box_link: BoxLink) -> None:
    first, second = box_link("first"), box_link("second", center=(0, 0, 1))
    painted = replace(second.pieces[0], material=Material("water", density=1.0))
    second = replace(second, pieces=(painted,))
    asset = Asset.from_tree(Tree(first, (Branch((revolute("j"),), Tree(second)),)), "it", "it")
    with pytest.raises(
        AssetError, match="two different materials named 'water'; give one of them another name"
    ):
        _ = asset.materials


def test_names_are_unique_in_a_tree(box_link: BoxLink) -> None:
    with pytest.raises(ValueError, match="the joint name 'a' is used twice; give one joint another name"):
        Tree(
            box_link("base"),
            tuple(Branch((revolute("a"),), Tree(box_link(name))) for name in ("left", "right")),
        ).checked()


@pytest.mark.parametrize("position", ["0.3", None, True])
def test_a_position_that_is_no_number_is_refused(position: Any) -> None:
    asset = find("handle").generate(0, certify=False)
    with pytest.raises(AssetError, match=r"joint 'handle_turn' cannot be at .*; give a number"):
        asset.pose({"handle_turn": position})
