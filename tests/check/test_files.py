"""The check of an export's files knows the maps: there, whole, and none that is named in vain."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from artgen.check.files import read_export
from artgen.export import export
from support.exports import edit_text
from support.textured import recipes, textured

AGAIN = "export the asset again"


@pytest.fixture(scope="module", autouse=True)
def registered_recipes() -> Iterator[None]:
    with recipes():
        yield


@pytest.fixture
def directory(tmp_path: Path) -> Path:
    return export(textured(), tmp_path / "it", textures=256)


def found(directory: Path) -> list[str]:
    return [str(finding) for finding in read_export(directory).result.findings]


def a_map(directory: Path, kind: str) -> Path:
    return next(iter(sorted((directory / "meshes/textures").glob(f"*_{kind}*.png"))))


def test_maps_are_files_of_the_export(directory: Path) -> None:
    assert not found(directory)


def test_missing_map_is_named_with_the_formats_that_need_it(directory: Path) -> None:
    path = a_map(directory, "albedo")
    path.unlink()
    (text,) = found(directory)
    assert f"meshes/textures/{path.name} is missing, which urdf and mjcf and usd need" in text
    assert AGAIN in text


@pytest.mark.parametrize("cut", [10, 400])
def test_damaged_map_is_no_image(directory: Path, cut: int) -> None:
    path = a_map(directory, "normal")
    path.write_bytes(path.read_bytes()[:cut])
    (text,) = found(directory)
    assert f"meshes/textures/{path.name} is no image that can be decoded, which urdf" in text


def test_map_that_nobody_wrote_is_a_fault_among_textures(directory: Path) -> None:
    (directory / "meshes/textures/old.png").write_bytes(b"old")
    (text,) = found(directory)
    assert "meshes/textures/old.png is listed by no format of asset.json" in text


def test_library_that_names_another_map_is_a_fault(directory: Path) -> None:
    name = a_map(directory, "normal").name
    edit_text(directory / "meshes/textured.mtl", f"norm textures/{name}", "norm textures/none.png")
    (text,) = found(directory)
    assert "meshes/textured.mtl names the map textures/none.png, which is listed by no format" in text


def test_maps_alone_are_no_visible_faces(tmp_path: Path) -> None:
    exported = read_export(export(textured(), tmp_path / "it", formats=("usd",), textures=256))
    assert not exported.meshes
    assert not exported.result.findings
