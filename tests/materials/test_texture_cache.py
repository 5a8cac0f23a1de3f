"""What is kept of textures: made once for all, never wrong, one error where it cannot be kept."""

import importlib
import os
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from artgen import _disk_cache as disk_cache
from artgen.errors import ExportError
from artgen.materials import Material, material
from artgen.materials.textures import RECIPES, Pattern, Recipe, encoded, kinds, maps
from artgen.materials.textures import bake as baking
from artgen.materials.textures.bake import Memory

SIZE = 256


@pytest.fixture
def place(tmp_path, monkeypatch):
    """Keep maps in an empty directory, none in memory, and return it."""
    monkeypatch.setenv("ARTGEN_CACHE", str(tmp_path / "cache"))
    baking.MEMORY.clear()
    yield tmp_path / "cache"
    baking.MEMORY.clear()


@pytest.fixture
def bakes(monkeypatch):
    """Count how often maps are made."""
    counted = []
    make = baking.bake

    def count(recipe, variant, size):
        counted.append(recipe.name)
        return make(recipe, variant, size)

    monkeypatch.setattr(baking, "bake", count)
    return counted


def files_in(place):
    return sorted(path for path in place.rglob("*") if path.is_file())


def test_maps_are_made_once_and_files_read_whole(place, bakes, monkeypatch):
    oak = material("oak")
    first = encoded(oak, "albedo", SIZE, "png")
    assert bakes == ["oak"]
    assert encoded(oak, "albedo", SIZE, "png") is first
    baking.MEMORY.clear()
    making = importlib.import_module("artgen.materials.textures.maps")
    monkeypatch.setattr(making, "maps", None)  # a kept file needs no maps
    assert encoded(oak, "albedo", SIZE, "png") == first
    assert bakes == ["oak"]
    assert len(files_in(place)) == 2  # the maps, and the file


def test_a_color_drawn_for_one_asset_does_not_fill_the_disk(place):
    oak = material("oak")
    encoded(oak, "albedo", SIZE, "png")
    before = files_in(place)
    for share in (0.41, 0.42, 0.43):
        encoded(oak.with_(base_color=(share, 0.25, 0.12)), "albedo", SIZE, "png")
    assert files_in(place) == before


@pytest.mark.parametrize("damage", ["empty", "cut", "flipped", "longer", "other", "folder"])
def test_a_damaged_file_is_made_again(place, bakes, damage):
    oak = material("oak")
    first = encoded(oak, "albedo", SIZE, "jpg")
    for path in files_in(place):
        content = path.read_bytes()
        middle = len(content) // 2
        flipped = content[:middle] + bytes([content[middle] ^ 1]) + content[middle + 1 :]
        damaged = {
            "empty": b"",
            "cut": content[:middle],
            "flipped": flipped,
            "longer": content + b"x",
            "other": b"no cache" * 9,
        }
        if damage == "folder":
            path.unlink()
        else:
            path.write_bytes(damaged[damage])
    baking.MEMORY.clear()
    assert encoded(oak, "albedo", SIZE, "jpg") == first
    assert bakes == ["oak", "oak"]
    baking.MEMORY.clear()
    assert encoded(oak, "albedo", SIZE, "jpg") == first
    assert bakes == ["oak", "oak"]
    assert len(files_in(place)) == 2


def test_sound_files_of_other_maps_are_not_taken(place, bakes):
    maps(material("oak"), SIZE)
    (path,) = files_in(place)
    for content in (b"no archive", b""):
        disk_cache.write("textures", path.name, content)
        baking.MEMORY.clear()
        assert maps(material("oak"), SIZE).albedo is not None
    assert bakes == ["oak", "oak", "oak"]


def test_it_works_without_a_cache(place, bakes, monkeypatch):
    kept = encoded(material("oak"), "normal", SIZE, "png")
    monkeypatch.setenv("ARTGEN_CACHE", "off")
    assert disk_cache.cache_directory() is None
    baking.MEMORY.clear()
    assert encoded(material("oak"), "normal", SIZE, "png") == kept
    assert bakes == ["oak", "oak"]
    assert not Path("off").exists()


def test_a_folder_may_be_below_the_home_directory(monkeypatch, tmp_path):
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setenv("ARTGEN_CACHE", "~/my cache")
    assert disk_cache.cache_directory() == tmp_path / "my cache"


def test_a_folder_that_cannot_be_written_is_one_error_with_the_fix(place, tmp_path, monkeypatch):
    (tmp_path / "taken").write_text("mine")
    monkeypatch.setenv("ARTGEN_CACHE", str(tmp_path / "taken" / "deeper"))
    with pytest.raises(
        ExportError,
        match=r"textures cannot be written to .*taken/deeper: .*; set ARTGEN_CACHE to a folder that can be "
        "written, or to 'off'",
    ):
        maps(material("oak"), SIZE)

    def full(*arguments):
        raise OSError(28, "No space left on device")

    monkeypatch.setenv("ARTGEN_CACHE", str(place))
    with monkeypatch.context() as patch:
        patch.setattr(Path, "replace", full)
        with pytest.raises(ExportError, match="No space left on device; set ARTGEN_CACHE"):
            maps(material("oak"), SIZE)
    assert files_in(place) == []


def test_recipes_of_others_are_not_kept_on_disk(place, monkeypatch):
    def even(stream, size):
        return Pattern(None, np.zeros((size, size)))

    def rough(stream, size):
        return Pattern(None, np.full((size, size), 0.2))

    for make, level in ((even, 128), (rough, 179)):
        monkeypatch.setitem(RECIPES, "mine", Recipe("mine", (0.5, 0.5, 0.5), make))
        made = Material("a", texture="mine", specular_roughness=0.502)
        assert (maps(made, SIZE).roughness == level).all()
        assert kinds(made) == ("orm", "roughness")
        encoded(made, "roughness", SIZE, "png")
    assert files_in(place) == []


def test_memory_forgets_what_was_used_least_lately():
    memory = Memory(10)
    made = []

    def get(key, weight):
        return memory.get(key, lambda: made.append(key) or key, lambda _: weight)

    assert [get(key, 4) for key in "abacab"] == list("abacab")
    assert made == ["a", "b", "c", "b"]  # b went when c came, for a had been used since
    get("huge", 99)
    assert get("huge", 99) == "huge"
    assert made[-1] == "huge"
    memory.clear()
    get("a", 4)
    assert made[-1] == "a"


@pytest.mark.long
def test_ten_processes_at_once_corrupt_nothing(place, tmp_path):
    program = """
import hashlib, pathlib, sys, time
from artgen.materials import material
from artgen.materials.textures import encoded, kinds
pathlib.Path(sys.argv[1]).touch()
while not pathlib.Path(sys.argv[2]).exists():
    time.sleep(0.002)
found = hashlib.sha256()
for name in ("satin_nickel", "chrome", "aged_bronze"):
    for kind in kinds(material(name)):
        found.update(encoded(material(name), kind, 256, "png"))
print(found.hexdigest())
"""
    start = tmp_path / "start"
    ready = [tmp_path / f"ready_{number}" for number in range(10)]
    command = [sys.executable, "-c", program]
    environment = {**os.environ, "OMP_NUM_THREADS": "1"}
    workers = [
        subprocess.Popen([*command, str(mark), str(start)], env=environment, stdout=subprocess.PIPE)
        for mark in ready
    ]
    deadline = time.monotonic() + 60
    while not all(mark.exists() for mark in ready):
        assert time.monotonic() < deadline
        time.sleep(0.01)
    start.touch()
    found = {worker.communicate(timeout=60)[0] for worker in workers}
    assert [worker.returncode for worker in workers] == [0] * 10
    assert len(found) == 1
    assert not [path for path in files_in(place) if path.name.endswith(".part")]
    for path in files_in(place):
        assert disk_cache.read(path.parent.name, path.name) is not None
    found_after = subprocess.run(
        [*command, str(ready[0]), str(start)], env=environment, capture_output=True, check=True, timeout=60
    )
    assert found == {found_after.stdout}
