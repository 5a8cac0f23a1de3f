"""From what a search found about a pair of links to what the certificate says of it."""

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.asset.certificate import OpenCell, PairResult, Verdict, Witness
from artgen.proof.cover import Cover
from artgen.proof.hierarchy import Hierarchy
from artgen.proof.items import Items, Outcome
from artgen.proof.overlap import (
    Links,
    Overlap,
    allowed_at,
    displacement,
    first_contact,
    penetration,
)
from artgen.proof.paths import Way

_MOST_CELLS = 5  # open cells that are listed for a pair
_DECIMALS = 9  # of lengths in a certificate
_POSE_DECIMALS = 8  # of positions: cells reach over the ends of ranges by less


@dataclass(frozen=True, eq=False)
class Judged:
    """What a search found about one pair of links on one kind of pieces.

    Attributes:
        way: The pair.
        outcome: What was found.
        nodes: The pieces of all links of the search.
        covers: The pieces of each link.
        number: Number of the way in the search.
        leaves: All items that the search closed.
    """

    way: Way
    outcome: Outcome
    nodes: Hierarchy
    covers: Mapping[str, Cover]
    number: int
    leaves: list[Items]

    @property
    def contained(self) -> bool:
        """Whether the pieces contain the solids of both links."""
        return all(self.covers[name].excess is not None for name in self.way.links)

    @property
    def proven(self) -> bool:
        """Whether the pieces stay apart."""
        return self.outcome.proven

    @property
    def settled(self) -> bool:
        """Whether this says all about the solids: they are proven apart, or overlap."""
        return (self.proven and self.contained) or self.outcome.hit is not None

    def labels(self, first: int, second: int) -> tuple[str, str]:
        """Return the labels of two leaves, or of the first pieces in two boxes."""
        a, b = (
            self.covers[link].labels[order[int(self.nodes.first[node])]]
            for link, node in zip(self.way.links, (first, second), strict=True)
            for order in [self.nodes.orders[list(self.covers).index(link)]]
        )
        return a, b


def pair_result(asset: Asset, solids: Links, on_colliders: Judged, on_solids: Judged) -> PairResult:
    """Say what is proven of a pair.

    Args:
        asset: The asset.
        solids: Its exact solids.
        on_colliders: What was found on the colliders.
        on_solids: What was found on the pieces that judge the solids; the same if those are the colliders.
    """
    way, outcome = on_colliders.way, on_solids.outcome
    verdict = _of_solids(on_solids)
    colliders = _of_colliders(on_colliders.outcome)
    hit = on_solids if outcome.hit is not None else on_colliders
    seen = _witness(asset, solids, hit) if verdict != "proven" or colliders != "proven" else None
    opened = on_solids if outcome.open else on_colliders
    guaranteed, found, found_at = None, None, {}
    if verdict == "proven":
        excess = sum(on_solids.covers[name].excess or 0.0 for name in way.links)
        if math.isfinite(outcome.guaranteed):
            guaranteed = math.floor((outcome.guaranteed - excess) * 10**_DECIMALS) / 10**_DECIMALS
        if math.isfinite(outcome.found):
            found, found_at = _rounded(outcome.found), _named(way, outcome.found_at)
    return PairResult(
        way.links,
        way.variables,
        verdict,
        colliders,
        guaranteed,
        found,
        found_at,
        seen,
        () if seen is not None else _open_cells(opened),
        0.0 if seen is not None else _open_fraction(opened),
    )


def _of_solids(judged: Judged) -> Verdict:
    if judged.outcome.hit is not None:
        return "collision"
    return "proven" if judged.proven and judged.contained else "not proven"


def _of_colliders(outcome: Outcome) -> Verdict:
    if outcome.hit is not None or outcome.collider_hit is not None:
        return "collision"
    return "proven" if outcome.proven else "not proven"


def _witness(asset: Asset, solids: Links, judged: Judged) -> Witness | None:
    """Describe the overlap that a search found, if it found one."""
    way, found = judged.way, judged.outcome.hit or judged.outcome.collider_hit
    if found is None:
        return None
    first, second, positions = found
    a = judged.nodes.hull(first)
    b = judged.nodes.hull(second).transform(displacement(way, positions)[:3])
    overlap = solids.overlap(way, positions, allowed_at(way, positions))
    if judged.outcome.hit is None or overlap is None:
        common = a ^ b
        place = np.array(common.bounding_box()).reshape(2, 3).mean(axis=0)
        overlap = Overlap(common.volume(), place, judged.labels(first, second))
    start = np.array([asset.joint(name).closed for name in way.variables])

    def touch(at: Array) -> bool:
        if judged.outcome.hit is not None:
            return solids.overlap(way, at, allowed_at(way, at)) is not None
        moved = judged.nodes.hull(second).transform(displacement(way, at)[:3])
        return bool((a ^ moved).volume() > 0.0)

    share = first_contact(touch, start, positions)
    pose = _named(way, positions)
    free = {joint.name for joint in asset.free_joints}
    placed = asset.pose({name: value for name, value in pose.items() if name in free})[way.links[0]]
    x, y, z = (placed[:3, :3] @ overlap.place + placed[:3, 3]).tolist()
    return Witness(
        pose,
        _named(way, start + share * (positions - start)),
        _rounded(penetration(a, b)),
        float(f"{overlap.volume:.6g}"),
        (_rounded(x), _rounded(y), _rounded(z)),
        overlap.labels,
    )


def _open_cells(judged: Judged) -> tuple[OpenCell, ...]:
    cells = []
    boxes = np.array(judged.way.boxes)  # cells reach over the ends of ranges by a breath
    least, most = boxes[:, :, 0].min(axis=0), boxes[:, :, 1].max(axis=0)
    for lowest, highest, first, second, distance in judged.outcome.open[:_MOST_CELLS]:
        low, high = (np.clip(end, least, most) for end in (lowest, highest))
        ends = zip(low.tolist(), high.tolist(), strict=True)
        region = {
            name: (lower, upper) for name, (lower, upper) in zip(judged.way.variables, ends, strict=True)
        }
        known = 0.0 if math.isnan(distance) else max(distance, 0.0)
        cells.append(OpenCell(region, judged.labels(first, second), _rounded(known)))
    return tuple(cells)


def _open_fraction(judged: Judged) -> float:
    """Return the share of the joint space of a pair that the open cells take; at most 1."""
    total = sum(_extent(box[:, 0], box[:, 1], box) for box in judged.way.boxes)
    widest = max(judged.way.boxes, key=lambda box: _extent(box[:, 0], box[:, 1], box))
    opened = sum(_extent(low, high, widest) for low, high, *_ in judged.outcome.open)
    return float(f"{min(opened / total, 1.0):.3g}") if total > 0.0 else float(bool(opened))


def _extent(low: Array, high: Array, box: Array) -> float:
    """Return the volume of a cell in those dimensions in which a box has one."""
    wide = box[:, 1] > box[:, 0]
    return float(np.prod((high - low)[wide]))


def _named(way: Way, positions: Array) -> dict[str, float]:
    """Return rounded positions by variable, none beyond the end of its range."""
    boxes = np.array(way.boxes)
    values = (
        np.clip(np.round(positions, _POSE_DECIMALS), boxes.min(axis=0)[:, 0], boxes.max(axis=0)[:, 1]) + 0.0
    )
    return dict(zip(way.variables, values.tolist(), strict=True))


def _rounded(number: float) -> float:
    return round(number, _DECIMALS) + 0.0
