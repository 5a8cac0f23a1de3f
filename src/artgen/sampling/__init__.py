"""Sampling: distributions as values, and independent named random streams."""

from artgen.sampling.choices import by, choice, count
from artgen.sampling.distributions import (
    Distribution,
    Fixed,
    Given,
    fixed,
    given,
    loguniform,
    stream,
    truncated_normal,
    uniform,
)

__all__ = [
    "Distribution", "Fixed", "Given", "by", "choice", "count", "fixed", "given", "loguniform", "stream",
    "truncated_normal", "uniform",
]  # fmt: skip
