"""Pieces that turn about one axis are kept apart by heights and distances that turning does not change."""

from collections.abc import Sequence

import numpy as np

from artgen._arrays import Array, Indices
from artgen.proof.bounds import Motion, around_axis, axis_gap
from artgen.proof.hierarchy import Hierarchy
from artgen.proof.items import Items
from artgen.proof.kinematics import is_coaxial
from artgen.proof.paths import Way


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
                shift += along * motion.centre[chosen]
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
