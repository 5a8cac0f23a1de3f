"""Steps of a search: separating planes, pieces on one axis, and witnesses of collisions."""

import itertools
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from artgen._arrays import Array, Indices
from artgen.proof.bounds import Motion, around_axis, axis_gap, gap
from artgen.proof.hierarchy import Hierarchy
from artgen.proof.items import NONE, Items, SearchOutcome
from artgen.proof.kinematics import JointTable, is_coaxial
from artgen.proof.paths import JointPath

Confirm = Callable[[int, int, int, Array, float], str]
"""Function that says what overlaps: `solids`, `pieces` or an empty text.

Its arguments are the number of the joint path, a piece of each link, the positions of the variables and an
allowed depth [m].
"""

Depths = Callable[[int, int, int, int], float]
"""Function for the allowed penetration of two pieces, by joint path, box and pieces; NaN if none [m]."""

_FEW = 4  # most candidates for a witness of a pair and level
_MOST_CORNERS = 256  # most corners of cells that are examined for a pair


class Witnesses:
    """Search for witnesses.

    Args:
        joint_paths: Joint paths of the pairs of links.
        outcomes: Outcome of each joint path; witnesses are stored there.
        confirm: Examines a pose in which pieces seem to overlap.
        depths: Allowed penetration of two pieces; None if no contact is allowed.
    """

    def __init__(
        self,
        joint_paths: Sequence[JointPath],
        outcomes: Sequence[SearchOutcome],
        confirm: Confirm,
        depths: Depths | None,
    ) -> None:
        self.joint_paths = joint_paths
        self.outcomes = outcomes
        self.confirm = confirm
        self.depths = depths
        self.done = np.zeros(len(joint_paths), bool)
        self._corners = np.zeros(len(joint_paths), np.int64)

    def in_middles(self, items: Items, rows: Indices) -> None:
        """Examine the centers of the cells of several items, a few for each joint path."""
        looked: dict[int, int] = {}
        for row in rows.tolist():
            joint_path = int(items.joint_path[row])
            if self.done[joint_path] or looked.get(joint_path, 0) >= _FEW:
                continue
            looked[joint_path] = looked.get(joint_path, 0) + 1
            count = len(self.joint_paths[joint_path].variables)
            self._look(items, row, ((items.low[row] + items.high[row]) / 2.0)[:count])
        for joint_path in looked:
            self._finish(joint_path)

    def in_corners(self, items: Items, rows: Indices) -> None:
        """Examine the corners of small cells, where depths are nearly linear in the positions.

        Pieces that touch slightly at the center of such a cell overlap most in one of its corners.
        """
        for row in rows.tolist():
            joint_path = int(items.joint_path[row])
            box = self.joint_paths[joint_path].boxes[items.box[row]]
            low, high = (np.clip(end[row, : len(box)], *box.T) for end in (items.low, items.high))
            ends = [(a, b) if a < b else (a,) for a, b in zip(low.tolist(), high.tolist(), strict=True)]
            for corner in itertools.product(*ends):
                if self.done[joint_path] or self._corners[joint_path] >= _MOST_CORNERS:
                    break
                self._corners[joint_path] += 1
                self._look(items, row, np.array(corner))
                self.done[joint_path] = self.outcomes[joint_path].hit is not None
            self._finish(joint_path)

    def _look(self, items: Items, row: int, positions: Array) -> None:
        """Examine one pose of the pieces of an item."""
        joint_path, outcome = int(items.joint_path[row]), self.outcomes[items.joint_path[row]]
        depth = depth_of(self.depths, items, row)
        first, second = int(items.first[row]), int(items.second[row])
        overlap = self.confirm(joint_path, first, second, positions, 0.0 if np.isnan(depth) else depth)
        if overlap == "solids" and outcome.hit is None:
            outcome.hit = (first, second, positions)
        elif overlap == "pieces" and outcome.collider_hit is None:
            outcome.collider_hit = (first, second, positions)

    def _finish(self, joint_path: int) -> None:
        outcome = self.outcomes[joint_path]
        self.done[joint_path] = outcome.hit is not None or outcome.collider_hit is not None


def depth_of(depths: Depths | None, items: Items, row: int) -> float:
    """Return the allowed penetration of the pieces of an item; NaN if they may not touch [m]."""
    if depths is None:
        return float("nan")
    return depths(
        int(items.joint_path[row]), int(items.box[row]), int(items.first[row]), int(items.second[row])
    )


GRAIN = 1e9
"""Steps per metre in which gaps are compared, so that all machines break ties alike."""

_UNIT = 0.99  # smallest squared length of a normal
_HARDLY = 0.02  # variables that move the pieces by less than this share of the largest motion are not split


@dataclass(eq=False)
class Planes:
    """Best plane of each item so far."""

    first: Array  # vertices of the nodes of link A, shape (N, V, 3) [m]
    second: Array  # vertices of the nodes of link B, shape (N, W, 3) [m]
    path: list[Motion]  # the joints between them
    best: Array = field(init=False)  # bound of the best plane, shape (N,) [m]
    normal: Array = field(init=False)  # normal of the best plane, shape (N, 3)
    frame: Indices = field(init=False)  # frame of the best plane, shape (N,)

    def __post_init__(self) -> None:
        count = len(self.first)
        self.best = np.full(count, -np.inf)
        self.normal = np.zeros((count, 3))
        self.frame = np.full(count, NONE, np.int64)

    def attempt(self, rows: Indices, normals: Array, frame: int) -> Array:
        """Try directions, shape (n, C, 3), for several items in a frame; return the best gap of each [m]."""
        if not len(rows):
            return np.zeros(0)
        whole = len(rows) == len(self.best)
        path = self.path if whole else [taken(motion, rows) for motion in self.path]
        first, second = (self.first, self.second) if whole else (self.first[rows], self.second[rows])
        gaps = gap(first, second, path, frame, normals)
        gaps[np.sum(normals * normals, axis=2) < _UNIT] = -np.inf  # a zero direction separates nothing
        choice = np.round(gaps * GRAIN).argmax(axis=1)
        line = np.arange(len(rows))
        reached: Array = gaps[line, choice]
        better = reached > self.best[rows]
        chosen = rows[better]
        self.best[chosen] = reached[better]
        self.normal[chosen] = normals[line, choice][better]
        self.frame[chosen] = frame
        return reached


@dataclass(eq=False)
class Ahead:
    """Gain of a split of each variable of open items, along the direction that FCL proposed."""

    first: Array
    second: Array
    path: list[Motion]
    normal: Array
    frame: Indices

    def dimension(self, layout: JointTable, joint_paths: Indices, rows: Indices, motion: Array) -> Indices:
        """Return the variable to split for several items: the one that raises the bound most."""
        motion = motion[rows]
        if motion.shape[1] == 1:
            return np.zeros(len(rows), np.int64)
        gain = np.zeros_like(motion)
        for frame in np.unique(self.frame[rows]):
            if frame < 0:
                continue
            lines = np.flatnonzero(self.frame[rows] == frame)
            chosen = rows[lines]
            path = [taken(each, chosen) for each in self.path]
            normals = self.normal[chosen][:, None, :]
            pieces = self.first[chosen], self.second[chosen]
            before = gap(*pieces, path, int(frame), normals)[:, 0]
            for variable in range(motion.shape[1]):
                held = [
                    replace(
                        each,
                        half=np.where(layout.variable[joint_paths[chosen], step] == variable, 0.0, each.half),
                    )
                    for step, each in enumerate(path)
                ]
                gain[lines, variable] = gap(*pieces, held, int(frame), normals)[:, 0] - before
        score = np.where(self.frame[rows, None] < 0, motion, gain + 1e-3 * motion)
        score[motion < _HARDLY * motion.max(axis=1, keepdims=True)] = -np.inf
        choice: Indices = np.round(score * GRAIN).argmax(axis=1)
        return choice


def taken(motion: Motion, rows: Indices) -> Motion:
    """Return the motion of several items."""
    return Motion(
        motion.kind, *(each[rows] for each in (motion.origin, motion.axis, motion.center, motion.half))
    )


class Coaxial:
    """Joint paths whose joints share one axis, with heights and distances of their pieces.

    Args:
        hierarchy: The pieces of the links.
        joint_paths: Joint paths of the pairs of links.
    """

    def __init__(self, hierarchy: Hierarchy, joint_paths: Sequence[JointPath]) -> None:
        self.nodes = hierarchy
        self.joint_paths = joint_paths
        self._axes = np.array([joint_path.steps[0].axis for joint_path in joint_paths]).reshape(-1, 3)
        self._coaxial = np.array([is_coaxial(joint_path) for joint_path in joint_paths], bool)
        self._profiles: list[dict[int, Array]] = [{} for _ in joint_paths]

    def apart(self, items: Items, rows: Indices, path: Sequence[Motion]) -> tuple[Indices, Array]:
        """Return the rows with pieces on one axis, and their gap [m]."""
        leaf = self.nodes.leaf
        chosen = rows[
            self._coaxial[items.joint_path[rows]] & leaf[items.first[rows]] & leaf[items.second[rows]]
        ]
        if not len(chosen):
            return chosen, np.zeros(0)
        shift, half = np.zeros(len(chosen)), np.zeros(len(chosen))
        for motion in path:
            if motion.kind == "prismatic":
                along = np.sum(motion.axis[chosen] * self._axes[items.joint_path[chosen]], axis=1)
                shift += along * motion.center[chosen]
                half += np.abs(along) * motion.half[chosen]
        first, second = (
            self._profile(items.joint_path[chosen], nodes[chosen]) for nodes in (items.first, items.second)
        )
        return chosen, axis_gap(first, second, shift, half)

    def _profile(self, joint_paths: Indices, nodes: Indices) -> Array:
        """Return the result of `around_axis` for pieces about the axis of their joint path, shape (N, 4)."""
        result = np.empty((len(nodes), 4))
        for joint_path in np.unique(joint_paths):
            known, rows = self._profiles[joint_path], np.flatnonzero(joint_paths == joint_path)
            fresh = np.array([node for node in np.unique(nodes[rows]) if node not in known], np.int64)
            if len(fresh):
                joint = self.joint_paths[joint_path].steps[0]
                found = around_axis(self.nodes.points(fresh), joint.pivot, joint.axis)
                known.update(zip(fresh.tolist(), found, strict=True))
            result[rows] = [known[node] for node in nodes[rows].tolist()]
        return result
