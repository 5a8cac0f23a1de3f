"""Surroundings of an asset in a picture: a photo studio, a room, or a wall around a built-in asset."""

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array
from artgen.asset.shape import Mesh
from artgen.materials import Material
from artgen.view.camera import Camera

Data = dict[str, Any]

_PAPER = Material("backdrop", (0.62, 0.615, 0.605), specular_roughness=0.95)


@dataclass(frozen=True, eq=False)
class Surroundings:
    """Surroundings of an asset.

    Attributes:
        lights: Mitsuba's dictionaries of lamps and of the sky by name.
        surfaces: Backdrop, walls and floors with their materials.
    """

    lights: dict[str, Data]
    surfaces: list[tuple[Mesh, Material]]


@dataclass(frozen=True, eq=False)
class Rig:
    """The frame of a studio, which rotates with the camera, so that every view is well lit.

    Attributes:
        mitsuba: The package, with a variant chosen.
        center: The middle of the asset, shape (3,) [m].
        floor: Height of the floor [m].
        scale: Half the diagonal of the asset [m].
        depth: Half the extent of the asset along y [m].
        back: Horizontal unit vector from the eye to the asset, shape (3,).
        side: 1 if angles around the asset count to the right of the eye, -1 if to the left.
    """

    mitsuba: Any
    center: Array
    floor: float
    scale: float
    depth: float
    back: Array
    side: float = 1.0

    @property
    def right(self) -> Array:
        """Horizontal unit vector to the right of the picture, shape (3,)."""
        return np.array([self.back[1], -self.back[0], 0.0])

    def around(self, azimuth: float, elevation: float, distance: float) -> Array:
        """Return a point around the asset [m], by azimuth and elevation [degrees] and distance [scales]."""
        turn, rise = self.side * math.radians(azimuth), math.radians(elevation)
        ahead = math.sin(turn) * self.right - math.cos(turn) * self.back
        direction = math.cos(rise) * ahead + math.sin(rise) * np.array([0.0, 0.0, 1.0])
        return np.asarray(self.center + distance * self.scale * direction)

    def softbox(
        self, place: Array, half: tuple[float, float], color: tuple[float, float, float], *, edge: float = 0.5
    ) -> Data:
        """Return a lamp that faces the asset and fades at its edge; `half` is half its size [scales]."""
        transform = self.mitsuba.ScalarTransform4f
        away = self.center - place
        up = [0.0, 0.0, 1.0] if abs(away[2]) < 0.95 * np.linalg.norm(away) else self.back.tolist()
        to_world = transform().look_at(place.tolist(), self.center.tolist(), up)
        to_world = to_world @ transform().scale([half[0] * self.scale, half[1] * self.scale, 1.0])
        glow = {"type": "bitmap", "bitmap": self.mitsuba.Bitmap(_faded(color, edge)), "raw": True}
        return {
            "type": "rectangle",
            "to_world": to_world,
            "bsdf": {"type": "null"},  # a lamp between the eye and the asset is not seen from behind
            "emitter": {"type": "area", "radiance": glow},
        }

    def dome(self, low: float, high: float, *, flags: float = 0.0) -> Data:
        """Return the dim surroundings, lighter above.

        Args:
            low: Radiance from the horizon down.
            high: Radiance from overhead.
            flags: How dark the flags at both sides of the eye are, which draw edges on metal, 0..1.
        """
        row, column = np.mgrid[0:64, 0:128]
        rise = math.pi / 2.0 - (row + 0.5) / 64 * math.pi
        turn = (column + 0.5) / 128 * 2.0 * math.pi - math.pi  # 0 behind the eye
        light = low + (high - low) * np.clip(np.sin(rise), 0.0, 1.0)
        dark = np.exp(-(((np.abs(turn) - math.radians(80.0)) / math.radians(14.0)) ** 2))
        light = light * (1.0 - flags * dark * (rise < math.radians(50.0)))
        pixels = (light[..., None] * np.array([1.0, 1.0, 1.02])).astype(np.float32)
        # Mitsuba's map has y up and its middle column at +z: stood up that is -y, the front
        transform = self.mitsuba.ScalarTransform4f
        heading = math.degrees(math.atan2(self.back[1], self.back[0])) - 90.0
        to_world = transform().rotate([0, 0, 1], heading) @ transform().rotate([1, 0, 0], 90)
        return {"type": "envmap", "bitmap": self.mitsuba.Bitmap(pixels), "to_world": to_world}


def rig(mitsuba: Any, bounds: Array, camera: Camera) -> Rig:
    """Return the frame of a studio around an asset with those bounds, shape (2, 3) [m]."""
    back = np.array(camera.target) - np.array(camera.position)
    back[2] = 0.0
    length = float(np.linalg.norm(back))
    back = back / length if length > 1e-6 else np.array([0.0, 1.0, 0.0])
    scale = max(float(np.linalg.norm(bounds[1] - bounds[0])) / 2.0, 1e-3)
    depth = float(bounds[1, 1] - bounds[0, 1]) / 2.0
    # the key light comes from the side that the front, or the back, of the asset is turned to
    side = 1.0 if back[0] * back[1] <= 0.0 else -1.0
    return Rig(mitsuba, bounds.mean(axis=0), float(bounds[0, 2]), scale, depth, back, side)


def backdrop(rig: Rig) -> Surroundings:
    """Return a seamless backdrop with a large key light, a fill, an overhead light and two rims."""
    lights = {
        "key": rig.softbox(rig.around(-48, 38, 3.0), (0.85, 1.15), (11.0, 10.7, 10.2)),
        "fill": rig.softbox(rig.around(62, 14, 3.6), (0.9, 1.7), (1.0, 1.04, 1.1), edge=0.9),
        "overhead": rig.softbox(rig.around(180, 78, 2.6), (1.2, 0.8), (4.2, 4.2, 4.2)),
        "rim_left": rig.softbox(rig.around(-112, 12, 2.6), (0.22, 1.5), (9.0, 9.2, 9.6), edge=0.3),
        "rim_right": rig.softbox(rig.around(108, 16, 2.8), (0.22, 1.5), (7.0, 7.2, 7.6), edge=0.3),
        "dome": rig.dome(0.10, 0.34, flags=0.85),
    }
    return Surroundings(lights, [(_cyclorama(rig), _PAPER)])


def _faded(color: tuple[float, float, float], edge: float) -> NDArray[np.float32]:
    """Return the texture of a lamp: full in the middle, fading over a share of its half width, (n, n, 3)."""
    across = np.linspace(-1.0, 1.0, 64)
    share = np.clip((1.0 - np.abs(across)) / edge, 0.0, 1.0)
    fade = share * share * (3.0 - 2.0 * share)
    fade = 0.12 + 0.88 * np.outer(fade, fade)
    return np.asarray(fade[..., None] * np.array(color), np.float32)


def _cyclorama(rig: Rig) -> Mesh:
    """Return the floor that bends up into the wall behind the asset."""
    scale = rig.scale
    radius, behind, front, high = 1.6 * scale, 3.2 * scale, 9.0 * scale, 9.0 * scale
    turns = np.linspace(0.0, math.pi / 2.0, 24)
    deep = np.concatenate([[-front, 0.0], behind - radius + radius * np.sin(turns), [behind]])
    rise = np.concatenate([[0.0, 0.0], radius * (1.0 - np.cos(turns)), [high]])
    lean = np.concatenate([[0.0, 0.0], turns, [math.pi / 2.0]])
    across = np.array([-14.0, 14.0]) * scale
    up = np.array([0.0, 0.0, 1.0])
    foot = np.array([rig.center[0], rig.center[1], rig.floor - 0.0005])
    points = foot + deep[:, None, None] * rig.back + rise[:, None, None] * up + across[:, None] * rig.right
    normals = np.cos(lean)[:, None, None] * up - np.sin(lean)[:, None, None] * rig.back
    normals = np.broadcast_to(normals, points.shape).reshape(-1, 3)
    first = 2 * np.arange(len(deep) - 1)[:, None]
    triangles = np.concatenate([first + [0, 1, 3], first + [0, 3, 2]])
    points = points.reshape(-1, 3)
    return Mesh(points, normals, points[:, :2].copy(), np.zeros(len(points), np.int64), triangles)
