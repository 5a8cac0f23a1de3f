"""What fronts of filing cabinets have: label holders with their cards, and a lock. They only are seen.

Both are drawn on the face y = 0.
"""

from artgen import (
    Body,
    Material,
    Scalar,
    Y,
    box,
    coloured,
    detail,
    details,
    extrude,
    material,
    rectangle,
    ring,
    text,
)
from artgen.categories.shared.hardware.cylinders import plug

INDEXES = ("A-F", "G-K", "L-R", "S-Z", "2021", "2022", "2023", "2024")
"""What is written on the cards."""

_WIDE, _HIGH = 0.078, 0.030  # of a label holder [m]


def label_holder(*, z: Scalar, finish: Material, index: str) -> list[Body]:
    """Make a label holder and its card."""
    opening = rectangle(_WIDE - 0.010, _HIGH - 0.011).at(0.0, 0.0015)
    rim = rectangle(_WIDE, _HIGH, radius=0.003) - opening
    paper = coloured("abs", "white").with_(name="card", specular_roughness=0.85)
    return [
        detail(extrude(rim, 0.0026, axis=Y, bevel=0.0007).at(0.0, -0.0008, z), "label_holder", finish),
        detail(box(_WIDE - 0.009, 0.0008, _HIGH - 0.010).at(0.0, -0.0003, z + 0.0015), "label_holder", paper),
        details.printed(text(index, 0.010), (0.0, -0.0007, z - 0.0035), material=material("black_abs")),
    ]


def lock(*, x: Scalar, z: Scalar, finish: Material) -> list[Body]:
    """Make the cylinder of a lock, which only is seen."""
    collar = extrude(ring(0.0115, 0.0070), 0.0030, axis=Y, bevel=0.0009)
    return [
        detail(collar.at(x, -0.0011, z), "lock", finish),
        *(each.at(x, 0.0, z) for each in plug(face=0.0004, side=-1, finish=finish, radius=0.0072)),
    ]
