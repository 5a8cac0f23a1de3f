"""Collisions between links by python-fcl, at given positions of the joints."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import fcl
import numpy as np
from numpy.typing import NDArray

from artgen.asset import Asset, Link
from artgen.colliders import Convex

Array = NDArray[np.float64]
Pairs = Sequence[tuple[str, str]]

CONTACTS = 1000
"""Contacts of a pair of bodies that are looked at."""


@dataclass(frozen=True, eq=False)
class Body:
    """A rigid piece of a link.

    Attributes:
        geometry: Geometry of FCL.
        pose: From its frame to the link's, shape (4, 4) [m].
    """

    geometry: Any
    pose: Array


class Links:
    """Links made of bodies, each in a tree of boxes.

    Args:
        bodies: The bodies of each link.
    """

    def __init__(self, bodies: Mapping[str, Sequence[Body]]) -> None:
        self._objects = {
            name: [(fcl.CollisionObject(body.geometry), body.pose) for body in each]
            for name, each in bodies.items()
        }
        self._managers = {}
        for name, objects in self._objects.items():
            manager = fcl.DynamicAABBTreeCollisionManager()
            manager.registerObjects([each for each, _ in objects])
            manager.setup()
            self._managers[name] = manager

    def place(self, poses: Mapping[str, Array]) -> None:
        """Set the frames of links, shape (4, 4) each [m]."""
        for name, pose in poses.items():
            for each, own in self._objects.get(name, ()):
                matrix = pose @ own
                each.setTransform(fcl.Transform(matrix[:3, :3], matrix[:3, 3]))
            if name in self._managers:
                self._managers[name].update()

    def collide(self, pairs: Pairs) -> list[tuple[str, str]]:
        """Return the pairs of links that touch or overlap; the check of a pair ends at its first contact."""
        found = []
        for first, second in pairs:
            data = fcl.CollisionData(request=fcl.CollisionRequest(num_max_contacts=1))
            self._managers[first].collide(self._managers[second], data, fcl.defaultCollisionCallback)
            if data.result.is_collision:
                found.append((first, second))
        return found

    def depths(self, pairs: Pairs) -> dict[tuple[str, str], float]:
        """Return the largest penetration of each touching pair of links [m]."""
        found = {}
        for first, second in pairs:
            request = fcl.CollisionRequest(num_max_contacts=CONTACTS, enable_contact=True)
            data = fcl.CollisionData(request=request)
            self._managers[first].collide(self._managers[second], data, fcl.defaultCollisionCallback)
            if data.result.is_collision:
                depths = [abs(contact.penetration_depth) for contact in data.result.contacts]
                found[first, second] = max(depths, default=0.0)
        return found


def convex_body(vertices: Array, triangles: NDArray[np.int64], pose: Array) -> Body:
    """Return a convex body of a closed mesh, shapes (n, 3) [m] and (m, 3)."""
    counted = np.hstack([np.full((len(triangles), 1), 3), triangles]).astype(np.int32)
    return Body(fcl.Convex(np.ascontiguousarray(vertices), len(triangles), counted.ravel()), pose)


def mesh_body(vertices: Array, triangles: NDArray[np.int64], pose: Array) -> Body:
    """Return the surface of a mesh as a body, shapes (n, 3) [m] and (m, 3); it is hollow."""
    model = fcl.BVHModel()
    model.beginModel(len(vertices), len(triangles))
    model.addSubModel(vertices, triangles)
    model.endModel()
    return Body(model, pose)


def convex_links(asset: Asset) -> Links:
    """Return the colliders of an asset, each a convex body."""
    return Links({link.name: [_body(each.convex) for each in link.colliders] for link in asset.links})


def surface_links(asset: Asset) -> Links:
    """Return the colliders of an asset, those of a link as one surface: faster, but hollow."""
    return Links({link.name: [_surface(link)] for link in asset.links if link.colliders})


def moving_pairs(asset: Asset) -> list[tuple[str, str]]:
    """Return the pairs of links that move against each other and may not touch by design."""
    group = {asset.links[0].name: 0}
    for number, (parent, child, joints) in enumerate(asset.pairs(), 1):
        group[child] = group[parent] if all(joint.locked for joint in joints) else number
    allowed = [set(contact.links) for contact in asset.contacts]
    names = [link.name for link in asset.links if link.colliders]
    return [(a, b) for a, b in combinations(names, 2) if group[a] != group[b] and {a, b} not in allowed]


def random_positions(asset: Asset, count: int, seed: int = 0) -> list[dict[str, float]]:
    """Draw positions of the free joints, uniform in their ranges, that no dependency forbids [rad or m]."""
    draw = np.random.default_rng(seed)
    found: list[dict[str, float]] = []
    while len(found) < count:
        q = {
            joint.name: float(draw.uniform(*(joint.limits or (-np.pi, np.pi)))) for joint in asset.free_joints
        }
        if not asset.blocked(q):
            found.append(q)
    return found


def _body(convex: Convex) -> Body:
    """Return a collider as a primitive of FCL if possible."""
    size = convex.size
    if convex.kind == "box":
        return Body(fcl.Box(*size), convex.pose)
    if convex.kind == "cylinder":
        return Body(fcl.Cylinder(*size), convex.pose)
    if convex.kind == "sphere":
        return Body(fcl.Sphere(*size), convex.pose)
    if convex.kind == "capsule":
        return Body(fcl.Capsule(*size), convex.pose)
    return convex_body(*_triangles(convex), np.eye(4))


def _surface(link: Link) -> Body:
    vertices, triangles, start = [], [], 0
    for each in link.colliders:
        points, corners = _triangles(each.convex)
        vertices.append(points)
        triangles.append(corners + start)
        start += len(points)
    return mesh_body(np.concatenate(vertices), np.concatenate(triangles), np.eye(4))


def _triangles(convex: Convex) -> tuple[Array, NDArray[np.int64]]:
    """Return a collider as a closed mesh."""
    mesh = convex.manifold().to_mesh64()
    vertices = np.ascontiguousarray(np.asarray(mesh.vert_properties, np.float64)[:, :3])
    return vertices, np.asarray(mesh.tri_verts, np.int64)
