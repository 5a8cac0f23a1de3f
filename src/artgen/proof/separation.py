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
from artgen.proof.paths import Way

Confirm = Callable[[int, int, int, Array, float], str]
"""Tells what overlaps, `solids`, `pieces` or nothing (an empty text).

Its arguments are the way's number, a leaf of each link, the variables' positions and an allowed depth [m].
"""

Depths = Callable[[int, int, int, int], float]
"""Tells how deep two leaves may press into each other, by way, box and leaves; NaN if they may not [m]."""

_FEW = 4  # candidates for a witness that are looked at for a pair and level
_MOST_CORNERS = 256  # corners of cells that are looked at for a pair


class Witnesses:
    """The search for witnesses.

    Args:
        ways: The pairs of links.
        outcomes: What was found about each; witnesses are noted there.
        confirm: Looks closely at a pose in which pieces seem to overlap.
        depths: Depth to which two leaves may press into each other; None where no contact is allowed at all.
    """

    def __init__(
        self, ways: Sequence[Way], outcomes: Sequence[SearchOutcome], confirm: Confirm, depths: Depths | None
    ) -> None:
        self.ways = ways
        self.outcomes = outcomes
        self.confirm = confirm
        self.depths = depths
        self.done = np.zeros(len(ways), bool)
        self._corners = np.zeros(len(ways), np.int64)

    def in_middles(self, items: Items, rows: Indices) -> None:
        """Look at the middles of the cells of some items, a few for each way."""
        looked: dict[int, int] = {}
        for row in rows.tolist():
            way = int(items.way[row])
            if self.done[way] or looked.get(way, 0) >= _FEW:
                continue
            looked[way] = looked.get(way, 0) + 1
            count = len(self.ways[way].variables)
            self._look(items, row, ((items.low[row] + items.high[row]) / 2.0)[:count])
        for way in looked:
            self._finish(way)

    def in_corners(self, items: Items, rows: Indices) -> None:
        """Look at the corners of small cells: how deep pieces press there is all but linear in the positions.

        Pieces that graze each other in the middle of such a cell are deepest in one of its corners.
        """
        for row in rows.tolist():
            way = int(items.way[row])
            box = self.ways[way].boxes[items.box[row]]
            low, high = (np.clip(end[row, : len(box)], *box.T) for end in (items.low, items.high))
            ends = [(a, b) if a < b else (a,) for a, b in zip(low.tolist(), high.tolist(), strict=True)]
            for corner in itertools.product(*ends):
                if self.done[way] or self._corners[way] >= _MOST_CORNERS:
                    break
                self._corners[way] += 1
                self._look(items, row, np.array(corner))
                self.done[way] = self.outcomes[way].hit is not None
            self._finish(way)

    def _look(self, items: Items, row: int, positions: Array) -> None:
        """Look closely at one pose of an item's pieces."""
        way, outcome = int(items.way[row]), self.outcomes[items.way[row]]
        depth = depth_of(self.depths, items, row)
        first, second = int(items.first[row]), int(items.second[row])
        overlap = self.confirm(way, first, second, positions, 0.0 if np.isnan(depth) else depth)
        if overlap == "solids" and outcome.hit is None:
            outcome.hit = (first, second, positions)
        elif overlap == "pieces" and outcome.collider_hit is None:
            outcome.collider_hit = (first, second, positions)

    def _finish(self, way: int) -> None:
        outcome = self.outcomes[way]
        self.done[way] = outcome.hit is not None or outcome.collider_hit is not None


def depth_of(depths: Depths | None, items: Items, row: int) -> float:
    """Return how deep the leaves of an item may press into each other; NaN if they may not touch [m]."""
    if depths is None:
        return float("nan")
    return depths(int(items.way[row]), int(items.box[row]), int(items.first[row]), int(items.second[row]))


GRAIN = 1e9
"""Steps per metre in which gaps are compared, so that ties fall alike on every machine."""

_UNIT = 0.99  # least square of the length of a normal
_HARDLY = 0.02  # variables that move the pieces by less than this share of the largest motion stay whole


@dataclass(eq=False)
class Planes:
    """The best plane of each item so far.

    Attributes:
        first: Vertices of the nodes of link A, shape (N, V, 3) [m].
        second: Vertices of the nodes of link B, shape (N, W, 3) [m].
        path: The joints between them.
        best: The bound of the best plane, shape (N,) [m].
        normal: Its normal, shape (N, 3).
        frame: Its frame, shape (N,).
    """

    first: Array
    second: Array
    path: list[Motion]
    best: Array = field(init=False)
    normal: Array = field(init=False)
    frame: Indices = field(init=False)

    def __post_init__(self) -> None:
        count = len(self.first)
        self.best = np.full(count, -np.inf)
        self.normal = np.zeros((count, 3))
        self.frame = np.full(count, NONE, np.int64)

    def attempt(self, rows: Indices, normals: Array, frame: int) -> Array:
        """Try directions, shape (n, C, 3), for some items in a frame; return the best gap of each [m]."""
        if not len(rows):
            return np.zeros(0)
        whole = len(rows) == len(self.best)
        path = self.path if whole else [taken(motion, rows) for motion in self.path]
        first, second = (self.first, self.second) if whole else (self.first[rows], self.second[rows])
        gaps = gap(first, second, path, frame, normals)
        gaps[np.sum(normals * normals, axis=2) < _UNIT] = -np.inf  # no direction: that keeps nothing apart
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
    """What splitting each variable of open items would gain, along the direction that FCL proposed."""

    first: Array
    second: Array
    path: list[Motion]
    normal: Array
    frame: Indices

    def dimension(self, layout: JointTable, ways: Indices, rows: Indices, motion: Array) -> Indices:
        """Return the variable to split for some items: the one that would raise the bound most."""
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
                        each, half=np.where(layout.variable[ways[chosen], step] == variable, 0.0, each.half)
                    )
                    for step, each in enumerate(path)
                ]
                gain[lines, variable] = gap(*pieces, held, int(frame), normals)[:, 0] - before
        score = np.where(self.frame[rows, None] < 0, motion, gain + 1e-3 * motion)
        score[motion < _HARDLY * motion.max(axis=1, keepdims=True)] = -np.inf
        choice: Indices = np.round(score * GRAIN).argmax(axis=1)
        return choice


def taken(motion: Motion, rows: Indices) -> Motion:
    """Return the motion of some of its items."""
    return Motion(
        motion.kind, *(each[rows] for each in (motion.origin, motion.axis, motion.center, motion.half))
    )


class Coaxial:
    """The ways whose joints are all about one axis, and what their pieces are about it.

    Args:
        hierarchy: The pieces of the links.
        ways: The pairs of links.
    """

    def __init__(self, hierarchy: Hierarchy, ways: Sequence[Way]) -> None:
        self.nodes = hierarchy
        self.ways = ways
        self._axes = np.array([way.steps[0].axis for way in ways]).reshape(-1, 3)
        self._coaxial = np.array([is_coaxial(way) for way in ways], bool)
        self._profiles: list[dict[int, Array]] = [{} for _ in ways]

    def apart(self, items: Items, rows: Indices, path: Sequence[Motion]) -> tuple[Indices, Array]:
        """Return those rows whose items are pieces about one axis, and how far they are apart there [m]."""
        leaf = self.nodes.leaf
        chosen = rows[self._coaxial[items.way[rows]] & leaf[items.first[rows]] & leaf[items.second[rows]]]
        if not len(chosen):
            return chosen, np.zeros(0)
        shift, half = np.zeros(len(chosen)), np.zeros(len(chosen))
        for motion in path:
            if motion.kind == "prismatic":
                along = np.sum(motion.axis[chosen] * self._axes[items.way[chosen]], axis=1)
                shift += along * motion.center[chosen]
                half += np.abs(along) * motion.half[chosen]
        first, second = (
            self._profile(items.way[chosen], nodes[chosen]) for nodes in (items.first, items.second)
        )
        return chosen, axis_gap(first, second, shift, half)

    def _profile(self, ways: Indices, nodes: Indices) -> Array:
        """Return what `around_axis` says of pieces about the axis of their way, shape (N, 4)."""
        result = np.empty((len(nodes), 4))
        for way in np.unique(ways):
            known, rows = self._profiles[way], np.flatnonzero(ways == way)
            fresh = np.array([node for node in np.unique(nodes[rows]) if node not in known], np.int64)
            if len(fresh):
                joint = self.ways[way].steps[0]
                found = around_axis(self.nodes.points(fresh), joint.pivot, joint.axis)
                known.update(zip(fresh.tolist(), found, strict=True))
            result[rows] = [known[node] for node in nodes[rows].tolist()]
        return result
