"""Typed handles of numbers: truth values, numbers, vectors and lists of points."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Annotated, Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from artgen.errors import BuildError
from artgen.graph import Handle
from artgen.graph.handle import is_sequence, of_numbers
from artgen.graph.node import Node, authors_line

Array3 = Annotated[NDArray[np.float64], "vector"]
"""The value of a `Vector`, shape (3,)."""
ArrayN3 = Annotated[NDArray[np.float64], "points"]
"""The value of `Points`, shape (n, 3)."""

# tuples: building a union type takes longer than an isinstance test
_BOOLS = (bool, np.bool_)
_NUMBERS = (float, int, np.floating, np.integer)


def _number(value: Any) -> Any:
    """Return a Python float for a finite number, or NotImplemented."""
    if type(value) is not float and not (isinstance(value, _NUMBERS) and not isinstance(value, _BOOLS)):
        return NotImplemented
    number = float(value)
    return number if math.isfinite(number) else NotImplemented


class Bool(Handle):
    """A truth value.

    Examples:
        >>> block = box(0.3, 0.2, 0.1)
        >>> wide = (block.size().x > 0.2) & ~(block.size().y > 0.4)
        >>> switch(wide, block, sphere(0.1))
    """

    __slots__ = ()
    value_type: ClassVar[Any] = bool
    folds: ClassVar[bool] = True

    @classmethod
    def lift(cls, value: Any) -> Any:
        """Accept a Bool or a Python bool."""
        if isinstance(value, _BOOLS):
            return bool(value)
        return super().lift(value)

    def __and__(self, other: Condition_) -> Bool:
        """Tell whether both hold."""
        return Bool.record("and_", a=self, b=other)

    def __or__(self, other: Condition_) -> Bool:
        """Tell whether either holds."""
        return Bool.record("or_", a=self, b=other)

    def __invert__(self) -> Bool:
        """Tell whether it does not hold."""
        return Bool.record("not_", a=self)

    __rand__, __ror__ = __and__, __or__


def _arithmetic(
    operation: str, doc: str
) -> tuple[Callable[[Float, Scalar], Float], Callable[[Float, Scalar], Float]]:
    """Return the methods of an operator with the handle on the left and on the right."""

    def record(a: Scalar, b: Scalar) -> Float:
        first, second = (each.node if type(each) is Float else each for each in (a, b))
        known = of_numbers(operation, first, second)
        return Float.record(operation, a=a, b=b) if known is None else Float(known)

    def left(self: Float, other: Scalar) -> Float:
        return record(self, other) if _is_scalar(other) else NotImplemented

    def right(self: Float, other: Scalar) -> Float:
        return record(other, self) if _is_scalar(other) else NotImplemented

    left.__doc__ = right.__doc__ = doc
    return left, right


def _comparison(operation: str) -> Callable[[Float, Scalar], Bool]:
    """Return the method of a comparison."""

    def compare(self: Float, other: Scalar) -> Bool:
        """Compare."""
        return Bool.record(operation, a=self, b=other) if _is_scalar(other) else NotImplemented

    return compare


def _is_scalar(value: Any) -> bool:
    return isinstance(value, (Float, *_NUMBERS))


class Float(Handle):
    """A number.

    Examples:
        >>> block = box(0.3, 0.2, 0.1)
        >>> half = block.size().x / 2 - 0.01
        >>> block | box(2 * half, 0.1, 0.1).at(z=half / 2)
    """

    __slots__ = ()
    value_type: ClassVar[Any] = float
    folds: ClassVar[bool] = True

    @classmethod
    def lift(cls, value: Any) -> Any:
        """Accept a Float or a finite Python number."""
        return value.node if isinstance(value, Float) else _number(value)

    __add__, __radd__ = _arithmetic("add", "Add.")
    __sub__, __rsub__ = _arithmetic("subtract", "Subtract.")
    __mul__, __rmul__ = _arithmetic("multiply", "Multiply.")
    __truediv__, __rtruediv__ = _arithmetic("divide", "Divide.")
    __pow__, __rpow__ = _arithmetic("power", "Raise to a power.")
    __mod__, __rmod__ = _arithmetic("modulo", "Return the remainder, with the sign of the divisor.")
    __lt__, __gt__ = _comparison("less"), _comparison("greater")
    __le__, __ge__ = _comparison("at_most"), _comparison("at_least")

    def __neg__(self) -> Float:
        """Negate."""
        return Float.record("negate", a=self)

    def __abs__(self) -> Float:
        """Return the magnitude."""
        return Float.record("absolute", a=self)

    def __floor__(self) -> Float:
        """Return the largest whole number not above it: `math.floor(a)`."""
        return Float.record("floor", a=self)

    def __round__(self, digits: int | None = None) -> Float:
        """Return the nearest whole number, of two the even one: `round(a)`."""
        if digits is not None:
            raise BuildError(
                f"round(a, {digits}) rounds to whole numbers only: scale the number before and after it\n"
                f"  at {authors_line()}"
            )
        return Float.record("round_", a=self)


class Vector(Handle):
    """A point or direction in space.

    Examples:
        >>> tip = vector(0.15, 0.1, 0.0) + (0, 0, 0.02)
        >>> up, shadow = 0.2 * tip.cross(Y).normalized(), tip.dot(X) * X
        >>> tips = (tip, tip.rotate(Z, 1.0), up, shadow)
        >>> union(torus(tip.norm(), 0.005), *(cylinder_between((0, 0, 0), each, 0.006) for each in tips))
    """

    __slots__ = ()
    value_type: ClassVar[Any] = Array3
    folds: ClassVar[bool] = True

    @classmethod
    def lift(cls, value: Any) -> Any:
        """Accept a Vector or three scalars."""
        if isinstance(value, Vector):
            return value.node
        if not is_sequence(value) or len(value) != 3:
            return NotImplemented
        scalars = tuple(Float.lift(item) for item in value)
        if any(item is NotImplemented for item in scalars):
            return NotImplemented
        if any(isinstance(item, Node) for item in scalars):
            return Vector.record("vector", x=value[0], y=value[1], z=value[2]).node
        return scalars

    @classmethod
    def decode(cls, literal: Any) -> Any:
        """Return the array of three numbers."""
        return np.array(literal, float)

    @property
    def x(self) -> Float:
        """The component along x."""
        return Float.record("component", vector=self, index=0)

    @property
    def y(self) -> Float:
        """The component along y."""
        return Float.record("component", vector=self, index=1)

    @property
    def z(self) -> Float:
        """The component along z."""
        return Float.record("component", vector=self, index=2)

    def __add__(self, other: VectorLike) -> Vector:
        """Add."""
        return Vector.record("vector_add", a=self, b=other)

    def __radd__(self, other: VectorLike) -> Vector:
        """Add."""
        return Vector.record("vector_add", a=other, b=self)

    def __sub__(self, other: VectorLike) -> Vector:
        """Subtract."""
        return Vector.record("vector_subtract", a=self, b=other)

    def __rsub__(self, other: VectorLike) -> Vector:
        """Subtract."""
        return Vector.record("vector_subtract", a=other, b=self)

    def __mul__(self, factor: Scalar) -> Vector:
        """Multiply by a number."""
        return Vector.record("vector_scale", vector=self, factor=factor)

    __rmul__ = __mul__

    def __truediv__(self, divisor: Scalar) -> Vector:
        """Divide by a number."""
        return self * Float.record("divide", a=1.0, b=divisor)

    def __neg__(self) -> Vector:
        """Reverse the direction."""
        return Vector.record("vector_scale", vector=self, factor=-1.0)

    def norm(self) -> Float:
        """Return the length."""
        return Float.record("norm", vector=self)

    def normalized(self) -> Vector:
        """Return the vector of length one in the same direction."""
        return Vector.record("normalize", vector=self)

    def dot(self, other: VectorLike) -> Float:
        """Return the scalar product with another vector."""
        return Float.record("dot", a=self, b=other)

    def cross(self, other: VectorLike) -> Vector:
        """Return the vector product with another vector."""
        return Vector.record("cross", a=self, b=other)

    def rotate(self, axis: VectorLike, angle: Scalar) -> Vector:
        """Turn about an axis through the origin by an angle [rad]."""
        return Vector.record("vector_rotate", vector=self, axis=axis, angle=angle)


class Points(Handle):
    """A list of points in space.

    Examples:
        >>> holes = row((0, 0, 0), (0.04, 0, 0), 5) + (-0.08, 0, 0)
        >>> box(0.22, 0.05, 0.02) - array(bore(0.012, 0.1), at=holes)
    """

    __slots__ = ()
    value_type: ClassVar[Any] = ArrayN3
    folds: ClassVar[bool] = True

    @classmethod
    def lift(cls, value: Any) -> Any:
        """Accept Points or a sequence of vectors."""
        if isinstance(value, Points):
            return value.node
        if not is_sequence(value) or not len(value):
            return NotImplemented
        vectors = tuple(Vector.lift(item) for item in value)
        if any(item is NotImplemented for item in vectors):
            return NotImplemented
        if any(isinstance(item, Node) for item in vectors):
            return Points.record("points", vectors=value).node
        return vectors

    @classmethod
    def decode(cls, literal: Any) -> Any:
        """Return the array of points."""
        return np.array(literal, float).reshape(-1, 3)

    def __add__(self, offset: VectorLike) -> Points:
        """Move all points."""
        return Points.record("points_move", points=self, offset=offset)

    def __sub__(self, offset: VectorLike) -> Points:
        """Move all points back."""
        return self + Vector.record("vector_scale", vector=offset, factor=-1.0)

    def __mul__(self, factor: Scalar) -> Points:
        """Multiply all points by a number."""
        return Points.record("points_scale", points=self, factor=factor)

    __radd__, __rmul__ = __add__, __mul__


# defined after the classes, so that they hold no names that only this module can resolve
Scalar = Float | float | int
VectorLike = Vector | Sequence[Scalar] | NDArray[np.float64]
PointsLike = Points | Sequence[VectorLike] | NDArray[np.float64]
Condition_ = Bool | bool
Span = tuple[Scalar, Scalar]
"""Extent along an axis: lowest and highest coordinate [m]."""
