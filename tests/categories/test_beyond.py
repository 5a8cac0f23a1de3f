"""What a category cannot build is ruled out by a requirement that names the parameter, not by a failure."""

from typing import Any

import pytest

from artgen.catalog import find
from artgen.errors import InfeasibleError

HANDLES = [
    (
        "cabinet",
        {"grip": "knob", "handle": "bar_pull"},
        "handle=bar_pull belongs to grip=bar, not to grip=knob",
    ),
    ("drawer", {"grip": "bar", "handle": "groove_pull"}, "handle=groove_pull belongs to grip=groove"),
    ("door", {"opener": "none", "handle": "knob_handle"}, "set opener as well, or leave handle out"),
    ("handle", {"inside": "knob", "handle": "lever_handle"}, "handle=lever_handle belongs to inside=lever"),
]

LIMITS = [
    ("box", {"style": "slotted", "aspect": 1.0}, "lower aspect, to 0.96 at most"),
    ("box", {"style": "slotted", "mouth": "ends", "height": 0.04}, "height at least 0.06 m"),
    ("box", {"style": "wine", "wine": "red", "height": 0.3}, "height at least 0.315 m"),
    ("cabinet", {"kind": "tall", "height": 0.55}, "a tall cabinet is at least 1 m high: raise height"),
    ("dishwasher", {"handle": "recessed", "door_thickness": 0.05}, "door_thickness over 0.051 m"),
    ("door", {"layout": "double", "frame": "arched"}, "frame must be jambs or full"),
    ("drawer", {"stand": "plinth", "stand_height": 0.005}, "stand_height over 0.02 m"),
    ("drawer", {"grip": "bar", "handle.length": 0.9}, "lower handle.length"),
    ("cabinet", {"kind": "base", "grip": "bar", "handle.length": 0.32}, "lower handle.length"),
    ("drawer", {"style": "fielded"}, "style=fielded is for doors"),
    ("faucet", {"style": "bridge", "spout": "beam"}, "spout=beam does not go with style=bridge"),
    ("faucet", {"style": "vessel", "spout": "arc"}, "spout=arc does not go with style=vessel"),
    (
        "faucet",
        {"style": "gooseneck", "spout": "low"},
        "spout=low hangs before a wall, not on style=gooseneck",
    ),
    ("faucet", {"style": "wall", "spout": "low", "rod": True}, "rod must be False"),
    ("microwave", {"key_shape": "round"}, "key_shape must be bar, square or pill"),
    (
        "microwave",
        {"controls": "dials", "keys": 6, "height": 0.25, "face": "banded", "show": "9:41", "handle": "none"},
        "raise height, or lower keys, dials or dial_radius",
    ),
    ("toaster", {"style": "retro", "tray": "side"}, "tray must be back"),
    ("toaster", {"length": 0.25, "slot_length": 0.28}, "length 0.05 m over slot_length"),
    ("window", {"style": "awning", "opens": "inwards"}, "style=awning has opens=outwards only"),
    (
        "window",
        {"style": "awning", "opens": "outwards", "shutters": "boarded"},
        "shutters=boarded: they must be none",
    ),
]


@pytest.mark.parametrize(("name", "given", "message"), HANDLES + LIMITS)
def test_what_cannot_be_built_is_ruled_out(name: str, given: dict[str, Any], message: str) -> None:
    with pytest.raises(InfeasibleError) as caught:
        find(name).generate(1, attempts=1, certify=False, **given)
    assert message in str(caught.value)


@pytest.mark.parametrize(
    ("name", "given"),
    [
        ("box", {"style": "slotted", "mouth": "ends", "size": "medium", "height": 0.06}),
        ("box", {"style": "wine", "wine": "red", "height": 0.315}),
        ("cabinet", {"kind": "tall", "height": 1.0}),
        ("drawer", {"stand": "plinth", "stand_height": 0.0201}),
        ("toaster", {"length": 0.301, "slot_length": 0.25}),
    ],
)
def test_what_is_just_allowed_is_proven(name: str, given: dict[str, Any]) -> None:
    asset = find(name).generate(1, attempts=1, on_collision="fail", **given)
    assert asset.certificate is not None
    assert asset.certificate.proven


@pytest.mark.parametrize(
    ("name", "option", "handle"), [("cabinet", "grip", "cup_pull"), ("handle", "inside", "knob_handle")]
)
def test_a_handle_brings_the_draws_that_suit_it(name: str, option: str, handle: str) -> None:
    """Without the option, other draws are made until one has the option that brings the handle."""
    for seed in range(3):
        asset = find(name).generate(seed, certify=False, handle=handle)
        assert asset.parameters["handle"] == handle
        assert handle.startswith(str(asset.parameters[option]))
