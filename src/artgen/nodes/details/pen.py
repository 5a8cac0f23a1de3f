"""Pen for signs: strokes with round ends, filled shapes and cuts, on a square of 20 units."""

import math
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Literal

import numpy as np

from artgen._arrays import Array, FrozenArrays
from artgen.nodes.contours import arc_points

Kind = Literal["stroke", "fill", "cut", "gap"]

SQUARE = 20.0
"""Side of the square about the origin for signs."""

_CHORD = 0.03  # tolerance of samples of a curve, in units
_TURN = math.radians(26.0)  # largest turn between samples and in round ends
_TOKEN = re.compile(r"([MLHVCQAZ])|(-?\d*\.?\d+)")
_TAKES = {"M": 2, "L": 2, "H": 1, "V": 1, "C": 6, "Q": 4, "A": 3}


@dataclass(frozen=True, eq=False)
class Mark(FrozenArrays):
    """One touch of the pen."""

    # a `stroke` along the line or a `fill` of its interior; a `cut` removes a fill from earlier marks, a
    # `gap` removes a stroke
    kind: Kind
    points: Array  # the line, shape (n, 2), in units
    closed: bool = False  # whether it returns to its first point
    weight: float = 1.0  # width of the stroke, in widths of the pen


def steps_of(radius: float, sweep: float) -> int:
    """Return the number of chords of an arc with a radius [units] and a sweep [rad]."""
    step = 2.0 * math.acos(max(0.0, 1.0 - _CHORD / radius)) if radius > _CHORD else _TURN
    return max(1, math.ceil(abs(sweep) / min(step, _TURN) - 1e-9))


def _curve(controls: Array) -> Array:
    """Return samples of a Bezier curve without its start; control points of shape (3, 2) or (4, 2)."""
    legs = np.diff(controls, axis=0)
    legs = legs[np.linalg.norm(legs, axis=1) > 1e-9]
    angle = np.unwrap(np.arctan2(legs[:, 1], legs[:, 0]))
    turn = float(np.abs(np.diff(angle)).sum())
    length = float(np.linalg.norm(legs, axis=1).sum())
    steps = max(2, steps_of(length / max(turn, 0.3), turn))
    t = (np.arange(1, steps + 1) / steps)[:, None]
    level = [np.broadcast_to(point, (steps, 2)) for point in controls]
    while len(level) > 1:
        level = [(1.0 - t) * a + t * b for a, b in pairwise(level)]
    return level[0]


def _bulge(start: Array, end: Array, radius: float) -> Array:
    """Return samples of the shorter arc between points without its start; a negative radius is clockwise."""
    half = 0.5 * (end - start)
    reach = float(np.linalg.norm(half))
    size = max(abs(radius), reach)
    across = np.array([-half[1], half[0]]) / reach * math.copysign(1.0, radius)
    center = start + half + across * math.sqrt(max(size**2 - reach**2, 0.0))
    first = start - center
    sweep = math.copysign(2.0 * math.asin(min(1.0, reach / size)), radius)
    begin = math.atan2(first[1], first[0])
    points, _ = arc_points(center, size, begin, sweep, steps_of(size, sweep))
    points[-1] = end
    return points[1:]


def _lines(path: str) -> list[tuple[Array, bool]]:
    """Return the lines of a path and whether each is closed.

    The path has the syntax of SVG, with absolute units: `M` moves, `L`, `H` and `V` draw straight lines, `C`
    and `Q` Bezier curves, `A radius x y` an arc (counter-clockwise for a positive radius), `Z` closes.
    """
    tokens = [letter or float(number) for letter, number in _TOKEN.findall(path)]
    lines: list[tuple[Array, bool]] = []
    points: list[Array] = []
    at, verb = 0, "M"

    def end(*, closed: bool = False) -> None:
        if len(points) > 1:
            lines.append((_distinct(np.array(points), closed=closed), closed))
        points.clear()

    while at < len(tokens):
        if isinstance(tokens[at], str):
            verb = str(tokens[at])
            at += 1
        if verb == "Z":
            end(closed=True)
            continue
        values = [float(value) for value in tokens[at : at + _TAKES[verb]]]
        at += _TAKES[verb]
        if verb == "M":
            end()
            points.append(np.array(values))
            verb = "L"
            continue
        points.extend(_drawn(verb, points[-1], values))
    end()
    return lines


def _drawn(verb: str, here: Array, values: Sequence[float]) -> Iterable[Array]:
    if verb == "L":
        return [np.array(values)]
    if verb == "H":
        return [np.array([values[0], here[1]])]
    if verb == "V":
        return [np.array([here[0], values[0]])]
    if verb == "A":
        return _bulge(here, np.array(values[1:]), values[0])
    return _curve(np.array([*here, *values]).reshape(-1, 2))


def _distinct(points: Array, *, closed: bool) -> Array:
    kept = np.linalg.norm(np.diff(points, axis=0, prepend=points[:1] - 1.0), axis=1) > 1e-6
    if closed and np.linalg.norm(points[-1] - points[0]) < 1e-6:
        kept[-1] = False
    distinct: Array = points[kept]
    return distinct


def stroke(path: str, weight: float = 1.0) -> tuple[Mark, ...]:
    """Draw along a path."""
    return tuple(Mark("stroke", points, closed, weight) for points, closed in _lines(path))


def gap(path: str, weight: float = 1.0) -> tuple[Mark, ...]:
    """Erase along a path."""
    return tuple(Mark("gap", points, closed, weight) for points, closed in _lines(path))


def fill(path: str) -> tuple[Mark, ...]:
    """Fill the area inside a path."""
    return tuple(Mark("fill", points, closed=True) for points, _ in _lines(path))


def cut(path: str) -> tuple[Mark, ...]:
    """Cut out the area inside a path."""
    return tuple(Mark("cut", points, closed=True) for points, _ in _lines(path))


def arc(x: float, y: float, radius: float, start: float, sweep: float) -> tuple[Mark, ...]:
    """Draw an arc about (x, y) from `start` counter-clockwise by `sweep` [degrees]."""
    angle = math.radians(sweep)
    points, _ = arc_points(np.array([x, y]), radius, math.radians(start), angle, steps_of(radius, angle))
    return (Mark("stroke", points),)


def circle(x: float, y: float, radius: float, kind: Kind = "stroke", weight: float = 1.0) -> tuple[Mark, ...]:
    """Draw, fill or cut a circle about (x, y)."""
    sides = 4 * math.ceil(steps_of(radius, math.tau) / 4)
    points, _ = arc_points(np.array([x, y]), radius, 0.0, math.tau, sides)
    return (Mark(kind, points[:-1], closed=True, weight=weight),)


def disc(x: float, y: float, radius: float) -> tuple[Mark, ...]:
    """Fill a circle about (x, y)."""
    return circle(x, y, radius, "fill")


def turned(count: int, *groups: tuple[Mark, ...], start: float = 0.0) -> tuple[Mark, ...]:
    """Repeat marks around the origin, starting at `start` [degrees]."""
    made = []
    for index in range(count):
        angle = math.radians(start) + math.tau * index / count
        matrix = np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])
        made += [replace(mark, points=mark.points @ matrix.T) for group in groups for mark in group]
    return tuple(made)


def placed(scale: float, x: float, y: float, *groups: tuple[Mark, ...]) -> tuple[Mark, ...]:
    """Scale and move marks; strokes keep their width."""
    shift = np.array([x, y])
    return tuple(replace(mark, points=mark.points * scale + shift) for group in groups for mark in group)


def mirrored(*groups: tuple[Mark, ...]) -> tuple[Mark, ...]:
    """Add the mirror image of marks, left to right."""
    marks = tuple(mark for group in groups for mark in group)
    flip = np.array([-1.0, 1.0])
    return marks + tuple(replace(mark, points=mark.points * flip) for mark in marks)


def flipped(*groups: tuple[Mark, ...]) -> tuple[Mark, ...]:
    """Reflect marks, top to bottom."""
    flip = np.array([1.0, -1.0])
    return tuple(replace(mark, points=mark.points * flip) for group in groups for mark in group)
