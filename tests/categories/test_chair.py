"""What is special to a chair: what rises, tilts back and folds, what follows, sizes and masses."""

import math
from functools import lru_cache
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
import pytest

from artgen.asset import Asset
from artgen.catalog import find
from artgen.errors import InfeasibleError
from artgen.validate.hands import check_grasps
from support.cases import some


@lru_cache(maxsize=8)
def made(seed: int, **given: Any) -> Asset:
    return find("chair").generate(seed, on_collision="fail", **given)


def test_a_seat_stays_at_its_height_and_turns_without_end() -> None:
    asset = made(1, style="bar")
    lift = asset.joint("seat_lift")
    carried = asset.link("seat").mass_properties.mass + asset.link("lever").mass_properties.mass
    assert lift.friction > 9.81 * carried, "the gas spring is locked"
    assert asset.joint("seat_swivel").limits is None


def test_rear_legs_follow_the_seat_until_they_lie_beside_the_front_ones() -> None:
    asset = made(2, style="folding")
    _, high = asset.joint("seat_fold").limits or (0.0, 0.0)
    follower = asset.joint("legs_fold").follows
    assert follower is not None
    assert follower.leader == "seat_fold"
    assert follower.at(high) == pytest.approx(1.13, abs=1e-3)
    depths = []
    for turn in (0.0, high):
        pose = asset.pose({"seat_fold": turn})["legs"]
        foot = pose[:3, :3] @ (0.0, 0.235, 0.012) + pose[:3, 3]
        depths.append(foot[1])
    assert depths[0] > 0.2, "behind the seat"
    assert depths[1] < -0.15, "between the front legs"


@pytest.mark.parametrize("joint", ["legs_fold", "strut_turn"])
def test_a_joint_of_the_four_bar_rests_exactly_at_an_end_of_its_range(joint: str) -> None:
    limits = made(0, style="folding").joint(joint).limits
    assert limits is not None, f"{joint} has limits"
    assert 0.0 in limits, "simulators warn of a rest position that is 1e-13 rad outside of a range"
    model = made(0, style="folding").to_mjspec().compile()
    assert model.qpos0[model.joint(joint).qposadr[0]] == 0.0, f"MuJoCo has {joint} at 0 at rest"


def test_seat_struts_and_legs_of_a_folding_chair_are_a_four_bar() -> None:
    asset = made(2, style="folding")
    (pin,) = asset.loops
    assert (*pin.links, pin.joint) == ("strut", "seat", "seat_fold")
    _, high = asset.joint("seat_fold").limits or (0.0, 0.0)
    sides, sines = [], []
    for turn in np.linspace(0.0, high, 9).tolist():
        pose = asset.pose({"seat_fold": turn})
        at = {name: pose[name][:3, :3] @ pin.point + pose[name][:3, 3] for name in pin.links}
        np.testing.assert_allclose(at["strut"], at["seat"], atol=1e-9)
        pivots = [asset.joint(name).pivot for name in ("legs_fold", "strut_turn")]
        low, end = (pose["legs"][:3, :3] @ pivot + pose["legs"][:3, 3] for pivot in pivots)
        sides.append(np.linalg.norm(at["strut"] - end))
        crank, rod = end - low, at["strut"] - end
        sines.append(np.linalg.norm(np.cross(crank, rod)) / np.linalg.norm(crank) / np.linalg.norm(rod))
    np.testing.assert_allclose(sides, sides[0], atol=1e-9)
    assert min(sines) > 0.35, "the seat moves the legs everywhere: no dead point is near"
    positions = [asset.positions({"seat_fold": turn})["legs_fold"] for turn in np.linspace(0, high, 33)]
    assert (np.diff(positions) > 0).all(), "the legs never swing back"


def test_a_hand_at_the_seat_folds_the_rear_legs_in_mujoco(tmp_path: Path) -> None:
    asset = made(2, style="folding").rounded()
    folder = asset.export(tmp_path / asset.name, formats=("mjcf",), textures=0)
    model = mujoco.MjModel.from_xml_path(str(folder / f"{asset.name}.xml"))
    data = mujoco.MjData(model)
    _, high = asset.joint("seat_fold").limits or (0.0, 0.0)
    hinge = model.joint("seat_fold")
    reached, worst = [], dict.fromkeys(("seat", "strut", "legs"), 0.0)
    for step in range(4000):  # the hand leads the seat up and down again
        wanted = high * math.sin(math.pi * (step + 1) / 4000) ** 2
        at, speed = data.qpos[hinge.qposadr[0]], data.qvel[hinge.dofadr[0]]
        data.qfrc_applied[hinge.dofadr[0]] = np.clip(400.0 * (wanted - at) - 10.0 * speed, -30.0, 30.0)
        mujoco.mj_step(model, data)
        reached.append(float(data.qpos[hinge.qposadr[0]]))
        if step % 50 == 0:
            mujoco.mj_kinematics(model, data)
            pose = asset.pose({"seat_fold": min(max(reached[-1], 0.0), high)})  # limits are soft
            for name in worst:
                place = pose[name][:3, :3] @ asset.origin(name) + pose[name][:3, 3]
                worst[name] = max(worst[name], float(np.abs(data.body(name).xpos - place).max()))
    assert max(reached) > 0.95 * high
    assert reached[-1] < 0.1
    assert max(worst.values()) < 0.001, worst
    assert all(warning.number == 0 for warning in data.warning)


def test_a_footrest_rises_with_the_reclined_back() -> None:
    asset = made(3, style="recliner")
    _, tilt = asset.joint("back_tilt").limits or (0.0, 0.0)
    follower = asset.joint("footrest_turn").follows
    assert follower is not None
    assert math.radians(55) < follower.ratio * tilt < math.radians(85)


@pytest.mark.parametrize("arms", ["block", "rolled", "wood"])
def test_a_hand_tilts_the_back_of_every_recliner_between_its_arms(arms: str) -> None:
    asset = made(3, style="recliner", arms=arms)
    assert check_grasps(asset).faults == ()
    back, base = asset.link("back").bounds(), asset.link("base").bounds()
    assert base[0, 0] < back[0, 0] - 0.04
    assert back[1, 0] + 0.04 < base[1, 0]
    assert base[0, 2] == pytest.approx(0.0, abs=1e-6)
    assert 28.0 < asset.mass < 52.0


def test_arms_of_another_style_are_refused() -> None:
    with pytest.raises(
        InfeasibleError, match="arms=wood are not for style=office: arms must be none or posts"
    ):
        made(3, style="office", arms="wood")


def test_casters_of_an_office_chair_stand_on_the_floor() -> None:
    asset = made(4, style="office")
    wheels = [link for link in asset.links if link.name.startswith("caster_wheel")]
    assert len(wheels) == 5
    for wheel in wheels:
        assert wheel.bounds()[0, 2] == pytest.approx(0.0, abs=1e-4)
    assert 10.0 < asset.mass < 20.0


@pytest.mark.parametrize("form", some(["padded", "tapered", "framed"], 2))
@pytest.mark.parametrize(("headrest", "arms"), [(True, "loops"), (False, "posts")])
def test_a_hand_tilts_every_back_at_its_top(form: str, arms: str, *, headrest: bool) -> None:
    asset = made(4, style="office", form=form, headrest=headrest, arms=arms, tall=0.6)
    assert check_grasps(asset).faults == ()
    (hold,) = asset.link("back").grasps
    top = asset.link("back").bounds()[1, 2]
    assert top - 0.04 < hold.frame[2, 3] < top
    assert top == pytest.approx(asset.parameters["height"] + 0.16 + 0.6, abs=0.02)
