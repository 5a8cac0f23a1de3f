"""Textures: no seam, the color and roughness asked for, the same bytes everywhere."""

import hashlib
import io
import os
import subprocess
import sys

import numpy as np
import pytest
from numpy._core import _multiarray_umath

from artgen.errors import ParameterError
from artgen.materials import MATERIALS, Material, material
from artgen.materials.textures import (
    KINDS,
    RECIPES,
    SIZES,
    Pattern,
    Recipe,
    check_size,
    encoded,
    kinds,
    map_name,
    maps,
    tile_of,
)
from artgen.materials.textures.bake import bake
from support.cases import some

NAMES = sorted(RECIPES)


@pytest.fixture(autouse=True)
def place(tmp_path_factory, monkeypatch):
    """Keep maps away from the user's own cache, but through all tests."""
    monkeypatch.setenv("ARTGEN_CACHE", str(tmp_path_factory.getbasetemp() / "textures"))


def plain(name, **changes):
    return Material(name, RECIPES[name].base_color, texture=name, specular_roughness=0.5, **changes)


def linear(pixels):
    code = pixels / 255.0
    return np.where(code <= 0.04045, code / 12.92, ((code + 0.055) / 1.055) ** 2.4)


def present(made):
    return {kind: pixels for kind, pixels in vars(made).items() if pixels is not None}


def one_channel(made):
    """Return what the eye sees vary most: lightness, or else roughness."""
    return (made.roughness if made.albedo is None else made.albedo[..., 1]).astype(float)


def halved(values):
    return (values[::2, ::2] + values[1::2, ::2] + values[::2, 1::2] + values[1::2, 1::2]) / 4


def steps_between(pixels, axis):
    """Return by how many grey levels neighbors differ, a line of texels each; the last is the seam."""
    values = pixels.reshape(len(pixels), len(pixels), -1).astype(float)
    across = tuple(each for each in range(3) if each != axis)
    return np.abs(np.roll(values, -1, axis=axis) - values).mean(axis=across)


@pytest.mark.parametrize("name", some(NAMES, 3))
def test_a_tile_has_no_seam(name):
    for variant in range(RECIPES[name].variants):
        for kind, pixels in present(maps(plain(name, variant=variant), 256)).items():
            for axis in (0, 1):
                *inner, seam = steps_between(pixels, axis)
                # lines along the grain differ by chance; a seam would stand out from all of them
                assert seam <= 1.15 * np.quantile(inner, 0.99) + 1.0, f"{kind} {axis}"


@pytest.mark.parametrize("name", some(NAMES, 3))
def test_maps_keep_to_the_color_the_roughness_and_the_plane(name):
    recipe = RECIPES[name]
    made = maps(plain(name), 512)
    if made.albedo is not None:
        albedo = linear(made.albedo)
        np.testing.assert_allclose(albedo.mean(axis=(0, 1)), recipe.base_color, atol=0.01, rtol=0)
        assert albedo.min() > 0.010
        assert albedo.max() < 0.95
    assert abs(made.roughness.mean() / 255 - 0.5) < 0.01
    assert 0.002 < made.roughness.std() / 255 < 0.15
    if made.normal is not None:
        normal = (made.normal - 128.0) / 127.0
        np.testing.assert_allclose(np.linalg.norm(normal, axis=-1), 1.0, atol=0.02)
        mean = normal.mean(axis=(0, 1))
        assert mean[2] > 0.75
        assert np.abs(mean[:2]).max() < 0.01
        assert normal[..., 2].min() > 0.0
        assert normal[..., :2].std() > 0.005  # else it is lost in the levels of a map


@pytest.mark.parametrize("name", some(NAMES, 3))
def test_a_recipe_has_the_maps_that_it_declares(name):
    recipe = RECIPES[name]
    assert recipe.name == name
    assert recipe.varying is not None
    assert set(present(maps(plain(name), 256))) == {"roughness", *recipe.varying}
    assert set(kinds(plain(name))) == {"roughness", "orm", *recipe.varying}
    assert len(bake(recipe, 0, 256).roughness) == 256


@pytest.mark.parametrize(
    ("name", "size", "least"),
    [
        *((name, 256, 0.7) for name in NAMES),  # fine fibres are lost in so few texels
        *((name, 512, 0.9) for name in ("oak", "pine_flat_sawn", "brushed", "granite", "coarse_grain")),
    ],
)
@pytest.mark.long
def test_more_texels_show_the_same_pattern_with_more_detail(name, size, least):
    coarse, fine = (one_channel(maps(plain(name), each)) for each in (size, 2 * size))
    assert np.corrcoef(coarse.ravel(), halved(fine).ravel())[0, 1] > least


@pytest.mark.parametrize("name", some((name for name in NAMES if RECIPES[name].variants > 1), 3))
def test_variants_differ(name):
    first, second = (maps(plain(name, variant=variant), 256) for variant in (0, 1))
    pair = [one_channel(made).ravel() for made in (first, second)]
    assert np.abs(pair[0] - pair[1]).max() > 8
    if name != "plywood_edge":  # all plywood has plies
        assert abs(np.corrcoef(*pair)[0, 1]) < 0.5
    around = maps(plain(name, variant=RECIPES[name].variants), 256)
    assert np.array_equal(around.roughness, first.roughness)


def test_sizes_are_the_powers_that_engines_like():
    for size in SIZES:
        check_size(size)
        made = maps(plain("sprayed_paint"), size)
        assert made.roughness.shape == (size, size)
        assert made.normal is not None
        assert made.normal.shape == (size, size, 3)
    for size in (0, 100, 4096, "big"):
        with pytest.raises(ParameterError, match=f"256, 512, 1024, 2048 texels on a side, not {size!r}"):
            maps(material("oak"), size)
        with pytest.raises(ParameterError, match="texels on a side"):
            encoded(material("oak"), "albedo", size, "png")


def test_an_unknown_texture_or_map_names_the_nearest():
    with pytest.raises(
        ParameterError, match=r"material 'a': there is no texture 'oka'\. Did you mean 'oak'\?"
    ):
        maps(Material("a", texture="oka"), 256)
    with pytest.raises(ParameterError, match="material 'a' has no texture; give it one: with_"):
        maps(Material("a"), 256)
    assert kinds(Material("a")) == ()
    with pytest.raises(
        ParameterError, match=r"material 'chrome' has no map 'albedo'\. Allowed: orm, roughness"
    ):
        encoded(material("chrome"), "albedo", 256, "png")


def test_a_tint_moves_the_mean_and_the_roughness_its_map():
    dark = material("oak").with_(base_color=(0.2, 0.1, 0.05), specular_roughness=0.3)
    made = maps(dark, 256)
    np.testing.assert_allclose(linear(made.albedo).mean(axis=(0, 1)), (0.2, 0.1, 0.05), atol=0.005)
    assert abs(made.roughness.mean() / 255 - 0.3) < 0.01


@pytest.mark.parametrize("name", some(sorted(name for name, made in MATERIALS.items() if made.texture), 3))
def test_every_material_of_the_table_has_its_maps(name):
    made = material(name)
    assert min(tile_of(made)) > 0.0
    assert kinds(made) == tuple(kind for kind in KINDS if kind in kinds(made))
    recipe = RECIPES[made.texture]
    if "albedo" in kinds(made):  # a tint far from the recipe's own color loses levels
        factors = np.array(made.base_color) / recipe.base_color
        assert factors.min() > 0.5
        assert factors.max() < 2.0
    if "metalness" in kinds(made):
        assert abs(maps(made, 256).metalness.mean() / 255 - made.base_metalness) < 0.1


@pytest.mark.parametrize("name", ["oak", "aged_bronze", "chrome"])
def test_files_hold_the_maps(name):
    from PIL import Image

    made = material(name)
    found = maps(made, 256)
    for kind in kinds(made):
        image = Image.open(io.BytesIO(encoded(made, kind, 256, "png")))
        image.load()
        pixels = np.asarray(image)
        assert image.mode == ("L" if kind in ("roughness", "metalness") else "RGB")
        if kind == "orm":
            assert (pixels[..., 0] == 255).all()
            assert np.array_equal(pixels[..., 1], found.roughness)
            expected = round(255 * made.base_metalness) if found.metalness is None else found.metalness
            assert (pixels[..., 2] == expected).all()
        else:
            assert np.array_equal(pixels, getattr(found, kind))
        lossy = np.asarray(Image.open(io.BytesIO(encoded(made, kind, 256, "jpg")))).astype(float)
        assert np.abs(lossy - pixels).mean() < 4.0


def test_names_tell_maps_apart():
    oak = material("oak")
    others = [
        oak.with_(variant=1),
        oak.with_(base_color=(0.4, 0.25, 0.12)),
        oak.with_(specular_roughness=0.3),
        oak.with_(base_metalness=1.0),
        oak.with_(texture="walnut"),
    ]
    for other in others:
        for kind in kinds(oak):
            same = encoded(oak, kind, 256, "png") == encoded(other, kind, 256, "png")
            assert (map_name(oak, kind) == map_name(other, kind)) == same, (kind, other)
    assert map_name(oak.with_(name="door", density=1.0), "albedo") == map_name(oak, "albedo")


def test_v_points_up_and_normals_lean_with_the_slope(monkeypatch):
    def hill(stream, size):
        place = (np.arange(size) + 0.5) / size
        height = 1e-3 * np.sin(2 * np.pi * place)[None, :] + np.zeros((size, 1))
        return Pattern(None, np.zeros((size, size)), height=height.T[::-1])  # rises with v at the bottom

    monkeypatch.setitem(RECIPES, "hill", Recipe("hill", (0.5, 0.5, 0.5), hill, (0.1, 0.1)))
    hilly = Material("a", texture="hill")
    assert kinds(hilly) == ("orm", "roughness", "normal")  # found out by baking
    normal = maps(hilly, 256).normal
    assert normal[-1, 0, 1] < 128 < normal[128, 0, 1]
    assert (normal[..., 0] == 128).all()


@pytest.mark.long
def test_processes_make_the_same_bytes(tmp_path):
    program = (
        "import hashlib\n"
        "from artgen.materials import material\n"
        "from artgen.materials.textures import encoded, kinds\n"
        "found = hashlib.sha256()\n"
        "for name in ('oak_flat_sawn', 'granite', 'aged_bronze', 'linen', 'marble'):\n"
        "    for kind in kinds(material(name)):\n"
        "        for form in ('png', 'jpg'):\n"
        "            found.update(encoded(material(name), kind, 256, form))\n"
        "print(found.hexdigest())\n"
    )
    # without wide vector instructions, other roots and exponentials are computed
    narrow = " ".join(_multiarray_umath.__cpu_dispatch__)
    found = set()
    for number, more in enumerate(({}, {}, {"NPY_DISABLE_CPU_FEATURES": narrow})):
        environment = {
            **os.environ,
            **more,
            "PYTHONHASHSEED": str(number),
            "PYTHONWARNINGS": "ignore",
            "ARTGEN_CACHE": str(tmp_path / str(number)) if number else "off",
        }
        command = [sys.executable, "-c", program]
        done = subprocess.run(
            command, env=environment, capture_output=True, text=True, check=True, timeout=120
        )
        found.add(done.stdout)
    assert len(found) == 1
    assert len(found.pop().strip()) == hashlib.sha256().digest_size * 2
