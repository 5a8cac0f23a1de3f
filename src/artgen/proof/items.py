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
    """Limits of a search.

    Attributes:
        measure: Whether to bracket the clearance, up to `cap`, within `share`.
        cap: Clearances beyond this are not measured [m].
        share: The guaranteed clearance is at least this share of the one found.
        close: Pieces nearer than this, beyond the tolerance, at the center of a cell are given up [m].
        still: Cells in which no point moves farther than this are given up [m].
        small: Larger cells are split even for close pieces, to find collisions [m].
        most_close: Largest number of such cells to split for a pair.
        pressed: Depth above which pieces count as overlapping [m].
        most_items: Number of items after which the rest stays open.
    """

    measure: bool = False
    cap: float = 0.010
    share: float = 0.8
    close: float = 5e-5
    still: float = 2e-5
    small: float = 1e-3
    most_close: int = 2000
    pressed: float = PRESSED
    most_items: int = 300_000


@dataclass(eq=False)
class Items:
    """Open items, one per row.

    Attributes:
        joint_path: Number of the joint path.
        box: Number of the box in its joint space.
        first: Node of link A.
        second: Node of link B.
        low: Lowest positions of the cell; 0 in columns beyond the variables of the joint path [rad or m].
        high: Highest positions [rad or m].
        normal: Normal of the best plane before the last split.
        frame: Frame of that plane; -1 if there is none.
    """

    joint_path: Indices
    box: Indices
    first: Indices
    second: Indices
    low: Array
    high: Array
    normal: Array
    frame: Indices

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
    """Result of the search for one pair of links.

    Attributes:
        guaranteed: Smallest bound of the closed items; infinite without closed items [m].
        found: Smallest distance of two pieces from FCL [m].
        found_at: Positions of the variables at that distance, shape (v,) [rad or m].
        hit: Node of A, node of B and positions of the variables of a confirmed overlap.
        collider_hit: The same for an overlap of pieces only, not of the solids.
        open: Low and high corner, nodes and distance of each item that was given up.
    """

    guaranteed: float = np.inf
    found: float = np.inf
    found_at: Array = field(default_factory=lambda: np.zeros(0))
    hit: tuple[int, int, Array] | None = None
    collider_hit: tuple[int, int, Array] | None = None
    open: list[tuple[Array, Array, int, int, float]] = field(default_factory=list)

    @property
    def proven(self) -> bool:
        """Whether all items were closed."""
        return self.hit is None and self.collider_hit is None and not self.open
