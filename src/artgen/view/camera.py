"""Cameras, and views that frame an asset automatically."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from numbers import Real
from typing import Any

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.errors import ParameterError, nearest

_HALVINGS = 40  # of the interval in which a camera is centered
# heights of assets, and the elevations of their cameras [m, rad]
_HEIGHTS, _ABOVE = (0.25, 2.0), (0.42, 0.2)
# height relative to the longer side of flat assets, and their elevation
_FLAT, _OVER = (0.08, 0.4), (0.85, 0.42)

CLOSE_UP = "close-up:"
"""Prefix of a link's name in the name of a view of this link."""


def box_corners(bounds: Array, pose: Array) -> Array:
    """Return the corners of a box, shape (2, 3), after a rigid motion, shape (4, 4): shape (8, 3)."""
    return np.asarray(pose[:3, :3] @ np.array(np.meshgrid(*bounds.T)).reshape(3, -1) + pose[:3, 3:]).T


def _is_number(value: Any) -> bool:
    return isinstance(value, Real) and math.isfinite(value)


def _check_field_of_view(angle: float) -> None:
    if not (_is_number(angle) and 0.01 <= angle <= 2.5):
        raise ParameterError(f"field_of_view {angle!r} must be in 0.01..2.5 [rad]")


@dataclass(frozen=True)
class Camera:
    """An upright pinhole camera.

    Attributes:
        position: Position in asset coordinates, shape (3,) [m].
        target: Point at the center of the picture, shape (3,) [m].
        field_of_view: Vertical angle of view [rad].
    """

    position: tuple[float, float, float]
    target: tuple[float, float, float] = (0.0, 0.0, 0.0)
    field_of_view: float = 0.5

    def __post_init__(self) -> None:
        """Check every field."""
        for name in ("position", "target"):
            try:
                point = np.asarray(getattr(self, name), float)
            except (TypeError, ValueError):
                point = np.empty(0)
            if point.shape != (3,) or not np.isfinite(point).all():
                raise ParameterError(f"camera: {name} {getattr(self, name)!r} must be 3 finite numbers [m]")
            object.__setattr__(self, name, tuple(point.tolist()))
        _check_field_of_view(self.field_of_view)
        if math.dist(self.position, self.target) < 1e-6:
            raise ParameterError(f"camera: position and target are both {self.position}; move one of them")

    def axes(self) -> Array:
        """Return the directions right, up and forward of the picture as rows, shape (3, 3)."""
        forward = np.subtract(self.target, self.position)
        forward /= np.linalg.norm(forward)
        right = np.cross(forward, (0.0, 0.0, 1.0))
        if np.linalg.norm(right) < 1e-6:  # from straight above, the top of the picture is the asset's back
            right = np.array([1.0, 0.0, 0.0])
        right /= np.linalg.norm(right)
        return np.array([right, np.cross(right, forward), forward])

    def rays(self, size: tuple[int, int]) -> Array:
        """Return the directions through the centers of the pixels, of depth 1, shape (height, width, 3).

        Args:
            size: Width and height of the picture [pixels].
        """
        width, height = size
        right, up, forward = self.axes()
        half = math.tan(self.field_of_view / 2.0)
        across = (2.0 * (np.arange(width) + 0.5) - width) / height * half
        along = (height - 2.0 * (np.arange(height) + 0.5)) / height * half
        return np.asarray(forward + across[None, :, None] * right + along[:, None, None] * up)

    def pixels(self, points: Array, size: tuple[int, int]) -> Array:
        """Return the column and row of points from the top left corner, shape (n, 2) [pixels].

        Args:
            points: In front of the camera, in asset coordinates, shape (n, 3) [m].
            size: Width and height of the picture [pixels].
        """
        width, height = size
        x, y, depth = self.axes() @ (np.asarray(points, float) - self.position).T
        scale = height / (2.0 * math.tan(self.field_of_view / 2.0)) / depth
        return np.column_stack([width / 2.0 + scale * x, height / 2.0 - scale * y])

    def moved(self, matrix: Array) -> "Camera":
        """Return the camera after a rigid motion, shape (4, 4)."""
        turn, shift = matrix[:3, :3], matrix[:3, 3]
        return replace(
            self, position=tuple(turn @ self.position + shift), target=tuple(turn @ self.target + shift)
        )

    def azimuth(self) -> float:
        """Return the azimuth of the camera: 0 from the front, a quarter turn from the right [rad]."""
        away = np.subtract(self.position, self.target)
        if math.hypot(away[0], away[1]) < 1e-6 * float(np.linalg.norm(away)):
            return 0.0
        return math.atan2(away[0], -away[1])


@dataclass(frozen=True)
class View:
    """A viewing direction; the distance follows from the size of the subject.

    Attributes:
        azimuth: 0 from the front, a quarter turn from the right [rad].
        elevation: Angle above the horizon, at most a quarter turn [rad].
        field_of_view: Vertical angle of view [rad].
        margin: Free share of the picture along its edges, 0..0.9.
        link: Name of the framed link; empty for the whole asset.
    """

    azimuth: float = 0.0
    elevation: float = 0.0
    field_of_view: float = 0.45
    margin: float = 0.08
    link: str = field(default="", kw_only=True)

    def __post_init__(self) -> None:
        """Check every field."""
        _check_field_of_view(self.field_of_view)
        if not _is_number(self.azimuth):
            raise ParameterError(f"view: azimuth {self.azimuth!r} must be a finite number [rad]")
        if not (_is_number(self.elevation) and -math.pi / 2 <= self.elevation <= math.pi / 2):
            raise ParameterError(f"view: elevation {self.elevation!r} must be in -pi/2..pi/2 [rad]")
        if not (_is_number(self.margin) and 0.0 <= self.margin <= 0.9):
            raise ParameterError(f"view: margin {self.margin!r} must be in 0..0.9")

    def camera(self, points: Array, aspect: float = 1.0) -> Camera:
        """Return the camera that shows points as large as possible.

        Args:
            points: Points to frame, in asset coordinates, shape (n, 3) [m].
            aspect: Width of the picture divided by its height.
        """
        level = math.cos(self.elevation)
        away = np.array(
            [level * math.sin(self.azimuth), -level * math.cos(self.azimuth), math.sin(self.elevation)]
        )
        axes = Camera(tuple(away), (0.0, 0.0, 0.0)).axes()
        x, y, depth = axes @ np.asarray(points, float).T
        vertical = math.tan(self.field_of_view / 2.0) * (1.0 - self.margin)
        horizontal = vertical * aspect
        # a point is in the picture if |x - cx| <= tan * (depth + distance): the largest offsets decide
        right, left = (x - horizontal * depth).max(), (-x - horizontal * depth).max()
        above, below = (y - vertical * depth).max(), (-y - vertical * depth).max()
        distance = max((right + left) / (2.0 * horizontal), (above + below) / (2.0 * vertical))
        least = 1e-3 - depth.min()  # all points have to be in front of the camera, even a single one
        distance = max(distance, least)
        center = axes.T @ np.array([*(_middle(each, depth + distance) for each in (x, y)), -distance])
        target = center + axes[2] * ((depth.min() + depth.max()) / 2.0 + distance)
        return Camera(tuple(center), tuple(target), self.field_of_view)


def _middle(offsets: Array, depths: Array) -> float:
    """Return the place of a camera from which points are equally far from both edges of its picture."""
    low, high = float(offsets.min()), float(offsets.max())
    for _ in range(_HALVINGS):
        middle = (low + high) / 2.0
        slopes = (offsets - middle) / depths
        low, high = (middle, high) if slopes.max() + slopes.min() > 0.0 else (low, middle)
    return (low + high) / 2.0


VIEWS: Mapping[str, View] = {
    "front": View(0.0, 0.12),
    "three_quarter": View(-0.6, 0.28),
    "three_quarter_right": View(0.6, 0.28),
    "side": View(math.pi / 2, 0.12),
    "back": View(math.pi, 0.12),
    "three_quarter_back": View(math.pi + 0.6, 0.28),
    "top": View(0.0, math.pi / 2),
    "room": View(0.1, 0.5),  # over the side that has no wall
}
"""Named views."""


def camera_of(
    camera: Camera | View | str | None, asset: Asset, points: Mapping[str, Array], aspect: float
) -> Camera:
    """Return the requested camera; by default it is the one for an asset or for a room."""
    if isinstance(camera, Camera):
        return camera
    view = camera if isinstance(camera, View) else _named(camera, asset)
    if view.link:
        return view.camera(points[asset.link(view.link).name], aspect)
    return view.camera(np.concatenate(list(points.values())), aspect)


def elevation_of(asset: Asset) -> float:
    """Return the elevation of a camera for an asset: higher for small and flat ones, and for rooms [rad]."""
    if asset.is_room:  # its walls would hide what stands at them
        return VIEWS["room"].elevation
    low, high = asset.bounds()
    x, y, z = high - low
    flat = np.interp(z / max(x, y), _FLAT, _OVER, right=0.0)
    return float(max(np.interp(z, _HEIGHTS, _ABOVE), flat))


def _named(name: str | None, asset: Asset) -> View:
    """Return the view of a name; without one, and for a link, the view that the asset usually has."""
    usual = replace(VIEWS["room" if asset.is_room else "three_quarter"], elevation=elevation_of(asset))
    if name is None:
        return usual
    if not isinstance(name, str):
        raise ParameterError(f"camera {name!r} must be a Camera, a View, or the name of a view")
    if name.startswith(CLOSE_UP):
        return replace(usual, margin=0.25, link=name.removeprefix(CLOSE_UP))
    if name not in VIEWS:
        raise ParameterError(f"there is no view {name!r}.{nearest(name, [*VIEWS, CLOSE_UP + '<link>'])}")
    return VIEWS[name]
