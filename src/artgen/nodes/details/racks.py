"""Wire racks: touching wires, each a separate solid.

Wires touch within 2 micrometres instead of overlapping: no boolean is needed, mass is exact, and every
straight wire collides as its own capsule.
"""

from __future__ import annotations

import math
from typing import Literal

import numpy as np

from artgen import _portable, colliders
from artgen._arrays import Array, affine
from artgen.asset.shape import ComposedShape, Contour, Curve, Outline, Shape
from artgen.colliders.pieces import Pieces
from artgen.graph import FULL, detail_level, records
from artgen.nodes import validators as inputs
from artgen.nodes.handles import ArrayN3, Path, PointsLike, Scalar, Solid
from artgen.nodes.path import _polyline
from artgen.nodes.primitive import _capsule
from artgen.nodes.primitive_colliders import lazily
from artgen.nodes.profile import _circle
from artgen.nodes.surfaces import DeferredSkin, Skin, sides_of
from artgen.nodes.sweep import _sweep, swept_skin

_GAP = 2e-6  # [m]
_MOST_WIRES = 200
_SIDES = 6  # segments of a bent wire with round shading
_AXES = {"depth": np.array([0.0, 1.0, 0.0]), "width": np.array([1.0, 0.0, 0.0])}


def _copies(shape: Shape, places: Array) -> list[Shape]:
    return [shape.transformed(affine(np.eye(3), place)) for place in places]


def _loop(width: float, depth: float, radius: float, corner: float) -> Shape:
    """Return a closed wire in the plane z = 0 with outer sides at distances `width` and `depth`."""
    x, y = width / 2.0 - radius, depth / 2.0 - radius
    corners = np.array([[0.0, -y, 0.0], [x, -y, 0.0], [x, y, 0.0], [-x, y, 0.0], [-x, -y, 0.0]])
    return _sweep(_circle(radius), _polyline(tuple(corners), corner, closed=True))


def _wire_rack(
    width: float,
    depth: float,
    pitch: float,
    wire: float,
    frame: float,
    corner: float,
    direction: Literal["depth", "width"],
    supports: int,
) -> Shape:
    inputs.positive("wire", wire)
    inputs.positive("frame", frame)
    least = 4.0 * frame + 4.0 * wire
    inputs.between("width", width, least, math.inf)
    inputs.between("depth", depth, least, math.inf)
    inputs.between("corner", corner, 1.5 * frame, 0.45 * min(width, depth))
    if supports < 0:
        raise ValueError(f"supports must be 0 or more, got {supports}")
    across, along = (width, depth) if direction == "depth" else (depth, width)
    span = across - 4.0 * frame - 2.0 * wire  # distance of wires from the sides of the frame
    inputs.between("pitch", pitch, 2.0 * wire + _GAP, max(span, 2.0 * wire + _GAP))
    count = max(2, round(span / pitch) + 1)
    if count > _MOST_WIRES:
        raise ValueError(
            f"a rack of {count} wires is too fine, {_MOST_WIRES} are allowed; use a larger pitch or a texture"
        )
    axis = _AXES[direction]
    side = np.abs(np.cross(axis, [0.0, 0.0, 1.0]))
    places = np.linspace(-span / 2.0, span / 2.0, count)[:, None] * side
    rise = np.array([0.0, 0.0, frame + wire + _GAP])
    shapes = [_loop(width, depth, frame, corner)]
    # wires in the round corners of the frame are shorter, so that they end on it
    reaches = [
        along - 2.0 * _inset(abs(_portable.dot(place, side)), across, corner, frame) for place in places
    ]
    bars = {reach: _capsule(wire, reach, axis) for reach in dict.fromkeys(reaches)}
    for reach, place in zip(reaches, places, strict=True):
        shapes += _copies(bars[reach], (place + rise)[None])
    if supports:
        brace = _capsule(frame, across - 4.0 * frame - 2.0 * _GAP, side)
        levels = (np.arange(supports) + 1.0) / (supports + 1.0) - 0.5
        shapes += _copies(brace, levels[:, None] * (along - 2.0 * frame) * axis)
    return ComposedShape(shapes)


def _inset(place: float, across: float, corner: float, frame: float) -> float:
    """Return the inset of the round corner of a frame at a position across it [m]."""
    into = place - (across / 2.0 - frame - corner)
    if into <= 0.0:
        return 0.0
    return round(corner - math.sqrt(max(corner**2 - into**2, 0.0)), 9)


@records(_wire_rack)
def wire_rack(
    width: Scalar,
    depth: Scalar,
    *,
    pitch: Scalar = 0.022,
    wire: Scalar = 0.0015,
    frame: Scalar = 0.003,
    corner: Scalar = 0.015,
    direction: Literal["depth", "width"] = "depth",
    supports: int = 1,
) -> Solid:
    """Make a rack of wires on a bent frame, with the center of the frame at z = 0.

    Args:
        width: Overall width along X [m].
        depth: Overall depth along Y [m].
        pitch: Distance between wires [m], adjusted to fill the frame evenly.
        wire: Radius of the wires [m].
        frame: Radius of the wire of the frame [m].
        corner: Radius of the frame's corners at its center line [m].
        direction: Side of the frame along which the wires run.
        supports: Number of crossing wires below them, as thick as the frame.

    Examples:
        >>> details.wire_rack(0.4, 0.3, supports=2)
    """


def _bent_wires(path: Curve, radius: float, at: ArrayN3) -> Shape:
    inputs.positive("radius", radius)
    places = inputs.points("at", at, 3, 1)
    sides = _SIDES if detail_level() is FULL else sides_of(radius)
    around = math.tau * np.arange(sides) / sides
    outward = np.column_stack([_portable.cos(around), _portable.sin(around)])
    round_ = Outline((Contour(radius * outward, outward, outward),))
    pieces = lazily(lambda: colliders.union(*_moved_pieces(round_, path, places)))
    return DeferredSkin(lambda: _copied(swept_skin(round_, path), places)).shape(pieces)


def _copied(skin: Skin, places: Array) -> Skin:
    offsets = len(skin.vertices) * np.arange(len(places))
    return Skin(
        (skin.vertices[None] + places[:, None, :]).reshape(-1, 3),
        np.tile(skin.normals, (len(places), 1)),
        np.tile(skin.uvs, (len(places), 1)),
        (skin.triangles[None] + offsets[:, None, None]).reshape(-1, 3),
        (skin.targets[None] + offsets[:, None]).ravel(),
    )


def _moved_pieces(profile: Outline, path: Curve, places: Array) -> list[Pieces]:
    pieces = _sweep(profile, path).pieces
    return [pieces.transformed(affine(np.eye(3), place)) for place in places]


@records(_bent_wires)
def bent_wires(path: Path, radius: Scalar, *, at: PointsLike) -> Solid:
    """Make equal thin wires at several places, with few faces, for racks with many wires.

    They form one solid without a boolean, so the wires must not overlap.

    Args:
        path: Center line of a wire.
        radius: Radius of the wires [m].
        at: Offset of each wire [m].

    Examples:
        >>> bend = polyline([(0, 0, 0), (0, 0, 0.05), (0, 0.1, 0.05), (0, 0.1, 0)], fillet=0.01)
        >>> details.bent_wires(bend, 0.002, at=row((0, 0, 0), (0.02, 0, 0), 8))
    """
