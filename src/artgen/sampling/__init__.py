"""Sampling: distributions as values, and independent random streams by name."""

from artgen.sampling.distributions import Distribution, by, choice, count, loguniform, normal, uniform
from artgen.sampling.streams import stream

__all__ = ["Distribution", "by", "choice", "count", "loguniform", "normal", "stream", "uniform"]
