"""Motion, rotation, scaling and reflection of solids."""

import math

import numpy as np

from artgen._arrays import Array
from artgen.asset.shape import Shape
from artgen.graph import kernel
from artgen.nodes import validators as inputs
from artgen.nodes.handles import Array3, Scalar, Solid, VectorLike


def rotation_about(axis: Array, angle: float) -> Array:
    """Return the right-handed rotation by an angle [rad] about an axis through the origin, shape (3, 3).

    Quarter turns about an asset axis are exact.
    """
    x, y, z = inputs.direction("axis", axis)
    cosine, sine = math.cos(inputs.finite("angle", angle, "rad")), math.sin(angle)
    cosine, sine = (round(value) if abs(value - round(value)) < 1e-15 else value for value in (cosine, sine))
    skew = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    along = np.outer([x, y, z], [x, y, z])
    return np.asarray(cosine * np.eye(3) + sine * skew + (1.0 - cosine) * along)


def moved(shape: Shape, linear: Array, offset: Array) -> Shape:
    """Return the shape with each point p at linear @ p + offset, checked."""
    return shape.transformed(inputs.pose(linear, offset)).checked()


@kernel
def _translate(solid: Shape, offset: Array3) -> Shape:
    return moved(solid, np.eye(3), inputs.vector("offset", offset))


def translate(solid: Solid, offset: VectorLike) -> Solid:
    """Move a solid by a vector [m]; also written `solid.at(x, y, z)`."""
    return Solid.record(_translate, solid=solid, offset=offset)


@kernel
def _rotate(solid: Shape, axis: Array3, angle: float, about: Array3) -> Shape:
    turn = rotation_about(axis, angle)
    center = inputs.vector("about", about)
    return moved(solid, turn, center - turn @ center)


def rotate(solid: Solid, axis: VectorLike, angle: Scalar, *, about: VectorLike = (0.0, 0.0, 0.0)) -> Solid:
    """Turn a solid; also written `solid.rotate(axis, angle)`."""
    return Solid.record(_rotate, solid=solid, axis=axis, angle=angle, about=about)


@kernel
def _scale(solid: Shape, factors: Array3) -> Shape:
    values = inputs.vector("factors", factors)
    if (values <= 0.0).any():
        raise ValueError(
            f"scale factors must be positive, got ({', '.join(f'{x:g}' for x in values)}); "
            "mirror(...) reflects"
        )
    scaled = moved(solid, np.diag(values), np.zeros(3))
    return scaled if values.max() == values.min() == 1.0 else _with_scaled_uvs(scaled, solid, values)


def _with_scaled_uvs(scaled: Shape, solid: Shape, factors: Array) -> Shape:
    """Multiply texture coordinates by the mean scale of their lengths."""
    before, after = solid.mesh, scaled.mesh
    change = math.sqrt(scaled.manifold.surface_area() / solid.manifold.surface_area())
    if abs(change - 1.0) < 1e-12 or not len(before.vertices):
        return scaled
    return Shape.from_mesh(
        after.vertices,
        after.normals,
        after.uvs * change,
        after.triangles,
        scaled.pieces,
        paints=after.paints,
        paint_materials=dict(scaled.paints),
    )


def scale(solid: Solid, factors: VectorLike) -> Solid:
    """Scale a solid about the origin by factors along X, Y and Z; also written `solid.scale(x, y, z)`."""
    return Solid.record(_scale, solid=solid, factors=factors)


@kernel
def _mirror(solid: Shape, normal: Array3) -> Shape:
    across = inputs.direction("normal", normal)
    return moved(solid, np.eye(3) - 2.0 * np.outer(across, across), np.zeros(3))


def mirror(solid: Solid, normal: VectorLike) -> Solid:
    """Reflect a solid in the plane through the origin with a normal; also `solid.mirror(normal)`."""
    return Solid.record(_mirror, solid=solid, normal=normal)


@kernel
def _align(solid: Shape, to: Array3, x: float, y: float, z: float) -> Shape:
    return moved(solid, np.eye(3), inputs.vector("to", to) - anchor_of(solid, x, y, z))


def align(solid: Solid, to: VectorLike, *, x: Scalar = 0.0, y: Scalar = 0.0, z: Scalar = 0.0) -> Solid:
    """Move a solid so that an anchor of its bounding box lies at a point; also `solid.align(to, z=-1)`."""
    return Solid.record(_align, solid=solid, to=to, x=x, y=y, z=z)


def anchor_of(shape: Shape, x: float, y: float, z: float) -> Array:
    """Return the point of the bounding box at (x, y, z), each from -1 to 1, shape (3,) [m]."""
    where = inputs.vector("the anchor", (x, y, z))
    low, high = shape.bounds()
    return np.asarray(0.5 * (low + high) + 0.5 * where * (high - low))
