"""Overrides that do not act are not among the parameters of an asset."""

from dataclasses import replace
from typing import Any, Literal

import pytest

from artgen import Body, Bool, Float, box, by, choice, generator, part, switch, uniform
from artgen import material as material_of

OAK = material_of("oak")


@generator
def inert_block(
    *,
    style: Literal["plain", "tall"] = choice("plain", "tall"),
    extra: Float = uniform(0.1, 0.2, "m"),
    doubled: Bool = choice(False, True),
    factor: Float = uniform(2.0, 3.0),
    size: Float = by("style", plain=0.1, tall=uniform(0.2, 0.3)),
    knob: bool = choice(False, True),
    unused: Literal["a", "b"] = choice("a", "b"),
) -> Body:
    """Make a block; `extra` acts on tall ones, and `knob` on tall ones only."""
    height = size + extra if style == "tall" else size
    width = switch(doubled, factor * size, size)
    solid = box(width, size, height + (0.05 if knob and style == "tall" else 0.0))
    return part(solid, "block", OAK)


@pytest.mark.parametrize(
    ("overrides", "absent"),
    [
        ({"style": "tall", "extra": 0.15}, set()),
        ({"style": "plain", "extra": 0.15}, {"extra"}),
        ({"style": "plain", "extra": uniform(0.1, 0.15)}, {"extra"}),
        ({"style": "tall", "doubled": False, "factor": 2.5}, {"factor"}),  # of a switch, one branch acts
        ({"style": "tall", "doubled": True, "factor": 2.5}, set()),
        ({"style": "plain", "knob": True}, {"knob"}),
        ({"style": "tall", "knob": True}, set()),
        ({"unused": "b"}, {"unused"}),
    ],
)
def test_an_asset_records_only_overrides_that_act(overrides: dict[str, Any], absent: set[str]) -> None:
    asset = inert_block.generate(0, **overrides)
    assert set(inert_block.own) - set(asset.parameters) == absent


def test_without_overrides_every_draw_is_recorded() -> None:
    assert set(inert_block.generate(0, certify=False).parameters) == set(inert_block.own)


def test_a_value_beside_the_only_one_of_a_style_acts() -> None:
    assert inert_block.generate(0, style="plain", size=0.25).parameters["size"] == 0.25


def test_graphs_of_other_options_are_made_when_the_parameters_are_first_read(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    graphs: list[Any] = []
    fold = inert_block._folded
    monkeypatch.setattr(inert_block, "_folded", lambda values: graphs.append(fold(values)) or graphs[-1])
    asset = inert_block.generate(0, style="tall", unused="b", certify="later")
    assert len(graphs) == 1
    assert "parameters" in dir(asset)
    assert replace(asset, name="other").parameters == asset.parameters
    assert len(graphs) == 3  # one for the other value of each override
    assert "unused" not in asset.parameters
    assert len(graphs) == 3
