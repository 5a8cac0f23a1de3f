"""The frame of a door, and the hinges in it."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen.categories.shared.fixings import hinge_frame, hinge_leaf, hinge_offset
from artgen.categories.shared.fronts import Arch, Blank

JAMB = 0.034
"""Thickness of jambs and head [m]."""

_TIMBER = 0.075  # width of the face of a solid timber frame [m]
_STOP = (0.012, 0.030)  # height and depth of a stop [m]
STOP_GAP = 0.002
"""Gap between the closed leaf and the stops [m]; a seal fills it."""

_REVEAL = 0.0095  # bare width of the front of the jamb beside the casing, for the hinges [m]
_ARCH_STOPS = 12  # number of straight lengths of the stop under an arch
_SILL_PLAY = 0.004  # gap between threshold and leaf [m]

FrameKind = Literal["jambs", "full", "arched"]

Trim = Literal["ogee", "flat", "stepped", "bevelled"]
"""Section of a casing."""

_TRIMS: dict[str, tuple[tuple[float, float], ...]] = {
    # shares of the width, and heights [m], from the outer edge to the inner edge; at most 15 mm high, for the
    # bolts to pass in front
    "ogee": (
        (1.0, 0.0132), (0.985, 0.0146), (0.965, 0.015), (0.86, 0.015), (0.84, 0.0147), (0.825, 0.0137),
        (0.80, 0.0126), (0.76, 0.0118), (0.72, 0.0114), (0.62, 0.0107), (0.40, 0.0096), (0.33, 0.0093),
        (0.28, 0.0088), (0.25, 0.0079), (0.22, 0.0073), (0.18, 0.0071), (0.05, 0.0070), (0.02, 0.0064),
        (0.0, 0.0050),
    ),
    "flat": (
        (1.0, 0.0130), (0.99, 0.0142), (0.975, 0.0145), (0.025, 0.0145), (0.01, 0.0142), (0.0, 0.0130),
    ),
    "stepped": (
        (1.0, 0.0140), (0.99, 0.0148), (0.98, 0.015), (0.76, 0.015), (0.745, 0.0148), (0.74, 0.0140),
        (0.74, 0.0112), (0.725, 0.0110), (0.36, 0.0110), (0.345, 0.0108), (0.34, 0.0100), (0.34, 0.0078),
        (0.325, 0.0075), (0.02, 0.0075), (0.005, 0.0070), (0.0, 0.0062),
    ),
    "bevelled": (
        (1.0, 0.0138), (0.99, 0.0148), (0.975, 0.015), (0.55, 0.015), (0.50, 0.0148), (0.04, 0.0072),
        (0.015, 0.0066), (0.0, 0.0058),
    ),
}  # fmt: skip


@dataclass(frozen=True)
class Doorway:
    """Clear opening of a frame."""

    width: ag.Float  # width between the jambs [m]
    height: ag.Float  # height under the head, at the crown of an arch [m]
    thickness: ag.Float  # thickness of the leaf [m]
    depth: ag.Float  # depth of the jambs, front to back [m]
    arch: Arch | None  # arch of the head; None for a straight head
    floor_gap: ag.Float  # gap under the leaf [m]

    @property
    def straight(self) -> ag.Scalar:
        """Height of the jambs [m]."""
        return self.height if self.arch is None else self.arch.spring

    @property
    def middle(self) -> ag.Float:
        """Position of the middle of the jambs along y [m]."""
        return (self.depth - self.thickness) / 2.0


def door_frame(
    doorway: Doorway,
    kind: FrameKind,
    *,
    finish: ag.Material,
    sill: ag.Material,
    casing: ag.Scalar,
    trim: Trim = "ogee",
    jamb_cut: ag.Solid | None = None,
    head_cut: ag.Solid | None = None,
) -> ag.Body:
    """Make the frame of a door: the link `frame`."""
    wide = _TIMBER if kind == "arched" else JAMB
    tall = doorway.straight if doorway.arch is None else doorway.arch.outset(wide).spring
    eased = 0.003 if kind == "arched" else 0.0015
    jamb = ag.box(wide, doorway.depth, tall, bevel=eased)
    beside, half_way = (doorway.width + wide) / 2.0, tall / 2.0
    right = jamb.at(beside, doorway.middle, half_way)
    head = _head(doorway, wide)
    solids = [
        right if jamb_cut is None else right - jamb_cut,
        jamb.at(-beside, doorway.middle, half_way),
        head if head_cut is None else head - head_cut,
        *_stops(doorway),
    ]
    bodies = [ag.part(solid, "frame", finish) for solid in solids]
    bodies.append(ag.detail(_seals(doorway), "seal", ag.material("rubber")))
    if kind == "full":
        front, back = -doorway.thickness / 2.0, doorway.depth - doorway.thickness / 2.0
        surround = _casing(doorway, casing, trim)
        bodies.append(ag.part(surround.at(0.0, front, 0.0), "frame", finish))
        bodies.append(ag.part(surround.rotate(ag.Z, math.pi).at(0.0, back, 0.0), "frame", finish))
    if kind != "jambs":
        bodies += _threshold(doorway, sill)
    return ag.weld(*bodies)


def _head(doorway: Doorway, wide: float) -> ag.Solid:
    if doorway.arch is None:
        head = ag.box(doorway.width + 2.0 * wide, doorway.depth, wide, bevel=0.0015)
        return head.at(0.0, doorway.middle, doorway.height + wide / 2.0)
    # the ends of the head are within the jambs, which reach up to its outer corners
    arch = doorway.arch
    (band,) = arch.bands(wide, beyond=(arch.outset(wide).angle - arch.angle) * arch.radius)
    return ag.extrude(band, doorway.depth, axis=ag.Y, bevel=0.0015).at(0.0, doorway.middle, 0.0)


def _stops(doorway: Doorway) -> list[ag.Solid]:
    """Make the stops behind the leaf."""
    out, deep = _STOP
    middle = doorway.thickness / 2.0 + STOP_GAP + deep / 2.0
    side = ag.box(out, deep, doorway.straight, bevel=0.0025)
    beside = (doorway.width - out) / 2.0
    sides = [side.at(x, middle, doorway.straight / 2.0) for x in (-beside, beside)]
    if doorway.arch is not None:
        # in convex lengths, half a millimeter into the doorway
        bands = doorway.arch.outset(-out).bands(out, count=_ARCH_STOPS, beyond=out)
        strips = [ag.bounding_collider(ag.extrude(band, deep, axis=ag.Y, bevel=0.001)) for band in bands]
        return [*sides, *(strip.at(0.0, middle, 0.0) for strip in strips)]
    top = ag.box(doorway.width - 2.0 * out, deep, out, bevel=0.0025)
    top = top.at(0.0, middle, doorway.height - out / 2.0)
    return [*sides, top]


def _seals(doorway: Doorway) -> ag.Solid:
    """Make the rubber seals on the sides of the stops, which the leaf touches."""
    tall = doorway.straight - _STOP[0]
    side = ag.box(0.007, STOP_GAP - 0.0003, tall, bevel=0.0005)
    middle = (doorway.thickness + STOP_GAP) / 2.0 + 0.0002
    beside = (doorway.width - _STOP[0]) / 2.0
    return ag.array(side, at=[(-beside, middle, tall / 2.0), (beside, middle, tall / 2.0)])


def _threshold(doorway: Doorway, sill: ag.Material) -> list[ag.Body]:
    """Make the plate on the floor; a metal plate has ribs against slipping."""
    thick = doorway.floor_gap - _SILL_PLAY
    plate = ag.box(doorway.width, doorway.depth, thick, bevel=ag.min_(0.0022, 0.4 * thick))
    bodies = [ag.part(plate.at(0.0, doorway.middle, thick / 2.0), "threshold", sill)]
    if sill.base_metalness > 0.5:
        rib = ag.box(doorway.width - 0.004, 0.0022, 0.0012, bevel=0.0005)
        places = [(0.0, doorway.middle + (index - 3.0) * 0.007, thick) for index in range(7)]
        bodies.append(ag.detail(ag.array(rib, at=places), "threshold", sill))
    return bodies


def _casing(doorway: Doorway, width: ag.Scalar, trim: Trim) -> ag.Solid:
    """Make the molded trim of the front, mitered at its corners, its back at y = 0."""
    corners = [(share * width, high) for share, high in _TRIMS[trim]]
    # union with its back: a union is smooth at obtuse corners
    back = ag.rectangle(width, 0.004).at(width / 2.0, 0.002)
    section = ag.polygon([(0.0, 0.0), (width, 0.0), *corners]) | back
    x, z = doorway.width / 2.0 + _REVEAL, doorway.height + _REVEAL
    # swept on the floor, up the left leg and down the right leg, then rotated upright: up becomes the front
    course = ag.polyline([(-x, 0.0, 0.0), (-x, z, 0.0), (x, z, 0.0), (x, 0.0, 0.0)])
    return ag.sweep(section, course).rotate(ag.X, math.pi / 2.0)


_TOP = 0.19  # distance from the top of the leaf to the middle of the upper hinge [m]
_BOTTOM = 0.28  # distance from the bottom of the leaf to the middle of the lower hinge [m]


@dataclass(frozen=True)
class Hanging:
    """Butt hinges at the left of a leaf that is centered in x."""

    blank: Blank  # leaf
    count: int  # number of hinges, 2 or 3
    gap: ag.Float  # gap between the leaf and the jamb [m]
    height: ag.Float  # height of a hinge [m]
    radius: ag.Float  # radius of the knuckles [m]
    finish: ag.Material  # metal of the hinges
    swing: ag.Float  # opening angle of the leaf [rad]
    friction: ag.Float  # friction of all hinges together [N m]
    damping: ag.Float  # damping of all hinges together [N m s/rad]

    def _half(self, make: Callable[..., ag.Body]) -> ag.Body:
        low, high = self.blank.bottom + _BOTTOM, self.blank.straight - _TOP
        levels = [low + (high - low) * index / (self.count - 1) for index in range(self.count)]
        half = make(
            height=self.height, radius=self.radius, depth=self._depth, finish=self.finish, levels=levels
        )
        return half.at(
            -(self.blank.width + self.gap) / 2.0, -self.blank.thickness / 2.0 - hinge_offset(self.radius), 0.0
        )

    def on_leaf(self) -> ag.Body:
        """Make the halves of the hinges on the leaf."""
        return self._half(hinge_leaf)

    def on_frame(self) -> ag.Body:
        """Make the halves of the hinges on the jamb."""
        return self._half(hinge_frame)

    @property
    def _depth(self) -> ag.Float:
        """Depth of the plates along the edge: they end 6 mm before its back [m]."""
        return self.blank.thickness - 0.006

    def joint(
        self,
        name: str,
        *,
        middle: ag.Scalar = 0.0,
        side: int = 1,
        needs: ag.Condition | ag.Dependency | None = None,
    ) -> ag.Joint:
        """Make the joint about the pins; positive opens the leaf towards -y."""
        blank = self.blank
        return ag.Revolute(
            name,
            axis=(0.0, 0.0, -side),
            pivot=(
                middle - side * (blank.width + self.gap) / 2.0,
                -blank.thickness / 2.0 - hinge_offset(self.radius),
                0.0,
            ),
            limits=(0.0, self.swing),
            friction=self.friction,
            damping=self.damping,
            effort=100.0,
            velocity=6.0,
            needs=needs,
        )

    def turns_within_gap(self) -> ag.Bool:
        """Return whether the swinging far corner of the leaf clears the jamb."""
        thick = hinge_offset(self.radius) + self.blank.thickness
        return thick * thick / (2.0 * self.blank.width) < self.gap - 0.0004
