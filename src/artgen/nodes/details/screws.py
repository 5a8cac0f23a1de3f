"""Visible heads of screws and rivets with a real recess, of at most 200 triangles."""

from __future__ import annotations

import math
from typing import Literal

import numpy as np

from artgen import _portable
from artgen._arrays import Array, Indices, affine, cached
from artgen.asset.shape import Contour, Outline, Shape
from artgen.graph import detail_level, records
from artgen.materials import Material
from artgen.nodes import validators as inputs
from artgen.nodes.body import detail, weld
from artgen.nodes.contours import circle_contour, faceted, moved_outline, reversed_contour
from artgen.nodes.details.relief import FRONT, facing_frame, in_shade, relief
from artgen.nodes.handles import Array3, Body, Profile, Scalar, Solid, VectorLike
from artgen.nodes.primitive import UP, _cylinder, dome
from artgen.nodes.primitive_colliders import around_hull
from artgen.nodes.surfaces import DeferredSkin, Sheets, Skin, triangulated
from artgen.nodes.unwrap import Rail

Drive = Literal["phillips", "pozidriv", "slot", "hex", "torx"]
"""Recess for a driver."""
Head = Literal["pan", "countersunk", "cap"]
"""A low dome, a disc that ends almost flush, or a tall cylinder."""

# radius, height and elevation of the normal [degrees] of the rows of a head, from the face upward; lengths
# relative to the radius of the head
_HEADS: dict[str, tuple[tuple[float, float, float], ...]] = {
    "pan": ((1.0, 0.0, 0.0), (1.0, 0.2, 12.0), (0.88, 0.44, 48.0), (0.66, 0.56, 78.0)),
    "countersunk": ((1.0, 0.0, 0.0), (1.0, 0.1, 0.0), (0.95, 0.16, 90.0)),
    "cap": ((1.0, 0.0, 0.0), (1.0, 0.82, 0.0), (0.9, 0.92, 90.0)),
}
_REACH = {"pan": 0.56, "countersunk": 0.62, "cap": 0.56}  # depth of the recess
_SLOT_REACH = {"pan": 0.62, "countersunk": 0.86, "cap": 0.8}  # width of a slot
_DEPTH = {"pan": 0.36, "countersunk": 0.13, "cap": 0.5}  # inner radius of the recess


def _reach(drive: Drive, head: Head) -> float:
    """Return the radius of a recess, relative to the radius of the head."""
    return (_SLOT_REACH if drive == "slot" else _REACH)[head]


@cached(8)
def _recess(drive: Drive) -> Array:
    """Return the border of a recess within the unit circle, shape (n, 2)."""
    if drive == "slot":
        return np.array([[-1.0, -0.15], [1.0, -0.15], [1.0, 0.15], [-1.0, 0.15]])
    if drive == "hex":
        angle = math.tau * np.arange(6) / 6
        return np.column_stack([_portable.cos(angle), _portable.sin(angle)])
    if drive == "torx":
        middle = (math.tau * np.arange(6) / 6)[:, None]
        angle = middle + np.radians([-11.0, 11.0, 30.0])
        radius = np.broadcast_to([1.0, 1.0, 0.7], (6, 3))
        return np.column_stack(
            [(radius * _portable.cos(angle)).ravel(), (radius * _portable.sin(angle)).ravel()]
        )
    half = 0.19 if drive == "phillips" else 0.16
    arm = [(1.0, -half), (1.0, half), (half * 1.35, half * 1.35)]
    if drive == "pozidriv":  # the thin diagonal marks of a Pozidriv recess
        arm[2:] = [(0.3, half), (0.5, 0.4), (0.4, 0.5), (half, 0.3)]
    rows = np.array(arm)
    turn = np.array([[0.0, -1.0], [1.0, 0.0]])
    quarters = [rows]
    for _ in range(3):
        quarters.append(quarters[-1] @ turn.T)
    return np.concatenate(quarters)


def _drive_recess(radius: float, drive: Drive) -> Outline:
    return Outline((faceted(_recess(drive) * inputs.positive("radius", radius)),))


@records(_drive_recess)
def drive_recess(radius: Scalar, drive: Drive) -> Profile:
    """Make the outline of the recess for a driver about the origin.

    Args:
        radius: Largest distance from the origin [m].
        drive: Kind of the recess; known while building.

    Examples:
        >>> circle(0.005) - details.drive_recess(0.003, "torx")
    """


def _head_skin(radius: float, drive: Drive, head: Head, turn: float) -> Skin:
    rows = np.array(_HEADS[head]) * [radius, radius, math.pi / 180.0]
    sides = 12 if drive == "pozidriv" or radius < 0.0015 else 16
    outer = circle_contour(1.0, sides)
    cosine, sine = math.cos(turn), math.sin(turn)
    recess = _drive_recess(_reach(drive, head) * radius, drive)
    hole = moved_outline(recess, np.array([[cosine, -sine], [sine, cosine]]), np.zeros(2)).contours[0]
    inward = reversed_contour(hole)
    top, floor = rows[-1, 1], rows[-1, 1] - _DEPTH[head] * radius
    sheets = Sheets()
    wall = _wall(sheets, outer, rows, radius)
    pit = _wall(sheets, inward, np.array([[1.0, floor, 0.0], [1.0, top, 0.0]]), 1.0)
    up = np.array([0.0, 0.0, 1.0])
    rings = [outer.points * rows[-1, 0], inward.points]
    flat = np.concatenate(rings)
    lid = np.column_stack([flat, np.full(len(flat), top)])
    sheets.cap(np.concatenate([wall[-1], pit[1]]), lid, up, flat, triangulated(rings))
    ground = np.column_stack([hole.points, np.full(len(hole.points), floor)])
    sheets.cap(pit[0][::-1], ground, up, hole.points, triangulated([hole.points]))
    base = outer.points * radius
    seat = np.column_stack([base, np.zeros(sides)])
    sheets.cap(wall[0], seat, -up, base * [-1.0, 1.0], triangulated([base])[:, ::-1])
    return sheets.skin()


def _wall(sheets: Sheets, border: Contour, rows: Array, scale: float) -> Indices:
    """Add a wall with rows of radius, height and elevation of the normal [rad]; return vertices by row."""
    # the radii are factors of the border; its scale [m] gives the distance along it
    rail = Rail.along(border)
    vertices = np.empty((len(rows), len(rail.vertex), 3))
    vertices[..., :2] = rows[:, 0, None, None] * border.points[rail.vertex]
    vertices[..., 2] = rows[:, 1, None]
    normals = np.empty_like(vertices)
    normals[..., :2] = _portable.cos(rows[:, 2])[:, None, None] * rail.normals
    normals[..., 2] = _portable.sin(rows[:, 2])[:, None]
    uvs = np.empty((*vertices.shape[:2], 2))
    uvs[..., 0], uvs[..., 1] = rail.distance * scale, rows[:, 1, None]
    return sheets.grid(rail, vertices, normals, uvs)


def _screw_head(radius: float, at: Array3, facing: Array3, drive: Drive, head: Head, turn: float) -> Shape:
    inputs.positive("radius", radius)
    if detail_level().thin:
        high = _HEADS[head][-1][1] * radius
        shape = _cylinder(radius, high, np.array(UP), 0.0).transformed(
            affine(np.eye(3), (0.0, 0.0, high / 2.0))
        )
    else:
        inputs.finite("turn", turn, "rad")
        skin = DeferredSkin(lambda: _head_skin(radius, drive, head, turn))
        shape = skin.shape(around_hull(skin.vertices))
    return shape.transformed(affine(facing_frame(facing, None), inputs.vector("at", at)))


@records(_screw_head)
def screw_head(
    radius: Scalar,
    at: VectorLike = (0.0, 0.0, 0.0),
    *,
    facing: VectorLike = FRONT,
    drive: Drive = "phillips",
    head: Head = "pan",
    turn: Scalar = 0.3,
) -> Solid:
    """Make the head of a screw on a face, with the recess above the face: no hole has to be cut.

    Args:
        radius: Radius of the head [m]: about 0.9 of the thread's diameter.
        at: Center on the face [m].
        facing: Outward direction of the face.
        drive: Kind of the recess; known while building.
        head: A low dome, a disc with a height of a sixth of its radius, or a tall cylinder.
        turn: Rotation of the recess [rad]; real screws end at any angle.

    Examples:
        >>> details.screw_head(0.004, drive="hex", head="cap")
    """


def screw(
    radius: Scalar,
    at: VectorLike = (0.0, 0.0, 0.0),
    *,
    material: Material,
    facing: VectorLike = FRONT,
    drive: Drive = "phillips",
    head: Head = "pan",
    turn: Scalar = 0.3,
    label: str = "screw",
) -> Body:
    """Make a visual screw head with a dark bottom of its recess.

    Args:
        radius: Radius of the head [m].
        at: Center on the face [m].
        material: Its metal.
        facing: Outward direction of the face.
        drive: Kind of the recess; known while building.
        head: A low dome, a disc with a height of a sixth of its radius, or a tall cylinder.
        turn: Rotation of the recess [rad].
        label: Semantic label.

    Examples:
        >>> plate = part(box(0.06, 0.004, 0.04), "plate", material("abs"))
        >>> weld(plate, details.screw(0.008, (0, -0.002, 0), material=material("steel"), drive="torx"))
    """
    solid = screw_head(radius, at, facing=facing, drive=drive, head=head, turn=turn)
    floor = _HEADS[head][-1][1] - _DEPTH[head]
    bottom = drive_recess(0.97 * _reach(drive, head) * radius, drive).rotate(turn)
    dark = relief(bottom, at, facing=facing, proud=(floor + 0.04) * radius, sunk=0.02 * radius)
    return weld(detail(solid, label, material), detail(dark, label, in_shade(material)))


def rivet(radius: Scalar, at: VectorLike = (0.0, 0.0, 0.0), *, facing: VectorLike = FRONT) -> Solid:
    """Make the head of a rivet on a face: a dome.

    Args:
        radius: Radius of the head [m].
        at: Center on the face [m].
        facing: Outward direction of the face.

    Examples:
        >>> box(0.03, 0.002, 0.02) | details.rivet(0.004, (0, -0.001, 0))
    """
    return dome(radius, height=0.55 * radius, axis=facing).at(at)
