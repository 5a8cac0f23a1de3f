"""What is special to a range hood: filters that rest on their catches and drop, panes that stay."""

import math
from functools import lru_cache
from typing import Any

import mujoco
import pytest

from artgen.asset import Asset
from artgen.catalog import find
from artgen.errors import InfeasibleError
from support.release import released

MASSES = {
    "chimney": (9.5, 23),
    "glass": (11, 21),
    "cabinet": (4.5, 9.5),
    "telescopic": (7, 11),
    "inclined": (12, 27),
    "island": (18, 36),
}
FILTERED = ("chimney", "glass", "cabinet", "inclined", "island")


@lru_cache(maxsize=16)
def made(seed: int, **given: Any) -> Asset:
    return find("range_hood").generate(seed, certify=False, **given)


@pytest.mark.parametrize("style", MASSES)
def test_a_hood_weighs_as_it_is_sold(style: str) -> None:
    low, high = MASSES[style]
    for seed in range(4):
        assert low < made(seed, style=style).mass < high


@pytest.mark.parametrize("style", FILTERED)
def test_a_filter_rests_on_its_catch_and_drops_without_it(style: str) -> None:
    asset = made(1, style=style)
    assert abs(released(asset, "filter_hinge_0", 0.0, seconds=2.0)) < 0.01
    model = asset.to_mjspec().compile()
    data = mujoco.MjData(model)
    catch, hinge = model.joint("catch_slide_0"), model.joint("filter_hinge_0")
    data.qfrc_applied[catch.dofadr[0]] = 9.0
    mujoco.mj_step(model, data, nstep=round(2.0 / model.opt.timestep))
    assert data.qpos[hinge.qposadr[0]] > 1.0


@pytest.mark.parametrize("style", FILTERED)
def test_a_catch_springs_back(style: str) -> None:
    assert released(made(1, style=style), "catch_slide_0", 0.006) == pytest.approx(0.0, abs=3e-4)


@pytest.mark.parametrize(("style", "joint"), [("inclined", "panel_hinge"), ("cabinet", "flap_hinge")])
def test_a_pane_stays_at_any_angle(style: str, joint: str) -> None:
    asset = made(1, style=style)
    limits = asset.joint(joint).limits
    assert limits is not None
    for share in (0.0, 0.3, 0.95):
        assert released(asset, joint, share * limits[1]) == pytest.approx(share * limits[1], abs=0.02)


def test_a_visor_is_drawn_out_by_a_hand_and_stays() -> None:
    asset = made(1, style="telescopic")
    slide = asset.joint("visor_slide")
    assert slide.limits is not None
    assert 0.12 < slide.limits[1] < 0.20
    assert released(asset, "visor_slide", 0.1) == pytest.approx(0.1, abs=1e-3)
    assert math.isclose(released(asset, "visor_slide", 0.0, pull=25.0), slide.limits[1], abs_tol=2e-3)


def test_a_slider_clicks_at_three_positions() -> None:
    asset = made(1, style="cabinet")
    for position in (0.001, 0.011, 0.0235):
        nearest = 0.012 * round(position / 0.012)
        assert released(asset, "slider_slide_0", position) == pytest.approx(nearest, abs=2e-3)


def test_widths_that_are_not_sold_are_refused() -> None:
    for style, width in (("island", 0.6), ("telescopic", 1.1)):
        with pytest.raises(InfeasibleError, match=f"width of a {style} hood must be"):
            made(1, style=style, width=width)
