"""Hoses at the back of appliances that take and drain water: limp things, so they are only seen.

Each starts on the plane y = 0 about the origin and leaves to +y; turn it about Z for other faces.
"""

from artgen import (
    Body,
    Material,
    Scalar,
    Solid,
    VectorLike,
    Y,
    array,
    circle,
    coloured,
    cylinder,
    detail,
    extrude,
    polyline,
    regular_polygon,
    sweep,
    weld,
)

_PITCH = 0.006  # of the ribs of a drain hose [m]
_RIBS = 3


def drain_hose(
    path: list[VectorLike],
    *,
    radius: Scalar = 0.0105,
    finish: Material | None = None,
    label: str = "hose",
) -> Body:
    """Make a corrugated hose from the origin through points."""
    grey = finish or coloured("polypropylene", "grey")
    hose = sweep(circle(radius), polyline([(0.0, -0.004, 0.0), *path], fillet=1.8 * radius))
    rib = cylinder(radius + 0.0012, 0.0035, axis=Y, bevel=0.001)
    ribs = array(rib, at=[(0.0, 0.004 + _PITCH * index, 0.0) for index in range(_RIBS)])
    collar = cylinder(1.45 * radius, 0.004, axis=Y, bevel=0.001).at(0.0, 0.001, 0.0)
    return weld(*(detail(each, label, grey) for each in (hose, collar, ribs)))


def inlet_hose(
    path: list[VectorLike],
    *,
    radius: Scalar = 0.007,
    finish: Material | None = None,
    label: str = "hose",
) -> Body:
    """Make a smooth pressure hose with the hexagon nut of its valve, from the origin through points."""
    grey = finish or coloured("abs", "light_grey")
    hose = sweep(circle(radius), polyline([(0.0, 0.006, 0.0), *path], fillet=2.0 * radius))
    nut: Solid = extrude(regular_polygon(6, 2.0 * radius), 0.014, axis=Y, bevel=0.001).at(0.0, 0.007, 0.0)
    blue = coloured("abs", "sky")
    return weld(
        detail(hose, label, grey),
        detail(nut, label, blue),
    )
