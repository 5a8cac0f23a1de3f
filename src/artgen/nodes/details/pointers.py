"""Marks of knobs, and bands around them with a growing width."""

import math
from typing import Literal

import numpy as np

from artgen.asset.shape import Outline
from artgen.graph import kernel
from artgen.nodes import validators as inputs
from artgen.nodes.contours import arc_points, faceted
from artgen.nodes.details.dials import SWEEP
from artgen.nodes.handles import Profile, Scalar
from artgen.nodes.profile import circle, polygon, rectangle
from artgen.nodes.surfaces import arc_steps


@kernel
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
    return Profile.record(
        _dial_band, radius=radius, width=width, end_width=end_width, sweep=sweep, start=start
    )


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
    if style == "dot":
        return circle(width / 2).at(0.0, outer - width / 2)
    if style == "triangle":
        return polygon([(-0.5, 0.0), (0.5, 0.0), (0.0, 1.0)]).scale(width, outer - inner).at(0.0, inner)
    return rectangle(width, outer - inner).at(0.0, (inner + outer) / 2)
