"""The catalog: categories by name, those of artgen and those that other packages bring."""

import functools
from importlib import import_module
from pkgutil import iter_modules
from typing import Any

from artgen.asset import Asset
from artgen.errors import BuildError, ParameterError, nearest
from artgen.generator import CATEGORIES, Generator

ENTRY_POINTS = "artgen.categories"
"""Group of entry points by which other packages bring categories; each names a module that defines some."""


@functools.cache
def _own() -> frozenset[str]:
    """Return the names of artgen's categories: each is the module of its name."""
    import artgen.categories

    return frozenset(found.name for found in iter_modules(artgen.categories.__path__) if not found.ispkg)


@functools.cache
def _load_others() -> None:
    """Import the modules of other packages that define categories, which enters them in `CATEGORIES`."""
    from importlib.metadata import entry_points

    for point in sorted(entry_points(group=ENTRY_POINTS), key=lambda point: (point.name, point.value)):
        try:
            point.load()
        except Exception as error:
            raise BuildError(f"the categories of {point.value!r} cannot be imported: {error!r}") from error


def categories() -> tuple[str, ...]:
    """Return the names of all categories in alphabetical order."""
    _load_others()
    return tuple(sorted({*_own(), *CATEGORIES}))


def find(name: str) -> Generator:
    """Return the category of that name; of artgen's own, only its module is imported.

    Raises:
        ParameterError: There is none; the message has the nearest name.
    """
    if name not in CATEGORIES and name in _own():
        import_module(f"artgen.categories.{name}")
    if name not in CATEGORIES:  # the caller's own categories need no catalog
        _load_others()
    if name not in CATEGORIES:
        raise ParameterError(f"there is no category {name!r}.{nearest(name, categories())}")
    return CATEGORIES[name]


def generate(category: str | Generator, /, seed: int = 0, **overrides: Any) -> Asset:
    """Generate an asset.

    Args:
        category: Name of a category, or a category or generator itself.
        seed: Decides every draw: the same seed gives the same asset, byte for byte.
        **overrides: What `Generator.generate` takes: `name`, `base` ("fixed" or "free"), `certify=False` to
            skip the proof that no two links collide, `tolerance` [m] and `on_collision` ("redraw", "fail" or
            "keep") for it, and a value or a distribution by parameter name. `handle__length` stands for
            `handle.length`.

    Raises:
        ParameterError: The category, the seed, an option or an override is unknown or not allowed.
        EvaluationError: A kernel failed.
        InfeasibleError: No draw met the category's requirements, or none is proven free of collisions.
        CheckError: The links are not proven apart, and `on_collision` is "fail".
    """
    chosen = find(category) if isinstance(category, str) else category
    if not isinstance(chosen, Generator):
        raise ParameterError(f"generate takes the name of a category or a generator, got {category!r}")
    return chosen.generate(seed, **overrides)
