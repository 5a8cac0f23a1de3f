"""Turned and thrown bodies, closed or hollow, as from a lathe or a potter's wheel.

The visible surface is a smooth skin. The mass and the colliders are a core of few facets inside it, at most a
millimeter deep: a smooth solid would have hundreds of unnecessary collider vertices.
"""

import math
from collections.abc import Sequence

import artgen as ag
from artgen import feel
from artgen.nodes.handles import Path

Point = tuple[ag.Scalar, ag.Scalar]
"""Radius and height of a point of an outline [m]."""

Run = Sequence[Point]
"""Points of an outline from the lower end up, smooth between them; two points make a straight run."""

Drawn = tuple[float, float, float]
"""A point of a form: radius over the body's radius, share of the body's height, and an addition to the height
over the radius, so that beads have the same shape on tall and short bodies."""

SIDES = 20
"""Facets of a core: 0.4 mm off a circle of 30 mm; three rings of them are one collider."""

_SMOOTH = 48  # number of facets of a skin: less than 0.07 mm off a circle of 30 mm
_GLASS_SIDES = 42  # number of facets of a blown vessel, each in a collider of its own
_GLASS_OFF = 0.00067  # distance of these colliders from the surface: two facets would be farther away [m]
_AROUND = 32  # sides of a collider with 64 corners: 0.4 mm off a circle of 90 mm

_SPARE = 0.0005  # gap between a hole and the colliders around it [m]
_WITHIN = 0.0005  # depth of the straight runs of a core below the outline [m]


def path_of(run: Run) -> Path:
    """Return the line of a run: straight through two points, a spline through more."""
    points = [(radius, 0.0, height) for radius, height in run]
    return ag.line(*points) if len(points) == 2 else ag.spline(points)


def drawn(form: Sequence[Sequence[Drawn]], radius: ag.Scalar, low: ag.Scalar, height: ag.Scalar) -> list[Run]:
    """Return the outline of a body from its drawn form."""
    return [[(r * radius, low + share * height + rest * radius) for r, share, rest in run] for run in form]


def core(runs: Sequence[Run], *, sides: int = SIDES) -> ag.Solid:
    """Make the faceted solid inside a turned body."""
    return ag.revolve(ag.half_section([path_of(run) for run in runs], within=_WITHIN), sides=sides)


def skin(runs: Sequence[Run], *, bore: ag.Scalar = 0.0) -> ag.Solid:
    """Make the smooth solid of a turned body, used as a `detail` around its core."""
    return ag.revolve(ag.half_section([path_of(run) for run in runs], bore=bore), sides=_SMOOTH)


def turned(
    runs: Sequence[Run],
    label: str,
    finish: ag.Material,
    *,
    hole: ag.Solid | None = None,
    spare: float = _SPARE,
    bore: ag.Scalar = 0.0,
    sides: int = SIDES,
    grasp: ag.Frame | Sequence[ag.Frame] = (),
) -> ag.Body:
    """Make a closed turned body about z."""
    body = core(runs, sides=sides)
    if hole is not None:
        body = ag.simplified_collider(body, spare) - hole
    return ag.weld(ag.part(body, label, finish, grasp=grasp), ag.detail(skin(runs, bore=bore), label, finish))


def blown(
    path: Path, label: str, finish: ag.Material, *, foot: ag.Scalar, wall: ag.Scalar, level: ag.Scalar
) -> ag.Body:
    """Make an open vessel: its glass is seen from both sides, so it has no core.

    The filled part collides as a solid; the part above collides as 21 sectors for each bend of its outline,
    so that straight slopes need fewer colliders.
    """
    vessel = ag.revolve(ag.half_section(path, wall=wall), sides=_GLASS_SIDES)
    upper = vessel.split(point=(0.0, 0.0, level), normal=ag.Z)
    # slightly more, so that both have corners of their own
    lower = vessel.split(point=(0.0, 0.0, level + 0.0001), normal=-ag.Z)
    pane = ag.cylinder_between((0.0, 0.0, 0.0), (0.0, 0.0, 1.4 * wall), foot - 0.5 * wall)
    # at narrow places 3 facets would be one collider, with a larger distance from the surface
    off = ag.min_(_GLASS_OFF, (1.0 - math.cos(3.0 * math.pi / _GLASS_SIDES)) * foot)
    return ag.weld(
        ag.part(ag.simplified_collider(upper, off), label, finish),
        ag.part(ag.bounding_collider(lower | pane), label, finish),
    )


def filled(path: Path, *, wall: ag.Scalar, level: ag.Scalar) -> ag.Solid:
    """Make the contents of a blown vessel up to a height, with a small gap to its wall."""
    inside = ag.revolve(ag.half_section(path, inset=wall + 0.0002))
    kept = inside.split(point=(0.0, 0.0, level), normal=-ag.Z)
    return kept.split(point=(0.0, 0.0, 1.4 * wall + 0.0002), normal=ag.Z)


def around(radius: ag.Scalar, sides: int = _AROUND) -> ag.Profile:
    """Return the polygon around a circle [m]; a prism or frustum of 32 sides or fewer is one collider."""
    return ag.regular_polygon(sides, radius / math.cos(math.pi / sides))


def chamfered(width: ag.Scalar, depth: ag.Scalar, cut: ag.Scalar) -> ag.Profile:
    """Return a rectangle with chamfered corners, the plan of a collider under a vessel; all lengths in m."""
    x, y = width / 2, depth / 2
    right = [(x, cut - y), (x, y - cut), (x - cut, y), (cut - x, y)]
    return ag.polygon([*right, *((-a, -b) for a, b in right)])


def bayonet(radius: ag.Scalar, *, half: float = 0.018) -> tuple[ag.Solid, ag.Solid]:
    """Make three lugs around a neck on z = 0, and the hooks over them.

    Hooks of 36 mm on a neck of 0.11 m come free by a turn of 0.48 rad.

    Args:
        radius: Radius of the neck [m].
        half: Half the width of the lugs and hooks [m].
    """
    lug = ag.Region((-half, half), (radius - 0.0040, radius + 0.0060), (0.0012, 0.0045)).box()
    hook = ag.Region((-half, half), (radius + 0.0020, radius + 0.0113), (0.0056, 0.0100)).box()
    hook |= ag.Region((-half, half), (radius + 0.0076, radius + 0.0119), (-0.0030, 0.0090)).box()
    turns = [math.pi / 6 + third * math.tau / 3 for third in range(3)]
    lugs, hooks = (ag.union(*(each.rotate(ag.Z, turn) for turn in turns)) for each in (lug, hook))
    return lugs, hooks


def ring_wall(foot: ag.Scalar, rim: ag.Scalar, tall: ag.Scalar, wall: float, count: int) -> ag.Solid:
    """Make the faceted wall inside the skin of an open vessel, which collides; its foot is at z = 0."""
    sides, low, thick = ag.regular_polygon(count, 1.0), 0.0022, 0.0003
    ends = [foot + (rim - foot) * low / tall, rim]
    out = [sides.scale(each - thick) for each in ends]
    inside = [sides.scale((each - wall + thick) / math.cos(math.pi / count)) for each in ends]
    return ag.loft(out, [low, tall - 0.0002]) - ag.loft(inside, [low - 0.0001, tall])


def hoop(outer: ag.Scalar, inner: ag.Scalar, tall: ag.Scalar, count: int) -> ag.Solid:
    """Make a faceted ring about the origin, which collides inside a smooth one."""
    sides = ag.regular_polygon(count, 1.0)
    return ag.extrude(sides.scale(outer) - sides.scale(inner / math.cos(math.pi / count)), tall)


def swinging_handles(
    body: ag.Body,
    radius: ag.Scalar,
    z: ag.Scalar,
    friction: ag.Scalar,
    finish: ag.Material,
    *,
    half: float = 0.044,
    drop: float = 0.048,
    sunk: float = 0.006,
) -> ag.Body:
    """Add a hanging handle at each side of a vessel, which swings up until it is level.

    Links are `handle_right` and `handle_left`, joints `handle_swing_right` and `handle_swing_left`.

    Args:
        body: The vessel.
        radius: Outer radius of its wall at the handles [m].
        z: Height of the pivots [m].
        friction: Friction of a handle [N m].
        finish: Material of the handles.
        half: Half the width of a handle [m].
        drop: Length of a handle below its pivots [m].
        sunk: Depth of the eyes in the wall [m].
    """
    axle = radius + 0.012
    eyes = [
        ag.Region((radius - sunk, axle + 0.006), (y - 0.006, y + 0.006), (z - 0.007, z + 0.007)).box(
            bevel=0.002
        )
        for y in (-half + 0.0136, half - 0.0136)
    ]
    line = [(axle, -half, z), (axle, -half, z - drop), (axle, half, z - drop), (axle, half, z)]
    bar = ag.sweep(ag.regular_polygon(8, 0.0042), ag.polyline(line, fillet=0.018))
    ends = [ag.cylinder(0.0055, 0.0108, axis=ag.Y, bevel=0.001).at(axle, y, z) for y in (-half, half)]
    hold = ag.grasp_on(bar, approach=-ag.X, closing=ag.Z, at=(axle, 0, z - drop), depth=0.008)
    ring = ag.part(ag.union(bar, *ends), "handle", finish, name="handle", grasp=hold)
    drag = feel.Feel(friction=friction, damping=0.005, effort=8.0)
    swing = ag.Revolute("handle_swing", axis=-ag.Y, pivot=(axle, 0, z), limits=(0, 1.5), feel=drag)
    fixed = ag.part(eyes, "hinge", finish)
    return ag.weld(body, fixed, fixed.mirror(ag.X)).attach_pair(ring, swing)
