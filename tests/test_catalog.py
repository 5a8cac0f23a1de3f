"""The catalog: categories by name, artgen's own and other packages'."""

import subprocess
import sys
from pathlib import Path

import pytest

import artgen
from artgen import catalog
from artgen.errors import ParameterError


def test_names_are_sorted_and_found() -> None:
    names = catalog.categories()
    assert {"door", "handle"} <= set(names)
    assert list(names) == sorted(names)
    assert [catalog.find(name).name for name in names] == list(names)


def test_an_unknown_name_shows_the_nearest() -> None:
    with pytest.raises(ParameterError, match=r"there is no category 'dor'\. Did you mean 'door'\?"):
        catalog.find("dor")


def test_generate_takes_a_name_or_a_generator() -> None:
    @artgen.generator
    def cube(*, size: artgen.Float = artgen.uniform(0.1, 0.2)) -> artgen.Body:
        return artgen.part(artgen.box(size, size, size), "cube", artgen.material("oak"))

    asset = artgen.generate(cube, seed=3, size=0.15, name="die", base="free")
    assert (asset.name, asset.category, asset.seed, asset.base) == ("die", "cube", 3, "free")
    assert asset.parameters == {"size": 0.15}


def test_generate_refuses_what_is_no_category() -> None:
    with pytest.raises(ParameterError, match="the name of a category or a generator, got 5"):
        artgen.generate(5)  # type: ignore[arg-type]


PLUGIN = """
import artgen

@artgen.category(labels=("stool",))
def stool(*, height: artgen.Float = artgen.uniform(0.4, 0.5)) -> artgen.Body:
    '''A stool.'''
    return artgen.part(artgen.cylinder(0.15, height), "stool", artgen.material("oak"))
"""


def install_plugin(folder: Path, module: str) -> None:
    (folder / "shop_stools.py").write_text(PLUGIN)
    info = folder / "shop_stools-1.0.dist-info"
    info.mkdir()
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: shop-stools\nVersion: 1.0\n")
    (info / "entry_points.txt").write_text(f"[artgen.categories]\nstools = {module}\n")


def run_with_plugin(folder: Path, statement: str) -> subprocess.CompletedProcess[str]:
    script = f"import sys; sys.path.insert(0, {str(folder)!r}); import artgen; {statement}"
    return subprocess.run(
        [sys.executable, "-W", "error", "-c", script], capture_output=True, text=True, check=False, timeout=60
    )


def test_another_package_brings_a_category(tmp_path: Path) -> None:
    install_plugin(tmp_path, "shop_stools")
    done = run_with_plugin(tmp_path, "sys.stdout.write(artgen.generate('stool', 2).name)")
    assert done.stdout == "stool_2", done.stderr


def test_a_broken_package_is_named(tmp_path: Path) -> None:
    install_plugin(tmp_path, "shop_tables")
    done = run_with_plugin(tmp_path, "artgen.catalog.categories()")
    assert "BuildError: the categories of 'shop_tables' cannot be imported" in done.stderr
