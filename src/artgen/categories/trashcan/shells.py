"""The fixed part of a bin (wall, floor, feet, rim, bands, beads) and its inner bucket."""

from dataclasses import dataclass
from typing import Literal

import artgen as ag
from artgen.categories.shared.finish import casting
from artgen.categories.shared.fixings import feet
from artgen.categories.trashcan.bins import Can

WIRE = 0.0028
"""Radius of the bail [m]."""

_REACH = 0.62  # forward reach of the bail, as a share of half the bucket's depth
# distance from the wall to the middle of a fixed grip, with space for a finger between them [m]
_BEHIND = 0.028
_GRIP = 0.0058  # radius of the fixed grip [m]
_PLASTIC = ag.material("black_abs")
_GRAVITY = 9.81  # gravity [m/s2]


def bucket(can: Can, *, finish: ag.Material, loop: bool = True, band: ag.Material | None = None) -> ag.Body:
    """Make a bucket: the link `bucket`."""
    floor = can.floor(can.foot, can.foot + 0.0022)
    lip = can.band(can.top - 0.010, can.top, outer=-0.0012, inner=0.0005)
    bodies = [
        *can.shell("bucket", finish),
        ag.part(floor, "bucket", finish),
        ag.detail(lip, "bucket", finish if band is None else band),
    ]
    if loop:
        bodies += _loop(can, finish)
    return ag.weld(*bodies)


def _loop(can: Can, finish: ag.Material) -> list[ag.Body]:
    """Make a horizontal bar inside the rim, on two ribs, for fingers behind it."""
    finish = casting(finish)  # pressed of sheet, or molded hollow
    wall = can.front + 0.6 * can.wall
    y, z = wall + _BEHIND, can.top - 0.006
    # shorter in a narrow bucket: its ribs are clear of the corners
    corner = can.corner if can.plan in ("square", "rectangle") else 0.0
    beside = ag.min_(0.064 / 2.0 - 0.004, can.width / 2.0 - 0.5 * corner - 0.003)
    bar = ag.box(2.0 * (beside + 0.004), 0.009, 0.011, bevel=0.003).at(0.0, y, z)
    rib = ag.box(0.006, _BEHIND, 0.009, bevel=0.0015)
    middle = wall + _BEHIND / 2.0
    ribs = [rib.at(side * beside, middle, z) for side in (-1, 1)]
    hold = ag.grasp_on(bar, approach=-ag.Z, closing=(0.0, 1.0, 0.0), depth=0.010)
    return [ag.part(bar, "bucket", finish, grasp=hold), *(ag.part(each, "bucket", finish) for each in ribs)]


def bail_play(can: Can, gap: ag.Scalar) -> ag.Scalar:
    """Return an angle just below that at which a bail strikes a part above the rim [rad]."""
    return 0.9 * gap / (_REACH * can.depth / 2.0)


def bucket_slide(body: ag.Body, *, travel: ag.Scalar, needs: ag.Condition | ag.Dependency | None) -> ag.Joint:
    """Make the joint of a bucket that lifts out with little more force than its weight."""
    return ag.Prismatic(
        "bucket_slide",
        axis=ag.Z,
        limits=(0.0, travel),
        friction=0.15,  # friction at the wall; a lid that leans on the bucket must not hold it up
        damping=2.0,
        # force of a hand that lifts the bucket but cannot force the lid open
        effort=1.1 * _GRAVITY * body.mass() + 1.0,
        velocity=1.0,
        needs=needs,
    )


def with_bail(
    body: ag.Body, can: Can, *, finish: ag.Material, needs: ag.Condition | ag.Dependency | None
) -> ag.Body:
    """Attach a wire bail to a bucket, at rest level with the rim, to the front: the link `handle`."""
    # the sides of the front of a half-round bucket converge immediately
    half = can.half_across(can.wall) - (0.005 if can.plan == "half_round" else 0.0)
    x, y = half - WIRE - 0.0022, -_REACH * can.depth / 2.0
    z = can.top - WIRE
    way = ag.spline([(x, 0.0, z), (0.93 * x, 0.45 * y, z), (0.55 * x, 0.88 * y, z), (0.0, y, z),
                  (-0.55 * x, 0.88 * y, z), (-0.93 * x, 0.45 * y, z), (-x, 0.0, z)])  # fmt: skip
    wire = ag.simplified_collider(ag.sweep(ag.circle(WIRE), way), 0.00075)
    grip = ag.cylinder(_GRIP, 0.07, axis=ag.X, bevel=0.0015).at(0.0, y, z - 0.003)
    hold = ag.grasp_on(grip, approach=-ag.Z, closing=(0.0, 1.0, 0.0))
    inner, outer = x + WIRE + 0.0005, can.half_across(can.wall) + 0.001
    eye = ag.cylinder(0.004, outer - inner, axis=ag.X)
    eyes = [eye.at(side * (inner + outer) / 2.0, 0.0, z) for side in (-1, 1)]
    bail = ag.weld(ag.part(wire, "handle", finish), ag.part(grip, "handle", _PLASTIC, grasp=hold))
    weight = _GRAVITY * bail.mass() * (0.0 - bail.center_of_mass().y)
    turn = ag.Revolute(
        "handle_hinge",
        axis=-ag.X,
        pivot=(0.0, 0.0, z),
        limits=(0.0, 1.5),
        friction=1.2 * weight,  # the bail stays up: its bent ends grip the eyes
        damping=0.01,
        armature=0.0002,
        effort=3.2 * weight + 0.01,  # torque that raises the bail but cannot force the lid open
        velocity=8.0,
        needs=needs,
    )
    return ag.weld(body, *(ag.detail(eye, "bucket", finish) for eye in eyes)).attach(bail, turn)


Dress = Literal["plain", "base_band", "beads", "ring"]
"""Bands around a wall: none, a band at the foot, two beads, or a bright ring under the rim."""


@dataclass(frozen=True)
class Looks:
    """Materials of a bin."""

    finish: ag.Material  # finish of the wall
    lid: ag.Material  # finish of the lid or hood
    trim: ag.Material  # material of rim, base and hinge
    bright: ag.Material  # metal of rings and pins
    plastic: ag.Material  # material of hidden parts and of hinges


def stand(
    can: Can,
    looks: Looks,
    *,
    floor: ag.Scalar,
    dress: Dress,
    holes: ag.Solid | None = None,
    rim: ag.Scalar = 0.014,
    label: str = "body",
) -> ag.Body:
    """Make the wall, floor, feet and trim of a bin: the link `body`."""
    bodies = [
        *can.shell(label, looks.finish, name="body", holes=holes),
        ag.part(can.floor(floor, floor + 0.003), "base", looks.trim),
        feet(can.feet(0.024), height=floor, radius=0.008, finish=ag.material("rubber")),
    ]
    bodies += [ag.detail(each, "rim", looks.trim) for each in _rim(can, rim)]
    if dress == "base_band":
        band = can.band(can.foot - 0.001, can.foot + 0.020, outer=-0.0012, inner=0.0008)
        bodies.append(ag.detail(band if holes is None else band - holes, "base", looks.trim))
    elif dress == "beads":
        for share in (0.30, 0.36):
            z = can.foot + share * (can.top - can.foot)
            bodies.append(
                ag.detail(can.band(z, z + 0.005, outer=-0.0014, inner=0.0010), "body", looks.finish)
            )
    elif dress == "ring":
        z = can.top - 0.050
        ring = can.band(z, z + 0.006, outer=-0.0018, inner=0.0010)
        bodies.append(ag.detail(ring if holes is None else ring - holes, "rim", looks.bright))
    return ag.weld(*bodies)


def _rim(can: Can, high: ag.Scalar) -> list[ag.Solid]:
    if isinstance(high, int | float) and high <= 0.0:
        return []
    return [can.band(can.top - high, can.top + 0.0006, outer=-0.0012, inner=can.wall + 0.0008)]


def rolled_rim(can: Can, finish: ag.Material) -> ag.Body:
    """Make the bead around the rim of an open bin, visual only."""
    return ag.detail(
        can.band(can.top - 0.010, can.top + 0.0015, outer=-0.0028, inner=can.wall + 0.001), "rim", finish
    )
