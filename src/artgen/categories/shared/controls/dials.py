"""Dials: knobs that fingers turn on a panel, their joint, and the print around them.

A dial is drawn about the origin on the plane y = 0, which is the face of its panel, and stands out to -y. It
keeps a gap of 0.6 mm to the panel, in which its shaft is not seen, so that no hole has to be cut.
"""

import math
from typing import Literal

from artgen import (
    Body,
    Joint,
    Material,
    Profile,
    Revolute,
    Scalar,
    Solid,
    VectorLike,
    X,
    Y,
    box,
    cylinder,
    detail,
    details,
    extrude,
    frustum,
    grasp_on,
    part,
    polygon,
    weld,
)
from artgen.nodes.details.dials import SWEEP

DialStyle = Literal["round", "fluted", "bar", "skirted", "capped"]
"""A plain cylinder, one with flutes, a bar on a disc, a knob on a skirt, or one with a cap of metal."""

GAP = 0.0006
"""Between a dial and its panel [m]."""

_FLUTES = 18
_FLUTE = 0.055  # depth of a flute, as a share of the radius
_CLEAR = 0.0012  # of the tips of fingers to what is behind them [m]


def _fluted() -> Profile:
    """Make the outline of a fluted knob of radius 1."""
    steps = 4 * _FLUTES
    angles = [math.tau * step / steps for step in range(steps)]
    radii = [1.0 - _FLUTE * (0.5 - 0.5 * math.cos(_FLUTES * angle)) for angle in angles]
    return polygon([(r * math.cos(a), r * math.sin(a)) for r, a in zip(radii, angles, strict=True)])


def _disc(radius: Scalar, near: Scalar, far: Scalar, bevel: Scalar) -> Solid:
    """Make a disc that stands between two distances from the panel [m]."""
    return cylinder(radius, far - near, axis=Y, bevel=bevel).at(0.0, -0.5 * (near + far), 0.0)


def dial(
    *,
    finish: Material,
    style: DialStyle = "round",
    radius: Scalar = 0.016,
    depth: Scalar = 0.016,
    mark: Material | None = None,
    cap: Material | None = None,
    name: str = "knob",
    label: str = "knob",
) -> Body:
    """Make a knob with its grasp frame, its mark upward; attach it by `dial_turn`."""
    step = GAP + 0.3 * (depth - GAP)  # where the grip of a knob with a base begins
    bevel = 0.0012
    solids: list[Solid]
    held: Scalar = GAP
    front, reach = 1.0 * depth, 0.9 * radius
    match style:
        case "round" | "capped":
            solids = [_disc(radius, GAP, depth, bevel)]
        case "fluted":
            solids = [_disc((1.0 - _FLUTE) * radius, GAP, depth, bevel)]
        case "bar":
            held = step
            bar = box(0.44 * radius, depth - GAP - 0.001, 1.94 * radius, bevel=0.0014)
            solids = [
                bar.at(0.0, -0.5 * (depth + GAP + 0.001), 0.0),
                _disc(radius, GAP, step, bevel),
            ]
        case "skirted":
            held, reach = step, 0.68 * radius
            skirt = frustum(radius, 0.84 * radius, step - GAP, axis=-Y, bevel=0.0008)
            solids = [
                frustum(0.76 * radius, 0.7 * radius, depth - GAP - 0.001, axis=-Y, bevel=bevel).at(
                    0.0, -0.5 * (depth + GAP + 0.001), 0.0
                ),
                skirt.at(0.0, -0.5 * (step + GAP), 0.0),
            ]
    hold = grasp_on(solids[0], approach=Y, closing=X, depth=front - held - _CLEAR)
    bodies = [part(solids[0], label, finish, name=name, grasp=hold)]
    bodies += [part(each, label, finish) for each in solids[1:]]
    if style == "fluted":  # its ribs are only seen, so that its collider is one cylinder
        ribs = extrude(_fluted().scale(radius), depth - GAP - 0.0006, axis=Y, bevel=0.0006)
        bodies.append(detail(ribs.at(0.0, -0.5 * (depth + GAP - 0.0006), 0.0), label, finish))
    if style == "capped":
        plate = _disc(0.86 * radius, depth - 0.001, depth + 0.0008, 0.0005)
        bodies.append(detail(plate, label, cap or finish))
        front = depth + 0.0008
        reach = 0.82 * radius
    if mark is not None:
        line = details.pointer(0.42 * reach, 0.97 * reach, 0.0015 if style == "bar" else 0.0019)
        bodies.append(details.printed(line, (0.0, -front, 0.0), material=mark))
    return weld(*bodies)


def dial_turn(
    name: str = "knob_turn",
    *,
    low: Scalar = -2.4,
    high: Scalar = 2.4,
    friction: Scalar = 0.045,
    damping: Scalar = 0.003,
    pivot: VectorLike = (0.0, 0.0, 0.0),
    endless: bool = False,
) -> Joint:
    """Make the joint of a dial; positive angles turn it clockwise, seen from the front.

    Rotary switches of appliances turn at 0.02-0.06 N m; their detents are felt as friction.
    """
    return Revolute(
        name,
        axis=Y,
        pivot=pivot,
        limits=None if endless else (low, high),
        friction=friction,
        damping=damping,
        armature=0.00002,  # the shaft and the wiper
        effort=0.6,  # two fingers at a radius of 15 mm, 20 N each
    )


def dial_print(
    radius: Scalar,
    *,
    ink: Material,
    style: Literal["numbers", "ticks", "band", "icons"] = "numbers",
    count: int = 6,
    icons: tuple[str, ...] = (),
    sweep: Scalar = SWEEP,
    start: Scalar | None = None,
    height: Scalar = 0.0034,
) -> Body:
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
                out,
                2 * count - 1,
                sweep=sweep,
                start=start,
                major_every=2,
                major_length=0.0032,
                width=0.0005,
            )
        case "band":
            scale = details.dial_band(out, 0.0004, 0.0034, sweep=sweep, start=start)
        case "icons":
            scale = details.dial_icons(icons, out + 1.2 * height, 2.0 * height, sweep=sweep, start=start)
    return details.printed(scale, (0.0, 0.0, 0.0), material=ink)
