"""What is special to a washing machine: the hook of its door, its drum, its kinds and their sizes."""

from functools import lru_cache
from typing import Any

import numpy as np
import pytest
from manifold3d import Manifold

from artgen.asset import Asset
from artgen.catalog import find
from artgen.errors import InfeasibleError


@lru_cache(maxsize=8)
def made(seed: int, **given: Any) -> Asset:
    return find("washing_machine").generate(seed, certify=False, **given)


def test_the_door_opens_only_while_its_handle_is_pulled() -> None:
    asset = made(0, kind="front", size="full", lever=True)
    assert asset.blocked({"door_hinge": 0.05}) == ("door_hinge",)
    assert asset.blocked({"door_hinge": 0.05, "handle_pull": 0.26}) == ()
    assert asset.blocked({"door_hinge": 1.0}) == (), "beyond its strike, the hook is free"
    needs = asset.joint("door_hinge").needs
    assert needs is not None
    apart = asset.clearance({"door_hinge": 0.05})
    assert min(gap for pair, gap in apart.items() if "handle" in pair and "body" in pair) < 0.0


def test_a_door_without_a_hook_is_held_by_friction() -> None:
    asset = made(0, kind="front", size="full", lever=False)
    hinge = asset.joint("door_hinge")
    assert hinge.needs is None
    assert 4.0 <= hinge.friction / (2 * (asset.parameters["porthole"] * asset.parameters["width"])) <= 9.0
    assert "handle_pull" not in [joint.name for joint in asset.joints]


@pytest.mark.parametrize("kind", ["front", "dryer"])
def test_laundry_goes_through_the_opening_into_the_drum(kind: str) -> None:
    asset = made(3, kind=kind, size="full")
    low, high = asset.link("drum").bounds()
    bundle = Manifold.sphere(0.10, 24).translate((0.0, 0.0, (low[2] + high[2]) / 2))
    for link in ("body", "drum"):
        solids = [collider.convex.manifold(0.001) for collider in asset.link(link).colliders]
        for y in np.linspace(low[1] - 0.07, high[1] - 0.15, 5):
            way = bundle.translate((0.0, y, 0.0))
            assert all((solid ^ way).is_empty() for solid in solids), f"{link} is in the way at y = {y:.3f}"


@pytest.mark.parametrize(
    ("given", "wide", "kilograms"),
    [
        ({"kind": "front", "size": "full"}, (0.59, 0.605), (58.0, 85.0)),
        ({"kind": "front", "size": "compact"}, (0.50, 0.52), (38.0, 60.0)),
        ({"kind": "front", "size": "wide"}, (0.68, 0.69), (81.0, 100.0)),
        ({"kind": "top", "size": "wide"}, (0.68, 0.69), (50.0, 75.0)),
        ({"kind": "dryer", "size": "full"}, (0.59, 0.605), (45.0, 66.0)),
    ],
)
def test_sizes_and_mass_by_kind(
    given: dict[str, str], wide: tuple[float, float], kilograms: tuple[float, float]
) -> None:
    asset = made(1, **given)
    low, high = asset.bounds()
    assert wide[0] <= high[0] - low[0] <= wide[1]
    assert kilograms[0] <= asset.mass <= kilograms[1]


def test_an_agitator_turns_in_its_basket() -> None:
    asset = made(2, kind="top", size="wide", agitator=True)
    turn, spin = asset.joint("agitator_turn"), asset.joint("drum_spin")
    assert turn.parent == "drum"
    assert turn.limits is None
    assert spin.limits is None
    assert np.allclose(turn.axis, spin.axis)


def test_a_console_refuses_buttons_beyond_its_end() -> None:
    given: dict[str, Any] = {"kind": "dryer", "size": "full", "drawer": True, "dials": 2, "show": "2:10"}
    with pytest.raises(InfeasibleError, match="need a wider console"):
        made(1, buttons=6, **given)
    assert sum(link.name.startswith("button") for link in made(1, buttons=2, **given).links) == 2


def test_a_flat_top_loader_is_refused() -> None:
    assert find("washing_machine").generate(1, kind="top", depth=0.45).certificate.proven
    with pytest.raises(InfeasibleError, match=r"depth of a top loader must be >= 0\.45 m"):
        find("washing_machine").generate(1, kind="top", depth=0.44)


def test_a_high_backsplash_of_a_compact_machine_is_refused() -> None:
    options = {"kind": "top", "size": "compact"}
    assert find("washing_machine").generate(1, backsplash=0.15, **options).certificate.proven
    with pytest.raises(InfeasibleError, match=r"backsplash of a compact machine must be <= 0\.15 m"):
        find("washing_machine").generate(1, backsplash=0.16, **options)
