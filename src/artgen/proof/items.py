"""Open items of a search, and the result of a search."""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from artgen._arrays import Array, Indices, Mask
from artgen.proof.overlap import PRESSED

NONE = -1
"""Frame of an item without a plane."""


@dataclass(frozen=True)
class Settings:
    """Limits of a search."""

    measure: bool = False  # whether to bracket the clearance, up to `cap`, within `share`
    cap: float = 0.010  # clearances beyond this are not measured [m]
    share: float = 0.8  # the guaranteed clearance is at least this share of the one found
    # pieces nearer than this, beyond the tolerance, at the center of a cell are given up [m]
    close: float = 5e-5
    still: float = 2e-5  # cells in which no point moves farther than this are given up [m]
    small: float = 1e-3  # larger cells are split even for close pieces, to find collisions [m]
    most_close: int = 2000  # largest number of such cells to split for a pair
    pressed: float = PRESSED  # depth above which pieces count as overlapping [m]
    most_items: int = 300_000  # number of items after which the rest stays open


@dataclass(eq=False)
class Items:
    """Open items, one per row."""

    joint_path: Indices  # number of the joint path
    box: Indices  # number of the box in its joint space
    first: Indices  # node of link A
    second: Indices  # node of link B
    low: Array  # lowest positions of the cell; 0 in columns beyond the variables of the joint path [rad or m]
    high: Array  # highest positions [rad or m]
    normal: Array  # normal of the best plane before the last split
    frame: Indices  # frame of that plane; -1 if there is none

    def __len__(self) -> int:
        return len(self.joint_path)

    def __getitem__(self, rows: Indices | Mask) -> "Items":
        return Items(*(column[rows] for column in vars(self).values()))

    @staticmethod
    def join(parts: "Sequence[Items]") -> "Items":
        """Return the items of all parts in order."""
        columns = zip(*(vars(part).values() for part in parts), strict=True)
        return Items(*(np.concatenate(column) for column in columns))


@dataclass(eq=False)
class SearchOutcome:
    """Result of the search for one pair of links."""

    guaranteed: float = np.inf  # smallest bound of the closed items; infinite without closed items [m]
    found: float = np.inf  # smallest distance of two pieces from FCL [m]
    # positions of the variables at that distance, shape (v,) [rad or m]
    found_at: Array = field(default_factory=lambda: np.zeros(0))
    # node of A, node of B and positions of the variables of a confirmed overlap
    hit: tuple[int, int, Array] | None = None
    # the same for an overlap of pieces only, not of the solids
    collider_hit: tuple[int, int, Array] | None = None
    # low and high corner, nodes and distance of each item that was given up
    open: list[tuple[Array, Array, int, int, float]] = field(default_factory=list)

    @property
    def proven(self) -> bool:
        """Whether all items were closed."""
        return self.hit is None and self.collider_hit is None and not self.open
