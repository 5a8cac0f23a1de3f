"""Tasks in processes: what raises, hangs or dies is told, and the others go on."""

import os
import time

from artgen.dataset.workers import run_tasks


def double(number: int) -> int:
    if number == 1:
        raise ValueError("one is refused")
    if number == 2:
        os._exit(3)
    if number == 3:
        time.sleep(60.0)
    return 2 * number


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


def test_nothing_to_do_starts_nothing() -> None:
    assert list(run_tasks(double, [], jobs=2, limit=1.0)) == []
