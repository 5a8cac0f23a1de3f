"""What a category cannot build is ruled out by a requirement that names the parameter, not by a failure."""

from typing import Any

import pytest

from artgen.catalog import find
from artgen.errors import InfeasibleError
from artgen.validate.colliders import check_colliders
from artgen.validate.solids import check_solids

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
    ("window", {"style": "sliding", "layout": "single"}, "layout of style=sliding must be pair or row"),
    ("box", {"style": "slotted", "mouth": "top", "aspect": 1.0}, "aspect must be <= 0.96"),
    ("box", {"style": "slotted", "mouth": "ends", "height": 0.04}, "height must be >= 0.06 m"),
    ("box", {"style": "tuck_end", "height": 0.04}, "height must be >= 0.1 m"),
    ("box", {"style": "tray", "width": 0.08}, "need room: width must be >= 0.14 m"),
    ("box", {"style": "mailer", "width": 0.08}, "need room: width must be >= 0.15 m"),
    (
        "box",
        {"style": "wine", "wine": "red", "height": 0.3},
        "would collide with the lid over them: raise height",
    ),
    ("cabinet", {"stand": "feet"}, "stand must be plinth, legs or brackets"),
    ("cabinet", {"kind": "tall", "height": 0.55}, "height of a tall cabinet must be >= 1 m"),
    (
        "cooktop",
        {"dial_radius": 0.028, "dial_pitch": 0.055},
        "dials would touch each other: raise dial_pitch",
    ),
    ("dishwasher", {"handle": "recessed", "door_thickness": 0.05}, "door_thickness must be > 0.051 m"),
    ("door", {"layout": "double", "frame": "arched"}, "frame must be jambs or full"),
    ("drawer", {"stand": "plinth", "stand_height": 0.005}, "stand_height of a plinth must be > 0.02 m"),
    ("drawer", {"stand": "legs", "stand_height": 0.005}, "stand_height of legs must be > 0.05 m"),
    ("stapler", {"style": "full", "width": 0.016}, "width of a full stapler must be >= 0.03 m"),
    ("drawer", {"kind": "kitchen", "rows": 5, "height": 0.42}, "raise height, or lower rows or stand_height"),
    ("drawer", {"grip": "bar", "handle.length": 0.9}, "lower handle.length"),
    ("cabinet", {"kind": "base", "grip": "bar", "handle.length": 0.32}, "lower handle.length"),
    ("drawer", {"style": "fielded"}, "style=fielded is for doors"),
    ("faucet", {"style": "bridge", "spout": "beam"}, "spout=beam is not allowed with style=bridge"),
    ("faucet", {"style": "vessel", "spout": "arc"}, "spout=arc is not allowed with style=vessel"),
    (
        "faucet",
        {"style": "gooseneck", "spout": "low"},
        "spout=low is for style=wall, not for style=gooseneck",
    ),
    ("faucet", {"style": "wall", "spout": "low", "rod": True}, "rod must be False"),
    (
        "faucet",
        {"style": "pull_down", "spout": "gooseneck", "reach": 0.08, "lever_length": 0.07},
        "swings past the lever: reach must exceed lever_length by 0.045 m",
    ),
    ("faucet", {"style": "pull_down", "spout": "gooseneck", "girth": 0.009}, "girth must be > 0.0104 m"),
    ("lamp", {"style": "reading", "shade_radius": 0.26}, "lower shade_radius, or raise arm_length"),
    ("microwave", {"key_shape": "round"}, "key_shape must be bar, square or pill"),
    (
        "microwave",
        {"controls": "dials", "keys": 6, "height": 0.25, "face": "banded", "show": "9:41", "handle": "none"},
        "raise height, or lower keys, dials or dial_radius",
    ),
    ("oven", {"build": "built_in", "drawer": True}, "drawer must be False"),
    ("oven", {"build": "range", "burners": 0}, "burners must be 4 or 5"),
    ("cooktop", {"burner": "coil", "burners": 6}, "at most 5 coils have room"),
    ("blender", {"style": "retro", "control": "buttons"}, "control must be dial"),
    ("toaster", {"levers": 2, "layout": "beside"}, "layout must be below"),
    ("faucet", {"style": "widespread", "spout": "arc", "height": 0.12}, "the arc bends too tightly"),
    ("safe", {"style": "home", "handle": "spokes", "width": 0.36}, "width must be >= 0.42 m"),
    ("chair", {"style": "folding", "height": 0.6}, "height must be <= 0.47 m"),
    ("pot", {"style": "pan", "width": 0.2, "tall": 0.19}, "the lid meets the handle of a low pot"),
    ("sink", {"style": "vessel", "hollow": 0.2, "height": 0.2}, "the tap of a vessel must be 0.034 m higher"),
    ("oven", {"build": "range", "height": 0.59}, "height of a range must be >= 0.8 m"),
    (
        "pepper_grinder",
        {"style": "barrel", "top": "bulb", "height": 0.12, "head_height": 1.8, "diameter": 0.07},
        "raise height, or lower head_height",
    ),
    (
        "pepper_grinder",
        {"style": "classic", "top": "ball", "head_height": 0.6},
        "head_height must be >= 0.91",
    ),
    ("plier", {"style": "slip_joint", "opening": 0.2}, "opening must be >= 0.41"),
    ("plier", {"length": 0.12, "handle_width": 0.012}, "lower handle_width, or raise length or spread"),
    (
        "refrigerator",
        {"layout": "french", "outer_drawers": 2, "freezer_share": 0.2},
        "raise freezer_share or height, or lower outer_drawers or kick_height",
    ),
    (
        "refrigerator",
        {"layout": "side_by_side", "shelf_kind": "wire", "shelves": 4, "freezer_shelves": 4},
        "shelves + freezer_shelves must be <= 6",
    ),
    (
        "soap_dispenser",
        {"style": "holder", "shape": "amphora", "build": "steel"},
        "must be round or apothecary",
    ),
    (
        "soap_dispenser",
        {"style": "holder", "shape": "round", "build": "clear", "fill": 0.2},
        "fill must be >= 0.28",
    ),
    ("toaster", {"slots": 1, "controls": "end", "layout": "beside", "shoulder": 0.034}, "have no room"),
    ("toaster", {"style": "retro", "tray": "side"}, "tray must be back"),
    ("toaster", {"length": 0.25, "slot_length": 0.28}, "length must exceed slot_length by 0.05 m"),
    ("trashcan", {"style": "ball", "width": 0.285, "height": 0.24}, "raise height, or lower width or aspect"),
    ("trashcan", {"style": "butterfly", "carry": "bail"}, "strike a bail: carry must be loop"),
    (
        "window",
        {"style": "sliding", "layout": "single", "slides": "one", "width": 1.2},
        "layout of style=sliding must be pair or row",
    ),
    ("window", {"style": "sliding", "layout": "row", "width": 0.4}, "width must be >= 1 m"),
    (
        "window",
        {"style": "awning", "opens": "inwards"},
        "opens=inwards is not allowed with style=awning: opens must be outwards",
    ),
    (
        "window",
        {"style": "awning", "opens": "outwards", "shutters": "boarded"},
        "shutters=boarded: shutters must be none",
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


SOUND = [
    ("handle", {"inside": "knob", "handle.style": "ball", "handle.radius": 0.04, "rose_depth": 0.014}),
    ("pepper_grinder", {"top": "crank", "build": "wood", "knob_radius": 0.016}),
    (
        "plier",
        {
            "style": "needle_nose",
            "length": 0.14,
            "handle_width": 0.0104,
            "handle_share": 0.66,
            "grips": "bare",
        },
    ),
    ("soap_dispenser", {"style": "box", "press": "button", "box_depth": 0.06, "travel": 0.0202}),
    ("window", {"style": "double_hung", "shutters": "louvred", "width": 0.4}),
]


@pytest.mark.parametrize(("name", "given"), SOUND, ids=[name for name, _ in SOUND])
def test_what_is_at_the_end_of_its_range_is_built(name: str, given: dict[str, Any]) -> None:
    asset = find(name).generate(1, attempts=1, **given)  # proven, or it fails
    assert check_colliders(asset).faults == ()
    assert check_solids(asset).faults == ()
