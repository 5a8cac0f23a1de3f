"""What is special to a bottle: threads, the bore of a stopper, springs, sizes and masses."""

import math
from functools import lru_cache
from typing import Any

import pytest

from artgen.asset import Asset
from artgen.catalog import find
from artgen.nodes.fitting import FIT

STYLES = ("screw", "jar", "flip", "pump", "stopper", "trigger")


@lru_cache(maxsize=12)
def made(seed: int, **given: Any) -> Asset:
    return find("bottle").generate(seed, on_collision="fail", **given)


@pytest.mark.parametrize(("style", "name", "pitch"), [("screw", "cap", 0.0027), ("jar", "lid", 0.0080)])
def test_a_cap_rises_by_the_pitch_of_its_thread(style: str, name: str, pitch: float) -> None:
    asset = made(1, style=style)
    turn = asset.joint(f"{name}_turn")
    assert turn.limits is not None
    end = turn.limits[1]
    assert end == pytest.approx(math.tau * asset.parameters["turns"])
    rise = asset.pose({turn.name: end})[name][2, 3] - asset.pose({turn.name: 0.0})[name][2, 3]
    assert rise == pytest.approx(pitch * end / math.tau, rel=1e-9)
    assert asset.valid_states.dofs == (turn.name,)


def test_a_stopper_has_a_sliding_fit_in_its_bore_and_lifts_out() -> None:
    asset = made(2, style="stopper")
    closed, lifted = (asset.clearance({"stopper_lift": z})["body", "stopper"] for z in (0.0, 0.06))
    assert closed == pytest.approx(FIT.sliding, abs=5e-5)
    assert lifted > 0.02
    assert asset.joint("stopper_lift").friction > 9.81 * asset.link("stopper").mass_properties.mass


@pytest.mark.parametrize(("style", "joint"), [("pump", "nozzle_slide"), ("trigger", "trigger_pull")])
def test_a_spring_returns_what_a_hand_presses(style: str, joint: str) -> None:
    found = made(3, style=style).joint(joint)
    assert found.stiffness > 0.0
    assert found.rest < 0.0
    assert found.friction < -found.rest * found.stiffness, "its preload overcomes its friction"


@pytest.mark.parametrize("style", STYLES)
def test_sizes_and_masses_are_those_of_full_bottles(style: str) -> None:
    asset = made(4, style=style)
    low, high = asset.bounds()
    width, height = asset.parameters["width"], high[2] - low[2]
    assert high[0] - low[0] == pytest.approx(width, abs=0.003)
    litres = math.pi / 4 * width**2 * height * 1000
    assert 0.45 <= asset.mass / litres <= 1.3
    assert asset.link("body").mass_properties.mass > 0.9 * asset.mass


def test_a_label_names_the_contents() -> None:
    printed = made(1, style="screw", label=True).link("body").labels
    bare = made(1, style="screw", label=False).link("body").labels
    assert set(printed) - set(bare) == {"label", "print"}
