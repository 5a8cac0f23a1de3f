"""Typed handles for authors: profiles, paths, solids, bodies (scalars are in `scalar_handles`)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, ClassVar, Literal, NoReturn

import numpy as np

from artgen._names import NAME_RULE, is_identifier
from artgen.asset import Curve, Outline, Shape, Tree
from artgen.asset.signals import OutputKind
from artgen.errors import BuildError
from artgen.graph import LITERAL_TYPES, Handle, LiteralType
from artgen.graph.node import authors_line
from artgen.materials import Material
from artgen.nodes.scalar_handles import (
    Array3,
    ArrayN3,
    Bool,
    Condition_,
    Float,
    Points,
    PointsLike,
    Scalar,
    Span,
    Vector,
    VectorLike,
)

__all__ = [
    "GRAVITY", "Array3", "ArrayN3", "Body", "Bool", "Condition_", "Float", "Path", "Points", "PointsLike",
    "Profile", "Scalar", "Solid", "Span", "Vector", "VectorLike", "offset_of",
]  # fmt: skip

GRAVITY = 9.81
"""Gravity, by which parts have a weight [m/s^2]."""

LITERAL_TYPES[Material] = LiteralType("material", Material.to_data, Material.from_data)


class Profile(Handle):
    """A region of the plane: x to the right, y up.

    Examples:
        >>> flag = polygon([(0.01, 0), (0.1, 0.03), (0.01, 0.06)]).offset(0.004)
        >>> pole = rectangle(0.2, 0.02).rotate(0.5).at(0, 0.1)
        >>> (flag | flag.mirror() | pole) - circle(0.01).scale(2.0, 1.0)
    """

    __slots__ = ()
    value_type: ClassVar[Any] = Outline

    def __or__(self, other: Profile) -> Profile:
        """Unite."""
        return Profile.record("profile_union", a=self, b=other)

    def __and__(self, other: Profile) -> Profile:
        """Intersect."""
        return Profile.record("profile_intersection", a=self, b=other)

    def __sub__(self, other: Profile) -> Profile:
        """Cut away."""
        return Profile.record("profile_difference", a=self, b=other)

    def at(self, x: Scalar, y: Scalar = 0.0) -> Profile:
        """Move by x and y [m]."""
        return Profile.record("profile_translate", profile=self, x=x, y=y)

    def rotate(self, angle: Scalar) -> Profile:
        """Turn counter-clockwise about the origin by an angle [rad]."""
        return Profile.record("profile_rotate", profile=self, angle=angle)

    def scale(self, x: Scalar, y: Scalar | None = None) -> Profile:
        """Scale about the origin; by `x` in both directions unless `y` is given."""
        return Profile.record("profile_scale", profile=self, x=x, y=x if y is None else y)

    def offset(self, distance: Scalar, *, join: Literal["round", "miter"] = "round") -> Profile:
        """Grow by a distance, or shrink by a negative one [m]; `join` is the shape of the corners."""
        return Profile.record("offset", profile=self, distance=distance, join=join)

    def mirror(self, x: Scalar = 1.0, y: Scalar = 0.0) -> Profile:
        """Reflect in the line through the origin whose normal is (x, y)."""
        return Profile.record("profile_mirror", profile=self, x=x, y=y)


class Path(Handle):
    """A line in space.

    Examples:
        >>> array(sphere(0.01), at=spline([(0, 0, 0), (0.1, 0, 0.05), (0.2, 0, 0)]).points(9))
    """

    __slots__ = ()
    value_type: ClassVar[Any] = Curve

    def points(self, count: int) -> Points:
        """Return evenly spaced points, both ends included [m]; a single point lies in the middle."""
        return Points.record("along", path=self, count=count)

    def profile(self) -> Profile:
        """Return the region inside a closed path in the plane z = 0, with the smooth sides of the path.

        Examples:
            >>> side = spline([(-0.05, 0, 0), (0, 0.03, 0), (0.06, 0.01, 0), (0, -0.02, 0)], closed=True)
            >>> extrude(side.profile(), 0.02)
        """
        return Profile.record("enclosed_by", path=self)


class Solid(Handle):
    """A solid in asset coordinates.

    Examples:
        >>> block = box(0.3, 0.2, 0.1) - cylinder(0.03, 0.3, axis=X)
        >>> balls = array(sphere(0.02), at=block.bounds()) | sphere(0.05).at(block.centroid())
        >>> post = cylinder(block.size().y / 4, block.volume() / block.area()).at(block.anchor(x=-1, z=1))
        >>> ear = box(0.02, 0.05, 0.1).scale(1.0, 1.0, 0.5).rotate(Y, 0.3).at(0.14, 0, 0.06)
        >>> cap = sphere(0.05).split(point=(0, 0, 0.02), normal=Z).paint(material("copper"))
        >>> block | balls | post | ear | ear.mirror(X) | cap.align(block.anchor(z=1), z=-1)
    """

    __slots__ = ()
    value_type: ClassVar[Any] = Shape

    def __or__(self, other: Solid) -> Solid:
        """Unite."""
        return Solid.record("union", solids=(self, other))

    def __and__(self, other: Solid) -> Solid:
        """Intersect."""
        return Solid.record("intersection", a=self, b=other)

    def __sub__(self, other: Solid) -> Solid:
        """Cut away."""
        return Solid.record("difference", a=self, b=other)

    def __add__(self, other: object) -> NoReturn:
        """Refuse a sum.

        Raises:
            BuildError: Always; the message names `|`.
        """
        raise BuildError("solids have no +; a | b unites them, a - b cuts b away, a & b is their common part")

    def split(self, *, point: VectorLike, normal: VectorLike) -> Solid:
        """Keep the part on the side of a plane to which the normal points.

        Args:
            point: A point on the plane [m].
            normal: Normal of the plane, towards the remaining part.
        """
        return Solid.record("split", solid=self, point=point, normal=normal)

    def fillet(self, *, point: VectorLike, normal: VectorLike, radius: Scalar) -> Solid:
        """Add a concave fillet where straight sides of the solid meet a plane, such as a post on a plate.

        Args:
            point: A point on the plane [m].
            normal: Normal of the plane, towards the solid.
            radius: Radius of the fillet [m].

        Raises:
            ValueError: The section at the plane is not convex, or changes within the radius.

        Examples:
            >>> plate = box(0.2, 0.2, 0.02)
            >>> plate | cylinder(0.02, 0.1).at(z=0.055).fillet(point=(0, 0, 0.01), normal=Z, radius=0.01)
        """
        return Solid.record("fillet", solid=self, point=point, normal=normal, radius=radius)

    def at(self, x: Scalar | VectorLike = 0.0, y: Scalar = 0.0, z: Scalar = 0.0) -> Solid:
        """Move by a vector, or by x, y and z [m]."""
        return Solid.record("translate", solid=self, offset=offset_of(x, y, z))

    def rotate(self, axis: VectorLike, angle: Scalar, *, about: VectorLike = (0.0, 0.0, 0.0)) -> Solid:
        """Turn about an axis through the point `about` by an angle [rad]."""
        return Solid.record("rotate", solid=self, axis=axis, angle=angle, about=about)

    def scale(self, x: Scalar, y: Scalar | None = None, z: Scalar | None = None) -> Solid:
        """Scale about the origin; by `x` in all directions unless the others are given."""
        factors = (x, x if y is None else y, x if z is None else z)
        return Solid.record("scale", solid=self, factors=factors)

    def mirror(self, normal: VectorLike) -> Solid:
        """Reflect in the plane through the origin with that normal."""
        return Solid.record("mirror", solid=self, normal=normal)

    def align(self, to: VectorLike, *, x: Scalar = 0.0, y: Scalar = 0.0, z: Scalar = 0.0) -> Solid:
        """Move so that the anchor (x, y, z), each in -1..1, of the bounding box comes to a point [m]."""
        return Solid.record("align", solid=self, to=to, x=x, y=y, z=z)

    def paint(self, material: Material) -> Solid:
        """Give all faces their own material, which stays on them through booleans."""
        return Solid.record("paint", solid=self, material=material)

    def anchor(self, *, x: Scalar = 0.0, y: Scalar = 0.0, z: Scalar = 0.0) -> Vector:
        """Return the point of the bounding box at (x, y, z), each from -1 (low) to 1 (high) [m]."""
        return Vector.record("anchor", solid=self, x=x, y=y, z=z)

    def size(self) -> Vector:
        """Return the lengths of the bounding box [m]."""
        return Vector.record("size", solid=self)

    def bounds(self) -> Points:
        """Return the two extreme corners of the bounding box, lowest first [m]."""
        return Points.record("bounds", solid=self)

    def centroid(self) -> Vector:
        """Return the center of volume [m]."""
        return Vector.record("centroid", solid=self)

    def volume(self) -> Float:
        """Return the volume [m^3]."""
        return Float.record("volume", solid=self)

    def area(self) -> Float:
        """Return the area of the surface [m^2]."""
        return Float.record("area", solid=self)


class Body(Handle):
    """A link with all links joined to it.

    Examples:
        >>> arm = part(box(0.2, 0.05, 0.02), "arm", material("steel")).rotate(Y, -0.5).at(0.15)
        >>> left, right = arm.mirror(X).suffixed("_left"), arm.suffixed("_right")
        >>> post = part(cylinder(0.03, 0.3), "post", material("oak"))
        >>> mark = detail(torus(0.031, 0.002).at(post.center_of_mass()), "mark", material("brass"))
        >>> post = weld(post, mark).attach(left, Revolute("turn_left", axis=Z, limits=(0, 1)))
        >>> post.attach(right, Revolute("turn_right", axis=Z, limits=(0, 1), friction=0.1 * right.mass()))
    """

    __slots__ = ()
    value_type: ClassVar[Any] = Tree

    def __or__(self, other: object) -> NoReturn:
        """Refuse operations on the solids of bodies, whose operations have other names.

        Raises:
            BuildError: Always; the message names `weld` and `attach`.
        """
        raise BuildError(
            "bodies have no |, -, & and +, which are for solids; weld(a, b) joins bodies rigidly to one "
            "link, a.attach(b, joint) by a joint; cut a solid before part(...) makes a body of it"
        )

    __ror__ = __sub__ = __rsub__ = __and__ = __rand__ = __add__ = __radd__ = __or__

    def mass(self) -> Float:
        """Return the mass with all links joined to this one [kg]."""
        return Float.record("mass", body=self)

    def weight(self) -> Float:
        """Return the weight with all links joined to this one [N].

        Examples:
            >>> seat = part(box(0.4, 0.4, 0.05), "seat", material("oak"))
            >>> column = part(cylinder(0.02, 0.4).at(z=-0.25), "column", material("steel"))
            >>> column.attach(seat, Prismatic("lift", axis=Z, limits=(0, 0.1), friction=1.5 * seat.weight()))
        """
        return GRAVITY * self.mass()

    def center_of_mass(self) -> Vector:
        """Return the center of mass with all links joined to this one, at rest [m]."""
        return Vector.record("center_of_mass", body=self)

    def attach(self, child: Body, *joints: Any, at: VectorLike = (0.0, 0.0, 0.0)) -> Body:
        """Join a child by one joint, or by several that act in order, the first nearest to this body.

        Args:
            child: The child, at its place or, with `at`, about the origin.
            *joints: The joints.
            at: Place to which the child and the pivots of its joints are moved together [m].

        Examples:
            >>> case = part(box(0.3, 0.2, 0.1), "case", material("walnut"))
            >>> dial = part(cylinder(0.02, 0.01, axis=Y).at(y=-0.0055), "dial", material("abs"))
            >>> case.attach(dial, Revolute("turn", axis=Y, limits=(0, 3)), at=(0.1, -0.1, 0))
        """
        if child is self:
            raise BuildError(f"attach: a body cannot be attached to itself\n  at {authors_line()}")
        return Body.record("attach", parent=self, child=child, joints=steps_of(joints), at=at)

    def attach_pair(
        self,
        child: Body,
        *joints: Any,
        normal: VectorLike = (1.0, 0.0, 0.0),
        suffixes: tuple[str, str] = ("_right", "_left"),
    ) -> Body:
        """Join a child, and its mirror image with mirrored joints, which move independently.

        Args:
            child: The child on the side to which `normal` points.
            *joints: Its joints.
            normal: Normal of the plane through the origin in which the second child is the image.
            suffixes: Suffixes of the names of links and joints: of the child, and of its image.

        Examples:
            >>> case = part(box(0.4, 0.02, 0.5), "case", material("walnut"))
            >>> door = part(box(0.196, 0.02, 0.5).at(0.1, -0.022), "door", material("oak"))
            >>> case.attach_pair(door, Revolute("hinge", axis=Z, pivot=(0.2, -0.032, 0), limits=(0, 1.5)))
        """
        return Body.record(
            "attach_pair", parent=self, child=child, joints=steps_of(joints), normal=normal, suffixes=suffixes
        )

    def cut(self, tool: Solid) -> Body:
        """Cut a solid out of all pieces of this link; pieces that it contains vanish.

        Examples:
            >>> panel = part(box(0.1, 0.012, 0.05), "panel", material("abs"))
            >>> panel.cut(cylinder(0.01, 0.05, axis=Y))
        """
        return Body.record("cut", body=self, tool=tool)

    def install(self, fitting: Any, *, at: VectorLike = (0.0, 0.0, 0.0)) -> Body:
        """Install a `Fitting`: cut its hole, weld its fixed parts to this link, and join its moving links.

        Args:
            fitting: The fitting, about the origin on the plane y = 0 of its host; or a body to be welded.
            at: Place on the host [m].

        Examples:
            >>> panel = part(box(0.1, 0.012, 0.05).at(y=0.006), "panel", material("abs"))
            >>> stop = part(cylinder(0.008, 0.01, axis=Y).at(y=-0.0048), "stop", material("rubber"))
            >>> panel.install(stop, at=(0.03, 0, 0)).install(stop, at=(-0.03, 0, 0))
        """
        _check_fitting("install", fitting)
        placed = fitting.at(at)
        if isinstance(placed, Body):
            return Body.record("weld", bodies=(self, placed))
        host = self if placed.cut is None else self.cut(placed.cut)
        return Body.record("weld", bodies=(host, placed.body))

    def repeat(self, child: Any, *joints: Any, at: PointsLike, around: VectorLike | None = None) -> Body:
        """Join a copy of a child at each point, with copies of its joints, suffixed `_0`, `_1`, ...

        Args:
            child: The child, modeled about the origin; or a `Fitting`, which has its own joints.
            *joints: Joints of the child; their pivots and axes move and turn with each copy.
            at: Place of each copy [m].
            around: Axis through the middle of the points about which the copies are turned like the points:
                the first one is not turned. By default none is turned.

        Examples:
            >>> panel = part(box(0.2, 0.02, 0.05), "panel", material("abs"))
            >>> key = part(cylinder(0.008, 0.006, axis=Y).at(y=-0.0135), "key", material("black_abs"))
            >>> press = Prismatic("press", axis=Y, limits=(0, 0.002), spring=Spring(stiffness=500.0))
            >>> panel.repeat(key, press, at=row((-0.06, 0, 0), (0.04, 0, 0), 4))
        """
        if isinstance(child, Body):
            steps = steps_of(joints)
            return Body.record("repeat", parent=self, child=child, joints=steps, at=at, around=around)
        _check_fitting("repeat", child)
        if joints:
            raise BuildError(f"repeat: a fitting has its own joints; leave joints out\n  at {authors_line()}")
        copies = Body.record("copies", body=child.body, at=at, around=around)
        if child.cut is None:
            return Body.record("weld", bodies=(self, copies))
        holes = Solid.record("array", solid=child.cut, at=at, around=around)
        return Body.record("weld", bodies=(self.cut(holes), copies))

    def allow_contact(self, a: str, b: str, *, depth: Scalar, reason: str = "", when: Any = None) -> Body:
        """Allow pieces of two links to touch or to penetrate each other, like a gasket and its frame.

        Args:
            a: Label of the pieces on one link, such as `"gasket"`; `"door/gasket"` if other links have that
                label too.
            b: Label of the pieces on the other link.
            depth: Largest allowed penetration; 0 for contact only [m].
            reason: Reason for the contact, listed in the certificate.
            when: Condition under which the contact is allowed, such as `hinge < 0.02`; by default always.

        Raises:
            BuildError: The reason is missing.

        Examples:
            >>> base = part(box(0.1, 0.1, 0.02), "base", material("steel"))
            >>> pad = part(cylinder(0.03, 0.02).at(z=0.0195), "pad", material("rubber"))
            >>> both = base.attach(pad, Revolute("turn", axis=Z, limits=(0, 1)))
            >>> both.allow_contact("pad", "base", depth=0.001, reason="the pad is pressed on the base")
        """
        if not str(reason or "").strip():
            raise BuildError(
                f"allow_contact({a!r}, {b!r}) gives no reason\n  at {authors_line()}\n"
                '  Give the reason, which the certificate lists: reason="the gasket seals"'
            )
        return Body.record("allow_contact", body=self, a=a, b=b, depth=depth, reason=reason, when=when)

    def loop(self, a: str, b: str, *, at: VectorLike, axis: VectorLike, driver: Any) -> Body:
        """Pin two links together, which closes a planar chain with one input, such as a four-bar linkage.

        The pin determines two joints of the chain beside the input: they have no limits of their own, and
        follow the input, solved to 1e-9. The joints turn about axes parallel to the pin, or slide across it.
        Where the chain would not close, an error names the input and its position. A chain on top of another
        one, with the same input, is declared after it.

        Args:
            a: Name of a link.
            b: Name of the link that is pinned to it.
            at: A point on the pin in asset coordinates at rest [m].
            axis: Direction of the pin.
            driver: The input: a joint that is attached, has limits or turns endlessly, and follows no other.

        Examples:
            >>> def bar(name, start, end, y):
            ...     disc = cylinder(0.008, 0.005, axis=Y)
            ...     return part(hull(disc.at(*start).at(y=y), disc.at(*end).at(y=y)), name, material("steel"))
            >>> o, a, b, c = (0, 0, 0), (0, 0, 0.03), (0.1, 0, 0.07), (0.12, 0, 0)
            >>> turn = Revolute("crank_turn", axis=Y, pivot=o)
            >>> rod = bar("rod", a, b, -0.012)
            >>> crank = bar("crank", o, a, -0.006).attach(rod, Revolute("rod_turn", axis=Y, pivot=a))
            >>> base = bar("base", o, c, 0).attach(crank, turn)
            >>> base = base.attach(bar("rocker", c, b, -0.006), Revolute("rocker_turn", axis=Y, pivot=c))
            >>> base.loop("rod", "rocker", at=b, axis=Y, driver=turn)
        """
        return Body.record("loop", body=self, a=a, b=b, at=at, axis=axis, driver=driver.name)

    def output(
        self,
        name: str,
        signal: Any,
        *,
        kind: OutputKind,
        material: Material | None = None,
        color: Sequence[Scalar] = (),
        moves: Any = None,
        speed: Scalar | None = None,
    ) -> Body:
        """Give the product an output, such as a light or a motor, which joints control.

        Args:
            name: Identifier, unique in the asset.
            signal: Its value from 0 to 1, from `artgen.signals`, or a condition such as `door > 0.05`.
            kind: `light`, `heat`, `motor`, `flow` of water, air or gas, `display` or `sound`.
            material: Material that shines with the output; no other part has it.
            color: Emission of that material at 1, linear RGB; by default warm white, red for heat.
            moves: Joint that a motor moves, or its name; its own `driven` names the motor.
            speed: Speed of that joint at 1 [rad/s or m/s].

        Examples:
            >>> opal = material("frosted_glass").with_(name="bulb")
            >>> socket = part(cylinder(0.02, 0.03).at(z=-0.02), "socket", material("abs"))
            >>> lamp = weld(socket, part(sphere(0.03).at(z=0.0245), "bulb", opal))
            >>> key = part(cylinder(0.004, 0.006, axis=X).at(0.0235, 0, -0.02), "button", material("abs"))
            >>> press = Prismatic("press", axis=-X, limits=(0, 0.0004), spring=Spring(stiffness=4000.0))
            >>> on = signals.toggle(signals.pressed(press))
            >>> lamp.attach(key, press).output("light", on, kind="light", material=opal, color=(1, 0.8, 0.6))
        """
        return Body.record(
            "output",
            body=self,
            name=name,
            signal=signal,
            kind=kind,
            material=None if material is None else material.name,
            color=tuple(color),
            joint=getattr(moves, "name", moves),
            speed=speed,
        )

    def at(self, x: Scalar | VectorLike = 0.0, y: Scalar = 0.0, z: Scalar = 0.0) -> Body:
        """Move by a vector, or by x, y and z [m]."""
        return Body.record("translate_body", body=self, offset=offset_of(x, y, z))

    def rotate(self, axis: VectorLike, angle: Scalar, *, about: VectorLike = (0.0, 0.0, 0.0)) -> Body:
        """Turn about an axis through the point `about` by an angle [rad]."""
        return Body.record("rotate_body", body=self, axis=axis, angle=angle, about=about)

    def mirror(self, normal: VectorLike) -> Body:
        """Reflect in the plane through the origin with that normal."""
        return Body.record("mirror_body", body=self, normal=normal)

    def suffixed(self, suffix: str) -> Body:
        """Add a suffix to the names of all its links, joints, grasps and pushes."""
        if not is_identifier(f"x{suffix}"):
            raise BuildError(
                f"suffix {suffix!r} cannot end a name; use {NAME_RULE}, such as '_left'\n"
                f"  at {authors_line()}"
            )
        return Body.record("suffix", body=self, suffix=suffix)


def steps_of(joints: Sequence[Any]) -> tuple[Any, ...]:
    """Return joints of one degree of freedom each in place of joints: a screw is two."""
    return tuple(step for joint in joints for step in getattr(joint, "steps", (joint,)))


def _check_fitting(method: str, value: Any) -> None:
    if not isinstance(getattr(value, "body", value), Body):
        raise BuildError(f"{method}(...) needs a Fitting or a Body, got {value!r}\n  at {authors_line()}")


def offset_of(x: Any, y: Scalar, z: Scalar) -> VectorLike:
    """Return the vector of the arguments of `.at(vector)` or `.at(x, y, z)`."""
    if not isinstance(x, Vector | Sequence | np.ndarray):
        return (x, y, z)
    if any(isinstance(item, Handle) or item != 0.0 for item in (y, z)):
        raise BuildError(
            f".at(...) takes a vector or three numbers, not a vector and numbers\n  at {authors_line()}\n"
            "  Add them to the vector: .at(vector + (x, y, z))"
        )
    return x
