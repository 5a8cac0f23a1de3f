"""Checks of solids, colliders and mass properties that share no code with what they check."""

import numpy as np
import trimesh
from manifold3d import Error, Manifold, OpType
from numpy.typing import NDArray
from scipy.spatial import ConvexHull, cKDTree

from artgen.asset import Link
from artgen.colliders import Convex

Array = NDArray[np.float64]

STICKS_OUT = 0.05e-3  # [m] that a solid may stick out of its colliders
EXCESS_VOLUME = 0.03  # of the solids' volume that colliders may add
EXCESS_SURFACE = 1.0e-3  # [m] that colliders may stand off the surface where they add more
CAVITY = 4.0e-3  # [m] from the surface, where even a rounded edge's collider has ended
FINE = 2.0e-6  # [m] to which round colliders are faceted for these checks
MOST_VERTICES = 64
MOST_COLLIDERS = 64


def check_solids(link: Link) -> None:
    """Assert that every solid of a link is watertight, positively oriented and has analytic normals."""
    for piece in link.pieces:
        place = f"{link.name}/{piece.label}"
        manifold = piece.shape.manifold
        assert manifold.status() == Error.NoError, place
        mesh = piece.shape.mesh
        points, group = np.unique(np.round(mesh.vertices, 9), axis=0, return_inverse=True)
        faces = group.ravel()[mesh.triangles]
        edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
        forward, counts = np.unique(edges, axis=0, return_counts=True)
        backward, back_counts = np.unique(edges[:, ::-1], axis=0, return_counts=True)
        assert (forward == backward).all(), f"{place}: open edges"
        assert (counts == back_counts).all(), f"{place}: edges with unequal neighbors"
        volume = trimesh.Trimesh(points, faces, process=False).volume
        assert volume > 0.0, f"{place}: volume {volume}"
        length = np.linalg.norm(mesh.normals, axis=1)
        assert np.abs(length - 1.0).max() < 1e-6, f"{place}: normals of length {length.min()}..{length.max()}"


def polytope(convex: Convex, tolerance: float = FINE) -> Array:
    """Return vertices of a polytope that a collider of any kind fills to within `tolerance` from outside."""
    if convex.kind == "hull":
        return convex.points
    if convex.kind == "box":
        corners = np.array(np.meshgrid([-0.5, 0.5], [-0.5, 0.5], [-0.5, 0.5])).reshape(3, -1).T
        local = corners * np.array(convex.size)
    else:
        radius = convex.size[0]
        sides = int(np.ceil(np.pi / np.arccos(1.0 / (1.0 + tolerance / radius))))
        sides = min(max(sides, 16), 720)
        angles = 2.0 * np.pi * np.arange(sides) / sides
        ring = np.stack([np.cos(angles), np.sin(angles)], axis=1) * radius / np.cos(np.pi / sides)
        if convex.kind == "cylinder":
            half = convex.size[1] / 2
            local = np.concatenate([np.column_stack([ring, np.full(sides, z)]) for z in (-half, half)])
        else:
            half = convex.size[1] / 2 if convex.kind == "capsule" else 0.0
            ball = trimesh.creation.icosphere(subdivisions=4, radius=radius).vertices * 1.002
            local = np.concatenate([ball + [0, 0, -half], ball + [0, 0, half]])
    return local @ convex.pose[:3, :3].T + convex.pose[:3, 3]


def check_collider_pieces(link: Link) -> None:
    """Assert that a link's colliders are convex, closed, of positive volume and within the budget."""
    colliders = link.colliders
    assert 0 < len(colliders) <= MOST_COLLIDERS, f"{link.name}: {len(colliders)} colliders"
    for collider in colliders:
        convex = collider.convex
        place = f"{link.name}/{collider.label} ({convex.kind})"
        rotation = convex.pose[:3, :3]
        assert np.abs(rotation @ rotation.T - np.eye(3)).max() < 1e-9, place
        assert np.linalg.det(rotation) > 0.0, place
        if convex.kind != "hull":
            assert min(convex.size) > 0.0, place
            continue
        assert 4 <= len(convex.points) <= MOST_VERTICES, f"{place}: {len(convex.points)} vertices"
        hull = ConvexHull(convex.points)
        assert hull.volume > 0.0, place
        depth = (hull.equations[:, :3] @ convex.points.T + hull.equations[:, 3:]).max(axis=0)
        assert depth.min() > -1e-7, f"{place}: a point lies {-depth.min():.2e} m inside its hull"


def check_colliders_cover(link: Link) -> None:
    """Assert that colliders contain the solids, add little, and leave cavities open."""
    convexes = [collider.convex for collider in link.colliders]
    hulls = [Manifold.hull_points(polytope(convex)) for convex in convexes]
    cover = Manifold.batch_boolean(hulls, OpType.Add)
    solids = Manifold.batch_boolean(
        [piece.shape.manifold for piece in link.pieces if not piece.visual], OpType.Add
    )
    outside = solids - cover
    if not outside.is_empty():
        corners = _vertices(outside)
        planes = [ConvexHull(polytope(convex)).equations for convex in convexes]
        distance = np.min([(plane[:, :3] @ corners.T + plane[:, 3:]).max(axis=0) for plane in planes], axis=0)
        worst = int(np.argmax(distance))
        assert distance[worst] <= STICKS_OUT, (
            f"{link.name}: the solid sticks out of its colliders by {1e3 * distance[worst]:.3f} mm at "
            f"{corners[worst].round(4)}"
        )
    excess = cover - solids
    added = excess.volume() / solids.volume()
    if excess.is_empty() or excess.volume() <= 0.0:
        return
    corners = _vertices(excess)
    worst_distance, place = _farthest(corners, solids)
    allowed = CAVITY if added <= EXCESS_VOLUME else EXCESS_SURFACE
    assert worst_distance <= allowed, (
        f"{link.name}: colliders add {100 * added:.1f} % of volume and stand off the surface by "
        f"{1e3 * worst_distance:.2f} mm at {place.round(4)}"
    )


def check_mass(link: Link) -> None:
    """Assert that mass properties agree with an integration by trimesh over disjoint solids."""
    expected_mass, first = 0.0, np.zeros(3)
    parts = []
    before: list[Manifold] = []
    for piece in link.pieces:
        if piece.visual:
            continue
        rest = piece.shape.manifold
        if before:
            rest = rest - Manifold.batch_boolean(before, OpType.Add)
        before.append(piece.shape.manifold)
        if rest.is_empty():
            continue
        raw = rest.to_mesh64()
        mesh = trimesh.Trimesh(
            np.asarray(raw.vert_properties)[:, :3], np.asarray(raw.tri_verts).astype(int), process=False
        )
        mesh.density = piece.material.density
        expected_mass += mesh.mass
        first += mesh.mass * mesh.center_mass
        parts.append((mesh.mass, mesh.center_mass, mesh.moment_inertia))
    found = link.mass_properties
    assert abs(found.mass - expected_mass) <= 1e-6 * expected_mass, (link.name, found.mass, expected_mass)
    center = first / expected_mass
    extent = np.linalg.norm(np.ptp(link.bounds(), axis=0))
    assert np.abs(found.center - center).max() <= 1e-6 * extent, link.name
    inertia = np.zeros((3, 3))
    for mass, at, about_center in parts:
        arm = at - center
        inertia += about_center + mass * (arm @ arm * np.eye(3) - np.outer(arm, arm))
    assert np.abs(found.inertia - inertia).max() <= 1e-6 * np.abs(inertia).max(), link.name
    moments = np.linalg.eigvalsh(found.inertia)
    assert moments[0] > 0.0, link.name
    assert moments[0] + moments[1] >= moments[2] * (1 - 1e-9), link.name


def _vertices(manifold: Manifold) -> Array:
    return np.asarray(manifold.to_mesh64().vert_properties)[:, :3]


def _farthest(points: Array, solids: Manifold) -> tuple[float, Array]:
    """Return the largest distance of some points to the surface of a solid, and that point."""
    raw = solids.to_mesh64()
    corners = np.asarray(raw.vert_properties)[:, :3][np.asarray(raw.tri_verts).astype(int)]
    points = np.unique(points.round(7), axis=0)
    # no point is farther from the surface than from its nearest vertex: most are near one
    bound, _ = cKDTree(np.asarray(raw.vert_properties)[:, :3]).query(points)
    if bound.max() <= EXCESS_SURFACE:
        return float(bound.max()), points[int(np.argmax(bound))]
    order = np.argsort(-bound)
    points, bound = points[order], bound[order]
    low, high = corners.min(axis=1), corners.max(axis=1)
    worst, place = 0.0, points[0]
    for point, most in zip(points, bound, strict=True):
        if most <= worst:  # so are those that follow
            break
        # only triangles whose boxes are nearer than the nearest vertex can be nearer than it
        box = np.linalg.norm(np.maximum(np.maximum(low - point, point - high), 0.0), axis=1)
        near = corners[box <= most + 1e-9]
        closest = trimesh.triangles.closest_point(near, np.broadcast_to(point, (len(near), 3)))
        distance = float(np.linalg.norm(closest - point, axis=1).min())
        if distance > worst:
            worst, place = distance, point
    return worst, place
