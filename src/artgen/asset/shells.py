"""Surfaces of triangles: connected shells with their faults, distances, and points spread over them."""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from manifold3d import Manifold, Mesh64
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree
from trimesh.triangles import closest_point

from artgen import _portable
from artgen._arrays import Array, FrozenArrays, Indices, cached_per_object, cached_property, distinct_rows
from artgen.asset import Link, Mesh
from artgen.asset.manifolds import mesh_of
from artgen.asset.mass import Moments, polyhedron_moments
from artgen.colliders.triangles import across, cross


def winding_number(corners: Array, point: Array) -> float:
    """Return how many times triangles, shape (m, 3, 3), enclose a point, shape (3,): 1 inside, 0 outside.

    It is the sum of the solid angles of the triangles (van Oosterom and Strackee) by 4 pi.
    """
    a, b, c = np.moveaxis(corners - point, 1, 0)
    lengths = [np.linalg.norm(each, axis=1) for each in (a, b, c)]
    above = np.einsum("ij,ij->i", a, cross(b, c))
    below = (
        lengths[0] * lengths[1] * lengths[2]
        + np.einsum("ij,ij->i", a, b) * lengths[2]
        + np.einsum("ij,ij->i", b, c) * lengths[0]
        + np.einsum("ij,ij->i", c, a) * lengths[1]
    )
    return float(_portable.arctan2(above, below).sum() / (2.0 * np.pi))


_WELD_MEMORY = 1e-9  # distance within which corners of solids are one point [m]
_WELD_FILES = 4e-7  # the same for mesh files, which have 7 decimals [m]


@dataclass(frozen=True, eq=False)
class Shell(FrozenArrays):
    """A connected part of a surface; solids that share an edge are two."""

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
        return float(0.5 * across(self.corners)[1].sum())

    @cached_property
    def _moments(self) -> Moments:
        return polyhedron_moments(self.points, self.triangles)

    @property
    def volume(self) -> float:
        """Enclosed volume, negative where the surface is turned inside out or bounds a hollow [m^3]."""
        return self._moments.zeroth

    @property
    def center(self) -> Array:
        """Center of the enclosed volume, shape (3,) [m]."""
        return self._moments.first / self.volume if self.volume else self.points.mean(axis=0)

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


@dataclass(frozen=True, eq=False)
class LinkShells(FrozenArrays):
    """The surface of a piece, or of all of a link that was read from files."""

    label: str  # label of the piece; empty for a whole link
    shells: tuple[Shell, ...] = ()  # its connected parts
    finite: bool = True  # whether all coordinates are finite; nothing else is known if they are not
    open_edges: int = 0  # edges with a face on one side only
    turned_edges: int = 0  # edges whose faces are wound against each other
    doubled: int = 0  # triangles that lie on another one of the same winding
    flat: int = 0  # triangles of less height than `_FLAT`
    # triangles that lean away from the mean of their normals by more than 60 degrees, or from one by 90
    against: int = 0
    place: Array = field(default_factory=lambda: np.zeros(3))  # a point of the first fault, shape (3,) [m]
    triangles: int = 0  # number of triangles

    @cached_property
    def solids(self) -> tuple[Shell, ...]:
        """The shells around solids, each with its hollows; none if the surface is not closed."""
        if not self.closed:
            return ()
        outer = [shell for shell in self.shells if shell.volume > 0.0]
        hollows: list[list[Shell]] = [[] for _ in outer]
        for wall in (shell for shell in self.shells if shell.volume < 0.0):
            # the smallest shell whose box contains the box of the wall
            around = [
                (shell.volume, number)
                for number, shell in enumerate(outer)
                if (shell.bounds[0] <= wall.bounds[0]).all() and (wall.bounds[1] <= shell.bounds[1]).all()
                if shell.volume > -wall.volume
            ]
            if around:
                hollows[min(around)[1]].append(wall)
        return tuple(replace(shell, hollows=tuple(each)) for shell, each in zip(outer, hollows, strict=True))

    @property
    def closed(self) -> bool:
        """Whether every edge has a face on either side, wound alike."""
        return self.finite and not self.open_edges and not self.turned_edges


_FLAT = 1e-8  # height below which a triangle is flat [m]
_JUDGED = 2e-5  # least height of a triangle with a meaningful normal in mesh files [m]
_AGAINST = 0.5  # least cosine between a face and the mean of the normals at its corners: 60 degrees


@cached_per_object
def skins(link: Link) -> tuple[LinkShells, ...]:
    """Return the surface of each piece of a link, or of the whole link if it was read from files."""
    if link.pieces:
        return tuple(
            _skin(piece.shape.mesh, [piece.label], _WELD_MEMORY, piece.label, number)
            for number, piece in enumerate(link.pieces)
        )
    if not link.surfaces:
        return ()
    labels = [surface.label for surface in link.surfaces for _ in surface.mesh.triangles]
    return (_skin(Mesh.concatenated([surface.mesh for surface in link.surfaces]), labels, _WELD_FILES),)


def _skin(mesh: Mesh, labels: Sequence[str], reach: float, label: str = "", piece: int = 0) -> LinkShells:
    """Weld coincident corners, count the faults and split the surface into shells."""
    # `labels` has the label of each triangle, or one for all
    if not np.isfinite(mesh.vertices).all():
        return LinkShells(label, finite=False, triangles=len(mesh.triangles))
    points, number = _welded(mesh.vertices, reach)
    faces = number[mesh.triangles]
    proper = (faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2]) & (faces[:, 2] != faces[:, 0])
    corners = mesh.vertices[mesh.triangles]
    products, size = across(corners)
    sides = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)
    height = size / np.maximum(sides.max(axis=1), 1e-300)  # the least of each triangle
    normals = mesh.normals[mesh.triangles]
    # normals at the corners of a coarse facet lean away from each other, their mean does not lean from it
    mean = np.einsum("ij,ij->i", products, normals.sum(axis=1))
    leans = mean < _AGAINST * np.maximum(size * np.linalg.norm(normals.sum(axis=1), axis=1), 1e-300)
    leans |= np.einsum("ij,ikj->ik", products, normals).min(axis=1) < 0.0
    against = np.flatnonzero(leans & (height > _JUDGED))
    chosen = np.flatnonzero(proper)
    turned = np.argmin(faces[chosen], axis=1)[:, None] + np.arange(3)
    _, first, _ = distinct_rows(np.take_along_axis(faces[chosen], turned % 3, axis=1))
    second = np.delete(chosen, first)  # triangles that lie on others
    chosen = chosen[np.sort(first)]
    faces = faces[chosen]
    unpaired, twisted, neighbors = _edges(points, faces)
    faulty = np.concatenate([unpaired, twisted])
    places = [*corners[second[:1], 0], *points[faulty[:1, 0]], *corners[against[:1], 0], np.zeros(3)]
    shells = []
    for of_shell in _parts(faces, neighbors):
        name = labels[chosen[of_shell[0]]] if len(labels) > 1 else labels[0]
        shells.append(_shell(points, faces[of_shell], name, piece))
    return LinkShells(
        label,
        tuple(shells),
        open_edges=len(unpaired),
        turned_edges=len(twisted),
        doubled=len(second),
        flat=int((height < _FLAT).sum()),
        against=len(against),
        place=places[0],
        triangles=len(mesh.triangles),
    )


def file_shells(mesh: Mesh, label: str) -> list[Shell]:
    """Return the connected parts of a mesh that was read from a file; they are open where it is open.

    Solids that share an edge are shells of their own, and so is each of two equal solids.
    """
    points, number = _welded(mesh.vertices, _WELD_FILES)
    faces = number[mesh.triangles]
    faces = faces[(faces != np.roll(faces, 1, axis=1)).all(axis=1)]
    return [_shell(points, faces[part], label, 0) for part in _parts(faces, _edges(points, faces)[2])]


def _shell(points: Array, faces: Indices, label: str, piece: int) -> Shell:
    used, triangles = np.unique(faces, return_inverse=True)
    return Shell(label, piece, points[used], triangles.reshape(-1, 3))


def _parts(faces: Indices, neighbors: Indices) -> list[Indices]:
    """Return the faces of each connected part, ascending; `neighbors` has pairs of faces, shape (k, 2)."""
    # folds enclose nothing and are no parts: each of their triangles lies on one with the opposite winding
    if not len(faces):
        return []
    group = _groups(len(faces), neighbors)
    parts = np.split(np.argsort(group, kind="stable"), np.cumsum(np.bincount(group))[:-1])
    corners = np.sort(faces, axis=1)
    return [part for part in parts if 2 * len(distinct_rows(corners[part])[0]) > len(part)]


def point_text(point: Iterable[float]) -> str:
    """Format a point in millimetres."""
    return "(" + ", ".join(f"{round(1e3 * value, 1) + 0.0:.1f}" for value in point) + ") mm"


def _welded(vertices: Array, reach: float) -> tuple[Array, Indices]:
    """Return the distinct points, joined within a reach [m], and the number of the point of each vertex."""
    distinct, _, number = distinct_rows(vertices)
    pairs = cKDTree(distinct).query_pairs(reach, output_type="ndarray")
    if not len(pairs):
        return distinct, number
    group = _groups(len(distinct), pairs)
    return distinct[np.unique(group, return_index=True)[1]], group[number]


def _groups(count: int, pairs: Indices) -> Indices:
    """Return the number of the group of each of several things that pairs, shape (k, 2), connect."""
    graph = coo_array((np.ones(len(pairs)), pairs.T), shape=(count, count))
    return np.asarray(connected_components(graph, directed=False)[1], np.int64)


def _edges(points: Array, faces: Indices) -> tuple[Indices, Indices, Indices]:
    """Return edges with one face, edges of two faces wound against each other, and faces that share edges."""
    # each row has two ends or two faces, shape (k, 2); at an edge of solids, each has a face on either side
    directed = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    forward = np.where(directed[:, 0] < directed[:, 1], 1, -1)
    ends, _, edge = distinct_rows(np.sort(directed, axis=1))
    count = np.bincount(edge, minlength=len(ends))
    unbalanced = np.bincount(edge, forward, minlength=len(ends)) != 0.0
    order = np.argsort(edge, kind="stable")
    face = np.tile(np.arange(len(faces)), 3)
    same = order[np.flatnonzero(edge[order][1:] == edge[order][:-1])[:, None] + (0, 1)]
    single = unbalanced & (count % 2 == 1)
    shared = ~unbalanced & (count > 2)
    neighbors = face[same[~shared[edge[same[:, 0]]]]]
    if shared.any():
        part = _groups(len(faces), neighbors)
        starts = np.append(0, np.cumsum(count))
        pairs = [neighbors]
        for number in np.flatnonzero(shared):
            found = order[starts[number] : starts[number + 1]]
            ahead, behind = (face[found[forward[found] == way]] for way in (1, -1))
            pairs.append(_around(points, faces, ends[number], ahead, behind, part))
        neighbors = np.concatenate(pairs)
    return ends[single], ends[unbalanced & ~single], neighbors


_CLOSE = 2e-3  # faces at a smaller angle have nothing between them [rad]


def _around(
    points: Array, faces: Indices, ends: Indices, ahead: Indices, behind: Indices, part: Indices
) -> Indices:
    """Return the pairs of faces between which a solid lies at an edge, shape (k, 2)."""
    # of one part, at the least angle of the solid; `ahead` run from the first of the `ends` to the second
    start, end = points[ends]
    along = (end - start) / _portable.norm(end - start)
    first = cross(along, np.eye(3)[np.argmin(abs(along))])
    tips = points[faces[np.append(ahead, behind)]].sum(axis=1) - end - 2.0 * start
    x, y = (np.einsum("ij,j->i", tips, axis) for axis in (first, cross(along, first)))
    angles = np.split(_portable.arctan2(y, x), 2)
    gaps = np.round(np.subtract.outer(*angles) % math.tau, 3)
    gaps[gaps < _CLOSE] += math.tau
    gaps[np.equal.outer(part[ahead], part[behind])] = -1.0
    one, other = (each.ravel() for each in np.meshgrid(ahead, behind, indexing="ij"))
    order = np.lexsort((part[other], part[one], gaps.ravel()))
    pairs: dict[int, int] = {}
    for face, opposite in zip(one[order].tolist(), other[order].tolist(), strict=True):
        if face not in pairs and opposite not in pairs.values():
            pairs[face] = opposite
    return np.array(list(pairs.items()))


_CHUNK = 128  # points compared with all triangles at once
_TRIED = 8  # nearest samples whose triangles are tried first: a corner has about six
_ON = 1e-6  # distance within which a point lies on the surface [m]


@dataclass(frozen=True, eq=False)
class TriangleSet(FrozenArrays):
    """Triangles of a surface."""

    corners: Array  # the corners of each triangle, shape (m, 3, 3) [m]

    @staticmethod
    def of(solid: Manifold) -> "TriangleSet":
        """Return the triangles of a solid's surface."""
        vertices, triangles = mesh_of(solid)
        return TriangleSet(vertices[triangles])

    @cached_property
    def areas(self) -> Array:
        """Area of each triangle, shape (m,) [m^2]."""
        return 0.5 * across(self.corners)[1]

    def spread(self, count: int) -> Array:
        """Return the corners and about `count` points spread evenly over the area, shape (n, 3) [m].

        The same triangles give the same points.
        """
        return self._sampled(count)[0]

    def _sampled(self, count: int) -> tuple[Array, Indices]:
        """Return the points of `spread`, and the triangle of each point, shape (n,)."""
        corners, owners = self.corners.reshape(-1, 3), np.repeat(np.arange(len(self.corners)), 3)
        ends = np.cumsum(self.areas)
        if not len(ends) or ends[-1] <= 0.0:
            return corners, owners
        step = ends[-1] / count
        at = (np.arange(count) + 0.5) * step
        index = np.minimum(np.searchsorted(ends, at), len(ends) - 1)
        # multiples of the plastic ratio fill every triangle evenly
        u, v = (np.arange(1, count + 1) * ratio % 1.0 for ratio in (0.7548776662466927, 0.5698402909980532))
        u, v = np.where(u + v > 1.0, 1.0 - u, u), np.where(u + v > 1.0, 1.0 - v, v)
        a, b, c = (self.corners[index, corner] for corner in range(3))
        inner = a + u[:, None] * (b - a) + v[:, None] * (c - a)
        return np.concatenate([corners, inner]), np.concatenate([owners, index])

    @cached_property
    def _tree(self) -> tuple[cKDTree, Indices]:
        points, owners = self._sampled(2000)
        return cKDTree(points), owners

    def farthest(self, points: Array, *, outside: bool = False) -> tuple[float, Array]:
        """Return the largest distance of points to the surface [m], and the point."""
        points, _, _ = distinct_rows(np.round(points, 8))
        bound = self._near(points)
        order = np.argsort(-bound, kind="stable")
        points, bound = points[order], bound[order]
        best, place = -1.0, points[0]
        for start in range(0, len(points), _CHUNK):
            if bound[start] <= best:
                break  # the bound of every later point is smaller
            distances = self._distances(points[start : start + _CHUNK], bound[start : start + _CHUNK])
            for number in np.argsort(-distances, kind="stable").tolist():
                if distances[number] <= best:
                    break
                point = points[start + number]
                if not outside or distances[number] < _ON or winding_number(self.corners, point) <= 0.5:
                    best, place = float(distances[number]), point
                    break
        return max(best, 0.0), place

    def _near(self, points: Array) -> Array:
        """Return an upper bound of the distance of each point, mostly tight, shape (n,) [m]."""
        tree, owners = self._tree
        samples = tree.query(points, k=np.arange(1, min(_TRIED, tree.n) + 1))[1].T
        nearest = [_closest(self.corners[owners[each]], points) for each in samples]
        return np.asarray(np.min([np.linalg.norm(each - points, axis=1) for each in nearest], axis=0))

    def _distances(self, points: Array, bound: Array) -> Array:
        """Return the distance of each point to the surface, shape (n,) [m]; `bound` is never exceeded."""
        low, high = self._boxes
        lower = np.zeros((len(points), len(self.corners)))
        for axis in range(3):
            column = points[:, axis, None]
            outside = np.maximum(np.maximum(low[:, axis] - column, column - high[:, axis]), 0.0)
            lower += outside * outside
        nearest = np.argmin(lower, axis=1)
        found = _closest(self.corners[nearest], points)
        bound = np.minimum(bound, np.linalg.norm(found - points, axis=1))
        rows, columns = np.nonzero(lower <= (bound * bound)[:, None] + 1e-18)
        found = _closest(self.corners[columns], points[rows])
        result = bound.copy()
        np.minimum.at(result, rows, np.linalg.norm(found - points[rows], axis=1))
        return result

    @cached_property
    def _boxes(self) -> tuple[Array, Array]:
        return self.corners.min(axis=1), self.corners.max(axis=1)


def _closest(corners: Array, points: Array) -> Array:
    return np.asarray(closest_point(corners, points))  # type: ignore[no-untyped-call]
