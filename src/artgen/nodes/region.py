"""Regions: boxes of planned space, from which parts take their sizes and places before any solid exists."""

from __future__ import annotations

import operator
from typing import Any, NamedTuple

from artgen.errors import BuildError
from artgen.graph.handle import lift
from artgen.graph.node import authors_line
from artgen.nodes.handles import Profile, Scalar, Solid, Span, Vector, VectorLike
from artgen.nodes.profile import rectangle

_SLACK = 1e-9  # by which lengths may exceed a region: rounding of their sum [m]


class Extent(NamedTuple):
    """The extent of a region along one axis."""

    low: Scalar  # lowest coordinate [m]
    high: Scalar  # highest coordinate [m]

    @property
    def size(self) -> Scalar:
        """Length [m]."""
        return self.high - self.low

    @property
    def mid(self) -> Scalar:
        """Coordinate of the middle [m]."""
        return (self.low + self.high) / 2

    def at(self, share: Scalar) -> Scalar:
        """Return the coordinate at a share of the length, 0 at `low` and 1 at `high` [m]."""
        return self.low + share * self.size

    def split(self, *lengths: Scalar | None, gap: Scalar = 0.0) -> list[Extent]:
        """Divide the extent from `low` on into lengths; one length may be None and takes the rest [m]."""
        given = [_number("a length of a region", each) for each in lengths if each is not None]
        if len(given) < len(lengths) - 1:
            raise BuildError(
                "one length of a region may be None and takes the rest, got "
                f"{len(lengths) - len(given)} None in {lengths}; give the others as numbers [m]\n"
                f"  at {authors_line()}"
            )
        rest = self.size - _number("gap", gap) * (len(lengths) - 1)
        for known in given:
            rest = rest - known
        if isinstance(rest, float | int) and rest < -_SLACK:  # a handle has no value yet
            raise BuildError(
                f"the lengths {lengths} with gaps of {gap:g} m are {-rest:.6g} m longer than the region, "
                f"{self.size:.6g} m; make them shorter\n  at {authors_line()}"
            )
        parts, start = [], self.low
        for length in lengths:
            end = start + (rest if length is None else length)
            parts.append(Extent(start, end))
            start = end + gap
        return parts

    def parts(self, count: int, gap: Scalar = 0.0) -> list[Extent]:
        """Divide the extent into equal parts with gaps between them [m]."""
        try:
            whole = operator.index(count)
        except TypeError:
            whole = 0
        if whole < 1:
            raise BuildError(
                f"a region is divided into a whole number of parts from 1 on, got {count!r}\n"
                f"  at {authors_line()}"
            )
        _number("gap", gap)
        length = (self.size - gap * (count - 1)) / count
        starts = [self.low + index * (length + gap) for index in range(count)]
        return [Extent(start, start + length) for start in starts]


def _extent(axis: str, span: Span) -> Extent:
    try:
        low, high = span
    except (TypeError, ValueError):
        raise BuildError(
            f"Region(..., {axis}=...) needs the lowest and the highest coordinate, got {span!r}\n"
            f"  at {authors_line()}"
        ) from None
    return Extent(_number(f"Region(..., {axis}=...)", low), _number(f"Region(..., {axis}=...)", high))


def _number(what: str, value: Any) -> Scalar:
    """Return a number or its handle as it is; BuildError for another value."""
    lift(value, float, what)
    return value  # type: ignore[no-any-return]


class Region:
    """A box of planned space: it has no surface and no mass, and it gives parts their sizes and places.

    The front of a region faces -Y, its right side X, its top Z. All methods return new regions.

    Args:
        x: Lowest and highest coordinate along X [m].
        y: Lowest and highest coordinate along Y [m].
        z: Lowest and highest coordinate along Z [m].

    Examples:
        >>> case = Region((-0.2, 0.2), (0, 0.3), (0, 0.5))
        >>> top, room, foot = case.shrink(left=0.02, right=0.02).stack(0.02, None, 0.08, gap=0.004)
        >>> drawers = [cell.shrink(0.002) for cell in room.grid(2, 3)]
        >>> posts = [corner.layers(2)[0].box() for corner in foot.across(0.02, None, 0.02)[::2]]
        >>> shelf = case.columns(3)[1].rows(4)[3].deep(0.01, None)[1].grow(top=0.01).at(z=0.1)
        >>> lid = extrude(top.front(radius=0.005), 0.3, axis=Y).at(y=0.15) | shelf.mirror().box(bevel=0.002)
        >>> feet = extrude(foot.plan(radius=0.02), 0.02).at(z=0.03)
        >>> hole = room.shrink(0.1).with_(y=room.y)
        >>> frame = union(*(board.box() for board in room.around(hole, lap=0.0005))).at(y=0.31)
        >>> ball = sphere(0.03).at(room.anchor(y=-1))
        >>> union(lid, feet, frame, ball, *posts, *(each.box(bevel=0.004) for each in drawers))
    """

    __slots__ = ("x", "y", "z")

    def __init__(self, x: Span, y: Span, z: Span) -> None:
        self.x, self.y, self.z = _extent("x", x), _extent("y", y), _extent("z", z)

    @classmethod
    def centered(cls, x: Scalar, y: Scalar, z: Scalar) -> Region:
        """Return the region of three lengths about the origin [m]."""
        return cls((-x / 2, x / 2), (-y / 2, y / 2), (-z / 2, z / 2))

    @classmethod
    def between(cls, low: VectorLike, high: VectorLike) -> Region:
        """Return the region between its lowest and its highest corner [m]."""
        pairs = zip(_components(low), _components(high), strict=True)
        return cls(*pairs)

    def __repr__(self) -> str:
        return f"Region({tuple(self.x)}, {tuple(self.y)}, {tuple(self.z)})"

    @property
    def size(self) -> tuple[Scalar, Scalar, Scalar]:
        """Lengths along X, Y and Z [m]."""
        return (self.x.size, self.y.size, self.z.size)

    @property
    def center(self) -> tuple[Scalar, Scalar, Scalar]:
        """The middle [m]."""
        return (self.x.mid, self.y.mid, self.z.mid)

    def anchor(self, *, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> tuple[Scalar, Scalar, Scalar]:
        """Return the point at (x, y, z), each from -1 (low) to 1 (high); the front is y=-1 [m]."""
        ends: list[Scalar] = []
        for extent, share in zip((self.x, self.y, self.z), (x, y, z), strict=True):
            if not -1.0 <= _number("a share of anchor", share) <= 1.0:
                raise BuildError(
                    f"anchor(x={x}, y={y}, z={z}) is not in the region: each share is from -1 (low) "
                    f"to 1 (high); .at(...) moves a region [m]\n  at {authors_line()}"
                )
            exact = {-1.0: extent.low, 1.0: extent.high}
            ends.append(exact[share] if share in exact else extent.mid + share / 2 * extent.size)
        return (ends[0], ends[1], ends[2])

    def with_(self, *, x: Span | None = None, y: Span | None = None, z: Span | None = None) -> Region:
        """Replace the extent along some axes."""
        return Region(self.x if x is None else x, self.y if y is None else y, self.z if z is None else z)

    def at(self, x: Scalar = 0.0, y: Scalar = 0.0, z: Scalar = 0.0) -> Region:
        """Move by x, y and z [m]."""
        pairs = zip((self.x, self.y, self.z), (x, y, z), strict=True)
        moved = ((extent, _number("at(...) of a region", by)) for extent, by in pairs)
        return Region(*((extent.low + by, extent.high + by) for extent, by in moved))

    def mirror(self) -> Region:
        """Reflect in the plane x = 0."""
        return self.with_(x=(-self.x.high, -self.x.low))

    def shrink(
        self,
        all: Scalar = 0.0,
        *,
        x: Scalar | None = None,
        y: Scalar | None = None,
        z: Scalar | None = None,
        left: Scalar | None = None,
        right: Scalar | None = None,
        front: Scalar | None = None,
        back: Scalar | None = None,
        bottom: Scalar | None = None,
        top: Scalar | None = None,
    ) -> Region:
        """Move sides inward [m].

        Args:
            all: Distance of all sides without their own distance.
            x: Distance of the left and the right side; y and z likewise.
            y: Distance of the front and the back.
            z: Distance of the bottom and the top.
            left: Distance of one side, which replaces that of its axis; the others likewise.
            right: Distance of the side at high x.
            front: Distance of the side at low y.
            back: Distance of the side at high y.
            bottom: Distance of the side at low z.
            top: Distance of the side at high z.
        """

        def shorter(extent: Extent, both: Scalar | None, low: Scalar | None, high: Scalar | None) -> Extent:
            each = all if both is None else both
            ends = (each if low is None else low, each if high is None else high)
            for distance in ends:
                _number("a distance of shrink", distance)
            return Extent(extent.low + ends[0], extent.high - ends[1])

        return Region(
            shorter(self.x, x, left, right), shorter(self.y, y, front, back), shorter(self.z, z, bottom, top)
        )

    def grow(self, all: Scalar = 0.0, **sides: Scalar) -> Region:
        """Move sides outward; the arguments are those of `shrink` [m]."""
        inward = {name: -_number(f"grow(..., {name}=...)", by) for name, by in {"all": all, **sides}.items()}
        return self.shrink(**inward)

    def columns(self, count: int, gap: Scalar = 0.0) -> list[Region]:
        """Divide into equal columns from left to right."""
        return [self.with_(x=part) for part in self.x.parts(count, gap)]

    def layers(self, count: int, gap: Scalar = 0.0) -> list[Region]:
        """Divide into equal layers from the front to the back."""
        return [self.with_(y=part) for part in self.y.parts(count, gap)]

    def rows(self, count: int, gap: Scalar = 0.0) -> list[Region]:
        """Divide into equal rows from the bottom to the top."""
        return [self.with_(z=part) for part in self.z.parts(count, gap)]

    def grid(self, columns: int, rows: int, gap: Scalar = 0.0) -> list[Region]:
        """Divide into equal cells in reading order: from the top left, row by row."""
        return [cell for row in reversed(self.rows(rows, gap)) for cell in row.columns(columns, gap)]

    def across(self, *widths: Scalar | None, gap: Scalar = 0.0) -> list[Region]:
        """Divide from left to right into widths; one of them may be None and takes the rest [m]."""
        return [self.with_(x=part) for part in self.x.split(*widths, gap=gap)]

    def deep(self, *depths: Scalar | None, gap: Scalar = 0.0) -> list[Region]:
        """Divide from the front to the back into depths; one of them may be None and takes the rest [m]."""
        return [self.with_(y=part) for part in self.y.split(*depths, gap=gap)]

    def stack(self, *heights: Scalar | None, gap: Scalar = 0.0) -> list[Region]:
        """Divide from the top to the bottom into heights; one of them may be None and takes the rest [m]."""
        return [self.with_(z=part) for part in reversed(self.z.split(*reversed(heights), gap=gap))]

    def around(self, hole: Region, *, lap: Scalar = 0.0) -> list[Region]:
        """Return the regions at the left, at the right, below and above a hole through the front.

        Args:
            hole: Region of the hole; its extent along Y is ignored.
            lap: Length by which the regions below and above reach into those at the sides, and by which they
                are thinner and lower, so that no two faces coincide [m].
        """
        if not isinstance(hole, Region):
            raise BuildError(f"around(...) needs the Region of a hole, got {hole!r}\n  at {authors_line()}")
        between = self.shrink(y=lap, z=lap).with_(x=(hole.x.low - lap, hole.x.high + lap))
        return [
            self.with_(x=(self.x.low, hole.x.low)),
            self.with_(x=(hole.x.high, self.x.high)),
            between.with_(z=(between.z.low, hole.z.low)),
            between.with_(z=(hole.z.high, between.z.high)),
        ]

    def box(self, *, bevel: Scalar = 0.0) -> Solid:
        """Make the solid box of the region, with rounded edges of radius `bevel` [m]."""
        low, high = zip(self.x, self.y, self.z, strict=True)
        return Solid.record("box_between", low=low, high=high, bevel=bevel)

    def front(self, *, radius: Scalar = 0.0) -> Profile:
        """Return the outline from the front, in place: x to the right, z up; `radius` of corners [m]."""
        return rectangle(self.x.size, self.z.size, radius=radius).at(self.x.mid, self.z.mid)

    def plan(self, *, radius: Scalar = 0.0) -> Profile:
        """Return the outline from above, in place: x to the right, y up; `radius` of corners [m]."""
        return rectangle(self.x.size, self.y.size, radius=radius).at(self.x.mid, self.y.mid)


def _components(point: VectorLike) -> tuple[Scalar, Scalar, Scalar]:
    return (point.x, point.y, point.z) if isinstance(point, Vector) else (point[0], point[1], point[2])
