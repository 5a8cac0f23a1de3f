"""Reliefs of profiles on faces and on turned solids: print, raised letters and engraving."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from artgen import _portable
from artgen._arrays import Array, Indices, affine, successors
from artgen.asset.shape import Contour, Curve, Outline, Shape
from artgen.colliders import Pieces
from artgen.colliders.triangles import cross
from artgen.graph import records
from artgen.materials import Material
from artgen.nodes import validators as inputs
from artgen.nodes.body import detail
from artgen.nodes.contours import is_disjoint, refined
from artgen.nodes.handles import Array3, Body, Path, Profile, Scalar, Solid, Vector, VectorLike
from artgen.nodes.primitive_colliders import around_extrusion, around_hull, lazily
from artgen.nodes.surfaces import DeferredSkin, Skin, extrusion, mitres, triangulated


def prisms(contours: Sequence[Contour], length: float) -> Skin:
    """Extrude contours along z, centered on z = 0, with sharp edges.

    Every vertex has three copies at either end: for the arriving side, the leaving side and the flat end. A
    loop over the contours would take ten times as long for hundreds of them.
    """
    plan = np.concatenate([contour.points for contour in contours])
    counts = np.array([len(contour.points) for contour in contours])
    begins = np.cumsum(counts) - counts
    following = np.arange(1, len(plan) + 1)
    following[begins + counts - 1] = begins
    level = np.array([-length / 2.0, length / 2.0])
    side = np.sign(level)
    vertices = np.empty((2, 3, len(plan), 3))
    vertices[..., :2] = plan
    vertices[..., 2] = level[:, None, None]
    normals = np.zeros_like(vertices)
    normals[:, 0, :, :2] = np.concatenate([contour.normals_in for contour in contours])
    normals[:, 1, :, :2] = np.concatenate([contour.normals_out for contour in contours])
    normals[:, 2, :, 2] = side[:, None]
    leaving, arriving = _distances(plan, following, begins, counts)
    uvs = np.empty((2, 3, len(plan), 2))
    uvs[:, 0, :, 0], uvs[:, 1, :, 0] = arriving, leaving
    uvs[:, :2, :, 1] = level[:, None, None]
    uvs[:, 2] = plan * np.stack([side, np.ones(2)], axis=1)[:, None]
    index = np.arange(6 * len(plan)).reshape(2, 3, len(plan))
    low, high, end = index[0, 1], index[1, 1], index[:, 0][:, following]
    walls = np.stack([low, end[0], end[1], low, end[1], high], axis=-1).reshape(-1, 3)
    lid = triangulated([contour.points for contour in contours])
    triangles = np.concatenate([walls, index[1, 2][lid], index[0, 2][lid[:, ::-1]]])
    targets = np.ascontiguousarray(np.broadcast_to(index[:, :1], index.shape)).reshape(-1)
    return Skin(vertices.reshape(-1, 3), normals.reshape(-1, 3), uvs.reshape(-1, 2), triangles, targets)


def _distances(plan: Array, following: Indices, begins: Indices, counts: Indices) -> tuple[Array, Array]:
    """Return the distances along its contour at which each vertex is left and reached, shape (n,) [m]."""
    sides = np.linalg.norm(plan[following] - plan, axis=1)
    total = np.concatenate([[0.0], np.cumsum(sides)])
    leaving = total[:-1] - np.repeat(total[begins], counts)
    arriving = leaving.copy()
    arriving[begins] = total[begins + counts] - total[begins]
    return leaving, arriving


_HALVINGS = 4
"""Number of halvings of a bevel that does not fit before the rim stays sharp."""

_ABOUT = 0.25
"""Largest offset of the center of a profile that lies about its origin, as a share of its width."""

_STEP = 0.10
"""Angle that one straight side of print around a turned solid may span [rad]."""

FRONT = (0.0, -1.0, 0.0)
"""Outward direction of the front of an asset."""


def facing_frame(facing: Array, up: Array | None) -> Array:
    """Return the rotation, shape (3, 3), with columns right, up and outward for the reader of a face."""
    out = inputs.direction("facing", facing)
    if up is None:
        up = np.array([0.0, 1.0, 0.0]) if abs(out[2]) > 0.9 else np.array([0.0, 0.0, 1.0])
    upward = inputs.direction("up", up)
    upward = upward - out * _portable.dot(out, upward)
    length = _portable.norm(upward)
    if length < 1e-6:
        shown = ", ".join(f"{value:g}" for value in up)
        raise ValueError(f"up ({shown}) runs along facing: it must point upward on the face")
    upward /= length
    return np.column_stack([cross(upward, out), upward, out]) + 0.0


def _allows(contours: Sequence[Contour], bevel: float) -> bool:
    """Tell whether borders moved inward by a bevel neither fold nor meet."""
    rings = []
    for contour in contours:
        inward = mitres(contour)
        sides = successors(contour.points) - contour.points
        shortening = bevel * ((successors(inward) - inward) * sides).sum(axis=1)
        if (shortening >= (sides * sides).sum(axis=1)).any():
            return False
        # in millimetres: the rounding of polygons in metres would count as an overlap
        rings.append(1e3 * (contour.points - bevel * inward))
    return is_disjoint(rings)


def _fitting(contours: Sequence[Contour], bevel: float) -> float:
    """Return the largest of bevel, bevel / 2, bevel / 4, ... that the contours allow, or 0."""
    for _ in range(_HALVINGS):
        if bevel < 1e-6:
            return 0.0
        if _allows(contours, bevel):
            return bevel
        bevel /= 2.0
    return 0.0


def _relief(
    profile: Outline, at: Array3, facing: Array3, up: Array3 | None, proud: float, sunk: float, bevel: float
) -> Shape:
    inputs.positive("proud", proud)
    inputs.positive("sunk", sunk)
    length = proud + sunk
    bevel = min(inputs.rounding("bevel", bevel, 1.0), 0.999 * proud, 0.499 * length)
    bevel = _fitting(profile.contours, bevel)
    place = inputs.vector("at", at)
    turn = facing_frame(facing, up)
    contours = profile.contours
    skin = DeferredSkin(
        lambda: extrusion(contours, length, bevel=bevel) if bevel > 0.0 else prisms(contours, length)
    )
    pieces = lazily(
        lambda: around_extrusion(profile, length, bevel=bevel, taper=0.0, twist=0.0, stations=1)
    )  # most reliefs are visual details
    return skin.shape(pieces).transformed(affine(turn, place + turn[:, 2] * (proud - sunk) / 2.0))


@records(_relief)
def relief(
    profile: Profile,
    at: VectorLike = (0.0, 0.0, 0.0),
    *,
    facing: VectorLike = FRONT,
    up: VectorLike | None = None,
    proud: Scalar = 0.0004,
    sunk: Scalar = 0.0004,
    bevel: Scalar = 0.0,
) -> Solid:
    """Put a profile on a face, readable from outside and never mirrored.

    Mirroring a body mirrors it as well; `printed`, `raised` and `engraved` stay readable.

    Args:
        profile: The profile; its x points to the reader's right and its y upward.
        at: Place of its origin on the face [m].
        facing: Outward direction of the face.
        up: Upward direction for the reader; by default Z, or Y on a face that looks up or down.
        proud: Height above the face [m].
        sunk: Depth below the face [m], which avoids z-fighting.
        bevel: Radius of its upper rim [m]; less for fine profiles.

    Examples:
        >>> box(0.06, 0.004, 0.04) - details.relief(text("EXIT", 0.012), (0, -0.002, 0), sunk=0.001)
    """


def _reading(facing: Array3, up: Array3 | None) -> Array3:
    return facing_frame(facing, up)[:, 0]


@records(_reading)
def reading(facing: VectorLike, up: VectorLike | None) -> Vector:
    """Return the direction of the lines of print on a face."""


def _middle(profile: Outline, at: Array3, facing: Array3, up: Array3 | None) -> Array3:
    points = np.concatenate([contour.points for contour in profile.contours])
    low, high = points[:, 0].min(), points[:, 0].max()
    middle = 0.5 * (low + high)
    if abs(middle) < _ABOUT * (high - low):
        middle = 0.0
    return np.asarray(at + facing_frame(facing, up)[:, 0] * middle)


@records(_middle)
def middle(profile: Profile, at: VectorLike, facing: VectorLike, up: VectorLike | None) -> Vector:
    """Return the point about which print is flipped if its body is mirrored.

    For a profile about its origin, such as a scale around a knob, this is `at`; for a profile next to its
    origin, such as a line of text, it is the center of the profile.
    """


def printed(
    profile: Profile,
    at: VectorLike = (0.0, 0.0, 0.0),
    *,
    material: Material,
    facing: VectorLike = FRONT,
    up: VectorLike | None = None,
    label: str = "print",
    proud: Scalar = 0.0002,
) -> Body:
    """Print a profile on a face: a visual film of ink.

    Args:
        profile: What to print, such as `text("Power", 0.004)` or `icon("power", 0.008)`.
        at: Place of its origin on the face [m].
        material: Material of the ink.
        facing: Outward direction of the face.
        up: Upward direction for the reader; by default Z, or Y on a face that looks up or down.
        label: Semantic label.
        proud: Height of the ink above the face and depth below it [m].

    Examples:
        >>> plate = part(box(0.06, 0.004, 0.04), "plate", material("abs"))
        >>> ink = material("black_abs")
        >>> weld(plate, details.printed(details.icon("light", 0.02), (0, -0.002, 0), material=ink))
    """
    return raised(profile, at, material=material, facing=facing, up=up, label=label, proud=proud, bevel=0.0)


def raised(
    profile: Profile,
    at: VectorLike = (0.0, 0.0, 0.0),
    *,
    material: Material,
    facing: VectorLike = FRONT,
    up: VectorLike | None = None,
    label: str = "print",
    proud: Scalar = 0.0004,
    bevel: Scalar = 0.00015,
) -> Body:
    """Raise a profile above a face with a soft rim, like moulded letters and glued emblems.

    Args:
        profile: The profile.
        at: Place of its origin on the face [m].
        material: Its material; the face's material for moulded letters.
        facing: Outward direction of the face.
        up: Upward direction for the reader; by default Z, or Y on a face that looks up or down.
        label: Semantic label.
        proud: Height above the face, 0.0003-0.001 [m].
        bevel: Radius of its rim [m]; less for fine profiles.

    Examples:
        >>> plate = part(box(0.06, 0.004, 0.04), "plate", material("abs"))
        >>> brass = material("brass")
        >>> weld(plate, details.raised(text("EXIT", 0.012), (0, -0.002, 0), material=brass, proud=0.001))
    """
    solid = relief(profile, at, facing=facing, up=up, proud=proud, sunk=proud, bevel=bevel)
    return detail(solid, label, material, reads=reading(facing, up), about=middle(profile, at, facing, up))


def engraved(
    profile: Profile,
    at: VectorLike = (0.0, 0.0, 0.0),
    *,
    material: Material,
    facing: VectorLike = FRONT,
    up: VectorLike | None = None,
    label: str = "print",
) -> Body:
    """Make a profile look engraved in a face: in the color of the face, but darker and rough like a groove.

    The face itself is not cut; subtract a `relief` for a real groove.

    Args:
        profile: The profile.
        at: Place of its origin on the face [m].
        material: The material of the face.
        facing: Outward direction of the face.
        up: Upward direction for the reader; by default Z, or Y on a face that looks up or down.
        label: Semantic label.

    Examples:
        >>> plate = part(box(0.06, 0.004, 0.04), "plate", material("abs"))
        >>> weld(plate, details.engraved(text("EXIT", 0.012), (0, -0.002, 0), material=material("abs")))
    """
    groove = in_shade(material)
    return printed(profile, at, material=groove, facing=facing, up=up, label=label, proud=0.0001)


def in_shade(material: Material) -> Material:
    """Return the appearance of a material at the bottom of a groove: darker, rough and without texture."""
    color = tuple(0.22 * channel for channel in material.base_color)
    return material.with_(
        name=f"{material.name}_shade",
        base_color=color,
        base_metalness=0.5 * material.base_metalness,
        specular_roughness=max(material.specular_roughness, 0.6),
        coat_weight=0.0,
        texture="",
        tile=None,
        variant=0,
        turned=False,
    )


def _wrap(profile: Outline, path: Curve, height: float, proud: float) -> Shape:
    inputs.positive("proud", proud)
    line = path.points[:, [0, 2]]
    line = line[np.argsort(line[:, 1], kind="stable")]
    plan = np.concatenate([contour.points for contour in profile.contours])
    low, high = height + plan[:, 1].min(), height + plan[:, 1].max()
    if low < line[0, 1] or high > line[-1, 1]:
        raise ValueError(
            f"the print reaches from {low:.4g} to {high:.4g} m, the line only from {line[0, 1]:.4g} to "
            f"{line[-1, 1]:.4g} m; move the print or make it smaller"
        )
    radius = float(np.interp(height, line[:, 1], line[:, 0]))
    wide = float(np.abs(plan[:, 0]).max())
    if wide > math.pi * radius:
        raise ValueError(
            f"the print is {2.0 * wide:.4g} m wide, more than once around a radius of {radius:.4g} m; use "
            "smaller print"
        )
    bent = prisms(refined(profile, _STEP * radius).contours, 2.0 * proud)
    vertices, normals = _bent(bent, line, radius, height)
    skin = Skin(vertices, normals, bent.uvs, bent.triangles, bent.targets)
    return skin.shape(
        Pieces(around_hull(lambda: vertices).outer, lambda _: ())
    )  # visual details need none inside


def _bent(flat: Skin, line: Array, radius: float, height: float) -> tuple[Array, Array]:
    """Return vertices and normals of a flat print, outward along z, bent onto the outline of a lathe."""
    across, up, out = flat.vertices.T
    level = height + up
    angle = across / radius - math.pi / 2.0
    here = np.interp(level, line[:, 1], line[:, 0]) + out
    cosine, sine = _portable.cos(angle), _portable.sin(angle)
    vertices = np.column_stack([here * cosine, here * sine, level])
    x, y, z = flat.normals.T
    normals = np.column_stack([z * cosine - x * sine, z * sine + x * cosine, y])
    return vertices, normals


@records(_wrap)
def wrap(profile: Profile, path: Path, height: Scalar, *, proud: Scalar = 0.0002) -> Solid:
    """Bend a profile onto a turned solid, readable from the front.

    Args:
        profile: The profile; its x points to the reader's right and its y upward.
        path: Outline that was turned about z, as for `half_section`; it must cover the height of the print.
        height: Height of the profile's origin on the outline [m].
        proud: Height above the surface and depth below it [m].

    Examples:
        >>> around = line((0.04, 0, 0), (0.04, 0, 0.1))
        >>> cylinder(0.04, 0.1).at(z=0.05) | details.wrap(text("MILK", 0.009), around, 0.05, proud=0.001)
    """


def wrapped(
    profile: Profile,
    path: Path,
    height: Scalar,
    *,
    material: Material,
    label: str = "print",
    proud: Scalar = 0.0002,
) -> Body:
    """Print a profile around the front of a turned solid: a visual film of ink.

    Args:
        profile: The profile, such as `text("Salt", 0.006)`.
        path: Outline that was turned about z, as for `half_section`.
        height: Height of the profile's origin on the outline [m].
        material: Material of the ink.
        label: Semantic label.
        proud: Height of the ink above the surface and depth below it [m].

    Examples:
        >>> around = line((0.04, 0, 0), (0.04, 0, 0.1))
        >>> can = part(cylinder(0.04, 0.1).at(z=0.05), "can", material("steel"))
        >>> weld(can, details.wrapped(text("MILK", 0.009), around, 0.05, material=material("copper")))
    """
    return detail(wrap(profile, path, height, proud=proud), label, material, reads=(1.0, 0.0, 0.0))
