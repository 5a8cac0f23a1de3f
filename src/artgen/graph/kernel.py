"""Registered operations: a constructor records one, its kernel computes the value at a level of detail."""

import inspect
import math
import sys
import types
import typing
from collections.abc import Callable, Mapping
from contextvars import ContextVar
from dataclasses import dataclass, field, replace
from functools import cache
from typing import Any, TypeVar, overload

from artgen._arrays import cached_property
from artgen.errors import GraphError, nearest

F = TypeVar("F", bound=Callable[..., Any])


@dataclass(frozen=True, eq=False)
class Detail:
    """A level of detail: tolerances of the solids, which kernels read with `detail_level`."""

    name: str
    chord: float = 0.0002  # largest distance of facets from a round surface [m]
    sides: tuple[int, int] = (12, 16)  # least sides of a circle with a radius below 2 mm, and of a larger one
    sharp: float = 1e-6  # edges with a smaller radius stay sharp [m]
    thin: float = 0.0  # print, and visual details that are not thicker, are left out; 0 keeps all [m]
    most: float = math.inf  # triangles of an asset that are aimed at

    @property
    def finer(self) -> "Detail":
        """The level to try after this one failed."""
        return self.scaled(0.5) if self.chord > 2.0 * FULL.chord else FULL

    def scaled(self, factor: float) -> "Detail":
        """Return the level with its tolerances multiplied by a factor."""
        tolerances = {name: factor * getattr(self, name) for name in ("chord", "sharp", "thin")}
        return replace(self, **tolerances)


FULL = Detail("full")
"""The level at which numbers, points and frames are measured, whatever the level of the solids."""

DETAILS: Mapping[str, Detail] = {
    each.name: each
    for each in (
        FULL,
        Detail("medium", 0.0005, (6, 8), 0.0008, most=10000),
        Detail("low", 0.0008, (4, 4), 0.0015, 0.001, 2000),
    )
}
"""The levels of detail by name."""

_LEVEL: ContextVar[Detail] = ContextVar("detail", default=FULL)


def detail_level() -> Detail:
    """Return the level of detail of the kernel that runs; `FULL` outside an evaluation."""
    return _LEVEL.get()


@dataclass(frozen=True, eq=False)
class Operation:
    """A registered operation.

    Attributes:
        name: Name of the kernel without leading underscores, and of its constructor.
        kernel: Function that computes the result from the values of the inputs, passed in order.
        inputs: The type of each input's value, from the kernel's annotations.
        result: The type of the result's value.
        module: Module of the constructor.
        spelling: Python source of the operation, such as `({a} + {b})`; empty for a call of the constructor.
        lazy: Whether the input `condition` selects which of the inputs `a` and `b` is evaluated.
        constructor: Name of the function in the module that records the operation, if there is one.
        bare: Function that returns the value without print from the inputs of a node, before any is computed;
            NotImplemented for a node that is computed as usual.
        later: Inputs that are computed on first use at levels of detail other than `FULL`, each with the
            function that makes its value of the function that computes it.
    """

    name: str
    kernel: Callable[..., Any]
    inputs: Mapping[str, Any]
    result: Any
    module: str
    spelling: str = ""
    lazy: bool = False
    constructor: str = ""
    bare: Callable[[Mapping[str, Any]], Any] | None = None
    later: Mapping[str, Callable[[Callable[[], Any]], Any]] = field(default_factory=dict)

    @cached_property
    def measures(self) -> bool:
        """Whether the result is a number, a truth value or an array, which is measured at full detail."""
        return self.result in (bool, int, float, str) or typing.get_origin(self.result) is typing.Annotated


OPERATIONS: dict[str, Operation] = {}
"""All operations by name, filled when the modules that define them are imported."""


@overload
def kernel(function: F) -> F: ...
@overload
def kernel(*, name: str = "", spelling: str = "") -> Callable[[F], F]: ...
def kernel(function: F | None = None, *, name: str = "", spelling: str = "") -> F | Callable[[F], F]:
    """Register a function as the kernel of the operation with its name.

    Args:
        function: Function on values; its annotations define the accepted inputs.
        name: Name of the operation; by default the function's name without leading underscores.
        spelling: Python source of the operation, e.g. `({a} + {b})`.

    Raises:
        GraphError: Another kernel has that name.
    """

    def decorate(made: F) -> F:
        operation = name or made.__name__.lstrip("_")
        inputs, result = types_of(made, operation)
        register(Operation(operation, made, inputs, result, made.__module__, spelling, constructor=operation))
        return made

    return decorate if function is None else decorate(function)


def register(known: Operation) -> None:
    """Enter an operation in the table.

    Raises:
        GraphError: Another operation has that name.
    """
    if known.name in OPERATIONS:
        other = OPERATIONS[known.name].module
        raise GraphError(f"the operation {known.name!r} is defined twice, in {other} and {known.module}")
    OPERATIONS[known.name] = known


def define(name: str, made: Callable[..., Any], spelling: str, result: Any, **inputs: Any) -> None:
    """Register an operation of a handle that has a short kernel, with the types of its result and inputs."""
    module = sys._getframe(1).f_globals["__name__"]  # kernels such as `abs` have another module
    register(Operation(name, made, inputs, result, module, spelling))


def types_of(made: Callable[..., Any], operation: str) -> tuple[dict[str, Any], Any]:
    """Return the types of a kernel's inputs and of its result, from its annotations.

    Raises:
        GraphError: An annotation is missing.
    """
    hints = typing.get_type_hints(made, include_extras=True)
    result = hints.pop("return", None)
    names = inspect.signature(made).parameters
    missing = [parameter for parameter in names if parameter not in hints]
    if missing or result is None:
        raise GraphError(f"the kernel {operation!r} must annotate {missing or 'its result'}")
    return {parameter: hints[parameter] for parameter in names}, result


def operation(name: str) -> Operation:
    """Return the operation of that name.

    Raises:
        GraphError: There is no such operation; the message suggests the nearest name.
    """
    if name not in OPERATIONS:
        raise GraphError(f"there is no operation {name!r}.{nearest(name, OPERATIONS)}")
    return OPERATIONS[name]


@cache
def alternatives(hint: Any) -> tuple[Any, ...]:
    """Return the members of a union type, or the type alone."""
    if isinstance(hint, types.UnionType) or typing.get_origin(hint) is typing.Union:
        return typing.get_args(hint)
    return (hint,)
