"""Operations behind the methods of `Solid`: motion, scaling, reflection and measures."""

import math

import numpy as np

from artgen._arrays import Array, affine
from artgen.asset.shape import Shape
from artgen.graph import define, kernel
from artgen.nodes import validators as check
from artgen.nodes.handles import Array3, ArrayN3


def rotation_about(axis: Array, angle: float) -> Array:
    """Return the right-handed rotation by an angle [rad] about an axis through the origin, shape (3, 3).

    Quarter turns about an asset axis are exact.
    """
    x, y, z = check.direction("axis", axis)
    cosine, sine = math.cos(check.finite("angle", angle, "rad")), math.sin(angle)
    cosine, sine = (round(value) if abs(value - round(value)) < 1e-15 else value for value in (cosine, sine))
    skew = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    along = np.outer([x, y, z], [x, y, z])
    return np.asarray(cosine * np.eye(3) + sine * skew + (1.0 - cosine) * along)


def moved(shape: Shape, linear: Array, offset: Array) -> Shape:
    """Return the checked shape with each point p at linear @ p + offset."""
    return shape.transformed(affine(linear, offset)).checked()


@kernel(spelling="{solid}.at({offset})")
def _translate(solid: Shape, offset: Array3) -> Shape:
    return moved(solid, np.eye(3), check.vector("offset", offset))


@kernel(spelling="{solid}.rotate({axis}, {angle}, about={about})")
def _rotate(solid: Shape, axis: Array3, angle: float, about: Array3) -> Shape:
    turn = rotation_about(axis, angle)
    center = check.vector("about", about)
    return moved(solid, turn, center - turn @ center)


@kernel
def _scale(solid: Shape, factors: Array3) -> Shape:
    values = check.vector("factors", factors)
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


@kernel(spelling="{solid}.mirror({normal})")
def _mirror(solid: Shape, normal: Array3) -> Shape:
    across = check.direction("normal", normal)
    return moved(solid, np.eye(3) - 2.0 * np.outer(across, across), np.zeros(3))


@kernel(spelling="{solid}.align({to}, x={x}, y={y}, z={z})")
def _align(solid: Shape, to: Array3, x: float, y: float, z: float) -> Shape:
    return moved(solid, np.eye(3), check.vector("to", to) - _anchor(solid, x, y, z))


@kernel(spelling="{solid}.anchor(x={x}, y={y}, z={z})")
def _anchor(solid: Shape, x: float, y: float, z: float) -> Array3:
    where = check.vector("the anchor", (x, y, z))
    if np.abs(where).max() > 1.0 + 1e-9:
        raise ValueError(
            f"the anchor ({x:.6g}, {y:.6g}, {z:.6g}) is not in the bounding box: each share is from -1 (low) "
            "to 1 (high); add a length to the point [m]"
        )
    low, high = solid.bounds()
    return np.asarray(0.5 * (low + high) + 0.5 * where * (high - low))


@kernel(spelling="{solid}.centroid()")
def _centroid(solid: Shape) -> Array3:
    mesh = solid.mesh
    origin = solid.bounds().mean(axis=0)  # near the solid, where the sum of signed volumes is exact
    a, b, c = np.moveaxis(mesh.vertices[mesh.triangles] - origin, 1, 0)
    volume = np.einsum("ij,ij->i", a, np.cross(b, c))
    return np.asarray(origin + (volume[:, None] * (a + b + c)).sum(axis=0) / (4.0 * volume.sum()))


define("bounds", lambda solid: solid.bounds(), "{solid}.bounds()", ArrayN3, solid=Shape)
define("size", lambda solid: np.ptp(solid.bounds(), axis=0), "{solid}.size()", Array3, solid=Shape)
define("volume", lambda solid: float(solid.manifold.volume()), "{solid}.volume()", float, solid=Shape)
define("area", lambda solid: float(solid.manifold.surface_area()), "{solid}.area()", float, solid=Shape)
