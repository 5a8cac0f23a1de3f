"""Settings of all tests: the same examples every time, no deadline on a busy machine; shared fixtures."""

import gc
import os
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest
from hypothesis import settings

from artgen.cli import main
from artgen.generator import CATEGORIES

settings.register_profile("artgen", deadline=None, derandomize=True, max_examples=50, print_blob=True)
settings.load_profile("artgen")


_LONGEST = (
    *("test_ray.py", "test_web_viewer.py", "test_readme.py", "test_scene.py", "test_registry.py"),
    *("test_real_clients.py", "test_same_bytes.py", "test_docs.py", "test_examples.py", "test_fewer.py"),
)


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Begin with the files that take longest: at the end, the other processes would wait for them."""
    items.sort(key=lambda item: item.path.name not in _LONGEST)


def pytest_collection_finish() -> None:
    """Let the collector leave out the modules and the tests, which stay until the end."""
    gc.collect()
    gc.freeze()


@pytest.fixture(scope="session", autouse=True)
def _own_cache(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Keep textures away from the user's own cache, but together for all processes of a run."""
    base = tmp_path_factory.getbasetemp()
    shared = base.parent if "PYTEST_XDIST_WORKER" in os.environ else base
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("ARTGEN_CACHE", str(shared / "artgen_cache"))
        yield


@pytest.fixture(scope="module", autouse=True)
def _own_categories() -> Iterator[None]:
    """Forget the categories that the tests of a module have made; others are about those that are there."""
    before = set(CATEGORIES)
    yield
    for name in set(CATEGORIES) - before:
        if not CATEGORIES[name].function.__module__.startswith("artgen.categories."):
            del CATEGORIES[name]


@pytest.fixture(scope="module")
def coacd_cache(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Keep what CoACD finds away from the user's own cache, but through all tests of a module."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("ARTGEN_CACHE", str(tmp_path_factory.mktemp("cache")))
        yield


@dataclass
class Result:
    """What a command printed, and how it ended."""

    code: int
    out: str
    err: str


@pytest.fixture
def artgen_command(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> Callable[..., Result]:
    """Run the command line in an empty directory."""
    monkeypatch.chdir(tmp_path)

    def run(*arguments: str) -> Result:
        with pytest.raises(SystemExit) as ended:
            main(arguments)
        printed = capsys.readouterr()
        return Result(int(ended.value.code or 0), printed.out, printed.err)

    return run
