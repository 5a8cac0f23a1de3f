"""Assets with one fault each: none that collides is proven, and few are undecided.

`ARTGEN_TEST_MUTANTS=100000 ARTGEN_TEST_POSES=10000 pytest tests/validate/test_mutations.py` tries all of
them; `benchmarks/mutations.py` prints what came of each.
"""

import os
from collections import Counter
from dataclasses import replace
from functools import cache
from itertools import islice, zip_longest

import numpy as np
import pytest

from artgen.asset import Asset
from artgen.catalog import categories, find
from support.brute import draw_poses, overlaps
from support.cases import long, some
from support.mutations import Mutant, Outcome, judged, mutants
from support.proof_assets import PROOF_ASSETS

COUNT = int(os.environ.get("ARTGEN_TEST_MUTANTS", "3"))  # of each asset
POSES = int(os.environ.get("ARTGEN_TEST_POSES", "200"))
UNDECIDED = 0.01  # share of mutants

NAMES = some((*PROOF_ASSETS, *categories()), 10)


@cache
def asset_of(name: str) -> Asset:
    return PROOF_ASSETS[name]() if name in PROOF_ASSETS else find(name).generate(0, certify=False)


def chosen(name: str, count: int) -> list[Mutant]:
    """Some mutants of an asset, those of every kind first."""
    by_kind: dict[str, list[Mutant]] = {}
    for mutant in mutants(asset_of(name)):
        by_kind.setdefault(mutant.kind, []).append(mutant)
    order = np.random.default_rng(1)
    for of_kind in by_kind.values():
        order.shuffle(of_kind)  # type: ignore[arg-type]
    rows = zip_longest(*by_kind.values())
    return list(islice((mutant for row in rows for mutant in row if mutant is not None), count))


@cache
def outcomes(name: str) -> list[Outcome]:
    return [judged(mutant, POSES) for mutant in chosen(name, COUNT)]


@pytest.mark.parametrize("name", NAMES)
def test_no_mutant_that_collides_is_proven_and_few_are_undecided(name: str) -> None:
    found = outcomes(name)
    missed = [str(outcome) for outcome in found if outcome.missed]
    assert not missed, "\n".join(missed)
    undecided = [str(outcome) for outcome in found if outcome.undecided]
    assert len(undecided) <= UNDECIDED * len(found), "\n".join(undecided)


@long
def test_many_mutants_collide() -> None:
    found = [outcome for name in PROOF_ASSETS for outcome in outcomes(name)]
    assert sum(outcome.overlap is not None for outcome in found) > 0.1 * len(found)


@pytest.mark.parametrize("name", NAMES)
def test_mutants_differ_from_the_asset_in_one_place(name: str) -> None:
    asset = asset_of(name)
    found = list(mutants(asset))
    assert len({mutant.what for mutant in found}) == len(found)
    for mutant in chosen(name, 30):
        links = [a.name for a, b in zip(asset.links, mutant.asset.links, strict=True) if a is not b]
        joints = [
            a.name
            for a, b in zip(asset.joints, mutant.asset.joints, strict=True)
            if replace(a, limits=None if a.follows else a.limits).to_data()
            != replace(b, limits=None if b.follows else b.limits).to_data()
        ]
        assert len(links) + len(joints) == 1, mutant.what
        assert (mutant.kind == "wide") == bool(links)


def test_a_wider_link_is_wider_along_each_axis_and_stays_in_its_place() -> None:
    asset = asset_of("lamp")
    (mutant,) = (each for each in mutants(asset) if each.what == "lower_arm wider by 4.93 mm")
    before, after = asset.link("lower_arm").bounds(), mutant.asset.link("lower_arm").bounds()
    np.testing.assert_allclose(np.ptp(after, axis=0), np.ptp(before, axis=0) + 0.00493, atol=1e-9)
    np.testing.assert_allclose(after.sum(axis=0), before.sum(axis=0), atol=1e-9)


@pytest.mark.long
def test_faults_of_every_kind_make_links_overlap() -> None:
    kinds: Counter[str] = Counter()
    for name in ("bearing_door", "fridge"):
        for mutant in chosen(name, 16):
            kinds[mutant.kind] += bool(overlaps(mutant.asset, draw_poses(mutant.asset, 200), most=1))
    assert {kind for kind, count in kinds.items() if count} >= {"pivot", "wide", "dependency", "limits"}
