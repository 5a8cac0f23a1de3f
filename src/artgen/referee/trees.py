"""Assets that the referee proves: welded bodies become one link, and a model falls apart at free joints."""

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from artgen._arrays import cached_property
from artgen._names import ByName
from artgen.asset import Asset, AssetJoint, Collider, Link, Piece
from artgen.asset.joint import AllowedContact
from artgen.asset.manifolds import mesh_of
from artgen.asset.mass import MassProperties
from artgen.asset.shape import Shape
from artgen.colliders import Convex, Exact
from artgen.colliders.convex import TOLERANCE
from artgen.colliders.enclose import few_vertices
from artgen.colliders.triangles import cross, hull_of
from artgen.materials import Material
from artgen.proof.cover import FINE
from artgen.referee.model import ForeignBody, ForeignGeom, ForeignModel, first_of

WORLD = "world"
"""Name of the link of all bodies that are fixed to the world, if they are several."""

MATERIAL = Material("collider", base_color=(0.55, 0.57, 0.6))
"""Material of colliders: a file's masses and colors do not matter for its collisions."""

_FEW_VERTICES = 32  # most vertices of a piece of the first proof
_WHOLE = 1e3  # depth of a contact between geoms that cannot collide [m]


@dataclass(frozen=True, eq=False, repr=False)
class ColliderLink(Link):
    """A link whose solids are convex colliders of a file."""

    geoms: tuple[ForeignGeom, ...] = field(kw_only=True)

    @staticmethod
    def of(name: str, geoms: Sequence[ForeignGeom], material: Material = MATERIAL) -> "ColliderLink":
        """Make a link of geoms, which may be none."""
        pieces = tuple(Piece(geom.name, material, _solid(geom.convex)) for geom in geoms)
        return ColliderLink(name, name, pieces, geoms=tuple(geoms))

    @cached_property
    def colliders(self) -> tuple[Collider, ...]:
        """Polytopes of few vertices around the geoms, for a faster proof than on the geoms themselves."""
        return tuple(
            Collider(convex, geom.name, MATERIAL)
            for geom in self.geoms
            for convex in few_vertices(geom.convex, _FEW_VERTICES, TOLERANCE)
        )

    @cached_property
    def mass_properties(self) -> MassProperties:
        """Mass properties of 1 kg at the origin: the mass of a foreign link is not read."""
        return MassProperties(1.0, np.zeros(3), np.eye(3))


def _solid(convex: Convex) -> Shape:
    """Return a convex piece as a solid that does not exceed it, with flat faces."""
    # a hull is its own inside, and many meshes have thousands of vertices, whose faces take seconds to join
    inside = hull_of(convex.points) if convex.kind == "hull" else convex.inner_polytope(FINE).manifold()
    vertices, triangles = mesh_of(inside)
    corners = vertices[triangles]
    a, b, c = corners.swapaxes(0, 1)
    normals = np.repeat(cross(b - a, c - a), 3, axis=0)
    _, first, point = np.unique(triangles, return_index=True, return_inverse=True)
    targets, count = first[point.reshape(-1)], 3 * len(triangles)
    faces = np.arange(count).reshape(-1, 3)
    exact = Exact((convex,))
    return Shape.from_mesh(
        corners.reshape(-1, 3), normals, np.zeros((count, 2)), faces, exact, targets=targets
    )


@dataclass(frozen=True, eq=False)
class JudgedTree:
    """An asset of links that move against each other, and what the file excludes."""

    asset: Asset
    members: Mapping[str, tuple[str, ...]]  # bodies of each link that carry geoms
    # pairs of links between which the file permits no collision, with the reason
    excluded: Mapping[frozenset[str], str]
    contacts: tuple[AllowedContact, ...]  # geoms of other pairs between which it permits none

    @cached_property
    def partly(self) -> frozenset[frozenset[str]]:
        """The pairs of links with such contacts."""
        return frozenset(frozenset(contact.links) for contact in self.contacts)


def trees_of(model: ForeignModel) -> tuple[list[JudgedTree], list[str]]:
    """Return the trees of a model and notes on what is between them."""
    world, link_of, root_of = _links(model.bodies)
    joints = _joints(model.bodies, link_of, root_of)
    bodies: dict[str, list[ForeignBody]] = {}
    for body in model.bodies:
        bodies.setdefault(link_of[body.name], []).append(body)
    roots = dict.fromkeys(root_of[link] for link in (world, *bodies) if link in root_of)
    result = []
    for root in roots:
        names = [name for name in dict.fromkeys((root, *bodies)) if root_of.get(name) == root]
        links = ByName(
            ColliderLink.of(name, [geom for body in bodies.get(name, ()) for geom in body.geoms])
            for name in names
        )
        steps = ByName(joint for joint in joints if joint.parent in names)
        asset = Asset(model.path.stem, "foreign", links, steps)
        result.append(_with_exclusions(asset, model, bodies))
    return result, _between(model, [tree for tree in result if any(tree.members.values())])


def _links(bodies: Sequence[ForeignBody]) -> tuple[str, dict[str, str], dict[str, str]]:
    """Return the link of what is fixed, the link of each body, and the root of the tree of each link."""
    fixed = {""}
    for body in bodies:
        if body.parent in fixed and not (body.joints or body.apart):
            fixed.add(body.name)
    solid = [body.name for body in bodies if body.name in fixed and body.geoms]
    world = solid[0] if len(solid) == 1 else WORLD  # a single body gives its name
    link_of, root_of = {"": world}, {world: world}
    for body in bodies:
        parent = link_of[body.parent]
        link_of[body.name] = parent if not (body.joints or body.apart) else body.name
        if body.apart:
            root_of[body.name] = body.name
        elif body.joints:
            root_of[body.name] = root_of[parent]
    return world, link_of, root_of


def _joints(
    bodies: Sequence[ForeignBody], link_of: Mapping[str, str], root_of: Mapping[str, str]
) -> list[AssetJoint]:
    """Return the joints between links; a coupling to a joint of another tree is left out."""
    found = [
        (replace(joint, parent=link_of[body.parent], child=body.name), body)
        for body in bodies
        if not body.apart
        for joint in body.joints
    ]
    trees = {joint.name: root_of[body.name] for joint, body in found}
    result = []
    for joint, _ in found:
        follows = joint.follows
        if follows is not None and trees.get(follows.leader) != trees[joint.name]:
            joint = replace(joint, follows=None)  # noqa: PLW2901
        result.append(joint)
    return result


def _with_exclusions(
    asset: Asset, model: ForeignModel, bodies: Mapping[str, Sequence[ForeignBody]]
) -> JudgedTree:
    """Add the exclusions between bodies as exclusions between links, or between geoms."""
    members = {
        link.name: tuple(body.name for body in bodies.get(link.name, ()) if body.geoms)
        for link in asset.links
    }
    geoms = {body.name: [geom.name for geom in body.geoms] for body in model.bodies}
    excluded, contacts = {}, []
    for a, b in itertools.combinations(members, 2):
        between = [(one, two) for one in members[a] for two in members[b]]
        reasons = {
            pair: model.excluded[frozenset(pair)] for pair in between if frozenset(pair) in model.excluded
        }
        if between and len(reasons) == len(between):
            excluded[frozenset((a, b))] = next(iter(reasons.values()))
            continue
        apart = [each for one, two in reasons for each in itertools.product(geoms[one], geoms[two])]
        if model.exempt:
            every = (each for one, two in between for each in itertools.product(geoms[one], geoms[two]))
            apart += [each for each in every if frozenset(each) in model.exempt]
        contacts += [AllowedContact((a, b), each, _WHOLE, "the file excludes it") for each in apart]
    return JudgedTree(asset, members, excluded, tuple(contacts))


def _between(model: ForeignModel, trees: Sequence[JudgedTree]) -> list[str]:
    """Return a note on the bodies that are judged apart from others."""
    if len(trees) < 2:
        return []
    reasons = [body.apart for body in model.bodies if body.apart]
    some = first_of(reasons, 3)
    return [f"{len(trees)} groups of bodies are judged apart, and no pair between two groups: {some}"]
