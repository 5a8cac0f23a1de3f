"""Branch and bound over pairs of pieces and cells of joint space: separating planes, or a witness.

A cell belongs to two nodes (pieces, or boxes around several pieces) and to a part of the joint space of their
links. A plane in one of the frames along the path closes it if its bound over the whole cell exceeds the
threshold. For joints about one axis, heights and distances from the axis close it as well. Open cells are
split: the larger node if it exceeds the motion in the cell, else the cell. Small cells of pieces that are too
close are given up after their corners were tried. FCL proposes directions and candidates for overlaps; no
proof relies on it. All pairs of links are searched in one batch.
"""

import math
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from artgen._arrays import Array, Indices, Mask
from artgen._progress import Update, progress
from artgen.asset.certificate import AXIS_FRAME
from artgen.asset.joint import JointKind
from artgen.proof.bounds import Motion, growth
from artgen.proof.hierarchy import Hierarchy
from artgen.proof.kinematics import NONE, Frames, JointTable, ProofCells, frames, starting_cells
from artgen.proof.overlap import PRESSED
from artgen.proof.paths import JointPath
from artgen.proof.separation import GRAIN, Ahead, Coaxial, Confirm, Depths, Planes, SearchOutcome, Witnesses

MARGIN = 1e-8  # margin of a bound over its threshold; float64 has errors of 1e-14 at one metre [m]
_CAP = 0.010  # clearances beyond this are not measured [m]
_SHARE = 0.8  # the guaranteed clearance is at least this share of the one found
_CLOSE = 5e-5  # pieces nearer than this, beyond the tolerance, at the center of a cell are given up [m]
_STILL = 2e-5  # cells in which no point moves farther than this are given up [m]
_SMALL = 1e-3  # larger cells are split even for close pieces, to find collisions [m]
_MOST_CLOSE = 2000  # most such cells to split for a pair
_MOST_CELLS = 300_000  # number of cells after which the rest stays open
_AT_ONCE = 400_000  # most vertices of cells between two looks at the clock
_LONG = 4  # joints above which the points that enclose arcs limit the cells at once
_MOST_POINTS = 1 << 19  # most such points at once
_DECIMALS = 9  # decimals of normals
_POSE_DECIMALS = 12  # decimals of poses that FCL is given
_TIE = 1e-9  # a clearance is smaller only by more; rounding does not decide between equal ones [m]
_MANY = 24  # vertices above which a node is searched separately from smaller nodes
_FARTHEST = 3  # most joints between the frame of a plane and either link
_MOST_AT_REST = 48  # most pairs of pieces whose distance at rest is measured


@dataclass(eq=False)
class Search:
    """Search for several pairs of links."""

    nodes: Hierarchy  # the pieces of the links
    joint_paths: Sequence[JointPath]  # joint paths of the pairs of links
    trees: Sequence[tuple[int, int]]  # for each joint path the numbers of the trees of its links
    confirm: Confirm  # examines a pose in which pieces seem to overlap
    depths: Depths  # allowed penetration of two pieces
    tolerances: Array  # required clearance of the pieces of each joint path, shape (paths,) [m]
    # clearance below which the solids may overlap; the requirement that remains after the tolerance of a
    # joint path is refuted, shape (paths,) [m]
    least: Array
    measure: bool  # whether to bracket the clearance up to `_CAP`
    seconds: float = np.inf  # time after which the rest stays open [s]
    brief: bool = False  # whether to end at the first joint path that is not proven

    def __post_init__(self) -> None:
        count = len(self.joint_paths)
        self.outcomes = [SearchOutcome() for _ in self.joint_paths]
        self._most = max(len(joint_path.variables) for joint_path in self.joint_paths)
        self._contacts = np.array([any(joint_path.allowed) for joint_path in self.joint_paths])
        self._witnesses = Witnesses(self.joint_paths, self.outcomes, self.confirm, self.depths)
        self._done = self._witnesses.done
        self._found, self._guaranteed = np.full(count, np.inf), np.full(count, np.inf)
        self._split_close = np.zeros(count, np.int64)
        self._seen, self._used = np.zeros(count, np.int64), np.zeros(count)  # cells and time [s] of each
        kinds: dict[tuple[JointKind, ...], list[int]] = {}
        for number, joint_path in enumerate(self.joint_paths):
            kinds.setdefault(tuple(joint.kind for joint in joint_path.steps), []).append(number)
        # joint paths of the same kinds share a table, in which each has a row
        self._tables: list[JointTable] = []
        self._table, self._row = np.zeros(count, np.int64), np.zeros(count, np.int64)
        for number, members in enumerate(kinds.values()):
            self._tables.append(JointTable.of([self.joint_paths[member] for member in members]))
            self._table[members], self._row[members] = number, np.arange(len(members))
        self._coaxial = Coaxial(self.nodes, self.joint_paths)

    def run(self) -> list[ProofCells]:
        """Search until all cells are closed, refuted or given up; return the closed cells of each path."""
        with progress("proof") as update:
            return self._run(update)

    def _run(self, update: Update) -> list[ProofCells]:
        end = time.monotonic() + self.seconds
        cells = self._start()
        self._closed = [cells[:0]]
        if self.measure:
            for number in range(len(self.joint_paths)):
                self._measure_near_rest(number)
        while len(cells):
            self._seen += self._counts(cells)
            cells = self._without_costly(cells, end)
            late = time.monotonic() > end
            if self._seen.sum() > _MOST_CELLS or late:
                self._give_up(cells, np.full(len(cells), np.nan))
                for number in np.unique(cells.joint_path):
                    self.outcomes[number].late = late
                break
            links = " and ".join(self.joint_paths[cells.joint_path[0]].links)
            update(text=f"proof: {links}, {len(cells)} cells left")
            parts = [cells[:0]]
            for some, table in self._portions(cells):
                begin = time.monotonic()
                if begin > end or self._costly(cells, end - begin) in some.joint_path:
                    parts.append(some)
                    continue
                parts += self._examine(some, table)
                self._used += (time.monotonic() - begin) / len(some) * self._counts(some)
            cells = ProofCells.join(parts)
            cells = cells[~self._done[cells.joint_path]]
            if self.brief and not all(outcome.proven for outcome in self.outcomes):
                break
        for number, outcome in enumerate(self.outcomes):
            outcome.guaranteed, outcome.found = float(self._guaranteed[number]), float(self._found[number])
        closed = ProofCells.join(self._closed)
        closed = closed[np.argsort(closed.joint_path, kind="stable")]
        ends = np.searchsorted(closed.joint_path, np.arange(1, len(self.joint_paths)))
        return [closed[slice(*each)] for each in zip([0, *ends], [*ends, len(closed)], strict=True)]

    def _counts(self, cells: ProofCells) -> Indices:
        """Return the number of cells of each path."""
        return np.bincount(cells.joint_path, minlength=len(self.joint_paths))

    def _costly(self, cells: ProofCells, left: float) -> int | None:
        """Return the open path that has used more time than is left, while others are open; else None."""
        numbers = np.unique(cells.joint_path)
        number = int(numbers[np.argmax(self._used[numbers])])
        return number if len(numbers) > 1 and self._used[number] > left else None

    def _without_costly(self, cells: ProofCells, end: float) -> ProofCells:
        """Give up the path that leaves the others without time, or without cells."""
        number = self._costly(cells, end - time.monotonic())
        outcome = None if number is None else self.outcomes[number]
        if outcome is not None:
            outcome.late, outcome.used = True, float(self._used[number])
        elif self._seen.sum() > _MOST_CELLS:
            most = int(np.argmax(self._seen))
            if 2 * self._seen[most] > self._seen.sum() and (cells.joint_path != most).any():
                number = most
        if number is None:
            return cells
        self._seen[number] = 0
        chosen = cells.joint_path == number
        self._give_up(cells[chosen], np.full(int(chosen.sum()), np.nan))
        return cells[~chosen]

    def _portions(self, cells: ProofCells) -> Iterator[tuple[ProofCells, JointTable]]:
        """Yield cells of one table and of nodes of like size; give up those with too many points."""
        counts = self.nodes.count
        big = 2 * (counts[cells.first] > _MANY) + (counts[cells.second] > _MANY)
        group = 4 * self._table[cells.joint_path] + big
        for key in np.unique(group):
            some, table = cells[group == key], self._tables[key // 4]
            at_once = self._at_once(some, table)
            if not at_once:
                self._give_up(some, np.full(len(some), np.nan))
                continue
            for start in range(0, len(some), at_once):
                yield some[start : start + at_once], table

    def _at_once(self, cells: ProofCells, table: JointTable) -> int:
        """Return how many cells to examine at once; 0 if the points of a single one are too many."""
        sizes = [int(self.nodes.count[side].max()) for side in (cells.first, cells.second)]
        most = len(cells) if self.seconds == np.inf else 1 + _AT_ONCE // sum(sizes)
        if len(table.kinds) <= _LONG:
            return most
        # a plane next to one link takes the points of the other link through all joints but one, and each of
        # these joints multiplies them
        factors = [growth(each) for each in table.motions(self._row[cells.joint_path], cells.low, cells.high)]
        points = max(sizes) * max(math.prod(factors[1:]), math.prod(factors[:-1]))
        return min(most, _MOST_POINTS // points)

    def _start(self) -> ProofCells:
        """Return the first cells of the paths that are left: both whole links in each box."""
        starts = [
            (number, box, cell)
            for number, joint_path in enumerate(self.joint_paths)
            if not self._done[number]
            for box, cell in starting_cells(joint_path)
        ]
        joint_path, box = (np.array([start[column] for start in starts], np.int64) for column in (0, 1))
        ends = np.zeros((len(starts), self._most, 2))
        for row, (_, _, cell) in enumerate(starts):
            ends[row, : len(cell)] = cell
        first, second = self.nodes.roots[np.array(self.trees)][joint_path].T
        frame, normal = np.full(len(starts), NONE), np.zeros((len(starts), 3))
        low, high = (np.ascontiguousarray(ends[:, :, end]) for end in (0, 1))
        return ProofCells(joint_path, box, first, second, low, high, normal, frame)

    def _measure_near_rest(self, number: int) -> None:
        """Measure the distance of links near rest, which leaves less to measure later."""
        nodes = self.nodes
        corners = [np.clip(0.0, *box.T) for box in self.joint_paths[number].boxes]
        box = int(np.argmin([np.abs(corner).sum() for corner in corners]))
        at = np.pad(corners[box], (0, self._most - len(corners[box])))[None]
        table = self._tables[self._table[number]]
        pose = frames(table.motions(self._row[[number]], at, at))
        first, second = (np.flatnonzero(nodes.leaf & (nodes.tree == tree)) for tree in self.trees[number])
        rotation, offset = pose.rotations[-1][0], pose.offset[0]
        half_a, half_b = nodes.half[first], nodes.half[second] @ np.abs(rotation).T
        between = np.abs(nodes.center[first][:, None] - (nodes.center[second] @ rotation.T + offset)[None])
        apart = np.maximum(between - half_a[:, None] - half_b[None], 0.0)
        order = np.sqrt(np.sum(apart * apart, axis=2))
        for flat in np.argsort(order, axis=None, kind="stable")[:_MOST_AT_REST].tolist():
            row, column = divmod(flat, len(second))
            if order[row, column] >= min(self._found[number], _CAP):
                break
            a, b = int(first[row]), int(second[column])
            if np.isnan(self.depths(number, box, a, b)):
                distance, towards = nodes.distance(a, b, rotation, offset)
                if 0.0 < distance < self._found[number] - _TIE:
                    distance = nodes.checked(a, b, rotation, offset, distance, towards)
                    self._found[number], self.outcomes[number].found_at = distance, corners[box]

    def _threshold(self, cells: ProofCells) -> Array:
        """Return the gap that closes each cell [m]."""
        threshold = self.tolerances[cells.joint_path]
        if self.measure:
            threshold = np.maximum(threshold, _SHARE * np.minimum(self._found[cells.joint_path], _CAP))
        for row in np.flatnonzero(self._contacts[cells.joint_path]):
            depth = self._depth(cells, int(row))
            if not np.isnan(depth):
                threshold[row] = -depth - 2.0 * MARGIN  # contact is exact to rounding only
        return threshold + MARGIN

    def _depth(self, cells: ProofCells, row: int) -> float:
        """Return the allowed penetration of the pieces of a cell; NaN if they may not touch."""
        pieces = self.nodes.leaf[cells.first[row]] and self.nodes.leaf[cells.second[row]]
        return self.depths(*cells.numbers(row)) if pieces else float("nan")

    def _examine(self, cells: ProofCells, table: JointTable) -> list[ProofCells]:
        """Close cells of one table if possible, and return the cells into which the others are split."""
        path = table.motions(self._row[cells.joint_path], cells.low, cells.high)
        threshold = self._threshold(cells)
        planes = Planes(self.nodes.points(cells.first), self.nodes.points(cells.second), path)
        pose = frames(path)
        self._try_known(planes, cells, pose)
        self._record(cells, planes, threshold, np.arange(len(cells)))
        rows = self._try_axis(cells, np.flatnonzero(planes.best <= threshold), path, threshold)
        if not len(rows):
            return []
        distance, towards, frame = self._try_distance(planes, cells, pose, rows, threshold)
        self._record(cells, planes, threshold, rows)
        still = planes.best[rows] <= threshold[rows]
        rows, distance = rows[still], distance[still]
        opened = replace(cells[rows], normal=planes.normal[rows], frame=planes.frame[rows])
        if self._refute(opened, distance, threshold[rows]):
            threshold = self._threshold(cells)
        # look for witnesses among pieces that seem to touch
        touching = self._are_pieces(opened) & ~(distance > PRESSED)
        self._witnesses.in_middles(opened, np.flatnonzero(touching))
        left = ~self._done[opened.joint_path]
        if not left.any():
            return []
        opened, rows, distance = opened[left], rows[left], distance[left]
        path = [motion[rows] for motion in path]
        ahead = Ahead(planes.first[rows], planes.second[rows], path, towards[still][left], frame[still][left])
        return self._split(opened, distance, threshold[rows], planes.best[rows], table, ahead)

    def _try_known(self, planes: Planes, cells: ProofCells, pose: Frames) -> None:
        """Try the plane from before the split, the direction between the centers and the main faces."""
        nodes, last = self.nodes, len(planes.path)
        for frame in range(1, last):
            rows = np.flatnonzero(cells.frame == frame)
            planes.attempt(rows, cells.normal[rows][:, None, :], frame)
        moved = np.matmul(pose.rotations[-1], nodes.center[cells.second][:, :, None])[:, :, 0] + pose.offset
        middle = moved - nodes.center[cells.first]
        length = np.sqrt(np.sum(middle * middle, axis=1, keepdims=True))
        middle /= np.where(length > 0.0, length, 1.0)
        for frame, of_link in ((0, cells.first), (last, cells.second)):
            towards = pose.directions(middle, frame)
            axes = nodes.main_axes(of_link)
            side = np.sign(np.round(np.matmul(axes, towards[:, :, None]), _DECIMALS))
            axes = axes * np.where(side == 0.0, 1.0, side)
            before = np.where((cells.frame == frame)[:, None], cells.normal, axes[:, 0])
            candidates = [before[:, None], axes]
            if last <= _FARTHEST:
                candidates.append(_grained(towards)[:, None])
            planes.attempt(np.arange(len(cells)), np.concatenate(candidates, axis=1), frame)

    def _try_axis(self, cells: ProofCells, rows: Indices, path: list[Motion], threshold: Array) -> Indices:
        """Close pieces on one axis by heights and distances from it; return the cells that stay open."""
        free = (threshold[rows] > 0.0) | ~self._contacts[cells.joint_path[rows]]
        about, apart = self._coaxial.apart(cells, rows[free], path)
        closed = apart > np.maximum(threshold[about], MARGIN)
        if closed.any():
            done = cells[about[closed]]
            done.frame[:] = AXIS_FRAME
            self._close(done, apart[closed])
        return rows[~np.isin(rows, about[closed])]

    def _try_distance(
        self, planes: Planes, cells: ProofCells, pose: Frames, rows: Indices, threshold: Array
    ) -> tuple[Array, Array, Indices]:
        """Try the directions that FCL proposes at the center of the cells."""
        distance, direction = self._distances(cells, pose, rows)
        separated = np.any(direction != 0.0, axis=1)
        best = np.full(len(rows), -np.inf)
        towards, of_frame = np.zeros((len(rows), 3)), np.full(len(rows), NONE)
        last = len(planes.path)
        for frame in range(last + 1):
            if max(frame, last - frame) > _FARTHEST and last <= 2 * _FARTHEST:
                continue
            chosen = np.flatnonzero(separated & (planes.best[rows] <= threshold[rows]))
            if not len(chosen):
                break
            normal = _grained(pose.directions(direction[chosen], frame, rows[chosen]))
            reached = planes.attempt(rows[chosen], normal[:, None, :], frame)
            better = np.round(reached * GRAIN) > np.round(best[chosen] * GRAIN)
            chosen, normal = chosen[better], normal[better]
            best[chosen], towards[chosen], of_frame[chosen] = reached[better], normal, frame
        return distance, towards, of_frame

    def _distances(self, cells: ProofCells, pose: Frames, rows: Indices) -> tuple[Array, Array]:
        """Return FCL's distance of each pair of nodes and the direction between their nearest points."""
        distances, directions = np.full(len(rows), -1.0), np.zeros((len(rows), 3))
        leaf = self.nodes.leaf
        # FCL's steps depend on the last digits
        rotations, offsets = (
            np.round(each[rows], _POSE_DECIMALS) for each in (pose.rotations[-1], pose.offset)
        )
        for index, row in enumerate(rows.tolist()):
            number, _, first, second = cells.numbers(row)
            found = self.nodes.distance(first, second, rotations[index], offsets[index])
            distances[index], directions[index] = found
            if leaf[first] and leaf[second] and 0.0 < distances[index] < self._found[number] - _TIE:
                if self._contacts[number] and not np.isnan(self._depth(cells, row)):
                    continue
                self._found[number] = self.nodes.checked(
                    first, second, rotations[index], offsets[index], distances[index], directions[index]
                )
                count = len(self.joint_paths[number].variables)
                self.outcomes[number].found_at = ((cells.low[row] + cells.high[row]) / 2.0)[:count]
        return distances, directions

    def _record(self, cells: ProofCells, planes: Planes, threshold: Array, rows: Indices) -> None:
        """Close the cells in given rows whose best plane exceeds the threshold."""
        rows = rows[planes.best[rows] > threshold[rows]]
        if len(rows):
            done = replace(cells[rows], normal=planes.normal[rows], frame=planes.frame[rows])
            self._close(done, planes.best[rows])

    def _close(self, cells: ProofCells, apart: Array) -> None:
        self._closed.append(cells)
        free = ~self._contacts[cells.joint_path]
        for row in np.flatnonzero(~free):
            free[row] = np.isnan(self._depth(cells, int(row)))
        np.minimum.at(self._guaranteed, cells.joint_path[free], apart[free])

    def _are_pieces(self, cells: ProofCells) -> Mask:
        """Tell which cells belong to two pieces, not to boxes around several pieces."""
        return self.nodes.leaf[cells.first] & self.nodes.leaf[cells.second]

    def _refute(self, cells: ProofCells, distance: Array, threshold: Array) -> bool:
        """Mark joint paths with less clearance than their tolerance; search them for collisions only."""
        tolerance, least = self.tolerances[cells.joint_path], self.least[cells.joint_path]
        close = self._are_pieces(cells) & (threshold > 0.0) & (distance > 0.0) & (distance < tolerance)
        refuted = np.flatnonzero(close & (tolerance > least))
        if not len(refuted):
            return False
        numbers, first = np.unique(cells.joint_path[refuted], return_index=True)
        rows = np.sort(refuted[first])
        self._give_up(cells[rows], distance[rows])
        self.tolerances[numbers] = self.least[numbers]
        return True

    def _hopeless(self, cells: ProofCells, distance: Array, threshold: Array, total: Array) -> Mask:
        """Tell which cells to give up: pieces that hardly move, or that are too close in a small cell."""
        # a large cell may hide a collision: it is split further while there are few cells
        pieces, joint_paths = self._are_pieces(cells), cells.joint_path
        close = pieces & (distance < self.tolerances[joint_paths] + _CLOSE) & (threshold > 0.0)
        large = close & (total > _SMALL)
        np.add.at(self._split_close, joint_paths[large], 1)
        still = pieces & (total < _STILL)
        return still | (close & ~(large & (self._split_close[joint_paths] < _MOST_CLOSE)))

    def _give_up(self, cells: ProofCells, distance: Array) -> None:
        for row, value in enumerate(distance.tolist()):
            number, _, first, second = cells.numbers(row)
            count = len(self.joint_paths[number].variables)
            low, high = cells.low[row, :count], cells.high[row, :count]
            self.outcomes[number].open.append((low, high, first, second, value))

    def _split(
        self,
        cells: ProofCells,
        distance: Array,
        threshold: Array,
        best: Array,
        table: JointTable,
        ahead: Ahead,
    ) -> list[ProofCells]:
        """Split the larger node of each cell, or the cell."""
        nodes, table_rows = self.nodes, self._row[cells.joint_path]
        both = np.stack((cells.first, cells.second))
        reach = table.reach(table_rows, ahead.path, nodes.center[both], nodes.radius[both], self._most)
        total = reach.sum(axis=1)
        sizes = np.where(nodes.leaf[both], 0.0, nodes.radius[both])
        larger = sizes.max(axis=0)
        divide = (larger > 0.0) & ((larger > 0.25 * total) | (total < _STILL))
        stuck = self._hopeless(cells, distance, threshold, total)
        if stuck.any():
            self._witnesses.in_corners(cells, np.flatnonzero(stuck & self._are_pieces(cells)))
            # proven as far as required, only not as far as measured
            enough = stuck & (threshold > 0.0) & (best > self.tolerances[cells.joint_path] + MARGIN)
            if enough.any():
                self._close(cells[enough], best[enough])
            self._give_up(cells[stuck & ~enough], distance[stuck & ~enough])
        result = []
        halve = np.flatnonzero(~divide & ~stuck)
        if len(halve):
            result += _halved(cells[halve], ahead.dimension(table, table_rows, halve, reach))
        if divide.any():
            chosen, limit = cells[divide], 0.5 * larger[divide]
            rows, first = nodes.expanded(chosen.first, sizes[0, divide] >= limit)
            chosen = replace(chosen[rows], first=first)
            rows, second = nodes.expanded(chosen.second, sizes[1, divide][rows] >= limit[rows])
            result.append(replace(chosen[rows], second=second))
        return result


def _grained(directions: Array) -> Array:
    """Return rounded directions without negative zeros, the same on all machines."""
    return np.round(directions, _DECIMALS) + 0.0


def _halved(cells: ProofCells, variable: Indices) -> list[ProofCells]:
    """Split cells in two, each along one variable."""
    rows = np.arange(len(cells))
    middle = (cells.low[rows, variable] + cells.high[rows, variable]) / 2.0
    low, high = cells.low.copy(), cells.high.copy()
    low[rows, variable] = high[rows, variable] = middle
    return [replace(cells, high=high), replace(cells, low=low)]
