"""Steps of a search: separating planes, pieces on one axis, and witnesses of collisions."""

import itertools
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from artgen._arrays import Array, Indices
from artgen.proof.bounds import Motion, around_axis, axis_gap, gap
from artgen.proof.hierarchy import Hierarchy
from artgen.proof.kinematics import NONE, JointTable, ProofCells, is_coaxial
from artgen.proof.paths import JointPath

Confirm = Callable[[int, int, int, Array, float], str]
"""Function that returns `solids`, `pieces` or an empty text: the objects that overlap at a pose.

It takes the number of the joint path, a piece of each link, the positions and an allowed depth [m].
"""

Depths = Callable[[int, int, int, int], float]
"""Function for the allowed penetration of two pieces, by joint path, box and pieces; NaN if none [m]."""

_FEW = 4  # most candidates for a witness of a pair and level
_MOST_CORNERS = 256  # most corners of cells that are examined for a pair


@dataclass(eq=False)
class SearchOutcome:
    """Result of the search for one pair of links."""

    guaranteed: float = np.inf  # smallest bound of the closed cells; infinite without closed cells [m]
    found: float = np.inf  # smallest distance of two pieces from FCL [m]
    # positions of the variables at that distance, shape (v,) [rad or m]
    found_at: Array = field(default_factory=lambda: np.zeros(0))
    # node of A, node of B and positions of the variables of a confirmed overlap
    hit: tuple[int, int, Array] | None = None
    # the same for an overlap of pieces only, not of the solids
    collider_hit: tuple[int, int, Array] | None = None
    # low and high corner, nodes and distance of each cell that was given up
    open: list[tuple[Array, Array, int, int, float]] = field(default_factory=list)
    late: bool = False  # whether the time limit gave up cells
    used: float = 0.0  # time after which the pair was given up, so that others had some; 0 if it was not [s]

    @property
    def proven(self) -> bool:
        """Whether all cells were closed."""
        return self.hit is None and self.collider_hit is None and not self.open


@dataclass(eq=False)
class Witnesses:
    """Search for witnesses."""

    joint_paths: Sequence[JointPath]  # joint paths of the pairs of links
    outcomes: Sequence[SearchOutcome]  # outcome of each joint path; witnesses are stored there
    confirm: Confirm  # examines a pose in which pieces seem to overlap
    depths: Depths  # allowed penetration of two pieces

    def __post_init__(self) -> None:
        self.done = np.zeros(len(self.joint_paths), bool)
        self._corners = np.zeros(len(self.joint_paths), np.int64)

    def in_middles(self, cells: ProofCells, rows: Indices) -> None:
        """Examine the centers of several cells, a few for each joint path."""
        examined: Counter[int] = Counter()
        for row in rows.tolist():
            number = int(cells.joint_path[row])
            if not self.done[number] and examined[number] < _FEW:
                examined[number] += 1
                count = len(self.joint_paths[number].variables)
                self._examine(cells, row, ((cells.low[row] + cells.high[row]) / 2.0)[:count])
        for number in examined:
            self._finish(number)

    def in_corners(self, cells: ProofCells, rows: Indices) -> None:
        """Examine the corners of small cells, where depths are nearly linear in the positions.

        Pieces that touch slightly at the center of such a cell overlap most in one of its corners.
        """
        for row in rows.tolist():
            number = int(cells.joint_path[row])
            box = self.joint_paths[number].boxes[cells.box[row]]
            low, high = (np.clip(end[row, : len(box)], *box.T) for end in (cells.low, cells.high))
            ends = [(a, b) if a < b else (a,) for a, b in zip(low.tolist(), high.tolist(), strict=True)]
            for corner in itertools.product(*ends):
                if self.done[number] or self._corners[number] >= _MOST_CORNERS:
                    break
                self._corners[number] += 1
                self._examine(cells, row, np.array(corner))
                self.done[number] = self.outcomes[number].hit is not None
            self._finish(number)

    def _examine(self, cells: ProofCells, row: int, positions: Array) -> None:
        """Examine one pose of the pieces of a cell."""
        number, box, first, second = cells.numbers(row)
        outcome, depth = self.outcomes[number], self.depths(number, box, first, second)
        overlap = self.confirm(number, first, second, positions, 0.0 if np.isnan(depth) else depth)
        if overlap == "solids" and outcome.hit is None:
            outcome.hit = (first, second, positions)
        elif overlap == "pieces" and outcome.collider_hit is None:
            outcome.collider_hit = (first, second, positions)

    def _finish(self, number: int) -> None:
        outcome = self.outcomes[number]
        self.done[number] = outcome.hit is not None or outcome.collider_hit is not None


GRAIN = 1e9  # steps per metre in which gaps are compared, so that all machines break ties alike
_UNIT = 0.99  # smallest squared length of a normal
_HARDLY = 0.02  # variables that move the pieces by less than this share of the largest motion are not split


@dataclass(eq=False)
class Planes:
    """Best plane of each cell so far."""

    first: Array  # vertices of the nodes of link A, shape (N, V, 3) [m]
    second: Array  # vertices of the nodes of link B, shape (N, W, 3) [m]
    path: list[Motion]  # the joints between them

    def __post_init__(self) -> None:
        count = len(self.first)
        self.best: Array = np.full(count, -np.inf)  # bound of the best plane, shape (N,) [m]
        self.normal: Array = np.zeros((count, 3))
        self.frame: Indices = np.full(count, NONE, np.int64)

    def attempt(self, rows: Indices, normals: Array, frame: int) -> Array:
        """Try directions, shape (n, C, 3), for several cells in a frame; return the best gap of each [m]."""
        if not len(rows):
            return np.zeros(0)
        whole = len(rows) == len(self.best)
        path = self.path if whole else [motion[rows] for motion in self.path]
        first, second = (self.first, self.second) if whole else (self.first[rows], self.second[rows])
        gaps = gap(first, second, path, frame, normals)
        gaps[np.sum(normals * normals, axis=2) < _UNIT] = -np.inf  # a zero direction separates nothing
        choice = np.round(gaps * GRAIN).argmax(axis=1)
        line = np.arange(len(rows))
        reached: Array = gaps[line, choice]
        better = np.round(reached * GRAIN) > np.round(self.best[rows] * GRAIN)
        chosen = rows[better]
        self.best[chosen] = reached[better]
        self.normal[chosen] = normals[line, choice][better]
        self.frame[chosen] = frame
        return reached


@dataclass(eq=False)
class Ahead:
    """Gain of a split of each variable of open cells, along the direction that FCL proposed."""

    first: Array
    second: Array
    path: list[Motion]
    normal: Array
    frame: Indices

    def dimension(self, table: JointTable, joint_paths: Indices, rows: Indices, reach: Array) -> Indices:
        """Return the variable to split for several cells: the one that raises the bound most."""
        reach = reach[rows]
        if reach.shape[1] == 1:
            return np.zeros(len(rows), np.int64)
        gain = np.zeros_like(reach)
        frames = self.frame[rows]
        for frame in np.unique(frames[frames >= 0]):
            lines = np.flatnonzero(frames == frame)
            chosen = rows[lines]
            path = [motion[chosen] for motion in self.path]
            normals = self.normal[chosen][:, None, :]
            pieces = self.first[chosen], self.second[chosen]
            before = gap(*pieces, path, int(frame), normals)[:, 0]
            for variable in range(reach.shape[1]):
                fixed = table.variable[joint_paths[chosen]] == variable
                held = [
                    replace(motion, half=np.where(fixed[:, step], 0.0, motion.half))
                    for step, motion in enumerate(path)
                ]
                gain[lines, variable] = gap(*pieces, held, int(frame), normals)[:, 0] - before
        score = np.where(frames[:, None] < 0, reach, gain + 1e-3 * reach)
        score[reach < _HARDLY * reach.max(axis=1, keepdims=True)] = -np.inf
        return np.asarray(np.round(score * GRAIN).argmax(axis=1))


class Coaxial:
    """Joint paths whose joints share one axis, with heights and distances of their pieces."""

    def __init__(self, nodes: Hierarchy, joint_paths: Sequence[JointPath]) -> None:
        self._nodes = nodes
        self._first = [joint_path.steps[0] for joint_path in joint_paths]
        self._axes = np.array([joint.axis for joint in self._first])
        self._coaxial = np.array([is_coaxial(joint_path) for joint_path in joint_paths])
        self._profiles: list[dict[int, Array]] = [{} for _ in joint_paths]

    def apart(self, cells: ProofCells, rows: Indices, path: Sequence[Motion]) -> tuple[Indices, Array]:
        """Return the rows with pieces on one axis, and their gap [m]."""
        leaf = self._nodes.leaf
        on_axis = self._coaxial[cells.joint_path[rows]]
        rows = rows[on_axis & leaf[cells.first[rows]] & leaf[cells.second[rows]]]
        if not len(rows):
            return rows, np.zeros(0)
        joint_paths = cells.joint_path[rows]
        shift, half = np.zeros(len(rows)), np.zeros(len(rows))
        for motion in path:
            if motion.kind == "prismatic":
                along = np.sum(motion.axis[rows] * self._axes[joint_paths], axis=1)
                shift += along * motion.center[rows]
                half += np.abs(along) * motion.half[rows]
        first, second = (self._profile(joint_paths, nodes[rows]) for nodes in (cells.first, cells.second))
        return rows, axis_gap(first, second, shift, half)

    def _profile(self, joint_paths: Indices, nodes: Indices) -> Array:
        """Return the result of `around_axis` for pieces about the axis of their joint path, shape (N, 4)."""
        result = np.empty((len(nodes), 4))
        for number in np.unique(joint_paths):
            known, rows = self._profiles[number], np.flatnonzero(joint_paths == number)
            fresh = np.array([node for node in np.unique(nodes[rows]) if node not in known], np.int64)
            if len(fresh):
                joint = self._first[number]
                found = around_axis(self._nodes.points(fresh), joint.pivot, joint.axis)
                known.update(zip(fresh.tolist(), found, strict=True))
            result[rows] = [known[node] for node in nodes[rows].tolist()]
        return result
