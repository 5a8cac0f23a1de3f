"""Value of a body: a link and the links joined to it, before the asset has a name and a seed."""

import math
from collections import Counter
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from heapq import heapify, heappop, heappush

import numpy as np

from artgen._arrays import Array, cached_property
from artgen.asset.coupling import AssetLoop
from artgen.asset.joint import AllowedContact, AssetJoint, joints_above
from artgen.asset.link import Link, Piece
from artgen.asset.manifolds import touching
from artgen.asset.shape import MovedShape
from artgen.asset.signals import AssetOutput
from artgen.colliders.triangles import cross
from artgen.errors import AssetError, nearest

_REMEDIES = {  # for names that are used twice
    "link": "give one part(...) another label, or the same label and a name of its own (name=...)",
    "joint": "give one joint another name",
    "grasp": "give one of the parts that carry it a name of its own (name=...)",
}


@dataclass(frozen=True, eq=False)
class Branch:
    """A child tree with its joints, the first nearest to the parent."""

    joints: tuple[AssetJoint, ...]
    tree: "Tree"


@dataclass(frozen=True, eq=False)
class Tree:
    """A link and its branches."""

    link: Link  # the link nearest to the root
    branches: tuple[Branch, ...] = ()  # the children with their joints
    # allowed contacts declared on this tree; contacts declared on a branch stay there
    contacts: tuple[AllowedContact, ...] = ()
    loops: tuple[AssetLoop, ...] = ()  # closed chains declared on this tree
    outputs: tuple[AssetOutput, ...] = ()  # outputs declared on this tree

    def links(self) -> Iterator[Link]:
        """Yield every link, parents before their children."""
        yield self.link
        for branch in self.branches:
            yield from branch.tree.links()

    def joints(self) -> Iterator[AssetJoint]:
        """Yield every joint with the names of its parent and child, parents before their children."""
        for branch in self.branches:
            for joint in branch.joints:
                yield replace(joint, parent=self.link.name, child=branch.tree.link.name)
            yield from branch.tree.joints()

    def all_contacts(self) -> Iterator[AllowedContact]:
        """Yield the allowed contacts of the whole tree, parents before their children."""
        yield from self.contacts
        for branch in self.branches:
            yield from branch.tree.all_contacts()

    def all_loops(self) -> Iterator[AssetLoop]:
        """Yield the closed chains of the whole tree, parents before their children."""
        yield from self.loops
        for branch in self.branches:
            yield from branch.tree.all_loops()

    def all_outputs(self) -> Iterator[AssetOutput]:
        """Yield the outputs of the whole tree, parents before their children."""
        yield from self.outputs
        for branch in self.branches:
            yield from branch.tree.all_outputs()

    def with_joints(self, joints: Mapping[str, AssetJoint]) -> "Tree":
        """Return the tree with other joints in place of those of the same names."""
        branches = self._branches(
            lambda joint: joints.get(joint.name, joint), lambda tree: tree.with_joints(joints)
        )
        return replace(self, branches=branches)

    def solid_triangles(self) -> int:
        """Return the number of triangles of the solids, without visual details."""
        return sum(_triangles(piece) for link in self.links() for piece in link.solids)

    def _with_links(self, of_link: Callable[[Link], Link]) -> "Tree":
        branches = self._branches(lambda joint: joint, lambda tree: tree._with_links(of_link))
        return replace(self, link=of_link(self.link), branches=branches)

    def moved(self, matrix: Array) -> "Tree":
        """Return the tree after a rigid motion or a reflection, shape (4, 4)."""
        branches = self._branches(lambda joint: joint.moved(matrix), lambda tree: tree.moved(matrix))
        loops = tuple(loop.moved(matrix) for loop in self.loops)
        return Tree(self.link.moved(matrix), branches, self.contacts, loops, self.outputs)

    def suffixed(self, suffix: str) -> "Tree":
        """Return the tree with a suffix on the names of all its links, joints, grasps and pushes."""
        return self._renamed({joint.name: joint.name + suffix for joint in self.joints()}, suffix)

    def _renamed(self, names: dict[str, str], suffix: str) -> "Tree":
        pairs = [contact.links for contact in self.contacts] + [loop.links for loop in self.loops]
        link_names = {name: name + suffix for pair in pairs for name in pair}
        branches = self._branches(
            lambda joint: joint.renamed(names), lambda tree: tree._renamed(names, suffix)
        )
        contacts = tuple(contact.renamed(link_names, names) for contact in self.contacts)
        loops = tuple(loop.renamed(link_names, names) for loop in self.loops)
        outputs = tuple(each.renamed(each.name + suffix, names, {}) for each in self.outputs)
        link = self.link.renamed(lambda name: name + suffix, names)
        return Tree(link, branches, contacts, loops, outputs)

    def _branches(
        self, of_joint: Callable[[AssetJoint], AssetJoint], of_tree: Callable[["Tree"], "Tree"]
    ) -> tuple[Branch, ...]:
        return tuple(Branch(tuple(map(of_joint, each.joints)), of_tree(each.tree)) for each in self.branches)

    def checked(self) -> "Tree":
        """Return the tree if its names are unique.

        Raises:
            ValueError: Two links, joints, or grasps and pushes share a name, or a joint with detents or a
                soft closing has another one beside it.
        """
        for branch in self.branches:
            for joint in branch.joints if len(branch.joints) > 1 else ():
                has = "detents" if joint.detents is not None else "a soft closing"
                if joint.detents is not None or joint.closing is not None:
                    raise ValueError(
                        f"joint {joint.name!r} has {has} and shares its links with another joint; give it a "
                        "pair of links with one joint: put a part between them"
                    )
        links = list(self.links())
        kinds = {
            "link": [link.name for link in links],
            "joint": [joint.name for joint in self.joints()],
            "grasp": [hold.name for link in links for hold in (*link.grasps, *link.pushes)],
        }
        for kind, names in kinds.items():
            twice = [name for name, count in Counter(names).items() if count > 1]
            if twice:
                raise ValueError(f"the {kind} name {twice[0]!r} is used twice; {_REMEDIES[kind]}")
        return self


@dataclass(frozen=True, eq=False)
class Reduction:
    """A choice of the visual details that are left out of a tree; made on first access to its details.

    Details that are not thicker than `thin` [m] are left out. With more than `most` triangles, others are as
    well, those with the smallest triangles first, then those that stand out of the bounds of a link's solids
    and show in the outline. A detail stays as long as solids, or details that stay, hang together by it; a
    link may be of separate solids. One that coarse solids do not reach any more is left out.
    """

    tree: Tree
    most: float
    thin: float = 0.0

    @cached_property
    def result(self) -> Tree:
        """The tree without these details."""
        return self.tree._with_links(lambda link: link.without(lambda: self._chosen[0]))

    @property
    def least(self) -> int:
        """Least number of triangles with all details that show in the outline, or hold others."""
        return self._chosen[1]

    @cached_property
    def _chosen(self) -> tuple[frozenset[int], int]:
        links = list(self.tree.links())
        pieces = [piece for link in links for piece in link.pieces]
        kept = least = sum(map(_triangles, pieces))
        solids = [[each.shape.bounds() for each in link.solids] for link in links]
        bounds = [(np.min(boxes, axis=0)[0], np.max(boxes, axis=0)[1]) for boxes in solids if boxes]

        def rank(piece: Piece) -> _Rank:
            low, high = piece.shape.bounds()
            beyond = min(max((start - low).max(), (high - end).max()) for start, end in bounds)
            return bool((high - low).min() > self.thin), bool(beyond > _PROUD), _mean_area(piece)

        ranks = {id(each): rank(each) for each in pieces if each.visual}
        neighbors = _hanging(links, ranks)
        for key in _floating(links, neighbors):
            ranks[key] = (False, *ranks[key][1:])
        if kept <= self.most and all(thick for thick, _, _ in ranks.values()):
            return frozenset(), kept
        left_out: set[int] = set()
        leaving, shows = True, False  # whether all details so far were left out, and whether one shows
        for piece in _from_ends(pieces, ranks, neighbors):
            thick, proud, _ = ranks[id(piece)]
            leaving = leaving and (not thick or kept > self.most)
            if leaving:
                left_out.add(id(piece))
                kept -= _triangles(piece)
            shows = shows or (thick and proud)
            if not shows:
                least -= _triangles(piece)
        return frozenset(left_out), least


_PROUD = 0.001  # distance beyond the solids at which a detail shows in the outline [m]


_Rank = tuple[bool, bool, float]
"""Order in which details are left out: whether one is thick, whether it stands out, mean triangle [m^2]."""


def _hanging(links: Sequence[Link], ranks: Mapping[int, _Rank]) -> dict[int, set[int]]:
    """Return the pieces that hang together with each piece, by `id`: a forest for each link."""
    neighbors: dict[int, set[int]] = {}
    for link in links:
        if link.separate or not any(piece.visual for piece in link.pieces):
            continue
        pieces = sorted(link.pieces, key=lambda each: ranks.get(id(each), _SOLID), reverse=True)
        solid = sum(not each.visual for each in pieces)
        order = np.maximum(np.arange(len(pieces)) - solid + 1, 0)
        boxes = np.array([each.shape.bounds() for each in pieces])
        neighbors |= {id(each): set() for each in pieces}
        for pair in touching([each.shape.manifold for each in pieces], boxes, order):
            one, other = (id(pieces[index]) for index in pair)
            neighbors[one].add(other)
            neighbors[other].add(one)
    return neighbors


def _floating(links: Sequence[Link], neighbors: Mapping[int, set[int]]) -> set[int]:
    """Return the visual details that hang on no solid, by `id`."""
    ends = [id(piece) for link in links for piece in link.pieces if not piece.visual]
    reached: set[int] = set()
    while ends:
        key = ends.pop()
        if key not in reached:
            reached.add(key)
            ends += neighbors.get(key, ())
    return set(neighbors) - reached


def _from_ends(
    pieces: Sequence[Piece], ranks: Mapping[int, _Rank], neighbors: Mapping[int, set[int]]
) -> Iterator[Piece]:
    """Yield visual details by rank, each after the details that hang on it; those between solids stay."""
    details = {id(piece): piece for piece in pieces if piece.visual}
    number = {key: index for index, key in enumerate(details)}
    ends = [(ranks[key], number[key], key) for key in details if len(neighbors.get(key, ())) < 2]
    heapify(ends)
    while ends:
        _, _, key = heappop(ends)
        yield details[key]
        for other in neighbors.get(key, ()):
            neighbors[other].remove(key)
            if other in details and len(neighbors[other]) == 1:
                heappush(ends, (ranks[other], number[other], other))


_SOLID: _Rank = (True, True, math.inf)  # solids come before all details


def _triangles(piece: Piece) -> int:
    shape = piece.shape
    while isinstance(shape, MovedShape):  # its own mesh has moved vertices
        shape = shape.source
    return len(shape.mesh.triangles)


def _mean_area(piece: Piece) -> float:
    """Return the mean area of the triangles of a piece [m^2]."""
    a, b, c = piece.shape.mesh.vertices[piece.shape.mesh.triangles.T]
    return float(np.linalg.norm(cross(b - a, c - a), axis=1).mean()) / 2.0


def check_contact(contact: AllowedContact, links: Collection[str], joints: Mapping[str, AssetJoint]) -> None:
    """Check that a contact names links of the asset, and joints that move one against the other."""
    for link in contact.links:
        if link not in links:
            raise AssetError(
                f"a contact names the link {link!r}, which is not a link of this asset."
                f"{nearest(link, links)}",
                link=link,
            )
    if contact.when is None:
        return
    (a, b), (first, second) = contact.links, contact.labels
    between = _moving(contact.links, joints)
    for name in contact.when.joints():
        if name in between:
            continue
        fault = f"is not a joint of this asset.{nearest(name, joints)}"
        if name in joints:
            fault = "does not move one against the other."
        raise AssetError(
            f"the contact of {a}/{first} with {b}/{second} is allowed where {contact.when}, but {name!r} "
            f"{fault} Between them are: {', '.join(between)}.",
            joint=name,
            link=a,
        )


def _moving(links: tuple[str, str], joints: Mapping[str, AssetJoint]) -> list[str]:
    """Return the joints on the path between two links, then the leaders of these joints."""
    first, second = ([joint.name for joint in joints_above(joints.values(), link)] for link in links)
    found = [name for name in first if name not in second] + [name for name in second if name not in first]
    for name in found:  # grows: leaders of leaders are appended
        follows = joints[name].follows
        if follows is not None and follows.leader not in found:
            found.append(follows.leader)
    return found
