"""Measures of solids and bodies: points, numbers, mass and center of mass."""

import numpy as np

from artgen.asset import Tree
from artgen.asset.mass import total
from artgen.asset.shape import Shape
from artgen.graph import kernel
from artgen.nodes.handles import Array3, ArrayN3, Body, Float, Points, Scalar, Solid, Vector
from artgen.nodes.transform import anchor_of


@kernel
def _mass(body: Tree) -> float:
    return sum(link.mass_properties.mass for link in body.links())


def mass(body: Body) -> Float:
    """Return the mass with all links joined to the body [kg]; also written `body.mass()`."""
    return Float.record(_mass, body=body)


@kernel
def _center_of_mass(body: Tree) -> Array3:
    return total([link.mass_properties.moments() for link in body.links()]).center


def center_of_mass(body: Body) -> Vector:
    """Return the center of mass of all links at rest [m]; also written `body.center_of_mass()`."""
    return Vector.record(_center_of_mass, body=body)


@kernel
def _anchor(solid: Shape, x: float, y: float, z: float) -> Array3:
    return anchor_of(solid, x, y, z)


def anchor(solid: Solid, *, x: Scalar = 0.0, y: Scalar = 0.0, z: Scalar = 0.0) -> Vector:
    """Return a point of the bounding box; also written `solid.anchor(x=-1)`."""
    return Vector.record(_anchor, solid=solid, x=x, y=y, z=z)


@kernel
def _size(solid: Shape) -> Array3:
    low, high = solid.bounds()
    return np.asarray(high - low)


def size(solid: Solid) -> Vector:
    """Return the lengths of the bounding box [m]; also written `solid.size()`."""
    return Vector.record(_size, solid=solid)


@kernel
def _bounds(solid: Shape) -> ArrayN3:
    return solid.bounds()


def bounds(solid: Solid) -> Points:
    """Return the two extreme corners of the bounding box [m], lowest first; also `solid.bounds()`."""
    return Points.record(_bounds, solid=solid)


@kernel
def _centroid(solid: Shape) -> Array3:
    mesh = solid.mesh
    origin = solid.bounds().mean(axis=0)  # near the solid, where the sum of signed volumes is exact
    a, b, c = np.moveaxis(mesh.vertices[mesh.triangles] - origin, 1, 0)
    volume = np.einsum("ij,ij->i", a, np.cross(b, c))
    return np.asarray(origin + (volume[:, None] * (a + b + c)).sum(axis=0) / (4.0 * volume.sum()))


def centroid(solid: Solid) -> Vector:
    """Return the center of volume [m]; also written `solid.centroid()`."""
    return Vector.record(_centroid, solid=solid)


@kernel
def _volume(solid: Shape) -> float:
    return float(solid.manifold.volume())


def volume(solid: Solid) -> Float:
    """Return the volume [m^3]; also written `solid.volume()`."""
    return Float.record(_volume, solid=solid)


@kernel
def _area(solid: Shape) -> float:
    return float(solid.manifold.surface_area())


def area(solid: Solid) -> Float:
    """Return the area of the surface [m^2]; also written `solid.area()`."""
    return Float.record(_area, solid=solid)
