"""What is special to a fan: blades that spin freely in their guard, heads and poles that stay, sizes."""

from functools import lru_cache
from typing import Any

import mujoco
import numpy as np
import pytest

from artgen.asset import Asset
from artgen.catalog import find
from artgen.errors import InfeasibleError


@lru_cache(maxsize=12)
def made(seed: int, **given: Any) -> Asset:
    return find("fan").generate(seed, on_collision="fail", **given)


@pytest.mark.parametrize("style", ["desk", "pedestal", "box", "clip"])
def test_blades_spin_freely_in_their_guard(style: str) -> None:
    asset = made(1, style=style)
    assert asset.joint("blades_spin").limits is None
    assert 3 < len(asset.link("blades").colliders) <= 12
    model = asset.to_mjspec().compile()
    data = mujoco.MjData(model)
    for _ in range(300):
        data.joint("blades_spin").qfrc_applied = 0.05
        mujoco.mj_step(model, data)
    assert data.joint("blades_spin").qvel[0] > 4.0


@pytest.mark.parametrize("style", ["desk", "pedestal"])
def test_head_and_pole_stay_where_they_are_left(style: str) -> None:
    asset = made(1, style=style)
    left = {"head_tilt": 0.15, "head_swing": -0.4} | ({"pole_slide": 0.1} if style == "pedestal" else {})
    model = asset.to_mjspec().compile()
    data = mujoco.MjData(model)
    for name, value in left.items():
        data.joint(name).qpos = value
    mujoco.mj_step(model, data, nstep=round(1.0 / model.opt.timestep))
    for name, value in left.items():
        assert data.joint(name).qpos[0] == pytest.approx(value, abs=0.015)


def test_a_dial_clicks_from_speed_to_speed() -> None:
    asset = made(1, style="box")
    model = asset.to_mjspec().compile()
    data = mujoco.MjData(model)
    data.joint("dial_turn").qpos = 1.15
    mujoco.mj_step(model, data, nstep=round(0.5 / model.opt.timestep))
    assert data.joint("dial_turn").qpos[0] == pytest.approx(1.4, abs=0.12)


def test_a_drawn_pole_lifts_the_head() -> None:
    asset = made(1, style="pedestal")
    rise = (asset.joint("pole_slide").limits or (0.0, 0.0))[1]
    assert asset.pose({"pole_slide": rise})["head"][2, 3] == pytest.approx(rise)
    assert 0.95 < asset.bounds()[1][2] < 1.35


@pytest.mark.parametrize(
    ("style", "masses"),
    [("desk", (1.8, 4.0)), ("pedestal", (4.0, 8.0)), ("box", (3.0, 6.0)), ("clip", (0.5, 1.4))],
)
def test_masses_are_those_of_shops(style: str, masses: tuple[float, float]) -> None:
    assert masses[0] < made(1, style=style).mass < masses[1]
    least = np.ptp(np.array(made(1, style=style).link("blades").bounds()), axis=0)
    assert least[0] < made(1, style=style).parameters["size"]


@pytest.mark.parametrize(("style", "least"), [("desk", 0.2), ("pedestal", 0.26)])
def test_a_fan_that_is_too_small_for_its_panel_is_refused(style: str, least: float) -> None:
    assert made(1, style=style, size=least, pitch=0.7).certificate
    with pytest.raises(InfeasibleError, match=f"size of a {style} fan must be >= {least:g} m"):
        made(1, style=style, size=least - 0.01)
