"""Links: rigid bodies made of named pieces of one material each."""

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from functools import cache
from itertools import compress, repeat
from operator import attrgetter
from typing import Any, ClassVar, Self

import numpy as np
from manifold3d import Manifold, OpType

from artgen._arrays import Array, FrozenArrays, affine, cached, cached_property
from artgen.asset.affordance import Grasp, Push
from artgen.asset.manifolds import mesh_of, part_boxes
from artgen.asset.mass import MassProperties, Moments, polyhedron_moments, total
from artgen.asset.record import plain, rounded, rounded_coordinates
from artgen.asset.shape import Mesh, Shape, joined_faces
from artgen.asset.surface import as_written, by_paint, joined, shifted
from artgen.colliders import Convex, budgeted
from artgen.colliders.budget import COARSEST
from artgen.errors import AssetError
from artgen.materials import Material

MOST_COLLIDERS = 64  # most convex pieces of one link; a common limit of GPU simulators


@dataclass(frozen=True, eq=False)
class PrintDirection(FrozenArrays):
    """Reading direction of print, which keeps print readable on mirrored parts."""

    about: Array  # center of the print, shape (3,) [m]
    direction: Array  # unit vector along the lines, shape (3,)

    def motion(self, matrix: Array) -> Array:
        """Return the motion of print on a part after a rigid motion or a reflection, shape (4, 4).

        Under a reflection, the print is also flipped about its center: it stays readable in the place of its
        mirror image.
        """
        if np.linalg.det(matrix[:3, :3]) > 0.0:
            return matrix
        turn = np.eye(3) - 2.0 * np.outer(self.direction, self.direction)
        return np.asarray(matrix @ affine(turn, self.about - turn @ self.about))

    def moved(self, motion: Array) -> "PrintDirection":
        """Return the reading direction after a motion of the print, shape (4, 4)."""
        return PrintDirection(motion[:3, :3] @ self.about + motion[:3, 3], motion[:3, :3] @ self.direction)


@dataclass(frozen=True, eq=False)
class Piece:
    """A labeled solid of one material."""

    label: str  # semantic label
    material: Material  # material of the solid
    shape: Shape  # the solid, in asset coordinates at rest
    visual: bool = False  # whether the piece is a visual detail, without mass and collider
    reading: PrintDirection | None = None  # its reading direction, if the piece is print

    def moved(self, matrix: Array) -> "Piece":
        """Return the piece carried along by a rigid motion or a reflection, shape (4, 4)."""
        if self.reading is None:
            return replace(self, shape=self.shape.transformed(matrix))
        motion = self.reading.motion(matrix)
        return replace(self, shape=self.shape.transformed(motion), reading=self.reading.moved(motion))


@dataclass(frozen=True, eq=False)
class Collider:
    """A convex piece of a link with its contact properties."""

    convex: Convex  # the piece, in asset coordinates at rest
    label: str  # semantic label of the covered solid
    material: Material  # material of the covered solid
    spare: bool = False  # whether it only fills a topology: it lies inside another collider of the same body
    joined: tuple[str, ...] = ()  # labels of other solids that it contains too, if pieces were joined


@dataclass(frozen=True, eq=False)
class Surface:
    """The visible faces of a link that share a label and a material."""

    name: str  # identifier, unique on the link
    label: str  # semantic label
    material: Material  # material of the faces
    mesh: Mesh  # the faces, in asset coordinates at rest


@dataclass(frozen=True, eq=False)
class Link(FrozenArrays):
    """A rigid body.

    Attributes:
        name: Identifier, unique in the asset.
        label: Semantic label of the link as a whole.
        pieces: Its solids; empty if the asset was read from files, which hold surfaces and colliders only.
        grasps: Frames at which a hand grasps the link.
        separate: Reason why its solids are not all connected; empty if they have to be.
        pushes: Frames at which a finger pushes the link.
    """

    rounded: ClassVar = False  # whether its numbers have as many digits as files keep
    absent: ClassVar = False  # whether it fills an empty slot of a topology

    name: str
    label: str
    pieces: Sequence[Piece] = ()
    grasps: tuple[Grasp, ...] = ()
    separate: str = ""
    pushes: tuple[Push, ...] = ()

    @cached_property
    def labels(self) -> tuple[str, ...]:
        """The semantic labels on the link, its own first."""
        return tuple(dict.fromkeys((self.label, *(piece.label for piece in self.pieces))))

    @cached_property
    def visual(self) -> bool:
        """Whether the link consists of visual details only."""
        return all(piece.visual for piece in self.pieces)

    @cached_property
    def solids(self) -> tuple[Piece, ...]:
        """Its pieces without visual details."""
        return tuple(piece for piece in self.pieces if not piece.visual)

    @cached_property
    def mass_properties(self) -> MassProperties:
        """Mass, center and inertia of the solids; a volume in several solids counts for the first one."""
        pieces = self._solid_pieces()
        low, high = np.array([piece.shape.bounds() for piece in pieces]).reshape(-1, 2, 3).swapaxes(0, 1)

        @cache
        def bare(number: int) -> Manifold:
            # normals and paint only take time
            return pieces[number].shape.manifold.set_properties(0, lambda *_: None)

        moments: list[Moments] = []
        for number, piece in enumerate(pieces):
            vertices, triangles = piece.shape.mesh.vertices, piece.shape.mesh.triangles
            meets = (low[:number] < high[number]).all(axis=1) & (low[number] < high[:number]).all(axis=1)
            if meets.any():
                near = map(bare, np.flatnonzero(meets).tolist())
                rest = Manifold.batch_boolean([bare(number), *near], OpType.Subtract)
                if rest.is_empty():
                    continue
                vertices, triangles = mesh_of(rest)
            moments.append(polyhedron_moments(vertices, triangles).scaled(piece.material.density))
        return total(moments)

    @cached_property
    def colliders(self) -> tuple[Collider, ...]:
        """Convex pieces that contain the solids, at most `MOST_COLLIDERS`."""
        pieces = self._solid_pieces()
        if len(pieces) > MOST_COLLIDERS:
            raise AssetError(
                f"link {self.name!r} is made of {len(pieces)} solids; a link may carry at most "
                f"{MOST_COLLIDERS} colliders: join small solids or make them details"
            )
        try:
            found = budgeted([piece.shape.pieces for piece in pieces], most_pieces=MOST_COLLIDERS)
        except ValueError as error:
            needs = [(len(piece.shape.pieces.simplified(COARSEST)), piece.label) for piece in pieces]
            most = ", ".join(f"{label} {count}" for count, label in sorted(needs, reverse=True)[:4])
            raise AssetError(f"link {self.name!r}: {error}; most are of its parts {most}") from None
        return tuple(
            Collider(convex, piece.label, piece.material)
            for piece, convexes in zip(pieces, found, strict=True)
            for convex in convexes
        )

    @property
    def covers(self) -> tuple[Convex, ...]:
        """Convex pieces within which its author lets the colliders stand off from the solids."""
        return tuple(cover for piece in self.solids for cover in piece.shape.pieces.declared())

    @cached_property
    def surfaces(self) -> tuple[Surface, ...]:
        """Visible faces, one surface for each label and material."""
        return self.surfaces_of(lambda piece: piece.shape.mesh)

    def surfaces_of(self, mesh_of: Callable[[Piece], Mesh]) -> tuple[Surface, ...]:
        """Return one surface for each label and material; `mesh_of` returns the mesh of a piece."""
        groups: dict[tuple[str, Material], list[Mesh]] = {}
        for index, piece in enumerate(self.pieces):
            for number, mesh in by_paint(mesh_of(piece)):
                material = piece.shape.paints[number] if number else piece.material
                laid = shifted(mesh, material, f"{self.name}/{index}")
                groups.setdefault((piece.label, material), []).append(laid)
        return tuple(
            Surface(f"{label}_{material.name}", label, material, joined(meshes))
            for (label, material), meshes in groups.items()
        )

    @property
    def mass(self) -> float:
        """Mass [kg]."""
        return self.mass_properties.mass

    def __repr__(self) -> str:
        return f"<link {self.name}: {', '.join(self.labels)}>"

    def bounds(self) -> Array:
        """Return the bounding box at rest, shape (2, 3) [m]; of the colliders if it has no surface."""
        parts = [surface.mesh.vertices for surface in self.surfaces]
        points = np.concatenate(parts or [each.convex.bounds() for each in self.colliders])
        return np.array([points.min(axis=0), points.max(axis=0)])

    def without(self, left_out: Callable[[], Collection[int]]) -> "ReducedLink":
        """Return the link without some visual details, whose `id` the function gives on first access."""
        return ReducedLink.of(self, pieces=_KeptPieces(self.pieces, left_out))

    def moved(self, matrix: Array) -> "Link":
        """Return the link carried along by a rigid motion or a reflection, shape (4, 4)."""
        grasps = tuple(grasp.moved(matrix) for grasp in self.grasps)
        pushes = tuple(push.moved(matrix) for push in self.pushes)
        values = (MovedPieces(self.pieces, matrix), grasps, self.separate, pushes)
        return MovedLink(self.name, self.label, *values, source=self, matrix=matrix)

    def renamed(self, rename: Callable[[str], str], joints: Mapping[str, str]) -> "Link":
        """Return the link with new names of it, its grasps and pushes; joints of conditions are renamed."""
        grasps = tuple(grasp.renamed(rename, joints) for grasp in self.grasps)
        pushes = tuple(push.renamed(rename, joints) for push in self.pushes)
        return replace(self, name=rename(self.name), grasps=grasps, pushes=pushes)

    def to_data(self) -> dict[str, Any]:
        """Return everything but the triangles as JSON data."""
        return {
            "name": self.name,
            "label": self.label,
            "labels": list(self.labels),
            **self.mass_properties.to_data(),
            "grasps": plain(self.grasps),
            "pushes": plain(self.pushes),
            "colliders": [
                {
                    **_convex_data(collider.convex),
                    "label": collider.label,
                    "material": collider.material.name,
                    **({"spare": True} if collider.spare else {}),
                    **({"joined": list(collider.joined)} if collider.joined else {}),
                }
                for collider in self.colliders
            ],
            "surfaces": [
                {
                    "name": surface.name,
                    "label": surface.label,
                    "material": surface.material.name,
                    "triangles": len(surface.mesh.triangles),
                }
                for surface in self.listed_surfaces
            ],
            "details": self.details,
            "separate": self.separate,
            **({"covers": [_convex_data(cover) for cover in self.covers]} if self.covers else {}),
            **self.changes,
        }

    @property
    def listed_surfaces(self) -> tuple[Surface, ...]:
        """The surfaces in the data: those before rounding."""
        return self.surfaces

    @cached_property
    def details(self) -> list[dict[str, Any]]:
        """Label and bounding box of each connected part of visual details, as JSON data."""
        found = [piece for piece in self.pieces if piece.visual]
        if not found:
            return []
        vertices = [piece.shape.vertices for piece in found]
        # one call for all, because there are many with few triangles
        boxes, first = part_boxes(np.concatenate(vertices), joined_faces([piece.shape for piece in found]))
        ends = np.cumsum([len(points) for points in vertices])
        labels = [found[number].label for number in np.searchsorted(ends, first, side="right")]
        listed = zip(labels, (np.round(boxes, 9) + 0.0).tolist(), strict=True)
        return [{"label": label, "bounds": bounds} for label, bounds in sorted(listed)]

    @property
    def changes(self) -> dict[str, Any]:
        """How colliders and surfaces were replaced, as JSON data; empty if they were not."""
        return {}

    def _solid_pieces(self) -> Sequence[Piece]:
        if not self.pieces:
            raise AssetError(
                f"link {self.name!r} was read from files and has no exact solids; generate the asset again"
            )
        return self.solids


def _convex_data(convex: Convex) -> dict[str, Any]:
    """Return a convex piece as JSON data."""
    points = convex.points.tolist() if convex.kind == "hull" else []
    return {"kind": convex.kind, "pose": convex.pose.tolist(), "size": list(convex.size), "points": points}


class MovedPieces(Sequence[Piece]):
    """Pieces whose motion is computed on first access."""

    def __init__(self, pieces: Sequence[Piece], matrix: Array) -> None:
        self._source = pieces
        self._matrix = matrix

    @cached_property
    def _moved(self) -> tuple[Piece, ...]:
        return tuple(piece.moved(self._matrix) for piece in self._source)

    def __len__(self) -> int:
        return len(self._source)

    def __getitem__(self, index: Any) -> Any:
        return self._moved[index]


class _KeptPieces(Sequence[Piece]):
    """The pieces of a link without some, which are chosen on first access."""

    def __init__(self, pieces: Sequence[Piece], left_out: Callable[[], Collection[int]]) -> None:
        self._source = pieces
        self._left_out = left_out

    @cached_property
    def _kept(self) -> tuple[Piece, ...]:
        left_out = self._left_out()
        return tuple(piece for piece in self._source if id(piece) not in left_out)

    def __bool__(self) -> bool:
        return bool(self._source)  # its solids stay

    def __len__(self) -> int:
        return len(self._kept)

    def __getitem__(self, index: Any) -> Any:
        return self._kept[index]


@dataclass(frozen=True, eq=False, repr=False)
class DerivedLink(Link):
    """A link with the values of another link; subclasses change some of them."""

    source: Link = field(kw_only=True)  # the link before

    @classmethod
    def of(cls, link: Link, **changes: Any) -> Self:
        """Return the link derived from another, with changed fields."""
        values = {each.name: getattr(link, each.name) for each in fields(Link)}
        return cls(**values | {"source": link} | changes)

    labels = cached_property(attrgetter("source.labels"))
    mass_properties = cached_property(attrgetter("source.mass_properties"))
    colliders = cached_property(attrgetter("source.colliders"))
    surfaces = cached_property(attrgetter("source.surfaces"))
    listed_surfaces = cached_property(attrgetter("source.listed_surfaces"))
    details = cached_property(attrgetter("source.details"))
    changes = cached_property(attrgetter("source.changes"))
    absent = property(attrgetter("source.absent"))


@dataclass(frozen=True, eq=False, repr=False)
class ReducedLink(DerivedLink):
    """A link without some visual details of its source; its solids are those of the source."""

    solids = cached_property(attrgetter("source.solids"))
    visual = cached_property(attrgetter("source.visual"))
    labels = cached_property(attrgetter("_whole.labels"))
    surfaces = cached_property(attrgetter("_whole.surfaces"))
    listed_surfaces = cached_property(attrgetter("_whole.listed_surfaces"))
    details = cached_property(attrgetter("_whole.details"))

    def surfaces_of(self, mesh_of: Callable[[Piece], Mesh]) -> tuple[Surface, ...]:
        """Return one surface for each label and material; `mesh_of` returns the mesh of a piece."""
        return self._whole.surfaces_of(mesh_of)

    @cached_property
    def _whole(self) -> Link:
        """A link of the pieces that are kept; the source if all are."""
        if len(self.pieces) == len(self.source.pieces):
            return self.source
        return Link(self.name, self.label, tuple(self.pieces), self.grasps, self.separate, self.pushes)


@dataclass(frozen=True, eq=False, repr=False)
class RepaintedLink(DerivedLink):
    """A link with other materials."""

    materials: Mapping[Material, Material] = field(kw_only=True)  # new materials by the old ones

    def _with(self, items: Iterable[Any]) -> tuple[Any, ...]:
        return tuple(
            replace(each, material=self.materials[each.material]) if each.material in self.materials else each
            for each in items
        )

    @cached_property
    def colliders(self) -> tuple[Collider, ...]:
        """The colliders of the source, with the new materials."""
        return self._with(self.source.colliders)

    @cached_property
    def surfaces(self) -> tuple[Surface, ...]:
        """The surfaces of the source, with the new materials."""
        return self._with(self.source.surfaces)

    def surfaces_of(self, mesh_of: Callable[[Piece], Mesh]) -> tuple[Surface, ...]:
        """Return one surface for each label and material; `mesh_of` returns the mesh of a piece."""
        return self._with(self.source.surfaces_of(mesh_of))


@dataclass(frozen=True, eq=False, repr=False)
class BareLink(DerivedLink):
    """A link without visual surfaces, and with the needed colliders of its source."""

    needed: tuple[bool, ...] | None = field(default=None, kw_only=True)  # for each collider; None: all

    @cached_property
    def colliders(self) -> tuple[Collider, ...]:
        """The needed ones."""
        return tuple(compress(self.source.colliders, self.needed or repeat(True)))

    @cached_property
    def surfaces(self) -> tuple[Surface, ...]:
        """None."""
        return ()


@dataclass(frozen=True, eq=False, repr=False)
class MovedLink(Link):
    """A moved link; its values are moved values of the source, computed on first access."""

    source: Link = field(kw_only=True)  # the link before
    matrix: Array = field(kw_only=True)  # rigid motion or reflection, shape (4, 4)

    labels = cached_property(attrgetter("source.labels"))
    visual = cached_property(attrgetter("source.visual"))

    @cached_property
    def mass_properties(self) -> MassProperties:
        """Mass, center and inertia of the source, moved."""
        return self.source.mass_properties.moved(self.matrix)

    @cached_property
    def colliders(self) -> tuple[Collider, ...]:
        """Convex pieces of the source, moved."""
        return tuple(
            replace(collider, convex=collider.convex.transformed(self.matrix))
            for collider in self.source.colliders
        )

    @cached_property
    def surfaces(self) -> tuple[Surface, ...]:
        """The visible faces of the source, moved; a renamed link uses another part of its texture maps."""
        return super().surfaces if self._turned_over else self._carried(self.source.surfaces)

    def surfaces_of(self, mesh_of: Callable[[Piece], Mesh]) -> tuple[Surface, ...]:
        """Return one surface for each label and material; `mesh_of` returns the mesh of a piece."""
        if self._turned_over:
            return super().surfaces_of(mesh_of)
        return self._carried(self.source.surfaces_of(mesh_of))

    @property
    def _turned_over(self) -> bool:
        """Whether a reflection requires that print is turned separately."""
        reflected = np.linalg.det(self.matrix[:3, :3]) < 0.0
        return bool(reflected) and any(piece.reading is not None for piece in self.source.pieces)

    def _carried(self, surfaces: Sequence[Surface]) -> tuple[Surface, ...]:
        moved = [replace(surface, mesh=surface.mesh.moved(self.matrix)) for surface in surfaces]
        if self.name == self.source.name:
            return tuple(moved)
        return tuple(replace(each, mesh=shifted(each.mesh, each.material, self.name)) for each in moved)


@dataclass(frozen=True, eq=False, repr=False)
class RoundedLink(DerivedLink):
    """A link rounded to the digits that files keep."""

    rounded: ClassVar = True

    origin: Array = field(kw_only=True)  # of its frame in asset coordinates at rest, shape (3,) [m]

    @staticmethod
    def at(link: Link, origin: Array) -> "RoundedLink":
        """Return a link with the origin of its frame, shape (3,) [m], rounded."""
        holds = {"grasps": rounded(link.grasps), "pushes": rounded(link.pushes)}
        return RoundedLink.of(link, origin=origin, **holds)

    @cached_property
    def mass_properties(self) -> MassProperties:
        """Mass, center and inertia of the source, rounded."""
        properties: MassProperties = rounded(self.source.mass_properties)
        inertia = properties.inertia
        noise = abs(inertia) < _NOISE * np.trace(inertia)  # a link that was turned has products of 1e-20
        return replace(properties, inertia=np.where(noise, 0.0, inertia))

    @cached_property
    def colliders(self) -> tuple[Collider, ...]:
        """The colliders of the source, rounded."""
        return tuple(
            replace(each, convex=_rounded_convex(each.convex), material=_rounded_material(each.material))
            for each in self.source.colliders
        )

    @property
    def covers(self) -> tuple[Convex, ...]:
        """The covers of the source, rounded."""
        return tuple(map(_rounded_convex, self.source.covers))

    @cached_property
    def surfaces(self) -> tuple[Surface, ...]:
        """The visible faces of the source, as a loader of the files sees them."""
        result = []
        for surface in self.source.surfaces:
            material = _rounded_material(surface.material)
            mesh = as_written(surface.mesh, self.origin, material)
            result.append(replace(surface, material=material, mesh=mesh))
        return tuple(result)


_NOISE = 1e-14  # share of the trace of an inertia below which a product is 0
_rounded_material: Callable[[Material], Material] = cached(256)(rounded)


def _rounded_convex(convex: Convex) -> Convex:
    size = tuple(map(rounded, convex.size))
    points = convex.points if convex.kind == "hull" else np.empty((0, 3))
    return Convex(convex.kind, rounded_coordinates(convex.pose), size, rounded_coordinates(points))
