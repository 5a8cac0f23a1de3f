"""Overrides written as text."""

import contextlib
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from artgen.errors import ParameterError
from artgen.generator.overrides import DISTRIBUTIONS, parse_overrides, parse_value, spelled
from artgen.sampling import choice, count, loguniform, truncated_normal, uniform


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1.05", 1.05),
        ("-2", -2),
        ("1e-3", 1e-3),
        ("true", True),
        ("False", False),
        ("left", "left"),
        ("'two words'", "two words"),
        ("satin-nickel", "satin-nickel"),
        ("0.8 to 0.9", "0.8 to 0.9"),
        ("uniform(0.8, 0.9)", uniform(0.8, 0.9)),
        ("truncated_normal(0.9, .02, low=.8, high=1)", truncated_normal(0.9, 0.02, 0.8, 1.0)),
        ("loguniform(1, 10)", loguniform(1, 10)),
        ("choice(left, right, weights=(1, 2))", choice("left", "right", weights=(1, 2))),
        ("count(2, 4)", count(2, 4)),
    ],
)
def test_values(text: str, value: Any) -> None:
    parsed = parse_value(text)
    assert parsed == value
    assert type(parsed) is type(value)


@given(st.one_of(st.floats(allow_nan=False, allow_infinity=False), st.integers(), st.booleans()))
def test_what_python_prints_reads_back(value: float) -> None:
    assert parse_overrides([f"width={value!r}"]) == {"width": value}


@given(st.text())
def test_any_text_is_a_value_or_a_clear_refusal(text: str) -> None:
    with contextlib.suppress(ParameterError):  # and nothing else
        parse_value(text)


def test_names_may_be_dotted() -> None:
    assert parse_overrides(["handle.length = 0.1", "handle__curl=2"]) == {
        "handle.length": 0.1,
        "handle.curl": 2,
    }


@pytest.mark.parametrize(
    ("texts", "message"),
    [
        (["width"], "'width' is no override; write NAME=VALUE, such as width=0.9"),
        (["=1"], "'=1' is no override"),
        (["width="], "'width=' is no override"),
        (["width=1", "width=2"], "width is set twice"),
        (["width=unifrm(1, 2)"], "width: there is no distribution 'unifrm'. Did you mean 'uniform'"),
        (["width=uniform(2, 1)"], r"width: uniform\(2, 1\): low exceeds high"),
        (["width=uniform(1)"], r"width = uniform\(1\) cannot be read: .*'high'"),
        (["width=uniform(a, 1)"], "width: uniform: low must be a finite number, got 'a'"),
        (["width=uniform(x.y, 1)"], "x.y is neither a number nor a word"),
        (["width=uniform(**{'low': 1})"], "cannot be read"),
    ],
)
def test_refusals(texts: list[str], message: str) -> None:
    with pytest.raises(ParameterError, match=message):
        parse_overrides(texts)


@pytest.mark.parametrize(
    "text", ["__import__('os').system('exit')", "open('x', 'w')", "uniform(open('x', 'w'), 1)"]
)
def test_no_code_runs(text: str, tmp_path: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    with pytest.raises(ParameterError, match=r"distribution|neither"):
        parse_value(text)
    assert not list(tmp_path.iterdir())


def test_every_distribution_of_numbers_can_be_spelled() -> None:
    assert set(DISTRIBUTIONS) == {"choice", "count", "loguniform", "truncated_normal", "uniform"}


@given(
    st.dictionaries(st.from_regex(r"[a-z]+(\.[a-z]+)?", fullmatch=True), st.one_of(st.text(), st.integers()))
)
def test_what_is_spelled_reads_back(overrides: dict[str, Any]) -> None:
    read = parse_overrides(spelled(overrides))
    assert read == overrides
    assert [type(value) for value in read.values()] == [type(value) for value in overrides.values()]


@pytest.mark.parametrize(
    ("value", "text"),
    [
        ("left", "hand=left"),
        ("8", "hand='8'"),
        ("", "hand=''"),
        ("True", "hand='True'"),
        ("uniform(0, 1)", "hand='uniform(0, 1)'"),
        (" left", "hand=' left'"),
        (True, "hand=True"),
        (0.1, "hand=0.1"),
    ],
)
def test_strings_are_quoted_where_they_would_be_read_as_something_else(value: Any, text: str) -> None:
    assert spelled({"hand": value}) == [text]
