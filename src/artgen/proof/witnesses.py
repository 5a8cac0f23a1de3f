"""Poses at which pieces seem to overlap, looked at closely until one is a witness of a collision."""

import itertools
from collections.abc import Callable, Sequence

import numpy as np

from artgen._arrays import Array, Indices
from artgen.proof.items import Items, Outcome
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
        self, ways: Sequence[Way], outcomes: Sequence[Outcome], confirm: Confirm, depths: Depths | None
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
