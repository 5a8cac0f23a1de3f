"""Contact of a hand, as boxes in the frame of a grasp, with the exact solids of an asset."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np
from manifold3d import Manifold

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.asset.affordance import GRIPPER, block, clipped
from artgen.asset.collision import SolidPart, link_parts
from artgen.proof.overlap import LEAST_VOLUME

_BEHIND = 0.020  # search depth for the surface behind the point of a push [m]
_SEGMENTS = 32  # sides of the polygon around a finger
_SLACK = 1e-5  # tolerance of contact along the path of a hand [m]


@dataclass(frozen=True)
class Touch:
    """Contact of a hand."""

    link: str  # name of the link
    label: str  # label of the solid

    def __str__(self) -> str:
        return f"{self.link}/{self.label}"


class HandSpace:
    """Solids of an asset as obstacles of hands, without visual details.

    Args:
        asset: The asset, in memory or loaded.
    """

    def __init__(self, asset: Asset) -> None:
        self.asset = asset
        self._parts = {link.name: link_parts(link) for link in asset.links}
        self._boxes = {
            name: np.array([part.solid.bounding_box() for part in parts]).reshape(-1, 2, 3)
            for name, parts in self._parts.items()
        }

    @property
    def lowest(self) -> float:
        """Height of the lowest solid at rest [m]."""
        return min(float(boxes[:, 0, 2].min()) for boxes in self._boxes.values() if len(boxes))

    def first_touch(
        self, corners: Array, frame: Array, pose: Mapping[str, Array], ignore: str = ""
    ) -> Touch | None:
        """Return a solid that a box overlaps; None if the box is free.

        Args:
            corners: Opposite corners of the box in the frame, shape (2, 3) [m].
            frame: Pose of the box in asset coordinates, shape (4, 4).
            pose: Displacement of each link from rest, shape (4, 4) each.
            ignore: Name of a link whose overlap is ignored.
        """
        shrunk = np.array([corners[0] + _SLACK, corners[1] - _SLACK])
        return self._touch(block(shrunk, np.eye(4)), shrunk, frame, pose, ignore)

    def finger_touch(
        self, back: float, frame: Array, pose: Mapping[str, Array], ignore: str = ""
    ) -> Touch | None:
        """Return a solid that a finger with its tip at the origin overlaps; None if the finger is free."""
        radius = GRIPPER.finger / 2.0 - _SLACK
        corners = np.array([[-radius, -radius, -back], [radius, radius, -_SLACK]])
        return self._touch(_rod(radius, -back, -_SLACK), corners, frame, pose, ignore)

    def _touch(
        self, solid: Manifold, corners: Array, frame: Array, pose: Mapping[str, Array], ignore: str
    ) -> Touch | None:
        for link in self._parts:
            if link == ignore:
                continue
            local = _inverse(pose[link]) @ frame
            near = self._near(link, corners, local)
            if not len(near):
                continue
            moved = solid.transform(local[:3])
            for part in near:
                if (part.solid ^ moved).volume() > LEAST_VOLUME:
                    return Touch(link, part.label)
        return None

    def _near(self, link: str, corners: Array, frame: Array) -> list[SolidPart]:
        """Return the parts of a link whose bounding boxes overlap a box, in both coordinate systems."""
        turn, half = frame[:3, :3], (corners[1] - corners[0]) / 2.0
        middle = turn @ corners.mean(axis=0) + frame[:3, 3]
        boxes = self._boxes[link]
        apart, halves = boxes.mean(axis=1) - middle, (boxes[:, 1] - boxes[:, 0]) / 2.0
        close = (np.abs(apart) < halves + np.abs(turn) @ half).all(axis=1)
        if not close.any():
            return []
        close &= (np.abs(apart @ turn) < halves @ np.abs(turn) + half).all(axis=1)
        return [self._parts[link][index] for index in np.flatnonzero(close)]

    def inside(self, corners: Array, frame: Array, link: str) -> Array:
        """Return the corners of a link's solids at rest inside a box, in the frame, shape (n, 3) [m]."""
        near = self._near(link, corners, frame)
        return clipped([part.solid for part in near], block(corners, frame), frame)

    def others_inside(
        self, corners: Array, frame: Array, pose: Mapping[str, Array], link: str
    ) -> Iterator[tuple[Touch, Array]]:
        """Yield for all links but one the corners of solids inside a box, in its frame, shape (n, 3) [m].

        Args:
            corners: Opposite corners of the box in the frame, shape (2, 3) [m].
            frame: Pose of the box in asset coordinates, shape (4, 4).
            pose: Displacement of each link from rest, shape (4, 4) each.
            link: Name of the excluded link.
        """
        for other in self._parts:
            if other == link:
                continue
            local = _inverse(pose[other]) @ frame
            for part in self._near(other, corners, local):
                points = clipped([part.solid], block(corners, local), local)
                if len(points):
                    yield Touch(other, part.label), points

    def finger_depths(self, frame: Array, pose: Mapping[str, Array], back: float) -> dict[str, float]:
        """Return the depth at which a finger that moves along z first touches each link [m].

        Args:
            frame: Frame of the push in asset coordinates, shape (4, 4).
            pose: Displacement of each link from rest, shape (4, 4) each.
            back: Distance from which the finger starts [m].
        """
        radius = GRIPPER.finger / 2.0
        corners = np.array([[-radius, -radius, -back], [radius, radius, _BEHIND]])
        rod = _rod(radius, -back, _BEHIND)
        found = {}
        for link in self._parts:
            local = _inverse(pose[link]) @ frame
            near = self._near(link, corners, local)
            if not near:
                continue
            points = clipped((part.solid for part in near), rod.transform(local[:3]), local)
            if len(points):
                found[link] = float(points[:, 2].min())
        return found

    def finger_patch(self, frame: Array, depth: float, gives: float, link: str) -> Array:
        """Return the bounding rectangle of the contact of a finger with a link, in x and y, shape (2, 2) [m].

        Args:
            frame: Frame of the push, shape (4, 4).
            depth: Depth of the first contact along z [m].
            gives: Compliance of the finger tip [m].
            link: Name of the link.
        """
        radius = GRIPPER.finger / 2.0
        corners = np.array([[-radius, -radius, depth - gives], [radius, radius, depth + gives]])
        region = _rod(radius, depth - gives, depth + gives).transform(frame[:3])
        points = clipped((part.solid for part in self._near(link, corners, frame)), region, frame)[:, :2]
        return np.array([points.min(axis=0), points.max(axis=0)])


def _rod(radius: float, low: float, high: float) -> Manifold:
    return Manifold.cylinder(high - low, radius, radius, _SEGMENTS).translate((0.0, 0.0, low))


def _inverse(pose: Array) -> Array:
    result = np.eye(4)
    result[:3, :3] = pose[:3, :3].T
    result[:3, 3] = -pose[:3, :3].T @ pose[:3, 3]
    return result
