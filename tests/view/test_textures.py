"""Maps in pictures: each repeat is upright, unmirrored, and where the texture coordinates put it."""

import numpy as np
import pytest
from scipy import ndimage

from artgen.asset.surface import texture_coordinates
from artgen.generator import generator
from artgen.materials import material
from artgen.materials.textures import RECIPES, Pattern, Recipe
from artgen.nodes.body import part
from artgen.nodes.handles import Body
from artgen.nodes.primitive import box, sphere
from artgen.view import View, shading
from artgen.view.tracing import cast

TILE = (0.3, 0.4)
QUARTERS = np.array([[[0.6, 0.05, 0.05], [0.05, 0.6, 0.05]], [[0.05, 0.05, 0.6], [0.5, 0.5, 0.5]]])
"""Red above, left; green above, right; blue below, left; grey below, right."""


def quarters(stream: np.random.Generator, size: int) -> Pattern:
    albedo = np.repeat(np.repeat(QUARTERS, size // 2, axis=0), size // 2, axis=1)
    return Pattern(albedo, np.zeros((size, size)))


@pytest.fixture(autouse=True)
def recipe(monkeypatch) -> None:
    mean = tuple(QUARTERS.reshape(4, 3).mean(axis=0).tolist())
    monkeypatch.setitem(RECIPES, "quarters", Recipe("quarters", mean, quarters, tile=TILE))


@generator
def board(*, turned: bool = False) -> Body:
    mean = tuple(QUARTERS.reshape(4, 3).mean(axis=0).tolist())
    painted = material("painted_wood").with_(
        name="quarters", texture="quarters", base_color=mean, specular_roughness=1.0, turned=turned
    )
    return part(box(0.8, 0.1, 1.1), "board", painted)


@pytest.mark.parametrize("turned", [False, True])
def test_every_pixel_has_the_color_of_its_texel(turned) -> None:
    pytest.importorskip("embreex", reason="needs Embree: artgen[sim]")
    asset = board.generate(turned=turned)
    size = (120, 120)
    for view in (View(-0.5, 0.3), View(2.6, 0.9)):
        shown = asset.render(camera=view, size=size, textures=256, studio="none")
        found = cast(
            [surface.mesh for surface in asset.links[0].surfaces],
            np.array(shown.camera.position),
            shown.camera.rays(size),
        )
        expected = _texels(asset, found)
        color = shown.color.reshape(-1, 3).astype(int)
        sure = expected >= 0
        assert sure.sum() > 1000
        for quarter, channel in enumerate((0, 1, 2)):
            here = color[sure & (expected == quarter)]
            others = np.delete(here, channel, axis=1).max(axis=1)
            assert (here[:, channel] > others + 20).mean() > 0.98, quarter
        grey = color[sure & (expected == 3)]
        assert (np.ptp(grey, axis=1) < 30).mean() > 0.98


def _texels(asset, found) -> np.ndarray:
    """Return the quarter of the map that each ray hits, -1 near its edges and where it hits nothing."""
    (surface,) = asset.links[0].surfaces
    uvs = texture_coordinates(surface.mesh, surface.material)[surface.mesh.triangles]
    hit = found.surfaces > 0
    result = np.full(len(hit), -1)
    at = (found.shares[hit][:, :, None] * uvs[found.triangles[hit]]).sum(axis=1)
    within = at - np.floor(at)
    clear = (np.abs(within % 0.5 - 0.25) < 0.2).all(axis=1)
    quarter = 2 * (within[:, 1] < 0.5) + (within[:, 0] >= 0.5)
    result[hit] = np.where(clear, quarter, -1)
    return result


@generator
def plate(*, turned: bool = False) -> Body:
    return part(box(0.6, 0.02, 0.6), "plate", material("stainless_across" if turned else "stainless"))


@pytest.mark.parametrize("turned", [False, True])
def test_brushed_metal_shows_its_strokes(turned) -> None:
    pytest.importorskip("embreex", reason="needs Embree: artgen[sim]")
    shown = plate.generate(turned=turned).render(camera=View(0.0, 0.05), size=200, textures=512)
    light = shown.color[50:150, 50:150].mean(axis=2)
    fine = light - ndimage.gaussian_filter(light, 4.0)
    down, right = (np.abs(np.diff(fine, axis=axis)).mean() for axis in (0, 1))
    across, along = (down, right) if turned else (right, down)
    assert across > 1.5  # averaging over neighbors left 0.6
    assert across > 2.0 * along


@generator
def ball(*, cloth: str = "velvet") -> Body:
    return part(sphere(0.3), "ball", material(cloth))


def test_velvet_is_light_at_its_edge(monkeypatch) -> None:
    pytest.importorskip("embreex", reason="needs Embree: artgen[sim]")
    asset, gain = ball.generate(), []
    for fuzz in (shading._FUZZ, {}):
        monkeypatch.setattr(shading, "_FUZZ", fuzz)
        shown = asset.render(size=128, textures=0)
        mask = shown.links.ids > 0
        inner, middle = (ndimage.binary_erosion(mask, iterations=depth) for depth in (6, 20))
        edge = ndimage.binary_erosion(mask, iterations=2) & ~inner
        light = shown.color.mean(axis=2)
        gain.append(light[edge].mean() - light[middle].mean())
    assert gain[0] > gain[1] + 15.0
