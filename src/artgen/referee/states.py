"""Collisions in some states of all joints, which refute most files that have a collision within a second."""

import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from artgen._arrays import Array, Indices
from artgen.asset import Asset
from artgen.asset.certificate import PairResult
from artgen.asset.joint import joints_above
from artgen.proof.bounds import Motion
from artgen.proof.certify import refuted
from artgen.proof.cover import FINE
from artgen.proof.hierarchy import Hierarchy
from artgen.proof.kinematics import frames
from artgen.proof.paths import FULL_SLIDE, JointPath, space_of

_RANDOM = 64  # random states
_MOST_IN_STATE = 4  # most pairs of pieces of two links that are examined in a state
_AT_ONCE = 1 << 20  # most vertices of pieces that are compared at once
_EXTENTS = 2.0  # an unlimited slide is moved by at most so many extents of the asset


def collisions(asset: Asset, joint_paths: Sequence[JointPath], end: float) -> Iterator[PairResult]:
    """Yield the pairs of links that collide in one of some states, each once.

    The states are rest, each joint alone at the ends of its range, and random ones of all joints.

    Args:
        asset: An asset of links with convex colliders.
        joint_paths: Joint paths of the pairs to examine.
        end: Value of `time.monotonic` after which no further pair is examined [s].
    """
    names = list(dict.fromkeys(name for joint_path in joint_paths for name in joint_path.links))
    if not names:
        return
    colliders = {name: asset.link(name).colliders for name in names}
    nodes = Hierarchy([[each.convex.outer_points(FINE) for each in colliders[name]] for name in names])
    labels = {name: [each.label for each in own] for name, own in colliders.items()}
    owner, first, second = _pairs(nodes, names, labels, joint_paths)
    done = np.zeros(len(joint_paths), np.bool_)
    for state in _states(asset, names, nodes):
        near = _near(nodes, owner, first, second, state)
        for row in near.tolist():
            if time.monotonic() > end:
                return
            number, a, b = int(owner[row]), int(first[row]), int(second[row])
            if done[number]:
                continue
            rotation, offset = state.between(int(nodes.tree[a]), int(nodes.tree[b]))
            if nodes.distance(a, b, rotation, offset)[0] > 0.0:
                continue
            joint_path = joint_paths[number]
            at = np.array([state.positions[name] for name in joint_path.variables])
            result = refuted(asset, joint_path, at, nodes.hull(a), nodes.hull(b))
            if result is not None:
                done[number] = True
                yield result
        left = ~done[owner]
        owner, first, second = owner[left], first[left], second[left]


@dataclass(frozen=True, eq=False)
class _State:
    """A state of all joints."""

    positions: Mapping[str, float]  # of the variables [rad or m]
    rotations: Array  # rotation of each link from rest, shape (links, 3, 3)
    offsets: Array  # shift of each link, shape (links, 3) [m]

    def between(self, first: int, second: int) -> tuple[Array, Array]:
        """Return rotation and shift of a link in the frame of another link."""
        back = self.rotations[first].T
        return back @ self.rotations[second], back @ (self.offsets[second] - self.offsets[first])


def _pairs(
    nodes: Hierarchy,
    names: Sequence[str],
    labels: Mapping[str, Sequence[str]],
    joint_paths: Sequence[JointPath],
) -> tuple[Indices, Indices, Indices]:
    """Return the number of the joint path and both nodes of each pair of pieces that may not touch."""
    leaves = [np.flatnonzero(nodes.leaf & (nodes.tree == tree)) for tree in range(len(names))]
    parts = [np.zeros((3, 0), np.int64)]
    for number, joint_path in enumerate(joint_paths):
        a, b = joint_path.links
        first, second = leaves[names.index(a)], leaves[names.index(b)]
        one, two = np.repeat(first, len(second)), np.tile(second, len(first))
        if joint_path.allowed[0]:
            allowed = {
                each.labels if each.links == joint_path.links else each.labels[::-1]
                for each in joint_path.allowed[0]
            }
            pieces = zip(nodes.first_piece[one].tolist(), nodes.first_piece[two].tolist(), strict=True)
            free = [(labels[a][piece], labels[b][other]) not in allowed for piece, other in pieces]
            one, two = one[free], two[free]
        parts.append(np.stack((np.full(len(one), number), one, two)))
    owner, first, second = np.concatenate(parts, axis=1)
    return owner, first, second


def _states(asset: Asset, names: Sequence[str], nodes: Hierarchy) -> Iterator[_State]:
    """Yield the states, with the poses of named links."""
    space = space_of(asset)
    variables = list(space.ranges)
    extent = _EXTENTS * float(np.linalg.norm(np.ptp(nodes.center, axis=0) + 2.0 * nodes.half.max(axis=0)))
    ends = np.array([(-extent, extent) if each == FULL_SLIDE else each for each in space.ranges.values()])
    low, high = ends.reshape(-1, 2).T
    rest = np.clip(0.0, low, high)
    alone = [np.where(np.eye(len(rest), dtype=np.bool_), each, rest) for each in (low, high)]
    random = np.random.default_rng(0).random((_RANDOM, len(rest)))
    at = np.concatenate((rest[None], *alone, low + random * (high - low)))
    columns = dict(zip(variables, at.T, strict=True))
    rotations, offsets = [], []
    for name in names:
        path = []
        for joint in joints_above(asset.joints, name)[::-1]:
            follower = space.followers[joint.name]
            leader = columns[follower.leader] if follower.leader else np.zeros(len(at))
            center = follower.ratio * leader + follower.offset
            origin, axis = (np.broadcast_to(each, (len(at), 3)) for each in (joint.pivot, joint.axis))
            path.append(Motion(joint.kind, origin, axis, center, np.zeros(len(at))))
        pose = frames(path) if path else None
        rotations.append(pose.rotations[-1] if pose else np.broadcast_to(np.eye(3), (len(at), 3, 3)))
        offsets.append(pose.offset if pose else np.zeros((len(at), 3)))
    for number, positions in enumerate(at.tolist()):
        yield _State(
            dict(zip(variables, positions, strict=True)),
            np.array([each[number] for each in rotations]),
            np.array([each[number] for each in offsets]),
        )


def _near(nodes: Hierarchy, owner: Indices, first: Indices, second: Indices, state: _State) -> Indices:
    """Return rows of pairs of pieces that may overlap, deepest first, the deepest few of each joint path."""
    turned = np.matmul(state.rotations[nodes.tree], nodes.center[:, :, None])[:, :, 0]
    centers = turned + state.offsets[nodes.tree]
    between = centers[second] - centers[first]
    length = np.sqrt(np.sum(between * between, axis=1))
    rows = np.flatnonzero(length < nodes.radius[first] + nodes.radius[second])
    if not len(rows):
        return rows
    normals = between[rows] / np.maximum(length[rows], 1e-12)[:, None]
    gaps = np.empty(len(rows))
    size = int(nodes.count[first[rows]].max() + nodes.count[second[rows]].max())
    step = max(_AT_ONCE // size, 1)
    for start in range(0, len(rows), step):
        part = slice(start, start + step)
        a, b, normal = first[rows[part]], second[rows[part]], normals[part]
        heights = [
            np.matmul(
                nodes.points(side) - nodes.center[side][:, None],
                np.matmul(state.rotations[nodes.tree[side]].swapaxes(1, 2), normal[:, :, None]),
            )[:, :, 0]
            for side in (a, b)
        ]
        gaps[part] = length[rows[part]] + heights[1].min(axis=1) - heights[0].max(axis=1)
    open_ = np.flatnonzero(gaps < 0.0)
    open_ = open_[np.argsort(gaps[open_], kind="stable")]
    # the rank of each among those of its joint path
    by_path = np.argsort(owner[rows[open_]], kind="stable")
    paths = owner[rows[open_]][by_path]
    rank = np.empty(len(paths), np.int64)
    rank[by_path] = np.arange(len(paths)) - np.searchsorted(paths, paths)
    result: Indices = rows[open_[rank < _MOST_IN_STATE]]
    return result
