"""What is special to a telephone: lids and slides snap, a smartphone stays at any angle."""

from functools import lru_cache
from typing import Any

import numpy as np
import pytest

from artgen.asset import Asset
from artgen.catalog import find
from support.release import released

STYLES = ("flip", "slider", "bar", "fold", "desk")


@lru_cache(maxsize=16)
def made(seed: int, **given: Any) -> Asset:
    return find("phone").generate(seed, certify=False, **given)


def end_of(asset: Asset, name: str) -> float:
    return (asset.joint(name).limits or (0.0, 0.0))[1]


@pytest.mark.parametrize(("style", "name"), [("flip", "lid_hinge"), ("slider", "slide_up")])
def test_it_snaps_open_and_shut(style: str, name: str) -> None:
    asset = made(1, style=style)
    end = end_of(asset, name)
    for share, expected in ((0.3, 0.0), (0.7, 1.0)):
        assert released(asset, name, share * end) == pytest.approx(expected * end, abs=0.03 * end)


def test_a_smartphone_stays_at_any_angle_and_opens_flat() -> None:
    asset = made(2, style="fold", turn=3.1)
    for angle in (0.5, 1.6, 2.6):
        assert released(asset, "lid_hinge", angle) == pytest.approx(angle, abs=0.02)
    pose = asset.pose({"lid_hinge": 3.1})["lid"]
    low, high = asset.link("lid").bounds()
    face = asset.parameters["thick"]
    inner = (pose @ np.array([0.0, low[1], face + 0.0013, 1.0]))[2]
    assert inner == pytest.approx(face, abs=0.005), "the two halves of the screen are level"
    assert (pose @ np.array([0.0, low[1], high[2], 1.0]))[2] > 0.0


@pytest.mark.parametrize("style", STYLES)
def test_keys_spring_back(style: str) -> None:
    asset = made(3, style=style)
    names = [joint.name for joint in asset.joints if joint.name.endswith("_press")]
    names += [joint.name for joint in asset.joints if joint.name.startswith("key_press")]
    for name in (names[0], names[-1]):
        assert released(asset, name, end_of(asset, name)) == pytest.approx(0.0, abs=1e-4)


@pytest.mark.parametrize(("style", "count"), [("flip", 18), ("slider", 18), ("bar", 18), ("desk", 15)])
def test_it_has_the_keys_of_a_telephone(style: str, count: int) -> None:
    asset = made(4, style=style, **({"extra": 0} if style == "desk" else {}))
    assert sum(joint.name.startswith("key_press") for joint in asset.joints) == count


def test_an_open_slider_shows_its_digits() -> None:
    asset = made(5, style="slider")
    front = asset.link("slide").bounds()[0][1]
    rows = [asset.link(f"key_{number}").bounds() for number in (0, 9)]
    assert front < rows[1][0][1], "closed, they lie below the upper half"
    assert max(high[2] for _, high in rows) < asset.link("slide").bounds()[0][2]
    middle = rows[0].mean(axis=0)[1]
    assert front + end_of(asset, "slide_up") > middle + 0.009, "a finger reaches the first row"


def test_a_handset_lies_in_its_cradle_and_falls_back() -> None:
    asset = made(6, style="desk")
    assert 0.12 < asset.link("handset").mass_properties.mass < 0.21
    assert released(asset, "handset_lift", 0.05) == pytest.approx(0.0, abs=1e-3)
    assert asset.joint("handset_lift").axis[1] < -0.1, "it is lifted off a face that looks to the user"


@pytest.mark.parametrize(
    ("style", "size", "mass"),
    [
        ("flip", (0.100, 0.108), (0.085, 0.115)),
        ("slider", (0.098, 0.106), (0.10, 0.125)),
        ("bar", (0.116, 0.127), (0.075, 0.10)),
        ("fold", (0.083, 0.089), (0.17, 0.20)),
        ("desk", (0.20, 0.235), (0.6, 0.9)),
    ],
)
def test_sizes_and_masses_are_those_of_data_sheets(
    style: str, size: tuple[float, float], mass: tuple[float, float]
) -> None:
    for seed in range(3):
        asset = made(seed, style=style)
        low, high = asset.bounds()
        assert size[0] < high[1] - low[1] < size[1]
        assert mass[0] < asset.mass < mass[1]
