"""Icons for buttons, knobs and lamps; reader of `drawings.svg`, which has the icons, emblems and gaskets.

It has paths with absolute coordinates, circles, arcs as circles with one dash, groups and copies.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import Literal, NamedTuple
from xml.etree.ElementTree import Element, parse

import numpy as np
from manifold3d import CrossSection, FillRule

from artgen import _portable
from artgen._arrays import Array, cached, predecessors
from artgen.asset.shape import Outline
from artgen.errors import BuildError, nearest
from artgen.graph import kernel
from artgen.graph.node import authors_line
from artgen.nodes import validators as inputs
from artgen.nodes.contours import arc_points, moved_outline, outline_of, side_normals, signed_area
from artgen.nodes.handles import Profile, Scalar

Weight = Literal["light", "regular", "bold"]
"""Line weight of an icon."""

_WIDTHS: dict[str, float] = {"light": 1.1, "regular": 1.5, "bold": 1.9}  # in units of the square
_SQUARE = 20.0  # side of the square about the origin for drawings
_CHORD = 0.03  # tolerance of samples of a curve, in units
_TURN = math.radians(26.0)  # largest turn between samples and in round ends
_SHARP = math.radians(32.0)  # larger turns of a line are corners
_TOKEN = re.compile(r"([MLHVCQAZ])|(-?\d*\.?\d+)")
_COUNTS = {"M": 2, "L": 2, "H": 1, "V": 1, "C": 6, "Q": 4, "A": 7}  # numbers after each command of a path


class _Mark(NamedTuple):
    """A line that is drawn, filled or erased."""

    kind: str  # a `stroke` along the line or a `fill` inside it; a `cut` removes a fill, a `gap` a stroke
    points: Array  # shape (n, 2), in units
    closed: bool  # whether it returns to its first point
    weight: float  # width of the stroke, relative to the line weight of the drawing


@cache
def _elements() -> dict[str, Element]:
    """Return the elements of the file by their id."""
    root = parse(Path(__file__).with_name("drawings.svg")).getroot()  # noqa: S314 - a file of this package
    for element in root.iter():
        element.tag = element.tag.rpartition("}")[2]
    return {element.attrib["id"]: element for element in root.iter() if "id" in element.attrib}


ICONS: tuple[str, ...] = tuple(
    sorted(name.removeprefix("icon-") for name in _elements() if name.startswith("icon-"))
)
"""The names of all icons."""


def _marks(element: Element, matrix: Array) -> list[_Mark]:
    """Return the marks of an element, moved by a matrix of shape (3, 3)."""
    matrix = matrix @ _transform(element.get("transform", ""))
    if element.tag == "use":
        return _marks(_elements()[element.attrib["href"].removeprefix("#")], matrix)
    if element.tag == "g":
        return [mark for child in element for mark in _marks(child, matrix)]
    kind, weight = element.get("class", "stroke"), float(element.get("stroke-width", "1"))
    lines = [_circle(element)] if element.tag == "circle" else _lines(element.attrib["d"])
    turn, shift = matrix[:2, :2].T, matrix[:2, 2]
    return [
        _Mark(kind, points @ turn + shift, closed or kind in ("fill", "cut"), weight)
        for points, closed in lines
    ]


def _transform(text: str) -> Array:
    """Return the matrix of a transform such as `translate(0 1) rotate(30)`, shape (3, 3)."""
    matrix = np.eye(3)
    for name, numbers in re.findall(r"(\w+)\(([^)]*)\)", text):
        step, values = np.eye(3), [float(number) for number in numbers.split()]
        if name == "translate":
            step[:2, 2] = values
        elif name == "scale":
            step[[0, 1], [0, 1]] = values
        else:  # a rotation, optionally about a point
            angle, about = math.radians(values[0]), np.array(values[1:] or (0.0, 0.0))
            cosine, sine = math.cos(angle), math.sin(angle)
            step[:2, :2] = [[cosine, -sine], [sine, cosine]]
            step[:2, 2] = about - step[:2, :2] @ about
        matrix = matrix @ step
    return matrix


def _circle(element: Element) -> tuple[Array, bool]:
    """Return a circle, or the arc of its dash, and whether it is closed."""
    center = np.array([float(element.get("cx", "0")), float(element.get("cy", "0"))])
    radius = float(element.attrib["r"])
    if "stroke-dasharray" in element.attrib:  # first its length [degrees]
        sweep = math.radians(float(element.attrib["stroke-dasharray"].split()[0]))
        return arc_points(center, radius, 0.0, sweep, _steps(radius, sweep))[0], False
    sides = 4 * math.ceil(_steps(radius, math.tau) / 4)
    return arc_points(center, radius, 0.0, math.tau, sides)[0][:-1], True


def _lines(path: str) -> list[tuple[Array, bool]]:
    """Return the lines of a path and whether each is closed."""
    tokens = [letter or float(number) for letter, number in _TOKEN.findall(path)]
    lines: list[tuple[Array, bool]] = []
    points: list[Array] = []
    at, command = 0, "M"

    def end(*, closed: bool = False) -> None:
        if len(points) > 1:
            lines.append((_distinct(np.array(points), closed=closed), closed))
        points.clear()

    while at < len(tokens):
        if isinstance(tokens[at], str):
            command = str(tokens[at])
            at += 1
        if command == "Z":
            end(closed=True)
            continue
        values = [float(value) for value in tokens[at : at + _COUNTS[command]]]
        at += _COUNTS[command]
        if command == "M":
            end()
            points.append(np.array(values))
            command = "L"
            continue
        points.extend(_drawn(command, points[-1], values))
    end()
    return lines


def _drawn(command: str, here: Array, values: list[float]) -> Iterable[Array]:
    """Return the points of a command of a path after the point `here`."""
    match command:
        case "L":
            return [np.array(values)]
        case "H":
            return [np.array([values[0], here[1]])]
        case "V":
            return [np.array([here[0], values[0]])]
        case "A":
            return _arc(here, np.array(values[5:]), values[0] if values[4] else -values[0])
        case _:
            return _curve(np.array([*here, *values]).reshape(-1, 2))


def _distinct(points: Array, *, closed: bool) -> Array:
    differs = np.linalg.norm(np.diff(points, axis=0, prepend=points[:1] - 1.0), axis=1) > 1e-6
    if closed and _portable.norm(points[-1] - points[0]) < 1e-6:
        differs[-1] = False
    distinct: Array = points[differs]
    return distinct


def _steps(radius: float, sweep: float) -> int:
    """Return the number of chords of an arc with a radius [units] and a sweep [rad]."""
    step = 2.0 * math.acos(max(0.0, 1.0 - _CHORD / radius)) if radius > _CHORD else _TURN
    return max(1, math.ceil(abs(sweep) / min(step, _TURN) - 1e-9))


def _curve(controls: Array) -> Array:
    """Return samples of a Bezier curve without its start; control points of shape (3, 2) or (4, 2)."""
    legs = np.diff(controls, axis=0)
    legs = legs[np.linalg.norm(legs, axis=1) > 1e-9]
    angle = np.unwrap(_portable.arctan2(legs[:, 1], legs[:, 0]))
    turn = float(np.abs(np.diff(angle)).sum())
    length = float(np.linalg.norm(legs, axis=1).sum())
    steps = max(2, _steps(length / max(turn, 0.3), turn))
    t = (np.arange(1, steps + 1) / steps)[:, None]
    level = [np.broadcast_to(point, (steps, 2)) for point in controls]
    while len(level) > 1:
        level = [(1.0 - t) * a + t * b for a, b in pairwise(level)]
    return level[0]


def _arc(start: Array, end: Array, radius: float) -> Array:
    """Return samples of the shorter arc between points without its start; a negative radius is clockwise."""
    half = 0.5 * (end - start)
    reach = _portable.norm(half)
    size = max(abs(radius), reach)
    across = np.array([-half[1], half[0]]) / reach * math.copysign(1.0, radius)
    center = start + half + across * math.sqrt(max(size**2 - reach**2, 0.0))
    first = start - center
    sweep = math.copysign(2.0 * math.asin(min(1.0, reach / size)), radius)
    begin = math.atan2(first[1], first[0])
    points, _ = arc_points(center, size, begin, sweep, _steps(size, sweep))
    points[-1] = end
    return points[1:]


def drawing(name: str, weight: float, height: float) -> Outline:
    """Return a drawing of the file.

    Args:
        name: Its id, such as `icon-power`.
        weight: Line weight, in units of the square of 20.
        height: Side of the square about the origin [m].
    """
    return moved_outline(_drawing(name, weight), np.eye(2) * (height / _SQUARE), np.zeros(2))


@cached(512)
def _drawing(name: str, weight: float) -> Outline:
    """Return a drawing, in units."""
    region = CrossSection()
    rings: list[Array] = []
    for mark in _marks(_elements()[name], np.eye(3)):
        area = _area(mark, weight * mark.weight)
        if mark.kind in ("stroke", "fill"):
            rings += area
            continue
        region += CrossSection(rings, FillRule.Positive)
        rings = []
        region -= CrossSection(area, FillRule.Positive)
    region += CrossSection(rings, FillRule.Positive)
    return outline_of(region.simplify(0.008), f"the drawing {name!r}")


def _area(mark: _Mark, width: float) -> list[Array]:
    """Return the rings of the area of a mark."""
    points = mark.points
    if mark.kind in ("fill", "cut"):
        return [points if signed_area(points) > 0.0 else points[::-1]]
    leaving = side_normals(points)
    arriving = predecessors(leaving)
    cross = arriving[:, 0] * leaving[:, 1] - arriving[:, 1] * leaving[:, 0]
    turn = _portable.arctan2(cross, np.einsum("ij,ij->i", arriving, leaving))
    if not mark.closed:
        turn[[0, -1]] = math.inf
    corners = np.flatnonzero(np.abs(turn) > _SHARP)
    if not len(corners):
        return _band(points, width)
    if mark.closed:
        points = np.roll(points, -corners[0], axis=0)
        points = np.concatenate([points, points[:1]])
        corners = np.append(corners - corners[0], len(points) - 1)
    return [_ribbon(points[first : last + 1], width) for first, last in pairwise(corners)]


def _across(arriving: Array, leaving: Array) -> Array:
    """Return the displacement of each vertex to the right if both its sides move by one unit."""
    scale = 1.0 + np.einsum("ij,ij->i", arriving, leaving)
    return np.asarray((arriving + leaving) / scale[:, None])


def _band(points: Array, width: float) -> list[Array]:
    """Return the two borders of a stroke along a closed smooth line."""
    if signed_area(points) < 0.0:
        points = points[::-1]
    normals = side_normals(points)
    outward = _across(predecessors(normals), normals) * (width / 2.0)
    return [points + outward, (points - outward)[::-1]]


def _ribbon(points: Array, width: float) -> Array:
    """Return the border of a stroke with round ends along a smooth open line."""
    normals = side_normals(points)[:-1]
    half = width / 2.0
    right = _across(np.concatenate([normals[:1], normals]), np.concatenate([normals, normals[-1:]])) * half
    steps = max(4, _steps(half, math.pi))
    ends = []
    for place, normal in ((points[-1], normals[-1]), (points[0], -normals[0])):
        start = math.atan2(normal[1], normal[0])
        ends.append(arc_points(place, half, start, math.pi, steps)[0][1:-1])
    return np.concatenate([points + right, ends[0], (points - right)[::-1], ends[1]])


def icon_outline(name: str, height: float, weight: Weight) -> Outline:
    """Return an icon; the height [m] is the side of its square."""
    return drawing(f"icon-{_checked(name)}", _WIDTHS[weight], height)


def _checked(name: str) -> str:
    """Return the name of an icon; raise a ValueError for other names."""
    if name not in ICONS:
        raise ValueError(f"there is no icon {name!r}.{nearest(name, ICONS)} `details.ICONS` lists all")
    return name


@kernel
def _icon(name: str, height: float, weight: Weight) -> Outline:
    return icon_outline(name, inputs.positive("height", height), weight)


def icon(name: str, height: Scalar, *, weight: Weight = "regular") -> Profile:
    """Make an icon such as `"power"`, `"timer"` or `"child_lock"`; `ICONS` lists them.

    Icons of equal height match: all are drawn on the same square with the same line width.

    Args:
        name: Name of the icon; known while building.
        height: Side of the square about the origin that the icon fills approximately [m].
        weight: Line weight.

    Raises:
        BuildError: There is no such icon; the message suggests the nearest name.

    Examples:
        >>> details.icon("power", 0.01)
    """
    try:
        _checked(name)
    except ValueError as error:
        raise BuildError(f"{error}\n  at {authors_line()}") from None
    return Profile.record(_icon, name=name, height=height, weight=weight)
