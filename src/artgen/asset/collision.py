"""Solids of links, also of links that were read from files, and colliders that are made of them."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Literal, get_args

import numpy as np
from manifold3d import Error, Manifold, Mesh64, OpType

from artgen._arrays import Array, Indices, cached_per_object, cached_property
from artgen._names import ByName
from artgen.asset import Asset, Collider, Link, Mesh, Surface
from artgen.asset.link import MOST_COLLIDERS, DerivedLink
from artgen.asset.manifolds import box_of
from artgen.colliders import Convex
from artgen.colliders.coacd import coacd_pieces, fewest, single_hull
from artgen.errors import AssetError, ExportError, nearest
from artgen.materials import Material

_ONE_BOX = 1e-6  # tolerance of bounding boxes in files [m]
_DUST = 1e-15  # smaller parts are rounding crumbs of booleans: a cube of 0.01 mm [m^3]


def closed_mesh(solid: Manifold) -> tuple[Array, Indices]:
    """Return the distinct vertices of a solid, shape (n, 3) [m], and its triangles, shape (m, 3)."""
    mesh = solid.to_mesh64()
    vertices = np.array(mesh.vert_properties)[:, :3]
    target = np.arange(len(vertices))
    merged, first, corners = (
        np.asarray(numbers).astype(np.int64)
        for numbers in (mesh.merge_from_vert, mesh.merge_to_vert, mesh.tri_verts)
    )
    target[merged] = first
    used, triangles = np.unique(target[corners], return_inverse=True)
    return vertices[used], triangles.reshape(-1, 3)


def connected_parts(solid: Manifold) -> list[Manifold]:
    """Return the connected parts of a solid with their hollows, the smallest first, without crumbs."""
    return _with_hollows(solid.decompose())


def _with_hollows(shells: Iterable[Manifold]) -> list[Manifold]:
    """Return solids without the hollows among shells, the smallest first, without crumbs."""

    def rank(shell: Manifold) -> tuple[float, ...]:
        return (round(shell.volume(), 15), *(round(number, 9) for number in shell.bounding_box()))

    shells = sorted(shells, key=rank)
    parts = [shell for shell in shells if shell.volume() > _DUST]
    for wall in (shell for shell in shells if shell.volume() < -_DUST):  # hollows: turned inside out
        around = next((number for number, part in enumerate(parts) if _inside(wall, part)), None)
        if around is not None:
            vertices, triangles = closed_mesh(wall)
            hollow = Manifold(Mesh64(np.array(vertices), triangles[:, ::-1].astype(np.uint64)))
            parts[around] -= hollow
    return parts


def _inside(inner: Manifold, outer: Manifold) -> bool:
    first, second = box_of(inner), box_of(outer)
    return bool((first[0] >= second[0]).all() and (first[1] <= second[1]).all())


def need_solids(asset: Asset, refused: str, instead: str) -> None:
    """Raise AssetError for an asset without solids: one that was read from files, or is padded."""
    made = "is padded to a topology and keeps" if asset.originals else "was read from files, which keep"
    again = "asset without a topology" if asset.originals else "asset again"
    for link in asset.links:
        if not link.pieces:
            raise AssetError(
                f"asset {asset.name!r} {made} no solids, so {refused}; generate the {again}, or write it "
                f"with {instead}",
                link=link.name,
            )


@dataclass(frozen=True, eq=False)
class SolidPart:
    """A solid of a link from which colliders are made."""

    label: str  # semantic label
    material: Material  # material of the solid
    solid: Manifold  # the solid in asset coordinates at rest; it may have several separate parts


def mesh_precision(*links: Link) -> float:
    """Return the mesh precision that links were exported with; 0 for exact meshes [m]."""
    read = [link.to_data() for link in links if not link.pieces]
    return max((float(data.get("mesh_precision", 0.0)) for data in read), default=0.0)


def is_detail(details: Sequence[Mapping[str, Any]], label: str, bounds: Array) -> bool:
    """Tell whether the data of visual details list one with a label and a bounding box, shape (2, 3)."""
    boxes = (each["bounds"] for each in details if each["label"] == label)
    return any(np.abs(box - bounds).max() <= _ONE_BOX for box in boxes)


@cached_per_object
def link_parts(link: Link) -> tuple[SolidPart, ...]:
    """Return the solids of a link; for a link that was read from files, the closed parts of its meshes.

    Visual details, such as heads of screws, are left out: label and bounding box identify them.
    """
    if link.pieces:
        return tuple(
            SolidPart(piece.label, piece.material, piece.shape.manifold)
            for piece in link.pieces
            if not piece.visual
        )
    if precision := mesh_precision(link):
        raise AssetError(
            f"the meshes of link {link.name!r} have a precision of {1e3 * precision:g} mm and do not give "
            f"its exact solids; export the asset with mesh_precision=0",
            link=link.name,
        )
    groups: dict[str, list[Surface]] = {}
    for surface in link.surfaces:
        groups.setdefault(surface.label, []).append(surface)
    materials = {collider.label: collider.material for collider in link.colliders}
    details = link.to_data().get("details", ())
    return tuple(
        SolidPart(label, materials.get(label, surfaces[0].material), part)
        for label, surfaces in groups.items()
        for part in _closed(link, label, surfaces)
        if not is_detail(details, label, box_of(part))
    )


def _closed(link: Link, label: str, surfaces: list[Surface]) -> list[Manifold]:
    """Return the closed parts of the surfaces of one label, with their hollows."""
    from artgen.asset.shells import file_shells

    shells = file_shells(Mesh.concatenated([surface.mesh for surface in surfaces]), label)
    solids = [shell.manifold for shell in shells]
    fault = "" if solids else "are empty"
    if wrong := [solid.status().name for solid in solids if solid.status() != Error.NoError]:
        fault = f"do not close to a solid ({wrong[0]})"
    if fault:
        raise AssetError(
            f"the meshes of link {link.name!r} with label {label!r} {fault}; export the asset again",
            link=link.name,
        )
    return _with_hollows(solids)


Collision = Literal["exact", "coacd", "hull"]
COLLISIONS: tuple[str, ...] = get_args(Collision)
"""Kinds of colliders; `exact` keeps the colliders of the asset."""

_TOUCHING = 2e-6  # solids that overlap by less only touch; files have seven decimals [m]
_CONVEX = 1e-4  # largest share of its hull that a convex part may leave empty
_RECORD = "collision"  # key in the data of a link with replaced colliders


def with_colliders(asset: Asset, kind: Collision | str) -> Asset:
    """Return an asset whose links have colliders of another kind; everything else stays, masses too.

    `hull`: one convex hull of at most 64 vertices around each connected part of each solid; on links with
    more than 64 parts, neighbors are joined. The hulls contain the solids and close every hollow.
    `coacd`: CoACD's decomposition of the union of a link's solids, with at most 64 pieces of 64 vertices;
    solids that only touch are decomposed separately. The pieces do not contain the solids exactly, and may
    close hollows.
    `exact`: the asset itself.

    The returned asset has no certificate: a certificate holds for the colliders that it was proven on.

    Raises:
        ExportError: The kind is unknown, or CoACD is not installed or fails.
        AssetError: The asset was read from files, which have no solids.
    """
    if kind not in COLLISIONS:
        raise ExportError(f"there is no collision {kind!r}.{nearest(kind, COLLISIONS)}")
    if kind == "exact":
        return asset
    need_solids(
        asset,
        f"its colliders cannot be replaced by {kind!r}",
        "collision='exact', which keeps the colliders that it has",
    )
    found = {link.name: made_colliders(link_parts(link), kind) for link in asset.links}
    return replace_colliders(asset, found, kind)


def replace_colliders(asset: Asset, colliders: dict[str, tuple[Collider, ...]], kind: str) -> Asset:
    """Return an asset with replaced colliders; `colliders` has the new ones by link name."""
    links = [RecollidedLink.of(link, replacing=colliders[link.name], collision=kind) for link in asset.links]
    return replace(asset, links=ByName(links))


def collision_of(links: Sequence[dict[str, Any]]) -> str:
    """Return the kind of the colliders in the data of an asset's links."""
    kinds = dict.fromkeys(link.get(_RECORD, "exact") for link in links)
    return next((kind for kind in kinds if kind != "exact"), "exact")


def made_colliders(parts: Sequence[SolidPart], kind: str) -> tuple[Collider, ...]:
    """Return the colliders of a link's solids, `hull` or `coacd`."""
    if kind == "hull":
        return _hulls(parts)
    try:
        convexes = [convex for solid in _unions(parts) for convex in _decomposed(solid)]
    except (ImportError, ValueError) as error:
        raise ExportError(f"cannot make colliders of kind 'coacd': {error}") from error
    return tuple(_named(convex, parts) for convex, _ in fewest(convexes, MOST_COLLIDERS))


def _unions(parts: Sequence[SolidPart]) -> list[Manifold]:
    """Return the unions of solids that overlap by more than the rounding of files."""
    groups: list[list[Manifold]] = []
    for solid in (connected for part in parts for connected in connected_parts(part.solid)):
        met = [group for group in groups if any(_overlapping(solid, other) for other in group)]
        groups = [group for group in groups if not any(group is other for other in met)]
        groups.append([*(other for group in met for other in group), solid])
    return [Manifold.batch_boolean(group, OpType.Add) for group in groups]


def _overlapping(first: Manifold, second: Manifold) -> bool:
    (low, high), (least, most) = box_of(first), box_of(second)
    if (low >= most).any() or (least >= high).any():
        return False
    common = first ^ second
    return bool(2.0 * common.volume() > _TOUCHING * common.surface_area())  # the thickness of a film


def _decomposed(solid: Manifold) -> tuple[Convex, ...]:
    """Return CoACD's pieces of a connected solid, or its hull where it is convex."""
    vertices, triangles = closed_mesh(solid)
    hull = single_hull(vertices)
    if hull.volume - solid.volume() <= _CONVEX * hull.volume:
        return (hull,)
    return coacd_pieces(vertices, triangles, most_pieces=MOST_COLLIDERS)


def _hulls(parts: Sequence[SolidPart]) -> tuple[Collider, ...]:
    """Return one hull around each connected part of the solids."""
    found = [(part, solid) for part in parts for solid in connected_parts(part.solid)]
    convexes = [single_hull(closed_mesh(solid)[0]) for _, solid in found]
    result = []
    for convex, group in fewest(convexes, MOST_COLLIDERS):
        owner, _ = max((found[number] for number in sorted(group)), key=lambda each: each[1].volume())
        result.append(Collider(convex, owner.label, owner.material))
    return tuple(result)


def _named(convex: Convex, parts: Sequence[SolidPart]) -> Collider:
    """Give a piece the label and the material of the solid that fills most of it."""
    manifold = convex.manifold()
    part = max(parts, key=lambda part: (manifold ^ part.solid).volume())
    return Collider(convex, part.label, part.material)


@dataclass(frozen=True, eq=False, repr=False)
class RecollidedLink(DerivedLink):
    """A link with replaced colliders; everything else comes from the source."""

    replacing: tuple[Collider, ...] = field(kw_only=True)  # the new colliders
    collision: str = field(kw_only=True)  # kind of the new colliders
    facts: Mapping[str, Any] = field(kw_only=True, default_factory=dict)  # other facts about them

    @cached_property
    def colliders(self) -> tuple[Collider, ...]:
        """The colliders that replace the source's."""
        return self.replacing

    @property
    def changes(self) -> dict[str, Any]:
        """How colliders and surfaces were replaced, as JSON data."""
        own = {_RECORD: self.collision, **self.facts}
        return own | self.source.changes | own
