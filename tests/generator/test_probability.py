"""The probability of values and ranges among the draws of a generator."""

import re
from dataclasses import dataclass

import numpy as np
import pytest

from artgen import (
    Bool,
    Float,
    Generator,
    ParameterError,
    Solid,
    by,
    catalog,
    choice,
    count,
    generator,
    loguniform,
    one_of,
    sphere,
    truncated_normal,
    uniform,
)
from artgen.sampling import Distribution


@generator
def lever(*, length: Float = uniform(0.1, 0.2)) -> Solid:
    return sphere(length)


@generator
def knob() -> Solid:
    return sphere(0.02)


@generator
def made(
    *,
    style: str = choice({"french": 0.25, "single": 0.75}),
    doors: int = by("style", french=2, single=count(1, 2)),
    water: Bool = by("doors", {1: False, 2: choice({True: 0.6, False: 0.4})}),
    width: Float = by("style", french=uniform(0.8, 1.0), single=uniform(0.5, 0.7)),
    mass: Float = loguniform(1.0, 100.0),
    height: Float = truncated_normal(1.0, 0.1, 0.8, 1.2),
    handle: Generator = one_of(lever, knob),
) -> Solid:
    return sphere(width * mass * height)


EXACT = {
    "an option": ({"style": "french"}, 0.25),
    "several options": ({"style": choice("french", "single")}, 1.0),
    "an option that depends on another": ({"doors": 2}, 0.25 + 0.75 / 2),
    "a chain": ({"water": True}, (0.25 + 0.75 / 2) * 0.6),
    "True is not 1": ({"doors": 1, "water": True}, 0.0),
    "a range": ({"width": uniform(0.85, 0.9)}, 0.25 * 0.25),
    "a range across the cases": ({"width": uniform(0.6, 0.9)}, 0.25 * 0.5 + 0.75 * 0.5),
    "all together": ({"style": "french", "width": uniform(0.85, 0.95), "water": True}, 0.25 * 0.5 * 0.6),
    "a logarithmic range": ({"mass": uniform(10.0, 100.0)}, 0.5),
    "half of a bell": ({"height": uniform(1.0, 1.2)}, 0.5),
    "a generator": ({"handle": "lever"}, 0.5),
    "nothing": ({}, 1.0),
}


@pytest.mark.parametrize(("wanted", "share"), EXACT.values(), ids=EXACT)
def test_a_probability_is_exact(wanted: dict, share: float) -> None:
    found = made.probability(**wanted)
    assert found == pytest.approx(share)
    assert found.error == 0.0
    assert repr(found) == f"{share:.4g}"


def test_draws_agree_with_the_probability() -> None:
    door = catalog.find("refrigerator")
    wanted = {"layout": "french", "shelves": choice(2, 3), "crispers": 2}
    draws = [door.sample(seed) for seed in range(300)]
    hits = [d["layout"] == "french" and d["shelves"] in (2, 3) and d["crispers"] == 2 for d in draws]
    found = door.probability(**wanted)
    assert abs(np.mean(hits) - found) < 4.0 * (found * (1.0 - found) / len(draws)) ** 0.5


def test_a_parameter_of_a_sub_generator_is_estimated() -> None:
    found = made.probability(style="single", handle__length=uniform(0.1, 0.15))
    assert abs(found - 0.75 * 0.25) < 4.0 * found.error
    assert 0.01 < found.error < 0.03
    assert re.fullmatch(r"0\.\d+ \+- 0\.0\d+ \(estimated\)", repr(found))


def test_a_distribution_of_ones_own_is_estimated() -> None:
    @dataclass(frozen=True)
    class Square(Distribution):
        def draw(self, generator: np.random.Generator, given: dict) -> float:
            return float(generator.random() ** 2)

        def support(self) -> tuple[float, float]:
            return 0.0, 1.0

    @generator
    def odd(*, size: Float = Square()) -> Solid:  # type: ignore[assignment]
        return sphere(size)

    found = odd.probability(size=uniform(0.0, 0.25))
    assert abs(found - 0.5) < 4.0 * found.error


def test_a_single_number_of_a_range_is_refused() -> None:
    message = (
        r"width is drawn from uniform\(0.8, 1\): a single number has no probability; give a range, such as"
    )
    with pytest.raises(ParameterError, match=message):
        made.probability(width=0.9)


def test_an_unknown_name_is_refused() -> None:
    with pytest.raises(ParameterError, match=r"made has no parameter 'widht'. Did you mean 'width'"):
        made.probability(widht=uniform(0.8, 0.9))
