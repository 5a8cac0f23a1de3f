"""The value of a body: a link with the links that are joined to it, before it has a seed and a name."""

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import chain

import numpy as np
from numpy.typing import NDArray

from artgen.asset.joint import Joint
from artgen.asset.link import Link

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Branch:
    """A child with the joints that join it, the first nearest to the parent."""

    joints: tuple[Joint, ...]
    tree: "Tree"


@dataclass(frozen=True, eq=False)
class Tree:
    """A link and its branches.

    Attributes:
        link: The link nearest to the root.
        branches: The children with their joints.
    """

    link: Link
    branches: tuple[Branch, ...] = ()

    def links(self) -> Iterator[Link]:
        """Yield every link, parents before their children."""
        yield self.link
        for branch in self.branches:
            yield from branch.tree.links()

    def joints(self) -> Iterator[Joint]:
        """Yield every joint with the names of its parent and child, parents before their children."""
        for branch in self.branches:
            for joint in branch.joints:
                yield replace(joint, parent=self.link.name, child=branch.tree.link.name)
            yield from branch.tree.joints()

    def moved(self, matrix: Array) -> "Tree":
        """Return the tree carried along by a rigid motion or a reflection, shape (4, 4)."""
        return Tree(
            self.link.moved(matrix),
            tuple(
                Branch(tuple(joint.moved(matrix) for joint in branch.joints), branch.tree.moved(matrix))
                for branch in self.branches
            ),
        )

    def suffixed(self, suffix: str) -> "Tree":
        """Return the tree with a suffix on the names of all its links, joints and grasps."""
        return self._renamed({joint.name: joint.name + suffix for joint in self.joints()}, suffix)

    def _renamed(self, joint_names: dict[str, str], suffix: str) -> "Tree":
        return Tree(
            self.link.renamed(suffix),
            tuple(
                Branch(
                    tuple(joint.renamed(joint_names) for joint in branch.joints),
                    branch.tree._renamed(joint_names, suffix),
                )
                for branch in self.branches
            ),
        )

    def checked(self) -> "Tree":
        """Return the tree if its names are unique.

        Raises:
            ValueError: Two links, joints or grasps share a name.
        """
        links = list(self.links())
        names = {
            "link": [link.name for link in links],
            "joint": [joint.name for joint in self.joints()],
            "grasp": list(chain.from_iterable((grasp.name for grasp in link.grasps) for link in links)),
        }
        remedy = {
            "link": "give one part(...) another label, or the same label and a name of its own (name=...)",
            "joint": "give one joint another name",
            "grasp": "give one of the parts that carry it a name of its own (name=...)",
        }
        for what, found in names.items():
            twice = [name for name, count in Counter(found).items() if count > 1]
            if twice:
                raise ValueError(f"the {what} name {twice[0]!r} is used twice; {remedy[what]}")
        return self
