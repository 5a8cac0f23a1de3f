"""Branch and bound over pairs of pieces and cells of joint space: separating planes, or a witness.

An item is two nodes (pieces, or boxes around several pieces) and a cell of the joint space of their links. A
plane in one of the frames along the path closes it if its bound over the whole cell exceeds the threshold.
For joints about one axis, heights and distances from the axis close it as well. Open items are split: the
larger box if it exceeds the motion in the cell, else the cell. Small cells of pieces that are too close are
given up after their corners were tried. FCL proposes directions and candidates for overlaps; no proof relies
on it. All pairs of links are searched in one batch.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from artgen._arrays import Array, Indices, Mask
from artgen.asset.certificate import AXIS_FRAME
from artgen.asset.joint import JointKind
from artgen.proof.bounds import Motion
from artgen.proof.hierarchy import Hierarchy
from artgen.proof.items import NONE, Items, SearchOutcome, Settings
from artgen.proof.kinematics import Frames, JointTable, frames, nearest_zero, starting_cells
from artgen.proof.paths import JointPath
from artgen.proof.separation import GRAIN, Ahead, Coaxial, Confirm, Depths, Planes, Witnesses, depth_of, taken

MARGIN = 1e-8
"""Margin of a bound over its threshold; float64 has errors of 1e-14 at one metre [m]."""

_DECIMALS = 9  # decimals of normals
_MANY = 24  # vertices above which a node is searched separately from smaller nodes
_FARTHEST = 3  # most joints between the frame of a plane and either link
_MOST_AT_REST = 48  # most pairs of pieces whose distance at rest is measured


class Search:
    """Search for several pairs of links.

    Args:
        hierarchy: The pieces of the links.
        joint_paths: Joint paths of the pairs of links.
        trees: For each joint path the numbers of the trees of its links.
        depths: Allowed penetration of two pieces, by joint path, box and pieces; NaN if they may not touch;
            None if no contact is allowed.
        confirm: Examines a pose in which pieces seem to overlap.
        tolerances: Required clearance of the pieces of each joint path, shape (paths,) [m].
        least: Clearance below which the solids may overlap; the requirement that remains after the tolerance
            of a joint path is refuted, shape (paths,) [m].
        settings: Limits of the search.
    """

    def __init__(
        self,
        hierarchy: Hierarchy,
        joint_paths: Sequence[JointPath],
        trees: Sequence[tuple[int, int]],
        confirm: Confirm,
        *,
        tolerances: Array,
        least: Array,
        depths: Depths | None = None,
        settings: Settings,
    ) -> None:
        self.nodes = hierarchy
        self.joint_paths = joint_paths
        self.trees = trees
        self.depths = depths
        self.tolerances = tolerances.copy()
        self.least = least
        self.settings = settings
        self.outcomes = [SearchOutcome() for _ in joint_paths]
        self.leaves: list[Items] = []
        self._most = max((len(joint_path.variables) for joint_path in joint_paths), default=0)
        self._contacts = np.array([any(joint_path.allowed) for joint_path in joint_paths], bool)
        self._witnesses = Witnesses(joint_paths, self.outcomes, confirm, depths)
        self._done = self._witnesses.done
        self._found = np.full(len(joint_paths), np.inf)
        self._split_close = np.zeros(len(joint_paths), np.int64)
        self._guaranteed = np.full(len(joint_paths), np.inf)
        self._layouts: list[JointTable] = []
        self._layout = np.zeros(len(joint_paths), np.int64)
        self._row = np.zeros(len(joint_paths), np.int64)
        kinds: dict[tuple[JointKind, ...], list[int]] = {}
        for number, joint_path in enumerate(joint_paths):
            kinds.setdefault(tuple(joint.kind for joint in joint_path.steps), []).append(number)
        for number, (of_kind, members) in enumerate(kinds.items()):
            self._layouts.append(JointTable.of(of_kind, [joint_paths[member] for member in members]))
            self._layout[members] = number
            self._row[members] = np.arange(len(members))
        self._coaxial = Coaxial(hierarchy, joint_paths)

    def run(self) -> list[SearchOutcome]:
        """Search until all items are closed, refuted or given up; return the outcome of each joint path."""
        if not self.joint_paths:
            return []
        items, seen = self._start(), 0
        if self.settings.measure:
            for number in range(len(self.joint_paths)):
                self._measure_near_rest(number)
        while len(items):
            seen += len(items)
            if seen > self.settings.most_items:
                self._give_up(items, np.full(len(items), np.nan))
                break
            nodes = self.nodes
            big = 2 * (nodes.count[items.first] > _MANY) + (nodes.count[items.second] > _MANY)
            group = 4 * self._layout[items.joint_path] + big
            parts: list[Items] = []
            for key in np.unique(group):
                parts += self._examine(items[group == key], self._layouts[key // 4])
            if not parts:
                break
            items = Items.join(parts)
            items = items[~self._done[items.joint_path]]
        for number, outcome in enumerate(self.outcomes):
            outcome.guaranteed = float(self._guaranteed[number])
            outcome.found = float(self._found[number])
        return self.outcomes

    def _start(self) -> Items:
        """Return the first items: both whole links in each box."""
        cells = [
            (number, *cell)
            for number, joint_path in enumerate(self.joint_paths)
            for cell in starting_cells(joint_path)
        ]
        joint_path, box = (np.array([cell[column] for cell in cells], np.int64) for column in (0, 1))
        corners = np.zeros((2, len(cells), self._most))
        for row, (_, _, (low, high)) in enumerate(cells):
            corners[0, row, : len(low)], corners[1, row, : len(high)] = low, high
        roots = self.nodes.roots[np.array(self.trees)]
        first, second = roots[joint_path].T
        frame = np.full(len(cells), NONE, np.int64)
        normal = np.zeros((len(cells), 3))
        return Items(joint_path, box, first, second, corners[0], corners[1], normal, frame)

    def _measure_near_rest(self, number: int) -> None:
        """Measure the distance of links near rest, which leaves less to measure later."""
        joint_path, nodes = self.joint_paths[number], self.nodes
        box = min(
            range(len(joint_path.boxes)),
            key=lambda index: float(np.abs(nearest_zero(joint_path.boxes[index])).sum()),
        )
        at = nearest_zero(joint_path.boxes[box])
        corner = np.zeros((1, self._most))
        corner[0, : len(at)] = at
        layout = self._layouts[self._layout[number]]
        place = frames(layout.path(self._row[[number]], corner, corner))
        first, second = (np.flatnonzero(nodes.leaf & (nodes.tree == tree)) for tree in self.trees[number])
        rotation, offset = place.rotations[-1][0], place.offset[0]
        half_a, half_b = nodes.half[first], nodes.half[second] @ np.abs(rotation).T
        between = np.abs(nodes.center[first][:, None] - (nodes.center[second] @ rotation.T + offset)[None])
        apart = np.maximum(between - half_a[:, None] - half_b[None], 0.0)
        order = np.sqrt(np.sum(apart * apart, axis=2))
        for flat in np.argsort(order, axis=None, kind="stable")[:_MOST_AT_REST]:
            a, b = divmod(int(flat), len(second))
            if order[a, b] >= min(self._found[number], self.settings.cap):
                break
            if self.depths is None or np.isnan(self.depths(number, box, int(first[a]), int(second[b]))):
                distance, _ = self.nodes.distance(int(first[a]), int(second[b]), rotation, offset)
                if 0.0 < distance < self._found[number]:
                    self._found[number], self.outcomes[number].found_at = distance, at

    def _threshold(self, items: Items) -> Array:
        """Return the gap that closes each item [m]."""
        settings = self.settings
        threshold = self.tolerances[items.joint_path]
        if settings.measure:
            wanted = settings.share * np.minimum(self._found[items.joint_path], settings.cap)
            threshold = np.maximum(threshold, wanted)
        for row in np.flatnonzero(self._contacts[items.joint_path]):
            depth = self._depth(items, int(row))
            if not np.isnan(depth):
                threshold[row] = -depth - 2.0 * MARGIN  # contact is exact to rounding only
        return threshold + MARGIN

    def _depth(self, items: Items, row: int) -> float:
        """Return the allowed penetration of the pieces of an item; NaN if they may not touch."""
        leaf = self.nodes.leaf
        if not (leaf[items.first[row]] and leaf[items.second[row]]):
            return float("nan")
        return depth_of(self.depths, items, row)

    def _examine(self, items: Items, layout: JointTable) -> list[Items]:
        """Close items of one layout if possible, and return the items into which the others are split."""
        path = layout.path(self._row[items.joint_path], items.low, items.high)
        threshold = self._threshold(items)
        planes = Planes(self.nodes.points(items.first), self.nodes.points(items.second), path)
        place = frames(path)
        self._try_known(planes, items, place)
        self._record(items, planes, threshold)
        rows = self._try_axis(items, np.flatnonzero(planes.best <= threshold), path, threshold)
        if not len(rows):
            return []
        distance, towards, frame = self._try_distance(planes, items, place, rows, threshold)
        self._record(items, planes, threshold, rows)
        still = planes.best[rows] <= threshold[rows]
        rows, distance = rows[still], distance[still]
        opened = replace(items[rows], normal=planes.normal[rows], frame=planes.frame[rows])
        if self._refute(opened, distance, threshold[rows]):
            threshold = self._threshold(items)
        kept = self._judge(opened, distance)
        if not kept.any():
            return []
        opened, rows, distance = opened[kept], rows[kept], distance[kept]
        path = [taken(motion, rows) for motion in path]
        ahead = Ahead(planes.first[rows], planes.second[rows], path, towards[still][kept], frame[still][kept])
        return self._split(opened, distance, threshold[rows], layout, ahead)

    def _try_known(self, planes: Planes, items: Items, place: Frames) -> None:
        """Try the plane from before the split, the direction between the centers and the main faces."""
        nodes, last = self.nodes, len(planes.path)
        for frame in range(1, last):
            rows = np.flatnonzero(items.frame == frame)
            planes.attempt(rows, items.normal[rows][:, None, :], frame)
        middle = place.moved(nodes.center[items.second]) - nodes.center[items.first]
        length = np.sqrt(np.sum(middle * middle, axis=1, keepdims=True))
        middle /= np.where(length > 0.0, length, 1.0)
        rows = np.arange(len(items))
        for frame, of_link in ((0, items.first), (last, items.second)):
            towards = place.seen(middle, frame)
            axes = nodes.main_axes(of_link)
            side = np.sign(np.round(np.matmul(axes, towards[:, :, None]), _DECIMALS))
            axes = axes * np.where(side == 0.0, 1.0, side)
            before = np.where((items.frame == frame)[:, None], items.normal, axes[:, 0])
            candidates = [before[:, None], axes]
            if max(frame, last - frame) <= _FARTHEST:
                candidates.append(np.round(towards, _DECIMALS)[:, None])
            planes.attempt(rows, np.concatenate(candidates, axis=1), frame)

    def _try_axis(self, items: Items, rows: Indices, path: list[Motion], threshold: Array) -> Indices:
        """Close pieces on one axis by heights and distances from it; return the items that stay open."""
        about, apart = self._coaxial.apart(items, rows[threshold[rows] > 0.0], path)
        closed = apart > threshold[about]
        if closed.any():
            done = items[about[closed]]
            done.frame[:] = AXIS_FRAME
            self._close(done, apart[closed])
        return rows[~np.isin(rows, about[closed])]

    def _try_distance(
        self, planes: Planes, items: Items, place: Frames, rows: Indices, threshold: Array
    ) -> tuple[Array, Array, Indices]:
        """Try the directions that FCL proposes at the center of the cells."""
        distance, direction = self._distances(items, place, rows)
        separated = np.any(direction != 0.0, axis=1)
        best = np.full(len(rows), -np.inf)
        towards, of_frame = np.zeros((len(rows), 3)), np.full(len(rows), NONE, np.int64)
        last = len(planes.path)
        for frame in range(last + 1):
            if max(frame, last - frame) > _FARTHEST and last <= 2 * _FARTHEST:
                continue
            chosen = np.flatnonzero(separated & (planes.best[rows] <= threshold[rows]))
            if not len(chosen):
                break
            normal = np.round(place.seen(direction[chosen], frame, rows[chosen]), _DECIMALS)
            reached = planes.attempt(rows[chosen], normal[:, None, :], frame)
            better = np.round(reached * GRAIN) > np.round(best[chosen] * GRAIN)
            chosen, normal = chosen[better], normal[better]
            best[chosen], towards[chosen], of_frame[chosen] = reached[better], normal, frame
        return distance, towards, of_frame

    def _distances(self, items: Items, place: Frames, rows: Indices) -> tuple[Array, Array]:
        """Return FCL's distance of each pair of nodes and the direction between their nearest points."""
        rotations, offsets = place.rotations[-1], place.offset
        distances, directions = np.full(len(rows), -1.0), np.zeros((len(rows), 3))
        leaf = self.nodes.leaf
        for index, row in enumerate(rows.tolist()):
            first, second = int(items.first[row]), int(items.second[row])
            distances[index], directions[index] = self.nodes.distance(
                first, second, rotations[row], offsets[row]
            )
            joint_path = items.joint_path[row]
            if leaf[first] and leaf[second] and 0.0 < distances[index] < self._found[joint_path]:
                if self._contacts[joint_path] and not np.isnan(self._depth(items, row)):
                    continue
                self._found[joint_path] = distances[index]
                count = len(self.joint_paths[joint_path].variables)
                self.outcomes[joint_path].found_at = ((items.low[row] + items.high[row]) / 2.0)[:count]
        return distances, directions

    def _record(self, items: Items, planes: Planes, threshold: Array, rows: Indices | None = None) -> None:
        """Close the items (in given rows) whose best plane exceeds the threshold."""
        chosen = np.arange(len(items)) if rows is None else rows
        chosen = chosen[planes.best[chosen] > threshold[chosen]]
        if len(chosen):
            done = replace(items[chosen], normal=planes.normal[chosen], frame=planes.frame[chosen])
            self._close(done, planes.best[chosen])

    def _close(self, items: Items, apart: Array) -> None:
        self.leaves.append(items)
        free = ~self._contacts[items.joint_path]
        for row in np.flatnonzero(~free):
            free[row] = np.isnan(self._depth(items, int(row)))
        np.minimum.at(self._guaranteed, items.joint_path[free], apart[free])

    def _are_pieces(self, items: Items) -> Mask:
        """Tell which items are pairs of pieces, not boxes around several pieces."""
        return self.nodes.leaf[items.first] & self.nodes.leaf[items.second]

    def _judge(self, items: Items, distance: Array) -> Mask:
        """Look for witnesses among open pieces that seem to touch, and return the remaining items."""
        touching = self._are_pieces(items) & ~(distance > self.settings.pressed)
        self._witnesses.in_middles(items, np.flatnonzero(touching))
        return ~self._done[items.joint_path]

    def _refute(self, items: Items, distance: Array, threshold: Array) -> bool:
        """Mark joint paths with less clearance than their tolerance; search them for collisions only."""
        leaf = self._are_pieces(items)
        joint_paths = items.joint_path
        close = leaf & (threshold > 0.0) & (distance > 0.0) & (distance < self.tolerances[joint_paths])
        refuted = np.flatnonzero(close & (self.tolerances[joint_paths] > self.least[joint_paths]))
        for row in refuted:
            joint_path = int(joint_paths[row])
            if self.tolerances[joint_path] > self.least[joint_path]:
                self._give_up(items[np.array([row])], distance[[row]])
                self.tolerances[joint_path] = self.least[joint_path]
        return bool(len(refuted))

    def _hopeless(self, items: Items, distance: Array, threshold: Array, motion: Array) -> Mask:
        """Tell which items to give up: pieces that hardly move, or that are too close in a small cell.

        A large cell may hide a collision: it is split further as long as the number of cells stays small.
        """
        leaf = self._are_pieces(items)
        still = leaf & (motion < self.settings.still)
        close = (
            leaf & (distance < self.tolerances[items.joint_path] + self.settings.close) & (threshold > 0.0)
        )
        large = close & (motion > self.settings.small)
        np.add.at(self._split_close, items.joint_path[large], 1)
        return still | (close & ~(large & (self._split_close[items.joint_path] < self.settings.most_close)))

    def _give_up(self, items: Items, distance: Array) -> None:
        for row, joint_path in enumerate(items.joint_path.tolist()):
            count = len(self.joint_paths[joint_path].variables)
            low, high = items.low[row, :count], items.high[row, :count]
            nodes = int(items.first[row]), int(items.second[row])
            self.outcomes[joint_path].open.append((low, high, *nodes, float(distance[row])))

    def _split(
        self, items: Items, distance: Array, threshold: Array, layout: JointTable, ahead: Ahead
    ) -> list[Items]:
        """Split the larger box of each item, or its cell."""
        nodes = self.nodes
        motion = layout.motion(
            self._row[items.joint_path],
            items,
            (nodes.center[items.first], nodes.radius[items.first]),
            (nodes.center[items.second], nodes.radius[items.second]),
        )
        total = motion.sum(axis=1)
        sizes = np.stack(
            [np.where(nodes.leaf[of], 0.0, nodes.radius[of]) for of in (items.first, items.second)]
        )
        larger = sizes.max(axis=0)
        divide = (larger > 0.0) & ((larger > 0.25 * total) | (total < self.settings.still))
        stuck = self._hopeless(items, distance, threshold, total)
        if stuck.any():
            self._witnesses.in_corners(items, np.flatnonzero(stuck & self._are_pieces(items)))
            self._give_up(items[stuck], distance[stuck])
        result = []
        halve = np.flatnonzero(~divide & ~stuck)
        if len(halve):
            result += _halved(
                items[halve], ahead.dimension(layout, self._row[items.joint_path], halve, motion)
            )
        if divide.any():
            chosen, limit = items[divide], 0.5 * larger[divide]
            rows, first = np.arange(len(chosen)), chosen.first
            apart = sizes[0, divide] >= limit
            rows, first = _expanded(nodes, chosen.first, apart)
            chosen = replace(chosen[rows], first=first)
            rows, second = _expanded(nodes, chosen.second, sizes[1, divide][rows] >= limit[rows])
            result.append(replace(chosen[rows], second=second))
        return result


def _halved(items: Items, variable: Indices) -> list[Items]:
    """Split the cells of items in two, each along one variable."""
    rows = np.arange(len(items))
    middle = (items.low[rows, variable] + items.high[rows, variable]) / 2.0
    low, high = items.low.copy(), items.high.copy()
    low[rows, variable] = high[rows, variable] = middle
    return [replace(items, high=high), replace(items, low=low)]


def _expanded(nodes: Hierarchy, chosen: Indices, wanted: Mask) -> tuple[Indices, Indices]:
    """Replace nodes by their children; return the rows of the parents and the nodes."""
    rows, within = nodes.expanded(chosen)
    first = np.ones(len(rows), bool)
    first[1:] = rows[1:] != rows[:-1]
    kept = wanted[rows] | first
    rows, within = rows[kept], within[kept]
    return rows, np.where(wanted[rows], within, chosen[rows])
