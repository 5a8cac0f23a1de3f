"""What is only seen: it takes no part in the proof, and yet never passes through another link."""

import os

import numpy as np
import pytest

from artgen.asset import Asset
from artgen.catalog import categories, find
from support.cases import some
from support.poses import free_poses

SEEDS = range(int(os.environ.get("ARTGEN_TEST_SEEDS", "1")))


def passing(asset: Asset, q: dict[str, float]) -> set[tuple[str, str, str, str]]:
    """Return which details overlap which pieces of other links at a pose."""
    pose = asset.pose(q)
    placed = [
        (link.name, piece, piece.shape.manifold.transform(np.asarray(pose[link.name])[:3]))
        for link in asset.links
        for piece in link.pieces
    ]
    boxes = np.array([np.reshape(solid.bounding_box(), (2, 3)) for *_, solid in placed])
    found = set()
    for i, (link, piece, solid) in enumerate(placed):
        near = (boxes[i, 0] < boxes[i:, 1]).all(axis=1) & (boxes[i:, 0] < boxes[i, 1]).all(axis=1)
        for j in np.flatnonzero(near) + i:
            other, met, around = placed[j]
            seen_only = piece.visual or met.visual
            if link != other and seen_only and (solid ^ around).volume() > 1e-12:
                found.add((link, piece.label, other, met.label))
    return found


@pytest.mark.parametrize(
    ("category", "seed"), some(((name, seed) for name in categories() for seed in SEEDS), 2)
)
def test_details_do_not_pass_through_other_links(category: str, seed: int) -> None:
    asset = find(category).generate(seed, certify=False)
    found = {each for q in free_poses(asset, 6) for each in passing(asset, q)}
    assert found == set()
