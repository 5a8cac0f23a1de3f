"""Surroundings of an asset in a picture: a seamless backdrop or the corner of a room, and the light.

In studio coordinates z is up, and the camera is towards -y.
"""

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from artgen._arrays import Array, affine
from artgen.asset import Asset
from artgen.asset.shape import Mesh
from artgen.materials import Material, material
from artgen.view.camera import Camera, box_corners
from artgen.view.opening import opened

Floats = NDArray[np.floating[Any]]
"""Vectors are rows of components, shape (3, n)."""

_PAPER = Material("studio_paper", (0.66, 0.66, 0.66), specular_roughness=1.0)
_WALL = Material("studio_wall", (0.70, 0.68, 0.64), specular_roughness=0.9)
_SKIRTING = Material("studio_skirting", (0.80, 0.79, 0.77), specular_roughness=0.4)
_FLOOR_REACH, _FLOOR_CELLS = 2.4, 40  # finely divided part of a floor, relative to the asset's radius
_LOBE = 64  # directions in the average for the blur of a rough surface


@dataclass(frozen=True, eq=False)
class Backdrop:
    """The surroundings of an asset, in studio coordinates."""

    kind: str  # `studio`, `room` or `none`
    center: Array  # center of the asset at rest, shape (3,) [m]
    radius: float  # half the diagonal of its bounding box [m]
    floor: float  # height of the floor [m]
    meshes: tuple[tuple[Mesh, Material], ...]  # visible surfaces with their materials

    def turned(self, camera: Camera) -> Array:
        """Return the transform from asset to studio coordinates, shape (4, 4).

        In the studio the asset is rotated for a picture instead of the camera; in a room its back or its
        front faces the wall.
        """
        angle = -camera.azimuth()
        if self.kind == "room":
            angle = 0.0 if math.cos(angle) > -1e-9 else math.pi
        turn = np.eye(3)
        turn[:2, :2] = [[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]]
        return affine(turn, self.center - turn @ self.center)


def backdrop(asset: Asset, kind: str) -> Backdrop:
    """Return the surroundings of an asset."""
    low, high = asset.bounds()
    center = (low + high) / 2.0
    radius = float(np.linalg.norm(high - low)) / 2.0
    floor = float(low[2]) - 1e-4 * radius  # no face coincides with one of the asset
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
            y = box_corners(link.bounds(), poses[link.name])[:, 1]
            farthest = max(farthest, float(np.abs(y - middle).max()))
    return farthest


def _cyclorama(center: Array, radius: float, floor: float) -> Mesh:
    """Return a sheet that lies on the floor and rises behind the asset without an edge."""
    bend = 5.0 * radius
    angles = np.linspace(0.0, math.pi / 2, 25)
    back = center[1] + 3.0 * radius
    near = center[1] + radius * np.linspace(-_FLOOR_REACH, _FLOOR_REACH, _FLOOR_CELLS + 1)
    y = np.concatenate([[-40.0 * radius], near, back + bend * np.sin(angles), [back + bend]])
    z = np.concatenate([[0.0], 0.0 * near, bend * (1.0 - np.cos(angles)), [60.0 * radius]])
    slope = np.concatenate([[0.0], 0.0 * near, angles, [math.pi / 2]])
    normals = np.column_stack([np.zeros_like(slope), -np.sin(slope), np.cos(slope)])
    return ribbon(np.column_stack([y, z + floor]), normals, _columns(center[0], radius, 50.0))


def _columns(middle: float, radius: float, reach: float) -> Array:
    """Return the places of the vertices of a floor across the studio, close together near the asset."""
    near = np.linspace(-_FLOOR_REACH, _FLOOR_REACH, _FLOOR_CELLS + 1)
    return np.asarray(middle + radius * np.array([-reach, *near, reach]))


def _room(center: Array, radius: float, floor: float, back: float) -> list[tuple[Mesh, Material]]:
    wall = back + 0.03 * radius + 0.02
    height, depth = 0.09, 0.015  # size of a skirting board [m]
    foot, top = wall - depth, floor + height
    up, front = (0.0, 0.0, 1.0), (0.0, -1.0, 0.0)
    rows = np.linspace(center[1] - _FLOOR_REACH * radius, foot, _FLOOR_CELLS, endpoint=False)
    near = [(float(row), floor) for row in rows]
    sheets = (
        (
            ((center[1] - 12.0 * radius, floor), *near, (foot, floor)),
            (up,) * (len(near) + 2),
            material("oak"),
        ),
        (((wall, floor), (wall, floor + 8.0 * radius)), (front, front), _WALL),
        (((foot, floor), (foot, top), (foot, top), (wall, top)), (front, front, up, up), _SKIRTING),
    )
    return [
        (ribbon(np.array(profile), np.array(normals), _columns(center[0], radius, 12.0)), made)
        for profile, normals, made in sheets
    ]


def ribbon(profile: Array, normals: Array, columns: Array) -> Mesh:
    """Return a sheet: a line in y and z, shape (n, 2), extruded along x, with vertices at some places."""
    count, wide = len(profile), len(columns)
    vertices = np.empty((count, wide, 3))
    vertices[..., 0] = columns
    vertices[..., 1:] = profile[:, None]
    length = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(profile, axis=0), axis=1))])
    uvs = np.stack(np.broadcast_arrays(vertices[..., 0], length[:, None]), axis=-1)
    first = (wide * np.arange(count - 1)[:, None] + np.arange(wide - 1)).reshape(-1, 1)
    triangles = np.concatenate([first + [0, 1, wide + 1], first + [0, wide + 1, wide]])
    flat = vertices.reshape(-1, 3)
    of_surface = np.zeros(len(flat), np.int64)
    return Mesh(flat, np.repeat(normals, wide, axis=0), uvs.reshape(-1, 2), of_surface, triangles)


def radiance(directions: Array) -> Array:
    """Return the brightness of the studio in unit directions, shape (n, 3) to (n,).

    A light tent that is dark at the camera. Softboxes and strips make long soft highlights on metal, and the
    gaps between them add contrast.
    """
    x, y, z = directions.T
    azimuth, elevation = np.arctan2(x, y), np.arcsin(np.clip(z, -1.0, 1.0))  # azimuth 0 is behind the asset
    dome = 0.26 + 0.40 * _step(elevation, 0.0, 1.3)
    floor = 0.50 - 0.28 * _step(-elevation, 0.0, 0.9)
    light = np.where(z > 0.0, dome, floor)
    light -= 0.20 * _window(y, -1.3, -0.80, 0.2) * _window(z, -0.25, 0.3, 0.25)  # dark side of the camera
    light += 2.6 * _window(azimuth, -2.75, -1.75, 0.14) * _window(elevation, 0.25, 1.02, 0.12)  # key softbox
    light += 1.4 * _window(azimuth, 1.30, 1.72, 0.10) * _window(elevation, -0.05, 1.10, 0.15)  # strip, right
    light += 1.1 * _window(azimuth, -1.20, -0.92, 0.08) * _window(elevation, -0.05, 0.95, 0.15)  # strip, left
    light += 0.8 * _window(elevation, 1.22, 2.0, 0.12)  # ceiling
    # the flag next to the strip
    return light - 0.16 * _window(azimuth, 1.95, 2.45, 0.1) * _window(elevation, -0.3, 0.9, 0.2)


def reflected(directions: Array, roughness: float) -> Array:
    """Return the reflection of a surface with a GGX roughness along directions, shape (n, 3) to (n,)."""
    if roughness < 0.03:
        return radiance(directions)
    number = np.arange(_LOBE) + 0.5
    alpha = roughness * roughness
    share = number / _LOBE
    cosine = np.sqrt((1.0 - share) / (1.0 + (alpha * alpha - 1.0) * share))
    sine = np.sqrt(1.0 - cosine * cosine)
    turn = number * (math.pi * (3.0 - math.sqrt(5.0)))
    # half vectors of a GGX lobe about z, and the reflected directions
    half = np.column_stack([sine * np.cos(turn), sine * np.sin(turn), cosine])
    mirrored = 2.0 * cosine[:, None] * half - np.array([0.0, 0.0, 1.0])
    weight = np.maximum(mirrored[:, 2], 0.0)
    aside = np.where(np.abs(directions[:, 2:]) < 0.9, [[0.0, 0.0, 1.0]], [[1.0, 0.0, 0.0]])
    across = np.cross(aside, directions)
    across /= np.linalg.norm(across, axis=1, keepdims=True)
    along = np.cross(directions, across)
    total = np.zeros(len(directions))
    for (u, v, w), share_of in zip(mirrored, weight, strict=True):
        if share_of > 0.0:
            total += share_of * radiance(u * across + v * along + w * directions)
    return np.asarray(total / weight.sum())


@dataclass(frozen=True)
class Box:
    """A rectangular lamp; lengths are relative to the asset's radius, from the asset's center."""

    center: tuple[float, float, float]  # it faces the asset
    half: tuple[float, float]  # half its width and height
    radiance: float

    def axes(self) -> Array:
        """Return the directions of width, height and light as rows, shape (3, 3)."""
        light = -np.array(self.center) / np.linalg.norm(self.center)
        across = np.cross((0.0, 1.0, 0.0) if abs(light[2]) > 0.9 else (0.0, 0.0, 1.0), light)
        across /= np.linalg.norm(across)
        return np.array([across, np.cross(light, across), light])


POINTS = 1024
"""Number of points on the lamps."""

_HORIZON, _ZENITH = 0.24, 0.46  # radiance of the tent

BOXES = (
    Box((-2.3, -2.7, 2.4), (1.05, 1.05), 12.0),  # key
    Box((0.3, 0.5, 4.4), (1.6, 1.0), 3.2),  # top
    Box((3.7, -0.9, 1.1), (0.5, 1.6), 2.2),  # right
    Box((-3.0, 1.9, 1.5), (0.4, 1.5), 2.6),  # left, behind
)
_AXES = np.array([box.axes() for box in BOXES], np.float32)
_CENTERS = np.array([box.center for box in BOXES], np.float32)
_HALVES = np.array([box.half for box in BOXES], np.float32)


def spread(count: int) -> Floats:
    """Return points in a square such that each run of them is spread evenly (R2), shape (2, count)."""
    index = np.arange(count)
    return np.stack([(0.5 + index * 0.7548776662466927) % 1.0, (0.5 + index * 0.5698402909980532) % 1.0])


@lru_cache(maxsize=1)
def lamp_points() -> Floats:
    """Return points of the lamps, of each in turn, relative to the asset's radius, shape (`POINTS`, 3)."""
    box = np.arange(POINTS) % len(BOXES)
    across, along = 2.0 * spread(POINTS // len(BOXES)).repeat(len(BOXES), axis=1) - 1.0
    u, v = across * _HALVES[box, 0], along * _HALVES[box, 1]
    points = _CENTERS[box] + u[:, None] * _AXES[box, 0] + v[:, None] * _AXES[box, 1]
    return np.asarray(points, np.float32)


def light_of(box: Box, origin: Floats, normal: Floats, radius: float) -> Floats:
    """Return the light of a lamp on white paper at open places, shape (3, n) [m], with unit normals."""
    center = np.array(box.center, np.float32)
    axis = (center / np.linalg.norm(center)).astype(np.float32)
    x, y, z = center[:, None] - origin * np.float32(1.0 / radius)
    square = x * x + y * y + z * z
    facing = np.maximum(x * normal[0] + y * normal[1] + z * normal[2], 0.0)
    leaving = np.maximum(x * axis[0] + y * axis[1] + z * axis[2], 0.0)
    power = np.float32(4.0 * box.half[0] * box.half[1] * box.radiance / math.pi)
    return np.asarray(power * facing * leaving / (square * square + np.float32(0.1)))


def dome(z: Floats) -> Floats:
    """Return the radiance of the tent around the studio for the vertical part of directions."""
    return np.asarray(np.maximum(_HORIZON + (_ZENITH - _HORIZON) * z, _HORIZON), np.float32)


def dome_light(z: Floats) -> Floats:
    """Return the light of the tent on white paper at open places, for the vertical part of normals."""
    return np.asarray(np.interp(z, *_dome_table()), np.float32)


@lru_cache(maxsize=1)
def _dome_table() -> tuple[Floats, Floats]:
    """Return vertical parts of normals, and the light of the tent there."""
    tilt = np.linspace(-1.0, 1.0, 33)
    across, around = spread(4096)
    level, turn = np.sqrt(across), 2.0 * math.pi * around
    up = level * np.cos(turn) * np.sqrt(1.0 - tilt[:, None] ** 2) + np.sqrt(1.0 - across) * tilt[:, None]
    return tilt, dome(up).mean(axis=1)


def environment(origin: Floats, direction: Floats, roughness: Floats, radius: float) -> Floats:
    """Return the radiance that a surface of a GGX roughness mirrors, shape (n,).

    Args:
        origin: Points, shape (3, n) [m].
        direction: Unit directions after the mirror.
        roughness: Shape (n,).
        radius: The asset's radius [m].
    """
    alpha = roughness * roughness
    _, y, z = direction
    soft = 0.12 + 1.2 * alpha
    level = _step(z, -soft, soft + 0.9)
    light = 0.16 + 0.42 * level
    light += 0.30 * _step(y, 0.0 - soft, 0.8 + soft)  # the backdrop
    light -= 0.12 * _window(y, -2.0, -0.80, 0.2 + soft) * _window(z, -0.25, 0.3, 0.25 + soft)
    for axes, center, half, box in zip(_AXES, _CENTERS, _HALVES, BOXES, strict=True):
        facing = -(axes[2] @ direction)
        start = origin / np.float32(radius) - center[:, None]
        ahead = facing > 0.02
        distance = (axes[2] @ start) / np.maximum(facing, 0.02)
        width = 0.02 + (0.01 + 1.1 * alpha) * distance
        u, v = (
            axes[0] @ start + distance * (axes[0] @ direction),
            axes[1] @ start + distance * (axes[1] @ direction),
        )
        share = _inside(u, half[0], width) * _inside(v, half[1], width)
        light += np.where(ahead & (distance > 0.0), box.radiance * share, 0.0)
    return np.asarray(light, np.float32)


def _inside(value: Floats, half: float, width: Floats) -> Floats:
    """Return the blurred inside of an interval about 0."""
    return _ramp((half - value) / width) - _ramp((-half - value) / width)


def _ramp(value: Floats) -> Floats:
    share = np.clip(0.5 + value * np.float32(0.3), 0.0, 1.0)
    return np.asarray(share * share * (3.0 - 2.0 * share))


def sphere_map_coordinates(directions: Array) -> Array:
    """Return the sphere map coordinates of unit directions seen from -y, shape (n, 3) to (n, 2), in 0..1."""
    x, y, z = directions.T
    scale = 2.0 * np.sqrt(np.maximum(x * x + z * z + (1.0 - y) ** 2, 1e-9))
    return np.column_stack([x / scale + 0.5, z / scale + 0.5])


@lru_cache(maxsize=32)
def sphere_map(roughness: float, size: int = 96) -> Array:
    """Return the reflections for a roughness as a sphere map, shape (size, size), from the bottom."""
    u, v = np.meshgrid((np.arange(size) + 0.5) / size - 0.5, (np.arange(size) + 0.5) / size - 0.5)
    square = np.minimum(4.0 * (u * u + v * v), 0.9999)
    root = np.sqrt(1.0 - square)
    directions = np.stack([4.0 * u * root, 2.0 * square - 1.0, 4.0 * v * root], axis=-1).reshape(-1, 3)
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    return reflected(directions, roughness).reshape(size, size)


def _step(value: Floats, low: float | Floats, high: float | Floats) -> Floats:
    share = np.clip((value - low) / (high - low), 0.0, 1.0)
    return np.asarray(share * share * (3.0 - 2.0 * share))


def _window(value: Floats, low: float, high: float, edge: float | Floats) -> Floats:
    """Return 1 between two values and 0 outside, with soft edges."""
    return _step(value, low - edge, low + edge) * (1.0 - _step(value, high - edge, high + edge))
