"""Outputs of all categories: every output follows its controls, in every style, and so do files."""

import numpy as np
import pytest

import artgen
from artgen.asset.controller import Controller
from artgen.asset.valid_states import ValidStates
from artgen.validate.outputs import check_outputs, used
from support.cases import some

CATEGORIES = list(artgen.catalog.categories())
WORKING = 35
"""Least number of categories whose products do something."""


@pytest.mark.parametrize("category", CATEGORIES)
def test_outputs_follow_their_controls(category):
    asset = artgen.generate(category, seed=0, certify=False)
    assert [str(each) for each in check_outputs(asset).findings] == []


@pytest.mark.long
@pytest.mark.parametrize("category", CATEGORIES)
def test_outputs_follow_their_controls_in_many_assets(category):
    for seed in (1, *range(9000, 9040)):
        asset = artgen.generate(category, seed=seed, certify=False)
        assert [str(each) for each in check_outputs(asset).findings] == []


@pytest.mark.long
def test_most_products_with_controls_do_something():
    found = {
        name
        for name in CATEGORIES
        if any(artgen.generate(name, seed=seed, certify=False).outputs for seed in range(3))
    }
    assert len(found) >= WORKING, sorted(set(CATEGORIES) - found)


@pytest.mark.parametrize("category", some(CATEGORIES, 12))
def test_files_have_the_same_outputs(category, tmp_path):
    asset = artgen.generate(category, seed=1, certify=False).rounded()
    folder = asset.export(tmp_path / asset.name, formats=("urdf", "mjcf", "usd"), textures=0)
    for suffix in ("urdf", "xml", "usda"):
        states = ValidStates.read(folder / f"{asset.name}.{suffix}")
        own, read = asset.controller(3), Controller(states, 3)
        for q in np.split(asset.sample_states(60, seed=4), 20):
            expected, found = own.step(q, 0.4), read.step(q, 0.4)
            assert list(expected) == list(found) == [each.name for each in asset.outputs]
            for name, values in expected.items():
                assert found[name].tolist() == values.tolist(), name


def test_use_is_the_same_for_a_seed():
    lamp = artgen.generate("lamp", seed=3, certify=False)
    first, again = (used(lamp, lamp.outputs, seed=5) for _ in range(2))
    assert first.tolist() == again.tolist()
    assert used(lamp, lamp.outputs, seed=6).tolist() != first.tolist()
