"""Checks of evaluated solids: closed, with true normals and covered by their pieces."""

from collections.abc import Sequence

import numpy as np
from manifold3d import Error, Manifold, OpType
from numpy.typing import NDArray

from artgen.asset import Shape
from artgen.asset.shape import Contour
from artgen.colliders import TOLERANCE, Convex
from artgen.nodes.contours import signed_area

Array = NDArray[np.float64]

X, Y, Z = np.eye(3)
_THIN = 1e-7  # [m]: slivers lower than this have no normal to speak of
_FILM = 1e-6  # mean thickness of the films that pieces may leave out [m]
_FRAMES = ((0.0, 0.0, 0.0), (10.0, 20.0, 30.0))  # turns about x, y and z for volumes [degrees]


def check_shape(shape: Shape, *, least_agreement: float = 0.7, covered: bool = True) -> None:
    """Assert that a solid is closed, that its normals fit its faces, and that its pieces bound it."""
    assert shape.manifold.status() == Error.NoError
    assert shape.manifold.volume() > 0.0
    mesh = shape.mesh
    assert np.isfinite(mesh.vertices).all()
    assert np.isfinite(mesh.uvs).all()
    np.testing.assert_allclose(np.linalg.norm(mesh.normals, axis=1), 1.0, atol=1e-9)
    assert agreement(shape) >= least_agreement
    if covered:
        check_cover(shape)


def agreement(shape: Shape) -> float:
    """Return the least cosine between a face and the normal of a vertex of it."""
    mesh = shape.mesh
    corners = mesh.vertices[mesh.triangles]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    size = np.linalg.norm(across, axis=1)
    longest = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(axis=1)
    sound = size > _THIN * longest
    cosine = np.einsum("ij,ikj->ik", across / np.maximum(size, 1e-300)[:, None], mesh.normals[mesh.triangles])
    return float(cosine[sound].min())


def check_cover(shape: Shape, tolerance: float = TOLERANCE) -> None:
    """Assert that the outer pieces contain the solid and that it contains the inner ones."""
    missed = _FILM * shape.manifold.surface_area()
    outer = [piece.manifold(1e-6) for piece in shape.pieces.outer(tolerance)]
    assert _outside([shape.manifold], outer) <= missed
    inner = [_within(piece) for piece in shape.pieces.inner(tolerance)]
    assert _outside(inner, [shape.manifold]) <= missed


def _outside(solids: list[Manifold], around: list[Manifold]) -> float:
    """Return the volume of solids outside of those around them [m^3].

    manifold3d loses some of the union of pieces that share faces, mostly metres from the origin, in one
    frame and not in another. A volume that is outside is so in every frame: the least one counts.
    """
    lows, highs = np.transpose([solid.bounding_box() for solid in around]).reshape(2, 3, -1)
    home = tuple(-0.5 * (lows.min(axis=1) + highs.max(axis=1)))
    volumes = []
    for turn in _FRAMES:
        inside, cover = (
            united([each.translate(home).rotate(turn) for each in group]) for group in (solids, around)
        )
        volumes.append((inside - cover).volume())
    return min(volumes)


def _within(piece: Convex) -> Manifold:
    return Manifold.hull_points(np.ascontiguousarray(piece.inner_polytope(1e-6).points))


def united(solids: list[Manifold]) -> Manifold:
    """Return the union of manifolds."""
    return Manifold.batch_boolean(solids, OpType.Add)


def check_metric(shape: Shape) -> None:
    """Assert that texture coordinates of flat faces keep lengths: both triangles have one area."""
    mesh = shape.mesh
    normals = mesh.normals[mesh.triangles]
    flat = np.linalg.norm(normals - normals[:, :1], axis=2).max(axis=1) < 1e-9
    assert flat.any()
    corners, uvs = mesh.vertices[mesh.triangles[flat]], mesh.uvs[mesh.triangles[flat]]
    for a, b in ((0, 1), (1, 2), (2, 0)):
        lengths = np.linalg.norm(corners[:, a] - corners[:, b], axis=1)
        np.testing.assert_allclose(np.linalg.norm(uvs[:, a] - uvs[:, b], axis=1), lengths, atol=1e-9)


def relative_volume(shape: Shape, expected: float) -> float:
    """Return the volume as a share of the expected one [m^3]."""
    return float(shape.manifold.volume()) / expected


def same_bytes(a: Shape, b: Shape) -> bool:
    """Tell whether two solids have the same mesh to the last bit."""
    return all(
        np.array_equal(getattr(a.mesh, name), getattr(b.mesh, name))
        for name in ("vertices", "normals", "uvs", "paints", "triangles")
    )


def outline_area(contours: Sequence[Contour]) -> float:
    """Return the area of a region [m^2]."""
    return sum(signed_area(contour.points) for contour in contours)
