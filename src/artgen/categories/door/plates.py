"""Plates where hands push, with their signs, and the strip that two leaves meet at."""

import artgen as ag
from artgen import details
from artgen.categories.shared.furniture.door_slab import Blank
from artgen.categories.shared.hardware.fixings import Way, screws

ASTRAGAL_GAP = 0.002
"""Between the active leaf and the strip behind it [m]."""


@ag.generator
def finger_plate(
    *,
    thickness: ag.Float,
    finish: ag.Material,
    height: ag.Float = ag.uniform(0.28, 0.38, "m"),
) -> ag.Body:
    """Make the plates on both faces of a leaf without a handle, where hands push it; weld them to it.

    They say which face to push, and which to pull (the front, to which the leaf opens).
    """
    plate = ag.extrude(ag.rectangle(0.075, height, radius=0.004), 0.0016, axis=ag.Y, bevel=0.0006)
    face = thickness / 2.0 + 0.0012
    bodies: list[ag.Body] = []
    for side, word in ((-1, "PULL"), (1, "PUSH")):
        bodies.append(ag.part(plate.at(0.0, side * (face - 0.0008), 0.0), "plate", finish))
        places = [(x * 0.030, side * face, z * (height / 2.0 - 0.008)) for x in (-1, 1) for z in (-1, 1)]
        facing: Way = "-y" if side < 0 else "+y"
        bodies += screws(places, facing=facing, radius=0.0034, finish=finish, drive="slot")
        bodies.append(
            details.engraved(
                ag.text(word, 0.0125),
                (0.0, side * face, height / 2.0 - 0.045),
                facing=(0.0, side, 0.0),
                label="plate",
                material=finish,
            )
        )
    return ag.weld(*bodies)


def astragal(blank: Blank, gap: ag.Scalar) -> ag.Body:
    """Make the strip on the back of the inactive leaf that the active one closes against."""
    wide, deep = 0.040, 0.012
    strip = ag.box(wide, deep - ASTRAGAL_GAP, blank.upright - 0.06, bevel=0.002)
    foot = ag.box(wide / 2.0 - gap / 2.0 - 0.002, ASTRAGAL_GAP + 0.002, blank.upright - 0.07)
    back = blank.thickness / 2.0
    edge = blank.width / 2.0
    strip = strip.align((edge + gap / 2.0, back + ASTRAGAL_GAP, blank.waist), y=-1.0)
    foot = foot.align((edge, back - 0.001, blank.waist), x=1.0, y=-1.0)
    return ag.weld(ag.part(strip, "door", blank.finish), ag.part(foot, "door", blank.finish))
