"""Scenes: assets at places that follow from relations, and a proof over the joints of all of them."""

import math
from collections.abc import Callable
from dataclasses import replace

import mujoco
import numpy as np
import pytest

from artgen._names import ByName
from artgen.asset import Asset
from artgen.errors import AssetError, ParameterError
from artgen.proof.certify import certify
from artgen.scene import ROOMS, Scene, kitchen
from artgen.scene.room import GAP, STANDING

SMALL = {"kind": "bedside", "rows": 1, "width": 0.45, "depth": 0.42}
ONE_DOOR = {"kind": "base", "doors": 1, "width": 0.5, "depth": 0.5}


@pytest.fixture(scope="module")
def corner() -> Asset:
    """Two cabinets whose doors open towards each other, and a lamp on one of them."""
    room = Scene("corner", seed=2, width=2.0, depth=1.6)
    hands = [("cabinet", {**ONE_DOOR, "hand": hand}) for hand in ("right", "left")]
    first, _ = room.run("back", *hands, at=0.4, gap=0.01)
    room.on(first, "pepper_grinder")
    return room.build()


def test_a_run_stands_on_the_floor_along_its_wall() -> None:
    room = Scene("run", width=3.0, depth=2.4)
    back = room.run("back", ("drawer", SMALL), ("drawer", SMALL), at=0.2)
    (left,) = room.run("left", ("drawer", SMALL), at=0.1)
    (right,) = room.run("right", ("drawer", SMALL), at=0.3)
    low, high = back[0].bounds
    assert np.allclose([low[0], high[1], low[2]], [-1.3, -GAP, STANDING], atol=1e-9)
    assert math.isclose(back[1].bounds[0][0] - high[0], GAP, abs_tol=1e-9)
    # seen from the room, the left end of the left wall is at the front, that of the right wall at the back
    assert np.allclose([left.bounds[0][0], left.bounds[0][1]], [-1.5 + GAP, -2.4 + 0.1], atol=1e-9)
    assert np.allclose([right.bounds[1][0], right.bounds[1][1]], [1.5 - GAP, -0.3], atol=1e-9)


def test_a_scene_is_an_asset_whose_joints_are_those_of_all(corner: Asset) -> None:
    assert corner.certificate is not None
    assert corner.certificate.proven
    assert corner.links[0].name == "room"
    assert {"cabinet_door", "cabinet_1_door", "pepper_grinder_body"} <= {link.name for link in corner.links}
    model = corner.to_mjspec(textures=0).compile()
    assert model.nv == len(corner.free_joints)
    assert math.isclose(sum(model.body_mass), corner.mass, rel_tol=1e-3)


def test_of_two_doors_that_meet_one_depends_on_the_other(corner: Asset) -> None:
    doors = {"cabinet_door_hinge", "cabinet_1_door_hinge"}
    (dependent,) = [joint for joint in corner.joints if joint.name in doors and joint.needs is not None]
    assert dependent.needs is not None
    assert {dependent.name, *dependent.needs.condition.joints()} == doors
    wide_open = {name: corner.joint(name).limits[1] for name in doors}  # type: ignore[index]
    assert not dependent.needs.allows(wide_open[dependent.name], wide_open)
    free = dict.fromkeys(doors, 0.0) | {dependent.name: wide_open[dependent.name]}
    assert dependent.needs.allows(wide_open[dependent.name], free)
    without = (replace(joint, needs=None) for joint in corner.joints)
    assert not certify(replace(corner, joints=ByName(without))).proven


def test_a_scene_rests_in_simulation(corner: Asset) -> None:
    model = corner.to_mjspec(textures=0).compile()
    data = mujoco.MjData(model)
    for _ in range(int(0.5 / model.opt.timestep)):
        mujoco.mj_step(model, data)
    assert data.ncon == 0
    assert np.abs(data.qpos).max() < 0.01


def test_an_opening_is_cut_to_the_size_of_its_window() -> None:
    room = Scene("view", width=2.4, depth=2.0)
    window = room.inset("back", "window", at=0.5, z=0.9, shutters="none")
    middle = window.bounds.mean(axis=0)
    asset = room.build()
    wall = [each for each in asset.links[0].colliders if each.label == "wall"]
    assert wall
    assert not any(each.convex.faces.contains(middle[None]) for each in wall)
    assert asset.joints["window_place"].locked


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        (
            lambda room: room.against("front", "lamp", at=0.0),
            "wall = 'front' is not allowed: it must be one of",
        ),
        (lambda room: room.against("back", "drawer", at=1.9, **SMALL), "m are missing"),
        (lambda room: room.on(room.against("back", "lamp", at=0.1), "oven"), "of width are missing"),
        (lambda room: [room.against("back", "lamp", at=0.1, name="a") for _ in "ab"], "give another name"),
        (lambda room: room.against("back", "lampp", at=0.1), "lamp"),
        (lambda room: Scene("hall", width=90.0, depth=2.0), "the width of a room is 0.5 to 30 m, not 90.0"),
        (
            lambda room: kitchen(0, width=2.2),
            "is too narrow: with a refrigerator, a dishwasher and an oven, ",
        ),
    ],
)
def test_what_does_not_fit_is_refused_with_what_is_missing(
    wrong: Callable[[Scene], object], message: str
) -> None:
    with pytest.raises(ParameterError) as error:
        wrong(Scene("room", width=2.0, depth=1.6))
    assert message in str(error.value)


def test_a_drawer_without_space_is_refused() -> None:
    room = Scene("tight", width=2.0, depth=1.6)
    room.against("back", "drawer", at=0.01, **SMALL)
    room.against("left", "drawer", at=0.66, **SMALL)
    with pytest.raises(
        AssetError, match=r"of the range of joint 'drawer\w*_slide_0' is free; leave more space"
    ):
        room.build()


def test_the_same_seed_gives_the_same_scene() -> None:
    def mill(seed: int) -> Asset:
        room = Scene("mill", seed=seed, width=2.0, depth=1.6)
        room.on(room.against("back", "drawer", at=0.3, **SMALL), "pepper_grinder")
        return room.build()

    assert mill(3).to_json() == mill(3).to_json()
    assert mill(3).to_json() != mill(4).to_json()


def test_a_kitchen_is_proven() -> None:
    room = ROOMS["kitchen"](2, width=3.0, depth=2.4, detail="low")
    assert room.certificate is not None
    assert room.certificate.proven
    assert (room.name, room.category, room.seed, room.detail) == ("kitchen_2", "kitchen", 2, "low")
    assert {"refrigerator_body", "oven_body", "dishwasher_body", "window_frame", "door_frame"} <= {
        link.name for link in room.links
    }
