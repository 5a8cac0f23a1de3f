"""Cases of parametrized tests, and the mark of those that `make test` leaves to `make test-long`."""

from collections.abc import Iterable
from typing import Any

import pytest

long = pytest.mark.long


def some(values: Iterable[Any], step: int, start: int = 0) -> list[Any]:
    """Return all values as cases, with the mark `long` on all but each `step`-th.

    Tests of common code take few categories by default; the others differ in what the common code meets,
    and are rarely the only one that fails.
    """
    return [
        pytest.param(
            *(each if isinstance(each, tuple) else (each,)), marks=() if index % step == start else long
        )
        for index, each in enumerate(values)
    ]
