"""Bars with right-angled bends, made so that few convex pieces carry them: straight runs and bends apart."""

import math
from collections.abc import Callable, Sequence

import artgen as ag

Way = tuple[int, int, int]
"""The direction of a straight run: an axis or its opposite."""

_EIGHTH = math.tan(math.pi / 8.0)


def rod(radius: ag.Scalar) -> Callable[[ag.Vector, ag.Vector], ag.Solid]:
    """Return the maker of round straight runs."""

    def run(start: ag.Vector, end: ag.Vector) -> ag.Solid:
        along = end - start
        return ag.cylinder(radius, along.norm(), axis=along).at((start + end) * 0.5)

    return run


def straight_run(section: ag.Profile) -> Callable[[ag.Vector, ag.Vector], ag.Solid]:
    """Return the maker of straight runs of a section."""
    return lambda start, end: ag.sweep(section, ag.line(start, end))


def bent_bar(
    section: ag.Profile,
    corners: Sequence[tuple[ag.Scalar, ag.Scalar, ag.Scalar]],
    ways: Sequence[Way],
    *,
    bend: ag.Scalar,
    halves: bool,
    run: Callable[[ag.Vector, ag.Vector], ag.Solid] | None = None,
) -> list[ag.Solid]:
    """Make a bar along axes: its straight runs, then its bends, each of which is nearly convex.

    The hull around a bend stands off its inner side by 0.3 of the radius there, or 0.08 if bends are halved.
    """
    straight = run or straight_run(section)
    points = [ag.vector(*corner) for corner in corners]
    runs: list[ag.Solid] = []
    bends: list[ag.Solid] = []
    for index, way in enumerate(ways):
        along = ag.vector(*way)
        first = points[index] if index == 0 else points[index] + along * bend
        last = points[index + 1] if index == len(ways) - 1 else points[index + 1] - along * bend
        runs.append(straight(first, last))
        if index + 1 < len(ways):
            after = ag.vector(*ways[index + 1])
            bends += _bend(section, points[index + 1], along, after, bend, halves=halves)
    return [*runs, *bends]


def _bend(
    section: ag.Profile,
    corner: ag.Vector,
    before: ag.Vector,
    after: ag.Vector,
    radius: ag.Scalar,
    *,
    halves: bool,
) -> list[ag.Solid]:
    start, end = corner - before * radius, corner + after * radius
    if not halves:
        return [ag.bounding_collider(ag.sweep(section, ag.polyline([start, corner, end], fillet=radius)))]
    short = radius * _EIGHTH
    near, far = start + before * short, end - after * short
    middle = (near + far) * 0.5
    return [
        ag.bounding_collider(ag.sweep(section, ag.polyline(points, fillet=radius)))
        for points in ([start, near, middle], [middle, far, end])
    ]
