"""The survey of a category: measurements, records and criteria."""

import json
import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from surveys.pages import soak_page
from surveys.products import PRODUCTS, Product, misfits, size_of
from surveys.run import read_records, survey
from surveys.sample import measure
from surveys.summary import criteria, failures, figures, listed

from artgen import Body, box, detail, generator, material, part, weld
from artgen.asset import Asset
from artgen.asset.report import CheckResult
from artgen.catalog import categories, find
from artgen.errors import ExportError
from surveys import sample

pytestmark = pytest.mark.long  # scripts of maintainers

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def handle() -> Asset:
    return find("handle").generate(4)


@pytest.fixture(scope="module")
def record() -> dict[str, Any]:
    return measure(4, category="handle")


def counted(seed: int, *, category: str, fast: bool) -> dict[str, Any]:
    """Replace `measure`."""
    if seed == 2:
        raise ValueError("no such sample")
    if seed == 3:
        os._exit(1)
    return {"category": category, "seed": seed, "state": "done", "process": os.getpid()}


def test_a_record_describes_the_asset(record, handle) -> None:
    assert json.loads(json.dumps(record, allow_nan=False)) == record
    low, high = handle.bounds()
    assert record["size"] == pytest.approx(list(high - low), abs=1e-3)
    assert record["mass"] == pytest.approx(handle.mass, rel=1e-5)
    assert record["colliders"] == {link.name: len(link.colliders) for link in handle.links}
    assert record["parameters"]["kind"] == handle.parameters["kind"]
    assert 0.0 < record["seconds"] < 5.0
    assert record["redrawn"] == {"required": 0, "collided": 0}
    assert set(record["checks"]) == {"solids", "tree", "colliders", "grasps", "behavior"}
    assert all(not each["faults"] for each in record["checks"].values())
    assert all(speed > 1.0 for speed in record["speed"].values())


def test_a_fast_record_has_no_results_of_simulators(record) -> None:
    fast = measure(4, category="handle", fast=True)
    assert set(fast["checks"]) == {"solids", "tree", "colliders"}
    assert not {"speed", "forces"} & set(fast)
    assert fast["size"] == record["size"]


def test_redraws_are_counted_by_cause(monkeypatch) -> None:
    def draws(seed, attempt):
        return {"attempt": attempt}

    class Drawn:
        sample = staticmethod(draws)
        build = staticmethod(lambda values: values)

    class Built:
        def __init__(self, values) -> None:
            self.values = values

        def evaluate(self, values, cache) -> None:
            if values["attempt"] == 3:
                raise sample.InfeasibleError("too wide")

    monkeypatch.setattr(sample, "Graph", Built)
    # two draws were infeasible, the third collided, the fourth was infeasible, the fifth collided
    assert sample._redraws(Drawn(), 0, 2, 5) == (3, 2)
    assert sample._redraws(Drawn(), 0, 2, 2) == (2, 0)


def test_a_check_that_raises_is_a_fault() -> None:
    def broken() -> CheckResult:
        raise ValueError("no mesh")

    found = sample._checks([("solids", broken)])
    assert "no mesh" in found["solids"]["faults"][0]


def test_an_interrupted_run_continues(tmp_path) -> None:
    path = tmp_path / "thing.jsonl"
    first = survey("thing", range(5), path, task=counted, limit=30.0)
    assert [each["seed"] for each in first] == [0, 1, 2, 3, 4]
    assert [each["state"] for each in first] == ["done", "done", "failed", "crashed", "done"]
    assert "no such sample" in first[2]["message"]
    seen: list[None] = []
    again = survey("thing", range(7), path, task=counted, limit=30.0, progress=lambda: seen.append(None))
    assert again[:5] == first
    assert len(seen) == 2
    assert len(read_records(path)) == 7
    assert len(survey("other", range(1), path, task=counted)) == 1
    assert len(read_records(path)) == 8


def test_a_fast_line_is_measured_again_for_a_full_survey(tmp_path) -> None:
    path = tmp_path / "thing.jsonl"
    survey("thing", [0], path, fast=True, task=counted)
    survey("thing", [0], path, fast=False, task=counted)
    assert [each["fast"] for each in read_records(path)] == [True, False]
    survey("thing", [0], path, fast=True, task=counted)
    assert len(read_records(path)) == 2


def test_a_line_that_was_cut_off_is_measured_again(tmp_path) -> None:
    path = tmp_path / "thing.jsonl"
    survey("thing", range(2), path, task=counted)
    path.write_text(path.read_text()[:-9])
    assert [each["seed"] for each in read_records(path)] == [0]
    assert len(survey("thing", range(2), path, task=counted)) == 2
    assert [each["seed"] for each in read_records(path)] == [0, 1]


@pytest.mark.parametrize("text", ["{}\n", "[1]\n", "seeds\n", '{"seed": 1}\n{"seed": 2}\n'])
def test_another_file_is_an_error(tmp_path, text) -> None:
    path = tmp_path / "other.jsonl"
    path.write_text(text)
    with pytest.raises(ExportError, match=r"line 1 is no record of a survey; give another --out"):
        survey("thing", [0], path, task=counted)
    assert path.read_text() == text


class TestCriteria:
    @pytest.fixture
    def record(self, record) -> dict[str, Any]:
        """Return the record of a fast machine, because the speed of this one does not matter."""
        return {**record, "seconds": 0.05, "speed": dict.fromkeys(record["speed"], 100.0)}

    def changed(self, record, **fields) -> dict[str, Any]:
        return {**record, "seed": 7, **fields}

    def unmet(self, records) -> dict[str, tuple[int, ...]]:
        return {each.name: each.seeds for each in criteria(records) if each.passed is False}

    def test_a_sound_sample_meets_all(self, record) -> None:
        assert self.unmet([record]) == {}
        assert not [kind for kind in map(str, failures([record])) if "(note)" not in kind]
        assert figures([record])["links"].startswith("4 to 4")

    @pytest.mark.parametrize(
        ("fields", "name"),
        [
            ({"seconds": 0.2}, "seed to asset: median at most 120 ms"),
            ({"colliders": {"base": 65}}, "colliders a link: at most 64"),
            ({"colliders": {"base": 50, "a": 50, "b": 50, "c": 50}}, "colliders: at most 199"),
            ({"misfits": ["mass 900 kg"]}, "like a product"),
            ({"ground": -0.001}, "on the ground"),
            ({"aside": 0.01}, "centered"),
            ({"speed": {"closed": 30.0, "half open": 19.0}}, "MuJoCo, times real time: at least 20"),
            ({"forces": {"turn": 61.0}}, "force of a hand [N]: at most 60"),
            ({"redrawn": {"required": 1, "collided": 0}}, "redrawn: under 2 %"),
        ],
    )
    def test_each_number_counts(self, record, fields, name) -> None:
        records = [self.changed(record, **fields)] + [record] * 2 * ("redrawn" in fields)
        unmet = self.unmet(records)
        assert list(unmet) == [name]
        assert unmet[name] in ((7,), ())

    def test_each_check_counts(self, record) -> None:
        for check in record["checks"]:
            checks = {**record["checks"], check: {**record["checks"][check], "faults": ["link a: bad"]}}
            records = [record, self.changed(record, checks=checks)]
            assert self.unmet(records) == {f"{check}: no faults": (7,)}
            assert any(
                str(each) == f"{check}: 1 seed: 7\n  seed 7: link a: bad" for each in failures(records)
            )

    def test_a_sample_that_is_missing_counts(self, record) -> None:
        lost = {"category": "handle", "seed": 9, "state": "timed out", "message": "it took more than 1 s"}
        assert self.unmet([record, lost]) == {"every seed gives an asset": (9,)}
        assert "timed out: 1 seed: 9" in str(failures([lost])[0])
        assert self.unmet([lost]) == {"every seed gives an asset": (9,)}
        assert figures([lost]) == {}

    def test_forces_at_copies_of_a_joint_are_joined(self, record) -> None:
        forces = {"button_slide_0": 2.0, "button_slide_12": 4.0, "door_hinge_left": 9.0}
        found = figures([self.changed(record, forces=forces)])
        assert found["force at button_slide [N]"].startswith("2 to 4")
        assert "force at door_hinge_left [N]" in found

    def test_unmeasured_criteria_are_neither_met_nor_missed(self) -> None:
        fast = measure(5, category="handle", fast=True)
        states = {each.name: each.passed for each in criteria([fast])}
        assert states["behavior: no faults"] is None
        assert states["MuJoCo, times real time: at least 20"] is None
        assert states["solids: no faults"] is True


def test_the_script_measures_and_judges(tmp_path) -> None:
    out = tmp_path / "handle.jsonl"
    page = tmp_path / "soak.md"
    arguments = [
        "handle",
        "--seeds",
        "2",
        "--first-seed",
        "3",
        "--fast",
        "--out",
        str(out),
        "--page",
        str(page),
    ]
    done = subprocess.run(
        [sys.executable, ROOT / "scripts" / "survey.py", *arguments],
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )
    assert done.stderr == ""
    assert "every seed gives an asset" in done.stdout
    assert "2 of 2" in done.stdout
    records = read_records(out)
    assert [record["seed"] for record in records] == [3, 4]
    met = all(each.passed is not False for each in criteria(records))
    assert done.returncode == (0 if met else 1)
    assert page.read_text() == soak_page({"handle": records})


def test_the_page_lists_unmet_criteria_with_their_seeds(record) -> None:
    record = {**record, "seconds": 0.05}
    heavy = {**record, "seed": 7, "misfits": ["mass 99 kg, 1 to 2 kg | sold"]}
    lines = soak_page({"handle": [record, heavy], "lamp": [record]}).splitlines()
    asked = len(criteria([record]))
    assert f"| [`handle`](#handle) | 2 | {asked - 1} of {asked} | like a product (1 of 2) |" in lines
    assert f"| [`lamp`](#lamp) | 1 | {asked} of {asked} | nothing |" in lines
    assert "| like a product | 1 of 2 | **no**, 1 seed: 7 |" in lines
    assert "- like no product: 1 seed: 7. `mass 99 kg, 1 to 2 kg | sold`" in lines
    assert "| links | 4 to 4, median 4 |" in lines


def test_seeds_are_listed_up_to_a_dozen() -> None:
    assert listed([4]) == "1 seed: 4"
    assert listed(range(14)) == "14 seeds: 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11 and 2 more"


class TestProducts:
    def test_every_category_has_some(self) -> None:
        assert set(categories()) <= set(PRODUCTS)

    def test_ranges_are_in_order(self) -> None:
        for products in PRODUCTS.values():
            for product in products:
                for low, high in (product.width, product.depth, product.height, product.mass):
                    assert 0.0 < low < high

    def test_unusual_sizes_are_listed_with_their_number(self, handle) -> None:
        product = Product("small", (0.1, 0.2), (0.1, 0.2), (0.28, 0.3), (0.1, 1.0))
        told = product.misfits(handle)
        assert told[0] == "width 0.250 m, 0.1 to 0.2 m are sold"
        assert told[1].startswith(f"mass {handle.mass:.2f} kg, 0.1 to 1 kg")
        assert misfits(handle) == []
        assert misfits(replace(handle, category="unknown")) == []

    def test_visual_details_have_no_size(self) -> None:
        whole = part(box(0.2, 0.1, 0.1), "base", material("oak"))

        @generator
        def corded() -> Body:
            return weld(whole, detail(box(0.5, 0.01, 0.01), "cord", material("oak")))

        asset = corded.generate(certify=False)
        assert np.ptp(asset.bounds(), axis=0) == pytest.approx([0.5, 0.1, 0.1])
        assert size_of(asset) == pytest.approx([0.2, 0.1, 0.1])

    def test_some_products_have_two_orientations(self, handle) -> None:
        width, depth, height = size_of(handle)
        assert width > depth + 0.02
        spans = [(length - 0.001, length + 0.001) for length in (depth, width, height)]
        turned = Product("turned", *spans, (0.1, 100.0), turns=True)
        assert turned.misfits(handle) == []
        assert len(replace(turned, turns=False).misfits(handle)) == 2
