"""Every category, over seeds: a new one is tested by being in the registry.

`ARTGEN_TEST_SEEDS=300 pytest tests/categories/test_registry.py` widens the range of seeds.
"""

import os
from contextlib import suppress
from functools import lru_cache
from itertools import combinations, product
from pathlib import Path

import numpy as np
import pytest
from surveys.coverage import coverage
from surveys.products import misfits

from artgen.asset import Asset
from artgen.catalog import categories, find
from artgen.errors import EvaluationError, InfeasibleError
from artgen.export import LAYOUTS
from artgen.graph import Cache, Graph
from artgen.sampling.choices import By
from artgen.validate.files import read_export
from artgen.validate.readback import check_formats
from support.agreement import check_formats_agree
from support.cases import some
from support.geometry import check_collider_pieces, check_colliders_cover, check_mass, check_solids
from support.joint_outline import joints_of

SEEDS = range(int(os.environ.get("ARTGEN_TEST_SEEDS", "1")))
cases = pytest.mark.parametrize(
    ("category", "seed"), [(category, seed) for category in categories() for seed in SEEDS]
)
# of what depends on common code more than on a category
some_cases = pytest.mark.parametrize(
    ("category", "seed"), some(((category, seed) for category in categories() for seed in SEEDS), 5)
)
# what takes longest: one fifth of the categories each
first_fifth, second_fifth, third_fifth = (
    pytest.mark.parametrize(
        ("category", "seed"),
        some(((category, seed) for category in categories() for seed in SEEDS), 5, start),
    )
    for start in range(3)
)


@lru_cache(maxsize=128)  # each test comes by every asset again
def asset_of(category: str, seed: int) -> Asset:
    return find(category).generate(seed)


@second_fifth
def test_solids_are_watertight_and_turned_outwards(category: str, seed: int) -> None:
    for link in asset_of(category, seed).links:
        check_solids(link)


@some_cases
def test_colliders_are_convex_and_within_budget(category: str, seed: int) -> None:
    for link in asset_of(category, seed).links:
        check_collider_pieces(link)


@some_cases
def test_colliders_contain_the_solids_and_leave_cavities_open(category: str, seed: int) -> None:
    for link in asset_of(category, seed).links:
        check_colliders_cover(link)


@some_cases
def test_mass_properties_match_an_independent_integration(category: str, seed: int) -> None:
    for link in asset_of(category, seed).links:
        check_mass(link)


@some_cases
def test_every_reader_finds_the_same_asset_in_every_format(category: str, seed: int, tmp_path: Path) -> None:
    asset = asset_of(category, seed)
    check_formats_agree(asset, asset.export(tmp_path / asset.name))


@cases
def test_an_asset_stands_on_the_ground_about_its_center(category: str, seed: int) -> None:
    low, high = asset_of(category, seed).bounds()
    assert low[2] == pytest.approx(0.0, abs=1e-6)
    base = asset_of(category, seed).links[0].bounds()
    assert base[:, 0].sum() == pytest.approx(0.0, abs=0.05 * (high[0] - low[0]))


@cases
def test_size_and_mass_are_those_of_a_product(category: str, seed: int) -> None:
    assert misfits(asset_of(category, seed)) == []


@some_cases
def test_an_asset_read_back_is_the_asset(category: str, seed: int, tmp_path: Path) -> None:
    asset = asset_of(category, seed)
    read = Asset.load(asset.export(tmp_path / asset.name, formats=("urdf",)))
    assert read.to_data() == asset.to_data()
    for name, pose in asset.pose().items():
        np.testing.assert_allclose(read.pose()[name], pose, atol=1e-11)


@some_cases
def test_a_graph_round_trips_through_json_and_source(category: str, seed: int) -> None:
    graph = find(category).graph(seed)
    assert Graph.from_json(graph.to_json()).key == graph.key
    namespace: dict[str, object] = {}
    exec(graph.to_python(), namespace)  # noqa: S102 - the source is our own
    assert Graph(namespace["build"]()).key == graph.key  # type: ignore[operator]


@cases
def test_a_graph_tells_the_joints_of_its_asset_before_it_is_made(category: str, seed: int) -> None:
    asset = asset_of(category, seed)
    if asset.attempt > 0:
        pytest.skip("the first draw was ruled out")
    planned = {joint.name: joint for joint in joints_of(find(category).graph(seed))}
    assert set(planned) == {joint.name for joint in asset.joints}
    for joint in asset.joints:
        leader = "" if joint.follows is None else joint.follows.leader
        told = planned[joint.name]
        assert (told.kind, told.follows, told.needs) == (joint.kind, leader, joint.needs is not None)
        assert told.unlimited == (joint.limits is None and joint.follows is None)


@cases
def test_every_declared_label_is_the_same_for_every_seed(category: str, seed: int) -> None:
    asset = asset_of(category, seed)
    assert asset.labels == find(category).labels
    assert {label for link in asset.links for label in link.labels} <= set(asset.labels)


@first_fifth
def test_every_check_passes_on_the_files(category: str, seed: int) -> None:
    report = asset_of(category, seed).validate()
    assert [result.check for result in report.results if result.skipped] == []
    assert report.passed, "\n".join(map(str, report.faults))


@cases
def test_the_proof_leaves_no_pair_out(category: str, seed: int) -> None:
    asset = asset_of(category, seed)
    certificate = asset.certificate
    assert certificate is not None
    assert certificate.proven, str(certificate)
    moving = {frozenset((a.name, b.name)) for a, b in combinations(asset.links, 2)}
    assert {frozenset(pair.links) for pair in certificate.pairs} == moving  # no link is locked to another


@third_fifth
def test_readers_find_the_asset_in_the_layouts_of_other_data_sets(
    category: str, seed: int, tmp_path: Path
) -> None:
    for layout in LAYOUTS.keys() - {"flat", "parts"}:
        folder = asset_of(category, seed).export(tmp_path / layout, layout=layout, textures=0, states=2)
        exported = read_export(folder)
        assert exported.asset is not None
        results = (exported.result, *check_formats(exported.asset, folder))
        assert [str(fault) for result in results for fault in result.faults] == [], layout


@pytest.mark.parametrize("category", categories())
def test_every_option_can_be_demanded_of_every_seed(category: str) -> None:
    generator = find(category)
    for seed, (name, parameter) in enumerate(generator.parameters().items()):
        short = ".".join(name.split(".")[::2])
        if parameter.structural and short in generator.sample(seed):
            for option in parameter.options:
                values = generator.sample(seed, overrides={short: option})
                # without the name, a generator without this parameter was chosen instead
                assert values.get(short, option) == option, (seed, short)


@pytest.mark.long
@pytest.mark.parametrize("category", categories())
def test_every_option_is_built_or_refused(category: str) -> None:
    generator = find(category)
    for name, parameter in generator.parameters().items():
        if not parameter.structural:
            continue
        short = ".".join(name.split(".")[::2])
        options = parameter.options[:: 1 + len(parameter.options) // 50]
        for seed, option in product(range(12), options):
            with suppress(InfeasibleError):  # another error names no remedy
                generator.graph(seed, **{short: option})


@pytest.mark.long
@pytest.mark.parametrize("category", categories())
def test_the_limits_of_every_number_are_made_or_refused(category: str) -> None:
    generator, faults = find(category), []
    for name, parameter in generator.own.items():
        made = parameter.distribution
        if parameter.structural or made.within is None:
            continue
        key = made.parameter if isinstance(made, By) else "style"
        options = [{key: each} for each in generator.own[key].options] if key in generator.own else [{}]
        for option, limit, seed in product(options, made.within, range(2)):
            given = {name: limit, **option}
            try:
                asset = generator.generate(seed, on_collision="keep", **given)
            except InfeasibleError:
                continue
            except EvaluationError as error:
                faults.append(f"seed {seed}, {given}: {error}")
                continue
            if not asset.certificate.proven:
                faults.append(f"seed {seed}, {given}: {asset.certificate.failures[0]}")
    assert not faults, "\n".join(faults)


@pytest.mark.parametrize("category", some(categories(), 3, 2))
def test_draws_have_every_option_and_fill_every_range(category: str) -> None:
    faults = coverage(find(category), 200).faults  # that is mostly enough
    assert faults == () or coverage(find(category), 500).faults == ()


@pytest.mark.parametrize("category", some(categories(), 5, 1))
def test_the_second_evaluation_runs_no_kernel(category: str) -> None:
    cache = Cache()
    find(category).evaluate(3, cache=cache)
    _, again = find(category).evaluate(3, cache=cache)
    assert sum(again.runs.values()) == 0


@pytest.mark.parametrize("category", categories())
def test_a_hand_can_take_hold_of_something(category: str) -> None:
    assert any(link.grasps for seed in range(2) for link in asset_of(category, seed).links[1:])
