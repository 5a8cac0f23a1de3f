"""Numbers and truth values: arithmetic, functions, logic, choice between values, and requirements."""

from __future__ import annotations

import math
from typing import Any, TypeVar, overload

import numpy as np

from artgen.errors import BuildError, InfeasibleError
from artgen.graph import Handle, Operation, define, kernel, records
from artgen.graph.kernel import register
from artgen.graph.node import authors_line
from artgen.nodes.handles import Body, Path, Profile, Solid
from artgen.nodes.scalar_handles import (
    Bool,
    Condition_,
    Float,
    Points,
    PointsLike,
    Scalar,
    Vector,
    VectorLike,
)

define("add", lambda a, b: a + b, "({a} + {b})", float, a=float, b=float)
define("subtract", lambda a, b: a - b, "({a} - {b})", float, a=float, b=float)
define("multiply", lambda a, b: a * b, "({a} * {b})", float, a=float, b=float)
define("negate", lambda a: -a, "(-{a})", float, a=float)
define("absolute", abs, "abs({a})", float, a=float)
define("floor", lambda a: float(math.floor(a)), "{a}.__floor__()", float, a=float)
define("round_", lambda a: float(round(a)), "round({a})", float, a=float)
define("less", lambda a, b: a < b, "({a} < {b})", bool, a=float, b=float)
define("greater", lambda a, b: a > b, "({a} > {b})", bool, a=float, b=float)
define("at_most", lambda a, b: a <= b, "({a} <= {b})", bool, a=float, b=float)
define("at_least", lambda a, b: a >= b, "({a} >= {b})", bool, a=float, b=float)
define("and_", lambda a, b: a and b, "({a} & {b})", bool, a=bool, b=bool)
define("or_", lambda a, b: a or b, "({a} | {b})", bool, a=bool, b=bool)
define("not_", lambda a: not a, "(~{a})", bool, a=bool)


@kernel(spelling="({a} / {b})")
def _divide(a: float, b: float) -> float:
    if b == 0.0:
        raise ValueError(f"division of {a:.6g} by zero")
    return a / b


@kernel(spelling="({a} ** {b})")
def _power(a: float, b: float) -> float:
    if a < 0.0 and b != math.floor(b):
        raise ValueError(f"{a:.6g} ** {b:.6g} is not real")
    return float(a**b)


@kernel(spelling="({a} % {b})")
def _modulo(a: float, b: float) -> float:
    if b == 0.0:
        raise ValueError(f"remainder of {a:.6g} divided by zero")
    return a % b


@records(min, of=float)
def min_(a: Scalar, b: Scalar) -> Float:
    """Return the smaller of two numbers.

    Examples:
        >>> size = box(0.3, 0.2, 0.1).size()
        >>> box(0.3, 0.2, 0.1) - bore(0.4 * min_(size.x, size.y), 0.2)
    """


@records(max, of=float)
def max_(a: Scalar, b: Scalar) -> Float:
    """Return the larger of two numbers.

    Examples:
        >>> size = box(0.3, 0.2, 0.1).size()
        >>> box(0.3, 0.2, 0.1) | cylinder(0.6 * max_(size.x, size.y), 0.01)
    """


def _clamp(value: float, low: float, high: float) -> float:
    if low > high:
        raise ValueError(f"clamp between {low:.6g} and {high:.6g}: low exceeds high")
    return min(max(value, low), high)


@records(_clamp)
def clamp(value: Scalar, low: Scalar, high: Scalar) -> Float:
    """Return the number between `low` and `high` that is nearest to `value`.

    Examples:
        >>> union(*(box(0.02, 0.03, clamp(0.015 * i, 0.03, 0.1)).at(0.02 * i) for i in range(10)))
    """


def _sqrt(a: float) -> float:
    if a < 0.0:
        raise ValueError(f"square root of {a:.6g}")
    return math.sqrt(a)


@records(_sqrt)
def sqrt(a: Scalar) -> Float:
    """Return the square root.

    Examples:
        >>> union(*(box(0.02, 0.03, 0.04 * sqrt(i + 1)).at(0.02 * i) for i in range(10)))
    """


@records(math.sin, of=float)
def sin(a: Scalar) -> Float:
    """Return the sine of an angle [rad].

    Examples:
        >>> union(*(box(0.02, 0.03, 0.08 + 0.05 * sin(0.5 * i)).at(0.02 * i) for i in range(13)))
    """


@records(math.cos, of=float)
def cos(a: Scalar) -> Float:
    """Return the cosine of an angle [rad].

    Examples:
        >>> union(*(box(0.02, 0.03, 0.08 + 0.05 * cos(0.5 * i)).at(0.02 * i) for i in range(13)))
    """


@records(math.tan, of=float)
def tan(a: Scalar) -> Float:
    """Return the tangent of an angle [rad].

    Examples:
        >>> wedge(0.1, 0.3, 0.3 * tan(0.5))
    """


@records(math.atan2, of=float)
def atan2(y: Scalar, x: Scalar) -> Float:
    """Return the angle of the direction (x, y), from -pi to pi [rad].

    Examples:
        >>> box(0.3, 0.02, 0.02).rotate(Z, atan2(0.1, 0.2)) | sphere(0.03).at(0.2, 0.1)
    """


H = TypeVar("H", bound=Handle)


_CHOOSABLE = (Float, Bool, Vector, Points, Profile, Path, Solid, Body)


def _chosen(condition: bool, a: Any, b: Any) -> Any:
    return a if condition else b


def _required(value: Any, condition: bool, message: str) -> Any:
    if not condition:
        raise InfeasibleError(message)
    return value


for _handle in _CHOOSABLE:
    _kind, _suffix = _handle.value_type, _handle.__name__.lower()
    _inputs = {"condition": bool, "a": _kind, "b": _kind}
    register(
        Operation(f"switch_{_suffix}", _chosen, _inputs, _kind, __name__, lazy=True, constructor="switch")
    )
    _inputs = {"value": _kind, "condition": bool, "message": str}
    register(Operation(f"require_{_suffix}", _required, _inputs, _kind, __name__, constructor="require"))


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
            f"require(condition, message) with a {type(value).__name__} has no effect: no value carries it\n"
            f"  at {authors_line()}\n  Attach it to a value: return body.require(condition, message)"
        )
    if not isinstance(value, bool | np.bool_):
        raise BuildError(f"require needs a condition, got {value!r}\n  at {authors_line()}")
    if not value:
        raise InfeasibleError(f"{condition}\n  at {authors_line()}")
    return None
