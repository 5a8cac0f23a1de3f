"""Distributions: values that are checked when they are made and draw within their support."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from artgen.errors import ParameterError
from artgen.sampling import (
    Distribution,
    Fixed,
    by,
    choice,
    count,
    loguniform,
    stream,
    truncated_normal,
    uniform,
)

FINITE = st.floats(-1e9, 1e9, allow_nan=False)
PAIRS = st.tuples(FINITE, FINITE).map(sorted)


def draws(distribution, number=300, given_=None):
    return [distribution.draw(stream(seed, "test/x"), given_ or {}) for seed in range(number)]


@given(ends=PAIRS, seed=st.integers(0, 2**32))
def test_uniform_stays_within_its_ends(ends, seed):
    low, high = ends
    value = uniform(low, high).draw(stream(seed, "x"), {})
    assert type(value) is float
    assert low <= value <= high


@given(ends=st.tuples(st.floats(1e-6, 1e6), st.floats(1e-6, 1e6)).map(sorted), seed=st.integers(0, 2**32))
def test_loguniform_stays_within_its_ends(ends, seed):
    assert ends[0] <= loguniform(*ends).draw(stream(seed, "x"), {}) <= ends[1]


@given(ends=PAIRS, share=st.floats(0, 1), deviation=st.floats(1e-6, 1e6), seed=st.integers(0, 2**32))
def test_normal_stays_within_its_ends(ends, share, deviation, seed):
    low, high = ends
    mean = min(max(low + (high - low) * share, low), high)
    assert low <= truncated_normal(mean, deviation, low, high).draw(stream(seed, "x"), {}) <= high


def test_uniform_covers_its_range_evenly():
    values = np.sort(draws(uniform(2.0, 4.0)))
    assert np.abs(values - np.linspace(2.0, 4.0, len(values))).max() < 0.2


def test_loguniform_is_even_in_ratios():
    values = np.sort(np.log10(draws(loguniform(0.01, 100.0))))
    assert np.abs(values - np.linspace(-2.0, 2.0, len(values))).max() < 0.4


def test_normal_is_a_bell_cut_off_at_its_ends():
    values = np.array(draws(truncated_normal(1.0, 0.1, 0.85, 1.3), 1000))
    assert abs(np.median(values) - 1.0) < 0.02
    assert np.mean(np.abs(values - 1.0) < 0.1) == pytest.approx(0.68 / 0.932, abs=0.05)
    assert len(set(values)) == len(values), "nothing piles up at the cut"


def test_choice_keeps_to_its_weights():
    values = draws(choice("a", "b", "c", "d", weights=(0, 3, 1, 0)), 600)
    assert set(values) == {"b", "c"}
    assert values.count("b") / 600 == pytest.approx(0.75, abs=0.06)


def test_a_mapping_has_the_options_with_their_weights():
    assert choice({"lever": 0.7, "knob": 0.3}) == choice("lever", "knob", weights=(0.7, 0.3))
    cases = by("style", round={"lever": 1, "knob": 3}, otherwise="knob")
    assert cases.case("round") == choice("lever", "knob", weights=(1, 3))
    with pytest.raises(ParameterError, match="choice takes the weights from its mapping"):
        choice({"lever": 1.0}, weights=(1.0,))


def test_choice_is_even_without_weights():
    values = draws(choice(10, 20, 30), 600)
    assert all(values.count(option) / 600 == pytest.approx(1 / 3, abs=0.06) for option in (10, 20, 30))


def test_count_includes_both_ends():
    assert set(draws(count(2, 5))) == {2, 3, 4, 5}


def test_by_draws_from_the_chosen_case():
    made = by("layout", french=uniform(0.8, 0.9), single=0.5, otherwise=count(3, 3))
    assert all(0.8 <= value <= 0.9 for value in draws(made, 20, {"layout": "french"}))
    assert draws(made, 3, {"layout": "single"}) == [0.5] * 3
    assert draws(made, 3, {"layout": "other"}) == [3] * 3
    assert made.needs() == ("layout",)


def test_by_takes_values_that_are_no_identifiers():
    made = by("doors", {1: uniform(0.5, 0.6), 2: uniform(0.9, 1.0)})
    assert draws(made, 1, {"doors": 2})[0] >= 0.9
    assert draws(by("open", {True: 1.0, False: 2.0}), 1, {"open": False}) == [2.0]
    with pytest.raises(ParameterError, match=r"has no case for True"):
        made.draw(stream(0, "x"), {"doors": True})


def test_by_nests_and_tells_what_it_needs():
    made = by("a", x=by("b", u=1.0, v=uniform(5.0, 6.0)), y=2.0)
    assert made.needs() == ("a", "b")
    assert draws(made, 1, {"a": "x", "b": "u"}) == [1.0]
    assert draws(made, 1, {"a": "y", "b": "u"}) == [2.0]


def test_by_without_the_case_names_the_nearest():
    with pytest.raises(
        ParameterError, match=r"by\('layout', ...\) has no case for 'frensh'\. Did you mean 'french'\?"
    ):
        by("layout", french=1.0, single=2.0).draw(stream(0, "x"), {"layout": "frensh"})


@pytest.mark.parametrize(
    ("distribution", "support", "numeric", "discrete"),
    [
        (uniform(1.0, 2.0), (1.0, 2.0), True, False),
        (loguniform(1.0, 2.0), (1.0, 2.0), True, False),
        (truncated_normal(1.5, 0.1, 1.0, 2.0), (1.0, 2.0), True, False),
        (choice("a", "b"), ("a", "b"), False, True),
        (choice(True, False), (True, False), False, True),
        (count(1, 3), (1, 2, 3), True, True),
        (Fixed(value=5), (5,), True, True),
        (by("a", x=uniform(1.0, 2.0), y=uniform(5.0, 6.0)), (1.0, 6.0), True, False),
        (by("a", x="p", y=choice("p", "q")), ("p", "q"), False, False),
        (by("a", x=uniform(1.0, 2.0), y=7), (1.0, 2.0, 7), True, False),
    ],
)
def test_what_a_distribution_may_give(distribution, support, numeric, discrete):
    assert distribution.support() == support
    assert distribution.numeric is numeric
    assert distribution.discrete is discrete


@pytest.mark.parametrize(
    ("distribution", "spelled"),
    [
        (uniform(0.75, 1.05, "m"), "uniform(0.75, 1.05)"),
        (truncated_normal(1.0, 0.1, 0.5, 1.5), "truncated_normal(1, 0.1, 0.5, 1.5)"),
        (loguniform(1, 10), "loguniform(1, 10)"),
        (choice("a", 2), "choice('a', 2)"),
        (by("layout", french=uniform(1, 2), single=3), "by('layout', french=uniform(1, 2), single=3)"),
    ],
)
def test_distributions_are_spelled_as_they_are_written(distribution, spelled):
    assert repr(distribution) == spelled


def test_distributions_are_values():
    assert uniform(1, 2, "m") == uniform(1.0, 2.0, "m")
    assert uniform(1, 2, "m") != uniform(1, 2, "rad")
    with pytest.raises(AttributeError):
        uniform(1, 2).low = 0.0


def test_unit_doc_and_limits_are_kept():
    made = uniform(0.8, 1.2, "m", doc="how high", within=(0.3, 2))
    assert (made.unit, made.doc, made.within) == ("m", "how high", (0.3, 2.0))
    assert isinstance(made, Distribution)


def test_hard_limits_hold_for_overrides_but_the_support_does_not():
    made = uniform(0.8, 1.2, "m", within=(0.3, 2.0))
    made.check("height", 1.9)
    made.check("height", uniform(0.3, 2.0))
    uniform(0.8, 1.2).check("height", 99.0)
    with pytest.raises(ParameterError, match=r"height = 2\.1 is out of range: 0\.3 to 2 m is allowed"):
        made.check("height", 2.1)
    with pytest.raises(
        ParameterError, match=r"height = uniform\(0\.5, 3\) is out of range: 0\.3 to 2 m is allowed"
    ):
        made.check("height", uniform(0.5, 3.0))


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: uniform("a", 1), "uniform: low must be a finite number, got 'a'"),
        (lambda: uniform(0, math.inf), "uniform: high must be a finite number, got inf"),
        (lambda: uniform(True, 1), "uniform: low must be a finite number, got True"),
        (lambda: uniform(2, 1), r"uniform\(2, 1\): low exceeds high; swap them"),
        (lambda: loguniform(0, 1), r"loguniform\(0, 1\): needs 0 < low <= high"),
        (lambda: loguniform(2, 1), r"needs 0 < low <= high"),
        (lambda: truncated_normal(0, 0, -1, 1), "truncated_normal: deviation must be positive, got 0"),
        (lambda: truncated_normal(5, 1, -1, 1), "the mean 5 must lie between low -1 and high 1"),
        (lambda: truncated_normal(0, math.nan, -1, 1), "deviation must be a finite number, got nan"),
        (choice, "choice needs at least one option"),
        (lambda: choice("a", "b", weights=(1,)), "2 options need as many weights"),
        (lambda: choice("a", "b", weights=(1, -1)), "none negative"),
        (lambda: choice("a", "b", weights=3), "2 options need as many weights"),
        (lambda: by("style", ["a", "b"]), r"by\('style'\): the cases must be a mapping from its values, got"),
        (lambda: choice("a", "b", weights=(0, 0)), "not all 0"),
        (lambda: choice("a", "b", weights=(1, math.nan)), "a weight must be a finite number, got nan"),
        (lambda: choice(uniform(0, 1), 2), r"the option uniform\(0, 1\) is a distribution; .* by\(...\)"),
        (lambda: count(1, 2.5), r"count: bounds must be whole numbers, got 2\.5"),
        (lambda: count(True, 2), "count: bounds must be whole numbers, got True"),
        (lambda: count(3, 2), r"count\(3, 2\): low exceeds high; swap them"),
        (lambda: by("layout"), r"by\('layout'\) needs a distribution for each value of 'layout'"),
        (
            lambda: by("a", x=uniform(0, 1, within=(0, 1))),
            r"by\('a', x=...\): .* give within=... to by itself",
        ),
        (lambda: uniform(0, 1, within=(2, 0)), r"within=\(2, 0\) has low above high; swap them"),
        (lambda: uniform(0, 1, within=3), r"within must be a pair of numbers \(low, high\), got 3"),
        (lambda: uniform(0, 1, within=(0, 1, 2)), "within must be a pair of numbers"),
        (lambda: uniform(0, 1, within=(0, "a")), "within must be a finite number, got 'a'"),
        (lambda: uniform(0, 5, within=(0, 3)), r"uniform\(0, 5\) may give 5\.0, outside within=\(0, 3\)"),
        (lambda: count(0, 5, within=(1, 9)), r"may give 0, outside within=\(1, 9\)"),
        (
            lambda: choice("a", within=(0, 1)),
            r"choice\('a'\): within limits numbers, and not all of these are",
        ),
        (lambda: by("a", x=uniform(0, 5), within=(0, 3)), r"may give 5\.0, outside within"),
    ],
)
def test_impossible_distributions_are_refused_when_they_are_written(make, message):
    with pytest.raises(ParameterError, match=message):
        make()
