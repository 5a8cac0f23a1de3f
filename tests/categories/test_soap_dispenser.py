"""What is special to soap dispensers: a nozzle that is pressed and turned, its spring, and what is inside."""

import math
from functools import lru_cache
from typing import Any, get_args

import pytest

from artgen import InfeasibleError
from artgen.asset import Asset, Link
from artgen.categories.soap_dispenser import soap_dispenser
from artgen.categories.soap_dispenser.bottles import Shape
from artgen.categories.soap_dispenser.pumps import Nozzle
from artgen.graph import Cache
from artgen.validate.colliders import check_colliders

OPAQUE = ("round", "square", "oval", "hexagonal", "amphora", "cone", "bell", "ribbed", "beehive")
CLEAR = ("round", "square", "cube", "hexagonal", "cone", "bell", "apothecary")


@lru_cache(maxsize=64)
def _drawn(seed: int, more: tuple[tuple[str, Any], ...]) -> Asset:
    return soap_dispenser.generate(seed, cache=Cache(), certify=False, **dict(more))


def drawn(seed: int, **more: Any) -> Asset:
    return _drawn(seed, tuple(more.items()))


def link(asset: Asset, name: str) -> Link:
    return next(each for each in asset.links if each.name == name)


@pytest.mark.parametrize("nozzle", get_args(Nozzle))
def test_a_nozzle_slides_and_turns_between_one_pair_of_links(nozzle: str) -> None:
    asset = drawn(1, style="bottle", shape="round", build="ceramic", nozzle=nozzle)
    assert [each.name for each in asset.links] == ["body", "nozzle"]
    slide, turn = asset.joint("nozzle_slide"), asset.joint("nozzle_turn")
    assert slide.limits is not None
    assert 0.012 <= slide.limits[1] <= 0.020
    assert slide.axis.tolist() == [0.0, 0.0, -1.0]
    assert turn.limits is None
    pressed = asset.pose({"nozzle_slide": slide.limits[1], "nozzle_turn": math.pi})["nozzle"]
    assert pressed[2, 3] == pytest.approx(-slide.limits[1])
    assert pressed[:2, :2].round(9).tolist() == [[-1.0, 0.0], [0.0, -1.0]]


def test_the_spring_lifts_the_nozzle_and_a_finger_can_press_it() -> None:
    for seed in range(6):
        asset = drawn(seed, style="bottle")
        slide = asset.joint("nozzle_slide")
        assert slide.limits is not None
        up, down = (slide.stiffness * (q - slide.rest) for q in slide.limits)
        weight = 9.81 * link(asset, "nozzle").mass_properties.mass
        assert up > weight + slide.friction, f"seed {seed}: its spring holds {up:.1f} N"
        assert 8.0 <= down + slide.friction <= 25.0


@pytest.mark.parametrize("nozzle", get_args(Nozzle))
def test_a_pressed_nozzle_keeps_off_the_bottle_all_round(nozzle: str) -> None:
    asset = drawn(2, style="bottle", shape="square", build="plastic", nozzle=nozzle, travel=0.02)
    for angle in (0.0, math.pi / 4.0, math.pi):
        gap = min(asset.clearance({"nozzle_slide": 0.02, "nozzle_turn": angle}).values())
        assert gap > 0.0003


@pytest.mark.parametrize("shape", CLEAR)
def test_a_clear_bottle_has_soap_and_a_dip_tube_in_a_hollow(shape: str) -> None:
    asset = drawn(3, style="bottle", shape=shape, build="clear")
    body = asset.links[0]
    soap = next(each for each in body.pieces if each.label == "soap")
    tube = next(each for each in body.pieces if each.label == "dip_tube")
    assert soap.shape.bounds()[1, 2] < 0.8 * float(asset.parameters["height"])
    assert tube.shape.bounds()[0, 2] < 0.01, "the tube does not reach the last of the soap"
    glass = sum(
        each.shape.manifold.volume() for each in body.pieces if each.label == "body" and not each.visual
    )
    assert glass < 0.7 * soap.shape.manifold.volume(), "the glass is not hollow"


@pytest.mark.parametrize("shape", [each for each in get_args(Shape) if each in OPAQUE])
def test_a_bottle_weighs_what_it_holds(shape: str) -> None:
    for seed in range(2):
        mass = drawn(seed, style="bottle", shape=shape).mass
        assert 0.2 <= mass <= 0.9, f"{shape} {seed} weighs {mass:.2f} kg"


def test_what_hangs_on_a_wall_comes_with_its_tile() -> None:
    held = drawn(4, style="holder")
    assert {"tile", "holder"} <= set(held.links[0].labels)
    assert held.joint("nozzle_turn").limits is None, "the nozzle strikes the wall"
    button = drawn(4, style="box", press="button").joint("button_slide")
    assert button.limits is not None
    assert button.axis.tolist() == [0.0, 1.0, 0.0]
    lever = drawn(4, style="box", press="lever").joint("lever_hinge")
    assert lever.limits is not None
    assert lever.stiffness * (0.0 - lever.rest) > 2.0 * lever.friction, "its spring does not bring it back"


@pytest.mark.parametrize(
    ("shape", "width"), [("round", 0.058), ("apothecary", 0.087), ("bell", 0.087), ("cone", 0.095)]
)
@pytest.mark.long
def test_colliders_follow_the_glass_of_narrow_and_wide_bottles(shape: str, width: float) -> None:
    asset = drawn(3, style="bottle", shape=shape, build="clear", width=width, height=0.13, fill=0.45)
    assert check_colliders(asset).faults == ()


def test_glass_is_not_blown_wider_than_colliders_follow_it() -> None:
    wide = {"style": "bottle", "build": "clear", "width": 0.095}
    with pytest.raises(InfeasibleError, match=r"take a width of 0\.087 at most, shape=cone or another build"):
        drawn(3, shape="round", attempts=1, **wide)
    assert drawn(3, shape="square", **wide).links
