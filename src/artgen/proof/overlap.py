"""Exact overlap of two links at one pose, and their first contact."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from manifold3d import Manifold

from artgen import _portable
from artgen._arrays import Array, Mask, cached_per_object
from artgen.asset import Asset, Link
from artgen.asset.collision import link_parts
from artgen.asset.joint import AllowedContact
from artgen.asset.manifolds import box_of, mesh_of
from artgen.colliders.triangles import cross
from artgen.proof.paths import JointPath

LEAST_VOLUME = 1e-13  # volume above which two solids count as overlapping [m^3]
PRESSED = 1e-5  # depth beyond the allowed depth above which pieces count as overlapping [m]
_MARCH = 48  # steps of the search for a first contact on the line from rest
_BISECTIONS = 16
_PARALLEL = 1e-6  # length of the cross product of unit vectors that count as parallel
_MOST_EDGES = 24  # edge directions of a piece that are crossed with those of the other piece


@dataclass(frozen=True, eq=False)
class Overlap:
    """The overlap of two links at a pose."""

    volume: float  # common volume [m^3]
    place: Array  # center of the largest common part, in link A's frame at rest, shape (3,) [m]
    labels: tuple[str, str]  # labels of the two solids of that part


def link_overlap(asset: Asset, joint_path: JointPath, positions: Array) -> Overlap | None:
    """Return the overlap of the exact solids of two links beyond allowed contacts, or None."""
    a, b = (asset.link(name) for name in joint_path.links)
    matrix = displacement(joint_path, positions)
    allowed = allowed_at(joint_path, positions)
    first, volume, largest, result = link_parts(a), 0.0, 0.0, None
    inverse = _portable.inverse(matrix)
    near = _meeting(_boxes(a), _boxes(b), matrix) & _meeting(_boxes(b), _boxes(a), inverse).T
    for column in np.flatnonzero(near.any(axis=0)).tolist():
        part = link_parts(b)[column]
        moved = part.solid.transform(matrix[:3])  # manifold3d computes it on first access
        for index in np.flatnonzero(near[:, column]).tolist():
            labels = first[index].label, part.label
            common = first[index].solid ^ moved
            size = common.volume()
            if size <= LEAST_VOLUME:
                continue
            depths = [contact.depth for contact in allowed if allows(contact, joint_path.links, labels)]
            if depths:
                thick = [each for each in common.decompose() if _width(each) > max(depths) + PRESSED]
                size = sum(each.volume() for each in thick)
                if size <= LEAST_VOLUME:
                    continue
                common = Manifold.compose(thick)
            volume += size
            if size > largest:
                largest = size
                result = Overlap(volume, box_of(common).mean(axis=0), labels)
    return None if result is None else replace(result, volume=volume)


def _meeting(boxes: Array, others: Array, matrix: Array) -> Mask:
    """Tell which boxes meet the bounding boxes of others after a transform, shape (n, m)."""
    half = (others[:, 1] - others[:, 0]) / 2.0
    middle = np.einsum("ij,nj->ni", matrix[:3, :3], others[:, 0] + half) + matrix[:3, 3]
    reach = np.einsum("ij,nj->ni", np.abs(matrix[:3, :3]), half)
    below = (boxes[:, None, 0] < middle + reach).all(axis=2)
    return np.asarray(below & (boxes[:, None, 1] > middle - reach).all(axis=2))


@cached_per_object
def _boxes(link: Link) -> Array:
    """Return the bounding boxes of the solids of a link, shape (n, 2, 3) [m]."""
    return np.array([box_of(part.solid) for part in link_parts(link)]).reshape(-1, 2, 3)


def allows(contact: AllowedContact, links: tuple[str, str], labels: tuple[str, str]) -> bool:
    """Tell whether a contact allows pieces with these labels on these links."""
    (a, b), (first, second) = links, labels
    return (contact.links, contact.labels) in (((a, b), (first, second)), ((b, a), (second, first)))


def allowed_at(joint_path: JointPath, positions: Array) -> tuple[AllowedContact, ...]:
    """Return the contacts that are allowed at positions of a path's variables, shape (v,)."""
    found = [
        contact
        for box, contacts in zip(joint_path.boxes, joint_path.allowed, strict=True)
        if (box[:, 0] <= positions).all() and (positions <= box[:, 1]).all()
        for contact in contacts
    ]
    return tuple(dict.fromkeys(found))


def displacement(joint_path: JointPath, positions: Array) -> Array:
    """Return the transform that takes link B from rest to a pose in link A's frame, shape (4, 4)."""
    matrix = np.eye(4)
    values = dict(zip(joint_path.variables, positions.tolist(), strict=True))
    for joint, sign, follower in zip(joint_path.steps, joint_path.signs, joint_path.followers, strict=True):
        matrix = matrix @ joint.motion(sign * follower.at(values.get(follower.leader, 0.0)))
    return matrix


def penetration(first: Manifold, second: Manifold) -> float:
    """Return the penetration depth of two convex pieces or slightly more: the shortest way apart [m]."""
    (a, faces, edges), (b, more_faces, more_edges) = _features(first), _features(second)
    crossed = _unit(cross(edges[:, None, :], more_edges[None, :, :]).reshape(-1, 3), _PARALLEL)
    normals = np.concatenate((faces, -more_faces, crossed, -crossed))
    gaps = _portable.product(b, normals.T).min(axis=0) - _portable.product(a, normals.T).max(axis=0)
    return float(-gaps.max())


def first_contact(touch: Callable[[Array], bool], start: Array, end: Array) -> float:
    """Return the share of the line from rest to touching positions at which links first touch.

    All positions have shape (v,) [rad or m].
    """
    shares = np.linspace(0.0, 1.0, _MARCH + 1)
    line = end - start
    high = next((index for index, share in enumerate(shares) if touch(start + share * line)), _MARCH)
    if high == 0:
        return 0.0
    low, up = float(shares[high - 1]), float(shares[high])
    for _ in range(_BISECTIONS):
        middle = (low + up) / 2.0
        low, up = (low, middle) if touch(start + middle * line) else (middle, up)
    return up


def _features(piece: Manifold) -> tuple[Array, Array, Array]:
    """Return vertices, outward unit normals of faces and unit directions of edges of a convex piece."""
    corners, triangles = mesh_of(piece)
    a, b, c = corners[triangles.T]
    normals = _unit(cross(b - a, c - a))
    sides = np.concatenate((b - a, c - b, a - c))
    longest = np.argsort(-np.round(np.sum(sides * sides, axis=1), 12), kind="stable")
    edges = _unit(sides[longest])
    _, index = np.unique(np.round(np.abs(edges), 6), axis=0, return_index=True)
    return corners, normals, edges[np.sort(index)[:_MOST_EDGES]]


def _width(solid: Manifold) -> float:
    """Return the smallest extent of a solid across the faces of its hull [m]."""
    corners, normals, _ = _features(solid.hull())
    return float(np.ptp(_portable.product(corners, normals.T), axis=0).min())


def _unit(vectors: Array, shortest: float = 0.0) -> Array:
    """Return the directions of the vectors that are longer than the shortest one."""
    length = np.sqrt(np.sum(vectors * vectors, axis=1))
    return np.asarray(vectors[length > shortest] / length[length > shortest][:, None])
