"""Branch and bound over pairs of pieces and cells of joint space: planes that keep them apart, or a witness.

An item is two nodes (pieces, or boxes around several) and a cell of the joint space of their links. It is
closed by a plane, in one of the frames along the path, whose bound over the whole cell exceeds the threshold;
or, for joints about one axis, by heights and distances that turning does not change. What is open is split:
the larger box if it exceeds the motion in the cell, else the cell. Small cells of pieces that are too close
are given up, once their corners were tried. FCL proposes directions and says which pieces may overlap;
nothing that is proven rests on it. All pairs of links are searched side by side.
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
from artgen.proof.paths import Way
from artgen.proof.separation import GRAIN, Ahead, Coaxial, Confirm, Depths, Planes, Witnesses, depth_of, taken

MARGIN = 1e-8
"""By how much a bound must exceed its threshold; float64 errs by 1e-14 at a metre [m]."""

_DECIMALS = 9  # of normals
_MANY = 24  # vertices from which a node is searched apart from smaller ones
_FARTHEST = 3  # joints between the frame of a plane and either link, at most
_MOST_AT_REST = 48  # pairs of pieces whose distance at rest is measured


class Search:
    """A search over some pairs of links.

    Args:
        hierarchy: The pieces of the links.
        ways: The pairs of links.
        trees: For each way the numbers of its links' trees.
        depths: Depth to which two leaves may press into each other, by way, box and leaves; NaN if they may
            not touch; None where no contact is allowed at all.
        confirm: Looks closely at a pose in which pieces seem to overlap.
        tolerances: Clearance to prove of the pieces of each way, shape (ways,) [m].
        least: Clearance without which the solids may overlap; what is left to prove of a way whose
            tolerance is refuted, shape (ways,) [m].
        settings: What to measure, and when to give up.
    """

    def __init__(
        self,
        hierarchy: Hierarchy,
        ways: Sequence[Way],
        trees: Sequence[tuple[int, int]],
        confirm: Confirm,
        *,
        tolerances: Array,
        least: Array,
        depths: Depths | None = None,
        settings: Settings,
    ) -> None:
        self.nodes = hierarchy
        self.ways = ways
        self.trees = trees
        self.depths = depths
        self.tolerances = tolerances.copy()
        self.least = least
        self.settings = settings
        self.outcomes = [SearchOutcome() for _ in ways]
        self.leaves: list[Items] = []
        self._most = max((len(way.variables) for way in ways), default=0)
        self._contacts = np.array([any(way.allowed) for way in ways], bool)
        self._witnesses = Witnesses(ways, self.outcomes, confirm, depths)
        self._done = self._witnesses.done
        self._found = np.full(len(ways), np.inf)
        self._split_close = np.zeros(len(ways), np.int64)
        self._guaranteed = np.full(len(ways), np.inf)
        self._layouts: list[JointTable] = []
        self._layout = np.zeros(len(ways), np.int64)
        self._row = np.zeros(len(ways), np.int64)
        kinds: dict[tuple[JointKind, ...], list[int]] = {}
        for number, way in enumerate(ways):
            kinds.setdefault(tuple(joint.kind for joint in way.steps), []).append(number)
        for number, (of_kind, members) in enumerate(kinds.items()):
            self._layouts.append(JointTable.of(of_kind, [ways[member] for member in members]))
            self._layout[members] = number
            self._row[members] = np.arange(len(members))
        self._coaxial = Coaxial(hierarchy, ways)

    def run(self) -> list[SearchOutcome]:
        """Search until everything is closed, refuted or given up, and return the outcome of each way."""
        if not self.ways:
            return []
        items, seen = self._start(), 0
        if self.settings.measure:
            for number in range(len(self.ways)):
                self._measure_near_rest(number)
        while len(items):
            seen += len(items)
            if seen > self.settings.most_items:
                self._give_up(items, np.full(len(items), np.nan))
                break
            nodes = self.nodes
            big = 2 * (nodes.count[items.first] > _MANY) + (nodes.count[items.second] > _MANY)
            group = 4 * self._layout[items.way] + big
            parts: list[Items] = []
            for key in np.unique(group):
                parts += self._examine(items[group == key], self._layouts[key // 4])
            if not parts:
                break
            items = Items.join(parts)
            items = items[~self._done[items.way]]
        for number, outcome in enumerate(self.outcomes):
            outcome.guaranteed = float(self._guaranteed[number])
            outcome.found = float(self._found[number])
        return self.outcomes

    def _start(self) -> Items:
        """Make the first items: the whole of both links over each box."""
        cells = [(number, *cell) for number, way in enumerate(self.ways) for cell in starting_cells(way)]
        way, box = (np.array([cell[column] for cell in cells], np.int64) for column in (0, 1))
        corners = np.zeros((2, len(cells), self._most))
        for row, (_, _, (low, high)) in enumerate(cells):
            corners[0, row, : len(low)], corners[1, row, : len(high)] = low, high
        roots = self.nodes.roots[np.array(self.trees)]
        first, second = roots[way].T
        frame = np.full(len(cells), NONE, np.int64)
        normal = np.zeros((len(cells), 3))
        return Items(way, box, first, second, corners[0], corners[1], normal, frame)

    def _measure_near_rest(self, number: int) -> None:
        """Find the distance of a way's links near rest, so that less is left to measure."""
        way, nodes = self.ways[number], self.nodes
        box = min(
            range(len(way.boxes)), key=lambda index: float(np.abs(nearest_zero(way.boxes[index])).sum())
        )
        at = nearest_zero(way.boxes[box])
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
        threshold = self.tolerances[items.way]
        if settings.measure:
            wanted = settings.share * np.minimum(self._found[items.way], settings.cap)
            threshold = np.maximum(threshold, wanted)
        for row in np.flatnonzero(self._contacts[items.way]):
            depth = self._depth(items, int(row))
            if not np.isnan(depth):
                threshold[row] = -depth - 2.0 * MARGIN  # pieces that are to touch do so to rounding
        return threshold + MARGIN

    def _depth(self, items: Items, row: int) -> float:
        """Return how deep the pieces of an item may press into each other; NaN if they may not touch."""
        leaf = self.nodes.leaf
        if not (leaf[items.first[row]] and leaf[items.second[row]]):
            return float("nan")
        return depth_of(self.depths, items, row)

    def _examine(self, items: Items, layout: JointTable) -> list[Items]:
        """Close what can be closed of some items of one layout, and return what the others split into."""
        path = layout.path(self._row[items.way], items.low, items.high)
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
        """Try the plane from before the split, the direction between the middles and the main faces."""
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
        """Close pieces that turn about one axis by what turning does not change; return what stays open."""
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
        """Try the directions that FCL proposes in the middle of the cells."""
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
        """Ask FCL for the distance of each pair of nodes and the direction between their nearest points."""
        rotations, offsets = place.rotations[-1], place.offset
        distances, directions = np.full(len(rows), -1.0), np.zeros((len(rows), 3))
        leaf = self.nodes.leaf
        for index, row in enumerate(rows.tolist()):
            first, second = int(items.first[row]), int(items.second[row])
            distances[index], directions[index] = self.nodes.distance(
                first, second, rotations[row], offsets[row]
            )
            way = items.way[row]
            if leaf[first] and leaf[second] and 0.0 < distances[index] < self._found[way]:
                if self._contacts[way] and not np.isnan(self._depth(items, row)):
                    continue
                self._found[way] = distances[index]
                count = len(self.ways[way].variables)
                self.outcomes[way].found_at = ((items.low[row] + items.high[row]) / 2.0)[:count]
        return distances, directions

    def _record(self, items: Items, planes: Planes, threshold: Array, rows: Indices | None = None) -> None:
        """Close the items (of some rows) whose best plane exceeds its threshold."""
        chosen = np.arange(len(items)) if rows is None else rows
        chosen = chosen[planes.best[chosen] > threshold[chosen]]
        if len(chosen):
            done = replace(items[chosen], normal=planes.normal[chosen], frame=planes.frame[chosen])
            self._close(done, planes.best[chosen])

    def _close(self, items: Items, apart: Array) -> None:
        self.leaves.append(items)
        free = ~self._contacts[items.way]
        for row in np.flatnonzero(~free):
            free[row] = np.isnan(self._depth(items, int(row)))
        np.minimum.at(self._guaranteed, items.way[free], apart[free])

    def _are_pieces(self, items: Items) -> Mask:
        """Tell which items are pieces, not boxes around several."""
        return self.nodes.leaf[items.first] & self.nodes.leaf[items.second]

    def _judge(self, items: Items, distance: Array) -> Mask:
        """Look for witnesses among open pieces that seem to touch, and return what to go on with."""
        touching = self._are_pieces(items) & ~(distance > self.settings.pressed)
        self._witnesses.in_middles(items, np.flatnonzero(touching))
        return ~self._done[items.way]

    def _refute(self, items: Items, distance: Array, threshold: Array) -> bool:
        """Note which ways keep less than their tolerance, and go on in search of collisions only."""
        leaf = self._are_pieces(items)
        ways = items.way
        close = leaf & (threshold > 0.0) & (distance > 0.0) & (distance < self.tolerances[ways])
        refuted = np.flatnonzero(close & (self.tolerances[ways] > self.least[ways]))
        for row in refuted:
            way = int(ways[row])
            if self.tolerances[way] > self.least[way]:
                self._give_up(items[np.array([row])], distance[[row]])
                self.tolerances[way] = self.least[way]
        return bool(len(refuted))

    def _hopeless(self, items: Items, distance: Array, threshold: Array, motion: Array) -> Mask:
        """Tell which items to give up: pieces that hardly move, or that are too close in a small cell.

        A large cell may hide a collision: it is split further, as long as that leads to few cells.
        """
        leaf = self._are_pieces(items)
        still = leaf & (motion < self.settings.still)
        close = leaf & (distance < self.tolerances[items.way] + self.settings.close) & (threshold > 0.0)
        large = close & (motion > self.settings.small)
        np.add.at(self._split_close, items.way[large], 1)
        return still | (close & ~(large & (self._split_close[items.way] < self.settings.most_close)))

    def _give_up(self, items: Items, distance: Array) -> None:
        for row, way in enumerate(items.way.tolist()):
            count = len(self.ways[way].variables)
            low, high = items.low[row, :count], items.high[row, :count]
            nodes = int(items.first[row]), int(items.second[row])
            self.outcomes[way].open.append((low, high, *nodes, float(distance[row])))

    def _split(
        self, items: Items, distance: Array, threshold: Array, layout: JointTable, ahead: Ahead
    ) -> list[Items]:
        """Split the larger box of each item, or its cell."""
        nodes = self.nodes
        motion = layout.motion(
            self._row[items.way],
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
            result += _halved(items[halve], ahead.dimension(layout, self._row[items.way], halve, motion))
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
    """Split the cells of items in two along a variable each."""
    rows = np.arange(len(items))
    middle = (items.low[rows, variable] + items.high[rows, variable]) / 2.0
    low, high = items.low.copy(), items.high.copy()
    low[rows, variable] = high[rows, variable] = middle
    return [replace(items, high=high), replace(items, low=low)]


def _expanded(nodes: Hierarchy, chosen: Indices, wanted: Mask) -> tuple[Indices, Indices]:
    """Replace some of the nodes by those within; return the rows they come from and the nodes."""
    rows, within = nodes.expanded(chosen)
    first = np.ones(len(rows), bool)
    first[1:] = rows[1:] != rows[:-1]
    kept = wanted[rows] | first
    rows, within = rows[kept], within[kept]
    return rows, np.where(wanted[rows], within, chosen[rows])
