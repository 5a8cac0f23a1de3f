"""Sources of the assets of a task: folders, lists, seeds; and errors for unsuitable ones."""

import numpy as np
import pytest

import artgen
from artgen.dataset import Dataset, Plan, generate_many
from artgen.envs.task import Assets
from artgen.errors import EnvError, ExportError
from support.manipulation import PULL


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    place = tmp_path_factory.mktemp("assets") / "mixed"
    plan = Plan(("drawer", "plier"), 3, formats=("mjcf",), textures="none", certify=False)
    generate_many(plan, place, jobs=1)
    return place


def test_the_assets_of_the_category_are_used_from_a_folder(folder):
    for source in (folder, str(folder), Dataset(folder)):
        assets = Assets(PULL, source)
        assert list(assets.keys) == [0, 1]
        assert [assets.load(key).category for key in assets.keys] == ["drawer", "drawer"]


def test_a_range_contains_seeds():
    assets = Assets(PULL, range(4, 10, 2))
    assert assets.load(6).seed == 6
    assert {assets.draw(np.random.default_rng(number)) for number in range(50)} == {4, 6, 8}
    with pytest.raises(EnvError, match="Pull has no asset 5; the numbers are 4 to 8"):
        assets.load(5)


def test_without_assets_any_seed_can_be_drawn():
    assets = Assets(PULL)
    rng = np.random.default_rng(0)
    assert len({assets.draw(rng) for _ in range(50)}) == 50
    assert assets.load(1_234_567).seed == 1_234_567


def test_listed_assets_are_used_unchanged():
    asset = PULL.generate(3)
    assert Assets(PULL, [asset]).load(0) is asset


def test_equal_assets_have_one_cache_entry():
    first, second = Assets(PULL, range(5)), Assets(PULL, range(3, 9))
    assert first.identity(3) == second.identity(3)
    asset, other = PULL.generate(3), PULL.generate(3)
    assert Assets(PULL, [asset]).identity(0) != Assets(PULL, [other]).identity(0)


def test_a_folder_without_the_category_is_refused(folder):
    only = Dataset(folder).filter("plier")
    with pytest.raises(
        EnvError, match=r"Pull needs assets of the category 'drawer', but .* holds assets of plier"
    ):
        Assets(PULL, only)


def test_an_empty_folder_is_refused(tmp_path):
    with pytest.raises(ExportError, match="holds no dataset; `artgen generate CATEGORY -n 100` makes one"):
        Assets(PULL, tmp_path)


@pytest.mark.parametrize("source", [[], range(0)])
def test_no_assets_are_refused(source):
    with pytest.raises(EnvError, match="Pull got no assets: give a folder, assets or a range of seeds"):
        Assets(PULL, source)


def test_negative_seeds_are_refused():
    with pytest.raises(EnvError, match="seeds must be >= 0"):
        Assets(PULL, range(-2, 3))


def test_assets_of_another_category_are_refused():
    plier = artgen.generate("plier", 1, certify=False)
    with pytest.raises(EnvError, match=r"needs assets of the category 'drawer', but 'plier_1' is of 'plier'"):
        Assets(PULL, [plier])


@pytest.mark.parametrize("source", [[7], ["drawer_0"], 7])
def test_other_values_than_assets_are_errors(source):
    with pytest.raises(EnvError, match="give a folder, assets, a range of seeds, or None"):
        Assets(PULL, source)
