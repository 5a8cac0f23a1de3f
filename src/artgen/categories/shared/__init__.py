"""Parts that several categories use, by family."""

import math

import artgen as ag


def recycling(size: ag.Scalar) -> ag.Profile:
    """Make the recycling sign about the origin: three arrows around a triangle."""
    unit = ag.polygon(
        [(-0.16, 0.30), (-0.16, 0.44), (0.14, 0.44), (0.14, 0.54), (0.34, 0.37), (0.14, 0.20), (0.14, 0.30)]
    )
    arrow = unit.at(0.0, -0.02)
    third = math.tau / 3.0
    return (arrow | arrow.rotate(third) | arrow.rotate(2.0 * third)).scale(size)
