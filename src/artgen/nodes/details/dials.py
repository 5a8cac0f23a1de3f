"""Scales of knobs: ticks, numbers and icons on a circle, read clockwise from the top."""

import math
from collections.abc import Sequence
from typing import Literal

import numpy as np

from artgen._arrays import Array, cached
from artgen.asset.shape import Contour, Outline
from artgen.graph import kernel
from artgen.nodes import text
from artgen.nodes import validators as inputs
from artgen.nodes.contours import faceted, moved_outline
from artgen.nodes.details.icons import Weight, checked_icon, icon_outline
from artgen.nodes.details.pen import SQUARE
from artgen.nodes.handles import Profile, Scalar

Orientation = Literal["upright", "radial"]
"""Orientation of numbers: upright, or with their feet towards the center of the dial."""

SWEEP = math.radians(270.0)
"""Rotation of a usual knob [rad]."""


def _angles(count: int, sweep: float, start: float | None) -> Array:
    """Return evenly spaced angles clockwise from the top, shape (count,) [rad]."""
    if count < 2:
        raise ValueError(f"a dial has at least 2 places, got {count}")
    inputs.between("sweep", sweep, 1e-3, math.tau + 1e-9, "rad")
    full = sweep >= math.tau - 1e-6
    first = (0.0 if full else -sweep / 2.0) if start is None else inputs.finite("start", start, "rad")
    return first + sweep * np.arange(count) / (count if full else count - 1)


def _around(angle: float) -> Array:
    """Return the matrix that rotates y to an angle clockwise from the top, shape (2, 2)."""
    cosine, sine = math.cos(angle), math.sin(angle)
    return np.array([[cosine, sine], [-sine, cosine]])


def _tick(angle: float, radius: float, length: float, width: float) -> Contour:
    half = width / 2.0
    corners = np.array([[-half, 0.0], [half, 0.0], [half, length], [-half, length]]) + [0.0, radius]
    return faceted(corners @ _around(angle).T)


@cached(256)
def _number(string: str, height: float) -> tuple[Outline, Array]:
    """Return a number centered on the origin, and half of its size, shape (2,) [m]."""
    outline = text._text(string, height, "left")
    points = np.concatenate([contour.points for contour in outline.contours])
    low, high = points.min(axis=0), points.max(axis=0)
    middle = np.array([(low[0] + high[0]) / 2.0, height / 2.0])
    return moved_outline(outline, np.eye(2), -middle), np.array([high[0] - low[0], height]) / 2.0


def _numbered(
    numbers: Sequence[str], angles: Array, radius: float, height: float, orientation: str
) -> list[Contour]:
    """Return numbers whose inner sides have a distance from the center."""
    made: list[Contour] = []
    for string, angle in zip(numbers, angles, strict=True):
        if not string.strip():
            continue
        outline, half = _number(string, height)
        out = np.array([math.sin(angle), math.cos(angle)])
        turn = np.eye(2)
        reach = half[1]
        if orientation == "upright":
            # the bounding box of the number, with cut corners, touches the circle
            reach = min(float(np.abs(out) @ half), 0.94 * float(np.hypot(*half)))
        else:
            turn = _around(angle)
        made += moved_outline(outline, turn, out * (radius + reach)).contours
    return made


@kernel
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
    number_gap: float,
    orientation: Orientation,
) -> Outline:
    inputs.positive("radius", radius)
    inputs.positive("length", length)
    inputs.positive("major length", major_length)
    inputs.positive("width", width)
    if major_every < 1:
        raise ValueError(f"major_every must be at least 1, got {major_every}")
    angles = _angles(ticks, sweep, start)
    spacing = 2.0 * radius * math.sin(min(float(angles[1] - angles[0]), math.pi) / 2.0)
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
                'give one for each, "" where none shall stand'
            )
        inputs.positive("number height", number_height)
        reach = radius + major_length + inputs.between("number gap", number_gap, 0.0, 1.0)
        contours += _numbered(numbers, angles[major], reach, number_height, orientation)
    return Outline(tuple(contours))


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
    number_gap: Scalar = 0.001,
    orientation: Orientation = "upright",
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
        number_gap: Space between ticks and numbers [m].
        orientation: Whether numbers are upright or radial.

    Examples:
        >>> details.dial_scale(0.02, 11, major_every=5, numbers=("0", "5", "10"))
    """
    numbers = tuple(numbers)
    return Profile.record(
        _dial_scale,
        radius=radius,
        ticks=ticks,
        sweep=sweep,
        start=start,
        major_every=major_every,
        length=length,
        major_length=major_length,
        width=width,
        numbers=numbers,
        number_height=number_height,
        number_gap=number_gap,
        orientation=orientation,
    )


@kernel
def _dial_icons(
    names: tuple[str, ...],
    radius: float,
    height: float,
    sweep: float,
    start: float | None,
    weight: Weight,
) -> Outline:
    inputs.positive("radius", radius)
    inputs.positive("height", height)
    angles = _angles(len(names), sweep, start)
    spacing = 2.0 * radius * math.sin(min(float(angles[1] - angles[0]), math.pi) / 2.0)
    if height > spacing:
        raise ValueError(
            f"{len(names)} icons {height * 1e3:.3g} mm high overlap: on a radius of {radius * 1e3:.3g} mm "
            f"they are {spacing * 1e3:.3g} mm apart; use smaller icons or a larger radius"
        )
    contours: list[Contour] = []
    for name, angle in zip(names, angles, strict=True):
        if name:
            middle = radius * np.array([math.sin(angle), math.cos(angle)])
            outline = icon_outline(checked_icon(name), weight)
            contours += moved_outline(outline, np.eye(2) * (height / SQUARE), middle).contours
    if not contours:
        raise ValueError("the dial has no icons")
    return Outline(tuple(contours))


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
    names = tuple(names)
    return Profile.record(
        _dial_icons, names=names, radius=radius, height=height, sweep=sweep, start=start, weight=weight
    )
