"""Values of 2-D profiles and 3-D paths: points with the normals or tangents that their maker knew."""

from dataclasses import dataclass

from artgen._arrays import Array
from artgen._caching import FrozenArrays


@dataclass(frozen=True, eq=False)
class Contour(FrozenArrays):
    """A closed polygon with the normals of the curve that it samples.

    Attributes:
        points: Vertices, counter-clockwise for outer borders and clockwise for holes, shape (n, 2) [m].
        normals_in: Outward unit normal at the end of the side that arrives at each vertex, shape (n, 2).
        normals_out: Outward unit normal at the start of the side that leaves each vertex, shape (n, 2).
            Equal to `normals_in` where the curve is smooth, different at corners.
    """

    points: Array
    normals_in: Array
    normals_out: Array


@dataclass(frozen=True, eq=False)
class Outline(FrozenArrays):
    """A region of the plane: the value of a `Profile`.

    Attributes:
        contours: Outer borders and holes.
        convex: Convex polygons (counter-clockwise, each shape (k, 2)) whose union is the region, where
            the maker knows them; None leaves the decomposition to whoever needs it.
    """

    contours: tuple[Contour, ...]
    convex: tuple[Array, ...] | None = None


@dataclass(frozen=True, eq=False)
class Curve(FrozenArrays):
    """A line in space: the value of a `Path`.

    Attributes:
        points: Samples along the line, shape (n, 3) [m].
        closed: Whether the last point joins the first (which is not repeated).
        tangents: Unit tangents at the samples where the maker knows them, shape (n, 3), else None.
    """

    points: Array
    closed: bool = False
    tangents: Array | None = None
