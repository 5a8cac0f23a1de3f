"""What an entrance door carries on its outer face (+y): letter plate, house number, viewer, kick plate.

All of it is fixed; the letter plate is thick enough to be a part, the rest is only seen.
"""

from artgen import (
    Body,
    Scalar,
    Y,
    box,
    cylinder,
    detail,
    details,
    dome,
    extrude,
    material,
    part,
    rectangle,
    text,
)
from artgen.categories.shared.finish import casting, recess
from artgen.categories.shared.furniture.door_slab import Fittings
from artgen.categories.shared.hardware.fixings import screws

LETTER_PLATE = 0.30
"""Width of a letter plate [m]."""


def letter_plate(fittings: Fittings, face: Scalar, height: Scalar) -> list[Body]:
    """Make a letter plate with its flap on the outer face, and the cover of its slot inside."""
    finish, wide, tall = fittings.finish, LETTER_PLATE, 0.076
    plate = extrude(rectangle(wide, tall, radius=0.006), 0.0075, axis=Y, bevel=0.0018)
    flap = extrude(rectangle(wide - 0.062, 0.048, radius=0.003), 0.0036, axis=Y, bevel=0.0012)
    gap = extrude(rectangle(wide - 0.059, 0.051, radius=0.0045), 0.0004, axis=Y)
    pivot = cylinder(0.0028, wide - 0.064, axis=(1.0, 0.0, 0.0), bevel=0.0006)
    out = face + 0.0070
    inside = extrude(rectangle(wide - 0.03, 0.062, radius=0.004), 0.0030, axis=Y, bevel=0.0009)
    lid = extrude(rectangle(wide - 0.075, 0.040, radius=0.003), 0.0026, axis=Y, bevel=0.0008)
    places = [(x * (wide / 2.0 - 0.0155), out, height) for x in (-1, 1)]
    return [
        part(plate.at(0.0, face + 0.00325, height), "plate", casting(finish, 0.5)),
        detail(gap.at(0.0, out, height), "plate", recess(finish)),
        detail(flap.at(0.0, out + 0.0010, height), "plate", finish),
        detail(pivot.at(0.0, out + 0.0004, height + 0.0215), "plate", finish),
        *screws(places, facing="+y", radius=0.0040, finish=finish, drive="slot", head="pan"),
        detail(inside.at(0.0, -(face + 0.0010), height), "plate", finish),
        detail(lid.at(0.0, -(face + 0.0030), height), "plate", finish),
    ]


def house_number(fittings: Fittings, face: Scalar, height: Scalar, tall: Scalar) -> Body:
    """Make the number of the house, cast figures on the outer face."""
    return details.raised(
        text(fittings.number, tall),
        (0.0, face, height),
        facing=Y,
        proud=0.004,
        bevel=0.0008,
        label="plate",
        material=fittings.finish,
    )


def viewer(fittings: Fittings, face: Scalar, height: Scalar) -> list[Body]:
    """Make a door viewer: a lens in a sleeve that shows on both faces."""
    bodies: list[Body] = []
    lens = fittings.finish.with_(
        name=f"{fittings.finish.name}_lens",
        base_color=(0.02, 0.025, 0.03),
        base_metalness=0.0,
        specular_roughness=0.05,
        texture="",
        variant=0,
        tile=None,
    )
    for side, outer in ((1, 0.0085), (-1, 0.0100)):
        sleeve = cylinder(outer, 0.0040, axis=Y, bevel=0.0009)
        glass = dome(0.0048, height=0.0016, axis=(0.0, side, 0.0))
        bodies.append(detail(sleeve.at(0.0, side * (face + 0.0012), height), "plate", fittings.finish))
        bodies.append(detail(glass.at(0.0, side * (face + 0.0031), height), "plate", lens))
    return bodies


def kick_plate(fittings: Fittings, face: Scalar, width: Scalar, bottom: Scalar) -> list[Body]:
    """Make the sheet that protects the foot of the outer face."""
    wide, tall, middle = width - 0.064, 0.150, bottom + 0.092
    sheet = extrude(rectangle(wide, tall, radius=0.003), 0.0014, axis=Y, bevel=0.0005)
    places = [
        (x * (wide / 2.0 - 0.010), face + 0.0010, middle + z * (tall / 2.0 - 0.010))
        for x in (-1.0, -1.0 / 3.0, 1.0 / 3.0, 1.0)
        for z in (-1, 1)
    ]
    return [
        detail(sheet.at(0.0, face + 0.0003, middle), "plate", fittings.finish),
        *screws(places, facing="+y", radius=0.0036, finish=fittings.finish),
    ]


def sweep_seal(face: Scalar, width: Scalar, bottom: Scalar) -> list[Body]:
    """Make the brush in its rail that closes the gap to the floor, on the inner face (-y)."""
    finish, brush = (
        material("aluminium"),
        material("rubber").with_(name="bristles", base_color=(0.02, 0.02, 0.02)),
    )
    wide = width - 0.06
    rail = extrude(rectangle(wide, 0.032, radius=0.0015), 0.0050, axis=Y, bevel=0.0012)
    bead = box(wide, 0.0016, 0.0030, bevel=0.0006)
    hair = box(wide - 0.002, 0.0028, 0.014)
    places = [(x * (wide / 2.0 - 0.05), -(face + 0.0045), bottom + 0.022) for x in (-1.0, -0.34, 0.34, 1.0)]
    return [
        detail(rail.at(0.0, -(face + 0.0020), bottom + 0.0195), "seal", finish),
        detail(bead.at(0.0, -(face + 0.0045), bottom + 0.0085), "seal", finish),
        detail(hair.at(0.0, -(face + 0.0020), bottom - 0.0010), "seal", brush),
        *screws(places, facing="-y", radius=0.0030, finish=finish),
    ]


def fitted(
    fittings: Fittings,
    *,
    face: Scalar,
    width: Scalar,
    bottom: Scalar,
    letters: Scalar | None,
    number: Scalar | None,
    looks_out: Scalar | None,
) -> list[Body]:
    """Make everything that a leaf carries besides its lock."""
    bodies: list[Body] = []
    if fittings.letters and letters is not None:
        bodies += letter_plate(fittings, face, letters)
    if fittings.number and number is not None:
        bodies.append(house_number(fittings, face, number, 0.062))
    if fittings.viewer and looks_out is not None:
        bodies += viewer(fittings, face, looks_out)
    if fittings.kick:
        bodies += kick_plate(fittings, face, width, bottom)
    if fittings.sweep:
        bodies += sweep_seal(face, width, bottom)
    return bodies
