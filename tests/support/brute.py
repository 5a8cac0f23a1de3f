"""The oracle: exact booleans of the solids at many poses, sharing no code with the proof.

The solids of a link are united and cut into blocks at their own corners, so that boxes tell most of them
apart; what boxes cannot tell apart is intersected.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations, product

import numpy as np
from manifold3d import Manifold, Mesh64, OpType
from numpy.typing import NDArray

from artgen.asset import AllowedContact, Asset, Link
from artgen.asset import AssetCondition as Condition
from artgen.asset import AssetJoint as Joint

Array = NDArray[np.float64]
Pose = Mapping[str, float]
Overlap = tuple[int, str, str, float]

NOTHING = 1e-12
"""Volume that counts as none [m^3]: a cube of 0.1 mm."""

_FEW = 12  # triangles of a box: nothing is gained by cutting it
_FULL = 0.5  # share of its box that a block of few triangles fills
_CUTS = 10  # halvings
_BATCH = 2000  # poses
_THRESHOLD = 1e-6  # how near to a limit or threshold the nearest poses are [rad or m]


def draw_poses(asset: Asset, count: int, seed: int = 0) -> list[dict[str, float]]:
    """Draw positions of the free joints that no dependency forbids.

    Three in five are uniform; of the rest each joint stands on or near a limit, its closed position, or the
    threshold of a dependency or contact. Where a dependency forbids a pose, either the dependent joint is
    closed or the joints that it needs are moved into their region.
    """
    draw = np.random.default_rng(seed)
    special = _special_positions(asset)
    poses: list[dict[str, float]] = []
    while len(poses) < count:
        clustered = draw.random() < 0.4
        q = {}
        for joint in asset.free_joints:
            low, high = _range(joint)
            q[joint.name] = float(draw.uniform(low, high))
            if clustered and draw.random() < 0.8:
                near = float(draw.choice(special[joint.name]))
                spread = float(draw.choice([0.0, _THRESHOLD, 0.003, 0.03])) * (high - low)
                q[joint.name] = float(np.clip(near + spread * draw.normal(), low, high))
        if _allow(asset, q, draw):
            poses.append(q)
    return poses


def overlaps(
    asset: Asset,
    poses: Sequence[Pose],
    *,
    least: float = NOTHING,
    most: int | None = None,
    once: bool = False,
    pairs: Sequence[tuple[str, str]] | None = None,
) -> list[Overlap]:
    """Return which links overlap at which poses: index of the pose, both links, volume [m^3].

    What an allowed contact covers, and is no thicker than its depth, does not count.

    Args:
        asset: Made of solids, not read from files.
        poses: Positions of the free joints.
        least: Smallest volume that counts [m^3].
        most: How many overlaps to find before stopping; all by default.
        once: Whether one overlap of each pair is enough.
        pairs: Which pairs of links to look at; all that move against each other by default.
    """
    found: list[Overlap] = []
    left = list(moving_pairs(asset) if pairs is None else pairs)
    step = _BATCH if most is None and not once else _BATCH // 10
    for start in range(0, len(poses), step):
        batch = poses[start : start + step]
        motion = _motions(asset, batch)
        for a, b in list(left):
            relative = _inverse(motion[a]) @ motion[b]
            for index, volume in _pair_overlaps(asset, a, b, relative, batch, least):
                found.append((start + index, a, b, volume))
                if most is not None and len(found) >= most:
                    return found
                if once:
                    left.remove((a, b))
                    break
    return sorted(found)


def moving_pairs(asset: Asset) -> list[tuple[str, str]]:
    """Return the pairs of links that are not rigidly joined."""
    group = {asset.links[0].name: 0}
    for number, (parent, child, joints) in enumerate(asset.pairs(), 1):
        group[child] = group[parent] if all(joint.locked for joint in joints) else number
    names = [link.name for link in asset.links]
    return [(a, b) for a, b in combinations(names, 2) if group[a] != group[b]]


# poses


def _range(joint: Joint) -> tuple[float, float]:
    return (-np.pi, np.pi) if joint.limits is None else joint.limits


def _terms(condition: Condition) -> Iterator[Condition]:
    if condition.terms:
        for term in condition.terms:
            yield from _terms(term)
    else:
        yield condition


def _leader(asset: Asset, name: str) -> tuple[str, float, float]:
    """Return the free joint that a joint follows, and ratio and offset to it."""
    ratio, offset = 1.0, 0.0
    joint = asset.joint(name)
    while joint.follows is not None:
        offset += ratio * joint.follows.offset
        ratio *= joint.follows.ratio
        joint = asset.joint(joint.follows.leader)
    return joint.name, ratio, offset


def _special_positions(asset: Asset) -> dict[str, list[float]]:
    special = {joint.name: [*_range(joint), joint.closed] for joint in asset.free_joints}

    def add(name: str, position: float) -> None:
        leader, ratio, offset = _leader(asset, name)
        if leader in special:
            low, high = _range(asset.joint(leader))
            at = (position - offset) / ratio
            special[leader] += [float(np.clip(at + side * _THRESHOLD, low, high)) for side in (-1, 1)]

    conditions = [contact.when for contact in asset.contacts if contact.when is not None]
    for joint in asset.joints:
        if joint.needs is not None:
            conditions.append(joint.needs.condition)
            for position in (joint.needs.until, joint.needs.beyond):
                if position is not None:
                    add(joint.name, position)
    for condition in conditions:
        for term in _terms(condition):
            add(term.joint, term.value)
    return special


def _allow(asset: Asset, q: dict[str, float], draw: np.random.Generator) -> bool:
    """Change a pose until no dependency forbids it; tell whether that worked."""
    for attempt in range(8):
        blocked = asset.blocked(q)
        if not blocked:
            return True
        joint = asset.joint(blocked[0])
        assert joint.needs is not None
        if attempt < 4 and draw.random() < 0.5:
            _meet(asset, joint.needs.condition, q, draw)
        else:
            leader, ratio, offset = _leader(asset, joint.name)
            if leader in q:
                low, high = _range(asset.joint(leader))
                q[leader] = float(np.clip(-offset / ratio, low, high))
    return not asset.blocked(q)


def _meet(asset: Asset, condition: Condition, q: dict[str, float], draw: np.random.Generator) -> None:
    """Move joints into the region of a condition, as far as their limits let them."""
    if condition.terms:
        terms = condition.terms if condition.kind == "all" else [draw.choice(np.array(condition.terms))]
        for term in terms:
            _meet(asset, term, q, draw)
        return
    leader, ratio, offset = _leader(asset, condition.joint)
    if leader not in q or condition.holds(asset.positions(q)):
        return
    low, high = _range(asset.joint(leader))
    at = float(np.clip((condition.value - offset) / ratio, low, high))
    upwards = (condition.kind == "above") == (ratio > 0.0)
    end = high if upwards else low
    share = 0.0 if draw.random() < 0.2 else draw.random()
    step = np.copysign(min(1e-9, abs(end - at)), end - at)
    q[leader] = float(at + step + share * (end - at - step))


def _motions(asset: Asset, poses: Sequence[Pose]) -> dict[str, Array]:
    """Return how each link is displaced from rest at each pose, shape (n, 4, 4)."""
    position: dict[str, Array] = {}
    for joint in asset.joints:
        leader, ratio, offset = _leader(asset, joint.name)
        closed = asset.joint(leader).closed
        of_leader = np.array([q.get(leader, closed) for q in poses], float)
        position[joint.name] = ratio * _bent(asset, joint, of_leader) + offset
    result = {asset.links[0].name: np.broadcast_to(np.eye(4), (len(poses), 4, 4))}
    for parent, child, joints in asset.pairs():
        motion = result[parent]
        for joint in joints:
            motion = motion @ _displacement(joint, position[joint.name])
        result[child] = motion
    return result


def _bent(asset: Asset, joint: Joint, leader: Array) -> Array:
    """Return what takes the place of the positions of a leader: those of a closed chain, or these."""
    while joint.follows is not None and joint.follows.curve is None:
        joint = asset.joint(joint.follows.leader)
    if joint.follows is None:
        return leader
    (low, high), terms = joint.follows.curve.range, joint.follows.curve.terms
    angle = np.arccos(np.clip((2.0 * leader - low - high) / (high - low), -1.0, 1.0))
    return sum(term * np.cos(number * angle) for number, term in enumerate(terms))


def _displacement(joint: Joint, position: Array) -> Array:
    """Return what a joint does to its child at each position, shape (n, 4, 4)."""
    result = np.tile(np.eye(4), (len(position), 1, 1))
    axis = joint.axis
    if joint.kind == "prismatic":
        result[:, :3, 3] = position[:, None] * axis
        return result
    cosine, sine = np.cos(position)[:, None, None], np.sin(position)[:, None, None]
    outer = np.outer(axis, axis)
    skew = np.cross(np.eye(3), axis)  # its product with v is the cross product of axis and v, transposed
    turn = outer + cosine * (np.eye(3) - outer) + sine * skew
    result[:, :3, :3] = turn
    result[:, :3, 3] = joint.pivot - turn @ joint.pivot
    return result


def _inverse(motion: Array) -> Array:
    turn = np.swapaxes(motion[:, :3, :3], 1, 2)
    result = np.tile(np.eye(4), (len(motion), 1, 1))
    result[:, :3, :3] = turn
    result[:, :3, 3] = -np.einsum("nij,nj->ni", turn, motion[:, :3, 3])
    return result


# solids


@dataclass(frozen=True, eq=False)
class _Blocks:
    """A solid cut into blocks, with their boxes.

    Attributes:
        label: Label of the pieces that it unites; empty for all.
        solids: The blocks.
    """

    label: str
    solids: list[Manifold]

    @cached_property
    def boxes(self) -> tuple[Array, Array]:
        """Middles and half lengths of the blocks' boxes, shape (k, 3) each."""
        corners = np.array([_bounds(solid) for solid in self.solids])
        return (corners[:, 0] + corners[:, 1]) / 2, (corners[:, 1] - corners[:, 0]) / 2


def _blocks(link: Link, *, by_label: bool) -> list[_Blocks]:
    known: dict[bool, list[_Blocks]] = vars(link).setdefault("_blocks_of_the_oracle", {})
    if by_label not in known:
        pieces = [piece for piece in link.pieces if not piece.visual]
        labels = list(dict.fromkeys(piece.label for piece in pieces)) if by_label else [""]
        known[by_label] = []
        for label in labels:
            solids = [_bare(piece.shape.manifold) for piece in pieces if label in ("", piece.label)]
            whole = Manifold.batch_boolean(solids, OpType.Add)
            known[by_label].append(_Blocks(label, list(_cut(whole, _CUTS))))
    return known[by_label]


def _bare(manifold: Manifold) -> Manifold:
    """Return a solid without normals and textures, which booleans would carry along."""
    mesh = manifold.to_mesh64()
    return Manifold(
        Mesh64(
            np.ascontiguousarray(np.asarray(mesh.vert_properties)[:, :3]),
            *(
                np.array(indices, np.uint64, order="C")
                for indices in (mesh.tri_verts, mesh.merge_from_vert, mesh.merge_to_vert)
            ),
        )
    )


def _bounds(solid: Manifold) -> Array:
    return np.array(solid.bounding_box(), float).reshape(2, 3)


def _box_volume(solid: Manifold) -> float:
    low, high = _bounds(solid)
    return float(np.prod(high - low))


def _cut(solid: Manifold, depth: int) -> Iterator[Manifold]:
    """Cut a solid in two where the boxes of the halves are smallest, and so on."""
    triangles = solid.num_tri()
    if depth == 0 or triangles <= _FEW or (triangles < 60 and solid.volume() > _FULL * _box_volume(solid)):
        yield solid
        return
    vertices = np.asarray(solid.to_mesh64().vert_properties)[:, :3]
    best, halves = 0.97 * _box_volume(solid), None
    for axis in range(3):
        levels = np.unique(vertices[:, axis].round(7))[1:-1]
        if len(levels) > 9:
            levels = levels[np.linspace(0, len(levels) - 1, 9).astype(int)]
        for level in levels.tolist():
            pair = solid.split_by_plane(np.eye(3)[axis].tolist(), level)
            if any(half.is_empty() for half in pair):
                continue
            boxes = sum(_box_volume(half) for half in pair)
            most = max(half.num_tri() for half in pair)
            if boxes + (0.0 if triangles < 200 else most / triangles * best) < best:
                best, halves = boxes, pair
    if halves is None:
        yield solid
        return
    for half in halves:
        yield from _cut(half, depth - 1)


def _pair_overlaps(
    asset: Asset, a: str, b: str, relative: Array, poses: Sequence[Pose], least: float
) -> Iterator[tuple[int, float]]:
    """Yield the poses at which two links overlap, with the volume; `relative` takes b into a's frame."""
    contacts = [contact for contact in asset.contacts if set(contact.links) == {a, b}]
    first, second = (_blocks(asset.link(name), by_label=bool(contacts)) for name in (a, b))
    near: dict[int, list[tuple[_Blocks, _Blocks, Array]]] = {}
    for one, other in product(first, second):
        for index, numbers in _near(one, other, relative):
            near.setdefault(index, []).append((one, other, numbers))
    for index in sorted(near):
        volume = 0.0
        for one, other, numbers in near[index]:
            labels = {a: one.label, b: other.label}
            allowed = (
                c.depth
                for c in contacts
                if dict(zip(c.links, c.labels, strict=True)) == labels and _holds(asset, c, poses[index])
            )
            volume += _common(one, other, numbers, relative[index], max(allowed, default=0.0), least)
        if volume > least:
            yield index, volume


def _holds(asset: Asset, contact: AllowedContact, q: Pose) -> bool:
    return contact.when is None or contact.when.holds(asset.positions(q))


def _near(one: _Blocks, other: _Blocks, relative: Array) -> Iterator[tuple[int, Array]]:
    """Yield the poses at which boxes of blocks overlap, with their numbers, shape (m, 2)."""
    (middle, half), (far, far_half) = one.boxes, other.boxes
    turn, shift = relative[:, :3, :3], relative[:, :3, 3]
    moved = np.einsum("nij,kj->nki", turn, far) + shift[:, None]
    reach = np.einsum("nij,kj->nki", np.abs(turn), far_half)
    back = np.swapaxes(turn, 1, 2)
    reach_back = np.einsum("nij,kj->nki", np.abs(back), half)
    whole = np.array([(middle - half).min(axis=0), (middle + half).max(axis=0)])
    may = ((moved - reach < whole[1]) & (moved + reach > whole[0])).all(axis=2)
    for index in np.flatnonzero(may.any(axis=1)).tolist():
        offset = moved[index][None] - middle[:, None]  # from each block of one to each of the other
        close = (np.abs(offset) < half[:, None] + reach[index][None]).all(axis=2)
        if close.any():
            offset_back = offset @ turn[index]
            close &= (np.abs(offset_back) < far_half[None] + reach_back[index][:, None]).all(axis=2)
        if close.any():
            yield index, np.argwhere(close)


def _common(
    one: _Blocks, other: _Blocks, blocks: Array, relative: Array, depth: float, least: float
) -> float:
    """Return the volume of what blocks have in common, less what is thin enough to be allowed [m^3]."""
    total = 0.0
    matrix = np.ascontiguousarray(relative[:3])
    moved = {j: other.solids[j].transform(matrix) for j in set(blocks[:, 1].tolist())}
    for i, j in blocks.tolist():
        common = one.solids[i] ^ moved[j]
        if common.is_empty():
            continue
        parts = common.decompose() if depth > 0.0 else [common]
        total += sum(part.volume() for part in parts if part.volume() > least / 10 and not _thin(part, depth))
    return total


def _thin(solid: Manifold, depth: float) -> bool:
    """Tell whether a solid lies between two parallel planes that are `depth` apart."""
    if depth == 0.0:
        return False
    mesh = solid.hull().to_mesh64()
    points, faces = np.asarray(mesh.vert_properties)[:, :3], np.asarray(mesh.tri_verts).astype(int)
    corners = points[faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    length = np.linalg.norm(normals, axis=1)
    heights = points @ (normals[length > 0.0] / length[length > 0.0, None]).T
    return bool(np.ptp(heights, axis=0).min() <= depth + 1e-9)
