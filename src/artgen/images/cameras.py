"""Random cameras on the upper hemisphere, and what other programs want to know of one.

A camera's axes are those of OpenCV: x to the right of the picture, y down, z forward. A pixel at column i and
row j spans i..i+1 and j..j+1, so its centre lies at (i + 0.5, j + 0.5), as for the boxes of COCO.
"""

import math
from dataclasses import replace

import numpy as np

from artgen._arrays import Array
from artgen.view.camera import Camera, View

_ASIDE = 0.7  # share of what stays free beside the asset by which it may stand off the middle


def random_camera(
    points: Array,
    draw: np.random.Generator,
    *,
    field_of_view: tuple[float, float],
    elevation: tuple[float, float],
    azimuth: float,
    margin: tuple[float, float],
) -> Camera:
    """Return a camera that has all points in its picture, which is square, some way off its middle."""
    height = draw.uniform(math.sin(elevation[0]), math.sin(elevation[1]))
    view = View(
        float(draw.uniform(-azimuth, azimuth)),
        math.asin(height),
        float(draw.uniform(*field_of_view)),
        float(draw.uniform(*margin)),
    )
    return _shifted(view.camera(points), points, draw)


def _shifted(camera: Camera, points: Array, draw: np.random.Generator) -> Camera:
    """Return the camera moved aside, as far as the points stay in the picture; never below the floor."""
    seen = camera.pixels(points, (1, 1))  # in shares of the picture
    free = np.clip(np.minimum(seen.min(axis=0), 1.0 - seen.max(axis=0)), 0.0, 1.0)
    across, up = draw.uniform(-_ASIDE, _ASIDE, 2) * free
    right, above, forward = camera.axes()
    depth = float(((points - camera.position) @ forward).min())  # the nearest points move farthest
    move = 2.0 * depth * math.tan(camera.field_of_view / 2.0) * (across * right + up * above)
    floor = float(points[:, 2].min())
    if camera.position[2] + move[2] < floor + 0.02 * depth:
        move[2] = 0.0
    return replace(
        camera, position=tuple(camera.position + move), target=tuple(np.array(camera.target) + move)
    )


def intrinsics(camera: Camera, size: int) -> Array:
    """Return the matrix that takes points in camera coordinates to pixels, shape (3, 3)."""
    focal = size / (2.0 * math.tan(camera.field_of_view / 2.0))
    return np.array([[focal, 0.0, size / 2.0], [0.0, focal, size / 2.0], [0.0, 0.0, 1.0]])


def extrinsics(camera: Camera) -> Array:
    """Return the motion from asset to camera coordinates, shape (4, 4) [m]."""
    right, up, forward = camera.axes()
    result = np.eye(4)
    result[:3, :3] = [right, -up, forward]
    result[:3, 3] = -result[:3, :3] @ np.array(camera.position)
    return result
