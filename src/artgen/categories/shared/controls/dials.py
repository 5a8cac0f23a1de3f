"""Dials: knobs on a panel that fingers turn, their joint, and the print around them.

A dial is modeled about the origin on the plane y = 0, which is the face of its panel, and projects to -y. It
has a gap of 0.6 mm to the panel, which hides its shaft, so that no hole has to be cut.
"""

import math
from typing import Literal

import artgen as ag
from artgen import details
from artgen.nodes.details.dials import SWEEP

DialStyle = Literal["round", "fluted", "bar", "skirted", "capped"]
"""A plain cylinder, a fluted cylinder, a bar on a disc, a knob on a skirt, or a knob with a metal cap."""

GAP = 0.0006
"""Gap between a dial and its panel [m]."""

_FLUTES = 18
_FLUTE = 0.055  # depth of a flute, as a share of the radius
_CLEAR = 0.0012  # distance of finger tips from the panel [m]


def _fluted() -> ag.Profile:
    """Make the outline of a fluted knob of radius 1."""
    steps = 4 * _FLUTES
    angles = [math.tau * step / steps for step in range(steps)]
    radii = [1.0 - _FLUTE * (0.5 - 0.5 * math.cos(_FLUTES * angle)) for angle in angles]
    return ag.polygon([(r * math.cos(a), r * math.sin(a)) for r, a in zip(radii, angles, strict=True)])


def _disc(radius: ag.Scalar, near: ag.Scalar, far: ag.Scalar, bevel: ag.Scalar) -> ag.Solid:
    """Make a disc between two distances from the panel [m]."""
    return ag.cylinder(radius, far - near, axis=ag.Y, bevel=bevel).at(0.0, -0.5 * (near + far), 0.0)


def dial(
    *,
    finish: ag.Material,
    style: DialStyle = "round",
    radius: ag.Scalar = 0.016,
    depth: ag.Scalar = 0.016,
    mark: ag.Material | None = None,
    cap: ag.Material | None = None,
    name: str = "knob",
    label: str = "knob",
) -> ag.Body:
    """Make a knob with its grasp frame, its mark upward; attach it by `dial_turn`."""
    step = GAP + 0.3 * (depth - GAP)  # start of the grip of a knob with a base
    bevel = 0.0012
    solids: list[ag.Solid]
    held: ag.Scalar = GAP
    front, reach = 1.0 * depth, 0.9 * radius
    match style:
        case "round" | "capped":
            solids = [_disc(radius, GAP, depth, bevel)]
        case "fluted":
            solids = [_disc((1.0 - _FLUTE) * radius, GAP, depth, bevel)]
        case "bar":
            held = step
            bar = ag.box(0.44 * radius, depth - GAP - 0.001, 1.94 * radius, bevel=0.0014)
            solids = [bar.at(0.0, -0.5 * (depth + GAP + 0.001), 0.0), _disc(radius, GAP, step, bevel)]
        case "skirted":
            held, reach = step, 0.68 * radius
            skirt = ag.frustum(radius, 0.84 * radius, step - GAP, axis=-ag.Y, bevel=0.0008)
            solids = [
                ag.frustum(0.76 * radius, 0.7 * radius, depth - GAP - 0.001, axis=-ag.Y, bevel=bevel).at(
                    0.0, -0.5 * (depth + GAP + 0.001), 0.0
                ),
                skirt.at(0.0, -0.5 * (step + GAP), 0.0),
            ]
    hold = ag.grasp_on(solids[0], approach=ag.Y, closing=ag.X, depth=front - held - _CLEAR)
    bodies = [ag.part(solids[0], label, finish, name=name, grasp=hold)]
    bodies += [ag.part(each, label, finish) for each in solids[1:]]
    if style == "fluted":  # its ribs are visual only, so that its collider is one cylinder
        ribs = ag.extrude(_fluted().scale(radius), depth - GAP - 0.0006, axis=ag.Y, bevel=0.0006)
        bodies.append(ag.detail(ribs.at(0.0, -0.5 * (depth + GAP - 0.0006), 0.0), label, finish))
    if style == "capped":
        plate = _disc(0.86 * radius, depth - 0.001, depth + 0.0008, 0.0005)
        bodies.append(ag.detail(plate, label, cap or finish))
        front = depth + 0.0008
        reach = 0.82 * radius
    if mark is not None:
        line = details.pointer(0.42 * reach, 0.97 * reach, 0.0015 if style == "bar" else 0.0019)
        bodies.append(details.printed(line, (0.0, -front, 0.0), material=mark))
    return ag.weld(*bodies)


def dial_turn(
    name: str = "knob_turn",
    *,
    low: ag.Scalar = -2.4,
    high: ag.Scalar = 2.4,
    friction: ag.Scalar = 0.045,
    damping: ag.Scalar = 0.003,
    pivot: ag.VectorLike = (0.0, 0.0, 0.0),
    endless: bool = False,
) -> ag.Joint:
    """Make the joint of a dial; positive angles turn it clockwise, seen from the front.

    Rotary switches of appliances turn at 0.02-0.06 N m; friction represents their detents.
    """
    return ag.Revolute(
        name,
        axis=ag.Y,
        pivot=pivot,
        limits=None if endless else (low, high),
        friction=friction,
        damping=damping,
        armature=0.00002,  # inertia of the shaft and the wiper
        effort=0.6,  # two fingers at a radius of 15 mm, 20 N each
    )


def dial_print(
    radius: ag.Scalar,
    *,
    ink: ag.Material,
    style: Literal["numbers", "ticks", "band", "icons"] = "numbers",
    count: int = 6,
    icons: tuple[str, ...] = (),
    sweep: ag.Scalar = SWEEP,
    start: ag.Scalar | None = None,
    height: ag.Scalar = 0.0034,
) -> ag.Body:
    """Print the scale around a dial on the face y = 0."""
    out = radius + 0.002
    match style:
        case "numbers":
            numbers = [str(number + 1) for number in range(count)]
            scale = details.dial_scale(
                out, count, sweep=sweep, start=start, numbers=numbers, number_height=height, width=0.0005
            )
        case "ticks":
            scale = details.dial_scale(
                out, 2 * count - 1, sweep=sweep, start=start, major_every=2, major_length=0.0032, width=0.0005
            )
        case "band":
            scale = details.dial_band(out, 0.0004, 0.0034, sweep=sweep, start=start)
        case "icons":
            scale = details.dial_icons(icons, out + 1.2 * height, 2.0 * height, sweep=sweep, start=start)
    return details.printed(scale, (0.0, 0.0, 0.0), material=ink)
