"""Generators: typed functions; the signature declares the parameters and their distributions."""

from artgen.generator.declare import CATEGORIES, category, collected, generator, one_of, own_categories
from artgen.generator.generator import Generator, OnCollision
from artgen.generator.parameter import Parameter, accept
from artgen.generator.shades import shades
from artgen.sampling import Fixed

__all__ = [
    "CATEGORIES", "Fixed", "Generator", "OnCollision", "Parameter", "accept", "category", "collected",
    "generator", "one_of", "own_categories", "shades",
]  # fmt: skip
