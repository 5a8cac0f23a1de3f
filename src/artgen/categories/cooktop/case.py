"""The plate of a cooktop and the case below it, which fits into a worktop."""

from typing import Literal

import artgen as ag
from artgen import details
from artgen.categories.shared import cooktops
from artgen.categories.shared.appliances import cord_stub, filled
from artgen.categories.shared.cooktops import BurnerKind

Trim = Literal["none", "frame", "sides"]
"""Edge protection of a glass plate: none, a steel frame, or bars at its left and right."""

THICK: dict[BurnerKind, float] = {"gas": 0.007, "radiant": 0.0045, "coil": 0.014, "induction": 0.0045}
"""Thickness of the modeled plate; a real pressed plate is of sheet and hollow below [m]."""

# density of the modeled plate for pressed sheet of 0.8-1.0 mm [kg/m3]
_SHEET = {"gas": 1100.0, "coil": 600.0}
_GLASS = 2050.0  # density for 6 mm of tempered glass, modeled 7 mm thick [kg/m3]
# density of cases: walls of 0.8 mm sheet, heaters in wool, or coils with their electronics [kg/m3]
_CASE = {"gas": 1250.0, "radiant": 230.0, "coil": 210.0, "induction": 290.0}
_GALVANISED = ag.material("zinc").with_(name="galvanised_sheet", base_color=(0.50, 0.51, 0.52), texture="")
_SEAL = ag.material("rubber").with_(name="foam_seal", base_color=(0.05, 0.05, 0.05), density=120.0)
_CLAMP = ag.material("steel").with_(name="clamp_steel", base_color=(0.42, 0.42, 0.42))


def plate(kind: BurnerKind, place: ag.Region, finish: ag.Material, holes: ag.Solid | None) -> ag.Body:
    """Make a plate of glass or sheet with holes; sheet has a raised border."""
    of_glass = "glass" in finish.name
    density = _SHEET.get(kind)
    if of_glass:
        density = _GLASS if kind == "gas" else None
    stuff = finish if density is None else filled(finish, density, "sheet")
    glass = of_glass or kind in ("radiant", "induction")
    outline = place.plan(radius=0.009 if glass else 0.014)
    slab = ag.extrude(outline, place.z.size, bevel=0.0012 if glass else 0.0022).at(z=place.z.mid)
    body = ag.part(slab if holes is None else slab - holes, "plate", stuff)
    if glass:
        return body
    border = place.shrink(0.0015).plan(radius=0.0125) - place.shrink(0.010).plan(radius=0.008)
    raised = details.relief(border, (0, 0, place.z.high), facing=ag.Z, proud=0.0016, bevel=0.0012)
    return ag.weld(body, ag.detail(raised, "plate", finish))


def plate_of_coils(
    place: ag.Region, finish: ag.Material, coils: list[tuple[ag.Scalar, ag.Scalar, float]]
) -> ag.Body:
    """Make a plate for coils at x and y of some radius: a layer with holes for the bowls, on another."""
    outline = open_ = place.plan(radius=0.014)
    for x, y, radius in coils:
        open_ = open_ - cooktops.coil_hole(radius).at(x, y)
    upper, lower = place.stack(cooktops.BOWL, None)
    layers = [
        ag.extrude(profile, layer.z.size).at(z=layer.z.mid)
        for profile, layer in ((open_, upper), (outline, lower))
    ]
    rim = ag.extrude(outline - place.shrink(0.003).plan(radius=0.011), 0.004, bevel=0.0012)
    glass = "glass" in finish.name
    return ag.weld(
        ag.part(layers, "plate", finish if glass else filled(finish, _SHEET["coil"], "sheet")),
        ag.detail(rim.at(z=place.z.high - 0.0005), "plate", finish),
    )


def trims(trim: Trim, place: ag.Region, metal: ag.Material) -> list[ag.Body]:
    """Make the edge protection of a plate, visual only."""
    band = place.grow(bottom=0.0005, top=0.0009)
    match trim:
        case "none":
            return []
        case "frame":
            outline = band.grow(0.003).plan(radius=0.011) - band.shrink(0.0035).plan(radius=0.006)
            solids = [ag.extrude(outline, band.z.size, bevel=0.0008).at(z=band.z.mid)]
        case "sides":
            bars = band.grow(x=0.003, y=0.001).across(0.008, None, 0.008)[::2]
            solids = [bar.box(bevel=0.0012) for bar in bars]
    return [ag.detail(solids, "trim", metal)]


def case(kind: BurnerKind, place: ag.Region, lines: tuple[str, ...]) -> ag.Body:
    """Make the case from the floor to the plate, with a rating plate of some lines and its connections."""
    under, (wide, deep, _) = place.z.low, place.size
    room = place.shrink(x=0.016, y=0.012).with_(z=(0, under + 0.0003))
    x, y = room.x.high, room.y.high
    shell = room.box()
    if kind == "gas":  # hollow for the taps
        shell = shell - room.shrink(0.003).with_(z=(0.003, place.z.high)).box()
    seam = ag.extrude(place.shrink(0.003).plan(radius=0.008) - room.shrink(0.001).plan(), 0.002)
    clamp = ag.box(0.020, 0.004, 0.030, bevel=0.0008)
    clamps = [clamp.at(side * 0.32 * wide, -y - 0.0012, under / 2) for side in (-1, 1)]
    bodies = [
        ag.part(shell, "body", filled(_GALVANISED, _CASE[kind], "case")),
        ag.detail(seam.at(z=under - 0.0007), "seal", _SEAL),
        ag.detail(clamps, "clamp", _CLAMP),
        details.rating_plate(0.07, 0.022, lines, at=(x, 0.12 * deep, under / 2), facing=ag.X),
        cord_stub(height=0.55 * under).at(0.32 * wide, y, 0.55 * under),
    ]
    steel = ag.material("stainless")
    for side in (-1, 1):
        at = (side * x, -0.36 * deep, 0.70 * under)
        bodies.append(details.screw(0.0032, at, facing=side * ag.X, material=steel))
        if kind == "induction":  # the fan takes in air in front and blows it out at the back
            slots = details.vent_slots(0.7 * wide, 0.016, 44, slot=0.003)
            at, black = (0, side * y, 0.62 * under), ag.material("black_abs")
            bodies.append(details.printed(slots, at, material=black, facing=side * ag.Y, label="vent"))
    if kind == "gas":
        pipe = ag.cylinder(0.0075, 0.034, axis=ag.Y, bevel=0.001).at(y=0.015)
        nut = ag.cylinder(0.0125, 0.010, axis=ag.Y, bevel=0.0015).at(y=0.012)
        brass = ag.material("brass").with_(name="gas_brass", specular_roughness=0.4)
        bodies.append(ag.detail([pipe, nut], "gas_pipe", brass).at(-0.36 * wide, y, 0.4 * under))
    return ag.weld(*bodies)
