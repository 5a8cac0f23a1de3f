"""Vents: perforated sheets and rows of slots."""

from __future__ import annotations

import math
from typing import Literal

import numpy as np
from manifold3d import JoinType
from numpy.typing import NDArray

from artgen._arrays import Array, successors
from artgen.asset.shape import Contour, Outline
from artgen.graph import records
from artgen.nodes import validators as inputs
from artgen.nodes.contours import circle_contour, moved_outline, reversed_contour, section
from artgen.nodes.handles import Profile, Scalar
from artgen.nodes.profile import _slot

MOST_HOLES = 2000
"""Most holes of a perforation as geometry."""

_FINE = 0.0012  # smaller holes have 8 sides, larger holes 12 [m]


def _grid(low: Array, high: Array, pitch: float, pattern: str) -> Array:
    """Return places in a box that are symmetric about its center, shape (n, 2)."""
    rise = pitch * (math.sqrt(0.75) if pattern == "hex" else 1.0)
    size = np.maximum(high - low, 0.0)
    columns, rows = (int(extent / step + 1e-9) + 1 for extent, step in zip(size, (pitch, rise), strict=True))
    column, row = np.meshgrid(np.arange(columns + 1), np.arange(rows))
    x = (column - (columns - 1) / 2.0) * pitch
    if pattern == "hex":
        # every other row is shifted by half a pitch, symmetrically
        x = x - np.where((row - rows // 2) % 2 == 0, 0.0, 0.5 * pitch)
    places = np.column_stack([x.ravel(), ((row - (rows - 1) / 2.0) * rise).ravel()])
    return places + (low + high) / 2.0


def _inside(points: Array, rings: list[Array]) -> NDArray[np.bool_]:
    """Tell which points lie in a region, shape (n,)."""
    inside = np.zeros(len(points), bool)
    for ring in rings:
        ends = successors(ring)
        above = ring[:, 1] > points[:, 1, None]
        crosses = above != (ends[:, 1] > points[:, 1, None])
        drop = np.where(ring[:, 1] == ends[:, 1], 1.0, ends[:, 1] - ring[:, 1])
        reach = ring[:, 0] + (points[:, 1, None] - ring[:, 1]) / drop * (ends[:, 0] - ring[:, 0])
        inside ^= ((crosses & (points[:, 0, None] < reach)).sum(axis=1) % 2).astype(bool)
    return inside


def _perforation(
    outline: Outline, pitch: float, radius: float, pattern: Literal["square", "hex"], margin: float
) -> Outline:
    inputs.positive("pitch", pitch)
    inputs.between("radius", radius, 1e-5, 0.499 * pitch)
    inputs.between("margin", margin, 0.0, 10.0)
    room = section(outline.contours).offset(-(radius + margin), JoinType.Round, 4.0, 32)
    estimate = room.area() / (pitch * pitch * (math.sqrt(0.75) if pattern == "hex" else 1.0))
    if estimate > 1.1 * MOST_HOLES:
        raise ValueError(_too_many(estimate))
    if room.is_empty():
        raise ValueError(
            f"no hole of radius {radius * 1e3:.3g} mm fits inside a margin of {margin * 1e3:.3g} mm; use "
            "smaller ones or a smaller margin"
        )
    rings = [np.asarray(ring, float) for ring in room.to_polygons()]
    low, high = (np.array(room.bounds()[span]) for span in (slice(0, 2), slice(2, 4)))
    places = _grid(low - 1e-9, high + 1e-9, pitch, pattern)
    # small tolerance for holes exactly at the margin
    places = places[_inside(places + (0.5 * (low + high) - places) * 1e-6, rings)]
    if len(places) > MOST_HOLES:
        raise ValueError(_too_many(len(places)))
    if not len(places):
        raise ValueError(f"no hole fits at a pitch of {pitch * 1e3:.3g} mm; use a smaller pitch or margin")
    hole = reversed_contour(circle_contour(radius, 8 if radius < _FINE else 12))
    holes = [Contour(hole.points + place, hole.normals_in, hole.normals_out) for place in places]
    return Outline((*outline.contours, *holes))


def _too_many(count: float) -> str:
    return (
        f"a perforation of about {count:.0f} holes is too fine for geometry, which allows {MOST_HOLES}; use "
        "a larger pitch, or a plain sheet of a material with a perforated texture"
    )


@records(_perforation)
def perforation(
    outline: Profile,
    pitch: Scalar,
    radius: Scalar,
    *,
    pattern: Literal["square", "hex"] = "hex",
    margin: Scalar = 0.003,
) -> Profile:
    """Punch round holes into a profile before it is extruded, which is much faster than cutting them later.

    A perforated part collides hole by hole: `bounding_collider(relief(...))` gives a flat sheet one collider,
    and `relief` builds many holes faster than `extrude`.

    Args:
        outline: Profile of the sheet.
        pitch: Distance between neighboring holes [m].
        radius: Radius of the holes [m].
        pattern: Holes in rows and columns, or each with six neighbors.
        margin: Least distance between holes and the border [m].

    Examples:
        >>> circle(0.03) - details.perforation(circle(0.03), 0.005, 0.0015)
    """


def _vent_slots(
    width: float, height: float, count: int, slot: float, direction: Literal["vertical", "horizontal"]
) -> Outline:
    inputs.positive("width", width)
    inputs.positive("height", height)
    inputs.positive("slot", slot)
    if count < 1:
        raise ValueError(f"vent slots need a count of at least 1, got {count}")
    upright = direction == "vertical"
    across, along = (width, height) if upright else (height, width)
    if slot > along:
        raise ValueError(
            f"a slot {slot * 1e3:.3g} mm wide is wider than long ({along * 1e3:.3g} mm); use a thinner one"
        )
    room = across - slot
    if (room < 0.0) if count == 1 else (room / (count - 1) <= slot * 1.02):
        raise ValueError(
            f"{count} slots {slot * 1e3:.3g} mm wide do not fit into {across * 1e3:.3g} mm; use fewer or "
            "thinner ones"
        )
    turn = np.array([[0.0, -1.0], [1.0, 0.0]]) if upright else np.eye(2)
    shape = moved_outline(_slot(along, slot), turn, np.zeros(2)).contours[0]
    step = np.array([1.0, 0.0]) if upright else np.array([0.0, 1.0])
    at = np.linspace(-room / 2.0, room / 2.0, count) if count > 1 else np.zeros(1)
    contours = tuple(
        Contour(shape.points + place * step, shape.normals_in, shape.normals_out) for place in at
    )
    return Outline(contours, tuple(contour.points for contour in contours))


@records(_vent_slots)
def vent_slots(
    width: Scalar,
    height: Scalar,
    count: int,
    *,
    slot: Scalar = 0.002,
    direction: Literal["vertical", "horizontal"] = "vertical",
) -> Profile:
    """Make a row of slots with round ends that fills a rectangle about the origin.

    The slots themselves are the profile: subtract them from a sheet, or print them dark.

    Args:
        width: Width of the rectangle [m].
        height: Height of the rectangle [m].
        count: Number of slots.
        slot: Width of a slot [m].
        direction: Direction of the slots.

    Examples:
        >>> rectangle(0.08, 0.04) - details.vent_slots(0.06, 0.02, 9)
    """
