"""The nodes in the documentation, by page, and the examples in their docstrings."""

import doctest
import inspect
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import artgen
from artgen import details, fittings
from artgen.nodes.handles import Body, Path, Profile, Solid, Vector
from artgen.nodes.joint import Condition, Coupling, Dependency, Joint

HANDLES = (
    artgen.Float,
    artgen.Bool,
    Vector,
    artgen.Points,
    artgen.Region,
    Profile,
    Path,
    Solid,
    Body,
    Joint,
    Coupling,
    Condition,
    Dependency,
)
"""The handles, and regions, whose public methods are nodes."""

_SHOWN_BY = {"Coupling": "Joint", "Condition": "Joint", "Dependency": "Joint"}  # a joint makes them

_INNER = {"lift", "decode", "record", "parameter"}  # how handles work, not what authors write


@dataclass(frozen=True)
class Example:
    """A node and its example.

    Attributes:
        name: Name after `artgen.`, such as `box`, `details.icon` or `Solid.at`.
        home: The module that defines it.
        source: Lines of the example, the last one an expression.
    """

    name: str
    home: str
    source: tuple[str, ...]

    @property
    def address(self) -> str:
        """The full dotted name: in the root package if possible, else in the module that defines it."""
        root = "artgen" if hasattr(artgen, self.name.split(".")[0]) else self.home
        return f"{root}.{self.name}"

    def run(self) -> Any:
        """Return the handle that the example returns."""
        names = {name: getattr(artgen, name) for name in (*artgen.__all__, "fittings", "signals")}
        *before, last = self.source
        for line in before:
            exec(line, names)  # noqa: S102 - what runs is our own docstring
        return eval(last, names)  # noqa: S307 - the same


def nodes() -> Iterator[tuple[str, Any]]:
    """Yield every public node by its name: functions, details, fittings, joints, handles and methods."""
    for name in artgen.__all__:
        made = getattr(artgen, name)
        function = inspect.isfunction(made) and made.__module__.startswith("artgen.nodes.")
        if function or (inspect.isclass(made) and made is not Joint and issubclass(made, Joint)):
            yield name, made
    for name in details.__all__:
        if inspect.isfunction(getattr(details, name)):
            yield f"details.{name}", getattr(details, name)
    for name in fittings.__all__:
        if inspect.isfunction(getattr(fittings, name)):
            yield f"fittings.{name}", getattr(fittings, name)
    for handle in HANDLES:
        yield handle.__name__, handle
        for name, method in vars(handle).items():
            if inspect.isfunction(method) and not name.startswith("_"):
                yield f"{handle.__name__}.{name}", method


def examples() -> dict[str, Example]:
    """Return the example of every node, by name; a handle's example may also be that of its methods.

    Raises:
        LookupError: A node has no example.
    """
    parser = doctest.DocTestParser()
    found = {}
    for name, made in nodes():
        source = tuple(each.source.rstrip("\n") for each in parser.get_examples(made.__doc__ or ""))
        handle, _, method = name.rpartition(".")
        shown_by = found.get(handle or _SHOWN_BY.get(name, ""))
        if not source and shown_by and (not handle or any(f".{method}(" in line for line in shown_by.source)):
            source = shown_by.source
        if not source:
            raise LookupError(f"{made.__module__}.{made.__qualname__} has no example; add `Examples:` to it")
        found[name] = Example(name, made.__module__, source)
    return found
