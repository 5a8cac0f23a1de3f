"""Visible mains cords: strain relief, cord and plug, without colliders."""

import math
from collections.abc import Sequence

import artgen as ag

CORD = 0.0032
"""Radius of the cord of a small appliance, H03VV-F 3 x 0.75 mm2 [m]."""

_RELIEF = 0.024  # length of the strain relief [m]
_RIBS = 4  # number of ribs around the strain relief


def strain_relief(*, radius: ag.Scalar = CORD, length: ag.Scalar = _RELIEF) -> list[ag.Solid]:
    """Make the ribbed sleeve against kinks of a cord: from y = 0 back, about the y axis."""
    pitch, edge = length / _RIBS, 0.0004
    core = radius + 0.0007
    line: list[tuple[ag.Scalar, ag.Scalar]] = [(0.0, 0.0)]
    for rib in range(_RIBS):
        out, low, high = radius + 0.0030 - 0.00055 * rib, rib * pitch, (rib + 0.62) * pitch
        line += [(out - edge, low), (out, low + edge), (out, high - edge), (out - edge, high), (core, high)]
        line.append((core, (rib + 1.0) * pitch))
    line.append((0.0, 1.0 * length))
    return [ag.revolve(ag.polygon(line)).rotate(ag.X, -0.5 * math.pi)]


def _seen(solids: Sequence[ag.Solid], label: str, finish: ag.Material | None) -> ag.Body:
    """Return overlapping, visual-only solids on one body; by default of black rubber."""
    return ag.weld(*(ag.detail(each, label, finish or ag.material("rubber")) for each in solids))


def cord_stub(
    *,
    height: ag.Scalar,
    finish: ag.Material | None = None,
    radius: ag.Scalar = CORD,
    reach: ag.Scalar = 0.045,
    label: str = "cord",
) -> ag.Body:
    """Make a strain relief on the plane y = 0 and a cord from it down to the floor at the back (+y)."""
    fall = -(height - radius)
    path = ag.polyline(_down(reach, fall), fillet=_bend(fall))
    return _seen([*strain_relief(radius=radius), ag.sweep(ag.circle(radius), path)], label, finish)


def mains_cord(
    *,
    height: ag.Scalar,
    length: ag.Scalar = 0.16,
    side: int = 1,
    finish: ag.Material | None = None,
    radius: ag.Scalar = CORD,
    reach: ag.Scalar = 0.045,
    label: str = "cord",
) -> ag.Body:
    """Make a cord with its plug: from its outlet on y = 0 down to the floor and along it to one side."""
    fall = -(height - radius)
    run = side * 1.0 * (length - 0.052)
    path = ag.polyline([*_down(reach, fall), (run, reach, fall)], fillet=_bend(fall))
    end = ag.vector(run, reach, fall)
    plug = [(each if side > 0 else each.mirror(ag.X)).at(end) for each in _plug(radius)]
    return _seen([*strain_relief(radius=radius), ag.sweep(ag.circle(radius), path), *plug], label, finish)


def _down(reach: ag.Scalar, fall: ag.Scalar) -> list[ag.VectorLike]:
    """Return the corners of a cord from inside its sleeve to the floor."""
    return [(0.0, 0.4 * _RELIEF, 0.0), (0.0, reach, 0.0), (0.0, reach, fall)]


def _bend(fall: ag.Scalar) -> ag.Float:
    """Return the radius of the bends of a cord over a height [m]."""
    return ag.min_(0.016, -0.45 * fall)


def _plug(radius: ag.Scalar) -> list[ag.Solid]:
    """Make a flat molded plug with two pins, along x from the end of its cord at the origin."""
    body = ag.extrude(ag.rectangle(0.0260, 0.0130, radius=0.0048), 0.034, axis=ag.X, bevel=0.0018)
    sleeve = ag.cylinder(radius + 0.0012, 0.014, axis=ag.X, bevel=0.0008)
    low = 0.0065 - radius  # the plug lies on the floor too
    pin = ag.cylinder(0.0020, 0.019, axis=ag.X, bevel=0.0009)
    base = ag.box(0.004, 0.0190, 0.0090, bevel=0.0015)
    return [
        body.at(0.026, 0.0, low),
        sleeve.at(0.006, 0.0, 0.0012),
        base.at(0.0440, 0.0, low),
        *(pin.at(0.0545, y * 0.0095, low) for y in (-1, 1)),
    ]
