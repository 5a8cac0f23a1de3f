"""Paths: lines in space that sweeps follow."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from artgen import _portable
from artgen._arrays import Array, Indices, predecessors, successors
from artgen.asset.shape import Curve
from artgen.graph import FULL, detail_level, records
from artgen.nodes import validators as check
from artgen.nodes.handles import Array3, Path, Scalar, VectorLike
from artgen.nodes.surfaces import arc_steps

_MOST_SAMPLES = 200


def _unit_rows(vectors: Array) -> Array:
    return np.asarray(vectors / np.maximum(np.linalg.norm(vectors, axis=1, keepdims=True), 1e-300))


def _line(start: Array3, end: Array3) -> Curve:
    points = np.stack([check.vector("start", start), check.vector("end", end)])
    along = points[1] - points[0]
    length = _portable.norm(along)
    if length < 1e-9:
        raise ValueError("a line needs two different points; its start and end are the same point")
    return Curve(points, tangents=np.stack([along / length] * 2))


@records(_line)
def line(start: VectorLike, end: VectorLike) -> Path:
    """Make a straight path between two points [m].

    Examples:
        >>> line((0, 0, 0), (0.3, 0, 0.1))
    """


def _polyline(points: tuple[Array3, ...], fillet: float, closed: bool) -> Curve:
    corners = check.points("the polyline", points or np.zeros((0, 3)), 3, 3 if closed else 2)
    fillet = check.rounding("fillet", fillet, math.inf)
    following = successors(corners)
    length = np.linalg.norm(following - corners, axis=1)
    sides = len(corners) if closed else len(corners) - 1
    if length[:sides].min() < 1e-9:
        at = int(np.argmin(length[:sides]))
        raise ValueError(f"points {at} and {(at + 1) % len(corners)} of the polyline are the same point")
    if fillet == 0.0:
        return Curve(corners, closed)
    return _filleted(corners, _unit_rows(following - corners), length, fillet, closed)


def _filleted(corners: Array, along: Array, length: Array, fillet: float, closed: bool) -> Curve:
    count = len(corners)
    bends = range(count) if closed else range(1, count - 1)
    turn, reach = np.zeros(count), np.zeros(count)
    for i in bends:
        turn[i] = math.acos(min(max(_portable.dot(along[i - 1], along[i]), -1.0), 1.0))
        if turn[i] > math.radians(175.0):
            raise ValueError(f"the polyline turns back on itself at point {i}; no fillet fits there")
        reach[i] = fillet * math.tan(turn[i] / 2.0)
    for i in range(count if closed else count - 1):
        needed = float(reach[i] + reach[(i + 1) % count])
        if needed > length[i] + 1e-9:
            raise ValueError(
                f"the fillets at points {i} and {(i + 1) % count} of the polyline need {needed:.4g} m "
                f"of a segment {length[i]:.4g} m long; use a smaller fillet than {fillet:g} m"
            )
    points, tangents = [], []
    for i in range(count):
        before, after = along[i - 1], along[i]
        if turn[i] < 1e-6:
            end = not closed and i == count - 1
            points.append(corners[i : i + 1])
            tangents.append((before if end else after)[None])
            continue
        inward = after - before * math.cos(turn[i])
        inward /= _portable.norm(inward)
        steps = max(2, arc_steps(fillet, turn[i]))
        angle = turn[i] * np.arange(steps + 1)[:, None] / steps
        center = corners[i] - before * reach[i] + inward * fillet
        points.append(center + fillet * (before * _portable.sin(angle) - inward * _portable.cos(angle)))
        tangents.append(before * _portable.cos(angle) + inward * _portable.sin(angle))
    return _without_repeats(np.concatenate(points), np.concatenate(tangents), closed)


def _without_repeats(points: Array, tangents: Array, closed: bool) -> Curve:
    gap = np.linalg.norm(points - predecessors(points), axis=1)
    if not closed:
        gap[0] = math.inf
    kept = gap > 1e-7
    return Curve(points[kept], closed, tangents[kept])


@records(_polyline)
def polyline(points: Sequence[VectorLike], *, fillet: Scalar = 0.0, closed: bool = False) -> Path:
    """Make a path of straight segments.

    Args:
        points: Corners [m].
        fillet: Radius of the arcs that replace the corners [m]; 0 leaves them sharp.
        closed: Whether the last point joins the first.

    Examples:
        >>> polyline([(0, 0, 0), (0.2, 0, 0), (0.2, 0, 0.15), (0.35, 0, 0.15)], fillet=0.03)
    """


def _arc(center: Array3, radius: float, start: float, sweep: float, axis: Array3) -> Curve:
    check.positive("radius", radius)
    check.finite("start", start, "rad")
    if not 1e-3 <= abs(sweep) <= math.tau + 1e-9:
        raise ValueError(f"sweep must be within 0.001 and 2 pi either way, got {sweep:g} rad")
    turn = check.frame(axis)
    closed = abs(sweep) >= math.tau - 1e-9
    steps = max(2, arc_steps(radius, sweep))
    angle = start + sweep * np.arange(steps if closed else steps + 1) / steps
    zero = np.zeros(len(angle))
    points = (
        check.vector("center", center)
        + radius * np.column_stack([_portable.cos(angle), _portable.sin(angle), zero]) @ turn.T
    )
    sign = math.copysign(1.0, sweep)
    return Curve(
        points, closed, sign * np.column_stack([-_portable.sin(angle), _portable.cos(angle), zero]) @ turn.T
    )


@records(_arc)
def arc(
    center: VectorLike,
    radius: Scalar,
    *,
    start: Scalar = 0.0,
    sweep: Scalar = math.pi,
    axis: VectorLike = (0.0, 0.0, 1.0),
) -> Path:
    """Make an arc of a circle; a sweep of 2 pi closes it.

    Angles are right-handed about `axis`; 0 is along X (along Y for an axis along X).

    Args:
        center: Center of the circle [m].
        radius: Radius of the circle [m].
        start: Angle of the first point [rad].
        sweep: Angle from the first to the last point; negative reverses the direction [rad].
        axis: Axis of the rotation.

    Examples:
        >>> arc((0, 0, 0), 0.1, start=0.0, sweep=4.0, axis=-Y)
    """


def _cubics(controls: Array, *, closed: bool) -> tuple[Array, Array]:
    """Return samples and tangents of cubic Bezier segments that follow each other, shape (k, 4, 3)."""
    steps = _steps_of(controls)
    counts = steps + (0 if closed else np.arange(len(steps)) == len(steps) - 1)  # the last has an end
    segment = np.repeat(np.arange(len(steps)), counts)
    t = ((np.arange(len(segment)) - (np.cumsum(counts) - counts)[segment]) / steps[segment])[:, None]
    s = 1.0 - t
    first, second, third, last = controls[segment].transpose(1, 0, 2)
    points = s * s * s * first + 3 * s * s * t * second + 3 * s * t * t * third + t * t * t * last
    speed = s * s * (second - first) + 2.0 * s * t * (third - second) + t * t * (last - third)
    still = np.linalg.norm(speed, axis=1, keepdims=True) < 1e-12
    return points, _unit_rows(np.where(still, last - first, speed))


def _steps_of(controls: Array) -> Indices:
    """Return the number of chords of Bezier curves, shape (..., n, 3): second differences bound the error."""
    second = controls[..., 2:, :] - 2.0 * controls[..., 1:-1, :] + controls[..., :-2, :]
    bend = np.linalg.norm(second, axis=-1).max(axis=-1)
    degree = controls.shape[-2] - 1
    level = detail_level()
    needed = np.sqrt(degree * (degree - 1) * bend / (8.0 * level.chord))
    return np.asarray(np.clip(np.ceil(needed), 4 if level is FULL else 1, _MOST_SAMPLES), np.int64)


def _bezier(points: tuple[Array3, ...]) -> Curve:
    controls = check.points("the curve", points or np.zeros((0, 3)), 3, 3)
    steps = int(_steps_of(controls))
    t = (np.arange(steps + 1) / steps)[:, None]

    def value(level: Array) -> Array:
        # De Casteljau for all samples at once
        layers = np.repeat(level[:, None, :], len(t), axis=1)
        while len(layers) > 1:
            layers = (1.0 - t) * layers[:-1] + t * layers[1:]
        return np.asarray(layers[0])

    tangents = value(np.diff(controls, axis=0))
    if np.linalg.norm(tangents, axis=1).min() < 1e-12:
        raise ValueError("the curve has no direction at one of its points; move its control points apart")
    return Curve(value(controls), False, _unit_rows(tangents))


@records(_bezier)
def bezier(points: Sequence[VectorLike]) -> Path:
    """Make a Bezier curve from its first to its last control point [m].

    Examples:
        >>> bezier([(0, 0, 0), (0.1, 0, 0.3), (0.3, 0, -0.1), (0.4, 0, 0.15)])
    """


def _spline(points: tuple[Array3, ...], closed: bool) -> Curve:
    through = check.points("the spline", points or np.zeros((0, 3)), 3, 3 if closed else 2)
    gap = np.linalg.norm(successors(through) - through, axis=1)
    count = len(through)
    segments = count if closed else count - 1
    if gap[:segments].min() < 1e-9:
        at = int(np.argmin(gap[:segments]))
        raise ValueError(f"points {at} and {(at + 1) % count} of the spline are the same point")
    slopes = _centripetal_slopes(through, closed)
    reach = gap[:segments, None] / 3.0
    start, end = through[:segments], successors(through)[:segments]
    leave, arrive = slopes[:segments], successors(slopes)[:segments]
    controls = np.stack((start, start + leave * reach, end - arrive * reach, end), axis=1)
    samples, tangents = _cubics(controls, closed=closed)
    return Curve(samples, closed, tangents)


def _centripetal_slopes(through: Array, closed: bool) -> Array:
    """Return a unit tangent at each point: that of the parabola through the point and its neighbors."""
    before = through - predecessors(through)
    after = successors(before)
    near = np.linalg.norm(before, axis=1, keepdims=True)
    far = np.linalg.norm(after, axis=1, keepdims=True)
    slopes = before / near**2 + after / far**2
    if not closed:
        if len(through) == 2:
            slopes[0] = slopes[1] = after[0]
        else:
            slopes[0] = 2.0 * after[0] / far[0] - _unit_rows(slopes[1:2])[0]
            slopes[-1] = 2.0 * before[-1] / near[-1] - _unit_rows(slopes[-2:-1])[0]
    stuck = np.linalg.norm(slopes, axis=1, keepdims=True) < 1e-9
    return _unit_rows(np.where(stuck, after, slopes))


@records(_spline)
def spline(points: Sequence[VectorLike], *, closed: bool = False) -> Path:
    """Make a smooth curve through points [m].

    Args:
        points: Points of the curve.
        closed: Whether it returns to the first point.

    Examples:
        >>> spline([(0, 0, 0), (0.1, 0, 0.1), (0.2, 0, 0), (0.3, 0, 0.15)])
    """


def _helix(radius: float, pitch: float, turns: float, axis: Array3) -> Curve:
    check.positive("radius", radius)
    check.positive("pitch", pitch)
    check.between("turns", turns, 0.01, 100.0, "")
    turn = check.frame(axis)
    steps = max(4, math.ceil(turns * arc_steps(radius, math.tau)))
    angle = math.tau * turns * np.arange(steps + 1) / steps
    rise = pitch * angle / math.tau
    points = np.column_stack(
        [radius * _portable.cos(angle), radius * _portable.sin(angle), rise - 0.5 * pitch * turns]
    )
    slope = np.full(len(angle), pitch / math.tau)
    tangents = np.column_stack([-radius * _portable.sin(angle), radius * _portable.cos(angle), slope])
    return Curve(points @ turn.T, False, _unit_rows(tangents) @ turn.T)


@records(_helix)
def helix(radius: Scalar, pitch: Scalar, turns: Scalar, *, axis: VectorLike = (0.0, 0.0, 1.0)) -> Path:
    """Make a right-handed helix centered on the origin.

    Args:
        radius: Radius of the cylinder [m].
        pitch: Advance per turn [m].
        turns: Number of turns.
        axis: Direction of its axis.

    Examples:
        >>> helix(0.05, 0.03, 5)
    """
