"""The category `toaster`: the carriage rides with the lever, springs return, sizes are right."""

import math
from itertools import product
from typing import get_args

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from artgen import Asset, InfeasibleError
from artgen.categories.shared.controls import ButtonShape, DialStyle
from artgen.categories.toaster import toaster
from artgen.categories.toaster.inside import LeverStyle
from artgen.categories.toaster.plan import BodyStyle
from artgen.graph import Cache

STYLES = get_args(BodyStyle)
BRIEF = settings(max_examples=6, deadline=None)
seeds = st.integers(0, 10_000)


def made(seed: int, **overrides: object) -> Asset:
    return toaster.generate(seed, cache=Cache(), certify=False, **overrides)


def lever_joints(asset: Asset) -> list[str]:
    return [joint.name for joint in asset.free_joints if joint.name.startswith("lever_slide")]


@pytest.mark.parametrize("style", STYLES)
def test_every_style_is_proven_free_of_collisions(style: str) -> None:
    asset = toaster.generate(4, cache=Cache(), on_collision="fail", style=style, buttons=4)
    assert asset.certificate is not None
    assert asset.certificate.proven
    assert max(len(link.colliders) for link in asset.links) <= 64


@pytest.mark.parametrize(
    ("slots", "levers", "size"), [(1, 1, "long"), (2, 2, "long"), (4, 1, "short"), (4, 2, "short")]
)
def test_a_carriage_goes_through_the_slots_with_its_lever(slots: int, levers: int, size: str) -> None:
    asset = made(1, slots=slots, levers=levers, slot_size=size, style="box")
    names = lever_joints(asset)
    assert len(names) == levers
    for name in names:
        joint = asset.joint(name)
        assert joint.limits is not None
        carried = [piece for piece in asset.link(joint.child).pieces if piece.label == "carriage"]
        assert carried
        lowered = asset.pose({name: joint.limits[1]})[joint.child]
        np.testing.assert_allclose(lowered[:3, 3], (0.0, 0.0, -joint.limits[1]), atol=1e-9)
        # a rail along each of its slots, over the crumb tray even at the bottom
        low, high = asset.link(joint.child).bounds()
        assert high[1] - low[1] > asset.parameters["slot_length"]
        tray = asset.link("crumb_tray")
        inside = max(piece.shape.bounds()[1, 2] for piece in tray.pieces if "tin" in piece.material.name)
        assert min(piece.shape.bounds()[0, 2] for piece in carried) - joint.limits[1] > inside + 0.002


def test_the_spring_carries_the_lever_and_takes_a_plausible_force() -> None:
    for seed in range(5):
        asset = made(seed)
        for name in lever_joints(asset):
            joint = asset.joint(name)
            assert joint.limits is not None
            weight = 9.81 * asset.link(joint.child).mass_properties.mass
            at_rest = -joint.stiffness * joint.rest
            at_bottom = joint.stiffness * (joint.limits[1] - joint.rest)
            assert at_rest > weight + joint.friction + 1.0  # it stands up, and comes up
            assert 10.0 <= at_bottom <= 25.0
            carried = at_bottom / 9.81
            assert joint.damping > 0.6 * math.sqrt(joint.stiffness * carried * 0.1)  # it does not bounce on


def test_buttons_and_dials_need_the_force_of_a_finger() -> None:
    asset = made(2, buttons=3, levers=1, knobs=1)
    for number in range(3):
        joint = asset.joint(f"button_slide_{number}")
        assert joint.limits == (0.0, pytest.approx(0.003))
        assert 2.0 <= joint.stiffness * (0.003 - joint.rest) <= 4.0
    knob = asset.joint("knob_turn")
    assert knob.limits == pytest.approx((-2.4, 2.4))
    assert 0.03 <= knob.friction <= 0.06


@pytest.mark.parametrize("buttons", range(5))
def test_any_number_of_buttons_is_named_in_order(buttons: int) -> None:
    names = sorted(link.name for link in made(3, buttons=buttons, knobs=1).links if link.label == "button")
    assert names == (["button"] if buttons == 1 else [f"button_{number}" for number in range(buttons)])


@BRIEF
@given(seed=seeds, style=st.sampled_from(STYLES), slots=st.sampled_from([1, 2, 4]))
def test_sizes_are_those_of_toasters(seed: int, style: str, slots: int) -> None:
    asset = made(seed, style=style, slots=slots)
    body = [piece for piece in asset.links[0].pieces if piece.label == "body"]
    corners = np.concatenate([piece.shape.bounds() for piece in body])
    size = np.ptp(corners, axis=0)
    long, wide = (size[0], size[1]) if asset.parameters["controls"] == "side" else (size[1], size[0])
    assert 0.25 <= long <= 0.40
    assert 0.148 <= wide <= 0.322
    assert 0.178 <= corners[:, 2].max() <= 0.222
    assert 1.0 <= asset.mass_properties().mass <= 3.5


@BRIEF
@given(
    seed=seeds,
    lever=st.sampled_from(get_args(LeverStyle)),
    knob=st.sampled_from(get_args(DialStyle)),
    shape=st.sampled_from(get_args(ButtonShape)),
)
def test_every_lever_dial_and_button_goes_with_every_seed(
    seed: int, lever: str, knob: str, shape: str
) -> None:
    asset = made(seed, lever_style=lever, knob_style=knob, button_shape=shape)
    for link in asset.links[1:]:
        assert link.grasps or link.pushes


@pytest.mark.parametrize(("way", "tray"), [*product(("end", "side"), ("back", "side"))])
def test_the_crumb_tray_slides_out_level_where_it_says(way: str, tray: str) -> None:
    asset = made(6, style="steel", levers=1, controls=way, tray=tray)
    axis = asset.joint("crumb_tray_slide").axis
    backwards = (way == "end") == (tray == "back")  # a quarter turn takes the end of the slots to a side
    expected = (0.0, 1.0, 0.0) if backwards else ((1.0, 0.0, 0.0) if way == "end" else (-1.0, 0.0, 0.0))
    np.testing.assert_allclose(axis, expected, atol=1e-9)


def test_buttons_need_a_front_as_wide_as_they_stand() -> None:
    narrow = {"style": "classic", "slots": 1, "slot_width": 0.03, "levers": 1, "layout": "below"}
    keys = {"knobs": 0, "buttons": 2, "knob_radius": 0.015}
    with pytest.raises(InfeasibleError, match="controls have no room: raise height or shoulder"):
        made(4, shoulder=0.044, attempts=1, **narrow, **keys)
    pressed = {"button_slide_0": 0.003, "button_slide_1": 0.003}
    assert min(made(4, shoulder=0.0446, **narrow, **keys).clearance(pressed).values()) > 0.0
    assert made(4, shoulder=0.044, **narrow, **{**keys, "knobs": 1, "buttons": 0}).attempt == 0


def test_controls_on_a_bulging_side_are_refused() -> None:
    with pytest.raises(InfeasibleError, match="the sides of this style are not flat: controls must be end"):
        made(0, style="retro", controls="side", levers=1)
    with pytest.raises(InfeasibleError, match="two levers need the narrow end: controls must be end"):
        made(0, style="steel", slots=4, controls="side", levers=2)


def test_more_levers_than_slots_and_more_knobs_than_levers_are_refused() -> None:
    with pytest.raises(InfeasibleError, match="one slot has one lever: levers must be 1"):
        made(0, slots=1, levers=2)
    with pytest.raises(InfeasibleError, match="a lever has at most one knob: knobs must be at most levers"):
        made(0, slots=2, levers=1, knobs=2)
