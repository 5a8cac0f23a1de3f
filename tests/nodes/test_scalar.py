"""Numbers: what the graph computes is what Python computes."""

import math
import operator

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from artgen.errors import EvaluationError
from artgen.graph import evaluate
from artgen.nodes import scalar
from artgen.nodes.handles import Bool, Float

NUMBERS = st.floats(-1e4, 1e4, allow_nan=False)
A, B = Float.parameter("a"), Float.parameter("b")


def value(handle, a=0.0, b=0.0):
    return evaluate(handle, {"a": a, "b": b}).value


@given(a=NUMBERS, b=NUMBERS)
@pytest.mark.parametrize("operation", [operator.add, operator.sub, operator.mul])
def test_arithmetic_on_either_side(operation, a, b):
    expected = operation(a, b)
    assert value(operation(A, B), a, b) == expected
    assert value(operation(A, b), a) == expected
    assert value(operation(a, B), b=b) == expected


@given(a=NUMBERS, b=NUMBERS)
@pytest.mark.parametrize("operation", [operator.truediv, operator.mod])
def test_division(operation, a, b):
    assume(abs(b) > 1e-3)
    expected = operation(a, b)
    assert value(operation(A, B), a, b) == expected
    assert value(operation(a, B), b=b) == expected
    assert value(operation(A, b), a) == expected


@given(a=st.floats(0.1, 10), b=st.floats(-5, 5))
def test_powers(a, b):
    assert value(A**B, a, b) == value(a**B, b=b) == value(A**b, a) == a**b


@given(a=NUMBERS, b=NUMBERS)
@pytest.mark.parametrize("operation", [operator.lt, operator.gt, operator.le, operator.ge])
def test_comparisons_on_either_side(operation, a, b):
    assert isinstance(operation(A, B), Bool)
    assert value(operation(A, B), a, b) is operation(a, b)
    assert value(operation(a, B), b=b) is operation(a, b)
    assert value(operation(A, a), a) is operation(a, a)


@given(a=NUMBERS)
@pytest.mark.parametrize(
    ("made", "expected"),
    [
        (-A, operator.neg),
        (abs(A), abs),
        (scalar.sin(A), math.sin),
        (scalar.cos(A), math.cos),
        (scalar.tan(A), math.tan),
        (math.floor(A), math.floor),
        (round(A), round),
        (scalar.sqrt(abs(A)), lambda a: math.sqrt(abs(a))),
    ],
)
def test_functions_of_one_number(made, expected, a):
    assert value(made, a) == expected(a)
    assert type(value(made, a)) is float


@given(a=NUMBERS, b=NUMBERS)
def test_functions_of_two_numbers(a, b):
    assert value(scalar.min_(A, B), a, b) == min(a, b)
    assert value(scalar.max_(A, B), a, b) == max(a, b)
    assert value(scalar.atan2(A, B), a, b) == math.atan2(a, b)


@given(a=NUMBERS, ends=st.tuples(NUMBERS, NUMBERS).map(sorted))
def test_clamp_gives_the_nearest_number_within(a, ends):
    low, high = ends
    clamped = value(scalar.clamp(A, low, high), a)
    assert low <= clamped <= high
    assert abs(clamped - a) == max(low - a, a - high, 0.0)


@pytest.mark.parametrize("a", [True, False])
@pytest.mark.parametrize("b", [True, False])
def test_logic(a, b):
    x, y = A > 0.0, B > 0.0
    numbers = (float(a), float(b))
    assert value(x & y, *numbers) is (a and b)
    assert value(x | y, *numbers) is (a or b)
    assert value(~x, *numbers) is (not a)
    assert value(x & b, *numbers) is value(b & x, *numbers) is (a and b)
    assert value(b | x, *numbers) is (a or b)


@pytest.mark.parametrize(
    ("made", "a", "message"),
    [
        (1.0 / A, 0.0, "division of 1 by zero"),
        (5.0 % A, 0.0, "remainder of 5 divided by zero"),
        (A**0.5, -2.0, r"-2 \*\* 0\.5 is not real"),
        (A**-1.0, 0.0, "power failed"),
        (scalar.sqrt(A), -2.0, "square root of -2"),
        (scalar.clamp(A, 2.0, 1.0), 0.0, "clamp between 2 and 1: low exceeds high"),
    ],
)
def test_impossible_arithmetic_says_what_and_where(made, a, message):
    with pytest.raises(EvaluationError, match=message) as caught:
        value(made, a)
    assert f"\n  at {__file__}:" in str(caught.value)
