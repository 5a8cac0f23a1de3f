"""Fields: noise has its deviation, its size and its place whatever the number of texels."""

import numpy as np
import pytest

from artgen.materials.textures.fields import Tile, blend, centered, in_strips, smoothstep, with_mean

MAKERS = {
    "streaks": lambda tile: tile.streaks(0.01, 0.1),
    "fine streaks": lambda tile: tile.streaks(0.0012, 0.01),
    "cloud": lambda tile: tile.cloud(0.2, 2.0),
    "band": lambda tile: tile.band(0.02),
    "fibres": lambda tile: tile.fibres(0.2),
    "smudges": lambda tile: tile.smudges(),
}


def tile(seed, size=256, extent=(0.3, 0.6)):
    return Tile(np.random.default_rng(np.random.SeedSequence(seed)), size, extent)


@pytest.mark.parametrize("kind", MAKERS)
@pytest.mark.parametrize("seed", range(4))
def test_noise_repeats_and_is_the_same_at_every_size(kind, seed):
    coarse, fine = (MAKERS[kind](tile(seed, size)) for size in (256, 512))
    halves = fine.reshape(256, 2, 256, 2).mean(axis=(1, 3))
    assert np.corrcoef(coarse.ravel(), halves.ravel())[0, 1] > 0.9
    assert abs(coarse.mean()) < 1e-9
    for axis in (0, 1):
        steps = np.abs(np.roll(coarse, -1, axis) - coarse).mean(axis=1 - axis)
        assert steps[-1] < 1.6 * steps[:-1].mean()


@pytest.mark.parametrize("kind", ["streaks", "cloud", "band"])
@pytest.mark.parametrize("seed", range(4))
def test_noise_has_unit_deviation(kind, seed):
    for size in (256, 512):
        assert MAKERS[kind](tile(seed, size)).std() == pytest.approx(1.0, abs=0.02)


def test_waves_have_their_length_and_direction():
    spectrum = np.abs(np.fft.rfft2(tile(1).band(0.02, 0.2))) ** 2
    along, across = np.meshgrid(
        np.fft.fftfreq(256, 0.6 / 256), np.fft.rfftfreq(256, 0.3 / 256), indexing="ij"
    )
    frequency = np.hypot(along, across)
    assert (spectrum * frequency).sum() / spectrum.sum() == pytest.approx(50.0, rel=0.05)
    streaks = tile(2).streaks(0.005, 0.2)
    steps = [np.abs(np.diff(streaks, axis=axis)).mean() for axis in (0, 1)]
    assert steps[0] * 0.3 < 0.2 * steps[1] * 0.6  # per metre, far smoother along the grain


@pytest.mark.parametrize("seed", range(3))
def test_cells_are_the_nearest_points(seed):
    made = tile(seed, 256, (0.1, 0.1)).cells(0.01, 0.8)
    assert made.total == 100
    assert made.number.max() < 100
    assert (made.nearest <= made.second).all()
    assert made.nearest.max() < 0.015
    for number in (0, 57, 99):
        inside = made.number == number
        assert inside.any()
        assert made.nearest[inside].min() < 0.0006
    steps = np.abs(np.roll(made.nearest, -1, 1) - made.nearest).max()
    assert steps < 1.01 * 0.1 / 256  # nothing is farther than a texel from its neighbor, over the border too


def test_a_moved_field_is_what_lies_there():
    made = tile(3, 256, (0.256, 0.256))
    values = made.cloud(0.1)
    np.testing.assert_allclose(made.moved(values, 0.005, 0.0), np.roll(values, -5, axis=1), atol=1e-9)
    np.testing.assert_allclose(made.moved(values, 0.0, 0.003), np.roll(values, 3, axis=0), atol=1e-9)
    half = made.moved(values, 0.0005, 0.0)
    np.testing.assert_allclose(half, (values + np.roll(values, -1, axis=1)) / 2, atol=1e-9)


def test_helpers():
    values = np.linspace(-1.0, 2.0, 300)
    rise = smoothstep(0.0, 1.0, values)
    assert rise[0] == 0.0
    assert rise[-1] == 1.0
    assert (np.diff(rise) >= 0).all()
    np.testing.assert_allclose(smoothstep(1.0, 0.0, values), 1.0 - rise)
    assert centered(values).mean() == pytest.approx(0.0)
    colors = blend(np.array([[-1.0, 0.5], [1.0, 7.0]]), ((0.0, (0.0, 0.2, 0.4)), (1.0, (1.0, 0.4, 0.0))))
    np.testing.assert_allclose(colors, [[[0, 0.2, 0.4], [0.5, 0.3, 0.2]], [[1, 0.4, 0], [1, 0.4, 0]]])
    scaled = with_mean(np.random.default_rng(0).random((8, 8, 3)), (0.1, 0.2, 0.3))
    np.testing.assert_allclose(scaled.mean(axis=(0, 1)), (0.1, 0.2, 0.3))


@pytest.mark.parametrize("strip", [1, 100, 256, 1000, 10**9])
def test_strips_are_the_whole(strip, monkeypatch):
    monkeypatch.setattr("artgen.materials.textures.fields._STRIP", strip)
    drawn = np.random.default_rng(0).random((2, 37, 11))
    sums = in_strips(lambda a, b: a + 2.0 * b, drawn[0], drawn[1])
    assert np.array_equal(sums, drawn[0] + 2.0 * drawn[1])
    bytes_ = in_strips(lambda a: np.stack([a, a], axis=-1).astype(np.uint8), 255.0 * drawn[0])
    assert bytes_.dtype == np.uint8
    assert bytes_.shape == (37, 11, 2)
    made = tile(5).cells(0.01)
    monkeypatch.undo()
    for field, whole in zip(made, tile(5).cells(0.01), strict=True):
        assert np.array_equal(field, whole)
