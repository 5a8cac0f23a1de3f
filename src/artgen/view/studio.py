"""Surroundings of an asset in a picture: a seamless backdrop, or the corner of a room."""

import math
from dataclasses import dataclass

import numpy as np

from artgen._arrays import Array
from artgen.asset import Asset
from artgen.asset.shape import Mesh
from artgen.materials import Material, material
from artgen.view.camera import Camera
from artgen.view.opening import opened

_PAPER = Material("studio_paper", (0.74, 0.74, 0.74), specular_roughness=1.0)
_WALL = Material("studio_wall", (0.70, 0.68, 0.64), specular_roughness=0.9)
_SKIRTING = Material("studio_skirting", (0.80, 0.79, 0.77), specular_roughness=0.4)


@dataclass(frozen=True, eq=False)
class Backdrop:
    """The surroundings of an asset, in studio coordinates."""

    kind: str  # `studio`, `room` or `none`
    center: Array  # center of the asset at rest, shape (3,) [m]
    radius: float  # half the diagonal of its bounding box [m]
    floor: float  # height of the floor [m]
    meshes: tuple[tuple[Mesh, Material], ...]  # visible surfaces with their materials

    @property
    def beyond(self) -> float:
        """Largest distance of visible things behind the asset [m]."""
        return 60.0 * self.radius

    def turned(self, camera: Camera) -> Array:
        """Return the transform from asset to studio coordinates, shape (4, 4).

        In the studio the asset is rotated for a picture instead of the camera; in a room its back or its
        front faces the wall.
        """
        result = np.eye(4)
        angle = -camera.azimuth()
        if self.kind == "room":
            angle = 0.0 if math.cos(angle) > -1e-9 else math.pi
        result[:2, :2] = [[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]]
        result[:3, 3] = self.center - result[:3, :3] @ self.center
        return result


def backdrop(asset: Asset, kind: str) -> Backdrop:
    """Return the surroundings of an asset."""
    low, high = asset.bounds()
    center = (low + high) / 2.0
    radius = float(np.linalg.norm(high - low)) / 2.0
    floor = float(low[2]) - 1e-4 * radius  # no face of it coincides with the asset's
    meshes: list[tuple[Mesh, Material]] = []
    if kind == "studio":
        meshes = [(_cyclorama(center, radius, floor), _PAPER)]
    elif kind == "room":
        meshes = _room(center, radius, floor, center[1] + _reach(asset, float(center[1])))
    return Backdrop(kind, center, radius, floor, tuple(meshes))


def _reach(asset: Asset, middle: float) -> float:
    """Return the extent of an asset to its front or back, closed or open [m]."""
    farthest = 0.0
    for q in ({}, opened(asset)):
        poses = asset.pose(q)
        for link in asset.links:
            corners = np.array(np.meshgrid(*link.bounds().T)).reshape(3, -1)
            y = poses[link.name][1, :3] @ corners + poses[link.name][1, 3]
            farthest = max(farthest, float(np.abs(y - middle).max()))
    return farthest


def _cyclorama(center: Array, radius: float, floor: float) -> Mesh:
    """Return a sheet that lies on the floor and rises behind the asset without an edge."""
    bend = 5.0 * radius
    angles = np.linspace(0.0, math.pi / 2, 25)
    back = center[1] + 3.0 * radius
    y = np.concatenate([[-40.0 * radius], back + bend * np.sin(angles), [back + bend]])
    z = np.concatenate([[0.0], bend * (1.0 - np.cos(angles)), [60.0 * radius]])
    slope = np.concatenate([[0.0], angles, [math.pi / 2]])
    normals = np.column_stack([np.zeros_like(slope), -np.sin(slope), np.cos(slope)])
    return ribbon(np.column_stack([y, z + floor]), normals, center[0], 50.0 * radius)


def _room(center: Array, radius: float, floor: float, back: float) -> list[tuple[Mesh, Material]]:
    wall = back + 0.03 * radius + 0.02
    wide = 12.0 * radius
    height, depth = 0.09, 0.015  # size of a skirting board [m]
    up, front = np.array([0.0, 0.0, 1.0]), np.array([0.0, -1.0, 0.0])
    near, foot = center[1] - 12.0 * radius, wall - depth
    boards = material("oak")
    return [
        (ribbon(np.array([[near, floor], [foot, floor]]), np.array([up, up]), center[0], wide), boards),
        (
            ribbon(
                np.array([[wall, floor], [wall, floor + 8.0 * radius]]),
                np.array([front, front]),
                center[0],
                wide,
            ),
            _WALL,
        ),
        (
            ribbon(
                np.array(
                    [[foot, floor], [foot, floor + height], [foot, floor + height], [wall, floor + height]]
                ),
                np.array([front, front, up, up]),
                center[0],
                wide,
            ),
            _SKIRTING,
        ),
    ]


def ribbon(profile: Array, normals: Array, middle: float, half: float) -> Mesh:
    """Return a sheet: a line in y and z, shape (n, 2), extruded along x."""
    count = len(profile)
    vertices = np.empty((count, 2, 3))
    vertices[..., 0] = middle + np.array([-half, half])
    vertices[..., 1:] = profile[:, None]
    length = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(profile, axis=0), axis=1))])
    uvs = np.stack(np.broadcast_arrays(vertices[..., 0], length[:, None]), axis=-1)
    first = 2 * np.arange(count - 1)[:, None]
    triangles = np.concatenate([first + [0, 1, 3], first + [0, 3, 2]])
    flat = vertices.reshape(-1, 3)
    return Mesh(
        flat,
        np.repeat(normals, 2, axis=0),
        uvs.reshape(-1, 2),
        np.zeros(len(flat), np.int64),
        triangles,
    )
