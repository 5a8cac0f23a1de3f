"""A small category for the studio: a crate whose lid waits for its bolt, with a flag that follows the lid."""

from typing import Literal

from artgen import (
    Body,
    Float,
    Generator,
    Prismatic,
    Revolute,
    X,
    box,
    category,
    choice,
    cylinder,
    fixed,
    generator,
    material,
    one_of,
    part,
    uniform,
    weld,
)


@generator
def knob(*, across: Float = uniform(0.03, 0.04, "m", doc="its diameter", within=(0.02, 0.06))) -> Body:
    """A round handle."""
    return part(cylinder(across / 2, 0.03), "handle", material("steel"))


@generator
def bar(*, length: Float = uniform(0.06, 0.1, "m")) -> Body:
    """A long handle."""
    return part(box(length, 0.02, 0.03), "handle", material("steel"))


@category(labels=("crate", "lid", "handle", "bolt", "flag"))
def crate(
    *,
    width: Float = uniform(0.3, 0.4, "m", within=(0.2, 0.6)),
    swing: Float = uniform(1.0, 1.2, "rad", within=(0.5, 2.5)),
    wall: Float = fixed(0.3, "m", doc="how far the wall behind the crate is away"),
    finish: Literal["plain", "raised"] = choice("plain", "raised"),
    handle: Generator = one_of(knob, bar),
) -> Body:
    """A box with a lid."""
    floor = box(width, 0.31 + wall, 0.01).at(0, wall / 2, -0.005)
    back = box(width, 0.01, 0.5).at(0, 0.15 + wall, 0.25)
    body = part(box(width, 0.3, 0.2).at(z=0.1) | floor | back, "crate", material("oak"))
    plate = box(width, 0.29, 0.02).at(z=0.215)
    if finish == "raised":
        plate = plate | box(width / 2, 0.1, 0.01).at(z=0.229)
    lid = weld(part(plate, "lid", material("oak")), handle().at(0, -0.1, 0.24))
    flag = part(box(0.02, 0.02, 0.05), "flag", material("steel")).at(width / 2 + 0.05, 0, 0.3)
    bolt = part(box(0.02, 0.02, 0.02), "bolt", material("steel")).at(-width / 2 - 0.03, 0, 0.1)
    slide = Prismatic("bolt_slide", axis=-X, limits=(0, 0.04))
    hinge = Revolute("lid_hinge", pivot=(0, 0.145, 0.215), axis=-X, limits=(0, swing), needs=slide > 0.03)
    wave = Prismatic("flag_slide", axis=X, limits=None, follows=0.02 * hinge)
    whole = body.attach(bolt, slide).attach(lid, hinge).attach(flag, wave)
    return whole.require(width < 0.55, "no lid is that wide")
