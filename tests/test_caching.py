"""What assets and threads share cannot be written to, and no thread waits for another for ever."""

import hashlib
import json
import subprocess
import sys
import threading
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import artgen
from artgen._arrays import cached, cached_per_object, cached_property
from artgen.asset import Asset
from artgen.catalog import categories
from artgen.export.files import encode
from artgen.generator.generator import SHARED
from support.cases import some

STACKS_AFTER = 60  # time without work that is a deadlock; the process ends and shows its stacks [s]


def arrays(value: Any, path: str, seen: set[int]) -> Iterator[tuple[str, np.ndarray]]:
    """Yield each array that a user can reach from a value, with its path."""
    if id(value) in seen:
        return
    seen.add(id(value))
    if isinstance(value, np.ndarray):
        yield path, value
    elif isinstance(value, Mapping):
        for key, each in value.items():
            yield from arrays(each, f"{path}[{key!r}]", seen)
    elif isinstance(value, tuple | list):
        for index, each in enumerate(value):
            yield from arrays(each, f"{path}[{index}]", seen)
    elif type(value).__module__.startswith("artgen."):
        remembered = {
            name
            for base in type(value).__mro__
            for name, member in vars(base).items()
            if isinstance(member, cached_property)
        }
        for name in sorted({*vars(value), *remembered}):
            yield from arrays(getattr(value, name), f"{path}.{name}", seen)


@pytest.mark.parametrize("category", some(categories(), 8, 1))
def test_arrays_of_an_asset_are_read_only(category: str) -> None:
    asset = artgen.generate(category, 0, certify=False)
    encode(asset, ("urdf", "mjcf", "usd"), textures=0)  # makes what exports ask for
    found = list(arrays(asset, "asset", {id(each) for each in (Any, None)}))
    assert len(found) > 100
    assert [path for path, array in found if array.flags.writeable] == []


@pytest.mark.parametrize("category", ["handle", "oven", "box", "door", "lamp", "toaster"])
def test_writing_to_an_asset_does_not_change_later_ones(category: str) -> None:
    """To millimetres, in place: an error instead of another asset that is silently wrong."""
    before = encode(artgen.generate(category, 0, certify=False), ("urdf", "mjcf"), textures=0)
    asset = artgen.generate(category, 0, certify=False)
    with pytest.raises(ValueError, match="read-only"):
        asset.links[0].surfaces[0].mesh.vertices *= 1000
    for _, array in arrays(asset, "asset", set()):
        with pytest.raises(ValueError, match="read-only"):
            array[...] = 0
    after = encode(artgen.generate(category, 0, certify=False), ("urdf", "mjcf"), textures=0)
    assert after == before


def test_a_copy_can_be_changed() -> None:
    asset = artgen.generate("handle", 0, certify=False)
    vertices = asset.links[0].surfaces[0].mesh.vertices.copy()
    vertices *= 1000
    assert vertices.flags.writeable


class Linked:
    """An object with two properties, each of which may ask for the other one of another object."""

    def __init__(self, gate: threading.Barrier | None = None, other: "Linked | None" = None) -> None:
        self.gate, self.other = gate, other

    def meet(self) -> None:
        if self.gate is not None:
            self.gate.wait(timeout=10)

    @cached_property
    def first(self) -> int:
        self.meet()
        return self.other.second if self.other else 1

    @cached_property
    def second(self) -> int:
        self.meet()
        return self.other.first if self.other else 2


def test_threads_do_not_wait_for_each_other() -> None:
    """Both threads are within one property when they ask for the other one; with locks, neither goes on."""
    gate = threading.Barrier(2)
    one, two = Linked(gate, Linked()), Linked(gate, Linked())
    found = []
    threads = [
        threading.Thread(target=lambda: found.append(one.first), daemon=True),
        threading.Thread(target=lambda: found.append(two.second), daemon=True),
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(timeout=20)
    assert sorted(found) == [1, 2], "the threads wait for each other"


def test_threads_get_the_same_value() -> None:
    made = []

    class Slow:
        @cached_property
        def value(self) -> np.ndarray:
            gate.wait(timeout=10)
            return np.zeros(3)

    gate, slow = threading.Barrier(4), Slow()
    threads = [threading.Thread(target=lambda: made.append(slow.value)) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len({id(each) for each in made}) == 1


def test_remembered_arrays_are_read_only() -> None:
    @cached(4)
    def pair(size: int) -> tuple[np.ndarray, dict[str, list[np.ndarray]]]:
        return np.zeros(size), {"more": [np.ones(size)]}

    @cached_per_object
    def of(key: Linked) -> np.ndarray:
        return np.zeros(1)

    first, more = pair(2)
    for each in (first, more["more"][0], of(Linked())):
        with pytest.raises(ValueError, match="read-only"):
            each[...] = 0


PROGRAM = f"""
import faulthandler, hashlib, json, sys, threading, time
from contextlib import suppress
from pathlib import Path


def watch():  # by processor time: a loaded machine is slow, a deadlock does nothing
    while True:
        faulthandler.dump_traceback_later({STACKS_AFTER}, exit=True)
        used = time.process_time()
        while time.process_time() < used + 0.1:
            time.sleep(1)

threading.Thread(target=watch, daemon=True).start()
import artgen
from artgen.export.files import encode

NAMES = ("door", "drawer", "toaster", "handle")
shared = artgen.generate("door", 1, certify=False)
found, errors = {{}}, []

def digest(asset):
    files = encode(asset, ("urdf", "mjcf", "usd", "glb"), textures=0)
    return hashlib.sha256(repr(sorted(files.items())).encode()).hexdigest()

def work(number):
    try:
        gate.wait()
        name = NAMES[number % 4]
        asset = artgen.generate(name, number // 4, certify=False)
        for each in (asset, shared):
            each.to_json()
            each.certify()
            found.setdefault(each.name, set()).add(digest(each))
            with suppress(artgen.errors.RenderError):  # there is no software renderer
                each.render(size=48, samples=1, textures=256)
            each.export(Path(sys.argv[1]) / str(number) / each.name, formats=("urdf", "mjcf"), textures=0)
    except BaseException as error:
        errors.append(repr(error))

gate = threading.Barrier(int(sys.argv[2]))
threads = [threading.Thread(target=work, args=(number,)) for number in range(int(sys.argv[2]))]
for thread in threads: thread.start()
for thread in threads: thread.join()
print(json.dumps([errors, {{name: sorted(each) for name, each in sorted(found.items())}}]))
"""


def together(folder: Path, threads: int) -> dict[str, list[str]]:
    """Return digests of assets that threads make, prove and write; a deadlock fails with the stacks."""
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM, folder, str(threads)],
        check=False, capture_output=True, text=True,
    )  # fmt: skip
    assert done.returncode == 0, f"the threads did not end:\n{done.stderr[-4000:]}"
    errors, found = json.loads(done.stdout)
    assert errors == []
    return found


@pytest.mark.long
def test_threads_make_prove_and_export_at_once(tmp_path: Path) -> None:
    found = together(tmp_path, 8)
    assert all(len(digests) == 1 for digests in found.values()), found
    assert len(found) == 8
    for name, (digest,) in found.items():
        category, _, seed = name.rpartition("_")
        SHARED.clear()
        alone = artgen.generate(category, int(seed), certify=False)
        alone.certify()
        assert digest == _digest(alone), f"{name} differs from the one that a single thread makes"


IMPORTS = """
import _imp, importlib.util, sys, threading, time
from importlib.machinery import EXTENSION_SUFFIXES
from pathlib import Path
import numpy
from artgen._arrays import OPENUSD

create, running, met = _imp.create_dynamic, set(), []

def recorded(spec, *rest):  # one library that is opened; time passes, in which other threads run
    running.add(spec.name)
    time.sleep(0.02)
    if len({name.startswith("pxr") for name in running}) > 1:
        met.extend(sorted(running))
    try:
        return create(spec, *rest)
    finally:
        running.discard(spec.name)

def others():
    for path in sorted(Path(numpy.__file__).parent.rglob("*" + EXTENSION_SUFFIXES[0])):
        if not stop:
            loader = importlib.util.spec_from_file_location("again_" + path.name.split(".")[0], path)
            try:
                importlib.util.module_from_spec(loader)
            except ImportError:  # some can be opened once only
                pass

_imp.create_dynamic = recorded
stop = []
thread = threading.Thread(target=lambda: [others() for _ in range(9)])
thread.start()
with OPENUSD:
    import pxr.Usd
stop.append(1)
thread.join()
assert any(name.startswith("pxr") for name in sys.modules)
print(met)
"""


def test_openusd_is_imported_while_no_other_thread_opens_a_library() -> None:
    done = subprocess.run(
        [sys.executable, "-c", IMPORTS], check=True, capture_output=True, text=True, timeout=300
    )
    assert done.stdout.strip() == "[]", "two threads opened libraries at once, which may end in a deadlock"


def _digest(asset: Asset) -> str:
    files = encode(asset, ("urdf", "mjcf", "usd", "glb"), textures=0)
    return hashlib.sha256(repr(sorted(files.items())).encode()).hexdigest()
