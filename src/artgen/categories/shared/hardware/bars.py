"""Bars with right-angled bends, made so that few convex pieces carry them: straight runs and bends apart."""

import math
from collections.abc import Callable, Sequence

from artgen import Profile, Scalar, Solid, Vector, bounding_collider, cylinder, line, polyline, sweep, vector

Way = tuple[int, int, int]
"""The direction of a straight run: an axis or its opposite."""

_EIGHTH = math.tan(math.pi / 8.0)


def rod(radius: Scalar) -> Callable[[Vector, Vector], Solid]:
    """Return the maker of round straight runs."""

    def run(start: Vector, end: Vector) -> Solid:
        along = end - start
        return cylinder(radius, along.norm(), axis=along).at((start + end) * 0.5)

    return run


def straight_run(section: Profile) -> Callable[[Vector, Vector], Solid]:
    """Return the maker of straight runs of a section."""
    return lambda start, end: sweep(section, line(start, end))


def bent_bar(
    section: Profile,
    corners: Sequence[tuple[Scalar, Scalar, Scalar]],
    ways: Sequence[Way],
    *,
    bend: Scalar,
    halves: bool,
    run: Callable[[Vector, Vector], Solid] | None = None,
) -> list[Solid]:
    """Make a bar along axes: its straight runs, then its bends, each of which is nearly convex.

    The hull around a bend stands off its inner side by 0.3 of the radius there, or 0.08 if bends are halved.
    """
    straight = run or straight_run(section)
    points = [vector(*corner) for corner in corners]
    runs: list[Solid] = []
    bends: list[Solid] = []
    for index, way in enumerate(ways):
        along = vector(*way)
        first = points[index] if index == 0 else points[index] + along * bend
        last = points[index + 1] if index == len(ways) - 1 else points[index + 1] - along * bend
        runs.append(straight(first, last))
        if index + 1 < len(ways):
            after = vector(*ways[index + 1])
            bends += _bend(section, points[index + 1], along, after, bend, halves=halves)
    return [*runs, *bends]


def _bend(
    section: Profile, corner: Vector, before: Vector, after: Vector, radius: Scalar, *, halves: bool
) -> list[Solid]:
    start, end = corner - before * radius, corner + after * radius
    if not halves:
        return [bounding_collider(sweep(section, polyline([start, corner, end], fillet=radius)))]
    short = radius * _EIGHTH
    near, far = start + before * short, end - after * short
    middle = (near + far) * 0.5
    return [
        bounding_collider(sweep(section, polyline(points, fillet=radius)))
        for points in ([start, near, middle], [middle, far, end])
    ]
