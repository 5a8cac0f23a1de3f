"""Parts that several categories use, by family."""

import math
from collections.abc import Mapping, Sequence

import artgen as ag

_LABELS = "handle rose latch faceplate strike lock deadbolt cylinder hinge screw"

HARDWARE_LABELS = tuple(_LABELS.split())
"""All labels of the parts of door hardware."""


def require_suited(
    handle: ag.Generator, option: str, chosen: str, handles: Mapping[str, ag.Generator]
) -> None:
    """Reject a sample with the handle of another option value; a handle from the caller is accepted."""
    own = [value for value, each in handles.items() if handle == each]
    ag.require(
        not own or chosen in own,
        f"handle={handle.name} belongs to {option}={' or '.join(own)}, not to {option}={chosen}: "
        f"set {option} as well, or leave handle out",
    )


def require_size(value: ag.Float, span: tuple[float, float], what: str) -> ag.Float:
    """Reject a sample with a size outside a span [m]; `what` names the size, such as "length of a pen"."""
    low, high = span
    value = ag.require(value, value >= low, f"{what} must be >= {low:g} m")
    return ag.require(value, value <= high, f"{what} must be <= {high:g} m")


def polar(radii: Sequence[float]) -> ag.Profile:
    """Make an outline from radii at equal angles, counter-clockwise from the x axis [m]."""
    count = len(radii)
    angles = [math.tau * step / count for step in range(count)]
    return ag.polygon([(r * math.cos(a), r * math.sin(a)) for r, a in zip(radii, angles, strict=True)])


def recycling(size: ag.Scalar) -> ag.Profile:
    """Make the recycling sign about the origin: three arrows around a triangle."""
    unit = ag.polygon(
        [(-0.16, 0.30), (-0.16, 0.44), (0.14, 0.44), (0.14, 0.54), (0.34, 0.37), (0.14, 0.20), (0.14, 0.30)]
    )
    arrow = unit.at(0.0, -0.02)
    third = math.tau / 3.0
    return (arrow | arrow.rotate(third) | arrow.rotate(2.0 * third)).scale(size)
