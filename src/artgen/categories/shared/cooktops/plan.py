"""Layout of a cooktop: the field of the burners, the strip of the dials, and the dial of each burner.

View from above: x to the right, y to the back, the origin in the middle of the plate.
"""

from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen._arrays import cached_property

BurnerKind = Literal["gas", "radiant", "coil", "induction"]
"""Gas flames, radiant heaters under glass, steel tubes, or induction coils under glass."""

DialSide = Literal["front", "left", "right", "back"]
"""Border of the plate with the dials."""

BurnerSize = Literal["small", "medium", "large", "wok"]
"""Sizes of burners; in shops: simmer, standard, rapid, wok."""

EDGE = 0.013
"""Distance from the edge of the plate to the print around a dial [m]."""

PRINT = 0.009
"""Width of the print around a dial [m]."""

SIGN = 0.014
"""Size of the sign beside a dial that shows its burner [m]."""

_MARGIN = 0.016  # distance from the edge of the plate to the field of the burners [m]
_END = 0.030  # distance from the edge of the plate to the rim of the first dial of a row [m]

# Number of burners in each column, from left to right, by the numbers of burners and of rows.
COLUMNS: dict[tuple[int, int], tuple[int, ...]] = {
    (2, 1): (1, 1),
    (3, 1): (1, 1, 1),
    (3, 2): (2, 1),
    (4, 1): (1, 1, 1, 1),
    (4, 2): (2, 2),
    (5, 2): (2, 1, 2),
    (6, 2): (2, 2, 2),
}

# Sizes of the burners in the same order, from the front to the back of a column.
_SIZES: dict[tuple[int, int], tuple[BurnerSize, ...]] = {
    (2, 1): ("large", "medium"),
    (3, 1): ("medium", "wok", "small"),
    (3, 2): ("small", "medium", "wok"),
    (4, 1): ("medium", "large", "medium", "small"),
    (4, 2): ("large", "medium", "small", "medium"),
    (5, 2): ("medium", "large", "wok", "small", "medium"),
    (6, 2): ("large", "medium", "small", "medium", "medium", "large"),
}


@dataclass(frozen=True)
class Place:
    """Position and size of a burner."""

    x: ag.Scalar  # position of the middle along x [m]
    y: ag.Scalar  # position of the middle along y [m]
    size: BurnerSize  # size of the burner
    reach: ag.Scalar  # half the width of the square reserved for the burner [m]


@dataclass(frozen=True)
class Column:
    """A column of burners, from front to back."""

    x: ag.Scalar  # middle of the column [m]
    width: ag.Scalar  # width of the column [m]
    depth: ag.Scalar  # depth of the column [m]
    burners: tuple[Place, ...]  # burners, from the front to the back


@dataclass(frozen=True)
class Plan:
    """The plan of a cooktop."""

    burners: int  # number of burners
    rows: int  # number of rows
    dials: int  # number of dials, first those of the burners
    side: DialSide  # border of the plate with the dials
    width: ag.Scalar  # width of the plate [m]
    depth: ag.Scalar  # depth of the plate [m]
    radius: ag.Scalar  # radius of the dials [m]
    pitch: ag.Scalar  # distance between dials, if there is space for it [m]
    mirrored: bool  # whether the large burners are on the right

    @cached_property
    def strip(self) -> ag.Scalar:
        """Width of the strip with the dials and their print [m]."""
        return EDGE + 2.0 * (self.radius + PRINT) + SIGN + 0.003

    @cached_property
    def field(self) -> tuple[ag.Scalar, ag.Scalar, ag.Scalar, ag.Scalar]:
        """Positions of the left, right, front and back of the field of the burners [m]."""
        x, y = self.width / 2 - _MARGIN, self.depth / 2 - _MARGIN
        inner = self.strip - _MARGIN
        return (
            -x + (inner if self.side == "left" else 0.0),
            x - (inner if self.side == "right" else 0.0),
            -y + (inner if self.side == "front" else 0.0),
            y - (inner if self.side == "back" else 0.0),
        )

    @cached_property
    def columns(self) -> list[Column]:
        """Columns of burners, from left to right."""
        left, right, front, back = self.field
        counts = COLUMNS[self.burners, self.rows]
        sizes = iter(_SIZES[self.burners, self.rows])
        # a wok's column is wider than its neighbors
        shares = [1.12 if number == 1 and max(counts) > 1 else 1.0 for number in counts]
        found: list[Column] = []
        start, deep = 0.0, back - front
        for number, share in zip(counts, shares, strict=True):
            width = (right - left) * (share / sum(shares))
            x = left + (right - left) * ((start + share / 2.0) / sum(shares))
            start += share
            x, way = (-x + left + right, -1) if self.mirrored else (x, 1)
            tall = deep / number
            burners = tuple(
                Place(x, front + tall * (row + 0.5), next(sizes), 0.5 * ag.min_(width, tall))
                for row in range(number)
            )
            found.insert(0 if way < 0 else len(found), Column(x, width, deep, burners))
        return found

    @cached_property
    def places(self) -> list[Place]:
        """Positions of the burners, column by column from left to right, each from front to back."""
        return [place for column in self.columns for place in column.burners]

    @cached_property
    def spaced(self) -> ag.Float:
        """Distance between dials [m]."""
        span = (self.width if self.side in ("front", "back") else self.depth) - 2.0 * (self.radius + _END)
        return ag.min_(self.pitch, span / max(self.dials - 1, 1))

    @cached_property
    def dial_places(self) -> list[tuple[ag.Scalar, ag.Scalar]]:
        """Positions of the dials, from left to right or from front to back [m]."""
        across = self.side in ("front", "back")
        inset = EDGE + PRINT + self.radius
        level = (self.depth if across else self.width) / 2 - inset
        level = -level if self.side in ("front", "left") else level
        row = [(number - (self.dials - 1) / 2.0) * self.spaced for number in range(self.dials)]
        return [(along, level) if across else (level, along) for along in row]

    @cached_property
    def sign_step(self) -> tuple[ag.Scalar, ag.Scalar]:
        """Offset from a dial to the sign of its burner [m]."""
        away = self.radius + PRINT + SIGN / 2.0
        ways: dict[DialSide, tuple[ag.Scalar, ag.Scalar]] = {
            "front": (0.0, away),
            "back": (0.0, -away),
            "left": (away, 0.0),
            "right": (-away, 0.0),
        }
        return ways[self.side]
