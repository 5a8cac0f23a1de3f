"""An asset as a robot meets it: each collider as an oriented box, wherever its link is."""

from collections.abc import Mapping

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.asset.gripper import GRIPPER
from artgen.colliders import Convex

_TABLE = 1.0  # its height, more than a robot reaches down [m]
_GRAZE = 0.001  # between the table and what stands on it [m]
_UNIT = np.stack(np.meshgrid(*[[-1.0, 1.0]] * 3, indexing="ij"), axis=-1).reshape(-1, 3)

HAND = np.array(
    [
        [-GRIPPER.hand[0] / 2.0, -GRIPPER.hand[1] / 2.0, GRIPPER.tip - GRIPPER.long - GRIPPER.hand[2]],
        [GRIPPER.hand[0] / 2.0, GRIPPER.hand[1] / 2.0, GRIPPER.tip - GRIPPER.long],
    ]
)
"""Corners of the box behind the fingers, in the tip's frame, shape (2, 3) [m]."""


class Obstacles:
    """The boxes of an asset.

    Args:
        asset: The asset.
        raised: Whether it stands on a table as large as it is.

    Attributes:
        asset: The asset.
        raised: Whether it stands on a table.
        floor: Height of what it stands on; far below it where it stands on a table [m].
    """

    def __init__(self, asset: Asset, *, raised: bool = False) -> None:
        self.asset, self.raised = asset, raised
        low, high = asset.bounds()
        self.floor = float(low[2]) - (_TABLE if raised else 0.0)
        self._links: list[str] = []
        frames, halves, corners = [], [], []
        for link in asset.links:
            for each in link.colliders:
                frame, half = _box(each.convex)
                frames.append(frame)
                halves.append(half)
                is_hull = each.convex.kind == "hull"
                corners.append(
                    each.convex.points if is_hull else (_UNIT * half) @ frame[:3, :3].T + frame[:3, 3]
                )
                self._links.append(link.name)
        if raised:
            frame, half = np.eye(4), np.array([*(high - low)[:2], _TABLE]) / 2.0
            frame[:3, 3] = [*(low + high)[:2] / 2.0, self.floor + _TABLE / 2.0 - _GRAZE]
            frames.append(frame)
            halves.append(half)
            corners.append(_UNIT * half + frame[:3, 3])
            self._links.append(asset.links[0].name)
        self._frames, self._halves = np.array(frames), np.array(halves)
        self._corners = np.concatenate(corners)
        self._first = np.cumsum([0, *(len(each) for each in corners[:-1])])
        self._piece = np.repeat(np.arange(len(corners)), [len(each) for each in corners])
        self._names = [link.name for link in asset.links]
        self._index = np.array([self._names.index(name) for name in self._links])

    def depth(self, points: Array, pose: Mapping[str, Array], ignored: str = "") -> Array:
        """Return how deep points are inside the asset, negative outside it, shape (n,) [m].

        Args:
            points: shape (n, 3) [m].
            pose: Displacement of each link from rest, shape (4, 4) each.
            ignored: Name of a link that may be touched.
        """
        chosen = [index for index, name in enumerate(self._links) if name != ignored]
        boxes = self._placed(pose)[chosen]
        local = (points[None] - boxes[:, None, :3, 3]) @ boxes[:, :3, :3]
        return np.asarray((self._halves[chosen, None] - np.abs(local)).min(axis=2).max(axis=0))

    def touch(self, corners: Array, frame: Array, pose: Mapping[str, Array], ignored: str = "") -> bool:
        """Tell whether a box overlaps the asset, by the axes that may separate two boxes.

        Args:
            corners: Opposite corners of the box in the frame, shape (2, 3) [m].
            frame: Pose of the box in asset coordinates, shape (4, 4).
            pose: Displacement of each link from rest, shape (4, 4) each.
            ignored: Name of a link that may be touched.
        """
        own, half = frame[:3, :3], (corners[1] - corners[0]) / 2.0
        middle = own @ corners.mean(axis=0) + frame[:3, 3]
        low, high = self._extents(pose, own)
        at = middle @ own
        near = ((low <= at + half) & (high >= at - half)).all(axis=1)
        chosen = [index for index in np.flatnonzero(near) if self._links[index] != ignored]
        if not chosen:
            return False
        boxes, halves = self._placed(pose)[chosen], self._halves[chosen]
        turn = own.T @ boxes[:, :3, :3]  # axes of the boxes in the frame, (n, 3, 3)
        apart = (boxes[:, :3, 3] - middle) @ own
        size = np.abs(turn) + 1e-9
        there = np.abs(np.einsum("nji,nj->ni", turn, apart))
        close = (there <= halves + np.einsum("nji,j->ni", size, half)).all(axis=1)
        for first in range(3):
            second, third = (first + 1) % 3, (first + 2) % 3
            for other in range(3):
                right, left = (other + 1) % 3, (other + 2) % 3
                between = np.abs(
                    apart[:, third] * turn[:, second, other] - apart[:, second] * turn[:, third, other]
                )
                reach = half[second] * size[:, third, other] + half[third] * size[:, second, other]
                reach += halves[:, right] * size[:, first, left] + halves[:, left] * size[:, first, right]
                close &= between <= reach
        return bool(close.any())

    def spans(self, pose: Mapping[str, Array]) -> Array:
        """Return the bounding boxes of all pieces in asset coordinates, shape (n, 2, 3) [m]."""
        boxes = self._placed(pose)
        reach = np.einsum("nij,nj->ni", np.abs(boxes[:, :3, :3]), self._halves)
        return np.stack([boxes[:, :3, 3] - reach, boxes[:, :3, 3] + reach], axis=1)

    def _extents(self, pose: Mapping[str, Array], axes: Array) -> tuple[Array, Array]:
        """Return how far the pieces reach along axes, the columns of a matrix, shape (n, 3) each [m]."""
        moved = np.array([pose[name] for name in self._names])[self._index][self._piece]
        points = (np.einsum("nij,nj->ni", moved[:, :3, :3], self._corners) + moved[:, :3, 3]) @ axes
        return np.minimum.reduceat(points, self._first), np.maximum.reduceat(points, self._first)

    def _placed(self, pose: Mapping[str, Array]) -> Array:
        return np.asarray(np.array([pose[name] for name in self._names])[self._index] @ self._frames)


def _box(convex: Convex) -> tuple[Array, Array]:
    """Return the pose of an oriented box around a piece, shape (4, 4), and half its size, shape (3,) [m]."""
    if convex.kind == "hull":
        low, high = convex.bounds()
        frame = np.eye(4)
        frame[:3, 3] = (low + high) / 2.0
        return frame, (high - low) / 2.0
    if convex.kind == "box":
        return convex.pose, np.array(convex.size) / 2.0
    radius = convex.size[0]
    long = 0.0 if convex.kind == "sphere" else convex.size[1] / 2.0
    beyond = 0.0 if convex.kind == "cylinder" else radius
    return convex.pose, np.array([radius, radius, long + beyond])
