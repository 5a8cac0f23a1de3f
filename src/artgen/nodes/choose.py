"""Choice between values by a condition, and requirements on samples."""

from collections.abc import Callable
from typing import Any, TypeVar, overload

import numpy as np

from artgen.errors import BuildError, InfeasibleError
from artgen.graph import Handle, kernel
from artgen.graph.node import authors_line
from artgen.nodes.handles import (
    Body,
    Bool,
    Condition_,
    Float,
    Path,
    Points,
    PointsLike,
    Profile,
    Scalar,
    Solid,
    Vector,
    VectorLike,
)

H = TypeVar("H", bound=Handle)


def _typed(function: Callable[..., Any], value_type: Any, **others: Any) -> Callable[..., Any]:
    """Annotate a kernel that accepts values of any single type."""
    function.__annotations__ = {"return": value_type, **others}
    return function


def _register(handle: type[Handle]) -> None:
    """Register `switch` and `require` for one type of value."""

    def choose(condition: bool, a: Any, b: Any) -> Any:
        return a if condition else b

    def demand(value: Any, condition: bool, message: str) -> Any:
        if not condition:
            raise InfeasibleError(message)
        return value

    kind, suffix = handle.value_type, handle.__name__.lower()
    kernel(name=f"switch_{suffix}", lazy=True, constructor="switch")(
        _typed(choose, kind, condition=bool, a=kind, b=kind)
    )
    kernel(name=f"require_{suffix}", constructor="require")(
        _typed(demand, kind, value=kind, condition=bool, message=str)
    )


_CHOOSABLE = (Float, Bool, Vector, Points, Profile, Path, Solid, Body)
for _handle in _CHOOSABLE:
    _register(_handle)


def _common_type(a: Any, b: Any) -> type[Handle]:
    """Return the common handle type of two values; plain values count as their handle type."""
    for value in (a, b):
        if isinstance(value, Handle):
            return type(value)
    kinds: tuple[type[Handle], ...] = (Bool, Float, Vector, Points)
    return next(
        (kind for kind in kinds if kind.lift(a) is not NotImplemented and kind.lift(b) is not NotImplemented),
        Float,
    )


@overload
def switch(condition: Condition_, a: H, b: H) -> H: ...  # type: ignore[overload-overlap] # the first match counts
@overload
def switch(condition: Condition_, a: bool, b: bool) -> Bool: ...  # type: ignore[overload-overlap] # the first match counts
@overload
def switch(condition: Condition_, a: Scalar, b: Scalar) -> Float: ...
@overload
def switch(condition: Condition_, a: VectorLike, b: VectorLike) -> Vector: ...  # type: ignore[overload-overlap] # the first match counts
@overload
def switch(condition: Condition_, a: PointsLike, b: PointsLike) -> Points: ...
def switch(condition: Any, a: Any, b: Any) -> Any:
    """Return `a` if the condition holds and `b` otherwise; only the chosen one is computed.

    Args:
        condition: A Bool, or a Python bool.
        a: A handle, or a number, truth value, vector or list of points.
        b: The same kind of value.

    Raises:
        BuildError: `a` and `b` have different types, or a type without choice.

    Examples:
        >>> block = box(0.3, 0.2, 0.1)
        >>> switch(block.size().x > 0.2, block - bore(0.05, 0.2), block)
    """
    kind = _common_type(a, b)
    if kind not in _CHOOSABLE:
        names = ", ".join(handle.__name__ for handle in _CHOOSABLE)
        raise BuildError(
            f"switch chooses between values of {names}, not {kind.__name__}\n  at {authors_line()}"
        )
    return kind.record(f"switch_{kind.__name__.lower()}", condition=condition, a=a, b=b)


@overload
def require(value: H, condition: Condition_, message: str) -> H: ...  # type: ignore[overload-overlap] # the first match counts
@overload
def require(value: bool, condition: str) -> None: ...
@overload
def require(value: Scalar, condition: Condition_, message: str) -> Float: ...
def require(value: Any, condition: Any, message: str = "") -> Any:
    """Require a condition; a sample that violates it is infeasible and drawn again.

    `require(condition, message)` checks a condition on structural parameters at once. `require(value,
    condition, message)`, like `value.require(condition, message)`, returns the value with a condition that is
    checked at evaluation; the value must be part of the result of the category, because a graph consists of
    the nodes that its result reaches.

    Raises:
        InfeasibleError: The condition is known while building and does not hold.
        BuildError: A condition that is known at evaluation has no value, or the first argument is neither a
            condition nor a value.

    Examples:
        >>> block = box(0.3, 0.2, 0.1)
        >>> require(block, block.size().x > 0.2, "the block is too narrow")
    """
    if not isinstance(condition, str):
        if isinstance(value, Handle):
            return value.require(condition, message)
        kind = _common_type(value, value)
        return kind.record(
            f"require_{kind.__name__.lower()}", value=value, condition=condition, message=message
        )
    if isinstance(value, Handle):
        raise BuildError(
            f"require(condition, message) with a {type(value).__name__} would be reached by nothing\n"
            f"  at {authors_line()}\n  Attach it to a value: return body.require(condition, message)"
        )
    if not isinstance(value, bool | np.bool_):
        raise BuildError(f"require needs a condition, got {value!r}\n  at {authors_line()}")
    if not value:
        raise InfeasibleError(f"{condition}\n  at {authors_line()}")
    return None
