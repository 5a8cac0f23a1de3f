"""Reading datasets: lengths, slices, filters, splits and tables, of folders written by hand."""

import json
import math
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from artgen.dataset import Dataset, Plan
from artgen.dataset.places import Disk
from artgen.dataset.run import MANIFEST_FILE, Folder
from artgen.errors import ExportError, ParameterError


def record(category: str, seed: int, **more: Any) -> dict[str, Any]:
    return {
        "name": f"{category}_{seed}",
        "category": category,
        "seed": seed,
        "state": "done",
        "path": f"{category}/{category}_{seed}",
        "files": {"mjcf": f"{category}_{seed}.xml"},
        "attempt": 0,
        "proven": True,
        "mass": 1.0 + seed,
        "links": 2,
        "joints": {"lid": "revolute" if category == "box" else "prismatic"},
        "parameters": {"width": 0.01 * seed, "style": "round" if seed % 2 else "square"},
        **more,
    }


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A manifest of 40 assets and one failed asset."""
    with Folder.opened(Disk(tmp_path / "set"), Plan(("box", "drawer"), 41)):
        pass
    lines = [record(category, seed) for seed in range(20) for category in ("box", "drawer")]
    lines.append({"name": "box_20", "category": "box", "seed": 20, "state": "failed", "error": "no room"})
    text = "".join(json.dumps(line) + "\n" for line in lines)
    (tmp_path / "set" / MANIFEST_FILE).write_text(text)
    return tmp_path / "set"


def test_a_dataset_has_the_finished_assets_only(folder: Path) -> None:
    found = Dataset(folder)
    assert len(found) == 40
    assert repr(found) == f"<40 assets of box, drawer in {folder}>"
    assert found.paths()[1] == folder / "drawer/drawer_0"
    assert found.files("mjcf")[1] == folder / "drawer/drawer_0/drawer_0.xml"
    assert [each["name"] for each in found[2:4].records] == ["box_1", "drawer_1"]
    assert len(found[:0]) == 0


def test_filters(folder: Path) -> None:
    found = Dataset(folder)
    assert {each["category"] for each in found.filter("box").records} == {"box"}
    assert len(found.filter(["box", "drawer"])) == 40
    assert found.filter(joint="prismatic").records == found.filter("drawer").records
    assert {each["seed"] for each in found.filter(width=(0.05, 0.07)).records} == {5, 6, 7}
    assert len(found.filter(style="round")) == 20
    assert len(found.filter(style=["round", "square"])) == 40
    assert [each["name"] for each in found.filter("box", where=lambda each: each["mass"] > 19.5).records] == [
        "box_19"
    ]


@pytest.mark.parametrize(
    ("condition", "message"),
    [
        ({"category": "bocks"}, r"no asset here has the category 'bocks'\. Did you mean 'box'\?"),
        ({"joint": "ball"}, r"no asset here has the kind of joint 'ball'\. Allowed: prismatic, revolute"),
        ({"widht": 1.0}, r"no asset here has the parameter 'widht'\. Did you mean 'width'\?"),
        ({"category": 5}, r"no asset here has the category 5\. Allowed: box, drawer\."),
        ({"joint": ["prismatic"]}, r"no asset here has the kind of joint \['prismatic'\]\. Allowed: pri"),
        ({"where": "mass>1"}, r"where = 'mass>1' is not allowed: it must be a function of a manifest line"),
    ],
)
def test_a_filter_with_an_unknown_name_is_an_error(
    folder: Path, condition: dict[str, Any], message: str
) -> None:
    with pytest.raises(ParameterError, match=message):
        Dataset(folder).filter(**condition)


@pytest.mark.parametrize(
    "value",
    [(1, 2, 3), (1,), (1, None), ("a", "b"), (2, 1), ("round", "square"), np.array([1, 2]), range(1, 3)],
)
def test_a_filter_with_a_value_of_another_kind_is_an_error(folder: Path, value: Any) -> None:
    message = f"width = {value!r} is not allowed: give a value, several values in a list or set, or a range "
    with pytest.raises(ParameterError, match=re.escape(message)):
        Dataset(folder).filter(width=value)


def test_no_seed_is_in_two_parts(folder: Path) -> None:
    found = Dataset(folder)
    parts = found.split(train=0.5, test=0.5)
    seeds = {name: {each["seed"] for each in part.records} for name, part in parts.items()}
    assert all(seeds.values())
    assert not seeds["train"] & seeds["test"]
    assert sum(map(len, parts.values())) == 40
    smaller = found[:20].split(train=0.5, test=0.5)
    assert all(set(smaller[name].paths()) <= set(parts[name].paths()) for name in parts)


def test_the_shares_of_a_split_are_met_on_average(folder: Path) -> None:
    text = "".join(json.dumps(record("box", seed)) + "\n" for seed in range(2000))
    (folder / MANIFEST_FILE).write_text(text)
    sizes = {name: len(part) for name, part in Dataset(folder).split().items()}
    assert sizes == pytest.approx({"train": 1600, "val": 200, "test": 200}, abs=60)


def test_shares_must_have_the_sum_one(folder: Path) -> None:
    with pytest.raises(
        ParameterError, match=r"the sum of the shares is 0\.9; it must be 1, and no share negative"
    ):
        Dataset(folder).split(train=0.8, test=0.1)
    with pytest.raises(ParameterError, match="the sum of the shares is nan; it must be 1"):
        Dataset(folder).split(a=math.nan)
    with pytest.raises(ParameterError, match=r"each share must be a number, got \{'train': 'all'\}"):
        Dataset(folder).split(train="all")  # type: ignore[arg-type]


def test_tables(folder: Path) -> None:
    pytest.importorskip("pandas")
    table = Dataset(folder).to_pandas()
    assert list(table["name"][:3]) == ["box_0", "drawer_0", "box_1"]
    assert table["parameter.width"].max() == pytest.approx(0.19)


@pytest.mark.parametrize("index", ["box_0", np.array([0]), np.array([0, 1])])
def test_an_asset_is_found_by_number(folder: Path, index: Any) -> None:
    message = f"by its number, such as 0, or a slice, not by {re.escape(repr(index))}; `records`"
    with pytest.raises(ParameterError, match=message):
        Dataset(folder)[index]


def test_a_last_line_without_its_end_counts_and_the_last_of_equal_names(folder: Path) -> None:
    file = folder / MANIFEST_FILE
    text = file.read_text()
    again = json.dumps(record("box", 0, mass=7.0))
    file.write_text(text + again)
    assert len(Dataset(folder)) == 40
    assert Dataset(folder).records[0]["mass"] == 7.0
    file.write_text(text + again[:-1])
    assert Dataset(folder).records[0]["mass"] == 1.0


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        ({"state": None}, "'state' is missing or has a wrong type"),
        ({"state": "failed"}, "'error' is missing or has a wrong type"),
        ({"name": None}, "'name' is missing or has a wrong type"),
        ({"path": None}, "'path' is missing or has a wrong type"),
        ({"parameters": None}, "'parameters' is missing or has a wrong type"),
        ({"mass": "x"}, "'mass' is missing or has a wrong type"),
        ({"mass": math.nan}, "NaN is no number"),
    ],
)
def test_an_edited_line_is_named(folder: Path, change: dict[str, Any], reason: str) -> None:
    line = {name: value for name, value in record("box", 0, **change).items() if value is not None}
    (folder / MANIFEST_FILE).write_text(json.dumps(record("box", 1)) + "\n" + json.dumps(line) + "\n")
    with pytest.raises(ExportError, match=rf"manifest\.jsonl: line 2 is damaged \({reason}\); remove the"):
        Dataset(folder)


def test_a_folder_in_place_of_the_manifest_is_named(folder: Path) -> None:
    (folder / MANIFEST_FILE).unlink()
    (folder / MANIFEST_FILE).mkdir()
    with pytest.raises(ExportError, match=r"cannot read .*manifest\.jsonl: "):
        Dataset(folder)


def test_what_is_no_dataset_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ExportError, match=r"holds no dataset; `artgen generate CATEGORY -n 100` makes one"):
        Dataset(tmp_path)


def test_a_format_without_files_is_an_error(folder: Path) -> None:
    with pytest.raises(ExportError, match=r"has no files in the format 'usd'\. Allowed: mjcf"):
        Dataset(folder).files("usd")
