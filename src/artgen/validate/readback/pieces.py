"""Colliders in files: their shape in a simulator, and the comparison of two."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

import numpy as np

from artgen._arrays import Array, Indices
from artgen.asset import Asset
from artgen.asset.link import Link
from artgen.asset.report import CHANGED, Finding
from artgen.colliders import Convex
from artgen.export.frames import translation
from artgen.export.hulls import hulls
from artgen.export.urdf import primitives

MOST_VERTICES = 64
"""Vertices that a collider may have; the budget of GPU simulators."""

_APART = 5e-6  # [m] by which a collider's bounds may differ: some formats have single precision
_VOLUME = 1e-3  # relative, for the same reason: pieces are thin
_FRICTION = 1e-6
_INSIDE = 1e-6  # [m] by which a vertex may lie inside the hull of the others
_SHOWN = 3  # colliders of a link


@dataclass(frozen=True, eq=False)
class ReadCollider:
    """A collider, in the frame of its link."""

    name: str  # what the file calls it
    bounds: Array  # corners of the bounding box, shape (2, 3) [m]
    middle: Array  # mean of its vertices; of a primitive its center, shape (3,) [m]
    volume: float  # [m^3]
    friction: float | None = None  # coefficient of sliding friction; None where the file does not say
    # those of a mesh, each once, shape (n, 3) [m]
    vertices: Array = field(default_factory=lambda: np.zeros((0, 3)))
    flaw: str = ""  # what a simulator would refuse or silently change, with the number

    @staticmethod
    def primitive(name: str, convex: Convex, friction: float | None = None, flaw: str = "") -> "ReadCollider":
        """Make the collider of a box or a round piece."""
        return ReadCollider(name, convex.bounds(), convex.pose[:3, 3], convex.volume, friction, flaw=flaw)

    @staticmethod
    def mesh(
        name: str, vertices: Array, triangles: Indices, friction: float | None = None, flaw: str = ""
    ) -> "ReadCollider":
        """Make the collider of a mesh; vertices at one place are one."""
        open_edges = _open_edges(triangles)
        if open_edges or len(vertices) > MOST_VERTICES:
            vertices, numbers = np.unique(vertices, axis=0, return_inverse=True)
            triangles = numbers.reshape(-1)[triangles]
            open_edges = _open_edges(triangles)
        volume = mesh_volume(vertices, triangles)
        if not np.isfinite(vertices).all():
            flaw = flaw or "has coordinates that are not finite"
        elif open_edges:
            flaw = flaw or f"is open: {open_edges} edges have a face on one side only"
        elif volume <= 0.0:
            flaw = flaw or f"is inside out: its volume is {1e6 * volume:.4g} cm^3"
        elif len(vertices) > MOST_VERTICES:
            flaw = flaw or f"has {len(vertices)} vertices; GPU simulators take at most {MOST_VERTICES}"
        bounds = np.array([vertices.min(axis=0), vertices.max(axis=0)])
        return ReadCollider(name, bounds, vertices.mean(axis=0), volume, friction, vertices, flaw)

    def concavity(self) -> float:
        """Return how far a vertex lies inside the hull of the others [m]."""
        from scipy.spatial import ConvexHull, QhullError

        try:
            planes = ConvexHull(self.vertices).equations
        except (QhullError, ValueError, IndexError):
            return 0.0
        return float(-(planes[:, :3] @ self.vertices.T + planes[:, 3:]).max(axis=0).min())


def mesh_volume(vertices: Array, triangles: Indices) -> float:
    """Return the volume inside closed triangles, shape (m, 3) [m^3]."""
    a, b, c = (vertices - vertices.mean(axis=0))[triangles.T]
    return float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6.0)


def _open_edges(triangles: Indices) -> int:
    """Return how many edges have not one triangle on either side."""
    if not len(triangles):
        return 1
    most = int(triangles.max()) + 1
    first, second = triangles.ravel(), triangles[:, [1, 2, 0]].ravel()
    forth, back = np.sort(first * most + second), np.sort(second * most + first)
    doubled = int((forth[1:] == forth[:-1]).sum())
    return doubled + len(np.setdiff1d(forth, back)) if doubled else len(np.setdiff1d(forth, back))


def expected_pieces(asset: Asset, *, capsules: bool) -> dict[str, tuple[ReadCollider, ...]]:
    """Return the colliders that a file should have; without capsules, a cylinder between two balls each."""
    made = hulls(asset)
    result = {}
    for link in asset.links:
        away = translation(-asset.origin(link.name))
        pieces: list[ReadCollider] = []
        for number, collider in enumerate(link.colliders):
            convex, friction = collider.convex, collider.material.friction
            name = f"{number} ({convex.kind} of {collider.label!r})"
            if convex.kind == "hull":
                hull = made[link.name][number]
                pieces.append(ReadCollider.mesh(name, hull.placed, hull.triangles, friction))
                continue
            placed = Convex(convex.kind, away @ convex.pose, convex.size)
            split = [placed] if capsules else [piece for _, piece in primitives(placed)]
            pieces += [ReadCollider.primitive(name, each, friction) for each in split]
        result[link.name] = tuple(pieces)
    return result


def piece_findings(
    check: str, link: Link, file: str, wanted: Sequence[ReadCollider], found: Sequence[ReadCollider]
) -> Iterator[Finding]:
    """Yield how the colliders of a link in a file differ from those of the asset."""
    complaints: list[tuple[str, float | None]] = [
        (f"its collider {piece.name} {piece.flaw} in {file}", None) for piece in found if piece.flaw
    ]
    pairs = _paired(wanted, found)
    if len(found) != len(wanted):
        yield _count_finding(check, link, file, wanted, found, pairs)
    else:
        seen = [(wanted[first], found[second], away) for first, second, away in pairs]
        complaints += [
            text
            for want, piece, away in seen
            if not piece.flaw
            for text in _differences(want, piece, away, file)
        ]
    for message, value in complaints[:_SHOWN]:
        yield Finding(check, message, link.name, value=value, hint=CHANGED)
    if len(complaints) > _SHOWN:
        message = f"{len(complaints) - _SHOWN} more of its colliders differ in {file}"
        yield Finding(check, message, link.name, value=float(len(complaints)), hint=CHANGED)


def _paired(wanted: Sequence[ReadCollider], found: Sequence[ReadCollider]) -> list[tuple[int, int, float]]:
    """Pair the colliders so that they differ least: their numbers, and by how much [m]."""
    from scipy.optimize import linear_sum_assignment

    if not wanted or not found:
        return []
    first, second = (
        np.array([[*piece.bounds.ravel(), *piece.middle] for piece in pieces]) for pieces in (wanted, found)
    )
    away = np.nan_to_num(np.abs(first[:, None] - second[None]).max(axis=2), nan=1e9, posinf=1e9)
    rows, columns = linear_sum_assignment(away)
    return [
        (int(row), int(column), float(away[row, column])) for row, column in zip(rows, columns, strict=True)
    ]


def _count_finding(
    check: str,
    link: Link,
    file: str,
    wanted: Sequence[ReadCollider],
    found: Sequence[ReadCollider],
    pairs: Sequence[tuple[int, int, float]],
) -> Finding:
    message = f"it has {len(found)} colliders in {file}, not {len(wanted)}"
    same = [(row, column) for row, column, away in pairs if away <= _APART]
    lost = [piece.name for number, piece in enumerate(wanted) if number not in {row for row, _ in same}]
    more = [piece.name for number, piece in enumerate(found) if number not in {column for _, column in same}]
    for what, names in (("without", lost), ("but also", more)):
        if names:
            message += f", {what} {', '.join(names[:_SHOWN])}"
    return Finding(check, message, link.name, value=float(len(found)), hint=CHANGED)


def _differences(
    wanted: ReadCollider, found: ReadCollider, away: float, file: str
) -> Iterator[tuple[str, float | None]]:
    name = f"its collider {found.name}"
    volumes = f"{1e6 * found.volume:.5g} cm^3 in {file}, not {1e6 * wanted.volume:.5g} cm^3"
    same_volume = abs(found.volume - wanted.volume) <= _VOLUME * wanted.volume
    depth = found.concavity() if len(found.vertices) and not (away <= _APART and same_volume) else 0.0
    if depth > _INSIDE:
        yield f"{name} is not convex in {file}: a vertex lies {1e3 * depth:.4g} mm inside its hull", depth
    elif not away <= _APART:
        yield f"{name} is off by {1e3 * away:.4g} mm and has {volumes}", away
    elif not same_volume:
        yield f"{name} has {volumes}", found.volume
    if found.friction is None or wanted.friction is None:
        return
    if not abs(found.friction - wanted.friction) <= _FRICTION:
        yield f"{name} has friction {found.friction:.4g} in {file}, not {wanted.friction:.4g}", found.friction
