"""Maps as files: the same for every format, of the right color, and no obstacle to reading an asset back."""

import io
import json
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PIL import Image

from artgen.asset import Asset, Mesh
from artgen.asset.surface import metric_coordinates, texture_coordinates
from artgen.export import export
from artgen.export.maps import map_files
from artgen.export.urdf import write_urdf
from artgen.export.usd import write_usd
from support.textured import BOARD, LAMP, PANE, PLATE, TURNED, recipes, textured

NONE = np.zeros(0, np.int64)


@pytest.fixture(scope="module", autouse=True)
def registered_recipes() -> Iterator[None]:
    with recipes():
        yield


def linear(content: bytes) -> np.ndarray:
    """Return the linear colors of an sRGB image, shape (n, n, 3)."""
    code = np.asarray(Image.open(io.BytesIO(content))) / 255.0
    return np.where(code <= 0.04045, code / 12.92, ((code + 0.055) / 1.055) ** 2.4)


def tree(directory: Path) -> dict[str, bytes]:
    return {
        path.relative_to(directory).as_posix(): path.read_bytes()
        for path in sorted(directory.rglob("*"))
        if path.is_file()
    }


@pytest.mark.parametrize("size", [256, 512])
def test_mean_of_the_maps_is_the_material(size: int) -> None:
    found = map_files(textured(), size)
    for stuff in (BOARD, PLATE, TURNED, PANE):
        names = found.of(stuff)
        if "albedo" in names:
            mean = linear(found.files[f"meshes/textures/{names['albedo']}"]).mean(axis=(0, 1))
            np.testing.assert_allclose(mean, stuff.base_color, rtol=0.01, atol=0.003)
        roughness = np.asarray(Image.open(io.BytesIO(found.files[f"meshes/textures/{names['roughness']}"])))
        assert roughness.shape == (size, size), "one channel"
        # the darkest of a smooth surface are cut off at 0
        assert roughness.mean() / 255.0 == pytest.approx(stuff.specular_roughness, abs=0.02)
    assert set(found.of(PLATE)) == {"roughness", "metalness"}
    assert set(found.of(BOARD)) == {"albedo", "roughness", "normal"}
    assert not found.of(LAMP)
    assert len(found.files) == len({name for stuff in found.names.values() for name in stuff.values()})


@given(
    uvs=st.lists(st.tuples(st.floats(-9.0, 9.0), st.floats(-9.0, 9.0)), min_size=1),
    tile=st.one_of(st.none(), st.tuples(st.floats(0.01, 3.0), st.floats(0.01, 3.0))),
    turned=st.booleans(),
)
def test_texture_coordinates_are_read_back_in_metres(
    uvs: list[tuple[float, float]], tile: tuple[float, float] | None, *, turned: bool
) -> None:
    wanted = np.array(uvs)
    mesh = Mesh(np.zeros((len(wanted), 3)), np.zeros((len(wanted), 3)), wanted, NONE, NONE.reshape(0, 3))
    for stuff in (BOARD.with_(tile=tile, turned=turned), LAMP):
        found = metric_coordinates(texture_coordinates(mesh, stuff), stuff)
        np.testing.assert_allclose(found, wanted, atol=1e-12, err_msg=stuff.name)


def test_no_maps_unless_asked_for() -> None:
    found = map_files(textured(), 0)
    assert not found.files
    assert not found.of(BOARD)


def test_every_format_has_the_same_maps(tmp_path: Path) -> None:
    asset = textured()
    data = {}
    for name in ("urdf", "mjcf", "usd"):
        directory = export(asset, tmp_path / name, formats=(name,), textures=256)
        files = {path: content for path, content in tree(directory).items() if path.endswith(".png")}
        data[name] = files
        recorded = json.loads((directory / "asset.json").read_text())["formats"][name]["files"]
        assert set(files) <= set(recorded)
    assert data["urdf"] == data["mjcf"] == data["usd"] == dict(map_files(asset, 256).files)
    assert write_urdf(asset, 256).files.keys() & write_usd(asset, 256).files.keys() == set(data["usd"])


@pytest.mark.parametrize("size", [0, 256])
def test_asset_read_back_is_exported_to_the_same_bytes(size: int, tmp_path: Path) -> None:
    asset = textured()
    first = export(asset, tmp_path / "first", textures=size)
    loaded = Asset.load(first)
    second = export(loaded, tmp_path / "second", formats=("urdf", "mjcf"), textures=size)
    again = tree(second)
    before = tree(first)
    shared = set(again) - {"asset.json"}
    assert len(shared) == 8 + 7 * bool(size)
    assert {path: before[path] for path in shared} == {path: again[path] for path in shared}
    for link in asset.links:
        for found, surface in zip(loaded.link(link.name).surfaces, link.surfaces, strict=True):
            assert found.material == surface.material
            np.testing.assert_allclose(found.mesh.uvs, surface.mesh.uvs, atol=1e-6, err_msg=link.name)
