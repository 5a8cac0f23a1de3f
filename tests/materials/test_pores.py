"""Pores: as much of the surface at every size, only where there may be any, across the border too."""

import numpy as np
import pytest

from artgen.materials.textures.fields import Tile
from artgen.materials.textures.wood import pores

EXTENT = (0.10, 0.40)


def drawn(seed, size=256, chance=1.0, density=2e4, length=0.004, width=0.0002):
    tile = Tile(np.random.default_rng(np.random.SeedSequence(seed)), size, EXTENT)
    return pores(tile, np.broadcast_to(chance, (size, size)), density, length, width)


@pytest.mark.parametrize("seed", range(4))
def test_pores_take_their_share_of_the_surface_at_every_size(seed):
    coarse, fine = drawn(seed, 256), drawn(seed, 512)
    assert coarse.min() == 0.0
    assert coarse.max() <= 1.0
    halves = fine.reshape(256, 2, 256, 2).mean(axis=(1, 3))
    assert np.corrcoef(coarse.ravel(), halves.ravel())[0, 1] > 0.99
    # a groove tapers to two thirds of its rectangle, and lengths spread about their median
    expected = 2e4 * 0.004 * 0.0002 * (2 / 3) * np.exp(0.45**2 / 2)
    assert fine.mean() == pytest.approx(expected, rel=0.08)
    assert coarse.mean() == pytest.approx(fine.mean(), rel=0.05)


@pytest.mark.parametrize("seed", range(4))
def test_pores_lie_only_where_they_may(seed):
    chance = np.zeros((256, 256))
    chance[:, 60:80] = 1.0
    made = drawn(seed, chance=chance)
    assert made[:, 60:80].any()
    assert not made[:, :58].any()
    assert not made[:, 82:].any()
    assert not drawn(seed, chance=0.0).any()
    half = drawn(seed, chance=0.5)
    assert half.mean() == pytest.approx(0.5 * drawn(seed).mean(), rel=0.2)


def test_pores_run_along_the_grain_and_over_the_border():
    made = drawn(1, size=512, density=3e3, length=0.02, width=0.0004)
    steps = [np.abs(np.roll(made, 1, axis) - made).mean() for axis in (0, 1)]
    assert steps[0] / (0.40 / 512) < 0.1 * steps[1] / (0.10 / 512)  # per metre
    taken = made > 0.05
    both = (taken[0] & taken[-1]).sum()
    assert both > 0.6 * taken[0].sum()


def test_more_pores_than_are_drawn_at_once_are_the_same(monkeypatch):
    whole = drawn(2)
    monkeypatch.setattr("artgen.materials.textures.wood._AT_ONCE", 37)
    np.testing.assert_allclose(drawn(2), whole, atol=1e-12)
