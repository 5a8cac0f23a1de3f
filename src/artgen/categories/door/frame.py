"""The frame of a door, and the hinges in it."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen import feel
from artgen.categories.shared.fixings import hinge_offset
from artgen.categories.shared.fronts import Arch, Blank

_JAMB = 0.034  # thickness of jambs and head [m]
_TIMBER = 0.075  # width of the face of a solid timber frame [m]
_STOP = (0.012, 0.030)  # height and depth of a stop [m]
STOP_GAP = 0.002  # gap between the closed leaf and the stops, filled by a seal [m]
_REVEAL = 0.0095  # bare width of the front of the jamb beside the casing, for the hinges [m]
_ARCH_STOPS = 12  # number of straight lengths of the stop under an arch
_TOP = 0.19  # distance from the top of the leaf to the middle of the upper hinge [m]
_BOTTOM = 0.28  # distance from the bottom of the leaf to the middle of the lower hinge [m]

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


def door_frame(
    opening: ag.Region,
    arch: Arch | None,
    kind: FrameKind,
    finish: ag.Material,
    sill: ag.Material,
    floor_gap: ag.Scalar,
    casing: ag.Scalar,
    trim: Trim,
    *,
    jamb_cut: ag.Solid | None = None,
    head_cut: ag.Solid | None = None,
) -> ag.Body:
    """Make the frame of a door around its opening, as deep as the jambs: the link `frame`."""
    wide, eased = (_TIMBER, 0.003) if kind == "arched" else (_JAMB, 0.0015)
    straight = opening.z.high if arch is None else arch.spring
    tall = straight if arch is None else arch.outset(wide).spring
    jamb = ag.Region((opening.x.high, opening.x.high + wide), opening.y, (0, tall)).box(bevel=eased)
    if arch is None:
        head = opening.grow(x=wide, top=wide).stack(wide, None)[0].box(bevel=0.0015)
    else:  # the ends of the head are within the jambs, which reach up to its outer corners
        (band,) = arch.bands(wide, beyond=(arch.outset(wide).angle - arch.angle) * arch.radius)
        head = ag.extrude(band, opening.y.size, axis=ag.Y, bevel=0.0015).at(y=opening.y.mid)
    solids = [
        jamb if jamb_cut is None else jamb - jamb_cut,
        jamb.mirror(ag.X),
        head if head_cut is None else head - head_cut,
        *_stops(opening.with_(z=(0, straight)), arch),
    ]
    back = -opening.y.low  # of the leaf
    seal = ag.box(0.007, STOP_GAP - 0.0003, straight - _STOP[0], bevel=0.0005)
    seal = seal.at(opening.x.high - _STOP[0] / 2, back + STOP_GAP / 2 + 0.0002, (straight - _STOP[0]) / 2)
    bodies = [
        ag.part(solids, "frame", finish),
        ag.detail(seal | seal.mirror(ag.X), "seal", ag.material("rubber")),
    ]
    if kind == "full":
        front = _casing(opening, casing, trim)
        pair = [front.at(y=opening.y.low), front.rotate(ag.Z, math.pi).at(y=opening.y.high)]
        bodies.append(ag.part(pair, "frame", finish))
    if kind != "jambs":
        bodies += _threshold(opening, floor_gap - 0.004, sill)
    return ag.weld(*bodies)


def _stops(opening: ag.Region, arch: Arch | None) -> list[ag.Solid]:
    """Make the stops behind the leaf."""
    out, deep = _STOP
    behind = opening.with_(y=(STOP_GAP - opening.y.low, STOP_GAP - opening.y.low + deep))
    side = behind.across(None, out)[1].box(bevel=0.0025)
    if arch is None:
        top = behind.shrink(x=out).stack(out, None)[0].box(bevel=0.0025)
        return [side, side.mirror(ag.X), top]
    # in convex lengths, half a millimeter into the doorway
    bands = arch.outset(-out).bands(out, count=_ARCH_STOPS, beyond=out)
    strips = [ag.bounding_collider(ag.extrude(band, deep, axis=ag.Y, bevel=0.001)) for band in bands]
    return [side, side.mirror(ag.X), *(strip.at(y=behind.y.mid) for strip in strips)]


def _threshold(opening: ag.Region, thick: ag.Scalar, sill: ag.Material) -> list[ag.Body]:
    """Make the plate on the floor, 4 mm below the leaf; a metal plate has ribs against slipping."""
    plate = opening.with_(z=(0, thick)).box(bevel=ag.min_(0.0022, 0.4 * thick))
    bodies = [ag.part(plate, "threshold", sill)]
    if sill.base_metalness > 0.5:
        rib = ag.box(opening.x.size - 0.004, 0.0022, 0.0012, bevel=0.0005)
        at = ag.row((0.0, opening.y.mid - 0.021, thick), (0.0, 0.007, 0.0), 7)
        bodies.append(ag.detail(ag.array(rib, at=at), "threshold", sill))
    return bodies


def _casing(opening: ag.Region, width: ag.Scalar, trim: Trim) -> ag.Solid:
    """Make the molded trim of the front, mitered at its corners, its back at y = 0."""
    corners = [(share * width, high) for share, high in _TRIMS[trim]]
    # union with its back: a union is smooth at obtuse corners
    back = ag.rectangle(width, 0.004).at(width / 2, 0.002)
    section = ag.polygon([(0.0, 0.0), (width, 0.0), *corners]) | back
    x, z = opening.x.high + _REVEAL, opening.z.high + _REVEAL
    # swept on the floor, up the left leg and down the right leg, then rotated upright: up becomes the front
    course = ag.polyline([(-x, 0.0, 0.0), (-x, z, 0.0), (x, z, 0.0), (x, 0.0, 0.0)])
    return ag.sweep(section, course).rotate(ag.X, math.pi / 2)


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

    @property
    def _axis(self) -> tuple[ag.Scalar, ag.Scalar]:
        blank = self.blank
        return -(blank.width + self.gap) / 2, -blank.thickness / 2 - hinge_offset(self.radius)

    def half(self, make: Callable[..., ag.Body]) -> ag.Body:
        """Make the halves of the hinges on the leaf or on the jamb."""
        low, high = self.blank.bottom + _BOTTOM, self.blank.straight - _TOP
        levels = [low + (high - low) * index / (self.count - 1) for index in range(self.count)]
        depth = self.blank.thickness - 0.006  # the plates end 6 mm before the back of the edge
        half = make(height=self.height, radius=self.radius, depth=depth, finish=self.finish, levels=levels)
        return half.at(*self._axis)

    def joint(self, name: str, *, side: int = 1, needs: ag.Dependency | None = None) -> ag.Joint:
        """Make the joint about the pins, at the left or the right; positive opens the leaf towards -y."""
        x, y = self._axis
        pivot = (side * x, y, 0.0)
        drag = feel.Feel(friction=self.friction, damping=self.damping, velocity=6)
        return ag.Revolute(
            name, axis=(0.0, 0.0, -side), pivot=pivot, limits=(0, self.swing), feel=drag, needs=needs
        )

    def turns_within_gap(self) -> ag.Bool:
        """Return whether the swinging far corner of the leaf clears the jamb."""
        thick = hinge_offset(self.radius) + self.blank.thickness
        return thick * thick / (2 * self.blank.width) < self.gap - 0.0004
