"""The part of a bin that stands on the floor: wall, floor, feet, rim, bands and beads."""

from dataclasses import dataclass
from typing import Literal

from artgen import Body, Material, Scalar, Solid, detail, material, part, weld
from artgen.categories.shared.hardware.feet import feet
from artgen.categories.trashcan.bins import Can

Dress = Literal["plain", "base_band", "beads", "ring"]
"""What goes around a wall: nothing, a band at the foot, two beads, or a bright ring under the rim."""


@dataclass(frozen=True)
class Looks:
    """What a bin is made of."""

    finish: Material  # of its wall
    lid: Material  # of its lid or hood
    trim: Material  # of rim, base and hinge
    bright: Material  # of rings and pins
    plastic: Material  # of what is hidden, and of hinges


def stand(
    can: Can,
    looks: Looks,
    *,
    floor: Scalar,
    dress: Dress,
    holes: Solid | None = None,
    rim: Scalar = 0.014,
    label: str = "body",
) -> Body:
    """Make the wall, floor, feet and trim of a bin: the link `body`."""
    bodies = [
        *can.shell(label, looks.finish, name="body", holes=holes),
        part(can.floor(floor, floor + 0.003), "base", looks.trim),
        feet(can.feet(0.024), height=floor, radius=0.008, finish=material("rubber")),
    ]
    bodies += [detail(each, "rim", looks.trim) for each in _rim(can, rim)]
    if dress == "base_band":
        band = can.band(can.foot - 0.001, can.foot + 0.020, outer=-0.0012, inner=0.0008)
        bodies.append(detail(band if holes is None else band - holes, "base", looks.trim))
    elif dress == "beads":
        for share in (0.30, 0.36):
            z = can.foot + share * (can.top - can.foot)
            bodies.append(detail(can.band(z, z + 0.005, outer=-0.0014, inner=0.0010), "body", looks.finish))
    elif dress == "ring":
        z = can.top - 0.050
        ring = can.band(z, z + 0.006, outer=-0.0018, inner=0.0010)
        bodies.append(detail(ring if holes is None else ring - holes, "rim", looks.bright))
    return weld(*bodies)


def _rim(can: Can, high: Scalar) -> list[Solid]:
    if isinstance(high, int | float) and high <= 0.0:
        return []
    return [can.band(can.top - high, can.top + 0.0006, outer=-0.0012, inner=can.wall + 0.0008)]


def rolled_rim(can: Can, finish: Material) -> Body:
    """Make the bead around the rim of an open bin, only seen."""
    return detail(
        can.band(can.top - 0.010, can.top + 0.0015, outer=-0.0028, inner=can.wall + 0.001), "rim", finish
    )
