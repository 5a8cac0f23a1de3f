"""What is special to a switch: it snaps to its ends, a timer clicks, a dimmer stays, sizes."""

from functools import lru_cache
from typing import Any

import numpy as np
import pytest

from artgen.asset import Asset
from artgen.catalog import find
from support.release import released


@lru_cache(maxsize=12)
def made(seed: int, **given: Any) -> Asset:
    return find("switch").generate(seed, on_collision="fail", **given)


@pytest.mark.parametrize(
    ("style", "name"), [("rocker", "rocker_tilt_0"), ("toggle", "toggle_tilt"), ("stop", "stop_push")]
)
def test_a_switch_snaps_to_the_nearer_end(style: str, name: str) -> None:
    asset = made(1, style=style)
    end = (asset.joint(name).limits or (0.0, 0.0))[1]
    for share, expected in ((0.35, 0.0), (0.65, 1.0)):
        assert released(asset, name, share * end) == pytest.approx(expected * end, abs=0.05 * end)


def test_a_timer_clicks_to_an_hour_and_a_dimmer_stays_between() -> None:
    step = 4.8 / 6
    assert released(made(2, style="timer"), "knob_turn", 2.3 * step) == pytest.approx(
        2 * step, abs=0.15 * step
    )
    assert released(made(2, style="dimmer"), "knob_turn", 2.3 * step) == pytest.approx(2.3 * step, abs=0.02)


@pytest.mark.parametrize("style", ["rocker", "toggle", "stop"])
def test_the_force_that_turns_it_over_is_the_parameter(style: str) -> None:
    asset = made(3, style=style, force=30.0 if style == "stop" else 3.0)
    (joint, *_) = asset.joints
    over = np.linspace(0.0, 0.49, 50) * (joint.limits or (0.0, 0.0))[1]
    assert (joint.detent_torque(over) <= 0.0).all(), "it is drawn back before the middle"
    window = {"rocker": 0.028 if asset.parameters["plate"] == "square" else 0.0335}
    arm = {"toggle": 0.0290, "stop": 1.0} | window
    assert -joint.detent_torque(over).min() == pytest.approx(asset.parameters["force"] * arm[style], rel=0.2)


@pytest.mark.parametrize("gangs", [1, 2, 3])
def test_rockers_stand_side_by_side(gangs: int) -> None:
    asset = made(4, style="rocker", plate="square", gangs=gangs)
    middles = [np.mean([each[0] for each in asset.link(f"rocker_{n}").bounds()]) for n in range(gangs)]
    assert np.diff(middles) == pytest.approx([0.056 / gangs] * (gangs - 1), abs=1e-6)
