"""Find similar samples of a category: compare small pictures of them pixel by pixel."""

from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.errors import ArtgenError
from artgen.generator import Generator
from artgen.view.camera import View
from artgen.view.sheet import shots
from artgen.view.tracing import cast

SAME = 0.07
"""Difference below which two samples look like one product, such as one appliance in two sizes."""

_SIZE = 40  # pixels on a side
_NEAR = 1  # largest shift between equal pixels [pixels]
_FINE = 3  # rays on a side of a pixel
_LIGHT = np.array([-0.45, -0.70, 0.55])  # direction to the light: in front, above, left
_DARK = 0.35  # brightness of an unlit face, over that of a lit one
_GAMMA = 1.0 / 2.2  # exponent of perceived brightness
_CONTRAST = 2.5  # colors that differ by 1 / 2.5 of the way from black to white count as fully different
_WHERE = 2  # pictures of a sample: closed and open, from the front


@dataclass(frozen=True)
class Likeness:
    """The difference of two samples."""

    seeds: tuple[int, int]  # the seeds of both samples
    difference: float  # 0 for equal pictures, 1 for entirely different ones
    near: bool  # whether they are neighbors on a contact sheet


def likenesses(category: Generator, seeds: Iterable[int]) -> list[Likeness]:
    """Return the difference of each pair of samples, the most similar pair first.

    Size does not count, as each sample fills its pictures; nor do the patterns of materials, so that two oaks
    differ by their color alone. Samples that cannot be made are omitted.
    """
    looks: dict[int, Array] = {}
    for seed in seeds:
        with suppress(ArtgenError):
            looks[seed] = look(category.generate(seed, certify=False))
    order = {seed: number for number, seed in enumerate(looks)}
    pairs = [
        Likeness((first, second), difference(looks[first], looks[second]), order[second] - order[first] == 1)
        for first, second in combinations(looks, 2)
    ]
    return sorted(pairs, key=lambda pair: pair.difference)


def look(asset: Asset) -> Array:
    """Return small pictures of an asset, closed and open: color and coverage, shape (n, size, size, 4)."""
    return np.array([_picture(asset, q, view) for q, view in shots(asset)[:_WHERE]])


def difference(first: Array, second: Array) -> float:
    """Return the difference of two looks where either shows something, 0 to 1.

    Each pixel is compared with the most similar one nearby in the other picture: a slightly wider door is no
    different door.
    """
    return (_unmatched(first, second) + _unmatched(second, first)) / 2.0


def _unmatched(look: Array, other: Array) -> float:
    """Return the share of one look that is not in another one, 0 to 1."""
    around = ((0, 0), (_NEAR, _NEAR), (_NEAR, _NEAR), (0, 0))
    padded = np.pad(other, around)
    size = look.shape[1]
    best = np.ones(look.shape[:-1])
    for down in range(2 * _NEAR + 1):
        for right in range(2 * _NEAR + 1):
            moved = padded[:, down : down + size, right : right + size]
            apart = np.linalg.norm(look[..., :3] - moved[..., :3], axis=-1) / np.sqrt(3.0)
            common = np.minimum(look[..., 3], moved[..., 3])
            either = np.maximum(look[..., 3], moved[..., 3])
            best = np.minimum(best, either - common + common * np.minimum(_CONTRAST * apart, 1.0))
    shown = look[..., 3]
    return float(np.mean((best * shown).sum(axis=(1, 2)) / np.maximum(shown.sum(axis=(1, 2)), 1e-9)))


def _picture(asset: Asset, q: Mapping[str, float], view: View) -> Array:
    poses = asset.pose(q)
    seen = [(surface, poses[link.name]) for link in asset.links for surface in link.surfaces]
    meshes = [surface.mesh.moved(pose) for surface, pose in seen]
    camera = view.camera(np.concatenate([mesh.vertices for mesh in meshes]))
    fine = _SIZE * _FINE
    hits = cast(meshes, np.array(camera.position), camera.rays((fine, fine)))
    colors = np.array([[0.0, 0.0, 0.0], *(surface.material.base_color for surface, _ in seen)])
    # the light on a face depends on its angle; faces that are visible from behind are lit as well
    lit = _DARK + (1.0 - _DARK) * np.abs(hits.normals @ (_LIGHT / np.linalg.norm(_LIGHT)))
    rgb = (colors[hits.surfaces] * lit[:, None]) ** _GAMMA
    covered = (hits.surfaces > 0).astype(float)
    parts = np.column_stack([rgb * covered[:, None], covered]).reshape(_SIZE, _FINE, _SIZE, _FINE, 4)
    mean = parts.mean(axis=(1, 3))
    mean[..., :3] /= np.maximum(mean[..., 3:], 1e-9)
    return np.asarray(mean)


def same_neighbors(pairs: Sequence[Likeness]) -> list[Likeness]:
    """Return the pairs of neighbors that look like one product."""
    return [pair for pair in pairs if pair.near and pair.difference < SAME]
