"""Scales, bands and pointers of knobs; angles are clockwise from the top."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Literal

import numpy as np

from artgen import _portable
from artgen._arrays import Array, cached
from artgen.asset.shape import Contour, Outline
from artgen.graph import records
from artgen.graph.handle import check_options
from artgen.nodes import text
from artgen.nodes import validators as inputs
from artgen.nodes.contours import arc_points, faceted, moved_outline
from artgen.nodes.details.icons import Weight, icon_outline
from artgen.nodes.handles import Profile, Scalar
from artgen.nodes.profile import circle, polygon, rectangle
from artgen.nodes.surfaces import arc_steps

SWEEP = math.radians(270.0)
"""Rotation of a usual knob [rad]."""

_NUMBER_GAP = 0.001  # space between ticks and numbers [m]


def _angles(count: int, sweep: float, start: float | None) -> Array:
    """Return evenly spaced angles clockwise from the top, shape (count,) [rad]."""
    if count < 2:
        raise ValueError(f"a dial has at least 2 places, got {count}")
    inputs.between("sweep", sweep, 1e-3, math.tau + 1e-9, "rad")
    full = sweep >= math.tau - 1e-6
    first = (0.0 if full else -sweep / 2.0) if start is None else inputs.finite("start", start, "rad")
    return first + sweep * np.arange(count) / (count if full else count - 1)


def _direction(angle: float) -> Array:
    """Return the direction of an angle clockwise from the top, shape (2,)."""
    return np.array([math.sin(angle), math.cos(angle)])


def _tick(angle: float, radius: float, length: float, width: float) -> Contour:
    half = width / 2.0
    corners = np.array([[-half, 0.0], [half, 0.0], [half, length], [-half, length]]) + [0.0, radius]
    sine, cosine = _direction(angle)
    return faceted(corners @ np.array([[cosine, -sine], [sine, cosine]]))


def _spacing(radius: float, angles: Array) -> float:
    """Return the distance of neighboring places on a circle [m]."""
    return 2.0 * radius * math.sin(min(float(angles[1] - angles[0]), math.pi) / 2.0)


@cached(256)
def _number(string: str, height: float) -> tuple[Outline, Array]:
    """Return a number centered on the origin, and half of its size, shape (2,) [m]."""
    outline = text._text(string, height, "left")
    points = np.concatenate([contour.points for contour in outline.contours])
    low, high = points.min(axis=0), points.max(axis=0)
    middle = np.array([(low[0] + high[0]) / 2.0, height / 2.0])
    return moved_outline(outline, np.eye(2), -middle), np.array([high[0] - low[0], height]) / 2.0


def _numbered(numbers: Sequence[str], angles: Array, radius: float, height: float) -> list[Contour]:
    """Return upright numbers outside a circle."""
    made: list[Contour] = []
    for string, angle in zip(numbers, angles, strict=True):
        if string.strip():
            outline, half = _number(string, height)
            out = _direction(angle)
            # the bounding box of the number, with cut corners, touches the circle
            reach = min(_portable.dot(np.abs(out), half), 0.94 * float(np.hypot(*half)))
            made += moved_outline(outline, np.eye(2), out * (radius + reach)).contours
    return made


def _dial_scale(
    radius: float,
    ticks: int,
    sweep: float,
    start: float | None,
    major_every: int,
    length: float,
    major_length: float,
    width: float,
    numbers: tuple[str, ...],
    number_height: float,
) -> Outline:
    inputs.positive("radius", radius)
    inputs.positive("length", length)
    inputs.positive("major length", major_length)
    inputs.positive("width", width)
    if major_every < 1:
        raise ValueError(f"major_every must be at least 1, got {major_every}")
    angles = _angles(ticks, sweep, start)
    spacing = _spacing(radius, angles)
    if width >= spacing:
        raise ValueError(
            f"{ticks} ticks {width * 1e3:.3g} mm wide do not fit: on a radius of {radius * 1e3:.3g} mm they "
            f"are {spacing * 1e3:.3g} mm apart; use fewer ticks, thinner ones or a larger radius"
        )
    major = np.arange(ticks) % major_every == 0
    contours = [
        _tick(angle, radius, major_length if strong else length, width * (1.5 if strong else 1.0))
        for angle, strong in zip(angles, major, strict=True)
    ]
    if numbers:
        if len(numbers) != int(major.sum()):
            raise ValueError(
                f"{len(numbers)} numbers for {int(major.sum())} long ticks (every {major_every} of {ticks}); "
                'give one for each, "" for a tick without a number'
            )
        inputs.positive("number height", number_height)
        contours += _numbered(numbers, angles[major], radius + major_length + _NUMBER_GAP, number_height)
    return Outline(tuple(contours))


@records(_dial_scale)
def dial_scale(
    radius: Scalar,
    ticks: int,
    *,
    sweep: Scalar = SWEEP,
    start: Scalar | None = None,
    major_every: int = 1,
    length: Scalar = 0.0015,
    major_length: Scalar = 0.0025,
    width: Scalar = 0.0004,
    numbers: Sequence[str] = (),
    number_height: Scalar = 0.0026,
) -> Profile:
    """Make the scale around a knob: ticks on a circle about the origin, clockwise, with numbers outside.

    Args:
        radius: Inner radius of the ticks [m].
        ticks: Number of ticks, including both ends of the sweep.
        sweep: Angle from the first to the last tick [rad]; 2 pi is a full circle without a repeated tick.
        start: Angle of the first tick, clockwise from the top [rad]; by default the sweep is symmetric, and a
            full circle begins at the top.
        major_every: Every n-th tick is long, starting with the first.
        length: Length of a short tick [m].
        major_length: Length of a long tick, which is 1.5 times as wide [m].
        width: Width of a short tick [m].
        numbers: Text at the long ticks, in order; `""` leaves a tick without text.
        number_height: Height of the numbers [m].

    Examples:
        >>> details.dial_scale(0.02, 11, major_every=5, numbers=("0", "5", "10"))
    """


def _dial_icons(
    names: tuple[str, ...], radius: float, height: float, sweep: float, start: float | None, weight: Weight
) -> Outline:
    inputs.positive("radius", radius)
    inputs.positive("height", height)
    angles = _angles(len(names), sweep, start)
    spacing = _spacing(radius, angles)
    if height > spacing:
        raise ValueError(
            f"{len(names)} icons {height * 1e3:.3g} mm high overlap: on a radius of {radius * 1e3:.3g} mm "
            f"they are {spacing * 1e3:.3g} mm apart; use smaller icons or a larger radius"
        )
    contours: list[Contour] = []
    for name, angle in zip(names, angles, strict=True):
        if name:
            icon = icon_outline(name, height, weight)
            contours += moved_outline(icon, np.eye(2), radius * _direction(angle)).contours
    if not contours:
        raise ValueError("the dial has no icons; name at least one")
    return Outline(tuple(contours))


@records(_dial_icons)
def dial_icons(
    names: Sequence[str],
    radius: Scalar,
    height: Scalar,
    *,
    sweep: Scalar = SWEEP,
    start: Scalar | None = None,
    weight: Weight = "regular",
) -> Profile:
    """Make icons around a knob, clockwise and upright.

    Args:
        names: Names of icons for `icon`, in order; `""` leaves a place empty.
        radius: Distance of their centers from the origin [m].
        height: Height of the icons [m].
        sweep: Angle from the first to the last icon [rad]; 2 pi is a full circle without a repeated icon.
        start: Angle of the first icon, clockwise from the top [rad]; by default the sweep is symmetric, and a
            full circle begins at the top.
        weight: Line weight.

    Examples:
        >>> details.dial_icons(("power", "fan", "light", "timer"), 0.02, 0.008)
    """


def _dial_band(radius: float, width: float, end_width: float, sweep: float, start: float | None) -> Outline:
    inputs.positive("radius", radius)
    inputs.positive("width", width)
    inputs.positive("end width", end_width)
    inputs.between("sweep", sweep, 1e-3, math.tau * 0.99, "rad")
    first = -sweep / 2.0 if start is None else inputs.finite("start", start, "rad")
    steps = 2 * arc_steps(radius + max(width, end_width), sweep)
    inner, outward = arc_points(np.zeros(2), radius, math.pi / 2.0 - first, -sweep, steps)
    share = np.arange(steps + 1)[:, None] / steps
    outer = inner + outward * (width + (end_width - width) * share)
    return Outline((faceted(np.concatenate([inner, outer[::-1]])),))


@records(_dial_band)
def dial_band(
    radius: Scalar, width: Scalar, end_width: Scalar, *, sweep: Scalar = SWEEP, start: Scalar | None = None
) -> Profile:
    """Make a band around a knob that widens clockwise, for example for loudness or heat.

    Args:
        radius: Inner radius [m].
        width: Width at the start [m].
        end_width: Width at the end [m].
        sweep: Angle of the band [rad].
        start: Start, clockwise from the top [rad]; by default the band is symmetric.

    Examples:
        >>> details.dial_band(0.02, 0.001, 0.005)
    """


def pointer(
    inner: Scalar, outer: Scalar, width: Scalar, *, style: Literal["line", "triangle", "dot"] = "line"
) -> Profile:
    """Make the mark of a knob, upward from the origin at the center of the knob.

    Args:
        inner: Distance of its lower end from the center [m].
        outer: Distance of its upper end from the center [m].
        width: Width; for a dot at the upper end, its diameter [m].
        style: A line, an outward triangle, or a dot.

    Examples:
        >>> circle(0.02) - details.pointer(0.008, 0.018, 0.004, style="triangle")
    """
    check_options(pointer, locals())
    if style == "dot":
        return circle(width / 2).at(0.0, outer - width / 2)
    if style == "triangle":
        return polygon([(-0.5, 0.0), (0.5, 0.0), (0.0, 1.0)]).scale(width, outer - inner).at(0.0, inner)
    return rectangle(width, outer - inner).at(0.0, (inner + outer) / 2)
