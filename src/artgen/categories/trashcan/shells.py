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
    """What a bin is made of.

    Attributes:
        finish: Of its wall.
        lid: Of its lid or hood.
        trim: Of rim, base and hinge.
        bright: Of rings and pins.
        plastic: Of what is hidden, and of hinges.
    """

    finish: Material
    lid: Material
    trim: Material
    bright: Material
    plastic: Material


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
    """Make the wall, floor, feet and trim of a bin: the link `body`.

    Args:
        can: Its shell.
        looks: What it is made of.
        floor: Height of the underside of its floor [m].
        dress: What goes around its wall.
        holes: What is cut out of wall and bands.
        rim: Height of the band around the rim, 0 for none [m].
        label: Semantic label of the wall.
    """
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
