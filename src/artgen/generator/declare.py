"""Decorators that make generators, and the registry of categories."""

from __future__ import annotations

import functools
import inspect
import typing
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from importlib.util import find_spec
from pkgutil import iter_modules
from typing import Any, Never

from artgen._names import NAME_RULE, is_identifier
from artgen.errors import BuildError, ParameterError
from artgen.generator.generator import Generator
from artgen.generator.parameter import spelled
from artgen.graph.node import authors_line
from artgen.nodes.handles import Body
from artgen.sampling import choice

CATEGORIES: dict[str, Generator] = {}
"""Categories by name, filled when the modules that define them are imported."""

_OWN = "artgen.categories"  # package of artgen's categories

_COLLECTED: ContextVar[tuple[str, dict[str, Generator]]] = ContextVar("collected", default=("", {}))


@functools.cache
def own_categories() -> frozenset[str]:
    """Return the names of artgen's categories, which are the names of their packages."""
    folders = find_spec(_OWN).submodule_search_locations  # type: ignore[union-attr]
    return frozenset(found.name for found in iter_modules(folders)) - {"shared"}


@contextmanager
def collected(module: str) -> Iterator[dict[str, Generator]]:
    """Collect the categories of a module while it runs, and keep them out of the catalog.

    A file that is run by path may be a copy of an installed module, so its category names may be taken.

    Args:
        module: `__name__` of the module; categories that it imports enter the catalog as usual.
    """
    found: dict[str, Generator] = {}
    token = _COLLECTED.set((module, found))
    try:
        yield found
    finally:
        _COLLECTED.reset(token)


def generator(function: Callable[..., Any]) -> Generator:
    """Make a generator of a function; its signature declares the parameters.

    Raises:
        BuildError: It is not a function, a parameter has no annotation, or a default does not fit it.
    """
    if not inspect.isfunction(function):
        raise BuildError(
            f"a generator is made of a function, not of {function!r}: write @generator before it\n"
            f"  at {authors_line()}"
        )
    return Generator(function)


def category(
    *function: Never, labels: str | tuple[str, ...] | None = None, joints: tuple[int, int] | None = None
) -> Callable[[Callable[..., Any]], Generator]:
    """Make a category of a function and enter it in the catalog under its name.

    Args:
        labels: All semantic labels of its parts, as names or as one text with spaces between them.
        joints: Minimum and maximum joint count, shown by `artgen list` and checked by `check_category`.

    Raises:
        BuildError: Another category, such as one of artgen, has that name, a parameter has no distribution or
            value, the function does not return a Body, there are no labels, or `joints` is not a range.
    """
    if function or labels is None:
        raise BuildError(
            'a category declares its labels: write @category(labels="base arm") before its function'
            f"\n  at {authors_line()}"
        )
    if joints is not None and not _is_range(joints):
        raise BuildError(
            f"joints={joints!r} is not allowed: give the least and the largest joint count, in this order\n"
            f"  at {authors_line()}"
        )

    names = tuple(labels.split()) if isinstance(labels, str) else labels

    def register(function: Callable[..., Any]) -> Generator:
        made = Generator(function, names, joints)
        if not is_identifier(made.name):
            raise BuildError(
                f"{made.name!r} cannot name a category; use ASCII {NAME_RULE}\n  at {made.where}"
            )
        for name in made.signature.parameters:
            if name not in made.own:
                raise BuildError(
                    f"{made.name}({name}: ...): a category has no inputs; give it a distribution or a "
                    f"plain value\n  at {made.where}"
                )
        returned = typing.get_type_hints(function).get("return", Body)
        if returned is not Body:
            raise BuildError(
                f"{made.name} returns {spelled(returned)}; a category returns a Body\n  at {made.where}"
            )
        collector, found = _COLLECTED.get()
        module, collects = function.__module__, function.__module__ == collector
        if not collects and made.name in own_categories() and module != f"{_OWN}.{made.name}":
            raise BuildError(f"{made.name!r} is a category of artgen; rename the category\n  at {made.where}")
        known = found if collects else CATEGORIES
        other = known.get(made.name)
        # a module or notebook cell that runs again replaces its own categories
        if other is not None and (collects or other.function.__module__ != module):
            raise BuildError(
                f"the category {made.name!r} is defined twice, at {other.where} and {made.where}"
            )
        known[made.name] = made
        return made

    return register


def _is_range(joints: Any) -> bool:
    counts = isinstance(joints, tuple) and len(joints) == 2 and all(type(each) is int for each in joints)
    return counts and bool(0 <= joints[0] <= joints[1])


def one_of(*generators: Generator, weights: tuple[float, ...] | None = None, doc: str = "") -> Any:
    """Draw one of several generators; its parameters become parameters of the caller.

    Raises:
        ParameterError: The list is empty, an option is not a generator, or two generators share a name.
    """
    names = []
    for option in generators:
        if not isinstance(option, Generator):
            raise ParameterError(f"one_of chooses between generators; {option!r} is none")
        if option.name in names:
            raise ParameterError(f"one_of: two generators are named {option.name!r}; rename one")
        names.append(option.name)
    return choice(*generators, weights=weights, doc=doc)
