"""What is special to a bucket: its capacity, a bail that swings over, handles that hang, full cans."""

import math
from functools import lru_cache
from typing import Any

import numpy as np
import pytest

from artgen.asset import Asset
from artgen.catalog import find
from support.release import released


@lru_cache(maxsize=32)
def made(seed: int, **given: Any) -> Asset:
    return find("bucket").generate(seed, certify=False, **given)


@pytest.mark.parametrize("style", ["household", "builder", "zinc", "wood", "cooler", "pail", "paint"])
def test_a_bucket_holds_its_capacity(style: str) -> None:
    for seed in range(4):
        asset, wall = made(seed, style=style), 0.015 if style == "wood" else 0.0
        vessel = [p.shape.bounds() for p in asset.link("bucket").pieces if p.label in ("bucket", "stave")]
        rim = max(float(bounds[1][1]) for bounds in vessel) - wall
        high = float(np.sort([bounds[1][2] for bounds in vessel])[len(vessel) // 2 if wall else -1])
        foot = asset.parameters["taper"] * (rim + wall) - wall
        liters = 1000 * math.pi / 3 * high * (rim**2 + rim * foot + foot**2)
        assert liters == pytest.approx(asset.parameters["litres"], rel=0.22), seed


@pytest.mark.parametrize("style", ["household", "zinc", "wood", "paint"])
def test_a_bail_falls_to_the_side_to_which_it_leans(style: str) -> None:
    asset = made(2, style=style)
    front, back = asset.joint("bail_swing").limits or (0.0, 0.0)
    upright = (front + back) / 2
    assert released(asset, "bail_swing", upright - 0.4, seconds=2.0) == pytest.approx(front, abs=0.02)
    assert released(asset, "bail_swing", upright + 0.4, seconds=2.0) == pytest.approx(back, abs=0.02)
    center = np.append(asset.link("bail").mass_properties.center, 1.0)
    assert (asset.pose({"bail_swing": upright})["bail"] @ center)[1] == pytest.approx(0.0, abs=1e-6)


@pytest.mark.parametrize("style", ["cooler", "pail"])
def test_handles_at_the_sides_hang(style: str) -> None:
    for side in ("right", "left"):
        assert released(made(1, style=style), f"handle_swing_{side}", 1.2, seconds=2.0) == pytest.approx(
            0.0, abs=0.15
        )


def test_a_can_of_paint_is_full_and_closed() -> None:
    for seed, liters in enumerate((1, 3, 5, 10)):
        asset = made(seed, style="paint", litres=liters)
        assert asset.mass == pytest.approx(1.35 * liters, rel=0.12) or liters == 1
        assert asset.mass < 1.6 * liters
        assert "lid_lift" not in asset.joints.names


def test_a_strap_is_of_the_plastic_of_its_grip() -> None:
    wire, strap = (made(3, style="household", bail=kind) for kind in ("wire", "strap"))
    for asset, alike in ((wire, False), (strap, True)):
        names = [piece.material.name for piece in asset.link("bail").pieces]
        assert (len(set(names)) == 1) == alike
