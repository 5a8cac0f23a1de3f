"""Refrigerators whose links never collide, with knobs for faults; what other proof assets are made with."""

from collections.abc import Sequence

import numpy as np

from artgen import (
    Body,
    Graph,
    Prismatic,
    Revolute,
    Solid,
    X,
    Y,
    Z,
    box,
    cylinder,
    material,
    part,
    union,
    weld,
)
from artgen.asset import Asset
from artgen.graph import Cache

Offset = tuple[float, float, float]
NOWHERE: Offset = (0.0, 0.0, 0.0)
WHITE, GLASS, STEEL, RUBBER = (material(name) for name in ("polypropylene", "glass", "stainless", "rubber"))

_FRONT = -0.002  # gap between a body and its doors [m]
_THICK = 0.06  # of doors [m]
_HINGE = _FRONT - _THICK  # y of the hinge: on the front of the door [m]


def block(low: Sequence[float], high: Sequence[float]) -> Solid:
    """Return the box between two corners [m]."""
    lower, upper = np.array(low, float), np.array(high, float)
    size, middle = (upper - lower).tolist(), ((lower + upper) / 2).tolist()
    return box(*size).at(*middle)


def evaluated(body: Body, name: str) -> Asset:
    """Return the asset of a body that has no parameters."""
    evaluation = Graph(body).evaluate({}, Cache())
    return Asset.from_tree(evaluation.value, name, name)


def shifted(point: Sequence[float], offset: Offset) -> Offset:
    """Return a point moved by an offset [m]."""
    x, y, z = (float(a) + b for a, b in zip(point, offset, strict=True))
    return x, y, z


def carcass(low: Sequence[float], high: Sequence[float], wall: float) -> list[Solid]:
    """Return the five walls of a box that is open to the front [m]."""
    (x0, y0, z0), (x1, y1, z1) = low, high
    return [
        block((x0, y0, z0), (x0 + wall, y1, z1)),
        block((x1 - wall, y0, z0), (x1, y1, z1)),
        block((x0 + wall, y0, z0), (x1 - wall, y1, z0 + wall)),
        block((x0 + wall, y0, z1 - wall), (x1 - wall, y1, z1)),
        block((x0 + wall, y1 - wall, z0 + wall), (x1 - wall, y1, z1 - wall)),
    ]


def tray(low: Sequence[float], high: Sequence[float], wall: float = 0.003) -> Solid:
    """Return a box that is open at the top [m]."""
    (x0, y0, z0), (x1, y1, z1) = low, high
    return block(low, high) - block((x0 + wall, y0 + wall, z0 + wall), (x1 - wall, y1 - wall, z1 + 0.01))


def fridge(*, pivot: Offset = NOWHERE, wide: float = 0.0, limit: float = 1.0, rule: bool = True) -> Asset:
    """Make a refrigerator: a door with three bins, two crispers that need it open.

    Args:
        pivot: By how much the door's hinge is misplaced [m].
        wide: How much too wide the crispers are [m].
        limit: Factor on all limits.
        rule: Whether the crispers need the door.
    """
    width, depth, height, wall = 0.6, 0.6, 1.6, 0.05
    shelves = [
        block((wall, 0.12, z), (width - wall, depth - wall, z + thick))
        for z, thick in ((0.62, 0.01), (0.95, 0.005), (1.25, 0.005))
    ]
    compressor = block((wall, 0.45, wall), (width - wall, depth - wall, 0.2))
    body = part(union(*carcass((0, 0, 0), (width, depth, height), wall), compressor, *shelves), "body", WHITE)
    hinge = Revolute("hinge", pivot=shifted((0.005, _HINGE, 0.0), pivot), axis=-Z, limits=(0.0, 2.9 * limit))
    bins = [tray((0.07, _FRONT - 0.001, z), (0.52, 0.1, z + 0.1), 0.004) for z in (0.3, 0.75, 1.15)]
    door = part(union(block((0, _HINGE, 0), (width, _FRONT, height)), *bins), "door", WHITE)
    body = body.attach(door, hinge)
    for name, low, high in (("lower", 0.06, 0.3), ("upper", 0.34, 0.6)):
        inset = wall + 0.0025 - wide / 2
        crisper = tray((inset, 0.125, low), (width - inset, 0.44, high))
        slide = Prismatic(
            f"{name}_slide", axis=-Y, limits=(0.0, 0.3 * limit), needs=hinge > 2.6 if rule else None
        )
        body = body.attach(part(crisper, "crisper", GLASS, name=f"{name}_crisper"), slide)
    return evaluated(body, "fridge")


def gasket_fridge(*, depth: float = 0.0012, press: float = 0.001, pivot: Offset = NOWHERE) -> Asset:
    """Make a small refrigerator whose gasket is pressed into the front of its body.

    Args:
        depth: How deep the gasket is allowed to be [m].
        press: How deep it is [m].
        pivot: By how much the hinge is misplaced [m].
    """
    width, height, wall = 0.5, 0.85, 0.04
    body = part(union(*carcass((0, 0, 0), (width, 0.5, height), wall)), "body", WHITE)
    ring = block((0.03, _FRONT - 0.004, 0.03), (width - 0.03, press, height - 0.03)) - block(
        (0.045, -0.1, 0.045), (width - 0.045, 0.1, height - 0.045)
    )
    panel = part(block((0, _HINGE, 0.005), (width, _FRONT, height)), "door", WHITE)
    lug = part(block((-0.04, _HINGE, 0.3), (0.0, _HINGE + 0.02, 0.5)), "door", WHITE)
    hinge = Revolute("hinge", pivot=shifted((-0.03, _HINGE + 0.01, 0.0), pivot), axis=-Z, limits=(0.0, 1.9))
    body = body.attach(weld(panel, lug, part(ring, "gasket", RUBBER)), hinge)
    body = body.allow_contact("gasket", "body", depth=depth, when=hinge < 0.05, reason="the gasket seals")
    return evaluated(body, "gasket_fridge")


def french_fridge(
    *, pivot: Offset = NOWHERE, wide: float = 0.0, limit: float = 1.0, rule: bool = True
) -> Asset:
    """Make a refrigerator of 15 links: two doors over two freezer drawers, crispers, shelves, bins.

    The left door has a lip over the edge of the right one, which can only open after it.

    Args:
        pivot: By how much the left hinge is misplaced [m].
        wide: How much too wide everything that slides in the body is [m].
        limit: Factor on the limits of the doors.
        rule: Whether the right door needs the left one.
    """
    half, depth, low, height, wall = 0.455, 0.65, 0.75, 1.78, 0.045
    body = _french_body(half, depth, low, height, wall)
    left = Revolute(
        "left_hinge", pivot=shifted((0.005 - half, _HINGE, 0.0), pivot), axis=-Z, limits=(0.0, 2.8 * limit)
    )
    right = Revolute(
        "right_hinge",
        pivot=(half - 0.005, _HINGE, 0.0),
        axis=Z,
        limits=(0.0, 2.8 * limit),
        needs=left > 0.5 if rule else None,
    )
    body = body.attach(_french_door(-1, half, low, height), left).attach(
        _french_door(1, half, low, height), right
    )
    gap = 0.0025 - wide / 2
    slides = (
        ("left_crisper", -half + wall + gap, -0.005 - gap / 2, 0.86, 1.08, left > 2.6),
        ("right_crisper", 0.005 + gap / 2, half - wall - gap, 0.86, 1.08, right > 2.6),
        ("deli", -half + wall + gap, half - wall - gap, 1.12, 1.24, (left > 2.6) & (right > 2.6)),
    )
    for name, x0, x1, z0, z1, needs in slides:
        slide = Prismatic(f"{name}_slide", axis=-Y, limits=(0.0, 0.3), needs=needs)
        body = body.attach(part(tray((x0, 0.13, z0), (x1, 0.5, z1)), "crisper", GLASS, name=name), slide)
    for name, x0, x1, needs in (
        ("left_shelf", -half + wall + gap, -0.003, left > 2.6),
        ("right_shelf", 0.003, half - wall - gap, right > 2.6),
    ):
        slide = Prismatic(f"{name}_slide", axis=-Y, limits=(0.0, 0.2), needs=needs)
        plate = union(block((x0, 0.13, 1.4), (x1, 0.55, 1.406)), block((x0, 0.13, 1.4), (x1, 0.14, 1.42)))
        body = body.attach(part(plate, "shelf", GLASS, name=name), slide)
    lower, upper = (
        _freezer_drawer(name, half, wall, z0, z1, gap)
        for name, z0, z1 in (("lower", 0.08, 0.38), ("upper", 0.40, 0.735))
    )
    divider = part(block((-0.15, 0.01, 0.096), (-0.147, 0.54, 0.2)), "divider", GLASS)
    lower = lower.attach(divider, Prismatic("divider_slide", axis=X, limits=(-0.2, 0.5)))
    for name, drawer in (("lower", lower), ("upper", upper)):
        body = body.attach(drawer, Prismatic(f"{name}_slide", axis=-Y, limits=(0.0, 0.45)))
    return evaluated(body, "french_fridge")


def _french_body(half: float, depth: float, low: float, height: float, wall: float) -> Body:
    upper = carcass((-half, 0, low + wall / 2), (half, depth, height), wall)
    lower = carcass((-half, 0, 0.02), (half, depth, low + wall / 2), wall)
    feet = [
        cylinder(0.02, 0.03).at(x, y, 0.015) for x in (0.05 - half, half - 0.05) for y in (0.05, depth - 0.05)
    ]
    fixed = block((-half + wall, 0.13, 1.255), (half - wall, depth - wall, 1.26))
    rail = block((-0.01, 0.16, 0.7), (0.01, depth, low))
    return part(union(*upper, *lower, *feet, fixed, rail), "body", STEEL)


def _french_door(side: int, half: float, low: float, height: float) -> Body:
    """Make a door at x of the sign of `side`, with what moves on it."""
    name = "left" if side < 0 else "right"

    def at_side(x0: float, y0: float, z0: float, x1: float, y1: float, z1: float) -> tuple[Offset, Offset]:
        near, far = sorted((side * x0, side * x1))
        return (near, y0, z0), (far, y1, z1)

    panel = [block(*at_side(0.0025, _HINGE, low + 0.01, half, _FRONT, height))]
    panel += [tray(*at_side(0.07, _FRONT - 0.001, z, 0.38, 0.1, z + 0.1)) for z in (0.85, 1.15)]
    panel.append(block(*at_side(half - 0.41, _HINGE - 0.05, 0.9, half - 0.39, _HINGE - 0.03, 1.6)))
    panel += [
        block(*at_side(half - 0.41, _HINGE - 0.04, z, half - 0.39, _HINGE, z + 0.02)) for z in (0.95, 1.53)
    ]
    if side < 0:  # the lip in front of the other door
        panel.append(block((-0.02, _HINGE - 0.008, low + 0.01), (0.012, _HINGE - 0.003, height)))
        panel.append(block((-0.02, _HINGE - 0.008, low + 0.01), (-0.012, _HINGE, height)))
    door = part(union(*panel), "door", STEEL, name=f"{name}_door")
    if side < 0:  # a lid over the butter
        shelf = tray(*at_side(0.07, _FRONT - 0.001, 1.5, 0.38, 0.1, 1.55))
        lid = block(*at_side(0.068, 0.0, 1.553, 0.382, 0.1, 1.557))
        turn = Revolute("butter_lid", pivot=(0.0, 0.0, 1.556), axis=X, limits=(0.0, 1.4))
        return weld(door, part(shelf, "bin", GLASS)).attach(part(lid, "lid", GLASS, name="butter_lid"), turn)
    bin_ = tray(*at_side(0.07, _FRONT + 0.002, 1.45, 0.38, 0.1, 1.58))
    return door.attach(
        part(bin_, "bin", GLASS, name="ice_bin"), Prismatic("ice_lift", axis=Z, limits=(0.0, 0.1))
    )


def _freezer_drawer(name: str, half: float, wall: float, z0: float, z1: float, gap: float) -> Body:
    """Make a drawer with a tray that slides back in it."""
    inset = wall + gap
    front = block((-half, _HINGE, z0 - 0.015), (half, _FRONT, z1))
    handle = [block((-0.3, _HINGE - 0.05, z1 - 0.06), (0.3, _HINGE - 0.03, z1 - 0.04))]
    handle += [
        block((x - 0.01, _HINGE - 0.04, z1 - 0.06), (x + 0.01, _HINGE, z1 - 0.04)) for x in (-0.25, 0.25)
    ]
    low, high = z0 + 0.01, z1 - 0.09
    trough = tray((inset - half, _FRONT - 0.001, low), (half - inset, 0.55, high), 0.004)
    drawer = part(union(front, *handle, trough), "drawer", STEEL, name=f"{name}_drawer")
    basket = tray((inset - half + 0.006, 0.01, high - 0.08), (half - inset - 0.006, 0.2, high + 0.01))
    slide = Prismatic(f"{name}_basket_slide", axis=Y, limits=(0.0, 0.3))
    return drawer.attach(part(basket, "basket", GLASS, name=f"{name}_basket"), slide)
