"""Similar samples."""

import numpy as np
import pytest
from surveys.alike import SAME, Likeness, difference, likenesses, look, same_neighbors

from artgen import Body, box, choice, generator, material, part
from artgen.catalog import find

pytest.importorskip("embreex")


@pytest.fixture(scope="module")
def looks() -> list[np.ndarray]:
    category = find("handle")
    return [look(category.generate(seed, certify=False)) for seed in (0, 1, 2)]


def test_a_sample_looks_like_itself(looks) -> None:
    for one in looks:
        assert one.shape[-1] == 4
        assert one[..., 3].any(axis=(1, 2)).all()
        assert difference(one, one) == 0.0


def test_others_look_different_in_the_same_measure_both_ways(looks) -> None:
    for one, other in ((0, 1), (1, 2), (0, 2)):
        apart = difference(looks[one], looks[other])
        assert SAME < apart <= 1.0
        assert difference(looks[other], looks[one]) == pytest.approx(apart)


def test_a_slightly_wider_sample_is_the_same_product() -> None:
    category = find("handle")
    given = {"kind": "lever", "rose_style": "round", "lock": "none", "handle__style": "straight"}
    one, other = (
        look(category.generate(5, certify=False, **given, rose_across=across)) for across in (0.060, 0.062)
    )
    assert 0.0 < difference(one, other) < SAME / 4.0


def test_color_alone_makes_a_difference() -> None:
    category = find("handle")
    one, other = (look(category.generate(5, certify=False, leaf=wood)) for wood in ("oak", "walnut"))
    assert difference(one, other) > SAME


def test_a_failed_sample_is_omitted() -> None:
    @generator
    def lucky(*, lucky: bool = choice(False, True)) -> Body:
        return part(box(0.1, 0.1, 0.1 if lucky else -0.1), "block", material("oak"))

    made = [seed for seed in range(8) if lucky.sample(seed)["lucky"]]
    assert 2 <= len(made) < 8
    pairs = likenesses(lucky, range(8))
    assert {seed for pair in pairs for seed in pair.seeds} == set(made)
    assert all(pair.difference == 0.0 for pair in pairs)


def test_the_most_alike_come_first_and_neighbors_are_marked() -> None:
    found = likenesses(find("handle"), [0, 0, 1, 5])  # the same seed twice is one sample
    assert len(found) == 3
    assert [each.difference for each in found] == sorted(each.difference for each in found)
    assert {each.seeds for each in found if each.near} == {(0, 1), (1, 5)}
    assert same_neighbors([Likeness((0, 1), 0.01, near=True), Likeness((0, 2), 0.0, near=False)]) == [
        Likeness((0, 1), 0.01, near=True)
    ]
