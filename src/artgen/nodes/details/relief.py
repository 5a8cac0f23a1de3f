"""Reliefs on a face from any profile: print, raised letters, engraving, and the prisms they consist of."""

from collections.abc import Sequence

import numpy as np

from artgen._arrays import Array, Indices, successors
from artgen.asset.shape import Contour, Outline, Shape
from artgen.colliders.triangles import cross
from artgen.graph import kernel
from artgen.materials import Material
from artgen.nodes import validators as inputs
from artgen.nodes.body import detail
from artgen.nodes.contours import is_disjoint
from artgen.nodes.handles import Array3, Body, Profile, Scalar, Solid, Vector, VectorLike
from artgen.nodes.primitive_colliders import around_extrusion, lazily
from artgen.nodes.surfaces import Skin, extrusion, mitres, triangulated


def prisms(contours: Sequence[Contour], length: float) -> Skin:
    """Extrude contours along z, centered on z = 0, with sharp edges.

    Every vertex has three copies at either end: for the side that arrives, for the side that leaves and for
    the flat end. A loop over the contours would take ten times as long for hundreds of them.
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
    """Return how far along its contour each vertex is left and reached, both shape (n,) [m]."""
    sides = np.linalg.norm(plan[following] - plan, axis=1)
    total = np.concatenate([[0.0], np.cumsum(sides)])
    leaving = total[:-1] - np.repeat(total[begins], counts)
    arriving = leaving.copy()
    arriving[begins] = total[begins + counts] - total[begins]
    return leaving, arriving


_HALVINGS = 4
"""How often a bevel that does not fit is halved before the rim stays sharp."""

_ABOUT = 0.25
"""A profile lies about its origin if its middle is off by less than this share of its width."""

FRONT = (0.0, -1.0, 0.0)
"""The way that the front of an asset faces."""


def facing_frame(facing: Array, up: Array | None) -> Array:
    """Return the rotation, shape (3, 3), whose columns are right, up and out of a face that is read."""
    out = inputs.direction("facing", facing)
    if up is None:
        up = np.array([0.0, 1.0, 0.0]) if abs(out[2]) > 0.9 else np.array([0.0, 0.0, 1.0])
    upward = inputs.direction("up", up)
    upward = upward - out * float(out @ upward)
    length = float(np.linalg.norm(upward))
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
    """Return the greatest of bevel, bevel / 2, bevel / 4, ... that the contours allow, or 0."""
    for _ in range(_HALVINGS):
        if bevel < 1e-6:
            return 0.0
        if _allows(contours, bevel):
            return bevel
        bevel /= 2.0
    return 0.0


@kernel
def _relief(
    profile: Outline,
    at: Array3,
    facing: Array3,
    up: Array3 | None,
    proud: float,
    sunk: float,
    bevel: float,
) -> Shape:
    inputs.positive("proud", proud)
    inputs.positive("sunk", sunk)
    length = proud + sunk
    bevel = min(inputs.rounding("bevel", bevel, 1.0), 0.999 * proud, 0.499 * length)
    bevel = _fitting(profile.contours, bevel)
    place = inputs.vector("at", at)
    turn = facing_frame(facing, up)
    contours = profile.contours
    skin = extrusion(contours, length, bevel=bevel) if bevel > 0.0 else prisms(contours, length)
    pieces = lazily(
        lambda: around_extrusion(profile, length, bevel=bevel, taper=0.0, twist=0.0, stations=1)
    )  # most reliefs are only seen
    return skin.shape(pieces).transformed(inputs.pose(turn, place + turn[:, 2] * (proud - sunk) / 2.0))


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
    """Put a profile on a face, to be read from where the face looks: never mirrored, whatever the face.

    A body that is mirrored later mirrors it; `printed`, `raised` and `engraved` stay readable.

    Args:
        profile: What to put there; its x runs to the reader's right and its y upward.
        at: Where its origin lies on the face [m].
        facing: Out of the face.
        up: Upward for the reader; by default Z, or Y on a face that looks up or down.
        proud: How far it stands out of the face [m].
        sunk: How far it reaches into the face [m], so that it never fights the face for a pixel.
        bevel: Radius of its upper rim [m]; less where the profile is too fine for it.

    Examples:
        >>> box(0.06, 0.004, 0.04) - details.relief(text("EXIT", 0.012), (0, -0.002, 0), sunk=0.001)
    """
    return Solid.record(
        _relief, profile=profile, at=at, facing=facing, up=up, proud=proud, sunk=sunk, bevel=bevel
    )


@kernel
def _reading(facing: Array3, up: Array3 | None) -> Array3:
    return facing_frame(facing, up)[:, 0]


def reading(facing: VectorLike, up: VectorLike | None) -> Vector:
    """Return the direction of the lines of print on a face."""
    return Vector.record(_reading, facing=facing, up=up)


@kernel
def _middle(profile: Outline, at: Array3, facing: Array3, up: Array3 | None) -> Array3:
    points = np.concatenate([contour.points for contour in profile.contours])
    low, high = points[:, 0].min(), points[:, 0].max()
    middle = 0.5 * (low + high)
    if abs(middle) < _ABOUT * (high - low):
        middle = 0.0
    return np.asarray(at + facing_frame(facing, up)[:, 0] * middle)


def middle(profile: Profile, at: VectorLike, facing: VectorLike, up: VectorLike | None) -> Vector:
    """Return about which point print turns over when its body is mirrored.

    It is `at` for a profile that lies about its origin, such as a scale around a knob, and the middle of the
    profile for one beside it, such as a line of text that starts there.
    """
    return Vector.record(_middle, profile=profile, at=at, facing=facing, up=up)


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
    """Print a profile on a face: a film of ink that is only seen.

    Args:
        profile: What to print, such as `text("Power", 0.004)` or `icon("power", 0.008)`.
        at: Where its origin lies on the face [m].
        material: The ink.
        facing: Out of the face.
        up: Upward for the reader; by default Z, or Y on a face that looks up or down.
        label: Semantic label.
        proud: How far the ink stands out [m]; it reaches as far into the face.

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
    """Let a profile stand out of a face with a soft rim, as moulded letters and glued emblems do.

    Args:
        profile: What stands out.
        at: Where its origin lies on the face [m].
        material: What it is made of; that of the face for moulded letters.
        facing: Out of the face.
        up: Upward for the reader; by default Z, or Y on a face that looks up or down.
        label: Semantic label.
        proud: How far it stands out, 0.0003-0.001 [m].
        bevel: Radius of its rim [m]; less where the profile is too fine for it.

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
    """Make a profile look engraved in a face: in the color of the face, darker and rough as a groove is.

    The face itself is not cut; where the groove has to be real, subtract a `relief`.

    Args:
        profile: What looks engraved.
        at: Where its origin lies on the face [m].
        material: The material of the face.
        facing: Out of the face.
        up: Upward for the reader; by default Z, or Y on a face that looks up or down.
        label: Semantic label.

    Examples:
        >>> plate = part(box(0.06, 0.004, 0.04), "plate", material("abs"))
        >>> weld(plate, details.engraved(text("EXIT", 0.012), (0, -0.002, 0), material=material("abs")))
    """
    groove = in_shade(material)
    return printed(profile, at, material=groove, facing=facing, up=up, label=label, proud=0.0001)


def in_shade(material: Material) -> Material:
    """Return how a material looks at the bottom of a groove or recess: darker, rough and even."""
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
