"""Collisions in some states of all joints, which refute most files that have a collision within a second.

Pairs that collide in none of them are moved towards each other from the states in which they are nearest.
"""

import itertools
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
from artgen.proof.kinematics import JointTable, frames
from artgen.proof.paths import FULL_SLIDE, JointPath, space_of

_RANDOM = 64  # random states
_MOST_IN_STATE = 4  # most pairs of pieces of two links that are examined in a state
_MOST_STARTS = 3  # most states from which a pair is moved together
_MOST_STEPS = 16  # most steps of that motion
_MOST_SHARE = 0.25  # most of the range of a joint in a step
_DEEPER = 0.1  # overlap at which a step aims, in radii of the smaller piece
_FARTHEST = 10.0  # farthest position of a joint in that motion [rad or m]
_TINY = 1e-12
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
    if not joint_paths:
        return
    look = _Look(asset, joint_paths)
    for pair in itertools.chain(look.in_states(), look.on_approach()):
        if pair is not None:
            yield pair
        if time.monotonic() > end:
            return


class _Look:
    """A look for collisions of some pairs; it yields None where a pair does not collide."""

    def __init__(self, asset: Asset, joint_paths: Sequence[JointPath]) -> None:
        self.asset, self.joint_paths = asset, joint_paths
        self.names = list(dict.fromkeys(name for each in joint_paths for name in each.links))
        colliders = {name: asset.link(name).colliders for name in self.names}
        self.nodes = Hierarchy(
            [[each.convex.outer_points(FINE) for each in own] for own in colliders.values()]
        )
        self.labels = {name: [each.label for each in own] for name, own in colliders.items()}
        self.done = np.zeros(len(joint_paths), np.bool_)
        self.starts: list[list[_Start]] = [[] for _ in joint_paths]

    def in_states(self) -> Iterator[PairResult | None]:
        """Look in some states of all joints."""
        nodes = self.nodes
        owner, first, second = _pairs(nodes, self.names, self.labels, self.joint_paths)
        for state in _states(self.asset, self.names, nodes):
            for row in _near(nodes, owner, first, second, state, self.starts).tolist():
                number, a, b = int(owner[row]), int(first[row]), int(second[row])
                placed = state.between(int(nodes.tree[a]), int(nodes.tree[b]))
                if not self.done[number] and nodes.distance(a, b, *placed)[0] <= 0.0:
                    yield self._refuted(number, a, b, state.at(self.joint_paths[number]))
            yield None
            left = ~self.done[owner]
            owner, first, second = owner[left], first[left], second[left]

    def on_approach(self) -> Iterator[PairResult | None]:
        """Move the other pairs towards each other, the nearest ones first."""
        waiting = [(start, number) for number, starts in enumerate(self.starts) for start in starts]
        for start, number in sorted(waiting, key=lambda each: each[0].gap):
            joint_path = self.joint_paths[number]
            for at in _approach(self.nodes, joint_path, start) if not self.done[number] else ():
                yield self._refuted(number, start.first, start.second, at)
                if self.done[number]:
                    break
            yield None

    def _refuted(self, number: int, first: int, second: int, at: Array) -> PairResult | None:
        a, b = self.nodes.hull(first), self.nodes.hull(second)
        result = refuted(self.asset, self.joint_paths[number], at, a, b)
        self.done[number] = result is not None
        return result


@dataclass(frozen=True, eq=False)
class _State:
    """A state of all joints."""

    positions: Mapping[str, float]  # of the variables [rad or m]
    rotations: Array  # rotation of each link from rest, shape (links, 3, 3)
    offsets: Array  # shift of each link, shape (links, 3) [m]

    def at(self, joint_path: JointPath) -> Array:
        """Return the positions of the variables of a joint path, shape (v,) [rad or m]."""
        return np.array([self.positions[name] for name in joint_path.variables])

    def between(self, first: int, second: int) -> tuple[Array, Array]:
        """Return rotation and shift of a link in the frame of another link."""
        back = self.rotations[first].T
        return back @ self.rotations[second], back @ (self.offsets[second] - self.offsets[first])


@dataclass(frozen=True, eq=False)
class _Start:
    """A state in which two pieces of a pair are near each other."""

    gap: float  # distance of the balls around the pieces [m]
    first: int  # node of the first piece
    second: int  # node of the second piece
    state: _State


def _approach(nodes: Hierarchy, joint_path: JointPath, start: _Start) -> Iterator[Array]:
    """Move two pieces towards each other by their joints; yield positions where they touch, shape (v,)."""
    table, a, b, at = JointTable.of([joint_path]), start.first, start.second, start.state.at(joint_path)
    low, high = joint_path.boxes[0].T
    low, high = np.maximum(low, -_FARTHEST), np.minimum(high, _FARTHEST)
    deeper = _DEEPER * float(min(nodes.radius[a], nodes.radius[b]))
    points = nodes.points(np.array([b]))[0]
    for _ in range(_MOST_STEPS):
        path = table.motions(np.zeros(1, np.int64), at[None], at[None])
        pose = frames(path)
        rotation, offset = pose.rotations[-1][0], pose.offset[0]
        distance, direction = nodes.distance(a, b, rotation, offset)
        if distance <= 0.0:
            yield at
            distance, direction = 0.0, rotation @ nodes.center[b] + offset - nodes.center[a]
            direction /= max(float(np.linalg.norm(direction)), _TINY)
        moved = points @ rotation.T + offset
        slope = _slope(table, path, moved[np.argmin(moved @ direction)], direction, len(at))
        slope[((at <= low) & (slope > 0.0)) | ((at >= high) & (slope < 0.0))] = 0.0
        weighted = (high - low) * slope
        if not np.abs(weighted).max() > _TINY:
            return
        step = weighted * (high - low) * (-(distance + deeper) / float(weighted @ weighted))
        step *= min(1.0, _MOST_SHARE / float(np.abs(step / (high - low)).max()))
        at = np.clip(at + step, low, high)


def _slope(table: JointTable, path: Sequence[Motion], point: Array, direction: Array, count: int) -> Array:
    """Return the speed of a point of the second link along a direction, for each variable, shape (count,)."""
    result = np.zeros(count)
    rotation, offset = np.eye(3), np.zeros(3)
    for step, motion in enumerate(path):
        axis, variable = rotation @ motion.axis[0], int(table.variable[0, step])
        if motion.kind == "prismatic":
            speed = axis
        else:
            speed = np.cross(axis, point - (rotation @ motion.origin[0] + offset))
        if variable >= 0:
            result[variable] += table.ratio[0, step] * float(speed @ direction)
        one = frames([motion])
        rotation, offset = rotation @ one.rotations[-1][0], rotation @ one.offset[0] + offset
    return result


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


def _near(
    nodes: Hierarchy,
    owner: Indices,
    first: Indices,
    second: Indices,
    state: _State,
    starts: Sequence[list[_Start]],
) -> Indices:
    """Return rows of pairs of pieces that may overlap, deepest first, the deepest few of each joint path."""
    # the nearest pieces of each joint path are added to its starts, of which the best few are kept
    turned = np.matmul(state.rotations[nodes.tree], nodes.center[:, :, None])[:, :, 0]
    centers = turned + state.offsets[nodes.tree]
    between = centers[second] - centers[first]
    length = np.sqrt(np.sum(between * between, axis=1))
    apart = length - nodes.radius[first] - nodes.radius[second]
    by_gap = np.lexsort((apart, owner))
    nearest = by_gap[np.unique(owner[by_gap], return_index=True)[1]]
    for row in nearest.tolist():
        known = starts[int(owner[row])]
        known.append(_Start(float(apart[row]), int(first[row]), int(second[row]), state))
        known.sort(key=lambda each: each.gap)
        del known[_MOST_STARTS:]
    rows = np.flatnonzero(apart < 0.0)
    if not len(rows):
        return rows
    normals = between[rows] / np.maximum(length[rows], _TINY)[:, None]
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
