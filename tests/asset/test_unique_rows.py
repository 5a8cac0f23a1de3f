"""Rows that are there several times, and what is worked out once for each link."""

import gc
import weakref

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from artgen._arrays import cached_per_object, distinct_rows
from artgen.asset.link import Link

few = st.integers(-2, 2)
tables = st.tuples(st.integers(0, 12), st.integers(1, 4))


@given(arrays(np.int64, tables, elements=few) | arrays(np.float64, tables, elements=few.map(float)))
def test_distinct_rows_are_those_of_numpy(rows) -> None:
    wanted = np.unique(rows, axis=0, return_index=True, return_inverse=True)
    for found, want in zip(distinct_rows(rows), wanted, strict=True):
        assert np.array_equal(found, want.reshape(found.shape))


def test_a_link_is_asked_once_and_forgotten_with_the_link() -> None:
    asked = []

    @cached_per_object
    def name(link: Link) -> str:
        asked.append(link.name)
        return link.name

    first, second = Link("lid", "lid"), Link("lid", "lid")
    assert [name(first), name(first), name(second)] == ["lid"] * 3
    assert len(asked) == 2, "two links of one name are two"
    gone = weakref.ref(first)
    del first
    gc.collect()
    assert gone() is None, "what is kept of a link must not keep the link"


def test_what_is_raised_is_not_kept() -> None:
    fails = [True]

    @cached_per_object
    def says(link: Link) -> str:
        if fails.pop():
            raise ValueError("a file is missing")
        return "well"

    fails.insert(0, False)
    link = Link("lid", "lid")
    with pytest.raises(ValueError, match="a file is missing"):
        says(link)
    assert says(link) == "well"
