"""An override of a category acts, or it is refused, or the asset does not record it."""

from typing import Any

import numpy as np
import pytest

import artgen
from artgen import ArtgenError, catalog
from artgen.generator.parameter import Variant
from artgen.graph.handle import folding
from support.cases import some

CASES = 2  # parameters of each category


def graph(category: Any, overrides: dict[str, Any]) -> str:
    """Return the key of the graph of a sample; empty if the sample is refused."""
    try:
        with folding():
            return str(category.build(category.sample(0, overrides=overrides)).node.key)
    except ArtgenError:
        return ""


@pytest.mark.parametrize("name", some(catalog.categories(), 2))
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


def test_a_dispenser_that_is_asked_for_is_there_and_a_bow_of_a_flat_front_is_not_claimed() -> None:
    plain, wet = (
        artgen.generate("refrigerator", layout="single", water=water, certify=False)
        for water in (False, True)
    )
    assert len(wet.links["door"].details) > len(plain.links["door"].details)
    flat = artgen.generate(
        "refrigerator", layout="single", form="flat", look="white", bow=0.012, certify=False
    )
    assert (wet.parameters["water"], "bow" in flat.parameters) == (True, False)
