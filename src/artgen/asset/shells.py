"""Connected shells of the surfaces of a link, for solids in memory and for meshes read from files."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from manifold3d import Manifold, Mesh64
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from artgen._arrays import Array, FrozenArrays, Indices, cached_per_object, cached_property
from artgen.asset import Link, Mesh
from artgen.asset.distance import distinct_rows

_WELD_MEMORY = 1e-9  # distance within which corners of solids are one point [m]
_WELD_FILES = 4e-7  # the same for mesh files, which have 7 decimals [m]


@dataclass(frozen=True, eq=False)
class Shell(FrozenArrays):
    """A connected part of a surface; solids that share an edge are one."""

    label: str  # label of its piece or surface
    piece: int  # number of its piece on the link; 0 for all shells that were read from files
    points: Array  # distinct corners, shape (n, 3) [m]
    triangles: Indices  # indices into `points`, shape (m, 3)
    hollows: tuple["Shell", ...] = ()  # the walls of the hollows inside it

    @cached_property
    def corners(self) -> Array:
        """The corners of each triangle, shape (m, 3, 3) [m]."""
        return self.points[self.triangles]

    @cached_property
    def area(self) -> float:
        """Surface area [m^2]."""
        a, b, c = self.corners[:, 0], self.corners[:, 1], self.corners[:, 2]
        return float(0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum())

    @cached_property
    def _moments(self) -> tuple[float, Array]:
        reference = self.points.mean(axis=0)
        a, b, c = (self.corners[:, number] - reference for number in range(3))
        volumes = np.einsum("ij,ij->i", a, np.cross(b, c)) / 6.0
        volume = float(volumes.sum())
        first = (volumes[:, None] * (a + b + c)).sum(axis=0) / 4.0
        return volume, reference + (first / volume if volume else 0.0)

    @property
    def volume(self) -> float:
        """Enclosed volume, negative where the surface is turned inside out or bounds a hollow [m^3]."""
        return self._moments[0]

    @property
    def center(self) -> Array:
        """Center of the enclosed volume, shape (3,) [m]."""
        return self._moments[1]

    @property
    def thickness(self) -> float:
        """Mean thickness: the thickness of a plate, half the diameter of a wire [m]."""
        return 2.0 * abs(self.volume) / self.area if self.area else 0.0

    @cached_property
    def bounds(self) -> Array:
        """Corners of the bounding box, shape (2, 3) [m]."""
        return np.array([self.points.min(axis=0), self.points.max(axis=0)])

    @cached_property
    def manifold(self) -> Manifold:
        """The enclosed solid without its hollows, as a manifold with unchecked status."""
        wall = Manifold(Mesh64(np.array(self.points), self.triangles.astype(np.uint64)))
        for hollow in self.hollows:
            turned = hollow.triangles[:, ::-1].astype(np.uint64)
            wall -= Manifold(Mesh64(np.array(hollow.points), turned))
        return wall

    def winds_around(self, point: Array) -> float:
        """Return how many times the shell encloses a point, shape (3,): 1 inside, 0 outside."""
        a, b, c = (self.corners[:, number] - point for number in range(3))
        lengths = [np.linalg.norm(each, axis=1) for each in (a, b, c)]
        above = np.einsum("ij,ij->i", a, np.cross(b, c))
        below = (
            lengths[0] * lengths[1] * lengths[2]
            + np.einsum("ij,ij->i", a, b) * lengths[2]
            + np.einsum("ij,ij->i", b, c) * lengths[0]
            + np.einsum("ij,ij->i", c, a) * lengths[1]
        )
        return float(np.arctan2(above, below).sum() / (2.0 * np.pi))


@dataclass(frozen=True, eq=False)
class LinkShells(FrozenArrays):
    """The surface of a piece, or of all of a link that was read from files."""

    label: str  # label of the piece; empty for a whole link
    shells: tuple[Shell, ...] = ()  # its connected parts
    detail: bool | None = None  # whether the piece is only seen; None where the files do not tell
    finite: bool = True  # whether all coordinates are finite; nothing else is known if they are not
    open_edges: int = 0  # edges with a face on one side only
    turned_edges: int = 0  # edges whose faces are wound against each other
    doubled: int = 0  # triangles that lie on another one of the same winding
    flat: int = 0  # triangles of less height than `_FLAT`
    against: int = 0  # triangles that lean away from a normal at their corners by more than 60 degrees
    place: Array = field(default_factory=lambda: np.zeros(3))  # a point of the first fault, shape (3,) [m]
    triangles: int = 0  # number of triangles

    @cached_property
    def solids(self) -> tuple[Shell, ...]:
        """The shells around solids, each with its hollows; none if the surface is not closed."""
        if not self.closed:
            return ()
        outer = [shell for shell in self.shells if shell.volume > 0.0]
        owners = [_owner(shell, outer) for shell in self.shells if shell.volume < 0.0]
        hollows = [shell for shell in self.shells if shell.volume < 0.0]
        return tuple(
            replace(
                shell,
                hollows=tuple(
                    hollow for hollow, owner in zip(hollows, owners, strict=True) if owner == number
                ),
            )
            for number, shell in enumerate(outer)
        )

    @property
    def closed(self) -> bool:
        """Whether every edge has a face on either side, wound alike."""
        return self.finite and not self.open_edges and not self.turned_edges


def _owner(hollow: Shell, outer: Sequence[Shell]) -> int:
    """Return the number of the smallest shell whose box contains the box of a hollow; -1 if there is none."""
    low, high = hollow.bounds
    around = [
        (shell.volume, number)
        for number, shell in enumerate(outer)
        if (shell.bounds[0] <= low).all()
        and (high <= shell.bounds[1]).all()
        and shell.volume > -hollow.volume
    ]
    return min(around, default=(0.0, -1))[1]


_FLAT = 1e-8  # height below which a triangle is flat [m]
_JUDGED = 2e-5  # least height of a triangle with a meaningful normal in mesh files [m]
_AGAINST = 0.5  # least cosine between a face and a normal at its corners: 60 degrees


@cached_per_object
def skins(link: Link) -> tuple[LinkShells, ...]:
    """Return the surface of each piece of a link, or of the whole link if it was read from files."""
    if link.pieces:
        return tuple(
            _skin(piece.shape.mesh, None, [piece.label], _WELD_MEMORY, number, detail=piece.visual)
            for number, piece in enumerate(link.pieces)
        )
    if not link.surfaces:
        return ()
    meshes = [surface.mesh for surface in link.surfaces]
    labels = np.repeat(np.arange(len(meshes)), [len(mesh.triangles) for mesh in meshes])
    names = [surface.label for surface in link.surfaces]
    return (_skin(Mesh.concatenated(meshes), labels, names, _WELD_FILES),)


def _skin(
    mesh: Mesh,
    labels: Indices | None,
    names: list[str],
    reach: float,
    piece: int = 0,
    *,
    detail: bool | None = None,
) -> LinkShells:
    """Weld coincident corners, count the faults and split the surface into shells."""
    label = names[0] if detail is not None else ""
    if not np.isfinite(mesh.vertices).all():
        return LinkShells(label, detail=detail, finite=False, triangles=len(mesh.triangles))
    if labels is None:
        labels = np.zeros(len(mesh.triangles), np.int64)
    points, number = _welded(mesh.vertices, reach)
    faces = number[mesh.triangles]
    proper = (faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2]) & (faces[:, 2] != faces[:, 0])
    against = _against(mesh)
    faces, labels, corners = faces[proper], labels[proper], mesh.vertices[mesh.triangles]
    turned = np.argmin(faces, axis=1)[:, None] + np.arange(3)
    _, first, _ = distinct_rows(np.take_along_axis(faces, turned % 3, axis=1))
    doubled = len(faces) - len(first)
    first.sort()
    faces, labels = faces[first], labels[first]
    edges = _Edges.of(faces)
    faulty = np.concatenate([edges.open, edges.turned])
    places = [*points[faulty[:1, 0]], *corners[against[:1], 0]]
    return LinkShells(
        label,
        tuple(_shells(points, faces, edges, labels, names, piece)),
        detail,
        open_edges=len(edges.open),
        turned_edges=len(edges.turned),
        doubled=doubled,
        flat=int((_heights(corners) < _FLAT).sum()),
        against=len(against),
        place=np.asarray(places[0]) if places else np.zeros(3),
        triangles=len(mesh.triangles),
    )


def point_text(point: Iterable[float]) -> str:
    """Format a point in millimetres."""
    return "(" + ", ".join(f"{round(1e3 * value, 1) + 0.0:.1f}" for value in point) + ") mm"


def _welded(vertices: Array, reach: float) -> tuple[Array, Indices]:
    """Return the distinct points, joined within a reach [m], and the number of the point of each vertex."""
    distinct, _, number = distinct_rows(vertices)
    pairs = cKDTree(distinct).query_pairs(reach, output_type="ndarray")
    if not len(pairs):
        return distinct, number
    graph = coo_array((np.ones(len(pairs)), pairs.T), shape=(len(distinct), len(distinct)))
    _, group = connected_components(graph, directed=False)
    _, first = np.unique(group, return_index=True)
    return distinct[first], group.astype(np.int64)[number]


def _heights(corners: Array) -> Array:
    """Return the least height of each triangle, shape (m,) [m]."""
    across = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    longest = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(axis=1)
    return np.asarray(across / np.maximum(longest, 1e-300))


def _against(mesh: Mesh) -> Indices:
    """Return the triangles that lean away from a normal at one of their corners."""
    corners = mesh.vertices[mesh.triangles]
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    size = np.linalg.norm(across, axis=1)
    normals = mesh.normals[mesh.triangles]
    cosine = np.einsum("ij,ikj->ik", across, normals).min(axis=1) / np.maximum(size, 1e-300)
    return np.flatnonzero((cosine < _AGAINST) & (_heights(corners) > _JUDGED))


@dataclass(frozen=True, eq=False)
class _Edges(FrozenArrays):
    """The edges of triangles."""

    open: Indices  # ends of the edges with one face, shape (k, 2)
    turned: Indices  # ends of the edges whose faces are wound against each other, shape (k, 2)
    neighbors: Indices  # pairs of faces that share an edge, shape (k, 2)

    @staticmethod
    def of(faces: Indices) -> "_Edges":
        directed = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
        forward = np.where(directed[:, 0] < directed[:, 1], 1, -1)
        ends, _, edge = distinct_rows(np.sort(directed, axis=1))
        count = np.bincount(edge, minlength=len(ends))
        balance = np.bincount(edge, forward, minlength=len(ends))
        order = np.argsort(edge, kind="stable")
        face = np.tile(np.arange(len(faces)), 3)[order]
        same = np.flatnonzero(edge[order][1:] == edge[order][:-1])
        unbalanced = balance != 0.0
        single = unbalanced & (count % 2 == 1)
        neighbors = np.column_stack([face[same], face[same + 1]])
        return _Edges(ends[single], ends[unbalanced & ~single], neighbors)


def _shells(
    points: Array, faces: Indices, edges: _Edges, labels: Indices, names: list[str], piece: int
) -> Iterator[Shell]:
    if not len(faces):
        return
    near = edges.neighbors
    graph = coo_array((np.ones(len(near)), near.T), shape=(len(faces), len(faces)))
    count, group = connected_components(graph, directed=False)
    order = np.argsort(group, kind="stable")
    ends = np.cumsum(np.bincount(group, minlength=count))
    for of_shell in np.split(order, ends[:-1]):
        used, triangles = np.unique(faces[of_shell], return_inverse=True)
        yield Shell(names[labels[of_shell[0]]], piece, points[used], triangles.reshape(-1, 3))
