"""Open items of a search, and its findings."""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from artgen._arrays import Array, Indices, Mask
from artgen.proof.overlap import PRESSED

NONE = -1
"""Frame of an item that has no plane."""


@dataclass(frozen=True)
class Settings:
    """The limits of a search.

    Attributes:
        measure: Whether to bracket the clearance, up to `cap`, within `share`.
        cap: Clearances beyond this are not measured [m].
        share: The guaranteed clearance is at least this share of the one found.
        close: Pieces nearer than this, beyond the tolerance, in the middle of a cell are given up [m].
        still: A cell in which no point moves farther is given up [m].
        small: Cells in which pieces move farther are split all the same, in search of a collision [m].
        most_close: How many such cells are split for a pair.
        pressed: Depth from which pieces count as overlapping [m].
        most_items: Items after which what is left stays open.
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
    """Open items, one a row.

    Attributes:
        way: Number of the pair of links.
        box: Number of the box of its joint space.
        first: Node of link A.
        second: Node of link B.
        low: Lowest positions of the cell; columns beyond the pair's variables are 0 [rad or m].
        high: Highest positions [rad or m].
        normal: Plane that was best before the last split.
        frame: Its frame; -1 if there is none.
    """

    way: Indices
    box: Indices
    first: Indices
    second: Indices
    low: Array
    high: Array
    normal: Array
    frame: Indices

    def __len__(self) -> int:
        return len(self.way)

    def __getitem__(self, rows: Indices | Mask) -> "Items":
        return Items(*(column[rows] for column in vars(self).values()))

    @staticmethod
    def join(parts: "Sequence[Items]") -> "Items":
        """Return the items of all parts in order."""
        columns = zip(*(vars(part).values() for part in parts), strict=True)
        return Items(*(np.concatenate(column) for column in columns))


@dataclass(eq=False)
class SearchOutcome:
    """The result of a search for one pair of links.

    Attributes:
        guaranteed: Smallest bound of what was closed; infinite if nothing was [m].
        found: Smallest distance of two pieces that FCL found [m].
        found_at: Positions of the variables there, shape (v,) [rad or m].
        hit: Node of A, node of B and positions of the variables of a confirmed overlap.
        collider_hit: The same where only the pieces overlap, not the solids.
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
        """Whether everything was closed."""
        return self.hit is None and self.collider_hit is None and not self.open
