"""Extrusion of a profile along an axis, and revolution about an axis."""

import math
from collections.abc import Callable, Sequence

import numpy as np

from artgen._arrays import Array, successors
from artgen.asset.shape import Contour, Outline, Shape
from artgen.graph import kernel
from artgen.nodes import validators as inputs
from artgen.nodes.contours import is_disjoint, moved_outline, refined
from artgen.nodes.handles import Array3, Profile, Scalar, Solid, VectorLike
from artgen.nodes.primitive_colliders import around_extrusion, around_lathe, moved
from artgen.nodes.surfaces import extrusion, lathe, mitres

_ON_AXIS = 1e-7  # points nearer to the axis than this lie on it [m]
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
    """Revolve a profile about an axis through the origin: its x is the radius, its y runs along the axis.

    Args:
        profile: The profile, at x >= 0.
        angle: Angle [rad], right-handed about the axis, starting at X (at Y for an axis along X).
        axis: Direction of the axis.
        sides: Number of facets of the full circle; 0 chooses a number that looks round. A hollow solid
            collides as one piece for each facet and each bend of the profile, so a thin shell should have
            few.

    Examples:
        >>> revolve(rectangle(0.04, 0.1, radius=0.01).at(0.08), angle=4.5)
    """
    return Solid.record(_revolve, profile=profile, angle=angle, axis=axis, sides=sides)


_TWIST_STEP = math.pi / 32.0


@kernel
def _extrude(
    profile: Outline, length: float, axis: Array3, bevel: float, taper: float, twist: float
) -> Shape:
    inputs.positive("length", length)
    bevel = inputs.rounding("bevel", bevel, length / 2.0 * 0.999)
    inputs.between("taper", taper, -10.0, 0.99, "")
    inputs.between("twist", twist, -100.0, 100.0, "rad")
    turn = inputs.frame(axis)
    if inputs.frame_is_mirrored(turn):
        profile = moved_outline(profile, np.diag([1.0, -1.0]), np.zeros(2))
    if bevel > 0.0:
        _check_bevel(profile.contours, bevel)
    stations = max(1, math.ceil(abs(twist) / _TWIST_STEP - 1e-9))
    warp = _warp(length, taper, twist) if taper != 0.0 or twist != 0.0 else None
    # long sides get more vertices for bending; the hulls of the original vertices bound the pieces
    contours = refined(profile, 2.0 * length / stations).contours if twist != 0.0 else profile.contours
    scales = (1.0, 1.0 - taper)
    skin = extrusion(contours, length, bevel=bevel, stations=stations, warp=warp, scales=scales).turned(turn)
    pieces = around_extrusion(profile, length, bevel=bevel, taper=taper, twist=twist, stations=stations)
    return skin.shape(moved(pieces, inputs.pose(turn)))


def extrude(
    profile: Profile,
    length: Scalar,
    *,
    axis: VectorLike = (0.0, 0.0, 1.0),
    bevel: Scalar = 0.0,
    taper: Scalar = 0.0,
    twist: Scalar = 0.0,
) -> Solid:
    """Extrude a profile along an axis, centered on the origin.

    The profile's x and y run along the two other asset axes, in the order X, Y, Z: along Z the profile lies
    in (X, Y), along Y (or -Y, the front) in (X, Z), and along X in (Y, Z). Reversing the axis does not mirror
    the profile; it swaps the ends, which matters for taper and twist.

    Args:
        profile: The profile.
        length: Length along the axis [m].
        axis: Direction of the axis.
        bevel: Radius of the rounded edges at both ends [m].
        taper: Share by which the profile shrinks towards the end of the axis (-1 doubles it).
        twist: Rotation of the end about the axis, right-handed [rad].

    Examples:
        >>> extrude(regular_polygon(6, 0.05), 0.15, bevel=0.004, taper=0.3, twist=0.5)
    """
    return Solid.record(
        _extrude, profile=profile, length=length, axis=axis, bevel=bevel, taper=taper, twist=twist
    )


def _check_bevel(contours: Sequence[Contour], bevel: float) -> None:
    """Check that borders moved inward by the bevel neither fold nor meet."""
    allowed = math.inf
    rings = []
    for contour in contours:
        inward = mitres(contour)
        sides = successors(contour.points) - contour.points
        shortening = ((successors(inward) - inward) * sides).sum(axis=1)
        squared = (sides * sides).sum(axis=1)
        shrinking = shortening > 1e-12
        if shrinking.any():
            allowed = min(allowed, float((squared[shrinking] / shortening[shrinking]).min()))
        rings.append(contour.points - bevel * inward)
    if bevel >= allowed:
        raise ValueError(
            f"bevel {bevel * 1e3:.3g} mm is too large for the profile, whose sharpest curve or shortest "
            f"side allows less than {allowed * 1e3:.3g} mm"
        )
    if not is_disjoint(rings):
        raise ValueError(
            f"bevel {bevel * 1e3:.3g} mm is too large for the profile: the rounded edges of a thin part "
            "of it would meet; a bevel must stay below half of the thinnest part"
        )


def _warp(length: float, taper: float, twist: float) -> Callable[[Array, Array], tuple[Array, Array]]:
    """Return the map of a straight extrusion along z to a tapered and twisted one."""

    def warp(vertices: Array, normals: Array) -> tuple[Array, Array]:
        x, y, z = vertices.T
        along = z / length + 0.5
        scale, angle = 1.0 - taper * along, twist * along
        cosine, sine = np.cos(angle), np.sin(angle)
        moved_vertices = np.column_stack(
            [scale * (cosine * x - sine * y), scale * (sine * x + cosine * y), z]
        )
        # normals are multiplied by the inverse transpose of the map's derivative, here times the scale
        nx, ny, nz = normals.T
        rise = scale * nz + taper / length * (x * nx + y * ny) - twist / length * scale * (x * ny - y * nx)
        turned = np.column_stack([cosine * nx - sine * ny, sine * nx + cosine * ny, rise])
        return moved_vertices, turned / np.linalg.norm(turned, axis=1, keepdims=True)

    return warp
