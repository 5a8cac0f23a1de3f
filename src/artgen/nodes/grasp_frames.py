"""Frames at which hands act, given by the author or found on a solid."""

from __future__ import annotations

from typing import Annotated, Any, ClassVar

import numpy as np
from manifold3d import Manifold
from numpy.typing import NDArray

from artgen import _portable
from artgen._arrays import affine
from artgen.asset import Shape
from artgen.asset.affordance import GRIPPER, block, clipped
from artgen.graph import Handle, records
from artgen.nodes.handles import Array3, Scalar, Solid, VectorLike
from artgen.nodes.vector import unit

Array4x4 = Annotated[NDArray[np.float64], "frame"]
"""The value of a `Frame`, shape (4, 4)."""

_DEEPEST = 0.030  # default reach of finger tips behind the front of a deep solid [m]
_FAR = 10.0  # distance beyond any solid [m]
_PARALLEL = 1e-6  # sine of the angle between approach and closing below which they count as parallel
_HOLLOW = 0.001  # depth of a hollow under a finger that counts as the surface [m]
_RAY = 0.001  # half the width of the column in which a surface is searched [m]
_ROUNDED = 6  # decimals of measured lengths [m]


class Frame(Handle):
    """A pose in asset coordinates."""

    __slots__ = ()
    value_type: ClassVar[Any] = Array4x4


def _frame(at: Array3, approach: Array3, closing: Array3) -> Array4x4:
    z = unit(approach)
    sideways = closing - z * _portable.dot(closing, z)
    if not _portable.norm(sideways) > _PARALLEL * _portable.norm(closing):
        raise ValueError(
            f"closing {_text(closing)} must lie across the approach {_text(approach)}; fingers cannot close "
            "in the direction of the approach"
        )
    x = unit(sideways)
    return affine(np.stack([x, np.cross(z, x), z], axis=1), at)


@records(_frame)
def frame(
    at: VectorLike, *, approach: VectorLike = (0.0, 1.0, 0.0), closing: VectorLike = (0.0, 0.0, 1.0)
) -> Frame:
    """Make a frame at which a hand grasps or pushes.

    Args:
        at: Point between the fingers, or under the pushing finger, in asset coordinates [m].
        approach: Direction of approach of the hand.
        closing: Direction along which the fingers close; made perpendicular to `approach`.

    Examples:
        >>> bar = box(0.2, 0.012, 0.012)
        >>> part(bar, "handle", material("steel"), grasp=frame((0, 0, 0), approach=Y, closing=Z))
    """


def _grasp_on(
    solid: Shape, approach: Array3, closing: Array3, at: Array3 | None, depth: float | None
) -> Array4x4:
    middle = solid.bounds().mean(axis=0) if at is None else at
    result = _frame(middle, approach, closing)
    half = GRIPPER.stroke / 2.0
    column = np.array([[-half, -GRIPPER.wide / 2.0, -_FAR], [half, GRIPPER.wide / 2.0, _FAR]])
    points = clipped([solid.manifold], block(column, result), result)
    surrounds = len(points) and points[:, 0].min() < _RAY - half and points[:, 0].max() > half - _RAY
    if not len(points) or (surrounds and not _is_in_middle(solid, result)):
        raise _nothing(middle, at)
    front, back = float(points[:, 2].min()), float(points[:, 2].max())
    reach = min((back - front) / 2.0 + GRIPPER.tip, _DEEPEST) if depth is None else depth
    result[:3, 3] += result[:3, 2] * (front + reach - GRIPPER.tip)
    points = clipped([solid.manifold], block(GRIPPER.between(half), result), result)
    if not len(points):
        raise ValueError(f"fingers that reach {1e3 * reach:.3g} mm deep touch nothing; make depth= larger")
    result[:3, 3] += result[:3, 0] * (points[:, 0].min() + points[:, 0].max()) / 2.0
    result[:3, 3] = np.round(result[:3, 3], _ROUNDED)
    return result


def _is_in_middle(solid: Shape, frame: Array4x4) -> bool:
    """Tell whether a part of a solid lies between the fingers, midway."""
    column = np.array([[-GRIPPER.pad, -GRIPPER.wide / 2.0, -_FAR], [GRIPPER.pad, GRIPPER.wide / 2.0, _FAR]])
    return bool(len(clipped([solid.manifold], block(column, frame), frame)))


def _nothing(middle: Array3, at: Array3 | None) -> ValueError:
    """Return the error of a point at which there is no solid."""
    if at is None:
        return ValueError(
            f"there is nothing at the middle of the solid, {_text(middle)} m; give a point on it: at=..."
        )
    return ValueError(f"there is no part of the solid at {_text(middle)} m; give another point: at=...")


@records(_grasp_on)
def grasp_on(
    solid: Solid,
    *,
    approach: VectorLike = (0.0, 1.0, 0.0),
    closing: VectorLike = (0.0, 0.0, 1.0),
    at: VectorLike | None = None,
    depth: Scalar | None = None,
) -> Frame:
    """Find the frame at which a parallel gripper grasps a solid, for `part(..., grasp=...)`.

    The fingers close on the center of the solid between them, at the middle of its depth. An upright handle
    bar on a front needs `closing=X`, a horizontal bar `closing=Z`, a lever the direction across it. A dial or
    a knob on a panel, or the edge of a lid, needs a `depth` slightly below its height.

    Args:
        solid: The solid to hold: for a handle, the bar without its feet is enough.
        approach: Direction of approach of the hand.
        closing: Direction along which the fingers close, over at most 74 mm.
        at: A point of the grasp; by default the center of the bounding box [m].
        depth: Reach of the finger tips behind the front of the solid; by default 9 mm behind its center, at
            most 30 mm [m].

    Examples:
        >>> bar = box(0.2, 0.012, 0.012)
        >>> part(bar, "handle", material("steel"), grasp=grasp_on(bar, closing=Z))
    """


def _push_on(solid: Shape, direction: Array3, at: Array3 | None) -> Array4x4:
    middle = solid.bounds().mean(axis=0) if at is None else at
    axis = unit(direction)
    sideways = np.eye(3)[int(np.argmin(np.abs(axis)))]
    result = _frame(middle, axis, sideways)
    column = np.array([[-_RAY, -_RAY, -_FAR], [_RAY, _RAY, _FAR]])
    points = clipped([solid.manifold], block(column, result), result)
    if not len(points):
        raise _nothing(middle, at)
    depth = float(points[:, 2].min())
    rod = Manifold.cylinder(2.0 * _FAR, GRIPPER.finger / 2.0, GRIPPER.finger / 2.0, 32)
    points = clipped([solid.manifold], rod.translate((0.0, 0.0, -_FAR)).transform(result[:3]), result)
    first = float(points[:, 2].min())
    if depth - first > _HOLLOW:  # the finger rests on the rim of a hollow
        depth = first
    result[:3, 3] = np.round(result[:3, 3] + axis * depth, _ROUNDED)
    return result


@records(_push_on)
def push_on(solid: Solid, *, direction: VectorLike = (0.0, 1.0, 0.0), at: VectorLike | None = None) -> Frame:
    """Find the point at which a finger first touches a solid to push it, for `part(..., push=...)`.

    Args:
        solid: The solid to push: a button, a flap, a bar, the leaf of a door.
        direction: Direction of the push.
        at: A point on the path of the finger; by default the center of the bounding box [m]. Over a hollow
            that is deeper than 1 mm, the finger stops at its rim.

    Examples:
        >>> cap = cylinder(0.01, 0.006, axis=Y, bevel=0.001)
        >>> part(cap, "button", material("abs"), push=push_on(cap))
    """


def _text(point: Array3) -> str:
    return f"({', '.join(f'{number:.4g}' for number in point)})"
