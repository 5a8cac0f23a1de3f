"""The certificate: all pairs of links that move against each other, proven apart on convex pieces."""

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.asset.certificate import MOST_TOLERANCE, PROOF_FORMAT, Certificate
from artgen.asset.joint import is_number
from artgen.errors import AssetError
from artgen.proof.cover import Cover, collider_cover, fine_cover
from artgen.proof.hierarchy import Hierarchy
from artgen.proof.items import Items, Settings
from artgen.proof.overlap import Links, allowed_at, allows, displacement, penetration
from artgen.proof.paths import Space, Way
from artgen.proof.results import Judged, pair_result
from artgen.proof.search import Search


def leaves_data(proven: Sequence[Judged]) -> dict[str, Any]:
    """Return what was proven as JSON data.

    `links` has for each kind of pieces and each link the order in which leaves count its pieces, and, where
    they are no colliders, the pieces themselves. Each leaf of a pair is one row: the range of pieces of the
    first link and that of the second (first, last + 1), the frame (-2 for heights and distances about the
    common axis), the normal and the lowest and highest position of each joint.
    """
    sets: list[dict[str, Any]] = []
    pairs: list[dict[str, Any]] = []
    known: dict[int, int] = {}
    ordered: list[dict[int, Items]] = []
    for judged in proven:
        key = id(judged.nodes)
        if key not in known:
            known[key] = len(sets)
            sets.append(_pieces(judged))
            ordered.append(_by_way(judged.leaves))
        rows = _rows(judged, ordered[known[key]].get(judged.number))
        pairs.append({"links": list(judged.way.links), "pieces": known[key], "leaves": rows})
    return {"format": PROOF_FORMAT, "pieces": sets, "pairs": pairs}


def _by_way(leaves: Sequence[Items]) -> dict[int, Items]:
    """Return the leaves of each way of a search, in the order in which it closed them."""
    if not leaves:
        return {}
    joined = Items.join(leaves)
    joined = joined[np.argsort(joined.way, kind="stable")]
    ways, first = np.unique(joined.way, return_index=True)
    ends = [*first[1:].tolist(), len(joined)]
    return {
        int(way): joined[np.arange(start, end)]
        for way, start, end in zip(ways, first.tolist(), ends, strict=True)
    }


def _pieces(judged: Judged) -> dict[str, Any]:
    result = {}
    for number, (name, cover) in enumerate(judged.covers.items()):
        points = None if cover.colliders else [each.tolist() for each in cover.points]
        result[name] = {
            "order": list(judged.nodes.orders[number]),
            "excess": cover.excess,
            "points": points,
            "labels": None if cover.colliders else list(cover.labels),
        }
    return result


def _rows(judged: Judged, items: Items | None) -> list[list[float]]:
    if items is None:
        return []
    nodes, count = judged.nodes, len(judged.way.variables)
    whole = np.column_stack(
        (
            nodes.first[items.first],
            nodes.last[items.first],
            nodes.first[items.second],
            nodes.last[items.second],
            items.frame,
        )
    ).tolist()
    cells = np.stack((items.low[:, :count], items.high[:, :count]), axis=2).reshape(len(items), -1)
    real = np.column_stack((items.normal, cells)).tolist()
    return [[*integers, *numbers] for integers, numbers in zip(whole, real, strict=True)]


_SMALLEST_RANGE = 1e-6  # [rad or m]


def certify(
    asset: Asset,
    tolerance: float = 0.0,
    *,
    measure: bool = False,
    only: Callable[[Way], bool] | None = None,
) -> Certificate:
    """Prove for all pairs of links that they stay apart at every position of the joints.

    Proven is that the solids, as they are written to files, and the colliders stay apart. Where the colliders
    do not suffice, the solids are proven on finer pieces, and what fails is said of the colliders only.

    Args:
        asset: The asset.
        tolerance: Clearance to prove [m].
        measure: Whether to bracket each pair's smallest clearance, within a fifth and up to 10 mm.
        only: Chooses the pairs to look at; all by default.

    Raises:
        AssetError: The asset has no links, or a joint has no range to speak of or can never move.
    """
    if not is_number(tolerance) or not 0.0 <= tolerance <= MOST_TOLERANCE:
        raise AssetError(
            f"tolerance must be a length of 0 to {MOST_TOLERANCE:g} m (metres, not mm), got {tolerance!r}"
        )
    if not asset.links:
        raise AssetError(f"asset {asset.name!r} has no links; there is nothing to certify")
    _check_ranges(asset)
    space = Space(asset)
    if only is None:  # in a part of its range a joint may have no leave to move
        space.check()
    ways = [way for way in space.ways() if only is None or only(way)]
    if not ways:
        return Certificate(float(tolerance), (), asset.contacts, leaves_data([]))
    proof = _Proof(asset, float(tolerance), Settings(measure=measure))
    on_colliders = proof.on(collider_cover, ways)
    doubtful = [judged.way for judged in on_colliders if not judged.settled]
    finer: Iterable[Judged] = ()
    if doubtful and all(link.pieces for link in asset.links):
        finer = proof.on(fine_cover, doubtful)
    on_solids = {judged.way.links: judged for judged in on_colliders} | {
        judged.way.links: judged for judged in finer
    }
    pairs = [pair_result(asset, proof.solids, judged, on_solids[judged.way.links]) for judged in on_colliders]
    proven = [on_solids[pair.links] for pair in pairs if pair.verdict == "proven"]
    also = [judged for judged in on_colliders if judged.proven and judged not in proven]
    return Certificate(float(tolerance), tuple(pairs), asset.contacts, leaves_data([*proven, *also]))


def _check_ranges(asset: Asset) -> None:
    for joint in asset.joints:
        if joint.limits is None or joint.locked:
            continue
        low, high = joint.limits
        if not high - low > _SMALLEST_RANGE:
            raise AssetError(
                f"joint {joint.name!r} has a range of {high - low:.3g} ({low:.9g} to {high:.9g}); give it a "
                f"range above {_SMALLEST_RANGE:g}, or equal limits to lock it",
                joint=joint.name,
            )


class _Proof:
    """What the searches for one asset share."""

    def __init__(self, asset: Asset, tolerance: float, settings: Settings) -> None:
        self.tolerance = tolerance
        self.settings = settings
        self.links = {link.name: link for link in asset.links}
        self.solids = Links(asset.links)

    def on(self, cover: Callable[..., Cover], ways: Sequence[Way]) -> list[Judged]:
        """Search some ways on one kind of pieces."""
        names = list(dict.fromkeys(name for way in ways for name in way.links))
        covers = {name: cover(self.links[name]) for name in names}
        nodes = Hierarchy([covers[name].points for name in names])
        number = {name: index for index, name in enumerate(names)}

        def confirm(index: int, first: int, second: int, positions: Array, depth: float) -> str:
            way = ways[index]
            a, b = nodes.hull(first), nodes.hull(second).transform(displacement(way, positions)[:3])
            if (a ^ b).volume() <= 0.0 or penetration(a, b) <= depth + self.settings.pressed:
                return ""
            overlap = self.solids.overlap(way, positions, allowed_at(way, positions))
            return "pieces" if overlap is None else "solids"

        least = np.array([sum(covers[name].excess or 0.0 for name in way.links) for way in ways])
        search = Search(
            nodes,
            ways,
            [(number[way.links[0]], number[way.links[1]]) for way in ways],
            confirm,
            tolerances=least + self.tolerance,
            least=least,
            depths=_depths(ways, covers, nodes),
            settings=self.settings,
        )
        outcomes = search.run()
        return [
            Judged(way, outcome, nodes, covers, index, search.leaves)
            for index, (way, outcome) in enumerate(zip(ways, outcomes, strict=True))
        ]


def _depths(
    ways: Sequence[Way], covers: Mapping[str, Cover], nodes: Hierarchy
) -> Callable[[int, int, int, int], float] | None:
    """Return the function that tells how deep two leaves may press into each other in a box of a way."""
    if not any(any(way.allowed) for way in ways):
        return None

    def depth(number: int, box: int, first: int, second: int) -> float:
        way = ways[number]
        a, b = (
            covers[link].labels[nodes.piece[node]]
            for link, node in zip(way.links, (first, second), strict=True)
        )
        found = [each.depth for each in way.allowed[box] if allows(each, way.links, (a, b))]
        return max(found, default=math.nan)

    return depth
