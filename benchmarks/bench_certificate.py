"""Compare the certificate with random poses: time to the same confidence, and faults found."""

import math
import random
import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from contacts import Links, Pairs, convex_links, moving_pairs, random_positions, surface_links
from report import Section, Table, shown, span
from timing import alternating, baseline, seconds

sys.path.append(str(Path(__file__).parents[1] / "tests"))

import artgen
from artgen.asset import Asset
from artgen.asset.certificate import Certificate
from support.mutations import Mutant, mutants
from support.proof_assets import PROOF_ASSETS

CONFIDENCE = 0.99
SHARES = (1e-3, 1e-4)
"""Shares of the joint ranges that a collision may take."""

TARGETS = {
    "bearing_door": 0.080,
    "fridge": 0.050,
    "french_fridge": 0.400,
    "lamp": 0.040,
    "dishwasher": 0.060,
    "cooktop": 0.150,
}
"""What a proof of an asset made for tests may take; to measure the clearances it may take twice that [s]."""

_TRIED = (10, 100, 1000)  # poses
_RANGE = 3.0  # of the joint of the thin blade [rad]
_PIN = 1.234  # where its pin stands [rad]
_RADIUS = 0.45  # how far from the hinge [m]

_COMPARED = f"""
A certificate says of every position within the joint ranges that no links collide. N random poses, each
checked by python-fcl on the same colliders, miss a collision that takes a share p of the ranges with a
chance of (1 - p)^N: to be {CONFIDENCE:.0%} sure that there is none takes N = ln({1 - CONFIDENCE:.2g}) /
ln(1 - p) poses. Time to the same confidence is N times that of a pose, of which the middle of a few is
measured; placing the links is counted, finding out where they are is not. FCL is given the colliders one by
one, and those of a link as one surface, and the quicker of both counts. The thin blade is an arm that
passes a pin, both so thin that they meet on the share of the range that is given; *not proven*
is a refusal, too. Faults are those of `tests/support/mutations.py`, without pairs that may touch by design.
"""


@dataclass(frozen=True)
class Timed:
    """Times of both methods for one asset.

    Attributes:
        pairs: Number of checked pairs of links.
        certificate: Time of the certificate [s].
        pose: Time of one pose [s].
    """

    pairs: int
    certificate: float
    pose: float


def measure(*, quick: bool) -> Section:
    """Run the benchmark."""
    names = ["plier"] if quick else ["cabinet", "door", "drawer", "microwave", "plier", "refrigerator"]
    runs, poses = (1, 10) if quick else (5, 200)
    shares = (1e-2,) if quick else (1e-1, 1e-2, 1e-3, 1e-4)
    timed = {name: _timed(partial(_evaluated, name), runs, poses) for name in names}
    blades = {blade_share(thin_blade(share)): partial(thin_blade, share) for share in shares}
    thin = {share: _timed(make, runs, poses) for share, make in blades.items()}
    verdicts = {share: verdict(make()) for share, make in blades.items()}
    faulty = {
        name: _faults(name, 3 if quick else 20)
        for name in (["lamp"] if quick else ["bearing_door", "cooktop", "sliding_gate"])
    }
    targets = _targets(["lamp"] if quick else list(TARGETS), runs)
    return Section(
        "certificate against sampling",
        _COMPARED,
        [_time_table(timed), _thin_table(thin, verdicts), _fault_table(faulty), targets],
        _findings(timed, thin, verdicts, faulty),
    )


def thin_blade(share: float) -> Asset:
    """Make an arm that collides with a pin in about the given share of the range of its hinge."""
    width = share * _RANGE * _RADIUS / 2.0
    metal = artgen.material("steel")
    plate = artgen.box(1.2, 1.2, 0.02)
    x, y = _RADIUS * math.cos(_PIN), _RADIUS * math.sin(_PIN)
    pin = artgen.box(0.02, width, 0.12).rotate(artgen.Z, _PIN).at(x, y, 0.06)
    arm = artgen.box(0.5, width, 0.02).at(0.25, 0.0, 0.06)
    hinge = artgen.Revolute("hinge", axis=artgen.Z, pivot=(0.0, 0.0, 0.06), limits=(0.0, _RANGE))
    body = artgen.part(plate | pin, "base", metal).attach(artgen.part(arm, "arm", metal), hinge)
    evaluation = artgen.Graph(body).evaluate({}, artgen.graph.Cache())
    return Asset.from_tree(evaluation.value, "thin_blade", "thin_blade")


def blade_share(asset: Asset) -> float:
    """Return the share of the hinge range in which a thin blade hits its pin, by bisection."""
    links, pairs = convex_links(asset), moving_pairs(asset)

    def meets(angle: float) -> bool:
        links.place(asset.pose({"hinge": angle}))
        return bool(links.collide(pairs))

    def edge(inside: float, outside: float) -> float:
        for _ in range(40):
            middle = (inside + outside) / 2.0
            inside, outside = (middle, outside) if meets(middle) else (inside, middle)
        return inside

    return (edge(_PIN, _RANGE) - edge(_PIN, 0.0)) / _RANGE


def verdict(asset: Asset) -> str:
    """Return the verdict of the certificate: `proven`, `collision`, or `not proven` if it is undecided."""
    certificate = asset.certify()
    if certificate.proven:
        return "proven"
    return "collision" if _collides(certificate, moving_pairs(asset)) else "not proven"


def _collides(certificate: Certificate, pairs: Pairs) -> bool:
    """Tell whether the certificate reports a collision of solids or colliders for some pairs."""
    looked = {frozenset(pair) for pair in pairs}
    return any(
        "collision" in (pair.verdict, pair.colliders)
        for pair in certificate.pairs
        if frozenset(pair.links) in looked
    )


def poses_for(share: float) -> int:
    """Return the number of random poses that find a collision in a share of the range with `CONFIDENCE`."""
    return math.ceil(math.log(1.0 - CONFIDENCE) / math.log1p(-share))


def _evaluated(name: str) -> Asset:
    return artgen.catalog.find(name).generate(0, cache=artgen.graph.Cache(), certify=False)


def _timed(make: Callable[[], Asset], runs: int, poses: int) -> Timed:
    """Time certificate and poses alternately, each with a new asset, so that no cache is warm."""
    asset = make()
    _prepared(asset)
    pairs = moving_pairs(asset)
    placed = [asset.pose(q) for q in random_positions(asset, poses)]

    def certificate() -> float:
        new = make()
        _prepared(new)
        return seconds(new.certify)

    def sampled(links: Links) -> float:
        def check() -> None:
            for pose in placed:
                links.place(pose)
                links.collide(pairs)

        return seconds(check) / poses

    works: dict[str, Callable[[], float]] = {
        "certificate": certificate,
        "convex": partial(sampled, convex_links(asset)),
        "surface": partial(sampled, surface_links(asset)),
    }
    found = alternating(works, runs + 1)
    return Timed(len(pairs), found["certificate"], min(found["convex"], found["surface"]))


def _prepared(asset: Asset) -> None:
    for link in asset.links:
        _ = link.colliders


def _faults(name: str, most: int) -> dict[str, int]:
    """Count the faults of an asset that the certificate finds, and those of them that random poses find."""
    chosen: Sequence[Mutant] = list(mutants(PROOF_ASSETS[name]()))
    if most < len(chosen):
        chosen = random.Random(name).sample(chosen, most)  # noqa: S311 - no secret
    found = {"faults": len(chosen), "certificate": 0, **{str(count): 0 for count in _TRIED}, "missed": 0}
    for mutant in chosen:
        first = _first_hit(mutant.asset, max(_TRIED))
        if not _collides(mutant.asset.certify(), moving_pairs(mutant.asset)):
            found["missed"] += first is not None
            continue
        found["certificate"] += 1
        for count in _TRIED:
            found[str(count)] += first is not None and first < count
    return found


def _first_hit(asset: Asset, poses: int) -> int | None:
    """Return the number of the first random pose at which links collide."""
    links, pairs = convex_links(asset), moving_pairs(asset)
    for number, q in enumerate(random_positions(asset, poses)):
        links.place(asset.pose(q))
        if links.collide(pairs):
            return number
    return None


def _targets(names: Sequence[str], runs: int) -> Table:
    """Time the proofs of test assets against their targets."""

    def certified(name: str, *, clearances: bool) -> float:
        asset = PROOF_ASSETS[name]()
        _prepared(asset)
        return seconds(partial(asset.certify, measure=clearances))

    unit = baseline()
    rows = []
    for name in names:
        certified(name, clearances=False)  # imports are no part of the figures
        found = alternating(
            {
                "prove": partial(certified, name, clearances=False),
                "measure": partial(certified, name, clearances=True),
            },
            runs,
        )
        asset = PROOF_ASSETS[name]()
        certificate = asset.certify()
        rows.append(
            (
                name,
                len(asset.links),
                len(certificate.pairs),
                certificate.proven,
                1e3 * TARGETS[name],
                1e3 * found["prove"],
                found["prove"] / TARGETS[name],
                1e3 * found["measure"],
                found["prove"] / unit,
            )
        )
    return Table(
        "Test assets: time of a proof, and its target",
        (
            "asset",
            "links",
            "pairs",
            "proven",
            "target [ms]",
            "prove [ms]",
            "of target",
            "measure [ms]",
            "prove / fixed workload",
        ),
        rows,
    )


def _time_table(timed: Mapping[str, Timed]) -> Table:
    return Table(
        "Time to the same confidence",
        (
            "asset",
            "pairs",
            "certificate [ms]",
            "pose [ms]",
            *(f"{poses_for(share)} poses (p = {share:g}) [s]" for share in SHARES),
            *(f"ratio, p = {share:g}" for share in SHARES),
        ),
        [
            (
                name,
                each.pairs,
                1e3 * each.certificate,
                1e3 * each.pose,
                *(poses_for(share) * each.pose for share in SHARES),
                *(poses_for(share) * each.pose / each.certificate for share in SHARES),
            )
            for name, each in timed.items()
        ],
    )


def _chance(share: float, each: Timed) -> float:
    """Return the probability that random poses find a collision in the time of the certificate."""
    return -math.expm1(each.certificate / each.pose * math.log1p(-share))


def _thin_table(thin: Mapping[float, Timed], verdicts: Mapping[float, str]) -> Table:
    return Table(
        "A thin blade: collisions found in the time of the certificate",
        (
            "share of the range",
            "verdict of the certificate",
            "certificate [ms]",
            "poses in that time",
            "chance that they find it [%]",
            f"time of poses for {CONFIDENCE:.0%} / certificate",
        ),
        [
            (
                share,
                verdicts[share],
                1e3 * each.certificate,
                int(each.certificate / each.pose),
                100.0 * _chance(share, each),
                poses_for(share) * each.pose / each.certificate,
            )
            for share, each in thin.items()
        ],
    )


def _fault_table(faulty: Mapping[str, Mapping[str, int]]) -> Table:
    return Table(
        "Faults inserted into assets, and how many are found",
        (
            "asset",
            "faults",
            "found by the certificate",
            *(f"of these by {count} poses" for count in _TRIED),
            "found by poses alone",
        ),
        [(name, *each.values()) for name, each in faulty.items()],
    )


def _findings(
    timed: Mapping[str, Timed],
    thin: Mapping[float, Timed],
    verdicts: Mapping[float, str],
    faulty: Mapping[str, Mapping[str, int]],
) -> list[str]:
    said = []
    for share in SHARES:
        ratios = {name: poses_for(share) * each.pose / each.certificate for name, each in timed.items()}
        quicker = [name for name, ratio in ratios.items() if ratio < 1.0]
        said.append(
            f"To exclude collisions on {share:g} of the ranges with {CONFIDENCE:.0%}, sampling takes "
            f"{span(list(ratios.values()))} times as long as the certificate, which excludes all of them"
            + (f"; sampling is faster for {', '.join(quicker)}." if quicker else ".")
        )
    thinnest = min(thin)
    refused = sum(each != "proven" for each in verdicts.values())
    chance = shown(100.0 * _chance(thinnest, thin[thinnest]))
    certificate, sampled, missed = (
        sum(each[what] for each in faulty.values()) for what in ("certificate", str(_TRIED[-1]), "missed")
    )
    said.append(
        f"Of {len(verdicts)} blades the certificate refuses {refused}; in its time, "
        f"random poses find the thinnest one, on {shown(thinnest)} of the range, with a chance of {chance} %."
    )
    said.append(
        f"Of {certificate} faults that the certificate finds, {_TRIED[-1]} random poses find {sampled}; "
        f"poses find {missed} that it does not."
    )
    return said
