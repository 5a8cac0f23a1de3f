"""An override of a category acts, or it is refused, or the asset does not record it."""

from typing import Any

import numpy as np
import pytest

import artgen
from artgen import ArtgenError, ParameterError, catalog
from artgen.generator.parameter import Variant
from artgen.graph.handle import folding

CASES = 2  # parameters of each category


def graph(category: Any, overrides: dict[str, Any]) -> str:
    """Return the key of the graph of a sample; empty if the sample is refused."""
    try:
        with folding():
            return str(category.build(category.sample(0, overrides=overrides)).node.key)
    except ArtgenError:
        return ""


@pytest.mark.parametrize("name", catalog.categories())
def test_an_override_acts_or_is_refused_or_absent(name: str) -> None:
    category = catalog.find(name)
    for parameter in np.random.default_rng(len(name)).permutation(sorted(category.own))[:CASES]:
        drawn = category.sample(0)[parameter]
        options = [each for each in category.own[parameter].options if not isinstance(each, Variant)]
        given = next((each for each in reversed(options) if each != drawn), drawn)
        made = graph(category, {parameter: given})
        if made and given != drawn and parameter not in category.inert(0, overrides={parameter: given}):
            others = {graph(category, {parameter: each}) for each in [drawn, *options[:4]] if each != given}
            assert others - {made, ""}, f"{parameter} = {given!r} changes nothing"


def test_another_value_than_the_only_one_is_refused_with_the_deciding_parameter() -> None:
    with pytest.raises(ParameterError) as refused:
        artgen.generate("refrigerator", layout="single", water=True)
    assert str(refused.value) == (
        "water = True is not allowed with layout = 'single': it must be False; "
        "set layout to 'french' or 'side_by_side' as well"
    )


def test_the_only_value_and_values_of_other_cases_are_allowed() -> None:
    refrigerator = catalog.find("refrigerator")
    assert refrigerator.sample(0, overrides={"layout": "single", "water": False})["water"] is False
    assert refrigerator.sample(0, overrides={"layout": "french", "water": True})["water"] is True


def test_a_sub_generator_other_than_that_of_the_grip_is_refused() -> None:
    with pytest.raises(ParameterError, match="handle = 'bar_pull' is not allowed with grip = 'knob'"):
        catalog.find("cabinet").sample(0, overrides={"grip": "knob", "handle": "bar_pull"})
