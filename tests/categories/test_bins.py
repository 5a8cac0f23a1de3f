"""Walls of bins: what collides is a few facets, and nobody sees them."""

import numpy as np
import pytest
from manifold3d import Manifold

from artgen import cylinder, material, weld
from artgen.asset import Asset
from artgen.categories.trashcan.bins import Can
from support.bodies import asset_of

STEEL = material("steel")
PLANS = [("round", 0.3), ("square", 0.3), ("rectangle", 0.24), ("half_round", 0.28)]
FACETS = {"round": 16, "square": 12, "rectangle": 12, "half_round": 14}


def can(plan: str, depth: float, taper: float) -> Can:
    return Can(plan, 0.3, depth, 0.5, corner=0.04, taper=taper)  # type: ignore[arg-type]


def wall(asset: Asset, *, visual: bool) -> Manifold:
    (found,) = [piece.shape.manifold for piece in asset.links[0].pieces if piece.visual is visual]
    return found


@pytest.mark.parametrize("taper", [0.0, 0.2])
@pytest.mark.parametrize(("plan", "depth"), PLANS)
def test_what_collides_of_a_wall_is_few_facets_within_what_is_seen(
    plan: str, depth: float, taper: float
) -> None:
    asset = asset_of(weld(*can(plan, depth, taper).shell("body", STEEL)))
    core, skin = (wall(asset, visual=visual) for visual in (False, True))
    assert (core - skin).volume() < 2e-4 * core.volume()  # chords of the skin's own corners
    assert len(asset.links[0].colliders) == FACETS[plan]
    # its faces stand back from the skin's no further than the wall is thick
    low, high = np.array(skin.bounding_box()).reshape(2, 3)
    near = np.array(core.bounding_box()).reshape(2, 3)
    assert np.abs(near - [low, high]).max() < can(plan, depth, taper).wall - 0.0028


@pytest.mark.parametrize(("plan", "depth"), PLANS)
def test_facets_look_to_the_front_and_the_back(plan: str, depth: float) -> None:
    asset = asset_of(weld(*can(plan, depth, 0.0).shell("body", STEEL)))
    corners = wall(asset, visual=False).to_mesh().vert_properties[:, :3]
    for side in (corners[:, 1].min(), corners[:, 1].max()):
        across = corners[np.abs(corners[:, 1] - side) < 1e-6, 0]
        assert across.min() == pytest.approx(-across.max())
        assert across.max() > 0.02


def test_a_hole_passes_through_what_collides_and_what_is_seen() -> None:
    hole = cylinder(0.02, 0.2, axis=(0.0, 1.0, 0.0)).at(0.0, -0.15, 0.2)
    asset = asset_of(weld(*can("round", 0.3, 0.0).shell("body", STEEL, holes=hole)))
    probe = Manifold.cylinder(0.2, 0.018, circular_segments=32).rotate([90.0, 0.0, 0.0])
    for visual in (False, True):
        assert (wall(asset, visual=visual) ^ probe.translate([0.0, -0.05, 0.2])).volume() < 1e-12
