"""Sampling: distributions as values, and independent named random streams."""

from artgen.sampling.choices import by, choice, count
from artgen.sampling.distributions import (
    Distribution,
    Fixed,
    Given,
    fixed,
    given,
    loguniform,
    normal,
    stream,
    uniform,
)

__all__ = [
    "Distribution",
    "Fixed",
    "Given",
    "by",
    "choice",
    "count",
    "fixed",
    "given",
    "loguniform",
    "normal",
    "stream",
    "uniform",
]
