"""Numbers as text: every digit as decimal arithmetic has it, nothing that says nothing."""

from decimal import Decimal

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from artgen.export.text import face_lines, lines, rounded, text


def spelled(number: int, decimals: int) -> str:
    """Return an integer of the last decimal as a plain decimal number."""
    return f"{Decimal(number).scaleb(-decimals).normalize():f}" if number else "0"


@given(
    st.integers(0, 13),
    st.lists(
        st.tuples(st.integers(-(10**15), 10**15), st.integers(-(10**8), 10**8), st.integers(-20000, 20000)),
        max_size=8,
    ),
)
def test_digits_are_those_of_decimal_arithmetic(decimals: int, rows: list[tuple[int, int, int]]) -> None:
    scaled = np.array(rows, np.int64).reshape(-1, 3)
    expected = "".join("v " + " ".join(spelled(number, decimals) for number in row) + "\n" for row in rows)
    assert text(lines(("v ", " ", " "), scaled, decimals)).decode() == expected


@given(st.integers(1, 9), st.lists(st.floats(-5e4, 5e4), min_size=1, max_size=20))
def test_text_read_back_is_the_rounded_number(decimals: int, numbers: list[float]) -> None:
    values = np.array(numbers)[:, None]
    read = [float(word) for word in text(lines(("",), rounded(values, decimals), decimals)).split()]
    np.testing.assert_allclose(read, numbers, rtol=1e-15, atol=0.50001 * 10.0**-decimals)


def test_rows_can_be_taken_apart() -> None:
    rows = lines(("vn ", " "), np.array([[1, -20], [300_000_000, 0], [-5, 7]]), 1)
    assert text(rows[1:]) == b"vn 30000000 0\nvn -0.5 0.7\n"
    assert text(rows[:1]) == b"vn 0.1 -2\n"
    assert text(rows[:0]) == b""


@pytest.mark.parametrize("count", [3, 1000, 12_345])
def test_faces_name_the_numbers_of_their_corners(count: int) -> None:
    random = np.random.default_rng(count)
    corners = random.integers(0, count, (50, 3))
    numbers = np.column_stack([np.arange(count) + 1, random.integers(1, count, count), np.ones(count, int)])
    expected = [
        "f " + " ".join("/".join(str(number) for number in numbers[corner]) for corner in row)
        for row in corners
    ]
    assert text(face_lines(corners, numbers)).decode().splitlines() == expected
