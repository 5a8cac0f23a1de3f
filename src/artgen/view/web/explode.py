"""Where the links of an asset go in an exploded view: apart along the axes, so that no box covers another."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset, Joint

_GAP = 0.06  # free space between two boxes, as a share of the asset's size
_FAR = 0.5  # share of its own length by which something slides that comes out that way, unlike a bolt
_SIDES = np.concatenate([np.eye(3), -np.eye(3)])


@dataclass
class _Group:
    """A link with all that hangs on it, already apart."""

    box: Array  # the corners of the space that it takes, shape (2, 3) [m]
    shifts: dict[str, Array]  # how far each of its links is moved, by name, shape (3,) [m]

    def moved(self, shift: Array) -> "_Group":
        """Return the group moved as a whole, by shape (3,) [m]."""
        return _Group(self.box + shift, {name: before + shift for name, before in self.shifts.items()})


def exploded(asset: Asset) -> dict[str, Array]:
    """Return how far each link is moved in an exploded view, in asset coordinates at rest, shape (3,) [m].

    What slides far goes the way it slides, everything else the shortest way out of the box of its parent.
    """
    low, high = asset.bounds()
    return _group(asset, asset.links[0].name, _GAP * float(np.linalg.norm(high - low))).shifts


def _group(asset: Asset, link: str, gap: float) -> _Group:
    """Move what hangs on a link away from it, that which is nearest to the link first."""
    whole = _Group(asset.link(link).bounds(), {link: np.zeros(3)})
    own = whole.box
    children = []
    for parent, child, joints in asset.pairs():
        if parent == link:
            side = _side(own, asset.link(child).bounds(), joints)
            children.append((side, _group(asset, child, gap)))
    # of those that go to one side, the outer ones have to leave room for the inner ones
    children.sort(key=lambda each: round(float((each[0] @ each[1].box.T).max()), 6))
    placed: list[_Group] = []
    for side, group in children:
        way = max(
            (_way(group.box, other, side, gap) for other in (own, *(one.box for one in placed))), default=0.0
        )
        placed.append(group.moved(max(way, 0.0) * side))
    for group in placed:
        whole.box = np.array([np.minimum(whole.box[0], group.box[0]), np.maximum(whole.box[1], group.box[1])])
        whole.shifts |= group.shifts
    return whole


def _side(parent: Array, child: Array, joints: Sequence[Joint]) -> Array:
    """Return the direction along an axis in which a child leaves its parent, boxes of shape (2, 3)."""
    for joint in reversed(joints):
        low, high = joint.limits or (0.0, 0.0)
        way = joint.axis * (high if high + low >= 0.0 else low)
        side = np.asarray(_SIDES[int(np.argmax(np.round(_SIDES @ way, 9)))])
        if joint.kind == "prismatic" and way @ side >= _FAR * abs(side @ (child[1] - child[0])):
            return side
    ways = [_way(child, parent, side, 0.0) for side in _SIDES]
    return np.asarray(_SIDES[int(np.argmin(np.round(ways, 6)))])


def _way(box: Array, other: Array, side: Array, gap: float) -> float:
    """Return how far a box goes to one side until another one is behind it; 0 if it passes beside it [m]."""
    across = side == 0.0
    if ((box[0] >= other[1]) | (box[1] <= other[0]))[across].any():
        return 0.0
    return float((side @ other.T).max() - (side @ box.T).min()) + gap
