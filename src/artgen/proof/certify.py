"""The certificate: proof on convex pieces that all pairs of links stay apart."""

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.asset.certificate import (
    MOST_TOLERANCE,
    PROOF_FORMAT,
    Certificate,
    OpenCell,
    PairResult,
    Verdict,
    Witness,
)
from artgen.asset.joint import is_number
from artgen.errors import AssetError
from artgen.proof.cover import Cover, collider_cover, fine_cover
from artgen.proof.hierarchy import Hierarchy
from artgen.proof.items import Items, SearchOutcome, Settings
from artgen.proof.overlap import (
    Links,
    Overlap,
    allowed_at,
    allows,
    displacement,
    first_contact,
    penetration,
)
from artgen.proof.paths import JointPath, Space
from artgen.proof.search import Search

_MOST_CELLS = 5  # most open cells in the result of a pair
_DECIMALS = 9  # decimals of lengths in a certificate
_POSE_DECIMALS = 8  # decimals of positions; cells extend beyond the ends of ranges by less


@dataclass(frozen=True, eq=False)
class Judged:
    """Search result for one pair of links on one kind of pieces."""

    joint_path: JointPath  # joint path of the pair
    outcome: SearchOutcome  # result of the search
    nodes: Hierarchy  # the pieces of all links of the search
    covers: Mapping[str, Cover]  # the pieces of each link
    number: int  # number of the joint path in the search
    leaves: list[Items]  # all items that the search closed

    @property
    def contained(self) -> bool:
        """Whether the pieces contain the solids of both links."""
        return all(self.covers[name].excess is not None for name in self.joint_path.links)

    @property
    def proven(self) -> bool:
        """Whether the pieces stay apart."""
        return self.outcome.proven

    @property
    def settled(self) -> bool:
        """Whether the result decides about the solids: they are proven apart, or they overlap."""
        return (self.proven and self.contained) or self.outcome.hit is not None

    def labels(self, first: int, second: int) -> tuple[str, str]:
        """Return the labels of two pieces; of boxes, the labels of their first pieces."""
        a, b = (
            self.covers[link].labels[order[int(self.nodes.first[node])]]
            for link, node in zip(self.joint_path.links, (first, second), strict=True)
            for order in [self.nodes.orders[list(self.covers).index(link)]]
        )
        return a, b


def pair_result(asset: Asset, solids: Links, on_colliders: Judged, on_solids: Judged) -> PairResult:
    """Return the result of the proof for a pair.

    Args:
        asset: The asset.
        solids: The exact solids.
        on_colliders: Result on the colliders.
        on_solids: Result on the pieces that represent the solids; the same object if those are the colliders.
    """
    joint_path, outcome = on_colliders.joint_path, on_solids.outcome
    verdict = _of_solids(on_solids)
    colliders = _of_colliders(on_colliders.outcome)
    hit = on_solids if outcome.hit is not None else on_colliders
    seen = _witness(asset, solids, hit) if verdict != "proven" or colliders != "proven" else None
    opened = on_solids if outcome.open else on_colliders
    guaranteed, found, found_at = None, None, {}
    if verdict == "proven":
        excess = sum(on_solids.covers[name].excess or 0.0 for name in joint_path.links)
        if math.isfinite(outcome.guaranteed):
            guaranteed = math.floor((outcome.guaranteed - excess) * 10**_DECIMALS) / 10**_DECIMALS
        if math.isfinite(outcome.found):
            found, found_at = _rounded(outcome.found), _named(joint_path, outcome.found_at)
    return PairResult(
        joint_path.links,
        joint_path.variables,
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


def _of_colliders(outcome: SearchOutcome) -> Verdict:
    if outcome.hit is not None or outcome.collider_hit is not None:
        return "collision"
    return "proven" if outcome.proven else "not proven"


def _witness(asset: Asset, solids: Links, judged: Judged) -> Witness | None:
    """Describe the overlap that a search found; None if it found no overlap."""
    joint_path, found = judged.joint_path, judged.outcome.hit or judged.outcome.collider_hit
    if found is None:
        return None
    first, second, positions = found
    a = judged.nodes.hull(first)
    b = judged.nodes.hull(second).transform(displacement(joint_path, positions)[:3])
    overlap = solids.overlap(joint_path, positions, allowed_at(joint_path, positions))
    if judged.outcome.hit is None or overlap is None:
        common = a ^ b
        place = np.array(common.bounding_box()).reshape(2, 3).mean(axis=0)
        overlap = Overlap(common.volume(), place, judged.labels(first, second))
    start = np.array([asset.joint(name).closed for name in joint_path.variables])

    def touch(at: Array) -> bool:
        if judged.outcome.hit is not None:
            return solids.overlap(joint_path, at, allowed_at(joint_path, at)) is not None
        moved = judged.nodes.hull(second).transform(displacement(joint_path, at)[:3])
        return bool((a ^ moved).volume() > 0.0)

    share = first_contact(touch, start, positions)
    pose = _named(joint_path, positions)
    free = {joint.name for joint in asset.free_joints}
    placed = asset.pose({name: value for name, value in pose.items() if name in free})[joint_path.links[0]]
    x, y, z = (placed[:3, :3] @ overlap.place + placed[:3, 3]).tolist()
    return Witness(
        pose,
        _named(joint_path, start + share * (positions - start)),
        _rounded(penetration(a, b)),
        float(f"{overlap.volume:.6g}"),
        (_rounded(x), _rounded(y), _rounded(z)),
        overlap.labels,
    )


def _open_cells(judged: Judged) -> tuple[OpenCell, ...]:
    cells = []
    boxes = np.array(judged.joint_path.boxes)  # cells extend slightly beyond the ends of ranges
    least, most = boxes[:, :, 0].min(axis=0), boxes[:, :, 1].max(axis=0)
    for lowest, highest, first, second, distance in judged.outcome.open[:_MOST_CELLS]:
        low, high = (np.clip(end, least, most) for end in (lowest, highest))
        ends = zip(low.tolist(), high.tolist(), strict=True)
        region = {
            name: (lower, upper)
            for name, (lower, upper) in zip(judged.joint_path.variables, ends, strict=True)
        }
        known = 0.0 if math.isnan(distance) else max(distance, 0.0)
        cells.append(OpenCell(region, judged.labels(first, second), _rounded(known)))
    return tuple(cells)


def _open_fraction(judged: Judged) -> float:
    """Return the share of open cells in the joint space of a pair, at most 1."""
    total = sum(_extent(box[:, 0], box[:, 1], box) for box in judged.joint_path.boxes)
    widest = max(judged.joint_path.boxes, key=lambda box: _extent(box[:, 0], box[:, 1], box))
    opened = sum(_extent(low, high, widest) for low, high, *_ in judged.outcome.open)
    return float(f"{min(opened / total, 1.0):.3g}") if total > 0.0 else float(bool(opened))


def _extent(low: Array, high: Array, box: Array) -> float:
    """Return the volume of a cell in the dimensions in which a box has an extent."""
    wide = box[:, 1] > box[:, 0]
    return float(np.prod((high - low)[wide]))


def _named(joint_path: JointPath, positions: Array) -> dict[str, float]:
    """Return rounded positions by variable, clipped to the ranges."""
    boxes = np.array(joint_path.boxes)
    values = (
        np.clip(np.round(positions, _POSE_DECIMALS), boxes.min(axis=0)[:, 0], boxes.max(axis=0)[:, 1]) + 0.0
    )
    return dict(zip(joint_path.variables, values.tolist(), strict=True))


def _rounded(number: float) -> float:
    return round(number, _DECIMALS) + 0.0


def leaves_data(proven: Sequence[Judged]) -> dict[str, Any]:
    """Return the cells of the proof as JSON data.

    `links` has for each kind of pieces and each link the order in which cells number its pieces, and the
    pieces themselves unless they are colliders. Each cell of a pair is one row: the ranges of pieces of the
    first and of the second link (first, last + 1), the frame (-2 for heights and distances about the common
    axis), the normal, and the lowest and highest position of each joint.
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
            ordered.append(_by_path(judged.leaves))
        rows = _rows(judged, ordered[known[key]].get(judged.number))
        pairs.append({"links": list(judged.joint_path.links), "pieces": known[key], "leaves": rows})
    return {"format": PROOF_FORMAT, "pieces": sets, "pairs": pairs}


def _by_path(leaves: Sequence[Items]) -> dict[int, Items]:
    """Return the closed items of each joint path, in the order in which the search closed them."""
    if not leaves:
        return {}
    joined = Items.join(leaves)
    joined = joined[np.argsort(joined.joint_path, kind="stable")]
    joint_paths, first = np.unique(joined.joint_path, return_index=True)
    ends = [*first[1:].tolist(), len(joined)]
    return {
        int(joint_path): joined[np.arange(start, end)]
        for joint_path, start, end in zip(joint_paths, first.tolist(), ends, strict=True)
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
    nodes, count = judged.nodes, len(judged.joint_path.variables)
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
    only: Callable[[JointPath], bool] | None = None,
) -> Certificate:
    """Prove for all pairs of links that they stay apart at every joint position.

    The proof holds for the solids as they are written to files, and for the colliders. Where the colliders
    are too coarse for a proof, the solids are proven on finer pieces, and the failure is reported for the
    colliders only.

    Args:
        asset: The asset.
        tolerance: Clearance to prove [m].
        measure: Whether to bracket each pair's smallest clearance, within a fifth and up to 10 mm.
        only: Selects the pairs to examine; all by default.

    Raises:
        AssetError: The asset has no links, a joint has no usable range, or a joint can never move.
    """
    if not is_number(tolerance) or not 0.0 <= tolerance <= MOST_TOLERANCE:
        raise AssetError(
            f"tolerance must be a length of 0 to {MOST_TOLERANCE:g} m (metres, not mm), got {tolerance!r}"
        )
    if not asset.links:
        raise AssetError(f"asset {asset.name!r} has no links; there is nothing to certify")
    _check_ranges(asset)
    space = Space(asset)
    if only is None:  # dependencies may block a joint in part of its range
        space.check()
    joint_paths = [joint_path for joint_path in space.joint_paths() if only is None or only(joint_path)]
    if not joint_paths:
        return Certificate(float(tolerance), (), asset.contacts, leaves_data([]))
    proof = _Proof(asset, float(tolerance), Settings(measure=measure))
    on_colliders = proof.on(collider_cover, joint_paths)
    doubtful = [judged.joint_path for judged in on_colliders if not judged.settled]
    finer: Iterable[Judged] = ()
    if doubtful and all(link.pieces for link in asset.links):
        finer = proof.on(fine_cover, doubtful)
    on_solids = {judged.joint_path.links: judged for judged in on_colliders} | {
        judged.joint_path.links: judged for judged in finer
    }
    pairs = [
        pair_result(asset, proof.solids, judged, on_solids[judged.joint_path.links])
        for judged in on_colliders
    ]
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
    """The shared state of the searches for one asset."""

    def __init__(self, asset: Asset, tolerance: float, settings: Settings) -> None:
        self.tolerance = tolerance
        self.settings = settings
        self.links = {link.name: link for link in asset.links}
        self.solids = Links(asset.links)

    def on(self, cover: Callable[..., Cover], joint_paths: Sequence[JointPath]) -> list[Judged]:
        """Search several joint paths on one kind of pieces."""
        names = list(dict.fromkeys(name for joint_path in joint_paths for name in joint_path.links))
        covers = {name: cover(self.links[name]) for name in names}
        nodes = Hierarchy([covers[name].points for name in names])
        number = {name: index for index, name in enumerate(names)}

        def confirm(index: int, first: int, second: int, positions: Array, depth: float) -> str:
            joint_path = joint_paths[index]
            a, b = nodes.hull(first), nodes.hull(second).transform(displacement(joint_path, positions)[:3])
            if (a ^ b).volume() <= 0.0 or penetration(a, b) <= depth + self.settings.pressed:
                return ""
            overlap = self.solids.overlap(joint_path, positions, allowed_at(joint_path, positions))
            return "pieces" if overlap is None else "solids"

        least = np.array(
            [sum(covers[name].excess or 0.0 for name in joint_path.links) for joint_path in joint_paths]
        )
        search = Search(
            nodes,
            joint_paths,
            [(number[joint_path.links[0]], number[joint_path.links[1]]) for joint_path in joint_paths],
            confirm,
            tolerances=least + self.tolerance,
            least=least,
            depths=_depths(joint_paths, covers, nodes),
            settings=self.settings,
        )
        outcomes = search.run()
        return [
            Judged(joint_path, outcome, nodes, covers, index, search.leaves)
            for index, (joint_path, outcome) in enumerate(zip(joint_paths, outcomes, strict=True))
        ]


def _depths(
    joint_paths: Sequence[JointPath], covers: Mapping[str, Cover], nodes: Hierarchy
) -> Callable[[int, int, int, int], float] | None:
    """Return a function that gives the allowed penetration of two pieces in a box of a joint path."""
    if not any(any(joint_path.allowed) for joint_path in joint_paths):
        return None

    def depth(number: int, box: int, first: int, second: int) -> float:
        joint_path = joint_paths[number]
        a, b = (
            covers[link].labels[nodes.piece[node]]
            for link, node in zip(joint_path.links, (first, second), strict=True)
        )
        found = [each.depth for each in joint_path.allowed[box] if allows(each, joint_path.links, (a, b))]
        return max(found, default=math.nan)

    return depth
