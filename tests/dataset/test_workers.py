"""Tasks in processes: exceptions, time limits and ended processes do not stop the others."""

import os
import time
from collections.abc import Callable, Iterable, Iterator
from typing import Any

import pytest

from artgen.dataset.workers import Ending, run_job, run_tasks


def double(number: int) -> int:
    if number == 1:
        raise ValueError("one is refused")
    if number == 2:
        os._exit(3)
    if number == 3:
        time.sleep(60.0)
    return 2 * number


@pytest.mark.long
def test_every_item_has_an_ending() -> None:
    start = time.monotonic()
    endings = {each.item: each for each in run_tasks(double, range(8), jobs=2, limit=3.0)}
    assert time.monotonic() - start < 30.0
    assert {item: each.state for item, each in endings.items()} == {
        **dict.fromkeys((0, 4, 5, 6, 7), "done"),
        1: "failed",
        2: "crashed",
        3: "timed out",
    }
    assert endings[7].value == 14
    assert "ValueError: one is refused" in endings[1].message
    assert endings[2].message == "its process ended with code 3"
    assert endings[3].message == "it took more than 3 s"


def test_no_items_start_no_process() -> None:
    assert list(run_tasks(double, [], jobs=2, limit=1.0)) == []


class Doubling:
    """A job whose records are endings."""

    def __init__(self) -> None:
        self.records: dict[int, Ending] = {}

    def left(self) -> list[int]:
        return [number for number in range(4) if number not in self.records]

    def add(self, ending: Ending) -> Ending:
        assert ending.item not in self.records
        self.records[ending.item] = ending
        return ending


def failing(times: int) -> Callable[..., Iterator[Ending]]:
    """Return an engine in which item 1 ends its process a number of times, and item 2 raises."""
    given: list[int] = []

    def run(task: Callable[[Any], Any], items: Iterable[Any], *, limit: float) -> Iterator[Ending]:
        for item in items:
            given.append(item)
            if item == 1 and given.count(1) <= times:
                yield Ending(item, "crashed", message="code -9")
            elif item == 2:
                yield Ending(item, "failed", message="Traceback\nValueError: two is refused")
            else:
                yield Ending(item, "done", 2 * item)

    return run


@pytest.mark.parametrize(("times", "state"), [(2, "done"), (3, "crashed")])
def test_a_job_tries_again_after_the_end_of_a_process(times: int, state: str) -> None:
    job = Doubling()
    found = {
        each.item: each for each in run_job(double, job.left(), job.add, failing(times), limit=1.0, tries=3)
    }
    assert found == job.records
    assert {item: each.state for item, each in found.items()} == {0: "done", 1: state, 2: "failed", 3: "done"}
    assert found[2].reason == "ValueError: two is refused"


def test_an_interrupted_job_continues_with_the_remaining_items() -> None:
    job = Doubling()
    for ending in run_job(double, job.left(), job.add, failing(0), limit=1.0):
        if ending.item == 1:
            break
    assert job.left() == [2, 3]
    assert [each.item for each in run_job(double, job.left(), job.add, failing(0), limit=1.0)] == [2, 3]
    assert list(run_job(double, job.left(), job.add, failing(0), limit=1.0)) == []
