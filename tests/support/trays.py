"""A tray with a lid: hollow, of two materials, with a foot of its own and a detail that has no collider."""

import artgen
from artgen import Body, Prismatic, Revolute, X, box, detail, material, part, weld

STEEL, RUBBER = material("steel"), material("rubber")


@artgen.generator
def tray() -> Body:
    """A tray with a foot and a screw under it, a lid on it, and a button."""
    niche = box(0.18, 0.08, 0.05).at(0, 0, 0.035)
    base = part(box(0.2, 0.1, 0.05).at(0, 0, 0.025) - niche, "tray", STEEL)
    foot = part(box(0.02, 0.02, 0.01).at(0, 0, -0.005), "foot", RUBBER)
    screw = detail(box(0.01, 0.01, 0.004).at(0.05, 0, -0.002), "screw", STEEL)
    lid = part(box(0.2, 0.1, 0.004).at(0, 0, 0.053), "lid", STEEL)
    button = part(box(0.01, 0.01, 0.01).at(0.106, 0, 0.03), "button", RUBBER)
    hinge = Revolute("hinge", pivot=(0, 0.05, 0.053), axis=-X, limits=(0, 1.5), friction=0.2)
    push = Prismatic("push", axis=X, limits=(0, 0.01), friction=5.0)
    return weld(base, foot, screw).attach(lid, hinge).attach(button, push)


@artgen.generator
def comb(*, teeth: int = 70) -> Body:
    """Blocks in a row that do not touch, as one solid."""
    row = box(0.002, 0.01, 0.01)
    for number in range(1, teeth):
        row = row | box(0.002, 0.01, 0.01).at(0.004 * number)
    return part(row, "comb", STEEL)
