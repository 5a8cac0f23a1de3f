"""The certificate: proof on convex pieces that all pairs of links stay apart."""

import math
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np
from manifold3d import Manifold

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
from artgen.asset.manifolds import box_of
from artgen.asset.record import rounded
from artgen.errors import AssetError
from artgen.proof.cover import Cover, collider_cover, fine_cover, slot_hosts
from artgen.proof.hierarchy import Hierarchy
from artgen.proof.kinematics import ProofCells
from artgen.proof.overlap import (
    PRESSED,
    Overlap,
    allows,
    displacement,
    first_contact,
    link_overlap,
    penetration,
)
from artgen.proof.paths import JointPath, space_of
from artgen.proof.search import Search
from artgen.proof.separation import SearchOutcome

_MOST_CELLS = 5  # most open cells in the result of a pair
_DECIMALS = 9  # decimals of lengths in a certificate
_POSE_DECIMALS = 8  # decimals of positions; cells extend beyond the ends of ranges by less
_SMALLEST_RANGE = 1e-6  # [rad or m]


def certify(
    asset: Asset,
    tolerance: float = 0.0,
    *,
    measure: bool = False,
    only: Callable[[JointPath], bool] | None = None,
    seconds: float = math.inf,
    overlap: float = 0.0,
    known: "Known | None" = None,
) -> Certificate:
    """Prove for all pairs of links that they stay apart at every joint position.

    The proof holds for the solids as they are written to files, and for the colliders. Where the colliders
    are too coarse for a proof, the solids are proven on finer pieces, and the failure is reported for the
    colliders only.

    The arguments are those of `Asset.certify`, and:

    Args:
        asset: The asset.
        tolerance: Required clearance [m].
        measure: Whether to bracket the clearance.
        only: Selects the pairs to examine.
        seconds: Time after which the pairs that are left are not proven [s].
        overlap: Overlap that is permitted everywhere, up to 0.01 mm; the tolerance of the certificate is less
            by it, so that `recheck` has to be told of it [m].
        known: Searches for pairs whose joint space is the same are taken from it; new ones are added.

    Raises:
        AssetError: The asset has no links, a joint has no usable range, or a joint can never move.
    """
    if not is_number(tolerance) or not 0.0 <= tolerance <= MOST_TOLERANCE:
        raise AssetError(
            f"tolerance must be a length of 0 to {MOST_TOLERANCE:g} m (metres, not mm), got {tolerance!r}"
        )
    if not 0.0 <= overlap <= PRESSED:
        raise AssetError(f"overlap must be a length of 0 to {PRESSED:g} m, got {overlap!r}")
    tolerance = float(tolerance) - overlap
    if not (is_number(seconds) or seconds == math.inf) or seconds < 0.0:
        raise AssetError(f"seconds must be a time limit that is not negative, got {seconds!r}")
    if not asset.links:
        raise AssetError(f"asset {asset.name!r} has no links; there is nothing to certify")
    _check_ranges(asset)
    hosts, faults = slot_hosts(asset)
    if faults:
        link, reason = faults[0]
        raise AssetError(f"link {link!r} of a padded asset: {reason}; pad the asset again", link=link)
    space = space_of(asset)
    if only is None:  # dependencies may block a joint in part of its range
        space.check()
    joint_paths = space.joint_paths(only)
    begin, limit = time.monotonic(), seconds
    finer_follows = all(link.pieces for link in asset.links if not link.absent)
    first = seconds / 2.0 if finer_follows else seconds  # a hard pair leaves time for the pairs that follow
    searched = partial(_searched, asset, tolerance=tolerance, measure=measure, known=known)
    on_colliders = searched(collider_cover, joint_paths, seconds=first)
    doubtful = [each.joint_path for each in on_colliders if not each.settled]
    on_solids = {each.joint_path.links: each for each in on_colliders}
    if finer_follows:
        seconds = max(seconds + begin - time.monotonic(), 0.0)
        finer = searched(fine_cover, doubtful, seconds=seconds)
        on_solids |= {each.joint_path.links: each for each in finer}
    pairs = [_pair_result(asset, each, on_solids[each.joint_path.links], limit) for each in on_colliders]
    proven = [on_solids[pair.links] for pair in pairs if pair.verdict == "proven"]
    stored = {id(each) for each in proven}
    proven += [each for each in on_colliders if each.outcome.proven and id(each) not in stored]
    return Certificate(tolerance, tuple(pairs), asset.contacts, _proof_data(proven), hosts)


def doubtful_colliders(
    asset: Asset, tolerance: float, only: Callable[[JointPath], bool]
) -> list[list[tuple[str, int]]]:
    """Return groups of colliders that are not proven apart, each as the name of its link and its number.

    The arguments are those of `certify`.
    """
    result = []
    for each in _searched(asset, collider_cover, space_of(asset).joint_paths(only), tolerance):
        hits = [hit[:2] for hit in (each.outcome.hit, each.outcome.collider_hit) if hit is not None]
        for pair in dict.fromkeys(hits or [cell[2:4] for cell in each.outcome.open]):
            named = zip(each.joint_path.links, pair, strict=True)
            result.append([(link, number) for link, node in named for number in each.nodes.pieces(node)])
    return result


def are_apart(asset: Asset, only: Callable[[JointPath], bool], known: "Known | None" = None) -> bool:
    """Tell whether the colliders of the selected pairs of links are proven apart."""
    searches = _searched(asset, collider_cover, space_of(asset).joint_paths(only), brief=True, known=known)
    return all(each.outcome.proven for each in searches)


def doubtful_pairs(asset: Asset, only: Callable[[JointPath], bool], known: "Known") -> set[tuple[str, str]]:
    """Return the selected pairs of links whose solids or colliders `certify` does not prove apart.

    The arguments are those of `certify`.
    """
    on_colliders = _searched(asset, collider_cover, space_of(asset).joint_paths(only), known=known)
    failed = {each.joint_path.links for each in on_colliders if not each.outcome.proven}
    doubtful = [each.joint_path for each in on_colliders if each.outcome.proven and not each.contained]
    finer = _searched(asset, fine_cover, doubtful, known=known)
    return failed | {each.joint_path.links for each in finer if not (each.outcome.proven and each.contained)}


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


@dataclass(frozen=True, eq=False)
class _PairSearch:
    """Search result for one pair of links on one kind of pieces."""

    joint_path: JointPath  # joint path of the pair
    outcome: SearchOutcome  # result of the search
    nodes: Hierarchy  # the pieces of all links of the search
    covers: Mapping[str, Cover]  # the pieces of each link
    closed: ProofCells  # the cells of the pair that are proven

    @property
    def contained(self) -> bool:
        """Whether the pieces contain the solids of both links."""
        return all(self.covers[name].excess is not None for name in self.joint_path.links)

    @property
    def settled(self) -> bool:
        """Whether the result decides about the solids: they are proven apart, or they overlap."""
        return (self.outcome.proven and self.contained) or self.outcome.hit is not None

    def is_of(self, joint_path: JointPath, covers: Mapping[str, Cover]) -> bool:
        """Tell whether a search of a joint path on the pieces of its links would find the same."""
        same = all(self.covers[name] is covers[name] for name in joint_path.links)
        return same and self.joint_path.key == joint_path.key

    def among(self, nodes: Hierarchy, covers: Mapping[str, Cover]) -> "_PairSearch":
        """Return the search with the numbers that its nodes have among those of other links."""
        first, second = (
            int(nodes.roots[[*covers].index(name)] - self.nodes.roots[[*self.covers].index(name)])
            for name in self.joint_path.links
        )
        cells = replace(self.closed, first=self.closed.first + first, second=self.closed.second + second)
        return replace(self, nodes=nodes, covers=covers, closed=cells)

    def labels(self, first: int, second: int) -> tuple[str, str]:
        """Return the labels of two pieces; of boxes, the labels of their first pieces."""
        return _labels(self.joint_path, self.covers, self.nodes, first, second)


def _labels(
    joint_path: JointPath, covers: Mapping[str, Cover], nodes: Hierarchy, first: int, second: int
) -> tuple[str, str]:
    a, b = (covers[link].labels for link in joint_path.links)
    return a[nodes.first_piece[first]], b[nodes.first_piece[second]]


class Known:
    """Searches of pairs of links, and trees of their pieces, shared by several proofs of one design."""

    def __init__(self) -> None:
        # by the names of the links, the kind of pieces and the requirements
        self.searches: dict[tuple[Any, ...], _PairSearch] = {}
        self._nodes: dict[tuple[Cover, ...], Hierarchy] = {}

    def hierarchy(self, covers: Sequence[Cover]) -> Hierarchy:
        """Return the trees of the pieces of several links."""
        key = tuple(covers)
        if key not in self._nodes:
            self._nodes[key] = Hierarchy([each.points for each in covers])
        return self._nodes[key]


def _searched(
    asset: Asset,
    cover: Callable[..., Cover],
    joint_paths: Sequence[JointPath],
    tolerance: float = 0.0,
    *,
    measure: bool = False,
    seconds: float = math.inf,
    brief: bool = False,
    known: Known | None = None,
) -> list[_PairSearch]:
    """Search several joint paths on one kind of pieces; `brief` ends at the first pair that is in doubt."""
    if not joint_paths:
        return []
    names = list(dict.fromkeys(name for joint_path in joint_paths for name in joint_path.links))
    covers = {name: cover(asset.link(name)) for name in names}
    known = Known() if known is None else known
    nodes, requirements = known.hierarchy([*covers.values()]), (cover, tolerance, measure)
    result = {
        joint_path.links: same.among(nodes, covers)
        for joint_path in joint_paths
        if (same := known.searches.get((joint_path.links, *requirements))) is not None
        and same.outcome.proven
        and same.is_of(joint_path, covers)
    }
    order = [each.links for each in joint_paths]
    joint_paths = [each for each in joint_paths if each.links not in result]

    def confirm(number: int, first: int, second: int, positions: Array, depth: float) -> str:
        joint_path = joint_paths[number]
        a, b = nodes.hull(first), nodes.hull(second).transform(displacement(joint_path, positions)[:3])
        if (a ^ b).volume() <= 0.0 or penetration(a, b) <= depth + PRESSED:
            return ""
        overlap = link_overlap(asset, joint_path, positions)
        return "pieces" if overlap is None else "solids"

    def allowed_depth(number: int, box: int, first: int, second: int) -> float:
        joint_path = joint_paths[number]
        if not joint_path.allowed[box]:
            return math.nan
        labels = _labels(joint_path, covers, nodes, first, second)
        found = [each.depth for each in joint_path.allowed[box] if allows(each, joint_path.links, labels)]
        return max(found, default=math.nan)

    pairs = [joint_path.links for joint_path in joint_paths]
    least = np.array([sum(covers[name].excess or 0.0 for name in links) for links in pairs])
    trees = [(names.index(a), names.index(b)) for a, b in pairs]
    tolerances = least + tolerance
    if joint_paths:
        search = Search(
            nodes, joint_paths, trees, confirm, allowed_depth, tolerances, least, measure, seconds, brief
        )
        for joint_path, outcome, cells in zip(joint_paths, search.outcomes, search.run(), strict=True):
            result[joint_path.links] = _PairSearch(joint_path, outcome, nodes, covers, cells)
    if not brief:
        known.searches |= {(links, *requirements): found for links, found in result.items()}
    return [result[links] for links in order]


def _pair_result(asset: Asset, on_colliders: _PairSearch, on_solids: _PairSearch, limit: float) -> PairResult:
    """Return the result of the proof for a pair; both searches are one if colliders represent the solids."""
    joint_path, outcome = on_colliders.joint_path, on_solids.outcome
    hit = on_colliders.outcome.hit or on_colliders.outcome.collider_hit
    verdict = _verdict(outcome.proven and on_solids.contained, outcome.hit)
    colliders = _verdict(on_colliders.outcome.proven, hit)
    witness = None
    if verdict != "proven" or colliders != "proven":
        witness = _witness(asset, on_solids if outcome.hit is not None else on_colliders)
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
        witness,
        () if witness is not None else _open_cells(opened),
        0.0 if witness is not None else _open_fraction(opened),
        (float(f"{opened.outcome.used:.2g}") or limit) if witness is None and opened.outcome.late else None,
    )


def _verdict(proven: bool, hit: object) -> Verdict:  # noqa: FBT001 - a private helper
    return "collision" if hit is not None else "proven" if proven else "not proven"


def refuted(
    asset: Asset, joint_path: JointPath, positions: Array, first: Manifold, second: Manifold
) -> PairResult | None:
    """Return the result for two links whose solids overlap at a pose; None if they do not.

    Args:
        asset: The asset.
        joint_path: The joint path between the links.
        positions: Positions of its variables, shape (v,) [rad or m].
        first: A convex piece of the first link, around the solid that may overlap.
        second: One of the second link, at rest.
    """
    moved = second.transform(displacement(joint_path, positions)[:3])
    if penetration(first, moved) <= PRESSED:
        return None
    overlap = link_overlap(asset, joint_path, positions)
    if overlap is None:
        return None

    def touch(at: Array) -> bool:
        return link_overlap(asset, joint_path, at) is not None

    witness = _described(asset, joint_path, positions, penetration(first, moved), overlap, touch)
    return PairResult(joint_path.links, joint_path.variables, "collision", "collision", witness=witness)


def _witness(asset: Asset, search: _PairSearch) -> Witness | None:
    """Describe the overlap that a search found; None if it found no overlap."""
    joint_path, hit = search.joint_path, search.outcome.hit
    found = hit or search.outcome.collider_hit
    if found is None:
        return None
    first, second, positions = found
    a, at_rest = search.nodes.hull(first), search.nodes.hull(second)

    def moved(at: Array) -> Any:
        return at_rest.transform(displacement(joint_path, at)[:3])

    def touch(at: Array) -> bool:
        if hit is not None:
            return link_overlap(asset, joint_path, at) is not None
        return bool((a ^ moved(at)).volume() > 0.0)

    b = moved(positions)
    overlap = link_overlap(asset, joint_path, positions)
    if hit is None or overlap is None:
        common = a ^ b
        overlap = Overlap(common.volume(), box_of(common).mean(axis=0), search.labels(first, second))
    return _described(asset, joint_path, positions, penetration(a, b), overlap, touch)


def _described(
    asset: Asset,
    joint_path: JointPath,
    positions: Array,
    depth: float,
    overlap: Overlap,
    touch: Callable[[Array], bool],
) -> Witness:
    """Return the witness of an overlap, with the first contact on the line from rest."""
    start = np.array([asset.joint(name).closed for name in joint_path.variables])
    share = first_contact(touch, start, positions)
    pose = _named(joint_path, positions)
    free = {joint.name for joint in asset.free_joints}
    placed = asset.pose({name: value for name, value in pose.items() if name in free})[joint_path.links[0]]
    x, y, z = (placed[:3, :3] @ overlap.place + placed[:3, 3]).tolist()
    return Witness(
        pose,
        _named(joint_path, start + share * (positions - start)),
        _rounded(depth),
        float(f"{overlap.volume:.6g}"),
        (_rounded(x), _rounded(y), _rounded(z)),
        overlap.labels,
    )


def _open_cells(search: _PairSearch) -> tuple[OpenCell, ...]:
    cells = []
    boxes = np.array(search.joint_path.boxes)  # cells extend slightly beyond the ends of ranges
    least, most = boxes[:, :, 0].min(axis=0), boxes[:, :, 1].max(axis=0)
    for low, high, first, second, distance in search.outcome.open[:_MOST_CELLS]:
        ends = zip(*(np.clip(end, least, most).tolist() for end in (low, high)), strict=True)
        region = dict(zip(search.joint_path.variables, ends, strict=True))
        known = 0.0 if math.isnan(distance) else max(distance, 0.0)
        cells.append(OpenCell(region, search.labels(first, second), _rounded(known)))
    return tuple(cells)


def _open_fraction(search: _PairSearch) -> float:
    """Return the share of open cells in the joint space of a pair, at most 1."""
    sizes = [_extent(box[:, 0], box[:, 1], box) for box in search.joint_path.boxes]
    widest = search.joint_path.boxes[int(np.argmax(sizes))]
    opened = sum(_extent(low, high, widest) for low, high, *_ in search.outcome.open)
    return float(f"{min(opened / sum(sizes), 1.0):.3g}") if sum(sizes) > 0.0 else float(bool(opened))


def _extent(low: Array, high: Array, box: Array) -> float:
    """Return the volume of a cell in the dimensions in which a box has an extent."""
    return float(np.prod((high - low)[box[:, 1] > box[:, 0]]))


def _named(joint_path: JointPath, positions: Array) -> dict[str, float]:
    """Return rounded positions by variable, clipped to the ranges."""
    boxes = np.array(joint_path.boxes)
    least, most = boxes[:, :, 0].min(axis=0), boxes[:, :, 1].max(axis=0)
    values = np.clip(np.round(positions, _POSE_DECIMALS), least, most) + 0.0
    return dict(zip(joint_path.variables, values.tolist(), strict=True))


def _rounded(number: float) -> float:
    return round(number, _DECIMALS) + 0.0


def _proof_data(proven: Sequence[_PairSearch]) -> dict[str, Any]:
    """Return the cells of the proof as JSON data.

    `pieces` has for each kind of pieces and each link the order in which cells number its pieces, and the
    pieces themselves unless they are colliders. Each cell of a pair is one row: the ranges of pieces of the
    first and of the second link (first, last + 1), the frame (-2 for heights and distances about the common
    axis), the normal, and the lowest and highest position of each joint.
    """
    kinds = {id(search.nodes): search for search in proven}
    pairs = [
        {
            "links": list(search.joint_path.links),
            "pieces": list(kinds).index(id(search.nodes)),
            "leaves": _rows(search),
        }
        for search in proven
    ]
    return {"format": PROOF_FORMAT, "pieces": [_pieces(search) for search in kinds.values()], "pairs": pairs}


def _pieces(search: _PairSearch) -> dict[str, Any]:
    return {
        name: {
            "order": list(order),
            "excess": rounded(cover.excess),
            "points": None if cover.colliders else [each.tolist() for each in cover.points],
            "labels": None if cover.colliders else list(cover.labels),
        }
        for (name, cover), order in zip(search.covers.items(), search.nodes.orders, strict=True)
    }


def _rows(search: _PairSearch) -> list[list[float]]:
    nodes, cells, count = search.nodes, search.closed, len(search.joint_path.variables)
    ranges = [ends[each] for each in (cells.first, cells.second) for ends in (nodes.first, nodes.last)]
    whole = np.column_stack((*ranges, cells.frame)).tolist()
    bounds = np.stack((cells.low[:, :count], cells.high[:, :count]), axis=2).reshape(len(cells), 2 * count)
    real = (np.column_stack((cells.normal, bounds)) + 0.0).tolist()  # no zero with a sign
    return [[*integers, *numbers] for integers, numbers in zip(whole, real, strict=True)]
