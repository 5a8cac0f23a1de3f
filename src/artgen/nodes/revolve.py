"""Lathe work: a profile turned about an axis."""

import math

from artgen.asset.outline import Contour, Outline
from artgen.asset.shape import Shape
from artgen.graph import kernel
from artgen.nodes import validators as inputs
from artgen.nodes.handles import Array3, Profile, Scalar, Solid, VectorLike
from artgen.nodes.primitive_colliders import around_lathe, moved
from artgen.nodes.surfaces import lathe

_ON_AXIS = 1e-7  # [m]: points nearer to the axis lie on it
_FEWEST, _MOST = 3, 128  # sides of a full turn


@kernel
def _revolve(profile: Outline, angle: float, axis: Array3, sides: int = 0) -> Shape:
    inputs.between("angle", angle, 0.001, math.tau + 1e-9, "rad")
    if sides != 0 and not _FEWEST <= sides <= _MOST:
        raise ValueError(
            f"a lathe makes {_FEWEST} to {_MOST} sides, or 0 for as many as look round; got {sides}"
        )
    least = min(float(contour.points[:, 0].min()) for contour in profile.contours)
    if least < -_ON_AXIS:
        raise ValueError(
            f"the profile reaches x = {least:g} m; all of it must be at x >= 0, which is the radius "
            "(profile.at(x, y) moves it)"
        )
    contours = []
    for contour in profile.contours:
        points = contour.points.copy()
        points[points[:, 0] < _ON_AXIS, 0] = 0.0
        contours.append(Contour(points, contour.normals_in, contour.normals_out))
    turn = inputs.frame(axis)
    pieces = around_lathe(contours, angle, sides or None)
    skin = lathe(contours, angle=angle, sides=sides or None)
    return skin.turned(turn).shape(moved(pieces, inputs.pose(turn)))


def revolve(
    profile: Profile, *, angle: Scalar = math.tau, axis: VectorLike = (0.0, 0.0, 1.0), sides: int = 0
) -> Solid:
    """Turn a profile about an axis through the origin: its x is the radius, its y runs along the axis.

    Args:
        profile: What to turn, all of it at x >= 0.
        angle: How far [rad], right-handed about the axis from X on (from Y on for an axis along X).
        axis: Direction of the axis.
        sides: Facets of the full circle; 0 for as many as look round. A hollow thing collides as one piece
            for each of them and for each bend of the profile, so a thin shell wants few.

    Examples:
        >>> revolve(rectangle(0.04, 0.1, radius=0.01).at(0.08), angle=4.5)
    """
    return Solid.record(_revolve, profile=profile, angle=angle, axis=axis, sides=sides)
