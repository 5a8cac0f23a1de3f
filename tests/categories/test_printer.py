"""What is special to a printer: paper in cassettes, a lid that stays, a panel that tilts with its keys."""

from functools import lru_cache
from typing import Any

import pytest

from artgen.asset import Asset
from artgen.catalog import find
from support.release import released


@lru_cache(maxsize=32)
def made(seed: int, **given: Any) -> Asset:
    return find("printer").generate(seed, certify=False, **given)


@pytest.mark.parametrize("style", ["inkjet", "laser", "multi"])
def test_sheets_of_a4_lie_in_each_cassette(style: str) -> None:
    asset = made(1, style=style, cassettes=2)
    for number in range(2):
        paper = [p.shape.bounds() for p in asset.link(f"cassette_{number}").pieces if p.label == "paper"]
        size = paper[0][1] - paper[0][0]
        assert sorted(size[:2]) == pytest.approx([0.210, 0.297], abs=1e-6)
        body = asset.link("body").bounds()
        assert (body[0] < paper[0][0]).all(), "the paper of a closed cassette is inside of the body"
        assert (paper[0][1] < body[1]).all()


@pytest.mark.parametrize("feeder", [False, True])
def test_the_lid_of_a_scanner_stays_where_it_is(feeder: bool) -> None:  # noqa: FBT001
    asset = made(2, style="multi", feeder=feeder)
    for angle in (0.2, 0.7, 1.1):
        assert released(asset, "lid_hinge", angle) == pytest.approx(angle, abs=0.02)


def test_keys_spring_back_in_a_tilted_panel() -> None:
    asset = made(3, style="inkjet", keys=3)
    assert {asset.joint(f"button_slide_{number}").parent for number in range(3)} == {"panel"}
    assert released(asset, "panel_tilt", 0.6) == pytest.approx(0.6, abs=0.02)
    assert released(asset, "button_slide_1", 0.002) == pytest.approx(0.0, abs=2e-4)


def test_a_plain_printer_has_its_keys_in_the_body_and_no_lid() -> None:
    asset = made(4, style="laser", keys=4)
    assert {asset.joint(f"button_slide_{number}").parent for number in range(4)} == {"body"}
    assert not {"lid", "panel"} & set(asset.links.names)
