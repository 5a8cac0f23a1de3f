"""The typed handles: numbers, vectors, profiles, solids and bodies that authors combine."""

import math
from collections.abc import Sequence
from typing import Annotated, Any, ClassVar, Union

import numpy as np
from numpy.typing import NDArray

from artgen.asset import Curve, Outline, Shape, Tree
from artgen.errors import BuildError
from artgen.graph import LITERAL_TYPES, Handle, LiteralType
from artgen.graph.handle import is_sequence
from artgen.graph.node import Node, authors_line
from artgen.materials import Material

Array3 = Annotated[NDArray[np.float64], "vector"]
"""The value of a `Vector`, shape (3,)."""
ArrayN3 = Annotated[NDArray[np.float64], "points"]
"""The value of `Points`, shape (n, 3)."""

Scalar = Union["Float", float, int]
VectorLike = Union["Vector", Sequence["Scalar"], NDArray[np.float64]]
PointsLike = Union["Points", Sequence["VectorLike"], NDArray[np.float64]]
Condition_ = Union["Bool", bool]
Span = tuple[Scalar, Scalar]
"""From where to where something is along an axis [m]."""

LITERAL_TYPES[Material] = LiteralType("material", Material.to_data, Material.from_data)


# tuples: to make a union takes longer than to test for one
_BOOLS = (bool, np.bool_)
_NUMBERS = (float, int, np.floating, np.integer)


def _number(value: Any) -> Any:
    """Return a finite Python float for a number, or NotImplemented."""
    if type(value) is not float and not (isinstance(value, _NUMBERS) and not isinstance(value, _BOOLS)):
        return NotImplemented
    number = float(value)
    if not math.isfinite(number):
        raise BuildError(f"{number} is no finite number\n  at {authors_line()}")
    return number


class Bool(Handle):
    """A truth value."""

    __slots__ = ()
    value_type: ClassVar[Any] = bool

    @classmethod
    def lift(cls, value: Any) -> Any:
        """Accept a Bool or a Python bool."""
        if isinstance(value, _BOOLS):
            return bool(value)
        return super().lift(value)

    def __and__(self, other: Condition_) -> "Bool":
        """Tell whether both hold."""
        return Bool.record("and_", a=self, b=other)

    def __or__(self, other: Condition_) -> "Bool":
        """Tell whether either holds."""
        return Bool.record("or_", a=self, b=other)

    def __invert__(self) -> "Bool":
        """Tell whether it does not hold."""
        return Bool.record("not_", a=self)

    __rand__, __ror__ = __and__, __or__


class Float(Handle):
    """A number."""

    __slots__ = ()
    value_type: ClassVar[Any] = float

    @classmethod
    def lift(cls, value: Any) -> Any:
        """Accept a Float or a finite Python number."""
        return value.node if isinstance(value, Float) else _number(value)

    def _with(self, name: str, a: Any, b: Any) -> Any:
        """Record arithmetic, or let the other operand try."""
        for operand in (a, b):
            if not isinstance(operand, (Float, *_NUMBERS)):
                return NotImplemented
        return (Bool if name in _COMPARISONS else Float).record(name, a=a, b=b)

    def __add__(self, other: Scalar) -> "Float":
        """Add."""
        return self._with("add", self, other)  # type: ignore[no-any-return]

    def __radd__(self, other: Scalar) -> "Float":
        """Add."""
        return self._with("add", other, self)  # type: ignore[no-any-return]

    def __sub__(self, other: Scalar) -> "Float":
        """Subtract."""
        return self._with("subtract", self, other)  # type: ignore[no-any-return]

    def __rsub__(self, other: Scalar) -> "Float":
        """Subtract."""
        return self._with("subtract", other, self)  # type: ignore[no-any-return]

    def __mul__(self, other: Scalar) -> "Float":
        """Multiply."""
        return self._with("multiply", self, other)  # type: ignore[no-any-return]

    def __rmul__(self, other: Scalar) -> "Float":
        """Multiply."""
        return self._with("multiply", other, self)  # type: ignore[no-any-return]

    def __truediv__(self, other: Scalar) -> "Float":
        """Divide."""
        return self._with("divide", self, other)  # type: ignore[no-any-return]

    def __rtruediv__(self, other: Scalar) -> "Float":
        """Divide."""
        return self._with("divide", other, self)  # type: ignore[no-any-return]

    def __pow__(self, other: Scalar) -> "Float":
        """Raise to a power."""
        return self._with("power", self, other)  # type: ignore[no-any-return]

    def __rpow__(self, other: Scalar) -> "Float":
        """Raise to a power."""
        return self._with("power", other, self)  # type: ignore[no-any-return]

    def __mod__(self, other: Scalar) -> "Float":
        """Return the remainder, with the sign of the divisor."""
        return self._with("modulo", self, other)  # type: ignore[no-any-return]

    def __rmod__(self, other: Scalar) -> "Float":
        """Return the remainder, with the sign of the divisor."""
        return self._with("modulo", other, self)  # type: ignore[no-any-return]

    def __neg__(self) -> "Float":
        """Negate."""
        return Float.record("negate", a=self)

    def __abs__(self) -> "Float":
        """Return the magnitude."""
        return Float.record("absolute", a=self)

    def __lt__(self, other: Scalar) -> Bool:
        """Compare."""
        return self._with("less", self, other)  # type: ignore[no-any-return]

    def __gt__(self, other: Scalar) -> Bool:
        """Compare."""
        return self._with("greater", self, other)  # type: ignore[no-any-return]

    def __le__(self, other: Scalar) -> Bool:
        """Compare."""
        return self._with("at_most", self, other)  # type: ignore[no-any-return]

    def __ge__(self, other: Scalar) -> Bool:
        """Compare."""
        return self._with("at_least", self, other)  # type: ignore[no-any-return]


_COMPARISONS = ("less", "greater", "at_most", "at_least")


class Vector(Handle):
    """A point or direction in space."""

    __slots__ = ()
    value_type: ClassVar[Any] = Array3

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

    def __add__(self, other: VectorLike) -> "Vector":
        """Add."""
        return Vector.record("vector_add", a=self, b=other)

    def __radd__(self, other: VectorLike) -> "Vector":
        """Add."""
        return Vector.record("vector_add", a=other, b=self)

    def __sub__(self, other: VectorLike) -> "Vector":
        """Subtract."""
        return Vector.record("vector_subtract", a=self, b=other)

    def __rsub__(self, other: VectorLike) -> "Vector":
        """Subtract."""
        return Vector.record("vector_subtract", a=other, b=self)

    def __mul__(self, factor: Scalar) -> "Vector":
        """Multiply by a number."""
        return Vector.record("vector_scale", vector=self, factor=factor)

    __rmul__ = __mul__

    def __truediv__(self, divisor: Scalar) -> "Vector":
        """Divide by a number."""
        return self * Float.record("divide", a=1.0, b=divisor)

    def __neg__(self) -> "Vector":
        """Point the other way."""
        return Vector.record("vector_scale", vector=self, factor=-1.0)

    def rotate(self, axis: VectorLike, angle: Scalar) -> "Vector":
        """Turn about an axis through the origin by an angle [rad]."""
        return Vector.record("vector_rotate", vector=self, axis=axis, angle=angle)


class Points(Handle):
    """A list of points in space."""

    __slots__ = ()
    value_type: ClassVar[Any] = ArrayN3

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

    def __add__(self, offset: VectorLike) -> "Points":
        """Move all points."""
        return Points.record("points_move", points=self, offset=offset)

    def __sub__(self, offset: VectorLike) -> "Points":
        """Move all points back."""
        return self + Vector.record("vector_scale", vector=offset, factor=-1.0)

    def __mul__(self, factor: Scalar) -> "Points":
        """Multiply all points by a number."""
        return Points.record("points_scale", points=self, factor=factor)

    __radd__, __rmul__ = __add__, __mul__


class Profile(Handle):
    """A region of the plane: x to the right, y up."""

    __slots__ = ()
    value_type: ClassVar[Any] = Outline

    def __or__(self, other: "Profile") -> "Profile":
        """Unite."""
        return Profile.record("profile_union", a=self, b=other)

    def __and__(self, other: "Profile") -> "Profile":
        """Intersect."""
        return Profile.record("profile_intersection", a=self, b=other)

    def __sub__(self, other: "Profile") -> "Profile":
        """Cut away."""
        return Profile.record("profile_difference", a=self, b=other)

    def at(self, x: Scalar, y: Scalar = 0.0) -> "Profile":
        """Move by x and y [m]."""
        return Profile.record("profile_translate", profile=self, x=x, y=y)

    def rotate(self, angle: Scalar) -> "Profile":
        """Turn counter-clockwise about the origin by an angle [rad]."""
        return Profile.record("profile_rotate", profile=self, angle=angle)

    def scale(self, x: Scalar, y: Scalar | None = None) -> "Profile":
        """Scale about the origin; by `x` in both directions unless `y` is given."""
        return Profile.record("profile_scale", profile=self, x=x, y=x if y is None else y)

    def offset(self, distance: Scalar) -> "Profile":
        """Grow by a distance with rounded corners, or shrink by a negative one [m]."""
        return Profile.record("offset", profile=self, distance=distance, join="round")

    def mirror(self, x: Scalar = 1.0, y: Scalar = 0.0) -> "Profile":
        """Reflect in the line through the origin whose normal is (x, y)."""
        return Profile.record("profile_mirror", profile=self, x=x, y=y)


class Path(Handle):
    """A line in space."""

    __slots__ = ()
    value_type: ClassVar[Any] = Curve


class Solid(Handle):
    """A solid in asset coordinates."""

    __slots__ = ()
    value_type: ClassVar[Any] = Shape

    def __or__(self, other: "Solid") -> "Solid":
        """Unite."""
        return Solid.record("union", solids=(self, other))

    def __and__(self, other: "Solid") -> "Solid":
        """Intersect."""
        return Solid.record("intersection", a=self, b=other)

    def __sub__(self, other: "Solid") -> "Solid":
        """Cut away."""
        return Solid.record("difference", a=self, b=other)

    def at(self, x: "Scalar | VectorLike" = 0.0, y: Scalar = 0.0, z: Scalar = 0.0) -> "Solid":
        """Move by a vector, or by x, y and z [m]."""
        return Solid.record("translate", solid=self, offset=offset_of(x, y, z))

    def rotate(self, axis: VectorLike, angle: Scalar, *, about: VectorLike = (0.0, 0.0, 0.0)) -> "Solid":
        """Turn about an axis through the point `about` by an angle [rad]."""
        return Solid.record("rotate", solid=self, axis=axis, angle=angle, about=about)

    def scale(self, x: Scalar, y: Scalar | None = None, z: Scalar | None = None) -> "Solid":
        """Scale about the origin; by `x` in all directions unless the others are given."""
        factors = (x, x if y is None else y, x if z is None else z)
        return Solid.record("scale", solid=self, factors=factors)

    def mirror(self, normal: VectorLike) -> "Solid":
        """Reflect in the plane through the origin with that normal."""
        return Solid.record("mirror", solid=self, normal=normal)

    def align(self, to: VectorLike, *, x: Scalar = 0.0, y: Scalar = 0.0, z: Scalar = 0.0) -> "Solid":
        """Move so that the anchor (x, y, z), each in -1..1, of the bounding box comes to a point [m]."""
        return Solid.record("align", solid=self, to=to, x=x, y=y, z=z)

    def paint(self, material: Material) -> "Solid":
        """Give all faces a material of their own; it stays on them through booleans."""
        return Solid.record("paint", solid=self, material=material)

    def anchor(self, *, x: Scalar = 0.0, y: Scalar = 0.0, z: Scalar = 0.0) -> Vector:
        """Return the point of the bounding box at (x, y, z), each from -1 (low) to 1 (high) [m]."""
        return Vector.record("anchor", solid=self, x=x, y=y, z=z)

    def size(self) -> Vector:
        """Return the lengths of the bounding box [m]."""
        return Vector.record("size", solid=self)

    def bounds(self) -> "Points":
        """Return the two extreme corners of the bounding box, lowest first [m]."""
        return Points.record("bounds", solid=self)

    def centroid(self) -> Vector:
        """Return the centre of volume [m]."""
        return Vector.record("centroid", solid=self)

    def volume(self) -> Float:
        """Return the volume [m^3]."""
        return Float.record("volume", solid=self)

    def area(self) -> Float:
        """Return the area of the surface [m^2]."""
        return Float.record("area", solid=self)


class Body(Handle):
    """A link with everything that is joined to it."""

    __slots__ = ()
    value_type: ClassVar[Any] = Tree

    def attach(self, child: "Body", *joints: Any) -> "Body":
        """Join a child by one joint, or by several that act in order, the first nearest to this body."""
        return Body.record("attach", parent=self, child=child, joints=joints)

    def repeat(self, child: "Body", *joints: Any, at: PointsLike) -> "Body":
        """Join a copy of a child, moved to each point, with copies of its joints; suffixed `_0`, `_1`, ..."""
        return Body.record("repeat", parent=self, child=child, joints=joints, at=at)

    def allow_contact(self, a: str, b: str, *, depth: Scalar, reason: str = "", when: Any = None) -> "Body":
        """Allow pieces of two links to touch or to press into each other by design, as a gasket does.

        Args:
            a: Label of the pieces on one link, such as `"gasket"`; `"door/gasket"` where other links carry
                that label too.
            b: Label of the pieces on the other link.
            depth: How far they may press into each other; 0 where they only touch [m].
            reason: Why they do; the certificate lists it.
            when: Where they may, such as `hinge < 0.02`; by default everywhere.

        Raises:
            BuildError: There is no reason.
        """
        if not str(reason or "").strip():
            raise BuildError(
                f"allow_contact({a!r}, {b!r}) gives no reason\n  at {authors_line()}\n"
                '  Say why they may touch, for those who read the certificate: reason="the gasket seals"'
            )
        return Body.record("allow_contact", body=self, a=a, b=b, depth=depth, reason=reason, when=when)

    def at(self, x: "Scalar | VectorLike" = 0.0, y: Scalar = 0.0, z: Scalar = 0.0) -> "Body":
        """Move by a vector, or by x, y and z [m]."""
        return Body.record("translate_body", body=self, offset=offset_of(x, y, z))

    def rotate(self, axis: VectorLike, angle: Scalar, *, about: VectorLike = (0.0, 0.0, 0.0)) -> "Body":
        """Turn about an axis through the point `about` by an angle [rad]."""
        return Body.record("rotate_body", body=self, axis=axis, angle=angle, about=about)

    def mirror(self, normal: VectorLike) -> "Body":
        """Reflect in the plane through the origin with that normal."""
        return Body.record("mirror_body", body=self, normal=normal)

    def suffixed(self, suffix: str) -> "Body":
        """Add a suffix to the names of all its links, joints, grasps and pushes."""
        return Body.record("suffix", body=self, suffix=suffix)


def offset_of(x: Any, y: Scalar, z: Scalar) -> VectorLike:
    """Return the vector that `.at(vector)` or `.at(x, y, z)` was given.

    Raises:
        BuildError: It was given a vector and more.
    """
    if not isinstance(x, Vector | Sequence | np.ndarray):
        return (x, y, z)
    if any(isinstance(item, Handle) or item != 0.0 for item in (y, z)):
        raise BuildError(
            f".at(...) takes a vector or three numbers, not a vector and numbers\n  at {authors_line()}\n"
            "  Add them to the vector: .at(vector + (x, y, z))"
        )
    return x
