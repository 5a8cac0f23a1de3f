"""`check_category`: sound categories pass, and each way to be unsound is told with seed and parameters."""

import itertools
import re
from typing import Literal

import pytest

from artgen import testing
from artgen.errors import ParameterError
from artgen.generator import Generator, generator
from artgen.graph import Graph
from artgen.materials import material
from artgen.nodes.body import part
from artgen.nodes.handles import Body, Float
from artgen.nodes.primitive import box
from artgen.nodes.scalar import require
from artgen.sampling import choice, uniform
from artgen.testing import check_category
from support.exports import stand
from support.generators import door
from support.lines import place_of

OAK = material("oak")
TREE = ("files", "tree")


def failure(*arguments, **options) -> str:
    with pytest.raises(AssertionError) as failed:
        check_category(*arguments, **options)
    return str(failed.value)


def test_a_sound_generator_passes():
    check_category(stand, seeds=range(2))


@pytest.mark.parametrize("name", ["handle"])
@pytest.mark.long
def test_a_category_is_found_by_its_name(name):
    check_category(name, seeds=[3], checks=["files", "tree", "certificate"])


def test_a_collision_is_told_with_seed_parameters_and_place():
    text = failure(stand, seeds=[4, 5], overrides={"gap": -0.001}, checks=["certificate"])
    assert text.startswith("stand: 2 of 2 seeds fail\nseed 4:\n  certificate: link ")
    assert "seed 5:" in text
    assert re.search(r"they collide: \w+ presses [\d.]+ mm into \w+ at \(", text)
    assert re.search(r"\n  with .*gap=-0.001", text)
    assert "travel=0.2" in text


def test_a_sample_that_collides_fails_unless_it_may_be_drawn_again():
    wide = {"gap": uniform(-0.004, 0.004)}
    seeds = [seed for seed in range(12) if stand.sample(seed, overrides=wide)["gap"] < 0][:2]
    assert "2 of 2 seeds fail" in failure(stand, seeds=seeds, overrides=wide, checks=["certificate"])
    check_category(stand, seeds=seeds, overrides=wide, checks=["certificate"], on_collision="redraw")


def test_a_number_of_joints_that_is_not_declared_is_told():
    stool = Generator(stand.function, ("body", "drawer"), (2, 3))
    text = failure(stool, seeds=[1], checks=["tree"])
    assert "the asset has 1 joints, but @category(joints=(2, 3)) is declared" in text


def test_what_changes_from_run_to_run_is_told():
    calls = itertools.count()

    @generator
    def restless() -> Body:
        return part(box(0.1 + 0.01 * next(calls), 0.1, 0.1), "box", OAK)  # grows

    text = failure(restless, seeds=[0], checks=TREE)
    assert "same seed, same bytes: generated again, the asset is another" in text
    line = place_of(__file__, "grows")
    assert (
        f"source: the same seed gives another asset when it is built again; box at {line} differs: x" in text
    )


def test_nothing_is_remembered_between_the_two_runs(monkeypatch):
    caches = []
    evaluate = Generator.evaluate

    def recorded(self, seed, *, cache=None, **options):
        caches.append(cache)
        return evaluate(self, seed, cache=cache, **options)

    monkeypatch.setattr(Generator, "evaluate", recorded)
    check_category(stand, seeds=[0, 1], checks=TREE)
    assert [cache is None for cache in caches] == [True, False, True, False]
    assert caches[1] is not caches[3]


def test_samples_that_were_drawn_again_pass():
    @generator
    def picky(*, size: Literal["small", "large"] = choice("small", "large")) -> Body:
        require(size == "large", "too small")
        return part(box(0.1, 0.1, 0.1), "box", OAK)

    again = [seed for seed in range(8) if picky.generate(seed, certify=False).attempt > 0]
    assert again
    check_category(picky, seeds=again, checks=TREE)


def test_a_label_that_is_not_declared_is_told():
    def shelf(*, width: Float = uniform(0.1, 0.2)) -> Body:
        return part(box(width, 0.1, 0.1), "shelf", OAK)

    text = failure(Generator(shelf, labels=("sheld",)), seeds=[2], checks=TREE)
    assert "seed 2:\n  generate: link 'shelf' carries the label 'shelf', which shelf does not declare" in text
    assert "\n  with width=0.1" in text


def test_a_category_without_feasible_samples_is_told():
    @generator
    def never(*, width: Float = uniform(0.1, 0.2)) -> Body:
        return part(box(require(width, width > 1, "too narrow"), 0.1, 0.1), "shelf", OAK)

    assert "generate: never: every draw fails alike (25 were tried for seed 0): " in failure(never, [0])


def test_a_graph_that_json_changes_is_told(monkeypatch):
    other = door.graph(0)
    monkeypatch.setattr(Graph, "from_json", staticmethod(lambda text: other))
    text = failure(stand, seeds=[0], checks=TREE)
    assert "graph round trip: the graph that was read back from JSON is another" in text


def test_the_checks_that_are_asked_for_run(monkeypatch):
    asked = []

    def validate(asset, **options):
        asked.append(options)
        return real(asset, checks=["files"])

    real = testing.category.validate
    monkeypatch.setattr(testing.category, "validate", validate)
    check_category(stand, seeds=[0], checks=TREE)
    check_category(stand, seeds=[0], behavior=True)
    assert asked == [{"behavior": False, "checks": TREE}, {"behavior": True, "checks": None}]


def test_an_authors_mistake_keeps_its_traceback_and_names_the_seed():
    @generator
    def broken() -> Body:
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError) as raised:
        check_category(broken, seeds=[6])
    assert raised.value.__notes__ == ["while checking broken, seed 6"]


@pytest.mark.parametrize(
    ("arguments", "options", "message"),
    [
        (["dor"], {}, r"there is no category 'dor'\. Did you mean 'door'"),
        ([3], {}, "a generator or the name of a category is needed, got 3"),
        ([stand, []], {}, r"check_category\(stand\): seeds is empty, so nothing would be checked"),
        ([stand], {"checks": ["tre"]}, r"there is no check 'tre'\. Did you mean 'tree'"),
        ([stand], {"overrides": {"gpa": 0.1}}, "stand has no parameter 'gpa'. Did you mean 'gap'"),
    ],
)
def test_wrong_use_is_an_error_not_a_failure(arguments, options, message):
    with pytest.raises(ParameterError, match=message):
        check_category(*arguments, **options)
