"""Numbers and truth values: arithmetic, functions, comparisons, logic."""

import math

from artgen.graph import kernel
from artgen.nodes.handles import Bool, Condition_, Float, Scalar


@kernel(spelling="({a} + {b})")
def _add(a: float, b: float) -> float:
    return a + b


@kernel(spelling="({a} - {b})")
def _subtract(a: float, b: float) -> float:
    return a - b


@kernel(spelling="({a} * {b})")
def _multiply(a: float, b: float) -> float:
    return a * b


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


@kernel(spelling="(-{a})")
def _negate(a: float) -> float:
    return -a


@kernel(spelling="abs({a})")
def _absolute(a: float) -> float:
    return abs(a)


@kernel(spelling="({a} < {b})")
def _less(a: float, b: float) -> bool:
    return a < b


@kernel(spelling="({a} > {b})")
def _greater(a: float, b: float) -> bool:
    return a > b


@kernel(spelling="({a} <= {b})")
def _at_most(a: float, b: float) -> bool:
    return a <= b


@kernel(spelling="({a} >= {b})")
def _at_least(a: float, b: float) -> bool:
    return a >= b


@kernel
def _and_(a: bool, b: bool) -> bool:
    return a and b


def and_(a: Condition_, b: Condition_) -> Bool:
    """Tell whether both conditions hold; also written `a & b`."""
    return Bool.record("and_", a=a, b=b)


@kernel
def _or_(a: bool, b: bool) -> bool:
    return a or b


def or_(a: Condition_, b: Condition_) -> Bool:
    """Tell whether at least one of the conditions holds; also written `a | b`."""
    return Bool.record("or_", a=a, b=b)


@kernel
def _not_(a: bool) -> bool:
    return not a


def not_(a: Condition_) -> Bool:
    """Tell whether the condition does not hold; also written `~a`."""
    return Bool.record("not_", a=a)


@kernel
def _min_(a: float, b: float) -> float:
    return min(a, b)


def min_(a: Scalar, b: Scalar) -> Float:
    """Return the smaller of two numbers.

    Examples:
        >>> block = box(0.3, 0.2, 0.1)
        >>> size = block.size()
        >>> block - bore(0.4 * min_(size.x, size.y), 0.2)
    """
    return Float.record("min_", a=a, b=b)


@kernel
def _max_(a: float, b: float) -> float:
    return max(a, b)


def max_(a: Scalar, b: Scalar) -> Float:
    """Return the larger of two numbers.

    Examples:
        >>> block = box(0.3, 0.2, 0.1)
        >>> size = block.size()
        >>> block | cylinder(0.6 * max_(size.x, size.y), 0.01)
    """
    return Float.record("max_", a=a, b=b)


@kernel
def _clamp(value: float, low: float, high: float) -> float:
    if low > high:
        raise ValueError(f"clamp between {low:.6g} and {high:.6g}: low exceeds high")
    return min(max(value, low), high)


def clamp(value: Scalar, low: Scalar, high: Scalar) -> Float:
    """Return the number between `low` and `high` that is nearest to `value`.

    Examples:
        >>> heights = [clamp(0.015 * i, 0.03, 0.1) for i in range(10)]
        >>> union(*(box(0.02, 0.03, h).align((0.02 * i, 0, 0), z=-1) for i, h in enumerate(heights)))
    """
    return Float.record(_clamp, value=value, low=low, high=high)


@kernel
def _sqrt(a: float) -> float:
    if a < 0.0:
        raise ValueError(f"square root of {a:.6g}")
    return math.sqrt(a)


def sqrt(a: Scalar) -> Float:
    """Return the square root.

    Examples:
        >>> heights = [0.04 * sqrt(i + 1) for i in range(10)]
        >>> union(*(box(0.02, 0.03, h).align((0.02 * i, 0, 0), z=-1) for i, h in enumerate(heights)))
    """
    return Float.record(_sqrt, a=a)


@kernel
def _sin(a: float) -> float:
    return math.sin(a)


def sin(a: Scalar) -> Float:
    """Return the sine of an angle [rad].

    Examples:
        >>> heights = [0.08 + 0.05 * sin(0.5 * i) for i in range(13)]
        >>> union(*(box(0.02, 0.03, h).align((0.02 * i, 0, 0), z=-1) for i, h in enumerate(heights)))
    """
    return Float.record(_sin, a=a)


@kernel
def _cos(a: float) -> float:
    return math.cos(a)


def cos(a: Scalar) -> Float:
    """Return the cosine of an angle [rad].

    Examples:
        >>> heights = [0.08 + 0.05 * cos(0.5 * i) for i in range(13)]
        >>> union(*(box(0.02, 0.03, h).align((0.02 * i, 0, 0), z=-1) for i, h in enumerate(heights)))
    """
    return Float.record(_cos, a=a)


@kernel
def _tan(a: float) -> float:
    return math.tan(a)


def tan(a: Scalar) -> Float:
    """Return the tangent of an angle [rad].

    Examples:
        >>> rise = 0.3 * tan(0.5)
        >>> wedge(0.1, 0.3, rise)
    """
    return Float.record(_tan, a=a)


@kernel
def _atan2(y: float, x: float) -> float:
    return math.atan2(y, x)


def atan2(y: Scalar, x: Scalar) -> Float:
    """Return the angle of the direction (x, y), from -pi to pi [rad].

    Examples:
        >>> box(0.3, 0.02, 0.02).rotate(Z, atan2(0.1, 0.2)) | sphere(0.03).at(0.2, 0.1)
    """
    return Float.record(_atan2, y=y, x=x)


@kernel
def _floor(a: float) -> float:
    return float(math.floor(a))


def floor(a: Scalar) -> Float:
    """Return the largest whole number not above `a`; also written `math.floor(a)`."""
    return Float.record(_floor, a=a)


@kernel
def _round_(a: float) -> float:
    return float(round(a))


def round_(a: Scalar) -> Float:
    """Return the nearest whole number, of two the even one; also written `round(a)`."""
    return Float.record("round_", a=a)
