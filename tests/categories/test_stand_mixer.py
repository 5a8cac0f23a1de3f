"""What is special to a stand mixer: a head behind its lock, a bowl behind its hooks, a crank that stays."""

from functools import lru_cache
from typing import Any

import mujoco
import pytest

from artgen.asset import Asset
from artgen.catalog import find
from artgen.errors import InfeasibleError
from artgen.validate.hands import check_grasps


@lru_cache(maxsize=4)
def made(seed: int, **given: Any) -> Asset:
    return find("stand_mixer").generate(seed, on_collision="fail", **given)


def settled(asset: Asset, left: dict[str, float], seconds: float, **torques: float) -> Any:
    """Return the simulation after some seconds under torques, from positions that joints are left in."""
    model = asset.to_mjspec().compile()
    data = mujoco.MjData(model)
    for name, value in left.items():
        data.joint(name).qpos = value
    for _ in range(round(seconds / model.opt.timestep)):
        for name, torque in torques.items():
            data.joint(name).qfrc_applied = torque
        mujoco.mj_step(model, data)
    return data


def test_the_lock_holds_a_head_down() -> None:
    asset = made(1, style="tilt")
    shut = settled(asset, {}, 0.5, head_tilt=15.0)
    assert shut.joint("head_tilt").qpos[0] < 0.03
    free = settled(asset, {"button_slide": 0.011}, 0.5, head_tilt=15.0)
    assert free.joint("head_tilt").qpos[0] > 0.2


def test_an_open_head_stays_open() -> None:
    asset = made(1, style="tilt")
    top = (asset.joint("head_tilt").limits or (0.0, 0.0))[1]
    data = settled(asset, {"button_slide": 0.011, "head_tilt": top - 0.01}, 0.5)
    assert data.joint("head_tilt").qpos[0] == pytest.approx(top - 0.01, abs=0.02)


def test_a_bowl_lifts_after_it_turns() -> None:
    asset = made(1, style="tilt")
    opened = {"button_slide": 0.011, "head_tilt": (asset.joint("head_tilt").limits or (0.0, 0.0))[1]}
    held = settled(asset, opened, 0.3, bowl_lift=20.0)
    assert held.joint("bowl_lift").qpos[0] < 0.004
    loose = settled(asset, opened | {"bowl_turn": 0.44}, 0.3, bowl_lift=20.0)
    assert loose.joint("bowl_lift").qpos[0] > 0.02


def test_a_crank_carries_the_bowl_and_stays() -> None:
    asset = made(1, style="lift")
    data = settled(asset, {"crank_turn": 0.7, "carriage_slide": 0.7 * asset.parameters["drop"] / 1.45}, 0.5)
    assert data.joint("crank_turn").qpos[0] == pytest.approx(0.7, abs=0.03)


def test_a_hand_takes_the_crank_beside_the_arms_of_the_widest_bowl() -> None:
    assert check_grasps(made(1, style="lift", radius=0.118)).faults == ()


@pytest.mark.parametrize(("style", "masses"), [("tilt", (8.5, 12.0)), ("lift", (11.0, 14.0))])
def test_masses_are_those_of_shops(style: str, masses: tuple[float, float]) -> None:
    assert masses[0] < made(1, style=style).mass < masses[1]


def test_a_low_bowl_that_lifts_is_refused() -> None:
    options = {"style": "lift", "radius": 0.108, "slim": 0.05}
    assert find("stand_mixer").generate(1, height=0.15, **options).certificate.proven
    with pytest.raises(InfeasibleError, match=r"height of a bowl that lifts must be >= 0\.15 m"):
        find("stand_mixer").generate(1, height=0.145, **options)
