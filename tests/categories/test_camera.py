"""What is special to a camera: lenses that come out, levers and buttons that return, backs that stay."""

import math
from functools import lru_cache
from typing import Any

import numpy as np
import pytest

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.catalog import find
from artgen.view.camera import box_corners
from support.release import released


@lru_cache(maxsize=32)
def made(seed: int, **given: Any) -> Asset:
    return find("camera").generate(seed, certify=False, **given)


def extent(asset: Asset, link: str, **q: float) -> Array:
    """Return the lowest and the highest corner of a link [m]."""
    corners = box_corners(asset.link(link).bounds(), asset.pose(q)[link])
    return np.array([corners.min(axis=0), corners.max(axis=0)])


def front(asset: Asset, link: str, **q: float) -> float:
    """Return the position of the front of a link along y [m]."""
    return float(extent(asset, link, **q)[0][1])


@pytest.mark.parametrize(
    ("style", "joint", "reach"), [("reflex", "zoom_ring_turn", 0.25), ("film", "focus_ring_turn", 0.16)]
)
def test_the_front_of_a_lens_comes_out_as_its_ring_turns(style: str, joint: str, reach: float) -> None:
    asset = made(1, style=style)
    length = asset.parameters["length"]
    for share in (0.5, 1.0):
        out = front(asset, "barrel") - front(asset, "barrel", **{joint: share * math.pi / 2})
        assert out == pytest.approx(share * reach * length, rel=1e-3)


def test_a_compact_lens_comes_out_in_two_steps_from_a_flat_front() -> None:
    asset = made(2, style="compact")
    body = front(asset, "body")
    assert front(asset, "barrel") > body - 0.005
    for link, reach in (("sleeve", 0.0155), ("barrel", 0.0310)):
        out = front(asset, link) - front(asset, link, sleeve_slide=0.0155)
        assert out == pytest.approx(reach, abs=1e-6), link


@pytest.mark.parametrize(
    ("style", "joint", "start"),
    [("film", "lever_turn", 1.2), ("film", "shutter_slide", 0.002), ("instant", "shutter_slide", 0.002)],
)
def test_levers_and_buttons_spring_back(style: str, joint: str, start: float) -> None:
    assert released(made(3, style=style), joint, start) == pytest.approx(0.0, abs=1e-3)


@pytest.mark.parametrize(
    ("style", "joint", "angles"),
    [
        ("film", "back_hinge", (0.5, 1.5)),
        ("webcam", "head_tilt", (-0.25, 0.25)),
        ("webcam", "neck_turn", (0.5,)),
        ("instant", "flap_hinge", (0.7,)),
    ],
)
def test_friction_holds_backs_flaps_and_heads(style: str, joint: str, angles: tuple[float, ...]) -> None:
    for angle in angles:
        assert released(made(4, style=style), joint, angle) == pytest.approx(angle, abs=0.01)


def test_a_flash_snaps_to_its_ends() -> None:
    asset = made(5, style="reflex", popup=True)
    assert released(asset, "flash_hinge", 0.15) == pytest.approx(0.0, abs=0.05)
    assert released(asset, "flash_hinge", 0.55) == pytest.approx(0.7, abs=0.05)


def test_the_slider_covers_the_lens() -> None:
    asset = made(6, style="webcam")
    lens = asset.parameters["lens"]
    (_, end) = asset.joint("slider_slide").limits or (0.0, 0.0)
    for position, covered in ((0.0, False), (end, True)):
        low, high = extent(asset, "slider", slider_slide=position)
        assert (low[0] <= -lens and high[0] >= lens) == covered


def test_a_picture_leaves_its_slot_but_not_the_camera() -> None:
    asset = made(7, style="instant")
    body = front(asset, "body")
    low, high = extent(asset, "photo", photo_slide=0.055)
    assert low[1] < body - 0.045
    assert high[1] > body + 0.005
